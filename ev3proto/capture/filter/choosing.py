"""The records that a filter lets through, in their order, also where it asks for what is only known later.

Whether a command is `unanswered` shows when its reply comes, or when the capture ends. Until then it waits here, and
so does everything after it that is wanted.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.capture.filter.language import Filter
from ev3proto.capture.record import Event, Record

_RECORD_SIZE = 900
"""Bytes of memory that a record takes while it waits, besides its frame, about."""


class Choosing:
    """Chooses records of one capture.

    given_up  commands that were taken for unanswered before the capture ended, because too much waited
    """

    def __init__(self, keep: Filter, memory: int = DEFAULT_MEMORY) -> None:
        """Starts a capture.

        Args:
            keep: Which records are wanted.
            memory: Bytes that the records that wait may take, about.
        """
        self.given_up = 0
        self._keep = keep
        self._memory = memory
        self._waiting: dict[int, Record] = {}
        self._size = 0

    def chosen(self, events: Iterable[Event]) -> Iterator[Record]:
        """Chooses the wanted records.

        Args:
            events: Those of the capture, to its end. Events that are not frames are never wanted.

        Yields:
            The records, in the order of the capture.
        """
        for event in events:
            if not isinstance(event, Record):
                continue
            if not self._keep.looks_ahead:
                if self._keep(event):
                    yield event
                continue
            command = event.request
            if command is not None and id(command) in self._waiting and not self._keep(command):
                self._release(command)
            if event.message.wants_reply or self._keep(event):
                self._waiting[id(event)] = event
                self._size += _RECORD_SIZE + len(event.frame)
            while self._waiting:
                first = next(iter(self._waiting.values()))
                is_open = first.message.wants_reply and first.answered is None
                if is_open and self._size <= self._memory:
                    break
                self._release(first)
                self.given_up += is_open
                if self._keep(first):
                    yield first
        yield from filter(self._keep, self._waiting.values())
        self._waiting.clear()

    def _release(self, record: Record) -> None:
        del self._waiting[id(record)]
        self._size -= _RECORD_SIZE + len(record.frame)
