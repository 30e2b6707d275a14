r"""String literals and names of constants to bytes.

Two readings of literals differ: `\128` is a byte in Lua, and in all others an octal escape and a digit.
"""

from __future__ import annotations

import re

from ev3proto.errors import BuildError
from ev3proto.schema.argument import encode_as
from ev3proto.schema.names import GVX, LAB1, LCF, LCS, LCX, LVX, constant, constant_names
from ev3proto.tables import OPCODES
from ev3proto.tables.frame import MessageType

_CHARACTERS = {"a": 7, "b": 8, "t": 9, "n": 10, "v": 11, "f": 12, "r": 13, "e": 27}
_ESCAPE = re.compile(
    r"\\(?:[xXu]\{(?P<braced>[0-9a-fA-F]{1,2})\}|(?:[xX]|u00)(?P<hex>[0-9a-fA-F]{1,2})"
    r"|(?P<octal>[0-3]?[0-7]{1,2})|(?P<character>[^\w])|(?P<letter>[A-Za-z]))"
)
_DECIMAL = re.compile(_ESCAPE.pattern.replace("[0-3]?[0-7]{1,2}", r"\d{1,3}"))
_CALL = re.compile(r"(?P<macro>LC[0124SXF]|[LG]V[0124X]|LAB1)\s?\(\s*(?P<inner>[^()]*)\)")
_NUMBER = re.compile(r"-?(?:0[xX][0-9a-fA-F]{1,8}|0|[1-9]\d{0,9})")
_BY_NAME = {"LCX": LCX, "LVX": LVX, "GVX": GVX, "LCF": LCF, "LAB1": LAB1}
_OPCODES = frozenset(f"op{opcode.name}" for opcode in OPCODES)


def literal(body: str, *, is_decimal: bool) -> bytes | None:
    r"""Returns the bytes of what is between two quotes; None where a character or an escape is not a byte.

    Args:
        body: The characters between the quotes.
        is_decimal: `\128` is one byte, as in Lua; otherwise digits are octal.
    """
    out = bytearray()
    at = 0
    pattern = _DECIMAL if is_decimal else _ESCAPE
    while at < len(body):
        start, at = at, body.find("\\", at)
        plain = body[start:] if at < 0 else body[start:at]
        try:
            out += plain.encode("latin-1")
        except UnicodeEncodeError:
            return None
        if at < 0:
            break
        found = pattern.match(body, at)
        if found is None:
            return None
        at = found.end()
        kind, text = found.lastgroup or "", found[found.lastgroup or 0]
        if kind == "letter" and text not in _CHARACTERS:
            # A letter without a meaning is itself after its backslash, as in Python.
            out += b"\\" + text.encode()
            continue
        if kind == "character":
            number = ord(text)
        elif kind == "letter":
            number = _CHARACTERS[text]
        else:
            number = int(text, 16 if kind != "octal" else 10 if is_decimal else 8)
        if number > 255:
            return None
        out.append(number)
    return bytes(out)


def constant_bytes(text: str) -> bytes | None:
    """Returns the bytes of a name or of one of LEGO's macros; None where the tables do not have it."""
    call = _CALL.fullmatch(text)
    if call is None:
        return _named(text)
    macro, inner = call["macro"], call["inner"].strip()
    try:
        if macro == "LCS":
            is_plain = len(inner) >= 2 and inner[0] in "\"'" and inner[-1] == inner[0] and "\\" not in inner
            return LCS(inner[1:-1]) if is_plain else None
        value = int(inner, 0) if _NUMBER.fullmatch(inner) else _number(inner)
        if value is None:
            return None
        return _BY_NAME[macro](value) if macro in _BY_NAME else encode_as(macro, value)
    except (BuildError, ValueError):
        return None


def _number(name: str) -> int | None:
    """Returns the number of a name in a macro's brackets: what its encoding holds, if it is encoded already."""
    data = _named(name)
    if data is None:
        return None
    if len(data) == 1:
        return data[0] - 0x40 if 0x20 <= data[0] <= 0x3F else data[0]
    return int.from_bytes(data[1:], "little", signed=True)


def _named(name: str) -> bytes | None:
    if name in MessageType.__members__:
        return bytes((MessageType[name],))
    if name not in _OPCODES and name not in constant_names():
        return None
    value = constant(name)
    if isinstance(value, int):
        return bytes((value,)) if 0 <= value <= 255 else None
    return value if isinstance(value, bytes) else None
