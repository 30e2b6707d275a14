"""What an argument of a direct command may be: one table, by kind of parameter.

Two questions are answered for each. Is it bounded: does every brick read it in the same way, and write and jump only
where it may? And does it only read: is it, beyond that, as `proxy --read-only` requires?
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from ev3proto.link.known import NOTHING, Known
from ev3proto.messages import Argument, DirectCommand, Operation
from ev3proto.semantics.facts import UNTYPED_SIZE, facts_of
from ev3proto.semantics.footprint import Footprint, footprints, whole_number
from ev3proto.semantics.judgement import judge
from ev3proto.tables.declaration import Parameter, Role, Type
from ev3proto.tables.encoding import CONSTANT, GLOBAL, JUMP, LOCAL, TEXT, limits_of
from ev3proto.tables.enumerations import TYPE
from ev3proto.tables.frame import GRANTED_GLOBALS, MAX_LOCALS
from ev3proto.tables.paths import WHOLE, is_allowed
from ev3proto.tables.reading import ReadOnly, is_own
from ev3proto.tables.validation import LABELS

GRANTED = {GLOBAL: GRANTED_GLOBALS, LOCAL: MAX_LOCALS}
"""The memory that every direct command has, whatever it requests."""

LONGEST_TEXT = 127
"""Bytes of the longest text that an operation returns; the firmware reads its length as a signed byte."""

_NUMBER_TEXT = 129
"""Bytes of the longest text of a number, and more than any other text that STRINGS adds to those it is given."""

_FORMAT = re.compile(r"[^%]*%[-+ #0]*\d{0,2}(\.\d{0,2})?[acdefgiouxAEFGX][^%]*")
"""A format of C's printf that reads one number and writes only the text."""

_BYTE = 0xFF


class References:
    """The operations of a direct command, and what its arguments refer to."""

    def __init__(self, command: DirectCommand) -> None:
        """Looks at a command whose operations can be read."""
        self.operations = command.operations
        self.requested: Mapping[str, int] = {GLOBAL: command.global_size, LOCAL: command.local_size}

    @cached_property
    def targets(self) -> frozenset[object]:
        """The allowed targets of jumps: the offsets of operations and of the end, and labels."""
        arguments = (argument for operation in self.operations for argument in operation.arguments)
        labels = {whole_number(one) for one in arguments if one.parameter.role is Role.LABEL}
        return frozenset(
            [(CONSTANT, at) for one in self.operations for at in (one.offset, one.offset + one.length)]
            + [(JUMP, number) for number in range(1, LABELS) if number in labels]
        )

    @cached_property
    def _written(self) -> list[Footprint]:
        places = (place for operation in self.operations for place in footprints(operation))
        return [place for place in places if place.facts.is_written]

    def writers(self, argument: Argument) -> list[Footprint]:
        """Returns what may write to the variable that an argument is read from."""
        assert isinstance(argument.value, int)
        start, end = argument.value, argument.value + max(argument.parameter.type.size, 1)
        return [
            place
            for place in self._written
            if place.argument.kind == argument.kind and place.start < end and start < end_of(place)
        ]


@dataclass(frozen=True)
class Use:
    """An argument, where it is, and what is known of the brick."""

    argument: Argument
    operation: Operation
    code: References
    known: Known

    @property
    def parameter(self) -> Parameter:
        """What the argument is for."""
        return self.argument.parameter

    @property
    def number(self) -> int | None:
        """Its value, if it is a constant."""
        return whole_number(self.argument)


Check = Callable[[Use], bool]


class Rule(NamedTuple):
    """What the arguments for one kind of parameter may be."""

    is_for: Callable[[Parameter, Operation], bool]
    is_bounded: Check
    only_reads: Check
    otherwise: str = ""  # what an argument is that does more than read


# Kinds of parameters


def _is_result(parameter: Parameter, _: Operation) -> bool:
    return parameter.is_output or parameter.stores


def _has_role(role: Role) -> Callable[[Parameter, Operation], bool]:
    return lambda parameter, _: parameter.role is role


def _has_type(type: Type) -> Callable[[Parameter, Operation], bool]:
    return lambda parameter, _: parameter.type is type


def _is_count(parameter: Parameter, operation: Operation) -> bool:
    tail = operation.declaration.tail
    return tail is not None and parameter is tail.counter


def _is_length_of_text(parameter: Parameter, operation: Operation) -> bool:
    declared = operation.declaration.parameters
    return parameter.name in {one.length for one in declared if one.is_output and one.type is Type.STRING}


def _is_path(parameter: Parameter, _: Operation) -> bool:
    return parameter.type is Type.STRING and parameter.most == WHOLE


def _is_device_type(parameter: Parameter, _: Operation) -> bool:
    return parameter.enum is TYPE


def _has_range(parameter: Parameter, _: Operation) -> bool:
    return parameter.range is not None


def _is_anything(_: Parameter, __: Operation) -> bool:
    return True


# What their arguments may be


def _never(_: Use) -> bool:
    return False


def _is_variable(use: Use) -> bool:
    return use.argument.is_variable and not use.argument.form.handle


def _is_target(use: Use) -> bool:
    form, number, operation = use.argument.form, use.number, use.operation
    if form.kind == JUMP:
        return (JUMP, use.argument.value) in use.code.targets
    return number is not None and (form.kind, operation.offset + operation.length + number) in use.code.targets


def _is_constant_count(use: Use) -> bool:
    # A count in a variable is its index when the firmware checks a command, and its value when it runs it.
    limits = limits_of(use.parameter)
    return use.number is not None and limits is not None and 0 <= use.number <= limits.high


def _is_constant_length(use: Use) -> bool:
    return use.number is not None and 0 < use.number <= LONGEST_TEXT


def _is_safe_format(use: Use) -> bool:
    return use.argument.kind == TEXT and _FORMAT.fullmatch(str(use.argument.value)) is not None


def _is_any_argument(_: Use) -> bool:
    return True


def _is_no_label(use: Use) -> bool:
    return use.argument.kind != JUMP


def _is_own_path(use: Use) -> bool:
    # The firmware never stops trying to open a forbidden name.
    path = use.argument.raw[1:-1]
    return use.argument.kind == TEXT and is_allowed(path) and is_own(path)


def _is_own_file(use: Use) -> bool:
    """Returns whether only OPEN_READ, of files that exist, has written to a handle, and has done so before."""
    if not _is_variable(use):
        return False
    opened = [place.operation for place in use.code.writers(use.argument) if _is_opened(place, use.argument)]
    return (
        len(opened) == len(use.code.writers(use.argument)) > 0
        and all(use.known.has_file(path_of(one)) for one in opened)
        and min(one.offset for one in opened) < use.operation.offset
    )


def _is_opened(place: Footprint, handle: Argument) -> bool:
    is_handle = place.argument.parameter.type is Type.HANDLE and place.argument.value == handle.value
    return is_handle and path_of(place.operation) is not None


def path_of(operation: Operation) -> bytes | None:
    """Returns the path that an operation is given as a text; None if there is none."""
    found = (one for one in operation.arguments if _is_path(one.parameter, operation) and one.kind == TEXT)
    argument = next(found, None)
    return None if argument is None else argument.raw[1:-1]


def _is_present_type(use: Use) -> bool:
    """Returns whether the brick reports this type at the port, or the operation keeps what is there."""
    value = type_value(use)
    return value is not None and (value & _BYTE == 0 or use.known.has_type(port_of(use.operation), value & _BYTE))


def type_value(use: Use) -> int | None:
    """Returns a constant, or what is in a variable that the command itself does not write to; None if unknown."""
    argument = use.argument
    if not argument.is_variable:
        return use.number
    assert isinstance(argument.value, int)
    if argument.form.handle or use.code.writers(argument):
        return None
    return 0 if argument.kind == LOCAL and argument.value < MAX_LOCALS else use.known.memory_at(argument)


def port_of(operation: Operation) -> tuple[int, int] | None:
    """Returns the layer and the port that an operation names as constants; None if it does not."""
    layer, port = (
        whole_number(next((one for one in operation.arguments if one.parameter.role is role), None))
        for role in (Role.LAYER, Role.PORT)
    )
    return None if layer is None or port is None else (layer, port)


def _is_legal_constant(use: Use) -> bool:
    argument = use.argument
    return argument.kind == CONSTANT and judge(facts_of(use.parameter), CONSTANT, argument.value) is None


def _is_number(use: Use) -> bool:
    return _is_variable(use) or _is_legal_constant(use)


RULES = (
    # for                       is bounded          only reads
    Rule(_is_result, _is_variable, _is_variable),
    Rule(_has_role(Role.JUMP), _is_target, _never),
    Rule(_has_role(Role.LABEL), _is_any_argument, _never),
    Rule(_is_count, _is_constant_count, _is_constant_count),
    Rule(_is_length_of_text, _is_constant_length, _is_constant_length),
    Rule(_has_role(Role.FORMAT), _is_safe_format, _never),
    Rule(_has_type(Type.HANDLE), _is_no_label, _is_own_file),
    Rule(_is_path, _is_no_label, _is_own_path),
    Rule(_has_type(Type.STRING), _is_no_label, _never),
    Rule(_is_device_type, _is_no_label, _is_present_type, "not the type of the device at that port"),
    Rule(_has_range, _is_no_label, _is_legal_constant),
    Rule(_is_anything, _is_no_label, _is_number),
)
"""The first that is for a parameter decides."""


def is_bounded(operation: Operation, code: References, memory: Mapping[str, int]) -> bool:
    """Returns whether every brick reads an operation in the same way, and it writes and jumps only where it may."""
    return _follows_rules(operation, code, NOTHING, lambda rule: rule.is_bounded) and all(
        end_of(place) <= memory[place.argument.kind] for place in footprints(operation) if place.facts.is_written
    )


def only_reads(operation: Operation, row: ReadOnly, code: References, known: Known) -> bool:
    """Returns whether an operation on the list does what its row says, and nothing else, with these arguments."""
    places = footprints(operation)
    return (
        is_bounded(operation, code, code.requested)
        and _follows_rules(operation, code, known, lambda rule: rule.only_reads)
        and all(end_of(place) <= GRANTED[place.argument.kind] for place in places)
        and all(
            place.start + row.room[place.argument.name] <= code.requested[place.argument.kind]
            for place in places
            if place.argument.name in row.room
        )
        and all(whole_number(one) == row.only.get(one.name, whole_number(one)) for one in operation.arguments)
    )


def _follows_rules(operation: Operation, code: References, known: Known, check: Callable[[Rule], Check]) -> bool:
    # Older firmware takes the arguments of an unknown CMD for operations.
    cmd = operation.cmd
    if operation.declaration.is_newer or (cmd is not None and (cmd.form.handle or cmd.form.address)):
        return False
    is_direct = not any(argument.form.address for argument in operation.arguments)
    return is_direct and next(_broken(operation, code, known, check), None) is None


def _broken(
    operation: Operation, code: References, known: Known, check: Callable[[Rule], Check]
) -> Iterator[tuple[Argument, Rule]]:
    """Yields the arguments that do not follow their rules."""
    for argument in operation.arguments:
        rule = _rule(argument.parameter, operation)
        if not check(rule)(Use(argument, operation, code, known)):
            yield argument, rule


def changing_argument(operation: Operation, code: References, known: Known) -> str:
    """Returns the argument for which an operation on the list does more than read, as words after its name."""
    for argument, rule in _broken(operation, code, known, lambda rule: rule.only_reads):
        shown = f"{argument.name} {argument.value}" if argument.kind == CONSTANT else f"this {argument.name}"
        return f" with {shown}{rule.otherwise and f' ({rule.otherwise})'}"
    return ""


def _rule(parameter: Parameter, operation: Operation) -> Rule:
    return next(rule for rule in RULES if rule.is_for(parameter, operation))


def end_of(place: Footprint) -> float:
    """Returns the end of the memory that an operation may use through an argument."""
    if place.most is not None:
        return place.start + place.most
    parameter = place.argument.parameter
    if parameter.type is Type.ARRAY_TYPED and parameter.length is None:
        return place.start + UNTYPED_SIZE
    texts = [
        one for one in place.operation.arguments if one.parameter.type is Type.STRING and not one.parameter.is_output
    ]
    if parameter.type is not Type.STRING or parameter.length is not None or any(one.kind != TEXT for one in texts):
        return math.inf
    return place.start + _NUMBER_TEXT + sum(one.length for one in texts)
