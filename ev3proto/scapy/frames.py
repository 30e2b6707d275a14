"""The frame as a layer, the bodies of all message types, and the splitting of streams."""

from __future__ import annotations

from typing import Any

from construct import Bytes, GreedyBytes
from scapy.fields import (
    BitField,
    ByteEnumField,
    ByteField,
    ConditionalField,
    Field,
    LEShortField,
    StrField,
    StrFixedLenField,
)
from scapy.layers.inet import TCP, UDP
from scapy.packet import NoPayload, Packet, Padding, Raw, bind_bottom_up, bind_layers, bind_top_down

from ev3proto.errors import BuildError, DecodeError
from ev3proto.scapy.operations import EV3Operation, OperationsField, command_of, in_a_row
from ev3proto.scapy.system import SYSTEM_BODIES, EV3SystemCommand, EV3SystemReply
from ev3proto.schema.discovery import Unlock
from ev3proto.schema.frame_buffer import FrameBuffer, OutOfStep
from ev3proto.schema.header import HEADER_SIZE, MEMORY_SIZE, Header, build_frame
from ev3proto.schema.wire_format import SENSOR_REPORT
from ev3proto.tables.daisy import DaisySubCommand
from ev3proto.tables.discovery import ACCEPT, BEACON_PORT, MOST_UNLOCK, TCP_PORT, UNLOCK_REQUEST
from ev3proto.tables.frame import (
    GLOBAL_BITS,
    LENGTH_FIELD,
    LOCAL_BITS,
    MAX_GLOBALS,
    MAX_LOCALS,
    MESSAGE_TYPES,
    MessageType,
)

_REQUEST = UNLOCK_REQUEST.encode()
_TYPES = {number: member.name for number, member in MESSAGE_TYPES.items()}


class EV3Text(Packet):
    """A text besides frames on WiFi: beacon, unlock text, the brick's answer to it."""

    name = "EV3 text"
    fields_desc = [StrField("text", b"")]  # noqa: RUF012 - scapy's way to declare a packet, here and below


class EV3(Packet):
    """A frame: length (computed if None), message counter and message type. The body follows."""

    name = "EV3"
    fields_desc = [  # noqa: RUF012
        LEShortField("length", None),
        LEShortField("counter", 0),
        ByteEnumField("type", MessageType.DIRECT_COMMAND_NO_REPLY.value, _TYPES),
    ]

    @classmethod
    def dispatch_hook(cls, _pkt: bytes | None = None, *args: Any, **kwargs: Any) -> type[Packet]:  # noqa: ARG003
        """Returns the layer of bytes: on WiFi, a connection starts with texts."""
        return EV3Text if _pkt and _pkt.startswith((_REQUEST, ACCEPT)) else cls

    @classmethod
    def tcp_reassemble(cls, data: bytes, metadata: Any, session: Any) -> Packet | None:  # noqa: ARG003
        """Returns the first frame or text of a stream, with the rest as padding; None while it is not complete."""
        if data.startswith((_REQUEST[: len(data)], ACCEPT[: len(data)])):
            return _text(data)
        found = FrameBuffer(data, polls=False).next()
        if isinstance(found, OutOfStep):
            return Raw(data)  # the start of the next frame is unknown
        return None if found is None else cls(data)

    def extract_padding(self, s: bytes) -> tuple[bytes, bytes]:
        """Returns the body, and the bytes after the frame."""
        end = max(int(self.length) + LENGTH_FIELD - HEADER_SIZE, 0)
        return s[:end], s[end:]

    def add_payload(self, payload: Any) -> None:
        """Adds a body to the frame.

        Args:
            payload: A body; or an operation or the fields of a system message, which get a body. That
                of operations requests the memory that they use, and the frame a reply if they write to it.
        """
        if not isinstance(self.payload, NoPayload) or not isinstance(payload, Packet):
            super().add_payload(payload)
        elif isinstance(payload, EV3Operation):
            super().add_payload(EV3DirectCommand(operations=[]))
            self.payload.add_payload(payload)
        else:
            below = SYSTEM_BODIES.get(type(payload))
            super().add_payload(payload if below is None else below() / payload)

    def post_build(self, pkt: bytes, pay: bytes) -> bytes:
        """Fills in the length if it is not given.

        Args:
            pkt: The header.
            pay: The body.

        Returns:
            The frame.

        Raises:
            BuildError: The frame is longer than a brick accepts. A given length is not checked.
        """
        if self.length is None:
            _, counter, code = Header.read(pkt)
            return build_frame(code, counter, pkt[HEADER_SIZE:] + pay)
        return pkt + pay

    def hashret(self) -> bytes:
        """Returns what command and reply have in common."""
        member = _member(self)
        return f"{self.counter} {'' if member is None else member.carries}".encode()

    def answers(self, other: Packet) -> int:
        """Returns whether this is the reply to that command."""
        own, others = _member(self), _member(other)
        if own is None or others is None or own.is_command or not others.wants_reply:
            return 0
        if (own.carries, self.counter) != (others.carries, other.counter):
            return 0
        return int(not isinstance(self.payload, EV3SystemReply) or self.payload.answers(other.payload))


def _member(packet: Packet) -> MessageType | None:
    return MESSAGE_TYPES.get(packet.type) if isinstance(packet, EV3) else None


def _text(data: bytes) -> Packet | None:
    """Returns the text at the start of a stream, or None."""
    if data.startswith(ACCEPT):
        end = len(ACCEPT) + data[len(ACCEPT) :].startswith(b"\0")
    elif not data.startswith(_REQUEST):
        return None
    else:
        try:
            _, end = Unlock.read(data)
        except DecodeError:
            return None if len(data) < MOST_UNLOCK else Raw(data)
    text: Packet = EV3Text(data[:end])
    return text / Padding(data[end:]) if data[end:] else text


_MOST = {"local_size": MAX_LOCALS, "global_size": MAX_GLOBALS}


class SizeField(BitField):
    """A number of bytes of memory, as a bit field."""

    def any2i(self, pkt: Packet | None, x: Any) -> Any:
        """Returns the number. Raises BuildError for one that does not fit; a plain bit field would truncate it."""
        most = _MOST[self.name]
        if isinstance(x, int) and not 0 <= x <= most:
            raise BuildError(f"{self.name} cannot be {x}: a header can request 0 to {most} bytes")
        return super().any2i(pkt, x)


class EV3DirectCommand(Packet):
    """Operations for the brick's virtual machine, and bytes of memory for them: local 0 to 63, global 0 to 1023."""

    name = "EV3 direct command"
    # One little-endian number, which scapy expresses by a negative size.
    fields_desc = [  # noqa: RUF012
        SizeField("local_size", 0, LOCAL_BITS, tot_size=-MEMORY_SIZE),
        SizeField("global_size", 0, GLOBAL_BITS, end_tot_size=-MEMORY_SIZE),
        OperationsField("operations"),
    ]

    def add_payload(self, payload: Any) -> None:
        """Appends an operation and requests its memory. Nothing else can follow operations."""
        if not isinstance(payload, EV3Operation):
            super().add_payload(payload)
            return
        operations: list[Packet] = [*self.getfieldval("operations"), *in_a_row(payload)]
        made = command_of(operations)
        self.setfieldval("operations", operations)
        self.setfieldval("local_size", max(self.getfieldval("local_size"), made.local_size))
        self.setfieldval("global_size", max(self.getfieldval("global_size"), made.global_size))
        frame = self.underlayer
        if made.wants_reply and isinstance(frame, EV3) and "type" not in frame.fields:
            frame.type = MessageType.DIRECT_COMMAND_REPLY.value


class EV3DirectReply(Packet):
    """The answer to a direct command: all of its global memory."""

    name = "EV3 direct reply"
    fields_desc = [StrField("memory", b"")]  # noqa: RUF012


_CARRIES_OPERATIONS = {member.value for member in DaisySubCommand if member.carries_operations}


class EV3DaisyCommand(Packet):
    """A message between bricks."""

    name = "EV3 daisy command"
    fields_desc = [  # noqa: RUF012
        ByteEnumField(
            "number", DaisySubCommand.DOWNSTREAM.value, {member.value: member.name for member in DaisySubCommand}
        ),
        ByteField("layer_from", 0),
        ByteField("layer_to", 1),
        ConditionalField(OperationsField("operations"), lambda packet: packet.number in _CARRIES_OPERATIONS),
    ]


def _report_field(part: Any) -> Field[Any, Any]:
    """Returns the field of a part of a sensor report, from its schema."""
    if part.subcon is GreedyBytes:
        return StrField(part.name, b"")
    if isinstance(part.subcon, Bytes):
        return StrFixedLenField(part.name, bytes(part.subcon.length), part.subcon.length)
    return ByteField(part.name, 0)


class EV3SensorReport(Packet):
    """A sensor of another layer."""

    name = "EV3 sensor report"
    fields_desc = [_report_field(part) for part in SENSOR_REPORT.subcons]  # noqa: RUF012


_REPORT_SIZE = sum(part.sizeof() for part in SENSOR_REPORT.subcons if part.subcon is not GreedyBytes)


class EV3DaisyReply(Packet):
    """The answer between bricks."""

    name = "EV3 daisy reply"
    fields_desc = [ByteField("layer_from", 1), ByteField("layer_to", 0)]  # noqa: RUF012

    def guess_payload_class(self, payload: bytes) -> type[Packet]:
        """Returns the layer of a sensor's data if the payload is long enough."""
        return EV3SensorReport if len(payload) >= _REPORT_SIZE else super().guess_payload_class(payload)


_BODIES: dict[str, type[Packet]] = {
    "direct-command": EV3DirectCommand,
    "direct-reply": EV3DirectReply,
    "system-command": EV3SystemCommand,
    "system-reply": EV3SystemReply,
    "daisy-command": EV3DaisyCommand,
    "daisy-reply": EV3DaisyReply,
}

_USUAL = (
    MessageType.DIRECT_COMMAND_NO_REPLY,
    MessageType.DIRECT_REPLY,
    MessageType.SYSTEM_COMMAND_REPLY,
    MessageType.SYSTEM_REPLY,
    MessageType.DAISY_COMMAND_REPLY,
    MessageType.DAISY_REPLY,
)
"""The default type of a frame, by its body."""

for _type in MessageType:
    bind_bottom_up(EV3, _BODIES[_type.kind], type=_type.value)
for _type in _USUAL:
    bind_top_down(EV3, _BODIES[_type.kind], type=_type.value)

bind_layers(TCP, EV3, dport=TCP_PORT)
bind_bottom_up(TCP, EV3, sport=TCP_PORT)
bind_bottom_up(UDP, EV3Text, dport=BEACON_PORT)
