"""Opcodes without a CMD in the firmware's area `compare`; `ops` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Number, Output, Real
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "cp_eq8",
    "cp_eq16",
    "cp_eq32",
    "cp_eqf",
    "cp_gt8",
    "cp_gt16",
    "cp_gt32",
    "cp_gteq8",
    "cp_gteq16",
    "cp_gteq32",
    "cp_gteqf",
    "cp_gtf",
    "cp_lt8",
    "cp_lt16",
    "cp_lt32",
    "cp_lteq8",
    "cp_lteq16",
    "cp_lteq32",
    "cp_lteqf",
    "cp_ltf",
    "cp_neq8",
    "cp_neq16",
    "cp_neq32",
    "cp_neqf",
    "select8",
    "select16",
    "select32",
    "selectf",
]

_OPERATIONS = drafts("official")


def cp_lt8(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LT8"].draft((left, right, flag), unchecked)


def cp_lt16(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LT16"].draft((left, right, flag), unchecked)


def cp_lt32(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LT32"].draft((left, right, flag), unchecked)


def cp_ltf(left: Real, right: Real, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LTF"].draft((left, right, flag), unchecked)


def cp_gt8(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GT8"].draft((left, right, flag), unchecked)


def cp_gt16(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GT16"].draft((left, right, flag), unchecked)


def cp_gt32(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GT32"].draft((left, right, flag), unchecked)


def cp_gtf(left: Real, right: Real, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GTF"].draft((left, right, flag), unchecked)


def cp_eq8(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is equal to RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_EQ8"].draft((left, right, flag), unchecked)


def cp_eq16(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is equal to RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_EQ16"].draft((left, right, flag), unchecked)


def cp_eq32(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is equal to RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_EQ32"].draft((left, right, flag), unchecked)


def cp_eqf(left: Real, right: Real, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is equal to RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_EQF"].draft((left, right, flag), unchecked)


def cp_neq8(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is different from RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_NEQ8"].draft((left, right, flag), unchecked)


def cp_neq16(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is different from RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_NEQ16"].draft((left, right, flag), unchecked)


def cp_neq32(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is different from RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_NEQ32"].draft((left, right, flag), unchecked)


def cp_neqf(left: Real, right: Real, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is different from RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_NEQF"].draft((left, right, flag), unchecked)


def cp_lteq8(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than or equal to RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LTEQ8"].draft((left, right, flag), unchecked)


def cp_lteq16(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than or equal to RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LTEQ16"].draft((left, right, flag), unchecked)


def cp_lteq32(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than or equal to RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LTEQ32"].draft((left, right, flag), unchecked)


def cp_lteqf(left: Real, right: Real, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is less than or equal to RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LTEQF"].draft((left, right, flag), unchecked)


def cp_gteq8(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than or equal to RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GTEQ8"].draft((left, right, flag), unchecked)


def cp_gteq16(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than or equal to RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GTEQ16"].draft((left, right, flag), unchecked)


def cp_gteq32(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than or equal to RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GTEQ32"].draft((left, right, flag), unchecked)


def cp_gteqf(left: Real, right: Real, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether LEFT is greater than or equal to RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        flag: Whether it holds; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GTEQF"].draft((left, right, flag), unchecked)


def select8(flag: Number, source1: Number, source2: Number, result: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes one of two 8-bit values, whichever the flag says.

    Args:
        flag: Which to take: anything but 0 takes SOURCE1; 0: SOURCE2; 1: SOURCE1; DATA8.
        source1: Value taken if the flag is set; DATA8.
        source2: Value taken if the flag is 0; DATA8.
        result: The value taken; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SELECT8"].draft((flag, source1, source2, result), unchecked)


def select16(
    flag: Number,
    source1: Number,
    source2: Number,
    result: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Takes one of two 16-bit values, whichever the flag says.

    Args:
        flag: Which to take: anything but 0 takes SOURCE1; 0: SOURCE2; 1: SOURCE1; DATA8.
        source1: Value taken if the flag is set; DATA16.
        source2: Value taken if the flag is 0; DATA16.
        result: The value taken; DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SELECT16"].draft((flag, source1, source2, result), unchecked)


def select32(
    flag: Number,
    source1: Number,
    source2: Number,
    result: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Takes one of two 32-bit values, whichever the flag says.

    Args:
        flag: Which to take: anything but 0 takes SOURCE1; 0: SOURCE2; 1: SOURCE1; DATA8.
        source1: Value taken if the flag is set; DATA32.
        source2: Value taken if the flag is 0; DATA32.
        result: The value taken; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SELECT32"].draft((flag, source1, source2, result), unchecked)


def selectf(flag: Number, source1: Real, source2: Real, result: Output = None, *, unchecked: bool = False) -> Draft:
    """Takes one of two floating-point values, whichever the flag says.

    Args:
        flag: Which to take: anything but 0 takes SOURCE1; 0: SOURCE2; 1: SOURCE1; DATA8.
        source1: Value taken if the flag is set; DATAF.
        source2: Value taken if the flag is 0; DATAF.
        result: The value taken; DATAF; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SELECTF"].draft((flag, source1, source2, result), unchecked)
