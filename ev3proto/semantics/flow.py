"""Control flow: which operations can run, starting at the first one and following every jump.

A jump into an operation runs the bytes there, so they are read there. A jump by a value outside the code may lead
anywhere, and a jump out of the code runs unknown bytes: then it is unknown what can run.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass, field

from ev3proto.messages import Argument, Operation
from ev3proto.schema.instructions import instruction_set
from ev3proto.semantics.footprint import whole_number
from ev3proto.tables.declaration import Effect, Role
from ev3proto.tables.encoding import JUMP
from ev3proto.tables.validation import LABELS

_WINDOWS = (32, 256)
"""Number of bytes in which an operation is first looked for, since jumps may lead into many places."""


@dataclass(slots=True)
class Flow:
    """The operations that can run.

    operations  by offset, including those found by jumps into others
    following   the offsets at which each of them continues; the end of the code if it ends
    is_known    whether these are all that can run
    """

    operations: dict[int, Operation] = field(default_factory=dict)
    following: dict[int, list[int]] = field(default_factory=dict)
    is_known: bool = True


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
    """Returns the target offset of a jump.

    Args:
        operation: The jump.
        jump: Its argument with the target.
        labels: The offsets of the labels.

    Returns:
        The offset; None if it is not in the code: a variable, a handle, an address, a missing label.
    """
    if jump.form.handle or jump.form.address or jump.is_variable or not isinstance(jump.value, int):
        return None
    if is_label(jump):
        return labels.get(jump.value)
    return operation.offset + operation.length + jump.value


def flow_of(data: bytes, operations: Sequence[Operation], start: int, end: int, dialect: str) -> Flow:
    """Follows code from its first operation.

    Args:
        data: The bytes that contain the code.
        operations: The operations read in a row.
        start: The offset of the first one.
        end: The offset after the last one.
        dialect: The firmware whose instruction set is used.
    """
    flow = Flow()
    read = {operation.offset: operation for operation in operations if operation.is_complete}
    labels = labels_of(operations)
    waiting = [start]
    while waiting:
        at = waiting.pop()
        if at in flow.following or at == end:
            continue
        if at not in read and start <= at < end:
            for offset, operation in _read(data, at, end, dialect).items():
                read.setdefault(offset, operation)
        reached = read.get(at)
        if reached is None:
            flow.is_known = False
            continue
        flow.operations[at] = reached
        flow.following[at] = following = _following(reached, end)
        jump = jump_of(reached)
        if jump is not None:
            target = target_of(reached, jump, labels)
            if target is None:
                flow.is_known = False
            else:
                following.append(target)
        waiting += following
    return flow


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
    for limit in (*(at + window for window in _WINDOWS if at + window < end), end):
        found, _ = instruction_set(dialect).scan(data, at, limit)
        if found and found[0].is_complete:
            return {operation.offset: operation for operation in found if operation.is_complete}
    return {}
