"""How the texts of arguments look around their values, kept: operations in a long capture are like one another.

The text of an argument is put together from what stood before and after its value the last time. Trees and JSON take
half the time that way.
"""

from __future__ import annotations

from collections.abc import Callable

from ev3proto.messages import Argument, ArgumentValue, Operation
from ev3proto.schema.argument import SHORT
from ev3proto.tables.declaration import LISTS, Declaration, Parameter

Around = tuple[str, str]
"""What stands before and after a value."""

_MOST_KEPT = 1024
"""Numbers with a meaning of their own, of one parameter, that are kept."""


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


def has_pattern(declaration: Declaration) -> bool:
    """Whether an operation always has the same arguments, so that each can have a pattern."""
    return not any(parameter.type in LISTS for parameter in declaration.parameters)


def is_usual(operation: Operation) -> bool:
    """Whether an operation is complete and its CMD, if it has one, is a short constant."""
    if not operation.is_complete:
        return False
    schema, data, start = operation[:3]
    return schema.declaration.command is None or data[start + 1] < len(SHORT)
