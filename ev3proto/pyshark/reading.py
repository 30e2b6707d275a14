"""The second engine: tshark takes the packets apart, with the dissector, for every link type that Wireshark knows.

It knows more formats and links than the built-in engine, and is the test that this one stands: what has to do with
carriers (reassembly, addresses, where a frame starts) is done by others here. Frames are read, and replies paired with
commands, by the same code.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Collection, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import BinaryIO

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.capture.byte_account import Account
from ev3proto.capture.formats import CaptureFile
from ev3proto.capture.reading import Capture
from ev3proto.capture.record import CaptureError, Event
from ev3proto.capture.wireshark.events import Events
from ev3proto.pyshark.process import Process
from ev3proto.pyshark.program import Program
from ev3proto.tables import check_dialect
from ev3proto.tables.discovery import TCP_PORT
from ev3proto.temporary import temporary_folder


def read(
    source: str | os.PathLike[str] | BinaryIO | CaptureFile,
    *,
    dialect: str = "official",
    ports: Collection[int] = (TCP_PORT,),
    tshark: str | None = None,
    memory: int = DEFAULT_MEMORY,
) -> Capture:
    """A capture file's records, like `ev3proto.capture.read`, for every format and link type that Wireshark knows.

    Args:
        source: A path, a stream at its start, or a CaptureFile. A stream is copied into a temporary file for tshark.
        dialect: The firmware whose instruction set to read by.
        ports: TCP ports on which bricks listen.
        tshark: Path of the tshark, where it is not on the path.
        memory: Bytes that commands without a reply may take together.

    Returns:
        The capture. While it is read it raises CaptureError, after everything readable, with what tshark says.
        Wireshark does not say which bytes are whose headers: `account` counts those, and bytes that came twice, as
        `other`.

    Raises:
        OSError: The file cannot be opened.
        CaptureError: There is no tshark that can be used.
        ValueError: The dialect is not known.

    """
    account = Account()
    with ExitStack() as stack:
        making = Events(account, check_dialect(dialect), ports, memory)
        path = _file(source, stack)
        program = Program(tshark)
        words = stack.enter_context(program.words(dialect, ports))
        return Capture(_events(path, program, words, making, stack.pop_all()), account)


def _events(path: Path, program: Program, words: list[str], making: Events, stack: ExitStack) -> Iterator[Event]:
    with stack:
        run = Process(program, [*words, "-r", str(path)])
        for rows in run.batches():
            for row in rows:
                yield from making.events(row)
        yield from making.end()
        trouble = run.trouble()
        if trouble is not None:
            raise CaptureError(trouble)


def _file(source: str | os.PathLike[str] | BinaryIO | CaptureFile, stack: ExitStack) -> Path:
    """A file that tshark can read: the one that was named, or a copy of a stream, which goes away again."""
    if isinstance(source, CaptureFile):
        stack.callback(source.close)
        source = source.contents
    if isinstance(source, str | os.PathLike):
        path = Path(source)
        with path.open("rb"):
            return path.absolute()
    copy = stack.enter_context(temporary_folder()) / "capture"
    with copy.open("wb") as stream:
        shutil.copyfileobj(source, stream)
    return copy
