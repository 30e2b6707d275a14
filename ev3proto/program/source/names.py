"""What the names of a source mean, by the rules of its dialect."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache
from itertools import islice
from typing import NamedTuple

from ev3proto.program.source.errors import SourceError
from ev3proto.program.source.numbers import fits, wrapped
from ev3proto.program.source.statements import DefineStatement, Float, Name, Number, Sum, Text, Unchecked, Value
from ev3proto.tables import OPCODES, enumerations
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import Direction, Enumeration, Type
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.text.assembly.symbols import suggestion

_HOW_TO_NAME = ": a variable is declared above its use, a label stands in the same object"

_MOST_KNOWN = 5000
"""Names among which a misspelt one is looked for."""

_MOST_BITS = 1024
"""Of the numerator and the denominator of an exact result."""

MAX_DEPTH = 100
"""How many defines may be needed for the value of one."""


@dataclass(frozen=True, slots=True)
class ProgramVariable:
    """A variable.

    at        where it is declared in the source
    scope     local or global
    index     bytes from the start of that memory
    size      bytes in all
    type      of one element; HANDLE for one that was declared as such
    is_array  whether it has elements
    """

    at: int
    scope: str
    index: int
    size: int
    type: Type
    is_array: bool


@dataclass
class Callee:
    """An object, as others see it.

    number      1 or more
    at          where it is declared
    kind        the word that began it
    parameters  type and direction of each; None where it takes none and no count is written, as for threads
    """

    number: int
    at: int
    kind: str
    parameters: list[tuple[Direction, Type]] | None


class Goal(NamedTuple):
    """A label to jump to."""

    name: str


Meaning = int | Fraction | Float | Text | ProgramVariable | Callee | Goal


@cache
def builtin_names() -> dict[str, int | Text]:
    """The firmware's names: constants, members of enumerations, CMDs. None occurs twice with different values."""
    found: dict[str, int | str] = {}
    for enumeration in vars(enumerations).values():
        if isinstance(enumeration, Enumeration):
            found.update(enumeration.members)
            found.update((enumeration.end,) if enumeration.end else ())
    found.update(CONSTANTS)
    found.update({command.name: command.number for opcode in OPCODES for command in opcode.commands})
    return {
        name: Text(0, value.encode(STRING_CODING)) if isinstance(value, str) else wrapped(value)
        for name, value in found.items()
    }


@dataclass
class LocalNames:
    """The names of one object: variables and defines so far, and all its labels."""

    places: dict[str, ProgramVariable] = field(default_factory=dict)
    defines: dict[str, DefineStatement] = field(default_factory=dict)
    labels: dict[str, int] = field(default_factory=dict)


class Names:
    """The names of a file, by the rules of a dialect.

    is_strict  strict: locals above, then globals, objects and defines above, the firmware's names, labels, what is
               declared further down. LEGO's: local, global, label, object, define, the firmware's; the last one counts
    """

    def __init__(self, is_strict: bool, warnings: list[tuple[int, str]]) -> None:
        self.is_strict = is_strict
        self._warnings = warnings
        self.globals: dict[str, list[ProgramVariable]] = {}
        self.objects: dict[str, Callee] = {}
        self.defines: dict[str, DefineStatement] = {}
        self._worked_out: dict[int, Meaning] = {}
        self._depth = 0

    def meaning(self, name: str, at: int, local: LocalNames) -> Meaning:
        """What a name means where it is used. Raises SourceError for a name that means nothing there."""
        found = self._strict(name, at, local) if self.is_strict else self._lego(name, at, local)
        if found is None:
            raise SourceError(at, self._unknown(name, at, local))
        return found

    def _strict(self, name: str, at: int, local: LocalNames) -> Meaning | None:
        place = local.places.get(name)
        if place is not None:
            return place
        if name in local.defines:
            return self.defined(local.defines[name], local)
        for is_above in (True, False):
            shared = self.globals.get(name)
            if shared is not None and is_above and shared[0].at < at:
                return shared[0]
            callee = self.objects.get(name)
            if callee is not None and (callee.at < at) is is_above:
                return callee
            define = self.defines.get(name)
            if define is not None and (define.at < at) is is_above:
                return self.defined(define, LocalNames())
            if is_above:
                builtin = builtin_names().get(name)
                if builtin is not None:
                    return builtin
                if name in local.labels:
                    return Goal(name)
        return None

    def _lego(self, name: str, at: int, local: LocalNames) -> Meaning | None:
        place = local.places.get(name)
        if place is not None:
            return place
        above = [it for it in self.globals.get(name, ()) if it.at < at]
        if above:
            return above[-1]
        define = self.defines.get(name)
        if name in local.labels and (define is None or define.at < local.labels[name]):
            return Goal(name)
        callee = self.objects.get(name)
        if callee is not None:
            return callee
        if define is not None:
            return self.defined(define, LocalNames())
        return builtin_names().get(name)

    def _unknown(self, name: str, at: int, local: LocalNames) -> str:
        if any(place.at >= at for place in self.globals.get(name, ())):
            return f"{name[:40]} is declared further down: a variable has to stand above its use"
        near = suggestion(name, islice(self._known(local), _MOST_KNOWN))
        return f"there is no {name[:40]}{near or _HOW_TO_NAME}"

    def _known(self, local: LocalNames) -> Iterator[str]:
        yield from builtin_names()
        yield from local.places
        yield from local.labels
        yield from local.defines
        yield from self.globals
        yield from self.objects
        yield from self.defines

    def defined(self, define: DefineStatement, local: LocalNames) -> Meaning:
        """What a define stands for."""
        key = id(define)
        if key not in self._worked_out:
            if self._depth >= MAX_DEPTH:
                raise SourceError(define.at, f"{define.name[:40]} is defined by itself, or by too many others")
            self._depth += 1
            try:
                self._worked_out[key] = self.value(define.value, local)
            finally:
                self._depth -= 1
        return self._worked_out[key]

    # Values

    def value(self, value: Value, local: LocalNames) -> Meaning:
        """What a value means that is neither a form nor marked. Raises SourceError."""
        match value:
            case Number(_, number):
                return number
            case Float() | Text():
                return value
            case Name(at, text):
                return self.meaning(text, at, local)
            case Sum():
                return self._sum(value, local)
            case Unchecked(_, inner):
                return self.value(inner, local)
        raise SourceError(value.at, "a plain value should stand here")

    def number(self, value: Value, local: LocalNames, what: str) -> int:
        """A whole number of 32 bits. Raises SourceError, which says of what."""
        found = self.value(value, local)
        if isinstance(found, Fraction):
            found = int(found)
        if not isinstance(found, int):
            raise SourceError(value.at, f"{what} must be a whole number")
        return wrapped(found)

    def _sum(self, value: Sum, local: LocalNames) -> int | Fraction:
        if self._depth >= MAX_DEPTH:
            raise SourceError(value.at, f"the expression needs more than {MAX_DEPTH} others for its value")
        self._depth += 1
        try:
            return self._worked(value, local)
        finally:
            self._depth -= 1

    def _worked(self, value: Sum, local: LocalNames) -> int | Fraction:
        parts: list[int | Fraction] = []
        for part in value.values:
            found = self.value(part, local)
            if not isinstance(found, int | Fraction):
                raise SourceError(part.at, "an expression is made of whole numbers and their names")
            parts.append(found)
        try:
            from_the_left = _from_the_left([int(part) for part in parts], value.operators)
            usual = _usual(parts, value.operators)
        except ZeroDivisionError:
            raise SourceError(value.at, "a division by zero has no value") from None
        except OverflowError:
            if value.is_usual:
                raise SourceError(value.at, "the expression needs more digits than any number has") from None
            return from_the_left
        result = usual if value.is_usual else from_the_left
        if int(usual) != from_the_left:
            how = "products before sums" if value.is_usual else "from left to right"
            self._warnings.append((value.at, f"{int(result)}, worked out {how}; the other dialect gets another number"))
        return result


def _from_the_left(parts: list[int], operators: tuple[str, ...]) -> int:
    """From left to right, each result cut to 32 bits; a division goes towards zero."""
    total = parts[0]
    for operator, part in zip(operators, parts[1:], strict=True):
        total = wrapped(_applied(operator, total, part))
    return total


def _applied(operator: str, left: int, right: int) -> int:
    if operator == "+":
        return left + right
    if operator == "-":
        return left - right
    if operator == "*":
        return left * right
    quotient = abs(left) // abs(right)
    return quotient if (left < 0) == (right < 0) else -quotient


def _usual(parts: list[int | Fraction], operators: tuple[str, ...]) -> int | Fraction:
    """Products before sums, divisions exact; what is left over is cut off where the number is encoded.

    Raises OverflowError for a product or sum that no program needs: each could be twice as long as the one before.
    """
    sums: list[Fraction] = [Fraction(parts[0])]
    for operator, part in zip(operators, parts[1:], strict=True):
        if operator == "*":
            sums[-1] *= part
        elif operator == "/":
            sums[-1] /= part
        else:
            sums.append(Fraction(part if operator == "+" else -part))
        _check_digits(sums[-1])
    total = Fraction(0)
    for product in sums:
        total += product
        _check_digits(total)
    if not fits(int(total)):
        return wrapped(int(total))
    return int(total) if total.denominator == 1 else total


def _check_digits(value: Fraction) -> None:
    if max(value.numerator.bit_length(), value.denominator.bit_length()) > _MOST_BITS:
        raise OverflowError
