"""Direct commands of a capture as texts straight from the bytes of their frames, for trees and JSON.

Most frames of a long capture are such commands. No messages are made of them: they are shown in half the time.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

from ev3proto.capture.record import Record, Route, elapsed, utc
from ev3proto.schema.instructions import instruction_set
from ev3proto.text.heading import Seen, origin, packets_text

_MOST_ROUTES = 1024
"""Routes of which is kept what their texts have in common."""


class Straight(ABC):
    """Writes the direct commands of a capture."""

    def __init__(self, dialect: str) -> None:
        """Knows no route yet.

        Args:
            dialect: The firmware whose instruction set to read by.

        """
        self._instructions = instruction_set(dialect)
        # By the id of a route, since there are few and to hash one takes long: the route, which keeps the id, its text.
        self._routes: dict[int, tuple[Route, str]] = {}

    @abstractmethod
    def texts(self, record: Record, start_ns: int) -> list[str] | None:
        """The lines of a frame in a capture that began then. None for what is no direct command, or an unusual one."""

    @abstractmethod
    def _text(self, route: Route) -> str:
        """What the texts of a route's frames have in common."""

    def _common(self, route: Route) -> str:
        found = self._routes.get(id(route))
        if found is None:
            if len(self._routes) >= _MOST_ROUTES:
                self._routes.clear()
            found = self._routes[id(route)] = route, self._text(route)
        return found[1]


class StraightTree(Straight):
    """Writes them as trees."""

    def texts(self, record: Record, start_ns: int) -> list[str] | None:
        """The lines of a frame in a capture that began then."""
        from ev3proto.text.tree import command_texts

        route = record.route
        time = f"{elapsed(record.time_ns, start_ns)} " if route.is_timed else ""
        before = f"{time}{packets_text(record.numbers)} {self._common(route)}"
        return command_texts(record.frame, before, self._instructions)

    def _text(self, route: Route) -> str:
        return "".join(text for text, _ in origin(Seen(direction=route.direction, place=place(route))))


class StraightJson(Straight):
    """Writes them as JSON."""

    def texts(self, record: Record, _start_ns: int) -> list[str] | None:
        """The line of a frame in a capture, with the time of day."""
        from ev3proto.text.json_format.from_messages import command_text

        route = record.route
        time = f'"time": "{utc(record.time_ns)}", ' if route.is_timed else ""
        numbers = ", ".join(map(str, record.numbers))
        more = f'{time}"packets": [{numbers}], {self._common(route)}'
        text = command_text(record.frame, route.direction, more, self._instructions)
        return None if text is None else [text]

    def _text(self, route: Route) -> str:
        import json

        return json.dumps(ends(route), ensure_ascii=False)[1:-1]


def place(route: Route) -> str | None:
    """Carrier and brick as headings name them; nobody knows those of a text."""
    return None if route.is_text else f"{route.carrier} {route.peer}"


def ends(route: Route) -> dict[str, Any]:
    """From where to where, for other tools."""
    return {
        "interface": route.interface,
        "carrier": route.carrier,
        "source": route.source,
        "target": route.target,
        "peer": route.peer,
    }
