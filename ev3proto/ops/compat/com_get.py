"""COM_GET: asks about the brick's connections and the devices around it.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnyHWTYPE, Output
from ev3proto.ops.com_get import (
    connec_item,
    connec_items,
    favour_item,
    favour_items,
    get_brickname,
    get_encrypt,
    get_id,
    get_incoming,
    get_mode2,
    get_network,
    get_on_off,
    get_pin,
    get_present,
    get_result,
    get_visible,
    search_item,
    search_items,
)
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "connec_item",
    "connec_items",
    "favour_item",
    "favour_items",
    "get_brickname",
    "get_encrypt",
    "get_id",
    "get_incoming",
    "get_mode2",
    "get_network",
    "get_on_off",
    "get_pin",
    "get_present",
    "get_result",
    "get_visible",
    "list_state",
    "search_item",
    "search_items",
]

_OPERATIONS = drafts("compat")


def list_state(hardware: AnyHWTYPE, state: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads a counter that changes when a device enters or leaves a list.

    Args:
        hardware: Carrier to use; a member of HWTYPE; DATA8.
        state: Number to compare with the one of the last call; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["COM_GET.LIST_STATE"].draft((hardware, state), unchecked)
