"""Capture files: their formats, recognised by the first bytes and not by names, and their packets."""

from __future__ import annotations

import gzip
import io
import os
import stat
import zlib
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from types import TracebackType
from typing import Any, BinaryIO, Self

from ev3proto.capture.formats import hcidump, packetlogger
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import CaptureError

GZIP = b"\x1f\x8b"

MAGICS = {
    bytes.fromhex("a1b2c3d4"): "pcap",
    bytes.fromhex("d4c3b2a1"): "pcap",
    bytes.fromhex("a1b23c4d"): "pcap",
    bytes.fromhex("4d3cb2a1"): "pcap",
    bytes.fromhex("0a0d0d0a"): "pcapng",
    b"btsnoop\0": "btsnoop",
}
"""The first bytes of each format, and the module that reads it, imported for the first such file."""

Reader = Callable[["io.BufferedReader[Any]"], Iterator[Packet]]

_STARTS = (GZIP, *MAGICS)
_MAGIC = max(map(len, MAGICS))
_MOST_HEAD = max(_MAGIC, packetlogger.SIZE, hcidump.SIZE)
"""The bytes that tell every format: of files without a magic, more are needed."""


def _format_of(head: bytes) -> str | None:
    """Returns the name of the module that reads files with these first bytes; None if there is none."""
    found = next((name for magic, name in MAGICS.items() if head.startswith(magic)), None)
    if found is None and packetlogger.order_of(head) is not None:
        return "packetlogger"
    return "hcidump" if found is None and hcidump.is_start(head) else found


def _is_undecided(head: bytes) -> bool:
    """Returns whether more bytes may tell the format; those without a magic have zeros, which texts do not."""
    if len(head) >= _MOST_HEAD or head.startswith(_STARTS):
        return False
    return any(magic.startswith(head) for magic in _STARTS) or b"\0" in head


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
        while _is_undecided(self._head):
            more = self._read((_MAGIC if len(self._head) < _MAGIC else _MOST_HEAD) - len(self._head))
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
        name = self._format()
        if name is None:
            start = self._start().hex(" ").upper()
            what = f"it begins with {start}" if start else "it is empty"
            raise CaptureError(
                f"not a capture file: {what}; expected pcap, pcapng, btsnoop or pklg, compressed with gzip or not"
            )
        packets: Reader = import_module(f"{__name__}.{name}").packets
        return self._unpacked(packets) if self._is_packed else packets(self.contents)

    def close(self) -> None:
        """Closes the stream if it was opened here."""
        if self._is_ours:
            self._file.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, where: TracebackType | None
    ) -> None:
        self.close()

    def _unpacked(self, reader: Reader) -> Iterator[Packet]:
        try:
            yield from reader(self.contents)
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

    def _format(self) -> str | None:
        return _format_of(self._start())


def _size(stream: BinaryIO) -> int | None:
    """Returns the size of a file in bytes; None for a pipe or another stream."""
    try:
        found = os.fstat(stream.fileno())
    except (OSError, AttributeError):
        return None
    return found.st_size if stat.S_ISREG(found.st_mode) else None
