"""Makes the captures in this folder, with the same bytes every time.

    .venv/bin/python captures/make.py [FOLDER]

They are written into FOLDER, by default the folder of this script. README.md describes each.
"""

from __future__ import annotations

import sys
from pathlib import Path

from making import bluetooth, conformance, senders, usb, wifi
from making.files import write_btsnoop, write_pcap, write_pcapng

ETHERNET, BLUETOOTH_H4_WITH_DIRECTION, USBMON, USBMON_MAPPED, USBPCAP = 1, 201, 189, 220, 249


def main(folder: Path) -> None:
    """Writes all captures."""
    write_pcapng(folder / "wifi.pcapng", wifi.whole(), ETHERNET)
    write_pcapng(folder / "conformance.pcapng", conformance.whole(), ETHERNET)
    write_pcapng(folder / "wifi-long.pcapng", wifi.long_downloads(), ETHERNET)
    write_pcap(folder / "wifi-reordered.pcap", wifi.reordered(), ETHERNET, nano=True)
    write_pcapng(folder / "senders.pcapng", senders.whole(), ETHERNET)
    write_pcapng(folder / "usb.pcapng", usb.plugged_in(), USBMON_MAPPED)
    write_pcap(folder / "usb-plugged.pcap", usb.among_others(), USBMON)
    write_pcap(folder / "usb-windows.pcap", usb.windows(), USBPCAP)
    write_pcapng(folder / "usb-bootloader.pcapng", usb.bootloader(), USBMON_MAPPED)
    write_pcap(folder / "daisy.pcap", usb.chain(), USBMON_MAPPED)
    write_btsnoop(folder / "bluetooth.log", bluetooth.whole())
    write_pcapng(
        folder / "bluetooth.pcapng", bluetooth.with_direction(bluetooth.begun_late()), BLUETOOTH_H4_WITH_DIRECTION
    )


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)
