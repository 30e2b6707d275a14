"""Evidence that bytes are messages of this protocol; the rule is in `tables.claims`."""

from __future__ import annotations

from ev3proto.messages import (
    Argument,
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    DirectReply,
    Message,
    SystemCommand,
    SystemReply,
    own_fault,
)
from ev3proto.schema.frame import FrameReader, frame_reader
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, read_memory, unpack_header
from ev3proto.semantics.facts import ParameterFacts, operation_facts
from ev3proto.semantics.judgement import Wrong, judged
from ev3proto.tables import OPCODES
from ev3proto.tables.claims import NEVER_SENT, NOT_TELLING, NXT_MASK, NXT_WRITE, ONLY_IN_PROGRAMS, STILL_SENT
from ev3proto.tables.daisy import MOST_LAYERS
from ev3proto.tables.declaration import DIALECTS, Role
from ev3proto.tables.encoding import GLOBAL
from ev3proto.tables.frame import LENGTH_FIELD, MESSAGE_TYPES

_NUMBERS = {opcode.name: opcode.number for opcode in OPCODES}
_NOT_TELLING = frozenset(_NUMBERS[name] for name in NOT_TELLING)
_STILL_SENT = frozenset(Wrong[name] for name in STILL_SENT)
_NOT_SENT = frozenset(_NUMBERS[name] for name in (NEVER_SENT, *ONLY_IN_PROGRAMS))


def is_plausible(message: Message, schema: FrameReader, *, is_cut: bool = False) -> bool:
    """Returns whether a message is a command that a program would send to a brick, not one by chance.

    Direct commands are also tried with the instructions of other firmware; of a cut one the remaining part counts.
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
        return message.fault is None and bool(opcodes) and _NUMBERS[NEVER_SENT] not in opcodes
    if isinstance(message, DaisyCommand | DaisyReply):
        return message.fault is None and max(message.layer_from, message.layer_to) <= MOST_LAYERS
    return message.fault is None


def is_complete_reply(message: Message) -> bool:
    """Returns whether a message is a valid, non-empty reply of a brick to a computer."""
    if isinstance(message, DirectReply):
        return message.fault is None and bool(message.memory) and not message.is_error
    return isinstance(message, SystemReply) and message.fault is None


def _fits(command: DirectCommand, *, is_cut: bool) -> bool:
    """Returns whether operations are read to their end, and each argument is one that its parameter accepts."""
    opcodes = {operation.opcode for operation in command.operations}
    return (
        own_fault(command, is_cut) is None
        and not opcodes <= _NOT_TELLING
        and not opcodes & _NOT_SENT
        and all(
            _is_in_place(facts.of(number, argument.parameter), argument, command.local_size, command.global_size)
            for operation in command.operations
            for facts in (operation_facts(operation.schema),)
            for number, argument in enumerate(operation.arguments)
        )
    )


def _is_in_place(known: ParameterFacts, argument: Argument, local_size: int, global_size: int) -> bool:
    value, parameter = argument.value, argument.parameter
    if argument.is_variable:
        assert isinstance(value, int)
        return value < (global_size if argument.form.kind == GLOBAL else local_size)
    if parameter.role is Role.MOTORS and not value:
        return False
    wrong = judged(known, argument)
    return wrong is None or wrong.wrong in _STILL_SENT


def proves(reply: bytes, command: bytes) -> bool:
    """Returns whether a frame is the reply to a command, which shows that both are of this protocol.

    It is of the command's kind and has its counter. A direct reply has the length that the command requested, or is an
    error; a system reply has the command's number, known or not, but not 0.
    """
    if len(reply) < HEADER_SIZE or len(command) <= HEADER_SIZE:
        return False
    (size, counter, code), (_, wanted, asked) = unpack_header(reply), unpack_header(command)
    answer, request = MESSAGE_TYPES.get(code), MESSAGE_TYPES.get(asked)
    if answer is None or request is None or answer.is_command or not request.wants_reply:
        return False
    if (answer.carries, counter) != (request.carries, wanted):
        return False
    if answer.carries == "system":
        return reply[HEADER_SIZE : HEADER_SIZE + 1] == command[HEADER_SIZE : HEADER_SIZE + 1] != b"\0"
    memory = size + LENGTH_FIELD - HEADER_SIZE
    return answer.carries == "direct" and _has_requested(memory, command, is_error=answer.is_error)


def _has_requested(memory: int, command: bytes, *, is_error: bool) -> bool:
    """Returns whether a reply with a number of bytes of memory is one to a direct command that is not zeros."""
    operations = command[COMMAND_HEADER_SIZE:]
    if operations and not any(operations):
        return False
    is_requested = len(command) >= COMMAND_HEADER_SIZE and memory == read_memory(command)[0]
    return is_requested or (is_error and not memory)
