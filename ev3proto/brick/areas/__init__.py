"""What every operation does, one function an operation, in files by the firmware's areas.

Importing this package registers them all. A new file is imported here.
"""

from ev3proto.brick.areas import (
    arrays,
    branch,
    buttons,
    com,
    compare,
    drawing,
    filenames,
    files,
    info,
    interface,
    logs,
    mailboxes,
    math,
    memory,
    move,
    ports,
    programs,
    sound,
    strings,
    tests,
    timers,
)

__all__ = [
    "arrays",
    "branch",
    "buttons",
    "com",
    "compare",
    "drawing",
    "filenames",
    "files",
    "info",
    "interface",
    "logs",
    "mailboxes",
    "math",
    "memory",
    "move",
    "ports",
    "programs",
    "sound",
    "strings",
    "tests",
    "timers",
]
