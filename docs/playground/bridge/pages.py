"""What was read, page by page: frames are kept as bytes, and become lines when their page is opened."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from copy import copy
from itertools import islice
from typing import Any

from ev3proto.capture.dialogues import RequestReply, dialogues
from ev3proto.capture.record import Announcement, Record, elapsed
from ev3proto.errors import DecodeError
from ev3proto.program import parse as parse_program
from ev3proto.program.listing import listing
from ev3proto.reading.items import Image
from ev3proto.reading.lines import announcement_line, message_lines, record_seen
from ev3proto.text.phrases import command_spans, reply_spans
from ev3proto.text.spans import Line, Role, plain_text

from .words import pieces

MOST_FRAMES, MOST_BYTES = 200, 10_000
"""Maximum numbers of frames on a page, and of their bytes; a longer frame has a page of its own."""

MOST_SHOWN = 400_000
"""Maximum characters of a page: a long program has more."""

MORE = "... and many more lines; ev3proto on the command line shows all"

MOST_AHEAD = 100
"""Maximum number of frames behind a page among which replies to its commands are looked for."""

Item = Record | Announcement | Image
"""What has lines."""


class Pages:
    """Everything that has lines, in order; an item's number is its place.

    start_ns   the time from which those that are shown count
    frames     the number of frames, or of programs
    dialogues  their number; a frame alone has none
    """

    def __init__(self) -> None:
        self.start_ns = self.frames = self.dialogues = 0
        self._items: list[Item] = []
        self._starts = [0]
        self._bytes = self._own = 0  # bytes and frames of the last page
        self._last: tuple[object, dict[str, Any]] = None, {}

    def add(self, item: Item) -> int:
        """Adds an item. Returns its number."""
        number, size = len(self._items), len(_bytes_of(item))
        is_full = self._own == MOST_FRAMES or self._bytes + size > MOST_BYTES
        if is_full and number > self._starts[-1]:
            self._starts.append(number)
            self._bytes = self._own = 0
        self._bytes += size
        is_frame, is_answer = not isinstance(item, Announcement), False
        if isinstance(item, Record):
            # Its counts go on increasing while reading.
            item.transfer = copy(item.transfer)
            is_answer = item.request is not None
        self._own += is_frame
        self.frames += is_frame
        self.dialogues += is_frame and not is_answer
        self._items.append(item)
        return number

    def page(self, number: int) -> dict[str, Any]:
        """Returns the page that has an item, for JSON.

        lines   of the tree, each with its pieces, the number of its item (-1 for none), offset and number of bytes
        frames  in hex, by number
        rows    its dialogues, each with time, command, reply, latency
        page    the numbers of its `first` item and of the first one of the `next` page, 0 for none; and those of its
                first and last frame, `begin` and `end`, counted from 1 without the texts between them
        """
        page = bisect_right(self._starts, number) - 1
        first = self._starts[page]
        end = self._starts[page + 1] if page + 1 < len(self._starts) else len(self._items)
        which = range(first, end)
        key = which, which.stop < len(self._items)
        if self._last[0] != key:
            self._last = key, self._rendered(which)
        return self._last[1]

    def _rendered(self, which: range) -> dict[str, Any]:
        items = self._items[which.start : which.stop]
        frames = {number: item for number, item in enumerate(items, which.start) if not isinstance(item, Announcement)}
        before = sum(not isinstance(item, Announcement) for item in self._items[: which.start])
        return {
            "lines": list(self._rows(items, which.start)),
            "frames": {number: _bytes_of(item).hex() for number, item in frames.items()},
            "rows": [self._dialogue_row(pair) for pair in self._dialogues(which)],
            "page": {
                "first": which.start,
                "next": which.stop if which.stop < len(self._items) else 0,
                "begin": before + 1,
                "end": before + len(frames),
            },
        }

    def _rows(self, items: list[Item], start: int) -> Iterator[list[Any]]:
        """Yields the lines of items, and a last one if there are more than are shown."""
        left = MOST_SHOWN
        for number, item in enumerate(items, start):
            for line in self._lines(item) if left > 0 else ():
                found = pieces(line)
                is_about = line.offset is not None and not isinstance(item, Announcement)
                yield [found, number, line.offset, line.length] if is_about else [found, -1, 0, 0]
                left -= sum(len(piece[0]) for piece in found) + 1
        if left <= 0:
            yield [[[MORE, Role.ASIDE]], -1, 0, 0]

    def _lines(self, item: Item) -> Iterator[Line]:
        if isinstance(item, Announcement):
            yield announcement_line(item, self.start_ns)
        elif isinstance(item, Record):
            seen = record_seen(item, self.start_ns) if item.written is None else item.seen
            yield from message_lines(item.exchange, seen, item.rest)
        else:
            try:
                yield from listing(parse_program(item.data, strict=False))
            except DecodeError:
                return  # that is a problem, which is told apart from the lines

    def _dialogues(self, which: range) -> Iterator[RequestReply]:
        """Yields the dialogues whose first frame is on a page."""
        own = {id(item) for item in self._items[which.start : which.stop]}
        near = islice(self._items, which.start, which.stop + MOST_AHEAD)
        for pair in dialogues(item for item in near if isinstance(item, Record)):
            if id(pair.command or pair.last) in own:
                yield pair

    def _dialogue_row(self, pair: RequestReply) -> list[str]:
        command, reply = pair
        first = command or pair.last
        latency = None if reply is None else reply.latency
        asks = command is not None and command.message.wants_reply
        return [
            elapsed(first.time_ns, self.start_ns) if first.route.is_timed else "",
            "(a command that was not seen)"
            if command is None
            else plain_text(command_spans(command.message, command.missing)),
            ("no reply" if asks else "") if reply is None else plain_text(reply_spans(reply.exchange, reply.missing)),
            "" if latency is None else f"{latency * 1000:.3f} ms",
        ]


def _bytes_of(item: Item) -> bytes:
    return item.frame if isinstance(item, Record) else item.data
