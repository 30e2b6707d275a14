"""Where the tables have the names of parameters and fields, and what stands there in a message."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache

from ev3proto.capture.filter.comparisons import Arguments, Held
from ev3proto.capture.record import Record
from ev3proto.messages import DaisyCommand, DaisyReply, DirectReply, Message, Operation, SystemCommand, SystemReply
from ev3proto.tables import OPCODES
from ev3proto.tables.daisy import DaisyCommand as DaisyNumber
from ev3proto.tables.declaration import Declaration, Parameter, Type, declarations
from ev3proto.tables.system import SYSTEM, Kind

PATH = "path"
"""The field that says which file a message is about."""

ANY = "arg"
"""What stands before the dot where it does not matter whose parameter it is."""

_LIST = "["
"""What follows a parameter's name in the names of its values: `VALUES[0]`."""

_BETWEEN_BRICKS = "messages from brick to brick"

_TEXTS = (Kind.TEXT, Kind.COUNTED_TEXT, Kind.LISTING)

_DAISY = {
    "layer_from": Kind.U8,
    "layer_to": Kind.U8,
    "payload": Kind.DATA,
    "layer": Kind.U8,
    "port": Kind.U8,
    "status": Kind.U8,
    "type": Kind.U8,
    "mode": Kind.U8,
    "data": Kind.DATA,
    "checksum": Kind.U8,
    "busy": Kind.DATA,
}
"""What daisy messages and the sensor reports in them have, by the names of the attributes."""


@dataclass(slots=True)
class NamedFields:
    """What a name stands for in frames: parameters of operations, fields of system commands.

    operations  the parameter of each operation that has one of this name, by the operation's full name
    commands    the system commands that have a field of this name
    fields      those fields' kinds by the fields' names
    element     the only element of a list that is meant (`values[0]`), or nothing
    """

    operations: dict[str, Parameter] = field(default_factory=dict)
    commands: set[str | None] = field(default_factory=set)
    fields: dict[str, set[Kind]] = field(default_factory=dict)
    element: str = ""

    def __bool__(self) -> bool:
        return bool(self.operations or self.fields)

    @property
    def kind(self) -> Arguments:
        """What it can be compared with."""
        kinds = set().union(*self.fields.values())
        types = {
            parameter.element if parameter.type is Type.VALUES else parameter.type
            for parameter in self.operations.values()
        }
        enums = {parameter.enum.name: parameter.enum for parameter in self.operations.values() if parameter.enum}
        units = dict.fromkeys(parameter.unit for parameter in self.operations.values() if parameter.unit)
        return Arguments(
            tuple(enums.values()),
            units=tuple(units),
            number=bool(types - {Type.STRING} or kinds - {*_TEXTS, Kind.DATA}),
            text=bool(Type.STRING in types or kinds.intersection(_TEXTS)),
            data=Kind.DATA in kinds,
        )

    def of(self, owner: str) -> NamedFields:
        """Those of one operation, one family, or one system command, in upper case."""
        names = operation_names().get(owner, frozenset())
        operations = {name: parameter for name, parameter in self.operations.items() if name in names}
        commands = self.commands & {owner}
        return NamedFields(operations, commands, self.fields if commands else {}, self.element)

    def read(self, record: Record) -> Iterator[Held]:
        """What stands there in a message: arguments of commands, values and fields of replies."""
        message = record.message
        if isinstance(message, DirectReply):
            yield from self._values(record)
        elif isinstance(message, SystemCommand | SystemReply):
            if message.command in self.commands:
                yield from self._fields(message.fields)
        else:
            yield from self._arguments(getattr(message, "operations", ()))
            if None in self.commands:
                yield from self._fields(_daisy_fields(message))

    def read_with_path(self, record: Record) -> Iterator[Held]:
        """The same, with the path of the file that a message is about."""
        yield from self.read(record)
        if record.transfer is not None:
            yield Held(record.transfer.path)

    def _arguments(self, operations: Iterable[Operation]) -> Iterator[Held]:
        for operation in operations:
            parameter = self.operations.get(operation.full_name)
            if parameter is None:
                continue
            for argument in operation.arguments:
                if self._is_meant(argument.name, parameter):
                    yield Held(None if argument.is_variable else argument.value, parameter.enum, parameter.unit)

    def _values(self, record: Record) -> Iterator[Held]:
        for value in record.values:
            parameter = self.operations.get(value.full_name)
            if parameter is not None and self._is_meant(value.name, parameter):
                for item in value.value if isinstance(value.value, list) else (value.value,):
                    yield Held(item, parameter.enum, parameter.unit)

    def _is_meant(self, name: str, parameter: Parameter) -> bool:
        if self.element:
            return name.lower() == self.element
        return name == parameter.name or name.partition(_LIST)[0] == parameter.name

    def _fields(self, fields: Mapping[str, int | str | bytes]) -> Iterator[Held]:
        for name in self.fields:
            if name in fields:
                yield Held(fields[name])


def _daisy_fields(message: Message) -> dict[str, int | str | bytes]:
    if not isinstance(message, DaisyCommand | DaisyReply):
        return {}
    found: dict[str, int | str | bytes] = {
        name: getattr(message, name) for name in ("layer_from", "layer_to", "payload")
    }
    if isinstance(message, DaisyReply) and message.report is not None:
        found.update(message.report._asdict())
    return found


def find_fields(name: str) -> NamedFields:
    """Where a name stands, which is in lower case; nowhere for a name that there is not.

    `volume`, `sound.tone.volume`, `arg.size`, `values[0]`. The name of a command that has a single parameter stands for
    that parameter (`led`), where no parameter has the name.
    """
    owner, _, base = name.rpartition(".")
    base, bracket, index = base.partition(_LIST)
    places = _index().get(base) or _single(base)
    found = NamedFields(places.operations, places.commands, places.fields, f"{base}{bracket}{index}" if bracket else "")
    return found.of(owner.upper()) if owner and owner != ANY else found


def is_parameter(name: str) -> bool:
    """True for the name of any parameter or field, in any case."""
    return name.lower() in _index()


def parameter_names() -> list[str]:
    """The names of all parameters and fields, as the tables spell them."""
    return sorted({parameter.name for entry in _declared() for parameter in entry.parameters} | {*_fields()})


def places_of() -> dict[str, list[str]]:
    """The names of all parameters and fields, each with the operations and system commands that have it."""
    found: dict[str, list[str]] = {name: [] for name in parameter_names()}
    for entry in _declared():
        for parameter in entry.parameters:
            found[parameter.name].append(entry.name)
    for name, places in _fields().items():
        found[name] += [command or _BETWEEN_BRICKS for command, _ in places]
    return {name: list(dict.fromkeys(owners)) for name, owners in found.items()}


@cache
def operation_names() -> dict[str, frozenset[str]]:
    """The operations that a name stands for: one full name, or all of a family."""
    found: dict[str, set[str]] = {}
    for entry in _declared():
        found.setdefault(entry.name, set()).add(entry.name)
        found.setdefault(entry.opcode.name, set()).add(entry.name)
    return {name: frozenset(members) for name, members in found.items()}


def operations_of_opcode(number: int) -> frozenset[str]:
    """The operations of an opcode by its number."""
    return frozenset(entry.name for entry in _declared() if entry.opcode.number == number)


@cache
def command_names() -> dict[str, tuple[str, ...]]:
    """All names that a command can have: of CMDs, system commands and daisy commands; each stands for itself."""
    named = [entry.command.name for entry in _declared() if entry.command is not None]
    named += [entry.name for entry in SYSTEM]
    named += [entry.name for entry in DaisyNumber]
    return {name: (name,) for name in named}


@cache
def _declared() -> tuple[Declaration, ...]:
    return tuple(declarations(OPCODES))


def _fields() -> dict[str, list[tuple[str | None, Kind]]]:
    """The fields by name, each with the system command that has it, or None for daisy messages."""
    found: dict[str, list[tuple[str | None, Kind]]] = {}
    for entry in SYSTEM:
        for declared in (*entry.request, *entry.reply):
            found.setdefault(declared.name, []).append((entry.name, declared.kind))
    for name, kind in _DAISY.items():
        found.setdefault(name, []).append((None, kind))
    return found


@cache
def _index() -> dict[str, NamedFields]:
    found: dict[str, NamedFields] = {}
    for entry in _declared():
        for parameter in entry.parameters:
            found.setdefault(parameter.name.lower(), NamedFields()).operations[entry.name] = parameter
    for name, places in _fields().items():
        place = found.setdefault(name.lower(), NamedFields())
        for command, kind in places:
            place.commands.add(command)
            place.fields.setdefault(name, set()).add(kind)
    return found


def _single(command: str) -> NamedFields:
    """The parameter of the commands of this name, which have no other."""
    found = NamedFields()
    for entry in _declared():
        named = entry.command is not None and entry.command.name.lower() == command
        if named and len(entry.parameters) == 1:
            found.operations[entry.name] = entry.parameters[0]
    return found
