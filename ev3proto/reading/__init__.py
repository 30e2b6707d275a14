"""Whatever it is, read: frames in any notation, logs, dumps, captures, programs, assembly. Start with `ev3proto.read`.

    for item in ev3proto.read("robot.log"):
        if isinstance(item, ev3proto.reading.Record):
            print(item.place, item.message.build().hex())

    given       what is given: a file, a text, bytes, lines, an open file
    kinds       what a file is, by its first bytes
    texts       the frames of a text, or the source that it is
    parts       each source, read once
    items       what reading yields
    lines       the lines that show it
    faults      what is wrong with a frame
    assembling  the frames that are made of assembly

Nothing here prints.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from importlib import import_module
from typing import TYPE_CHECKING, Any

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.capture.record import Place, Record
from ev3proto.checking.report import Severity
from ev3proto.reading.given import Readable, given
from ev3proto.reading.items import Image, Item, Problem, ProblemCode, Source, SourceKind
from ev3proto.reading.options import BUILTIN, ENGINES, Options
from ev3proto.reading.parts import Reading

if TYPE_CHECKING:
    from ev3proto.capture.filter import Filter
    from ev3proto.reading.assembling import assembled as assembled

__all__ = [
    "Image",
    "Item",
    "Place",
    "Problem",
    "ProblemCode",
    "Readable",
    "Record",
    "Severity",
    "Source",
    "SourceKind",
    "assembled",
    "read",
]


def read(
    *sources: Readable,
    dialect: str = "official",
    filter: str | Filter | None = None,
    ports: Collection[int] = (),
    everything: bool = False,
    memory: int = DEFAULT_MEMORY,
    engine: str = BUILTIN,
    tshark: str | None = None,
) -> Iterator[Item]:
    """Reads whatever the sources are, in their order, as far as it is asked for.

    Args:
        sources: A `Path` is a file. A `str` is a file if one has that name, else a text: frames in any notation that
            `ev3proto decode` reads, or assembly. Bytes are a frame, a capture or an image. Lines and open files, such
            as `sys.stdin`, are read as they come. Replies in one source may answer commands in an earlier text.
        dialect: The firmware whose instruction set is used: "official", "xtended" or "compat".
        filter: Yields only matching records, such as "op == SOUND.TONE".
        ports: TCP ports on which bricks listen: all their traffic is read, recognised or not. Without any, traffic on
            port 5555 is read if it is recognised.
        everything: Also read unrecognised traffic on that port, on a brick's Bluetooth channel, and in USB reports of a
            brick's size.
        memory: Memory limit in bytes for unfinished frames, transfers and unanswered commands; the oldest are dropped
            first, which is a problem.
        engine: "builtin", or "wireshark" for tshark, which reads all formats and link types of Wireshark.
        tshark: Path of tshark, if it is not on PATH.

    Yields:
        A Record for each message, an Image for a program, a Source for assembly or an .lms file, and a Problem for
        everything that cannot be read or is odd. A source with nothing in it is one Problem. A frame that is wrong is
        a Record whose `message.fault` says where.

    Raises:
        OSError: A file cannot be opened.
        ValueError: The dialect, the engine or the filter is unknown or wrong.
        TypeError: A source is of another type.
    """
    if isinstance(filter, str):
        from ev3proto.capture.filter import compile_filter  # takes 16 ms, which only filters need

        filter = compile_filter(filter)  # noqa: A001
    if engine not in ENGINES:
        raise ValueError(f"unknown engine {engine!r}; expected {' or '.join(ENGINES)}")
    options = Options(dialect, tuple(ports), everything, engine, tshark, filter, memory=memory)
    return iter(Reading([given(source) for source in sources], options))


def __getattr__(name: str) -> Any:
    """Imports the assembler on first use: it takes 8 ms, which frames do not need."""
    if name != "assembled":
        raise AttributeError(f"module 'ev3proto.reading' has no attribute {name!r}")
    value = globals()[name] = import_module("ev3proto.reading.assembling").assembled
    return value
