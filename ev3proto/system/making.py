"""Functions for system commands from the tables, made when they are first asked for."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from ev3proto.compose.calls import bound
from ev3proto.errors import near_misses
from ev3proto.messages import FieldValue, SystemCommand
from ev3proto.schema import constructors
from ev3proto.schema.fields import NUMBERS
from ev3proto.schema.frame import HEADER_SIZE
from ev3proto.tables import system
from ev3proto.tables.frame import MAX_FRAME
from ev3proto.tables.system import Field, Kind

_REPLY_HEAD: int = HEADER_SIZE + 2
"""Bytes of a reply in front of its fields: header, command, status."""

_ROOM = "max_bytes"
"""The field that says how much a reply may carry."""


class Commands:
    """Functions for system commands by name; an AttributeError suggests the nearest names."""

    def __init__(self, entries: Sequence[system.SystemCommand], path: str) -> None:
        self._path = path
        self._entries = {entry.name.lower(): entry for entry in entries}

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        entry = self._entries.get(name)
        if entry is None:
            hint = near_misses(name, [other.upper() for other in self._entries]).lower()
            raise AttributeError(f"there is no system command {self._path}{name}{hint}")
        value = self.__dict__[name] = function(entry)
        return value

    def __dir__(self) -> list[str]:
        return sorted(self._entries)

    def __repr__(self) -> str:
        return f"<system commands {self._path.rstrip('.')}>"


class SystemCommands(Commands):
    """Those of the firmware, and those of the bootloader in a namespace of their own.

    bootloader  what only the brick's firmware updater knows (USB only)
    """

    def __init__(self) -> None:
        super().__init__([entry for entry in system.SYSTEM if not entry.bootloader], "system.")
        self.bootloader = Commands([entry for entry in system.SYSTEM if entry.bootloader], "system.bootloader.")

    def __dir__(self) -> list[str]:
        return sorted([*super().__dir__(), "bootloader"])


def fields_in_order(entry: system.SystemCommand) -> list[Field]:
    """The fields of a command as a call has them: the path, what has to be said, what may be left away."""
    return sorted(entry.request, key=lambda field: (default_of(entry, field) is not None, field.name != "path"))


def default_of(entry: system.SystemCommand, field: Field) -> str | None:
    """How a call shows what a field is when it is left away; None where it has to be said."""
    if field.name == _ROOM:
        return str(room(entry))
    return "None" if field.counts is not None or field.optional else None


def room(entry: system.SystemCommand) -> int:
    """Most bytes of contents that fit a reply."""
    fixed: int = sum(NUMBERS[field.kind].sizeof() for field in entry.reply if field.kind in NUMBERS)
    return MAX_FRAME - _REPLY_HEAD - fixed


def function(entry: system.SystemCommand) -> Callable[..., SystemCommand]:
    """The function for one system command."""
    fields = fields_in_order(entry)
    name = entry.name.lower()
    names = [field.name for field in fields]
    required = [field.name for field in fields if default_of(entry, field) is None]
    defaults: dict[str, FieldValue] = {field.name: room(entry) for field in fields if field.name == _ROOM}

    def command(*values: Any, counter: int = 0, reply: bool = entry.answered, **named: Any) -> SystemCommand:
        found = zip(names, bound(name, names, required, values, named), strict=True)
        given = {field: value for field, value in found if value is not None}
        return constructors.system_command(entry.number, counter=counter, reply=reply, **{**defaults, **given})

    command.__name__ = command.__qualname__ = name
    command.__module__ = "ev3proto.system"
    command.__doc__ = described(entry)
    parameters = list(_parameters(entry, fields))
    command.__signature__ = inspect.Signature(  # type: ignore[attr-defined]
        parameters, return_annotation=SystemCommand
    )
    return command


def _parameters(entry: system.SystemCommand, fields: Sequence[Field]) -> Iterator[inspect.Parameter]:
    for field in fields:
        has_default = default_of(entry, field) is not None
        default = room(entry) if field.name == _ROOM else None if has_default else inspect.Parameter.empty
        yield inspect.Parameter(field.name, inspect.Parameter.POSITIONAL_OR_KEYWORD, default=default)
    yield inspect.Parameter("counter", inspect.Parameter.KEYWORD_ONLY, default=0, annotation=int)
    yield inspect.Parameter("reply", inspect.Parameter.KEYWORD_ONLY, default=entry.answered, annotation=bool)


def described(entry: system.SystemCommand) -> str:
    """What the tables say of a system command, as the text that editors and `help` show."""
    fields = fields_in_order(entry)
    rows = [(field.name, "; ".join(_pieces(field))) for field in fields]
    rows.append(("counter", "of the message, 0 to 65535"))
    rows.append(("reply", "whether the brick is to answer" + ("" if entry.answered else "; it never does to this one")))
    width = max(len(name) for name, _ in rows)
    return "\n".join([f"{entry.text}.", "", *(f"{name.ljust(width)}  {text}" for name, text in rows)])


def _pieces(field: Field) -> Iterator[str]:
    yield field.text
    if field.kind in NUMBERS:
        yield f"0 to {(1 << 8 * NUMBERS[field.kind].sizeof()) - 1}"
    if field.most is not None:
        yield f"at most {field.most} bytes{' with its zero' if field.kind is Kind.TEXT else ''}"
    if field.counts is not None:
        yield f"worked out from {field.counts} when left away"
