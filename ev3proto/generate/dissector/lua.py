"""Lua values: a table is on one line, `Rows` have a line each."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

INDENT = "    "


class Name(str):
    """A Lua expression, emitted verbatim: a name, or a number in a special form (`0x94`)."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Table:
    """A table with positional values and keyed values, in this order. Keys are names or numbers."""

    items: Sequence[object] = ()
    named: Mapping[Any, object] = field(default_factory=dict)

    @property
    def brackets(self) -> tuple[str, str]:
        """Returns the brackets around the entries."""
        return "{", "}"

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


class Source(Table):
    """The entries of a table as a text that Lua parses on demand: `[[ 1, unit = "mm" ]]`."""

    __slots__ = ()

    @property
    def brackets(self) -> tuple[str, str]:
        """Quotes of a long string. None of the texts in the tables contains the second one."""
        return "[[", "]]"


def hexadecimal(number: int) -> Name:
    """Writes a byte as documents print it."""
    return Name(f"0x{number:02X}")


def literal(value: object, depth: int = 0) -> str:
    """Writes a whole number, a text, a truth value, a `Name` or a `Table` as Lua, at a depth of indentation."""
    if not isinstance(value, Table):
        return _scalar(value)
    first, last = value.brackets
    pieces = [head + literal(inner, depth + 1) for head, inner in value.entries()]
    if isinstance(value, Rows):
        rows = "".join(f"{INDENT * (depth + 1)}{piece},\n" for piece in pieces)
        return f"{first}\n{rows}{INDENT * depth}{last}"
    return f"{first} {', '.join(pieces)} {last}" if pieces else first + last


def _scalar(value: object) -> str:
    if isinstance(value, Name):
        return str(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, str):
        return _quoted(value)
    raise TypeError(f"{value!r} cannot be written in Lua")


_ESCAPES = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\r": "\\r", "\0": "\\0"}


def _quoted(text: str) -> str:
    return '"' + "".join(_ESCAPES.get(letter, letter) for letter in text) + '"'
