"""How the texts of arguments look around their values, kept: operations in a long capture are like one another.

The text of an argument is put together from what stood before and after its value the last time. Trees and JSON take
half the time that way.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ev3proto.messages import Argument, ArgumentValue, Operation
from ev3proto.schema.argument import SHORT, reader_of
from ev3proto.tables.declaration import LISTS, Declaration, Parameter
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.text.phrases import plain

Around = tuple[str, str]
"""What stands before and after a value."""

_MOST_KEPT = 1024
"""Numbers with a meaning of their own, of one parameter, that are kept."""

_FORMS = 256
"""Identification bytes."""


class Pattern(dict[object, Around]):
    """How the texts of one argument of an operation look, by its encoding, and by its value where that has a meaning.

    split  makes a text, in two parts around the value
    named  numbers that have names or meanings, which are said, too; None where any number may have one
    """

    __slots__ = ("_split", "named")

    def __init__(self, parameter: Parameter, split: Callable[[Argument], Around]) -> None:
        super().__init__()
        enum = parameter.enum
        self.named: frozenset[ArgumentValue] | None = frozenset(parameter.special or ())
        if enum is not None:
            self.named = None if enum.flags else self.named | frozenset(enum.members.values())
        self._split = split

    def around(self, argument: Argument) -> Around:
        """What stands before and after the value of an argument, made where it is not known yet."""
        _, form, value, _, _ = argument
        # There is one object for each encoding, so its id tells it; to hash one takes long.
        key = (id(form), value) if self.named is None or value in self.named else id(form)
        found = self.get(key)
        if found is None:
            if len(self) >= _MOST_KEPT:
                self.clear()
            found = self[key] = self._split(argument)
        return found


class ArgumentTexts:
    """The texts of one argument of an operation, straight from the bytes of a frame without a fault.

    short  by the only byte of a short form: its text; None where none was needed yet
    """

    __slots__ = ("_long_forms", "_named", "_numbers", "_parameter", "_pattern", "short")

    def __init__(self, parameter: Parameter, pattern: Pattern) -> None:
        self._parameter, self._long_forms = reader_of(parameter)
        self._pattern = pattern
        self._named = pattern.named
        self.short: list[str | None] = [None] * _FORMS
        # By the identification byte of a long form: what reads its number, its size, what stands around the number.
        self._numbers: dict[int, tuple[Callable[[bytes, int], tuple[Any]], int, str, str]] = {}

    def read(self, data: bytes, at: int) -> tuple[str, int]:
        """The text of the argument at an offset, and the offset after it."""
        first = data[at]
        named = self._named
        known = self._numbers.get(first)
        if known is not None:
            unpack, size, before, after = known
            (number,) = unpack(data, at)
            if number not in named:  # type: ignore[operator]
                return f"{before}{number if type(number) is int else plain(number)}{after}", at + size
        if first < len(SHORT):
            form, value = SHORT[first]
            before, after = self._pattern.around(Argument((self._parameter, form, value, at, data)))
            text = self.short[first] = f"{before}{value}{after}"
            return text, at + 1
        long_form = self._long_forms[first]
        assert long_form is not None, "a frame without a fault has no undefined identification byte"
        form, read, size = long_form
        if read is None:
            end = data.index(0, at + 1) + 1
            text = data[at + 1 : end - 1].decode(STRING_CODING)
            before, after = self._pattern.around(Argument((self._parameter, form, text, at, data)))
            return f"{before}{plain(text)}{after}", end
        (number,) = read(data, at)
        before, after = self._pattern.around(Argument((self._parameter, form, number, at, data)))
        if named is not None and number not in named:
            self._numbers[first] = read, size, before, after
        return f"{before}{number if type(number) is int else plain(number)}{after}", at + size


def has_pattern(declaration: Declaration) -> bool:
    """Whether an operation always has the same arguments, so that each can have a pattern."""
    return not any(parameter.type in LISTS for parameter in declaration.parameters)


def is_usual(operation: Operation) -> bool:
    """Whether an operation is complete and its CMD, if it has one, is a short constant."""
    if not operation.is_complete:
        return False
    schema, data, start = operation[:3]
    return schema.declaration.command is None or data[start + 1] < len(SHORT)
