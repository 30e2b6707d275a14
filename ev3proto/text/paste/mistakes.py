r"""Pieces that are meant as bytes without being a frame: the few bytes of an argument, those of a log that were cut,
and where a piece breaks off, such as at `0x1FF`, `G8` or `\xof`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from ev3proto.schema.header import frame_size
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.text.paste.pieces import (
    LEAST,
    MAX_TEXT,
    MOST_SHORT,
    NO_HEAD,
    Head,
    Pasted,
    clean_head,
    head_before,
    short,
)
from ev3proto.text.paste.readings import is_nearly, may_begin
from ev3proto.text.paste.values import literal

_OPENING = re.compile(
    r"(?P<lesson>0[xX]\|)|\b(?P<call>(?:fromhex|unhexlify)\(\s{0,8}b?[\"'](?=(?P<hex>[^\"']*)))"
    r"|(?P<string>(?<!\w)b(?=[\"'])|(?=[\"'][ -~]?\\x))(?P<quote>[\"'])|(?P<array>[\[{])"
)
_LESSON_FRAME = re.compile(r"0[xX]\|[0-9a-fA-F]{2}:[0-9a-fA-F]{2}\|[0-9a-fA-F]{2}:[0-9a-fA-F]{2}\|[0-9a-fA-F]{2}")
_LESSON = re.compile(r"[0-9a-fA-F\s:|.…]*$|[^\s\"'`()<>,;]*")
_ESCAPES = re.compile(r"b?(?=[ -~]?\\x[0-9a-fA-F]{2})")
_BODY = {
    quote: re.compile(rf"(?:(?![\\{quote}])[ -~]|\\(?:x[0-9a-fA-F]{{2}}|[0-3]?[0-7]{{1,2}}|[ -/89:-wy-~]))*")
    for quote in "\"'"
}
# An ellipsis that may have cut an escape in two.
_CUT = re.compile(r"(?:\\x?[0-9a-fA-F]?)?(?:\.{3}|…)")
_ROW = re.compile(
    r"\s*(?:0[xX])?(?P<offset>[0-9a-fA-F]{4,16})(?P<colon>:?)(?P<blanks>\s+)(?P<first>[0-9a-fA-F]{2,8})\b"
)
_TEXT_COLUMN = re.compile(r"(?<=\S)\s{2,}(?!\s?[0-9a-fA-F]{2}(?:\s|$))|\||$")
_ADDRESS = re.compile(r"(?:[0-9a-fA-F]{2}[:-]){5}[0-9a-fA-F]{2}\s*$")
_WORD = re.compile(r"(?<![^\W_])[a-zA-Z]{3,}(?![^\W_])")
_END = re.compile(r"\s(?:#|//)|[\s\"'`\])}>;,]*$")
_HEX = re.compile(r"(0[xX])?([0-9a-fA-F]+)")
_NO_DIGIT = re.compile(r"[^0-9a-fA-FxX]")
_NUMBER = re.compile(r"(?:0[xX]([0-9a-fA-F]+)|0[bB]([01]+)|(\d+))[uU]?", re.ASCII)
_PART, _HEX_PART = (
    re.compile(
        rf"(?P<blank>\s+)|(?P<comma>[,{marks}]+)|(?P<remark>//[^\n]*|#[^\n]*|/\*(?:[^*]|\*(?!/))*(?:\*/)?)"
        rf"|(?P<cut>\.{{3}}|…)|(?P<close>[\]}}])|(?P<word>(?:(?!\.{{3}}|…)[^\s,{marks}\]}}])+)"
    )
    for marks in ("", r";:|\-")
)


class Found(NamedTuple):
    """Bytes in text[start:end].

    problem    what is wrong at the offset `at`
    is_marked  they are where only a frame can be, however short they are
    is_open    the text ends before they do
    """

    start: int
    end: int
    head: Head
    data: bytes
    cut: bool = False
    problem: str | None = None
    at: int = 0
    is_marked: bool = False
    is_open: bool = False

    @property
    def is_worth(self) -> bool:
        """Whether it is worth reporting among other text: the text says that it is meant as bytes, or it breaks off."""
        if self.problem is not None:
            is_log = self.head.is_log and (bool(self.data) or self.head.direction is not None)
            return self.is_marked or is_log or (len(self.data) >= LEAST - 1 and may_begin(self.data))
        is_meant = self.is_marked or (self.head.is_log and self.head.direction is not None)
        return (is_meant and len(self.data) >= 2) or (self.cut and len(self.data) >= LEAST)


def broken(lines: list[str], number: int, *, is_sure: bool, is_array: bool = False) -> list[Pasted]:
    """Returns the pieces in lines without a frame that are worth reporting.

    Args:
        lines: A line, or some that belong together.
        number: The number of the first one.
        is_sure: They are known to be meant as bytes, however few.
        is_array: An array is open in front of them.
    """
    text, after, start = "\n".join(lines), 0, 0
    pieces = [piece for piece in [_array(text, 0, 0, NO_HEAD)] if is_array and piece.is_worth]
    for line in lines:
        is_comment = line.lstrip().startswith(("#", "//")) and not is_sure
        if start >= after and line.strip() and not is_comment and not is_array:
            here = [piece for piece in _marked(text, line, start, is_sure=is_sure) if is_sure or piece.is_worth]
            if all(piece.problem is not None for piece in here):
                # Hex in brackets without 0x breaks off as an array at its first letter.
                whole = [piece for piece in _whole(line, start, is_sure=is_sure) if is_sure or piece.is_worth]
                is_better = any(piece.problem is None for piece in whole) and here and text[here[0].start] in "[{"
                here = whole if is_better or not here else here
            pieces += here
            after = max((piece.end for piece in pieces), default=0)
        start += len(line) + 1
    return [_told(piece, text, number) for piece in pieces]


def _told(piece: Found, text: str, number: int) -> Pasted:
    place, problem = piece.start, piece.problem
    column = place - text.rfind("\n", 0, place)
    if problem is not None:
        line = text.count("\n", place, piece.at)
        problem = f"column {piece.at - text.rfind(chr(10), 0, piece.at)}: {problem.format(column)}"
        problem = f"line {line + 1}, {problem}" if line else problem
    shown = short(text[place : piece.end], MAX_TEXT)
    line = number + text.count("\n", 0, place)
    return Pasted(piece.data, line, shown, piece.head.direction, piece.head.time, piece.cut, problem, column)


def _marked(text: str, line: str, start: int, *, is_sure: bool) -> Iterator[Found]:
    """Yields the pieces that begin in a line of a text with something that says what they are.

    Brackets are in prose and code for much else, so an array is read number by number and given up where it is not one.
    """
    position = before = 0
    clean = clean_head(line)
    while opening := _OPENING.search(line, position):
        at, position = opening.span()
        head = clean if at <= clean.end else NO_HEAD
        if opening["array"]:
            is_value = line[max(0, at - 8) : at].rstrip().endswith(("=", "(", ":", ",", "[", "{"))
            if opening["array"] == "[" and not head.is_clean and not is_value:
                continue
            found = _array(text, start + at, start + position, head)
            if found.problem is not None and len(found.data) < 2 and not (is_sure and head.is_clean):
                position = len(line) if found.is_open else position
                continue
        elif opening["quote"]:
            found = _string(line, at, position, opening["quote"], head, start)
            if not head.is_clean and "\\" not in line[at : found.end - start]:
                continue
        elif opening["call"]:
            found = _hex(line, at, position, position + len(opening["hex"]), head, start)
        elif head.is_clean or _LESSON_FRAME.match(line, at):
            # Blanks may be between the groups when nothing else follows; the lesson writes single values so, too.
            rest = _LESSON.match(line, position)
            stop = len(line) if rest is None else rest.end()
            found = _hex(line, at, position, stop - line.endswith("|.", position, stop), head, start)
            found = found._replace(is_marked=head.is_clean)
        else:
            continue
        yield found._replace(head=head_before(line, before, at)) if is_sure or found.is_worth else found
        if is_sure and found.problem is not None:
            return
        position = before = max(position, found.end - start)
        clean = clean_head(line, before)


def _whole(line: str, start: int, *, is_sure: bool) -> Iterator[Found]:
    """Yields what a line is that has nothing else than bytes: escapes without quotes, a row of a dump, hex."""
    head = clean_head(line)
    first, end = head.end, len(line.rstrip())
    if escapes := _ESCAPES.match(line, first):
        # Blanks and commas between escapes are not bytes.
        text = re.sub(r"(?<=\\x..)[\s,]+(?=\\x)", "", line[:end])
        found = _string(text, first, escapes.end(), "", head, start)
        yield found._replace(problem=found.problem and f"{found.problem} is not an escape such as \\x0e")
        return
    if row := _ROW.match(line):
        is_od = len(row["offset"]) == 7 and not row["colon"]
        if is_od and len(row["first"]) == 4:
            words = "words of two bytes are in either order in a dump, use hexdump -C or xxd"
            yield Found(start, start + end, head, b"", False, words, start + row.start("first"), True)
            return
        if row["colon"] or (len(row["first"]) == 2 and (row["blanks"] != " " or is_od)):
            column = _TEXT_COLUMN.search(line, row.start("first"), end)
            found = _hex(line, 0, row.start("first"), end if column is None else column.start(), head, start)
            if found.problem is not None and not int(row["offset"], 16):
                yield found._replace(is_marked=True)
            return
    if _ADDRESS.match(line, first) and not is_sure:
        return
    remark = _END.search(line, first)
    stop = end if remark is None else remark.start()
    found = _hex(line, first, first, stop, head, start)
    groups = [part[0] for part in _HEX_PART.finditer(line, first, stop) if part["word"] or part["close"]]
    if found.problem is not None and not is_sure:
        # A line of bytes with one slip among them begins a frame; a log line has many digits and no words.
        strange = [group for group in groups if _HEX.fullmatch(group) is None]
        is_short = len(strange) == 1 and strange[0].isalnum() and len(strange[0]) < LEAST
        size = sum((len(group) + 1) // 2 for group in groups)
        is_slip = is_short and len(found.data) >= LENGTH_FIELD and abs(frame_size(found.data) - size) <= LENGTH_FIELD
        is_number = any("." in group for group in strange)
        is_log = head.is_log and not is_number and sum(map(line[first:stop].count, "0123456789abcdefABCDEF")) >= 8
        if _WORD.search(line, first, stop) is not None or not (is_slip or is_log):
            return
        found = found._replace(is_marked=is_slip)
    elif found.problem is None and "-" not in line[first:stop] and is_nearly(found.data):
        # Nothing else is in the line: a frame made by hand, with a wrong length.
        found = found._replace(is_marked=True)
    if groups:
        yield found


def _hex(line: str, begin: int, start: int, end: int, head: Head, offset: int) -> Found:
    """Returns the groups of hex digits in line[start:end], up to the first that is something else."""
    parts = [part for part in _HEX_PART.finditer(line, start, end) if part.lastgroup not in ("blank", "comma")]
    cut = bool(parts) and parts[-1]["cut"] is not None
    data, problem, at = b"", None, 0
    for part in parts[:-1] if cut else parts:
        word, at = part[0], part.start()
        number = _HEX.fullmatch(word)
        digits = "" if number is None else number[2].zfill(2) if number[1] else number[2]
        data += bytes.fromhex(digits[: len(digits) & ~1])
        if number is None:
            strange = _NO_DIGIT.search(word) if len(word) > MOST_SHORT else None
            problem = f"{short(word)!r} is not hex"
            if strange is not None:
                problem, at = f"{strange[0]!r} is not a hex digit", at + strange.start()
        elif number[1] and len(digits) > 2 and len(parts) > 1:
            data, problem = data[: -(len(digits) // 2)], f"{short(word)!r} is more than 255, which a byte cannot be"
        elif len(digits) % 2 and not (cut and part is parts[-2]):
            # Where the text was cut, half a byte at the end was cut, too.
            problem = f"{short(word)!r} has an odd number of hex digits ({len(digits)}); two make a byte"
        if problem is not None:
            break
    problem = problem and problem.replace("{", "{{").replace("}", "}}")
    return Found(offset + begin, offset + end, head, data, cut, problem, offset + at)


def _string(line: str, begin: int, start: int, quote: str, head: Head, offset: int) -> Found:
    """Returns the characters and escapes of a string, or of escapes without quotes."""
    body = _BODY[quote or '"'].match(line, start)
    stop = start if body is None else body.end()
    is_closed = bool(quote) and line.startswith(quote, stop)
    cut = not is_closed and (line.endswith("...", start, stop) or _CUT.match(line, stop) is not None)
    problem = None
    if not is_closed and not cut and stop < len(line):
        problem = f"{short(line[stop : stop + 4])!r}".replace("{", "{{").replace("}", "}}")
        problem += " cannot be in a byte string" * bool(quote)
    elif not is_closed and not cut and quote:
        problem = "the string that starts at column {} never ends"
    data = literal(line[start:stop].rstrip(".") if cut else line[start:stop]) or b""
    return Found(offset + begin, offset + (stop + 1 if quote else len(line)), head, data, cut, problem, offset + stop)


def _array(text: str, start: int, position: int, head: Head) -> Found:
    """Returns the array of numbers from there on, which may end in a later line."""
    data, problem, at, cut, is_closed, needs_comma = bytearray(), None, start, False, False, False
    while problem is None and not is_closed and (part := _PART.match(text, position)):
        kind, at, position = part.lastgroup, position, part.end()
        is_closed, cut = kind == "close", cut or kind == "cut"
        if kind == "remark" and part[0].startswith("/*") and not part[0].endswith("*/"):
            problem = "the comment that starts here never ends"
        elif kind == "word":
            is_missing = needs_comma and _NUMBER.fullmatch(part[0]) is not None
            problem = "a comma is missing" if is_missing else _add(data, part[0])
        needs_comma = (needs_comma or kind in ("word", "cut")) and kind != "comma"
    if problem is None and not is_closed and not cut:
        problem, at = "the array that starts here never ends", start
    is_meant = problem is None or head.is_log or may_begin(data)
    is_open = not is_closed and position >= len(text)
    return Found(start, position, head, bytes(data) if is_meant else b"", cut, problem, at, is_open=is_open)


def _add(data: bytearray, word: str) -> str | None:
    """Adds a number to an array; returns what is wrong with it."""
    number = _NUMBER.fullmatch(word)
    if number is None:
        return f"{short(word[:32])!r} is not a number".replace("{", "{{").replace("}", "}}")
    digits, base = number[number.lastindex or 0], {1: 16, 2: 2}.get(number.lastindex or 0, 10)
    # Cut short: a few digits tell that it is too much, and Python refuses to read thousands of them.
    value = int(digits.lstrip("0")[:9] or "0", base)
    if base == 10 and value > 7 and digits[0] == "0":
        return f"{digits[:9]} is octal in C and decimal to most readers, write it as 0x.."
    if value > 255:
        return f"{short(word)} is more than 255, which a byte cannot be"
    data.append(value)
    return None
