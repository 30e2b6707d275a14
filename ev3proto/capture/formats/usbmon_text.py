"""The text of Linux's usbmon, as `cat /sys/kernel/debug/usb/usbmon/1u` prints it: a line for each half of a request.

It has at most 32 bytes of each report. https://www.kernel.org/doc/html/latest/usb/usbmon.html
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from io import BufferedReader
from typing import Any

from ev3proto.capture.packets import Format, Interface, Packet
from ev3proto.capture.record import CaptureError
from ev3proto.errors import counted
from ev3proto.tables.carriers import Link

_LINE = re.compile(
    r"""
    (?P<tag> [0-9a-f]{1,16})\ (?P<microseconds> \d{1,10})\ (?P<event> [SCE])
    \ (?P<type> [ZICB])(?P<way> [io]):(?P<bus> \d{1,3}):(?P<device> \d{1,3}):(?P<endpoint> \d{1,2})
    \ (?: \S (?:\ [0-9a-f_]{2}){2} (?:\ [0-9a-f_]{4}){3} | (?P<status> -?\d{1,9})\S* )  # a control request, or a status
    (?: \ \d+ (?:\ -?\d+:\d+:\d+)* )?                                                  # the packets of isochronous ones
    \ (?P<size> \d{1,9})
    (?: \ (?: =(?P<data> (?:\ (?:[0-9a-f]{2})+)*) | \S) )?
    """,
    re.VERBOSE | re.ASCII,
)
_START = re.compile(rb"[0-9a-f]{1,16} \d{1,10} [SCE] [ZICB][io]:\d+:\d+:\d+ ")
_BEGUN = re.compile(rb"[0-9a-f]{0,16}|[0-9a-f]{1,16} \d{0,10}( ([SCE]( ([ZICB]([io](:[\d:]*)?)?)?)?)?)?")
_BYTE_ORDER_MARK = b"\xef\xbb\xbf"

_TYPES = {"Z": 0, "I": 1, "C": 2, "B": 3}
_IN, _NO_SETUP, _NO_DATA = 0x80, ord("-"), ord("<")

_SECOND = 1_000_000
_CYCLE = 4096 * _SECOND
"""Microseconds after which the times begin again at 0."""

_NEEDED = 4096
_MOST_LINE = 1024


def _is_comment(line: bytes) -> bool:
    return not line or line.startswith(b"#")


def _matches(head: bytes) -> bool | None:
    """Returns whether the first line of a text is usbmon's, after empty lines and comments; None for too few bytes."""
    *whole, begun = head.removeprefix(_BYTE_ORDER_MARK).split(b"\n")
    for line in map(bytes.strip, whole):
        if not _is_comment(line):
            return _START.match(line) is not None
    begun = begun.lstrip()
    if _START.match(begun):
        return True
    may_be = (_is_comment(begun) or _BEGUN.fullmatch(begun)) and len(head) < _NEEDED
    return None if may_be else False


class _Clock:
    """Times from the first line on, although those of the kernel begin again."""

    def __init__(self) -> None:
        self._first_ns: int | None = None
        self._last = self._turns = 0

    def time_ns(self, microseconds: int) -> int:
        """Returns the time of the next line, in nanoseconds."""
        self._turns += self._last - microseconds > _CYCLE // 2
        self._last = microseconds
        time_ns = (self._turns * _CYCLE + microseconds) * 1000
        if self._first_ns is None:
            self._first_ns = time_ns
        return time_ns - self._first_ns


def _header(found: re.Match[str], size: int, captured: int) -> bytes:
    from ev3proto.capture.carriers.usb.requests import USBMON  # takes 8 ms, which other formats do not need

    return USBMON["<"].pack(
        int(found["tag"], 16),
        ord(found["event"]),
        _TYPES[found["type"]],
        int(found["endpoint"]) | _IN * (found["way"] == "i"),
        int(found["device"]),
        int(found["bus"]),
        _NO_SETUP,
        _NO_DATA * (not captured),
        *divmod(int(found["microseconds"]), _SECOND),
        int(found["status"] or 0) & 0xFFFFFFFF,
        size,
        captured,
        b"",
    )


def packets(stream: BufferedReader[Any]) -> Iterator[Packet]:
    """Yields the packets of a file as usbmon's binary ones; their times count from the first. Raises CaptureError."""
    interface, clock = Interface(Link.USBMON), _Clock()
    number = at = wrong = first_wrong = 0
    while line := stream.readline(_MOST_LINE):
        at += 1
        text = line.removeprefix(_BYTE_ORDER_MARK).strip()
        found = _LINE.fullmatch(text.decode("latin-1"))
        if found is not None:
            number += 1
            data = bytes.fromhex(found["data"] or "")
            size = int(found["size"]) if data else 0
            head = _header(found, size, len(data))
            time_ns = clock.time_ns(int(found["microseconds"]))
            yield Packet(number, time_ns, head + data, len(head) + size, interface)
        elif not _is_comment(text):
            wrong += 1
            first_wrong = first_wrong or at
    if wrong:
        raise CaptureError(f"{counted(wrong, 'line')} cannot be read, the first is line {first_wrong}")


FORMAT = Format("usbmon's text", (".txt", ".mon"), _NEEDED, _matches, packets)
