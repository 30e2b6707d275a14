"""Dialogues: windows that wait for a button. They work like the firmware's, but look different."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from ev3proto.brick.devices.display.canvas import Canvas
from ev3proto.brick.devices.display.display import LARGE_ICONS, NORMAL, NORMAL_ICONS, TINY, Display
from ev3proto.brick.devices.display.fonts import FONTS
from ev3proto.brick.devices.display.icons import ICONS

_LEFT, _TOP, _WIDTH, _HEIGHT = 9, 20, 160, 92
_MARGIN = 7
_ICON = ICONS[LARGE_ICONS]
_LINE = FONTS[NORMAL]
_CHARACTERS = b" ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-."


@dataclass
class ScreenDialog:
    """A window over what was drawn before."""

    display: Display  # the display that shows it
    owner: object  # the program that opened it
    choice: int = 0  # the number of the selected element, counted from 0
    text: bytes = b""  # the text typed so far
    lines: Sequence[bytes] = ()  # from which one is chosen
    _before: Canvas = field(init=False)

    def __post_init__(self) -> None:
        self._before = self.display.canvas.copy()

    def close(self) -> None:
        """Closes the window and shows what it covered."""
        self.display.canvas = self._before
        self.display.update()

    def _window(self) -> None:
        canvas = self.display.canvas
        canvas.fillrect(0, _LEFT, _TOP, _WIDTH, _HEIGHT)
        canvas.rect(1, _LEFT, _TOP, _WIDTH, _HEIGHT)

    def _icons(self, icons: Sequence[int], selected: int | None) -> int:
        """Draws large icons in a row, the selected one in a frame; returns the row after them."""
        shown = [icon for icon in icons if icon >= 0]
        left, top = (_LEFT + _MARGIN) & ~7, _TOP + _MARGIN
        for place, icon in enumerate(shown):
            x = left + place * (_ICON.width + 8)
            self.display.icon(1, x, top, LARGE_ICONS, icon)
            if place == selected:
                self.display.canvas.rect(1, x - 3, top - 3, _ICON.width + 6, _ICON.height + 6)
        return top + (_ICON.height + _MARGIN if shown else 0)

    def _text(self, text: bytes, top: int) -> None:
        """Draws a text in as many lines as fit."""
        most = (_WIDTH - 2 * _MARGIN) // _LINE.width
        for line in range((_TOP + _HEIGHT - top) // _LINE.height):
            part = text[line * most : (line + 1) * most]
            self.display.text(1, _LEFT + _MARGIN, top + line * _LINE.height, part, NORMAL)

    def show_message(self, icons: Sequence[int], text: bytes) -> None:
        """Shows icons with a text below."""
        self._window()
        self._text(text, self._icons(icons, None))
        self.display.update()

    def show_choice(self, icons: Sequence[int]) -> None:
        """Shows icons, one of them selected."""
        self._window()
        self._icons(icons, self.choice)
        self.display.update()

    def show_input(self, icon: int, caption: bytes) -> None:
        """Shows a caption and the text typed so far."""
        self._window()
        self.display.icon(1, _LEFT + _MARGIN, _TOP + 4, NORMAL_ICONS, icon)
        self.display.text(1, _LEFT + 4 * _MARGIN + 8, _TOP + _MARGIN, caption, TINY)
        self._text(self.text + b"_", _TOP + 4 * _MARGIN)
        self.display.update()

    def show_list(self, x: int, y: int, width: int, height: int, lines: Sequence[bytes]) -> None:
        """Shows lines in a rectangle, the selected one inverted."""
        canvas = self.display.canvas
        canvas.fillrect(0, x, y, width, height)
        fit = max(height // _LINE.height, 1)
        first = max(0, min(self.choice - fit // 2, len(lines) - fit))
        for row, line in enumerate(lines[first : first + fit]):
            top = y + row * _LINE.height
            self.display.text(1, x, top, line[: max(width // _LINE.width, 0)], NORMAL)
            if first + row == self.choice:
                canvas.inverserect(x, top, width, _LINE.height)
        self.display.update()

    def type_key(self, up: bool, down: bool, left: bool, right: bool) -> None:
        """Types with four buttons: up and down change the last character, right adds one, left removes one."""
        if right:
            self.text += _CHARACTERS[1:2]
        elif left:
            self.text = self.text[:-1]
        elif (up or down) and self.text:
            place = _CHARACTERS.find(self.text[-1:]) + (1 if down else -1)
            self.text = self.text[:-1] + bytes([_CHARACTERS[place % len(_CHARACTERS)]])
