"""Records paired as people think of them: a command with its reply, a command without one, a reply by itself."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from ev3proto.capture.conversation import MOST_PENDING
from ev3proto.capture.record import Event, Record


class Spoken(NamedTuple):
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


def dialogues(events: Iterable[Event], patience_ns: int | None = None) -> Iterator[Spoken]:
    """Commands with their replies, as they are complete; those that wait in vain come when nothing more does.

    patience_ns  nanoseconds after which a command is given without a reply, should it come after all, then with it;
                 None: without end

    At most MOST_PENDING commands wait at the same time; the oldest is then given without a reply.
    """
    waiting: OrderedDict[int, Record] = OrderedDict()
    for event in events:
        while patience_ns is not None and waiting:
            oldest = next(iter(waiting.values()))
            if event.time_ns - oldest.time_ns < patience_ns:
                break
            yield Spoken(waiting.popitem(last=False)[1], None)
        if not isinstance(event, Record):
            continue
        if event.request is not None:
            waiting.pop(id(event.request), None)
            yield Spoken(event.request, event)
        elif event.message.type is not None and not event.message.type.is_command:
            yield Spoken(None, event)
        elif not event.message.wants_reply:
            yield Spoken(event, None)
        else:
            waiting[id(event)] = event
            if len(waiting) > MOST_PENDING:
                yield Spoken(waiting.popitem(last=False)[1], None)
    for command in waiting.values():
        yield Spoken(command, None)
