"""The virtual brick of the page, which lives as long as the page."""

from __future__ import annotations

import json
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from ev3proto.brick import Brick
from ev3proto.brick.running_programs import RUNNING
from ev3proto.brick.servers.page.state import Changes, answer
from ev3proto.brick.servers.page.watcher import Watcher
from ev3proto.schema.header import frame_size

from .notations import MOST_SENT

MOST_STEP = 1.0
"""Maximum seconds that the clock advances per tick while something happens: a page that slept does not catch up."""

STRETCH = 0.02
"""Seconds that a command or program may run before the page gets its turn."""


class VirtualBrick:
    """A brick with one client, the page."""

    number = 1
    name = "playground"

    def __init__(self) -> None:
        """Switches the brick on."""
        self._folder = TemporaryDirectory()
        self._brick = Brick(Path(self._folder.name), stretch=STRETCH)
        self._brick.plug_core_set()
        self._watcher = Watcher(lambda: self._brick.microseconds / 1_000_000)
        self._changes = Changes(self._brick, self._watcher.open(), tuple)
        self.rests = False
        """Whether nothing happens by itself: no command or program runs, nothing moves or sounds."""

    def tick(self, seconds: float) -> str:
        """Advances the brick's clock. Returns what is new on it as JSON; empty if nothing is."""
        for _, reply in self._brick.advance_all(seconds if self.rests else min(seconds, MOST_STEP)):
            self._watcher.frame(self, reply, False)
        new = self._changes.take()
        brick = self._brick
        is_running = any(program is not None and program.status == RUNNING for program in brick.machine.slots)
        self.rests = not (new or is_running or brick.is_busy or brick.is_computing or brick.equipment.sound.playing)
        return json.dumps(new) if new else ""

    def act(self, action: str) -> dict[str, Any] | None:
        """Runs an action, given as JSON. Returns the answer for the page."""
        return answer(self._brick, action)

    def play(self, sent: str) -> str:
        """Takes what `Frames.to_send` returned, as JSON. Returns an error message, or ""."""
        given = json.loads(sent)
        if given["error"]:
            return str(given["error"])
        if given["program"] is not None:
            is_started = self._brick.start(bytes.fromhex(given["program"])) is not None
            return "" if is_started else "The brick refuses the program; see the findings."
        for frame in given["frames"]:
            if said := self.send(bytes.fromhex(frame)):
                return said
        is_all = given["count"] == len(given["frames"])
        return "" if is_all else f"Only the first {MOST_SENT} of {given['count']} commands were sent."

    def stop(self) -> None:
        """Stops the program that it runs."""
        self._brick.stop()

    def send(self, frame: bytes) -> str:
        """Sends a command. Returns an error message, or ""."""
        if len(frame) < frame_size(frame):
            return "The frame is cut off: a brick would wait for the rest."
        self._watcher.frame(self, frame, True)
        for _, reply in self._brick.receive_from(self, frame):
            self._watcher.frame(self, reply, False)
        return ""
