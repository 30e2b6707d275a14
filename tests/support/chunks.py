"""The chunks in which bytes may come: every reader of a stream is tried with all of them, by one function."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from typing import Any

_MOST_SINGLE = 2000
"""Bytes of the longest case that also comes byte by byte."""


def assert_read(
    read: Callable[[list[bytes]], Sequence[Any]],
    data: bytes,
    expected: Sequence[Any],
    behind: Sequence[tuple[bytes, Sequence[Any]]] = (),
) -> None:
    """Fails unless a reader finds the same in bytes that come whole, in two parts, and one by one.

    Args:
        read: Reads chunks.
        data: All bytes.
        expected: What is in them.
        behind: Bytes that may follow, and what the reader finds in addition then.
    """
    for more, added in ((b"", ()), *behind):
        whole = data + more
        assert list(read([whole])) == [*expected, *added], more
    assert list(read([data[:1], data[1:]])) == [*expected]
    if len(data) < _MOST_SINGLE:
        assert list(read([data[at : at + 1] for at in range(len(data))])) == [*expected]


class Pipe(io.RawIOBase):
    """A pipe whose writer sends one chunk after the other."""

    def __init__(self, chunks: list[bytes]) -> None:
        self._chunks = chunks.copy()

    def readable(self) -> bool:
        return True

    def readinto(self, into: Any) -> int:
        chunk = self._chunks.pop(0) if self._chunks else b""
        size = min(len(chunk), len(into))
        into[:size] = chunk[:size]
        if chunk[size:]:
            self._chunks.insert(0, chunk[size:])
        return size
