"""Prints the contents of a capture: its frames, the texts around them, its dialogues."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from ev3proto.capture.dialogues import RequestReply
from ev3proto.capture.files import RecoveredFile, recover
from ev3proto.capture.record import Announcement, CaptureError, Record, elapsed, utc
from ev3proto.cli.captures import CaptureSource
from ev3proto.cli.kinds import is_image
from ev3proto.cli.show import Show
from ev3proto.temporary import temporary_folder
from ev3proto.text.json_format.from_messages import record as message_record
from ev3proto.text.phrases import Seen, dialogue_line, origin
from ev3proto.text.spans import Role, Spans, visible


def show_capture(show: Show, capture: CaptureSource, *, as_dialogues: bool) -> Iterator[Record]:
    """Shows the frames and texts of a capture, or its dialogues, and yields the frames."""
    if as_dialogues:
        dialogues = Dialogues(show)
        for pair in capture.dialogues():
            dialogues.show(pair, capture.account.first_ns or 0)
            yield from filter(None, pair)
        return
    for event in capture.events():
        start_ns = capture.account.first_ns or 0
        if isinstance(event, Record):
            _show_record(show, event, start_ns)
            yield event
        elif isinstance(event, Announcement):
            show_announcement(show, event, start_ns)


def moved_programs(capture: CaptureSource, complain: Callable[[str], None]) -> Iterator[tuple[str, bytes]]:
    """Yields the origins and images of the programs that a capture transfers, as far as they were captured."""
    with temporary_folder() as folder:
        found: list[RecoveredFile] = []
        try:
            # One by one, so that earlier files are kept if the capture ends early.
            found += recover(capture.events(), folder)
        except CaptureError as error:
            complain(f"{capture.label}: {error}")
        except OSError as error:
            complain(f"the programs cannot be written to {folder}: {error.strerror or error}")
        for file in found:
            image = b"" if file.file is None else file.file.read_bytes()
            if is_image(image):
                yield f"{capture.where(file.packets[0])}: {visible(file.path)}", image


def _show_record(show: Show, record: Record, start_ns: int) -> None:
    """Shows a frame of a capture that starts at `start_ns`."""
    if show.is_json:
        show.entry(_record(record))
        return
    answers = None if record.request is None else record.request.number
    show.exchange(record.exchange, _seen(record, start_ns, answers))


def show_announcement(show: Show, announcement: Announcement, start_ns: int) -> None:
    """Shows a text of a capture that starts at `start_ns`."""
    facts = announcement.facts
    if show.is_json:
        show.entry(
            {
                "kind": announcement.said.name.lower(),
                "direction": announcement.route.direction,
                **_place(announcement),
                "text": facts,
                "hex": announcement.data.hex(),
            }
        )
        return
    listed = ", ".join(f"{name} {value}" for name, value in facts.items())
    line = [*origin(_seen(announcement, start_ns)), (str(announcement.said), Role.HEADING)]
    show.line([*line, (f": {listed}" if listed else "", Role.VALUE)])


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
            entry: dict[str, Any] = {name: _record(one) for name, one in pair._asdict().items() if one is not None}
            self._show.entry(entry | {"latency": None if reply is None else reply.latency})
            return
        route = first.route
        place = "" if route.is_text or self._is_known else f"{first.carrier} {first.peer}"
        if place and place != self._place:
            self._place = place
            self._show.aside([(place, Role.HEADING)])
        time = elapsed(first.time_ns, start_ns) if route.is_timed else ""
        line: Spans = [(f"{time:>12} ", Role.ASIDE), (f"#{first.number} ".rjust(7), Role.ASIDE)]
        line += dialogue_line(
            None if pair.command is None else pair.command.message,
            None if reply is None else reply.exchange,
            None if reply is None else reply.latency,
        )
        self._show.line(line)


def _seen(event: Record | Announcement, start_ns: int, answers: int | None = None) -> Seen:
    route = event.route
    return Seen(
        direction=route.direction,
        time=elapsed(event.time_ns, start_ns) if route.is_timed else None,
        packets=event.numbers,
        place=None if route.is_text else f"{route.carrier} {route.peer}",
        answers=answers,
        latency=event.latency if isinstance(event, Record) else None,
        frame=event.frame if isinstance(event, Record) else None,
    )


def _record(record: Record) -> dict[str, Any]:
    """Returns a frame with its place in the capture, for other tools."""
    entry = message_record(record.exchange, Seen(direction=record.direction, frame=record.frame)) | _place(record)
    if record.request is not None:
        entry |= {"answers": record.request.number, "latency": record.latency}
    return entry


def _place(event: Record | Announcement) -> dict[str, Any]:
    """Returns place and time for other tools; without `time` for a log without times."""
    route = event.route
    time = {"time": utc(event.time_ns)} if route.is_timed else {}
    return time | {
        "packets": list(event.numbers),
        "interface": route.interface,
        "carrier": route.carrier,
        "source": route.source,
        "target": route.target,
        "peer": route.peer,
    }
