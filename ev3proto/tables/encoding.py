"""The encodings of values in a frame, their widths, and the numbers that each type can hold.

The identification byte says which encoding follows; its bits are declared in `ev3proto.schema.argument`. Ranges
omit the one value that means "not a number".
"""

from typing import NamedTuple

from ev3proto.tables.declaration import Type

WIDTHS = {1: 1, 2: 2, 3: 4}
"""Width code of a long form (bits 0 to 2) to the bytes that follow the identification byte."""

STRING_OLD, STRING_ZERO = 0, 4
"""Width codes of the two string forms; both end at a zero, new senders use the second (LCS)."""

HANDLE_BIT = 0x10
ADDRESS_BIT = 0x08

CONSTANT, TEXT, LOCAL, GLOBAL, JUMP = "constant", "string", "local", "global", "label"
"""The kinds of argument."""


class Encoding(NamedTuple):
    """The meaning of one identification byte.

    name     LC0, LC1, LC2, LC4, LCS, LCS_OLD (the old string form), LV0 ..., GV0 ..., LAB1
    kind     constant, string, local, global or label
    width    bytes that follow the identification byte; None for a string, which ends at its zero
    handle   the value is a handle to a memory object
    address  the value is an absolute address
    """

    name: str
    kind: str
    width: int | None
    handle: bool = False
    address: bool = False

    def __str__(self) -> str:
        return self.name


class Range(NamedTuple):
    """The numbers of a type, both ends included, and the bit pattern that means "not a number"."""

    low: int
    high: int
    nan: int


RANGES = {
    Type.DATA8: Range(-127, 127, -128),
    Type.DATA16: Range(-32767, 32767, -32768),
    Type.DATA32: Range(-2147483647, 2147483647, -2147483648),
    Type.HANDLE: Range(-32767, 32767, -32768),
    Type.ARRAY_TYPED: Range(-2147483647, 2147483647, -2147483648),
    Type.LABEL: Range(-2147483647, 2147483647, -2147483648),
    Type.COUNT: Range(0, 127, -128),
}
"""The valid integer constants of each type. A label is a number 0 to 31 or a jump; a count fits a signed byte."""

BITS = {
    kind: range(RANGES[kind].nan, -2 * RANGES[kind].nan) for kind in (Type.DATA8, Type.DATA16, Type.DATA32, Type.HANDLE)
}
"""The constants of each type where only the bits count: each number with a sign, and the same bits read unsigned."""

CONSTANT_RANGES = {
    0: range(-32, 32),
    1: range(-0x7F, 0x80),
    2: range(-0x7FFF, 0x8000),
    4: range(-0x7FFFFFFF, 0x80000000),
}
"""The numbers that a constant can hold, by the bytes that follow the identification byte."""

INDEX_RANGES = {0: range(32), 1: range(0x100), 2: range(0x10000), 4: range(0x100000000)}
"""The indexes that a variable can have, by the bytes that follow the identification byte."""

NAN_FLOAT = b"\x00\x00\xc0\x7f"
"""The bytes of the float that means "not a number" (0x7FC00000)."""

STRING_CODING = "latin-1"
"""The brick shows its strings as ISO-8859-1; every byte but zero is allowed."""
