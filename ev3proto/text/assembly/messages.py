"""The statements of one message to the bytes of its frame: header, memory, jumps, sizes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from ev3proto.errors import BuildError
from ev3proto.messages import DaisyCommand as DaisyMessage
from ev3proto.messages import DaisyReply, DirectCommand, Flaw, Message, Operation
from ev3proto.schema.frame import parse
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.schema.instructions import instruction_set
from ev3proto.semantics.footprint import footprints
from ev3proto.tables.daisy import DaisyCommand
from ev3proto.tables.encoding import GLOBAL, LOCAL
from ev3proto.tables.frame import (
    COUNTERS,
    DIRECT_COMMAND_TYPES,
    MAX_FRAME,
    MAX_GLOBALS,
    MAX_LOCALS,
    MessageType,
)
from ev3proto.text.assembly.errors import SourceError
from ev3proto.text.assembly.names import LocalNames, suggestion
from ev3proto.text.assembly.notations import OF_FRAMES
from ev3proto.text.assembly.syntax import Header, Name, RawFrame
from ev3proto.text.assembly.values import Encoder, Piece, joined

COUNTER, LENGTH, GLOBALS, LOCALS = "counter", "length", "globals", "locals"
COMMAND, LAYER_FROM, LAYER_TO = "command", "layer_from", "layer_to"

_FACTS = {
    "direct-command": {GLOBALS: MAX_GLOBALS, LOCALS: MAX_LOCALS},
    "daisy-command": {COMMAND: 0xFF, LAYER_FROM: 0xFF, LAYER_TO: 0xFF},
    "daisy-reply": {LAYER_FROM: 0xFF, LAYER_TO: 0xFF},
}
_ALL_FACTS = {COUNTER: COUNTERS - 1, LENGTH: 0xFFFF}
"""What a header can say, of some kinds of message and of all, and the largest number that it can be."""

_MEMORIES = {GLOBAL: GLOBALS, LOCAL: LOCALS}

MOST_MEMORY = {GLOBAL: MAX_FRAME - HEADER_SIZE, LOCAL: MAX_LOCALS}
"""Bytes that variables can take: those that a reply carries, those that a header can ask for."""

MAX_BODY = 1 << 19
"""Bytes that can be said of one message: faulty ones may be longer than any frame, as long as a line of hex."""


@dataclass
class PendingMessage:
    """A message while its statements are read.

    at          where it starts
    type        None for a direct command whose type is worked out
    facts       what its header says, in numbers
    is_frame    the bytes are all of the frame, its header included
    is_lenient  it may be faulty: it was written so on purpose
    has_header  a header began it: its values may mean nothing to the brick
    parts       operations, bodies of system messages and raw bytes, in pieces
    size        bytes of all parts, where every jump is short
    """

    at: int
    type: MessageType | None = None
    facts: dict[str, int] = field(default_factory=dict)
    is_frame: bool = False
    is_lenient: bool = False
    has_header: bool = False
    parts: list[Piece] = field(default_factory=list)
    size: int = 0

    @property
    def kind(self) -> str:
        """`direct-command`, `system-reply`, ..."""
        return MessageType.DIRECT_COMMAND_REPLY.kind if self.type is None else self.type.kind

    @property
    def carries_system(self) -> bool:
        """Whether it is a system command or the reply to one."""
        return self.type is not None and self.type.carries == "system"

    def add(self, at: int, pieces: Iterable[Piece]) -> None:
        """One more part. Raises SourceError where there are more than anybody can mean."""
        added = list(pieces)
        self.size += max(1, sum(len(piece) if isinstance(piece, bytes) else 1 for piece in added))
        if self.size > MAX_BODY:
            raise SourceError(at, f"the message has more than {MAX_BODY} bytes, and the largest frame {MAX_FRAME}")
        self.parts += added

    def message(
        self, local: LocalNames, sizes: Mapping[str, int], dialect: str, counter: int, reply: bool | None
    ) -> Message:
        """The message. Raises SourceError.

        Args:
            local: Its labels.
            sizes: Bytes of its variables, by the kind of memory.
            dialect: The firmware whose instruction set it is read by.
            counter: For a message that states none.
            reply: Whether a direct command without a stated type wants a reply; None: where it has global memory.
        """
        if self.type is None and not self.parts and not self.is_frame:
            raise SourceError(self.at, "there is no operation in this message: the brick refuses an empty one")
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
        """The message, its operations, payload or fields still as bytes."""
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
            known = ", ".join(command.name for command in DaisyCommand)
            raise SourceError(self.at, f"a daisy command needs a command: {known}, or a number")
        return DaisyMessage(
            type=self.type,
            counter=counter,
            number=self.facts[COMMAND],
            layer_from=layer_from,
            layer_to=layer_to,
            flaw=flaw,
        )

    def _memory(self, body: bytes, variables: Mapping[str, int], dialect: str) -> dict[str, int]:
        """Bytes of memory that a direct command asks for: those stated, or those that it uses."""
        operations, _ = instruction_set(dialect).scan(body, 0, len(body))
        used = _used(operations)
        sizes = {}
        for scope, name in _MEMORIES.items():
            stated, declared = self.facts.get(name), variables[scope]
            sizes[scope] = max(used[scope], declared) if stated is None else stated
            if stated is not None and declared > stated:
                raise SourceError(
                    self.at, f"the variables take {declared} bytes of {scope} memory, and {name} says {stated}"
                )
            if stated is None and sizes[scope] > MOST_MEMORY[scope]:
                raise SourceError(
                    self.at,
                    f"the operations use {sizes[scope]} bytes of {scope} memory; there are {MOST_MEMORY[scope]}"
                    f" (`message {name} {MOST_MEMORY[scope]}` in front of them leaves it at that)",
                )
        return sizes


def begun_by(header: Header | RawFrame, encoder: Encoder) -> PendingMessage:
    """The message that a header begins. Raises SourceError."""
    if isinstance(header, RawFrame):
        return PendingMessage(header.at, is_frame=True, is_lenient=True, has_header=True)
    pending = PendingMessage(header.at, None if header.type is None else _type(header.type), has_header=True)
    known = _ALL_FACTS | _FACTS.get(pending.kind, {})
    for named, value in header.facts:
        name = named.text
        if name not in known:
            hint = suggestion(name, known) or f": it has {', '.join(known)}"
            raise SourceError(named.at, f"the header of a {pending.kind} has no {name}{hint}")
        if name in pending.facts:
            raise SourceError(named.at, f"{name} is given already")
        if name == COMMAND and isinstance(value, Name):
            pending.facts[name] = _daisy_command(value)
            continue
        pending.facts[name] = encoder.whole(value, name, 0, known[name])
    pending.is_lenient = LENGTH in pending.facts or pending.facts.get(COMMAND) not in (None, *DaisyCommand)
    return pending


def _type(name: Name) -> MessageType:
    try:
        return MessageType[name.text]
    except KeyError:
        names = [member.name for member in MessageType]
        hint = suggestion(name.text, names) or f": it is one of {', '.join(names)}"
        raise SourceError(name.at, f"unknown message type {name.text}{hint}") from None


def _daisy_command(name: Name) -> int:
    names = [command.name for command in DaisyCommand]
    if name.text not in names:
        hint = suggestion(name.text, names) or f": it is one of {', '.join(names)}, or a number"
        raise SourceError(name.at, f"unknown daisy command {name.text}{hint}")
    return int(DaisyCommand[name.text])


def _used(operations: Iterable[Operation]) -> dict[str, int]:
    """Bytes of global and of local memory up to the last that operations use for sure."""
    used = {GLOBAL: 0, LOCAL: 0}
    for operation in operations:
        for found in footprints(operation):
            scope = found.argument.kind
            used[scope] = max(used[scope], found.start + (found.room or found.size))
    return used
