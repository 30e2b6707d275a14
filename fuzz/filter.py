"""Filters: each is refused with a column inside it, or selects records without failing."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from ev3proto.capture import Record, read
from ev3proto.capture.filter import FilterError, compile_filter

CAPTURE = Path(__file__).parents[1] / "captures" / "wifi.pcapng"


@cache
def records() -> tuple[Record, ...]:
    """Frames of every kind, with their replies."""
    return tuple(event for event in read(CAPTURE).events() if isinstance(event, Record))


def one_input(data: bytes) -> None:
    """Takes a filter."""
    text = data.decode("utf-8", "replace")
    try:
        chosen = compile_filter(text)
    except FilterError as error:
        assert 1 <= error.column <= len(text) + 1
        return
    for record in records():
        assert chosen(record) in (True, False)
