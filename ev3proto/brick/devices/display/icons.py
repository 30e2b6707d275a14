"""The icons of the display by set and number: the drawings of icon_drawings.py made into cells of pixels."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ev3proto.brick.devices.display.canvas import WIDTH, Canvas
from ev3proto.brick.devices.display.fonts import FIRST, FONTS
from ev3proto.brick.devices.display.icon_drawings import ARROW_ICONS, LARGE_ICONS, MENU_ICONS, NORMAL_ICONS, SMALL_ICONS
from ev3proto.tables.declaration import Enumeration
from ev3proto.tables.enumerations import A_ICON_NO, FONTTYPE, ICONTYPE, L_ICON_NO, M_ICON_NO, N_ICON_NO, S_ICON_NO

_TINY = FONTS[FONTTYPE.members["TINY_FONT"]]


@dataclass(frozen=True)
class IconSet:
    """Icons of one size; `pictures` has the rows of each, the leftmost pixel the highest of `width` bits."""

    width: int
    height: int
    pictures: tuple[tuple[int, ...], ...]


def _draw(drawing: str, width: int, height: int) -> tuple[int, ...]:
    """Returns the rows of one icon."""
    canvas = Canvas()
    for word in drawing.split():
        letter, arguments = word[0], word[1:].split(",")
        if letter == "T":
            x, y = int(arguments[0]), int(arguments[1])
            for place, character in enumerate(arguments[2].encode()):
                rows = _TINY.glyphs[character - FIRST]
                canvas.cell(x + place * _TINY.width, y, _TINY.width, list(rows))
            continue
        numbers = [int(argument) for argument in arguments]
        if letter == "I":
            canvas.inverserect(*numbers)
        elif letter == "E":
            canvas.fillrect(0, *numbers)
        else:
            shape = {"L": canvas.line, "R": canvas.rect, "F": canvas.fillrect}.get(letter)
            if shape is not None:
                shape(1, *numbers)
            else:
                {"C": canvas.circle, "D": canvas.fillcircle}[letter](1, *numbers)
    return tuple(row >> (WIDTH - width) for row in canvas.rows[:height])


def _icon_set(width: int, height: int, names: Enumeration, drawings: Mapping[str, str]) -> IconSet:
    """Returns the icons of one set in the order of their numbers."""
    assert names.end is not None
    by_number = {names.members[name]: drawing for name, drawing in drawings.items()}
    pictures = tuple(_draw(by_number.get(number, ""), width, height) for number in range(names.end[1]))
    return IconSet(width, height, pictures)


ICONS = {
    ICONTYPE.members["NORMAL_ICON"]: _icon_set(24, 12, N_ICON_NO, NORMAL_ICONS),
    ICONTYPE.members["SMALL_ICON"]: _icon_set(16, 8, S_ICON_NO, SMALL_ICONS),
    ICONTYPE.members["LARGE_ICON"]: _icon_set(24, 22, L_ICON_NO, LARGE_ICONS),
    ICONTYPE.members["MENU_ICON"]: _icon_set(16, 12, M_ICON_NO, MENU_ICONS),
    ICONTYPE.members["ARROW_ICON"]: _icon_set(8, 12, A_ICON_NO, ARROW_ICONS),
}
"""The sets by number."""
