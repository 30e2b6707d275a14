"""The program image (.rbf): sign, versions, kinds of objects, the codes of parameters, how memory is laid out."""

from __future__ import annotations

from enum import StrEnum

from ev3proto.tables.declaration import DATA8, DATA16, DATA32, DATAF, STRING, Direction, Type

SIGN = b"LEGO"
"""What every image starts with."""

DEFAULT_VERSION = 0x6D
"""The version that an image gets unless the user says another: byte code 1.09. The machine does not depend on it."""

RELEASE_VERSION = 0x68
"""The version of the release of 2013, whose validator does not know the newer commands."""

OLD_VERSIONS = range(1, RELEASE_VERSION)
"""Versions that the validator objects to, and accepts all the same."""

VERSIONS = {
    0x00: "EV3 Classroom",
    0x39: "EV3-G",
    RELEASE_VERSION: "the release of 2013, EV3-Basic",
    DEFAULT_VERSION: "the sources of release 1.09",
}
"""Who writes which version, as far as that is known."""

MAX_OBJECTS = 0xFFFF
"""Objects that the header can count; their numbers start at 1."""

MAX_MEMORY = 0xFFFFFFFF
"""Bytes of globals or locals that a header can ask for."""

MAX_PARAMETERS = 0xFF
"""Parameters that a subcall can declare: their number is one byte."""


class ObjectKind(StrEnum):
    """What an object is. Its header tells: an owner makes a block, one trigger a subcall, all others are threads."""

    THREAD = "vmthread"
    SUBCALL = "subcall"
    BLOCK = "block"


def kind_of(owner: int, triggers: int) -> ObjectKind:
    """The kind of an object with that owner and number of triggers."""
    if owner:
        return ObjectKind.BLOCK
    return ObjectKind.SUBCALL if triggers == 1 else ObjectKind.THREAD


STRING_CODE = 4
"""The low bits of the code of a parameter that is a string, which is followed by a byte of size."""

PARAMETER_CODES: dict[int, Type] = {0: DATA8, 1: DATA16, 2: DATA32, 3: DATAF, STRING_CODE: STRING}
"""The low bits of a parameter's code. A handle is declared as 16 bits."""

PARAMETER_DIRECTIONS = {(True, False): Direction.IN, (False, True): Direction.OUT, (True, True): Direction.INOUT}
"""By the bits "in" (0x80) and "out" (0x40) of a parameter's code."""

ALIGNED_SIZES = (2, 4)
"""A variable of so many bytes in all, whatever its type, starts at a multiple of that; all others at the next byte."""


def aligned(offset: int, size: int) -> int:
    """The offset, at or after the given one, where a variable of that many bytes in all starts."""
    return -(-offset // size) * size if size in ALIGNED_SIZES else offset
