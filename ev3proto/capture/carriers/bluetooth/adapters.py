"""Bluetooth between host and controller: connections, L2CAP channels, and RFCOMM in them.

A capture may begin before or after any of them was set up, so RFCOMM is recognised by its checksum, on any L2CAP
channel. A packet that the capture has cut is accepted on a channel that had a whole one.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

from ev3proto.bounded import Bounded
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import HOST
from ev3proto.tables.carriers import RFCOMM_DATA, RFCOMM_POLL, Link

ACL = struct.Struct("<HH")
"""The header of a data packet: handle and length. The upper bits of the handle tell whether it starts a packet."""

L2CAP = struct.Struct("<HH")
"""The header of an L2CAP packet: length and channel."""

DIRECTION = struct.Struct(">I")
"""Whether the packet after it was received."""

_MONITOR = struct.Struct(">HH")
"""The header that Linux's monitor writes before each packet: adapter and kind."""

COMMAND_PACKET, ACL_PACKET, EVENT_PACKET = 1, 2, 4
"""Packet types of HCI."""

_MONITOR_KINDS = {3: (EVENT_PACKET, True), 4: (ACL_PACKET, False), 5: (ACL_PACKET, True)}
_RECEIVED = 1

CONNECTED, DISCONNECTED, COMMAND_COMPLETE = 0x03, 0x05, 0x0E
"""Events."""

_LEAST_OF_EVENT = {CONNECTED: 9, DISCONNECTED: 3, COMMAND_COMPLETE: 10}
"""Bytes of an event that is whole."""

READ_ADDRESS = 0x1009
"""The command that requests a controller's own address."""

HANDLE_BITS = 12
_HANDLE_MASK = (1 << HANDLE_BITS) - 1
_GOES_ON = 1

_LEAST_DYNAMIC = 0x40
"""The first L2CAP channel that is given to services."""

OPEN, DONE, REFUSED, CLOSED = 0x2F, 0x63, 0x0F, 0x43
"""RFCOMM's frame types besides data: they open and close ports."""

_FRAME_TYPES = {RFCOMM_DATA, OPEN, DONE, REFUSED, CLOSED}
MOST_CONNECTIONS = 64
"""Maximum number of connections of all adapters together. An adapter has 7 at most."""

MOST_CHANNELS = 128
"""Maximum number of remembered RFCOMM channels of a connection."""

MOST_ADAPTERS = 1024
"""Maximum number of adapters whose own addresses are remembered."""


def _check_table() -> bytes:
    table = bytearray()
    for byte in range(256):
        for _ in range(8):
            byte = byte >> 1 ^ (0xE0 if byte & 1 else 0)
        table.append(byte)
    return bytes(table)


_CHECK = _check_table()


def frame_check(data: bytes) -> int:
    """Returns RFCOMM's checksum (TS 07.10, 5.2.1.6)."""
    rest = 0xFF
    for byte in data:
        rest = _CHECK[rest ^ byte]
    return 0xFF - rest


class Serial(NamedTuple):
    """The contents of an RFCOMM frame."""

    channel: int  # the serial port's number
    is_from_host: bool
    data: bytes  # the bytes; empty in frames that open or close ports
    missing: int  # number of further bytes that were not captured
    is_turn: bool  # it opens or closes the port


class Ports(NamedTuple):
    """The addresses of both ends of a connection."""

    host: str
    device: str


class Closed(NamedTuple):
    """A closed connection."""

    ends: Ports  # as in `Carried`
    key: tuple[object, int, int]


class Carried(NamedTuple):
    """A whole L2CAP packet."""

    ends: Ports  # both ends of the connection
    key: tuple[object, int, int]  # the connection: adapter, handle, and a number, as handles are reused
    serial: Serial | None  # the RFCOMM frame in it; None for other traffic
    weight: int  # captured bytes of all packets that carried it


@dataclass(slots=True)
class _Part:
    """The beginning of an L2CAP packet."""

    data: bytes
    size: int
    weight: int


@dataclass(slots=True)
class _Connection:
    address: str | None
    generation: int
    # the L2CAP channels of RFCOMM, with their directions
    channels: set[tuple[bool | None, int]] = field(default_factory=set)
    parts: dict[object, _Part] = field(default_factory=dict)


class Bluetooth:
    """A reader of the traffic between one computer's adapters and their controllers."""

    def __init__(self) -> None:
        self._connections: dict[tuple[object, int], _Connection] = {}
        self._own: Bounded[object, str] = Bounded(MOST_ADAPTERS)
        self._generation = 0

    def feed(self, packet: Packet) -> Iterator[Carried | Closed | int]:
        """Yields what a packet completes; a number is the captured bytes of other traffic."""
        kind, is_from_host, body = _unwrap(packet)
        adapter: object = packet.interface if packet.interface.link != Link.BLUETOOTH_MONITOR else _adapter(packet)
        if kind == ACL_PACKET and len(body) >= ACL.size:
            yield from self._data(adapter, is_from_host, body, len(packet.data))
            return
        if kind == EVENT_PACKET:
            yield from self._event(adapter, body)
        yield len(packet.data)

    def pending(self) -> int:
        """Returns the captured bytes of incomplete L2CAP packets."""
        parts = (part for connection in self._connections.values() for part in connection.parts.values())
        return sum(part.weight for part in parts)

    def _event(self, adapter: object, body: bytes) -> Iterator[Closed | int]:
        if len(body) < 2:
            return
        event, rest = body[0], body[2:]
        if len(rest) < _LEAST_OF_EVENT.get(event, 0):
            return
        if event == CONNECTED and rest[0] == 0:
            yield from self._connect(adapter, _handle(rest[1:3]), _address(rest[3:9]))
        elif event == DISCONNECTED and rest[0] == 0:
            yield from self._forget(adapter, _handle(rest[1:3]))
        elif event == COMMAND_COMPLETE and int.from_bytes(rest[1:3], "little") == READ_ADDRESS:
            self._own.add(adapter, _address(rest[4:10]))

    def _connect(self, adapter: object, handle: int, address: str | None) -> Iterator[Closed | int]:
        yield from self._forget(adapter, handle)
        if len(self._connections) >= MOST_CONNECTIONS:
            yield from self._forget(*next(iter(self._connections)))
        self._generation += 1
        self._connections[adapter, handle] = _Connection(address, self._generation)

    def _forget(self, adapter: object, handle: int) -> Iterator[Closed | int]:
        connection = self._connections.pop((adapter, handle), None)
        if connection is not None:
            yield sum(part.weight for part in connection.parts.values())
            yield Closed(self._ends(adapter, handle, connection), (adapter, handle, connection.generation))

    def _ends(self, adapter: object, handle: int, connection: _Connection) -> Ports:
        return Ports(self._own.get(adapter, HOST), connection.address or f"handle 0x{handle:04x}")

    def _data(
        self, adapter: object, is_from_host: bool | None, body: bytes, weight: int
    ) -> Iterator[Carried | Closed | int]:
        word, length = ACL.unpack_from(body)
        handle, start = word & _HANDLE_MASK, word >> HANDLE_BITS & 3
        if (adapter, handle) not in self._connections:
            yield from self._connect(adapter, handle, None)
        connection = self._connections[adapter, handle]
        data = body[ACL.size : ACL.size + length]
        # Without a direction, the kind of start tells which of two unfinished packets continues.
        side: object = start if is_from_host is None else is_from_host
        if start == _GOES_ON:
            if is_from_host is None:
                side = next(reversed(connection.parts), None)
            part = connection.parts.pop(side, None)
            if part is None:
                yield weight
                return
            part = _Part(part.data + data, part.size, part.weight + weight)
        else:
            before = connection.parts.pop(side, None)
            if before is not None:
                yield before.weight
            if len(data) < L2CAP.size:
                yield weight
                return
            part = _Part(data, L2CAP.size + L2CAP.unpack_from(data)[0], weight)
        # A packet that the capture has cut is read as far as it was captured.
        is_cut = len(data) < length
        if len(part.data) < part.size and not is_cut:
            connection.parts[side] = part
            return
        serial = _serial(connection, is_from_host, part)
        ends = self._ends(adapter, handle, connection)
        yield Carried(ends, (adapter, handle, connection.generation), serial, part.weight)


def _unwrap(packet: Packet) -> tuple[int | None, bool | None, bytes]:
    """Returns the packet type, whether it is from the host (None if unknown), and what follows the type."""
    data, link = packet.data, packet.interface.link
    if link == Link.BLUETOOTH_MONITOR:
        if packet.flags is None:
            if len(data) < _MONITOR.size:
                return None, None, b""
            kind, data = _MONITOR.unpack_from(data)[1], data[_MONITOR.size :]
        else:
            kind = packet.flags & 0xFFFF
        packet_type, is_received = _MONITOR_KINDS.get(kind, (None, False))
        return packet_type, not is_received, data
    is_from_host: bool | None = None
    if link == Link.HCI_WITH_DIRECTION:
        if len(data) < DIRECTION.size:
            return None, None, b""
        is_from_host = not DIRECTION.unpack_from(data)[0] & _RECEIVED
        data = data[DIRECTION.size :]
    elif packet.flags is not None:
        is_from_host = not packet.flags & _RECEIVED
    return (data[0] if data else None), is_from_host, data[1:]


def _adapter(packet: Packet) -> object:
    number = packet.flags >> 16 if packet.flags is not None else int.from_bytes(packet.data[:2], "big")
    return (packet.interface, number)


def _handle(data: bytes) -> int:
    return int.from_bytes(data, "little") & _HANDLE_MASK


def _address(data: bytes) -> str:
    return data[::-1].hex(":")


def _header(data: bytes) -> tuple[int, int, bytes] | None:
    """Returns where the contents of an RFCOMM frame begin, their length, and the bytes that its checksum covers."""
    if len(data) < 4 or not data[0] & 1 or data[1] & ~RFCOMM_POLL not in _FRAME_TYPES:
        return None
    is_data, head = data[1] & ~RFCOMM_POLL == RFCOMM_DATA, 3 if data[2] & 1 else 4
    has_credits = is_data and data[1] & RFCOMM_POLL and data[0] >> 2
    length = int.from_bytes(data[2:head], "little") >> 1
    return head + bool(has_credits), length, data[: 2 if is_data else head]


def _serial(connection: _Connection, is_from_host: bool | None, part: _Part) -> Serial | None:
    _, channel = L2CAP.unpack_from(part.data)
    data = part.data[L2CAP.size : part.size]
    header = _header(data) if channel >= _LEAST_DYNAMIC else None
    if header is None:
        return None
    start, length, checked = header
    way = is_from_host, channel
    is_known_cut = len(part.data) < part.size and way in connection.channels
    if not is_known_cut and (len(data) != start + length + 1 or data[-1] != frame_check(checked)):
        return None
    if len(connection.channels) < MOST_CHANNELS:
        connection.channels.add(way)
    if is_from_host is None:
        # In data frames this bit is set by the side that opened the connection, which is never a brick.
        is_from_host = bool(data[0] & 2)
    number, kind = data[0] >> 2, data[1] & ~RFCOMM_POLL
    carried = data[start : start + length] if kind == RFCOMM_DATA and number else b""
    return Serial(number >> 1, is_from_host, carried, length - len(carried) if carried else 0, kind in (OPEN, CLOSED))
