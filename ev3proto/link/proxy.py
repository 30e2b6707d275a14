"""The proxy: looks like a WiFi brick to any program, forwards everything to another brick, and returns its replies.

Clients connect to the port of a virtual brick (`ev3proto.brick.servers.wifi`); one is served at a time, others wait.
With `is_read_only`, many are served in turn. `relays` has what passes. One thread reads from the brick; everything
else runs in one event loop.
"""

from __future__ import annotations

import asyncio
import contextlib
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial

from ev3proto.brick.servers.host import Ends, Faults, Line, ServerError
from ev3proto.brick.servers.wifi import Wifi
from ev3proto.capture.dialogues import RequestReply
from ev3proto.generate.captures.recording import Recording
from ev3proto.link.carriers import Wire
from ev3proto.link.errors import ConnectionLostError, LinkError, PortInUseError
from ev3proto.link.masking import Counters, masked, masked_note, masked_opening
from ev3proto.link.records import Records
from ev3proto.link.relays import Client, Guard, Passing, Sent
from ev3proto.messages import Message
from ev3proto.schema.discovery import Beacon
from ev3proto.semantics.advice import advice
from ev3proto.semantics.identify import foreign, identify
from ev3proto.stream import Decoder, StreamError
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.discovery import BEACON_PORT

_HIDDEN_HOST, _HIDDEN_PROXY = "192.0.2.1", "192.0.2.10"
"""The ends of a connection in recordings without addresses."""

MOST_CLIENTS = 32
"""Clients of `is_read_only` that are served in turn; others wait."""

SILENCE = 8.0
"""Seconds after which a client with half a frame is disconnected, if there are others; see `Proxy.queued`."""

_TURN, _LOOK = 0.1, 1.0
"""Seconds for which the brick is read, and between two looks for silent clients."""

_MOST_ENDING, _ENDING = 2.0, 0.01
"""Seconds in which open files and listings are ended when the proxy ends, and between two looks."""


@dataclass(frozen=True)
class ProxyOptions:
    """The options of a proxy."""

    address: str = "127.0.0.1"  # of this computer, where clients connect
    port: int = 0  # 0 for any that is free
    only_from: str | None = None  # the address that clients must have; None for any
    is_read_only: bool = False  # only commands that read go through
    is_masked: bool = False  # names, addresses and PINs are masked in the recording and in all output
    faults: Faults = field(default_factory=Faults)  # the deliberate faults of replies
    dialect: str = "official"  # the firmware's instruction set
    announced: str | None = None  # serial number in the UDP beacon, by which programs find the proxy; None: no beacon
    beacon_port: int = BEACON_PORT  # the UDP port that the beacon goes to


Shown = Callable[[RequestReply], None]
"""Receives each command with its reply, or without one if it wants none."""

Say = Callable[[str], None]
"""Receives messages for the user of the proxy."""


class Proxy:
    """A proxy between clients and a brick."""

    def __init__(
        self,
        wire: Wire,
        peer: str,
        options: ProxyOptions,
        *,
        show: Shown,
        say: Say,
        recording: Recording | None = None,
        reopen: Callable[[], Wire] | None = None,
    ) -> None:
        """Opens the port. Raises PortInUseError.

        `reopen` connects to the brick again, which `is_read_only` needs where a reply is lost.
        """
        self.lost: ConnectionLostError | None = None  # why the connection to the brick is lost; None while it is open
        packets = None if recording is None else lambda: recording.packets
        if options.is_masked:
            peer = "brick"
        self.records = Records(wire.carrier, peer, options.dialect, packets)
        self.say_once: Say = (lambda note: say(masked_note(note))) if options.is_masked else say
        self._options = options
        self._wire = self._labelled(wire)
        self._reopen = reopen
        self._is_reading, self._is_renewed = True, False
        self._counters = Counters()
        self._relay: Guard | Passing = Guard(self) if options.is_read_only else Passing(self)
        self._show = show
        self._recording = recording
        self.clients: list[Client] = []  # those that are served
        self._error: BaseException | None = None
        self._is_over = asyncio.Event()
        self._loop = asyncio.new_event_loop()
        self._wifi = Wifi(self, MOST_CLIENTS if options.is_read_only else 1, options.only_from)
        try:
            self._loop.run_until_complete(self._wifi.listen(options.address, options.port))
        except ServerError as error:
            self._loop.close()
            raise PortInUseError(str(error)) from None
        self.port: int = self._wifi.port  # where it listens

    def serve(self) -> None:
        """Serves clients until `stop` is called or the brick is gone. Raises what `show` raises."""
        reader = threading.Thread(target=self._read, name="reads from the brick", daemon=True)
        reader.start()
        try:
            self._loop.run_until_complete(self._serve())
        finally:
            self._is_reading = False
            self._wire.stop()
            reader.join()
            self._wire.close()
            self._loop.close()
        if self._error is not None:
            raise self._error

    def stop(self) -> None:
        """Ends everything; may be called from another thread, or when a signal comes."""
        with contextlib.suppress(RuntimeError):  # it has ended already
            self._loop.call_soon_threadsafe(self._is_over.set)

    async def _serve(self) -> None:
        serial_number = self._options.announced
        if serial_number is not None:
            self._wifi.announce(lambda: Beacon(serial_number, str(self.port)), self._options.beacon_port)
        while not self._is_over.is_set():
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(self._is_over.wait(), _LOOK)
            self.queued()
        await self._wifi.close()
        for client in list(self.clients):
            self.gone(client)
        ending = self._loop.time() + _MOST_ENDING
        while not self._relay.is_idle and self.lost is None and self._loop.time() < ending:
            await asyncio.sleep(_ENDING)

    def act(self, call: Callable[[], None]) -> None:
        """Makes a call in the event loop; an error ends the proxy."""
        try:
            call()
        except ConnectionLostError as error:
            if not self._is_over.is_set():
                self.lost = error
            self.stop()
        except BaseException as error:
            self._error = self._error or error
            self.stop()

    # Clients

    def open(self, line: Line, name: str, carrier: str, ends: Ends, opening: Sequence[tuple[bytes, bool]]) -> _Session:
        """Begins to serve a client, and records the beginning of its connection."""
        client = Client(line, name, Decoder(strict=False, dialect=self._options.dialect), self.now())
        self.clients.append(client)
        host, proxy = ends
        if self._options.is_masked:
            opening = [(masked_opening(text), is_host) for text, is_host in opening]
            host, proxy = (_HIDDEN_HOST, host[1]), (_HIDDEN_PROXY, proxy[1])

        def record(recording: Recording) -> None:
            recording.opened(client, Carrier(carrier), host, proxy)
            for text, is_from_host in opening:
                recording.data(client, text, is_from_host)

        self._record(record)
        return _Session(self, client)

    def queued(self) -> None:
        """Ends the client that was silent for longest: with half a frame, or in the place of one that waits."""
        waits, latest = self._wifi.has_waiting, self.now() - SILENCE
        if not waits and len(self.clients) == 1:
            return
        gives_way = waits and self._options.is_read_only
        silent = [
            each
            for each in self.clients
            if each.heard <= latest and not each.waiting and (gives_way or each.decoder.pending)
        ]
        if silent:
            client = min(silent, key=lambda each: each.heard)
            self.say_once(f"{client.name} was disconnected: it sent no whole frame for {SILENCE:g} s, and others wait")
            client.line.drop()

    def forward(self, client: Client, data: bytes) -> None:
        """Forwards what a client sends; bytes that are not frames end its connection."""
        if not client.decoder.pending:
            client.heard = self.now()
        # As it was sent, in part of a frame or several; names and PINs are found in whole frames only.
        if not self._options.is_masked:
            self._record(lambda recording: recording.data(client, data, True))
        try:
            for message in client.decoder.feed(data):
                self._take_up(client, message)
        except StreamError as error:
            client.line.drop()
            said = None if self._options.is_masked else advice(foreign(client.decoder.pending))
            self._end(client, said or str(error))

    def gone(self, client: Client) -> None:
        """Ends the dialogue with a client that has disconnected."""
        if client in self.clients:
            left = client.decoder.pending
            fault = client.decoder.close() if left else None
            said = None if self._options.is_masked else advice(identify(left))
            self._end(client, None if fault is None else said or fault.reason)

    def _end(self, client: Client, reason: str | None) -> None:
        self.clients.remove(client)
        if reason is not None:
            self.say_once(f"{client.name} sent bytes that are not a frame: {reason}; disconnected")
        left = client.decoder.pending
        if left and self._options.is_masked:
            self._record(lambda recording: recording.data(client, self._masked(left), True))
        self._record(lambda recording: recording.closed(client))
        self._relay.gone(client)

    def _masked(self, frame: bytes, request: bytes | None = None) -> bytes:
        return masked(frame, request, self._options.dialect) if self._options.is_masked else frame

    def _take_up(self, client: Client, message: Message) -> None:
        client.heard = self.now()
        frame = message.build()
        self._counters.sent(frame)
        shown = self._masked(frame)
        if self._options.is_masked:
            self._record(lambda recording: recording.data(client, shown, True))
        elif (said := advice(foreign(frame))) is not None:
            self.say_once(f"{client.name}: {said}")
        self._relay.forward(Sent(client, message, self.records.sent(shown), frame))

    # The brick

    def _read(self) -> None:
        try:
            while self._is_reading:
                if self._is_renewed:
                    self._reconnect()
                data = self._wire.receive(_TURN)
                if data:
                    self._loop.call_soon_threadsafe(self.act, partial(self._relay.heard, data))
        except ConnectionLostError as error:
            self._loop.call_soon_threadsafe(self.act, partial(_raise, error))

    def _reconnect(self) -> None:
        self._is_renewed = False
        assert self._reopen is not None
        self._wire.close()
        try:
            self._wire = self._labelled(self._reopen())
        except LinkError as error:
            raise ConnectionLostError(str(error)) from None
        self._loop.call_soon_threadsafe(self.act, self._relay.renewed)

    def _labelled(self, wire: Wire) -> Wire:
        if self._options.is_masked:
            wire.label = "the brick"
        return wire

    # For the relay

    @property
    def carrier(self) -> Carrier:
        """What carries frames to the brick."""
        return self._wire.carrier

    def send(self, frame: bytes) -> None:
        """Sends a frame to the brick. Raises ConnectionLostError."""
        self._wire.send(frame)

    def renew(self) -> None:
        """Makes the connection to the brick anew. Raises ConnectionLostError."""
        if self._reopen is None:
            raise ConnectionLostError(f"{self._wire.label} does not answer")
        self._is_renewed = True

    def later(self, seconds: float, call: Callable[[], None]) -> Callable[[], None]:
        """Calls a function after a time. Returns a function that cancels it."""
        return self._loop.call_later(seconds, self.act, call).cancel

    def now(self) -> float:
        """Returns the time in seconds."""
        return self._loop.time()

    def unanswered(self, sent: Sent) -> None:
        """Shows a command that has no reply."""
        self._show(RequestReply(sent.command, None))

    def answer(self, sent: Sent | None, client: Client, frame: bytes, note: str | None = None) -> None:
        """Sends a reply to a client, shows and records it, with a note on the pairing."""
        faults = self._options.faults
        command, client.heard = None if sent is None else sent.command, self.now()
        reply = faults.apply_to(frame)
        if reply is None:
            self.say_once("a reply was dropped (--drop)")
            if command is not None:
                self._show(RequestReply(command, None))
            return
        request = sent.frame if sent is not None and self._counters.is_sure(reply) else None
        shown = self._masked(reply, request)
        self._record(lambda recording: recording.data(client, shown, False))
        self._show(RequestReply(command, self.records.received(shown, command, note)))
        if faults.delay:
            self._loop.call_later(faults.delay, client.line.send, reply)
        else:
            client.line.send(reply)

    def _record(self, write: Callable[[Recording], None]) -> None:
        if self._recording is None:
            return
        try:
            write(self._recording)
        except OSError as error:
            self._recording = None
            self.say_once(f"recording ended: {error.strerror or error}")


class _Session:
    """A client, as the port sees it."""

    def __init__(self, proxy: Proxy, client: Client) -> None:
        self._proxy = proxy
        self._client = client

    def feed(self, data: bytes) -> None:
        """Takes bytes from the client."""
        self._proxy.act(lambda: self._proxy.forward(self._client, data))

    def throttle(self, is_throttled: bool) -> None:
        """Reads from the client only while it reads its replies."""
        self._client.hold("it reads nothing", is_throttled)

    def close(self) -> None:
        """Learns that the client has disconnected."""
        self._proxy.act(lambda: self._proxy.gone(self._client))


def _raise(error: Exception) -> None:
    raise error
