"""Images: their contents, their faults, and that they build to the same bytes, from any assembler."""

from __future__ import annotations

import copy
import pickle
from typing import Any

import pytest
from construct import Bytes, Int8ul, Struct
from support.programs import IMAGE, SHORTEST, image_of

import ev3proto
from ev3proto import program as programs
from ev3proto.program import HEADER, CodeObject, ObjectKind, Program

pytestmark = pytest.mark.portable


def test_the_header_of_a_program() -> None:
    program = programs.parse(IMAGE)
    assert (program.version, program.global_size, len(program.objects)) == (0x6D, 8, 2)
    assert program.fault is None


def test_its_objects() -> None:
    main, say = programs.parse(IMAGE).objects
    assert (main.number, main.kind, main.owner, main.triggers, main.local_size) == (1, ObjectKind.THREAD, 0, 0, 10)
    assert (say.number, say.kind, say.owner, say.triggers, say.local_size) == (2, ObjectKind.SUBCALL, 0, 1, 16)
    assert (main.offset, say.offset) == (0x28, 0x51)
    assert [str(parameter.type) for parameter in say.parameters] == ["string", "DATAF"]
    assert [str(parameter.direction) for parameter in say.parameters] == ["in", "out"]
    assert [parameter.size for parameter in say.parameters] == [8, None]
    assert say.places == ((0, 8), (8, 4))


def test_its_operations_with_their_offsets_in_theimage_of() -> None:
    main, say = programs.parse(IMAGE).objects
    assert [(operation.offset, operation.full_name) for operation in main.operations] == [
        (0x28, "MOVE8_8"),
        (0x2B, "UI_WRITE.LED"),
        (0x2E, "TIMER_WAIT"),
        (0x33, "TIMER_READY"),
        (0x35, "ADD8"),
        (0x39, "JR_LT8"),
        (0x3F, "CALL"),
        (0x4A, "STRINGS.DUPLICATE"),
        (0x50, "OBJECT_END"),
    ]
    assert [operation.full_name for operation in say.operations] == [
        *("MOVE16_16", "MOVEF_F", "UI_DRAW.TEXT", "RETURN", "OBJECT_END")
    ]


def test_a_call_has_the_types_that_the_subcall_declares() -> None:
    call = programs.parse(IMAGE).objects[0].operations[6]
    assert [(argument.value, str(argument.parameter.direction)) for argument in call.arguments] == [
        *((2, "in"), (2, "in"), ("done'", "in"), (4, "out"))
    ]


@pytest.mark.parametrize("image", [IMAGE, SHORTEST])
def test_it_builds_back(image: bytes) -> None:
    program = programs.parse(image)
    assert program.build() == image
    assert programs.build(program) == image


def test_a_float_that_a_call_hands_over_is_a_float() -> None:
    image = image_of(
        (0, 0, "09 02 01 83 00 00 C0 3F 0A"),  # CALL(2, 1.5F)
        (0, 1, "01 83 08 0A"),
    )
    call = programs.parse(image).objects[0].operations[0]
    assert call.arguments[2].value == 1.5
    assert call.arguments[2].encoding == "LC4"


def test_a_float_that_fills_an_array_is_a_float() -> None:
    # ARRAY(CREATEF, 4, GV0); ARRAY(FILL, GV0, 1.5F), and the same with 32 bits
    floats = image_of((0, 0, "C1 04 04 60 C1 06 60 83 00 00 C0 3F 0A"), global_size=2)
    numbers = image_of((0, 0, "C1 03 04 60 C1 06 60 83 00 00 C0 3F 0A"), global_size=2)
    assert programs.parse(floats).objects[0].operations[1].arguments[1].value == 1.5
    assert programs.parse(numbers).objects[0].operations[1].arguments[1].value == 0x3FC00000


def test_objects_may_share_their_code() -> None:
    image = image_of((0, 0, "01 0A"), (0, 1, "00 08 0A"), (0, 1, None))
    program = programs.parse(image)
    assert [part.shares for part in program.objects] == [None, None, 2]
    assert program.objects[2].operations == program.objects[1].operations
    assert program.build() == image


def test_programs_can_be_copied_and_pickled() -> None:
    program = programs.parse(IMAGE)
    assert copy.deepcopy(program) == program
    assert pickle.loads(pickle.dumps(program)) == program


def test_a_program_made_by_hand() -> None:
    program = Program(
        global_size=1,
        objects=(
            CodeObject(operations=(ev3proto.operation("MOVE8_8", 1, ev3proto.GV(0)), ev3proto.operation("OBJECT_END"))),
        ),
    )
    assert program.build() == bytes.fromhex(
        "4C45474F 20000000 6D00 0100 01000000 1C000000 0000 0000 00000000 300160 0A"
    )


def test_headers_that_all_say_offset_0() -> None:
    image = bytes.fromhex(
        "4C45474F 38000000 6D00 0200 00000000  00000000 0000 0000 01000000  00000000 0000 0100 01000000"
        "09020105 0A  0180 3040 40 08 0A"
    )
    image = image[:4] + len(image).to_bytes(4, "little") + image[8:]
    program = programs.parse(image)
    assert [[step.name for step in part.operations] for part in program.objects] == [
        *(["CALL", "OBJECT_END"], ["MOVE8_8", "RETURN", "OBJECT_END"])
    ]
    assert [part.offset for part in program.objects] == [40, 45]
    assert program.defects.headers == (0, 0)
    assert program.build() == image
    assert programs.assemble(programs.source_of(program)).image == image
    assert programs.check_program(image).accepted


@pytest.mark.parametrize(
    ("damage", "offset", "words"),
    [
        (lambda image: b"", 0, "starts with LEGO"),
        (lambda image: b"LEXO" + image[4:], 0, "starts with LEGO"),
        (lambda image: image[:11], 11, "header of 16 bytes"),
        (lambda image: image[:-1], 4, "the header says 101 bytes; the image has 100"),
        (
            lambda image: image[:4] + b"\x1e" + image[5:30],
            10,
            "the table of objects is cut off: 2 should be in it, 1 are",
        ),
        (lambda image: image[:16] + b"\xff" + image[17:], 16, "object 1 should be at offset 255, after the end"),
        (lambda image: image[:16] + b"\x01" + image[17:], 16, "object 1 should be at offset 1, in the header"),
        (lambda image: image[:0x2B] + b"\xdf" + image[0x2C:], 0x2B, "unknown opcode 0xDF"),
        (lambda image: image[:0x51] + b"\xff" + image[0x52:], 0x51, "it should declare 255 parameters"),
    ],
)
def test_damage_is_reported_with_its_offset(damage: object, offset: int, words: str) -> None:
    image = damage(IMAGE)  # type: ignore[operator]
    with pytest.raises(ev3proto.DecodeError, match=words) as caught:
        programs.parse(image)
    assert caught.value.offset == offset
    if len(image) >= 16 and image.startswith(b"LEGO"):
        damaged = programs.parse(image, strict=False)
        assert words in " ".join(fault.reason for fault in damaged.faults)
        with pytest.raises(ev3proto.BuildError, match="read in part only, so it cannot be made again: fault at"):
            damaged.build()


def test_damaged_code_is_read_as_far_as_it_goes() -> None:
    image = IMAGE[:0x33] + b"\xdf" + IMAGE[0x34:]
    main, say = programs.parse(image, strict=False).objects
    assert [operation.name for operation in main.operations] == ["MOVE8_8", "UI_WRITE", "TIMER_WAIT"]
    assert main.rest == image[0x33:0x51]
    assert say.fault is None


def test_bytes_after_the_end_of_an_object_are_not_code() -> None:
    image = IMAGE[:4] + (103).to_bytes(4, "little") + IMAGE[8:] + b"\xff\xff"
    say = programs.parse(image).objects[1]
    assert say.rest == b"\xff\xff"
    assert say.operations[-1].name == "OBJECT_END"


def test_bytes_after_an_end_that_a_jump_leads_to_are_not_code() -> None:
    main = programs.parse(image_of((0, 0, "40 00 0A 01 0A"))).objects[0]
    assert [operation.name for operation in main.operations] == ["JR", "OBJECT_END"]
    assert main.rest == b"\x01\x0a"


def test_a_hostile_table_takes_no_longer_than_its_size() -> None:
    count = 60_000
    code = b"\x01" * 100_000 + b"\x0a"
    start = 16 + 12 * count
    table = b"".join(start.to_bytes(4, "little") + bytes(8) for _ in range(count))
    head = b"LEGO" + (start + len(code)).to_bytes(4, "little") + b"\x6d\x00" + count.to_bytes(2, "little") + bytes(4)
    image = head + table + code
    program = programs.parse(image)
    assert len(program.objects) == count
    assert program.build() == image


@pytest.mark.parametrize("schema", [Struct("header" / HEADER, "code" / Bytes(61)), programs.IMAGE])
def test_an_image_is_part_of_a_users_own_structure(schema: Any) -> None:
    wrapped = Struct("kind" / Int8ul, "it" / schema, "behind" / Int8ul)
    data = b"\x01" + IMAGE + b"\x02"
    assert wrapped.build(wrapped.parse(data)) == data
