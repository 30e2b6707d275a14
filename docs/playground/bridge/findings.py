"""What the check of an input found: frames with errors first, then those with warnings, then the accepted ones."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import groupby
from typing import Any, NamedTuple

from ev3proto.checking.checking import check
from ev3proto.checking.codes import CODES
from ev3proto.checking.fixing import fix
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.checking.report import Report, Severity
from ev3proto.errors import counted
from ev3proto.program.report import ProgramReport, program_findings
from ev3proto.text.diagnostics import diagnostics
from ev3proto.text.spans import Line, Role
from ev3proto.text.verdict import REFUSES, TAKES, TAKES_BUT, verdict

from .rows import pieces

MOST_FRAMES = 100
"""Maximum number of frames of each severity whose findings are shown."""

MOST_ACCEPTED = 1000
"""Maximum number of accepted frames that are listed."""

SUGGESTION = "suggestion"
"""In place of a severity: what was meant."""

_SEVERITIES = tuple(Severity)


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
    """The findings in all frames, as they are read."""

    def __init__(self) -> None:
        self._checked = self._skipped = self._accepted = 0
        self._counts = dict.fromkeys(_SEVERITIES, 0)
        self._frames: dict[Severity, list[Checked]] = {severity: [] for severity in _SEVERITIES}
        self._left_out = dict.fromkeys(_SEVERITIES, 0)
        self._accepted_places: list[str] = []
        self._programs: list[ProgramReport] = []
        self._warnings: list[str] = []

    def frame(self, frame: bytes, number: int, place: str, line: int, *, carrier: str | None = None) -> None:
        """Checks a frame."""
        self._checked += 1
        report = check(frame, carrier=carrier)
        found = [finding.severity for finding in report.findings]
        for severity in found:
            self._counts[severity] += 1
        if report.accepted and not found:
            self._accepted += 1
            if self._accepted <= MOST_ACCEPTED:
                self._accepted_places.append(place)
            return
        worst = min(found, key=_SEVERITIES.index, default=Severity.ERROR)
        if len(self._frames[worst]) < MOST_FRAMES:
            self._frames[worst].append(Checked(number, place, line, report))
        else:
            self._left_out[worst] += 1

    def reply(self) -> None:
        """Counts a frame that is not checked: it comes from the brick."""
        self._skipped += 1

    def program(self, report: ProgramReport) -> None:
        """Takes the report on a program, whose image is frame 0."""
        self._programs.append(report)

    def warn(self, sentences: Iterable[str]) -> None:
        """Takes the warnings about a program's source."""
        self._warnings += sentences

    @property
    def frames(self) -> list[Checked]:
        """The frames with findings that are shown, the worst first."""
        return [each for severity in _SEVERITIES for each in self._frames[severity]]

    @property
    def is_fixable(self) -> bool:
        """Whether a fix of one of these frames changes anything."""
        return any(fix(each.report.frame, carrier=each.report.carrier).changes for each in self.frames)

    def answer(self) -> dict[str, Any]:
        """Returns what is shown, for JSON.

        summary   of many frames
        verdict   what the brick makes of it: its kind (see `ev3proto.text.verdict`; empty for none) and a sentence
        blocks    each finding, or verdict, with its lines, severity, code, frame, line of the text, offset, length
        accepted  the number of accepted frames among many
        places    where they are
        """
        is_alone = self._checked == 1 and not self._skipped
        blocks: list[dict[str, Any]] = []
        if self._warnings:
            lines = [Line([(line, Role.PLAIN)]) for line in self._warnings]
            blocks.append(_block(lines, None, "warning"))
        for report in self._programs:
            blocks += _program_blocks(report)
        for each in self.frames:
            blocks += _blocks(each)
        for severity, count in self._left_out.items():
            if count:
                text = f"... and {counted(count, 'more frame')} with {severity}s"
                blocks.append(_block([Line([(text, Role.ASIDE)])], None))
        if is_alone and self._accepted:
            line = Line([("accepted", Role.NAME), (": no findings", Role.PLAIN)])
            blocks.append(_block([line], None, "accepted"))
        return {
            "summary": "" if is_alone or not self._checked + self._skipped else self._summary(),
            "verdict": dict(zip(("kind", "text"), self._verdict(), strict=True)),
            "blocks": blocks,
            "accepted": 0 if is_alone else self._accepted,
            "places": [] if is_alone else self._accepted_places,
        }

    def _verdict(self) -> tuple[str, str]:
        """Returns kind and text of the verdict on all frames."""
        if not self._checked:
            return "", ""
        if self._checked == 1:
            return verdict(self.frames[0].report) if self.frames else (TAKES, "The brick takes it.")
        worse = len(self._frames[Severity.ERROR]) + self._left_out[Severity.ERROR]
        noted = self._checked - self._accepted - worse
        parts = [
            f"{count} {what}"
            for count, what in ((self._accepted, "as they are"), (noted, "with warnings"), (worse, "with errors"))
            if count
        ]
        kind = REFUSES if worse else TAKES_BUT if noted else TAKES
        return kind, f"{counted(self._checked, 'frame')} for the brick: {', '.join(parts)}."

    def _summary(self) -> str:
        found = ", ".join(counted(self._counts[severity], str(severity)) for severity in _SEVERITIES)
        replies = f"; {counted(self._skipped, 'frame')} from the brick not checked" if self._skipped else ""
        return f"{counted(self._checked, 'frame')}: {found}{replies}"


def _blocks(checked: Checked) -> Iterator[dict[str, Any]]:
    """Yields the verdict on a frame, then each group of its findings."""
    lines = list(diagnostics(checked.report, place=checked.place))
    starts = [at for at, line in enumerate(lines) if not line]
    for start, end in zip([0, *starts], [*starts, len(lines)], strict=True):
        yield _block(lines[start:end], checked)


def _program_blocks(report: ProgramReport) -> Iterator[dict[str, Any]]:
    checked = Checked(0, "", 0, report)
    for _, lines in groupby(program_findings(report, report.findings), lambda line: (line.code, line.offset)):
        yield _block(lines, checked)


def _severity(code: str) -> str:
    return str((CODES.get(code) or PROGRAM_CODES[code]).severity)


def _block(lines: Iterable[Line], checked: Checked | None, severity: str = "") -> dict[str, Any]:
    """Returns lines with what they are about: a finding, by its code and offset, or the whole frame."""
    shown = list(lines)
    codes = list(dict.fromkeys(line.code for line in shown if line.code))
    at, length = 0, 0 if checked is None else len(checked.report.frame)
    # The verdict comes first; other lines without a code tell what was meant.
    about = next((line for line in shown if line.offset is not None and (line.code or not shown[0])), None)
    if about is not None and about.offset is not None:
        at, length = about.offset, about.length or 1
        severity = _severity(about.code) if about.code else SUGGESTION
    return {
        "lines": [pieces(line) for line in shown],
        "severity": severity,
        "codes": codes,
        "frame": -1 if checked is None else checked.number,
        "line": 0 if checked is None else checked.line,
        "offset": at,
        "length": length,
    }
