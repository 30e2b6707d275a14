"""The events of a capture: frames with place and time, the texts around them, bytes that cannot be read."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from datetime import UTC, datetime
from enum import StrEnum
from typing import Any, NamedTuple

from ev3proto.dialogue import Exchange, Transfer, Value, values_of
from ev3proto.errors import Error, Fault
from ev3proto.messages import Message, own_fault
from ev3proto.schema.discovery import Beacon, Unlock
from ev3proto.schema.frame import FrameReader
from ev3proto.schema.header import HEADER_SIZE, frame_size
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.text.json_format.from_messages import record as message_record
from ev3proto.text.phrases import Seen

NANOSECONDS = 1_000_000_000
"""Nanoseconds in a second."""


OLDEST_DATE = 946_684_800
"""Seconds from 1970 to 2000. Earlier times are of a source without dates: they count from any moment."""

HOST = "host"
"""The computer's end of a route, if its address is unknown."""


class CaptureError(ValueError, Error):
    """A fault of a capture as a whole. It is raised after everything readable was given."""


class Direction(StrEnum):
    """The direction of a frame, as seen by the computer."""

    SENT = "sent"
    RECEIVED = "received"


@dataclass(frozen=True, slots=True)
class Route:
    """The common facts of all frames in one direction of a connection.

    carrier    USB, Bluetooth or WiFi
    source     address of the sender: `192.0.2.1:49152`, `host`, `1.7` (USB bus and device), `00:16:53:00:00:0a`
    target     address of the receiver
    direction  sent or received, None if unknown
    interface  name of the interface they were captured on, None if unknown
    peer       address of the brick (with the TCP port on WiFi): the source or the target
    label      what a text names beside the direction, such as "leader" or "COM3"; empty without a label
    is_text    the frames are from a text, which does not tell their carrier
    is_timed   their times are known; a text may have none, and then the times of its records only give their order
    """

    carrier: Carrier
    source: str
    target: str
    direction: Direction | None
    interface: str | None
    peer: str
    is_text: bool = False
    is_timed: bool = True
    label: str = ""


class Place(NamedTuple):
    """A place in something that was read; its text is `robot.log, line 3`.

    name    of the file, or the quoted text; empty for a text that speaks for itself
    line    in a text, the first is 1
    column  in that line, the first is 1
    packet  number of the packet in a capture, the first is 1
    frame   number of the frame that assembly makes, or in a file of bytes, the first is 1
    offset  in that frame or that piece of a text, as the sentence about it says
    """

    name: str = ""
    line: int | None = None
    column: int | None = None
    packet: int | None = None
    frame: int | None = None
    offset: int | None = None

    def __str__(self) -> str:
        counted = [f"{word} {number}" for word, number in zip(self._fields[1:-1], self[1:-1], strict=True) if number]
        return ", ".join([self.name, *counted] if self.name else counted)


class Written(NamedTuple):
    """What a text says of a frame, besides its bytes.

    place      of its bytes in the text
    direction  stated in front of them; None if not stated
    time       as written, None if there is none
    is_typed   it was given by itself, as on a command line
    column     in its line at which it starts, the first is 1; None for a message that was made
    unknown    offsets in the frame of bytes that the text does not give, which were read as zero
    rest       the bytes after the frame that have no meaning, such as padding
    """

    place: Place
    direction: str | None = None
    time: str | None = None
    is_typed: bool = False
    column: int | None = None
    unknown: frozenset[int] = frozenset()
    rest: bytes = b""


class Outcome(NamedTuple):
    """A command's facts about its reply, without the reply itself, which refers to the command."""

    time_ns: int  # the reply's time, in nanoseconds since 1970-01-01 UTC
    failed: bool  # whether the command failed


class Record:
    """A frame in a capture. Its message and values are parsed on access.

    frame       the bytes
    numbers     the numbers of the packets that carried it (from 1), in the order of its bytes
    time_ns     the time of its last packet, in nanoseconds since 1970-01-01 UTC
    route       carrier, sender and receiver
    connection  the number of its conversation in its file, from 1
    request     for a reply: the record of the command that it answers; None if that was not captured
    answered    for a command: the facts about its reply; None without one so far
    transfer    the file transfer that a system message belongs to, if any; its counts increase while reading
    note        a sentence about a peculiarity besides its contents, if any
    is_mended   its length or its first bytes are wrong, but what was meant is certain; the note says what is wrong
    missing     number of bytes at the end of the frame that the capture or the text has left out
    written     what the text says in which it is; None in a capture
    name        the name of the capture; empty if unknown

    A conversation is a TCP connection (a SYN with another sequence number begins a new one between the same ends), a
    USB device (bus and number), or the RFCOMM channel between two addresses. It gets the next number with its first
    message: when that is complete and recognised as one. A packet that proves earlier messages counts as theirs. So
    one pass over the packets in their order gives the numbers, and the dissector's `ev3.connection` has the same. In a
    text, each label of commands is one, as long as replies are found to have the label of their command; a reply has
    the number of its command.
    """

    # A long capture makes many of these: slots without a dataclass cost half as much.
    __slots__ = (
        "_message",
        "_reader",
        "_values",
        "answered",
        "connection",
        "frame",
        "is_mended",
        "missing",
        "name",
        "note",
        "numbers",
        "request",
        "route",
        "time_ns",
        "transfer",
        "written",
    )

    def __init__(
        self,
        frame: bytes,
        numbers: tuple[int, ...],
        time_ns: int,
        route: Route,
        reader: FrameReader,
        request: Record | None = None,
        transfer: Transfer | None = None,
        note: str | None = None,
    ) -> None:
        self.frame = frame
        self.numbers = numbers
        self.time_ns = time_ns
        self.route = route
        self.connection = 1
        self.request = request
        self.answered: Outcome | None = None
        self.transfer = transfer
        self.note = note
        self.is_mended = False
        self.missing = 0
        self.written: Written | None = None
        self.name = ""
        self._reader = reader
        self._message: Message | None = None
        self._values: list[Value] | None = None

    @property
    def message(self) -> Message:
        """The parsed message. A faulty frame's message has a `fault`."""
        message = self._message
        if message is None:
            message = self._reader.read_frame(self.frame, strict=False)
            self.keep(message)
        return message

    def keep(self, message: Message) -> None:
        """Takes the message of its frame, which was parsed already."""
        self._message = message
        _keep(self)

    @property
    def values(self) -> list[Value]:
        """For a reply: its values by name; else an empty list."""
        if self._values is None:
            self._values = values_of(self.message, None if self.request is None else self.request.message)
        return self._values

    @property
    def exchange(self) -> Exchange:
        """The message with its facts from the dialogue."""
        request = None if self.request is None else self.request.message
        return Exchange(self.message, request, self.values, self.transfer, self.note)

    @property
    def time(self) -> float | None:
        """The time of its last packet, in seconds since 1970-01-01 UTC; None if unknown. `time_ns` is exact."""
        return self.time_ns / NANOSECONDS if self.route.is_timed else None

    @property
    def seen(self) -> Seen:
        """Its circumstances, as far as a text or the route tells them."""
        written = self.written
        if written is None:
            return Seen(self.route.direction, missing=self.missing, frame=self.frame)
        return Seen(
            written.direction,
            written.time,
            self.missing,
            frame=self.frame,
            unknown=written.unknown,
            label=self.label,
        )

    def as_dict(self) -> dict[str, Any]:
        """Returns it as `ev3proto decode --json` prints it, for other tools; bytes are hex."""
        entry = message_record(self.exchange, self.seen)
        return entry if self.written is not None else entry | self.circumstances()

    def circumstances(self) -> dict[str, Any]:
        """Returns time, place and dialogue for other tools, without `time` for a log without times."""
        entry = place_record(self) | {"connection": self.connection}
        if self.label:
            entry["label"] = self.label
        if self.request is not None:
            entry |= {"answers": self.request.number, "latency": self.latency}
        return entry

    @property
    def place(self) -> Place:
        """Its place: the line of a text, the packet of a capture."""
        written = self.written
        return Place(self.name, packet=self.number) if written is None else written.place

    @property
    def rest(self) -> bytes:
        """The bytes after the frame that have no meaning, such as padding; empty in a capture."""
        return b"" if self.written is None else self.written.rest

    @property
    def unknown(self) -> frozenset[int]:
        """Offsets in the frame of bytes that a text does not give, which were read as zero."""
        return frozenset() if self.written is None else self.written.unknown

    @property
    def is_pasted(self) -> bool:
        """Whether its bytes are in a text, and were not made from assembly or JSON."""
        return self.written is not None and self.written.column is not None

    @property
    def fault(self) -> Fault | None:
        """What is wrong with the frame, unless only its end is missing here."""
        return own_fault(self.message, self.missing)

    @property
    def is_from_brick(self) -> bool:
        """Whether the brick sent it: by its direction, or else, unless it was typed as bytes, by its type."""
        if self.written is None:
            stated: str | None = self.route.direction
        elif self.written.is_typed:
            return self.written.direction == Direction.RECEIVED
        else:
            stated = self.written.direction
        if stated is not None:
            return stated == Direction.RECEIVED
        return self.message.type is not None and not self.message.type.is_command

    @property
    def latency(self) -> float | None:
        """For a reply: seconds since its command; None if that was not captured, or times are unknown."""
        request = self.request
        if request is None or not (self.route.is_timed and request.route.is_timed):
            return None
        return (self.time_ns - request.time_ns) / NANOSECONDS

    @property
    def number(self) -> int:
        """The number of the packet that completed it."""
        return max(self.numbers)

    @property
    def carrier(self) -> Carrier | None:
        """USB, Bluetooth or WiFi; None in a text, which does not tell it."""
        return None if self.route.is_text else self.route.carrier

    @property
    def source(self) -> str:
        """Address of the sender."""
        return self.route.source

    @property
    def target(self) -> str:
        """Address of the receiver."""
        return self.route.target

    @property
    def peer(self) -> str:
        """Address of the brick."""
        return self.route.peer

    @property
    def end(self) -> tuple[str, int]:
        """What its connection is counted by, also in several files: the address of the brick, and the number."""
        return self.route.peer, self.connection

    @property
    def direction(self) -> Direction | None:
        """Sent or received, as seen by the computer; None if unknown."""
        return self.route.direction

    @property
    def label(self) -> str:
        """What a text names beside the direction, often the brick or its port; empty without a label."""
        return self.route.label

    @property
    def interface(self) -> str | None:
        """The name of the interface on which it was captured."""
        return self.route.interface

    def __repr__(self) -> str:
        if self.written is not None:
            return f"<Record {self.place} {self.direction} {self.frame.hex()}>"
        return (
            f"<Record {self.number} {self.route.carrier} {self.route.source} > {self.route.target} {self.frame.hex()}>"
        )


MOST_READ = 32
"""Maximum number of cached messages; others are parsed again. A message takes up to 200 times its frame's memory."""

_read: deque[Record] = deque()


def _keep(record: Record) -> None:
    _read.append(record)
    if len(_read) > MOST_READ:
        oldest = _read.popleft()
        oldest._message = oldest._values = None


def missing_of(frame: bytes) -> int:
    """Returns the number of bytes that a frame lacks at its end; without its length field, those of its header."""
    size = frame_size(frame) if len(frame) >= LENGTH_FIELD else HEADER_SIZE
    return max(size - len(frame), 0)


class TextKind(StrEnum):
    """The texts around frames on WiFi."""

    BEACON = "beacon"
    ANSWER = "answer to a beacon"
    UNLOCK = "unlock"
    ACCEPT = "accepted"


@dataclass(frozen=True, slots=True)
class Announcement:
    """A text on WiFi: a beacon, the host's answer, the text that unlocks the brick, its answer.

    said     its kind
    data     the bytes
    text     the parsed text; None for answers, and for a faulty beacon
    numbers  the numbers of the packets that carried it
    time_ns  the time of the last of them, in nanoseconds since 1970-01-01 UTC
    route    carrier, sender and receiver; an answer's peer is the brick
    """

    said: TextKind
    data: bytes
    text: Beacon | Unlock | None
    numbers: tuple[int, ...]
    time_ns: int
    route: Route

    @property
    def time(self) -> float:
        """Its time in seconds since 1970-01-01 UTC."""
        return self.time_ns / NANOSECONDS

    @property
    def facts(self) -> dict[str, str]:
        """Its facts by name: the brick's serial number, TCP port, name and protocol; empty for answers."""
        names = ("serial", "port", "name", "protocol")
        return {name: getattr(self.text, name) for name in names if hasattr(self.text, name)}


@dataclass(frozen=True, slots=True)
class Skipped:
    """Bytes among frames that cannot be read, or that are missing.

    data     the captured bytes that cannot be read
    missing  number of bytes that were not captured, 0 if unknown
    reason   one sentence
    number   the number of the packet in which it was noticed
    time_ns  that packet's time, in nanoseconds since 1970-01-01 UTC
    route    carrier, sender and receiver
    """

    data: bytes
    missing: int
    reason: str
    number: int
    time_ns: int
    route: Route

    def __str__(self) -> str:
        return f"packet {self.number}, {self.route.source} to {self.route.target}: {self.reason}"


Event = Record | Announcement | Skipped
"""Everything in a capture."""


def place_record(event: Record | Announcement) -> dict[str, Any]:
    """Returns place and time for other tools; without `time` for a log without times."""
    route = event.route
    written = event.written if isinstance(event, Record) else None
    said = utc(event.time_ns) if written is None else written.time
    time = {"time": said} if route.is_timed else {}
    return time | {
        "packets": list(event.numbers),
        "interface": route.interface,
        "carrier": route.carrier,
        "source": route.source,
        "target": route.target,
        "peer": route.peer,
    }


def elapsed(time_ns: int, start_ns: int) -> str:
    """Returns the seconds since a capture began: `0.011558`."""
    return f"{(time_ns - start_ns) / NANOSECONDS:.6f}"


def utc(time_ns: int) -> str:
    """Returns a time as `2024-01-31T09:12:31.011558Z`, with nanoseconds if it has any.

    Times before 2000, and after 9999 in a damaged file, are not dates: these become bare seconds, `0.011558`.
    """
    seconds, rest = divmod(time_ns, NANOSECONDS)
    digits = f"{rest:09}"
    digits = digits[:6] if digits.endswith("000") else digits
    if seconds < OLDEST_DATE:
        return f"{seconds}.{digits}"
    try:
        moment = datetime.fromtimestamp(seconds, UTC)
    except (OverflowError, ValueError, OSError):
        return f"{seconds}.{digits}"
    return f"{moment.isoformat()[: len('2024-01-31T09:12:31')]}.{digits}Z"
