"""Statistics of a capture: messages, operations, latencies, errors, transfers, and what could not be read.

    statistics = Statistics()
    for event in capture.events():
        statistics.add(event)
    print(statistics.summary(capture.account).as_dict())

Memory does not grow with the capture: the tables limit the number of operations, and lists have a limit, with the total
beside them.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from dataclasses import asdict, dataclass, field
from typing import Any, NamedTuple

from ev3proto.capture.byte_account import Account
from ev3proto.capture.dialogues import is_error
from ev3proto.capture.latencies import Latencies, Percentiles
from ev3proto.capture.moving import Moved
from ev3proto.capture.record import NANOSECONDS, OLDEST_DATE, Announcement, Event, Record, Skipped, utc
from ev3proto.dialogue import Transfer
from ev3proto.messages import DaisyCommand, DirectCommand, Message, SystemCommand, SystemReply
from ev3proto.semantics.transfers import UPLOADS, step_of
from ev3proto.tables.system import SYSTEM_BY_NUMBER

MOST_LISTED = 20
"""Maximum number of listed unanswered commands, of faults, and of skipped pieces."""

MOST_PEERS = 64
"""Maximum number of connections with their own statistics; further ones are counted only in the total."""

MOST_TRANSFERS = 1000
"""Maximum number of listed files and listings; further ones are only counted."""

MOST_PENDING = 4096
"""Maximum number of pending commands; beyond, the oldest counts as unanswered."""

_OLDEST_NS = OLDEST_DATE * NANOSECONDS

# The results


@dataclass(slots=True)
class Amount:
    """A number of messages, and the bytes of their frames."""

    messages: int = 0
    bytes: int = 0

    def add(self, size: int) -> None:
        """Adds a message of this size."""
        self.messages += 1
        self.bytes += size


@dataclass(slots=True)
class OperationSummary:
    """One operation or system command."""

    name: str  # `SOUND.TONE`; a system or daisy command's name, or its number if unknown
    kind: str  # `direct`, `system` or `daisy`: the kind of messages that carry it
    uses: int = 0  # its occurrences in commands
    commands: int = 0  # commands that have it
    replies: int = 0  # replies to these
    errors: int = 0  # replies among them that report a failure
    unanswered: int = 0  # commands that requested a reply and got none
    bytes: int = 0  # bytes of the frames of those commands and replies; a frame with several operations counts for each
    latency: Percentiles | None = None  # latency of those replies, None without any


@dataclass(frozen=True, slots=True)
class TransferSummary:
    """A transferred file or listing."""

    path: str  # its path in the command
    command: str  # the command that began it
    direction: str  # `to brick` or `from brick`
    bytes: int  # number of transferred bytes
    size: int | None  # total number of bytes, None if unknown
    seconds: float  # seconds from its first message to its last
    rate: float | None  # bytes per second, None if it took no time
    complete: bool  # all of it was transferred, and the brick answered the last piece if that wanted a reply
    failed: bool  # the brick reported a failure
    packet: int  # the packet in which it began
    peer: str


@dataclass(frozen=True, slots=True)
class Noted:
    """A place in the capture with a remark."""

    packet: int
    peer: str
    text: str


@dataclass(slots=True)
class PeerSummary:
    """The traffic of one connection of a computer and a brick, or of all of them."""

    name: str  # the brick's address, in a text its label if it has one, or `all`
    connection: int | None  # its number, `Record.connection`; None for all of them
    messages: Amount = field(default_factory=Amount)  # frames and their bytes
    kinds: dict[str, Amount] = field(default_factory=dict)  # the same by kind: direct-command, direct-reply, ...
    # each operation, those with the most commands first
    operations: list[OperationSummary] = field(default_factory=list)
    latency: Percentiles | None = None  # latency of all replies, None without any
    errors: int = 0  # replies that report a failure
    faults: int = 0  # faulty frames
    cut: int = 0  # frames whose last bytes the capture or the text has left out
    unanswered: int = 0  # commands that requested a reply and got none
    orphans: int = 0  # replies whose command was not captured
    first: str | None = None  # time of the first message: UTC, or seconds in a source without dates; None if unknown
    last: str | None = None  # time of the last message
    seconds: float = 0.0  # seconds between these
    gap: float | None = None  # longest time between two replies of a connection, in seconds; None without times


@dataclass(frozen=True, slots=True)
class Summary:
    """The statistics of a capture."""

    whole: PeerSummary  # all connections together
    peers: list[PeerSummary]  # each connection of each brick, in the order of their first messages
    peers_left_out: int  # messages of further connections, beyond `MOST_PEERS`
    texts: dict[str, Amount]  # texts around frames, by kind
    transfers: list[TransferSummary]  # files and listings, in the order in which they began
    transfers_left_out: int  # number of further ones, beyond `MOST_TRANSFERS`
    unanswered: list[Noted]  # the first commands that requested a reply and got none
    faults: list[Noted]  # the first faulty frames
    skipped: list[Noted]  # the first pieces that could not be read
    skipped_pieces: int  # number of all such pieces
    skipped_bytes: int  # captured bytes in them
    missing_bytes: int  # number of bytes that were not captured, as far as known
    account: Account | None  # the account of the captured bytes, if given

    def as_dict(self) -> dict[str, Any]:
        """Returns the statistics as values for JSON."""
        return asdict(self)


# The counting


class OperationName(NamedTuple):
    """The kind and the name of an operation in a message."""

    kind: str
    name: str


class _Peer:
    def __init__(self, name: str, connection: int | None = None) -> None:
        self.counts = PeerSummary(name, connection)  # the result, which `summary` completes
        self._operations: dict[OperationName, tuple[OperationSummary, Latencies]] = {}
        self._latencies = Latencies()
        self._first_ns: int | None = None
        self._last_ns = 0
        self._reply_ns: int | None = None  # time of the newest reply

    def message(self, record: Record) -> None:
        size, message = len(record.frame), record.message
        self.counts.messages.add(size)
        # A record that answers another one is a reply, even if a command's type is written over its start.
        kind = message.kind if record.request is None else message.kind.replace("-command", "-reply")
        self.counts.kinds.setdefault(kind, Amount()).add(size)
        self.counts.faults += record.fault is not None
        self.counts.cut += record.missing > 0
        if record.route.is_timed:
            self._add_time(record.time_ns)

    def _add_time(self, time_ns: int) -> None:
        """Takes the time of a message; those without a date count only if none has one."""
        first_ns = self._first_ns
        if first_ns is None or first_ns < _OLDEST_NS <= time_ns:
            self._first_ns = self._last_ns = time_ns
        elif (first_ns < _OLDEST_NS) is (time_ns < _OLDEST_NS):
            self._first_ns, self._last_ns = min(first_ns, time_ns), max(self._last_ns, time_ns)

    def command(self, record: Record, carried: dict[OperationName, int]) -> None:
        for key, uses in carried.items():
            operation, _ = self._operation(key)
            operation.uses += uses
            operation.commands += 1
            operation.bytes += len(record.frame)

    def reply(self, record: Record, carried: dict[OperationName, int], failed: bool) -> None:
        self.counts.errors += failed
        self.counts.orphans += record.request is None
        latency = record.latency
        if latency is not None:
            self._latencies.add(latency)
        if record.route.is_timed:
            self._add_gap(record.time_ns)
        for key in carried:
            operation, latencies = self._operation(key)
            operation.replies += 1
            operation.errors += failed
            operation.bytes += len(record.frame)
            if latency is not None:
                latencies.add(latency)

    def _add_gap(self, time_ns: int) -> None:
        if self._reply_ns is not None:
            self.counts.gap = max(self.counts.gap or 0.0, (time_ns - self._reply_ns) / NANOSECONDS)
        self._reply_ns = time_ns

    def no_reply(self, carried: Iterable[OperationName]) -> None:
        self.counts.unanswered += 1
        for key in carried:
            self._operation(key)[0].unanswered += 1

    def _operation(self, key: OperationName) -> tuple[OperationSummary, Latencies]:
        found = self._operations.get(key)
        if found is None:
            found = self._operations[key] = OperationSummary(key.name, key.kind), Latencies()
        return found

    def summary(self) -> PeerSummary:
        counts = self.counts
        for operation, latencies in self._operations.values():
            operation.latency = latencies.percentiles()
        counts.operations = sorted(
            (operation for operation, _ in self._operations.values()),
            key=lambda entry: (-entry.commands - entry.replies, entry.kind, entry.name),
        )
        counts.kinds = dict(sorted(counts.kinds.items()))
        counts.latency = self._latencies.percentiles()
        if self._first_ns is not None:
            counts.first, counts.last = utc(self._first_ns), utc(self._last_ns)
            counts.seconds = (self._last_ns - self._first_ns) / NANOSECONDS
        return counts


@dataclass(slots=True)
class _Moving:
    moved: Moved
    first_ns: int
    last_ns: int
    packet: int
    peer: str

    def summary(self) -> TransferSummary:
        transfer = self.moved.transfer
        seconds = (self.last_ns - self.first_ns) / NANOSECONDS
        return TransferSummary(
            transfer.path,
            transfer.command,
            "from brick" if transfer.command in UPLOADS else "to brick",
            transfer.transferred,
            transfer.size,
            seconds,
            transfer.transferred / seconds if seconds > 0 else None,
            self.moved.is_complete,
            self.moved.failure is not None,
            self.packet,
            self.peer,
        )


class Statistics:
    """Statistics of events, which are added one by one in their order."""

    def __init__(self) -> None:
        self._whole = _Peer("all")
        self._peers: dict[tuple[str, int], _Peer] = {}
        self._further = 0
        self._texts: dict[str, Amount] = {}
        self._waiting: deque[Record] = deque()
        self._unanswered: list[Noted] = []
        self._faults: list[Noted] = []
        self._skipped: list[Noted] = []
        self._skipped_pieces = 0
        self._skipped_bytes = 0
        self._missing_bytes = 0
        self._transfers: dict[int, _Moving] = {}
        self._transfers_left_out = 0

    def add(self, event: Event) -> None:
        """Counts an event."""
        if isinstance(event, Record):
            self._record(event)
        elif isinstance(event, Announcement):
            self._texts.setdefault(event.said.value, Amount()).add(len(event.data))
        else:
            self._skip(event)

    def summary(self, account: Account | None = None) -> Summary:
        """Returns the statistics so far; pending commands count as unanswered."""
        while self._waiting:
            self._settle_oldest()
        self._unanswered.sort(key=lambda noted: noted.packet)
        whole, peers = self._whole.summary(), [peer.summary() for peer in self._peers.values()]
        whole.gap = max((peer.gap for peer in peers if peer.gap is not None), default=None)
        return Summary(
            whole,
            peers,
            self._further,
            self._texts,
            [moving.summary() for moving in self._transfers.values()],
            self._transfers_left_out,
            self._unanswered[:MOST_LISTED],
            self._faults,
            self._skipped,
            self._skipped_pieces,
            self._skipped_bytes,
            self._missing_bytes,
            account,
        )

    def _record(self, record: Record) -> None:
        message = record.message
        if record.fault is not None and len(self._faults) < MOST_LISTED:
            self._faults.append(Noted(record.number, record.label or record.peer, str(record.fault)))
        self._missing_bytes += record.missing
        counted = self._counted(record)
        self._further += len(counted) == 1
        for each in counted:
            each.message(record)
        if message.type is not None:
            is_command = message.type.is_command and record.request is None
            (self._command if is_command else self._reply)(record, counted)
        if record.transfer is not None:
            self._move(record, record.transfer)

    def _command(self, record: Record, counted: tuple[_Peer, ...]) -> None:
        carried = _carried(record.message)
        for each in counted:
            each.command(record, carried)
        if record.message.wants_reply:
            self._waiting.append(record)
        while self._waiting and (self._waiting[0].answered is not None or len(self._waiting) > MOST_PENDING):
            self._settle_oldest()

    def _reply(self, record: Record, counted: tuple[_Peer, ...]) -> None:
        carried = _carried(record.message if record.request is None else record.request.message)
        for each in counted:
            each.reply(record, carried, is_error(record.message))

    def _counted(self, record: Record) -> tuple[_Peer, ...]:
        """Returns the counts to which a message is added: the total, and its connection's up to the limit."""
        if record.end not in self._peers:
            if len(self._peers) >= MOST_PEERS:
                return (self._whole,)
            self._peers[record.end] = _Peer(record.label or record.peer, record.connection)
        return self._whole, self._peers[record.end]

    def _settle_oldest(self) -> None:
        """Removes the oldest pending command, which counts as unanswered unless it has a reply."""
        command = self._waiting.popleft()
        if command.answered is not None:
            return
        carried = _carried(command.message)
        for each in self._counted(command):
            each.no_reply(carried)
        self._unanswered.append(Noted(command.number, command.label or command.peer, _listed(tuple(carried))))
        if len(self._unanswered) > 2 * MOST_LISTED:
            # Commands are not always settled in their order.
            self._unanswered.sort(key=lambda noted: noted.packet)
            del self._unanswered[MOST_LISTED:]

    # The rest

    def _move(self, record: Record, transfer: Transfer) -> None:
        moving = self._transfers.get(id(transfer))
        if moving is None:
            if len(self._transfers) >= MOST_TRANSFERS:
                self._transfers_left_out += step_of(record.message) == "begin"
                return
            peer = record.label or record.peer
            moving = _Moving(Moved(transfer), record.time_ns, record.time_ns, record.number, peer)
            self._transfers[id(transfer)] = moving
        moving.last_ns = max(moving.last_ns, record.time_ns)
        moving.moved.add(record)

    def _skip(self, event: Skipped) -> None:
        self._skipped_pieces += 1
        self._skipped_bytes += len(event.data)
        self._missing_bytes += event.missing
        if len(self._skipped) < MOST_LISTED:
            self._skipped.append(Noted(event.number, event.route.peer, event.reason))


def _carried(message: Message) -> dict[OperationName, int]:
    """Returns the operations of a command with their numbers; of a reply without its command, those it names."""
    if isinstance(message, SystemCommand | SystemReply):
        return {OperationName("system", _system_name(message.number)): 1}
    found: dict[OperationName, int] = {}
    if isinstance(message, DaisyCommand):
        found[OperationName("daisy", message.command or f"0x{message.number:02X}")] = 1
    if isinstance(message, DirectCommand | DaisyCommand):
        for operation in message.operations:
            key = OperationName("direct", operation.full_name)
            found[key] = found.get(key, 0) + 1
    return found


def _system_name(number: int) -> str:
    """Returns a system command's name; one is both the bootloader's and the firmware's."""
    entry = SYSTEM_BY_NUMBER.get(number)
    if entry is None:
        return f"0x{number:02X}"
    return f"{entry.name} (bootloader)" if entry.bootloader else entry.name


def _listed(carried: tuple[OperationName, ...]) -> str:
    """Returns the first operations: `SOUND.TONE, UI_WRITE.LED and 3 more`."""
    names = [key.name for key in carried[:MOST_NAMED]]
    more = len(carried) - len(names)
    return ", ".join(names) + (f" and {more} more" if more else "")


MOST_NAMED = 4
"""Maximum number of named operations of an unanswered command."""
