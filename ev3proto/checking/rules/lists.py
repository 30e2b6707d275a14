"""Texts and arrays that do not fit their length, or the room that the firmware has for them."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.places import number_of
from ev3proto.checking.report import Finding
from ev3proto.checking.rules.header import plural
from ev3proto.checking.subject import Step
from ev3proto.messages import Argument
from ev3proto.tables.declaration import Direction
from ev3proto.tables.encoding import CONSTANT, TEXT

_PLAIN_SIZE = 4
"""Bytes that a constant has where the brick reads it as an array: those of the number that it was made into."""


def check_lists(steps: tuple[Step, ...]) -> Iterator[Finding]:
    """The texts and arrays that stand in the operations themselves."""
    for step in steps:
        for argument in step.arguments:
            parameter, form, *_ = argument
            if parameter.length is None and parameter.most is None:
                continue
            if form.kind not in (TEXT, CONSTANT) or form.handle or form.address:
                continue
            if parameter.direction is Direction.IN:
                yield from _text_or_array(step, argument)


def _text_or_array(step: Step, argument: Argument) -> Iterator[Finding]:
    parameter = argument.parameter
    if argument.kind == TEXT and parameter.most is not None and argument.length - 1 > parameter.most:
        yield _too_long(step, argument, parameter.most)
    if isinstance(parameter.length, str):
        yield from _array(step, argument, parameter.length)


def _too_long(step: Step, argument: Argument, most: int) -> Finding:
    size = argument.length - 1
    return step.finding_at(
        codes.NAME_TOO_LONG,
        argument,
        f"{argument.name} has {plural(size - 1, 'character')}, and the firmware takes {most - 1} at most",
        f"shorten it by {size - most}",
    )


def _array(step: Step, argument: Argument, length: str) -> Iterator[Finding]:
    teller = next((other for other in step.arguments if other.name == length), None)
    count = number_of(teller)
    if count is None or count == -1:
        return
    one = max(argument.parameter.type.size, 1)
    wanted = one * abs(count)
    if argument.form.kind == CONSTANT:
        if wanted > _PLAIN_SIZE:
            yield step.finding_at(
                codes.ARRAY_TOO_SHORT,
                argument,
                f"{length} says that {argument.name} has {plural(wanted, 'byte')}, and it is a single number",
                "give the bytes as a text, or a variable that holds them",
            )
        return
    # The zero at the end is a byte as any other.
    present = argument.length - 1
    if wanted > present:
        yield step.finding_at(
            codes.ARRAY_TOO_SHORT,
            argument,
            f"{length} says that {argument.name} has {plural(wanted, 'byte')}, and it has {present} with its zero",
            f"give {present // one} as {length}, or all {plural(wanted, 'byte')}",
        )
    elif wanted < present - 1:
        yield step.finding_at(
            codes.REST_UNUSED,
            argument,
            f"{length} says that {argument.name} has {plural(wanted, 'byte')}, and it has {present - 1}",
            f"give {(present - 1) // one} as {length}, or leave the rest away",
        )
