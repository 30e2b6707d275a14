"""Drafts of operations from one value for each parameter: the implementation of the functions of `ev3proto.ops`.

All kinds of values and mistakes are handled here. Most calls pass plain numbers and names and omit all
outputs, or have none. For those, the bytes of each value are cached once it was checked and encoded:
`ops.sound.tone(1, 440, 1000)` takes 1 us. All other calls are judged by the operation that they encode: 19 us for the
same one.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from typing import Any

from ev3proto.errors import BuildError, near_misses
from ev3proto.messages import Argument, Operation, Variable
from ev3proto.schema.argument import ArgumentSchema, shortest
from ev3proto.schema.instructions import OperationSchema, instruction_set
from ev3proto.semantics.domain import domain_of
from ev3proto.semantics.drafts.draft import OMITTED, STAND_IN, Draft, Open
from ev3proto.semantics.drafts.placeholders import NO_DISTANCE, Label, Need, Placeholder
from ev3proto.semantics.facts import ParameterFacts, operation_facts
from ev3proto.semantics.footprint import Footprint, footprints, inline_arrays
from ev3proto.semantics.judgement import Judgement, Wrong, judge, judged
from ev3proto.tables.declaration import Declaration, Direction, Parameter, Role, Type
from ev3proto.tables.encoding import CONSTANT, COUNTS, TEXT
from ev3proto.tables.ports import MotorPort, MotorPorts, SensorPort

HOW_TO_MEAN_IT = "pass unchecked=True to allow it"
"""The end of Python's error messages about values that can be encoded but have no meaning for the brick."""


def objections(operation: Operation) -> Iterator[tuple[int, str]]:
    """Yields what means nothing to the brick in an encoded operation: the number of an argument, and a sentence."""
    arguments, facts = operation.arguments, operation_facts(operation.schema)
    yield from _wrong_arrays(arguments)
    for number, argument in enumerate(arguments):
        judgement = None if argument.is_variable else judged(facts.of(number, argument.parameter), argument)
        if judgement is not None and judgement.wrong is not Wrong.NAN_FLOAT:
            yield number, _sentence(judgement, argument.name)
    yield from _wrong_places(footprints(operation, arguments))


def _wrong_places(used: Iterable[Footprint]) -> Iterator[tuple[int, str]]:
    """Yields misaligned variables, for which the brick refuses the whole command."""
    for footprint in used:
        multiple = footprint.facts.validator_alignment
        if footprint.start % multiple:
            kind = "a handle" if footprint.argument.form.handle else footprint.argument.parameter.type.label
            yield (
                footprint.number,
                f"{footprint.argument.name} cannot be {footprint.variable}: as {kind} it must be at a multiple of"
                f" {multiple}, or the brick refuses it",
            )


_ANOTHER = "{name} must be {choice}, not {value}"
_SENTENCES = {
    Wrong.LABEL: "{name} takes a number, not a label",
    Wrong.LABEL_BYTE: "{name} takes a number, not a label",
    Wrong.WRITTEN: "{name} cannot be {value!r}: the brick writes to it, so it takes a variable, GV(0) or Local()",
    Wrong.TEXT: "{name} takes a number or a variable, not {value!r}",
    Wrong.NUMBER: "{name} takes a string or a variable, not {value!r}",
    Wrong.WHOLE: "{name} takes a float, not the whole number {value}, whose bits the brick reads",
    Wrong.LONG: "{name} has {size} characters; the firmware accepts at most {most}",
}
"""What `ops` and the assembler say of a value; of others, which numbers are legal."""

_BEYOND_FLOATS = 1 << 128

_LEFT_TO_ENCODING = (Wrong.TEXT, Wrong.NUMBER, Wrong.NAN_FLOAT)
"""The encoder refuses these with the names of an enumeration; a float may be sent that is not a number."""


def _sentence(judgement: Judgement, name: str) -> str:
    parameter, value = judgement.known.parameter, judgement.value
    domain = domain_of(parameter)
    return _SENTENCES.get(judgement.wrong, _ANOTHER).format(
        name=name,
        value=value,
        choice="a number" if domain is None else domain.choice,
        size=len(str(value)),
        most=(parameter.most or 0) - 1,
    )


def _meaningless(sentence: str) -> BuildError:
    """Returns the error about a value that can be encoded."""
    return BuildError(f"{sentence}; {HOW_TO_MEAN_IT}")


def _wrong_arrays(arguments: Sequence[Argument]) -> Iterator[tuple[int, str]]:
    """Yields arrays inside the operation that have fewer bytes than their length says."""
    for array in inline_arrays(arguments):
        if array.stated > array.present:
            argument = array.argument
            has = f"a text of {array.present} bytes, including its zero" if argument.kind == TEXT else "one number"
            yield (
                arguments.index(argument),
                f"{argument.name} cannot be {argument.value!r}: {array.length} says that it has {array.stated} bytes,"
                f" but this is {has}",
            )


def wrong_name(parameter: Parameter, name: str) -> BuildError:
    """Returns the error for a text that is not a name of the enumeration."""
    domain = domain_of(parameter)
    assert parameter.enum is not None
    assert domain is not None
    hint = near_misses(name, [*parameter.enum.members, *parameter.names])
    if hint:
        return BuildError(f"{parameter.name} cannot be {name!r}{hint}")
    return BuildError(f"{parameter.name} must be {domain.choice}, not {name!r}")


class _Required:
    """The default of a required parameter after an optional one."""

    def __repr__(self) -> str:
        return "required"


REQUIRED: Any = _Required()

_ENUMS = "ev3proto.enums"
"""The module whose classes are the enumerations of the tables, under the same names."""


def may_be_omitted(declaration: Declaration, number: int) -> bool:
    """Returns whether a parameter, by its number from 0, is an output or the count of the list after it."""
    parameter, tail = declaration.parameters[number], declaration.tail
    if tail is None or parameter is not tail.counter:
        return parameter.direction is Direction.OUT
    return not parameter.counts or tail.direction is Direction.OUT


def draft(schema: OperationSchema, values: Sequence[Any], *, unchecked: bool = False) -> Draft:
    """Returns a draft from one value for each parameter, in order. Raises BuildError, and TypeError for REQUIRED.

    A value may be a `Placeholder`, or None for an omitted output or count; a list parameter takes a list, a list of
    outputs also their number. `unchecked` allows values without a meaning for the brick.
    """
    declaration = schema.declaration
    try:
        flat = schema.one_by_one(_in_order(schema, values, unchecked))
        places = {number: value for number, value in enumerate(flat) if isinstance(value, Placeholder | Open)}
        label = flat[-1] if declaration.is_jump and isinstance(flat[-1], Label) else None
        operation = schema.make([_standing(value) for value in flat] if places or label is not None else flat)
        if not unchecked:
            for _, sentence in objections(operation):
                raise _meaningless(sentence)
        _refuse_unknown_size(footprints(operation), places)
    except BuildError as error:
        sentence = str(error)
        prefix = "" if sentence.startswith(declaration.name) else f"{declaration.name}: "
        raise BuildError(prefix + sentence) from None
    return Draft(schema, operation.raw, places, label=label)


def _standing(value: Any) -> Any:
    if isinstance(value, Label):
        return NO_DISTANCE
    if isinstance(value, Open):
        return STAND_IN
    if isinstance(value, Placeholder):
        # The scope is kept for messages; the index has the shortest encoding.
        return Variable(value.scope, 0, value.handle, value.address)
    return value


def _in_order(schema: OperationSchema, values: Sequence[Any], unchecked: bool) -> list[Any]:
    """Returns one value for each parameter: a list is a list, omitted outputs are marked, an omitted count is None."""
    found: list[Any] = []
    declaration, facts = schema.declaration, operation_facts(schema)
    for number, (parameter, value) in enumerate(zip(declaration.parameters, values, strict=True)):
        if value is REQUIRED:
            raise TypeError(f"{declaration.name} also needs {parameter.name}")
        if parameter.is_list:
            found.append(_elements(parameter, value))
        elif value is not None:
            _check_constant(facts.of(number, parameter), value, unchecked=unchecked)
            found.append(value)
        elif may_be_omitted(declaration, number):
            found.append(OMITTED if parameter.direction is Direction.OUT else None)
        else:
            raise BuildError(f"{parameter.name} cannot be omitted: {parameter.text}")
    return found


def _elements(parameter: Parameter, value: Any) -> list[Any]:
    if parameter.elements is not Direction.IN:
        if value is None:
            return [OMITTED]
        if isinstance(value, int) and not isinstance(value, bool):
            if not 0 <= value <= COUNTS.high:
                raise BuildError(f"{parameter.name} must be 0 to {COUNTS.high} as a number of outputs, not {value}")
            return [OMITTED] * value
        if isinstance(value, Variable | Placeholder):
            return [value]
    if isinstance(value, str | bytes) or not isinstance(value, Iterable):
        raise BuildError(f"{parameter.name} takes a list, not {value!r}")
    return [OMITTED if element is None else element for element in value]


def _check_constant(known: ParameterFacts, value: Any, *, unchecked: bool = False) -> None:
    """Refuses an illegal constant, or with `unchecked` only an unknown name. Raises BuildError."""
    parameter = known.parameter
    if parameter.enum is not None:
        _check_name(parameter, value)
    if isinstance(value, MotorPorts | MotorPort | SensorPort):
        _check_port(parameter, value)
    if parameter.role is Role.JUMP and isinstance(value, str):
        raise BuildError(f"{parameter.name} takes a number, a variable or {Label(value or 'again')!r}, not {value!r}")
    if not unchecked and isinstance(value, int | float | str) and parameter.direction is not Direction.OUT:
        _check_meaning(known, value)


def _check_meaning(known: ParameterFacts, value: float | str) -> None:
    """Refuses a constant that means nothing to the brick."""
    parameter = known.parameter
    number = parameter.number_of(value) if isinstance(value, str) else value
    meant = value if number is None else number
    if isinstance(meant, int):
        meant = int(meant)  # for a member of an enumeration, `in` would try each number of a range
        if parameter.type is Type.DATAF:
            meant = float(meant) if abs(meant) < _BEYOND_FLOATS else math.inf
    judgement = judge(known, TEXT if isinstance(meant, str) else CONSTANT, meant)
    if judgement is None or judgement.wrong in _LEFT_TO_ENCODING:
        return
    sentence = _sentence(judgement._replace(value=value), parameter.name)
    try:
        shortest(parameter, value)
    except BuildError:
        raise BuildError(sentence) from None
    raise _meaningless(sentence)


_PORTS = {Role.MOTORS: MotorPorts, Role.MOTOR: MotorPort, Role.PORT: SensorPort}
"""The names of ports that parameters take, by their role."""


def _check_port(parameter: Parameter, value: MotorPorts | MotorPort | SensorPort) -> None:
    """Refuses the bit of a port where its number is meant, and the other way round."""
    expected = None if parameter.role is None else _PORTS.get(parameter.role)
    if expected is not None and not isinstance(value, expected):
        raise BuildError(f"{parameter.name} takes a {expected.__name__} or a number, not {value!r}: {parameter.text}")


def _check_name(parameter: Parameter, value: Any) -> None:
    """Refuses a name that is not in the parameter's enumeration, or a member of another one."""
    assert parameter.enum is not None
    if isinstance(value, str) and parameter.number_of(value) is None and parameter.length is None:
        raise wrong_name(parameter, value)
    meant = type(value)
    is_of_another = meant.__module__ == _ENUMS and meant.__name__ != parameter.enum.name
    if is_of_another and value.name not in parameter.names:
        raise BuildError(f"{parameter.name} takes a member of {parameter.enum.name}, not {value!r}")


def _refuse_unknown_size(used: Iterable[Footprint], places: Mapping[int, Placeholder | Open]) -> None:
    for found in used:
        if found.room is None and isinstance(places.get(found.number), Open):
            raise BuildError(
                f"{found.argument.name} cannot be omitted: its length is unknown. Pass its size,"
                " Global(32), or its place, GV(0)"
            )


_MOST_KEPT = 4096
"""Maximum number of cached values of one parameter."""

_KEPT_TYPES = frozenset({int, str, type(None)})
"""Types of the cached values. Members of enumerations are not cached: they equal the members of other enumerations."""


class _Constants(dict[Any, bytes]):
    """A cache of the encoded legal constants of one parameter, with a KeyError for other values."""

    def __init__(self, schema: ArgumentSchema, facts: ParameterFacts) -> None:
        super().__init__()
        self._schema = schema
        self._facts = facts

    def __missing__(self, value: Any) -> bytes:
        is_number = type(value) is int
        try:
            if not is_number or value not in self._facts.legal:
                _check_constant(self._facts, value)
            encoded = self._schema.write(value)
        except BuildError:
            raise KeyError(value) from None
        # Names are cached, arbitrary texts are not.
        if len(self) < _MOST_KEPT and (is_number or self._schema.parameter.enum is not None):
            self[value] = encoded
        return encoded


_OMITTED_OUTPUT = {None: STAND_IN}
"""The cache of an output."""


class OperationDrafts:
    """Drafts of one operation."""

    __slots__ = ("_head", "_known", "_needs", "_places", "_schema")

    def __init__(self, schema: OperationSchema) -> None:
        self._schema = schema
        self._head = schema.head
        self._places: dict[int, Open] = {}
        self._known: tuple[dict[Any, bytes], ...] | None = None
        needs = _needs(schema)
        self._needs = needs or ()
        if needs is not None:
            inputs = schema.fixed[: len(schema.fixed) - len(needs)]
            facts = operation_facts(schema).parameters
            self._known = (*map(_Constants, inputs, facts), *(_OMITTED_OUTPUT for _ in needs))
            self._places = {len(inputs) + number: OMITTED for number in range(len(needs))}

    def draft(self, values: Sequence[Any], unchecked: bool) -> Draft:
        """Returns a draft from one value for each parameter, like `ev3proto.semantics.drafts.functions.draft`."""
        if self._known is not None and not unchecked:
            encoded = self._head
            try:
                for known, value in zip(self._known, values, strict=True):
                    if type(value) not in _KEPT_TYPES:
                        break
                    encoded += known[value]
                else:
                    return Draft(self._schema, encoded, self._places, self._needs)
            except KeyError:
                pass  # The general way reports what is wrong.
        return draft(self._schema, values, unchecked=unchecked)


def _needs(schema: OperationSchema) -> tuple[Need, ...] | None:
    """Returns what the outputs of an operation need if all are omitted; None if that depends on the arguments."""
    if schema.tail is not None:
        return None
    found: list[Need] = []
    for facts in operation_facts(schema).parameters:
        parameter = facts.parameter
        if parameter.length is not None or parameter.direction is Direction.INOUT:
            return None
        if parameter.direction is Direction.OUT:
            if facts.is_counted or facts.room is None:
                return None
            found.append(Need(f"{parameter.name} of {schema.declaration.name}", facts.room, facts.alignment))
        elif found:
            return None
    return tuple(found)


class Drafts(dict[str, OperationDrafts]):
    """Drafts of the operations of one dialect by name (`SOUND.TONE`); each is prepared on first use."""

    def __init__(self, dialect: str) -> None:
        super().__init__()
        self._dialect = dialect

    def __missing__(self, name: str) -> OperationDrafts:
        found = self[name] = OperationDrafts(instruction_set(self._dialect)[name])
        return found


@cache
def drafts(dialect: str) -> Drafts:
    """Returns the drafts of one dialect's operations."""
    return Drafts(dialect)
