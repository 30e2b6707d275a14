"""What the rules need to know of an operation, worked out from the tables once and for all frames."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from ev3proto.messages import OperationReader
from ev3proto.semantics.domain import Domain, domain_of
from ev3proto.semantics.footprint import MemoryFacts, memory_facts
from ev3proto.tables.declaration import Declaration, Direction, Effect, Parameter, Type
from ev3proto.tables.encoding import RANGES, Range


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
