"""What the tables say a value may be, beyond what its type can hold: documented ranges, names, single special values.

A value that means nothing to the brick is refused where it is written down. Whoever means it says `unchecked=True`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache

from ev3proto.errors import BuildError, near_misses
from ev3proto.messages import Argument, Variable
from ev3proto.tables.declaration import Direction, Enumeration, Parameter, Type
from ev3proto.tables.encoding import CONSTANT, RANGES, TEXT

HOW_TO_MEAN_IT = "unchecked=True lets it through"


def check_meaning(argument: Argument, *, is_aligned: bool) -> None:
    """Refuses what the tables do not provide for, in an argument that is encoded.

    is_aligned  whether the brick looks at the index of a variable here

    BuildError names the parameter and what would be right.
    """
    parameter, form, value, *_ = argument
    if form.handle or form.address:
        return
    if argument.is_variable:
        if is_aligned:
            _check_alignment(argument)
    elif parameter.direction is not Direction.IN:
        raise no_variable(parameter, value)
    elif form.kind == CONSTANT and not isinstance(value, str):
        check_number(parameter, value)


def check_number(parameter: Parameter, value: float) -> None:
    """The same for a number that is not encoded yet."""
    meaning = _meaning(parameter)
    if meaning is not None and not meaning.covers(value):
        hint = f"; {HOW_TO_MEAN_IT}" if _can_be(parameter, value) else ""
        raise BuildError(f"{parameter.name} cannot be {value}: {meaning.told}{hint}")


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
    for argument in arguments:
        parameter, form, value, *_ = argument
        if parameter.direction is not Direction.IN or not isinstance(parameter.length, str):
            continue
        if form.kind not in (CONSTANT, TEXT) or form.handle or form.address:
            continue
        length = next((other for other in arguments if other.name == parameter.length), None)
        # -1 stands for as much as there is; other negative lengths are those of bytes in reverse order.
        if length is None or length.kind != CONSTANT or not isinstance(length.value, int) or length.value == -1:
            continue
        wanted = max(parameter.type.size, 1) * abs(length.value)
        present = len(value) + 1 if isinstance(value, str) else _NUMBER_SIZE
        if wanted > present:
            what = f"a text of {present} bytes with its zero" if isinstance(value, str) else "one number"
            raise BuildError(
                f"{parameter.name} cannot be {value!r}: {length.name} says that it has {wanted} bytes, and this is"
                f" {what}; {HOW_TO_MEAN_IT}"
            )


_NUMBER_SIZE = 4
"""Bytes of a number in the operation itself, where the brick reads it as an array."""


def _can_be(parameter: Parameter, value: float) -> bool:
    """Whether there is an encoding for it."""
    limits = RANGES.get(parameter.type)
    return limits is None or (value == int(value) and (limits.low <= value <= limits.high or value == limits.nan))


def _check_alignment(argument: Argument) -> None:
    """A misaligned variable makes the brick refuse the whole command."""
    parameter = argument.parameter
    kind = parameter.validated or parameter.type
    if kind.size > 1 and int(argument.value) % kind.size:
        variable = Variable(argument.kind, int(argument.value))
        raise BuildError(
            f"{parameter.name} cannot be {variable}: as {kind.label} it has to be at a multiple of {kind.size}, or the"
            f" brick refuses it; {HOW_TO_MEAN_IT}"
        )


def no_variable(parameter: Parameter, value: object) -> BuildError:
    """The error for a constant where the brick writes."""
    return BuildError(
        f"{parameter.name} cannot be {value!r}: the brick writes to it, so it takes a variable, GV(0) or Local();"
        f" {HOW_TO_MEAN_IT}"
    )


def wrong_name(parameter: Parameter, name: str) -> BuildError:
    """The error for a text where the name of an enumeration's member should stand."""
    assert parameter.enum is not None
    hint = near_misses(name, parameter.enum.members)
    return BuildError(f"{parameter.name} cannot be {name!r}{hint or f': it is {_names(parameter.enum)}'}")


def span(parameter: Parameter) -> str:
    """`0 to 100 %`, or the unit alone; nothing where the tables name neither."""
    unit = f" {parameter.unit}" if parameter.unit else ""
    if parameter.range is None:
        return unit.strip()
    low, high = parameter.range
    return f"{low} to {high}{unit}"


class _Meaning:
    """The numbers of one parameter that mean something; `told` says which."""

    def __init__(self, parameter: Parameter) -> None:
        self._singles = set(parameter.special)
        self._spans: list[tuple[int, int]] = []
        self._mask = 0
        special = parameter.special.items()
        if parameter.range is not None:
            low, high = parameter.range
            self._spans.append((low, high))
            special = [(number, text) for number, text in special if not low <= number <= high]  # type: ignore[assignment]
            told = span(parameter)
        elif parameter.enum is not None:
            self._singles |= set(parameter.enum.members.values())
            self._spans += _spans(parameter.enum)
            self._mask = sum(parameter.enum.members.values()) if parameter.enum.flags else 0
            told = _names(parameter.enum)
        else:
            # All numbers of the type; the special ones are among them.
            limits = RANGES[parameter.type]
            self._spans.append((limits.low, limits.high))
            special = ()  # type: ignore[assignment]
            told = f"{limits.low} to {limits.high} ({limits.nan} says that it is not a number)"
        self.told = " or ".join((f"it is {told}", *(f"{number} ({text})" for number, text in special)))

    def covers(self, value: float) -> bool:
        """Whether a number means something."""
        if value in self._singles or any(low <= value <= high for low, high in self._spans):
            return True
        return bool(self._mask) and not int(value) & ~self._mask


@cache
def _meaning(parameter: Parameter) -> _Meaning | None:
    """None where all that can be encoded means something."""
    if parameter.type is Type.STRING or (parameter.type is Type.DATAF and parameter.range is None):
        return None
    return _Meaning(parameter)


def _spans(enum: Enumeration) -> Iterator[tuple[int, int]]:
    """Numbers between two members that name both ends of a span: TYPE_THIRD_PARTY_START and ..._END."""
    for name, low in enum.members.items():
        if name.endswith("_START"):
            high = enum.members.get(f"{name.removesuffix('_START')}_END")
            if high is not None:
                yield low, high


_MOST_NAMES = 12


def _names(enum: Enumeration) -> str:
    names = list(enum.members)
    if len(names) <= _MOST_NAMES:
        return f"{', '.join(names[:-1])} or {names[-1]}"
    return f"one of the {len(names)} names of {enum.name}, such as {names[0]} or {names[-1]}"
