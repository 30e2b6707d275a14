"""What the rules look at: a frame, the message in it, its operations with their arguments, the brick's verdict."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from ev3proto.checking.codes import Code
from ev3proto.checking.report import Finding
from ev3proto.checking.verdict import Verdict
from ev3proto.errors import Fault
from ev3proto.messages import Argument, Message, Operation, OperationReader
from ev3proto.schema.header import HEADER_SIZE, frame_size, may_be_long
from ev3proto.semantics.domain import Domain, domain_of
from ev3proto.semantics.footprint import MemoryFacts, memory_facts
from ev3proto.tables.declaration import Declaration, Direction, Effect, Parameter, Type
from ev3proto.tables.encoding import RANGES, Range
from ev3proto.tables.frame import MAX_FRAME, MAX_LONG_FRAME, REPORT_SIZES


@dataclass(frozen=True, slots=True)
class ParameterFacts:
    """What the rules need to know of a parameter.

    parameter  the parameter
    numbers    whole numbers about which there is nothing to say; there may be more
    domain     the numbers that the tables tell, None where the type alone limits them
    limits     the numbers that its bytes hold, None where it is no number of so many bytes
    outside    what follows a number that is none of the domain: ` Hz, outside of 250 to 10000 Hz`
    advice     what to give instead
    """

    parameter: Parameter
    numbers: range | frozenset[int]
    domain: Domain | None
    limits: Range | None
    outside: str
    advice: str


@dataclass(frozen=True, slots=True)
class OperationFacts:
    """What the rules need to know of an operation besides its arguments.

    declaration  what the tables say of it
    name         `SOUND.TONE`
    parameters   of each argument before the elements of a list
    memory       the same for the memory that a variable in their place takes
    effects      what it does besides what its parameters say
    has_cmd      its opcode has CMDs
    is_jump      its last argument says where to
    has_lists    it takes texts or arrays of which the tables tell how long they are or may be
    ends_code    the firmware reads nothing after it
    is_newer     the validator of the release of 2013 does not know it
    """

    declaration: Declaration
    name: str
    parameters: tuple[ParameterFacts, ...]
    memory: tuple[MemoryFacts, ...]
    effects: frozenset[Effect]
    has_cmd: bool
    is_jump: bool
    has_lists: bool
    ends_code: bool
    is_newer: bool


@cache
def operation_facts(schema: OperationReader) -> OperationFacts:
    """What is known of an operation."""
    declaration = schema.declaration
    parameters = declaration.parameters
    fixed = parameters[:-1] if parameters and parameters[-1].type is Type.VALUES else parameters
    return OperationFacts(
        declaration,
        declaration.name,
        tuple(parameter_facts(parameter) for parameter in fixed),
        memory_facts(schema),
        frozenset(declaration.effects),
        declaration.command is not None,
        is_jump=declaration.is_jump,
        has_lists=any(parameter.length is not None or parameter.most is not None for parameter in parameters),
        ends_code=Effect.ENDS_CODE in declaration.effects,
        is_newer=declaration.is_newer,
    )


@cache
def parameter_facts(parameter: Parameter) -> ParameterFacts:
    """What is known of a parameter, or of an element of a list."""
    domain = domain_of(parameter)
    if domain is not None and not domain.is_documented:
        domain = None
    limits = RANGES[parameter.type] if parameter.type in _NUMBERS else None
    return ParameterFacts(parameter, _numbers(parameter, domain), domain, limits, *_sentences(parameter, domain))


_NUMBERS = (Type.DATA8, Type.DATA16, Type.DATA32, Type.HANDLE)


def _sentences(parameter: Parameter, domain: Domain | None) -> tuple[str, str]:
    """What is said of a number that is none of the domain: what is wrong, after the number, and what to give."""
    if domain is None:
        return "", ""
    if domain.has_names:
        assert parameter.enum is not None
        return f", which {parameter.enum.name} has no name for", f"give {domain.choice}"
    unit = f" {parameter.unit}" if parameter.unit else ""
    return f"{unit}, outside of {domain.text}", f"give {domain.text}"


def _numbers(parameter: Parameter, domain: Domain | None) -> range | frozenset[int]:
    if parameter.direction is not Direction.IN or parameter.type in (Type.STRING, Type.DATAF, Type.LABEL):
        return frozenset()
    limits = RANGES.get(parameter.validated or parameter.type)
    if limits is None:
        return frozenset()
    whole = range(limits.low, limits.high + 1)
    if domain is None:
        return whole
    if domain.spans:
        low, high = domain.spans[0]
        return range(max(low, limits.low), min(high, limits.high) + 1)
    return frozenset(number for number in domain.singles if number in whole)


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
        if self.end > self.most or (self.operations and self.operations[-1].facts.ends_code):
            return None
        return self.message.flaw.fault

    @property
    def most(self) -> int:
        """Most bytes that a frame like this one may have: but on USB, downloads may be longer than others."""
        return MAX_LONG_FRAME if self.carrier != "usb" and may_be_long(self.frame) else MAX_FRAME

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
