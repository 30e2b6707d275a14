"""Bytes over a connected socket: what WiFi and Bluetooth share."""

from __future__ import annotations

import contextlib
import selectors
import socket

from ev3proto.link.carriers.wire import SEND_TIMEOUT
from ev3proto.link.errors import ConnectionLostError
from ev3proto.tables.carriers import Carrier

_CHUNK = 1 << 16


class SocketWire:
    """A connected socket; `Wire` documents its methods."""

    def __init__(self, connected: socket.socket, carrier: Carrier, label: str, first: bytes = b"") -> None:
        """Takes over a socket; `first` are bytes that were already read from it."""
        self.carrier = carrier
        self.label = label
        self._socket = connected
        self._first = first
        self._selector = selectors.DefaultSelector()
        self._selector.register(connected, selectors.EVENT_READ)
        connected.settimeout(SEND_TIMEOUT)

    def send(self, frame: bytes) -> None:
        """Sends one whole frame. Raises ConnectionLostError."""
        try:
            self._socket.sendall(frame)
        except TimeoutError:
            raise ConnectionLostError(f"{self.label} has accepted no data for {SEND_TIMEOUT:g} s; restart it") from None
        except OSError as error:
            raise ConnectionLostError(
                f"the connection to {self.label} was lost ({error.strerror or error}); connect again"
            ) from None

    def receive(self, timeout: float) -> bytes:
        """Waits for bytes. Raises ConnectionLostError."""
        if self._first:
            first, self._first = self._first, b""
            return first
        try:
            if not self._selector.select(timeout):
                return b""
            data = self._socket.recv(_CHUNK)
        except (OSError, ValueError) as error:
            reason = getattr(error, "strerror", None) or "it was closed"
            raise ConnectionLostError(f"the connection to {self.label} was lost ({reason}); connect again") from None
        if not data:
            raise ConnectionLostError(f"{self.label} closed the connection; connect again")
        return data

    def stop(self) -> None:
        """Unblocks a pending `receive`."""
        with contextlib.suppress(OSError):
            self._socket.shutdown(socket.SHUT_RDWR)

    def close(self) -> None:
        """Ends the connection. A second call does nothing."""
        self._selector.close()
        self._socket.close()
