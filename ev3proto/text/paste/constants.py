"""Names in arrays of bytes: `opOUTPUT_POWER, LC0(0), DIRECT_COMMAND_NO_REPLY`, as programs write them."""

from __future__ import annotations

from functools import cache

from ev3proto.errors import BuildError
from ev3proto.tables.frame import MessageType
from ev3proto.text.late_pattern import late_pattern

_CALL = late_pattern(r"(?P<macro>LC[0124SXF]|[LG]V[0124X]|LAB1)\s*\(\s*(?P<inner>[^()]*)\)")
_NUMBER = late_pattern(r"-?(?:0[xX][0-9a-fA-F]{1,8}|0|[1-9]\d{0,9})")


def constant_bytes(text: str) -> bytes | None:
    """The bytes of a name or of one of LEGO's macros; None where the tables do not have it."""
    from ev3proto.schema import names
    from ev3proto.schema.argument import encode_as

    call = _CALL.fullmatch(text)
    if call is None:
        return _named(text)
    macro, inner = call["macro"], call["inner"].strip()
    try:
        if macro == "LCS":
            is_plain = len(inner) >= 2 and inner[0] in "\"'" and inner[-1] == inner[0] and "\\" not in inner
            return names.LCS(inner[1:-1]) if is_plain else None
        value = _value(inner)
        if value is None:
            return None
        # Both are functions of the flat names, which find the shortest encoding.
        by_name = {"LCX": names.LCX, "LVX": names.LVX, "GVX": names.GVX, "LCF": names.LCF, "LAB1": names.LAB1}
        return by_name[macro](value) if macro in by_name else encode_as(macro, value)
    except (BuildError, ValueError):
        return None


def _value(text: str) -> int | None:
    """The number that stands in a macro's brackets, as digits or as a name."""
    if _NUMBER.fullmatch(text):
        return int(text, 0)
    data = _named(text)
    if data is None:
        return None
    # A constant of the instruction set is encoded already: its number is what the encoding holds.
    if len(data) == 1:
        return data[0] - 0x40 if 0x20 <= data[0] <= 0x3F else data[0]
    return int.from_bytes(data[1:], "little", signed=True)


@cache
def _known() -> frozenset[str]:
    from ev3proto.schema.names import constant_names
    from ev3proto.tables import OPCODES

    return frozenset({*constant_names(), *(f"op{opcode.name}" for opcode in OPCODES)})


def _named(name: str) -> bytes | None:
    from ev3proto.schema.names import constant

    if name in MessageType.__members__:
        return bytes((MessageType[name],))
    if name not in _known():
        return None
    value = constant(name)
    if isinstance(value, int):
        return bytes((value,)) if 0 <= value <= 255 else None
    return value if isinstance(value, bytes) else None
