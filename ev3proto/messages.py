"""The public objects: messages, their operations, and their arguments. Immutable, typed, printable.

An operation consists of its bytes on the wire and its declaration. So a parsed message builds
the same bytes again, in any encoding.
"""

from __future__ import annotations

from collections import namedtuple
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from dataclasses import fields as dataclass_fields
from functools import cache
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple, Protocol, Self

from ev3proto.errors import BuildError, Fault
from ev3proto.tables.declaration import Declaration, Parameter
from ev3proto.tables.encoding import GLOBAL, LOCAL, Encoding
from ev3proto.tables.frame import MessageType
from ev3proto.tables.mailboxes import Reading, readings
from ev3proto.tables.system import SYSTEM_BY_NUMBER, SystemStatus


@dataclass(frozen=True, slots=True)
class Variable:
    """A place in local or global memory, for use as an argument: `LV(4)`, `GV(0)`.

    scope    "local" or "global"
    index    bytes from the start of that memory, 0 or more
    handle   the variable holds a handle to a memory object
    address  the variable holds an absolute address
    """

    scope: str
    index: int
    handle: bool = False
    address: bool = False

    def __str__(self) -> str:
        return f"{'G' if self.scope == GLOBAL else 'L'}V({self.index})"

    def __repr__(self) -> str:
        handle = ", handle=True" if self.handle else ""
        address = ", address=True" if self.address else ""
        return f"{str(self)[:-1]}{handle}{address})"


def _index(index: int) -> int:
    if isinstance(index, bool) or not isinstance(index, int):
        raise BuildError(f"the index of a variable must be a whole number, 0 or more, not {index!r}")
    return index


def LV(index: int, *, handle: bool = False, address: bool = False) -> Variable:  # noqa: N802 - the field's name
    """Returns the local variable at an index (bytes, 0 or more). Raises BuildError for any other index."""
    return Variable(LOCAL, _index(index), handle, address)


def GV(index: int, *, handle: bool = False, address: bool = False) -> Variable:  # noqa: N802 - the field's name
    """Returns the global variable at an index (bytes, 0 or more), at offset 5 + index of the reply.

    Raises BuildError for any other index.
    """
    return Variable(GLOBAL, _index(index), handle, address)


def _getters(count: int) -> tuple[Any, ...]:
    """Returns read-only attributes for the fields of a tuple, as fast as those of a named tuple."""
    names = [f"field{index}" for index in range(count)]
    fields = namedtuple("fields", names)  # type: ignore[misc]
    return tuple(getattr(fields, name) for name in names)


_ARGUMENT_PARTS = 5
_OPERATION_PARTS = 4
_WITHOUT_CONTENTS = "<{} without contents>"
"""The repr of an argument or operation created by hand, which a debugger may show."""

ArgumentValue = int | float | str
"""A number, a text, or the index of a variable."""


class Argument(tuple[Parameter, Encoding, ArgumentValue, int, bytes]):
    """The argument that a frame carries for one parameter.

    parameter  its declaration in the tables
    form       its encoding: name, kind, width, handle, address
    value      number, text, or the index of a variable
    offset     of its identification byte, in the frame
    """

    # Streams create very many arguments and operations. Subclasses of a bare tuple, created from one tuple, take
    # half the time of other immutable objects: see "parse" in `pytest benchmarks`.
    __slots__ = ()

    if TYPE_CHECKING:
        parameter: Parameter
        form: Encoding
        value: ArgumentValue
        offset: int
        _data: bytes
    else:
        parameter, form, value, offset, _data = _getters(_ARGUMENT_PARTS)

    @property
    def name(self) -> str:
        """The parameter's name as the firmware spells it; `VALUES[0]` for the elements of a list."""
        return self.parameter.name

    @property
    def encoding(self) -> str:
        """`LC0`, `LC2`, `LCS`, `GV1`, ..."""
        return self.form.name

    @property
    def kind(self) -> str:
        """`constant`, `string`, `local`, `global` or `label`."""
        return self.form.kind

    @property
    def is_variable(self) -> bool:
        """Whether the value is the index of a variable."""
        return self.form.kind == GLOBAL or self.form.kind == LOCAL

    @property
    def length(self) -> int:
        """Its size in the frame, in bytes."""
        width = self.form.width
        return self._data.index(0, self.offset + 1) + 1 - self.offset if width is None else 1 + width

    @property
    def raw(self) -> bytes:
        """Its bytes, identification byte first."""
        return self._data[self.offset : self.offset + self.length]

    @property
    def symbol(self) -> str | None:
        """The name of the value in the parameter's enumeration, or None."""
        if self.parameter.enum is None or self.is_variable:
            return None
        return self.parameter.enum.name_of(self.value)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Argument):
            return NotImplemented
        return (self.parameter, self.offset, self.raw) == (other.parameter, other.offset, other.raw)

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return hash((self.offset, self.raw))

    def __repr__(self) -> str:
        if len(self) != _ARGUMENT_PARTS or not isinstance(self.form, Encoding):
            return _WITHOUT_CONTENTS.format(type(self).__name__)
        return f"Argument({self.name}={self._shown()}, {self.encoding}, offset={self.offset})"

    def _shown(self) -> str:
        """Returns the repr of the value, or of the variable."""
        if not self.is_variable:
            return repr(self.value)
        return repr(Variable(self.form.kind, int(self.value), self.form.handle, self.form.address))


class OperationReader(Protocol):
    """The interface of a schema that an operation uses."""

    declaration: Declaration

    @property
    def has_outputs(self) -> bool:
        """Whether the brick writes any of its parameters."""

    def __hash__(self) -> int:
        """Hashes by identity; facts about a schema are cached by it."""

    def selector(self, data: bytes, at: int) -> Argument | None:
        """Returns the CMD argument of the operation at an offset."""

    def arguments(self, data: bytes, at: int, end: int) -> tuple[Argument, ...]:
        """Returns the readable arguments after opcode and CMD."""


_WITH_ARGUMENTS = _OPERATION_PARTS + 1
"""Length of the tuple of an operation that includes its arguments."""


class Operation(tuple[Any, ...]):
    """An opcode, its CMD if it has one, and its arguments.

    Created by `ev3proto.parse` and `ev3proto.operation`, not directly.

    schema  its schema, the same for all operations of its opcode and CMD
    offset  of its opcode, in the frame
    """

    __slots__ = ()

    if TYPE_CHECKING:
        schema: OperationReader
        _data: bytes
        offset: int
        _end: int
    else:
        schema, _data, offset, _end = _getters(
            _OPERATION_PARTS
        )  # the fifth part of a parsed operation is its arguments

    is_complete: ClassVar[bool] = True
    """False for the last operation of a faulty frame if only its first arguments could be read."""

    @property
    def declaration(self) -> Declaration:
        """Its declaration in the tables."""
        return self.schema.declaration

    @property
    def name(self) -> str:
        """The opcode's name: `SOUND`."""
        return self.schema.declaration.opcode.name

    @property
    def opcode(self) -> int:
        """The opcode's number, 0 to 255."""
        return self._data[self.offset]

    @property
    def command(self) -> str | None:
        """The name of its CMD, `TONE`; None if the opcode has no CMD."""
        command = self.schema.declaration.command
        return command.name if command else None

    @property
    def full_name(self) -> str:
        """`SOUND.TONE`, or the opcode's name alone."""
        return self.schema.declaration.name

    @property
    def has_outputs(self) -> bool:
        """Whether the brick writes any of its parameters."""
        return self.schema.has_outputs

    @property
    def cmd(self) -> Argument | None:
        """CMD in the frame: an argument like any other, with an encoding of its own."""
        return self.schema.selector(self._data, self.offset)

    @property
    def length(self) -> int:
        """Its size in the frame, in bytes."""
        return self._end - self.offset

    @property
    def raw(self) -> bytes:
        """Its bytes, opcode first."""
        return self._data[self.offset : self._end]

    @property
    def arguments(self) -> tuple[Argument, ...]:
        """The arguments after opcode and CMD, in the order of the frame, including list elements one by one.

        A parsed operation has them already; others read them on each access.
        """
        if len(self) == _WITH_ARGUMENTS:
            found: tuple[Argument, ...] = self[-1]
            return found
        return self.schema.arguments(self._data, self.offset, self._end)

    def read_by(self, schema: OperationReader) -> Self:
        """Returns the operation with its arguments read by another schema."""
        arguments = schema.arguments(self._data, self.offset, self._end)
        return type(self)((schema, self._data, self.offset, self._end, arguments))

    def __getnewargs__(self) -> tuple[tuple[Any, ...]]:
        """Copies and pickles keep the parts of the operation and read their arguments again."""
        return (self[:_OPERATION_PARTS],)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Operation):
            return NotImplemented
        return self.schema is other.schema and self.offset == other.offset and self.raw == other.raw

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return hash((self.raw, self.offset))

    def __repr__(self) -> str:
        if len(self) < _OPERATION_PARTS or not isinstance(self._data, bytes):
            return _WITHOUT_CONTENTS.format(type(self).__name__)
        arguments = ", ".join(f"{argument.name}={argument._shown()}" for argument in self.arguments)
        return f"<{self.full_name}({arguments}) at {self.offset}>"


class PartialOperation(Operation):
    """The last operation of a faulty frame: opcode and CMD are known, and the arguments that could be read."""

    __slots__ = ()

    is_complete = False


class Flaw(NamedTuple):
    """The extra parts of a faulty frame that let it build byte for byte.

    fault          what is wrong and where
    rest           the bytes that could not be read
    stated_length  the length field if it does not match the frame
    headless       whether the frame ends inside the fixed part of its body, which is then in `rest`
    """

    fault: Fault | None = None
    rest: bytes = b""
    stated_length: int | None = None
    headless: bool = False

    def __repr__(self) -> str:
        shown = [f"{name}={value!r}" for name, value in self._asdict().items() if value not in (None, b"", False)]
        return f"Flaw({', '.join(shown)})"


NO_FLAW = Flaw()


@cache
def _builder() -> Callable[[Message], bytes]:
    """Returns the function that builds frames, which is in a higher layer."""
    from ev3proto.schema.frame import build_message  # once: at each frame it would take a third of the time

    return build_message


_NOTHING: tuple[object, ...] = (NO_FLAW, None, 0, b"", (), {})
"""Default values of a message's fields."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Message:
    """The base of every message, and the class of a message of unknown type.

    type     one of the twelve types; None if the frame is too short or the type unknown
    counter  the sender's message counter, 0 to 65535, echoed in the reply
    flaw     the extra parts of a faulty frame; NO_FLAW if it parses strictly
    """

    type: MessageType | None = None
    counter: int = 0
    flaw: Flaw = NO_FLAW

    @property
    def fault(self) -> Fault | None:
        """What is wrong with the frame, or None."""
        return self.flaw.fault

    @property
    def rest(self) -> bytes:
        """Bytes that could not be read: all if the type is None, none if nothing is wrong."""
        return self.flaw.rest

    @property
    def stated_length(self) -> int | None:
        """The length field if it does not match the frame, else None."""
        return self.flaw.stated_length

    @property
    def kind(self) -> str:
        """`direct-command`, `direct-reply`, `system-command`, ... or `unknown`."""
        return "unknown" if self.type is None else self.type.kind

    @property
    def wants_reply(self) -> bool:
        """Whether the brick answers this command."""
        return self.type is not None and self.type.wants_reply

    @property
    def length(self) -> int:
        """The length field: number of bytes that follow it."""
        return len(self.build()) - 2 if self.stated_length is None else self.stated_length

    def build(self) -> bytes:
        """Builds the frame.

        Returns:
            The frame. A parsed message returns its original bytes.

        Raises:
            BuildError: The message does not fit into a frame. The error names the faulty attribute.

        """
        return _builder()(self)

    def __repr__(self) -> str:
        # Attributes with default values are omitted.
        names = [field.name for field in dataclass_fields(self) if field.name != "type"]
        present = [(name, getattr(self, name)) for name in names]
        shown = [f"{name}={value!r}" for name, value in present if value not in _NOTHING]
        kind = [] if self.type is None else [self.type.name]
        return f"{type(self).__name__}({', '.join([*kind, *shown])})"


def own_fault(message: Message, missing: int) -> Fault | None:
    """Returns what is wrong with a message, but for `missing` bytes at its end that a text or a capture left out."""
    fault = message.fault
    return None if fault is None or (missing and fault.truncated) else fault


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class DirectCommand(Message):
    """Operations for the brick's virtual machine.

    global_size  bytes of global memory requested, 0 to 1023: the reply's payload
    local_size   bytes of local memory requested, 0 to 63
    operations   the operations to run
    """

    global_size: int = 0
    local_size: int = 0
    operations: tuple[Operation, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class DirectReply(Message):
    """The answer to a direct command: all of its global memory, or an error without details."""

    memory: bytes = b""

    @property
    def is_error(self) -> bool:
        """Whether the brick refused the command or it failed."""
        return self.type is MessageType.DIRECT_REPLY_ERROR


FieldValue = int | str | bytes
"""The value of a system message's field."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class SystemCommand(Message):
    """A system command: its number, its firmware name (None when the number is unknown), its fields by name."""

    number: int = 0
    command: str | None = None
    fields: Mapping[str, FieldValue] = field(default_factory=dict, hash=False)

    @property
    def readings(self) -> dict[str, Reading]:
        """The readings that fit the message of a WRITEMAILBOX: `text`, `number`, `logic`; none for other commands."""
        entry = SYSTEM_BY_NUMBER.get(self.number)
        for declared in entry.request if entry is not None else ():
            payload = self.fields.get(declared.name)
            if declared.is_message and isinstance(payload, bytes):
                return readings(payload)
        return {}


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class SystemReply(Message):
    """The answer to a system command: its number, status and fields."""

    number: int = 0
    command: str | None = None
    status_code: int = 0
    fields: Mapping[str, FieldValue] = field(default_factory=dict, hash=False)

    @property
    def status(self) -> SystemStatus | None:
        """The status by name; None for a number unknown to the firmware."""
        try:
            return SystemStatus(self.status_code)
        except ValueError:
            return None

    @property
    def is_error(self) -> bool:
        """Whether the command failed; END_OF_FILE, at the end of an upload, is not a failure."""
        return self.status is None or self.status.is_failure or self.type is MessageType.SYSTEM_REPLY_ERROR


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class DaisyCommand(Message):
    """A message between bricks over the daisy chain.

    number      the sub-command
    command     its name, None if the number is unknown
    layer_from  counter of the layer it comes from
    layer_to    counter of the layer it goes to
    payload     its contents
    operations  the payload read as byte code, if the sub-command carries byte code and all of it can be read
    """

    number: int = 0
    command: str | None = None
    layer_from: int = 0
    layer_to: int = 0
    payload: bytes = b""
    operations: tuple[Operation, ...] = ()


class SensorReport(NamedTuple):
    """A sensor of another layer, as in a daisy reply.

    layer and port count from 0; status, type and mode are the firmware's bytes; data is always 32 bytes.
    """

    layer: int
    port: int
    status: int
    type: int
    mode: int
    data: bytes
    checksum: int
    busy: bytes = b""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class DaisyReply(Message):
    """The answer over the daisy chain; `report` is the payload read as a sensor's data, if it has that shape."""

    layer_from: int = 0
    layer_to: int = 0
    payload: bytes = b""
    report: SensorReport | None = None
