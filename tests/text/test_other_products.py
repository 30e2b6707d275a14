"""Other products' telegrams are named; a frame of an EV3, right or wrong, is never called one, nor dropped."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from support.cases import each
from support.notations import NOTATIONS
from support.typical import COMMANDS, SYSTEM, frame, with_length

from ev3proto import parse
from ev3proto.system import writemailbox
from ev3proto.text.paste import read_argument, read_text

SLIPS: dict[str, Callable[[bytes, int], bytes]] = {
    "length counts itself": lambda data, _: with_length(data, len(data)),
    "length two too small": lambda data, _: with_length(data, len(data) - 4),
    "a byte lost": lambda data, at: data[: at % (len(data) - 5) + 5] + data[at % (len(data) - 5) + 6 :],
    "unknown type": lambda data, at: data[:4] + bytes((0x40 + at % 0x40,)) + data[5:],
}
FORMS = ("blanks", "C", "repr", "decimals", "lesson")
RIGHT = "06 00 2a 00 80 00 00 01"


@each("form, slip", [(form, slip) for form in FORMS for slip in SLIPS])
@given(
    contents=st.sampled_from([*COMMANDS.values(), *SYSTEM.values()]),
    counter=st.integers(0, 65535),
    at=st.integers(0, 255),
)
@example(contents=COMMANDS["tone"], counter=1, at=0)
@example(contents=COMMANDS["battery"], counter=3, at=0)
@example(contents=COMMANDS["nothing"], counter=0x0300, at=0)
def test_a_wrong_frame_is_never_a_strangers(form: str, slip: str, contents: str, counter: int, at: int) -> None:
    right = frame(contents, counter)
    wrong = SLIPS[slip](right, at)
    text = NOTATIONS[form](wrong)
    alone = read_argument(text)
    assert (alone.data, alone.problem) == (wrong, None)
    pieces = list(read_text([f"{RIGHT}\n", f"TX {text}\n", f"{RIGHT}\n"]))
    assert [(piece.line, piece.problem) for piece in pieces] == [
        (1, None),
        *([(2, None)] * (len(wrong) > 6)),
        (3, None),
    ]
    assert len(wrong) <= 6 or pieces[1].data == wrong


STRANGERS = {
    "DEBUG:nxt.backend.bluetooth:send: 0200019b": "NXT (GETDEVICEINFO)",
    "02 00 00 0b": "NXT (GETBATTERYLEVEL)",
    r"b'\x02\x00\x01\x9b'": "NXT (GETDEVICEINFO)",
    r"Sent b'\x02\x00\x80\r'": "NXT (KEEPALIVE)",
    "06 00 00 03 0b 02 f4 01": "NXT (PLAYTONE)",
    "06 00 80 03 b8 01 e8 03": "NXT (PLAYTONE)",
    "80 04 00 64 07 00 00 20 00 00 00 00": "NXT (SETOUTPUTSTATE)",
    "80 04 01 4b 05 01 00 20 00 00 00 00": "NXT (SETOUTPUTSTATE)",
    "08 00 81 00 11 51 00 25": "Wireless Protocol",
    "0f 00 04 00 01 27 00 00 00 00 10 00 00 00 10": "Wireless Protocol",
    "0a 00 41 00 00 01 00 00 00 01": "Wireless Protocol",
}


@pytest.mark.parametrize("text", STRANGERS)
def test_a_telegram_of_another_product_is_named(text: str) -> None:
    (piece,) = read_text(["connected\n", f"{text}\n"])
    assert piece.data == b""
    assert STRANGERS[text] in (piece.problem or "")


FORWARD = (
    "this is the text 'forward', not a frame; a Messaging block needs WRITEMAILBOX: for its mailbox 'abc', send"
    " 13 00 00 00 81 9E 04 61 62 63 00 08 00 66 6F 72 77 61 72 64 00"
)


@pytest.mark.parametrize(
    "line",
    [
        "66 6F 72 77 61 72 64",
        "666F7277617264",
        "0x66, 0x6f, 0x72, 0x77, 0x61, 0x72, 0x64, 0x00",
        "TX: 66 6F 72 77 61 72 64 0D 0A",
        "b'forward'",
        r"Sent b'forward\r\n'",
        '12:01:02.123 Sent: "forward"',
    ],
)
def test_text_that_was_sent_to_a_brick_is_named_with_the_frame_that_carries_it(line: str) -> None:
    (piece,) = read_text([f"{line}\n"])
    assert (piece.data, piece.problem) == (b"", FORWARD)
    assert parse(bytes.fromhex(FORWARD.rpartition("send ")[2])).build() == writemailbox("abc", "forward").build()


FRAME = bytes.fromhex("0F0000008000009401810282E80382E803")
WRITTEN = {
    "hex": "0F0000008000009401810282E80382E803",
    "hex, small": "0f 00 00 00 80 00 00 94 01 81 02 82 e8 03 82 e8 03",
    "0x": "0x0F,0x00,0x00,0x00,0x80,0x00,0x00,0x94,0x01,0x81,0x02,0x82,0xE8,0x03,0x82,0xE8,0x03",
    "lesson": "0x|0F:00|00:00|80|00:00|94|01|81:02|82:E8:03|82:E8:03|",
    "escapes": r"\x0f\x00\x00\x00\x80\x00\x00\x94\x01\x81\x02\x82\xe8\x03\x82\xe8\x03",
    "decimals": "15 0 0 0 128 0 0 148 1 129 2 130 232 3 130 232 3",
    "list": "[15, 0, 0, 0, -128, 0, 0, -108, 1, -127, 2, -126, -24, 3, -126, -24, 3]",
    "base64": "DwAAAIAAAJQBgQKC6AOC6AM=",
}
"""How a program may write the frame as a text that it then sends."""


@pytest.mark.parametrize("written", WRITTEN)
@pytest.mark.parametrize("form", ["hex", "blanks", "0x and commas", "C", "decimals", "hexdump -C", "xxd", "lesson"])
def test_a_frame_that_was_sent_as_a_text_is_named_and_shown(written: str, form: str) -> None:
    text = WRITTEN[written]
    (piece,) = read_text(f"{NOTATIONS[form](text.encode())}\n".splitlines(keepends=True))
    assert piece.data == b""
    assert piece.problem == f"this is the text {text!r}, a frame written as characters; send {FRAME.hex(' ').upper()}"


def test_digits_that_are_not_a_frame_are_not_named() -> None:
    for text in ("0123456789ABCDEF01", "2026 11 28 13 43 11", "DEADBEEFDEADBEEF", "192 168 0 1 5555 10 3"):
        found = list(read_text([f"{text.encode().hex(' ')}\n"]))
        assert [piece for piece in found if "written as characters" in (piece.problem or "")] == [], text


OPERATIONS = "these are operations without the header of a frame"


@pytest.mark.parametrize(
    "text",
    [
        "<<174, 0, 3, 129, 50, 0, 130, 132, 3, 130, 180, 0, 1>>",
        "[-92, 0, 1, -127, 50, -90, 0, 1]",
        "byte[] ops = {(byte) 0xA4, 0, 1, (byte) 0x81, 50, (byte) 0xA6, 0, 1};",
        "bytes([164, 0, 1, 129, 50, 166, 0, 1])",
        "164, 0, 1, 129, 50, 166, 0, 1",
        "164 0 1 129 50 166 0 1",
        r"b'\xa4\x00\x01\x812\xa6\x00\x01'",
        "A4 00 01 81 32 A6 00 01",
    ],
)
def test_operations_without_a_header_are_named_in_every_notation(text: str) -> None:
    (piece,) = read_text([f"{text}\n"])
    assert (piece.data, piece.problem) == (b"", OPERATIONS)


@pytest.mark.parametrize(
    "text",
    [
        "[0, 1, 1, 2, 3, 5, 8, 13]",
        "[10, 20, 30, 40]",
        "x = [2, 2, 2, 3, 3, 1, 8]",
        "5 10 15 20 9",
        "192, 168, 0, 1",
        "130 140 150 160 170",
    ],
)
def test_other_lists_are_not_operations(text: str) -> None:
    assert [piece.problem for piece in read_text([f"{text}\n"]) if piece.problem] == []


def test_a_long_text_is_named_alone() -> None:
    (piece,) = read_text([f"Sent b'{'turn left ' * 20}'\n"])
    assert piece.problem == (
        "this is the text 'turn left turn left tur…', not a frame; a Messaging block needs WRITEMAILBOX"
    )


@pytest.mark.parametrize("line", ["Received 'forward'", "x = 'forward'", "31 32 33 34", "b'1'", "Sent b'\\x0b\\x00'"])
def test_other_texts_are_not_named(line: str) -> None:
    assert [piece for piece in read_text([f"{line}\n"]) if "WRITEMAILBOX" in (piece.problem or "")] == []


def test_a_text_among_frames_is_passed_over() -> None:
    (piece,) = read_text(["Sent b'forward'\n", f"Sent {RIGHT}\n"])
    assert piece.data.hex(" ") == RIGHT


@each(
    "text, how",
    {
        "recv: [B@40e3f9b8": "Java prints for an array, not its bytes; print Arrays.toString(bytes)",
        "java.nio.HeapByteBuffer[pos=0 lim=17 cap=17]": "print Arrays.toString(buffer.array())",
        "Received System.Byte[]": "print BitConverter.ToString(bytes.ToArray())",
        "rx: [object ArrayBuffer]": "print new Uint8Array(buffer).join(' ')",
        "sent ARRAY(0x55d0c8a3f0)": "print join(' ', @$bytes)",
        "got #<Enumerator:0x000055d0c8a3f0>": "print bytes.to_a",
        "Received: Instance of 'Uint8List'": "print data.buffer.asUint8List()",
        "rx: System.Collections.Generic.List`1[System.Byte]": "print BitConverter.ToString(bytes.ToArray())",
        "<_io.BytesIO object at 0x7f2b3c>": "print bytes(data).hex(' ')",
        "reply = <memory at 0x7f2b8c0d1e80>": "print bytes(data).hex(' ')",
        "<map object at 0x7f2b8c0d1e80>": "print bytes(data).hex(' ')",
        "sent table: 0x5581c3a0": "print table.concat(bytes, ' ')",
    }.items(),
)
def test_the_name_of_an_array_is_answered_with_how_to_print_it(text: str, how: str) -> None:
    (piece,) = read_text([f"{text}\n"])
    assert piece.data == b""
    assert how in (piece.problem or "")


def test_a_string_of_source_code_is_not_operations() -> None:
    assert list(read_text(["    'abc\\033[mdef',"])) == []
