"""Texts of several lines with delimiters between them, as in text boxes and text files."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice

from ev3proto.tables.enumerations import DEL

_BYTES = {
    "DEL_NONE": b"",
    "DEL_TAB": b"\t",
    "DEL_SPACE": b" ",
    "DEL_RETURN": b"\r",
    "DEL_COLON": b":",
    "DEL_COMMA": b",",
    "DEL_LINEFEED": b"\n",
    "DEL_CRLF": b"\r\n",
}
DELIMITERS = {DEL.members[name]: text for name, text in _BYTES.items()}
"""The bytes of every delimiter, by its number."""

_FONT_MARKS = (1, 2, 3)


def lines_of(text: bytes, delimiter: bytes) -> Iterator[bytes]:
    """Yields the lines of a text, without delimiter and font byte; anything after the last delimiter does not count."""
    # The text is read once, as in the firmware: an incomplete delimiter hides what follows it.
    start = 0
    first, rest = re.escape(delimiter[:1]), re.escape(delimiter[1:])
    ends = re.compile(first + (b"(?:(%b)|.|\\Z)" % rest if rest else b"()"), re.DOTALL)
    for found in ends.finditer(text) if delimiter else ():
        if found[1] is not None:
            line = text[start : found.end() - len(delimiter)]
            start = found.end()
            yield line[1:] if line[:1] and line[0] in _FONT_MARKS else line


def line_of(text: bytes, delimiter: bytes, number: int) -> bytes:
    """Returns a line, counted from 1; an empty one if there is none. An empty delimiter ends every line at once."""
    return next(islice(lines_of(text, delimiter), number - 1, None), b"") if number >= 1 else b""


def with_line(text: bytes, line: bytes, delimiter: bytes, font: int, size: int) -> bytes:
    """Returns a text with a line and a zero appended, cut to `size` bytes; a font but 0 precedes the line as a byte."""
    return (text + bytes([font] * (font != 0)) + line + delimiter + b"\0")[: max(size, 0)]
