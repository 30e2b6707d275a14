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
from ev3proto.tables import with_effect
from ev3proto.tables.declaration import Effect, Role
from ev3proto.tables.output import MOTOR_LETTERS, PORT_SETS
from ev3proto.tables.ports import SensorPort

_STARTS = with_effect(Effect.STARTS_MOTORS)


def check_alone(context: CheckContext) -> Iterator[Finding]:
    """Checks a direct command that is tried by itself."""
    if not context.is_whole:
        return
    is_started = Effect.RUNS_MOTORS in context.effects
    for operation in context.operations:
        if operation.has(Effect.AWAITS_START) and not is_started:
            yield operation.finding(
                codes.NOT_STARTED,
                f"{operation.name} starts no motor: it sets what {_STARTS.name} starts them with",
                f"put {_STARTS.name} (0x{_STARTS.opcode.number:02X}) after it, unless the motors run already or a later"
                " command starts them",
            )
        for argument in operation.arguments:
            yield from _port(operation, argument)


def _port(operation: CheckedOperation, argument: Argument) -> Iterator[Finding]:
    """Yields a hint about the number of a port that may be meant as a bit mask, and about a mask of no port."""
    role, number = argument.parameter.role, whole_number(argument)
    if role is Role.MOTORS and number == 0:
        masks = ", ".join(f"{1 << port} for {letter}" for port, letter in MOTOR_LETTERS.items())
        parts = {"owner": operation.name, "ports": f"{masks}, or the sum of several"}
        yield operation.finding_of(codes.WRONG_KIND_OF_PORT, codes.NO_PORTS, argument, parts)
    elif role is Role.PORT and number == len(SensorPort):
        yield operation.finding_at(
            codes.PORT_OF_NEXT_BRICK,
            argument,
            f"{argument.name} is {number}, port 1 of the next brick in a daisy chain: ports are counted from 0",
            f"use {number - 1} if port {number} of this brick is meant",
        )
    elif (
        role is Role.MOTOR
        and number in PORT_SETS
        and number in MOTOR_LETTERS
        and len(PORT_SETS[number]) == 1
        and number
    ):
        meant = next(port for port, letter in MOTOR_LETTERS.items() if letter == PORT_SETS[number])
        other = PORT_SETS[number]
        yield operation.finding_at(
            codes.WRONG_KIND_OF_PORT,
            argument,
            f"{argument.name} is {number}, the number of port {MOTOR_LETTERS[number]};"
            f" as a bit mask it would be {other}",
            f"use {meant} if port {other} is meant: {operation.name} takes the number of one port",
        )
