"""`--report`: what `check` has to say about the frames of the clients, each finding once."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Iterator
from dataclasses import dataclass

from ev3proto.brick.servers.host import Connection
from ev3proto.checking.checking import check
from ev3proto.checking.report import Finding, Report, Severity
from ev3proto.errors import counted
from ev3proto.schema.header import HEADER
from ev3proto.text.diagnostics import diagnostics
from ev3proto.text.spans import Line, Role

_MOST_KINDS = 200
"""Different findings that are kept."""

_MOST_KNOWN = 4096
"""Different frames of which the findings are remembered."""

_COUNTER = slice(HEADER.length.sizeof(), HEADER.length.sizeof() + HEADER.counter.sizeof())

Kind = tuple[str, str | None, str | None]
"""A finding's code, operation and parameter."""


@dataclass
class _Found:
    """A kind of finding: the first frame that has it, who sent that, and in how many frames it is."""

    report: Report
    finding: Finding
    sender: str
    frames: int = 0


class Reporter:
    """Checks the frames of all clients."""

    def __init__(self, dialect: str = "official") -> None:
        """Starts without any frame. ValueError for an unknown dialect."""
        self.frames = 0
        self._dialect = dialect
        self._found: dict[Kind, _Found] = {}
        self._known: OrderedDict[bytes, tuple[Kind, ...]] = OrderedDict()
        self._left_out = 0

    def opened(self, connection: Connection) -> None:
        """Nothing to check."""

    def closed(self, connection: Connection) -> None:
        """Nothing to check."""

    def frame(self, connection: Connection, frame: bytes, is_from_host: bool) -> None:
        """Checks a frame of a client, unless one like it was checked before."""
        if not is_from_host:
            return
        self.frames += 1
        # All that a client counts up is the message counter.
        alike = frame[: _COUNTER.start] + frame[_COUNTER.stop :]
        kinds = self._known.get(alike)
        if kinds is None:
            kinds = self._check(connection, frame)
            self._known[alike] = kinds
            if len(self._known) > _MOST_KNOWN:
                self._known.popitem(last=False)
        for kind in kinds:
            self._found[kind].frames += 1

    def _check(self, connection: Connection, frame: bytes) -> tuple[Kind, ...]:
        report = check(frame, dialect=self._dialect, carrier=connection.carrier)
        kinds: dict[Kind, Finding] = {}
        for finding in report.findings:
            kinds.setdefault((finding.code, finding.operation, finding.parameter), finding)
        for kind, finding in list(kinds.items()):
            if kind in self._found:
                continue
            if len(self._found) < _MOST_KINDS:
                self._found[kind] = _Found(report, finding, connection.name)
            else:
                self._left_out += 1
                del kinds[kind]
        return tuple(kinds)

    def lines(self) -> Iterator[Line]:
        """What was found, for people: each kind of finding with the first frame that has it."""
        many = f"{counted(self.frames, 'frame')} from clients"
        if not self._found:
            yield [(f"{many}: no findings", Role.PLAIN)]
            return
        yield [(f"{many}, {len(self._found)} different findings", Role.HEADING)]
        for found in sorted(self._found.values(), key=lambda found: list(Severity).index(found.finding.severity)):
            yield []
            place = f"{found.sender}, in {counted(found.frames, 'frame')}"
            yield from diagnostics(found.report, [found.finding], place=place, dialect=self._dialect)
        if self._left_out:
            yield []
            yield [(f"and {self._left_out} more findings of other kinds", Role.ASIDE)]
