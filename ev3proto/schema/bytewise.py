"""The Construct node that everything here is made of: it works on bytes where Construct's own work on streams.

Byte code is many small things one after the other. Reading each through a stream, a context and a path costs ten times
what the reading itself costs. A `Bytewise` node reads from bytes at an offset and writes bytes, and is a full Construct
all the same: it parses, builds, and stands in anybody's `Struct`.
"""

from __future__ import annotations

import io
from typing import Any

from construct import Construct


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
