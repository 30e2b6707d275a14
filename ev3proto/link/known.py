"""What a brick has answered about its ports, its files and its memory, on which it depends whether a command reads."""

from __future__ import annotations

from collections.abc import Container, Mapping
from dataclasses import dataclass, field

from ev3proto.messages import Argument
from ev3proto.tables.encoding import GLOBAL
from ev3proto.tables.enumerations import TYPE

_NONE = TYPE.members["TYPE_NONE"]


@dataclass(frozen=True)
class Known:
    """The facts about a brick."""

    types: Mapping[tuple[int, int], int] = field(default_factory=dict)  # of devices, by layer and port
    files: Container[bytes] = ()  # paths of files that exist
    memory: bytes = b""  # global memory of direct commands
    is_assumed: bool = False  # nothing was asked: every type and file is as a command says

    def has_type(self, port: tuple[int, int] | None, number: int) -> bool:
        """Returns whether a device is of this type; an empty port stays empty, whatever type a command gives."""
        return self.is_assumed or (port is not None and self.types.get(port) in (number, _NONE))

    def has_file(self, path: bytes | None) -> bool:
        """Returns whether there is such a file."""
        return self.is_assumed or path in self.files

    def memory_at(self, argument: Argument) -> int | None:
        """Returns the byte of global memory that an argument names; None if it is unknown."""
        at = argument.value
        if self.is_assumed:
            return 0
        is_known = argument.kind == GLOBAL and isinstance(at, int) and at < len(self.memory)
        return self.memory[at] if is_known and isinstance(at, int) else None


NOTHING = Known()
"""Nothing was asked."""

ASSUMED = Known(is_assumed=True)
"""Everything is as commands say: for plans, without a brick."""
