"""A TCP port whose clients cannot use up the file descriptors of this process.

One descriptor is kept in reserve, to accept and disconnect further clients. asyncio's own servers log errors repeatedly
for each client that they cannot accept.
"""

from __future__ import annotations

import asyncio
import contextlib
import errno
import os
import socket
from collections.abc import Callable

_BACKLOG = 128
_PAUSE = 0.1
"""Seconds until a client is accepted again after an error."""

_EXHAUSTED = (errno.EMFILE, errno.ENFILE, errno.ENOBUFS, errno.ENOMEM)


class Listener:
    """A port that accepts clients."""

    def __init__(self, client: Callable[[], asyncio.BaseProtocol], full: Callable[[], None]) -> None:
        """Does not open the port yet; `full` is called when a client was refused for lack of descriptors."""
        self.address = ""  # where it listens
        self.port = 0
        self._client = client
        self._full = full
        self._sockets: list[socket.socket] = []
        self._tasks: list[asyncio.Task[None]] = []
        self._reserve: int | None = None

    async def open(self, address: str, port: int) -> None:
        """Opens a port, 0 for any that is free. Raises OSError, OverflowError and UnicodeError."""
        loop = asyncio.get_running_loop()
        for family, _, _, _, place in await loop.getaddrinfo(address, port, type=socket.SOCK_STREAM):
            listening = socket.create_server(place[:2], family=family, backlog=_BACKLOG)
            listening.setblocking(False)
            self._sockets.append(listening)
            self._tasks.append(asyncio.create_task(self._accept_all(listening)))
        self.address, self.port = self._sockets[0].getsockname()[:2]
        self._keep_reserve()

    def close(self) -> None:
        """Closes the port; clients stay connected."""
        for task in self._tasks:
            task.cancel()
        for listening in self._sockets:
            listening.close()
        self._release_reserve()

    async def _accept_all(self, listening: socket.socket) -> None:
        loop = asyncio.get_running_loop()
        while True:
            try:
                accepted, _ = await loop.sock_accept(listening)
                if self._reserve is None and not self._keep_reserve():
                    accepted.close()
                    self._keep_reserve()
                    self._full()
                else:
                    await loop.connect_accepted_socket(self._client, accepted)
            except OSError as error:
                # Without a free descriptor, accept does not wait for a client.
                if error.errno not in _EXHAUSTED or not self._release_reserve():
                    await asyncio.sleep(_PAUSE)

    def _keep_reserve(self) -> bool:
        with contextlib.suppress(OSError):
            self._reserve = os.open(os.devnull, os.O_RDONLY)
        return self._reserve is not None

    def _release_reserve(self) -> bool:
        reserve, self._reserve = self._reserve, None
        if reserve is not None:
            os.close(reserve)
        return reserve is not None
