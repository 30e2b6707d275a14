"""A capture of what goes through the proxy, written while it goes: a file, or a pipe that somebody reads meanwhile."""

from __future__ import annotations

import time
from typing import BinaryIO

from ev3proto.generate.captures import PacketFile
from ev3proto.generate.captures.wifi import Writer
from ev3proto.tables.carriers import Carrier

_FIRST_PORT, _PORTS = 49152, 16384
"""Ports of clients in the capture."""

_SEGMENT = 1460
"""Bytes of a TCP segment; longer frames are cut."""


class Recording:
    """Writes a pcapng file, one connection of a client after the other."""

    def __init__(self, stream: BinaryIO) -> None:
        """Begins the file. OSError where it cannot be written."""
        self._stream = stream
        self._file = PacketFile(stream)
        self._interface = self._file.interface(Carrier.WIFI)
        self._writer: Writer | None = None
        self._count = 0
        stream.flush()

    def opened(self) -> None:
        """A client is there. Raises OSError."""
        self._writer = Writer(_FIRST_PORT + self._count % _PORTS)
        self._count += 1
        self._write(self._writer.opening())

    def frame(self, frame: bytes, is_from_host: bool) -> None:
        """A frame goes by. Raises OSError."""
        if self._writer is None:
            return
        packets = self._writer.between(is_from_host)
        for at in range(0, len(frame), _SEGMENT):
            packets += self._writer.frame(frame[at : at + _SEGMENT], is_from_host)
        self._write(packets)

    def closed(self) -> None:
        """The client has gone. Raises OSError."""
        if self._writer is not None:
            self._write(self._writer.closing())
            self._writer = None

    def _write(self, packets: list[bytes]) -> None:
        assert self._writer is not None
        now = time.time_ns()
        for packet in packets:
            self._file.write(self._writer.stamped(packet, now), now, self._interface)
        self._stream.flush()
