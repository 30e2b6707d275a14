"""`--record`: a capture of what goes over the brick's connections, made without a network to capture on.

Each connection is shown as the carrier's own opening, its frames as they came and went, and its end.
"""

from __future__ import annotations

import time
from pathlib import Path
from typing import BinaryIO, cast

from ev3proto.brick.servers.host import Connection, Say
from ev3proto.generate.captures import PacketFile, carrier_writer, wifi
from ev3proto.generate.captures.carrier_writer import CarrierWriter
from ev3proto.tables.carriers import Carrier
from ev3proto.whole_files import GrowingFile

_FIRST_PORT, _PORTS = 49152, 16384
"""Ports of clients in the capture."""

_SEGMENT = 1460
"""Bytes of a TCP segment; longer frames are cut."""


class Recorder:
    """Writes a pcapng file while the brick is on. `packets` counts those written."""

    def __init__(self, path: Path, say: Say) -> None:
        """Opens the file, and empties it. OSError where it cannot be written."""
        self._say = say
        self._path = path
        self._stream = GrowingFile(path)
        self._file = PacketFile(cast(BinaryIO, self._stream))
        self._interface = self._file.interface(Carrier("wifi"))
        self._writers: dict[Connection, tuple[CarrierWriter, int]] = {}
        self._is_open = True
        self.packets = 0

    def opened(self, connection: Connection) -> None:
        """What comes before the first frame."""
        if not self._is_open:
            return
        carrier = Carrier(connection.carrier)
        writer: CarrierWriter
        if carrier == "wifi":
            writer = wifi.Writer(_FIRST_PORT + (connection.number - 1) % _PORTS)
        else:
            writer = carrier_writer(carrier)
        self._writers[connection] = writer, self._file.interface(carrier)
        self._write(connection, writer.opening())

    def frame(self, connection: Connection, frame: bytes, is_from_host: bool) -> None:
        """A frame, in as many segments as it needs."""
        if connection not in self._writers:
            return
        writer, _ = self._writers[connection]
        for at in range(0, len(frame), _SEGMENT):
            self._write(connection, writer.between(is_from_host) if at == 0 else [])
            self._write(connection, writer.frame(frame[at : at + _SEGMENT], is_from_host))

    def left(self, connection: Connection, data: bytes, reason: str) -> None:  # noqa: ARG002 - the bytes tell it
        """Bytes that were not a whole frame, as they came."""
        self.frame(connection, data, True)

    def closed(self, connection: Connection) -> None:
        """What comes after the last frame."""
        if connection in self._writers:
            self._write(connection, self._writers[connection][0].closing())
            self._writers.pop(connection, None)

    def close(self) -> None:
        """Ends all connections and the file."""
        for connection in list(self._writers):
            self.closed(connection)
        if self._is_open:
            self._is_open = False
            try:
                self._stream.close()
            except OSError as error:
                self._say(f"{self._path}: it cannot be ended: {error.strerror or error}")

    def _write(self, connection: Connection, packets: list[bytes]) -> None:
        writer, interface = self._writers[connection]
        now = time.time_ns()
        try:
            for packet in packets:
                self._file.write(writer.stamped(packet, now), now, interface)
                self.packets += 1
            # What is recorded can be read while it grows, and is there if this process is killed.
            self._stream.flush()
        except OSError as error:
            self._is_open = False
            self._writers.clear()
            self._say(f"{self._path}: nothing more is recorded: {error.strerror or error}")
