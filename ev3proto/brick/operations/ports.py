"""Numbers of ports and names of notes, as LEGO's editor writes them."""

from __future__ import annotations

from ev3proto.brick.conversions import quotient, wrap8
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.machine import Machine
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.notes import NOTES, OTHER_NOTE


def _digit(number: int, place: int) -> int:
    """Returns a decimal digit, with the number's sign as in C; `place` 1 is the last digit, 10 the one before it."""
    shifted = quotient(number, place)
    return shifted - quotient(shifted, 10) * 10


def _layer(port: int) -> int:
    return max(0, _digit(port, 100) - 1)


def _bit(digit: int) -> int:
    """Returns the bit of a motor port, counted from 1; 0 for port 0, as a negative shift gives on the brick."""
    return wrap8(1 << digit - 1) if digit > 0 else 0


@handles("PORT_CNV_OUTPUT", computes=True)
def convert_output(_: Machine, port: int) -> tuple[int, int, bool]:
    """Returns the layer (the hundreds), the bits of one or two ports, and whether they are in reverse order."""
    first, second = _bit(_digit(port, 10)), _bit(_digit(port, 1))
    return _layer(port), first | second, first > second


computes(
    {
        # Hundreds: the layer; the last digit: the port.
        "PORT_CNV_INPUT": lambda _, port: (_layer(port), _digit(port, 1) - 1),
        # In Hz; 440 for an unknown note.
        "NOTE_TO_FREQ": lambda _, note: NOTES.get(note.decode(STRING_CODING), OTHER_NOTE),
    }
)
