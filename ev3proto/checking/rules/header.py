"""The frame itself: its length, its type, the memory that its header requests, and system commands."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext
from ev3proto.checking.report import Finding
from ev3proto.checking.verdict import Reason
from ev3proto.errors import counted
from ev3proto.messages import DaisyCommand, DirectCommand, SystemCommand
from ev3proto.schema.frame import frame_reader
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, MEMORY_SIZE, MOST_IN_REPLY, frame_size, may_be_long
from ev3proto.schema.wire_format import NUMBERS
from ev3proto.semantics.advice import advice
from ev3proto.semantics.identify import NOTHING, foreign
from ev3proto.tables import daisy, mailboxes, paths
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.frame import GRANTED_GLOBALS, LENGTH_FIELD, MIN_LENGTH, REPORT_SIZES, MessageType
from ev3proto.tables.system import FLASH_SIZE, SYSTEM_BY_NUMBER, FieldKind, SystemDeclaration, SystemField

TYPE_OFFSET = HEADER_SIZE - 1
"""Offset of the message type."""


def check_envelope(context: CheckContext) -> Iterator[Finding]:
    """Checks length and type."""
    frame = context.frame
    size = len(frame)
    if size < HEADER_SIZE:
        yield codes.TOO_SHORT.finding(
            0,
            size,
            f"a frame has at least {HEADER_SIZE} bytes (length, counter, type), this one has {size}",
            "start at the length field and include the whole frame",
        )
        return
    is_wrong = context.is_length_wrong or context.fault is not None or context.message.type is None
    found = foreign(frame, frame_reader(context.dialect)) if is_wrong else NOTHING
    if (said := advice(found)) is not None:
        yield codes.NOT_A_FRAME.finding(0, size, said, "send a frame; `ops` lists the operations")
        return
    yield from _length(frame, size, context)
    if context.message.type is None:
        yield codes.UNKNOWN_TYPE.finding(
            TYPE_OFFSET,
            1,
            f"unknown message type 0x{frame[TYPE_OFFSET]:02X}",
            f"use 0x{MessageType.DIRECT_COMMAND_REPLY:02X} for a direct command with a reply,"
            f" 0x{MessageType.DIRECT_COMMAND_NO_REPLY:02X} for one without,"
            f" 0x{MessageType.SYSTEM_COMMAND_REPLY:02X} or 0x{MessageType.SYSTEM_COMMAND_NO_REPLY:02X} for a system"
            " command",
        )
    elif not context.message.type.is_command:
        yield codes.NO_COMMAND.finding(
            TYPE_OFFSET,
            1,
            f"{context.message.type.name} is a message from the brick, not to it",
            "check the command that it answers",
        )


def _length(frame: bytes, size: int, context: CheckContext) -> Iterator[Finding]:
    stated, follow = frame_size(frame) - LENGTH_FIELD, size - LENGTH_FIELD
    most = context.most
    says = f"the length field says that {counted(stated, 'byte')} {'follows' if stated == 1 else 'follow'} it, but"
    if size > most and (stated == follow or stated + LENGTH_FIELD > most):
        yield codes.TOO_LONG.finding(
            most,
            size - most,
            f"a frame has at most {most} bytes{' on USB' if may_be_long(frame) else ''}, this one has {size}",
            "send it in several frames",
        )
    elif stated > follow:
        yield codes.INCOMPLETE.finding(
            0,
            LENGTH_FIELD,
            f"{says} there are {follow}",
            f"set the length to {follow}, or add the {counted(stated - follow, 'missing byte')}",
        )
    elif context.is_padded and context.carrier in (None, "usb"):
        end = context.end
        yield codes.PADDING.finding(
            end,
            size - end,
            f"the frame ends here; {counted(size - end, 'zero')} pad it to a USB report",
            "omit them, except on USB",
        )
    elif stated < follow:
        omit = f", or omit the last {counted(follow - stated, 'byte')}" if stated > MIN_LENGTH else ""
        length = f"set the length to {follow}" if size <= most else f"use a length of at most {most - LENGTH_FIELD}"
        yield codes.LEFT_OVER.finding(0, LENGTH_FIELD, f"{says} there are {follow}", f"{length}{omit}")


def check_command_header(context: CheckContext, command: DirectCommand) -> Iterator[Finding]:
    """Checks what the header of a direct command requests."""
    reason = context.verdict.reason
    if reason is Reason.EMPTY or context.end < COMMAND_HEADER_SIZE:
        if not context.is_length_wrong:
            yield codes.EMPTY.finding(
                context.end,
                0,
                "the command has no operation"
                if context.end == COMMAND_HEADER_SIZE
                else "the command ends before the two bytes that request memory",
                f"add at least one operation; {codes.opcode('NOP')} does nothing"
                if context.end == COMMAND_HEADER_SIZE
                else "add two bytes that request memory, 0 for none, and then at least one operation;"
                f" {codes.opcode('NOP')} does nothing",
            )
        return
    asked = command.global_size
    if asked > GRANTED_GLOBALS:
        yield codes.REFUSED_MEMORY.finding(
            HEADER_SIZE,
            MEMORY_SIZE,
            f"the header requests {asked} bytes of global memory, but the firmware grants at most {GRANTED_GLOBALS}",
            f"request at most {MOST_IN_REPLY} bytes, which fit into a reply",
        )
    elif asked > MOST_IN_REPLY:
        yield codes.LONG_REPLY.finding(
            HEADER_SIZE,
            MEMORY_SIZE,
            f"the header requests {asked} bytes of global memory, but a reply carries {MOST_IN_REPLY}",
            f"request at most {MOST_IN_REPLY} bytes",
        )


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
        yield codes.WRONG_CARRIER.finding(
            HEADER_SIZE,
            1,
            f"{entry.name} reaches the brick only by USB, not by {context.carrier}",
            "send it by USB",
            entry.name,
        )
    yield from _answer(command, entry)
    if context.fault is not None:
        if not (context.is_length_wrong and context.fault.truncated):
            yield _wrong_fields(context, entry)
        return
    yield from _fields(command, entry)


def _unknown(context: CheckContext) -> Finding:
    if context.end <= HEADER_SIZE:
        return codes.UNKNOWN_SYSTEM.finding(
            context.end, 0, "the frame ends before the number of the system command", "add the number"
        )
    number = context.frame[HEADER_SIZE]
    known = [
        entry.number
        for entry in SYSTEM_BY_NUMBER.values()
        if not entry.bootloader and not (entry.usb_only and context.carrier not in (None, _USB))
    ]
    return codes.UNKNOWN_SYSTEM.finding(
        HEADER_SIZE,
        1,
        f"unknown system command 0x{number:02X}",
        f"use {' or '.join(_runs(known))}",
    )


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
        yield codes.NEVER_ANSWERED.finding(
            TYPE_OFFSET,
            1,
            f"the type asks for a reply, but the brick never replies to {entry.name}",
            f"use type 0x{MessageType.SYSTEM_COMMAND_NO_REPLY:02X}, and do not wait",
            entry.name,
        )
    elif not command.wants_reply and _is_question(entry):
        content = "the handle for the next commands" if entry.transfer == _OPENED else "the requested contents"
        yield codes.ANSWER_NEEDED.finding(
            TYPE_OFFSET,
            1,
            f"the type does not ask for a reply, but the reply to {entry.name} has {content}",
            f"use type 0x{MessageType.SYSTEM_COMMAND_REPLY:02X}",
            entry.name,
        )


def _is_question(entry: SystemDeclaration) -> bool:
    return entry.transfer == _OPENED or any(
        field.kind in (FieldKind.DATA, FieldKind.LISTING, FieldKind.U32) for field in entry.reply
    )


def _wrong_fields(context: CheckContext, entry: SystemDeclaration) -> Finding:
    fault = context.fault
    assert fault is not None
    start = min(fault.offset, context.end)
    expected = ", ".join(f"{field.name} ({field.kind.value})" for field in entry.request) or "nothing"
    return codes.WRONG_FIELDS.finding(
        start,
        context.end - start,
        f"{entry.name}: {fault.reason}",
        f"fields of the command: {expected}",
        entry.name,
    )


def _fields(command: SystemCommand, entry: SystemDeclaration) -> Iterator[Finding]:
    """Checks the lengths of the fields that can be read."""
    at = HEADER_SIZE + 1
    for field in entry.request:
        value = command.fields.get(field.name)
        if value is None:
            return
        size = _size(field, value)
        if isinstance(value, int) and entry.transfer == _OPENED and value > FLASH_SIZE:
            yield codes.FILE_TOO_LARGE.finding(
                at,
                size,
                f"{field.name} is {value}, but the flash memory of a brick has {FLASH_SIZE} bytes",
                "send the size of the file, the low byte first",
                entry.name,
                field.name,
            )
        elif field.most is not None and size > field.most:
            yield codes.FIELD_TOO_LONG.finding(
                at,
                size,
                f"{field.name} has {counted(size, 'byte')}, but the firmware has room for only {field.most}",
                f"shorten it by {size - field.most}",
                entry.name,
                field.name,
            )
        if field.name == _PATH and isinstance(value, str):
            yield from _path(at, value, entry)
        if field.is_message and isinstance(value, bytes):
            yield from _mailbox(at, value, str(command.fields[_NAME]), entry, field.name)
        at += size


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
        yield codes.REFUSED_PATH.finding(
            at, 1, f"the path of {entry.name} is empty", "name a file or folder", entry.name, _PATH
        )
        return
    folder, slash, rest = path.rpartition("/")
    name, dot, extension = rest.partition(".")
    if entry.transfer != _OPENED or _lists(entry):
        # The firmware splits only the paths of files that it opens.
        parts: tuple[tuple[str, str, int, int], ...] = (("path", path, paths.WHOLE, 0),)
    else:
        start = len(folder + slash)
        parts = (
            ("path", path, paths.WHOLE, 0),
            ("folder", folder + slash, paths.FOLDER, 0),
            ("name", name, paths.NAME, start),
            ("extension", dot + extension, paths.EXTENSION, start + len(name)),
        )
    excesses = [len(part) - room + 1 for _, part, room, _ in parts]
    for (what, part, room, start), excess in zip(parts, excesses, strict=True):
        if excess <= 0:
            continue
        # If the folder is also too long, shortening it fixes both.
        folder_excess = excesses[1] if what == "path" and len(parts) > 1 else 0
        shorten = (
            f"shorten its folder by {max(excess, folder_excess)}" if folder_excess > 0 else f"shorten it by {excess}"
        )
        yield codes.REFUSED_PATH.finding(
            at + start,
            len(part),
            f"the {what} has {counted(len(part), 'character')}; the firmware accepts at most {room - 1}",
            shorten,
            entry.name,
            _PATH,
        )
        return


def _mailbox(at: int, payload: bytes, name: str, entry: SystemDeclaration, field: str) -> Iterator[Finding]:
    """Checks a message at an offset, to a mailbox of that name."""
    for key, start, size, most, owner in (
        (codes.MAILBOX_NAME, _NAME_OFFSET, len(name), mailboxes.MOST_NAME, _NAME),
        (codes.MAILBOX_CONTENT, at, len(payload), mailboxes.MOST_CONTENT, field),
    ):
        if size > most:
            message, help_ = codes.MAILBOX_TOO_SMALL.words[key]
            yield codes.MAILBOX_TOO_SMALL.finding(start, size, message.format(size=size), help_, entry.name, owner)
    if mailboxes.lacks_zero(payload):
        yield codes.TEXT_WITHOUT_ZERO.finding(
            at,
            len(payload),
            "the message looks like a text without a zero at its end",
            "add a zero, and count it in the length of the message",
            entry.name,
            field,
        )
    elif other := mailboxes.number_of_another_type(payload):
        kind, value = other
        yield codes.NUMBER_OF_ANOTHER_TYPE.finding(
            at,
            len(payload),
            f"the message is {value:g} as {kind}; a program reads a number as a float of 4 bytes, little-endian",
            f"send {mailboxes.message_of(float(value)).hex(' ').upper()} for {value:g}",
            entry.name,
            field,
        )


def _lists(entry: SystemDeclaration) -> bool:
    """Returns whether it lists a folder."""
    return any(field.kind is FieldKind.LISTING for field in entry.reply)


_DAISY = f"0x{min(daisy.DaisySubCommand):02X} to 0x{max(daisy.DaisySubCommand):02X}"


def check_daisy(context: CheckContext, command: DaisyCommand) -> Iterator[Finding]:
    """Checks a message between bricks."""
    fault = context.fault
    if fault is not None and not (context.is_length_wrong and fault.truncated):
        start = min(fault.offset, context.end)
        yield codes.UNKNOWN_DAISY.finding(
            start, min(1, context.end - start), fault.reason, f"use a sub-command, {_DAISY}, and two layers"
        )
    most = REPORT_SIZES[0]
    if context.end > most:
        yield codes.LONG_DAISY.finding(
            most,
            context.end - most,
            f"the frame has {context.end} bytes, but a report between bricks carries {most}",
            "send less data per frame",
            command.command,
        )
