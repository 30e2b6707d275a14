"""Why bytes cannot be read as a frame: the words for Python, the dissector and the decoder in JavaScript."""

from __future__ import annotations

from ev3proto.errors import DecodeError
from ev3proto.schema.header import HEADER_SIZE
from ev3proto.tables.frame import MAX_FRAME, MAX_LENGTH, MIN_LENGTH

REASONS = {
    # A frame outside its body
    "no_header": f"a frame has at least {HEADER_SIZE} bytes (length, counter, type), this one has {{size}}",
    "wrong_length": f"the length field says {{length}}; it can be {MIN_LENGTH} to {MAX_LENGTH}",
    "too_long": f"the frame has {{size}} bytes; the maximum is {MAX_FRAME}",
    "cut_off": "the frame is cut off: its length field says that {length} bytes follow, but {size} do",
    "longer": "the frame is longer than its length field says: {length} bytes should follow it, but {size} do",
    "bootloader": "{reason}. From a brick on a USB 3 port this is a known fault of its bootloader: the reply to {name}"
    " with the request written over its first bytes",
    "no_type": "unknown message type {byte}",
    "two": "{reason}; and at offset {offset}: {inner}",
    # What a body begins with, by the kind of the message
    "direct-command": "the frame ends before the two bytes that request memory",
    "system-command": "the frame ends before the system command",
    "system-reply": "the frame ends before the command answered and the status",
    "daisy-command": "the frame ends before the sub-command and the two layers",
    "daisy-reply": "the frame ends before the two layers",
    "no_system": "unknown system command {byte}",
    "no_daisy": "unknown daisy sub-command {byte}",
    # Operations and their arguments
    "no_opcode": "unknown opcode {byte} for the {dialect} firmware",
    "no_cmd": "{owner} has no CMD {value} (it has {known}, ...)",
    "variable_cmd": "CMD of {owner} is {value}, but must be a constant",
    "no_argument": "the frame ends before the argument {name}",
    "no_form": "undefined identification byte {byte} (argument {name})",
    "cut_string": "the string {name} runs past the end of the frame: its terminating zero is missing",
    "cut_argument": "the argument {name} runs past the end of the frame: {form} needs {more}",
    "no_count": "{name} must be a constant: it is the number of values that follow",
    "no_room": "{name} cannot be {value}: there is room for 0 to {room} values",
    # The fields of system messages
    "left_over": "{bytes} left over after the last field",
    "wrong_count": "{counter} says {stated} bytes, but {size} follow to the end of the frame",
    "cut_text": "a text of length {length} runs past the end of the frame",
    "no_zero": "the terminating zero of a text is missing",
    "other_zero": "a text of length {length} must end with a zero, not with {byte}",
    "endless_text": "the text {name} runs past the end of the frame: its terminating zero is missing",
    "no_field": "the frame ends before the field {name} ({kind})",
}


def unreadable(at: int, key: str, truncated: bool = False, /, **parts: object) -> DecodeError:
    """Returns the error for an offset of a frame, in words of `REASONS` with their parts; `byte` is a number."""
    if "byte" in parts:
        parts["byte"] = f"0x{parts['byte']:02X}"
    return DecodeError(at, REASONS[key].format(**parts), truncated)
