"""Captures that are made to be slow: twice the capture takes twice the time, for any contents and any output."""

from __future__ import annotations

import io
import random
from collections.abc import Callable, Iterable, Iterator
from itertools import cycle, islice
from pathlib import Path

import pytest
from support.cli import run_ev3proto
from support.cpu_time import Work, assert_linear, milliseconds
from support.effort import effort
from support.files import RAW_IP, pcap, timed
from support.packets import SYN, segment

from ev3proto.capture import read

PACKETS = effort(250, 10_000)

TONE = bytes.fromhex("0e002a0080000094010182b80182e803")
"""SOUND.TONE at volume 1, 440 Hz, 1000 ms."""

VOLTAGE = bytes.fromhex("08002b00000400810160")
"""UI_READ.GET_VBATT, which wants a reply."""

TRUNCATED = bytes.fromhex("1400000080000082")
"""A header and an operation of two arguments: if repeated, a frame may start at each."""

ENDLESS = bytes.fromhex("e803000080000094")
"""A header with a length of 1000 bytes."""


def connected(pieces: Iterable[bytes]) -> Iterator[bytes]:
    """A connection from its start, in which the host sends these pieces, each in a packet."""
    yield segment(True, 999, flags=SYN)
    at = 1000
    for piece in pieces:
        yield segment(True, at, piece)
        at += len(piece)


def segments_in_reverse(count: int) -> Iterator[bytes]:
    frames = b"".join(islice(cycle((TONE, VOLTAGE)), count))
    yield segment(True, 999, flags=SYN)
    for at in range(0, len(frames), 1300):
        for back in range(min(at + 1300, len(frames)) - 13, at - 1, -13):
            yield segment(True, 1000 + back, frames[back : back + 13])


def gaps(count: int) -> Iterator[bytes]:
    for number in range(count):
        yield segment(True, 1000 + 40 * number, TONE + VOLTAGE[:7])
        yield segment(False, 77, acknowledged=1040 + 40 * number)


def each_byte(data: bytes, count: int) -> Iterator[bytes]:
    return (bytes((byte,)) for byte in islice(cycle(data), count))


def after_a_tone(pieces: Iterable[bytes]) -> Iterator[bytes]:
    """The same, each piece behind two bytes that no frame begins with."""
    return connected([TONE, *(b"\xff\xff" + piece for piece in pieces)])


HOSTILE: dict[str, Callable[[int], Iterable[bytes]]] = {
    "in step": lambda count: connected([TONE] * count),
    "garbage": lambda count: after_a_tone(map(random.Random(1).randbytes, [98] * count)),
    "frames that never fit": lambda count: after_a_tone([TRUNCATED * 12] * count),
    "large packets that never fit": lambda count: after_a_tone([TRUNCATED * 175] * (count // 8)),
    "long frames that never end": lambda count: after_a_tone([ENDLESS * 5] * count),
    "single bytes": lambda count: connected(each_byte(TONE + VOLTAGE, count)),
    "single bytes out of step": lambda count: connected([TONE, b"\xff\xff", *each_byte(ENDLESS, 4 * count)]),
    "gaps": gaps,
    "segments in reverse": segments_in_reverse,
    "connections": lambda count: [segment(True, 1000, VOLTAGE + TONE[:9], port=1024 + each) for each in range(count)],
    "commands without replies": lambda count: connected(
        VOLTAGE[:2] + number.to_bytes(2, "little") + VOLTAGE[4:] for number in range(count)
    ),
}


def messages(data: bytes) -> int:
    """Reads a capture and all messages in it; returns their counts."""
    return sum(getattr(event, "message", event) is not None for event in read(io.BytesIO(data)).events())


@pytest.mark.parametrize("packets", HOSTILE)
def test_reading(packets: str) -> None:
    def reading(count: int) -> Work:
        data = pcap(RAW_IP, timed(list(HOSTILE[packets](count))))
        return lambda: messages(data)

    assert_linear(reading, PACKETS)


@pytest.mark.parametrize(
    "words",
    [("decode",), ("decode", "--json"), ("decode", "--dialogues"), ("stats",), ("check",), ("timeline",), ("files",)],
    ids=" ".join,
)
def test_showing(words: tuple[str, ...], tmp_path: Path) -> None:
    """All of that in one capture, in every output."""
    rest = {"timeline": ("-o", tmp_path / "page.html"), "files": ("-o", tmp_path / "files")}.get(words[0], ())

    def showing(count: int) -> Work:
        path = tmp_path / f"{count}.pcap"
        path.write_bytes(pcap(RAW_IP, timed([packet for made in HOSTILE.values() for packet in made(count)])))

        def show() -> None:
            done = run_ev3proto(*words, path, *rest)
            assert done.returncode in (0, 1), done.stderr

        return show

    assert_linear(showing, PACKETS // 5)


def test_packets_without_a_byte_are_only_counted() -> None:
    data = pcap(RAW_IP, timed([b""] * 20_000))
    capture = read(io.BytesIO(data))
    assert list(capture) == []
    assert capture.account.packets == 20_000
    assert milliseconds(lambda: list(read(io.BytesIO(data))), 30) <= 30
