"""The objects people hold: messages, their operations, the arguments of those. Immutable, typed, printable.

An operation is kept as the bytes that it has on the wire together with its declaration. That is why building what was
parsed gives the same bytes, whatever encodings it has.
"""

from __future__ import annotations

from collections import namedtuple
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from dataclasses import fields as dataclass_fields
from importlib import import_module
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple, Protocol

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
    """The local variable at an index (bytes, 0 or more). Raises BuildError for what is no number."""
    return Variable(LOCAL, _index(index), handle, address)


def GV(index: int, *, handle: bool = False, address: bool = False) -> Variable:  # noqa: N802 - the field's name
    """The global variable at an index (bytes, 0 or more): what the reply carries from offset 5 + index on.

    Raises BuildError for what is no number.
    """
    return Variable(GLOBAL, _index(index), handle, address)


def _getters(count: int) -> tuple[Any, ...]:
    """Read-only attributes for the fields of a tuple. Those of a named tuple are the fastest that there are."""
    names = [f"field{index}" for index in range(count)]
    fields = namedtuple("fields", names)  # type: ignore[misc]
    return tuple(getattr(fields, name) for name in names)


_ARGUMENT_PARTS = 5
_OPERATION_PARTS = 4
_WITHOUT_CONTENTS = "<{} without contents>"
"""What is shown of an argument or an operation that somebody made by hand: a debugger shows those, too."""

ArgumentValue = int | float | str
"""A number, a text, or the index of a variable."""


class Argument(tuple[Parameter, Encoding, ArgumentValue, int, bytes]):
    """What a frame carries for one parameter.

    parameter  what the tables declare
    form       how it is encoded: name, kind, width, handle, address
    value      number, text, or the index of a variable
    offset     of its identification byte, in the frame
    """

    # A busy stream makes a great many of these and of operations. Subclasses of a bare tuple, made from one tuple, take
    # half the time of any other immutable object: `pytest benchmarks` shows it in "parse".
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
        """True where the value is the index of a variable."""
        return self.form.kind == GLOBAL or self.form.kind == LOCAL

    @property
    def length(self) -> int:
        """Bytes in the frame."""
        width = self.form.width
        return self._data.index(0, self.offset + 1) + 1 - self.offset if width is None else 1 + width

    @property
    def raw(self) -> bytes:
        """Its bytes, identification byte first."""
        return self._data[self.offset : self.offset + self.length]

    @property
    def symbol(self) -> str | None:
        """The name of the value in the parameter's enumeration, None where it has none."""
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
        """The value as Python writes it: a variable as one."""
        if not self.is_variable:
            return repr(self.value)
        return repr(Variable(self.form.kind, int(self.value), self.form.handle, self.form.address))


class OperationReader(Protocol):
    """What an operation needs of its schema."""

    declaration: Declaration
    has_outputs: bool

    def __hash__(self) -> int:
        """Facts about it are kept by it."""

    def selector(self, data: bytes, at: int) -> Argument | None:
        """The CMD argument of the operation at an offset."""

    def arguments(self, data: bytes, at: int, end: int) -> tuple[Argument, ...]:
        """What follows opcode and CMD, up to the end of what can be read."""


_WITH_ARGUMENTS = _OPERATION_PARTS + 1
"""Length of an operation that has its arguments with it."""


class Operation(tuple[Any, ...]):
    """An opcode, its CMD if it has one, and its arguments.

    Made by `ev3proto.parse` and `ev3proto.operation`, not by hand.
    """

    __slots__ = ()

    if TYPE_CHECKING:
        _schema: OperationReader
        _data: bytes
        offset: int
        _end: int
    else:
        _schema, _data, offset, _end = _getters(_OPERATION_PARTS)  # a parsed operation has its arguments as the fifth

    is_complete: ClassVar[bool] = True
    """False for the last operation of a faulty frame, of which only the first arguments could be read."""

    @property
    def declaration(self) -> Declaration:
        """What the tables say of it."""
        return self._schema.declaration

    @property
    def name(self) -> str:
        """The opcode's name: `SOUND`."""
        return self._schema.declaration.opcode.name

    @property
    def opcode(self) -> int:
        """The opcode's number, 0 to 255."""
        return self._data[self.offset]

    @property
    def command(self) -> str | None:
        """CMD's name, `TONE`; None where the opcode has no CMD."""
        command = self._schema.declaration.command
        return command.name if command else None

    @property
    def full_name(self) -> str:
        """`SOUND.TONE`, or the opcode's name alone."""
        return self._schema.declaration.name

    @property
    def has_outputs(self) -> bool:
        """True where any of its parameters takes a value that the brick writes."""
        return self._schema.has_outputs

    @property
    def cmd(self) -> Argument | None:
        """CMD as it stands in the frame: a parameter like any other, with an encoding of its own."""
        return self._schema.selector(self._data, self.offset)

    @property
    def length(self) -> int:
        """Bytes in the frame."""
        return self._end - self.offset

    @property
    def raw(self) -> bytes:
        """Its bytes, opcode first."""
        return self._data[self.offset : self._end]

    @property
    def arguments(self) -> tuple[Argument, ...]:
        """What follows opcode and CMD, in the order of the frame; list elements too, one by one.

        Those of a parsed operation were read when it was. Those of others are read each time they are asked for.
        """
        if len(self) == _WITH_ARGUMENTS:
            found: tuple[Argument, ...] = self[-1]
            return found
        return self._schema.arguments(self._data, self.offset, self._end)

    def placed(self, frame: bytes, offset: int) -> Operation:
        """The same operation where it stands in a frame."""
        schema, _, start, end = self[:_OPERATION_PARTS]
        return type(self)((schema, frame, offset, offset + end - start))

    def __getnewargs__(self) -> tuple[tuple[Any, ...]]:
        """Copies and pickles have what the operation is made of, and read their arguments again."""
        return (self[:_OPERATION_PARTS],)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Operation):
            return NotImplemented
        return self._schema is other._schema and self.offset == other.offset and self.raw == other.raw

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
    """The last operation of a faulty frame: its opcode and CMD are known, and those arguments that could be read."""

    __slots__ = ()

    is_complete = False


class Flaw(NamedTuple):
    """What is kept of a faulty frame so that it builds back byte for byte.

    fault          what is wrong and where
    rest           the bytes that could not be read
    stated_length  the length field, where it does not say what the frame has
    headless       the frame ends before the fixed part of its body does, which is in `rest` then
    """

    fault: Fault | None = None
    rest: bytes = b""
    stated_length: int | None = None
    headless: bool = False

    def __repr__(self) -> str:
        shown = [f"{name}={value!r}" for name, value in self._asdict().items() if value not in (None, b"", False)]
        return f"Flaw({', '.join(shown)})"


NO_FLAW = Flaw()

_builder: list[Callable[[Message], bytes]] = []
_BUILDER = "ev3proto.schema.frame"
"""What registers the builder when it is loaded. It stands above the messages, so it is known by name alone."""


def builds_messages(build: Callable[[Message], bytes]) -> Callable[[Message], bytes]:
    """Registers what builds the frames of messages."""
    _builder[:] = [build]
    return build


_NOTHING: tuple[object, ...] = (NO_FLAW, None, 0, b"", (), {})
"""Values of a message's fields that stand there where nobody gives others."""


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Message:
    """What every message has. A message that is no subclass is one whose type is not known.

    type     which of the twelve types; None when the frame is too short or the type is unknown
    counter  the sender's message counter, 0 to 65535, echoed in the reply
    flaw     what a faulty frame has beside that; NO_FLAW for every frame that parses strictly
    """

    type: MessageType | None = None
    counter: int = 0
    flaw: Flaw = NO_FLAW

    @property
    def fault(self) -> Fault | None:
        """What is wrong with the frame, None when nothing is."""
        return self.flaw.fault

    @property
    def rest(self) -> bytes:
        """Bytes that could not be read: all of them where the type is None, none where nothing is wrong."""
        return self.flaw.rest

    @property
    def stated_length(self) -> int | None:
        """The length field where it does not say what the frame has, else None."""
        return self.flaw.stated_length

    @property
    def kind(self) -> str:
        """`direct-command`, `direct-reply`, `system-command`, ... or `unknown`."""
        return "unknown" if self.type is None else self.type.kind

    @property
    def wants_reply(self) -> bool:
        """True for commands that the brick answers."""
        return self.type is not None and self.type.wants_reply

    @property
    def length(self) -> int:
        """The length field: bytes that follow it."""
        return len(self.build()) - 2 if self.stated_length is None else self.stated_length

    def build(self) -> bytes:
        """Builds the frame.

        Returns:
            The frame. For a message that was parsed these are the bytes that it was parsed from.

        Raises:
            BuildError: No frame can carry the message. The sentence names the attribute at fault.

        """
        if not _builder:
            import_module(_BUILDER)
        return _builder[0](self)

    def __repr__(self) -> str:
        # What is as it is by default says nothing.
        names = [field.name for field in dataclass_fields(self) if field.name != "type"]
        present = [(name, getattr(self, name)) for name in names]
        shown = [f"{name}={value!r}" for name, value in present if value not in _NOTHING]
        kind = [] if self.type is None else [self.type.name]
        return f"{type(self).__name__}({', '.join([*kind, *shown])})"


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class DirectCommand(Message):
    """Operations for the brick's virtual machine.

    global_size  bytes of global memory asked for, 0 to 1023: the reply's payload
    local_size   bytes of local memory asked for, 0 to 63
    operations   what is to be run
    """

    global_size: int = 0
    local_size: int = 0
    operations: tuple[Operation, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class DirectReply(Message):
    """The answer to a direct command: all of its global memory, or an error that tells nothing more."""

    memory: bytes = b""

    @property
    def is_error(self) -> bool:
        """True when the brick refused or failed the command."""
        return self.type is MessageType.DIRECT_REPLY_ERROR


FieldValue = int | str | bytes
"""What a system message's field holds."""


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
    """The answer to a system command: which one, how it went, and what it gives back."""

    number: int = 0
    command: str | None = None
    status_code: int = 0
    fields: Mapping[str, FieldValue] = field(default_factory=dict, hash=False)

    @property
    def status(self) -> SystemStatus | None:
        """The status by name; None for a number that the firmware does not have."""
        try:
            return SystemStatus(self.status_code)
        except ValueError:
            return None

    @property
    def is_error(self) -> bool:
        """True when the command failed; END_OF_FILE is how an upload ends."""
        return self.status is None or self.status.is_failure or self.type is MessageType.SYSTEM_REPLY_ERROR


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class DaisyCommand(Message):
    """A message from brick to brick over the daisy chain.

    number      the sub-command
    command     its name, None when the number is unknown
    layer_from  counter of the layer it comes from
    layer_to    counter of the layer it goes to
    payload     what it carries
    operations  the payload read as byte code, where the sub-command carries byte code and all of it can be read
    """

    number: int = 0
    command: str | None = None
    layer_from: int = 0
    layer_to: int = 0
    payload: bytes = b""
    operations: tuple[Operation, ...] = ()


class SensorReport(NamedTuple):
    """A sensor of another layer as a daisy reply carries it.

    layer and port are 0 based; status, type and mode are the firmware's bytes; data is always 32 bytes.
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
    """The answer over the daisy chain; `report` is the payload read as a sensor's data where it has that shape."""

    layer_from: int = 0
    layer_to: int = 0
    payload: bytes = b""
    report: SensorReport | None = None
