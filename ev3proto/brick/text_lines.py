"""Texts of several lines and the delimiters between them, as text boxes and text files have them."""

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
    """Yields where the lines of a text end, after their delimiters; what follows the last delimiter does not count.

    The text is read once, as the firmware reads it: an incomplete delimiter hides what follows it.
    """
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
    """Returns a line of a text.

    Args:
        text: The lines, each with the delimiter after it.
        delimiter: The end of a line. An empty one ends every line at once, as in the firmware.
        number: Which line, counted from 1.

    Returns:
        The line without its delimiter and without the byte before it that names a font; empty for an unknown line.
    """
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
    """Returns a text with a line appended to it, as the bytes that the firmware writes.

    Args:
        text: The present text.
        line: The line to append.
        delimiter: What ends the line.
        font: The font that the line is shown in; any but 0 is written before it as one byte.
        size: Size of the memory in bytes; what does not fit is omitted.

    Returns:
        The whole text, with a zero where there is room for it.
    """
    return (text + bytes([font] * (font != 0)) + line + delimiter + b"\0")[: max(size, 0)]
