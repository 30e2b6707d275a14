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
        self._waiting: dict[int, tuple[Record, bool]] = {}
        self._size = 0

    def chosen(self, events: Iterable[Event]) -> Iterator[Record]:
        """Chooses the wanted records.

        Args:
            events: Those of the capture, to its end. What is no frame is never wanted.

        Yields:
            The records, in the order of the capture.
        """
        for event in events:
            if isinstance(event, Record):
                if self._keep.looks_ahead:
                    yield from self._add(event)
                elif self._keep(event):
                    yield event
        for record, is_chosen in self._waiting.values():
            if is_chosen or self._keep(record):
                yield record
        self._waiting.clear()

    def _add(self, record: Record) -> Iterator[Record]:
        if record.request is not None:
            self._decide(record.request)
        if record.message.wants_reply:
            self._hold(record, is_chosen=False)
        elif self._keep(record):
            self._hold(record, is_chosen=True)
        while self._waiting:
            first, is_chosen = next(iter(self._waiting.values()))
            if not is_chosen and self._size <= self._memory:
                return
            self._release(first)
            if is_chosen:
                yield first
            else:
                self.given_up += 1
                if self._keep(first):
                    yield first

    def _decide(self, command: Record) -> None:
        """A command's reply is there: now it is known whether the command is wanted."""
        if id(command) not in self._waiting:
            return
        if self._keep(command):
            self._waiting[id(command)] = command, True
        else:
            self._release(command)

    def _hold(self, record: Record, *, is_chosen: bool) -> None:
        self._waiting[id(record)] = record, is_chosen
        self._size += _RECORD_SIZE + len(record.frame)

    def _release(self, record: Record) -> None:
        del self._waiting[id(record)]
        self._size -= _RECORD_SIZE + len(record.frame)
