"""Picture files (.rgf): a byte width, a byte height, then rows of whole bytes, the lowest bit the leftmost pixel."""

from __future__ import annotations

from dataclasses import dataclass

from ev3proto.brick.devices.display.canvas import REVERSED


@dataclass(frozen=True)
class Picture:
    """A picture: its rows as integers, the leftmost pixel the highest of `width` bits."""

    width: int
    rows: tuple[int, ...]

    @property
    def height(self) -> int:
        """Its number of rows."""
        return len(self.rows)


def read_picture(data: bytes) -> Picture:
    """Reads an .rgf file; missing bytes are clear pixels, without a size the picture is empty."""
    if len(data) < 2:
        return Picture(0, ())
    width, height = data[0], data[1]
    row_bytes = (width + 7) // 8
    padding = row_bytes * 8 - width
    rows = []
    for index in range(height):
        start = 2 + index * row_bytes
        row = data[start : start + row_bytes].translate(REVERSED).ljust(row_bytes, b"\0")
        rows.append(int.from_bytes(row, "big") >> padding)
    return Picture(width, tuple(rows))
