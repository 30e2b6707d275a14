"""Deliberate faults, for testing clients: replies that are late, lost, or have a changed byte."""

from __future__ import annotations

from dataclasses import dataclass, field
from random import Random

from ev3proto.tables.frame import LENGTH_FIELD


@dataclass
class Faults:
    """The faults of replies."""

    delay: float = 0.0  # seconds by which each reply is delayed
    drop: float = 0.0  # share of them that are lost, 0 to 1
    corrupt: float = 0.0  # share of them in which one byte after the length field is changed, 0 to 1
    random: Random = field(default_factory=Random)  # the random numbers; a seed makes them repeatable

    def apply_to(self, reply: bytes) -> bytes | None:
        """Returns the bytes to send for a reply; None if it is lost."""
        if self.drop and self.random.random() < self.drop:
            return None
        if self.corrupt and self.random.random() < self.corrupt:
            changed = bytearray(reply)
            # The length stays right, so that later replies can still be read.
            changed[self.random.randrange(LENGTH_FIELD, len(reply))] ^= self.random.randint(1, 0xFF)
            return bytes(changed)
        return reply
