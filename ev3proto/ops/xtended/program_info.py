"""PROGRAM_INFO: asks about a program or controls its objects.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ev3proto.calls import explained
from ev3proto.compose.drafts import Draft
from ev3proto.compose.functions import drafts
from ev3proto.late import listed
from ev3proto.ops.program_info import get_prgresult, get_speed, get_status, obj_start, obj_stop, set_instr

if TYPE_CHECKING:
    from ev3proto.ops.argument_types import AnySLOT, Output

__all__ = ["get_prgname", "get_prgresult", "get_speed", "get_status", "obj_start", "obj_stop", "set_instr"]

if not TYPE_CHECKING:
    __getattr__, __dir__ = listed(__all__, "the xtended firmware has no operation program_info.")

_OPERATIONS = drafts("xtended")


@explained
def get_prgname(prgid: AnySLOT, name: Output = None, *, unchecked: bool = False) -> Draft:
    """Asks for the name of a program.

    Args:
        prgid: Program slot; a member of SLOT; DATA16.
        name: Name of the program, ended by its zero; string; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["PROGRAM_INFO.GET_PRGNAME"].draft((prgid, name), unchecked)
