"""`check`: whether the brick will accept a frame, and what a careful sender would change in it."""

from __future__ import annotations

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext, checked_operations
from ev3proto.checking.report import Finding, Report, Severity
from ev3proto.checking.rules.alone import check_alone
from ev3proto.checking.rules.arguments import check_arguments, check_lists
from ev3proto.checking.rules.devices import check_devices
from ev3proto.checking.rules.header import check_command_header, check_daisy, check_envelope, check_system
from ev3proto.checking.rules.memory import check_memory
from ev3proto.checking.rules.operations import check_effects, check_flow, check_refusals
from ev3proto.checking.rules.programs import check_programs
from ev3proto.checking.rules.refused_when_run import check_failures
from ev3proto.checking.verdict import verdict
from ev3proto.errors import as_bytes
from ev3proto.messages import DaisyCommand, DirectCommand, Message, SystemCommand
from ev3proto.schema.frame import read_last
from ev3proto.schema.header import HEADER_SIZE, TYPE_AT, frame_size, with_length
from ev3proto.tables.carriers import CARRIERS
from ev3proto.tables.declaration import Effect
from ev3proto.tables.frame import LENGTH_FIELD, MAX_FRAME


def check(
    frame: bytes | bytearray | memoryview | Message,
    *,
    dialect: str = "official",
    carrier: str | None = None,
    alone: bool = False,
) -> Report:
    """Checks a frame: whether the brick accepts it, and what is wrong with it. No content of a frame makes it raise.

    Args:
        frame: The bytes from the length field to the last one; or a message, whose frame is checked.
        dialect: "official", "xtended" or "compat": the firmware whose instruction set is used.
        carrier: "usb", "bluetooth" or "wifi": the carrier of the frame; None if it does not matter.
        alone: Whether no other command belongs to it, so that one that does nothing by itself is worth a hint.

    Returns:
        The brick's verdict, and the findings ordered by offset.

    Raises:
        TypeError: The frame is neither bytes nor a message.
        ValueError: The dialect or the carrier is unknown.
    """
    if carrier is not None and carrier not in CARRIERS:
        raise ValueError(f"carrier must be one of {', '.join(CARRIERS)}, not {carrier!r}")
    if isinstance(frame, Message):
        frame = frame.build()
    elif type(frame) is not bytes:
        frame = as_bytes(frame, "a frame")
    context = _context(frame, dialect, carrier, alone)
    findings = _in_order(_findings(context))
    accepted, rejected_at = _answer(context, findings)
    return Report(frame, accepted, rejected_at, tuple(findings), dialect, carrier, alone)


_WORST_FIRST = list(Severity)


def _in_order(findings: list[Finding]) -> list[Finding]:
    """Returns the findings by offset and then severity, without hints about bytes that have an error."""
    wrong = {finding.offset for finding in findings if finding.severity is Severity.ERROR}
    kept = [one for one in findings if one.severity is not Severity.HINT or one.offset not in wrong]
    return sorted(kept, key=lambda one: (one.offset, _WORST_FIRST.index(one.severity)))


_NO_EFFECTS: frozenset[Effect] = frozenset()


def _context(frame: bytes, dialect: str, carrier: str | None, alone: bool) -> CheckContext:
    """Returns the context of a frame with a corrected length field, so that the rules see what is wrong inside."""
    size = end = len(frame)
    content = frame
    if size >= HEADER_SIZE:
        stated = frame_size(frame)
        if stated != size:
            end = min(max(stated, HEADER_SIZE), size)
            content = with_length(frame[LENGTH_FIELD:end])
    message = read_last(content, dialect)
    operations = checked_operations(message.operations) if isinstance(message, DirectCommand) else ()
    effects = _NO_EFFECTS.union(*[operation.facts.effects for operation in operations])
    has_jumps = True in [operation.facts.is_jump for operation in operations]
    return CheckContext(
        frame, end, message, verdict(frame, dialect), operations, effects, has_jumps, dialect, carrier, alone
    )


def _findings(context: CheckContext) -> list[Finding]:
    found = list(check_envelope(context))
    if any(finding.code == codes.NOT_A_FRAME.code for finding in found):
        return found
    message = context.message
    if isinstance(message, DirectCommand):
        found += check_command_header(context, message)
        if context.end > MAX_FRAME:
            return [*found, *check_refusals(context)]  # the brick reads none of its bytes
        found += check_refusals(context)
        local, shared = check_arguments(context, found)
        found += check_lists(context.operations)
        found += check_memory(context, message, local, shared)
        found += check_flow(context)
        found += check_failures(context)
        found += check_effects(context)
        found += check_devices(context, shared)
        found += check_programs(context)
        if context.is_alone:
            found += check_alone(context)
    elif isinstance(message, SystemCommand):
        found += check_system(context, message)
    elif isinstance(message, DaisyCommand):
        found += check_daisy(context, message)
    return found


def _answer(context: CheckContext, findings: list[Finding]) -> tuple[bool, int | None]:
    """Returns whether the brick accepts it, and if not, where it stops."""
    message = context.message
    if isinstance(message, DirectCommand):
        return context.verdict.accepted, context.verdict.rejected_at
    first = next((finding.offset for finding in findings if finding.severity is Severity.ERROR), None)
    if first is None and (message.type is None or not message.type.is_command):
        first = TYPE_AT
    return first is None, first
