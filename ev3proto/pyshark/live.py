"""Packets as they are captured: the events on interfaces of this computer, until somebody stops it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator

from ev3proto.bounded import DEFAULT_MEMORY
from ev3proto.capture.byte_account import Account
from ev3proto.capture.record import Event
from ev3proto.capture.wireshark.events import Events
from ev3proto.pyshark.process import Process
from ev3proto.pyshark.program import EngineError, Program
from ev3proto.tables.discovery import BEACON_PORT

_STARTED = b"Capture started"


class Live:
    """A capture that lasts until it is stopped."""

    def __init__(
        self,
        interfaces: Collection[str],
        *,
        dialect: str,
        ports: Collection[int],
        tshark: str | None = None,
        memory: int = DEFAULT_MEMORY,
        on_start: Callable[[], None] = lambda: None,
    ) -> None:
        """Nothing is captured before the first of `events`.

        Args:
            interfaces: Names of interfaces, or their numbers as tshark counts them.
            dialect: The firmware whose instruction set to read by.
            ports: TCP ports on which bricks listen.
            tshark: Path of the tshark, where it is not on the path.
            memory: Bytes that commands without a reply may take together.
            on_start: Is called once packets are captured, from another thread.

        Raises:
            EngineError: There is no tshark, no such interface, or no right to capture there.

        """
        self._program = Program(tshark)
        self._dialect = dialect
        self._ports = ports
        self._memory = memory
        self._on_start = on_start
        self._process: Process | None = None
        self._is_started = False
        self._is_stopped = False
        listed = ", ".join(map(str, sorted(ports)))
        self._words = ["-l", "-Y", f"ev3 || tcp.len > 0 && tcp.port in {{{listed}}}"]
        # Packets of others need not even be captured, where the operating system can distinguish them.
        internet = " or ".join([*(f"tcp port {port}" for port in sorted(ports)), f"udp port {BEACON_PORT}"])
        for name in interfaces:
            self._words += ["-i", name, *(("-f", internet) if self._program.check_interface(name) else ())]

    def events(self) -> Iterator[Event]:
        """What happens, as it happens.

        Yields:
            Events, whose packets are numbered from 1. They end after `stop`.

        Raises:
            EngineError: Tshark ended by itself.

        """
        making = Events(Account(), self._dialect, self._ports, self._memory)
        with self._program.words(self._dialect, self._ports) as words:
            if self._is_stopped:
                return
            self._process = process = Process(self._program, [*words, *self._words], self._heard)
            for rows in process.batches():
                for row in rows:
                    yield from making.events(row)
            yield from making.end()
            trouble = process.trouble()
            if trouble is not None:
                raise EngineError(trouble)

    def stop(self) -> None:
        """Ends the events, after those that happened before. Signal handlers may call it."""
        self._is_stopped = True
        if self._process is not None:
            self._process.stop()

    def _heard(self, said: bytes) -> None:
        if self._is_stopped:
            # tshark may have started to listen to signals only now.
            self.stop()
        elif not self._is_started and _STARTED in said:
            self._is_started = True
            self._on_start()
