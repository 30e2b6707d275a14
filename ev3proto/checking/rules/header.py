"""The frame itself: its length, its type, the memory that its header asks for."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.checking import codes
from ev3proto.checking.context import CheckContext
from ev3proto.checking.report import Finding
from ev3proto.checking.verdict import Reason
from ev3proto.errors import counted
from ev3proto.messages import DirectCommand
from ev3proto.schema.frame import frame_schema
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, MEMORY_SIZE, frame_size, with_length
from ev3proto.tables.frame import GRANTED_GLOBALS, LENGTH_FIELD, MAX_FRAME, MAX_LENGTH, MessageType

MOST_IN_REPLY = MAX_FRAME - HEADER_SIZE
"""Bytes of global memory that a reply has room for."""

TYPE_OFFSET = HEADER_SIZE - 1
"""Where the message type stands."""


def check_envelope(context: CheckContext) -> Iterator[Finding]:
    """Length and type."""
    frame = context.frame
    size = len(frame)
    if size < HEADER_SIZE:
        yield codes.TOO_SHORT.finding(
            0,
            size,
            f"a frame has at least {HEADER_SIZE} bytes (length, counter, type), here are {size}",
            "give the whole frame, from its length field on",
        )
        return
    yield from _length(frame, size, context)
    if context.message.type is None:
        yield codes.UNKNOWN_TYPE.finding(
            TYPE_OFFSET,
            1,
            f"0x{frame[TYPE_OFFSET]:02X} is not a message type",
            f"give 0x{MessageType.DIRECT_COMMAND_REPLY:02X} for a direct command with a reply,"
            f" 0x{MessageType.DIRECT_COMMAND_NO_REPLY:02X} for one without,"
            f" 0x{MessageType.SYSTEM_COMMAND_REPLY:02X} or 0x{MessageType.SYSTEM_COMMAND_NO_REPLY:02X} for a system"
            " command",
        )
    elif not context.message.type.is_command:
        yield codes.NO_COMMAND.finding(
            TYPE_OFFSET,
            1,
            f"{context.message.type.name} is what a brick sends, not what is sent to it",
            "check the command that it answers",
        )


def _length(frame: bytes, size: int, context: CheckContext) -> Iterator[Finding]:
    stated = frame_size(frame) - LENGTH_FIELD
    follow = size - LENGTH_FIELD
    if size > MAX_FRAME and (stated == follow or stated > MAX_LENGTH):
        yield codes.TOO_LONG.finding(
            MAX_FRAME,
            size - MAX_FRAME,
            f"a frame has at most {MAX_FRAME} bytes, this one has {size}",
            "send it in several frames",
        )
    elif (slip := _slip(frame, stated, follow, context)) is not None:
        code = codes.INCOMPLETE if stated > follow else codes.LEFT_OVER
        yield code.finding(0, LENGTH_FIELD, _says(stated, follow), slip)
    elif stated > follow:
        yield codes.INCOMPLETE.finding(
            0,
            LENGTH_FIELD,
            _says(stated, follow),
            f"give {follow} as the length, or the bytes that are missing: {stated - follow}"
            if _reads_to_its_end(with_length(frame[LENGTH_FIELD:]), context)
            else f"give the {counted(stated - follow, 'byte')} that {'is' if stated - follow == 1 else 'are'} missing",
        )
    elif stated < follow:
        yield _left_over(frame, stated, follow, context)


def _slip(frame: bytes, stated: int, follow: int, context: CheckContext) -> str | None:
    """Returns what to do about a length whose bytes are swapped, or which counts itself; None for any other length."""
    if stated == follow or not _reads_to_its_end(with_length(frame[LENGTH_FIELD:]), context):
        return None
    if int.from_bytes(frame[:LENGTH_FIELD], "big") == follow:
        return f"did you swap these two bytes? The low one is first: {frame[1::-1].hex(' ').upper()} is {follow}"
    if stated == follow + LENGTH_FIELD:
        return f"give {follow}: the length does not count its own two bytes"
    return None


def _says(stated: int, follow: int) -> str:
    verb = "follows" if stated == 1 else "follow"
    return f"the length field says that {counted(stated, 'byte')} {verb} it, and there are {follow}"


def _left_over(frame: bytes, stated: int, follow: int, context: CheckContext) -> Finding:
    end = context.end
    if context.is_padded and context.carrier in (None, "usb"):
        return codes.PADDING.finding(
            end,
            len(frame) - end,
            f"the frame ends here, and {counted(len(frame) - end, 'zero')} fill it up to a USB report",
            "omit them everywhere but on USB",
        )
    return codes.LEFT_OVER.finding(
        0,
        LENGTH_FIELD,
        _says(stated, follow),
        " or ".join(_ways_out(frame, stated, follow, context)),
    )


def _ways_out(frame: bytes, stated: int, follow: int, context: CheckContext) -> Iterator[str]:
    """What can be done about bytes after the end of a frame: what makes a frame of it, or what else is possible."""
    is_start = stated + LENGTH_FIELD >= HEADER_SIZE
    fits = len(frame) <= MAX_FRAME
    if fits and (not is_start or _reads_to_its_end(with_length(frame[LENGTH_FIELD:]), context)):
        yield f"give {follow} as the length" + "," * is_start
    elif not is_start:
        yield f"give the length of one frame, which has {MAX_FRAME} bytes at most"
    if is_start:
        yield f"omit the last {counted(follow - stated, 'byte')}"


def _reads_to_its_end(frame: bytes, context: CheckContext) -> bool:
    """Whether a frame could be meant so: it has a command's type, and no byte too few or too many."""
    message = frame_schema(context.dialect).read_frame(frame, strict=False)
    return message.type is not None and message.type.is_command and message.fault is None


def check_command_header(context: CheckContext, command: DirectCommand) -> Iterator[Finding]:
    """What the header of a direct command asks for."""
    reason = context.verdict.reason
    if reason is Reason.EMPTY or context.end < COMMAND_HEADER_SIZE:
        if not context.is_length_wrong:
            yield codes.EMPTY.finding(
                context.end,
                0,
                "the command has no operation"
                if context.end == COMMAND_HEADER_SIZE
                else "the command ends before the two bytes that ask for memory",
                f"give at least one operation; {codes.opcode('NOP')} does nothing"
                if context.end == COMMAND_HEADER_SIZE
                else "give two bytes that ask for memory, 0 for none, and then at least one operation;"
                f" {codes.opcode('NOP')} does nothing",
            )
        return
    asked = command.global_size
    if asked > GRANTED_GLOBALS:
        yield codes.REFUSED_MEMORY.finding(
            HEADER_SIZE,
            MEMORY_SIZE,
            f"the header asks for {asked} bytes of global memory, and the firmware grants {GRANTED_GLOBALS} at most",
            f"ask for no more than {MOST_IN_REPLY} bytes, which is what a reply carries",
        )
    elif asked > MOST_IN_REPLY:
        yield codes.LONG_REPLY.finding(
            HEADER_SIZE,
            MEMORY_SIZE,
            f"the header asks for {asked} bytes of global memory, and a reply carries {MOST_IN_REPLY}",
            f"ask for no more than {MOST_IN_REPLY} bytes",
        )
