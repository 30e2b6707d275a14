"""COM_WRITE: answers direct commands, for the brick's own command program.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ev3proto.calls import explained
from ev3proto.compose.drafts import Draft
from ev3proto.compose.functions import drafts
from ev3proto.late import listed

if TYPE_CHECKING:
    from ev3proto.ops.argument_types import AnyRESULT, Number

__all__ = ["reply"]

if not TYPE_CHECKING:
    __getattr__, __dir__ = listed(__all__, "the official firmware has no operation com_write.")

_OPERATIONS = drafts("official")


@explained
def reply(image: Number, global_: Number, status: AnyRESULT, *, unchecked: bool = False) -> Draft:
    """Sends the global memory of a direct command that has run as its reply.

    Args:
        image: Address of the code; DATA32.
        global_: Address of its global memory; DATA32.
        status: How it ended, all but OK give DIRECT_REPLY_ERROR; a member of RESULT; DATA8.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_WRITE.REPLY"].draft((image, global_, status), unchecked)
