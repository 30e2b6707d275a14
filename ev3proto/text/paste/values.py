r"""The bytes of one value, in each reading: `0x0f`, `15`, `017`, `"\x0f\0"`, `LC2(1000)`, `xx`.

Each reading is a table from the text of a value to its bytes, which is filled as values come. So the bytes of a run are
one join, whatever the notation.
"""

from __future__ import annotations

import binascii
import re
from collections.abc import Callable, Iterable

from ev3proto.errors import BuildError
from ev3proto.schema import names
from ev3proto.schema.argument import encode_as
from ev3proto.tables import OPCODES
from ev3proto.tables.frame import MessageType

_LONGEST_KEPT = 8
_MOST_KEPT = 1 << 14

Parse = Callable[[str], bytes | None]


class Table(dict[str, bytes | None]):
    """The bytes of values in one reading; None where a value has none."""

    def __init__(self, parse: Parse) -> None:
        self._parse = parse

    def __missing__(self, token: str) -> bytes | None:
        data = self._parse(token)
        if len(token) <= _LONGEST_KEPT and len(self) < _MOST_KEPT:
            self[token] = data
        return data


# Numbers

_H = "[0-9a-fA-F]"
_BITS = re.compile(r"(?:0[bB]|#b|B)?([01]{4})_?([01]{4})")
_HEX = re.compile(rf"(?:\\?0[xX]|\\[xX]|\#?\$|&[hH]|\#[xX]|[xX])'?({_H}+).*|({_H}+)[hH]&?")
_DECIMAL = re.compile(r"(\d+)(?:_?u8|[uU]?[yYlL]|[lL]?[uU]|\.to\w+\(\))")
_UNKNOWN = re.compile(rf"(?:0[xX]|\\x)?(?:{_H}{{2}})*(?:[xX]{{2}}|[mM]{{2}})(?:{_H}{{2}}|[xX]{{2}}|[mM]{{2}})*")
_UNKNOWN_BYTE = re.compile("[xXmM]{2}|..", re.DOTALL)


EXPRESSION = "\ufffc"
"""An unknown byte in the place of an expression."""


class _Widths(dict[str, int]):
    """The number of digits of a value without a mark; 0 for others, -1 for those with unknown bytes."""

    def __missing__(self, token: str) -> int:
        if token.strip("0123456789abcdefABCDEF"):
            width = -1 if is_unknown(token) else 0
        else:
            # 0b00001111 has hex digits only, too.
            width = 0 if len(token) > 8 and _BITS.fullmatch(token) else len(token)
        if len(token) <= _LONGEST_KEPT and len(self) < _MOST_KEPT:
            self[token] = width
        return width


def is_unknown(token: str) -> bool:
    """Whether some bytes of a value are not known: `xx`, `XXXX`, `MM`, `0F00xxxx`."""
    return token == EXPRESSION or _UNKNOWN.fullmatch(token) is not None


WIDTH = _Widths()


def unknown_bytes(token: str) -> list[bool]:
    """Returns for each byte of a value whether it is unknown."""
    if token == EXPRESSION:
        return [True]
    digits = token[2:] if token[:2] in ("0x", "0X", "\\x") else token
    return [pair[0] in "xXmM" for pair in _UNKNOWN_BYTE.findall(digits)] if WIDTH[token] < 0 else []


def _hex(digits: str) -> bytes | None:
    if len(digits) == 8 and digits[:6].lower() == "ffffff":
        # A negative byte of Java or C, spread over 32 bits.
        return bytes.fromhex(digits[6:])
    return bytes.fromhex(digits.zfill(2)) if len(digits) == 1 or len(digits) % 2 == 0 else None


def marked(token: str) -> bytes | None:
    """Returns the bytes of a value whose mark, sign or name says what it is: `0x0f`, `-128`, `0Fh`, `15u`, `opNOP`."""
    if WIDTH[token] < 0:
        digits = "00" if token == EXPRESSION else token[2 * (token[:2] in ("0x", "0X", "\\x")) :]
        return bytes.fromhex(re.sub("[xXmM]", "0", digits))
    if found := _HEX.fullmatch(token):
        return _hex(found[1] or found[2])
    if found := _BITS.fullmatch(token):
        return bytes((int(found[1] + found[2], 2),))
    if token[0] == "-":
        return bytes((int(token) & 0xFF,)) if -128 <= int(token) < 0 else None
    if found := _DECIMAL.fullmatch(token):
        return _sized(found[1], 10, 1)
    return None if token.isalnum() and token[0].isdigit() else constant(token)


def _sized(text: str, base: int, size: int) -> bytes | None:
    if not text.isdecimal() or (base == 8 and {"8", "9"} & {*text}):
        return None
    number = int(text[:9], base)
    return number.to_bytes(size, "little") if number < 1 << 8 * size else None


def _unpadded(text: str) -> bytes | None:
    number = int(text, 16) if len(text) in (1, 2, 8) else -1
    return bytes((number & 0xFF,)) if 0 <= number < 256 or number >= 0xFFFFFF80 else None


def _bits(text: str) -> bytes | None:
    is_bits = len(text) % 8 == 0 and {*text} <= {"0", "1"}
    return int(text, 2).to_bytes(len(text) // 8, "big") if is_bits else None


def _number(digits: Parse) -> Table:
    """Returns a reading of bare digits; values with a mark have the same bytes in all."""
    return Table(lambda token: digits(token) if WIDTH[token] > 0 else marked(token))


# Strings

_NAMED = {"a": "\a", "b": "\b", "t": "\t", "n": "\n", "v": "\v", "f": "\f", "r": "\r", "e": "\x1b"}
_ESCAPES = {
    is_decimal: re.compile(
        rf"\\(?:[xXu]\{{({_H}{{1,2}})\}}|(?:[xX]|u00)({_H}{{1,2}})|({digits})|([A-Za-z\W]))", re.DOTALL
    )
    for is_decimal, digits in ((False, "[0-3]?[0-7]{1,2}"), (True, r"\d{1,3}"))
}


MISSPELT = re.compile(r"(?<!\\)(?:\\\\)*(?P<escape>\\[xX](?!\{?[0-9a-fA-F]).{0,2})")
"""An escape without hex digits, such as `\\xof`."""


class _Characters(dict[str, str]):
    """The characters of escapes."""

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


def _literal(token: str, *, is_decimal: bool = False) -> bytes | None:
    r"""Returns the bytes of a string; None where a character is not a byte.

    Args:
        token: The string, with its quotes if it has some.
        is_decimal: `\128` is one byte, as in Lua; otherwise digits are octal.
    """
    mark = token[-1]
    at = token.find(mark)
    body = token[at + 1 : -1] if mark in "\"'`" and at < len(token) - 1 else token
    if MISSPELT.search(body):
        return None
    try:
        known = _CHARACTERS[is_decimal]
        return _ESCAPES[is_decimal].sub(lambda found: known[found[0]], body).encode("latin-1")
    except UnicodeEncodeError:
        return None


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


def constant(text: str) -> bytes | None:
    """Returns the bytes of a name or of one of LEGO's macros; None where the tables do not have it."""
    if not _constants:
        found = {name: names.constant(name) for name in names.constant_names()}
        _constants.update({f"op{opcode.name}": bytes((opcode.number,)) for opcode in OPCODES})
        for name, value in found.items():
            if isinstance(value, bytes) or (isinstance(value, int) and 0 <= value <= 255):
                _constants[name] = value if isinstance(value, bytes) else bytes((value,))
        _constants.update({name: bytes((member,)) for name, member in MessageType.__members__.items()})
    text = text.partition(".")[2] if text[:1].islower() and not text.startswith("op") and "." in text else text
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


READINGS = {
    "hex": _number(_hex),
    "decimal": _number(lambda text: _sized(text, 10, 1) if len(text) <= 3 else None),
    "octal": _number(
        lambda text: _sized(text, 8, 1) if len(text) <= 3 or (len(text) == 4 and text[0] == "0") else None
    ),
    "number": _number(_unpadded),
    "bits": _number(_bits),
    "words": _number(lambda text: bytes.fromhex(text)[::-1] if len(text) in (2, 4, 6, 8) else None),
    "string": Table(_literal),
    "decimal string": Table(lambda token: _literal(token, is_decimal=True)),
    "base64": Table(_base64),
}
"""The readings that the values of a run may have."""

UNLIKELY = ("octal", "number", "words")
"""The readings whose frames must not have a flaw."""


def joined(tokens: Iterable[str], name: str) -> bytes | None:
    """Returns the bytes of all values in a reading; None where one has none."""
    try:
        return b"".join(map(READINGS[name].__getitem__, tokens))  # type: ignore[arg-type]
    except TypeError:
        return None
