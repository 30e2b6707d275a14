"""Checks of programs: the firmware's verdict, and what a careful programmer would change."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from ev3proto.checking import program_codes as codes
from ev3proto.checking.checking import check
from ev3proto.checking.codes import FindingCode
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.checking.report import Finding
from ev3proto.errors import DecodeError, as_bytes, counted
from ev3proto.messages import Argument, Operation
from ev3proto.program.header import IMAGE_HEADER_SIZE, OBJECT_HEADER_SIZE, PACKED_HEADER
from ev3proto.program.image import Program, parse
from ev3proto.program.objects import CodeObject
from ev3proto.program.report import ProgramReport, program_findings
from ev3proto.program.retyped import CALL
from ev3proto.program.walk import SIZE_AT, Walk, walk
from ev3proto.semantics.flow import is_label, jump_of, labels_of, place_of, runs_of, starts_of, target_of
from ev3proto.tables.declaration import Direction, Effect
from ev3proto.tables.encoding import CONSTANT, GLOBAL, LOCAL
from ev3proto.tables.program import ObjectKind
from ev3proto.text.diagnostics import diagnostics, explanation, grouped_hex
from ev3proto.text.phrases import spaced_hex
from ev3proto.text.spans import Line

_OBJECT_END = "OBJECT_END"
_HANDLE_SIZE = 2

MOST_OF_A_CODE = 1000
"""Maximum number of findings kept for each code; further ones are only counted."""


def check_program(image: bytes | bytearray | memoryview, *, dialect: str = "official") -> ProgramReport:
    """Checks a program image, and whether the brick starts it. The contents of an image never make it raise.

    Args:
        image: The image from its sign to its last byte.
        dialect: "official", "xtended" or "compat": the firmware whose instruction set to use.

    Returns:
        The findings, at most 1,000 of each code, and the verdict: `rejected_at` is the offset of the first operation
        that the firmware's validator rejects, 4 for the header. For an image older than the release of 2013 it is 8,
        the offset of its version: the firmware complains about that, but accepts the image.
    """
    image = as_bytes(image, "an image")
    try:
        program = parse(image, strict=False, dialect=dialect)
    except DecodeError as error:
        finding = codes.DAMAGED.at(error.offset, 0, reason=error.reason)
        return ProgramReport(image, False, 0, (finding,))
    found = walk(image, dialect)
    seen: Counter[str] = Counter()
    findings = []
    for finding in _Check(image, program, found, dialect).findings():
        seen[finding.code] += 1
        if seen[finding.code] <= MOST_OF_A_CODE:
            findings.append(finding)
    findings.sort(key=lambda it: (it.offset, it.code))
    omitted = seen.total() - len(findings)
    return ProgramReport(image, found.accepted, found.position, tuple(findings), omitted=omitted)


class _Check:
    """The findings of one program."""

    def __init__(self, image: bytes, program: Program, found: Walk, dialect: str) -> None:
        self._image = image
        self._dialect = dialect
        self._program = program
        self._walk = found
        self._by_number = {part.number: part for part in program.objects}
        self._starts = {
            (read.start, part.kind is ObjectKind.SUBCALL)
            for read, part in zip(found.objects, program.objects, strict=False)
        }

    def findings(self) -> Iterator[Finding]:
        """Yields all findings; those about shared code once."""
        if not self._walk.accepted:
            refusal = self._refusal(self._walk.position or 0, str(self._walk.reason))
            yield refusal
            if refusal.code == codes.DAMAGED.code:
                return
        stated = PACKED_HEADER.unpack_from(self._image, SIZE_AT)[0]
        if stated < len(self._image):
            more = len(self._image) - stated
            parts = {"stated": counted(stated, "byte"), "more": more, "bytes": counted(more, "byte")}
            yield codes.LEFT_OVER.at(stated, more, "after the image", **parts)
        for offset, data in self._program.defects.gaps:
            yield from self._left_over(offset, len(data))
        for part in self._program.objects:
            if self._walk.accepted:
                yield from self._other_code(part)
            if part.shares is None:
                yield from self._object(part)

    def _left_over(self, offset: int, size: int) -> Iterator[Finding]:
        """Yields the finding about bytes between objects; those after the image are reported as a whole."""
        size = min(size, PACKED_HEADER.unpack_from(self._image, SIZE_AT)[0] - offset)
        if size > 0:
            belong, them = ("belongs", "it") if size == 1 else ("belong", "them")
            yield codes.LEFT_OVER.at(offset, size, bytes=counted(size, "byte"), belong=belong, them=them)

    def _refusal(self, at: int, why: str) -> Finding:
        """Returns the finding for the place where the firmware's validator stops."""
        if at == SIZE_AT:
            return codes.DAMAGED.at(at, 0, reason=why)
        objects = self._program.objects
        operation = next((step for part in objects for step in part.operations if step.offset == at), None)
        # The reason why it cannot be read says more than the validator's.
        reasons = {part.fault.offset: part.fault.reason for part in objects if part.fault is not None}
        parts = {"object": len(self._walk.objects), "reason": reasons.get(at, why)}
        if operation is None:
            return codes.REFUSED.at(at, 1, operation=f"0x{self._image[at]:02X}", **parts)
        key, name = "newer" if operation.declaration.is_newer else "", operation.full_name
        return codes.REFUSED.at(at, operation.length, key, owner=name, operation=name, **parts)

    def _other_code(self, part: CodeObject) -> Iterator[Finding]:
        """Yields code that the brick runs without validating it, because the object's header points elsewhere."""
        at = IMAGE_HEADER_SIZE + (part.number - 1) * OBJECT_HEADER_SIZE
        read = self._walk.objects[part.number - 1]
        if (part.offset, part.kind is ObjectKind.SUBCALL) not in self._starts:
            yield codes.OTHER_CODE.at(at, 4, number=part.number, offset=part.offset, start=read.start)
        elif part.number == 1 and not part.operations and (part.fault is None or part.flaw.headless):
            yield codes.NOTHING_TO_RUN.at(at, 4)

    def _object(self, part: CodeObject) -> Iterator[Finding]:
        for operation in part.operations:
            yield from self._operation(operation, part)
        if self._walk.accepted or part.fault is None:
            yield from self._end(part)
        yield from _way(part, self._image, self._dialect)

    def _end(self, part: CodeObject) -> Iterator[Finding]:
        steps = part.operations
        is_ended = steps[-1].name == _OBJECT_END if steps else part.number == 1 or not part.rest
        if part.fault is not None and not part.fault.truncated and not part.flaw.headless:
            yield codes.UNREAD.at(part.fault.offset, 0, number=part.number, reason=part.fault.reason)
        elif not is_ended:
            yield codes.NO_END.at(steps[-1].offset if steps else part.offset, 0, number=part.number)
        elif part.rest and not part.flaw.headless:
            yield from self._left_over(part.offset + len(part.code) - len(part.rest), len(part.rest))

    # Operations

    def _operation(self, operation: Operation, part: CodeObject) -> Iterator[Finding]:
        arguments = operation.arguments
        if Effect.OF_PROGRAMS in operation.declaration.effects and arguments and operation.is_complete:
            yield from self._object_named(operation, arguments)
        for argument in arguments:
            if argument.kind in (LOCAL, GLOBAL):
                yield from self._place(operation, argument, part)

    def _object_named(self, operation: Operation, arguments: tuple[Argument, ...]) -> Iterator[Finding]:
        first = arguments[0]
        if first.kind != CONSTANT:
            return
        named = self._by_number.get(int(first.value))
        if named is None:
            yield _at(operation, first, codes.NO_SUCH_OBJECT, number=first.value, count=len(self._by_number))
        elif operation.name == CALL:
            yield from self._call(operation, arguments, named)

    def _call(self, operation: Operation, arguments: tuple[Argument, ...], callee: CodeObject) -> Iterator[Finding]:
        if callee.kind is not ObjectKind.SUBCALL:
            yield _at(operation, arguments[0], codes.NOT_A_SUBCALL, number=callee.number, kind=callee.kind)
            return
        given, declared = len(arguments) - 2, len(callee.parameters)
        if given != declared:
            parts = {"number": callee.number, "declared": counted(declared, "parameter"), "given": given}
            yield _at(operation, arguments[1], codes.CALL_COUNT, **parts)
        for argument, parameter in zip(arguments[2:], callee.parameters, strict=False):
            if parameter.direction is not Direction.IN and argument.kind not in (LOCAL, GLOBAL):
                yield _at(operation, argument, codes.CALL_OUTPUT, number=callee.number)

    def _place(self, operation: Operation, argument: Argument, part: CodeObject) -> Iterator[Finding]:
        """Yields a finding if a variable ends outside its memory. A block shares the locals of its owner."""
        if argument.kind == GLOBAL:
            size = self._program.global_size
        else:
            owner = self._by_number.get(part.owner)
            size = max(part.local_size, owner.local_size if owner is not None else 0)
        width = _HANDLE_SIZE if argument.form.handle else max(argument.parameter.type.size, 1)
        end = int(argument.value) + width
        if end > size:
            parts = {"scope": argument.kind, "end": end, "size": size, "bytes": counted(end, "byte")}
            yield _at(operation, argument, codes.OUTSIDE_MEMORY, **parts)


def _at(operation: Operation, argument: Argument, code: FindingCode, **parts: object) -> Finding:
    return code.at(argument.offset, argument.length, owner=operation.full_name, name=argument.name, **parts)


# Control flow of an object


def _way(part: CodeObject, image: bytes, dialect: str) -> Iterator[Finding]:
    """Yields jumps with a wrong or unknown target, and unreachable operations."""
    steps = part.operations
    if not steps:
        return
    starts = starts_of(steps)
    labels = labels_of(steps)
    for step, jump in [(step, jump) for step in steps if (jump := jump_of(step)) is not None]:
        goal = target_of(step, jump, labels)
        if goal is None and not is_label(jump):
            yield _at(step, jump, codes.UNKNOWN_JUMP)
        elif goal is not None and place_of(goal, starts) is None:
            yield codes.BAD_JUMP.at(step.offset, step.length, owner=step.full_name, target=goal, number=part.number)
    if part.fault is None:
        runs = runs_of(image, steps, steps[-1].offset + steps[-1].length, dialect)
        if runs is not None:
            yield from _unreached(steps, runs)


def _unreached(steps: Sequence[Operation], runs: bytearray) -> Iterator[Finding]:
    """Yields one finding for each row of unreachable operations, except the end that every assembler adds."""
    place = runs.find(0)
    while place >= 0:
        after = runs.find(1, place)
        last = (len(steps) if after < 0 else after) - 1
        while last >= place and Effect.ENDS in steps[last].declaration.effects:
            last -= 1
        if last >= place:
            first, end = steps[place], steps[last]
            parts = {"owner": first.full_name, "last": end.full_name if last > place else None}
            yield codes.UNREACHABLE.at(first.offset, end.offset + end.length - first.offset, **parts)
        place = -1 if after < 0 else runs.find(0, after)


def explained(code: FindingCode, *, dialect: str = "official") -> Iterator[Line]:
    """Yields what `ev3proto check --explain` prints of a code."""
    if code.code in PROGRAM_CODES:
        program = check_program(code.example, dialect=dialect)
        return explanation(code, program_findings(program, program.findings), spaced_hex)
    report = check(code.example, dialect=dialect, carrier=code.carrier, alone=code.alone)
    return explanation(code, diagnostics(report, dialect=dialect), lambda frame: grouped_hex(frame, dialect))
