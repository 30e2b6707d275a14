"""Every notation in which real programs write bytes, with whatever people write around them."""

from __future__ import annotations

import pytest
from support.notations import EVERY

from ev3proto.text.paste import Pasted, read_text

TONE = bytes.fromhex("0f 00 00 00 80 00 00 94 01 81 02 82 e8 03 82 e8 03")
NOTHING = bytes.fromhex("06 00 2a 00 00 00 00 01")
NAME = bytes.fromhex("0e 00 2a 00 00 00 00 d4 08 84 6d 79 45 56 33 00")
REPLY = bytes.fromhex("07 00 2a 00 02 00 00 d0 41")
LIST = bytes.fromhex("1f 00 01 00 01 99 e8 03") + b"/home/root/lms2012/prjs/\0"
TEXT = bytes.fromhex("2e 00 10 27 80 00 00 84 05 01 00 0a 84") + b'He said: "it\'s 0f 00", (0x12)\\n!\0\x84\0'
TEXT = (len(TEXT) - 2).to_bytes(2, "little") + TEXT[2:]
FRAMES = {"tone": TONE, "name": NAME, "reply": REPLY, "list": LIST, "text": TEXT}


def pieces(text: str) -> list[Pasted]:
    return list(read_text(text.splitlines(keepends=True)))


def frame_of(piece: Pasted) -> bytes:
    """A piece without the padding that may follow its frame."""
    size = int.from_bytes(piece.data[:2], "little") + 2
    return piece.data if any(piece.data[size:]) else piece.data[:size]


@pytest.mark.parametrize("name", EVERY)
@pytest.mark.parametrize("frame", FRAMES.values(), ids=FRAMES.keys())
def test_every_notation(name: str, frame: bytes) -> None:
    text = EVERY[name](frame)
    found = pieces(text)
    assert [(frame_of(piece), piece.problem) for piece in found] == [(frame, None)], text


@pytest.mark.parametrize("name", EVERY)
def test_every_notation_among_prose(name: str) -> None:
    text = EVERY[name](TONE)
    found = pieces(
        f"I tried it like this on 2024-01-31 at 12:30:\n\n{text}\n\nand my EV3 (00:16:53:42:2B:99) was silent.\n"
    )
    assert [(frame_of(piece), piece.problem) for piece in found] == [(TONE, None)], text
