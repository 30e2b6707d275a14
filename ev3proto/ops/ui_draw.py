"""UI_DRAW: draws on the canvas of the display, or runs a dialogue on it.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import (
    AnyBROWSERTYPE,
    AnyDEL,
    AnyFONTTYPE,
    AnyICONTYPE,
    AnyL_ICON_NO,
    AnyN_ICON_NO,
    AnyVariable,
    Elements,
    NamedNumber,
    Number,
    Output,
    Real,
    Text,
)
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = [
    "bmpfile",
    "browse",
    "circle",
    "clean",
    "dotline",
    "fillcircle",
    "fillrect",
    "fillwindow",
    "graph_draw",
    "graph_setup",
    "icon",
    "icon_question",
    "inverserect",
    "keyboard",
    "line",
    "notification",
    "picture",
    "pixel",
    "popup",
    "question",
    "rect",
    "restore",
    "scroll",
    "select_font",
    "store",
    "text",
    "textbox",
    "topline",
    "update",
    "value",
    "vertbar",
    "view_unit",
    "view_value",
]

_OPERATIONS = drafts("official")


def update(*, unchecked: bool = False) -> Draft:
    """Shows on the display what has been drawn, and restores the normal font."""
    return _OPERATIONS["UI_DRAW.UPDATE"].draft((), unchecked)


def clean(*, unchecked: bool = False) -> Draft:
    """Clears the canvas to white, and restores the normal font."""
    return _OPERATIONS["UI_DRAW.CLEAN"].draft((), unchecked)


def pixel(color: NamedNumber, x0: Number, y0: Number, *, unchecked: bool = False) -> Draft:
    """Draws one pixel.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Column; 0 to 177 px; DATA16.
        y0: Row; 0 to 127 px; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.PIXEL"].draft((color, x0, y0), unchecked)


def line(color: NamedNumber, x0: Number, y0: Number, x1: Number, y1: Number, *, unchecked: bool = False) -> Draft:
    """Draws a line between two points.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Column of the start; 0 to 177 px; DATA16.
        y0: Row of the start; 0 to 127 px; DATA16.
        x1: Column of the end; 0 to 178 px; DATA16.
        y1: Row of the end; 0 to 128 px; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.LINE"].draft((color, x0, y0, x1, y1), unchecked)


def circle(color: NamedNumber, x0: Number, y0: Number, r: Number, *, unchecked: bool = False) -> Draft:
    """Draws a circle.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Column of the centre; 0 to 177 px; DATA16.
        y0: Row of the centre; 0 to 127 px; DATA16.
        r: Radius; px; 0: draws nothing; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.CIRCLE"].draft((color, x0, y0, r), unchecked)


def text(color: NamedNumber, x0: Number, y0: Number, string: Text, *, unchecked: bool = False) -> Draft:
    """Draws text in the font chosen by SELECT_FONT.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        string: Text to draw; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.TEXT"].draft((color, x0, y0, string), unchecked)


def icon(
    color: NamedNumber,
    x0: Number,
    y0: Number,
    type: AnyICONTYPE,
    no: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Draws one of the built-in icons.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        type: Set of icons; a member of ICONTYPE; DATA8.
        no: Number of the icon in its set; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.ICON"].draft((color, x0, y0, type, no), unchecked)


def picture(color: NamedNumber, x0: Number, y0: Number, ip: Number, *, unchecked: bool = False) -> Draft:
    """Draws a picture from memory.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        ip: Address of the picture; 0: draws nothing; DATA32.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.PICTURE"].draft((color, x0, y0, ip), unchecked)


def value(
    color: NamedNumber,
    x0: Number,
    y0: Number,
    value: Real,
    figures: Number,
    decimals: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Draws a number, or dashes where it is not a number.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        value: Number to draw; DATAF.
        figures: Total number of characters, including the decimal point; negative aligns left; DATA8.
        decimals: Digits after the decimal point; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.VALUE"].draft((color, x0, y0, value, figures, decimals), unchecked)


def fillrect(color: NamedNumber, x0: Number, y0: Number, x1: Number, y1: Number, *, unchecked: bool = False) -> Draft:
    """Draws a filled rectangle.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        x1: Width; 0 to 178 px; DATA16.
        y1: Height; 0 to 128 px; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.FILLRECT"].draft((color, x0, y0, x1, y1), unchecked)


def rect(color: NamedNumber, x0: Number, y0: Number, x1: Number, y1: Number, *, unchecked: bool = False) -> Draft:
    """Draws the outline of a rectangle.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        x1: Width; 0 to 178 px; DATA16.
        y1: Height; 0 to 128 px; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.RECT"].draft((color, x0, y0, x1, y1), unchecked)


def notification(
    color: NamedNumber,
    x0: Number,
    y0: Number,
    icon1: AnyL_ICON_NO,
    icon2: AnyL_ICON_NO,
    icon3: AnyL_ICON_NO,
    string: Text,
    state: AnyVariable,
    *,
    unchecked: bool = False,
) -> Draft:
    """Shows icons and text in a window and waits for the centre button.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        icon1: First large icon; -1: none; a member of L_ICON_NO; DATA8.
        icon2: Second large icon; -1: none; a member of L_ICON_NO; DATA8.
        icon3: Third large icon; -1: none; a member of L_ICON_NO; DATA8.
        string: Text beside the icons; may be empty; string.
        state: Variable for the dialogue's progress; must be 0 at first; 0 to 1; 0: start, or done; 1: being shown;
            DATA8, a variable that is read and written.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.NOTIFICATION"].draft((color, x0, y0, icon1, icon2, icon3, string, state), unchecked)


def question(
    color: NamedNumber,
    x0: Number,
    y0: Number,
    icon1: AnyL_ICON_NO,
    icon2: AnyL_ICON_NO,
    string: Text,
    state: AnyVariable,
    ok: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Shows icons in a window and waits for yes or no.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        icon1: First large icon; -1: none; a member of L_ICON_NO; DATA8.
        icon2: Second large icon; -1: none; a member of L_ICON_NO; DATA8.
        string: Text of the question (LEGO's firmware does not show it); string.
        state: Variable for the dialogue's progress; must be 0 at first; 0 to 1; 0: start, or done; 1: being shown;
            DATA8, a variable that is read and written.
        ok: Answer; the variable's previous value is selected at first; -1 to 1; 0: no; 1: yes; -1: closed with the back
            button; DATA8; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.QUESTION"].draft((color, x0, y0, icon1, icon2, string, state, ok), unchecked)


def keyboard(
    color: NamedNumber,
    x0: Number,
    y0: Number,
    icon: AnyN_ICON_NO,
    length: Number,
    default: Text,
    charset: AnyVariable,
    string: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Shows a keyboard on the display and waits until a text has been entered.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        icon: Normal icon before the caption; a member of N_ICON_NO; DATA8.
        length: Maximum number of bytes to return, including the zero; 0 to 127 bytes; DATA8.
        default: Caption above the text, not a preset as its name says; 0: none; string.
        charset: Variable with the sum of the allowed kinds of text; becomes 0 once the keyboard is shown; 0: being
            shown; 1: brick name; 2: file name; 4: Bluetooth PIN; 8: WiFi password; 16: WiFi name; DATA8, a variable
            that is read and written.
        string: Entered text; the variable's previous text is edited, the back button empties it; as many bytes as
            LENGTH says; string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.KEYBOARD"].draft((color, x0, y0, icon, length, default, charset, string), unchecked)


def browse(
    type: AnyBROWSERTYPE,
    x0: Number,
    y0: Number,
    x1: Number,
    y1: Number,
    length: Number,
    item_type: Output = None,
    string: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Shows files and folders and waits until one is chosen.

    Args:
        type: What to list; a member of BROWSERTYPE; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        x1: Width; 0 to 178 px; DATA16.
        y1: Height; 0 to 128 px; DATA16.
        length: Maximum number of bytes to return, including the zero; 0 to 127 bytes; DATA8.
        item_type: Kind of the chosen entry; the variable must be 0 at first; a member of FILETYPE; DATA8; an output, in
            global memory when omitted.
        string: Path of the chosen entry; set the variable to the top folder first; as many bytes as LENGTH says;
            string; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.BROWSE"].draft((type, x0, y0, x1, y1, length, item_type, string), unchecked)


def vertbar(
    color: NamedNumber,
    x0: Number,
    y0: Number,
    x1: Number,
    y1: Number,
    min: Number,
    max: Number,
    act: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Draws a vertical scroll bar.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        x1: Width; 0 to 178 px; DATA16.
        y1: Height; 0 to 128 px; DATA16.
        min: Value at one end of the bar; DATA16.
        max: Value at the other end of the bar; DATA16.
        act: Value that the knob shows; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.VERTBAR"].draft((color, x0, y0, x1, y1, min, max, act), unchecked)


def inverserect(x0: Number, y0: Number, x1: Number, y1: Number, *, unchecked: bool = False) -> Draft:
    """Swaps black and white in a rectangle.

    Args:
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        x1: Width; 0 to 178 px; DATA16.
        y1: Height; 0 to 128 px; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.INVERSERECT"].draft((x0, y0, x1, y1), unchecked)


def select_font(type: AnyFONTTYPE, *, unchecked: bool = False) -> Draft:
    """Chooses the font for text, until UPDATE, CLEAN or FILLWINDOW.

    Args:
        type: Font; 0 to 3; a member of FONTTYPE; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.SELECT_FONT"].draft((type,), unchecked)


def topline(enable: Number, *, unchecked: bool = False) -> Draft:
    """Switches the status line at the top on or off.

    Args:
        enable: Whether the status line is shown; 0 to 1; 0: disabled; 1: enabled; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.TOPLINE"].draft((enable,), unchecked)


def fillwindow(color: NamedNumber, y0: Number, y1: Number, *, unchecked: bool = False) -> Draft:
    """Fills rows over the whole width, and restores the normal font.

    Args:
        color: Colour to fill with; any other value makes a test pattern; 0: white; 1: black; DATA8.
        y0: Top edge; 0 to 127 px; DATA16.
        y1: Height; nothing is filled if Y0 plus it is 128 or more; 0 to 127 px; 0: down to the bottom; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.FILLWINDOW"].draft((color, y0, y1), unchecked)


def scroll(y: Number, *, unchecked: bool = False) -> Draft:
    """Moves the canvas up.

    Args:
        y: Distance; 1 to 127 px; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.SCROLL"].draft((y,), unchecked)


def dotline(
    color: NamedNumber,
    x0: Number,
    y0: Number,
    x1: Number,
    y1: Number,
    on: Number,
    off: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Draws a dashed line between two points.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Column of the start; 0 to 177 px; DATA16.
        y0: Row of the start; 0 to 127 px; DATA16.
        x1: Column of the end; 0 to 178 px; DATA16.
        y1: Row of the end; 0 to 128 px; DATA16.
        on: Length of a dash; px; DATA16.
        off: Length of a gap; px; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.DOTLINE"].draft((color, x0, y0, x1, y1, on, off), unchecked)


def view_value(
    color: NamedNumber,
    x0: Number,
    y0: Number,
    value: Real,
    figures: Number,
    decimals: Number,
    *,
    unchecked: bool = False,
) -> Draft:
    """Draws a number centred in its place, or > instead of digits if it does not fit.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        value: Number to draw; DATAF.
        figures: Total number of characters, including the decimal point; DATA8.
        decimals: Digits after the decimal point; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.VIEW_VALUE"].draft((color, x0, y0, value, figures, decimals), unchecked)


def view_unit(
    color: NamedNumber,
    x0: Number,
    y0: Number,
    value: Real,
    figures: Number,
    decimals: Number,
    length: Number,
    string: Text,
    *,
    unchecked: bool = False,
) -> Draft:
    """Draws a number in large figures and its unit in small letters.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        value: Number to draw; DATAF.
        figures: Total number of characters, including the decimal point; DATA8.
        decimals: Digits after the decimal point; DATA8.
        length: Maximum number of bytes of the unit, including the zero; 0 to 127 bytes; DATA8.
        string: Unit to draw after the number; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.VIEW_UNIT"].draft((color, x0, y0, value, figures, decimals, length, string), unchecked)


def fillcircle(color: NamedNumber, x0: Number, y0: Number, r: Number, *, unchecked: bool = False) -> Draft:
    """Draws a filled circle.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Column of the centre; 0 to 177 px; DATA16.
        y0: Row of the centre; 0 to 127 px; DATA16.
        r: Radius; px; 0: draws nothing; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.FILLCIRCLE"].draft((color, x0, y0, r), unchecked)


def store(no: Number, *, unchecked: bool = False) -> Draft:
    """Keeps a copy of the canvas.

    Args:
        no: Slot for one screen; 0 holds the screen from before the program ran; 0 to 2; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.STORE"].draft((no,), unchecked)


def restore(no: Number, *, unchecked: bool = False) -> Draft:
    """Restores a canvas kept by STORE.

    Args:
        no: Slot for one screen; 0 holds the screen from before the program ran; 0 to 2; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.RESTORE"].draft((no,), unchecked)


def icon_question(
    color: NamedNumber,
    x0: Number,
    y0: Number,
    state: AnyVariable,
    icons: AnyVariable,
    *,
    unchecked: bool = False,
) -> Draft:
    """Shows a row of icons and waits until one is chosen.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        state: Variable for the dialogue's progress; must be 0 at first; 0 to 1; 0: start, or done; 1: being shown;
            DATA8, a variable that is read and written.
        icons: Bit n is large icon n: first the icons to show, then the chosen one; 0: none: closed with the back
            button; DATA32, a variable that is read and written.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.ICON_QUESTION"].draft((color, x0, y0, state, icons), unchecked)


def bmpfile(color: Number, x0: Number, y0: Number, name: Text, *, unchecked: bool = False) -> Draft:
    """Draws a picture file in LEGO's own format .rgf (no .bmp despite the name).

    Args:
        color: Colour of the set pixels; 0 to 1; 0: white, picture inverted; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        name: File with extension .rgf, absolute or relative to /home/root/lms2012/sys; at most 119 characters; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.BMPFILE"].draft((color, x0, y0, name), unchecked)


def popup(open: Number, *, unchecked: bool = False) -> Draft:
    """Opens a window that only its opener can draw on, or closes it and restores the display.

    Args:
        open: Action; 0 to 1; 0: close; 1: open; DATA8.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.POPUP"].draft((open,), unchecked)


def graph_setup(
    x0: Number,
    x1: Number,
    items: Number,
    offset: Elements,
    span: Elements,
    min: Elements,
    max: Elements,
    sample: Elements,
    *,
    unchecked: bool = False,
) -> Draft:
    """Sets up a graph of up to 8 curves; useless in direct commands, since the arrays must outlive it.

    Args:
        x0: Left edge; 0 to 177 px; DATA16.
        x1: Width; 0 to 178 px; DATA16.
        items: Number of curves; 0 to 8; DATA8.
        offset: Top edge of each curve; 0 to 127 px; as many values as ITEMS says; DATA16.
        span: Height of each curve; 0 to 128 px; as many values as ITEMS says; DATA16.
        min: Value at the bottom of each curve; as many values as ITEMS says; DATAF.
        max: Value at the top of each curve; as many values as ITEMS says; DATAF.
        sample: Current value of each curve, read again at each GRAPH_SAMPLE; as many values as ITEMS says; DATAF.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.GRAPH_SETUP"].draft((x0, x1, items, offset, span, min, max, sample), unchecked)


def graph_draw(
    view: Number,
    actual: Output = None,
    lowest: Output = None,
    highest: Output = None,
    average: Output = None,
    *,
    unchecked: bool = False,
) -> Draft:
    """Draws the graph and measures the curve it shows.

    Args:
        view: Curve to draw, counted from 0; any other value draws all and measures none; -1: all; DATA8.
        actual: Latest value, NaN if there is none; DATAF; an output, in global memory when omitted.
        lowest: Lowest value in the graph; DATAF; an output, in global memory when omitted.
        highest: Highest value in the graph; DATAF; an output, in global memory when omitted.
        average: Mean of the values in the graph; DATAF; an output, in global memory when omitted.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.GRAPH_DRAW"].draft((view, actual, lowest, highest, average), unchecked)


def textbox(
    x0: Number,
    y0: Number,
    x1: Number,
    y1: Number,
    text: Text,
    size: Number,
    del_: AnyDEL,
    line: AnyVariable,
    *,
    unchecked: bool = False,
) -> Draft:
    """Shows a text with a scroll bar and waits until a line is chosen.

    Args:
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        x1: Width; 0 to 178 px; DATA16.
        y1: Height; 0 to 128 px; DATA16.
        text: Whole text of the box, its lines separated by DEL; string.
        size: Size of the box's text buffer, including the zero; bytes; DATA32.
        del_: What separates the lines; a member of DEL; DATA8.
        line: Variable, must be -1 at first; then the chosen line, counted from 1; -1: start, or closed with the back
            button; 0: being shown; DATA16, a variable that is read and written.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.TEXTBOX"].draft((x0, y0, x1, y1, text, size, del_, line), unchecked)
