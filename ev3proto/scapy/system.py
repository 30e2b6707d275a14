"""System commands and their replies: a number, then a packet with the fields that the tables declare."""

from __future__ import annotations

import io
from typing import Any

from scapy.fields import ByteEnumField, ByteField, Field, FieldLenField, LEIntField, LEShortField, StrField
from scapy.packet import Packet, Raw, bind_layers

from ev3proto.errors import DecodeError
from ev3proto.schema.fields import REPLIES
from ev3proto.schema.wire_format import counted_text
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.system import SYSTEM, FieldKind, SystemDeclaration, SystemField, SystemStatus

PREFIX, BOOTLOADER, REPLY = "SYS_", "BOOTLOADER_", "_REPLY"
"""Prefixes and suffixes of layer names; the bootloader reuses names of the firmware."""

RENAMED = {
    "name": "mailbox",
    "name_length": "mailbox_length",
    "payload": "message",
    "payload_length": "message_length",
}
"""Fields whose names are reserved in Scapy packets, and those that count them."""


_COUNTED = counted_text("length")


class TextField(Field[str, bytes]):
    """A text in ISO-8859-1: up to its zero, or with `to_end` up to the end of the frame."""

    __slots__ = ["to_end"]

    def __init__(self, name: str, *, to_end: bool = False) -> None:
        self.to_end = to_end
        super().__init__(name, "", "s")

    def any2i(self, pkt: Packet | None, x: Any) -> Any:  # noqa: ARG002 - scapy's names and arguments, here and below
        """Returns a text, also for bytes."""
        return x.decode(STRING_CODING) if isinstance(x, bytes) else x

    def i2len(self, pkt: Packet, x: Any) -> int:  # noqa: ARG002
        """Returns its size in the frame in bytes, including the zero."""
        return len(x) + (not self.to_end)

    def addfield(self, pkt: Packet, s: bytes, val: Any) -> bytes:  # noqa: ARG002
        """Appends the text. Raises UnicodeEncodeError for characters that the brick lacks."""
        return s + str(val).encode(STRING_CODING) + (b"" if self.to_end else b"\0")

    def getfield(self, pkt: Packet, s: bytes) -> tuple[bytes, str]:  # noqa: ARG002
        """Returns the bytes after the text, and the text. Raises DecodeError."""
        if self.to_end:
            return b"", s.decode(STRING_CODING)
        text, zero, rest = s.partition(b"\0")
        if not zero:
            raise DecodeError(len(s), f"the terminating zero of {self.name} is missing", truncated=True)
        return rest, text.decode(STRING_CODING)

    def randval(self) -> None:  # type: ignore[override]
        """Keeps texts unchanged."""
        return


class CountedTextField(TextField):
    """A text after its length. Some senders include its zero in the length, some do not."""

    __slots__ = ["counter"]

    def __init__(self, name: str, counter: str) -> None:
        self.counter = counter
        super().__init__(name)

    def getfield(self, pkt: Packet, s: bytes) -> tuple[bytes, str]:
        """Returns the bytes after the text and its zero, and the text. Raises ConstructError."""
        stream = io.BytesIO(s)
        text = _COUNTED.parse_stream(stream, length=int(pkt.getfieldval(self.counter)))
        return s[stream.tell() :], text


def layer_name(entry: SystemDeclaration) -> str:
    """Returns the name of a layer: `SYS_LIST_FILES`, `SYS_BOOTLOADER_START_APP`."""
    return PREFIX + (BOOTLOADER if entry.bootloader else "") + entry.name


NAMES = {entry.number: layer_name(entry).removeprefix(PREFIX) for entry in SYSTEM}
STATUSES = {status.value: status.name for status in SystemStatus}


class EV3SystemCommand(Packet):
    """A system command: its number. Its fields follow as a separate packet."""

    name = "EV3 system command"
    fields_desc = [ByteEnumField("number", SYSTEM[0].number, NAMES)]  # noqa: RUF012 - scapy's way, here and below


class EV3SystemReply(Packet):
    """The answer to a system command: its number and status. Its fields follow as a separate packet."""

    name = "EV3 system reply"
    fields_desc = [  # noqa: RUF012
        ByteEnumField("number", SYSTEM[0].number, NAMES),
        ByteEnumField("status", SystemStatus.SUCCESS.value, STATUSES),
    ]

    def guess_payload_class(self, payload: bytes) -> type[Packet]:
        """Returns the layer of the fields if they are complete: the answer to a failed command may be shorter."""
        schema = REPLIES.get(self.number)
        if schema is None or schema.read_leniently(payload, 0, complete=True)[2] is not None:
            return Raw
        return super().guess_payload_class(payload)

    def answers(self, other: Packet) -> int:
        """Returns whether this is the reply to that command."""
        return int(isinstance(other, EV3SystemCommand) and self.number == other.number)


def _name(declared: SystemField) -> str:
    return RENAMED.get(declared.name, declared.name)


_NUMBERS = {FieldKind.U8: ("B", ByteField), FieldKind.U16: ("<H", LEShortField), FieldKind.U32: ("<I", LEIntField)}


def _field(declared: SystemField, all_of_it: tuple[SystemField, ...]) -> Field[Any, Any]:
    name = _name(declared)
    if declared.kind in _NUMBERS:
        layout, field = _NUMBERS[declared.kind]
        if declared.counts is None:
            return field(name, 0)
        counted = next(other for other in all_of_it if other.name == declared.counts)
        return FieldLenField(name, None, length_of=_name(counted), fmt=layout)
    if declared.kind is FieldKind.COUNTED_TEXT:
        return CountedTextField(name, next(_name(other) for other in all_of_it if other.counts == declared.name))
    if declared.kind is FieldKind.DATA:
        return StrField(name, b"")
    return TextField(name, to_end=declared.kind is FieldKind.LISTING)


def _layer(name: str, entry: SystemDeclaration, fields: tuple[SystemField, ...]) -> type[Packet]:
    described = {"name": name, "fields_desc": [_field(declared, fields) for declared in fields], "__doc__": entry.text}
    make: Any = type(Packet)
    layer: type[Packet] = make(name, (Packet,), {**described, "__module__": __package__})
    return layer


def _layers() -> dict[str, type[Packet]]:
    found: dict[str, type[Packet]] = {}
    for entry in SYSTEM:
        name = layer_name(entry)
        sides = ((name, EV3SystemCommand, entry.request), (name + REPLY, EV3SystemReply, entry.reply))
        for own_name, below, fields in sides:
            found[own_name] = _layer(own_name, entry, fields)
            bind_layers(below, found[own_name], number=entry.number)
    return found


def _bodies() -> dict[type[Packet], type[Packet]]:
    bodies = {"": EV3SystemCommand, REPLY: EV3SystemReply}
    return {SYSTEM_LAYERS[layer_name(entry) + side]: below for entry in SYSTEM for side, below in bodies.items()}


SYSTEM_LAYERS = _layers()
"""The fields of every system command and of every reply, by the names of their layers."""

SYSTEM_BODIES = _bodies()
"""The body that contains each of them."""
