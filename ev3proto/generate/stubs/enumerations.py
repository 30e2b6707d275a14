"""The stub of `ev3proto.enums`: a class for each enumeration, with all names of its members."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.enums.making import Naming, aliases, namings
from ev3proto.generate.stubs.writing import HEAD, docstring, indented


def stub() -> str:
    """The text of the file."""
    return "\n".join(_lines()) + "\n"


def _lines() -> Iterator[str]:
    yield from docstring(f"The firmware's enumerations for use in Python.\n\n{HEAD}")
    yield ""
    yield "# ruff: noqa: N801 - the names are the firmware's"
    yield ""
    yield "from enum import IntEnum, IntFlag"
    for naming in namings():
        yield ""
        yield from _class(naming)
    yield ""
    for alias, name in aliases().items():
        yield f"{alias} = {name}"


def _class(naming: Naming) -> Iterator[str]:
    declared = naming.declared
    yield f"class {declared.name}({'IntFlag' if declared.flags else 'IntEnum'}):"
    yield from indented(docstring(f"{declared.text}."))
    yield ""
    yield from indented(f"{name} = {number}" for name, number in declared.members.items())
    yield from indented(f"{short} = {name}" for short, name in zip(naming.short, declared.members, strict=False))
