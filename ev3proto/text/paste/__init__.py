r"""Text that people paste -> the bytes of frames: log lines, hex, byte strings, arrays, dumps.

Nobody types a frame into a file of its own: frames come out of terminals, source code and bug reports. What is here
finds them there and leaves prose alone. One rule says what a frame is: a run of byte values, in any notation, whose
length field fits it exactly, wherever it stands in a text and whatever stands around it.

    plain         the hex digits of one frame and nothing else, for which none of the following is loaded
    blanking      what is no byte is blanked: times, casts, indexes, comments
    columns       so are the offsets and the text of dumps
    rhythm        values with the same words between them
    values        the values in a line, the runs that they form, and the readings that a run may have
    familiar      the short way for lines like those before
    readings      what a run may stand for
    fitting       which bytes of a run are frames, and what looks like one
    scanner       lines to frames, also those that are wrapped
    forms         what is no frame: where a piece breaks off, and the few bytes that an argument may be

A reading is chosen by the length field, too: `10` is sixteen where the run is a frame with it, and ten where it is one
with that.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Literal

from ev3proto.text.paste.pieces import MAX_LINE, MAX_TEXT, Pasted, Wants, check_text, short
from ev3proto.text.paste.plain import plain_frame

__all__ = ["MAX_LINE", "Missing", "Pasted", "read_argument", "read_bare", "read_text"]

Missing = Literal["length", "header"]
"""What bytes may lack: the two bytes of the length field, or the whole header of a direct command."""


def read_text(lines: Iterable[str]) -> Iterator[Pasted]:
    """The frames in lines of text, in their order, and what looks like one (`unread`). Never raises of itself.

    Memory stays bounded: only an array or a dump that goes on over several lines is collected, up to 64 KiB of it.
    Lines of more than 1 MiB are not read, but reported.
    """
    from ev3proto.text.paste.reader import Reader

    yield from Reader().read(lines)


def read_bare(lines: Iterable[str], missing: Missing) -> Iterator[Pasted]:
    """The frames in lines of bytes that lack a part of it; each line is one.

    Args:
        lines: The lines.
        missing: What is put in front of the bytes of each.

    Yields:
        The frames. A line whose bytes cannot be a frame even so has a `problem`; a line without bytes has nothing.
    """
    from ev3proto.text.paste.fitting import with_header, with_length
    from ev3proto.text.paste.scanner import bytes_in

    completed = with_length if missing == "length" else with_header
    for number, line in enumerate(lines, 1):
        check_text(line)
        data = bytes_in(line[:MAX_LINE])
        if not data:
            continue
        frame = completed(data)
        text = short(line, MAX_TEXT)
        if frame is not None:
            yield Pasted(frame, number, text)
        else:
            yield Pasted(b"", number, text, problem=f"{len(data)} bytes are no frame that lacks its {missing}")


def read_argument(text: str) -> Pasted:
    """The bytes of one argument of a command line, which is taken to be meant as bytes, however few. Never raises.

    What cannot be read gives a `problem`, and so does a second piece in the same argument: `data` is the first.
    """
    check_text(text)
    return plain_frame(text) or read_any_form(text)


def read_any_form(text: str) -> Pasted:
    """What `read_argument` gives for a text that is not plain hex: any of the other forms."""
    from ev3proto.text.paste.forms import Forms

    lines = text.strip("\r\n").split("\n")
    found = list(read_text(lines))
    pieces = [piece for piece in found if not piece.unread]
    if not any(piece.problem is None for piece in pieces):
        wrapped = _wrapped_hex(lines) if len(lines) > 1 else None
        if wrapped is not None:
            pieces = [wrapped]
        elif len(lines) == 1:
            forms = Forms(Wants(1, is_sure=True))
            pieces = [*forms.feed(lines[0], 1), *forms.close()]
    pieces = [_explained(piece) for piece in pieces]
    if not pieces:
        problem = "it is empty" if not text.strip() else "column 1: there are no bytes in it that could be read"
        return Pasted(b"", 1, short(text, MAX_TEXT), problem=problem)
    first = pieces[0]
    if len(pieces) == 1 or first.problem is not None:
        return first
    problem = f"it has {len(pieces)} frames in it, of which only the first was read: give each an argument of its own"
    return first._replace(problem=problem)


def _explained(piece: Pasted) -> Pasted:
    """The piece, and what is missing in front of it where that makes a frame of it."""
    from ev3proto.text.paste.fitting import bare_reason, is_flawless

    if piece.problem is not None or piece.cut or is_flawless(piece.data):
        return piece
    reason = bare_reason(piece.data)
    return piece if reason is None else piece._replace(problem=reason)


def _wrapped_hex(lines: list[str]) -> Pasted | None:
    """Hex that was wrapped at the end of the line is one piece; a dump must not be joined, its offsets are no bytes."""
    from ev3proto.text.paste.dumps import dump_row
    from ev3proto.text.paste.hexadecimal import bare

    joined = " ".join(lines)
    if dump_row(lines[0]) is not None or len(joined) > MAX_LINE:
        return None
    found = bare(joined, is_sure=False)
    if found is None or not found.data or found.problem is not None:
        return None
    return found.pasted(1, joined)
