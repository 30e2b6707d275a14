"""Dumps, as Wireshark, hexdump -C, xxd, od and tcpdump print them: an offset, the bytes in hex, and the same as text.

The lines of a dump belong together when their offsets say so. Words of two bytes are refused: either order is in use.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from ev3proto.text.late_pattern import late_pattern
from ev3proto.text.paste.head import NO_HEAD
from ev3proto.text.paste.pieces import MAX_COLLECTED, MAX_TEXT, Pasted, Wants, short

_START = late_pattern(r"\s*+(?:0[xX])?(?P<offset>[0-9a-fA-F]{4,16})(?P<colon>:?)(?P<blanks>\s++)(?=[0-9a-fA-F]{2})")
_GROUP = late_pattern(r"(?P<digits>(?:[0-9a-fA-F]{2}){1,8})(?!\S)(?P<blanks>\s*+)")


class Row(NamedTuple):
    """One line of a dump."""

    offset: int
    data: bytes
    problem: str | None


def dump_row(line: str) -> Row | None:
    """The line as a line of a dump; None where it is none."""
    opening = _START.match(line)
    group = opening and _GROUP.match(line, opening.end())
    if not opening or not group:
        return None
    offset, first = opening["offset"], len(group["digits"])
    # An offset of seven digits without a colon is od's, which counts in octal.
    is_od = len(offset) == 7 and not opening["colon"]
    if is_od and first == 4:
        words = f"column {opening.end() + 1}: words of two bytes stand in either order in a dump, use hexdump -C or xxd"
        return Row(int(offset, 16), b"", words)
    # Hex in groups looks nearly the same: only a colon, two blanks or an odd width tell that it is an offset.
    if not opening["colon"] and (first != 2 or (opening["blanks"] == " " and len(offset) not in (6, 7))):
        return None
    is_octal = is_od and set(offset) <= set("01234567")
    return Row(int(offset, 8 if is_octal else 16), *_row_bytes(line, opening.end()))


def _row_bytes(line: str, position: int) -> tuple[bytes, str | None]:
    """The bytes from there on, and what is wrong with what follows them."""
    data = bytearray()
    while group := _GROUP.match(line, position):
        data += bytes.fromhex(group["digits"])
        position = group.end()
        blanks = len(group["blanks"])
        # One blank between groups, one more in the middle; after any wider gap stands the text column.
        if blanks != 1 and not (blanks == 2 and len(data) == 8):
            return bytes(data), None
    problem = None
    if position < len(line) and line[position] != "|":
        problem = f"column {position + 1}: {short(line[position : position + 8])!r} is no hex"
    return bytes(data), problem


@dataclass(slots=True)
class Dump:
    """Lines of a dump whose offsets follow each other."""

    line: int
    text: str
    offset: int
    data: bytearray
    problem: str | None

    def takes(self, line: str, number: int) -> bool:
        """Takes the line if it goes on with the dump. After a problem it takes whatever has a higher offset."""
        if line.strip() == "*":
            self.problem = self.problem or f"line {number}: the dump leaves lines out here, as the * tells"
            return True
        row = dump_row(line)
        if row is None or row.offset <= self.offset:
            return False
        if self.problem is None:
            if row.offset != self.offset + len(self.data):
                return False
            self.data += row.data
            if row.problem is not None:
                self.problem = f"line {number}, {row.problem}"
            elif len(self.data) > MAX_COLLECTED:
                self.problem = f"the dump is longer than {MAX_COLLECTED // 1024} KiB"
        if len(self.text) < MAX_TEXT:
            self.text = f"{self.text}\n{short(line, MAX_TEXT)}"
        return True

    def is_wanted(self, wants: Wants) -> bool:
        """Whether it is worth reporting."""
        return wants.takes(len(self.data), self.problem, NO_HEAD)

    def pasted(self) -> Pasted:
        """The lines as one piece."""
        return Pasted(bytes(self.data), self.line, short(self.text, MAX_TEXT), problem=self.problem)


def start_dump(line: str, number: int) -> Dump | None:
    """The dump that starts with the line, if one does."""
    row = dump_row(line)
    if row is None or (row.problem is not None and row.offset != 0):
        return None
    return Dump(number, line, row.offset, bytearray(row.data), row.problem)
