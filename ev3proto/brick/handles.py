"""Handles of programs: arrays and blocks of memory. Open files share the numbering (`open_files.py`).

Each program slot counts for itself and gives the lowest free number. Number 0 is the program's own memory, so the
first array of a direct command is 1.
"""

from __future__ import annotations

from typing import TypeVar

from ev3proto.tables.declaration import Type

HANDLES = 250
"""Handles of one slot, the program's own memory included."""

NO_HANDLE = -1
"""The handle that programs get when none is left."""


class Array:
    """An array: elements of one type, in one buffer that keeps its identity when it is resized."""

    def __init__(self, type: Type, elements: int) -> None:
        self.type = type  # DATA8, DATA16, DATA32 or DATAF
        self.data = bytearray(elements * type.size)

    @property
    def elements(self) -> int:
        """Its number of elements."""
        return len(self.data) // self.type.size


Entry = TypeVar("Entry")


class HandleTable:
    """The handles of one slot."""

    def __init__(self) -> None:
        self._entries: dict[int, object] = {}

    def add(self, entry: object) -> int | None:
        """Adds an entry under the lowest free number. Returns the number; None if none is left."""
        number = 1
        while number in self._entries:
            number += 1
        if number >= HANDLES:
            return None
        self._entries[number] = entry
        return number

    def get(self, number: int, kind: type[Entry]) -> Entry | None:
        """Returns the entry of a number, if it is of that kind."""
        entry = self._entries.get(number)
        return entry if isinstance(entry, kind) else None

    def remove(self, number: int) -> object | None:
        """Frees a number and returns its entry; None for an unused number."""
        return self._entries.pop(number, None)

    def entries(self) -> list[object]:
        """Returns all entries."""
        return list(self._entries.values())

    def items(self) -> list[tuple[int, object]]:
        """Returns all entries with their numbers, in the order of the numbers."""
        return sorted(self._entries.items())
