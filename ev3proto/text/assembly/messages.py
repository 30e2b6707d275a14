"""Assembles one message: its header, memory, jumps, and the fields of system commands."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from ev3proto.errors import BuildError, near_misses
from ev3proto.messages import DaisyCommand, DaisyReply, DirectCommand, FieldValue, Flaw, Message
from ev3proto.schema.argument import text_bytes
from ev3proto.schema.fields import REPLIES, REQUESTS, Fields
from ev3proto.schema.frame import parse
from ev3proto.schema.instructions import instruction_set
from ev3proto.schema.wire_format import NUMBERS
from ev3proto.semantics.footprint import MEMORY_LIMITS, memory_of
from ev3proto.tables.daisy import DaisySubCommand
from ev3proto.tables.encoding import GLOBAL, LOCAL, STRING_CODING
from ev3proto.tables.frame import COUNTERS, DIRECT_COMMAND_TYPES, MAX_FRAME, MAX_GLOBALS, MAX_LOCALS, MessageType
from ev3proto.tables.system import SYSTEM, FieldKind, SystemDeclaration, SystemField, SystemStatus
from ev3proto.text.assembly.errors import SourceError
from ev3proto.text.assembly.names import LocalNames, choice
from ev3proto.text.assembly.notations import OF_FRAMES, STATUS, declared_name
from ev3proto.text.assembly.syntax import Call, MessageHeader, Name, Raw, RawFrame, WrittenArgument
from ev3proto.text.assembly.values import Encoder, Piece, joined

COUNTER, LENGTH, GLOBALS, LOCALS = "counter", "length", "globals", "locals"
COMMAND, LAYER_FROM, LAYER_TO = "command", "layer_from", "layer_to"

_FACTS = {
    "direct-command": {GLOBALS: MAX_GLOBALS, LOCALS: MAX_LOCALS},
    "daisy-command": {COMMAND: 0xFF, LAYER_FROM: 0xFF, LAYER_TO: 0xFF},
    "daisy-reply": {LAYER_FROM: 0xFF, LAYER_TO: 0xFF},
}
_ALL_FACTS = {COUNTER: COUNTERS - 1, LENGTH: 0xFFFF}
"""Facts that headers can state, of some kinds of messages and of all, with their largest numbers."""

_TYPES = [member.name for member in MessageType]
_MEMORIES = {GLOBAL: GLOBALS, LOCAL: LOCALS}

_LOGIC = {"true": True, "false": False}

_BY_NAME = {entry.name: entry for entry in reversed(SYSTEM)} | {declared_name(entry): entry for entry in SYSTEM}

MAX_BODY = 1 << 19
"""Maximum size of one assembled message; deliberately faulty ones may exceed a frame."""


@dataclass
class PendingMessage:
    """A message under construction."""

    at: int
    type: MessageType | None = None  # its type; None for a direct command whose type is computed
    facts: dict[str, int] = field(default_factory=dict)  # the numbers in its header
    is_frame: bool = False  # whether the bytes are a whole frame, its header included
    is_lenient: bool = False  # whether it may be faulty, on purpose
    has_header: bool = False  # whether a header begins it, so that its values may mean nothing to the brick
    parts: list[Piece] = field(default_factory=list)  # operations, bodies of system messages and raw bytes, in pieces
    size: int = 0  # bytes of all parts, if all jumps are short

    @property
    def kind(self) -> str:
        """`direct-command`, `system-reply`, ..."""
        return MessageType.DIRECT_COMMAND_REPLY.kind if self.type is None else self.type.kind

    @property
    def carries_system(self) -> bool:
        """Whether it is a system command or its reply."""
        return self.type is not None and self.type.carries == "system"

    def add(self, at: int, pieces: Iterable[Piece]) -> None:
        """Adds a part. Raises SourceError if the message becomes too long."""
        added = list(pieces)
        self.size += max(1, sum(len(piece) if isinstance(piece, bytes) else 1 for piece in added))
        if self.size > MAX_BODY:
            raise SourceError(at, f"the message has more than {MAX_BODY} bytes, and the largest frame {MAX_FRAME}")
        self.parts += added

    def message(
        self, local: LocalNames, sizes: Mapping[str, int], dialect: str, counter: int, reply: bool | None
    ) -> Message:
        """Returns the message; counter and reply are for a header without them. Raises SourceError."""
        if self.type is None and not self.parts and not self.is_frame:
            raise SourceError(self.at, "this message has no operation, and the brick refuses an empty one")
        body = joined(self.parts, local.labels, OF_FRAMES)
        if self.is_frame:
            return parse(body, strict=False, dialect=dialect)
        try:
            frame = self._unread(body, sizes, dialect, counter, reply).build()
        except BuildError as error:
            raise SourceError(self.at, str(error)) from None
        message = parse(frame, strict=False, dialect=dialect)
        if message.fault is not None and not self.is_lenient:
            raise SourceError(self.at, f"the message cannot be sent: {message.fault}")
        return message

    def _unread(
        self, body: bytes, declared: Mapping[str, int], dialect: str, counter: int, reply: bool | None
    ) -> Message:
        """Returns the message with its operations, payload or fields as bytes."""
        counter = self.facts.get(COUNTER, counter)
        flaw = Flaw(rest=body, stated_length=self.facts.get(LENGTH))
        if self.type is None or self.type.kind == MessageType.DIRECT_COMMAND_REPLY.kind:
            sizes = self._memory(body, declared, dialect)
            kind = self.type
            if kind is None:
                kind = DIRECT_COMMAND_TYPES[bool(sizes[GLOBAL] if reply is None else reply)]
            return DirectCommand(
                type=kind, counter=counter, global_size=sizes[GLOBAL], local_size=sizes[LOCAL], flaw=flaw
            )
        if self.type.carries != "daisy":
            return Message(type=self.type, counter=counter, flaw=flaw)
        layer_from, layer_to = self.facts.get(LAYER_FROM, 0), self.facts.get(LAYER_TO, 0)
        if not self.type.is_command:
            return DaisyReply(type=self.type, counter=counter, layer_from=layer_from, layer_to=layer_to, flaw=flaw)
        if COMMAND not in self.facts:
            known = ", ".join(command.name for command in DaisySubCommand)
            raise SourceError(self.at, f"a daisy command needs a command: {known}, or a number")
        return DaisyCommand(
            type=self.type,
            counter=counter,
            number=self.facts[COMMAND],
            layer_from=layer_from,
            layer_to=layer_to,
            flaw=flaw,
        )

    def _memory(self, body: bytes, variables: Mapping[str, int], dialect: str) -> dict[str, int]:
        """Returns the bytes of memory that a direct command requests: as stated, or as used."""
        operations, _ = instruction_set(dialect).scan(body, 0, len(body))
        used = memory_of(operations)._asdict()
        sizes = {}
        for scope, name in _MEMORIES.items():
            stated, declared = self.facts.get(name), variables[scope]
            sizes[scope] = max(used[name], declared) if stated is None else stated
            if stated is not None and declared > stated:
                raise SourceError(
                    self.at, f"the variables take {declared} bytes of {scope} memory, and {name} says {stated}"
                )
            if stated is None and sizes[scope] > MEMORY_LIMITS[scope]:
                raise SourceError(
                    self.at,
                    f"the operations use {sizes[scope]} bytes of {scope} memory; there are {MEMORY_LIMITS[scope]}"
                    f" (put `message {name} {MEMORY_LIMITS[scope]}` before them to allow it)",
                )
        return sizes


def begun_by(header: MessageHeader | RawFrame, encoder: Encoder) -> PendingMessage:
    """Returns the message that a header begins. Raises SourceError."""
    if isinstance(header, RawFrame):
        return PendingMessage(header.at, is_frame=True, is_lenient=True, has_header=True)
    kind = header.type
    type_ = None if kind is None else MessageType[choice(kind.text, kind.at, "unknown message type", _TYPES)]
    pending = PendingMessage(header.at, type_, has_header=True)
    known = _ALL_FACTS | _FACTS.get(pending.kind, {})
    for named, value in header.facts:
        name = named.text
        choice(name, named.at, f"the header of a {pending.kind} has no", known)
        if name in pending.facts:
            raise SourceError(named.at, f"{name} is given already")
        if name == COMMAND and isinstance(value, Name):
            names = [command.name for command in DaisySubCommand]
            found = choice(value.text, value.at, "unknown daisy command", names, ", or a number")
            pending.facts[name] = int(DaisySubCommand[found])
            continue
        pending.facts[name] = encoder.whole(value, name, 0, known[name])
    pending.is_lenient = LENGTH in pending.facts or pending.facts.get(COMMAND) not in (None, *DaisySubCommand)
    return pending


# System commands and their replies


def find_command(name: str) -> SystemDeclaration | None:
    """Returns a system command by name; the firmware's if the bootloader has it too."""
    return _BY_NAME.get(name)


def system_body(call: Call, encoder: Encoder, *, is_reply: bool, may_fail: bool) -> bytes:
    """Returns the bytes after the message type; with `may_fail`, fields may be missing. Raises SourceError."""
    entry = find_command(call.name)
    if entry is None:
        raise SourceError(call.at, f"unknown system command {call.name}{near_misses(call.name, _BY_NAME)}")
    arguments = list(call.arguments)
    head = bytes((entry.number,))
    if is_reply:
        status = _status(arguments, encoder)
        head += bytes((status,))
        may_fail |= status != SystemStatus.SUCCESS
    schema = (REPLIES if is_reply else REQUESTS)[entry.number]
    values = _values(entry.name, schema, arguments, encoder)
    try:
        completed = schema.completed(values)
        for field in schema.fields:
            if field.name not in completed and not (field.optional or may_fail) and call.is_complete:
                raise SourceError(call.end, f"{entry.name} needs {field.name} too: {field.text}")
        return head + schema.write_present(completed)
    except BuildError as error:
        raise SourceError(call.at, str(error)) from None


def _status(arguments: list[WrittenArgument], encoder: Encoder) -> int:
    """Returns the status of a reply, and removes it from the arguments."""
    for index, argument in enumerate(arguments):
        if argument.name is not None and argument.name.text == STATUS:
            value = arguments.pop(index).value
            if isinstance(value, Name):
                names = [member.name for member in SystemStatus]
                return SystemStatus[choice(value.text, value.at, "unknown status", names, ", or a number")]
            return encoder.whole(value, STATUS, 0, 0xFF)
    return SystemStatus.SUCCESS


def _values(
    name: str, schema: Fields, arguments: list[WrittenArgument], encoder: Encoder
) -> dict[str, FieldValue | float]:
    """Returns the fields by name. Values without names are for the fields in order, except lengths."""
    in_order = iter([field for field in schema.fields if field.counts is None])
    values: dict[str, FieldValue | float] = {}
    for argument in arguments:
        if argument.name is None:
            field = next(in_order, None)
            if field is None:
                fields = ", ".join(schema.by_name) or "no fields"
                raise SourceError(argument.at, f"{name} takes no further value: it has {fields}")
        else:
            named = argument.name
            field = schema.by_name[choice(named.text, named.at, f"{name} has no field", schema.by_name)]
        if field.name in values:
            raise SourceError(argument.at, f"{field.name} is given already")
        values[field.name] = _value(field, argument, encoder)
    return values


def _value(field: SystemField, argument: WrittenArgument, encoder: Encoder) -> FieldValue | float:
    value = argument.value
    if field.kind in NUMBERS:
        return encoder.whole(value, field.name, 0, (1 << 8 * NUMBERS[field.kind].sizeof()) - 1)
    if isinstance(value, Raw):
        return value.data if field.kind is FieldKind.DATA else value.data.decode(STRING_CODING)
    if field.is_message and isinstance(value, Name) and value.text.lower() in _LOGIC:
        return _LOGIC[value.text.lower()]
    found = encoder.meaning(value)
    if field.is_message:
        if isinstance(found, str | int | float):
            return found
        raise SourceError(value.at, f"{field.name} takes a text, a number, true, false or bytes(01 FF), not {found!r}")
    if not isinstance(found, str):
        expected = "a text or bytes(01 FF)" if field.kind is FieldKind.DATA else "a text"
        raise SourceError(value.at, f"{field.name} takes {expected}, not {found!r}")
    if field.kind is not FieldKind.DATA:
        return found
    try:
        return text_bytes(found, field.name, zeros=True)
    except BuildError as error:
        raise SourceError(value.at, str(error)) from None
