r"""Pieces that are meant as bytes without being a frame: the few bytes of an argument, those of a log that were cut,
and where a piece breaks off, such as at `0x1FF`, `G8` or `\xof`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from ev3proto.schema.header import frame_size
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.text.paste.fitting import is_nearly, may_begin
from ev3proto.text.paste.head import NO_HEAD, Head, clean_head, head_before
from ev3proto.text.paste.literals import literal
from ev3proto.text.paste.pieces import LEAST, MAX_TEXT, MOST_SHORT, Pasted, short

_SEPARATORS = " \t\r\n\f\v,;:|-"
_GROUP = re.compile(r"[^\s,;:|\-]+")
_HEX_GROUP = re.compile(r"(0[xX])?([0-9a-fA-F]+)")
_NO_DIGIT = re.compile(r"[^0-9a-fA-FxX]")
_WORD = re.compile(r"(?<![^\W_])[a-zA-Z]{3,}(?![^\W_])")
_REMARK = re.compile(r"\s(?:#|//)")
_OPENING = re.compile(
    r"(?P<lesson>0[xX]\|)(?=(?P<groups>[^\s\"'`()<>,;]*))|\b(?P<call>(?:fromhex|unhexlify)\(\s{0,8}b?[\"'](?=(?P<hex>[^\"']*)))"
    r"|(?P<string>(?<!\w)b(?=[\"'])|(?=[\"'][ -~]?\\x))(?P<quote>[\"'])|(?P<array>[\[{])"
)
_LESSON_FRAME = re.compile(r"0[xX]\|[0-9a-fA-F]{2}:[0-9a-fA-F]{2}\|[0-9a-fA-F]{2}:[0-9a-fA-F]{2}\|[0-9a-fA-F]{2}")
_LESSON_REST = re.compile(r"[0-9a-fA-F\s:|.…]*$")
_ESCAPES = re.compile(r"b?(?=[ -~]?\\x[0-9a-fA-F]{2})")
_BODY = {
    quote: re.compile(rf"(?:(?![\\{quote}])[ -~]|\\(?:x[0-9a-fA-F]{{2}}|[0-3]?[0-7]{{1,2}}|[ -/89:-wy-~]))*")
    for quote in "\"'"
}
# An ellipsis that may have cut an escape in two.
_CUT = re.compile(r"(?:\\x?[0-9a-fA-F]?)?(?:\.{3}|…)")
_OFFSET = re.compile(
    r"\s*(?:0[xX])?(?P<offset>[0-9a-fA-F]{4,16})(?P<colon>:?)(?P<blanks>\s+)(?P<first>[0-9a-fA-F]{2,8})\b"
)
_TEXT_COLUMN = re.compile(r"(?<=\S)\s{2,}(?!\s?[0-9a-fA-F]{2}(?:\s|$))|\|")
_ADDRESS = re.compile(r"(?:[0-9a-fA-F]{2}[:-]){5}[0-9a-fA-F]{2}")
_PART = re.compile(
    r"(?P<blank>\s+)|(?P<comma>,)|(?P<remark>//[^\n]*|#[^\n]*)|(?P<comment>/\*)|(?P<ellipsis>\.{3}|…)"
    r"|(?P<number>0[xX][0-9a-fA-F]+|0[bB][01]+|\d+)[uU]?(?!\w|\.\d)|(?P<closer>[\]}])|(?P<other>[^\s,\]}]{1,32})",
    re.ASCII,
)


class Found(NamedTuple):
    """Bytes in text[start:end].

    is_marked  they are where only a frame can be, however short they are
    is_open    the text ends before they do
    """

    start: int
    end: int
    head: Head
    data: bytes
    cut: bool
    problem: str | None
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
    pieces = [array for array in [_array(text, 0, 0, 0, NO_HEAD)] if is_array and array.is_worth]
    for line in lines:
        end = start + len(line)
        is_comment = line.lstrip().startswith(("#", "//")) and not is_sure
        if start >= after and line.strip() and not is_comment and not is_array:
            here = [piece for piece in _marked(text, start, end, is_sure=is_sure) if is_sure or piece.is_worth]
            if all(piece.problem is not None for piece in here):
                # Hex in brackets without 0x breaks off as an array at its first letter.
                whole = [piece for piece in _whole(line, start, is_sure=is_sure) if is_sure or piece.is_worth]
                is_better = any(piece.problem is None for piece in whole) and here and text[here[0].start] in "[{"
                here = whole if is_better or not here else here
            pieces += here
            after = max((piece.end for piece in pieces), default=0)
        start = end + 1
    found = []
    for piece in pieces:
        begin = text.rfind("\n", 0, piece.start + 1) + 1
        shown, direction, time = short(text[piece.start : piece.end], MAX_TEXT), piece.head.direction, piece.head.time
        line_number, column = number + text.count("\n", 0, begin), piece.start - begin + 1
        found.append(Pasted(piece.data, line_number, shown, direction, time, piece.cut, piece.problem, column))
    return found


def _marked(text: str, start: int, end: int, *, is_sure: bool) -> Iterator[Found]:
    """Yields the pieces that begin in text[start:end] with something that says what they are.

    Brackets are in prose and code for much else, so an array is read number by number and given up where it is not one.
    """
    line, position, before = text[start:end], 0, 0
    clean = clean_head(line)
    while opening := _OPENING.search(line, position):
        at, position = opening.span()
        head = clean if at <= clean.end else NO_HEAD
        if opening["array"]:
            is_value = line[max(0, at - 8) : at].rstrip().endswith(("=", "(", ":", ",", "[", "{"))
            if opening["array"] == "[" and not head.is_clean and not is_value:
                continue
            found = _array(text, start + at, start + position, start, head)
            if found.problem is not None and len(found.data) < 2 and not (is_sure and head.is_clean):
                position = len(line) if found.is_open else position
                continue
        elif opening["quote"]:
            found = _string(line, at, position, opening["quote"], head, start)
            if not head.is_clean and "\\" not in line[at : found.end - start]:
                continue
        elif opening["call"]:
            found = _hex(line, at, position, position + len(opening["hex"]), head, start)
        else:
            # Blanks may be between the groups when nothing else follows; the lesson writes single values so, too.
            stop = len(line) if _LESSON_REST.match(line, position) else position + len(opening["groups"])
            stop -= line.endswith("|.", position, stop)
            if not head.is_clean and not _LESSON_FRAME.match(line, at):
                continue
            found = _hex(line, at, position, stop, head, start)._replace(is_marked=head.is_clean)
        yield found._replace(head=head_before(line, before, at)) if is_sure or found.is_worth else found
        if is_sure and found.problem is not None:
            return
        position = before = max(position, found.end - start)
        clean = clean_head(line, before)


def _whole(line: str, start: int, *, is_sure: bool) -> Iterator[Found]:
    """Yields what a line is that has nothing else than bytes: escapes without quotes, a row of a dump, hex."""
    head = clean_head(line)
    first, end = head.end, len(line.rstrip())
    escapes = _ESCAPES.match(line, first)
    row = _OFFSET.match(line)
    if escapes is not None:
        # Blanks and commas between escapes are not bytes.
        found = _string(re.sub(r"(?<=\\x..)[\s,]+(?=\\x)", "", line[:end]), first, escapes.end(), "", head, start)
        yield (
            found
            if found.problem is None
            else found._replace(problem=f"{found.problem} is not an escape such as \\x0e")
        )
        return
    is_od = row is not None and len(row["offset"]) == 7 and not row["colon"]
    if row is not None and is_od and len(row["first"]) == 4:
        words = (
            f"column {row.start('first') + 1}: words of two bytes are in either order in a dump, use hexdump -C or xxd"
        )
        yield Found(start, start + end, head, b"", False, words, True)
        return
    is_row = row is not None and (row["colon"] or (len(row["first"]) == 2 and (row["blanks"] != " " or is_od)))
    if row is not None and is_row:
        first = row.start("first")
        column = _TEXT_COLUMN.search(line, first)
        found = _hex(line, 0, first, end if column is None else column.start(), head, start)
        if found.problem is not None and not int(row["offset"], 16):
            yield found._replace(is_marked=True)
        return
    if _ADDRESS.fullmatch(line, first, end) and not is_sure:
        return
    remark = _REMARK.search(line, first)
    stop = first + len(line[first : end if remark is None else remark.start()].rstrip(" \t\"'`])}>;,"))
    found = _hex(line, first, first, stop, head, start)
    text = line[first:stop]
    groups = _GROUP.findall(text)
    if found.problem is not None and not is_sure:
        # A line of bytes with one slip among them begins a frame; a log line has many digits and no words.
        strange = [group for group in groups if _HEX_GROUP.fullmatch(group) is None]
        is_short = len(strange) == 1 and strange[0].isalnum() and len(strange[0]) <= LEAST - 1
        size = sum((len(group) + 1) // 2 for group in groups)
        is_slip = is_short and len(found.data) >= LENGTH_FIELD and abs(frame_size(found.data) - size) <= LENGTH_FIELD
        is_log = head.is_log and sum(map(text.count, "0123456789abcdefABCDEF")) >= 8
        if _WORD.search(text) is not None or not (is_slip or is_log):
            return
        found = found._replace(is_marked=is_slip)
    elif found.problem is None and "-" not in text and is_nearly(found.data):
        # Nothing else is in the line: a frame that somebody made by hand, with a wrong length.
        found = found._replace(is_marked=True)
    if groups:
        yield found


def _hex(line: str, begin: int, start: int, end: int, head: Head, offset: int) -> Found:
    """Returns the groups of hex digits in line[start:end], up to the first that is something else."""
    text = line[start:end].rstrip(_SEPARATORS)
    cut = text.endswith(("...", "…"))
    groups = list(_GROUP.finditer(line, start, start + len(text.rstrip(_SEPARATORS + ".…") if cut else text)))
    digits, problem = "", None
    for group in groups:
        number = _HEX_GROUP.fullmatch(group[0])
        said = f"column {group.start() + 1}: {short(group[0])!r}"
        if number is None:
            strange = _NO_DIGIT.search(group[0]) if len(group[0]) > MOST_SHORT else None
            problem = f"{said} is not hex"
            if strange is not None:
                problem = f"column {group.start() + strange.start() + 1}: {strange[0]!r} is not a hex digit"
            break
        if number[1] and len(number[2]) > 2 and len(groups) > 1:
            problem = f"{said} is more than 255, which a byte cannot be"
            break
        part = number[2].zfill(2) if number[1] else number[2]
        digits += part[: len(part) & ~1]
        # Where the text was cut, half a byte at the end was cut, too.
        if len(part) % 2 and not (cut and group is groups[-1]):
            problem = f"{said} has an odd number of hex digits ({len(part)}), two make a byte"
            break
    return Found(offset + begin, offset + end, head, bytes.fromhex(digits), cut, problem)


def _string(line: str, begin: int, start: int, quote: str, head: Head, offset: int) -> Found:
    """Returns the characters and escapes of a string, or of escapes without quotes."""
    body = _BODY[quote or '"'].match(line, start)
    stop = start if body is None else body.end()
    is_closed = bool(quote) and line.startswith(quote, stop)
    cut = not is_closed and (line.endswith("...", start, stop) or _CUT.match(line, stop) is not None)
    text, problem = line[start:stop].rstrip(".") if cut else line[start:stop], None
    if not is_closed and not cut and stop < len(line):
        problem = f"column {stop + 1}: {short(line[stop : stop + 4])!r}" + " cannot be in a byte string" * bool(quote)
    elif not is_closed and not cut and quote:
        problem = f"column {stop + 1}: the string that starts at column {begin + 1} has no end"
    end = offset + (stop + 1 if quote else len(line))
    return Found(offset + begin, end, head, literal(text, is_decimal=False) or b"", cut, problem)


def _array(text: str, start: int, position: int, line_start: int, head: Head) -> Found:
    """Returns the array of numbers from there on, which may end in a later line."""
    data, problem, cut, is_closed, needs_comma = bytearray(), None, False, False, False
    while problem is None and not is_closed and (part := _PART.match(text, position)):
        kind, said, position = part.lastgroup, part[part.lastgroup or 0], part.end()
        if kind == "comma":
            needs_comma = False
        elif kind == "closer":
            is_closed = True
        elif kind == "ellipsis":
            cut = needs_comma = True
        elif kind == "comment":
            position = text.find("*/", position) + 2
            if position < 2:
                position, problem = part.end(), "the comment that starts here has no end"
        elif kind == "other":
            problem = f"{short(said)!r} is not a number"
        elif kind == "number" and needs_comma:
            problem = "a comma is missing"
        elif kind == "number":
            needs_comma, problem = True, _add(data, said)
        if problem is not None:
            line = text.count("\n", start, part.start())
            column = part.start() - max(text.rfind("\n", start, part.start()), line_start - 1)
            problem = f"line {line + 1}, " * bool(line) + f"column {column}: {problem}"
    if problem is None and not is_closed and not cut:
        problem = f"column {start - line_start + 1}: the array that starts here has no end"
    is_meant = problem is None or head.is_log or may_begin(data)
    is_open = not is_closed and position >= len(text)
    return Found(start, position, head, bytes(data) if is_meant else b"", cut, problem, is_open=is_open)


def _add(data: bytearray, digits: str) -> str | None:
    """Adds a number to an array; returns what is wrong with it."""
    base = {"0x": 16, "0b": 2}.get(digits[:2].lower(), 10)
    # Cut short: a few digits tell that it is too much, and Python refuses to read thousands of them.
    value = int((digits if base == 10 else digits[2:]).lstrip("0")[:9] or "0", base)
    if base == 10 and value > 7 and digits[0] == "0":
        return f"{digits[:9]} is octal in C and decimal to most readers, write it as 0x.."
    if value > 255:
        return f"{short(digits)} is more than 255, which a byte cannot be"
    data.append(value)
    return None
