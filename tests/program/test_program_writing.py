"""Images to sources and back: the source of an image without faults assembles to the same bytes."""

from __future__ import annotations

import random
from contextlib import suppress

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.programs import IMAGE, SHORTEST, image_of

from ev3proto import BuildError
from ev3proto import program as programs
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.program import assemble, source_of
from ev3proto.program.sources import SourceDialect
from ev3proto.text.assembly import AssemblyError


def test_the_source_of_the_example_is_written_plainly() -> None:
    source = source_of(programs.parse(IMAGE))
    assert [line.strip() for line in source.split("vmthread")[1].splitlines()] == [
        "thread1",
        "{",
        "DATA32 l0",
        "DATAS l4 6",
        "MOVE8_8(0, g0)",
        "to1:",
        "UI_WRITE(LED, LED_RED)",
        "TIMER_WAIT(500, l0)",
        "TIMER_READY(l0)",
        "ADD8(g0, 1, g0)",
        "JR_LT8(g0, 2, to1)",
        r"CALL(sub2, 'done\q', g4)",
        "STRINGS(DUPLICATE, 'x', l4)",
        "}",
        "",
        "subcall sub2",
        "{",
        "IN_S p0 8",
        "OUT_F p1",
        "ARRAY8 l12 2",
        "DATA16 l14",
        "MOVE16_16(-128, l14)",
        "MOVEF_F(0.0F, p1)",
        "UI_DRAW(TEXT, 1, 4, l14, p0)",
        "}",
    ]


BASIC_TEXT = image_of((0, 0, "7D 05 80 27 0D 0A 00 60 40 83 01 00 00 00 01 0A"), global_size=8)
"""By the rules of EV3 Basic, which has no escape for an apostrophe."""

SIGNS = image_of((0, 0, "7D 05 80 5F 78 00 60 0A"), global_size=8)
"""With a text that LEGO's assembler takes for the number of a letter, unless it is in double quotes."""


@pytest.mark.parametrize("dialect", [None, *SourceDialect])
def test_in_every_dialect_it_comes_back_or_is_refused(dialect: str | None) -> None:
    examples = [image for code in PROGRAM_CODES.values() for image in (code.example, code.counterexample)]
    refusals = [AssemblyError] if dialect in (SourceDialect.LEGO, SourceDialect.BASIC) else []
    for image in [IMAGE, SHORTEST, SIGNS, BASIC_TEXT[:8] + b"\x68" + BASIC_TEXT[9:], *examples]:
        program = programs.parse(image, strict=False)
        if program.fault is not None:
            continue
        source = source_of(program)
        with suppress(*refusals):
            assert assemble(source, dialect=dialect).image == image, source


@pytest.mark.parametrize(
    ("code", "statement"),
    [
        ("30 81 05 60", "MOVE8_8(LC1(5), g0)"),
        ("30 83 05 00 00 00 60", "MOVE8_8(LC4(5), g0)"),
        ("30 20 60", "MOVE8_8(LC0(-32), g0)"),
        ("30 05 E2 00 00", "MOVE8_8(5, GV2(0))"),
        ("30 05 F1 00", "MOVE8_8(5, @g0)"),
        ("30 05 E9 00", "MOVE8_8(5, ADR(GV1(0)))"),
        ("30 05 7F", "MOVE8_8(5, GV0(31))"),
        ("3E 83 00 00 C0 3F 60", "MOVEF_32(1.5F, g0)"),
        ("3E 83 00 00 00 00 60", "MOVEF_32(LCF(0.0F), g0)"),
        ("3E 83 00 00 C0 7F 60", "MOVEF_32(DATAF_NAN, g0)"),
        ("3E 83 00 00 80 7F 60", "MOVEF_32(!0x7F800000, g0)"),
        ("3E 00 60", "MOVEF_32(0.0F, g0)"),
        ("3E 05 60", "MOVEF_32(!5, g0)"),
        ("3E 83 17 B7 D1 38 60", "MOVEF_32(0.0001F, g0)"),
        ("7D 05 84 78 00 60", "STRINGS(DUPLICATE, LCS('x'), g0)"),
        ("7D 81 05 80 78 00 60", "STRINGS(LC1(DUPLICATE), 'x', g0)"),
        ("7D 05 80 E4 5C 00 60", r'STRINGS(DUPLICATE, "ä\\", g0)'),
        ("40 82 02 00 40 00", "JR(LC0(to1))"),
        ("40 A0 00", "JR(LAB1(to1))"),
        ("40 81 64", "JR(100)"),
        ("40 82 05 00", "JR(LC2(5))"),
        ("09 02 00", "CALL(2, 0)"),
    ],
)
def test_unusual_encodings_are_named(code: str, statement: str) -> None:
    image = image_of((0, 0, f"{code} 0A"), global_size=8)
    source = source_of(programs.parse(image, strict=False))
    assert statement in source
    assert assemble(source, dialect="strict").image == image


@pytest.mark.parametrize(
    "objects",
    [
        [(0, 0, "0A"), (0, 1, "00 08 0A")],
        [(0, 1, "00 08 08 0A")],
        [(0, 1, "00 08 08 08 0A")],
        [(0, 1, "00 01 0A")],
        [(0, 1, "00 40 82 01 00 08 0A")],
        [(0, 1, "01 05 08 0A")],
        [(0, 1, "01 84 00 08 0A")],
        [(0, 0, "01")],
        [(0, 0, "01 0A FF FF")],
        [(0, 0, "01 0A"), (1, 1, "0A"), (7, 3, "0A"), (0, 5, "0A")],
        [(0, 0, "09 02 00 0A"), (0, 1, "00 08 0A"), (0, 1, None)],
        [(0, 0, "09 03 00 0A"), (0, 1, "00 08 0A"), (0, 1, "00 08 0A")],
        [],
    ],
)
def test_objects_of_every_kind_come_back(objects: list[tuple[int, int, str | None]]) -> None:
    for locals_of_all in (0, 3, 70_000):
        image = image_of(*objects, global_size=5, local_size=locals_of_all)
        source = source_of(programs.parse(image, strict=False))
        assert assemble(source, dialect="strict").image == image


@settings(max_examples=300)
@given(st.integers(0), st.integers(1, 6), st.sampled_from((IMAGE, SHORTEST)))
def test_readable_images_round_trip(seed: int, changes: int, image: bytes) -> None:
    rng = random.Random(seed)
    damaged = bytearray(image)
    for _ in range(changes):
        at = rng.randrange(16, len(damaged) + 1)
        match rng.randrange(4):
            case 0:
                damaged[at - 12] = rng.choice((0, 1, 2, 8, 10, 0x80, 0x82, 0x84, rng.randrange(256)))
            case 1:
                del damaged[at:]
            case 2:
                damaged[at:at] = rng.randbytes(rng.randrange(4))
            case 3:
                damaged[at:at] = bytes((rng.choice((0x08, 0x0A, 0x40, 0x3A)),))
    program = programs.parse(bytes(damaged), strict=False)
    if program.fault is None:
        assert assemble(source_of(program), dialect="strict").image == bytes(damaged)
        return
    with pytest.raises(BuildError, match="read in part only, so it cannot be made again: fault at"):
        source_of(program)
