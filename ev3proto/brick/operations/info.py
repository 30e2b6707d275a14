"""INFO and KEEP_ALIVE: the log of errors, the volume, the time after which the brick switches off."""

from __future__ import annotations

from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.places import Place
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.errors import ERRORS

NUMBER_ROOM = 10
"""Elements of an array for the text of an error that has no name."""

NO_ERROR_ROOM = 26
"""Elements of an array for the empty text of no error, where no length is given."""


@handles("INFO.SET_ERROR")
def set_error(vm: Machine, number: int) -> None:
    """Number 0 is ignored; the log holds seven, further ones are dropped."""
    vm.brick.settings.log_error_number(number)


@handles("INFO.GET_ERROR")
def get_error(vm: Machine, number: Place) -> None:
    """The oldest one, which is taken out; 0 when there is none."""
    errors = vm.brick.settings.errors
    number.write8(errors.pop(0) if errors else 0)


@handles("INFO.ERRORTEXT")
def error_text(vm: Machine, number: int, length: int, destination: Place) -> None:
    """The name of an error; of one without a name, its number, for which an array gets ten elements at most.

    The text is empty where the length is 0. No error and a length of -1 give an array 26 elements.
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


@handles("INFO.GET_VOLUME")
def get_volume(vm: Machine, value: Place) -> None:
    """In percent."""
    value.write8(vm.brick.settings.volume)


@handles("INFO.SET_VOLUME")
def set_volume(vm: Machine, value: int) -> None:
    """Any byte is kept."""
    vm.brick.settings.volume = value


@handles("INFO.GET_MINUTES", "KEEP_ALIVE")
def get_minutes(vm: Machine, value: Place) -> None:
    """The brick never switches itself off, so KEEP_ALIVE has nothing to reset."""
    value.write8(vm.brick.settings.minutes)


@handles("INFO.SET_MINUTES")
def set_minutes(vm: Machine, value: int) -> None:
    """Any byte is kept."""
    vm.brick.settings.minutes = value
