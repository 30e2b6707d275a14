"""ARRAY: creates, fills, copies and resizes arrays.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Number, Output
from ev3proto.ops.array import (
    copy,
    create8,
    create16,
    create32,
    createf,
    fill,
    init8,
    init16,
    init32,
    initf,
    read_content,
    read_size,
    resize,
    write_content,
)
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "copy",
    "create8",
    "create16",
    "create32",
    "createf",
    "destroy",
    "fill",
    "init8",
    "init16",
    "init32",
    "initf",
    "read_content",
    "read_size",
    "resize",
    "set_size",
    "write_content",
]

_OPERATIONS = drafts("xtended")


def destroy(handle: Number, *, unchecked: bool = False) -> Draft:
    """Deletes an array and frees its handle (LEGO's name for it is DELETE).

    Args:
        handle: The array; handle.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.DESTROY"].draft((handle,), unchecked)


def set_size(handle: Number, elements: Output = None, *, unchecked: bool = False) -> Draft:
    """Counts the elements of an array (LEGO's name for it is SIZE).

    Args:
        handle: The array; handle.
        elements: Number of elements, 0 if there is no such array; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY.SET_SIZE"].draft((handle, elements), unchecked)
