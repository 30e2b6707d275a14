"""WiFi discovery: the beacon a brick broadcasts, the text that unlocks its TCP port, and the answer.

They are lines of text, not frames, and come before the first frame.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from ev3proto.errors import BuildError, DecodeError, as_bytes
from ev3proto.tables.discovery import (
    BEACON_LINES,
    PROTOCOL,
    TCP_PORT,
    UNLOCK_ENDINGS,
    UNLOCK_PROTOCOL,
    UNLOCK_REQUEST,
    UNLOCK_VERSION,
)
from ev3proto.tables.encoding import STRING_CODING

NEWLINE = b"\r\n"

_PORT = re.compile(r"[0-9]{1,9}")
_LAST_PORT = 0xFFFF


_HEADS = {name: f"{label}: ".encode(STRING_CODING) for name, label in BEACON_LINES.items()}
"""The start of each line of a beacon, whose text follows."""


def is_beacon(datagram: bytes, *, is_cut: bool = False) -> bool:
    """Returns whether a datagram is a beacon, possibly a faulty one.

    Args:
        datagram: The datagram's contents.
        is_cut: The capture has only its beginning.

    Returns:
        True if it begins with the labels of a beacon's first two lines, as far as captured, and names no other
        protocol.

    Raises:
        TypeError: The datagram is not bytes.
    """
    if not isinstance(datagram, bytes):
        datagram = as_bytes(datagram, "a datagram")
    first, second, *_, last = _HEADS.values()
    if not datagram.startswith(first):
        return False
    rest = datagram.partition(NEWLINE)[2]
    if not rest.startswith(second) and not (is_cut and second.startswith(rest)):
        return False
    protocol = rest.partition(NEWLINE + last)[2].partition(NEWLINE[:1])[0]
    return PROTOCOL.encode(STRING_CODING).startswith(protocol)


@dataclass(frozen=True, slots=True)
class Beacon:
    """The announcement of a brick: serial number (its MAC address in hex), TCP port, name, protocol, all as text."""

    serial: str
    port: str = str(TCP_PORT)
    name: str = PROTOCOL
    protocol: str = PROTOCOL

    @property
    def tcp_port(self) -> int | None:
        """The port as a number, 1 to 65535; None if the text is not such a number."""
        if not _PORT.fullmatch(self.port):
            return None
        number = int(self.port)
        return number if 1 <= number <= _LAST_PORT else None

    @classmethod
    def parse(cls, datagram: bytes) -> Beacon:
        """Parses a datagram. Raises DecodeError that names the faulty line."""
        found, at = {}, 0
        for name, head in _HEADS.items():
            end = datagram.find(NEWLINE, at)
            if end < 0 or not datagram.startswith(head, at):
                raise DecodeError(at, f"expected a line '{head.decode()}...' that ends with \\r\\n")
            found[name] = datagram[at + len(head) : end].decode(STRING_CODING)
            at = end + len(NEWLINE)
        if at < len(datagram):
            raise DecodeError(at, f"{len(datagram) - at} bytes follow the beacon's last line")
        return cls(**found)

    def build(self) -> bytes:
        """Builds the datagram. Raises BuildError for a line break or a character outside ISO-8859-1."""
        return b"".join(self._line(head, getattr(self, name)) for name, head in _HEADS.items())

    @staticmethod
    def _line(head: bytes, text: str) -> bytes:
        if not isinstance(text, str) or set(text) & set("\r\n\0") or any(ord(letter) > 0xFF for letter in text):
            raise BuildError(f"{head.decode()[:-2]} cannot be {text!r}: it must be one line of ISO-8859-1 text")
        return head + text.encode(STRING_CODING) + NEWLINE


_UNLOCK = re.compile(
    rf"{re.escape(UNLOCK_REQUEST)}([\w:]*?)( ?)((?:{re.escape(UNLOCK_VERSION)})?)(\r?\n)"
    rf"{re.escape(UNLOCK_PROTOCOL)}( ?){PROTOCOL}((?:\4){{0,{UNLOCK_ENDINGS}}})".encode()
)


@dataclass(frozen=True, slots=True)
class Unlock:
    r"""The first text that a host sends by TCP. The brick checks only for `ET /target?sn=`, so senders differ.

    serial      serial number of the brick, as in its beacon or with colons; empty if the sender does not know it
    space       whether a space follows the serial number
    newline     line ending, "\r\n" or "\n"
    endings     number of line ends after the last line, 0 to 2 (2: an empty line ends the text)
    version     whether the first line ends with the protocol's version
    gap         whether a space precedes the name of the protocol
    """

    serial: str
    space: bool = True
    newline: str = "\r\n"
    endings: int = 2
    version: bool = True
    gap: bool = True

    @classmethod
    def parse(cls, text: bytes) -> Unlock:
        """Parses exactly one unlock text. Raises DecodeError for anything else."""
        unlock, end = cls.read(text)
        if end < len(text):
            raise DecodeError(end, f"{len(text) - end} bytes follow the unlock text")
        return unlock

    @classmethod
    def read(cls, data: bytes, at: int = 0) -> tuple[Unlock, int]:
        """Returns the unlock text at an offset, and the offset after it. Raises DecodeError."""
        found = _UNLOCK.match(data, at)
        if found is None:
            raise DecodeError(at, "expected an unlock text: 'GET /target?sn=... VMTP1.0' and a line 'Protocol: EV3'")
        serial, space, version, newline, gap, ending = found.groups()
        endings = len(ending) // len(newline)
        return cls(serial.decode(), bool(space), newline.decode(), endings, bool(version), bool(gap)), found.end()

    def build(self) -> bytes:
        """Builds the text. Raises BuildError for a serial number that is not a word."""
        if self.endings not in range(UNLOCK_ENDINGS + 1):
            raise BuildError(
                f"an unlock text has 0 to {UNLOCK_ENDINGS} line ends after its last line, not {self.endings!r}"
            )
        version = " " * bool(self.space) + UNLOCK_VERSION * bool(self.version)
        protocol = UNLOCK_PROTOCOL + " " * bool(self.gap) + PROTOCOL
        text = f"{UNLOCK_REQUEST}{self.serial}{version}{self.newline}{protocol}{self.newline * self.endings}"
        try:
            found = _UNLOCK.fullmatch(text.encode(STRING_CODING))
        except UnicodeEncodeError:
            found = None
        if found is None:
            raise BuildError(
                f"an unlock text cannot have the serial number {self.serial!r} and line ends {self.newline!r}: use"
                " letters, digits and colons for the number, \\r\\n or \\n for line ends"
            )
        return found.group()
