"""ARRAY: creates, fills, copies and resizes arrays.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import overload

from ev3proto.ops.argument_types import AnySLOT, Elements, Number, Output, Real
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import REQUIRED, drafts

__all__ = [
    "copy",
    "create8",
    "create16",
    "create32",
    "createf",
    "delete",
    "fill",
    "init8",
    "init16",
    "init32",
    "initf",
    "read_content",
    "read_size",
    "resize",
    "size",
    "write_content",
]

_OPERATIONS = drafts("official")


def delete(handle: Number, *, unchecked: bool = False) -> Draft:
    """Deletes an array and frees its handle.

    Args:
        handle: The array; handle.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.DELETE"].draft((handle,), unchecked)


def create8(elements: Number, handle: Output = None, *, unchecked: bool = False) -> Draft:
    """Creates an array of DATA8 elements.

    Args:
        elements: Initial number of elements; 0 to 6000000; DATA32.
        handle: Handle of the new array; handle; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.CREATE8"].draft((elements, handle), unchecked)


def create16(elements: Number, handle: Output = None, *, unchecked: bool = False) -> Draft:
    """Creates an array of DATA16 elements.

    Args:
        elements: Initial number of elements; 0 to 3000000; DATA32.
        handle: Handle of the new array; handle; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.CREATE16"].draft((elements, handle), unchecked)


def create32(elements: Number, handle: Output = None, *, unchecked: bool = False) -> Draft:
    """Creates an array of DATA32 elements.

    Args:
        elements: Initial number of elements; 0 to 1500000; DATA32.
        handle: Handle of the new array; handle; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.CREATE32"].draft((elements, handle), unchecked)


def createf(elements: Number, handle: Output = None, *, unchecked: bool = False) -> Draft:
    """Creates an array of DATAF elements.

    Args:
        elements: Initial number of elements; 0 to 1500000; DATA32.
        handle: Handle of the new array; handle; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.CREATEF"].draft((elements, handle), unchecked)


def resize(handle: Number, elements: Number, *, unchecked: bool = False) -> Draft:
    """Changes the number of elements of an array.

    Args:
        handle: The array; handle.
        elements: New number of elements; 0 to 6000000; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.RESIZE"].draft((handle, elements), unchecked)


def fill(handle: Number, value: Real, *, unchecked: bool = False) -> Draft:
    """Sets every element of an array to one value.

    Args:
        handle: The array; handle.
        value: The value, of the array's type; array-typed.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.FILL"].draft((handle, value), unchecked)


def copy(hsource: Number, hdest: Number, *, unchecked: bool = False) -> Draft:
    """Copies the content of one array into another of the same type, which is resized to match.

    Args:
        hsource: Array to copy from; handle.
        hdest: Array to copy into, which must exist; handle.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.COPY"].draft((hsource, hdest), unchecked)


@overload
def init8(
    handle: Number,
    index: Number,
    elements: Number | None,
    values: Sequence[Number],
    *,
    unchecked: bool = False,
) -> Draft: ...


@overload
def init8(
    handle: Number,
    index: Number,
    *,
    elements: Number | None = None,
    values: Sequence[Number],
    unchecked: bool = False,
) -> Draft: ...


def init8(
    handle: Number,
    index: Number,
    elements: Number | None = None,
    values: Sequence[Number] = REQUIRED,
    *,
    unchecked: bool = False,
) -> Draft:
    """Writes several elements of a DATA8 array, all within its size.

    Args:
        handle: The array; handle.
        index: First element to write, counted from 0; 0 to 5999999; DATA32.
        elements: Number of values that follow; 0 to 2147483647; DATA32; computed when omitted.
        values: The values, one parameter each; a list of DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.INIT8"].draft((handle, index, elements, values), unchecked)


@overload
def init16(
    handle: Number,
    index: Number,
    elements: Number | None,
    values: Sequence[Number],
    *,
    unchecked: bool = False,
) -> Draft: ...


@overload
def init16(
    handle: Number,
    index: Number,
    *,
    elements: Number | None = None,
    values: Sequence[Number],
    unchecked: bool = False,
) -> Draft: ...


def init16(
    handle: Number,
    index: Number,
    elements: Number | None = None,
    values: Sequence[Number] = REQUIRED,
    *,
    unchecked: bool = False,
) -> Draft:
    """Writes several elements of a DATA16 array, all within its size.

    Args:
        handle: The array; handle.
        index: First element to write, counted from 0; 0 to 5999999; DATA32.
        elements: Number of values that follow; 0 to 2147483647; DATA32; computed when omitted.
        values: The values, one parameter each; a list of DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.INIT16"].draft((handle, index, elements, values), unchecked)


@overload
def init32(
    handle: Number,
    index: Number,
    elements: Number | None,
    values: Sequence[Number],
    *,
    unchecked: bool = False,
) -> Draft: ...


@overload
def init32(
    handle: Number,
    index: Number,
    *,
    elements: Number | None = None,
    values: Sequence[Number],
    unchecked: bool = False,
) -> Draft: ...


def init32(
    handle: Number,
    index: Number,
    elements: Number | None = None,
    values: Sequence[Number] = REQUIRED,
    *,
    unchecked: bool = False,
) -> Draft:
    """Writes several elements of a DATA32 array, all within its size.

    Args:
        handle: The array; handle.
        index: First element to write, counted from 0; 0 to 5999999; DATA32.
        elements: Number of values that follow; 0 to 2147483647; DATA32; computed when omitted.
        values: The values, one parameter each; a list of DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.INIT32"].draft((handle, index, elements, values), unchecked)


@overload
def initf(
    handle: Number,
    index: Number,
    elements: Number | None,
    values: Sequence[Real],
    *,
    unchecked: bool = False,
) -> Draft: ...


@overload
def initf(
    handle: Number,
    index: Number,
    *,
    elements: Number | None = None,
    values: Sequence[Real],
    unchecked: bool = False,
) -> Draft: ...


def initf(
    handle: Number,
    index: Number,
    elements: Number | None = None,
    values: Sequence[Real] = REQUIRED,
    *,
    unchecked: bool = False,
) -> Draft:
    """Writes several elements of a DATAF array, all within its size.

    Args:
        handle: The array; handle.
        index: First element to write, counted from 0; 0 to 5999999; DATA32.
        elements: Number of values that follow; 0 to 2147483647; DATA32; computed when omitted.
        values: The values, one parameter each; a list of DATAF.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.INITF"].draft((handle, index, elements, values), unchecked)


def size(handle: Number, elements: Output = None, *, unchecked: bool = False) -> Draft:
    """Counts the elements of an array.

    Args:
        handle: The array; handle.
        elements: Number of elements, 0 if there is no such array; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.SIZE"].draft((handle, elements), unchecked)


def read_content(
    prgid: AnySLOT,
    handle: Number,
    index: Number,
    bytes: Number,
    array: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads an array's content as bytes, also of another program.

    Args:
        prgid: Slot of the program that owns the array; a member of SLOT; DATA16.
        handle: The array; handle.
        index: First byte in the array's content, whatever its elements; 0 to 2147483647; DATA32.
        bytes: Number of bytes; 0 to 2147483647 bytes; DATA32.
        array: The bytes, zeros beyond the end of the array; as many values as BYTES says; DATA8; an output, in global
            memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.READ_CONTENT"].draft((prgid, handle, index, bytes, array), unchecked)


def write_content(
    prgid: AnySLOT,
    handle: Number,
    index: Number,
    bytes: Number,
    array: Elements,
    *,
    unchecked: bool = False,
) -> Draft:
    """Writes an array's content as bytes; the array then ends after them.

    Args:
        prgid: Slot of the program that owns the array; a member of SLOT; DATA16.
        handle: The array; handle.
        index: First byte in the array's content, whatever its elements; 0 to 2147483647; DATA32.
        bytes: Number of bytes; 0 to 2147483647 bytes; DATA32.
        array: The bytes; as many values as BYTES says; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.WRITE_CONTENT"].draft((prgid, handle, index, bytes, array), unchecked)


def read_size(prgid: AnySLOT, handle: Number, bytes: Output = None, *, unchecked: bool = False) -> Draft:
    """Returns the size of an array's content, also of another program.

    Args:
        prgid: Slot of the program that owns the array; a member of SLOT; DATA16.
        handle: The array; handle.
        bytes: Number of bytes, 0 if there is no such array; bytes; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.READ_SIZE"].draft((prgid, handle, bytes), unchecked)
