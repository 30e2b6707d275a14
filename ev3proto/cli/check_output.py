"""What `check` found, and the renderers of that: text, one JSON object a line; annotations are beside it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

from ev3proto.checking.report import Finding, Fix, Report, Severity, Suggestion
from ev3proto.cli.output import Printer, complain, say_json
from ev3proto.errors import counted
from ev3proto.text.diagnostics import diagnostics, fixed
from ev3proto.text.spans import Role, Spans, plain_text

if TYPE_CHECKING:
    from ev3proto.text.assembly.errors import AssemblyError, SourceWarning
    from ev3proto.text.fixed_text import FixedFrame

SEVERITIES = ("error", "warning", "hint")
"""The severities that are counted, the worst first."""

SOURCE_CODE = "source"
"""The code of errors and warnings of a program's source."""


class FramePlace(NamedTuple):
    """The place of a frame or a program.

    label     prefix of every offset, such as `robot.log, line 3`; empty for a single frame
    facts     the same for other tools
    is_among  whether it is one of many frames in a text or a capture
    """

    label: str
    facts: dict[str, Any]
    is_among: bool = False


class SourceFinding(NamedTuple):
    """An error or a warning of a program's source."""

    severity: Severity
    error: AssemblyError | SourceWarning


class Checked(NamedTuple):
    """A frame or a program, and what was found in it.

    report      None for a program whose source has errors
    shown       the findings of the report to show
    fix         the fix of a frame; the report is that of the fixed one
    is_program  whether it is a program
    source      what was found in a program's source
    nearest     what was probably meant by a frame
    is_whole    whether to show findings that a suggestion resolves, too
    """

    place: FramePlace
    report: Report | None
    shown: Sequence[Finding] = ()
    fix: Fix | None = None
    is_program: bool = False
    source: Sequence[SourceFinding] = ()
    nearest: Sequence[Suggestion] = ()
    is_whole: bool = False


@dataclass(slots=True)
class Tally:
    """What was checked, and the numbers of findings by severity; `cut`: commands that a capture has only in part."""

    frames: int = 0
    programs: int = 0
    replies: int = 0
    cut: int = 0
    findings: Counter[str] = field(default_factory=Counter)

    @property
    def seen(self) -> int:
        """The number of commands and programs, checked or cut."""
        return self.frames + self.programs + self.cut

    @property
    def is_one(self) -> bool:
        """Whether no more than one thing was read."""
        return self.seen + self.replies <= 1

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
    """A renderer: the findings in one format."""

    @abstractmethod
    def show(self, checked: Checked) -> None:
        """Shows the findings of a frame or a program."""

    def complaint(self, sentence: str) -> None:  # noqa: B027 - most formats leave it to standard error
        """Shows a message about input that cannot be read, besides standard error."""

    @abstractmethod
    def end(self, tally: Tally, *, is_quiet: bool) -> None:
        """Shows the numbers of frames and findings."""


class TextOutput(Output):
    """The findings as text; paragraphs of several lines have empty lines between them.

    is_edited  whether the output is a text with its frames fixed, and all else goes to standard error
    """

    def __init__(self, dialect: str) -> None:
        self._printer = Printer()
        self._dialect = dialect
        self._was_long: bool | None = None
        self.is_edited = False

    def show(self, checked: Checked) -> None:
        """Prints the verdict, the fix, and each finding with its bytes."""
        label, dialect, report, shown = checked.place.label, self._dialect, checked.report, checked.shown
        _complain_of_source(checked)
        if report is None:
            return
        lines: Iterable[Spans]
        if checked.is_program:
            from ev3proto.program.report import ProgramReport, program_findings  # takes 8 ms, which frames do not need

            assert isinstance(report, ProgramReport)
            lines = program_findings(report, shown, f"{label}, " if label else "")
        elif checked.fix is not None:
            lines = fixed(checked.fix, shown, place=label, dialect=dialect)
        else:
            nearest, is_whole = checked.nearest, checked.is_whole
            lines = diagnostics(report, shown, place=label, dialect=dialect, nearest=nearest, is_complete=is_whole)
        self._paragraph(lines, is_long=bool(shown) or checked.fix is not None)

    def edited(self, edited: FixedFrame, shown: Sequence[Finding], place: FramePlace) -> None:
        """Prints the same about a frame in a text on standard error: the text itself is the output."""
        if edited.fix.is_fixed or edited.fix.report.findings:
            lines = fixed(edited.fix, shown, place=place.label, dialect=self._dialect, is_written=edited.is_written)
            complain("\n".join(map(plain_text, lines)) + "\n")

    def end(self, tally: Tally, *, is_quiet: bool) -> None:
        """Prints a line, if there is more than one frame; none for no frame at all."""
        if not tally.seen or (tally.is_one and not is_quiet and not tally.cut):
            return
        found = ", ".join(counted(tally.findings[severity], severity) for severity in SEVERITIES)
        line = [(f"{tally.inputs}: ", Role.HEADING), (found, Role.PLAIN)]
        if tally.replies:
            line.append((f"; {counted(tally.replies, 'frame')} from the brick not checked", Role.ASIDE))
        if tally.cut:
            line.append((f"; {counted(tally.cut, 'frame')} cut by the capture not checked", Role.ASIDE))
        if self.is_edited:
            complain(plain_text(line))
        else:
            self._paragraph([line], is_long=False)

    def _paragraph(self, lines: Iterable[Spans], *, is_long: bool) -> None:
        """Prints lines that belong together, after an empty one if this or the last paragraph has several lines."""
        if self._was_long or (is_long and self._was_long is not None):
            self._printer.text("")
        self._was_long = is_long
        self._printer.lines(lines)


_REFUSED: dict[str, Any] = {"accepted": False, "rejected_at": None, "findings": [], "hex": ""}
"""The report on a program whose source has errors."""


class JsonOutput(Output):
    """The findings as one JSON object a line."""

    def show(self, checked: Checked) -> None:
        """Prints the verdict and the findings, also those of a program's source."""
        _complain_of_source(checked)
        found = checked.fix or checked.report
        entry = _REFUSED if found is None else found.as_dict()
        findings = [*map(_source_entry, checked.source), *(finding.as_dict() for finding in checked.shown)]
        nearest = {"nearest": [one.as_dict() for one in checked.nearest]} if checked.nearest else {}
        say_json(checked.place.facts | entry | {"findings": findings} | nearest)

    def end(self, tally: Tally, *, is_quiet: bool) -> None:
        """Prints the numbers if nothing else is printed."""
        if is_quiet:
            counts = {f"{severity}s": tally.findings[severity] for severity in SEVERITIES}
            say_json(
                {
                    "frames": tally.frames,
                    "programs": tally.programs,
                    "replies": tally.replies,
                    "cut": tally.cut,
                    **counts,
                }
            )


def _complain_of_source(checked: Checked) -> None:
    if checked.source:
        from ev3proto.cli.programs import complain_of_source  # takes 8 ms, which frames do not need

        complain_of_source(checked.place.facts["source"], [error for _, error in checked.source])


def _source_entry(found: SourceFinding) -> dict[str, Any]:
    """Returns what was found in a source in the form of `Finding.as_dict`, with `line` and `column`."""
    one = found.error
    finding = Finding(found.severity, SOURCE_CODE, 0, 0, one.reason, f"change line {one.line} of the source")
    return finding.as_dict() | {"line": one.line, "column": one.column}
