"""Opens the carrier of a target."""

from __future__ import annotations

from ev3proto.link.carriers.wire import Wire
from ev3proto.link.targets import Target, Way

CONNECT_TIMEOUT = 15.0
"""Seconds to wait for a beacon, and for a brick that takes the connection. Beacons come every five seconds."""


def open_wire(target: Target, timeout: float = CONNECT_TIMEOUT) -> Wire:
    """Connects to a brick.

    Args:
        target: Which one.
        timeout: Seconds to wait at most, where there is anything to wait for.

    Returns:
        The connection, ready for frames.

    Raises:
        LinkError: It cannot be reached; the sentence says what to do.
    """
    if target.way is Way.WIFI:
        from ev3proto.link.carriers.wifi import open_wifi

        return open_wifi(target, timeout)
    if target.way is Way.USB:
        from ev3proto.link.carriers.usb import open_usb

        return open_usb(target)
    if target.way is Way.BLUETOOTH:
        from ev3proto.link.carriers.bluetooth import open_bluetooth

        return open_bluetooth(target, timeout)
    if target.way is Way.SERIAL:
        from ev3proto.link.carriers.serial_port import open_serial

        return open_serial(target)
    from ev3proto.link.carriers.virtual import open_virtual

    return open_virtual(target)
