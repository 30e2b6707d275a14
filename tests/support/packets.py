"""Captures in the making: frames put into packets of their carriers, quickly.

The packets contain only what Wireshark needs to find the frames; `captures/` has complete ones.
Packet numbers are Wireshark's: the first packet is 1.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable, Iterator

from ev3proto.tables.discovery import BEACON_PORT, TCP_PORT
from ev3proto.tables.frame import MAX_FRAME

RAW_IP, HCI_WITH_DIRECTION, USBMON = 101, 201, 220
"""Kinds of captures: IP without a lower layer, Bluetooth's HCI, USB under Linux."""

HOST, BRICK, EVERYBODY = (bytes((192, 0, 2, number)) for number in (1, 10, 255))
HOST_PORT = 49152
"""The first port that a computer gives to a program; later programs get the next ones."""

MILLISECONDS_EACH = 1
"""The time between packets."""

_HEAD_SIZE = 24
_RECORD = struct.Struct("<IIII")


class Capture:
    """A pcap file; `size` is the original size of a packet if it was captured only in part."""

    def __init__(self, link: int) -> None:
        self.count = 0
        self._waited = 0
        self._pieces = [struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 0x40000, link)]

    def add(self, packet: bytes, size: int = 0) -> int:
        """Adds a packet, a fixed time after the one before; returns its number."""
        seconds, milliseconds = divmod(self.count * MILLISECONDS_EACH + self._waited, 1000)
        head = _RECORD.pack(seconds, 1000 * milliseconds, len(packet), size or len(packet))
        self._pieces += [head, packet]
        self.count += 1
        return self.count

    def wait(self, milliseconds: int) -> None:
        """Lets time pass before the next packet."""
        self._waited += milliseconds

    def data(self) -> bytes:
        return b"".join(self._pieces)


def packets_of(capture: bytes) -> Iterator[bytes]:
    """Yields the packets of a pcap file with times in microseconds or nanoseconds."""
    at = _HEAD_SIZE
    while at < len(capture):
        size = _RECORD.unpack_from(capture, at)[2]
        yield capture[at + _RECORD.size : at + _RECORD.size + size]
        at += _RECORD.size + size


def cut(capture: bytes, most: int) -> bytes:
    """Returns the capture with each packet truncated to a number of bytes."""
    found = Capture(struct.unpack_from("<I", capture, 20)[0])
    for packet in packets_of(capture):
        found.add(packet[:most], len(packet))
    return found.data()


# IP


def _ip(source: bytes, target: bytes, protocol: int, data: bytes) -> bytes:
    return struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(data), 0, 0x4000, 64, protocol, 0, source, target) + data


class Connection:
    """A TCP connection between a program on the host and a brick, begun before the capture."""

    PUSH_AND_ACKNOWLEDGE = 0x18

    def __init__(
        self,
        capture: Capture,
        port: int = HOST_PORT,
        brick_port: int = TCP_PORT,
        ends: tuple[bytes, bytes] = (HOST, BRICK),
    ) -> None:
        self.capture = capture
        self.ports, self.ends = (port, brick_port), ends
        self.numbers = {True: 1, False: 1}

    def segment(self, from_host: bool, data: bytes) -> bytes:
        """Returns the next segment without sending it."""
        own, acknowledged = self.numbers[from_host], self.numbers[not from_host]
        self.numbers[from_host] += len(data)
        ports = self.ports if from_host else self.ports[::-1]
        head = struct.pack(">HHIIBBHHH", *ports, own, acknowledged, 5 << 4, self.PUSH_AND_ACKNOWLEDGE, 0xFFFF, 0, 0)
        return _ip(*(self.ends if from_host else self.ends[::-1]), 6, head + data)

    def send(self, data: bytes) -> int:
        """The host sends."""
        return self.capture.add(self.segment(True, data))

    def receive(self, data: bytes) -> int:
        """The brick sends."""
        return self.capture.add(self.segment(False, data))


def segment(
    from_host: bool,
    sequence: int,
    data: bytes = b"",
    *,
    acknowledged: int | None = None,
    flags: int = 0,
    port: int = HOST_PORT,
    brick_port: int = TCP_PORT,
) -> bytes:
    """Adds a TCP packet with the given numbers, which wrap; with `acknowledged`, also with that flag."""
    ports = (port, brick_port) if from_host else (brick_port, port)
    flags |= 0 if acknowledged is None else ACK
    numbers = (sequence % 2**32, (acknowledged or 0) % 2**32)
    head = struct.pack(">HHIIBBHHH", *ports, *numbers, 5 << 4, flags, 0xFFFF, 0, 0)
    return _ip(*((HOST, BRICK) if from_host else (BRICK, HOST)), 6, head + data)


FIN, SYN, RST, PUSH, ACK = 0x01, 0x02, 0x04, 0x08, 0x10
"""TCP's flags."""


def datagram(
    data: bytes, source: bytes = BRICK, port: int = 3016, target: bytes = EVERYBODY, target_port: int = BEACON_PORT
) -> bytes:
    """A UDP packet: by default a brick's beacon."""
    return _ip(source, target, 17, struct.pack(">HHHH", port, target_port, 8 + len(data), 0) + data)


def in_tunnels(data: bytes) -> bytes:
    """A capture of Ethernet: the same data by six programs, in GRE, AH, 802.1ah, VXLAN, Geneve and GTP; then ARP."""
    capture = Capture(1)
    head, is_ip = bytes(12), b"\x08\0"
    inside = [Connection(Capture(RAW_IP), HOST_PORT + each).segment(True, data) for each in range(6)]
    capture.add(head + is_ip + _ip(HOST, BRICK, 47, bytes.fromhex("00000800") + inside[0]))
    capture.add(
        head + is_ip + _ip(HOST, BRICK, 51, bytes.fromhex("04040000 00000001 00000001") + bytes(12) + inside[1])
    )
    capture.add(head + bytes.fromhex("88e7 00000001") + head + is_ip + inside[2])
    for port, start, packet in (
        (4789, bytes.fromhex("08000000 00002a00") + head + is_ip, inside[3]),
        (6081, bytes.fromhex("00006558 00002a00") + head + is_ip, inside[4]),
        (2152, struct.pack(">BBHI", 0x30, 0xFF, len(inside[5]), 1), inside[5]),
    ):
        capture.add(head + is_ip + datagram(start + packet, HOST, 50000, BRICK, port))
    capture.add(head + bytes.fromhex("0806 0001 0800 0604 0001") + bytes(20))
    return capture.data()


def over(capture: Capture, carrier: Connection | SerialPort | Device, said: Iterable[tuple[bool, bytes]]) -> bytes:
    """Returns a capture of a dialogue over a carrier; each part has whether the host sends it."""
    for from_host, data in said:
        (carrier.send if from_host else carrier.receive)(data)
    return capture.data()


# USB


class Device:
    """A USB device that was plugged in before the capture; `kind` is the transfer type of its reports."""

    INTERRUPT, CONTROL, BULK = 1, 2, 3
    OUT, IN = 0x01, 0x81

    def __init__(self, capture: Capture, number: int = 7, size: int = MAX_FRAME) -> None:
        self.capture = capture
        self.number = number
        self.size = size
        self.kind = self.INTERRUPT

    def _add(self, event: bytes, kind: int, endpoint: int, data: bytes, setup: bytes = b"") -> int:
        """Linux' records of a request, when it is submitted and when it is done."""
        is_empty = bool(endpoint & 0x80) == (event == b"S")
        head = struct.pack(
            "<QcBBBHBBqiiII8siiII",
            self.number << 16 | endpoint << 8,
            event,
            kind,
            endpoint,
            self.number,
            1,
            0 if setup else ord("-"),
            ord("<") if is_empty else 0,
            self.capture.count // 1000,
            self.capture.count % 1000 * 1000,
            -115 if event == b"S" else 0,
            len(data),
            len(data),
            setup,
            8,
            0,
            0,
            0,
        )
        return self.capture.add(head + data)

    def enumerate(self, vendor: int, product: int, interface_class: int = 3) -> None:
        """The host asks for the product, and for the class of its interface."""
        device = struct.pack("<BBHBBBBHHHBBBB", 18, 1, 0x0200, 0, 0, 0, 64, vendor, product, 0x0100, 0, 0, 0, 1)
        inside = struct.pack("<BBBBBBBBB", 9, 4, 0, 0, 2, interface_class, 0, 0, 0)
        inside += struct.pack("<BBHBBBH", 9, 0x21, 0x0110, 0, 1, 0x22, 29) if interface_class == 3 else b""
        for endpoint in (self.IN, self.OUT):
            inside += struct.pack("<BBBBHB", 7, 5, endpoint, 3, self.size, 4)
        configuration = struct.pack("<BBHBBBBB", 9, 2, 9 + len(inside), 1, 1, 0, 0xC0, 1) + inside
        for kind, answer in ((1, device), (2, configuration)):
            setup = struct.pack("<BBHHH", 0x80, 6, kind << 8, 0, len(answer))
            self._add(b"S", self.CONTROL, 0x80, b"", setup)
            self._add(b"C", self.CONTROL, 0x80, answer)
        self._add(b"S", self.CONTROL, 0x00, b"", struct.pack("<BBHHH", 0x00, 9, 1, 0, 0))
        self._add(b"C", self.CONTROL, 0x00, b"")

    def send(self, data: bytes, padding: bytes = b"") -> int:
        """The host sends a report that starts with these bytes; the rest is zero, or starts with `padding`."""
        return self._add(b"S", self.kind, self.OUT, (data + padding).ljust(self.size, b"\0")[: self.size])

    def receive(self, data: bytes, padding: bytes = b"") -> int:
        """The device sends such a report."""
        return self._add(b"C", self.kind, self.IN, (data + padding).ljust(self.size, b"\0")[: self.size])


# Bluetooth


def frame_check(data: bytes) -> int:
    """Returns RFCOMM's check sum, bit by bit."""
    rest = 0xFF
    for byte in data:
        rest ^= byte
        for _ in range(8):
            rest = rest >> 1 ^ 0xE0 * (rest & 1)
    return 0xFF - rest


class SerialPort:
    """An RFCOMM channel, beginning with the L2CAP connection; `connection` tells devices apart.

    With an `address`, the capture also has the beginning of the connection, by which Wireshark tells devices apart.
    """

    UIH = 0xEF
    SIGNALS, RFCOMM = 1, 3
    OURS, THEIRS = 0x0041, 0x0051

    CONNECTED = 3

    def __init__(self, capture: Capture, channel: int = 1, connection: int = 0x00B, address: bytes = b"") -> None:
        self.capture = capture
        self.dlci = channel << 1
        self.connection = connection
        heads = {way: bytes((self.dlci << 2 | way << 1 | 1, self.UIH)) for way in (True, False)}
        self.heads = {way: (head, frame_check(head)) for way, head in heads.items()}
        if address:
            event = struct.pack("<BBBH", self.CONNECTED, 11, 0, connection) + address + bytes((1, 0))
            capture.add(struct.pack(">IB", 1, 4) + event)
        asked = struct.pack("<BBHHH", 2, 1, 4, self.RFCOMM, self.OURS)
        self._packet(True, self.SIGNALS, asked)
        self._packet(False, self.SIGNALS, struct.pack("<BBHHHHH", 3, 1, 8, self.THEIRS, self.OURS, 0, 0))

    def _packet(self, from_host: bool, channel: int, data: bytes) -> int:
        start = 0x0000 if from_host else 0x2000
        acl = struct.pack(">IB", not from_host, 2) + struct.pack("<HH", self.connection | start, 4 + len(data))
        return self.capture.add(acl + struct.pack("<HH", len(data), channel) + data)

    def _data(self, from_host: bool, data: bytes) -> int:
        head, check = self.heads[from_host]
        size = len(data)
        length = bytes((size << 1 | 1,)) if size < 0x80 else (size << 1).to_bytes(2, "little")
        packet = head + length + data + bytes((check,))
        return self._packet(from_host, self.THEIRS if from_host else self.OURS, packet)

    def send(self, data: bytes) -> int:
        """The host sends an RFCOMM frame with these bytes."""
        return self._data(True, data)

    def receive(self, data: bytes) -> int:
        """The device sends one."""
        return self._data(False, data)
