"""What is wrong with a frame that was read, as `decode` says it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ev3proto.capture.record import Record
from ev3proto.checking.report import Severity, Suggestion
from ev3proto.messages import Message
from ev3proto.reading.items import Problem, ProblemCode
from ev3proto.schema.frame import frame_reader, parse
from ev3proto.semantics.advice import advice
from ev3proto.semantics.identify import foreign, never_run
from ev3proto.text.phrases import command_spans
from ev3proto.text.spans import plain_text

if TYPE_CHECKING:
    from ev3proto.checking.nearest import Suggestions


class Faults:
    """What is wrong with the frames of one run; what was meant is looked for in at most 100 different ones."""

    def __init__(self, dialect: str = "official") -> None:
        self._dialect = dialect
        self._suggestions: Suggestions | None = None

    def of(self, record: Record, *, is_text: bool = True) -> Problem | None:
        """Returns what is wrong with a frame, unless it was cut off: of the bytes in a text, also what was meant."""
        message, place = record.message, record.place
        if record.fault is not None or not is_text or record.missing:
            return self._fault(record, is_text=is_text)
        if record.is_from_brick and record.seen.direction is None:
            # A command without its counter is a reply by its type.
            for one in self._meant(message):
                content = plain_text(command_spans(parse(one.frame, strict=False, dialect=self._dialect)))
                return Problem(place, ProblemCode.FAULT, f"did you mean {content}? {one.message}", Severity.HINT)
        never = never_run(message)
        if never is None:
            return None
        said = f"offset {never.offset}: opcode 0x{never.opcode:02X} is {never.name}, which the brick refuses"
        return Problem(place._replace(offset=never.offset), ProblemCode.FAULT, f"{said}; `ev3proto check` says more")

    def _fault(self, record: Record, *, is_text: bool) -> Problem | None:
        fault = record.fault
        if fault is None:
            return None
        named = advice(foreign(record.frame, frame_reader(self._dialect)))
        meant = [f"; did you mean: {one.message}?" for one in self._meant(record.message)] if is_text else []
        sentence = f"{f'{named}; ' if named else ''}fault at {fault}{''.join(meant)}"
        return Problem(record.place._replace(offset=fault.offset), ProblemCode.FAULT, sentence)

    def _meant(self, message: Message) -> tuple[Suggestion, ...]:
        """Returns what was probably meant by a frame that has a fault, or is not the reply that it seems to be."""
        # These take 15 ms, which right frames do not need.
        from ev3proto.checking.checking import check
        from ev3proto.checking.nearest import Suggestions

        if self._suggestions is None:
            self._suggestions = Suggestions()
        return self._suggestions.of(check(message, dialect=self._dialect, alone=True))
