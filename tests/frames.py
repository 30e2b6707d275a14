"""Frames to show to a dissector: drawn from strategies, and put into a capture of a TCP connection with a brick."""

from __future__ import annotations

import struct
from collections.abc import Iterable
from typing import NamedTuple, TypeVar

from hypothesis import HealthCheck, Phase, given, settings
from hypothesis.strategies import SearchStrategy

from ev3proto.tables.discovery import TCP_PORT

T = TypeVar("T")

HOST, BRICK = (bytes((192, 0, 2, 1)), 49152), (bytes((192, 0, 2, 10)), TCP_PORT)
MILLISECONDS_EACH = 1
"""From one packet to the next."""

_RAW_IP = 101
_PUSH, _ACKNOWLEDGE = 0x08, 0x10


class Segment(NamedTuple):
    """What one packet of the connection carries, and which way it goes."""

    from_host: bool
    data: bytes


def drawn(strategy: SearchStrategy[T], count: int) -> list[T]:
    """So many examples of a strategy, the same ones every time."""
    found: list[T] = []

    @settings(
        max_examples=count,
        derandomize=True,
        database=None,
        deadline=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(strategy)
    def collect(example: T) -> None:
        found.append(example)

    collect()
    return found


def tcp_capture(segments: Iterable[Segment]) -> bytes:
    """A pcap file of a connection, begun after its handshake: packet 1 is the first segment."""
    pieces = [struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 0x40000, _RAW_IP)]
    numbers = {True: 1, False: 1}
    for index, (from_host, data) in enumerate(segments):
        (source, port), (target, other_port) = (HOST, BRICK) if from_host else (BRICK, HOST)
        own, acknowledged = numbers[from_host], numbers[not from_host]
        flags = _PUSH | _ACKNOWLEDGE
        tcp = struct.pack(">HHIIBBHHH", port, other_port, own, acknowledged, 5 << 4, flags, 0xFFFF, 0, 0)
        size = 20 + len(tcp) + len(data)
        ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, size, index & 0xFFFF, 0x4000, 64, 6, 0, source, target)
        seconds, rest = divmod(index * MILLISECONDS_EACH, 1000)
        pieces += [struct.pack("<IIII", seconds, 1000 * rest, size, size), ip, tcp, data]
        numbers[from_host] += len(data)
    return b"".join(pieces)
