"""What the check of an input found: frames with errors first, then those with warnings, then those with hints."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from itertools import groupby, pairwise
from typing import Any, NamedTuple

from ev3proto.capture.record import Record
from ev3proto.checking.checking import check
from ev3proto.checking.report import Report, Severity
from ev3proto.errors import counted
from ev3proto.program.report import ProgramReport, program_findings
from ev3proto.text.diagnostics import diagnostics
from ev3proto.text.spans import Line, Role

from .words import ALL_CODES, pieces

MOST_FRAMES = 100
"""Maximum number of frames of each severity whose findings are shown."""


class Checked(NamedTuple):
    """A frame with findings.

    number  of the frame
    place   its place in the input, empty for a frame alone
    line    of the text, 0 for none
    """

    number: int
    place: str
    line: int
    report: Report


class Findings:
    """The findings in all frames, as they are read.

    checked     the number of frames for the brick
    count       the number of those whose worst finding has a severity
    refused     the number of those that it refuses
    replies     the number of frames from the brick, which are not checked
    failed      the number of those that say that a command failed
    faulty      the number of those with a fault, or with bytes after them
    program     the report on the program, whose image is frame 0
    """

    def __init__(self) -> None:
        self.checked = self.refused = 0
        self.replies = self.failed = self.faulty = 0
        self.count: Counter[Severity] = Counter()
        self.program: ProgramReport | None = None
        self._frames: dict[Severity, list[Checked]] = {severity: [] for severity in Severity}
        self._last: Checked | None = None
        self._others: list[tuple[str, Severity]] = []

    def frame(self, frame: bytes, number: int, place: str, line: int, *, carrier: str | None = None) -> None:
        """Checks a frame."""
        report = check(frame, carrier=carrier)
        self._last = checked = Checked(number, place, line, report)
        self.checked += 1
        self.refused += not report.accepted
        if not report.findings:
            return
        worst = next(severity for severity in Severity if report.of(severity))
        self.count[worst] += 1
        if self.count[worst] <= MOST_FRAMES:
            self._frames[worst].append(checked)

    def reply(self, record: Record, place: str) -> None:
        """Takes a frame from the brick."""
        message, rest = record.message, record.rest if any(record.rest) else b""
        self.replies += 1
        self.failed += message.type is not None and message.type.is_error
        self.faulty += message.fault is not None or bool(rest)
        if place and message.fault is not None:
            self.say(f"{place}: {message.fault.reason}", Severity.ERROR)

    def say(self, sentence: str, severity: Severity) -> None:
        """Takes a sentence about the input that no check makes."""
        self._others.append((sentence, severity))

    @property
    def frames(self) -> list[Checked]:
        """The frames with findings that are shown, the worst first."""
        if self._last is not None and self.checked == 1 and not self.replies:
            # A frame by itself gets more hints.
            report = self._last.report
            alone = check(report.frame, carrier=report.carrier, alone=True)
            return [self._last._replace(report=alone)] if alone.findings else []
        return [each for severity in Severity for each in self._frames[severity]]

    def answer(self) -> list[dict[str, Any]]:
        """Returns the findings for JSON: each with lines, severity, codes, frame, line of the text, offset, length."""
        shown = [_block([Line([(text, Role.PLAIN)])], None, severity) for text, severity in self._others]
        shown += [] if self.program is None else _program_blocks(self.program)
        for each in self.frames:
            shown += _blocks(each)
        for severity in Severity:
            if (left := self.count[severity] - MOST_FRAMES) > 0:
                text = f"... and {counted(left, 'more frame')} with {severity}s"
                shown.append(_block([Line([(text, Role.ASIDE)])], None))
        return shown


def _blocks(checked: Checked) -> Iterator[dict[str, Any]]:
    """Yields each group of the findings in a frame."""
    lines = list(diagnostics(checked.report, place=checked.place, nearest=()))
    # The verdict comes first, which the headline has.
    starts = [at for at, line in enumerate(lines) if not line]
    for start, end in pairwise([*starts, len(lines)]):
        yield _block(lines[start + 1 : end], checked)


def _program_blocks(report: ProgramReport) -> Iterator[dict[str, Any]]:
    checked = Checked(0, "", 0, report)
    found = (line for line in program_findings(report, report.findings) if line.code)
    for _, lines in groupby(found, lambda line: (line.code, line.offset)):
        yield _block(lines, checked)


def _block(lines: Iterable[Line], checked: Checked | None, severity: str = "") -> dict[str, Any]:
    """Returns lines with what they are about: a finding, by its code and offset, or the whole frame."""
    shown = list(lines)
    at, length = 0, 0 if checked is None else len(checked.report.frame)
    about = next((line for line in shown if line.code), None)
    if about is not None and about.offset is not None:
        at, length = about.offset, about.length or 1
        severity = ALL_CODES[about.code].severity
    return {
        "lines": [pieces(line) for line in shown],
        "severity": severity,
        "codes": list(dict.fromkeys(line.code for line in shown if line.code)),
        "frame": -1 if checked is None else checked.number,
        "line": 0 if checked is None else checked.line,
        "offset": at,
        "length": length,
    }
