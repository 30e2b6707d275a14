"""Captures: each is read to its end or refused with a message, and every byte of it is accounted for."""

from __future__ import annotations

import io

from ev3proto.capture import Account, CaptureError, Record, read
from ev3proto.capture.dialogues import dialogues
from ev3proto.capture.files import survey

_MEMORY = 1 << 20


def one_input(data: bytes) -> None:
    """Takes a capture file, compressed or not."""
    account = Account()
    events = []
    try:
        capture = read(io.BytesIO(data), memory=_MEMORY)
        account = capture.account
        for event in capture.events():
            events.append(event)
    except CaptureError as error:
        assert str(error).isprintable()
    assert account.balance == 0
    for event in events:
        if isinstance(event, Record):
            assert event.message.build() == event.frame
    list(dialogues(events))
    list(survey(events, listings=True))
