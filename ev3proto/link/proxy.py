"""The proxy: looks like a WiFi brick to any program, forwards everything to another brick, and returns its replies.

Clients connect to the port of a virtual brick (`ev3proto.brick.servers.wifi`); one is served at a time, others wait.
Frames pass unchanged, counters included. One thread reads from the brick; everything else runs in one event loop.
"""

from __future__ import annotations

import asyncio
import contextlib
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import TypeGuard

from ev3proto.brick.servers.faults import Faults
from ev3proto.brick.servers.host import Ends, Line, ServerError
from ev3proto.brick.servers.wifi import Wifi
from ev3proto.capture.dialogues import RequestReply
from ev3proto.capture.record import Record
from ev3proto.generate.captures.recording import Recording
from ev3proto.link.carriers import Wire
from ev3proto.link.errors import ConnectionLostError, PortInUseError
from ev3proto.link.harm import Harm, harms_of
from ev3proto.link.masking import masked, masked_note, masked_opening
from ev3proto.link.open_handles import OpenHandles
from ev3proto.link.records import Records
from ev3proto.link.refusals import refused
from ev3proto.link.reply_stream import ReplyStream
from ev3proto.messages import Message, SystemCommand
from ev3proto.schema.discovery import Beacon
from ev3proto.schema.frame import parse
from ev3proto.schema.frame_buffer import OutOfStep
from ev3proto.semantics.pairing import Pairing, pairing_key
from ev3proto.stream import Decoder, StreamError
from ev3proto.system import close_filehandle
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.discovery import BEACON_PORT
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.tables.system import SYSTEM_BY_NUMBER, SystemStatus

_CLIENT = "client"
"""The name of the one client in a recording."""

_HIDDEN_HOST, _HIDDEN_PROXY = "192.0.2.1", "192.0.2.10"
"""The ends of a connection in recordings without addresses."""

_TURN = 0.1
_MOST_WAITING = 1024

_MOST_FILES = 16
"""Maximum number of files that a client may have open with --read-only; the brick has 64 handles in all."""

_NANOSECONDS = 1_000_000_000


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
    ) -> None:
        """Opens the port. Raises PortInUseError."""
        self.lost: ConnectionLostError | None = None  # why the connection to the brick is lost; None while it is open
        packets = None if recording is None else lambda: recording.packets
        if options.is_masked:
            wire.label, peer = "the brick", "brick"
        self.records = Records(wire.carrier, peer, options.dialect, packets)
        self.say_once: Say = (lambda note: say(masked_note(note))) if options.is_masked else say
        self._wire = wire
        self._options = options
        self._show = show
        self._recording = recording
        self._client: _Client | None = None
        self._pairing: Pairing[_Sent] = Pairing(_MOST_WAITING, give_up=self._unanswered)
        self._error: BaseException | None = None
        self._is_over = asyncio.Event()
        self._loop = asyncio.new_event_loop()
        self._wifi = Wifi(self, only_from=options.only_from)
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

    async def _serve(self) -> None:
        serial_number = self._options.announced
        if serial_number is not None:
            self._wifi.announce(lambda: Beacon(serial_number, str(self.port)), self._options.beacon_port)
        await self._is_over.wait()
        await self._wifi.close()
        if self._client is not None:
            self._client.close()

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

    # The client

    def open(self, line: Line, name: str, carrier: str, ends: Ends, opening: Sequence[tuple[bytes, bool]]) -> _Client:
        """Begins to serve a client, and records the beginning of its connection."""
        self._client = _Client(self, line, name, Decoder(strict=False, dialect=self._options.dialect))
        host, proxy = ends
        if self._options.is_masked:
            opening = [(masked_opening(text), is_host) for text, is_host in opening]
            host, proxy = (_HIDDEN_HOST, host[1]), (_HIDDEN_PROXY, proxy[1])
        self._record(lambda recording: recording.opened(_CLIENT, Carrier(carrier), host, proxy))
        for text, is_from_host in opening:
            self._record(partial(_record_text, text, is_from_host))
        return self._client

    def queued(self) -> None:
        """Does nothing: the waiting client notices it by itself."""

    def forward(self, client: _Client, data: bytes) -> None:
        """Forwards what a client sends; bytes that are not frames end its connection."""
        # As it was sent, in part of a frame or several; names and PINs are found in whole frames only.
        if not self._options.is_masked:
            self._record(lambda recording: recording.data(_CLIENT, data, True))
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
        left = client.decoder.pending
        if left and self._options.is_masked:
            self._record(lambda recording: recording.data(_CLIENT, self._masked(left), True))
        for sent in self._waiting(client):
            self._show(RequestReply(sent.command, None))
        self._record(lambda recording: recording.closed(_CLIENT))
        self._close_handles(client)

    def _close_handles(self, client: _Client) -> None:
        """Closes the files that a client leaves open: the brick has few handles for all clients."""
        for handle in client.handles.take() if self._options.is_read_only else ():
            self._wire.send(close_filehandle(handle, reply=False).build())
            self.say_once(f"{client.name} left the handle {handle} open; it was closed")

    def _masked(self, frame: bytes, request: bytes | None = None) -> bytes:
        return masked(frame, request, self._options.dialect) if self._options.is_masked else frame

    def _to_brick(self, client: _Client, message: Message) -> None:
        frame = message.build()
        status = self._refusal(client, message, frame)
        shown = self._masked(frame)
        if self._options.is_masked:
            self._record(lambda recording: recording.data(_CLIENT, shown, True))
        command = self.records.sent(shown)
        if not message.wants_reply:
            self._show(RequestReply(command, None))
        sent = _Sent(client, command, frame)
        if status is None:
            if message.wants_reply:
                self._pairing.remember(*pairing_key(frame), sent, self._now_ns())
            client.handles.lend(message)
            self._wire.send(frame)
        elif (reply := refused(message, status)) is not None:
            self._to_client(client, sent, reply)

    def _refusal(self, client: _Client, message: Message, frame: bytes) -> SystemStatus | None:
        """Reports why a message is not forwarded. Returns the status for a system command; None for others."""
        if self._options.is_read_only and (harms := harms_of(message, handles=client.handles)):
            reasons = ", ".join(f"{name} {harm.text}" for harm, name in harms.items())
            status = SystemStatus.NO_PERMISSION
            if message.type is not None and not message.type.is_command:
                reasons = f"{message.type.name} is not a command"
            elif isinstance(message, SystemCommand) and set(harms) == {Harm.COMPUTING}:
                reasons = f"{message.command} names a handle that this client has not opened, or is using"
                status = SystemStatus.UNKNOWN_HANDLE
            self.say_once(f"blocked by --read-only: {reasons}")
            return status
        if self._options.is_read_only and _begins(message) and self._files(client) >= _MOST_FILES:
            self.say_once(f"blocked by --read-only: {message.command} opens more than {_MOST_FILES} files")
            return SystemStatus.NO_HANDLES_AVAILABLE
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

    def _take(self, part: bytes | OutOfStep) -> None:
        client = self._client
        if isinstance(part, OutOfStep):
            self.say_once(f"the brick sent {len(part.data)} bytes that are not a frame; they were dropped")
            return
        answer = self._pairing.answered(*pairing_key(part), self._now_ns())
        sent, note = (None, None) if answer is None else (answer.command, answer.note)
        if sent is not None and sent.client is not client:
            # The client that sent the command has disconnected.
            sent.client.handles.learn(parse(part, strict=False))
            self._close_handles(sent.client)
        elif client is not None:
            client.handles.learn(parse(part, strict=False))
            self._to_client(client, sent, part, note)

    def _waiting(self, client: _Client) -> list[_Sent]:
        """Returns the commands of a client that wait for their reply."""
        return [sent for sent in self._pairing.unanswered if sent.client is client]

    def _files(self, client: _Client) -> int:
        """Returns how many files of a client are open, or may be once the replies have come."""
        asked = sum(isinstance(sent.command.message, SystemCommand) for sent in self._waiting(client))
        return len(client.handles) + asked

    def _unanswered(self, sent: _Sent) -> None:
        """Shows a command that was given up; those of a disconnected client were shown."""
        if sent.client is self._client:
            self._show(RequestReply(sent.command, None))

    def _now_ns(self) -> int:
        return round(self._loop.time() * _NANOSECONDS)

    def _to_client(self, client: _Client, sent: _Sent | None, frame: bytes, note: str | None = None) -> None:
        faults = self._options.faults
        command = None if sent is None else sent.command
        reply = faults.apply_to(frame)
        if reply is None:
            self.say_once("a reply was dropped (--drop)")
            if command is not None:
                self._show(RequestReply(command, None))
            return
        shown = self._masked(reply, None if sent is None else sent.frame)
        self._record(lambda recording: recording.data(_CLIENT, shown, False))
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


@dataclass(eq=False, slots=True)
class _Sent:
    """A command that waits for its reply."""

    client: _Client  # its sender
    command: Record  # as it is shown
    frame: bytes  # as it was sent


def _begins(message: Message) -> TypeGuard[SystemCommand]:
    """Returns whether a message opens a file or a listing."""
    entry = SYSTEM_BY_NUMBER.get(message.number) if isinstance(message, SystemCommand) else None
    return entry is not None and entry.transfer == "begin"


class _Client:
    """The client that is served."""

    def __init__(self, proxy: Proxy, line: Line, name: str, decoder: Decoder) -> None:
        self.line = line  # its connection
        self.name = name  # its address and port
        self.decoder = decoder  # what it sent
        self.handles = OpenHandles()  # its open files on the brick
        self._proxy = proxy

    def feed(self, data: bytes) -> None:
        """Takes bytes from the client."""
        self._proxy.act(lambda: self._proxy.forward(self, data))

    def throttle(self, is_throttled: bool) -> None:
        """Reads from the client only while it reads its replies."""
        (self.line.pause if is_throttled else self.line.resume)()

    def close(self) -> None:
        """Learns that the client has disconnected."""
        self._proxy.act(lambda: self._proxy.gone(self))


def _record_text(text: bytes, is_from_host: bool, recording: Recording) -> None:
    recording.data(_CLIENT, text, is_from_host)


def _raise(error: Exception) -> None:
    raise error
