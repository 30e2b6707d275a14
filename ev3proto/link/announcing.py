"""The beacon of the proxy: programs that look for a brick by its beacon find the proxy in its place."""

from __future__ import annotations

import contextlib
import ipaddress
import socket
import threading

from ev3proto.schema.discovery import Beacon

PERIOD = 5.0
"""Seconds from one beacon to the next, as a brick has it."""

_EVERYBODY = "255.255.255.255"


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
        listens_at = ipaddress.ip_address(address)
        self._to = ("127.0.0.1" if listens_at.is_loopback else _EVERYBODY, port)
        self._is_over = threading.Event()
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_BROADCAST, 1)
        # Programs answer to the port that the beacon names, or to that which it came from: best if they are the same.
        if listens_at.version == 4:
            with contextlib.suppress(OSError):
                self._socket.bind((address, int(beacon.port)))
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
            if self._is_over.wait(PERIOD):
                return
