"""The Construct node that all schemas here are made of. It works on bytes; Construct's own nodes work on streams.

Byte code is many small items in a row. Reading each through a stream, a context and a path takes ten times as long
as reading its bytes. A `Bytewise` node reads from bytes at an offset and writes bytes, and is still a full Construct:
it parses, builds, and can be part of any `Struct`. `packed` reads structures of numbers at once.
"""

from __future__ import annotations

import io
import struct
from typing import Any

from construct import Bytes, Construct, Struct


class Bytewise(Construct):  # type: ignore[misc]
    """A schema node that reads `(bytes, offset) -> (object, offset after it)` and writes `object -> bytes`."""

    def read(self, data: bytes, at: int) -> tuple[Any, int]:
        """Returns the object at an offset, and the offset after it. Raises DecodeError."""
        raise NotImplementedError

    def write(self, value: Any) -> bytes:
        """Returns the bytes of an object. Raises BuildError."""
        raise NotImplementedError

    def _parse(self, stream: io.BufferedIOBase, _context: Any, _path: str) -> Any:
        start = stream.tell()
        if type(stream) is io.BytesIO:
            # Construct's stream of bytes: getvalue() does not copy, and offsets count from the start of the bytes.
            value, end = self.read(stream.getvalue(), start)
        else:
            value, used = self.read(stream.read(), 0)
            end = start + used
        stream.seek(end)
        return value

    def _build(self, value: Any, stream: io.BufferedIOBase, _context: Any, _path: str) -> Any:
        stream.write(self.write(value))
        return value


_LETTERS = {1: "B", 2: "H", 4: "I", 8: "Q"}
"""The format characters of `struct` for unsigned numbers, by size in bytes."""


def packed(schema: Struct, order: str = "<") -> struct.Struct:
    """Returns one `struct` for a schema.

    Args:
        schema: Unsigned numbers and bytes of fixed size, one after the other.
        order: "<" for the least significant byte first, ">" for the most significant. It replaces the byte order
            of the schema's numbers.

    Returns:
        A `struct` that reads and writes the fields in the schema's order.

    """
    return struct.Struct(order + "".join(_format(field.subcon) for field in schema.subcons))


def _format(field: Any) -> str:
    size = field.sizeof()
    return f"{size}s" if isinstance(field, Bytes) else _LETTERS[size]
