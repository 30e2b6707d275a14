"""A server on loopback that answers a client as a test says, also as a brick never would."""

from __future__ import annotations

import socket
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from support.server import ACCEPT, UNLOCK

Answer = Callable[[bytes, Callable[[bytes], None]], object]
"""Receives a frame and a function that sends bytes; raising an exception ends the connection."""


class HangUp(Exception):  # noqa: N818 - no error: the test wants it
    """Raised by an answer to close the connection."""


def reply(frame: bytes, memory: bytes = b"", type: int = 2) -> bytes:
    """Returns the reply to a frame, as specified."""
    return (3 + len(memory)).to_bytes(2, "little") + frame[2:4] + bytes((type,)) + memory


@contextmanager
def stub_brick(answer: Answer, accept: bytes = ACCEPT) -> Iterator[int]:
    """Serves one client after the other. Yields its port."""
    with socket.create_server(("127.0.0.1", 0)) as listening:
        thread = threading.Thread(target=_serve, args=(listening, answer, accept), daemon=True)
        thread.start()
        yield listening.getsockname()[1]
        listening.shutdown(socket.SHUT_RDWR)
        thread.join(5)


def _serve(listening: socket.socket, answer: Answer, accept: bytes) -> None:
    while True:
        try:
            client, _ = listening.accept()
        except OSError:
            return
        with client:
            text = client.recv(100)
            assert text.startswith(UNLOCK[:15])
            client.sendall(accept)
            try:
                for frame in _frames(client):
                    answer(frame, client.sendall)
            except (HangUp, OSError):
                continue


def _frames(client: socket.socket) -> Iterator[bytes]:
    data = b""
    while True:
        while len(data) >= 2 and len(data) >= 2 + int.from_bytes(data[:2], "little"):
            size = 2 + int.from_bytes(data[:2], "little")
            yield data[:size]
            data = data[size:]
        more = client.recv(4096)
        if not more:
            return
        data += more
