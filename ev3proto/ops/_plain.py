"""Opcodes without a CMD, area by area; `ops` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import overload

from ev3proto.ops.argument_types import (
    AnyDATA_FORMAT,
    AnyFILETYPE,
    AnyHWTYPE,
    AnySLOT,
    AnyTYPE,
    Elements,
    Jump,
    NamedNumber,
    Number,
    Output,
    Outputs,
    Real,
    Text,
    Untyped,
)
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import REQUIRED, drafts

__all__ = [
    "add8",
    "add16",
    "add32",
    "addf",
    "and8",
    "and16",
    "and32",
    "array_append",
    "array_read",
    "array_write",
    "bp0",
    "bp1",
    "bp2",
    "bp3",
    "bp_set",
    "call",
    "com_readdata",
    "com_ready",
    "com_remove",
    "com_test",
    "com_writedata",
    "com_writefile",
    "cp_eq8",
    "cp_eq16",
    "cp_eq32",
    "cp_eqf",
    "cp_gt8",
    "cp_gt16",
    "cp_gt32",
    "cp_gteq8",
    "cp_gteq16",
    "cp_gteq32",
    "cp_gteqf",
    "cp_gtf",
    "cp_lt8",
    "cp_lt16",
    "cp_lt32",
    "cp_lteq8",
    "cp_lteq16",
    "cp_lteq32",
    "cp_lteqf",
    "cp_ltf",
    "cp_neq8",
    "cp_neq16",
    "cp_neq32",
    "cp_neqf",
    "div8",
    "div16",
    "div32",
    "divf",
    "do",
    "error",
    "init_bytes",
    "input_device_list",
    "input_read",
    "input_readext",
    "input_readsi",
    "input_ready",
    "input_sample",
    "input_test",
    "input_write",
    "jr",
    "jr_eq8",
    "jr_eq16",
    "jr_eq32",
    "jr_eqf",
    "jr_false",
    "jr_gt8",
    "jr_gt16",
    "jr_gt32",
    "jr_gteq8",
    "jr_gteq16",
    "jr_gteq32",
    "jr_gteqf",
    "jr_gtf",
    "jr_lt8",
    "jr_lt16",
    "jr_lt32",
    "jr_lteq8",
    "jr_lteq16",
    "jr_lteq32",
    "jr_lteqf",
    "jr_ltf",
    "jr_nan",
    "jr_neq8",
    "jr_neq16",
    "jr_neq32",
    "jr_neqf",
    "jr_true",
    "keep_alive",
    "label",
    "mailbox_close",
    "mailbox_open",
    "mailbox_read",
    "mailbox_ready",
    "mailbox_test",
    "mailbox_write",
    "memory_read",
    "memory_usage",
    "memory_write",
    "move8_8",
    "move8_16",
    "move8_32",
    "move8_f",
    "move16_8",
    "move16_16",
    "move16_32",
    "move16_f",
    "move32_8",
    "move32_16",
    "move32_32",
    "move32_f",
    "movef_8",
    "movef_16",
    "movef_32",
    "movef_f",
    "mul8",
    "mul16",
    "mul32",
    "mulf",
    "nop",
    "note_to_freq",
    "object_end",
    "object_start",
    "object_stop",
    "object_trig",
    "object_wait",
    "or8",
    "or16",
    "or32",
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
    "port_cnv_input",
    "port_cnv_output",
    "probe",
    "program_start",
    "program_stop",
    "random",
    "read8",
    "read16",
    "read32",
    "readf",
    "return_",
    "rl8",
    "rl16",
    "rl32",
    "select8",
    "select16",
    "select32",
    "selectf",
    "sleep",
    "sound_ready",
    "sound_test",
    "sub8",
    "sub16",
    "sub32",
    "subf",
    "system",
    "timer_read",
    "timer_read_us",
    "timer_ready",
    "timer_wait",
    "ui_flush",
    "write8",
    "write16",
    "write32",
    "writef",
    "xor8",
    "xor16",
    "xor32",
]

_OPERATIONS = drafts("official")


def jr(offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps always.

    Args:
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR"].draft((offset,), unchecked)


def jr_false(flag: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if a flag is 0.

    Args:
        flag: The condition: anything but 0 is true; 0: false; 1: true; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_FALSE"].draft((flag, offset), unchecked)


def jr_true(flag: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if a flag is not 0.

    Args:
        flag: The condition: anything but 0 is true; 0: false; 1: true; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_TRUE"].draft((flag, offset), unchecked)


def jr_nan(value: Real, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if a value is not a number, as read from a sensor without data.

    Args:
        value: Value to look at; DATAF.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_NAN"].draft((value, offset), unchecked)


def jr_lt8(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LT8"].draft((left, right, offset), unchecked)


def jr_lt16(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LT16"].draft((left, right, offset), unchecked)


def jr_lt32(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LT32"].draft((left, right, offset), unchecked)


def jr_ltf(left: Real, right: Real, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LTF"].draft((left, right, offset), unchecked)


def jr_gt8(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GT8"].draft((left, right, offset), unchecked)


def jr_gt16(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GT16"].draft((left, right, offset), unchecked)


def jr_gt32(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GT32"].draft((left, right, offset), unchecked)


def jr_gtf(left: Real, right: Real, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GTF"].draft((left, right, offset), unchecked)


def jr_eq8(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is equal to RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_EQ8"].draft((left, right, offset), unchecked)


def jr_eq16(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is equal to RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_EQ16"].draft((left, right, offset), unchecked)


def jr_eq32(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is equal to RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_EQ32"].draft((left, right, offset), unchecked)


def jr_eqf(left: Real, right: Real, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is equal to RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_EQF"].draft((left, right, offset), unchecked)


def jr_neq8(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is different from RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_NEQ8"].draft((left, right, offset), unchecked)


def jr_neq16(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is different from RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_NEQ16"].draft((left, right, offset), unchecked)


def jr_neq32(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is different from RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_NEQ32"].draft((left, right, offset), unchecked)


def jr_neqf(left: Real, right: Real, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is different from RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_NEQF"].draft((left, right, offset), unchecked)


def jr_lteq8(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than or equal to RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LTEQ8"].draft((left, right, offset), unchecked)


def jr_lteq16(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than or equal to RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LTEQ16"].draft((left, right, offset), unchecked)


def jr_lteq32(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than or equal to RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LTEQ32"].draft((left, right, offset), unchecked)


def jr_lteqf(left: Real, right: Real, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is less than or equal to RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_LTEQF"].draft((left, right, offset), unchecked)


def jr_gteq8(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than or equal to RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GTEQ8"].draft((left, right, offset), unchecked)


def jr_gteq16(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than or equal to RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GTEQ16"].draft((left, right, offset), unchecked)


def jr_gteq32(left: Number, right: Number, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than or equal to RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GTEQ32"].draft((left, right, offset), unchecked)


def jr_gteqf(left: Real, right: Real, offset: Jump, *, unchecked: bool = False) -> Draft:
    """Jumps if LEFT is greater than or equal to RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        offset: How far to jump from the end of this operation; negative jumps back; or a label; bytes; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["JR_GTEQF"].draft((left, right, offset), unchecked)


def com_ready(hardware: AnyHWTYPE, name: Text, *, unchecked: bool = False) -> Draft:
    """Waits until nothing is being sent to a device.

    Args:
        hardware: Carrier to use; a member of HWTYPE; DATA8.
        name: Name of the other device, empty: the brick's own adapter; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
    """Does nothing in the firmware; meant to receive data.

    Args:
        value1: Carrier, ignored; a member of HWTYPE; DATA8.
        value2: Name of the other device, ignored; DATA8.
        value3: Number of bytes, ignored; bytes; DATA16.
        value4: The bytes, ignored; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
    """Does nothing in the firmware; meant to send data.

    Args:
        value1: Carrier, ignored; a member of HWTYPE; DATA8.
        value2: Name of the other device, ignored; DATA8.
        value3: Number of bytes, ignored; bytes; DATA16.
        value4: The bytes, ignored; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_WRITEDATA"].draft((value1, value2, value3, value4), unchecked)


def com_test(hardware: AnyHWTYPE, name: Text, busy: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether something is still being sent to a device.

    Args:
        hardware: Carrier to use; a member of HWTYPE; DATA8.
        name: Name of the other device, empty: the brick's own adapter; string.
        busy: Whether to wait; 0 to 1; 0: ready; 1: busy; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_TEST"].draft((hardware, name, busy), unchecked)


def com_remove(hardware: AnyHWTYPE, remote_name: Text, *, unchecked: bool = False) -> Draft:
    """Forgets a paired device or a known network.

    Args:
        hardware: Carrier to use; a member of HWTYPE; DATA8.
        remote_name: Name of the other device or network; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        hardware: Carrier to use; a member of HWTYPE; DATA8.
        remote_name: Name of the other device or network; string.
        file_name: Path of the file or folder on this brick; string.
        file_type: TYPE_FOLDER for a folder, else a file; a member of FILETYPE; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        boxname: Name of the mailbox; at most 49 characters; string.
        types: Type of its values; a member of DATA_FORMAT; DATA8.
        fifosize: Depth of the queue, ignored by the firmware; DATA8.
        values: Number of values, ignored by the firmware; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        boxname: Name of the mailbox; at most 49 characters; string.
        type: Type of the values; a member of DATA_FORMAT; DATA8.
        values: Number of values of TYPE follow; exactly one for a string, of at most 249 characters; at most 249
            characters; a list, of the type in type.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MAILBOX_WRITE"].draft((brickname, hardware, boxname, type, values), unchecked)


def mailbox_read(no: Number, length: Number, values: Outputs = None, *, unchecked: bool = False) -> Draft:
    """Reads the content of a mailbox and marks it read.

    Args:
        no: Number of the mailbox on this brick; 0 to 29; DATA8.
        length: Maximum number of bytes to read, ignored by the firmware; bytes; DATA8.
        values: Number of values that follow, in the type of MAILBOX_OPEN; a list of array-typed; an output for each: a
            list of variables, or how many; one when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MAILBOX_READ"].draft((no, length, values), unchecked)


def mailbox_test(no: Number, busy: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether a mailbox has an unread message.

    Args:
        no: Number of the mailbox on this brick; 0 to 29; DATA8.
        busy: Whether to wait; 0 to 1; 0: a new message is there; 1: nothing new; DATA8; an output, in global memory
            when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MAILBOX_TEST"].draft((no, busy), unchecked)


def mailbox_ready(no: Number, *, unchecked: bool = False) -> Draft:
    """Waits for an unread message in a mailbox.

    Args:
        no: Number of the mailbox on this brick; 0 to 29; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MAILBOX_READY"].draft((no,), unchecked)


def mailbox_close(no: Number, *, unchecked: bool = False) -> Draft:
    """Closes a mailbox on this brick.

    Args:
        no: Number of the mailbox on this brick; 0 to 29; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MAILBOX_CLOSE"].draft((no,), unchecked)


def cp_lt8(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is less than RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LT8"].draft((left, right, flag), unchecked)


def cp_lt16(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is less than RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LT16"].draft((left, right, flag), unchecked)


def cp_lt32(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is less than RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LT32"].draft((left, right, flag), unchecked)


def cp_ltf(left: Real, right: Real, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is less than RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LTF"].draft((left, right, flag), unchecked)


def cp_gt8(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is greater than RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GT8"].draft((left, right, flag), unchecked)


def cp_gt16(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is greater than RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GT16"].draft((left, right, flag), unchecked)


def cp_gt32(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is greater than RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GT32"].draft((left, right, flag), unchecked)


def cp_gtf(left: Real, right: Real, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is greater than RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GTF"].draft((left, right, flag), unchecked)


def cp_eq8(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is equal to RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_EQ8"].draft((left, right, flag), unchecked)


def cp_eq16(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is equal to RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_EQ16"].draft((left, right, flag), unchecked)


def cp_eq32(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is equal to RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_EQ32"].draft((left, right, flag), unchecked)


def cp_eqf(left: Real, right: Real, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is equal to RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_EQF"].draft((left, right, flag), unchecked)


def cp_neq8(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is different from RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_NEQ8"].draft((left, right, flag), unchecked)


def cp_neq16(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is different from RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_NEQ16"].draft((left, right, flag), unchecked)


def cp_neq32(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is different from RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_NEQ32"].draft((left, right, flag), unchecked)


def cp_neqf(left: Real, right: Real, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is different from RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_NEQF"].draft((left, right, flag), unchecked)


def cp_lteq8(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is less than or equal to RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LTEQ8"].draft((left, right, flag), unchecked)


def cp_lteq16(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is less than or equal to RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LTEQ16"].draft((left, right, flag), unchecked)


def cp_lteq32(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is less than or equal to RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LTEQ32"].draft((left, right, flag), unchecked)


def cp_lteqf(left: Real, right: Real, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is less than or equal to RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_LTEQF"].draft((left, right, flag), unchecked)


def cp_gteq8(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is greater than or equal to RIGHT, as 8-bit numbers.

    Args:
        left: Left side of the comparison; DATA8.
        right: Right side of the comparison; DATA8.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GTEQ8"].draft((left, right, flag), unchecked)


def cp_gteq16(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is greater than or equal to RIGHT, as 16-bit numbers.

    Args:
        left: Left side of the comparison; DATA16.
        right: Right side of the comparison; DATA16.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GTEQ16"].draft((left, right, flag), unchecked)


def cp_gteq32(left: Number, right: Number, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is greater than or equal to RIGHT, as 32-bit numbers.

    Args:
        left: Left side of the comparison; DATA32.
        right: Right side of the comparison; DATA32.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GTEQ32"].draft((left, right, flag), unchecked)


def cp_gteqf(left: Real, right: Real, flag: Output = None, *, unchecked: bool = False) -> Draft:
    """Tests whether LEFT is greater than or equal to RIGHT, as floating-point numbers.

    Args:
        left: Left side of the comparison; DATAF.
        right: Right side of the comparison; DATAF.
        flag: Result of the comparison; 0 to 1; 0: false; 1: true; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CP_GTEQF"].draft((left, right, flag), unchecked)


def select8(flag: Number, source1: Number, source2: Number, result: Output = None, *, unchecked: bool = False) -> Draft:
    """Selects one of two 8-bit values by a flag.

    Args:
        flag: Which one: anything but 0 selects SOURCE1; 0: SOURCE2; 1: SOURCE1; DATA8.
        source1: Value selected if the flag is set; DATA8.
        source2: Value selected if the flag is 0; DATA8.
        result: The selected value; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SELECT8"].draft((flag, source1, source2, result), unchecked)


def select16(
    flag: Number,
    source1: Number,
    source2: Number,
    result: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Selects one of two 16-bit values by a flag.

    Args:
        flag: Which one: anything but 0 selects SOURCE1; 0: SOURCE2; 1: SOURCE1; DATA8.
        source1: Value selected if the flag is set; DATA16.
        source2: Value selected if the flag is 0; DATA16.
        result: The selected value; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SELECT16"].draft((flag, source1, source2, result), unchecked)


def select32(
    flag: Number,
    source1: Number,
    source2: Number,
    result: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Selects one of two 32-bit values by a flag.

    Args:
        flag: Which one: anything but 0 selects SOURCE1; 0: SOURCE2; 1: SOURCE1; DATA8.
        source1: Value selected if the flag is set; DATA32.
        source2: Value selected if the flag is 0; DATA32.
        result: The selected value; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SELECT32"].draft((flag, source1, source2, result), unchecked)


def selectf(flag: Number, source1: Real, source2: Real, result: Output = None, *, unchecked: bool = False) -> Draft:
    """Selects one of two floating-point values by a flag.

    Args:
        flag: Which one: anything but 0 selects SOURCE1; 0: SOURCE2; 1: SOURCE1; DATA8.
        source1: Value selected if the flag is set; DATAF.
        source2: Value selected if the flag is 0; DATAF.
        result: The selected value; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SELECTF"].draft((flag, source1, source2, result), unchecked)


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
        samples: Number of devices the arrays list; DATA16.
        init: Place in the sample buffer of each device, -1 starts it anew; as many values as SAMPLES says; DATA16.
        devices: Ports, 0 to 3 for sensors, 4 to 7 for motors A to D; as many values as SAMPLES says; DATA8.
        types: Type to set for each device; a member of TYPE; as many values as SAMPLES says; DATA8.
        modes: Mode to set for each device; as many values as SAMPLES says; DATA8.
        datasets: Index of the value to read from each device, from 0; as many values as SAMPLES says; DATA8.
        values: One value per device, NaN if there is none; as many values as SAMPLES says; DATAF; an output, in global
            memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        length: Size of the array; 32 holds the whole daisy chain; 0 to 127; DATA8.
        array: Type of device at each port; a member of TYPE; as many values as LENGTH says; DATA8; an output, in global
            memory when omitted.
        changed: Whether devices came or went since the last call; 0: no change; DATA8; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        type: Type to set; 0: keep the type; a member of TYPE; DATA8.
        mode: Mode to set; 0 to 7; -1: keep the mode; DATA8.
        pct: Value, NaN if there is none; %; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_READ"].draft((layer, no, type, mode, pct), unchecked)


def input_test(layer: Number, no: Number, busy: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether a device is still changing type or mode.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        busy: Whether to wait; 0 to 1; 0: ready; 1: busy; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_TEST"].draft((layer, no, busy), unchecked)


def input_ready(layer: Number, no: Number, *, unchecked: bool = False) -> Draft:
    """Waits until a device has valid values.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 16 to 19 for motors; 0 to 19; 0: port 1; 1: port 2; 2: port 3; 3: port 4; 16: motor
            port A; 17: motor port B; 18: motor port C; 19: motor port D; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        type: Type to set; 0: keep the type; a member of TYPE; DATA8.
        mode: Mode to set; 0 to 7; -1: keep the mode; DATA8.
        si: Value in the mode's unit, NaN if there is none; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        type: Type to set; 0: keep the type; a member of TYPE; DATA8.
        mode: Mode to set; 0 to 7; -1: keep the mode; DATA8.
        format: DATA_PCT, DATA_RAW or DATA_SI; others give NaN; a member of DATA_FORMAT; DATA8.
        values: Number of values that follow, each in FORMAT; a list, of the type in format; an output for each: a list
            of variables, or how many; one when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_READEXT"].draft((layer, no, type, mode, format, values), unchecked)


def input_write(layer: Number, no: Number, bytes: Number, data: Elements, *, unchecked: bool = False) -> Draft:
    """Sends bytes to a UART sensor.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Sensor port, counted from 0; 0 to 3; 0: port 1; 1: port 2; 2: port 3; 3: port 4; DATA8.
        bytes: Number of bytes to send; 1 to 32 bytes; DATA8.
        data: Bytes to send; as many values as BYTES says; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INPUT_WRITE"].draft((layer, no, bytes, data), unchecked)


def add8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Adds two 8-bit numbers.

    Args:
        source1: First number; DATA8.
        source2: Second number; DATA8.
        destination: Their sum; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ADD8"].draft((source1, source2, destination), unchecked)


def add16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Adds two 16-bit numbers.

    Args:
        source1: First number; DATA16.
        source2: Second number; DATA16.
        destination: Their sum; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ADD16"].draft((source1, source2, destination), unchecked)


def add32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Adds two 32-bit numbers.

    Args:
        source1: First number; DATA32.
        source2: Second number; DATA32.
        destination: Their sum; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ADD32"].draft((source1, source2, destination), unchecked)


def addf(source1: Real, source2: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Adds two floating-point numbers.

    Args:
        source1: First number; DATAF.
        source2: Second number; DATAF.
        destination: Their sum; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ADDF"].draft((source1, source2, destination), unchecked)


def sub8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Subtracts one 8-bit number from another.

    Args:
        source1: Number to subtract from; DATA8.
        source2: Number to subtract; DATA8.
        destination: SOURCE1 less SOURCE2; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SUB8"].draft((source1, source2, destination), unchecked)


def sub16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Subtracts one 16-bit number from another.

    Args:
        source1: Number to subtract from; DATA16.
        source2: Number to subtract; DATA16.
        destination: SOURCE1 less SOURCE2; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SUB16"].draft((source1, source2, destination), unchecked)


def sub32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Subtracts one 32-bit number from another.

    Args:
        source1: Number to subtract from; DATA32.
        source2: Number to subtract; DATA32.
        destination: SOURCE1 less SOURCE2; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SUB32"].draft((source1, source2, destination), unchecked)


def subf(source1: Real, source2: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Subtracts one floating-point number from another.

    Args:
        source1: Number to subtract from; DATAF.
        source2: Number to subtract; DATAF.
        destination: SOURCE1 less SOURCE2; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SUBF"].draft((source1, source2, destination), unchecked)


def mul8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Multiplies two 8-bit numbers.

    Args:
        source1: First factor; DATA8.
        source2: Second factor; DATA8.
        destination: Their product; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MUL8"].draft((source1, source2, destination), unchecked)


def mul16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Multiplies two 16-bit numbers.

    Args:
        source1: First factor; DATA16.
        source2: Second factor; DATA16.
        destination: Their product; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MUL16"].draft((source1, source2, destination), unchecked)


def mul32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Multiplies two 32-bit numbers.

    Args:
        source1: First factor; DATA32.
        source2: Second factor; DATA32.
        destination: Their product; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MUL32"].draft((source1, source2, destination), unchecked)


def mulf(source1: Real, source2: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Multiplies two floating-point numbers.

    Args:
        source1: First factor; DATAF.
        source2: Second factor; DATAF.
        destination: Their product; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MULF"].draft((source1, source2, destination), unchecked)


def div8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Divides two 8-bit numbers; by zero gives the largest or smallest value.

    Args:
        source1: Number to divide; DATA8.
        source2: Number to divide by; DATA8.
        destination: Quotient, cut off towards zero (0 for 0 / 0); DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DIV8"].draft((source1, source2, destination), unchecked)


def div16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Divides two 16-bit numbers; by zero gives the largest or smallest value.

    Args:
        source1: Number to divide; DATA16.
        source2: Number to divide by; DATA16.
        destination: Quotient, cut off towards zero (0 for 0 / 0); DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DIV16"].draft((source1, source2, destination), unchecked)


def div32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Divides two 32-bit numbers; by zero gives the largest or smallest value.

    Args:
        source1: Number to divide; DATA32.
        source2: Number to divide by; DATA32.
        destination: Quotient, cut off towards zero (0 for 0 / 0); DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DIV32"].draft((source1, source2, destination), unchecked)


def divf(source1: Real, source2: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Divides two floating-point numbers; by zero gives infinity or NaN.

    Args:
        source1: Number to divide; DATAF.
        source2: Number to divide by; DATAF.
        destination: Quotient; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DIVF"].draft((source1, source2, destination), unchecked)


def or8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 8-bit values, bit by bit, by OR.

    Args:
        source1: First; DATA8.
        source2: Second; DATA8.
        destination: Bits set in either; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OR8"].draft((source1, source2, destination), unchecked)


def or16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 16-bit values, bit by bit, by OR.

    Args:
        source1: First; DATA16.
        source2: Second; DATA16.
        destination: Bits set in either; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OR16"].draft((source1, source2, destination), unchecked)


def or32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 32-bit values, bit by bit, by OR.

    Args:
        source1: First; DATA32.
        source2: Second; DATA32.
        destination: Bits set in either; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OR32"].draft((source1, source2, destination), unchecked)


def and8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 8-bit values, bit by bit, by AND.

    Args:
        source1: First; DATA8.
        source2: Second; DATA8.
        destination: Bits set in both; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["AND8"].draft((source1, source2, destination), unchecked)


def and16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 16-bit values, bit by bit, by AND.

    Args:
        source1: First; DATA16.
        source2: Second; DATA16.
        destination: Bits set in both; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["AND16"].draft((source1, source2, destination), unchecked)


def and32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 32-bit values, bit by bit, by AND.

    Args:
        source1: First; DATA32.
        source2: Second; DATA32.
        destination: Bits set in both; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["AND32"].draft((source1, source2, destination), unchecked)


def xor8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 8-bit values, bit by bit, by exclusive OR.

    Args:
        source1: First; DATA8.
        source2: Second; DATA8.
        destination: Bits set in just one of the two; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["XOR8"].draft((source1, source2, destination), unchecked)


def xor16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 16-bit values, bit by bit, by exclusive OR.

    Args:
        source1: First; DATA16.
        source2: Second; DATA16.
        destination: Bits set in just one of the two; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["XOR16"].draft((source1, source2, destination), unchecked)


def xor32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Combines 32-bit values, bit by bit, by exclusive OR.

    Args:
        source1: First; DATA32.
        source2: Second; DATA32.
        destination: Bits set in just one of the two; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["XOR32"].draft((source1, source2, destination), unchecked)


def rl8(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Shifts 8-bit values left; despite the name (rotate), bits shifted out on the left are lost.

    Args:
        source1: Value to shift; DATA8.
        source2: Number of places; bits; DATA8.
        destination: Shifted value, filled up with zero bits; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["RL8"].draft((source1, source2, destination), unchecked)


def rl16(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Shifts 16-bit values left; despite the name (rotate), bits shifted out on the left are lost.

    Args:
        source1: Value to shift; DATA16.
        source2: Number of places; bits; DATA16.
        destination: Shifted value, filled up with zero bits; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["RL16"].draft((source1, source2, destination), unchecked)


def rl32(source1: Number, source2: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Shifts 32-bit values left; despite the name (rotate), bits shifted out on the left are lost.

    Args:
        source1: Value to shift; DATA32.
        source2: Number of places; bits; DATA32.
        destination: Shifted value, filled up with zero bits; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["RL32"].draft((source1, source2, destination), unchecked)


def random(min: Number, max: Number, value: Output = None, *, unchecked: bool = False) -> Draft:
    """Draws a random whole number.

    Args:
        min: Smallest number to draw; DATA16.
        max: Largest number to draw; DATA16.
        value: The number drawn, MIN to MAX, both included; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["RANDOM"].draft((min, max, value), unchecked)


def memory_write(
    prgid: AnySLOT,
    objid: Number,
    offset: Number,
    size: Number,
    array: Elements,
    *,
    unchecked: bool = False,
) -> Draft:
    """Writes bytes into the variables of a running program.

    Args:
        prgid: Slot of the program, which must be running; 0 to 4; a member of SLOT; DATA16.
        objid: Object whose local memory is meant; 0: the program's global memory; DATA16.
        offset: First byte in that memory; 0 to 2147483647 bytes; DATA32.
        size: Number of bytes; 0 to 2147483647 bytes; DATA32.
        array: The bytes; those beyond the end of the memory are dropped; as many values as SIZE says; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MEMORY_WRITE"].draft((prgid, objid, offset, size, array), unchecked)


def memory_read(
    prgid: AnySLOT,
    objid: Number,
    offset: Number,
    size: Number,
    array: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Reads bytes from the variables of a running program.

    Args:
        prgid: Slot of the program, which must be running; 0 to 4; a member of SLOT; DATA16.
        objid: Object whose local memory is meant; 0: the program's global memory; DATA16.
        offset: First byte in that memory; 0 to 2147483647 bytes; DATA32.
        size: Number of bytes; 0 to 2147483647 bytes; DATA32.
        array: The bytes, zeros beyond the end of the memory; as many values as SIZE says; DATA8; an output, in global
            memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MEMORY_READ"].draft((prgid, objid, offset, size, array), unchecked)


def array_write(handle: Number, index: Number, value: Real, *, unchecked: bool = False) -> Draft:
    """Writes one element of an array, which grows where needed.

    Args:
        handle: The array; handle.
        index: Which element, the first is 0; 0 to 5999999; DATA32.
        value: The value, of the array's type; array-typed.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY_WRITE"].draft((handle, index, value), unchecked)


def array_read(handle: Number, index: Number, value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads one element of an array.

    Args:
        handle: The array; handle.
        index: Which element, the first is 0; 0 to 5999999; DATA32.
        value: The value, of the array's type; array-typed; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY_READ"].draft((handle, index, value), unchecked)


def array_append(handle: Number, value: Real, *, unchecked: bool = False) -> Draft:
    """Adds one element to the end of an array.

    Args:
        handle: The array; handle.
        value: The value, of the array's type; array-typed.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["ARRAY_APPEND"].draft((handle, value), unchecked)


def memory_usage(total: Output = None, free: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports the total and free memory for user files.

    Args:
        total: Total memory; KiB; DATA32; an output, in global memory when omitted.
        free: Free memory; KiB; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MEMORY_USAGE"].draft((total, free), unchecked)


@overload
def init_bytes(
    destination: Output,
    length: Number | None,
    source: Sequence[Number],
    *,
    unchecked: bool = False,
) -> Draft: ...


@overload
def init_bytes(
    *,
    destination: Output = None,
    length: Number | None = None,
    source: Sequence[Number],
    unchecked: bool = False,
) -> Draft: ...


def init_bytes(
    destination: Output = None,
    length: Number | None = None,
    source: Sequence[Number] = REQUIRED,
    *,
    unchecked: bool = False,
) -> Draft:
    """Fills consecutive bytes of memory with constant values.

    Args:
        destination: First byte to fill; as many values as LENGTH says; DATA8; an output, in global memory when omitted.
        length: Number of values that follow; a negative count hangs the brick; bytes; DATA32; computed when omitted.
        source: The values, one per byte; a list of DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["INIT_BYTES"].draft((destination, length, source), unchecked)


def move8_8(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Copies a value to another variable, both 8-bit.

    Args:
        source: Value to copy; DATA8.
        destination: Copy of the value; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE8_8"].draft((source, destination), unchecked)


def move8_16(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 8-bit to 16-bit; NaN stays NaN.

    Args:
        source: Value to copy; DATA8.
        destination: Copy of the value; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE8_16"].draft((source, destination), unchecked)


def move8_32(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 8-bit to 32-bit; NaN stays NaN.

    Args:
        source: Value to copy; DATA8.
        destination: Copy of the value; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE8_32"].draft((source, destination), unchecked)


def move8_f(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 8-bit to floating-point; NaN stays NaN.

    Args:
        source: Value to copy; DATA8.
        destination: Copy of the value; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE8_F"].draft((source, destination), unchecked)


def move16_8(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 16-bit to 8-bit; limited to what fits, NaN stays NaN.

    Args:
        source: Value to copy; DATA16.
        destination: Copy of the value; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE16_8"].draft((source, destination), unchecked)


def move16_16(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Copies a value to another variable, both 16-bit.

    Args:
        source: Value to copy; DATA16.
        destination: Copy of the value; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE16_16"].draft((source, destination), unchecked)


def move16_32(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 16-bit to 32-bit; NaN stays NaN.

    Args:
        source: Value to copy; DATA16.
        destination: Copy of the value; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE16_32"].draft((source, destination), unchecked)


def move16_f(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 16-bit to floating-point; NaN stays NaN.

    Args:
        source: Value to copy; DATA16.
        destination: Copy of the value; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE16_F"].draft((source, destination), unchecked)


def move32_8(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 32-bit to 8-bit; limited to what fits, NaN stays NaN.

    Args:
        source: Value to copy; DATA32.
        destination: Copy of the value; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE32_8"].draft((source, destination), unchecked)


def move32_16(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 32-bit to 16-bit; limited to what fits, NaN stays NaN.

    Args:
        source: Value to copy; DATA32.
        destination: Copy of the value; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE32_16"].draft((source, destination), unchecked)


def move32_32(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Copies a value to another variable, both 32-bit.

    Args:
        source: Value to copy; DATA32.
        destination: Copy of the value; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE32_32"].draft((source, destination), unchecked)


def move32_f(source: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, 32-bit to floating-point; NaN stays NaN.

    Args:
        source: Value to copy; DATA32.
        destination: Copy of the value; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVE32_F"].draft((source, destination), unchecked)


def movef_8(source: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, floating-point to 8-bit; limited to what fits, NaN stays NaN.

    Args:
        source: Value to copy; DATAF.
        destination: Copy of the value; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVEF_8"].draft((source, destination), unchecked)


def movef_16(source: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, floating-point to 16-bit; limited to what fits, NaN stays NaN.

    Args:
        source: Value to copy; DATAF.
        destination: Copy of the value; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVEF_16"].draft((source, destination), unchecked)


def movef_32(source: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts a value, floating-point to 32-bit; limited to what fits, NaN stays NaN.

    Args:
        source: Value to copy; DATAF.
        destination: Copy of the value; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVEF_32"].draft((source, destination), unchecked)


def movef_f(source: Real, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Copies a value to another variable, both floating-point.

    Args:
        source: Value to copy; DATAF.
        destination: Copy of the value; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MOVEF_F"].draft((source, destination), unchecked)


def read8(source: Number, index: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads one element of an array of 8-bit values.

    Args:
        source: First element of the array, as a variable; DATA8.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: The element's value; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["READ8"].draft((source, index, destination), unchecked)


def read16(source: Number, index: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads one element of an array of 16-bit values.

    Args:
        source: First element of the array, as a variable; DATA16.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: The element's value; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["READ16"].draft((source, index, destination), unchecked)


def read32(source: Number, index: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads one element of an array of 32-bit values.

    Args:
        source: First element of the array, as a variable; DATA32.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: The element's value; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["READ32"].draft((source, index, destination), unchecked)


def readf(source: Real, index: Number, destination: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads one element of an array of floating-point values.

    Args:
        source: First element of the array, as a variable; DATAF.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: The element's value; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["READF"].draft((source, index, destination), unchecked)


def write8(source: Number, index: Number, destination: Number, *, unchecked: bool = False) -> Draft:
    """Writes one element of an array of 8-bit values.

    Args:
        source: Value to write; DATA8.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: First element of the array, as a variable; element INDEX is written; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["WRITE8"].draft((source, index, destination), unchecked)


def write16(source: Number, index: Number, destination: Number, *, unchecked: bool = False) -> Draft:
    """Writes one element of an array of 16-bit values.

    Args:
        source: Value to write; DATA16.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: First element of the array, as a variable; element INDEX is written; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["WRITE16"].draft((source, index, destination), unchecked)


def write32(source: Number, index: Number, destination: Number, *, unchecked: bool = False) -> Draft:
    """Writes one element of an array of 32-bit values.

    Args:
        source: Value to write; DATA32.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: First element of the array, as a variable; element INDEX is written; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["WRITE32"].draft((source, index, destination), unchecked)


def writef(source: Real, index: Number, destination: Real, *, unchecked: bool = False) -> Draft:
    """Writes one element of an array of floating-point values.

    Args:
        source: Value to write; DATAF.
        index: Which element, counted from 0; the firmware does not check it; 0 to 127; DATA8.
        destination: First element of the array, as a variable; element INDEX is written; DATAF.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["WRITEF"].draft((source, index, destination), unchecked)


def output_set_type(layer: Number, no: NamedNumber, type: AnyTYPE, *, unchecked: bool = False) -> Draft:
    """Declares which type of motor is at a port.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        no: Port, counted from 0; 0 to 3; 0: A; 1: B; 2: C; 3: D; DATA8.
        type: Type of the motor; a member of TYPE; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_SET_TYPE"].draft((layer, no, type), unchecked)


def output_reset(layer: Number, nos: NamedNumber, *, unchecked: bool = False) -> Draft:
    """Sets the tacho counts that moves and OUTPUT_READ use to zero.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_RESET"].draft((layer, nos), unchecked)


def output_stop(layer: Number, nos: NamedNumber, brake: Number, *, unchecked: bool = False) -> Draft:
    """Stops motors.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        brake: What the motors do at the end; 0 to 1; 0: coast; 1: brake and hold; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_STOP"].draft((layer, nos, brake), unchecked)


def output_power(layer: Number, nos: NamedNumber, power: Number, *, unchecked: bool = False) -> Draft:
    """Sets the power of motors, which run at the next OUTPUT_START.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        power: Unregulated power; negative: backward; -100 to 100 %; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_POWER"].draft((layer, nos, power), unchecked)


def output_speed(layer: Number, nos: NamedNumber, speed: Number, *, unchecked: bool = False) -> Draft:
    """Sets the speed of motors, which run at the next OUTPUT_START.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        speed: Regulated speed; negative: backward; -100 to 100 %; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_SPEED"].draft((layer, nos, speed), unchecked)


def output_start(layer: Number, nos: NamedNumber, *, unchecked: bool = False) -> Draft:
    """Starts motors with the power or speed set before.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_START"].draft((layer, nos), unchecked)


def output_polarity(layer: Number, nos: NamedNumber, pol: Number, *, unchecked: bool = False) -> Draft:
    """Sets the direction of motors.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        pol: Direction; -1 to 1; -1: backward; 0: opposite of the current one; 1: forward; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        speed: Current speed; -100 to 100 %; DATA8; an output, in global memory when omitted.
        tacho: Angle in the current phase of a move; about 0 after one that brakes; degrees; DATA32; an output, in
            global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_READ"].draft((layer, no, speed, tacho), unchecked)


def output_test(layer: Number, nos: NamedNumber, busy: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether one of the motors is still in a move that ends by itself.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        busy: Whether to wait; 0 to 1; 0: ready; 1: busy; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_TEST"].draft((layer, nos, busy), unchecked)


def output_ready(layer: Number, nos: NamedNumber, *, unchecked: bool = False) -> Draft:
    """Waits until the moves of the motors have ended; ignores those from OUTPUT_START.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        power: Unregulated power; negative: backward; -100 to 100 %; DATA8.
        step1: Angle of the ramp up; 0 to 2147483647 degrees; DATA32.
        step2: Angle at constant drive; 0 to 2147483647 degrees; DATA32.
        step3: Angle of the ramp down; 0 to 2147483647 degrees; DATA32.
        brake: What the motors do at the end; 0 to 1; 0: coast; 1: brake and hold; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        power: Unregulated power; negative: backward; -100 to 100 %; DATA8.
        time1: Time of the ramp up; 0 to 2147483647 ms; DATA32.
        time2: Time at constant drive; 0 to 2147483647 ms; DATA32.
        time3: Time of the ramp down; 0 to 2147483647 ms; DATA32.
        brake: What the motors do at the end; 0 to 1; 0: coast; 1: brake and hold; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        speed: Regulated speed; negative: backward; -100 to 100 %; DATA8.
        step1: Angle of the ramp up; 0 to 2147483647 degrees; DATA32.
        step2: Angle at constant drive; 0 to 2147483647 degrees; DATA32.
        step3: Angle of the ramp down; 0 to 2147483647 degrees; DATA32.
        brake: What the motors do at the end; 0 to 1; 0: coast; 1: brake and hold; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        speed: Regulated speed; negative: backward; -100 to 100 %; DATA8.
        time1: Time of the ramp up; 0 to 2147483647 ms; DATA32.
        time2: Time at constant drive; 0 to 2147483647 ms; DATA32.
        time3: Time of the ramp down; 0 to 2147483647 ms; DATA32.
        brake: What the motors do at the end; 0 to 1; 0: coast; 1: brake and hold; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        speed: Regulated speed; negative: backward; -100 to 100 %; DATA8.
        turn: How tight the turn is, positive slows the higher port, negative the lower; -200 to 200; -200: spin, lower
            port runs backward; -100: lower port stands still; 0: straight; 100: higher port stands still; 200: spin,
            higher port runs backward; DATA16.
        step: Angle of the faster motor; 0 to 2147483647 degrees; 0: endless; DATA32.
        brake: What the motors do at the end; 0 to 1; 0: coast; 1: brake and hold; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
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
        speed: Regulated speed; negative: backward; -100 to 100 %; DATA8.
        turn: How tight the turn is, positive slows the higher port, negative the lower; -200 to 200; -200: spin, lower
            port runs backward; -100: lower port stands still; 0: straight; 100: higher port stands still; 200: spin,
            higher port runs backward; DATA16.
        time: How long to run; 0 to 2147483647 ms; 0: endless; DATA32.
        brake: What the motors do at the end; 0 to 1; 0: coast; 1: brake and hold; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_TIME_SYNC"].draft((layer, nos, speed, turn, time, brake), unchecked)


def output_clr_count(layer: Number, nos: NamedNumber, *, unchecked: bool = False) -> Draft:
    """Sets the tacho counts of motors read as sensors to zero.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Ports as a bit mask: A 1, B 2, C 4, D 8; 0 to 15; 0: none; 1: A; 2: B; 3: A+B; 4: C; 5: A+C; 6: B+C; 7:
            A+B+C; 8: D; 9: A+D; 10: B+D; 11: A+B+D; 12: C+D; 13: A+C+D; 14: B+C+D; 15: A+B+C+D; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_CLR_COUNT"].draft((layer, nos), unchecked)


def output_get_count(layer: Number, nos: NamedNumber, tacho: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the tacho count of a motor read as a sensor.

    Args:
        layer: Brick in the daisy chain, 0 is the one addressed; 0 to 3; DATA8.
        nos: Port, counted from 0; 0 to 3; 0: A; 1: B; 2: C; 3: D; DATA8.
        tacho: Angle since OUTPUT_CLR_COUNT; degrees; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OUTPUT_GET_COUNT"].draft((layer, nos, tacho), unchecked)


def output_prg_stop(*, unchecked: bool = False) -> Draft:
    """Stops and resets all motors as the end of a program does."""
    return _OPERATIONS["OUTPUT_PRG_STOP"].draft((), unchecked)


def sound_test(busy: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether a sound is playing.

    Args:
        busy: Whether a sound is playing; 0 to 1; 0: ready; 1: busy; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SOUND_TEST"].draft((busy,), unchecked)


def sound_ready(*, unchecked: bool = False) -> Draft:
    """Waits until the sound has ended (forever after REPEAT, an endless tone or a missing file)."""
    return _OPERATIONS["SOUND_READY"].draft((), unchecked)


def timer_wait(time: Number, timer: Output = None, *, unchecked: bool = False) -> Draft:
    """Stores the end of a wait and returns at once; TIMER_READY does the waiting.

    Args:
        time: Duration of the wait; 0 to 2147483647 ms; DATA32.
        timer: Variable that gets the end of the wait, on the brick's millisecond clock; DATA32; an output, in global
            memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TIMER_WAIT"].draft((time, timer), unchecked)


def timer_ready(timer: Number, *, unchecked: bool = False) -> Draft:
    """Waits until the time that TIMER_WAIT stored.

    Args:
        timer: Variable that TIMER_WAIT has set; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TIMER_READY"].draft((timer,), unchecked)


def timer_read(time: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the time since the start of the program or direct command that asks.

    Args:
        time: Time since the start; ms; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TIMER_READ"].draft((time,), unchecked)


def timer_read_us(time: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the free-running microsecond clock, for differences only.

    Args:
        time: Low 32 bits of the clock, wraps every 71.6 minutes; us; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["TIMER_READ_US"].draft((time,), unchecked)


def ui_flush(*, unchecked: bool = False) -> Draft:
    """Sends the contents of the terminal's output buffer."""
    return _OPERATIONS["UI_FLUSH"].draft((), unchecked)


def keep_alive(minutes: Output = None, *, unchecked: bool = False) -> Draft:
    """Restarts the timer that switches off an idle brick, and reads its time.

    Args:
        minutes: Idle time before switching off; min; 0: never; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["KEEP_ALIVE"].draft((minutes,), unchecked)


def error(*, unchecked: bool = False) -> Draft:
    """Ends the program with a failure; never valid on the wire."""
    return _OPERATIONS["ERROR"].draft((), unchecked)


def nop(*, unchecked: bool = False) -> Draft:
    """Does nothing; a harmless way to test whether the brick answers."""
    return _OPERATIONS["NOP"].draft((), unchecked)


def program_stop(prgid: AnySLOT, *, unchecked: bool = False) -> Draft:
    """Stops the program of a slot.

    Args:
        prgid: Program slot to stop; 0: all programs; -1: the calling program; a member of SLOT; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PROGRAM_STOP"].draft((prgid,), unchecked)


def program_start(prgid: AnySLOT, size: Number, ip: Number, debug: Number, *, unchecked: bool = False) -> Draft:
    """Starts a loaded program; a direct command can do this only while no user program runs.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        size: Size of the image; read and ignored; bytes; DATA32.
        ip: Address of the image, as FILE.LOAD_IMAGE returned it; DATA32.
        debug: How to run it; 0 to 2; 0: run; 1: debug; 2: load, do not run; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PROGRAM_START"].draft((prgid, size, ip, debug), unchecked)


def object_stop(objid: Number, *, unchecked: bool = False) -> Draft:
    """Stops an object of its own program.

    Args:
        objid: Object of the program, counted from 1; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OBJECT_STOP"].draft((objid,), unchecked)


def object_start(objid: Number, *, unchecked: bool = False) -> Draft:
    """Starts an object of its own program.

    Args:
        objid: Object of the program, counted from 1; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OBJECT_START"].draft((objid,), unchecked)


def object_trig(objid: Number, *, unchecked: bool = False) -> Draft:
    """Counts an object's trigger down; at zero the object starts.

    Args:
        objid: Object of the program, counted from 1; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OBJECT_TRIG"].draft((objid,), unchecked)


def object_wait(objid: Number, *, unchecked: bool = False) -> Draft:
    """Waits until an object has ended.

    Args:
        objid: Object of the program, counted from 1; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["OBJECT_WAIT"].draft((objid,), unchecked)


def return_(*, unchecked: bool = False) -> Draft:
    """Returns from a subroutine to its caller."""
    return _OPERATIONS["RETURN"].draft((), unchecked)


def call(objid: Number, parameters: Sequence[Untyped], *, unchecked: bool = False) -> Draft:
    """Calls a subroutine of its own program; waits while another thread runs it.

    Args:
        objid: Object number of the subroutine, counted from 1; DATA16.
        parameters: Number of parameters follow; the subroutine declares their types and directions; a list of DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["CALL"].draft((objid, parameters), unchecked)


def object_end(*, unchecked: bool = False) -> Draft:
    """Ends the object; the firmware appends one to every direct command."""
    return _OPERATIONS["OBJECT_END"].draft((), unchecked)


def sleep(*, unchecked: bool = False) -> Draft:
    """Gives up the rest of the thread's time slice."""
    return _OPERATIONS["SLEEP"].draft((), unchecked)


def label(no: Number, *, unchecked: bool = False) -> Draft:
    """Marks a place that jumps can name; does nothing itself.

    Args:
        no: Number of the label; 0 to 31; label.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["LABEL"].draft((no,), unchecked)


def probe(prgid: AnySLOT, objid: Number, offset: Number, size: Number, *, unchecked: bool = False) -> Draft:
    """Prints a program's memory on the brick's debug terminal.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        objid: Object whose local memory to print; 0: the global memory; DATA16.
        offset: First byte; bytes; DATA32.
        size: Number of bytes to print; 0 to 1024 bytes; 0: all, 1024 at most; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PROBE"].draft((prgid, objid, offset, size), unchecked)


def do(prgid: AnySLOT, image: Number, global_: Number, *, unchecked: bool = False) -> Draft:
    """Runs byte code that is already in memory, ending the slot's previous program.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        image: Address of the byte code image; DATA32.
        global_: Address of the global memory it uses; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DO"].draft((prgid, image, global_), unchecked)


def system(command: Text, status: Output = None, *, unchecked: bool = False) -> Draft:
    """Runs a shell command on the brick's Linux and waits until it ends.

    Args:
        command: The command line; string.
        status: Wait status as C's system() gives it: 256 times the exit code; 0: success; -1: could not run; DATA32; an
            output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SYSTEM"].draft((command, status), unchecked)


def port_cnv_output(
    portin: Number,
    layer: Output = None,
    bitfield: Output = None,
    inverted: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Splits a motor port number as LEGO's editor writes it.

    Args:
        portin: Three decimal digits, each 1-4: layer, first port, second port (123: B and C); DATA32.
        layer: Position in the daisy chain; 0 to 3; 0: this brick; DATA8; an output, in global memory when omitted.
        bitfield: Motor ports as bits: A=1 B=2 C=4 D=8; 0 to 15; DATA8; an output, in global memory when omitted.
        inverted: Whether the first port comes after the second, as in CA; 0 to 1; 0: no; 1: yes; DATA8; an output, in
            global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PORT_CNV_OUTPUT"].draft((portin, layer, bitfield, inverted), unchecked)


def port_cnv_input(portin: Number, layer: Output = None, portout: Output = None, *, unchecked: bool = False) -> Draft:
    """Splits a sensor port number as LEGO's editor writes it.

    Args:
        portin: Three decimal digits: layer 1-4, any, port 1-4 (103: port 3); DATA32.
        layer: Position in the daisy chain; 0 to 3; 0: this brick; DATA8; an output, in global memory when omitted.
        portout: Sensor port minus one, as in INPUT_*; 0 to 3; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PORT_CNV_INPUT"].draft((portin, layer, portout), unchecked)


def note_to_freq(note: Text, freq: Output = None, *, unchecked: bool = False) -> Draft:
    """Converts the name of a note to its frequency.

    Args:
        note: C4 to B6, sharps as C#4; string.
        freq: Frequency; 440 for an unknown note; 262 to 1976 Hz; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["NOTE_TO_FREQ"].draft((note, freq), unchecked)


def bp0(*, unchecked: bool = False) -> Draft:
    """Stops at breakpoint 0; BP_SET puts it over the instruction it replaces."""
    return _OPERATIONS["BP0"].draft((), unchecked)


def bp1(*, unchecked: bool = False) -> Draft:
    """Stops at breakpoint 1; BP_SET puts it over the instruction it replaces."""
    return _OPERATIONS["BP1"].draft((), unchecked)


def bp2(*, unchecked: bool = False) -> Draft:
    """Stops at breakpoint 2; BP_SET puts it over the instruction it replaces."""
    return _OPERATIONS["BP2"].draft((), unchecked)


def bp3(*, unchecked: bool = False) -> Draft:
    """Pulses test pin TP4 and continues; BP_SET puts it over the instruction it replaces."""
    return _OPERATIONS["BP3"].draft((), unchecked)


def bp_set(prgid: AnySLOT, no: Number, address: Number, *, unchecked: bool = False) -> Draft:
    """Sets or removes a breakpoint in a running program.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        no: Number of the breakpoint; 0 to 2; 3: pulse on test pin TP4, no stop; DATA8.
        address: Offset in the image; bytes; 0: remove the breakpoint; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["BP_SET"].draft((prgid, no, address), unchecked)
