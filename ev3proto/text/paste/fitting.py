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
)
from ev3proto.semantics.footprint import footprints
from ev3proto.tables.encoding import GLOBAL, LOCAL
from ev3proto.tables.frame import DIRECT_COMMAND_TYPES, LENGTH_FIELD, MAX_GLOBALS, MAX_LOCALS, MessageType

_TYPES = frozenset(int(member) for member in MessageType)
_COMMANDS = frozenset(int(member) for member in MessageType if member.is_command)
LOOKS = 7
"""So many values in a row may look like a frame."""
NEARLY = 2
_PLAUSIBLE = 4
"""The high byte of a length field is less than this in nearly all frames there are: they have up to 1023 bytes."""
_MOST_MISSING = 8
"""So many times the numbers that stand there may be missing of a frame in decimal numbers."""
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
    """Whether a frame has nothing in it that a brick could not read, and a command that there is."""
    message = parse(frame, strict=False)
    if message.fault is not None:
        return False
    return not isinstance(message, SystemCommand | SystemReply) or message.command is not None


def frames_in(
    data: bytes, starts: Set[int], ends: Set[int], unknown: Set[int] = frozenset(), *, is_hid: bool = False
) -> list[Span]:
    """The frames in the bytes of a run.

    Args:
        data: The bytes.
        starts: Offsets of natural boundaries at which a frame may start.
        ends: Offsets of natural boundaries at which a frame may end.
        unknown: Offsets of bytes that were not written; they can belong to the counter only.
        is_hid: A report number of zero may stand in front.

    Returns:
        The frames in their order. They do not overlap.
    """
    found: list[Span] = []
    size = len(data)
    padded = len(data.rstrip(b"\0"))
    budget = _TRIES * size + 1024
    at = after = 0
    while at + HEADER_SIZE <= size:
        end = at + frame_size(data, at)
        if data[at + _TYPE_AT] not in _TYPES or end > size or not is_frame_size(end - at):
            at += 1
            continue
        if _is_in_rfcomm(data, at, end):
            starts, ends = starts | {at}, ends | {end}
        starts_well = at in starts or (at == after and bool(found)) or (is_hid and at == 1)
        ends_well = end in ends or (end >= padded and size in ends) or _goes_on(data, end)
        takes = starts_well and ends_well
        if not takes and budget > 0:
            budget -= end - at
            is_long = end - at >= LOOKS
            is_lone = data[at + _TYPE_AT] in _COMMANDS and 0 < at < HEADER_SIZE
            may = not starts_well and (ends_well or is_lone)
            says_something = is_something(data[at:end]) or not is_long
            takes = may and says_something and (is_long or at <= 2) and is_flawless(bytes(data[at:end]))
        if takes and not any(at <= place < at + 2 or at + 4 <= place < end for place in unknown):
            found.append(Span(at, end, starts_well and ends_well))
            at = after = end
        else:
            at += 1
    return found


def is_something(frame: bytes) -> bool:
    """Whether more is in a frame than zeros and ones: they are operations without a flaw, but nobody sends them."""
    return len(set(frame[HEADER_SIZE:])) > 2


def _is_in_rfcomm(data: bytes, at: int, end: int) -> bool:
    """Whether RFCOMM stands around a frame: the control byte and its length in front, one byte of a check sum after."""
    size = end - at
    if at < 3 or end + 1 != len(data):
        return False
    length = bytes((size << 1 | 1,)) if size < 0x80 else bytes(((size & 0x7F) << 1, size >> 7 & 0xFF))
    for before in (length, length + data[at - 1 : at]):
        control = at - len(before) - 1
        if control >= 1 and data[control] in _RFCOMM and data[control + 1 : at] == before:
            return True
    return False


def _goes_on(data: bytes, at: int) -> bool:
    """Whether another frame starts there and ends inside the bytes."""
    if at + HEADER_SIZE > len(data) or data[at + _TYPE_AT] not in _TYPES:
        return False
    end = at + frame_size(data, at)
    return end <= len(data) and is_frame_size(end - at)


def may_begin(data: bytes | bytearray) -> bool:
    """Whether a frame may begin there: its length and its type are possible."""
    return len(data) >= HEADER_SIZE and is_frame_size(frame_size(data)) and data[_TYPE_AT] in _TYPES


def covered(spans: list[Span]) -> int:
    """How many bytes the frames have."""
    return sum(span.end - span.start for span in spans)


def is_whole(data: bytes, spans: list[Span]) -> bool:
    """Whether the frames are all there is, but for padding with zeros."""
    return bool(spans) and covered(spans) == spans[-1].end and not any(data[spans[-1].end :])


def reason(data: bytes, *, is_dense: bool, is_decimal: bool) -> str | None:
    """Why bytes that are no frame look like one, as a sentence; None where they do not.

    Args:
        data: The bytes of a run, from a natural boundary to the next.
        is_dense: They stand without blanks, as hashes and fingerprints do.
        is_decimal: They are decimal numbers, of which prose and tables have many.
    """
    if len(data) < LOOKS or _counts_up(data):
        return None
    says = frame_size(data)
    is_near = abs(says - len(data)) <= NEARLY and is_frame_size(says)
    has_type = data[_TYPE_AT] in _TYPES
    if is_dense and len(data) in HASHES and not (is_near and has_type):
        return None
    if has_type and is_decimal:
        has_type = data[1] < _PLAUSIBLE and any(data[2:]) and says <= _MOST_MISSING * len(data)
    if not is_near and not has_type:
        return None
    if says > len(data):
        return f"{len(data)} bytes begin a frame of {says}"
    if says < len(data) and is_frame_size(says):
        return f"{len(data)} bytes stand here, and the length field is that of a frame of {says}"
    return f"{len(data)} bytes stand here, and the length field says {says - LENGTH_FIELD}"


def bare_reason(data: bytes) -> str | None:
    """What bytes without a header are, as a sentence, and which option reads them; None where they are none."""
    if len(data) < HEADER_SIZE or _counts_up(data):
        return None
    says = frame_size(data)
    if abs(says - len(data)) <= NEARLY:
        return None
    if is_frame_size(says) and data[_TYPE_AT] in _TYPES and says < len(data) and not any(data[says:]):
        return None  # a frame with padding
    for text, make in _BARE:
        frame = make(data)
        if frame is not None and is_flawless(frame):
            return text
    return None


def with_length(data: bytes) -> bytes | None:
    """The bytes as a message that lost its length field; None where they are too few or too many."""
    if not is_frame_size(len(data) + LENGTH_FIELD) or data[_TYPE_AT - LENGTH_FIELD] not in _TYPES:
        return None
    return len(data).to_bytes(LENGTH_FIELD, "little") + data


def with_header(data: bytes) -> bytes | None:
    """The bytes as the operations of a direct command with the memory that they use for sure."""
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
    ("this is a frame without its length bytes: --no-length reads it", with_length),
    ("these are operations without the header of a frame: --operations reads them", with_header),
)


def _counts_up(data: bytes) -> bool:
    """Whether the values are all the same, or count up or down, as the head of a dump does."""
    step = (data[1] - data[0]) & 0xFF
    return step in (0, 1, 255) and all((b - a) & 0xFF == step for a, b in pairwise(data))
