"""Opcodes without a CMD in the firmware's area `com`; `ops` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from collections.abc import Sequence

from ev3proto.ops.argument_types import AnyDATA_FORMAT, AnyFILETYPE, AnyHWTYPE, Number, Output, Outputs, Text, Untyped
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "com_readdata",
    "com_ready",
    "com_remove",
    "com_test",
    "com_writedata",
    "com_writefile",
    "mailbox_close",
    "mailbox_open",
    "mailbox_read",
    "mailbox_ready",
    "mailbox_test",
    "mailbox_write",
]

_OPERATIONS = drafts("official")


def com_ready(hardware: AnyHWTYPE, name: Text, *, unchecked: bool = False) -> Draft:
    """Waits until nothing is being sent to a device.

    Args:
        hardware: Which way to communicate; a member of HWTYPE; DATA8.
        name: Name of the other device, empty: the brick's own adapter; string.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_READY"].draft((hardware, name), unchecked)


def com_readdata(
    value1: AnyHWTYPE,
    value2: Number,
    value3: Number,
    value4: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Does nothing in the firmware, meant to receive data.

    Args:
        value1: Which way to communicate, ignored; a member of HWTYPE; DATA8.
        value2: Name of the other device, ignored; DATA8.
        value3: Number of bytes, ignored; bytes; DATA16.
        value4: The bytes, ignored; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_READDATA"].draft((value1, value2, value3, value4), unchecked)


def com_writedata(
    value1: AnyHWTYPE,
    value2: Number,
    value3: Number,
    value4: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Does nothing in the firmware, meant to send data.

    Args:
        value1: Which way to communicate, ignored; a member of HWTYPE; DATA8.
        value2: Name of the other device, ignored; DATA8.
        value3: Number of bytes, ignored; bytes; DATA16.
        value4: The bytes, ignored; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_WRITEDATA"].draft((value1, value2, value3, value4), unchecked)


def com_test(hardware: AnyHWTYPE, name: Text, busy: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether something is still being sent to a device.

    Args:
        hardware: Which way to communicate; a member of HWTYPE; DATA8.
        name: Name of the other device, empty: the brick's own adapter; string.
        busy: Whether to wait; 0 to 1; 0: ready; 1: busy; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_TEST"].draft((hardware, name, busy), unchecked)


def com_remove(hardware: AnyHWTYPE, remote_name: Text, *, unchecked: bool = False) -> Draft:
    """Forgets a paired device or a known network.

    Args:
        hardware: Which way to communicate; a member of HWTYPE; DATA8.
        remote_name: Name of the other device or network; string.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_REMOVE"].draft((hardware, remote_name), unchecked)


def com_writefile(
    hardware: AnyHWTYPE,
    remote_name: Text,
    file_name: Text,
    file_type: AnyFILETYPE,
    *,
    unchecked: bool = False,
) -> Draft:
    """Sends a file or a folder to another brick, Bluetooth only.

    Args:
        hardware: Which way to communicate; a member of HWTYPE; DATA8.
        remote_name: Name of the other device or network; string.
        file_name: Path of the file or folder on this brick; string.
        file_type: TYPE_FOLDER for a folder, else a file; a member of FILETYPE; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_WRITEFILE"].draft((hardware, remote_name, file_name, file_type), unchecked)


def mailbox_open(
    no: Number,
    boxname: Text,
    types: AnyDATA_FORMAT,
    fifosize: Number,
    values: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Opens a mailbox on this brick, at most 250 bytes of content.

    Args:
        no: Number of the mailbox on this brick; 0 to 29; DATA8.
        boxname: Name of the mailbox, at most 49 characters; at most 49 characters; string.
        types: Type of its values; a member of DATA_FORMAT; DATA8.
        fifosize: Depth of the queue, ignored by the firmware; DATA8.
        values: Number of values, ignored by the firmware; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MAILBOX_OPEN"].draft((no, boxname, types, fifosize, values), unchecked)


def mailbox_write(
    brickname: Text,
    hardware: AnyHWTYPE,
    boxname: Text,
    type: AnyDATA_FORMAT,
    values: Sequence[Untyped],
    *,
    unchecked: bool = False,
) -> Draft:
    """Sends values to a mailbox of another brick, Bluetooth only.

    Args:
        brickname: Name of the other brick, empty: all connected ones; string.
        hardware: Read by the firmware and never used; 0: as compilers write; a member of HWTYPE; DATA8.
        boxname: Name of the mailbox; string.
        type: Type of the values; a member of DATA_FORMAT; DATA8.
        values: How many values of TYPE follow, one only for a string; a list, of the type that type says.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MAILBOX_WRITE"].draft((brickname, hardware, boxname, type, values), unchecked)


def mailbox_read(no: Number, length: Number, values: Outputs = None, *, unchecked: bool = False) -> Draft:
    """Reads the content of a mailbox and marks it read.

    Args:
        no: Number of the mailbox on this brick; 0 to 29; DATA8.
        length: Most bytes to read, ignored by the firmware; bytes; DATA8.
        values: How many values follow, of the type given to MAILBOX_OPEN; a list of array-typed; an output for each: a
            list of variables, or how many; one when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MAILBOX_READ"].draft((no, length, values), unchecked)


def mailbox_test(no: Number, busy: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether a mailbox has an unread message.

    Args:
        no: Number of the mailbox on this brick; 0 to 29; DATA8.
        busy: Whether to wait; 0 to 1; 0: a new message is there; 1: nothing new; DATA8; an output, in global memory
            when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MAILBOX_TEST"].draft((no, busy), unchecked)


def mailbox_ready(no: Number, *, unchecked: bool = False) -> Draft:
    """Waits for an unread message in a mailbox.

    Args:
        no: Number of the mailbox on this brick; 0 to 29; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MAILBOX_READY"].draft((no,), unchecked)


def mailbox_close(no: Number, *, unchecked: bool = False) -> Draft:
    """Closes a mailbox on this brick.

    Args:
        no: Number of the mailbox on this brick; 0 to 29; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MAILBOX_CLOSE"].draft((no,), unchecked)
