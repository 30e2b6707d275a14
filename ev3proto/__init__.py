"""ev3proto: the wire protocol of the LEGO MINDSTORMS EV3, both ways.

    message = ev3proto.parse(frame)
    message.build() == frame

All public names are here, together with the constants and encoding functions of programs for
the EV3: `ev3proto.opSound`, `ev3proto.TONE`, `ev3proto.LED_RED`, `ev3proto.LCX(440)`.

Everything is imported on first use.
"""

from __future__ import annotations

from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

from ev3proto.version import VERSION

if TYPE_CHECKING:
    from ev3proto import capture as capture
    from ev3proto import enums as enums
    from ev3proto import errors as errors
    from ev3proto import messages as messages
    from ev3proto import ops as ops
    from ev3proto import program as program
    from ev3proto import reading as reading
    from ev3proto import schema as schema
    from ev3proto import system as system
    from ev3proto import tables as tables
    from ev3proto.checking.checking import check as check
    from ev3proto.checking.fixing import fix as fix
    from ev3proto.checking.report import Finding as Finding
    from ev3proto.checking.report import Fix as Fix
    from ev3proto.checking.report import Report as Report
    from ev3proto.checking.report import Severity as Severity
    from ev3proto.compose import Draft as Draft
    from ev3proto.compose import Global as Global
    from ev3proto.compose import Label as Label
    from ev3proto.compose import Local as Local
    from ev3proto.compose import command as command
    from ev3proto.dialogue import Dialogue as Dialogue
    from ev3proto.dialogue import Exchange as Exchange
    from ev3proto.dialogue import Transfer as Transfer
    from ev3proto.dialogue import Value as Value
    from ev3proto.errors import BuildError as BuildError
    from ev3proto.errors import DecodeError as DecodeError
    from ev3proto.errors import Error as Error
    from ev3proto.errors import Fault as Fault
    from ev3proto.link.async_ev3 import AsyncEV3 as AsyncEV3
    from ev3proto.link.errors import ConnectionLostError as ConnectionLostError
    from ev3proto.link.errors import DirCmdError as DirCmdError
    from ev3proto.link.errors import DirectCommandError as DirectCommandError
    from ev3proto.link.errors import LinkError as LinkError
    from ev3proto.link.errors import NoAnswerError as NoAnswerError
    from ev3proto.link.errors import NoBrickError as NoBrickError
    from ev3proto.link.errors import NoEV3 as NoEV3
    from ev3proto.link.errors import PortInUse as PortInUse
    from ev3proto.link.errors import PortInUseError as PortInUseError
    from ev3proto.link.errors import SysCmdError as SysCmdError
    from ev3proto.link.errors import SystemCommandError as SystemCommandError
    from ev3proto.link.errors import TransferError as TransferError
    from ev3proto.link.ev3 import EV3 as EV3
    from ev3proto.messages import GV as GV
    from ev3proto.messages import LV as LV
    from ev3proto.messages import Argument as Argument
    from ev3proto.messages import DaisyCommand as DaisyCommand
    from ev3proto.messages import DaisyReply as DaisyReply
    from ev3proto.messages import DirectCommand as DirectCommand
    from ev3proto.messages import DirectReply as DirectReply
    from ev3proto.messages import Message as Message
    from ev3proto.messages import Operation as Operation
    from ev3proto.messages import SensorReport as SensorReport
    from ev3proto.messages import SystemCommand as SystemCommand
    from ev3proto.messages import SystemReply as SystemReply
    from ev3proto.messages import Variable as Variable
    from ev3proto.reading import Image as Image
    from ev3proto.reading import Problem as Problem
    from ev3proto.reading import Record as Record
    from ev3proto.reading import Source as Source
    from ev3proto.reading import read as read
    from ev3proto.schema.constructors import direct_command as direct_command
    from ev3proto.schema.constructors import direct_reply as direct_reply
    from ev3proto.schema.constructors import system_command as system_command
    from ev3proto.schema.constructors import system_reply as system_reply
    from ev3proto.schema.discovery import Beacon as Beacon
    from ev3proto.schema.discovery import Unlock as Unlock
    from ev3proto.schema.frame import parse as parse
    from ev3proto.schema.instructions import operation as operation
    from ev3proto.schema.names import ADR as ADR
    from ev3proto.schema.names import GVX as GVX
    from ev3proto.schema.names import HND as HND
    from ev3proto.schema.names import LAB1 as LAB1
    from ev3proto.schema.names import LC0 as LC0
    from ev3proto.schema.names import LC1 as LC1
    from ev3proto.schema.names import LC2 as LC2
    from ev3proto.schema.names import LC4 as LC4
    from ev3proto.schema.names import LCF as LCF
    from ev3proto.schema.names import LCS as LCS
    from ev3proto.schema.names import LCX as LCX
    from ev3proto.schema.names import LVX as LVX
    from ev3proto.schema.names import port_motor_input as port_motor_input
    from ev3proto.stream import Decoder as Decoder
    from ev3proto.stream import StreamError as StreamError
    from ev3proto.tables.frame import MessageType as MessageType
    from ev3proto.tables.ports import MotorPort as MotorPort
    from ev3proto.tables.ports import MotorPorts as MotorPorts
    from ev3proto.tables.ports import SensorPort as SensorPort
    from ev3proto.tables.system import SystemStatus as SystemStatus
    from ev3proto.text.fixed_text import FixedText as FixedText
    from ev3proto.text.fixed_text import fix_text as fix_text

__version__ = VERSION

_MODULES = ("capture", "enums", "errors", "messages", "ops", "program", "reading", "schema", "system", "tables")
"""Submodules."""

_NAMES = {
    "ev3proto.checking.checking": ("check",),
    "ev3proto.checking.fixing": ("fix",),
    "ev3proto.checking.report": ("Finding", "Fix", "Report", "Severity"),
    "ev3proto.compose": ("Draft", "Global", "Label", "Local", "command"),
    "ev3proto.dialogue": ("Dialogue", "Exchange", "Transfer", "Value"),
    "ev3proto.errors": ("BuildError", "DecodeError", "Error", "Fault"),
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
    "ev3proto.messages": (
        "GV",
        "LV",
        "Argument",
        "DaisyCommand",
        "DaisyReply",
        "DirectCommand",
        "DirectReply",
        "Message",
        "Operation",
        "SensorReport",
        "SystemCommand",
        "SystemReply",
        "Variable",
    ),
    "ev3proto.reading": ("Image", "Problem", "Record", "Source", "read"),
    "ev3proto.schema.constructors": ("direct_command", "direct_reply", "system_command", "system_reply"),
    "ev3proto.schema.discovery": ("Beacon", "Unlock"),
    "ev3proto.schema.frame": ("parse",),
    "ev3proto.schema.instructions": ("operation",),
    "ev3proto.schema.names": (
        *("ADR", "GVX", "HND", "LAB1", "LC0", "LC1", "LC2", "LC4", "LCF", "LCS", "LCX", "LVX"),
        "port_motor_input",
    ),
    "ev3proto.stream": ("Decoder", "StreamError"),
    "ev3proto.tables.frame": ("MessageType",),
    "ev3proto.tables.ports": ("MotorPort", "MotorPorts", "SensorPort"),
    "ev3proto.tables.system": ("SystemStatus",),
    "ev3proto.text.fixed_text": ("FixedText", "fix_text"),
}
"""All other names, by module."""

_SAID = {"decode": "parse", "encode": "command", "build": "command", "loads": "parse", "Brick": "ev3proto.brick.Brick"}
"""What people look for, and where it is."""

_HOMES = {name: module for module, names in _NAMES.items() for name in names}

__all__ = sorted({*_HOMES, *(each for each in _MODULES if each not in ("errors", "messages", "schema", "tables"))})


def __getattr__(name: str) -> Any:
    """Imports a name on first use; also the constants of the instruction set: `opSound`, `TONE`, `LED_RED`, ..."""
    if name in _MODULES:
        return import_module(f"ev3proto.{name}")
    if name in _HOMES:
        value = globals()[name] = getattr(import_module(_HOMES[name]), name)
        return value
    if name.startswith("__"):
        raise AttributeError(f"module 'ev3proto' has no attribute {name!r}")
    names = import_module("ev3proto.schema.names")
    try:
        return names.constant(name)
    except KeyError:
        near = import_module("ev3proto.errors").near_misses(name, [*__all__, *names.constant_names()])
        hint = f": did you mean {_SAID[name]}?" if name in _SAID else near
        raise AttributeError(f"module 'ev3proto' has no attribute {name!r}{hint}") from None


def __dir__() -> list[str]:
    """Returns the public names and the modules; the constants of the instruction set can be imported all the same."""
    modules = {name for name, value in globals().items() if isinstance(value, ModuleType)}
    return sorted({*(name for name in globals() if name.startswith("__")), *modules, *_MODULES, *__all__})
