"""Dialogues: replies read through the commands they answer."""

from __future__ import annotations

import math
import struct
from typing import Any

import pytest

import ev3proto
from ev3proto import GV, LV, Value
from ev3proto.dialogue import MOST_PENDING

pytestmark = pytest.mark.portable


def ask(*operations: ev3proto.Operation, counter: int = 1, size: int = 64) -> ev3proto.DirectCommand:
    return ev3proto.direct_command(*operations, counter=counter, reply=True, global_size=size, local_size=16)


def answer(memory: bytes, counter: int = 1, size: int = 64) -> ev3proto.DirectReply:
    return ev3proto.direct_reply(memory.ljust(size, b"\0"), counter=counter)


def values(*operations: ev3proto.Operation, memory: bytes) -> list[Value]:
    dialogue = ev3proto.Dialogue()
    assert dialogue.feed(ask(*operations)) == []
    return dialogue.feed(answer(memory))


def test_a_float_with_its_unit() -> None:
    (value,) = values(ev3proto.operation("UI_READ.GET_VBATT", GV(0)), memory=struct.pack("<f", 7.92))
    assert (value.op, value.command, value.name, value.unit, value.type) == (
        "UI_READ",
        "GET_VBATT",
        "VALUE",
        "V",
        "DATAF",
    )
    assert value.value == pytest.approx(7.92)
    assert (value.offset, value.length) == (5, 4)


def test_the_examples_of_the_protocol() -> None:
    dialogue = ev3proto.Dialogue()
    dialogue.feed(ev3proto.parse(bytes.fromhex("0B 00 01 00 00 01 00 9A 00 00 00 00 60")))
    (percent,) = dialogue.feed(ev3proto.parse(bytes.fromhex("04 00 01 00 02 00")))
    assert (percent.name, percent.value) == ("PCT", 0)
    dialogue.feed(ev3proto.parse(bytes.fromhex("09 00 05 00 00 05 00 98 04 60 64")))
    devices, changed = dialogue.feed(ev3proto.parse(bytes.fromhex("08 00 05 00 02 7E 7E 7E 7D 00")))
    assert devices.name == "ARRAY"
    assert devices.value == [126, 126, 126, 125]
    assert devices.symbol == ["TYPE_NONE", "TYPE_NONE", "TYPE_NONE", "TYPE_UNKNOWN"]
    assert (changed.name, changed.value, changed.offset) == ("CHANGED", 0, 9)


NAME = ("INPUT_DEVICE.GET_NAME", 0, 0, 16, GV(0))


@pytest.mark.parametrize(
    ("operation", "memory", "expected"),
    [
        # A text ends at its zero or its length; -1 means unlimited.
        (NAME, b"EV3-BRICK\0rest", {"DESTINATION": "EV3-BRICK"}),
        (NAME, b"0123456789abcdefTOO MUCH", {"DESTINATION": "0123456789abcdef"}),
        (NAME, b"\xe9t\xe9\0", {"DESTINATION": "été"}),
        (("UI_READ.GET_FW_VERS", -1, GV(3)), b"...V1.09H\0", {"DESTINATION": "V1.09H"}),
        # Several values
        (("INPUT_DEVICE.READY_PCT", 0, 0, 0, 0, [GV(0), GV(1)]), b"\x32\xfd", {"VALUES[0]": 50, "VALUES[1]": -3}),
        (("INPUT_DEVICE.READY_RAW", 0, 0, 0, 0, [GV(4)]), b"....\xff\xff\xff\xff", {"VALUES[0]": -1}),
        (("INPUT_DEVICE.READY_SI", 0, 0, 0, 0, [GV(0)]), b"\x00\x00\x00\xc0", {"VALUES[0]": -2.0}),
        (("INPUT_READEXT", 0, 0, 0, 0, "DATA_16", [GV(0)]), b"\xfb\xff", {"VALUES[0]": -5}),
        (("MEMORY_READ", 1, 0, 0, 5, GV(0)), b"\x01\x02\xff\x04\x05\x06", {"ARRAY": [1, 2, -1, 4, 5]}),
    ],
)
def test_values_in_the_form_of_their_parameters(
    operation: tuple[Any, ...], memory: bytes, expected: dict[str, object]
) -> None:
    found = values(ev3proto.operation(*operation), memory=memory)
    assert {value.name: value.value for value in found} == expected


GYRO, ULTRASONIC, MOTOR, NXT_TEMPERATURE = 32, 30, 7, 6


@pytest.mark.parametrize(
    ("operation", "expected"),
    [
        (("INPUT_DEVICE.READY_SI", 0, 0, GYRO, 3, [GV(0), GV(4)]), [("angle", "degrees"), ("rate", "degrees/s")]),
        (("INPUT_DEVICE.READY_SI", 0, 0, GYRO, 1, [GV(0), GV(4)]), [("rate", "degrees/s"), (None, None)]),
        (("INPUT_READSI", 0, 0, ULTRASONIC, 0, GV(0)), [("distance", "cm")]),
        (("INPUT_READSI", 0, 0, NXT_TEMPERATURE, 1, GV(0)), [("temperature", "°F")]),
        (("INPUT_READSI", 0, 0, 29, 2, GV(0)), [("colour", None)]),
        (("INPUT_DEVICE.READY_SI", 0, 3, 33, 1, [GV(4 * n) for n in range(3)]), [
            ("heading on channel 1", None), ("distance on channel 1", "%"), ("heading on channel 2", None)
        ]),
        # Raw values are in the unit where the ranges agree.
        (("INPUT_DEVICE.READY_RAW", 0, 16, MOTOR, 0, [GV(0)]), [("angle", "degrees")]),
        (("INPUT_DEVICE.READY_RAW", 0, 0, ULTRASONIC, 0, [GV(0)]), [(None, None)]),
        # Kept, unknown, in a variable, not documented.
        (("INPUT_DEVICE.READY_SI", 0, 0, 0, 0, [GV(0)]), [(None, None)]),
        (("INPUT_DEVICE.READY_SI", 0, 0, GYRO, -1, [GV(0)]), [(None, None)]),
        (("INPUT_DEVICE.READY_SI", 0, 0, GYRO, 9, [GV(0)]), [(None, None)]),
        (("INPUT_DEVICE.READY_SI", 0, 0, 77, 0, [GV(0)]), [(None, None)]),
        (("INPUT_DEVICE.READY_SI", 0, 0, LV(0), 0, [GV(0)]), [(None, None)]),
        (("INPUT_DEVICE.READY_SI", 0, 0, GYRO, 4, [GV(0)]), [(None, None)]),
    ],
)  # fmt: skip
def test_readings_of_devices(operation: tuple[Any, ...], expected: list[tuple[str | None, str | None]]) -> None:
    found = values(ev3proto.operation(*operation), memory=bytes(32))
    assert [(value.quantity, value.unit) for value in found] == expected


def test_names_of_enumerations() -> None:
    kind, mode = values(ev3proto.operation("INPUT_DEVICE.GET_TYPEMODE", 0, 0, GV(0), GV(1)), memory=b"\x1d\x02")
    assert (kind.value, kind.symbol) == (29, "TYPE_COLOR")
    assert (mode.value, mode.symbol) == (2, None)


def test_an_element_is_as_large_as_the_memory_that_is_left_for_it() -> None:
    dialogue = ev3proto.Dialogue()
    dialogue.feed(ask(ev3proto.operation("ARRAY_READ", LV(0), 0, GV(0)), size=2))
    (value,) = dialogue.feed(answer(b"\x01\x80", size=2))
    assert (value.value, value.type, value.length) == (-32767, "DATA16", 2)


def test_only_what_is_in_the_reply_is_a_value() -> None:
    operations = [
        ev3proto.operation("OUTPUT_READ", 0, 0, GV(4), LV(0)),
        ev3proto.operation("SOUND.TONE", 1, 440, 1000),
        ev3proto.operation("OUTPUT_GET_COUNT", 0, 1, GV(62)),
    ]
    assert [value.name for value in values(*operations, memory=bytes(64))] == ["SPEED"]


def test_not_a_number() -> None:
    number, real = values(
        ev3proto.operation("INPUT_READ", 0, 0, 0, 0, GV(0)),
        ev3proto.operation("INPUT_READSI", 0, 0, 0, 0, GV(4)),
        memory=b"\x80\0\0\0\x00\x00\xc0\x7f",
    )
    assert number.value == -128
    assert number.is_nan
    assert isinstance(real.value, float)
    assert math.isnan(real.value)
    assert real.is_nan


def test_an_error_has_no_values() -> None:
    dialogue = ev3proto.Dialogue()
    command = ask(ev3proto.operation("UI_READ.GET_VBATT", GV(0)))
    dialogue.feed(command)
    exchange = dialogue.follow(ev3proto.direct_reply(counter=1, error=True))
    assert exchange.request == command
    assert exchange.values == []
    assert dialogue.unanswered == []


def test_replies_to_unseen_commands() -> None:
    dialogue = ev3proto.Dialogue()
    dialogue.feed(ask(ev3proto.operation("UI_READ.GET_VBATT", GV(0)), counter=7))
    exchange = dialogue.follow(answer(b"", counter=8))
    assert exchange.is_orphan
    assert exchange.values == []
    assert [message.counter for message in dialogue.unanswered] == [7]


def test_replies_late_and_out_of_order() -> None:
    dialogue = ev3proto.Dialogue()
    for counter in (65535, 0):
        dialogue.feed(ask(ev3proto.operation("OUTPUT_GET_COUNT", 0, 1, GV(0)), counter=counter))
    assert dialogue.feed(answer(struct.pack("<i", 2), counter=0))[0].value == 2
    assert dialogue.feed(answer(struct.pack("<i", 1), counter=65535))[0].value == 1
    assert dialogue.feed(answer(b"", counter=0)) == []


def test_a_counter_used_again() -> None:
    """The first command's reply was lost; the second's must not be read through the first."""
    dialogue = ev3proto.Dialogue()
    dialogue.feed(ask(ev3proto.operation("UI_READ.GET_VBATT", GV(0)), counter=5, size=4))
    dialogue.feed(ask(ev3proto.operation("OUTPUT_TEST", 0, 15, GV(0)), counter=5, size=1))
    assert [value.name for value in dialogue.feed(answer(b"\x01", counter=5, size=1))] == ["BUSY"]


def test_of_commands_of_one_counter_and_one_size_the_oldest_is_answered() -> None:
    dialogue = ev3proto.Dialogue()
    for name in ("UI_READ.GET_VBATT", "UI_READ.GET_IBATT"):
        dialogue.feed(ask(ev3proto.operation(name, GV(0)), counter=5, size=4))
    first = dialogue.follow(answer(struct.pack("<f", 7.5), counter=5, size=4))
    second = dialogue.follow(answer(struct.pack("<f", 0.25), counter=5, size=4))
    assert [(one.values[0].command, one.values[0].value) for one in (first, second)] == [
        ("GET_VBATT", 7.5),
        ("GET_IBATT", 0.25),
    ]
    assert first.note == "the pairing is unsure: several commands with its counter waited"
    assert second.note is None


def test_commands_before_the_one_that_is_answered_are_given_up() -> None:
    dialogue = ev3proto.Dialogue()
    for name, size in (("UI_READ.GET_TBATT", 8), ("UI_READ.GET_VBATT", 4), ("UI_READ.GET_IBATT", 4)):
        dialogue.feed(ask(ev3proto.operation(name, GV(0)), counter=5, size=size))
    (value,) = dialogue.feed(answer(struct.pack("<f", 7.5), counter=5, size=4))
    assert (value.command, value.value) == ("GET_VBATT", 7.5)
    assert [message.global_size for message in dialogue.unanswered] == [4]  # type: ignore[attr-defined]


def test_a_reply_that_fits_no_command_of_its_counter_answers_the_newest() -> None:
    dialogue = ev3proto.Dialogue()
    commands = [ask(ev3proto.operation("UI_READ.GET_VBATT", GV(0)), counter=5, size=size) for size in (4, 8)]
    for command in commands:
        dialogue.feed(command)
    assert dialogue.follow(answer(b"", counter=5, size=2)).request is commands[1]


def test_a_sender_that_never_changes_its_counter() -> None:
    """Two commands on their way at once: the size of the reply tells which one it answers."""
    dialogue = ev3proto.Dialogue()
    dialogue.feed(ask(ev3proto.operation("UI_READ.GET_VBATT", GV(0)), counter=0, size=4))
    dialogue.feed(ask(ev3proto.operation("OUTPUT_TEST", 0, 15, GV(0)), counter=0, size=1))
    assert dialogue.feed(answer(struct.pack("<f", 8), counter=0, size=4))[0].value == 8.0
    assert dialogue.feed(answer(b"\x01", counter=0, size=1))[0].value == 1


def test_a_reply_with_less_memory_than_asked_for() -> None:
    """As in a log whose lines are cut: the available bytes are read."""
    first = ev3proto.operation("UI_READ.GET_VBATT", GV(0))
    second = ev3proto.operation("UI_READ.GET_IBATT", GV(4))
    dialogue = ev3proto.Dialogue()
    dialogue.feed(ask(first, second, size=8))
    assert [value.command for value in dialogue.feed(answer(struct.pack("<f", 8), size=6))] == ["GET_VBATT"]


def test_a_handle_is_not_in_volts() -> None:
    (value,) = values(ev3proto.operation("UI_READ.GET_VBATT", GV(40, handle=True)), memory=bytes(40) + b"\x02\x00")
    assert (value.type, value.value, value.unit) == ("handle", 2, None)


def test_a_closed_handle_has_no_file() -> None:
    dialogue = ev3proto.Dialogue()
    dialogue.feed(ev3proto.system_command("BEGIN_DOWNLOAD", counter=1, size=2, path="a.rbf"))
    dialogue.feed(ev3proto.system_reply("BEGIN_DOWNLOAD", counter=1, handle=0))
    dialogue.feed(ev3proto.system_command("CONTINUE_DOWNLOAD", counter=2, handle=0, data=b"ab"))
    dialogue.feed(ev3proto.system_reply("CONTINUE_DOWNLOAD", counter=2, status=8, handle=0))
    late = dialogue.follow(ev3proto.system_command("CONTINUE_DOWNLOAD", counter=3, handle=0, data=b"c"))
    assert late.transfer is None


def test_commands_without_a_reply_are_not_paired() -> None:
    dialogue = ev3proto.Dialogue()
    dialogue.feed(ask(ev3proto.operation("UI_READ.GET_VBATT", GV(0)), counter=5, size=4))
    dialogue.feed(ev3proto.direct_command(ev3proto.operation("NOP"), counter=5))
    assert dialogue.feed(answer(struct.pack("<f", 8), counter=5, size=4))[0].name == "VALUE"


def test_waiting_commands_are_bounded() -> None:
    dialogue = ev3proto.Dialogue()
    message = ask(ev3proto.operation("NOP"), counter=3)
    for _ in range(300):
        dialogue.feed(message)
    assert len(dialogue.unanswered) == 256
    assert MOST_PENDING == 65536


def test_system_replies_have_fields_of_their_own() -> None:
    dialogue = ev3proto.Dialogue()
    dialogue.feed(ev3proto.system_command("LIST_FILES", counter=2, max_bytes=1000, path="/home/root/lms2012/sys/"))
    found = dialogue.feed(
        ev3proto.system_reply("LIST_FILES", counter=2, status=8, list_size=9, handle=0, list="ui/\nlib/\n")
    )
    assert [(value.op, value.command, value.name, value.value) for value in found] == [
        ("LIST_FILES", None, "list_size", 9),
        ("LIST_FILES", None, "handle", 0),
        ("LIST_FILES", None, "list", "ui/\nlib/\n"),
    ]
    assert [(value.offset, value.length) for value in found] == [(7, 4), (11, 1), (12, 9)]


def test_a_download_is_followed_by_its_handle() -> None:
    dialogue = ev3proto.Dialogue()
    dialogue.feed(ev3proto.system_command("BEGIN_DOWNLOAD", counter=1, size=10, path="../prjs/a.rbf"))
    begun = dialogue.follow(ev3proto.system_reply("BEGIN_DOWNLOAD", counter=1, handle=3)).transfer
    assert begun is not None
    assert (begun.path, begun.size, begun.handle, begun.transferred) == ("../prjs/a.rbf", 10, 3, 0)
    for number, piece in enumerate((b"123456", b"7890"), 2):
        dialogue.feed(ev3proto.system_command("CONTINUE_DOWNLOAD", counter=number, handle=3, data=piece))
        exchange = dialogue.follow(ev3proto.system_reply("CONTINUE_DOWNLOAD", counter=number, handle=3))
        assert exchange.transfer is begun
    assert begun.transferred == 10
    assert begun.is_complete


def test_an_upload_is_followed_by_its_handle() -> None:
    dialogue = ev3proto.Dialogue()
    dialogue.feed(ev3proto.system_command("BEGIN_UPLOAD", counter=1, max_bytes=4, path="a.rtf"))
    dialogue.feed(ev3proto.system_reply("BEGIN_UPLOAD", counter=1, size=6, handle=0, data=b"abcd"))
    asked = dialogue.follow(ev3proto.system_command("CONTINUE_UPLOAD", counter=2, handle=0, max_bytes=4)).transfer
    assert asked is not None
    assert (asked.path, asked.size, asked.transferred) == ("a.rtf", 6, 4)
    told = dialogue.follow(ev3proto.system_reply("CONTINUE_UPLOAD", counter=2, status=8, handle=0, data=b"ef"))
    assert told.transfer is asked
    assert asked.is_complete


def test_a_handle_of_an_unseen_command_has_no_file() -> None:
    dialogue = ev3proto.Dialogue()
    dialogue.follow(ev3proto.system_command("BEGIN_UPLOAD", counter=1, max_bytes=2, path="a.rtf"))
    begun = ev3proto.system_reply("BEGIN_UPLOAD", counter=1, size=6, handle=0, data=b"ab")
    assert dialogue.follow(begun).transfer is not None
    unseen = ev3proto.system_reply("BEGIN_DOWNLOAD", counter=2, handle=0)
    assert dialogue.follow(unseen).transfer is None
    piece = ev3proto.system_command("CONTINUE_DOWNLOAD", counter=3, handle=0, data=b"abc")
    assert dialogue.follow(piece).transfer is None


def test_a_revoked_handle_has_no_file() -> None:
    dialogue = ev3proto.Dialogue()
    dialogue.follow(ev3proto.system_command("BEGIN_DOWNLOAD", counter=1, size=10, path="../prjs/a.rbf"))
    dialogue.follow(ev3proto.system_reply("BEGIN_DOWNLOAD", counter=1, handle=3))
    dialogue.follow(ev3proto.system_command("CONTINUE_DOWNLOAD", counter=2, handle=3, data=b"123456"))
    failed = ev3proto.system_reply("CONTINUE_DOWNLOAD", counter=2, status=1, handle=3)
    assert dialogue.follow(failed).transfer is not None
    again = ev3proto.system_command("CONTINUE_DOWNLOAD", counter=3, handle=3, data=b"7890")
    assert dialogue.follow(again).transfer is None
