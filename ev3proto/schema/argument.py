"""One argument of an operation: an identification byte and what it announces, read for one declared parameter."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable
from typing import Any

from ev3proto.errors import BuildError, DecodeError
from ev3proto.messages import Argument, Variable
from ev3proto.schema.bytewise import Bytewise
from ev3proto.schema.identification import ENCODINGS, LABEL_BYTE, SHORT_VALUES
from ev3proto.tables.declaration import Direction, Parameter, Type
from ev3proto.tables.encoding import (
    ADDRESS_BIT,
    BITS,
    CONSTANT,
    CONSTANT_RANGES,
    GLOBAL,
    HANDLE_BIT,
    INDEX_RANGES,
    LOCAL,
    NAN_FLOAT,
    RANGES,
    STRING_CODING,
    TEXT,
    Encoding,
)

Unpack = Callable[[bytes, int], tuple[Any]]
Long = tuple[Encoding, Unpack | None, int]
Short = tuple[Encoding, int]
Reader = tuple[Parameter, tuple[Long | None, ...]]
"""A parameter, and how its long forms are read, by their identification byte."""

SIZES = bytes(0 if encoding is None or encoding.width is None else 1 + encoding.width for encoding in ENCODINGS)
"""Bytes of an argument by its identification byte, that byte included. 0 for strings, which end at their zero, and for
undefined bytes. `data.translate(SIZES)` has, for each byte, the size of the argument that would start there."""

STRINGS = frozenset(byte for byte, encoding in enumerate(ENCODINGS) if encoding is not None and encoding.kind == TEXT)
"""The identification bytes of strings."""

SHORT: tuple[Short, ...] = tuple(
    (encoding, value)
    for encoding, value in zip(ENCODINGS, SHORT_VALUES, strict=True)
    if encoding is not None and value is not None
)
"""Short forms by their only byte (0 to 127): encoding and value."""

_SIGNED = {1: "<xb", 2: "<xh", 4: "<xi"}
_UNSIGNED = {1: "<xB", 2: "<xH", 4: "<xI"}


def _long_forms(float_constants: bool) -> tuple[Long | None, ...]:
    forms: list[Long | None] = []
    for encoding, size in zip(ENCODINGS, SIZES, strict=True):
        if encoding is None or encoding.width == 0:
            forms.append(None)
        elif encoding.width is None:
            forms.append((encoding, None, 0))
        elif encoding.kind in (LOCAL, GLOBAL):
            forms.append((encoding, struct.Struct(_UNSIGNED[encoding.width]).unpack_from, size))
        elif float_constants and encoding.kind == CONSTANT and encoding.width == 4:
            forms.append((encoding, struct.Struct("<xf").unpack_from, size))
        else:
            forms.append((encoding, struct.Struct(_SIGNED[encoding.width]).unpack_from, size))
    return tuple(forms)


INTEGER_FORMS = _long_forms(float_constants=False)
"""Long forms by their identification byte, constants read as whole numbers."""

_FLOAT_FORMS = _long_forms(float_constants=True)


class _Integers(dict[int, bytes]):
    """The bytes of whole numbers as one parameter's argument. A number that was written before is only looked up.

    Most values are such numbers, and most programs use few of them. `operation()` takes 1.5 times as long without this:
    `pytest benchmarks -k compos`.
    """

    def __init__(self, schema: ArgumentSchema) -> None:
        super().__init__()
        self._schema = schema

    def __missing__(self, value: int) -> bytes:
        encoded = self._schema.write(value)
        if len(self) < _MOST_KEPT:
            self[value] = encoded
        return encoded


_MOST_KEPT = 1024
"""Numbers of one parameter whose bytes are kept."""


def reader_of(parameter: Parameter) -> Reader:
    """What is needed to read the arguments of a parameter."""
    return parameter, _FLOAT_FORMS if parameter.type is Type.DATAF else INTEGER_FORMS


class ArgumentSchema(Bytewise):
    """The schema of one parameter's argument."""

    def __init__(self, parameter: Parameter) -> None:
        super().__init__()
        self.parameter = parameter
        self.reader = reader_of(parameter)
        self.long_forms = self.reader[1]
        self.integers = _Integers(self)
        """The bytes of whole numbers."""

    def read(self, data: bytes, at: int) -> tuple[Argument, int]:
        """Reads the argument at an offset.

        Args:
            data: The bytes that the argument is in.
            at: The offset of its identification byte.

        Returns:
            The argument, and the offset after it.

        Raises:
            DecodeError: No argument can be read there. The error names the parameter and the reason.

        """
        end = self.measure(data, at, len(data))
        return self.read_measured(data, at, end), end

    def read_measured(self, data: bytes, at: int, end: int) -> Argument:
        """Reads the argument between two offsets that `measure` found.

        Args:
            data: The bytes that the argument is in.
            at: The offset of its identification byte.
            end: The offset after it.

        Returns:
            The argument.

        """
        first = data[at]
        if first < len(SHORT):
            encoding, short = SHORT[first]
            return Argument((self.parameter, encoding, short, at, data))
        form = self.long_forms[first]
        assert form is not None, "measure() lets no undefined identification byte pass"
        encoding, unpack, _ = form
        value = data[at + 1 : end - 1].decode(STRING_CODING) if unpack is None else unpack(data, at)[0]
        return Argument((self.parameter, encoding, value, at, data))

    def measure(self, data: bytes, at: int, limit: int) -> int:
        """The offset after the argument at an offset, where the contents end at `limit`. Raises DecodeError."""
        name = self.parameter.name
        if at >= limit:
            raise DecodeError(limit, f"the frame ends where the argument {name} should start", truncated=True)
        encoding = ENCODINGS[data[at]]
        if encoding is None:
            reason = f"0x{data[at]:02X} is no identification byte that the firmware defines (argument {name})"
            raise DecodeError(at, reason)
        if encoding.width is not None:
            end = at + 1 + encoding.width
            if end > limit:
                missing = end - limit
                raise DecodeError(
                    at,
                    f"the argument {name} runs past the end of the frame: {encoding.name} needs {missing} more"
                    f" byte{'s' * (missing > 1)}",
                    truncated=True,
                )
            return end
        end = data.find(0, at + 1, limit)
        if end < 0:
            raise DecodeError(
                at,
                f"the string {name} runs past the end of the frame: the zero that ends it is missing",
                truncated=True,
            )
        return end + 1

    def write(self, value: Any) -> bytes:
        """The shortest encoding of a value.

        Args:
            value: A number, a text, the name of an enumeration's member, a `Variable`, an `Argument` (its bytes as they
                are), or bytes that are one encoded argument.

        Raises:
            BuildError: The parameter cannot have the value. The sentence names it and what it takes.
        """
        if isinstance(value, Argument):
            return value.raw
        if isinstance(value, bytes):
            return self._encoded(value)
        if isinstance(value, Variable):
            return encode_variable(value, self.parameter.name)
        if self.parameter.direction is Direction.OUT:
            raise BuildError(
                f"{self.parameter.name} is an output, so {value!r} cannot stand there: it takes GV(0) or LV(0)"
            )
        return self._constant(value)

    def _encoded(self, value: bytes) -> bytes:
        try:
            end = self.measure(value, 0, len(value))
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
        if not isinstance(value, int | float):
            raise BuildError(f"{parameter.name} cannot be {value!r}: it is a {parameter.type}")
        if parameter.type is Type.STRING:
            raise BuildError(f"{parameter.name} takes a string or a variable, not {value!r}")
        may_be_float = parameter.any_type or parameter.type is Type.ARRAY_TYPED
        if parameter.type is Type.DATAF or (may_be_float and isinstance(value, float)):
            return encode_float(value, parameter.name)
        return self._integer(value)

    def _integer(self, value: float) -> bytes:
        parameter = self.parameter
        limits = RANGES[parameter.type]
        if parameter.unsigned and limits.high < value <= BITS[parameter.type][-1]:
            value += 2 * limits.nan
        if (value != value and not parameter.unsigned) or value == limits.nan:
            return encode_as(_NAN_ENCODING.get(parameter.type.size, "LC4"), limits.nan)
        if not limits.low <= value <= limits.high or value != int(value):
            raise BuildError(
                f"{parameter.name} cannot be {value}: a {parameter.type} is a whole number from {limits.low} to"
                f" {BITS[parameter.type][-1] if parameter.unsigned else limits.high}"
            )
        return encode_integer(int(value))


_BY_NAME = {
    (encoding.name, encoding.handle, encoding.address): byte
    for byte, encoding in reversed(list(enumerate(ENCODINGS)))
    if encoding is not None
}
"""The lowest identification byte of each encoding."""

_NAN_ENCODING = {1: "LC1", 2: "LC2", 4: "LC4"}
"""By the bytes of a type: the encoding in which its lowest number means "not a number"."""

_INDEX_LAYOUTS = {0: None, 1: "<B", 2: "<H", 4: "<I"}


_BYTES = tuple(
    bytes((value & 0x3F,)) if value in CONSTANT_RANGES[0] else struct.pack("<Bb", _BY_NAME["LC1", False, False], value)
    for value in CONSTANT_RANGES[1]
)
"""LC0 and LC1 for every number from -127 to 127."""

_LC1_MOST, _LC2_MOST = CONSTANT_RANGES[1][-1], CONSTANT_RANGES[2][-1]
_LC2, _LC4 = (struct.pack("<B", _BY_NAME[name, False, False]) for name in ("LC2", "LC4"))
_pack_2, _pack_4 = struct.Struct("<h").pack, struct.Struct("<i").pack


def encode_integer(value: int) -> bytes:
    """Writes a number as the shortest constant: LC0, LC1, LC2 or LC4.

    Args:
        value: -2147483648 to 2147483647. The lowest number of 8 and of 16 bits means "not a number" there, so it takes
            the next width. That of 32 bits has none: it is the pattern for "not a number".

    Returns:
        The identification byte and what follows it.

    Raises:
        BuildError: The number needs more than 32 bits.

    """
    if -_LC1_MOST <= value <= _LC1_MOST:
        return _BYTES[value + _LC1_MOST]
    if -_LC2_MOST <= value <= _LC2_MOST:
        return _LC2 + _pack_2(value)
    if -0x80000000 <= value <= 0x7FFFFFFF:
        return _LC4 + _pack_4(value)
    raise BuildError(f"no constant can be {value}: the largest encoding, LC4, holds -2147483647 to 2147483647")


def encode_float(value: float, name: str = "the value") -> bytes:
    """A float constant: an LC4 whose four bytes are an IEEE single. BuildError for numbers beyond a single's range."""
    head = bytes((_BY_NAME["LC4", False, False],))
    try:
        if math.isnan(value):
            return head + NAN_FLOAT
        return head + struct.pack("<f", value)
    except OverflowError:
        raise BuildError(f"{name} cannot be {value}: a DATAF reaches from -3.4028235e38 to 3.4028235e38") from None


def encode_string(value: str, name: str = "the string") -> bytes:
    """A zero-terminated string (LCS). BuildError for a zero in it and for characters that ISO-8859-1 does not have."""
    try:
        text = value.encode(STRING_CODING)
    except UnicodeEncodeError as error:
        raise BuildError(
            f"{name} cannot be {value!r}: the brick's strings are ISO-8859-1, which has no {value[error.start]!r}"
        ) from None
    if 0 in text:
        raise BuildError(f"{name} cannot be {value!r}: a zero ends a string, so none can stand in it")
    return bytes((_BY_NAME["LCS", False, False],)) + text + b"\0"


def encode_variable(variable: Variable, name: str = "the variable") -> bytes:
    """The shortest form of a local or global variable. BuildError for an index below 0 or beyond 32 bits."""
    letter = "G" if variable.scope == GLOBAL else "L"
    for width, indexes in INDEX_RANGES.items():
        key = (f"{letter}V{width}", variable.handle, variable.address)
        if not isinstance(variable.index, int) or variable.index not in indexes or key not in _BY_NAME:
            continue
        head, layout = _BY_NAME[key], _INDEX_LAYOUTS[width]
        return (
            bytes((head | variable.index,)) if layout is None else bytes((head,)) + struct.pack(layout, variable.index)
        )
    raise BuildError(f"{name} cannot be {variable}: an index is a whole number from 0 to 4294967295")


def encode_label(value: int, name: str = "the label") -> bytes:
    """A label or short jump (LAB1): a signed byte. BuildError beyond -128 to 127."""
    if not -128 <= value <= 127:
        raise BuildError(f"{name} cannot be {value}: LAB1 holds -128 to 127")
    return bytes((LABEL_BYTE, value & 0xFF))


def with_bits(encoded: bytes, *, handle: bool = False, address: bool = False) -> bytes:
    """An encoded long argument with the handle or address bit set. BuildError for short forms, which have none."""
    if not encoded or encoded[0] < len(SHORT):
        raise BuildError(f"{encoded!r} is a short form, which has no room for the handle and address bits")
    return bytes((encoded[0] | HANDLE_BIT * handle | ADDRESS_BIT * address,)) + encoded[1:]


def encode_as(name: str, value: int | float | str) -> bytes:
    """A value in the named encoding, shortest or not: `encode_as("LC2", 5)`. BuildError when it does not fit."""
    try:
        head = _BY_NAME[name, False, False]
    except KeyError:
        names = ", ".join(sorted({encoding.name for encoding in ENCODINGS if encoding}))
        raise BuildError(f"there is no encoding {name!r}: it is one of {names}") from None
    encoding = ENCODINGS[head]
    assert encoding is not None
    if encoding.kind == TEXT:
        return bytes((head,)) + encode_string(str(value))[1:]
    if isinstance(value, float) and name == "LC4":
        return encode_float(value)
    if not isinstance(value, int):
        raise BuildError(f"{name} holds a whole number, not {value!r}")
    is_variable = encoding.kind in (LOCAL, GLOBAL)
    if encoding.width == 0:
        numbers = (INDEX_RANGES if is_variable else CONSTANT_RANGES)[0]
        if value not in numbers:
            raise BuildError(f"{name} cannot hold {value}: it reaches from {numbers[0]} to {numbers[-1]}")
        return bytes((head | value & 0x3F,))
    layout = (_UNSIGNED if is_variable else _SIGNED)[encoding.width or 1]
    try:
        return bytes((head,)) + struct.pack(layout.replace("x", ""), value)
    except struct.error:
        bits = 8 * (encoding.width or 1)
        low, high = (0, (1 << bits) - 1) if is_variable else (-(1 << bits - 1), (1 << bits - 1) - 1)
        raise BuildError(f"{name} cannot hold {value}: it reaches from {low} to {high}") from None
