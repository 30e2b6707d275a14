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

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby, pairwise
from operator import attrgetter
from textwrap import wrap

from ev3proto.checking.codes import Code
from ev3proto.checking.report import Finding, Fix, Report, Severity, uses
from ev3proto.errors import counted
from ev3proto.messages import DirectCommand, Message
from ev3proto.schema.frame import read_last
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE
from ev3proto.tables.frame import COUNTER_SIZE, LENGTH_FIELD
from ev3proto.text.excerpt import Excerpt
from ev3proto.text.spans import Line, Role, Span, plain_text

MOST_ALIKE = 4
"""Findings with the same code that are shown of one frame; of the others, only the offsets are listed."""

_WORST = list(Severity)
_MOST_OFFSETS = 12
_TEXT_WIDTH = 100

ROLES = {Severity.ERROR: Role.FAULT, Severity.WARNING: Role.VALUE, Severity.HINT: Role.MEANING}
"""How each severity looks."""


def _verdict(report: Report) -> str:
    """`the brick refuses it at offset 9`."""
    if report.accepted:
        return "the brick accepts it"
    if report.rejected_at is None:
        return "the brick refuses it"
    return f"the brick refuses it at offset {report.rejected_at}"


def tally(findings: Iterable[Finding]) -> str:
    """`2 errors, 1 hint`, or `no findings`."""
    counts = Counter(finding.severity for finding in findings)
    return ", ".join(counted(counts[one], one) for one in Severity if counts[one]) or "no findings"


def diagnostics(
    report: Report, findings: Sequence[Finding] | None = None, *, place: str = "", dialect: str = "official"
) -> Iterator[Line]:
    """The verdict, then every finding with its bytes.

    Args:
        report: What a check found.
        findings: Those to show, in the order of their offsets; without them all of the report's.
        place: Where the frame comes from, such as `robot.log, line 3`; it stands in front of every offset.
        dialect: The firmware whose instruction set the frame is read by.

    Yields:
        Lines; what belongs together has an empty line before it.

    """
    shown = report.findings if findings is None else findings
    where: Line = [(f"{place}: ", Role.HEADING)] if place else []
    if report.accepted and not report.findings:
        yield [*where, ("accepted", Role.NAME), (": no findings", Role.PLAIN)]
        return
    hidden = len(report.findings) - len(shown)
    yield [
        *where,
        (_verdict(report), Role.NAME if report.accepted else Role.FAULT),
        (f"; {tally(report.findings)}", Role.PLAIN),
        (f" ({hidden} not shown)" if hidden else "", Role.ASIDE),
    ]
    if not shown:
        return
    excerpt = Excerpt(report.frame, dialect)
    kept, left = _without_repetitions(shown)
    for _, together in groupby(kept, attrgetter("offset", "length")):
        yield []
        yield from _on_one_span(list(together), excerpt, place)
    if left:
        yield []
    for alike in left:
        offsets = ", ".join(str(finding.offset) for finding in alike[:_MOST_OFFSETS])
        more = ", ..." if len(alike) > _MOST_OFFSETS else ""
        yield [
            _mark(alike[0]),
            (f": and {len(alike)} more of these, at offsets {offsets}{more}", Role.PLAIN),
        ]


def fixed(
    fix: Fix, findings: Sequence[Finding] | None = None, *, place: str = "", dialect: str = "official"
) -> Iterator[Line]:
    """The fixed frame, what was changed in it, what was left, and then what a check says of it.

    findings, place  as `diagnostics` takes them
    """
    line: Line = [(f"{place}: ", Role.HEADING)] if place else []
    count = len(fix.changes)
    if count:
        line.append((f"fixed in {counted(count, 'place')}", Role.NAME))
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
    cuts = sorted({0, *_cuts(read_last(frame, dialect), len(frame)), len(frame)})
    digits = frame.hex(":").upper()
    return "|".join(["0x", *[digits[3 * start : 3 * end - 1] for start, end in pairwise(cuts)], ""])


def _cuts(message: Message, size: int) -> list[int]:
    """Where the groups of a frame start."""
    starts = [LENGTH_FIELD, LENGTH_FIELD + COUNTER_SIZE, HEADER_SIZE]
    if isinstance(message, DirectCommand):
        starts.append(COMMAND_HEADER_SIZE)
        for operation in message.operations:
            at = operation.offset
            starts += [at, at + 1]
            starts += [argument[3] for argument in operation.arguments]
            starts.append(at + operation.length)
    elif message.type is not None:
        starts.append(HEADER_SIZE + 1)
    return [start for start in starts if start <= size]


def _without_repetitions(findings: Sequence[Finding]) -> tuple[list[Finding], list[list[Finding]]]:
    """The findings to show, and by code those that repeat what was shown often enough."""
    counts = Counter(finding.code for finding in findings)
    seen: Counter[str] = Counter()
    kept: list[Finding] = []
    left: dict[str, list[Finding]] = {}
    for finding in findings:
        seen[finding.code] += 1
        # One that is left over is not worth a line that says that there is one more.
        if seen[finding.code] <= MOST_ALIKE or counts[finding.code] <= MOST_ALIKE + 1:
            kept.append(finding)
        else:
            left.setdefault(finding.code, []).append(finding)
    return kept, list(left.values())


def _on_one_span(findings: list[Finding], excerpt: Excerpt, place: str) -> list[Line]:
    """The lines of the findings on one span of bytes. Help that several of them have is given once."""
    lines: list[Line] = [[_mark(finding), (f": {finding.message}", Role.HEADING)] for finding in findings]
    first = findings[0]
    about = " of ".join(filter(None, (first.parameter, first.operation)))
    where = f"offset {first.offset}{f', {about}' if about else ''}"
    lines.append([(f"{excerpt.margin}--> ", Role.ASIDE), (f"{place}, {where}" if place else where, Role.PLAIN)])
    worst = min((finding.severity for finding in findings), key=_WORST.index)
    lines += excerpt.show(first, ROLES[worst])
    helps: dict[str, str] = {}
    for finding in findings:
        helps.setdefault(finding.help, finding.code)
    for help_, code in helps.items():
        word = f"help for {code}: " if len(helps) > 1 else "help: "
        lines.append([(f"{excerpt.margin} = ", Role.ASIDE), (word, Role.OPERATION), (help_, Role.PLAIN)])
    return lines


def _mark(finding: Finding) -> Span:
    """`error[E301]`."""
    return f"{finding.severity}[{finding.code}]", ROLES[finding.severity]


def _report_text(report: Report) -> str:
    return "\n".join(map(plain_text, diagnostics(report, dialect=report.dialect)))


def _fix_text(fix: Fix) -> str:
    return "\n".join(map(plain_text, fixed(fix, dialect=fix.report.dialect)))


uses.report_text, uses.fix_text = _report_text, _fix_text
