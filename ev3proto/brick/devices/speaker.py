"""The speaker: what it is playing, and until when. Only the page makes the sound audible."""

from __future__ import annotations

from dataclasses import dataclass

from ev3proto.brick.parts import Part
from ev3proto.brick.running_programs import USER_SLOT, Program

LOWEST, HIGHEST = 250, 10_000
"""Hertz that the driver can play; others are clamped."""

_STEPS, _STEP = 13, 8
_SHORTEST = 10_000
"""Microseconds until the driver reports the end of an empty file."""

_HEADER = 8
_COMPRESSED = 0x0101
_MICROSECONDS = 1_000_000


@dataclass(frozen=True)
class Playing:
    """A tone or file that is being played."""

    volume: int  # percent, in steps of 8
    frequency: int  # of a tone, in hertz; 0 for a file
    file: bytes  # of a sound file, its contents; empty for a tone
    began: int  # when, in microseconds of the brick's clock
    ends: int | None  # when; None: never


class Sound(Part):
    """A silent loudspeaker."""

    def __init__(self) -> None:
        self.playing: Playing | None = None

    def tone(self, volume: int, frequency: int, duration: int, now: int) -> None:
        """Plays a tone: volume in percent, hertz, milliseconds (0: without end), the clock in microseconds."""
        frequency = max(LOWEST, min(frequency, HIGHEST))
        self.playing = Playing(_loudness(volume), frequency, b"", now, now + duration * 1000 if duration else None)

    def play(self, volume: int, file: bytes, is_repeated: bool, now: int) -> None:
        """Plays a sound file at a volume in percent; an empty file is silent and counts as sounding for a moment."""
        ends = None if is_repeated else now + max(_length(file), _SHORTEST)
        self.playing = Playing(_loudness(volume), 0, file, now, ends)

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


def _loudness(volume: int) -> int:
    """Returns a volume as the driver plays it."""
    return max(0, min(volume // _STEP, _STEPS)) * _STEP


def _length(file: bytes) -> int:
    """Returns how long a sound file plays, in microseconds: its header has kind, bytes and samples a second."""
    kind, size, rate = (int.from_bytes(file[at : at + 2], "big") for at in (0, 2, 4))
    size = min(size, len(file) - _HEADER)
    samples = size * 2 if kind == _COMPRESSED else size
    return samples * _MICROSECONDS // rate if rate and samples > 0 else 0
