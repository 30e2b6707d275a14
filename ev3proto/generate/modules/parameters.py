"""What the tables say of a parameter, as the sentence that editors and `help` show."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.generate.modules.source import sentence
from ev3proto.semantics.descriptions import facts
from ev3proto.tables.declaration import LISTS, Direction, Parameter, Type


def text_of(parameter: Parameter, *, is_optional: bool) -> str:
    """Meaning, unit, range, special values and type: `How loud; 0 to 100 %; 0: silent; DATA8.`"""
    return sentence(*_pieces(parameter, is_optional=is_optional))


def _pieces(parameter: Parameter, *, is_optional: bool) -> Iterator[str]:
    yield parameter.text
    yield from facts(parameter)
    yield _type(parameter)
    if parameter.type is Type.COUNT and is_optional:
        yield "an output for each: a list of variables, or how many; one when omitted"
    elif parameter.direction is Direction.OUT:
        yield "an output, in global memory when omitted"
    elif is_optional:
        yield "worked out when omitted"


def _type(parameter: Parameter) -> str:
    """`DATA16`, or what a list has."""
    if parameter.type in LISTS:
        element = parameter.element
        if isinstance(element, str):
            return f"a list, of the type that {element.lower()} says"
        return f"a list of {element.label}" if isinstance(element, Type) else "a list"
    if parameter.direction is Direction.INOUT:
        return f"{parameter.type.label}, a variable that is read and written"
    return parameter.type.label
