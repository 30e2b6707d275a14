r"""Text that people paste -> the bytes of frames: log lines, hex, byte strings, arrays, dumps.

Nobody types a frame into a file of its own: frames come out of terminals, source code and bug reports. What is here
finds them there, line by line, and leaves prose alone. It knows how bytes are written and nothing of what they mean.

The forms, in the order in which a line is tried:

    dump            0000  0e 00 2a 00 80 00 00 94  01 01 82 b8 01 82 e8 03   ..*.............
    fromhex         bytes.fromhex("0e002a00...")
    string          b'\x0e\x00*\x00...'  and  "\x0e\x00*\x00..."
    escapes         \x0e\x00\x2a\x00...
    lesson          0x|0E:00|2A:00|80|00:00|94|01|01|82:B8:01|82:E8:03|
    array           { 0x0E, 0x00, 42, ... }  and  [14, 0, 42, ...], also over several lines
    bare hex        0E002A00..., with blanks, commas, colons, dashes, bars or 0x; nothing else may stand in the line

In front of each may stand a time and a word that tells the direction.
"""

from __future__ import annotations

import ast
import re
import warnings
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

Direction = Literal["sent", "received"]

# The shortest frame there is. Less than that in the midst of other text is not worth the risk of reading prose as hex.
_LEAST = 5
_MAX_TEXT = 200
_MAX_LINE = 1 << 20
_MAX_COLLECTED = 1 << 16


@dataclass(frozen=True, slots=True)
class Pasted:
    """One piece of pasted text and the bytes it stands for.

    data       the bytes; where `problem` is set, those in front of it
    line       where the piece starts in its source, the first line is 1
    text       the piece, stripped, at most 200 characters of it
    direction  "sent" or "received" (as the host sees it) where the text says so, else None
    time       as printed, such as "09:12:31.011558" or "2024-01-31T09:12:31Z"; None where the text has none
    cut        True where the text says that more bytes existed, by an ellipsis at its end
    problem    None, or a sentence that tells (with the column) why the piece could not be read whole
    """

    data: bytes
    line: int
    text: str
    direction: Direction | None
    time: str | None
    cut: bool
    problem: str | None


def read_text(lines: Iterable[str]) -> Iterator[Pasted]:
    """The frames in lines of text, in their order; whatever looks like none is passed over. Never raises of itself.

    Memory stays bounded: only an array or a dump that goes on over several lines is collected, up to 64 KiB of it.
    Lines of more than 1 MiB are not read, but reported.
    """
    yield from _Reader(_LEAST, is_sure=False).read(lines)


def read_argument(text: str) -> Pasted:
    """The bytes of one argument of a command line, which is taken to be meant as bytes, however few. Never raises.

    What cannot be read gives a `problem`, and so does a second piece in the same argument: `data` is the first.
    """
    lines = text.strip("\r\n").split("\n")
    if len(lines) == 1:
        pieces = list(_Reader(1, is_sure=True).read(lines))
    else:
        # Hex that was wrapped at the end of the line is one piece; a dump must not be joined, its offsets are no bytes.
        joined = " ".join(lines)
        if _dump_row(lines[0]) is None and len(joined) <= _MAX_LINE:
            for found in _bare(joined, _Wants(1, is_sure=False)):
                if found.problem is None:
                    return found.pasted(1, joined)
        pieces = list(_Reader(_LEAST, is_sure=False).read(lines))
    if not pieces:
        problem = "it is empty" if not text.strip() else "column 1: there are no bytes in it that could be read"
        return Pasted(b"", 1, _short(text, _MAX_TEXT), None, None, cut=False, problem=problem)
    first = pieces[0]
    if len(pieces) == 1 or first.problem is not None:
        return first
    problem = f"it has {len(pieces)} frames in it, of which only the first was read: give each an argument of its own"
    return Pasted(first.data, first.line, first.text, first.direction, first.time, first.cut, problem)


def _short(text: str, limit: int = 24) -> str:
    """The text stripped, and no longer than that, for showing it."""
    # Sliced first: the text may be a megabyte, of which nobody wants a copy.
    return text[: limit * 4].strip()[:limit].rstrip()


# --- what stands in front of the bytes


_CLOCK = r"(?:[01]\d|2[0-3]):[0-5]\d:[0-6]\d(?:[.,]\d{1,9})?"
_TIME = rf"(?<![\w:.])(?:\d{{4}}[-/]\d\d[-/]\d\d[T ]\s?)?{_CLOCK}(?:Z|\s?[+-]\d\d:?\d\d)?(?=[\])>:;,]?(?:\s|$))"
_SENT = r"sent|send|sending|sends|tx|write|writes|writing|wrote|written|request|command"
_RECEIVED = r"received|receive|receiving|receives|recv|rx|read|reads|reading|reply|response|answer"
_DIRECTION = (
    rf"(?P<sent>(?<![a-z])(?:{_SENT})(?![a-z])|(?<![<>=-])(?:->|-->|>>|→)(?![<>=-]))"
    rf"|(?P<received>(?<![a-z])(?:{_RECEIVED})(?![a-z])|(?<![<>=-])(?:<-|<--|<<|←)(?![<>=-]))"
)
# Words that loggers put beside the direction, and that therefore do not make a line prose.
_BESIDE = (
    r"(?P<beside>\b(?:debug|info|notice|warning|error|trace|data|raw|hex|frame|packet|payload|message"
    r"|bytearray|(?:\d{1,7}\s{1,4})?bytes?)\b)"
)

_TIME_SEARCH = re.compile(_TIME, re.ASCII)
_DIRECTION_SEARCH = re.compile(_DIRECTION, re.IGNORECASE)
_HEAD_PART = re.compile(
    rf"(?P<time>{_TIME})|{_DIRECTION}|{_BESIDE}|[\s\[({{\])}}\"'`:;,|]++|[<>=-]{{4,}}+|[<>=-]", re.IGNORECASE | re.ASCII
)


class _Head(NamedTuple):
    """What a line says in front of its bytes.

    end       the column (from 0) where the time and the words about the direction end
    said      the column where the last of these words ends; only brackets, quotes and the like follow up to `end`
    is_clean  True when nothing else stands in front of the bytes
    """

    direction: Direction | None
    time: str | None
    end: int
    said: int
    is_clean: bool

    @property
    def is_log(self) -> bool:
        """True for the beginning of a log line, behind which one may expect bytes."""
        return self.is_clean and (self.direction is not None or self.time is not None)


def _clean_head(line: str, start: int = 0) -> _Head:
    """The time and the direction at the start, as far as there is nothing else."""
    direction: Direction | None = None
    time: str | None = None
    position = said = start
    while match := _HEAD_PART.match(line, position):
        position = match.end()
        if match.lastgroup is None:
            continue
        said = position
        if match["time"] and time is None:
            time = match["time"]
        elif match["sent"]:
            direction = direction or "sent"
        elif match["received"]:
            direction = direction or "received"
    return _Head(direction, time, position, said, is_clean=True)


def _head(line: str, start: int, end: int, clean: _Head) -> _Head:
    """What stands in line[start:end]; `clean` is what _clean_head says from `start` on."""
    if end <= clean.end:
        return clean
    time = _TIME_SEARCH.search(line, start, end)
    word = _DIRECTION_SEARCH.search(line, start, end)
    direction: Direction | None = None
    if word is not None:
        direction = "sent" if word["sent"] else "received"
    return _Head(direction, time[0] if time else None, clean.end, clean.said, is_clean=False)


def _run(pattern: re.Pattern[str], text: str, start: int, end: int | None = None) -> int:
    """Where the run ends that starts there and consists of what the pattern matches."""
    match = pattern.match(text, start, len(text) if end is None else end)
    return start if match is None else match.end()


_NO_HEAD = _Head(None, None, 0, 0, is_clean=False)


# --- what the forms find


@dataclass(frozen=True, slots=True)
class _Found:
    """Bytes in line[start:end]."""

    start: int
    end: int
    head: _Head
    data: bytes
    cut: bool = False
    problem: str | None = None

    def pasted(self, number: int, line: str) -> Pasted:
        text = _short(line[self.start : self.end], _MAX_TEXT)
        return Pasted(self.data, number, text, self.head.direction, self.head.time, self.cut, self.problem)


class _Wants(NamedTuple):
    """What is worth reporting: the fewest bytes, and whether the text is known to be meant as bytes."""

    least: int
    is_sure: bool

    def takes(self, size: int, problem: str | None, head: _Head) -> bool:
        if problem is None:
            return size >= self.least
        return self.is_sure or head.is_log or size >= _LEAST


# --- hex digits, the part that several forms share


_GROUP = re.compile(r"[^\s,;:|\-]+")
_HEX_GROUP = re.compile(r"(0[xX])?([0-9a-fA-F]+)")
_SEPARATORS = " \t\r\n\f\v,;:|-"


def _hex(line: str, start: int, end: int, *, cut: bool) -> tuple[bytes, str | None]:
    """The bytes of the groups of hex digits in line[start:end], and what is wrong with the first group that is none.

    Where the text was cut, half a byte at the end was cut too and is no problem.
    """
    groups = list(_GROUP.finditer(line, start, end))
    digits: list[str] = []
    problem = None
    for group in groups:
        number = _HEX_GROUP.fullmatch(group[0])
        place = f"column {group.start() + 1}: {_short(group[0])!r}"
        if number is None:
            problem = f"{place} is no hex"
            break
        prefix, text = number.groups()
        if prefix and len(text) > 2 and len(groups) > 1:
            problem = f"{place} is more than 255, which a byte cannot be"
            break
        if prefix and len(text) == 1:
            text = "0" + text
        digits.append(text[: len(text) & ~1])
        if len(text) % 2:
            if not (cut and group is groups[-1]):
                problem = f"{place} has an odd number of hex digits ({len(text)}), two make a byte"
            break
    return bytes.fromhex("".join(digits)), problem


def _cut_off(line: str, start: int, end: int) -> tuple[int, bool]:
    """The end without the ellipsis and the separators that stand there, and whether there was an ellipsis."""
    text = line[start:end].rstrip(_SEPARATORS)
    if text.endswith(("...", "…")):
        return start + len(text.rstrip(_SEPARATORS + ".…")), True
    return start + len(text), False


# --- bare hex


_REMARK = re.compile(r"\s(?:#|//)")
_WORD = re.compile(r"(?<![^\W_])[a-zA-Z]{3,}(?![^\W_])")
_HEX_DIGIT = re.compile(r"[0-9a-fA-F]")


def _bare(line: str, wants: _Wants) -> Iterator[_Found]:
    """Hex digits that, with a time and a direction, are the whole line."""
    head = _clean_head(line)
    start = head.end
    remark = _REMARK.search(line, start)
    text = line[start : remark.start() if remark is not None else None]
    end, cut = _cut_off(line, start, start + len(text.rstrip(" \t\"'`])}>;,")))
    if start >= end:
        return
    data, problem = _hex(line, start, end, cut=cut)
    if wants.is_sure:
        is_meant = True
    elif problem is None:
        is_meant = not _is_words(line[start:end])
    else:
        is_meant = head.is_log and _is_nearly_hex(line[start:end])
    if is_meant and wants.takes(len(data), problem, head):
        yield _Found(start, end, head, data, cut, problem)


def _is_words(text: str) -> bool:
    """True for words that happen to be spelled with the letters a to f, such as "decade facade"."""
    groups = _GROUP.findall(text)
    return (
        len(groups) > 1 and text.upper() != text and all(map(str.isalpha, groups)) and any(len(g) > 2 for g in groups)
    )


def _is_nearly_hex(text: str) -> bool:
    """True when somebody must have meant hex: many digits and not a word among them."""
    return _WORD.search(text) is None and len(_HEX_DIGIT.findall(text)) >= 8


# --- the lesson's form


_LESSON_START = re.compile(r"0[xX]\|")
_LESSON_FRAME = re.compile(r"0[xX]\|[0-9a-fA-F]{2}:[0-9a-fA-F]{2}\|[0-9a-fA-F]{2}:[0-9a-fA-F]{2}\|[0-9a-fA-F]{2}")
_LESSON_REST = re.compile(r"[0-9a-fA-F\s:|.…]*+$")
_LESSON_RUN = re.compile(r"[^\s\"'`()<>,;]*+")


def _lesson(line: str, wants: _Wants) -> Iterator[_Found]:
    """`0x|0E:00|2A:00|80|...|`. The lesson writes single values so too: among prose it must start as frames do."""
    position = 0
    while opening := _LESSON_START.search(line, position):
        head = _head(line, position, opening.start(), _clean_head(line, position))
        first = opening.end()
        # Blanks may stand between the groups when nothing else follows.
        stop = len(line) if _LESSON_REST.match(line, first) else _run(_LESSON_RUN, line, first)
        if line.endswith("|.", first, stop):
            stop -= 1
        end, cut = _cut_off(line, first, stop)
        data, problem = _hex(line, first, end, cut=cut)
        is_frame = head.is_clean or _LESSON_FRAME.match(line, opening.start()) is not None
        if is_frame and wants.takes(len(data), problem, head):
            yield _Found(opening.start(), stop, head, data, cut, problem)
        position = stop


# --- strings


_STRING_START = re.compile(r"(?<!\w)b(?P<bytes>[\"'])|(?P<text>[\"'])(?=[ -~]?\\x)")
_ESCAPE = r"\\(?:x[0-9a-fA-F]{2}|[0-3]?[0-7]{1,2}|[ -/89:-wy-~])"
_STRING_BODY = {
    "'": re.compile(rf"(?:[ -&(-\[\]-~]|{_ESCAPE})*+"),
    '"': re.compile(rf"(?:[ !#-\[\]-~]|{_ESCAPE})*+"),
}
# An ellipsis that may have cut an escape in two.
_CUT_STRING = re.compile(r"(?:\\x?[0-9a-fA-F]?)?(?:\.{3}|…)")


def _evaluated(quote: str, body: str) -> bytes | None:
    """What Python makes of the body of a byte string; None where it makes nothing of it."""
    try:
        with warnings.catch_warnings():
            # An unknown escape such as \d stands for itself. That is no news to somebody who reads a log.
            warnings.simplefilter("ignore")
            value = ast.literal_eval(f"b{quote}{body}{quote}")
    except (ValueError, SyntaxError, MemoryError, RecursionError):
        return None
    return value if isinstance(value, bytes) else None


def _strings(line: str, wants: _Wants) -> Iterator[_Found]:
    """Byte strings of Python, and strings of any language that begin with an escape."""
    position = 0
    while opening := _STRING_START.search(line, position):
        head = _head(line, position, opening.start(), _clean_head(line, position))
        quote = opening["bytes"] or opening["text"]
        position = stop = _run(_STRING_BODY[quote], line, opening.end())
        text = line[opening.end() : stop]
        cut, problem = False, None
        if line.startswith(quote, stop):
            position = stop + 1
        elif text.endswith("...") or _CUT_STRING.match(line, stop):
            cut, text = True, text.rstrip(".")
        elif stop < len(line):
            problem = f"column {stop + 1}: {_short(line[stop : stop + 4])!r} cannot stand in a byte string"
        else:
            problem = f"column {stop + 1}: the string that starts at column {opening.start() + 1} has no end"
        # Source code has many byte strings; one without any escape is a text and no frame, whose length is never text.
        if not head.is_clean and "\\" not in text:
            continue
        data = _evaluated(quote, text)
        if data is None:
            data, problem = b"", f"column {opening.start() + 1}: this is no byte string that Python could read"
        if wants.takes(len(data), problem, head):
            yield _Found(opening.start(), position, head, data, cut, problem)


_FROMHEX = re.compile(r"\b(?:fromhex|unhexlify)\(\s{0,8}b?([\"'])([^\"']*+)")


def _fromhex(line: str, wants: _Wants) -> Iterator[_Found]:
    """`bytes.fromhex("0e00...")` and `binascii.unhexlify(...)`."""
    start = 0
    for match in _FROMHEX.finditer(line):
        end, cut = _cut_off(line, match.start(2), match.end(2))
        data, problem = _hex(line, match.start(2), end, cut=cut)
        head = _head(line, start, match.start(), _clean_head(line, start))
        if wants.takes(len(data), problem, head):
            yield _Found(match.start(), match.end(), head, data, cut, problem)
        start = match.end()


_ESCAPES_START = re.compile(r"b?(?=[ -~]?\\x[0-9a-fA-F]{2})")
_ESCAPES_ONLY = re.compile(r"(?:\\x[0-9a-fA-F]{2}[\s,]*+)+")


def _escapes(line: str, wants: _Wants) -> Iterator[_Found]:
    r"""`\x0e\x00*\x00` without quotes, or with the b that is left of a byte string when the shell took its quotes."""
    head = _clean_head(line)
    opening = _ESCAPES_START.match(line, head.end)
    if opening is None:
        return
    first = opening.end()
    end, cut, problem = first + len(line[first:].rstrip()), False, None
    if _ESCAPES_ONLY.fullmatch(line, first, end):
        data = bytes.fromhex("".join(re.findall(r"x(..)", line[first:end])))
    else:
        stop = _run(_STRING_BODY['"'], line, first, end)
        text = line[first:stop]
        if text.endswith("...") or _CUT_STRING.match(line, stop):
            cut, text = True, text.rstrip(".")
        elif stop < end:
            problem = f"column {stop + 1}: {_short(line[stop : stop + 4])!r} is no escape such as \\x0e"
        data = _evaluated('"', text) or b""
    if wants.takes(len(data), problem, head):
        yield _Found(opening.start(), end, head, data, cut, problem)


# --- arrays


_OPENING = re.compile(r"[\[{]")
_ARRAY_PART = re.compile(
    r"(?P<blank>\s++)|(?P<comma>,)|(?P<remark>//.*+|#.*+)|(?P<comment>/\*)|(?P<ellipsis>\.{3}|…)"
    r"|(?P<number>0[xX][0-9a-fA-F]+|0[bB][01]+|\d+)[uU]?(?!\w|\.\d)|(?P<closer>[\]}])|(?P<other>[^\s,\]}]{1,32})",
    re.ASCII | re.DOTALL,
)

_State = Literal["open", "closed", "broken"]


@dataclass(slots=True)
class _Array:
    """An array of numbers while it is read, which may take several lines."""

    line: int
    column: int
    head: _Head
    data: bytearray = field(default_factory=bytearray)
    cut: bool = False
    problem: str | None = None
    text: str = ""
    size: int = 0
    needs_comma: bool = False
    count: int = 0

    def feed(self, text: str, position: int, number: int) -> tuple[_State, int]:
        """Reads on at text[position]; tells what has become of the array and how far the text was read."""
        start = position
        state: _State = "open"
        while state == "open" and (part := _ARRAY_PART.match(text, position)):
            position = part.end()
            match part.lastgroup:
                case "comma":
                    self.needs_comma = False
                case "comment":
                    close = text.find("*/", position)
                    # A comment that goes on over lines would hide frames from us if it were none.
                    state, position = ("broken", len(text)) if close < 0 else ("open", close + 2)
                case "closer":
                    state = "closed"
                case "number" | "ellipsis" | "other":
                    if not self._item(part, number):
                        state, position = "broken", part.start()
                    self.needs_comma = True
        if state == "open" and self.cut:
            state = "closed"
        self.size += position - start + 1
        if len(self.text) < _MAX_TEXT:
            first = start if self.text else self.column
            last = position if state == "closed" else len(text)
            self.text = f"{self.text}\n{_short(text[first : min(last, first + 2 * _MAX_TEXT)], _MAX_TEXT)}"
        return state, position

    def _item(self, part: re.Match[str], number: int) -> bool:
        """Takes a number or an ellipsis. Where it is neither, or no byte, `problem` tells and the answer is False."""
        where = f"column {part.start() + 1}" if number == self.line else f"line {number}, column {part.start() + 1}"
        if part["ellipsis"]:
            self.cut = True
            return True
        digits = part["number"]
        if not digits or self.needs_comma:
            self.problem = (
                f"{where}: {_short(part[0])!r} is no number" if not digits else f"{where}: a comma is missing"
            )
            return False
        self.count += 1
        value = _value(digits)
        if value is None:
            self.problem = f"{where}: {digits[:9]} is octal in C and decimal to most readers, write it as 0x.."
        elif value > 255:
            self.problem = f"{where}: {_short(digits)} is more than 255, which a byte cannot be"
        elif self.size <= _MAX_COLLECTED:
            self.data.append(value)
            return True
        else:
            # Read on all the same: what follows is no hex on lines of its own.
            self.problem = f"{where}: the array goes on after {_MAX_COLLECTED // 1024} KiB of text, which is too much"
            return True
        return False

    def pasted(self, state: _State) -> Pasted:
        """The array as far as it was read."""
        problem = self.problem
        if problem is None and state != "closed":
            problem = f"column {self.column + 1}: the array that starts here has no end"
        text = _short(self.text, _MAX_TEXT)
        return Pasted(bytes(self.data), self.line, text, self.head.direction, self.head.time, self.cut, problem)

    def wanted(self, state: _State, wants: _Wants) -> bool:
        """Whether it is worth reporting."""
        problem = None if state == "closed" else "not closed"
        return self.count > 0 and wants.takes(self.count, self.problem or problem, self.head)


def _value(digits: str) -> int | None:
    """The number (256 for all that are larger), or None where a leading zero may make it octal."""
    if digits[:2] in ("0x", "0X"):
        return int(digits[2:].lstrip("0")[:3] or "0", 16)
    if digits[:2] in ("0b", "0B"):
        return int(digits[2:].lstrip("0")[:9] or "0", 2)
    # Cut short: four digits tell that it is too much, and Python refuses to read thousands of them.
    value = int(digits.lstrip("0")[:4] or "0")
    return None if value > 7 and digits[0] == "0" else value


# --- dumps


_DUMP_START = re.compile(r"\s*+(?:0[xX])?(?P<offset>[0-9a-fA-F]{4,16})(?P<colon>:?)(?P<blanks>\s++)(?=[0-9a-fA-F]{2})")
_DUMP_GROUP = re.compile(r"(?:[0-9a-fA-F]{2}){1,8}(?!\S)")
_DUMP_BLANKS = re.compile(r"\s*+")


class _Row(NamedTuple):
    """One line of a dump. An offset of seven digits without a colon is od's, which counts in octal."""

    offset: int
    data: bytes
    problem: str | None


def _dump_row(line: str) -> _Row | None:
    """The line as a line of a dump; None where it is none."""
    opening = _DUMP_START.match(line)
    if opening is None:
        return None
    offset, position = opening["offset"], opening.end()
    first = _run(_DUMP_GROUP, line, position) - position
    is_od = len(offset) == 7 and not opening["colon"]
    if is_od and first == 4:
        words = f"column {position + 1}: words of two bytes stand in either order in a dump, use hexdump -C or xxd"
        return _Row(int(offset, 16), b"", words)
    # Hex in groups looks nearly the same: only a colon, two blanks or an odd width tell that it is an offset.
    is_offset = opening["colon"] or (first == 2 and (opening["blanks"] != " " or len(offset) in (6, 7)))
    if not is_offset or first == 0:
        return None
    groups: list[str] = []
    count = 0
    problem: str | None = None
    while group := _DUMP_GROUP.match(line, position):
        groups.append(group[0])
        count += len(group[0]) // 2
        position = _run(_DUMP_BLANKS, line, group.end())
        blanks = position - group.end()
        # One blank between groups, one more in the middle; behind any wider gap stands the text column.
        if blanks != 1 and not (blanks == 2 and count == 8):
            break
    else:
        if position < len(line) and line[position] != "|":
            problem = f"column {position + 1}: {_short(line[position : position + 8])!r} is no hex"
    is_octal = is_od and offset.isdigit() and not set(offset) & set("89")
    return _Row(int(offset, 8 if is_octal else 16), bytes.fromhex("".join(groups)), problem)


@dataclass(slots=True)
class _Dump:
    """Lines of a dump whose offsets follow each other."""

    line: int
    text: str
    offset: int
    data: bytearray
    problem: str | None

    def takes(self, line: str, number: int) -> bool:
        """Takes the line if it goes on with the dump. Behind a problem it takes whatever has a higher offset."""
        if line.strip() == "*":
            self.problem = self.problem or f"line {number}: the dump leaves lines out here, as the * tells"
            return True
        row = _dump_row(line)
        if row is None or row.offset <= self.offset:
            return False
        if self.problem is None:
            if row.offset != self.offset + len(self.data):
                return False
            self.data += row.data
            if row.problem is not None:
                self.problem = f"line {number}, {row.problem}"
            elif len(self.data) > _MAX_COLLECTED:
                self.problem = f"the dump is longer than {_MAX_COLLECTED // 1024} KiB"
        if len(self.text) < _MAX_TEXT:
            self.text = f"{self.text}\n{_short(line, _MAX_TEXT)}"
        return True

    def pasted(self) -> Pasted:
        """The lines as one piece."""
        return Pasted(bytes(self.data), self.line, _short(self.text, _MAX_TEXT), None, None, False, self.problem)


# --- the forms together


_FORMS: tuple[Callable[[str, _Wants], Iterator[_Found]], ...] = (_fromhex, _strings, _escapes, _lesson)


class _Reader:
    """Reads line after line and keeps the array or the dump that is not yet at its end."""

    def __init__(self, least: int, *, is_sure: bool) -> None:
        self._wants = _Wants(least, is_sure)
        self._array: _Array | None = None
        self._dump: _Dump | None = None

    def read(self, lines: Iterable[str]) -> Iterator[Pasted]:
        """All pieces in the lines."""
        for number, line in enumerate(lines, 1):
            if len(line) > _MAX_LINE:
                yield from self._end()
                problem = f"the line has {len(line)} characters, more than {_MAX_LINE}, and was not read"
                yield Pasted(b"", number, _short(line, _MAX_TEXT), None, None, cut=False, problem=problem)
            else:
                yield from self._line(number, line.rstrip("\r\n"))
        yield from self._end()

    def _end(self) -> Iterator[Pasted]:
        """What was being collected, as far as it came."""
        array, self._array = self._array, None
        dump, self._dump = self._dump, None
        if array is not None and array.wanted("open", self._wants):
            yield array.pasted("open")
        if dump is not None and self._wants.takes(len(dump.data), dump.problem, _NO_HEAD):
            yield dump.pasted()

    def _line(self, number: int, line: str) -> Iterator[Pasted]:
        if self._dump is not None:
            if self._dump.takes(line, number):
                return
            yield from self._end()
        position = 0
        if self._array is not None:
            array, self._array = self._array, None
            state, position = array.feed(line, 0, number)
            yield from self._after(array, state)
            if state == "open":
                return
            if state == "broken":
                position = 0
        if position == 0:
            if not line.strip() or line.lstrip().startswith(("#", "//")):
                return
            row = _dump_row(line)
            if row is not None and (row.problem is None or row.offset == 0):
                self._dump = _Dump(number, line, row.offset, bytearray(row.data), row.problem)
                return
            for form in _FORMS:
                found = list(form(line, self._wants))
                if found:
                    yield from (piece.pasted(number, line) for piece in found)
                    return
        yield from self._arrays(number, line, position)

    def _arrays(self, number: int, line: str, position: int) -> Iterator[Pasted]:
        """The arrays in the line; where there is none, the line may be bare hex."""
        may_be_bare = position == 0
        start = position
        clean = _clean_head(line, start)
        # A time may stand in brackets too.
        position = clean.said
        pieces: list[Pasted] = []
        while opening := _OPENING.search(line, position):
            column, position = opening.start(), opening.end()
            is_clean = column < clean.end
            # A list in square brackets must be a value of something: prose has lists of references.
            before = line[max(0, column - 8) : column].rstrip()[-1:]
            if opening[0] == "[" and not is_clean and (not before or before not in "=(:,[{"):
                continue
            array = _Array(number, column, clean if is_clean else _NO_HEAD)
            state, position = array.feed(line, position, number)
            if state == "open" or array.wanted(state, self._wants):
                may_be_bare = may_be_bare and state == "broken"
                array.head = _head(line, start, column, clean)
                start = position
                clean = _clean_head(line, start)
            pieces += self._after(array, state)
        if may_be_bare:
            # Hex in brackets without 0x breaks off as an array at its first letter.
            bare = [found.pasted(number, line) for found in _bare(line, self._wants)]
            if not pieces or (bare and bare[0].problem is None):
                pieces = bare
        yield from pieces

    def _after(self, array: _Array, state: _State) -> Iterator[Pasted]:
        """Keeps the array, reports it or drops it."""
        if state == "open":
            self._array = array
        elif array.wanted(state, self._wants):
            yield array.pasted(state)
