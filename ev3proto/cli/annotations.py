"""The findings of `check` for continuous integration: SARIF, and the annotations of GitHub's workflows."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from typing import Any

from ev3proto.checking.codes import CODES
from ev3proto.checking.report import Finding, Report, Severity
from ev3proto.version import VERSION

SARIF_SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
SARIF_VERSION = "2.1.0"

REFUSED = "E000"
"""The code of a frame that the brick refuses and that no finding explains."""

_GITHUB = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.HINT: "notice"}
_SARIF = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.HINT: "note"}


def github(report: Report, findings: Iterable[Finding], facts: Mapping[str, Any]) -> list[str]:
    """The findings as commands of a workflow on GitHub, which marks the lines of the file with them.

    Args:
        report: What was found in a frame.
        findings: Those of them to show.
        facts: Where the frame stands: `source`, and `line` or `packet`.

    Returns:
        A line for each.
    """
    place = [f"file={_property(str(facts['source']))}"] if "source" in facts else []
    place += [f"line={facts['line']}"] if "line" in facts else []
    return [
        f"::{_GITHUB[one.severity]} {','.join([*place, f'title={_property(one.code)}'])}::{_message(_sentence(one))}"
        for one in _all(report, findings)
    ]


class Sarif:
    """Findings of any number of frames as one SARIF log."""

    def __init__(self) -> None:
        self._results: list[dict[str, Any]] = []

    def add(self, report: Report, findings: Iterable[Finding], facts: Mapping[str, Any]) -> None:
        """Adds what was found in a frame; the arguments are those of `github`."""
        for one in _all(report, findings):
            result: dict[str, Any] = {
                "ruleId": one.code,
                "level": _SARIF[one.severity],
                "message": {"text": _sentence(one)},
                "properties": {"offset": one.offset, "length": one.length, "frame": report.frame.hex()},
            }
            if "source" in facts:
                location: dict[str, Any] = {"artifactLocation": {"uri": str(facts["source"]).replace("\\", "/")}}
                if "line" in facts:
                    location["region"] = {"startLine": facts["line"]}
                result["locations"] = [{"physicalLocation": location}]
            self._results.append(result)

    def text(self) -> str:
        """The log, as JSON on one line."""
        used = sorted({result["ruleId"] for result in self._results})
        rules = [
            {"id": code, "shortDescription": {"text": CODES[code].title}, "fullDescription": {"text": _story(code)}}
            if code in CODES
            else {"id": code}
            for code in used
        ]
        driver = {"name": "ev3proto", "version": VERSION, "rules": rules}
        log = {
            "$schema": SARIF_SCHEMA,
            "version": SARIF_VERSION,
            "runs": [{"tool": {"driver": driver}, "results": self._results}],
        }
        return json.dumps(log, ensure_ascii=False)


def _all(report: Report, findings: Iterable[Finding]) -> list[Finding]:
    """The findings, and one more where the brick refuses a frame for a reason that none of them has."""
    shown = list(findings)
    if not report.accepted and not report.errors:
        at = report.rejected_at or 0
        shown.insert(
            0, Finding(Severity.ERROR, REFUSED, at, 0, "the brick refuses the frame", "see the other findings")
        )
    return shown


def _sentence(one: Finding) -> str:
    return f"offset {one.offset}: {one.message}; {one.help}"


def _story(code: str) -> str:
    return " ".join(CODES[code].explanation.split())


def _message(text: str) -> str:
    """A text as the commands of a workflow take it."""
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _message(text).replace(":", "%3A").replace(",", "%2C")
