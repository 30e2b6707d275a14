"""A connection that several objects share: it ends with the last of them."""

from __future__ import annotations

import threading

from ev3proto.link.channel import Channel


class Shared:
    """A channel, and who uses it.

    channel  the connection
    moving   held while a file is moved
    """

    def __init__(self, channel: Channel) -> None:
        """Takes a channel over."""
        self.channel = channel
        self.moving = threading.Lock()
        self._users = 0
        self._lock = threading.Lock()

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
