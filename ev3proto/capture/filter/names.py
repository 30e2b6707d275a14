"""The names that a filter knows, and what each of them has to say about a record.

Lower case   what a frame is and how it came: `op`, `peer`, `latency`, ...; `NAMES` has them all.
Any case     the parameters and fields of the tables: `FREQUENCY`, `path`, ... Those that have the name of the former
             (`TYPE`, `SIZE`, `TIME`, ...) are meant where they are written in upper case, as the firmware has them.
With a dot   a parameter of one operation, family or system command (`SOUND.TONE.VOLUME`, `BEGIN_DOWNLOAD.size`),
             or, after `arg.`, of any.
"""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from ev3proto.capture.dialogues import is_error
from ev3proto.capture.filter.comparisons import Choice, Flags, Held, Numbers, Texts, ValueType
from ev3proto.capture.filter.fields import (
    PATH,
    command_names,
    find_fields,
    is_parameter,
    operation_names,
    operations_of_opcode,
    parameter_names,
)
from ev3proto.capture.filter.grammar import FilterError, Word
from ev3proto.capture.record import NANOSECONDS, Direction, Record
from ev3proto.messages import DaisyCommand, Message, Operation, SystemCommand, SystemReply
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SystemStatus

Read = Callable[[Record], Iterable[Any]]
"""The values that a record has for a name."""

TIME = "time"
"""The one name that is about more than the record alone."""


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
    there: Callable[[Record], bool]


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
    if lower in NAMES and not (word.text.isupper() and is_parameter(lower)):
        kind, read = NAMES[lower]
        return Name(word.text, kind, read, (lambda record: any(read(record))) if kind is _FLAG else _has(read))
    if lower == TIME and not word.text.isupper():
        return Name(word.text, Numbers(" of seconds"), lambda record: (clock.elapsed(record),), lambda _: True)
    places = find_fields(lower)
    if not places:
        raise FilterError(word.column, _unknown(word.text))
    # The path is said once, when a transfer begins; it is asked for to find all of the transfer.
    read_held = places.read_with_path if lower == PATH else places.read
    return Name(word.text, places.kind, lambda record: _known(read_held(record)), _has(read_held))


def _has(read: Read) -> Callable[[Record], bool]:
    return lambda record: any(True for _ in read(record))


def _known(found: Iterable[Held]) -> list[Held]:
    """Those with a value: what a variable holds is not known."""
    return [held for held in found if held.value is not None]


def _unknown(text: str) -> str:
    owner, _, name = text.upper().rpartition(".")
    if owner in operation_names() and is_parameter(name):
        return f"{owner} has no parameter {name}"
    if text.upper() in operation_names():
        return f"{text} is an operation, which is asked for so: op=={text.upper()}"
    if text.upper() in command_names():
        return f"{text} is a command, which is asked for so: command=={text.upper()}"
    known = {name.lower(): name for name in (*parameter_names(), *NAMES, TIME)}
    near = [known[found] for found in difflib.get_close_matches(name.lower(), known, 3, 0.6)]
    return f"nothing is called {text}" + (f": did you mean {' or '.join(near)}?" if near else "")


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


_KINDS = dict.fromkeys([*(member.kind for member in MessageType), Message().kind])

_FLAG = Flags()

NAMES: Mapping[str, tuple[ValueType, Read]] = {
    "op": (Choice("an operation", operation_names(), operations_of_opcode, _is_a_command), _operation_names),
    "command": (Choice("a command", command_names(), None, _is_an_operation), _command_names),
    "type": (
        Choice(
            "a message type",
            {member.name: (member.value,) for member in MessageType},
            lambda number: (number,),
            lambda word: _is_a_member(word, "type"),
        ),
        _type,
    ),
    "kind": (Choice("a kind of message", {kind: (kind,) for kind in _KINDS}), lambda record: (record.message.kind,)),
    "status": (
        Choice(
            "a system status",
            {member.name: (member.value,) for member in SystemStatus},
            lambda number: (number,),
            lambda word: _is_a_member(word, "status"),
        ),
        _status,
    ),
    "error": (_FLAG, lambda record: (is_error(record.message) or record.message.fault is not None,)),
    "fault": (Texts(), lambda record: () if record.message.fault is None else (record.message.fault.reason,)),
    "orphan": (_FLAG, lambda record: (record.exchange.is_orphan,)),
    "wants_reply": (_FLAG, lambda record: (record.message.wants_reply,)),
    "counter": (Numbers(), _counter),
    "size": (Numbers(), lambda record: (len(record.frame),)),
    "packet": (Numbers(), lambda record: record.numbers),
    "latency": (Numbers(" of seconds"), lambda record: _optional(record.latency)),
    "peer": (Texts(bare=True), lambda record: _address(record, record.peer)),
    "source": (Texts(bare=True), lambda record: _address(record, record.source)),
    "target": (Texts(bare=True), lambda record: _address(record, record.target)),
    "carrier": (Choice("a carrier", {carrier: (carrier,) for carrier in Carrier}), lambda record: (record.carrier,)),
    "direction": (
        Choice("a direction", {direction: (direction,) for direction in Direction}),
        lambda record: _optional(record.direction),
    ),
    "interface": (Texts(bare=True), lambda record: _optional(record.interface)),
}
"""What can be asked about every frame, but for `time`, which depends on the frame that came first.

op           full name, or the family's, or the opcode's number; of a reply: that of the command it answers
command      name of the CMD, or of the system or daisy command; of a reply: that of the command it answers
type         name or number of the message type
kind         direct-command, direct-reply, system-command, ...
status       of a system reply, by name or number
error        the reply says that its command failed, or the frame has a fault
fault        what is wrong with the frame, as a sentence
orphan       a reply whose command was not seen
wants_reply  a command that the brick is to answer
counter      message counter
size         bytes of the frame
packet       number of each packet that carried it, the first in the file is 1
latency      seconds from a command to its reply
peer         address of the brick; on WiFi with its port or without, as `source` and `target` are
carrier      usb, bluetooth or wifi
direction    sent or received, where the capture says so
interface    that it was captured on
"""
