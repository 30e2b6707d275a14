"""Hints about a command that is tried by itself: operations without effect, and numbers that are easily confused.

Frames in a capture or a log get none of them, since other commands may complete what they begin.
"""

from __future__ import annotations

from collections.abc import Iterator

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
            yield from _port(operation, argument)


def _port(operation: CheckedOperation, argument: Argument) -> Iterator[Finding]:
    """Yields a hint about the number of a port that may be meant as a bit mask, and about a mask of no port."""
    role, number = argument.parameter.role, whole_number(argument)
    if role is Role.MOTORS and number == 0:
        masks = ", ".join(f"{1 << port} for {letter}" for port, letter in MOTOR_LETTERS.items())
        ports = f"{masks}, or the sum of several"
        yield operation.finding_of(codes.WRONG_KIND_OF_PORT, argument, codes.NO_PORTS, ports=ports)
    elif role is Role.PORT and number == len(SensorPort):
        yield operation.finding_of(codes.PORT_OF_NEXT_BRICK, argument, number=number, before=number - 1)
    elif role is Role.DRIVE and number is not None and argument.length == 1 and number < 0:
        byte = f"{0x40 + number:02X}"
        yield operation.finding_of(codes.RAW_PERCENT, argument, number=number, byte=byte, meant=0x40 + number)
    elif (
        role is Role.MOTOR
        and number in PORT_SETS
        and number in MOTOR_LETTERS
        and len(PORT_SETS[number]) == 1
        and number
    ):
        meant = next(port for port, letter in MOTOR_LETTERS.items() if letter == PORT_SETS[number])
        parts = {"number": number, "port": MOTOR_LETTERS[number], "other": PORT_SETS[number], "meant": meant}
        yield operation.finding_of(codes.WRONG_KIND_OF_PORT, argument, "number", **parts)
