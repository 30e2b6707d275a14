"""Selects the records of a capture that match a filter, in their order, even if the filter needs later records.

Whether a command is `unanswered` is known when its reply comes, or when the capture ends. Until then the command
waits here, and so do all matching records after it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.capture.filter.language import Filter
from ev3proto.capture.record import Event, Record

_RECORD_SIZE = 900
"""Approximate memory of a waiting record, in bytes, in addition to its frame."""


class Choosing:
    """A selection of records from one capture."""

    def __init__(self, keep: Filter, memory: int = DEFAULT_MEMORY) -> None:
        """Starts with an empty backlog, which may take some bytes of memory."""
        # commands that counted as unanswered before the capture ended, because too many records waited
        self.given_up = 0
        self._keep = keep
        self._memory = memory
        self._waiting: dict[int, Record] = {}
        self._size = 0

    def chosen(self, events: Iterable[Event]) -> Iterator[Record]:
        """Yields the matching records, in the order of the capture."""
        for event in events:
            if isinstance(event, Record):
                yield from self.take(event)
        yield from self.end()

    def take(self, record: Record) -> Iterator[Record]:
        """Takes the next record, and yields the matching records that are known now."""
        if not self._keep.looks_ahead:
            if self._keep(record):
                yield record
            return
        command = record.request
        if command is not None and id(command) in self._waiting and not self._keep(command):
            self._release(command)
        if record.message.wants_reply or self._keep(record):
            self._waiting[id(record)] = record
            self._size += _RECORD_SIZE + len(record.frame)
        while self._waiting:
            first = next(iter(self._waiting.values()))
            is_open = first.message.wants_reply and first.answered is None
            if is_open and self._size <= self._memory:
                break
            self._release(first)
            self.given_up += is_open
            if self._keep(first):
                yield first

    def end(self) -> Iterator[Record]:
        """Yields the matching records that were still waiting."""
        yield from filter(self._keep, self._waiting.values())
        self._waiting.clear()

    def _release(self, record: Record) -> None:
        del self._waiting[id(record)]
        self._size -= _RECORD_SIZE + len(record.frame)
