"""Prints the contents of a capture: its frames, the texts around them, its dialogues."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from ev3proto.capture.dialogues import RequestReply, dialogues
from ev3proto.capture.record import Announcement, Record, place_record
from ev3proto.cli.show import Show
from ev3proto.reading.items import Event
from ev3proto.reading.lines import announcement_line, pair_line, record_seen
from ev3proto.reading.parts import Part
from ev3proto.text.json_format.from_messages import record as message_record
from ev3proto.text.phrases import Seen
from ev3proto.text.spans import Role

if TYPE_CHECKING:
    from ev3proto.capture.filter import Filter


def matching(events: Iterable[Event], chosen: Filter | None, part: Part) -> Iterator[RequestReply]:
    """Yields each command in a part with its reply, if the two match the filter."""
    is_begun = False
    for pair in dialogues(event for event in events if isinstance(event, Record)):
        if chosen is not None and not is_begun:
            chosen.begin(part.account.first_ns or 0)
            is_begun = True
        if chosen is None or chosen.of_dialogue(pair):
            yield pair


def show_record(show: Show, record: Record, start_ns: int) -> None:
    """Shows a frame of a capture that starts at `start_ns`."""
    if show.is_json:
        show.entry(_entry(record))
    else:
        show.exchange(record.exchange, record_seen(record, start_ns))


def show_announcement(show: Show, announcement: Announcement, start_ns: int) -> None:
    """Shows a text of a capture that starts at `start_ns`."""
    if not show.is_json:
        show.line(announcement_line(announcement, start_ns))
        return
    show.entry(
        {
            "kind": announcement.said.name.lower(),
            "direction": announcement.route.direction,
            **place_record(announcement),
            "text": announcement.facts,
            "hex": announcement.data.hex(),
        }
    )


class Dialogues:
    """Shows commands with their replies, one a line. Where the connection changes, a line names it.

    is_known  whether the user knows the only connection
    """

    def __init__(self, show: Show, *, is_known: bool = False) -> None:
        self._show = show
        self._is_known = is_known
        self._place = ""

    def show(self, pair: RequestReply, start_ns: int) -> None:
        """Shows a command with its reply."""
        first, reply = pair.command or pair.last, pair.reply
        if self._show.is_json:
            entry: dict[str, Any] = {name: _entry(one) for name, one in pair._asdict().items() if one is not None}
            self._show.entry(entry | {"latency": None if reply is None else reply.latency})
            return
        route = first.route
        place = "" if route.is_text or self._is_known else f"{first.carrier} {first.peer}"
        if place and place != self._place:
            self._place = place
            self._show.aside([(place, Role.HEADING)])
        self._show.line(pair_line(pair, start_ns))


def _entry(record: Record) -> dict[str, Any]:
    """Returns a frame with its place in the capture or the log, for other tools."""
    seen = Seen(direction=record.direction, frame=record.frame)
    return message_record(record.exchange, seen) | record.circumstances()
