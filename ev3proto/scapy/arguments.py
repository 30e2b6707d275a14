"""Fields of operations: arguments with their identification bytes, and lists of them."""

from __future__ import annotations

from typing import Any

from scapy.fields import Field
from scapy.packet import Packet
from scapy.volatile import RandFloat, RandNum, VolatileValue

from ev3proto.errors import BuildError
from ev3proto.messages import GV, Argument, Variable
from ev3proto.schema.argument import ArgumentSchema
from ev3proto.tables.declaration import Direction, Parameter, Type
from ev3proto.tables.encoding import CONSTANT, RANGES
from ev3proto.tables.enumerations import FORMAT_TYPES

_HUGE = 10**30


class ArgumentField(Field[Any, bytes]):
    """One argument. Its value is a number, a text, a `Variable`, or bytes where its encoding is not the shortest."""

    __slots__ = ["names", "schema"]

    def __init__(self, schema: ArgumentSchema, default: Any, names: dict[int, str] | None = None) -> None:
        self.schema = schema
        self.names = names or {}
        super().__init__(schema.parameter.name, default, "s")

    def any2i(self, pkt: Packet | None, x: Any) -> Any:  # noqa: ARG002 - scapy's names and arguments, here and below
        """The value itself. Raises BuildError at once for what the parameter cannot be."""
        if isinstance(x, int | float | str | bytes | Variable):
            self.schema.write(x)
        return x

    def i2repr(self, pkt: Packet | None, x: Any) -> str:  # noqa: ARG002
        """As people write it: with the name of the number and the unit."""
        return argument_text(self.schema, x, self.names)

    def i2len(self, pkt: Packet, x: Any) -> int:  # noqa: ARG002
        """Bytes in the frame."""
        return len(self.schema.write(x))

    def addfield(self, pkt: Packet, s: bytes, val: Any) -> bytes:  # noqa: ARG002
        """Appends the argument. Raises BuildError."""
        return s + self.schema.write(val)

    def getfield(self, pkt: Packet, s: bytes) -> tuple[bytes, Any]:  # noqa: ARG002
        """What follows the argument, and its value. Raises DecodeError."""
        argument, end = self.schema.read(s, 0)
        return s[end:], value_of(self.schema, argument)

    def randval(self) -> VolatileValue[Any] | None:  # type: ignore[override]
        """A random number that makes sense; nothing for texts and outputs, which stay as they are."""
        parameter = self.schema.parameter
        if parameter.direction is Direction.OUT or parameter.type is Type.STRING:
            return None
        if parameter.type is Type.DATAF:
            return RandFloat(-_HUGE, _HUGE)
        low, high = parameter.range or RANGES[parameter.type][:2]
        return RandNum(max(low, RANGES[parameter.type].low), min(high, RANGES[parameter.type].high))


class CountField(ArgumentField):
    """How many arguments follow. None, which is the default, stands for as many as there are."""

    __slots__ = ["counted"]

    def __init__(self, schema: ArgumentSchema, name: str, counted: str) -> None:
        self.counted = counted
        super().__init__(schema, None)
        self.name = name

    def addfield(self, pkt: Packet, s: bytes, val: Any) -> bytes:
        """Appends the number, which is worked out where it is not given."""
        return super().addfield(pkt, s, len(pkt.getfieldval(self.counted)) if val is None else val)


class ArgumentsField(Field[list[Any], bytes]):
    """As many arguments as another field says. Their type is declared, or a third field tells it."""

    __slots__ = ["counter", "parameter"]
    islist = 1

    def __init__(self, parameter: Parameter, counter: str) -> None:
        self.parameter = parameter
        self.counter = counter
        super().__init__(parameter.name, [], "s")

    def any2i(self, pkt: Packet | None, x: Any) -> Any:  # noqa: ARG002
        """A list, also of a single value."""
        return x if x is None or isinstance(x, list | VolatileValue) else [x]

    def i2repr(self, pkt: Packet | None, x: Any) -> str:
        """The arguments as people write them."""
        return f"[{', '.join(argument_text(self._schema(pkt, index), value) for index, value in enumerate(x))}]"

    def i2count(self, pkt: Packet | None, x: Any) -> int:  # noqa: ARG002
        """How many there are."""
        return len(x)

    def addfield(self, pkt: Packet, s: bytes, val: Any) -> bytes:
        """Appends them all. Raises BuildError."""
        return s + b"".join(self._schema(pkt, index).write(value) for index, value in enumerate(val))

    def getfield(self, pkt: Packet, s: bytes) -> tuple[bytes, list[Any]]:
        """What follows the last argument, and their values. Raises DecodeError."""
        count = number_of(pkt, self.counter)
        values = []
        for index in range(count or 0):
            schema = self._schema(pkt, index)
            argument, end = schema.read(s, 0)
            values.append(value_of(schema, argument))
            s = s[end:]
        return s, values

    def randval(self) -> None:  # type: ignore[override]
        """Lists stay as they are."""
        return

    def _schema(self, pkt: Packet | None, index: int) -> ArgumentSchema:
        """The schema of an element."""
        element = self.parameter.element
        if isinstance(element, str):
            number = None if pkt is None else number_of(pkt, element)
            element = FORMAT_TYPES.get(number) if number is not None else None
        direction = self.parameter.elements if self.parameter.type is Type.COUNT else Direction.IN
        name = f"{self.parameter.name}[{index}]"
        kind = element or Type.ARRAY_TYPED
        return ArgumentSchema(self.parameter._replace(name=name, type=kind, direction=direction, element=None))


def default_of(parameter: Parameter) -> Any:
    """What stands in an argument of which nobody says anything."""
    if parameter.direction is not Direction.IN:
        return GV(0)
    return "" if parameter.type is Type.STRING else 0


def value_of(schema: ArgumentSchema, argument: Argument) -> Any:
    """The value of which the schema makes these bytes again: the bytes themselves where they are not the shortest."""
    value: Any = argument.value
    if argument.is_variable:
        value = Variable(argument.kind, int(argument.value), argument.form.handle, argument.form.address)
    try:
        if schema.write(value) == argument.raw:
            return value
    except BuildError:
        pass  # a number or text where the tables have another type, which senders do
    return argument.raw


def number_of(pkt: Packet, name: str) -> int | None:
    """The number that an argument is, however it is given; None for a variable."""
    value = pkt.getfieldval(name)
    field = pkt.get_field(name)
    if value is None or not isinstance(field, ArgumentField):
        return None
    argument, _ = field.schema.read(field.schema.write(value), 0)
    return int(argument.value) if argument.kind == CONSTANT else None


def argument_text(schema: ArgumentSchema, value: Any, names: dict[int, str] | None = None) -> str:
    """An argument as people write it: `440 Hz`, `LED_RED (2)`, `GV(0)`, `'myEV3'`, `LC2(1)`."""
    if value is None or isinstance(value, VolatileValue):
        return str(value)
    argument, _ = schema.read(schema.write(value), 0)
    if argument.is_variable or isinstance(value, bytes):
        text = f"{argument.encoding}({argument.value!r})" if isinstance(value, bytes) else str(value)
        marks = (("HND", argument.form.handle), ("ADR", argument.form.address))
        for mark in (name for name, is_set in marks if is_set):
            text = f"{mark}({text})"
        return text
    if isinstance(argument.value, str):
        return repr(argument.value)
    symbol = argument.symbol or (names or {}).get(int(argument.value) if argument.value == argument.value else -1)
    if symbol:
        return f"{symbol} ({argument.value})"
    unit = schema.parameter.unit
    return f"{argument.value} {unit}" if unit else str(argument.value)
