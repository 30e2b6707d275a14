"""Capture files of every format are read packet by packet, from any source, complete or not."""

from __future__ import annotations

import gc
import gzip
import io
import os
import re
import struct
import tracemalloc
import warnings
import zlib
from collections.abc import Iterator
from pathlib import Path

import pytest
from support.cli import run_ev3proto_text
from support.files import BEGIN_NS, RAW_IP, Blocks, Timed, btsnoop, packetlogger, pcap, timed
from support.packets import Capture as Packets
from support.packets import Connection, SerialPort, packets_of

from ev3proto.capture import Capture, CaptureError, read
from ev3proto.capture.formats import CAPTURE_FORMATS, LISTED, READ
from ev3proto.capture.packets import Format

COMMANDS = [struct.pack("<HHB", 8, counter, 0x00) + bytes.fromhex("0400 81 01 60") for counter in range(5)]
"""UI_READ.GET_VBATT, 10 bytes each."""


def segments() -> list[bytes]:
    connection = Connection(Packets(RAW_IP))
    return [connection.segment(True, command) for command in COMMANDS]


def ways() -> dict[str, bytes]:
    """The five commands, a millisecond apart, in every kind of file that can contain IP."""
    packets = timed(segments())
    found = {
        f"pcap {order}{' nano' * nano}": pcap(RAW_IP, packets, order=order, nano=nano)
        for order in "<>"
        for nano in (False, True)
    }
    for order in "<>":
        blocks = Blocks(order)
        blocks.interface(RAW_IP)
        for time_ns, data, _ in packets:
            blocks.packet(time_ns // 1000, data)
        found[f"pcapng {order} packet"] = blocks.data()
    for name, data in list(found.items()):
        found[f"gzip {name}"] = gzip.compress(data)
        found[f"gzip {name} in two members"] = gzip.compress(data[:100]) + gzip.compress(data[100:])
    return found


WAYS = ways()


def bluetooth_capture() -> bytes:
    """A btsnoop file with one command on a connection that is set up in it."""
    packets = Packets(201)
    port = SerialPort(packets)
    port.send(COMMANDS[0])
    found = [(data[4:], struct.unpack(">I", data[:4])[0]) for data in packets_of(packets.data())]
    return btsnoop(1002, timed([data for data, _ in found]), [flags for _, flags in found])


def everything(capture: Capture) -> tuple[list[bytes], str | None]:
    """Returns the frames of a capture and the error at its end; checks that every byte is accounted for."""
    frames: list[bytes] = []
    trouble = None
    try:
        for record in capture:
            frames.append(record.frame)
    except CaptureError as error:
        trouble = str(error)
    assert capture.account.balance == 0
    return frames, trouble


def read_bytes(data: bytes) -> tuple[list[bytes], str | None]:
    try:
        capture = read(io.BytesIO(data))
    except CaptureError as error:
        return [], str(error)
    return everything(capture)


@pytest.mark.parametrize("way", WAYS)
def test_every_format_has_the_same_packets(way: str, tmp_path: Path) -> None:
    path = tmp_path / "a file.txt"  # the name does not tell
    path.write_bytes(WAYS[way])
    with read(path) as capture:
        records = list(capture)
    assert [record.frame for record in records] == COMMANDS
    assert [record.numbers for record in records] == [(1,), (2,), (3,), (4,), (5,)]
    assert [record.time_ns - BEGIN_NS for record in records] == [0, 1_000_000, 2_000_000, 3_000_000, 4_000_000]
    account = capture.account
    assert (account.packets, account.captured, account.frames, account.headers) == (5, 250, 50, 200)
    assert (account.first_ns, account.last_ns) == (BEGIN_NS, BEGIN_NS + 4_000_000)
    assert account.balance == 0


def test_nanoseconds_are_kept() -> None:
    packet = Timed(1_700_000_000_123_456_789, segments()[0])
    (record,) = read(io.BytesIO(pcap(RAW_IP, [packet], nano=True)))
    assert record.time_ns == 1_700_000_000_123_456_789
    (record,) = read(io.BytesIO(pcap(RAW_IP, [packet])))
    assert record.time_ns == 1_700_000_000_123_456_000


def test_the_link_of_a_pcap_file_may_say_that_check_sums_follow() -> None:
    data = bytearray(pcap(RAW_IP, timed(segments())))
    data[20:24] = struct.pack("<I", 0x5400_0000 | RAW_IP)
    assert read_bytes(bytes(data)) == (COMMANDS, None)


ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize("found", CAPTURE_FORMATS, ids=lambda found: found.name)
def test_each_format_is_decided_by_as_many_bytes_as_it_says(found: Format) -> None:
    for head in (bytes(found.needs), b"a" * found.needs, b"0" * found.needs, b"#" * found.needs):
        assert found.matches(head) is False
    assert found.matches(b"") is None


def test_pages_and_help_list_the_formats() -> None:
    """To add a format, run this and change what it names."""
    assert LISTED == "pcap, pcapng, btsnoop, pklg or usbmon's text"
    pages = {name: " ".join((ROOT / name).read_text(encoding="utf-8").split()) for name in PAGES}
    assert [name for name, text in pages.items() if LISTED not in text] == []
    assert f"captures ({LISTED}; gzipped or not)" in " ".join(run_ev3proto_text("decode", "--help").stdout.split())
    rows = (ROOT / "docs/howto/record.md").read_text(encoding="utf-8").partition("## Which files are read")[2]
    suffixes = {suffix for found in READ for suffix in found.suffixes}
    assert suffixes <= set(re.findall(r"`(\.\w+)`", rows))


PAGES = ("README.md", "docs/howto/captures.md")


# Bluetooth


def hci_packets() -> list[Timed]:
    """A command on a serial port, and what sets it up: for each its time, direction, and packet type and contents."""
    packets = Packets(201)
    SerialPort(packets).send(COMMANDS[0])
    return timed(list(packets_of(packets.data())))


@pytest.mark.parametrize("order", "<>")
def test_files_of_packetlogger(order: str) -> None:
    """As a Mac writes them; texts and notes are between the packets."""
    note = struct.pack(f"{order}IIIB", 13, 1_500_000_000, 0, 0xFB) + b"note"
    data = note + packetlogger(hci_packets(), order)
    assert read_bytes(data) == (COMMANDS[:1], None)
    (record,) = read(io.BytesIO(data))
    assert record.time_ns == hci_packets()[-1][0]
    assert read_bytes(data[:-1])[1] == "the file is cut off in packet 4: 21 of its 22 bytes are there"
    assert read_bytes(data[:25])[1] == "the file is cut off in the header of packet 2, at offset 17"
    damaged = data[:17] + struct.pack(f"{order}I", 3) + data[21:]
    assert str(read_bytes(damaged)[1]).startswith("the file is damaged at offset 17: packet 2 would have -6 bytes")


def test_btsnoop_without_packet_types() -> None:
    """The flags tell them: 1 for a received packet, 2 for commands and events."""
    found = [(packet[5:], struct.unpack(">IB", packet[:5])) for _, packet, _ in hci_packets()]
    flags = [direction | (0 if kind == 2 else 2) for _, (direction, kind) in found]
    assert read_bytes(btsnoop(1001, timed([data for data, _ in found]), flags)) == (COMMANDS[:1], None)


def test_files_that_are_known_and_not_read() -> None:
    packet = bytes.fromhex("02 0b20 1200 0e00 4000 0bef15 08000200000400810160 9a")
    dump = struct.pack("<HBBII", len(packet), 0, 0, 1_540_000_000, 5) + packet
    assert read_bytes(dump) == ([], "a file of hcidump -w, which is not read here; --engine wireshark reads it")
    summary = bytes.fromhex("02 0068e5cf8b010000 789c6390 6378c1ccc0a0c8a82049")
    netlog = b'{"constants":{"activeFieldTrialGroups":[]'
    assert "Android's compressed log of Bluetooth (btsnooz), which is not read here; " in str(read_bytes(summary)[1])
    assert "a NetLog of Chrome, which has requests of pages" in str(read_bytes(netlog)[1])
    mac = read_bytes(pcap(266, timed([bytes(40)])))
    assert mac == (
        [],
        "packets of link type 266 (USB on macOS) were not read; --engine wireshark reads all link types of Wireshark",
    )


def test_an_iphone_speaks_another_protocol() -> None:
    packets = Packets(201)
    link = "FF 5A 00 1A 80 2B 00 00 E1 01 05 10 00 0F A0 00 17 03 03 0A 00 01 0B 02 01 E8"
    SerialPort(packets).send(bytes.fromhex(link))
    capture = read(io.BytesIO(packets.data()))
    assert list(capture) == []
    assert capture.account.passed_over == (
        "; 1 packet in Apple's accessory protocol (iAP), in which iPhones and iPads speak to a brick, was not read;"
        " --engine wireshark does not know the messages in it either"
    )


# pcapng


def test_interfaces_have_their_own_times_and_names() -> None:
    blocks = Blocks()
    blocks.interface(RAW_IP, name="wlan0")
    blocks.interface(RAW_IP, name="eth1", resolution=9)
    blocks.interface(RAW_IP, resolution=0x80 | 10)  # units of 1/1024 second
    blocks.interface(RAW_IP, resolution=3, offset=1_700_000_000)
    blocks.interface(RAW_IP, resolution=0, offset=-10)
    for interface, time in enumerate((1_700_000_000_000_001, 1_700_000_000_000_000_001, 1536, 7, 12)):
        blocks.packet(time, segments()[interface], interface=interface)
    records = list(read(io.BytesIO(blocks.data())))
    assert [(record.interface, record.time_ns) for record in records] == [
        ("wlan0", 1_700_000_000_000_001_000),
        ("eth1", 1_700_000_000_000_000_001),
        (None, 1_500_000_000),
        (None, 1_700_000_000_007_000_000),
        (None, 2_000_000_000),
    ]


def test_sections_have_their_own_interfaces_and_byte_order() -> None:
    blocks = Blocks("<")
    blocks.interface(RAW_IP, name="first")
    blocks.packet(1, segments()[0])
    blocks.section(">")
    blocks.interface(113, name="cooked")
    blocks.interface(RAW_IP, name="second", resolution=9)
    blocks.packet(2000, segments()[1], interface=1)
    records = list(read(io.BytesIO(blocks.data())))
    assert [(record.frame, record.numbers, record.interface, record.time_ns) for record in records] == [
        (COMMANDS[0], (1,), "first", 1000),
        (COMMANDS[1], (2,), "second", 2000),
    ]


def test_unknown_blocks_are_passed_over() -> None:
    blocks = Blocks()
    blocks.block(4, bytes(40))  # names
    blocks.interface(RAW_IP)
    blocks.block(0x0BAD, b"custom")
    blocks.packet(0, segments()[0])
    blocks.block(5, bytes(12))  # statistics
    blocks.block(0x80000001, b"")
    blocks.packet(0, segments()[1])
    assert read_bytes(blocks.data()) == (COMMANDS[:2], None)


def test_simple_packets_are_cut_where_their_interface_says() -> None:
    blocks = Blocks()
    blocks.interface(RAW_IP, most=56)
    connection = Connection(Packets(RAW_IP))
    for commands in (COMMANDS[0], COMMANDS[1] + COMMANDS[2]):
        packet = connection.segment(True, commands)
        blocks.simple_packet(packet[:56], len(packet))
    with read(io.BytesIO(blocks.data())) as capture:
        records = list(capture)
    assert [record.frame for record in records] == [*COMMANDS[:2], COMMANDS[2][:6]]
    fault = records[-1].message.fault
    assert fault is not None
    assert fault.reason == "the frame is cut off: its length field says that 8 bytes follow, but 4 do"
    assert (capture.account.captured, capture.account.cut) == (50 + 56, 1)
    assert capture.account.balance == 0


def test_a_simple_packet_has_no_padding() -> None:
    blocks = Blocks()
    blocks.interface(RAW_IP)
    blocks.simple_packet(segments()[0] + segments()[1][:0])
    assert len(segments()[0]) % 4 == 2
    with read(io.BytesIO(blocks.data())) as capture:
        (record,) = capture
    assert (record.frame, capture.account.captured) == (COMMANDS[0], 50)


@pytest.mark.parametrize("power", [0x7F, 0xFF, 0x40])
def test_a_time_resolution_may_be_absurd(power: int) -> None:
    blocks = Blocks()
    blocks.interface(RAW_IP, resolution=power, offset=-(2**63))
    blocks.packet(2**64 - 1, segments()[0])
    (record,) = read(io.BytesIO(blocks.data()))
    assert record.frame == COMMANDS[0]


def test_a_packet_of_no_interface_is_left_out_and_told() -> None:
    blocks = Blocks()
    blocks.interface(RAW_IP)
    blocks.packet(0, segments()[0])
    blocks.packet(0, segments()[1], interface=7)
    blocks.packet(0, segments()[1])
    assert read_bytes(blocks.data()) == (COMMANDS[:2], "packet 2 is of interface 7, which the file does not describe")


def test_a_packet_that_is_larger_than_its_block_is_left_out_and_told() -> None:
    blocks = Blocks()
    blocks.interface(RAW_IP)
    blocks.packet(0, segments()[0])
    head = struct.pack("<IIIII", 0, 0, 0, 0xFFFFFFF0, 0xFFFFFFF0)
    blocks.block(6, head + segments()[1])
    blocks.packet(0, segments()[1])
    sentence = "packet 2 would have 4294967280 bytes, but its block has room for 52"
    assert read_bytes(blocks.data()) == (COMMANDS[:2], sentence)


def test_a_block_too_short_for_its_kind_is_told() -> None:
    for kind in (1, 3, 6):
        blocks = Blocks()
        blocks.interface(RAW_IP)
        blocks.block(kind, b"")
        frames, trouble = read_bytes(blocks.data())
        assert frames == []
        assert trouble == "the file is damaged at offset 48: a block is too short for its kind"


@pytest.mark.parametrize("length", [0, 8, 11, 13, 0xFFFFFFFC])
def test_a_block_cannot_have_any_length(length: int) -> None:
    blocks = Blocks()
    blocks.interface(RAW_IP)
    blocks.packet(0, segments()[0])
    size = len(blocks.data())
    data = blocks.data() + struct.pack("<II", 0x0BAD, length) + bytes(100)
    sentence = f"the file is damaged at offset {size}: a block would have {length} bytes; what follows cannot be read"
    assert read_bytes(data) == (COMMANDS[:1], sentence)


# Truncated files


SMALL = {
    "pcap": WAYS["pcap <"],
    "pcap in the other byte order": WAYS["pcap > nano"],
    "pcapng": WAYS["pcapng < packet"],
    "pcapng in the other byte order": WAYS["pcapng > packet"],
}


@pytest.mark.parametrize("way", SMALL)
def test_a_file_may_be_cut_off_anywhere(way: str) -> None:
    """Every complete packet is given, with an error unless the cut is between two packets.

    The last packet may be given in part.
    """
    whole = SMALL[way]
    ends = [whole.index(command) + len(command) for command in COMMANDS]
    boundaries = {24 + 66 * count for count in range(5)} if way.startswith("pcap ") or way == "pcap" else set()
    quiet = 0
    for size in range(len(whole)):
        frames, trouble = read_bytes(whole[:size])
        count = sum(end <= size for end in ends)
        assert frames[:count] == COMMANDS[:count], size
        assert all(COMMANDS[count].startswith(frame) and trouble for frame in frames[count:]), size
        if trouble is None:
            quiet += 1
            assert size in boundaries or way.startswith("pcapng"), size
        else:
            assert trouble[0].islower(), trouble
            assert "\n" not in trouble
    # pcapng: after the section, after the interface, and after each packet but the last.
    assert quiet == (6 if way.startswith("pcapng") else 5)


def test_what_is_said_of_a_file_that_is_cut_off() -> None:
    whole = WAYS["pcap <"]
    told = {size: read_bytes(whole[:size])[1] for size in (0, 3, 20, 24 + 7, 24 + 16 + 49)}
    formats = "expected pcap, pcapng, btsnoop, pklg or usbmon's text, compressed with gzip or not"
    assert told == {
        0: f"not a capture file: it is empty; {formats}",
        3: f"not a capture file: it begins with D4 C3 B2; {formats}",
        20: "the file is cut off in its header",
        31: "the file is cut off in the header of packet 1, at offset 24",
        89: "the file is cut off in packet 1: 49 of its 50 bytes are there",
    }


def test_a_btsnoop_file_may_be_cut_off_anywhere() -> None:
    whole = bluetooth_capture()
    assert read_bytes(whole) == (COMMANDS[:1], None)
    for size in range(len(whole)):
        frames, trouble = read_bytes(whole[:size])
        assert frames == [], size
        assert trouble is not None or size in (16, 16 + 24 + 17, 16 + 24 + 17 + 24 + 21)


@pytest.mark.parametrize("way", ["pcap <", "pcapng < packet"])
def test_a_gzip_stream_may_be_cut_off_anywhere(way: str) -> None:
    """Everything that zlib returns is read: a frame is lost only if its packet is incomplete."""
    packed = gzip.compress(WAYS[way])
    ends = [WAYS[way].index(command) + len(command) for command in COMMANDS]
    whole_packets = 0
    for size in range(2, len(packed)):
        unpacked = zlib.decompressobj(31).decompress(packed[:size])
        there = [command for command, end in zip(COMMANDS, ends, strict=True) if end <= len(unpacked)]
        frames, trouble = read_bytes(packed[:size])
        # A block of pcapng must be complete, not only the frame in it.
        assert frames == there[: len(frames)], size
        assert len(there) - len(frames) <= way.startswith("pcapng"), size
        assert trouble is not None, size
        whole_packets += len(frames)
    assert whole_packets > 0


def test_a_gzip_stream_may_have_a_wrong_check_sum_or_something_behind_it() -> None:
    packed = WAYS["gzip pcap <"]
    for damaged in (packed[:-8] + bytes(8), packed + b"no gzip"):
        frames, trouble = read_bytes(damaged)
        assert frames == COMMANDS
        assert trouble is not None
        assert trouble.startswith("the gzip stream is cut off or damaged: ")
    assert read_bytes(packed + bytes(512)) == (COMMANDS, None)  # as on tapes


def test_a_gzip_stream_may_have_nothing_of_use_in_it() -> None:
    formats = "expected pcap, pcapng, btsnoop, pklg or usbmon's text, compressed with gzip or not"
    assert read_bytes(gzip.compress(b"hello, world")) == (
        [],
        f"not a capture file: it begins with 68 65 6C 6C 6F 2C 20 77; {formats}",
    )
    assert read_bytes(gzip.compress(b"")) == ([], f"not a capture file: it is empty; {formats}")
    assert read_bytes(b"\x1f\x8b\x08") == (
        [],
        "the gzip stream is cut off or damaged: Compressed file ended before the end-of-stream marker was reached",
    )


@pytest.mark.parametrize("order", ["<", ">"])
@pytest.mark.parametrize("length", [0xFFFFFFFF, 0x80000000, (1 << 24) + 1])
def test_a_packet_that_claims_to_be_huge_takes_no_memory(order: str, length: int) -> None:
    whole = pcap(RAW_IP, timed(segments()), order=order)
    record = struct.pack(order + "IIII", 0, 0, length, length)
    tracemalloc.start()
    frames, trouble = read_bytes(whole + record + bytes(1000))
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    sentence = f"the file is damaged at offset 354: packet 6 would have {length} bytes; what follows cannot be read"
    assert (frames, trouble) == (COMMANDS, sentence)
    assert peak < 2_000_000


def test_a_btsnoop_file_of_another_kind_is_told() -> None:
    assert read_bytes(btsnoop(1003, [], [])) == (
        [],
        "unknown packet kind 1003 of a btsnoop file of version 1; expected one of 1001, 1002, 2001",
    )


def test_packets_of_an_unknown_link_are_passed_over_and_told() -> None:
    blocks = Blocks()
    blocks.interface(147)
    blocks.interface(RAW_IP)
    blocks.interface(148)
    for interface in (0, 1, 2, 0):
        blocks.packet(0, segments()[0] if interface == 1 else b"12345", interface=interface)
    capture = read(io.BytesIO(blocks.data()))
    frames, trouble = everything(capture)
    assert frames == COMMANDS[:1]
    assert trouble is not None
    assert trouble.startswith("packets of link type 147, 148 were not read")
    assert capture.account.other == 15


@pytest.mark.parametrize("start", [b"\x7fELF", b"PK\x03\x04", b"XCP\0", b"\x0a\x0d\x0d", b"snoop\0\0\0", b"0f00"])
def test_another_format_is_told_at_once(start: bytes, tmp_path: Path) -> None:
    path = tmp_path / "capture.pcap"
    path.write_bytes(start + b"\xff" * 100)
    with pytest.raises(CaptureError, match="not a capture file: it begins with "):
        read(path)
    assert path.stat().st_size > 100


# Streams and files


class Trickle(io.RawIOBase):
    """A pipe with a slow writer: a read returns one byte."""

    def __init__(self, data: bytes) -> None:
        self.left = data

    def readable(self) -> bool:
        return True

    def readinto(self, target: memoryview) -> int:  # type: ignore[override]
        piece, self.left = self.left[:1], self.left[1:]
        target[: len(piece)] = piece
        return len(piece)


@pytest.mark.parametrize("way", ["pcap <", "pcapng > packet", "gzip pcap <"])
def test_a_stream_may_come_byte_by_byte(way: str) -> None:
    assert everything(read(io.BufferedReader(Trickle(WAYS[way])))) == (COMMANDS, None)
    assert everything(read(Trickle(WAYS[way]))) == (COMMANDS, None)  # type: ignore[arg-type]


def test_packets_in_a_pipe_are_given_as_they_come() -> None:
    """Reading does not wait for the rest: a capture can be read while it is written."""
    reader, writer = os.pipe()
    whole = WAYS["pcap <"]
    with os.fdopen(reader, "rb") as stream, os.fdopen(writer, "wb", buffering=0) as source:
        source.write(whole[: 24 + 66])
        records = iter(read(stream))
        assert next(records).frame == COMMANDS[0]
        source.write(whole[24 + 66 : 24 + 132])
        assert next(records).frame == COMMANDS[1]


def test_a_stream_of_ones_own_stays_open() -> None:
    for way in ("pcap <", "gzip pcap <"):
        stream = io.BytesIO(WAYS[way])
        capture = read(stream)
        assert everything(capture) == (COMMANDS, None)
        capture.close()
        del capture
        gc.collect()
        assert not stream.closed
        stream.seek(0)
        assert everything(read(stream)) == (COMMANDS, None)


class Watched(io.BytesIO):
    """Counts the bytes that were read."""

    most = 0

    def read1(self, size: int | None = -1, /) -> bytes:
        data = super().read1(size)
        self.most += len(data)
        return data


def test_nothing_is_read_before_iteration() -> None:
    packets = timed([segments()[0]] + [segments()[0]] * 5000)
    stream = Watched(pcap(RAW_IP, packets))
    capture = read(stream)
    assert stream.most <= 8
    assert capture.account.packets == 0
    records = iter(capture)
    next(records)
    assert stream.most <= 65536
    assert capture.account.packets == 1
    del records
    assert capture.account.packets == 1


def open_files(path: Path) -> int:
    """Returns how often a file is open in this process, if the system tells."""
    if not Path("/proc/self/fd").exists():
        pytest.skip("no /proc here")
    found = 0
    for entry in Path("/proc/self/fd").iterdir():
        try:
            found += entry.samefile(path)
        except OSError:
            continue
    return found


@pytest.fixture
def path(tmp_path: Path) -> Iterator[Path]:
    path = tmp_path / "a.pcap"
    path.write_bytes(WAYS["pcap <"])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield path


def test_the_file_is_closed_at_the_end(path: Path) -> None:
    capture = read(path)
    assert open_files(path) == 1
    assert len(list(capture)) == 5
    assert open_files(path) == 0
    assert list(capture) == []


def test_the_file_is_closed_on_close(path: Path) -> None:
    capture = read(path)
    records = iter(capture)
    next(records)
    capture.close()
    assert open_files(path) == 0
    assert list(records) == []  # iterating just ends
    capture.close()
    never_iterated = read(path)
    never_iterated.close()
    assert open_files(path) == 0
    assert list(never_iterated) == []


def test_the_file_is_closed_when_the_iterator_is_dropped(path: Path) -> None:
    records = iter(read(path))
    next(records)
    assert open_files(path) == 1
    del records
    assert open_files(path) == 0
    records = iter(read(path))  # never started
    del records
    assert open_files(path) == 0
    for _ in read(path):
        break
    assert open_files(path) == 0


def test_the_file_is_closed_when_it_is_refused(path: Path) -> None:
    path.write_bytes(b"no capture")
    with pytest.raises(CaptureError):
        read(path)
    assert open_files(path) == 0


def test_the_file_is_closed_when_reading_goes_wrong(path: Path) -> None:
    path.write_bytes(WAYS["pcap <"][:-1])
    capture = read(path)
    with pytest.raises(CaptureError):
        list(capture)
    assert open_files(path) == 0


def test_progress_goes_from_0_to_1(path: Path) -> None:
    path.write_bytes(pcap(RAW_IP, timed([segments()[0]] * 5000)))
    with read(path) as capture:
        assert capture.progress is not None
        assert capture.progress < 0.1
        seen = [capture.progress for _ in capture.events()]
    assert all(one is not None for one in seen)


def test_a_file_that_is_not_there_is_an_os_error(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        read(tmp_path / "nothing.pcap")
    with pytest.raises(IsADirectoryError):
        read(tmp_path)
