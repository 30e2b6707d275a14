"""The program image (.rbf): magic bytes, versions, kinds of objects, codes of parameters, memory layout."""

from __future__ import annotations

from enum import StrEnum

from ev3proto.tables.declaration import DATA8, DATA16, DATA32, DATAF, STRING, Direction, Type

SIGN = b"LEGO"
"""The magic bytes at the start of every image."""

DEFAULT_VERSION = 0x6D
"""The default version of an image: byte code 1.09. The virtual machine ignores it."""

RELEASE_VERSION = 0x68
"""The version of the release of 2013, whose validator does not know the newer commands."""

OLD_VERSIONS = range(1, RELEASE_VERSION)
"""Versions that the validator complains about, but accepts."""

VERSIONS = {
    0x00: "EV3 Classroom",
    0x39: "EV3-G",
    RELEASE_VERSION: "the release of 2013, EV3-Basic",
    DEFAULT_VERSION: "the sources of release 1.09",
}
"""The known writers of each version."""

MAX_IMAGE = 1 << 22
"""Maximum size of an image that is read, in bytes; the flash memory of a brick has 16 MiB for all files."""

MAX_OBJECTS = 0xFFFF
"""Maximum number of objects that the header can count; their numbers start at 1."""

MAX_MEMORY = 0xFFFFFFFF
"""Maximum size of globals or locals that a header can request, in bytes."""

MAX_PARAMETERS = 0xFF
"""Maximum number of parameters of a subcall: their count is one byte."""


class ObjectKind(StrEnum):
    """The kind of an object, by its header: with an owner a block, with one trigger a subcall, else a thread."""

    THREAD = "vmthread"
    SUBCALL = "subcall"
    BLOCK = "block"


def kind_of(owner: int, triggers: int) -> ObjectKind:
    """Returns the kind of an object with that owner and number of triggers."""
    if owner:
        return ObjectKind.BLOCK
    return ObjectKind.SUBCALL if triggers == 1 else ObjectKind.THREAD


STRING_CODE = 4
"""The low bits of the code of a string parameter; a byte with its size follows."""

PARAMETER_CODES: dict[int, Type] = {0: DATA8, 1: DATA16, 2: DATA32, 3: DATAF, STRING_CODE: STRING}
"""The low bits of a parameter's code. A handle is declared as 16 bits."""

PARAMETER_DIRECTIONS = {(True, False): Direction.IN, (False, True): Direction.OUT, (True, True): Direction.INOUT}
"""The direction by the bits "in" (0x80) and "out" (0x40) of a parameter's code."""

ALIGNED_SIZES = (2, 4)
"""Variables of these total sizes, of any type, start at a multiple of their size; all others at the next byte."""


def aligned(offset: int, size: int) -> int:
    """Returns the first offset, from the given one on, where a variable of that total size can start."""
    return -(-offset // size) * size if size in ALIGNED_SIZES else offset
