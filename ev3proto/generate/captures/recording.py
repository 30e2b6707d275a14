"""A capture that grows while programs communicate: a pcapng file of exactly what was on the wire."""

from __future__ import annotations

import time
from collections.abc import Hashable
from typing import BinaryIO

from ev3proto.generate.captures import wifi
from ev3proto.generate.captures.carrier_writer import CarrierWriter
from ev3proto.generate.captures.packets import PacketFile, carrier_writer
from ev3proto.tables.carriers import Carrier

_SEGMENT = 1460
"""Bytes of a TCP segment; longer frames are split."""


class Recording:
    """A recording of connections between clients and a brick."""

    def __init__(self, stream: BinaryIO) -> None:
        """Begins the file; `flush` writes its beginning. Raises OSError if it cannot be written."""
        self.packets = 0  # how many were written
        self._stream = stream
        self._file = PacketFile(stream)
        # Some programs reject a file without an interface.
        self._file.interface(Carrier.WIFI)
        self._writers: dict[Hashable, tuple[CarrierWriter, int]] = {}

    def flush(self) -> None:
        """Passes on what was written, for programs that read the file while it grows. Raises OSError."""
        self._stream.flush()

    def opened(self, key: Hashable, carrier: Carrier, host: wifi.Address, brick: wifi.Address) -> None:
        """Records the start of a connection, named `key` from now on; on WiFi with TCP's handshake. Raises OSError."""
        writer = wifi.Writer(host, brick) if carrier is Carrier.WIFI else carrier_writer(carrier)
        self._writers[key] = writer, self._file.interface(carrier)
        self._write(key, writer.handshake() if isinstance(writer, wifi.Writer) else writer.opening())

    def data(self, key: Hashable, data: bytes, is_from_host: bool) -> None:
        """Records bytes: a frame, the unlock text or its answer, whatever a client sends. Raises OSError."""
        if key not in self._writers:
            return
        writer, _ = self._writers[key]
        packets = writer.between(is_from_host)
        for at in range(0, len(data), _SEGMENT):
            packets += writer.frame(data[at : at + _SEGMENT], is_from_host)
        self._write(key, packets)

    def closed(self, key: Hashable) -> None:
        """Records the end of a connection. Raises OSError."""
        if key in self._writers:
            self._write(key, self._writers[key][0].closing())
            del self._writers[key]

    def close(self) -> None:
        """Ends all connections. Raises OSError."""
        for key in list(self._writers):
            self.closed(key)

    def _write(self, key: Hashable, packets: list[bytes]) -> None:
        writer, interface = self._writers[key]
        now = time.time_ns()
        for packet in packets:
            self._file.write(writer.stamped(packet, now), now, interface)
            self.packets += 1
        # Flushed at once, so that the file can be read while it grows and survives a kill of this process.
        self.flush()
