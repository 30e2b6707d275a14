"""The Construct node that everything here is made of: it works on bytes where Construct's own work on streams.

Byte code is many small things one after the other. Reading each through a stream, a context and a path costs ten times
what the reading itself costs. A `Bytewise` node reads from bytes at an offset and writes bytes, and is a full Construct
all the same: it parses, builds, and stands in anybody's `Struct`. `packed` reads structures of numbers in one go.
"""

from __future__ import annotations

import io
import struct
from typing import Any

from construct import Bytes, Construct, Struct


class Bytewise(Construct):  # type: ignore[misc]
    """A schema node that reads `(bytes, offset) -> (object, offset after it)` and writes `object -> bytes`."""

    def read(self, data: bytes, at: int) -> tuple[Any, int]:
        """The object at an offset, and the offset after it. Raises DecodeError."""
        raise NotImplementedError

    def write(self, value: Any) -> bytes:
        """The bytes of an object. Raises BuildError."""
        raise NotImplementedError

    def _parse(self, stream: io.BufferedIOBase, _context: Any, _path: str) -> Any:
        start = stream.tell()
        if type(stream) is io.BytesIO:
            # Whatever Construct parses from bytes. getvalue() copies nothing, and offsets stay those of all the bytes.
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
