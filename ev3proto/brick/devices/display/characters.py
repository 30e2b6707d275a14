"""The display as text for a terminal: two pixels a character in half blocks, or eight in Braille patterns."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

_HALVES = (" ", "▄", "▀", "█")
_BRAILLE = 0x2800
_DOTS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
"""The bits of a Braille pattern: four rows of two dots."""


def half_blocks(rows: Sequence[bytes], width: int) -> Iterator[str]:
    """The display in lines of `width` characters, two rows of pixels a line.

    Args:
        rows: The rows of pixels, whole bytes each, the leftmost pixel the highest bit.
        width: Pixels in a row.
    """
    pixels = [_bits(row, width) for row in rows]
    for upper, lower in zip(pixels[::2], [*pixels[1::2], "0" * width], strict=False):
        yield "".join(_HALVES[(a == "1") * 2 + (b == "1")] for a, b in zip(upper, lower, strict=True))


def braille(rows: Sequence[bytes], width: int) -> Iterator[str]:
    """The display in lines of half as many characters as it has columns, four rows of pixels a line.

    Args:
        rows: The rows of pixels, whole bytes each, the leftmost pixel the highest bit; their number a multiple of 4.
        width: Pixels in a row, an even number.
    """
    pixels = [_bits(row, width) for row in rows]
    for top in range(0, len(pixels), 4):
        yield "".join(
            chr(
                _BRAILLE
                + sum(
                    dot
                    for row, dots in zip(pixels[top : top + 4], _DOTS, strict=True)
                    for column, dot in enumerate(dots)
                    if row[left + column] == "1"
                )
            )
            for left in range(0, width, 2)
        )


def _bits(row: bytes, width: int) -> str:
    return f"{int.from_bytes(row, 'big'):0{len(row) * 8}b}"[:width]
