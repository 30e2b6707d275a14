"""`EV3`: the connection to a brick, with the interface of the lessons and of the package ev3_dc."""

from __future__ import annotations

import errno
import threading
import weakref
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any, TypeAlias, TypeVar

from ev3proto.link import file_moves, questions
from ev3proto.link.carriers import open_wire
from ev3proto.link.carriers.opening import CONNECT_TIMEOUT
from ev3proto.link.channel import Channel, Ticket, known_timeout
from ev3proto.link.commands import Prepared, Result, SyncMode, counter_bytes, counter_of, direct, system
from ev3proto.link.errors import LinkError
from ev3proto.link.file_moves import COPYING, MOST_FILE, Progress, Task, nothing_moved
from ev3proto.link.printing import RECEIVED, SENT, frame_printer, known_verbosity
from ev3proto.link.questions import Battery, Memory, Network, Question, Sensors, System
from ev3proto.link.targets import Target, chosen_target
from ev3proto.link.transfers import OpenTransfers, next_of
from ev3proto.link.verbs import Verbs
from ev3proto.messages import DirectCommand, Message, SystemCommand
from ev3proto.ops import com_set, info
from ev3proto.schema.frame import parse
from ev3proto.semantics.transfers import File, Listing
from ev3proto.whole_files import write_whole

T = TypeVar("T")

REPLY_TIMEOUT = 30.0
"""Default seconds to wait for a reply."""

Command: TypeAlias = SystemCommand | DirectCommand

ENDING = 2.0
"""Seconds to wait for the reply to each command that ends a transfer."""


class Shared:
    """A connection that several objects share: it ends with the last of them."""

    def __init__(self, channel: Channel) -> None:
        """Takes over a channel."""
        self.channel = channel
        self.moving = threading.Lock()  # the lock that a file transfer holds
        self._users = 0
        self._lock = threading.Lock()

    def take(self) -> None:
        """Counts one more user."""
        with self._lock:
            self._users += 1

    def release(self) -> None:
        """Counts one user fewer; the last one closes it."""
        with self._lock:
            self._users -= 1
            if self._users:
                return
        self.channel.close()


class EV3(Verbs[bytes, Any]):
    """A connection to a brick. Any number of threads may use it at once.

    It is a context manager: leaving it closes the connection.
    """

    def __init__(
        self,
        *,
        protocol: str | None = None,
        host: str | None = None,
        ev3_obj: EV3 | None = None,
        sync_mode: str | None = None,
        verbosity: int = 0,
        address: tuple[str, int] | None = None,
        target: str | Target | None = None,
        timeout: float | None = REPLY_TIMEOUT,
        dialect: str = "official",
    ) -> None:
        """Connects to a brick. The environment variable EV3PROTO_TARGET overrides the arguments that select it.

        Args:
            protocol: BLUETOOTH, USB or WIFI.
            host: Bluetooth: the MAC address, or the serial port of the connection. USB: the serial number, if several
                bricks are plugged in. WiFi: the serial number or address; by default the first brick that is heard.
            ev3_obj: Another object whose connection to share, instead of protocol and host.
            sync_mode: STD, ASYNC or SYNC; by default STD, or that of `ev3_obj`.
            verbosity: 0 prints nothing, 1 each frame, 2 also its contents.
            address: WiFi: address and TCP port; the beacon is not needed then.
            target: The brick as on the command line, such as `usb`, instead of protocol and host.
            timeout: Seconds to wait for each reply; None waits as long as the connection lasts.
            dialect: "official", "xtended" or "compat": the firmware whose instruction set to use.

        Raises:
            ValueError: The arguments do not select a brick, or one of them is invalid.
            LinkError: The brick cannot be reached; the message says what to do.
        """
        self.timeout = known_timeout(timeout)
        self.dialect = dialect
        self._verbosity = known_verbosity(verbosity)
        if ev3_obj is None:
            self._sync_mode = SyncMode.of(sync_mode or SyncMode.STD)
            self._target = chosen_target(protocol, host, address, target)
            self._shared = Shared(Channel(open_wire(self._target, CONNECT_TIMEOUT)))
        else:
            if not isinstance(ev3_obj, EV3):
                raise ValueError(f"ev3_obj must be an EV3, not {ev3_obj!r:.60}")
            self._sync_mode = SyncMode.of(sync_mode or ev3_obj.sync_mode)
            self._target = ev3_obj._target
            self._shared = ev3_obj._shared
        self._shared.take()
        self._release = weakref.finalize(self, self._shared.release)

    # The connection

    @property
    def target(self) -> str:
        """The brick as on the command line, such as `usb`."""
        return str(self._target)

    @property
    def protocol(self) -> str:
        """How the brick is reached: the value of BLUETOOTH, USB or WIFI."""
        return self.channel.carrier.facts.label

    @property
    def host(self) -> str | None:
        """The given address, serial number or port, or None."""
        return self._target.host

    @property
    def channel(self) -> Channel:
        """The channel that sends commands and pairs replies with them."""
        return self._shared.channel

    @property
    def is_open(self) -> bool:
        """Whether the connection is open, as far as is known."""
        return self._release.alive and self.channel.is_open

    def close(self) -> None:
        """Ends the connection, unless another object shares it. A second call does nothing."""
        self._release()

    def __enter__(self) -> EV3:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __str__(self) -> str:
        return f"EV3 at {self._target}"

    # Settings of commands

    @property
    def sync_mode(self) -> str:
        """STD, ASYNC or SYNC.

        STD requests a reply if there is global memory, and waits for it. ASYNC requests it, too, but the program waits
        for it with `wait_for_reply`. SYNC always requests a reply, and waits for it.
        """
        return self._sync_mode.value

    @sync_mode.setter
    def sync_mode(self, value: str) -> None:
        self._sync_mode = SyncMode.of(value)

    @property
    def verbosity(self) -> int:
        """What is printed: 0 nothing, 1 each frame, 2 also its contents."""
        return self._verbosity

    @verbosity.setter
    def verbosity(self, value: int) -> None:
        self._verbosity = known_verbosity(value)

    # Commands

    def _settings(self, sync_mode: str | None) -> tuple[SyncMode, str]:
        return self._sync_mode if sync_mode is None else SyncMode.of(sync_mode), self.dialect

    def _fetch(self, msg_cnt: bytes | int, verbosity: int | None, timeout: float | None) -> Result:
        ticket = self.channel.ticket(counter_of(msg_cnt))
        return ticket.result(self._reply(ticket, verbosity, self._patience(timeout), keep=True))

    def _send(self, prepare: Callable[[], Prepared], verbosity: int | None, timeout: float | None) -> Result:
        prepared, patience = prepare(), self._patience(timeout)
        ticket = self.channel.send(prepared, self.printer(SENT, verbosity))
        if prepared.waits:
            return ticket.result(self._reply(ticket, verbosity, patience, keep=False))
        return counter_bytes(ticket.request.frame)

    def _patience(self, timeout: float | None) -> float | None:
        """Returns the timeout of a call, or else of the object. It is checked before anything is sent."""
        return known_timeout(self.timeout if timeout is None else timeout)

    def _reply(self, ticket: Ticket, verbosity: int | None, patience: float | None, *, keep: bool) -> bytes:
        frame = self.channel.wait(ticket, patience, keep=keep)
        printer = self.printer(RECEIVED, verbosity, ticket.request.frame)
        if printer is not None:
            printer(frame)
        return frame

    def printer(
        self, direction: str, verbosity: int | None, request: bytes | None = None
    ) -> Callable[[bytes], None] | None:
        """Returns a function that logs a frame and prints it by `verbosity`; None if neither is wanted.

        Args:
            direction: SENT or RECEIVED.
            verbosity: 0, 1 or 2; None for that of this object.
            request: For a reply: the frame of its command.
        """
        level = self._verbosity if verbosity is None else known_verbosity(verbosity)
        return frame_printer(direction, level, request, self.dialect)

    def take_messages(self) -> list[Message]:
        """Returns the mailbox messages that programs on the brick have sent since the last call.

        Returns:
            The messages, oldest first; at most the newest 256.
        """
        return [parse(frame, strict=False, dialect=self.dialect) for frame in self.channel.take_unasked()]

    # Information and settings of the brick

    @property
    def name(self) -> str:
        """The brick's name; it can be set."""
        return self._ask(questions.NAME)

    @name.setter
    def name(self, value: str) -> None:
        self._tell(com_set.set_brickname(value))

    @property
    def volume(self) -> int:
        """The volume of sounds in percent; it can be set."""
        return self._ask(questions.VOLUME)

    @volume.setter
    def volume(self, value: int) -> None:
        self._tell(info.set_volume(value))

    @property
    def sleep(self) -> int:
        """Minutes without use after which the brick powers off, 0 for never; it can be set."""
        return self._ask(questions.SLEEP)

    @sleep.setter
    def sleep(self, value: int) -> None:
        self._tell(info.set_minutes(value))

    @property
    def battery(self) -> Battery:
        """Voltage in V, current in A, charge in percent."""
        return self._ask(questions.BATTERY)

    @property
    def sensors(self) -> Sensors:
        """The types of the devices at all ports, None for an empty port: `sensors.Port_1`, `sensors.Port_A`."""
        return self._ask(questions.SENSORS)

    @property
    def system(self) -> System:
        """The versions of operating system, firmware and hardware."""
        return self._ask(questions.SYSTEM)

    @property
    def memory(self) -> Memory:
        """The memory for users' files in KiB: total and free."""
        return self._ask(questions.MEMORY)

    @property
    def network(self) -> Network:
        """The WiFi network of the brick, and its addresses there."""
        return self._ask(questions.NETWORK)

    def _ask(self, question: Question[T]) -> T:
        values = self.send_direct_cmd(question.operations, sync_mode=SyncMode.SYNC)
        return question.read(values)

    def _tell(self, operations: Any) -> None:
        self.send_direct_cmd(operations, sync_mode=SyncMode.SYNC)

    # Files

    def download(self, source: bytes | str | Path, path: str, progress: Progress = nothing_moved) -> File:
        """Writes a file to the brick (the protocol's word for it), and compares its MD5 there.

        Args:
            source: A file of this computer, or the contents as bytes.
            path: The path on the brick, absolute or relative to /home/root/lms2012/sys. Missing folders are created.
            progress: Called with the bytes transferred so far and their total.

        Returns:
            The file as the brick lists it.

        Raises:
            OSError: The file cannot be read, or has more than 256 MiB.
            SystemCommandError: The brick refuses the file.
            TransferError: The file on the brick differs.
        """
        data = source if isinstance(source, bytes) else read_source(source)
        return self._run(file_moves.download(data, path, progress))

    def upload(self, path: str, destination: str | Path | None = None, progress: Progress = nothing_moved) -> bytes:
        """Reads a file from the brick (the protocol's word for it), and compares its MD5 there.

        Args:
            path: The path on the brick, absolute or relative to /home/root/lms2012/sys.
            destination: The file of this computer to write, or None. It appears only when it is complete.
            progress: Called with the bytes transferred so far and their total.

        Returns:
            The contents.

        Raises:
            OSError: The file cannot be written.
            SystemCommandError: The brick refuses to send the file.
            TransferError: The contents differ from the file on the brick.
        """
        data = self._run(file_moves.upload(path, progress))
        if destination is not None:
            write_whole(Path(destination), data, is_private=True)
        return data

    def list_dir(self, path: str) -> Listing:
        """Lists a folder of the brick: its folders and its files, each with size and MD5.

        Args:
            path: The path on the brick, absolute or relative to /home/root/lms2012/sys.

        Raises:
            SystemCommandError: The folder does not exist.
        """
        return self._run(file_moves.list_dir(path))

    def delete(self, path: str) -> None:
        """Deletes a file or an empty folder of the brick. Raises SystemCommandError."""
        self._run(file_moves.delete(path))

    def mkdir(self, path: str) -> None:
        """Creates a folder on the brick. Raises SystemCommandError."""
        self._run(file_moves.mkdir(path))

    def _run(self, task: Task[T]) -> T:
        # The firmware reads from the file that was opened last, whatever the handle: one transfer at a time.
        with self._shared.moving:
            transfers, patience = OpenTransfers(), self._patience(None)
            step: Callable[[], Command] = partial(next, task)
            try:
                while True:
                    command = step()
                    try:
                        step = partial(task.send, self._moved(command, transfers, patience))
                    except BaseException as error:
                        # What it does in its `finally` comes next, with the connection free.
                        self._end(transfers)
                        patience = ENDING
                        step = partial(task.throw, error)
            except StopIteration as end:
                result: T = end.value
                return result
            finally:
                self._end(transfers)

    def _moved(self, command: Command, transfers: OpenTransfers, patience: float | None) -> Message:
        """Sends a command of a transfer. Whatever happens while it waits, the handle in the reply becomes known."""
        ticket = self.channel.send(prepared(command, self.dialect), self.printer(SENT, None))
        try:
            frame = self._reply(ticket, None, longest(command, patience), keep=False)
        except BaseException:
            with suppress(LinkError):
                transfers.learn(command, parse(self.channel.wait(ticket, ENDING), strict=False))
            raise
        reply = parse(frame, strict=False)
        transfers.learn(command, reply)
        return reply

    def _end(self, transfers: OpenTransfers) -> None:
        """Closes what a transfer has left open on the brick, which would keep it until it is restarted."""
        ending, reply = transfers.ending(), None
        with suppress(LinkError):
            while (command := next_of(ending, reply)) is not None:
                reply = self._moved(command, transfers, ENDING)


def longest(command: Command, patience: float | None) -> float | None:
    """Returns the seconds to wait for the reply to a command of a transfer."""
    is_copying = isinstance(command, DirectCommand) and patience not in (None, ENDING)
    return max(patience or 0.0, COPYING) if is_copying else patience


def prepared(command: Command, dialect: str) -> Prepared:
    """Prepares a command of a transfer; all of them want a reply."""
    if isinstance(command, SystemCommand):
        return system(command, True)
    return direct(command, 0, 0, SyncMode.SYNC, dialect)


def read_source(path: str | Path) -> bytes:
    """Reads a file to send to a brick, even from a device, which may never end. Raises OSError."""
    with Path(path).open("rb") as stream:
        data = stream.read(MOST_FILE + 1)
    if len(data) > MOST_FILE:
        raise OSError(errno.EFBIG, f"more than {MOST_FILE >> 20} MiB, for which no brick has room", str(path))
    return data
