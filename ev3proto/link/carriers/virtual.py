"""A virtual brick in this process: no socket, the real clock."""

from __future__ import annotations

import threading
import time
import weakref
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path

from ev3proto.brick import Brick
from ev3proto.link.errors import ConnectionLostError, NoBrickError
from ev3proto.link.targets import Target
from ev3proto.tables.carriers import DEFAULT_CARRIER
from ev3proto.temporary import temporary_folder

_TURN = 0.01
"""Seconds between two checks of the clock."""


class VirtualWire:
    """A virtual brick; `Wire` documents its methods."""

    def __init__(self, brick: Brick, leave: Callable[[], object] = lambda: None) -> None:
        """Takes over a brick, whose clock follows the real one from now on; `leave` is called once, at the end."""
        self.carrier = DEFAULT_CARRIER
        self.label = "the virtual brick"
        self._brick = brick
        self._replies: list[bytes] = []
        self._changed = threading.Condition()
        self._now = time.monotonic()
        self._is_closed = False
        self._leave = weakref.finalize(self, leave)

    def send(self, frame: bytes) -> None:
        """Sends one whole frame. Raises ConnectionLostError."""
        with self._changed:
            if self._is_closed:
                raise ConnectionLostError("the connection to the virtual brick was closed")
            self._advance()
            self._replies += self._brick.receive(frame)
            self._changed.notify_all()

    def receive(self, timeout: float) -> bytes:
        """Waits for bytes. Raises ConnectionLostError."""
        deadline = time.monotonic() + timeout
        with self._changed:
            while not self._is_closed:
                self._advance()
                left = deadline - time.monotonic()
                if self._replies or left <= 0:
                    data = b"".join(self._replies)
                    self._replies.clear()
                    return data
                self._changed.wait(min(left, _TURN if self._brick.is_busy else left))
        raise ConnectionLostError("the connection to the virtual brick was closed")

    @property
    def waits_for(self) -> str:
        """What the brick's command waits for in vain, in words; empty if it is not known to."""
        with self._changed:
            return self._brick.waits_for

    def stop(self) -> None:
        """Unblocks a pending `receive`."""
        with self._changed:
            self._is_closed = True
            self._changed.notify_all()

    def close(self) -> None:
        """Ends the connection. A second call does nothing."""
        self.stop()
        self._leave()

    def _advance(self) -> None:
        now = time.monotonic()
        self._replies += self._brick.advance(now - self._now)
        self._now = now


def open_virtual(target: Target) -> VirtualWire:
    """Switches a virtual brick on, whose files are in a folder or deleted at the end. Raises NoBrickError."""
    stack = ExitStack()
    if target.host is not None and not Path(target.host).is_dir():
        raise NoBrickError(f"{target.host} is not a folder; the virtual brick keeps its files in one")
    brick = Brick(root=stack.enter_context(temporary_folder()) if target.host is None else target.host)
    if not target.is_bare:
        brick.plug_core_set()
    return VirtualWire(brick, stack.close)
