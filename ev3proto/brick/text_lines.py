"""Texts of several lines and the delimiters between them, as text boxes and text files have them."""

from __future__ import annotations

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


def line_of(text: bytes, delimiter: bytes, number: int) -> bytes:
    """A line of a text.

    Args:
        text: the lines, each with the delimiter after it.
        delimiter: what ends a line. An empty one ends every line at once, as in the firmware.
        number: which line, counted from 1.

    Returns:
        The line without delimiter and without the byte before it that names a font; empty where there is no such line.
    """
    lines = text.split(delimiter) if delimiter else []
    if not 1 <= number <= len(lines):
        return b""
    line = lines[number - 1]
    return line[1:] if line[:1] and line[0] in _FONT_MARKS else line


def with_line(text: bytes, line: bytes, delimiter: bytes, font: int, size: int) -> bytes:
    """A text with a line appended to it, as the bytes that the firmware writes.

    Args:
        text: what is there.
        line: what is added.
        delimiter: what ends the line.
        font: the font that the line is shown in; any but 0 is written before it as one byte.
        size: bytes that there are; what does not fit is left out.

    Returns:
        The whole text, with a zero where there is room for it.
    """
    return (text + bytes([font] * (font != 0)) + line + delimiter + b"\0")[: max(size, 0)]
