"""Opcodes without a CMD in the firmware's area `sound`; `ops` has each under its name.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Output
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = ["sound_ready", "sound_test"]

_OPERATIONS = drafts("official")


def sound_test(busy: Output = None, *, unchecked: bool = False) -> Draft:
    """Tells whether a sound is playing.

    Args:
        busy: Whether a sound is playing; 0 to 1; 0: ready; 1: busy; DATA8; an output, in global memory when omitted.
        unchecked: Let values through that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SOUND_TEST"].draft((busy,), unchecked)


def sound_ready(*, unchecked: bool = False) -> Draft:
    """Waits until the sound has ended (for ever after REPEAT or a tone without end)."""
    return _OPERATIONS["SOUND_READY"].draft((), unchecked)
