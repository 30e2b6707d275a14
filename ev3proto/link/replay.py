"""The replay of a capture's commands: which are sent, in which form, and how the replies differ from the recorded ones.

There is no I/O here: the caller sends the frames of `frame_for` and passes on the replies.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum
from itertools import chain

from ev3proto.capture.dialogues import RequestReply
from ev3proto.capture.record import Direction, Record
from ev3proto.link.harm import Harm, harms_of
from ev3proto.link.open_handles import OpenHandles
from ev3proto.messages import Message, SystemReply
from ev3proto.schema.frame import parse
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.semantics.replies import Value, values_of
from ev3proto.tables import operations
from ev3proto.tables.declaration import Effect
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SYSTEM, SYSTEM_BY_NUMBER, SystemStatus
from ev3proto.text.phrases import status_name, value_text

_HANDLE = "handle"
_HANDLE_AT = HEADER_SIZE + 1
_MOST_DIFFERENCES = 4
_FIRMWARE = "UI_READ.GET_FW_VERS"


@dataclass(frozen=True, slots=True)
class Step:
    """A command of a capture."""

    command: Record  # as it was recorded
    reply: Record | None  # the recorded reply, None without one
    harms: dict[Harm, str]  # the reasons to omit it, each with its operation; empty if it is sent


class Likeness(Enum):
    """How a reply compares with the recorded one."""

    SAME = "as recorded"
    VALUES = "with other values"
    KIND = "otherwise"


def steps(pairs: Iterable[RequestReply], allowed: frozenset[str]) -> list[Step]:
    """Returns the commands of a capture in the order of sending; `allowed` may be sent besides reading."""
    sent = [
        (command, reply)
        for command, reply in pairs
        if command is not None and command.direction is not Direction.RECEIVED
    ]
    found, handles = [], OpenHandles()
    for command, reply in sorted(sent, key=lambda pair: (pair[0].time_ns, pair[0].number)):
        harms = _harms(command.message, allowed, handles)
        found.append(Step(command, reply, harms))
        if reply is not None and not harms:
            handles.learn(reply.message)
    return found


def _harms(message: Message, allowed: frozenset[str], handles: OpenHandles) -> dict[Harm, str]:
    """Returns why a message is omitted; one of unknown type cannot be sent with a new counter at all."""
    return {Harm.UNKNOWN: "the frame"} if message.type is None else harms_of(message, allowed, handles)


class Handles:
    """The brick's handles of open files: the recorded ones and the present ones."""

    def __init__(self) -> None:
        self._now: dict[int, int] = {}

    def frame_for(self, command: Record) -> bytes:
        """Returns the frame of a recorded command, with the handle that the file has now."""
        frame = command.frame
        if _has_handle(command.message) and len(frame) > _HANDLE_AT:
            handle = frame[_HANDLE_AT]
            return frame[:_HANDLE_AT] + bytes((self._now.get(handle, handle),)) + frame[_HANDLE_AT + 1 :]
        return frame

    def learn(self, recorded: Record | None, reply: bytes) -> None:
        """Takes a reply, and the recorded one: a file that both open may have another handle now."""
        if recorded is None:
            return
        before, now = recorded.message, parse(reply, strict=False)
        if isinstance(before, SystemReply) and isinstance(now, SystemReply):
            was, is_now = before.fields.get(_HANDLE), now.fields.get(_HANDLE)
            entry = SYSTEM_BY_NUMBER.get(now.number)
            if entry is not None and entry.transfer == "begin" and isinstance(was, int) and isinstance(is_now, int):
                self._now[was] = is_now


def compare(step: Step, frame: bytes, reply: bytes | None, dialect: str) -> tuple[Likeness, str]:
    """Returns how a reply compares with the recorded one, and what differs in words."""
    if reply is None or step.reply is None:
        if reply is None and step.reply is None:
            return Likeness.SAME, ""
        return Likeness.KIND, "recorded: no reply" if step.reply is None else "recorded: a reply"
    before, now = step.reply.message, parse(reply, strict=False, dialect=dialect)
    if _outcome(before) != _outcome(now):
        return Likeness.KIND, f"recorded: {_kind(before)}"
    if step.reply.frame[HEADER_SIZE:] == reply[HEADER_SIZE:]:
        return Likeness.SAME, ""
    values = values_of(now, parse(frame, strict=False, dialect=dialect))
    changed = [
        was
        for was, is_now in zip(step.reply.values, values, strict=False)
        if was.value != is_now.value and was.name != _HANDLE
    ]
    more = f" and {len(changed) - _MOST_DIFFERENCES} more" if len(changed) > _MOST_DIFFERENCES else ""
    shown = ", ".join(f"{was.name}={value_text(was)}" for was in changed[:_MOST_DIFFERENCES])
    if values and len(values) == len(step.reply.values) and all(map(_varies, changed)):
        # Handles, and memory that was not written to, may also differ.
        return Likeness.SAME, f"recorded: {shown}{more}" if shown else ""
    return Likeness.VALUES, f"recorded: {shown or 'other bytes'}{more}"


def _has_handle(message: Message) -> bool:
    entry = SYSTEM_BY_NUMBER.get(getattr(message, "number", -1))
    is_command = message.type is not None and message.type.is_command and message.type.carries == "system"
    return is_command and entry is not None and bool(entry.request) and entry.request[0].name == _HANDLE


def _outcome(message: Message) -> tuple[MessageType | None, int | None]:
    """Returns the type and status of a reply; END_OF_FILE is ignored, as the size of pieces depends on the brick."""
    if not isinstance(message, SystemReply):
        return message.type, None
    entry = SYSTEM_BY_NUMBER.get(message.number)
    is_part = entry is not None and Effect.VARIES in entry.effects and message.status is SystemStatus.END_OF_FILE
    return message.type, SystemStatus.SUCCESS if is_part else message.status_code


def _varies(value: Value) -> bool:
    """Returns whether a value depends on the brick or on time, such as the battery, names, sensors."""
    declaration = operations().get(value.full_name)
    effects = [entry.effects for entry in SYSTEM if entry.name == value.op] if declaration is None else []
    return Effect.VARIES in (declaration.effects if declaration is not None else chain(*effects))


def firmware_of(reply: Record) -> str | None:
    """Returns the version of the firmware in a reply; None if it has none."""
    found = [value.value for value in reply.values if value.full_name == _FIRMWARE]
    return str(found[0]) if found else None


def _kind(message: Message) -> str:
    if isinstance(message, SystemReply):
        return status_name(message)
    return "not an EV3 message" if message.type is None else message.type.name
