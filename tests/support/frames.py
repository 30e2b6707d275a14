"""Frames for a dissector: drawn from strategies, and put into a capture of a TCP connection with a brick."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple, TypeVar

from hypothesis import HealthCheck, Phase, given, settings
from hypothesis.strategies import SearchStrategy

from support.packets import RAW_IP, Capture, Connection

T = TypeVar("T")


class Segment(NamedTuple):
    """The bytes of one packet of the connection, and its direction."""

    from_host: bool
    data: bytes


def drawn(strategy: SearchStrategy[T], count: int) -> list[T]:
    """Returns this number of examples of a strategy, the same every time."""
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
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    for from_host, data in segments:
        capture.add(connection.segment(from_host, data))
    return capture.data()
