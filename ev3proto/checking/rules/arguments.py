"""What is said of an argument by itself: its value, its encoding, the place in memory that it stands for.

All that is looked at in one pass, since a frame has more arguments than anything else. What is said of a short argument
or of a variable is the same wherever it stands, so it is worked out once and kept with the facts of its operation.
"""

from __future__ import annotations

from ev3proto.checking.context import CheckContext, CheckedOperation
from ev3proto.checking.facts import Said, parameter_facts, said_of_element
from ev3proto.checking.report import Finding, new_finding
from ev3proto.checking.rules.encodings import SHORTER, longer_finding, longer_form
from ev3proto.checking.rules.memory import Use
from ev3proto.checking.rules.values import value_finding
from ev3proto.messages import Argument, ArgumentValue
from ev3proto.schema.argument import SHORT
from ev3proto.semantics.footprint import Place, footprint
from ev3proto.tables.encoding import GLOBAL, LOCAL

_SHORT_FORMS = len(SHORT)
"""Identification bytes below this one are whole arguments."""

_VARIABLES = (LOCAL, GLOBAL)

_MOST_KEPT = 1024
"""Arguments of one parameter of which is kept what is said."""

_UNKNOWN = Place(0, 0, None, is_read=False, is_written=False, is_misaligned=False)
"""Stands for what was not worked out yet."""


def check_arguments(context: CheckContext, found: list[Finding]) -> tuple[list[Use], list[Use]]:
    """Adds what is wrong with single arguments; returns the variables in local and in global memory."""
    local: list[Use] = []
    shared: list[Use] = []
    frame, has_jumps = context.frame, context.has_jumps
    for operation in context.operations:
        facts = operation.facts
        if facts.has_cmd and frame[operation.start + 1] >= _SHORT_FORMS:
            found += longer_form(operation, has_jumps)
        said_before = facts.said
        fixed = len(said_before)
        for number, argument in enumerate(operation.arguments):
            parameter, form, value, offset, data = argument
            first = data[offset]
            if first < _SHORT_FORMS:
                kept = said_before[number] if number < fixed else said_of_element(parameter)
                said = kept.get(first, _UNKNOWN)
                if said is _UNKNOWN:
                    said = _say(operation, number, argument, kept, first)
                if said is None:
                    continue
                if type(said) is Place:
                    (shared if form.kind == GLOBAL else local).append((said, operation, number))
                else:
                    found.append(_placed(said, operation, offset))  # type: ignore[arg-type]
                continue
            if form.kind in _VARIABLES:
                kept = said_before[number] if number < fixed else said_of_element(parameter)
                key = first, value
                place = kept.get(key, _UNKNOWN)
                if place is _UNKNOWN:
                    place = _say(operation, number, argument, kept, key)
                (shared if form.kind == GLOBAL else local).append((place, operation, number))  # type: ignore[arg-type]
            else:
                known = facts.parameters[number] if number < fixed else parameter_facts(parameter)
                # A range looks at all of its numbers, one by one, for what is no whole number.
                if type(value) is not int or value not in known.numbers:
                    wrong = value_finding(operation, number, argument, known)
                    if wrong is not None:
                        found.append(wrong)
            shorter = SHORTER.get(id(form))
            if shorter is not None and type(value) is int and value in shorter:
                found.append(longer_finding(operation, argument, has_jumps))
    return local, shared


def _placed(said: Finding, operation: CheckedOperation, offset: int) -> Finding:
    """A finding as it was before, at another offset."""
    return new_finding(
        said.severity, said.code, offset, said.length, said.message, said.help, operation.name, said.parameter
    )


def _say(
    operation: CheckedOperation, number: int, argument: Argument, kept: Said, key: int | tuple[int, ArgumentValue]
) -> Finding | Place | None:
    """What is said of a short argument or a variable, which is kept where it is the same wherever that stands."""
    said: Finding | Place | None
    if argument.is_variable:
        lies, is_fixed = footprint(operation.parsed, number, operation.arguments)
        said = Place.of(lies)
        if not is_fixed:
            return said
    else:
        parameters = operation.facts.parameters
        known = parameters[number] if number < len(parameters) else parameter_facts(argument.parameter)
        said = None if argument.value in known.numbers else value_finding(operation, number, argument, known)
    if len(kept) >= _MOST_KEPT:
        kept.clear()
    kept[key] = said
    return said
