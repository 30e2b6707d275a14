"""The short way for most lines of long texts: one frame in hex, alone or after the same words as in a line before.

Nothing is read here in another way than everywhere else. A line is taken only where the long way is known to give the
same: hex alone on its line, or after words with which a line was read the long way before. What may differ between two
such lines is their times, their frames, and numbers that are too few to be a frame.
"""

from __future__ import annotations

import re

from ev3proto.schema.header import HEADER_SIZE, frame_size, is_frame_size
from ev3proto.tables.frame import MessageType
from ev3proto.text.late_pattern import late_pattern
from ev3proto.text.paste.blanking import clean
from ev3proto.text.paste.constants import constant_bytes
from ev3proto.text.paste.direction import is_command
from ev3proto.text.paste.head import Direction, time_before
from ev3proto.text.paste.pieces import LEAST, MAX_TEXT, Pasted, short

_TYPES = frozenset(int(member) for member in MessageType)
_TYPE_AT = HEADER_SIZE - 1

_BYTE = "[0-9a-fA-F]{2}"
_HEX = (
    rf"(?:(?P<plain>{_BYTE}(?P<mark>[ :-]?){_BYTE}(?>(?:(?P=mark){_BYTE}){{3,}}))"
    rf"|0[xX]\|(?P<lesson>{_BYTE}(?>(?:[:|]{_BYTE}){{4,}}))\|?"
    rf"|(?P<prefixed>0[xX]{_BYTE}(?P<comma>,? |,)0[xX]{_BYTE}(?>(?:(?P=comma)0[xX]{_BYTE}){{3,}})))(?!\w)"
)
_ALONE = late_pattern(rf"{_HEX}\s*")
_AFTER = late_pattern(rf"(?<=[\s:=(\[{{<\"'`]){_HEX}")
_REST = late_pattern(r"[\s)\]}>\"'`;,|]*")
_BETWEEN = late_pattern(r"0[xX]|[:|,-]")

_WORD = late_pattern(
    r"(?:^|[^\w$])(?P<word>(?=\w*[g-wyzG-WYZ])(?![0-9a-fA-F]{1,3}[hH]\b)[^\W\d_]\w+)(?P<after>[\s:=<>(\[{\"'`,)\]}-]*)$"
)
_CALL = late_pattern(r"\w\s?\([^()]*\)\W*$")
_NUMBER = late_pattern(r"(?<!\w)\d+(?!\w)")
_DIGIT = late_pattern(r"\d")
_MAYBE_BYTES = late_pattern(r"(?<!\w)[0-9a-fA-F]+(?!\w)")
_END = "\n"
_ODD = frozenset("\\\x1b+&$#%*")
_MOST_BEFORE = 200
_MOST_LINE = 1 << 13
_MOST_SHAPES = 1 << 10


class Familiar:
    """Reads lines that are like those that were read before."""

    def __init__(self) -> None:
        self._directions: dict[str, Direction | None] = {}
        self._strange: set[str] = set()
        self._learning: tuple[str, Pasted] | None = None

    def read(self, line: str, number: int) -> Pasted | None:
        """The frame in a line that does not go on with another; None where the long way is to be taken.

        Args:
            line: A line, with the mark of its end or without it.
            number: Its number in the text.
        """
        self._learning = None
        found = _ALONE.fullmatch(line)
        if found is not None:
            data = _frame(found)
            return None if data is None else _pasted(found, data, number, None, None)
        found = _AFTER.search(line, 0, _MOST_LINE)
        if found is None or found.start() > _MOST_BEFORE or _REST.fullmatch(line, found.end()) is None:
            return None
        data = _frame(found)
        if data is None:
            return None
        start = found.start()
        before = line[:start]
        separator = found["mark"] or found["comma"]
        # After an arrow, the direction depends on the type.
        shape = (
            f"{is_command(data)}{_shape(before)}{_END}{found.lastgroup}{separator}{_END}{line[found.end() :].rstrip()}"
        )
        if shape in self._directions:
            return _pasted(found, data, number, self._directions[shape], time_before(line, start))
        if shape not in self._strange and _ends_in_word(before):
            self._learning = (shape, _pasted(found, data, number, None, time_before(line, start)))
        return None

    def learn(self, pieces: list[Pasted]) -> None:
        """Remembers what the long way gave for the line that was not read the short way.

        Args:
            pieces: All that was found in the line.
        """
        if self._learning is None:
            return
        shape, expected = self._learning
        if len(self._directions) + len(self._strange) >= _MOST_SHAPES:
            self._directions.clear()
            self._strange.clear()
        if len(pieces) == 1 and pieces[0]._replace(direction=None) == expected:
            self._directions[shape] = pieces[0].direction
        else:
            self._strange.add(shape)


def _frame(found: re.Match[str]) -> bytes | None:
    """The bytes of hex, if they are one frame."""
    text = found["plain"]
    if text is None or found["mark"] in (":", "-"):
        text = _BETWEEN.sub("", found[found.lastgroup or 0])
    data = bytes.fromhex(text)
    size = len(data)
    return data if frame_size(data) == size and is_frame_size(size) and data[_TYPE_AT] in _TYPES else None


def _pasted(found: re.Match[str], data: bytes, number: int, direction: Direction | None, time: str | None) -> Pasted:
    start, end = found.span(found.lastgroup or 0)
    return Pasted(data, number, short(found.string[start:end], MAX_TEXT), direction, time, column=start + 1)


def _shape(before: str) -> str:
    """What lines that are read in the same way have in common in front of their bytes.

    Numbers may differ where there are too few digits for a frame. Zeros, which may be the offset of a dump, may not.
    """
    text = clean(before)
    if _DIGIT.search(text) is None:
        return text
    size = sum((len(digits) + 1) // 2 for digits in _MAYBE_BYTES.findall(text))
    return text if size >= LEAST or "0000" in text else _NUMBER.sub(_nines, text)


def _ends_in_word(before: str) -> bool:
    """Whether no run of bytes goes on from there: it ends in a word that is no value of any notation."""
    if not _ODD.isdisjoint(before):
        return False
    found = _WORD.search(before)
    if found is None:
        return False
    # Names and calls in lists may be values.
    is_listed = not {",", ")", "]", "}"}.isdisjoint(found["after"])
    return not is_listed or (constant_bytes(found["word"]) is None and _CALL.search(before) is None)


def _nines(number: re.Match[str]) -> str:
    return "9" * len(number[0])
