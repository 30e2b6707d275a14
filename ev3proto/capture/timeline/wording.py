"""What marks say: messages, values, files and announcements in a few words that are safe to draw.

All that comes from the network goes through `clean`: it may be long, and it may have characters that no picture can
have or that turn the text around them.
"""

from __future__ import annotations

from ev3proto.capture.dialogues import is_error
from ev3proto.capture.record import Announcement, Record
from ev3proto.dialogue import Transfer
from ev3proto.messages import DaisyCommand, DirectCommand, Message, SystemCommand, SystemReply
from ev3proto.text.phrases import argument_meaning, argument_value, command_spans, reply_spans, value_text
from ev3proto.text.spans import plain_text, visible

MOST_LETTERS = 240
"""Letters of one detail."""

MOST_LABEL = 28
"""Letters of what stands beside a mark."""

MOST_TOLD = 8
"""Values of one message that stand beside a mark."""

UNSEEN = "command not seen"
"""Subject of replies to commands that were not seen, of which nothing says what they are about."""


def clean(text: str, most: int = MOST_LETTERS) -> str:
    """A text with what is not printable escaped, and not longer than `most` letters: the end is omitted."""
    shown = visible(text[: most + 1])
    return shown if len(shown) <= most else f"{shown[: most - 1]}…"


def clean_path(path: str, most: int = MOST_LABEL) -> str:
    """The same for a path, whose beginning is omitted."""
    shown = visible(path[-most - 1 :])
    return shown if len(shown) <= most else f"…{shown[1 - most :]}"


def subject(message: Message) -> str:
    """What a message is about: its operations, its system command, its daisy command; UNSEEN for other replies."""
    match message:
        case DirectCommand():
            return _operations(message)
        case SystemCommand() | SystemReply() | DaisyCommand():
            return message.command or f"0x{message.number:02X}"
    return UNSEEN


def _operations(command: DirectCommand) -> str:
    names = list(dict.fromkeys(operation.full_name for operation in command.operations))
    if not names:
        return "no operation"
    return ", ".join(names) if len(names) <= 2 else f"{names[0]} + {len(names) - 1} more"


def command_text(command: Record) -> str:
    """A command with its arguments or fields: `SOUND.TONE(VOLUME=5, FREQUENCY=440, DURATION=250)`."""
    return clean(plain_text(command_spans(command.message)))


def reply_text(reply: Record) -> str:
    """What a reply says: its values with their units, its status."""
    return clean(plain_text(reply_spans(reply.exchange)))


def exchange_label(command: Record | None, reply: Record | None) -> str:
    """What stands beside an exchange: values that came back; without a reply, what the one operation is to do."""
    if reply is not None:
        message = reply.message
        if isinstance(message, SystemReply):
            return reply_text(reply).split(" ", 1)[0] if message.is_error else ""
        if is_error(message):
            return "error"
        return clean(", ".join(value_text(value) for value in reply.values[:MOST_TOLD]), MOST_LABEL)
    message = command.message if command is not None else Message()
    if not isinstance(message, DirectCommand) or message.wants_reply or len(message.operations) != 1:
        return ""
    arguments = message.operations[0].arguments[:MOST_TOLD]
    shown = (
        argument.symbol or f"{argument_value(argument)} {argument_meaning(argument)}".rstrip() for argument in arguments
    )
    return clean(", ".join(shown), MOST_LABEL)


def transfer_progress(transfer: Transfer) -> str:
    """How far it came: `2500 of 2500 bytes`."""
    return f"{transfer.transferred} of {'?' if transfer.size is None else transfer.size} bytes"


def announcement_text(announcement: Announcement) -> str:
    """What a beacon or unlock text says: `serial 0016530f0f0f, port 5555, name myEV3, protocol EV3`."""
    shown = ", ".join(f"{name} {value}" for name, value in announcement.facts.items())
    return clean(shown or f"{len(announcement.data)} bytes")


def packets(numbers: tuple[int, ...]) -> str:
    """`7`, `7, 8`, `7 to 31 (9 packets)`."""
    if len(numbers) <= 3:
        return ", ".join(str(number) for number in numbers)
    return f"{numbers[0]} to {numbers[-1]} ({len(numbers)} packets)"
