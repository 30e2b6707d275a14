"""Bytes that are not a frame and were meant as one: a wrong length or type, a slip such as `G8`, what was cut.

A wrong frame is given out as its bytes, so that `decode` and `check` name its fault. A slip is named with its column,
and the bytes in front of it are given out.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice, pairwise
from typing import NamedTuple

from ev3proto.schema.header import frame_end, frame_size
from ev3proto.semantics.identify import LOOKS, identify, is_prose
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.text.paste.frames import (
    HASHES,
    bare_reason,
    has_place,
    is_swapped,
    may_begin,
)
from ev3proto.text.paste.heads import head_of, is_head
from ev3proto.text.paste.pieces import LEAST, MAX_TEXT, MOST_SHORT, Pasted, SlipPlace, short
from ev3proto.text.paste.rows import AROUND, Row, of_line
from ev3proto.text.paste.sequences import Part, Values, within
from ev3proto.text.paste.strangers import strange_bytes, written
from ev3proto.text.paste.tokens import BYTES, MISSPELT, Token, clean, string_bytes

_MOST_STARTS = 8
_MOST_BEFORE = 400
"""Characters in front of bytes in which a word may say which way they went."""
_ADDRESS = re.compile(r"(?:[0-9a-fA-F]{2}[:-]){5}[0-9a-fA-F]{2}(?![:-])")
_WORD = re.compile(r"[\s,:;|\"'`-]{0,2}+(\\?\w[^\s,:;|\"'`\[\](){}<>#/]*)")
_LESSON = re.compile(r"0[xX]\|")
_WHO_CUTS = (
    (re.compile(r"\b(?:write|send|sendto|read|recv|recvfrom)\(\d"), "strace cut the string; -s 1024 shows all of it"),
    (
        re.compile(r"\{length = \d+, bytes = |(?<![\w<])<[0-9a-f]{8} "),
        "the description of NSData is cut in the middle; print each byte",
    ),
)
_SCANNED = str.maketrans("OolIi", "00111")
"""The digits that are read as letters in scanned pictures."""
_MISREAD = re.compile(r"(?<![^\W_])(?=\w*[0-9])(?:[0O][xX])?[0-9a-fA-FOolI]*[OolI][0-9a-fA-FOolI]*(?![^\W_])")


_ENDLESS = re.compile(r"\\(?:[xXu](?:[0-9a-fA-F]?|\{[0-9a-fA-F]*))?$")
"""A part of an escape, at which a string is cut."""


class Near(NamedTuple):
    """Bytes that are not a frame.

    data     the bytes
    values   the sequence that they are from, and the part of it
    part
    start    where they begin and end in the bytes of the part
    end
    problem  what is wrong with the text, as a sentence
    cut      the text says that more bytes existed
    notes    who cut it
    """

    data: bytes
    values: Values
    part: Part
    start: int
    end: int
    problem: str | None = None
    cut: bool = False
    notes: tuple[str, ...] = ()
    slip: SlipPlace | None = None


def near(sequences: Iterable[Values], rows: Sequence[Row]) -> Near | None:
    """Returns the bytes of some lines that were meant as a frame; None if there are none."""
    # With expressions among the values, or from any place of several lines, a wrong frame is too much of a guess.
    tried = [values for values in sequences if not (values.is_guess and (values.has_unknown or len(rows) > 1))]
    if len(rows) == 1 and (scanned := _scanned(rows[0])):
        return scanned
    found = (*islice(_wrong(tried, rows), 1), *islice(_begun(tried, rows), 1))
    return found[0] if found else None


def _scanned(row: Row) -> Near | None:
    """Returns the bytes in front of a letter that is read for a digit in a scanned picture: `O` for 0, `l` for 1."""
    slip = _MISREAD.search(row.line)
    meant = Row(_MISREAD.sub(_corrected, row.line), row.number).reading if slip else None
    if slip is None or meant is None or not meant.worth.natural:
        return None
    part = meant.parts[0]
    frame = part.frames[0]
    problem = f"column {slip.start() + 1}: {not_a_byte(slip[0])}"
    known = (
        at
        for token, at in zip(meant.values.tokens[part.first :], part.offsets, strict=False)
        if token.end > slip.start()
    )
    end = next(known, frame.end)
    return Near(
        part.data[frame.start : end],
        meant.values,
        part,
        frame.start,
        max(end, frame.start + 1),
        problem,
        slip=SlipPlace(row.number, slip.start() + 1),
    )


def _corrected(found: re.Match[str]) -> str:
    return found[0].translate(_SCANNED)


def _wrong(sequences: list[Values], rows: Sequence[Row]) -> Iterator[Near]:
    """Yields bytes that are a frame but for their header, or of which the end is missing."""
    for values in sequences:
        for base in values.bases:
            for part in values.parts(base):
                # A length that counts itself tells where the frame ends.
                extents = sorted(_extents(values, part), key=lambda one: not _counts_itself(part.data, *one))
                for start, end in extents:
                    data = part.data[start:end]
                    is_listed = values.is_guess and not values.breaks
                    if _is_digest(part, data):
                        continue
                    is_alone = len(rows) > 1 or is_listed or _is_alone(values, part, start, end, rows[0])
                    is_decimal = base in ("bits", "octal", "words") or (base == "decimal" and any(values.widths))
                    if (
                        len(data) >= LOOKS
                        and identify(data, whole=is_alone, is_doubtful=is_decimal, missing=False).is_meant
                    ):
                        yield _with_stop(Near(data, values, part, start, end), base, rows)


def _counts_itself(data: bytes, start: int, end: int) -> bool:
    return end - start >= LOOKS and frame_size(data, start) == end - start + LENGTH_FIELD


def _extents(values: Values, part: Part) -> Iterator[tuple[int, int]]:
    """Yields the bytes of literals, then those of lists, which a slip ends, then those between two breaks."""
    if len(part.data) < LOOKS:
        return
    is_torn = values.is_torn(part)
    extents = [one for one in islice(values.between_breaks(part), _MOST_STARTS) if one[1] - one[0] >= LOOKS]
    literals = [
        (start, end)
        for start, end in extents
        if values.span(part, start, end)[0] is values.span(part, start, end)[1]
        and frame_size(part.data, start) <= end - start + LENGTH_FIELD
    ]
    if any(is_torn):
        bad = (0 if is_torn[0] else -1, len(part.data) if is_torn[1] else -1)
        yield from (one for one in extents if one[0] != bad[0] and one[1] != bad[1])
        return
    yield from literals
    edges = (
        part.offsets[place - part.first]
        for place in within(values.breaks, part)
        if has_place(values.opens, place) or _has_slip(values, place)
    )
    starts = list(islice(edges, _MOST_STARTS))
    lists = [] if literals else [*pairwise((0, *starts, len(part.data)))]
    yield from lists
    yield from (one for one in extents if one not in lists)


def _has_slip(values: Values, place: int) -> bool:
    """Returns whether there is a word in front of a value that was meant as a value, too."""
    word = _WORD.match(values.tokens[place].gap)
    return word is not None and _is_slip(word[1], values.tokens[place - 1].text)


def _is_digest(part: Part, data: bytes) -> bool:
    """Returns whether one value has as many bytes as a digest, and not nearly as many as its length says."""
    if len(part.offsets) != 2 or len(data) not in HASHES:
        return False
    return abs(frame_size(data) - len(data)) > LENGTH_FIELD and not is_swapped(data)


def _is_alone(values: Values, part: Part, start: int, end: int, row: Row) -> bool:
    """Returns whether bytes are a literal, an array, or all of a line but for what introduces it."""
    first, last = values.span(part, start, end)
    before, after = row.around(first)[0], row.around(last)[1]
    starts = [token.start for token in row.tokens[: 1 + row.is_offset]]
    end = next((token.end for token in reversed(row.tokens) if token.kind != "cut"), last.end)
    is_last = last.end == end and not after.strip(AROUND)
    is_first = first.start in starts and (first.start != starts[0] or not before.strip(AROUND + "x0b"))
    if first == last or (is_last and (is_first or before.rstrip().endswith(":"))):
        return True
    is_closed = last.kind == "string" or after.lstrip(" ,;|:")[:1] in tuple("])}>\"'`")
    if is_closed and any(sign in before for sign in "[({<\"'`"):
        return True
    return head_of(row.line[max(0, first.start - _MOST_BEFORE) : first.start]).direction is not None


def _begun(sequences: list[Values], rows: Sequence[Row]) -> Iterator[Near]:
    """Yields bytes that break off at a slip, an ellipsis, or the end of the line."""
    for values in (one for one in sequences if not one.is_guess):
        for base in values.bases[:2] if values.bases[0] != "base64" else ():
            for part in islice(_parts(values, base), _MOST_STARTS):
                yield from _begun_in(values, base, part, rows)
    first = rows[0]
    word = _WORD.match(first.line, first.line.index("|") + 1) if _LESSON.match(first.line.lstrip()) else None
    if word is not None and BYTES["hex"][word[1]] is None and first.tokens:
        column = word.start(1) + 1
        problem, slip = f"column {column}: {not_a_byte(word[1])}", SlipPlace(first.number, column)
        yield Near(b"", Values(first.tokens[:1]), Part(0, b"\0", [0, 1], []), 0, 1, problem, slip=slip)


def _begun_in(values: Values, base: str, part: Part, rows: Sequence[Row]) -> Iterator[Near]:
    """Yields bytes in a part of a sequence that break off."""
    is_cut = part.last < len(values.tokens) and values.tokens[part.last].kind == "cut"
    for start, end in islice(values.between_breaks(part), _MOST_STARTS):
        end = len(part.data) if is_cut else end
        data, (first, _) = part.data[start:end], values.span(part, start, end)
        is_first = first.line == rows[0].number
        before = rows[0].line[max(0, first.start - _MOST_BEFORE) : first.start] if is_first else ""
        is_one = start + 1 == end < len(part.data) and not before.endswith("|")
        if is_one or _ADDRESS.match(rows[0].line, first.start) or _is_digest(part, data):
            continue
        found = _with_stop(Near(data, values, part, start, end), base, rows)
        if _is_meant(found, values, before) and strange_bytes(data) is None:
            yield found


def _parts(values: Values, base: str) -> Iterator[Part]:
    """Yields the parts of a sequence, and the values that have bytes only in front of a slip."""
    found = list(values.parts(base))
    yield from found
    begun = {part.last for part in found}
    for place, token in enumerate(values.tokens):
        if place not in begun and len(token.text) >= LEAST and (data := _partial(token).data):
            yield Part(place, data, [0, len(data)], [])


def _is_meant(found: Near, values: Values, before: str) -> bool:
    """Returns whether bytes in front of a slip or an end were meant as a frame."""
    data, is_lesson = found.data, before.endswith(("0x|", "0X|"))
    if is_prose(data) and not is_lesson:
        return False
    is_begun = may_begin(data) or (found.problem is not None and frame_end(data) == len(data))
    is_counted = bool({1, 3} & {*values.widths})
    if len(data) >= (2 if is_lesson else LEAST) and is_begun and not (is_counted and data[LEAST - 1 :] < b"\x80"):
        return True
    is_listed = len(data) > 1 and (not is_counted or before.rstrip().endswith(("[", "{", "(")))
    is_stopped = found.cut or found.problem is not None
    return is_stopped and (is_lesson or is_listed) and is_head(before) and head_of(before).direction is not None


def _with_stop(found: Near, base: str, rows: Sequence[Row]) -> Near:
    """Returns bytes with what is wrong behind them: a slip, or an ellipsis."""
    tokens, part = found.values.tokens, found.part
    _, last = found.values.span(part, found.start, found.end)
    if BYTES[base][last.text] is None:
        return _stopped(found, last, rows)
    if len(found.data) > 1 and frame_size(found.data) <= len(found.data):
        return found
    place = part.first + bisect_left(part.offsets, found.end)
    follows = tokens[place] if place < len(tokens) else None
    line = next(row.line for row in rows if row.number == last.line)
    if follows is not None and follows.kind == "cut":
        is_half = len(last.text) == 1 and place > 1 and len(tokens[place - 2].text) == 2
        found = found._replace(data=found.data[:-1], end=found.end - 1) if is_half else found
        return found._replace(cut=True, notes=tuple(note for who, note in _WHO_CUTS if who.search(line)))
    if follows is not None and found.end == len(part.data) and BYTES[base][follows.text] is None:
        return _stopped(found._replace(data=found.data + _partial(follows).data), follows, rows)
    word = _WORD.match(line, last.end)
    if word is None or not _is_slip(word[1], last.text) or (follows is not None and follows.start <= word.start(1)):
        return found
    problem = not_a_byte(word[1], is_hex=last.kind == "digits")
    slip = SlipPlace(last.line, word.start(1) + 1)
    return found._replace(problem=f"{_where(last, rows)}column {slip.column}: {problem}", slip=slip)


def _stopped(found: Near, token: Token, rows: Sequence[Row]) -> Near:
    """Returns bytes that end in a value with a slip."""
    slip = _partial(token)
    if slip.is_cut:
        return found._replace(problem=None, cut=True)
    problem = f"{_where(token, rows)}column {slip.column + 1}: {slip.problem}"
    return found._replace(problem=problem, slip=SlipPlace(token.line, slip.column + 1))


def _where(token: Token, rows: Sequence[Row]) -> str:
    """Returns the line of a value below the first row, as it is named."""
    return f"line {token.line - rows[0].number + 1}, " if token.line > rows[0].number else ""


def _is_slip(word: str, value: str) -> bool:
    """Returns whether a word was meant as a value like the one in front of it."""
    return (len(word) == len(value) or word[:2] in ("0x", "\\x")) and BYTES["hex"][word] is None


class _Partial(NamedTuple):
    """A slip in a value: the bytes in front of it, its column (from 0), what it is; or that the value is cut there."""

    data: bytes
    column: int
    problem: str
    is_cut: bool = False


def _partial(token: Token) -> _Partial:
    """Returns the slip in a value that has no bytes."""
    text = token.text
    if token.kind == "open":
        is_cut = text.rstrip().endswith(("...", "\u2026"))
        body = text.rstrip(". \u2026") if is_cut else text
        body = _ENDLESS.sub("", body)
        data = string_bytes(body[1 + (body[0] == "b") :], "hex") or b""
        return _Partial(data, token.start, "the string that starts here never ends", is_cut)
    if slip := MISSPELT.search(text):
        at = slip.start("escape")
        quote = next((place for place, sign in enumerate(text[:at]) if sign in "\"'`"), -1)
        data = string_bytes(text[quote + 1 : at], "hex") or b""
        return _Partial(data, token.start + at, not_a_byte(slip["escape"]))
    is_odd = _is_hex(text) and len(text) > 4 and len(text) % 2 == 1
    return _Partial(bytes.fromhex(text[:-1]) if is_odd else b"", token.start, not_a_byte(text))


def spelt(sequences: Iterable[Values]) -> str | None:
    """Returns what values are that are the characters of a frame's digits; None for any other."""
    parts = ((values, part) for values in sequences for base in values.bases[:2] for part in values.parts(base))
    between = (part.data[start:end] for values, part in parts for start, end in values.between_breaks(part))
    return next((said for data in between if (said := written(data))), None)


def told(row: Row) -> str | None:
    """Returns what a line of nothing but bytes is, if it is not a frame: one without its header, or something else."""
    values = row.sequences[-1]
    part = next((part for base in values.bases[:2] for part in values.parts(base)), None)
    if part is None or part.last < len(values.tokens) or part.first or row.after.strip(AROUND):
        return None
    first, data = values.tokens[0], part.data
    before = row.line[: first.start].rstrip().removesuffix("(byte)").rstrip()
    is_listed = max(data) > 0x7F and before.endswith(("[", "{", "(", "<<"))
    if not is_listed and not _is_data(row, values):
        return None
    is_dull = first.kind == "string" or (len(values.tokens) > 1 and len({*data}) < LEAST - 1)
    is_known = is_dull or _is_digest(part, data) or _ADDRESS.match(row.line, first.start) is not None
    return strange_bytes(data) or (None if is_known else bare_reason(data))


def _is_data(row: Row, values: Values) -> bool:
    """Returns whether the values of a line were meant as bytes: nothing or a direction introduces them."""
    first = values.tokens[0]
    before = row.line[: first.start]
    is_counted = {*values.widths} != {2} and all(token.text.isdecimal() for token in values.tokens)
    # Operations by their names are assembly, if they are not joined.
    is_assembly = first.kind == "marked" and first.text[0].isalpha() and ".join(" not in row.line
    if 1 in values.widths or is_counted or is_assembly:
        return False
    is_alone = not before.strip(AROUND + "xb") or before.rstrip("([").endswith(".join")
    return is_alone or head_of(before).direction is not None


def not_a_byte(word: str, *, is_hex: bool = True) -> str:
    """Returns what is wrong with a value, as a sentence."""
    digits = word.removeprefix("0x").removeprefix("0X")
    has_digits = not digits.strip("0123456789abcdefABCDEF")
    if slip := MISSPELT.search(word):
        return f"{slip['escape']!r} is not an escape: two hex digits follow \\x"
    if (word.isdecimal() and len(word) == 3) or (has_digits and digits != word):
        return f"{short(word)!r} is more than 255, which a byte cannot be"
    if has_digits and len(digits) % 2:
        return f"{short(word)!r} has an odd number of hex digits ({len(digits)}); two make a byte"
    meant = digits.translate(_SCANNED)
    help_text = f"; did you mean {word[: -len(digits)] + meant!r}?" if _is_hex(meant) and meant != digits else ""
    return f"{short(word)!r} is not {'hex' if is_hex else 'a number'}{help_text}"


def _is_hex(text: str) -> bool:
    return bool(text) and not text.strip("0123456789abcdefABCDEF")


# Bytes that are known to be meant as such


def bytes_in(line: str) -> bytes:
    """Returns the bytes of the values in a line, in their likeliest base, whether they are a frame or not."""
    row = Row(clean(line), 0)
    found = (part.data for values in of_line(row) for base in values.bases[:2] for part in values.parts(base))
    return max(found, key=len, default=b"")


_NO_DIGIT = re.compile(r"(?!^0[xX])(?<!^0)[^0-9a-fA-F]")


def as_given(line: str) -> Pasted:
    """Returns the bytes of a line that has no frame, but is known to be meant as bytes, however few."""
    row = Row(clean(line), 1)
    shown = short(line, MAX_TEXT)
    values = Values(row.tokens)
    for base in values.bases[:2]:
        for part in islice(_parts(values, base), 1):
            before = row.line[: values.tokens[part.first].start]
            if part.first or (before.strip(AROUND + "x0b") and not is_head(before)):
                continue
            found = _with_stop(Near(part.data, values, part, 0, len(part.data)), base, [row])
            return Pasted(found.data, 1, shown, cut=found.cut, problem=found.problem, slip=found.slip)
    if row.tokens and row.is_bare:
        begun = _partial(row.tokens[0])
        slip = SlipPlace(1, begun.column + 1)
        return Pasted(b"", 1, shown, problem=f"column {slip.column}: {begun.problem}", slip=slip)
    if not line.strip():
        return Pasted(b"", 1, "", problem="it is empty")
    word = line.split()[0].rstrip("\"'`)]}>;,")
    slip = SlipPlace(1, 1)
    problem = f"column 1: {short(word)!r} is not hex" if word.strip("-") else "column 1: it contains no readable bytes"
    if len(word) > MOST_SHORT and (strange := _NO_DIGIT.search(word)):
        slip = SlipPlace(1, strange.start() + 1)
        problem = f"column {slip.column}: {strange[0]!r} is not a hex digit"
    return Pasted(b"", 1, shown, problem=problem, slip=slip)
