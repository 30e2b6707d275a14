"""The input of the rules: a frame, its message, the operations with their arguments, the brick's verdict."""

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
from ev3proto.tables.declaration import Declaration, Direction, Effect, Parameter, Type
from ev3proto.tables.encoding import RANGES, Range
from ev3proto.tables.frame import MAX_FRAME, MAX_LONG_FRAME, REPORT_SIZES


@dataclass(frozen=True, slots=True)
class ParameterFacts:
    """The facts about a parameter that the rules need.

    parameter  the parameter
    numbers    whole numbers that need no finding; not necessarily all of them
    domain     the legal numbers of the tables, None if only the type limits them
    limits     the numbers that its bytes can hold, None if it is not a number of fixed size
    outside    the text after a number outside the domain: ` Hz, outside of 250 to 10000 Hz`
    advice     what to use instead
    """

    parameter: Parameter
    numbers: range | frozenset[int]
    domain: Domain | None
    limits: Range | None
    outside: str
    advice: str


@dataclass(frozen=True, slots=True)
class OperationFacts:
    """The facts about an operation, besides its arguments, that the rules need.

    declaration  its entry in the tables
    name         `SOUND.TONE`
    parameters   facts of each argument before the elements of a list
    effects      its side effects
    has_cmd      whether its opcode has CMDs
    is_jump      whether its last argument is a jump target
    has_lists    whether it takes texts or arrays with a known or limited length
    ends_code    whether the firmware reads nothing after it
    is_newer     whether the validator of the release of 2013 does not know it
    """

    declaration: Declaration
    name: str
    parameters: tuple[ParameterFacts, ...]
    effects: frozenset[Effect]
    has_cmd: bool
    is_jump: bool
    has_lists: bool
    ends_code: bool
    is_newer: bool


@cache
def operation_facts(schema: OperationReader) -> OperationFacts:
    """Returns the facts about an operation."""
    declaration = schema.declaration
    parameters = declaration.parameters
    fixed = parameters[:-1] if parameters and parameters[-1].type is Type.VALUES else parameters
    return OperationFacts(
        declaration,
        declaration.name,
        tuple(parameter_facts(parameter) for parameter in fixed),
        frozenset(declaration.effects),
        declaration.command is not None,
        is_jump=declaration.is_jump,
        has_lists=any(parameter.length is not None or parameter.most is not None for parameter in parameters),
        ends_code=Effect.ENDS_CODE in declaration.effects,
        is_newer=declaration.is_newer,
    )


@cache
def parameter_facts(parameter: Parameter) -> ParameterFacts:
    """Returns the facts about a parameter, or an element of a list."""
    domain = domain_of(parameter)
    if domain is not None and not domain.is_documented:
        domain = None
    limits = RANGES[parameter.type] if parameter.type in _NUMBERS else None
    return ParameterFacts(parameter, _numbers(parameter, domain), domain, limits, *_sentences(parameter, domain))


_NUMBERS = (Type.DATA8, Type.DATA16, Type.DATA32, Type.HANDLE)


def _sentences(parameter: Parameter, domain: Domain | None) -> tuple[str, str]:
    """Returns the texts for a number outside the domain: what is wrong (after the number), and what to use instead."""
    if domain is None:
        return "", ""
    if domain.has_names:
        assert parameter.enum is not None
        return f", which is not in {parameter.enum.name}", f"use {domain.choice}"
    unit = f" {parameter.unit}" if parameter.unit else ""
    return f"{unit}, outside of {domain.text}", f"use {domain.text}"


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


# The rules read these fields very often, and reading a slot takes a quarter of the time of a named tuple's
# field. They are not frozen because creating a frozen one takes three times as long.


@dataclass(slots=True)
class CheckedOperation:
    """An operation with the values that the rules use repeatedly.

    parsed     the operation itself
    facts      its facts
    name       `SOUND.TONE`
    arguments  the arguments after opcode and CMD; if the operation is cut off, the readable ones
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
        # A tuple, since most operations have no effects and hashing an effect for a set is slow.
        facts = self.facts
        return bool(facts.effects) and effect in facts.declaration.effects

    def finding(self, code: Code, message: str, help_: str) -> Finding:
        """Returns a finding about the whole operation."""
        return code.finding(self.start, self.end - self.start, message, help_, self.name)

    def finding_at(self, code: Code, argument: Argument, message: str, help_: str) -> Finding:
        """Returns a finding about one of its arguments."""
        parameter, form, _, offset, _ = argument
        length = argument.length if form.width is None else 1 + form.width
        return Finding(code.severity, code.code, offset, length, message, help_, self.name, parameter.name)


def checked_operations(operations: tuple[Operation, ...]) -> tuple[CheckedOperation, ...]:
    """Returns the operations for the rules, as far as the firmware reads them."""
    found: list[CheckedOperation] = []
    for parsed in operations:
        facts = operation_facts(parsed.schema)
        found.append(CheckedOperation(parsed, facts, facts.name, parsed.arguments, parsed[2], parsed[3]))
        if facts.ends_code:
            break
    return tuple(found)


@dataclass(slots=True)
class CheckContext:
    """A frame with everything that the rules read.

    frame       the bytes
    end         the end of the message: that of the length field, or that of the bytes
    message     the message in `frame[:end]`
    verdict     the brick's verdict
    operations  the operations of a direct command, as far as the firmware reads them: up to an OBJECT_END
    effects     the side effects of all of them
    has_jumps   whether any of them jumps
    dialect     the firmware whose instruction set is used
    carrier     the carrier, None for any
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
        """The part of the message that cannot be read.

        None also if the frame is too long, or an OBJECT_END comes first: then only that is reported.
        """
        if self.end > self.most or (self.operations and self.operations[-1].facts.ends_code):
            return None
        return self.message.flaw.fault

    @property
    def most(self) -> int:
        """Maximum length of this frame, in bytes: downloads may be longer, except on USB."""
        return MAX_LONG_FRAME if self.carrier != "usb" and may_be_long(self.frame) else MAX_FRAME

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
