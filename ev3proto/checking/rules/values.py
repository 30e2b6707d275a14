"""Constants: what the type cannot hold, what the tables do not provide for, what stands where something else should."""

from __future__ import annotations

import math
from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckedOperation
from ev3proto.checking.facts import ParameterFacts, parameter_facts
from ev3proto.checking.report import Finding
from ev3proto.messages import Argument
from ev3proto.semantics.domain import Domain
from ev3proto.tables.declaration import Direction, Role, Type
from ev3proto.tables.encoding import GLOBAL, LOCAL, RANGES, TEXT
from ev3proto.tables.validation import LABELS

_BYTES_OF_NUMBERS = {Type.DATA8: 1, Type.DATA16: 2, Type.DATA32: 4, Type.HANDLE: 2}


def check_values(operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    """The constants of all operations."""
    for operation in operations:
        yield from _values(operation)


def _values(operation: CheckedOperation) -> Iterator[Finding]:
    known_parameters = operation.facts.parameters
    for number, argument in enumerate(operation.arguments):
        parameter, form, value, *_ = argument
        kind = form.kind
        if kind in (LOCAL, GLOBAL):
            continue
        known = known_parameters[number] if number < len(known_parameters) else parameter_facts(parameter)
        # A range looks at all of its numbers, one by one, for what is no whole number.
        if type(value) is int and value in known.numbers:
            continue
        is_first = not number and not operation.facts.has_cmd
        if form.handle or form.address:
            # Only the brick knows what is there. Its validator takes the handle or address itself for the value.
            if is_first and isinstance(value, int):
                yield from _refused(operation, argument, value, known)
            continue
        if parameter.direction is not Direction.IN:
            yield _constant_output(operation, argument)
        elif kind == TEXT:
            if parameter.type is not Type.STRING and parameter.length is None and parameter.type is not _UNTYPED:
                yield _text_for_number(operation, argument)
        elif isinstance(value, float):
            if math.isnan(value):
                yield _not_a_number(operation, argument)
        elif parameter.type is Type.STRING:
            yield _number_for_text(operation, argument)
        elif parameter.type is Type.DATAF:
            if value and parameter.length is None:
                yield _integer_for_float(operation, argument)
        else:
            assert isinstance(value, int)
            yield from _number(operation, argument, value, known, is_first=is_first)


_UNTYPED = Type.ARRAY_TYPED


def _number(
    operation: CheckedOperation, argument: Argument, value: int, known: ParameterFacts, *, is_first: bool
) -> Iterator[Finding]:
    """What is wrong with a whole number."""
    parameter, domain = known.parameter, known.domain
    refused = list(_refused(operation, argument, value, known)) if is_first else []
    if refused or parameter.type is Type.LABEL:
        yield from refused
        return
    size = _BYTES_OF_NUMBERS.get(parameter.type)
    if size is not None:
        limits = RANGES[parameter.type]
        if not limits.low <= value <= limits.high:
            yield _cut_down(operation, argument, value, size, known)
            return
    if domain is None or domain.covers(value):
        return
    yield _illegal(operation, argument, value, domain)


def _illegal(operation: CheckedOperation, argument: Argument, value: int, domain: Domain, aside: str = "") -> Finding:
    """A number that the tables do not provide for."""
    parameter = argument.parameter
    if domain.has_names:
        assert parameter.enum is not None
        return operation.finding_at(
            codes.NO_MEMBER,
            argument,
            f"{argument.name} is {value}, which {parameter.enum.name} has no name for{aside}",
            f"give {domain.choice}",
        )
    unit = f" {parameter.unit}" if parameter.unit else ""
    return operation.finding_at(
        codes.OUT_OF_RANGE,
        argument,
        f"{argument.name} is {value}{unit}, outside of {domain.text}{aside}",
        f"give {domain.text}",
    )


def _refused(operation: CheckedOperation, argument: Argument, value: int, known: ParameterFacts) -> Iterator[Finding]:
    """A first parameter that the validator does not let pass."""
    parameter = known.parameter
    if parameter.role is Role.LABEL:
        if not 0 <= value < LABELS:
            yield operation.finding_at(
                codes.BAD_LABEL,
                argument,
                f"{argument.name} is {value}, and there are labels 0 to {LABELS - 1}",
                f"give 1 to {LABELS - 1}; jumps cannot name label 0",
            )
        return
    checked = parameter.validated or parameter.type
    if checked is Type.STRING:
        # Of a text, the validator sees its first character.
        checked = Type.DATA8
    limits = RANGES.get(checked)
    if limits is not None and not limits.low <= value <= limits.high:
        yield operation.finding_at(
            codes.FIRST_OUT_OF_RANGE,
            argument,
            f"{argument.name} is {value}, and the brick takes {limits.low} to {limits.high} as {checked}"
            " in a first parameter",
            _value_help(known),
        )


def _cut_down(operation: CheckedOperation, argument: Argument, value: int, size: int, known: ParameterFacts) -> Finding:
    """A number that more bytes were given than the parameter has, or the one that means that there is none."""
    parameter = argument.parameter
    nan = RANGES[parameter.type].nan
    bits = 8 * size
    if value == nan:
        return _not_a_number(operation, argument)
    kept = value & (1 << bits) - 1
    read = kept - (1 << bits) if kept >> bits - 1 else kept
    if 0 <= value < 1 << bits:
        if known.domain is not None and not known.domain.covers(read):
            return _illegal(operation, argument, value, known.domain, f", and the brick reads it as {read}")
        return operation.finding_at(
            codes.NEGATIVE,
            argument,
            f"{parameter.name} is {value}, which the brick reads as {read}: it is {_article(parameter.type)}",
            f"write {read} if these bits are meant, or else a number that fits",
        )
    return operation.finding_at(
        codes.TRUNCATED,
        argument,
        f"{parameter.name} is {value}, of which the brick keeps {read}: it is {_article(parameter.type)}",
        _value_help(known),
    )


def _article(kind: Type) -> str:
    limits = RANGES[kind]
    return f"a {kind}, {limits.low} to {limits.high}"


def _value_help(known: ParameterFacts) -> str:
    if known.domain is not None:
        return f"give {known.domain.choice}"
    limits = RANGES.get(known.parameter.type)
    return "give a text" if limits is None else f"give {limits.low} to {limits.high}"


def _not_a_number(operation: CheckedOperation, argument: Argument) -> Finding:
    return operation.finding_at(
        codes.NOT_A_NUMBER,
        argument,
        f'{argument.name} is {argument.value}, which means "not a number"',
        "give a number, unless just that is meant",
    )


def _constant_output(operation: CheckedOperation, argument: Argument) -> Finding:
    parameter = argument.parameter
    wide = parameter.type.size
    room = f" that has room for {parameter.type}" if wide else ""
    return operation.finding_at(
        codes.CONSTANT_OUTPUT,
        argument,
        f"{argument.name} is a constant, and the brick writes there",
        f"give a variable{room}: global for the reply, or local",
    )


def _number_for_text(operation: CheckedOperation, argument: Argument) -> Finding:
    return operation.finding_at(
        codes.NUMBER_FOR_TEXT,
        argument,
        f"{argument.name} is the number {argument.value}, and the brick reads a text",
        "give a text as LCS, or a variable that holds one",
    )


def _text_for_number(operation: CheckedOperation, argument: Argument) -> Finding:
    return operation.finding_at(
        codes.TEXT_FOR_NUMBER,
        argument,
        f"{argument.name} is a text, and the brick reads a {argument.parameter.type}",
        "give a number",
    )


def _integer_for_float(operation: CheckedOperation, argument: Argument) -> Finding:
    return operation.finding_at(
        codes.INTEGER_FOR_FLOAT,
        argument,
        f"{argument.name} is the whole number {argument.value}, whose bits the brick reads as a float",
        f"give {argument.value} as a float: LC4 with the four bytes of an IEEE single",
    )
