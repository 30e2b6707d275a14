"""The explanation of a code of the checker, with its examples, of frames or of programs."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking.checking import check
from ev3proto.checking.codes import FindingCode
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.program.checking import check_program
from ev3proto.program.report import program_findings
from ev3proto.text.diagnostics import diagnostics, explanation, grouped_hex
from ev3proto.text.phrases import spaced_hex
from ev3proto.text.spans import Line


def explained(code: FindingCode, *, dialect: str = "official") -> Iterator[Line]:
    """Yields what `ev3proto check --explain` prints of a code."""
    if code.code in PROGRAM_CODES:
        program = check_program(code.example, dialect=dialect)
        return explanation(code, program_findings(program, program.findings), spaced_hex)
    report = check(code.example, dialect=dialect, carrier=code.carrier, alone=code.alone)
    return explanation(code, diagnostics(report, dialect=dialect), lambda frame: grouped_hex(frame, dialect))
