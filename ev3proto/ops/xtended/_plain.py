"""Opcodes without a CMD, area by area; `ops.xtended` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnyCONN, Elements, Number, Output, Text
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "dynload_entry_0",
    "dynload_entry_1",
    "dynload_entry_2",
    "dynload_entry_3",
    "dynload_entry_4",
    "dynload_entry_5",
    "dynload_entry_6",
    "dynload_entry_7",
    "dynload_entry_8",
    "dynload_entry_9",
    "dynload_get_vm",
    "dynload_vmexit",
    "dynload_vmload",
    "file_md5sum",
    "input_iic_read",
    "input_iic_status",
    "input_iic_write",
    "input_set_autoid",
    "input_set_conn",
    "mailbox_size",
]

_OPERATIONS = drafts("xtended")


def mailbox_size(no: Number, size: Output = None, *, unchecked: bool = False) -> Draft:
    """Returns the size of a mailbox's content.

    Args:
        no: Number of the mailbox on this brick; 0 to 29; DATA8.
        size: Size of the content; bytes; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MAILBOX_SIZE"].draft((no, size), unchecked)


def input_set_conn(layer: Number, no: Number, conn: AnyCONN, *, unchecked: bool = False) -> Draft:
    """Sets how a port is connected, for ports whose automatic detection is off.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Sensor port, counted from 0; 0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4; DATA8.
        conn: CONN_NXT_IIC, CONN_NXT_DUMB, CONN_INPUT_DUMB or CONN_NONE; a member of CONN; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        rdlng: Number of bytes to read; 0 to 32 bytes; DATA8.
        rddata: Bytes read; as many values as RDLNG says; DATA8; an output, in global memory when omitted.
        result: OK or FAIL; a member of RESULT; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_IIC_READ"].draft((layer, no, rdlng, rddata, result), unchecked)


def input_iic_status(layer: Number, no: Number, result: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports the state of the I2C bus of a port.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Sensor port, counted from 0; 0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4; DATA8.
        result: State of the bus; a member of RESULT; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
    """Sends bytes to an I2C sensor once, without waiting for its answer.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Sensor port, counted from 0; 0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4; DATA8.
        wrlng: Number of bytes to write; 0 to 32 bytes; DATA8.
        wrdata: Bytes to write: I2C address, register, data; as many values as WRLNG says; DATA8.
        rdlng: Number of bytes in the sensor's answer; 0 to 32 bytes; DATA8.
        result: State of the bus after the request; a member of RESULT; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_IIC_WRITE"].draft((layer, no, wrlng, wrdata, rdlng, result), unchecked)


def input_set_autoid(layer: Number, no: Number, enable: Number, *, unchecked: bool = False) -> Draft:
    """Switches the automatic detection of sensors at a port on or off.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Sensor port, counted from 0; 0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4; DATA8.
        enable: Whether to detect; 0 to 1; 0: off; 1: on; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_SET_AUTOID"].draft((layer, no, enable), unchecked)


def file_md5sum(name: Text, md5sum: Output = None, success: Output = None, *, unchecked: bool = False) -> Draft:
    """Computes the MD5 digest of a file.

    Args:
        name: Path of the file; string.
        md5sum: The digest, as 16 bytes; 16 values; DATA8; an output, in global memory when omitted.
        success: Whether the file could be read; 0: no; 1: yes; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["FILE_MD5SUM"].draft((name, md5sum, success), unchecked)


def dynload_vmload(vmindex: Number, result: Output = None, *, unchecked: bool = False) -> Draft:
    """Loads an additional virtual machine; fails while another one is loaded.

    Args:
        vmindex: Which one; 0 to 1; 0: RobotC; 1: LabVIEW; DATA8.
        result: OK or FAIL; a member of RESULT; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DYNLOAD_VMLOAD"].draft((vmindex, result), unchecked)


def dynload_vmexit(*, unchecked: bool = False) -> Draft:
    """Unloads the additional virtual machine."""
    return _OPERATIONS["DYNLOAD_VMEXIT"].draft((), unchecked)


def dynload_entry_0(
    cmd: Number,
    length_in: Number,
    length_out: Output = None,
    value: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 0 of the additional virtual machine that is loaded.

    Args:
        cmd: Function to call, in that machine's numbering; DATA8.
        length_in: Amount of data passed; DATA8.
        length_out: Number of elements returned; DATA16; an output, in global memory when omitted.
        value: The returned elements; their type depends on CMD; as many values as LENGTH_OUT says; array-typed; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DYNLOAD_ENTRY_0"].draft((cmd, length_in, length_out, value), unchecked)


def dynload_entry_1(
    cmd: Number,
    length_in: Number,
    length_out: Output = None,
    value: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 1 of the additional virtual machine that is loaded.

    Args:
        cmd: Function to call, in that machine's numbering; DATA8.
        length_in: Amount of data passed; DATA8.
        length_out: Number of elements returned; DATA16; an output, in global memory when omitted.
        value: The returned elements; their type depends on CMD; as many values as LENGTH_OUT says; array-typed; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DYNLOAD_ENTRY_1"].draft((cmd, length_in, length_out, value), unchecked)


def dynload_entry_2(
    cmd: Number,
    length_in: Number,
    length_out: Output = None,
    value: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 2 of the additional virtual machine that is loaded.

    Args:
        cmd: Function to call, in that machine's numbering; DATA8.
        length_in: Amount of data passed; DATA8.
        length_out: Number of elements returned; DATA16; an output, in global memory when omitted.
        value: The returned elements; their type depends on CMD; as many values as LENGTH_OUT says; array-typed; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DYNLOAD_ENTRY_2"].draft((cmd, length_in, length_out, value), unchecked)


def dynload_entry_3(
    cmd: Number,
    length_in: Number,
    length_out: Output = None,
    value: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 3 of the additional virtual machine that is loaded.

    Args:
        cmd: Function to call, in that machine's numbering; DATA8.
        length_in: Amount of data passed; DATA8.
        length_out: Number of elements returned; DATA16; an output, in global memory when omitted.
        value: The returned elements; their type depends on CMD; as many values as LENGTH_OUT says; array-typed; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DYNLOAD_ENTRY_3"].draft((cmd, length_in, length_out, value), unchecked)


def dynload_entry_4(
    cmd: Number,
    length_in: Number,
    length_out: Output = None,
    value: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 4 of the additional virtual machine that is loaded.

    Args:
        cmd: Function to call, in that machine's numbering; DATA8.
        length_in: Amount of data passed; DATA8.
        length_out: Number of elements returned; DATA16; an output, in global memory when omitted.
        value: The returned elements; their type depends on CMD; as many values as LENGTH_OUT says; array-typed; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DYNLOAD_ENTRY_4"].draft((cmd, length_in, length_out, value), unchecked)


def dynload_entry_5(
    cmd: Number,
    length_in: Number,
    length_out: Output = None,
    value: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 5 of the additional virtual machine that is loaded.

    Args:
        cmd: Function to call, in that machine's numbering; DATA8.
        length_in: Amount of data passed; DATA8.
        length_out: Number of elements returned; DATA16; an output, in global memory when omitted.
        value: The returned elements; their type depends on CMD; as many values as LENGTH_OUT says; array-typed; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DYNLOAD_ENTRY_5"].draft((cmd, length_in, length_out, value), unchecked)


def dynload_entry_6(
    cmd: Number,
    length_in: Number,
    length_out: Output = None,
    value: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 6 of the additional virtual machine that is loaded.

    Args:
        cmd: Function to call, in that machine's numbering; DATA8.
        length_in: Amount of data passed; DATA8.
        length_out: Number of elements returned; DATA16; an output, in global memory when omitted.
        value: The returned elements; their type depends on CMD; as many values as LENGTH_OUT says; array-typed; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DYNLOAD_ENTRY_6"].draft((cmd, length_in, length_out, value), unchecked)


def dynload_entry_7(
    cmd: Number,
    length_in: Number,
    length_out: Output = None,
    value: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 7 of the additional virtual machine that is loaded.

    Args:
        cmd: Function to call, in that machine's numbering; DATA8.
        length_in: Amount of data passed; DATA8.
        length_out: Number of elements returned; DATA16; an output, in global memory when omitted.
        value: The returned elements; their type depends on CMD; as many values as LENGTH_OUT says; array-typed; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DYNLOAD_ENTRY_7"].draft((cmd, length_in, length_out, value), unchecked)


def dynload_entry_8(
    cmd: Number,
    length_in: Number,
    length_out: Output = None,
    value: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 8 of the additional virtual machine that is loaded.

    Args:
        cmd: Function to call, in that machine's numbering; DATA8.
        length_in: Amount of data passed; DATA8.
        length_out: Number of elements returned; DATA16; an output, in global memory when omitted.
        value: The returned elements; their type depends on CMD; as many values as LENGTH_OUT says; array-typed; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DYNLOAD_ENTRY_8"].draft((cmd, length_in, length_out, value), unchecked)


def dynload_entry_9(
    cmd: Number,
    length_in: Number,
    length_out: Output = None,
    value: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Calls entry point 9 of the additional virtual machine that is loaded.

    Args:
        cmd: Function to call, in that machine's numbering; DATA8.
        length_in: Amount of data passed; DATA8.
        length_out: Number of elements returned; DATA16; an output, in global memory when omitted.
        value: The returned elements; their type depends on CMD; as many values as LENGTH_OUT says; array-typed; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DYNLOAD_ENTRY_9"].draft((cmd, length_in, length_out, value), unchecked)


def dynload_get_vm(result: Output = None, *, unchecked: bool = False) -> Draft:
    """Asks which additional virtual machine is loaded.

    Args:
        result: Which one; 0 to 1; -1: none; 0: RobotC; 1: LabVIEW; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DYNLOAD_GET_VM"].draft((result,), unchecked)
