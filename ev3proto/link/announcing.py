"""The beacon of the proxy: programs that look for a brick by its beacon find the proxy in its place."""

from __future__ import annotations

import contextlib
import threading

from ev3proto.brick.servers.unlocking import BEACON_PERIOD, beacon_socket
from ev3proto.schema.discovery import Beacon


class Announcement:
    """Sends beacons, from the moment it is made until it is stopped."""

    def __init__(self, beacon: Beacon, address: str, port: int) -> None:
        """Begins.

        Args:
            beacon: What it says.
            address: Where the proxy listens: on loopback only this computer hears it, else everybody in the network.
            port: The UDP port to which beacons go.
        """
        self._datagram = beacon.build()
        self._is_over = threading.Event()
        self._socket, to = beacon_socket(address, int(beacon.port))
        self._to = (to, port)
        self._thread = threading.Thread(target=self._announce, name="sends beacons", daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """Sends no more."""
        self._is_over.set()
        self._thread.join()
        self._socket.close()

    def _announce(self) -> None:
        while True:
            with contextlib.suppress(OSError):  # a network may come and go
                self._socket.sendto(self._datagram, self._to)
            if self._is_over.wait(BEACON_PERIOD):
                return
