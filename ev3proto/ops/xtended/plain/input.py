"""Opcodes without a CMD in the firmware's area `input`; `ops.xtended` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnyCONN, Elements, Number, Output
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = ["input_iic_read", "input_iic_status", "input_iic_write", "input_set_autoid", "input_set_conn"]

_OPERATIONS = drafts("xtended")


def input_set_conn(layer: Number, no: Number, conn: AnyCONN, *, unchecked: bool = False) -> Draft:
    """Sets how a port is connected, for ports whose automatic detection is off.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Sensor port, counted from 0; 0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4; DATA8.
        conn: CONN_NXT_IIC, CONN_NXT_DUMB, CONN_INPUT_DUMB or CONN_NONE; a member of CONN; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_SET_CONN"].draft((layer, no, conn), unchecked)


def input_iic_read(
    layer: Number,
    no: Number,
    rdlng: Number,
    rddata: Output = None,
    result: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Fetches the bytes that an I2C sensor answered to INPUT_IIC_WRITE.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Sensor port, counted from 0; 0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4; DATA8.
        rdlng: How many bytes to read; 0 to 32 bytes; DATA8.
        rddata: Bytes read; as many values as RDLNG says; DATA8; an output, in global memory when omitted.
        result: OK or FAIL; a member of RESULT; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_IIC_READ"].draft((layer, no, rdlng, rddata, result), unchecked)


def input_iic_status(layer: Number, no: Number, result: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells the state of the I2C bus of a port.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Sensor port, counted from 0; 0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4; DATA8.
        result: State of the bus; a member of RESULT; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_IIC_STATUS"].draft((layer, no, result), unchecked)


def input_iic_write(
    layer: Number,
    no: Number,
    wrlng: Number,
    wrdata: Elements,
    rdlng: Number,
    result: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Sends bytes to an I2C sensor once and does not wait for its answer.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Sensor port, counted from 0; 0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4; DATA8.
        wrlng: How many bytes to write; 0 to 32 bytes; DATA8.
        wrdata: Bytes to write: I2C address, register, data; as many values as WRLNG says; DATA8.
        rdlng: How many bytes the sensor will answer; 0 to 32 bytes; DATA8.
        result: State of the bus after the request; a member of RESULT; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_IIC_WRITE"].draft((layer, no, wrlng, wrdata, rdlng, result), unchecked)


def input_set_autoid(layer: Number, no: Number, enable: Number, *, unchecked: bool = False) -> Draft:
    """Switches the automatic detection of sensors at a port on or off.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Sensor port, counted from 0; 0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4; DATA8.
        enable: Whether to detect; 0 to 1; 0: off; 1: on; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_SET_AUTOID"].draft((layer, no, enable), unchecked)
