"""The interface of every carrier."""

from __future__ import annotations

from typing import Protocol

from ev3proto.tables.carriers import Carrier

SEND_TIMEOUT = 30.0
"""Seconds after which a brick that accepts no bytes is considered gone."""


class Wire(Protocol):
    """A connection to one brick that carries bytes. One thread sends while another receives."""

    carrier: Carrier  # what carries them, as captures call it
    label: str  # which brick, as messages call it

    def send(self, frame: bytes) -> None:
        """Sends one whole frame. Raises ConnectionLostError."""

    def receive(self, timeout: float) -> bytes:
        """Waits for bytes, some seconds at most; returns none if nothing came. Raises ConnectionLostError."""

    def stop(self) -> None:
        """Unblocks a pending `receive`, if the carrier can. Nothing is sent or received afterwards."""

    def close(self) -> None:
        """Ends the connection, after the last `receive`. A second call does nothing."""
