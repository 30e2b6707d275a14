"""The pixels of the display and the shapes drawn on them: lines, rectangles, circles, fills, cells of given pixels.

A row is one integer of 178 bits, the leftmost pixel the highest: a rectangle is one mask ORed into some rows. What is
drawn is what the firmware draws, pixel for pixel, its rounding and its 16-bit coordinates included. Coordinates may
lie outside the display; pixels outside are omitted. Colour 0 clears pixels, any other sets them.
"""

from __future__ import annotations

from collections.abc import Iterator

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
"""Steps after which a line ends whose 16-bit error sum overflowed; it would never end on a brick."""

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
        if y0 == y1 and abs(x1 - x0) < 0x4000:
            self._paint(color, span(min(x0, x1), max(x0, x1) + 1), y0, y0 + 1)
        elif x0 == x1 and abs(y1 - y0) < 0x4000:
            self._paint(color, span(x0, x0 + 1), min(y0, y1), max(y0, y1) + 1)
        elif x0 == x1 or y0 == y1:
            self.pixel(color, x0, y0)
        else:
            for x, y in _walk(x0, y0, x1, y1):
                self.pixel(color, x, y)

    def dotline(self, color: int, x0: int, y0: int, x1: int, y1: int, on: int, off: int) -> None:
        """Draws a dotted line, horizontal or vertical; an oblique one has no dots.

        Args:
            color: Of the dots; the pixels between them get the opposite one.
            x0: Column of the start.
            y0: Row of the start.
            x1: Column of the end.
            y1: Row of the end.
            on: Pixels of a dot.
            off: Pixels between two dots.
        """
        if x0 != x1 and y0 != y1:
            self.line(color, x0, y0, x1, y1)
            return
        pixels = _walk(x0, y0, x1, y1)
        self.pixel(color, *next(pixels))
        count = 1
        for x, y in pixels:
            if count < on + off:
                self.pixel(color if count < on else 1 - color, x, y)
            count += 1
            if count >= on + off:
                count = 0

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
        for dx, dy in _octant(radius):
            for across, down in ((dx, dy), (dy, dx)):
                for row in (y + down, y - down):
                    if 0 <= row < HEIGHT:
                        self.pixel(color, x + across, row)
                        self.pixel(color, x - across, row)

    def fillcircle(self, color: int, x: int, y: int, radius: int) -> None:
        """Fills a circle; does nothing where the radius is 0."""
        for dx, dy in _octant(radius):
            for across, down in ((dx, dy), (dy, dx)):
                for row in (y + down, y - down):
                    if 0 <= row < HEIGHT:
                        self._paint(color, span(x - abs(across), x + abs(across) + 1), row, row + 1)

    # Areas

    def clean(self) -> None:
        """Clears everything."""
        self.rows = [0] * HEIGHT

    def fillwindow(self, color: int, y: int, height: int) -> None:
        """Fills whole rows.

        Args:
            color: 0 clears, 1 sets; any other is the bit pattern of eight pixels, the lowest bit the leftmost, turned
                over from row to row.
            y: First row.
            height: Number of rows, 0: all down to the bottom. With a pattern it is the row after the last.
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
        """Draws a cell of given pixels over the present ones, clipped at the edges.

        Args:
            x: Left column.
            y: Top row.
            width: Pixels in a row of the cell.
            cell_rows: The rows, an integer each, the leftmost pixel the highest of `width` bits.
        """
        shift = WIDTH - width - x
        mask = span(x, x + width)
        for index, row in enumerate(cell_rows, y):
            if 0 <= index < HEIGHT:
                pixels = row << shift if shift >= 0 else row >> -shift
                self.rows[index] = self.rows[index] & ~mask | pixels & mask

    def byte_cell(self, x: int, y: int, width: int, cell_rows: list[int]) -> None:
        """Draws a cell aligned to whole bytes as the firmware does: byte by byte, without clipping at left and right.

        What is left of the display appears at the right end of the row above, and the other way round.

        Args:
            x: Left column, a multiple of 8.
            y: Top row.
            width: Pixels in a row of the cell, a multiple of 8.
            cell_rows: The rows, an integer each, the leftmost pixel the highest of `width` bits.
        """
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


def _walk(x0: int, y0: int, x1: int, y1: int) -> Iterator[tuple[int, int]]:
    """Yields the pixels of a line from one end to the other, with the firmware's 16-bit error sum."""
    dx, dy = wrap16(abs(x1 - x0)), wrap16(abs(y1 - y0))
    step_x, step_y = 1 if x0 < x1 else -1, 1 if y0 < y1 else -1
    error = wrap16(dx - dy)
    yield x0, y0
    for _ in range(_LONGEST_WALK):
        if x0 == x1 and y0 == y1:
            return
        twice = wrap16(error * 2)
        if twice > -dy:
            error, x0 = wrap16(error - dy), wrap16(x0 + step_x)
        if twice < dx:
            error, y0 = wrap16(error + dx), wrap16(y0 + step_y)
        yield x0, y0


def _octant(radius: int) -> Iterator[tuple[int, int]]:
    """Yields one eighth of a circle, from straight below the centre to the diagonal: distances across and down."""
    if not radius:
        return
    x, y, p = 0, radius, 3 - 2 * radius
    while x < y:
        yield x, y
        if p < 0:
            p += 4 * x + 6
        else:
            p += 4 * (x - y) + 10
            y -= 1
        x += 1
    yield x, y
