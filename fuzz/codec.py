"""Frames: whatever the bytes are, they are read, come back as they were, and can be shown, checked and fixed."""

from __future__ import annotations

import json

import ev3proto
from ev3proto.checking.checking import check
from ev3proto.checking.fixing import fix
from ev3proto.dialogue import Exchange
from ev3proto.stream import StreamError
from ev3proto.tables.declaration import DIALECTS
from ev3proto.text.heading import Seen
from ev3proto.text.json_format.writing import record
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
    check(data)
    fix(data)
    _stream(data)


def _stream(data: bytes) -> None:
    """The bytes in chunks: every frame of them is there, up to where no frame can start."""
    decoder = ev3proto.Decoder(strict=False)
    found = b""
    try:
        for at in range(0, len(data), _MOST_CHUNK):
            for message in decoder.feed(data[at : at + _MOST_CHUNK]):
                found += message.build()
    except StreamError:
        assert data.startswith(found)
    else:
        assert found + decoder.pending == data
