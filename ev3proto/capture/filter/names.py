"""The names in filters, and their values in a record.

Lower case   properties of every frame: `op`, `peer`, `latency`, ...; `NAMES` lists them all.
Any case     parameters and fields of the tables: `FREQUENCY`, `path`, ... If a property has the same name
             (`TYPE`, `SIZE`, `TIME`, ...), upper case means the parameter.
With a dot   a parameter of one operation, family or system command (`SOUND.TONE.VOLUME`, `BEGIN_DOWNLOAD.size`),
             or, after `arg.`, of any.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from enum import Enum
from typing import Any

from ev3proto.capture.dialogues import is_error
from ev3proto.capture.filter.fields import PATH, command_names, find_field, is_parameter, operation_names, places_of
from ev3proto.capture.filter.values import SECONDS, FilterValue, Kind, Name, Word
from ev3proto.capture.record import NANOSECONDS, Direction, Record
from ev3proto.errors import near_misses
from ev3proto.messages import DaisyCommand, Message, Operation, SystemCommand, SystemReply
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SystemStatus

TIME = "time"
"""The one name that also depends on the beginning of the capture."""

LATE_MS = 100
"""Milliseconds after which a reply is late. Bricks answer within 10 by USB and WiFi, within 60 by Bluetooth."""


def find_name(word: Word, time: Callable[[Record], float]) -> Name:
    """Looks up a name; `time` returns the seconds from the beginning of the capture to a record. Raises FilterError."""
    lower = word.text.lower()
    known = None if word.text.isupper() and is_parameter(lower) else NAMES.get(lower)
    if known is not None:
        return known if lower != TIME else _known(known.kind, lambda record: (time(record),))
    field = find_field(word.text)
    if field is None:
        raise word.error(_unknown(word.text))
    if lower != PATH:
        return field

    def read_with_path(record: Record) -> Iterator[FilterValue]:
        # Only the first message of a transfer has the path, but a filter for a path should find the whole transfer.
        yield from field.read(record)
        if record.transfer is not None:
            yield FilterValue(record.transfer.path)

    return Name(field.kind, read_with_path)


# Properties of every frame


def operations_of(record: Record) -> tuple[Operation, ...]:
    """Returns the operations of a command; for a reply, those of its command."""
    message = record.message if record.request is None else record.request.message
    found: tuple[Operation, ...] = getattr(message, "operations", ())
    return found


def _operations(record: Record) -> Iterator[str | int]:
    """Yields the full name, the family and the number of each."""
    for operation in operations_of(record):
        yield from (operation.full_name, operation.name, operation.opcode)


def _commands(record: Record) -> list[str]:
    message = record.message
    if record.request is not None and not isinstance(message, SystemReply):
        message = record.request.message
    named = [operation.command for operation in operations_of(record) if operation.command is not None]
    if isinstance(message, SystemCommand | SystemReply | DaisyCommand) and message.command is not None:
        named.append(message.command)
    return named


def _named(member: Enum | None) -> tuple[str | int, ...]:
    return () if member is None else (member.name, member.value)


def _status(record: Record) -> tuple[str | int, ...]:
    code = record.message.status_code if isinstance(record.message, SystemReply) else None
    return _named(SystemStatus(code)) if code in _STATUSES else () if code is None else (code,)


_STATUSES = {status.value for status in SystemStatus}


def _address(which: str, text: str, example: str) -> Name:
    """Describes an address; on WiFi it also matches without its port."""

    def read(record: Record) -> tuple[str, ...]:
        address: str = getattr(record, which)
        host = address.rpartition(":")[0] if record.carrier is Carrier.WIFI else ""
        return (address, host, host.strip("[]")) if host else (address,)

    return _known(_BARE_TEXT, read, text, example)


def _unanswered(record: Record) -> bool:
    # A bootloader's reply may have its command's type, and does not wait for a reply itself.
    return record.message.wants_reply and record.answered is None and record.request is None


def _late(record: Record) -> bool:
    begin, end = record.time_ns, record.time_ns
    if record.request is not None:
        begin = record.request.time_ns
    elif record.answered is not None:
        end = record.answered.time_ns
    return end - begin > LATE_MS * NANOSECONDS // 1000


def _meant(word: str) -> str:
    upper = word.upper()
    if upper in operation_names():
        return f"; it is an operation: op=={upper}"
    return f"; it is a command: command=={upper}" if upper in command_names() else ""


def _is_member_of(name: str) -> Callable[[str], str]:
    def hint(word: str) -> str:
        field = find_field(name)
        known = field is not None and any(word.upper() in enum.members for enum in field.kind.enums)
        return f"; it is a value of the parameter {name}, in upper case" if known else ""

    return hint


def _one_of(
    what: str, names: Iterable[str], hint: Callable[[str], str] = lambda _: "", *, number: bool = False
) -> Kind:
    return Kind(what, text=True, is_bare=True, names=tuple(names), hint=hint, number=number)


def _known(
    kind: Kind, read: Callable[[Record], Iterable[Any]], text: str = "", example: str = "", looks_ahead: bool = False
) -> Name:
    unit = next(iter(kind.units), None)
    return Name(
        kind, lambda record: [FilterValue(value, None, unit) for value in read(record)], text, example, looks_ahead
    )


_KINDS = dict.fromkeys([*(member.kind for member in MessageType), Message().kind])

_FLAG = Kind("truth value", text=True, is_bare=True, names=("true", "false"), number=True, is_flag=True)


def _flag(is_true: Callable[[Record], bool], text: str, example: str, looks_ahead: bool = False) -> Name:
    return _known(_FLAG, lambda record: ("true", 1) if is_true(record) else ("false", 0), text, example, looks_ahead)


_NUMBER = Kind("a number", number=True)
_DURATION = Kind("a time in seconds, such as 4ms", number=True, units=SECONDS, is_exact=True)
_BARE_TEXT = Kind("a text", text=True, is_bare=True)


def _text(text: str | None) -> tuple[str, ...]:
    return () if text is None else (str(text),)


NAMES = {
    "op": _known(
        _one_of("operation", operation_names(), _meant, number=True),
        _operations,
        "operation by full name, family or opcode; for a reply, that of its command",
        "op == SOUND.TONE",
    ),
    "command": _known(
        _one_of("command", command_names(), _meant),
        _commands,
        "name of the CMD, system command or daisy command; for a reply, that of its command",
        "command == LIST_FILES",
    ),
    "type": _known(
        _one_of("message type", MessageType.__members__, _is_member_of("TYPE"), number=True),
        lambda record: _named(record.message.type),
        "message type by name or number",
        "type == DIRECT_COMMAND_NO_REPLY",
    ),
    "kind": _known(
        _one_of("kind of message", _KINDS),
        lambda record: (record.message.kind,),
        f"one of {', '.join(_KINDS)}",
        "kind like system-*",
    ),
    "status": _known(
        _one_of("system status", SystemStatus.__members__, _is_member_of("STATUS"), number=True),
        _status,
        "status of a system reply by name or number",
        "status == END_OF_FILE",
    ),
    "error": _flag(
        lambda record: is_error(record.message) or record.fault is not None,
        "a reply that reports a failed command, or a frame with a fault",
        "error",
    ),
    "failed": _flag(
        lambda record: is_error(record.message) or (record.answered is not None and record.answered.failed),
        "a command that failed, and its reply",
        "failed && op",
        True,
    ),
    "late": _flag(_late, f"a reply that came more than {LATE_MS} ms after its command, and that command", "late", True),
    "unanswered": _flag(
        _unanswered, "a command that wants a reply and got none before the capture ended", "unanswered", True
    ),
    "fault": _known(
        Kind("a text", text=True),
        lambda record: _text(record.fault and record.fault.reason),
        "the fault of the frame, as a sentence",
        'fault contains "opcode"',
    ),
    "orphan": _flag(lambda record: record.exchange.is_orphan, "a reply whose command was not captured", "orphan"),
    "wants_reply": _flag(lambda record: record.message.wants_reply, "a command that wants a reply", "wants_reply"),
    "counter": _known(
        _NUMBER,
        lambda record: () if record.message.type is None else (record.message.counter,),
        "message counter",
        "counter == 1",
    ),
    "size": _known(_NUMBER, lambda record: (len(record.frame),), "bytes of the frame", "size > 100"),
    "missing": _known(
        _NUMBER,
        lambda record: (record.missing,) if record.missing else (),
        "bytes at the end of the frame that the capture or the text has left out",
        "missing",
    ),
    "packet": _known(
        _NUMBER,
        lambda record: record.numbers,
        "numbers of the packets that carried it, from 1; in a text, its line",
        "packet in {10..20}",
    ),
    "latency": _known(
        _DURATION,
        lambda record: () if record.latency is None else (record.latency,),
        "time from a command to its reply",
        "latency > 4ms",
    ),
    TIME: _known(
        _DURATION,
        lambda record: (record.time_ns / NANOSECONDS,),
        "time since the capture began, as shown before each frame",
        "time < 1.5s",
    ),
    "peer": _address("peer", "address of the brick; on WiFi with or without the port", "peer == 192.0.2.10"),
    "source": _address("source", "address of the sender, likewise", 'source like "192.0.2.*"'),
    "target": _address("target", "address of the receiver, likewise", "target == 192.0.2.10:5555"),
    "carrier": _known(
        _one_of("carrier", Carrier),
        lambda record: () if record.carrier is None else _text(record.carrier),
        f"one of {', '.join(Carrier)}",
        "carrier == bluetooth",
    ),
    "direction": _known(
        _one_of("direction", Direction),
        lambda record: _text(record.direction),
        f"one of {', '.join(Direction)}, if known",
        "direction == received",
    ),
    "connection": _known(
        Kind("a number or a label", number=True, text=True, is_bare=True),
        lambda record: (record.connection, record.label) if record.label else (record.connection,),
        "number of the conversation with a brick, in the order in which they began; in a text, also its label",
        "connection == 2",
    ),
    "interface": _known(
        _BARE_TEXT, lambda record: _text(record.interface), "interface on which it was captured", "interface"
    ),
}
"""The properties of every frame."""

_OF_WIRESHARK = {
    "op": "_ws.col.info ev3.answers ev3.cmd ev3.op ev3.opcode",
    "fault": "_ws.expert _ws.malformed ev3.expert.fault ev3.expert.unknown_opcode",
    "connection": "ev3.connection tcp.stream",
    "peer": "btatt.handle bluetooth.addr ip.addr ipv6.addr tcp.port usb.addr usb.bus_id usb.device_address",
    "target": "bluetooth.dst ip.dst ipv6.dst",
    "source": "bluetooth.src ip.src ipv6.src",
    "type": "ev3.cmd_type ev3.type",
    "counter": "ev3.counter ev3.msg_num",
    "command": "ev3.daisy.command ev3.sys_cmd",
    "failed": "ev3.expert.error_reply",
    "orphan": "ev3.expert.orphan",
    "unanswered": "ev3.expert.unanswered",
    "latency": "ev3.latency ev3.request_in ev3.response_in ev3.response_time frame.time_delta",
    "size": "ev3.msg_len ev3.length frame.len",
    "status": "ev3.reply_status ev3.status",
    "path": "ev3.transfer.path",
    "interface": "frame.interface_name",
    "packet": "frame.number",
    "time": "frame.time frame.time_relative",
}
"""The fields of Wireshark that correspond to a name."""


def _unknown(text: str) -> str:
    upper, lower = text.upper(), text.lower()
    for name, fields in _OF_WIRESHARK.items():
        if lower in fields.split():
            return f"{text} is a name of Wireshark; here it is {name}"
    own = upper.removeprefix("EV3.")
    if own != upper and find_field(own) is not None:
        return f"{text} is a name of Wireshark; here it is {own if '.' in own else own.lower()}"
    owner, _, name = upper.rpartition(".")
    if owner in operation_names() and is_parameter(name):
        return f"{owner} has no parameter {name}"
    return f"unknown field {text!r}{_meant(text) or _near(text, is_dotted=bool(owner)) or '; see --help-filter'}"


def _near(text: str, *, is_dotted: bool) -> str:
    places = places_of()
    dotted = [f"{owner}.{name}" for name, owners in places.items() for owner in owners] if is_dotted else ()
    return near_misses(text, [*places, *NAMES, *dotted])
