"""Which bytes of a run are frames: those whose length field fits, from one natural boundary to the next.

A boundary is natural where the run begins or ends, and where the way of separating or writing its values changes.
Between other boundaries a frame must have no flaw, or any number among many would make one.
"""

from __future__ import annotations

from collections.abc import Callable, Set
from itertools import pairwise

from ev3proto.messages import DirectCommand, SystemCommand, SystemReply
from ev3proto.schema.frame import parse
from ev3proto.schema.header import (
    COMMAND_HEADER_SIZE,
    HEADER_SIZE,
    MEMORY_SIZE,
    build_frame,
    frame_size,
    is_frame_size,
    may_have_length,
    with_length,
    write_memory,
)
from ev3proto.semantics.footprint import footprints
from ev3proto.tables.encoding import GLOBAL, LOCAL
from ev3proto.tables.frame import DIRECT_COMMAND_TYPES, LENGTH_FIELD, MAX_GLOBALS, MAX_LOCALS, MessageType

_TYPES = frozenset(map(int, MessageType))
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


def is_flawless(frame: bytes) -> bool:
    """Whether a brick could read all of a frame, and knows its command."""
    message = parse(frame, strict=False)
    if message.fault is not None:
        return False
    return not isinstance(message, SystemCommand | SystemReply) or message.command is not None


def is_something(frame: bytes) -> bool:
    """Whether more is in a frame than zeros and ones, which are operations without a flaw that programs do not send."""
    return len(set(frame[HEADER_SIZE:])) > 2


def is_one_frame(data: bytes) -> bool:
    """Whether bytes that were gathered among words are one frame, without a flaw and not by chance."""
    return len(data) >= HEADER_SIZE and frame_size(data) == len(data) and is_something(data) and is_flawless(data)


def frames_in(
    data: bytes, starts: Set[int], ends: Set[int], unknown: Set[int], *, is_hid: bool
) -> list[tuple[int, int, bool]]:
    """Returns the frames in the bytes of a run, in their order; they do not overlap.

    Args:
        data: The bytes.
        starts: Offsets of natural boundaries at which a frame may start.
        ends: Offsets of natural boundaries at which a frame may end.
        unknown: Offsets of bytes that are not given; only those of a counter may be.
        is_hid: A report number of zero may be in front.

    Returns:
        Of each frame its first byte, the byte after its last, and whether both are natural boundaries.
    """
    found: list[tuple[int, int, bool]] = []
    size, padded = len(data), len(data.rstrip(b"\0"))
    budget = _TRIES * size + 1024
    at = after = 0
    while at + HEADER_SIZE <= size:
        end = _end(data, at)
        if end is None:
            at += 1
            continue
        # RFCOMM has its control byte and its length in front of a frame, and one byte of a check sum after it.
        is_carried = end + 1 == size and any(byte in _RFCOMM for byte in data[max(at - 3, 0) : max(at - 1, 0)])
        starts_well = is_carried or at in starts or (at == after and bool(found)) or (is_hid and at == 1)
        ends_well = is_carried or end in ends or (end >= padded and size in ends) or _end(data, end) is not None
        takes = starts_well and ends_well
        if not takes and budget > 0:
            budget -= end - at
            is_long = end - at >= LOOKS
            is_lone = data[at + _TYPE_AT] in _COMMANDS and 0 < at < HEADER_SIZE
            may = not starts_well and (ends_well or is_lone) and (is_long or at <= 2)
            takes = may and (not is_long or is_something(data[at:end])) and is_flawless(data[at:end])
        if takes and not any(at <= place < at + 2 or at + 4 <= place < end for place in unknown):
            found.append((at, end, starts_well and ends_well))
            at = after = end
        else:
            at += 1
    return found


def _end(data: bytes, at: int) -> int | None:
    """Returns where the frame ends that may start there, by its length and its type; None for no frame."""
    if at + HEADER_SIZE > len(data) or data[at + _TYPE_AT] not in _TYPES:
        return None
    size = frame_size(data, at)
    return at + size if at + size <= len(data) and may_have_length(data, at) else None


def may_begin(data: bytes | bytearray) -> bool:
    """Whether a frame may begin there: its length and its type are possible, as far as they are there."""
    if len(data) < LENGTH_FIELD or not may_have_length(data) or frame_size(data) > _MOST_MISSING * len(data):
        return False
    return len(data) <= _TYPE_AT or data[_TYPE_AT] in _TYPES


def reason(data: bytes, *, is_dense: bool, is_decimal: bool) -> str | None:
    """Returns why bytes that are not a frame look like one, as a sentence; None where they do not.

    Args:
        data: The bytes of a run, from a natural boundary to the next.
        is_dense: They are written without blanks, as hashes and fingerprints are.
        is_decimal: They are decimal numbers, of which prose and tables have many.
    """
    if len(data) < LOOKS or _counts_up(data):
        return None
    says, has_type = frame_size(data), data[_TYPE_AT] in _TYPES
    is_near = abs(says - len(data)) <= _NEARLY
    if is_dense and len(data) in HASHES and not (is_near and has_type):
        return None
    if _swapped(data):
        return (
            f"the length field says {says - LENGTH_FIELD}: did you swap these two bytes, {data[:2].hex(' ').upper()}?"
        )
    if says > _MOST_MISSING * len(data) or (is_decimal and not any(data[2:])):
        return None
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
    says = frame_size(data) if len(data) >= LOOKS and data[_TYPE_AT] in _TYPES else 0
    return is_frame_size(says) and -_NEARLY <= says - len(data) < LENGTH_FIELD


def _swapped(data: bytes) -> bool:
    """Whether the length field fits once its two bytes are swapped, and the rest is a frame without a flaw."""
    right = data[1::-1] + data[2:]
    return len(data) >= LOOKS and frame_size(right) == len(data) and data[_TYPE_AT] in _TYPES and is_flawless(right)


def bare_reason(data: bytes) -> str | None:
    """Returns what bytes without a header are, as a sentence, and which option reads them; None for other bytes."""
    if len(data) < HEADER_SIZE or _counts_up(data) or _swapped(data):
        return None
    end = _end(data, 0)
    if abs(frame_size(data) - len(data)) <= _NEARLY or (end is not None and not any(data[end:])):
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
    for found in (place for operation in message.operations for place in footprints(operation)):
        scope = found.argument.kind
        used[scope] = max(used[scope], found.start + (found.room or found.size))
    if not any(used.values()) or used[GLOBAL] > MAX_GLOBALS or used[LOCAL] > MAX_LOCALS:
        return plain
    return build_frame(DIRECT_COMMAND_TYPES[bool(used[GLOBAL])], 0, write_memory(used[GLOBAL], used[LOCAL]) + data)


_BARE: tuple[tuple[str, Callable[[bytes], bytes | None]], ...] = (
    ("this is a frame without its length bytes: --no-length reads it", without_length),
    ("these are operations without the header of a frame: --operations reads them", with_header),
)


def _counts_up(data: bytes) -> bool:
    """Whether the values are all the same, or count up or down, as the head of a dump does."""
    step = (data[1] - data[0]) & 0xFF
    return step in (0, 1, 255) and all((b - a) & 0xFF == step for a, b in pairwise(data))
