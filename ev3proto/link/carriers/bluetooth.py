"""Bluetooth: the standard library's RFCOMM socket, if this Python has one."""

from __future__ import annotations

import errno
import re
import socket

from ev3proto.link.carriers.sockets import SocketWire
from ev3proto.link.errors import NoBrickError, PortInUseError
from ev3proto.link.targets import Target
from ev3proto.tables.carriers import RFCOMM_CHANNEL, Carrier

_NO_RFCOMM = (
    "this Python has no Bluetooth sockets (it was built without them, or the system has none, as macOS). Give the"
    " serial port of the connection in place of the MAC address: /dev/rfcomm0 (Linux, `rfcomm bind 0 MAC`),"
    " /dev/tty.EV3-SerialPort (macOS), COM5 (Windows)"
)


def open_bluetooth(target: Target, timeout: float) -> SocketWire:
    """Connects to the brick with a MAC address, waiting some seconds at most. Raises LinkError."""
    number = target.serial_number
    if number is None:
        raise NoBrickError(
            f"invalid MAC address {target.host!r}; expected one such as 00:16:53:42:2B:99, which the brick shows under"
            " Brick Info as ID"
        )
    address = ":".join(re.findall("..", number.upper()))
    connected = _socket()
    try:
        connected.settimeout(timeout)
        connected.connect((address, RFCOMM_CHANNEL))
    except OSError as error:
        connected.close()
        raise _why(error, address, timeout) from None
    return SocketWire(connected, Carrier.BLUETOOTH, f"the brick {address}")


def _socket() -> socket.socket:
    family, protocol = getattr(socket, "AF_BLUETOOTH", None), getattr(socket, "BTPROTO_RFCOMM", None)
    if family is None or protocol is None:
        raise NoBrickError(_NO_RFCOMM)
    try:
        return socket.socket(family, socket.SOCK_STREAM, protocol)
    except OSError as error:
        raise NoBrickError(
            f"this computer has no Bluetooth ({error.strerror or error}); plug in an adapter, and turn it on"
        ) from None


def _why(error: OSError, address: str, timeout: float) -> NoBrickError | PortInUseError:
    if error.errno == errno.EBUSY:
        return PortInUseError(f"{address}: another program is connected to this brick; end it, then try again")
    if isinstance(error, TimeoutError) or error.errno == errno.EHOSTDOWN:
        return NoBrickError(
            f"{address} did not answer within {timeout:g} s; is the brick on and near, is its Bluetooth on, and does"
            " Brick Info show this address as ID?"
        )
    if error.errno in (errno.ECONNREFUSED, errno.EACCES, errno.EPERM):
        return NoBrickError(
            f"{address} refused the connection; pair it with this computer first (the usual PIN is 1234)"
        )
    return NoBrickError(f"{address} cannot be reached: {error.strerror or error}")
