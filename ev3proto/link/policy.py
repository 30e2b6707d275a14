"""The policy of `proxy --read-only`, of `replay`, and of what the playground sends without a question.

A client may read; it changes nothing but the mode of a sensor, keeps nothing, holds up no other client, and leaves
nothing behind. docs/reference/read-only.md says how. `harms_of` judges one command; here are the commands around it.
There is no I/O: the caller sends the frames that a talk yields, one at a time, and passes the replies back.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping
from dataclasses import dataclass, field
from typing import TypeAlias

from ev3proto.link.asking import question_about
from ev3proto.link.harm import Harm, harms_of
from ev3proto.link.known import ASSUMED
from ev3proto.link.transfers import NO_TRANSFERS, OpenTransfers, is_listing
from ev3proto.messages import Message, SystemCommand
from ev3proto.schema.constructors import system_command
from ev3proto.schema.frame import parse
from ev3proto.schema.header import HEADER_SIZE, build_frame
from ev3proto.system import close_filehandle, continue_list_files
from ev3proto.tables.declaration import Effect
from ev3proto.tables.frame import MAX_FRAME, MessageType
from ev3proto.tables.system import SYSTEM_BY_NUMBER, FieldKind, SystemDeclaration, SystemStatus

PATIENCE = 15.0
"""Seconds after which a reply counts as lost; a command that reads takes less than 10."""

_MOST_PIECES = 10_000
"""Pieces of a listing that is read to its end; the largest folder has fewer."""

_SIZES = {FieldKind.U8: 1, FieldKind.U16: 2, FieldKind.U32: 4}


@dataclass(frozen=True)
class Outcome:
    """What became of a command."""

    harms: Mapping[Harm, str] = field(default_factory=dict)  # why it was not sent; empty if it was
    frame: bytes = b""  # as it was sent
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

    def __init__(self, allowed: frozenset[str] = frozenset(), *, is_plan: bool = False) -> None:
        """Starts with nothing open.

        Args:
            allowed: Groups of harms, and full names, that may be sent besides reading.
            is_plan: Nothing is asked, as there is no brick: ports and files are as the commands say.
        """
        self.transfers = OpenTransfers()
        self._allowed = allowed
        self._is_plan = is_plan

    def talk(self, message: Message, *, is_own: bool = True) -> Talk:
        """Sends a command if it may be sent, with what has to come before it.

        Args:
            message: The command.
            is_own: Whether its handle, if it has one, is of a reply to the same sender.
        """
        transfers = self.transfers if is_own else NO_TRANSFERS
        listing = _closed_listing(message, transfers)
        if listing is not None:
            yield from self._end(listing)
            return Outcome(reply=_closed(message, listing))
        harms = yield from self._judge(message, transfers)
        if harms:
            return Outcome(harms)
        entry = _entry(message)
        if entry is not None and entry.transfer == "begin" and Effect.READS in entry.effects:
            # The firmware continues the file or listing that was opened last, whatever handle is named.
            yield from self.leave()
        message = _lowered(message)
        frame = message.build()
        reply = yield frame
        self.transfers.learn(message, None if reply is None else parse(reply, strict=False))
        return Outcome({}, frame, reply)

    def leave(self) -> Talk:
        """Closes the files that are open, and reads listings to their end."""
        for handle in list(self.transfers):
            yield from self._end(handle)
        return Outcome()

    def forget(self) -> None:
        """Forgets what is open: the connection is a new one, and the handles may be another client's."""
        self.transfers.clear()

    def _judge(self, message: Message, transfers: Mapping[int, str]) -> Generator[bytes, bytes | None, dict[Harm, str]]:
        """Returns the harms of a command; asks the brick if they depend on what it has."""
        harms = harms_of(message, self._allowed, transfers)
        if not harms or harms_of(message, self._allowed, transfers, ASSUMED):
            return harms
        return {} if self._is_plan else (yield from self._ask(message, transfers))

    def _ask(self, message: Message, transfers: Mapping[int, str]) -> Generator[bytes, bytes | None, dict[Harm, str]]:
        """Asks the brick what a command depends on. Returns its harms."""
        question = question_about(message)
        frame = None if question is None else question.build()
        if question is None or frame is None:
            return harms_of(message, self._allowed, transfers)
        reply = yield frame
        return harms_of(message, self._allowed, transfers, question.read(reply))

    def _end(self, handle: int) -> Generator[bytes, bytes | None, None]:
        is_list = is_listing(self.transfers[handle])
        for _ in range(_MOST_PIECES if is_list else 1):
            command = continue_list_files(handle) if is_list else close_filehandle(handle)
            reply = yield command.build()
            self.transfers.learn(command, None if reply is None else parse(reply, strict=False))
            if handle not in self.transfers:
                return
        del self.transfers[handle]


def _entry(message: Message) -> SystemDeclaration | None:
    return SYSTEM_BY_NUMBER.get(message.number) if isinstance(message, SystemCommand) else None


def _closed_listing(message: Message, transfers: Mapping[int, str]) -> int | None:
    """Returns the handle of a listing that a command closes. The firmware would close another descriptor instead."""
    entry = _entry(message)
    if entry is None or entry.transfer != "close" or not isinstance(message, SystemCommand) or not message.wants_reply:
        return None
    handle = message.fields.get("handle")
    return handle if isinstance(handle, int) and is_listing(transfers.get(handle, "")) else None


def _closed(message: Message, handle: int) -> bytes:
    """Returns the reply to a command that has closed a handle."""
    assert isinstance(message, SystemCommand)
    body = bytes((message.number, SystemStatus.SUCCESS, handle))
    return build_frame(MessageType.SYSTEM_REPLY, message.counter, body)


def _lowered(message: Message) -> Message:
    """Returns a command that asks for no more than fits a reply: longer ones come in parts that look like frames."""
    entry = _entry(message)
    if entry is None or not isinstance(message, SystemCommand) or "max_bytes" not in message.fields:
        return message
    room = MAX_FRAME - HEADER_SIZE - 2 - sum(_SIZES.get(each.kind, 0) for each in entry.reply)
    asked = message.fields["max_bytes"]
    if not isinstance(asked, int) or asked <= room:
        return message
    fields = {**message.fields, "max_bytes": room}
    return system_command(message.number, counter=message.counter, reply=message.wants_reply, **fields)
