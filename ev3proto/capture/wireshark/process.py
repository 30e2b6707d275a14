"""tshark run by pyshark: its output as rows of fields, and what became of it."""

from __future__ import annotations

import asyncio
import contextlib
import json
import sys
import warnings
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from ev3proto.capture.wireshark.program import EngineError, Program
from ev3proto.capture.wireshark.row import FIELDS, Row

try:
    import pyshark
    from packaging.version import Version
    from pyshark.capture.capture import Capture
    from pyshark.tshark.output_parser.base_parser import BaseTsharkOutputParser
except ImportError as error:
    raise EngineError(
        f"the engine wireshark runs tshark through pyshark, which is not there ({error}): pip install"
        " 'ev3proto[wireshark]'"
    ) from error

PATIENCE = 10
"""Seconds that tshark gets to end by itself, once it was asked to or its output has ended."""

_MOST_SAID = 1 << 16
_INDEX = b'{"index"'
_STARTED = b"Capture started"


class _Rows(BaseTsharkOutputParser):  # type: ignore[misc]
    """Reads one line of JSON a packet. What pyshark calls a packet is all of them that have come: that is faster."""

    def _extract_packet_from_data(self, data: bytes, **_: object) -> tuple[bytes | None, bytes]:
        end = data.rfind(b"\n") + 1
        return (data[:end], data[end:]) if end else (None, data)

    def _parse_single_packet(self, packet: bytes) -> list[Row]:
        lines = (line for line in packet.splitlines() if line and not line.startswith(_INDEX))
        return [Row(json.loads(line.decode("utf-8", "replace"))["layers"]) for line in lines]


class _Told(Capture):  # type: ignore[misc]
    """What is other than pyshark has it: just that tshark runs, it ends by itself, and all that it says is kept.

    said     the end of what it said on standard error
    status   its exit status, None while it runs or where it was ended
    on_said  is called when it has said more
    """

    program: Program
    said = b""
    status: int | None = None
    on_said: Callable[[bytes], None] | None = None

    def _get_tshark_path(self) -> str:
        return self.program.path

    def _get_tshark_version(self) -> Version:
        return Version(".".join(map(str, self.program.version)))

    def _setup_tshark_output_parser(self) -> _Rows:
        return _Rows()

    def _created_new_process(self, _: object, process: asyncio.subprocess.Process, **__: object) -> None:
        # One that has ended already has said why.
        self._running_processes.add(process)

    async def _handle_process_stderr_forever(self, stderr: asyncio.StreamReader) -> None:
        while chunk := await stderr.read(4096):
            self.said = (self.said + chunk)[-_MOST_SAID:]
            if self.on_said is not None:
                self.on_said(self.said)

    async def _cleanup_subprocess(self, process: asyncio.subprocess.Process) -> None:
        self._running_processes.discard(process)
        if not self._eof_reached:
            # tshark asks the program that captures for it to end, too; whoever is killed does not.
            with contextlib.suppress(ProcessLookupError):
                process.terminate()
        try:
            status = await asyncio.wait_for(process.wait(), PATIENCE)
        except TimeoutError:
            with contextlib.suppress(ProcessLookupError):
                process.kill()
            status = await process.wait()
        if self._eof_reached:
            self.status = status


class _FileReader(_Told, pyshark.FileCapture):  # type: ignore[misc]
    """Reads a file."""


class _LiveReader(_Told):
    """Captures. `interfaces` has the filter of each, None for all packets."""

    interfaces: Mapping[str, str | None]

    def get_parameters(self, packet_count: int | None = None) -> list[str]:
        """The arguments. pyshark's own way has two programs that capture, one reading what the other writes."""
        words: list[str] = super().get_parameters(packet_count)
        for interface, chosen in self.interfaces.items():
            words += ["-i", interface, *(() if chosen is None else ("-f", chosen))]
        return words


class Run(ABC):
    """One run of tshark."""

    def __init__(self, program: Program, words: list[str]) -> None:
        self._program = program
        self._words = ["-n", *words]
        for field in FIELDS:
            self._words += ["-e", field]
        self._reader: Any = None

    @abstractmethod
    def _open(self, loop: asyncio.AbstractEventLoop) -> Any:
        """The reader of pyshark, in that loop."""

    def batches(self) -> Iterator[list[Row]]:
        """The rows as they come, several at a time. tshark is gone when this ends, or is closed."""
        return _stepped(self._batches)

    def _batches(self) -> Iterator[list[Row]]:
        _forget_watchers()
        with contextlib.ExitStack() as stack:
            loop = asyncio.new_event_loop()
            stack.callback(loop.close)
            self._reader = self._open(loop)
            self._reader.program = self._program
            stack.callback(self._reader.close)
            rows = iter(self._reader)
            stack.callback(rows.close)
            yield from rows

    def trouble(self) -> str | None:
        """Why tshark ended before all was read, in a sentence; None where all was read."""
        if self._reader is None or not self._reader.status:
            return None
        return self._program.complaint(self._reader.said.decode("utf-8", "replace"), self._reader.status)


class FileRun(Run):
    """tshark reading a file."""

    def __init__(self, program: Program, words: list[str], path: Path) -> None:
        super().__init__(program, words)
        self._path = path

    def _open(self, loop: asyncio.AbstractEventLoop) -> Any:
        return _FileReader(
            str(self._path), use_ek=True, keep_packets=False, custom_parameters=self._words, eventloop=loop
        )


class LiveRun(Run):
    """tshark capturing.

    interfaces  names, each with the filter by which packets are captured there, None for all
    chosen      the display filter for what is given of them
    on_start    is called once packets are captured
    """

    def __init__(
        self,
        program: Program,
        words: list[str],
        interfaces: Mapping[str, str | None],
        chosen: str,
        on_start: Callable[[], None],
    ) -> None:
        super().__init__(program, words)
        self._interfaces = interfaces
        self._chosen = chosen
        self._on_start = on_start
        self._is_started = False
        self._is_stopped = False

    def _open(self, loop: asyncio.AbstractEventLoop) -> Any:
        reader = _LiveReader(use_ek=True, display_filter=self._chosen, custom_parameters=self._words, eventloop=loop)
        reader.interfaces = self._interfaces
        reader.on_said = self._heard
        return reader

    def _heard(self, said: bytes) -> None:
        if self._is_stopped:
            self.stop()
        elif not self._is_started and _STARTED in said:
            self._is_started = True
            self._on_start()

    def stop(self) -> None:
        """Asks tshark to stop: the rows end when those are given that were captured before. Signal handlers may."""
        self._is_stopped = True
        for process in tuple(self._reader._running_processes) if self._reader is not None else ():
            with contextlib.suppress(ProcessLookupError):
                process.terminate()


def _stepped(make: Callable[[], Iterator[list[Row]]]) -> Iterator[list[Row]]:
    """The iterator itself; where an event loop runs, as in notebooks, its steps are taken in another thread.

    pyshark has its own loop, and a thread can only run one.
    """
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return make()
    return _in_thread(make)


def _in_thread(make: Callable[[], Iterator[list[Row]]]) -> Iterator[list[Row]]:
    with ThreadPoolExecutor(1, "tshark") as thread:
        rows = thread.submit(make).result()
        try:
            while (batch := thread.submit(next, rows, None).result()) is not None:
                yield batch
        finally:
            thread.submit(rows.close).result()  # type: ignore[attr-defined]


def _forget_watchers() -> None:
    """Makes asyncio able to run programs in a loop of ours.

    A reader of pyshark that somebody made without a loop has left behind what waits for programs of that loop only.
    """
    if sys.version_info < (3, 14):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DeprecationWarning)
            asyncio.set_child_watcher(None)  # type: ignore[arg-type]
