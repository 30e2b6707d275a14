"""The start of WiFi connections, for the virtual brick and the proxy: the beacon, the port, the unlock text."""

from __future__ import annotations

import errno
import ipaddress
import socket

from ev3proto.tables.discovery import PROTOCOL, UNLOCK_PROTOCOL, UNLOCK_REQUEST

BEACON_PERIOD = 5.0
"""Seconds from one beacon to the next."""

FIRST_READ = 100
"""Bytes that the firmware reads to find the unlock text; any others among them are lost."""

_UNLOCK = UNLOCK_REQUEST[1:].encode()
"""The part of the unlock text that the firmware checks."""

_MOST_SAID = 1024
"""Bytes that are kept, the latest ones, until the unlock text is complete."""

_EVERYBODY = "255.255.255.255"


class Unlocking:
    """Finds the unlock text."""

    def __init__(self) -> None:
        self.said = b""  # the last bytes from the client, up to the end of the read that has the text
        self.extra = False  # whether bytes right behind the text were lost with it

    def feed(self, data: bytes) -> bytes | None:
        """Takes bytes from the client. Returns the kept ones after the unlock text; None until it is there."""
        for at in range(0, len(data), FIRST_READ):
            piece = data[at : at + FIRST_READ]
            self.said = (self.said + piece)[-_MOST_SAID:]
            if _UNLOCK in self.said:
                behind = piece.partition(UNLOCK_PROTOCOL.encode())[2].lstrip(b" ").removeprefix(PROTOCOL.encode())
                self.extra = bool(behind.strip(b"\r\n\0"))
                return data[at + FIRST_READ :]
        return None


def beacon_socket(address: str, port: int) -> tuple[socket.socket, str]:
    """Returns the socket that sends beacons, and their address: on loopback, only this computer."""
    # Hosts answer to the port that the beacon names, or to the one it came from: the same, if that port is free.
    sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    sender.setblocking(False)
    sender.setsockopt(socket.SOL_SOCKET, socket.SO_BROADCAST, 1)
    for each in (port, 0):
        try:
            sender.bind((address, each))
            break
        except OSError:
            continue
    return sender, "127.0.0.1" if ipaddress.ip_address(address).is_loopback else _EVERYBODY


def why_not_open(error: Exception, address: str, port: int) -> str:
    """Returns why a port cannot be opened, and what to do."""
    code = getattr(error, "errno", None)
    if isinstance(error, OverflowError):
        return f"invalid port {port}; expected 0 to 65535"
    if code == errno.EADDRINUSE:
        return f"port {port} of {address} is in use: end what uses it, or give another one"
    if code == errno.EACCES:
        return f"port {port} needs administrator rights; take one above 1023"
    if code == errno.EADDRNOTAVAIL:
        return f"{address} is not an address of this computer"
    return f"port {port} of {address} cannot be opened: {getattr(error, 'strerror', None) or error}"
