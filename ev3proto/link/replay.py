"""The replay of a capture's commands: which are sent, in which form, and how the replies differ from the recorded ones.

There is no I/O here: the caller sends the frames that a talk yields, and passes on the replies.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from itertools import chain

from ev3proto.capture.dialogues import RequestReply, is_error
from ev3proto.capture.record import Direction, Record
from ev3proto.link.harm import Harm, harms_of
from ev3proto.link.policy import Outcome, Policy, Talk
from ev3proto.link.transfers import OpenTransfers
from ev3proto.messages import Message, SystemReply
from ev3proto.schema.frame import parse
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.semantics.replies import Value, values_of
from ev3proto.semantics.transfers import handle_of, step_of
from ev3proto.tables import operations
from ev3proto.tables.declaration import Effect
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SYSTEM, SYSTEM_BY_NUMBER, SystemStatus
from ev3proto.text.phrases import status_name, value_text

_HANDLE = "handle"
_LEFT_HANDLE = "a handle of the recording"
_HANDLE_AT = HEADER_SIZE + 1
_MOST_DIFFERENCES = 4
_FIRMWARE = "UI_READ.GET_FW_VERS"


@dataclass(frozen=True, slots=True)
class Step:
    """A command of a capture."""

    command: Record  # as it was recorded
    reply: Record | None  # the recorded reply, None without one


class Likeness(Enum):
    """How a reply compares with the recorded one."""

    SAME = "as recorded"
    VALUES = "with other values"
    KIND = "otherwise"


def steps(pairs: Iterable[RequestReply]) -> list[Step]:
    """Returns the commands of a capture in the order of sending."""
    sent = [
        Step(command, reply)
        for command, reply in pairs
        if command is not None and command.direction is not Direction.RECEIVED
    ]
    return sorted(sent, key=lambda step: (step.command.time_ns, step.command.number))


def plan(found: Iterable[Step], allowed: frozenset[str]) -> Iterator[tuple[Step, Mapping[Harm, str]]]:
    """Yields each step with the reasons to omit it, if the brick answers as recorded."""
    opened = OpenTransfers()
    for step in found:
        message, handle = step.command.message, handle_of(step.command.message)
        harms = harms_of(message, allowed)
        if not harms and handle is not None and handle not in opened and Harm.COMPUTING not in allowed:
            harms = {Harm.COMPUTING: _LEFT_HANDLE}
        if not harms:
            opened.learn(message, None if step.reply is None else step.reply.message)
        yield step, harms


class Replay:
    """What is sent of a capture. This is decided as it is sent, by the replies of this brick."""

    def __init__(self, allowed: frozenset[str]) -> None:
        """`allowed` may be sent besides reading."""
        self._policy = Policy(allowed)
        self._allowed = allowed
        self._now: dict[int, int] = {}  # recorded handles, and those that this brick gave for them

    def talk(self, step: Step) -> Talk:
        """Sends a recorded command if it may be sent, with the handle that its file has now."""
        message = step.command.message
        if message.type is None:
            # It cannot be sent with a new counter.
            return Outcome({Harm.UNKNOWN: "the frame"})
        recorded = handle_of(message)
        handle = None if recorded is None else self._now.get(recorded)
        if recorded is not None and handle is None and Harm.COMPUTING not in self._allowed:
            return Outcome(harms_of(message, self._allowed) or {Harm.COMPUTING: _LEFT_HANDLE})
        if handle is not None:
            frame = step.command.frame
            message = parse(frame[:_HANDLE_AT] + bytes((handle,)) + frame[_HANDLE_AT + 1 :], strict=False)
        outcome = yield from self._policy.talk(message)
        self._learn(step, outcome.reply)
        return outcome

    def leave(self) -> Talk:
        """Ends what is still open."""
        return self._policy.leave()

    def _learn(self, step: Step, reply: bytes | None) -> None:
        """Takes a reply: a file that this brick and the recorded one have opened may have another handle now."""
        if step.reply is None or step_of(step.command.message) != "begin":
            return
        recorded, now = handle_of(step.reply.message), parse(reply or b"", strict=False)
        if recorded is not None:
            self._now.pop(recorded, None)
            handle = None if is_error(now) else handle_of(now)
            if handle is not None:
                self._now[recorded] = handle


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
    return _of_values(step.reply.values, values_of(now, parse(frame, strict=False, dialect=dialect)))


def _of_values(recorded: Sequence[Value], values: Sequence[Value]) -> tuple[Likeness, str]:
    pairs = zip(recorded, values, strict=False)
    changed = [was for was, is_now in pairs if was.value != is_now.value and was.name != _HANDLE]
    more = f" and {len(changed) - _MOST_DIFFERENCES} more" if len(changed) > _MOST_DIFFERENCES else ""
    shown = ", ".join(f"{was.name}={value_text(was)}" for was in changed[:_MOST_DIFFERENCES])
    if values and len(values) == len(recorded) and all(map(_varies, changed)):
        # Handles, and memory that was not written to, may also differ.
        return Likeness.SAME, f"recorded: {shown}{more}" if shown else ""
    return Likeness.VALUES, f"recorded: {shown or 'other bytes'}{more}"


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
