"""Hints about a command that is tried by itself: operations without effect, and numbers that are easily confused.

Frames in a capture or a log get none of them, since other commands may complete what they begin.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.messages import Argument
from ev3proto.semantics.footprint import whole_number
from ev3proto.tables.declaration import Effect, Role
from ev3proto.tables.output import MOTOR_LETTERS, PORT_SETS
from ev3proto.tables.ports import SensorPort


def check_alone(context: CheckContext) -> Iterator[Finding]:
    """Checks a direct command that is tried by itself."""
    if not context.is_whole:
        return
    is_started = Effect.RUNS_MOTORS in context.effects
    for operation in context.operations:
        if operation.has(Effect.AWAITS_START) and not is_started:
            yield operation.finding(codes.NOT_STARTED)
        for argument in operation.arguments:
            number, role = whole_number(argument), argument.parameter.role
            rule = _OF_ROLES.get(role) if role is not None else None
            if number is not None and rule is not None:
                yield from rule(operation, argument, number)


def _mask(operation: CheckedOperation, argument: Argument, number: int) -> Iterator[Finding]:
    if number == 0:
        masks = ", ".join(f"{1 << port} for {letter}" for port, letter in MOTOR_LETTERS.items())
        yield operation.finding_of(codes.WRONG_KIND_OF_PORT, argument, codes.NO_PORTS, ports=masks)


def _motor(operation: CheckedOperation, argument: Argument, number: int) -> Iterator[Finding]:
    """Yields a hint about the number of a port that may be meant as a bit mask."""
    other = PORT_SETS.get(number, "")
    meant = next((port for port, letter in MOTOR_LETTERS.items() if letter == other), None)
    if number in MOTOR_LETTERS and meant is not None:
        parts = {"number": number, "port": MOTOR_LETTERS[number], "other": other, "meant": meant}
        yield operation.finding_of(codes.WRONG_KIND_OF_PORT, argument, "number", **parts)


def _sensor(operation: CheckedOperation, argument: Argument, number: int) -> Iterator[Finding]:
    if number == len(SensorPort):
        yield operation.finding_of(codes.PORT_OF_NEXT_BRICK, argument, number=number, before=number - 1)


def _percent(operation: CheckedOperation, argument: Argument, number: int) -> Iterator[Finding]:
    """Yields a hint about a byte that is a round number as it is, but means another one, which is not round."""
    raw = argument.raw[0]
    if argument.length == 1 and number < 0 and raw % _ROUND == 0:
        yield operation.finding_of(codes.RAW_PERCENT, argument, number=number, byte=f"{raw:02X}", meant=raw)


_ROUND = 5
_OF_ROLES: dict[Role | None, Callable[[CheckedOperation, Argument, int], Iterator[Finding]]] = {
    Role.MOTORS: _mask,
    Role.MOTOR: _motor,
    Role.PORT: _sensor,
    Role.DRIVE: _percent,
}
"""The rules on the values of arguments, by what these are."""
