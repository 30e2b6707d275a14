"""The verdict of a check in one sentence: the brick takes it; takes it, but ...; refuses it, because ..."""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.checking.report import Finding, Report

TAKES, TAKES_BUT, REFUSES = "takes", "but", "refuses"


class VerdictSentence(NamedTuple):
    """A verdict.

    kind  TAKES, TAKES_BUT or REFUSES
    text  a sentence
    """

    kind: str
    text: str


def verdict(report: Report) -> VerdictSentence:
    """Returns what the brick makes of a frame."""
    if report.accepted and not report.findings:
        return VerdictSentence(TAKES, "The brick takes it.")
    if report.accepted:
        return VerdictSentence(TAKES_BUT, f"The brick takes it, but {_first(report.findings).message}.")
    found = [each for each in report.findings if each.offset == report.rejected_at] or list(report.findings)
    because = f", because {_first(found).message}" if found else ""
    return VerdictSentence(REFUSES, f"The brick refuses it at byte {report.rejected_at or 0}{because}.")


def _first(findings: tuple[Finding, ...] | list[Finding]) -> Finding:
    """Returns the worst finding, and the first one of these."""
    severities = list(type(findings[0].severity))
    return min(findings, key=lambda finding: (severities.index(finding.severity), finding.offset))
