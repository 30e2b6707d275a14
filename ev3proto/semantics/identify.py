"""What bytes are that are taken for a frame: right, with a slip, another product's telegram, a text.

Every room asks here: pasted text, captures, the checker, the brick and the link. The first row of `_ROWS` that knows
the bytes decides, so the order is the whole rule. Only slips that the header or all bytes together show are named here;
`checking.nearest` searches for the others. Words are up to the rooms.
"""

from __future__ import annotations

import base64
import binascii
import re
from collections.abc import Callable, Iterator
from enum import Enum
from itertools import pairwise
from typing import NamedTuple

from ev3proto.messages import DirectCommand, Message, Operation
from ev3proto.schema.frame import FrameReader, frame_reader, is_flawless
from ev3proto.schema.header import (
    COMMAND_HEADER_SIZE,
    HEADER_SIZE,
    MEMORY_SIZE,
    TYPE_AT,
    build_frame,
    frame_end,
    frame_size,
    is_frame_size,
    read_memory,
    with_length,
    write_memory,
)
from ev3proto.semantics.footprint import memory_of
from ev3proto.semantics.mangled import mangled
from ev3proto.tables.declaration import Effect
from ev3proto.tables.frame import COMMAND_TYPES, DIRECT_COMMAND_TYPES, LENGTH_FIELD, MESSAGE_TYPES, MessageType
from ev3proto.tables.strangers import HUB, NXT, NXT_ANSWERS, NXT_REPLY, NXT_STATUS

LOOKS = 7
"""The fewest bytes that look like a frame."""

MOST_MISSING = 8
"""Maximum ratio of the bytes that the length field says to those that are there."""

_LEAST_OPERATIONS, _ASCII = 3, 0x7F
_NEARLY, _MOST_OF_REPLY, _LEAST_PROSE, _LEAST_TELEGRAM = 2, 2, 4, 5
_COMMANDS = frozenset(bytes((code,)) for code in COMMAND_TYPES)
_DIRECT = (MessageType.DIRECT_COMMAND_REPLY, MessageType.DIRECT_COMMAND_NO_REPLY)


class Kind(Enum):
    """What bytes are."""

    FRAME = "a right frame"
    SLIP = "a frame with a slip"
    DIGITS = "a frame written as characters"
    TEXT = "another text"
    NXT = "a telegram of the NXT"
    HUB = "a message of LEGO's Wireless Protocol"
    NO_LENGTH = "a frame without its length field"
    HALF_LENGTH = "a command whose length field has one byte"
    OPERATIONS = "operations without a header"
    NOTHING = "nothing known"


_OTHERS = frozenset((Kind.DIGITS, Kind.TEXT, Kind.NXT, Kind.HUB))


class Identity(NamedTuple):
    """What bytes are.

    kind   of `Kind`
    name   of the slip, as `checking.slips` has it, or `cut`; of the telegram; or the text
    frame  the frame that was meant, where it follows
    also   for a right frame: the telegram of the NXT that all of its bytes fit, too
    """

    kind: Kind
    name: str = ""
    frame: bytes | None = None
    also: str = ""

    @property
    def is_meant(self) -> bool:
        """Whether the bytes were meant as a frame of an EV3, and not as a text."""
        return self.kind in (Kind.FRAME, Kind.SLIP)


NOTHING = Identity(Kind.NOTHING)


def identify(data: bytes, *, missing: bool = True, reader: FrameReader | None = None) -> Identity:
    """Returns what bytes are.

    Args:
        data: The bytes.
        missing: Frames without their length and operations without a header count, too.
        reader: The reader of the dialect; None: of the official one.
    """
    if len(data) < _LEAST_OPERATIONS:
        return NOTHING
    reader = reader or frame_reader()
    found = (row(data, reader) for row in (_ROWS if missing else _ROWS[:-1]))
    return next((one for one in found if one is not None), NOTHING)


def foreign(data: bytes, reader: FrameReader | None = None) -> Identity:
    """Returns what bytes are instead of a frame: the text of one, another text, a telegram; or else `NOTHING`.

    It is quick for bytes that are none of these.
    """
    is_possible = is_prose(data.removesuffix(b"\0")) or _nxt(data) is not None or _hub(data) is not None
    found = identify(data, missing=False, reader=reader) if is_possible else NOTHING
    return found if found.kind in _OTHERS else NOTHING


def is_sure(frame: bytes, reader: FrameReader | None = None) -> bool:
    """Returns whether bytes are a flawless frame with more in it than zeros and ones, which any numbers may be."""
    return len(frame) >= LOOKS and len({*frame[HEADER_SIZE:]}) > 2 and is_flawless(frame, reader)


def is_prose(data: bytes) -> bool:
    """Returns whether bytes are text."""
    return data.isascii() and all(byte >= 0x20 or byte in b"\t\r\n" for byte in data)


def never_run(message: Message) -> Operation | None:
    """Returns the first operation of a command that no brick runs: bytes of something else look like that."""
    operations = message.operations if isinstance(message, DirectCommand) else ()
    return next((each for each in operations if Effect.NEVER_RUNS in each.schema.declaration.effects), None)


def _runs(frame: bytes, reader: FrameReader) -> bool:
    """Returns whether a frame is flawless, and if it is a command, whether a brick runs all of it."""
    if not is_flawless(frame, reader):
        return False
    message = reader.read_frame(frame)
    return not isinstance(message, DirectCommand) or (bool(message.operations) and never_run(message) is None)


def length_slip(data: bytes) -> str | None:
    """Returns the name of the slip in the length field of a frame, if that says nearly the size; else None."""
    says, size = frame_size(data), len(data)
    if says == size + LENGTH_FIELD:
        return "length-self"
    if says != size == frame_size(data[1::-1]):
        return "length-swapped"
    return "length" if 0 < abs(says - size) <= _NEARLY else None


def without_length(data: bytes) -> bytes | None:
    """Returns the bytes as a message that lost its length field; None where they are too few or too many."""
    if not is_frame_size(len(data) + LENGTH_FIELD) or data[TYPE_AT - LENGTH_FIELD] not in MESSAGE_TYPES:
        return None
    return with_length(data)


def with_header(data: bytes, reader: FrameReader | None = None) -> bytes | None:
    """Returns the bytes as the operations of a direct command with the memory that they use, where there is enough."""
    if not data or not is_frame_size(COMMAND_HEADER_SIZE + len(data)):
        return None
    plain = build_frame(MessageType.DIRECT_COMMAND_NO_REPLY, 0, bytes(MEMORY_SIZE) + data)
    message = (reader or frame_reader()).read_frame(plain, strict=False)
    if not isinstance(message, DirectCommand):
        return None
    used = memory_of(message.operations)
    if used.excess is not None:
        return plain
    return build_frame(DIRECT_COMMAND_TYPES[bool(used.globals)], 0, write_memory(used.globals, used.locals) + data)


# The rows


def _right(data: bytes, reader: FrameReader) -> Identity | None:
    if len(data) < HEADER_SIZE or frame_size(data) != len(data) or not is_flawless(data, reader):
        return None
    return Identity(Kind.FRAME, frame=data, also=_nxt(data) or "")


def _dull(data: bytes, _: FrameReader) -> Identity | None:
    """The values are the same, or count up or down, as in the head of a dump."""
    step = (data[1] - data[0]) & 0xFF if len(data) > 1 else 0
    is_dull = step in (0, 1, 255) and all((b - a) & 0xFF == step for a, b in pairwise(data))
    return NOTHING if is_dull else None


def _through_a_text(data: bytes, reader: FrameReader) -> Identity | None:
    found = mangled(data, reader) if len(data) >= LOOKS else None
    return None if found is None else Identity(Kind.SLIP, found.kind, found.original)


def _text(data: bytes, reader: FrameReader) -> Identity | None:
    """Letters or digits: a text, or the text of a frame."""
    body = data.removesuffix(b"\0").strip()
    if len(body) < _LEAST_PROSE or not is_prose(body):
        return None
    text = body.decode()
    for pattern, bytes_of in _WRITTEN:
        if pattern.fullmatch(text):
            try:
                frame = bytes_of(text)
            except ValueError:
                continue
            if len(frame) >= LOOKS and identify(frame, missing=False, reader=reader).is_meant:
                return Identity(Kind.DIGITS, text, frame)
    return Identity(Kind.TEXT, text) if sum(map(str.isalpha, text)) * 2 > len(text) else None


def _stranger(data: bytes, reader: FrameReader) -> Identity | None:
    nxt = _nxt(data)
    hub = _hub(data) if nxt is None else None
    if (nxt is None and hub is None) or _speaks_for_ev3(data, reader):
        return None
    return Identity(Kind.HUB, hub) if nxt is None and hub else Identity(Kind.NXT, nxt or "")


def _wrong_header(data: bytes, reader: FrameReader) -> Identity | None:
    """A frame but for its length or its type, or one that was cut."""
    if len(data) < LOOKS:
        return None
    says, kind = frame_size(data), data[TYPE_AT]
    if kind not in MESSAGE_TYPES:
        return Identity(Kind.SLIP, "type") if says == len(data) else None
    if kind not in COMMAND_TYPES:
        # Any bytes are a reply.
        is_meant = -_NEARLY <= says - len(data) <= _NEARLY or len(data) < says < _MOST_OF_REPLY * len(data)
        return Identity(Kind.SLIP, _cut_or_long(data)) if is_meant else None
    return _wrong_command(data, says, reader)


def _wrong_command(data: bytes, says: int, reader: FrameReader) -> Identity | None:
    mended, slip = with_length(data[LENGTH_FIELD:]), length_slip(data)
    if not (is_frame_size(says) and says <= MOST_MISSING * len(data)) and slip != "length-swapped":
        return None
    if is_flawless(mended, reader):
        return Identity(Kind.SLIP, slip or "length", mended)
    is_near = abs(says - len(data)) <= _NEARLY
    is_meant = is_near or _is_truncated(mended, reader) or is_flawless(data[:says], reader)
    return Identity(Kind.SLIP, _cut_or_long(data)) if is_meant else None


def _cut_or_long(data: bytes) -> str:
    return "cut" if frame_size(data) > len(data) else "length"


def _bare(data: bytes, reader: FrameReader) -> Identity | None:
    # Low numbers are often something else.
    least = _LEAST_OPERATIONS if max(data, default=0) > _ASCII else HEADER_SIZE
    if len(data) < least or frame_size(data) == len(data) or (frame_end(data) or len(data) + 1) <= len(data):
        return None
    found = ((kind, _COMPLETED[kind](data, reader)) for kind in _lacking(data))
    right = (Identity(kind, frame=frame) for kind, frame in found if frame is not None and _runs(frame, reader))
    return next(right, None)


def _lacking(data: bytes) -> Iterator[Kind]:
    """Yields what bytes may be that lack a part of a frame, the likeliest first."""
    if 0 <= data[0] - len(data[1:]) <= LENGTH_FIELD and data[TYPE_AT - 1 : TYPE_AT] in _COMMANDS:
        yield Kind.HALF_LENGTH  # it may count itself
    is_command = data[TYPE_AT - LENGTH_FIELD] in COMMAND_TYPES
    if is_command:
        yield Kind.NO_LENGTH
    begins_command = len(data) < LOOKS and data[TYPE_AT : TYPE_AT + 1] in _COMMANDS
    if not begins_command or frame_size(data) > MOST_MISSING * len(data):
        yield Kind.OPERATIONS
    if not is_command:
        yield Kind.NO_LENGTH  # any bytes are a reply


_COMPLETED: dict[Kind, Callable[[bytes, FrameReader], bytes | None]] = {
    Kind.HALF_LENGTH: lambda data, _: with_length(data[1:]),
    Kind.NO_LENGTH: lambda data, _: without_length(data),
    Kind.OPERATIONS: with_header,
}
"""The frames that bytes are with the part that they lack."""


_ROWS: tuple[Callable[[bytes, FrameReader], Identity | None], ...] = (
    *(_right, _dull, _through_a_text, _text, _stranger, _wrong_header, _bare),
)


# Texts of frames


def _of_hex(text: str) -> bytes:
    return bytes.fromhex(_AROUND_HEX.sub("", text))


def _of_decimals(text: str) -> bytes:
    return bytes([number & 0xFF for number in map(int, re.findall(r"-?\d+", text)) if -128 <= number <= 255])


def _of_base64(text: str) -> bytes:
    try:
        return base64.b64decode(text, validate=True)
    except binascii.Error as error:
        raise ValueError(text) from error


_AROUND_HEX = re.compile(r"0[xX]\|?|\\x|[\s|:,;\[\](){}]")
_WRITTEN = (
    (re.compile(r"[\[({]?(?:(?:0[xX]\|?|\\x)?(?:[0-9a-fA-F]{2})+[\s|:,;]*)+[\])}]?"), _of_hex),
    (re.compile(r"[\[({]?\s*(?:-?\d{1,3}[\s,;]+)+-?\d{1,3}\s*[\])}]?"), _of_decimals),
    (re.compile(r"[\w+/-]+={0,2}"), _of_base64),
)
"""How a frame may be written as a text: the form of the text, and the bytes in it."""


# Other products


def _hub(data: bytes) -> str | None:
    """Returns the name of a message of LEGO's Wireless Protocol; None for other bytes."""
    if len(data) < _LEAST_TELEGRAM or data[0] != len(data) or data[1] or data[2] not in HUB:
        return None
    known = HUB[data[2]]
    return known.name if re.fullmatch(known.contents, data[3:], re.DOTALL) else None


def _nxt(data: bytes) -> str | None:
    """Returns the name of a telegram of the NXT, with or without its length; None for other bytes."""
    has_length = len(data) >= 4 and frame_size(data) == len(data)
    telegram = data[LENGTH_FIELD:] if has_length else data
    if len(telegram) < (2 if has_length else _LEAST_TELEGRAM):
        return None
    kind, number, contents = telegram[0], telegram[1], telegram[2:]
    if kind == NXT_REPLY:
        answered = NXT_ANSWERS.get(number) if has_length and contents[:1] and contents[0] in NXT_STATUS else None
        return f"the reply to {answered.name}" if answered is not None and answered.reply == len(telegram) else None
    known = NXT.get(kind, {}).get(number)
    if known is None or (contents and not any(contents)):
        return None
    return known.name if re.fullmatch(known.contents, contents, re.DOTALL) else None


# Evidence


def _is_truncated(frame: bytes, reader: FrameReader) -> bool:
    """Returns whether a frame has no flaw but for bytes that are missing at its end."""
    fault = reader.read_frame(frame, strict=False).fault
    return fault is not None and fault.truncated


def _speaks_for_ev3(data: bytes, reader: FrameReader) -> bool:
    """Returns whether bytes were meant as an EV3's frame, although a part of its header is wrong or missing.

    That is so if a known type has contents that a brick can read, or an unknown one has the operations of a command
    that ask for exactly the memory that they use. A stranger's telegram has neither but by chance.
    """
    if len(data) < LOOKS:
        return False
    is_nearly = abs(frame_size(data) - len(data)) <= LENGTH_FIELD
    code, contents = data[TYPE_AT], data[HEADER_SIZE:]
    if code in COMMAND_TYPES:
        meant = with_length(data[LENGTH_FIELD:])
        is_possible = is_sure(meant, reader) or _is_truncated(meant, reader)
        is_possible = is_possible or (code in _DIRECT and _fits(code, contents, reader))
    else:
        is_possible = is_nearly and (code in MESSAGE_TYPES or any(_fits(kind, contents, reader) for kind in _DIRECT))
    # The length field is missing, or one byte of the header.
    return is_possible or any(data[at] in _DIRECT and _fits(data[at], data[at + 1 :], reader) for at in (2, 3))


def _fits(kind: int, contents: bytes, reader: FrameReader) -> bool:
    """Returns whether the contents of a direct command ask for the memory that their operations use."""
    if not is_flawless(with_length(bytes((0, 0, kind)) + contents), reader) or len(contents) <= MEMORY_SIZE:
        return False
    used = with_header(contents[MEMORY_SIZE:], reader)
    return used is not None and read_memory(used) == read_memory(contents, 0)
