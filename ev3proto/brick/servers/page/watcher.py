"""The live dialogue for pages: each command with its reply, decoded only while a page is open."""

from __future__ import annotations

from collections import OrderedDict, deque
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

from ev3proto.brick.servers import Observer
from ev3proto.dialogue import Dialogue
from ev3proto.schema.frame import parse
from ev3proto.schema.header import HEADER_SIZE, Header
from ev3proto.semantics.pairing import Pairing, pairing_key
from ev3proto.tables.frame import ASKING_TYPES, MESSAGE_TYPES
from ev3proto.text.phrases import command_spans, dialogue_line
from ev3proto.text.spans import Role, plain_text

MOST_KEPT = 200
"""Recent dialogues that a new page shows."""

MOST_PENDING = 256
"""Commands that may wait for a reply."""

MOST_UNSHOWN = 400
"""Dialogues that wait to be sent to a page; older ones are only counted."""


class Client(Protocol):
    """A client that sends commands: a connection of the brick, or the page itself."""

    number: int
    name: str


@dataclass(eq=False)
class Talk:
    """A command and its reply."""

    number: int  # counted from 1
    client: str  # the name of the client
    begun: float  # seconds since the brick was switched on
    command: bytes | None  # the frame; None for a reply to an unknown command
    reply: bytes | None = None  # the frame; None while it has not come
    latency: float | None = None  # seconds between them

    def entry(self, dialect: str) -> dict[str, Any]:
        """Returns the dialogue for a page: command and reply, decoded, and whether something went wrong."""
        dialogue = Dialogue()
        command = None if self.command is None else parse(self.command, strict=False, dialect=dialect)
        if command is not None:
            dialogue.follow(command)
        if self.reply is not None:
            exchange = dialogue.follow(parse(self.reply, strict=False, dialect=dialect))
            line = dialogue_line(command, exchange, self.latency)
        else:
            line = [] if command is None else command_spans(command)
        is_wrong = any(role is Role.FAULT for _, role in line)
        time = round(self.begun, 3)
        return {"number": self.number, "client": self.client, "time": time, "text": plain_text(line), "wrong": is_wrong}


class Unshown:
    """The dialogues that one page has not been sent yet."""

    def __init__(self, kept: deque[Talk]) -> None:
        self.left_out = 0
        self._talks: OrderedDict[int, Talk] = OrderedDict((talk.number, talk) for talk in kept)

    def add(self, talk: Talk) -> None:
        """Adds a dialogue that has changed."""
        self._talks[talk.number] = talk
        if len(self._talks) > MOST_UNSHOWN:
            self._talks.popitem(last=False)
            self.left_out += 1

    def take(self, most: int) -> list[Talk]:
        """Removes and returns the next dialogues to send."""
        return [self._talks.popitem(last=False)[1] for _ in range(min(most, len(self._talks)))]


class Watcher(Observer):
    """Watches the brick's connections for all pages."""

    def __init__(self, clock: Callable[[], float]) -> None:
        """Creates a watcher; `clock` returns the seconds since the brick was switched on."""
        self._clock = clock
        self._count = 0
        self._kept: deque[Talk] = deque(maxlen=MOST_KEPT)
        self._pairing: Pairing[Talk] = Pairing(MOST_PENDING)
        self._pages: set[Unshown] = set()

    def open(self) -> Unshown:
        """Opens a page."""
        unshown = Unshown(self._kept)
        self._pages.add(unshown)
        return unshown

    def close(self, unshown: Unshown) -> None:
        """Closes a page."""
        self._pages.discard(unshown)

    def frame(self, connection: Client, frame: bytes, is_from_host: bool) -> None:
        """Begins a dialogue with a command, or ends it with its reply."""
        if len(frame) < HEADER_SIZE:
            return
        number, now = Header.read(frame).type, self._clock()
        key, size = pairing_key(frame) if number in MESSAGE_TYPES else (None, None)
        answer = None if is_from_host else self._pairing.answered((connection.number, key), size)
        if answer is not None:
            talk = answer.command
            talk.reply, talk.latency = frame, now - talk.begun
        else:
            self._count += 1
            talk = Talk(self._count, connection.name, now, frame if is_from_host else None)
            if not is_from_host:
                talk.reply = frame
            elif number in ASKING_TYPES:
                self._pairing.remember((connection.number, key), size, talk)
            self._kept.append(talk)
        for page in self._pages:
            page.add(talk)
