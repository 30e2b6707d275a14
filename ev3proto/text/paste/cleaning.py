"""Blanks what is written among bytes without being one, column for column: times, casts, tags, remarks, colours.

A line keeps its length, so that a column found in the result is a column of the line.
"""

from __future__ import annotations

import re

OTHER = "\x00"
"""Replaces characters that cannot be bytes and that end a run of them."""

_COLOUR = re.compile(r"\x1b\[[0-9;?]{0,20}[A-Za-z]")
_CLOCK = r"(?:[01]?\d|2[0-3]):[0-5]\d:[0-6]\d(?:[.,]\d{1,9})?"
_FOREIGN = re.compile(
    # A UUID, a date with or without a time, a time.
    r"(?<![\w-])[0-9a-fA-F]{8}-[0-9a-fA-F]{4}-[0-9a-fA-F]{4}-[0-9a-fA-F]{4}-[0-9a-fA-F]{12}(?![\w-])"
    rf"|(?<![\w.:|-])(?:19|20)\d\d[-/.][01]\d[-/.][0-3]\d(?:[T ]\s?{_CLOCK})?(?:Z|\s?[+-]\d\d:?\d\d)?(?![\w:|-])"
    r"|(?<![\w.:|-])[0-3]\d[./][01]\d[./](?:19|20)\d\d(?![\w:|-])"
    rf"|(?<![\w.:|-]){_CLOCK}(?:Z|\s?[+-]\d\d:?\d\d)?(?=[\])>:;,-]?(?:\s|$))"
    # An address of IPv6 whose zeros are omitted.
    r"|(?<![\w:.])(?:[0-9a-fA-F]{1,4}:){1,6}:(?:[0-9a-fA-F]{1,4}:){0,5}[0-9a-fA-F]{1,4}(?:%\w+|/\d{1,3})?(?![\w:])"
    # A number with decimal places, an address on the internet; but groups of four digits are bytes.
    r"|(?<![\w.-])(?!\d{4}(?:\.\d{4}){2}\.\d\d)[-+]?\d+(?:\.\d+)+(?:e[-+]?\d+)?(?![\w.])",
    re.ASCII,
)
_CAST = re.compile(
    r"\(\s?(?:(?:un)?signed )?(?:byte|char|u?int8_t|u8|sbyte|Byte|SByte|UInt8|uint8|BYTE)\s?\)"
    r"|\.to(?:Byte|UByte|Char)\(\)|\bas (?:u8|i8|byte|Byte)\b"
    r"|\b(?:bytes|bytearray|bytes\.fromhex|byte|char|chr|Chr\$?|ord|CByte|UInt8|uint8|int8|u8|ToByte|int)(?=\s?\()"
    r"|\bb?(?=')(?='..?')",
)
_BESIDE = re.compile(
    # Characters that a debugger shows beside numbers, and types beside values.
    r"(?<=[0-9a-fA-F])\s'(?:\\(?:[0-7]{1,3}|x[0-9a-fA-F]{1,2}|[^\s\w])|\\[a-z0]|[^'\\])'"
    r"|(?<=[0-9a-fA-F])\t+(?:unsigned char|byte|uint8_t|char)\s*$"
    # The character of a byte, as interceptty shows it; what a debugger calls an address.
    r"|(?<=0x[0-9a-fA-F]{2})\s\((?:\^.|M-\^?.?|.)\)\s*$"
    r"|(?<=[0-9a-fA-F])\s<[^<>\s]{1,120}>(?=:)"
)
_ENTITY = re.compile(r"&(?:quot|apos|nbsp|lt|gt|#3[49]|#x2[27]|#160);")
_COLUMNS = re.compile(r"^\s*Columns? \d{1,5} (?:through|and) \d{1,5}:?\s*$")
_TAG = re.compile(r"</?(?![0-9a-fA-F]{2}>)[A-Za-z_][\w:.-]{0,60}\s?/?>")
# Frames of tables, blanks that do not break, smart quotes, dashes.
_LOOKALIKES = str.maketrans(
    "\u2502\u2503\u250a\u00a0\u202f\u201c\u201d\u201e\u2018\u2019\u2010\u2011\u2013\u2212", '||   """\'\'----'
)
_LEAD = re.compile(r"^\s*(?:(?://+[/!]?|#+|/\*+|\*(?!/)|;+|--+(?=\s)|'(?=\s)|REM\b|%+(?=\s)|<!--|>+(?=\s))\s?)+")
_DIRECTIVE = re.compile(
    r"^[\s\w.$@:]{0,40}?(?:\.byte|\.db|\bdb|\bDB|\bdc\.b|\bDC\.B|\bdefb|\bDEFB|\bfcb|\bFCB|(?:\d{1,5}\s+)?DATA"
    r"|\.ascii|\bBYTE)\s"
)
_REMARK = re.compile(
    r"//|(?<=[\s,;)}\]])(?:#(?![xX$\d])|;(?=\s*[^\W\d_]{2})|--(?=\s)|'(?=\s*[A-Za-z]{3})|\\{1,2}\s|%(?=\s))"
)


def blank(line: str, pattern: re.Pattern[str], character: str = " ") -> str:
    """Returns the line, each match replaced by as many characters."""
    return pattern.sub(lambda found: character * len(found[0]), line)


def clean(line: str) -> str:
    """Returns the line without what no notation of bytes has: colours, times, addresses on the internet, casts."""
    if "\x1b" in line:
        line = blank(line, _COLOUR)
    if not line.isascii():
        line = line.translate(_LOOKALIKES)
    if "." in line or ":" in line or "-" in line or "/" in line:
        line = blank(line, _FOREIGN, OTHER)
    if "'" in line or "<" in line or "\t" in line:
        line = blank(line, _BESIDE)
    if "<" in line and ">" in line:
        line = blank(line, _TAG)
    if "&" in line:
        line = blank(line, _ENTITY)
    if line.lstrip().startswith("Column"):
        line = blank(line, _COLUMNS)
    return blank(line, _CAST) if "(" in line or " as " in line or "'" in line else line


def without_marks(line: str) -> str:
    """Returns the line without the marks of a comment at its start, and without an assembler's directive."""
    for pattern in (_LEAD, _DIRECTIVE):
        found = pattern.match(line)
        if found is not None:
            line = " " * found.end() + line[found.end() :]
    return line


def without_remarks(line: str, *, is_inside: bool = False) -> tuple[str, bool]:
    """Returns the line without its comments, and whether a comment continues in the next line.

    Args:
        line: A line.
        is_inside: It begins inside a comment.
    """
    parts: list[str] = []
    position = 0
    while True:
        if is_inside:
            end = line.find("*/", position)
            if end < 0:
                return "".join([*parts, " " * (len(line) - position)]), True
            parts.append(" " * (end + 2 - position))
            position = end + 2
        begin = line.find("/*", position)
        if begin < 0:
            break
        parts.append(line[position:begin])
        position, is_inside = begin, True
        parts.append("  ")
        position += 2
    line = "".join([*parts, line[position:]])
    found = _REMARK.search(line, len(line) - len(line.lstrip()) + 1)
    return (line if found is None else line[: found.start()] + " " * (len(line) - found.start())), False
