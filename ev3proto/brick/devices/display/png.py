"""The display as a PNG file: one bit a pixel, which needs no more than the standard library's zlib."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Sequence

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
