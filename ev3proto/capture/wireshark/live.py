"""Packets as they are captured: the events on interfaces of this computer, until somebody stops it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from functools import partial

from ev3proto.capture.byte_account import Account
from ev3proto.capture.record import Event
from ev3proto.capture.wireshark.events import Events
from ev3proto.capture.wireshark.program import EngineError, Program
from ev3proto.tables.discovery import BEACON_PORT


class Live:
    """A capture that goes on.

    interfaces  names of interfaces, or their numbers as tshark counts them
    dialect     the firmware whose instruction set to read by
    ports       TCP ports on which bricks listen
    tshark      path of the tshark, where it is not on the path
    on_start    is called once packets are captured

    Raises EngineError where tshark or pyshark is missing, an interface, or the right to capture there.
    """

    def __init__(
        self,
        interfaces: Collection[str],
        *,
        dialect: str,
        ports: Collection[int],
        tshark: str | None = None,
        on_start: Callable[[], None] = lambda: None,
    ) -> None:
        from ev3proto.capture.wireshark.process import LiveRun

        self._program = Program(tshark)
        # Packets of others need not even be captured, where the operating system can tell them.
        internet = " or ".join([*(f"tcp port {port}" for port in sorted(ports)), f"udp port {BEACON_PORT}"])
        filters = {name: internet if self._program.check_interface(name) else None for name in interfaces}
        chosen = f"ev3 || tcp.len > 0 && tcp.port in {{{', '.join(map(str, sorted(ports)))}}}"
        self._dialect = dialect
        self._ports = ports
        self._make: Callable[[list[str]], LiveRun] = partial(
            LiveRun, self._program, interfaces=filters, chosen=chosen, on_start=on_start
        )
        self._run: LiveRun | None = None
        self._is_stopped = False

    def events(self) -> Iterator[Event]:
        """What happens, as it happens; packets are numbered from 1. Ends after `stop`.

        Raises EngineError where tshark ends by itself.
        """
        making = Events(Account(), self._dialect, self._ports)
        with self._program.words(self._dialect, self._ports) as words:
            if self._is_stopped:
                return
            self._run = run = self._make(words)
            for rows in run.batches():
                for row in rows:
                    yield from making.events(row)
            yield from making.end()
            trouble = run.trouble()
            if trouble is not None:
                raise EngineError(trouble)

    def stop(self) -> None:
        """Ends the events, after those that happened before. Signal handlers may call it."""
        self._is_stopped = True
        if self._run is not None:
            self._run.stop()
