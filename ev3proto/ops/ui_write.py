"""UI_WRITE: writes to the terminal or sets lights and states of the brick.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import AnyDEL, AnyLEDPATTERN, AnyVariable, Number, Output, Real, Text
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "address",
    "allow_pulse",
    "code",
    "download_end",
    "floatvalue",
    "graph_sample",
    "init_run",
    "led",
    "power",
    "put_string",
    "screen_block",
    "set_busy",
    "set_pulse",
    "set_testpin",
    "stamp",
    "terminal",
    "textbox_append",
    "update_run",
    "value8",
    "value16",
    "value32",
    "valuef",
    "write_flush",
]

_OPERATIONS = drafts("official")


def write_flush(*, unchecked: bool = False) -> Draft:
    """Sends the contents of the terminal's output buffer, like UI_FLUSH."""
    return _OPERATIONS["UI_WRITE.WRITE_FLUSH"].draft((), unchecked)


def floatvalue(value: Real, figures: Number, decimals: Number, *, unchecked: bool = False) -> Draft:
    """Writes a number in a fixed format to the terminal.

    Args:
        value: Number to write; DATAF.
        figures: Total number of characters, including the decimal point; negative aligns left; DATA8.
        decimals: Digits after the decimal point; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.FLOATVALUE"].draft((value, figures, decimals), unchecked)


def stamp(value: Text, *, unchecked: bool = False) -> Draft:
    """Writes time, program, object, position and a comment to the terminal.

    Args:
        value: Remark; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.STAMP"].draft((value,), unchecked)


def put_string(string: Text, *, unchecked: bool = False) -> Draft:
    """Writes text to the terminal.

    Args:
        string: Text to write; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.PUT_STRING"].draft((string,), unchecked)


def value8(value: Number, *, unchecked: bool = False) -> Draft:
    """Writes a whole number to the terminal.

    Args:
        value: Number to write; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.VALUE8"].draft((value,), unchecked)


def value16(value: Number, *, unchecked: bool = False) -> Draft:
    """Writes an unsigned whole number to the terminal.

    Args:
        value: Number to write; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.VALUE16"].draft((value,), unchecked)


def value32(value: Number, *, unchecked: bool = False) -> Draft:
    """Writes a whole number to the terminal.

    Args:
        value: Number to write; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.VALUE32"].draft((value,), unchecked)


def valuef(value: Real, *, unchecked: bool = False) -> Draft:
    """Writes a number to the terminal.

    Args:
        value: Number to write; DATAF.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.VALUEF"].draft((value,), unchecked)


def address(value: Output = None, *, unchecked: bool = False) -> Draft:
    """Not implemented in the firmware: the program that runs it fails.

    Args:
        value: Address; never written; DATA32; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.ADDRESS"].draft((value,), unchecked)


def code(array: Number, length: Number, *, unchecked: bool = False) -> Draft:
    """Writes bytes of memory as hex to the terminal.

    Args:
        array: Address of the bytes; DATA32.
        length: Number of bytes; bytes; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.CODE"].draft((array, length), unchecked)


def download_end(*, unchecked: bool = False) -> Draft:
    """Plays the sound of a finished download and refreshes the file browser."""
    return _OPERATIONS["UI_WRITE.DOWNLOAD_END"].draft((), unchecked)


def screen_block(status: Number, *, unchecked: bool = False) -> Draft:
    """Blocks or unblocks the display and the buttons for programs.

    Args:
        status: Whether drawing is ignored; 0 to 1; 0: normal; 1: blocked; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.SCREEN_BLOCK"].draft((status,), unchecked)


def allow_pulse(value: Number, *, unchecked: bool = False) -> Draft:
    """Selects the debug pulses that are shown (only in debug builds of the firmware).

    Args:
        value: Sum of bits; 1: menu background; 2: browser; 4: key; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.ALLOW_PULSE"].draft((value,), unchecked)


def set_pulse(value: Number, *, unchecked: bool = False) -> Draft:
    """Raises debug pulses (only in debug builds of the firmware).

    Args:
        value: Sum of bits; 1: menu background; 2: browser; 4: key; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.SET_PULSE"].draft((value,), unchecked)


def textbox_append(text: AnyVariable, size: Number, del_: AnyDEL, source: Text, *, unchecked: bool = False) -> Draft:
    """Appends a line to the text of a text box.

    Args:
        text: Whole text of the box, its lines separated by DEL; as many bytes as SIZE says; string, a variable that is
            read and written.
        size: Size of the box's text buffer, including the zero; bytes; DATA32.
        del_: What separates the lines; a member of DEL; DATA8.
        source: Line to append; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.TEXTBOX_APPEND"].draft((text, size, del_, source), unchecked)


def set_busy(value: Number, *, unchecked: bool = False) -> Draft:
    """Sets or clears the busy bit among the warnings.

    Args:
        value: Whether the brick counts as busy; 0 to 1; 0: no; 1: yes; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.SET_BUSY"].draft((value,), unchecked)


def set_testpin(state: Number, *, unchecked: bool = False) -> Draft:
    """Sets the test pin on the brick's circuit board.

    Args:
        state: Level of the pin; 0 to 1; 0: low; 1: high; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.SET_TESTPIN"].draft((state,), unchecked)


def init_run(*, unchecked: bool = False) -> Draft:
    """Shows the animation of a running program until something draws."""
    return _OPERATIONS["UI_WRITE.INIT_RUN"].draft((), unchecked)


def update_run(*, unchecked: bool = False) -> Draft:
    """Does nothing."""
    return _OPERATIONS["UI_WRITE.UPDATE_RUN"].draft((), unchecked)


def led(pattern: AnyLEDPATTERN, *, unchecked: bool = False) -> Draft:
    """Sets colour and blinking of the light around the buttons.

    Args:
        pattern: Colour and rhythm; a member of LEDPATTERN; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.LED"].draft((pattern,), unchecked)


def power(value: Number, *, unchecked: bool = False) -> Draft:
    """Sets the flag that makes the power driver switch off when the firmware ends.

    Args:
        value: The flag; 0 to 1; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.POWER"].draft((value,), unchecked)


def graph_sample(*, unchecked: bool = False) -> Draft:
    """Adds the current values to the graph of GRAPH_SETUP."""
    return _OPERATIONS["UI_WRITE.GRAPH_SAMPLE"].draft((), unchecked)


def terminal(state: Number, *, unchecked: bool = False) -> Draft:
    """Switches the debug terminal on or off.

    Args:
        state: Whether the terminal is on; 0 to 1; 0: off; 1: on; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_WRITE.TERMINAL"].draft((state,), unchecked)
