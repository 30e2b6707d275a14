"""The speaker: what it is playing, and until when. Only the page makes the sound audible."""

from __future__ import annotations

from bisect import bisect
from dataclasses import dataclass

from ev3proto.brick.devices import Part
from ev3proto.brick.running_programs import USER_SLOT, Program

LOWEST, HIGHEST = 250, 10_000
"""Hertz that the driver can play; others are clamped."""

_TONE_LEVELS, _TONE_STEP = 13, 8
"""Levels of a tone, and the percent of each."""

_FILE_LEVELS = (1, 14, 26, 39, 51, 64, 76, 89)
"""Percent from which a file has the next of its levels."""

_FILE_STEP = 12
"""Percent of each level of a file."""

_HEADER = 8
_COMPRESSED = 0x0101
_SAMPLE = 125
"""Microseconds of a sample of a file. The driver reads the rate in its header, and ignores it."""

_UNSIGNED = 0xFFFF


@dataclass(frozen=True)
class Playing:
    """A tone or file that is being played."""

    volume: int  # percent as the driver plays it: a tone in steps of 8, a file in steps of 12
    frequency: int  # of a tone, in hertz; 0 for a file
    file: bytes  # of a sound file, its contents; empty for a tone, and for a file that does not exist
    began: int  # when, in microseconds of the brick's clock
    ends: int | None  # when; None: not by itself

    @property
    def kind(self) -> str:
        """What it is, in words."""
        if self.frequency:
            return "a tone without end"
        return "a repeated sound file" if _length(self.file) else "a sound file that is missing or empty"


class Sound(Part):
    """A silent loudspeaker."""

    def __init__(self) -> None:
        self.playing: Playing | None = None

    def tone(self, volume: int, frequency: int, duration: int, now: int) -> None:
        """Plays a tone, by percent, hertz and milliseconds, 0: without end; a negative volume is the loudest."""
        level = _TONE_LEVELS if volume < 0 else min(-(-volume // _TONE_STEP), _TONE_LEVELS)
        frequency = max(LOWEST, min(frequency & _UNSIGNED, HIGHEST))
        duration = (duration & _UNSIGNED) * 1000
        self.playing = Playing(level * _TONE_STEP, frequency, b"", now, now + duration if duration else None)

    def play(self, volume: int, file: bytes, is_repeated: bool, now: int) -> None:
        """Plays the contents of a sound file; as in the driver, one without data, or that is missing, does not end."""
        level = len(_FILE_LEVELS) if volume < 0 else bisect(_FILE_LEVELS, volume)
        length = _length(file)
        ends = now + length if length and not is_repeated else None
        self.playing = Playing(level * _FILE_STEP, 0, file, now, ends)

    def stop(self) -> None:
        """Stops what is playing."""
        self.playing = None

    def advance(self, microseconds: int) -> None:
        """Stops what has ended by a time."""
        if self.playing is not None and self.playing.ends is not None and microseconds >= self.playing.ends:
            self.playing = None

    def program_ended(self, program: Program) -> None:
        """Stops the sound of a user program that has ended."""
        if program.slot == USER_SLOT:
            self.stop()


def _length(file: bytes) -> int:
    """Returns how long a sound file plays, in microseconds: its header has format and bytes of data."""
    kind, size = (int.from_bytes(file[at : at + 2], "big") for at in (0, 2))
    size = max(0, min(size, len(file) - _HEADER))
    return size * _SAMPLE * (2 if kind == _COMPRESSED else 1)
