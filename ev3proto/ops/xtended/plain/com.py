"""Opcodes without a CMD in the firmware's area `com`; `ops.xtended` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Number, Output
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = ["mailbox_size"]

_OPERATIONS = drafts("xtended")


def mailbox_size(no: Number, size: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells how many bytes the content of a mailbox has.

    Args:
        no: Number of the mailbox on this brick; 0 to 29; DATA8.
        size: Size of the content; bytes; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["MAILBOX_SIZE"].draft((no, size), unchecked)
