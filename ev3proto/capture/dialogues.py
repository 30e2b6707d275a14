"""Dialogues of a capture: a command with its reply, a command without one, a reply by itself."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from ev3proto.bounded import Bounded
from ev3proto.capture.conversation import MOST_PENDING
from ev3proto.capture.record import Event, Record
from ev3proto.messages import Message, SystemReply


class RequestReply(NamedTuple):
    """A command and its reply."""

    command: Record | None  # None for a reply whose command was not captured
    reply: Record | None  # None for a command that requests or gets none

    @property
    def last(self) -> Record:
        """The record that completed it."""
        record = self.reply or self.command
        assert record is not None
        return record


def is_error(message: Message) -> bool:
    """Returns whether a reply reports a failure. END_OF_FILE is not a failure: uploads end with it."""
    if isinstance(message, SystemReply):
        return message.is_error
    return message.type is not None and message.type.is_error


def dialogues(events: Iterable[Event], patience_ns: int | None = None) -> Iterator[RequestReply]:
    """Yields commands with their replies when they are complete; at the end unanswered commands.

    A command is yielded without its reply after `patience_ns`, and again with it if it comes later. So is the oldest
    of more than MOST_PENDING.
    """
    waiting: Bounded[int, Record] = Bounded(MOST_PENDING)
    for event in events:
        if patience_ns is not None:
            yield from _given_up(waiting, event.time_ns - patience_ns)
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


def _given_up(waiting: Bounded[int, Record], last_ns: int) -> Iterator[RequestReply]:
    """Yields the commands that have waited for their replies since a time, or for longer."""
    while waiting and next(iter(waiting.values())).time_ns <= last_ns:
        yield RequestReply(waiting.pop_oldest(), None)
