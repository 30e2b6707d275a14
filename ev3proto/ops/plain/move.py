"""Opcodes without a CMD in the firmware's area `move`; `ops` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import overload

from ev3proto.ops.argument_types import Number, Output, Real
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts
from ev3proto.semantics.drafts.values import REQUIRED

__all__ = [
    "init_bytes",
    "move8_8",
    "move8_16",
    "move8_32",
    "move8_f",
    "move16_8",
    "move16_16",
    "move16_32",
    "move16_f",
    "move32_8",
    "move32_16",
    "move32_32",
    "move32_f",
    "movef_8",
    "movef_16",
    "movef_32",
    "movef_f",
    "read8",
    "read16",
    "read32",
    "readf",
    "write8",
    "write16",
    "write32",
    "writef",
]

_OPERATIONS = drafts("official")


@overload
def init_bytes(
    destination: Output,
    length: Number | None,
    source: Sequence[Number],
    *,
    unchecked: bool = False,
) -> Draft: ...


@overload
def init_bytes(
    *,
    destination: Output = None,
    length: Number | None = None,
    source: Sequence[Number],
    unchecked: bool = False,
) -> Draft: ...


def init_bytes(
    destination: Output = None,
    length: Number | None = None,
    source: Sequence[Number] = REQUIRED,
    *,
    unchecked: bool = False,
) -> Draft:
    """Fills consecutive bytes of memory with values given in place.

    Args:
        destination: First byte to fill; as many values as LENGTH says; DATA8; an output, in global memory when omitted.
        length: How many values follow; a negative count hangs the brick; bytes; DATA32; worked out when omitted.
        source: The values, one per byte; a list of DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INIT_BYTES"].draft((destination, length, source), unchecked)


def move8_8(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Copies a value to another variable, both 8-bit.

    Args:
        source: Value to copy; DATA8.
        destination: Copy of the value; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE8_8"].draft((source, destination), unchecked)


def move8_16(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 8-bit to 16-bit; NaN stays NaN.

    Args:
        source: Value to copy; DATA8.
        destination: Copy of the value; DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE8_16"].draft((source, destination), unchecked)


def move8_32(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 8-bit to 32-bit; NaN stays NaN.

    Args:
        source: Value to copy; DATA8.
        destination: Copy of the value; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE8_32"].draft((source, destination), unchecked)


def move8_f(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 8-bit to floating-point; NaN stays NaN.

    Args:
        source: Value to copy; DATA8.
        destination: Copy of the value; DATAF; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE8_F"].draft((source, destination), unchecked)


def move16_8(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 16-bit to 8-bit; limited to what fits, NaN stays NaN.

    Args:
        source: Value to copy; DATA16.
        destination: Copy of the value; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE16_8"].draft((source, destination), unchecked)


def move16_16(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Copies a value to another variable, both 16-bit.

    Args:
        source: Value to copy; DATA16.
        destination: Copy of the value; DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE16_16"].draft((source, destination), unchecked)


def move16_32(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 16-bit to 32-bit; NaN stays NaN.

    Args:
        source: Value to copy; DATA16.
        destination: Copy of the value; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE16_32"].draft((source, destination), unchecked)


def move16_f(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 16-bit to floating-point; NaN stays NaN.

    Args:
        source: Value to copy; DATA16.
        destination: Copy of the value; DATAF; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE16_F"].draft((source, destination), unchecked)


def move32_8(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 32-bit to 8-bit; limited to what fits, NaN stays NaN.

    Args:
        source: Value to copy; DATA32.
        destination: Copy of the value; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE32_8"].draft((source, destination), unchecked)


def move32_16(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 32-bit to 16-bit; limited to what fits, NaN stays NaN.

    Args:
        source: Value to copy; DATA32.
        destination: Copy of the value; DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE32_16"].draft((source, destination), unchecked)


def move32_32(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Copies a value to another variable, both 32-bit.

    Args:
        source: Value to copy; DATA32.
        destination: Copy of the value; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE32_32"].draft((source, destination), unchecked)


def move32_f(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 32-bit to floating-point; NaN stays NaN.

    Args:
        source: Value to copy; DATA32.
        destination: Copy of the value; DATAF; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE32_F"].draft((source, destination), unchecked)


def movef_8(source: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, floating-point to 8-bit; limited to what fits, NaN stays NaN.

    Args:
        source: Value to copy; DATAF.
        destination: Copy of the value; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVEF_8"].draft((source, destination), unchecked)


def movef_16(source: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, floating-point to 16-bit; limited to what fits, NaN stays NaN.

    Args:
        source: Value to copy; DATAF.
        destination: Copy of the value; DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVEF_16"].draft((source, destination), unchecked)


def movef_32(source: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, floating-point to 32-bit; limited to what fits, NaN stays NaN.

    Args:
        source: Value to copy; DATAF.
        destination: Copy of the value; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVEF_32"].draft((source, destination), unchecked)


def movef_f(source: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Copies a value to another variable, both floating-point.

    Args:
        source: Value to copy; DATAF.
        destination: Copy of the value; DATAF; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVEF_F"].draft((source, destination), unchecked)


def read8(source: Number, index: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes one element out of an array of 8-bit values.

    Args:
        source: First element of the array, as a variable; DATA8.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: The element's value; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["READ8"].draft((source, index, destination), unchecked)


def read16(source: Number, index: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes one element out of an array of 16-bit values.

    Args:
        source: First element of the array, as a variable; DATA16.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: The element's value; DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["READ16"].draft((source, index, destination), unchecked)


def read32(source: Number, index: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes one element out of an array of 32-bit values.

    Args:
        source: First element of the array, as a variable; DATA32.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: The element's value; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["READ32"].draft((source, index, destination), unchecked)


def readf(source: Real, index: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes one element out of an array of floating-point values.

    Args:
        source: First element of the array, as a variable; DATAF.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: The element's value; DATAF; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["READF"].draft((source, index, destination), unchecked)


def write8(source: Number, index: Number, destination: Number, *, unchecked: bool = False) -> Draft:
    """Sets one element of an array of 8-bit values.

    Args:
        source: Value to set; DATA8.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: First element of the array, as a variable; element INDEX is written; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["WRITE8"].draft((source, index, destination), unchecked)


def write16(source: Number, index: Number, destination: Number, *, unchecked: bool = False) -> Draft:
    """Sets one element of an array of 16-bit values.

    Args:
        source: Value to set; DATA16.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: First element of the array, as a variable; element INDEX is written; DATA16.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["WRITE16"].draft((source, index, destination), unchecked)


def write32(source: Number, index: Number, destination: Number, *, unchecked: bool = False) -> Draft:
    """Sets one element of an array of 32-bit values.

    Args:
        source: Value to set; DATA32.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: First element of the array, as a variable; element INDEX is written; DATA32.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["WRITE32"].draft((source, index, destination), unchecked)


def writef(source: Real, index: Number, destination: Real, *, unchecked: bool = False) -> Draft:
    """Sets one element of an array of floating-point values.

    Args:
        source: Value to set; DATAF.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: First element of the array, as a variable; element INDEX is written; DATAF.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["WRITEF"].draft((source, index, destination), unchecked)
