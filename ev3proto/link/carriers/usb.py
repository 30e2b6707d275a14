"""USB: reports of one HID interface, each with one frame at its start. It needs hidapi."""

from __future__ import annotations

from typing import Any

from ev3proto.extras import install_command
from ev3proto.link.errors import ConnectionLostError, LinkError, NoBrickError
from ev3proto.link.targets import Target
from ev3proto.schema.header import frame_size
from ev3proto.tables.carriers import USB_BOOTLOADER, USB_PRODUCT, USB_VENDOR, Carrier
from ev3proto.tables.frame import LENGTH_FIELD, MAX_FRAME

UDEV_RULE = (
    f'SUBSYSTEMS=="usb", ATTRS{{idVendor}}=="{USB_VENDOR:04x}", ATTRS{{idProduct}}=="{USB_PRODUCT:04x}", MODE="0666"'
)
"""The udev rule that gives all users of a Linux computer access to a brick."""

_REPORT_ID = b"\0"
"""The report number that hidapi expects before a report. It is not sent."""

_MILLISECONDS = 1000


class UsbWire:
    """An open device of hidapi; `Wire` documents its methods."""

    def __init__(self, device: Any, serial_number: str) -> None:
        """Takes over an open device."""
        self.carrier = Carrier.USB
        self.label = f"the brick {serial_number or 'on USB'}"
        self._device = device
        self._is_closed = False

    def send(self, frame: bytes) -> None:
        """Sends one whole frame. Raises ConnectionLostError."""
        try:
            written = self._device.write(_REPORT_ID + frame.ljust(MAX_FRAME, b"\0"))
        except (OSError, ValueError):
            written = -1
        if written < 0:
            raise self._gone()

    def receive(self, timeout: float) -> bytes:
        """Waits for a report, and returns its frame without the padding. Raises ConnectionLostError."""
        try:
            report = bytes(self._device.read(MAX_FRAME, round(timeout * _MILLISECONDS)))
        except (OSError, ValueError):
            raise self._gone() from None
        if len(report) < LENGTH_FIELD:
            return report
        return report[: frame_size(report)]

    def stop(self) -> None:
        """Does nothing: hidapi cannot unblock a pending read."""

    def close(self) -> None:
        """Ends the connection. A second call does nothing."""
        if not self._is_closed:
            self._is_closed = True
            self._device.close()

    def _gone(self) -> ConnectionLostError:
        return ConnectionLostError(f"{self.label} was unplugged or switched off; plug it in, and connect again")


def open_usb(target: Target) -> UsbWire:
    """Opens the brick with a serial number, or the only one. Raises LinkError, also if hidapi is not installed."""
    try:
        import hid  # an extra
    except ImportError as error:
        if "libusb" in str(error) or "libhidapi" in str(error) or "libudev" in str(error):
            raise LinkError(f"hidapi cannot be loaded: {error}") from None
        raise LinkError(f"USB needs the package hidapi, which is not installed: {install_command('usb')}") from None
    found = {str(each["serial_number"] or "").lower(): each for each in hid.enumerate(USB_VENDOR, USB_PRODUCT)}
    chosen = _chosen(target, found, is_updating=bool(hid.enumerate(USB_VENDOR, USB_BOOTLOADER)))
    device = hid.device()
    try:
        device.open_path(found[chosen]["path"])
    except OSError:
        raise NoBrickError(
            f"no permission to open the brick {chosen}, or another program uses it. On Linux, write this line to"
            f" /etc/udev/rules.d/99-ev3.rules and plug the brick in again: {UDEV_RULE}"
        ) from None
    return UsbWire(device, chosen)


def _chosen(target: Target, found: dict[str, Any], *, is_updating: bool) -> str:
    """Returns the serial number of the selected brick, if it is plugged in. Raises NoBrickError."""
    listed = ", ".join(found)
    if not found:
        if is_updating:
            raise NoBrickError("the brick on USB is in its firmware updater; restart it")
        raise NoBrickError("no brick found on USB; is the cable in the port marked PC, and is the brick on?")
    if target.host is None:
        if len(found) > 1:
            raise NoBrickError(f"{len(found)} bricks are plugged in ({listed}); choose one by its serial number")
        return next(iter(found))
    wanted = target.serial_number or target.host.lower()
    if wanted not in found:
        raise NoBrickError(f"no brick with the serial number {wanted} is plugged in, only {listed}")
    return wanted
