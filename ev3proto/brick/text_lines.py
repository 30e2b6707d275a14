"""Texts of several lines with delimiters between them, as in text boxes and text files."""

from __future__ import annotations

from collections.abc import Iterator

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


def lines_of(text: bytes, delimiter: bytes) -> Iterator[int]:
    """Yields the ends of a text's lines, after their delimiters; anything after the last delimiter does not count."""
    # The text is read once, as in the firmware: an incomplete delimiter hides what follows it.
    at = 0
    while delimiter and at < len(text):
        found = 0
        while found < len(delimiter) and at < len(text) and text[at] == delimiter[found]:
            found += 1
            at += 1
        if found == len(delimiter):
            yield at
        else:
            at += 1


def line_of(text: bytes, delimiter: bytes, number: int) -> bytes:
    """Returns a line, counted from 1, without delimiter and font byte; an empty delimiter ends every line at once."""
    if number < 1:
        return b""
    start = 0
    for count, end in enumerate(lines_of(text, delimiter), 1):
        if count == number:
            line = text[start : end - len(delimiter)]
            return line[1:] if line[:1] and line[0] in _FONT_MARKS else line
        start = end
    return b""


def with_line(text: bytes, line: bytes, delimiter: bytes, font: int, size: int) -> bytes:
    """Returns a text with a line and a zero appended, cut to `size` bytes; a font but 0 precedes the line as a byte."""
    return (text + bytes([font] * (font != 0)) + line + delimiter + b"\0")[: max(size, 0)]
