r"""Bytes that are not a frame and were meant as one: a wrong length or type, a slip such as `G8`, a piece that was cut.

A wrong frame is given out as its bytes, so that `decode` and `check` name its fault. A slip is named with its column,
and the bytes in front of it are given out.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

from ev3proto.schema.header import frame_size
from ev3proto.tables.frame import REPORT_SIZES
from ev3proto.text.paste.frames import HASHES, LOOKS, bare_reason, is_prose, is_wrong_frame, may_begin
from ev3proto.text.paste.notations import BASE64, NUMBERS, STRINGS
from ev3proto.text.paste.pieces import LEAST, clean_head, head_before, short
from ev3proto.text.paste.readings import Part, Run, starts_of
from ev3proto.text.paste.strangers import strange_bytes
from ev3proto.text.paste.values import MISSPELT, READINGS, UNLIKELY, WIDTH

AROUND = " \t\r\n\f\v,;:|+&/\\\"'`<>()[]{}_-="
"""What may be around bytes that are alone in a line."""

_OPENERS, _CLOSERS = frozenset("[({<\"'`"), frozenset("])}>\"'`")
_MOST_STARTS = 8
_OPENS = re.compile(r"[\[{][\s'\"]*(?:\([\w ]+\)\s?)?$")
_IS_INDEX = re.compile(r"\w+\s?\]")
_LESSON = re.compile(r"0[xX]\|")
_CUT = re.compile(r"(?:\\?x?[0-9a-fA-F])?[\s:|,\"']{0,4}(?:\.{3}|\u2026)")
_NEXT = re.compile(r"[\s,:;|-]*+(?P<word>[^\s,:;|\"'`\[\](){}<>]+)")
_REMARK = re.compile(r"\s*(?://|#|;|=|/\*)")
_BYTES = re.compile(r"(?<!\w)(?:0x)?[0-9a-fA-F]{2}(?!\w)|\\x[0-9a-fA-F]{2}")
_ADDRESS = re.compile(r"(?:[0-9a-fA-F]{2}[:-]){5}[0-9a-fA-F]{2}(?![:-])")
_OPEN_STRING = re.compile(
    r"""
    (?: (?<!\w)b )? (?P<quote>["']) (?= [^"'\\]*\\[xX0-3] )
    (?P<body> (?: (?!(?P=quote)) [^\\] | \\. )*? )
    (?P<cut> (?: \\x?[0-9a-fA-F]? )? (?: \.{3} | \u2026 ) )? $
    """,
    re.VERBOSE,
)
"""A string without its second quote: its bytes, and the ellipsis at which it was cut."""
_STRACE = re.compile(r"\b(?:write|send|sendto|read|recv|recvfrom)\(\d")
_NSDATA = re.compile(r"\{length = \d+, bytes = |(?<![\w<])<[0-9a-f]{8} ")
_MOST_WORD = 4
_MOST_AROUND = 120


class Near(NamedTuple):
    """Bytes that are not a frame.

    place    the line, the column where they begin and that after their end
    data     the bytes
    problem  what is wrong with the text, as a sentence
    cut      the text says that more bytes existed
    note     who cut it
    is_strange  `problem` says what they are instead
    """

    place: tuple[int, int, int]
    data: bytes
    problem: str | None = None
    cut: bool = False
    note: str | None = None
    is_strange: bool = False


def wrong_frame(run: Run, line: str, *, is_row: bool) -> Near | None:
    """Returns a run as the frame that it was meant as; None where it does not begin like one.

    Args:
        run: Values that are not a frame.
        line: The line with them.
        is_row: They are the values of several lines, or there is nothing else in the line.
    """
    if not run.tokens or run.starts_with_name or (len(run.tokens) == 1 and len(run.tokens[0]) <= 3):
        return None
    is_alone = is_row or _is_alone(run, line)
    is_bare = run.notation is NUMBERS and 0 not in run.widths
    parts = [part for one in run.readings for part in one.parts if len(part.data) >= LEAST]
    for is_strict, part in product((True, False), parts):
        is_decimal = is_strict or part.name in UNLIKELY or part.name == "base64" or (is_bare and part.name == "decimal")
        is_decimal = is_decimal or (is_bare and 1 in run.widths and all(map(str.isdecimal, run.tokens)))
        owners = part.owners(run)
        for start in _starts(run, part, line, owners):
            end = start + 1
            while end < len(part.data) and (is_alone or owners[end] == owners[end - 1] or owners[end] not in run.edges):
                end += 1
            data = part.data[start:end]
            place = *run.place(owners[start])[:2], run.place(owners[end - 1])[2]
            is_all = is_alone and start == 0 and end == len(part.data) and 1 not in run.widths
            if is_all and run.notation is NUMBERS and (said := strange_bytes(data)):
                return Near(place, b"", said, is_strange=True)
            if len(data) < LOOKS:
                continue
            if part.name == "words" and data[-1:] == b"\0" and frame_size(data) < len(data):
                data = data[:-1]
            if end == len(part.data) and run.check_sum is not None and data[-1] == run.check_sum:
                data = data[:-1]
            if len(part.data) in REPORT_SIZES:
                data = data.rstrip(b"\0")
            if is_wrong_frame(data, is_alone=is_alone, is_decimal=is_decimal):
                if frame_size(data) > len(data) and end == len(part.data) and not is_row:
                    return _broken(run, part._replace(data=data), line)._replace(place=place)
                return Near(place, data)
    return None


def _starts(run: Run, part: Part, line: str, owners: Sequence[int]) -> list[int]:
    """Returns the offsets at which a frame may begin: in an array where it opens, otherwise at any edge."""
    starts = [at for at in starts_of(run, part) if at < len(part.data)][:_MOST_STARTS]
    for at in starts:
        number, column, _ = run.place(owners[at])
        if (
            number == run.number
            and _OPENS.search(line, max(0, column - _MOST_AROUND), column)
            and not _IS_INDEX.match(line, column)
        ):
            return [at]
    return starts


def _is_alone(run: Run, line: str) -> bool:
    """Returns whether a run is a literal, an array, or all of a line but for what introduces it."""
    if run.notation is not NUMBERS:
        return True
    start = max(0, run.start - _MOST_AROUND)
    before, after = line[start : run.start], line[run.end : run.end + _MOST_AROUND].lstrip(" ,;|:")
    if not before.strip(AROUND) and (not after.strip(AROUND) or _REMARK.match(after)):
        return True
    if run.widths == {0} and not after.strip(AROUND):
        return True
    if after[:1] in _CLOSERS and not _OPENERS.isdisjoint(before):
        return True
    return head_before(line, start, run.start).direction is not None


def bare(run: Run, line: str) -> Near | None:
    """Returns what a line of nothing but bytes is without its header; None for other lines."""
    is_dull = len(run.tokens) > 1 and len({*run.tokens}) < LEAST - 1
    is_counted = run.widths != {2} and all(map(str.isdecimal, run.tokens))
    if run.notation is BASE64 or 1 in run.widths or run.starts_with_name or is_dull or is_counted:
        return None
    if (line[: run.start] + line[run.end :]).strip(AROUND):
        return None
    data = run.likely_data()
    is_hash = data is not None and (len(data) == 6 or (len(run.tokens) == 1 and len(data) in HASHES))
    problem = None if data is None or is_hash else bare_reason(data)
    return None if problem is None else Near((run.number, run.start, run.end), b"", problem)


def broken(run: Run, line: str, *, is_sure: bool) -> Near | None:
    """Returns a piece that breaks off, or that is shorter than a frame; None where it may be anything.

    Args:
        run: Values.
        line: The line with them.
        is_sure: They are known to be meant as bytes, however few.
    """
    head = clean_head(line)
    lesson = _LESSON.search(line)
    # Bytes are expected after the lesson's mark, and after what a log says in front of them.
    is_lesson = lesson is not None and lesson.start() <= head.end <= lesson.end()
    is_first = run.start <= max(head.end, lesson.end() if lesson and is_lesson else 0)
    if is_lesson and lesson is not None and not is_first and not line[lesson.end() : run.start].isspace():
        word = line[lesson.end() : run.start].strip(AROUND)
        return Near((run.number, lesson.start(), run.end), b"", f"column {lesson.end() + 1}: {_not_a_byte(word)}")
    if _ADDRESS.match(line, run.start) and not is_sure:
        return None
    if not run.names:
        return None
    near = _broken(run, _longest(run), line)
    if is_prose(near.data) and near.data and not is_sure and not is_lesson:
        return None
    is_log = is_first and head.is_log and head.direction is not None
    if near.problem is not None:
        is_worth = len(near.data) >= LEAST - 1 and may_begin(near.data) and not _is_counted(run, near.data)
        is_listed = not {1, 3} & run.widths or line[: run.start].rstrip().endswith(tuple(_OPENERS))
        is_number = len(run.tokens) == 1 and run.tokens[0].isdecimal()
        is_meant = (is_first and head.is_log and bool(near.data) and is_listed and not is_number) or is_lesson
        return near if is_sure or is_worth or is_meant else None
    is_end = near.cut or not line[run.end :].strip(AROUND)
    is_log = is_log and not {1, 3} & run.widths
    is_meant = is_sure or (is_end and len(near.data) >= 2 and ((is_first and is_lesson) or is_log))
    is_array = _is_alone(run, line) and not _is_counted(run, near.data)
    is_meant = is_meant or ((near.cut or is_array) and len(near.data) >= LEAST and may_begin(near.data))
    return near if is_meant and near.data else None


def _is_counted(run: Run, data: bytes) -> bool:
    """Returns whether bytes are rather small numbers, which code has for everything."""
    return bool({1, 3} & run.widths) and data[LEAST - 1 :] < b"\x80"


def _longest(run: Run) -> Part:
    """Returns the reading that gives bytes for the most values from the first on."""
    names = [name for name in run.names if name not in UNLIKELY] or run.names
    found = [Part(name, 0, len(run.tokens), b"", []) for name in names]
    for place, part in enumerate(found):
        pieces = []
        for token in run.tokens:
            data = READINGS[part.name][token]
            if data is None:
                break
            pieces.append(data)
        found[place] = part._replace(last=len(pieces), data=b"".join(pieces))
    return max(found, key=lambda part: part.last)


def _broken(run: Run, part: Part, line: str) -> Near:
    """Returns the bytes of a run up to the first value that has none, or to what follows the run."""
    number, start, _ = run.place(part.first)
    data, problem, cut, end, note = part.data, None, False, run.end, None
    if part.last < len(run.tokens):
        token = run.tokens[part.last]
        number_of_bad, column, end = run.place(part.last)
        if run.notation is STRINGS and (slip := MISSPELT.search(token)):
            at = slip.start("escape")
            data += READINGS["string"][token[:at] + (token[-1] if token[-1] in "\"'`" else "")] or b""
            column, problem = column + at, _not_a_byte(slip["escape"])
        else:
            digits = token[: len(token) & ~1]
            data += bytes.fromhex(digits) if WIDTH[token] > 1 and len(token) > 3 else b""
            problem = _not_a_byte(token)
        where = f"line {number_of_bad - number + 1}, " if number_of_bad != number else ""
        return Near((number, start, end), data, f"{where}column {column + 1}: {problem}")
    if found := _CUT.match(line, run.end):
        cut, end, note = True, found.end(), _who_cut(line)
        if WIDTH[run.tokens[-1]] == 1 and len(run.tokens) > 1 and WIDTH[run.tokens[-2]] == 2:
            # Half a byte.
            data = data[:-1]
    elif (found := _NEXT.match(line, run.end)) and not _REMARK.match(line, run.end):
        word = found["word"]
        is_closed = run.notation is STRINGS and run.tokens[-1][-1] in "\"'`"
        is_short = (len(word) <= _MOST_WORD or word.startswith("0x")) and not is_closed
        is_among = is_short and (_BYTES.search(line, found.end()) or len(word) == len(run.tokens[-1]))
        if is_among or word[:2] in ("\\x", "\\X"):
            problem = f"column {found.start('word') + 1}: {_not_a_byte(word, is_hex=0 not in run.widths)}"
    return Near((number, start, end), data, problem, cut, note)


def _not_a_byte(word: str, *, is_hex: bool = True) -> str:
    """Returns what is wrong with a value, as a sentence."""
    digits = word.removeprefix("0x").removeprefix("0X")
    has_digits = not digits.strip("0123456789abcdefABCDEF")
    if word[:2] in ("\\x", "\\X"):
        return f"{word[:4]!r} is not an escape: two hex digits follow \\x"
    if (word.isdecimal() and len(word) == 3) or (has_digits and digits != word):
        return f"{short(word)!r} is more than 255, which a byte cannot be"
    if has_digits and len(digits) % 2:
        return f"{short(word)!r} has an odd number of hex digits ({len(digits)}); two make a byte"
    return f"{short(word)!r} is not {'hex' if is_hex else 'a number'}"


def unclosed(line: str, number: int) -> Near | None:
    """Returns the bytes of a string without its second quote, which was cut or forgotten."""
    found = _OPEN_STRING.search(line)
    if found is None:
        return None
    data = READINGS["string"][found["body"]] if found["body"] else None
    if not data or not (may_begin(data) or ((head := clean_head(line)).is_log and head.direction)):
        return None
    problem = None if found["cut"] else f"column {found.start() + 1}: the string that starts here never ends"
    return Near((number, found.start(), found.end()), data, problem, found["cut"] is not None)


def _who_cut(line: str) -> str | None:
    """Returns who cut the bytes of a line, and how to get all of them."""
    if _STRACE.search(line):
        return "strace cut the string; -s 1024 shows all of it"
    if _NSDATA.search(line):
        return "the description of NSData is cut in the middle; print each byte"
    return None
