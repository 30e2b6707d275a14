"""`--report`: the findings of `check` for the frames of the clients, each kind once."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from ev3proto.brick.servers import Observer
from ev3proto.brick.servers.host import Connection
from ev3proto.checking import codes
from ev3proto.checking.checking import check
from ev3proto.checking.report import Finding, Report, Severity
from ev3proto.errors import counted
from ev3proto.messages import DirectCommand
from ev3proto.schema.frame import parse
from ev3proto.tables.declaration import Effect
from ev3proto.text.diagnostics import diagnostics
from ev3proto.text.spans import Line, Role

_MOST_OPERATIONS = 8
"""Names of operations that are listed with a kind of finding."""

_MOST_BROKEN = 100
"""Connections that ended inside a frame, or out of step, that are kept."""

_SHOWING = (Effect.SHOWS, Effect.DIALOG)


@dataclass
class _Kind:
    """All findings with one code: the first one, its place, and the number of frames that have one."""

    report: Report
    finding: Finding
    place: dict[str, Any]
    operations: dict[str, None]
    frames: int = 0


class Reporter(Observer):
    """Checks the frames of all clients."""

    def __init__(self, dialect: str = "official", packet: Callable[[], int] | None = None) -> None:
        """Starts without any frame; `packet` returns the number of the recording's last packet."""
        self.frames = 0
        self._dialect = dialect
        self._packet = packet
        self._begin = time.monotonic()
        self._kinds: dict[str, _Kind] = {}
        self._not_shown: list[_Kind] = []
        self._broken: list[tuple[dict[str, Any], str]] = []
        self._waiting: list[tuple[dict[str, Any], str]] = []

    def left(self, connection: Connection, data: bytes, reason: str) -> None:  # noqa: ARG002 - the recording has them
        """Keeps the reason why a client's bytes ended."""
        if len(self._broken) < _MOST_BROKEN:
            self._broken.append((self._place(connection), reason))

    def waiting(self, connection: Connection, reason: str) -> None:
        """Keeps what a command waits for in vain."""
        if len(self._waiting) < _MOST_BROKEN:
            self._waiting.append((self._place(connection), reason))

    def frame(self, connection: Connection, frame: bytes, is_from_host: bool) -> None:
        """Checks a frame of a client. Each kind of finding counts once a frame."""
        if not is_from_host:
            return
        self.frames += 1
        if _shows(frame, self._dialect):
            self._not_shown.clear()
        report = check(frame, dialect=self._dialect, carrier=connection.carrier)
        first: dict[str, Finding] = {}
        for finding in report.findings:
            first.setdefault(finding.code, finding)
        for finding in first.values():
            kind = _Kind(report, finding, self._place(connection), {})
            if finding.code == codes.NOT_SHOWN.code:
                # A later command may show it.
                self._not_shown.append(kind)
            else:
                self._count(kind)

    def _count(self, kind: _Kind) -> None:
        known = self._kinds.setdefault(kind.finding.code, kind)
        known.frames += 1
        if kind.finding.operation is not None and len(known.operations) <= _MOST_OPERATIONS:
            known.operations[kind.finding.operation] = None

    def _place(self, connection: Connection) -> dict[str, Any]:
        """Returns the sender, number and time of a frame: `packet` in the recording, `frame` among the clients'."""
        place: dict[str, Any] = {"client": connection.name, "frame": self.frames}
        if self._packet is not None:
            place["packet"] = self._packet()
        place["seconds"] = round(time.monotonic() - self._begin, 6)
        return place

    # Findings

    @property
    def has_errors(self) -> bool:
        """Whether any frame has an error, or a client sent bytes that are not a frame."""
        return bool(self._broken) or any(kind.finding.severity is Severity.ERROR for kind in self._sorted(True))

    def lines(self, *, errors_only: bool = False) -> Iterator[Line]:
        """Yields the findings for people: each kind with its count and the first frame that has it."""
        many = f"{counted(self.frames, 'frame')} from clients"
        kind_of_finding = "error" if errors_only else "finding"
        kinds = self._sorted(errors_only)
        troubles = [*self._broken, *([] if errors_only else self._waiting)]
        if not kinds and not troubles:
            yield Line([(f"{many}: no {kind_of_finding}s", Role.PLAIN)])
            return
        yield Line([(f"{many}, {counted(len(kinds), f'distinct {kind_of_finding}')}", Role.HEADING)])
        for place, reason in troubles:
            yield Line([(f"{_named(place)}: {reason}", Role.FAULT)])
        for kind in kinds:
            yield Line()
            yield from diagnostics(kind.report, [kind.finding], place=_named(kind.place), dialect=self._dialect)
            others = [name for name in kind.operations if name != kind.finding.operation]
            more = f"; also in {', '.join(others[:_MOST_OPERATIONS])}" if others else ""
            etc = ", ..." if len(others) > _MOST_OPERATIONS else ""
            yield Line([(f"     = {kind.finding.code} in {counted(kind.frames, 'frame')}{more}{etc}", Role.ASIDE)])

    def json_lines(self, *, errors_only: bool = False) -> Iterator[str]:
        """Yields the same for other tools: an object for each kind of finding and each client out of step."""
        for place, reason in self._broken:
            yield json.dumps({**place, "severity": Severity.ERROR, "message": reason}, ensure_ascii=False)
        for place, reason in [] if errors_only else self._waiting:
            yield json.dumps({**place, "severity": Severity.WARNING, "message": reason}, ensure_ascii=False)
        for kind in self._sorted(errors_only):
            entry = {**kind.place, **kind.finding.as_dict(), "frames": kind.frames, "operations": list(kind.operations)}
            yield json.dumps({**entry, "hex": kind.report.frame.hex()}, ensure_ascii=False)

    def _sorted(self, errors_only: bool) -> list[_Kind]:
        """Returns the kinds of findings, errors first, including drawings that are not shown yet."""
        for kind in self._not_shown:
            self._count(kind)
        self._not_shown.clear()
        shown = [kind for kind in self._kinds.values() if not errors_only or kind.finding.severity is Severity.ERROR]
        return sorted(shown, key=lambda kind: list(Severity).index(kind.finding.severity))


def _shows(frame: bytes, dialect: str) -> bool:
    """Returns whether a command shows what was drawn before it."""
    message = parse(frame, strict=False, dialect=dialect)
    if not isinstance(message, DirectCommand):
        return False
    return any(effect in _SHOWING for operation in message.operations for effect in operation.declaration.effects)


def _named(place: dict[str, Any]) -> str:
    """Returns a place such as `127.0.0.1:5555, packet 13, 0.250 s`."""
    number = f"packet {place['packet']}" if "packet" in place else f"frame {place['frame']}"
    return f"{place['client']}, {number}, {place['seconds']:.3f} s"
