"""The columns of a dump that are no bytes: the offset in front of a row, and the same bytes as text after it.

A column of text is known by what it says: each printable byte stands there as its character. An offset is known by its
digits, what follows it, and whether it counts the bytes of the rows before.
"""

from __future__ import annotations

import re
from collections.abc import Collection

from ev3proto.text.late_pattern import late_pattern
from ev3proto.text.paste.blanking import OTHER

_OFFSET = late_pattern(
    r"^(?P<before>(?:.{0,80}?[\s\])>:|[])??)(?P<offset>(?:0[xX])?[0-9a-fA-F]{4,16})(?P<mark>\]|[:hH]?(?:\s?[|:])?|\s{1,130}:)(?P<blanks>\s++)"
    r"(?=-?[0-9a-fA-F\\])"
)
_ROW_OFFSET = late_pattern(r"\s*(?:0[xX])?(?P<offset>[0-9a-fA-F]{4,16}):?(?=\s|$)")
_ONLY_OFFSET = late_pattern(r"^\s*(?P<offset>[0-9a-fA-F]{7,8}):?\s*$")
_GROUP = late_pattern(r"(?P<digits>(?:[0-9a-fA-F]{2}){1,32})(?![^\s|])(?P<blanks>\s*+)")
_MORE = late_pattern(r"(?:[0-9a-fA-F]{2,8}(?:\s{1,4}|$)){2,}|[0-9a-fA-F]{2,8}(?:\s*$|\s{2,}\S)")
_PAIR = late_pattern(r"[0-9a-fA-F]{2}")
_MOST_TEXT = 1 << 10
_NUMBERS = late_pattern(r"[\s\d-]+")
_MOST_GROUPS = 64
_MOST_ROW = 16


def without_columns(line: str, counts: Collection[int] = ()) -> str:
    """The line without offset and text column, if it is the row of a dump.

    Args:
        line: A line, cleaned.
        counts: How many bytes the rows before it have, in each reading of them.
    """
    alone = _ONLY_OFFSET.match(line)
    if alone is not None and _numbers(alone["offset"]) & {*counts} - {0}:
        return " " * len(line)
    start = 0
    offset = _OFFSET.match(line)
    if offset is not None and _is_offset(line, offset, counts):
        start = offset.end()
        line = " " * start + line[start:] if not offset["before"].strip() else _covered(line, offset)
    else:
        offset = None
    return _without_text(line, start, has_offset=offset is not None)


def repeated_rows(before: str, line: str, size: int, count: int) -> int | None:
    """How many rows like the one before a `*` stands for.

    Args:
        before: The row in front of the `*`.
        line: The row after it, or the offset alone that ends a dump.
        size: How many bytes that row has.
        count: How many bytes all rows have up to the `*`.

    Returns:
        The number of rows; None where the offsets do not tell it.
    """
    first, second = _ROW_OFFSET.match(before), _ROW_OFFSET.match(line)
    if first is None or second is None or size == 0:
        return None
    for base in (16, 10, 8):
        try:
            begin, end = int(first["offset"], base), int(second["offset"], base)
        except ValueError:
            continue
        missing = end - count
        if 0 < begin == count - size and missing > 0 and missing % size == 0:
            return missing // size
    return None


def _covered(line: str, offset: re.Match[str]) -> str:
    begin = offset.start("offset")
    return line[:begin] + " " * (offset.end() - begin) + line[offset.end() :]


def _is_offset(line: str, offset: re.Match[str], counts: Collection[int]) -> bool:
    """Whether the digits are an offset: zero, the bytes so far, or written as nothing but an offset is."""
    digits = offset["offset"].lower().removeprefix("0x")
    numbers = _numbers(digits)
    if numbers & {count for count in counts if count}:
        return True
    group = _GROUP.match(line, offset.end())
    width = len(group["digits"]) if group is not None else 0
    is_set_off = ":" in offset["mark"] or len(offset["blanks"]) > 1 or "\t" in offset["blanks"]
    if numbers == {0}:
        # No frame begins with four zeros, nor with two and a report number.
        is_in_words = (len(digits), width) in ((4, 8), (8, 4), (8, 8))
        return is_set_off or len(digits) in (6, 7) or width == 2 or is_in_words
    is_address = offset["offset"][:2] in ("0x", "0X") and len(digits) >= 6
    if is_address and width == 2 and len(offset["blanks"]) > 1:
        return True
    return not offset["before"].strip() and (
        ":" in offset["mark"] or (width == 2 and (len(offset["blanks"]) > 1 or len(digits) in (6, 7)))
    )


def _numbers(digits: str) -> set[int]:
    """The numbers that the digits of an offset may mean: od counts in octal."""
    numbers = {int(digits, 16)}
    if digits.isdecimal():
        numbers.add(int(digits))
    if set(digits) <= set("01234567"):
        numbers.add(int(digits, 8))
    return numbers


def _without_text(line: str, start: int, *, has_offset: bool) -> str:
    """The line without the column of text."""
    first = _PAIR.search(line, start)
    if first is None:
        return line
    position = first.start()
    if not has_offset and line[:position].strip(" \t" + OTHER):
        return line
    data = bytearray()
    for _ in range(_MOST_GROUPS):
        group = _GROUP.match(line, position)
        if group is None:
            break
        data += bytes.fromhex(group["digits"])
        position = group.end()
        text = line[position:]
        if not text:
            return line
        is_wide = len(group["blanks"]) > 1 or text[0] in "|>"
        if not is_wide:
            if has_offset and len(data) == _MOST_ROW and _PAIR.match(text) is None:
                return line[:position] + " " * len(text)
            continue
        if _says(text, data):
            return line[:position] + " " * len(text)
        if len(text) > _MOST_TEXT or _NUMBERS.fullmatch(text):
            continue
        # Wider gaps than one blank stand between groups of bytes, too; more bytes follow those.
        if has_offset and (text[0] == "|" or _MORE.match(text) is None):
            return line[:position] + " " * len(text)
    return line


def _says(text: str, data: bytearray) -> bool:
    """Whether the text is that of the bytes."""
    if len(text) > _MOST_TEXT:
        return False
    shown = text.strip()
    if len(shown) > 2 and shown[0] in "|>" and shown[-1] in "|<":
        shown = shown[1:-1]
    shown = "".join(shown.split())
    known = [byte for byte in data if byte != 0x20]
    if len(shown) != len(known):
        return False
    return all(chr(byte) == character or not 0x20 < byte < 0x7F for byte, character in zip(known, shown, strict=True))
