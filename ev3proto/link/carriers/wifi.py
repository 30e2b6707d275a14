"""WiFi: the beacon by which a brick is found, the text that unlocks its TCP port, and the connection."""

from __future__ import annotations

import contextlib
import errno
import re
import socket
import time
from dataclasses import dataclass

from ev3proto.errors import DecodeError
from ev3proto.link.carriers.sockets import SocketWire
from ev3proto.link.errors import NoBrickError, PortInUseError
from ev3proto.link.targets import Target
from ev3proto.schema.discovery import Beacon, Unlock
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.discovery import ACCEPT, BEACON_PORT, TCP_PORT

_ANY_SERIAL = "0" * 12
"""The serial number that is sent if the real one is unknown: the brick does not compare it."""

_ANSWER = b"ev3proto"
"""The answer to a beacon; any datagram will do."""

_MOST_BEACON = 1 << 10
_MOST_TEXT = 64
_DIGITS = re.compile("[0-9a-f]{12}")


@dataclass(frozen=True, slots=True)
class Found:
    """A brick whose beacon was heard: its address, TCP port, serial number and name."""

    address: str
    port: int
    serial_number: str
    name: str


def open_wifi(target: Target, timeout: float) -> SocketWire:
    """Connects to a brick by WiFi, after its beacon if the target has no address. Raises LinkError."""
    serial_number = target.serial_number
    if target.host is None or serial_number is not None:
        found = discover(serial_number, timeout)
        return connect(found.address, target.port or found.port, timeout, found.serial_number)
    return connect(target.host, target.port or TCP_PORT, timeout)


def discover(serial_number: str | None, timeout: float, *, interface: str = "", port: int = BEACON_PORT) -> Found:
    """Waits for the beacon of a brick, None for any, and answers it. Raises PortInUseError and NoBrickError."""
    deadline = time.monotonic() + timeout
    others: dict[str, str] = {}
    with _listening(interface, port) as listening:
        while (left := deadline - time.monotonic()) > 0:
            listening.settimeout(left)
            try:
                datagram, sender = listening.recvfrom(_MOST_BEACON)
                beacon = Beacon.parse(datagram)
            except TimeoutError:
                break
            except (DecodeError, OSError):
                continue  # not a beacon, or an unreadable one: wait for the next one
            found = _found(beacon, sender[0])
            if found is None:
                continue
            if serial_number in (None, found.serial_number):
                with contextlib.suppress(OSError):
                    listening.sendto(_ANSWER, sender)
                return found
            others[found.serial_number] = found.address
    raise NoBrickError(_not_heard(serial_number, timeout, others))


def _found(beacon: Beacon, address: str) -> Found | None:
    serial_number = beacon.serial.lower()
    if beacon.tcp_port is None or not _DIGITS.fullmatch(serial_number):
        return None
    return Found(address, beacon.tcp_port, serial_number, beacon.name)


def _not_heard(serial_number: str | None, timeout: float, others: dict[str, str]) -> str:
    which = "no brick" if serial_number is None else f"no brick with the serial number {serial_number}"
    heard = "".join(f"; {number} is at {address}" for number, address in others.items())
    return (
        f"{which} was found within {timeout:g} s{heard}. Is the brick's WiFi on, is it in the same network as this"
        " computer, and does the firewall let UDP port 3015 in? wifi:ADDRESS works without that"
    )


def _listening(interface: str, port: int) -> socket.socket:
    listening = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        listening.bind((interface, port))
    except OSError as error:
        listening.close()
        if error.errno == errno.EADDRINUSE:
            raise PortInUseError(
                f"UDP port {port} is in use: another program waits for a brick's beacon; end it, or give the brick's"
                " address (wifi:ADDRESS)"
            ) from None
        raise NoBrickError(f"UDP port {port} cannot be opened: {error.strerror or error}") from None
    return listening


def connect(address: str, port: int, timeout: float, serial_number: str = _ANY_SERIAL) -> SocketWire:
    """Connects to a brick whose address is known, and unlocks it. Raises NoBrickError."""
    place = f"[{address}]:{port}" if ":" in address else f"{address}:{port}"
    deadline = time.monotonic() + timeout
    try:
        connected = socket.create_connection((address, port), timeout)
    except (OSError, UnicodeError) as error:
        raise NoBrickError(_unreachable(place, error, timeout)) from None
    try:
        connected.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        connected.sendall(Unlock(serial_number).build())
        rest = _accepted(connected, place, deadline)
    except TimeoutError:
        connected.close()
        raise NoBrickError(
            f"{place} accepted the connection, but did not answer the unlock text; is another program connected to the"
            " brick, or is this not a brick?"
        ) from None
    except OSError as error:
        connected.close()
        raise NoBrickError(f"{place} closed the connection: {error.strerror or error}") from None
    except NoBrickError:
        connected.close()
        raise
    return SocketWire(connected, Carrier.WIFI, f"the brick at {place}", rest)


def _accepted(connected: socket.socket, place: str, deadline: float) -> bytes:
    """Waits for the answer to the unlock text. Returns the bytes after it."""
    text = b""
    while len(text) < len(ACCEPT):
        connected.settimeout(max(deadline - time.monotonic(), 0.001))
        piece = connected.recv(_MOST_TEXT)
        if not piece:
            raise NoBrickError(f"{place} is not a brick: it closed the connection after the unlock text")
        text += piece
        if not text.startswith(ACCEPT[: len(text)]):
            raise NoBrickError(f"{place} is not a brick: it answered {text[:_MOST_TEXT]!r}")
    # Some firmware sends a zero after the text.
    return text[len(ACCEPT) :].removeprefix(b"\0")


def _unreachable(place: str, error: Exception, timeout: float) -> str:
    if isinstance(error, TimeoutError):
        return f"{place} did not answer within {timeout:g} s; is the brick on, and in the same network?"
    if isinstance(error, ConnectionRefusedError):
        return f"nothing is listening on {place}; is the brick's WiFi on? `ev3proto brick` starts a virtual brick"
    if isinstance(error, socket.gaierror | UnicodeError):
        host = place.rpartition(":")[0]
        return f"cannot find {host}: no computer or brick has this name"
    reason = getattr(error, "strerror", None) or str(error)
    return f"{place} cannot be reached: {reason}"
