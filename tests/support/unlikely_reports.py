"""USB reports that differ from those of a brick in one respect, by that respect."""

from __future__ import annotations

FROM_HOST, FROM_DEVICE = True, False

UNLIKELY: dict[str, tuple[bool, bytes]] = {
    "a reply from the host": (FROM_HOST, bytes.fromhex("0700 0100 02 0000F040")),
    "a command from the device": (FROM_DEVICE, bytes.fromhex("0800 0100 00 0400 81 01 60")),
    "nothing": (FROM_HOST, b""),
    "a command of no operation": (FROM_HOST, bytes.fromhex("0500 0100 80 0000")),
    "a command of zeros": (FROM_HOST, bytes.fromhex("0001 0100 00 0000")),
    "an operation cut off": (FROM_HOST, bytes.fromhex("0700 0100 80 0000 94 01")),
    "bytes behind a system command": (FROM_HOST, bytes.fromhex("0600 0100 01 9D 01 02")),
    "an unknown system command": (FROM_HOST, bytes.fromhex("0400 0100 01 77")),
    "a length that is too large": (FROM_HOST, bytes.fromhex("FF03 0100 80 0000")),
    "a daisy command to a computer": (FROM_DEVICE, bytes.fromhex("0600 0100 0A A2 00 01")),
    "a daisy reply without a command": (FROM_DEVICE, bytes.fromhex("0500 0100 08 01 00")),
}
