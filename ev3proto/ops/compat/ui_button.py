"""UI_BUTTON: reads or simulates the buttons.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnyBUTTONTYPE, Output
from ev3proto.ops.ui_button import (
    flush,
    get_back_block,
    get_click,
    get_horz,
    get_vert,
    longpress,
    press,
    pressed,
    release,
    set_back_block,
    shortpress,
    testlongpress,
    testshortpress,
    wait_for_press,
)
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "flush",
    "get_back_block",
    "get_bumped",
    "get_click",
    "get_horz",
    "get_vert",
    "longpress",
    "press",
    "pressed",
    "release",
    "set_back_block",
    "shortpress",
    "testlongpress",
    "testshortpress",
    "wait_for_press",
]

_OPERATIONS = drafts("compat")


def get_bumped(button: AnyBUTTONTYPE, state: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether a button was pressed and released since the last query, and clears it.

    Args:
        button: Which button; a member of BUTTONTYPE; DATA8.
        state: Whether the button was pressed and released; 0 to 1; 0: no; 1: yes; DATA8; an output, in global memory
            when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_BUTTON.GET_BUMPED"].draft((button, state), unchecked)
