"""Rules on arguments: their values, encodings, lists. All in one pass, since most of a frame is arguments."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.checking.rules.memory import Use
from ev3proto.errors import counted
from ev3proto.messages import Argument, Operation, Variable
from ev3proto.schema.argument import encode_integer, encode_variable
from ev3proto.semantics.footprint import InlineArray, footprint, inline_arrays
from ev3proto.semantics.judgement import Judgement, Wrong, judged
from ev3proto.tables.declaration import Role
from ev3proto.tables.encoding import (
    CONSTANT,
    CONSTANT_RANGES,
    ENCODINGS,
    GLOBAL,
    INDEX_RANGES,
    LOCAL,
    RANGES,
    SHORT,
    Encoding,
)
from ev3proto.tables.output import LETTERS, PORT_SETS


def value_finding(operation: CheckedOperation, argument: Argument, judgement: Judgement) -> Finding:
    """Returns the finding about a constant."""
    wrong = judgement.wrong
    parts = {name: part(argument, judgement) for name, part in _PARTS_OF[wrong].items()}
    return operation.finding_of(codes.OF_VALUES[wrong], argument, wrong, **parts)


def _of_type(judgement: Judgement) -> str:
    limits = RANGES.get(judgement.known.parameter.type)
    return f"{limits.low} to {limits.high}" if limits is not None else "a text"


def _legal(_: Argument, judgement: Judgement) -> str:
    domain = judgement.known.domain
    return domain.choice if domain is not None else _of_type(judgement)


def _accepted(_: Argument, judgement: Judgement) -> str:
    validated = judgement.known.validated
    return f"{validated.numbers[0]} to {validated.numbers[-1]} as {validated.kind}" if validated.numbers else ""


def _ports(_: Argument, judgement: Judgement) -> str:
    return PORT_SETS[int(judgement.value)]


_PARTS: dict[str, Callable[[Argument, Judgement], object]] = {
    "value": lambda _, one: one.value,
    "read": lambda _, one: one.read,
    "byte": lambda argument, _: f"0x{argument.raw[0]:02X}",
    "kind": lambda _, one: one.known.parameter.type,
    "type": lambda _, one: f"{one.known.parameter.type}, {_of_type(one)}",
    "sized": lambda _, one: one.known.parameter.type if one.known.parameter.type.size else None,
    "legal": _legal,
    "outside": lambda _, one: one.known.domain.outside if one.known.domain is not None else "",
    "accepted": _accepted,
    "ports": _ports,
    "letters": lambda _, one: ", ".join(f"{LETTERS[each]} for {each}" for each in _ports(_, one).split("+")),
    "characters": lambda argument, _: counted(argument.length - 2, "character"),
    "most": lambda _, one: (one.known.parameter.most or 0) - 1,
    "over": lambda argument, one: argument.length - 1 - (one.known.parameter.most or 0),
}
"""What the words about a constant name."""

_PARTS_OF = {
    wrong: {name: _PARTS[name] for name in code.words[wrong].names if name in _PARTS}
    for wrong, code in codes.OF_VALUES.items()
}


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
    saved = argument.length - len(shorter) if has_jumps and argument.parameter.role is not Role.JUMP else 0
    parts = {
        "encoding": argument.encoding,
        "bytes": counted(len(shorter), "byte"),
        "shorter": shorter.hex(" ").upper(),
        "saved": counted(saved, "byte") if saved else None,
    }
    return operation.finding_of(codes.LONGER_FORM, argument, **parts)


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
            for array in inline_arrays(operation.arguments):
                yield from _array(operation, array)


def _array(operation: CheckedOperation, array: InlineArray) -> Iterator[Finding]:
    argument, stated, present, one = array.argument, array.stated, array.present, array.one
    parts: dict[str, object] = {"length": array.length, "stated": counted(stated, "byte"), "present": present}
    if argument.form.kind == CONSTANT:
        if stated > present:
            yield operation.finding_of(codes.ARRAY_TOO_SHORT, argument, "number", **parts)
    elif stated > present:
        parts["count"] = _count(operation, array, present // one)
        yield operation.finding_of(codes.ARRAY_TOO_SHORT, argument, "bytes", **parts)
    elif stated < present - 1:
        count, rest = _count(operation, array, -(-(present - 1) // one)), counted(present - 1 - stated, "byte")
        parts |= {"present": present - 1, "count": count, "rest": rest}
        yield operation.finding_of(codes.REST_UNUSED, argument, **parts)


def _count(operation: CheckedOperation, array: InlineArray, count: int) -> int | None:
    """Returns a number of values if the array has that many and the parameter can hold it."""
    parameter = next(it for it in operation.facts.declaration.parameters if it.name == array.length)
    limits = RANGES.get(parameter.type)
    is_possible = 0 < count * array.one <= array.present and (limits is None or count <= limits.high)
    return count if is_possible else None


def check_arguments(context: CheckContext, found: list[Finding]) -> tuple[list[Use], list[Use]]:
    """Adds findings about values and encodings; returns the variables in local and in global memory."""
    local: list[Use] = []
    shared: list[Use] = []
    for operation in context.operations:
        arguments, facts = operation.arguments, operation.facts
        for number, argument in enumerate(arguments):
            kind = argument.form.kind
            if kind == GLOBAL:
                shared.append((operation, footprint(operation.parsed, number, arguments)))
            elif kind == LOCAL:
                local.append((operation, footprint(operation.parsed, number, arguments)))
            else:
                wrong = judged(facts.of(number, argument.parameter), argument)
                if wrong is not None and wrong.wrong is not Wrong.COUNT:  # which `operations` words
                    found.append(value_finding(operation, argument, wrong))
        for argument in longer_arguments(operation.parsed):
            found.append(longer_finding(operation, argument, context.has_jumps))
    return local, shared
