"""Fixes of the frames in a text. Only wrong bytes change; comments, times, replies and all other lines stay.

A frame is edited where its bytes are written, in their own notation, and the edited lines are read again: the reader
of texts decides whether they have the fixed frame now. If not, the text is not changed there.
"""

from __future__ import annotations

import base64
import binascii
import io
import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from difflib import SequenceMatcher
from itertools import accumulate, islice, pairwise
from typing import NamedTuple

from ev3proto.checking.checking import check
from ev3proto.checking.fixing import fix
from ev3proto.checking.report import Fix, Report
from ev3proto.messages import Message
from ev3proto.text.paste import Pasted, read_text
from ev3proto.text.paste.elements import BYTES, string_bytes
from ev3proto.text.splitting import split

_MOST_TEXT = 1 << 16
"""Characters of a text in which the bytes of one frame are looked for: the reader collects no more."""


class FixedFrame(NamedTuple):
    """A command in a text, after its fix."""

    line: int  # the line in which it starts, from 1 on
    column: int  # where it starts in this line, from 1 on
    fix: Fix  # the fixed frame, its changes, what was not fixed, and the report on the result
    is_written: bool  # whether the text has the fixed frame; False if its notation cannot be edited
    report: Report  # the report on the frame that the text has now


@dataclass(frozen=True, slots=True)
class FixedText:
    """A text with fixed frames in it.

    text    the whole text
    lines   the numbers of the changed lines, from 1 on
    frames  its commands, in order, also those without a change
    """

    text: str
    lines: tuple[int, ...]
    frames: tuple[FixedFrame, ...]

    @property
    def is_fixed(self) -> bool:
        """Whether anything in the text changed."""
        return bool(self.lines)


def fix_text(text: str, *, dialect: str = "official", carrier: str | None = None) -> FixedText:
    """Fixes everything in the frames of a text that can be fixed with certainty, as `fix` does for one frame.

    Args:
        text: Any text with frames in it, in every notation that `decode` reads. Replies are left alone.
        dialect: "official", "xtended" or "compat": the firmware whose instruction set is used.
        carrier: "usb", "bluetooth" or "wifi": the carrier of the frames; None if it does not matter.

    Returns:
        The text, which lines changed, and the commands with their fixes.

    Raises:
        ValueError: The dialect or the carrier is unknown.
    """
    return fix_pieces(text, list(read_text(unix_lines(text))), dialect=dialect, carrier=carrier)


def fix_pieces(text: str, pieces: Iterable[Pasted], *, dialect: str, carrier: str | None) -> FixedText:
    """Fixes a text by the pieces that `read_text` finds in its `unix_lines`; the rest is as for `fix_text`."""
    found = [pasted for pasted in pieces if pasted.data]
    lines = list(io.StringIO(text, newline=""))
    frames: list[FixedFrame] = []
    edited = lines.copy()
    # From the end on, so that the columns of what is still to be edited stay.
    for number in range(len(found) - 1, -1, -1):
        pasted = found[number]
        fixes, data = _fixed(pasted, dialect, carrier)
        is_written = data == pasted.data
        if not is_written and pasted.problem is None:
            end = next((one.line - 1 for one in found[number:] if one.line > pasted.line), len(lines))
            is_written = _edit(edited, pasted, end, data)
            if not is_written:
                # Rows of a dump have a fixed number of bytes.
                kept, same_size = _fixed(pasted, dialect, carrier, shorten=False)
                is_written = same_size != pasted.data and _edit(edited, pasted, end, same_size)
                fixes = kept if is_written else fixes
        for frame, one in reversed(fixes):
            report = one.report if is_written else check(frame, dialect=dialect, carrier=carrier)
            frames.append(FixedFrame(pasted.line, pasted.column, one, is_written, report))
    changed = tuple(number for number, (old, new) in enumerate(zip(lines, edited, strict=True), 1) if old != new)
    return FixedText("".join(edited), changed, tuple(reversed(frames)))


def is_command(message: Message, pasted: Pasted) -> bool:
    """Returns whether a message is from the client, as its text says, or else its type."""
    if pasted.direction is None:
        return message.type is None or message.type.is_command
    return pasted.direction == "sent"


def is_whole(message: Message, pasted: Pasted) -> bool:
    """Returns whether a text does not say that more bytes of an incomplete message existed."""
    return not (pasted.cut and message.fault is not None and message.fault.truncated)


def unix_lines(text: str) -> Iterator[str]:
    """Yields the lines of a text, each with a line feed at its end, however they ended."""
    return map(_unix, io.StringIO(text, newline=""))


def _unix(line: str) -> str:
    return line.rstrip("\r\n") + "\n" if line.endswith(("\r", "\n")) else line


def _fixed(
    pasted: Pasted, dialect: str, carrier: str | None, *, shorten: bool = True
) -> tuple[list[tuple[bytes, Fix]], bytes]:
    """Returns the commands in a piece with their fixes, and its bytes with them."""
    fixes: list[tuple[bytes, Fix]] = []
    data = b""
    for piece in split(pasted.data, dialect=dialect):
        frame = piece.message.build()
        if is_command(piece.message, pasted) and is_whole(piece.message, pasted):
            fixes.append((frame, fix(frame, dialect=dialect, carrier=carrier, shorten=shorten)))
            frame = fixes[-1][1].frame
        data += frame + piece.rest
    return fixes, data


def _edit(lines: list[str], pasted: Pasted, end: int, data: bytes) -> bool:
    """Writes the new bytes of a piece into its lines, and returns whether the reader sees them there."""
    begin = pasted.line - 1
    sizes = accumulate(map(len, lines[begin:end]))
    end = begin + 1 + sum(size <= _MOST_TEXT for size in islice(sizes, 1, None))
    block = "".join(lines[begin:end])
    before = _read(block)
    for edited in _candidates(block, pasted.column - 1, pasted.data, data):
        after = _read(edited)
        changed = [place for place, (old, new) in enumerate(zip(before, after, strict=False)) if old != new]
        if len(after) == len(before) and [after[place] for place in changed] == [data]:
            lines[begin:end] = io.StringIO(edited, newline="")
            return True
    return False


def _read(block: str) -> list[bytes]:
    """Returns the bytes of the pieces in some lines."""
    return [one.data for one in read_text(unix_lines(block)) if one.data]


# Notations, as far as an edit needs them


class _Atom(NamedTuple):
    """A part of a text that represents bytes."""

    start: int  # where it starts, with its prefix
    at: int  # where its digits start
    end: int  # where it ends
    digits: str  # what is replaced by an edit
    data: bytes


class _Style(NamedTuple):
    """How the numbers of a piece are written."""

    is_padded: bool  # with leading zeros
    is_upper: bool  # with capital letters
    is_signed: bool  # as signed bytes


class _Notation(NamedTuple):
    """One way of writing bytes."""

    pattern: re.Pattern[str]  # an atom, the digits in its first group
    read: Callable[[str], bytes | None]  # returns the bytes of the digits, None if they are none
    write: Callable[[bytes, str, _Style], str]  # returns the digits of new bytes, from the old digits


def _write_hex(data: bytes, _: str, style: _Style) -> str:
    if style.is_signed and len(data) == 1 and data[0] > 127:
        return f"ffffff{data.hex()}"
    digits = data.hex() if style.is_padded or len(data) > 1 else f"{data[0]:x}"
    return digits.upper() if style.is_upper else digits


def _write_escape(data: bytes, old: str, style: _Style) -> str:
    if old.startswith("\\u"):
        return f"\\u{data[0]:04x}"
    if re.match(r"\\\d", old):
        return f"\\{data[0]:03o}"
    return f"\\x{data.hex().upper() if style.is_upper else data.hex()}"


_HEX = re.compile(
    r"(?:\\[xX]|0[xX]|&[hH]|\b[xX]'|\b0(?=(?:[0-9a-fA-F]{2})+[hH])|(?<![0-9A-Za-z]))"
    r"([0-9a-fA-F]+)(?=[hHuUlL8]{0,3}(?![0-9A-Za-z]))"
)
_WORDS = re.compile(r"(?<!\w)([0-9a-fA-F]{4})(?!\w)")
_DECIMAL = re.compile(r"(?<![\w.-])(-?[0-9]{1,3})(?=[uUlLbBsS8]{0,3}(?![\w]))")
_OCTAL = re.compile(r"(?<!\w)0?([0-3][0-7]{2})(?!\w)")
_BINARY = re.compile(r"(?<![0-9A-Za-z])(?:0[bB])?([01]{8})(?!\w)")
_UNIT = re.compile(r"(\\x[0-9a-fA-F]{1,2}|\\u[0-9a-fA-F]{4}|\\u\{[0-9a-fA-F]+\}|\\[0-9]{1,3}|\\?.)", re.DOTALL)
_WORD = re.compile(r"\w")
_SEPARATOR = re.compile(r"[,;]?[ \t]*")
_BASE64 = re.compile(r"[A-Za-z0-9+/_-]{8,}={0,2}")

_NOTATIONS = (
    _Notation(_HEX, BYTES["hex"].__getitem__, _write_hex),
    _Notation(
        _DECIMAL,
        BYTES["decimal"].__getitem__,
        lambda data, _, style: str(data[0] - 256 if style.is_signed and data[0] > 127 else data[0]),
    ),
    _Notation(_UNIT, string_bytes, _write_escape),
    _Notation(_WORDS, BYTES["words"].__getitem__, lambda data, _, style: _write_hex(data[::-1], "", style)),
    _Notation(_OCTAL, BYTES["octal"].__getitem__, lambda data, *_: f"{data[0]:03o}"),
    _Notation(_BINARY, BYTES["bits"].__getitem__, lambda data, *_: f"{data[0]:08b}"),
)


def _candidates(text: str, at: int, old: bytes, new: bytes) -> Iterator[str]:
    """Yields edits of a text that may turn the old bytes, which start at a place in it, into the new ones."""
    encoded = _BASE64.match(text, at)
    if encoded is not None:
        with suppress(binascii.Error):
            if base64.b64decode(encoded[0]) == old:
                yield text[:at] + base64.b64encode(new).decode() + text[encoded.end() :]
    for notation in _NOTATIONS:
        atoms = _atoms(notation, text, at, old)
        if atoms is not None:
            edited = _rewritten(notation, text, atoms, old, new)
            if edited is not None:
                yield edited


def _atoms(notation: _Notation, text: str, at: int, data: bytes) -> list[_Atom] | None:
    """Returns the parts of a text that represent bytes, one after the other; None if it does not have them all.

    What does not continue the bytes is skipped: offsets and comments between them.
    """
    found: list[_Atom] = []
    done = 0
    for match in notation.pattern.finditer(text, at):
        value = notation.read(match[1])
        if value and data.startswith(value, done):
            found.append(_Atom(match.start(), match.start(1), match.end(1), match[1], value))
            done += len(value)
            if done == len(data):
                return found
    return None


def _rewritten(notation: _Notation, text: str, atoms: list[_Atom], old: bytes, new: bytes) -> str | None:
    """Returns the text with the new bytes in place of the old ones; None if their number must stay."""
    kept = _in_place(old, new)
    gaps = [text[one.end : other.start].rpartition("\n") for one, other in pairwise(atoms)]
    if kept is None or (len(new) < len(old) and any(end and _WORD.search(start) for _, end, start in gaps)):
        # Rows with offsets or indexes have a fixed number of bytes.
        return None
    style, fresh = _style_of(atoms), iter(kept)
    pieces: list[str] = []
    done, is_joined = 0, False
    for number, atom in enumerate(atoms):
        data = b"".join(islice(fresh, len(atom.data)))
        gap = "" if is_joined else text[done : atom.start]
        done, is_joined = atom.end, False
        if data == atom.data:
            pieces += (gap, text[atom.start : done])
        elif data:
            pieces += (gap, text[atom.start : atom.at], notation.write(data, atom.digits, style))
        elif "\n" in gap:
            # The first of its line: what separates it from the next one goes with it.
            follows = text[done : atoms[number + 1].start] if number + 1 < len(atoms) else "\n"
            separator = _SEPARATOR.match(text, done) if "\n" in follows else None
            is_joined = separator is None
            done = done if separator is None else separator.end()
            pieces.append(gap)
    return "".join([*pieces, text[done:]])


def _in_place(old: bytes, new: bytes) -> list[bytes] | None:
    """Returns the new bytes in place of each old one, which may be empty; None if there are too many."""
    if len(new) == len(old):
        # If their number stays, so do their places; a comparison may see one of them move.
        return [bytes((byte,)) for byte in new]
    kept = [bytes((byte,)) for byte in old]
    for tag, begin, end, start, stop in SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if stop - start > end - begin:
            return None
        if tag != "equal":
            fresh = [bytes((byte,)) for byte in new[start:stop]]
            kept[begin:end] = fresh + [b""] * (end - begin - len(fresh))
    return kept


def _style_of(atoms: list[_Atom]) -> _Style:
    """Returns how the numbers of a text are written."""
    digits = [atom.digits for atom in atoms]
    letters = "".join(digits)
    return _Style(
        is_padded=all(len(each) > 1 for each in digits),
        is_upper=letters != letters.lower(),
        is_signed=any(each.startswith("-") or each.lower().startswith("ffffff") for each in digits),
    )
