"""Opcodes without a CMD in the firmware's area `vm`; `ops.xtended` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Number, Output
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
]

_OPERATIONS = drafts("xtended")


def dynload_vmload(vmindex: Number, result: Output = None, *, unchecked: bool = False) -> Draft:
    """Loads an additional virtual machine; fails while another one is loaded.

    Args:
        vmindex: Which one; 0 to 1; 0: RobotC; 1: LabVIEW; DATA8.
        result: OK or FAIL; a member of RESULT; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
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
        cmd: Function to call, as that machine numbers them; DATA8.
        length_in: How much data is handed over; DATA8.
        length_out: How many elements came back; DATA16; an output, in global memory when omitted.
        value: What came back; the type depends on CMD; as many values as LENGTH_OUT says; array-typed; an output, in
            global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
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
        cmd: Function to call, as that machine numbers them; DATA8.
        length_in: How much data is handed over; DATA8.
        length_out: How many elements came back; DATA16; an output, in global memory when omitted.
        value: What came back; the type depends on CMD; as many values as LENGTH_OUT says; array-typed; an output, in
            global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
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
        cmd: Function to call, as that machine numbers them; DATA8.
        length_in: How much data is handed over; DATA8.
        length_out: How many elements came back; DATA16; an output, in global memory when omitted.
        value: What came back; the type depends on CMD; as many values as LENGTH_OUT says; array-typed; an output, in
            global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
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
        cmd: Function to call, as that machine numbers them; DATA8.
        length_in: How much data is handed over; DATA8.
        length_out: How many elements came back; DATA16; an output, in global memory when omitted.
        value: What came back; the type depends on CMD; as many values as LENGTH_OUT says; array-typed; an output, in
            global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
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
        cmd: Function to call, as that machine numbers them; DATA8.
        length_in: How much data is handed over; DATA8.
        length_out: How many elements came back; DATA16; an output, in global memory when omitted.
        value: What came back; the type depends on CMD; as many values as LENGTH_OUT says; array-typed; an output, in
            global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
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
        cmd: Function to call, as that machine numbers them; DATA8.
        length_in: How much data is handed over; DATA8.
        length_out: How many elements came back; DATA16; an output, in global memory when omitted.
        value: What came back; the type depends on CMD; as many values as LENGTH_OUT says; array-typed; an output, in
            global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
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
        cmd: Function to call, as that machine numbers them; DATA8.
        length_in: How much data is handed over; DATA8.
        length_out: How many elements came back; DATA16; an output, in global memory when omitted.
        value: What came back; the type depends on CMD; as many values as LENGTH_OUT says; array-typed; an output, in
            global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
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
        cmd: Function to call, as that machine numbers them; DATA8.
        length_in: How much data is handed over; DATA8.
        length_out: How many elements came back; DATA16; an output, in global memory when omitted.
        value: What came back; the type depends on CMD; as many values as LENGTH_OUT says; array-typed; an output, in
            global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
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
        cmd: Function to call, as that machine numbers them; DATA8.
        length_in: How much data is handed over; DATA8.
        length_out: How many elements came back; DATA16; an output, in global memory when omitted.
        value: What came back; the type depends on CMD; as many values as LENGTH_OUT says; array-typed; an output, in
            global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
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
        cmd: Function to call, as that machine numbers them; DATA8.
        length_in: How much data is handed over; DATA8.
        length_out: How many elements came back; DATA16; an output, in global memory when omitted.
        value: What came back; the type depends on CMD; as many values as LENGTH_OUT says; array-typed; an output, in
            global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DYNLOAD_ENTRY_9"].draft((cmd, length_in, length_out, value), unchecked)


def dynload_get_vm(result: Output = None, *, unchecked: bool = False) -> Draft:
    """Asks which additional virtual machine is loaded.

    Args:
        result: Which one; 0 to 1; -1: none; 0: RobotC; 1: LabVIEW; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["DYNLOAD_GET_VM"].draft((result,), unchecked)
