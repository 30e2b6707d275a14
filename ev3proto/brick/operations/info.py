"""INFO and KEEP_ALIVE: the log of errors, the volume, the time after which the brick switches off."""

from __future__ import annotations

from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.errors import ERRORS

NUMBER_ROOM = 10
"""Array size for the text of an error without a name."""

NO_ERROR_ROOM = 26
"""Default array size for an empty error text."""

computes(
    {
        # The oldest error, which is removed; 0 when there is none.
        "INFO.GET_ERROR": lambda vm: vm.brick.settings.errors.pop(0) if vm.brick.settings.errors else 0,
        "INFO.SET_ERROR": lambda vm, number: vm.brick.settings.log_error_number(number),
        # In percent, and in minutes; any byte is kept.
        "INFO.GET_VOLUME": lambda vm: vm.brick.settings.volume,
        "INFO.SET_VOLUME": lambda vm, percent: setattr(vm.brick.settings, "volume", percent),
        "INFO.GET_MINUTES": lambda vm: vm.brick.settings.minutes,
        "INFO.SET_MINUTES": lambda vm, minutes: setattr(vm.brick.settings, "minutes", minutes),
        # The virtual brick never switches itself off, so KEEP_ALIVE has nothing to reset.
        "KEEP_ALIVE": lambda vm: vm.brick.settings.minutes,
    }
)


@handles("INFO.ERRORTEXT")
def error_text(vm: Machine, number: int, length: int, destination: Location) -> None:
    """Writes the name of an error, or the number of one without a name; an array is resized to fit.

    The text is empty if the length is 0. An array gets at most ten elements for a number, and 26 for no error and a
    length of -1.
    """
    if number == 0 and length == -1 and destination.handle >= 0:
        if vm.resize(destination, NO_ERROR_ROOM):
            destination.write8(0)
        return
    if destination.handle < 0:
        destination.write8(0)
    elif number >= len(ERRORS):
        length = NUMBER_ROOM if length == -1 else min(length, NUMBER_ROOM)
    text = "" if number == 0 else ERRORS[number] if 0 < number < len(ERRORS) else f"Number {number:02d}"
    vm.write_limited(destination, text.encode(STRING_CODING), length)
