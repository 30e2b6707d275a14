"""Rules on operations: refused ones, unreachable ones, and those that undo each other."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator
from itertools import groupby

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation, MotorAt
from ev3proto.checking.report import Finding
from ev3proto.errors import Fault, counted
from ev3proto.messages import Argument
from ev3proto.schema.header import COMMAND_HEADER_SIZE
from ev3proto.schema.instructions import CMD, instruction_set
from ev3proto.semantics.flow import flow_of, is_label, jump_of, labels_of, reached, target_of
from ev3proto.semantics.footprint import whole_number
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import UNRELEASED, Effect, Role
from ev3proto.tables.encoding import CONSTANT, CONSTANT_RANGES, ENCODINGS, JUMP

_OWN_OBJECT = 1
"""The number of a direct command's only object."""


def check_flow(context: CheckContext) -> Iterator[Finding]:
    """Checks the control flow of a command."""
    operations = context.operations
    if operations and operations[-1].facts.ends_code:
        yield _object_end(operations[-1], context.end)
    for operation in operations if Effect.OF_PROGRAMS in context.effects else ():
        if operation.has(Effect.OF_PROGRAMS) and not operation.facts.ends_code:
            yield from _of_programs(operation)
    if not context.has_jumps and Effect.ENDS not in context.effects:
        return
    way = _Way(context)
    yield from way.wrong_jumps()
    if context.is_whole:
        yield from way.dead_ends()


def _object_end(operation: CheckedOperation, end: int) -> Finding:
    if operation.end == end:
        return operation.finding(codes.NEEDLESS_END)
    follow = end - operation.end
    return codes.AFTER_END.at(operation.end, follow, bytes=counted(follow, "byte"), end=operation.start)


def _of_programs(operation: CheckedOperation) -> Iterator[Finding]:
    objects = [argument for argument in operation.arguments if argument.parameter.role is Role.OBJECT]
    if any(whole_number(argument) == _OWN_OBJECT for argument in objects):
        return
    yield operation.finding(codes.FOREIGN_OBJECT)


class _Way:
    """The control flow: which operations can run, and where each of them leads."""

    def __init__(self, context: CheckContext) -> None:
        self._subject = context
        self._operations = context.operations
        self._starts = [operation.start for operation in self._operations]
        parsed = [operation.parsed for operation in self._operations]
        self._labels = labels_of(parsed)
        self._flow = flow_of(context.frame, parsed, COMMAND_HEADER_SIZE, context.end, context.dialect)
        self._reached = reached(parsed, self._flow)

    def wrong_jumps(self) -> Iterator[Finding]:
        """Yields findings about jumps that lead neither to an operation nor to the end."""
        for operation in self._operations:
            jump = jump_of(operation.parsed)
            if jump is not None:
                yield from self._wrong_jump(operation, jump)

    def _wrong_jump(self, operation: CheckedOperation, jump: Argument) -> Iterator[Finding]:
        target = target_of(operation.parsed, jump, self._labels)
        end = self._subject.end
        if target is None:
            if not is_label(jump) or jump.form.handle or jump.form.address:
                yield operation.finding_of(codes.JUMP_UNKNOWN, jump)
            else:
                yield operation.finding_of(codes.NO_SUCH_LABEL, jump, value=jump.value)
        elif not COMMAND_HEADER_SIZE <= target <= end:
            parts = _targets(operation, jump, COMMAND_HEADER_SIZE, end)
            yield operation.finding_of(codes.JUMP_OUT, jump, target=target, last=end - 1, **parts)
        elif target != end and target not in self._starts and self._is_known(target):
            inside = self._operations[bisect_left(self._starts, target) - 1]
            parts = _targets(operation, jump, inside.start, inside.end)
            yield operation.finding_of(codes.JUMP_INTO, jump, target=target, inside=inside.name, **parts)

    def _is_known(self, target: int) -> bool:
        """Returns whether an operation was read there."""
        return bool(self._operations) and target < self._operations[-1].end

    def dead_ends(self) -> Iterator[Finding]:
        """Yields findings about unreachable operations and endless loops; nothing if a jump's target is unknown."""
        if not self._flow.is_known or not self._operations:
            return
        yield from self._unreached()
        endless = set(self._flow.operations) - self._leaving()
        for operation in [one for one in self._operations if one.start in endless][:1]:
            yield operation.finding(codes.ENDLESS, at=operation.start)

    def _leaving(self) -> set[int]:
        """Returns the offsets from which a way leads to the end."""
        back: dict[int, list[int]] = {}
        for start, following in self._flow.following.items():
            for target in following:
                back.setdefault(target, []).append(start)
        leaving: set[int] = set()
        waiting = [self._subject.end]
        while waiting:
            at = waiting.pop()
            if at not in leaving:
                leaving.add(at)
                waiting += back.get(at, ())
        return leaving

    def _unreached(self) -> Iterator[Finding]:
        """Yields one finding for each row of unreachable operations."""
        for is_reached, row in groupby(self._operations, lambda one: one.start in self._reached):
            first, *others = row
            if is_reached or first.facts.ends_code:
                # The command ends at an OBJECT_END in any case.
                continue
            last = others[-1] if others else first
            last_name = last.name if others else None
            yield codes.UNREACHABLE.at(first.start, last.end - first.start, owner=first.name, last=last_name)


def _counted(operation: CheckedOperation, jump: Argument, target: int) -> int:
    """Returns the distance from the end of a jump to an offset; a number that takes more bytes moves that end."""
    kept = jump.length if jump.form.kind == CONSTANT else 0
    for width, numbers in CONSTANT_RANGES.items():
        length = 1 + width
        number = target - (operation.end - jump.length + length) if target < operation.end else target - operation.end
        if length >= kept and number in numbers:
            return number
    return target - operation.end


def _targets(operation: CheckedOperation, jump: Argument, start: int, end: int) -> dict[str, object]:
    """Returns the parts of the words about a jump that may lead to either of two offsets."""
    return {
        "value": jump.value,
        "start": _counted(operation, jump, start),
        "end": _counted(operation, jump, end),
        "form": "a constant" if jump.form.kind == JUMP else None,
    }


def check_effects(context: CheckContext) -> Iterator[Finding]:
    """Checks operations that undo each other."""
    for effect, rule in _OF_EFFECTS.items():
        if effect in context.effects:
            yield from rule(context.operations)
    if Effect.DRAWS in context.effects and context.is_whole:
        yield from _not_shown(context.operations)


def _waits(operation: CheckedOperation) -> bool:
    """Returns whether the operation lets time pass; a jump counts, because loops are used to wait."""
    return operation.has(Effect.WAITS) or operation.facts.is_jump


def _sounds(operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    playing: CheckedOperation | None = None
    for operation in operations:
        starts, ends = operation.has(Effect.STARTS_SOUND), operation.has(Effect.ENDS_SOUND)
        if playing is not None and (starts or ends):
            yield playing.finding(codes.SOUND_INTERRUPTED, other=operation.name, at=operation.start)
        if starts:
            playing = operation
        elif ends or _waits(operation):
            playing = None


def _pictures(operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    """Yields findings about pictures that are replaced as soon as they are shown."""
    shown: CheckedOperation | None = None
    wiping: CheckedOperation | None = None
    is_drawn = False
    for operation in operations:
        if operation.has(Effect.SHOWS):
            if shown is not None and wiping is not None:
                parts = {"wiping": wiping.name, "other": operation.name, "at": operation.start}
                yield shown.finding(codes.PICTURE_REPLACED, **parts)
            shown, wiping, is_drawn = (operation if is_drawn else None), None, False
        elif operation.has(Effect.WIPES) and shown is not None:
            wiping = operation
        elif _waits(operation):
            shown = None
        is_drawn = is_drawn or operation.has(Effect.DRAWS)


def _not_shown(operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    """Yields one finding for everything drawn after the last UPDATE."""
    hidden: CheckedOperation | None = None
    for operation in operations:
        if operation.has(Effect.SHOWS) or operation.has(Effect.DIALOG):
            hidden = None
        elif operation.has(Effect.DRAWS):
            hidden = operation
    if hidden is not None:
        yield hidden.finding(codes.NOT_SHOWN)


def _moves(operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    moving: dict[MotorAt, CheckedOperation] = {}
    for operation in operations:
        starts = operation.has(Effect.STARTS_MOVE)
        if not starts and not operation.has(Effect.STOPS_MOTORS):
            if _waits(operation):
                moving.clear()
            continue
        ports = operation.motors or []
        interrupted = {moving[port].start: moving[port] for port in ports if port in moving}
        for before in interrupted.values():
            yield before.finding(codes.MOVE_INTERRUPTED, other=operation.name, at=operation.start)
        for port in ports:
            moving.pop(port, None)
        if starts:
            moving.update(dict.fromkeys(ports, operation))


_OF_EFFECTS = {Effect.STARTS_SOUND: _sounds, Effect.SHOWS: _pictures, Effect.STARTS_MOVE: _moves}


def check_refusals(context: CheckContext) -> Iterator[Finding]:
    """Yields findings about what stops the parser or validator."""
    if Effect.NEVER_RUNS in context.effects:
        yield from _never_run(context)
    if context.dialect == "official":
        yield from _newer(context)
    if context.verdict.spins:
        yield _spins(context)
        if context.fault is not None and _faulty_start(context) == context.verdict.rejected_at:
            return
    # A frame that ends early, or has a wrong length, is reported elsewhere.
    if context.own_fault is not None and context.end > COMMAND_HEADER_SIZE:
        yield _fault(context, context.own_fault)


def _never_run(context: CheckContext) -> Iterator[Finding]:
    for operation in context.operations:
        if operation.has(Effect.NEVER_RUNS):
            byte = f"0x{operation.parsed.opcode:02X}"
            yield operation.finding(codes.UNKNOWN_OPCODE, codes.NEVER_RUNS, byte=byte)


def _faulty_start(context: CheckContext) -> int:
    """Returns the offset of the operation that cannot be read."""
    start: int = COMMAND_HEADER_SIZE
    for last in context.operations[-1:]:
        start = last.end if last.parsed.is_complete else last.start
    return start


def _newer(context: CheckContext) -> Iterator[Finding]:
    rejected_at = context.verdict.rejected_at
    for operation in context.operations:
        if not operation.facts.declaration.is_newer:
            continue
        cmd = operation.parsed.cmd
        assert cmd is not None
        if rejected_at is not None and rejected_at >= operation.start:
            yield operation.finding_of(codes.NEWER, cmd, at=rejected_at)
            # Later refusals have the same cause.
            rejected_at = None
        else:
            yield operation.finding_of(codes.NEWER_ACCEPTED, cmd)


def _spins(context: CheckContext) -> Finding:
    verdict = context.verdict
    at = verdict.blamed
    assert at is not None
    operation = next((operation for operation in context.operations if operation.start == verdict.rejected_at), None)
    argument = next((it for it in operation.arguments if it.offset == at), None) if operation else None
    if operation is not None and argument is not None:
        return operation.finding_of(codes.SPINS, argument, **_number_or_encoding(argument))
    return codes.SPINS.at(at, max(context.end - at, 0), "unread")


def _fault(context: CheckContext, fault: Fault) -> Finding:
    """Returns the finding about what stops the parser, which is the cause of all later refusals."""
    start = _faulty_start(context)
    if context.operations and context.operations[-1].start == start:
        return _faulty_argument(context, context.operations[-1], fault)
    family = instruction_set(context.dialect).families[context.frame[start]]
    if family is None:
        return _unknown_opcode(context, start)
    return _faulty_cmd(context, start, family.opcode.name, fault)


def _unknown_opcode(context: CheckContext, start: int) -> Finding:
    number = context.frame[start]
    others = [opcode for opcode in OPCODES if opcode.number == number]
    parts: dict[str, object] = {"byte": f"0x{number:02X}", "dialect": context.dialect}
    if not others:
        return codes.UNKNOWN_OPCODE.at(start, 1, **parts)
    known = others[0]
    key = "unreleased" if known.dialects == UNRELEASED else "dialect"
    parts |= {"known": known.name, "note": known.note, "others": " and ".join(known.dialects)}
    return codes.UNKNOWN_OPCODE.at(start, 1, key, **parts)


def _faulty_cmd(context: CheckContext, start: int, name: str, fault: Fault) -> Finding:
    """Returns the finding about an opcode without a valid CMD."""
    at = start + 1
    if fault.truncated:
        return codes.CUT_OFF.at(start, context.end - start, owner=name, name="CMD", reason=fault.reason)
    first = context.frame[at]
    encoding = ENCODINGS[first]
    if encoding is None:
        return _undefined_form(at, first, name, "CMD")
    cmd, _ = CMD.read(context.frame[: context.end], at)
    if encoding.kind != CONSTANT:
        return codes.VARIABLE_CMD.at(at, cmd.length, owner=name, name="CMD", reason=fault.reason)
    key, refused_at = _later(context, start)
    return codes.UNKNOWN_CMD.at(at, cmd.length, key, owner=name, name="CMD", value=cmd.value, refused_at=refused_at)


def _later(context: CheckContext, start: int) -> tuple[str, int | None]:
    """Returns the key of the words about a fault, and where the brick refuses the command if not at the fault."""
    rejected_at = context.verdict.rejected_at
    if rejected_at is None:
        return codes.UNNOTICED, None
    return "", rejected_at if rejected_at > start else None


def _number_or_encoding(argument: Argument) -> dict[str, object]:
    """Returns the value of a constant number, or the encoding of another argument."""
    is_number = argument.kind == CONSTANT and isinstance(argument.value, int)
    return {"value": argument.value, "encoding": None} if is_number else {"value": None, "encoding": argument.encoding}


def _undefined_form(at: int, first: int, name: str, parameter: str) -> Finding:
    return codes.UNDEFINED_FORM.at(at, 1, owner=name, name=parameter, byte=first)


def _faulty_argument(context: CheckContext, operation: CheckedOperation, fault: Fault) -> Finding:
    """Returns the finding about an argument that cannot be read."""
    at = fault.offset
    count = next((argument for argument in operation.arguments if argument.offset == at), None)
    if count is not None:
        # A readable argument stops the parser only if it is a count.
        return _faulty_count(context, operation, count, fault)
    parameters = operation.facts.declaration.parameters
    parameter = parameters[min(len(operation.arguments), len(parameters) - 1)]
    if fault.truncated:
        last = min(at, context.end)
        return codes.CUT_OFF.at(
            last, context.end - last, owner=operation.name, name=parameter.name, reason=fault.reason
        )
    return _undefined_form(at, context.frame[at], operation.name, parameter.name)


def _faulty_count(context: CheckContext, operation: CheckedOperation, count: Argument, fault: Fault) -> Finding:
    number = whole_number(count)
    if number is not None and number >= 0 and (fault.truncated or not count.parameter.counts):
        room = context.end - count.offset - count.length
        parts = {"values": counted(number, "value"), "bytes": counted(room, "byte")}
        return operation.finding_of(codes.CUT_OFF, count, "count", **parts)
    key, refused_at = _later(context, operation.start)
    return operation.finding_of(codes.BAD_COUNT, count, key, refused_at=refused_at, **_number_or_encoding(count))
