"""A virtual brick on loopback, in a thread of the tests, and a plain client for it."""

from __future__ import annotations

import asyncio
import contextlib
import socket
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from random import SystemRandom
from typing import NamedTuple

from ev3proto.brick.servers.server import Options, Running, running
from ev3proto.tables.discovery import BEACON_PORT
from ev3proto.text.assembly import assemble

UNLOCK = b"GET /target?sn=0016530f0c1e VMTP1.0\r\nProtocol: EV3\r\n\r\n"
ACCEPT = b"Accept:EV340\r\n\r\n"


MOST_WAITING = 60
"""Seconds for which another process of the tests may keep the beacon's port."""


class Served(NamedTuple):
    """A brick that is switched on, with its surroundings and its messages."""

    now: Running
    said: list[str]

    @property
    def port(self) -> int:
        return self.now.port


@contextmanager
def served(root: Path, options: Options | None = None) -> Iterator[Served]:
    """Switches a brick on while the context lasts, by default without a beacon and on any free port."""
    options = options or Options(port=0, beacon=False)
    said: list[str] = []
    found: list[Running | BaseException] = []
    there = threading.Event()
    loop = asyncio.new_event_loop()
    over = asyncio.Event()

    async def serve() -> None:
        try:
            async with running(options, root, said.append) as now:
                found.append(now)
                there.set()
                await over.wait()
        except BaseException as error:
            found.append(error)
            there.set()

    thread = threading.Thread(target=lambda: loop.run_until_complete(serve()), daemon=True)
    thread.start()
    try:
        assert there.wait(30)
        first = found[0]
        if isinstance(first, BaseException):
            raise first
        yield Served(first, said)
    finally:
        loop.call_soon_threadsafe(over.set)
        thread.join(30)
        assert not thread.is_alive()
        loop.close()
    for late in found[1:]:
        if isinstance(late, BaseException):
            raise late


def until(is_so: Callable[[], bool]) -> None:
    """Waits until a condition is true, for at most half a minute."""
    end = time.monotonic() + 30
    while not is_so():
        assert time.monotonic() < end
        time.sleep(0.01)


class Client:
    """A connection to a brick over TCP, unlocked by default."""

    def __init__(self, port: int, *, unlocks: bool = True, timeout: float = 30.0) -> None:
        self.socket = socket.create_connection(("127.0.0.1", port), timeout)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        if unlocks:
            self.send(UNLOCK)
            assert self.read(len(ACCEPT)) == ACCEPT

    def __enter__(self) -> Client:
        return self

    def __exit__(self, *_: object) -> None:
        self.socket.close()

    def send(self, data: bytes) -> None:
        self.socket.sendall(data)

    def read(self, size: int) -> bytes:
        data = b""
        while len(data) < size:
            more = self.socket.recv(size - len(data))
            if not more:
                raise ConnectionError(f"the brick closed the connection after {data!r}")
            data += more
        return data

    def reply(self) -> bytes:
        head = self.read(2)
        return head + self.read(int.from_bytes(head, "little"))

    def ask(self, frame: bytes) -> bytes:
        self.send(frame)
        return self.reply()

    def is_silent(self, seconds: float = 0.2) -> bool:
        """Returns whether nothing arrives for a while."""
        self.socket.settimeout(seconds)
        try:
            return self.socket.recv(1) == b"never"
        except TimeoutError:
            return True
        finally:
            self.socket.settimeout(30)


def command(text: str, counter: int = 1) -> bytes:
    """The frame of a direct command that wants a reply, from assembly."""
    (message,) = assemble(text, reply=True, unchecked=True)
    frame = message.build()
    return frame[:2] + counter.to_bytes(2, "little") + frame[4:]


@contextmanager
def beacon_port() -> Iterator[None]:
    """Reserves the UDP port of beacons: the tests run in several processes, of several users, and the port exists once.

    It is reserved by the TCP port of the same number, which no file is needed for, and which ends with its process.
    """
    until = time.monotonic() + MOST_WAITING
    with socket.socket() as lock:
        while True:
            try:
                lock.bind(("127.0.0.1", BEACON_PORT))
                break
            except OSError:
                assert time.monotonic() < until, "another test run keeps the beacon's port"
                time.sleep(0.02)
        yield


def free_port(lowest: int = 6000, highest: int = 9999) -> int:
    """Returns a free TCP port of four digits: some clients accept only those from a beacon.

    It is random, so that simultaneous tests do not choose the same one.
    """
    for port in SystemRandom().sample(range(lowest, highest), 100):
        with contextlib.suppress(OSError), socket.socket() as probe:
            probe.bind(("127.0.0.1", port))
            return port
    raise OSError("no port is free")


def frame(counter: int, kind: int, body: bytes) -> bytes:
    """A frame by hand."""
    rest = counter.to_bytes(2, "little") + bytes((kind,)) + body
    return len(rest).to_bytes(2, "little") + rest


def system(number: int, body: bytes) -> bytes:
    """A system command that wants a reply, by hand."""
    return frame(9, 0x01, bytes((number,)) + body)


def upload(client: Client, path: bytes, data: bytes, size: int = 1017) -> int:
    """Sends a file to the brick in pieces of a size; returns the last status."""
    reply = client.ask(system(0x92, len(data).to_bytes(4, "little") + path + b"\0"))
    status, handle = reply[6], reply[7]
    for at in range(0, len(data), size):
        if status not in (0,):
            break
        status = client.ask(system(0x93, bytes((handle,)) + data[at : at + size]))[6]
    return status


def download(client: Client, path: bytes, size: int = 1000) -> bytes:
    """Fetches a file from the brick in pieces of a size."""
    reply = client.ask(system(0x94, size.to_bytes(2, "little") + path + b"\0"))
    handle, data = reply[11], reply[12:]
    while reply[6] == 0:
        reply = client.ask(system(0x95, bytes((handle,)) + size.to_bytes(2, "little")))
        data += reply[8:]
    assert reply[6] == 8
    return data
