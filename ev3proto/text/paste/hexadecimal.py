"""Forms made of hex digits: bare hex, the lesson's `0x|0E:00|...|`, and what stands in a call of fromhex().

They differ in where the digits begin and end. The digits, what may separate them and an ellipsis are the same in all.
"""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.text.late_pattern import late_pattern
from ev3proto.text.paste.head import clean_head, head_before
from ev3proto.text.paste.pieces import MOST_SHORT, Found, short

_GROUP = late_pattern(r"[^\s,;:|\-]+")
_HEX_GROUP = late_pattern(r"(0[xX])?([0-9a-fA-F]+)")
_SEPARATORS = " \t\r\n\f\v,;:|-"

_REMARK = late_pattern(r"\s(?:#|//)")
_WORD = late_pattern(r"(?<![^\W_])[a-zA-Z]{3,}(?![^\W_])")
_STRANGE = late_pattern(r"[^0-9a-fA-FxX]")
_HEX_DIGIT = late_pattern(r"[0-9a-fA-F]")

_LESSON = late_pattern(r"0[xX]\|(?P<groups>[^\s\"'`()<>,;]*+)")
_LESSON_FRAME = late_pattern(r"0[xX]\|[0-9a-fA-F]{2}:[0-9a-fA-F]{2}\|[0-9a-fA-F]{2}:[0-9a-fA-F]{2}\|[0-9a-fA-F]{2}")
_LESSON_REST = late_pattern(r"[0-9a-fA-F\s:|.…]*+$")

_FROMHEX = late_pattern(r"\b(?:fromhex|unhexlify)\(\s{0,8}b?([\"'])(?P<groups>[^\"']*+)")
_NO_HEX = "is no hex"


def bare(line: str, *, is_sure: bool) -> Found | None:
    """Hex digits that, with a time and a direction, are the whole line."""
    head = clean_head(line)
    start = head.end
    remark = _REMARK.search(line, start)
    text = line[start : remark.start() if remark is not None else None]
    end, cut = _cut_off(line, start, start + len(text.rstrip(" \t\"'`])}>;,")))
    if start >= end:
        return None
    data, problem = _hex(line, start, end, cut=cut)
    text = line[start:end]
    is_meant = not _is_words(text) if problem is None else head.is_log and _is_nearly_hex(text)
    return Found(start, end, head, data, cut, problem) if is_sure or is_meant else None


def lesson(line: str) -> Iterator[Found]:
    """`0x|0E:00|2A:00|80|...|`. The lesson writes single values so too: among prose it must start as frames do."""
    position = 0
    while opening := _LESSON.search(line, position):
        start, first = opening.start(), opening.start("groups")
        head = head_before(line, position, start)
        # Blanks may stand between the groups when nothing else follows.
        stop = len(line) if _LESSON_REST.match(line, first) else opening.end()
        if line.endswith("|.", first, stop):
            stop -= 1
        if head.is_clean or _LESSON_FRAME.match(line, start):
            end, cut = _cut_off(line, first, stop)
            data, problem = _hex(line, first, end, cut=cut)
            yield Found(start, stop, head, data, cut, problem, is_marked=head.is_clean)
        position = stop


def fromhex(line: str) -> Iterator[Found]:
    """`bytes.fromhex("0e00...")` and `binascii.unhexlify(...)`."""
    position = 0
    for call in _FROMHEX.finditer(line):
        head = head_before(line, position, call.start())
        first = call.start("groups")
        position = call.end()
        end, cut = _cut_off(line, first, position)
        data, problem = _hex(line, first, end, cut=cut)
        yield Found(call.start(), position, head, data, cut, problem)


def _hex(line: str, start: int, end: int, *, cut: bool) -> tuple[bytes, str | None]:
    """The bytes of the groups of hex digits in line[start:end], and what is wrong with the first group that is none.

    Where the text was cut, half a byte at the end was cut too and is no problem.
    """
    groups = list(_GROUP.finditer(line, start, end))
    digits: list[str] = []
    problem = None
    for group in groups:
        text, reason = _digits(group[0], is_alone=len(groups) == 1)
        digits.append(text[: len(text) & ~1])
        if len(text) % 2 and not (cut and group is groups[-1]):
            reason = f"has an odd number of hex digits ({len(text)}), two make a byte"
        if reason == _NO_HEX and len(group[0]) > MOST_SHORT and (strange := _STRANGE.search(group[0])):
            problem = f"column {group.start() + strange.start() + 1}: {strange[0]!r} is no hex digit"
            break
        if reason is not None:
            problem = f"column {group.start() + 1}: {short(group[0])!r} {reason}"
            break
    return bytes.fromhex("".join(digits)), problem


def _digits(group: str, *, is_alone: bool) -> tuple[str, str | None]:
    """The digits of a group, or why there are none. After 0x stands one byte, or all of them if the group is alone."""
    number = _HEX_GROUP.fullmatch(group)
    if number is None:
        return "", _NO_HEX
    prefix, digits = number.groups()
    if prefix and len(digits) > 2 and not is_alone:
        return "", "is more than 255, which a byte cannot be"
    return ("0" + digits if prefix and len(digits) == 1 else digits), None


def _cut_off(line: str, start: int, end: int) -> tuple[int, bool]:
    """The end without the ellipsis and the separators that stand there, and whether there was an ellipsis."""
    text = line[start:end].rstrip(_SEPARATORS)
    if text.endswith(("...", "…")):
        return start + len(text.rstrip(_SEPARATORS + ".…")), True
    return start + len(text), False


def _is_words(text: str) -> bool:
    """True for words that happen to be spelled with the letters a to f, such as "decade facade"."""
    groups = _GROUP.findall(text)
    return (
        len(groups) > 1 and text.upper() != text and all(map(str.isalpha, groups)) and any(len(g) > 2 for g in groups)
    )


def _is_nearly_hex(text: str) -> bool:
    """True when somebody must have meant hex: many digits and not a word among them."""
    return _WORD.search(text) is None and len(_HEX_DIGIT.findall(text)) >= 8
