"""Numbers as texts, in the formats of C's printf, and numbers read from texts, as by its scanf."""

from __future__ import annotations

import math
import re
from typing import Any

MOST_CHARACTERS = 4096
"""Width and precision beyond which a format is cut: no text of the brick has that much room."""

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
    """`%.<decimals>f`; a negative number of decimals counts as omitted, which is 6."""
    if value != value:
        return "-nan" if _is_negative(value) else "nan"
    if value in (float("inf"), float("-inf")):
        return "inf" if value > 0 else "-inf"
    return f"{value:.{decimals if decimals >= 0 else 6}f}"


def padded(text: str, figures: int) -> str:
    """A number's text filled up with blanks to some figures: on the left, or on the right for a negative number."""
    return text.rjust(figures) if figures >= 0 else text.ljust(-figures)


def formatted(pattern: bytes, value: int | float) -> bytes:
    """One number in a format of C's printf.

    Args:
        pattern: The format; every conversion in it gets the same value, where the firmware has one for the first only.
        value: An int is passed as 32 bits, a float as a double. Where a conversion wants the other kind, which C leaves
            undefined, it is converted.
    """
    return _CONVERSION.sub(lambda found: _converted(found, value), pattern)


def _converted(found: re.Match[bytes], value: int | float) -> bytes:
    kind = (found["kind"] or b"").decode("ascii")
    if kind == "%":
        return b"%"
    flags = found["flags"].decode("ascii").replace("'", "")
    width = min(int(found["width"] or 0), MOST_CHARACTERS)
    precision = None if found["precision"] is None else _precision(found["precision"])
    if kind in ("d", "i", "u", "x", "X", "o", "c"):
        return _integer(flags, width, precision, kind, _narrowed(value, found["size"], kind))
    if kind in ("f", "F", "e", "E", "g", "G"):
        return _float(flags, width, precision, kind, float(value))
    if kind in ("a", "A"):
        return _hexadecimal(flags, width, precision, kind, float(value))
    # Other conversions read memory that is not there (%s, %n) or are none: they are shown as they stand.
    return found[0]


def _precision(text: bytes) -> int | None:
    """The precision; one that is negative counts as omitted."""
    return None if text.startswith(b"-") else min(int(text or 0), MOST_CHARACTERS)


def _narrowed(value: Any, size: bytes | None, kind: str) -> Any:
    """The value as `hh` or `h` take it, as 8 or 16 bits; other sizes take all of it."""
    bits = {b"hh": 8, b"h": 16}.get(size or b"")
    if bits is None or value != value or abs(value) == float("inf"):
        return value
    number = int(value) & (1 << bits) - 1
    return number - (1 << bits) if kind in ("d", "i") and number >> bits - 1 else number


def _integer(flags: str, width: int, precision: int | None, kind: str, value: Any) -> bytes:
    number = int(value) if value == value and abs(value) != float("inf") else 0
    if kind == "c":
        return _padded(flags.replace("0", ""), width, b"", bytes((number & 0xFF,)))
    if kind in ("d", "i"):
        digits = str(abs(number))
        sign = "-" if number < 0 else "+" if "+" in flags else " " if " " in flags else ""
    else:
        unsigned = number & 0xFFFFFFFF
        digits = {"u": "{}", "x": "{:x}", "X": "{:X}", "o": "{:o}"}[kind].format(unsigned)
        sign = {"x": "0x", "X": "0X"}.get(kind, "") if "#" in flags and unsigned else ""
        if kind == "o" and "#" in flags and not digits.startswith("0"):
            digits = "0" + digits
    if precision is not None:
        digits = "" if precision == 0 and number == 0 else digits.rjust(precision, "0")
        flags = flags.replace("0", "")
    return _padded(flags, width, sign.encode(), digits.encode())


def _float(flags: str, width: int, precision: int | None, kind: str, value: float) -> bytes:
    negative = _is_negative(value)
    sign = b"-" if negative else b"+" if "+" in flags else b" " if " " in flags else b""
    if value != value or abs(value) == float("inf"):
        text = "nan" if value != value else "inf"
        return _padded(flags.replace("0", ""), width, sign, (text.upper() if kind.isupper() else text).encode())
    alternate = "#" if "#" in flags else ""
    digits = format(abs(value), f"{alternate}.{6 if precision is None else precision}{kind}")
    return _padded(flags, width, sign, digits.encode())


def _hexadecimal(flags: str, width: int, precision: int | None, kind: str, value: float) -> bytes:
    """`%a`: as many digits as the number needs, or as many as the precision says."""
    if value != value or abs(value) == float("inf"):
        return _float(flags, width, None, "F" if kind == "A" else "f", value)
    mantissa, _, exponent = abs(value).hex().removeprefix("0x").partition("p")
    whole, _, digits = mantissa.partition(".")
    if precision is None:
        digits = digits.rstrip("0")
    elif precision < len(digits):
        # The last digit is rounded, halves to even.
        kept, rest = int(whole + digits[:precision], 16), int(digits[precision:], 16)
        half = 8 << 4 * (len(digits) - precision - 1)
        kept += rest > half or (rest == half and kept & 1)
        text = f"{kept:0{precision + 1}x}"
        whole, digits = text[: len(text) - precision], text[len(text) - precision :]
    else:
        digits = digits.ljust(precision, "0")
    point = "." if digits or "#" in flags else ""
    text = f"{whole}{point}{digits}p{int(exponent):+d}"
    sign = "-" if _is_negative(value) else "+" if "+" in flags else " " if " " in flags else ""
    prefix = sign + "0x"
    if kind == "A":
        prefix, text = prefix.upper(), text.upper()
    return _padded(flags, width, prefix.encode(), text.encode())


def _padded(flags: str, width: int, sign: bytes, digits: bytes) -> bytes:
    if "-" in flags:
        return (sign + digits).ljust(width)
    if "0" in flags:
        return sign + digits.rjust(width - len(sign), b"0")
    return (sign + digits).rjust(width)


def _is_negative(value: float) -> bool:
    return math.copysign(1.0, value) < 0


def read_number(text: bytes) -> float | None:
    """The number that a text begins with, as scanf reads it by %f, after any blanks; None where there is none."""
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
