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
from typing import TYPE_CHECKING, BinaryIO

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.capture.record import CaptureError
from ev3proto.capture.wireshark.events import Events
from ev3proto.capture.wireshark.process import Process
from ev3proto.capture.wireshark.program import EngineError, Program
from ev3proto.temporary import temporary_folder

if TYPE_CHECKING:
    from ev3proto.capture.byte_account import Account
    from ev3proto.capture.formats import CaptureFile
    from ev3proto.capture.record import Event

__all__ = ["EngineError", "wireshark_events"]


def wireshark_events(
    source: str | os.PathLike[str] | BinaryIO | CaptureFile,
    account: Account,
    *,
    dialect: str,
    ports: Collection[int],
    tshark: str | None = None,
    memory: int = DEFAULT_MEMORY,
) -> Iterator[Event]:
    """Everything in a capture, in the order of its packets. A stream is copied into a temporary file for tshark.

    Args:
        source: A path, a stream at its start, or a CaptureFile.
        account: Counts the bytes while the capture is read. Wireshark does not say which bytes are whose headers:
            those, and bytes that came twice, are counted as `other`.
        dialect: The firmware whose instruction set to read by.
        ports: TCP ports on which bricks listen.
        tshark: Path of the tshark, where it is not on the path.
        memory: Bytes that commands without a reply may take together.

    Returns:
        The events. While they are read they raise CaptureError, after everything readable, with what tshark says.

    Raises:
        OSError: The file cannot be opened.
        EngineError: There is no tshark that can be used.

    """
    with ExitStack() as stack:
        path = _file(source, stack)
        program = Program(tshark)
        words = stack.enter_context(program.words(dialect, ports))
        return _events(path, program, words, Events(account, dialect, ports, memory), stack.pop_all())


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
    from ev3proto.capture.formats import CaptureFile

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
