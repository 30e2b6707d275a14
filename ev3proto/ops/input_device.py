"""INPUT_DEVICE: asks about devices, calibrates them, reads several values.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnyTYPE, Elements, Number, Output, Outputs, Text
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "cal_default",
    "cal_max",
    "cal_min",
    "cal_minmax",
    "clr_all",
    "clr_changes",
    "get_bumps",
    "get_changes",
    "get_connection",
    "get_figures",
    "get_format",
    "get_minmax",
    "get_modename",
    "get_name",
    "get_raw",
    "get_symbol",
    "get_typemode",
    "insert_type",
    "ready_iic",
    "ready_pct",
    "ready_raw",
    "ready_si",
    "set_raw",
    "set_typemode",
    "setup",
    "stop_all",
]

_OPERATIONS = drafts("official")


def insert_type(typedata: Text, force: Number, error: Output = None, *, unchecked: bool = False) -> Draft:
    """Adds a line to the table of device types, for third party types (50 to 98) only.

    Args:
        typedata: The line as in typedata.rcf, starting with the type's number; string.
        force: Whether to replace a known type; 0 to 1; 0: refuse a known type; 1: replace a known type; DATA8.
        error: Whether it failed; 0 to 1; 0: done; 1: failed or known; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.INSERT_TYPE"].draft((typedata, force, error), unchecked)


def get_format(
    layer: Number,
    no: Number,
    datasets: Output = None,
    format: Output = None,
    modes: Output = None,
    views: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Describes the values of a device in its current mode.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        datasets: Number of values in one reading; DATA8; an output, in global memory when omitted.
        format: Type of one raw value; 0 to 3; a member of DATA_FORMAT; DATA8; an output, in global memory when omitted.
        modes: Number of modes of the device; 1 to 8; DATA8; an output, in global memory when omitted.
        views: Number of modes shown to users; 1 to 8; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.GET_FORMAT"].draft((layer, no, datasets, format, modes, views), unchecked)


def cal_minmax(type: AnyTYPE, mode: Number, cal_min: Number, cal_max: Number, *, unchecked: bool = False) -> Draft:
    """Sets the raw values that scale a type and mode to percent and SI.

    Args:
        type: Type of device the calibration is for; a member of TYPE; DATA8.
        mode: Mode the calibration is for; 0 to 7; DATA8.
        cal_min: Raw value at the lower end; DATA32.
        cal_max: Raw value at full scale; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.CAL_MINMAX"].draft((type, mode, cal_min, cal_max), unchecked)


def cal_default(type: AnyTYPE, mode: Number, *, unchecked: bool = False) -> Draft:
    """Restores the built-in scaling of a type and mode.

    Args:
        type: Type of device the calibration is for; a member of TYPE; DATA8.
        mode: Mode the calibration is for; 0 to 7; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.CAL_DEFAULT"].draft((type, mode), unchecked)


def get_typemode(
    layer: Number,
    no: Number,
    type: Output = None,
    mode: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reports the device at a port and its mode.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        type: Type of the device; a member of TYPE; DATA8; an output, in global memory when omitted.
        mode: Mode the device is in; 0 to 7; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.GET_TYPEMODE"].draft((layer, no, type, mode), unchecked)


def get_symbol(
    layer: Number,
    no: Number,
    length: Number,
    destination: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads the symbol of the unit of the current mode.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        length: Size of the text buffer, including the zero; bytes; -1: unlimited (handles only); DATA8.
        destination: Symbol, padded with blanks; as many bytes as LENGTH says; string; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.GET_SYMBOL"].draft((layer, no, length, destination), unchecked)


def cal_min(type: AnyTYPE, mode: Number, cal_min: Number, *, unchecked: bool = False) -> Draft:
    """Sets the lower end of the scaling of a type and mode.

    Args:
        type: Type of device the calibration is for; a member of TYPE; DATA8.
        mode: Mode the calibration is for; 0 to 7; DATA8.
        cal_min: Value at the lower end, in SI units once calibrated; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.CAL_MIN"].draft((type, mode, cal_min), unchecked)


def cal_max(type: AnyTYPE, mode: Number, cal_max: Number, *, unchecked: bool = False) -> Draft:
    """Sets the full scale of a type and mode.

    Args:
        type: Type of device the calibration is for; a member of TYPE; DATA8.
        mode: Mode the calibration is for; 0 to 7; DATA8.
        cal_max: Value at full scale, in SI units once calibrated; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.CAL_MAX"].draft((type, mode, cal_max), unchecked)


def setup(
    layer: Number,
    no: Number,
    repeat: Number,
    time: Number,
    write_len: Number,
    write_data: Elements,
    read_len: Number,
    read_data: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Writes to an I2C sensor and reads its answer, repeatedly if requested.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Sensor port, counted from 0; 0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4; DATA8.
        repeat: Number of repeats; 0: endless; DATA8.
        time: Time between repeats; 10 to 1000 ms; 0: 10 ms; DATA16.
        write_len: Number of bytes to write; 0 to 32 bytes; DATA8.
        write_data: Bytes to write: I2C address, register, data; as many values as WRITE_LEN says; DATA8.
        read_len: Number of bytes to read, negative: in reverse order; -32 to 32 bytes; DATA8.
        read_data: Bytes read; as many values as READ_LEN says; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.SETUP"].draft(
        (layer, no, repeat, time, write_len, write_data, read_len, read_data), unchecked
    )


def clr_all(layer: Number, *, unchecked: bool = False) -> Draft:
    """Clears counters and angles of all devices.

    Args:
        layer: Brick in the daisy chain; 0 to 3; -1: all layers; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.CLR_ALL"].draft((layer,), unchecked)


def get_raw(layer: Number, no: Number, value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the first raw value of a device.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        value: Raw value, NaN if there is none; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.GET_RAW"].draft((layer, no, value), unchecked)


def get_connection(layer: Number, no: Number, conn: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports how the device at a port is connected.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        conn: Kind of connection; a member of CONN; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.GET_CONNECTION"].draft((layer, no, conn), unchecked)


def stop_all(layer: Number, *, unchecked: bool = False) -> Draft:
    """Stops all devices, motors among them.

    Args:
        layer: Brick in the daisy chain; 0 to 3; -1: all layers; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.STOP_ALL"].draft((layer,), unchecked)


def set_typemode(
    type: AnyTYPE,
    mode: Number,
    newtype: AnyTYPE,
    newmode: Number,
    error: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Renumbers an entry of the table of device types, third party types only.

    Args:
        type: Type of the entry; 50 to 98; a member of TYPE; DATA8.
        mode: Mode of the entry; 0 to 7; DATA8.
        newtype: New type of the entry; 50 to 98; a member of TYPE; DATA8.
        newmode: New mode of the entry; 0 to 7; DATA8.
        error: Whether it failed; 0 to 1; 0: done; 1: failed or not found; DATA8; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.SET_TYPEMODE"].draft((type, mode, newtype, newmode, error), unchecked)


def ready_iic(
    layer: Number,
    no: Number,
    wrlng: Number,
    wrdata: Elements,
    rdlng: Number,
    rddata: Output = None,
    result: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Writes to an I2C sensor once, waits for its answer and reports the result.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Sensor port, counted from 0; 0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4; DATA8.
        wrlng: Number of bytes to write; 0 to 32 bytes; DATA8.
        wrdata: Bytes to write: I2C address, register, data; as many values as WRLNG says; DATA8.
        rdlng: Number of bytes to read, negative: in reverse order; -32 to 32 bytes; DATA8.
        rddata: Bytes read; as many values as RDLNG says; DATA8; an output, in global memory when omitted.
        result: How the transfer ended; a member of RESULT; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.READY_IIC"].draft((layer, no, wrlng, wrdata, rdlng, rddata, result), unchecked)


def get_name(
    layer: Number,
    no: Number,
    length: Number,
    destination: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads the name of a device in its current mode, such as TOUCH or COL-REFLECT.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        length: Size of the text buffer, including the zero; bytes; -1: unlimited (handles only); DATA8.
        destination: Name, padded with blanks; as many bytes as LENGTH says; string; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.GET_NAME"].draft((layer, no, length, destination), unchecked)


def get_modename(
    layer: Number,
    no: Number,
    mode: Number,
    length: Number,
    destination: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads the name of any mode of a device.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        mode: Mode to name; 0 to 7; DATA8.
        length: Size of the text buffer, including the zero; bytes; -1: unlimited (handles only); DATA8.
        destination: Name, padded with blanks; as many bytes as LENGTH says; string; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.GET_MODENAME"].draft((layer, no, mode, length, destination), unchecked)


def set_raw(layer: Number, no: Number, type: AnyTYPE, value: Number, *, unchecked: bool = False) -> Draft:
    """Simulates a raw value of a device.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        type: Type to set; 0: keep the type; a member of TYPE; DATA8.
        value: Raw value to simulate; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.SET_RAW"].draft((layer, no, type, value), unchecked)


def get_figures(
    layer: Number,
    no: Number,
    figures: Output = None,
    decimals: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reports the number of digits that a value of the current mode needs.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        figures: Total number of characters, with point and decimals; DATA8; an output, in global memory when omitted.
        decimals: Digits after the point; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.GET_FIGURES"].draft((layer, no, figures, decimals), unchecked)


def get_changes(layer: Number, no: Number, value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads how often a touch sensor changed to pressed since CLR_CHANGES.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        value: Number of changes, 0 for other sensors; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.GET_CHANGES"].draft((layer, no, value), unchecked)


def clr_changes(layer: Number, no: Number, *, unchecked: bool = False) -> Draft:
    """Sets the counts of GET_CHANGES and GET_BUMPS to zero.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.CLR_CHANGES"].draft((layer, no), unchecked)


def ready_pct(
    layer: Number,
    no: Number,
    type: AnyTYPE,
    mode: Number,
    values: Outputs = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Sets type and mode, waits until the device is ready and reads percent values.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        type: Type to set; 0: keep the type; a member of TYPE; DATA8.
        mode: Mode to set; 0 to 7; -1: keep the mode; DATA8.
        values: Number of values that follow, each in percent; a list of DATA8; an output for each: a list of variables,
            or how many; one when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.READY_PCT"].draft((layer, no, type, mode, values), unchecked)


def ready_raw(
    layer: Number,
    no: Number,
    type: AnyTYPE,
    mode: Number,
    values: Outputs = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Sets type and mode, waits until the device is ready and reads raw values.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        type: Type to set; 0: keep the type; a member of TYPE; DATA8.
        mode: Mode to set; 0 to 7; -1: keep the mode; DATA8.
        values: Number of raw values that follow; a list of DATA32; an output for each: a list of variables, or how
            many; one when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.READY_RAW"].draft((layer, no, type, mode, values), unchecked)


def ready_si(
    layer: Number,
    no: Number,
    type: AnyTYPE,
    mode: Number,
    values: Outputs = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Sets type and mode, waits until the device is ready and reads SI values.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        type: Type to set; 0: keep the type; a member of TYPE; DATA8.
        mode: Mode to set; 0 to 7; -1: keep the mode; DATA8.
        values: Number of values that follow, each in SI units; a list of DATAF; an output for each: a list of
            variables, or how many; one when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.READY_SI"].draft((layer, no, type, mode, values), unchecked)


def get_minmax(layer: Number, no: Number, min: Output = None, max: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports the range of SI values of the current mode.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        min: Smallest value in SI units; DATAF; an output, in global memory when omitted.
        max: Largest value in SI units; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.GET_MINMAX"].draft((layer, no, min, max), unchecked)


def get_bumps(layer: Number, no: Number, value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads how often a touch sensor changed to released since CLR_CHANGES.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        value: Number of changes, 0 for other sensors; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_DEVICE.GET_BUMPS"].draft((layer, no, value), unchecked)
