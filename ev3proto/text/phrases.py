"""How single things are said: a value with its unit and name, bytes as hex, a float with no more digits than it has."""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Iterator

from ev3proto.dialogue import Value, ValueType
from ev3proto.messages import Argument, SystemCommand, SystemReply
from ev3proto.tables.encoding import GLOBAL, LOCAL, TEXT
from ev3proto.tables.mailboxes import Reading

_LETTERS = {LOCAL: "L", GLOBAL: "G"}
_encode = json.JSONEncoder(ensure_ascii=False).encode
_SINGLE = struct.Struct("<f")


def short_float(value: float) -> str:
    """A single-precision float in as few digits as tell it from its neighbours: `7.92`, not `7.920000076293945`."""
    if not math.isfinite(value):
        return str(value)
    single = _SINGLE.pack(value)
    # Six digits always come through a single and back, so fewer need not be tried: zeros at the end are left off.
    for digits in range(6, 10):
        text = f"{value:.{digits}g}"
        try:
            if _SINGLE.pack(float(text)) == single:
                break
        except OverflowError:
            continue
    number = float(text)
    return repr(int(number)) + ".0" if number.is_integer() and abs(number) < 1e7 else repr(number)


def quoted(text: str) -> str:
    """A text in double quotes, control characters escaped, letters of every language as they are."""
    return _encode(text)


def spaced_hex(data: bytes) -> str:
    """`0E 00 2A`."""
    return data.hex(" ").upper()


def plain(value: ValueType) -> str:
    """A value alone: numbers, quoted texts, lists in brackets, bytes as hex (long ones cut, with their number)."""
    if type(value) is int:
        return str(value)
    if isinstance(value, str):
        return quoted(value)
    if isinstance(value, float):
        return short_float(value)
    if isinstance(value, bytes):
        return spaced_hex(value) if len(value) <= 24 else f"{spaced_hex(value[:24])} ... ({len(value)} bytes)"
    if isinstance(value, list):
        return f"[{', '.join(plain(item) for item in value)}]"
    return str(value)


def reading_text(value: Reading) -> str:
    """A reading of a mailbox's message: `"hi"`, `1.5`, `true`."""
    return str(value).lower() if isinstance(value, bool) else plain(value)


def field_texts(message: SystemCommand | SystemReply) -> Iterator[tuple[str, str, str]]:
    """Each field of a system message: its name, its value, and its meaning where its bytes are a mailbox's message.

    The meaning names each reading that fits: `logic false or text ""`.
    """
    found = message.readings if isinstance(message, SystemCommand) else {}
    meaning = " or ".join(f"{kind} {reading_text(value)}" for kind, value in found.items())
    for name, value in message.fields.items():
        yield name, plain(value), meaning if isinstance(value, bytes) else ""


def argument_value(argument: Argument) -> str:
    """An argument's value: `440`, `"myEV3"`, `GV(0)`, with handle and address marked."""
    form, text = argument.form, plain(argument.value)
    if form.kind in _LETTERS:
        text = f"{_LETTERS[form.kind]}V({text})"
    if form.handle:
        text = f"handle {text}"
    return f"address {text}" if form.address else text


def argument_meaning(argument: Argument) -> str:
    """What the tables know of a constant: its name in the enumeration, or its special meaning, or else its unit."""
    parameter, value = argument.parameter, argument.value
    if argument.form.kind in (LOCAL, GLOBAL, TEXT):
        return ""
    symbol = argument.symbol
    if symbol is not None:
        return symbol
    if parameter.special and isinstance(value, int) and value in parameter.special:
        return parameter.special[value]
    return parameter.unit or ""


def value_text(value: Value) -> str:
    """A value from a reply: `7.92 V`, `16 (TYPE_TOUCH)`, `-128 (not a number: there is no value)`."""
    if value.is_nan:
        return f"{plain(value.value)} (not a number: there is no value)"
    text = plain(value.value)
    if isinstance(value.symbol, list):
        return f"{text} ({', '.join(name or '?' for name in value.symbol)})"
    if value.symbol is not None:
        return f"{text} ({value.symbol})"
    return f"{text} {value.unit}" if value.unit else text
