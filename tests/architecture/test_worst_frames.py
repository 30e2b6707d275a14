"""The cost of the worst frames: no frame of at most 1,024 bytes keeps any face busy for long."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

from support.cpu_time import milliseconds

import ev3proto
from ev3proto.checking.checking import check
from ev3proto.checking.fixing import fix
from ev3proto.checking.nearest import nearest
from ev3proto.dialogue import Exchange
from ev3proto.schema.frame import read_last
from ev3proto.text.assembly import assembly
from ev3proto.text.csv_rows import rows
from ev3proto.text.diagnostics import diagnostics, fixed
from ev3proto.text.json_format.from_messages import record
from ev3proto.text.phrases import NOTATIONS, Seen
from ev3proto.text.spans import plain_text
from ev3proto.text.table import table
from ev3proto.text.tree import tree

BODY = 1017
MOST_SHOWING = 16
"""Maximum milliseconds of a face. Almost all take less than five.

Limits are twice what the worst frame takes: what grows faster than a frame takes far longer, and machines differ.
"""

MOST = {"check": 36, "nearest": 300, "fix": 540}
"""The same for a check, for what was meant by a frame, and for a fix, which looks for that again after each change."""

TESTS = Path(__file__).parents[1]


def _command(body: bytes, *, kind: int = 0, memory: int = 0) -> bytes:
    return (5 + len(body)).to_bytes(2, "little") + bytes((1, 0, kind, *memory.to_bytes(2, "little"))) + body


def _frame(*operations: str, kind: int = 0, memory: int = 0) -> bytes:
    """A frame filled with the same operations again and again."""
    unit = bytes.fromhex("".join(operations))
    return _command(unit * (BODY // len(unit)), kind=kind, memory=memory)


def _global(index: int) -> bytes:
    return bytes((0xE1, index)) if index < 256 else bytes((0xE2, *index.to_bytes(2, "little")))


def _one_gap() -> bytes:
    """All of global memory is full of misaligned numbers."""
    indexes = (1, *range(1, 1010, 4))
    return bytes.fromhex("306060") + b"".join(
        b"\x3a" + _global(one) + _global(other) for one, other in zip(indexes[::2], indexes[1::2], strict=True)
    )


FRAMES = {
    "operations of one byte": _frame("01"),
    "errors": _frame("00"),
    "jumps to the next operation": _frame("4000"),
    "jumps into others": _frame("4005"),
    "jumps by a variable": _frame("77010101"),
    "jumps to labels": _frame("8201", "40A001"),
    "one string": _frame("D184" + "78" * 1014 + "00"),
    "results on results": _frame("3A0160", memory=4),
    "misaligned variables beyond memory": _frame("3AE10141", "E103"),
    "handles": _frame("30D1016A"),
    "numbers that make room for one another": _command(_one_gap()),
    "results that are all read at the end": _command(bytes.fromhex("307F60" * 338 + "306041"), kind=0x80, memory=32),
    "values out of range": _frame("940181C882C8008301000000", kind=0x80),
    "long encodings": _frame("94830100000083010000008301000000"),
    "moves that end one another": _frame("A6000F"),
    "pictures": _frame("8400"),
    "a thousand values": bytes.fromhex("FE030100" + "00FF03" + "991C00000000" + "817F") + b"\x60" * 1009,
    "lists of results": _frame(
        "99821C0000000000", "8164", "61636567696B6D6F71737577797B7D7F" * 6 + "61636567", memory=4
    ),
    "unknown opcodes": _frame("FF"),
    "unknown CMDs": _frame("943F"),
    "letters that are shown as escapes": _frame("D184" + "07" * 1014 + "00"),
    "zeros": bytes(1024),
    "a system command": bytes.fromhex("FC030100" + "0192" + "00000000") + b"x" * 1012,
}

FACES: dict[str, Callable[[bytes], object]] = {
    "tree": lambda frame: list(map(plain_text, tree(_exchange(frame), Seen()))),
    "JSON": lambda frame: json.dumps(record(_exchange(frame), Seen())),
    "table": lambda frame: list(table(_exchange(frame), Seen())),
    "csv": lambda frame: list(rows(_exchange(frame))),
    "assembly": lambda frame: [list(assembly(_exchange(frame), "", notation)) for notation in NOTATIONS],
    "check": lambda frame: list(diagnostics(check(_new(frame)), nearest=())),
    "nearest": lambda frame: check(_new(frame), alone=True).nearest,
    "fix": lambda frame: list(fixed(fix(_new(frame)))),
}


def _new(frame: bytes) -> bytes:
    """The frame, after recent ones were evicted from the caches, so that a second check is not faster."""
    read_last.cache_clear()
    nearest.cache_clear()
    return frame


def _exchange(frame: bytes) -> Exchange:
    return Exchange(ev3proto.parse(frame, strict=False))


def test_no_face_takes_long() -> None:
    """In another process: after thousands of tests, the same work takes up to twice as long."""
    command = [sys.executable, __file__]
    paths = os.pathsep.join((str(TESTS), str(TESTS.parent)))
    done = subprocess.run(command, capture_output=True, text=True, check=True, env=os.environ | {"PYTHONPATH": paths})
    assert done.stdout == ""


def _measure() -> None:
    """Prints the slow faces."""
    for name, frame in FRAMES.items():
        assert len(frame) <= 1024
        for face, show in FACES.items():
            most = MOST.get(face, MOST_SHOWING)
            taken = milliseconds(partial(show, frame), most)
            if taken > most:
                print(f"{name}: {face} takes {taken:.0f} ms, not at most {most}")


if __name__ == "__main__":
    _measure()
