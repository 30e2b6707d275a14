"""Every operation of every dialect: it composes to what was asked, and everything agrees about its memory.

Constants come back, and variables are aligned, within the memory that the header requests, and apart from each other:
this is worked out here from the protocol's description. Where `command` or the assembler chooses places or sizes, a
check has nothing to say about memory, and a dialogue reads each output where it was placed. Variables given by hand are
aligned and apart from each other here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from random import Random
from typing import Any

from support.cases import each
from support.effort import effort

import ev3proto
from ev3proto import GV, Argument, DirectCommand, Draft, Global, Local, Variable, check, command
from ev3proto.compose import Placeholder
from ev3proto.semantics.footprint import footprints
from ev3proto.tables import operations
from ev3proto.tables.declaration import DIALECTS, Declaration, Direction, Effect, Parameter, Type
from ev3proto.text.assembly import assemble, operation_line

ABOUT_MEMORY = {"E205", "E401", "E402", "W401", "W402", "W403", "W404", "W405", "H401"}

APART = 64
"""Bytes between variables given by hand: more than any array here has."""

SIZES = {Type.DATA16: 2, Type.HANDLE: 2, Type.DATA32: 4, Type.DATAF: 4, Type.ARRAY_TYPED: 4}
"""Bytes of what is not a byte."""

LARGEST = {Type.DATA8: 127, Type.DATA16: 32767, Type.DATA32: 2**31 - 1, Type.LABEL: 0}


def _home() -> Iterator[tuple[str, Declaration]]:
    """Each entry once, with the first dialect that has it."""
    seen: set[int] = set()
    for dialect in DIALECTS:
        for name, declaration in operations(dialect).items():
            entry = id(declaration.command or declaration.opcode)
            if entry not in seen and name != "ERROR" and Effect.ENDS not in declaration.effects:
                seen.add(entry)
                yield dialect, declaration


HOME = {f"{dialect}-{declaration.name}": (dialect, declaration) for dialect, declaration in _home()}


class Values:
    """One value for each parameter of an operation."""

    def __init__(self, declaration: Declaration, random: Random) -> None:
        self._declaration = declaration
        self._random = random
        self._next = 0
        parameters = declaration.parameters
        self._tellers = {parameter.length or parameter.indexed_by for parameter in parameters}
        self._types = {parameter.element for parameter in parameters if isinstance(parameter.element, str)}

    def all(self) -> list[Any]:
        parameters = self._declaration.parameters
        return [self._value(parameter) for parameter in parameters if not self._is_counted(parameter)]

    def _is_counted(self, parameter: Parameter) -> bool:
        """Whether it is the number of the values after it, which is computed."""
        last = self._declaration.parameters[-1]
        return last.is_list and not last.counts and parameter is self._declaration.parameters[-2]

    def by_hand(self) -> Variable:
        self._next += APART
        return GV(self._next - APART)

    def _one_of(self, *choices: Callable[[], Any]) -> Any:
        return self._random.choice(choices)()

    def _value(self, parameter: Parameter) -> Any:
        if parameter.counts and parameter.elements is Direction.OUT:
            return self._one_of(lambda: None, lambda: 3, lambda: [None, self.by_hand(), Local()])
        if parameter.is_list:
            return self._one_of(list, lambda: [1, 2], lambda: [self.by_hand(), Global()])
        is_text = parameter.type is Type.STRING
        is_told = not isinstance(parameter.length, str) or not self._is_result(parameter.length)
        is_open = is_text and parameter.length is None
        if parameter.direction is Direction.OUT and is_told and not is_open:
            return self._one_of(lambda: None, Local, Global, self.by_hand)
        if parameter.direction is not Direction.IN:
            return Global(None if is_told and not is_open else 16)
        if parameter.name in self._tellers:
            numbers = parameter.range or (0, 5)
            return self._random.choice((max(numbers[0], 0), 1, 5))
        if parameter.name in self._types:
            return "DATA_32"
        if parameter.length is not None:
            return self._one_of(Global, lambda: "x" * APART, self.by_hand)
        if parameter.indexed_by is not None:
            return self._one_of(Global, self.by_hand)
        return self._one_of(
            lambda: self._constant(parameter),
            lambda: self._constant(parameter),
            lambda: Global(8) if is_text else Local(),
            lambda: Local().as_handle(),
            lambda: Local().as_address(),
            # The length of a text is unknown, so no place after one given by hand is safe.
            (lambda: Global(8)) if is_text else self.by_hand,
        )

    def _is_result(self, name: str) -> bool:
        return any(parameter.name == name and parameter.is_output for parameter in self._declaration.parameters)

    def _constant(self, parameter: Parameter) -> Any:
        if parameter.type is Type.STRING:
            return self._random.choice(("", "ab", "größer"))
        if parameter.range is not None:
            return self._random.choice((self._random.randint(*parameter.range), *parameter.range, *parameter.special))
        if parameter.enum is not None:
            return self._random.choice((*parameter.enum.members, *parameter.enum.members.values()))
        largest = LARGEST.get(parameter.type, 0)
        return 0.5 if parameter.type is Type.DATAF else self._random.randint(-largest, largest)


def _function(declaration: Declaration, dialect: str) -> Callable[..., Draft]:
    import ev3proto.ops.compat
    import ev3proto.ops.xtended

    found: Any = ev3proto.ops if dialect == "official" else vars(ev3proto.ops)[dialect]
    for part in declaration.name.lower().split("."):
        found = getattr(found, f"{part}_" if part in ("break", "return") else part)
    return found  # type: ignore[no-any-return]


def _drawn(declaration: Declaration, random: Random) -> list[list[Any]]:
    """Values for two operations in one command, so that their places must be apart."""
    parameters = declaration.parameters
    values = Values(declaration, random)
    drawn = [values.all() for _ in range(2)]
    if parameters and parameters[-1].is_list and not parameters[-1].counts:
        drawn = [[*given[:-1], None, given[-1]] for given in drawn]
    return drawn


def _about_memory(message: ev3proto.Message, dialect: str) -> list[str]:
    found = check(message.build(), dialect=dialect).findings
    return [f"{finding.code}: {finding.message}" for finding in found if finding.code in ABOUT_MEMORY]


@each("name", HOME)
def test_compose_check_and_dialogue_agree_about_memory(name: str) -> None:
    dialect, declaration = HOME[name]
    function = _function(declaration, dialect)
    for round_ in range(effort(4, 50)):
        drawn = _drawn(declaration, Random(f"{name} {round_}"))
        message = command(*(function(*values) for values in drawn), counter=7)
        assert ev3proto.parse(message.build(), dialect=dialect) == message
        for operation, values in zip(message.operations, drawn, strict=True):
            _assert_says(declaration, list(operation.arguments), values)
        _assert_laid_out(message)
        assert _about_memory(message, dialect) == [], message.operations
        _assert_read_where_it_is(message)
        text = "\n".join(operation_line(operation) for operation in message.operations)
        (assembled,) = assemble(text, dialect=dialect)
        assert _about_memory(assembled, dialect) == [], text


def _assert_says(declaration: Declaration, left: list[Argument], values: list[Any]) -> None:
    """The constants are those that were asked for; where variables were to be found, there are some."""
    for parameter, value in zip(declaration.parameters, values, strict=True):
        elements = [value]
        if parameter.is_list and not parameter.counts:
            elements = value
        elif parameter.counts:
            elements = [None] * value if isinstance(value, int) else [None] if value is None else value
            assert left.pop(0).value == len(elements)
        elif value is None and not parameter.is_output:
            elements = [len(values[-1])]
        for one in elements:
            _assert_value(left.pop(0), parameter, one)
    assert left == []


def _assert_value(argument: Argument, parameter: Parameter, value: Any) -> None:
    if value is None or isinstance(value, Placeholder | Variable):
        assert argument.kind == ("global" if value is None else value.scope)
        assert not isinstance(value, Variable) or argument.value == value.index
        return
    if parameter.enum is not None and isinstance(value, str):
        value = parameter.enum.members.get(value, value)
    assert argument.value == value


def _assert_laid_out(message: DirectCommand) -> None:
    """Every variable is aligned, within the memory that is requested, and shares no byte with another."""
    taken: dict[str, set[int]] = {"global": set(), "local": set()}
    for operation in message.operations:
        told = {argument.name: argument.value for argument in operation.arguments if not argument.is_variable}
        for argument in operation.arguments:
            if argument.is_variable:
                form, parameter = argument.form, argument.parameter
                size = 4 if form.address else 2 if form.handle else SIZES.get(parameter.type, 1)
                assert int(argument.value) % size == 0
                length = told.get(str(parameter.length), parameter.length)
                if isinstance(length, int) and not (form.handle or form.address):
                    size *= abs(length)
                span = set(range(int(argument.value), int(argument.value) + size))
                assert not span & taken[argument.kind], argument
                taken[argument.kind] |= span
    assert max(taken["global"], default=-1) < message.global_size
    assert max(taken["local"], default=-1) < message.local_size


def _assert_read_where_it_is(message: DirectCommand) -> None:
    """A dialogue reads every output of a command at the place that its footprint says."""
    used = [found for operation in message.operations for found in footprints(operation)]
    expected = {
        (found.argument.name, 5 + found.start)
        for found in used
        if found.argument.parameter.is_output
        and found.argument.kind == "global"
        and not found.argument.form.address
        and found.size
    }
    dialogue = ev3proto.Dialogue()
    dialogue.feed(message)
    values = dialogue.feed(ev3proto.direct_reply(b"\x01" * message.global_size, counter=7))
    assert bool(expected) <= message.wants_reply
    assert {(value.name, value.offset) for value in values if value.length} == expected
