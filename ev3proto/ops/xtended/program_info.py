"""PROGRAM_INFO: asks about a program or controls its objects.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnySLOT, Output
from ev3proto.ops.program_info import get_prgresult, get_speed, get_status, obj_start, obj_stop, set_instr
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = ["get_prgname", "get_prgresult", "get_speed", "get_status", "obj_start", "obj_stop", "set_instr"]

_OPERATIONS = drafts("xtended")


def get_prgname(prgid: AnySLOT, name: Output = None, *, unchecked: bool = False) -> Draft:
    """Asks for the name of a program.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        name: Name of the program, zero-terminated; string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PROGRAM_INFO.GET_PRGNAME"].draft((prgid, name), unchecked)
