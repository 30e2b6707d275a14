"""The byte values in a line and the runs that they form, whatever notation they are written in.

A value knows how it is written; what it is worth depends on the reading of the whole run: `10` is sixteen or ten.
"""

from __future__ import annotations

import base64
import binascii
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from ev3proto.tables.frame import MAX_FRAME
from ev3proto.text.late_pattern import late_pattern
from ev3proto.text.paste.blanking import OTHER, blank
from ev3proto.text.paste.constants import constant_bytes
from ev3proto.text.paste.literals import literal


class Style(StrEnum):
    """How a value is written.

    BARE     digits without a mark, whose base nobody knows yet
    MARKED   digits with a mark of their base, such as 0x0F, $0F, 0Fh
    LONG     many hex digits with one mark in front: 0x0f000000
    STRING   a string literal, or the escapes of one
    NAME     a name of the tables
    UNKNOWN  `xx` or `MM`, which stands for any byte
    BASE64   a word that may be base64 or base32
    """

    BARE = "bare"
    MARKED = "marked"
    LONG = "long"
    STRING = "string"
    NAME = "name"
    UNKNOWN = "unknown"
    BASE64 = "base64"


@dataclass(frozen=True, slots=True)
class Value:
    """A value in a line.

    start, end  its columns
    text        what its reading needs: the digits, or the body of a string
    data        its bytes, where every reading gives the same
    """

    start: int
    end: int
    style: Style
    text: str
    data: bytes | None = None


@dataclass(slots=True)
class Run:
    """Values in a row.

    values    the values
    gaps      what stands between a value and the one in front of it, as a class of its own; empty for the first
    is_head   nothing but brackets and the like stands in front of them in their line
    is_tail   nothing but these follows them
    opened    brackets that were opened and not closed: by what stands in front, and between and after them
    is_cut    an ellipsis follows
    has_comma a comma follows
    lines     the line of each value, where the run has several
    is_array  they are one list in brackets, in which the end of a line means nothing
    changes   the values in front of which the way of writing changes, once somebody asked
    check_sum a byte that may follow the last frame, as the text says
    known     what was found out about its readings
    """

    values: list[Value]
    gaps: list[str]
    is_head: bool = False
    is_tail: bool = False
    opened: int = 0
    depth: int = 0
    is_cut: bool = False
    has_comma: bool = False
    lines: list[int] = field(default_factory=list)
    changes: frozenset[int] | None = None
    is_array: bool = False
    check_sum: int | None = None
    known: Any = None

    @property
    def start(self) -> int:
        """The column of its first value."""
        return self.values[0].start

    @property
    def end(self) -> int:
        """The column after its last value."""
        return self.values[-1].end

    @property
    def most_bytes(self) -> int:
        """More bytes than these it has in no reading."""
        return sum(len(value.text if value.data is None else value.data) for value in self.values)

    @property
    def is_text(self) -> bool:
        """Whether its values are string literals."""
        return self.values[0].style is Style.STRING


_HEX = "0-9a-fA-F"
_PREFIXES = r"(?:&[hH]|\#?\$|\#?[xX](?=[0-9a-fA-F])|\#|16r|16\#|\\?0[xX]|['][hH]|[xXH]')"
_TOKEN = late_pattern(
    rf"""
      (?P<lesson>0[xX]\|)
    | (?P<sized>(?<!\w)\d{{1,2}}'[hH](?P<digit>[{_HEX}]{{1,2}})(?!\w))
    | (?P<quote>(?<![\w\\])(?P<prefix>(?:b|B|rb|br|u8|u|U|L|@|\$|c)?)(?P<mark>["'`]))
    | (?P<binary>(?<![\w.])(?:0[bB]|\#b|%)(?P<bits>[01](?:_?[01]){{1,8}})(?!\w))
    | (?P<long>(?<![\w.])(?:0[xX]|(?<!\\)\\x(?=[{_HEX}]{{10}}))(?P<glued>(?:[{_HEX}]{{2}}){{2,}})(?![\w\\]))
    | (?P<glued_marks>(?<![\w.])0[xX][{_HEX}]{{2}}(?>(?:0[xX][{_HEX}]{{2}})+)(?!\w))
    | (?P<numbered>(?<![.$&\#])\#(?P<sharp>[{_HEX}]{{2}}|\d{{1,3}})(?!\w))
    | (?P<marked>(?<![\w.$])(?:&[hH]|\#?\$|\#[xX]|16r|16\#|\\?0[xX]|[xX](?=[{_HEX}]{{2}}(?!\w))|'[hH]|[xXH](?=["']))
        ["']?(?P<hex>[{_HEX}]{{1,2}}|[fF]{{6}}[{_HEX}]{{2}})["'\#]?
        (?:_?(?:u8|i8|u32|i32|usize|uy|y|UL|ul|u|U|L|l))?&?(?!\w))
    | (?P<suffixed>(?<![\w.])(?P<digits>0?[{_HEX}]{{2}}|\d)[hH](?!\w))
    | (?P<percent>%(?P<code>[{_HEX}]{{2}}))
    | (?P<unknown>(?<![\w.])(?P<placeholder>[xX]{{4}}|[xX]{{2}}|[mM]{{4}}|MM)(?!\w))
    | (?P<templated>(?<![\w.])[{_HEX}]{{4}}(?:[xX]{{4}}|[mM]{{4}})[{_HEX}]{{2,}}(?!\w))
    | (?P<joined>(?<![\w.])[{_HEX}]{{2}}(?:[_.][{_HEX}]{{2}}){{4,}}(?![\w]))
    | (?P<fours>(?<![\w.])[{_HEX}]{{4}}(?:\.[{_HEX}]{{4}}){{2}}
        (?:(?:\.[{_HEX}]{{4}})+(?:\.[{_HEX}]{{2}})?|\.[{_HEX}]{{2}})(?![\w.]))
    | (?P<printable>(?>(?:=[0-9A-F]{{2}}){{2,}})=?(?!\w))
    | (?P<base64>(?<![\w+/=.-])(?=[\w+/-]*[G-Zg-z+/])(?=[\w+/-]*[A-Z])[A-Za-z0-9+/_-]{{8,}}+={{0,6}}+(?![\w+/=.]))
    | (?P<negative>(?<![\w)\]<>=-])[-\u2212](?P<number>\d{{1,3}})(?![\w.]))
    | (?P<typed>(?<![\w.])(?P<decimal>\d{{1,3}})['_]?(?:u8|i8|uy|u|U|UL|L)(?!\w))
    | (?P<bare>(?<![\w.])(?:[{_HEX}]+(?!\w)(?!\.\d)|[{_HEX}]{{10,}}(?=[hH](?!\w))))
    | (?P<escapes>\\(?:x\{{?[{_HEX}]{{1,2}}|u00[{_HEX}]{{2}}|[0-3][0-7]{{2}}))
    | (?P<word>[^\W\d]\w*+)
    """,
    re.VERBOSE,
)
_BODY = {mark: late_pattern(rf"(?>(?:[^{mark}\\]|\\.)*)") for mark in "\"'`"}
_UNQUOTED = late_pattern(
    rf"(?>(?:\\(?:[xX]\{{?[{_HEX}]{{1,2}}\}}?|u00[{_HEX}]{{2}}|\d{{1,3}}|[abtnvfre\\\"' #])|[!#-&(-\[\]-~])*)"
)
_GAP = late_pattern(r"[\s,;:|+&/\\\"'`<>()\[\]{}\u2013_-]*+")
_JOINER = late_pattern(r"[\s+&()\\]*+|\s*\.\.?\s*|\s*,\s*")
_IS_ADDED = late_pattern(r"[\"')\]\s]*\+[\"'(\[\s]*")
_ADDENDS = frozenset((Style.NAME, Style.UNKNOWN, Style.BASE64))
"""What is not added to a string."""
_HEAD = late_pattern(r"[\s,;:|+&/\\\"'`<>()\[\]{}*=\u2013_-]*+")
_TAIL = late_pattern(r"[\s,;:|+&/\\\"'`<>()\[\]{}\u2013._!?$-]*+(?:[uU]?8?[;\s]*)$")
_REPEATS = late_pattern(r"\s*<repeats (?P<count>[1-9]\d{0,5}) times>")
_ELLIPSIS = late_pattern(r"[\s,;:|\"'-]*+(?:\.{3}|\u2026)")
_HEX_ONLY = late_pattern(rf"[\s,:{_HEX}-]*")
_NAMED = late_pattern(r"(?P<name>[A-Za-z_]\w*)(?P<call>\s?\([^()]{0,80}\))?")
_AFTER_WORD = late_pattern(r"\s*(?:[(,}\])]|$)")
_AFTER_NAME = late_pattern(r"\s*(?:[,}\])]|$)")
_BEFORE_NAME = late_pattern(r"(?:[,{(\[]|^)\s*$")
_MOST_GAP = 160
_MOST_REPEATS = 4 * MAX_FRAME


def runs(line: str, *, is_text: bool = False) -> list[Run]:
    """The runs of values in a line that was cleaned.

    Args:
        line: The line.
        is_text: What stands between quotes is a string literal, because one stands in the line before.
    """
    found: list[Run] = []
    last = 0
    room = _MOST_REPEATS
    plain = blank(line, _REPEATS) if "<repeats" in line else line
    for value in values(plain, is_text=is_text):
        gap = line[last : value.start]
        previous = found[-1] if found else None
        if previous is not None and _joins(previous.values[-1], value, gap):
            if previous.is_text and value.style is not Style.STRING:
                previous.values = [_as_marked(one) for one in previous.values]
            elif value.style is Style.STRING and not previous.is_text:
                value = _as_marked(value)
            previous.values.append(value)
            previous.gaps.append(_gap_class(gap))
            run = previous
        else:
            before = line[:0] if previous is None and _HEAD.fullmatch(gap) is None else gap
            is_head = previous is None and _HEAD.fullmatch(line, 0, value.start) is not None
            run = Run([value], [""], is_head=is_head)
            run.opened = _opening(before if before else gap)
            found.append(run)
        last = value.end
        repeated = None if plain is line else _REPEATS.match(line, last)
        if repeated is not None:
            last = repeated.end()
            count = min(int(repeated["count"]) - 1, room)
            room -= count
            run.values += [value] * count
            run.gaps += [run.gaps[-1] or ","] * count
    for index, run in enumerate(found):
        following = found[index + 1].start if index + 1 < len(found) else len(line)
        run.is_tail = index + 1 == len(found) and _TAIL.match(line, run.end) is not None
        rest = line[run.end : following]
        run.is_cut = _ELLIPSIS.match(rest) is not None
        run.has_comma = rest.lstrip("'\" )").startswith(",")
        inside = _between(line, run) if _BRACKET.search(line, run.start, run.end) is not None else 0
        run.depth = run.opened + inside + _balance(rest if run.is_tail else "")
    return found


_BRACKET = late_pattern(r"[\[\](){}]")


def _between(line: str, run: Run) -> int:
    depth = 0
    for left, right in zip(run.values, run.values[1:], strict=False):
        depth += _balance(line[left.end : right.start])
    return depth


_CELLS = late_pattern(r"\s*[0-7]{7}(?P<cells>(?: (?: {2}[ \S]| \\[0abtnvfr]|[0-7]{3}))+)\s*")
_NO_OFFSET = " " * 8
_CELL_NAMES = {"\\0": 0, "\\a": 7, "\\b": 8, "\\t": 9, "\\n": 10, "\\v": 11, "\\f": 12, "\\r": 13}


def character_cells(line: str, *, goes_on: bool = False) -> Run | None:
    """The row of `od -c`, whose cells are characters, escapes and octal numbers; None where it is none.

    Args:
        line: A line.
        goes_on: The line before is such a row; otherwise it must have an escape.
    """
    row = _CELLS.fullmatch(line)
    if row is None or not (goes_on or "\\" in line):
        return None
    start = row.start("cells")
    values = []
    end = len(line.rstrip())
    for column in range(start, row.end("cells"), 4):
        text = line[column : column + 4].strip() or " "
        code = _CELL_NAMES.get(text)
        if code is None:
            code = ord(text) if len(text) == 1 else int(text, 8)
        if code > 255:
            return None
        values.append(Value(column + 1, column + 4, Style.MARKED, text, bytes((code,))))
    # hexdump fills its last row with blanks, which are no cells.
    gaps = [" " if value.start < end else "" for value in values]
    return Run(values, ["", *gaps[1:]], is_head=True, is_tail=True)


def says_the_same(line: str, data: bytes | None) -> bool:
    """Whether a line is the row of characters below one of hex, as `od -t x1c` prints both."""
    if data is None or not line.startswith(_NO_OFFSET):
        return False
    run = character_cells(f"0000000{line[len(_NO_OFFSET) - 1 :]}", goes_on=True)
    return run is not None and b"".join(value.data or b"" for value in run.values) == data


def _as_marked(value: Value) -> Value:
    """A string literal beside numbers, as in `b"..." + bytes([1, 2])`: its bytes are those of any reading."""
    if value.style is not Style.STRING:
        return value
    return Value(value.start, value.end, Style.MARKED, value.text, literal(value.text, is_decimal=False) or b"")


def _opening(gap: str) -> int:
    """The brackets that are opened right in front of a run."""
    return sum(gap[len(gap.rstrip("[{( \t\"'b")) :].count(mark) for mark in "[{(")


def _balance(text: str) -> int:
    return sum(text.count(mark) for mark in "[{(") - sum(text.count(mark) for mark in "]})")


def _gap_class(gap: str) -> str:
    """What a gap has in common with others of its kind: its characters, but for blanks beside them."""
    marks = gap.replace("0x", "").replace("0X", "").split()
    if not marks:
        return " " if gap else ""
    return "".join(marks).replace("|", ":")


def _joins(left: Value, right: Value, gap: str) -> bool:
    """Whether two values may belong to one run."""
    if Style.BASE64 in (left.style, right.style):
        return left.style is right.style and not gap.strip()
    if len(gap) > _MOST_GAP:
        return False
    if Style.STRING in (left.style, right.style):
        if left.style is not right.style:
            return _IS_ADDED.fullmatch(gap) is not None and _ADDENDS.isdisjoint((left.style, right.style))
        return _JOINER.fullmatch(gap) is not None or (
            len(left.text) <= 6 and _GAP.fullmatch(gap) is not None and "\n" not in gap
        )
    return gap == "." or _GAP.fullmatch(gap.replace("0x|", "|")) is not None


def values(line: str, *, is_text: bool = False) -> Iterator[Value]:
    """The values in a line that was cleaned.

    Args:
        line: The line.
        is_text: Whether what stands in quotes is a string in any case, though no escape or prefix says so.
    """
    position = 0
    string_end = -1
    closers: set[int] = set()
    while token := _TOKEN.search(line, position):
        start, position = token.span()
        kind = token.lastgroup or ""
        by_itself = _BY_ITSELF.get(kind)
        if by_itself is not None:
            yield from by_itself(token)
        elif kind == "lesson":
            position = start + 2
        elif kind == "escapes":
            start, position = _escapes(line, start, string_end)
            yield Value(start, position, Style.STRING, line[start:position])
            string_end = position
        elif kind == "quote":
            if token.start("mark") in closers:
                continue
            body = _BODY[token["mark"]].match(line, position)
            assert body is not None
            if body.end() >= len(line):
                continue
            is_joined = string_end >= 0 and _JOINER.fullmatch(line, string_end, start) is not None
            if OTHER not in body[0] and (is_text or is_joined or _is_string(token["prefix"], body[0])):
                position = string_end = body.end() + 1
                yield Value(start, position, Style.STRING, body[0])
            else:
                closers.add(body.end())
        else:
            named = _named(line, start) if _AFTER_WORD.match(line, position) is not None else None
            if named is not None:
                position = named.end
                yield named
            elif kind == "base64":
                yield Value(start, position, Style.BASE64, token[0])


def _is_string(prefix: str | None, body: str) -> bool:
    """Whether what stands in quotes says by itself that it is a string: by an escape, or as bytes of Python."""
    return "\\" in body or (prefix in ("b", "B") and _HEX_ONLY.fullmatch(body) is None)


def _whole(token: re.Match[str], style: Style, text: str) -> Iterator[Value]:
    """All of a token as one value."""
    yield Value(*token.span(), style, text)


def _byte(token: re.Match[str], text: str, number: int) -> Iterator[Value]:
    """All of a token as one byte; nothing where the number is none."""
    if 0 <= number <= 255:
        yield Value(*token.span(), Style.MARKED, text, bytes((number,)))


def _glued_marks(token: re.Match[str]) -> Iterator[Value]:
    for at in range(token.start(), token.end(), 4):
        digits = token.string[at + 2 : at + 4]
        yield Value(at, at + 4, Style.MARKED, digits, bytes.fromhex(digits))


def _unknown(token: re.Match[str]) -> Iterator[Value]:
    text = token["placeholder"]
    yield Value(*token.span(), Style.UNKNOWN, text, bytes(len(text) // 2))


def _templated(token: re.Match[str]) -> Iterator[Value]:
    """A frame without a blank in which `xxxx` stands for the counter."""
    start, end = token.span()
    text = token[0].lower()
    yield Value(start, start + 4, Style.BARE, text[:4])
    yield Value(start + 4, start + 8, Style.UNKNOWN, "xxxx", bytes(2))
    if len(text) % 2 == 0:
        yield Value(start + 8, end, Style.BARE, text[8:])


def _groups(token: re.Match[str], digits: int) -> Iterator[Value]:
    """Groups of so many digits, with one character between them."""
    for at in range(token.start(), token.end(), digits + 1):
        end = min(at + digits, token.end())
        yield Value(at, end, Style.BARE, token.string[at:end])


def _printable(token: re.Match[str]) -> Iterator[Value]:
    """`=0E=00`, of which the last value has what stands after it, too."""
    start, stop = token.span()
    for at in range(start, stop - 1, 3):
        end = at + 3 if at + 6 <= stop else stop
        digits = token.string[at + 1 : at + 3]
        yield Value(at, end, Style.MARKED, digits, bytes.fromhex(digits))


def _negative(token: re.Match[str]) -> Iterator[Value]:
    """A byte as a signed number, -128 to -1."""
    number = int(token["number"])
    return _byte(token, token[0], -number & 0xFF if number <= 128 else -1)


_BY_ITSELF: Mapping[str, Callable[[re.Match[str]], Iterator[Value]]] = {
    "binary": lambda token: _byte(token, token["bits"], int(token["bits"].replace("_", ""), 2) & 0xFF),
    "long": lambda token: _whole(token, Style.LONG, token["glued"]),
    "marked": lambda token: _byte(token, token["hex"], int(token["hex"], 16) & 0xFF),
    "sized": lambda token: _byte(token, token["digit"], int(token["digit"], 16)),
    "glued_marks": _glued_marks,
    "numbered": lambda token: _whole(token, Style.BARE, token["sharp"]),
    "suffixed": lambda token: _byte(token, token["digits"], int(token["digits"], 16)),
    "percent": lambda token: _byte(token, token["code"], int(token["code"], 16)),
    "unknown": _unknown,
    "templated": _templated,
    "joined": lambda token: _groups(token, 2),
    "fours": lambda token: _groups(token, 4),
    "printable": _printable,
    "negative": _negative,
    "typed": lambda token: _byte(token, token[0], int(token["decimal"])),
    "bare": lambda token: _whole(token, Style.BARE, token[0]),
}
"""The values in those kinds of tokens that say all themselves; the others depend on what stands around them."""


def _escapes(line: str, start: int, least: int) -> tuple[int, int]:
    """Where escapes without quotes begin and end; a character may stand in front of the first."""
    body = _UNQUOTED.match(line, start)
    assert body is not None
    end = body.end()
    # A full stop or a bracket after the last escape is no byte of it, nor is a quote.
    text = line[start:end]
    trimmed = text.rstrip(".,;)]}>")
    if not text.endswith("...") and trimmed:
        end = start + len(trimmed)
    if start > least and start > 0 and line[start - 1] in "!#%&()*+-./:;<>?@^_{}~" and line[start - 1] != "=":
        is_alone = start == 1 or line[start - 2].isspace()
        if is_alone:
            start -= 1
    return start, max(end, start + 1)


def _named(line: str, start: int) -> Value | None:
    """The name at that column, if it stands in an array and the tables have it."""
    found = _NAMED.match(line, start)
    if found is None or _BEFORE_NAME.search(line, max(0, start - 40), start) is None:
        return None
    if _AFTER_NAME.match(line, found.end()) is None:
        return None
    data = constant_bytes(found[0].replace(" (", "("))
    return None if data is None else Value(start, found.end(), Style.NAME, found[0], data)


# Readings


def reading(name: str, value: Value) -> bytes | None:
    """The bytes of a value in a reading; None where it has none."""
    if value.data is not None:
        return value.data
    text = value.text
    match name:
        case "string":
            return literal(text, is_decimal=False) if value.style is Style.STRING else None
        case "decimal string":
            return literal(text, is_decimal=True) if value.style is Style.STRING else None
        case "hex":
            if len(text) == 1:
                return bytes((int(text, 16),))
            return None if len(text) % 2 else bytes.fromhex(text)
        case "decimal":
            number = int(text) if len(text) <= 3 and text.isdecimal() else 256
            return bytes((number,)) if number <= 255 else None
        case "octal":
            is_octal = (len(text) <= 3 or (len(text) == 4 and text[0] == "0")) and set(text) <= _OCTAL
            number = int(text, 8) if is_octal else 256
            return bytes((number,)) if number <= 255 else None
        case "number":
            number = int(text, 16) if len(text) <= 8 else 256
            return bytes((number & 0xFF,)) if number <= 255 or number >= 0xFFFFFF80 else None
        case "words":
            return bytes.fromhex(text)[::-1] if len(text) in (2, 4, 6, 8) else None
        case "decimal words":
            number = int(text) if len(text) == 5 and text.isdecimal() else 1 << 16
            return number.to_bytes(2, "little") if number < 1 << 16 else None
        case "octal words":
            number = int(text, 8) if len(text) == 6 and set(text) <= _OCTAL else 1 << 16
            return number.to_bytes(2, "little") if number < 1 << 16 else None
        case "base64":
            return _base64(text)
        case "base32":
            return _base32(text)
        case "bits":
            is_bits = len(text) % 8 == 0 and set(text) <= {"0", "1"}
            return int(text, 2).to_bytes(len(text) // 8, "big") if is_bits else None
    return None


def _base64(text: str) -> bytes | None:
    """What base64 stands for, with either alphabet, padded or not."""
    digits = text.rstrip("=").replace("-", "+").replace("_", "/")
    try:
        return base64.b64decode(digits + "=" * (-len(digits) % 4), validate=True)
    except binascii.Error:
        return None


def _base32(text: str) -> bytes | None:
    """What base32 stands for, padded or not."""
    digits = text.rstrip("=")
    try:
        return base64.b32decode(digits + "=" * (-len(digits) % 8))
    except binascii.Error:
        return None


BASES = ("base64", "base32")
"""The readings in which a value is no whole number of bytes."""
_OCTAL = frozenset("01234567")


def readings(run: Run) -> list[str]:
    """The readings that a run may have, the likeliest first."""
    if run.values[0].style is Style.BASE64:
        return [*BASES]
    if run.is_text:
        has_digits = any("\\" in value.text for value in run.values)
        return ["string", "decimal string"] if has_digits else ["string"]
    widths = {len(value.text) for value in run.values if value.style in (Style.BARE, Style.LONG)}
    if not widths:
        return ["hex"]
    if not min(widths) % 8 and all(set(value.text) <= {"0", "1"} for value in run.values if value.style is Style.BARE):
        return ["bits"] if len(run.values) > 2 else ["bits", "hex"]
    has_marks = any(value.style is Style.MARKED for value in run.values)
    is_padded = widths <= {2} or (max(widths) >= 4)
    has_zeros = any(len(value.text) == 2 and value.text[0] == "0" for value in run.values if value.style is Style.BARE)
    found = ["decimal", "hex"] if has_marks or not (is_padded or has_zeros) else ["hex", "decimal"]
    if widths & {3, 4}:
        found.append("octal")
    if 8 in widths or 1 in widths:
        found += ["number", "bits"]
    if 4 in widths or 8 in widths:
        found.append("words")
    if 5 in widths:
        found.append("decimal words")
    if 6 in widths:
        found.append("octal words")
    return found
