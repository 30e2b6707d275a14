"""A connection that several objects share: it ends with the last of them."""

from __future__ import annotations

import threading
from collections.abc import Callable
from weakref import WeakKeyDictionary

from ev3proto.link.channel import Channel, Ticket
from ev3proto.link.commands import Prepared
from ev3proto.link.errors import LinkError


class Shared:
    """A channel, who uses it, and what was asked for with each command.

    channel  the connection
    moving   held while a file is moved
    """

    def __init__(self, channel: Channel) -> None:
        """Takes a channel over."""
        self.channel = channel
        self.moving = threading.Lock()
        self._users = 0
        self._lock = threading.Lock()
        self._prepared: WeakKeyDictionary[Ticket, Prepared] = WeakKeyDictionary()

    def take(self) -> None:
        """One more uses it."""
        with self._lock:
            self._users += 1

    def release(self) -> None:
        """One of them uses it no more; the last one closes it."""
        with self._lock:
            self._users -= 1
            if self._users:
                return
        self.channel.close()

    def send(self, prepared: Prepared, before: Callable[[bytes], None] | None) -> Ticket:
        """Sends a command. What was asked for is known as long as its ticket is.

        Args:
            prepared: The command.
            before: Called with the frame just before it is sent.
        """
        ticket = self.channel.send(prepared.kind, prepared.body, before=before)
        with self._lock:
            self._prepared[ticket] = prepared
        return ticket

    def prepared(self, ticket: Ticket) -> Prepared:
        """The command of a ticket. Raises LinkError where it was not sent here."""
        with self._lock:
            found = self._prepared.get(ticket)
        if found is None:
            raise LinkError(f"the command with the counter {ticket.request.counter} is not known here")
        return found
