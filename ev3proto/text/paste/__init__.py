r"""Text that people paste -> the bytes of frames: log lines, hex, byte strings, arrays, dumps.

Nobody types a frame into a file of its own: frames come out of terminals, source code and bug reports. What is here
finds them there, line by line, and leaves prose alone. It knows how bytes are written and nothing of what they mean.

The forms, in the order in which a line is tried:

    dump            0000  0e 00 2a 00 80 00 00 94  01 01 82 b8 01 82 e8 03   ..*.............
    fromhex         bytes.fromhex("0e002a00...")
    string          b'\x0e\x00*\x00...'  and  "\x0e\x00*\x00..."
    escapes         \x0e\x00\x2a\x00...
    lesson          0x|0E:00|2A:00|80|00:00|94|01|01|82:B8:01|82:E8:03|
    array           { 0x0E, 0x00, 42, ... }  and  [14, 0, 42, ...], also over several lines
    bare hex        0E002A00..., with blanks, commas, colons, dashes, bars or 0x; nothing else may stand in the line

In front of each may stand a time and a word that tells the direction.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from ev3proto.text.paste.dumps import dump_row
from ev3proto.text.paste.hexadecimal import bare
from ev3proto.text.paste.pieces import LEAST, MAX_TEXT, Pasted, Wants, short
from ev3proto.text.paste.reader import MAX_LINE, Reader

__all__ = ["MAX_LINE", "Pasted", "read_argument", "read_text"]


def read_text(lines: Iterable[str]) -> Iterator[Pasted]:
    """The frames in lines of text, in their order; whatever looks like none is passed over. Never raises of itself.

    Memory stays bounded: only an array or a dump that goes on over several lines is collected, up to 64 KiB of it.
    Lines of more than 1 MiB are not read, but reported.
    """
    yield from Reader(Wants(LEAST, is_sure=False)).read(lines)


def read_argument(text: str) -> Pasted:
    """The bytes of one argument of a command line, which is taken to be meant as bytes, however few. Never raises.

    What cannot be read gives a `problem`, and so does a second piece in the same argument: `data` is the first.
    """
    lines = text.strip("\r\n").split("\n")
    if len(lines) == 1:
        pieces = list(Reader(Wants(1, is_sure=True)).read(lines))
    else:
        wrapped = _wrapped_hex(lines)
        pieces = list(read_text(lines)) if wrapped is None else [wrapped]
    if not pieces:
        problem = "it is empty" if not text.strip() else "column 1: there are no bytes in it that could be read"
        return Pasted(b"", 1, short(text, MAX_TEXT), problem=problem)
    first = pieces[0]
    if len(pieces) == 1 or first.problem is not None:
        return first
    problem = f"it has {len(pieces)} frames in it, of which only the first was read: give each an argument of its own"
    return replace(first, problem=problem)


def _wrapped_hex(lines: list[str]) -> Pasted | None:
    """Hex that was wrapped at the end of the line is one piece; a dump must not be joined, its offsets are no bytes."""
    joined = " ".join(lines)
    if dump_row(lines[0]) is not None or len(joined) > MAX_LINE:
        return None
    found = bare(joined, is_sure=False)
    if found is None or not found.data or found.problem is not None:
        return None
    return found.pasted(1, joined)
