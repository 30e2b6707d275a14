"""What a capture amounts to: messages, operations, latencies, errors, transfers, and what could not be read.

    statistics = Statistics()
    for event in capture.events():
        statistics.add(event)
    print(statistics.summary(capture.account).as_dict())

Memory does not grow with the capture: there are as many operations as the tables have, and everything that is listed
one by one is listed up to a limit, with the number of all beside it.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from dataclasses import asdict, dataclass, field
from functools import cache
from typing import Any, NamedTuple

from ev3proto.capture.byte_account import Account
from ev3proto.capture.dialogues import is_error
from ev3proto.capture.latencies import Latencies, Percentiles
from ev3proto.capture.moving import UPLOADS, begins
from ev3proto.capture.record import NANOSECONDS, Announcement, Event, Record, Skipped, utc
from ev3proto.dialogue import Transfer
from ev3proto.messages import DaisyCommand, DirectCommand, Message, SystemCommand, SystemReply
from ev3proto.tables.system import SYSTEM_BY_NUMBER

MOST_LISTED = 20
"""So many unanswered commands, faults and skipped pieces are listed."""

MOST_PEERS = 64
"""So many bricks have statistics of their own; what further ones say is only counted in all."""

MOST_TRANSFERS = 1000
"""So many files and listings are listed; further ones are counted."""

MOST_PENDING = 4096
"""So many commands can wait for their replies; beyond, the oldest is taken for one that gets none."""

# The results


@dataclass(slots=True)
class Amount:
    """Messages, and the bytes of their frames."""

    messages: int = 0
    bytes: int = 0

    def add(self, size: int) -> None:
        """Another message of this size."""
        self.messages += 1
        self.bytes += size


@dataclass(slots=True)
class OperationSummary:
    """One operation or system command.

    name        `SOUND.TONE`; a system or daisy command's name, its number where it is not known
    kind        `direct`, `system` or `daisy`: whose messages carry it
    uses        how often it stands in commands
    commands    commands that have it
    replies     replies to these
    errors      replies among them that say that the command failed
    unanswered  commands that wanted a reply and got none
    bytes       of the frames of those commands and replies; a frame with several operations is counted for each
    latency     of those replies, None where there is none
    """

    name: str
    kind: str
    uses: int = 0
    commands: int = 0
    replies: int = 0
    errors: int = 0
    unanswered: int = 0
    bytes: int = 0
    latency: Percentiles | None = None


@dataclass(frozen=True, slots=True)
class TransferSummary:
    """A file or listing that was moved.

    path       as the command says it
    command    the command by which it began
    direction  `to brick` or `from brick`
    bytes      moved
    size       of it all, None where it was not said
    seconds    from its first message to its last
    rate       bytes a second, None where that took no time
    complete   all of it was moved
    failed     the brick said that something went wrong
    packet     in which it began
    peer       the brick
    """

    path: str
    command: str
    direction: str
    bytes: int
    size: int | None
    seconds: float
    rate: float | None
    complete: bool
    failed: bool
    packet: int
    peer: str


@dataclass(frozen=True, slots=True)
class Noted:
    """A place in the capture, and what is to be said about it."""

    packet: int
    peer: str
    text: str


@dataclass(slots=True)
class PeerSummary:
    """What went between the computer and one brick, or all of them.

    name         the brick's address; `all` for all of them
    messages     frames and their bytes
    kinds        the same by kind: direct-command, direct-reply, ...
    operations   one by one, those with the most commands first
    latency      of all replies, None where there is none
    errors       replies that say that the command failed
    faults       frames that have a fault
    unanswered   commands that wanted a reply and got none
    orphans      replies whose command was not seen
    first, last  when the first and the last message were captured, UTC; None where nobody wrote times down
    seconds      between these
    """

    name: str
    messages: Amount = field(default_factory=Amount)
    kinds: dict[str, Amount] = field(default_factory=dict)
    operations: list[OperationSummary] = field(default_factory=list)
    latency: Percentiles | None = None
    errors: int = 0
    faults: int = 0
    unanswered: int = 0
    orphans: int = 0
    first: str | None = None
    last: str | None = None
    seconds: float = 0.0


@dataclass(frozen=True, slots=True)
class Summary:
    """What a capture amounts to.

    whole               all bricks together
    peers               each brick, where there are several
    peers_left_out      messages of further bricks, beyond `MOST_PEERS`
    texts               what was said around frames, by what it was
    transfers           files and listings, in the order in which they began
    transfers_left_out  further ones, beyond `MOST_TRANSFERS`
    unanswered          the first commands that wanted a reply and got none
    faults              the first frames with a fault
    skipped             the first pieces that could not be read
    skipped_pieces      how many there are
    skipped_bytes       captured bytes in them
    missing_bytes       bytes that were not captured, as far as is known
    account             where the captured bytes went, None where it was not given
    """

    whole: PeerSummary
    peers: list[PeerSummary]
    peers_left_out: int
    texts: dict[str, Amount]
    transfers: list[TransferSummary]
    transfers_left_out: int
    unanswered: list[Noted]
    faults: list[Noted]
    skipped: list[Noted]
    skipped_pieces: int
    skipped_bytes: int
    missing_bytes: int
    account: Account | None

    def as_dict(self) -> dict[str, Any]:
        """The same of nothing but what JSON has."""
        return asdict(self)


# The counting


class OperationName(NamedTuple):
    """What a message carries: whose operation it is, and its name."""

    kind: str
    name: str


class _Peer:
    """What is counted of one brick, or of all.

    counts  the result, which `summary` completes
    """

    def __init__(self, name: str) -> None:
        self.counts = PeerSummary(name)
        self._operations: dict[OperationName, tuple[OperationSummary, Latencies]] = {}
        self._latencies = Latencies()
        self._first_ns: int | None = None
        self._last_ns = 0

    def message(self, record: Record) -> None:
        size, message = len(record.frame), record.message
        self.counts.messages.add(size)
        # A record that answers another one is a reply, though a command's type may have been written over its start.
        kind = message.kind if record.request is None else message.kind.replace("-command", "-reply")
        self.counts.kinds.setdefault(kind, Amount()).add(size)
        self.counts.faults += message.fault is not None
        if record.route.is_timed:
            self._first_ns = record.time_ns if self._first_ns is None else min(self._first_ns, record.time_ns)
            self._last_ns = max(self._last_ns, record.time_ns)

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
        for key in carried:
            operation, latencies = self._operation(key)
            operation.replies += 1
            operation.errors += failed
            operation.bytes += len(record.frame)
            if latency is not None:
                latencies.add(latency)

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
    transfer: Transfer
    first_ns: int
    last_ns: int
    packet: int
    peer: str
    failed: bool = False

    def summary(self) -> TransferSummary:
        transfer = self.transfer
        seconds = (self.last_ns - self.first_ns) / NANOSECONDS
        return TransferSummary(
            transfer.path,
            transfer.command,
            "from brick" if transfer.command in UPLOADS else "to brick",
            transfer.transferred,
            transfer.size,
            seconds,
            transfer.transferred / seconds if seconds > 0 else None,
            transfer.is_complete and not self.failed,
            self.failed,
            self.packet,
            self.peer,
        )


class Statistics:
    """Takes the events of a capture one by one, in their order. What it says is about those that it was given."""

    def __init__(self) -> None:
        self._whole = _Peer("all")
        self._peers: dict[str, _Peer] = {}
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
        """What there was so far. Commands whose reply did not come are unanswered.

        Args:
            account: That of the capture, after it was read.
        """
        while self._waiting:
            self._settle_oldest()
        self._unanswered.sort(key=lambda noted: noted.packet)
        return Summary(
            self._whole.summary(),
            [peer.summary() for peer in self._peers.values()] if len(self._peers) > 1 else [],
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
        if message.fault is not None and len(self._faults) < MOST_LISTED:
            self._faults.append(Noted(record.number, record.peer, str(message.fault)))
        counted = self._counted(record.peer)
        self._further += len(counted) == 1
        for each in counted:
            each.message(record)
        if message.type is None:
            pass
        elif message.type.is_command and record.request is None:
            carried = _carried(message)
            for each in counted:
                each.command(record, carried)
            if message.wants_reply:
                self._waiting.append(record)
            while self._waiting and (self._waiting[0].answered is not None or len(self._waiting) > MOST_PENDING):
                self._settle_oldest()
        else:
            carried = _carried(message if record.request is None else record.request.message)
            for each in counted:
                each.reply(record, carried, is_error(message))
        if record.transfer is not None:
            self._move(record, record.transfer)

    def _counted(self, peer: str) -> tuple[_Peer, ...]:
        """What counts what a brick says: the whole, and as long as there are not too many, what it has of its own."""
        if peer not in self._peers:
            if len(self._peers) >= MOST_PEERS:
                return (self._whole,)
            self._peers[peer] = _Peer(peer)
        return self._whole, self._peers[peer]

    def _settle_oldest(self) -> None:
        """Stops waiting for the oldest command, which is unanswered unless its reply came meanwhile."""
        command = self._waiting.popleft()
        if command.answered is not None:
            return
        carried = _carried(command.message)
        for each in self._counted(command.peer):
            each.no_reply(carried)
        self._unanswered.append(Noted(command.number, command.peer, _listed(tuple(carried))))
        if len(self._unanswered) > 2 * MOST_LISTED:
            # Commands are not always settled in their order.
            self._unanswered.sort(key=lambda noted: noted.packet)
            del self._unanswered[MOST_LISTED:]

    # The rest

    def _move(self, record: Record, transfer: Transfer) -> None:
        moving = self._transfers.get(id(transfer))
        if moving is None:
            if len(self._transfers) >= MOST_TRANSFERS:
                self._transfers_left_out += begins(record.message)
                return
            moving = _Moving(transfer, record.time_ns, record.time_ns, record.number, record.peer)
            self._transfers[id(transfer)] = moving
        moving.last_ns = max(moving.last_ns, record.time_ns)
        moving.failed |= is_error(record.message)

    def _skip(self, event: Skipped) -> None:
        self._skipped_pieces += 1
        self._skipped_bytes += len(event.data)
        self._missing_bytes += event.missing
        if len(self._skipped) < MOST_LISTED:
            self._skipped.append(Noted(event.number, event.route.peer, event.reason))


def _carried(message: Message) -> dict[OperationName, int]:
    """What a command carries, each with how often; of a reply whose command was not seen, what it says of it."""
    if isinstance(message, SystemCommand | SystemReply):
        return {OperationName("system", _system_name(message.number)): 1}
    found: dict[OperationName, int] = {}
    if isinstance(message, DaisyCommand):
        found[OperationName("daisy", message.command or f"0x{message.number:02X}")] = 1
    if isinstance(message, DirectCommand | DaisyCommand):
        for operation in message.operations:
            key = _direct(operation.full_name)
            found[key] = found.get(key, 0) + 1
    return found


@cache
def _direct(name: str) -> OperationName:
    """The name of an operation. There are as many as the tables have, and commands that wait share them."""
    return OperationName("direct", name)


def _system_name(number: int) -> str:
    """The command's name; the bootloader has one that the firmware has, too."""
    entry = SYSTEM_BY_NUMBER.get(number)
    if entry is None:
        return f"0x{number:02X}"
    return f"{entry.name} (bootloader)" if entry.bootloader else entry.name


def _listed(carried: tuple[OperationName, ...]) -> str:
    """`SOUND.TONE, UI_WRITE.LED`, not all of a long program."""
    names = [key.name for key in carried[:MOST_NAMED]]
    more = len(carried) - len(names)
    return ", ".join(names) + (f" and {more} more" if more else "")


MOST_NAMED = 4
"""So many operations of an unanswered command are named."""
