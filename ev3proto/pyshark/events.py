"""The results of tshark and the dissector for a packet, as events of a capture.

The dissector finds the frames (`ev3.bytes`), the brick (`ev3.brick`) and the conversation (`ev3.connection`) on any
carrier; Wireshark orders the streams. So a few fields of each packet are enough.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from datetime import datetime

from ev3proto.bounded import DEFAULT_MEMORY, Bounded, Budget
from ev3proto.capture import Account, Announcement, Carrier, Direction, Event, Route, Skipped, TextKind
from ev3proto.capture.conversation import Conversation
from ev3proto.capture.record import HOST, NANOSECONDS, missing_of
from ev3proto.errors import DecodeError
from ev3proto.schema.discovery import Beacon, Unlock
from ev3proto.schema.frame import frame_reader
from ev3proto.schema.header import HEADER_SIZE, may_have_length
from ev3proto.tables.discovery import ACCEPT, BEACON_LINES, UNLOCK_REQUEST

MOST_CONNECTIONS = 1024
"""Maximum number of remembered connections; the least recently used are evicted."""

_SENT = {"frame.p2p_dir": 0, "hci_mon.opcode": 4, "packetlogger.type": 2, "usb.endpoint_address.direction": 0}
"""Values in headers of USB and Bluetooth of packets from the host."""

FIELDS = (
    "frame.number",
    "frame.time_epoch",
    "frame.len",
    "frame.cap_len",
    "frame.interface_name",
    "frame.protocols",
    *_SENT,
    "bthci_acl.chandle",
    "ip.src",
    "ip.dst",
    "ipv6.src",
    "ipv6.dst",
    "udp.srcport",
    "udp.dstport",
    "tcp.srcport",
    "tcp.dstport",
    "ev3.brick",
    "ev3.bytes",
    "ev3.connection",
    "ev3.expert.bootloader_fault",
)
"""The requested fields: five times as fast as requesting all."""

_CARRIERS = {protocol: carrier for carrier in Carrier for protocol in carrier.facts.protocols}
_NO_BRACKETS = str.maketrans("", "", "[]")  # the dissector writes none around addresses of IPv6
_NO_ADDRESS = "00:00:00:00:00:00"
_BEACON_START = f"{next(iter(BEACON_LINES.values()))}: ".encode()
_REQUEST = UNLOCK_REQUEST.encode()
_TEXT_ENDS = b"\r\n\0"


class Row:
    """The fields of one packet, each with all its values in order, innermost last."""

    def __init__(self, values: dict[str, list[str]]) -> None:
        """Takes the values by the names of the fields, with underscores for dots."""
        self._values = values
        self.protocols = (self.text("frame.protocols") or "").split(":")

    def all(self, field: str) -> list[str]:
        """Returns all values of a field."""
        return self._values.get(field.replace(".", "_"), [])

    def text(self, field: str) -> str | None:
        """Returns the innermost value of a field."""
        return next(reversed(self.all(field)), None)

    def number(self, field: str) -> int:
        """Returns the innermost value as a number, 0 without the field."""
        return int(self.text(field) or "0", 0)

    def innermost(self, *protocols: str) -> str | None:
        """Returns the innermost of some protocols."""
        return next((name for name in reversed(self.protocols) if name in protocols), None)

    @property
    def packet(self) -> int:
        """The packet's number."""
        return self.number("frame.number")

    @property
    def bytes(self) -> list[bytes]:
        """What the dissector claimed: whole frames, texts, and other bytes in place of a frame."""
        return [bytes.fromhex(text.replace(":", "")) for text in self.all("ev3.bytes")]

    @property
    def time_ns(self) -> int:
        """The capture time, in nanoseconds since 1970-01-01 UTC."""
        seconds, _, fraction = (self.text("frame.time_epoch") or "0").removesuffix("Z").partition(".")
        if "T" in seconds:  # in pyshark's EK mode
            seconds = f"{datetime.fromisoformat(seconds + '+00:00').timestamp():.0f}"
        nanoseconds = int(fraction[:9].ljust(9, "0"))
        return int(seconds) * NANOSECONDS + (-nanoseconds if seconds.startswith("-") else nanoseconds)


class Events:
    """A converter of the packets of one capture, in order, to events."""

    def __init__(self, account: Account, dialect: str, memory: int = DEFAULT_MEMORY) -> None:
        """Starts before the first packet; unanswered commands may take some bytes of memory."""
        self._account = account
        self._schema = frame_reader(dialect)
        self._budget = Budget(memory)
        self._conversations: Bounded[int, Conversation] = Bounded(MOST_CONNECTIONS)
        self._routes: Bounded[Route, Route] = Bounded(MOST_CONNECTIONS)

    def of(self, row: Row) -> Iterator[Event]:
        """Yields the events of the frames and texts that end in a packet."""
        self._count(row)
        found, carrier = row.bytes, row.innermost(*_CARRIERS)
        if not found or carrier is None or row.innermost("icmp", "icmpv6"):
            return
        route = self._route(row, _CARRIERS[carrier])
        for data in found:
            event = self._event(row, data, route)
            if event is not None:
                yield event
        self._account.forgotten = self._budget.dropped

    def _count(self, row: Row) -> None:
        account, captured = self._account, row.number("frame.cap_len")
        account.packets += 1
        account.captured += captured
        account.other += captured
        account.cut += row.number("frame.len") > captured
        account.last_ns = row.time_ns
        if account.first_ns is None:
            account.first_ns = account.last_ns

    def _route(self, row: Row, carrier: Carrier) -> Route:
        brick = row.text("ev3.brick") or ""
        if carrier is Carrier.WIFI:
            source, target = _place(row, "src"), _place(row, "dst")
            is_udp = row.innermost("tcp", "udp") == "udp"
            is_sent = not _is_beacon(row) if is_udp else brick == target.translate(_NO_BRACKETS)
            brick = target if is_sent else source
        else:
            is_sent = any(row.text(field) and row.number(field) == value for field, value in _SENT.items())
            if brick == _NO_ADDRESS:
                brick = f"handle 0x{row.number('bthci_acl.chandle'):04x}"
            source, target = (HOST, brick) if is_sent else (brick, HOST)
        interface = row.text("frame.interface_name")
        interface = None if interface == "unknown" else interface
        direction = Direction.SENT if is_sent else Direction.RECEIVED
        route = Route(carrier, source, target, direction, interface, brick)
        return self._routes.use(route, lambda: route)[0]

    def _event(self, row: Row, data: bytes, route: Route) -> Event | None:
        """Returns the event of a claimed piece: a text, a frame, or neither; None for the end of a text."""
        place = (row.packet,), row.time_ns, route
        said = _text_kind(row, data)
        if said is not None or not data.strip(_TEXT_ENDS):
            self._move("texts", len(data))
            return None if said is None else Announcement(said, data, _parsed(said, data), *place)
        # Packets without a frame have no number.
        number = row.number("ev3.connection")
        if not number or len(data) < HEADER_SIZE or not may_have_length(data):
            self._move("skipped", len(data))
            return Skipped(data, 0, "the dissector finds no frame in these bytes", row.packet, row.time_ns, route)
        self._move("frames", len(data))
        talk = self._conversations.use(number, lambda: Conversation(self._schema, self._budget))[0]
        talk.number = number
        if row.all("ev3.expert.bootloader_fault"):
            return talk.overwritten(data, *place)
        record = talk.record(data, *place)
        if row.number("frame.cap_len") < row.number("frame.len"):
            record.missing = missing_of(data)
        return record

    def _move(self, part: str, size: int) -> None:
        setattr(self._account, part, getattr(self._account, part) + size)
        self._account.other -= size


def _text_kind(row: Row, data: bytes) -> TextKind | None:
    """Returns the kind of text of a piece, None for frames."""
    if row.innermost("tcp", "udp") == "udp":
        return TextKind.BEACON if _is_beacon(row) else TextKind.ANSWER
    if data.startswith(_REQUEST):
        return TextKind.UNLOCK
    return TextKind.ACCEPT if data.startswith(ACCEPT) else None


def _is_beacon(row: Row) -> bool:
    return row.bytes[0].startswith(_BEACON_START)


def _parsed(said: TextKind, data: bytes) -> Beacon | Unlock | None:
    """Returns the parsed text; None for answers and faulty texts."""
    with suppress(DecodeError):
        if said is TextKind.BEACON:
            return Beacon.parse(data)
        if said is TextKind.UNLOCK:
            return Unlock.parse(data)
    return None


def _place(row: Row, end: str) -> str:
    """Returns address and port of one end: `192.0.2.1:5555`."""
    address = row.text(f"{row.innermost('ip', 'ipv6')}.{end}") or ""
    port = row.text(f"{row.innermost('tcp', 'udp')}.{end}port")
    return f"[{address}]:{port}" if ":" in address else f"{address}:{port}"
