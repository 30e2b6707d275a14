"""Proxies in threads, for tests of what passes through them."""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Iterator
from typing import Any

from ev3proto.capture.dialogues import RequestReply
from ev3proto.generate.captures.recording import Recording
from ev3proto.link.carriers import open_wire
from ev3proto.link.proxy import Proxy, ProxyOptions
from ev3proto.link.targets import Target
from ev3proto.text.phrases import dialogue_line
from ev3proto.text.spans import plain_text


def line_of(pair: RequestReply) -> str:
    command = None if pair.command is None else pair.command.message
    reply = None if pair.reply is None else pair.reply.exchange
    return plain_text(dialogue_line(command, reply, None))


class Relay:
    """A proxy in a thread, its output and its messages."""

    def __init__(self, target: str, recording: Recording | None = None, **options: Any) -> None:
        self.shown: list[str] = []
        self.numbers: list[int] = []
        self.said: list[str] = []
        self.wire = open_wire(Target.parse(target))
        self.proxy = Proxy(
            self.wire,
            target,
            ProxyOptions(**options),
            show=self._show,
            say=self.said.append,
            recording=recording,
            reopen=lambda: open_wire(Target.parse(target)),
        )
        self.thread = threading.Thread(target=self.proxy.serve)
        self.thread.start()

    def _show(self, pair: RequestReply) -> None:
        self.shown.append(line_of(pair))
        self.numbers += [record.number for record in pair if record is not None]


@contextlib.contextmanager
def relay(target: str, recording: Recording | None = None, **options: Any) -> Iterator[Relay]:
    found = Relay(target, recording, **options)
    try:
        yield found
    finally:
        found.proxy.stop()
        found.thread.join(30)
        assert not found.thread.is_alive()
        found.wire.close()
        assert not [each.name for each in threading.enumerate() if each.name == "reads from the brick"]
