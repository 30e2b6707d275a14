"""What a check found, shown as good compilers show it: the sentence, the bytes with a line under them, the help.

warning[W303]: FREQUENCY is 200 Hz, outside of 250 to 10000 Hz
    --> offset 10, FREQUENCY of SOUND.TONE
     |
  +0 | 0E 00 2A 00 80 00 00 94 01 01 82 C8 00 82 E8 03
     |                               ^^^^^^^^ FREQUENCY = 200 Hz
     = opSOUND, LC0(TONE), LC0(1), LC2(200), LC2(1000)
     = help: give 250 to 10000 Hz
"""

from __future__ import annotations

from bisect import bisect_right
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby, pairwise
from operator import attrgetter
from textwrap import wrap
from typing import TYPE_CHECKING

from ev3proto.checking.report import Finding, Report, Severity
from ev3proto.messages import Argument, DaisyCommand, DirectCommand, Message, Operation
from ev3proto.schema.frame import parse
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, MEMORY_SIZE
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.text.assembly import operation_line
from ev3proto.text.dialogues import command_spans
from ev3proto.text.phrases import argument_meaning, argument_value
from ev3proto.text.spans import Line, Role, plain_text

if TYPE_CHECKING:
    from ev3proto.checking.codes import Code
    from ev3proto.checking.fixing import Fix

ROW = 16
"""Bytes in a row."""

MOST_ROWS = 4
"""Rows of one span that are shown; a longer one is cut in the middle."""

MOST_ALIKE = 4
"""Findings with the same code that are shown of one frame; of the others, only their offsets are told."""

_MOST_OFFSETS = 12
_MOST_OPERATION = 108
_MOST_LABEL = 60
_TEXT_WIDTH = 100
_COUNTER_SIZE = 2
_BLANK = "   "
_SEVERITIES = tuple(Severity)

_SPAN = attrgetter("offset", "length")

ROLES = {Severity.ERROR: Role.FAULT, Severity.WARNING: Role.VALUE, Severity.HINT: Role.MEANING}
"""How each severity looks."""


def verdict_spans(report: Report) -> Line:
    """`the brick refuses it at offset 9`."""
    if report.accepted:
        return [("the brick accepts it", Role.NAME)]
    if report.rejected_at is None:
        return [("the brick refuses it", Role.FAULT)]
    return [(f"the brick refuses it at offset {report.rejected_at}", Role.FAULT)]


def tally(findings: Iterable[Finding]) -> str:
    """`2 errors, 1 hint`, or `no findings`."""
    severities = [finding.severity for finding in findings]
    present = [(severity, severities.count(severity)) for severity in _SEVERITIES if severity in severities]
    told = [f"{count} {severity}{'s' * (count != 1)}" for severity, count in present]
    return ", ".join(told) or "no findings"


def diagnostics(
    report: Report, findings: Sequence[Finding] | None = None, *, place: str = "", dialect: str = "official"
) -> Iterator[Line]:
    """The verdict, then every finding with its bytes.

    findings  those to show, in the order of their offsets; without them all of the report's
    place     where the frame comes from, such as `robot.log, line 3`; it stands in front of every offset
    """
    shown = report.findings if findings is None else tuple(findings)
    line: Line = [(f"{place}: ", Role.HEADING)] if place else []
    if report.accepted and not report.findings:
        yield [*line, ("accepted", Role.NAME), (": no findings", Role.PLAIN)]
        return
    counts = tally(report.findings)
    hidden = len(report.findings) - len(shown)
    aside = f" ({hidden} not shown)" if hidden else ""
    yield [*line, *verdict_spans(report), (f"; {counts}", Role.PLAIN), (aside, Role.ASIDE)]
    excerpt = _Excerpt(report.frame, dialect)
    kept, left = _without_repetitions(shown)
    for _, together in groupby(kept, key=_SPAN):
        yield []
        yield from _together(list(together), excerpt, place)
    if left:
        yield []
    for alike in left:
        yield _repetitions(alike)


def fixed(
    fix: Fix, findings: Sequence[Finding] | None = None, *, place: str = "", dialect: str = "official"
) -> Iterator[Line]:
    """The fixed frame, what was changed in it, what was left, and then what a check says of it.

    findings, place  as `diagnostics` takes them
    """
    line: Line = [(f"{place}: ", Role.HEADING)] if place else []
    count = len(fix.changes)
    if count:
        line.append((f"fixed in {count} place{'s' * (count > 1)}", Role.NAME))
    else:
        line.append(("nothing could be fixed" if fix.report.findings else "nothing to fix", Role.PLAIN))
    yield line
    yield [(grouped_hex(fix.frame, dialect), Role.HEADING)]
    for change in fix.changes:
        yield [
            (f"  {change.what}: ", Role.NAME),
            (f"{change.before} -> {change.after}", Role.VALUE),
            (f" ({change.why})", Role.ASIDE),
        ]
    for reason in fix.unfixed:
        yield [("  not fixed: ", Role.FAULT), (reason, Role.PLAIN)]
    if count:
        place = f"{place}, fixed" if place else "fixed"
    yield from diagnostics(fix.report, findings, place=place, dialect=dialect)


def explanation(code: Code, report: Report, dialect: str = "official") -> Iterator[Line]:
    """What a code means, and what a check says of its example: `report` is that of it."""
    yield [
        (f"{code.severity}[{code.code}]", ROLES[code.severity]),
        (f": {code.title}", Role.HEADING),
    ]
    yield []
    for paragraph in code.explanation.split("\n\n"):
        for text in wrap(" ".join(paragraph.split()), _TEXT_WIDTH):
            yield [(text, Role.PLAIN)]
        yield []
    yield [("example: ", Role.ASIDE), (grouped_hex(report.frame, dialect), Role.VALUE)]
    yield from diagnostics(report, dialect=dialect)
    yield []
    yield [("without it: ", Role.ASIDE), (grouped_hex(code.counterexample, dialect), Role.VALUE)]


def grouped_hex(frame: bytes, dialect: str = "official") -> str:
    """`0x|0E:00|2A:00|80|00:00|94|01|01|82:B8:01|82:E8:03|`: a frame as the lesson prints it, argument by argument."""
    cuts = sorted({0, *_cuts(parse(frame, strict=False, dialect=dialect), len(frame)), len(frame)})
    pieces = (frame[start:end].hex(":").upper() for start, end in pairwise(cuts))
    return f"0x|{''.join(f'{piece}|' for piece in pieces)}"


def _cuts(message: Message, size: int) -> Iterator[int]:
    """Where the groups of a frame start."""
    ends = [LENGTH_FIELD, LENGTH_FIELD + _COUNTER_SIZE, HEADER_SIZE]
    if isinstance(message, DirectCommand):
        ends.append(COMMAND_HEADER_SIZE)
        for operation in message.operations:
            cmd = operation.cmd
            ends += [operation.offset, operation.offset + 1, operation.offset + (1 + cmd.length if cmd else 1)]
            ends += [argument.offset + argument.length for argument in operation.arguments]
    elif message.type is not None:
        ends.append(HEADER_SIZE + 1)
    yield from (end for end in ends if end <= size)


def _without_repetitions(findings: Sequence[Finding]) -> tuple[list[Finding], list[list[Finding]]]:
    """The findings to show, and by code those that repeat what was shown often enough."""
    if len(findings) <= MOST_ALIKE:
        return list(findings), []
    seen: Counter[str] = Counter()
    kept: list[Finding] = []
    left: dict[str, list[Finding]] = {}
    totals = Counter(finding.code for finding in findings)
    for finding in findings:
        seen[finding.code] += 1
        # The last but one is not worth a line that says that there is one more.
        if seen[finding.code] <= MOST_ALIKE or totals[finding.code] == MOST_ALIKE + 1:
            kept.append(finding)
        else:
            left.setdefault(finding.code, []).append(finding)
    return kept, list(left.values())


def _repetitions(alike: list[Finding]) -> Line:
    first = alike[0]
    offsets = ", ".join(str(finding.offset) for finding in alike[:_MOST_OFFSETS])
    more = ", ..." if len(alike) > _MOST_OFFSETS else ""
    return [
        (f"{first.severity}[{first.code}]", ROLES[first.severity]),
        (f": and {len(alike)} more of these, at offsets {offsets}{more}", Role.PLAIN),
    ]


def _together(findings: list[Finding], excerpt: _Excerpt, place: str) -> Iterator[Line]:
    """The findings on one span of bytes."""
    first = findings[0]
    for finding in findings:
        yield [
            (f"{finding.severity}[{finding.code}]", ROLES[finding.severity]),
            (f": {finding.message}", Role.HEADING),
        ]
    margin = " " * excerpt.margin
    yield [(f"{margin}--> ", Role.ASIDE), (", ".join((*([place] if place else []), _where(first))), Role.PLAIN)]
    worst = min([finding.severity for finding in findings], key=_SEVERITIES.index)
    yield from excerpt.rows(first, ROLES[worst])
    yield from excerpt.operation(first)
    helps: dict[str, str] = {}
    for finding in findings:
        helps.setdefault(finding.help, finding.code)
    for help_, code in helps.items():
        word = f"help for {code}: " if len(helps) > 1 else "help: "
        yield [(f"{margin} = ", Role.ASIDE), (word, Role.OPERATION), (help_, Role.PLAIN)]


def _where(finding: Finding) -> str:
    """`offset 9, VOLUME of SOUND.TONE`."""
    what = " of ".join(name for name in (finding.parameter, finding.operation) if name is not None)
    return f"offset {finding.offset}" + (f", {what}" if what else "")


class _Excerpt:
    """A frame from which spans are shown, and what it says there."""

    def __init__(self, frame: bytes, dialect: str) -> None:
        self._frame = frame
        self._message = message = parse(frame, strict=False, dialect=dialect)
        self._operations = message.operations if isinstance(message, DirectCommand | DaisyCommand) else ()
        self._starts = [operation.offset for operation in self._operations]
        self._lines: dict[int, str] = {}
        self.margin = 2 + len(str(max(len(frame) - 1, 10)))

    def rows(self, finding: Finding, role: Role) -> Iterator[Line]:
        """The rows that a span is in, each with a line under the span, after the last of them what it says."""
        if not self._frame:
            return
        yield self._gutter("")
        start = min(finding.offset, len(self._frame))
        end = min(max(start + finding.length, start + 1), max(len(self._frame), start + 1))
        # A span after the last byte is shown where the next byte would stand.
        last_row = (end - 1) // ROW if end - 1 < len(self._frame) or start % ROW else (start - 1) // ROW
        numbers: list[int | None] = list(range(min(start // ROW, last_row), last_row + 1))
        if len(numbers) > MOST_ROWS:
            numbers[MOST_ROWS - 1 : -1] = [None]
        for number in numbers:
            if number is None:
                yield [*self._gutter("..."), (" ...", Role.ASIDE)]
                continue
            yield self._bytes(number * ROW, start, end, role)
            yield self._underline(number * ROW, start, end, role, self._label(finding) if number == last_row else "")

    def operation(self, finding: Finding) -> Iterator[Line]:
        """What the span belongs to, decoded."""
        told = self._decoded(finding)
        if told:
            text = told if len(told) <= _MOST_OPERATION else f"{told[: _MOST_OPERATION - 3]}..."
            yield [(f"{' ' * self.margin} = ", Role.ASIDE), (text, Role.ASIDE)]

    def _gutter(self, number: str) -> Line:
        return [(f"{number.rjust(self.margin)} |", Role.ASIDE)]

    def _bytes(self, row: int, start: int, end: int, role: Role) -> Line:
        # The plus keeps who reads frames out of texts from taking the row for one.
        first, behind = max(start, row), min(max(end, row), row + ROW)
        line = self._gutter(f"+{row}")
        for begin, stop, part in ((row, first, Role.PLAIN), (first, behind, role), (behind, row + ROW, Role.PLAIN)):
            data = self._frame[begin:stop] if begin < stop else b""
            if data:
                line.append((f" {data.hex(' ').upper()}", part))
        return line

    def _underline(self, row: int, start: int, end: int, role: Role, label: str) -> Line:
        first, behind = max(start, row) - row, min(end, row + ROW) - row
        # What is missing after a full row is marked after that row.
        width = len(_BLANK) * max(behind - first, 1) - 1
        line = [*self._gutter(""), (" " + _BLANK * first, Role.PLAIN), ("^" * width, role)]
        return [*line, (f" {label}", Role.PLAIN)] if label else line

    def _label(self, finding: Finding) -> str:
        """What the bytes of a span say: `VOLUME = 200 %`."""
        if not finding.length:
            return ""
        told = self._header(finding) if finding.offset < COMMAND_HEADER_SIZE else self._argument(finding)
        return told if len(told) <= _MOST_LABEL else f"{told[: _MOST_LABEL - 3]}..."

    def _header(self, finding: Finding) -> str:
        message, offset = self._message, finding.offset
        if len(self._frame) < HEADER_SIZE:
            return ""
        if offset < LENGTH_FIELD:
            return f"length = {message.length}, {len(self._frame) - LENGTH_FIELD} bytes follow"
        if offset < LENGTH_FIELD + _COUNTER_SIZE:
            return f"counter = {message.counter}"
        if offset < HEADER_SIZE:
            return f"type = {'?' if message.type is None else message.type.name}"
        if isinstance(message, DirectCommand) and offset < HEADER_SIZE + MEMORY_SIZE:
            return f"memory: {message.global_size} bytes global, {message.local_size} bytes local"
        return ""

    def _argument(self, finding: Finding) -> str:
        operation = self._operation_at(finding.offset)
        if operation is None:
            return ""
        if (finding.offset, finding.length) == (operation.offset, operation.length):
            return operation.full_name
        cmd = operation.cmd
        if cmd is not None and (finding.offset, finding.length) == (cmd.offset, cmd.length):
            return f"CMD = {cmd.value} {operation.command}"
        for argument in operation.arguments:
            if (finding.offset, finding.length) == (argument.offset, argument.length):
                return _told(argument)
        return ""

    def _decoded(self, finding: Finding) -> str:
        message, offset = self._message, finding.offset
        if isinstance(message, DirectCommand | DaisyCommand):
            operation = self._operation_at(offset)
            if not finding.length and (operation is None or operation.full_name != finding.operation):
                # What is missing at the end of an operation stands where the next one starts.
                operation = self._operation_at(offset - 1)
            return "" if operation is None else self._line(operation)
        return "" if message.type is None or offset < HEADER_SIZE else plain_text(command_spans(message))

    def _line(self, operation: Operation) -> str:
        """An operation as assembly, made once."""
        line = self._lines.get(operation.offset)
        if line is None:
            line = self._lines[operation.offset] = operation_line(operation)
        return line

    def _operation_at(self, offset: int) -> Operation | None:
        number = bisect_right(self._starts, offset) - 1
        if number < 0:
            return None
        operation = self._operations[number]
        # Of an operation that is cut short, what could not be read belongs to it, too.
        is_there = offset < operation.offset + operation.length or not operation.is_complete
        return operation if is_there else None


def _told(argument: Argument) -> str:
    meaning = argument_meaning(argument)
    return f"{argument.name} = {argument_value(argument)}{f' {meaning}' if meaning else ''}"
