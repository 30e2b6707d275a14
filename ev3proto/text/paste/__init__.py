r"""Text that people paste -> the bytes of frames: log lines, hex, byte strings, arrays, dumps.

Frames come out of terminals, source code and bug reports. One rule says what a frame is: a run of byte values, in any
notation, whose length field fits it exactly, wherever it is in a text and whatever is around it. A reading is chosen by
the length field, too: `10` is sixteen where the run is a frame with it, and ten where it is one with that.

    notations    how values are written, and the bytes of each
    rows         what is around the values of a row: comments, the columns of dumps, indexes
    frames       the frames in bytes, and what bytes are that look like one
    readings     which bytes a run of values is, in each reading that it may have
    pieces       what is reported of a piece: its bytes, and the time and the direction in front of it
    reader       lines to frames, also those over several lines
    mistakes     where a piece breaks off, and the few bytes that an argument may be
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Literal

from ev3proto.text.paste.frames import bare_reason, is_flawless, with_header, without_length
from ev3proto.text.paste.pieces import MAX_LINE, MAX_TEXT, Pasted, check_text, short
from ev3proto.text.paste.reader import Reader, bytes_in

__all__ = ["MAX_LINE", "Missing", "Pasted", "read_argument", "read_bare", "read_text"]

Missing = Literal["length", "header"]
"""What bytes may lack: the two bytes of the length field, or the whole header of a direct command."""


def read_text(lines: Iterable[str]) -> Iterator[Pasted]:
    """Yields the frames in lines of text, in their order, and what looks like one (`unread`).

    Memory is bounded: only an array or a dump over several lines is collected, up to 64 KiB of it. Lines of more than
    1 MiB are not read, but reported.
    """
    yield from Reader().read(lines)


def read_bare(lines: Iterable[str], missing: Missing) -> Iterator[Pasted]:
    """Yields the frames in lines of bytes that lack a part of it; each line is one.

    A line whose bytes cannot be a frame even so has a `problem`; a line without bytes yields nothing.

    Args:
        lines: The lines.
        missing: What is put in front of the bytes of each.
    """
    completed = without_length if missing == "length" else with_header
    for number, line in enumerate(lines, 1):
        check_text(line)
        data = bytes_in(line[:MAX_LINE])
        if data:
            problem = f"{len(data)} bytes are not a frame that lacks its {missing}"
            frame = completed(data)
            yield Pasted(frame or b"", number, short(line, MAX_TEXT), problem=problem if frame is None else None)


def read_argument(text: str) -> Pasted:
    """Returns the bytes of an argument of a command line, which is known to be meant as bytes, however few.

    What cannot be read gives a `problem`, and so does a second piece in the same argument: `data` is the first.
    """
    check_text(text)
    lines = text.strip("\r\n").split("\n")
    found = list(read_text(lines))
    pieces = [piece for piece in found if not piece.unread]
    if not any(piece.problem is None for piece in pieces) and len(text) <= MAX_LINE:
        from ev3proto.text.paste.mistakes import broken  # takes 4 ms, which a frame has no use for

        # Hex may be wrapped at the end of the line.
        sure = broken([" ".join(lines)], 1, is_sure=True)
        pieces = sure if len(lines) == 1 or (sure and sure[0].problem is None) else pieces
    if not pieces:
        problem = "it is empty" if not text.strip() else "column 1: it contains no readable bytes"
        return Pasted(b"", 1, short(text, MAX_TEXT), problem=problem)
    first = pieces[0]
    if first.problem is None and not first.cut and not is_flawless(first.data):
        first = first._replace(problem=bare_reason(first.data))
    if len(pieces) == 1 or first.problem is not None:
        return first
    problem = f"it has {len(pieces)} frames in it, of which only the first was read: give each an argument of its own"
    return first._replace(problem=problem)
