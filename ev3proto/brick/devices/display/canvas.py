"""The pixels of the display and the shapes drawn on them: lines, rectangles, circles, fills, cells of given pixels.

A row is one integer of 178 bits, the leftmost pixel the highest: a rectangle is one mask ORed into some rows. What is
drawn is what the firmware draws, pixel for pixel, its rounding and its 16-bit coordinates included. Coordinates may
be outside the display: circles are clipped before they are drawn, and lines have a limit, so that none takes long.
Colour 0 clears pixels, any other sets them.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import isqrt

from ev3proto.brick.conversions import quotient, wrap16

WIDTH = 178
HEIGHT = 128
ROW_BYTES = 23
"""Bytes of a row in the frame buffer: 184 bits, of which the last 6 are padding."""

FULL = (1 << WIDTH) - 1
"""A row whose pixels are all set."""

_PADDING = ROW_BYTES * 8 - WIDTH
_LEFT = 1 << (WIDTH - 1)
_LONGEST_WALK = 1 << 15
"""Maximum number of steps of a line whose 16-bit error sum overflowed, which would never end on a brick."""

_LONGEST_STRAIGHT = 0x3FFF
"""Length up to which the error sum of a horizontal or vertical line does not overflow."""

REVERSED = bytes(int(f"{byte:08b}"[::-1], 2) for byte in range(256))
"""Each byte with its bits reversed: in the firmware's pictures the leftmost pixel is the lowest bit."""


def span(left: int, right: int) -> int:
    """Returns the mask of the pixels from column `left` up to, not including, column `right`."""
    left, right = max(left, 0), min(right, WIDTH)
    return ((1 << right - left) - 1) << (WIDTH - right) if left < right else 0


class Canvas:
    """178 x 128 pixels, (0, 0) at the top left; all of them clear at first."""

    __slots__ = ("rows",)

    def __init__(self) -> None:
        self.rows = [0] * HEIGHT

    def copy(self) -> Canvas:
        """Returns another canvas with the same pixels."""
        other = Canvas()
        other.rows[:] = self.rows
        return other

    def to_bytes(self) -> list[bytes]:
        """Returns the rows, 23 bytes each: leftmost pixel the highest bit, padding 0."""
        return [(row << _PADDING).to_bytes(ROW_BYTES, "big") for row in self.rows]

    # Single pixels and masks

    def pixel(self, color: int, x: int, y: int) -> None:
        """Draws one pixel."""
        if 0 <= x < WIDTH and 0 <= y < HEIGHT:
            if color:
                self.rows[y] |= _LEFT >> x
            else:
                self.rows[y] &= ~(_LEFT >> x)

    def _paint(self, color: int, mask: int, top: int, bottom: int) -> None:
        """Paints the same pixels of all rows from `top` up to, not including, `bottom`."""
        rows = self.rows
        if color:
            for y in range(max(top, 0), min(bottom, HEIGHT)):
                rows[y] |= mask
        else:
            mask ^= FULL
            for y in range(max(top, 0), min(bottom, HEIGHT)):
                rows[y] &= mask

    # Lines

    def line(self, color: int, x0: int, y0: int, x1: int, y1: int) -> None:
        """Draws a line with both ends; of a horizontal or vertical one too long for the firmware only its start."""
        if y0 == y1 and abs(x1 - x0) <= _LONGEST_STRAIGHT:
            self._paint(color, span(min(x0, x1), max(x0, x1) + 1), y0, y0 + 1)
        elif x0 == x1 and abs(y1 - y0) <= _LONGEST_STRAIGHT:
            self._paint(color, span(x0, x0 + 1), min(y0, y1), max(y0, y1) + 1)
        elif x0 == x1 or y0 == y1:
            self.pixel(color, x0, y0)
        else:
            for _, x, y in _walk(x0, y0, x1, y1):
                self.pixel(color, x, y)

    def dotline(self, color: int, x0: int, y0: int, x1: int, y1: int, on: int, off: int) -> None:
        """Draws a straight line of `on` pixels and gaps of `off` in the opposite colour; an oblique one is solid."""
        if x0 != x1 and y0 != y1:
            self.line(color, x0, y0, x1, y1)
            return
        period = on + off
        for step, x, y in _walk(x0, y0, x1, y1):
            # The counter starts at 1, and is reset when it reaches the period.
            count = step % period if step > 1 and period > 0 else step
            if not step or count < period:
                self.pixel(color if not step or count < on else 1 - color, x, y)

    # Rectangles

    def rect(self, color: int, x: int, y: int, width: int, height: int) -> None:
        """Draws the outline of a rectangle: four lines."""
        right, bottom = wrap16(x + width - 1), wrap16(y + height - 1)
        self.line(color, x, y, right, y)
        self.line(color, right, y, right, bottom)
        self.line(color, x, bottom, right, bottom)
        self.line(color, x, y, x, bottom)

    def fillrect(self, color: int, x: int, y: int, width: int, height: int) -> None:
        """Fills a rectangle; does nothing where width or height is not positive."""
        self._paint(color, span(x, wrap16(x + width)), y, wrap16(y + height))

    def inverserect(self, x: int, y: int, width: int, height: int) -> None:
        """Inverts the pixels of a rectangle."""
        mask = span(x, wrap16(x + width))
        for row in range(max(y, 0), min(wrap16(y + height), HEIGHT)):
            self.rows[row] ^= mask

    def vertbar(self, color: int, x: int, y: int, width: int, height: int, least: int, most: int, actual: int) -> None:
        """Draws a scroll bar: an outline with a knob for the position of `actual` between `least` and `most`."""
        items = wrap16(most - least)
        actual = min(max(actual, least), most)
        shape = _KNOBS.get(width)
        knob = len(shape) if shape else quotient(height, items) if items > 0 else 7
        self.rect(color, x, y, width, height)
        top = y
        if items > 1 and actual > 0:
            top += quotient((height - knob) * (actual - 1), items - 1)
        if shape is None:
            self.fillrect(color, x, top, width, knob)
            return
        for row, columns in enumerate(shape):
            for column in columns:
                self.pixel(color, x + column, top + row)

    # Circles

    def circle(self, color: int, x: int, y: int, radius: int) -> None:
        """Draws a circle's outline; nothing where the radius is 0."""
        octant = _Octant(radius)
        across = {abs(column - x) for column in range(WIDTH)} | {abs(row - y) for row in range(HEIGHT)}
        for dx in across:
            if dx > octant.last or not radius:
                continue
            dy = octant.height(dx)
            for right, down in ((dx, dy), (dy, dx)):
                for row in (y + down, y - down):
                    self.pixel(color, x + right, row)
                    self.pixel(color, x - right, row)

    def fillcircle(self, color: int, x: int, y: int, radius: int) -> None:
        """Fills a circle; does nothing where the radius is 0."""
        octant = _Octant(radius)
        for row in range(HEIGHT) if radius else ():
            half = octant.width(abs(row - y))
            if half is not None:
                self._paint(color, span(x - half, x + half + 1), row, row + 1)

    # Areas

    def clean(self) -> None:
        """Clears everything."""
        self.rows = [0] * HEIGHT

    def fillwindow(self, color: int, y: int, height: int) -> None:
        """Fills whole rows: height 0 means down to the bottom.

        Colours above 1 are bit patterns, the lowest bit leftmost, inverted from row to row, and end at row `height`.
        """
        if y + height >= HEIGHT:
            return
        if color in (0, 1):
            self._paint(color, FULL, y, y + height if height else HEIGHT)
            return
        pattern = REVERSED[color & 0xFF]
        row = int.from_bytes(bytes([pattern]) * ROW_BYTES, "big") >> _PADDING
        for index in range(y, height or HEIGHT):
            if 0 <= index < HEIGHT:
                self.rows[index] = row
            row ^= FULL

    def scroll(self, rows: int) -> None:
        """Moves the picture up; what comes in at the bottom is clear. Only for 1 to 127 rows."""
        if 0 < rows < HEIGHT:
            self.rows = self.rows[rows:] + [0] * rows

    # Opaque cells: characters, icons, pictures

    def cell(self, x: int, y: int, width: int, cell_rows: list[int]) -> None:
        """Draws a cell over the present pixels, clipped; the leftmost pixel is the highest of `width` bits."""
        shift = WIDTH - width - x
        mask = span(x, x + width)
        for index, row in enumerate(cell_rows, y):
            if 0 <= index < HEIGHT:
                pixels = row << shift if shift >= 0 else row >> -shift
                self.rows[index] = self.rows[index] & ~mask | pixels & mask

    def byte_cell(self, x: int, y: int, width: int, cell_rows: list[int]) -> None:
        """Draws a cell aligned to whole bytes; as in the firmware, pixels beyond an edge appear at the opposite one."""
        if x >= 0 and x + width <= WIDTH:
            self.cell(x, y, width, cell_rows)
            return
        for index, row in enumerate(cell_rows, y):
            start = index * ROW_BYTES + x // 8
            if not 0 <= start < HEIGHT * ROW_BYTES:
                continue
            for place in range(width // 8):
                target, column = divmod(start + place, ROW_BYTES)
                self.cell(column * 8, target, 8, [row >> (width - 8 - place * 8) & 0xFF])


_KNOBS = {
    5: ((1, 2, 3), (1, 3), (2,), (1, 3), (2,), (1, 3), (1, 2, 3)),
    6: ((2, 3), (1, 4), (), (2, 3), (), (2, 3), (), (1, 4), (2, 3)),
}
"""Knobs of scroll bars by the bar's width: the columns that are drawn, row by row."""


_Pixels = Iterator[tuple[int, int, int]]
"""The pixels of a line on the display: steps from its start, column, row."""


def _walk(x0: int, y0: int, x1: int, y1: int) -> _Pixels:
    """Yields the pixels of a line that are on the display, with the firmware's 16-bit error sum, which may overflow."""
    dx, dy = wrap16(abs(x1 - x0)), wrap16(abs(y1 - y0))
    step_x, step_y = 1 if x0 < x1 else -1, 1 if y0 < y1 else -1
    error = wrap16(dx - dy)
    for step in range(_LONGEST_WALK + 1):
        if 0 <= x0 < WIDTH and 0 <= y0 < HEIGHT:
            yield step, x0, y0
        # wrap16, written out: the loop is four times as fast.
        twice = (error * 2 + 0x8000 & 0xFFFF) - 0x8000
        moves_x, moves_y = twice > -dy, twice < dx
        if (x0 == x1 and y0 == y1) or not (moves_x or moves_y):
            return
        if moves_x:
            error, x0 = (error - dy + 0x8000 & 0xFFFF) - 0x8000, (x0 + step_x + 0x8000 & 0xFFFF) - 0x8000
        if moves_y:
            error, y0 = (error + dx + 0x8000 & 0xFFFF) - 0x8000, (y0 + step_y + 0x8000 & 0xFFFF) - 0x8000


class _Octant:
    """One eighth of a circle, from straight below the centre to the diagonal, as the firmware walks it."""

    def __init__(self, radius: int) -> None:
        self._radius = abs(radius)
        # the distance from the middle to its last column
        self.last = 0 if radius < 0 else max(isqrt(radius * radius // 2) - 2, 0)
        while radius > 0 and self.height(self.last) > self.last:
            self.last += 1

    def height(self, across: int) -> int:
        """Returns how far below the centre the pixel of a column is; the firmware goes up one pixel a column."""
        if not across:
            return self._radius
        square = 4 * (self._radius * self._radius - across * across) - 3
        return max((1 + isqrt(max(square, 0))) // 2, across - 1)

    def width(self, down: int) -> int | None:
        """Returns the distance to the last pixel of a row of the filled circle; None for a row outside it."""
        most = self.height(down) if down <= self.last else None
        square = self._radius * self._radius - down * down + down - 1
        across = min(isqrt(max(square, 0)), self.last)
        if self.height(across) == down:
            most = max(most or 0, across)
        return most
