"""The four fonts of the display: cells of the firmware's sizes, made of the letters in letters.py.

The normal font has the letters as they are, the small one twice as thick, the large one at twice the size; the tiny one
has letters of its own.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ev3proto.brick.devices.display.letters import LETTERS, TINY_LETTERS
from ev3proto.tables.enumerations import FONTTYPE

FIRST, LAST = 0x20, 0x7F
"""The characters that have a glyph; others leave a gap."""


@dataclass(frozen=True)
class Font:
    """A font whose characters all have cells of one size."""

    width: int
    height: int
    glyphs: tuple[tuple[int, ...], ...]
    """Rows of each character from FIRST on, the leftmost pixel the highest of `width` bits."""

    def glyph(self, character: int) -> tuple[int, ...] | None:
        """Returns the rows of a character; None if it has no glyph."""
        return self.glyphs[character - FIRST] if FIRST <= character <= LAST else None


def _letters(drawings: tuple[str, ...]) -> list[list[str]]:
    """Returns the rows of every letter in a set of drawings, `#` and `.`."""
    letters: list[list[str]] = []
    for drawing in drawings:
        rows = [line.split() for line in drawing.strip().splitlines()]
        letters += [list(column) for column in zip(*rows, strict=True)]
    return letters


def _font(
    width: int, height: int, drawings: tuple[str, ...], left: int, shape: Callable[[list[int]], list[int]] = list
) -> Font:
    """Makes a font of cells `width` by `height`, its letters `left` pixels from the left edge, changed by `shape`."""
    glyphs = []
    for letter in _letters(drawings):
        rows = [int(row.translate(_BITS), 2) << (width - left - len(row)) for row in letter]
        rows = shape(rows + [0] * (height - len(rows)))
        glyphs.append(tuple(rows))
    return Font(width, height, tuple(glyphs))


def _bold(rows: list[int]) -> list[int]:
    """Doubles every pixel to the right, unless that closes a gap of one pixel."""
    return [row | row >> 1 & ~(row << 1) for row in rows]


def _doubled(font: Font) -> Font:
    """Draws every pixel as two by two."""
    wide = [int("".join(bit * 2 for bit in f"{row:0{font.width}b}"), 2) for row in range(1 << font.width)]
    glyphs = tuple(tuple(wide[row] for row in glyph for _ in range(2)) for glyph in font.glyphs)
    return Font(2 * font.width, 2 * font.height, glyphs)


_BITS = str.maketrans(".#", "01")
_NORMAL = FONTTYPE.members["NORMAL_FONT"]

FONTS = {
    _NORMAL: _font(8, 9, LETTERS, 1),
    FONTTYPE.members["SMALL_FONT"]: _font(8, 8, LETTERS, 1, _bold),
    FONTTYPE.members["LARGE_FONT"]: _doubled(_font(8, 8, LETTERS, 1)),
    FONTTYPE.members["TINY_FONT"]: _font(5, 7, TINY_LETTERS, 0),
}
"""The fonts by number."""
