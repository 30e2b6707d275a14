"""A pseudo-terminal in place of the serial port of a Bluetooth connection, for programs that open one.

The port is reached by a symbolic link, whose name the user chooses. While no program has it open no client is
connected; a program that opens it later starts anew.
"""

from __future__ import annotations

import asyncio
import os
import select
from pathlib import Path

from ev3proto.brick.limits import MOST_UNREAD
from ev3proto.brick.servers.host import Connection, Host, ServerError

_PERIOD = 0.05
"""Seconds between two checks whether the port is open."""

_CHUNK = 1 << 14


class SerialPort:
    """The pseudo-terminal, and the link to it."""

    def __init__(self, host: Host, path: Path) -> None:
        """Makes both; the path of the link must not exist yet. Raises ServerError."""
        try:
            import pty  # Windows has neither
            import tty
        except ImportError:
            raise ServerError("this system has no pseudo-terminals, so --serial does not work here") from None
        self._make_raw = tty.setraw
        self.path = path
        self._host = host
        self._loop = asyncio.get_running_loop()
        self._connection: Connection | None = None
        self._timer: asyncio.TimerHandle | None = None
        self._outgoing = bytearray()
        self._master, slave = pty.openpty()
        try:
            tty.setraw(slave)
            self._target = os.ttyname(slave)
            os.set_blocking(self._master, False)
            path.symlink_to(self._target)
        except FileExistsError:
            os.close(self._master)
            raise ServerError(f"{path}: already exists; give another name, or delete it first") from None
        except OSError as error:
            os.close(self._master)
            raise ServerError(f"{path}: cannot be created: {error.strerror or error}") from None
        finally:
            os.close(slave)
        self._wait()

    def close(self) -> None:
        """Ends the connection and removes the link, unless it was replaced by something else."""
        if self._timer is not None:
            self._timer.cancel()
        self._hang_up()
        os.close(self._master)
        try:
            if str(self.path.readlink()) == self._target:
                self.path.unlink()
        except OSError:
            pass  # it was removed or replaced by something else

    # Opening and closing

    def _wait(self) -> None:
        """Checks regularly whether a program has opened the port."""
        self._timer = None
        poll = select.poll()
        poll.register(self._master, select.POLLIN)
        if any(event & select.POLLHUP for _, event in poll.poll(0)):
            self._timer = self._loop.call_later(_PERIOD, self._wait)
            return
        self._connection = self._host.open(self, str(self.path), "bluetooth")
        self._loop.add_reader(self._master, self._read)

    def _hang_up(self) -> None:
        self._loop.remove_reader(self._master)
        self._loop.remove_writer(self._master)
        self._outgoing.clear()
        connection, self._connection = self._connection, None
        if connection is not None:
            connection.close()

    # Bytes

    def _read(self) -> None:
        try:
            data = os.read(self._master, _CHUNK)
        except BlockingIOError:
            return
        except OSError:
            data = b""
        if data and self._connection is not None:
            self._connection.feed(data)
        elif not data:
            # The last program that had it open has closed it. Its settings must not apply to the next one.
            self._hang_up()
            self._make_raw(self._master)
            self._timer = self._loop.call_later(_PERIOD, self._wait)

    def _write(self) -> None:
        try:
            del self._outgoing[: os.write(self._master, self._outgoing)]
        except BlockingIOError:
            pass
        except OSError:
            self._outgoing.clear()
        if self._outgoing:
            self._loop.add_writer(self._master, self._write)
        else:
            self._loop.remove_writer(self._master)
        if self._connection is not None:
            self._connection.throttle(len(self._outgoing) > MOST_UNREAD)

    def send(self, data: bytes) -> None:
        """Sends bytes to the program that has the port open; unread ones wait."""
        if self._connection is not None:
            is_first = not self._outgoing
            self._outgoing += data
            if is_first:
                self._write()

    def pause(self) -> None:
        """Stops reading for now."""
        self._loop.remove_reader(self._master)

    def resume(self) -> None:
        """Resumes reading."""
        if self._connection is not None:
            self._loop.add_reader(self._master, self._read)

    def drop(self) -> None:
        """Ends the connection at once."""
        self._hang_up()
