"""Texts of operations straight from the bytes of a frame: operations in a long capture are like one another.

The text of an argument is put together from what stood before and after its value the last time, and no operations and
arguments are made for it. Trees and JSON take a third of the time that way.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from functools import cache

from ev3proto.messages import Argument, ArgumentValue, DirectCommand, Operation, unread_operations
from ev3proto.schema.argument import SHORT, Unpack, reader_of
from ev3proto.schema.instructions import PADDING, InstructionSet
from ev3proto.schema.operation import OperationSchema
from ev3proto.tables.declaration import Parameter, Type
from ev3proto.tables.encoding import GLOBAL, LOCAL, STRING_CODING, Encoding
from ev3proto.tables.frame import MAX_FRAME

Around = tuple[str, str]
"""What stands before and after a value."""

_MOST_LISTED = 8
"""Elements of the longest list that is made of known texts. Longer ones are rare, and each length has its own texts."""

_MOST_KEPT = 1024
"""Numbers with a meaning of their own, of one parameter, that are kept."""

_FORMS = 256
"""Identification bytes."""

_NO_NAMES: frozenset[ArgumentValue] = frozenset()

_NARROW = 2
"""Bytes of a form whose value is one byte."""

_SHORT_FORMS = [form for form, _ in SHORT]
_PLACES = {
    form: (_SHORT_FORMS.index(form), _SHORT_FORMS.index(form) + _SHORT_FORMS.count(form)) for form in set(_SHORT_FORMS)
}
"""By each short form, the first of its bytes and the one after the last."""

LONG = len(SHORT)
"""The first identification byte of long forms."""

SHORT_NUMBERS = tuple(str(value) for _, value in SHORT)
"""The values of short forms, by their only byte."""

_UNSIGNED = tuple(map(str, range(256)))
_SIGNED = (*_UNSIGNED[:128], *map(str, range(-128, 0)))
"""Numbers by their only byte, in variables and in all else."""


class UnusualError(Exception):
    """Texts of operations cannot be made straight from the bytes: they may be at fault."""


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
    """The texts of one argument of an operation, straight from the bytes of a frame.

    short   by the only byte of a short form: what stands before and after its value; None where it is not known yet
    narrow  by the identification byte of a form of two bytes: numbers by the second byte, what stands around them
    """

    # Whoever writes texts looks into the two lists first: to call a method for each argument takes half as long again.
    __slots__ = ("_long_forms", "_named", "_numbers", "_parameter", "_pattern", "_said", "narrow", "short")

    def __init__(self, parameter: Parameter, pattern: Pattern, said: Callable[[float | str], str]) -> None:
        """Knows no text yet.

        Args:
            parameter: What the tables declare.
            pattern: How its texts look around their values.
            said: How a value looks that is no whole number.

        """
        self._parameter, self._long_forms = reader_of(parameter)
        self._pattern = pattern
        self._named = pattern.named
        self._said = said
        self.short: list[Around | None] = [None] * len(SHORT)
        self.narrow: list[tuple[Sequence[str], str, str] | None] = [None] * _FORMS
        # By the identification byte: what reads the number, the size, what stands around numbers, and those with names.
        self._numbers: dict[int, tuple[Unpack, int, str, str, frozenset[ArgumentValue]]] = {}

    def of_short(self, first: int) -> Around:
        """What stands before and after the value of a short form. It is kept."""
        form, value = SHORT[first]
        found = self._pattern.around(Argument((self._parameter, form, value, 0, bytes((first,)))))
        if self._named == _NO_NAMES or form.kind in (LOCAL, GLOBAL):
            start, end = _PLACES[form]
            self.short[start:end] = [found] * (end - start)
        else:
            self.short[first] = found
        return found

    def read(self, data: bytes, at: int) -> tuple[str, str, str, int]:
        """What stands before the value of the long form at an offset, the value, what stands after it; where it ends.

        Raises:
            UnusualError: There is none.
            ValueError: A string does not end.

        """
        first = data[at]
        known = self._numbers.get(first)
        if known is not None:
            unpack, size, before, after, named = known
            (number,) = unpack(data, at)
            if number not in named:
                return before, str(number) if type(number) is int else self._said(number), after, at + size
        long_form = self._long_forms[first]
        if long_form is None:
            raise UnusualError
        form, read, size = long_form
        if read is None:
            end = data.index(0, at + 1)
            text = data[at + 1 : end].decode(STRING_CODING)
            before, after = self._pattern.around(Argument((self._parameter, form, text, at, data)))
            return before, self._said(text), after, end + 1
        (number,) = read(data, at)
        before, after = self._pattern.around(Argument((self._parameter, form, number, at, data)))
        self._keep(first, form, number, (read, size, before, after))
        return before, str(number) if type(number) is int else self._said(number), after, at + size

    def _keep(self, first: int, form: Encoding, number: ArgumentValue, known: tuple[Unpack, int, str, str]) -> None:
        """Keeps what stands around a number for all of its form that have no names."""
        is_variable = form.kind in (LOCAL, GLOBAL)
        named = _NO_NAMES if is_variable else self._named
        if named is None or number in named:
            return
        self._numbers[first] = *known, named
        _, size, before, after = known
        if size == _NARROW and not named:
            self.narrow[first] = _UNSIGNED if is_variable else _SIGNED, before, after


class OperationTexts(ABC):
    """The texts of operations of one kind, straight from the bytes of a frame."""

    __slots__ = ()

    @abstractmethod
    def add(self, texts: list[str], data: bytes, at: int) -> int:
        """Adds the texts of the operation at an offset.

        Args:
            texts: What was added so far.
            data: The frame, with `PADDING` after it: the operation may be at fault, and end there.
            at: The offset of the opcode, which is followed by the right CMD in its shortest encoding.

        Returns:
            The offset after the operation. It is one after the end of the frame where the operation is at fault.

        Raises:
            UnusualError: The operation is at fault, or so unusual that others have to write it.
            ValueError: A string does not end.

        """


_Made = Callable[[OperationSchema, tuple[Parameter, ...]], OperationTexts]
"""Makes the texts of operations with these parameters."""


class ListTexts(OperationTexts):
    """The texts of operations with a list, made for each length by itself."""

    __slots__ = ("_by_list", "_made", "_schema")

    def __init__(self, schema: OperationSchema, made: _Made) -> None:
        self._schema = schema
        self._made = made
        self._by_list: dict[tuple[int, Type], OperationTexts] = {}

    def add(self, texts: list[str], data: bytes, at: int) -> int:
        """Adds the texts of the operation at an offset."""
        parameters = self._schema.parameters_at(data, at, _MOST_LISTED)
        if parameters is None:
            raise UnusualError
        # The type of one element is that of all.
        key = len(parameters), parameters[-1].type
        known = self._by_list.get(key)
        if known is None:
            known = self._by_list[key] = self._made(self._schema, parameters)
        return known.add(texts, data, at)


class DialectTexts:
    """The texts of all operations of one dialect."""

    def __init__(self, instructions: InstructionSet, texts_of: Callable[[OperationSchema], OperationTexts]) -> None:
        """Knows no operation yet.

        Args:
            instructions: The instruction set of the dialect.
            texts_of: Finds the texts of operations of one kind.

        """
        self._instructions = instructions
        self._texts_of = texts_of
        self._by_opcode: list[OperationTexts | list[OperationTexts | None] | None] = [None] * 256

    def add(self, texts: list[str], frame: bytes, at: int) -> bool:
        """Adds the texts of all operations from an offset of a frame on.

        Returns:
            False where one of them is at fault or unusual: nothing is added then.
        """
        end = len(frame)
        if end > MAX_FRAME:
            return False
        data = frame + PADDING
        by_opcode = self._by_opcode
        before = len(texts)
        try:
            while at < end:
                known = by_opcode[data[at]]
                if type(known) is list:
                    known = known[data[at + 1]]
                if known is None:
                    known = self._found(data, at)
                at = known.add(texts, data, at)  # type: ignore[union-attr]
        except (UnusualError, ValueError):
            at = 0
        if at == end:
            return True
        del texts[before:]
        return False

    def _found(self, data: bytes, at: int) -> OperationTexts:
        """The texts of the operation at an offset, which are kept. Raises UnusualError where nobody knows it."""
        schema = self._instructions.usual_schema(data, at)
        if schema is None:
            raise UnusualError
        found = self._texts_of(schema)
        code = data[at]
        if schema.declaration.command is None:
            self._by_opcode[code] = found
        else:
            commands = self._by_opcode[code]
            if type(commands) is not list:
                commands = self._by_opcode[code] = [None] * 256
            commands[data[at + 1]] = found
        return found


class CommandTexts:
    """The texts of the operations of direct commands: straight from the bytes, or of one operation after the other."""

    def __init__(self, made: _Made, general: Callable[[Operation], list[str]]) -> None:
        """Knows no operation yet.

        Args:
            made: Makes the texts of operations with certain parameters.
            general: The texts of any operation.

        """
        self._made = made
        self._general = general
        self._of = cache(self._new)
        self._in = cache(lambda instructions: DialectTexts(instructions, self._of))

    def _new(self, schema: OperationSchema) -> OperationTexts:
        if schema.list_parameter is not None:
            return ListTexts(schema, self._made)
        return self._made(schema, schema.declaration.parameters)

    def add(self, texts: list[str], frame: bytes, at: int, instructions: InstructionSet) -> bool:
        """Adds the texts of all operations from an offset of a frame on.

        Returns:
            False where one of them is at fault or unusual: nothing is added then.
        """
        return self._in(instructions).add(texts, frame, at)

    def add_all(self, texts: list[str], message: DirectCommand) -> None:
        """Adds the texts of all operations of a message, whatever they are like."""
        unread = unread_operations(message)
        if unread is not None:
            instructions, frame, at = unread
            if self.add(texts, frame, at, instructions):
                return
        for operation in message.operations:
            if not self._add_usual(texts, operation):
                texts += self._general(operation)

    def _add_usual(self, texts: list[str], operation: Operation) -> bool:
        if not is_usual(operation):
            return False
        schema, data, at = operation[:3]
        before = len(texts)
        try:
            self._of(schema).add(texts, data, at)
        except UnusualError:
            del texts[before:]
            return False
        return True


def is_usual(operation: Operation) -> bool:
    """Whether an operation is complete and its CMD, if it has one, is a short constant."""
    if not operation.is_complete:
        return False
    schema, data, start = operation[:3]
    return schema.declaration.command is None or data[start + 1] < len(SHORT)
