r"""Text that people paste -> the bytes of frames: log lines, hex, byte strings, arrays, dumps.

One rule says what a frame is: byte values, in any notation, whose length field fits them, wherever they are in a text
and whatever is around them. The protocol decides which values are bytes, and in which base.

To add a notation, add an example to `docs/notations.md`: tests read it, in prose, in rows, and among other lines. If it
is not read, its elements are unknown or what is between them: add a row to `FORMS` in `elements`. If a frame was
changed on its way into the text, add a row to `REPAIRS`. Nothing else knows notations.

    elements     a line -> its elements, and the bytes of an element in each base; a row for each form
    runs         hypotheses: which elements of a line, or of lines that look alike, are bytes
    frames       bytes -> the frames in them, and what was meant as one
    judge        what a run is worth
    near         wrong frames, slips, what was cut
    repairs      what happened to a frame on its way into the text
    heads        the time and the direction in front of bytes
    pieces       what is reported
    strangers    what bytes and lines are that have nothing to do with frames
    reader       lines -> blocks of lines -> pieces
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Literal

from ev3proto.messages import DirectCommand
from ev3proto.schema.frame import FrameReader, frame_reader, is_flawless
from ev3proto.semantics.advice import BARE
from ev3proto.semantics.footprint import memory_of
from ev3proto.semantics.identify import with_header, without_length
from ev3proto.text.paste.frames import lacking
from ev3proto.text.paste.near import as_given, bytes_in
from ev3proto.text.paste.pieces import MAX_LINE, MAX_TEXT, Pasted, check_text, short
from ev3proto.text.paste.reader import Reader

__all__ = ["MAX_LINE", "Missing", "Pasted", "read_argument", "read_bare", "read_text"]

Missing = Literal["length", "header"]
"""What bytes may lack: the two bytes of the length field, or the whole header of a direct command."""


def read_text(lines: Iterable[str], is_silent: Callable[[], bool] = lambda: False) -> Iterator[Pasted]:
    """Yields the frames in lines of text, in their order, and what was meant as one.

    Memory is bounded: only an array or a dump over several lines is collected, up to 64 KiB of it. Lines of more than
    1 MiB are not read, but reported.

    Args:
        lines: The lines.
        is_silent: Waits for the next line, and returns whether it does not come. It is called only when something may
            be continued by it, which is then yielded as it is.
    """
    yield from Reader().read(lines, is_silent)


def read_bare(lines: Iterable[str], missing: Missing, dialect: str = "official") -> Iterator[Pasted]:
    """Yields the frames in lines of bytes that lack a part of it; each line is one.

    A line whose bytes cannot be a frame even so has a `problem`; a line without bytes yields nothing.

    Args:
        lines: The lines.
        missing: What is put in front of the bytes of each.
        dialect: The firmware whose operations use memory.
    """
    reader = frame_reader(dialect)
    for number, line in enumerate(lines, 1):
        check_text(line)
        data = bytes_in(line[:MAX_LINE])
        if data:
            frame = without_length(data) if missing == "length" else with_header(data, reader)
            if frame is None:
                problem: str | None = f"{len(data)} bytes are not a frame that lacks its {missing}"
            else:
                problem = _excess(frame, reader) if missing == "header" else None
            yield Pasted(frame or b"", number, short(line, MAX_TEXT), problem=problem)


def _excess(frame: bytes, reader: FrameReader) -> str | None:
    """Returns what is wrong with the memory that the operations of a frame use, as a sentence; None if it fits."""
    message = reader.read_frame(frame, strict=False)
    return memory_of(message.operations).excess if isinstance(message, DirectCommand) else None


def read_argument(text: str) -> Pasted:
    """Returns the bytes of an argument of a command line, which is known to be meant as bytes, however few.

    What cannot be read gives a `problem`, and so does a second piece in the same argument: `data` is the first.
    """
    check_text(text)
    lines = text.strip("\r\n").split("\n")
    found = list(read_text(lines))
    if not any(piece.data or piece.problem for piece in found) and len(text) <= MAX_LINE:
        found = [as_given(" ".join(lines))]
    first = _as_bare(found[0])
    if len(found) == 1 or first.problem is not None:
        return first
    problem = f"contains {len(found)} frames; only the first was read (pass each as a separate argument)"
    return first._replace(problem=problem)


def _as_bare(piece: Pasted) -> Pasted:
    """Returns a piece, without data and with a problem if its bytes lack a part of a frame."""
    is_given = piece.problem is None and not piece.cut and not piece.unknown
    lacks = lacking(piece.data) if is_given and not is_flawless(piece.data) else None
    return piece if lacks is None else piece._replace(data=b"", problem=BARE[lacks], lacks=lacks)
