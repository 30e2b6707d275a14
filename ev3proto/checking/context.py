"""What the rules look at: a frame, the message in it, its operations with their arguments, the brick's verdict."""

from __future__ import annotations

from dataclasses import dataclass

from ev3proto.checking.codes import Code
from ev3proto.checking.facts import OperationFacts, operation_facts
from ev3proto.checking.report import Finding
from ev3proto.checking.verdict import Verdict
from ev3proto.errors import Fault
from ev3proto.messages import Argument, Message, Operation
from ev3proto.schema.header import HEADER_SIZE, frame_size
from ev3proto.tables.declaration import Effect
from ev3proto.tables.frame import MAX_FRAME, REPORT_SIZES

# Rules read the fields of these two all the time, and reading a slot takes a quarter of the time of a named tuple's
# field. They are not frozen, since making them would take three times as long.


@dataclass(slots=True)
class CheckedOperation:
    """An operation with what the rules ask of it again and again.

    parsed     the operation itself
    facts      what is known of it
    name       `SOUND.TONE`
    arguments  what follows opcode and CMD; of an operation that is cut off, those that can be read
    start      offset of its opcode
    end        offset after it
    """

    parsed: Operation
    facts: OperationFacts
    name: str
    arguments: tuple[Argument, ...]
    start: int
    end: int

    def has(self, effect: Effect) -> bool:
        """Whether it has an effect."""
        # Most operations have none. Of the others it is asked in their tuple: a set takes long to hash an effect.
        facts = self.facts
        return bool(facts.effects) and effect in facts.declaration.effects

    def finding(self, code: Code, message: str, help_: str) -> Finding:
        """A finding about the operation as a whole."""
        return code.finding(self.start, self.end - self.start, message, help_, self.name)

    def finding_at(self, code: Code, argument: Argument, message: str, help_: str) -> Finding:
        """A finding about one of its arguments."""
        parameter, form, _, offset, _ = argument
        length = argument.length if form.width is None else 1 + form.width
        return Finding(code.severity, code.code, offset, length, message, help_, self.name, parameter.name)


def checked_operations(operations: tuple[Operation, ...]) -> tuple[CheckedOperation, ...]:
    """Operations as the rules look at them, as far as the firmware reads them."""
    found: list[CheckedOperation] = []
    for parsed in operations:
        facts = operation_facts(parsed[0])
        found.append(CheckedOperation(parsed, facts, facts.name, parsed.arguments, parsed[2], parsed[3]))
        if facts.ends_code:
            break
    return tuple(found)


@dataclass(slots=True)
class CheckContext:
    """A frame that is checked, with all that the rules may look at.

    frame       the bytes
    end         where the message ends: where its length field says, or where the bytes do
    message     what `frame[:end]` says
    verdict     what the brick says to it
    operations  the operations of a direct command, as far as the firmware reads them: up to an OBJECT_END
    effects     what any of them does besides what its parameters say
    has_jumps   any of them says where to go on
    dialect     the firmware whose instruction set it is read by
    carrier     what is to carry it, None for any
    """

    frame: bytes
    end: int
    message: Message
    verdict: Verdict
    operations: tuple[CheckedOperation, ...]
    effects: frozenset[Effect]
    has_jumps: bool
    dialect: str
    carrier: str | None

    @property
    def fault(self) -> Fault | None:
        """What cannot be read in the message.

        None also for one that is too long, or where an OBJECT_END comes before it: that alone is reported then.
        """
        if self.end > MAX_FRAME or (self.operations and self.operations[-1].facts.ends_code):
            return None
        return self.message.flaw.fault

    @property
    def is_whole(self) -> bool:
        """Whether the operations are all that there is."""
        return self.fault is None and (not self.operations or self.operations[-1].end == self.end)

    @property
    def is_padded(self) -> bool:
        """Whether nothing but zeros follow the message, as many as fill it up to a USB report."""
        frame, end = self.frame, self.end
        return end < len(frame) and end >= HEADER_SIZE and len(frame) in REPORT_SIZES and not any(frame[end:])

    @property
    def is_length_wrong(self) -> bool:
        """Whether the length field does not say how many bytes follow it, and they are no padding."""
        frame = self.frame
        return frame_size(frame) != len(frame) and not self.is_padded
