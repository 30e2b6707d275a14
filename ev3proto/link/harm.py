"""What a message may do to a brick that outlasts it or moves something, by the effects in the tables.

Who replays a capture or lets strangers at a brick decides by it what to omit.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum

from ev3proto.messages import DaisyCommand, DirectCommand, Message, SystemCommand
from ev3proto.tables.declaration import Effect
from ev3proto.tables.system import SYSTEM_BY_NUMBER


class Harm(StrEnum):
    """A group of effects, as it is named on the command line."""

    MOTORS = "motors"
    FILES = "files"
    DELETES = "deletes"
    SETTINGS = "settings"
    PROGRAMS = "programs"
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
    Harm.MOTORS: "makes motors turn",
    Harm.FILES: "creates or changes files",
    Harm.DELETES: "deletes files or folders",
    Harm.SETTINGS: "changes settings",
    Harm.PROGRAMS: "starts, stops or changes programs",
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
    Effect.WRITES_FILES: Harm.FILES,
    Effect.DELETES_FILES: Harm.DELETES,
    Effect.CHANGES_SETTINGS: Harm.SETTINGS,
    Effect.RENAMES: Harm.SETTINGS,
    Effect.CONTROLS_PROGRAMS: Harm.PROGRAMS,
    Effect.PRESSES_BUTTONS: Harm.BUTTONS,
    Effect.WRITES_TO_DEVICES: Harm.DEVICES,
    Effect.RESTARTS: Harm.RESTARTS,
    Effect.WRITES_FIRMWARE: Harm.FIRMWARE,
    Effect.RUNS_SHELL: Harm.SHELL,
}


def harms_of(message: Message, allowed: frozenset[str] = frozenset()) -> dict[Harm, str]:
    """What a message may do.

    Args:
        message: A message to a brick.
        allowed: Groups, and full names of operations and system commands, that count as harmless.

    Returns:
        Each group once, with the name of the operation or system command that does it first.
    """
    found: dict[Harm, str] = {}
    for name, effects in _entries(message):
        if name not in allowed:
            for effect in effects:
                if effect in _BY_EFFECT:
                    found.setdefault(_BY_EFFECT[effect], name)
    if _is_unread(message):
        found.setdefault(Harm.UNKNOWN, "the frame")
    return {harm: name for harm, name in found.items() if harm not in allowed}


def _entries(message: Message) -> Iterable[tuple[str, tuple[Effect, ...]]]:
    if isinstance(message, DirectCommand | DaisyCommand):
        for operation in message.operations:
            yield operation.full_name, operation.declaration.effects
    elif isinstance(message, SystemCommand) and message.number in SYSTEM_BY_NUMBER:
        entry = SYSTEM_BY_NUMBER[message.number]
        yield entry.name, entry.effects


def _is_unread(message: Message) -> bool:
    """Whether a message has anything of which nobody knows what it does."""
    if isinstance(message, DaisyCommand):
        return not message.operations
    if isinstance(message, SystemCommand) and message.number not in SYSTEM_BY_NUMBER:
        return True
    return message.type is None or message.fault is not None
