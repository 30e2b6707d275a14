"""Blanks or rewrites what is written among bytes without being one: times, casts, tags, remarks, the columns of dumps.

A line keeps its length, so that a column found in the result is a column of the line. The offset in front of the row of
a dump is recognised by its digits, by what follows it, and by whether it counts the bytes of the rows before; the same
bytes as text after it by its content: each printable byte is its character.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection

from ev3proto.tables.frame import MAX_FRAME

OTHER = "\x00"
"""Replaces characters that cannot be bytes and that end a run of them."""

_CLOCK = r"(?:[01]?\d|2[0-3]):[0-5]\d:[0-6]\d(?:[.,]\d{1,9})?"
_FOREIGN = (
    # A UUID, a date with or without a time, a time.
    r"(?<![\w-])[0-9a-fA-F]{8}-[0-9a-fA-F]{4}-[0-9a-fA-F]{4}-[0-9a-fA-F]{4}-[0-9a-fA-F]{12}(?![\w-])"
    rf"|(?<![\w.:|-])(?:19|20)\d\d[-/.][01]\d[-/.][0-3]\d(?:[T ]\s?{_CLOCK})?(?:Z|\s?[+-]\d\d:?\d\d)?(?![\w:|-])"
    r"|(?<![\w.:|-])[0-3]\d[./][01]\d[./](?:19|20)\d\d(?![\w:|-])"
    rf"|(?<![\w.:|-]){_CLOCK}(?:Z|\s?[+-]\d\d:?\d\d)?(?=[\])>:;,-]?(?:\s|$))"
    # An address of IPv6 whose zeros are omitted.
    r"|(?<![\w:.])(?:[0-9a-fA-F]{1,4}:){1,6}:(?:[0-9a-fA-F]{1,4}:){0,5}[0-9a-fA-F]{1,4}(?:%\w+|/\d{1,3})?(?![\w:])"
    # A number with decimal places, an address on the internet; but groups of four digits are bytes.
    r"|(?<![\w.-])(?!\d{4}(?:\.\d{4}){2}\.\d\d)[-+]?\d+(?:\.\d+)+(?:e[-+]?\d+)?(?![\w.])"
)
_CAST = (
    r"\(\s?(?:(?:un)?signed )?(?:byte|char|u?int8_t|u8|sbyte|Byte|SByte|UInt8|uint8|BYTE)\s?\)"
    r"|\.to(?:Byte|UByte|Char)\(\)|\bas (?:u8|i8|byte|Byte)\b"
    r"|\b(?:bytes|bytearray|bytes\.fromhex|byte|char|chr|Chr\$?|ord|CByte|UInt8|uint8|int8|u8|ToByte|int)(?=\s?\()"
    r"|\bb?(?=')(?='..?')"
)
_BESIDE = (
    # Characters that a debugger shows beside numbers, and types beside values.
    r"(?<=[0-9a-fA-F])\s'(?:\\(?:[0-7]{1,3}|x[0-9a-fA-F]{1,2}|[^\s\w])|\\[a-z0]|[^'\\])'"
    r"|(?<=[0-9a-fA-F])\t+(?:unsigned char|byte|uint8_t|char)\s*$"
    # The character of a byte, as interceptty shows it; what a debugger calls an address.
    r"|(?<=0x[0-9a-fA-F]{2})\s\((?:\^.|M-\^?.?|.)\)\s*$"
    r"|(?<=[0-9a-fA-F])\s<[^<>\s]{1,120}>(?=:)"
)
_HEX = "[0-9a-fA-F]"


def _each(pattern: str, replacement: str) -> Callable[[re.Match[str]], str]:
    return lambda found: re.sub(pattern, replacement, found[0])


_BLANKED = _each(".", " ")
_REWRITES: tuple[tuple[str, str, str | Callable[[re.Match[str]], str]], ...] = (
    ("\x1b", r"\x1b\[[0-9;?]{0,20}[A-Za-z]", _BLANKED),
    (".:-/", f"(?a:{_FOREIGN})", _each(".", OTHER)),
    ("'<\t", _BESIDE, _BLANKED),
    ("<", r"</?(?![0-9a-fA-F]{2}>)[A-Za-z_][\w:.-]{0,60}\s?/?>", _BLANKED),
    ("&", r"&(?:quot|apos|nbsp|lt|gt|#3[49]|#x2[27]|#160);", _BLANKED),
    ("C", r"^\s*Columns? \d{1,5} (?:through|and) \d{1,5}:?\s*$", _BLANKED),
    ("('s", _CAST, _BLANKED),
    # Pairs of digits with a mark in front of each or between them: 0x0f0x00, %0F%00, =0F=00, 0f.00, 0f_00, 0f00.2a00.
    ("xX", rf"(?<![\w.])0[xX]{_HEX}{{2}}(?:0[xX]{_HEX}{{2}})+(?!\w)", _each("0[xX](..)", r"\1  ")),
    ("%=", rf"(?:%{_HEX}{{2}}){{5,}}|(?:=[0-9A-F]{{2}}){{2,}}=?(?!\w)", _each("[%=](..)?", r"\1 ")),
    ("_.", rf"(?<![\w.]){_HEX}{{2}}(?:[_.]{_HEX}{{2}}){{4,}}(?!\w)", _each("[_.]", " ")),
    (".", rf"(?<![\w.]){_HEX}{{4}}(?:\.{_HEX}{{4}}){{2,}}(?:\.{_HEX}{{2}})?(?![\w.])", _each(r"\.", " ")),
    ("#", rf"(?:#(?:\$?{_HEX}{{2}}|\d{{1,3}})){{5,}}(?!\w)", _each(r"#(\$?\w+)", r"\1 ")),
    # Marks that mean 0x: 8'h0f, &H0F, 16#0F#, 16r0F, #x0F.
    (
        "'#r&",
        rf"(?<!\w)(?:\d{{1,2}}'[hH]|&[hH]|16[#r]|#[xX])(?={_HEX}{{1,2}}(?![^\W#&]))",
        lambda found: "0x".rjust(len(found[0])),
    ),
    # What replaces an unknown counter in a frame without blanks.
    ("xXmM", rf"(?<![\w.])({_HEX}{{4}})(?:[xX]{{4}}|[mM]{{4}})(?={_HEX}{{2,}}(?!\w))", r"\g<1>0000"),
)
"""What is rewritten: characters one of which is in the line, the pattern, what replaces it or each character of it.

Compiled when first needed, as few lines have any of them: all of them take 5 ms.
"""

# Frames of tables, blanks that do not break, smart quotes, dashes.
_LOOKALIKES = str.maketrans(
    "\u2502\u2503\u250a\u00a0\u202f\u201c\u201d\u201e\u2018\u2019\u2010\u2011\u2013\u2212", '||   """\'\'----'
)
_LEAD = re.compile(
    r"^\s*(?:(?:(?://+[/!]?|#+|/\*+|\*(?!/)|;+|--+(?=\s)|'(?=\s)|REM\b|%+(?=\s)|<!--|>+(?=\s))\s?)+)?"
    # Among pairs of digits, db is a byte.
    rf"(?:(?!\s*(?:{_HEX}{{2}}\s+)+{_HEX}{{2}}\s*$)[\s\w.$@:]{{0,40}}?"
    rf"(?:\.byte|\.db|(?<!\b{_HEX}{{2}}\s)(?<!\b{_HEX}{{2}}\s\s)(?:\bdb|\bDB)|\bdc\.b|\bDC\.B|\bdefb|\bDEFB|\bfcb|\bFCB"
    r"|(?:\d{1,5}\s+)?DATA"
    r"|\.ascii|\bBYTE)\s)?"
)
_REMARK = re.compile(
    r"//|(?<=[\s,;)}\]])(?:#(?![xX$\d])|;(?=\s*[^\W\d_]{2})|--(?=\s)|'(?=\s*[A-Za-z]{3})|\\{1,2}\s|%(?=\s))"
)
_CELLS = re.compile(r"\s*[0-7]{7}(?: (?: {2}[ \S]| \\[0abtnvfr]|[0-7]{3}))+\s*")
_CELL = re.compile(r" (?:  ([ \S])| (\\.)|([0-7]{3}))")
_CODES = {f"\\{letter}": code for letter, code in zip("0abtnvfr", (0, 7, 8, 9, 10, 11, 12, 13), strict=True)}


def clean(line: str, *, has_cells: bool = False) -> str:
    """Returns the line without what no notation of bytes has: colours, times, addresses on the internet, casts.

    Args:
        line: A line.
        has_cells: The line before is one of `od -c`; otherwise one has an escape.
    """
    if not line.isascii():
        line = line.translate(_LOOKALIKES)
    if (has_cells or "\\" in line) and _CELLS.fullmatch(line):
        # Cells of four columns become octal escapes. hexdump fills its last row with blanks, which are not cells.
        cells = line if line.endswith(" " * 4) and not line.endswith(" " * 5) else line.rstrip()
        return " " * 7 + _CELL.sub(lambda cell: f"\\{_code(*cell.groups()):03o}", cells.lstrip()[7:])
    for marks, pattern, new in _REWRITES:
        if any(map(line.__contains__, marks)):
            line = re.sub(pattern, new, line)
    return line


def _code(character: str | None, escape: str | None, octal: str | None) -> int:
    return ord(character) if character else int(octal, 8) if octal else _CODES[escape or ""]


def blanked(line: str, start: int, end: int) -> str:
    """Returns the line with blanks in those columns."""
    return line[:start] + " " * (end - start) + line[end:]


def without_marks(line: str) -> str:
    """Returns the line without the marks of a comment at its start, and without an assembler's directive."""
    lead = _LEAD.match(line)
    return line if lead is None else blanked(line, 0, lead.end())


def without_remarks(line: str, *, is_inside: bool = False) -> tuple[str, bool]:
    """Returns the line without its comments, and whether a comment continues in the next line.

    Args:
        line: A line.
        is_inside: It begins inside a comment.
    """
    parts: list[str] = []
    position = 0
    while is_inside or (begin := line.find("/*", position)) >= 0:
        if not is_inside:
            parts.append(line[position:begin])
        start = position if is_inside else begin
        end = line.find("*/", start if is_inside else start + 2)
        position, is_inside = (len(line), True) if end < 0 else (end + 2, False)
        parts.append(" " * (position - start))
        if is_inside:
            return "".join(parts), True
    line = "".join([*parts, line[position:]])
    found = _REMARK.search(line, len(line) - len(line.lstrip()) + 1)
    return (line if found is None else blanked(line, found.start(), len(line))), False


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
