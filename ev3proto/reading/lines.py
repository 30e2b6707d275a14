"""What is read as lines: messages with what is around them, the texts of a capture, dialogues."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from ev3proto.capture.dialogues import RequestReply
from ev3proto.capture.record import Announcement, Record, Route, elapsed
from ev3proto.dialogue import Exchange
from ev3proto.errors import counted
from ev3proto.text.phrases import Seen, dialogue_line, origin, spaced_hex
from ev3proto.text.sentence import sentence
from ev3proto.text.spans import Line, Role, Spans
from ev3proto.text.table import table
from ev3proto.text.tree import tree

LINE_STYLES: dict[str, Callable[[Exchange, Seen], Iterable[Line]]] = {
    "tree": tree,
    "table": table,
    "sentence": lambda exchange, seen: [Line([*origin(seen), (sentence(exchange, seen.missing), Role.PLAIN)])],
}
"""The styles of messages as lines."""

_MOST_REST = 16


def message_lines(exchange: Exchange, seen: Seen, rest: bytes = b"", style: str = "tree") -> Iterator[Line]:
    """Yields a message in a style, the bytes after it, and a note on it."""
    yield from LINE_STYLES[style](exchange, seen)
    if rest:
        follow = "follows" if len(rest) == 1 else "follow"
        shown = f": {spaced_hex(rest[:_MOST_REST])}{' ...' * (len(rest) > _MOST_REST)}" if any(rest) else ""
        count = counted(len(rest), "left-over byte") if shown else f"{counted(len(rest), 'byte')} of padding"
        yield Line([(f"        {count} {follow} the frame{shown}", Role.PLAIN)])
    if exchange.note is not None:
        yield Line([(f"  note: {exchange.note}", Role.MEANING)])


def record_seen(event: Record | Announcement, start_ns: int) -> Seen:
    """Returns the circumstances of an event in a capture or a log that starts at `start_ns`."""
    route = event.route
    time = elapsed(event.time_ns, start_ns) if route.is_timed else None
    seen = Seen(route.direction, time, packets=event.numbers, place=None if route.is_text else _place(route))
    if isinstance(event, Announcement):
        return seen
    answers = None if event.request is None else event.request.number
    return seen._replace(answers=answers, latency=event.latency, missing=event.missing, frame=event.frame)


def _place(route: Route) -> str:
    return f"{route.carrier} {route.peer}"


def announcement_line(announcement: Announcement, start_ns: int) -> Line:
    """Returns the line of a text around the frames of a capture that starts at `start_ns`."""
    listed = ", ".join(f"{name} {value}" for name, value in announcement.facts.items())
    line = [*origin(record_seen(announcement, start_ns)), (str(announcement.said), Role.HEADING)]
    return Line([*line, (f": {listed}" if listed else "", Role.VALUE)])


def pair_line(pair: RequestReply, start_ns: int) -> Spans:
    """Returns a command with its reply on one line, of a capture that starts at `start_ns`."""
    first, reply = pair.command or pair.last, pair.reply
    time = elapsed(first.time_ns, start_ns) if first.route.is_timed else ""
    return [
        (f"{time:>12} ", Role.ASIDE),
        (f"#{first.number} ".rjust(7), Role.ASIDE),
        *dialogue_line(
            None if pair.command is None else pair.command.message,
            None if reply is None else reply.exchange,
            None if reply is None else reply.latency,
            of_command=0 if pair.command is None else pair.command.missing,
            of_reply=0 if reply is None else reply.missing,
        ),
    ]
