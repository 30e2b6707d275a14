"""The table of parameters at the start of a subcall: bytes to declarations and back."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

from ev3proto.errors import BuildError, DecodeError
from ev3proto.program.header import PARAMETER_CODE
from ev3proto.tables.declaration import DATA8, Direction, Type
from ev3proto.tables.program import MAX_PARAMETERS, PARAMETER_CODES, PARAMETER_DIRECTIONS, STRING_CODE


@cache
def _parsed(code: int) -> tuple[Direction, Type | None]:
    found = PARAMETER_CODE.parse(bytes((code,)))
    known = None if found.reserved else PARAMETER_CODES.get(found.type)
    return PARAMETER_DIRECTIONS.get((found.is_in, found.is_out), Direction.IN), known


def direction_of(code: int) -> Direction:
    """Returns the direction of a parameter with that code; IN if the code has none."""
    return _parsed(code)[0]


def type_of(code: int) -> Type:
    """Returns the type of a parameter with that code; DATA8 if the code has none."""
    return _parsed(code)[1] or DATA8


@cache
def has_size(code: int) -> bool:
    """Returns whether a size byte follows the code, as for strings."""
    return bool(PARAMETER_CODE.parse(bytes((code,))).type == STRING_CODE)


def code_of(direction: Direction, kind: Type) -> int:
    """Returns the code of a parameter."""
    is_in, is_out = next(bits for bits, one in PARAMETER_DIRECTIONS.items() if one is direction)
    number = next(number for number, one in PARAMETER_CODES.items() if one is kind)
    code: bytes = PARAMETER_CODE.build({"is_in": is_in, "is_out": is_out, "reserved": 0, "type": number})
    return code[0]


@dataclass(frozen=True, slots=True)
class ProgramParameter:
    """A parameter that a subcall declares.

    code  the byte in the image: direction and type
    size  of a string: the byte after it, its size modulo 256; else None
    """

    code: int
    size: int | None = None

    @property
    def type(self) -> Type:
        """DATA8, DATA16 (also for a handle), DATA32, DATAF or STRING; DATA8 if the code has no type."""
        return type_of(self.code)

    @property
    def direction(self) -> Direction:
        """The direction of its value; IN for a code with neither direction."""
        return direction_of(self.code)

    @property
    def bytes(self) -> int:
        """Its bytes in local memory; modulo 256 for a string of 256 bytes or more."""
        return self.type.size if self.size is None else self.size


def read_table(data: bytes, at: int, end: int) -> tuple[tuple[ProgramParameter, ...], int]:
    """Returns the parameters that a subcall declares, and the offset after their table. Raises DecodeError."""
    start = at
    count = data[at] if at < end else None
    at += 1
    found: list[ProgramParameter] = []
    while count is not None and len(found) < count and at < end:
        code = data[at]
        if not has_size(code):
            found.append(ProgramParameter(code))
            at += 1
        elif at + 1 < end:
            found.append(ProgramParameter(code, data[at + 1]))
            at += 2
        else:
            break
    if count is None or len(found) < count:
        said = "its number of parameters is missing" if count is None else f"it should declare {count} parameters"
        raise DecodeError(start, f"the code of the subcall ends in its table of parameters: {said}", truncated=True)
    return tuple(found), at


def table_bytes(parameters: Sequence[ProgramParameter]) -> bytes:
    """Returns the table of parameters of a subcall. Raises BuildError if there are too many."""
    if len(parameters) > MAX_PARAMETERS:
        raise BuildError(f"a subcall cannot have {len(parameters)} parameters: at most {MAX_PARAMETERS}")
    table = bytearray((len(parameters),))
    for parameter in parameters:
        table.append(parameter.code)
        if has_size(parameter.code):
            table.append((parameter.size or 0) & 0xFF)
    return bytes(table)
