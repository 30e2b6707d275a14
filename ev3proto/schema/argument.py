"""One argument of an operation: an identification byte and its value, read and written for one declared parameter.

The meaning of each identification byte comes from the rows of `tables/encoding.py`.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Iterable
from typing import Any

from ev3proto.errors import BuildError, DecodeError, counted
from ev3proto.messages import Argument, Variable
from ev3proto.schema.reasons import unreadable
from ev3proto.tables.declaration import Direction, Parameter, Type
from ev3proto.tables.encoding import (
    ADDRESS_BIT,
    BITS,
    CONSTANT,
    ENCODINGS,
    GLOBAL,
    HANDLE_BIT,
    INDEX_RANGES,
    LOCAL,
    NAN_FLOAT,
    SHORT,
    SIZES,
    STRING_CODING,
    TEXT,
    Encoding,
    limits_of,
)

Form = tuple[Encoding, Callable[[bytes | bytearray, int], tuple[Any]] | None, int]
"""A long form: its encoding, the reader of its value (None for a string), its size with the identification byte."""

Reader = tuple[Parameter, tuple[Form | None, ...]]
"""A parameter, and the long forms of its arguments by their identification byte."""

_LONG = len(SHORT)
"""The lowest identification byte of a long form."""


def _long_form(encoding: Encoding | None, size: int, *, float_constants: bool) -> Form | None:
    if encoding is None or encoding.width == 0:
        return None
    if encoding.width is None:
        return encoding, None, 0
    is_float = float_constants and encoding.kind == CONSTANT and encoding.width == 4
    return encoding, struct.Struct("<xf" if is_float else f"<x{encoding.letter}").unpack_from, size


INTEGER_FORMS, _FLOAT_FORMS = (
    tuple(_long_form(encoding, size, float_constants=is_float) for encoding, size in zip(ENCODINGS, SIZES, strict=True))
    for is_float in (False, True)
)
"""Long forms by their identification byte, with constants of four bytes as whole numbers and as floats."""


def reader_of(parameter: Parameter) -> Reader:
    """Returns what `read_arguments` needs to know about a parameter."""
    return parameter, _FLOAT_FORMS if parameter.type is Type.DATAF else INTEGER_FORMS


def read_arguments(readers: Iterable[Reader], data: bytes, at: int, end: int, found: list[Argument]) -> int:
    """Reads one argument for each reader. All arguments of the package are read here.

    Args:
        readers: The readers of the expected arguments, in order.
        data: The bytes that contain the arguments.
        at: The offset of the first one.
        end: The end of the byte code.
        found: A list to which the arguments are added, even those before a fault.

    Returns:
        The offset after the last argument.

    Raises:
        DecodeError: An argument cannot be read. The error names its parameter and the reason.
    """
    for parameter, long_forms in readers:
        if at >= end:
            raise _unreadable(parameter, data, at, end)
        first = data[at]
        if first < _LONG:
            encoding, number = SHORT[first]
            found.append(Argument((parameter, encoding, number, at, data)))
            at += 1
            continue
        form = long_forms[first]
        if form is None:
            raise _unreadable(parameter, data, at, end)
        encoding, unpack, size = form
        if unpack is None:
            size = data.find(0, at + 1, end) + 1 - at
            if size <= 0:
                raise _unreadable(parameter, data, at, end)
            found.append(Argument((parameter, encoding, data[at + 1 : at + size - 1].decode(STRING_CODING), at, data)))
        else:
            if at + size > end:
                raise _unreadable(parameter, data, at, end)
            found.append(Argument((parameter, encoding, unpack(data, at)[0], at, data)))
        at += size
    return at


def _unreadable(parameter: Parameter, data: bytes, at: int, end: int) -> DecodeError:
    """Returns the error for a missing or unreadable argument at an offset."""
    name = parameter.name
    if at >= end:
        return unreadable(end, "no_argument", True, name=name)
    encoding = ENCODINGS[data[at]]
    if encoding is None:
        return unreadable(at, "no_form", byte=data[at], name=name)
    if encoding.width is None:
        return unreadable(at, "cut_string", True, name=name)
    more = counted(at + 1 + encoding.width - end, "more byte")
    return unreadable(at, "cut_argument", True, name=name, form=encoding.name, more=more)


class ArgumentSchema:
    """Reads and writes the arguments of one parameter."""

    def __init__(self, parameter: Parameter) -> None:
        self.parameter = parameter
        self.reader = reader_of(parameter)
        limits = None if parameter.direction is Direction.OUT else limits_of(parameter)
        self._numbers = range(0) if limits is None else range(limits.low, limits.high + 1)

    def read(self, data: bytes, at: int) -> tuple[Argument, int]:
        """Reads the argument at an offset.

        Args:
            data: The bytes that contain the argument.
            at: The offset of its identification byte.

        Returns:
            The argument, and the offset after it.

        Raises:
            DecodeError: There is no valid argument. The error names the parameter and the reason.
        """
        found: list[Argument] = []
        end = read_arguments((self.reader,), data, at, len(data), found)
        return found[0], end

    def write(self, value: Any) -> bytes:
        """Returns the shortest encoding of a value.

        Args:
            value: A number, a text, the name of an enumeration's member, a `Variable`, an `Argument` (its bytes are
                kept), or bytes that are one encoded argument.

        Raises:
            BuildError: The parameter cannot have the value. The message names it and the valid values.
        """
        if type(value) is int and value in self._numbers:
            return encode_integer(value)
        if isinstance(value, Argument):
            return value.raw
        if isinstance(value, bytes):
            return self._encoded(value)
        if isinstance(value, Variable):
            return encode_variable(value, self.parameter.name)
        if self.parameter.direction is Direction.OUT:
            raise BuildError(
                f"{self.parameter.name} is an output and cannot be {value!r}: use a variable such as GV(0) or LV(0)"
            )
        return self._constant(value)

    def _encoded(self, value: bytes) -> bytes:
        try:
            _, end = self.read(value, 0)
        except DecodeError as error:
            raise BuildError(f"{self.parameter.name}: {value!r} is not one encoded argument: {error.reason}") from None
        if end != len(value):
            raise BuildError(
                f"{self.parameter.name}: {value!r} is more than one encoded argument: the first ends after {end} bytes"
            )
        return value

    def _constant(self, value: Any) -> bytes:
        parameter = self.parameter
        if isinstance(value, str):
            return self._text(value)
        if not isinstance(value, int | float):
            raise BuildError(f"{parameter.name} cannot be {value!r}: it is a {parameter.label}")
        if parameter.type is Type.STRING:
            raise BuildError(f"{parameter.name} takes a string or a variable, not {value!r}")
        may_be_float = parameter.any_type or parameter.type is Type.ARRAY_TYPED
        if parameter.type is Type.DATAF or (may_be_float and isinstance(value, float)):
            return encode_float(value, parameter.name)
        return self._integer(value)

    def _text(self, value: str) -> bytes:
        parameter = self.parameter
        number = parameter.number_of(value)
        if number is not None:
            return encode_integer(number)
        if parameter.type is Type.ARRAY_TYPED and len(value) == 1:
            return encode_integer(encode_string(value, parameter.name)[1])
        if parameter.type is not Type.STRING and parameter.length is None and not parameter.any_type:
            expected = "a number"
            if parameter.enum is not None:
                expected = f"a name of {parameter.enum.name} or a number"
            elif parameter.names:
                expected = f"one of {', '.join(parameter.names)} or a number"
            raise BuildError(f"{parameter.name} takes {expected} or a variable, not {value!r}")
        return encode_string(value, parameter.name)

    def _integer(self, value: float) -> bytes:
        parameter = self.parameter
        limits = limits_of(parameter)
        assert limits is not None
        low, high = limits.low, BITS[parameter.type][-1] if parameter.unsigned else limits.high
        if limits.high < value <= high:
            value += 2 * limits.nan
        if (value != value and not parameter.unsigned) or value == limits.nan:
            return encode_as(_NAN_ENCODING.get(parameter.type.size, "LC4"), limits.nan)
        if not limits.low <= value <= limits.high or value != int(value):
            said = f"a {parameter.label} is a whole number from {low} to {high}"
            if parameter.range is not None:
                unit = f" {parameter.unit}" if parameter.unit else ""
                said = f"use {parameter.range[0]} to {parameter.range[1]}{unit}; {said}"
            raise BuildError(f"{parameter.name} cannot be {value}: {said}")
        return encode_integer(int(value))


def shortest(parameter: Parameter, value: Any) -> bytes:
    """Returns the shortest encoding of a value for a parameter, as `ArgumentSchema.write` chooses it."""
    return ArgumentSchema(parameter).write(value)


_BY_NAME = {
    (encoding.name, encoding.handle, encoding.address): byte
    for byte, encoding in reversed(list(enumerate(ENCODINGS)))
    if encoding is not None
}
"""The lowest identification byte of each encoding."""

LABEL_BYTE = _BY_NAME["LAB1", False, False]
"""The identification byte of a label."""

_NAN_ENCODING = {1: "LC1", 2: "LC2", 4: "LC4"}
"""The encoding in which a type's lowest number means "not a number", by the size of the type."""


_pack_1, _pack_2, _pack_4 = (struct.Struct(f"<B{letter}").pack for letter in "bhi")
_LC1, _LC2, _LC4 = (_BY_NAME[name, False, False] for name in ("LC1", "LC2", "LC4"))


def encode_integer(value: int) -> bytes:
    """Returns a number as the shortest constant: LC0, LC1, LC2 or LC4.

    Args:
        value: -2147483648 to 2147483647. The lowest numbers of 8 and of 16 bits mean "not a number", so they take
            the next width. The lowest of 32 bits always means "not a number".

    Returns:
        The identification byte and the value.

    Raises:
        BuildError: The number needs more than 32 bits.
    """
    if -32 <= value < 32:
        return bytes((value & 0x3F,))
    if -0x80 < value < 0x80:
        return _pack_1(_LC1, value)
    if -0x8000 < value < 0x8000:
        return _pack_2(_LC2, value)
    if -0x80000000 <= value < 0x80000000:
        return _pack_4(_LC4, value)
    raise BuildError(f"a constant cannot be {value}: the largest encoding, LC4, holds -2147483647 to 2147483647")


def encode_float(value: float, name: str = "the value") -> bytes:
    """Returns a float constant: an LC4 with an IEEE single. Raises BuildError beyond a single's range."""
    head = bytes((_LC4,))
    try:
        if math.isnan(value):
            return head + NAN_FLOAT
        return head + struct.pack("<f", value)
    except OverflowError:
        raise BuildError(f"{name} cannot be {value}: a DATAF is from -3.4028235e38 to 3.4028235e38") from None


def encode_string(value: str, name: str = "the string") -> bytes:
    """Returns a zero-terminated string (LCS). Raises BuildError for a zero or a character outside ISO-8859-1."""
    return bytes((_BY_NAME["LCS", False, False],)) + text_bytes(value, name) + b"\0"


def text_bytes(value: str, name: str, *, zeros: bool = False) -> bytes:
    """Returns the bytes of a text. Raises BuildError for a character outside ISO-8859-1, or a zero."""
    try:
        encoded = value.encode(STRING_CODING)
    except UnicodeEncodeError as error:
        raise BuildError(
            f"{name} cannot be {value!r}: the brick's strings are ISO-8859-1, which has no {value[error.start]!r}"
        ) from None
    if 0 in encoded and not zeros:
        raise BuildError(f"{name} cannot be {value!r}: a text cannot contain a zero, which ends it")
    return encoded


def encode_variable(variable: Variable, name: str = "the variable") -> bytes:
    """Returns the shortest form of a variable. Raises BuildError for an index below 0 or beyond 32 bits."""
    letter = "G" if variable.scope == GLOBAL else "L"
    for width, indexes in INDEX_RANGES.items():
        key = (f"{letter}V{width}", variable.handle, variable.address)
        if not isinstance(variable.index, int) or variable.index not in indexes or key not in _BY_NAME:
            continue
        head = _BY_NAME[key]
        if width == 0:
            return bytes((head | variable.index,))
        return bytes((head,)) + variable.index.to_bytes(width, "little")
    raise BuildError(f"{name} cannot be {variable}: an index is a whole number from 0 to 4294967295")


def encode_label(value: int, name: str = "the label") -> bytes:
    """Returns a label or short jump (LAB1): a signed byte. Raises BuildError outside -128 to 127."""
    if not -128 <= value <= 127:
        raise BuildError(f"{name} cannot be {value}: LAB1 holds -128 to 127")
    return bytes((LABEL_BYTE, value & 0xFF))


def with_bits(encoded: bytes, *, handle: bool = False, address: bool = False) -> bytes:
    """Returns a long argument with the handle or address bit set. Raises BuildError for short forms."""
    if not encoded or encoded[0] < len(SHORT):
        raise BuildError(f"{encoded!r} is a short form, without handle and address bits")
    return bytes((encoded[0] | HANDLE_BIT * handle | ADDRESS_BIT * address,)) + encoded[1:]


_PATTERNS = {width: range(-(1 << bits - 1), 1 << bits - 1) for width, bits in ((0, 6), (1, 8), (2, 16), (4, 32))}
"""The constants of each width, "not a number" among them."""


def encode_as(name: str, value: int | float | str) -> bytes:
    """Returns a value in any encoding by name: `encode_as("LC2", 5)`. Raises BuildError if it does not fit."""
    try:
        head = _BY_NAME[name, False, False]
    except KeyError:
        names = ", ".join(sorted({encoding.name for encoding in ENCODINGS if encoding}))
        raise BuildError(f"unknown encoding {name!r}: the encodings are {names}") from None
    encoding = ENCODINGS[head]
    assert encoding is not None
    if encoding.kind == TEXT:
        return bytes((head,)) + encode_string(str(value))[1:]
    if isinstance(value, float) and name == "LC4":
        return encode_float(value)
    if not isinstance(value, int):
        raise BuildError(f"{name} holds a whole number, not {value!r}")
    assert encoding.width is not None
    numbers = (INDEX_RANGES if encoding.kind in (LOCAL, GLOBAL) else _PATTERNS)[encoding.width]
    if value not in numbers:
        raise BuildError(f"{name} cannot hold {value}: it is limited to {numbers[0]} to {numbers[-1]}")
    if encoding.width == 0:
        return bytes((head | value & 0x3F,))
    return bytes((head,)) + struct.pack(f"<{encoding.letter}", value)
