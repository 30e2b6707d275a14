"""Numbers of ports and names of notes, as LEGO's editor writes them."""

from __future__ import annotations

from ev3proto.brick.conversions import wrap8
from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.operations.math import quotient
from ev3proto.brick.places import Place
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.notes import NOTES, OTHER_NOTE


def _digit(number: int, place: int) -> int:
    """A decimal digit, with the number's sign as in C; `place` 1 is the last digit, 10 the one before it."""
    shifted = quotient(number, place)
    return shifted - quotient(shifted, 10) * 10


def _layer(port: int) -> int:
    return max(0, _digit(port, 100) - 1)


def _bit(digit: int) -> int:
    """The bit of a motor port, counted from 1. A shift by a negative number gives 0 on the brick's processor."""
    return wrap8(1 << digit - 1) if digit > 0 else 0


@handles("PORT_CNV_INPUT")
def convert_input(_: Machine, port: int, layer: Place, port_out: Place) -> None:
    """Hundreds: the layer; the last digit: the port."""
    layer.write8(_layer(port))
    port_out.write8(_digit(port, 1) - 1)


@handles("PORT_CNV_OUTPUT")
def convert_output(_: Machine, port: int, layer: Place, bits: Place, inverted: Place) -> None:
    """Hundreds: the layer; then one or two ports."""
    first, second = _bit(_digit(port, 10)), _bit(_digit(port, 1))
    layer.write8(_layer(port))
    bits.write8(first | second)
    inverted.write8(first > second)


@handles("NOTE_TO_FREQ")
def note_to_frequency(_: Machine, note: bytes, frequency: Place) -> None:
    """In Hz; 440 for what is no note."""
    frequency.write16(NOTES.get(note.decode(STRING_CODING), OTHER_NOTE))
