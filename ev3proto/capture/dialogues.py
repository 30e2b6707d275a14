"""Records paired as people think of them: a command with its reply, a command without one, a reply by itself."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from ev3proto.bounded import Bounded
from ev3proto.capture.conversation import MOST_PENDING
from ev3proto.capture.record import Event, Record
from ev3proto.messages import Message, SystemReply


class RequestReply(NamedTuple):
    """A command and its reply.

    command  None for a reply whose command was not seen
    reply    None for a command that wants none, or got none
    """

    command: Record | None
    reply: Record | None

    @property
    def last(self) -> Record:
        """The record with which it was complete."""
        record = self.reply or self.command
        assert record is not None
        return record


def is_error(message: Message) -> bool:
    """Whether a reply says that its command failed. END_OF_FILE is no failure: files end with it."""
    if isinstance(message, SystemReply):
        return message.is_error
    return message.type is not None and message.type.is_error


def dialogues(events: Iterable[Event], patience_ns: int | None = None) -> Iterator[RequestReply]:
    """Joins commands and their replies.

    At most MOST_PENDING commands wait at the same time; the oldest is then given without a reply.

    Args:
        events: The events of a capture.
        patience_ns: Nanoseconds after which a command is given without a reply. If that comes after all, the command is
            given again, with it. None waits until there are no more events.

    Yields:
        Commands with their replies, as they are complete; at the end those that waited in vain.
    """
    waiting: Bounded[int, Record] = Bounded(MOST_PENDING)
    for event in events:
        while patience_ns is not None and waiting:
            oldest = next(iter(waiting.values()))
            if event.time_ns - oldest.time_ns < patience_ns:
                break
            yield RequestReply(waiting.pop_oldest(), None)
        if not isinstance(event, Record):
            continue
        if event.request is not None:
            waiting.pop(id(event.request), None)
            yield RequestReply(event.request, event)
        elif event.message.type is not None and not event.message.type.is_command:
            yield RequestReply(None, event)
        elif not event.message.wants_reply:
            yield RequestReply(event, None)
        else:
            dropped = waiting.add(id(event), event)
            if dropped is not None:
                yield RequestReply(dropped, None)
    for command in waiting.values():
        yield RequestReply(command, None)
