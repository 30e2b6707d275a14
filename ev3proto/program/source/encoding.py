"""Values to bytes as LEGO's assembler writes them: the encoding depends on the value alone."""

from __future__ import annotations

from functools import lru_cache

from ev3proto.program.source.names import ProgramVariable
from ev3proto.program.source.numbers import wrapped
from ev3proto.schema.argument import encode_as, encode_integer, with_bits
from ev3proto.tables.encoding import GLOBAL

_MOST_KEPT = 1 << 12
_LOWEST_SHORT = -32
_LARGEST = (1 << 31) - 1
_INDEX_STEPS = (("0", 32), ("1", 128), ("2", 32768))
JUMP_SIZES = {"LC0": 1, "LC1": 2, "LC2": 3, "LC4": 5, "LAB1": 2}
"""Bytes of a jump's distance by its encoding."""
_BY_SIZE = {1: "LC0", 2: "LC1", 3: "LC2", 5: "LC4"}
LABEL = "LC2"
"""The encoding in which the assemblers write every label."""

OLD_STRING = encode_as("LCS_OLD", "")[:1]
"""What a string starts with in a program."""


@lru_cache(_MOST_KEPT)
def integer(value: int) -> bytes:
    """A number in its shortest encoding. The lowest of a width takes the next one, -32 too.

    Args:
        value: -2147483648 to 4294967295; from 2147483648 on it is a pattern of 32 bits, LC4.
    """
    if not -_LARGEST <= value <= _LARGEST:
        return encode_as("LC4", wrapped(value))
    return encode_as("LC1", value) if value == _LOWEST_SHORT else encode_integer(value)


def long_float(bits: int) -> bytes:
    """The bits of a single as LC4, as EV3-G writes every float."""
    return encode_as("LC4", bits)


def string(data: bytes) -> bytes:
    """A string with its zero."""
    return OLD_STRING + data + b"\0"


@lru_cache(_MOST_KEPT)
def variable(scope: str, index: int) -> bytes:
    """A variable in its shortest encoding."""
    letter = "G" if scope == GLOBAL else "L"
    step = next((name for name, limit in _INDEX_STEPS if index < limit), "4")
    return encode_as(f"{letter}V{step}", index)


def marked(place: ProgramVariable, sign: str) -> bytes:
    """A variable that holds a handle (`@`) or an address (`&`): never in one byte."""
    letter = "G" if place.scope == GLOBAL else "L"
    step = next((name for name, limit in _INDEX_STEPS[1:] if place.index < limit), "4")
    return with_bits(encode_as(f"{letter}V{step}", place.index), handle=sign == "@", address=sign == "&")


def jump(distance: int, size: int) -> bytes:
    """A distance in so many bytes. BuildError where it does not fit."""
    return encode_as(_BY_SIZE[size], distance)


def shortest_jump(distance: int) -> int:
    """How many bytes the shortest encoding of a distance has."""
    return len(integer(distance))
