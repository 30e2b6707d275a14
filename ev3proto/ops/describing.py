"""What the tables say of an operation, as the text that editors and `help` show."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from textwrap import wrap

from ev3proto.compose.drafts import may_be_left_away
from ev3proto.semantics.domain import limits
from ev3proto.tables.declaration import Declaration, Direction, Parameter, Type

WIDTH = 100
"""Columns of the text; editors show it in narrow windows."""


def described(declaration: Declaration, names: Sequence[str]) -> str:
    """A sentence, and a line for each parameter: meaning, unit, range, special values, type.

    names  of the parameters, as Python writes them
    """
    lines = [f"{declaration.text}."]
    width = max(map(len, names), default=0)
    if names:
        lines.append("")
    for number, (name, parameter) in enumerate(zip(names, declaration.parameters, strict=True)):
        text = "; ".join(_pieces(parameter, is_optional=may_be_left_away(declaration, number)))
        lines += wrap(
            text,
            WIDTH,
            initial_indent=f"{name.ljust(width)}  ",
            subsequent_indent=" " * (width + 2),
            break_long_words=False,
            break_on_hyphens=False,
        )
    return "\n".join(lines)


def _pieces(parameter: Parameter, *, is_optional: bool) -> Iterator[str]:
    yield parameter.text
    span = limits(parameter)
    if span:
        yield span
    if parameter.most is not None:
        yield f"at most {parameter.most - 1} characters"
    if parameter.special:
        yield ", ".join(f"{number}: {text}" for number, text in parameter.special.items())
    if parameter.enum is not None:
        yield f"a member of {parameter.enum.name}"
    yield _type(parameter)
    if parameter.type is Type.COUNT and is_optional:
        yield "an output for each: a list of variables, or how many; one when left away"
    elif parameter.direction is Direction.OUT:
        yield "an output, in global memory when left away"
    elif is_optional:
        yield "worked out when left away"


def _type(parameter: Parameter) -> str:
    """`DATA16`, or what a list has."""
    if parameter.type in (Type.COUNT, Type.VALUES):
        element = parameter.element
        if isinstance(element, str):
            return f"a list, of the type that {element.lower()} tells"
        return f"a list of {element.label}" if isinstance(element, Type) else "a list"
    if parameter.direction is Direction.INOUT:
        return f"{parameter.type.label}, a variable that is read and written"
    return parameter.type.label
