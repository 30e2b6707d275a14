"""What a file is by its first bytes: a capture, a program, lines of text, the bytes of frames, or something else."""

from __future__ import annotations

import codecs
import struct
import zlib
from collections.abc import Iterable, Iterator
from contextlib import suppress
from enum import Enum
from io import BufferedReader
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from ev3proto.schema.header import HEADER_SIZE, frame_end
from ev3proto.tables.program import SIGN
from ev3proto.text.paste import Pasted
from ev3proto.text.phrases import spaced_hex
from ev3proto.text.splitting import frame_ends, split

if TYPE_CHECKING:
    from ev3proto.capture.formats import CaptureFile


class Kind(Enum):
    """What a file is."""

    CAPTURE = "a capture"
    PROGRAM = "the image of a program (.rbf)"
    TEXT = "lines of text"
    FRAMES = "the bytes of frames, one after the other"
    OTHER = "anything else"


class Contents(NamedTuple):
    """A file and what it is.

    kind    its kind
    frames  of a file of frames; their numbers are in place of lines
    reason  why it cannot be read, for any other file
    """

    kind: Kind
    frames: Iterable[Pasted] = ()
    reason: str = ""


_START = 8
_ZIP = b"PK\x03\x04"
_UF2 = b"UF2\n"
_NXT_PROGRAM = b"MindstormsNXT"
_SOUND = struct.Struct(">HHHH")
_SOUND_FORMATS = (0x0100, 0x0101)
_DISPLAY = (178, 128)
_LEAST_FIRMWARE = 1 << 20
_BY_SUFFIX = {
    ".ev3": "a project of LEGO's EV3 software, a zip of diagrams without byte code; download it to a brick and copy"
    " the program's .rbf from there",
    ".uf2": "a UF2 image for a brick in bootloader mode, which holds ARM code; copy it to the brick's drive",
    ".rgf": "an image for the brick's display; `ev3proto copy` copies it to a brick, UI_DRAW.BMPFILE shows it",
    ".rsf": "a sound file; `ev3proto copy` copies it to a brick, SOUND.PLAY plays it",
    ".bin": "probably a firmware image, which holds ARM code; the firmware updater of LEGO's software writes it",
}


def recognized(file: CaptureFile, path: Path | None, dialect: str, readable: str) -> Contents:
    """Finds out what a file is; `readable` says what could be read instead of another kind. Raises OSError."""
    try:
        if file.is_capture:
            return Contents(Kind.CAPTURE)
    except ValueError:  # a CaptureError: the gzip stream is damaged, which is reported when it is read
        return Contents(Kind.CAPTURE)
    start = file.contents.peek(_START)[:_START]
    if is_image(start):
        return Contents(Kind.PROGRAM)
    reason = _unreadable(path, start)
    if reason is None and not _is_binary(start):
        return Contents(Kind.TEXT)
    with suppress(OSError, EOFError, zlib.error):
        frames = _raw_frames(file.contents, dialect)
        if frames is not None:
            return Contents(Kind.FRAMES, frames=frames)
    shown = start.hex(" ").upper()
    return Contents(Kind.OTHER, reason=reason or f"neither text nor a capture: it starts with {shown}; {readable}")


def _unreadable(path: Path | None, start: bytes) -> str | None:
    """Returns what a file is that cannot be read, and what to do with it; None for an unknown kind."""
    suffix = "" if path is None else path.suffix.lower()
    if start.startswith(_UF2):
        return _BY_SUFFIX[".uf2"]
    if start.startswith(_ZIP):
        return _BY_SUFFIX[suffix] if suffix == ".ev3" else "a zip archive; unpack it, and give the files in it"
    if path is None:
        return None
    if _NXT_PROGRAM.startswith(start) and _beginning(path, len(_NXT_PROGRAM)) == _NXT_PROGRAM:
        return "a program for an NXT (.rxe), LEGO's earlier brick; an EV3 does not run it"
    return _by_name(path, start)


def _by_name(path: Path, start: bytes) -> str | None:
    """Returns what a file of the brick is that has neither frames nor byte code; None for an unknown kind."""
    suffix = path.suffix.lower()
    if suffix not in (".rgf", ".rsf", ".bin"):
        return None
    size = path.stat().st_size
    if suffix == ".bin":
        return _BY_SUFFIX[suffix] if size >= _LEAST_FIRMWARE else None
    wrong = _wrong_picture(start, size) if suffix == ".rgf" else _wrong_sound(start, size)
    return wrong or _BY_SUFFIX[suffix]


def _beginning(path: Path, size: int) -> bytes:
    with path.open("rb") as stream:
        return stream.read(size)


def _wrong_picture(start: bytes, size: int) -> str | None:
    """Returns what is wrong with a picture: its first two bytes are width and height in pixels."""
    if len(start) < 2:
        return "an image for the brick's display that is too short: width and height are its first two bytes"
    width, height = start[:2]
    needed = (width + 7) // 8 * height
    if size - 2 == needed and width <= _DISPLAY[0] and height <= _DISPLAY[1]:
        return None
    if size - 2 == needed:
        return f"an image of {width} x {height} pixels, but the brick's display has {_DISPLAY[0]} x {_DISPLAY[1]}"
    return (
        f"an image of {width} x {height} pixels by its first two bytes, which needs {needed} bytes after them"
        f" ({(width + 7) // 8} a row), but {max(size - 2, 0)} follow; UI_DRAW.BMPFILE shows it wrong"
    )


def _wrong_sound(start: bytes, size: int) -> str | None:
    """Returns what is wrong with a sound: it starts with format, number of bytes, rate and mode, high byte first."""
    if start.startswith(b"RIFF"):
        return "a WAV file with the suffix .rsf; SOUND.PLAY needs the brick's own format, which begins with 01 00"
    if len(start) < _SOUND.size:
        return f"a sound file that is too short: its header has {_SOUND.size} bytes, the file has {size}"
    kind, stated, rate, _ = _SOUND.unpack_from(start)
    if kind not in _SOUND_FORMATS:
        return f"not a sound file of the brick: it starts with {spaced_hex(start[:2])}, which must be 01 00 or 01 01"
    if stated != size - _SOUND.size:
        return (
            f"a sound file whose header says {stated} bytes of sound, but {size - _SOUND.size} follow;"
            " SOUND.PLAY plays it to the end of the file"
        )
    return None if rate else "a sound file whose header says 0 Hz; 8000 is usual"


def is_image(start: bytes) -> bool:
    """Whether a file that starts with these bytes is a program image."""
    return start.startswith(SIGN)


def _is_binary(start: bytes) -> bool:
    """Whether bytes are not text: text has no control characters but those that break lines, or is UTF-16."""
    if start.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return False
    return any(byte < ord(" ") and byte not in b"\t\n\r\f\x1b" for byte in start)


# Texts

_MOST_LOOKED_AT = 500
"""Lines of comments before the first line that says what a text is."""


def introduction(lines: Iterator[str]) -> Iterator[str]:
    """Yields the lines up to the first that is neither empty nor a comment, that one too."""
    is_comment = False
    for line in islice(lines, _MOST_LOOKED_AT):
        yield line
        text = line.strip()
        if is_comment or text.startswith("/*"):
            is_comment = "*/" not in text
        elif text and not text.startswith("//") and not (text.startswith("#") and "define" not in text):
            return


# Bytes


MOST_RAW = 1 << 26
"""Bytes of frames that are read from a file which has nothing else; a longer one is refused."""


def _raw_frames(stream: BufferedReader[Any], dialect: str) -> Iterator[Pasted] | None:
    """Reads the bytes of frames that follow one another; None if the stream starts with something else."""
    start = stream.read(HEADER_SIZE)
    if frame_end(start) is None:
        return None
    data = start + stream.read(MOST_RAW + 1 - len(start))
    ends = frame_ends(data)
    if ends is not None:
        return _cut(data, ends)
    is_frame = all(piece.message.fault is None for piece in split(data, dialect=dialect))
    return iter([Pasted(data, 1, "")]) if is_frame else None


def _cut(data: bytes, ends: list[int]) -> Iterator[Pasted]:
    start = 0
    for number, end in enumerate(ends, 1):
        yield Pasted(data[start:end], number, "")
        start = end
