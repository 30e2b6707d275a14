"""Reading of captures: `read` returns the records of a file, and all other events."""

from __future__ import annotations

import os
from collections.abc import Collection, Generator, Iterator
from typing import BinaryIO, Self

from ev3proto.bounded import DEFAULT_MEMORY, Budget
from ev3proto.capture.byte_account import Account
from ev3proto.capture.carriers import CarrierReader, reader
from ev3proto.capture.carriers.streams import Context
from ev3proto.capture.formats import CaptureFile
from ev3proto.capture.packets import Packet
from ev3proto.capture.record import CaptureError, Event, Record
from ev3proto.schema.frame import frame_reader
from ev3proto.tables import check_dialect
from ev3proto.tables.carriers import Carrier


class Capture:
    """A capture to iterate once, for its records, or with `events` for everything in it.

    It is closed at its end, when it is no longer referred to, or by `close` or a `with`.

    account  the account of the captured bytes so far
    """

    def __init__(self, events: Iterator[Event], account: Account, file: CaptureFile | None = None) -> None:
        self._events = events
        self._file = file
        self.account = account

    @property
    def progress(self) -> float | None:
        """The part of the file that was read, 0 to 1; None if its size is unknown."""
        return None if self._file is None else self._file.progress

    def __iter__(self) -> Iterator[Record]:
        try:
            for event in self._events:
                if type(event) is Record:
                    yield event
        finally:
            self.close()

    def events(self) -> Iterator[Event]:
        """Reads the capture.

        Yields:
            Records, announcements and skipped bytes, in the order in which they became complete.

        Raises:
            CaptureError: The file is damaged. Everything readable was given before.
            OSError: The file cannot be read.
        """
        try:
            yield from self._events
        finally:
            self.close()

    def close(self) -> None:
        """Closes the file, and ends iterating."""
        if isinstance(self._events, Generator):
            self._events.close()
        if self._file is not None:
            self._file.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __del__(self) -> None:
        self.close()


def read(
    source: str | os.PathLike[str] | BinaryIO | CaptureFile,
    *,
    dialect: str = "official",
    ports: Collection[int] = (),
    everything: bool = False,
    memory: int = DEFAULT_MEMORY,
) -> Capture:
    """Reads a capture file of any of `capture.formats`, with gzip or not, recognised by its first bytes.

    `ev3proto.pyshark.read` reads all formats and link types of Wireshark.

    Args:
        source: A path, a binary stream at its start (which stays open), or a CaptureFile.
        dialect: The firmware whose instruction set is used.
        ports: TCP ports on which bricks listen: all their traffic is read, recognised or not. Without any, traffic on
            port 5555 is read if it is recognised.
        everything: Also read unrecognised traffic on that port, on a brick's Bluetooth channel, and in USB reports of a
            brick's size.
        memory: Memory limit in bytes for everything pending: unanswered commands, segments ahead of their turn, and so
            on. The oldest are evicted first; `account.forgotten` counts them.

    Returns:
        The capture. Iterating it raises CaptureError for a damaged file, after everything readable.

    Raises:
        OSError: The file cannot be opened.
        CaptureError: The file is not a capture.
        ValueError: The dialect is unknown.

    """
    check_dialect(dialect)
    account = Account()
    file = source if isinstance(source, CaptureFile) else _opened(source)
    try:
        packets = file.packets()
    except BaseException:
        file.close()
        raise
    context = Context(frame_reader(dialect), account, frozenset(ports), Budget(memory), is_all=everything)
    return Capture(_events_in(packets, context), account, file)


def _opened(source: str | os.PathLike[str] | BinaryIO) -> CaptureFile:
    if isinstance(source, str | os.PathLike):
        return CaptureFile.at(source)
    return CaptureFile(source)


_CARRIERS = {int(link): carrier for carrier in Carrier for link in carrier.facts.links}


_UNREAD = {266: "USB on macOS"}
"""Names of link types that are not read."""


def _named(link: int) -> str:
    return f"{link} ({_UNREAD[link]})" if link in _UNREAD else str(link)


def _events_in(packets: Iterator[Packet], context: Context) -> Iterator[Event]:
    """Yields the events in packets. Raises CaptureError after everything readable."""
    account = context.account
    readers: dict[Carrier, CarrierReader] = {}
    unknown: set[int] = set()
    trouble: CaptureError | None = None
    try:
        for packet in packets:
            captured = len(packet.data)
            account.count_packet(packet.time_ns, captured, packet.size)
            carrier = _CARRIERS.get(packet.interface.link)
            if carrier is None:
                unknown.add(packet.interface.link)
                account.other += captured
                continue
            if carrier not in readers:
                readers[carrier] = reader(carrier, context)
            if captured:
                yield from readers[carrier].feed(packet)
            if context.late:
                yield from context.late
                context.late.clear()
    except CaptureError as error:
        trouble = error
    for each in readers.values():
        yield from each.end()
    account.forgotten = context.budget.dropped
    if trouble is not None:
        raise trouble
    if unknown:
        links = ", ".join(map(_named, sorted(unknown)))
        raise CaptureError(
            f"packets of link type {links} were not read; --engine wireshark reads all link types of Wireshark"
        )
