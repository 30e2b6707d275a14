"""Lua values: a table is on one line if it fits, `Rows` have a line each."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from textwrap import wrap
from typing import Any

INDENT = "    "

WIDTH, _CLOSING = 160, 14
"""Maximum length of a line, and room in it for the brackets around a part."""


class Name(str):
    """A Lua expression, emitted verbatim: a name, or a number in a special form (`0x94`)."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Table:
    """A table with positional values and keyed values, in this order. Keys are names or numbers."""

    items: Sequence[object] = ()
    named: Mapping[Any, object] = field(default_factory=dict)

    def entries(self) -> Iterator[tuple[str, object]]:
        """Returns the prefix of each value (`unit = `, `[0] = `, nothing), and the value."""
        for item in self.items:
            yield "", item
        for key, value in self.named.items():
            is_name = isinstance(key, str) and not isinstance(key, Name)
            yield (f"{key} = " if is_name else f"[{key}] = "), value


class Rows(Table):
    """A table with one entry a line."""

    __slots__ = ()


def hexadecimal(number: int) -> Name:
    """Writes a byte as documents print it."""
    return Name(f"0x{number:02X}")


def literal(value: object, depth: int = 0, head: int = 0) -> str:
    """Writes a value as Lua, indented; `head` is the number of characters before it on its line."""
    if isinstance(value, str) and not isinstance(value, Name):
        return _quoted(value, depth + 1, WIDTH - len(INDENT) * (depth + 1) - head - _CLOSING)
    if not isinstance(value, Table):
        return _scalar(value)
    pieces = [prefix + literal(inner, depth + 1, len(prefix)) for prefix, inner in value.entries()]
    if not pieces:
        return "{}"
    text = f"{{ {', '.join(pieces)} }}"
    if isinstance(value, Rows):
        return "{\n" + "".join(f"{INDENT * (depth + 1)}{piece},\n" for piece in pieces) + f"{INDENT * depth}}}"
    if "\n" not in text and len(INDENT) * depth + head + len(text) + _CLOSING <= WIDTH:
        return text
    lines = _filled(pieces, WIDTH - len(INDENT) * (depth + 1) - head - _CLOSING)
    return "{ " + f",\n{INDENT * (depth + 1)}".join(lines) + " }"


def _filled(pieces: Sequence[str], width: int) -> Iterator[str]:
    """Yields lines with as many of the pieces as fit; one that has lines itself is alone."""
    line = ""
    for piece in pieces:
        if line and ("\n" in line + piece or len(line) + len(piece) + 2 > width):
            yield line
            line = ""
        line = f"{line}, {piece}" if line else piece
    yield line


def _scalar(value: object) -> str:
    if isinstance(value, Name):
        return str(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    raise TypeError(f"{value!r} cannot be written in Lua")


_ESCAPES = str.maketrans({'"': '\\"', "\\": "\\\\", "\n": "\\n", "\r": "\\r", "\0": "\\0"})


def _quoted(text: str, depth: int, width: int) -> str:
    """Writes a text, in several lines where it is wider."""
    lines = wrap(
        text, width, expand_tabs=False, replace_whitespace=False, drop_whitespace=False, break_on_hyphens=False
    ) or [""]
    return f" ..\n{INDENT * depth}".join(f'"{line.translate(_ESCAPES)}"' for line in lines)
