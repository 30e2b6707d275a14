"""What clients sent in the captures of the repository."""

from __future__ import annotations

from collections.abc import Iterator

import ev3proto
from ev3proto.capture.record import Direction
from ev3proto.messages import Message
from support.cli import ROOT


def sent_in(name: str) -> Iterator[Message]:
    """Yields the messages that clients sent in a capture, or in both directions where it does not tell them apart."""
    for record in ev3proto.read(ROOT / "captures" / name):
        if isinstance(record, ev3proto.Record) and record.direction is not Direction.RECEIVED:
            yield record.message
