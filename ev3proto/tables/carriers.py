"""Carriers of frames: how a brick shows itself on USB and where it listens on Bluetooth; WiFi is in `discovery`."""

CARRIERS = ("usb", "bluetooth", "wifi")
"""What can carry frames."""

USB_VENDOR = 0x0694
"""LEGO's number among the makers of USB devices."""

USB_PRODUCT = 0x0005
"""The brick running its firmware: one HID interface, one interrupt endpoint each way."""

USB_BOOTLOADER = 0x0006
"""The brick while its firmware is updated."""

USB_ENDPOINT_OUT = 0x01
"""Interrupt endpoint of the reports to the brick."""

USB_ENDPOINT_IN = 0x81
"""Interrupt endpoint of the reports from the brick."""

RFCOMM_CHANNEL = 1
"""Bluetooth channel on which a brick serves the serial port profile."""
