"""COM_READ: fetches direct commands, for the brick's own command program.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Number, Output
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = ["command"]

_OPERATIONS = drafts("official")


def command(
    length: Number,
    image: Output = None,
    global_: Output = None,
    flag: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Returns the address of the last direct command received.

    Args:
        length: Maximum number of bytes of code, ignored by the firmware; bytes; DATA32.
        image: Address of the code; DATA32; an output, in global memory when omitted.
        global_: Address of its global memory; DATA32; an output, in global memory when omitted.
        flag: Whether one is waiting; 0 to 1; 0: none; 1: ready to run; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_READ.COMMAND"].draft((length, image, global_, flag), unchecked)
