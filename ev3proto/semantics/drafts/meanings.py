"""What the tables say a value may be, beyond what its type can hold: documented ranges, names, single special values.

A value that means nothing to the brick is refused where it is written down. Whoever means it says `unchecked=True`.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

from ev3proto.errors import BuildError, near_misses
from ev3proto.messages import Argument, Operation
from ev3proto.semantics.domain import domain_of
from ev3proto.semantics.footprint import Footprint, footprints
from ev3proto.semantics.inline_arrays import inline_arrays
from ev3proto.tables.declaration import Direction, Parameter
from ev3proto.tables.encoding import CONSTANT, RANGES, TEXT

HOW_TO_MEAN_IT = "unchecked=True lets it through"
"""Ends the sentences of Python calls about values that can be encoded, but mean nothing to the brick."""


class MeaningError(BuildError):
    """A value that can be encoded, but means nothing to the brick.

    Attributes:
        sentence: What is wrong, without how to let it through.
    """

    def __init__(self, sentence: str) -> None:
        self.sentence = sentence
        super().__init__(f"{sentence}; {HOW_TO_MEAN_IT}")


def objections(operation: Operation) -> Iterator[tuple[int, BuildError]]:
    """What is not legal in an operation that is encoded: constants, variables that are misaligned.

    Args:
        operation: The operation, by itself or in a frame.

    Yields:
        The number of the argument, from 0, and an error that names its parameter and what would be right.
    """
    arguments = operation.arguments
    yield from _wrong_arrays(arguments)
    for number, argument in enumerate(arguments):
        try:
            _check_meaning(argument)
        except BuildError as error:
            yield number, error
    yield from _wrong_places(footprints(operation, arguments))


def _check_meaning(argument: Argument) -> None:
    """Refuses a constant that is not legal, in an argument that is encoded.

    Raises:
        BuildError: Names the parameter and what would be right.
    """
    parameter, form, value, *_ = argument
    if form.handle or form.address or argument.is_variable:
        return
    if parameter.direction is not Direction.IN:
        raise no_variable(parameter, value)
    if isinstance(value, str):
        check_text(parameter, value)
    elif form.kind == CONSTANT:
        check_number(parameter, value)


def _wrong_places(used: Iterable[Footprint]) -> Iterator[tuple[int, BuildError]]:
    """Variables that are misaligned, for which the brick refuses the whole command."""
    for footprint in used:
        multiple = footprint.validator_alignment
        if footprint.start % multiple:
            kind = "a handle" if footprint.argument.form.handle else footprint.argument.parameter.type.label
            sentence = (
                f"{footprint.argument.name} cannot be {footprint.variable}: as {kind} it must be at a multiple of"
                f" {multiple}, or the brick refuses it"
            )
            yield footprint.number, MeaningError(sentence)


def check_number(parameter: Parameter, value: float) -> None:
    """Refuses a number that is not legal.

    Args:
        parameter: What the tables declare.
        value: The number.

    Raises:
        BuildError: Names the parameter and what would be right.
    """
    domain = domain_of(parameter)
    if domain is not None and not domain.covers(value):
        sentence = f"{parameter.name} must be {domain.choice}, not {value}"
        raise MeaningError(sentence) if _can_be(parameter, value) else BuildError(sentence)


def check_text(parameter: Parameter, value: str) -> None:
    """Refuses a text that is longer than the firmware takes.

    Args:
        parameter: What the tables declare.
        value: The text.

    Raises:
        BuildError: Names the parameter and how long the text may be.
    """
    size = len(value) + 1
    if parameter.most is not None and size > parameter.most:
        raise MeaningError(
            f"{parameter.name} has {size - 1} characters, and the firmware takes {parameter.most - 1} at most"
        )


def _wrong_arrays(arguments: Sequence[Argument]) -> Iterator[tuple[int, BuildError]]:
    """Arrays that stand in the operation itself and have fewer bytes than their length says."""
    for array in inline_arrays(arguments):
        if array.stated > array.present:
            argument = array.argument
            has = f"a text of {array.present} bytes with its zero" if argument.kind == TEXT else "one number"
            sentence = (
                f"{argument.name} cannot be {argument.value!r}: {array.length} says that it has {array.stated} bytes,"
                f" and this is {has}"
            )
            yield arguments.index(argument), MeaningError(sentence)


def _can_be(parameter: Parameter, value: float) -> bool:
    """Whether there is an encoding for it."""
    limits = RANGES.get(parameter.type)
    if limits is None or value == limits.nan or (isinstance(value, float) and math.isnan(value)):
        return True
    return limits.low <= value <= limits.high and value == int(value)


def no_variable(parameter: Parameter, value: object) -> BuildError:
    """The error for a constant where the brick writes."""
    return MeaningError(
        f"{parameter.name} cannot be {value!r}: the brick writes to it, so it takes a variable, GV(0) or Local()"
    )


def wrong_name(parameter: Parameter, name: str) -> BuildError:
    """The error for a text where the name of an enumeration's member should stand."""
    domain = domain_of(parameter)
    assert parameter.enum is not None
    assert domain is not None
    hint = near_misses(name, [*parameter.enum.members, *parameter.names])
    if hint:
        return BuildError(f"{parameter.name} cannot be {name!r}{hint}")
    return BuildError(f"{parameter.name} must be {domain.choice}, not {name!r}")
