"""A packet for every operation of the tables, with its arguments, and the choice of the packet for byte code."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from typing import Any

from scapy.config import conf
from scapy.fields import Field, PacketListField, XByteEnumField
from scapy.packet import Packet
from scapy.volatile import RandFloat, RandNum, VolatileValue

from ev3proto.compose import command
from ev3proto.errors import BuildError, DecodeError
from ev3proto.messages import GV, Argument, DirectCommand, Operation, Variable
from ev3proto.schema.argument import ArgumentSchema
from ev3proto.schema.instructions import CMD, instruction_set
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import DIALECTS, Declaration, Direction, Parameter, Tail, Type, declarations
from ev3proto.tables.encoding import CONSTANT, RANGES
from ev3proto.tables.enumerations import FORMAT_TYPES
from ev3proto.tables.frame import MAX_FRAME

_HUGE = 10**30


class ArgumentField(Field[Any, bytes]):
    """One argument. Its value is a number, a text, a `Variable`, or bytes if its encoding is not the shortest."""

    __slots__ = ["names", "schema"]

    def __init__(self, schema: ArgumentSchema, default: Any, names: dict[int, str] | None = None) -> None:
        self.schema = schema
        self.names = names or {}
        super().__init__(schema.parameter.name, default, "s")

    def any2i(self, pkt: Packet | None, x: Any) -> Any:  # noqa: ARG002 - scapy's names and arguments, here and below
        """Returns the value. Raises BuildError at once for a value that the parameter cannot have."""
        if isinstance(x, int | float | str | bytes | Variable):
            self.schema.write(x)
        return x

    def i2repr(self, pkt: Packet | None, x: Any) -> str:  # noqa: ARG002
        """Returns the value with its name and unit."""
        return argument_text(self.schema, x, self.names)

    def i2len(self, pkt: Packet, x: Any) -> int:  # noqa: ARG002
        """Returns its size in the frame, in bytes."""
        return len(self.schema.write(x))

    def addfield(self, pkt: Packet, s: bytes, val: Any) -> bytes:  # noqa: ARG002
        """Appends the argument. Raises BuildError."""
        return s + self.schema.write(val)

    def getfield(self, pkt: Packet, s: bytes) -> tuple[bytes, Any]:  # noqa: ARG002
        """Returns the bytes after the argument, and its value. Raises DecodeError."""
        argument, end = self.schema.read(s, 0)
        return s[end:], value_of(self.schema, argument)

    def randval(self) -> VolatileValue[Any] | None:  # type: ignore[override]
        """Returns a random sensible number; None for texts and outputs, which are kept."""
        parameter = self.schema.parameter
        if parameter.direction is Direction.OUT or parameter.type is Type.STRING:
            return None
        if parameter.type is Type.DATAF:
            return RandFloat(-_HUGE, _HUGE)
        low, high = parameter.range or RANGES[parameter.type][:2]
        return RandNum(max(low, RANGES[parameter.type].low), min(high, RANGES[parameter.type].high))


class CountField(ArgumentField):
    """The number of arguments that follow. The default, None, counts them."""

    __slots__ = ["counted"]

    def __init__(self, schema: ArgumentSchema, name: str, counted: str) -> None:
        self.counted = counted
        super().__init__(schema, None)
        self.name = name

    def addfield(self, pkt: Packet, s: bytes, val: Any) -> bytes:
        """Appends the number, computed if not given."""
        return super().addfield(pkt, s, len(pkt.getfieldval(self.counted)) if val is None else val)


class ArgumentsField(Field[list[Any], bytes]):
    """A list of arguments, counted by another field. Their type is declared, or given by a third field."""

    __slots__ = ["counter", "tail"]
    islist = 1

    def __init__(self, tail: Tail, counter: str) -> None:
        self.tail = tail
        self.counter = counter
        super().__init__(tail.element.name, [], "s")

    def any2i(self, pkt: Packet | None, x: Any) -> Any:  # noqa: ARG002
        """Returns a list, also for a single value."""
        return x if x is None or isinstance(x, list | VolatileValue) else [x]

    def i2repr(self, pkt: Packet | None, x: Any) -> str:
        """Returns the arguments with names and units."""
        return f"[{', '.join(argument_text(self._schema(pkt, index), value) for index, value in enumerate(x))}]"

    def i2count(self, pkt: Packet | None, x: Any) -> int:  # noqa: ARG002
        """Returns their number."""
        return len(x)

    def addfield(self, pkt: Packet, s: bytes, val: Any) -> bytes:
        """Appends all arguments. Raises BuildError."""
        return s + b"".join(self._schema(pkt, index).write(value) for index, value in enumerate(val))

    def getfield(self, pkt: Packet, s: bytes) -> tuple[bytes, list[Any]]:
        """Returns the bytes after the last argument, and the values. Raises DecodeError."""
        count = number_of(pkt, self.counter)
        values = []
        for index in range(count or 0):
            schema = self._schema(pkt, index)
            argument, end = schema.read(s, 0)
            values.append(value_of(schema, argument))
            s = s[end:]
        return s, values

    def randval(self) -> None:  # type: ignore[override]
        """Keeps lists unchanged."""
        return

    def _schema(self, pkt: Packet | None, index: int) -> ArgumentSchema:
        """Returns the schema of an element."""
        element, typed_by = self.tail.element, self.tail.typed_by
        number = None if typed_by is None or pkt is None else number_of(pkt, typed_by)
        kind = element.type if number is None else FORMAT_TYPES.get(number, element.type)
        return ArgumentSchema(element._replace(name=f"{element.name}[{index}]", type=kind))


def default_of(parameter: Parameter) -> Any:
    """Returns the default value of an argument."""
    if parameter.direction is not Direction.IN:
        return GV(0)
    return "" if parameter.type is Type.STRING else 0


def value_of(schema: ArgumentSchema, argument: Argument) -> Any:
    """Returns the value that builds these bytes: the bytes themselves if they are not the shortest encoding."""
    value: Any = argument.value
    if argument.is_variable:
        value = Variable(argument.kind, int(argument.value), argument.form.handle, argument.form.address)
    try:
        if schema.write(value) == argument.raw:
            return value
    except BuildError:
        pass  # a number or text where the tables have another type, as some senders use
    return argument.raw


def number_of(pkt: Packet, name: str) -> int | None:
    """Returns the number of an argument in any form; None for a variable."""
    value = pkt.getfieldval(name)
    field = pkt.get_field(name)
    if value is None or not isinstance(field, ArgumentField):
        return None
    argument, _ = field.schema.read(field.schema.write(value), 0)
    return int(argument.value) if argument.kind == CONSTANT else None


def argument_text(schema: ArgumentSchema, value: Any, names: dict[int, str] | None = None) -> str:
    """Returns an argument as text: `440 Hz`, `LED_RED (2)`, `GV(0)`, `'myEV3'`, `LC2(1)`."""
    if value is None or isinstance(value, VolatileValue):
        return str(value)
    argument, _ = schema.read(schema.write(value), 0)
    if argument.is_variable or isinstance(value, bytes):
        text = f"{argument.encoding}({argument.value!r})" if isinstance(value, bytes) else str(value)
        text = f"HND({text})" if argument.form.handle else text
        return f"ADR({text})" if argument.form.address else text
    if isinstance(argument.value, str):
        return repr(argument.value)
    symbol = argument.symbol or (names or {}).get(int(argument.value) if argument.value == argument.value else -1)
    if symbol:
        return f"{symbol} ({argument.value})"
    unit = schema.parameter.unit
    return f"{argument.value} {unit}" if unit else str(argument.value)


COUNT = "_COUNT"
"""The suffix to the name of a list, for the field that counts it."""

conf.contribs.setdefault("ev3", {"dialect": DIALECTS[0]})


class EV3Operation(Packet):
    """The base of all operations: only the next operation follows."""

    name = "EV3 operation"

    def __init__(self, *arguments: Any, **fields: Any) -> None:
        try:
            super().__init__(*arguments, **fields)
        except AttributeError as error:
            # scapy's error has only the name.
            names = [field.name for field in self.fields_desc]
            if not any(name not in names for name in fields):
                raise
            parameters = ", ".join(names[1:]) or "none"
            raise AttributeError(f"{self.name} has no parameter {error}: it has {parameters}") from None

    def extract_padding(self, s: bytes) -> tuple[bytes, bytes]:
        """Leaves everything after an operation to the next one."""
        return b"", s


@cache
def operation_names() -> dict[str, Declaration]:
    """Returns the operations of all firmwares by the names of their layers: `SOUND_TONE`."""
    return {entry.name.replace(".", "_"): entry for entry in declarations(OPCODES) if entry.dialects}


@cache
def operation_layer(declaration: Declaration) -> type[EV3Operation]:
    """Returns the layer of an operation, created once."""
    opcode, command = declaration.opcode, declaration.command
    fields: list[Field[Any, Any]] = [XByteEnumField("opcode", opcode.number, {opcode.number: opcode.name})]
    if command is not None:
        fields.append(ArgumentField(CMD, command.number, {command.number: command.name}))
    tail = declaration.tail
    for parameter in declaration.fixed:
        schema = ArgumentSchema(parameter)
        if tail is None or parameter is not tail.counter:
            fields.append(ArgumentField(schema, default_of(parameter)))
            continue
        counter = parameter.name + COUNT * parameter.counts
        fields += [CountField(schema, counter, tail.element.name), ArgumentsField(tail, counter)]
    described = {"name": declaration.name, "fields_desc": fields, "__doc__": declaration.text}
    make: Any = type(EV3Operation)
    name = declaration.name.replace(".", "_")
    layer: type[EV3Operation] = make(name, (EV3Operation,), {**described, "__module__": __package__})
    return layer


class OperationsField(PacketListField):
    """Operations in a row. Results of `ev3proto.operation` are accepted, too."""

    def __init__(self, name: str) -> None:
        super().__init__(name, [], next_cls_cb=next_operation, max_count=MAX_FRAME)

    def any2i(self, pkt: Packet | None, x: Any) -> list[Any]:
        """Returns a list of packets, also for a single one."""
        given = x if isinstance(x, list) else [x]
        packets = [operation_layer(one.declaration)(one.raw) if isinstance(one, Operation) else one for one in given]
        found: list[Any] = super().any2i(pkt, packets)
        return found


def next_operation(pkt: Packet, before: Any, last: Any, remain: bytes) -> type[EV3Operation] | None:  # noqa: ARG001
    """Returns the layer of the first operation in bytes, None if unknown to the dialect. For PacketListField."""
    if not remain:
        return None
    instructions = instruction_set(conf.contribs["ev3"]["dialect"])
    schema = instructions.opcodes[remain[0]]
    if schema is None:
        try:
            schema, _ = instructions.select(remain, 0, len(remain))
        except DecodeError:
            return None
    return operation_layer(schema.declaration)


def in_a_row(packet: Packet) -> list[Packet]:
    """Returns an operation and those appended with `/`, each alone."""
    found: list[Packet] = []
    while isinstance(packet, EV3Operation):
        single = packet.copy()
        single.remove_payload()
        found.append(single)
        packet = packet.payload
    return found


def command_of(packets: Iterable[Packet]) -> DirectCommand:
    """Returns operations as a command, which requests the memory that they use; an empty one if they are unreadable."""
    data = b"".join(bytes(packet) for packet in packets)
    operations, fault = instruction_set(conf.contribs["ev3"]["dialect"]).scan(data, 0, len(data))
    try:
        return command(*(operations if fault is None else ()))
    except BuildError:
        return DirectCommand()
