"""Claims of conversations, packet by packet; the rule is in `tables.claims`."""

from __future__ import annotations

from ev3proto.capture.record import Record
from ev3proto.messages import (
    Argument,
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    DirectReply,
    Message,
    SystemCommand,
    SystemReply,
)
from ev3proto.schema.frame import FrameReader, frame_reader
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE
from ev3proto.semantics.domain import domain_of
from ev3proto.tables import OPCODES
from ev3proto.tables.claims import (
    FIRST_OF_DEVICES,
    NEVER_SENT,
    NOT_TELLING,
    NXT_MASK,
    NXT_WRITE,
    ONLY_IN_PROGRAMS,
    STRANGE_PACKETS,
)
from ev3proto.tables.daisy import MOST_LAYERS
from ev3proto.tables.declaration import DIALECTS, Type
from ev3proto.tables.encoding import GLOBAL, TEXT
from ev3proto.tables.frame import MAX_FRAME

_NUMBERS = {opcode.name: opcode.number for opcode in OPCODES}
_NEVER_SENT, _FIRST_OF_DEVICES = _NUMBERS[NEVER_SENT], _NUMBERS[FIRST_OF_DEVICES]
_NOT_TELLING, _ONLY_IN_PROGRAMS = (
    frozenset(_NUMBERS[name] for name in names) for names in (NOT_TELLING, ONLY_IN_PROGRAMS)
)


def is_plausible(message: Message, schema: FrameReader, *, is_cut: bool = False) -> bool:
    """Returns whether a message is a command that a program would send to a brick, not one by chance.

    Args:
        message: The message.
        schema: Reads frames. Direct commands are also tried with the instructions of other firmware.
        is_cut: The capture has only its beginning: of a direct command the remaining part counts.
    """
    if isinstance(message, SystemCommand):
        return message.fault is None and message.counter & NXT_MASK != NXT_WRITE
    if isinstance(message, DaisyCommand):
        return is_sensible(message)
    if not isinstance(message, DirectCommand):
        return False
    if _fits(message, is_cut=is_cut):
        return True
    others = (each for each in map(frame_reader, DIALECTS) if each is not schema)
    readings = (each.read_frame(message.build(), strict=False) for each in others)
    return any(isinstance(reading, DirectCommand) and _fits(reading, is_cut=is_cut) for reading in readings)


def is_sensible(message: Message) -> bool:
    """Returns whether a message is valid and has operations; in a daisy chain, whether its layers exist."""
    if isinstance(message, DirectCommand):
        opcodes = [operation.opcode for operation in message.operations]
        return message.fault is None and bool(opcodes) and _NEVER_SENT not in opcodes
    if isinstance(message, DaisyCommand | DaisyReply):
        return message.fault is None and max(message.layer_from, message.layer_to) <= MOST_LAYERS
    return message.fault is None


def is_complete_reply(message: Message) -> bool:
    """Returns whether a message is a valid, non-empty reply of a brick to a computer."""
    if isinstance(message, DirectReply):
        return message.fault is None and bool(message.memory) and not message.is_error
    return isinstance(message, SystemReply) and message.fault is None


def _fits(command: DirectCommand, *, is_cut: bool) -> bool:
    """Returns whether each argument has a kind and range that its parameter accepts."""
    sizes = command.local_size, command.global_size
    is_read = command.fault is None or (is_cut and command.fault.truncated)
    is_telling = any(operation.opcode not in _NOT_TELLING for operation in command.operations)
    return (
        is_read
        and is_telling
        and all(
            operation.opcode != _NEVER_SENT
            and operation.opcode not in _ONLY_IN_PROGRAMS
            and (command.fault is None or operation.opcode >= _FIRST_OF_DEVICES)
            and all(_is_in_place(argument, *sizes) for argument in operation.arguments)
            for operation in command.operations
        )
    )


def _is_in_place(argument: Argument, local_size: int, global_size: int) -> bool:
    value, parameter = argument.value, argument.parameter
    if argument.is_variable:
        assert isinstance(value, int)
        return value < (global_size if argument.form.kind == GLOBAL else local_size)
    if parameter.is_output:
        return False
    is_text = argument.form.kind == TEXT
    if is_text or isinstance(value, str) or Type.STRING in (parameter.type, parameter.element):
        return is_text and Type.STRING in (parameter.type, parameter.element)
    domain = domain_of(parameter)
    return domain is None or domain.covers(value)


def answers(record: Record) -> bool:
    """Returns whether a reply has the counter and the length that a command requested."""
    if record.request is None or record.message.fault is not None:
        return False
    reply, asked = record.message, record.request
    if isinstance(reply, DirectReply):
        size = 0 if reply.is_error or not isinstance(asked.message, DirectCommand) else asked.message.global_size
        return len(asked.frame) >= COMMAND_HEADER_SIZE and len(record.frame) == HEADER_SIZE + size
    return isinstance(reply, SystemReply)


class Claim:
    """The claim of one conversation.

    Attributes:
        is_claimed: It is claimed.
        is_sure: It stays claimed, by a text or the user's choice.
        is_answered: A reply matched its command: faulty frames keep the claim, too.

    """

    __slots__ = ("_strange", "_unread", "is_answered", "is_claimed", "is_sure")

    def __init__(self, *, is_sure: bool = False) -> None:
        self.is_claimed = False
        self.begin(is_sure=is_sure)
        self.is_claimed = is_sure

    def begin(self, *, is_sure: bool = False) -> None:
        """Claims the conversation from now on."""
        self.is_claimed, self.is_sure, self.is_answered = True, is_sure, False
        self._strange = self._unread = 0

    def is_ours(self, record: Record) -> bool:
        """Returns whether a frame keeps the claim: a sensible one, or any once a reply matched its command."""
        self.is_answered = self.is_answered or answers(record)
        return self.is_answered or is_sensible(record.message)

    def count(self, *, is_good: bool, unread: int = 0) -> None:
        """Counts a packet of a claimed conversation, which may end the claim.

        Args:
            is_good: It has, or completes, a frame that keeps the claim.
            unread: Bytes in it that are in no frame.

        """
        if is_good:
            self._strange = self._unread = 0
            return
        self._strange += 1
        self._unread += unread
        # In a dialogue, the rest of a frame may come in many packets.
        is_over = self._strange >= STRANGE_PACKETS and (not self.is_answered or self._unread > MAX_FRAME)
        if is_over and not self.is_sure:
            self.is_claimed = self.is_answered = False
