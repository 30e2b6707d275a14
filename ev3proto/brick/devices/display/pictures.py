"""Pictures: .rgf files, and the display for people to look at: as text, in braille, and as a PNG file."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Sequence
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


_FIRST = 0x2800
_DOTS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
"""The bit of each dot in a character's number, row by row."""


def braille(rows: Sequence[bytes], width: int) -> list[str]:
    """Returns the display as text, a line for every four rows; a row has whole bytes, its width is even."""
    bits = [int.from_bytes(row, "big") for row in rows]
    size = len(rows[0]) * 8 if rows else 0
    lines = []
    for top in range(0, len(rows), len(_DOTS)):
        line = []
        for left in range(0, width, 2):
            number = _FIRST
            for row, dots in zip(bits[top : top + len(_DOTS)], _DOTS, strict=False):
                pair = row >> (size - left - 2) & 3
                number |= dots[0] * (pair >> 1) | dots[1] * (pair & 1)
            line.append(chr(number))
        lines.append("".join(line))
    return lines


_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_GREY = 0
_ALL_LIGHT = bytes(255 - byte for byte in range(256))


def write_png(rows: Sequence[bytes], width: int, scale: int = 1) -> bytes:
    """Makes a PNG file of rows of whole bytes, the leftmost pixel the highest bit; set pixels become black."""
    lines = []
    for row in rows:
        bits = int.from_bytes(row, "big") >> (len(row) * 8 - width)
        wide = "".join(bit * scale for bit in f"{bits:0{width}b}")
        wide += "0" * (-len(wide) % 8)
        line = int(wide, 2).to_bytes(len(wide) // 8, "big").translate(_ALL_LIGHT)
        lines += [b"\0" + line] * scale
    header = struct.pack(">IIBBBBB", width * scale, len(rows) * scale, 1, _GREY, 0, 0, 0)
    body = zlib.compress(b"".join(lines), 9)
    return _SIGNATURE + _chunk(b"IHDR", header) + _chunk(b"IDAT", body) + _chunk(b"IEND", b"")


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
