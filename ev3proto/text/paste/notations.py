r"""The notations: how a run of values looks, where each value in it is, and which bytes a value has in each reading.

A notation is a declaration. Its `run` finds five values and more in one search of the regex engine, which skips the
times, dates and addresses on its way; its `value` steps through a run from one value to the next; its `readings` are
memoised functions from the text of a value to bytes, so that the bytes of a run are one join.
"""

from __future__ import annotations

import binascii
import re
from collections.abc import Callable, Iterable
from functools import cache
from typing import NamedTuple

from ev3proto.errors import BuildError
from ev3proto.schema import names
from ev3proto.schema.argument import encode_as
from ev3proto.tables import OPCODES
from ev3proto.tables.frame import MessageType

_H = "[0-9a-fA-F]"
_CLOCK = r"(?:[01]?\d|2[0-3]):[0-5]\d:[0-6]\d(?:[.,]\d{1,9})?"
_FOREIGN = (
    # A UUID, a date with or without a time, a time, an address of IPv6 without its zeros, a number with a fraction.
    rf"(?<![\w-]){_H}{{8}}-{_H}{{4}}-{_H}{{4}}-{_H}{{4}}-{_H}{{12}}(?![\w-])"
    rf"|(?<![\w.:|-])(?:(?:(?:19|20)\d\d[-/.])?[01]\d[-/.][0-3]\d|[0-3]\d[./][01]\d[./](?:19|20)\d\d)"
    rf"(?:[T ]\s?{_CLOCK}(?:Z|\s?[+-]\d\d:?\d\d)?(?![\w:|])|(?<=[\d/.-]{{8}})(?![\w:|./-]))"
    rf"|(?<![\w.:|-]){_CLOCK}(?:Z|\s?[+-]\d\d:?\d\d)?(?=[\])>:;,-]?(?:\s|$))"
    rf"|(?<![\w:.])(?:{_H}{{1,4}}:){{1,6}}:(?:{_H}{{1,4}}:){{0,5}}{_H}{{1,4}}(?:%\w+|/\d{{1,3}})?(?![\w:])"
    r"|</?[a-fA-F]>"
    r"|(?<![\w.-])(?!\d{4}(?:\.\d{4}){2}\.\d\d)[-+]?\d+(?:\.\d+){1,3}(?:e[-+]?\d+)?(?![\w.])"
)
_SUFFIX = r"(?:_?[ui](?:8|32|size)|'?[ui]8|[uU]?[yYlL]|[lL]?[uU]|[hH]|\.to(?:U?Byte|Char)\(\))?&?(?!\w)"
_MACRO = r"(?:LC[0124SXF]|[LG]V[0124X]|LAB1)\s?\("
_NAME = rf"(?<=[,{{(\[\s])(?:{_MACRO}[^()]{{0,80}}\)|op[A-Z]\w+|[A-Z][A-Z0-9_]+)(?=\s{{0,8}}(?:[,}}\])]|$))"
_VALUE = (
    # What most values are and most gaps have comes first; the rest is rarer.
    rf"(?<!\w){_H}+(?![\w'\#&.])"
    rf"|0[xX](?:{_H}{{1,2}}(?!\w)|{_H}{{2}}(?=0[xX]{_H}{{2}}))(?!['\#&])"
    rf"|(?<![\w$])(?:\\?0[xX]|\\[xX]|\$|&[hH]|\#[xX]|(?<!\#)16[\#r]|\d{{0,2}}'[hH]|[xX](?={_H}{{2}}(?!\w)|'))'?{_H}+{_SUFFIX}"
    rf"|(?<!\w)(?:0[bB]|\#b|B)[01]{{4}}_?[01]{{4}}(?!\w)"
    rf"|(?<!\w)(?:{_H}{{4}}(?:[xX]{{4}}|[mM]{{4}}){_H}+|[xX]{{4}}|[xX]{{2}}|[mM]{{4}}|MM)(?!\w)"
    rf"|(?:(?<![\w)\]<>=-])|(?<=[a-z]\)))-\d{{1,3}}(?![\w.])"
    rf"|(?<!\w){_H}+{_SUFFIX}|{_NAME}"
)
_TYPES = r"(?:(?:un)?signed\s)?(?:s?byte|char|u?int8_?t?|u8|[US]?Byte|SByte|UInt8|BYTE)"
_GAP = (
    rf"(?:[\s,:|]+(?={_H})"
    rf"|\({_TYPES}\s?\)|(?<=\d\s)'(?:\\(?:[0-7]{{1,3}}|x[0-9a-fA-F]{{2}}|.)|[^'\\])'"
    rf"|</?(?!{_H}{{2}}>)[A-Za-z_][\w:.-]{{0,30}}\s?/?>"
    r"|[\s,;:|+\"`<>()\[\]{}_./=%]|(?<=\w)-|-(?![\d])|&(?![hH#\w])|\\(?![xX])|\#(?![xXb])|'(?![hH])"
    rf"|&\#?\w{{2,5}};|0[xX](?=\|)"
    rf"|(?<!\w)(?!{_MACRO})(?:\w+\.)?[A-Za-z_]\w*\s?\(|as\s(?:u8|byte)\b)"
)


_PLAIN_VALUES = rf"(?:[\s,:|]{{1,4}}(?:0x)?{_H}{{1,8}}(?![\w'\#&.]))++"
"""What most runs are, so that the engine takes it in one loop: values without marks but 0x, between them no words."""


Bytes = Callable[[str], bytes | None]


class Table(dict[str, bytes | None]):
    """The bytes of values in one reading, each worked out once."""

    def __init__(self, parse: Bytes) -> None:
        self._parse = parse

    def __missing__(self, token: str) -> bytes | None:
        data = self._parse(token)
        if len(token) <= 8 and len(self) < 1 << 14:
            self[token] = data
        return data


# Numbers

_MARKED = re.compile(rf"(?:\\?0[xX]|\\[xX]|\#?\$|&[hH]|\#[xX]|16[\#r]|\d{{0,2}}'[hH]|[xX]'?)'?({_H}+)(?:.*)", re.DOTALL)
_BARE = re.compile(f"{_H}+")
_BITS = re.compile(r"(?:0[bB]|#b|B)([01]{4})_?([01]{4})")
_PLAIN = re.compile(rf"({_H}+?)(?:[hH]|(_?[ui](?:8|32|size)|'?[ui]8|[uU]?[yYlL]|[lL]?[uU]|\.to\w+\(\)))?&?")
_UNKNOWN = re.compile(rf"(?:{_H}{{4}})?(?:[xX]{{4}}|[mM]{{4}}){_H}*|[xX]{{2}}|MM")


def _hex(digits: str) -> bytes | None:
    if len(digits) == 8 and digits[:6].lower() == "ffffff":
        return bytes.fromhex(digits[6:])
    return bytes.fromhex(digits.zfill(2)) if len(digits) == 1 or len(digits) % 2 == 0 else None


def marked(token: str) -> bytes | None:
    """Returns the bytes of a value whose mark or sign says what it is; None for bare digits and anything but a byte."""
    if found := _MARKED.fullmatch(token):
        return _hex(found[1])
    if found := _BITS.fullmatch(token):
        return bytes((int(found[1] + found[2], 2),))
    if token[0] == "-":
        return bytes((int(token) & 0xFF,)) if -128 <= int(token) < 0 else None
    if _UNKNOWN.fullmatch(token):
        return _hex(re.sub("[xXmM]", "0", token))
    found = _PLAIN.fullmatch(token)
    if found is None or found[1] == token:
        return None if found else _constant(token)
    if found[2] is not None and not found[1].isdecimal():
        return None
    number = int(found[1], 16 if found[2] is None else 10)
    return bytes((number,)) if number < 256 else None


def _sized(text: str, base: int, size: int) -> bytes | None:
    number = int(text, base) if text.isdecimal() and (base == 10 or not {"8", "9"} & {*text}) else 1 << 16
    return number.to_bytes(size, "little") if number < 1 << 8 * size else None


def _unpadded(text: str) -> bytes | None:
    """Returns the byte of an unpadded number, also where the sign of a negative one was spread over 32 bits."""
    number = int(text, 16) if len(text) in (1, 2, 8) else -1
    return bytes((number & 0xFF,)) if 0 <= number < 256 or number >= 0xFFFFFF80 else None


def _bits(text: str) -> bytes | None:
    is_bits = len(text) % 8 == 0 and {*text} <= {"0", "1"}
    return int(text, 2).to_bytes(len(text) // 8, "big") if is_bits else None


def _number(digits: Bytes) -> Table:
    return Table(lambda token: digits(token) if WIDTH[token] > 0 else marked(token))


class _Widths(dict[str, int]):
    """The number of digits of a value without a mark; 0 for others, -1 for unknown ones."""

    def __missing__(self, token: str) -> int:
        if _BARE.fullmatch(token) and (len(token) <= 8 or not _BITS.fullmatch(token)):
            width = len(token)
        else:
            width = -1 if _UNKNOWN.fullmatch(token) else 0
        if len(token) <= 8 and len(self) < 1 << 14:
            self[token] = width
        return width


WIDTH = _Widths()

# Strings

_NAMED = {"a": "\a", "b": "\b", "t": "\t", "n": "\n", "v": "\v", "f": "\f", "r": "\r", "e": "\x1b"}
_ESCAPES = {
    is_decimal: re.compile(
        rf"\\(?:[xXu]\{{({_H}{{1,2}})\}}|(?:[xX]|u00)({_H}{{1,2}})|({digits})|([A-Za-z\W]))", re.DOTALL
    )
    for is_decimal, digits in ((False, "[0-3]?[0-7]{1,2}"), (True, r"\d{1,3}"))
}


class _Characters(dict[str, str]):
    """The characters of escapes, each worked out once."""

    def __init__(self, *, is_decimal: bool) -> None:
        self._is_decimal = is_decimal

    def __missing__(self, escape: str) -> str:
        found = _ESCAPES[self._is_decimal].fullmatch(escape)
        assert found is not None
        braced, digits, number, letter = found.groups()
        if letter is not None:
            # A letter without a meaning is itself after its backslash, as in Python.
            return _NAMED.get(letter, escape if letter.isalpha() else letter)
        code = int(braced or digits, 16) if number is None else int(number, 10 if self._is_decimal else 8)
        return self.setdefault(escape, chr(code))


_CHARACTERS = {is_decimal: _Characters(is_decimal=is_decimal) for is_decimal in (False, True)}


def literal(body: str, *, is_decimal: bool = False) -> bytes | None:
    r"""Returns the bytes of what is between two quotes; None where a character is not a byte.

    Args:
        body: The characters between the quotes.
        is_decimal: `\128` is one byte, as in Lua; otherwise digits are octal.
    """
    try:
        known = _CHARACTERS[is_decimal]
        return _ESCAPES[is_decimal].sub(lambda found: known[found[0]], body).encode("latin-1")
    except UnicodeEncodeError:
        return None


def _body(token: str) -> str:
    mark = token[-1]
    at = token.find(mark)
    # Escapes without quotes: a full stop or a bracket after the last is not a byte of it.
    return token[at + 1 : -1] if mark in "\"'`" and at < len(token) - 1 else token


def _base64(text: str) -> bytes | None:
    """Returns the bytes of base64, with either alphabet, padded or not."""
    digits = text.rstrip("=").replace("-", "+").replace("_", "/")
    try:
        return binascii.a2b_base64(digits + "=" * (-len(digits) % 4), strict_mode=True)
    except binascii.Error:
        return None


# Names

_INTEGER = re.compile(r"-?(?:0[xX][0-9a-fA-F]{1,8}|0|[1-9]\d{0,9})")
_CALL = re.compile(r"(LC[0124SXF]|[LG]V[0124X]|LAB1)\s?\(\s*([^()]*?)\s*\)")
_constants: dict[str, bytes] = {}


def _constant(text: str) -> bytes | None:
    """Returns the bytes of a name or of one of LEGO's macros; None where the tables do not have it."""
    if not _constants:
        found = {name: names.constant(name) for name in names.constant_names()}
        _constants.update({f"op{opcode.name}": bytes((opcode.number,)) for opcode in OPCODES})
        for name, value in found.items():
            if isinstance(value, bytes) or (isinstance(value, int) and 0 <= value <= 255):
                _constants[name] = value if isinstance(value, bytes) else bytes((value,))
        _constants.update({name: bytes((member,)) for name, member in MessageType.__members__.items()})
    call = _CALL.fullmatch(text)
    if call is None:
        return _constants.get(text)
    macro, inner = call.groups()
    try:
        if macro == "LCS":
            return names.LCS(inner[1:-1]) if len(inner) > 1 and inner[0] == inner[-1] in "\"'" else None
        if _INTEGER.fullmatch(inner):
            value = int(inner, 0)
        else:
            # A name is encoded already: the macro gets the number that it has.
            data = _constants[inner]
            value = int.from_bytes(data[1:] or bytes((data[0] << 2 & 0xFF,)), "little", signed=True)
            value >>= 2 * (len(data) == 1)
        encode: Callable[[int], bytes] | None = getattr(names, macro, None)
        return encode_as(macro, value) if encode is None else encode(value)
    except (BuildError, KeyError):
        return None


# The table of notations


class Notation(NamedTuple):
    """A way of writing bytes.

    run       finds a run of values; a match without its group `run` is to be skipped
    value     finds the next value of a run, and what is in front of it
    likely    returns the names of the readings of some values, the likeliest first
    """

    name: str
    run: re.Pattern[str]
    value: re.Pattern[str]
    likely: Callable[[list[str], frozenset[int]], tuple[str, ...]]


TABLES = {
    "hex": _number(_hex),
    "decimal": _number(lambda text: _sized(text, 10, 1) if len(text) <= 3 else None),
    "octal": _number(
        lambda text: _sized(text, 8, 1) if len(text) <= 3 or (len(text) == 4 and text[0] == "0") else None
    ),
    "number": _number(_unpadded),
    "bits": _number(_bits),
    "words": _number(lambda text: bytes.fromhex(text)[::-1] if len(text) in (2, 4, 6, 8) else None),
    "decimal words": _number(lambda text: _sized(text, 10, 2) if len(text) == 5 else None),
    "octal words": _number(lambda text: _sized(text, 8, 2) if len(text) == 6 else None),
    "string": Table(lambda token: literal(_body(token))),
    "decimal string": Table(lambda token: literal(_body(token), is_decimal=True)),
    "base64": Table(_base64),
}
UNLIKELY = ("octal", "number", "words", "decimal words", "octal words")
"""The readings whose frames must not have a flaw."""
_OF_WIDTH = {
    "octal": {3, 4},
    "number": {1, 8},
    "bits": {8},
    "words": {4, 8},
    "decimal words": {5},
    "octal words": {6},
}
"""Widths of digits one of which must be in a run to be read so."""


def _numbers_likely(tokens: list[str], widths: frozenset[int]) -> tuple[str, ...]:
    if 8 in widths and {*"".join(token for token in tokens if WIDTH[token] > 0)} <= {"0", "1"}:
        return ("bits",) if len(tokens) > 2 else ("bits", "hex")
    has_zero = {1, 2} < widths and any(len(token) == 2 and token[0] == "0" for token in tokens)
    return _likely_by_width(widths, has_zero=has_zero)


@cache
def _likely_by_width(widths: frozenset[int], *, has_zero: bool) -> tuple[str, ...]:
    bare = widths - {0, -1}
    if not bare:
        return ("hex",)
    is_padded = bare == {2} or max(bare) >= 4 or has_zero
    found = ("hex", "decimal") if is_padded and 0 not in widths else ("decimal", "hex")
    return (*found, *(name for name, needed in _OF_WIDTH.items() if bare & needed))


def _strings_likely(tokens: list[str], _: frozenset[int]) -> tuple[str, ...]:
    has_digits = any(_DIGIT_ESCAPE.search(token) for token in tokens)
    return ("string", "decimal string") if has_digits else ("string",)


_DIGIT_ESCAPE = re.compile(r"\\\d")


def _quoted(*, has_escape: bool) -> str:
    # A literal within another is skipped.
    ahead = r"(?=[^{0}\\]*\\)(?!b?{1}[^{0}]*{1}{0})" if has_escape else ""
    body = "|".join(
        f"{{0}}{ahead}(?:[^{{0}}\\\\]|\\\\.)*+{{0}}".replace("{0}", mark).replace("{1}", other)
        for mark, other in ("\"'", "'\"", "`'")
    )
    return rf"(?:(?<![\w\\])(?:b|B|rb|br|u8|u|U|L|@|\$|c))?(?:{body})"


_ESCAPED, _ANY = _quoted(has_escape=True), _quoted(has_escape=False)
_LOOSE = rf"\\(?:[xX]\{{?{_H}{{1,2}}\}}?|u00{_H}{{2}}|u\{{{_H}{{1,2}}\}}|[0-3]?[0-7]{{1,2}}|[abtnvfre\\\"' #])"
_FREE = rf"(?:{_LOOSE}){{2}}(?:{_LOOSE}|[!#-&(-\[\]-~](?=[^\s]))*+"
_BETWEEN = r"(?:[\s+&()\[\],;]|\\(?=\s|$)|\.(?=\s?[bB\"'$])|bytes\(|bytearray\()*+"
_DIGIT64 = "[A-Za-z0-9+/_-]"
NUMBERS = Notation(
    "numbers",
    re.compile(
        rf"(?=[0-9a-fA-FxXLGMo:$&#'\\+<-])(?:(?a:{_FOREIGN})|(?P<run>(?:{_VALUE})(?:{_PLAIN_VALUES}|{_GAP}{{0,160}}+(?:{_VALUE}))*+))"
    ),
    re.compile(rf"{_GAP}*+({_VALUE})"),
    _numbers_likely,
)
STRINGS = Notation(
    "strings",
    re.compile(rf"(?P<run>{_ESCAPED}(?:{_BETWEEN}{_ANY})*+|(?<!\w){_FREE}(?:[\s,]{{0,4}}{_FREE})*+)", re.DOTALL),
    re.compile(rf"{_BETWEEN}({_ANY}|{_FREE}|{_LOOSE})", re.DOTALL),
    _strings_likely,
)
BASE64 = Notation(
    "base64",
    # A frame begins with a length below 1024, and its fifth byte is a type.
    re.compile(
        rf"(?<![\w+/.-])(?P<run>{_DIGIT64}[AQgw][A-P]{_DIGIT64}{{2}}[AQgwIYo4][A-Xg-r]{_DIGIT64}+={{0,3}})(?![\w+/=.])"
    ),
    re.compile(rf"\s*({_DIGIT64}+={{0,3}})"),
    lambda *_: ("base64",),
)
EACH = re.compile(rf"(?=[0-9a-fA-FxXLGMo:$&#'\\+<-])(?:(?a:{_FOREIGN})|({_VALUE}))")
"""Each number of a line, whatever is between them."""
ANY_STRING = re.compile(rf"(?P<run>{_ANY}(?:{_BETWEEN}{_ANY})*+|(?:{_LOOSE}|{_FREE})++)", re.DOTALL)


def values_in(notation: Notation, line: str, start: int, end: int) -> list[str]:
    """Returns the values in a run."""
    # Where nothing but plain values is in a run, each word is one.
    is_plain = _IS_PLAIN.fullmatch(line, start, end)
    return _WORDS.findall(line, start, end) if is_plain else notation.value.findall(line, start, end)


_IS_PLAIN = re.compile(f"[{_H[1:-1]}\\s,:|]*+")
_WORDS = re.compile(r"\w+")


def joined(tokens: Iterable[str], name: str) -> bytes | None:
    """Returns the bytes of all values in a reading; None where one has none."""
    try:
        return b"".join(map(TABLES[name].__getitem__, tokens))  # type: ignore[arg-type]
    except TypeError:
        return None
