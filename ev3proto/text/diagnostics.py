"""The findings of a check, shown as good compilers do: the sentence, the bytes with a line under them, the help.

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
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import groupby, pairwise
from operator import attrgetter
from textwrap import wrap

from ev3proto.checking.checking import check
from ev3proto.checking.codes import FindingCode
from ev3proto.checking.report import Finding, Fix, Report, Severity, Suggestion, difference
from ev3proto.errors import counted
from ev3proto.messages import Argument, DaisyCommand, DirectCommand, Message, Operation, SystemCommand
from ev3proto.schema.frame import read_last
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, MEMORY_SIZE
from ev3proto.tables.frame import COUNTER_SIZE, LENGTH_FIELD
from ev3proto.text.assembly import operation_line
from ev3proto.text.phrases import argument_meaning, argument_value, command_spans, spaced_hex
from ev3proto.text.spans import Line, Role, Span, Spans, plain_text

ROW = 16
"""Bytes in one row."""

MOST_ROWS = 4
"""Maximum rows of one span; a longer one is cut in the middle."""

_MOST_OPERATION = 108
_MOST_LABEL = 60
_BYTE = 3
"""Columns of a byte: a blank and two digits."""


class Excerpt:
    """A frame whose spans are shown, with their meaning."""

    def __init__(self, frame: bytes, dialect: str) -> None:
        self._size = len(frame)
        self._hex = f" {spaced_hex(frame)}"
        self._message = message = read_last(frame, dialect)
        self._operations = message.operations if isinstance(message, (DirectCommand, DaisyCommand)) else None
        self._starts = [operation.offset for operation in self._operations or ()]
        self._lines: dict[int, str] = {}
        self._width = 2 + len(str(max(len(frame) - 1, 10)))
        self.margin = " " * self._width
        self._gutter = f"{self.margin} |", Role.GUTTER

    def meant(self, at: int, size: int, unknown: Iterable[tuple[int, int]]) -> list[Spans]:
        """Returns the rows of a frame that was meant, its changed bytes underlined, its unknown ones as ??."""
        for start, length in unknown:
            first, after = _BYTE * start, _BYTE * (start + length)
            self._hex = self._hex[:first] + " ??" * length + self._hex[after:]
        lines: list[Spans] = [[self._gutter]]
        last = max(at + size - 1, at) // ROW
        rows = range(min(max(at // ROW - 1, 0), max(self._rows_in_all - MOST_ROWS, 0)), self._rows_in_all)
        for number in rows[:MOST_ROWS]:
            row, under = self._row(number * ROW, at, at + size, Role.NAME, "")
            lines += [row, under] if at // ROW <= number <= last else [row]
        if len(rows) > MOST_ROWS:
            lines.append([("...".rjust(self._width) + " | ...", Role.GUTTER)])
        message = self._message
        names = [operation.full_name for operation in self._operations or ()]
        if isinstance(message, SystemCommand) and message.command is not None:
            names.append(message.command)
        if names:
            lines.append([(f"{self.margin} = {_cut(', '.join(names), _MOST_OPERATION)}", Role.ASIDE)])
        return lines

    @property
    def _rows_in_all(self) -> int:
        return -(-self._size // ROW)

    def show(self, finding: Finding, role: str) -> list[Spans]:
        """Returns the rows with a finding's bytes underlined, and the meaning of the bytes and of their operation."""
        lines: list[Spans] = [[self._gutter], *self._rows(finding, role)] if self._size else []
        text = self._decoded(finding)
        if text:
            lines.append([(f"{self.margin} = {text}", Role.ASIDE)])
        return lines

    def _rows(self, finding: Finding, role: str) -> list[Spans]:
        lines: list[Spans] = []
        size, start = self._size, min(finding.offset, self._size)
        end = start + (finding.length or 1)
        # A span after the last byte is shown where the next byte would be.
        if end > size:
            end = size if size > start else start + 1
        last = (end - 1) // ROW if end - 1 < size or start % ROW else (start - 1) // ROW
        first = min(start // ROW, last)
        before = range(first, last)
        for number in before[: MOST_ROWS - 1]:
            lines += self._row(number * ROW, start, end, role, "")
        if len(before) >= MOST_ROWS:
            lines.append([("...".rjust(self._width) + " | ...", Role.GUTTER)])
        return [*lines, *self._row(last * ROW, start, end, role, self._label(finding))]

    def _row(self, row: int, start: int, end: int, role: str, label: str) -> tuple[Spans, Spans]:
        """Returns a row of bytes, and the line under a span of it."""
        digits, stop = self._hex, _BYTE * (row + ROW)
        # Bytes missing after a full row are marked after that row.
        first, after = _BYTE * max(start, row), _BYTE * min(end, row + ROW)
        marks = "^" * (max(after - first, _BYTE) - 1)
        row_line = [
            # The plus keeps readers of pasted frames from taking the row for one.
            (f"{f'+{row}'.rjust(self._width)} |", Role.GUTTER),
            (digits[_BYTE * row : min(first, stop)], Role.PLAIN),
            (digits[first:after], role),
            (digits[max(after, first) : stop], Role.PLAIN),
        ]
        under = [
            self._gutter,
            (" " * (first - _BYTE * row + 1), Role.PLAIN),
            (marks, role),
            (f" {label}" if label else "", Role.PLAIN),
        ]
        return row_line, under

    def _label(self, finding: Finding) -> str:
        """Returns the meaning of a span's bytes: `VOLUME = 200 %`."""
        span = finding.offset, finding.length
        if not finding.length:
            return ""
        if finding.offset < COMMAND_HEADER_SIZE:
            return self._header(finding.offset)
        operation = self._operation_at(finding.offset)
        if operation is None:
            return ""
        if span == (operation.offset, operation.length):
            return _cut(operation.full_name, _MOST_LABEL)
        for argument in operation.arguments:
            if span == (argument.offset, argument.length):
                return _cut(_said(argument), _MOST_LABEL)
        cmd = operation.cmd
        if cmd is not None and span == (cmd.offset, cmd.length):
            return _cut(f"CMD = {cmd.value} {operation.command}", _MOST_LABEL)
        return ""

    def _header(self, offset: int) -> str:
        message = self._message
        if self._size < HEADER_SIZE:
            return ""
        if offset < LENGTH_FIELD:
            return f"length = {message.length}, {self._size - LENGTH_FIELD} bytes follow"
        if offset < LENGTH_FIELD + COUNTER_SIZE:
            return f"counter = {message.counter}"
        if offset < HEADER_SIZE:
            return f"type = {'?' if message.type is None else message.type.name}"
        if isinstance(message, DirectCommand) and offset < HEADER_SIZE + MEMORY_SIZE:
            return f"memory: {message.global_size} bytes global, {message.local_size} bytes local"
        return ""

    def _decoded(self, finding: Finding) -> str:
        """Returns what the span belongs to: an operation, or the whole command."""
        message, offset = self._message, finding.offset
        if self._operations is None:
            if message.type is None or offset < HEADER_SIZE:
                return ""
            return _cut(plain_text(command_spans(message)), _MOST_OPERATION)
        operation = self._operation_at(offset)
        if not finding.length and (operation is None or operation.full_name != finding.operation):
            # Bytes missing at the end of an operation are reported where the next one starts.
            operation = self._operation_at(offset - 1)
        if operation is None:
            return ""
        # One operation may have a thousand arguments and dozens of findings.
        line = self._lines.get(operation.offset)
        if line is None:
            line = self._lines[operation.offset] = _cut(operation_line(operation), _MOST_OPERATION)
        return line

    def _operation_at(self, offset: int) -> Operation | None:
        number = bisect_right(self._starts, offset) - 1
        if number < 0:
            return None
        assert self._operations is not None
        operation = self._operations[number]
        # The unread rest of an operation that is cut short also belongs to it.
        is_there = offset < operation.offset + operation.length or not operation.is_complete
        return operation if is_there else None


def _said(argument: Argument) -> str:
    meaning = argument_meaning(argument)
    return f"{argument.name} = {argument_value(argument)}{f' {meaning}' if meaning else ''}"


def _cut(text: str, most: int) -> str:
    return text if len(text) <= most else f"{text[: most - 3]}..."


MOST_ALIKE = 4
"""Findings with the same code shown in full for one frame; the others are listed by offset."""

_WORST = list(Severity)
_MOST_OFFSETS = 12
_TEXT_WIDTH = 100

ROLES = {Severity.ERROR: Role.FAULT, Severity.WARNING: Role.VALUE, Severity.HINT: Role.MEANING}
"""The style of each severity."""


def _verdict(report: Report) -> str:
    """Returns `the brick refuses it at offset 9`."""
    if report.accepted:
        return "the brick accepts it"
    if report.rejected_at is None:
        return "the brick refuses it"
    return f"the brick refuses it at offset {report.rejected_at}"


def tally(findings: Iterable[Finding]) -> str:
    """Returns `2 errors, 1 hint`, or `no findings`."""
    found = [finding.severity for finding in findings]
    return ", ".join([counted(found.count(one), one) for one in _WORST if one in found]) or "no findings"


def diagnostics(
    report: Report,
    findings: Sequence[Finding] | None = None,
    *,
    place: str = "",
    dialect: str = "official",
    nearest: Sequence[Suggestion] | None = None,
    is_complete: bool = False,
) -> Iterator[Line]:
    """Yields the verdict, what was probably meant, then every finding with its bytes.

    findings     those to show; None for all
    place        shown in front of every offset
    nearest      the suggestions to show; None for those of the report
    is_complete  whether also findings that a sure suggestion resolves are shown
    """
    shown = report.findings if findings is None else findings
    meant = report.nearest if nearest is None else nearest
    if not is_complete:
        shown = unresolved(report, shown, meant)
    yield _verdict_line(report, place, len(report.findings) - len(shown))
    for number, one in enumerate(meant):
        yield Line()
        yield from _did_you_mean(report.frame, one, "or" if number else "did you mean", dialect)
    if not shown:
        return
    excerpt = Excerpt(report.frame, dialect)
    kept, left = _without_repetitions(shown)
    for _, together in groupby(kept, attrgetter("offset", "length")):
        yield Line()
        yield from _on_one_span(list(together), excerpt, place)
    if left:
        yield Line()
        yield from map(_repeated, left)


def _verdict_line(report: Report, place: str, hidden: int) -> Line:
    where = [(f"{place}: ", Role.HEADING)] if place else []
    if report.accepted and not report.findings:
        return Line([*where, ("accepted", Role.NAME), (": no findings", Role.PLAIN)], 0, len(report.frame))
    verdict = [
        *where,
        (_verdict(report), Role.NAME if report.accepted else Role.FAULT),
        (f"; {tally(report.findings)}", Role.PLAIN),
        (f" ({hidden} not shown)" if hidden else "", Role.ASIDE),
    ]
    return Line(verdict, 0, len(report.frame))


def _repeated(alike: Sequence[Finding]) -> Line:
    """Returns a line about findings that say the same as one above."""
    offsets = ", ".join(str(finding.offset) for finding in alike[:_MOST_OFFSETS])
    more = ", ..." if len(alike) > _MOST_OFFSETS else ""
    said = f": and {len(alike)} more of these, at offsets {offsets}{more}"
    return Line([_mark(alike[0]), (said, Role.PLAIN)], code=alike[0].code)


def unresolved(report: Report, findings: Sequence[Finding], nearest: Sequence[Suggestion]) -> Sequence[Finding]:
    """Returns the findings that a sure suggestion does not resolve, and the one for which the brick refuses a frame.

    Of an unsure one, only the hints are left out that it resolves: they would advise something else.
    """
    if len(nearest) != 1:
        return findings
    after = check(nearest[0].frame, dialect=report.dialect, carrier=report.carrier, alone=report.alone)
    kept = {(one.code, one.operation, one.parameter) for one in after.findings}
    at = report.rejected_at or 0
    causes = () if report.accepted else report.errors
    cause = min(causes, key=lambda one: one.offset < at, default=None)
    left = [one for one in findings if one is cause or (one.code, one.operation, one.parameter) in kept]
    return left if nearest[0].is_sure else [one for one in findings if one in left or one.severity is not Severity.HINT]


def _did_you_mean(frame: bytes, one: Suggestion, head: str, dialect: str) -> Iterator[Line]:
    at, _, new = difference(frame, one.frame)
    yield Line([(f"{head}: ", Role.NAME), (one.message, Role.HEADING)], one.offset, one.length)
    for spans in Excerpt(one.frame, dialect).meant(at, len(new), one.unknown):
        yield Line(spans, one.offset, one.length)


def fixed(
    fix: Fix,
    findings: Sequence[Finding] | None = None,
    *,
    place: str = "",
    dialect: str = "official",
    is_written: bool = True,
) -> Iterator[Line]:
    """Yields the fixed frame, the changes, what was left unchanged, and then the findings that remain.

    findings, place  as for `diagnostics`
    is_written       False for a frame in a text that stays as it was
    """
    line = Line([(f"{place}: ", Role.HEADING)] if place else [])
    count = len(fix.changes)
    if count:
        line.append((f"{'' if is_written else 'could be '}fixed in {counted(count, 'place')}", Role.NAME))
    else:
        line.append(("nothing could be fixed" if fix.report.findings else "nothing to fix", Role.PLAIN))
    yield line
    yield Line([(grouped_hex(fix.frame, dialect), Role.HEADING)])
    if not is_written:
        yield Line([("  the text is unchanged here: its notation cannot be edited", Role.FAULT)])
    for change in fix.changes:
        edit = f"{change.before} -> {change.after}"
        yield Line([(f"  {change.what}: ", Role.NAME), (edit, Role.VALUE), (f" ({change.why})", Role.ASIDE)])
    for reason in fix.unfixed:
        yield Line([("  not fixed: ", Role.FAULT), (reason, Role.PLAIN)])
    if count:
        place = f"{place}, fixed" if place else "fixed"
    yield from diagnostics(fix.report, findings, place=place, dialect=dialect, nearest=())


def explanation(code: FindingCode, found: Iterable[Line], shown: Callable[[bytes], str]) -> Iterator[Line]:
    """Yields the explanation of a code, with its examples as `shown` writes bytes, and what is found in the first."""
    yield Line([(f"{code.severity}[{code.code}]", ROLES[code.severity]), (f": {code.title}", Role.HEADING)])
    yield Line()
    for paragraph in code.explanation.split("\n\n"):
        for text in wrap(" ".join(paragraph.split()), _TEXT_WIDTH):
            yield Line([(text, Role.PLAIN)])
        yield Line()
    yield Line([("example: ", Role.ASIDE), (shown(code.example), Role.VALUE)])
    yield from found
    yield Line()
    yield Line([("without it: ", Role.ASIDE), (shown(code.counterexample), Role.VALUE)])


def grouped_hex(frame: bytes, dialect: str = "official") -> str:
    """Returns a frame as the lesson prints it, argument by argument: `0x|0E:00|2A:00|80|00:00|94|01|01|82:B8:01|`."""
    cuts = sorted({0, *_cuts(read_last(frame, dialect), len(frame)), len(frame)})
    digits = frame.hex(":").upper()
    return "|".join(["0x", *[digits[3 * start : 3 * end - 1] for start, end in pairwise(cuts)], ""])


def _cuts(message: Message, size: int) -> list[int]:
    """Returns the offsets at which the groups of a frame start."""
    starts = [LENGTH_FIELD, LENGTH_FIELD + COUNTER_SIZE, HEADER_SIZE]
    if isinstance(message, DirectCommand):
        starts.append(COMMAND_HEADER_SIZE)
        for operation in message.operations:
            at = operation.offset
            starts += [at, at + 1]
            starts += [argument.offset for argument in operation.arguments]
            starts.append(at + operation.length)
    elif message.type is not None:
        starts.append(HEADER_SIZE + 1)
    return [start for start in starts if start <= size]


def _without_repetitions(findings: Sequence[Finding]) -> tuple[list[Finding], list[list[Finding]]]:
    """Splits findings into those to show, and, by code, those that repeat earlier ones often enough."""
    by_code: dict[str, list[Finding]] = {}
    for finding in findings:
        by_code.setdefault(finding.code, []).append(finding)
    # A single leftover finding is shown: a line that says there is one more would be as long.
    left = [alike[MOST_ALIKE:] for alike in by_code.values() if len(alike) > MOST_ALIKE + 1]
    repeated = {id(finding) for alike in left for finding in alike}
    kept = [finding for finding in findings if id(finding) not in repeated]
    return kept, sorted(left, key=lambda alike: alike[0].offset)


def _on_one_span(findings: list[Finding], excerpt: Excerpt, place: str) -> list[Line]:
    """Returns the findings of one span. Help that several of them share is given once."""
    first = findings[0]
    offset, length = first.offset, first.length
    lines = [Line([_mark(one), (f": {one.message}", Role.HEADING)], offset, length, one.code) for one in findings]
    about = " of ".join(filter(None, (first.parameter, first.operation)))
    where = f"offset {first.offset}{f', {about}' if about else ''}"
    arrow = [(f"{excerpt.margin}--> ", Role.ASIDE), (f"{place}, {where}" if place else where, Role.PLAIN)]
    shown = excerpt.show(first, ROLES[min([one.severity for one in findings], key=_WORST.index)])
    lines += [Line(spans, offset, length, first.code) for spans in (arrow, *shown)]
    helps: dict[str, str] = {}
    for finding in findings:
        helps.setdefault(finding.help, finding.code)
    for help_, code in helps.items():
        word = f"help for {code}: " if len(helps) > 1 else "help: "
        spans = [(f"{excerpt.margin} = ", Role.ASIDE), (word, Role.OPERATION), (help_, Role.PLAIN)]
        lines.append(Line(spans, offset, length, code))
    return lines


def _mark(finding: Finding) -> Span:
    """Returns `error[E301]`."""
    return f"{finding.severity}[{finding.code}]", ROLES[finding.severity]


def report_text(report: Report) -> str:
    """Returns what `ev3proto check` prints about a frame."""
    return "\n".join(map(plain_text, diagnostics(report, dialect=report.dialect)))


def described_fix(fix: Fix) -> str:
    """Returns what `ev3proto check --fix` prints about a frame."""
    return "\n".join(map(plain_text, fixed(fix, dialect=fix.report.dialect)))
