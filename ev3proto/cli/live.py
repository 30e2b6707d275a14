"""`ev3proto live`: the dialogues between computer and brick, live."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import BinaryIO

import click

from ev3proto.capture.dialogues import dialogues
from ev3proto.capture.record import Announcement, CaptureError, Record, Skipped, TextKind
from ev3proto.checking.report import Severity
from ev3proto.cli.ending import stopped_by_signals
from ev3proto.cli.formats import made
from ev3proto.cli.output import complain, failing_on
from ev3proto.cli.reading import reading_options
from ev3proto.cli.show import Dialogues
from ev3proto.pyshark.tshark import Run, Tshark
from ev3proto.reading.given import Given
from ev3proto.reading.items import Event, Problem, ProblemCode
from ev3proto.reading.options import Options, Sources
from ev3proto.reading.parts import Reading

PATIENCE_NS = 2_000_000_000
"""Time without a reply after which a command is shown as unanswered, at the next event."""

MOST_BEACONS = 256
"""Maximum number of different beacons that are shown, each once; a brick repeats its own every few seconds."""


@click.command()
@click.option(
    "-i",
    "--interface",
    "interfaces",
    multiple=True,
    required=True,
    metavar="NAME",
    help="Interface to capture on, such as wlan0 or usbmon1; can be repeated. `tshark -D` lists them.",
)
@reading_options
@click.option(
    "--json", "as_json", is_flag=True, help="Print one JSON object a line: a command with its reply, or a text."
)
def live(interfaces: tuple[str, ...], reading: Options, as_json: bool) -> None:
    """Shows dialogues live, one a line, with values and latency.

    tshark captures, so it must be installed and have permission to capture. A command is shown when its reply arrives,
    or as "no reply" after two seconds. --filter applies to a command together with its reply.

    \b
      ev3proto live -i wlan0
      ev3proto live -i usbmon1 --filter 'op like "SOUND.*" || error'
      ev3proto live -i lo --port 5556 --json
    """  # noqa: D301 - the mark by which click leaves lines as they are
    names = tuple(dict.fromkeys(interfaces))
    words = [word for name in names for word in ("-i", name)]
    with (
        failing_on(CaptureError),
        Run(Tshark(reading.tshark), *words, "-w", "-") as run,
        stopped_by_signals(run.stop),
    ):
        _watch(run, reading, f"Capturing on {', '.join(names)}. Ctrl-C ends it.", as_json=as_json)


def _watch(run: Run, options: Options, started: str, *, as_json: bool) -> None:
    """Shows what tshark captures until it ends. Raises CaptureError if it ends by itself."""

    def opened() -> BinaryIO:
        # The output starts with the first captured packet.
        if run.output.peek(1):
            complain(started)
        return run.output

    captured = Reading(
        [Given("", open=opened, is_lent=True)], replace(options, filter=None, sources=Sources.NO, images=False)
    )
    try:
        _Watching(options, as_json=as_json).show(captured.events())
    except CaptureError:
        run.check()
        if not run.is_stopped:
            raise
    run.check()


for _option in live.params:
    if isinstance(_option, click.Option) and _option.name == "engine":
        _option.hidden = True  # only tshark captures


class _Watching:
    def __init__(self, reading: Options, *, as_json: bool) -> None:
        self._chosen = reading.filter
        self._as_json = as_json
        self._show = made("json" if as_json else None, at_once=True)
        self._dialogues = Dialogues(self._show)
        self._start_ns: int | None = None
        self._beacons: set[bytes] = set()

    def show(self, events: Iterable[Event]) -> None:
        """Shows all events."""
        for pair in dialogues(self._beside(events), PATIENCE_NS):
            if self._chosen is None or self._chosen.of_dialogue(pair):
                self._dialogues.show(pair, self._start_ns or 0)

    def _beside(self, events: Iterable[Event]) -> Iterator[Record | Skipped | Announcement]:
        """Yields the events, and shows those outside dialogues. Raises CaptureError for what ends the capture."""
        for event in events:
            if isinstance(event, Problem):
                if event.severity is Severity.ERROR and event.code is not ProblemCode.SKIPPED:
                    raise CaptureError(event.message)
                complain(str(event))
            elif isinstance(event, Record | Skipped | Announcement):
                if self._start_ns is None:
                    self._start_ns = event.time_ns
                if isinstance(event, Announcement) and self._is_shown(event):
                    self._show.announcement(event, self._start_ns)
                yield event

    def _is_shown(self, announcement: Announcement) -> bool:
        """Whether to show a text: without a filter each one, but equal beacons only once for people."""
        if self._chosen is not None:
            return False
        if self._as_json or announcement.said is not TextKind.BEACON:
            return True
        is_new = announcement.data not in self._beacons
        if len(self._beacons) < MOST_BEACONS:
            self._beacons.add(announcement.data)
        return is_new
