"""Every system command as a function: `system.list_files("/home/root/lms2012/sys/")`, and files cut into commands.

Names are the firmware's in lower case; those of the bootloader are in `system.bootloader`. A path comes first, lengths
are worked out, and as much is asked for at a time as a reply can carry. All are made from the tables when they are
first asked for; `download` and `pieces` are those that make several commands. What editors and type checkers see
stands in the .pyi file, which is written from the same tables.
"""

from typing import Any

from ev3proto.system.making import SystemCommands
from ev3proto.system.moving import download, pieces

__all__ = ["download", "pieces"]

_COMMANDS = SystemCommands()


def __getattr__(name: str) -> Any:
    """The function for a system command."""
    value = globals()[name] = getattr(_COMMANDS, name)
    return value


def __dir__() -> list[str]:
    return sorted([*__all__, *dir(_COMMANDS)])
