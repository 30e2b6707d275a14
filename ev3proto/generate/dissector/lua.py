"""Lua values in a readable layout: on one line if they fit, else one entry a line."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

WIDTH = 120
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
            yield (f"{key} = " if isinstance(key, str) else f"[{key}] = "), value


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


def literal(value: object, depth: int = 0, used: int = 0) -> str:
    """Writes a whole number, a text, a truth value, a `Name` or a `Table` as Lua, at a depth of indentation."""
    if isinstance(value, Table):
        return _table(value, depth, used)
    return _scalar(value)


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


def _on_one_line(table: Table) -> str:
    pieces = [
        head + (_on_one_line(value) if isinstance(value, Table) else _scalar(value)) for head, value in table.entries()
    ]
    first, last = table.brackets
    return f"{first} {', '.join(pieces)} {last}" if pieces else first + last


def _table(table: Table, depth: int, used: int) -> str:
    line = _on_one_line(table)
    if used + len(line) <= WIDTH:
        return line
    first, last = table.brackets
    return f"{first}\n" + "".join(f"{row}\n" for row in _rows(table, depth + 1)) + INDENT * depth + last


def _rows(table: Table, depth: int) -> Iterator[str]:
    """Yields the lines inside a long table: plain values fill lines, each table has its own."""
    margin = INDENT * depth
    row = margin
    for head, value in table.entries():
        if isinstance(value, Table):
            if row.strip():
                yield row.rstrip()
                row = margin
            yield margin + head + literal(value, depth, len(margin + head) + 1) + ","
            continue
        piece = f"{head}{_scalar(value)},"
        if row.strip() and len(row) + len(piece) > WIDTH:
            yield row.rstrip()
            row = margin
        row += piece + " "
    if row.strip():
        yield row.rstrip()
