"""The list of what only reads, by what the tables declare; everything else is refused with the name of the culprit.

An operation passes if its effect is to read, every input is a constant, and every output a variable within the memory
that the command requests.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from ev3proto.messages import Argument, DaisyCommand, DirectCommand, Message, Operation, SystemCommand
from ev3proto.schema.frame import parse
from ev3proto.schema.header import MOST_IN_REPLY
from ev3proto.semantics.facts import facts_of
from ev3proto.semantics.footprint import footprint, whole_number
from ev3proto.semantics.judgement import judged
from ev3proto.semantics.transfers import LISTINGS
from ev3proto.tables.declaration import Effect, Type
from ev3proto.tables.encoding import CONSTANT, GLOBAL, LOCAL, STRING_CODING, TEXT, limits_of
from ev3proto.tables.enumerations import TYPE
from ev3proto.tables.frame import MAX_FRAME, MAX_LOCALS
from ev3proto.tables.input import MOST_WAITS
from ev3proto.tables.paths import is_allowed
from ev3proto.tables.system import SYSTEM_BY_NUMBER

_LONGEST_TEXT = 127
"""Bytes of the longest text that an operation returns; the firmware reads its length as a signed byte."""

_SILENT = " without a reply"
_OWN = re.compile(rb"(?=.{1,100}\Z)(\.\.|/home/root/lms2012)(/(?!\.{1,2}(/|\Z))[\w.~ -]+)*/?", re.ASCII)
"""A path below /home/root/lms2012 in one of two spellings, without `.`, `..` and empty names."""


class Blame(NamedTuple):
    """An operation or a system command that does more than read, or the frame, which may do anything."""

    name: str
    effects: tuple[Effect, ...] = ()
    detail: str = ""  # words after its name: the argument, or what is missing


_FRAME = Blame("the frame")


def blamed(message: Message) -> Iterator[Blame]:
    """Yields what a message does besides reading; nothing if, sent by `with_types_kept`, it only reads."""
    if isinstance(message, SystemCommand) and message.fault is None and message.number in SYSTEM_BY_NUMBER:
        yield from _in_system(message)
    elif isinstance(message, DirectCommand) and message.fault is None:
        yield from _in_direct(message)
    else:
        yield _FRAME
        operations = message.operations if isinstance(message, DirectCommand | DaisyCommand) else ()
        yield from (Blame(*each) for each in _does(operations) if Effect.READS not in each[1])


def _does(operations: Iterable[Operation]) -> Iterator[tuple[str, tuple[Effect, ...]]]:
    return ((one.full_name, one.declaration.effects) for one in operations)


def _in_system(command: SystemCommand) -> Iterator[Blame]:
    entry, path = SYSTEM_BY_NUMBER[command.number], str(command.fields.get("path", "")).encode(STRING_CODING)
    if Effect.READS not in entry.effects:
        yield Blame(entry.name, entry.effects)
    elif "path" in command.fields and not (is_own(path) and (entry.name in LISTINGS or is_allowed(path))):
        yield Blame(entry.name, entry.effects, " with this path")
    elif not command.wants_reply:
        yield Blame(entry.name, entry.effects, _SILENT)


def _in_direct(command: DirectCommand) -> Iterator[Blame]:
    operations = command.operations
    memory = {GLOBAL: command.global_size, LOCAL: command.local_size}
    is_whole = bool(operations) and operations[-1].offset + operations[-1].length <= MAX_FRAME
    if not is_whole or memory[GLOBAL] > MOST_IN_REPLY or memory[LOCAL] > MAX_LOCALS:
        yield _FRAME
    is_fine, waits = True, 0
    for operation, does in zip(operations, _does(operations), strict=True):
        waits += Effect.WAITS in operation.declaration.effects
        detail = _beyond(operation, memory) if waits <= MOST_WAITS else f" after {MOST_WAITS} others that wait"
        if detail is not None:
            is_fine = False
            yield Blame(*does, detail)
    if is_fine and operations and not command.wants_reply:
        # Nothing would tell when it has ended, nor how long it keeps others waiting.
        yield Blame(*next(_does(operations)), _SILENT)


def _beyond(operation: Operation, memory: dict[str, int]) -> str | None:
    """Returns words on the argument for which an operation does more than read; None if it only reads."""
    cmd = operation.cmd
    if Effect.READS not in operation.declaration.effects or operation.declaration.is_newer:
        return ""
    if cmd is not None and (cmd.form.handle or cmd.form.address):
        return " with this CMD"
    for number, argument in enumerate(operation.arguments):
        if not _is_fine(argument, number, operation, memory):
            return f" with {argument.name}" + (f" {argument.value}" if argument.kind == CONSTANT else "")
    return None


def _is_fine(argument: Argument, number: int, operation: Operation, memory: dict[str, int]) -> bool:
    parameter, form = argument.parameter, argument.form
    if form.handle or form.address or parameter.type in (Type.HANDLE, Type.LABEL):
        return False
    if parameter.is_output or parameter.stores:
        return argument.is_variable and _has_room(number, operation, memory[argument.kind])
    if parameter.type is Type.STRING:
        return argument.kind == TEXT and is_own(argument.raw[1:-1]) and is_allowed(argument.raw[1:-1])
    return _is_fine_number(argument, operation)


def _is_fine_number(argument: Argument, operation: Operation) -> bool:
    parameter, given = argument.parameter, whole_number(argument)
    if parameter.enum is TYPE:
        # Whatever it is, `with_types_kept` replaces it.
        return given is not None
    if parameter.length is not None or parameter.indexed_by is not None or argument.kind != CONSTANT:
        return False
    tail, limits = operation.declaration.tail, limits_of(parameter)
    if tail is not None and parameter is tail.counter:
        return given is not None and limits is not None and 0 <= given <= limits.high
    return judged(facts_of(parameter), argument) is None


def _has_room(number: int, operation: Operation, memory: int) -> bool:
    place, parameter = footprint(operation, number, operation.arguments), operation.arguments[number].parameter
    if isinstance(parameter.length, str) and parameter.type is Type.STRING:
        length = whole_number(next((one for one in operation.arguments if one.name == parameter.length), None))
        if length is None or not 0 < length <= _LONGEST_TEXT:
            return False
    return place.most is not None and place.start + max(place.most, parameter.most or 0) <= memory


def with_types_kept(command: DirectCommand) -> DirectCommand:
    """Returns a command that reads whatever is at a port: a type resets the port of another device, 0 keeps it."""
    frame = bytearray(command.build())
    for argument in (one for operation in command.operations for one in operation.arguments):
        if argument.parameter.enum is TYPE and not argument.parameter.is_output and whole_number(argument):
            raw = argument.raw[:1] if argument.form.width else b""
            frame[argument.offset : argument.offset + argument.length] = raw.ljust(argument.length, b"\0")
    kept = parse(bytes(frame), strict=False)
    return kept if isinstance(kept, DirectCommand) else command


def is_own(path: bytes) -> bool:
    """Returns whether a path is below /home/root/lms2012 however a file system reads it, and short."""
    return _OWN.fullmatch(path) is not None
