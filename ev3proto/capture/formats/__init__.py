"""Capture files: their formats, recognised by the first bytes and not by names, and their packets."""

from __future__ import annotations

import gzip
import io
import os
import stat
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, BinaryIO, Self

from ev3proto.capture.formats import btsnoop, packetlogger, pcap, pcapng, unread, usbmon_text
from ev3proto.capture.packets import Format, Packet, begins_with
from ev3proto.capture.record import CaptureError

READ = tuple(each.FORMAT for each in (pcap, pcapng, btsnoop, packetlogger, usbmon_text))
"""The formats that are read. To add one, write its module and add it here."""

CAPTURE_FORMATS = (*READ, *unread.FORMATS)
"""All formats. A file has the first that matches."""

_NAMES = [each.name for each in READ]
LISTED = f"{', '.join(_NAMES[:-1])} or {_NAMES[-1]}"
"""The names of those, for sentences."""

GZIP = b"\x1f\x8b"
_is_gzip = begins_with(GZIP)
_LEAST = 8
"""First bytes that are requested at least, and shown of a file of no known format."""


def _needed(head: bytes) -> int:
    """Returns the number of first bytes that may tell the format; 0 if these do, or no more can."""
    undecided: list[int] = []
    for matches, needs in ((_is_gzip, len(GZIP)), *((each.matches, each.needs) for each in CAPTURE_FORMATS)):
        is_it = matches(head)
        if is_it:
            break
        undecided += [needs] if is_it is None else []
    return max(min(undecided), _LEAST) if undecided else 0


class _Source(io.RawIOBase):
    """A raw stream around a read function, which can show its first bytes and does not close the stream behind it."""

    # A pipe may return less than requested, and a damaged gzip stream returns the bytes before the damage only if no
    # more are requested at once.

    def __init__(self, read: Callable[[int], bytes]) -> None:
        self._read = read
        self._head = b""
        self._first: bytes | None = None

    def start(self) -> bytes:
        """Returns the first bytes that tell the format. Call it first before anything is read."""
        if self._first is not None:
            return self._first
        while needs := _needed(self._head):
            more = self._read(needs - len(self._head))
            if not more:
                break
            self._head += more
        self._first = self._head
        return self._first

    def readable(self) -> bool:
        return True

    def readinto(self, target: Any) -> int:
        data = self._head[: len(target)] or self._read(len(target))
        self._head = self._head[len(data) :]
        target[: len(data)] = data
        return len(data)


class CaptureFile:
    """A stream that may be a capture, compressed with gzip or not. Its format can be examined before it is read."""

    def __init__(self, stream: BinaryIO, *, is_ours: bool = False) -> None:
        """Takes a stream at its start; with `is_ours`, `close` closes it."""
        self._is_ours = is_ours
        self._file = stream
        self._trouble: str | None = None
        self._size = _size(stream)
        self._source = _Source(getattr(stream, "read1", stream.read))
        self._is_packed = self._source.start().startswith(GZIP)
        self.contents: io.BufferedReader[Any] = io.BufferedReader(self._source)  # its uncompressed contents
        self._gzip_trouble: tuple[type[Exception], ...] = ()
        if self._is_packed:
            self._gzip_trouble = EOFError, zlib.error, gzip.BadGzipFile
            self._source = _Source(gzip.GzipFile(fileobj=self.contents).read1)
            self.contents = io.BufferedReader(self._source)

    @classmethod
    def at(cls, path: str | os.PathLike[str]) -> Self:
        """Opens a file. Raises OSError."""
        stream = Path(path).open("rb")  # noqa: SIM115 - `close` does
        try:
            return cls(stream, is_ours=True)
        except BaseException:
            stream.close()
            raise

    @property
    def is_capture(self) -> bool:
        """Whether it begins like a capture file. Raises CaptureError and OSError."""
        return self._format() is not None

    @property
    def progress(self) -> float | None:
        """The part that was read, 0 to 1; None if its size is unknown."""
        return None if not self._size or self._file.closed else min(self._file.tell() / self._size, 1.0)

    def packets(self) -> Iterator[Packet]:
        """Yields the packets. Raises CaptureError, if the file is damaged after everything readable."""
        found = self._format()
        if found is None:
            start = self._start()[:_LEAST].hex(" ").upper()
            what = f"it begins with {start}" if start else "it is empty"
            raise CaptureError(f"not a capture file: {what}; expected {LISTED}, compressed with gzip or not")
        return self._unpacked(found) if self._is_packed else found.packets(self.contents)

    def close(self) -> None:
        """Closes the stream if it was opened here."""
        if self._is_ours:
            self._file.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _unpacked(self, found: Format) -> Iterator[Packet]:
        try:
            yield from found.packets(self.contents)
        except self._gzip_trouble as error:
            raise CaptureError(f"the gzip stream is cut off or damaged: {error}") from None

    def _start(self) -> bytes:
        start = b""
        try:
            start = self._source.start()
        except self._gzip_trouble as error:
            # On the next call, the stream would seem empty.
            self._trouble = self._trouble or f"the gzip stream is cut off or damaged: {error}"
        if self._trouble is not None:
            raise CaptureError(self._trouble)
        return start

    def _format(self) -> Format | None:
        start = self._start()
        return next((each for each in CAPTURE_FORMATS if each.matches(start)), None)


def _size(stream: BinaryIO) -> int | None:
    try:
        found = os.fstat(stream.fileno())
    except (OSError, AttributeError):
        return None
    return found.st_size if stat.S_ISREG(found.st_mode) else None
