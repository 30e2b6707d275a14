"""The way through the code: jumps, ends, operations that no way leads to, loops without an end."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.errors import counted
from ev3proto.messages import Argument
from ev3proto.schema.header import COMMAND_HEADER_SIZE
from ev3proto.semantics.footprint import whole_number
from ev3proto.tables.declaration import Effect, Role
from ev3proto.tables.encoding import CONSTANT, CONSTANT_RANGES, JUMP
from ev3proto.tables.validation import LABELS

_OF_PROGRAMS = frozenset((Effect.OF_PROGRAMS,))
_ENDS = frozenset((Effect.ENDS,))

_OWN_OBJECT = 1
"""The number of the only object that a direct command has."""


def check_flow(context: CheckContext) -> Iterator[Finding]:
    """The operations of a command as a way."""
    operations = context.operations
    if operations and operations[-1].facts.ends_code:
        yield _object_end(operations[-1], context.end)
    if not context.effects.isdisjoint(_OF_PROGRAMS):
        for operation in operations:
            if operation.has(Effect.OF_PROGRAMS) and not operation.facts.ends_code:
                yield from _of_programs(operation)
    if not context.has_jumps and context.effects.isdisjoint(_ENDS):
        return
    way = _Way(context)
    yield from way.wrong_jumps()
    if context.is_whole:
        yield from way.dead_ends()


def _object_end(operation: CheckedOperation, end: int) -> Finding:
    if operation.end == end:
        return operation.finding(codes.NEEDLESS_END, "the firmware puts an OBJECT_END here by itself", "omit it")
    return codes.AFTER_END.finding(
        operation.end,
        end - operation.end,
        f"{counted(end - operation.end, 'byte')} follow the OBJECT_END at offset {operation.start}, so the firmware"
        " refuses the command",
        "omit the OBJECT_END, or what follows it",
    )


def _of_programs(operation: CheckedOperation) -> Iterator[Finding]:
    objects = [argument for argument in operation.arguments if argument.parameter.role is Role.OBJECT]
    if any(whole_number(argument) == _OWN_OBJECT for argument in objects):
        return
    yield operation.finding(
        codes.FOREIGN_OBJECT,
        f"{operation.name} is about objects of a compiled program, and a direct command has only itself",
        "omit it",
    )


class _Way:
    """Which operation leads to which."""

    def __init__(self, context: CheckContext) -> None:
        self._subject = context
        self._operations = context.operations
        self._starts = [operation.start for operation in self._operations]
        self._numbers = {operation.start: number for number, operation in enumerate(self._operations)}
        self._labels = {
            whole_number(argument): operation.end
            for operation in self._operations
            for argument in operation.arguments
            if argument.parameter.role is Role.LABEL
        }

    def wrong_jumps(self) -> Iterator[Finding]:
        """Jumps that do not lead to an operation, nor to the end."""
        for operation in self._operations:
            jump = _jump(operation)
            if jump is not None:
                yield from self._wrong_jump(operation, jump)

    def _wrong_jump(self, operation: CheckedOperation, jump: Argument) -> Iterator[Finding]:
        target = self._target(operation, jump)
        end = self._subject.end
        if target is None:
            if _is_label(jump) and not jump.form.handle and not jump.form.address:
                yield operation.finding_at(
                    codes.NO_SUCH_LABEL,
                    jump,
                    f"{jump.name} names label {jump.value}, which no LABEL sets",
                    f"put LABEL {jump.value} where the jump is to lead",
                )
        elif not COMMAND_HEADER_SIZE <= target <= end:
            yield operation.finding_at(
                codes.JUMP_OUT,
                jump,
                f"{jump.name} is {jump.value}, which leads to offset {target}, and the operations are at"
                f" {COMMAND_HEADER_SIZE} to {end - 1}",
                f"give {_counted(operation, jump, COMMAND_HEADER_SIZE)} to lead to the first operation, or"
                f" {_counted(operation, jump, end)} to lead to the end, counted from the end of the jump"
                f"{_form(jump)}",
            )
        elif target != end and target not in self._numbers and self._is_known(target):
            inside = self._operations[bisect_left(self._starts, target) - 1]
            yield operation.finding_at(
                codes.JUMP_INTO,
                jump,
                f"{jump.name} is {jump.value}, which leads to offset {target}, into the middle of {inside.name}",
                f"give {_counted(operation, jump, inside.start)} to run {inside.name}, or"
                f" {_counted(operation, jump, inside.end)} to skip it{_form(jump)}",
            )

    def _is_known(self, target: int) -> bool:
        """Whether an operation could be read there."""
        return bool(self._operations) and target < self._operations[-1].end

    def _target(self, operation: CheckedOperation, jump: Argument) -> int | None:
        """Where a jump leads, None where that is not known."""
        if jump.form.handle or jump.form.address or jump.is_variable or not isinstance(jump.value, int):
            return None
        if _is_label(jump):
            return self._labels.get(jump.value)
        return operation.end + jump.value

    def _next(self, number: int) -> list[int] | None:
        """The numbers of the operations that may follow one; one more than there are is the end. None: anything."""
        operation = self._operations[number]
        if operation.has(Effect.ENDS):
            return [len(self._operations)]
        jump = _jump(operation)
        following = [] if operation.has(Effect.JUMPS_ALWAYS) else [number + 1]
        if jump is not None:
            target = self._target(operation, jump)
            if target is None:
                return None
            if target == self._subject.end:
                following.append(len(self._operations))
            elif target in self._numbers:
                following.append(self._numbers[target])
            else:
                return None
        if operation.has(Effect.MAY_END):
            following.append(len(self._operations))
        return following

    def dead_ends(self) -> Iterator[Finding]:
        """Operations that no way leads to, or that no way leads out of; nothing if it is unknown where a jump leads."""
        ways: list[list[int]] = []
        for number in range(len(self._operations)):
            following = self._next(number)
            if following is None:
                return
            ways.append(following)
        if not ways:
            return
        end = len(ways)
        reached = _reachable(ways, 0)
        yield from self._unreached(reached)
        back: list[list[int]] = [[] for _ in range(end + 1)]
        for number, following in enumerate(ways):
            for target in following:
                back[target].append(number)
        leaving = _reachable(back, end)
        for number in range(end):
            if number in reached and number not in leaving:
                operation = self._operations[number]
                yield operation.finding(
                    codes.ENDLESS,
                    f"from {operation.name} at offset {operation.start} on, every way leads back: the command never"
                    " ends",
                    "let the loop end by a condition, or repeat it from outside",
                )
                return

    def _unreached(self, reached: set[int]) -> Iterator[Finding]:
        """One finding for the operations in a row that no way leads to."""
        number = 0
        while number < len(self._operations):
            if number in reached:
                number += 1
                continue
            first = last = self._operations[number]
            while number < len(self._operations) and number not in reached:
                last = self._operations[number]
                number += 1
            if first.facts.ends_code:
                # It is where the command ends in any case.
                continue
            yield codes.UNREACHABLE.finding(
                first.start,
                last.end - first.start,
                f"no way leads to {first.name}" + (f" and what follows up to {last.name}" if last is not first else ""),
                "omit it, or let a jump lead there",
                first.name,
            )


def _jump(operation: CheckedOperation) -> Argument | None:
    """The argument of a jump that says where to, None for all other operations."""
    if operation.arguments and operation.arguments[-1].parameter.role is Role.JUMP:
        return operation.arguments[-1]
    return None


def _counted(operation: CheckedOperation, jump: Argument, target: int) -> int:
    """What a jump has to say to lead to an offset in the frame.

    It is counted from the end of the jump, which lies further on where the number takes more bytes than the one that
    stands there now.
    """
    kept = jump.length if jump.form.kind == CONSTANT else 0
    for width, numbers in CONSTANT_RANGES.items():
        length = 1 + width
        number = target - (operation.end - jump.length + length) if target < operation.end else target - operation.end
        if length >= kept and number in numbers:
            return number
    return target - operation.end


def _form(jump: Argument) -> str:
    """What has to be said of a jump that is written as a label and is none."""
    return ", and write it as a constant" if jump.form.kind == JUMP else ""


def _is_label(jump: Argument) -> bool:
    return jump.form.kind == JUMP and isinstance(jump.value, int) and 0 < jump.value < LABELS


def _reachable(ways: Iterable[list[int]], start: int) -> set[int]:
    """All numbers that ways lead to, the first one included."""
    known = list(ways)
    found, waiting = {start}, [start]
    while waiting:
        number = waiting.pop()
        for target in known[number] if number < len(known) else ():
            if target not in found:
                found.add(target)
                waiting.append(target)
    return found
