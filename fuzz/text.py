"""Pasted texts: logs, hex, arrays of C, JSON. Every byte that is read from any text was in it."""

from __future__ import annotations

from ev3proto.text.json_format.to_messages import RecordError, frames_of_json, read_records
from ev3proto.text.paste import read_argument, read_bare, read_text
from ev3proto.text.splitting import split


def one_input(data: bytes) -> None:
    """Takes a text, as a file, as an argument and as JSON."""
    text = data.decode("utf-8", "replace")
    lines = text.splitlines(keepends=True)
    found = [*read_text(lines), *read_bare(lines, "length"), *read_bare(lines, "header"), read_argument(text)]
    for pasted in found:
        assert pasted.problem is None or pasted.problem
        assert b"".join(piece.message.build() for piece in split(pasted.data)) in pasted.data
    try:
        for _, entry in read_records(lines):
            for frame in frames_of_json(entry):
                assert frame
    except RecordError as error:
        assert str(error)
