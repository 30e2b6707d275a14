"""The effects of a message on a brick besides reading: a list of what is harmless, by the facts in the tables.

A proxy for untrusted clients forwards only what is on the list. A replay also sends what `--allow` names, by group.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Mapping
from enum import StrEnum
from typing import NamedTuple

from ev3proto.link.arguments import GRANTED, References, changing_argument, is_bounded, only_reads
from ev3proto.link.known import NOTHING, Known
from ev3proto.link.transfers import NO_TRANSFERS, is_listing, is_of
from ev3proto.messages import DaisyCommand, DirectCommand, Message, Operation, SystemCommand
from ev3proto.schema.header import MOST_IN_REPLY
from ev3proto.tables.declaration import Effect
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.tables.paths import WHOLE, is_allowed
from ev3proto.tables.reading import ReadOnly, is_own, reading_of
from ev3proto.tables.system import SYSTEM_BY_NUMBER, SystemDeclaration


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


class _Doing(NamedTuple):
    """What an operation or a system command does."""

    name: str
    effects: tuple[Effect, ...]
    detail: str = ""  # words after its name: the argument that is to blame


_Found = tuple[list[_Doing], list[str]]
"""What a message does, and the names of the operations that may do anything."""


def harms_of(
    message: Message,
    allowed: Container[str] = (),
    handles: Mapping[int, str] = NO_TRANSFERS,
    known: Known = NOTHING,
) -> dict[Harm, str]:
    """Returns what a message may do besides reading: each group with the first operation that does it.

    Args:
        message: A command.
        allowed: Groups and full names.
        handles: The files and listings that the sender has opened: for each handle the command that began it.
        known: What the brick has answered about its ports and files.
    """
    does, unknown = _done_by(message, handles, known)
    found: dict[Harm, str] = {}
    for harm in Harm:
        named = (one for effect in harm.effects for one in does if effect in one.effects and one.name not in allowed)
        first = next(named, None)
        if first is not None and harm not in allowed:
            found[harm] = first.name + first.detail
    if unknown and Harm.UNKNOWN not in allowed:
        found[Harm.UNKNOWN] = unknown[0]
    return found


def _done_by(message: Message, handles: Mapping[int, str], known: Known) -> _Found:
    if isinstance(message, DirectCommand) and message.fault is None:
        return _of_direct(message, known)
    if isinstance(message, SystemCommand) and message.fault is None:
        return _of_system(message, handles)
    operations = message.operations if isinstance(message, DirectCommand | DaisyCommand) else ()
    return [_Doing(one.full_name, one.declaration.effects) for one in operations], ["the frame"]


def _of_system(command: SystemCommand, handles: Mapping[int, str]) -> _Found:
    entry = SYSTEM_BY_NUMBER.get(command.number)
    if entry is None:
        return [], ["the frame"]
    effects, path = entry.effects, str(command.fields.get("path", "")).encode(STRING_CODING)
    is_fine = entry.transfer in (None, "begin") or is_of(entry, command.fields.get("handle"), handles)
    if not is_fine or (Effect.READS in effects and not _is_reading(command, entry, path)):
        effects = (*(one for one in effects if one is not Effect.READS), Effect.COMPUTES)
    return [_Doing(entry.name, effects)], [entry.name] if len(path) >= WHOLE else []


def _is_reading(command: SystemCommand, entry: SystemDeclaration, path: bytes) -> bool:
    """Returns whether a command that reads has a path that may be read, and its handle will be known."""
    # The handle of a file that is opened without a reply is unknown, so it would stay open.
    is_allowed_path = is_own(path) and (is_listing(entry.name) or is_allowed(path))
    return command.wants_reply and (entry.transfer != "begin" or is_allowed_path)


def _of_direct(command: DirectCommand, known: Known) -> _Found:
    code = References(command)
    operations = code.operations
    is_whole = bool(operations) and operations[-1].offset + operations[-1].length <= MAX_FRAME
    does: list[_Doing] = []
    unknown = [] if is_whole and command.global_size <= MOST_IN_REPLY else ["the frame"]
    counts: Counter[str] = Counter()
    for operation in operations:
        doing = _of_operation(operation, code, counts, known)
        if doing is None:
            continue
        does.append(doing)
        if _GROUPED.isdisjoint(doing.effects) or not is_bounded(operation, code, GRANTED):
            unknown.append(operation.full_name)
    if operations and not does and not command.wants_reply:
        # Nothing would tell when it has ended, nor how long it keeps others waiting.
        does.append(_Doing(f"{operations[0].full_name} without a reply", (Effect.COMPUTES,)))
    return does, unknown


def _of_operation(operation: Operation, code: References, counts: Counter[str], known: Known) -> _Doing | None:
    """Returns what an operation does; None if it only reads."""
    effects = operation.declaration.effects
    if Effect.READS not in effects:
        return _Doing(operation.full_name, effects)
    row = reading_of(operation.full_name)
    if row is not None and _is_one_of_few(row, counts) and only_reads(operation, row, code, known):
        return None
    return _Doing(operation.full_name, (Effect.COMPUTES,), changing_argument(operation, code, known))


def _is_one_of_few(row: ReadOnly, counts: Counter[str]) -> bool:
    """Counts an operation. Returns whether a command may have that number of them."""
    counts[row.names] += 1
    return row.most is None or counts[row.names] <= row.most
