"""UI_DRAW: draws on the canvas of the display, or runs a dialogue on it.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import NamedNumber, Number
from ev3proto.ops.ui_draw import (
    bmpfile,
    browse,
    circle,
    clean,
    dotline,
    fillcircle,
    fillrect,
    fillwindow,
    graph_draw,
    graph_setup,
    icon,
    icon_question,
    inverserect,
    keyboard,
    line,
    notification,
    picture,
    pixel,
    popup,
    question,
    restore,
    scroll,
    select_font,
    store,
    text,
    textbox,
    topline,
    update,
    value,
    vertbar,
    view_unit,
    view_value,
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
    "rectangle",
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

_OPERATIONS = drafts("xtended")


def rectangle(color: NamedNumber, x0: Number, y0: Number, x1: Number, y1: Number, *, unchecked: bool = False) -> Draft:
    """Draws the outline of a rectangle.

    Args:
        color: Colour to draw in; 0 to 1; 0: white; 1: black; DATA8.
        x0: Left edge; 0 to 177 px; DATA16.
        y0: Top edge; 0 to 127 px; DATA16.
        x1: Width; 0 to 178 px; DATA16.
        y1: Height; 0 to 128 px; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["UI_DRAW.RECTANGLE"].draft((color, x0, y0, x1, y1), unchecked)
