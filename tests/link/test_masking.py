"""What `--hide` overwrites: every text that is not declared public."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.effort import effort

import ev3proto
from ev3proto import GV, LV, Operation, operation
from ev3proto.link.masking import masked, masked_note, masked_opening
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
        *(
            asking(text)
            for text in (
                operation("SYSTEM", SECRET, LV(0)),
                operation("UI_DRAW.TEXT", 1, 0, 0, SECRET),
                operation("UI_DRAW.VIEW_UNIT", 1, 0, 0, 1.0, 4, 1, 8, SECRET),
                operation("UI_WRITE.PUT_STRING", SECRET),
                operation("UI_WRITE.STAMP", SECRET),
                operation("FILENAME.EXIST", SECRET, LV(0)),
                operation("FILENAME.MERGE", SECRET, SECRET, SECRET, 60, LV(0)),
                operation("FILE.OPEN_READ", SECRET, LV(0), LV(4)),
                operation("FILE.WRITE_TEXT", 1, 0, SECRET),
                operation("SOUND.PLAY", 100, SECRET),
                operation("STRINGS.COMPARE", SECRET, SECRET, LV(0)),
                operation("NOTE_TO_FREQ", SECRET, LV(0)),
                operation("MAILBOX_WRITE", SECRET, 0, SECRET, 4, [encode_as("LCS", SECRET)]),
                operation("INPUT_DEVICE.INSERT_TYPE", SECRET, 0, LV(0)),
                operation("INPUT_WRITE", 0, 0, 11, encode_as("LCS", SECRET)),
            )
        ),
        # A text that is put together of constants.
        asking(*(operation("WRITE8", encode_as("LC1", byte), at, LV(0)) for at, byte in enumerate(SECRET.encode()))),
        asking(*(operation("ADD8", encode_as("LC1", byte), 0, LV(at)) for at, byte in enumerate(SECRET.encode()))),
        asking(
            *(operation("SELECT8", 1, encode_as("LC1", byte), 0, LV(at)) for at, byte in enumerate(SECRET.encode()))
        ),
        asking(*(operation("OR8", encode_as("LC1", byte), 0, LV(at)) for at, byte in enumerate(SECRET.encode()))),
        asking(operation("MOVE32_32", int.from_bytes(SECRET[:4].encode(), "little"), LV(0))),
        ev3proto.system_command("SETBUNDLEID", id=SECRET).build(),
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
    ("frame", "shown"),
    [
        ("0800 2A00 81 9F 01 00 01 00", "0800 2A00 81 9F 01 00 01 00"),
        ("0A00 2A00 81 9F 02 31 00 02 32 00", "0A00 2A00 81 9F 02 78 00 02 78 00"),
        ("0C00 2A00 81 9F 03 61 62 00 03 31 32 00", "0C00 2A00 81 9F 03 78 78 00 03 78 78 00"),
        ("0600 2A00 81 A1 61 00", "0600 2A00 81 A1 78 00"),
    ],
    ids=["no letters", "one letter", "two letters", "one text"],
)
def test_all_letters_of_a_text_are_hidden_and_its_zero_is_shown(frame: str, shown: str) -> None:
    """BLUETOOTHPIN has two texts with their sizes, SETBUNDLEID one to its zero."""
    assert masked(bytes.fromhex(frame)) == bytes.fromhex(shown)


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
        # Memory keeps its contents from one command to the next.
        *(
            (replying(MEMORY), asking(*operations))
            for operations in (
                [operation("MOVE32_32", GV(at), GV(at)) for at in (0, 4, 8)],
                [operation("ADD8", GV(at), 0, GV(at)) for at in range(11)],
                [operation("STRINGS.DUPLICATE", GV(0), GV(0))],
                [operation("SELECT32", 1, GV(0), GV(4), GV(0)), operation("SELECT32", 1, GV(4), GV(8), GV(4))],
                [operation("MEMORY_READ", 1, 0, 0, 16, GV(0))],
                [operation("ARRAY_READ", LV(0), at, GV(at)) for at in range(11)],
                [operation("FILE.GET_SUBFOLDER_NAME", "../prjs/", 1, 16, GV(0))],
                [operation("UI_READ.TEXTBOX_READ", GV(0), 16, 0, 16, 1, GV(0))],
                [operation("JR", 3), operation("UI_READ.GET_VBATT", GV(0))],
                # Outputs that are never reached.
                *(
                    [end, *(operation("UI_READ.GET_VBATT", GV(at)) for at in (0, 4, 8))]
                    for end in (
                        operation("OBJECT_END"),
                        operation("OBJECT_STOP", 1),
                        operation("PROGRAM_STOP", 2),
                        operation("PROGRAM_STOP", -1),
                        operation("RETURN"),
                        operation("ERROR"),
                        operation("JR", 7),
                        operation("JR_TRUE", 1, 7),
                        operation("CALL", 1, []),
                    )
                ),
                # Outputs that are not written, or only a part of them.
                [operation("INPUT_DEVICE_LIST", 48, GV(0), LV(0))],
                [operation("INPUT_DEVICE_LIST", LV(4), GV(0), LV(0))],
                [operation("INPUT_DEVICE.GET_NAME", 0, 0, LV(4), GV(0))],
                [operation("INPUT_READEXT", 0, 0, 0, 0, 3, [GV(0), GV(4), GV(8)])],
                [operation("PROGRAM_INFO.GET_STATUS", 1, GV(at)) for at in range(11)],
                [operation("FILE.LOAD_IMAGE", 1, "../prjs/a.rbf", GV(0), GV(4))],
                [operation("COM_GET.GET_NETWORK", 1, 16, GV(0), LV(0), LV(16))],
            )
        ),
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


def test_commands_without_texts_stay() -> None:
    tone = asking(operation("SOUND.TONE", 1, 440, 1000))
    sensor = asking(operation("INPUT_DEVICE.READY_SI", 0, 1, 32, 3, [GV(0), GV(4)]))
    name = asking(operation("INPUT_DEVICE.GET_NAME", 0, 2, 16, GV(0)))
    for frame in (BATTERY, tone, sensor, name):
        assert masked(frame) == frame
    # Memory behind the outputs may hold anything.
    volts = bytes.fromhex("00 00 f0 40")
    assert masked(replying(volts.ljust(16, b"\0")), BATTERY) == replying(volts.ljust(16, b"x"))
    version = replying(b"V1.04H".ljust(16, b"\0"))
    shown = replying(b"V1.04H\0".ljust(16, b"x"))
    assert masked(version, asking(operation("UI_READ.GET_FW_VERS", 16, GV(0)))) == shown
    for public, memory in ((sensor, bytes(range(8))), (name, b"COL-REFLECT\0")):
        assert masked(replying(memory.ljust(16, b"\0")), public) == replying(memory.ljust(16, b"x"))
    listing = ev3proto.system_command("LIST_FILES", path="../prjs/", max_bytes=900).build()
    assert masked(listing) == listing


def test_outputs_of_commands_that_do_more_than_read_are_masked() -> None:
    request = asking(operation("UI_READ.GET_VBATT", GV(0)), operation("OBJECT_END"))
    assert masked(request) == request
    assert masked(replying(bytes(16)), request) == replying(b"x" * 16)


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


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        (
            b"GET /target?sn=0016533f0c1e VMTP1.0\r\nProtocol: EV3\r\n\r\n",
            b"GET /target?sn=000000000000 VMTP1.0\r\nProtocol: EV3\r\n\r\n",
        ),
        (b"GET /target?sn=Anna VMTP1.0\nProtocol:EV3\n", b"GET /target?sn=0000 VMTP1.0\nProtocol:EV3\n"),
        (
            b"GET /target?sn= VMTP1.0\r\nHost: annas-laptop\r\nProtocol: EV3 of Anna\r\n",
            b"GET /target?sn= VMTP1.0\r\nxxxxxxxxxxxxxxxxxx\r\nxxxxxxxxxxxxxxxxxxxxx\r\n",
        ),
        (b"AnnaGET /target?sn=0016533f0c1e\r\n", b"x" * 31 + b"\r\n"),
        (b"Accept:EV340\r\n\r\n\0", b"Accept:EV340\r\n\r\n\0"),
    ],
)
def test_the_unlock_text(text: bytes, shown: bytes) -> None:
    assert masked_opening(text) == shown


@pytest.mark.parametrize(
    ("note", "shown"),
    [
        ("192.0.2.7:61234 sent bytes that are not a frame", "x sent bytes that are not a frame"),
        ("192.0.2.7 was disconnected: only 192.0.2.10 is served", "x was disconnected: only x is served"),
        ("fe80::1%eth0:61234 sent", "x sent"),
        ("::1 was disconnected", "x was disconnected"),
        ("the brick 0016533f0c1e was unplugged", "the brick x was unplugged"),
        ("00:16:53:3F:0C:1E did not answer", "x did not answer"),
        ("blocked by --read-only: SOUND.TONE starts a sound", "blocked by --read-only: SOUND.TONE starts a sound"),
        ("offset 0: length 29264: text", "offset 0: length 29264: text"),
    ],
)
def test_messages(note: str, shown: str) -> None:
    assert masked_note(note) == shown
