"""Opens the carrier of a target."""

from __future__ import annotations

from ev3proto.link.carriers.bluetooth import open_bluetooth
from ev3proto.link.carriers.serial_port import open_serial
from ev3proto.link.carriers.usb import open_usb
from ev3proto.link.carriers.virtual import open_virtual
from ev3proto.link.carriers.wifi import open_wifi
from ev3proto.link.carriers.wire import Wire
from ev3proto.link.targets import Target, Way

CONNECT_TIMEOUT = 15.0
"""Seconds to wait for a beacon, and for a connection. Beacons are sent every five seconds."""


def open_wire(target: Target, timeout: float = CONNECT_TIMEOUT) -> Wire:
    """Connects to a brick, waiting some seconds at most. Raises LinkError, which says what to do."""
    if target.way is Way.WIFI:
        return open_wifi(target, timeout)
    if target.way is Way.USB:
        return open_usb(target)
    if target.way is Way.BLUETOOTH:
        return open_bluetooth(target, timeout)
    if target.way is Way.SERIAL:
        return open_serial(target)

    return open_virtual(target)
