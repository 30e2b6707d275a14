"""What a frame says in words: its sentence, the fields of its header, each of its bytes."""

from __future__ import annotations

import json

from ev3proto.dialogue import Exchange
from ev3proto.schema.frame import parse
from ev3proto.text.byte_by_byte import byte_lines, header_parts
from ev3proto.text.sentence import sentence
from ev3proto.text.spans import visible


def about(frame: str) -> str:
    """Returns what a frame says.

    Args:
        frame: The frame, in hex.

    Returns:
        JSON: `sentence`, `parts` (each with name, offset, length, text) and `bytes`, a line each.
    """
    message = parse(bytes.fromhex(frame), strict=False)
    return json.dumps(
        {
            "sentence": visible(sentence(Exchange(message))),
            "parts": [part._asdict() for part in header_parts(message)],
            "bytes": [visible(line) for line in byte_lines(message)],
        }
    )
