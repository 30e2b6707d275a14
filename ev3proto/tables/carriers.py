"""Carriers of frames: one entry each, and the numbers by which a brick is found on them.

To add a carrier, add an entry to `Carrier`. Its name is also the name of the folder in `capture/carriers` that reads
it, of the module in `generate/captures` that writes it, and of the part of the dissector in
`generate/dissector/runtime`. The texts by which bricks are found on WiFi are in `discovery`.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum, StrEnum
from typing import Self


class Link(IntEnum):
    """Link types of captures, numbered as in https://www.tcpdump.org/linktypes.html."""

    LOOPBACK = 0
    ETHERNET = 1
    RAW_BSD = 12
    RAW_OPENBSD = 14
    RAW_IP = 101
    LOOPBACK_OPENBSD = 108
    LINUX_COOKED = 113
    HCI = 187
    USBMON = 189
    HCI_WITH_DIRECTION = 201
    USBMON_PADDED = 220
    IPV4 = 228
    IPV6 = 229
    USBPCAP = 249
    BLUETOOTH_MONITOR = 254
    LINUX_COOKED_2 = 276


@dataclass(frozen=True, slots=True, kw_only=True)
class CarrierFacts:
    """The facts about one carrier.

    label      its name as people write it
    links      link types of captures that have it
    protocols  Wireshark's names of the protocols that hold its frames
    export     link type of the captures that ev3proto writes
    interface  example of an interface to capture on
    """

    label: str
    links: tuple[Link, ...]
    protocols: tuple[str, ...]
    export: Link
    interface: str


class Carrier(StrEnum):
    """The carriers of frames."""

    facts: CarrierFacts

    def __new__(cls, name: str, facts: CarrierFacts | None = None) -> Self:
        """A member with its name as value. Type checkers need the default: `Carrier("usb")` looks like a call."""
        assert facts is not None
        member = str.__new__(cls, name)
        member._value_ = name
        member.facts = facts
        return member

    USB = (
        "usb",
        CarrierFacts(
            label="USB",
            links=(Link.USBMON, Link.USBMON_PADDED, Link.USBPCAP),
            protocols=("usb",),
            export=Link.USBMON_PADDED,
            interface="usbmon1",
        ),
    )
    BLUETOOTH = (
        "bluetooth",
        CarrierFacts(
            label="Bluetooth",
            links=(Link.HCI, Link.HCI_WITH_DIRECTION, Link.BLUETOOTH_MONITOR),
            protocols=("btrfcomm",),
            export=Link.HCI_WITH_DIRECTION,
            interface="bluetooth0",
        ),
    )
    WIFI = (
        "wifi",
        CarrierFacts(
            label="WiFi",
            links=(
                Link.ETHERNET,
                Link.LOOPBACK,
                Link.LOOPBACK_OPENBSD,
                Link.LINUX_COOKED,
                Link.LINUX_COOKED_2,
                Link.RAW_BSD,
                Link.RAW_OPENBSD,
                Link.RAW_IP,
                Link.IPV4,
                Link.IPV6,
            ),
            protocols=("tcp", "udp"),
            export=Link.ETHERNET,
            interface="wlan0",
        ),
    )


CARRIERS = tuple(carrier.value for carrier in Carrier)
"""The names of all carriers."""

DEFAULT_CARRIER = Carrier.WIFI
"""The default carrier of written captures."""

USB_VENDOR = 0x0694
"""LEGO's USB vendor id."""

USB_PRODUCT = 0x0005
"""The brick running its firmware: one HID interface, one interrupt endpoint each way."""

USB_BOOTLOADER = 0x0006
"""The brick while its firmware is updated."""

USB_PRODUCTS = frozenset(((USB_VENDOR, USB_PRODUCT), (USB_VENDOR, USB_BOOTLOADER)))
"""USB vendor and product ids of bricks."""

USB_ENDPOINT_OUT = 0x01
"""Interrupt endpoint of the reports to the brick."""

USB_ENDPOINT_IN = 0x81
"""Interrupt endpoint of the reports from the brick."""

RFCOMM_CHANNEL = 1
"""Bluetooth channel on which a brick serves the serial port profile."""

RFCOMM_DATA = 0xEF
"""The type of RFCOMM's frames with data (UIH), their control byte without the bit below."""

RFCOMM_POLL = 0x10
"""The bit of RFCOMM's control bytes that asks for an answer; in frames with data, it announces a byte of credits."""
