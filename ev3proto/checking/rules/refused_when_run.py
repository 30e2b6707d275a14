"""Operations that pass the validator, but fail or do nothing on every brick."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.errors import counted
from ev3proto.semantics.footprint import whole_number
from ev3proto.tables.declaration import Direction, Effect, Role
from ev3proto.tables.encoding import TEXT

_HELD = (Role.FILE, Role.ARRAY)
_OFFICIAL = "official"


def check_failures(context: CheckContext) -> Iterator[Finding]:
    """Checks for operations that fail on every brick, handles never created, refused letters and added suffixes."""
    made: list[Role] = []
    if context.has_jumps:
        # The order is unknown.
        made = [role for operation in context.operations for role in _made_by(operation)]
    may_fail = context.dialect == _OFFICIAL
    for operation in context.operations:
        if may_fail and operation.has(Effect.FAILS) and not operation.facts.declaration.is_newer:
            yield _failure(operation)
        elif operation.facts.has_handles:
            yield from _handles(operation, made)
            made += _made_by(operation)
        if operation.facts.has_letters:
            yield from _letters(operation)


def _failure(operation: CheckedOperation) -> Finding:
    note = operation.facts.declaration.note
    key, reason = ("", note[0].lower() + note[1:].rstrip(".")) if note else ("no code", "")
    return operation.finding(codes.FAILS, key, reason=reason)


def _made_by(operation: CheckedOperation) -> list[Role]:
    return [
        argument.parameter.role
        for argument in operation.arguments
        if argument.parameter.role in _HELD and argument.parameter.direction is Direction.OUT
    ]


def _handles(operation: CheckedOperation, made: list[Role]) -> Iterator[Finding]:
    for argument in operation.arguments:
        role = argument.parameter.role
        if role not in _HELD or argument.parameter.direction is not Direction.IN:
            continue
        number = whole_number(argument)
        if role not in made:
            yield operation.finding_of(codes.NO_HANDLE, argument, role)
        elif number is not None and not 1 <= number <= len(made):
            yield operation.finding_of(
                codes.NO_HANDLE, argument, "number", number=number, handles=counted(len(made), "handle")
            )


def _letters(operation: CheckedOperation) -> Iterator[Finding]:
    for argument in operation.arguments:
        if argument.form.kind != TEXT or argument.form.handle or argument.form.address:
            continue
        text, parameter = str(argument.value), argument.parameter
        refused = [letter for letter in text if letter not in parameter.letters] if parameter.letters else []
        if refused:
            yield operation.finding_of(codes.REFUSED_LETTER, argument, letter=refused[0])
        if parameter.suffix and text.lower().endswith(parameter.suffix):
            bare = text[: -len(parameter.suffix)]
            yield operation.finding_of(codes.SUFFIX_ADDED, argument, suffix=parameter.suffix, bare=bare)
