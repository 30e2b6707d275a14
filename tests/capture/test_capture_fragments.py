"""Fragmented IP packets: reassembled as in Wireshark, whatever their headers say."""

from __future__ import annotations

import io
import random
import struct
from collections.abc import Callable
from itertools import chain

import pytest
from support.packets import BRICK, EVERYBODY, HOST, RAW_IP, Capture, Connection, datagram, fragments
from support.wireshark import Tshark

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.capture import Announcement, Event, Record, Skipped, read
from ev3proto.capture import Capture as Captured
from ev3proto.capture.carriers.wifi.fragments import MOST_SECONDS
from ev3proto.pyshark import read as read_by_tshark

TONE = bytes.fromhex("0e00020080 0000 94010582b80182fa00")
VOLTAGE = bytes.fromhex("0800010000 0400 810160")
ANSWER = bytes.fromhex("0700010002 a470fd40")
BEACON = b"Serial-Number: 0016530f0f0f\r\nPort: 5555\r\nName: EV3\r\nProtocol: EV3\r\n"
IPV6 = [bytes.fromhex(f"20010db8{number:024x}") for number in (1, 10)]
PART = struct.Struct(">BBHI")


def ours(capture: Capture | bytes, memory: int = DEFAULT_MEMORY) -> tuple[list[Event], Captured]:
    """Returns all events of a capture; checks that every byte is accounted for."""
    opened = read(io.BytesIO(capture if isinstance(capture, bytes) else capture.data()), memory=memory)
    events = list(opened.events())
    assert opened.account.balance == 0
    assert all(count >= 0 for count in opened.account.parts.values())
    return events, opened


def found(events: list[Event]) -> list[tuple[bytes, tuple[int, ...], int]]:
    """Returns the frames and texts of a capture, with their packets and times."""
    assert not any(isinstance(event, Skipped) for event in events), events
    return [
        (event.frame if isinstance(event, Record) else event.data, event.numbers, event.time_ns)
        for event in events
        if isinstance(event, Record | Announcement)
    ]


def in_ipv6(packet: bytes, size: int, identity: int = 1) -> list[bytes]:
    """The fragments of an IPv6 packet with the contents of an IP packet."""
    data, protocol, parts = packet[20:], packet[9], []
    ends = IPV6 if packet[12:16] == HOST else IPV6[::-1]
    for at in range(0, len(data), size):
        part = data[at : at + size]
        head = struct.pack(">IHBB", 6 << 28, PART.size + len(part), 44, 64) + b"".join(ends)
        parts.append(head + PART.pack(protocol, 0, at | (at + size < len(data)), identity) + part)
    return parts


def dialogue(split: Callable[[bytes, int, int], list[bytes]]) -> Capture:
    """A command, a question and its answer in fragments, those of the question in the wrong order; then a beacon."""
    capture = Capture(RAW_IP)
    talk = Connection(capture)
    parts = [
        split(talk.segment(True, TONE), 16, 7),
        split(talk.segment(True, VOLTAGE), 8, 8)[::-1],
        split(talk.segment(False, ANSWER), 24, 7),
        split(datagram(BEACON), 24, 9),
    ]
    for packet in chain.from_iterable(parts):
        capture.add(packet)
    return capture


@pytest.mark.parametrize("split", [fragments, in_ipv6], ids=["IPv4", "IPv6"])
def test_both_engines_put_parts_together(
    split: Callable[[bytes, int, int], list[bytes]], tshark: Tshark, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tshark.folder))
    path = tshark.place(dialogue(split).data(), "parts.pcap")
    events, captured = ours(path.read_bytes())
    assert [(data, numbers) for data, numbers, _ in found(events)] == [
        (TONE, (3,)),
        (VOLTAGE, (7,)),
        (ANSWER, (9,)),
        (BEACON, (13,)),
    ]
    assert captured.account.forgotten == 0
    theirs = list(read_by_tshark(path, tshark=str(tshark.path)).events())
    assert found(theirs) == found(events)
    assert [event.route for event in theirs] == [event.route for event in events]
    assert isinstance(events[2], Record)
    assert events[2].request is events[1]


def test_parts_of_several_packets_at_once() -> None:
    capture = Capture(RAW_IP)
    parts = [fragments(Connection(capture, 50000 + each).segment(True, TONE), 16, each) for each in range(5)]
    for index in range(3):
        for each in parts:
            capture.add(each[index])
    events, _ = ours(capture)
    assert [numbers for _, numbers, _ in found(events)] == [(11,), (12,), (13,), (14,), (15,)]


def changed(part: bytes, *, at: int | None = None, is_more: bool | None = None, data: bytes | None = None) -> bytes:
    """The same fragment with a different header, or with other data."""
    word = struct.unpack_from(">H", part, 6)[0]
    word = word if at is None else word & ~0x1FFF | at // 8
    word = word if is_more is None else word & ~0x2000 | 0x2000 * is_more
    data = part[20:] if data is None else data
    return part[:2] + struct.pack(">H", 20 + len(data)) + part[4:6] + struct.pack(">H", word) + part[8:20] + data


def test_parts_that_come_twice_or_overlap() -> None:
    """If bytes differ, those captured first win."""
    capture = Capture(RAW_IP)
    first, second, third = fragments(Connection(capture).segment(True, TONE), 16)
    overlapping = changed(second, at=8, data=bytes(8) + second[20:])
    for packet in (first, first, overlapping, changed(second, data=bytes(16)), third):
        capture.add(packet)
    events, _ = ours(capture)
    assert found(events) == [(TONE, (5,), 4_000_000)]


@pytest.mark.parametrize(
    "odd",
    [
        lambda parts: changed(parts[2], at=8, is_more=False, data=bytes(8)),  # another end
        lambda parts: changed(parts[1], at=0x1FFF * 8, is_more=False, data=bytes(1000)),  # beyond the longest packet
        lambda parts: changed(parts[1], at=64, is_more=True, data=bytes(16)),  # beyond the end
        lambda parts: changed(parts[1], is_more=True, data=bytes(13)),  # what follows cannot begin there
        lambda parts: changed(parts[1], is_more=True, data=b""),
        lambda parts: parts[1][:-4],  # its length field is larger than the packet
        lambda parts: parts[1][:2] + b"\xff\xff" + parts[1][4:],
        lambda parts: b"\x4f" + parts[1][1:],
    ],
)
def test_parts_at_odds_with_the_others_are_passed_over(odd: Callable[[list[bytes]], bytes]) -> None:
    capture = Capture(RAW_IP)
    first, second, third = parts = fragments(Connection(capture).segment(True, TONE), 16)
    for packet in (third, odd(parts), first, second):
        capture.add(packet)
    events, captured = ours(capture)
    assert found(events) == [(TONE, (4,), 3_000_000)]
    assert captured.account.other > 0


def test_parts_of_others_are_left_alone() -> None:
    capture = Capture(RAW_IP)
    other = Connection(capture, brick_port=80).segment(True, b"GET / HTTP/1.1\r\n\r\n")
    for packet in fragments(other, 8) + fragments(datagram(b"hello, world", target_port=53), 8, 2):
        capture.add(packet)
    events, captured = ours(capture)
    assert events == []
    assert captured.account.other == captured.account.captured


def test_parts_whose_rest_never_comes(tshark: Tshark, monkeypatch: pytest.MonkeyPatch) -> None:
    """Even if a frame is in one of them."""
    monkeypatch.setattr("tempfile.tempdir", str(tshark.folder))
    capture = Capture(RAW_IP)
    talk = Connection(capture)
    talk.send(VOLTAGE)
    capture.add(fragments(talk.segment(True, VOLTAGE + TONE), 32)[0])
    talk.receive(ANSWER)
    events, _ = ours(capture)
    path = tshark.place(capture.data(), "lost.pcap")
    theirs = list(read_by_tshark(path, tshark=str(tshark.path)).events())
    assert found(events) == found(theirs)
    assert [numbers for _, numbers, _ in found(events)] == [(1,), (3,)]


def test_parts_whose_rest_never_comes_leave_a_hole() -> None:
    capture = Capture(RAW_IP)
    talk = Connection(capture)
    talk.send(VOLTAGE)
    for packet in fragments(talk.segment(True, TONE), 16)[:2]:
        capture.add(packet)
    talk.send(VOLTAGE)
    events, _ = ours(capture)
    assert [event.number for event in events if isinstance(event, Record)] == [1, 4]
    assert [event.missing for event in events if isinstance(event, Skipped)] == [len(TONE)]


@pytest.mark.parametrize(("seconds", "count"), [(MOST_SECONDS, 1), (MOST_SECONDS + 1, 0)])
def test_parts_belong_together_for_a_while_only(seconds: int, count: int) -> None:
    """Identification numbers are used again."""
    first, *rest = fragments(Connection(Capture(RAW_IP)).segment(True, TONE), 16)
    capture = Capture(RAW_IP)
    capture.add(first)
    capture.count += seconds * 1000 - 2
    for packet in rest:
        capture.add(packet)
    opened = read(io.BytesIO(capture.data()))
    assert len(list(opened)) == count


def test_many_parts_take_no_more_memory_than_they_may() -> None:
    """Each of them claims to be the end of the longest packet."""
    capture = Capture(RAW_IP)
    part = fragments(datagram(bytes(64)), 16)[1]
    for identity in range(3000):
        capture.add(changed(part[:4] + struct.pack(">H", identity) + part[6:], at=65_000))
    for packet in fragments(Connection(capture).segment(True, TONE), 16, 5000):
        capture.add(packet)
    events, captured = ours(capture, 1 << 20)
    assert [data for data, _, _ in found(events)] == [TONE]
    assert captured.account.forgotten >= 2900


def test_packets_in_parts_in_packets_in_parts_have_an_end() -> None:
    """Each complete packet completes the one around it."""
    packet = datagram(BEACON)
    capture, last = Capture(RAW_IP), []
    for identity in range(40):
        head = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(packet), identity, 0, 64, 4, 0, BRICK, EVERYBODY)
        *first, packet = fragments(head + packet, 24, identity)
        last += first
    for part in last[::-1]:
        capture.add(part)
    capture.add(packet)
    events, _ = ours(capture)
    assert len(events) <= 1


def test_parts_of_any_kind_do_no_harm() -> None:
    chance = random.Random(7)
    whole = [Connection(Capture(RAW_IP), 50000 + each).segment(True, TONE) for each in range(4)]
    parts = [part for each in whole for split in (fragments, in_ipv6) for part in split(each, 8, 1)]
    capture = Capture(RAW_IP)
    for _ in range(5000):
        part = bytearray(chance.choice(parts))
        for _ in range(chance.randrange(3)):
            part[chance.randrange(len(part))] = chance.randrange(256)
        capture.add(bytes(part[: chance.randrange(len(part) + 1)] if chance.random() < 0.1 else part))
    opened = read(io.BytesIO(capture.data()))
    list(opened.events())
    assert opened.account.balance == 0
    assert all(count >= 0 for count in opened.account.parts.values())
