"""What stands among bytes and is none is blanked, column for column: times, casts, indexes, remarks, offsets, colours.

A line keeps its length, so that a column found in what is left is a column of the line.
"""

from __future__ import annotations

import re

from ev3proto.text.late_pattern import late_pattern

OTHER = "\x00"
"""Stands for characters that cannot be bytes and that end a run of them."""

_COLOUR = late_pattern(r"\x1b\[[0-9;?]{0,20}[A-Za-z]")
_CLOCK = r"(?:[01]?\d|2[0-3]):[0-5]\d:[0-6]\d(?:[.,]\d{1,9})?"
_FOREIGN = late_pattern(
    # A UUID, a date with or without a time, a time.
    r"(?<![\w-])[0-9a-fA-F]{8}-[0-9a-fA-F]{4}-[0-9a-fA-F]{4}-[0-9a-fA-F]{4}-[0-9a-fA-F]{12}(?![\w-])"
    rf"|(?<![\w.:|-])(?:19|20)\d\d[-/.][01]\d[-/.][0-3]\d(?:[T ]\s?{_CLOCK})?(?:Z|\s?[+-]\d\d:?\d\d)?(?![\w:|-])"
    r"|(?<![\w.:|-])[0-3]\d[./][01]\d[./](?:19|20)\d\d(?![\w:|-])"
    rf"|(?<![\w.:|-]){_CLOCK}(?:Z|\s?[+-]\d\d:?\d\d)?(?=[\])>:;,-]?(?:\s|$))"
    # An address of IPv6 whose zeros are omitted.
    r"|(?<![\w:.])(?:[0-9a-fA-F]{1,4}:){1,6}:(?:[0-9a-fA-F]{1,4}:){0,5}[0-9a-fA-F]{1,4}(?:%\w+|/\d{1,3})?(?![\w:])"
    # A number with a unit or decimal places; an address on the internet.
    # Groups of four digits are bytes, where there are more than in a hardware address.
    r"|(?<![\w.-])(?!\d{4}(?:\.\d{4}){2}\.\d\d)[-+]?\d+(?:\.\d+)+(?:e[-+]?\d+)?(?![\w.])",
    re.ASCII,
)
_CAST = late_pattern(
    r"\(\s?(?:(?:un)?signed )?(?:byte|char|u?int8_t|u8|sbyte|Byte|SByte|UInt8|uint8|BYTE)\s?\)"
    r"|\.to(?:Byte|UByte|Char)\(\)|\bas (?:u8|i8|byte|Byte)\b"
    r"|\b(?:bytes|bytearray|bytes\.fromhex|byte|char|chr|Chr\$?|ord|CByte|UInt8|uint8|int8|u8|ToByte|Word8|fromIntegral|int)(?=\s?\()"
    r"|\bb?(?=')(?='..?')",
)
_BESIDE = late_pattern(
    # Characters that a debugger shows beside numbers, and types beside values.
    r"(?<=[0-9a-fA-F])\s'(?:\\(?:[0-7]{1,3}|x[0-9a-fA-F]{1,2}|[^\s\w])|\\[a-z0]|[^'\\])'"
    r"|(?<=[0-9a-fA-F])\t+(?:unsigned char|byte|uint8_t|char)\s*$"
    # The character of a byte, as interceptty shows it.
    r"|(?<=0x[0-9a-fA-F]{2})\s\((?:\^.|M-\^?.?|.)\)\s*$"
    # What a debugger calls an address, and the upper half of one.
    r"|(?<=[0-9a-fA-F])\s<[^<>\s]{1,120}>(?=:)|^[0-9a-fA-F]{8}`(?=[0-9a-fA-F]{8}\s)"
)
_ENTITY = late_pattern(r"&(?:quot|apos|nbsp|lt|gt|#3[49]|#x2[27]|#160);")
_COLUMNS = late_pattern(r"^\s*Columns? \d{1,5} (?:through|and) \d{1,5}:?\s*$")
_MIDDLE = late_pattern(r"(?<=\s[0-9a-fA-F]{2}\s[0-9a-fA-F]{2})-(?=[0-9a-fA-F]{2}(?:\s|$))")
"""The mark in the middle of a row, as in `80 00 00 94-01 81 02 82`."""
_INTEL = late_pattern(r":(?P<record>(?:[0-9a-fA-F]{2}){5,260})\s*")
_INTEL_BEFORE = 4
"""Bytes in front of the data of a record of Intel HEX: its size, two of its address, its type."""
_INTEL_AROUND = _INTEL_BEFORE + 1
_INTEL_TYPE = 3
_MOTOROLA = late_pattern(r"S(?P<type>[0-35-9])(?P<record>(?:[0-9a-fA-F]{2}){4,256})\s*")
_MOTOROLA_ADDRESS = {"1": 2, "2": 3, "3": 4}
"""Bytes of the address in an S-record that has data, by its type."""
_TAG = late_pattern(r"</?(?![0-9a-fA-F]{2}>)[A-Za-z_][\w:.-]{0,60}\s?/?>")
_FRAMES_OF_TABLES = str.maketrans("\u2502\u2503\u250a\u00a0\u202f", "||   ")
_DIRECTIVE = late_pattern(
    r"^(?P<before>[\s\w.$@:]{0,40}?)(?P<word>(?:\.byte|\.db|\bdb|\bDB|\bdc\.b|\bDC\.B|\bdefb|\bDEFB|\bfcb|\bFCB"
    r"|(?:\d{1,5}\s+)?DATA|\.ascii|\.short8|\bBYTE)\s)"
)
_LEAD = late_pattern(
    r"^(?P<blank>\s*)(?P<mark>(?://+[/!]?|#+|/\*+|\*(?!/)|;+|--+(?=\s)|'(?=\s)|REM\b|%+(?=\s)|<!--|>(?=\s))\s?)+"
)
_REMARK = late_pattern(
    r"(?://|(?<=[\s,;)}\]])(?:#(?![xX$\d])|;(?=\s*[^\W\d_]{2})|--(?=\s)|'(?=\s*[A-Za-z]{3})|\\{1,2}\s|%(?=\s)))"
)
_COMMENT = late_pattern(r"/\*(?>(?:(?!\*/).)*)(?:\*/)?")
_SUBSCRIPT = late_pattern(r"(?:\b[A-Za-z_][\w.>-]{0,40})?\[\s?(?P<index>0|[1-9]\d{0,4})\]\s{0,4}(?:=>?|:|\t)\s{0,4}")
_NUMBERED = late_pattern(
    r"^\s*\[?(?P<index>0|[1-9]\d{0,4})\]?\s?[\t,;]\s*(?=(?:0x)?[0-9a-fA-F]{1,3}(?:[\t,; (]{1,8}\S{1,6}){0,2}\s*$)"
)
_TWICE = late_pattern(
    r"(?P<hex>(?<![\w(])(?:0[xX]|&[hH]|\$)[0-9a-fA-F]{1,2})(?P<again>[\s,;=(]{1,8}(?P<decimal>\d{1,3})\)?)(?!\w)"
)
_FIRST_OF_TWO = late_pattern(
    r"\b[A-Za-z_][\w.>-]{0,60}\(\s?(?P<index>0|[1-9]\d{0,4}),\s{0,20}(?=(?:0[xX])?[0-9a-fA-F]{1,3}\s?\))"
)
_SECOND_OF_TWO = late_pattern(
    r"(?<=[(\s])(?P<value>(?:0[xX])?[0-9a-fA-F]{1,3}),\s{0,4}(?P<index>0|[1-9]\d{0,4})(?=\s?\))"
)
_KEY = late_pattern(
    r"(?<![\w\"'.])(?P<quote>[\"']?)(?P<index>0|[1-9]\d{0,4})(?P=quote)\s?(?:=>|:)(?:\s{1,4}|(?<=[\"']:))"
)


def blank(line: str, pattern: re.Pattern[str], character: str = " ") -> str:
    """The line, each match replaced by so many characters."""
    return pattern.sub(lambda found: character * len(found[0]), line)


def clean(line: str) -> str:
    """The line without what no notation of bytes has: colours, times, addresses on the internet, casts."""
    if "\x1b" in line:
        line = blank(line, _COLOUR)
    if not line.isascii():
        line = line.translate(_FRAMES_OF_TABLES)
    if "." in line or ":" in line or "-" in line or "/" in line:
        line = blank(line, _FOREIGN, OTHER)
    if "'" in line or "<" in line or "`" in line or "\t" in line:
        line = blank(line, _BESIDE)
    if "<" in line and ">" in line:
        line = blank(line, _TAG)
    if "0x" in line or "$" in line or "&" in line:
        line = _TWICE.sub(_once, line)
    if "&" in line:
        line = blank(line, _ENTITY)
    if "-" in line:
        line = blank(line, _MIDDLE)
    line = without_record(line)
    if line.lstrip().startswith("Column"):
        line = blank(line, _COLUMNS)
    return blank(line, _CAST) if "(" in line or " as " in line or "'" in line else line


def without_record(line: str) -> str:
    """A record of Intel HEX or Motorola's S-records without what is around its data: size, address, type, check sum.

    Nothing is left of a record that has no data. A line that is no such record, by its size or its check sum, stays.
    """
    if line.startswith(":"):
        return _without_intel(line)
    return _without_motorola(line) if line.startswith("S") else line


def _without_intel(line: str) -> str:
    found = _INTEL.fullmatch(line)
    if found is None:
        return line
    record = bytes.fromhex(found["record"])
    if len(record) != record[0] + _INTEL_AROUND or sum(record) & 0xFF:
        return line
    return _only_data(line, found, None if record[_INTEL_TYPE] else _INTEL_BEFORE)


def _without_motorola(line: str) -> str:
    found = _MOTOROLA.fullmatch(line)
    if found is None:
        return line
    record = bytes.fromhex(found["record"])
    if len(record) != record[0] + 1 or sum(record) & 0xFF != 0xFF:
        return line
    address = _MOTOROLA_ADDRESS.get(found["type"])
    return _only_data(line, found, None if address is None else address + 1)


def _only_data(line: str, found: re.Match[str], before: int | None) -> str:
    """A record without so many bytes in front of its data and without its check sum; None stands for all of it."""
    if before is None:
        return " " * len(line)
    start, end = found.start("record") + 2 * before, found.end("record") - 2
    return " " * start + line[start:end] + " " * (len(line) - end)


def without_marks(line: str) -> str:
    """The line without the marks of a comment at its start, and without an assembler's directive."""
    found = _LEAD.match(line)
    if found is not None:
        line = " " * found.end() + line[found.end() :]
    found = _DIRECTIVE.match(line)
    if found is not None:
        line = " " * found.end() + line[found.end() :]
    return line


def without_remarks(line: str, *, is_inside: bool = False) -> tuple[str, bool]:
    """The line without its comments, and whether a comment goes on in the next line.

    Args:
        line: A line.
        is_inside: It begins inside a comment.
    """
    if is_inside:
        end = line.find("*/")
        if end < 0:
            return " " * len(line), True
        line = " " * (end + 2) + line[end + 2 :]
    stays_open = False
    if "/*" in line:
        last = line.rfind("/*")
        stays_open = "*/" not in line[last:]
        line = blank(line, _COMMENT)
    found = _REMARK.search(line, len(line) - len(line.lstrip()) + 1)
    if found is not None:
        line = line[: found.start()] + " " * (len(line) - found.start())
    return line, stays_open


def without_number(line: str, expected: int | None) -> tuple[str, int | None]:
    """The line without the number of its byte in front, as tables of one byte a line have it: `12,0x82`.

    Args:
        line: A line.
        expected: The number that it must have; None for the first line, which has zero.

    Returns:
        The line, and the number of the next; None where the line has none.
    """
    found = _NUMBERED.match(line)
    if found is None or int(found["index"]) != (expected or 0):
        return line, None
    return " " * found.end() + line[found.end() :], int(found["index"]) + 1


def _once(found: re.Match[str]) -> str:
    """The number, without the same in decimal after it."""
    is_same = int(found["hex"].lower().lstrip("0x&h$") or "0", 16) == int(found["decimal"])
    return found["hex"] + " " * len(found["again"]) if is_same else found[0]


def without_indexes(line: str, expected: int) -> tuple[str, int]:
    """The line without the indexes of an array (`0: 15, 1: 0`, `cmd[0] = 15;`, `setUint8(0, 15)`), which must count up.

    Args:
        line: A line.
        expected: The index that may stand first.

    Returns:
        The line, and the index after the last.
    """
    for pattern in (_SUBSCRIPT, _KEY, _FIRST_OF_TWO, _SECOND_OF_TWO):
        found = pattern.search(line)
        if found is None or int(found["index"]) not in (0, expected):
            continue
        following = int(found["index"])
        parts = []
        position = 0
        for found in pattern.finditer(line):
            if int(found["index"]) != following:
                break
            following += 1
            # The value may stand in front of its index.
            start = found.end("value") if pattern is _SECOND_OF_TWO else found.start()
            parts += [line[position:start], " " * (found.end() - start)]
            position = found.end()
        return "".join(parts) + line[position:], following
    return line, expected
