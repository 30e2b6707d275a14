r"""Byte strings, as Python prints them and C and the shell take them: characters and escapes such as \x0e.

Python itself says what the escapes mean. What is here finds where a string ends, also where a log cut it.
"""

from __future__ import annotations

import ast
import re
import warnings
from collections.abc import Iterator

from ev3proto.text.late_pattern import late_pattern
from ev3proto.text.paste.head import clean_head, head_before
from ev3proto.text.paste.pieces import Found, short

_START = late_pattern(r"(?<!\w)b(?P<bytes>[\"'])|(?P<text>[\"'])(?=[ -~]?\\x)")
_ESCAPE = r"\\(?:x[0-9a-fA-F]{2}|[0-3]?[0-7]{1,2}|[ -/89:-wy-~])"
_BODY = {
    "'": late_pattern(rf"(?>(?:[ -&(-\[\]-~]|{_ESCAPE})*)"),
    '"': late_pattern(rf"(?>(?:[ !#-\[\]-~]|{_ESCAPE})*)"),
}
# An ellipsis that may have cut an escape in two.
_CUT = late_pattern(r"(?:\\x?[0-9a-fA-F]?)?(?:\.{3}|…)")

_ESCAPES_START = late_pattern(r"b?(?=[ -~]?\\x[0-9a-fA-F]{2})")
_ESCAPES_ONLY = late_pattern(r"(?:\\x[0-9a-fA-F]{2}[\s,]*+)+")


def strings(line: str) -> Iterator[Found]:
    """Byte strings of Python, and strings of any language that begin with an escape."""
    position = 0
    while opening := _START.search(line, position):
        head = head_before(line, position, opening.start())
        quote = opening["bytes"] or opening["text"]
        position = stop = _body_end(quote, line, opening.end(), len(line))
        text = line[opening.end() : stop]
        cut, problem = False, None
        if line.startswith(quote, stop):
            position = stop + 1
        elif _is_cut(line, text, stop):
            cut, text = True, text.rstrip(".")
        elif stop < len(line):
            problem = f"column {stop + 1}: {short(line[stop : stop + 4])!r} cannot stand in a byte string"
        else:
            problem = f"column {stop + 1}: the string that starts at column {opening.start() + 1} has no end"
        # Source code has many byte strings; one without any escape is a text and no frame, whose length is never text.
        if not head.is_clean and "\\" not in text:
            continue
        data = _evaluated(quote, text)
        if data is None:
            data, problem = b"", f"column {opening.start() + 1}: this is no byte string that Python could read"
        yield Found(opening.start(), position, head, data, cut, problem)


def escapes(line: str) -> Iterator[Found]:
    r"""`\x0e\x00*\x00` without quotes, or with the b that is left of a byte string when the shell took its quotes."""
    head = clean_head(line)
    opening = _ESCAPES_START.match(line, head.end)
    if opening is None:
        return
    first, end = opening.end(), len(line.rstrip())
    cut, problem = False, None
    if _ESCAPES_ONLY.fullmatch(line, first, end):
        data = bytes.fromhex("".join(re.findall(r"x(..)", line[first:end])))
    else:
        stop = _body_end('"', line, first, end)
        text = line[first:stop]
        if _is_cut(line, text, stop):
            cut, text = True, text.rstrip(".")
        elif stop < end:
            problem = f"column {stop + 1}: {short(line[stop : stop + 4])!r} is no escape such as \\x0e"
        data = _evaluated('"', text) or b""
    yield Found(opening.start(), end, head, data, cut, problem)


def _body_end(quote: str, line: str, start: int, end: int) -> int:
    """Where the characters and escapes end that may stand between such quotes."""
    body = _BODY[quote].match(line, start, end)
    return start if body is None else body.end()


def _is_cut(line: str, text: str, stop: int) -> bool:
    """Whether the text, which stops there in the line, has an ellipsis at its end."""
    return text.endswith("...") or _CUT.match(line, stop) is not None


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
