"""The findings of `check` for continuous integration: SARIF, and annotations of GitHub's workflows."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any
from urllib.parse import quote

from ev3proto.checking.codes import CODES
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.checking.report import Finding, Report, Severity, Suggestion
from ev3proto.cli.check_output import SOURCE_CODE, Checked, Output, Tally
from ev3proto.cli.output import Printer
from ev3proto.version import VERSION

SARIF_SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
SARIF_VERSION = "2.1.0"

REFUSED = "E000"
"""The code of a frame that the brick refuses for a reason that no shown finding gives."""

UNREAD = "unread"
"""The code of input that cannot be read."""

MOST_COMPLAINTS = 1_000
"""Maximum number of unreadable places that a SARIF log lists."""

_TITLES = {REFUSED: "refused by the brick", SOURCE_CODE: "a program's source"}

_GITHUB = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.HINT: "notice"}
_SARIF = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.HINT: "note"}


@dataclass(frozen=True, slots=True)
class Note:
    """A message about a file or a frame.

    severity   error, warning or hint
    code       of the finding
    sentence   what is wrong, and what would be right
    source     the file, or empty
    line       of a text, from 1 on; None for other files
    column     in that line, from 1 on
    at         offset and number of bytes in a file of bytes, None for texts and captures
    more       further keys for other tools
    """

    severity: Severity
    code: str
    sentence: str
    source: str = ""
    line: int | None = None
    column: int | None = None
    at: tuple[int, int] | None = None
    more: Mapping[str, Any] = field(default_factory=dict)


def notes_on(checked: Checked) -> Iterator[Note]:
    """Yields the findings of a frame or a program, one more if the brick refuses it for a reason that none gives."""
    report, name = checked.report, str(checked.place.facts.get("source", ""))
    for severity, one in checked.source:
        yield Note(severity, SOURCE_CODE, one.reason, name, one.line, one.column)
    if report is None:
        return
    nearest = checked.nearest
    for finding in (*_refusal(report, checked.shown), *checked.shown):
        yield _note(checked, report, finding, nearest)
        nearest = ()  # what was meant is said once


def _refusal(report: Report, shown: Sequence[Finding]) -> Iterator[Finding]:
    """Yields an error for a refusal that no shown finding explains."""
    if not report.accepted and not any(one.severity is Severity.ERROR for one in shown):
        advice = "ev3proto check shows why" if report.findings else "the bytes there are not what it reads"
        yield Finding(Severity.ERROR, REFUSED, report.rejected_at or 0, 0, "the brick refuses it", advice)


def _note(checked: Checked, report: Report, finding: Finding, nearest: Sequence[Suggestion]) -> Note:
    facts, span = checked.place.facts, {"offset": finding.offset, "length": finding.length}
    packet = {"packet": facts["packet"]} if "packet" in facts else {}
    where = "".join(f"packet {number}, " for number in packet.values())
    meant = "".join(f"; did you mean: {one.message}?" for one in nearest)
    return Note(
        finding.severity,
        finding.code,
        f"{where}offset {finding.offset}: {finding.message}; {finding.help}{meant}",
        str(facts.get("source", "")),
        facts.get("line"),
        facts.get("column"),
        (finding.offset, finding.length) if checked.is_program else None,
        span
        | ({} if checked.is_program else {"frame": report.frame.hex()})
        | ({"nearest": [one.as_dict() for one in nearest]} if nearest else {})
        | packet,
    )


class GitHub(Output):
    """The findings as commands of GitHub's workflows, which mark the lines of files."""

    def __init__(self) -> None:
        self._printer = Printer()

    def show(self, checked: Checked) -> None:
        """Shows the findings of a frame or a program, and of a program's source."""
        for note in notes_on(checked):
            self._show(note)

    def complaint(self, sentence: str) -> None:
        """Shows a sentence about input that could not be read."""
        self._show(Note(Severity.ERROR, UNREAD, sentence))

    def end(self, tally: Tally, *, is_quiet: bool) -> None:
        """Shows nothing: numbers are for people."""

    def _show(self, note: Note) -> None:
        parts = [f"file={_property(note.source)}"] if note.source else []
        parts += [] if note.line is None else [f"line={note.line}"]
        parts.append(f"title={_property(note.code)}")
        parts += [] if note.line is None or note.column is None else [f"col={note.column}"]
        self._printer.text(f"::{_GITHUB[note.severity]} {','.join(parts)}::{_message(note.sentence)}")


class Sarif(Output):
    """The findings as one SARIF log, which is written note by note, because a capture may have millions."""

    def __init__(self) -> None:
        self._printer = Printer()
        self._used: set[str] = set()
        self._complaints: list[str] = []
        self._more_complaints = 0
        self._last = f'{{"$schema": "{SARIF_SCHEMA}", "version": "{SARIF_VERSION}", "runs": [{{"results": ['

    def show(self, checked: Checked) -> None:
        """Adds the findings of a frame or a program, and of a program's source."""
        for note in notes_on(checked):
            # A comma separates two results, so each line is written when the next one is known.
            self._printer.text(self._last + "," * bool(self._used))
            self._last = json.dumps(_result(note), ensure_ascii=False)
            self._used.add(note.code)

    def complaint(self, sentence: str) -> None:
        """Adds a sentence about input that could not be read."""
        if len(self._complaints) < MOST_COMPLAINTS:
            self._complaints.append(sentence)
        else:
            self._more_complaints += 1

    def end(self, tally: Tally, *, is_quiet: bool) -> None:  # noqa: ARG002 - numbers are for people
        """Writes the end of the log: the rules, and what could not be read."""
        driver = {"name": "ev3proto", "version": VERSION, "rules": [_rule(code) for code in sorted(self._used)]}
        sentences = list(self._complaints)
        if self._more_complaints:
            sentences.append(f"and {self._more_complaints} more places that could not be read")
        complaints = [{"level": "error", "message": {"text": sentence}} for sentence in sentences]
        rest = {
            "tool": {"driver": driver},
            "invocations": [{"executionSuccessful": not complaints, "toolExecutionNotifications": complaints}],
        }
        self._printer.text(self._last)
        self._printer.text(f"], {json.dumps(rest, ensure_ascii=False)[1:]}]}}")


def _result(note: Note) -> dict[str, Any]:
    result: dict[str, Any] = {"ruleId": note.code, "level": _SARIF[note.severity], "message": {"text": note.sentence}}
    if note.more:
        result["properties"] = dict(note.more)
    if note.source:
        location: dict[str, Any] = {"artifactLocation": {"uri": quote(note.source.replace("\\", "/"))}}
        region = _region(note)
        if region:
            location["region"] = region
        result["locations"] = [{"physicalLocation": location}]
    return result


def _region(note: Note) -> dict[str, int]:
    if note.line is not None:
        column = {} if note.column is None else {"startColumn": note.column}
        return {"startLine": note.line, **column}
    return {} if note.at is None else {"byteOffset": note.at[0], "byteLength": note.at[1]}


def _rule(code: str) -> dict[str, Any]:
    entry = CODES.get(code) or PROGRAM_CODES.get(code)
    if entry is None:
        return {"id": code, "shortDescription": {"text": _TITLES[code]}}
    story = " ".join(entry.explanation.split())
    return {"id": code, "shortDescription": {"text": entry.title}, "fullDescription": {"text": story}}


def _message(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _message(text).replace(":", "%3A").replace(",", "%2C")
