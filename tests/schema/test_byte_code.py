"""Byte code, operation by operation: what is read of it, where it is at fault, and what is kept up to there."""

from __future__ import annotations

import copy
import dataclasses
import pickle
import subprocess
import sys

import pytest

import ev3proto
from ev3proto import Decoder, DirectCommand
from ev3proto.schema.instructions import instruction_set

TONE = bytes.fromhex("0e002a0080000094010182b80182e803")
"""SOUND TONE at volume 1, 440 Hz, 1000 ms."""

WHOLE_TONE = "<SOUND.TONE(VOLUME=1, FREQUENCY=440, DURATION=1000) at 0>"
CUT_TONE = "<SOUND.TONE(VOLUME=1, FREQUENCY=440) at 0>"
READ = "INPUT_READEXT(LAYER=0, NO=0, TYPE=0, MODE=0, FORMAT=0, "


def scanned(code: str, end: int | None = None) -> tuple[list[ev3proto.Operation], ev3proto.DecodeError | None]:
    data = bytes.fromhex(code)
    return instruction_set().scan(data, 0, len(data) if end is None else end)


@pytest.mark.parametrize(
    ("code", "expected"),
    [
        ("", ""),
        ("01", "<NOP() at 0>"),
        ("94 01 01 82 B8 01 82 E8 03", WHOLE_TONE),
        ("94 81 01 01 82 B8 01 82 E8 03", WHOLE_TONE),  # a CMD that is longer than it need be
        ("01 94 83 01 00 00 00 01 82 B8 01 82 E8 03", f"<NOP() at 0> {WHOLE_TONE.replace('at 0', 'at 1')}"),
        ("7D 01 84 61 00 60", "<STRINGS.GET_SIZE(SOURCE1='a', SIZE=GV(0)) at 0>"),
        ("9E 00 00 00 00 00 02 60 64", f"<{READ}VALUES=2, VALUES[0]=GV(0), VALUES[1]=GV(4)) at 0>"),
        ("9E 00 00 00 00 00 81 02 60 64", f"<{READ}VALUES=2, VALUES[0]=GV(0), VALUES[1]=GV(4)) at 0>"),
        ("9E 00 00 00 00 00 00 01", f"<{READ}VALUES=0) at 0> <NOP() at 7>"),
    ],
)
def test_operations_without_a_fault(code: str, expected: str) -> None:
    operations, fault = scanned(code)
    assert fault is None
    assert " ".join(map(repr, operations)) == expected
    assert all(operation.is_complete for operation in operations)
    assert b"".join(operation.raw for operation in operations) == bytes.fromhex(code)


@pytest.mark.parametrize(
    ("code", "end", "expected", "fault"),
    [
        ("94 01 01 82 B8 01 82 E8 03", 8, CUT_TONE, (6, True)),  # the operation goes on, but not here
        ("94 01 01 82 B8 01 82 E8", 8, CUT_TONE, (6, True)),
        ("94 01 01 82 B8 01", 6, CUT_TONE, (6, True)),
        ("94 01 01 01 01", 3, "<SOUND.TONE(VOLUME=1) at 0>", (3, True)),
        ("94 01 01 82 B8 01 A8", 7, CUT_TONE, (6, True)),  # a label has a byte after the first
        ("94 01 01 82 B8 01 85", 7, CUT_TONE, (6, False)),  # no such identification byte
        ("94", 1, "", (1, True)),  # no CMD at all
        ("94 81", 2, "", (1, True)),
        ("94 1F 01 01 01", 5, "", (1, False)),  # no such CMD
        ("94 60 01 01 01", 5, "", (1, False)),  # a variable says nothing
        ("94 84 31 00", 4, "", (1, False)),
        ("A0", 1, "", (0, False)),  # no such opcode
        ("01 A0", 2, "<NOP() at 0>", (1, False)),
        ("7D 01 84 61 00 60", 4, "<STRINGS.GET_SIZE() at 0>", (2, True)),  # the zero after the string is behind the end
        ("C2 09 84 61", 4, "<ARRAY_WRITE(HANDLE=9) at 0>", (2, True)),
        ("9E 00 00 00 00 00 02 60", 8, f"<{READ}VALUES=2) at 0>", (6, True)),  # one of two values
        ("9E 00 00 00 00 00 40 60 64", 9, f"<{READ}VALUES=LV(0)) at 0>", (6, False)),  # a variable counts nothing
        (
            "9E 00 00 00 00 00 82 80 00" + "60" * 128,  # a list of parameters has 127 at most
            137,
            f"<{READ}VALUES=128) at 0>",
            (6, False),
        ),
        ("2F 40 3F 01", 4, "<INIT_BYTES(DESTINATION=LV(0), LENGTH=-1) at 0>", (2, False)),
        ("2F 40 03 01 02", 5, "<INIT_BYTES(DESTINATION=LV(0), LENGTH=3) at 0>", (2, True)),
        ("2F 40 02 01 85", 5, "<INIT_BYTES(DESTINATION=LV(0), LENGTH=2, SOURCE[0]=1) at 0>", (4, False)),
    ],
)
def test_operations_up_to_a_fault(code: str, end: int, expected: str, fault: tuple[int, bool]) -> None:
    operations, found = scanned(code, end)
    assert found is not None
    assert (found.offset, found.truncated) == fault
    assert " ".join(map(repr, operations)) == expected
    if operations and not operations[-1].is_complete:
        partial = operations[-1]
        for copied in (copy.copy(partial), copy.deepcopy(partial), pickle.loads(pickle.dumps(partial))):
            assert copied == partial
            assert copied.arguments == partial.arguments


def test_an_argument_by_itself_needs_its_end() -> None:
    with pytest.raises(ev3proto.BuildError, match="its terminating zero is missing"):
        ev3proto.operation("SOUND.PLAY", 1, b"\x84a")


def test_a_frame_that_is_too_long_whatever_its_length_field_says() -> None:
    frame = (1100).to_bytes(2, "little") + b"\x01\0\x80\0\0" + b"\x01" * 1095
    message = ev3proto.parse(frame, strict=False)
    assert message.fault == ev3proto.Fault(0, "the frame has 1102 bytes; the maximum is 1024")
    with pytest.raises(ev3proto.DecodeError, match="the length field says 1100; it can be 3 to 1022"):
        ev3proto.parse(frame)


def read(frame: bytes) -> DirectCommand:
    """A direct command as a stream gives it."""
    (message,) = Decoder().feed(frame)
    assert isinstance(message, DirectCommand)
    return message


def test_messages_cannot_be_changed() -> None:
    command = read(TONE)
    with pytest.raises(dataclasses.FrozenInstanceError, match="cannot assign to field 'operations'"):
        command.operations = ()  # type: ignore[misc]
    with pytest.raises(dataclasses.FrozenInstanceError, match="cannot delete field 'operations'"):
        del command.operations
    assert command.operations is command.operations
    assert [operation.full_name for operation in command.operations] == ["SOUND.TONE"]


def test_copies_pickles_and_changed_copies_have_the_same_operations() -> None:
    for made in (copy.copy, copy.deepcopy, lambda command: pickle.loads(pickle.dumps(command)), dataclasses.replace):
        command = made(read(TONE))
        assert command == ev3proto.parse(TONE)
        assert hash(command) == hash(ev3proto.parse(TONE))
        assert command.build() == TONE
        assert command.operations[0].arguments == ev3proto.parse(TONE, expect=DirectCommand).operations[0].arguments
    louder = dataclasses.replace(read(TONE), counter=43)
    assert louder.build().hex() == "0e002b0080000094010182b80182e803"


def test_a_message_is_shown_with_its_operations() -> None:
    assert repr(read(TONE)) == (
        "DirectCommand(DIRECT_COMMAND_NO_REPLY, counter=42, operations=(<SOUND.TONE(VOLUME=1, FREQUENCY=440,"
        " DURATION=1000) at 7>,))"
    )


def test_a_message_made_by_hand_is_built_whatever_is_loaded() -> None:
    program = (
        "from ev3proto.messages import DirectReply; from ev3proto.tables.frame import MessageType;"
        "print(DirectReply(type=MessageType.DIRECT_REPLY, memory=b'x').build().hex())"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout == "040000000278\n"
