"""Messages of streams and captures, whose operations are made when somebody first asks for them.

Nobody can tell them from those that `ev3proto.parse` gives. What says beforehand that nothing is wrong with their byte
code only passes over it; it must never say so of byte code in which there is a fault.
"""

from __future__ import annotations

import copy
import dataclasses
import pickle

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from support.effort import effort

import ev3proto
from ev3proto import Decoder, DirectCommand, Message
from ev3proto.schema.frame import frame_schema
from ev3proto.schema.instructions import InstructionSet, instruction_set
from ev3proto.tables.declaration import DIALECTS
from ev3proto.testing import frames, mutated_frames, operations, raw_operations

many = settings(max_examples=effort(120, 2000), database=None)

dialects = st.sampled_from(DIALECTS)

TONE = bytes.fromhex("0e002a0080000094010182b80182e803")
"""SOUND TONE at volume 1, 440 Hz, 1000 ms."""

MOST_IN_A_BYTE = 31
"""The largest constant that is one byte."""


def read(frame: bytes) -> DirectCommand:
    """A direct command as a stream gives it."""
    (message,) = Decoder().feed(frame)
    assert isinstance(message, DirectCommand)
    return message


def looked_at(message: Message) -> Message:
    """The message after somebody asked for its operations."""
    assert not isinstance(message, DirectCommand) or isinstance(message.operations, tuple)
    return message


@many
@given(dialects.flatmap(lambda dialect: st.tuples(st.just(dialect), frames(dialect) | mutated_frames(dialect))))
@example(("official", TONE))
@example(("official", TONE[:-1]))
@example(("official", b"\x05\0\0\0\x80\0\0"))  # a command of no operations
def test_they_are_the_messages_that_parsing_gives(drawn: tuple[str, bytes]) -> None:
    dialect, frame = drawn
    parsed = ev3proto.parse(frame, strict=False, dialect=dialect)
    later = frame_schema(dialect).read_for_later(frame, strict=False)
    assert (later.fault, later.type, later.counter, later.flaw) == (
        parsed.fault,
        parsed.type,
        parsed.counter,
        parsed.flaw,
    )
    assert later.build() == frame
    assert looked_at(later) == parsed
    assert repr(later) == repr(parsed)
    assert [one.arguments for one in getattr(later, "operations", ())] == [
        one.arguments for one in getattr(parsed, "operations", ())
    ]


@many
@given(dialects.flatmap(lambda dialect: st.tuples(st.just(dialect), st.binary(max_size=24) | raw_operations(dialect))))
@example(("official", bytes.fromhex("94 01 01 82 B8 01 82 E8")))  # the last argument is cut
@example(("official", bytes.fromhex("94 01 01 82 B8 01 A8")))  # no such identification byte
@example(("official", bytes.fromhex("94 1F 01 01 01")))  # no such CMD
@example(("official", bytes.fromhex("FF")))  # no such opcode
@example(("official", bytes.fromhex("C2 09 84 61")))  # the zero after the string is missing
@example(("official", bytes.fromhex("9E 00 00 00 00 02 02 60")))  # one of two values
def test_what_counts_as_flawless_has_no_fault(drawn: tuple[str, bytes]) -> None:
    dialect, code = drawn
    instructions = instruction_set(dialect)
    found, fault = instructions.scan(code, 0, len(code))
    assert instructions.is_flawless(code, 0, len(code)) == (fault is None)
    if fault is None:
        assert instructions.operations(code, 0) == tuple(found)


def test_opcodes_are_known_when_they_are_first_met() -> None:
    instructions = InstructionSet("official")
    fine, cut = bytes.fromhex("94 01 01 82 B8 01 82 E8 03") * 3, bytes.fromhex("94 01 01 82 B8 01 82")
    for _ in range(2):
        assert not instructions.is_usual(cut, 0, len(cut))
        assert not instructions.is_flawless(cut, 0, len(cut))
        assert instructions.is_usual(fine, 0, len(fine))
        assert instructions.is_flawless(fine, 0, len(fine))


@pytest.mark.parametrize(
    ("code", "end", "is_usual"),
    [
        ("94 01 01 82 B8 01 82 E8 03", 9, True),
        ("94 01 01 82 B8 01 82 E8 03", 8, False),  # the operation goes on, but not here
        ("01 94 01 01 82 B8 01 82 E8", 9, False),  # one that is whole, and one that is cut
        ("01 01 94 81 01 01 82 B8 01 82 E8 03", 12, False),  # a CMD that is longer than it need be
        ("7D 01 84 61 00 60", 6, True),
        ("7D 01 84 61 00 60", 4, False),  # the zero after the string is behind the end
        ("9E 00 00 00 00 00 02 60 64", 9, True),  # two values
        ("9E 00 00 00 00 00 02 60", 8, False),
        ("9E 00 00 00 00 00 81 02 60 64", 10, False),  # a counter that is longer than it need be
        ("9E 00 00 00 00 00 40 60 64", 9, False),  # a variable counts nothing
        ("01 FF", 2, False),  # no such opcode
        ("01 94 1F", 3, False),  # no such CMD
        ("01 94", 2, False),  # no CMD at all
        ("01", 1, True),
        ("", 0, True),
    ],
)
def test_what_is_usual_is_passed_over(code: str, end: int, is_usual: bool) -> None:
    instructions = InstructionSet("official")
    for _ in range(2):  # opcodes are not known before they are met
        assert instructions.is_usual(bytes.fromhex(code), 0, end) == is_usual


@many
@given(dialects.flatmap(lambda dialect: st.tuples(st.just(dialect), operations(dialect))))
def test_every_operation_is_usual_in_its_shortest_encoding(drawn: tuple[str, ev3proto.Operation]) -> None:
    dialect, operation = drawn
    elements = [one for one in operation.arguments if one.name.endswith("]")]
    is_usual = len(elements) <= MOST_IN_A_BYTE and (operation.cmd is None or operation.cmd.length == 1)
    assert instruction_set(dialect).is_usual(operation.raw, 0, operation.length) == is_usual


@many
@given(dialects.flatmap(lambda dialect: st.tuples(st.just(dialect), frames(dialect) | mutated_frames(dialect))))
def test_a_frame_among_other_bytes_is_flawless_where_parsing_it_raises_nothing(drawn: tuple[str, bytes]) -> None:
    dialect, frame = drawn
    fault = ev3proto.parse(frame, strict=False, dialect=dialect).fault
    assert frame_schema(dialect).is_flawless(b"before" + frame + b"after", 6, 6 + len(frame)) == (fault is None)


def test_nobody_can_change_them() -> None:
    command = read(TONE)
    with pytest.raises(dataclasses.FrozenInstanceError, match="cannot assign to field 'operations'"):
        command.operations = ()  # type: ignore[misc]
    with pytest.raises(dataclasses.FrozenInstanceError, match="cannot delete field 'operations'"):
        del command.operations
    assert command.operations is command.operations
    assert [operation.full_name for operation in command.operations] == ["SOUND.TONE"]


def test_copies_pickles_and_changed_copies_have_them() -> None:
    for made in (copy.copy, copy.deepcopy, lambda command: pickle.loads(pickle.dumps(command)), dataclasses.replace):
        command = made(read(TONE))
        assert command == ev3proto.parse(TONE)
        assert hash(command) == hash(ev3proto.parse(TONE))
        assert command.build() == TONE
    louder = dataclasses.replace(read(TONE), counter=43)
    assert louder.build().hex() == "0e002b0080000094010182b80182e803"


def test_they_are_shown_as_others_are() -> None:
    assert repr(read(TONE)) == (
        "DirectCommand(DIRECT_COMMAND_NO_REPLY, counter=42, operations=(<SOUND.TONE(VOLUME=1, FREQUENCY=440,"
        " DURATION=1000) at 7>,))"
    )
