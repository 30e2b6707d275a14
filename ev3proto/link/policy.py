"""The policy of `proxy --read-only`, of `replay`, and of what the playground sends without a question.

A client may read; it changes nothing but the mode of a sensor, keeps nothing, holds up no other client, and leaves
nothing behind. docs/reference/read-only.md says how. `harms_of` judges one command; here are the commands around it.
There is no I/O: the caller sends the frames that a talk yields, one at a time, and passes the replies back.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping
from dataclasses import dataclass, field
from typing import TypeAlias, TypeGuard

from ev3proto.link.harm import Harm, harms_of
from ev3proto.link.reader import Reader
from ev3proto.link.transfers import OpenTransfers, is_of, next_of
from ev3proto.link.whitelist import with_types_kept
from ev3proto.messages import DirectCommand, Message, SystemCommand
from ev3proto.schema.frame import parse
from ev3proto.semantics.transfers import entry_of, step_of
from ev3proto.tables.declaration import Effect

PATIENCE = 15.0
"""Seconds after which a reply counts as lost; a command that reads takes less than 10."""


@dataclass(frozen=True)
class Outcome:
    """What became of a command."""

    harms: Mapping[Harm, str] = field(default_factory=dict)  # why it was not sent; empty if it was
    frame: bytes = b""  # the client's own
    reply: bytes | None = None  # the brick's; None if none came, or none was wanted


Talk: TypeAlias = Generator[bytes, bytes | None, Outcome]
"""Yields frames to send, and takes the reply to each; None if none came in time, or none is wanted."""


def conduct(talk: Talk, exchange: Callable[[bytes], bytes | None]) -> Outcome:
    """Runs a talk to its end; `exchange` sends a frame and returns the reply."""
    reply: bytes | None = None
    while True:
        try:
            frame = talk.send(reply)
        except StopIteration as end:
            outcome: Outcome = end.value
            return outcome
        reply = exchange(frame)


class Policy:
    """The commands of one client at a time, and what it has open on the brick."""

    def __init__(self, allowed: frozenset[str] = frozenset()) -> None:
        """Starts with nothing open. `allowed`: groups of harms, and full names, that may be sent besides reading."""
        self._reader = Reader()
        self._written = OpenTransfers()
        self._allowed = allowed
        self._is_strict = Harm.COMPUTING not in allowed

    @property
    def has_open(self) -> bool:
        """Whether something is open on the brick."""
        return bool(self._written) or self._reader.is_open

    def harms(self, message: Message) -> dict[Harm, str]:
        """Returns why a command is not sent."""
        harms = harms_of(message, self._allowed)
        if harms or not self._is_strict or not _is_later(message):
            return harms
        is_known = is_of(message, self._written) or is_of(message, self._reader.handles)
        return {} if is_known else {Harm.COMPUTING: f"{message.command} with this handle"}

    def talk(self, message: Message, *, is_allowed: bool = False) -> Talk:
        """Sends a command if it may be sent, in the form in which it only reads; or as it is, if it `is_allowed`."""
        frame, harms = message.build(), self.harms(message)
        if harms and not is_allowed:
            return Outcome(harms)
        if self._is_strict and not harms:
            if _is_reading(message) and not is_of(message, self._written):
                return Outcome({}, frame, (yield from self._reader.serve(message)))
            if isinstance(message, DirectCommand):
                message = with_types_kept(message)
        reply = yield message.build()
        self._written.learn(message, None if reply is None else parse(reply, strict=False))
        return Outcome({}, frame, reply)

    def leave(self) -> Talk:
        """Ends what is open on the brick."""
        yield from self._reader.leave()
        ending, reply = self._written.ending(), None
        while (command := next_of(ending, reply)) is not None:
            data = yield command.build()
            reply = None if data is None else parse(data, strict=False)
        return Outcome()

    def read_on(self) -> Talk:
        """Reads one more piece of the file or folder that is open, and keeps it for the client."""
        yield from self._reader.read_on()
        return Outcome()

    def forget(self) -> None:
        """Forgets what is open: the connection is a new one, and the handles may be another client's."""
        self._reader.forget()
        self._written.clear()


def _is_later(message: Message) -> TypeGuard[SystemCommand]:
    """Returns whether a command names the handle of a transfer."""
    return step_of(message) in ("continue", "close")


def _is_reading(message: Message) -> TypeGuard[SystemCommand]:
    """Returns whether a command is one of a transfer that reads."""
    entry = entry_of(message)
    return entry is not None and step_of(message) is not None and Effect.READS in entry.effects
