"""What a capture amounts to: messages, operations, latencies, errors, transfers, and what could not be read.

    statistics = Statistics()
    for event in capture.events():
        statistics.add(event)
    print(statistics.summary(capture.account).as_dict())

Memory does not grow with the capture: there are as many operations as the tables have, and everything that is listed
one by one is listed up to a limit, with the number of all beside it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict, dataclass, field
from functools import cache
from typing import Any, NamedTuple

from ev3proto.bounded import Bounded
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

    def add_all(self, other: Amount) -> None:
        """All those of another one."""
        self.messages += other.messages
        self.bytes += other.bytes


@dataclass(frozen=True, slots=True)
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
    uses: int
    commands: int
    replies: int
    errors: int
    unanswered: int
    bytes: int
    latency: Percentiles | None


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


@dataclass(frozen=True, slots=True)
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
    messages: Amount
    kinds: dict[str, Amount]
    operations: list[OperationSummary]
    latency: Percentiles | None
    errors: int
    faults: int
    unanswered: int
    orphans: int
    first: str | None
    last: str | None
    seconds: float


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


@dataclass(slots=True)
class _OperationCounts:
    uses: int = 0
    commands: int = 0
    replies: int = 0
    errors: int = 0
    unanswered: int = 0
    bytes: int = 0
    latencies: Latencies = field(default_factory=Latencies)

    def add_all(self, other: _OperationCounts) -> None:
        self.uses += other.uses
        self.commands += other.commands
        self.replies += other.replies
        self.errors += other.errors
        self.unanswered += other.unanswered
        self.bytes += other.bytes
        self.latencies.add_all(other.latencies)

    def summary(self, carried: OperationName) -> OperationSummary:
        return OperationSummary(
            carried.name,
            carried.kind,
            self.uses,
            self.commands,
            self.replies,
            self.errors,
            self.unanswered,
            self.bytes,
            self.latencies.percentiles(),
        )


@dataclass(slots=True)
class _PeerCounts:
    """The counts of one brick, or of all."""

    name: str
    messages: Amount = field(default_factory=Amount)
    kinds: dict[str, Amount] = field(default_factory=dict)
    operations: dict[OperationName, _OperationCounts] = field(default_factory=dict)
    latencies: Latencies = field(default_factory=Latencies)
    errors: int = 0
    faults: int = 0
    unanswered: int = 0
    orphans: int = 0
    first_ns: int | None = None
    last_ns: int = 0

    def command(self, record: Record, carried: dict[OperationName, int]) -> None:
        self._message(record)
        for key, uses in carried.items():
            operation = self._operation(key)
            operation.uses += uses
            operation.commands += 1
            operation.bytes += len(record.frame)

    def reply(self, record: Record, carried: dict[OperationName, int], failed: bool) -> None:
        self._message(record)
        self.errors += failed
        self.orphans += record.request is None
        latency = record.latency
        if latency is not None:
            self.latencies.add(latency)
        for key in carried:
            operation = self._operation(key)
            operation.replies += 1
            operation.errors += failed
            operation.bytes += len(record.frame)
            if latency is not None:
                operation.latencies.add(latency)

    def no_message(self, record: Record) -> None:
        self._message(record)

    def add_all(self, other: _PeerCounts) -> None:
        self.messages.add_all(other.messages)
        for kind, amount in other.kinds.items():
            self.kinds.setdefault(kind, Amount()).add_all(amount)
        for key, operation in other.operations.items():
            self._operation(key).add_all(operation)
        self.latencies.add_all(other.latencies)
        self.errors += other.errors
        self.faults += other.faults
        self.unanswered += other.unanswered
        self.orphans += other.orphans
        if other.first_ns is not None:
            self.first_ns = other.first_ns if self.first_ns is None else min(self.first_ns, other.first_ns)
            self.last_ns = max(self.last_ns, other.last_ns)

    def no_reply(self, carried: Iterable[OperationName]) -> None:
        self.unanswered += 1
        for key in carried:
            self._operation(key).unanswered += 1

    def _message(self, record: Record) -> None:
        size = len(record.frame)
        self.messages.add(size)
        # A record that answers another one is a reply, though a command's type may have been written over its start.
        kind = record.message.kind if record.request is None else record.message.kind.replace("-command", "-reply")
        self.kinds.setdefault(kind, Amount()).add(size)
        self.faults += record.message.fault is not None
        if record.route.is_timed:
            self.first_ns = record.time_ns if self.first_ns is None else min(self.first_ns, record.time_ns)
            self.last_ns = max(self.last_ns, record.time_ns)

    def _operation(self, key: OperationName) -> _OperationCounts:
        found = self.operations.get(key)
        if found is None:
            found = self.operations[key] = _OperationCounts()
        return found

    def summary(self) -> PeerSummary:
        operations = [operation.summary(key) for key, operation in self.operations.items()]
        operations.sort(key=lambda entry: (-entry.commands - entry.replies, entry.kind, entry.name))
        seen = self.first_ns is not None
        return PeerSummary(
            self.name,
            self.messages,
            dict(sorted(self.kinds.items())),
            operations,
            self.latencies.percentiles(),
            self.errors,
            self.faults,
            self.unanswered,
            self.orphans,
            utc(self.first_ns) if self.first_ns is not None else None,
            utc(self.last_ns) if seen else None,
            (self.last_ns - self.first_ns) / NANOSECONDS if self.first_ns is not None else 0.0,
        )


class _OpenCommand(NamedTuple):
    """A command that waits for its reply; not the record itself, which would keep its frame and message."""

    number: int
    peer: str
    carried: tuple[OperationName, ...]


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
        self._peers: dict[str, _PeerCounts] = {}
        self._further = _PeerCounts("further ones")
        self._texts: dict[str, Amount] = {}
        self._waiting: Bounded[int, _OpenCommand] = Bounded(MOST_PENDING)
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

    def look(self, event: Event) -> None:
        """Looks at an event that may not be counted: a reply to a command that was counted is one all the same."""
        if isinstance(event, Record):
            self._answered(event)

    def summary(self, account: Account | None = None) -> Summary:
        """What there was so far. Commands whose reply did not come are unanswered.

        Args:
            account: That of the capture, after it was read.
        """
        while self._waiting:
            self._give_up(self._waiting.pop_oldest())
        self._unanswered.sort(key=lambda noted: noted.packet)
        whole = _PeerCounts("all")
        for tally in (*self._peers.values(), self._further):
            whole.add_all(tally)
        return Summary(
            whole.summary(),
            [tally.summary() for tally in self._peers.values()] if len(self._peers) > 1 else [],
            self._further.messages.messages,
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
        tally = self._tally(record.peer)
        if message.type is None:
            tally.no_message(record)
        elif message.type.is_command and record.request is None:
            carried = _carried(message)
            tally.command(record, carried)
            if message.wants_reply and record.answered is None:
                self._wait(record, carried)
        else:
            request = record.request
            tally.reply(record, _carried(message if request is None else request.message), is_error(message))
            self._answered(record)
        if record.transfer is not None:
            self._move(record, record.transfer)

    def _tally(self, peer: str) -> _PeerCounts:
        found = self._peers.get(peer)
        if found is None:
            if len(self._peers) >= MOST_PEERS:
                return self._further
            found = self._peers[peer] = _PeerCounts(peer)
        return found

    # Commands and their replies. A record that is no longer referred to can have no reply, and then another one can
    # have its id: what waits under that id waits in vain.

    def _wait(self, record: Record, carried: dict[OperationName, int]) -> None:
        same = self._waiting.pop(id(record), None)
        oldest = self._waiting.add(id(record), _OpenCommand(record.number, record.peer, tuple(carried)))
        for forgotten in (same, oldest):
            if forgotten is not None:
                self._give_up(forgotten)

    def _answered(self, reply: Record) -> None:
        request = reply.request
        waiting = None if request is None else self._waiting.get(id(request))
        if request is not None and waiting is not None and waiting.number == request.number:
            del self._waiting[id(request)]

    def _give_up(self, waiting: _OpenCommand) -> None:
        self._peers.get(waiting.peer, self._further).no_reply(waiting.carried)
        self._unanswered.append(Noted(waiting.number, waiting.peer, _listed(waiting.carried)))
        if len(self._unanswered) > 2 * MOST_LISTED:
            # Commands are not always given up in their order.
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
