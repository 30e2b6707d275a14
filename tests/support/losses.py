"""Captures with missing packets, and the messages in them that are complete nevertheless."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterable, Iterator
from typing import NamedTuple

import ev3proto
from support.frames import Segment
from support.packets import HCI_WITH_DIRECTION, RAW_IP, Capture, Connection, SerialPort

SHARE = 0.03
"""The number of missing packets per 100."""

BEGINNING = bytes.fromhex("0e00feff80000094010182b80182e803")
"""SOUND.TONE, which is never missing: what comes before the first frame of a capture is a different subject."""

UNLOCK = ev3proto.Unlock("06165300000a").build()
"""The first data of every program over TCP."""

MOST_TOGETHER = 20
"""The maximum number of messages that one side sends before the other."""


class Lossy(NamedTuple):
    """A capture, and its complete messages, each with the side that sent it."""

    data: bytes
    whole: Counter[Segment]


def lossy(carrier: str, sizes: tuple[int, int], dialogues: Iterable[Iterable[Segment]]) -> Lossy:
    """A capture of dialogues, each in its own connection; packets have a fixed size, independent of the frames."""
    capture = Capture(RAW_IP if carrier == "tcp" else HCI_WITH_DIRECTION)
    whole: Counter[Segment] = Counter()
    for number, messages in enumerate(dialogues):
        way: Connection | SerialPort = (
            Connection(capture, 10_000 + number) if carrier == "tcp" else SerialPort(capture, connection=number)
        )
        whole += _say(way, sizes, messages, random.Random(number))
    return Lossy(capture.data(), whole)


def _say(
    way: Connection | SerialPort, sizes: tuple[int, int], messages: Iterable[Segment], rng: random.Random
) -> Counter[Segment]:
    capture, missing = way.capture, Capture(RAW_IP)
    whole = Counter({Segment(True, BEGINNING): 1})
    if isinstance(way, Connection):
        way.send(UNLOCK)
    way.send(BEGINNING)
    for from_host, frames in _turns(messages, rng):
        data, is_there = b"".join(frames), bytearray()
        while len(is_there) < len(data):
            piece = data[len(is_there) :][: rng.randint(*sizes)]
            is_lost = rng.random() < SHARE
            way.capture = missing if is_lost else capture
            (way.send if from_host else way.receive)(piece)
            is_there += bytes([not is_lost]) * len(piece)
        at = 0
        for frame in frames:
            whole[Segment(from_host, frame)] += all(is_there[at : at + len(frame)])
            at += len(frame)
    return whole


def _turns(messages: Iterable[Segment], rng: random.Random) -> Iterator[tuple[bool, list[bytes]]]:
    """Commands that are sent one after the other, followed by their replies, and so on."""
    waiting: dict[bool, list[bytes]] = {True: [], False: []}
    most = 1
    for from_host, data in messages:
        if from_host and len(waiting[True]) >= most:
            yield from waiting.items()
            waiting = {True: [], False: []}
            most = rng.randint(1, MOST_TOGETHER)
        waiting[from_host].append(data)
    yield from waiting.items()
