"""Encodes operations of both notations of frames: resolves opcode and CMD, and encodes each argument."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache

from ev3proto.errors import BuildError, counted, near_misses
from ev3proto.messages import Operation
from ev3proto.schema.argument import ArgumentSchema, encode_integer
from ev3proto.schema.instructions import CMD, FamilySchema, InstructionSet, OperationSchema, instruction_set
from ev3proto.semantics.drafts.functions import objections
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import DIALECTS, Enumeration, Opcode, Parameter, Type
from ev3proto.tables.encoding import CONSTANT
from ev3proto.tables.system import SYSTEM
from ev3proto.text.assembly.errors import SourceError
from ev3proto.text.assembly.names import NOT_NUMBERS, choice
from ev3proto.text.assembly.notations import SHORTEST
from ev3proto.text.assembly.parsing import is_operation_word
from ev3proto.text.assembly.syntax import Call, Name, NamedEncoding, Number, Raw, Value, WrittenArgument
from ev3proto.text.assembly.values import Encoder, Piece

_MOST_NAMED = 8
"""Maximum number of CMDs that an error lists."""

_ANY_DISTANCE = encode_integer(0)
_HOW_TO_MEAN_IT = "put a `message` line before it to allow it"
_ELEMENT = ArgumentSchema(Parameter("the value", Type.ARRAY_TYPED, "an element of a list that is cut short"))


@cache
def opcodes(dialect: str) -> dict[str, Opcode]:
    """Returns the opcodes of a dialect by name."""
    return {opcode.name: opcode for opcode in OPCODES if dialect in opcode.dialects}


class Assembler:
    """Encodes the operations of one dialect."""

    def __init__(self, dialect: str, encoder: Encoder) -> None:
        self._dialect = dialect
        self._set: InstructionSet = instruction_set(dialect)
        self._encoder = encoder

    def is_operation(self, name: str) -> bool:
        """Returns whether a name is that of an operation."""
        return _bare(name).partition(".")[0] in opcodes(self._dialect)

    def operation(self, call: Call, *, is_checked: bool) -> list[Piece]:
        """Returns the pieces of an operation; `is_checked` refuses meaningless values. Raises SourceError."""
        schema, head, arguments = self._selected(call)
        if not call.is_complete:
            return [head, *self._incomplete(schema, arguments)]
        arguments = _in_order(schema, arguments, call)
        arguments = self._with_count(schema, arguments, call)
        fixed = schema.fixed
        if schema.tail is None and len(arguments) > len(fixed):
            raise SourceError(arguments[len(fixed)].at, f"{_takes(schema)}, not {len(arguments)}")
        if len(arguments) < len(fixed):
            missing = fixed[len(arguments)].parameter
            raise SourceError(
                call.end, f"{_takes(schema)}, not {len(arguments)}: {missing.name} is missing ({missing.text})"
            )
        counter = arguments[len(fixed) - 1].value if schema.tail is not None else None
        if isinstance(counter, Name) and self._encoder.whole_or_none(counter) is None:
            self._check_counter(counter)
        pieces = [self._encoder.argument(given.value, one) for given, one in zip(arguments, fixed, strict=False)]
        pieces += self._elements(schema, pieces, arguments)
        if is_checked:
            _check(schema, head, pieces, arguments)
        return [head, *pieces]

    def _check_counter(self, counter: Name) -> None:
        """Raises SourceError for a name that should be the number of the values that follow."""
        what = "is a variable" if counter.text in self._encoder.names.local.places else "is unknown"
        hint = f"`define {counter.text} 2` in front of it makes it a number"
        raise SourceError(counter.at, f"{counter.text} {what}, and the number of values that follow is needed: {hint}")

    # Opcode and CMD

    def _selected(self, call: Call) -> tuple[OperationSchema, bytes, tuple[WrittenArgument, ...]]:
        """Returns the schema of an operation, the bytes of opcode and CMD, and the other arguments."""
        name, _, command = _bare(call.name).partition(".")
        opcode = opcodes(self._dialect).get(name)
        if opcode is None:
            raise SourceError(call.at, self._unknown(call.name, name))
        head = bytes((opcode.number,))
        plain = self._set.opcodes[opcode.number]
        if plain is not None:
            if command:
                raise SourceError(call.at, f"{name} has no CMD, so its name takes none")
            return plain, head, call.arguments
        family = self._set.families[opcode.number]
        assert family is not None, "an opcode of a dialect is plain or has CMDs"
        if command:
            number = self._command_number(family, command, call.at)
            return family.commands[number], head + encode_integer(number), call.arguments
        if not call.arguments:
            raise SourceError(call.end, f"the CMD of {name} is missing: it has {_commands(family)}")
        cmd, number = self._cmd(family, call.arguments[0].value)
        return family.commands[number], head + cmd, call.arguments[1:]

    def _cmd(self, family: FamilySchema, value: Value) -> tuple[bytes, int]:
        """Returns the bytes of CMD and its number."""
        named = value
        while isinstance(named, NamedEncoding):
            named = named.value
        # A name that the text defines may be that of a CMD, too: LEGO's sources define SIZE and LINE.
        if isinstance(named, Name) and (
            named.text in _numbers(family) or named.text not in self._encoder.names.defines
        ):
            number = self._command_number(family, named.text, named.at)
            if named is value:
                return encode_integer(number), number
        encoded = self._encoder.argument(value, _cmd_schema(family))
        found = None if not isinstance(encoded, bytes) else CMD.read(encoded, 0)[0]
        if found is None or found.kind != CONSTANT:
            raise SourceError(value.at, f"the CMD of {family.opcode.name} must be a constant: {_commands(family)}")
        number = int(found.value)
        if number not in family.commands:
            raise SourceError(value.at, f"{family.opcode.name} has no CMD {number}: it has {_commands(family)}")
        assert isinstance(encoded, bytes)
        return encoded, number

    def _command_number(self, family: FamilySchema, name: str, at: int) -> int:
        numbers = _numbers(family)
        if name in numbers:
            return numbers[name]
        for command in family.opcode.commands:
            if command.name == name:
                others = ", ".join(dialect for dialect in command.dialects)
                where = f"{others} has" if others else "it is in headers only"
                raise SourceError(at, f"the {self._dialect} firmware has no {family.opcode.name}.{name}: {where}")
        hint = near_misses(name, numbers) or f": it has {_commands(family)}"
        raise SourceError(at, f"{family.opcode.name} has no CMD {name}{hint}")

    def _unknown(self, written: str, name: str) -> str:
        """Returns the error for an operation that the dialect lacks."""
        for dialect in DIALECTS:
            if name in opcodes(dialect):
                return f"the {self._dialect} firmware has no operation {name}; {dialect} has"
        systems = [] if is_operation_word(written) else [entry.name for entry in SYSTEM]
        known = opcodes(self._dialect)
        commands = (f"{family}.{command.name}" for family, opcode in known.items() for command in opcode.commands)
        hint = near_misses(_bare(written), [*known, *systems, *(commands if "." in written else ())])
        return f"unknown operation {written}{hint}"

    # Values

    def _with_count(
        self, schema: OperationSchema, arguments: tuple[WrittenArgument, ...], call: Call
    ) -> tuple[WrittenArgument, ...]:
        """Returns the arguments of a CALL with their count, if the text omits it.

        It does so after the name of a subroutine, and if the second value cannot be the count.
        """
        tail = schema.tail
        if tail is None or not tail.counter.any_type or not arguments or is_operation_word(call.name):
            return arguments
        first, *others = arguments
        is_by_name = isinstance(first.value, Name)
        if not is_by_name and (not others or self._encoder.whole_or_none(others[0].value) is not None):
            return arguments
        return (first, WrittenArgument(None, Number(first.at, len(others))), *others)

    def _elements(
        self, schema: OperationSchema, fixed: Sequence[Piece], arguments: Sequence[WrittenArgument]
    ) -> list[Piece]:
        """Returns the values of a list at the end, encoded as the list's type."""
        if schema.tail is None:
            return []
        given = arguments[len(fixed) :]
        known = [piece for piece in fixed if isinstance(piece, bytes)]
        if len(known) < len(fixed):
            raise SourceError(arguments[0].at, "a label cannot precede a list")
        try:
            # Zeros instead of the values show whether their number is right, and the type of each.
            placeholders = schema.make([*known, *[encode_integer(0)] * len(given)]).arguments[len(fixed) :]
        except BuildError as error:
            raise SourceError(arguments[len(fixed) - 1].at, str(error)) from None
        return [
            self._encoder.element(one.value, ArgumentSchema(placeholder.parameter))
            for one, placeholder in zip(given, placeholders, strict=True)
        ]

    def _incomplete(self, schema: OperationSchema, arguments: Sequence[WrittenArgument]) -> Iterator[Piece]:
        """Yields the arguments of an operation that is cut short."""
        for index, argument in enumerate(arguments):
            if argument.name is not None:
                raise SourceError(argument.name.at, "the values of an operation that is cut short have no names")
            parameter = schema.fixed[index] if index < len(schema.fixed) else _ELEMENT
            yield self._encoder.argument(argument.value, parameter)


def _check(schema: OperationSchema, head: bytes, pieces: Sequence[Piece], arguments: Sequence[WrittenArgument]) -> None:
    """Raises SourceError for the first value that means nothing to the brick.

    Values in a named encoding, DATA8_NAN and others like it are accepted.
    """
    code = head + b"".join(_ANY_DISTANCE if not isinstance(piece, bytes) else piece for piece in pieces)
    for number, sentence in objections(Operation((schema, code, 0, len(code)))):
        value = arguments[number].value
        if not _is_meant(value):
            raise SourceError(value.at, f"{sentence}; {_HOW_TO_MEAN_IT}")


def _is_meant(value: Value) -> bool:
    """Returns whether the encoding was written explicitly."""
    if isinstance(value, NamedEncoding):
        return value.name not in SHORTEST
    return isinstance(value, Raw) or (isinstance(value, Name) and value.text in NOT_NUMBERS)


def _in_order(
    schema: OperationSchema, arguments: tuple[WrittenArgument, ...], call: Call
) -> tuple[WrittenArgument, ...]:
    """Returns arguments in the order of the parameters, if they are given by name."""
    named = {argument.name.text.upper(): argument for argument in arguments if argument.name is not None}
    if not named:
        return arguments
    if len(named) < len(arguments):
        raise SourceError(arguments[0].at, "give the values in order, or each by its name once, not both")
    parameters = {one.parameter.name: one.parameter for one in schema.fixed}
    for name, argument in named.items():
        choice(name, argument.at, f"{schema.declaration.name} has no parameter", parameters)
    for name, parameter in parameters.items():
        if name not in named:
            raise SourceError(call.end, f"{schema.declaration.name} needs {name} too ({parameter.text})")
    return tuple(named[name] for name in parameters)


def _takes(schema: OperationSchema) -> str:
    """Returns `SOUND.TONE takes 3 values (VOLUME, FREQUENCY, DURATION)`."""
    names = [one.parameter.name for one in schema.fixed]
    count = counted(len(names), "value")
    if schema.tail is not None:
        count += " and a list"
    named = f" ({', '.join(names)})" if names else ""
    return f"{schema.declaration.name} takes {count}{named}"


def _bare(name: str) -> str:
    """Returns the name of an operation without the prefix `op`, after which case does not matter."""
    return name[2:].upper() if is_operation_word(name) else name


def _numbers(family: FamilySchema) -> dict[str, int]:
    """Returns the CMDs of a family by name."""
    return {
        schema.declaration.command.name: number
        for number, schema in family.commands.items()
        if schema.declaration.command is not None
    }


def _cmd_schema(family: FamilySchema) -> ArgumentSchema:
    """Returns the schema of CMD with its names."""
    enum = Enumeration(family.opcode.name, "its CMDs", _numbers(family))
    return ArgumentSchema(CMD.parameter._replace(enum=enum))


def _commands(family: FamilySchema) -> str:
    """Returns `BREAK, TONE, PLAY, REPEAT, SERVICE`; the first of many."""
    names = list(_numbers(family))
    return ", ".join(names[:_MOST_NAMED]) + (", ..." if len(names) > _MOST_NAMED else "")
