"""The columns of a dump that are not its bytes: the offset in front of a row, and the same bytes as text after it.

A column of text is recognised by its content: each printable byte is its character. An offset is recognised by its
digits, by what follows it, and by whether it counts the bytes of the rows before.
"""

from __future__ import annotations

import re
from collections.abc import Collection

from ev3proto.tables.frame import MAX_FRAME
from ev3proto.text.paste.cleaning import OTHER, blanked

_OFFSET = re.compile(
    r"^(?P<before>(?:.{0,80}?[\s\])>:|[])??)(?P<offset>(?:0[xX])?[0-9a-fA-F]{4,16})"
    r"(?P<mark>\]|[:hH]?(?:\s?[|:])?|\s{1,130}:)(?P<blanks>\s{1,200})(?=-?[0-9a-fA-F\\])"
)
_ENDS_IN_BYTE = re.compile(r"(?:^|\s)[0-9a-fA-F]{2}\s$")
_ROW_OFFSET = re.compile(r"\s*(?:0[xX])?(?P<offset>[0-9a-fA-F]{4,16}):?(?=\s|$)")
_ONLY_OFFSET = re.compile(r"^\s*(?P<offset>[0-9a-fA-F]{6,8}):?\s*$")
_GROUP = re.compile(r"(?P<digits>(?:[0-9a-fA-F]{2}){1,32})(?![^\s|])(?P<blanks>\s*)")
_MORE = re.compile(r"(?:[0-9a-fA-F]{2,8}(?:\s{1,4}|$)){2,}|[0-9a-fA-F]{2,8}(?:\s*$|\s{2,}\S)")
_PAIR = re.compile(r"[0-9a-fA-F]{2}")
_NUMBERS = re.compile(r"[\s\d-]+")
_MOST_TEXT = 1 << 10
_MOST_GROUPS = 64
_ROW = 16


def without_columns(line: str, counts: Collection[int] = ()) -> str:
    """Returns the line without offset and text column, if it is the row of a dump.

    Args:
        line: A line, cleaned.
        counts: How many bytes the rows before it have, in each reading of them.
    """
    alone = _ONLY_OFFSET.match(line)
    if alone is not None and {*_numbers(alone["offset"]).values()} & {*counts} - {0}:
        return " " * len(line)
    offset = _OFFSET.match(line)
    if offset is None or not _is_offset(line, offset, {*counts} - {0}):
        return _without_text(line, 0, has_offset=False)
    begin = offset.start("offset") if offset["before"].strip() else 0
    return _without_text(blanked(line, begin, offset.end()), offset.end(), has_offset=True)


def repeated_rows(before: str, line: str, size: int, count: int) -> int | None:
    """Returns how many rows a `*` replaces; None where the offsets do not tell.

    Args:
        before: The row in front of the `*`.
        line: The row after it, or the offset alone that ends a dump.
        size: How many bytes that row has.
        count: How many bytes all rows have up to the `*`.
    """
    first, second = _ROW_OFFSET.match(before), _ROW_OFFSET.match(line)
    if first is not None and second is not None and size:
        begins, ends = _numbers(first["offset"]), _numbers(second["offset"])
        for base in begins.keys() & ends.keys():
            missing = ends[base] - count
            if 0 < begins[base] == count - size and 0 < missing <= MAX_FRAME and missing % size == 0:
                return missing // size
    return None


def _is_offset(line: str, offset: re.Match[str], counts: Collection[int]) -> bool:
    """Whether the digits are an offset: zero, the bytes so far, or in a format that only offsets have."""
    digits = offset["offset"].lower().removeprefix("0x")
    numbers = {*_numbers(digits).values()}
    if numbers & {*counts}:
        return True
    group = _GROUP.match(line, offset.end())
    width = len(group["digits"]) if group is not None else 0
    is_wide = len(offset["blanks"]) > 1
    if _ENDS_IN_BYTE.search(offset["before"]):
        return False
    if numbers == {0}:
        # No frame begins with four zeros, nor with two and a report number.
        is_in_words = (len(digits), width) in ((4, 8), (8, 4), (8, 8))
        is_set_off = ":" in offset["mark"] or is_wide or "\t" in offset["blanks"]
        return is_set_off or len(digits) in (6, 7) or width == 2 or is_in_words
    if offset["offset"][:2] in ("0x", "0X") and len(digits) >= 6 and width == 2 and is_wide:
        return True
    is_row = ":" in offset["mark"] or (width == 2 and (is_wide or len(digits) in (6, 7)))
    return is_row and not offset["before"].strip()


def _numbers(digits: str) -> dict[int, int]:
    """Returns the numbers that the digits of an offset may mean, by base: od counts in octal."""
    bases = [16, *(base for base, known in ((10, "0123456789"), (8, "01234567")) if {*digits} <= {*known})]
    return {base: int(digits, base) for base in bases}


def _without_text(line: str, start: int, *, has_offset: bool) -> str:
    """Returns the line without the column of text."""
    first = _PAIR.search(line, start)
    if first is None or (not has_offset and line[: first.start()].strip(" \t" + OTHER)):
        return line
    position = first.start()
    data = bytearray()
    for _ in range(_MOST_GROUPS):
        group = _GROUP.match(line, position)
        if group is None or group.end() == len(line):
            break
        data += bytes.fromhex(group["digits"])
        position = group.end()
        if len(group["blanks"]) < 2 and line[position] not in "|>":
            if has_offset and len(data) == _ROW and _PAIR.match(line, position) is None:
                return blanked(line, position, len(line))
        elif len(line) - position <= _MOST_TEXT:
            text = line[position:]
            # Wider gaps than one blank also separate groups of bytes; more bytes follow those.
            may_be = has_offset and not _NUMBERS.fullmatch(text)
            is_set_off = text[0] == "|" or len(group["blanks"]) > _ROW or _MORE.match(text) is None
            if _says(text, data) or (may_be and is_set_off):
                return blanked(line, position, len(line))
    return line


def _says(text: str, data: bytearray) -> bool:
    """Whether the text is that of the bytes."""
    shown = text.strip()
    if len(shown) > 2 and shown[0] in "|>" and shown[-1] in "|<":
        shown = shown[1:-1]
    shown = "".join(shown.split())
    known = [byte for byte in data if byte != 0x20]
    return len(shown) == len(known) and all(
        chr(byte) == character or not 0x20 < byte < 0x7F for byte, character in zip(known, shown, strict=True)
    )
