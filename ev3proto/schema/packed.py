"""A schema of nothing but numbers and bytes of fixed size, read in one go.

Construct reads such a structure field by field through a stream; where millions of them are read, that is most of the
time. The schema stays the declaration; this makes one `struct` of it.
"""

from __future__ import annotations

import struct
from typing import Any

from construct import Bytes, Struct


def packed(schema: Struct, order: str = "<") -> struct.Struct:
    """One `struct` for a schema: `order` is "<" for the least significant byte first, ">" for the most significant."""
    return struct.Struct(order + "".join(_format(field.subcon) for field in schema.subcons))


def _format(field: Any) -> str:
    return f"{field.length}s" if isinstance(field, Bytes) else str(field.fmtstr[1:])
