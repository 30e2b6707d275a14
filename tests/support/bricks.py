"""Direct commands for the virtual brick, made from operations, and the parts of its answers."""

from __future__ import annotations

import struct
from typing import Any

from ev3proto.brick import Brick
from ev3proto.schema.instructions import operation

OK, FAIL = 0x02, 0x04


def op(name: str, *values: Any) -> bytes:
    """Returns the byte code of an operation."""
    return operation(name, *values).raw


def command(*code: bytes, globals: int = 0, locals: int = 0, reply: bool = True, counter: int = 1) -> bytes:
    """Returns the frame of a direct command."""
    body = struct.pack("<HBH", counter, 0 if reply else 0x80, globals | locals << 10) + b"".join(code)
    return struct.pack("<H", len(body)) + body


def run(brick: Brick, *code: bytes, globals: int = 0, locals: int = 0) -> tuple[int, bytes]:
    """Executes operations that end at once; returns the reply's type and global memory."""
    replies = brick.receive(command(*code, globals=globals, locals=locals))
    assert len(replies) == 1, "the command is busy"
    return taken_apart(replies[0])


def taken_apart(reply: bytes) -> tuple[int, bytes]:
    """Returns type and global memory of a reply."""
    assert int.from_bytes(reply[:2], "little") == len(reply) - 2
    return reply[4], reply[5:]


def memory(brick: Brick, *code: bytes, globals: int) -> bytes:
    """Returns the global memory after operations that succeed; it was zero before."""
    brick.receive(command(op("INIT_BYTES", *_zeros(globals)), globals=globals, reply=False))
    kind, found = run(brick, *code, globals=globals)
    assert kind == OK, "the command failed"
    return found


def _zeros(count: int) -> tuple[Any, ...]:
    from ev3proto.messages import GV

    return GV(0), count, [0] * count
