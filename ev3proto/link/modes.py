"""When a direct command asks for a reply, and when a program waits for it: the three modes of the lessons."""

from __future__ import annotations

from enum import StrEnum
from typing import NamedTuple


class SyncMode(StrEnum):
    """How commands and program go together.

    STD    asks for a reply where there is global memory, and waits for it
    ASYNC  asks for a reply where there is global memory, and waits only when the program asks for it
    SYNC   asks for a reply always, and waits for it: the brick has done everything when the program goes on
    """

    STD = "STD"
    ASYNC = "ASYNC"
    SYNC = "SYNC"

    @classmethod
    def of(cls, name: str) -> SyncMode:
        """The mode of that name. Raises ValueError for any other."""
        try:
            return cls(name)
        except ValueError:
            raise ValueError(f"sync_mode must be one of {', '.join(cls)}, not {name!r}") from None


class Plan(NamedTuple):
    """What becomes of one command.

    asks   it asks for a reply
    waits  the program waits for that
    """

    asks: bool
    waits: bool


def plan(mode: SyncMode, has_globals: bool) -> Plan:
    """What a mode makes of a command.

    Args:
        mode: The mode.
        has_globals: Whether the command has any global memory for the brick to write to.
    """
    asks = has_globals or mode is SyncMode.SYNC
    return Plan(asks, asks and mode is not SyncMode.ASYNC)
