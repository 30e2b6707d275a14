"""What is said of an argument by itself, in one pass, since a frame has more arguments than anything else."""

from __future__ import annotations

from ev3proto.checking.context import CheckContext
from ev3proto.checking.facts import parameter_facts
from ev3proto.checking.report import Finding
from ev3proto.checking.rules.encodings import SHORTER, longer_finding, longer_form
from ev3proto.checking.rules.memory import Use
from ev3proto.checking.rules.values import value_finding
from ev3proto.schema.argument import SHORT
from ev3proto.semantics.footprint import element_facts, footprint
from ev3proto.tables.encoding import GLOBAL, LOCAL

_VARIABLES = (LOCAL, GLOBAL)
_SHORT_FORMS = len(SHORT)
"""Identification bytes below this one are whole arguments."""


def check_arguments(context: CheckContext, found: list[Finding]) -> tuple[list[Use], list[Use]]:
    """Adds what is wrong with values and encodings; returns the variables in local and in global memory."""
    local: list[Use] = []
    shared: list[Use] = []
    frame, has_jumps = context.frame, context.has_jumps
    for operation in context.operations:
        facts = operation.facts
        if facts.has_cmd and frame[operation.start + 1] >= _SHORT_FORMS:
            found += longer_form(operation, has_jumps)
        parameters = facts.parameters
        fixed = len(parameters)
        if len(operation.arguments) > fixed:
            # The elements of a list are all alike.
            element = operation.arguments[fixed].parameter
            listed, listed_memory = parameter_facts(element), element_facts(element)
        for number, argument in enumerate(operation.arguments):
            _, form, value, _, _ = argument
            kind = form.kind
            if kind in _VARIABLES:
                known = facts.memory[number] if number < fixed else listed_memory
                if known.is_counted or form.handle or form.address:
                    lies = footprint(operation.parsed, number, operation.arguments)
                    start, size, most = lies.start, lies.size, lies.most
                    used: Use = start, start + size, None if most is None else start + most, lies, operation, number
                else:
                    assert type(value) is int
                    most = known.most
                    end = value + known.size
                    used = value, end, None if most is None else value + most, known, operation, number
                (shared if kind == GLOBAL else local).append(used)
            else:
                legal = parameters[number] if number < fixed else listed
                # A range looks at all of its numbers, one by one, for what is no whole number.
                if type(value) is not int or value not in legal.numbers:
                    wrong = value_finding(operation, number, argument, legal)
                    if wrong is not None:
                        found.append(wrong)
            if form.width:
                shorter = SHORTER.get(id(form))
                if shorter is not None and type(value) is int and value in shorter:
                    found.append(longer_finding(operation, argument, has_jumps))
    return local, shared
