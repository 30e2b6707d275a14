"""The report on a program, and its printed form."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any, NoReturn

from ev3proto.checking.report import Finding, Report
from ev3proto.text.diagnostics import ROLES
from ev3proto.text.spans import Line, Role, plain_text, visible


@dataclass(frozen=True, slots=True)
class ProgramReport(Report):
    """The result of a check of a program. `frame` is the image; `accepted` tells whether the brick starts it."""

    omitted: int = 0  # number of findings beyond the limit, which are not in `findings`

    def __str__(self) -> str:
        """Returns what `ev3proto check` prints of it."""
        return "\n".join(visible(plain_text(line)) for line in program_findings(self, self.findings))

    def as_dict(self) -> dict[str, Any]:
        """Returns it as a dictionary for other tools; with `omitted` if there are more findings than listed."""
        return {**Report.as_dict(self), **({"omitted": self.omitted} if self.omitted else {})}

    @property
    def fixed(self) -> NoReturn:
        """Only frames are fixed. Raises ValueError."""
        raise ValueError("only frames can be fixed, and this is the report on a program")


def program_findings(report: ProgramReport, findings: Iterable[Finding], place: str = "") -> Iterator[Line]:
    """Yields two lines for each finding, and one for the verdict; `place` precedes each offset."""
    for finding in findings:
        spans = [
            (f"{finding.severity}[{finding.code}]", ROLES[finding.severity]),
            (f": {place}offset {finding.offset}: {finding.message}", Role.PLAIN),
        ]
        for shown in (spans, [(f"  help: {finding.help}", Role.ASIDE)]):
            yield Line(shown, finding.offset, finding.length, finding.code)
    if report.omitted:
        yield Line([(f"{place}and {report.omitted} more findings, which are not listed", Role.ASIDE)])
    if report.accepted:
        verdict = (f"{place}the brick takes the program", Role.HEADING)
    else:
        verdict = (f"{place}the brick refuses the program at offset {report.rejected_at}", Role.FAULT)
    yield Line([verdict], 0, len(report.frame))
