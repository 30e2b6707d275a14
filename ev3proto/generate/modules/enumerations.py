"""`ev3proto.enums`: a class for each enumeration, its members under the firmware's names and under short ones."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from ev3proto.generate.modules.source import MARK, docstring, exported, indented, joined, sentence
from ev3proto.tables.declaration import Enumeration
from ev3proto.tables.enumerations import ENUMERATIONS


class _Naming(NamedTuple):
    """The Python names of an enumeration."""

    declared: Enumeration
    word: str  # the word that all member names share; empty if they share none
    short: tuple[str, ...]  # member names without that word, in the order of the tables; empty if they share none


def module() -> str:
    """Returns the text of the module."""
    return joined(_lines())


def _lines() -> Iterator[str]:
    yield from docstring(
        [
            "The firmware's enumerations for use in Python: `LED.RED_FLASH`, `BUTTON.UP`, `TYPE.TYPE_TOUCH`.",
            "",
            "Each is a class under the firmware's name with members under the firmware's names",
            "(`LEDPATTERN.LED_RED_FLASH`). Where all members begin or end with the same word, they have a name without",
            "it, too, and the class has that word as a second name (`LED.RED_FLASH`).",
            "",
            MARK,
        ]
    )
    namings = [_naming(declared) for declared in ENUMERATIONS]
    aliases = _aliases(namings)
    yield ""
    yield "# ruff: noqa: N801 - the names are the firmware's"
    yield ""
    yield "from enum import IntEnum, IntFlag"
    yield ""
    yield "from ev3proto.errors import MemberNames"
    yield ""
    yield from exported([*(naming.declared.name for naming in namings), *aliases])
    for naming in namings:
        yield ""
        yield ""
        yield from _class(naming)
    yield ""
    yield ""
    for alias, name in aliases.items():
        yield f"{alias} = {name}"


def _aliases(namings: Sequence[_Naming]) -> dict[str, str]:
    """Returns classes by their second name. If two claim one, the first keeps it."""
    found: dict[str, str] = {}
    names = {naming.declared.name for naming in namings}
    for naming in namings:
        if naming.word and naming.word not in names:
            found.setdefault(naming.word, naming.declared.name)
    return found


def _class(naming: _Naming) -> Iterator[str]:
    declared = naming.declared
    yield f"class {declared.name}({'IntFlag' if declared.flags else 'IntEnum'}, metaclass=MemberNames):"
    yield from indented(docstring([sentence(declared.text)]))
    yield ""
    yield from indented(f"{name} = {number}" for name, number in declared.members.items())
    if naming.short:
        yield ""
        yield from indented(f"{short} = {name}" for short, name in zip(naming.short, declared.members, strict=True))


def _naming(declared: Enumeration) -> _Naming:
    words = [name.split("_") for name in declared.members]
    for at in range(min(map(len, words)) - 1, 0, -1):
        for shared, rest in ((slice(None, at), slice(at, None)), (slice(-at, None), slice(None, -at))):
            short = tuple("_".join(name[rest]) for name in words)
            if len({tuple(name[shared]) for name in words}) == 1 and all(name.isidentifier() for name in short):
                return _Naming(declared, "_".join(words[0][shared]), short)
    return _Naming(declared, "", ())
