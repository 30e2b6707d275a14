"""Every schema is a Construct: it parses, builds, also from mappings, and works inside other `Struct`s."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import construct
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.cases import each
from support.effort import effort

import ev3proto
from ev3proto import BuildError, MessageType
from ev3proto.schema.argument import IDENTIFICATION, ArgumentSchema
from ev3proto.schema.discovery import BEACON, UNLOCK
from ev3proto.schema.fields import REPLIES, REQUESTS, Fields
from ev3proto.schema.frame import SENSOR_REPORT, frame_schema
from ev3proto.schema.header import HEADER, MEMORY
from ev3proto.schema.instructions import instruction_set
from ev3proto.tables import operations as operations_of
from ev3proto.tables.declaration import DIALECTS, Type
from ev3proto.tables.system import SYSTEM, Field, Kind
from ev3proto.testing import messages, values_for

few = settings(max_examples=effort(2, 20), database=None)
many = settings(max_examples=effort(80, 1000))

HOME = {name: dialect for dialect in reversed(DIALECTS) for name in operations_of(dialect)}
"""Every operation of every dialect, and one dialect that has it."""

NOP = {"name": "NOP"}
TONE = bytes.fromhex("0e002a0080000094010182b80182e803")


def assert_stands_in_a_struct(schema: Any, value: Any, data: bytes) -> None:
    """Between two other fields: the same bytes are built from the value and from the parsed object."""
    record = construct.Struct("before" / construct.Int8ul, "it" / schema, "after" / construct.Const(b"END"))
    whole = b"\x07" + data + b"END"
    assert record.build({"before": 7, "it": value}) == whole
    assert record.build(record.parse(whole)) == whole


@pytest.mark.parametrize(
    ("schema", "value", "data"),
    [
        (HEADER, {"length": 14, "counter": 0x802A, "type": 0x80}, "0E 00 2A 80 80"),
        (MEMORY, {"globals": 1021, "locals": 2}, "FD 0B"),
        (IDENTIFICATION, {"is_long": False, "is_variable": False, "form": {"value": -1}}, "3F"),
        (IDENTIFICATION, {"is_long": False, "is_variable": True, "form": {"is_global": True, "value": 4}}, "64"),
        (
            IDENTIFICATION,
            {
                "is_long": True,
                "is_variable": True,
                "form": {"selector": True, "handle": True, "address": False, "width": 1},
            },
            "F1",
        ),
        (
            SENSOR_REPORT,
            {"layer": 0, "port": 1, "status": 2, "type": 3, "mode": 4, "data": bytes(32), "checksum": 5, "busy": b""},
            f"00 01 02 03 04 {'00' * 32} 05",
        ),
    ],
)
def test_headers_and_identification_bytes(schema: Any, value: Mapping[str, Any], data: str) -> None:
    raw = bytes.fromhex(data)
    assert schema.build(value) == raw
    assert schema.build(schema.parse(raw)) == raw
    if schema is not SENSOR_REPORT:  # which continues to the end of the bytes
        assert_stands_in_a_struct(schema, value, raw)


@each("byte", range(256))
def test_every_identification_byte(byte: int) -> None:
    data = bytes((byte,))
    assert_stands_in_a_struct(IDENTIFICATION, IDENTIFICATION.parse(data), data)


def test_what_comes_before_frames() -> None:
    lines = {"serial": "0016533fba5f", "port": "5555", "name": "EV3", "protocol": "EV3"}
    assert_stands_in_a_struct(BEACON, lines, BEACON.build(lines))
    assert_stands_in_a_struct(UNLOCK, {"serial": "0016533FBA5F"}, UNLOCK.build(ev3proto.Unlock("0016533FBA5F")))


@each("name", sorted(HOME))
def test_every_operation(name: str) -> None:
    """Values in order and by name build the bytes of `ev3proto.operation`; so does each argument alone."""
    schema = instruction_set(HOME[name])[name]
    parameters = schema.declaration.parameters

    @few
    @given(st.tuples(*map(values_for, parameters)))
    def check(drawn: tuple[Any, ...]) -> None:
        values = list(drawn)
        if parameters and parameters[-1].type is Type.VALUES:
            values[-2] = len(values[-1])
        named = {parameter.name: value for parameter, value in zip(parameters, values, strict=True)}
        try:
            raw = ev3proto.operation(name, *values, dialect=HOME[name]).raw
        except BuildError:  # another value gives the type of the elements of a list
            return
        assert schema.build(named) == schema.build(values) == schema.build(schema.parse(raw)) == raw
        assert_stands_in_a_struct(schema, named, raw)
        for argument in schema.parse(raw).arguments:
            assert_stands_in_a_struct(ArgumentSchema(argument.parameter), argument, argument.raw)

    check()


_DATA: dict[Kind, str | bytes] = {Kind.TEXT: "/a", Kind.LISTING: "a\nb", Kind.COUNTED_TEXT: "ab", Kind.DATA: b"\1\2"}
"""The values of each kind of field that is not a number."""


def _value(field: Field, fields: tuple[Field, ...]) -> Any:
    counted = next((one for one in fields if one.name == field.counts), None)
    if counted is None:
        return _DATA.get(field.kind, 1)
    return len(_DATA[counted.kind]) + (counted.kind is Kind.COUNTED_TEXT)


@pytest.mark.parametrize("entry", SYSTEM, ids=lambda entry: f"{entry.number:02X}")
@pytest.mark.parametrize("is_reply", [False, True])
def test_every_system_command(entry: Any, is_reply: bool) -> None:
    fields = entry.reply if is_reply else entry.request
    schema = (REPLIES if is_reply else REQUESTS)[entry.number]
    values = {field.name: _value(field, fields) for field in fields}
    raw = schema.build(values)
    assert schema.parse(raw) == values
    assert schema.build({field.name: values[field.name] for field in fields if field.counts is None}) == raw
    record = construct.Struct("number" / construct.Int8ul, "fields" / Fields(fields))
    assert record.build({"number": entry.number, "fields": values}) == bytes((entry.number,)) + raw
    assert record.parse(b"\1" + raw).fields == values
    frame = frame_schema().build(
        {
            "type": MessageType.SYSTEM_REPLY if is_reply else MessageType.SYSTEM_COMMAND_REPLY,
            "counter": 7,
            "number": entry.number,
            "fields": {field.name: values[field.name] for field in fields if field.counts is None},
        }
    )
    make: Any = ev3proto.system_reply if is_reply else ev3proto.system_command
    assert frame == make(entry.number, counter=7, **values).build()


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        (
            {
                "type": "DIRECT_COMMAND_NO_REPLY",
                "counter": 42,
                "operations": [{"name": "SOUND", "command": "TONE", "arguments": [1, 440, 1000]}],
            },
            TONE.hex(),
        ),
        (
            {
                "length": 14,
                "type": 0x80,
                "counter": 42,
                "operations": [{"name": "SOUND.TONE", "arguments": {"VOLUME": 1, "FREQUENCY": 440, "DURATION": 1000}}],
            },
            TONE.hex(),
        ),
        (
            {"type": MessageType.DIRECT_COMMAND_REPLY, "global_size": 1, "local_size": 2, "operations": [NOP]},
            "06000000 00 0108 01",
        ),
        ({"type": "DIRECT_REPLY", "counter": 42, "memory": b"\1\2"}, "05002a00 02 0102"),
        (
            {"type": "SYSTEM_COMMAND_REPLY", "command": "list_files", "fields": {"max_bytes": 1, "path": "a"}},
            "08000000 01 99 0100 6100",
        ),
        (
            {"type": "SYSTEM_REPLY", "command": "CLOSE_FILEHANDLE", "status_code": 0, "fields": {"handle": 3}},
            "06000000 03 98 00 03",
        ),
        ({"type": "DAISY_REPLY", "layer_from": 1, "layer_to": 2, "payload": b"\7"}, "06000000 08 01 02 07"),
    ],
)
def test_a_frame_is_built_from_a_mapping(values: Mapping[str, Any], expected: str) -> None:
    frame = bytes.fromhex(expected)
    assert frame_schema().build(values) == frame
    assert frame_schema().parse(frame).build() == frame
    assert_stands_in_a_struct(frame_schema(), values, frame)


@pytest.mark.parametrize(
    ("values", "reason"),
    [
        ({}, "unknown message type None: the types are DIRECT_COMMAND_REPLY, "),
        ({"type": 0x77}, "unknown message type 119"),
        (5, "expected a message or its attributes by name, not 5"),
        (
            {"type": "DIRECT_REPLY", "globals": 1},
            "a DirectReply has no attribute globals: it has counter, memory, type",
        ),
        ({"type": "DIRECT_COMMAND_REPLY", "operations": [5]}, "5 is not an operation"),
        ({"type": "DIRECT_COMMAND_REPLY", "operations": [{"name": "SOUND.TON"}]}, "did you mean SOUND.TONE"),
        ({"type": "DIRECT_COMMAND_REPLY", "operations": [{"name": "SOUND.TONE"}]}, "SOUND.TONE takes 3 values"),
        ({"type": "SYSTEM_COMMAND_REPLY"}, "the name of a system command is a text, such as LIST_FILES, not None"),
        ({"type": "SYSTEM_COMMAND_REPLY", "command": "LIST_FILE"}, "did you mean LIST_FILES"),
        ({"type": "SYSTEM_COMMAND_REPLY", "command": "LIST_FILES", "fields": {"x": 1}}, "unknown field x"),
        ({"type": "DIRECT_REPLY", "counter": -1}, "counter cannot be -1"),
    ],
)
def test_a_mapping_that_is_no_frame(values: Any, reason: str) -> None:
    with pytest.raises(BuildError) as caught:
        frame_schema().build(values)
    assert reason in str(caught.value)


@many
@given(messages())
def test_messages_stand_in_a_struct(message: ev3proto.Message) -> None:
    assert_stands_in_a_struct(frame_schema(), message, message.build())


def test_a_mapping_of_attributes_is_the_message() -> None:
    """The result of `parse`, field by field, builds the same frame."""
    message = ev3proto.parse(TONE, expect=ev3proto.DirectCommand)
    names = ("type", "counter", "global_size", "local_size", "operations")
    assert frame_schema().build({name: getattr(message, name) for name in names}) == TONE
