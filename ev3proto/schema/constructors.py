"""Public functions that build commands and replies from values. The schemas define what is allowed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from ev3proto.errors import BuildError
from ev3proto.messages import (
    DirectCommand,
    DirectReply,
    FieldValue,
    Operation,
    OperationReader,
    SystemCommand,
    SystemReply,
)
from ev3proto.schema.fields import REPLIES, REQUESTS, Fields, system_entry
from ev3proto.schema.header import COMMAND_HEADER_SIZE, build_frame, write_memory
from ev3proto.tables.frame import DIRECT_COMMAND_TYPES, SYSTEM_COMMAND_TYPES, MessageType

EMPTY_COMMAND = "a command needs at least one operation: the brick refuses an empty one"
"""The error message for an empty direct command."""


def direct_command(
    *operations: Operation,
    counter: int = 0,
    reply: bool = False,
    global_size: int = 0,
    local_size: int = 0,
) -> DirectCommand:
    """Returns a direct command.

    Args:
        operations: The operations to run, in order.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
        global_size: Bytes of global memory, 0 to 1023.
        local_size: Bytes of local memory, 0 to 63.

    Returns:
        The command. Each operation has its offset in the frame.

    Raises:
        BuildError: There is no operation, or the command does not fit into a frame.
    """
    encoded = []
    for operation in operations:
        if not isinstance(operation, Operation):
            raise BuildError(
                f"{operation!r} is not an operation: use ev3proto.operation; results of ev3proto.ops, and labels, are"
                " for ev3proto.command"
            )
        encoded.append(operation.raw)
    command = placed_in_frame(operations, encoded, counter, reply, global_size, local_size)
    if not operations:
        raise BuildError(EMPTY_COMMAND)
    return command


class Unplaced(Protocol):
    """An operation whose offset in the frame does not matter: an `Operation`, or a draft of one."""

    @property
    def schema(self) -> OperationReader:
        """Its schema."""


def placed_in_frame(
    operations: Sequence[Unplaced],
    encoded: Sequence[bytes],
    counter: int,
    reply: bool,
    global_size: int,
    local_size: int,
) -> DirectCommand:
    """Returns a direct command in which each operation has its offset.

    Args:
        operations: The operations. A brick refuses a command without any.
        encoded: The bytes of each operation.
        counter: As for `direct_command`, like the other arguments.
        reply: Whether the brick should answer.
        global_size: Bytes of global memory.
        local_size: Bytes of local memory.

    Raises:
        BuildError: The command does not fit into a frame.
    """
    kind = DIRECT_COMMAND_TYPES[bool(reply)]
    frame = build_frame(kind, counter, write_memory(global_size, local_size) + b"".join(encoded))
    end = COMMAND_HEADER_SIZE
    placed = []
    for operation, raw in zip(operations, encoded, strict=True):
        start, end = end, end + len(raw)
        placed.append(Operation((operation.schema, frame, start, end)))
    return DirectCommand(
        type=kind, counter=counter, global_size=global_size, local_size=local_size, operations=tuple(placed)
    )


def direct_reply(memory: bytes = b"", *, counter: int = 0, error: bool = False) -> DirectReply:
    """Returns the reply to a direct command.

    Args:
        memory: The global memory that the command requested, at most 1019 bytes.
        counter: The counter of the command, 0 to 65535.
        error: Whether the command failed.

    Returns:
        The reply.

    Raises:
        BuildError: It does not fit into a frame.
    """
    if not isinstance(memory, bytes):
        raise BuildError(f"memory takes bytes, not {memory!r}")
    member = MessageType.DIRECT_REPLY_ERROR if error else MessageType.DIRECT_REPLY
    message = DirectReply(type=member, counter=counter, memory=memory)
    message.build()
    return message


def _checked(schema: Fields, data: bytes, *, complete: bool) -> dict[str, FieldValue]:
    """Returns the fields as a receiver reads them."""
    values, _, fault = schema.read_leniently(data, 0, complete=complete)
    if fault is not None:
        raise BuildError(fault.reason)
    return values


def system_command(
    command: int | str, *, counter: int = 0, reply: bool = True, **fields: FieldValue | float
) -> SystemCommand:
    """Returns a system command.

    Args:
        command: Name or number. The bootloader's BEGIN_DOWNLOAD (0xF1) shares its name with another: use its number.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick should answer.
        fields: Values by field name. Omitted lengths are computed. The message of a mailbox is a text
            (its zero is added), a number, True or False, or bytes.

    Returns:
        The command.

    Raises:
        BuildError: The command is unknown or does not fit into a frame. The error names the faulty field.
    """
    entry = system_entry(command)
    schema = REQUESTS[entry.number]
    values = _checked(schema, schema.write(fields), complete=True)
    message = SystemCommand(
        type=SYSTEM_COMMAND_TYPES[bool(reply)],
        counter=counter,
        number=entry.number,
        command=entry.name,
        fields=values,
    )
    message.build()
    return message


def system_reply(
    command: int | str, *, counter: int = 0, status: int = 0, error: bool = False, **fields: FieldValue
) -> SystemReply:
    """Returns the reply to a system command.

    Args:
        command: Name or number of the command.
        counter: The counter of the command, 0 to 65535.
        status: The status byte: 0 for success.
        error: Whether the message type says that the command failed.
        fields: Values by field name. Omitted lengths are computed. After a failure any field may be omitted.

    Returns:
        The reply.

    Raises:
        BuildError: The command is unknown, or the reply does not fit into a frame. The error names the faulty field.
    """
    entry = system_entry(command)
    schema = REPLIES[entry.number]
    failed = bool(status) or error
    data = schema.write_present(schema.completed(fields)) if failed else schema.write(fields)
    values = _checked(schema, data, complete=not failed)
    message = SystemReply(
        type=MessageType.SYSTEM_REPLY_ERROR if error else MessageType.SYSTEM_REPLY,
        counter=counter,
        number=entry.number,
        command=entry.name,
        status_code=status,
        fields=values,
    )
    message.build()
    return message
