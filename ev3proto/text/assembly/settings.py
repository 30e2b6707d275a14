"""What a source says about its image that no statement can: comments of the form `// ev3proto: version 0x39`.

Other assemblers pass over them. `decode --format lego` writes them where an image is not as the usual rules make it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

from ev3proto.tables.program import MAX_MEMORY, MAX_OBJECTS
from ev3proto.text.assembly.errors import SourceError
from ev3proto.text.assembly.notations import OF_BASIC, OF_EV3_G, OF_LEGO, Rules

_SETTING = re.compile(r"^[ \t]*//[ \t]*ev3proto:[ \t]*(\w+)[ \t]*([^\r\n]*)", re.MULTILINE | re.ASCII)

_WORD = "ev3proto:"
MARK = f"// {_WORD}"
GAP = "gap"
OPEN = "open"
OWN = "own"

FILE_NUMBERS = {"version": 0xFFFF, "size": MAX_MEMORY, "count": MAX_OBJECTS, "globals": MAX_MEMORY}
"""Settings of the whole image that are numbers, and the largest that each can be."""

OBJECT_NUMBERS = {
    "owner": MAX_OBJECTS,
    "triggers": 0xFFFF,
    "locals": MAX_MEMORY,
    "offset": MAX_MEMORY,
    "header": MAX_MEMORY,
    "shares": MAX_OBJECTS,
}
"""Settings of the object that follows."""

_RULES = {rules.name: rules for rules in (OF_LEGO, OF_EV3_G, OF_BASIC)}
"""The rules that a source can ask for by their names: `// ev3proto: shortest`."""


@dataclass
class ObjectSettings:
    """What is said of the object that follows.

    numbers  the fields of its header, where they are not what the source makes them
    is_open  neither RETURN nor OBJECT_END is added
    is_own   its code is written even if an earlier object has the same
    """

    numbers: dict[str, int] = field(default_factory=dict)
    is_open: bool = False
    is_own: bool = False


@dataclass
class Settings:
    """What is said of the image.

    numbers  its fields, where they are not what the source makes them
    rules    those by which values are encoded; None: those of the notation
    gaps     offset and bytes of what belongs to no object
    """

    numbers: dict[str, int] = field(default_factory=dict)
    rules: Rules | None = None
    gaps: list[tuple[int, bytes]] = field(default_factory=list)


class SettingsReader:
    """The settings of a source: those of the image, and for each object those in front of it."""

    def __init__(self, text: str, errors: list[SourceError]) -> None:
        self.file = Settings()
        self._of_objects: list[tuple[int, str, int | None]] = []
        self._taken = 0
        if _WORD not in text:
            return
        for found in _SETTING.finditer(text):
            try:
                self._one(found.start(1), found[1], found[2].strip())
            except ValueError:
                errors.append(SourceError(found.start(1), f"{found[1]} {found[2].strip()[:40]} is not a setting"))

    def _one(self, at: int, word: str, rest: str) -> None:
        if word in _RULES:
            self.file.rules = _RULES[word]
        elif word == GAP:
            offset, _, data = rest.partition(" ")
            self.file.gaps.append((_number(offset, MAX_MEMORY), bytes.fromhex(data)))
        elif word in FILE_NUMBERS:
            self.file.numbers[word] = _number(rest, FILE_NUMBERS[word])
        elif word in OBJECT_NUMBERS:
            self._of_objects.append((at, word, _number(rest, OBJECT_NUMBERS[word])))
        elif word in (OPEN, OWN):
            self._of_objects.append((at, word, None))
        else:
            raise ValueError

    def before(self, at: int) -> ObjectSettings:
        """The settings in front of an object; objects are to be asked for in their order."""
        found = ObjectSettings()
        for word, value in self._until(at):
            if value is not None:
                found.numbers[word] = value
            elif word == OPEN:
                found.is_open = True
            else:
                found.is_own = True
        return found

    def _until(self, at: int) -> Iterator[tuple[str, int | None]]:
        while self._taken < len(self._of_objects) and self._of_objects[self._taken][0] < at:
            yield self._of_objects[self._taken][1:]
            self._taken += 1


def _number(text: str, most: int) -> int:
    value = int(text[:12], 0)
    if not 0 <= value <= most or len(text) > 12:
        raise ValueError
    return value
