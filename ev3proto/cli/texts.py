"""Texts that have frames: their lines, what other files are, what looks like a frame in them, and where each ends."""

from __future__ import annotations

import codecs
import io
from collections.abc import Callable, Iterator
from itertools import chain, islice
from pathlib import Path
from typing import Any, NamedTuple

from ev3proto.messages import Message
from ev3proto.schema.frame import parse
from ev3proto.schema.header import HEADER_SIZE, frame_size, may_have_length
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.frame import LENGTH_FIELD, REPORT_SIZES, MessageType
from ev3proto.tables.program import SIGN
from ev3proto.text.paste import MAX_LINE, Missing, Pasted, read_bare, read_text


class Piece(NamedTuple):
    """A message out of pasted bytes; `padding` bytes without meaning followed it."""

    message: Message
    padding: int = 0


def split(data: bytes, *, dialect: str = "official") -> Iterator[Piece]:
    """The messages in pasted bytes. Never raises; what is wrong stands in each message's fault."""
    first = next(_ends(data), 0)
    if first < max(_ends(data), default=0) == len(data):
        start = 0
        for end in _ends(data):
            yield Piece(parse(data[start:end], strict=False, dialect=dialect))
            start = end
        return
    if 0 < first < len(data) and (len(data) in REPORT_SIZES or not any(data[first:])):
        yield Piece(parse(data[:first], strict=False, dialect=dialect), len(data) - first)
        return
    yield Piece(parse(data, strict=False, dialect=dialect))


def _ends(data: bytes) -> Iterator[int]:
    """Where the frames end when each starts where the one before ended."""
    at = 0
    while at + LENGTH_FIELD <= len(data):
        is_frame = may_have_length(data, at)
        at += frame_size(data, at)
        if not is_frame or at > len(data):
            return
        yield at


_ZIP = b"PK\x03\x04"
_UF2 = b"UF2\n"
_SOUND = (b"\x01\x00", b"\x01\x01")
_LEAST_FIRMWARE = 1 << 20
_BY_SUFFIX = {
    ".ev3": "a project of LEGO's EV3 software, a zip of diagrams without byte code: download it to a brick and copy"
    " the program's .rbf from there",
    ".uf2": "a UF2 image for a brick in bootloader mode, which holds ARM code: copy it to the brick's drive",
    ".rgf": "an image for the brick's display: `ev3proto copy` puts it on a brick, UI_DRAW.BMPFILE shows it",
    ".rsf": "a sound file: `ev3proto copy` puts it on a brick, SOUND.PLAY plays it",
    ".bin": "a firmware image, perhaps: it holds ARM code, which the firmware updater of LEGO's software writes",
}


def kind_of(name: str, start: bytes) -> str | None:
    """Returns what a file is that cannot be read, and what to do with it; None for an unknown kind.

    Args:
        name: The path of a file; `-` for standard input.
        start: Its first bytes.
    """
    suffix = Path(name).suffix.lower()
    if start.startswith(_UF2):
        return _BY_SUFFIX[".uf2"]
    if start.startswith(_ZIP):
        return _BY_SUFFIX[suffix] if suffix == ".ev3" else "a zip archive: unpack it, and give the files in it"
    if suffix == ".bin" and Path(name).stat().st_size < _LEAST_FIRMWARE:
        return None
    if suffix == ".rsf" and not start.startswith(_SOUND):
        return None
    return _BY_SUFFIX.get(suffix) if suffix in (".rgf", ".rsf", ".bin") else None


MOST_RAW = 1 << 26
"""Bytes of frames that are read from a file which has nothing else; a longer one is refused."""

START = 8
"""Bytes by which a file is recognised."""

SOURCE_SUFFIX = ".lms"
"""What the names of programs' sources end in."""

_MOST_UNREAD = 8

_MOST_LOOKED_AT = 500
"""Lines of comments before the first line that says what a text is."""


class Unread:
    """What looks like frames in a text and was not read."""

    def __init__(self) -> None:
        self.count = 0
        self._first: list[str] = []

    def add(self, pasted: Pasted) -> None:
        """Takes one more; only the first ones are named."""
        self.count += 1
        if len(self._first) < _MOST_UNREAD:
            self._first.append(f"line {pasted.line}, column {pasted.column}: {pasted.problem}")

    def __str__(self) -> str:
        many = f"{self.count} lines look like frames and were"
        lines = "1 line looks like a frame and was" if self.count == 1 else many
        more = self.count - len(self._first)
        return f"{lines} not read: {'; '.join(self._first)}" + (f"; and {more} more" if more else "")


def pieces(lines: Iterator[str], missing: Missing | None, complain: Callable[[str], None]) -> Iterator[Pasted]:
    """What there is in the lines of a text.

    Args:
        lines: The lines.
        missing: What the bytes of each line lack to be a frame.
        complain: Is called at the end with a sentence on what looks like frames and was not read.

    Yields:
        Pieces that have bytes, or a problem.
    """
    unread = Unread()
    for pasted in read_text(lines) if missing is None else read_bare(lines, missing):
        if pasted.unread:
            unread.add(pasted)
        else:
            yield pasted
    if unread.count:
        complain(str(unread))


def introduction(lines: Iterator[str]) -> Iterator[str]:
    """The lines up to the first that is neither empty nor a comment, that one too."""
    is_comment = False
    for line in islice(lines, _MOST_LOOKED_AT):
        yield line
        text = line.strip()
        if is_comment or text.startswith("/*"):
            is_comment = "*/" not in text
        elif text and not text.startswith("//") and not (text.startswith("#") and "define" not in text):
            return


def is_image(start: bytes) -> bool:
    """Whether a file that starts so is a program image."""
    return start.startswith(SIGN)


def _as_latin_1(error: UnicodeError) -> tuple[str, int]:
    """The characters that bytes mean in ISO-8859-1, and where reading goes on."""
    assert isinstance(error, UnicodeDecodeError)
    return error.object[error.start : error.end].decode(STRING_CODING), error.end


_LATIN_1 = "ev3proto-latin-1"
codecs.register_error(_LATIN_1, _as_latin_1)


def text_lines(stream: io.BufferedReader[Any]) -> Iterator[str]:
    """The lines of a file, those that are too long only as far as it takes to see that.

    Text is UTF-8, or UTF-16 where the file starts with that mark, as PowerShell writes it. Bytes that are no UTF-8 are
    ISO-8859-1, as in many sources of programs.
    """
    start = stream.peek(2)[:2]
    encoding = "utf-16" if start in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE) else "utf-8-sig"
    text = io.TextIOWrapper(stream, encoding, _LATIN_1 if encoding == "utf-8-sig" else "replace")
    while line := text.readline(MAX_LINE + 1):
        yield line
        while len(line) > MAX_LINE and not line.endswith("\n"):
            line = text.readline(MAX_LINE + 1)


def raw_frames(stream: io.BufferedReader[Any], dialect: str) -> Iterator[Piece] | None:
    """Frames that stand one after the other as they are.

    Args:
        stream: A file that is neither a text nor a capture. It is not read where it does not start with a frame.
        dialect: The firmware whose instruction set to read by.

    Returns:
        The frames, one by one; None where there is none.
    """
    start = stream.peek(HEADER_SIZE)[:HEADER_SIZE]
    if len(start) < HEADER_SIZE or not may_have_length(start) or start[-1] not in frozenset(MessageType):
        return None
    found = split(stream.read(MOST_RAW + 1), dialect=dialect)
    begin = list(islice(found, 2))
    if len(begin) == 1 and begin[0].message.fault is not None:
        return None
    return chain(begin, found)


def hex_lines(found: Iterator[Piece]) -> Iterator[str]:
    """Frames as the lines of a text."""
    return (piece.message.build().hex(" ") for piece in found)


def is_binary(start: bytes) -> bool:
    """Whether bytes are no text: it has no control characters but those that break lines, or is UTF-16."""
    if start.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return False
    return any(byte < ord(" ") and byte not in b"\t\n\r\f\x1b" for byte in start)
