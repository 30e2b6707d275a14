"""Captures: each is read to its end or refused with a message, and every byte of it is accounted for."""

from __future__ import annotations

import io

from ev3proto.capture import Account, Announcement, CaptureError, Event, Record, read
from ev3proto.capture.dialogues import dialogues
from ev3proto.capture.files import survey
from ev3proto.capture.record import utc

_MEMORY = 1 << 20


def one_input(data: bytes) -> list[Event]:
    """Takes a capture file, compressed or not. Returns everything in it."""
    account, events = Account(), list[Event]()
    try:
        capture = read(io.BytesIO(data), memory=_MEMORY)
        account = capture.account
        for event in capture.events():
            events.append(event)
    except CaptureError as error:
        assert str(error).isprintable()
    records = [event for event in events if isinstance(event, Record)]
    announcements = [event for event in events if isinstance(event, Announcement)]
    skipped = [event for event in events if not isinstance(event, Record | Announcement)]
    assert account.balance == 0
    assert all(count >= 0 for count in account.parts.values())
    assert account.frames == sum(len(record.frame) for record in records)
    assert account.texts >= sum(len(announcement.data) for announcement in announcements)
    assert account.skipped == sum(len(gap.data) for gap in skipped)
    for record in records:
        assert record.message.build() == record.frame
        assert isinstance(record.values, list)
        assert repr(record)
        assert record.latency is None or record.request is not None
        assert record.number == max(record.numbers) >= min(record.numbers) >= 1
        assert record.peer in (record.source, record.target)
    assert all(utc(event.time_ns) for event in events)
    assert all(each.data and isinstance(each.facts, dict) for each in announcements)
    assert all(str(gap) and (gap.data or gap.missing or "elsewhere" in gap.reason) for gap in skipped)
    assert len(list(dialogues(events))) <= len(events)
    list(survey(events, listings=True))
    return events
