"""A layer for Scapy that dissects, builds and sends frames, with a packet for every operation and system command.

    from ev3proto import scapy as ev3
    from ev3proto.scapy import EV3, EV3DirectCommand

    tone = EV3(counter=42) / EV3DirectCommand(operations=[ev3.SOUND_TONE(VOLUME=1, FREQUENCY=440, DURATION=1000)])
    bytes(tone), EV3(b"..."), EV3(b"...").show()
    EV3(counter=42) / ev3.SOUND_TONE(VOLUME=1, FREQUENCY=440, DURATION=1000) / ev3.UI_FLUSH()
    EV3() / ev3.SYS_LIST_FILES(path="/home/root/lms2012/prjs/", max_bytes=1000)
    sniff(offline="robot.pcap", session=EV3Session)
    StreamSocket(connected, EV3).sr1(question)
    from ev3proto.scapy import *; eval(packet.command())

Importing it binds EV3 to TCP port 5555, to reports of USB and to Bluetooth's serial ports.

Operations are named as in the tables, with a _ for the dot (`SOUND_TONE`, `UI_FLUSH`), system commands SYS_LIST_FILES,
their replies SYS_LIST_FILES_REPLY, and those of the bootloader SYS_BOOTLOADER_START_APP. All of them are attributes of
this module.

A frame with an operation requests the memory that it uses, and a reply if the operation writes to global memory.
System commands get their number in the same way.

An argument is a number, a text, the name of an enumeration's member or a variable (`GV(0)`), and is built in its
shortest encoding. Bytes are one encoded argument: `LC2(1)`. Dissected arguments are kept as bytes if their
encoding is not the shortest; building a dissected frame gives the same bytes.

Operations are read by the instruction set that `conf.contribs["ev3"]["dialect"]` names.
"""

from __future__ import annotations

from math import inf, nan
from typing import Any

try:
    import scapy  # noqa: F401 - one place for the error, and first
except ImportError as error:
    from ev3proto.extras import install_command

    raise ImportError(f"ev3proto.scapy needs scapy, which is not installed: {install_command('scapy')}") from error

from scapy.packet import Padding, Raw

from ev3proto.errors import near_misses
from ev3proto.messages import GV, LV
from ev3proto.scapy.carriers import RFCOMM, EV3Session, USBmon, USBmonPadded
from ev3proto.scapy.frames import (
    EV3,
    EV3DaisyCommand,
    EV3DaisyReply,
    EV3DirectCommand,
    EV3DirectReply,
    EV3SensorReport,
    EV3Text,
)
from ev3proto.scapy.operations import EV3Operation, operation_layer, operation_names
from ev3proto.scapy.system import SYSTEM_LAYERS, EV3SystemCommand, EV3SystemReply

__all__ = [
    "EV3",
    "GV",
    "LV",
    "RFCOMM",
    "EV3DaisyCommand",
    "EV3DaisyReply",
    "EV3DirectCommand",
    "EV3DirectReply",
    "EV3Operation",
    "EV3SensorReport",
    "EV3Session",
    "EV3SystemCommand",
    "EV3SystemReply",
    "EV3Text",
    "Padding",
    "Raw",
    "USBmon",
    "USBmonPadded",
    "inf",
    "nan",
    *operation_names(),
    *SYSTEM_LAYERS,
]
"""What `from ev3proto.scapy import *` imports: all that `command()` of a packet may name."""


def __getattr__(name: str) -> Any:
    """Returns the layer of an operation or system command, created on first use."""
    if name in SYSTEM_LAYERS:
        return SYSTEM_LAYERS[name]
    names = operation_names()
    if name in names:
        return operation_layer(names[name])
    hint = "" if name.startswith("_") else near_misses(name, [*names, *SYSTEM_LAYERS])
    raise AttributeError(f"unknown layer {name}{hint}")


def __dir__() -> list[str]:
    return sorted({*globals(), *operation_names(), *SYSTEM_LAYERS})
