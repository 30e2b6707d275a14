"""Where a stream goes on that is out of step: the next frame, found by what a frame must be like.

Five bytes of a header look right once in some thousand places of any data, so a place is believed for more than that:
all of a frame stands there without a fault, and what follows it may be the next one. Of a frame that is not whole yet
it is asked whether it can become such a one. The dissector finds frames in the same way.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection
from enum import Enum, auto

from ev3proto.errors import DecodeError
from ev3proto.messages import Argument, DaisyCommand, DaisyReply, DirectCommand, Message, SystemCommand
from ev3proto.schema.frame import FrameSchema
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, frame_size, may_have_length
from ev3proto.tables import OPCODES, system
from ev3proto.tables.claims import FIRST_TELLING, NEVER_SENT, NOT_TELLING, SYSTEM_TELLS
from ev3proto.tables.daisy import MOST_LAYERS
from ev3proto.tables.declaration import Type
from ev3proto.tables.encoding import TEXT
from ev3proto.tables.frame import LENGTH_FIELD, MAX_LENGTH, MIN_LENGTH, SYSTEM_COMMAND_TYPES, MessageType

MOST_TRIALS = 64
"""Places in one piece of a stream where a whole frame is tried, before the piece is given up."""

MOST_FOLLOWING = 2
"""Frames after one that are looked at to tell whether it is one."""

_TYPES = {int(member): member for member in MessageType}
# Where a header may stand: most places that are none are passed over at ten times the speed.
_STARTS = re.compile(
    b"(?=(?:[%b-\\xff]\\0|.[\\1-%b])..[%b]|.[%b-\\xff]..[%b][%b])"
    % (
        re.escape(bytes((MIN_LENGTH,))),
        re.escape(bytes((MAX_LENGTH >> 8,))),
        re.escape(bytes(sorted(_TYPES))),
        re.escape(bytes((MAX_LENGTH >> 8,))),
        re.escape(bytes(SYSTEM_COMMAND_TYPES.values())),
        re.escape(bytes(sorted(system.LONG_COMMANDS))),
    ),
    re.DOTALL,
)
_FIRST_TELLING = next(opcode.number for opcode in OPCODES if opcode.name == FIRST_TELLING)
_NEVER_SENT = frozenset(opcode.number for opcode in OPCODES if opcode.name in NEVER_SENT)
_NOT_TELLING = frozenset(opcode.number for opcode in OPCODES if opcode.name in NOT_TELLING)


def makes_sense(message: Message) -> bool:
    """Says whether somebody would send a frame without a fault.

    Args:
        message: A message without a fault.

    Returns:
        False for commands without operations, or with one that nobody sends, and for layers that no chain has.

    """
    if isinstance(message, DaisyCommand | DaisyReply):
        return message.layer_from <= MOST_LAYERS and message.layer_to <= MOST_LAYERS
    if isinstance(message, DirectCommand):
        opcodes = [operation.opcode for operation in message.operations]
        return bool(opcodes) and _NEVER_SENT.isdisjoint(opcodes)
    return True


def count_telling(message: Message) -> int:
    """Says how much a frame without a fault tells that others' bytes hardly ever do.

    Args:
        message: A message without a fault.

    Returns:
        How many of its operations tell it. 0 for replies, and where anything stands in a place that is not its own.

    """
    if isinstance(message, SystemCommand):
        return SYSTEM_TELLS
    if not isinstance(message, DirectCommand) or not makes_sense(message):
        return 0
    arguments = (argument for operation in message.operations for argument in operation.arguments)
    if any(map(_is_misplaced, arguments)):
        return 0
    opcodes = [operation.opcode for operation in message.operations]
    return sum(opcode >= _FIRST_TELLING and opcode not in _NOT_TELLING for opcode in opcodes)


def _is_misplaced(argument: Argument) -> bool:
    if argument.is_variable:
        return False
    parameter = argument.parameter
    is_text = Type.STRING in (parameter.type, parameter.element)
    return parameter.is_output or (argument.form.kind == TEXT) != is_text


_POLLS = re.compile(b"(?:%b)*" % re.escape(bytes(LENGTH_FIELD)))


def polls_end(buffer: bytes, at: int) -> int:
    """Returns the offset after the polls at an offset: length fields of 0, which the brick passes over."""
    found = _POLLS.match(buffer, at)
    assert found is not None
    return found.end()


class Found(Enum):
    """What stands at the place where a stream may go on.

    NOTHING  no place was found
    OPEN     a frame that is not whole yet, and without a fault so far
    SINGLE   a whole one, after which nothing tells whether it is one
    CHAIN    one, and the next one begins after it
    """

    NOTHING = auto()
    OPEN = auto()
    SINGLE = auto()
    CHAIN = auto()


class Finder:
    """Finds frames in the bytes of a stream.

    schema  reads frames
    """

    __slots__ = ("_schema",)

    def __init__(self, schema: FrameSchema) -> None:
        self._schema = schema

    def may_start(self, buffer: bytes, at: int) -> bool:
        """Whether a frame may start here, as far as its header is there."""
        left = len(buffer) - at
        if left < LENGTH_FIELD:
            return True
        return may_have_length(buffer, at) and (left < HEADER_SIZE or buffer[at + HEADER_SIZE - 1] in _TYPES)

    def stands(self, buffer: bytes, at: int, end: int) -> bool:
        """Whether a frame without a fault stands here, which somebody would send."""
        if end - at < HEADER_SIZE or buffer[at + HEADER_SIZE - 1] not in _TYPES:
            return False
        try:
            message = self._schema.read_frame(buffer[at:end])
        except DecodeError:
            return False
        code = buffer[at + HEADER_SIZE - 1]
        if _TYPES[code].carries == "system" or (not _TYPES[code].is_command and _TYPES[code].carries == "direct"):
            return True
        return makes_sense(message)

    def is_self_evident(self, buffer: bytes, at: int) -> bool:
        """Whether a frame without a fault is one whatever follows it, as few bytes are operations by chance."""
        member = _TYPES.get(buffer[at + HEADER_SIZE - 1])
        return member is not None and member.is_command and member.carries == "direct"

    def may_become(self, buffer: bytes, at: int) -> bool:
        """Whether the frame of which only the start is here may be without a fault."""
        if not self.may_start(buffer, at):
            return False
        size = len(buffer)
        if size - at <= HEADER_SIZE:
            return True
        member = _TYPES[buffer[at + HEADER_SIZE - 1]]
        if member.carries == "system":
            return buffer[at + HEADER_SIZE] in system.SYSTEM_BY_NUMBER
        if member.carries == "direct" and member.is_command and size - at > COMMAND_HEADER_SIZE:
            _, fault = self._schema.instructions.scan(buffer, at + COMMAND_HEADER_SIZE, size)
            return fault is None or fault.truncated
        return True

    def follow(self, buffer: bytes, at: int) -> int | None:
        """How many frames begin here, one after the other, of those whose headers are here; None where none can.

        Few are enough to tell. The next gap in the stream may come soon.
        """
        size, count = len(buffer), 0
        while at < size and count < MOST_FOLLOWING:
            at = polls_end(buffer, at)
            if not self.may_start(buffer, at):
                return None
            if size - at < HEADER_SIZE:
                break
            count += 1
            at += frame_size(buffer, at)
        return count

    def first_place(self, buffer: bytes, at: int, accepts: Callable[[MessageType], bool]) -> int | None:
        """The first place from an offset on where a frame stands that goes this way, and the next one may follow."""
        for trials, hit in enumerate(_STARTS.finditer(buffer, at)):
            if trials >= MOST_TRIALS:
                break
            place = hit.start()
            end = place + frame_size(buffer, place)
            if end > len(buffer) or not accepts(_TYPES[buffer[place + HEADER_SIZE - 1]]):
                continue
            if (end == len(buffer) or self.may_start(buffer, end)) and self.stands(buffer, place, end):
                return place
        return None

    def next_step(self, buffer: bytes, at: int, begins: Collection[int], least: int = 0) -> tuple[Found, int]:
        """The place from an offset on where the stream goes on, and what stands there.

        Args:
            buffer: Bytes of the stream.
            at: The first offset that may be the place.
            begins: Offsets where packets begin: there a frame may have faults, or nothing that can follow it.
            least: Frames that must begin after a whole one.

        Returns:
            What is there, and the offset, which is where the bytes end for `NOTHING`.

        """
        size, trials = len(buffer), MOST_TRIALS
        opened = single = begun = None
        for hit in _STARTS.finditer(buffer, at):
            place = hit.start()
            if not may_have_length(buffer, place):
                continue
            end = place + frame_size(buffer, place)
            trials -= 1
            if trials <= 0:
                break
            if end > size:
                if opened is None and self.may_become(buffer, place):
                    opened = place
                continue
            following = self.follow(buffer, end) if end < size else 0
            is_begin = place in begins
            if (following is None and not is_begin) or (following or 0) < least:
                continue
            stands = self.stands(buffer, place, end)
            if stands and following:
                return Found.CHAIN, place
            if stands and following is not None:
                single = place if single is None else single
            elif is_begin and (stands or following is not None):
                begun = place if begun is None else begun
        if single is not None:
            return Found.SINGLE, single
        if begun is not None:
            return Found.SINGLE, begun
        if opened is not None:
            return Found.OPEN, opened
        return Found.NOTHING, size
