"""Commands with their replies on standard output."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from ev3proto.capture.dialogues import RequestReply, dialogues
from ev3proto.capture.record import Record
from ev3proto.cli.formats import Format
from ev3proto.reading.items import Event
from ev3proto.reading.parts import Part
from ev3proto.semantics.pairing import counters_slip
from ev3proto.text.spans import Role

if TYPE_CHECKING:
    from ev3proto.capture.filter import Filter


MOST_ALONE = 4096
"""Maximum number of commands, and of replies, without the other that are kept to find out why."""


def matching(events: Iterable[Event], chosen: Filter | None, part: Part) -> Iterator[RequestReply]:
    """Yields each command in a part with its reply, if the two match the filter."""
    is_begun = False
    for pair in dialogues(event for event in events if isinstance(event, Record)):
        if chosen is not None and not is_begun:
            chosen.begin(part.account.first_ns or 0)
            is_begun = True
        if chosen is None or chosen.of_dialogue(pair):
            yield pair


class Dialogues:
    """Shows commands with their replies, one a line. Where the connection changes, a line names it.

    is_known  whether the user knows the only connection
    """

    def __init__(self, show: Format, *, is_known: bool = False) -> None:
        self._show = show
        self._is_known = is_known
        self._place = ""
        self._has_labels = False
        self._commands: list[bytes] = []
        self._replies: list[bytes] = []
        self._paired = 0

    def show(self, pair: RequestReply, start_ns: int) -> None:
        """Shows a command with its reply."""
        first = pair.command or pair.last
        place = self._label(pair) if first.route.is_text else f"{first.carrier} {first.peer}"
        if place and place != self._place and not self._is_known:
            self._place = place
            self._show.aside([(place, Role.HEADING)])
        self._show.pair(pair, start_ns)
        self._keep(pair)

    def end(self) -> None:
        """Shows why replies answer no command, if one slip of the counters explains that for most."""
        slip = counters_slip(self._commands, self._replies) if self._paired <= len(self._replies) else None
        if slip is not None:
            self._show.aside([(slip, Role.HEADING)])
        self._commands, self._replies, self._paired = [], [], 0

    def _keep(self, pair: RequestReply) -> None:
        """Keeps the frame of a command without a reply, or of a reply without a command."""
        message, frame = pair.last.message, pair.last.frame
        if None not in pair:
            self._paired += 1
        elif message.type is not None and message.wants_reply is message.type.is_command:
            kept = self._commands if message.type.is_command else self._replies
            kept += [frame] if len(kept) < MOST_ALONE else []

    def _label(self, pair: RequestReply) -> str:
        """Returns the label of a dialogue in a text; empty as long as no command has that of its reply."""
        command, reply = pair
        self._has_labels |= command is not None and reply is not None and command.label == reply.label != ""
        return ((command or pair.last).label or "without a label") if self._has_labels else ""
