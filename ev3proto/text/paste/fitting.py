"""Which bytes of a run are frames: those whose length field fits, from one natural boundary to the next.

A boundary is natural where the run begins or ends, and where the way of separating or writing its values changes.
Between other boundaries a frame must have no flaw, or any number among many would make one.
"""

from __future__ import annotations

from collections.abc import Callable, Set
from itertools import pairwise
from typing import NamedTuple

from ev3proto.messages import DirectCommand, SystemCommand, SystemReply
from ev3proto.schema.frame import parse
from ev3proto.schema.header import (
    COMMAND_HEADER_SIZE,
    HEADER_SIZE,
    MEMORY,
    MEMORY_SIZE,
    build_frame,
    frame_size,
    is_frame_size,
    with_length,
)
from ev3proto.semantics.footprint import footprints
from ev3proto.tables.encoding import GLOBAL, LOCAL
from ev3proto.tables.frame import DIRECT_COMMAND_TYPES, LENGTH_FIELD, MAX_GLOBALS, MAX_LOCALS, MessageType

_TYPES = frozenset(int(member) for member in MessageType)
_COMMANDS = frozenset(int(member) for member in MessageType if member.is_command)
LOOKS = 7
"""The fewest bytes that look like a frame."""
_NEARLY = 2
_MOST_MISSING = 8
"""How many times as many bytes as a text has may be those of the frame that it begins."""
HASHES = (16, 20, 28, 32, 48, 64)
"""Bytes of the sums that people print beside files: MD5, SHA-1, SHA-2."""
_TYPE_AT = HEADER_SIZE - 1
_TRIES = 16
_RFCOMM = (0xEF, 0xFF)
"""The control byte of RFCOMM packets that carry data."""


class Span(NamedTuple):
    """A frame: its first byte, the byte after its last, and whether both are natural boundaries."""

    start: int
    end: int
    is_natural: bool


def is_flawless(frame: bytes) -> bool:
    """Whether a brick could read all of a frame, and knows its command."""
    message = parse(frame, strict=False)
    if message.fault is not None:
        return False
    return not isinstance(message, SystemCommand | SystemReply) or message.command is not None


def frames_in(
    data: bytes, starts: Set[int], ends: Set[int], unknown: Set[int] = frozenset(), *, is_hid: bool = False
) -> list[Span]:
    """Returns the frames in the bytes of a run, in their order. They do not overlap.

    Args:
        data: The bytes.
        starts: Offsets of natural boundaries at which a frame may start.
        ends: Offsets of natural boundaries at which a frame may end.
        unknown: Offsets of bytes that are not given; only those of a counter may be.
        is_hid: A report number of zero may be in front.
    """
    found: list[Span] = []
    size, padded = len(data), len(data.rstrip(b"\0"))
    budget = _TRIES * size + 1024
    at = after = 0
    while at + HEADER_SIZE <= size:
        end = at + frame_size(data, at)
        if data[at + _TYPE_AT] not in _TYPES or end > size or not is_frame_size(end - at):
            at += 1
            continue
        is_carried = _is_in_rfcomm(data, at, end)
        starts_well = is_carried or at in starts or (at == after and bool(found)) or (is_hid and at == 1)
        ends_well = is_carried or end in ends or (end >= padded and size in ends) or _continues(data, end)
        takes = starts_well and ends_well
        if not takes and budget > 0:
            budget -= end - at
            is_long = end - at >= LOOKS
            is_lone = data[at + _TYPE_AT] in _COMMANDS and 0 < at < HEADER_SIZE
            may = not starts_well and (ends_well or is_lone) and (is_long or at <= 2)
            takes = may and (not is_long or is_something(data[at:end])) and is_flawless(bytes(data[at:end]))
        if takes and not any(at <= place < at + 2 or at + 4 <= place < end for place in unknown):
            found.append(Span(at, end, starts_well and ends_well))
            at = after = end
        else:
            at += 1
    return found


def is_something(frame: bytes) -> bool:
    """Whether more is in a frame than zeros and ones, which are operations without a flaw that programs do not send."""
    return len(set(frame[HEADER_SIZE:])) > 2


def _is_in_rfcomm(data: bytes, at: int, end: int) -> bool:
    """Whether RFCOMM is around a frame: the control byte and its length in front, one byte of a check sum after."""
    size = end - at
    if at < 3 or end + 1 != len(data):
        return False
    length = bytes((size << 1 | 1,)) if size < 0x80 else bytes(((size & 0x7F) << 1, size >> 7 & 0xFF))
    return any(
        at > len(before) + 1 and data[at - len(before) - 1] in _RFCOMM and data[at - len(before) : at] == before
        for before in (length, length + data[at - 1 : at])
    )


def _continues(data: bytes, at: int) -> bool:
    """Whether another frame starts there and ends inside the bytes."""
    if at + HEADER_SIZE > len(data) or data[at + _TYPE_AT] not in _TYPES:
        return False
    end = at + frame_size(data, at)
    return end <= len(data) and is_frame_size(end - at)


def may_begin(data: bytes | bytearray) -> bool:
    """Whether a frame may begin there: its length and its type are possible, as far as they are there."""
    if len(data) < LENGTH_FIELD or not is_frame_size(says := frame_size(data)) or says > _MOST_MISSING * len(data):
        return False
    return len(data) <= _TYPE_AT or data[_TYPE_AT] in _TYPES


def covered(spans: list[Span]) -> int:
    """Returns how many bytes the frames have."""
    return sum(span.end - span.start for span in spans)


def is_whole(data: bytes, spans: list[Span]) -> bool:
    """Whether the frames are all of the bytes, but for padding with zeros."""
    return bool(spans) and covered(spans) == spans[-1].end and not any(data[spans[-1].end :])


def reason(data: bytes, *, is_dense: bool, is_decimal: bool) -> str | None:
    """Returns why bytes that are not a frame look like one, as a sentence; None where they do not.

    Args:
        data: The bytes of a run, from a natural boundary to the next.
        is_dense: They are written without blanks, as hashes and fingerprints are.
        is_decimal: They are decimal numbers, of which prose and tables have many.
    """
    if len(data) < LOOKS or _counts_up(data):
        return None
    says = frame_size(data)
    has_type = data[_TYPE_AT] in _TYPES
    if is_dense and len(data) in HASHES and not (abs(says - len(data)) <= _NEARLY and has_type):
        return None
    if swapped(data):
        return f"the length field says {says - LENGTH_FIELD}: did you swap its bytes {data[:2].hex(' ').upper()}?"
    if says > _MOST_MISSING * len(data) or (is_decimal and not any(data[2:])):
        return None
    is_near = abs(says - len(data)) <= _NEARLY
    if not is_near and not (has_type and (is_frame_size(says) or is_flawless(with_length(data[LENGTH_FIELD:])))):
        return None
    here = f"{len(data)} bytes"
    if says > len(data):
        is_own = says - len(data) == LENGTH_FIELD
        return f"{here} begin a frame of {says}" + ": does the length count its own two bytes?" * is_own
    if is_frame_size(says):
        return f"{here} are here, and the length field is that of a frame of {says}"
    return f"{here} are here, and the length field says {says - LENGTH_FIELD}"


def is_nearly(data: bytes) -> bool:
    """Whether bytes are a frame but for a length field that is wrong by a little, and does not count itself."""
    if len(data) < LOOKS or data[_TYPE_AT] not in _TYPES:
        return False
    says = frame_size(data)
    return is_frame_size(says) and -_NEARLY <= says - len(data) < LENGTH_FIELD


def swapped(data: bytes) -> bool:
    """Whether the length field fits once its two bytes are swapped, and the rest is a frame without a flaw."""
    right = data[1::-1] + data[2:]
    return len(data) >= LOOKS and frame_size(right) == len(data) and data[_TYPE_AT] in _TYPES and is_flawless(right)


def bare_reason(data: bytes) -> str | None:
    """Returns what bytes without a header are, as a sentence, and which option reads them; None for other bytes."""
    if len(data) < HEADER_SIZE or _counts_up(data) or swapped(data):
        return None
    says = frame_size(data)
    is_padded = is_frame_size(says) and data[_TYPE_AT] in _TYPES and says < len(data) and not any(data[says:])
    if abs(says - len(data)) <= _NEARLY or is_padded:
        return None
    for text, make in _BARE:
        frame = make(data)
        if frame is not None and is_flawless(frame):
            return text
    return None


def without_length(data: bytes) -> bytes | None:
    """Returns the bytes as a message that lost its length field; None where they are too few or too many."""
    if not is_frame_size(len(data) + LENGTH_FIELD) or data[_TYPE_AT - LENGTH_FIELD] not in _TYPES:
        return None
    return with_length(data)


def with_header(data: bytes) -> bytes | None:
    """Returns the bytes as the operations of a direct command with the memory that they use for sure."""
    if not data or not is_frame_size(COMMAND_HEADER_SIZE + len(data)):
        return None
    plain = build_frame(MessageType.DIRECT_COMMAND_NO_REPLY, 0, bytes(MEMORY_SIZE) + data)
    message = parse(plain, strict=False)
    if not isinstance(message, DirectCommand):
        return None
    used = {GLOBAL: 0, LOCAL: 0}
    for operation in message.operations:
        for found in footprints(operation):
            scope = found.argument.kind
            used[scope] = max(used[scope], found.start + (found.room or found.size))
    if not any(used.values()) or used[GLOBAL] > MAX_GLOBALS or used[LOCAL] > MAX_LOCALS:
        return plain
    code = DIRECT_COMMAND_TYPES[bool(used[GLOBAL])]
    return build_frame(code, 0, MEMORY.build({"globals": used[GLOBAL], "locals": used[LOCAL]}) + data)


_BARE: tuple[tuple[str, Callable[[bytes], bytes | None]], ...] = (
    ("this is a frame without its length bytes: --no-length reads it", without_length),
    ("these are operations without the header of a frame: --operations reads them", with_header),
)


def _counts_up(data: bytes) -> bool:
    """Whether the values are all the same, or count up or down, as the head of a dump does."""
    step = (data[1] - data[0]) & 0xFF
    return step in (0, 1, 255) and all((b - a) & 0xFF == step for a, b in pairwise(data))
