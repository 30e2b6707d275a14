"""The statements of one message to the bytes of its frame: header, memory, jumps, sizes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import accumulate

from ev3proto.errors import BuildError
from ev3proto.messages import DaisyCommand as DaisyMessage
from ev3proto.messages import DaisyReply, DirectCommand, Flaw, Message, Operation
from ev3proto.schema.frame import parse
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
from ev3proto.text.assembly.lexing import Token
from ev3proto.text.assembly.parser import Header, Named, RawFrame, error_at
from ev3proto.text.assembly.symbols import MOST_MEMORY, Names, suggestion
from ev3proto.text.assembly.values import CodePiece, Encoder, PendingJump

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

MAX_BODY = 1 << 19
"""Bytes that can be said of one message: faulty ones may be longer than any frame, as long as a line of hex."""


@dataclass
class PendingMessage:
    """A message while its statements are read.

    token       where it starts
    type        None for a direct command whose type is worked out
    facts       what its header says, in numbers
    is_frame    the bytes are all of the frame, its header included
    is_lenient  it may be faulty: it was written so on purpose
    has_header  a header began it: its values may mean nothing to the brick
    parts       operations, bodies of system messages and raw bytes, one by one, each in pieces
    size        bytes of all parts, where every jump is short
    """

    token: Token
    type: MessageType | None = None
    facts: dict[str, int] = field(default_factory=dict)
    is_frame: bool = False
    is_lenient: bool = False
    has_header: bool = False
    parts: list[Sequence[CodePiece]] = field(default_factory=list)
    size: int = 0

    @property
    def kind(self) -> str:
        """`direct-command`, `system-reply`, ..."""
        return MessageType.DIRECT_COMMAND_REPLY.kind if self.type is None else self.type.kind

    @property
    def carries_system(self) -> bool:
        """Whether it is a system command or the reply to one."""
        return self.type is not None and self.type.carries == "system"

    def add(self, token: Token, pieces: Sequence[CodePiece]) -> None:
        """One more part. Raises AssemblyError where there are more than anybody can mean."""
        self.size += max(1, sum(len(piece) if isinstance(piece, bytes) else 1 for piece in pieces))
        if self.size > MAX_BODY:
            raise error_at(token, f"the message has more than {MAX_BODY} bytes, and the largest frame {MAX_FRAME}")
        self.parts.append(pieces)

    def message(self, names: Names, dialect: str, counter: int, reply: bool | None) -> Message:
        """The message. Raises AssemblyError.

        Args:
            names: What the labels in it stand for.
            dialect: The firmware whose instruction set it is read by.
            counter: For a message that states none.
            reply: Whether a direct command without a stated type wants a reply; None: where it has global memory.
        """
        if self.type is None and not self.parts and not self.is_frame:
            raise error_at(self.token, "there is no operation in this message: the brick refuses an empty one")
        body = _joined(self.parts, names.labels)
        if self.is_frame:
            return parse(body, strict=False, dialect=dialect)
        try:
            frame = self._unread(body, names, dialect, counter, reply).build()
        except BuildError as error:
            raise error_at(self.token, str(error)) from None
        message = parse(frame, strict=False, dialect=dialect)
        if message.fault is not None and not self.is_lenient:
            raise error_at(self.token, f"the message cannot be sent: {message.fault}")
        return message

    def _unread(self, body: bytes, names: Names, dialect: str, counter: int, reply: bool | None) -> Message:
        """The message, its operations, payload or fields still as bytes."""
        counter = self.facts.get(COUNTER, counter)
        flaw = Flaw(rest=body, stated_length=self.facts.get(LENGTH))
        if self.type is None or self.type.kind == MessageType.DIRECT_COMMAND_REPLY.kind:
            sizes = self._memory(body, names, dialect)
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
            raise error_at(self.token, f"a daisy command needs a command: {known}, or a number")
        return DaisyMessage(
            type=self.type,
            counter=counter,
            number=self.facts[COMMAND],
            layer_from=layer_from,
            layer_to=layer_to,
            flaw=flaw,
        )

    def _memory(self, body: bytes, names: Names, dialect: str) -> dict[str, int]:
        """Bytes of memory that a direct command asks for: those stated, or those that it uses."""
        operations, _ = instruction_set(dialect).scan(body, 0, len(body))
        used = _used(operations)
        sizes = {}
        for scope, name in _MEMORIES.items():
            stated, declared = self.facts.get(name), names.sizes[scope]
            sizes[scope] = max(used[scope], declared) if stated is None else stated
            if stated is not None and declared > stated:
                raise error_at(
                    self.token, f"the variables take {declared} bytes of {scope} memory, and {name} says {stated}"
                )
            if stated is None and sizes[scope] > MOST_MEMORY[scope]:
                raise error_at(
                    self.token,
                    f"the operations use {sizes[scope]} bytes of {scope} memory; there are {MOST_MEMORY[scope]}"
                    f" (`message {name} {MOST_MEMORY[scope]}` in front of them leaves it at that)",
                )
        return sizes


def begun_by(header: Header | RawFrame, encoder: Encoder) -> PendingMessage:
    """The message that a header begins. Raises AssemblyError."""
    if isinstance(header, RawFrame):
        return PendingMessage(header.token, is_frame=True, is_lenient=True, has_header=True)
    pending = PendingMessage(header.token, None if header.type is None else _type(header.type), has_header=True)
    known = _ALL_FACTS | _FACTS.get(pending.kind, {})
    for token, value in header.facts:
        name = token.text
        if name not in known:
            hint = suggestion(name, known) or f": it has {', '.join(known)}"
            raise error_at(token, f"the header of a {pending.kind} has no {name}{hint}")
        if name in pending.facts:
            raise error_at(token, f"{name} is given already")
        if name == COMMAND and isinstance(value, Named):
            pending.facts[name] = _daisy_command(value.token)
            continue
        pending.facts[name] = encoder.whole(value, name, 0, known[name])
    pending.is_lenient = LENGTH in pending.facts or pending.facts.get(COMMAND) not in (None, *DaisyCommand)
    return pending


def _type(token: Token) -> MessageType:
    try:
        return MessageType[token.text]
    except KeyError:
        names = [member.name for member in MessageType]
        hint = suggestion(token.text, names) or f": it is one of {', '.join(names)}"
        raise error_at(token, f"there is no message type {token.text}{hint}") from None


def _daisy_command(token: Token) -> int:
    names = [command.name for command in DaisyCommand]
    if token.text not in names:
        hint = suggestion(token.text, names) or f": it is one of {', '.join(names)}, or a number"
        raise error_at(token, f"there is no daisy command {token.text}{hint}")
    return int(DaisyCommand[token.text])


def _used(operations: Iterable[Operation]) -> dict[str, int]:
    """Bytes of global and of local memory up to the last that operations use for sure."""
    used = {GLOBAL: 0, LOCAL: 0}
    for operation in operations:
        for found in footprints(operation):
            scope = found.argument.kind
            used[scope] = max(used[scope], found.start + (found.room or found.size))
    return used


def _joined(parts: Sequence[Sequence[CodePiece]], labels: dict[str, int]) -> bytes:
    """The parts with every jump in them worked out. Raises AssemblyError for jumps that cannot be made.

    A jump counts from the end of its operation, so how long it is depends on itself. It starts as short as can be and
    only ever becomes longer, which comes to an end.
    """
    jumps = {
        (index, at): piece
        for index, part in enumerate(parts)
        for at, piece in enumerate(part)
        if isinstance(piece, PendingJump)
    }
    for jump in jumps.values():
        if jump.token.text not in labels:
            hint = suggestion(jump.token.text, labels) or f": `{jump.token.text}:` in front of an operation makes one"
            raise error_at(jump.token, f"there is no label {jump.token.text}{hint}")
    encoded = {place: jump.encoded(0) for place, jump in jumps.items()}
    is_settled = not jumps
    while not is_settled:
        ends = list(accumulate((_size(index, part, encoded) for index, part in enumerate(parts)), initial=0))
        is_settled = True
        for place, jump in jumps.items():
            distance = ends[labels[jump.token.text]] - ends[place[0] + 1]
            longer = jump.encoded(distance, len(encoded[place]))
            is_settled &= len(longer) == len(encoded[place])
            encoded[place] = longer
    return b"".join(
        encoded[index, at] if isinstance(piece, PendingJump) else piece
        for index, part in enumerate(parts)
        for at, piece in enumerate(part)
    )


def _size(index: int, part: Sequence[CodePiece], encoded: dict[tuple[int, int], bytes]) -> int:
    return sum(len(encoded[index, at] if isinstance(piece, PendingJump) else piece) for at, piece in enumerate(part))
