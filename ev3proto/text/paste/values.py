"""The byte values in a line and the runs that they form, in any notation.

A value knows how it is written; its bytes depend on the reading of the whole run: `10` is sixteen or ten.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from enum import Enum, auto
from functools import cache
from typing import Any, NamedTuple

from ev3proto.errors import BuildError
from ev3proto.schema import names
from ev3proto.schema.argument import encode_as
from ev3proto.tables import OPCODES
from ev3proto.tables.frame import MessageType
from ev3proto.text.paste.cleaning import OTHER


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
    """A value in a line: its columns, the digits or the body of a string, its bytes where every reading gives these."""

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
    def is_text(self) -> bool:
        """Whether its values are string literals."""
        return self.values[0].style is Style.STRING


_HEX = "0-9a-fA-F"
_TOKEN = re.compile(
    rf"""
      (?P<lesson>0[xX]\|)
    | (?P<quote>(?<![\w\\])(?P<prefix>(?:b|B|rb|br|u8|u|U|L|@|\$|c)?)(?P<mark>["'`]))
    | (?P<binary>(?<![\w.])(?:0[bB]|\#b|%|B(?=[01]{{8}}))(?P<bits>[01](?:_?[01]){{7}})(?!\w))
    | (?P<long>(?<![\w.])(?:0[xX]|(?<!\\)\\x(?=[{_HEX}]{{10}}))(?P<glued>(?:[{_HEX}]{{2}}){{2,}})(?![\w\\]))
    | (?P<marked>(?<![\w.$])(?:\#?\$|\\?0[xX]|[xX](?=[{_HEX}]{{2}}(?!\w))|[xXH](?=["']))
        ["']?(?P<hex>[{_HEX}]{{1,2}}|[fF]{{6}}[{_HEX}]{{2}})["'\#]?(?:_?(?:[ui](?:8|32|size)|[uU]?[yYlL]|[lL]?[uU]))?&?(?!\w))
    | (?P<suffixed>(?<![\w.])(?P<digits>0?[{_HEX}]{{2}}|\d)[hH](?!\w))
    | (?P<unknown>(?<![\w.])(?P<placeholder>[xX]{{4}}|[xX]{{2}}|[mM]{{4}}|MM)(?!\w))
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
_CHARACTERS = {"a": "\a", "b": "\b", "t": "\t", "n": "\n", "v": "\v", "f": "\f", "r": "\r", "e": "\x1b"}
_ESCAPE = re.compile(
    rf"\\(?:[xXu]\{{([{_HEX}]{{1,2}})\}}|(?:[xX]|u00)([{_HEX}]{{1,2}})|([0-3]?[0-7]{{1,2}})|([A-Za-z\W]))"
)
_DECIMAL_ESCAPE = re.compile(_ESCAPE.pattern.replace("[0-3]?[0-7]{1,2}", r"\d{1,3}"))
_MACRO = re.compile(r"(LC[0124SXF]|[LG]V[0124X]|LAB1)\s?\(\s*([^()]*?)\s*\)")
_NUMBER = re.compile(r"-?(?:0[xX][0-9a-fA-F]{1,8}|0|[1-9]\d{0,9})")
_GAP = re.compile(r"[\s,;:|+&/\\\"'`<>()\[\]{}_-]*")
_JOINER = re.compile(r"[\s+&()\\]*|\s*\.\.?\s*|\s*,\s*")
_IS_ADDED = re.compile(r"[\"')\]\s]*\+[\"'(\[\s]*")
_HEX_ONLY = re.compile(rf"[\s,:{_HEX}-]*")
_NAME = re.compile(r"(?:[A-Za-z_]\w*\s?\([^()]{0,80}\)|\w+)(?=\s{0,8}(?:[,}\])]|$))")
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
    for value in _values(line, is_text=is_text):
        gap = line[last : value.start]
        run = found[-1] if found else None
        if run is not None and _joins(run.values[-1], value, gap):
            if run.is_text is not (value.style is Style.STRING):
                # A string literal beside numbers, as in `b"..." + bytes([1, 2])`, is a value of the same bytes.
                run.values, value = [_as_marked(one) for one in run.values], _as_marked(value)
            run.values.append(value)
            run.gaps.append(_gap_class(gap))
        else:
            opened = sum(map(gap[len(gap.rstrip("[{( \t\"'b")) :].count, "[{("))
            found.append(Run([value], [""], is_head=run is None and not gap.strip(_AROUND + "*="), opened=opened))
        last = value.end
    for run, following in zip(found, [*(run.start for run in found[1:]), len(line)], strict=False):
        rest = line[run.end : following]
        run.is_tail = run is found[-1] and rest.strip(_AROUND + ".!?$") in _ENDS
        run.has_comma = rest.lstrip("'\" )").startswith(",")
        run.depth = run.opened + sum(map(_balance, run.gaps)) + (_balance(rest) if run.is_tail else 0)
    return found


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
        while (at := start + 2 * count) < len(values) and at + of_value < len(values):
            if values[at].style is not Style.BARE or values[at].text != str(first + count):
                break
            count += 1
        if count >= least and (least > 1 or len(values) == 2):
            return [values[start + 2 * place + of_value] for place in range(count)]
    return None


def _as_marked(value: Value) -> Value:
    return value._replace(style=Style.MARKED, data=literal(value.text)) if value.style is Style.STRING else value


def _balance(text: str) -> int:
    return sum(map(text.count, "[{(")) - sum(map(text.count, "]})")) if text else 0


def _gap_class(gap: str) -> str:
    """Returns the characters of a gap, but for blanks beside others."""
    if gap in ("", " "):
        return gap
    marks = gap.replace("0x|", "|").replace("0X|", "|").split()
    return "".join(marks).replace("|", ":") or " "


def _joins(left: Value, right: Value, gap: str) -> bool:
    """Whether two values may belong to one run."""
    styles = {left.style, right.style}
    if Style.BASE64 in styles:
        return len(styles) == 1 and not gap.strip()
    if len(gap) > _MOST_GAP:
        return False
    if Style.STRING in styles:
        if len(styles) == 2:
            return styles <= {Style.STRING, Style.BARE, Style.MARKED} and _IS_ADDED.fullmatch(gap) is not None
        return _JOINER.fullmatch(gap) is not None or (len(left.text) <= 6 and _GAP.fullmatch(gap) is not None)
    return gap in (" ", ".", ", ") or _GAP.fullmatch(gap.replace("0x|", "|").replace("0X|", "|")) is not None


def _values(line: str, *, is_text: bool) -> Iterator[Value]:
    position, string_end = 0, -1
    closers: set[int] = set()
    while token := _TOKEN.search(line, position):
        start, position = token.span()
        kind = token.lastgroup or ""
        if kind == "bare":
            yield Value(start, position, Style.BARE, token[0])
        elif kind in _BYTES:
            text, data = _BYTES[kind](token)
            if data is not None:
                yield Value(start, position, Style.UNKNOWN if kind == "unknown" else Style.MARKED, text, data)
        elif kind == "lesson":
            position = start + 2
        elif kind == "escapes":
            start, position = _escapes(line, start, string_end)
            yield Value(start, position, Style.STRING, line[start:position])
            string_end = position
        elif kind == "quote":
            body = None if token.start("mark") in closers else _BODY[token["mark"]].match(line, position)
            if body is None or not line.startswith(token["mark"], body.end()):
                continue
            is_joined = string_end >= 0 and _JOINER.fullmatch(line, string_end, start) is not None
            if OTHER not in body[0] and (is_text or is_joined or _is_string(token["prefix"], body[0])):
                position = string_end = body.end() + 1
                yield Value(start, position, Style.STRING, body[0])
            else:
                closers.add(body.end())
        else:
            name = _NAME.match(line, start)
            is_listed = name is not None and _BEFORE_NAME.search(line, max(0, start - 40), start) is not None
            data = _constant(name[0]) if name is not None and is_listed else None
            if name is not None and data is not None:
                position = name.end()
                yield Value(start, position, Style.NAME, name[0], data)
            elif kind == "base64":
                yield Value(start, position, Style.BASE64, token[0])


def _is_string(prefix: str, body: str) -> bool:
    """Whether what is in quotes says by itself that it is a string: by an escape, or as bytes of Python."""
    is_nested = body[-1:] in ("'", '"') and body.removeprefix("b")[:1] == body[-1]
    return not is_nested and ("\\" in body or (prefix in ("b", "B") and _HEX_ONLY.fullmatch(body) is None))


def _byte(text: str, number: int) -> tuple[str, bytes | None]:
    return text, bytes((number,)) if 0 <= number <= 255 else None


def _negative(text: str) -> tuple[str, bytes | None]:
    return _byte(text, 256 + int(text) if -128 <= int(text) < 0 else -1)


_BYTES: Mapping[str, Callable[[re.Match[str]], tuple[str, bytes | None]]] = {
    "binary": lambda token: _byte(token["bits"], int(token["bits"].replace("_", ""), 2)),
    "long": lambda token: (token["glued"], bytes.fromhex(token["glued"])),
    "marked": lambda token: _byte(token["hex"], int(token["hex"], 16) & 0xFF),
    "suffixed": lambda token: _byte(token["digits"], int(token["digits"], 16)),
    "unknown": lambda token: (token[0], bytes(len(token[0]) // 2)),
    "negative": lambda token: _negative(token[0]),
    "typed": lambda token: _byte(token[0], int(token["decimal"])),
}
"""The text and the bytes of the kinds of tokens that do not depend on their surroundings."""


def _escapes(line: str, start: int, least: int) -> tuple[int, int]:
    """Returns where escapes without quotes begin and end; a character may be in front of the first."""
    body = _UNQUOTED.match(line, start)
    text = line[start : body.end()] if body is not None else ""
    # A full stop or a bracket after the last escape is not a byte of it.
    trimmed = text if text.endswith("...") else text.rstrip(".,;)]}>") or text
    is_free = start > max(least, 0) and line[start - 1] in "!#%&()*+-./:;<>?@^_{}~"
    return start - (is_free and (start == 1 or line[start - 2].isspace())), start + max(len(trimmed), 1)


def literal(body: str, *, is_decimal: bool = False) -> bytes | None:
    r"""Returns the bytes of what is between two quotes; None where a character is not a byte.

    Args:
        body: The characters between the quotes.
        is_decimal: `\128` is one byte, as in Lua; otherwise digits are octal.
    """

    def character(found: re.Match[str]) -> str:
        braced, digits, number, letter = found.groups()
        if letter is not None:
            # A letter without a meaning is itself after its backslash, as in Python.
            return _CHARACTERS.get(letter, found[0] if letter.isalpha() else letter)
        return chr(int(braced or digits, 16) if number is None else int(number, 10 if is_decimal else 8))

    try:
        return (_DECIMAL_ESCAPE if is_decimal else _ESCAPE).sub(character, body).encode("latin-1")
    except UnicodeEncodeError:
        return None


def _constant(text: str) -> bytes | None:
    """Returns the bytes of a name or of one of LEGO's macros; None where the tables do not have it."""
    call = _MACRO.fullmatch(text)
    if call is None:
        return _constants().get(text)
    macro, inner = call.groups()
    try:
        if macro == "LCS":
            return names.LCS(inner[1:-1]) if len(inner) > 1 and inner[0] == inner[-1] in "\"'" else None
        if _NUMBER.fullmatch(inner):
            value = int(inner, 0)
        else:
            # A name is encoded already: the macro gets the number that it has.
            data = _constants()[inner]
            value = int.from_bytes(data[1:] or bytes((data[0] << 2 & 0xFF,)), "little", signed=True)
            value >>= 2 * (len(data) == 1)
        encode: Callable[[int], bytes] | None = getattr(names, macro, None)
        return encode_as(macro, value) if encode is None else encode(value)
    except (BuildError, KeyError):
        return None


@cache
def _constants() -> dict[str, bytes]:
    """Returns the bytes of each name that stands for some: opcodes, types of messages, encoded constants."""
    found: dict[str, bytes] = {f"op{opcode.name}": bytes((opcode.number,)) for opcode in OPCODES}
    for name in names.constant_names():
        value = names.constant(name)
        if isinstance(value, bytes) or (isinstance(value, int) and 0 <= value <= 255):
            found[name] = value if isinstance(value, bytes) else bytes((value,))
    return found | {name: bytes((member,)) for name, member in MessageType.__members__.items()}
