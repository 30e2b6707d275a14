"""All readers of streams side by side: each case whole, byte by byte, in two parts, and with something behind it."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from support.chunks import assert_read

import ev3proto
from ev3proto.brick.servers.host import Connection
from ev3proto.capture.framing import Cutter, PartKind
from ev3proto.link.reply_stream import ReplyStream
from ev3proto.schema.frame import frame_reader
from ev3proto.schema.frame_buffer import FrameBuffer, OutOfStep

NOP = bytes.fromhex("06 00 01 00 80 00 00 01")
TONE = bytes.fromhex("0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03")
REPLY = bytes.fromhex("07 00 2A 00 02 A4 70 FD 40")
SHORTEST = bytes.fromhex("03 00 2A 00 04")
LONGEST = bytes.fromhex("FE 03 2A 00 02") + bytes(range(256)) * 3 + b"\x01" * 251
FAULTY = bytes.fromhex("06 00 02 00 80 00 00 FE")
PIECE = bytes.fromhex("FF FF 2A 00 81 93 03") + b"\0" * 65_530
POLL = bytes(2)

Chunks = list[bytes]


def buffer(chunks: Chunks) -> Iterator[bytes]:
    stream = FrameBuffer()
    for chunk in chunks:
        stream.append(chunk)
        yield from stream


def decoder(chunks: Chunks) -> Iterator[bytes]:
    stream = ev3proto.Decoder(strict=False)
    for chunk in chunks:
        yield from (message.build() for message in stream.feed(chunk))


def capture(chunks: Chunks) -> Iterator[bytes]:
    cutter = Cutter(frame_reader("official"), in_step=True)
    for number, chunk in enumerate(chunks):
        yield from (part.data for part in cutter.feed(chunk, number) if part.kind is PartKind.FRAME)


def client(chunks: Chunks) -> Iterator[bytes]:
    stream = ReplyStream(lambda _counter: True)
    for chunk in chunks:
        yield from (part for part in stream.feed(chunk) if isinstance(part, bytes))


class Silent:
    """A host with a brick and a line, which do nothing but count."""

    said = 0
    is_busy = False

    @property
    def brick(self) -> Silent:
        return self

    def say_once(self, _sentence: str) -> None:
        self.said += 1

    def wake(self) -> None:
        pass

    pause = resume = wake


def virtual_brick(chunks: Chunks) -> Iterator[bytes]:
    async def served() -> list[bytes]:
        host: Any = Silent()
        connection = Connection(host, host, "client", "wifi")
        frames = []
        for chunk in chunks:
            connection.feed(chunk)
            while connection.is_ready:
                frames.append(connection.take())
        assert host.said == 0
        return frames

    yield from asyncio.run(served())


def scapy_session(chunks: Chunks) -> Iterator[bytes]:
    from scapy.packet import Padding

    from ev3proto.scapy import EV3

    data = b""
    for chunk in chunks:
        data += chunk
        while (packet := EV3.tcp_reassemble(data, {}, {})) is not None:
            behind = bytes(packet[Padding]) if Padding in packet else b""
            yield data[: len(data) - len(behind)]
            data = behind


READERS = [buffer, decoder, capture, client, virtual_brick, scapy_session]

CASES = {
    "one": (TONE, [TONE]),
    "several": (NOP + TONE + REPLY, [NOP, TONE, REPLY]),
    "the shortest": (SHORTEST, [SHORTEST]),
    "the longest": (LONGEST, [LONGEST]),
    "after the longest": (LONGEST + NOP, [LONGEST, NOP]),
    "a faulty one between": (NOP + FAULTY + TONE, [NOP, FAULTY, TONE]),
}
POLLS = {
    "a poll first": (POLL + TONE, [TONE]),
    "polls between": (TONE + POLL * 3 + NOP, [TONE, NOP]),
    "polls last": (TONE + POLL, [TONE]),
}
DOWNLOADS = {"a long download": (PIECE + TONE, [PIECE, TONE])}
OF_READER: dict[Callable[[Chunks], Iterator[bytes]], dict[str, tuple[bytes, list[bytes]]]] = {
    client: CASES,  # a brick sends neither polls nor downloads
    scapy_session: CASES | DOWNLOADS,  # a poll has no layer
}
ALL = [
    pytest.param(reader, *case, id=f"{reader.__name__}, {name}")
    for reader in READERS
    for name, case in OF_READER.get(reader, CASES | POLLS | DOWNLOADS).items()
]


@pytest.mark.parametrize(("reader", "data", "frames"), ALL)
def test_readers(reader: Callable[[Chunks], Iterator[bytes]], data: bytes, frames: list[bytes]) -> None:
    begun = [(part, ()) for part in (b"\x06", NOP[:2], NOP[:-1])]
    assert_read(lambda chunks: list(reader(chunks)), data, frames, [*begun, (NOP, [NOP])])


# The buffer itself


def test_what_is_left() -> None:
    stream = FrameBuffer(TONE + NOP[:1])
    assert (len(stream), stream.size, stream.position, stream.missing) == (17, 16, 0, 0)
    assert stream.next() == TONE
    assert (stream.pending, stream.size, stream.position, stream.missing) == (NOP[:1], None, 16, 0)
    assert stream.next() is None
    stream.append(NOP[1:5])
    assert (stream.size, stream.missing, stream.next()) == (8, 3, None)
    stream.append(NOP[5:])
    assert (stream.next(), stream.position, stream.pending) == (NOP, 24, b"")


@pytest.mark.parametrize(
    ("start", "reason"),
    [
        ("01 00", "no frame can start here: the length field says 1, but it can be 3 to 1022"),
        ("02 00", "no frame can start here: the length field says 2, but it can be 3 to 1022"),
        ("FF 03 01 00 80", "no frame can start here: the length field says 1023, but it can be 3 to 1022"),
        ("FF FF 01 00 00", "no frame can start here: the length field says 65535, but it can be 3 to 1022"),
        ("FF 03 01 00 01 99", "no frame can start here: the length field says 1023, but it can be 3 to 1022"),
        ("47 45 54 20 2F", "length 17735: text where a frame should be"),
    ],
)
def test_out_of_step(start: str, reason: str) -> None:
    data = bytes.fromhex(start)
    stream = FrameBuffer(NOP + data)
    assert [stream.next() for _ in range(3)] == [NOP, OutOfStep(reason), OutOfStep(reason)]
    stream.append(NOP)
    assert stream.next() == OutOfStep(reason)
    assert stream.skip(len(data)) == data
    assert (stream.next(), stream.position) == (NOP, 16 + len(data))


@pytest.mark.parametrize("start", ["FF 03", "FF 03 01 00", "FF 03 01 00 01", "FF 03 01 00 81 92", "FF FF 01 00 01 93"])
def test_a_length_that_may_be_that_of_a_download(start: str) -> None:
    stream = FrameBuffer(bytes.fromhex(start))
    assert stream.next() is None
    assert stream.size in (1025, 65_537)


def test_the_way_back_into_step_is_given() -> None:
    stream = FrameBuffer(b"\xff\xff\xff\xff\xff" + TONE, resync=lambda data, at: max(data.find(TONE[:2], at), at))
    reason = "no frame can start here: the length field says 65535, but it can be 3 to 1022"
    assert [stream.next(), stream.next(), stream.next()] == [OutOfStep(reason, b"\xff" * 5), TONE, None]
    assert stream.position == 21


# The policy of a client: a reply is believed when a command waits for it


def replies(chunks: Chunks, *waiting: int) -> list[bytes | bytearray | str]:
    stream = ReplyStream(waiting.__contains__)
    found = [part for chunk in chunks for part in stream.feed(chunk)]
    return [part if isinstance(part, bytes) else f"lost {part.data.hex()}" for part in found]


def test_a_client_drops_zeros() -> None:
    assert replies([bytes(5) + REPLY], 42) == ["lost 0000000000", REPLY]
    assert replies([bytes(5), REPLY], 42) == ["lost 00", "lost 00000000", REPLY]


def test_a_client_believes_no_counter_that_it_does_not_wait_for() -> None:
    other = bytes.fromhex("03 00 2B 00 02")
    assert replies([b"\xff" * 5 + other + REPLY], 42) == ["lost " + "ff" * 5 + other.hex(), REPLY]
    # In step, a foreign reply is a frame all the same.
    assert replies([other + REPLY], 42) == [other, REPLY]


def test_a_client_takes_the_largest_reply_that_the_firmware_grants() -> None:
    largest = bytes.fromhex("00 04 2A 00 02") + b"\x01" * 1021
    assert replies([largest[:3], largest[3:]], 42) == [largest]
    beyond = bytes.fromhex("01 04 2A 00 02") + b"\x01" * 1022
    assert replies([beyond + REPLY], 42) == [f"lost {beyond.hex()}", REPLY]


def test_a_client_knows_what_is_missing() -> None:
    stream = ReplyStream(lambda _counter: True)
    assert stream.missing == 0
    stream.feed(REPLY[:1])
    assert (stream.missing, stream.pending) == (4, REPLY[:1])
    stream.feed(REPLY[1:6])
    assert stream.missing == 3


# The policy of a capture: a frame that was searched for is judged, and so is the next one


def cut(*packets: str) -> list[str]:
    cutter = Cutter(frame_reader("official"), in_step=False)
    parts = [part for number, data in enumerate(packets) for part in cutter.feed(bytes.fromhex(data), number)]
    return [f"{part.kind.name} {part.data.hex()}" for part in parts]


def test_after_a_reply_that_nothing_follows_the_next_frame_is_judged_too() -> None:
    """A reply may be anything, so it proves less than a command."""
    junk = "0600 0100 80 0000 FE" + "FFFF" * 4
    found = cut("FF" * 3 + REPLY.hex(), junk)
    assert found[:2] == ["LOST ffffff", f"FRAME {REPLY.hex()}"]
    assert not any(part.startswith("FRAME 0600") for part in found)
    found = cut("FF" * 3 + TONE.hex(), junk)
    assert found[:3] == ["LOST ffffff", f"FRAME {TONE.hex()}", "FRAME 06000100800000fe"]


@pytest.mark.parametrize(
    ("data", "what"),
    [
        ("G", "frame, of which 1 byte came"),
        ("GE", "text, of which 2 bytes came"),
        ("GET", "text, of which 3 bytes came"),
    ],
)
def test_a_text_that_ends_early_is_a_text_from_its_second_byte_on(data: str, what: str) -> None:
    """One byte may be the start of a length; 45 47 is a length that no frame has."""
    cutter = Cutter(frame_reader("official"), in_step=True)
    assert cutter.feed(data.encode(), 1) == []
    (part,) = cutter.end()
    assert part.reason == f"the stream ends inside a {what}"


@pytest.mark.parametrize("size", [1, 2, 7])
def test_packets_are_waited_for_while_they_have_pending_bytes(size: int) -> None:
    cutter = Cutter(frame_reader("official"), in_step=True)
    first, second = cutter.feed(NOP + TONE[:size], 1), cutter.feed(TONE[size:] + NOP[:size], 2)
    assert [(part.data, part.numbers) for part in (*first, *second)] == [(NOP, (1,)), (TONE, (1, 2))]
    assert cutter.waiting == [2]


def test_no_packet_is_waited_for_after_the_last_byte_of_a_frame() -> None:
    cutter = Cutter(frame_reader("official"), in_step=True)
    assert cutter.feed(TONE[:5], 1) == []
    (part,) = cutter.feed(TONE[5:], 2)
    assert (part.numbers, cutter.waiting, cutter.size) == ((1, 2), [], 0)


@pytest.mark.parametrize("missing", [0, 1])
def test_the_zero_after_the_bricks_answer_is_not_a_length(missing: int) -> None:
    """00 03 00 2A 00 looks like a header, unless the whole shortest reply is there without its first byte."""
    answer, reply = b"Accept:EV340\r\n\r\n", bytes.fromhex("03 00 2A 00 02")
    cutter = Cutter(frame_reader("official"), in_step=True)
    parts = cutter.feed(answer + b"\0" + reply[: len(reply) - missing], 1)
    expected = [("ACCEPT", answer + b"\0"), ("FRAME", reply)] if not missing else [("ACCEPT", answer)]
    assert [(part.kind.name, part.data) for part in parts] == expected


def test_a_faulty_frame_with_a_gap_between_its_packets_waits_for_the_next() -> None:
    """Bytes may be missing between two packets, not within one."""
    faulty = bytes.fromhex("06 00 FF FF 80 00 00 FE")
    cutter = Cutter(frame_reader("official"), in_step=True, may_gap=True)
    assert [part.data for part in cutter.feed(faulty + NOP[:1], 1)] == [faulty]
    cutter = Cutter(frame_reader("official"), in_step=True, may_gap=True)
    assert cutter.feed(faulty[:7], 1) == cutter.feed(faulty[7:] + NOP[:1], 2) == []
    assert [part.data for part in cutter.feed(NOP[1:] + NOP, 3)] == [faulty, NOP, NOP]
