"""Both ways: what is built parses to the same, what is parsed builds to the same bytes, and nothing ever crashes.

These are properties: they hold for anything that `ev3proto.testing` can draw, and for every operation of every dialect.
Expected values are computed here from the protocol's description, not by the code under test.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from hypothesis import example, given, settings
from hypothesis import strategies as st
from support.cases import each
from support.effort import effort

import ev3proto
from ev3proto import (
    Argument,
    DaisyCommand,
    DecodeError,
    Decoder,
    Dialogue,
    DirectCommand,
    Fault,
    Message,
    MessageType,
    Operation,
    StreamError,
    Variable,
)
from ev3proto.tables import operations as operations_of
from ev3proto.tables.declaration import DIALECTS, Parameter, Type
from ev3proto.testing import (
    OperationValue,
    direct_commands,
    encoded_arguments,
    frames,
    messages,
    mutated_frames,
    operations,
    raw_operations,
    values_for,
)

few = settings(max_examples=effort(2, 30), database=None)
many = settings(max_examples=effort(80, 1000))

HOME = {name: dialect for dialect in reversed(DIALECTS) for name in operations_of(dialect)}
"""Every operation of every dialect, and one dialect that has it."""

DIALECTS_OF = {name: [dialect for dialect in DIALECTS if name in operations_of(dialect)] for name in HOME}

dialects = st.sampled_from(DIALECTS)


# Every operation


@each("name", sorted(HOME))
def test_values_are_parsed_as_built(name: str) -> None:
    """operation(values) -> frame -> the same names and values, in every dialect that has the operation."""
    declaration = operations_of(HOME[name])[name]

    @few
    @given(st.data())
    def check(data: st.DataObject) -> None:
        values: list[OperationValue] = [data.draw(values_for(parameter)) for parameter in declaration.parameters]
        if len(declaration.fixed) < len(declaration.parameters):
            assert isinstance(values[-1], list)
            values[-2] = len(values[-1])
        elif declaration.parameters and isinstance(declaration.parameters[-1].element, str):
            # The elements are whole numbers, for which the parameter with their type has to be a variable.
            teller = [parameter.name for parameter in declaration.parameters].index(declaration.parameters[-1].element)
            values[teller] = ev3proto.LV(0)
        expected = list(expected_arguments(declaration.parameters, values))
        for dialect in DIALECTS_OF[name]:
            built = ev3proto.operation(name, *values, dialect=dialect)
            found = only_operation(built, dialect)
            assert found.full_name == name
            assert [(it.name, it.kind, same(it.value)) for it in found.arguments] == expected
            assert found.raw == built.raw

    check()


@each("name", sorted(HOME))
def test_every_encoding_builds_the_same_bytes(name: str) -> None:
    """Arguments, CMD and counts in any encoding: the same operation, the same bytes, nothing between its arguments."""

    @few
    @given(raw_operations(HOME[name], name))
    def check(raw: bytes) -> None:
        for dialect in DIALECTS_OF[name]:
            frame = direct_frame(raw)
            message = ev3proto.parse(frame, dialect=dialect, expect=DirectCommand)
            assert [operation.full_name for operation in message.operations] == [name]
            assert message.build() == frame
            assert_tiled(message.operations, frame, 7)

    check()


@each("name", sorted(HOME))
def test_built_encodings_are_the_shortest(name: str) -> None:
    @few
    @given(operations(HOME[name], name))
    def check(operation: Operation) -> None:
        if operation.cmd is not None:
            assert operation.cmd.length == shortest_number(int(operation.cmd.value))
        for argument in operation.arguments:
            assert argument.length == shortest(argument), argument
            assert argument.encoding not in ("LCS_OLD", "LAB1")

    check()


@many
@given(st.data())
def test_an_encoded_argument_is_kept(data: st.DataObject) -> None:
    """The builder's way around the shortest encoding: bytes that are one encoded argument."""
    declaration = operations_of()["SOUND.TONE"]
    raw = [data.draw(encoded_arguments(parameter)) for parameter in declaration.parameters]
    operation = ev3proto.operation("SOUND.TONE", *raw)
    assert operation.raw == b"\x94\x01" + b"".join(raw)
    assert [argument.raw for argument in operation.arguments] == raw


def only_operation(operation: Operation, dialect: str) -> Operation:
    message = ev3proto.parse(direct_frame(operation.raw), dialect=dialect, expect=DirectCommand)
    (found,) = message.operations
    assert found.offset == 7
    return found


def direct_frame(byte_code: bytes) -> bytes:
    """A direct command without reply and memory, built by hand."""
    return struct.pack("<HHBH", 5 + len(byte_code), 42, 0x80, 0) + byte_code


def expected_arguments(
    parameters: Sequence[Parameter], values: Sequence[OperationValue]
) -> Iterator[tuple[str, str, object]]:
    """Name, kind and value of the arguments for these values."""
    for parameter, value in zip(parameters, values, strict=True):
        if isinstance(value, list):
            if parameter.counts:
                yield parameter.name, "constant", len(value)
            is_float = parameter.element is Type.DATAF
            for index, element in enumerate(value):
                yield (f"{parameter.name}[{index}]", *expected_value(parameter, element, is_float))
        else:
            yield (parameter.name, *expected_value(parameter, value, parameter.type is Type.DATAF))


def expected_value(parameter: Parameter, value: object, is_float: bool) -> tuple[str, object]:
    if isinstance(value, Variable):
        return ("global" if value.scope == "global" else "local"), value.index
    if parameter.enum is not None and isinstance(value, str) and value in parameter.enum.members:
        value = parameter.enum.members[value]
        return "constant", struct.pack("<f", value) if is_float else value
    return ("string" if isinstance(value, str) else "constant"), same(value)


def same(value: object) -> object:
    """Floats as their four bytes, because "not a number" equals nothing. All of these are the same on the wire."""
    if isinstance(value, float) and math.isnan(value):
        return b"\x00\x00\xc0\x7f"
    return struct.pack("<f", value) if isinstance(value, float) else value


def shortest(argument: Argument) -> int:
    """Bytes of the shortest encoding of an argument's value, its identification byte included."""
    if argument.is_variable:
        index, has_bits = int(argument.value), argument.form.handle or argument.form.address
        # The form of one byte has no room for the handle and address bits.
        limits = {2: 1 << 8, 3: 1 << 16, 5: 1 << 32} if has_bits else {1: 32, 2: 1 << 8, 3: 1 << 16, 5: 1 << 32}
        return next(length for length, limit in limits.items() if index < limit)
    if isinstance(argument.value, str):
        return 1 + len(argument.value) + 1
    if argument.parameter.type is Type.DATAF:
        return 1 + 4
    # Each type has one bit pattern for "not a number", in its own width.
    nan_width = {(Type.DATA8, -0x80): 1, (Type.DATA16, -0x8000): 2, (Type.HANDLE, -0x8000): 2}
    return 1 + nan_width.get((argument.parameter.type, int(argument.value)), shortest_number(int(argument.value)) - 1)


def shortest_number(value: int) -> int:
    """LC0 holds -32 to 31; the lowest number of LC1 and LC2 means "not a number" there and takes the next."""
    if -32 <= value <= 31:
        return 1
    return next(1 + width for width in (1, 2, 4) if width == 4 or abs(value) < 1 << 8 * width - 1)


def assert_tiled(found: Sequence[Operation], frame: bytes, start: int) -> None:
    """Operations are adjacent up to the end of the frame, arguments up to the end of their operation."""
    ends = [start] + [operation.offset + operation.length for operation in found]
    assert [operation.offset for operation in found] + [len(frame)] == ends
    for operation in found:
        assert operation.raw == frame[operation.offset : operation.offset + operation.length]
        pieces = ([operation.cmd] if operation.cmd else []) + list(operation.arguments)
        assert bytes((operation.opcode,)) + b"".join(piece.raw for piece in pieces) == operation.raw
        bounds = [operation.offset + 1, *(piece.offset + piece.length for piece in pieces)]
        assert [piece.offset for piece in pieces] == bounds[:-1]


# Every frame


@many
@given(dialects.flatmap(lambda dialect: st.tuples(st.just(dialect), frames(dialect))))
def test_frames_build_the_same_bytes(drawn: tuple[str, bytes]) -> None:
    dialect, frame = drawn
    message = ev3proto.parse(frame, dialect=dialect)
    assert message.build() == frame
    assert message.fault is None
    assert message.rest == b""
    assert message.length == len(frame) - 2
    assert message.counter == frame[2] | frame[3] << 8
    assert message.type == frame[4]


@many
@given(frames())
def test_operations_and_arguments_tile_the_frame(frame: bytes) -> None:
    message = ev3proto.parse(frame)
    if isinstance(message, DirectCommand):
        assert_tiled(message.operations, frame, 7)
    elif isinstance(message, DaisyCommand) and message.operations:
        assert_tiled(message.operations, frame, 8)


# Every sequence of bytes

headers = st.builds(
    lambda counter, code, body: struct.pack("<HHB", 3 + len(body), counter, code) + body,
    st.integers(0, 0xFFFF),
    st.sampled_from((0x00, 0x80, 0x01, 0x81, 0x02, 0x04, 0x03, 0x05, 0x0A, 0x8A, 0x08, 0x09)),
    st.binary(max_size=40),
)
"""A correct length, counter and type, followed by anything."""

garbage = st.one_of(st.binary(max_size=40), headers, mutated_frames())


@many
@given(garbage)
@example(b"")
@example(b"\x03\x00\x00\x00\x00\xff")
@example(b"\x03\x00\x00\x00\x00\xff\xff")
@example(b"\x04\x00\x00\x00\x00\xff")
@example(b"\x06\x00\x00\x00\x00\x00\x00")
@example(b"\x03\x00\x00\x00\x01\xf6\x00")
@example(b"\x04\x00\x00\x00\x03\x99")
@example(b"\x00\x00\x00\x00\x00")
@example(b"\xff\xff\x00\x00\x77")
@example(b"\x03\x04\x00\x00\x00" + bytes(1024))
@example(bytes(70000))
def test_lenient_parsing_accepts_any_bytes(frame: bytes) -> None:
    message = ev3proto.parse(frame, strict=False)
    assert message.build() == frame
    if message.fault is not None:
        assert_sensible(message.fault, frame)
    if isinstance(message, DirectCommand | DaisyCommand):
        for operation in message.operations:
            assert all(
                frame[argument.offset : argument.offset + argument.length] == argument.raw
                for argument in operation.arguments
            )
            assert repr(operation)


@many
@given(garbage)
@example(b"")
@example(bytes(70000))
def test_strict_parsing_raises_decode_errors_only(frame: bytes) -> None:
    lenient = ev3proto.parse(frame, strict=False)
    try:
        message = ev3proto.parse(frame)
    except DecodeError as error:
        assert_sensible(error.fault, frame)
        assert lenient.fault is not None
    else:
        assert lenient.fault is None
        assert lenient == message
        assert message.build() == frame


def assert_sensible(fault: Fault, frame: bytes) -> None:
    assert 0 <= fault.offset <= len(frame)
    assert fault.reason
    assert str(fault).startswith(f"offset {fault.offset}: ")


# Streams and dialogues


@st.composite
def chunked(draw: st.DrawFn, stream: bytes) -> list[bytes]:
    """The same bytes in any chunks, empty ones too."""
    cuts = sorted(draw(st.lists(st.integers(0, len(stream)), max_size=8)))
    return [stream[start:end] for start, end in pairwise([0, *cuts, len(stream)])]


@many
@given(st.data())
def test_any_chunking_gives_the_same_messages(data: st.DataObject) -> None:
    sent = data.draw(st.lists(frames(), max_size=4))
    decoder = Decoder()
    got = [message for chunk in data.draw(chunked(b"".join(sent))) for message in decoder.feed(chunk)]
    assert got == [ev3proto.parse(frame) for frame in sent]
    assert decoder.close() is None
    assert decoder.position == sum(map(len, sent))


@many
@given(st.lists(garbage, max_size=4).map(b"".join).flatmap(chunked), st.booleans())
def test_a_stream_of_garbage_raises_decode_errors_only(chunks: list[bytes], strict: bool) -> None:
    decoder = Decoder(strict=strict)
    stream = b"".join(chunks)
    got: list[bytes] = []
    errors: list[DecodeError] = []
    for chunk in chunks:
        try:
            # One by one: a list would lose those before an error.
            for message in decoder.feed(chunk):
                got.append(message.build())
                assert stream[: decoder.position].endswith(got[-1])
        except DecodeError as error:
            errors.append(error)
    assert strict or all(isinstance(error, StreamError) for error in errors)
    assert all(error.reason and 0 <= error.offset <= len(stream) for error in errors)
    assert stream[decoder.position :].startswith(decoder.pending)
    if not strict:
        polls = decoder.position - sum(map(len, got))
        assert polls % 2 == 0
        assert stream[: decoder.position].count(0) >= polls + b"".join(got).count(0)


@many
@given(st.lists(messages() | garbage.map(lambda frame: ev3proto.parse(frame, strict=False)), max_size=8))
def test_a_dialogue_accepts_any_messages(found: list[Message]) -> None:
    dialogue = Dialogue()
    for message in found:
        assert isinstance(dialogue.feed(message), list)
    assert all(message.wants_reply for message in dialogue.unanswered)


@many
@given(direct_commands(), st.data())
def test_a_reply_of_any_memory_can_be_read(command: DirectCommand, data: st.DataObject) -> None:
    """Values never extend beyond the memory in the reply, whatever length the command gives."""
    dialogue = Dialogue()
    dialogue.feed(replace(command, type=MessageType.DIRECT_COMMAND_REPLY, counter=7))
    memory = data.draw(st.binary(min_size=command.global_size, max_size=command.global_size))
    if len(memory) > 1019:
        return
    for value in dialogue.feed(ev3proto.direct_reply(memory, counter=7)):
        assert 5 <= value.offset <= value.offset + value.length <= 5 + len(memory)
