"""A schema of nothing but unsigned numbers and bytes of fixed size, read in one go.

Construct reads such a structure field by field through a stream; where millions of them are read, that is most of the
time. The schema stays the declaration; this makes one `struct` of it.
"""

from __future__ import annotations

import struct
from typing import Any

from construct import Bytes, Struct

_LETTERS = {1: "B", 2: "H", 4: "I", 8: "Q"}
"""How `struct` names unsigned numbers, by their size in bytes."""


def packed(schema: Struct, order: str = "<") -> struct.Struct:
    """Makes one `struct` of a schema.

    Args:
        schema: Unsigned numbers and bytes of fixed size, one after the other.
        order: "<" for the least significant byte first, ">" for the most significant. It takes the place of the order
            that the schema's numbers have.

    Returns:
        A `struct` that reads and writes the fields in the schema's order.

    """
    return struct.Struct(order + "".join(_format(field.subcon) for field in schema.subcons))


def _format(field: Any) -> str:
    size = field.sizeof()
    return f"{size}s" if isinstance(field, Bytes) else _LETTERS[size]
