r"""Text that people paste -> the bytes of frames: log lines, hex, byte strings, arrays, dumps.

Frames come out of terminals, source code and bug reports. One rule says what a frame is: a run of byte values, in any
notation, whose length field fits it exactly, wherever it is in a text and whatever is around it. A reading is chosen by
the length field, too: `10` is sixteen where the run is a frame with it, and ten where it is one with that.

    notations    how values are written, and what is between them; a row for each form, with an example
    values       the bytes of a value, in each reading
    rows         what is around the values of a row: comments, the columns of dumps, indexes
    frames       the frames in bytes, and the bytes that were meant as one
    readings     which bytes a run of values is, in each reading that it may have
    pieces       what is reported of a piece: its bytes, and the time and the direction in front of it
    near         wrong frames, slips, pieces that were cut
    strangers    what bytes and lines are that have nothing to do with frames
    groups       lines that belong together
    reader       lines to pieces
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Literal

from ev3proto.text.paste.frames import bare_reason, is_flawless, with_header, without_length
from ev3proto.text.paste.near import AROUND, broken
from ev3proto.text.paste.pieces import MAX_LINE, MAX_TEXT, MOST_SHORT, Pasted, check_text, clean_head, short
from ev3proto.text.paste.reader import Reader, bytes_in
from ev3proto.text.paste.readings import runs_in

__all__ = ["MAX_LINE", "Missing", "Pasted", "read_argument", "read_bare", "read_text"]

_NO_DIGIT = re.compile(r"(?!^0[xX])(?<!^0)[^0-9a-fA-F]")

Missing = Literal["length", "header"]
"""What bytes may lack: the two bytes of the length field, or the whole header of a direct command."""


def read_text(lines: Iterable[str]) -> Iterator[Pasted]:
    """Yields the frames in lines of text, in their order, and what was meant as one.

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
    if not any(piece.data or piece.problem for piece in found) and len(text) <= MAX_LINE:
        found = [_short(" ".join(lines))]
    first = found[0]
    if first.problem is None and not first.cut and not first.unknown and not is_flawless(first.data):
        first = first._replace(problem=bare_reason(first.data))
    if len(found) == 1 or first.problem is not None:
        return first
    problem = f"it has {len(found)} frames in it, of which only the first was read: give each an argument of its own"
    return first._replace(problem=problem)


def _short(line: str) -> Pasted:
    """Returns what a line is that is known to be meant as bytes, and has no frame."""
    runs = [run for run in runs_in(line, 1) if not line[clean_head(line).end : run.start].strip(AROUND + "x0b")]
    one = next((one for run in runs if (one := broken(run, line, is_sure=True))), None)
    if one is not None:
        return Pasted(one.data, 1, short(line, MAX_TEXT), cut=one.cut, problem=one.problem)
    if not line.strip():
        return Pasted(b"", 1, "", problem="it is empty")
    word = line.split()[0].rstrip("\"'`)]}>;,")
    problem = f"column 1: {short(word)!r} is not hex" if word.strip("-") else "column 1: it contains no readable bytes"
    if len(word) > MOST_SHORT and (strange := _NO_DIGIT.search(word)):
        problem = f"column {strange.start() + 1}: {strange[0]!r} is not a hex digit"
    return Pasted(b"", 1, short(line, MAX_TEXT), problem=problem)
