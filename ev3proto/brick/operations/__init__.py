"""The operations, one function each, in files by the firmware's areas.

Importing this package registers all of them. A new file is imported here.
"""

from ev3proto.brick.operations import (  # noqa: F401 - registers the handlers
    arrays,
    branch,
    buttons,
    com,
    dialogues,
    drawing,
    factory_tests,
    filenames,
    files,
    info,
    inputs,
    interface,
    logs,
    mailboxes,
    math,
    memory,
    move,
    outputs,
    ports,
    programs,
    sound,
    strings,
    timers,
    without_effect,
)
