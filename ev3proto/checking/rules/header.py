"""The frame itself: its length, its type, the memory that its header requests, and system commands."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext
from ev3proto.checking.report import Finding
from ev3proto.checking.verdict import Reason
from ev3proto.errors import Fault, counted
from ev3proto.messages import DaisyCommand, DirectCommand, SystemCommand
from ev3proto.schema.frame import frame_reader
from ev3proto.schema.header import (
    COMMAND_HEADER_SIZE,
    HEADER_SIZE,
    MEMORY_SIZE,
    MOST_IN_REPLY,
    TYPE_AT,
    frame_size,
    may_be_long,
)
from ev3proto.schema.wire_format import NUMBERS
from ev3proto.semantics.advice import advice
from ev3proto.semantics.identify import NOTHING, foreign
from ev3proto.tables import mailboxes, paths
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.frame import GRANTED_GLOBALS, LENGTH_FIELD, MIN_LENGTH, REPORT_SIZES
from ev3proto.tables.system import FLASH_SIZE, SYSTEM_BY_NUMBER, FieldKind, SystemDeclaration, SystemField


def check_envelope(context: CheckContext) -> Iterator[Finding]:
    """Checks length and type."""
    frame = context.frame
    size = len(frame)
    if size < HEADER_SIZE:
        yield codes.TOO_SHORT.at(0, size, size=size)
        return
    is_wrong = context.is_length_wrong or context.fault is not None or context.message.type is None
    found = foreign(frame, frame_reader(context.dialect)) if is_wrong else NOTHING
    if (said := advice(found)) is not None:
        yield codes.NOT_A_FRAME.at(0, size, said=said)
        return
    yield from _length(frame, size, context)
    if context.message.type is None:
        yield codes.UNKNOWN_TYPE.at(TYPE_AT, 1, type=frame[TYPE_AT])
    elif not context.message.type.is_command:
        yield codes.NO_COMMAND.at(TYPE_AT, 1, type=context.message.type.name)


def _length(frame: bytes, size: int, context: CheckContext) -> Iterator[Finding]:
    stated, follow = frame_size(frame) - LENGTH_FIELD, size - LENGTH_FIELD
    most = context.most
    parts = {"stated": f"{counted(stated, 'byte')} {'follows' if stated == 1 else 'follow'}", "follow": follow}
    if min(size, stated + LENGTH_FIELD) > most:
        yield codes.TOO_LONG.at(most, size - most, most=most, carrier="USB" if may_be_long(frame) else None, size=size)
    elif stated > follow:
        yield codes.INCOMPLETE.at(0, LENGTH_FIELD, missing=counted(stated - follow, "missing byte"), **parts)
    elif context.is_padded and context.carrier in (None, "usb"):
        end = context.end
        yield codes.PADDING.at(end, size - end, zeros=counted(size - end, "zero"))
    elif stated < follow:
        over = counted(follow - stated, "byte") if stated > MIN_LENGTH else None
        key = "" if size <= most else "too long"
        yield codes.LEFT_OVER.at(0, LENGTH_FIELD, key, most=most - LENGTH_FIELD, over=over, **parts)


def check_command_header(context: CheckContext, command: DirectCommand) -> Iterator[Finding]:
    """Checks what the header of a direct command requests."""
    reason = context.verdict.reason
    if reason is Reason.EMPTY or context.end < COMMAND_HEADER_SIZE:
        if not context.is_length_wrong:
            yield codes.EMPTY.at(context.end, 0, "" if context.end == COMMAND_HEADER_SIZE else "no memory")
        return
    asked = command.global_size
    if asked > GRANTED_GLOBALS:
        yield codes.REFUSED_MEMORY.at(HEADER_SIZE, MEMORY_SIZE, asked=asked)
    elif asked > MOST_IN_REPLY:
        yield codes.LONG_REPLY.at(HEADER_SIZE, MEMORY_SIZE, asked=asked)


_USB = "usb"
_PATH = "path"
_NAME = "name"
_NAME_OFFSET = HEADER_SIZE + 2
"""Offset of a mailbox's name, after the command and the length of the name."""
_OPENED = "begin"
"""Transfers begin with the path of a file, which the firmware splits."""


def check_system(context: CheckContext, command: SystemCommand) -> Iterator[Finding]:
    """Checks a system command."""
    entry = SYSTEM_BY_NUMBER.get(command.number) if context.end > HEADER_SIZE else None
    if entry is None:
        if not (context.is_length_wrong and context.end <= HEADER_SIZE):
            yield _unknown(context)
        return
    if context.carrier not in (None, _USB) and (entry.bootloader or entry.usb_only):
        yield codes.WRONG_CARRIER.at(HEADER_SIZE, 1, owner=entry.name, carrier=context.carrier)
    yield from _answer(command, entry)
    if context.own_fault is not None:
        yield _wrong_fields(context, entry, context.own_fault)
    elif context.fault is None:
        yield from _fields(command, entry)


def _unknown(context: CheckContext) -> Finding:
    if context.end <= HEADER_SIZE:
        return codes.UNKNOWN_SYSTEM.at(context.end, 0, "cut off")
    known = [
        entry.number
        for entry in SYSTEM_BY_NUMBER.values()
        if not entry.bootloader and not (entry.usb_only and context.carrier not in (None, _USB))
    ]
    return codes.UNKNOWN_SYSTEM.at(HEADER_SIZE, 1, number=context.frame[HEADER_SIZE], known=" or ".join(_runs(known)))


def _runs(numbers: list[int]) -> Iterator[str]:
    """Yields consecutive numbers as ranges: `0x92 to 0x9F`, `0xA1`."""
    rest = sorted(numbers)
    while rest:
        last = first = rest.pop(0)
        while rest and rest[0] == last + 1:
            last = rest.pop(0)
        yield f"0x{first:02X}" if first == last else f"0x{first:02X} to 0x{last:02X}"


def _answer(command: SystemCommand, entry: SystemDeclaration) -> Iterator[Finding]:
    if command.wants_reply and not entry.answered:
        yield codes.NEVER_ANSWERED.at(TYPE_AT, 1, owner=entry.name)
    elif not command.wants_reply and _is_question(entry):
        yield codes.ANSWER_NEEDED.at(TYPE_AT, 1, "handle" if entry.transfer == _OPENED else "", owner=entry.name)


def _is_question(entry: SystemDeclaration) -> bool:
    return entry.transfer == _OPENED or any(
        field.kind in (FieldKind.DATA, FieldKind.LISTING, FieldKind.U32) for field in entry.reply
    )


def _wrong_fields(context: CheckContext, entry: SystemDeclaration, fault: Fault) -> Finding:
    start = min(fault.offset, context.end)
    expected = ", ".join(f"{field.name} ({field.kind.value})" for field in entry.request) or "nothing"
    return codes.WRONG_FIELDS.at(start, context.end - start, owner=entry.name, reason=fault.reason, expected=expected)


def _fields(command: SystemCommand, entry: SystemDeclaration) -> Iterator[Finding]:
    """Checks the lengths of the fields that can be read."""
    at = HEADER_SIZE + 1
    for field in entry.request:
        value = command.fields.get(field.name)
        if value is None:
            return
        size = _size(field, value)
        if field.most is not None and size > field.most:
            parts = {"bytes": counted(size, "byte"), "most": field.most, "over": size - field.most}
            yield codes.FIELD_TOO_LONG.at(at, size, owner=entry.name, name=field.name, **parts)
        if isinstance(value, int):
            yield from _number(at, value, entry, field)
        if field.name == _PATH and isinstance(value, str):
            yield from _path(at, value, entry)
        if field.is_message and isinstance(value, bytes):
            yield from _mailbox(at, value, str(command.fields[_NAME]), entry, field.name)
        at += size


def _number(at: int, value: int, entry: SystemDeclaration, field: SystemField) -> Iterator[Finding]:
    """Checks the size of a file."""
    if entry.transfer == _OPENED and value > FLASH_SIZE:
        yield codes.FILE_TOO_LARGE.at(at, _size(field, value), owner=entry.name, name=field.name, value=value)


def _size(field: SystemField, value: int | str | bytes) -> int:
    """Returns the bytes of a field in the frame."""
    if isinstance(value, int):
        return int(NUMBERS[field.kind].sizeof())
    if isinstance(value, str):
        return len(value.encode(STRING_CODING)) + 1
    return len(value)


def _path(at: int, path: str, entry: SystemDeclaration) -> Iterator[Finding]:
    """Checks a path: too long for the firmware, or empty."""
    if not path and not _lists(entry):
        yield codes.REFUSED_PATH.at(at, 1, "empty", owner=entry.name, name=_PATH)
        return
    folder, slash, rest = path.rpartition("/")
    name, dot, extension = rest.partition(".")
    start = len(folder + slash)
    limits = (
        ("path", len(path), paths.WHOLE, 0),
        ("folder", start, paths.FOLDER, 0),
        ("name", len(name), paths.NAME, start),
        ("extension", len(dot + extension), paths.EXTENSION, start + len(name)),
    )
    # The firmware splits only the paths of files that it opens.
    is_split = entry.transfer == _OPENED and not _lists(entry)
    long = [one for one in limits[: None if is_split else 1] if one[1] >= one[2]]
    over = {what: size - room + 1 for what, size, room, _ in long}
    for what, size, room, start in long[:1]:
        # If the folder is also too long, shortening it fixes both.
        is_folder = what == "path" and "folder" in over
        parts = {
            "part": what,
            "characters": counted(size, "character"),
            "most": room - 1,
            "what": "its folder" if is_folder else "it",
            "over": max(over[what], over.get("folder", 0)),
        }
        yield codes.REFUSED_PATH.at(at + start, size, owner=entry.name, name=_PATH, **parts)


def _mailbox(at: int, payload: bytes, name: str, entry: SystemDeclaration, field: str) -> Iterator[Finding]:
    """Checks a message at an offset, to a mailbox of that name."""
    for key, start, size, most, part in (
        (codes.MAILBOX_NAME, _NAME_OFFSET, len(name), mailboxes.MOST_NAME, _NAME),
        (codes.MAILBOX_CONTENT, at, len(payload), mailboxes.MOST_CONTENT, field),
    ):
        if size > most:
            yield codes.MAILBOX_TOO_SMALL.at(start, size, key, owner=entry.name, name=part, size=size)
    if mailboxes.lacks_zero(payload):
        yield codes.TEXT_WITHOUT_ZERO.at(at, len(payload), owner=entry.name, name=field)
    elif other := mailboxes.number_of_another_type(payload):
        kind, value = other
        right = mailboxes.message_of(float(value)).hex(" ").upper()
        parts = {"kind": kind, "value": value, "bytes": right}
        yield codes.NUMBER_OF_ANOTHER_TYPE.at(at, len(payload), owner=entry.name, name=field, **parts)


def _lists(entry: SystemDeclaration) -> bool:
    """Returns whether it lists a folder."""
    return any(field.kind is FieldKind.LISTING for field in entry.reply)


def check_daisy(context: CheckContext, command: DaisyCommand) -> Iterator[Finding]:
    """Checks a message between bricks."""
    fault = context.own_fault
    if fault is not None:
        start = min(fault.offset, context.end)
        yield codes.UNKNOWN_DAISY.at(start, min(1, context.end - start), reason=fault.reason)
    most = REPORT_SIZES[0]
    if context.end > most:
        yield codes.LONG_DAISY.at(most, context.end - most, owner=command.command, size=context.end)
