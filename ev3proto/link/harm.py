"""What a message may do to a brick that outlasts it or moves something, by the effects in the tables.

Replays, and proxies for untrusted clients, decide by it what to omit.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum

from ev3proto.checking.verdict import operation_offsets, verdict
from ev3proto.messages import DaisyCommand, DirectCommand, Message, Operation, SystemCommand
from ev3proto.schema.header import COMMAND_HEADER_SIZE
from ev3proto.semantics.flow import flow_of
from ev3proto.semantics.footprint import Footprint, footprints
from ev3proto.tables.declaration import Effect
from ev3proto.tables.encoding import TEXT
from ev3proto.tables.frame import GRANTED_GLOBALS, MAX_LOCALS
from ev3proto.tables.system import SYSTEM_BY_NUMBER


class Harm(StrEnum):
    """A group of effects, as it is named on the command line."""

    MOTORS = "motors"
    FILES = "files"
    DELETES = "deletes"
    SETTINGS = "settings"
    PROGRAMS = "programs"
    MESSAGES = "messages"
    BUTTONS = "buttons"
    DEVICES = "devices"
    RESTARTS = "restarts"
    FIRMWARE = "firmware"
    SHELL = "shell"
    UNKNOWN = "unknown"

    @property
    def text(self) -> str:
        """What it is, completing "it ..."."""
        return _TEXTS[self]


_TEXTS = {
    Harm.MOTORS: "makes motors turn or stop",
    Harm.FILES: "creates or changes files",
    Harm.DELETES: "deletes files or folders",
    Harm.SETTINGS: "changes settings",
    Harm.PROGRAMS: "starts, stops or changes programs",
    Harm.MESSAGES: "sends messages to programs",
    Harm.BUTTONS: "presses buttons",
    Harm.DEVICES: "writes to sensors or circuits",
    Harm.RESTARTS: "restarts the brick",
    Harm.FIRMWARE: "erases or writes firmware",
    Harm.SHELL: "runs a command on the brick's operating system",
    Harm.UNKNOWN: "does what is not known, because not all of it can be read",
}

_BY_EFFECT = {
    Effect.RUNS_MOTORS: Harm.MOTORS,
    Effect.STARTS_MOVE: Harm.MOTORS,
    Effect.SETS_MOTORS: Harm.MOTORS,
    Effect.STOPS_MOTORS: Harm.MOTORS,
    Effect.WRITES_FILES: Harm.FILES,
    Effect.DELETES_FILES: Harm.DELETES,
    Effect.CHANGES_SETTINGS: Harm.SETTINGS,
    Effect.RENAMES: Harm.SETTINGS,
    Effect.CONTROLS_PROGRAMS: Harm.PROGRAMS,
    Effect.SENDS_MESSAGES: Harm.MESSAGES,
    Effect.PRESSES_BUTTONS: Harm.BUTTONS,
    Effect.WRITES_TO_DEVICES: Harm.DEVICES,
    Effect.RESTARTS: Harm.RESTARTS,
    Effect.WRITES_FIRMWARE: Harm.FIRMWARE,
    Effect.RUNS_SHELL: Harm.SHELL,
}


def harms_of(message: Message, allowed: frozenset[str] = frozenset(), dialect: str = "official") -> dict[Harm, str]:
    """Returns what a message may do.

    Args:
        message: A message to a brick.
        allowed: Groups, and full names of operations and system commands, that count as harmless.
        dialect: The firmware whose instruction set to read hidden code by.

    Returns:
        Each group once, with the name of the operation or system command that does it first.
    """
    found: dict[Harm, str] = {}
    is_unread = message.type is None or message.fault is not None
    entries: list[tuple[str, tuple[Effect, ...]]] = []
    if isinstance(message, DirectCommand | DaisyCommand):
        operations, is_known = running(message, dialect)
        entries = [(operation.full_name, operation.declaration.effects) for operation in operations]
        is_unread = is_unread or not is_known
    elif isinstance(message, SystemCommand):
        entry = SYSTEM_BY_NUMBER.get(message.number)
        entries = [] if entry is None else [(entry.name, entry.effects)]
        is_unread = is_unread or entry is None
    # Of several effects of a group, the gravest comes first.
    for effect, harm in _BY_EFFECT.items():
        names = (name for name, effects in entries if effect in effects and name not in allowed)
        if harm not in found and (name := next(names, None)) is not None:
            found[harm] = name
    if is_unread:
        found.setdefault(Harm.UNKNOWN, "the frame")
    return {harm: name for harm, name in found.items() if harm not in allowed}


def running(message: DirectCommand | DaisyCommand, dialect: str) -> tuple[Iterable[Operation], bool]:
    """Returns the operations of a command that can run, and whether the list is known to be complete.

    Args:
        message: The command.
        dialect: The firmware whose instruction set to read hidden code by.
    """
    operations = message.operations
    if not operations or message.fault is not None:
        return operations, isinstance(message, DirectCommand)
    frame = message.build()
    flow = flow_of(frame, operations, operations[0].offset, len(frame), dialect)
    can_run = [operation for _, operation in sorted(flow.operations.items())]
    is_known = flow.is_known and not any(map(_may_rewrite_code, can_run))
    return can_run, is_known and not (isinstance(message, DirectCommand) and _reads_otherwise(message, frame))


def _may_rewrite_code(operation: Operation) -> bool:
    """Returns whether an operation may write code that runs later.

    A text is in the code. So are variables outside the memory: the firmware does not check their index.
    """
    for argument in operation.arguments:
        parameter = argument.parameter
        if (parameter.is_output or parameter.stores) and (argument.kind == TEXT or argument.form.address):
            return True
    return any(place.is_written and _is_beyond(place) for place in footprints(operation))


def _is_beyond(place: Footprint) -> bool:
    """Returns whether an operation may write outside the memory that every direct command has."""
    is_anywhere = place.argument.parameter.stores and place.is_open
    return is_anywhere or place.end > (GRANTED_GLOBALS if place.is_global else MAX_LOCALS)


def _reads_otherwise(message: DirectCommand, frame: bytes) -> bool:
    """Returns whether older firmware takes a command and sees other operations in it.

    It does not know some CMDs, and runs what should be their arguments.
    """
    if not verdict(frame).accepted:
        return False
    seen = [COMMAND_HEADER_SIZE + offset for offset in operation_offsets(frame[COMMAND_HEADER_SIZE:])]
    return seen != [operation.offset for operation in message.operations]
