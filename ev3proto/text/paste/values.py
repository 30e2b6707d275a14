"""The byte values in a line and the runs that they form, in any notation.

A value knows how it is written; its bytes depend on the reading of the whole run: `10` is sixteen or ten.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from enum import Enum, auto
from typing import Any, NamedTuple

from ev3proto.text.paste.cleaning import OTHER
from ev3proto.text.paste.literals import constant_bytes, literal


class Style(Enum):
    """How a value is written.

    BARE     digits without a mark, of any base
    MARKED   digits with a mark of their base, such as 0x0F, $0F, 0Fh, 0x0f000000
    STRING   a string literal, or the escapes of one
    NAME     a name of the tables
    UNKNOWN  `xx` or `MM`, for any byte
    BASE64   a word that may be base64
    """

    BARE = auto()
    MARKED = auto()
    STRING = auto()
    NAME = auto()
    UNKNOWN = auto()
    BASE64 = auto()


class Value(NamedTuple):
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
    """Consecutive values.

    values     the values
    gaps       what is between a value and the one in front of it, without blanks; empty for the first
    is_head    nothing but brackets and the like is in front of them in their line
    is_tail    nothing but these follows them
    opened     brackets that are opened right in front of them
    depth      brackets that are opened and not closed in the line from there on
    has_comma  a comma follows
    lines      the line of each value, where the run has several
    is_array   they are one list in brackets, in which the end of a line means nothing
    check_sum  a byte that may follow the last frame, as the text says
    changes    the values in front of which the way of writing changes, once it was asked for
    tried      its readings, once they were tried
    """

    values: list[Value]
    gaps: list[str]
    is_head: bool = False
    is_tail: bool = False
    opened: int = 0
    depth: int = 0
    has_comma: bool = False
    lines: list[int] = field(default_factory=list)
    is_array: bool = False
    check_sum: int | None = None
    changes: frozenset[int] | None = None
    tried: Any = None

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
        """An upper limit of its bytes in any reading."""
        return sum(len(value.text if value.data is None else value.data) for value in self.values)

    @property
    def is_text(self) -> bool:
        """Whether its values are string literals."""
        return self.values[0].style is Style.STRING


_HEX = "0-9a-fA-F"
_TOKEN = re.compile(
    rf"""
      (?P<lesson>0[xX]\|)
    | (?P<sized>(?<!\w)\d{{1,2}}'[hH](?P<digit>[{_HEX}]{{1,2}})(?!\w))
    | (?P<quote>(?<![\w\\])(?P<prefix>(?:b|B|rb|br|u8|u|U|L|@|\$|c)?)(?P<mark>["'`]))
    | (?P<binary>(?<![\w.])(?:0[bB]|\#b|%|B(?=[01]{{8}}))(?P<bits>[01](?:_?[01]){{7}})(?!\w))
    | (?P<long>(?<![\w.])(?:0[xX]|(?<!\\)\\x(?=[{_HEX}]{{10}}))(?P<glued>(?:[{_HEX}]{{2}}){{2,}})(?![\w\\]))
    | (?P<glued_marks>(?<![\w.])0[xX][{_HEX}]{{2}}(?:0[xX][{_HEX}]{{2}})+(?!\w))
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
    | (?P<printable>(?:=[0-9A-F]{{2}}){{2,}}=?(?!\w))
    | (?P<base64>(?<![\w+/.-])(?=[\w+/-]*[G-Zg-z+/])(?=[\w+/-]*[A-Z])[A-Za-z0-9+/_-]{{8,}}={{0,3}}(?![\w+/=.]))
    | (?P<negative>(?<![\w)\]<>=-])-(?P<number>\d{{1,3}})(?![\w.]))
    | (?P<typed>(?<![\w.])(?P<decimal>\d{{1,3}})['_]?(?:u8|i8|uy|u|U|UL|L)(?!\w))
    | (?P<bare>(?<![\w.])[{_HEX}]+(?!\w)(?!\.\d))
    | (?P<escapes>\\(?:x\{{?[{_HEX}]{{1,2}}|u00[{_HEX}]{{2}}|[0-3][0-7]{{2}}))
    | (?P<word>[^\W\d]\w*)
    """,
    re.VERBOSE,
)
_BODY = {mark: re.compile(rf"[^{mark}\\]*(?:\\.[^{mark}\\]*)*") for mark in "\"'`"}
_UNQUOTED = re.compile(
    rf"(?:\\(?:[xX]\{{?[{_HEX}]{{1,2}}\}}?|u00[{_HEX}]{{2}}|\d{{1,3}}|[abtnvfre\\\"' #])|[!#-&(-\[\]-~])*"
)
_GAP = re.compile(r"[\s,;:|+&/\\\"'`<>()\[\]{}_-]*")
_JOINER = re.compile(r"[\s+&()\\]*|\s*\.\.?\s*|\s*,\s*")
_IS_ADDED = re.compile(r"[\"')\]\s]*\+[\"'(\[\s]*")
_HEX_ONLY = re.compile(rf"[\s,:{_HEX}-]*")
_NESTED = re.compile(r"b?([\"']).*\1")
_CALL = re.compile(r"[A-Za-z_]\w*\s?\([^()]{0,80}\)")
_AFTER_WORD = re.compile(r"\s{0,8}(?:[(,}\])]|$)")
_AFTER_NAME = re.compile(r"\s{0,8}(?:[,}\])]|$)")
_BEFORE_NAME = re.compile(r"(?:[,{(\[]|^)\s*$")
_AROUND = " \t\r\n\f\v,;:|+&/\\\"'`<>()[]{}_-"
_ENDS = ("", "u", "U", "u8", "U8")
_SAME = "="
"""The gap between values whose indexes or names are between them."""
_MOST_GAP = 160


def runs(line: str, *, is_text: bool = False) -> list[Run]:
    """Returns the runs of values in a line that was cleaned.

    Args:
        line: The line.
        is_text: What is between quotes is a string literal, because there is one in the line before.
    """
    found: list[Run] = []
    last = 0
    for value in values(line, is_text=is_text):
        gap = line[last : value.start]
        previous = found[-1] if found else None
        if previous is not None and _joins(previous.values[-1], value, gap):
            if previous.is_text and value.style is not Style.STRING:
                previous.values = [_as_marked(one) for one in previous.values]
            elif value.style is Style.STRING and not previous.is_text:
                value = _as_marked(value)
            previous.values.append(value)
            previous.gaps.append(_gap_class(gap))
        else:
            is_head = previous is None and not gap.strip(_AROUND + "*=")
            opened = sum(map(gap[len(gap.rstrip("[{( \t\"'b")) :].count, "[{("))
            found.append(Run([value], [""], is_head=is_head, opened=opened))
        last = value.end
    ends = [run.start for run in found[1:]] + [len(line)]
    for run, following in zip(found, ends, strict=False):
        rest = line[run.end : following]
        run.is_tail = run is found[-1] and rest.strip(_AROUND + ".!?$") in _ENDS
        run.has_comma = rest.lstrip("'\" )").startswith(",")
        run.depth = run.opened + sum(_balance(gap) for gap in run.gaps if len(gap) > 1 or gap in "[](){}")
        if run.is_tail:
            run.depth += _balance(rest)
    return found


def all_values(found: list[Run]) -> list[Value]:
    """Returns the values of all runs of a line."""
    return [value for run in found for value in run.values]


def listed(values: list[Value]) -> Run:
    """Returns values as a run, whatever is between them."""
    return Run(values, ["", *[_SAME] * (len(values) - 1)])


def without_indexes(values: list[Value], first: int, least: int) -> list[Value] | None:
    """Returns the values without the indexes among them (`0: 15, 1: 0`, `cmd[0] = 15;`, `setUint8(0, 15)`).

    Args:
        values: The values of a line.
        first: The first index.
        least: The fewest values with an index.

    Returns:
        The values that have one; None where they have not. The index is in front of its value or after it.
    """
    for start, of_value in ((0, 1), (1, 1), (1, -1), (2, -1)):
        count = 0
        while (at := start + 2 * count) < len(values) and 0 <= at + of_value < len(values):
            if values[at].style is not Style.BARE or values[at].text != str(first + count):
                break
            count += 1
        if count >= least and (least > 1 or len(values) == 2):
            return [values[start + 2 * place + of_value] for place in range(count)]
    return None


def _as_marked(value: Value) -> Value:
    """Returns a string literal beside numbers, as in `b"..." + bytes([1, 2])`, as a value of the same bytes."""
    if value.style is not Style.STRING:
        return value
    return value._replace(style=Style.MARKED, data=literal(value.text, is_decimal=False) or b"")


def _balance(text: str) -> int:
    return sum(map(text.count, "[{(")) - sum(map(text.count, "]})"))


def _gap_class(gap: str) -> str:
    """Returns the characters of a gap, but for blanks beside others."""
    if len(gap) < 2:
        return gap if gap not in "\t|\u00a0" else ":" if gap == "|" else " " if gap else ""
    marks = gap.replace("0x|", "|").replace("0X|", "|").split()
    return "".join(marks).replace("|", ":") if marks else " "


def _joins(left: Value, right: Value, gap: str) -> bool:
    """Whether two values may belong to one run."""
    if left.style is Style.BASE64 or right.style is Style.BASE64:
        return left.style is right.style and not gap.strip()
    if len(gap) > _MOST_GAP:
        return False
    if left.style is Style.STRING or right.style is Style.STRING:
        if left.style is not right.style:
            is_number = {left.style, right.style} <= {Style.STRING, Style.BARE, Style.MARKED}
            return is_number and _IS_ADDED.fullmatch(gap) is not None
        return _JOINER.fullmatch(gap) is not None or (len(left.text) <= 6 and _GAP.fullmatch(gap) is not None)
    return gap in (" ", ".", ", ") or _GAP.fullmatch(gap.replace("0x|", "|").replace("0X|", "|")) is not None


def values(line: str, *, is_text: bool = False) -> Iterator[Value]:
    """Yields the values in a line that was cleaned.

    Args:
        line: The line.
        is_text: Whether what is in quotes is a string in any case, without an escape or a prefix.
    """
    position, string_end = 0, -1
    closers: set[int] = set()
    search = _TOKEN.search
    while token := search(line, position):
        start, position = token.span()
        kind = token.lastgroup or ""
        if kind == "bare":
            yield Value(start, position, Style.BARE, token[0])
        elif kind in _BY_ITSELF:
            yield from _BY_ITSELF[kind](token)
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
            if body is None or body.end() >= len(line) or line[body.end()] != token["mark"]:
                continue
            is_joined = string_end >= 0 and _JOINER.fullmatch(line, string_end, start) is not None
            if OTHER not in body[0] and (is_text or is_joined or _is_string(token["prefix"], body[0])):
                position = string_end = body.end() + 1
                yield Value(start, position, Style.STRING, body[0])
            else:
                closers.add(body.end())
        else:
            named = _named(line, token) if _AFTER_WORD.match(line, position) is not None else None
            if named is not None:
                position = named.end
                yield named
            elif kind == "base64":
                yield Value(start, position, Style.BASE64, token[0])


def _is_string(prefix: str | None, body: str) -> bool:
    """Whether what is in quotes says by itself that it is a string: by an escape, or as bytes of Python."""
    if _NESTED.fullmatch(body):
        return False
    return "\\" in body or (prefix in ("b", "B") and _HEX_ONLY.fullmatch(body) is None)


def _byte(token: re.Match[str], text: str, number: int) -> Iterator[Value]:
    """Yields all of a token as one byte; nothing where the number is not one."""
    if 0 <= number <= 255:
        yield Value(*token.span(), Style.MARKED, text, bytes((number,)))


def _every(token: re.Match[str], width: int, skip: int) -> Iterator[Value]:
    """Yields bytes with marks, each of them that many characters wide; the last has what is after it, too."""
    start, stop = token.span()
    for at in range(start, stop - 1, width):
        end = at + width if at + 2 * width <= stop else stop
        digits = token.string[at + skip : at + skip + 2]
        yield Value(at, end, Style.MARKED, digits, bytes.fromhex(digits))


def _unknown(token: re.Match[str]) -> Iterator[Value]:
    yield Value(*token.span(), Style.UNKNOWN, token[0], bytes(len(token[0]) // 2))


def _templated(token: re.Match[str]) -> Iterator[Value]:
    """Yields the parts of a frame without blanks in which `xxxx` replaces the counter."""
    start, end = token.span()
    yield Value(start, start + 4, Style.BARE, token[0][:4])
    yield Value(start + 4, start + 8, Style.UNKNOWN, "xxxx", bytes(2))
    yield Value(start + 8, end, Style.BARE, token[0][8:])


def _groups(token: re.Match[str], digits: int) -> Iterator[Value]:
    """Yields groups of as many digits, with one character between them."""
    for at in range(token.start(), token.end(), digits + 1):
        end = min(at + digits, token.end())
        yield Value(at, end, Style.BARE, token.string[at:end])


def _negative(token: re.Match[str]) -> Iterator[Value]:
    """Yields a byte that is a signed number, -128 to -1."""
    number = int(token["number"])
    return _byte(token, token[0], -number & 0xFF if number <= 128 else -1)


_BY_ITSELF: Mapping[str, Callable[[re.Match[str]], Iterator[Value]]] = {
    "binary": lambda token: _byte(token, token["bits"], int(token["bits"].replace("_", ""), 2) & 0xFF),
    "long": lambda token: iter((Value(*token.span(), Style.MARKED, token["glued"], bytes.fromhex(token["glued"])),)),
    "marked": lambda token: _byte(token, token["hex"], int(token["hex"], 16) & 0xFF),
    "sized": lambda token: _byte(token, token["digit"], int(token["digit"], 16)),
    "glued_marks": lambda token: _every(token, 4, 2),
    "numbered": lambda token: iter((Value(*token.span(), Style.BARE, token["sharp"]),)),
    "suffixed": lambda token: _byte(token, token["digits"], int(token["digits"], 16)),
    "percent": lambda token: _byte(token, token["code"], int(token["code"], 16)),
    "unknown": _unknown,
    "templated": _templated,
    "joined": lambda token: _groups(token, 2),
    "fours": lambda token: _groups(token, 4),
    "printable": lambda token: _every(token, 3, 1),
    "negative": _negative,
    "typed": lambda token: _byte(token, token[0], int(token["decimal"])),
}
"""The values in the kinds of tokens that do not depend on their surroundings."""


def _escapes(line: str, start: int, least: int) -> tuple[int, int]:
    """Returns where escapes without quotes begin and end; a character may be in front of the first."""
    body = _UNQUOTED.match(line, start)
    text = line[start : body.end()] if body is not None else ""
    # A full stop or a bracket after the last escape is not a byte of it.
    trimmed = text if text.endswith("...") else text.rstrip(".,;)]}>") or text
    end = start + max(len(trimmed), 1)
    is_free = start > least and start > 0 and line[start - 1] in "!#%&()*+-./:;<>?@^_{}~"
    return start - (is_free and (start == 1 or line[start - 2].isspace())), end


def _named(line: str, token: re.Match[str]) -> Value | None:
    """Returns the name at that column, if it is in an array and the tables have it."""
    start, end = token.span()
    if _BEFORE_NAME.search(line, max(0, start - 40), start) is None:
        return None
    call = _CALL.match(line, start)
    end = end if call is None else call.end()
    data = constant_bytes(line[start:end]) if _AFTER_NAME.match(line, end) is not None else None
    return None if data is None else Value(start, end, Style.NAME, line[start:end], data)


_CELLS = re.compile(r"\s*[0-7]{7}(?P<cells>(?: (?: {2}[ \S]| \\[0abtnvfr]|[0-7]{3}))+)\s*")


def character_cells(line: str, *, continues: bool = False) -> Run | None:
    """Returns the row of `od -c`, whose cells are characters, escapes and octal numbers; None for any other line.

    Args:
        line: A line.
        continues: The line before is such a row; otherwise it must have an escape.
    """
    row = _CELLS.fullmatch(line)
    if row is None or not (continues or "\\" in line):
        return None
    found = []
    for column in range(row.start("cells"), row.end("cells"), 4):
        text = line[column : column + 4].strip() or " "
        data = (
            text.encode("latin-1")
            if len(text) == 1
            else literal(text if text[0] == "\\" else f"\\{text}", is_decimal=False)
        )
        found.append(Value(column + 1, column + 4, Style.MARKED, text, data))
    # hexdump fills its last row with blanks, which are not cells.
    end = len(line.rstrip())
    gaps = [" " if value.start < end else "" for value in found[1:]]
    return Run(found, ["", *gaps], is_head=True, is_tail=True)
