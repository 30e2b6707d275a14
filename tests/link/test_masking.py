"""What `--hide` overwrites: everything that is not known to be harmless."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.effort import effort

import ev3proto
from ev3proto import GV, LV, Operation, operation
from ev3proto.link.masking import masked
from ev3proto.schema.argument import encode_as
from ev3proto.testing import frames, mutated_frames

many = settings(max_examples=effort(75, 1000))

SECRET = "EV3-of-Anna"
PIN = bytes.fromhex("17000100019f0d303031363533333465414243440005 31323334")
"""BLUETOOTHPIN with the PIN 1234, whose last byte, a zero, is missing."""


def asking(*operations: Operation, size: int = 16) -> bytes:
    return ev3proto.direct_command(*operations, reply=True, global_size=size, local_size=32).build()


def replying(memory: bytes, *, fails: bool = False) -> bytes:
    body = b"\0\0" + (b"\x04" if fails else b"\x02") + memory
    return len(body).to_bytes(2, "little") + body


NAMING = asking(operation("COM_SET.SET_BRICKNAME", SECRET))
NAME = asking(operation("COM_GET.GET_BRICKNAME", 16, GV(0)))
ADDRESS = asking(operation("UI_READ.GET_IP", 16, GV(0)))
BATTERY = asking(operation("UI_READ.GET_VBATT", GV(0)))
MEMORY = SECRET.encode().ljust(16, b"\0")


@pytest.mark.parametrize(
    "frame",
    [
        PIN,
        NAMING,
        NAMING[:-1],
        b"\x1f" + NAMING[1:],
        NAMING[:4] + b"\x77" + NAMING[5:],  # unknown message type
        asking(operation("STRINGS.DUPLICATE", SECRET, LV(0)), operation("COM_SET.SET_BRICKNAME", LV(0))),
        asking(operation("STRINGS.DUPLICATE", SECRET, GV(0))),  # the next command names the brick by GV(0)
        asking(operation("INIT_BYTES", LV(0), len(SECRET), *[encode_as("LC1", byte) for byte in SECRET.encode()])),
        asking(
            *(operation("MOVE8_8", encode_as("LC1", byte), LV(at)) for at, byte in enumerate(SECRET.encode())),
            operation("COM_SET.SET_BRICKNAME", LV(0)),
        ),
        # A jump into a text that may contain an operation about communication.
        asking(operation("JR", 3), operation("SOUND.PLAY", 100, SECRET)),
        asking(operation("UI_DRAW.KEYBOARD", 1, 0, 0, 0, 16, SECRET, LV(20), LV(0))),
    ],
)
def test_commands(frame: bytes) -> None:
    hidden = masked(frame)
    assert len(hidden) == len(frame)
    assert hidden[:5] == frame[:5]
    for at in range(len(SECRET) - 3):
        assert SECRET[at : at + 3].encode() not in hidden
    assert b"123" not in hidden
    letters = [byte for byte in SECRET.encode() if bytes((0x81, byte)) in hidden]
    assert letters == []


@pytest.mark.parametrize(
    ("reply", "request_"),
    [
        (replying(MEMORY), NAME),
        (replying(MEMORY), masked(NAME)),
        (replying(MEMORY), ADDRESS),
        (replying(MEMORY), NAMING),
        (replying(MEMORY), masked(PIN)),
        (replying(MEMORY), None),
        (replying(MEMORY, fails=True), NAME),
        (replying(MEMORY, fails=True), BATTERY),
        (replying(b"\0\0\0\0" + MEMORY), BATTERY),  # left from the command before
        (replying(b"\0" + SECRET[1:].encode()), asking(operation("UI_READ.GET_FW_VERS", 16, GV(0)))),
        (
            replying(MEMORY),
            asking(operation("COM_GET.GET_BRICKNAME", 16, LV(0)), operation("STRINGS.ADD", LV(0), LV(0), GV(0))),
        ),
        (replying(MEMORY)[:-1], BATTERY),
    ],
)
def test_replies(reply: bytes, request_: bytes | None) -> None:
    hidden = masked(reply, request_)
    assert len(hidden) == len(reply)
    assert hidden[:5] == reply[:5]
    for at in range(len(SECRET) - 3):
        assert SECRET[at : at + 3].encode() not in hidden


def test_a_masked_command_has_the_same_operations() -> None:
    frame = asking(
        operation("COM_GET.GET_BRICKNAME", 16, GV(0)),
        operation("COM_SET.SET_BRICKNAME", SECRET),
        operation("MOVE32_32", 12345678, LV(4)),
        operation("MOVE8_8", 5, LV(8)),
    )
    (name, naming, long, short) = ev3proto.parse(masked(frame)).operations  # type: ignore[attr-defined]
    assert [argument.value for argument in name.arguments] == [16, 0]
    assert [argument.value for argument in naming.arguments] == ["x" * len(SECRET)]
    assert [argument.value for argument in long.arguments] == [0x78787878, 4]
    assert [argument.value for argument in short.arguments] == [0, 8]


def test_what_is_harmless_stays() -> None:
    for frame in (BATTERY, asking(operation("SOUND.PLAY", 100, "./ui/x"))):
        assert masked(frame) == frame
    reply = replying(bytes.fromhex("00 00 f0 40").ljust(16, b"\0"))
    assert masked(reply, BATTERY) == reply
    version = replying(b"V1.04H".ljust(16, b"\0"))
    assert masked(version, asking(operation("UI_READ.GET_FW_VERS", 16, GV(0)))) == version
    listing = ev3proto.system_command("LIST_FILES", path="../prjs/", max_bytes=900).build()
    assert masked(listing) == listing


def test_the_text_in_a_masked_reply_keeps_its_length() -> None:
    hidden = masked(replying(MEMORY), NAME)
    assert hidden[5:] == b"x" * len(SECRET) + b"\0" + b"x" * (15 - len(SECRET))


@many
@given(frames() | mutated_frames(), st.none() | frames())
def test_a_mask_keeps_length_counter_and_type(frame: bytes, request: bytes | None) -> None:
    hidden = masked(frame, request)
    assert (len(hidden), hidden[:5]) == (len(frame), frame[:5])
    assert masked(hidden, request) == hidden
    message, shown = ev3proto.parse(frame, strict=False), ev3proto.parse(hidden, strict=False)
    if message.fault is not None:
        assert hidden[5:] == b"x" * len(frame[5:])
    elif getattr(message, "operations", ()):
        assert [one.full_name for one in shown.operations] == [one.full_name for one in message.operations]  # type: ignore[attr-defined]
