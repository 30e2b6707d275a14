"""UI_BUTTON: reads or simulates the buttons.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnyBUTTONTYPE, Number, Output
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "flush",
    "get_back_block",
    "get_bumbed",
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

_OPERATIONS = drafts("official")


def shortpress(button: AnyBUTTONTYPE, state: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether a button was pressed since the last query, and clears the press.

    Args:
        button: Which button; a member of BUTTONTYPE; DATA8.
        state: Whether the button was pressed; 0 to 1; 0: no; 1: yes; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_BUTTON.SHORTPRESS"].draft((button, state), unchecked)


def longpress(button: AnyBUTTONTYPE, state: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether a button was held for 3 s since the last query, and clears it.

    Args:
        button: Which button; a member of BUTTONTYPE; DATA8.
        state: Whether the button was held for 3 s; 0 to 1; 0: no; 1: yes; DATA8; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_BUTTON.LONGPRESS"].draft((button, state), unchecked)


def wait_for_press(*, unchecked: bool = False) -> Draft:
    """Waits until any button has been pressed, by hand or by PRESS."""
    return _OPERATIONS["UI_BUTTON.WAIT_FOR_PRESS"].draft((), unchecked)


def flush(*, unchecked: bool = False) -> Draft:
    """Clears all pending presses."""
    return _OPERATIONS["UI_BUTTON.FLUSH"].draft((), unchecked)


def press(button: AnyBUTTONTYPE, *, unchecked: bool = False) -> Draft:
    """Presses a button as if by hand and holds it until RELEASE.

    Args:
        button: Which button; a member of BUTTONTYPE; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_BUTTON.PRESS"].draft((button,), unchecked)


def release(button: AnyBUTTONTYPE, *, unchecked: bool = False) -> Draft:
    """Releases a button that PRESS holds.

    Args:
        button: Which button; a member of BUTTONTYPE; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_BUTTON.RELEASE"].draft((button,), unchecked)


def get_horz(value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the left and right buttons as one axis, and clears their presses.

    Args:
        value: Direction; -1 to 1; -1: left; 1: right; 0: not pressed; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_BUTTON.GET_HORZ"].draft((value,), unchecked)


def get_vert(value: Output = None, *, unchecked: bool = False) -> Draft:
    """Reads the up and down buttons as one axis, and clears their presses.

    Args:
        value: Direction; -1 to 1; -1: up; 1: down; 0: not pressed; DATA16; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_BUTTON.GET_VERT"].draft((value,), unchecked)


def pressed(button: AnyBUTTONTYPE, state: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether a button is down at the moment.

    Args:
        button: Which button; a member of BUTTONTYPE; DATA8.
        state: Whether the button is down; 0 to 1; 0: no; 1: yes; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_BUTTON.PRESSED"].draft((button, state), unchecked)


def set_back_block(blocked: Number, *, unchecked: bool = False) -> Draft:
    """Blocks or unblocks the back button, which ends the running program.

    Args:
        blocked: Whether the back button is blocked; 0 to 1; 0: not blocked; 1: blocked; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_BUTTON.SET_BACK_BLOCK"].draft((blocked,), unchecked)


def get_back_block(blocked: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether the back button is blocked.

    Args:
        blocked: Whether the back button is blocked; 0 to 1; 0: not blocked; 1: blocked; DATA8; an output, in global
            memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_BUTTON.GET_BACK_BLOCK"].draft((blocked,), unchecked)


def testshortpress(button: AnyBUTTONTYPE, state: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports, like SHORTPRESS, whether a button was pressed, without clearing the press.

    Args:
        button: Which button; a member of BUTTONTYPE; DATA8.
        state: Whether the button was pressed; 0 to 1; 0: no; 1: yes; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_BUTTON.TESTSHORTPRESS"].draft((button, state), unchecked)


def testlongpress(button: AnyBUTTONTYPE, state: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports, like LONGPRESS, whether a button was held for 3 s, without clearing it.

    Args:
        button: Which button; a member of BUTTONTYPE; DATA8.
        state: Whether the button was held for 3 s; 0 to 1; 0: no; 1: yes; DATA8; an output, in global memory when
            omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_BUTTON.TESTLONGPRESS"].draft((button, state), unchecked)


def get_bumbed(button: AnyBUTTONTYPE, state: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether a button was pressed and released since the last query, and clears it.

    Args:
        button: Which button; a member of BUTTONTYPE; DATA8.
        state: Whether the button was pressed and released; 0 to 1; 0: no; 1: yes; DATA8; an output, in global memory
            when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_BUTTON.GET_BUMBED"].draft((button, state), unchecked)


def get_click(click: Output = None, *, unchecked: bool = False) -> Draft:
    """Reports whether a key click is due for a handled press, and clears it.

    Args:
        click: Whether a click is due; 0 to 1; 0: no; 1: yes; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_BUTTON.GET_CLICK"].draft((click,), unchecked)
