"""Captures in memory, read whole."""

from __future__ import annotations

import io
from typing import Any

from ev3proto.capture import Capture, Event, Record, read


def opened(data: bytes, **options: Any) -> tuple[list[Event], Capture]:
    """Returns all events of a capture; checks that every byte is accounted for."""
    capture = read(io.BytesIO(data), **options)
    events = list(capture.events())
    assert capture.account.balance == 0
    return events, capture


def records(data: bytes, **options: Any) -> list[Record]:
    return [event for event in opened(data, **options)[0] if isinstance(event, Record)]
