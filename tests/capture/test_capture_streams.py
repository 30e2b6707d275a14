"""Reassembled byte streams: what TCP and RFCOMM do to frames, and what a capture does to TCP and RFCOMM."""

from __future__ import annotations

import io
import itertools
import random
import struct
from collections.abc import Iterable, Iterator

import pytest
from support.files import BEGIN_NS, RAW_IP, Blocks, Timed, btsnoop, pcap, timed
from support.messages import voltage, volts
from support.packets import FIN, HCI_WITH_DIRECTION, RST, SYN, SerialPort, frame_check, segment
from support.packets import Capture as Packets
from support.reading import opened

import ev3proto
from ev3proto.capture import Announcement, Capture, Event, Record, Skipped, read

UNLOCK = ev3proto.Unlock("0016530f0f0f").build()
ACCEPT = b"Accept:EV340\r\n\r\n"
HCI = 201


def tone(counter: int) -> bytes:
    """SOUND.TONE, 15 bytes: its length starts with the byte of a carriage return."""
    return struct.pack("<HHB", 13, counter, 0x80) + bytes.fromhex("0000 94 01 01 82B801 8164")


def led(counter: int) -> bytes:
    """A command of 12 bytes: its length starts with the byte of a line feed."""
    return struct.pack("<HHB", 10, counter, 0x80) + bytes.fromhex("0000 821b01 01 01")


def of(packets: Iterable[bytes], link: int = RAW_IP) -> tuple[list[Event], Capture]:
    return opened(pcap(link, timed(list(packets))))


def frames(events: Iterable[Event]) -> list[tuple[bytes, tuple[int, ...]]]:
    """Returns the frames and their packets."""
    return [(event.frame, event.numbers) for event in events if isinstance(event, Record)]


def complaints(events: Iterable[Event]) -> list[tuple[bytes, int, int, str]]:
    """Returns what was skipped: bytes, missing bytes, place, and reason."""
    return [(event.data, event.missing, event.number, event.reason) for event in events if isinstance(event, Skipped)]


def connected(*pieces: bytes, at: int = 1000) -> Iterator[bytes]:
    """A connection from its start, in which the host sends these pieces."""
    yield segment(True, at - 1, flags=SYN)
    for piece in pieces:
        yield segment(True, at, piece)
        at += len(piece)


# Frames


def test_frames_share_segments_and_are_split_over_them() -> None:
    stream = b"".join(map(voltage, range(4)))
    events, _ = of(connected(stream[:10], stream[10:31], stream[31:33], stream[33:]))
    assert frames(events) == [
        (voltage(0), (2,)),
        (voltage(1), (3,)),
        (voltage(2), (3,)),
        (voltage(3), (3, 4, 5)),
    ]
    assert not complaints(events)


@pytest.mark.parametrize("size", range(1, 35))
def test_a_stream_is_cut_anywhere(size: int) -> None:
    stream = voltage(1) + tone(2) + led(3) + voltage(4)
    events, capture = of(connected(*(stream[at : at + size] for at in range(0, len(stream), size))))
    assert [frame for frame, _ in frames(events)] == [voltage(1), tone(2), led(3), voltage(4)]
    assert not complaints(events)
    assert capture.account.frames == len(stream)


def download(size: int) -> bytes:
    """CONTINUE_DOWNLOAD with this number of bytes of a file."""
    contents = struct.pack("<HBBB", 7, 0x01, 0x93, 0) + bytes(range(256)) * (size // 256) + bytes(range(size % 256))
    return struct.pack("<H", len(contents)) + contents


@pytest.mark.parametrize("size", [1018, 1100, 65530])
def test_downloads_are_longer_than_all_other_frames(size: int) -> None:
    stream = voltage(1) + download(size) + voltage(2)
    for cut in (1460, 1000, min(len(stream), 60_000)):
        pieces = [stream[at : at + cut] for at in range(0, len(stream), cut)]
        events, _ = of(connected(UNLOCK, *pieces))
        assert [frame for frame, _ in frames(events)] == [voltage(1), download(size), voltage(2)]
        assert not complaints(events)
    # With one byte at a time, the header of the long frame is read in parts.
    events, _ = of(connected(UNLOCK, voltage(1), *(bytes((byte,)) for byte in download(1100)), voltage(2)))
    assert [frame for frame, _ in frames(events)] == [voltage(1), download(1100), voltage(2)]


def test_a_long_frame_other_than_a_download_is_not_read() -> None:
    long = struct.pack("<HHB", 1100, 7, 0x80) + bytes(1097)
    events, _ = of(connected(UNLOCK, voltage(1), long, voltage(2)))
    assert [frame for frame, _ in frames(events)] == [voltage(1), voltage(2)]
    ((_, _, _, reason),) = complaints(events)
    assert reason.startswith("no frame can start here: the length field says 1100")


def test_the_rest_of_a_partly_captured_download_is_not_a_frame() -> None:
    whole = download(3000)
    stream = (UNLOCK, voltage(1), whole[:1460], whole[1460:2920], whole[2920:], voltage(2))
    packets = list(connected(*stream))
    del packets[4]
    packets.append(segment(False, 5000, volts(2), acknowledged=1000 + sum(map(len, stream))))
    events, _ = of(packets)
    assert {frame for frame, _ in frames(events)} == {voltage(1), voltage(2), volts(2)}


def test_polls_between_frames_are_passed_over() -> None:
    stream = bytes(2) + voltage(1) + bytes(2) + voltage(2) + bytes(6) + download(1100) + bytes(2)
    for size in (1, 2, 3, 11, 100, len(stream)):
        pieces = [stream[at : at + size] for at in range(0, len(stream), size)]
        events, capture = of(connected(UNLOCK, *pieces))
        assert [frame for frame, _ in frames(events)] == [voltage(1), voltage(2), download(1100)]
        assert not complaints(events)
        assert capture.account.padding == 12


def test_requests_latencies_and_values() -> None:
    packets = [
        segment(True, 999, flags=SYN),
        segment(False, 4999, flags=SYN, acknowledged=1000),
        segment(True, 1000, voltage(1) + voltage(2), acknowledged=5000),
        segment(False, 5000, volts(2, 8.25)[:4], acknowledged=1020),
        segment(False, 5004, volts(2, 8.25)[4:] + volts(1, 7.5), acknowledged=1020),
    ]
    events, _ = of(packets)
    first, second, to_second, to_first = (event for event in events if isinstance(event, Record))
    assert (to_second.request, to_first.request) == (second, first)
    assert [value.value for value in (*to_second.values, *to_first.values)] == [8.25, 7.5]
    assert (to_second.numbers, to_first.numbers) == ((4, 5), (5,))
    assert (to_second.latency, to_first.latency) == (0.002, 0.002)
    assert to_second.time_ns == BEGIN_NS + 4_000_000
    assert (first.direction, to_first.direction) == ("sent", "received")


# Texts


WITHOUT_VERSION, WITHOUT_GAP = UNLOCK.replace(b" VMTP1.0", b""), UNLOCK.replace(b": ", b":")


@pytest.mark.parametrize(
    "text", [UNLOCK, UNLOCK[:-2], UNLOCK[:-4], UNLOCK.replace(b"\r", b""), WITHOUT_VERSION, WITHOUT_GAP]
)
@pytest.mark.parametrize("frame", [voltage(1), tone(2), led(3)])
def test_an_unlock_text_is_cut_anywhere(text: bytes, frame: bytes) -> None:
    """The frame after it may start with the byte of a line end."""
    for size in range(1, len(text) + 6):
        stream = text + frame + led(9) + tone(10)
        events, capture = of(connected(*(stream[at : at + size] for at in range(0, len(stream), size))))
        if not any(text.endswith(end) for end in (b"\r\n\r\n", b"\n\n")) and size > len(text):
            continue  # a line end or a length: the reader does not know here
        assert [frame for frame, _ in frames(events)] == [frame, led(9), tone(10)], size
        assert not complaints(events), size
        (unlock,) = (event for event in events if isinstance(event, Announcement))
        assert unlock.facts == {"serial": "0016530f0f0f"}
        assert capture.account.texts == len(text)


@pytest.mark.parametrize("zero", [b"", b"\0"])
@pytest.mark.parametrize("reply", [volts(1), struct.pack("<HHB", 3, 1, 4), struct.pack("<HHB", 3, 0x101, 2)])
def test_an_accepting_text_is_cut_anywhere(zero: bytes, reply: bytes) -> None:
    text = ACCEPT + zero
    for size in range(1, len(text) + len(reply) + 1):
        stream = text + reply + volts(2)
        packets = [segment(False, 4999, flags=SYN)]
        packets += [segment(False, 5000 + at, stream[at : at + size]) for at in range(0, len(stream), size)]
        events, capture = of(packets)
        assert [frame for frame, _ in frames(events)] == [reply, volts(2)], size
        assert not complaints(events), size
        assert len([event for event in events if isinstance(event, Announcement)]) == 1
        assert capture.account.texts == len(text)


def test_a_line_end_that_comes_late_is_of_the_text_though_nothing_follows() -> None:
    for end in (b"\r", b"\n", b"\r\n", b"\r\n\r", b"\r\n\r\n"):
        events, capture = of(connected(UNLOCK[:-4], end))
        assert not complaints(events)
        assert capture.account.texts == len(UNLOCK) - 4 + len(end)


def test_a_text_that_breaks_off_is_told() -> None:
    events, _ = of(connected(UNLOCK[:20]))
    assert complaints(events) == [(UNLOCK[:20], 0, 2, "the stream ends inside a text, of which 20 bytes came")]


def test_a_text_that_never_ends_is_given_up() -> None:
    endless = b"GET /target?sn=" + b"1" * 100_000
    events, capture = of(connected(*(endless[at : at + 1000] for at in range(0, len(endless), 1000))))
    assert frames(events) == []
    assert capture.account.skipped + capture.account.other == len(endless)


# Data that is missing, repeated, or in another order


def test_a_repeated_segment_is_given_once() -> None:
    packets = [
        *connected(voltage(1), voltage(2)),
        segment(True, 1000, voltage(1)),
        segment(True, 1000, voltage(1) + voltage(2)),
        segment(True, 1010, voltage(2) + voltage(3)),
        segment(True, 1019, voltage(2)[-1:]),  # keep-alive
        segment(True, 1029),
        segment(True, 999, flags=SYN),  # the start, repeated
        segment(True, 1030, voltage(4)),
    ]
    events, capture = of(packets)
    assert frames(events) == [(voltage(1), (2,)), (voltage(2), (3,)), (voltage(3), (6,)), (voltage(4), (10,))]
    assert not complaints(events)
    assert capture.account.repeated == 10 + 20 + 10 + 1


def test_segments_in_another_order() -> None:
    """A frame that waited for an earlier one has its own time."""
    one, two, three, four = (voltage(number) for number in range(4))
    packets = [
        segment(True, 999, flags=SYN),
        segment(True, 1030, four),
        segment(True, 1015, two[5:] + three),
        segment(True, 1000, one + two[:5]),
    ]
    events, _ = of(packets)
    assert frames(events) == [(one, (4,)), (two, (4, 3)), (three, (3,)), (four, (2,))]
    times = [event.time_ns - BEGIN_NS for event in events]
    assert times == [3_000_000, 3_000_000, 2_000_000, 1_000_000]
    assert [event.number for event in events if isinstance(event, Record)] == [4, 4, 3, 2]


def test_of_segments_that_differ_the_first_is_believed() -> None:
    other = b"\xff" * 10
    packets = [
        segment(True, 999, flags=SYN),
        segment(True, 1010, voltage(2)),
        segment(True, 1010, other),
        segment(True, 1000, voltage(1)),
        segment(True, 1000, other),
    ]
    events, capture = of(packets)
    assert frames(events) == [(voltage(1), (4,)), (voltage(2), (2,))]
    assert capture.account.repeated == 20
    packets[1:3] = packets[2:0:-1]
    events, capture = of(packets)
    assert frames(events)[0] == (voltage(1), (4,))
    assert complaints(events)[0][0] == other


def test_segments_that_overlap_in_part() -> None:
    stream = b"".join(map(voltage, range(6)))
    spans = [(30, 60), (25, 40), (10, 28), (5, 12), (0, 7)]
    packets = [segment(True, 1000 + start, stream[start:stop]) for start, stop in spans]
    events, capture = of([segment(True, 999, flags=SYN), *packets])
    assert [frame for frame, _ in frames(events)] == [voltage(number) for number in range(6)]
    assert capture.account.repeated == 30 + 15 + 18 + 7 + 7 - 60


def test_a_segment_that_was_not_captured() -> None:
    """Data that the other side has acknowledged will not come any more."""
    packets = [
        *connected(voltage(1), voltage(2)[:4]),
        segment(True, 1030, voltage(4)),
        segment(True, 1040, voltage(5)),
        segment(False, 5000, acknowledged=1050),
    ]
    events, _ = of(packets)
    assert frames(events) == [(voltage(1), (2,)), (voltage(4), (4,)), (voltage(5), (5,))]
    assert complaints(events) == [
        (voltage(2)[:4], 0, 5, "the rest of the frame is not in the capture"),
        (b"", 16, 5, "16 bytes are missing in the stream: not in the capture"),
    ]
    assert [type(event) for event in events] == [Record, Skipped, Skipped, Record, Record]


def test_the_frame_after_one_that_lacks_its_middle_is_found_wherever_it_begins() -> None:
    # It has no fault that would distinguish it: any data may be from a file.
    data = b"".join(struct.pack("<HHBBB", 60, number, 0x81, 0x93, 0) + bytes(55) for number in range(3))
    cuts = [0, 20, 40, 90, 150, len(data)]
    pieces = [(at, data[at:stop]) for at, stop in itertools.pairwise(cuts) if at != 20]
    events, _ = of([*connected(voltage(9)), *(segment(True, 1010 + at, piece) for at, piece in pieces)])
    assert [frame[2] for frame, _ in frames(events)] == [9, 1, 2]


def test_a_segment_that_comes_after_it_was_given_up() -> None:
    packets = [
        *connected(voltage(1)),
        segment(True, 1020, voltage(3)),
        segment(False, 5000, acknowledged=1030),
        segment(True, 1010, voltage(2)),
        segment(True, 1010, voltage(2) + voltage(3) + voltage(4)),
    ]
    events, capture = of(packets)
    assert frames(events) == [(voltage(1), (2,)), (voltage(3), (3,)), (voltage(4), (6,))]
    late = "10 bytes came too late to be put in order"
    assert complaints(events) == [
        (b"", 10, 3, "10 bytes are missing in the stream: not in the capture"),
        (voltage(2), 0, 5, late),
        (voltage(2), 0, 6, late),
    ]
    assert (capture.account.skipped, capture.account.repeated) == (20, 10)


def test_a_command_captured_after_its_reply_is_a_message_of_its_own() -> None:
    """As on two interfaces: data that the brick has acknowledged need not be a repetition."""
    packets = [
        *connected(voltage(1)),
        segment(False, 5000, volts(1), acknowledged=1010),
        segment(False, 5009, volts(2), acknowledged=1020),
        segment(True, 1010, voltage(2), acknowledged=5009),
        segment(True, 1020, voltage(3), acknowledged=5018),
        segment(False, 5018, volts(3), acknowledged=1030),
    ]
    events, _ = of(packets)
    told = [(event.number, event.request is not None) for event in events if isinstance(event, Record)]
    assert told == [(2, False), (3, True), (4, False), (5, False), (6, False), (7, True)]
    assert not complaints(events)


def test_without_acknowledgements() -> None:
    """Waiting data is given at the end, up to a limit."""
    stream = b"".join(voltage(number) for number in range(10_000))
    pieces = [segment(True, 1000 + at, stream[at : at + 10]) for at in range(0, len(stream), 10)]
    del pieces[1]
    events, _ = of([segment(True, 999, flags=SYN), *pieces])
    assert len(frames(events)) == 9_999
    assert [(missing, number) for _, missing, number, _ in complaints(events)] == [(10, 4099)]
    events, _ = of([segment(True, 999, flags=SYN), *pieces[:100]])
    assert len(frames(events)) == 100
    assert [missing for _, missing, _, _ in complaints(events)] == [10]


def test_a_capture_begun_inside_a_frame() -> None:
    packets = [
        segment(True, 1000, voltage(1)[3:] + voltage(2) + voltage(3)),
        segment(True, 1027, voltage(4)),
        segment(False, 5000, volts(1)[-2:]),
        segment(False, 5002, volts(2)),
    ]
    events, capture = opened(pcap(RAW_IP, timed(packets)))
    assert frames(events) == [(voltage(2), (1,)), (voltage(3), (1,)), (voltage(4), (2,)), (volts(2), (4,))]
    assert [data for data, *_ in complaints(events)] == [volts(1)[-2:]]
    # Traffic before the first plausible command belongs to others.
    assert (capture.account.other, capture.account.balance) == (len(voltage(1)[3:]), 0)


@pytest.mark.parametrize(
    "inside", [b"", b"\xff\xfe", b"\xff\xff" + struct.pack("<HHB", 300, 0x0707, 0x02) + b"\xaa" * 10]
)
def test_frames_that_are_packets_do_not_wait_for_one_another(inside: bytes) -> None:
    """Whatever came before, such as the apparent beginning of a long frame: each reply is after its command."""
    at = 1000 + len(inside)
    dialogue = [
        segment(True, at, voltage(1)),
        segment(False, 5000, volts(1)),
        segment(True, at + len(voltage(1)), voltage(2)),
        segment(False, 5000 + len(volts(1)), volts(2)),
    ]
    events, _ = of([segment(True, 1000, inside), *dialogue] if inside else dialogue)
    assert [frame for frame, _ in frames(events)] == [voltage(1), volts(1), voltage(2), volts(2)]


def test_a_capture_begun_between_segments_of_a_frame() -> None:
    for cut in range(1, 10):
        packets = [segment(True, 1000, voltage(1)[cut:]), segment(True, 2000 - 990 - cut, voltage(2))]
        events, capture = opened(pcap(RAW_IP, timed(packets)))
        assert frames(events) == [(voltage(2), (2,))], cut
        assert (capture.account.other, capture.account.balance) == (10 - cut, 0), cut


def test_a_segment_from_before_the_start() -> None:
    events, _ = of([segment(True, 1010, voltage(2)), segment(True, 1005, voltage(1)[5:] + voltage(2) + voltage(3))])
    assert frames(events) == [(voltage(2), (1,)), (voltage(3), (2,))]
    assert complaints(events) == [(voltage(1)[5:], 0, 2, "5 bytes came too late to be put in order")]


@pytest.mark.parametrize("at", [2**32 - 1, 2**32 - 5, 2**32 - 10, 2**32 - 15, 0, 1])
def test_sequence_numbers_wrap(at: int) -> None:
    packets = [
        segment(True, at - 1, flags=SYN),
        segment(True, at, voltage(1)),
        segment(True, at + 20, voltage(3)),
        segment(True, at + 10, voltage(2)),
        segment(True, at + 40, voltage(5)),
        segment(False, 77, acknowledged=at + 50),
        segment(True, at, voltage(1)),
    ]
    events, capture = of(packets)
    assert [frame for frame, _ in frames(events)] == [voltage(number) for number in (1, 2, 3, 5)]
    assert [missing for _, missing, _, _ in complaints(events)] == [10]
    assert capture.account.repeated == 10


def test_a_stream_longer_than_its_numbers() -> None:
    """Positions continue when sequence numbers wrap."""
    from ev3proto.capture.carriers.streams import Piece
    from ev3proto.capture.carriers.wifi.tcp import Hole, Reassembly

    stream = Reassembly()
    at, big = 2**32 - 100, bytes(1 << 20)
    for number in range(5000):
        piece = Piece(big, number, 0)
        assert stream.add((at + number * len(big)) % 2**32, piece) == [piece]
    position = 5000 * len(big)
    assert stream.add((at + position + 7) % 2**32, Piece(b"later", 1, 0)) == []
    assert stream.add((at + position - len(big)) % 2**32, Piece(big, 2, 0)) == []
    assert stream.repeated == len(big)
    assert stream.acknowledge((at + position + 12) % 2**32) == [Hole(7), Piece(b"later", 1, 0)]


def test_a_port_is_used_again() -> None:
    """The new connection starts with its own numbers and a frame; commands of the old one get no replies in it."""
    packets = [
        segment(True, 999, flags=SYN),
        segment(False, 4999, flags=SYN, acknowledged=1000),
        segment(True, 1000, voltage(1) + voltage(2)[:4], acknowledged=5000),
        segment(True, 70_000, flags=SYN),
        segment(False, 90_000, flags=SYN, acknowledged=70_001),
        segment(True, 70_001, tone(3)[:5], acknowledged=90_001),
        segment(False, 90_001, volts(1), acknowledged=70_006),
        segment(True, 70_006, tone(3)[5:], acknowledged=90_010),
    ]
    events, _ = of(packets)
    assert frames(events) == [(voltage(1), (3,)), (volts(1), (7,)), (tone(3), (6, 8))]
    sentence = "the stream ends inside a frame, of which 4 bytes came and 6 are missing"
    assert complaints(events) == [(voltage(2)[:4], 0, 3, sentence)]
    assert [event.request for event in events if isinstance(event, Record)] == [None, None, None]


@pytest.mark.parametrize("at", [3_000_000_000, 1_000_000_000, 4_000_000_000])
def test_a_port_is_reused_without_a_captured_handshake(at: int) -> None:
    events, _ = of([*connected(voltage(1)), segment(True, at, voltage(2)), segment(True, at + 10, voltage(3))])
    assert frames(events) == [(voltage(1), (2,)), (voltage(2), (3,)), (voltage(3), (4,))]
    sentence = "the stream continues elsewhere: what is in between is not in the capture"
    assert complaints(events) == [(b"", 0, 3, sentence)]


def test_a_connection_that_is_reset() -> None:
    packets = [
        *connected(voltage(1), voltage(2)[:4]),
        segment(True, 1014, flags=RST),
        segment(True, 1014, b"\x81\x01\x60" + voltage(3)),
    ]
    events, _ = of(packets)
    assert frames(events) == [(voltage(1), (2,)), (voltage(3), (5,))]
    assert complaints(events) == [
        (voltage(2)[:4], 0, 3, "the stream ends inside a frame, of which 4 bytes came and 6 are missing"),
        (b"\x81\x01\x60", 0, 5, "bytes between frames"),
    ]


def test_the_end_of_a_connection_takes_a_sequence_number() -> None:
    packets = [
        *connected(voltage(1)),
        segment(True, 1010, flags=FIN),
        segment(False, 5000, acknowledged=1011),
        segment(True, 1011),
    ]
    events, _ = of(packets)
    assert frames(events) == [(voltage(1), (2,))]
    assert not complaints(events)


def test_segments_cut_by_the_capture() -> None:
    """Of all packets except one, 48 bytes were captured, 8 of them of the stream."""
    packets = [
        Timed(BEGIN_NS, segment(True, 989, flags=SYN)),
        Timed(BEGIN_NS, segment(True, 990, voltage(0))),
        Timed(BEGIN_NS, segment(True, 1000, voltage(1) + voltage(2))[:48], 60),
        Timed(BEGIN_NS, segment(True, 1020, voltage(3)[:8]), 48),
        Timed(BEGIN_NS, segment(False, 5000, acknowledged=1028)),
        Timed(BEGIN_NS, segment(True, 1028, voltage(3)[8:] + b"\2\0\2")[:48], 45),
        Timed(BEGIN_NS, segment(True, 1033, b"\0\2" * 15)[:48], 70),
    ]
    events, capture = opened(pcap(RAW_IP, packets))
    assert frames(events) == [(voltage(0), (2,)), (voltage(1)[:8], (3,)), (voltage(3), (4, 6))]
    assert [(len(data), missing) for data, missing, _, _ in complaints(events)] == [(0, 10), (1, 0), (10, 0), (0, 22)]
    assert [each.missing for each in events if isinstance(each, Record)] == [0, 2, 0]
    assert capture.account.skipped == 1 + 10


def test_segments_on_two_interfaces() -> None:
    """The same packet is captured on both sides of a bridge, or the two directions are captured separately."""
    blocks = Blocks()
    blocks.interface(RAW_IP, name="wlan0")
    blocks.interface(1, name="br0")
    wire = bytes(12) + b"\x08\x00"
    both = [segment(True, 999, flags=SYN), segment(True, 1000, voltage(1)), segment(True, 1010, voltage(2))]
    for packet in both:
        blocks.packet(0, packet)
        blocks.packet(0, wire + packet, interface=1)
    blocks.packet(0, wire + segment(False, 5000, volts(2)), interface=1)
    events, capture = opened(blocks.data())
    assert frames(events) == [(voltage(1), (3,)), (voltage(2), (5,)), (volts(2), (7,))]
    records = [event for event in events if isinstance(event, Record)]
    assert [record.interface for record in records] == ["wlan0", "wlan0", "br0"]
    assert records[2].request is records[1]
    assert capture.account.repeated == 20


# Garbage


def test_garbage_between_frames_is_skipped_and_told() -> None:
    garbage = b"\xff\xff\xff\xff\xff garbage"
    events, _ = of(connected(voltage(1) + garbage + voltage(2) + voltage(3), voltage(4)))
    assert frames(events) == [(voltage(1), (2,)), (voltage(2), (2,)), (voltage(3), (2,)), (voltage(4), (3,))]
    sentence = "no frame can start here: the length field says 65535, but it can be 3 to 1022"
    assert complaints(events) == [(garbage, 0, 2, sentence)]


def test_text_in_place_of_a_frame_is_told() -> None:
    events, _ = of(connected(UNLOCK, b"forward\r\n"))
    ((data, _, _, reason),) = complaints(events)
    assert data == b"forward\r\n"
    assert reason == (
        "this is the text 'forward', not a frame; a Messaging block needs WRITEMAILBOX: for its mailbox 'abc', send"
        " 13 00 00 00 81 9E 04 61 62 63 00 08 00 66 6F 72 77 61 72 64 00"
    )


def test_a_stream_of_nothing_but_garbage() -> None:
    rng = random.Random(1)
    pieces = [rng.randbytes(1000) for _ in range(200)]
    events, capture = of(connected(*pieces))
    account = capture.account
    assert events == []
    assert account.other == 200_000


def test_a_connection_kept_alive_when_the_capture_begins() -> None:
    """The byte before the next one is sent again; no frame begins with it, though it may look so."""
    events, _ = of([segment(True, 999, b"\0"), segment(True, 1000, voltage(1)), segment(True, 1010, voltage(2))])
    assert frames(events) == [(voltage(1), (2,)), (voltage(2), (3,))]
    assert complaints(events) == []


def test_what_looks_like_a_long_frame_where_a_capture_begins() -> None:
    """A frame may contain any bytes, even a length; complete frames after it are still given."""
    for packets in (
        [segment(True, 1000, b"\0\x03\0\0\0" + voltage(1) + voltage(2))],
        [segment(True, 1000, b"\0\x03\0\0\0"), segment(True, 1005, voltage(1)), segment(True, 1015, voltage(2))],
    ):
        events, capture = opened(pcap(RAW_IP, timed(packets)))
        assert [frame for frame, _ in frames(events)] == [voltage(1), voltage(2)]
        assert (capture.account.other, capture.account.balance) == (5, 0)


def test_a_frame_at_fault_is_a_frame_all_the_same() -> None:
    faulty = struct.pack("<HHB", 8, 1, 0x00) + bytes.fromhex("0400 FF FF FF")
    events, _ = of(connected(voltage(1), faulty, voltage(2)))
    assert frames(events) == [(voltage(1), (2,)), (faulty, (3,)), (voltage(2), (4,))]


# RFCOMM


class Link:
    """The packets between host and controller, with their H4 type."""

    OURS, THEIRS = 0x41, 0x51

    def __init__(self, handle: int = 0x0B) -> None:
        self.handle = handle
        self.packets: list[bytes] = []

    def event(self, data: str) -> None:
        body = bytes.fromhex(data)
        self.packets.append(struct.pack(">I", 1) + b"\x04" + body[:1] + bytes((len(body) - 1,)) + body[1:])

    def connect(self, address: str = "0a000053 1600") -> None:
        self.event(f"03 00 {self.handle.to_bytes(2, 'little').hex()} {address} 01 00")

    def disconnect(self) -> None:
        self.event(f"05 00 {self.handle.to_bytes(2, 'little').hex()} 13")

    def acl(self, from_host: bool, data: bytes, *, goes_on: bool = False) -> None:
        start = 0x1000 if goes_on else 0 if from_host else 0x2000
        head = struct.pack(">IBHH", not from_host, 2, 0, 0)[:5] + struct.pack("<HH", self.handle | start, len(data))
        self.packets.append(head + data)

    def l2cap(self, from_host: bool, channel: int, data: bytes, pieces: int = 0) -> None:
        whole = struct.pack("<HH", len(data), channel) + data
        size = pieces or len(whole)
        for at in range(0, len(whole), size):
            self.acl(from_host, whole[at : at + size], goes_on=at > 0)

    def ask(self, service: int = 3, ours: int = OURS, theirs: int = THEIRS) -> None:
        self.l2cap(True, 1, struct.pack("<BBHHH", 2, 7, 4, service, ours))
        self.l2cap(False, 1, struct.pack("<BBHHHHH", 3, 7, 8, theirs, ours, 1, 0))  # still pending
        self.l2cap(False, 1, struct.pack("<BBHHHHH", 3, 7, 8, theirs, ours, 0, 0))

    def rfcomm(
        self,
        from_host: bool,
        data: bytes,
        *,
        port: int = 2,
        kind: int = 0xEF,
        credits: int | None = None,
        wide: bool = False,
        pieces: int = 0,
        channel: int | None = None,
    ) -> None:
        head = bytes((port << 2 | from_host << 1 | 1, kind | (0 if credits is None else 0x10)))
        size = len(data)
        length = (size << 1).to_bytes(2, "little") if wide or size > 127 else bytes((size << 1 | 1,))
        extra = b"" if credits is None else bytes((credits,))
        end = bytes((frame_check(head if kind == 0xEF else head + length),))
        if channel is None:
            channel = self.THEIRS if from_host else self.OURS
        self.l2cap(from_host, channel, head + length + extra + data + end, pieces)

    def open(self) -> None:
        """The port is opened and negotiated, as by a computer."""
        self.rfcomm(True, b"", port=0, kind=0x3F)
        self.rfcomm(False, b"", port=0, kind=0x73)
        self.rfcomm(True, bytes.fromhex("8311 02f00700f0030007"), port=0)
        self.rfcomm(True, b"", kind=0x3F)
        self.rfcomm(False, b"", kind=0x73)
        self.rfcomm(True, bytes.fromhex("e305 0b8d"), port=0)


def link_events(link: Link) -> tuple[list[Event], Capture]:
    return of(link.packets, HCI)


def test_a_serial_port_from_its_connection_on() -> None:
    link = Link()
    link.event("0e 01 0910 00 010000000000")  # the computer's own address
    link.connect()
    link.ask()
    link.open()
    first = len(link.packets)
    link.rfcomm(True, voltage(1))
    link.rfcomm(False, volts(1))
    events, capture = link_events(link)
    assert frames(events) == [(voltage(1), (first + 1,)), (volts(1), (first + 2,))]
    command, reply = (event for event in events if isinstance(event, Record))
    assert (command.source, command.target) == ("00:00:00:00:00:01", "00:16:53:00:00:0a")
    assert (command.peer, reply.peer) == ("00:16:53:00:00:0a", "00:16:53:00:00:0a")
    assert (command.carrier, command.direction, reply.direction) == ("bluetooth", "sent", "received")
    assert reply.request is command
    assert capture.account.frames == 19


@pytest.mark.parametrize("begun", ["connection", "channel", "port", "data"])
def test_a_capture_may_begin_after_any_of_it(begun: str) -> None:
    link = Link()
    if begun == "connection":
        link.connect()
    if begun in ("connection", "channel"):
        link.ask()
    if begun in ("connection", "channel", "port"):
        link.open()
    link.rfcomm(True, voltage(1))
    link.rfcomm(False, volts(1), credits=3)
    link.rfcomm(False, b"", credits=1)
    link.rfcomm(True, voltage(2), wide=True)
    events, _ = link_events(link)
    assert [frame for frame, _ in frames(events)] == [voltage(1), volts(1), voltage(2)]
    assert not complaints(events)
    assert {record.peer for record in events if isinstance(record, Record)} == {
        "00:16:53:00:00:0a" if begun == "connection" else "handle 0x000b"
    }


@pytest.mark.parametrize("size", [5, 9])
def test_a_capture_may_begin_with_a_reply(size: int) -> None:
    """Only a command shows that a serial port belongs to a brick."""
    link = Link()
    for at in range(0, 9, size):
        link.rfcomm(False, volts(1)[at : at + size])
    link.rfcomm(True, voltage(2))
    link.rfcomm(False, volts(2))
    events, capture = link_events(link)
    assert [frame for frame, _ in frames(events)] == [voltage(2), volts(2)]
    assert (capture.account.other, capture.account.balance) == (9, 0)


@pytest.mark.parametrize("size", [1, 3, 4, 5, 27, 100])
def test_acl_fragments_of_both_directions_interleaved(size: int) -> None:
    """Long frames with two bytes of length, split by ACL; meanwhile the other direction does the same."""
    frame = struct.pack("<HHBH", 398, 5, 0x80, 0) + b"\x01" * 393
    there, back = Link(), Link()
    there.rfcomm(True, frame, pieces=max(size, 4), credits=7)
    back.rfcomm(False, frame, pieces=max(size, 4))
    link = Link()
    for pair in zip(there.packets, back.packets, strict=False):
        link.packets += pair
    link.packets += there.packets[len(back.packets) :] + back.packets[len(there.packets) :]
    events, capture = link_events(link)
    assert [frame for frame, _ in frames(events)] == [frame, frame]
    assert [event.direction for event in events if isinstance(event, Record)] in (
        ["sent", "received"],
        ["received", "sent"],
    )
    assert (capture.account.frames, capture.account.other) == (800, 0)


def test_frames_are_cut_anywhere_in_rfcomm() -> None:
    stream = voltage(1) + tone(2) + voltage(3)
    for size in range(1, len(stream) + 1):
        link = Link()
        link.ask()
        for at in range(0, len(stream), size):
            link.rfcomm(True, stream[at : at + size])
        events, _ = link_events(link)
        assert [frame for frame, _ in frames(events)] == [voltage(1), tone(2), voltage(3)], size


def test_serial_ports_of_other_devices_are_left_alone() -> None:
    link = Link()
    link.ask()
    link.l2cap(True, 0x50, voltage(1))
    link.rfcomm(True, voltage(2), port=4)
    link.l2cap(True, 0x04, voltage(3))  # of Bluetooth LE
    link.l2cap(True, 0x60, b"\x09\xef\x15" + voltage(4) + b"\x00")  # wrong check sum
    link.rfcomm(True, b"hello, world")
    link.rfcomm(True, b"\r\n")
    events, capture = link_events(link)
    assert events == []
    assert capture.account.frames == capture.account.skipped == 0
    link.rfcomm(True, voltage(5))
    events, _ = link_events(link)
    assert [frame for frame, _ in frames(events)] == [voltage(5)]


def test_a_handle_is_given_again() -> None:
    link = Link()
    link.connect()
    link.ask()
    link.rfcomm(True, voltage(1))
    link.rfcomm(True, voltage(2)[:6])
    link.acl(False, struct.pack("<HH", 100, link.OURS) + b"half")
    link.disconnect()
    link.connect("0b000053 1600")
    link.rfcomm(True, voltage(3))  # its L2CAP channel was not captured
    link.rfcomm(False, volts(1))
    events, _ = link_events(link)
    assert [frame for frame, _ in frames(events)] == [voltage(1), voltage(3), volts(1)]
    peers = [event.peer for event in events if isinstance(event, Record)]
    assert peers == ["00:16:53:00:00:0a", "00:16:53:00:00:0b", "00:16:53:00:00:0b"]
    sentence = "the stream ends inside a frame, of which 6 bytes came and 4 are missing"
    assert complaints(events) == [(voltage(2)[:6], 0, 6, sentence)]
    assert [type(event) for event in events] == [Record, Skipped, Record, Record]
    assert [event for event in events if isinstance(event, Record)][2].request is None


def test_a_connection_that_could_not_be_closed_goes_on() -> None:
    link = Link()
    link.connect()
    link.ask()
    link.rfcomm(True, voltage(1)[:6])
    link.event("05 0c 0b00 13")
    link.rfcomm(True, voltage(1)[6:])
    events, _ = link_events(link)
    assert [frame for frame, _ in frames(events)] == [voltage(1)]


def test_a_port_that_is_opened_again_starts_anew() -> None:
    for kind in (0x3F, 0x53):
        link = Link()
        link.rfcomm(True, voltage(1) + voltage(2)[:6])
        link.rfcomm(True, b"", kind=kind)
        link.rfcomm(True, voltage(3))
        events, _ = link_events(link)
        assert [frame for frame, _ in frames(events)] == [voltage(1), voltage(3)]
        assert [data for data, *_ in complaints(events)] == [voltage(2)[:6]]


def test_bluetooth_packets_cut_by_the_capture() -> None:
    """A gap in a stream is reported, and the next frame is found."""
    link = Link()
    link.ask()
    link.rfcomm(True, voltage(1))
    link.rfcomm(True, voltage(2) + voltage(3))
    link.rfcomm(True, voltage(4))
    packets = timed(link.packets)
    whole = packets[4].data
    packets[4] = packets[4]._replace(data=whole[: whole.index(voltage(3)) + 4], size=len(whole))
    events, _ = opened(pcap(HCI, packets))
    assert frames(events) == [(voltage(1), (4,)), (voltage(2), (5,)), (voltage(4), (6,))]
    assert complaints(events) == [
        (voltage(3)[:4], 0, 5, "the rest of the frame is not in the capture"),
        (b"", 6, 5, "6 bytes are missing in the stream: not in the capture"),
    ]


def test_garbage_in_a_serial_port() -> None:
    link = Link()
    link.rfcomm(True, voltage(1) + b"\xff\xff\xff")
    link.rfcomm(True, voltage(2))
    link.rfcomm(True, b"\xff" * 120)
    link.rfcomm(True, voltage(3))
    events, capture = link_events(link)
    assert [frame for frame, _ in frames(events)] == [voltage(1), voltage(2), voltage(3)]
    assert capture.account.skipped == 123


def test_direction_is_guessed_where_the_file_does_not_tell() -> None:
    """H4 alone has no addresses; RFCOMM shows which end opened the connection, which a brick does not."""
    link = Link()
    link.rfcomm(True, voltage(1))
    link.rfcomm(False, volts(1))
    link.rfcomm(True, voltage(2)[:5])
    link.rfcomm(False, volts(2)[:5])
    link.rfcomm(True, voltage(2)[5:])
    link.rfcomm(False, volts(2)[5:])
    events, _ = opened(pcap(187, timed([packet[4:] for packet in link.packets])))
    assert [event.direction for event in events if isinstance(event, Record)] == ["sent", "received"] * 2
    flags = [packet[3] for packet in link.packets]
    events, _ = opened(btsnoop(1002, timed([packet[4:] for packet in link.packets]), flags))
    assert [event.direction for event in events if isinstance(event, Record)] == ["sent", "received"] * 2


# Evicted because of too many connections, or too much waiting data


TONE = bytes.fromhex("0e002a0080000094010182b80182e803")
"""SOUND.TONE at volume 1, 440 Hz, 1000 ms."""


def test_connections_that_had_to_go_are_reported() -> None:
    """In each of them, a complete frame is followed by the beginning of another."""
    events, capture = of([segment(True, 1, TONE + TONE[:9], port=1024 + number) for number in range(1500)])
    assert len(complaints(events)) == 1500
    assert (capture.account.skipped, capture.account.balance) == (1500 * 9, 0)


def test_half_frames_share_the_memory() -> None:
    packets = [segment(True, 1000, TONE, port=1024 + number) for number in range(100)]
    for at in range(9):
        packets += [segment(True, 1016 + at, TONE[at : at + 1], port=1024 + number) for number in range(100)]
    capture = read(io.BytesIO(pcap(RAW_IP, timed(packets))), memory=50_000)
    events = list(capture.events())
    assert len(frames(events)) == 100
    assert 0 < capture.account.forgotten < 300
    assert "the rest of the frame was given up: too much is pending" in {text for *_, text in complaints(events)}
    assert (capture.account.skipped + capture.account.other, capture.account.balance) == (900, 0)


@pytest.mark.parametrize("memory", [1 << 10, 1 << 26])
def test_every_byte_is_accounted_for_however_little_may_wait(memory: int) -> None:
    found = Packets(HCI_WITH_DIRECTION)
    for number in range(60):
        port = SerialPort(found, connection=number % 20)
        port.receive(ev3proto.direct_reply(bytes(20)).build())
        port.send(TONE[:-1] if number % 3 else TONE)
        head = struct.pack("<IBHHHH", 0, 2, number % 20, 604, 1000, 0x41)
        found.add(head + b"x" * 600)
    capture = read(io.BytesIO(found.data()), memory=memory)
    list(capture.events())
    assert capture.account.balance == 0
    assert (capture.account.forgotten > 0) == (memory < 1 << 26)
