"""The input of the rules: a frame, its message, the operations with their arguments, the brick's verdict."""

from __future__ import annotations

from dataclasses import dataclass, field

from ev3proto.checking.codes import FindingCode
from ev3proto.checking.report import Finding
from ev3proto.checking.verdict import Verdict
from ev3proto.errors import Fault
from ev3proto.messages import Argument, Message, Operation
from ev3proto.schema.header import HEADER_SIZE, frame_size, may_be_long
from ev3proto.semantics.facts import OperationFacts, operation_facts
from ev3proto.semantics.footprint import whole_number
from ev3proto.semantics.judgement import Wrong
from ev3proto.tables.declaration import Effect, Role
from ev3proto.tables.frame import MAX_FRAME, MAX_LONG_FRAME, REPORT_SIZES
from ev3proto.tables.output import MOTOR_LETTERS

MotorAt = tuple[int, int]
"""The layer of a brick in a daisy chain, and the number of its port."""

# The rules read these fields very often, and reading a slot takes a quarter of the time of a named tuple's
# field. They are not frozen because creating a frozen one takes three times as long.


@dataclass(slots=True)
class CheckedOperation:
    """An operation with the values that the rules use repeatedly."""

    parsed: Operation
    facts: OperationFacts
    name: str  # `SOUND.TONE`
    # the arguments after opcode and CMD; if the operation is cut off, the readable ones
    arguments: tuple[Argument, ...]
    start: int  # offset of its opcode
    end: int  # offset after it

    def has(self, effect: Effect) -> bool:
        """Whether it has an effect."""
        # A tuple, since most operations have no effects and hashing an effect for a set is slow.
        facts = self.facts
        return bool(facts.effects) and effect in facts.declaration.effects

    @property
    def motors(self) -> list[MotorAt] | None:
        """The motors that it is for; None if they are not known, or if it is for none."""
        known = {argument.parameter.role: whole_number(argument) for argument in self.arguments}
        layer, mask, number = (known.get(role) for role in (Role.LAYER, Role.MOTORS, Role.MOTOR))
        if layer is None or (mask is None and number is None):
            return None
        return [(layer, port) for port in MOTOR_LETTERS if port == number or (mask is not None and mask & 1 << port)]

    def finding(self, code: FindingCode, key: Wrong | Role | str = "", /, **parts: object) -> Finding:
        """Returns a finding about the whole operation, in the words of the code."""
        return code.at(self.start, self.end - self.start, key, owner=self.name, **parts)

    def finding_of(
        self, code: FindingCode, argument: Argument, key: Wrong | Role | str = "", /, **parts: object
    ) -> Finding:
        """Returns a finding about one of its arguments, in the words of the code."""
        return code.at(argument.offset, argument.length, key, owner=self.name, name=argument.name, **parts)


def checked_operations(operations: tuple[Operation, ...]) -> tuple[CheckedOperation, ...]:
    """Returns the operations for the rules, as far as the firmware reads them."""
    found: list[CheckedOperation] = []
    for parsed in operations:
        facts = operation_facts(parsed.schema)
        start = parsed.offset
        found.append(CheckedOperation(parsed, facts, facts.name, parsed.arguments, start, start + parsed.length))
        if facts.ends_code:
            break
    return tuple(found)


@dataclass(slots=True)
class CheckContext:
    """A frame with everything that the rules read."""

    frame: bytes
    end: int  # the end of the message: that of the length field, or that of the bytes
    message: Message  # the message in `frame[:end]`
    verdict: Verdict  # the brick's verdict
    # the operations of a direct command, as far as the firmware reads them: up to an OBJECT_END
    operations: tuple[CheckedOperation, ...]
    effects: frozenset[Effect]  # the side effects of all of them
    has_jumps: bool  # whether any of them jumps
    dialect: str  # the firmware whose instruction set is used
    carrier: str | None  # the carrier, None for any
    is_alone: bool = False  # whether no other command belongs to it

    # maximum length of this frame, in bytes: downloads may be longer, except on USB
    most: int = field(init=False)
    # the part of the message that cannot be read; None also if the frame is too long, or an OBJECT_END comes first:
    # then only that is reported
    fault: Fault | None = field(init=False)

    def __post_init__(self) -> None:
        self.most = MAX_LONG_FRAME if self.carrier != "usb" and may_be_long(self.frame) else MAX_FRAME
        is_over = self.end > self.most or (self.operations and self.operations[-1].facts.ends_code)
        self.fault = None if is_over else self.message.flaw.fault

    @property
    def own_fault(self) -> Fault | None:
        """The fault that is not explained by a wrong length field."""
        fault = self.fault
        return None if fault is not None and fault.truncated and self.is_length_wrong else fault

    @property
    def is_whole(self) -> bool:
        """Whether the operations are complete."""
        return self.fault is None and (not self.operations or self.operations[-1].end == self.end)

    @property
    def is_padded(self) -> bool:
        """Whether the message is padded with zeros to the size of a USB report."""
        frame, end = self.frame, self.end
        return end < len(frame) and end >= HEADER_SIZE and len(frame) in REPORT_SIZES and not any(frame[end:])

    @property
    def is_length_wrong(self) -> bool:
        """Whether the length field does not match the bytes after it, padding aside."""
        frame = self.frame
        return frame_size(frame) != len(frame) and not self.is_padded
