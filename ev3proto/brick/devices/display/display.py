"""The display: the canvas, the visible picture, the selected font, saved pictures.

Shapes are drawn by the canvas. This file draws what needs letters and icons, and handles the display as a
whole: showing, saving, the line at the top.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

from ev3proto.brick.devices import Part
from ev3proto.brick.devices.display import top_line
from ev3proto.brick.devices.display.canvas import WIDTH, Canvas
from ev3proto.brick.devices.display.fonts import FONTS, Font
from ev3proto.brick.devices.display.graph import Graph
from ev3proto.brick.devices.display.icons import ICONS
from ev3proto.brick.devices.display.pictures import Picture
from ev3proto.brick.devices.panel import Battery
from ev3proto.brick.formatting import fixed
from ev3proto.brick.running_programs import USER_SLOT, Program
from ev3proto.brick.settings import Settings
from ev3proto.tables.enumerations import FONTTYPE, ICONTYPE

NORMAL, SMALL, LARGE, TINY = (
    FONTTYPE.members[name] for name in ("NORMAL_FONT", "SMALL_FONT", "LARGE_FONT", "TINY_FONT")
)
NORMAL_ICONS, LARGE_ICONS = ICONTYPE.members["NORMAL_ICON"], ICONTYPE.members["LARGE_ICON"]
STORE_LEVELS = 3
"""Pictures that STORE can save."""

_MOST_DIGITS = 23
"""Characters of a number that is drawn."""

TOP_LINE_PERIOD = 400_000
"""Microseconds between two redraws of the line at the top while it is on."""


class Display(Part):
    """The display of a brick that was just switched on: everything is clear."""

    def __init__(self, settings: Settings | None = None, battery: Battery | None = None) -> None:
        """Makes a display; its top line shows `settings` and `battery`."""
        self.canvas = Canvas()  # the canvas of all drawing operations
        self.font = NORMAL  # number of the selected font
        self.is_headed = False  # whether there is a line at the top
        self._settings = settings or Settings()
        self._battery = battery or Battery()
        self.graph = Graph()  # the graph of GRAPH_SETUP
        self.is_in_use = False  # something was drawn that is not shown yet
        self.is_blocked = False  # only the object that opened a popup may draw
        self._owner: tuple[int, int] | None = None
        self._before_popup = Canvas()
        self._next_top_line = 0
        self._shown = self.canvas.to_bytes()
        self._stored = [Canvas() for _ in range(STORE_LEVELS)]

    @property
    def rows(self) -> list[bytes]:
        """What is shown: 128 rows of 23 bytes, the leftmost pixel the highest bit, padding bits 0."""
        return list(self._shown)

    # The display as a whole

    def update(self) -> None:
        """Shows the canvas, the line at the top redrawn if it is on; selects the normal font."""
        self.font = NORMAL
        if self.is_headed:
            self._draw_top_line()
        self._shown = self.canvas.to_bytes()

    def advance(self, microseconds: int) -> None:
        """Redraws the line at the top every 0.4 s, as the firmware does, and shows the canvas with it."""
        if microseconds >= self._next_top_line:
            self._next_top_line = microseconds + TOP_LINE_PERIOD
            if self.is_headed:
                self._draw_top_line()
                self._shown = self.canvas.to_bytes()

    def program_started(self, program: Program) -> None:
        """Stores the screen at level 0 before a user program, which has no line at the top."""
        if program.slot == USER_SLOT:
            self.store(0)
            self.is_headed = False

    def program_ended(self, program: Program) -> None:
        """Closes the popup of a program that has ended."""
        if self._owner is not None and self._owner[0] == program.slot:
            self.close_popup()

    def clean(self) -> None:
        """Clears the canvas and selects the normal font."""
        self.font = NORMAL
        self.canvas.clean()

    def fillwindow(self, color: int, y: int, height: int) -> None:
        """Fills whole rows of the canvas, see Canvas.fillwindow, and selects the normal font."""
        self.font = NORMAL
        self.canvas.fillwindow(color, y, height)

    def select_font(self, font: int) -> None:
        """Selects a font by its number, clamped to the known ones."""
        self.font = min(max(font, min(FONTS)), max(FONTS))

    def store(self, level: int) -> None:
        """Saves the canvas; levels other than 0 to 2 are ignored."""
        if 0 <= level < STORE_LEVELS:
            self._stored[level] = self.canvas.copy()

    def restore(self, level: int) -> None:
        """Restores a saved canvas; levels other than 0 to 2 are ignored."""
        if 0 <= level < STORE_LEVELS:
            self.canvas = self._stored[level].copy()

    # Permission to draw

    def is_blocked_for(self, slot: int, number: int) -> bool:
        """Returns whether the display is blocked for an object of a program: SCREEN_BLOCK or another object's popup."""
        return self.is_blocked and self._owner != (slot, number)

    def open_popup(self, slot: int, number: int) -> None:
        """Keeps the canvas as it is now, and blocks the display for all but one object of a program."""
        self._before_popup = self.canvas.copy()
        self._owner = (slot, number)
        self.is_blocked = True

    def close_popup(self) -> None:
        """Shows the canvas as it was before the popup, and lets all objects draw."""
        self.canvas = self._before_popup.copy()
        self._shown = self.canvas.to_bytes()
        self._owner = None
        self.is_blocked = False

    # Text

    def text(self, color: int, x: int, y: int, text: bytes, font: int | None = None) -> None:
        """Draws characters up to the right edge; colour 0 inverts them, those without a glyph leave a gap."""
        letters = FONTS[self.font if font is None else font]
        for character in text:
            if x >= WIDTH - letters.width:
                return
            self._character(color, x, y, letters, character)
            x += letters.width

    def _character(self, color: int, x: int, y: int, letters: Font, character: int) -> None:
        glyph = letters.glyph(character)
        if glyph is None:
            return
        rows = _painted(glyph, letters.width, color)
        if x % 8 == 0 and letters.width % 8 == 0:
            self.canvas.byte_cell(x, y, letters.width, rows)
        else:
            self.canvas.cell(x, y, letters.width, rows)

    def value(self, color: int, x: int, y: int, number: float, figures: int, decimals: int) -> None:
        """Draws a number of at most `figures` characters, left-justified if negative; NaN as dashes."""
        if math.isnan(number):
            self.text(color, x, y, b"-" * abs(figures))
            return
        digits = fixed(number, decimals).rjust(max(figures, 0)).encode()[:_MOST_DIGITS]
        self.text(color, x, y, digits[: abs(figures) + digits.startswith(b"-")])

    def view_value(self, color: int, x: int, y: int, number: float, figures: int, decimals: int) -> None:
        """Draws a number centred in `figures` cells, its sign as a line before them, in the selected font."""
        self._view(self.font, color, x, y, number, figures, decimals, centred=True)

    def view_unit(self, color: int, x: int, y: int, number: float, figures: int, decimals: int, unit: bytes) -> None:
        """Draws a number in the large font with its unit in small letters after it."""
        cells = self._view(LARGE, color, x, y, number, figures, decimals, centred=False)
        if cells is not None:
            self.text(color, x + FONTS[LARGE].width * cells, y, unit, SMALL)

    def _view(
        self, font: int, color: int, x: int, y: int, number: float, figures: int, decimals: int, *, centred: bool
    ) -> int | None:
        """Draws a number with its sign as a line; returns the cells it takes, None if it is drawn as dashes."""
        letters = FONTS[font]
        before = (letters.width + 2) // 3 - 1
        self._sign(letters, 1 - color, x - before, y, x + figures * letters.width)
        if not math.isfinite(number):
            self.text(color, x, y, b"-" * figures, font)
            return None
        digits = fixed(number, decimals).encode()
        negative = digits.startswith(b"-")
        digits = digits.removeprefix(b"-")
        if len(digits) > figures:
            self.text(color, x, y, b">" * figures, font)
            self._sign(letters, 1 - color, x - before, y, x)
            return figures
        indent = (figures - len(digits) + 1) // 2 * letters.width if centred else 0
        self.text(color, x + indent, y, digits[:_MOST_DIGITS], font)
        self._sign(letters, color if negative else 1 - color, x - before + indent, y, x + indent)
        return len(digits)

    def _sign(self, letters: Font, color: int, left: int, y: int, right: int) -> None:
        """Draws a minus sign as a line at half the height of the letters; in tall fonts two rows."""
        middle = y + letters.height // 2
        self.canvas.line(color, left, middle, right, middle)
        if letters.height > 12:
            self.canvas.line(color, left, middle - 1, right, middle - 1)

    # Pictures

    def icon(self, color: int, x: int, y: int, kind: int, number: int) -> None:
        """Draws an icon at x, rounded down to a multiple of 8; an unknown one is ignored."""
        icons = ICONS.get(kind)
        if icons is None or not 0 <= number < len(icons.pictures):
            return
        self.canvas.byte_cell(x & ~7, y, icons.width, _painted(icons.pictures[number], icons.width, color))

    def picture(self, color: int, x: int, y: int, picture: Picture) -> None:
        """Draws a picture over the canvas, clipped at the edges; colour 0 inverts its pixels."""
        self.canvas.cell(x, y, picture.width, _painted(picture.rows, picture.width, color))

    def _draw_top_line(self) -> None:
        self.canvas.fillrect(0, 0, 0, WIDTH, top_line.HEIGHT)
        x, name = top_line.name_place(self._settings)
        self.text(1, x, top_line.TOP, name, top_line.FONT)
        for x, icon in top_line.icon_places(self._settings, self._battery):
            self.icon(1, x, top_line.TOP, top_line.ICON_SET, icon)
        self.canvas.line(1, 0, top_line.HEIGHT, WIDTH - 1, top_line.HEIGHT)


def _painted(rows: Iterable[int], width: int, color: int) -> list[int]:
    """Returns the rows of a picture; colour 0 inverts its pixels."""
    solid = (1 << width) - 1
    return [row if color else row ^ solid for row in rows]
