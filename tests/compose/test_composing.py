"""Commands composed from operations: places in memory, sizes, reply type, and replies that read back by name.

Expected values are written out, or computed here from the protocol's description, not by the code under test.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from random import Random
from typing import Any

import pytest
from support.cases import each

import ev3proto
from ev3proto import (
    GV,
    LV,
    BuildError,
    Dialogue,
    DirectCommand,
    Draft,
    Global,
    Local,
    command,
    direct_reply,
    ops,
)
from ev3proto.enums import LED
from ev3proto.schema.instructions import instruction_set
from ev3proto.semantics.drafts.functions import draft, drafts
from ev3proto.tables import operations as operations_of
from ev3proto.tables.declaration import DIALECTS, Direction

pytestmark = pytest.mark.portable


def operation_code(message: DirectCommand) -> str:
    """The byte code in hex, an operation each piece."""
    return " ".join(operation.raw.hex() for operation in message.operations)


def sizes(message: DirectCommand) -> tuple[bool, int, int]:
    """Whether a reply is wanted, bytes of global and of local memory."""
    return message.wants_reply, message.global_size, message.local_size


# Outputs that are omitted


def test_battery_and_charge_read_back_by_name() -> None:
    message = command(ops.ui_read.get_vbatt(), ops.ui_read.get_lbatt(), counter=42)
    assert message.build().hex(":") == "0b:00:2a:00:00:05:00:81:01:60:81:12:64"
    dialogue = Dialogue()
    dialogue.feed(message)
    found = dialogue.feed(direct_reply(struct.pack("<fb", 7.5, 80), counter=42))
    assert [(value.command, value.name, value.value, value.unit) for value in found] == [
        ("GET_VBATT", "VALUE", 7.5, "V"),
        ("GET_LBATT", "PCT", 80, "%"),
    ]


def test_outputs_follow_each_other_in_order_and_aligned() -> None:
    message = command(
        ops.ui_read.get_lbatt(),  # DATA8 at 0
        ops.ui_read.get_vbatt(),  # DATAF at 4
        ops.ui_button.get_horz(),  # DATA16 at 8
        ops.ui_read.get_os_vers(5),  # text of 5 bytes at 10
        ops.output_read(0, 0),  # DATA8 at 15, DATA32 at 16
    )
    places = [
        argument.value
        for operation in message.operations
        for argument in operation.arguments
        if argument.kind == "global"
    ]
    assert places == [0, 4, 8, 10, 15, 16]
    assert sizes(message) == (True, 20, 0)


def test_arrays_take_what_their_length_says() -> None:
    message = command(ops.input_device_list(4), ops.memory_read(1, 0, 0, 5))
    assert operation_code(message) == "98046064 7f010000056" + "5"
    assert sizes(message) == (True, 10, 0)


def test_lists_of_outputs() -> None:
    message = command(ops.input_device.ready_raw(0, 0, 0, 0, 3), ops.input_readext(0, 0, 0, 0, "DATA_PCT", 2))
    assert operation_code(message) == "991c0000000003606468 9e00000000100" + "26c6d"
    assert sizes(message) == (True, 14, 0)
    assert sizes(command(ops.input_device.ready_si(0, 0, 0, 0))) == (True, 4, 0)


def test_the_same_operation_twice_has_two_outputs() -> None:
    battery = ops.ui_read.get_vbatt()
    assert operation_code(command(battery, battery)) == "810160 810164"
    assert operation_code(command(battery)) == "810160"


# Places by hand


def test_explicit_places_are_kept() -> None:
    message = command(ops.ui_read.get_vbatt(GV(4)), ops.ui_read.get_vbatt(), ops.ui_read.get_vbatt())
    assert operation_code(message) == "810164 810160 810168"
    assert sizes(message) == (True, 12, 0)


def test_a_text_of_unknown_length_ends_at_the_next_explicit_place() -> None:
    message = command(
        ops.strings.duplicate("abc", GV(0)), ops.ui_read.get_lbatt(GV(8)), ops.ui_read.get_vbatt(), ops.random(1, 2)
    )
    assert [operation.arguments[-1].value for operation in message.operations] == [0, 8, 12, 16]
    with pytest.raises(BuildError) as raised:
        command(ops.strings.duplicate("abc", GV(0)), ops.ui_read.get_vbatt())
    assert str(raised.value) == (
        "the size of DESTINATION of STRINGS.DUPLICATE from GV(0) on is unknown, so there is no safe place"
        " for VALUE of UI_READ.GET_VBATT: give it an explicit place, too"
    )


def test_sizes_and_reply_by_hand() -> None:
    battery = ops.ui_read.get_vbatt()
    assert sizes(command(battery, global_size=100, local_size=7)) == (True, 100, 7)
    assert sizes(command(ops.sound.break_(), reply=True)) == (True, 0, 0)
    assert sizes(command(ops.sound.break_(), global_size=3)) == (True, 3, 0)
    assert sizes(command(ops.ui_read.get_vbatt(GV(0)), reply=False)) == (False, 4, 0)
    assert sizes(command(battery, ops.or8(1, 2, LV(0)), global_size=4, local_size=1)) == (True, 4, 1)
    with pytest.raises(
        BuildError, match=r"^global_size must be 4 or more, not 2: the operations use that much global memory$"
    ):
        command(battery, global_size=2)
    with pytest.raises(
        BuildError, match=r"^local_size must be 1 or more, not 0: the operations use that much local memory$"
    ):
        command(ops.or8(1, 2, LV(0)), local_size=0)
    with pytest.raises(BuildError, match="local_size cannot be 64: a header can request 0 to 63 bytes"):
        command(ops.sound.break_(), local_size=64)


def test_unread_outputs_go_to_local_memory() -> None:
    message = command(ops.file.make_folder("a"), ops.output_read(0, 0), reply=False)
    assert sizes(message) == (False, 0, 8)
    assert [argument.kind for argument in message.operations[1].arguments[2:]] == ["local", "local"]


def test_operations_made_otherwise() -> None:
    made = ev3proto.operation("UI_READ.GET_VBATT", GV(0))
    parsed = ev3proto.parse(bytes.fromhex("0800 0100 00 0400 810160"), expect=DirectCommand)
    message = command(made, ops.ui_read.get_lbatt(), *parsed.operations)
    assert operation_code(message) == "810160 811264 810160"
    assert sizes(message) == (True, 5, 0)


# Variables that operations share


def test_a_local_variable_hands_a_value_on() -> None:
    speed = Local()
    message = command(ops.output_read(0, 0, speed=speed), ops.output_power(0, 2, speed), ops.output_start(0, 2))
    assert operation_code(message) == "a800004060 a4000240 a60002"
    assert sizes(message) == (True, 4, 1)


def test_a_variable_is_as_large_and_as_aligned_as_its_widest_use() -> None:
    first, wide = Local(), Local()
    message = command(
        ops.move8_8(1, first), ops.move8_8(2, wide), ops.move32_32(5, wide), ops.add32(wide, 1, Local()), reply=False
    )
    assert operation_code(message) == "300140 300244 3a0544 12440148"
    assert sizes(message) == (False, 0, 12)


def test_global_variables_keep_the_order_of_outputs() -> None:
    total = Global()
    message = command(ops.ui_read.get_lbatt(), ops.add32(1, 2, total), ops.mul32(total, 3, total))
    assert operation_code(message) == "811260 12010264 1a640364"
    assert sizes(message) == (True, 8, 0)


def test_a_text_goes_from_one_operation_to_another() -> None:
    name = Local()
    message = command(ops.com_get.get_brickname(16, name), ops.ui_draw.text(1, 0, 0, name), ops.ui_draw.update())
    assert operation_code(message) == "d30d1040 840501000040 8400"
    assert sizes(message) == (False, 0, 16)


def test_a_handle_is_marked_where_it_is_used_as_one() -> None:
    array = Local()
    message = command(ops.array.create8(20, array), ops.strings.duplicate("abc", array.as_handle()))
    assert operation_code(message) == "c1011440 7d058461626300d100"
    assert sizes(message) == (False, 0, 2)
    pointer = Local()
    marked = command(ops.move32_32(0, pointer), ops.move8_8(pointer.as_address(), Local()), reply=False)
    assert operation_code(marked) == "3a0040 30c90044"


@pytest.mark.parametrize(
    ("operations", "sentence"),
    [
        ((), "a command needs at least one operation: the brick refuses an empty one"),
        ((b"\x01",), "b'\\x01' is not an operation: use ev3proto.ops, for example ops.sound.tone(1, 440, 1000)"),
        (
            (ops.strings.add("a", "b", Global()),),
            "the size of DESTINATION of STRINGS.ADD is unknown: pass one, such as Global(32)",
        ),
        (
            (ops.ui_read.get_vbatt(Global(2)),),
            "Global(2) is too small: VALUE of UI_READ.GET_VBATT takes 4 bytes",
        ),
        (
            (ops.memory_read(1, 0, 0, 1000), ops.memory_read(1, 0, 0, 20)),
            "no room for the 20 bytes of ARRAY of MEMORY_READ: global memory has 1019, of which 1000",
        ),
        (
            (ops.ui_read.get_os_vers(64, Local()),),
            "no room for the 64 bytes of DESTINATION of UI_READ.GET_OS_VERS: local memory has 63, of which 0",
        ),
        (
            (ops.ui_read.get_vbatt(GV(1016)),),
            "the operations use global memory up to byte 1020, but it has at most 1019",
        ),
        ((ops.or8(1, 2, LV(63)),), "the operations use local memory up to byte 64, but it has at most 63"),
        ((ops.strings.compare("a" * 500, "b" * 500),) * 2, "the brick accepts at most 1024 in one frame"),
    ],
)
def test_refused_commands(operations: tuple[Any, ...], sentence: str) -> None:
    with pytest.raises(BuildError) as raised:
        command(*operations)
    assert sentence in str(raised.value)


def test_counters() -> None:
    assert command(ops.nop()).counter == 0
    assert command(ops.nop(), counter=65535).build().hex() == "0600ffff80000001"
    with pytest.raises(BuildError, match="counter cannot be 65536"):
        command(ops.nop(), counter=65536)


# Every operation

HOME = {name: dialect for dialect in reversed(DIALECTS) for name in operations_of(dialect)}

EDGES: list[Any] = [0, 1, -1, 2, 31, 32, -32, 100, 127, -127, -128, 255, 440, 32767, -32768, 65535, 2**31 - 1, 2**31]
EDGES += [True, False, 1.0, 0.5, float("nan"), float("inf"), "a", "", LED.RED, None, GV(0), GV(3), b"\x01", [1]]


@each("name", sorted(HOME))
def test_cached_values_are_those_that_are_checked(name: str) -> None:
    schema = instruction_set(HOME[name])[name]
    function = drafts(HOME[name])[name]
    random = Random(name)
    for _ in range(30):
        values = [
            random.choice([*EDGES, *(parameter.enum.members if parameter.enum else ()), *parameter.special])
            if parameter.direction is Direction.IN
            else random.choice([None, None, None, *EDGES])
            for parameter in schema.declaration.parameters
        ]
        careful = outcome(draft, schema, values)
        assert [outcome(function.draft, values, False) for _ in range(2)] == [careful] * 2, values


def outcome(make: Callable[..., Draft], *arguments: Any) -> str:
    try:
        made = make(*arguments)
        return f"{made!r} {command(made).build().hex()}"
    except BuildError as error:
        return str(error)
