"""The effects of a message on a brick besides reading: a list of what is harmless, by the facts in the tables.

A proxy for untrusted clients forwards only what is on the list. A replay also sends what `--allow` names, by group.
"""

from __future__ import annotations

import math
import re
from collections.abc import Container, Sequence
from enum import StrEnum

from ev3proto.messages import Argument, DaisyCommand, DirectCommand, Message, Operation, SystemCommand
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.semantics.domain import domain_of
from ev3proto.semantics.facts import UNTYPED_SIZE
from ev3proto.semantics.footprint import Footprint, footprints, whole_number
from ev3proto.tables.declaration import Effect, Role, Type
from ev3proto.tables.encoding import CONSTANT, GLOBAL, JUMP, LOCAL, TEXT, limits_of
from ev3proto.tables.frame import GRANTED_GLOBALS, MAX_FRAME, MAX_LOCALS
from ev3proto.tables.paths import WHOLE, is_allowed
from ev3proto.tables.system import SYSTEM_BY_NUMBER
from ev3proto.tables.validation import LABELS


class Harm(StrEnum):
    """A group of effects, as it is named on the command line."""

    text: str  # a description that completes "it ..."
    effects: tuple[Effect, ...]  # the most serious first

    def __new__(cls, name: str, text: str, *effects: Effect) -> Harm:
        """Creates a group from its name, text and effects."""
        harm = str.__new__(cls, name)
        harm._value_ = name
        harm.text, harm.effects = text, effects
        return harm

    MOTORS = (
        "motors",
        "makes motors turn or stop",
        Effect.RUNS_MOTORS,
        Effect.STARTS_MOVE,
        Effect.SETS_MOTORS,
        Effect.STOPS_MOTORS,
    )
    FILES = "files", "creates or changes files", Effect.WRITES_FILES
    DELETES = "deletes", "deletes files or folders", Effect.DELETES_FILES
    SETTINGS = "settings", "changes settings", Effect.CHANGES_SETTINGS, Effect.RENAMES
    PROGRAMS = "programs", "starts, stops or changes programs", Effect.CONTROLS_PROGRAMS, Effect.OF_PROGRAMS
    MESSAGES = "messages", "uses the mailboxes of programs", Effect.SENDS_MESSAGES, Effect.USES_MAILBOXES
    BUTTONS = "buttons", "presses buttons", Effect.PRESSES_BUTTONS
    DEVICES = "devices", "writes to sensors or circuits", Effect.WRITES_TO_DEVICES, Effect.RESETS_SENSORS
    SOUNDS = "sounds", "starts or ends a sound", Effect.STARTS_SOUND, Effect.ENDS_SOUND
    DISPLAY = (
        "display",
        "changes what the display or the terminal shows",
        Effect.DIALOG,
        Effect.SHOWS,
        Effect.WIPES,
        Effect.DRAWS,
        Effect.PRINTS,
    )
    LIGHTS = "lights", "changes the lights, or plays a signal", Effect.SIGNALS
    RESTARTS = "restarts", "restarts the brick", Effect.RESTARTS
    FIRMWARE = "firmware", "erases or writes firmware", Effect.WRITES_FIRMWARE
    SHELL = "shell", "runs a command on the brick's operating system", Effect.RUNS_SHELL
    COMPUTING = "computing", "does more than read, such as computing, jumping or waiting", Effect.COMPUTES
    UNKNOWN = "unknown", "may do anything"


_GROUPED = frozenset(effect for harm in Harm for effect in harm.effects)

_Memory = dict[str, int]
"""Bytes of global and of local memory."""

_GRANTED: _Memory = {GLOBAL: GRANTED_GLOBALS, LOCAL: MAX_LOCALS}
"""The memory that every direct command has, whatever it requests."""

_MOST_REPLIED = MAX_FRAME - HEADER_SIZE
"""Bytes of global memory that fit into a reply."""

_MOST_WAITS = 16
"""Maximum number of operations in a command that may wait for a sensor, each for 1.2 s at most."""

_LONGEST_TEXT = 127
"""Bytes of the longest text that an operation returns; the firmware reads its length as a signed byte."""

_NUMBER_TEXT = 129
"""Bytes of the longest text of a number, and more than any other text that STRINGS adds to those it is given."""

_FORMAT = re.compile(r"[^%]*%[-+ #0]*\d{0,2}(\.\d{0,2})?[acdefgiouxAEFGX][^%]*")
"""A format of C's printf that reads one number and writes only the text."""

_Found = tuple[list[tuple[str, tuple[Effect, ...]]], list[str]]
"""The effects of operations and system commands, by name, and the names of those that may do anything."""


def harms_of(message: Message, allowed: Container[str] = (), handles: Container[int] = ()) -> dict[Harm, str]:
    """Returns what a message may do besides reading: each group with the first operation that does it.

    `allowed` has groups and full names; `handles` has those of files that the sender opened, and may read and close.
    """
    if isinstance(message, DirectCommand) and message.fault is None:
        effects, unknown = _of_direct(message)
    elif isinstance(message, SystemCommand) and message.fault is None:
        effects, unknown = _of_system(message, handles)
    else:
        operations = message.operations if isinstance(message, DirectCommand | DaisyCommand) else ()
        effects, unknown = [(one.full_name, one.declaration.effects) for one in operations], ["the frame"]
    found: dict[Harm, str] = {}
    for harm in Harm:
        names = (name for effect in harm.effects for name, has in effects if effect in has and name not in allowed)
        name = next(names, None)
        if name is not None and harm not in allowed:
            found[harm] = name
    if unknown and Harm.UNKNOWN not in allowed:
        found[Harm.UNKNOWN] = unknown[0]
    return found


def _of_system(command: SystemCommand, handles: Container[int]) -> _Found:
    entry = SYSTEM_BY_NUMBER.get(command.number)
    if entry is None:
        return [], ["the frame"]
    effects, path, handle = entry.effects, command.fields.get("path", ""), command.fields.get("handle")
    if Effect.READS in effects and handle is not None and handle not in handles:
        # The firmware does not check whose file it is: another client could lose the file, or its position in it.
        effects = (Effect.COMPUTES,)
    return [(entry.name, effects)], [entry.name] if isinstance(path, str) and len(path) >= WHOLE else []


def _of_direct(command: DirectCommand) -> _Found:
    operations = command.operations
    requested = {GLOBAL: command.global_size, LOCAL: command.local_size}
    effects_of, unknown = [], [] if operations and command.global_size <= _MOST_REPLIED else ["the frame"]
    targets, files = _targets(operations), _files(operations)
    waits = 0
    for operation in operations:
        effects, places = operation.declaration.effects, footprints(operation)
        if Effect.READS in effects:
            waits += Effect.WAITS in effects
            if waits <= _MOST_WAITS and _only_reads(operation, places, requested, files):
                continue
            effects = (Effect.COMPUTES,)
        effects_of.append((operation.full_name, effects))
        if _GROUPED.isdisjoint(effects) or not _is_bounded(operation, places, _GRANTED, targets):
            unknown.append(operation.full_name)
    return effects_of, unknown


def _only_reads(
    operation: Operation, places: Sequence[Footprint], requested: _Memory, files: Container[object]
) -> bool:
    """Returns whether an operation that is declared as reading does nothing else with these arguments."""
    return (
        _is_bounded(operation, places, requested)
        and all(_end(place) <= _GRANTED[place.argument.kind] for place in places)
        and all(_is_expected(argument, files) for argument in operation.arguments)
    )


def _is_expected(argument: Argument, files: Container[object]) -> bool:
    """Returns whether an argument is an output, a legal constant, or a variable that may have any value."""
    parameter = argument.parameter
    if argument.form.handle or argument.kind == JUMP:
        return False
    if parameter.is_output or parameter.stores:
        return True
    if parameter.type is Type.HANDLE:
        return (argument.kind, argument.value) in files
    if parameter.type is Type.STRING:
        # The firmware never stops trying to open a forbidden name.
        return argument.kind == TEXT and parameter.most == WHOLE and is_allowed(argument.raw[1:-1])
    if argument.is_variable:
        return parameter.range is None
    domain = domain_of(parameter)
    return argument.kind == CONSTANT and (domain is None or domain.covers(float(argument.value)))


def _is_bounded(
    operation: Operation, places: Sequence[Footprint], memory: _Memory, targets: Container[object] = ()
) -> bool:
    """Returns whether every brick reads an operation in the same way, and it writes and jumps only where it may."""
    # Older firmware takes the arguments of an unknown CMD for operations. A count in a variable is its index when the
    # firmware checks a command, and its value when it runs it.
    declaration, cmd = operation.declaration, operation.cmd
    texts = {one.length for one in declaration.parameters if one.is_output and one.type is Type.STRING}
    if declaration.is_newer or (cmd is not None and (cmd.form.handle or cmd.form.address)):
        return False
    for argument in operation.arguments:
        parameter, form, number = argument.parameter, argument.form, whole_number(argument)
        if form.address or ((parameter.is_output or parameter.stores) and (form.handle or not argument.is_variable)):
            return False
        if parameter.role is Role.JUMP:
            is_fine = (form.kind, number if number is None else operation.offset + operation.length + number) in targets
            is_fine = (JUMP, argument.value) in targets if form.kind == JUMP else is_fine
        elif declaration.tail is not None and parameter is declaration.tail.counter:
            limits = limits_of(parameter)
            is_fine = number is not None and limits is not None and 0 <= number <= limits.high
        elif parameter.name in texts:
            is_fine = number is not None and 0 < number <= _LONGEST_TEXT
        elif parameter.role is Role.FORMAT:
            is_fine = form.kind == TEXT and _FORMAT.fullmatch(str(argument.value)) is not None
        else:
            is_fine = form.kind != JUMP or parameter.role is Role.LABEL
        if not is_fine:
            return False
    return all(_end(place) <= memory[place.argument.kind] for place in places if place.facts.is_written)


def _end(place: Footprint) -> float:
    """Returns the end of the memory that an operation may use through an argument."""
    if place.most is not None:
        return place.start + place.most
    parameter = place.argument.parameter
    if parameter.type is Type.ARRAY_TYPED and parameter.length is None:
        return place.start + UNTYPED_SIZE
    texts = [
        one for one in place.operation.arguments if one.parameter.type is Type.STRING and not one.parameter.is_output
    ]
    if parameter.type is not Type.STRING or parameter.length is not None or any(one.kind != TEXT for one in texts):
        return math.inf
    return place.start + _NUMBER_TEXT + sum(one.length for one in texts)


def _files(operations: Sequence[Operation]) -> frozenset[object]:
    """Returns the variables into which a command writes handles."""
    arguments = (argument for operation in operations for argument in operation.arguments)
    return frozenset(
        (one.kind, one.value) for one in arguments if one.parameter.type is Type.HANDLE and one.parameter.is_output
    )


def _targets(operations: Sequence[Operation]) -> frozenset[object]:
    """Returns the allowed targets of jumps: the offsets of operations and of the end, and labels."""
    arguments = (argument for operation in operations for argument in operation.arguments)
    labels = {whole_number(one) for one in arguments if one.parameter.role is Role.LABEL}
    return frozenset(
        [(CONSTANT, at) for one in operations for at in (one.offset, one.offset + one.length)]
        + [(JUMP, number) for number in range(1, LABELS) if number in labels]
    )
