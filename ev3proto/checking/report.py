"""What a check finds: the brick's own verdict, and one finding for everything that should be looked at."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Any


class Severity(StrEnum):
    """How bad it is: an error will not do what was meant, a warning may not, a hint only could be done better."""

    ERROR = "error"
    WARNING = "warning"
    HINT = "hint"


_KEYS = {"help": "mend"}
"""Keys for other tools that are not named as the field is."""


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
        """The same for other tools; keys that do not apply are absent."""
        entry = {_KEYS.get(name, name): getattr(self, name) for name in self.__slots__}
        return {name: value for name, value in entry.items() if value is not None}

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
    """

    frame: bytes
    accepted: bool
    rejected_at: int | None
    findings: tuple[Finding, ...]

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
