"""The proxy: a WiFi brick for any program, which forwards everything to another brick, and the replies back.

Clients connect to the port of the virtual brick (`ev3proto.brick.servers.wifi`), one is served at a time, and others
wait. Frames go through as they are, counters included. One thread reads from the brick, all else is one event loop.
"""

from __future__ import annotations

import asyncio
import contextlib
import re
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial

from ev3proto.brick.servers.faults import Faults
from ev3proto.brick.servers.host import Ends, Line, ServerError
from ev3proto.brick.servers.wifi import Wifi
from ev3proto.capture.dialogues import RequestReply
from ev3proto.capture.record import Record
from ev3proto.dialogue import Pairing
from ev3proto.generate.captures.recording import Recording
from ev3proto.link.carriers import Wire
from ev3proto.link.errors import ConnectionLostError, PortInUseError
from ev3proto.link.harm import harms_of
from ev3proto.link.masking import masked
from ev3proto.link.records import Records
from ev3proto.link.reply_stream import Garbage, ReplyStream
from ev3proto.link.session import pairing_key
from ev3proto.messages import Message, SystemCommand
from ev3proto.schema.discovery import Beacon
from ev3proto.schema.header import build_frame
from ev3proto.stream import Decoder, StreamError
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.discovery import BEACON_PORT
from ev3proto.tables.frame import MAX_FRAME, MessageType
from ev3proto.tables.system import SystemStatus

_CLIENT = "client"
"""The name of the one client in a recording."""

_HIDDEN_HOST, _HIDDEN_PROXY = "192.0.2.1", "192.0.2.10"
_SERIAL = re.compile(rb"(?<=sn=)\w+")

_TURN = 0.1
_MOST_WAITING = 1024


@dataclass(frozen=True)
class ProxyOptions:
    """The options of a proxy.

    address       of this computer, where clients connect
    port          0 for any that is free
    only_from     the address that clients must have; None for any
    is_read_only  nothing goes through that changes the brick
    is_masked     names, addresses and PINs are kept out of the recording and of what is shown
    faults        what happens to replies
    dialect       the firmware's instruction set
    announced     serial number in the UDP beacon, by which programs find the proxy; None: no beacon
    beacon_port   the UDP port that the beacon goes to
    """

    address: str = "127.0.0.1"
    port: int = 0
    only_from: str | None = None
    is_read_only: bool = False
    is_masked: bool = False
    faults: Faults = field(default_factory=Faults)
    dialect: str = "official"
    announced: str | None = None
    beacon_port: int = BEACON_PORT


Shown = Callable[[RequestReply], None]
"""Receives each command with its reply, or without one where it wants none."""

Say = Callable[[str], None]
"""Receives messages for the user of the proxy."""


class Proxy:
    """A proxy between clients and a brick.

    port  where it listens
    lost  why the connection to the brick is gone; None while it is there
    """

    def __init__(
        self,
        wire: Wire,
        peer: str,
        options: ProxyOptions,
        *,
        show: Shown,
        say: Say,
        recording: Recording | None = None,
    ) -> None:
        """Opens the port.

        Args:
            wire: The brick.
            peer: The brick's name in the output.
            options: The options.
            show: Receives each command with its reply.
            say: Receives messages for the user.
            recording: Receives all frames, too.

        Raises:
            PortInUseError: The port cannot be opened.
        """
        self.lost: ConnectionLostError | None = None
        packets = None if recording is None else lambda: recording.packets
        self.records = Records(wire.carrier, peer, options.dialect, packets)
        self.say_once = say
        self._wire = wire
        self._options = options
        self._show = show
        self._recording = recording
        self._client: _Client | None = None
        self._error: BaseException | None = None
        self._is_over = asyncio.Event()
        self._loop = asyncio.new_event_loop()
        self._wifi = Wifi(self, only_from=options.only_from)
        try:
            self._loop.run_until_complete(self._wifi.listen(options.address, options.port))
        except ServerError as error:
            self._loop.close()
            raise PortInUseError(str(error)) from None
        self.port: int = self._wifi.port

    def serve(self) -> None:
        """Serves clients until `stop` is called or the brick is gone. Raises what `show` raises."""
        reader = threading.Thread(target=self._read, name="reads from the brick", daemon=True)
        reader.start()
        try:
            self._loop.run_until_complete(self._serve())
        finally:
            self._is_over.set()
            self._wire.stop()
            reader.join()
            self._loop.close()
        if self._error is not None:
            raise self._error

    def stop(self) -> None:
        """Ends everything; may be called from another thread, or when a signal comes."""
        with contextlib.suppress(RuntimeError):  # it has ended already
            self._loop.call_soon_threadsafe(self._is_over.set)
        self._wire.stop()

    async def _serve(self) -> None:
        serial_number = self._options.announced
        if serial_number is not None:
            self._wifi.announce(lambda: Beacon(serial_number, str(self.port)), self._options.beacon_port)
        await self._is_over.wait()
        await self._wifi.close()
        if self._client is not None:
            self._client.close()

    def act(self, call: Callable[[], None]) -> None:
        """Does something in the event loop; an error ends the proxy."""
        try:
            call()
        except ConnectionLostError as error:
            if not self._is_over.is_set():
                self.lost = error
            self.stop()
        except BaseException as error:
            self._error = self._error or error
            self.stop()

    # The client

    def open(self, line: Line, name: str, carrier: str, ends: Ends, opening: Sequence[tuple[bytes, bool]]) -> _Client:
        """Begins to serve a client. Records the beginning of its connection, without what is masked."""
        self._client = _Client(self, line, name, Decoder(strict=False, dialect=self._options.dialect))
        host, proxy = ends
        if self._options.is_masked:
            opening = [(_SERIAL.sub(lambda found: b"0" * len(found[0]), text), is_host) for text, is_host in opening]
            host, proxy = (_HIDDEN_HOST, host[1]), (_HIDDEN_PROXY, proxy[1])
        self._record(lambda recording: recording.opened(_CLIENT, Carrier(carrier), host, proxy))
        for text, is_from_host in opening:
            self._record(partial(_record_text, text, is_from_host))
        return self._client

    def queued(self) -> None:
        """Does nothing: the waiting client notices it by itself."""

    def forward(self, client: _Client, data: bytes) -> None:
        """Forwards what a client sends; bytes that are not frames end its connection."""
        try:
            for message in client.decoder.feed(data):
                self._to_brick(client, message)
        except StreamError as error:
            client.line.drop()
            self._end(client, str(error))

    def gone(self, client: _Client) -> None:
        """Ends the dialogue with a client that has disconnected."""
        if client is self._client:
            left = client.decoder.pending
            fault = client.decoder.close() if left else None
            self._end(client, None if fault is None else fault.reason)

    def _end(self, client: _Client, reason: str | None) -> None:
        self._client = None
        if reason is not None:
            self.say_once(f"{client.name} sent bytes that are not a frame: {reason}; disconnected")
        if left := client.decoder.pending:
            self._record(lambda recording: recording.data(_CLIENT, self._masked(left), True))
        for command in client.pairing.unanswered:
            self._show(RequestReply(command, None))
        self._record(lambda recording: recording.closed(_CLIENT))

    def _masked(self, frame: bytes, request: bytes | None = None) -> bytes:
        return masked(frame, request, self._options.dialect) if self._options.is_masked else frame

    def _to_brick(self, client: _Client, message: Message) -> None:
        frame = message.build()
        status = self._refusal(message, frame)
        shown = self._masked(frame)
        self._record(lambda recording: recording.data(_CLIENT, shown, True))
        command = self.records.sent(shown)
        if not message.wants_reply:
            self._show(RequestReply(command, None))
        elif (forgotten := client.pairing.remember(pairing_key(frame), 0, command)) is not None:
            self._show(RequestReply(forgotten, None))
        if status is None:
            self._wire.send(frame)
        elif message.wants_reply and isinstance(message, SystemCommand):
            reply = build_frame(MessageType.SYSTEM_REPLY_ERROR, message.counter, bytes((message.number, status)))
            self._to_client(reply)
        elif message.wants_reply:
            self._to_client(build_frame(MessageType.DIRECT_REPLY_ERROR, message.counter, b""))

    def _refusal(self, message: Message, frame: bytes) -> SystemStatus | None:
        """Says why a command does not go to the brick. Returns what a system command is told; None for others."""
        if self._options.is_read_only and (harms := harms_of(message, dialect=self._options.dialect)):
            reasons = ", ".join(f"{name} {harm.text}" for harm, name in harms.items())
            self.say_once(f"blocked by --read-only: {reasons}")
            return SystemStatus.NO_PERMISSION
        if len(frame) > MAX_FRAME and self._wire.carrier is Carrier.USB:
            self.say_once(
                f"a frame of {len(frame)} bytes was not sent: on USB a frame has at most {MAX_FRAME} bytes; send the"
                " file in pieces"
            )
            return SystemStatus.SIZE_ERROR
        return None

    # The brick

    def _read(self) -> None:
        """Reads from the brick, in a thread of its own."""
        stream = ReplyStream(lambda _counter: True)
        try:
            while not self._is_over.is_set():
                for part in stream.feed(self._wire.receive(_TURN)):
                    self._loop.call_soon_threadsafe(self.act, partial(self._take, part))
        except ConnectionLostError as error:
            self._loop.call_soon_threadsafe(self.act, partial(_raise, error))

    def _take(self, part: bytes | Garbage) -> None:
        if isinstance(part, Garbage):
            self.say_once(f"the brick sent {len(part.data)} bytes that are not a frame; they were dropped")
        else:
            self._to_client(part)

    def _to_client(self, frame: bytes) -> None:
        faults, client = self._options.faults, self._client
        request = None if client is None else client.pairing.answered(pairing_key(frame), None)
        sent = faults.apply_to(frame)
        if sent is None:
            self.say_once("a reply was dropped (--drop)")
            if request is not None:
                self._show(RequestReply(request, None))
            return
        shown = self._masked(sent, None if request is None else request.frame)
        self._record(lambda recording: recording.data(_CLIENT, shown, False))
        self._show(RequestReply(request, self.records.received(shown, request)))
        if client is not None and faults.delay:
            self._loop.call_later(faults.delay, client.line.send, sent)
        elif client is not None:
            client.line.send(sent)

    def _record(self, write: Callable[[Recording], None]) -> None:
        if self._recording is None:
            return
        try:
            write(self._recording)
        except OSError as error:
            self._recording = None
            self.say_once(f"recording ended: {error.strerror or error}")


class _Client:
    """The client that is served.

    line     its connection
    name     its address and port
    decoder  what it sent
    pairing  its commands without a reply yet
    """

    def __init__(self, proxy: Proxy, line: Line, name: str, decoder: Decoder) -> None:
        self.line = line
        self.name = name
        self.decoder = decoder
        self.pairing: Pairing[Record] = Pairing(_MOST_WAITING)
        self._proxy = proxy

    def feed(self, data: bytes) -> None:
        """Takes bytes from the client."""
        self._proxy.act(lambda: self._proxy.forward(self, data))

    def throttle(self, is_throttled: bool) -> None:
        """Reads from the client only while it reads its replies."""
        (self.line.pause if is_throttled else self.line.resume)()

    def close(self) -> None:
        """Ends, as the client has disconnected."""
        self._proxy.act(lambda: self._proxy.gone(self))


def _record_text(text: bytes, is_from_host: bool, recording: Recording) -> None:
    recording.data(_CLIENT, text, is_from_host)


def _raise(error: Exception) -> None:
    raise error
