"""PROGRAM_INFO: asks about a program or controls its objects.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnySLOT, Number, Output
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = ["get_prgresult", "get_speed", "get_status", "obj_start", "obj_stop", "set_instr"]

_OPERATIONS = drafts("official")


def obj_stop(prgid: AnySLOT, objid: Number, *, unchecked: bool = False) -> Draft:
    """Stops an object of a running program.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        objid: Object of the program, counted from 1; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PROGRAM_INFO.OBJ_STOP"].draft((prgid, objid), unchecked)


def obj_start(prgid: AnySLOT, objid: Number, *, unchecked: bool = False) -> Draft:
    """Starts an object of a running program from its beginning.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        objid: Object of the program, counted from 1; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PROGRAM_INFO.OBJ_START"].draft((prgid, objid), unchecked)


def get_status(prgid: AnySLOT, data: Output = None, *, unchecked: bool = False) -> Draft:
    """Asks whether a program runs.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        data: State of the program; a member of OBJSTAT; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PROGRAM_INFO.GET_STATUS"].draft((prgid, data), unchecked)


def get_speed(prgid: AnySLOT, data: Output = None, *, unchecked: bool = False) -> Draft:
    """Asks for a program's speed.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        data: Speed since the program started; instructions/s; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PROGRAM_INFO.GET_SPEED"].draft((prgid, data), unchecked)


def get_prgresult(prgid: AnySLOT, data: Output = None, *, unchecked: bool = False) -> Draft:
    """Asks how a program ended.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        data: OK, BUSY (still running) or FAIL; a member of RESULT; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PROGRAM_INFO.GET_PRGRESULT"].draft((prgid, data), unchecked)


def set_instr(prgid: AnySLOT, *, unchecked: bool = False) -> Draft:
    """Sets how many instructions the calling thread may still run in its time slice.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PROGRAM_INFO.SET_INSTR"].draft((prgid,), unchecked)
