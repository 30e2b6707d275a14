"""A file cut into the commands that bring it to the brick."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain

from ev3proto.errors import BuildError
from ev3proto.messages import SystemCommand
from ev3proto.schema.constructors import system_command
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.frame import COUNTERS, MAX_FRAME

PIECE = MAX_FRAME - HEADER_SIZE - 2
"""Most bytes of a file that one CONTINUE_DOWNLOAD carries: a frame less its header, the command and the handle."""

_BEGIN, _CONTINUE = "BEGIN_DOWNLOAD", "CONTINUE_DOWNLOAD"


def download(
    path: str, data: bytes, *, handle: int = 0, counter: int = 0, reply: bool = True, piece: int = PIECE
) -> Iterator[SystemCommand]:
    """The commands that write a file to the brick: BEGIN_DOWNLOAD, then a CONTINUE_DOWNLOAD for each piece of it.

    The brick's reply to the first has the handle. A brick without open files gives 0. Where it gives another, send
    what `pieces` makes with that one.

    Args:
        path: Where the file goes, absolute or relative to /home/root/lms2012/sys.
        data: Its contents.
        handle: What the brick is expected to give, 0 to 255.
        counter: Of the first message, 0 to 65535; the others count up from it.
        reply: Whether the brick should answer each.
        piece: Bytes of the file in one command, 1 to 1017.

    Returns:
        The commands, in order.

    Raises:
        BuildError: A command cannot be built; raised at once.
    """
    if not isinstance(data, bytes):
        raise BuildError(f"data takes bytes, not {data!r:.60}")
    begin = system_command(_BEGIN, counter=counter, reply=reply, size=len(data), path=path)
    rest = pieces(handle, data, counter=(counter + 1) % COUNTERS, reply=reply, piece=piece)
    return chain((begin,), rest)


def pieces(
    handle: int, data: bytes, *, counter: int = 0, reply: bool = True, piece: int = PIECE
) -> Iterator[SystemCommand]:
    """The CONTINUE_DOWNLOAD commands for a file's contents, once the brick has given its handle.

    Args:
        handle: As the brick's reply to BEGIN_DOWNLOAD gave it, 0 to 255.
        data: The contents.
        counter: Of the first message, 0 to 65535; the others count up from it.
        reply: Whether the brick should answer each.
        piece: Bytes of the file in one command, 1 to 1017.

    Returns:
        The commands, in order.

    Raises:
        BuildError: A command cannot be built; raised at once.
    """
    if not isinstance(data, bytes):
        raise BuildError(f"data takes bytes, not {data!r:.60}")
    if isinstance(piece, bool) or not isinstance(piece, int) or not 1 <= piece <= PIECE:
        raise BuildError(f"piece cannot be {piece!r}: one {_CONTINUE} carries 1 to {PIECE} bytes")
    system_command(_CONTINUE, counter=counter, reply=reply, handle=handle, data=b"")
    return _pieces(handle, data, counter, reply, piece)


def _pieces(handle: int, data: bytes, counter: int, reply: bool, piece: int) -> Iterator[SystemCommand]:
    for number, start in enumerate(range(0, len(data), piece)):
        yield system_command(
            _CONTINUE,
            counter=(counter + number) % COUNTERS,
            reply=reply,
            handle=handle,
            data=data[start : start + piece],
        )
