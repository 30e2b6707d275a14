"""Opcodes without a CMD in the firmware's area `output`; `ops` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnyTYPE, NamedNumber, Number, Output
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "output_clr_count",
    "output_get_count",
    "output_polarity",
    "output_power",
    "output_prg_stop",
    "output_read",
    "output_ready",
    "output_reset",
    "output_set_type",
    "output_speed",
    "output_start",
    "output_step_power",
    "output_step_speed",
    "output_step_sync",
    "output_stop",
    "output_test",
    "output_time_power",
    "output_time_speed",
    "output_time_sync",
]

_OPERATIONS = drafts("official")


def output_set_type(layer: Number, no: NamedNumber, type: AnyTYPE, *, unchecked: bool = False) -> Draft:
    """Declares which type of motor is at a port.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 0 to 3; 0: A; 1: B; 2: C; 3: D; DATA8.
        type: Type of the motor; a member of TYPE; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_SET_TYPE"].draft((layer, no, type), unchecked)


def output_reset(layer: Number, nos: NamedNumber, *, unchecked: bool = False) -> Draft:
    """Sets the tacho counts that moves and OUTPUT_READ use to zero.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_RESET"].draft((layer, nos), unchecked)


def output_stop(layer: Number, nos: NamedNumber, brake: Number, *, unchecked: bool = False) -> Draft:
    """Stops motors.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        brake: What the motors do at the end; 0 to 1; 0: coast; 1: brake and hold; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_STOP"].draft((layer, nos, brake), unchecked)


def output_power(layer: Number, nos: NamedNumber, power: Number, *, unchecked: bool = False) -> Draft:
    """Sets the power of motors, OUTPUT_START makes them run.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        power: Unregulated power, negative: backward; -100 to 100 %; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_POWER"].draft((layer, nos, power), unchecked)


def output_speed(layer: Number, nos: NamedNumber, speed: Number, *, unchecked: bool = False) -> Draft:
    """Sets the speed of motors, OUTPUT_START makes them run.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        speed: Regulated speed, negative: backward; -100 to 100 %; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_SPEED"].draft((layer, nos, speed), unchecked)


def output_start(layer: Number, nos: NamedNumber, *, unchecked: bool = False) -> Draft:
    """Starts motors with the power or speed set before.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_START"].draft((layer, nos), unchecked)


def output_polarity(layer: Number, nos: NamedNumber, pol: Number, *, unchecked: bool = False) -> Draft:
    """Sets the direction of motors.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        pol: Direction; -1 to 1; -1: backward; 0: opposite of the present one; 1: forward; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_POLARITY"].draft((layer, nos, pol), unchecked)


def output_read(
    layer: Number,
    no: NamedNumber,
    speed: Output = None,
    tacho: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads speed and tacho count of one motor, 0 on layers other than 0.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 0 to 3; 0: A; 1: B; 2: C; 3: D; DATA8.
        speed: Present speed; -100 to 100 %; DATA8; an output, in global memory when omitted.
        tacho: Angle since OUTPUT_RESET; degrees; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_READ"].draft((layer, no, speed, tacho), unchecked)


def output_test(layer: Number, nos: NamedNumber, busy: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether one of the motors is still in a move that ends by itself.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        busy: Whether to wait; 0 to 1; 0: ready; 1: busy; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_TEST"].draft((layer, nos, busy), unchecked)


def output_ready(layer: Number, nos: NamedNumber, *, unchecked: bool = False) -> Draft:
    """Waits until the moves of the motors have ended, OUTPUT_START does not count.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_READY"].draft((layer, nos), unchecked)


def output_step_power(
    layer: Number,
    nos: NamedNumber,
    power: Number,
    step1: Number,
    step2: Number,
    step3: Number,
    brake: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Turns motors by an angle with unregulated power.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        power: Unregulated power, negative: backward; -100 to 100 %; DATA8.
        step1: Angle of the ramp up; 0 to 2147483647 degrees; DATA32.
        step2: Angle at constant drive; 0 to 2147483647 degrees; DATA32.
        step3: Angle of the ramp down; 0 to 2147483647 degrees; DATA32.
        brake: What the motors do at the end; 0 to 1; 0: coast; 1: brake and hold; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_STEP_POWER"].draft((layer, nos, power, step1, step2, step3, brake), unchecked)


def output_time_power(
    layer: Number,
    nos: NamedNumber,
    power: Number,
    time1: Number,
    time2: Number,
    time3: Number,
    brake: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Runs motors for a time with unregulated power.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        power: Unregulated power, negative: backward; -100 to 100 %; DATA8.
        time1: Time of the ramp up; 0 to 2147483647 ms; DATA32.
        time2: Time at constant drive; 0 to 2147483647 ms; DATA32.
        time3: Time of the ramp down; 0 to 2147483647 ms; DATA32.
        brake: What the motors do at the end; 0 to 1; 0: coast; 1: brake and hold; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_TIME_POWER"].draft((layer, nos, power, time1, time2, time3, brake), unchecked)


def output_step_speed(
    layer: Number,
    nos: NamedNumber,
    speed: Number,
    step1: Number,
    step2: Number,
    step3: Number,
    brake: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Turns motors by an angle with regulated speed.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        speed: Regulated speed, negative: backward; -100 to 100 %; DATA8.
        step1: Angle of the ramp up; 0 to 2147483647 degrees; DATA32.
        step2: Angle at constant drive; 0 to 2147483647 degrees; DATA32.
        step3: Angle of the ramp down; 0 to 2147483647 degrees; DATA32.
        brake: What the motors do at the end; 0 to 1; 0: coast; 1: brake and hold; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_STEP_SPEED"].draft((layer, nos, speed, step1, step2, step3, brake), unchecked)


def output_time_speed(
    layer: Number,
    nos: NamedNumber,
    speed: Number,
    time1: Number,
    time2: Number,
    time3: Number,
    brake: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Runs motors for a time with regulated speed.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        speed: Regulated speed, negative: backward; -100 to 100 %; DATA8.
        time1: Time of the ramp up; 0 to 2147483647 ms; DATA32.
        time2: Time at constant drive; 0 to 2147483647 ms; DATA32.
        time3: Time of the ramp down; 0 to 2147483647 ms; DATA32.
        brake: What the motors do at the end; 0 to 1; 0: coast; 1: brake and hold; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_TIME_SPEED"].draft((layer, nos, speed, time1, time2, time3, brake), unchecked)


def output_step_sync(
    layer: Number,
    nos: NamedNumber,
    speed: Number,
    turn: Number,
    step: Number,
    brake: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Turns two motors in step by an angle.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        speed: Regulated speed, negative: backward; -100 to 100 %; DATA8.
        turn: How tight the turn is, positive slows the higher port, negative the lower; -200 to 200; -200: spin, lower
            port runs backward; -100: lower port stands; 0: straight; 100: higher port stands; 200: spin, higher port
            runs backward; DATA16.
        step: Angle of the faster motor; 0 to 2147483647 degrees; 0: no end; DATA32.
        brake: What the motors do at the end; 0 to 1; 0: coast; 1: brake and hold; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_STEP_SYNC"].draft((layer, nos, speed, turn, step, brake), unchecked)


def output_time_sync(
    layer: Number,
    nos: NamedNumber,
    speed: Number,
    turn: Number,
    time: Number,
    brake: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Runs two motors in step for a time.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        speed: Regulated speed, negative: backward; -100 to 100 %; DATA8.
        turn: How tight the turn is, positive slows the higher port, negative the lower; -200 to 200; -200: spin, lower
            port runs backward; -100: lower port stands; 0: straight; 100: higher port stands; 200: spin, higher port
            runs backward; DATA16.
        time: How long to run; 0 to 2147483647 ms; 0: no end; DATA32.
        brake: What the motors do at the end; 0 to 1; 0: coast; 1: brake and hold; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_TIME_SYNC"].draft((layer, nos, speed, turn, time, brake), unchecked)


def output_clr_count(layer: Number, nos: NamedNumber, *, unchecked: bool = False) -> Draft:
    """Sets the tacho counts that motors have as sensors to zero.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_CLR_COUNT"].draft((layer, nos), unchecked)


def output_get_count(layer: Number, nos: NamedNumber, tacho: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the tacho count that a motor has as a sensor.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Port, counted from 0; 0 to 3; 0: A; 1: B; 2: C; 3: D; DATA8.
        tacho: Angle since OUTPUT_CLR_COUNT; degrees; DATA32; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_GET_COUNT"].draft((layer, nos, tacho), unchecked)


def output_prg_stop(*, unchecked: bool = False) -> Draft:
    """Stops and resets all motors as the end of a program does."""
    return _OPERATIONS["OUTPUT_PRG_STOP"].draft((), unchecked)
