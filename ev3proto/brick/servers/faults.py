"""Faults on purpose, for those who test a client: replies that come late, not at all, or with a byte changed."""

from __future__ import annotations

from dataclasses import dataclass, field
from random import Random

from ev3proto.tables.frame import LENGTH_FIELD


@dataclass
class Faults:
    """What happens to replies.

    delay    seconds by which each is held back
    drop     share of them that are lost, 0 to 1
    corrupt  share of them in which one byte after the length field is changed, 0 to 1
    random   where chance comes from; a seed makes it the same every time
    """

    delay: float = 0.0
    drop: float = 0.0
    corrupt: float = 0.0
    random: Random = field(default_factory=Random)

    def befall(self, reply: bytes) -> bytes | None:
        """What is sent instead of a reply; None where it is lost."""
        if self.drop and self.random.random() < self.drop:
            return None
        if self.corrupt and self.random.random() < self.corrupt:
            changed = bytearray(reply)
            # The length stays right: what follows the reply can still be read.
            changed[self.random.randrange(LENGTH_FIELD, len(reply))] ^= self.random.randint(1, 0xFF)
            return bytes(changed)
        return reply
