"""The parameters and fields of the tables: the places that a name refers to, and their values in a record."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from functools import cache, partial
from typing import Any, NamedTuple

from ev3proto.capture.filter.values import FilterValue, Kind, Name
from ev3proto.capture.record import Record
from ev3proto.messages import DaisyCommand, DaisyReply, DirectReply, SystemCommand, SystemReply
from ev3proto.tables import OPCODES
from ev3proto.tables.daisy import DaisySubCommand
from ev3proto.tables.declaration import Declaration, Enumeration, Parameter, Type, declarations
from ev3proto.tables.system import SYSTEM, FieldKind

PATH = "path"
"""The field with the path of a file."""

_ANY = "ARG"
"""Prefix before the dot: the parameter of any operation."""

_DAISY = "messages from brick to brick"

_SENT_ON = dict.fromkeys(("layer_from", "layer_to"), FieldKind.U8) | {"payload": FieldKind.DATA}
_REPORT = dict.fromkeys(("layer", "port", "status", "type", "mode", "checksum"), FieldKind.U8) | dict.fromkeys(
    ("data", "busy"), FieldKind.DATA
)
"""The fields of daisy messages, and of the sensor reports in them."""


class FieldPlace(NamedTuple):
    """A parameter of an operation, or a field of a system command."""

    owner: str  # full name of the operation or the command
    name: str  # spelling in the tables
    holds: type  # int (for all numbers), str or bytes
    enum: Enumeration | None = None
    unit: str | None = None


_WHAT = {int: "a number", str: "a text in quotes", bytes: "bytes such as 4c:45:47:4f"}


def find_field(name: str) -> Name | None:
    """Looks up `VOLUME`, `SOUND.TONE.VOLUME`, `arg.SIZE` or `VALUES[0]`, in any case. Returns None if it is unknown.

    The name of a command with a single parameter also means that parameter (`LED`), unless a parameter has the name.
    """
    places = _places_of(name)
    return Name(_kind(places), partial(_values, name, {place.owner: place for place in places})) if places else None


def _places_of(name: str) -> list[FieldPlace]:
    owner, _, base = name.upper().rpartition(".")
    base = base.partition("[")[0]
    places = _places().get(base) or [
        _place(entry, entry.parameters[0])
        for entry in _declared()
        if entry.command is not None and entry.command.name == base and len(entry.parameters) == 1
    ]
    owners = operation_names().get(owner, ()) or (owner,)
    return [place for place in places if owner in ("", _ANY) or place.owner in owners]


def _kind(places: Sequence[FieldPlace]) -> Kind:
    held = {place.holds for place in places}
    return Kind(
        " or ".join(text for type_, text in _WHAT.items() if type_ in held),
        number=int in held,
        text=str in held,
        data=bytes in held,
        enums=tuple({place.enum.name: place.enum for place in places if place.enum}.values()),
        units=tuple(dict.fromkeys(place.unit for place in places if place.unit)),
    )


def _values(name: str, by_owner: Mapping[str, FieldPlace], record: Record) -> Iterator[FilterValue]:
    """Yields the values of a name in a record; a name with an index means one value."""
    element = name.lower().rpartition(".")[2]
    for owner, called, value in _named_values(record, by_owner):
        place = by_owner.get(owner)
        if place and (called.lower() == element if "[" in element else called.partition("[")[0] == place.name):
            for each in value if isinstance(value, list) else [value]:
                yield FilterValue(each, place.enum, place.unit)


def _named_values(record: Record, owners: Container[str]) -> Iterator[tuple[str, str, Any]]:
    """Yields owner, name and value of all arguments of commands, and values and fields of replies."""
    yield from _held(record)
    for operation in getattr(record.message, "operations", ()):
        if operation.full_name in owners:
            for argument in operation.arguments:
                yield operation.full_name, argument.name, None if argument.is_variable else argument.value


def _held(record: Record) -> Iterator[tuple[str, str, Any]]:
    """Yields the same of everything but operations."""
    message = record.message
    if isinstance(message, DirectReply):
        yield from ((value.full_name, value.name, value.value) for value in record.values)
    elif isinstance(message, SystemCommand | SystemReply):
        yield from ((message.command or "", name, field) for name, field in message.fields.items())
    elif isinstance(message, DaisyCommand | DaisyReply):
        yield from ((_DAISY, name, getattr(message, name)) for name in _SENT_ON)
        if (report := getattr(message, "report", None)) is not None:
            yield from ((_DAISY, name, field) for name, field in report._asdict().items())


def is_parameter(name: str) -> bool:
    """Tells whether any parameter or field has this name, in any case."""
    return name.upper() in _places()


def places_of() -> dict[str, list[str]]:
    """Returns the names of all parameters and fields, each with its operations and system commands."""
    found: dict[str, list[str]] = {}
    for place in (place for places in _places().values() for place in places):
        found.setdefault(place.name, []).append(place.owner)
    return {name: list(dict.fromkeys(found[name])) for name in sorted(found)}


@cache
def operation_names() -> dict[str, frozenset[str]]:
    """Returns the operations of each name: one for a full name, all of them for a family."""
    found: dict[str, set[str]] = {}
    for entry in _declared():
        found.setdefault(entry.name, set()).add(entry.name)
        found.setdefault(entry.opcode.name, set()).add(entry.name)
    return {name: frozenset(members) for name, members in found.items()}


@cache
def command_names() -> tuple[str, ...]:
    """Returns all names of CMDs, system commands and daisy commands."""
    of_operations = [entry.command for entry in _declared() if entry.command is not None]
    return tuple(dict.fromkeys(entry.name for entry in (*of_operations, *SYSTEM, *DaisySubCommand)))


@cache
def _declared() -> tuple[Declaration, ...]:
    return tuple(declarations(OPCODES))


def _place(entry: Declaration, parameter: Parameter) -> FieldPlace:
    held = str if parameter.type is Type.STRING else int
    return FieldPlace(entry.name, parameter.name, held, parameter.enum, parameter.unit)


def _holds(kind: FieldKind) -> type:
    texts = (FieldKind.TEXT, FieldKind.COUNTED_TEXT, FieldKind.LISTING)
    return str if kind in texts else bytes if kind is FieldKind.DATA else int


@cache
def _places() -> dict[str, list[FieldPlace]]:
    found = [_place(entry, parameter) for entry in _declared() for parameter in entry.parameters]
    for command in SYSTEM:
        fields = (*command.request, *command.reply)
        found += [FieldPlace(command.name, field.name, _holds(field.kind)) for field in fields]
    found += [FieldPlace(_DAISY, name, _holds(kind)) for name, kind in (_SENT_ON | _REPORT).items()]
    by_name: dict[str, list[FieldPlace]] = {}
    for place in found:
        by_name.setdefault(place.name.upper(), []).append(place)
    return by_name
