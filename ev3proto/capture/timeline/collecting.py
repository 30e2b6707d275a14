"""Turns events into marks, in memory that does not grow with the capture.

Up to MOST_MARKS, everything has its own mark. Beyond that, marks are counted in bins of time, and only problems
are kept one by one, up to MOST_TROUBLES.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Iterable
from dataclasses import dataclass
from typing import NamedTuple

from ev3proto.capture.dialogues import RequestReply, dialogues, is_error
from ev3proto.capture.moving import Moved
from ev3proto.capture.record import NANOSECONDS, Announcement, Event, Record, Route, Skipped, utc
from ev3proto.capture.timeline.marks import OTHERS, TROUBLES, Bins, Lane, LaneKind, Mark, MarkState, Tally, Timeline
from ev3proto.dialogue import Transfer
from ev3proto.messages import DaisyCommand, DirectCommand, Message, SystemCommand, SystemReply
from ev3proto.semantics.transfers import step_of
from ev3proto.text.phrases import argument_meaning, argument_value, command_spans, reply_spans, value_text
from ev3proto.text.spans import plain_text, visible

MOST_MARKS = 20_000
"""Maximum number of marks that are drawn one by one."""

MOST_TROUBLES = 2_000
"""Maximum number of problems that are drawn one by one if the rest is counted."""

MOST_FILES = 500
"""Maximum number of files that are drawn."""

MOST_BRICKS = 8
"""Maximum number of bricks with their own lanes; the rest share theirs."""

MOST_LANES = 300
"""Maximum number of lanes of all bricks; further subjects share the lane OTHERS of their kind."""

MOST_LETTERS = 240
"""Maximum length of one detail, in letters."""

MOST_LABEL = 28
"""Maximum length of a label beside a mark, in letters."""

MOST_TOLD = 8
"""Maximum number of values in a label."""

_KINDS = {"direct": LaneKind.DIRECT, "system": LaneKind.SYSTEM, "daisy": LaneKind.DAISY}


class Window(NamedTuple):
    """The part of a capture that is drawn, in seconds since the first event; None means no limit."""

    first: float | None = None
    last: float | None = None


def collect(
    events: Iterable[Event],
    chosen: Callable[[Record], bool] | None = None,
    window: Window | None = None,
    most_marks: int = MOST_MARKS,
) -> Timeline | None:
    """Returns the timeline of a capture; None if there is nothing to draw.

    A command and its reply are drawn if either is chosen; without `chosen` everything is, within the window.
    """
    collector = _Collector(chosen, window or Window(), most_marks)
    for pair in dialogues(map(collector.seen, events)):
        collector.dialogue(pair)
    return collector.timeline()


def collect_in_steps(
    events: Iterable[Event],
    chosen: Callable[[Record], bool] | None = None,
    window: Window | None = None,
    most_marks: int = MOST_MARKS,
) -> Generator[None, None, Timeline | None]:
    """Collects in steps: yields after each dialogue, and returns the timeline."""
    collector = _Collector(chosen, window or Window(), most_marks)
    for pair in dialogues(map(collector.seen, events)):
        collector.dialogue(pair)
        yield
    return collector.timeline()


@dataclass(slots=True)
class _Move:
    moved: Moved
    brick: str
    begin: tuple[float, int]
    end: tuple[float, int]


class _Collector:
    def __init__(self, chosen: Callable[[Record], bool] | None, window: Window, most_marks: int) -> None:
        self._chosen = chosen
        self._window = window
        self._first = -math.inf if window.first is None else window.first
        self._last = math.inf if window.last is None else window.last
        self._origin: int | None = None
        # Some logs have no times; their messages are drawn in order.
        self._is_timed = True
        self._most_marks = most_marks
        self._marks: list[Mark] = []
        self._bins: Bins | None = None
        self._moves: dict[int, _Move] = {}
        self._lanes: set[Lane] = set()
        self._bricks: dict[str, Tally] = {}
        self._begin, self._end = math.inf, -math.inf
        self._unshown = 0

    def seen(self, event: Event) -> Event:
        """Adds events that are not records. Returns the event."""
        if self._origin is None:
            self._is_timed = event.route.is_timed
            self._origin = event.time_ns if self._is_timed else 0
        match event:
            case Announcement() if self._chosen is None:
                said = event.said.value
                facts = ", ".join(f"{name} {value}" for name, value in event.facts.items())
                details = {"says": clean(facts or f"{len(event.data)} bytes"), **_ends(event.route)}
                self._point(event, LaneKind.ANNOUNCEMENTS, said, MarkState.ANNOUNCED, said, details)
            case Skipped() if self._chosen is None:
                heading = f"{len(event.data)} bytes skipped" if event.data else "bytes are missing"
                details = {"reason": clean(event.reason), **_ends(event.route)}
                if event.missing:
                    details["not captured"] = f"{event.missing} bytes"
                self._point(event, LaneKind.TROUBLE, "skipped bytes", MarkState.SKIPPED, heading, details)
        return event

    def dialogue(self, pair: RequestReply) -> None:
        """Adds a command with its reply; both are drawn if either is selected."""
        counted = [record for record in pair if record is not None and self._is_counted(record)]
        if any(record.message.type is not None for record in counted):
            self._exchange(pair)

    def timeline(self) -> Timeline | None:
        """Returns the timeline; None if nothing was collected."""
        files = [
            self._file(move)
            for move in self._moves.values()
            if self._is_inside(move.begin[0]) or move.begin[0] < self._first <= move.end[0]
        ]
        if math.isinf(self._begin) or self._origin is None:
            return None
        cells, width = ({}, 0.0) if self._bins is None else (self._bins.cells, self._bins.width_ns / NANOSECONDS)
        return Timeline(
            origin_ns=self._origin,
            begin=self._begin if self._window.first is None else self._first,
            end=self._end if self._window.last is None else self._last,
            marks=sorted([*self._marks, *files], key=lambda mark: mark.begin),
            cells=cells,
            bin_width=width,
            bricks={name: tally for name, tally in self._bricks.items() if tally.messages or tally.outcomes},
            unshown=self._unshown,
            is_timed=self._is_timed,
        )

    def _at(self, event: Event) -> float:
        """Returns the position on the axis; without times, each line of the text counts as a second."""
        assert self._origin is not None
        return (event.time_ns - self._origin) / NANOSECONDS if self._is_timed else _number(event)

    def _is_inside(self, seconds: float) -> bool:
        return self._first <= seconds <= self._last

    # Records

    def _is_counted(self, record: Record) -> bool:
        """Tells whether a record is selected. If so, counts it for its brick and file, and adds a mark for a fault."""
        if self._chosen is not None and not self._chosen(record):
            return False
        message = record.message
        brick = self._brick(record.route)
        if self._is_inside(self._at(record)):
            self._bricks[brick].messages += 1
        if record.fault is not None or message.type is None:
            heading = "faulty frame" if message.type is None else f"faulty {message.type.name}"
            fault = "unknown message type" if record.fault is None else clean(f"at {record.fault}")
            details = {"fault": fault, "bytes": str(len(record.frame))}
            self._point(record, LaneKind.TROUBLE, "faulty frames", MarkState.FAULTY, heading, details)
        if record.transfer is not None:
            self._move(record, record.transfer, brick)
        return True

    def _exchange(self, pair: RequestReply) -> None:
        command, reply = pair
        seen = command or reply
        assert seen is not None
        assert seen.message.type is not None
        subject = _subject(seen.message)
        lane = self._lane(self._brick(seen.route), _KINDS[seen.message.type.carries], subject)
        mark = Mark(lane, _outcome(pair), self._at(seen), None, "", {}, seen.number)
        if command and reply:
            mark.end = self._at(reply)
            if self._is_timed and reply.latency is not None:
                mark.latency = max(reply.latency, 0.0)
        if self._bins is None or (mark.outcome in TROUBLES and len(self._marks) < MOST_TROUBLES):
            details = _exchange_details(pair)
            if mark.latency is not None:
                details = {"answer after": f"{mark.latency * 1000:,.3f} ms", **details}
            mark.label = _exchange_label(*pair)
            mark.tip = self._tip(subject, mark, seen, details)
        self._keep(mark)

    def _point(
        self, event: Event, kind: LaneKind, subject: str, outcome: MarkState, heading: str, details: dict[str, str]
    ) -> None:
        mark = Mark(self._lane(self._brick(event.route), kind, subject), outcome, self._at(event), None, "", {}, 0)
        mark.number = _number(event)
        mark.tip = self._tip(heading, mark, event, {"packet": _packets(event), **details})
        self._keep(mark)

    def _tip(self, heading: str, mark: Mark, event: Event, details: dict[str, str]) -> dict[str, str]:
        tip = {"title": heading, "outcome": mark.outcome.value}
        if self._is_timed and event.route.is_timed:
            tip |= {"at": f"{mark.begin:.6f} s", "clock": clock(event.time_ns)}
        return tip | {"brick": mark.lane.brick} | details

    def _move(self, record: Record, transfer: Transfer, brick: str) -> None:
        at = self._at(record), record.number
        move = self._moves.get(id(transfer))
        if move is None:
            if len(self._moves) >= MOST_FILES:
                self._unshown += step_of(record.message) == "begin"
                return
            move = self._moves[id(transfer)] = _Move(Moved(transfer), brick, at, at)
        move.begin, move.end = min(move.begin, at), max(move.end, at)
        move.moved.add(record)

    def _file(self, move: _Move) -> Mark:
        transfer, failure, (begin, first), (end, last) = move.moved.transfer, move.moved.failure, move.begin, move.end
        outcome = MarkState.MOVED if move.moved.is_complete else MarkState.ERROR if failure else MarkState.CUT_SHORT
        if failure is None:
            # A failed command is already counted by its reply.
            self._bricks[move.brick].outcomes[outcome] += 1
        path = visible(transfer.path[-MOST_LABEL - 1 :])
        label = path if len(path) <= MOST_LABEL else f"…{path[1 - MOST_LABEL :]}"
        tip = {"title": f"{transfer.command} {label}", "outcome": outcome.value}
        if self._is_timed:
            tip |= {"at": f"{begin:.6f} s", "took": f"{(end - begin) * 1000:,.3f} ms"}
        tip |= {
            "path": clean(transfer.path),
            "moved": f"{transfer.transferred} of {'?' if transfer.size is None else transfer.size} bytes",
            "packets": f"{first} to {last}",
        }
        if failure is not None:
            tip["error"] = _reply_text(failure)
        return Mark(Lane(move.brick, LaneKind.FILES, ""), outcome, begin, end, label, tip, first)

    # Limits

    def _brick(self, route: Route) -> str:
        name = clean(f"{route.carrier.facts.label} {route.peer}", 60)
        if name not in self._bricks:
            if len(self._bricks) >= MOST_BRICKS:
                name = OTHERS
            self._bricks.setdefault(name, Tally())
        return name

    def _lane(self, brick: str, kind: LaneKind, subject: str) -> Lane:
        lane = Lane(brick, kind, subject)
        if lane not in self._lanes and len(self._lanes) >= MOST_LANES:
            return Lane(brick, kind, OTHERS)
        self._lanes.add(lane)
        return lane

    def _keep(self, mark: Mark) -> None:
        if not self._is_inside(mark.begin):
            return
        self._begin = min(self._begin, mark.begin)
        self._end = max(self._end, mark.begin if mark.end is None else mark.end)
        self._bricks[mark.lane.brick].add(mark)
        new = [mark]
        if self._bins is None:
            self._marks.append(mark)
            if len(self._marks) <= self._most_marks:
                return
            new, self._marks, self._bins = self._marks, [], Bins()
        for each in new:
            self._count(self._bins, each)

    def _count(self, bins: Bins, mark: Mark) -> None:
        bins.add(mark)
        if mark.outcome in TROUBLES:
            if len(self._marks) < MOST_TROUBLES:
                self._marks.append(mark)
            else:
                self._unshown += 1


# Texts. Those from the network can be long, and contain characters that reorder the text around them: see `clean`.


def clean(text: str, most: int = MOST_LETTERS) -> str:
    """Escapes unprintable characters, and shortens the text to `most` letters."""
    shown = visible(text[: most + 1])
    return shown if len(shown) <= most else f"{shown[: most - 1]}…"


def clock(time_ns: int) -> str:
    """Returns `2024-01-31 09:12:31.011558 UTC`, or the bare seconds of a source without dates."""
    return utc(time_ns).replace("T", " ").replace("Z", " UTC")


def _ends(route: Route) -> dict[str, str]:
    return {"from": clean(route.source), "to": clean(route.target)}


def _number(event: Event) -> int:
    return event.number if isinstance(event, Skipped) else max(event.numbers)


def _packets(event: Event) -> str:
    """Returns `7`, `7, 8`, `7 to 31 (9 packets)`."""
    numbers = (event.number,) if isinstance(event, Skipped) else event.numbers
    if len(numbers) <= 3:
        return ", ".join(map(str, numbers))
    return f"{numbers[0]} to {numbers[-1]} ({len(numbers)} packets)"


def _outcome(pair: RequestReply) -> MarkState:
    command, reply = pair
    if reply is None:
        assert command is not None
        return MarkState.UNANSWERED if command.message.wants_reply else MarkState.SILENT
    if is_error(reply.message):
        return MarkState.ERROR
    return MarkState.ANSWERED if command is not None else MarkState.ORPHAN


def _subject(message: Message) -> str:
    """Returns the subject of a message: its operations, system command or daisy command."""
    match message:
        case DirectCommand():
            names = list(dict.fromkeys(operation.full_name for operation in message.operations)) or ["no operation"]
            return ", ".join(names) if len(names) <= 2 else f"{names[0]} + {len(names) - 1} more"
        case SystemCommand() | SystemReply() | DaisyCommand():
            return message.command or f"0x{message.number:02X}"
    return "command not seen"


def _exchange_details(pair: RequestReply) -> dict[str, str]:
    command, reply = pair
    details = {}
    if command is not None:
        details["command"] = clean(plain_text(command_spans(command.message, command.missing)))
    if reply is not None:
        details["reply"] = _reply_text(reply)
    for name, record in pair._asdict().items():
        if record is not None:
            details[f"{name}'s packet"] = _packets(record)
            if record.note is not None:
                details[f"{name}'s note"] = clean(record.note)
            details["counter"] = str(record.message.counter)
    return details


def _reply_text(reply: Record) -> str:
    return clean(plain_text(reply_spans(reply.exchange, reply.missing)))


def _exchange_label(command: Record | None, reply: Record | None) -> str:
    """Returns the values of the reply; without a reply, the arguments of a single operation."""
    if reply is not None:
        if is_error(reply.message):
            return _reply_text(reply).split(" ", 1)[0]
        values = [] if isinstance(reply.message, SystemReply) else reply.values[:MOST_TOLD]
        return clean(", ".join(map(value_text, values)), MOST_LABEL)
    message = command and command.message
    if not isinstance(message, DirectCommand) or message.wants_reply or len(message.operations) != 1:
        return ""
    arguments = message.operations[0].arguments[:MOST_TOLD]
    shown = (each.symbol or f"{argument_value(each)} {argument_meaning(each)}".rstrip() for each in arguments)
    return clean(", ".join(shown), MOST_LABEL)
