"""Standard output and standard error of servers, which go on serving while their output is not read."""

from __future__ import annotations

import io
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from queue import SimpleQueue
from typing import TYPE_CHECKING, BinaryIO, cast

from ev3proto.cli.output import complain

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer

MOST_UNREAD = 1 << 24
"""Bytes that wait until they are read; what comes then is dropped, by whole lines and packets."""

_GRACE = 1.0
"""Seconds in which the rest is written at the end."""


class _Outlet(io.BufferedIOBase):
    """A stream that is written in a thread of its own; an error is raised at the next write or flush."""

    def __init__(self, stream: BinaryIO) -> None:
        # Without the buffer, whose lock would be held at the end of the process.
        self._stream: BinaryIO = getattr(stream, "raw", stream)
        self._pieces: SimpleQueue[bytes | None] = SimpleQueue()  # None ends it
        self._given = self._written = 0  # bytes that were put in, and that were written
        self.dropped = 0  # bytes that were not read in time
        self._error: OSError | None = None
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def writable(self) -> bool:
        return True

    def isatty(self) -> bool:
        return self._stream.isatty()

    def fileno(self) -> int:
        return self._stream.fileno()

    def write(self, data: ReadableBuffer, /) -> int:
        self.flush()
        piece = bytes(data)
        if self._given + len(piece) - self._written <= MOST_UNREAD:
            self._given += len(piece)
            self._pieces.put(piece)
        else:
            self.dropped += len(piece)
        return len(piece)

    def flush(self) -> None:
        if self._error is not None:
            raise self._error

    def end(self) -> None:
        """Writes the rest, if it is read."""
        self._pieces.put(None)
        self._thread.join(_GRACE)

    def _run(self) -> None:
        while (piece := self._pieces.get()) is not None:
            rest = memoryview(piece)
            try:
                while rest:
                    rest = rest[self._stream.write(rest) or 0 :]
            except OSError as error:
                self._error = error
                return
            self._written += len(piece)


@contextmanager
def unblocked_output() -> Iterator[None]:
    """Writes to standard output and standard error without waiting until they are read. Raises OSError."""
    streams, outlets = (sys.stdout, sys.stderr), list[_Outlet]()

    def unblocked(stream: io.TextIOWrapper) -> io.TextIOWrapper:
        stream.flush()
        outlets.append(_Outlet(cast(BinaryIO, stream.buffer)))
        raw = cast(BinaryIO, outlets[-1])
        return io.TextIOWrapper(raw, stream.encoding, stream.errors, write_through=True)

    sys.stdout, sys.stderr = (
        unblocked(stream) if isinstance(stream, io.TextIOWrapper) else stream for stream in streams
    )
    try:
        yield
    finally:
        if dropped := sum(outlet.dropped for outlet in outlets):
            complain(f"{dropped:,} bytes of output were dropped: the reader was {MOST_UNREAD:,} bytes behind")
        for outlet in outlets:
            outlet.end()
        sys.stdout, sys.stderr = streams
