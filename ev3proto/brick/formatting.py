"""Numbers as texts, in the formats of C's printf, and numbers read from texts, as by its scanf."""

from __future__ import annotations

import math
import re

MOST_CHARACTERS = 4096
"""Maximum width and precision of a format, more than fits in any text of the brick."""

_UNSIGNED = frozenset("uxXo")
_WHOLE = _UNSIGNED | frozenset("dic")
_FRACTIONS = frozenset("fFeEgG")

_CONVERSION = re.compile(
    rb"%(?P<flags>[-+ 0#']*)(?P<width>\d*)(?:\.(?P<precision>-?\d*))?(?P<size>hh|h|ll|l|L|q|j|z|t)?(?P<kind>[a-zA-Z%])?"
)

_NUMBER = re.compile(
    rb"[ \t\n\v\f\r]*(?P<number>[+-]?(?:"
    rb"(?P<hex>0[xX](?:[0-9a-fA-F]+\.?[0-9a-fA-F]*|\.[0-9a-fA-F]+)(?:[pP][+-]?\d+)?)"
    rb"|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|inf(?:inity)?|nan))",
    re.IGNORECASE,
)


def fixed(value: float, decimals: int) -> str:
    """Returns `%.<decimals>f`; a negative number of decimals counts as omitted, which is 6."""
    if value != value:
        return "-nan" if math.copysign(1.0, value) < 0 else "nan"
    if value in (float("inf"), float("-inf")):
        return "inf" if value > 0 else "-inf"
    return f"{value:.{decimals if decimals >= 0 else 6}f}"


def padded(text: str, figures: int) -> str:
    """Pads a number's text with spaces to a width: on the left, or on the right for a negative width."""
    return text.rjust(figures) if figures >= 0 else text.ljust(-figures)


def formatted(pattern: bytes, value: int | float, most: int = MOST_CHARACTERS) -> bytes:
    """Writes a number in a format of C's printf; every conversion gets it (in the firmware, only the first).

    Returns:
        At most `most` bytes; what would follow is not computed.
    """
    text, at = b"", 0
    pattern = pattern[:MOST_CHARACTERS]
    for found in _CONVERSION.finditer(pattern):
        text += pattern[at : found.start()] + _converted(found, value)
        at = found.end()
        if len(text) >= most:
            break
    else:
        text += pattern[at:]
    return text[:most]


def _converted(found: re.Match[bytes], value: int | float) -> bytes:
    kind = (found["kind"] or b"").decode("ascii")
    if kind == "%":
        return b"%"
    flags = found["flags"].decode("ascii").replace("'", "")
    width = min(int(found["width"] or 0), MOST_CHARACTERS)
    precision = found["precision"]
    # A negative precision counts as omitted.
    digits = None if precision is None or precision.startswith(b"-") else min(int(precision or 0), MOST_CHARACTERS)
    if kind in _WHOLE:
        number = _narrowed(int(value) if math.isfinite(value) else 0, found["size"], kind)
        return _whole(kind, flags, width, digits, number)
    if kind not in _FRACTIONS:
        # Other conversions read memory that is not there (%s, %n), or are unknown: they are shown as written.
        return found[0]
    if not math.isfinite(value):
        return _not_finite(flags, width, kind, float(value))
    return _written(kind, flags, width, digits, float(value))


def _whole(kind: str, flags: str, width: int, digits: int | None, number: int) -> bytes:
    """Writes an integer by C's rules, where Python's differ."""
    if digits is not None or kind == "c":
        flags = flags.replace("0", "")
    if kind == "c":
        return _written(kind, flags, width, None, number & 0xFF)
    if kind in _UNSIGNED:
        number &= 0xFFFFFFFF
        flags = re.sub(r"[+ ]" if number else r"[+ #]", "", flags)
    if kind == "o" and "#" in flags:
        flags, digits = flags.replace("#", ""), max(digits or 0, len(f"{number:o}") + 1)
    return _written(kind, flags, width, digits, number)


def _written(kind: str, flags: str, width: int, digits: int | None, number: float) -> bytes:
    precision = "" if digits is None else f".{digits}"
    return f"%{flags}{width or ''}{precision}{kind}".encode() % number


def _narrowed(value: int, size: bytes | None, kind: str) -> int:
    """Returns the value cut to 8 or 16 bits for `hh` or `h`; unchanged for other sizes."""
    bits = {b"hh": 8, b"h": 16}.get(size or b"")
    if bits is None:
        return value
    number = value & (1 << bits) - 1
    return number - (1 << bits) if kind in ("d", "i") and number >> bits - 1 else number


def _not_finite(flags: str, width: int, kind: str, value: float) -> bytes:
    """Returns infinity, or NaN with its sign, which Python's own formats do not write."""
    sign = "-" if math.copysign(1.0, value) < 0 else "+" if "+" in flags else " " if " " in flags else ""
    text = sign + ("nan" if value != value else "inf")
    text = text.upper() if kind.isupper() else text
    return padded(text, -width if "-" in flags else width).encode()


def read_number(text: bytes) -> float | None:
    """Returns the number at the start of a text, as scanf reads it by %f; None if it does not start with one."""
    found = _NUMBER.match(text)
    if found is None:
        return None
    number = found["number"].decode("ascii")
    if found["hex"] is None:
        return float(number)
    try:
        return float.fromhex(number)
    except OverflowError:
        return float("-inf") if number.startswith("-") else float("inf")
