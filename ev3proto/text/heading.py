"""The one line that tells a message: when, which way, what kind, how it went."""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.dialogue import Exchange
from ev3proto.errors import counted
from ev3proto.messages import DaisyCommand, DaisyReply, DirectReply, SystemCommand, SystemReply
from ev3proto.text.spans import Line, Role


class Seen(NamedTuple):
    """How a message was come by.

    direction  `sent` or `received`, as the computer sees it
    time       as it was written, or seconds since the capture began
    cut        the text that it was read from is cut off
    packets    the packets of a capture that carried it
    place      carrier and brick
    answers    for a reply: the packet of the command that it answers
    latency    for a reply: seconds since then
    frame      the message's bytes where they are at hand, which saves building them
    """

    direction: str | None = None
    time: str | None = None
    cut: bool = False
    packets: tuple[int, ...] = ()
    place: str | None = None
    answers: int | None = None
    latency: float | None = None
    frame: bytes | None = None


def origin(seen: Seen) -> Line:
    """`0.011558 #12 usb 1.7 sent `: what stands before a message."""
    line: Line = []
    if seen.time:
        line.append((f"{seen.time} ", Role.ASIDE))
    if seen.packets:
        line.append((f"{packets_text(seen.packets)} ", Role.ASIDE))
    if seen.place:
        line.append((f"{seen.place} ", Role.PLAIN))
    if seen.direction:
        line.append((f"{seen.direction} ", Role.ASIDE))
    return line


def packets_text(numbers: tuple[int, ...]) -> str:
    """`#12`, `#12+13`: the packets of a capture."""
    return f"#{numbers[0]}" if len(numbers) == 1 else f"#{'+'.join(map(str, numbers))}"


def heading(exchange: Exchange, seen: Seen) -> Line:
    """`09:12:31.011558 sent DIRECT_COMMAND_REPLY, counter 42, 16 bytes`, and for replies what they answer and how."""
    message = exchange.message
    line = origin(seen)
    size = len(message.build() if seen.frame is None else seen.frame)
    if message.type is None:
        line.append((f"no EV3 message, {counted(size, 'byte')}", Role.HEADING))
    else:
        line.append((message.type.name, Role.HEADING))
        line.append((f", counter {message.counter}, {counted(size, 'byte')}", Role.PLAIN))
    if seen.cut and message.stated_length is not None:
        line.append((f" of {message.stated_length + 2}: the text is cut here", Role.MEANING))
    line += _what(exchange)
    if seen.latency is not None:
        line.append((f" ({seen.latency * 1000:.3f} ms after #{seen.answers})", Role.ASIDE))
    return line


def _what(exchange: Exchange) -> Line:
    message = exchange.message
    line: Line = []
    if isinstance(message, SystemCommand | DaisyCommand):
        line.append((": ", Role.PLAIN))
        line.append((message.command or f"0x{message.number:02X}", Role.OPERATION))
    elif isinstance(message, SystemReply):
        status = message.status.name if message.status is not None else f"status {message.status_code}"
        line.append((": ", Role.PLAIN))
        line.append((message.command or f"0x{message.number:02X}", Role.OPERATION))
        line.append((f" {status}", Role.FAULT if message.is_error else Role.VALUE))
    elif isinstance(message, DirectReply | DaisyReply) and message.type is not None:
        line.append(
            (": error" if message.type.is_error else ": ok", Role.FAULT if message.type.is_error else Role.VALUE)
        )
    if exchange.is_orphan:
        line.append((" (the command it answers was not seen)", Role.ASIDE))
    return line
