"""The declaration in Construct: what it parses and builds, and that the readers agree with it.

They agree if they find the same values, build the same bytes, and refuse the same frames, at the same offset.
"""

from __future__ import annotations

import copy
import io
import pickle
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest
from construct import (
    Bytes,
    Construct,
    ConstructError,
    GreedyBytes,
    GreedyRange,
    Select,
    SizeofError,
    Struct,
    Terminated,
)
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy
from support.cases import each
from support.effort import effort

import ev3proto
from ev3proto import GV, BuildError, DecodeError, schema
from ev3proto.schema import FRAME, OPERATIONS, declared
from ev3proto.schema.wire_format import ENCODED, IDENTIFICATION, MEMORY, SENSOR_REPORT
from ev3proto.tables import operations as operations_of
from ev3proto.tables.declaration import DIALECTS
from ev3proto.tables.encoding import CONSTANT, ENCODINGS, GLOBAL, JUMP, LOCAL, SHORT, TEXT
from ev3proto.testing import (
    daisy_messages,
    frames,
    mutated_frames,
    raw_operations,
    system_commands,
    system_replies,
    values_for,
)

few = settings(max_examples=effort(1, 20), database=None)
some = settings(max_examples=effort(30, 1000), database=None)

HOME = {name: dialect for dialect in reversed(DIALECTS) for name in operations_of(dialect)}
"""Every operation of every dialect, and one dialect that has it."""

TONE = bytes.fromhex("0e002a0080000094010182b80182e803")
TONE_VALUES = {"VOLUME": 1, "FREQUENCY": 440, "DURATION": 1000}


def test_the_arguments_of_an_operation() -> None:
    raw = bytes.fromhex("01 82B801 82E803")
    assert OPERATIONS["SOUND.TONE"].build(TONE_VALUES) == raw
    found = OPERATIONS["SOUND.TONE"].parse(raw)
    assert [found[name].value for name in TONE_VALUES] == [1, 440, 1000]
    found.FREQUENCY = 880
    assert OPERATIONS["SOUND.TONE"].build(found) == bytes.fromhex("01 827003 82E803")


def test_a_frame() -> None:
    found = FRAME.parse(TONE)
    assert (found.counter, found.type, int(found.type)) == (42, "DIRECT_COMMAND_NO_REPLY", 0x80)
    (operation,) = found.body.operations
    assert (operation.opcode, operation.cmd.value, operation.offset) == ("SOUND", 1, 7)
    assert (operation.arguments.DURATION.value, operation.arguments.DURATION.offset) == (1000, 13)
    assert FRAME.build(found) == TONE


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        (
            {
                "type": "DIRECT_COMMAND_NO_REPLY",
                "counter": 42,
                "body": {"operations": [{"opcode": "SOUND", "cmd": "TONE", "arguments": TONE_VALUES}]},
            },
            TONE.hex(),
        ),
        (
            {
                "type": 0x80,
                "counter": 42,
                "body": {"memory": {}, "operations": [{"opcode": 0x94, "cmd": 1, "arguments": TONE_VALUES}]},
            },
            TONE.hex(),
        ),
        (
            {
                "type": ev3proto.MessageType.DIRECT_COMMAND_REPLY,
                "body": {"memory": {"globals": 1, "locals": 2}, "operations": [{"opcode": "NOP"}]},
            },
            "06000000 00 0108 01",
        ),
        ({"type": "DIRECT_REPLY", "counter": 42, "body": {"memory": b"\1\2"}}, "05002a00 02 0102"),
        (
            {
                "type": "SYSTEM_COMMAND_REPLY",
                "body": {"command": "LIST_FILES", "fields": {"max_bytes": 1, "path": "a"}},
            },
            "08000000 01 99 0100 6100",
        ),
        (
            {"type": "SYSTEM_COMMAND_REPLY", "body": {"command": 0xF1, "fields": {"address": 1, "image_size": 2}}},
            "0c000000 01 f1 01000000 02000000",
        ),
        (
            {
                "type": "SYSTEM_COMMAND_NO_REPLY",
                "body": {"command": "WRITEMAILBOX", "fields": {"name": "ab", "payload": "hi"}},
            },
            "0d000000 81 9e 03 616200 0300 686900",
        ),
        (
            {
                "type": "SYSTEM_COMMAND_NO_REPLY",
                "body": {"command": "WRITEMAILBOX", "fields": {"name_length": 2, "name": "ab", "payload": True}},
            },
            "0b000000 81 9e 02 616200 0100 01",
        ),
        ({"type": "SYSTEM_COMMAND_REPLY", "body": {"command": "GET_VERSION"}}, "04000000 01 f6"),
        (
            {"type": "SYSTEM_REPLY", "body": {"command": "CLOSE_FILEHANDLE", "fields": {"handle": 3}}},
            "06000000 03 98 00 03",
        ),
        (
            {"type": "SYSTEM_REPLY", "body": {"command": "BEGIN_UPLOAD", "status": "UNKNOWN_HANDLE"}},
            "05000000 03 94 01",
        ),
        (
            {
                "type": "DAISY_COMMAND_REPLY",
                "body": {"command": "DOWNSTREAM", "layer_from": 1, "layer_to": 2, "payload": [{"opcode": "NOP"}]},
            },
            "07000000 0a a0 01 02 01",
        ),
        (
            {
                "type": "DAISY_COMMAND_REPLY",
                "body": {"command": 0xA2, "layer_from": 1, "layer_to": 2, "payload": b"\7"},
            },
            "07000000 0a a2 01 02 07",
        ),
        ({"type": "DAISY_REPLY", "body": {"layer_from": 1, "layer_to": 2, "payload": b"\7"}}, "06000000 08 01 02 07"),
    ],
)
def test_a_frame_is_built_from_plain_values(values: Mapping[str, Any], expected: str) -> None:
    frame = bytes.fromhex(expected)
    assert FRAME.build(values) == frame
    assert FRAME.build(FRAME.parse(frame)) == frame
    assert ev3proto.parse(frame).build() == frame


def test_lists_are_counted() -> None:
    call = OPERATIONS["CALL"]
    assert call.build({"OBJID": 3, "PARAMETERS": [1, GV(2)]}) == bytes.fromhex("03 02 01 62")
    found = call.parse(bytes.fromhex("03 8102 01 62"))
    assert (found.PARAMETERS_COUNT.value, [element.value for element in found.PARAMETERS]) == (2, [1, 2])
    assert call.build(found) == bytes.fromhex("03 8102 01 62")
    some_bytes = {"DESTINATION": GV(0), "SOURCE": [1, 2]}
    assert OPERATIONS["INIT_BYTES"].build(some_bytes) == bytes.fromhex("60 02 01 02")
    assert OPERATIONS["INIT_BYTES"].build({**some_bytes, "LENGTH": b"\x81\x02"}) == bytes.fromhex("60 8102 01 02")


@pytest.mark.parametrize(
    ("name", "values", "reason"),
    [
        ("SOUND.TONE", {**TONE_VALUES, "VOLUME": 300}, "VOLUME cannot be 300"),
        ("SOUND.TONE", {**TONE_VALUES, "VOLUME": "loud"}, "VOLUME takes a number"),
        ("CALL", {"OBJID": 1, "PARAMETERS_COUNT": GV(0), "PARAMETERS": []}, "PARAMETERS must be a constant"),
        ("CALL", {"OBJID": 1, "PARAMETERS_COUNT": 3, "PARAMETERS": [1]}, "expected 3 elements, found 1"),
    ],
)
def test_values_that_do_not_fit(name: str, values: Mapping[str, Any], reason: str) -> None:
    with pytest.raises(ConstructError, match=reason) as caught:
        OPERATIONS[name].build(values)
    if "VOLUME" in reason:
        assert caught.value.path == "(building) -> SOUND.TONE -> VOLUME"


@pytest.mark.parametrize(
    "operation",
    [{"opcode": "SOUND", "cmd": 23}, {"opcode": 0xFE}, {"opcode": "SOUND"}, {"opcode": "SOUND", "cmd": GV(0)}],
)
def test_unknown_operations_are_not_built(operation: Mapping[str, Any]) -> None:
    with pytest.raises(BuildError):
        FRAME.build({"type": "DIRECT_COMMAND_REPLY", "body": {"operations": [operation]}})


@pytest.mark.parametrize(
    ("body", "offset", "path"),
    [
        ("94 01 01 82B801 82E8", 13, "SOUND.TONE -> DURATION"),  # cut off in the value
        ("94 01 01 82B801", 13, "SOUND.TONE -> DURATION"),  # missing
        ("94 01 01 85 01", 10, "SOUND.TONE -> FREQUENCY"),  # undefined
        ("94 02 01 8461", 10, "SOUND.PLAY -> NAME"),  # a text without its end
        ("94 17", 8, "SOUND -> CMD"),
        ("94", 8, "SOUND -> CMD"),
        ("94 40", 8, "SOUND -> CMD"),  # a variable selects nothing
        ("2F 40 7F 01", 9, "INIT_BYTES -> LENGTH"),
        ("2F 40 8303000000 01", 9, "INIT_BYTES -> LENGTH"),  # three values, but one byte
        ("2F 40 02 01 85", 11, "INIT_BYTES -> SOURCE"),
        ("01 01 FE", 9, "(parsing)"),
    ],
)
def test_a_fault_has_offset_and_path(body: str, offset: int, path: str) -> None:
    contents = bytes.fromhex("2a00 80 0000") + bytes.fromhex(body)
    frame = len(contents).to_bytes(2, "little") + contents
    with pytest.raises(DecodeError) as ours:
        ev3proto.parse(frame)
    with pytest.raises(DecodeError) as caught:
        FRAME.parse(frame)
    error = caught.value
    assert error.offset == ours.value.offset == offset
    assert error.path.endswith(path)
    assert str(error).startswith(f"Error in path {error.path}\noffset {offset}: ")
    for copied in (copy.copy(error), pickle.loads(pickle.dumps(error))):
        assert (copied.fault, copied.path, str(copied)) == (error.fault, error.path, str(error))


def test_a_frame_in_other_structures() -> None:
    log: Any = GreedyRange(Struct("time" / Bytes(4), "frame" / FRAME))
    data = (bytes(4) + TONE) * 2
    found = log.parse(data)
    assert [entry.frame.body.operations[0].offset for entry in found] == [11, 31]  # in the log
    assert log.build(found) == data
    # What is faulty is left to the alternatives.
    lenient: Any = Select(FRAME, GreedyBytes)
    assert lenient.parse(TONE[:-1]) == TONE[:-1]
    faulty = bytes.fromhex("06002a00800000FE")
    assert lenient.parse(faulty) == faulty


@pytest.mark.parametrize(
    ("part", "value", "data"),
    [
        (MEMORY, {"globals": 1021, "locals": 2}, "FD 0B"),
        (MEMORY, {"locals": 63, "globals": 1023}, "FF FF"),
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
def test_parts(part: Any, value: Mapping[str, Any], data: str) -> None:
    raw = bytes.fromhex(data)
    assert part.build(value) == raw
    assert part.build(part.parse(raw)) == raw


def test_every_identification_byte() -> None:
    """The bits, as Construct declares them, mean what the rows of the tables say."""
    assert (IDENTIFICATION.sizeof(), MEMORY.sizeof()) == (1, 2)
    for byte, encoding in enumerate(ENCODINGS):
        data = bytes((byte, 1, 2, 3, 0))
        parsed = ENCODED.parse(data)
        assert IDENTIFICATION.build(IDENTIFICATION.parse(data[:1])) == data[:1]
        if encoding is None:
            assert "rest" in parsed, hex(byte)
            continue
        is_long, is_variable, form = (parsed.identification[name] for name in ("is_long", "is_variable", "form"))
        kind = CONSTANT
        if is_variable:
            kind = GLOBAL if (form.selector if is_long else form.is_global) else LOCAL
        elif is_long and form.selector:
            kind = JUMP
        elif isinstance(parsed.value, str):
            kind = TEXT
        size = len(ENCODED.build(parsed))
        assert (encoding.kind, encoding.width) == (kind, None if kind == TEXT else size - 1), hex(byte)
        assert (encoding.handle, encoding.address) == ((form.handle, form.address) if is_long else (False, False))
        assert is_long or SHORT[byte] == (encoding, parsed.value)
        names = {CONSTANT: f"LC{size - 1}", LOCAL: f"LV{size - 1}", GLOBAL: f"GV{size - 1}", JUMP: "LAB1"}
        assert encoding.name == names.get(kind) or (encoding.name, byte & 7) in (("LCS_OLD", 0), ("LCS", 4))


def test_every_bit_of_a_float_is_kept() -> None:
    """Also of a signalling "not a number", which a float of Python's loses."""
    for bits in ("0100807F", "FFFFFFFF", "0000807F", "0000C07F", "0000803F", "01000000"):
        raw = bytes.fromhex("83" + bits + "40")
        assert OPERATIONS["MOVEF_F"].build(OPERATIONS["MOVEF_F"].parse(raw)) == raw


def test_the_public_names() -> None:
    assert declared() is declared("official")
    assert declared("official") == (FRAME, OPERATIONS)
    assert declared("xtended").OPERATIONS.keys() == operations_of("xtended").keys()
    with pytest.raises(ValueError, match="dialect must be one of"):
        declared("nxt")
    with pytest.raises(AttributeError, match="no attribute 'FRAMES'"):
        schema.FRAMES  # noqa: B018


def _add_nodes(node: Construct, found: dict[int, Construct]) -> None:
    """Collects all Constructs that a Construct consists of."""
    if id(node) not in found:
        found[id(node)] = node
        for value in vars(node).values():
            inner = value.values() if isinstance(value, Mapping) else value if isinstance(value, list) else [value]
            for part in inner:
                if isinstance(part, Construct):
                    _add_nodes(part, found)


@pytest.mark.parametrize("dialect", DIALECTS)
def test_it_consists_of_constructs_own_classes(dialect: str) -> None:
    found: dict[int, Construct] = {}
    _add_nodes(declared(dialect).FRAME, found)
    assert {type(node).__module__ for node in found.values()} == {"construct.core"}
    assert {id(node) for node in declared(dialect).OPERATIONS.values()} <= found.keys()


# Agreement with the readers

Operation = tuple[str, int, list[tuple[str, int, str]]]
"""Opcode with CMD, offset, and name, offset and value of each argument; "not a number" equals itself as a text."""


def _declared_arguments(found: Mapping[str, Any]) -> Iterator[tuple[str, int, str]]:
    for name, argument in _public(found).items():
        if isinstance(argument, list):
            for number, element in enumerate(argument):
                yield f"{name}[{number}]", element.offset, repr(element.value)
        else:
            yield name.removesuffix("_COUNT"), argument.offset, repr(argument.value)


def _declared_operation(found: Any) -> Operation:
    opcode = str(found.opcode) if found.cmd is None else f"{found.opcode} {found.cmd.value}"
    return opcode, found.offset, list(_declared_arguments(found.arguments))


def _read_operation(found: ev3proto.Operation) -> Operation:
    opcode = found.name if found.cmd is None else f"{found.name} {found.cmd.value}"
    return opcode, found.offset, [(one.name, one.offset, repr(one.value)) for one in found.arguments]


def _public(found: Mapping[str, Any]) -> dict[str, Any]:
    """Returns the fields of a Container without its stream."""
    return {name: value for name, value in found.items() if not name.startswith("_")}


def assert_same_values(found: Any, message: ev3proto.Message) -> None:
    body = found.body
    assert (int(found.type), found.counter) == (message.type, message.counter)
    match message:
        case ev3proto.DirectCommand():
            assert (body.memory.globals, body.memory.locals) == (message.global_size, message.local_size)
            assert list(map(_declared_operation, body.operations)) == list(map(_read_operation, message.operations))
        case ev3proto.DirectReply():
            assert body.memory == message.memory
        case ev3proto.SystemCommand():
            assert (int(body.command), _public(body.fields)) == (message.number, message.fields)
        case ev3proto.SystemReply():
            assert (int(body.command), int(body.status)) == (message.number, message.status_code)
            assert _public(body.fields) == message.fields
        case ev3proto.DaisyCommand():
            assert (int(body.command), body.layer_from) == (message.number, message.layer_from)
            if isinstance(body.payload, list):
                assert list(map(_declared_operation, body.payload)) == list(map(_read_operation, message.operations))
            else:
                assert (body.payload, message.operations) == (message.payload, ())
        case ev3proto.DaisyReply():
            assert (body.layer_from, body.layer_to) == (message.layer_from, message.layer_to)
            if message.report is None:
                assert body.payload == message.payload
            else:
                assert ev3proto.SensorReport(**_public(body.payload)) == message.report
        case _:
            raise AssertionError(message)


WHOLE = {dialect: Struct("frame" / declared(dialect).FRAME, Terminated) for dialect in DIALECTS}
"""A frame with nothing after it."""


def assert_agreement(frame: bytes, dialect: str) -> None:
    message = ev3proto.parse(frame, dialect=dialect, strict=False)
    if message.fault is not None:
        with pytest.raises(ConstructError) as caught:
            WHOLE[dialect].parse(frame)
        if isinstance(caught.value, DecodeError) and message.stated_length is None:
            assert caught.value.offset == message.fault.offset
        return
    found = WHOLE[dialect].parse(frame)
    assert_same_values(found.frame, message)
    assert WHOLE[dialect].build(found) == frame


@pytest.mark.parametrize("dialect", DIALECTS)
@pytest.mark.parametrize("drawn", [frames, mutated_frames])
def test_agreement_on_frames(drawn: Any, dialect: str) -> None:
    @some
    @given(drawn(dialect))
    def check(frame: bytes) -> None:
        assert_agreement(frame, dialect)

    check()


@pytest.mark.parametrize("drawn", [system_commands(), system_replies(), daisy_messages()], ids=str)
def test_agreement_on_system_and_daisy_messages(drawn: SearchStrategy[ev3proto.Message]) -> None:
    @some
    @given(drawn, st.integers(0, 8), st.binary(max_size=2))
    def check(message: ev3proto.Message, cut: int, more: bytes) -> None:
        frame = message.build()
        assert_agreement(frame, "official")
        contents = frame[2 : max(5, len(frame) - cut)] + more
        assert_agreement(len(contents).to_bytes(2, "little") + contents, "official")

    check()


def test_what_compiles() -> None:
    """As docs/construct.md says: operations without a list at their end."""
    refused = set()
    for name, arguments in OPERATIONS.items():
        try:
            arguments.compile()
        except SyntaxError:
            refused.add(name)
    assert refused == {name for name, entry in operations_of().items() if entry.tail is not None}
    assert {"INPUT_READEXT", "ARRAY.INIT8"} <= refused
    assert len(refused) == 12
    with pytest.raises(SyntaxError):
        FRAME.compile()
    compiled, raw = OPERATIONS["SOUND.TONE"].compile(), bytes.fromhex("0182b80182e803")
    assert compiled.parse(raw) == OPERATIONS["SOUND.TONE"].parse(raw)
    assert compiled.build({"VOLUME": 1, "FREQUENCY": 440, "DURATION": 1000}) == raw


def test_streams_files_and_sizes(tmp_path: Path) -> None:
    found = FRAME.parse_stream(io.BytesIO(TONE + b"more"))
    FRAME.build_file(found, tmp_path / "frame")
    assert FRAME.parse_file(tmp_path / "frame") == found
    assert (tmp_path / "frame").read_bytes() == TONE
    assert OPERATIONS["NOP"].sizeof() == 0
    for varying in (FRAME, OPERATIONS["SOUND.TONE"]):
        with pytest.raises(SizeofError):
            varying.sizeof()


@each("name", sorted(HOME))
def test_agreement_on_each_operation(name: str) -> None:
    """Every encoding and each cut; and the bytes of plain values."""
    dialect, parameters = HOME[name], operations_of(HOME[name])[name].parameters
    arguments = declared(dialect).OPERATIONS[name]

    @few
    @given(raw_operations(dialect, name), st.tuples(*map(values_for, parameters)), st.data())
    def check(raw: bytes, drawn: tuple[Any, ...], data: st.DataObject) -> None:
        for code in (raw, raw[: data.draw(st.integers(1, len(raw)))]):
            contents = bytes.fromhex("2a00 80 0000") + code
            assert_agreement(len(contents).to_bytes(2, "little") + contents, dialect)
        values = {parameter.name: value for parameter, value in zip(parameters, drawn, strict=True)}
        if parameters and parameters[-1].is_list and not parameters[-1].counts:
            del values[parameters[-2].name]
        try:
            operation = ev3proto.operation(name, dialect=dialect, **values)
        except BuildError:  # another value gives the type of the elements of a list
            return
        head = 1 if operation.cmd is None else 1 + operation.cmd.length
        assert arguments.build(values) == operation.raw[head:]

    check()


@pytest.mark.parametrize(("size", "is_possible"), [(1023, True), (1024, True), (1025, False)])
def test_a_frame_has_as_many_bytes_for_both(size: int, is_possible: bool) -> None:
    """A direct reply has at most 1,024 bytes; the data of a download may be longer."""
    contents = bytes.fromhex("2A00 02") + bytes(size - 5)
    frame = len(contents).to_bytes(2, "little") + contents
    assert (ev3proto.parse(frame, strict=False).fault is None) is is_possible
    if is_possible:
        assert FRAME.build(FRAME.parse(frame)) == frame
    else:
        with pytest.raises(ConstructError):
            FRAME.parse(frame)
    download = len(contents).to_bytes(2, "little") + bytes.fromhex("2A00 01 93 00") + bytes(size - 7)
    assert ev3proto.parse(download).build() == download
    assert FRAME.build(FRAME.parse(download)) == download
