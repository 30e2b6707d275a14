"""Frames: any bytes are read, build to the same bytes, and can be shown, checked and fixed."""

from __future__ import annotations

import json
from contextlib import suppress

import ev3proto
from ev3proto.checking.checking import check
from ev3proto.checking.fixing import fix
from ev3proto.dialogue import Exchange
from ev3proto.stream import StreamError
from ev3proto.tables.declaration import DIALECTS
from ev3proto.text.json_format.from_messages import record
from ev3proto.text.phrases import Seen
from ev3proto.text.table import table
from ev3proto.text.tree import tree

_MOST_CHUNK = 7


def one_input(data: bytes) -> None:
    """Takes a frame, or a stream of frames in chunks."""
    for dialect in DIALECTS:
        message = ev3proto.parse(data, strict=False, dialect=dialect)
        assert message.build() == data
    message = ev3proto.parse(data, strict=False)
    exchange = Exchange(message)
    json.dumps(record(exchange, Seen()))
    assert list(tree(exchange, Seen()))
    assert list(table(exchange, Seen()))
    _fixed(data)
    _stream(data)


def _fixed(data: bytes) -> None:
    """A fix improves a frame or does nothing; a second one changes nothing."""
    before, fixed = check(data), fix(data)
    after = fixed.report
    if fixed.frame != data:
        assert after.accepted
        assert len(after.findings) < len(before.findings)
        assert len(after.errors) <= len(before.errors)
    again = fix(fixed.frame)
    assert (again.frame, again.changes) == (fixed.frame, ())


def _stream(data: bytes) -> None:
    """The bytes in chunks: every frame is found, and only zeros are skipped, up to where no frame can start."""
    decoder = ev3proto.Decoder(strict=False)
    at = 0
    with suppress(StreamError):
        for start in range(0, len(data), _MOST_CHUNK):
            for message in decoder.feed(data[start : start + _MOST_CHUNK]):
                frame = message.build()
                begin = decoder.position - len(frame)
                assert not any(data[at:begin])
                assert data[begin : decoder.position] == frame
                at = decoder.position
    assert not any(data[at : decoder.position])
    assert data[decoder.position :].startswith(decoder.pending)
