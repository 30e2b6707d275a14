"""Turns assembly text into messages: groups statements into messages, and collects errors."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.messages import Message
from ev3proto.semantics.footprint import MEMORY_LIMITS
from ev3proto.tables import check_dialect
from ev3proto.tables.encoding import GLOBAL, LOCAL
from ev3proto.tables.frame import COUNTERS, MAX_GLOBALS, SYSTEM_COMMAND_TYPES
from ev3proto.tables.source import VARIABLE_WORDS
from ev3proto.tables.system import SystemDeclaration
from ev3proto.text.assembly.errors import MOST_ERRORS, AssemblyError, Lines, SourceError
from ev3proto.text.assembly.messages import PendingMessage, begun_by, find_command, system_body
from ev3proto.text.assembly.names import LocalNames, Memory, Names
from ev3proto.text.assembly.notations import MACRO_NOTATION, OF_FRAMES
from ev3proto.text.assembly.operations import Assembler
from ev3proto.text.assembly.parsing import Parser
from ev3proto.text.assembly.syntax import (
    Call,
    Closing,
    Define,
    Label,
    MessageHeader,
    Opening,
    Raw,
    RawFrame,
    Statement,
    VariableDeclaration,
)
from ev3proto.text.assembly.values import Encoder
from ev3proto.text.paste.elements import narrow

MAX_SOURCE = 1 << 24
"""Maximum characters of a text."""


def assembled(
    text: str, *, dialect: str = "official", counter: int = 0, reply: bool | None = None, unchecked: bool = False
) -> Iterator[Message]:
    """Yields the messages of a text, one after the other; parameters and errors as for `assemble`.

    If there are mistakes, the messages before the first one are yielded, then all errors are raised as one.
    """
    if len(text) > MAX_SOURCE:
        raise AssemblyError(1, 1, f"the text has {len(text)} characters; at most {MAX_SOURCE} can be assembled at once")
    parser = Parser(narrow(text), MACRO_NOTATION)
    work = _Work(check_dialect(dialect), counter, reply, parser.warnings, is_checked=not unchecked)
    for statement in parser.statements():
        if isinstance(statement, SourceError):
            work.errors.append(statement)
        else:
            yield from work.take(statement)
        if len(work.errors) >= MOST_ERRORS:
            break
    else:
        yield from work.finish()
    if work.errors:
        raise Lines(text).error(work.errors)


class _Work:
    """Takes one statement after the other, and yields complete messages."""

    def __init__(
        self, dialect: str, counter: int, reply: bool | None, warnings: list[tuple[int, str]], *, is_checked: bool
    ) -> None:
        self.errors: list[SourceError] = []
        self._is_checked = is_checked
        self._dialect = dialect
        self._counter = counter
        self._reply = reply
        self._names = Names(MACRO_NOTATION, lambda define, local: self._encoder.defined(define, local))
        self._encoder = Encoder(self._names, OF_FRAMES, warnings)
        self._assembler = Assembler(dialect, self._encoder)
        self._pending: PendingMessage | None = None
        self._thread: Opening | None = None
        self._memory: dict[str, Memory] = {}
        self._begin()

    def _begin(self) -> None:
        """Forgets the names that belong to one message."""
        self._names.local = LocalNames()
        self._memory = {scope: Memory(scope, MACRO_NOTATION, most) for scope, most in MEMORY_LIMITS.items()}

    def take(self, statement: Statement) -> Iterator[Message]:
        """Adds a statement; yields messages that are complete. Errors are kept."""
        try:
            if isinstance(statement, MessageHeader | RawFrame):
                yield from self.finish()
                self._pending = begun_by(statement, self._encoder)
            elif isinstance(statement, Call) and (entry := self._system_alone(statement)) is not None:
                yield from self.finish()
                wants_reply = entry.answered if self._reply is None else self._reply
                self._pending = PendingMessage(statement.at, SYSTEM_COMMAND_TYPES[bool(wants_reply)])
                self._add(statement)
                yield from self.finish()
            else:
                self._add(statement)
        except SourceError as error:
            self.errors.append(error)

    def finish(self) -> Iterator[Message]:
        """Yields the message that was begun, if there is one."""
        pending, self._pending = self._pending, None
        if self._thread is not None:
            self.errors.append(SourceError(self._thread.at, "the thread that begins here has no } at its end"))
            self._thread = None
        # After an error, a message is incomplete: further errors would only follow from that.
        if pending is not None and not self.errors:
            sizes = {scope: memory.size for scope, memory in self._memory.items()}
            try:
                message = pending.message(self._names.local, sizes, self._dialect, self._counter, self._reply)
            except SourceError as error:
                self.errors.append(error)
            else:
                self._counter = (message.counter + 1) % COUNTERS
                yield message
        self._begin()

    def _system_alone(self, call: Call) -> SystemDeclaration | None:
        """Returns a system command without a header, which is a complete message."""
        pending = self._pending
        is_awaited = pending is not None and pending.carries_system and not pending.parts
        return None if is_awaited else find_command(call.name)

    def _add(self, statement: Statement) -> None:
        """Adds a statement to the current message. Raises SourceError."""
        match statement:
            case Define():
                self._define(statement)
            case VariableDeclaration():
                self._declare(statement)
            case Label(at, name):
                pending = self._pending_operations(at, "a label")
                self._check_new(at, name)
                self._names.local.labels[name] = len(pending.parts)
            case Opening(at):
                if self._thread is not None:
                    raise SourceError(at, "a direct command is one thread: no second can begin in it")
                self._pending_operations(at, "a thread")
                self._thread = statement
            case Closing(at):
                if self._thread is None:
                    raise SourceError(at, "unexpected }: no { is open")
                self._thread = None
            case Raw(at, data):
                pending = self._opened(at)
                pending.is_lenient = True
                pending.add(at, [data])
            case Call():
                self._call(statement)

    def _define(self, define: Define) -> None:
        """Defines a name for a constant or an argument, which is evaluated now."""
        names, before = self._names, self._names.defines.get(define.name)
        meaning = names.defined(define, names.local)
        if before is not None:
            if names.defined(before, names.local) != meaning:
                raise SourceError(define.at, f"{define.name} is defined already")
            return
        self._check_new(define.at, define.name)
        names.defines[define.name] = define

    def _check_new(self, at: int, name: str) -> None:
        local = self._names.local
        for kind, known in (("a variable", local.places), ("a label", local.labels)):
            if name in known:
                raise SourceError(at, f"{name} is declared already, as {kind}")

    def _opened(self, at: int) -> PendingMessage:
        """Returns the current message; without one, a direct command begins."""
        if self._pending is None:
            self._pending = PendingMessage(at)
        return self._pending

    def _pending_operations(self, at: int, what: str) -> PendingMessage:
        pending = self._opened(at)
        if pending.is_frame or pending.kind not in ("direct-command", "daisy-command"):
            name = "a frame in bytes" if pending.is_frame else f"a {pending.kind}"
            raise SourceError(at, f"{what} is not allowed in {name}, which has no operations")
        return pending

    def _declare(self, statement: VariableDeclaration) -> None:
        self._pending_operations(statement.at, "a variable")
        count = 1
        if statement.size is not None:
            what = f"the number of elements of {statement.name}"
            count = self._encoder.whole(statement.size, what, 1, MAX_GLOBALS)
        self._check_new(statement.at, statement.name)
        is_local = statement.scope == LOCAL or (statement.scope is None and self._thread is not None)
        memory = self._memory[LOCAL if is_local else GLOBAL]
        kind = VARIABLE_WORDS[statement.word]
        place = memory.place(statement.at, statement.name, kind, count, statement.size is not None)
        self._names.local.places[statement.name] = place

    def _call(self, call: Call) -> None:
        pending = self._opened(call.at)
        if pending.carries_system:
            self._system_call(call, pending)
            return
        pending = self._pending_operations(call.at, "an operation")
        pending.is_lenient |= not call.is_complete
        pending.add(call.at, self._assembler.operation(call, is_checked=self._is_checked and not pending.has_header))

    def _system_call(self, call: Call, pending: PendingMessage) -> None:
        if pending.parts:
            raise SourceError(call.at, f"a {pending.kind} has one command; what follows can only be bytes")
        if self._assembler.is_operation(call.name):
            raise SourceError(call.at, f"{call.name} is an operation, which is not allowed in a {pending.kind}")
        assert pending.type is not None
        pending.is_lenient |= not call.is_complete
        is_reply = not pending.type.is_command
        body = system_body(call, self._encoder, is_reply=is_reply, may_fail=is_reply and pending.type.is_error)
        pending.add(call.at, [body])
