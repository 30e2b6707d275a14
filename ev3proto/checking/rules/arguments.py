"""Rules on arguments: their values, encodings, lists. All in one pass, since most of a frame is arguments."""

from __future__ import annotations

import math
from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.checking.rules.memory import Use
from ev3proto.errors import counted
from ev3proto.messages import Argument, Operation, Variable
from ev3proto.schema.argument import encode_integer, encode_variable
from ev3proto.semantics.facts import ParameterFacts
from ev3proto.semantics.flow import is_label
from ev3proto.semantics.footprint import InlineArray, footprint, inline_arrays
from ev3proto.tables.declaration import Direction, Role, Type
from ev3proto.tables.encoding import (
    CONSTANT,
    CONSTANT_RANGES,
    ENCODINGS,
    GLOBAL,
    INDEX_RANGES,
    JUMP,
    LOCAL,
    RANGES,
    SHORT,
    TEXT,
    Encoding,
)
from ev3proto.tables.output import LETTERS, PORT_SETS
from ev3proto.tables.validation import LABELS


def value_finding(
    operation: CheckedOperation, number: int, argument: Argument, known: ParameterFacts
) -> Finding | None:
    """Returns what is wrong with a constant outside `known.legal`."""
    is_first = not number and not operation.facts.has_cmd
    parameter, form, value = argument.parameter, argument.form, argument.value
    is_input = parameter.direction is Direction.IN
    is_number = is_input and parameter.type in _WHOLE and parameter.length is None
    if form.kind == JUMP and is_number and parameter.role is not Role.JUMP:
        return _label_for_number(operation, argument)
    if (form.handle or form.address) and not (form.kind == TEXT and is_number):
        # Only the brick knows the value there. Its validator takes the handle or address itself as the value.
        return _refused(operation, argument, value, known) if is_first and isinstance(value, int) else None
    if not is_input:
        return _constant_output(operation, argument)
    if form.kind == TEXT:
        is_text = parameter.type in (Type.STRING, Type.ARRAY_TYPED) or parameter.length is not None
        return None if is_text else _text_for_number(operation, argument)
    return _of_number(operation, argument, known, is_first=is_first)


def _of_number(
    operation: CheckedOperation, argument: Argument, known: ParameterFacts, *, is_first: bool
) -> Finding | None:
    """Returns what is wrong with a number, whatever belongs there."""
    parameter, value = argument.parameter, argument.value
    if isinstance(value, float):
        return _not_a_number(operation, argument) if math.isnan(value) else None
    if parameter.type is Type.STRING:
        return _number_for_text(operation, argument)
    if parameter.type is Type.DATAF:
        return _integer_for_float(operation, argument) if value and parameter.length is None else None
    assert isinstance(value, int)
    return _number(operation, argument, value, known, is_first=is_first)


def _number(
    operation: CheckedOperation, argument: Argument, value: int, known: ParameterFacts, *, is_first: bool
) -> Finding | None:
    """Returns what is wrong with a whole number."""
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
    """Returns the finding about a number that is not in the tables."""
    parameter, domain = known.parameter, known.domain
    assert domain is not None
    if parameter.role is Role.MOTOR and value in PORT_SETS:
        ports = PORT_SETS[value]
        message = f"{parameter.name} is {value}, the bit mask of {ports}, but it takes the number of one port"
        advice = ", ".join(f"{LETTERS[letter]} for {letter}" for letter in ports.split("+"))
        return operation.finding_at(codes.OUT_OF_RANGE, argument, message, f"use {advice}")
    code = codes.NO_MEMBER if domain.has_names else codes.OUT_OF_RANGE
    return operation.finding_at(
        code, argument, f"{argument.name} is {value}{domain.outside}{aside}", f"use {domain.choice}"
    )


def _refused(operation: CheckedOperation, argument: Argument, value: int, known: ParameterFacts) -> Finding | None:
    """Returns the finding about a first argument that the validator refuses."""
    parameter = known.parameter
    if parameter.role is Role.LABEL:
        if 0 <= value < LABELS:
            return None
        return operation.finding_at(
            codes.BAD_LABEL,
            argument,
            f"{argument.name} is {value}, but labels are 0 to {LABELS - 1}",
            f"use 1 to {LABELS - 1}; jumps cannot name label 0",
        )
    numbers = known.validated.numbers
    if numbers is None or value in numbers:
        return None
    return operation.finding_at(
        codes.FIRST_OUT_OF_RANGE,
        argument,
        f"{argument.name} is {value}, but the brick accepts only {numbers[0]} to {numbers[-1]} as"
        f" {known.validated.kind} in a first parameter",
        _value_help(known),
    )


def _cut_down(operation: CheckedOperation, argument: Argument, value: int, known: ParameterFacts) -> Finding:
    """Returns the finding about a number with more bytes than the parameter, or about the value for "not a number"."""
    parameter = argument.parameter
    bits = 8 * parameter.type.size
    if value == RANGES[parameter.type].nan:
        return _not_a_number(operation, argument)
    kept = value & (1 << bits) - 1
    read = kept - (1 << bits) if kept >> bits - 1 else kept
    if 0 <= value < 1 << bits:
        if known.domain is not None and not known.domain.covers(read):
            return _illegal(operation, argument, value, known, f"; the brick reads it as {read}")
        return operation.finding_at(
            codes.NEGATIVE,
            argument,
            f"{parameter.name} is {value}, which the brick reads as {read}: it is {_article(parameter.type)}",
            f"write {read} if these bits are meant, otherwise a number that fits",
        )
    return operation.finding_at(
        codes.TRUNCATED,
        argument,
        f"{parameter.name} is {value}, which the brick truncates to {read}: it is {_article(parameter.type)}",
        _value_help(known),
    )


def _article(kind: Type) -> str:
    limits = RANGES[kind]
    return f"a {kind}, {limits.low} to {limits.high}"


def _value_help(known: ParameterFacts) -> str:
    if known.domain is not None:
        return f"use {known.domain.choice}"
    limits = RANGES.get(known.parameter.type)
    return "use a text" if limits is None else f"use {limits.low} to {limits.high}"


def _not_a_number(operation: CheckedOperation, argument: Argument) -> Finding:
    return operation.finding_at(
        codes.NOT_A_NUMBER,
        argument,
        f'{argument.name} is {argument.value}, which means "not a number"',
        "use a number, unless this is intended",
    )


def _constant_output(operation: CheckedOperation, argument: Argument) -> Finding:
    parameter = argument.parameter
    wide = parameter.type.size
    room = f" large enough for {parameter.type}" if wide else ""
    return operation.finding_at(
        codes.CONSTANT_OUTPUT,
        argument,
        f"{argument.name} is a constant, but the brick writes to it",
        f"use a variable{room}: global for the reply, or local",
    )


def _number_for_text(operation: CheckedOperation, argument: Argument) -> Finding:
    return operation.finding_at(
        codes.NUMBER_FOR_TEXT,
        argument,
        f"{argument.name} is the number {argument.value}, but the brick reads a text",
        "use a text as LCS, or a variable that holds one",
    )


def _text_for_number(operation: CheckedOperation, argument: Argument) -> Finding:
    return operation.finding_at(
        codes.TEXT_FOR_NUMBER,
        argument,
        f"{argument.name} is a text, but the brick reads a {argument.parameter.type}",
        "use a number",
    )


def _label_for_number(operation: CheckedOperation, argument: Argument) -> Finding:
    first, help_ = f"0x{argument.raw[0]:02X} is LAB1, a label", "write a number as a constant; labels are for jumps"
    if is_label(argument):
        message = f"{first}: the brick puts the place of label {argument.value} here, not a number"
        return operation.finding_at(codes.LABEL_FOR_NUMBER, argument, message, help_)
    # The brick takes the byte of another label without its sign.
    number = argument.value if argument.parameter.type is Type.DATA8 else argument.raw[1]
    message = f"{first}, but labels are 1 to {LABELS - 1}: the brick takes this one as the number {number}"
    return operation.finding_at(codes.NUMBER_AS_LABEL, argument, message, help_)


def _integer_for_float(operation: CheckedOperation, argument: Argument) -> Finding:
    return operation.finding_at(
        codes.INTEGER_FOR_FLOAT,
        argument,
        f"{argument.name} is the whole number {argument.value}, but the brick reads its bits as a float",
        "write a float as LC4 with the four bytes of an IEEE single",
    )


_WHOLE = (Type.DATA8, Type.DATA16, Type.DATA32)

_SHORT_FORMS = len(SHORT)
"""Identification bytes below this one are complete arguments."""

_RANGES = {CONSTANT: CONSTANT_RANGES, LOCAL: INDEX_RANGES, GLOBAL: INDEX_RANGES}


def _shorter(form: Encoding) -> range | None:
    """Returns the values that a shorter form can hold, None if there is no shorter form."""
    if not form.width:
        return None
    # Wider forms hold all values of narrower ones.
    narrower = [numbers for width, numbers in _RANGES.get(form.kind, {}).items() if width < form.width]
    return narrower[-1] if narrower else None


_SHORTER = {form.name: _shorter(form) for form in ENCODINGS if form is not None and not (form.handle or form.address)}
"""The values that a shorter form can hold, by the name of the encoding."""


def is_longer(argument: Argument) -> bool:
    """Returns whether its value fits a shorter form."""
    form, value = argument.form, argument.value
    shorter = _SHORTER[form.name]
    return shorter is not None and type(value) is int and value in shorter and not (form.handle or form.address)


def longer_arguments(operation: Operation) -> Iterator[Argument]:
    """Yields CMD and the arguments whose value fits a shorter form."""
    code = operation.raw
    if len(code) > 1 and code[1] >= _SHORT_FORMS and (cmd := operation.cmd) is not None and is_longer(cmd):
        yield cmd
    for argument in operation.arguments:
        if argument.form.width and is_longer(argument):
            yield argument


def shortest(argument: Argument) -> bytes:
    """Returns the shortest encoding of an argument that `is_longer`."""
    kind, value = argument.form.kind, argument.value
    assert isinstance(value, int)
    return encode_integer(value) if kind == CONSTANT else encode_variable(Variable(kind, value))


def longer_finding(operation: CheckedOperation, argument: Argument, has_jumps: bool) -> Finding:
    """Returns the finding about an argument that `is_longer`."""
    kind, value = argument.form.kind, argument.value
    shorter = shortest(argument)
    if argument.parameter.role is Role.JUMP and kind == CONSTANT and isinstance(value, int) and value < 0:
        shorter = _shorter_way_back(argument, value)
    aside = ""
    if has_jumps and argument.parameter.role is not Role.JUMP:
        aside = f", and shorten jumps over it by {counted(argument.length - len(shorter), 'byte')}"
    return operation.finding_at(
        codes.LONGER_FORM,
        argument,
        f"{argument.name} is {argument.encoding}, but its value fits {counted(len(shorter), 'byte')}",
        f"write it as {shorter.hex(' ').upper()}{aside}",
    )


def _shorter_way_back(argument: Argument, value: int) -> bytes:
    """Returns a jump to the same target in fewer bytes; its distance, counted from its end, changes."""
    for length in range(1, argument.length):
        data = encode_integer(value + argument.length - length)
        if len(data) == length:
            return data
    return encode_integer(value)


def check_lists(operations: tuple[CheckedOperation, ...]) -> Iterator[Finding]:
    """Checks the texts and arrays inside the operations."""
    for operation in operations:
        if operation.facts.has_lists:
            yield from _long_texts(operation)
            for array in inline_arrays(operation.arguments):
                yield from _array(operation, array)


def _long_texts(operation: CheckedOperation) -> Iterator[Finding]:
    for argument in operation.arguments:
        parameter, form = argument.parameter, argument.form
        most = parameter.most
        if most is None or form.kind != TEXT or parameter.direction is not Direction.IN:
            continue
        size = argument.length - 1
        if size > most and not form.handle and not form.address:
            yield operation.finding_at(
                codes.NAME_TOO_LONG,
                argument,
                f"{argument.name} has {counted(size - 1, 'character')}; the firmware accepts at most {most - 1}",
                f"shorten it by {size - most}",
            )


def _array(operation: CheckedOperation, array: InlineArray) -> Iterator[Finding]:
    argument, length, stated, present = array.argument, array.length, array.stated, array.present
    says = f"{length} says that {argument.name} has {counted(stated, 'byte')}"
    if argument.form.kind == CONSTANT:
        if stated > present:
            yield operation.finding_at(
                codes.ARRAY_TOO_SHORT,
                argument,
                f"{says}, but it is a single number",
                "write the bytes as a text, or a variable that holds them",
            )
    elif stated > present:
        yield operation.finding_at(
            codes.ARRAY_TOO_SHORT,
            argument,
            f"{says}, but it has {present}, including its zero",
            ", or ".join(
                (
                    *_count(operation, array, present // array.one),
                    f"add the missing bytes, up to {counted(stated, 'byte')}",
                )
            ),
        )
    elif stated < present - 1:
        yield operation.finding_at(
            codes.REST_UNUSED,
            argument,
            f"{says}, but it has {present - 1}",
            ", or ".join(
                (
                    *_count(operation, array, -(-(present - 1) // array.one)),
                    f"omit the last {counted(present - 1 - stated, 'byte')}",
                )
            ),
        )


def _count(operation: CheckedOperation, array: InlineArray, count: int) -> Iterator[str]:
    """Yields the advice to change the number of values, if the array has that many and the parameter can hold it."""
    parameter = next(it for it in operation.facts.declaration.parameters if it.name == array.length)
    limits = RANGES.get(parameter.type)
    if 0 < count * array.one <= array.present and (limits is None or count <= limits.high):
        yield f"set {array.length} to {count}"


def check_arguments(context: CheckContext, found: list[Finding]) -> tuple[list[Use], list[Use]]:
    """Adds findings about values and encodings; returns the variables in local and in global memory."""
    local: list[Use] = []
    shared: list[Use] = []
    for operation in context.operations:
        arguments, facts = operation.arguments, operation.facts
        for number, argument in enumerate(arguments):
            kind, value = argument.form.kind, argument.value
            if kind == GLOBAL:
                shared.append((operation, footprint(operation.parsed, number, arguments)))
            elif kind == LOCAL:
                local.append((operation, footprint(operation.parsed, number, arguments)))
            else:
                known = facts.of(number, argument.parameter)
                # `in` compares a value that is not a whole number with all numbers of a range, one by one.
                form = argument.form
                if type(value) is not int or value not in known.legal or kind == JUMP or form.handle or form.address:
                    wrong = value_finding(operation, number, argument, known)
                    if wrong is not None:
                        found.append(wrong)
        for argument in longer_arguments(operation.parsed):
            found.append(longer_finding(operation, argument, context.has_jumps))
    return local, shared
