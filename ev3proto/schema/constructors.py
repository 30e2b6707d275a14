"""Messages from values: what people call to make a command or a reply. The schemas say what is allowed."""

from __future__ import annotations

from collections.abc import Sequence

from ev3proto.errors import BuildError
from ev3proto.messages import DirectCommand, DirectReply, FieldValue, Operation, SystemCommand, SystemReply
from ev3proto.schema.fields import REPLIES, REQUESTS, Fields, system_entry
from ev3proto.schema.header import COMMAND_HEADER_SIZE, build_frame, write_memory
from ev3proto.tables.frame import DIRECT_COMMAND_TYPES, SYSTEM_COMMAND_TYPES, MessageType

EMPTY_COMMAND = "a command needs an operation: the brick refuses an empty one"
"""What is said to who makes a direct command of nothing."""


def direct_command(
    *operations: Operation,
    counter: int = 0,
    reply: bool = False,
    global_size: int = 0,
    local_size: int = 0,
) -> DirectCommand:
    """Makes a direct command.

    Args:
        operations: What is to be run, in this order.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick is to answer.
        global_size: Bytes of global memory, 0 to 1023.
        local_size: Bytes of local memory, 0 to 63.

    Returns:
        The command. Each operation has the offset that it has in the frame.

    Raises:
        BuildError: There is no operation, or no frame can carry the command.
    """
    made = any_direct_command(operations, counter, reply, global_size, local_size)
    if not operations:
        raise BuildError(EMPTY_COMMAND)
    return made


def any_direct_command(
    operations: Sequence[Operation], counter: int, reply: bool, global_size: int, local_size: int
) -> DirectCommand:
    """Makes a direct command, an empty one too, which no brick runs but anybody may send. As `direct_command`."""
    for operation in operations:
        if not isinstance(operation, Operation):
            raise BuildError(
                f"{operation!r} is no operation: ev3proto.operation makes one; what ev3proto.ops makes, and labels, are"
                " for ev3proto.command"
            )
    kind = DIRECT_COMMAND_TYPES[bool(reply)]
    code = b"".join([operation.raw for operation in operations])
    frame = build_frame(kind, counter, write_memory(global_size, local_size) + code)
    at = COMMAND_HEADER_SIZE
    placed = []
    for operation in operations:
        placed.append(operation.placed(frame, at))
        at += operation.length
    return DirectCommand(
        type=kind, counter=counter, global_size=global_size, local_size=local_size, operations=tuple(placed)
    )


def direct_reply(memory: bytes = b"", *, counter: int = 0, error: bool = False) -> DirectReply:
    """Makes the reply to a direct command.

    Args:
        memory: The global memory that the command asked for, at most 1019 bytes.
        counter: The counter of the command, 0 to 65535.
        error: Whether the command failed.

    Returns:
        The reply.

    Raises:
        BuildError: No frame can carry it.
    """
    if not isinstance(memory, bytes):
        raise BuildError(f"memory takes bytes, not {memory!r}")
    member = MessageType.DIRECT_REPLY_ERROR if error else MessageType.DIRECT_REPLY
    message = DirectReply(type=member, counter=counter, memory=memory)
    message.build()
    return message


def _checked(schema: Fields, data: bytes, *, complete: bool) -> dict[str, FieldValue]:
    """The fields as a receiver reads them. Raises BuildError where they contradict each other."""
    values, _, fault = schema.read_leniently(data, 0, complete=complete)
    if fault is not None:
        raise BuildError(fault.reason)
    return values


def system_command(
    command: int | str, *, counter: int = 0, reply: bool = True, **fields: FieldValue | float
) -> SystemCommand:
    """Makes a system command.

    Args:
        command: Name or number. BEGIN_DOWNLOAD of the bootloader, 0xF1, has the name of another one: use its number.
        counter: The message counter, 0 to 65535.
        reply: Whether the brick is to answer.
        fields: Values by the field's name. Lengths that are omitted are worked out. The message of a mailbox is a text
            (its zero is added), a number, True or False, or bytes.

    Returns:
        The command.

    Raises:
        BuildError: There is no such command, or no frame can carry it. The error names the field at fault.
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
    """Makes the reply to a system command.

    Args:
        command: Name or number of the command.
        counter: The counter of the command, 0 to 65535.
        status: The status byte: 0 for success.
        error: Whether the message type says that the command failed.
        fields: Values by the field's name. Lengths that are omitted are worked out. After a failure any may be omitted.

    Returns:
        The reply.

    Raises:
        BuildError: There is no such command, or no frame can carry the reply. The error names the field at fault.
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
