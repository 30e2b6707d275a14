"""Opcodes without a CMD in the firmware's area `branch`; `ops` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Jump, Number, Real
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "jr",
    "jr_eq8",
    "jr_eq16",
    "jr_eq32",
    "jr_eqf",
    "jr_false",
    "jr_gt8",
    "jr_gt16",
    "jr_gt32",
    "jr_gteq8",
    "jr_gteq16",
    "jr_gteq32",
    "jr_gteqf",
    "jr_gtf",
    "jr_lt8",
    "jr_lt16",
    "jr_lt32",
    "jr_lteq8",
    "jr_lteq16",
    "jr_lteq32",
    "jr_lteqf",
    "jr_ltf",
    "jr_nan",
    "jr_neq8",
    "jr_neq16",
    "jr_neq32",
    "jr_neqf",
    "jr_true",
]

_OPERATIONS = drafts("official")


def jr(offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps always.

    Args:
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR"].draft((offset,), unchecked)


def jr_false(flag: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if a flag is 0.

    Args:
        flag: The condition: anything but 0 is true; 0: false; 1: true; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_FALSE"].draft((flag, offset), unchecked)


def jr_true(flag: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if a flag is not 0.

    Args:
        flag: The condition: anything but 0 is true; 0: false; 1: true; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_TRUE"].draft((flag, offset), unchecked)


def jr_nan(value: Real, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if a value is not a number, as a sensor without data gives.

    Args:
        value: Value to look at; DATAF.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_NAN"].draft((value, offset), unchecked)


def jr_lt8(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LT8"].draft((left, right, offset), unchecked)


def jr_lt16(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LT16"].draft((left, right, offset), unchecked)


def jr_lt32(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LT32"].draft((left, right, offset), unchecked)


def jr_ltf(left: Real, right: Real, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LTF"].draft((left, right, offset), unchecked)


def jr_gt8(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GT8"].draft((left, right, offset), unchecked)


def jr_gt16(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GT16"].draft((left, right, offset), unchecked)


def jr_gt32(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GT32"].draft((left, right, offset), unchecked)


def jr_gtf(left: Real, right: Real, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GTF"].draft((left, right, offset), unchecked)


def jr_eq8(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is equal to RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_EQ8"].draft((left, right, offset), unchecked)


def jr_eq16(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is equal to RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_EQ16"].draft((left, right, offset), unchecked)


def jr_eq32(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is equal to RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_EQ32"].draft((left, right, offset), unchecked)


def jr_eqf(left: Real, right: Real, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is equal to RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_EQF"].draft((left, right, offset), unchecked)


def jr_neq8(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is different from RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_NEQ8"].draft((left, right, offset), unchecked)


def jr_neq16(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is different from RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_NEQ16"].draft((left, right, offset), unchecked)


def jr_neq32(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is different from RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_NEQ32"].draft((left, right, offset), unchecked)


def jr_neqf(left: Real, right: Real, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is different from RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_NEQF"].draft((left, right, offset), unchecked)


def jr_lteq8(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than or equal to RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LTEQ8"].draft((left, right, offset), unchecked)


def jr_lteq16(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than or equal to RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LTEQ16"].draft((left, right, offset), unchecked)


def jr_lteq32(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than or equal to RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LTEQ32"].draft((left, right, offset), unchecked)


def jr_lteqf(left: Real, right: Real, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than or equal to RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LTEQF"].draft((left, right, offset), unchecked)


def jr_gteq8(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than or equal to RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GTEQ8"].draft((left, right, offset), unchecked)


def jr_gteq16(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than or equal to RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GTEQ16"].draft((left, right, offset), unchecked)


def jr_gteq32(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than or equal to RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GTEQ32"].draft((left, right, offset), unchecked)


def jr_gteqf(left: Real, right: Real, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than or equal to RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GTEQF"].draft((left, right, offset), unchecked)
