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


def packets(stream: BufferedReader[Any]) -> Iterator[Packet]:
    """Yields the packets of a file as usbmon's binary ones; their times count from the first. Raises CaptureError."""
    from ev3proto.capture.carriers.usb.requests import USBMON  # takes 8 ms, which other formats do not need

    interface, header = Interface(Link.USBMON), USBMON["<"]
    number = at = turns = 0
    first = last = None
    wrong: list[int] = []
    while line := stream.readline(_MOST_LINE):
        at += 1
        text = line.removeprefix(_BYTE_ORDER_MARK).strip()
        found = _LINE.fullmatch(text.decode("latin-1"))
        if found is None:
            wrong += [] if _is_comment(text) else [at]
            continue
        microseconds = int(found["microseconds"])
        turns += last is not None and last - microseconds > _CYCLE // 2
        last = microseconds
        first = microseconds if first is None else first
        number += 1
        data, size = bytes.fromhex(found["data"] or ""), int(found["size"]) if found["data"] else 0
        head = header.pack(
            int(found["tag"], 16),
            ord(found["event"]),
            _TYPES[found["type"]],
            int(found["endpoint"]) | _IN * (found["way"] == "i"),
            int(found["device"]),
            int(found["bus"]),
            _NO_SETUP,
            0 if data else _NO_DATA,
            *divmod(microseconds, _SECOND),
            int(found["status"] or 0) & 0xFFFFFFFF,
            size,
            len(data),
            b"",
        )
        time_ns = (turns * _CYCLE + microseconds - first) * 1000
        yield Packet(number, time_ns, head + data, len(head) + size, interface)
    if wrong:
        lines = "lines" if len(wrong) > 1 else "line"
        raise CaptureError(f"{len(wrong)} {lines} cannot be read, the first is line {wrong[0]}")


FORMAT = Format("usbmon's text", (".txt", ".mon"), _NEEDED, _matches, packets)
