"""Malformed captures: damaged, shuffled and random packets are read to their end, and no byte is lost.

The fuzzer of captures says what must hold; it also damages whole files (`tests/architecture/test_fuzz.py`).
"""

from __future__ import annotations

import io
import random
import struct
from functools import cache
from itertools import groupby
from typing import NamedTuple

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from support.effort import effort
from support.files import Timed, pcap, timed
from support.messages import voltage, volts
from support.packets import ACK, FIN, PUSH, RST, SYN, SerialPort, segment
from support.packets import Capture as Packets

from ev3proto.capture import Record
from ev3proto.capture.formats import CaptureFile
from ev3proto.capture.packets import Packet
from fuzz.captures import one_input
from fuzz.corpus import CAPTURES, mutated

LINKS = (0, 1, 12, 14, 101, 108, 113, 187, 189, 201, 220, 228, 229, 249, 254, 276)

fuzzed = settings(max_examples=effort(100, 5000), suppress_health_check=list(HealthCheck))


# Packets in which everything may be changed


def link_of(packet: Packet) -> int:
    return packet.interface.link


@cache
def packet_seeds() -> list[tuple[int, list[Timed]]]:
    """The packets of small captures, for each link type."""
    found = []
    for path in sorted(CAPTURES.glob("*.pcap*")):
        if path.stat().st_size < 12_000:
            packets = sorted(CaptureFile(io.BytesIO(path.read_bytes())).packets(), key=link_of)
            for link, some in groupby(packets, link_of):
                found.append((link, [Timed(packet.time_ns, packet.data, packet.size) for packet in some]))
    return found


@fuzzed
@given(st.integers(0, 100), st.integers(1, 20), st.booleans(), st.randoms(use_true_random=False))
def test_shuffled_and_damaged_packets(which: int, changes: int, is_big: bool, rng: random.Random) -> None:
    link, seed = packet_seeds()[which % len(packet_seeds())]
    packets = list(seed)
    for _ in range(changes):
        one, other = rng.choice(packets), rng.randrange(len(packets) + 1)
        packets[other:other] = [one] * rng.randrange(2)
        packets.remove(rng.choice(packets))
        at = rng.randrange(len(packets)) if packets else 0
        for time_ns, data, size in packets[at : at + 1]:
            damaged = rng.choice((data, data[: rng.randrange(len(data) + 1)], mutated(data, rng, [data])))
            packets[at] = Timed(time_ns, damaged, size)
        packets = packets or list(seed)
    one_input(pcap(link, packets, order=">" if is_big else "<"))


@fuzzed
@given(st.sampled_from(LINKS), st.lists(st.binary(max_size=120), max_size=8), st.sampled_from("<>"))
def test_random_packets_of_every_link(link: int, packets: list[bytes], order: str) -> None:
    one_input(pcap(link, timed(packets), order=order))


# Streams


class Sent(NamedTuple):
    """A segment: a piece of the stream, or anything else."""

    start: int
    size: int
    flags: int
    acknowledged: int | None
    garbage: bytes


STREAM = b"".join(voltage(number) for number in range(3)) + volts(9) + struct.pack("<HHB", 300, 4, 2) + bytes(297)
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
    one_input(pcap(101, timed(packets)))


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
    events = one_input(pcap(101, timed([segment(True, begin - 1, flags=SYN), *packets])))
    assert b"".join(event.frame for event in events if isinstance(event, Record)) == STREAM
    assert len(events) == 5


@fuzzed
@given(st.lists(st.binary(max_size=40) | st.sampled_from((voltage(1), volts(1), voltage(2)[:4], voltage(2)[4:]))))
def test_anything_in_a_serial_port(pieces: list[bytes]) -> None:
    packets = Packets(201)
    port = SerialPort(packets)
    for number, piece in enumerate(pieces):
        (port.receive if number % 3 == 2 else port.send)(piece)
    one_input(packets.data())
