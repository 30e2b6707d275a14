"""The keywords of program sources (.lms): types, parameters, objects, and the escapes in strings."""

from __future__ import annotations

from ev3proto.tables.declaration import DATA8, DATA16, DATA32, DATAF, HANDLE, STRING, Direction, Type

VARIABLE_WORDS: dict[str, Type] = {
    "DATA8": DATA8,
    "DATA16": DATA16,
    "DATA32": DATA32,
    "DATAF": DATAF,
    "HANDLE": HANDLE,
    "DATAS": STRING,
    "ARRAY8": DATA8,
    "ARRAY16": DATA16,
    "ARRAY32": DATA32,
    "ARRAYF": DATAF,
}
"""The keywords that declare a variable, and the type of one element."""

SIZED_WORDS = ("DATAS", "ARRAY8", "ARRAY16", "ARRAY32", "ARRAYF")
"""The keywords whose variable name is followed by a number of elements."""

_SUFFIXES = {"8": DATA8, "16": DATA16, "32": DATA32, "F": DATAF, "S": STRING, "H": HANDLE}
_PREFIXES = {"IN": Direction.IN, "OUT": Direction.OUT, "IO": Direction.INOUT}

PARAMETER_WORDS: dict[str, tuple[Direction, Type]] = {
    f"{prefix}_{suffix}": (direction, kind)
    for prefix, direction in _PREFIXES.items()
    for suffix, kind in _SUFFIXES.items()
}
"""The keywords that declare a parameter of a subcall. LEGO's assembler lacks those of handles."""

SIZED_PARAMETERS = tuple(word for word, (_, kind) in PARAMETER_WORDS.items() if kind is STRING)

OLD_WORDS = ("global", "local")
"""Keywords of LEGO's assembler that declare a number of bytes."""

OBJECT_WORDS = ("vmthread", "subcall", "block")
"""The keywords that begin an object; LEGO's assembler lacks blocks."""

DEFINE = "define"

ESCAPES = ((r"\n", "\n"), (r"\q", "'"), (r"\r", "\r"), (r"\t", "\t"))
"""Escapes of both dialects. They are replaced one kind at a time, not from left to right."""

BACKSLASH = ("\\\\", "\\")
"""The escape that only the strict dialect has; it is replaced last."""

LEGO_ESCAPES = ((r"\'", "'"), ("''", "'"), (r"\s", " "))
"""The escapes that only LEGO's dialect has."""

BASIC_NAMES = {"JR_DYNAMIC": "JR", "AND8888_32": "AND32", "EXTRACTLOWBYTE": "MOVE8_8", "INJECTLOWBYTE": "MOVE8_8"}
"""EV3 Basic's extra names for operations whose types would not fit."""

BYTES = "bytes"
"""This project's own: raw bytes."""
