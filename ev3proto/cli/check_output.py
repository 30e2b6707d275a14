"""How `check` shows what it found: as text, as one JSON object a line. SARIF and GitHub's annotations are beside it."""

from __future__ import annotations

import json
from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

from ev3proto.checking.report import Finding, Fix, Report
from ev3proto.cli.output import Printer, complain
from ev3proto.errors import counted
from ev3proto.text.diagnostics import diagnostics, fixed
from ev3proto.text.spans import Line, Role, plain_text

if TYPE_CHECKING:
    from ev3proto.program.report import ProgramReport
    from ev3proto.text.assembly.errors import AssemblyError, SourceWarning
    from ev3proto.text.fixed_text import FixedFrame

# Programs are imported when they are needed, which saves 30 ms for a frame.

SEVERITIES = ("error", "warning", "hint")
"""The severities that are counted, the worst first."""


class Place(NamedTuple):
    """The place of a frame or a program.

    label     prefix of every offset, such as `robot.log, line 3`; empty for a single frame
    facts     the same for other tools
    is_among  whether it is one of many frames in a text or a capture
    """

    label: str
    facts: dict[str, Any]
    is_among: bool = False


@dataclass(slots=True)
class Tally:
    """What was checked, and the numbers of findings by severity."""

    frames: int = 0
    programs: int = 0
    replies: int = 0
    findings: Counter[str] = field(default_factory=Counter)

    @property
    def is_one(self) -> bool:
        """Whether no more than one thing was read."""
        return self.frames + self.programs + self.replies <= 1

    def add(self, findings: Iterable[Finding]) -> None:
        """Counts findings."""
        self.findings.update(str(finding.severity) for finding in findings)

    @property
    def inputs(self) -> str:
        """`4 frames`, `2 programs`, `1 frame and 1 program`."""
        programs = [counted(self.programs, "program")] if self.programs else []
        frames = [counted(self.frames, "frame")] if self.frames or not programs else []
        return " and ".join([*frames, *programs])


class Output(ABC):
    """The findings in one format."""

    @abstractmethod
    def frame(self, report: Report, shown: Sequence[Finding], place: Place) -> None:
        """Shows the findings of a frame."""

    @abstractmethod
    def fixed(self, fix: Fix, shown: Sequence[Finding], place: Place) -> None:
        """Shows a fixed frame."""

    @abstractmethod
    def program(
        self, report: ProgramReport, shown: Sequence[Finding], place: Place, warnings: Sequence[SourceWarning]
    ) -> None:
        """Shows the findings of a program, and the warnings of its source."""

    @abstractmethod
    def source_errors(self, label: str, error: AssemblyError) -> None:
        """Shows the errors of a program's source."""

    def complaint(self, sentence: str) -> None:  # noqa: B027 - most formats leave it to standard error
        """Shows a message about input that cannot be read, besides standard error."""

    @abstractmethod
    def end(self, tally: Tally, *, is_quiet: bool) -> None:
        """Shows the numbers of frames and findings."""


class TextOutput(Output):
    """The findings as text; paragraphs of several lines have empty lines between them.

    Attributes:
        is_edited: Whether the output is a text with its frames fixed, and all else goes to standard error.
    """

    def __init__(self, dialect: str) -> None:
        self._printer = Printer()
        self._dialect = dialect
        self._was_long: bool | None = None
        self.is_edited = False

    def frame(self, report: Report, shown: Sequence[Finding], place: Place) -> None:
        """Prints the verdict, and each finding with its bytes."""
        self._paragraph(diagnostics(report, shown, place=place.label, dialect=self._dialect), is_long=bool(shown))

    def fixed(self, fix: Fix, shown: Sequence[Finding], place: Place) -> None:
        """Prints the fixed frame, its changes, and what remains."""
        self._paragraph(fixed(fix, shown, place=place.label, dialect=self._dialect), is_long=True)

    def edited(self, edited: FixedFrame, shown: Sequence[Finding], place: Place) -> None:
        """Prints the same about a frame in a text on standard error: the text itself is the output."""
        fix = edited.fix
        if fix.is_fixed or fix.report.findings:
            lines = fixed(fix, shown, place=place.label, dialect=self._dialect, is_written=edited.is_written)
            complain("\n".join(map(plain_text, lines)) + "\n")

    def program(
        self, report: ProgramReport, shown: Sequence[Finding], place: Place, warnings: Sequence[SourceWarning]
    ) -> None:
        """Prints the findings, and the warnings on standard error."""
        from ev3proto.cli.programs import complain_of_warnings  # takes 30 ms, which frames do not need
        from ev3proto.program.report import program_findings  # the same

        complain_of_warnings(place.facts["source"], warnings)
        label = f"{place.label}, " if place.label else ""
        self._paragraph(program_findings(report, shown, label), is_long=bool(shown))

    def source_errors(self, label: str, error: AssemblyError) -> None:
        """Prints the errors on standard error."""
        from ev3proto.cli.assembly import show_errors  # takes 5 ms, which frames do not need

        show_errors(f"{label}, ", error)

    def end(self, tally: Tally, *, is_quiet: bool) -> None:
        """Prints a line, if there is more than one frame; none for no frame at all."""
        if not (tally.frames or tally.programs) or (tally.is_one and not is_quiet):
            return
        found = ", ".join(counted(tally.findings[severity], severity) for severity in SEVERITIES)
        line: Line = [(f"{tally.inputs}: ", Role.HEADING), (found, Role.PLAIN)]
        if tally.replies:
            line.append((f"; {counted(tally.replies, 'frame')} from the brick not checked", Role.ASIDE))
        if self.is_edited:
            complain(plain_text(line))
        else:
            self._paragraph([line], is_long=False)

    def _paragraph(self, lines: Iterable[Line], *, is_long: bool) -> None:
        """Prints lines that belong together, after an empty one if this or the last paragraph has several lines."""
        if self._was_long or (is_long and self._was_long is not None):
            self._printer.text("")
        self._was_long = is_long
        self._printer.lines(lines)


class JsonOutput(Output):
    """The findings as one JSON object a line.

    shows_warnings  whether warnings are shown
    """

    def __init__(self, *, shows_warnings: bool) -> None:
        self._printer = Printer()
        self._shows_warnings = shows_warnings

    def frame(self, report: Report, shown: Sequence[Finding], place: Place) -> None:
        """Prints the verdict and the findings."""
        self._print(place.facts, report.as_dict(), shown)

    def fixed(self, fix: Fix, shown: Sequence[Finding], place: Place) -> None:
        """Prints the same of the fixed frame, with its changes."""
        self._print(place.facts, fix.as_dict(), shown)

    def program(
        self, report: ProgramReport, shown: Sequence[Finding], place: Place, warnings: Sequence[SourceWarning]
    ) -> None:
        """Prints the verdict, the warnings of the source and the findings."""
        from ev3proto.cli.programs import complain_of_warnings, source_findings  # takes 30 ms, which frames do not need

        complain_of_warnings(place.facts["source"], warnings)
        found = source_findings(warnings=warnings) if warnings and self._shows_warnings else []
        self._print(place.facts, report.as_dict(), shown, found)

    def source_errors(self, label: str, error: AssemblyError) -> None:
        """Prints the errors as findings of a program that is refused, and on standard error."""
        from ev3proto.cli.assembly import show_errors  # takes 5 ms, which frames do not need
        from ev3proto.cli.programs import source_findings  # takes 30 ms, the same

        show_errors(f"{label}, ", error)
        entry: dict[str, Any] = {"accepted": False, "rejected_at": None, "findings": [], "hex": ""}
        self._print({"source": label}, entry, (), source_findings(error))

    def end(self, tally: Tally, *, is_quiet: bool) -> None:
        """Prints the numbers if nothing else is printed."""
        if is_quiet:
            counts = {f"{severity}s": tally.findings[severity] for severity in SEVERITIES}
            entry = {"frames": tally.frames, "programs": tally.programs, "replies": tally.replies, **counts}
            self._printer.text(json.dumps(entry))

    def _print(
        self,
        facts: dict[str, Any],
        entry: dict[str, Any],
        shown: Sequence[Finding],
        before: Sequence[dict[str, Any]] = (),
    ) -> None:
        entry["findings"] = [*before, *(finding.as_dict() for finding in shown)]
        self._printer.text(json.dumps(facts | entry, ensure_ascii=False))
