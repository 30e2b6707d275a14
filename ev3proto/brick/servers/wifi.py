"""The brick's WiFi: the beacon, and the TCP port on which frames come after the unlock text."""

from __future__ import annotations

import asyncio
import ipaddress
import socket
from collections import deque
from collections.abc import Callable, Sequence
from typing import Protocol

from ev3proto.brick.limits import MOST_QUEUED, MOST_UNREAD, UNLOCK_TIME
from ev3proto.brick.servers.host import Ends, Line, ServerError
from ev3proto.brick.servers.listening import listen
from ev3proto.brick.servers.unlocking import BEACON_PERIOD, FIRST_READ, Unlocking, beacon_socket, why_not_open
from ev3proto.errors import BuildError
from ev3proto.schema.discovery import Beacon
from ev3proto.tables.discovery import ACCEPT, BEACON_PORT


class Session(Protocol):
    """A client of the port's owner, once its unlock text is answered."""

    def feed(self, data: bytes) -> None:
        """Takes bytes from the client."""

    def throttle(self, is_throttled: bool) -> None:
        """Learns whether the client leaves too many bytes unread."""

    def close(self) -> None:
        """Learns that the client has disconnected."""


class Owner(Protocol):
    """The server of the clients: a virtual brick's `Host`, or the proxy."""

    def open(self, line: Line, name: str, carrier: str, ends: Ends, opening: Sequence[tuple[bytes, bool]]) -> Session:
        """Begins to serve a client."""

    def queued(self) -> None:
        """Learns that a client waits until another one disconnects."""

    @property
    def say_once(self) -> Callable[[str], None]:
        """Reports a message to the user of the server."""


class Wifi:
    """The TCP port, and the beacon if there is one."""

    def __init__(self, host: Owner, clients: int = 1, only_from: str | None = None) -> None:
        """Does not open the port yet; `only_from` is the address that clients must have."""
        self.address = ""  # where it listens
        self.port = 0
        self._host = host
        self._clients = clients
        self._only_from = only_from
        self._locked: dict[_Client, None] = {}
        self._queued: deque[_Client] = deque()
        self._served: set[_Client] = set()
        self._servers: list[asyncio.Server] = []
        self._beacon: asyncio.Task[None] | None = None

    async def listen(self, address: str, port: int) -> None:
        """Opens the port, 0 for any that is free. Raises ServerError."""
        try:
            self._servers = await listen(lambda: _Client(self, self._host), address, port)
        except (OSError, OverflowError, UnicodeError) as error:
            raise ServerError(why_not_open(error, address, port)) from None
        self.address, self.port = self._servers[0].sockets[0].getsockname()[:2]

    def announce(self, beacon: Callable[[], Beacon], port: int = BEACON_PORT) -> None:
        """Begins to send beacons to a UDP port; `beacon` is called for each."""
        self._beacon = asyncio.create_task(self._announce(beacon, port))

    @property
    def has_waiting(self) -> bool:
        """Whether a client waits until another one disconnects."""
        return bool(self._queued)

    async def close(self) -> None:
        """Closes the port and all connections."""
        if self._beacon is not None:
            self._beacon.cancel()
        for server in self._servers:
            server.close()
        clients = [*self._served, *self._queued, *self._locked]
        self._locked.clear()
        self._queued.clear()
        for client in clients:
            client.drop()

    # Clients

    def connected(self, client: _Client) -> None:
        """Takes a connected client, which does not keep others waiting until it sends the unlock text."""
        if self._only_from not in (None, client.address):
            self._host.say_once(f"{client.address} was disconnected: only {self._only_from} is served (--from)")
            client.drop()
            return
        self._locked[client] = None
        if len(self._locked) > MOST_QUEUED:
            next(iter(self._locked)).drop()

    def unlocked(self, client: _Client) -> None:
        """Serves a client that has sent the unlock text, queues it, or disconnects it."""
        self._locked.pop(client, None)
        if len(self._queued) >= MOST_QUEUED:
            client.drop()
            return
        self._queued.append(client)
        self._serve_next()
        if client in self._queued:
            self._host.queued()

    def disconnected(self, client: _Client) -> None:
        """Forgets a client that has disconnected, and serves the next one."""
        if self._locked.pop(client, client) is None:
            self._host.say_once(f"{client.address} did not send the unlock text of a WiFi brick; disconnected")
        if client in self._queued:
            self._queued.remove(client)
        self._served.discard(client)
        self._serve_next()

    def _serve_next(self) -> None:
        while self._queued and len(self._served) < self._clients:
            client = self._queued.popleft()
            self._served.add(client)
            client.accept()

    # The beacon

    async def _announce(self, beacon: Callable[[], Beacon], port: int) -> None:
        if ipaddress.ip_address(self.address).version != 4:
            self._host.say_once("no beacon is sent: beacons use IPv4, and this is an IPv6 address")
            return
        sender, target = beacon_socket(self.address, self.port)
        with sender:
            while True:
                try:
                    sender.sendto(beacon().build(), (target, port))
                except OSError as error:
                    self._host.say_once(f"the beacon cannot be sent: {error.strerror or error}")
                except BuildError as error:
                    self._host.say_once(f"the beacon cannot be sent: {error}")
                await asyncio.sleep(BEACON_PERIOD)


class _Client(asyncio.Protocol):
    """One TCP connection, from the unlock text to its end."""

    _transport: asyncio.Transport  # from when it is connected
    _timer: asyncio.TimerHandle

    def __init__(self, wifi: Wifi, host: Owner) -> None:
        self._wifi = wifi
        self._host = host
        self._connection: Session | None = None
        self._unlocking = Unlocking()
        self._rest: bytes | None = None

    # Callbacks of asyncio

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self._transport = transport
        # A client that vanished must not keep its place for ever.
        transport.get_extra_info("socket").setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
        transport.set_write_buffer_limits(MOST_UNREAD)
        self._timer = asyncio.get_running_loop().call_later(UNLOCK_TIME, self.drop)
        self._wifi.connected(self)

    def data_received(self, data: bytes) -> None:
        if self._connection is not None:
            self._connection.feed(data)
        elif self._rest is None:
            self._unlock(data)
        else:
            self._rest += data

    def pause_writing(self) -> None:
        if self._connection is not None:
            self._connection.throttle(True)

    def resume_writing(self) -> None:
        if self._connection is not None:
            self._connection.throttle(False)

    def connection_lost(self, exc: Exception | None) -> None:  # noqa: ARG002 - the reason does not matter
        self._timer.cancel()
        connection, self._connection = self._connection, None
        try:
            if connection is not None:
                connection.close()
        finally:
            self._wifi.disconnected(self)

    # Called by the port

    @property
    def address(self) -> str:
        """The client's IP address."""
        return str(self._transport.get_extra_info("peername")[0])

    def accept(self) -> None:
        """Answers the unlock text: its turn has come."""
        assert self._rest is not None
        host, port = self._transport.get_extra_info("peername")[:2]
        ends = (host, port), self._transport.get_extra_info("sockname")[:2]
        opening = (self._unlocking.said, True), (ACCEPT, False)
        self._connection = self._host.open(self, f"{host}:{port}", "wifi", ends, opening)
        # No zero follows, unlike in some firmware: clients that read 16 bytes would find it before their first reply.
        self._transport.write(ACCEPT)
        self.resume()
        if self._rest:
            self._connection.feed(self._rest)

    def drop(self) -> None:
        """Ends the connection at once."""
        self._transport.abort()

    def _unlock(self, data: bytes) -> None:
        rest = self._unlocking.feed(data)
        if rest is None:
            return
        self._timer.cancel()
        self._rest = rest
        self.pause()
        self._wifi.unlocked(self)
        if self._unlocking.extra:
            self._host.say_once(
                f"what a client sends right after the unlock text is lost with it, within {FIRST_READ} bytes,"
                " as on the real brick: wait for its answer"
            )

    # Called by the connection

    def send(self, data: bytes) -> None:
        if not self._transport.is_closing():
            self._transport.write(data)

    def pause(self) -> None:
        self._transport.pause_reading()

    def resume(self) -> None:
        if not self._transport.is_closing():
            self._transport.resume_reading()
