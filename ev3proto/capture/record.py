"""What is found in a capture: frames with their place and time, the texts around them, bytes that cannot be read."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from datetime import UTC, datetime
from enum import StrEnum
from typing import NamedTuple, Protocol

from ev3proto.dialogue import Exchange, Transfer, Value, values_of
from ev3proto.messages import Message
from ev3proto.schema.discovery import Beacon, Unlock
from ev3proto.tables.carriers import Carrier

NANOSECONDS = 1_000_000_000
"""In a second."""


HOST = "host"
"""The computer's end of a route, where nothing gives its address."""


class CaptureError(ValueError):
    """What is wrong with a capture as a whole, as a sentence. Everything readable was given before it is raised."""


class Direction(StrEnum):
    """Which way a frame goes, as the computer sees it."""

    SENT = "sent"
    RECEIVED = "received"


@dataclass(frozen=True, slots=True)
class Route:
    """From where to where: what all frames of one direction of one connection have in common.

    carrier    USB, Bluetooth or WiFi
    source     address of the sender: `192.0.2.1:49152`, `host`, `1.7` (USB bus and device), `00:16:53:00:00:0a`
    target     address of the receiver
    direction  sent or received, None where the capture does not say
    interface  name of the interface it was captured on, None where the file has none
    peer       address of the brick (with the TCP port on WiFi): the source or the target
    is_text    the frames stood in a text, which does not say what carried them
    is_timed   somebody wrote down when they were captured; a text may have no times, and those of its records only
               keep them in order
    """

    carrier: Carrier
    source: str
    target: str
    direction: Direction | None
    interface: str | None
    peer: str
    is_text: bool = False
    is_timed: bool = True


class Answered(NamedTuple):
    """What a command's record knows of its reply. It does not keep the reply itself, which keeps the command.

    time_ns  when the reply was captured, in nanoseconds since 1970-01-01 UTC
    failed   the reply says that the command failed
    """

    time_ns: int
    failed: bool


class FrameReader(Protocol):
    """What a record needs of the schema of frames."""

    def read_frame(self, frame: bytes, *, strict: bool = True) -> Message:
        """The message in a frame. With `strict=False` a faulty one is a message, too."""


class Record:
    """A frame in a capture. Its message and values are read when somebody looks at them.

    frame     the bytes
    numbers   the packets that carried it, by their numbers in the file (the first is 1), in the order of its bytes
    time_ns   when its last packet was captured, in nanoseconds since 1970-01-01 UTC
    route     from where to where, and by what
    request   for a reply: the record of the command that it answers; None when no such command was seen
    answered  for a command: what is known of its reply; None as long as none was seen
    transfer  the file that a system message is about, None where it is about none; it counts on while reading
    note      a sentence on what is odd about it beside its contents, None where nothing is
    """

    # A long capture makes a great many of these: the slots without a dataclass around them cost half as much.
    __slots__ = (
        "_message",
        "_reader",
        "_values",
        "answered",
        "frame",
        "note",
        "numbers",
        "request",
        "route",
        "time_ns",
        "transfer",
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
        self.request = request
        self.answered: Answered | None = None
        self.transfer = transfer
        self.note = note
        self._reader = reader
        self._message: Message | None = None
        self._values: list[Value] | None = None

    @property
    def message(self) -> Message:
        """What the frame says. A faulty frame's message has a `fault`."""
        message = self._message
        if message is None:
            message = self._message = self._reader.read_frame(self.frame, strict=False)
            _keep(self)
        return message

    @property
    def values(self) -> list[Value]:
        """For a reply: what it says, by name; else an empty list."""
        if self._values is None:
            self._values = values_of(self.message, None if self.request is None else self.request.message)
        return self._values

    @property
    def exchange(self) -> Exchange:
        """The message with all that a dialogue knows of it."""
        request = None if self.request is None else self.request.message
        return Exchange(self.message, request, self.values, self.transfer)

    @property
    def time(self) -> float:
        """When its last packet was captured, in seconds since 1970-01-01 UTC. `time_ns` is exact."""
        return self.time_ns / NANOSECONDS

    @property
    def latency(self) -> float | None:
        """For a reply: seconds since its command, None where that was not seen, or where nobody wrote times down."""
        request = self.request
        if request is None or not (self.route.is_timed and request.route.is_timed):
            return None
        return (self.time_ns - request.time_ns) / NANOSECONDS

    @property
    def number(self) -> int:
        """The packet that made it whole, by its number in the file."""
        return max(self.numbers)

    @property
    def carrier(self) -> Carrier:
        """USB, Bluetooth or WiFi."""
        return self.route.carrier

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
    def direction(self) -> Direction | None:
        """Sent or received, as the computer sees it; None where the capture does not say."""
        return self.route.direction

    @property
    def interface(self) -> str | None:
        """The interface it was captured on."""
        return self.route.interface

    def __repr__(self) -> str:
        return (
            f"<Record {self.number} {self.route.carrier} {self.route.source} > {self.route.target} {self.frame.hex()}>"
        )


MOST_READ = 32
"""Messages that are kept at the same time. Others are read again when somebody looks at them: a message takes up to 200
times the memory of its frame."""

_read: deque[Record] = deque()


def _keep(record: Record) -> None:
    """Keeps the message of a record, and lets go of the one that was read longest ago."""
    _read.append(record)
    if len(_read) > MOST_READ:
        oldest = _read.popleft()
        oldest._message = oldest._values = None


class TextKind(StrEnum):
    """What stands around frames on WiFi."""

    BEACON = "beacon"
    ANSWER = "answer to a beacon"
    UNLOCK = "unlock"
    ACCEPT = "accepted"


@dataclass(frozen=True, slots=True)
class Announcement:
    """A text on WiFi that is no frame: a beacon, the host's answer, the text that unlocks the brick, its answer.

    said     which of them
    data     the bytes
    text     the text read; None for answers, and for a beacon at fault
    numbers  the packets that carried it
    time_ns  when the last of them was captured, in nanoseconds since 1970-01-01 UTC
    route    from where to where; an answer's peer is the brick
    """

    said: TextKind
    data: bytes
    text: Beacon | Unlock | None
    numbers: tuple[int, ...]
    time_ns: int
    route: Route

    @property
    def time(self) -> float:
        """When it was captured, in seconds since 1970-01-01 UTC."""
        return self.time_ns / NANOSECONDS

    @property
    def facts(self) -> dict[str, str]:
        """What the text says, by name: a brick's serial number, TCP port, name and protocol; nothing for answers."""
        names = ("serial", "port", "name", "protocol")
        return {name: getattr(self.text, name) for name in names if hasattr(self.text, name)}


@dataclass(frozen=True, slots=True)
class Skipped:
    """Bytes among frames that are none, or bytes that should be there and are not.

    data     the bytes that were captured and could not be read
    missing  how many bytes were not captured at all, 0 where that is not known
    reason   one sentence
    number   the packet where it was noticed
    time_ns  when that was captured, in nanoseconds since 1970-01-01 UTC
    route    from where to where
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
"""Everything that is found in a capture."""


def elapsed(time_ns: int, start_ns: int) -> str:
    """`0.011558`: seconds since a capture began."""
    return f"{(time_ns - start_ns) / NANOSECONDS:.6f}"


def utc(time_ns: int) -> str:
    """`2024-01-31T09:12:31.011558Z`, with nanoseconds where the time has them."""
    seconds, rest = divmod(time_ns, NANOSECONDS)
    digits = f"{rest:09}"
    try:
        moment = datetime.fromtimestamp(seconds, UTC)
    except (OverflowError, ValueError, OSError):
        return f"{seconds}.{digits}"  # a damaged file can have times that no calendar has
    day_and_time = moment.isoformat()[: len("2024-01-31T09:12:31")]
    return f"{day_and_time}.{digits[:6] if digits.endswith('000') else digits}Z"
