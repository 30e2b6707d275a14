"""Streams: chunks of any size to complete messages, bounded memory, and the error if no frame can follow."""

from __future__ import annotations

import tracemalloc

import pytest

import ev3proto

pytestmark = pytest.mark.portable

NOP = bytes.fromhex("06 00 01 00 80 00 00 01")
TONE = bytes.fromhex("0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03")


def test_several_frames_in_one_chunk() -> None:
    decoder = ev3proto.Decoder()
    counters = [message.counter for message in decoder.feed(NOP + TONE + NOP[:3])]
    assert counters == [1, 42]
    assert decoder.position == 24
    assert decoder.pending == NOP[:3]


def test_messages_that_were_not_read_come_with_the_next_chunk() -> None:
    decoder = ev3proto.Decoder()
    assert next(iter(decoder.feed(NOP + TONE))).counter == 1
    assert [message.counter for message in decoder.feed(NOP)] == [42, 1]


def test_an_impossible_length() -> None:
    decoder = ev3proto.Decoder(strict=False)
    found = decoder.feed(NOP + b"GET /target")
    assert next(found).counter == 1
    with pytest.raises(ev3proto.StreamError, match=r"length 17735: text where a frame should be") as error:
        next(found)
    assert error.value.offset == 8
    pending = len(decoder.pending)
    with pytest.raises(ev3proto.StreamError):
        list(decoder.feed(bytes(1000)))
    assert len(decoder.pending) == pending


def test_polls_are_skipped() -> None:
    decoder = ev3proto.Decoder()
    chunks = (b"\0", b"\0" + TONE + bytes(6), NOP + b"\0", b"\0")
    counters = [message.counter for chunk in chunks for message in decoder.feed(chunk)]
    assert (counters, decoder.position, decoder.close()) == ([42, 1], 34, None)


def test_a_faulty_frame_does_not_end_the_stream() -> None:
    unknown = bytes.fromhex("06 00 02 00 80 00 00 FE")
    decoder = ev3proto.Decoder()
    with pytest.raises(ev3proto.DecodeError, match="starts at offset 8 of the stream: unknown opcode 0xFE") as error:
        list(decoder.feed(NOP + unknown + TONE))
    assert error.value.offset == 15
    assert [message.counter for message in decoder.feed(b"")] == [42]
    lenient = ev3proto.Decoder(strict=False)
    faults = [message.fault for message in lenient.feed(NOP + unknown + TONE)]
    assert [fault and fault.offset for fault in faults] == [None, 7, None]


def test_a_stream_that_ends_inside_a_frame() -> None:
    decoder = ev3proto.Decoder()
    assert list(decoder.feed(TONE[:5])) == []
    with pytest.raises(ev3proto.StreamError, match="ends inside a frame, after 5 bytes of it"):
        decoder.close()
    lenient = ev3proto.Decoder(strict=False)
    assert list(lenient.feed(NOP + TONE[:1])) != []
    fault = lenient.close()
    assert fault is not None
    assert (fault.offset, fault.truncated) == (8, True)


def test_memory_stays_that_of_one_frame() -> None:
    decoder = ev3proto.Decoder()

    def stream(frames: int) -> None:
        for _ in range(frames):
            for _ in decoder.feed(TONE):
                pass

    stream(1000)  # what is computed once, such as the expression for byte code, is not the stream's memory
    tracemalloc.start()
    stream(5000)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 100_000
