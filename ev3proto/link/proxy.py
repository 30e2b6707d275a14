"""The proxy: a WiFi brick for any program, which hands all that it is sent to another brick, and the answers back.

One client is served at a time, as a brick does it; others wait. Frames go through as they are, counters included.
"""

from __future__ import annotations

import contextlib
import queue
import re
import socket
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field

from ev3proto.brick.servers.faults import Faults
from ev3proto.brick.servers.limits import MOST_QUEUED, UNLOCK_TIME
from ev3proto.brick.servers.unlocking import FIRST_READ, Unlocking, why_not_open
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
from ev3proto.schema.header import build_frame
from ev3proto.stream import Decoder, StreamError
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.discovery import ACCEPT
from ev3proto.tables.frame import MAX_FRAME, MessageType
from ev3proto.tables.system import SystemStatus

_CLIENT = "client"
"""One is served at a time."""

_HIDDEN_HOST, _HIDDEN_PROXY = "192.0.2.1", "192.0.2.10"
_SERIAL = re.compile(rb"(?<=sn=)\w+")

_CHUNK = 1 << 14
_TURN = 0.1
_SEND_TIME = 30.0
_MOST_WAITING = 1024


@dataclass(frozen=True)
class ProxyOptions:
    """What is wanted of a proxy.

    address       of this computer, where clients connect
    port          0 for any that is free
    only_from     the address that clients must have; None for any
    is_read_only  nothing goes through that changes the brick
    is_masked     names, addresses and PINs are kept out of the recording and of what is shown
    faults        what happens to replies
    dialect       the firmware's instruction set
    """

    address: str = "127.0.0.1"
    port: int = 0
    only_from: str | None = None
    is_read_only: bool = False
    is_masked: bool = False
    faults: Faults = field(default_factory=Faults)
    dialect: str = "official"


Shown = Callable[[RequestReply], None]
"""Is given each command with its reply, or without one where it wants none."""

Say = Callable[[str], None]
"""Is called with what the user of the proxy should know."""


class Proxy:
    """Stands between clients and a brick.

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
            peer: What it is called in what is shown.
            options: What is wanted.
            show: Is given what goes by.
            say: Is called with what is odd, in sentences.
            recording: Is given what goes by, too.

        Raises:
            PortInUseError: The port is not to be had.
        """
        self.lost: ConnectionLostError | None = None
        packets = None if recording is None else lambda: recording.packets
        self.records = Records(wire.carrier, peer, options.dialect, packets)
        self._wire = wire
        self._options = options
        self._show = show
        self._say = say
        self._recording = recording
        self._lock = threading.Lock()
        self._pairing: Pairing[Record] = Pairing(_MOST_WAITING)
        self._client: socket.socket | None = None
        self._strangers: dict[socket.socket, None] = {}  # oldest first
        self._unlocked: queue.SimpleQueue[tuple[socket.socket, bytes] | None] = queue.SimpleQueue()
        self._is_over = threading.Event()
        self._delayed: queue.Queue[tuple[float, socket.socket, bytes] | None] = queue.Queue(_MOST_WAITING)
        self._listening = _listen(options)
        self.port: int = self._listening.getsockname()[1]

    def serve(self) -> None:
        """Serves clients until `stop` is called or the brick is gone."""
        reader = threading.Thread(target=self._from_brick, name="reads from the brick", daemon=True)
        reader.start()
        late = threading.Thread(target=self._deliver_late, name="hands replies on late", daemon=True)
        if self._options.faults.delay:
            late.start()
        threading.Thread(target=self._accept, name="accepts clients", daemon=True).start()
        try:
            while (unlocked := self._unlocked.get()) is not None:
                with unlocked[0]:
                    self._serve(*unlocked)
        finally:
            self.stop()
            while (left := self._unlocked.get()) is not None:
                left[0].close()
            reader.join()
            if late.is_alive():
                with contextlib.suppress(queue.Full):  # then it waits for no other, but for the time of one
                    self._delayed.put_nowait(None)
                late.join()

    def stop(self) -> None:
        """Ends everything; may be called from another thread, or when a signal comes."""
        self._is_over.set()
        self._unlocked.put(None)
        for each in (self._listening, self._client, *list(self._strangers)):
            if each is not None:
                with contextlib.suppress(OSError):
                    each.shutdown(socket.SHUT_RDWR)
        self._listening.close()
        self._wire.stop()

    # The client

    def _accept(self) -> None:
        """Takes clients; one that says nothing keeps no other waiting, and of too many the oldest gives way."""
        while not self._is_over.is_set():
            try:
                client, peer = self._listening.accept()
            except OSError:
                return
            wanted = self._options.only_from
            if wanted is not None and peer[0] != wanted:
                self._say(f"{peer[0]} was disconnected: only {wanted} is served (--from)")
                client.close()
                continue
            self._strangers[client] = None
            for each in list(self._strangers)[:-MOST_QUEUED]:
                with contextlib.suppress(OSError):
                    each.shutdown(socket.SHUT_RDWR)
            threading.Thread(target=self._unlock, args=(client, peer[0]), daemon=True).start()

    def _unlock(self, client: socket.socket, address: str) -> None:
        """Waits for the unlock text of a client, which is served in its turn then."""
        text = _unlock_text(client)
        self._strangers.pop(client, None)
        if text is not None:
            self._unlocked.put((client, text))
            return
        client.close()
        if not self._is_over.is_set():
            self._say(f"{address} did not send the unlock text of a WiFi brick; disconnected")

    def _serve(self, client: socket.socket, text: bytes) -> None:
        client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        try:
            client.sendall(ACCEPT)
        except OSError:
            return
        client.settimeout(_SEND_TIME)
        with self._lock:
            self._client = client
            self._pairing = Pairing(_MOST_WAITING)
            self._record_opening(client, text)
        try:
            self._from_client(client)
        finally:
            with self._lock:
                self._client = None
                for command in self._pairing.unanswered:
                    self._show(RequestReply(command, None))
                self._record(lambda recording: recording.closed(_CLIENT))

    def _record_opening(self, client: socket.socket, text: bytes) -> None:
        """Records how a connection begins: as it was, but for what is to be hidden."""
        host, proxy = client.getpeername()[:2], client.getsockname()[:2]
        if self._options.is_masked:
            text = _without_serial(text)
            host, proxy = (_HIDDEN_HOST, host[1]), (_HIDDEN_PROXY, proxy[1])
        self._record(lambda recording: recording.opened(_CLIENT, Carrier.WIFI, host, proxy))
        self._record(lambda recording: recording.data(_CLIENT, text, True))
        self._record(lambda recording: recording.data(_CLIENT, ACCEPT, False))

    def _from_client(self, client: socket.socket) -> None:
        decoder = Decoder(strict=False, dialect=self._options.dialect)
        reason = self._pass_on(client, decoder)
        left = decoder.pending
        if reason is None and left and (fault := decoder.close()) is not None:
            reason = fault.reason
        if reason is not None:
            self._say(f"the client sent bytes that are not a frame: {reason}; disconnected")
        if left:
            shown = masked(left, dialect=self._options.dialect) if self._options.is_masked else left
            with self._lock:
                self._record(lambda recording: recording.data(_CLIENT, shown, True))

    def _pass_on(self, client: socket.socket, decoder: Decoder) -> str | None:
        """Hands the client's messages on until it goes. Returns why its bytes are no frames, where they are not."""
        while True:
            try:
                data = client.recv(_CHUNK)
            except TimeoutError:
                continue  # the time is for sending; a client may be silent as long as it likes
            except OSError:
                return None
            if not data:
                return None
            try:
                for message in decoder.feed(data):
                    self._to_brick(message)
            except StreamError as error:
                return str(error)
            except ConnectionLostError as error:
                self._lose(error)
                return None

    def _to_brick(self, message: Message) -> None:
        frame = message.build()
        if self._options.is_read_only and (harms := harms_of(message, dialect=self._options.dialect)):
            reasons = ", ".join(f"{name} {harm.text}" for harm, name in harms.items())
            self._say(f"blocked by --read-only: {reasons}")
            self._refuse(message, frame, SystemStatus.NO_PERMISSION)
            return
        if len(frame) > MAX_FRAME and self._wire.carrier is Carrier.USB:
            self._say(
                f"a frame of {len(frame)} bytes was not sent: on USB a frame has at most {MAX_FRAME} bytes; send the"
                " file in pieces"
            )
            self._refuse(message, frame, SystemStatus.SIZE_ERROR)
            return
        with self._lock:
            command = self._seen_command(frame, message.wants_reply)
            if not message.wants_reply:
                self._show(RequestReply(command, None))
        self._wire.send(frame)

    def _refuse(self, message: Message, frame: bytes, status: SystemStatus) -> None:
        """Answers a command in the brick's place; only system commands are told the status."""
        with self._lock:
            command = self._seen_command(frame, message.wants_reply)
            if not message.wants_reply:
                self._show(RequestReply(command, None))
                return
        if isinstance(message, SystemCommand):
            kind = MessageType.SYSTEM_REPLY_ERROR
            body = bytes((message.number, status))
        else:
            kind, body = MessageType.DIRECT_REPLY_ERROR, b""
        self._to_client(build_frame(kind, message.counter, body))

    def _seen_command(self, frame: bytes, wants_reply: bool) -> Record:
        shown = masked(frame, dialect=self._options.dialect) if self._options.is_masked else frame
        self._record(lambda recording: recording.data(_CLIENT, shown, True))
        command = self.records.sent(shown)
        if wants_reply:
            forgotten = self._pairing.remember(pairing_key(frame), 0, command)
            if forgotten is not None:
                self._show(RequestReply(forgotten, None))
        return command

    # The brick

    def _from_brick(self) -> None:
        stream = ReplyStream(lambda _counter: True)
        while not self._is_over.is_set():
            try:
                data = self._wire.receive(_TURN)
            except ConnectionLostError as error:
                self._lose(error)
                return
            for part in stream.feed(data) if data else ():
                if isinstance(part, Garbage):
                    self._say(f"the brick sent {len(part.data)} bytes that are not a frame; they were dropped")
                else:
                    self._to_client(part)

    def _to_client(self, frame: bytes) -> None:
        faults = self._options.faults
        sent = faults.befall(frame)
        with self._lock:
            request = self._pairing.answered(pairing_key(frame), None)
            self._seen_reply(frame if sent is None else sent, request, is_lost=sent is None)
            client = self._client
        if sent is None or client is None:
            return
        if faults.delay:
            self._delayed.put((time.monotonic() + faults.delay, client, sent))
        else:
            _deliver(client, sent)

    def _deliver_late(self) -> None:
        """Hands replies on when they are due, in their order."""
        while (waiting := self._delayed.get()) is not None:
            due, client, frame = waiting
            if self._is_over.wait(max(0.0, due - time.monotonic())):
                return
            _deliver(client, frame)

    def _seen_reply(self, frame: bytes, request: Record | None, *, is_lost: bool) -> None:
        if is_lost:
            self._say("a reply was dropped (--drop)")
            if request is not None:
                self._show(RequestReply(request, None))
            return
        shown = frame
        if self._options.is_masked:
            shown = masked(frame, None if request is None else request.frame, self._options.dialect)
        self._record(lambda recording: recording.data(_CLIENT, shown, False))
        self._show(RequestReply(request, self.records.received(shown, request)))

    def _lose(self, error: ConnectionLostError) -> None:
        if not self._is_over.is_set():
            self.lost = error
            self.stop()

    def _record(self, write: Callable[[Recording], None]) -> None:
        if self._recording is None:
            return
        try:
            write(self._recording)
        except OSError as error:
            self._recording = None
            self._say(f"recording ended: {error.strerror or error}")


def _listen(options: ProxyOptions) -> socket.socket:
    try:
        family = socket.AF_INET6 if ":" in options.address else socket.AF_INET
        return socket.create_server((options.address, options.port), family=family)
    except (OSError, OverflowError, UnicodeError) as error:
        other = "--listen wifi:127.0.0.1:5556"
        raise PortInUseError(why_not_open(error, options.address, options.port, other)) from None


def _unlock_text(client: socket.socket) -> bytes | None:
    """Waits for the unlock text. Returns what the client said up to its end; None where that is something else."""
    unlocking = Unlocking()
    deadline = time.monotonic() + UNLOCK_TIME
    client.settimeout(UNLOCK_TIME)
    with contextlib.suppress(OSError):
        while (piece := client.recv(FIRST_READ)) and time.monotonic() < deadline:
            if unlocking.feed(piece) is not None:
                return unlocking.said
    return None


def _without_serial(text: bytes) -> bytes:
    """An unlock text with zeros in place of the serial number."""
    return _SERIAL.sub(lambda found: b"0" * len(found[0]), text)


def _deliver(client: socket.socket, data: bytes) -> None:
    """Sends a reply; a client that takes nothing any more is sent away."""
    try:
        client.sendall(data)
    except OSError:
        with contextlib.suppress(OSError):
            client.shutdown(socket.SHUT_RDWR)
