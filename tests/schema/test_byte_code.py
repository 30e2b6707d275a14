"""Byte code, operation by operation: what is read, where it is faulty, and what is kept before the fault."""

from __future__ import annotations

import copy
import dataclasses
import pickle
import subprocess
import sys

import pytest

import ev3proto
from ev3proto import Decoder, DirectCommand

TONE = bytes.fromhex("0e002a0080000094010182b80182e803")
"""SOUND TONE at volume 1, 440 Hz, 1000 ms."""

READ = "INPUT_READEXT(LAYER=0, NO=0, TYPE=0, MODE=0, FORMAT=0, "


@pytest.mark.parametrize(
    ("code", "expected"),
    [
        ("94 01 01 82 B8 01 82 E8", "SOUND.TONE(VOLUME=1, FREQUENCY=440)"),
        ("94 01 01 82 B8 01 A8", "SOUND.TONE(VOLUME=1, FREQUENCY=440)"),  # a label has a byte after the first
        ("7D 01 84 61", "STRINGS.GET_SIZE()"),
        ("9E 00 00 00 00 00 02 60", f"{READ}VALUES=2)"),  # one of two values
        ("9E 00 00 00 00 00 40 60 64", f"{READ}VALUES=LV(0))"),  # a variable counts nothing
        ("9E 00 00 00 00 00 82 80 00" + "60" * 128, f"{READ}VALUES=128)"),  # a list of parameters has 127 at most
        ("2F 40 02 01 85", "INIT_BYTES(DESTINATION=LV(0), LENGTH=2, SOURCE[0]=1)"),
    ],
)
def test_arguments_before_a_fault_are_kept(code: str, expected: str) -> None:
    body = bytes.fromhex("2A00 80 0000" + code)
    frame = len(body).to_bytes(2, "little") + body
    (partial,) = ev3proto.parse(frame, expect=DirectCommand, strict=False).operations
    assert (repr(partial), partial.is_complete) == (f"<{expected} at 7>", False)
    for copied in (copy.copy(partial), copy.deepcopy(partial), pickle.loads(pickle.dumps(partial))):
        assert copied == partial
        assert copied.arguments == partial.arguments


def test_a_text_needs_its_zero() -> None:
    with pytest.raises(ev3proto.BuildError, match="its terminating zero is missing"):
        ev3proto.operation("SOUND.PLAY", 1, b"\x84a")


def test_a_frame_longer_than_1024_bytes() -> None:
    frame = (1100).to_bytes(2, "little") + b"\x01\0\x80\0\0" + b"\x01" * 1095
    message = ev3proto.parse(frame, strict=False)
    assert message.fault == ev3proto.Fault(0, "the frame has 1102 bytes; the maximum is 1024")
    with pytest.raises(ev3proto.DecodeError, match="the length field says 1100; it can be 3 to 1022"):
        ev3proto.parse(frame)


def read(frame: bytes) -> DirectCommand:
    """A direct command as a stream returns it."""
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


def test_a_message_builds_without_other_imports() -> None:
    program = (
        "from ev3proto.messages import DirectReply; from ev3proto.tables.frame import MessageType;"
        "print(DirectReply(type=MessageType.DIRECT_REPLY, memory=b'x').build().hex())"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout == "040000000278\n"
