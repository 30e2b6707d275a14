"""What the tables say a value may be, beyond what its type can hold: documented ranges, names, single special values.

A value that means nothing to the brick is refused where it is written down. Whoever means it says `unchecked=True`.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from ev3proto.errors import BuildError, near_misses
from ev3proto.messages import Argument
from ev3proto.semantics.domain import domain_of
from ev3proto.semantics.footprint import Footprint
from ev3proto.semantics.inline_arrays import inline_arrays
from ev3proto.tables.declaration import Direction, Parameter
from ev3proto.tables.encoding import CONSTANT, RANGES, TEXT

HOW_TO_MEAN_IT = "unchecked=True lets it through"


def check_meaning(argument: Argument) -> None:
    """Refuses a constant that is not legal, in an argument that is encoded.

    Raises:
        BuildError: Names the parameter and what would be right.
    """
    parameter, form, value, *_ = argument
    if form.handle or form.address or argument.is_variable:
        return
    if parameter.direction is not Direction.IN:
        raise no_variable(parameter, value)
    if form.kind == CONSTANT and not isinstance(value, str):
        check_number(parameter, value)


def check_places(used: Iterable[Footprint]) -> None:
    """Refuses misaligned variables, for which the brick refuses the whole command."""
    for footprint in used:
        multiple = footprint.validator_alignment
        if footprint.start % multiple:
            kind = "a handle" if footprint.argument.form.handle else footprint.argument.parameter.type.label
            raise BuildError(
                f"{footprint.argument.name} cannot be {footprint.variable}: as {kind} it must be at a multiple of"
                f" {multiple}, or the brick refuses it; {HOW_TO_MEAN_IT}"
            )


def check_number(parameter: Parameter, value: float) -> None:
    """The same for a number that is not encoded yet."""
    domain = domain_of(parameter)
    if domain is not None and not domain.covers(value):
        hint = f"; {HOW_TO_MEAN_IT}" if _can_be(parameter, value) else ""
        raise BuildError(f"{parameter.name} must be {domain.choice}, not {value}{hint}")


def check_text(parameter: Parameter, value: str) -> None:
    """The same for a text that is not encoded yet: some have a largest length."""
    size = len(value) + 1
    if parameter.most is not None and size > parameter.most:
        raise BuildError(
            f"{parameter.name} has {size - 1} characters, and the firmware takes {parameter.most - 1} at most;"
            f" {HOW_TO_MEAN_IT}"
        )


def check_arrays(arguments: Sequence[Argument]) -> None:
    """Refuses arrays that stand in the operation itself and have fewer bytes than their length says."""
    for array in inline_arrays(arguments):
        if array.stated > array.present:
            argument = array.argument
            has = f"a text of {array.present} bytes with its zero" if argument.kind == TEXT else "one number"
            raise BuildError(
                f"{argument.name} cannot be {argument.value!r}: {array.length} says that it has {array.stated} bytes,"
                f" and this is {has}; {HOW_TO_MEAN_IT}"
            )


def _can_be(parameter: Parameter, value: float) -> bool:
    """Whether there is an encoding for it."""
    limits = RANGES.get(parameter.type)
    if limits is None or math.isnan(value) or value == limits.nan:
        return True
    return limits.low <= value <= limits.high and value == int(value)


def no_variable(parameter: Parameter, value: object) -> BuildError:
    """The error for a constant where the brick writes."""
    return BuildError(
        f"{parameter.name} cannot be {value!r}: the brick writes to it, so it takes a variable, GV(0) or Local();"
        f" {HOW_TO_MEAN_IT}"
    )


def wrong_name(parameter: Parameter, name: str) -> BuildError:
    """The error for a text where the name of an enumeration's member should stand."""
    domain = domain_of(parameter)
    assert parameter.enum is not None
    assert domain is not None
    hint = near_misses(name, parameter.enum.members)
    if hint:
        return BuildError(f"{parameter.name} cannot be {name!r}{hint}")
    return BuildError(f"{parameter.name} must be {domain.choice}, not {name!r}")
