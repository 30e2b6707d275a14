"""The way through the code: jumps, ends, operations that no way leads to, loops without an end."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ev3proto.checking import codes
from ev3proto.checking.places import number_of
from ev3proto.checking.report import Finding
from ev3proto.checking.rules.header import plural
from ev3proto.checking.subject import OBJECT_END, Step, Subject
from ev3proto.messages import Argument
from ev3proto.schema.frame import COMMAND_HEADER_SIZE
from ev3proto.tables.behaviour import ENDS, MAY_END, OF_PROGRAMS
from ev3proto.tables.branch import OFFSET
from ev3proto.tables.encoding import JUMP
from ev3proto.tables.validation import LABELS

_LABEL = "LABEL"
_ALWAYS = "JR"
_OWN_OBJECT = 1


def check_flow(subject: Subject) -> Iterator[Finding]:
    """The operations of a command as a way."""
    steps = subject.steps
    has_jumps = False
    for step in steps:
        if step.name == OBJECT_END:
            yield _object_end(step, subject.end)
        elif step.name in OF_PROGRAMS:
            yield from _of_programs(step)
        has_jumps = has_jumps or step.traits.is_jump
    if not has_jumps and not any(step.name in ENDS for step in steps):
        return
    way = _Way(subject)
    yield from way.wrong_jumps()
    if subject.is_whole:
        yield from way.dead_ends()


def _object_end(step: Step, end: int) -> Finding:
    if step.end == end:
        return step.finding(codes.NEEDLESS_END, "the firmware puts an OBJECT_END here by itself", "leave it away")
    return codes.AFTER_END.finding(
        step.end,
        end - step.end,
        f"{plural(end - step.end, 'byte')} follow the OBJECT_END at offset {step.start}, so the firmware refuses the"
        " command",
        "leave the OBJECT_END away, or what stands behind it",
    )


def _of_programs(step: Step) -> Iterator[Finding]:
    if step.arguments and step.name not in ENDS and number_of(step.arguments[0]) == _OWN_OBJECT:
        return
    yield step.finding(
        codes.FOREIGN_OBJECT,
        f"{step.name} is about objects of a compiled program, and a direct command has only itself",
        "leave it away",
    )


class _Way:
    """Which operation leads to which."""

    def __init__(self, subject: Subject) -> None:
        self._subject = subject
        self._steps = subject.steps
        self._numbers = {step.start: number for number, step in enumerate(self._steps)}
        self._labels = {
            number_of(step.arguments[0]): step.end for step in self._steps if step.name == _LABEL and step.arguments
        }

    def wrong_jumps(self) -> Iterator[Finding]:
        """Jumps that do not lead to an operation, nor to the end."""
        for step in self._steps:
            jump = _jump(step)
            if jump is not None:
                yield from self._wrong_jump(step, jump)

    def _wrong_jump(self, step: Step, jump: Argument) -> Iterator[Finding]:
        target = self._target(step, jump)
        end = self._subject.end
        if target is None:
            if _is_label(jump) and not jump.form.handle:
                yield step.finding_at(
                    codes.NO_SUCH_LABEL,
                    jump,
                    f"{jump.name} names label {jump.value}, which no LABEL sets",
                    f"put LABEL {jump.value} where the jump is to lead",
                )
        elif not COMMAND_HEADER_SIZE <= target <= end:
            yield step.finding_at(
                codes.JUMP_OUT,
                jump,
                f"{jump.name} is {jump.value}, which leads to offset {target}, and the operations are at"
                f" {COMMAND_HEADER_SIZE} to {end - 1}",
                f"give {COMMAND_HEADER_SIZE - step.end} to {end - step.end}, counted from the end of the jump",
            )
        elif target != end and target not in self._numbers and self._is_known(target):
            inside = next(other for other in self._steps if other.start < target < other.end)
            yield step.finding_at(
                codes.JUMP_INTO,
                jump,
                f"{jump.name} is {jump.value}, which leads to offset {target}, into the middle of {inside.name}",
                f"give {inside.start - step.end} to run {inside.name}, or {inside.end - step.end} to leave it out",
            )

    def _is_known(self, target: int) -> bool:
        """Whether an operation could be read there."""
        return bool(self._steps) and target < self._steps[-1].end

    def _target(self, step: Step, jump: Argument) -> int | None:
        """Where a jump leads, None where nobody can tell."""
        if jump.form.handle or jump.form.address or jump.is_variable or not isinstance(jump.value, int):
            return None
        if _is_label(jump):
            return self._labels.get(jump.value)
        return step.end + jump.value

    def _next(self, number: int) -> list[int] | None:
        """The numbers of the operations that may follow one; one more than there are is the end. None: anything."""
        step = self._steps[number]
        if step.name in ENDS:
            return [len(self._steps)]
        jump = _jump(step)
        following = [] if step.name == _ALWAYS else [number + 1]
        if jump is not None:
            target = self._target(step, jump)
            if target is None:
                return None
            if target == self._subject.end:
                following.append(len(self._steps))
            elif target in self._numbers:
                following.append(self._numbers[target])
            else:
                return None
        if step.name in MAY_END:
            following.append(len(self._steps))
        return following

    def dead_ends(self) -> Iterator[Finding]:
        """Operations that no way leads to, and those that no way leads out of. Nothing where a jump cannot be told."""
        ways: list[list[int]] = []
        for number in range(len(self._steps)):
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
                step = self._steps[number]
                yield step.finding(
                    codes.ENDLESS,
                    f"from {step.name} at offset {step.start} on, every way leads back: the command never ends",
                    "let the loop end by a condition, or repeat it from outside",
                )
                return

    def _unreached(self, reached: set[int]) -> Iterator[Finding]:
        """One finding for the operations in a row that no way leads to."""
        number = 0
        while number < len(self._steps):
            if number in reached:
                number += 1
                continue
            first = last = self._steps[number]
            while number < len(self._steps) and number not in reached:
                last = self._steps[number]
                number += 1
            if first.name == OBJECT_END:
                # It is where the command ends in any case.
                continue
            yield codes.UNREACHABLE.finding(
                first.start,
                last.end - first.start,
                f"no way leads to {first.name}" + (f" and what follows up to {last.name}" if last is not first else ""),
                "leave it away, or let a jump lead there",
                first.name,
            )


def _jump(step: Step) -> Argument | None:
    """The argument of a jump that says where to, None for all other operations."""
    if step.arguments and step.arguments[-1].parameter is OFFSET:
        return step.arguments[-1]
    return None


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
