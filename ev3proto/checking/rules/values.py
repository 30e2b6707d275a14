"""Constants: what the type cannot hold, what the tables do not provide for, what stands where something else should."""

from __future__ import annotations

import math

from ev3proto.checking import codes
from ev3proto.checking.context import CheckedOperation
from ev3proto.checking.facts import ParameterFacts
from ev3proto.checking.report import Finding
from ev3proto.messages import Argument
from ev3proto.tables.declaration import Direction, Role, Type
from ev3proto.tables.encoding import RANGES, TEXT
from ev3proto.tables.validation import LABELS


def value_finding(
    operation: CheckedOperation, number: int, argument: Argument, known: ParameterFacts
) -> Finding | None:
    """What is wrong with a constant that is none of `known.numbers`."""
    is_first = not number and not operation.facts.has_cmd
    parameter, form, value, _, _ = argument
    kind, type_ = form.kind, parameter.type
    if form.handle or form.address:
        # Only the brick knows what is there. Its validator takes the handle or address itself for the value.
        return _refused(operation, argument, value, known) if is_first and isinstance(value, int) else None
    if parameter.direction is not Direction.IN:
        return _constant_output(operation, argument)
    if kind == TEXT:
        is_text = type_ is Type.STRING or parameter.length is not None or type_ is Type.ARRAY_TYPED
        return None if is_text else _text_for_number(operation, argument)
    if isinstance(value, float):
        return _not_a_number(operation, argument) if math.isnan(value) else None
    if type_ is Type.STRING:
        return _number_for_text(operation, argument)
    if type_ is Type.DATAF:
        return _integer_for_float(operation, argument) if value and parameter.length is None else None
    assert isinstance(value, int)
    return _number(operation, argument, value, known, is_first=is_first)


def _number(
    operation: CheckedOperation, argument: Argument, value: int, known: ParameterFacts, *, is_first: bool
) -> Finding | None:
    """What is wrong with a whole number."""
    domain, limits = known.domain, known.limits
    refused = _refused(operation, argument, value, known) if is_first else None
    if refused is not None or known.parameter.type is Type.LABEL:
        return refused
    if limits is not None and not limits.low <= value <= limits.high:
        return _cut_down(operation, argument, value, known)
    if domain is None or domain.covers(value):
        return None
    return _illegal(operation, argument, value, known)


def _illegal(
    operation: CheckedOperation, argument: Argument, value: int, known: ParameterFacts, aside: str = ""
) -> Finding:
    """A number that the tables do not provide for."""
    assert known.domain is not None
    code = codes.NO_MEMBER if known.domain.has_names else codes.OUT_OF_RANGE
    message = f"{argument[0].name} is {value}{known.outside}{aside}"
    return operation.finding_at(code, argument, message, known.advice)


def _refused(operation: CheckedOperation, argument: Argument, value: int, known: ParameterFacts) -> Finding | None:
    """A first parameter that the validator does not let pass."""
    parameter = known.parameter
    if parameter.role is Role.LABEL:
        if 0 <= value < LABELS:
            return None
        return operation.finding_at(
            codes.BAD_LABEL,
            argument,
            f"{argument.name} is {value}, and there are labels 0 to {LABELS - 1}",
            f"give 1 to {LABELS - 1}; jumps cannot name label 0",
        )
    checked = parameter.validated or parameter.type
    if checked is Type.STRING:
        # Of a text, the validator sees its first character.
        checked = Type.DATA8
    limits = RANGES.get(checked)
    if limits is None or limits.low <= value <= limits.high:
        return None
    return operation.finding_at(
        codes.FIRST_OUT_OF_RANGE,
        argument,
        f"{argument.name} is {value}, and the brick takes {limits.low} to {limits.high} as {checked}"
        " in a first parameter",
        _value_help(known),
    )


def _cut_down(operation: CheckedOperation, argument: Argument, value: int, known: ParameterFacts) -> Finding:
    """A number that more bytes were given than the parameter has, or the one that means that there is none."""
    parameter = argument.parameter
    bits = 8 * parameter.type.size
    if value == RANGES[parameter.type].nan:
        return _not_a_number(operation, argument)
    kept = value & (1 << bits) - 1
    read = kept - (1 << bits) if kept >> bits - 1 else kept
    if 0 <= value < 1 << bits:
        if known.domain is not None and not known.domain.covers(read):
            return _illegal(operation, argument, value, known, f", and the brick reads it as {read}")
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
