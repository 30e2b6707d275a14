"""Copies in both directions, and what is left of them when they are interrupted anywhere."""

from __future__ import annotations

import asyncio
import contextlib
import select
import socket
import threading
from collections.abc import Callable, Iterator
from itertools import product
from pathlib import Path
from random import Random
from typing import Any

import pytest
from support.cases import each
from support.effort import effort
from support.relays import relay
from support.server import Client, Served, download, served, system, until, upload

import ev3proto
from ev3proto import EV3, AsyncEV3
from ev3proto.brick.servers.server import Options
from ev3proto.link.channel import Channel, Ticket
from ev3proto.link.commands import Prepared
from ev3proto.link.session import Request
from ev3proto.schema.header import build_frame
from ev3proto.tables.frame import MessageType

SIZES = (0, 1, 1012, 1013, 1017, 1018, 64_000, 500_000)
"""At the limits of one piece in both directions, and large."""
SHARED = Options(port=0, beacon=False, clients=4)
PATH = "../prjs/x.rtf"


def data_of(size: int) -> bytes:
    return Random(size).randbytes(size)


@pytest.fixture(scope="module")
def brick(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Served, Path]]:
    root = tmp_path_factory.mktemp("brick")
    (root / "prjs").mkdir()
    with served(root, SHARED) as found:
        yield found, root


def left_open(brick: Served) -> int:
    return len(brick.now.brick._system._transfers)


# All sizes, all ways


def read_by_ev3(port: int, path: str) -> bytes:
    with EV3(target=f"wifi:127.0.0.1:{port}") as my_ev3:
        return my_ev3.upload(path)


def read_by_async(port: int, path: str) -> bytes:
    async def read() -> bytes:
        async with AsyncEV3(target=f"wifi:127.0.0.1:{port}") as my_ev3:
            return await my_ev3.upload(path)

    return asyncio.run(read())


def read_by_frames(size: int) -> Callable[[int, str], bytes]:
    def read(port: int, path: str) -> bytes:
        with Client(port) as client:
            return download(client, path.encode(), size)

    return read


READERS = [read_by_ev3, read_by_async, *map(read_by_frames, (65_535, 999, 7))]


def write_by_ev3(port: int, path: str, data: bytes) -> None:
    with EV3(target=f"wifi:127.0.0.1:{port}") as my_ev3:
        my_ev3.download(data, path)


def write_by_async(port: int, path: str, data: bytes) -> None:
    async def write() -> None:
        async with AsyncEV3(target=f"wifi:127.0.0.1:{port}") as my_ev3:
            await my_ev3.download(data, path)

    asyncio.run(write())


def write_by_frames(size: int) -> Callable[[int, str, bytes], None]:
    def write(port: int, path: str, data: bytes) -> None:
        with Client(port) as client:
            assert upload(client, path.encode(), data, size) == 8

    return write


WRITERS = [write_by_ev3, write_by_async, *map(write_by_frames, (65_530, 999, 7))]


def ways(all_of_them: list[Any], size: int) -> list[Any]:
    """Large files are not copied in small pieces."""
    return all_of_them[: 5 if size < 5000 else 4 if size < 100_000 else 3]


@each("is_read_only", [True, False])
def test_copies_from_the_brick(is_read_only: bool, brick: tuple[Served, Path]) -> None:
    found, root = brick
    with relay(f"wifi:127.0.0.1:{found.port}", is_read_only=is_read_only) as proxy:
        for size in SIZES:
            data = data_of(size)
            (root / f"prjs/{size}.rtf").write_bytes(data)
            for way in ways(READERS, size):
                assert way(proxy.proxy.port, f"../prjs/{size}.rtf") == data
        assert proxy.said == []
    until(lambda: left_open(found) == 0)


def test_copies_to_the_brick(brick: tuple[Served, Path]) -> None:
    found, root = brick
    with relay(f"wifi:127.0.0.1:{found.port}") as proxy:
        for size in SIZES:
            data = data_of(size)
            for way in ways(WRITERS, size):
                way(proxy.proxy.port, PATH, data)
                assert (root / "prjs/x.rtf").read_bytes() == data
        assert proxy.said == []
    until(lambda: left_open(found) == 0)


# Interrupted anywhere

OLD, NEW = b"old" * 1000, b"new" * 700


class Left:
    """What is on the brick after a copy that was interrupted."""

    def __init__(self, found: Served, root: Path) -> None:
        self._found, self.folder = found, root / "prjs/a"
        self.folder.mkdir(exist_ok=True)
        self.renew()

    def renew(self) -> None:
        for file in self.folder.iterdir():
            file.unlink()
        (self.folder / "x.rtf").write_bytes(OLD)

    def check(self, *, is_written: bool = False) -> None:
        """Fails unless nothing is left open, and the folder has one file, which is whole."""
        until(lambda: left_open(self._found) == 0)
        assert [file.name for file in self.folder.iterdir()] == ["x.rtf"]
        assert (self.folder / "x.rtf").read_bytes() in ((NEW,) if is_written else (OLD, NEW))


class Stop(BaseException):
    """Ctrl-C, in a test."""


LOST = ev3proto.NoAnswerError("lost")


def stopping(monkeypatch: pytest.MonkeyPatch, at: int, error: BaseException, *, is_before: bool) -> None:
    """Raises an error at one wait for a reply, before it comes or in its place."""
    count = 0
    wait = Channel.wait

    def stopped(channel: Channel, *arguments: Any, **named: Any) -> bytes:
        nonlocal count
        count += 1
        reply = b"" if is_before and count == at else wait(channel, *arguments, **named)
        if count == at:
            raise error
        return reply

    monkeypatch.setattr(Channel, "wait", stopped)


INTERRUPTIONS = product(range(1, 13), (Stop(), LOST, ValueError()), (True, False))


@each("at, error, is_before", INTERRUPTIONS)
def test_an_interrupted_copy_leaves_nothing(
    at: int, error: BaseException, is_before: bool, brick: tuple[Served, Path]
) -> None:
    left = Left(*brick)
    for is_download in (True, False):
        with EV3(target=f"wifi:127.0.0.1:{brick[0].port}") as my_ev3:
            left.renew()
            with pytest.MonkeyPatch.context() as patched:
                stopping(patched, at, error, is_before=is_before)
                with contextlib.suppress(Stop, ValueError, ev3proto.LinkError):
                    if is_download:
                        my_ev3.download(NEW, "../prjs/a/x.rtf")
                    else:
                        my_ev3.upload("../prjs/a/x.rtf")
            left.check()
            # The connection is as good as before.
            assert len(my_ev3.upload("../prjs/a/x.rtf")) in (len(OLD), len(NEW))


@each("at, is_before", [(at, is_before) for at in range(1, 12) for is_before in (True, False)])
def test_a_cancelled_copy_leaves_nothing(at: int, is_before: bool, brick: tuple[Served, Path]) -> None:
    left = Left(*brick)
    exchanged = AsyncEV3._exchanged
    copying: asyncio.Future[Any]
    count = 0

    async def cancelled(my_ev3: AsyncEV3, *arguments: Any) -> Any:
        nonlocal count
        count += 1
        reply = None if is_before and count == at else await exchanged(my_ev3, *arguments)
        if count == at:
            copying.cancel()
            reply = reply or await exchanged(my_ev3, *arguments)
        return reply

    async def copy(*, is_download: bool) -> None:
        nonlocal copying, count
        count = 0
        async with AsyncEV3(target=f"wifi:127.0.0.1:{brick[0].port}") as my_ev3:
            path = "../prjs/a/x.rtf"
            copying = asyncio.ensure_future(my_ev3.download(NEW, path) if is_download else my_ev3.upload(path))
            await asyncio.wait({copying})
            left.check()
            assert len(await my_ev3.upload(path)) in (len(OLD), len(NEW))

    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(AsyncEV3, "_exchanged", cancelled)
        for is_download in (True, False):
            left.renew()
            asyncio.run(copy(is_download=is_download))


def cut_after(count: int, port: int) -> socket.socket:
    """Returns a listening socket whose client is cut off after some bytes in either direction."""
    listening = socket.create_server(("127.0.0.1", 0))

    def serve() -> None:
        with listening, listening.accept()[0] as client, socket.create_connection(("127.0.0.1", port)) as brick:
            rest = count
            while rest:
                for source in select.select([client, brick], [], [])[0]:
                    data = source.recv(rest)
                    (brick if source is client else client).sendall(data)
                    rest = rest - len(data) if data else 0

    threading.Thread(target=serve, daemon=True).start()
    return listening


@each("is_through_proxy", [False, True])
def test_a_connection_that_ends_at_any_byte(is_through_proxy: bool, brick: tuple[Served, Path]) -> None:
    """The brick, or the proxy for it, closes what was open. Only the temporary file may remain, and is named."""
    said, folder = "", brick[1] / f"prjs/cut{is_through_proxy:d}"
    with contextlib.ExitStack() as stack:
        port = brick[0].port
        if is_through_proxy:
            port = stack.enter_context(relay(f"wifi:127.0.0.1:{port}")).proxy.port
        for count in range(72, 3700, effort(97, 1)):
            # The brick may be at work on it when the next one begins.
            (folder / f"{count}").mkdir(parents=True)
            (folder / f"{count}/x.rtf").write_bytes(OLD)
            with cut_after(count, port) as cut:
                try:
                    with EV3(target=f"wifi:127.0.0.1:{cut.getsockname()[1]}") as my_ev3:
                        my_ev3.download(NEW, f"../prjs/{folder.name}/{count}/x.rtf")
                except ev3proto.LinkError as error:
                    said += str(error)
        with Client(port) as client:
            client.ask(system(0x9D, b""))
        until(lambda: left_open(brick[0]) == 0)
        for file in folder.glob("*/*"):
            assert file.name in said if file.suffix == ".tmp" else file.read_bytes() in (OLD, NEW), file


def of_move(frame: bytes) -> bool:
    return frame[4] == 0 and b"../prjs/a/~" in frame


@each("is_done", [True, False])
def test_a_move_whose_reply_is_lost_is_verified_or_named(is_done: bool, brick: tuple[Served, Path]) -> None:
    left = Left(*brick)
    wait, send = Channel.wait, Channel.send

    def lost(channel: Channel, ticket: Ticket, *arguments: Any, **named: Any) -> bytes:
        if of_move(ticket.request.frame):
            raise ev3proto.NoAnswerError("lost")
        return wait(channel, ticket, *arguments, **named)

    def sent(channel: Channel, prepared: Prepared, before: Any = None) -> Ticket:
        if not is_done and b"../prjs/a/~" in prepared.body and prepared.kind is MessageType.DIRECT_COMMAND_REPLY:
            return Ticket(prepared, Request(0, build_frame(prepared.kind, 0, prepared.body), True))
        return send(channel, prepared, before)

    with pytest.MonkeyPatch.context() as patched, EV3(target=f"wifi:127.0.0.1:{brick[0].port}") as my_ev3:
        patched.setattr(Channel, "wait", lost)
        patched.setattr(Channel, "send", sent)
        if is_done:
            my_ev3.download(NEW, "../prjs/a/x.rtf")
            left.check(is_written=True)
        else:
            with pytest.raises(ev3proto.NoAnswerError) as raised:
                my_ev3.download(NEW, "../prjs/a/x.rtf")
            (file,) = left.folder.glob("*.tmp")
            assert file.read_bytes() == NEW
            assert str(raised.value) == (
                "lost; ../prjs/a/x.rtf: the brick may not have all of it; the new file is complete in"
                f" ../prjs/a/{file.name}"
            )
            file.unlink()
            assert (left.folder / "x.rtf").read_bytes() == OLD


def test_a_file_for_whose_second_copy_there_is_no_room_leaves_the_old_one(tmp_path: Path) -> None:
    """FILE.MOVE copies; the room of the old file is free by then."""
    (tmp_path / "prjs").mkdir()
    (tmp_path / "prjs/x.rtf").write_bytes(OLD)
    with served(tmp_path) as brick, EV3(target=f"wifi:127.0.0.1:{brick.port}") as my_ev3:
        storage = brick.now.brick.equipment.files
        storage.used = storage.quota - 300 * 1024 - 400_000  # a download leaves 300 KiB free
        with pytest.raises(ev3proto.TransferError) as raised:
            my_ev3.download(bytes(400_000), PATH)
        assert str(raised.value) == (
            f"{PATH}: the brick has no room for a second copy, which the firmware makes: 400000 bytes are needed, and"
            " 310200 are free; delete files there"
        )
        assert [file.name for file in (tmp_path / "prjs").iterdir() if file.is_file()] == ["x.rtf"]
        assert (tmp_path / "prjs/x.rtf").read_bytes() == OLD
        assert my_ev3.download(bytes(310_000), PATH).size == 310_000


def test_seventy_clients_that_vanish_leave_nothing_open(brick: tuple[Served, Path]) -> None:
    found, root = brick
    (root / "prjs/x.rtf").write_bytes(OLD)
    begun = [system(0x94, b"\x0a\0../prjs/x.rtf\0"), system(0x92, b"\x0a\0\0\0../prjs/y.rtf\0")]
    with relay(f"wifi:127.0.0.1:{found.port}") as proxy:
        for number in range(70):
            with Client(proxy.proxy.port) as client:
                client.send(begun[number % 2])
                if number % 3:
                    assert client.reply()[6] == 0
        with Client(proxy.proxy.port) as client:
            # The file is read again, and no other handle is open.
            assert download(client, PATH.encode()) == OLD
        until(lambda: left_open(found) == 0)
