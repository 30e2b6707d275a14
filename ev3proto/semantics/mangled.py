"""Bytes of frames that went through a text on their way: an encoding or a line end changed them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ev3proto.schema.frame import FrameReader, is_flawless
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, TYPE_AT, frame_size
from ev3proto.tables.frame import COMMAND_TYPES, MESSAGE_TYPES

_REPLACED = b"\xef\xbf\xbd"
_QUESTION = b"?"
_ASCII = 0x80


class Mangled(NamedTuple):
    """What happened to the bytes of a frame.

    kind      utf-8 or text-mode; replaced or ascii where bytes are lost
    original  the frame before that, with zeros for the lost bytes
    lost      the offsets of these
    """

    kind: str
    original: bytes
    lost: tuple[int, ...] = ()


def mangled(data: bytes, reader: FrameReader | None = None) -> Mangled | None:
    """Returns what happened to bytes that were a frame before they went through a text; None for others.

    Args:
        data: The bytes.
        reader: The reader of the dialect; None: of the official one.
    """
    return None if _is_flawless(data, reader) else next(_found(data, reader), None)


def _found(data: bytes, reader: FrameReader | None) -> Iterator[Mangled]:
    for kind, original in (("utf-8", _without_utf8(data)), ("text-mode", data.replace(b"\r\n", b"\n"))):
        if original != data and _is_flawless(original, reader):
            yield Mangled(kind, original)
    if _REPLACED in data and _may_be(data.replace(_REPLACED, _QUESTION)):
        yield _lost("replaced", data, _REPLACED)
    if _may_be(data) and (data[TYPE_AT] != _QUESTION[0] or data.count(_QUESTION) > 1):
        yield _lost("ascii", data, _QUESTION)


def _lost(kind: str, data: bytes, mark: bytes) -> Mangled:
    pieces = data.split(mark)
    lost, at = [], -1
    for piece in pieces[:-1]:
        at += len(piece) + 1
        lost.append(at)
    return Mangled(kind, b"\0".join(pieces), tuple(lost))


def _without_utf8(data: bytes) -> bytes:
    if b"\xc2" not in data and b"\xc3" not in data:
        return data
    try:
        return data.decode("utf-8").encode("latin-1")
    except UnicodeError:
        return data


def _is_flawless(frame: bytes, reader: FrameReader | None) -> bool:
    """Returns whether bytes are a frame that a brick can read, or a reply of the right length."""
    if len(frame) <= HEADER_SIZE or frame_size(frame) != len(frame) or frame[TYPE_AT] not in MESSAGE_TYPES:
        return False
    return is_flawless(frame, reader)


def _may_be(frame: bytes) -> bool:
    """Returns whether a frame of the right length has no byte above 7F, and question marks where it needs some."""
    if len(frame) <= COMMAND_HEADER_SIZE or frame_size(frame) != len(frame) or max(frame) >= _ASCII:
        return False
    at = COMMAND_HEADER_SIZE
    return frame[TYPE_AT] == _QUESTION[0] or (frame[TYPE_AT] in COMMAND_TYPES and frame[at] == _QUESTION[0])
