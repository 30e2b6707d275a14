"""Malformed captures: damaged, shuffled and random ones are read to their end, and no byte is lost."""

from __future__ import annotations

import gzip
import io
import random
import struct
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from support.effort import effort
from support.files import Blocks, Timed, btsnoop, pcap, timed
from support.messages import voltage
from support.packets import ACK, FIN, PUSH, RST, SYN, Device, SerialPort, datagram, packets_of, segment
from support.packets import Capture as Packets

import ev3proto
from ev3proto.capture import Account, Announcement, CaptureError, Event, Record, read
from ev3proto.capture.dialogues import dialogues
from ev3proto.capture.formats import CaptureFile
from ev3proto.capture.record import utc

CAPTURES = Path(__file__).parents[2] / "captures"
LINKS = (0, 1, 12, 14, 101, 108, 113, 187, 189, 201, 220, 228, 229, 249, 254, 276)

fuzzed = settings(max_examples=effort(100, 5000), suppress_health_check=list(HealthCheck))


def read_to_its_end(data: bytes) -> list[Event]:
    """Reads everything in a capture and every public attribute of it; checks that every byte is accounted for."""
    events: list[Event] = []
    sentence, account = "all is well", Account()
    try:
        capture = read(io.BytesIO(data))
        account = capture.account
        for event in capture.events():
            events.append(event)
    except CaptureError as error:
        sentence = str(error)
    assert sentence
    assert "\n" not in sentence
    assert account.balance == 0, account
    assert all(count >= 0 for count in account.parts.values()), account
    assert account.frames == sum(len(event.frame) for event in events if isinstance(event, Record))
    texts = sum(len(event.data) for event in events if isinstance(event, Announcement))
    assert account.texts >= texts
    skipped = sum(len(event.data) for event in events if not isinstance(event, Record | Announcement))
    assert account.skipped == skipped
    for event in events:
        look_at(event)
    assert len(list(dialogues(events))) <= len(events)
    return events


def look_at(event: Event) -> None:
    assert utc(event.time_ns)
    if isinstance(event, Record):
        assert event.message is not None
        assert isinstance(event.values, list)
        assert repr(event)
        assert event.latency is None or event.request is not None
        assert event.number == max(event.numbers) >= min(event.numbers) >= 1
        assert event.peer in (event.source, event.target)
    elif isinstance(event, Announcement):
        assert event.data
        assert isinstance(event.facts, dict)
    else:
        assert str(event)
        assert event.data or event.missing or "another place" in event.reason


# Files in which everything may be changed


def reply(counter: int) -> bytes:
    return struct.pack("<HHBf", 7, counter, 0x02, 7.5)


def wifi() -> bytes:
    """A connection with everything that can happen."""
    packets = [
        datagram(ev3proto.Beacon("0016530f0f0f").build()),
        segment(True, 99, flags=SYN),
        segment(False, 199, flags=SYN, acknowledged=100),
        segment(True, 100, ev3proto.Unlock("0016530f0f0f").build(), acknowledged=200),
        segment(False, 200, b"Accept:EV340\r\n\r\n\0", acknowledged=167),
        segment(True, 167, voltage(1) + voltage(2)[:5], acknowledged=217),
        segment(True, 187, voltage(3), acknowledged=217),
        segment(True, 182, voltage(2)[5:], acknowledged=217),
        segment(False, 217, reply(1) + reply(2), acknowledged=197),
        segment(True, 197, flags=RST),
    ]
    return pcap(101, timed(packets))


def usb() -> bytes:
    packets = Packets(220)
    device = Device(packets, size=64)
    device.enumerate(0x0694, 0x0005)
    device.send(voltage(1))
    device.receive(reply(1))
    return packets.data()


def bluetooth() -> bytes:
    packets = Packets(201)
    port = SerialPort(packets)
    port.send(voltage(1) + voltage(2)[:3])
    port.send(voltage(2)[3:])
    port.receive(reply(1) + reply(2))
    return packets.data()


def in_blocks(order: str) -> bytes:
    blocks = Blocks(order)
    blocks.interface(101, name="wlan0", resolution=9)
    for number, data in enumerate(packets_of(wifi())):
        blocks.packet(number, data)
    blocks.section("<" if order == ">" else ">")
    blocks.interface(201)
    for data in packets_of(bluetooth()):
        blocks.packet(0, data)
    return blocks.data()


def snoop() -> bytes:
    packets = list(packets_of(bluetooth()))
    return btsnoop(1002, timed([data[4:] for data in packets]), [data[3] for data in packets])


@cache
def seeds() -> list[bytes]:
    small = [path.read_bytes() for path in sorted(CAPTURES.glob("*.pcap*")) if path.stat().st_size < 12_000]
    return [wifi(), usb(), bluetooth(), in_blocks("<"), in_blocks(">"), snoop(), gzip.compress(wifi()), *small]


class Change(NamedTuple):
    """Changes a file or a packet in some place."""

    what: str
    where: float
    value: int


changes = st.builds(
    Change,
    st.sampled_from(("byte", "bit", "cut", "insert", "double", "drop", "word", "huge")),
    st.floats(0, 1, exclude_max=True),
    st.integers(0, 255),
)


def changed(data: bytes, made: Sequence[Change]) -> bytes:
    found = bytearray(data)
    for what, where, value in made:
        at = int(where * len(found))
        if not found:
            break
        if what == "byte":
            found[at] = value
        elif what == "bit":
            found[at] ^= 1 << value % 8
        elif what == "cut":
            del found[max(at, 1) :]
        elif what == "insert":
            found[at:at] = bytes((value,)) * (value % 9 + 1)
        elif what == "double":
            found[at:at] = found[at : at + value]
        elif what == "drop":
            del found[at : at + value % 32]
        elif what == "word":
            found[at : at + 2] = value.to_bytes(2, "big")
        else:
            found[at : at + 4] = b"\xff\xff\xff" + bytes((value,))
    return bytes(found)


# Packets in which everything may be changed


@cache
def packet_seeds() -> list[tuple[int, list[Timed]]]:
    found = []
    for data in seeds():
        packets = list(CaptureFile(io.BytesIO(data)).packets())
        by_link: dict[int, list[Timed]] = {}
        for packet in packets:
            by_link.setdefault(packet.interface.link, []).append(Timed(packet.time_ns, packet.data, packet.size))
        found += [(link, some) for link, some in by_link.items() if link in LINKS]
    return found


orders = st.lists(st.tuples(st.sampled_from(("drop", "double", "swap", "cut", "change")), st.integers(0, 10_000)))


@fuzzed
@given(st.integers(0, 100), orders, st.lists(changes, min_size=1, max_size=4), st.booleans())
def test_shuffled_and_damaged_packets(
    which: int, made: list[tuple[str, int]], damage: list[Change], is_big: bool
) -> None:
    link, seed = packet_seeds()[which % len(packet_seeds())]
    packets = list(seed)
    for what, value in made:
        if not packets:
            break
        at = value % len(packets)
        time_ns, data, size = packets[at]
        if what == "drop":
            del packets[at]
        elif what == "double":
            packets.insert(value // 7 % len(packets), packets[at])
        elif what == "swap":
            other = value // 7 % len(packets)
            packets[at], packets[other] = packets[other], packets[at]
        elif what == "cut":
            packets[at] = Timed(time_ns, data[: value // 7 % (len(data) + 1)], size)
        else:
            packets[at] = Timed(time_ns, changed(data, damage), size)
    read_to_its_end(pcap(link, packets, order=">" if is_big else "<"))


@fuzzed
@given(st.sampled_from(LINKS), st.lists(st.binary(max_size=120), max_size=8), st.sampled_from("<>"))
def test_random_packets_of_every_link(link: int, packets: list[bytes], order: str) -> None:
    read_to_its_end(pcap(link, timed(packets), order=order))


# Streams


class Sent(NamedTuple):
    """A segment: a piece of the stream, or anything else."""

    start: int
    size: int
    flags: int
    acknowledged: int | None
    garbage: bytes


STREAM = b"".join(voltage(number) for number in range(3)) + reply(9) + struct.pack("<HHB", 300, 4, 2) + bytes(297)
sent = st.builds(
    Sent,
    st.integers(0, len(STREAM)),
    st.integers(0, 60),
    st.sampled_from((0, 0, 0, ACK, PUSH, FIN, SYN, RST)),
    st.none() | st.integers(0, len(STREAM) + 50),
    st.just(b"") | st.binary(max_size=20),
)


@fuzzed
@given(st.lists(st.tuples(st.booleans(), sent), max_size=30), st.integers(0, 2**32 - 1))
def test_any_segments_in_any_order(segments: list[tuple[bool, Sent]], begin: int) -> None:
    packets = []
    for from_host, (start, size, flags, acknowledged, garbage) in segments:
        data = garbage or STREAM[start : start + size]
        number = None if acknowledged is None else begin + acknowledged
        packets.append(segment(from_host, begin + start, data, flags=flags, acknowledged=number))
    read_to_its_end(pcap(101, timed(packets)))


@fuzzed
@given(
    st.lists(st.integers(1, len(STREAM)), max_size=20),
    st.lists(st.tuples(st.integers(0, len(STREAM)), st.integers(1, 80)), max_size=10),
    st.integers(0, 2**32 - 1),
    st.randoms(use_true_random=False),
)
def test_all_of_a_stream_gives_all_of_its_frames(
    cuts: list[int], repeats: list[tuple[int, int]], begin: int, rng: random.Random
) -> None:
    """If the capture has its start, every frame is given once, however the stream is cut, repeated and shuffled."""
    spans = list(zip([0, *sorted(cuts)], [*sorted(cuts), len(STREAM)], strict=True))
    spans += [(start, start + size) for start, size in repeats]
    rng.shuffle(spans)
    packets = [segment(True, begin + start, STREAM[start:stop]) for start, stop in spans]
    events = read_to_its_end(pcap(101, timed([segment(True, begin - 1, flags=SYN), *packets])))
    assert b"".join(event.frame for event in events if isinstance(event, Record)) == STREAM
    assert len(events) == 5


@fuzzed
@given(st.lists(st.binary(max_size=40) | st.sampled_from((voltage(1), reply(1), voltage(2)[:4], voltage(2)[4:]))))
def test_anything_in_a_serial_port(pieces: list[bytes]) -> None:
    packets = Packets(201)
    port = SerialPort(packets)
    for number, piece in enumerate(pieces):
        (port.receive if number % 3 == 2 else port.send)(piece)
    read_to_its_end(packets.data())
