"""Evaluates and encodes values: resolves names, evaluates expressions, expands macros; jumps stay symbolic.

In a frame the parameter decides how a value is encoded, and whether it is allowed. In a program the value alone
decides, as in every assembler of programs.
"""

from __future__ import annotations

import math
import operator
import struct
from collections.abc import Callable, Container, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import accumulate
from typing import Any, NamedTuple, TypeVar

from ev3proto.errors import BuildError, counted, near_misses
from ev3proto.schema.argument import ArgumentSchema, encode_as, encode_float, encode_integer, encode_label, with_bits
from ev3proto.semantics.drafts.placeholders import FORM_OF_SIZE, settle
from ev3proto.tables.declaration import DATA8, Direction, Parameter, Role, Type
from ev3proto.tables.encoding import GLOBAL, LOCAL, RANGES
from ev3proto.tables.source import VARIABLE_WORDS
from ev3proto.text.assembly.errors import SourceError, cited
from ev3proto.text.assembly.names import NOT_NUMBERS, Callee, Encoded, Goal, Meaning, Names, Variable
from ev3proto.text.assembly.notations import MARKS, SHORTEST, Jumps, Rules
from ev3proto.text.assembly.syntax import (
    Define,
    Distance,
    Element,
    Marked,
    Name,
    NamedEncoding,
    Number,
    Pattern,
    Raw,
    Sum,
    Text,
    Unchecked,
    Value,
)

_LARGEST = 1 << 64
"""Limit for intermediate results."""

_MOST_BITS = 1024
"""Maximum bits of numerator and denominator of an exact result."""

_MOST_NESTED = 60
"""Maximum nesting depth of defines in expressions."""

_MOST_KEPT = 1 << 12
_BITS = {"LC0": 6, "LC1": 8, "LC2": 16, "LC4": 32, "LAB1": 8}
"""Bits of the constants whose encoding is named."""

JUMP_SIZES = {**{form: size for size, form in FORM_OF_SIZE.items()}, "LAB1": 2}
"""Bytes of a jump's distance by its encoding."""

_SCOPES = {"L": LOCAL, "G": GLOBAL}
_MOST_MEMBERS = 6
_FLOATS = {"inf": math.inf, "nan": math.nan}
_ANYTHING = ArgumentSchema(Parameter("the value", Type.ARRAY_TYPED, "any argument"))


_N = TypeVar("_N", int, float, Fraction)


class PendingJump(NamedTuple):
    """A jump whose distance is not known yet."""

    at: int  # its place in the text
    name: str  # the label
    form: str | None = None  # the encoding that is named, None for the usual one


Piece = bytes | PendingJump | Distance
"""A piece of code."""


# Single values, by the rules of an assembler


def wrapped(value: int) -> int:
    """Returns the lowest 32 bits as a number with a sign: 0xFFFFFFFF is -1."""
    return (value + (1 << 31)) % (1 << 32) - (1 << 31)


def single_bits(value: float) -> int:
    """Returns the bits of the nearest single, as a number with a sign."""
    return int(struct.unpack("<i", struct.pack("<f", value))[0])


@lru_cache(_MOST_KEPT)
def integer(value: int, rules: Rules) -> bytes:
    """Returns a number in its shortest encoding. From 2147483648 on it is a pattern of 32 bits."""
    for form, low, high in zip(("LC0", "LC1", "LC2"), rules.lowest, (31, 127, 32767), strict=True):
        if low <= value <= high:
            return encode_as(form, value)
    return encode_as("LC4", wrapped(value))


@lru_cache(_MOST_KEPT)
def variable(scope: str, index: int, rules: Rules, handle: bool = False, address: bool = False) -> bytes:
    """Returns a variable in its shortest encoding; that of a handle or an address is never one byte."""
    is_marked = handle or address
    width = next(
        (w for w, end in zip((0, 1, 2), rules.indexes, strict=True) if index < end and (w or not is_marked)), 4
    )
    plain = encode_as(f"{'G' if scope == GLOBAL else 'L'}V{width}", index)
    return with_bits(plain, handle=handle, address=address) if is_marked else plain


def measure(sizes: list[int], goals: Mapping[int, int], rules: Rules) -> None:
    """Sizes every jump in `sizes` whose encoding is not named; `goals` has the part that each leads to."""
    free: dict[int, int] = {}
    for place, goal in goals.items():
        is_long = rules.jumps is Jumps.FORWARD and goal > place
        sizes[place] = 5 if is_long else 3 if rules.jumps in (Jumps.THREE, Jumps.SHRUNK) else 1
        if rules.jumps is not Jumps.THREE and not is_long:
            free[place] = goal
    settle(sizes, free, lambda far: len(integer(far, rules)), is_shrinking=rules.jumps is Jumps.SHRUNK)


def joined(parts: Sequence[Piece], labels: Mapping[str, int], rules: Rules) -> bytes:
    """Joins the parts of a code whose jumps all stay in it; parameters and errors as for `part_sizes`."""
    sizes = part_sizes(parts, labels, rules)
    starts = list(accumulate(sizes, initial=0))
    return encoded_parts(parts, sizes, {name: starts[part] for name, part in labels.items()})


def part_sizes(
    parts: Sequence[Piece], labels: Mapping[str, int], rules: Rules, elsewhere: Container[str] = ()
) -> list[int]:
    """Returns the bytes of each part of a code. Raises SourceError for a jump to an unknown label.

    `labels` has the number of the part that a label precedes; a jump to one that is `elsewhere` has three bytes.
    """
    sizes: list[int] = []
    goals: dict[int, int] = {}
    for place, part in enumerate(parts):
        if isinstance(part, bytes):
            sizes.append(len(part))
            continue
        _check_labels(part, labels, elsewhere)
        form = "LC4" if isinstance(part, Distance) else part.form
        sizes.append(JUMP_SIZES[form or "LC2"])
        if isinstance(part, PendingJump) and form is None and part.name in labels:
            goals[place] = labels[part.name]
    measure(sizes, goals, rules)
    return sizes


def _check_labels(part: PendingJump | Distance, labels: Mapping[str, int], elsewhere: Container[str]) -> None:
    for name in (part.name,) if isinstance(part, PendingJump) else (part.start, part.end):
        if name not in labels and name not in elsewhere:
            hint = near_misses(name, labels) or f": `{cited(name)}:` in front of an operation makes one"
            raise SourceError(part.at, f"unknown label {cited(name)}{hint}")


def encoded_parts(parts: Sequence[Piece], sizes: Sequence[int], labels: Mapping[str, int], start: int = 0) -> bytes:
    """Joins the parts of a code, by their sizes and the offsets of labels. Raises SourceError for a far jump."""
    ends = accumulate(sizes, initial=start)
    next(ends)
    return b"".join(
        part if isinstance(part, bytes) else _encoded_jump(part, size, end, labels)
        for part, size, end in zip(parts, sizes, ends, strict=True)
    )


def _encoded_jump(part: PendingJump | Distance, size: int, end: int, labels: Mapping[str, int]) -> bytes:
    if isinstance(part, Distance):
        return encode_as("LC4", labels[part.end] - labels[part.start])
    far = labels[part.name] - end
    try:
        return encode_label(far) if part.form == "LAB1" else encode_as(part.form or FORM_OF_SIZE[size], far)
    except BuildError as error:
        raise SourceError(part.at, f"{cited(part.name)} is {far} bytes away: {error}") from None


class Encoder:
    """Evaluates and encodes values."""

    def __init__(self, names: Names, rules: Rules, warnings: list[tuple[int, str]]) -> None:
        self.names = names  # the names that are known
        self.rules = rules
        self.warnings = warnings  # (offset, message) of valid but probably unintended code
        self._is_typed = names.notation.has_messages
        self._depth = 0

    # Evaluation

    def defined(self, define: Define, _: object = None) -> Meaning:
        """Returns the value of a define: a constant, or in frames an encoded argument. Raises SourceError."""
        value = define.value
        if not self._is_typed or isinstance(value, Number | Text | Name | Sum):
            return self.meaning(value)
        piece = self.argument(value, _ANYTHING)
        if not isinstance(piece, bytes):
            raise SourceError(value.at, "a label cannot be defined by another name")
        return Encoded(piece)

    def meaning(self, value: Value, parameter: Parameter | None = None) -> Meaning:
        """Returns the meaning of a value that is neither a macro nor marked. Raises SourceError."""
        match value:
            case Number() | Text():
                return value.value
            case Name(at, text):
                return self._named(text, at, parameter)
            case Sum():
                return self._sum(value, parameter)
            case Unchecked(_, inner):
                return self.meaning(inner, parameter)
            case Element():
                return self._part(value)
        found = value.sign if isinstance(value, Marked) else value.name if isinstance(value, NamedEncoding) else "bytes"
        raise SourceError(value.at, f"expected a number, a text or a name, found {found}")

    def whole(self, value: Value, what: str, low: int, high: int) -> int:
        """Returns a whole number in a range. Raises SourceError, which names `what`."""
        found = self.meaning(value)
        if isinstance(found, Variable | Encoded | Callee | Goal):
            raise SourceError(value.at, f"{what} must be a whole number from {low} to {high}")
        if isinstance(found, Fraction) and not self._is_typed:
            found = int(found)
        if not self._is_typed and isinstance(found, int):
            found = wrapped(found)
        if not isinstance(found, int) or not low <= found <= high:
            raise SourceError(value.at, f"{what} cannot be {found!r}: it is a whole number from {low} to {high}")
        return int(found)

    def whole_or_none(self, value: Value) -> int | None:
        """Returns a whole number, which may be in a macro; None for other values."""
        while isinstance(value, NamedEncoding):
            value = value.value
        try:
            found = self.meaning(value)
        except SourceError:
            return None
        return found if isinstance(found, int) else None

    def _named(self, name: str, at: int, parameter: Parameter | None) -> Meaning:
        found = self.names.meaning(name, at, parameter)
        if found is None and parameter is not None:
            # Letters of motor ports mean something at their parameter only.
            found = parameter.names.get(name)
        if found is None and self._is_typed:
            found = _FLOATS.get(name)
        if found is None:
            raise SourceError(at, self._unknown(name, at, parameter))
        return found

    def _unknown(self, name: str, at: int, parameter: Parameter | None) -> str:
        """Returns the error for a name that is not a value of the parameter."""
        names = self.names
        if any(place.at >= at for place in names.globals.get(name, ())):
            return f"{cited(name)} is declared further down: a variable has to be declared above its use"
        if not self._is_typed:
            hint = near_misses(name, names.known())
            how = hint or ": a variable is declared above its use, a label is set in the same object"
            return f"unknown name {cited(name)}{how}"
        if name in names.local.labels and parameter is not None:
            return f"{name} is a label, and {parameter.name} takes none"
        if parameter is None:
            return f"unknown name {cited(name)}{near_misses(name, names.known())}"
        return self._unknown_for(parameter, name)

    def _unknown_for(self, parameter: Parameter, name: str) -> str:
        names = self.names
        what, known = "variable or constant", names.known(parameter)
        enum = parameter.enum
        if parameter.is_output:
            what, known = "variable", list(names.local.places)
        elif parameter.role is Role.OBJECT:
            what, known = "object", list(names.defines)
        elif enum is not None:
            what = f"value of {parameter.name} ({enum.name}):"
        hint = near_misses(name, known)
        if parameter.role is Role.OBJECT:
            hint = hint or f": `define {name} 2` in front of it gives the number of the object, counted from 1"
        elif enum is None or parameter.is_output:
            declares = _declaration(parameter, name)
            hint = f"{hint} Or {declares}" if hint else f": {declares}"
        elif not hint:
            hint = f": it has {', '.join(list(enum.members)[:_MOST_MEMBERS])}, ..."
        return f"unknown {what} {cited(name)}{hint}"

    def _part(self, value: Element) -> Variable:
        """Returns a part of a declared variable."""
        place = self._variable(value.text, value.at)
        if value.is_byte and isinstance(value.number, Number):
            far = int(value.number.value)
            return place._replace(start=place.start + far, elements=max(place.elements - far, 0))
        number = self.whole(value.number, f"an index of {value.text}", 0, place.elements - 1)
        return place._replace(start=place.start + number * place.width, elements=place.elements - number)

    def _variable(self, name: str, at: int) -> Variable:
        found = self.names.meaning(name, at)
        if not isinstance(found, Variable):
            hint = near_misses(name, (*self.names.local.places, *self.names.globals))
            raise SourceError(at, f"unknown variable {cited(name)}{hint or ': DATA8, DATAF and others declare one'}")
        return found

    # Expressions

    def _number(self, value: Value, parameter: Parameter | None) -> int | float:
        found = self.meaning(value, parameter)
        if isinstance(found, int | float | Fraction) and (self._is_typed or not isinstance(found, float)):
            return found
        what = (
            f"{found!r} is a text"
            if isinstance(found, str)
            else f"{cited(getattr(value, 'text', 'this'))} has no value"
        )
        raise SourceError(value.at, f"{what}: an expression is made of numbers and names of numbers")

    def _sum(self, value: Sum, parameter: Parameter | None) -> int | float:
        if self._depth >= _MOST_NESTED:
            raise SourceError(value.at, f"the expression needs more than {_MOST_NESTED} others for its value")
        self._depth += 1
        try:
            parts = [self._number(part, parameter) for part in value.values]
        finally:
            self._depth -= 1
        if self._is_typed:
            return _worked_out(parts, value.operators, _USUAL, _bounded)
        return self._both(value, parts)

    def _both(self, value: Sum, parts: Sequence[int | float]) -> int | float:
        """Returns the value of an expression of a program, and warns if the dialects differ."""
        from_the_left = int(
            _worked_out([int(part) for part in parts], value.operators, _LEFT, lambda _, number: wrapped(number))
        )
        is_exact = self.names.notation.last_counts
        try:
            exact = _worked_out([Fraction(part) for part in parts], value.operators, _USUAL, _exact)
        except OverflowError:
            if is_exact:
                raise SourceError(value.at, "the expression needs more digits than any number has") from None
            return from_the_left
        if not -1 << 31 <= int(exact) < 1 << 31:
            exact = Fraction(wrapped(int(exact)))
        if int(exact) != from_the_left:
            how = "products before sums" if is_exact else "from left to right"
            result = int(exact) if is_exact else from_the_left
            self.warnings.append((value.at, f"{result}, worked out {how}; the other dialect gets another number"))
        if not is_exact:
            return from_the_left
        return int(exact) if exact.denominator == 1 else exact  # type: ignore[return-value]

    # Arguments

    def argument(self, value: Value, schema: ArgumentSchema = _ANYTHING) -> Piece:
        """Returns the bytes of one argument of an operation. Raises SourceError."""
        try:
            return self._argument(value, schema)
        except BuildError as error:
            raise SourceError(value.at, str(error)) from None

    def element(self, value: Value, schema: ArgumentSchema) -> Piece:
        """Returns the bytes of one value of a list. A letter may be given for its number. Raises SourceError."""
        if isinstance(value, Text) and schema.parameter.type is Type.DATA8 and len(value.value) == 1:
            return schema.write(ord(value.value))
        return self.argument(value, schema)

    def _argument(self, value: Value, schema: ArgumentSchema) -> Piece:
        match value:
            case Raw(_, data):
                return schema.write(data) if self._is_typed else data
            case Unchecked(_, inner):
                return self._argument(inner, schema)
            case NamedEncoding():
                return self._form(value, schema)
            case Marked():
                return self._marked(value)
            case Distance():
                return value
            case Name(text=text) if self._is_typed and text in NOT_NUMBERS and text not in self.names.local.places:
                if schema.parameter.type is not Type.STRING and text not in self.names.defines:
                    return schema.write(math.nan)
        return self.encoded(self.meaning(value, schema.parameter), value, schema)

    def encoded(self, meaning: Meaning, value: Value, schema: ArgumentSchema = _ANYTHING) -> Piece:
        """Returns the bytes of a meaning."""
        match meaning:
            case Encoded(data):
                return schema.write(data)
            case Goal(name):
                return PendingJump(value.at, name)
            case Variable():
                if self._is_typed:
                    self._check_room(meaning, value, schema.parameter)
                return variable(meaning.scope, meaning.start, self.rules)
            case Callee():
                return integer(meaning.number, self.rules)
        if self._is_typed:
            kind = schema.parameter.type
            if isinstance(meaning, Pattern) and kind in RANGES and kind.size:
                return schema.write(_signed(meaning, 8 * kind.size))
            return schema.write(meaning)
        return self._of_program(meaning)

    def _of_program(self, meaning: int | float | str) -> bytes:
        if isinstance(meaning, str):
            return encode_as("LCS_OLD", meaning)
        if isinstance(meaning, float):
            bits = single_bits(meaning)
            return encode_as("LC4", bits) if self.rules.long_floats else integer(bits, self.rules)
        return integer(int(meaning), self.rules)

    def _marked(self, value: Marked) -> bytes:
        part = value.part
        place = self._part(part) if isinstance(part, Element) else self._variable(part.text, part.at)
        if not self._is_typed and value.sign == "@" and place.type is not Type.HANDLE:
            self.warnings.append((value.at, f"{cited(part.text)} is a {place.type}, and @ is for a HANDLE"))
        return variable(place.scope, place.start, self.rules, handle=value.sign == "@", address=value.sign == "&")

    def _check_room(self, place: Variable, value: Value, parameter: Parameter) -> None:
        """Raises SourceError if a parameter is larger than its variable."""
        room = place.width * place.elements
        if parameter.type.size > room and not parameter.any_type:
            verb = "is read as" if parameter.direction is Direction.IN else "would be overwritten by"
            raise SourceError(
                value.at,
                f"{_written(value)} has {counted(room, 'byte')} here and {verb} {parameter.name}, a"
                f" {parameter.type} of {parameter.type.size}",
            )

    # Macros

    def _form(self, form: NamedEncoding, schema: ArgumentSchema) -> Piece:
        """Returns a value in a named encoding."""
        name, part = form.name, form.value
        if name in MARKS:
            inner = self.argument(part, schema)
            if not isinstance(inner, bytes):
                raise SourceError(part.at, f"{name} takes no label")
            return with_bits(inner, handle=name == "HND", address=name == "ADR")
        is_number = self._is_typed and isinstance(part, Name) and part.text in NOT_NUMBERS
        meaning = math.nan if is_number and name == "LCF" else self.meaning(part, schema.parameter)
        if isinstance(meaning, Goal):
            if name not in JUMP_SIZES:
                raise SourceError(form.at, f"{name} cannot hold the distance to a label")
            return PendingJump(part.at, meaning.name, name)
        if name[1] == "V":
            return self._variable_form(name, part, meaning)
        return self._value_form(name, part, meaning)

    def _value_form(self, name: str, part: Value, meaning: Meaning) -> bytes:
        if isinstance(meaning, Callee):
            meaning = meaning.number
        if name in ("LCS", "LCS_OLD"):
            if not isinstance(meaning, str):
                raise SourceError(part.at, f"{name} takes a text in quotes, not {_shown(meaning)}")
            return encode_as(name, meaning)
        if isinstance(meaning, str) and len(meaning) == 1:
            meaning = ord(meaning)
        if not isinstance(meaning, int | float | Fraction):
            raise SourceError(part.at, f"{name} takes a number, not {_shown(meaning)}")
        return self._constant_form(name, part, meaning)

    def _constant_form(self, name: str, part: Value, number: int | float) -> bytes:
        if name == "LCF":
            return encode_float(number, "the number")
        if isinstance(number, float):
            if self._is_typed:
                raise SourceError(part.at, f"{name} takes a whole number, not {number!r}; LCF takes this one")
            number = single_bits(number)
        if name == "LCX":
            return encode_integer(int(number))
        if isinstance(number, Pattern):
            number = _signed(number, _BITS[name])
        elif not self._is_typed:
            number = wrapped(int(number))
        return encode_label(int(number), name) if name == "LAB1" else encode_as(name, int(number))

    def _variable_form(self, name: str, part: Value, meaning: Meaning) -> bytes:
        scope = _SCOPES[name[0]]
        if isinstance(meaning, Variable):
            if meaning.scope != scope:
                raise SourceError(part.at, f"{name} is for {scope} variables, and this is a {meaning.scope} one")
            index = meaning.start
        elif isinstance(meaning, int) and 0 <= meaning <= 0xFFFFFFFF:
            index = int(meaning)
        else:
            shown = _shown(meaning)
            raise SourceError(
                part.at, f"the index of {name} cannot be {shown}: it is a whole number from 0 to 4294967295"
            )
        return variable(scope, index, self.rules) if name in SHORTEST else encode_as(name, index)


_WORDS = {kind: word for word, kind in reversed(VARIABLE_WORDS.items())}
"""The first word that declares a variable of a type."""


def _declaration(parameter: Parameter, name: str) -> str:
    """Returns which line declares a name for a parameter."""
    if parameter.type is Type.LABEL:
        return f"`define {name} 1` in front of it makes it a number"
    line = f"{_WORDS.get(parameter.type, DATA8.label)} {name}"
    if parameter.type is Type.STRING or parameter.length is not None:
        line = f"DATAS {name} 64"
    return f"`{line}` in front of it declares a variable"


def _shown(meaning: Meaning) -> str:
    return repr(meaning) if isinstance(meaning, int | float | str) else "a variable"


def _written(value: Value) -> str:
    return cited(getattr(value, "text", "this"))


def _signed(pattern: int, bits: int) -> int:
    """Returns a pattern of that many bits as a signed number; longer ones unchanged."""
    return pattern - (1 << bits) if 1 << (bits - 1) <= pattern < 1 << bits else int(pattern)


_LEFT = ("*/+-",)
_USUAL = ("*/", "+-", "|")
"""Operators by precedence."""


def _worked_out(
    parts: Sequence[_N], operators: Sequence[tuple[int, str]], ranks: Sequence[str], kept: Callable[[int, _N], _N]
) -> _N:
    """Returns the value of an expression.

    `ranks` has operators by precedence; `kept` cuts intermediate results to their size, or raises an error.
    """
    for rank in ranks:
        done, left = [parts[0]], []
        for (at, sign), part in zip(operators, parts[1:], strict=True):
            if sign in rank:
                done[-1] = kept(at, _applied(at, sign, done[-1], part))
            else:
                done.append(part)
                left.append((at, sign))
        parts, operators = done, left
    return parts[0]


def _applied(at: int, sign: str, left: Any, right: Any) -> Any:
    """Returns the result of one operator; whole numbers are divided towards zero."""
    are_whole = isinstance(left, int) and isinstance(right, int)
    if sign == "|" and not are_whole:
        raise SourceError(at, "| joins the bits of whole numbers")
    if sign == "/" and right == 0:
        raise SourceError(at, "a division by zero has no value")
    if sign == "/" and are_whole:
        return abs(left) // abs(right) * (1 if (left < 0) == (right < 0) else -1)
    return _OPERATIONS[sign](left, right)


_OPERATIONS = {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "|": operator.or_}


def _bounded(at: int, number: int | float) -> int | float:
    if isinstance(number, int) and abs(number) >= _LARGEST:
        raise SourceError(at, "the numbers become larger than anything in a frame")
    return number


def _exact(_: int, value: Fraction) -> Fraction:
    """Raises OverflowError for excessive results: each could be twice as long as the one before."""
    if max(value.numerator.bit_length(), value.denominator.bit_length()) > _MOST_BITS:
        raise OverflowError
    return value
