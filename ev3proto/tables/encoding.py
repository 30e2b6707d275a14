"""The encodings of values in a frame: the 256 identification bytes, and the numbers that each type can hold.

`ev3proto.schema.wire_format` declares the bits of an identification byte in Construct; a test compares all 256. Ranges
omit the one value that means "not a number".
"""

from itertools import product
from typing import NamedTuple

from ev3proto.tables.declaration import Parameter, Type

CONSTANT, TEXT, LOCAL, GLOBAL, JUMP = "constant", "string", "local", "global", "label"
"""The kinds of argument."""

LONG_BIT = 0x80
"""The value is in the bytes that follow; without it, in the lowest five bits."""

VARIABLE_BIT = 0x40
GLOBAL_BIT = 0x20
"""Of a variable: in global memory, not in local memory. Of a long constant: a label."""

HANDLE_BIT = 0x10
ADDRESS_BIT = 0x08


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

    @property
    def letter(self) -> str:
        """The letter that `struct` has for the number that follows; empty if none does."""
        letter = {1: "b", 2: "h", 4: "i"}.get(self.width or 0, "")
        return letter.upper() if self.kind in (LOCAL, GLOBAL) else letter


class Identification(NamedTuple):
    """A run of identification bytes with one encoding.

    first, last  the bytes, both included
    encoding     what they mean
    value        of short forms: the value in the byte `first`; the next byte has the next value
    """

    first: int
    last: int
    encoding: Encoding
    value: int | None = None


_SHORT_FORMS = (
    Identification(0x00, 0x1F, Encoding("LC0", CONSTANT, 0), 0),
    Identification(0x20, 0x3F, Encoding("LC0", CONSTANT, 0), -32),
    Identification(0x40, 0x5F, Encoding("LV0", LOCAL, 0), 0),
    Identification(0x60, 0x7F, Encoding("GV0", GLOBAL, 0), 0),
)

_LONG_FORMS = (
    Identification(0x80, 0x80, Encoding("LCS_OLD", TEXT, None)),
    Identification(0x81, 0x81, Encoding("LC1", CONSTANT, 1)),
    Identification(0x82, 0x82, Encoding("LC2", CONSTANT, 2)),
    Identification(0x83, 0x83, Encoding("LC4", CONSTANT, 4)),
    Identification(0x84, 0x84, Encoding("LCS", TEXT, None)),
    Identification(0xA0, 0xA7, Encoding("LAB1", JUMP, 1)),
    Identification(0xC1, 0xC1, Encoding("LV1", LOCAL, 1)),
    Identification(0xC2, 0xC2, Encoding("LV2", LOCAL, 2)),
    Identification(0xC3, 0xC3, Encoding("LV4", LOCAL, 4)),
    Identification(0xE1, 0xE1, Encoding("GV1", GLOBAL, 1)),
    Identification(0xE2, 0xE2, Encoding("GV2", GLOBAL, 2)),
    Identification(0xE3, 0xE3, Encoding("GV4", GLOBAL, 4)),
)
"""Each also exists with the handle bit, the address bit, or both. The firmware ignores the lowest bits of a label's."""


def _with_bits(row: Identification, handle: bool, address: bool) -> Identification:
    bits = HANDLE_BIT * handle | ADDRESS_BIT * address
    return Identification(row.first | bits, row.last | bits, row.encoding._replace(handle=handle, address=address))


IDENTIFICATIONS = (
    *_SHORT_FORMS,
    *sorted(_with_bits(*each) for each in product(_LONG_FORMS, (False, True), (False, True))),
)
"""All defined identification bytes, in order."""

_BY_BYTE = {byte: row for row in IDENTIFICATIONS for byte in range(row.first, row.last + 1)}

ENCODING_TEXTS = {
    "LC0": ("A number of -32 to 31 in one byte", "00 to 1F are 0 to 31, 20 to 3F are -32 to -1"),
    "LC1": ("A number of -127 to 127 in two bytes", "the number follows: 75 is 81 4B, -100 is 81 9C"),
    "LC2": ("A number of -32767 to 32767 in three bytes", "the number follows, low byte first: 440 is 82 B8 01"),
    "LC4": (
        "A number or a float in five bytes",
        "the number follows, low byte first: 100000 is 83 A0 86 01 00; a float is the bytes of an IEEE single",
    ),
    "LCS": ("A text", "its characters follow in ISO-8859-1, then a zero: hi is 84 68 69 00"),
    "LCS_OLD": ("A text, in a form that no program should send", "LCS, 84, means the same"),
    "LV0": ("A variable in the first 32 bytes of local memory", "40 to 5F are LV(0) to LV(31)"),
    "LV1": ("A variable in the first 256 bytes of local memory", "its place follows: LV(40) is C1 28"),
    "LV2": ("A variable in local memory", "its place follows in two bytes, low byte first"),
    "LV4": ("A variable in local memory", "its place follows in four bytes, low byte first"),
    "GV0": (
        "A variable in the first 32 bytes of global memory, which the reply carries",
        "60 to 7F are GV(0) to GV(31)",
    ),
    "GV1": (
        "A variable in the first 256 bytes of global memory, which the reply carries",
        "its place follows: GV(40) is E1 28",
    ),
    "GV2": ("A variable in global memory, which the reply carries", "its place follows in two bytes, low byte first"),
    "GV4": ("A variable in global memory, which the reply carries", "its place follows in four bytes, low byte first"),
    "LAB1": ("A label, the target of a jump", "its number, 1 to 31, follows: label 1 is A0 01"),
}
"""What an encoding is, and the bytes that it has, by its name."""

ENCODINGS = tuple(_BY_BYTE[byte].encoding if byte in _BY_BYTE else None for byte in range(0x100))
"""The encoding of each of the 256 bytes; None if it is undefined."""

SHORT = tuple((row.encoding, row.value + byte - row.first) for byte, row in _BY_BYTE.items() if row.value is not None)
"""Short forms by their only byte (0 to 127): encoding and value."""

SIZES = bytes(0 if encoding is None or encoding.width is None else 1 + encoding.width for encoding in ENCODINGS)
"""The size of an argument in bytes by its identification byte, which is included. 0 for strings, which end at their
zero, and for undefined bytes."""

STRINGS = frozenset(byte for byte, row in _BY_BYTE.items() if row.encoding.kind == TEXT)
"""The identification bytes of strings."""


class NumberRange(NamedTuple):
    """The numbers of a type, both ends included, and the bit pattern that means "not a number"."""

    low: int
    high: int
    nan: int


RANGES = {
    Type.DATA8: NumberRange(-127, 127, -128),
    Type.DATA16: NumberRange(-32767, 32767, -32768),
    Type.DATA32: NumberRange(-2147483647, 2147483647, -2147483648),
    Type.HANDLE: NumberRange(-32767, 32767, -32768),
    Type.ARRAY_TYPED: NumberRange(-2147483647, 2147483647, -2147483648),
    Type.LABEL: NumberRange(-2147483647, 2147483647, -2147483648),
}
"""The valid integer constants of each type. A label is a number 0 to 31 or a jump."""

COUNTS = NumberRange(0, 127, -128)
"""The valid counts of a list that has its own: a count fits a signed byte."""


def limits_of(parameter: Parameter) -> NumberRange | None:
    """Returns the integer constants that the argument of a parameter can be; None if it is not a whole number."""
    return COUNTS if parameter.counts else RANGES.get(parameter.type)


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
