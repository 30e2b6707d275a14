"""Traffic of other programs on the ports, channels and devices that bricks use."""

from __future__ import annotations

import random
import struct
from collections.abc import Iterator

from ev3proto.tables.frame import MAX_FRAME, MessageType

Said = tuple[bool, bytes]
"""Whether the host sends it, and the bytes."""


def debug_bridge(rng: random.Random) -> Iterator[Said]:
    """Android's debugger on TCP port 5555: a header of six numbers, then data."""

    def packet(command: bytes, first: int, second: int, data: bytes) -> bytes:
        number = int.from_bytes(command, "little")
        return struct.pack("<6I", number, first, second, len(data), sum(data), number ^ 0xFFFFFFFF) + data

    yield True, packet(b"CNXN", 0x01000001, 0x40000, b"host::features=shell_v2,cmd")
    yield False, packet(b"CNXN", 0x01000001, 0x40000, b"device::ro.product.name=x;\0")
    for number in range(1, 20):
        yield True, packet(b"OPEN", number, 0, b"shell:ls\0")
        yield False, packet(b"OKAY", number, number, b"")
        yield False, packet(b"WRTE", number, number, rng.randbytes(rng.randrange(900)))
        yield True, packet(b"OKAY", number, number, b"")


def encrypted(rng: random.Random) -> Iterator[Said]:
    """TLS, whose records begin with type, version and length."""

    def record(kind: int, data: bytes) -> bytes:
        return struct.pack(">BHH", kind, 0x0303, len(data)) + data

    hello = bytes((1, 0, 1, 0xFC, 3, 3)) + rng.randbytes(32) + bytes(474)
    yield True, struct.pack(">BHH", 22, 0x0301, len(hello)) + hello
    yield False, record(22, bytes((2, 0, 0, 0x76, 3, 3)) + rng.randbytes(116)) + record(20, b"\1")
    for _ in range(60):
        yield rng.random() < 0.5, record(23, rng.randbytes(rng.randint(17, 1300)))


def object_exchange(rng: random.Random) -> Iterator[Said]:
    """OBEX on RFCOMM: an opcode, the length with the high byte first, headers."""

    def packet(code: int, data: bytes) -> bytes:
        return struct.pack(">BH", code, 3 + len(data)) + data

    yield True, packet(0x80, bytes((0x10, 0, 0x20, 0)))
    yield False, packet(0xA0, bytes((0x10, 0, 0x20, 0)))
    for _ in range(100):
        data = rng.randbytes(rng.randrange(200))
        yield True, packet(0x02, struct.pack(">BH", 0x48, 3 + len(data)) + data)
        yield False, packet(0x90, b"")


def nxt(rng: random.Random) -> Iterator[Said]:
    """LEGO's brick before the EV3: two bytes of length, the kind of telegram, the command."""

    def telegram(data: bytes) -> bytes:
        return struct.pack("<H", len(data)) + data

    for _ in range(100):
        yield True, telegram(b"\x00\x0b")
        yield False, telegram(b"\x02\x0b\x00" + rng.randbytes(2))
        power = rng.randbytes(1)
        yield True, telegram(bytes((0x80, 4, rng.randrange(3))) + power + bytes((7, 0, 0, 32, 0, 0, 0, 0)))
        yield True, telegram(bytes((0, 6, rng.randrange(3))))
        yield False, telegram(bytes((2, 6, 0, rng.randrange(3))) + power + bytes((7, 0, 0, 32)) + rng.randbytes(16))
        yield True, telegram(bytes((0, 7, rng.randrange(4))))
        yield False, telegram(bytes((2, 7, 0, rng.randrange(4), 1, 0, 1, 0x20)) + rng.randbytes(8))
        yield True, telegram(bytes((0, 9, rng.randrange(20), 20)) + rng.randbytes(20))
        # A text for mailbox 0, a request to the ultrasonic sensor, a file: read as EV3 commands, they have no fault.
        yield True, telegram(b"\x80\x09\x00\x05abcd\0")
        yield True, telegram(b"\x00\x0f\x00\x02\x01\x02\x42")
        yield True, telegram(b"\x01\x83\x01\x93" + rng.randbytes(60))
        yield False, telegram(b"\x02\x80\x00\x00\x98\xdd\xac\x59")


def modbus(rng: random.Random) -> Iterator[Said]:
    """Modbus on a serial line: an address, a function, data, two bytes of checksum."""
    for _ in range(150):
        count = rng.randint(1, 20)
        yield True, struct.pack(">BBHH", 1, 3, rng.randrange(100), count) + rng.randbytes(2)
        yield False, struct.pack(">BBB", 1, 3, 2 * count) + rng.randbytes(2 * count + 2)


def checked_modbus(rng: random.Random) -> Iterator[Said]:
    """The same with real checksums: bits, registers and single values of several units, read and written."""

    def checked(data: bytes) -> bytes:
        rest = 0xFFFF
        for byte in data:
            rest ^= byte
            for _ in range(8):
                rest = rest >> 1 ^ 0xA001 * (rest & 1)
        return data + struct.pack("<H", rest)

    def values(count: int) -> bytes:
        return b"".join(
            struct.pack(">H", rng.choice((0, 1, rng.randrange(300), rng.randrange(1 << 16)))) for _ in range(count)
        )

    for _ in range(300):
        unit, at, count = rng.randint(1, 8), rng.randrange(1000), rng.randint(1, 20)
        function = rng.choice((1, 2, 3, 4, 5, 6, 16))
        head = struct.pack(">BBHH", unit, function, at, rng.randrange(1000) if function in (5, 6) else count)
        if function <= 4:
            size = 2 * count if function > 2 else (count + 7) // 8
            yield True, checked(head)
            yield False, checked(bytes((unit, function, size)) + values(count)[:size])
        else:
            yield True, checked(head + bytes((2 * count,)) + values(count) if function == 16 else head)
            yield False, checked(head)


def numbered(rng: random.Random) -> Iterator[Said]:
    """An invented protocol: two bytes of length, a kind, a number at the place of a frame's type, a text."""
    words = (b"temperature", b"hello", b"SELECT 1", b"admin")
    first = rng.randrange(100)
    for number in range(first, first + 40):
        body = struct.pack("<HI", rng.randrange(6), number) + rng.choice(words)
        yield number % 2 == 0, struct.pack("<H", len(body)) + body


def padded(rng: random.Random) -> Iterator[Said]:
    """A machine's controller: two bytes of length, a number, then mostly zeros."""
    for number in range(rng.randrange(100), 200):
        head = struct.pack("<HHHH", rng.choice((6, 14, 18)), number, 0, 0)
        yield number % 2 == 0, head + bytes(rng.choice((0, 8, 12)))


def database(rng: random.Random) -> Iterator[Said]:
    """MySQL: three bytes of length, a number, then data."""

    def packet(number: int, data: bytes) -> bytes:
        return len(data).to_bytes(3, "little") + bytes((number,)) + data

    yield False, packet(0, b"\x0a8.0.36\0" + rng.randbytes(60))
    yield True, packet(1, rng.randbytes(32) + bytes(23) + b"root\0")
    yield False, packet(2, b"\0\0\0\2\0\0\0")
    for number in range(30):
        yield True, packet(0, b"\3SELECT a FROM t WHERE id=%d" % number)
        column = packet(2, b"\3def\2db\1t\1t\1a\1a\x0c\x3f\0\x0b\0\0\0\3\0\0\0\0\0")
        yield False, packet(1, b"\1") + column + packet(3, b"\xfe\0\0\2\0") + packet(4, b"\xfe\0\0\2\0")
        yield True, packet(0, b"\x0e")
        yield False, packet(1, b"\0\0\0\2\0\0\0")


def torrent(rng: random.Random) -> Iterator[Said]:
    """BitTorrent's datagrams: bencoded queries, and headers of its own transport."""
    for _ in range(100):
        yield True, b"d1:ad2:id20:" + rng.randbytes(20) + b"e1:q4:ping1:t2:aa1:y1:qe"
        yield False, bytes((0x21, 0)) + rng.randbytes(18)


def pieces(rng: random.Random) -> Iterator[Said]:
    """BitTorrent over TCP: a request has the index of a piece, an offset and a length."""
    for number in range(7, 47):
        wanted = struct.pack(">III", number % 8, 0x4000 * rng.randrange(8), 0x4000)
        yield True, struct.pack(">IB", 13, 6) + wanted
        yield False, struct.pack(">IB", 509, 7) + wanted[:8] + rng.randbytes(500)


def similar_beacons(rng: random.Random) -> Iterator[Said]:
    """Datagrams of other devices with the words of a beacon."""
    for number in range(20):
        yield rng.random() < 0.5, b"Serial-Number: XYZ-%d\r\nPort: 9100\r\nName: printer\r\nProtocol: IPP\r\n" % number
        yield rng.random() < 0.5, b"Serial-Number: %d\r\nModel: 5555\r\n" % number
        yield rng.random() < 0.5, b"Serial-Number: %d" % number


def reports(rng: random.Random, count: int) -> Iterator[Said]:
    """USB reports of another vendor: any bytes, with a length and a type that a frame may have."""
    for _ in range(count):
        size = rng.randint(5, MAX_FRAME)
        kind = rng.choice(list(MessageType))
        head = struct.pack("<HHB", size - 2, rng.randrange(0x10000), kind)
        yield rng.random() < 0.5, head + rng.randbytes(MAX_FRAME - len(head))


def opcodes(rng: random.Random) -> Iterator[Said]:
    """Messages after their length in two bytes: an operation, and small numbers."""
    for _ in range(400):
        body = bytes((rng.randrange(20), *(rng.randrange(16) for _ in range(rng.randrange(25)))))
        yield rng.random() < 0.5, struct.pack("<H", len(body)) + body


def cards(_rng: random.Random) -> Iterator[Said]:
    """Business cards: by chance, their beginning looks like a command, and their letters like operations."""
    for number in range(20):
        yield number % 2 == 0, bytes.fromhex("9000 DBC3 00 006C 8E 4800D3") + b"BEGIN:VCARD\r\n" * 17


def moves(rng: random.Random) -> Iterator[Said]:
    """A joystick in small packets: by chance, the first ones look like the beginning of a system command."""
    data = bytes.fromhex("6D00 0001 01 93 0000")
    for number in range(100):
        data += struct.pack(
            "<IhBB", 0x0100_0100 + number, rng.randrange(-32768, 32768), rng.randrange(1, 3), number % 4
        )
    for at in range(0, len(data), 5):
        yield True, data[at : at + 5]


def tuner(rng: random.Random) -> Iterator[Said]:
    """Tuning of loudspeakers on RFCOMM: a mark, a block, rows of four numbers, mostly zeros, a check sum, a mark."""
    for number in range(2000):
        rows = [
            struct.pack("<HHHH", *map(rng.choice, ((0, 8, 11, 160), (0, 40, 600), (0, 128), (0, 0xAA00))))
            for _ in range(rng.randint(1, 6))
        ]
        block = bytes((0x80, 0x80, 0x80, 0xEE, number % 3)) + b"".join(rows)
        yield number % 2 == 0, block + bytes((sum(block) & 0xFF, 0xAA)) + bytes(rng.choice((0, 4, 16)))


def log_sink(rng: random.Random) -> Iterator[Said]:
    """A device that writes its log to a server: length, number, kind of record, level, text; each is acknowledged."""
    for number in range(20):
        line = b"I/wdog: heap %d of 65536\\0" % rng.randrange(65536)
        yield True, struct.pack("<HHBB", 4 + len(line), number, 1, 0) + line
        yield False, struct.pack("<HHBBB", 5, number, 3, 0, 0)
