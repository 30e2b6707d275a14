"""Fixes of frames: the nearest right frame where it is certain, and shorter encodings."""

from __future__ import annotations

from ev3proto.checking.checking import check
from ev3proto.checking.report import Change, Fix, Report, Suggestion, difference
from ev3proto.checking.rules.arguments import longer_arguments, shortest
from ev3proto.errors import as_bytes, counted
from ev3proto.messages import DirectCommand, Message
from ev3proto.schema.frame import read_last
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, TYPE_AT, with_length
from ev3proto.semantics.facts import operation_facts
from ev3proto.tables.encoding import CONSTANT, JUMP
from ev3proto.tables.frame import LENGTH_FIELD

_PARTS = {HEADER_SIZE: "memory", TYPE_AT: "type", LENGTH_FIELD: "counter", 0: "length field"}
"""What is changed in a header, by its offset."""


def fix(
    frame: bytes | bytearray | memoryview | Message,
    *,
    dialect: str = "official",
    carrier: str | None = None,
    shorten: bool = True,
) -> Fix:
    """Fixes what can be fixed with certainty. No content of a frame makes it raise, and no fix makes a frame worse.

    Args:
        frame: The bytes from the length field to the last one; or a message, whose frame is fixed.
        dialect: "official", "xtended" or "compat": the firmware whose instruction set is used.
        carrier: "usb", "bluetooth" or "wifi": the carrier of the frame; None if it does not matter.
        shorten: Whether to shorten encodings that are longer than needed; without it, only slips are fixed.

    Returns:
        The frame, what was fixed, what was not and why, and the report of a check of the result.

    Raises:
        ValueError: The dialect or the carrier is unknown.
    """
    given = frame.build() if isinstance(frame, Message) else as_bytes(frame, "a frame")
    report = check(given, dialect=dialect, carrier=carrier)
    changes: list[Change] = []
    while True:
        # Each round has fewer errors, or as many and fewer findings, than the one before.
        after, made, unfixed = _meant(report)
        if not made and shorten:
            after, made, kept = _shorter(report)
            unfixed += kept
        if not made:
            return Fix(report.frame, tuple(changes), tuple(unfixed), report)
        changes, report = [*changes, *made], after


def _meant(report: Report) -> tuple[Report, list[Change], list[str]]:
    """Returns the report on what was meant and the change to it, if that is certain; else why it is not."""
    frame, dialect, carrier = report.frame, report.dialect, report.carrier
    found = check(frame, dialect=dialect, carrier=carrier, alone=True).nearest
    for one in found:
        after = check(one.frame, dialect=dialect, carrier=carrier)
        is_safe = not one.harm and (not report.accepted or _doing(after) == _doing(report))
        if one.is_sure and is_safe and is_better(after, report):
            return after, [_change(frame, one)], []
    return report, [], [f"{one.message}; {_doubt(one, len(found))}" for one in found]


def _doing(report: Report) -> object:
    """Returns what a frame does: its operations with their values, its type and its global memory; or its bytes."""
    message = read_last(report.frame, report.dialect)
    if not isinstance(message, DirectCommand) or message.fault is not None:
        return report.frame
    operations = [
        # 2 and 2.0 are equal in Python, but other bytes to the brick.
        (one.full_name, [(it.kind, it.form.handle, it.form.address, repr(it.value)) for it in one.arguments])
        for one in message.operations
    ]
    return message.type, message.counter, message.global_size, operations


def _shorter(report: Report) -> tuple[Report, list[Change], list[str]]:
    """Returns the report on the frame with shorter encodings and the changes to it, and what was kept."""
    frame, made, kept = _shortened(report)
    if not made:
        return report, [], kept
    after = check(frame, dialect=report.dialect, carrier=report.carrier)
    if is_better(after, report):
        return after, made, kept
    reason = f"shorter encodings of {counted(len(made), 'value')} would not give a frame with fewer findings"
    return report, [], [reason]


def is_better(after: Report, before: Report) -> bool:
    """Returns whether a frame is accepted with fewer errors than another, or as many and fewer findings."""
    return after.accepted and _weight(after) < _weight(before)


def _weight(report: Report) -> tuple[int, int]:
    return len(report.errors), len(report.findings)


def _change(given: bytes, one: Suggestion) -> Change:
    at, end, new = difference(given, one.frame)
    before, after = (data.hex(":").upper() or "nothing" for data in (given[at:end], new))
    part = next(name for start, name in _PARTS.items() if start <= at)
    what = part if at < COMMAND_HEADER_SIZE and len(given) == len(one.frame) else f"offset {at}"
    return Change(what, before, after, one.message)


def _doubt(one: Suggestion, count: int) -> str:
    """Returns why a suggestion is not made."""
    if count > 1:
        return "or something else, which is as likely"
    if one.is_sure:
        return "so it is up to you" if one.harm else "but the brick accepts the frame, and would do something else then"
    return "its bytes can only be guessed" if one.unknown else "but that is not certain"


def _shortened(report: Report) -> tuple[bytes, list[Change], list[str]]:
    """Returns the frame with the shortest encodings, the changes to it, and a sentence about others."""
    frame, message = report.frame, read_last(report.frame, report.dialect)
    if not isinstance(message, DirectCommand) or message.fault is not None:
        return frame, [], []
    keeps_size = _spanned(message, len(frame))
    made: list[Change] = []
    found = [(one, argument) for one in message.operations for argument in longer_arguments(one)]
    spanned = sum(keeps_size[argument.offset] for _, argument in found)
    # From the last one on, so that the offsets of the others stay.
    for operation, argument in reversed(found):
        at = argument.offset
        if keeps_size[at]:
            continue
        new = shortest(argument)
        frame = with_length(frame[LENGTH_FIELD:at] + new + frame[at + argument.length :])
        what = f"{argument.name} of {operation.full_name} at offset {at}"
        before, after = argument.raw.hex(":").upper(), new.hex(":").upper()
        why = f"the same value in {counted(argument.length - len(new), 'byte')} less"
        made.insert(0, Change(what, before, after, why))
    its = "their" if spanned > 1 else "its"
    return frame, made, [f"{counted(spanned, 'longer encoding')} kept: a jump counts {its} bytes"] if spanned else []


def _spanned(command: DirectCommand, size: int) -> bytearray:
    """Returns 1 for each byte of the frame between a jump and its target, where no encoding may be shortened."""
    spanned = bytearray(size)
    for operation in command.operations:
        if not operation_facts(operation.schema).is_jump:
            continue
        jump = operation.arguments[-1]
        if jump.kind not in (CONSTANT, JUMP):
            return bytearray(b"\1" * size)
        end = operation.offset + operation.length
        target = min(max(end + int(jump.value), 0), size)
        first, last = min(target, end), max(target, end)
        spanned[first:last] = b"\1" * (last - first)
    return spanned
