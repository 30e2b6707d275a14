"""What a message may do to a brick that outlasts it or moves something, by the effects in the tables.

Who replays a capture or lets strangers at a brick decides by it what to omit.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import StrEnum

from ev3proto.checking.verdict import operation_offsets, verdict
from ev3proto.messages import Argument, DaisyCommand, DirectCommand, Message, Operation, SystemCommand
from ev3proto.schema.header import COMMAND_HEADER_SIZE
from ev3proto.semantics.footprint import Footprint, footprints, whole_number
from ev3proto.tables.declaration import Effect, Role
from ev3proto.tables.encoding import CONSTANT, JUMP, TEXT
from ev3proto.tables.frame import GRANTED_GLOBALS, MAX_LOCALS
from ev3proto.tables.system import SYSTEM_BY_NUMBER
from ev3proto.tables.validation import LABELS


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
    """Returns whether anything in a message may run that its operations do not show."""
    if isinstance(message, DaisyCommand):
        return not message.operations or _has_hidden_code(message.operations)
    if isinstance(message, DirectCommand) and (_has_hidden_code(message.operations) or _reads_otherwise(message)):
        return True
    if isinstance(message, SystemCommand) and message.number not in SYSTEM_BY_NUMBER:
        return True
    return message.type is None or message.fault is not None


def _has_hidden_code(operations: Sequence[Operation]) -> bool:
    """Returns whether code may run that is no operation of the list: by a jump into one, or by one that rewrites code.

    A jump by a variable may lead anywhere. A text stands in the code, so what is written to it is code as well; and
    code is in the same memory as variables, of which the firmware checks no index.
    """
    starts = {operation.offset for operation in operations}
    ends = {operation.offset + operation.length for operation in operations}
    labels = {
        whole_number(argument)
        for operation in operations
        for argument in operation.arguments
        if argument.parameter.role is Role.LABEL
    }
    for operation in operations:
        for argument in operation.arguments:
            parameter = argument.parameter
            if parameter.role is Role.JUMP:
                if not _leads_to(argument, operation.offset + operation.length, starts | ends, labels):
                    return True
            elif (parameter.is_output or parameter.stores) and (argument.kind == TEXT or argument.form.address):
                return True
        if any(place.is_written and _is_beyond(place) for place in footprints(operation)):
            return True
    return False


def _reads_otherwise(message: DirectCommand) -> bool:
    """Returns whether older firmware takes a command and sees other operations in it.

    It does not know some CMDs, and runs what should be their arguments.
    """
    frame = message.build()
    if not verdict(frame).accepted:
        return False
    seen = [COMMAND_HEADER_SIZE + offset for offset in operation_offsets(frame[COMMAND_HEADER_SIZE:])]
    return seen != [operation.offset for operation in message.operations]


def _is_beyond(place: Footprint) -> bool:
    """Returns whether an operation may write outside the memory that every direct command has."""
    is_anywhere = place.argument.parameter.stores and place.is_open
    return is_anywhere or place.end > (GRANTED_GLOBALS if place.is_global else MAX_LOCALS)


def _leads_to(jump: Argument, after: int, places: set[int], labels: set[int | None]) -> bool:
    """Returns whether a jump surely leads to one of some places, counted from `after`, or to one of some labels."""
    form, value = jump.form, jump.value
    if form.handle or form.address or not isinstance(value, int) or form.kind not in (CONSTANT, JUMP):
        return False
    if form.kind == JUMP and 0 < value < LABELS:
        return value in labels
    return after + value in places
