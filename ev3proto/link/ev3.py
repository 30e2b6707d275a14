"""`EV3`: a brick as a program sees it, as the lessons and the package ev3_dc have it."""

from __future__ import annotations

import errno
import threading
import weakref
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Any, TypeVar

from ev3proto.link import file_moves, questions
from ev3proto.link.carriers import open_wire
from ev3proto.link.carriers.opening import CONNECT_TIMEOUT
from ev3proto.link.channel import Channel, Ticket, known_timeout
from ev3proto.link.commands import Prepared, Result, SyncMode, counter_bytes, counter_of, system
from ev3proto.link.file_moves import MOST_FILE, File, Listing, Progress, Task, nothing_moved
from ev3proto.link.printing import RECEIVED, SENT, frame_printer, known_verbosity
from ev3proto.link.questions import Battery, Memory, Network, Question, Sensors, System
from ev3proto.link.targets import Target, chosen_target
from ev3proto.link.verbs import Verbs
from ev3proto.messages import Message, SystemReply
from ev3proto.ops import com_set, info
from ev3proto.schema.frame import parse
from ev3proto.whole_files import write_whole

T = TypeVar("T")

REPLY_TIMEOUT = 30.0
"""Seconds to wait for a reply unless something else is asked for."""


class Shared:
    """A connection that several objects share: it ends with the last of them.

    channel  the connection
    moving   held while a file is moved
    """

    def __init__(self, channel: Channel) -> None:
        """Takes a channel over."""
        self.channel = channel
        self.moving = threading.Lock()
        self._users = 0
        self._lock = threading.Lock()

    def take(self) -> None:
        """Counts one more user."""
        with self._lock:
            self._users += 1

    def release(self) -> None:
        """Counts one user less; the last one closes it."""
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
        """Connects to a brick. The environment variable EV3PROTO_TARGET overrides what is said here about which one.

        Args:
            protocol: BLUETOOTH, USB or WIFI.
            host: Bluetooth: its MAC address, or the serial port of the connection. USB: its serial number, where
                several are plugged in. WiFi: its serial number or address; the first one that is heard when omitted.
            ev3_obj: Another object, whose connection is shared; in place of protocol and host.
            sync_mode: STD, ASYNC or SYNC; STD when omitted, or that of `ev3_obj`.
            verbosity: 0 prints nothing, 1 each frame, 2 also what it says.
            address: WiFi: address and TCP port; no beacon is waited for.
            target: The brick as the command line names it, such as `usb`; in place of protocol and host.
            timeout: Seconds to wait for each reply; None waits as long as the connection lasts.
            dialect: "official", "xtended" or "compat": the firmware whose instruction set to read by.

        Raises:
            ValueError: The arguments do not say which brick is meant, or one of them is odd.
            LinkError: It cannot be reached; the sentence says what to do.
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
        """The brick as the command line names it."""
        return str(self._target)

    @property
    def protocol(self) -> str:
        """How the brick is reached: the value of BLUETOOTH, USB or WIFI."""
        return self.channel.carrier.facts.label

    @property
    def host(self) -> str | None:
        """The address, serial number or port that was given, None where none was."""
        return self._target.host

    @property
    def channel(self) -> Channel:
        """What carries the commands, and pairs the replies with them."""
        return self._shared.channel

    @property
    def is_open(self) -> bool:
        """Whether the connection is there, as far as is known."""
        return self._release.alive and self.channel.is_open

    def close(self) -> None:
        """Ends the connection, unless another object shares it. A second call does nothing."""
        self._release()

    def __enter__(self) -> EV3:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def __str__(self) -> str:
        return f"EV3 at {self._target}"

    # How commands go

    @property
    def sync_mode(self) -> str:
        """STD, ASYNC or SYNC.

        STD asks for a reply where there is global memory, and waits for it. ASYNC asks for it, too; the program waits
        for it with `wait_for_reply`. SYNC asks for a reply always, and waits for it.
        """
        return self._sync_mode.value

    @sync_mode.setter
    def sync_mode(self, value: str) -> None:
        self._sync_mode = SyncMode.of(value)

    @property
    def verbosity(self) -> int:
        """What is printed: 0 nothing, 1 each frame, 2 also what it says."""
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
        """Returns what logs a frame, and prints it as `verbosity` asks for; None where nothing is logged or printed.

        Args:
            direction: SENT or RECEIVED.
            verbosity: 0, 1 or 2; that of this object where None.
            request: For a reply: the frame of its command.
        """
        level = self._verbosity if verbosity is None else known_verbosity(verbosity)
        return frame_printer(direction, level, request, self.dialect)

    def take_messages(self) -> list[Message]:
        """Returns what the brick has sent by itself since the last call: what its programs write to mailboxes.

        Returns:
            The messages, oldest first; the newest 256 where there are more.
        """
        return [parse(frame, strict=False, dialect=self.dialect) for frame in self.channel.take_unasked()]

    # What the brick is and has

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
        """The memory for users' files in KiB: all of it, and what is free."""
        return self._ask(questions.MEMORY)

    @property
    def network(self) -> Network:
        """The WiFi network that the brick is in, and its addresses there."""
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
            source: A file of this computer, or the contents themselves as bytes.
            path: Where it goes, absolute or relative to /home/root/lms2012/sys. Missing folders are made.
            progress: Called with the bytes moved so far and their total.

        Returns:
            The file as the brick lists it.

        Raises:
            OSError: The file cannot be read, or has more than 256 MiB.
            SystemCommandError: The brick does not take it.
            TransferError: It has not arrived as it was sent.
        """
        data = source if isinstance(source, bytes) else read_source(source)
        return self._run(file_moves.download(data, path, progress))

    def upload(self, path: str, destination: str | Path | None = None, progress: Progress = nothing_moved) -> bytes:
        """Reads a file from the brick (the protocol's word for it), and compares its MD5 there.

        Args:
            path: Where it is, absolute or relative to /home/root/lms2012/sys.
            destination: The file of this computer to write; None writes none. It appears only when it is complete.
            progress: Called with the bytes moved so far and their total.

        Returns:
            The contents.

        Raises:
            OSError: The file cannot be written.
            SystemCommandError: The brick does not give it.
            TransferError: It has not arrived as the brick has it.
        """
        data = self._run(file_moves.upload(path, progress))
        if destination is not None:
            write_whole(Path(destination), data, is_private=True)
        return data

    def list_dir(self, path: str) -> Listing:
        """Lists a folder of the brick: its folders and its files, each with size and MD5.

        Args:
            path: Where it is, absolute or relative to /home/root/lms2012/sys.

        Raises:
            SystemCommandError: The folder does not exist.
        """
        return self._run(file_moves.list_dir(path))

    def delete(self, path: str) -> None:
        """Deletes a file or an empty folder of the brick. Raises SystemCommandError."""
        self._run(file_moves.delete(path))

    def mkdir(self, path: str) -> None:
        """Makes a folder on the brick. Raises SystemCommandError."""
        self._run(file_moves.mkdir(path))

    def _run(self, task: Task[T]) -> T:
        # The firmware reads from the file that was opened last, for any handle: one at a time.
        with self._shared.moving:
            reply: SystemReply | None = None
            while True:
                try:
                    command = next(task) if reply is None else task.send(reply)
                except StopIteration as end:
                    result: T = end.value
                    return result
                patience = self._patience(None)
                ticket = self.channel.send(system(command, True), self.printer(SENT, None))
                reply = system_reply(self._reply(ticket, None, patience, keep=False))


def system_reply(frame: bytes) -> SystemReply:
    """Returns the system reply in a frame that answers a system command."""
    message = parse(frame, strict=False)
    assert isinstance(message, SystemReply)
    return message


def read_source(path: str | Path) -> bytes:
    """Returns the contents of a file that goes to a brick.

    Args:
        path: Any file of this computer, a device as well, which may never end.

    Returns:
        Its bytes, `MOST_FILE` at most.

    Raises:
        OSError: It cannot be read, or has more bytes than that.
    """
    with Path(path).open("rb") as stream:
        data = stream.read(MOST_FILE + 1)
    if len(data) > MOST_FILE:
        raise OSError(errno.EFBIG, f"more than {MOST_FILE >> 20} MiB, for which no brick has room", str(path))
    return data
