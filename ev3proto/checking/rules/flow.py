"""The way through the code: jumps, ends, operations that no way leads to, loops without an end."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.errors import counted
from ev3proto.messages import Argument
from ev3proto.schema.header import COMMAND_HEADER_SIZE
from ev3proto.semantics.flow import flow_of, is_label, jump_of, labels_of, reached, target_of
from ev3proto.semantics.footprint import whole_number
from ev3proto.tables.declaration import Effect, Role
from ev3proto.tables.encoding import CONSTANT, CONSTANT_RANGES, JUMP

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
    """The operations as a way: which can run, and where each of them leads."""

    def __init__(self, context: CheckContext) -> None:
        self._subject = context
        self._operations = context.operations
        self._starts = [operation.start for operation in self._operations]
        parsed = [operation.parsed for operation in self._operations]
        self._labels = labels_of(parsed)
        self._flow = flow_of(context.frame, parsed, COMMAND_HEADER_SIZE, context.end, context.dialect)
        self._reached = reached(parsed, self._flow)

    def wrong_jumps(self) -> Iterator[Finding]:
        """Jumps that do not lead to an operation, nor to the end."""
        for operation in self._operations:
            jump = jump_of(operation.parsed)
            if jump is not None:
                yield from self._wrong_jump(operation, jump)

    def _wrong_jump(self, operation: CheckedOperation, jump: Argument) -> Iterator[Finding]:
        target = target_of(operation.parsed, jump, self._labels)
        end = self._subject.end
        if target is None:
            if not is_label(jump) or jump.form.handle or jump.form.address:
                yield operation.finding_at(
                    codes.JUMP_UNKNOWN,
                    jump,
                    f"{jump.name} is no number in the code, so it is not known where {operation.name} leads",
                    "jump by a constant, or by a condition for each place",
                )
            else:
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
        elif target != end and target not in self._starts and self._is_known(target):
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

    def dead_ends(self) -> Iterator[Finding]:
        """Operations that no way leads to, or that no way leads out of; nothing if it is unknown what can run."""
        flow, end = self._flow, self._subject.end
        if not flow.is_known or not self._operations:
            return
        yield from self._unreached()
        back: dict[int, list[int]] = {}
        for start, following in flow.following.items():
            for target in following:
                back.setdefault(target, []).append(start)
        leaving, waiting = {end}, [end]
        while waiting:
            for start in back.get(waiting.pop(), ()):
                if start not in leaving:
                    leaving.add(start)
                    waiting.append(start)
        for operation in self._operations:
            if operation.start in flow.operations and operation.start not in leaving:
                yield operation.finding(
                    codes.ENDLESS,
                    f"from {operation.name} at offset {operation.start} on, every way leads back: the command never"
                    " ends",
                    "let the loop end by a condition, or repeat it from outside",
                )
                return

    def _unreached(self) -> Iterator[Finding]:
        """One finding for the operations in a row that no way leads to."""
        number = 0
        while number < len(self._operations):
            if self._operations[number].start in self._reached:
                number += 1
                continue
            first = last = self._operations[number]
            while number < len(self._operations) and self._operations[number].start not in self._reached:
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
