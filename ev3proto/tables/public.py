"""What `proxy --hide` shows: the operations whose numbers are public. Nothing else is.

Texts and lists are public where their parameter has Role.PUBLIC. Operations that move, compute or compare values are
not here, as a text can be put together from their constants, byte by byte; nor are those that may leave an output as it
was.
"""

from __future__ import annotations

from fnmatch import fnmatchcase
from functools import cache
from typing import NamedTuple


class Public(NamedTuple):
    """Operations whose numbers say nothing about their owner.

    names   patterns of their names, separated by blanks
    reason  what the numbers are
    """

    names: str
    reason: str


PUBLIC = (
    Public("NOP OBJECT_END SLEEP", "They have none."),
    Public("TIMER_WAIT TIMER_READY TIMER_READ TIMER_READ_US", "Times."),
    Public("SOUND.TONE SOUND.BREAK SOUND.PLAY SOUND.REPEAT SOUND_TEST SOUND_READY", "Volumes, frequencies, times."),
    Public("OUTPUT_*", "Ports, speeds, counts and times of motors."),
    Public("INPUT_DEVICE_LIST", "Types of devices."),
    Public(
        "INPUT_TEST INPUT_READY INPUT_READ INPUT_READSI INPUT_DEVICE.GET_* INPUT_DEVICE.READY_*"
        " INPUT_DEVICE.CLR_* INPUT_DEVICE.STOP_ALL",
        "Ports, types, modes and values of sensors and motors.",
    ),
    Public(
        "UI_READ.GET_VBATT UI_READ.GET_IBATT UI_READ.GET_TBATT UI_READ.GET_IINT UI_READ.GET_IMOTOR UI_READ.GET_LBATT"
        " UI_READ.GET_WARNING UI_READ.GET_SDCARD UI_READ.GET_USBSTICK",
        "The battery, the state of the brick.",
    ),
    Public("UI_READ.GET_*_VERS UI_READ.GET_*_BUILD UI_READ.GET_VERSION", "Lengths of public texts."),
    Public("UI_BUTTON.*", "Buttons and their states."),
    Public("UI_WRITE.LED UI_WRITE.SET_BUSY UI_WRITE.TERMINAL UI_WRITE.WRITE_FLUSH UI_FLUSH", "Lights, and states."),
    Public("UI_DRAW.*", "Places, colours, sizes and icons."),
    Public("INFO.GET_VOLUME INFO.SET_VOLUME INFO.GET_MINUTES INFO.SET_MINUTES INFO.ERRORTEXT", "Settings, errors."),
    Public("MEMORY_USAGE", "Sizes of memory."),
    Public(
        "COM_GET.GET_ON_OFF COM_GET.GET_VISIBLE COM_GET.GET_PRESENT COM_GET.*_ITEMS COM_GET.GET_MODE2"
        " COM_GET.GET_RESULT",
        "States of radios, and how many connections there are.",
    ),
)
"""The first row that matches an operation is its own."""


@cache
def public_of(name: str) -> Public | None:
    """Returns the row of an operation; None if its numbers are hidden."""
    return next((row for row in PUBLIC if any(fnmatchcase(name, each) for each in row.names.split())), None)
