"""From events to marks, in memory that does not grow with the capture.

Up to MOST_MARKS, everything has a mark of its own. Beyond that, marks are counted in bins of time, and only troubles
are kept one by one, up to MOST_TROUBLES.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import NamedTuple

from ev3proto.bounded import Bounded
from ev3proto.capture.conversation import MOST_PENDING
from ev3proto.capture.dialogues import is_error
from ev3proto.capture.filter import Filter
from ev3proto.capture.moving import begins
from ev3proto.capture.record import NANOSECONDS, Announcement, Event, Record, Route, Skipped
from ev3proto.capture.timeline.bins import Bins
from ev3proto.capture.timeline.marks import OTHERS, TROUBLES, Lane, LaneKind, Mark, MarkState, Tally, Timeline
from ev3proto.capture.timeline.wording import (
    announcement_text,
    clean,
    clean_path,
    command_text,
    exchange_label,
    packets,
    reply_text,
    subject,
    transfer_progress,
)
from ev3proto.dialogue import Transfer

MOST_MARKS = 20_000
"""Marks that are drawn one by one."""

MOST_TROUBLES = 2_000
"""Troubles that are drawn one by one where the rest is counted."""

MOST_FILES = 500
"""Files that are drawn."""

MOST_BRICKS = 8
"""Bricks that have lanes of their own; the rest share theirs."""

MOST_WAITING = MOST_PENDING * MOST_BRICKS
"""Commands that wait for their reply; the oldest beyond that counts as never answered."""

MOST_LANES = 300
"""Lanes of all bricks together; what comes beyond that goes into the lane OTHERS of its kind."""

_KINDS = {"direct": LaneKind.DIRECT, "system": LaneKind.SYSTEM, "daisy": LaneKind.DAISY}


def collect(
    events: Iterable[Event],
    chosen: Callable[[Record], bool] | None = None,
    window: Window | None = None,
    most_marks: int = MOST_MARKS,
) -> Timeline | None:
    """Collects what is to be drawn of a capture.

    Args:
        events: The events of the capture.
        chosen: Which records to draw, by default all, with everything else. Of a command and its reply, one is enough
            for both.
        window: Which part of the capture to draw, by default all of it.
        most_marks: How many marks may be drawn one by one.

    Returns:
        The timeline; None where there is nothing to draw.
    """
    collector = Collector(chosen, window or Window(), most_marks)
    for event in events:
        collector.feed(event)
    return collector.finish()


@dataclass(slots=True)
class _Move:
    """A file on its way. The transfer itself counts on while the capture is read."""

    transfer: Transfer
    brick: str
    begin_ns: int
    end_ns: int
    first: int
    last: int
    failure: str = ""


class Window(NamedTuple):
    """The part of a capture that is drawn: what begins in it.

    first  seconds since the first event, None from the capture's begin on
    last   the same, None up to its end
    """

    first: float | None = None
    last: float | None = None


class Collector:
    """Takes events, one by one, and makes marks of them."""

    def __init__(self, chosen: Callable[[Record], bool] | None, window: Window, most_marks: int) -> None:
        self._chosen = chosen
        # Whether a command is chosen may only show with its reply.
        self._is_patient = isinstance(chosen, Filter) and chosen.looks_ahead
        self._window = window
        # When the capture's first event was captured, and between which times something is drawn.
        self._origin: int | None = None
        # Whether that has a time, as all captures and most logs have; else all is drawn in its order.
        self._is_timed = True
        self._first: float = -math.inf
        self._last: float = math.inf
        self._most_marks = most_marks
        self._marks: list[Mark] = []
        self._bins: Bins | None = None
        # The commands that wait, each with whether it is chosen: None where that is not known yet.
        self._waiting: Bounded[Record, tuple[Record, bool | None]] = Bounded(MOST_WAITING)
        self._moves: dict[int, _Move] = {}
        self._lanes: set[Lane] = set()
        self._bricks: dict[str, Tally] = {}
        self._span: tuple[int, int] | None = None
        self._unshown = 0

    def feed(self, event: Event) -> None:
        """Takes the next event."""
        if self._origin is None:
            self._begin(event)
        match event:
            case Record():
                self._record(event)
            case Announcement() if self._chosen is None:
                self._announcement(event)
            case Skipped() if self._chosen is None:
                self._skipped(event)

    def _begin(self, event: Event) -> None:
        self._is_timed = event.route.is_timed
        origin = self._origin = event.time_ns if self._is_timed else 0
        if self._window.first is not None:
            self._first = origin + self._window.first * NANOSECONDS
        if self._window.last is not None:
            self._last = origin + self._window.last * NANOSECONDS

    def _at(self, event: Event) -> int:
        """Where on the axis something stands: without times, each line of the text is as long as a second."""
        if self._is_timed:
            return event.time_ns
        return NANOSECONDS * (max(event.numbers) if isinstance(event, Announcement) else event.number)

    def finish(self) -> Timeline | None:
        """All that was collected; commands that still wait were never answered. None where nothing was."""
        while self._waiting:
            self._give_up(*self._waiting.pop_oldest())
        files = [
            self._file(move)
            for move in self._moves.values()
            if self._is_inside(move.begin_ns) or move.begin_ns < self._first <= move.end_ns
        ]
        if self._span is None or self._origin is None:
            return None
        begin, end = self._span
        return Timeline(
            origin_ns=self._origin,
            begin_ns=begin if self._window.first is None else round(self._first),
            end_ns=end if self._window.last is None else round(self._last),
            marks=sorted(self._marks, key=lambda mark: mark.begin_ns),
            files=sorted(files, key=lambda mark: mark.begin_ns),
            cells=self._bins.cells if self._bins else {},
            bin_ns=self._bins.width_ns if self._bins else 0,
            bricks={name: tally for name, tally in self._bricks.items() if tally.messages or tally.outcomes},
            unshown=self._unshown,
            is_timed=self._is_timed,
        )

    def _record(self, record: Record) -> None:
        message = record.message
        if self._is_patient and message.wants_reply:
            oldest = self._waiting.add(record, (record, None))
            if oldest is not None:
                self._give_up(*oldest)
            return
        is_chosen = self._is_chosen(record)
        if is_chosen:
            self._chosen_record(record)
        if message.type is None:
            return
        if not message.type.is_command:
            waited = None if record.request is None else self._waiting.pop(record.request, None)
            was_chosen = waited is not None and self._settled(*waited)
            if is_chosen or was_chosen:
                self._exchange(record.request, record)
        elif message.wants_reply:
            oldest = self._waiting.add(record, (record, is_chosen))
            if oldest is not None:
                self._give_up(*oldest)
        elif is_chosen:
            self._exchange(record, None)

    def _is_chosen(self, record: Record) -> bool:
        return self._chosen is None or self._chosen(record)

    def _settled(self, command: Record, is_chosen: bool | None) -> bool:
        """Whether a command is chosen, now that its reply was seen or can no longer come."""
        if is_chosen is not None:
            return is_chosen
        is_chosen = self._is_chosen(command)
        if is_chosen:
            self._chosen_record(command)
        return is_chosen

    def _chosen_record(self, record: Record) -> None:
        brick = self._brick(record.route)
        if self._is_inside(self._at(record)):
            self._bricks[brick].messages += 1
        if record.message.fault is not None or record.message.type is None:
            self._faulty(record, brick)
        if record.transfer is not None:
            self._move(record, record.transfer, brick)

    def _give_up(self, command: Record, is_chosen: bool | None) -> None:
        """A command was never answered."""
        if self._settled(command, is_chosen):
            self._exchange(command, None)

    def _exchange(self, command: Record | None, reply: Record | None) -> None:
        """A command and its reply, or one of them alone."""
        seen = command or reply
        assert seen is not None
        assert seen.message.type is not None
        begin, end = self._at(seen), self._at(reply) if command and reply else None
        outcome = _outcome(command, reply)
        about = subject(seen.message)
        lane = self._lane(self._brick(seen.route), _KINDS[seen.message.type.carries], about)
        mark = Mark(lane, outcome, begin, end, about, "", {}, seen.number)
        mark.is_timed = self._is_timed and seen.route.is_timed and (reply is None or reply.route.is_timed)
        if self._is_told(outcome):
            mark.label = exchange_label(command, reply)
            mark.details = _exchange_details(command, reply)
        self._keep(mark)

    def _faulty(self, record: Record, brick: str) -> None:
        fault = record.message.fault
        mark = Mark(
            self._lane(brick, LaneKind.TROUBLE, "faulty frames"),
            MarkState.FAULTY,
            self._at(record),
            None,
            "faulty frame" if record.message.type is None else f"faulty {record.message.type.name}",
            "",
            {
                "fault": clean(f"at {fault}") if fault is not None else "no message type that there is",
                "packet": packets(record.numbers),
                "bytes": str(len(record.frame)),
            },
            record.number,
        )
        self._keep(mark)

    def _announcement(self, announcement: Announcement) -> None:
        brick = self._brick(announcement.route)
        details = {
            "says": announcement_text(announcement),
            "from": clean(announcement.route.source),
            "to": clean(announcement.route.target),
            "packet": packets(announcement.numbers),
        }
        said = announcement.said.value
        lane = self._lane(brick, LaneKind.ANNOUNCEMENTS, said)
        number = max(announcement.numbers)
        self._keep(Mark(lane, MarkState.ANNOUNCED, self._at(announcement), None, said, "", details, number))

    def _skipped(self, skipped: Skipped) -> None:
        lane = self._lane(self._brick(skipped.route), LaneKind.TROUBLE, "skipped bytes")
        details = {
            "reason": clean(skipped.reason),
            "from": clean(skipped.route.source),
            "to": clean(skipped.route.target),
            "packet": str(skipped.number),
        }
        if skipped.missing:
            details["not captured"] = f"{skipped.missing} bytes"
        heading = f"{len(skipped.data)} bytes skipped" if skipped.data else "bytes are missing"
        self._keep(Mark(lane, MarkState.SKIPPED, self._at(skipped), None, heading, "", details, skipped.number))

    def _move(self, record: Record, transfer: Transfer, brick: str) -> None:
        move = self._moves.get(id(transfer))
        if move is None:
            if len(self._moves) >= MOST_FILES:
                self._unshown += begins(record.message)
                return
            move = _Move(transfer, brick, self._at(record), self._at(record), record.number, record.number)
            self._moves[id(transfer)] = move
        move.begin_ns, move.first = min((move.begin_ns, move.first), (self._at(record), record.number))
        move.end_ns, move.last = max((move.end_ns, move.last), (self._at(record), record.number))
        if is_error(record.message):
            move.failure = reply_text(record)

    def _file(self, move: _Move) -> Mark:
        transfer = move.transfer
        outcome = MarkState.MOVED if transfer.is_complete else MarkState.CUT_SHORT
        details = {
            "path": clean(transfer.path),
            "command": transfer.command,
            "moved": transfer_progress(transfer),
            "packets": f"{move.first} to {move.last}",
        }
        if move.failure:
            # It is counted already, as the answer of the command that failed.
            outcome = MarkState.ERROR
            details["error"] = move.failure
        else:
            self._bricks[move.brick].outcomes[outcome] += 1
        lane = Lane(move.brick, LaneKind.FILES, "")
        heading = f"{transfer.command} {clean_path(transfer.path)}"
        return Mark(lane, outcome, move.begin_ns, move.end_ns, heading, clean_path(transfer.path), details, move.first)

    def _brick(self, route: Route) -> str:
        name = clean(f"{route.carrier.facts.label} {route.peer}", 60)
        if name not in self._bricks:
            if len(self._bricks) >= MOST_BRICKS:
                name = OTHERS
            self._bricks.setdefault(name, Tally())
        return name

    def _lane(self, brick: str, kind: LaneKind, about: str) -> Lane:
        lane = Lane(brick, kind, about)
        if lane in self._lanes or len(self._lanes) < MOST_LANES:
            self._lanes.add(lane)
            return lane
        return Lane(brick, kind, OTHERS)

    def _is_told(self, outcome: MarkState) -> bool:
        """Whether the mark will be drawn by itself, so that its words are worth finding."""
        return self._bins is None or (outcome in TROUBLES and len(self._marks) < MOST_TROUBLES)

    def _is_inside(self, time_ns: int) -> bool:
        return self._first <= time_ns <= self._last

    def _keep(self, mark: Mark) -> None:
        if not self._is_inside(mark.begin_ns):
            return
        last = mark.begin_ns if mark.end_ns is None else mark.end_ns
        first, latest = self._span or (mark.begin_ns, last)
        self._span = min(first, mark.begin_ns), max(latest, last)
        self._bricks[mark.lane.brick].add(mark)
        if self._bins is not None:
            self._bins.add(mark)
            self._keep_trouble(mark)
            return
        self._marks.append(mark)
        if len(self._marks) > self._most_marks:
            marks, self._marks, self._bins = self._marks, [], Bins()
            for each in marks:
                self._bins.add(each)
                self._keep_trouble(each)

    def _keep_trouble(self, mark: Mark) -> None:
        if mark.outcome not in TROUBLES:
            return
        if len(self._marks) < MOST_TROUBLES:
            self._marks.append(mark)
        else:
            self._unshown += 1


def _outcome(command: Record | None, reply: Record | None) -> MarkState:
    if reply is None:
        assert command is not None
        return MarkState.UNANSWERED if command.message.wants_reply else MarkState.SILENT
    if is_error(reply.message):
        return MarkState.ERROR
    return MarkState.ANSWERED if command is not None else MarkState.ORPHAN


def _exchange_details(command: Record | None, reply: Record | None) -> dict[str, str]:
    details = {}
    if command is not None:
        details["command"] = command_text(command)
    if reply is not None:
        details["reply"] = reply_text(reply)
    for name, record in (("command", command), ("reply", reply)):
        if record is None:
            continue
        details[f"{name}'s packet"] = packets(record.numbers)
        if record.note is not None:
            details[f"{name}'s note"] = clean(record.note)
    seen = command or reply
    assert seen is not None
    details["counter"] = str(seen.message.counter)
    return details
