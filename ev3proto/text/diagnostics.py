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
from functools import lru_cache
from itertools import groupby, pairwise
from operator import attrgetter
from textwrap import wrap
from typing import TYPE_CHECKING

from ev3proto.checking.report import Finding, Report, Severity
from ev3proto.errors import counted
from ev3proto.messages import DirectCommand, Message
from ev3proto.schema.frame import read_last
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE
from ev3proto.tables.frame import COUNTER_SIZE, LENGTH_FIELD
from ev3proto.text.excerpt import Excerpt
from ev3proto.text.spans import Line, Role, Span, plain_text

if TYPE_CHECKING:
    from ev3proto.checking.codes import Code
    from ev3proto.checking.fixing import Fix

MOST_ALIKE = 4
"""Findings with the same code that are shown of one frame; of the others, only the offsets are listed."""

_MOST_OFFSETS = 12
_MOST_COUNTS = 256
_TEXT_WIDTH = 100
_SEVERITIES = tuple(Severity)

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
    severities = [finding.severity for finding in findings]
    return _counts(*[severities.count(severity) for severity in _SEVERITIES])


@lru_cache(_MOST_COUNTS)
def _counts(*numbers: int) -> str:
    """The numbers of findings of each severity in words. Most frames have few, so that they are like one another."""
    counts = [counted(count, severity) for count, severity in zip(numbers, _SEVERITIES, strict=True)]
    return ", ".join(text for count, text in zip(numbers, counts, strict=True) if count) or "no findings"


def diagnostics(
    report: Report, findings: Sequence[Finding] | None = None, *, place: str = "", dialect: str = "official"
) -> list[Line]:
    """The verdict, then every finding with its bytes.

    Args:
        report: What a check found.
        findings: Those to show, in the order of their offsets; without them all of the report's.
        place: Where the frame comes from, such as `robot.log, line 3`; it stands in front of every offset.
        dialect: The firmware whose instruction set the frame is read by.

    Returns:
        Lines; what belongs together has an empty line before it.

    """
    shown = report.findings if findings is None else tuple(findings)
    lines = [_summary(report, len(shown), place)]
    if not shown or _is_fine(report):
        return lines
    excerpt = Excerpt(report.frame, dialect)
    kept, left = _without_repetitions(shown)
    for _, together in groupby(kept, _SPAN):
        lines.append([])
        _add_together(list(together), excerpt, place, lines)
    if left:
        lines.append([])
        lines += map(_repetitions, left)
    return lines


def diagnostics_texts(
    report: Report, findings: Sequence[Finding] | None = None, *, place: str = "", dialect: str = "official"
) -> list[str]:
    """The same lines as texts.

    They are written as texts from the start, which takes a third less time than joining spans.
    """
    shown = report.findings if findings is None else tuple(findings)
    if not shown or _is_fine(report):
        return [plain_text(_summary(report, len(shown), place))]
    texts = [
        f"{f'{place}: ' if place else ''}{_verdict(report)}; {tally(report.findings)}{_hidden(report, len(shown))}"
    ]
    excerpt = Excerpt(report.frame, dialect)
    kept, left = _without_repetitions(shown)
    _add_texts(kept, excerpt, place, texts)
    if left:
        texts.append("")
        texts += [plain_text(_repetitions(alike)) for alike in left]
    return texts


def _is_fine(report: Report) -> bool:
    return report.accepted and not report.findings


def _summary(report: Report, shown: int, place: str) -> Line:
    """The verdict, and what was found. `shown` is the number of findings that follow."""
    line: Line = [(f"{place}: ", Role.HEADING)] if place else []
    if _is_fine(report):
        return [*line, ("accepted", Role.NAME), (": no findings", Role.PLAIN)]
    return [
        *line,
        (_verdict(report), Role.NAME if report.accepted else Role.FAULT),
        (f"; {tally(report.findings)}", Role.PLAIN),
        (_hidden(report, shown), Role.ASIDE),
    ]


def _hidden(report: Report, shown: int) -> str:
    hidden = len(report.findings) - shown
    return f" ({hidden} not shown)" if hidden else ""


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
    if len(findings) <= MOST_ALIKE:
        return list(findings), []
    codes = [finding.code for finding in findings]
    if len(codes) - len(set(codes)) <= MOST_ALIKE:
        # However they are shared out, no code has more findings than one and all those that are left over.
        return list(findings), []
    # One that is left over is not worth a line that says that there is one more.
    seen = {code: 0 for code, count in Counter(codes).items() if count > MOST_ALIKE + 1}
    if not seen:
        return list(findings), []
    kept: list[Finding] = []
    left: dict[str, list[Finding]] = {}
    for finding, code in zip(findings, codes, strict=True):
        if code in seen:
            seen[code] += 1
            if seen[code] > MOST_ALIKE:
                left.setdefault(code, []).append(finding)
                continue
        kept.append(finding)
    return kept, list(left.values())


_SPAN = attrgetter("offset", "length")


def _repetitions(alike: list[Finding]) -> Line:
    first = alike[0]
    offsets = ", ".join(str(finding.offset) for finding in alike[:_MOST_OFFSETS])
    more = ", ..." if len(alike) > _MOST_OFFSETS else ""
    return [
        _mark(first),
        (f": and {len(alike)} more of these, at offsets {offsets}{more}", Role.PLAIN),
    ]


def _add_together(findings: list[Finding], excerpt: Excerpt, place: str, lines: list[Line]) -> None:
    """Adds the lines of the findings on one span of bytes."""
    first = findings[0]
    for finding in findings:
        lines.append([_mark(finding), (f": {finding.message}", Role.HEADING)])
    where = f"offset {first.offset}{_about(first)}"
    lines.append([(f"{excerpt.margin}--> ", Role.ASIDE), (f"{place}, {where}" if place else where, Role.PLAIN)])
    worst = first.severity if len(findings) == 1 else min((it.severity for it in findings), key=_SEVERITIES.index)
    excerpt.show(first, ROLES[worst], lines)
    for word, help_ in _helps(findings):
        lines.append([(f"{excerpt.margin} = ", Role.ASIDE), (word, Role.OPERATION), (help_, Role.PLAIN)])


def _add_texts(findings: list[Finding], excerpt: Excerpt, place: str, texts: list[str]) -> None:
    """Adds the same lines of all findings as texts.

    This is half of the time that `check` takes for a capture, so that it makes no calls that it can do without.
    """
    margin = excerpt.margin
    before = f"{margin}--> {place}, offset " if place else f"{margin}--> offset "
    for (offset, _), group in groupby(findings, _SPAN):
        first, *others = group
        operation, parameter, code = first.operation, first.parameter, first.code
        texts += ("", f"{_MARKS.get(code) or _mark_text(first)}{first.message}".rstrip())
        for finding in others:
            texts.append(f"{_mark_text(finding)}{finding.message}".rstrip())
        if operation is not None and parameter is not None:
            texts.append(f"{before}{offset}, {parameter} of {operation}")
        else:
            texts.append(f"{before}{offset}{_about(first)}".rstrip())
        texts += excerpt.texts(first)
        if not others:
            texts.append(f"{margin} = help: {first.help}".rstrip())
            continue
        for word, help_ in _helps([first, *others]):
            texts.append(f"{margin} = {word}{help_}".rstrip())


def _helps(findings: list[Finding]) -> list[tuple[str, str]]:
    """What stands before the help of each finding, and the help; one that several have is given once."""
    if len(findings) == 1:
        return [("help: ", findings[0].help)]
    helps: dict[str, str] = {}
    for finding in findings:
        helps.setdefault(finding.help, finding.code)
    return [(f"help for {code}: " if len(helps) > 1 else "help: ", help_) for help_, code in helps.items()]


def _mark(finding: Finding) -> Span:
    """`error[E301]`."""
    return f"{finding.severity!s}[{finding.code}]", ROLES[finding.severity]


_MARKS: dict[str, str] = {}
"""What stands before the message of a finding, by its code."""


def _mark_text(finding: Finding) -> str:
    return _MARKS.get(finding.code) or _MARKS.setdefault(finding.code, f"{_mark(finding)[0]}: ")


def _about(finding: Finding) -> str:
    """`, VOLUME of SOUND.TONE`."""
    operation, parameter = finding.operation, finding.parameter
    if operation is None and parameter is None:
        return ""
    if operation is None or parameter is None:
        return f", {operation or parameter}"
    return f", {parameter} of {operation}"
