"""Image settings given in comments, such as `// ev3proto: version 0x39`.

Other assemblers ignore them. `decode --format lego` writes them if an image differs from what the default rules make.
"""

from __future__ import annotations

import re
from collections import deque

from ev3proto.tables.program import MAX_MEMORY, MAX_OBJECTS
from ev3proto.text.assembly.errors import SourceError
from ev3proto.text.assembly.notations import OF_BASIC, OF_EV3_G, OF_LEGO, Rules

_SETTING = re.compile(r"^[ \t]*//[ \t]*ev3proto:[ \t]*(\w+)[ \t]*([^\r\n]*)", re.MULTILINE | re.ASCII)

MARK = "// ev3proto:"
GAP = "gap"
"""Offset and bytes of data that belongs to no object."""

OPEN = "open"
"""Of an object: neither RETURN nor OBJECT_END is added."""

OWN = "own"
"""Of an object: its code is written even if an earlier object has the same."""

_OF_FILE = {"version": 0xFFFF, "globals": MAX_MEMORY}
_OF_OBJECTS = {
    "owner": MAX_OBJECTS,
    "triggers": 0xFFFF,
    "locals": MAX_MEMORY,
    "offset": MAX_MEMORY,
    "header": MAX_MEMORY,
    "shares": MAX_OBJECTS,
}
"""The fields of the image, and of the object that follows, where they are not what the source makes them; the largest
number of each.
"""

_RULES = {rules.name: rules for rules in (OF_LEGO, OF_EV3_G, OF_BASIC)}
"""The rules that a source can ask for by their names: `// ev3proto: shortest`."""


class ImageSettings:
    """The settings of a source."""

    def __init__(self, text: str, errors: list[SourceError]) -> None:
        self.numbers: dict[str, int] = {}  # fields of the image
        self.rules: Rules | None = None  # those by which values are encoded; None: those of the notation
        self.gaps: list[tuple[int, bytes]] = []  # offset and bytes of what belongs to no object
        self._of_objects: deque[tuple[int, str, int]] = deque()
        for found in _SETTING.finditer(text) if MARK[3:] in text else ():
            try:
                self._one(found.start(1), found[1], found[2].strip())
            except ValueError:
                errors.append(SourceError(found.start(1), f"unknown setting {found[1]} {found[2].strip()[:40]}"))

    def _one(self, at: int, word: str, rest: str) -> None:
        if word in _RULES:
            self.rules = _RULES[word]
        elif word == GAP:
            offset, _, data = rest.partition(" ")
            self.gaps.append((_number(offset, MAX_MEMORY), bytes.fromhex(data)))
        elif word in _OF_FILE:
            self.numbers[word] = _number(rest, _OF_FILE[word])
        elif word in (OPEN, OWN):
            self._of_objects.append((at, word, 1))
        elif word in _OF_OBJECTS:
            self._of_objects.append((at, word, _number(rest, _OF_OBJECTS[word])))
        else:
            raise ValueError

    def before(self, at: int) -> dict[str, int]:
        """Takes the settings that precede an object; call it for the objects in order."""
        found: dict[str, int] = {}
        while self._of_objects and self._of_objects[0][0] < at:
            _, word, value = self._of_objects.popleft()
            found[word] = value
        return found


def _number(text: str, most: int) -> int:
    value = int(text[:12], 0)
    if not 0 <= value <= most or len(text) > 12:
        raise ValueError
    return value
