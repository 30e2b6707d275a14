"""What a check finds: the brick's own verdict, and one finding for everything that should be looked at."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ev3proto.checking.fixing import Fix


class Severity(StrEnum):
    """How bad it is: an error will not do what was meant, a warning may not, a hint only could be done better."""

    ERROR = "error"
    WARNING = "warning"
    HINT = "hint"


@dataclass(frozen=True, slots=True, init=False)
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

    # A frame may have a thousand of them. The method that a frozen class gets takes three times as long as to fill the
    # slots: `pytest benchmarks -k checking` shows it in "check".
    def __init__(
        self,
        severity: Severity,
        code: str,
        offset: int,
        length: int,
        message: str,
        help: str,
        operation: str | None = None,
        parameter: str | None = None,
    ) -> None:
        _set_severity(self, severity)
        _set_code(self, code)
        _set_offset(self, offset)
        _set_length(self, length)
        _set_message(self, message)
        _set_help(self, help)
        _set_operation(self, operation)
        _set_parameter(self, parameter)

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


_set_severity, _set_code, _set_offset, _set_length, _set_message, _set_help, _set_operation, _set_parameter = (
    getattr(Finding, name).__set__ for name in Finding.__slots__
)


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
        from ev3proto.text.diagnostics import diagnostics
        from ev3proto.text.spans import plain_text
        from ev3proto.text.visible import visible

        return "\n".join(visible(plain_text(line)) for line in diagnostics(self, dialect=self.dialect))

    @property
    def fixed(self) -> Fix:
        """The frame with everything fixed that can be fixed with certainty, as `ev3proto check --fix` prints it."""
        from ev3proto.checking.fixing import fix

        return fix(self.frame, dialect=self.dialect, carrier=self.carrier)

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
