"""Enumerations of the tables as classes of Python."""

from __future__ import annotations

import enum
from functools import cache
from typing import Any, NamedTuple

from ev3proto.compose.drafts import MARK
from ev3proto.errors import near_misses
from ev3proto.tables import enumerations
from ev3proto.tables.declaration import Enumeration


class Naming(NamedTuple):
    """How an enumeration is called in Python.

    declared  what the tables say
    word      the word that all members have in common, empty where there is none
    short     members' names without that word, in the order of the tables; empty where there is none
    """

    declared: Enumeration
    word: str
    short: tuple[str, ...]


def namings() -> list[Naming]:
    """Every enumeration of the tables, in their order."""
    return [_naming(declared) for declared in vars(enumerations).values() if isinstance(declared, Enumeration)]


@cache
def aliases() -> dict[str, str]:
    """Classes by their second name: the word that their members have in common. The first that has it keeps it."""
    found: dict[str, str] = {}
    names = {naming.declared.name for naming in namings()}
    for naming in namings():
        if naming.word and naming.word not in names:
            found.setdefault(naming.word, naming.declared.name)
    return found


def enumeration_names() -> list[str]:
    """Every name that `enumeration` knows, sorted."""
    return sorted([*(naming.declared.name for naming in namings()), *aliases()])


def enumeration(name: str) -> enum.EnumType:
    """An enumeration by its own or its second name. KeyError suggests the nearest names."""
    name = aliases().get(name, name)
    for naming in namings():
        if naming.declared.name == name:
            return _made(name)
    raise KeyError(f"there is no enumeration {name}{near_misses(name, enumeration_names())}")


@cache
def _made(name: str) -> enum.EnumType:
    naming = next(naming for naming in namings() if naming.declared.name == name)
    declared = naming.declared
    members = dict(declared.members)
    members |= dict(zip(naming.short, declared.members.values(), strict=False))
    kind: Any = enum.IntFlag if declared.flags else enum.IntEnum
    made: enum.EnumType = kind(name, members, module="ev3proto.enums", qualname=name)
    made.__doc__ = f"{declared.text}."
    # An operation that wants another enumeration tells its members by this.
    setattr(made, MARK, name)
    return made


def _naming(declared: Enumeration) -> Naming:
    words = [name.split("_") for name in declared.members]
    for at in range(min(map(len, words)) - 1, 0, -1):
        for shared, rest in ((slice(None, at), slice(at, None)), (slice(-at, None), slice(None, -at))):
            short = tuple("_".join(name[rest]) for name in words)
            if len({tuple(name[shared]) for name in words}) == 1 and all(name.isidentifier() for name in short):
                return Naming(declared, "_".join(words[0][shared]), short)
    return Naming(declared, "", ())
