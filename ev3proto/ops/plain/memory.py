"""Opcodes without a CMD in the firmware's area `memory`; `ops` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnySLOT, Elements, Number, Output, Real
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = ["array_append", "array_read", "array_write", "memory_read", "memory_usage", "memory_write"]

_OPERATIONS = drafts("official")


def memory_write(
    prgid: AnySLOT,
    objid: Number,
    offset: Number,
    size: Number,
    array: Elements,
    *,
    unchecked: bool = False,
) -> Draft:
    """Writes bytes into the variables of a running program.

    Args:
        prgid: Slot of the program, which must be running; 0 to 4; a member of SLOT; DATA16.
        objid: Object whose local memory is meant; 0: the program's global memory; DATA16.
        offset: First byte in that memory; 0 to 2147483647 bytes; DATA32.
        size: How many bytes; 0 to 2147483647 bytes; DATA32.
        array: The bytes; those beyond the end of the memory are dropped; as many values as SIZE says; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MEMORY_WRITE"].draft((prgid, objid, offset, size, array), unchecked)


def memory_read(
    prgid: AnySLOT,
    objid: Number,
    offset: Number,
    size: Number,
    array: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads bytes from the variables of a running program.

    Args:
        prgid: Slot of the program, which must be running; 0 to 4; a member of SLOT; DATA16.
        objid: Object whose local memory is meant; 0: the program's global memory; DATA16.
        offset: First byte in that memory; 0 to 2147483647 bytes; DATA32.
        size: How many bytes; 0 to 2147483647 bytes; DATA32.
        array: The bytes, zeros beyond the end of the memory; as many values as SIZE says; DATA8; an output, in global
            memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MEMORY_READ"].draft((prgid, objid, offset, size, array), unchecked)


def array_write(handle: Number, index: Number, value: Real, *, unchecked: bool = False) -> Draft:
    """Writes one element of an array, which grows where needed.

    Args:
        handle: The array; handle.
        index: Which element, the first is 0; 0 to 2147483647; DATA32.
        value: The value, of the array's type; array-typed.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY_WRITE"].draft((handle, index, value), unchecked)


def array_read(handle: Number, index: Number, value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads one element of an array.

    Args:
        handle: The array; handle.
        index: Which element, the first is 0; 0 to 2147483647; DATA32.
        value: The value, of the array's type; array-typed; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY_READ"].draft((handle, index, value), unchecked)


def array_append(handle: Number, value: Real, *, unchecked: bool = False) -> Draft:
    """Adds one element to the end of an array.

    Args:
        handle: The array; handle.
        value: The value, of the array's type; array-typed.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY_APPEND"].draft((handle, value), unchecked)


def memory_usage(total: Output = None, free: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells how much memory for user files there is and how much of it is free.

    Args:
        total: All of it; KiB; DATA32; an output, in global memory when omitted.
        free: What is free; KiB; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MEMORY_USAGE"].draft((total, free), unchecked)
