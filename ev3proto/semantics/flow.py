"""Control flow: which operations can run, starting at the first one and following every jump.

A jump into an operation runs the bytes there, so they are read there. A jump by a value outside the code may lead
anywhere, and a jump out of the code runs unknown bytes: then it is unknown what can run.
"""

from __future__ import annotations

from array import array
from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from ev3proto.messages import Argument, Operation
from ev3proto.schema.instructions import instruction_set
from ev3proto.semantics.footprint import whole_number
from ev3proto.tables.declaration import Effect, Role
from ev3proto.tables.encoding import JUMP
from ev3proto.tables.validation import LABELS

_FIRST_WINDOW, _GROWTH = 32, 8
"""Bytes in which an operation is looked for first, since jumps may lead into many places; the factor of the next."""


@dataclass(slots=True)
class Flow:
    """The operations that can run."""

    # by offset, including those found by jumps into others
    operations: dict[int, Operation] = field(default_factory=dict)
    # the offsets at which each of them continues; the end of the code if it ends
    following: dict[int, list[int]] = field(default_factory=dict)
    is_known: bool = True  # whether these are all that can run


def jump_of(operation: Operation) -> Argument | None:
    """Returns the argument with the target of a jump; None for other operations, and for one that is cut off."""
    if not operation.declaration.is_jump:
        return None
    arguments = operation.arguments
    return arguments[-1] if arguments and arguments[-1].parameter.role is Role.JUMP else None


def is_label(jump: Argument) -> bool:
    """Returns whether a jump names a label; other numbers in this encoding are distances."""
    return jump.form.kind == JUMP and isinstance(jump.value, int) and 0 < jump.value < LABELS


def labels_of(operations: Sequence[Operation]) -> dict[int | None, int]:
    """Returns the offsets of labels, after LABEL; of several with one number, the last counts."""
    return {
        whole_number(argument): operation.offset + operation.length
        for operation in operations
        for argument in operation.arguments
        if argument.parameter.role is Role.LABEL
    }


def target_of(operation: Operation, jump: Argument, labels: dict[int | None, int]) -> int | None:
    """Returns the offset that a jump leads to; None for a variable, a handle, an address, a missing label."""
    if jump.form.handle or jump.form.address or jump.is_variable or not isinstance(jump.value, int):
        return None
    if is_label(jump):
        return labels.get(jump.value)
    return operation.offset + operation.length + jump.value


class Step(NamedTuple):
    """An operation that can run."""

    operation: Operation  # the operation, which may be inside another one
    following: list[int]  # the offsets at which it continues; the end of the code if it ends
    is_known: bool  # whether these are all


def steps_of(data: bytes, operations: Sequence[Operation], start: int, end: int, dialect: str) -> Iterator[Step | None]:
    """Yields each operation that can run, once; None for a place that can run, but has no code that can be read.

    Takes some bytes of memory for each byte of code.
    """
    starts, labels = starts_of(operations), labels_of(operations)
    seen = bytearray(end - start)
    inside: dict[int, Operation] = {}
    waiting = [start]
    while waiting:
        at = waiting.pop()
        is_code = start <= at < end
        if at == end or (is_code and seen[at - start]):
            continue
        place = place_of(at, starts)
        operation = None if place is None else operations[place]
        if is_code and (operation is None or not operation.is_complete):
            if at not in inside:
                inside = _read(data, at, end, dialect)
            operation = inside.get(at)
        if operation is None:
            yield None
            continue
        if is_code:
            seen[at - start] = 1
        step = _step(operation, labels, end)
        yield step
        # What follows in the row is next: that is read fastest.
        waiting += reversed(step.following)


def _step(operation: Operation, labels: dict[int | None, int], end: int) -> Step:
    following = _following(operation, end)
    jump = jump_of(operation)
    target = None if jump is None else target_of(operation, jump, labels)
    if target is not None:
        following.append(target)
    return Step(operation, following, jump is None or target is not None)


def starts_of(operations: Sequence[Operation]) -> Sequence[int]:
    """Returns the offsets of operations, in ascending order."""
    return array("I", (operation.offset for operation in operations))


def place_of(offset: int, starts: Sequence[int]) -> int | None:
    """Returns the number of the operation that starts at an offset, or None."""
    place = bisect_left(starts, offset)
    return place if place < len(starts) and starts[place] == offset else None


def flow_of(data: bytes, operations: Sequence[Operation], start: int, end: int, dialect: str) -> Flow:
    """Returns the operations that can run; arguments as for `steps_of`."""
    flow = Flow()
    for step in steps_of(data, operations, start, end, dialect):
        if step is None:
            flow.is_known = False
            continue
        flow.operations[step.operation.offset] = step.operation
        flow.following[step.operation.offset] = step.following
        flow.is_known &= step.is_known
    return flow


def runs_of(data: bytes, operations: Sequence[Operation], end: int, dialect: str) -> bytearray | None:
    """Returns 1 for each operation that can run or contains code that can, else 0; None if that is unknown."""
    starts = starts_of(operations)
    runs = bytearray(len(starts))
    for step in steps_of(data, operations, starts[0], end, dialect):
        if step is None or not step.is_known:
            return None
        runs[bisect_right(starts, step.operation.offset) - 1] = 1
    return runs


def reached(operations: Sequence[Operation], flow: Flow) -> set[int]:
    """Returns the offsets of the operations that can run, or that contain code that can."""
    starts = [operation.offset for operation in operations]
    inside = (offset for offset in flow.operations if offset >= starts[0]) if starts else iter(())
    return {starts[bisect_right(starts, offset) - 1] for offset in inside}


def _following(operation: Operation, end: int) -> list[int]:
    """Returns the offsets at which the code continues without a jump."""
    effects = operation.declaration.effects
    if Effect.ENDS in effects or Effect.ENDS_CODE in effects:
        return [end]
    after = operation.offset + operation.length
    found = [] if Effect.JUMPS_ALWAYS in effects else [after]
    return [*found, end] if Effect.MAY_END in effects else found


def _read(data: bytes, at: int, end: int, dialect: str) -> dict[int, Operation]:
    """Returns the operation at an offset, if readable, and some after it."""
    size = _FIRST_WINDOW
    while True:
        found, _ = instruction_set(dialect).scan(data, at, min(at + size, end))
        if (found and found[0].is_complete) or at + size >= end:
            return {operation.offset: operation for operation in found if operation.is_complete}
        size *= _GROWTH
