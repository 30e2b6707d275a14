"""The display as text: each character of braille shows two by four of its pixels."""

from __future__ import annotations

from collections.abc import Sequence

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
