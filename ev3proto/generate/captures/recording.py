"""A capture that grows while programs talk: a pcapng file with what was on the wire, and nothing else."""

from __future__ import annotations

import time
from collections.abc import Hashable
from typing import BinaryIO

from ev3proto.generate.captures import wifi
from ev3proto.generate.captures.carrier_writer import CarrierWriter
from ev3proto.generate.captures.packets import PacketFile, carrier_writer
from ev3proto.tables.carriers import Carrier

_SEGMENT = 1460
"""Bytes of a TCP segment; longer frames are cut."""


class Recording:
    """Connections of clients with a brick.

    packets  how many were written
    """

    def __init__(self, stream: BinaryIO) -> None:
        """Begins the file; `flush` sends its beginning. OSError where it cannot be written."""
        self.packets = 0
        self._stream = stream
        self._file = PacketFile(stream)
        # A file without an interface is not one that every program reads.
        self._file.interface(Carrier.WIFI)
        self._writers: dict[Hashable, tuple[CarrierWriter, int]] = {}

    def flush(self) -> None:
        """Sends what was written to who reads the file meanwhile. Raises OSError."""
        self._stream.flush()

    def opened(self, key: Hashable, carrier: Carrier, host: wifi.Address, brick: wifi.Address) -> None:
        """A connection begins; on WiFi with the handshake of TCP.

        Args:
            key: Names the connection in further calls.
            carrier: What carries it.
            host: IP address and port of the client, where WiFi carries it.
            brick: Those of the brick.

        Raises:
            OSError: The file cannot be written.
        """
        interface = self._file.interface(carrier)
        if carrier is Carrier.WIFI:
            connection = wifi.Writer(host, brick)
            self._writers[key] = connection, interface
            self._write(key, connection.handshake())
        else:
            writer = carrier_writer(carrier)
            self._writers[key] = writer, interface
            self._write(key, writer.opening())

    def data(self, key: Hashable, data: bytes, is_from_host: bool) -> None:
        """Bytes go by: a frame, the unlock text or its answer, whatever a client sends. Raises OSError."""
        if key not in self._writers:
            return
        writer, _ = self._writers[key]
        packets = writer.between(is_from_host)
        for at in range(0, len(data), _SEGMENT):
            packets += writer.frame(data[at : at + _SEGMENT], is_from_host)
        self._write(key, packets)

    def closed(self, key: Hashable) -> None:
        """A connection ends. Raises OSError."""
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
        # What is recorded can be read while it grows, and is there if this process is killed.
        self.flush()
