"""ev3proto: the wire protocol of the LEGO MINDSTORMS EV3, both ways.

    message = ev3proto.parse(frame)
    message.build() == frame

Everything that people need stands here by name. Beside it stand the constants and encoding functions that programs for
the EV3 are written with: `ev3proto.opSound`, `ev3proto.TONE`, `ev3proto.LED_RED`, `ev3proto.LCX(440)`.
"""

from __future__ import annotations

import ev3proto.starting  # noqa: F401 - before all others, which take a while to load

# isort: split
from importlib import import_module
from typing import TYPE_CHECKING, Any

from ev3proto.errors import BuildError, DecodeError, Fault
from ev3proto.messages import (
    GV,
    LV,
    Argument,
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    DirectReply,
    Message,
    Operation,
    SensorReport,
    SystemCommand,
    SystemReply,
    Variable,
)
from ev3proto.schema.constructors import direct_command, direct_reply, system_command, system_reply
from ev3proto.schema.frame import parse
from ev3proto.schema.instructions import operation
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SystemStatus
from ev3proto.version import VERSION

if TYPE_CHECKING:
    from ev3proto import capture, enums, ops, program, system
    from ev3proto.checking.checking import check
    from ev3proto.checking.fixing import Fix, fix
    from ev3proto.checking.report import Finding, Report, Severity
    from ev3proto.compose import Draft, Global, Label, Local, command
    from ev3proto.dialogue import Dialogue, Exchange, Transfer, Value
    from ev3proto.link.async_ev3 import AsyncEV3
    from ev3proto.link.errors import (
        ConnectionLostError,
        DirCmdError,
        DirectCommandError,
        LinkError,
        NoAnswerError,
        NoBrickError,
        NoEV3,
        PortInUse,
        PortInUseError,
        SysCmdError,
        SystemCommandError,
        TransferError,
    )
    from ev3proto.link.ev3 import EV3
    from ev3proto.schema.discovery import Beacon, Unlock
    from ev3proto.schema.names import ADR, GVX, HND, LAB1, LC0, LC1, LC2, LC4, LCF, LCS, LCX, LVX
    from ev3proto.stream import Decoder, StreamError

__version__ = VERSION

_LATER = {
    "ev3proto.checking.checking": ("check",),
    "ev3proto.checking.fixing": ("Fix", "fix"),
    "ev3proto.checking.report": ("Finding", "Report", "Severity"),
    "ev3proto.compose": ("Draft", "Global", "Label", "Local", "command"),
    "ev3proto.dialogue": ("Dialogue", "Exchange", "Transfer", "Value"),
    "ev3proto.link.async_ev3": ("AsyncEV3",),
    "ev3proto.link.errors": (
        "ConnectionLostError",
        "DirCmdError",
        "DirectCommandError",
        "LinkError",
        "NoAnswerError",
        "NoBrickError",
        "NoEV3",
        "PortInUse",
        "PortInUseError",
        "SysCmdError",
        "SystemCommandError",
        "TransferError",
    ),
    "ev3proto.link.ev3": ("EV3",),
    "ev3proto.schema.names": ("ADR", "GVX", "HND", "LAB1", "LC0", "LC1", "LC2", "LC4", "LCF", "LCS", "LCX", "LVX"),
    "ev3proto.schema.discovery": ("Beacon", "Unlock"),
    "ev3proto.stream": ("Decoder", "StreamError"),
}
"""What is imported when it is first asked for: a program that only parses frames starts sooner without it."""

_MODULES = ("capture", "enums", "ops", "program", "system")
"""Parts that are modules, imported when they are first asked for, too."""

_HOME = {name: module for module, names in _LATER.items() for name in names}

__all__ = [
    "ADR",
    "EV3",
    "GV",
    "GVX",
    "HND",
    "LAB1",
    "LC0",
    "LC1",
    "LC2",
    "LC4",
    "LCF",
    "LCS",
    "LCX",
    "LV",
    "LVX",
    "Argument",
    "AsyncEV3",
    "Beacon",
    "BuildError",
    "ConnectionLostError",
    "DaisyCommand",
    "DaisyReply",
    "DecodeError",
    "Decoder",
    "Dialogue",
    "DirCmdError",
    "DirectCommand",
    "DirectCommandError",
    "DirectReply",
    "Draft",
    "Exchange",
    "Fault",
    "Finding",
    "Fix",
    "Global",
    "Label",
    "LinkError",
    "Local",
    "Message",
    "MessageType",
    "NoAnswerError",
    "NoBrickError",
    "NoEV3",
    "Operation",
    "PortInUse",
    "PortInUseError",
    "Report",
    "SensorReport",
    "Severity",
    "StreamError",
    "SysCmdError",
    "SystemCommand",
    "SystemCommandError",
    "SystemReply",
    "SystemStatus",
    "Transfer",
    "TransferError",
    "Unlock",
    "Value",
    "Variable",
    "capture",
    "check",
    "command",
    "direct_command",
    "direct_reply",
    "enums",
    "fix",
    "operation",
    "ops",
    "parse",
    "program",
    "system",
    "system_command",
    "system_reply",
]


def __getattr__(name: str) -> Any:
    """What is imported late, and the constants of the instruction set: `opSound`, `TONE`, `LED_RED`, `PORT_A`, ..."""
    if name in _MODULES:
        return import_module(f"ev3proto.{name}")
    if name in _HOME:
        value = globals()[name] = getattr(import_module(_HOME[name]), name)
        return value
    if name.startswith("__"):
        raise AttributeError(f"module 'ev3proto' has no attribute {name!r}")
    names = import_module("ev3proto.schema.names")
    try:
        return names.constant(name)
    except KeyError as error:
        raise AttributeError(f"ev3proto has no {name}: {error.args[0]}") from None


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__, *import_module("ev3proto.schema.names").constant_names()})
