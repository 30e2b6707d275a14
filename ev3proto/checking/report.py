"""What a check finds: the brick's own verdict, and one finding for everything that should be looked at."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import Any


class Severity(StrEnum):
    """How bad it is: an error will not do what was meant, a warning may not, a hint only could be done better."""

    ERROR = "error"
    WARNING = "warning"
    HINT = "hint"


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that is wrong, or could be better.

    severity   error, warning or hint
    code       stable name of what it is: `E101`, `W203`, `H301`; `ev3proto check --explain` explains it
    offset     of the first byte it is about, counted from the frame's first
    length     bytes it is about, 0 where something is missing
    message    one sentence: what is wrong
    help       one sentence: how to fix it
    operation  name of the operation or system command, None for what is about the header
    parameter  name of the parameter or field, None where it is about none
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
        """The same for other tools, `help` as `mend`; keys that do not apply are absent."""
        entry: dict[str, Any] = {
            "severity": self.severity,
            "code": self.code,
            "offset": self.offset,
            "length": self.length,
            "message": self.message,
            "mend": self.help,
        }
        if self.operation is not None:
            entry["operation"] = self.operation
        if self.parameter is not None:
            entry["parameter"] = self.parameter
        return entry

    @property
    def mend(self) -> str:
        """`help` by its former name."""
        return self.help


@dataclass(frozen=True, slots=True)
class Report:
    """What a check found.

    frame        the bytes that were checked
    accepted     whether the brick will run the command; of all but direct commands, whether nothing in it stops that
    rejected_at  offset in the frame where the brick gives up: the operation, or the field of the header; None where it
                 accepts
    findings     in the order of their offsets
    dialect      the firmware whose instruction set it was read by
    carrier      what was to carry it; None where that did not matter
    """

    frame: bytes
    accepted: bool
    rejected_at: int | None
    findings: tuple[Finding, ...]
    dialect: str = "official"
    carrier: str | None = None

    def __str__(self) -> str:
        """What `ev3proto check` prints of it."""
        return uses.report_text(self)

    @property
    def fixed(self) -> Fix:
        """The frame with everything fixed that can be fixed with certainty, as `ev3proto check --fix` prints it."""
        return uses.fix(self.frame, dialect=self.dialect, carrier=self.carrier)

    def of(self, severity: Severity) -> tuple[Finding, ...]:
        """The findings of one severity."""
        return tuple(finding for finding in self.findings if finding.severity is severity)

    @property
    def errors(self) -> tuple[Finding, ...]:
        """What will not do what was meant."""
        return self.of(Severity.ERROR)

    @property
    def warnings(self) -> tuple[Finding, ...]:
        """What may not do what was meant."""
        return self.of(Severity.WARNING)

    def as_dict(self) -> dict[str, Any]:
        """The same for other tools."""
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
    before  what stood there
    after   what stands there now
    why     half a sentence
    """

    what: str
    before: str
    after: str
    why: str

    def __str__(self) -> str:
        return f"{self.what}: {self.before} -> {self.after} ({self.why})"

    def as_dict(self) -> dict[str, str]:
        """The same for other tools."""
        return {name: getattr(self, name) for name in self.__slots__}


@dataclass(frozen=True, slots=True)
class Fix:
    """A frame and what was fixed in it.

    frame     the fixed bytes; those that were given where nothing was fixed
    changes   what was fixed, in the order in which it was done
    unfixed   sentences: what looked fixable and was left, and why
    report    what a check says of the fixed bytes
    """

    frame: bytes
    changes: tuple[Change, ...]
    unfixed: tuple[str, ...]
    report: Report

    def __str__(self) -> str:
        """What `ev3proto check --fix` prints of it."""
        return uses.fix_text(self)

    @property
    def unmended(self) -> tuple[str, ...]:
        """`unfixed` by its former name."""
        return self.unfixed

    def as_dict(self) -> dict[str, Any]:
        """The same for other tools; `hex` is the fixed frame."""
        return {
            **self.report.as_dict(),
            "changes": [change.as_dict() for change in self.changes],
            "unmended": list(self.unfixed),
        }


class Uses:
    """What floors above give a report to do; each registers its function when it is loaded.

    fix          fixes a frame: `checking.fixing`
    report_text  what is printed of a report, and
    fix_text     of a fix: `text.diagnostics`, which `ev3proto.check` and `ev3proto.fix` load
    """

    fix: Callable[..., Fix]
    report_text: Callable[[Report], str] = staticmethod(repr)
    fix_text: Callable[[Fix], str] = staticmethod(repr)


uses = Uses()
