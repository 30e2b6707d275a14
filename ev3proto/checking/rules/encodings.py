"""Encodings that are longer than they need be."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.checking.rules.header import plural
from ev3proto.messages import Argument, Variable
from ev3proto.schema.argument import SHORT, encode_integer, encode_variable
from ev3proto.tables.declaration import Role
from ev3proto.tables.encoding import CONSTANT, CONSTANT_RANGES, GLOBAL, INDEX_RANGES, LOCAL


def check_encodings(frame: bytes, operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    """The arguments of all operations, CMD included."""
    has_jumps = any(operation.facts.is_jump for operation in operations)
    for operation in operations:
        if operation.facts.has_cmd and frame[operation.start + 1] >= _SHORT_FORMS:
            cmd = operation.parsed.cmd
            assert cmd is not None
            yield from _longer(operation, cmd, has_jumps)
        for argument in operation.arguments:
            form = argument.form
            if form.width and not form.handle and not form.address:
                yield from _longer(operation, argument, has_jumps)


_SHORT_FORMS = len(SHORT)
"""Identification bytes below this one are whole arguments."""


def _longer(operation: CheckedOperation, argument: Argument, has_jumps: bool) -> Iterator[Finding]:
    _, form, value, *_ = argument
    if form.kind == CONSTANT:
        if not isinstance(value, int):
            return
        spans = CONSTANT_RANGES
    elif form.kind in (LOCAL, GLOBAL):
        spans = INDEX_RANGES
    else:
        return
    assert isinstance(value, int)
    for width, numbers in spans.items():
        if value in numbers:
            if width < form.width:  # type: ignore[operator]
                yield _finding(operation, argument, value, has_jumps)
            return


def _finding(operation: CheckedOperation, argument: Argument, value: int, has_jumps: bool) -> Finding:
    kind = argument.form.kind
    shortest = encode_integer(value) if kind == CONSTANT else encode_variable(Variable(kind, value))
    if argument.parameter.role is Role.JUMP and kind == CONSTANT and value < 0:
        shortest = _shorter_way_back(argument, value)
    aside = ""
    if has_jumps and argument.parameter.role is not Role.JUMP:
        aside = f", and count {plural(argument.length - len(shortest), 'byte')} less in jumps over it"
    return operation.finding_at(
        codes.LONGER_FORM,
        argument,
        f"{argument.name} is {argument.encoding}, and its value fits {plural(len(shortest), 'byte')}",
        f"write it as {shortest.hex(' ').upper()}{aside}",
    )


def _shorter_way_back(argument: Argument, value: int) -> bytes:
    """A jump to the same place in fewer bytes: it is counted from its end, which is less far from there then."""
    for length in range(1, argument.length):
        data = encode_integer(value + argument.length - length)
        if len(data) == length:
            return data
    return encode_integer(value)
