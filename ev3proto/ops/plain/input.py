"""Opcodes without a CMD in the firmware's area `input`; `ops` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnyDATA_FORMAT, AnyTYPE, Elements, Number, Output, Outputs
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "input_device_list",
    "input_read",
    "input_readext",
    "input_readsi",
    "input_ready",
    "input_sample",
    "input_test",
    "input_write",
]

_OPERATIONS = drafts("official")


def input_sample(
    time: Number,
    samples: Number,
    init: Elements,
    devices: Elements,
    types: AnyTYPE,
    modes: Elements,
    datasets: Elements,
    values: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads one SI value of each of several devices, sampled in the background.

    Args:
        time: Time between two samples; ms; DATA32.
        samples: How many devices the arrays list; DATA16.
        init: Place in the sample buffer of each device, -1 starts it anew; as many values as SAMPLES says; DATA16.
        devices: Ports, 0 to 3 for sensors, 4 to 7 for motors A to D; as many values as SAMPLES says; DATA8.
        types: Type each device shall have; a member of TYPE; as many values as SAMPLES says; DATA8.
        modes: Mode each device shall have; as many values as SAMPLES says; DATA8.
        datasets: Which of its values to read from each device, from 0; as many values as SAMPLES says; DATA8.
        values: One value per device, NaN where there is none; as many values as SAMPLES says; DATAF; an output, in
            global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_SAMPLE"].draft((time, samples, init, devices, types, modes, datasets, values), unchecked)


def input_device_list(
    length: Number,
    array: Output = None,
    changed: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Lists the types of all devices, sensor ports of each layer first, then motor ports.

    Args:
        length: Room in the array, 32 takes the whole daisy chain; DATA8.
        array: Type of device at each port; a member of TYPE; as many values as LENGTH says; DATA8; an output, in global
            memory when omitted.
        changed: Whether devices came or went since the last call; 0: no change; DATA8; an output, in global memory when
            omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE_LIST"].draft((length, array, changed), unchecked)


def input_read(
    layer: Number,
    no: Number,
    type: AnyTYPE,
    mode: Number,
    pct: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Sets type and mode and reads the first value in percent at once.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        type: Type the device shall have; 0: keep the type; a member of TYPE; DATA8.
        mode: Mode the device shall have; 0 to 7; -1: keep the mode; DATA8.
        pct: Value, NaN where there is none; %; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_READ"].draft((layer, no, type, mode, pct), unchecked)


def input_test(layer: Number, no: Number, busy: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether a device is still changing type or mode.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        busy: Whether to wait; 0 to 1; 0: ready; 1: busy; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_TEST"].draft((layer, no, busy), unchecked)


def input_ready(layer: Number, no: Number, *, unchecked: bool = False) -> Draft:
    """Waits until a device has valid values.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_READY"].draft((layer, no), unchecked)


def input_readsi(
    layer: Number,
    no: Number,
    type: AnyTYPE,
    mode: Number,
    si: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Sets type and mode and reads the first value in SI units at once.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        type: Type the device shall have; 0: keep the type; a member of TYPE; DATA8.
        mode: Mode the device shall have; 0 to 7; -1: keep the mode; DATA8.
        si: Value in the mode's unit, NaN where there is none; DATAF; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_READSI"].draft((layer, no, type, mode, si), unchecked)


def input_readext(
    layer: Number,
    no: Number,
    type: AnyTYPE,
    mode: Number,
    format: AnyDATA_FORMAT,
    values: Outputs = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Sets type and mode and reads several values at once, in the format asked for.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        type: Type the device shall have; 0: keep the type; a member of TYPE; DATA8.
        mode: Mode the device shall have; 0 to 7; -1: keep the mode; DATA8.
        format: DATA_PCT, DATA_RAW or DATA_SI, others give NaN; a member of DATA_FORMAT; DATA8.
        values: How many values follow, each in FORMAT; a list, of the type that format says; an output for each: a list
            of variables, or how many; one when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_READEXT"].draft((layer, no, type, mode, format, values), unchecked)


def input_write(layer: Number, no: Number, bytes: Number, data: Elements, *, unchecked: bool = False) -> Draft:
    """Sends bytes to a UART sensor.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Sensor port, counted from 0; 0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4; DATA8.
        bytes: How many bytes to send; 1 to 32 bytes; DATA8.
        data: Bytes to send; as many values as BYTES says; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_WRITE"].draft((layer, no, bytes, data), unchecked)
