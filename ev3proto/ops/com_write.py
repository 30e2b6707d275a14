"""COM_WRITE: answers direct commands, for the brick's own command program.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnyRESULT, Number
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = ["reply"]

_OPERATIONS = drafts("official")


def reply(image: Number, global_: Number, status: AnyRESULT, *, unchecked: bool = False) -> Draft:
    """Sends the global memory of a direct command that has run as its reply.

    Args:
        image: Address of the code; DATA32.
        global_: Address of its global memory; DATA32.
        status: How it ended; all but OK give DIRECT_REPLY_ERROR; a member of RESULT; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_WRITE.REPLY"].draft((image, global_, status), unchecked)
