"""Texts and arrays that do not fit their length, or the room that the firmware has for them."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.errors import counted
from ev3proto.semantics.inline_arrays import InlineArray, inline_arrays
from ev3proto.tables.declaration import Direction
from ev3proto.tables.encoding import CONSTANT, RANGES, TEXT


def check_lists(operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    """The texts and arrays that stand in the operations themselves."""
    for operation in operations:
        if operation.facts.has_lists:
            yield from _long_texts(operation)
            for array in inline_arrays(operation.arguments):
                yield from _array(operation, array)


def _long_texts(operation: CheckedOperation) -> Iterator[Finding]:
    for argument in operation.arguments:
        parameter, form, *_ = argument
        most = parameter.most
        if most is None or form.kind != TEXT or parameter.direction is not Direction.IN:
            continue
        size = argument.length - 1
        if size > most and not form.handle and not form.address:
            yield operation.finding_at(
                codes.NAME_TOO_LONG,
                argument,
                f"{argument.name} has {counted(size - 1, 'character')}, and the firmware takes {most - 1} at most",
                f"shorten it by {size - most}",
            )


def _array(operation: CheckedOperation, array: InlineArray) -> Iterator[Finding]:
    argument, length, stated, present = array.argument, array.length, array.stated, array.present
    says = f"{length} says that {argument.name} has {counted(stated, 'byte')}"
    if argument.form.kind == CONSTANT:
        if stated > present:
            yield operation.finding_at(
                codes.ARRAY_TOO_SHORT,
                argument,
                f"{says}, and it is a single number",
                "give the bytes as a text, or a variable that holds them",
            )
    elif stated > present:
        yield operation.finding_at(
            codes.ARRAY_TOO_SHORT,
            argument,
            f"{says}, and it has {present} with its zero",
            ", or ".join((*_count(operation, array, present // array.one), f"give all {counted(stated, 'byte')}")),
        )
    elif stated < present - 1:
        yield operation.finding_at(
            codes.REST_UNUSED,
            argument,
            f"{says}, and it has {present - 1}",
            ", or ".join(
                (
                    *_count(operation, array, -(-(present - 1) // array.one)),
                    f"omit the last {counted(present - 1 - stated, 'byte')}",
                )
            ),
        )


def _count(operation: CheckedOperation, array: InlineArray, count: int) -> Iterator[str]:
    """The advice to give another number of values, where the array has so many and the parameter can say so."""
    parameter = next(it for it in operation.facts.declaration.parameters if it.name == array.length)
    limits = RANGES.get(parameter.type)
    if 0 < count * array.one <= array.present and (limits is None or count <= limits.high):
        yield f"give {count} as {array.length}"
