"""System commands, and messages from brick to brick."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext
from ev3proto.checking.report import Finding
from ev3proto.checking.rules.header import TYPE_OFFSET
from ev3proto.errors import counted
from ev3proto.messages import DaisyCommand, SystemCommand
from ev3proto.schema.fields import NUMBERS
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables import daisy, mailboxes, paths
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.frame import REPORT_SIZES, MessageType
from ev3proto.tables.system import SYSTEM_BY_NUMBER, Field, Kind
from ev3proto.tables.system import SystemCommand as Entry

_USB = "usb"
_PATH = "path"
_NAME = "name"
_NAME_OFFSET = HEADER_SIZE + 2
"""Of a mailbox's name, after the command and the length of the name."""
_OPENED = "begin"
"""Transfers begin with a path of a file, which the firmware takes apart."""


def check_system(context: CheckContext, command: SystemCommand) -> Iterator[Finding]:
    """A system command."""
    entry = SYSTEM_BY_NUMBER.get(command.number) if context.end > HEADER_SIZE else None
    if entry is None:
        if not (context.is_length_wrong and context.end <= HEADER_SIZE):
            yield _unknown(context)
        return
    if context.carrier not in (None, _USB) and (entry.bootloader or entry.usb_only):
        yield codes.WRONG_CARRIER.finding(
            HEADER_SIZE,
            1,
            f"{entry.name} reaches a brick by USB only, not by {context.carrier}",
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
            context.end, 0, "the frame ends where the system command should stand", "give the number of one"
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
        f"0x{number:02X} is not a system command",
        f"give {' or '.join(_runs(known))}",
    )


def _runs(numbers: list[int]) -> Iterator[str]:
    """`0x92 to 0x9F`, `0xA1`: numbers in a row as one."""
    rest = sorted(numbers)
    while rest:
        last = first = rest.pop(0)
        while rest and rest[0] == last + 1:
            last = rest.pop(0)
        yield f"0x{first:02X}" if first == last else f"0x{first:02X} to 0x{last:02X}"


def _answer(command: SystemCommand, entry: Entry) -> Iterator[Finding]:
    if command.wants_reply and not entry.answered:
        yield codes.NEVER_ANSWERED.finding(
            TYPE_OFFSET,
            1,
            f"the type asks for a reply, and the brick never replies to {entry.name}",
            f"give the type 0x{MessageType.SYSTEM_COMMAND_NO_REPLY:02X}, and do not wait",
            entry.name,
        )
    elif not command.wants_reply and _is_question(entry):
        content = "the handle for what follows" if entry.transfer == _OPENED else "what is asked for"
        yield codes.ANSWER_NEEDED.finding(
            TYPE_OFFSET,
            1,
            f"the type says that no reply is wanted, and the reply to {entry.name} brings {content}",
            f"give the type 0x{MessageType.SYSTEM_COMMAND_REPLY:02X}",
            entry.name,
        )


def _is_question(entry: Entry) -> bool:
    return entry.transfer == _OPENED or any(field.kind in (Kind.DATA, Kind.LISTING, Kind.U32) for field in entry.reply)


def _wrong_fields(context: CheckContext, entry: Entry) -> Finding:
    fault = context.fault
    assert fault is not None
    start = min(fault.offset, context.end)
    expected = ", ".join(f"{field.name} ({field.kind.value})" for field in entry.request) or "nothing"
    return codes.WRONG_FIELDS.finding(
        start,
        context.end - start,
        f"{entry.name}: {fault.reason}",
        f"give what belongs after the command: {expected}",
        entry.name,
    )


def _fields(command: SystemCommand, entry: Entry) -> Iterator[Finding]:
    """Fields that can be read, and are too long."""
    at = HEADER_SIZE + 1
    for field in entry.request:
        value = command.fields.get(field.name)
        if value is None:
            return
        size = _size(field, value)
        if field.most is not None and size > field.most:
            yield codes.FIELD_TOO_LONG.finding(
                at,
                size,
                f"{field.name} has {counted(size, 'byte')}, and the firmware has room for {field.most}",
                f"shorten it by {size - field.most}",
                entry.name,
                field.name,
            )
        if field.name == _PATH and isinstance(value, str):
            yield from _path(at, value, entry)
        if field.is_message and isinstance(value, bytes):
            yield from _mailbox(at, value, str(command.fields[_NAME]), entry, field.name)
        at += size


def _size(field: Field, value: int | str | bytes) -> int:
    """Bytes of a field in the frame."""
    if isinstance(value, int):
        return int(NUMBERS[field.kind].sizeof())
    if isinstance(value, str):
        return len(value.encode(STRING_CODING)) + 1
    return len(value)


def _path(at: int, path: str, entry: Entry) -> Iterator[Finding]:
    """What the firmware has no room for, or what opens nothing."""
    if not path and not _lists(entry):
        yield codes.REFUSED_PATH.finding(
            at, 1, f"the path of {entry.name} is empty", "name a file or folder", entry.name, _PATH
        )
        return
    folder, slash, rest = path.rpartition("/")
    name, dot, extension = rest.partition(".")
    if entry.transfer != _OPENED or _lists(entry):
        # The firmware takes the paths of files apart that it opens, and no others.
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
        # A path that is too long may have a folder that is, too: shortening that helps both.
        folder_excess = excesses[1] if what == "path" and len(parts) > 1 else 0
        shorten = (
            f"shorten its folder by {max(excess, folder_excess)}" if folder_excess > 0 else f"shorten it by {excess}"
        )
        yield codes.REFUSED_PATH.finding(
            at + start,
            len(part),
            f"the {what} has {counted(len(part), 'character')}, and the firmware takes {room - 1} at most",
            shorten,
            entry.name,
            _PATH,
        )
        return


def _mailbox(at: int, payload: bytes, name: str, entry: Entry, field: str) -> Iterator[Finding]:
    """A message that starts at an offset, to a mailbox of that name."""
    if len(name) > mailboxes.MOST_NAME:
        yield codes.MAILBOX_TOO_SMALL.finding(
            _NAME_OFFSET,
            len(name),
            f"the name has {len(name)} characters, and that of a mailbox has {mailboxes.MOST_NAME} at most",
            f"shorten it by {len(name) - mailboxes.MOST_NAME}",
            entry.name,
            _NAME,
        )
    if len(payload) > mailboxes.MOST_CONTENT:
        yield codes.MAILBOX_TOO_SMALL.finding(
            at,
            len(payload),
            f"the message has {len(payload)} bytes, and a mailbox has room for {mailboxes.MOST_CONTENT}",
            f"shorten it by {len(payload) - mailboxes.MOST_CONTENT}",
            entry.name,
            field,
        )
    if mailboxes.lacks_zero(payload):
        yield codes.TEXT_WITHOUT_ZERO.finding(
            at,
            len(payload),
            "the message looks like a text, and has no zero at its end",
            "add a zero, and count it in the length of the message",
            entry.name,
            field,
        )


def _lists(entry: Entry) -> bool:
    """Whether it is about what a folder holds."""
    return any(field.kind is Kind.LISTING for field in entry.reply)


_DAISY = f"0x{min(daisy.DaisyCommand):02X} to 0x{max(daisy.DaisyCommand):02X}"


def check_daisy(context: CheckContext, command: DaisyCommand) -> Iterator[Finding]:
    """A message from brick to brick."""
    fault = context.fault
    if fault is not None and not (context.is_length_wrong and fault.truncated):
        start = min(fault.offset, context.end)
        yield codes.UNKNOWN_DAISY.finding(
            start, min(1, context.end - start), fault.reason, f"give a sub-command, {_DAISY}, and two layers"
        )
    most = REPORT_SIZES[0]
    if context.end > most:
        yield codes.LONG_DAISY.finding(
            most,
            context.end - most,
            f"the frame has {context.end} bytes, and a report between bricks carries {most}",
            "send less at once",
            command.command,
        )
