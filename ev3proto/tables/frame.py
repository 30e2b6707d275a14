"""The frame around everything: message types, the bits of a direct command's header, and the size limits."""

from enum import IntEnum
from functools import cached_property

MAX_FRAME = 1024
"""Bytes of the largest frame, its length field included: the firmware's buffers, one USB report."""

REPORT_SIZES = (64, MAX_FRAME)
"""Bytes of a USB report between bricks of a daisy chain and to a computer; the bytes after the frame are padding."""

LENGTH_FIELD = 2
"""Bytes of the length field, which counts what follows it."""

COUNTER_SIZE = 2
"""Bytes of the message counter, which follows the length field."""

MIN_LENGTH = 3
"""Smallest length field a frame can have: message counter and type."""

MAX_LONG_FRAME = LENGTH_FIELD + 0xFFFF
"""Bytes of the longest frame that the length field can count, for the few system commands that may exceed MAX_FRAME."""

MAX_LENGTH = MAX_FRAME - LENGTH_FIELD
"""Largest length field a frame can have."""

COUNTERS = 1 << 16
"""Message counters are unsigned 16-bit numbers and start again at 0."""

GLOBAL_BITS = 10
MAX_GLOBALS = (1 << GLOBAL_BITS) - 1
"""Maximum global memory that a header can request, in bytes (the firmware grants 1021, a reply carries 1019)."""

GRANTED_GLOBALS = 1021
"""Maximum global memory that the firmware grants, in bytes; it refuses a command that requests more."""

LOCAL_BITS = 6
MAX_LOCALS = (1 << LOCAL_BITS) - 1
"""Maximum local memory that a header can request, in bytes."""


class MessageType(IntEnum):
    """The byte after the message counter."""

    DIRECT_COMMAND_REPLY = 0x00
    DIRECT_COMMAND_NO_REPLY = 0x80
    SYSTEM_COMMAND_REPLY = 0x01
    SYSTEM_COMMAND_NO_REPLY = 0x81
    DIRECT_REPLY = 0x02
    DIRECT_REPLY_ERROR = 0x04
    SYSTEM_REPLY = 0x03
    SYSTEM_REPLY_ERROR = 0x05
    DAISY_COMMAND_REPLY = 0x0A
    DAISY_COMMAND_NO_REPLY = 0x8A
    DAISY_REPLY = 0x08
    DAISY_REPLY_ERROR = 0x09

    # Cached, since every message needs them and looking up a member's name is slower than its number.

    @cached_property
    def carries(self) -> str:
        """The layer that the message belongs to: `direct`, `system` or `daisy`."""
        return self.name.split("_", 1)[0].lower()

    @cached_property
    def is_command(self) -> bool:
        """Whether it goes from host to brick; False for a reply."""
        return "_COMMAND_" in self.name

    @cached_property
    def kind(self) -> str:
        """`direct-command`, `direct-reply`, `system-command`, ..."""
        return f"{self.carries}-{'command' if self.is_command else 'reply'}"

    @cached_property
    def wants_reply(self) -> bool:
        """Whether the brick answers the command."""
        return self.name.endswith("_COMMAND_REPLY")

    @property
    def is_error(self) -> bool:
        """Whether a reply says that the command failed."""
        return self.name.endswith("_ERROR")


MESSAGE_TYPES = {member.value: member for member in MessageType}
"""The types by their numbers."""

COMMAND_TYPES = frozenset(number for number, member in MESSAGE_TYPES.items() if member.is_command)
REPLY_TYPES = frozenset(MESSAGE_TYPES) - COMMAND_TYPES
ASKING_TYPES = frozenset(number for number, member in MESSAGE_TYPES.items() if member.wants_reply)
"""The numbers of commands, of replies, and of commands that want a reply."""

TYPES_BY_KIND = {
    kind: tuple(member for member in MessageType if member.kind == kind)
    for kind in dict.fromkeys(member.kind for member in MessageType)
}
"""The types of each kind: `direct-command`, `direct-reply`, ..."""

DIRECT_COMMAND_TYPES = {True: MessageType.DIRECT_COMMAND_REPLY, False: MessageType.DIRECT_COMMAND_NO_REPLY}
"""The type of a direct command, by whether it wants a reply."""

SYSTEM_COMMAND_TYPES = {True: MessageType.SYSTEM_COMMAND_REPLY, False: MessageType.SYSTEM_COMMAND_NO_REPLY}
"""The type of a system command, by whether it wants a reply."""

TYPE_MEANINGS = {
    MessageType.DIRECT_COMMAND_REPLY: "Byte code for the virtual machine, to be answered",
    MessageType.DIRECT_COMMAND_NO_REPLY: "Byte code for the virtual machine, not to be answered",
    MessageType.SYSTEM_COMMAND_REPLY: "A system command, to be answered",
    MessageType.SYSTEM_COMMAND_NO_REPLY: "A system command, not to be answered",
    MessageType.DIRECT_REPLY: "The answer to a direct command: its global memory",
    MessageType.DIRECT_REPLY_ERROR: "A direct command was refused, or an operation failed; the brick gives no reason",
    MessageType.SYSTEM_REPLY: "The answer to a system command: number, status, fields",
    MessageType.SYSTEM_REPLY_ERROR: "A system command failed; its status says why",
    MessageType.DAISY_COMMAND_REPLY: "A command for another brick of the chain, to be answered",
    MessageType.DAISY_COMMAND_NO_REPLY: "A command for another brick of the chain, not to be answered",
    MessageType.DAISY_REPLY: "The answer of another brick of the chain",
    MessageType.DAISY_REPLY_ERROR: "Another brick of the chain refused a command",
}
"""A description of each type of message."""

TYPE_ADVICE = {
    MessageType.DIRECT_REPLY_ERROR: (
        "`ev3proto check FRAME` says which byte of the command the brick refuses; where it finds no error, an operation"
        " failed while it was executed: an empty port, a missing file, a wrong handle"
    ),
    MessageType.SYSTEM_REPLY_ERROR: "`ev3proto help` explains the status: `ev3proto help UNKNOWN_HANDLE`",
}
"""Advice for replies that report a failure."""
