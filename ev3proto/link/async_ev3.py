"""`AsyncEV3`: `EV3` for programs with asyncio, on the same sessions and carriers.

Carriers block while they send, so a separate thread sends, in the order of the calls. Replies arrive in the thread
that reads and are passed to the event loop: a program can await any number of them without a thread for each.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from ev3proto.link import file_moves, questions
from ev3proto.link.channel import Ticket
from ev3proto.link.commands import Prepared, Result, SyncMode, counter_bytes, counter_of
from ev3proto.link.errors import LinkError
from ev3proto.link.ev3 import ENDING, EV3, Command, longest, prepared, read_source
from ev3proto.link.file_moves import Progress, Task, nothing_moved
from ev3proto.link.printing import RECEIVED, SENT
from ev3proto.link.questions import Battery, Memory, Network, Question, Sensors, System
from ev3proto.link.transfers import OpenTransfers, next_of
from ev3proto.link.verbs import Verbs
from ev3proto.messages import Message
from ev3proto.ops import com_set, info
from ev3proto.schema.frame import parse
from ev3proto.semantics.transfers import File, Listing
from ev3proto.whole_files import write_whole

T = TypeVar("T")


class AsyncEV3(Verbs[Coroutine[Any, Any, bytes], Coroutine[Any, Any, Any]]):
    """A connection to a brick, for one event loop.

    `async with AsyncEV3(protocol=...) as my_ev3` connects and closes. It has the methods and properties of `EV3`, to be
    awaited where they ask the brick (`await my_ev3.battery`). Those of the brick are set by methods: `set_name`,
    `set_volume`, `set_sleep`.
    """

    def __init__(self, **arguments: Any) -> None:
        """Selects a brick; `connect` or `async with` connects to it.

        Args:
            arguments: Those of `EV3`.
        """
        self._arguments = arguments
        self._ev3: EV3 | None = None
        self._sender = ThreadPoolExecutor(1, thread_name_prefix="sends to a brick")
        self._moving = asyncio.Lock()

    async def connect(self) -> AsyncEV3:
        """Connects to the brick. Raises what `EV3` raises."""
        if self._ev3 is None:
            self._ev3 = await self._in_thread(lambda: EV3(**self._arguments))
        return self

    async def close(self) -> None:
        """Ends the connection. A second call does nothing."""
        if self._ev3 is not None:
            await self._in_thread(self._ev3.close)
        self._sender.shutdown(wait=False)

    async def __aenter__(self) -> AsyncEV3:
        return await self.connect()

    async def __aexit__(self, *_: object) -> None:
        await self.close()

    @property
    def connected(self) -> EV3:
        """The connection itself.

        Raises:
            RuntimeError: It is not connected yet.
        """
        if self._ev3 is None:
            raise RuntimeError("there is no connection yet: `await connect()`, or `async with AsyncEV3(...)`")
        return self._ev3

    @property
    def is_open(self) -> bool:
        """Whether the connection is open, as far as is known."""
        return self._ev3 is not None and self._ev3.is_open

    @property
    def target(self) -> str:
        """The brick as on the command line, such as `usb`."""
        return self.connected.target

    @property
    def protocol(self) -> str:
        """How the brick is reached: the value of BLUETOOTH, USB or WIFI."""
        return self.connected.protocol

    @property
    def host(self) -> str | None:
        """The given address, serial number or port, or None."""
        return self.connected.host

    @property
    def sync_mode(self) -> str:
        """STD, ASYNC or SYNC; it can be set."""
        return self.connected.sync_mode

    @sync_mode.setter
    def sync_mode(self, value: str) -> None:
        self.connected.sync_mode = value

    @property
    def verbosity(self) -> int:
        """What is printed: 0 nothing, 1 each frame, 2 also its contents; it can be set."""
        return self.connected.verbosity

    @verbosity.setter
    def verbosity(self, value: int) -> None:
        self.connected.verbosity = value

    def _settings(self, sync_mode: str | None) -> tuple[SyncMode, str]:
        return self.connected._settings(sync_mode)

    async def _fetch(self, msg_cnt: bytes | int, verbosity: int | None, timeout: float | None) -> Result:
        ticket = self.connected.channel.ticket(counter_of(msg_cnt))
        return ticket.result(await self._reply(ticket, verbosity, self.connected._patience(timeout), keep=True))

    async def _send(self, prepare: Callable[[], Prepared], verbosity: int | None, timeout: float | None) -> Result:
        prepared, patience = prepare(), self.connected._patience(timeout)
        ticket = await self._sent(prepared, verbosity)
        if prepared.waits:
            return ticket.result(await self._reply(ticket, verbosity, patience, keep=False))
        return counter_bytes(ticket.request.frame)

    async def _sent(self, prepared: Prepared, verbosity: int | None) -> Ticket:
        ev3 = self.connected
        printer = ev3.printer(SENT, verbosity)
        sending = asyncio.get_running_loop().run_in_executor(self._sender, lambda: ev3.channel.send(prepared, printer))
        try:
            return await asyncio.shield(sending)
        except asyncio.CancelledError:
            sending.add_done_callback(lambda sent: _abandon(ev3, sent))
            raise

    async def _reply(self, ticket: Ticket, verbosity: int | None, patience: float | None, *, keep: bool) -> bytes:
        ev3 = self.connected
        # Shielded: a caller that stops waiting must not cancel the future, which the reading thread fills in.
        waiting = asyncio.wrap_future(ticket.reply)
        waiting.add_done_callback(_looked_at)
        try:
            frame = await asyncio.wait_for(asyncio.shield(waiting), patience)
        except TimeoutError:
            raise ev3.channel.give_up(ticket, patience or 0.0, keep=keep) from None
        except asyncio.CancelledError:
            ev3.channel.give_up(ticket, 0.0, keep=keep)
            raise
        ev3.channel.fetched(ticket)
        printer = ev3.printer(RECEIVED, verbosity, ticket.request.frame)
        if printer is not None:
            printer(frame)
        return frame

    async def _in_thread(self, call: Callable[[], T]) -> T:
        return await asyncio.get_running_loop().run_in_executor(self._sender, call)

    def take_messages(self) -> list[Message]:
        """Returns new mailbox messages of the brick; see `EV3.take_messages`."""
        return self.connected.take_messages()

    # Information and settings of the brick

    @property
    def name(self) -> Coroutine[Any, Any, str]:
        """The brick's name."""
        return self._ask(questions.NAME)

    async def set_name(self, name: str) -> None:
        """Changes the brick's name."""
        await self.send_direct_cmd(com_set.set_brickname(name), sync_mode=SyncMode.SYNC)

    @property
    def volume(self) -> Coroutine[Any, Any, int]:
        """The volume of sounds in percent."""
        return self._ask(questions.VOLUME)

    async def set_volume(self, percent: int) -> None:
        """Changes the volume of sounds."""
        await self.send_direct_cmd(info.set_volume(percent), sync_mode=SyncMode.SYNC)

    @property
    def sleep(self) -> Coroutine[Any, Any, int]:
        """Minutes without use after which the brick powers off, 0 for never."""
        return self._ask(questions.SLEEP)

    async def set_sleep(self, minutes: int) -> None:
        """Changes the minutes without use after which the brick powers off, 0 for never."""
        await self.send_direct_cmd(info.set_minutes(minutes), sync_mode=SyncMode.SYNC)

    @property
    def battery(self) -> Coroutine[Any, Any, Battery]:
        """Voltage in V, current in A, charge in percent."""
        return self._ask(questions.BATTERY)

    @property
    def sensors(self) -> Coroutine[Any, Any, Sensors]:
        """The types of the devices at all ports, None for an empty port."""
        return self._ask(questions.SENSORS)

    @property
    def system(self) -> Coroutine[Any, Any, System]:
        """The versions of operating system, firmware and hardware."""
        return self._ask(questions.SYSTEM)

    @property
    def memory(self) -> Coroutine[Any, Any, Memory]:
        """The memory for users' files in KiB: total and free."""
        return self._ask(questions.MEMORY)

    @property
    def network(self) -> Coroutine[Any, Any, Network]:
        """The WiFi network of the brick, and its addresses there."""
        return self._ask(questions.NETWORK)

    async def _ask(self, question: Question[T]) -> T:
        values = await self.send_direct_cmd(question.operations, sync_mode=SyncMode.SYNC)
        return question.read(values)

    # Files

    async def download(self, source: bytes | str | Path, path: str, progress: Progress = nothing_moved) -> File:
        """Writes a file to the brick; see `EV3.download`."""
        data = source if isinstance(source, bytes) else await asyncio.to_thread(read_source, source)
        return await self._run(file_moves.download(data, path, progress))

    async def upload(
        self, path: str, destination: str | Path | None = None, progress: Progress = nothing_moved
    ) -> bytes:
        """Reads a file from the brick; see `EV3.upload`."""
        data = await self._run(file_moves.upload(path, progress))
        if destination is not None:
            await asyncio.to_thread(write_whole, Path(destination), data, is_private=True)
        return data

    async def list_dir(self, path: str) -> Listing:
        """Lists a folder of the brick; see `EV3.list_dir`."""
        return await self._run(file_moves.list_dir(path))

    async def delete(self, path: str) -> None:
        """Deletes a file or an empty folder of the brick. Raises SystemCommandError."""
        await self._run(file_moves.delete(path))

    async def mkdir(self, path: str) -> None:
        """Creates a folder on the brick. Raises SystemCommandError."""
        await self._run(file_moves.mkdir(path))

    async def _run(self, task: Task[T]) -> T:
        async with self._moving:
            transfers, patience = OpenTransfers(), self.connected._patience(None)
            step: Callable[[], Command] = partial(next, task)
            try:
                while True:
                    command = step()
                    try:
                        step = partial(task.send, await self._moved(command, transfers, patience))
                    except BaseException as error:
                        await self._end(transfers)
                        patience = ENDING
                        step = partial(task.throw, error)
            except StopIteration as end:
                result: T = end.value
                return result
            finally:
                await self._end(transfers)

    async def _moved(self, command: Command, transfers: OpenTransfers, patience: float | None) -> Message:
        moving = asyncio.ensure_future(self._exchanged(command, longest(command, patience)))
        try:
            reply = await asyncio.shield(moving)
        except asyncio.CancelledError:
            await asyncio.wait({moving}, timeout=ENDING)
            if moving.done() and moving.exception() is None:
                transfers.learn(command, moving.result())
            raise
        transfers.learn(command, reply)
        return reply

    async def _exchanged(self, command: Command, patience: float | None) -> Message:
        ticket = await self._sent(prepared(command, self._settings(None)[1]), None)
        return parse(await self._reply(ticket, None, patience, keep=False), strict=False)

    async def _end(self, transfers: OpenTransfers) -> None:
        ending, reply = transfers.ending(), None
        with suppress(LinkError):
            while (command := next_of(ending, reply)) is not None:
                reply = await self._moved(command, transfers, ENDING)


def _abandon(ev3: EV3, sent: asyncio.Future[Ticket]) -> None:
    """Abandons a command whose sender was cancelled before it was sent."""
    if not sent.cancelled() and sent.exception() is None:
        ev3.channel.give_up(sent.result(), 0.0)


def _looked_at(reply: asyncio.Future[bytes]) -> None:
    """Retrieves the exception of an abandoned reply, so that asyncio does not warn."""
    if not reply.cancelled():
        reply.exception()
