"""Operations that pass the validator, but fail or do nothing on every brick."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.semantics.footprint import whole_number
from ev3proto.tables.declaration import Direction, Effect, Role
from ev3proto.tables.encoding import TEXT

_HELD = {Role.FILE: "file", Role.ARRAY: "array"}
_OFFICIAL = "official"


def check_failures(context: CheckContext) -> Iterator[Finding]:
    """Checks for operations that fail on every brick, handles never created, refused letters and added suffixes."""
    made: list[Role] = []
    if context.has_jumps:
        # The order is unknown.
        made = [role for operation in context.operations for role in _made_by(operation)]
    may_fail = context.dialect == _OFFICIAL and Effect.FAILS in context.effects
    for operation in context.operations:
        if may_fail and operation.has(Effect.FAILS) and not operation.facts.declaration.is_newer:
            yield operation.finding(
                codes.FAILS,
                f"{operation.name} ends the command with an error on every brick: {_reason(operation)}",
                "omit it",
            )
        elif operation.facts.has_handles:
            yield from _handles(operation, made)
            made += _made_by(operation)
        if operation.facts.has_letters:
            yield from _letters(operation)


def _reason(operation: CheckedOperation) -> str:
    note = operation.facts.declaration.note
    return note[0].lower() + note[1:].rstrip(".") if note else "the firmware has no code for it that a command can use"


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
        what = _HELD[role]
        verb = "opens" if role is Role.FILE else "creates"
        number = whole_number(argument)
        if role not in made:
            yield operation.finding_at(
                codes.NO_HANDLE,
                argument,
                f"no operation before {operation.name} {verb} {_article(what)}: handles end with their command",
                f"{verb.removesuffix('s')} the {what} in the same command, and use the handle that it gives",
            )
        elif number is not None and not 1 <= number <= len(made):
            yield operation.finding_at(
                codes.NO_HANDLE,
                argument,
                f"{argument.name} is {number}, but the command has only the handle{_numbers(len(made))}",
                "use the variable in which the handle was stored",
            )


def _article(what: str) -> str:
    return f"an {what}" if what[0] in "aeiou" else f"a {what}"


def _numbers(count: int) -> str:
    return " 1" if count == 1 else f"s 1 to {count}"


def _letters(operation: CheckedOperation) -> Iterator[Finding]:
    for argument in operation.arguments:
        if argument.form.kind != TEXT or argument.form.handle or argument.form.address:
            continue
        text, parameter = str(argument.value), argument.parameter
        refused = [letter for letter in text if letter not in parameter.letters] if parameter.letters else []
        if refused:
            yield operation.finding_at(
                codes.REFUSED_LETTER,
                argument,
                f"{argument.name} contains {refused[0]!r}, which the firmware refuses",
                "use letters, digits, _ and -",
            )
        if parameter.suffix and text.lower().endswith(parameter.suffix):
            yield operation.finding_at(
                codes.SUFFIX_ADDED,
                argument,
                f"{argument.name} ends in {parameter.suffix}, and the firmware adds {parameter.suffix} to every name",
                f"omit it: {text[: -len(parameter.suffix)]}",
            )
