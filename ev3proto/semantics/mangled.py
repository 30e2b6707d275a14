"""Bytes of frames that went through a text on their way: an encoding or a line end changed them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ev3proto.messages import SystemCommand, SystemReply
from ev3proto.schema.frame import parse
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, frame_size
from ev3proto.tables.frame import COMMAND_TYPES, MESSAGE_TYPES

_TYPE_AT = HEADER_SIZE - 1
_REPLACED = b"\xef\xbf\xbd"
_QUESTION = 0x3F
_ASCII = 0x80


class Mangled(NamedTuple):
    """What happened to the bytes of a frame.

    offset   the first byte that changed, and how many bytes it is now
    length
    message  what happened, as a sentence
    help     how to prevent it
    """

    offset: int
    length: int
    message: str
    help: str


def mangled(data: bytes) -> Mangled | None:
    """Returns what happened to bytes that were a frame before they went through a text; None for others."""
    found = next(_found(data), None)
    return None if found is None or _is_flawless(data) else found


def unmangled(data: bytes) -> tuple[bytes, str] | None:
    """Returns the frame that a text conversion changed, and the conversion; None if that is not certain."""
    if _is_flawless(data):
        return None
    for original, cause in ((_without_utf8(data), "UTF-8"), (data.replace(b"\r\n", b"\n"), "0D 0A for 0A")):
        if original != data and _is_flawless(original):
            return original, cause
    return None


def _found(data: bytes) -> Iterator[Mangled]:
    if _is_flawless(original := _without_utf8(data)):
        at = next(place for place, (one, other) in enumerate(zip(data, original, strict=False)) if one != other)
        yield Mangled(
            at,
            2,
            f"the frame was encoded as UTF-8: {_hex(data[at : at + 2])} is here for {_hex(original[at : at + 1])}",
            "send bytes, not a text: a byte above 7F becomes two in UTF-8",
        )
    if _is_flawless(original := data.replace(b"\r\n", b"\n")) and original != data:
        yield Mangled(
            data.index(b"\r\n"),
            2,
            "0D 0A is here for 0A: the frame went through a file or port in text mode, which changes line ends",
            "open it in binary mode",
        )
    if _REPLACED in data and _may_be(data.replace(_REPLACED, bytes((_QUESTION,)))):
        yield Mangled(
            data.index(_REPLACED),
            len(_REPLACED),
            "EF BF BD is here for a byte above 7F: the frame was decoded as UTF-8, which lost these bytes",
            "keep the frame as bytes: a text cannot hold every byte",
        )
    if _may_be(data) and (data[_TYPE_AT] != _QUESTION or data.count(_QUESTION) > 1):
        yield Mangled(
            data.index(_QUESTION),
            1,
            "3F is here for every byte above 7F: the frame was encoded as ASCII, which lost these bytes",
            "send bytes, not a text; in .NET, SerialPort.Write(byte[], int, int)",
        )


def _hex(data: bytes) -> str:
    return data.hex(" ").upper()


def _without_utf8(data: bytes) -> bytes:
    if b"\xc2" not in data and b"\xc3" not in data:
        return b""
    try:
        return data.decode("utf-8").encode("latin-1")
    except UnicodeError:
        return b""


def _is_flawless(frame: bytes) -> bool:
    """Whether bytes are a frame that a brick can read, or a reply of the right length."""
    if len(frame) <= HEADER_SIZE or frame_size(frame) != len(frame) or frame[_TYPE_AT] not in MESSAGE_TYPES:
        return False
    message = parse(frame, strict=False)
    if message.fault is not None:
        return False
    return not isinstance(message, SystemCommand | SystemReply) or message.command is not None


def _may_be(frame: bytes) -> bool:
    """Whether a frame of the right length has no byte above 7F, and question marks where it needs some."""
    if len(frame) <= COMMAND_HEADER_SIZE or frame_size(frame) != len(frame) or max(frame) >= _ASCII:
        return False
    return frame[_TYPE_AT] == _QUESTION or (
        frame[_TYPE_AT] in COMMAND_TYPES and frame[COMMAND_HEADER_SIZE] == _QUESTION
    )
