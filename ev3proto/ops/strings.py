"""STRINGS: works with texts: joins, compares, converts from and to numbers.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Number, Output, Real, Text
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "add",
    "compare",
    "duplicate",
    "get_size",
    "number_formatted",
    "number_to_string",
    "string_to_value",
    "strip",
    "sub",
    "value_formatted",
    "value_to_string",
]

_OPERATIONS = drafts("official")


def get_size(source1: Text, size: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the length of a text.

    Args:
        source1: Text to work on; string.
        size: Its length, not including the zero; bytes; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["STRINGS.GET_SIZE"].draft((source1, size), unchecked)


def add(source1: Text, source2: Text, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Joins two texts.

    Args:
        source1: First part; string.
        source2: Second part; string.
        destination: Resulting text, zero-terminated; string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["STRINGS.ADD"].draft((source1, source2, destination), unchecked)


def compare(source1: Text, source2: Text, result: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether two texts are equal; case matters.

    Args:
        source1: One text; string.
        source2: The other text; string.
        result: Whether they are equal; 0 to 1; 0: different; 1: the same; DATA8; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["STRINGS.COMPARE"].draft((source1, source2, result), unchecked)


def duplicate(source1: Text, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Copies a text.

    Args:
        source1: Text to work on; string.
        destination: Resulting text, zero-terminated; string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["STRINGS.DUPLICATE"].draft((source1, destination), unchecked)


def value_to_string(
    value: Real,
    figures: Number,
    decimals: Number,
    destination: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Writes a floating-point number as text, without trailing zeros.

    Args:
        value: Number to write; NaN becomes ----; DATAF.
        figures: Width, including the point; negative aligns left; characters; DATA8.
        decimals: Digits after the point; DATA8.
        destination: Resulting text, zero-terminated; at most 128 characters; string; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["STRINGS.VALUE_TO_STRING"].draft((value, figures, decimals, destination), unchecked)


def string_to_value(source1: Text, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads a number from a text.

    Args:
        source1: Text to read; a comma counts as decimal point; string.
        destination: The number; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["STRINGS.STRING_TO_VALUE"].draft((source1, destination), unchecked)


def strip(source1: Text, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Removes every space from a text.

    Args:
        source1: Text to work on; string.
        destination: Resulting text, zero-terminated; string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["STRINGS.STRIP"].draft((source1, destination), unchecked)


def number_to_string(value: Number, figures: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Writes a whole number as text, with leading zeros.

    Args:
        value: Number to write; DATA16.
        figures: Width of the text; characters; DATA8.
        destination: Resulting text, zero-terminated; at most 128 characters; string; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["STRINGS.NUMBER_TO_STRING"].draft((value, figures, destination), unchecked)


def sub(source1: Text, source2: Text, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Returns the part of a text after another text found in it.

    Args:
        source1: Text to search; string.
        source2: Text to find; must occur; string.
        destination: Resulting text, zero-terminated; string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["STRINGS.SUB"].draft((source1, source2, destination), unchecked)


def value_formatted(
    value: Real,
    format: Text,
    size: Number,
    destination: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Writes a floating-point number as text in a format of C's printf.

    Args:
        value: Number to write; DATAF.
        format: Format, such as %5.2f; string.
        size: Size of the text buffer, including the zero; bytes; DATA8.
        destination: Resulting text; as many bytes as SIZE says; string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["STRINGS.VALUE_FORMATTED"].draft((value, format, size, destination), unchecked)


def number_formatted(
    value: Number,
    format: Text,
    size: Number,
    destination: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Writes a whole number as text in a format of C's printf.

    Args:
        value: Number to write; DATA32.
        format: Format, such as %05d or %X; string.
        size: Size of the text buffer, including the zero; bytes; DATA8.
        destination: Resulting text; as many bytes as SIZE says; string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["STRINGS.NUMBER_FORMATTED"].draft((value, format, size, destination), unchecked)
