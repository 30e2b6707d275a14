"""Where the operations can no longer be read, or are not what the firmware's validator reads."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, CheckedOperation
from ev3proto.checking.report import Finding
from ev3proto.errors import Fault, counted
from ev3proto.messages import Argument
from ev3proto.schema.header import COMMAND_HEADER_SIZE
from ev3proto.schema.identification import ENCODINGS
from ev3proto.schema.instructions import instruction_set
from ev3proto.schema.operation import CMD
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import UNRELEASED, Effect, Type
from ev3proto.tables.encoding import CONSTANT


def check_refusals(context: CheckContext) -> Iterator[Finding]:
    """What stops the reader of the operations, or the validator where the reader goes on."""
    if not context.effects.isdisjoint(_NEVER_RUNS):
        yield from _never_run(context)
    if context.dialect == "official":
        yield from _newer(context)
    fault = context.fault
    if context.verdict.spins:
        yield _spins(context)
        if fault is not None and _faulty_start(context) == context.verdict.rejected_at:
            return
    # That the frame ends too early, or that its length is wrong, has been said already.
    if fault is not None and context.end > COMMAND_HEADER_SIZE and not (context.is_length_wrong and fault.truncated):
        yield _fault(context, fault)


_NEVER_RUNS = frozenset((Effect.NEVER_RUNS,))


def _never_run(context: CheckContext) -> Iterator[Finding]:
    for operation in context.operations:
        if operation.has(Effect.NEVER_RUNS):
            yield operation.finding(
                codes.UNKNOWN_OPCODE,
                f"0x{operation.parsed.opcode:02X} is {operation.name}, which the firmware never runs",
                _out_of_step(operation.start),
            )


def _faulty_start(context: CheckContext) -> int:
    """Where the operation starts that cannot be read."""
    start: int = COMMAND_HEADER_SIZE
    for last in context.operations[-1:]:
        start = last.end if last.parsed.is_complete else last.start
    return start


def _newer(context: CheckContext) -> Iterator[Finding]:
    rejected_at = context.verdict.rejected_at
    for operation in context.operations:
        if not operation.facts.is_newer:
            continue
        cmd = operation.parsed.cmd
        assert cmd is not None
        known = f"firmware of 2013 does not know {operation.name} and reads its arguments as operations"
        if rejected_at is not None and rejected_at >= operation.start:
            yield operation.finding_at(
                codes.NEWER,
                cmd,
                f"{known}: it refuses the command at offset {rejected_at}",
                "send it to bricks with newer firmware only",
            )
            # What the validator stops at further on has the same reason.
            rejected_at = None
        else:
            yield operation.finding_at(codes.NEWER_ACCEPTED, cmd, known, "send it to bricks with newer firmware only")


def _spins(context: CheckContext) -> Finding:
    verdict = context.verdict
    at = verdict.blamed
    assert at is not None
    operation = next((operation for operation in context.operations if operation.start == verdict.rejected_at), None)
    argument = next((it for it in operation.arguments if it.offset == at), None) if operation else None
    help_ = "give the number of the values that follow, 0 or more"
    if operation is not None and argument is not None:
        counted = argument.value if argument.kind == CONSTANT else "no number"
        message = f"{argument.name} is {counted}: the brick reads millions of values before it looks at anything else"
        return operation.finding_at(codes.SPINS, argument, message, help_)
    message = "the brick takes this for a count of values, and reads millions of them before it looks at anything else"
    return codes.SPINS.finding(at, max(context.end - at, 0), message, help_)


def _fault(context: CheckContext, fault: Fault) -> Finding:
    """What the reader stops at. What the validator makes of the bytes after it follows from that."""
    start = _faulty_start(context)
    if context.operations and context.operations[-1].start == start:
        return _faulty_argument(context, context.operations[-1], fault)
    family = instruction_set(context.dialect).families[context.frame[start]]
    if family is None:
        return _unknown_opcode(context, start)
    return _faulty_cmd(context, start, family.opcode.name, fault)


def _unknown_opcode(context: CheckContext, start: int) -> Finding:
    number = context.frame[start]
    others = [opcode for opcode in OPCODES if opcode.number == number]
    if others and others[0].dialects == UNRELEASED:
        message = f"0x{number:02X} is {others[0].name}, which is documented, and which no firmware implements"
        return codes.UNKNOWN_OPCODE.finding(start, 1, message, others[0].note)
    if others:
        message = (
            f"0x{number:02X} is {others[0].name} for the dialects {' and '.join(others[0].dialects)}, and not an opcode"
            f" of {context.dialect} firmware"
        )
    else:
        message = f"0x{number:02X} is not an opcode of the {context.dialect} firmware"
    return codes.UNKNOWN_OPCODE.finding(start, 1, message, _out_of_step(start))


def _out_of_step(start: int) -> str:
    if start == COMMAND_HEADER_SIZE:
        return "give an opcode; the operations start after the two bytes that ask for memory"
    return "give an opcode, or look at the operation before it: one of its arguments may be too short or too long"


def _faulty_cmd(context: CheckContext, start: int, name: str, fault: Fault) -> Finding:
    """An opcode is there, and no CMD that says what follows."""
    at = start + 1
    if fault.truncated:
        return codes.CUT_OFF.finding(
            start, context.end - start, f"{name}: {fault.reason}", "give the bytes that are missing", name, "CMD"
        )
    first = context.frame[at]
    encoding = ENCODINGS[first]
    if encoding is None:
        return _undefined_form(at, first, name, "CMD")
    family = instruction_set(context.dialect).families[context.frame[start]]
    assert family is not None
    names = [
        f"{number} {schema.declaration.command.name}"  # type: ignore[union-attr]
        for number, schema in sorted(family.commands.items())
        if context.dialect != "official" or not schema.declaration.is_newer
    ]
    known = ", ".join(names[:_MOST_NAMES])
    more = ", ..." if len(names) > _MOST_NAMES else ""
    cmd, _ = CMD.read(context.frame[: context.end], at)
    if encoding.kind != CONSTANT:
        return codes.VARIABLE_CMD.finding(
            at,
            cmd.length,
            f"CMD of {name} is {encoding.name}, and must be a number in the frame itself",
            f"give one of {known}{more}",
            name,
            "CMD",
        )
    return codes.UNKNOWN_CMD.finding(
        at,
        cmd.length,
        f"{name} has no CMD {cmd.value}{_consequence(context, start)}",
        f"give one of {known}{more}",
        name,
        "CMD",
    )


_MOST_NAMES = 6


def _consequence(context: CheckContext, start: int) -> str:
    """What the brick does where it does not stop at the fault itself."""
    rejected_at = context.verdict.rejected_at
    if rejected_at is None:
        return "; the brick does not notice, and runs what follows as operations"
    if rejected_at > start:
        return f"; the brick takes what follows for operations, and refuses the command at offset {rejected_at}"
    return ""


def _undefined_form(at: int, first: int, name: str, parameter: str) -> Finding:
    return codes.UNDEFINED_FORM.finding(
        at,
        1,
        f"0x{first:02X} is not an identification byte: {parameter} of {name} has no encoding that the firmware defines",
        "give the argument as LC0, LC1, LC2, LC4, LCS or a variable",
        name,
        parameter,
    )


def _faulty_argument(context: CheckContext, operation: CheckedOperation, fault: Fault) -> Finding:
    """The operation is known, and one of its arguments cannot be read."""
    at = fault.offset
    count = next((argument for argument in operation.arguments if argument.offset == at), None)
    if count is not None:
        # An argument that can be read is no reason to stop, unless it tells how many follow.
        return _faulty_count(context, operation, count, fault)
    parameters = operation.facts.declaration.parameters
    parameter = parameters[min(len(operation.arguments), len(parameters) - 1)]
    if fault.truncated:
        last = min(at, context.end)
        return codes.CUT_OFF.finding(
            last,
            context.end - last,
            f"{operation.name}: {fault.reason}",
            f"give the bytes that are missing, or the right length of what comes before {parameter.name}",
            operation.name,
            parameter.name,
        )
    return _undefined_form(at, context.frame[at], operation.name, parameter.name)


def _faulty_count(context: CheckContext, operation: CheckedOperation, count: Argument, fault: Fault) -> Finding:
    is_number = count.kind == CONSTANT and isinstance(count.value, int)
    is_count = fault.truncated or operation.facts.declaration.parameters[-1].type is Type.VALUES
    if is_number and is_count and int(count.value) >= 0:
        room = context.end - count.offset - count.length
        return operation.finding_at(
            codes.CUT_OFF,
            count,
            f"{count.name} says that {counted(int(count.value), 'value')} follow, and {counted(room, 'byte')} do",
            "give as many values as it says, or the number that there are",
        )
    state = f"{count.name} is {count.value}" if is_number else f"{count.name} is {count.encoding}, which is no number"
    return operation.finding_at(
        codes.BAD_COUNT,
        count,
        f"{state}{_consequence(context, operation.start)}",
        "give the number of the values that follow as a constant",
    )
