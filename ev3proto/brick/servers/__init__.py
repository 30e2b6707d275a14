"""The servers of a virtual brick: its clock, connections of several carriers, deliberate faults, the page.

`host` drives the brick and serves its connections one frame after the other; `wifi` and `serial_port` carry frames to
it; `page` shows it in a browser. Everything runs in one event loop of asyncio.
"""

from __future__ import annotations

from typing import Any


class Observer:
    """An observer of the connections, which overrides what it wants to know."""

    def opened(self, connection: Any) -> None:
        """Learns that a client has connected."""

    def frame(self, connection: Any, frame: bytes, is_from_host: bool) -> None:
        """Receives a frame from or to a client."""

    def left(self, connection: Any, data: bytes, reason: str) -> None:
        """Learns that the last bytes of a client were not a whole frame, and why."""

    def waiting(self, connection: Any, reason: str) -> None:
        """Learns what the command of a client waits for in vain, such as a motor that is not plugged in."""

    def closed(self, connection: Any) -> None:
        """Learns that a client has disconnected, and that all of its frames are done."""
