"""Opcodes without a CMD in the firmware's area `math`; `ops` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Number, Output, Real
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "add8",
    "add16",
    "add32",
    "addf",
    "and8",
    "and16",
    "and32",
    "div8",
    "div16",
    "div32",
    "divf",
    "mul8",
    "mul16",
    "mul32",
    "mulf",
    "or8",
    "or16",
    "or32",
    "random",
    "rl8",
    "rl16",
    "rl32",
    "sub8",
    "sub16",
    "sub32",
    "subf",
    "xor8",
    "xor16",
    "xor32",
]

_OPERATIONS = drafts("official")


def add8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Adds two 8-bit numbers.

    Args:
        source1: First number; DATA8.
        source2: Second number; DATA8.
        destination: Their sum; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ADD8"].draft((source1, source2, destination), unchecked)


def add16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Adds two 16-bit numbers.

    Args:
        source1: First number; DATA16.
        source2: Second number; DATA16.
        destination: Their sum; DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ADD16"].draft((source1, source2, destination), unchecked)


def add32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Adds two 32-bit numbers.

    Args:
        source1: First number; DATA32.
        source2: Second number; DATA32.
        destination: Their sum; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ADD32"].draft((source1, source2, destination), unchecked)


def addf(source1: Real, source2: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Adds two floating-point numbers.

    Args:
        source1: First number; DATAF.
        source2: Second number; DATAF.
        destination: Their sum; DATAF; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ADDF"].draft((source1, source2, destination), unchecked)


def sub8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Subtracts one 8-bit number from another.

    Args:
        source1: Number to subtract from; DATA8.
        source2: Number to subtract; DATA8.
        destination: SOURCE1 less SOURCE2; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SUB8"].draft((source1, source2, destination), unchecked)


def sub16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Subtracts one 16-bit number from another.

    Args:
        source1: Number to subtract from; DATA16.
        source2: Number to subtract; DATA16.
        destination: SOURCE1 less SOURCE2; DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SUB16"].draft((source1, source2, destination), unchecked)


def sub32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Subtracts one 32-bit number from another.

    Args:
        source1: Number to subtract from; DATA32.
        source2: Number to subtract; DATA32.
        destination: SOURCE1 less SOURCE2; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SUB32"].draft((source1, source2, destination), unchecked)


def subf(source1: Real, source2: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Subtracts one floating-point number from another.

    Args:
        source1: Number to subtract from; DATAF.
        source2: Number to subtract; DATAF.
        destination: SOURCE1 less SOURCE2; DATAF; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SUBF"].draft((source1, source2, destination), unchecked)


def mul8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Multiplies two 8-bit numbers.

    Args:
        source1: First factor; DATA8.
        source2: Second factor; DATA8.
        destination: Their product; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MUL8"].draft((source1, source2, destination), unchecked)


def mul16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Multiplies two 16-bit numbers.

    Args:
        source1: First factor; DATA16.
        source2: Second factor; DATA16.
        destination: Their product; DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MUL16"].draft((source1, source2, destination), unchecked)


def mul32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Multiplies two 32-bit numbers.

    Args:
        source1: First factor; DATA32.
        source2: Second factor; DATA32.
        destination: Their product; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MUL32"].draft((source1, source2, destination), unchecked)


def mulf(source1: Real, source2: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Multiplies two floating-point numbers.

    Args:
        source1: First factor; DATAF.
        source2: Second factor; DATAF.
        destination: Their product; DATAF; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MULF"].draft((source1, source2, destination), unchecked)


def div8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Divides two 8-bit numbers; by zero gives the largest or smallest value.

    Args:
        source1: Number to divide; DATA8.
        source2: Number to divide by; DATA8.
        destination: Quotient, cut off towards zero (0 for 0 / 0); DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DIV8"].draft((source1, source2, destination), unchecked)


def div16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Divides two 16-bit numbers; by zero gives the largest or smallest value.

    Args:
        source1: Number to divide; DATA16.
        source2: Number to divide by; DATA16.
        destination: Quotient, cut off towards zero (0 for 0 / 0); DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DIV16"].draft((source1, source2, destination), unchecked)


def div32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Divides two 32-bit numbers; by zero gives the largest or smallest value.

    Args:
        source1: Number to divide; DATA32.
        source2: Number to divide by; DATA32.
        destination: Quotient, cut off towards zero (0 for 0 / 0); DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DIV32"].draft((source1, source2, destination), unchecked)


def divf(source1: Real, source2: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Divides two floating-point numbers; by zero gives infinity or NaN.

    Args:
        source1: Number to divide; DATAF.
        source2: Number to divide by; DATAF.
        destination: Quotient; DATAF; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DIVF"].draft((source1, source2, destination), unchecked)


def or8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 8-bit values, bit by bit, by OR.

    Args:
        source1: First; DATA8.
        source2: Second; DATA8.
        destination: Bits set in either; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OR8"].draft((source1, source2, destination), unchecked)


def or16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 16-bit values, bit by bit, by OR.

    Args:
        source1: First; DATA16.
        source2: Second; DATA16.
        destination: Bits set in either; DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OR16"].draft((source1, source2, destination), unchecked)


def or32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 32-bit values, bit by bit, by OR.

    Args:
        source1: First; DATA32.
        source2: Second; DATA32.
        destination: Bits set in either; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OR32"].draft((source1, source2, destination), unchecked)


def and8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 8-bit values, bit by bit, by AND.

    Args:
        source1: First; DATA8.
        source2: Second; DATA8.
        destination: Bits set in both; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["AND8"].draft((source1, source2, destination), unchecked)


def and16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 16-bit values, bit by bit, by AND.

    Args:
        source1: First; DATA16.
        source2: Second; DATA16.
        destination: Bits set in both; DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["AND16"].draft((source1, source2, destination), unchecked)


def and32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 32-bit values, bit by bit, by AND.

    Args:
        source1: First; DATA32.
        source2: Second; DATA32.
        destination: Bits set in both; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["AND32"].draft((source1, source2, destination), unchecked)


def xor8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 8-bit values, bit by bit, by exclusive OR.

    Args:
        source1: First; DATA8.
        source2: Second; DATA8.
        destination: Bits set in just one of the two; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["XOR8"].draft((source1, source2, destination), unchecked)


def xor16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 16-bit values, bit by bit, by exclusive OR.

    Args:
        source1: First; DATA16.
        source2: Second; DATA16.
        destination: Bits set in just one of the two; DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["XOR16"].draft((source1, source2, destination), unchecked)


def xor32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 32-bit values, bit by bit, by exclusive OR.

    Args:
        source1: First; DATA32.
        source2: Second; DATA32.
        destination: Bits set in just one of the two; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["XOR32"].draft((source1, source2, destination), unchecked)


def rl8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Shifts 8-bit values left; despite the name (rotate), bits leaving on the left are lost.

    Args:
        source1: Value to shift; DATA8.
        source2: How many places; bits; DATA8.
        destination: Shifted value, filled up with zero bits; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["RL8"].draft((source1, source2, destination), unchecked)


def rl16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Shifts 16-bit values left; despite the name (rotate), bits leaving on the left are lost.

    Args:
        source1: Value to shift; DATA16.
        source2: How many places; bits; DATA16.
        destination: Shifted value, filled up with zero bits; DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["RL16"].draft((source1, source2, destination), unchecked)


def rl32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Shifts 32-bit values left; despite the name (rotate), bits leaving on the left are lost.

    Args:
        source1: Value to shift; DATA32.
        source2: How many places; bits; DATA32.
        destination: Shifted value, filled up with zero bits; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["RL32"].draft((source1, source2, destination), unchecked)


def random(min: Number, max: Number, value: Output = None, *, unchecked: bool = False) -> Draft:
    """Draws a random whole number.

    Args:
        min: Smallest number to draw; DATA16.
        max: Largest number to draw; DATA16.
        value: The number drawn, MIN to MAX, both included; DATA16; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["RANDOM"].draft((min, max, value), unchecked)
