"""The header of every frame, and the memory request of a direct command right after it.

The whole project reads and writes headers by these functions: `Header.read` parses one, `frame_size` returns the
length of a frame, `build_frame` builds a frame.
"""

from __future__ import annotations

import re
import struct
from typing import NamedTuple

from ev3proto.errors import BuildError
from ev3proto.tables.frame import (
    COUNTERS,
    GLOBAL_BITS,
    LENGTH_FIELD,
    MAX_FRAME,
    MAX_GLOBALS,
    MAX_LENGTH,
    MAX_LOCALS,
    MAX_LONG_FRAME,
    MESSAGE_TYPES,
    MIN_LENGTH,
    SYSTEM_COMMAND_TYPES,
)
from ev3proto.tables.system import LONG_COMMANDS

_header = struct.Struct("<HHB")
_memory = struct.Struct("<H")
_length = struct.Struct("<H")

HEADER_SIZE = _header.size
MEMORY_SIZE = _memory.size
TYPE_AT = HEADER_SIZE - 1
COMMAND_HEADER_SIZE = HEADER_SIZE + MEMORY_SIZE
"""Offset of the first operation of a direct command."""

MOST_IN_REPLY = MAX_FRAME - HEADER_SIZE
"""Bytes of global memory that fit into a reply."""

unpack_header = _header.unpack_from
"""Length field, counter and type number of the header in `(data, offset)`. Needs `HEADER_SIZE` bytes."""

_SYSTEM_COMMANDS = frozenset(map(int, SYSTEM_COMMAND_TYPES.values()))


class Header(NamedTuple):
    """The header of a frame.

    Attributes:
        length: The length field: number of bytes that follow it.
        counter: The message counter, 0 to 65535.
        type: The number of the message type, 0 to 255.
    """

    length: int
    counter: int
    type: int

    @classmethod
    def read(cls, data: bytes | bytearray, at: int = 0) -> Header:
        """Reads the header at an offset, unchecked; it has to be there."""
        return cls(*unpack_header(data, at))


def frame_size(data: bytes | bytearray, at: int = 0) -> int:
    """Returns the length of the frame at an offset, by its length field.

    Args:
        data: At least the two bytes of the length field from the offset on.
        at: The offset of the length field.

    Returns:
        Bytes of the whole frame, including its length field: 2 to 65537. `is_frame_size` says whether that is possible.
    """
    length: int = _length.unpack_from(data, at)[0]
    return length + LENGTH_FIELD


def impossible_length(length: int) -> str:
    """Returns why no frame can have this length field, as a sentence."""
    return f"no frame can start here: the length field says {length}, but it can be {MIN_LENGTH} to {MAX_LENGTH}"


def out_of_step(data: bytes | bytearray, at: int = 0) -> str | None:
    """Returns why no frame starts at an offset, as a sentence; None if one may, or more bytes are needed to decide."""
    if may_have_length(data, at):
        return None
    size = frame_size(data, at)
    if _TEXT.fullmatch(data, at, at + _SHOWN):
        return f"length {size - LENGTH_FIELD}: text where a frame should be"
    return impossible_length(size - LENGTH_FIELD)


_SHOWN = 8
_TEXT = re.compile(rb"[\x20-\x7E\t\r\n]+")
"""Bytes of typed text: sending text instead of frames is the most common mistake of new libraries."""


def is_frame_size(size: int) -> bool:
    """Returns whether a frame can have this length, including its length field. `may_be_long` has the exceptions."""
    return MIN_LENGTH <= size - LENGTH_FIELD <= MAX_LENGTH


def may_have_length(data: bytes | bytearray, at: int = 0) -> bool:
    """Returns whether the length field at an offset can be a frame's; True if more bytes are needed to decide."""
    size = frame_size(data, at)
    return is_frame_size(size) or (size > MAX_FRAME and may_be_long(data, at) is not False)


def may_start(data: bytes | bytearray, at: int = 0) -> bool:
    """Returns whether a message of a known type may start at an offset, as far as its header is there."""
    left = len(data) - at
    if left < LENGTH_FIELD:
        return True
    return may_have_length(data, at) and (left < HEADER_SIZE or data[at + HEADER_SIZE - 1] in MESSAGE_TYPES)


def frame_end(data: bytes | bytearray, at: int = 0) -> int | None:
    """Returns the offset after the frame with the header at an offset; None without a whole header of a known type.

    The frame may end after the data.
    """
    return at + frame_size(data, at) if len(data) - at >= HEADER_SIZE and may_start(data, at) else None


def may_be_long(data: bytes | bytearray, at: int = 0) -> bool | None:
    """Returns whether a frame may have more than `MAX_FRAME` bytes, as downloads may; None if that is not known yet."""
    code = data[at + HEADER_SIZE - 1 : at + HEADER_SIZE]
    number = data[at + HEADER_SIZE : at + HEADER_SIZE + 1]
    if not code or (code[0] in _SYSTEM_COMMANDS and not number):
        return None
    return _is_long(code[0], number)


def _is_long(code: int, number: bytes | bytearray) -> bool:
    return code in _SYSTEM_COMMANDS and bool(number) and number[0] in LONG_COMMANDS


def read_memory(data: bytes | bytearray, at: int = HEADER_SIZE) -> tuple[int, int]:
    """Reads the memory request of a direct command: bytes of global (0 to 1023) and local memory (0 to 63)."""
    number: int = _memory.unpack_from(data, at)[0]
    return number & MAX_GLOBALS, number >> GLOBAL_BITS


def write_memory(global_size: int, local_size: int) -> bytes:
    """Returns the bytes of a memory request.

    Args:
        global_size: Bytes of global memory, 0 to 1023.
        local_size: Bytes of local memory, 0 to 63.

    Returns:
        The two bytes.

    Raises:
        BuildError: A size is out of range.
    """
    if not isinstance(global_size, int) or not 0 <= global_size <= MAX_GLOBALS:
        raise BuildError(f"global_size cannot be {global_size!r}: a header can request 0 to {MAX_GLOBALS} bytes")
    if not isinstance(local_size, int) or not 0 <= local_size <= MAX_LOCALS:
        raise BuildError(f"local_size cannot be {local_size!r}: a header can request 0 to {MAX_LOCALS} bytes")
    return _memory.pack(local_size << GLOBAL_BITS | global_size)


def with_length(contents: bytes) -> bytes:
    """Returns a frame from all that follows its length field, which counts at most 65535 bytes."""
    return _length.pack(len(contents) & 0xFFFF) + contents


def build_frame(code: int, counter: int, body: bytes, length: int | None = None) -> bytes:
    """Builds a frame. All frames of the package are built here.

    Args:
        code: The number of the message type, 0 to 255.
        counter: The message counter, 0 to 65535.
        body: The bytes after the header.
        length: A length field that differs from the real length, 0 to 65535. None: computed.

    Returns:
        The frame.

    Raises:
        BuildError: The frame would be longer than the brick accepts, or the counter is out of range.
    """
    if length is None:
        size = HEADER_SIZE + len(body)
        length = size - LENGTH_FIELD
        if size > MAX_FRAME:
            most = MAX_LONG_FRAME if _is_long(code, body[:1]) else MAX_FRAME
            if size > most:
                raise BuildError(f"the frame would have {size} bytes; the brick accepts at most {most} in one frame")
    try:
        return _header.pack(length, counter, code) + body
    except struct.error:
        raise BuildError(f"counter cannot be {counter!r}: it is a whole number from 0 to {COUNTERS - 1}") from None
