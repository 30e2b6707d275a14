"""Assembly text to messages: which statement belongs to which message, and what of it is wrong."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.messages import Message
from ev3proto.tables import check_dialect
from ev3proto.tables.encoding import GLOBAL, LOCAL
from ev3proto.tables.frame import COUNTERS, MAX_GLOBALS, SYSTEM_COMMAND_TYPES
from ev3proto.text.assembly.errors import MOST_ERRORS, MOST_SAID, AssemblyError
from ev3proto.text.assembly.lexing import Token
from ev3proto.text.assembly.messages import PendingMessage, begun_by
from ev3proto.text.assembly.operations import Assembler
from ev3proto.text.assembly.parser import (
    LOCAL_WORD,
    TYPES,
    Call,
    Closing,
    Define,
    Header,
    Label,
    Opening,
    RawBytes,
    RawFrame,
    Statement,
    VariableDeclaration,
    error_at,
    statements,
)
from ev3proto.text.assembly.symbols import Names
from ev3proto.text.assembly.system import find_command, system_body
from ev3proto.text.assembly.values import Encoder

MAX_TEXT = 1 << 24
"""Characters of a text that is assembled."""


def assembled(
    text: str, *, dialect: str = "official", counter: int = 0, reply: bool | None = None, unchecked: bool = False
) -> Iterator[Message]:
    """The messages of a text, one after the other; parameters and errors as for `assemble`.

    Where something is wrong, the messages in front of it are given, and then all errors are raised as one.
    """
    if len(text) > MAX_TEXT:
        raise AssemblyError(1, 1, f"the text has {len(text)} characters; at most {MAX_TEXT} can be assembled at once")
    work = _Work(check_dialect(dialect), counter, reply, is_checked=not unchecked)
    for statement in statements(text):
        if isinstance(statement, AssemblyError):
            work.errors.append(statement)
        else:
            yield from work.take(statement)
        if len(work.errors) >= MOST_ERRORS:
            break
    else:
        yield from work.finish()
    if work.errors:
        raise _together(work.errors, text)


def _together(errors: list[AssemblyError], text: str) -> AssemblyError:
    """One error of all, each with the line that it is in."""
    lines = text.split("\n")
    first, *others = (
        AssemblyError(error.line, error.column, _short(error.reason), lines[error.line - 1].rstrip("\r"))
        for error in sorted(errors, key=lambda error: (error.line, error.column))
    )
    return AssemblyError(first.line, first.column, first.reason, first.text, tuple(others))


def _short(reason: str) -> str:
    return reason if len(reason) <= MOST_SAID else f"{reason[:MOST_SAID]}..."


class _Work:
    """Takes statement after statement and gives the messages that are complete."""

    def __init__(self, dialect: str, counter: int, reply: bool | None, *, is_checked: bool) -> None:
        self.errors: list[AssemblyError] = []
        self._is_checked = is_checked
        self._dialect = dialect
        self._counter = counter
        self._reply = reply
        self._names = Names()
        self._encoder = Encoder(self._names)
        self._assembler = Assembler(dialect, self._encoder)
        self._pending: PendingMessage | None = None
        self._thread: Token | None = None

    def take(self, statement: Statement) -> Iterator[Message]:
        """What is complete when a statement came. Errors are kept."""
        try:
            if isinstance(statement, Header | RawFrame):
                yield from self.finish()
                self._pending = begun_by(statement, self._encoder)
            elif isinstance(statement, Call) and self._stands_alone(statement):
                yield from self.finish()
                self._pending = self._pending_system(statement)
                self._add(statement)
                yield from self.finish()
            else:
                self._add(statement)
        except AssemblyError as error:
            self.errors.append(error)

    def finish(self) -> Iterator[Message]:
        """The message that was begun, if there is one."""
        pending, self._pending = self._pending, None
        if self._thread is not None:
            self.errors.append(error_at(self._thread, "the thread that begins here has no } at its end"))
            self._thread = None
        # With an error in the text, a message lacks what was wrong: more errors would only follow from that.
        if pending is not None and not self.errors:
            try:
                message = pending.message(self._names, self._dialect, self._counter, self._reply)
            except AssemblyError as error:
                self.errors.append(error)
            else:
                self._counter = (message.counter + 1) % COUNTERS
                yield message
        self._names.begin_message()

    def _stands_alone(self, call: Call) -> bool:
        """Whether it is a system command that no header waits for, so a message of its own."""
        pending = self._pending
        is_awaited = pending is not None and pending.carries_system and not pending.parts
        return not is_awaited and find_command(call.token.text) is not None

    def _pending_system(self, call: Call) -> PendingMessage:
        entry = find_command(call.token.text)
        assert entry is not None
        wants_reply = entry.answered if self._reply is None else self._reply
        kind = SYSTEM_COMMAND_TYPES[bool(wants_reply)]
        return PendingMessage(call.token, kind)

    def _add(self, statement: Statement) -> None:
        """A statement of the message that is read. Raises AssemblyError."""
        match statement:
            case Define(token, value):
                self._encoder.define(token, value)
            case VariableDeclaration():
                self._declare(statement)
            case Label(token):
                pending = self._pending_operations(token, "a label")
                self._names.mark(token, len(pending.parts))
            case Opening(token):
                if self._thread is not None:
                    raise error_at(token, "a direct command is one thread: no second can begin in it")
                self._pending_operations(token, "a thread")
                self._thread = token
            case Closing(token):
                if self._thread is None:
                    raise error_at(token, "there is no { that this } could end")
                self._thread = None
            case RawBytes(token, data):
                pending = self._opened(token)
                pending.is_lenient = True
                pending.add(token, [data])
            case Call():
                self._call(statement)

    def _opened(self, token: Token) -> PendingMessage:
        """The message that is read; a direct command begins where there is none."""
        if self._pending is None:
            self._pending = PendingMessage(token)
        return self._pending

    def _pending_operations(self, token: Token, what: str) -> PendingMessage:
        pending = self._opened(token)
        if pending.is_frame or pending.kind not in ("direct-command", "daisy-command"):
            name = "a frame in bytes" if pending.is_frame else f"a {pending.kind}"
            raise error_at(token, f"{what} cannot stand in {name}, which has no operations")
        return pending

    def _declare(self, statement: VariableDeclaration) -> None:
        token = statement.token
        self._pending_operations(token, "a variable")
        kind = TYPES[statement.type.text]
        count = 1
        if statement.size is not None:
            count = self._encoder.whole(statement.size, f"the number of elements of {token.text}", 1, MAX_GLOBALS)
        is_local = statement.scope == LOCAL_WORD or (statement.scope is None and self._thread is not None)
        self._names.declare(token, kind, count, LOCAL if is_local else GLOBAL)

    def _call(self, call: Call) -> None:
        pending = self._opened(call.token)
        if pending.carries_system:
            self._system_call(call, pending)
            return
        pending = self._pending_operations(call.token, "an operation")
        pending.is_lenient |= not call.is_complete
        pending.add(call.token, self._assembler.operation(call, is_checked=self._is_checked and not pending.has_header))

    def _system_call(self, call: Call, pending: PendingMessage) -> None:
        if pending.parts:
            raise error_at(call.token, f"a {pending.kind} has one command; what follows can only be bytes")
        if self._assembler.is_operation(call.token):
            raise error_at(call.token, f"{call.token.text} is an operation, which cannot stand in a {pending.kind}")
        assert pending.type is not None
        pending.is_lenient |= not call.is_complete
        is_reply = not pending.type.is_command
        pending.add(
            call.token,
            [system_body(call, self._encoder, is_reply=is_reply, may_fail=is_reply and pending.type.is_error)],
        )
