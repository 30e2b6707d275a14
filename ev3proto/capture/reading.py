"""Capture files opened, sniffed and read: `read` gives records, and everything else that a capture has beside them."""

from __future__ import annotations

import os
from collections.abc import Collection, Generator, Iterator
from types import TracebackType
from typing import BinaryIO, Literal, Self

from ev3proto.capture.byte_account import Account
from ev3proto.capture.formats import CaptureFile
from ev3proto.capture.record import Event, Record
from ev3proto.tables import check_dialect
from ev3proto.tables.discovery import TCP_PORT

Engine = Literal["builtin", "wireshark"]


class Capture:
    """A capture that is being read: iterate it once, for its records or with `events` for everything in it.

    It is closed when it was read to its end, when nobody holds it any more, or by `close` or a `with`.

    account  where the captured bytes went, so far
    """

    def __init__(self, events: Iterator[Event], account: Account, file: CaptureFile | None = None) -> None:
        self._events = events
        self._file = file
        self.account = account

    @property
    def progress(self) -> float | None:
        """How much of the file was read, 0 to 1; None where nobody knows its size."""
        return None if self._file is None else self._file.progress

    def __iter__(self) -> Iterator[Record]:
        for event in self.events():
            if type(event) is Record:
                yield event

    def events(self) -> Iterator[Event]:
        """Records, announcements and skipped bytes, in the order in which they became complete.

        Raises CaptureError for a damaged file after everything readable was given, OSError where it cannot be read.
        """
        try:
            yield from self._events
        finally:
            self.close()

    def close(self) -> None:
        """Closes what was opened; iterating comes to its end."""
        if isinstance(self._events, Generator):
            self._events.close()
        if self._file is not None:
            self._file.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, where: TracebackType | None
    ) -> None:
        self.close()

    def __del__(self) -> None:
        self.close()


def read(
    source: str | os.PathLike[str] | BinaryIO | CaptureFile,
    *,
    dialect: str = "official",
    ports: Collection[int] = (TCP_PORT,),
    engine: Engine = "builtin",
    tshark: str | None = None,
) -> Capture:
    """A capture file's records: pcap, pcapng or btsnoop, packed with gzip or not, told by its first bytes.

    source   a path, a binary stream at its start (which stays open), or a CaptureFile that was looked at before
    dialect  the firmware whose instruction set to read by
    ports    TCP ports on which bricks listen
    engine   "builtin", or "wireshark": tshark takes the packets apart, for every link type that Wireshark knows
    tshark   path of the tshark for that engine, where it is not on the path

    Raises OSError for a file that cannot be opened, CaptureError for one that is no capture, ValueError for an unknown
    dialect or engine; while it is read CaptureError for a damaged file, after everything readable was given.
    """
    check_dialect(dialect)
    account = Account()
    if engine == "wireshark":
        from ev3proto.capture.wireshark import wireshark_events

        return Capture(wireshark_events(source, account, dialect=dialect, ports=ports, tshark=tshark), account)
    if engine != "builtin":
        raise ValueError(f"there is no engine {engine!r}: it is builtin or wireshark")
    from ev3proto.capture.builtin import events

    file = source if isinstance(source, CaptureFile) else _opened(source)
    try:
        packets = file.packets()
    except BaseException:
        file.close()
        raise
    return Capture(events(packets, account, dialect=dialect, ports=ports), account, file)


def _opened(source: str | os.PathLike[str] | BinaryIO) -> CaptureFile:
    return CaptureFile.at(source) if isinstance(source, str | os.PathLike) else CaptureFile(source)
