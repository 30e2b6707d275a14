"""The result of a check: the brick's own verdict, and one finding for each problem."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from ev3proto.tables.frame import LENGTH_FIELD as _LENGTH


class Severity(StrEnum):
    """The severity of a finding.

    An error will not do what was meant, a warning may not; a hint marks something that could be done better.
    """

    ERROR = "error"
    WARNING = "warning"
    HINT = "hint"


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that is wrong or could be better.

    severity   error, warning or hint
    code       stable name of the problem: `E101`, `W203`, `H301`; `ev3proto check --explain` explains it
    offset     of the first byte concerned, from the start of the frame
    length     number of bytes concerned, 0 if something is missing
    message    one sentence: what is wrong
    help       one sentence: how to fix it
    operation  name of the operation or system command, None for the header
    parameter  name of the parameter or field, or None
    """

    severity: Severity
    code: str
    offset: int
    length: int
    message: str
    help: str
    operation: str | None = None
    parameter: str | None = None

    def as_dict(self) -> dict[str, Any]:
        """Returns it as a dictionary for other tools; keys that do not apply are absent."""
        entry = {name: getattr(self, name) for name in self.__slots__}
        return {name: value for name, value in entry.items() if value is not None}


@dataclass(frozen=True, slots=True)
class Suggestion:
    """A right frame that was probably meant.

    kind     of the slip: `memory-missing`, `raw`, ...
    offset   of the slip in the frame that was checked
    length   number of bytes there that are wrong, 0 if something is missing
    message  one sentence: what is wrong, and what would be right
    frame    the frame that was probably meant
    unknown  the bytes of that frame that can only be guessed, as pairs of offset and length
    is_sure  whether it is likely enough for a fix: the only suggestion, with nothing guessed
    harm     half a sentence: what it would do that is worse than what the given frame does, so that no fix takes it
    """

    kind: str
    offset: int
    length: int
    message: str
    frame: bytes
    unknown: tuple[tuple[int, int], ...] = ()
    is_sure: bool = False
    harm: str = ""

    def as_dict(self) -> dict[str, Any]:
        """Returns it as a dictionary for other tools; `hex` is the frame."""
        return {
            "kind": self.kind,
            "offset": self.offset,
            "length": self.length,
            "message": self.message,
            "hex": self.frame.hex(),
            "unknown": [list(span) for span in self.unknown],
            "sure": self.is_sure,
            **({"harm": self.harm} if self.harm else {}),
        }


def difference(old: bytes, new: bytes) -> tuple[int, int, bytes]:
    """Returns where two frames differ, but for the length: offset and end in the old one, and the new bytes there."""
    at, shorter = _LENGTH if old[_LENGTH:] != new[_LENGTH:] else 0, min(len(old), len(new))
    if new[_LENGTH:].endswith(old) or old[_LENGTH:].endswith(new):
        at = 0
    while at < shorter and old[at] == new[at]:
        at += 1
    same = 0
    while same < shorter - at and old[-1 - same] == new[-1 - same]:
        same += 1
    return at, len(old) - same, new[at : len(new) - same]


@dataclass(frozen=True, slots=True)
class Report:
    """The result of a check.

    frame        the bytes that were checked
    accepted     whether the brick will run the command; for other messages, whether nothing prevents that
    rejected_at  offset in the frame where the brick stops: the operation, or the field of the header; None if it
                 accepts
    findings     ordered by offset
    dialect      the firmware whose instruction set was used
    carrier      the carrier; None if it did not matter
    alone        whether no other command belongs to the frame
    """

    frame: bytes
    accepted: bool
    rejected_at: int | None
    findings: tuple[Finding, ...]
    dialect: str = "official"
    carrier: str | None = None
    alone: bool = False

    def __str__(self) -> str:
        """Returns what `ev3proto check` prints."""
        from ev3proto.text.diagnostics import report_text  # a higher layer, which renders reports

        return report_text(self)

    @property
    def nearest(self) -> tuple[Suggestion, ...]:
        """What was probably meant: nothing, one frame, or two that are equally likely.

        Empty for a frame without findings, and for one among others that the brick accepts without errors. The search
        takes some milliseconds, when it is first asked for.
        """
        from ev3proto.checking.nearest import nearest  # which checks the frames that it finds

        if not self.findings or not (self.alone or self.errors or not self.accepted):
            return ()
        return nearest(self)

    @property
    def fixed(self) -> Fix:
        """Fixes everything in the frame that can be fixed with certainty, like `ev3proto check --fix`."""
        from ev3proto.checking.fixing import fix  # which checks the fixed frame again

        return fix(self.frame, dialect=self.dialect, carrier=self.carrier)

    def of(self, severity: Severity) -> tuple[Finding, ...]:
        """Returns the findings of one severity."""
        return tuple(finding for finding in self.findings if finding.severity is severity)

    @property
    def errors(self) -> tuple[Finding, ...]:
        """The findings about what will not do what was meant."""
        return self.of(Severity.ERROR)

    @property
    def warnings(self) -> tuple[Finding, ...]:
        """The findings about what may not do what was meant."""
        return self.of(Severity.WARNING)

    def as_dict(self) -> dict[str, Any]:
        """Returns it as a dictionary for other tools."""
        return {
            "accepted": self.accepted,
            "rejected_at": self.rejected_at,
            "findings": [finding.as_dict() for finding in self.findings],
            "hex": self.frame.hex(),
        }


@dataclass(frozen=True, slots=True)
class Change:
    """One thing that was fixed.

    what    `length field`, `global memory`, `FREQUENCY of SOUND.TONE at offset 10`
    before  the old value
    after   the new value
    why     reason, in half a sentence
    """

    what: str
    before: str
    after: str
    why: str

    def __str__(self) -> str:
        return f"{self.what}: {self.before} -> {self.after} ({self.why})"

    def as_dict(self) -> dict[str, str]:
        """Returns it as a dictionary for other tools."""
        return {name: getattr(self, name) for name in self.__slots__}


@dataclass(frozen=True, slots=True)
class Fix:
    """A fixed frame and its changes.

    frame     the fixed bytes; the given ones if nothing was fixed
    changes   the changes, in order
    unfixed   sentences: what looked fixable but was kept, and why
    report    the report of a check of the fixed bytes
    """

    frame: bytes
    changes: tuple[Change, ...]
    unfixed: tuple[str, ...]
    report: Report

    def __str__(self) -> str:
        """Returns what `ev3proto check --fix` prints."""
        from ev3proto.text.diagnostics import described_fix  # a higher layer, which renders reports

        return described_fix(self)

    @property
    def is_fixed(self) -> bool:
        """Whether anything was fixed."""
        return bool(self.changes)

    def as_dict(self) -> dict[str, Any]:
        """Returns it as a dictionary for other tools; `hex` is the fixed frame."""
        return {
            **self.report.as_dict(),
            "fixed": self.is_fixed,
            "changes": [change.as_dict() for change in self.changes],
            "unfixed": list(self.unfixed),
        }
