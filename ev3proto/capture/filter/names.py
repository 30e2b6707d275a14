"""The names that a filter knows, and what each of them has to say about a record.

Lower case   what a frame is and how it came: `op`, `peer`, `latency`, ...; `NAMES` has them all.
Any case     the parameters and fields of the tables: `FREQUENCY`, `path`, ... Those that have the name of the former
             (`TYPE`, `SIZE`, `TIME`, ...) are meant where they are written in upper case, as the firmware has them.
With a dot   a parameter of one operation, family or system command (`SOUND.TONE.VOLUME`, `BEGIN_DOWNLOAD.size`),
             or, after `arg.`, of any.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from ev3proto.capture.dialogues import is_error
from ev3proto.capture.filter.comparisons import Choice, Durations, Flags, Held, Numbers, Texts, ValueType
from ev3proto.capture.filter.fields import (
    PATH,
    command_names,
    find_fields,
    is_parameter,
    operation_names,
    operations_of_opcode,
)
from ev3proto.capture.filter.grammar import Word
from ev3proto.capture.filter.unknown_names import unknown
from ev3proto.capture.record import NANOSECONDS, Direction, Record
from ev3proto.messages import DaisyCommand, Message, Operation, SystemCommand, SystemReply
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SystemStatus

Read = Callable[[Any], Iterable[Any]]
"""The values that a record has for a name, or the records of a dialogue."""

TIME = "time"
"""The one name that is about more than the record alone."""

LATE_MS = 100
"""Milliseconds after which a reply is late. Bricks answer within 10 by USB and WiFi, within 60 by Bluetooth."""


@dataclass(frozen=True, slots=True)
class Name:
    """What a name means.

    text   as it was written
    kind   what its values can be compared with
    read   the values that a record has for it
    there  whether a record has it, which is what the name alone means
    """

    text: str
    kind: ValueType
    read: Read
    there: Callable[[Any], bool]


@dataclass(frozen=True, slots=True)
class Known:
    """What can be asked about every frame.

    kind         what its values can be compared with
    read         the values that a record has for it; None for `time`, which depends on the frame that came first
    text         what it is, for people
    example      a filter that uses it
    looks_ahead  of a command, it is only known when its reply was seen, or can no longer come
    """

    kind: ValueType
    read: Read | None
    text: str
    example: str
    looks_ahead: bool = False


class Clock:
    """When the capture begins, as far as a filter knows: with the first record that it is asked about."""

    def __init__(self) -> None:
        self.start_ns: int | None = None

    def elapsed(self, record: Record) -> float:
        """Seconds from the first record to this one."""
        return (record.time_ns - (record.time_ns if self.start_ns is None else self.start_ns)) / NANOSECONDS


def find_name(word: Word, clock: Clock) -> Name:
    """What a name means. FilterError names the nearest ones for a name that there is not."""
    lower = word.text.lower()
    known = None if word.text.isupper() and is_parameter(lower) else NAMES.get(lower)
    if known is not None:
        read = known.read
        if read is None:
            return Name(word.text, known.kind, lambda record: (clock.elapsed(record),), lambda _: True)
        return Name(
            word.text, known.kind, read, (lambda record: any(read(record))) if known.kind is _FLAG else _has(read)
        )
    places = find_fields(lower)
    if not places:
        raise word.trouble(unknown(word.text, NAMES))
    # The path is said once, when a transfer begins; it is asked for to find all of the transfer.
    read_held = places.read_with_path if lower == PATH else places.read
    return Name(word.text, places.kind, lambda record: _known(read_held(record)), _has(read_held))


def looks_ahead(word: Word) -> bool:
    """Whether the name means something that a command's record does not know before its reply was seen."""
    known = NAMES.get(word.text.lower())
    return known is not None and known.looks_ahead


def _has(read: Read) -> Callable[[Record], bool]:
    return lambda record: any(True for _ in read(record))


def _known(found: Iterable[Held]) -> list[Held]:
    """Those with a value: what a variable holds is not known."""
    return [held for held in found if held.value is not None]


# What a frame is and how it came


def operations_of(record: Record) -> tuple[Operation, ...]:
    """The operations of a command; for a reply, those of the command that it answers."""
    message = record.message if record.request is None else record.request.message
    found: tuple[Operation, ...] = getattr(message, "operations", ())
    return found


def _operation_names(record: Record) -> list[str]:
    return [operation.full_name for operation in operations_of(record)]


def _command_names(record: Record) -> list[str]:
    message = record.message
    if record.request is not None and not isinstance(message, SystemReply):
        message = record.request.message
    named = [operation.command for operation in operations_of(record) if operation.command is not None]
    if isinstance(message, SystemCommand | SystemReply | DaisyCommand) and message.command is not None:
        named.append(message.command)
    return named


def _status(record: Record) -> tuple[int, ...]:
    message = record.message
    return (message.status_code,) if isinstance(message, SystemReply) else ()


def _type(record: Record) -> tuple[int, ...]:
    return () if record.message.type is None else (record.message.type.value,)


def _counter(record: Record) -> tuple[int, ...]:
    return () if record.message.type is None else (record.message.counter,)


def _address(record: Record, address: str) -> tuple[str, ...]:
    """An address, and on WiFi the same without its port."""
    if record.carrier is not Carrier.WIFI:
        return (address,)
    host, _, _ = address.rpartition(":")
    return (address, host, host.strip("[]")) if host else (address,)


def _optional(value: Any) -> tuple[Any, ...]:
    return () if value is None else (value,)


def _is_a_command(word: str) -> str:
    return f": it is a command, command=={word.upper()}" if word.upper() in command_names() else ""


def _is_an_operation(word: str) -> str:
    return f": it is an operation, op=={word.upper()}" if word.upper() in operation_names() else ""


def _is_a_member(word: str, name: str) -> str:
    """For a name that is a parameter's, too, and a value that is the parameter's."""
    known = any(word.upper() in enum.members for enum in find_fields(name).kind.enums)
    return f": it is a value of the parameter {name.upper()}, in upper case" if known else ""


def _failed(record: Record) -> bool:
    return is_error(record.message) or (record.answered is not None and record.answered.failed)


def _unanswered(record: Record) -> bool:
    # A bootloader's reply may have its command's type, and it is none all the same.
    return record.message.wants_reply and record.answered is None and record.request is None


def _late(record: Record) -> bool:
    begin, end = record.time_ns, record.time_ns
    if record.request is not None:
        begin = record.request.time_ns
    elif record.answered is not None:
        end = record.answered.time_ns
    return end - begin > LATE_MS * NANOSECONDS // 1000


_KINDS = dict.fromkeys([*(member.kind for member in MessageType), Message().kind])

_FLAG = Flags()

NAMES: Mapping[str, Known] = {
    "op": Known(
        Choice("an operation", operation_names(), operations_of_opcode, _is_a_command),
        _operation_names,
        "operation by its full name, its family's, or the opcode's number; of a reply: that of its command",
        "op == SOUND.TONE",
    ),
    "command": Known(
        Choice("a command", command_names(), None, _is_an_operation),
        _command_names,
        "name of the CMD, or of the system or daisy command; of a reply: that of its command",
        "command == LIST_FILES",
    ),
    "type": Known(
        Choice(
            "a message type",
            {member.name: (member.value,) for member in MessageType},
            lambda number: (number,),
            lambda word: _is_a_member(word, "type"),
        ),
        _type,
        "message type by name or number",
        "type == DIRECT_COMMAND_NO_REPLY",
    ),
    "kind": Known(
        Choice("a kind of message", {kind: (kind,) for kind in _KINDS}),
        lambda record: (record.message.kind,),
        f"one of {', '.join(_KINDS)}",
        "kind like system-*",
    ),
    "status": Known(
        Choice(
            "a system status",
            {member.name: (member.value,) for member in SystemStatus},
            lambda number: (number,),
            lambda word: _is_a_member(word, "status"),
        ),
        _status,
        "status of a system reply by name or number",
        "status == END_OF_FILE",
    ),
    "error": Known(
        _FLAG,
        lambda record: (is_error(record.message) or record.message.fault is not None,),
        "a reply that says that its command failed, or a frame with a fault",
        "error",
    ),
    "failed": Known(
        _FLAG,
        lambda record: (_failed(record),),
        "a command that failed, as its reply says, and that reply",
        "failed && op",
        looks_ahead=True,
    ),
    "late": Known(
        _FLAG,
        lambda record: (_late(record),),
        f"a reply that came more than {LATE_MS} ms after its command, and that command",
        "late",
        looks_ahead=True,
    ),
    "unanswered": Known(
        _FLAG,
        lambda record: (_unanswered(record),),
        "a command that wants a reply and got none before the capture ended",
        "unanswered",
        looks_ahead=True,
    ),
    "fault": Known(
        Texts(),
        lambda record: () if record.message.fault is None else (record.message.fault.reason,),
        "what is wrong with the frame, as a sentence",
        'fault contains "opcode"',
    ),
    "orphan": Known(_FLAG, lambda record: (record.exchange.is_orphan,), "a reply whose command was not seen", "orphan"),
    "wants_reply": Known(
        _FLAG, lambda record: (record.message.wants_reply,), "a command that the brick is to answer", "wants_reply"
    ),
    "counter": Known(Numbers(), _counter, "message counter", "counter == 1"),
    "size": Known(Numbers(), lambda record: (len(record.frame),), "bytes of the frame", "size > 100"),
    "packet": Known(
        Numbers(),
        lambda record: record.numbers,
        "number of each packet that carried it, from 1 on; of a text: its line",
        "packet in {10..20}",
    ),
    "latency": Known(
        Durations(), lambda record: _optional(record.latency), "time from a command to its reply", "latency > 4ms"
    ),
    TIME: Known(Durations(), None, "time since the capture began, as it is shown before each frame", "time < 1.5s"),
    "peer": Known(
        Texts(bare=True),
        lambda record: _address(record, record.peer),
        "address of the brick; on WiFi with its port or without",
        "peer == 192.0.2.10",
    ),
    "source": Known(
        Texts(bare=True),
        lambda record: _address(record, record.source),
        "address of the sender, in the same way",
        'source like "192.0.2.*"',
    ),
    "target": Known(
        Texts(bare=True),
        lambda record: _address(record, record.target),
        "address of the receiver, in the same way",
        "target == 192.0.2.10:5555",
    ),
    "carrier": Known(
        Choice("a carrier", {carrier: (carrier,) for carrier in Carrier}),
        lambda record: (record.carrier,),
        f"one of {', '.join(Carrier)}",
        "carrier == bluetooth",
    ),
    "direction": Known(
        Choice("a direction", {direction: (direction,) for direction in Direction}),
        lambda record: _optional(record.direction),
        f"one of {', '.join(Direction)}, where the capture says so",
        "direction == received",
    ),
    "interface": Known(
        Texts(bare=True),
        lambda record: _optional(record.interface),
        "interface on which it was captured",
        "interface",
    ),
}
"""What can be asked about every frame."""
