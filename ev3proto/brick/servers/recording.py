"""`--record`: a capture of the brick's connections, written directly instead of captured on a network."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import BinaryIO, cast

from ev3proto.brick.servers import Observer
from ev3proto.brick.servers.host import Connection, Say
from ev3proto.generate.captures.recording import Recording
from ev3proto.tables.carriers import Carrier
from ev3proto.whole_files import GrowingFile


class Recorder(Observer):
    """Writes a pcapng file while the brick is on."""

    def __init__(self, path: Path, say: Say, *, force: bool = False) -> None:
        """Opens the file. Raises OSError if it cannot be written."""
        self._say = say
        self._path = path
        self._stream = GrowingFile(path, force=force)
        self._recording = Recording(cast(BinaryIO, self._stream))
        self._is_open = True

    @property
    def packets(self) -> int:
        """Number of packets written."""
        return self._recording.packets

    def opened(self, connection: Connection) -> None:
        """Records the beginning of a connection: on WiFi the TCP handshake, the unlock text and its answer."""
        carrier = Carrier(connection.carrier)
        self._try(lambda: self._recording.opened(connection, carrier, *connection.ends))
        for data, is_from_host in connection.opening:
            self.frame(connection, data, is_from_host)

    def frame(self, connection: Connection, frame: bytes, is_from_host: bool) -> None:
        """Records a frame, or a text before the first one."""
        self._try(lambda: self._recording.data(connection, frame, is_from_host))

    def left(self, connection: Connection, data: bytes, reason: str) -> None:  # noqa: ARG002 - the bytes tell it
        """Records bytes that were not a whole frame."""
        self._try(lambda: self._recording.data(connection, data, True))

    def closed(self, connection: Connection) -> None:
        """Records the end of a connection."""
        self._try(lambda: self._recording.closed(connection))

    def close(self) -> None:
        """Ends all connections and the file. Without a packet, the file is as it was."""
        if self.packets:
            self._try(self._recording.close)
        if self._is_open:
            self._is_open = False
            try:
                self._stream.close()
            except OSError as error:
                self._say(f"{self._path}: it cannot be ended: {error.strerror or error}")

    def _try(self, write: Callable[[], None]) -> None:
        """Writes, until writing fails."""
        if not self._is_open:
            return
        try:
            write()
        except OSError as error:
            self._is_open = False
            self._say(f"{self._path}: nothing more is recorded: {error.strerror or error}")
