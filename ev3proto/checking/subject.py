"""What the rules look at: a frame, the message in it, its operations with their arguments, the brick's verdict."""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.checking.codes import Code
from ev3proto.checking.report import Finding
from ev3proto.checking.traits import Traits, traits_of
from ev3proto.checking.verdict import Verdict
from ev3proto.errors import Fault
from ev3proto.messages import Argument, Message, Operation
from ev3proto.schema.frame import HEADER_SIZE
from ev3proto.tables.declaration import Declaration
from ev3proto.tables.frame import LENGTH_FIELD, MAX_FRAME, REPORT_SIZES

OBJECT_END = "OBJECT_END"
"""The operation at which the firmware stops reading."""


class Step(NamedTuple):
    """An operation with what is asked of it again and again.

    operation  the operation itself
    traits     what is known of it
    name       `SOUND.TONE`
    arguments  what follows opcode and CMD; of an operation that is cut off, those that can be read
    start      offset of its opcode
    end        offset behind it
    """

    operation: Operation
    traits: Traits
    name: str
    arguments: tuple[Argument, ...]
    start: int
    end: int

    @property
    def declaration(self) -> Declaration:
        """What the tables say of it."""
        return self.traits.declaration

    def finding(self, code: Code, message: str, mend: str) -> Finding:
        """Something about the operation as a whole."""
        return code.finding(self.start, self.end - self.start, message, mend, self.name)

    def finding_at(self, code: Code, argument: Argument, message: str, mend: str) -> Finding:
        """Something about one of its arguments."""
        parameter, _, _, offset, _ = argument
        return Finding(code.severity, code.code, offset, argument.length, message, mend, self.name, parameter.name)


def step_of(operation: Operation) -> Step:
    """An operation as a step."""
    schema, _, start, end = operation
    traits = traits_of(schema)
    return Step(operation, traits, traits.name, operation.arguments, start, end)


def steps_of(operations: tuple[Operation, ...]) -> tuple[Step, ...]:
    """Operations as steps, up to an OBJECT_END."""
    steps: list[Step] = []
    for operation in operations:
        step = step_of(operation)
        steps.append(step)
        if step.name == OBJECT_END:
            break
    return tuple(steps)


class Subject(NamedTuple):
    """A frame that is checked.

    frame    the bytes
    end      where the message ends: where its length field says, or where the bytes do
    message  what `frame[:end]` says
    verdict  what the brick says to it
    steps    the operations of a direct command, as far as the firmware reads them: up to an OBJECT_END
    dialect  the firmware whose instruction set it is read by
    carrier  what is to carry it, None for any
    """

    frame: bytes
    end: int
    message: Message
    verdict: Verdict
    steps: tuple[Step, ...]
    dialect: str
    carrier: str | None

    @property
    def fault(self) -> Fault | None:
        """What cannot be read in the message.

        None also for one that is too long, or where an OBJECT_END stands in front of it: that alone is said then.
        """
        if self.end > MAX_FRAME or (self.steps and self.steps[-1].name == OBJECT_END):
            return None
        return self.message.flaw.fault

    @property
    def is_whole(self) -> bool:
        """Whether the steps are all that there is."""
        return self.fault is None and (not self.steps or self.steps[-1].end == self.end)

    @property
    def is_padded(self) -> bool:
        """Whether nothing but zeros follow the message, as many as fill it up to a USB report."""
        frame, end = self.frame, self.end
        return end < len(frame) and end >= HEADER_SIZE and len(frame) in REPORT_SIZES and not any(frame[end:])

    @property
    def is_length_wrong(self) -> bool:
        """Whether the length field does not say how many bytes follow it, and they are no padding."""
        frame = self.frame
        return (frame[0] | frame[1] << 8) + LENGTH_FIELD != len(frame) and not self.is_padded
