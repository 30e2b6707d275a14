"""Python for its users: messages for wrong types, printed forms, pickling, types."""

from __future__ import annotations

import io
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import ev3proto
from ev3proto import (
    GV,
    LV,
    BuildError,
    DecodeError,
    DirectCommand,
    DirectReply,
    Draft,
    Message,
    MotorPort,
    MotorPorts,
    SensorPort,
    SystemReply,
    ops,
    program,
    testing,
)
from ev3proto.brick import Brick
from ev3proto.capture import CaptureError, read
from ev3proto.capture.filter import FilterError, compile_filter
from ev3proto.text.assembly import AssemblyError, assemble

pytestmark = pytest.mark.portable

ROOT = Path(__file__).parents[2]
TONE = bytes.fromhex("0e002a0080000094010182b80182e803")
VOLTAGE = bytes.fromhex("0700e80302a470fd40")


def test_what_is_expected_is_returned() -> None:
    command = ev3proto.parse(TONE, expect=DirectCommand)
    assert [operation.full_name for operation in command.operations] == ["SOUND.TONE"]
    assert ev3proto.parse(VOLTAGE, expect=Message) == ev3proto.parse(VOLTAGE)


def test_another_message_than_expected_raises() -> None:
    with pytest.raises(DecodeError) as caught:
        ev3proto.parse(VOLTAGE, expect=SystemReply)
    assert str(caught.value) == "offset 4: expected a SystemReply, but this is a DirectReply"
    with pytest.raises(DecodeError, match="offset 4: expected a DirectReply, but this is a Message"):
        ev3proto.parse(b"\x00", expect=DirectReply, strict=False)


def wrong(call: Callable[[Any], object], value: object) -> str:
    with pytest.raises((TypeError, BuildError)) as caught:
        call(value)
    return str(caught.value)


def test_wrong_types_get_a_sentence() -> None:
    assert wrong(ev3proto.parse, "0e002a00") == (
        "a frame must be bytes, not text: convert hex by bytes.fromhex('0e002a00')"
    )
    assert wrong(ev3proto.parse, TONE.hex()) == (
        "a frame must be bytes, not text: convert hex by bytes.fromhex('0e002a0080000094...')"
    )
    assert wrong(ev3proto.parse, 14) == "a frame must be bytes, not int"
    for call in (ev3proto.check, ev3proto.fix, Brick().receive):
        assert wrong(call, "0e002a00") == "a frame must be bytes, not text: convert hex by bytes.fromhex('0e002a00')"
        assert wrong(call, 14) == "a frame must be bytes, not int"
    for image_call in (program.parse, program.check_program):
        assert (
            wrong(image_call, "4c45474f")
            == "an image must be bytes, not text: convert hex by bytes.fromhex('4c45474f')"
        )
    assert wrong(ev3proto.Decoder().feed, "0e") == (
        "a chunk of a stream must be bytes, not text: convert hex by bytes.fromhex('0e')"
    )
    assert wrong(ev3proto.Dialogue().feed, TONE) == ("a dialogue takes messages, not bytes: use ev3proto.parse(frame)")


@pytest.mark.parametrize("index", ["a", 1.5, None, True])
def test_the_index_of_a_variable_is_a_number(index: Any) -> None:
    for variable in (GV, LV):
        assert wrong(variable, index) == f"the index of a variable must be a whole number, 0 or more, not {index!r}"


@pytest.mark.parametrize("index", [1 << 70, -1])
def test_a_variable_is_shown_whatever_it_is_made_of(index: int) -> None:
    assert repr(GV(index, handle=True)) == f"GV({index}, handle=True)"
    assert repr(GV(0, address=index)) == "GV(0, address=True)"  # type: ignore[arg-type]
    assert repr(GV(0, handle="x")) == "GV(0, handle=True)"  # type: ignore[arg-type]


def test_what_is_printed() -> None:
    assert repr(GV(0)) == "GV(0)"
    assert repr(LV(4, handle=True)) == "LV(4, handle=True)"
    command = ev3proto.command(ops.ui_read.get_vbatt(), counter=1)
    assert repr(command) == (
        "DirectCommand(DIRECT_COMMAND_REPLY, counter=1, global_size=4,"
        " operations=(<UI_READ.GET_VBATT(VALUE=GV(0)) at 7>,))"
    )
    assert repr(command.operations[0].arguments) == "(Argument(VALUE=GV(0), GV0, offset=9),)"
    assert repr(ev3proto.parse(VOLTAGE)) == r"DirectReply(DIRECT_REPLY, counter=1000, memory=b'\xa4p\xfd@')"
    assert repr(ev3proto.parse(TONE[:3], strict=False)) == (
        "Message(flaw=Flaw(fault=Fault(offset=3, reason='a frame has at least 5 bytes (length, counter, type), this one"
        r" has 3', truncated=True), rest=b'\x0e\x00*'))"
    )


@pytest.mark.parametrize("name", ["wifi.pcapng", "usb-plugged.pcap", "bluetooth.pcapng"])
def test_records_can_be_pickled(name: str) -> None:
    for record in read(ROOT / "captures" / name):
        again = pickle.loads(pickle.dumps(record))
        assert (again.frame, again.numbers, again.time_ns, again.route) == (
            record.frame,
            record.numbers,
            record.time_ns,
            record.route,
        )
        assert (again.message, again.latency, again.transfer) == (record.message, record.latency, record.transfer)
        assert repr(again.values) == repr(record.values)
        assert repr(pickle.loads(pickle.dumps(record)).message) == repr(record.message)


# Errors, names, ports


@pytest.mark.parametrize(
    ("call", "bases"),
    [
        (lambda: ev3proto.parse(b"\x00"), (DecodeError, ValueError)),
        (lambda: ev3proto.operation("SOUND.TONE", 1), (BuildError, ValueError)),
        (lambda: list(ev3proto.Decoder().feed(b"\xff\xff\x00\x00\x80")), (ev3proto.StreamError, DecodeError)),
        (lambda: list(read(io.BytesIO(b"not a capture"))), (CaptureError, ValueError)),
        (lambda: assemble("SOUND("), (AssemblyError, ValueError)),
        (lambda: compile_filter("VOLUME >"), (FilterError, ValueError)),
    ],
)
def test_one_class_is_above_all_errors(call: Callable[[], object], bases: tuple[type[Exception], ...]) -> None:
    with pytest.raises(ev3proto.Error) as caught:
        call()
    assert all(isinstance(caught.value, base) for base in bases)
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)


def test_errors_of_connections_are_below_it_too() -> None:
    assert issubclass(ev3proto.LinkError, ev3proto.Error)
    assert issubclass(ev3proto.NoAnswerError, TimeoutError)


def test_dir_lists_what_is_public() -> None:
    assert {"parse", "Error", "MotorPorts", "schema", "messages", "__version__"} <= set(dir(ev3proto))
    assert not {"opSound", "TONE", "LED_RED", "import_module", "TYPE_CHECKING"} & set(dir(ev3proto))
    assert ev3proto.opSound == b"\x94"
    assert {"FRAME", "OPERATIONS", "declared"} <= set(dir(ev3proto.schema))
    assert dir(testing) == testing.__all__


@pytest.mark.parametrize(
    ("operation", "encoded"),
    [
        (ops.output_start(0, MotorPorts.A), "A6 00 01"),
        (ops.output_start(0, MotorPorts.A | MotorPorts.D), "A6 00 09"),
        (ops.output_start(0, MotorPorts.ALL), "A6 00 0F"),
        (ops.output_get_count(0, MotorPort.D, GV(0)), "B3 00 03 60"),
        (ops.input_device.get_typemode(0, SensorPort.S2, GV(0), GV(1)), "99 05 00 01 60 61"),
        (ops.input_read(0, SensorPort.S4, 0, 0, GV(0)), "9A 00 03 00 00 60"),
    ],
)
def test_names_of_ports(operation: Draft, encoded: str) -> None:
    assert ev3proto.command(operation).build()[7:] == bytes.fromhex(encoded)


def test_a_bit_is_not_taken_for_a_number() -> None:
    with pytest.raises(BuildError, match="NOS takes a MotorPorts or a number, not <MotorPort"):
        ops.output_start(0, MotorPort.A)
    with pytest.raises(BuildError, match="NO takes a SensorPort or a number, not <MotorPort"):
        ops.input_read(0, MotorPort.A, 0, 0, GV(0))
