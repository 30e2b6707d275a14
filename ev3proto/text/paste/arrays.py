"""Arrays of numbers, as source code in C, Python or JSON has them: in a line, or over several with remarks.

Brackets stand in prose and code for much else, so an array is read number by number and given up where it is none.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Literal

from ev3proto.text.late_pattern import late_pattern
from ev3proto.text.paste.head import NO_HEAD, Head, clean_head, head_before
from ev3proto.text.paste.pieces import MAX_COLLECTED, MAX_TEXT, Pasted, Wants, short

_OPENING = late_pattern(r"[\[{]")
_PART = late_pattern(
    r"(?P<blank>\s++)|(?P<comma>,)|(?P<remark>//.*+|#.*+)|(?P<comment>/\*)|(?P<ellipsis>\.{3}|…)"
    r"|(?P<number>0[xX][0-9a-fA-F]+|0[bB][01]+|\d+)[uU]?(?!\w|\.\d)|(?P<closer>[\]}])|(?P<other>[^\s,\]}]{1,32})",
    re.ASCII | re.DOTALL,
)


@dataclass(slots=True)
class Array:
    """An array of numbers while it is read, which may take several lines.

    size   the characters of the lines that were read so far
    count  the numbers that were read so far, also those that are no bytes
    """

    line: int
    column: int
    head: Head
    state: Literal["open", "closed", "broken"] = "open"
    data: bytearray = field(default_factory=bytearray)
    cut: bool = False
    problem: str | None = None
    text: str = ""
    size: int = 0
    needs_comma: bool = False
    count: int = 0

    def feed(self, line: str, start: int, number: int) -> int:
        """Reads on at line[start]; tells how far the line was read."""
        position = start
        while self.state == "open" and (part := _PART.match(line, position)):
            position = self._take(part, number)
        if self.state == "open" and self.cut:
            self.state = "closed"
        self.size += position - start + 1
        if len(self.text) < MAX_TEXT:
            first = start if self.text else self.column
            last = position if self.state == "closed" else len(line)
            self.text = f"{self.text}\n{short(line[first : min(last, first + 2 * MAX_TEXT)], MAX_TEXT)}"
        return position

    def _take(self, part: re.Match[str], number: int) -> int:
        """Takes the next part of a line; tells where to read on."""
        match part.lastgroup:
            case "comma":
                self.needs_comma = False
            case "closer":
                self.state = "closed"
            case "ellipsis":
                self.cut = self.needs_comma = True
            case "comment":
                close = part.string.find("*/", part.end())
                if close >= 0:
                    return close + 2
                # A comment that goes on over lines would hide frames from us if it were none.
                self.state = "broken"
                return len(part.string)
            case "number" | "other":
                where = "" if number == self.line else f"line {number}, "
                where += f"column {part.start() + 1}"
                if part["number"]:
                    self._number(part["number"], where)
                else:
                    self._fail(f"{where}: {short(part[0])!r} is no number")
        return part.start() if self.state == "broken" else part.end()

    def _number(self, digits: str, where: str) -> None:
        """Takes a number; it must follow a comma and be a byte."""
        if self.needs_comma:
            self._fail(f"{where}: a comma is missing")
            return
        self.needs_comma = True
        self.count += 1
        value = _value(digits)
        if value is None:
            self._fail(f"{where}: {digits[:9]} is octal in C and decimal to most readers, write it as 0x..")
        elif value > 255:
            self._fail(f"{where}: {short(digits)} is more than 255, which a byte cannot be")
        elif self.size <= MAX_COLLECTED:
            self.data.append(value)
        else:
            # Read on all the same: what follows is no hex on lines of its own.
            self.problem = f"{where}: the array goes on after {MAX_COLLECTED // 1024} KiB of text, which is too much"

    def _fail(self, problem: str) -> None:
        self.problem, self.state = problem, "broken"

    def _fault(self) -> str | None:
        """What is wrong with the array, if it ends here."""
        if self.problem is None and self.state != "closed":
            return f"column {self.column + 1}: the array that starts here has no end"
        return self.problem

    def is_wanted(self, wants: Wants) -> bool:
        """Whether it is worth reporting."""
        return self.count > 0 and wants.takes(self.count, self._fault(), self.head)

    def pasted(self) -> Pasted:
        """The array as far as it was read."""
        text = short(self.text, MAX_TEXT)
        return Pasted(bytes(self.data), self.line, text, self.head.direction, self.head.time, self.cut, self._fault())


def find_arrays(line: str, number: int, start: int, wants: Wants) -> list[Array]:
    """The arrays in line[start:] that are worth reporting; the last one may still be open."""
    found: list[Array] = []
    clean = clean_head(line, start)
    # A time may stand in brackets too.
    position = clean.said
    while opening := _OPENING.search(line, position):
        column, position = opening.start(), opening.end()
        is_clean = column < clean.end
        if opening[0] == "[" and not is_clean and not _is_value(line, column):
            continue
        array = Array(number, column, clean if is_clean else NO_HEAD)
        position = array.feed(line, position, number)
        if array.state == "open" or array.is_wanted(wants):
            array.head = head_before(line, start, column)
            found.append(array)
            start = position
            clean = clean_head(line, start)
    return found


def _is_value(line: str, column: int) -> bool:
    """Whether a list in square brackets there is a value of something: prose has lists of references."""
    return line[max(0, column - 8) : column].rstrip().endswith(("=", "(", ":", ",", "[", "{"))


def _value(digits: str) -> int | None:
    """The number (256 or more for all that are larger), or None where a leading zero may make it octal."""
    if digits[:2] in ("0x", "0X"):
        return int(digits[2:].lstrip("0")[:3] or "0", 16)
    if digits[:2] in ("0b", "0B"):
        return int(digits[2:].lstrip("0")[:9] or "0", 2)
    # Cut short: four digits tell that it is too much, and Python refuses to read thousands of them.
    value = int(digits.lstrip("0")[:4] or "0")
    return None if value > 7 and digits[0] == "0" else value
