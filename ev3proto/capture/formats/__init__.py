"""Capture files: which format a file has, told by its first bytes and not by its name, and the packets in it."""

from __future__ import annotations

import gzip
import io
import zlib
from collections.abc import Callable, Iterator
from typing import BinaryIO

from ev3proto.capture.errors import CaptureError
from ev3proto.capture.formats import btsnoop, pcap, pcapng
from ev3proto.capture.packets import Packet

GZIP = b"\x1f\x8b"

_READERS: dict[bytes, Callable[[BinaryIO], Iterator[Packet]]] = {
    **dict.fromkeys(pcap.MAGICS, pcap.packets),
    pcapng.MAGIC: pcapng.packets,
    btsnoop.MAGIC: btsnoop.packets,
}

_MOST_MAGIC = max(map(len, _READERS))


def unpacked(stream: io.BufferedReader) -> io.BufferedReader:
    """The same stream, or what gzip packed into it."""
    if not stream.peek(len(GZIP)).startswith(GZIP):
        return stream
    return io.BufferedReader(gzip.GzipFile(fileobj=stream))


def is_capture(stream: io.BufferedReader) -> bool:
    """Whether a stream starts like a capture file. Nothing is taken from it. Raises CaptureError for a damaged gzip."""
    return _reader(stream) is not None


def packets(stream: io.BufferedReader) -> Iterator[Packet]:
    """The packets of a stream. Raises CaptureError for another format, or at what cannot be read, all before given."""
    reader = _reader(stream)
    if reader is None:
        start = _start(stream)
        raise CaptureError(
            f"no capture file: it starts with {start.hex(' ').upper()}; pcap, pcapng and btsnoop files can be read,"
            " packed with gzip or not"
            if start
            else "no capture file: it is empty"
        )
    return _told(reader(stream))


def _told(found: Iterator[Packet]) -> Iterator[Packet]:
    try:
        yield from found
    except (EOFError, zlib.error, gzip.BadGzipFile) as error:
        raise CaptureError(f"the gzip stream is cut off or damaged: {error}") from None


def _start(stream: io.BufferedReader) -> bytes:
    try:
        return stream.peek(_MOST_MAGIC)[:_MOST_MAGIC]
    except (EOFError, zlib.error, gzip.BadGzipFile) as error:
        raise CaptureError(f"the gzip stream is cut off or damaged: {error}") from None


def _reader(stream: io.BufferedReader) -> Callable[[BinaryIO], Iterator[Packet]] | None:
    start = _start(stream)
    return next((reader for magic, reader in _READERS.items() if start.startswith(magic)), None)
