"""Every code that a check can give: its severity, its explanation, a frame that raises it and one that does not.

Codes are stable: a tool may rely on `E301`. The first digit is the topic: 1 the frame, 2 operations,
3 values, 4 memory, 5 texts and arrays, 6 control flow, 7 sounds, drawings and moves, 8 system messages and
messages between bricks, 9 encodings.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from types import MappingProxyType
from typing import NamedTuple

from ev3proto.checking.report import Finding, Severity
from ev3proto.schema.header import COMMAND_HEADER_SIZE, MOST_IN_REPLY, with_length
from ev3proto.schema.reasons import REASONS
from ev3proto.semantics.advice import STATED
from ev3proto.semantics.judgement import Wrong
from ev3proto.tables import mailboxes, operations
from ev3proto.tables.daisy import DaisySubCommand
from ev3proto.tables.declaration import Role
from ev3proto.tables.frame import GRANTED_GLOBALS, REPORT_SIZES, MessageType
from ev3proto.tables.system import FLASH_SIZE
from ev3proto.tables.validation import LABELS


@dataclass(frozen=True)
class Words:
    """What a finding says: templates with named parts, such as {name} and {value}.

    Words in brackets, such as `[ on {carrier}]`, are left out if one of their parts is None.
    """

    message: str
    help: str

    @property
    def names(self) -> set[str]:
        """The names of the parts."""
        return set(_PART.findall(self.message + self.help))

    def filled(self, parts: Mapping[str, object]) -> tuple[str, str]:
        """Returns message and help with their parts."""
        return _filled(self.message, parts), _filled(self.help, parts)


def _filled(template: str, parts: Mapping[str, object]) -> str:
    def optional(found: re.Match[str]) -> str:
        return "" if None in map(parts.get, _PART.findall(found[1])) else found[1]

    return (_OPTIONAL.sub(optional, template) if "[" in template else template).format_map(parts)


_OPTIONAL, _PART = re.compile(r"\[([^]]*)\]"), re.compile(r"\{(\w+)")
_Texts = Mapping[Wrong | Role | str, Words]
_NO_WORDS: _Texts = MappingProxyType({})


class FindingCode(NamedTuple):
    """One code."""

    code: str  # `E301`: E for errors, W for warnings, H for hints
    title: str  # a few words that name it
    explanation: str  # what happens on the brick, why, and what to do; paragraphs, separated by empty lines
    example: bytes  # a frame that raises it
    counterexample: bytes  # nearly the same frame, which does not raise it
    carrier: str | None = None  # the carrier that both need, None if it does not matter
    alone: bool = False  # whether it is only for a frame that is not among others
    words: _Texts = _NO_WORDS  # its words, by what is wrong with a value or by a name; "" is the name of the usual ones

    @property
    def severity(self) -> Severity:
        """How bad it is."""
        return _SEVERITIES[self.code[0]]

    def at(self, offset: int, length: int, key: Wrong | Role | str = "", /, **parts: object) -> Finding:
        """Returns a finding in the words of this code.

        Args:
            offset: Of the first byte concerned.
            length: Number of bytes concerned.
            key: Of the words.
            parts: What the words name; `owner` is the operation or system command, `name` the parameter or field.
        """
        message, help_ = self.words[key].filled(parts)
        owner, name = [None if parts.get(part) is None else str(parts[part]) for part in ("owner", "name")]
        return Finding(self.severity, self.code, offset, length, message, help_, owner, name)


UNNOTICED = "unnoticed"
"""The key of words about bytes that the brick runs as operations without noticing."""
NO_PORTS, NEVER_RUNS, MAILBOX_NAME, MAILBOX_CONTENT = "NO_PORTS", "NEVER_RUNS", "MAILBOX_NAME", "MAILBOX_CONTENT"
"""The keys of words that the dissector says, too: a bit mask without a port, an opcode that never runs, what is too
long for a mailbox."""

CODES: dict[str, FindingCode] = {}
"""The codes by name, in order."""

_SEVERITIES = {severity.value[0].upper(): severity for severity in Severity}


def registered(
    known: dict[str, FindingCode],
    code: str,
    title: str,
    explanation: str,
    example: bytes,
    counterexample: bytes,
    carrier: str | None = None,
    alone: bool = False,
    words: Words | _Texts = _NO_WORDS,
) -> FindingCode:
    """Returns a code, which is added to those known; the parameters are the fields of `FindingCode`."""
    texts: _Texts = {"": words} if isinstance(words, Words) else words
    return known.setdefault(
        code, FindingCode(code, title, explanation.strip(), example, counterexample, carrier, alone, texts)
    )


_code = partial(registered, CODES)


def _frame(text: str) -> bytes:
    """Returns a frame, written like `0E:00|2A:00|80|...`, with the length field as given."""
    return bytes.fromhex(text.replace("|", "").replace(":", ""))


def _sized(text: str) -> bytes:
    """Returns a frame, written from the counter on; the length field is computed."""
    return with_length(_frame(text))


def opcode(name: str) -> str:
    """Returns the name of an operation without a CMD together with its byte: `NOP (0x01)`."""
    return f"{name} (0x{operations()[name].opcode.number:02X})"


# What several codes say.
_NOP = opcode("NOP")
_USE_AN_OPCODE = "use an opcode, and check the length of what is before it"
_OTHER_CMD = "use a CMD of {owner}; `ev3proto ops {owner}` lists them"
_REFUSED_LATER = "[; the brick reads the next bytes as operations, and refuses the command at offset {refused_at}]"
_UNNOTICED = "; the brick does not notice, and runs the next bytes as operations"
_COUNT = "{name} is [{value}][{encoding}, which is not a number]"
_OTHER_COUNT = "use the number of values that follow, as a constant"
_UNASKED = "the type does not ask for a reply, but the reply to {owner} has"
_FAILS = "{owner} ends the command with an error on every brick"
_MISREAD = "the 2013 firmware does not know {owner} and reads its arguments as operations"
_BEYOND = Words(
    "{name} takes {bytes} of {scope} memory, but the header requests {asked} {scope} memory",
    "[request {room} of {scope} memory, or ]use a lower index[; {scope} memory has at most {limit}]",
)

TONE = _sized("2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03")
VOLTAGE = _sized("2A:00|00|04:00|81:01:60")

# 1: the frame

TOO_SHORT = _code(
    "E101",
    "too short for a frame",
    """
    A frame starts with five bytes: two of length, two of the message counter, one of the type. A direct command
    has two more, which request memory. These bytes end before that, so they cannot be identified.
    """,
    _frame("03:00|2A:00"),
    VOLTAGE,
    words=Words(REASONS["no_header"], "start at the length field and include the whole frame"),
)
INCOMPLETE = _code(
    "E102",
    "the frame ends too early",
    """
    The length field counts the bytes that follow it. Here it counts more bytes than there are.

    On Bluetooth and WiFi the brick keeps waiting, and takes the start of the next frame for the missing bytes. On
    USB it continues reading in its buffer, which holds the remains of the last report.
    """,
    _frame("0E:00|2A:00|80|00:00|94:01:01:82:B8:01"),
    TONE,
    words=Words(STATED, "set the length to {follow}, or add the {missing}"),
)
LEFT_OVER = _code(
    "E103",
    "bytes after the end of the frame",
    """
    The length field counts the bytes that follow it. Here more bytes follow, and the brick does not read them as
    part of the frame: on USB it drops them, on Bluetooth and WiFi it takes them for the start of the next frame,
    and everything after them is lost.
    """,
    _frame("08:00|2A:00|80|00:00|82:1B:02:82:1B:01"),
    _frame("0B:00|2A:00|80|00:00|82:1B:02:82:1B:01"),
    words={
        "": Words(STATED, "set the length to {follow}[, or omit the last {over}]"),
        "too long": Words(STATED, "use a length of at most {most}[, or omit the last {over}]"),
    },
)
TOO_LONG = _code(
    "E104",
    "a frame that is too long",
    """
    A frame has at most 1024 bytes, including its length field. That is the size of the firmware's buffers and of
    one USB report. Split a long job into several commands.

    BEGIN_DOWNLOAD and CONTINUE_DOWNLOAD may be longer on Bluetooth and WiFi: the firmware takes their data in
    pieces. `--carrier usb` checks them for USB.
    """,
    _sized("2A:00|80|00:00|" + "01:" * 1017 + "01"),
    _sized("2A:00|80|00:00|" + "01:" * 1016 + "01"),
    words=Words("a frame has at most {most} bytes[ on {carrier}], this one has {size}", "send it in several frames"),
)
UNKNOWN_TYPE = _code(
    "E105",
    "an unknown message type",
    """
    The byte after the message counter is the type of the message. There are twelve types; a brick accepts
    direct commands (0x00 with a reply, 0x80 without) and system commands (0x01 and 0x81).
    """,
    _frame("06:00|2A:00|40|00:00|01"),
    _frame("06:00|2A:00|80|00:00|01"),
    words=Words(
        "unknown message type 0x{type:02X}",
        f"use 0x{MessageType.DIRECT_COMMAND_REPLY:02X} for a direct command with a reply,"
        f" 0x{MessageType.DIRECT_COMMAND_NO_REPLY:02X} for one without, 0x{MessageType.SYSTEM_COMMAND_REPLY:02X} or"
        f" 0x{MessageType.SYSTEM_COMMAND_NO_REPLY:02X} for a system command",
    ),
)
EMPTY = _code(
    "E106",
    "a command without operations",
    f"""
    The firmware refuses a direct command that ends after its header. To test whether the brick answers, send
    {opcode("NOP")}.
    """,
    _frame("05:00|2A:00|00|00:00"),
    _frame("06:00|2A:00|00|00:00|01"),
    words={
        "": Words("the command has no operation", f"add at least one operation; {_NOP} does nothing"),
        "no memory": Words(
            "the command ends before the two bytes that request memory",
            f"add two bytes that request memory, 0 for none, and then at least one operation; {_NOP} does nothing",
        ),
    },
)
REFUSED_MEMORY = _code(
    "E107",
    "more global memory than the firmware grants",
    """
    The header has ten bits for the size of the global memory, so it can request up to 1023 bytes. The firmware grants
    1021 and refuses a command that requests more. A reply has room for 1019.
    """,
    _sized("2A:00|00|FF:03|81:01:60"),
    VOLTAGE,
    words=Words(
        f"the header requests {{asked}} bytes of global memory, but the firmware grants at most {GRANTED_GLOBALS}",
        f"request at most {MOST_IN_REPLY} bytes, which fit into a reply",
    ),
)
NOT_A_FRAME = _code(
    "E108",
    "not a frame of an EV3",
    """
    All bytes together are something else: a text, the digits of a frame as characters, or a telegram of another
    product of LEGO, such as the NXT. A brick takes their first two bytes for a length.
    """,
    b"forward",
    _frame("06:00|2A:00|80|00:00|01"),
    words=Words("{said}", "send a frame; `ops` lists the operations"),
)
NO_COMMAND = _code(
    "W101",
    "a reply, not a command",
    """
    This is a message from a brick. A check is for messages to a brick, so it says nothing about this frame; to
    read it, use `ev3proto decode`.
    """,
    _frame("03:00|2A:00|02"),
    VOLTAGE,
    words=Words("{type} is a message from the brick, not to it", "check the command that it answers"),
)
LONG_REPLY = _code(
    "W102",
    "a reply that would be too long",
    """
    A reply carries the whole global memory after a header of five bytes, and a frame has at most 1024 bytes. The
    firmware grants two bytes of global memory more than fit.
    """,
    _sized("2A:00|00|FC:03|81:03:81:7F:60"),
    _sized("2A:00|00|7F:00|81:03:81:7F:60"),
    words=Words(
        f"the header requests {{asked}} bytes of global memory, but a reply carries {MOST_IN_REPLY}",
        f"request at most {MOST_IN_REPLY} bytes",
    ),
)
PADDING = _code(
    "H101",
    "padding after the frame",
    """
    A USB report always has 1024 bytes; the bytes after the frame have no meaning. Only USB has such padding: on
    Bluetooth and WiFi the brick would take the zeros for frames.
    """,
    _frame("06:00|2A:00|80|00:00|01") + bytes(1016),
    _frame("06:00|2A:00|80|00:00|01"),
    words=Words("the frame ends here; {zeros} pad it to a USB report", "omit them, except on USB"),
)

# 2: operations

UNKNOWN_OPCODE = _code(
    "E201",
    "an unknown opcode",
    """
    The firmware's table of opcodes has no entry for this byte, or it is ERROR (0x00), which is never allowed.
    The brick refuses the whole command; none of it runs.

    Often the byte was not meant as an opcode: an argument before it is shorter or longer than intended, so
    everything after it is misread. Look at the operation before it first.
    """,
    _sized("2A:00|80|00:00|A6:00:01:00"),
    _sized("2A:00|80|00:00|A6:00:01"),
    words={
        NEVER_RUNS: Words("{byte} is {owner}, which the firmware never runs", _USE_AN_OPCODE),
        "": Words("unknown opcode {byte} for the {dialect} firmware", _USE_AN_OPCODE),
        "dialect": Words(
            "{byte} is {known} in the dialects {others}, but not an opcode of {dialect} firmware", _USE_AN_OPCODE
        ),
        "unreleased": Words("{byte} is {known}, which is documented but not implemented by any firmware", "{note}"),
    },
)
AFTER_END = _code(
    "E202",
    "operations after OBJECT_END",
    """
    OBJECT_END ends the code. The firmware stops reading there, finds bytes left over, and refuses the command. It
    appends an OBJECT_END to every direct command itself, so a command does not need one.
    """,
    _sized("2A:00|80|00:00|82:1B:02:0A:82:1B:01"),
    _sized("2A:00|80|00:00|82:1B:02:82:1B:01"),
    words=Words(
        "the firmware refuses the command: {bytes} too many after the OBJECT_END at offset {end}",
        "omit the OBJECT_END, or what follows it",
    ),
)
CUT_OFF = _code(
    "E203",
    "the last operation is cut off",
    """
    The operations must end exactly where the command ends. This one needs more bytes than the command has: an
    argument is missing, a text has no zero, or a list has fewer elements than its count.

    The firmware reads on past the end, where it finds an OBJECT_END and zeros, and refuses the command because the
    operation ends too late.
    """,
    _sized("2A:00|80|00:00|94:01:01:82:B8:01"),
    TONE,
    words={
        "": Words("{owner}: {reason}", "add the missing bytes"),
        "count": Words("{name} says {values}, but only {bytes} follow", "add the missing values, or correct the count"),
    },
)
FIRST_OUT_OF_RANGE = _code(
    "E204",
    "a first argument out of range of its type",
    """
    The firmware checks the value of a constant only in an operation's first parameter, CMD included. A value that
    the type cannot hold makes it refuse the command: outside -127 to 127 for 8 bits, -32767 to 32767 for 16,
    -2147483647 to 2147483647 for 32. The lowest number of each type means "not a number" and is refused, too.

    In later parameters the firmware does not notice this mistake; see E301.
    """,
    _sized("2A:00|80|00:00|A6:82:2C:01:01"),
    _sized("2A:00|80|00:00|A6:00:01"),
    words={
        Wrong.REFUSED: Words(
            "{name} is {value}, but the brick accepts only {accepted} in a first parameter", "use {legal}"
        )
    },
)
MISALIGNED = _code(
    "E205",
    "a misaligned variable",
    """
    A variable of 16 bits must start at an even index of its memory, one of 32 bits or a float at a multiple of 4.
    The firmware checks that before it runs anything, and refuses the whole command. --fix does not move variables,
    because the program that reads the reply relies on their positions; the help names the multiple.
    """,
    _sized("2A:00|00|05:00|81:01:61"),
    VOLTAGE,
    words=Words("{name} is {variable}, and must start at a multiple of {step}", "use a multiple of {multiple}"),
)
BAD_LABEL = _code(
    "E206",
    "a label out of range",
    """
    LABEL marks a place for jumps. A program has room for 32 labels, numbered 0 to 31; the firmware refuses
    other numbers.
    """,
    _sized("2A:00|80|00:00|0D:81:20"),
    _sized("2A:00|80|00:00|0D:01"),
    words={
        Wrong.LABEL_NUMBER: Words(
            f"{{name}} is {{value}}, but labels are 0 to {LABELS - 1}",
            f"use 1 to {LABELS - 1}; jumps cannot name label 0",
        )
    },
)
SPINS = _code(
    "E207",
    "a count that hangs the brick",
    """
    The operation says how many values follow, and the firmware trusts it: it reads that many before it checks
    whether the command has them. It reads the count unsigned, so -1 is more than four thousand million. The brick
    then hangs for minutes, and must be switched off.
    """,
    _sized("2A:00|80|00:04|2F:40:3F:01"),
    _sized("2A:00|80|00:04|2F:40:01:01"),
    words={
        "": Words(
            f"{_COUNT}: the brick reads millions of values before it does anything else",
            "use the number of values that follow, 0 or more",
        ),
        "unread": Words(
            "the brick takes this for a count of values, and reads millions of them before it does anything else",
            "use the number of values that follow, 0 or more",
        ),
    },
)
UNKNOWN_CMD = _code(
    "E208",
    "an unknown CMD",
    """
    The firmware does not refuse an unknown CMD. It treats it as a command without parameters, so it reads and runs
    the bytes meant as arguments as operations. It may refuse those later on, or do something unintended.
    """,
    _sized("2A:00|80|00:00|94:07:01"),
    _sized("2A:00|80|00:00|94:00:01"),
    words={
        "": Words(f"{{owner}} has no CMD {{value}}{_REFUSED_LATER}", _OTHER_CMD),
        UNNOTICED: Words(f"{{owner}} has no CMD {{value}}{_UNNOTICED}", _OTHER_CMD),
    },
)
VARIABLE_CMD = _code(
    "E209",
    "a CMD that is not a constant",
    """
    CMD decides which parameters follow, so it must be a number in the frame itself. For a variable, the firmware's
    validator takes its index as the CMD, while the operation takes its value; for a text, CMD is 0.
    """,
    _sized("2A:00|80|00:04|94:41:01:82:B8:01:82:E8:03"),
    TONE,
    words=Words("{reason}", _OTHER_CMD),
)
UNDEFINED_FORM = _code(
    "E210",
    "an undefined identification byte",
    """
    The first byte of an argument gives its encoding. In the long forms, its last three bits give the width; of the
    eight possible numbers, the firmware defines five for constants and three for variables. For all others it
    reads no further byte, and uses the number it read before.
    """,
    _sized("2A:00|80|00:00|A3:00:01:85"),
    _sized("2A:00|80|00:00|A3:00:01:01"),
    words=Words(
        "undefined identification byte 0x{byte:02X} for {name} of {owner}",
        "encode the argument as LC0, LC1, LC2, LC4, LCS or a variable",
    ),
)
BAD_COUNT = _code(
    "E211",
    "a count that is not a constant number",
    """
    The number of elements in a list must be a constant: 0 to 127 for a count of parameters, 0 or more for a count
    of values. Otherwise the firmware takes the list as empty, or the index of a variable as the number, and reads
    the elements as operations.
    """,
    _sized("2A:00|80|00:14|2F:44:40:01"),
    _sized("2A:00|80|00:04|2F:40:01:01"),
    words={
        "": Words(f"{_COUNT}{_REFUSED_LATER}", _OTHER_COUNT),
        UNNOTICED: Words(f"{_COUNT}{_UNNOTICED}", _OTHER_COUNT),
    },
)
NEWER = _code(
    "E212",
    "an operation that the 2013 firmware refuses",
    """
    LEGO added this CMD later. The firmware of 2013, whose rules are used here, treats it as a command without
    parameters, reads what follows as operations, and refuses the command there. Newer firmware accepts it.
    """,
    _sized("2A:00|00|10:00|81:1D:60:64:68:6C"),
    VOLTAGE,
    words=Words(f"{_MISREAD}: it refuses the command at offset {{at}}", "send it to bricks with newer firmware only"),
)
FAILS = _code(
    "W202",
    "an operation that fails on every brick",
    """
    The validator knows the operation and accepts it, but it cannot work in a direct command: the firmware has no code
    for it, or it needs an address in the brick's own memory. The command ends there, and the reply is
    DIRECT_REPLY_ERROR (0x04).
    """,
    _sized("2A:00|00|00:00|D1:01:00:00:00"),
    _sized("2A:00|00|00:00|01"),
    words={
        "": Words(f"{_FAILS}: {{reason}}", "omit it"),
        "no code": Words(f"{_FAILS}: the firmware has no code for it that a command can use", "omit it"),
    },
)
NEWER_ACCEPTED = _code(
    "W201",
    "an operation that the 2013 firmware misreads",
    """
    LEGO added this CMD later. The firmware of 2013, whose rules are used here, treats it as a command without
    parameters, and runs what follows as operations. By chance these are valid.
    """,
    _sized("2A:00|80|00:00|82:12:01"),
    _sized("2A:00|80|00:00|82:1B:01"),
    words=Words(_MISREAD, "send it to bricks with newer firmware only"),
)

# 3: values

TRUNCATED = _code(
    "E301",
    "a constant that is truncated to its type",
    """
    A constant may be encoded in more bytes than the parameter has. The firmware keeps the lowest of them and
    drops the rest without a warning: 300 in a parameter of 8 bits is 44. It checks the value of the first
    parameter only (E204).
    """,
    _sized("2A:00|80|00:00|A3:00:82:2C:01:01"),
    _sized("2A:00|80|00:00|A3:00:01:01"),
    words={
        Wrong.TRUNCATED: Words("{name} is {value}, which the brick truncates to {read}: it is a {type}", "use {legal}")
    },
)
CONSTANT_OUTPUT = _code(
    "E302",
    "a constant for an output",
    """
    The parameter is a variable in which the brick stores a result. It accepts a constant, too, but then the
    result is lost; a text is overwritten inside the command.
    """,
    _sized("2A:00|00|00:00|81:01:00"),
    VOLTAGE,
    words={
        Wrong.WRITTEN: Words(
            "{name} is a constant, but the brick writes to it",
            "use a variable[ large enough for {sized}]: global for the reply, or local",
        )
    },
)
NUMBER_FOR_TEXT = _code(
    "E303",
    "a number instead of a text",
    """
    The parameter takes a text (0x84, the characters, a zero) or a variable that holds one. The brick also accepts a
    number and reads its bytes, and those after them, as characters up to the next zero.
    """,
    _sized("2A:00|80|00:00|94:02:01:05"),
    _sized("2A:00|80|00:00|94:02:01:84:78:00"),
    words={
        Wrong.NUMBER: Words(
            "{name} is the number {value}, but the brick reads a text",
            "use a text as LCS, or a variable that holds one",
        )
    },
)
TEXT_FOR_NUMBER = _code(
    "E304",
    "a text instead of a number",
    """
    The parameter takes a number. The brick also accepts a text and reads its first characters as a number:
    "1" is 49.
    """,
    _sized("2A:00|80|00:00|A3:00:84:31:00:01"),
    _sized("2A:00|80|00:00|A3:00:01:01"),
    words={Wrong.TEXT: Words("{name} is a text, but the brick reads a {kind}", "use a number")},
)
INTEGER_FOR_FLOAT = _code(
    "E305",
    "a whole number instead of a float",
    """
    A float is four bytes (0x83 and an IEEE single). The brick reads the bits of any constant here as a float: the
    whole number 1 becomes 0.0000000000000000000000000000000000000000000014. Only 0 is the same in both.
    """,
    _sized("2A:00|80|00:10|3F:01:40"),
    _sized("2A:00|80|00:10|3F:83:00:00:80:3F:40"),
    words={
        Wrong.WHOLE: Words(
            "{name} is the whole number {value}, but the brick reads its bits as a float",
            "write a float as LC4 with the four bytes of an IEEE single",
        )
    },
)
LABEL_FOR_NUMBER = _code(
    "E307",
    "a label instead of a number",
    """
    An identification byte of A0 to BF is LAB1, a label for jumps. The brick replaces labels 1 to 31 by the distance to
    that label, whatever the operation does with it.

    Programs that set a sign in the identification byte send A1 14 for -20. Negative numbers have no sign of their own:
    -20 is 2C (LC0), -100 is 81 9C.
    """,
    _sized("2A:00|80|00:00|A5:00:01:A1:14:A6:00:01"),
    _sized("2A:00|80|00:00|A5:00:01:2C:A6:00:01"),
    words={
        Wrong.LABEL: Words(
            "{byte} is LAB1, a label: the brick puts the place of label {value} here, not a number",
            "write a number as a constant; labels are for jumps",
        )
    },
)
NEGATIVE = _code(
    "W301",
    "a number that the brick reads as negative",
    """
    The value fits the bytes of the parameter only if unsigned. The firmware drops the upper bytes and reads the
    rest as signed: 200 in a parameter of 8 bits is -56. That is fine for bits or bytes; write them as the negative
    number to make it explicit.
    """,
    _sized("2A:00|80|00:04|30:00:40|9F:00:00:01:82:C8:00"),
    _sized("2A:00|80|00:04|30:00:40|9F:00:00:01:81:C8"),
    words={
        Wrong.NEGATIVE: Words(
            "{name} is {value}, which the brick reads as {read}: it is a {type}",
            "write {read} if these bits are meant, otherwise a number that fits",
        )
    },
)
NOT_A_NUMBER = _code(
    "W302",
    "a value that means 'not a number'",
    """
    The lowest number of each type (-128, -32768, -2147483648) and the float 0x7FC00000 mean that there is no
    value. Sensors return them; as an argument they are rarely intended. In a first parameter the brick refuses them
    (E204).
    """,
    _sized("2A:00|80|00:00|A4:00:01:81:80"),
    _sized("2A:00|80|00:00|A4:00:01:81:9C"),
    words=dict.fromkeys(
        (Wrong.NAN, Wrong.NAN_FLOAT),
        Words('{name} is {value}, which means "not a number"', "use a number, unless this is intended"),
    ),
)
OUT_OF_RANGE = _code(
    "W303",
    "a value outside the documented range",
    """
    The brick accepts the command. What it does with the value depends on the operation: some limit it, some do
    nothing, some do something unexpected.
    """,
    _sized("2A:00|80|00:00|94:01:01:82:C8:00:82:E8:03"),
    TONE,
    words={
        Wrong.OUTSIDE: Words("{name} is {value}{outside}[; the brick reads it as {read}]", "use {legal}"),
        Wrong.MASK: Words(
            "{name} is {value}, the bit mask of {ports}, but it takes the number of one port", "use {letters}"
        ),
    },
)
NO_MEMBER = _code(
    "W304",
    "a number without a name",
    """
    The parameter takes one of several named numbers, such as the patterns of the light. This number is not among
    them.
    """,
    _sized("2A:00|80|00:00|82:1B:1F"),
    _sized("2A:00|80|00:00|82:1B:01"),
    words={Wrong.NO_MEMBER: Words("{name} is {value}{outside}[; the brick reads it as {read}]", "use {legal}")},
)
NUMBER_AS_LABEL = _code(
    "W305",
    "a number that is encoded as a label",
    """
    An identification byte of A0 to BF is LAB1, a label for jumps. A program has labels 1 to 31; the brick takes 0, 32
    and above as plain numbers of one byte without a sign.

    Programs that set a sign in the identification byte send A1 32 for -50, and the brick reads 50. -50 is 81 CE.
    """,
    _sized("2A:00|80|00:00|A5:00:01:A1:32:A6:00:01"),
    _sized("2A:00|80|00:00|A5:00:01:81:CE:A6:00:01"),
    words={
        Wrong.LABEL_BYTE: Words(
            f"{{byte}} is LAB1, a label, but labels are 1 to {LABELS - 1}: the brick takes this one as the number"
            " {read}",
            "write a number as a constant; labels are for jumps",
        )
    },
)


# 4: memory

BEYOND_LOCALS = _code(
    "E401",
    "a variable beyond the local memory",
    """
    The header requests a number of bytes of local memory (its upper six bits). This variable is beyond them, wholly
    or partly. The firmware does not check that: the operation reads or writes bytes that belong to something else.
    """,
    _sized("2A:00|80|00:00|85:82:E8:03:40:86:40"),
    _sized("2A:00|80|00:10|85:82:E8:03:40:86:40"),
    words=_BEYOND,
)
BEYOND_GLOBALS = _code(
    "E402",
    "a variable beyond the global memory",
    """
    The header requests a number of bytes of global memory (its lower ten bits), and the reply carries exactly
    these. This variable is beyond them, wholly or partly: the reply does not include its value, and the operation
    overwrites memory that belongs to something else.
    """,
    _sized("2A:00|00|00:00|81:01:60"),
    VOLTAGE,
    words=_BEYOND,
)
OVERLAP = _code(
    "W401",
    "results that overlap",
    """
    Two results are stored in places that share bytes, so the later one destroys the other. A
    number of 8 bits takes one byte, of 16 bits two, of 32 bits or a float four.
    """,
    _sized("2A:00|00|08:00|81:12:60|81:01:64|81:12:65"),
    _sized("2A:00|00|08:00|81:12:60|81:01:64|81:12:61"),
    words=Words(
        "{name} takes {bytes}, and {first} takes {others}: the later one destroys the other",
        "store them in variables that do not overlap",
    ),
)
OVERWRITTEN = _code(
    "W402",
    "a result that is overwritten before it is read",
    """
    Two operations store their results in the same place of the global memory, and the first one is not read
    in between. The reply has only the last one.
    """,
    _sized("2A:00|00|04:00|81:01:60|81:02:60"),
    _sized("2A:00|00|08:00|81:01:60|81:02:64"),
    words=Words(
        "{name} is stored in {variable}, like {first} before: the reply has only the last",
        "store them in different variables",
    ),
)
UNWANTED_GLOBALS = _code(
    "W403",
    "global memory in a command without a reply",
    """
    The reply carries the global memory. This command does not want a reply (type 0x80), and none of its operations
    uses the global memory.
    """,
    _sized("2A:00|80|04:00|82:1B:01"),
    _sized("2A:00|80|00:00|82:1B:01"),
    words=Words(
        "the header requests {asked} of global memory, which no operation uses and no reply carries",
        f"request none, or use type 0x{MessageType.DIRECT_COMMAND_REPLY:02X}",
    ),
)
NO_REPLY = _code(
    "W404",
    "results without a reply",
    """
    The command stores results in global memory, which a reply would carry. But its type does not ask for a reply,
    and no operation of the command itself uses them.

    With type 0x00 the brick answers. Results that are not needed belong in local memory.
    """,
    _sized("2A:00|80|04:00|81:01:60"),
    VOLTAGE,
    words=Words(
        "{storing} stores {result} in {variable}, which only a reply carries, but the type does not ask for one",
        f"use type 0x{MessageType.DIRECT_COMMAND_REPLY:02X}, or store it in local memory",
    ),
)
UNWRITTEN = _code(
    "W406",
    "a local variable that nothing writes",
    """
    All local memory is zero when a command starts, and only the command itself can write it. It reads a local variable
    that none of its operations writes, so the value is always 0, or an empty text, which is not a legal value here.
    """,
    _sized("2A:00|00|04:04|D3:01:40:60"),
    _sized("2A:00|00|04:04|30:02:40|D3:01:40:60"),
    words={
        "": Words("no operation writes {variable}, so {name} is always 0", "use {legal}, or write the variable first"),
        "text": Words(
            "no operation writes {variable}, so {name} is an empty text", "use a text, or write the variable first"
        ),
    },
)
UNALIGNED = _code(
    "W405",
    "a misaligned variable that the firmware accepts",
    """
    After a count of parameters the firmware no longer checks the alignment of variables, and for a few parameters
    it checks the wrong type. The processor still needs numbers of 16 bits at even indexes and those of 32 bits and
    floats at multiples of 4; elsewhere it may read and write the wrong bytes.
    """,
    _sized("2A:00|00|05:00|99:1D:00:00:00:3F:01:61"),
    _sized("2A:00|00|04:00|99:1D:00:00:00:3F:01:60"),
    words=Words(
        "{name} is {variable}, and must start at a multiple of {step}, though the firmware does not check it here",
        "use a multiple of {multiple}",
    ),
)
RESULT_IN_LOCAL = _code(
    "W407",
    "a result that the reply does not carry",
    """
    A reply carries the global memory, and nothing else: what an operation stores in local memory is gone when the
    command has ended. A variable is local from 40 (LV0) on, and global from 60 (GV0) on; the header requests memory of
    both.
    """,
    _sized("2A:00|00|04:10|81:01:40"),
    VOLTAGE,
    words=Words(
        "{name} goes to {variable}, a local variable; a reply carries only global memory",
        "use {other}, and request {bytes} of global memory",
    ),
)
UNUSED_MEMORY = _code(
    "H401",
    "unused memory",
    """
    The header requests more memory than the operations use. Every reply carries the whole global memory, used
    or not.
    """,
    _sized("2A:00|00|20:00|81:01:60"),
    VOLTAGE,
    words={
        "": Words("the header requests {asked} of {scope} memory, but the operations use only {end}", "request {end}"),
        "none": Words("the header requests {asked} of {scope} memory, but none are used", "request 0"),
    },
)

PARTLY_WRITTEN = _code(
    "H402",
    "bytes of the reply that no operation writes",
    """
    INPUT_READ writes one byte, a percentage; the reply has room for four. A program that reads them as a float gets a
    meaningless number: global memory is not cleared, so the other bytes are those of earlier commands. INPUT_READSI
    writes a float; so does INPUT_DEVICE.READY_SI, while READY_PCT writes a byte.
    """,
    _sized("2A:00|00|04:00|9A:00:00:00:3F:60"),
    _sized("2A:00|00|04:00|9D:00:00:00:3F:60"),
    words=Words(
        "{owner} writes one byte; bytes {first} to {last} of the reply are written by no operation",
        "use {larger} for a float, or read one byte",
    ),
)

# 5: texts and arrays

ARRAY_TOO_SHORT = _code(
    "E501",
    "fewer bytes than announced",
    """
    One parameter gives the number of elements of another, which has fewer. The brick reads on after them: in the
    operations that follow, or in unrelated memory.
    """,
    _sized("2A:00|80|00:00|9F:00:00:08:84:41:42:00"),
    _sized("2A:00|80|00:00|9F:00:00:02:84:41:42:00"),
    words={
        "number": Words(
            "{length} says that {name} has {stated}, but it is a single number",
            "write the bytes as a text, or a variable that holds them",
        ),
        "bytes": Words(
            "{length} says that {name} has {stated}, but it has {present}, including its zero",
            "[set {length} to {count}, or ]add the missing bytes, up to {stated}",
        ),
    },
)
NAME_TOO_LONG = _code(
    "E502",
    "a text that is too long",
    """
    The firmware has a buffer of fixed size for this text and its zero. It refuses a longer text when it runs the
    operation: a path has at most 119 characters, the name of a brick 118, that of a mailbox 49.
    """,
    _sized("2A:00|80|00:00|94:02:01:84:" + "61:" * 120 + "00"),
    _sized("2A:00|80|00:00|94:02:01:84:" + "61:" * 119 + "00"),
    words={Wrong.LONG: Words("{name} has {characters}; the firmware accepts at most {most}", "shorten it by {over}")},
)
NO_HANDLE = _code(
    "W502",
    "a handle of nothing",
    """
    A handle is the number of an open file or an array, valid only in the command that made it: all are closed and
    deleted when the command has ended. No operation before this one makes such a handle, so it fails, and so does the
    command. Open, read and close a file in one command. To read a whole file, use the system commands BEGIN_UPLOAD
    and CONTINUE_UPLOAD, whose handles remain.
    """,
    _sized("2A:00|00|00:00|C0:07:01"),
    _sized("2A:00|00|08:00|C0:01:84:61:00:64:60:C0:07:64"),
    words={
        Role.FILE: Words(
            "no operation before {owner} opens a file: handles end with their command",
            "open the file in the same command, and use the handle that it gives",
        ),
        Role.ARRAY: Words(
            "no operation before {owner} creates an array: handles end with their command",
            "create the array in the same command, and use the handle that it gives",
        ),
        "number": Words(
            "{name} is {number}, but the command has only {handles}",
            "use the variable in which the handle was stored",
        ),
    },
)
REFUSED_LETTER = _code(
    "W503",
    "a character that the firmware refuses",
    """
    The text may contain only certain characters: letters from A to Z, digits, _ and - in the name of a brick. The
    firmware refuses others when it runs the operation, and the command ends with an error.
    """,
    _sized("2A:00|00|00:00|D4:08:84:41:20:42:00"),
    _sized("2A:00|00|00:00|D4:08:84:41:5F:42:00"),
    words=Words("{name} contains {letter!r}, which the firmware refuses", "use letters, digits, _ and -"),
)
REST_UNUSED = _code(
    "W501",
    "more bytes than announced",
    """
    One parameter gives the number of elements of another, which has more. The brick ignores the rest.
    """,
    _sized("2A:00|80|00:00|9F:00:00:01:84:41:42:00"),
    _sized("2A:00|80|00:00|9F:00:00:02:84:41:42:00"),
    words=Words(
        "{length} says that {name} has {stated}, but it has {present}",
        "[set {length} to {count}, or ]omit the last {rest}",
    ),
)

# 6: the way through the code

JUMP_OUT = _code(
    "E601",
    "a jump out of the code",
    """
    A jump distance is counted from the end of the jump. This one leads beyond the end of the command or before its
    first operation, where the brick runs whatever bytes it finds. A jump to the very end is fine: it ends the
    command.
    """,
    _sized("2A:00|80|01:00|41:60:05:01"),
    _sized("2A:00|80|01:00|41:60:01:01"),
    words=Words(
        f"{{name}} is {{value}}, which leads to offset {{target}}, but the operations are at {COMMAND_HEADER_SIZE} to"
        " {last}",
        "use {start} to jump to the first operation, or {end} to jump to the end, counted from the end of the"
        " jump[, and write it as {form}]",
    ),
)
JUMP_INTO = _code(
    "E602",
    "a jump into the middle of an operation",
    """
    A jump distance is counted from the end of the jump. No operation starts where this one leads: the brick would
    take an argument for an opcode.
    """,
    _sized("2A:00|80|01:00|41:60:01:82:1B:01"),
    _sized("2A:00|80|01:00|41:60:03:82:1B:01"),
    words=Words(
        "{name} is {value}, which leads to offset {target}, into the middle of {inside}",
        "use {start} to run {inside}, or {end} to skip it[, and write it as {form}]",
    ),
)
NO_SUCH_LABEL = _code(
    "E603",
    "a jump to a missing label",
    """
    LAB1 with 1 to 31 names a label, which LABEL sets. Without a LABEL the brick jumps by the value it has stored for
    that number, which may be left from an earlier command. Other numbers are distances in bytes.
    """,
    _sized("2A:00|80|01:00|41:60:A0:01:01"),
    _sized("2A:00|80|01:00|41:60:A0:01:01:0D:01"),
    words=Words("{name} names label {value}, which no LABEL sets", "put LABEL {value} at the target of the jump"),
)
UNREACHABLE = _code(
    "W601",
    "operations that never run",
    """
    This code is unreachable: before it is a jump that is always taken, or RETURN, and nothing jumps to it.
    """,
    _sized("2A:00|80|00:00|40:03:82:1B:01:01"),
    _sized("2A:00|80|01:00|41:60:03:82:1B:01:01"),
    words=Words("{owner} never runs[, nor do the operations up to {last}]", "omit it, or jump to it"),
)
ENDLESS = _code(
    "W602",
    "an endless loop",
    """
    From here on the command never ends: every path leads back. The brick answers only when a command has
    ended, and runs no other direct command until then.
    """,
    _sized("2A:00|80|00:00|82:1B:01:40:3B"),
    _sized("2A:00|80|01:00|82:1B:01:41:60:3A"),
    words=Words(
        "from {owner} at offset {at} on, every path leads back: the command never ends",
        "end the loop by a condition, or repeat the command from outside",
    ),
)
FOREIGN_OBJECT = _code(
    "W603",
    "an operation of compiled programs",
    """
    The operation acts on the objects of its own program. A direct command is a program with a single object, number
    1, which has no caller: there are no others to start, to call or to return to.
    """,
    _sized("2A:00|80|00:00|05:02"),
    _sized("2A:00|80|00:00|04:01"),
    words=Words("{owner} acts on objects of a compiled program, but a direct command has only itself", "omit it"),
)
JUMP_UNKNOWN = _code(
    "W604",
    "a jump that may lead anywhere",
    """
    The distance of this jump is in a variable, or behind a handle or an address. The brick accepts it, and what runs
    then depends on numbers outside the code. Read-only proxies and replay refuse such a command.
    """,
    _sized("2A:00|80|04:00|40:60"),
    _sized("2A:00|80|01:00|41:60:00"),
    words=Words(
        "{name} is not a constant, so the target of {owner} is unknown",
        "jump by a constant, or by one condition per target",
    ),
)
NEEDLESS_END = _code(
    "H601",
    "an unneeded OBJECT_END",
    """
    The firmware appends an OBJECT_END to every direct command itself. A second one does no harm.
    """,
    _sized("2A:00|80|00:00|82:1B:01:0A"),
    _sized("2A:00|80|00:00|82:1B:01"),
    words=Words("the firmware adds an OBJECT_END here itself", "omit it"),
)

# 7: sounds, drawings, moves

SOUND_INTERRUPTED = _code(
    "W701",
    "a sound that the next one interrupts",
    f"""
    SOUND starts a sound and returns at once; the next one ends it. Of several in a row, only the last is heard.
    Put {opcode("SOUND_READY")}, which waits until the sound has ended, or a timer between them.
    """,
    _sized("2A:00|80|00:00|94:01:01:82:06:01:82:F4:01|94:01:01:82:4A:01:82:F4:01"),
    _sized("2A:00|80|00:00|94:01:01:82:06:01:82:F4:01|96|94:01:01:82:4A:01:82:F4:01"),
    words=Words(
        "{other} at offset {at} interrupts this sound as soon as it starts",
        f"put {opcode('SOUND_READY')} after it, which waits until the sound has ended",
    ),
)
NOT_SHOWN = _code(
    "W702",
    "a drawing that is not shown",
    """
    Operations draw on a canvas. UI_DRAW.UPDATE (84:00) makes it visible, but does not come after this
    one.
    """,
    _sized("2A:00|80|00:00|84:02:01:05:05"),
    _sized("2A:00|80|00:00|84:02:01:05:05:84:00"),
    words=Words(
        "{owner} draws on the canvas, but the canvas is not shown",
        "put UI_DRAW.UPDATE (84:00) after the last drawing, unless a later command shows it",
    ),
)
PICTURE_REPLACED = _code(
    "W703",
    "a picture that the next one replaces at once",
    """
    The display shows what was drawn, and the next drawing replaces it. Nothing waits in between, so the first
    picture is visible for only a few milliseconds. TIMER_WAIT and TIMER_READY leave time to see it.
    """,
    _sized("2A:00|80|00:00|84:02:01:05:05:84:00|84:01:84:00"),
    _sized("2A:00|80|00:10|84:02:01:05:05:84:00|85:1F:40:86:40|84:01:84:00"),
    words=Words(
        "{wiping} and {other} at offset {at} replace this picture at once",
        "wait in between, with TIMER_WAIT and TIMER_READY",
    ),
)
MOVE_INTERRUPTED = _code(
    "W704",
    "a move that the next one ends",
    f"""
    A move of motors starts and returns at once, and the next operation that moves or stops the same motors ends
    it. Put {opcode("OUTPUT_READY")}, which waits until the move has ended, or a timer between them.
    """,
    _sized("2A:00|80|00:00|AE:00:01:1E:00:82:68:01:00:01|AE:00:01:22:00:82:68:01:00:01"),
    _sized("2A:00|80|00:00|AE:00:01:1E:00:82:68:01:00:01|AA:00:01|AE:00:01:22:00:82:68:01:00:01"),
    words=Words(
        "{other} at offset {at} ends this move as soon as it starts",
        f"put {opcode('OUTPUT_READY')} after it, which waits until the motors are done",
    ),
)

SUFFIX_ADDED = _code(
    "W705",
    "a file name with the suffix that the firmware adds",
    """
    The firmware adds .rsf to every name of a sound file. With the suffix in the name it looks for a file such as
    hello.rsf.rsf, finds none, plays nothing, and stays busy. The reply does not report that.
    """,
    _sized("2A:00|80|00:00|94:02:01:84:68:2E:72:73:66:00"),
    _sized("2A:00|80|00:00|94:02:01:84:68:00"),
    words=Words("{name} ends in {suffix}, and the firmware adds {suffix} to every name", "omit it: {bare}"),
)
NOT_STARTED = _code(
    "H701",
    "a power or a speed that starts no motor",
    f"""
    OUTPUT_POWER and OUTPUT_SPEED set how motors run; {opcode("OUTPUT_START")} makes them run. A motor that runs
    already by the same of the two takes a new one at once. Only `check` of a single frame says so, since another
    command may start it.
    """,
    _sized("2A:00|80|00:00|A5:00:01:1E"),
    _sized("2A:00|80|00:00|A5:00:01:1E:A6:00:01"),
    alone=True,
    words=Words(
        "{owner} starts no motor: it sets what OUTPUT_START starts them with",
        f"put {opcode('OUTPUT_START')} after it, unless the motors run already or a later command starts them",
    ),
)
WRONG_KIND_OF_PORT = _code(
    "H702",
    "the number of a port, or a bit mask",
    """
    Most operations on motors take a bit mask of ports: A is 1, B is 2, C is 4, D is 8. OUTPUT_READ, OUTPUT_GET_COUNT
    and OUTPUT_SET_TYPE take the number of one port: A is 0, B is 1, C is 2, D is 3. 1 and 2 are legal in both and mean
    different ports. Only `check` of a single frame says so.
    """,
    _sized("2A:00|00|04:00|B3:00:01:60"),
    _sized("2A:00|00|04:00|B3:00:00:60"),
    alone=True,
    words={
        NO_PORTS: Words(
            "{name} is 0, a bit mask without a port, so {owner} does nothing", "use {ports}, or the sum of several"
        ),
        "number": Words(
            "{name} is {number}, the number of port {port}; as a bit mask it would be {other}",
            "use {meant} if port {other} is meant: {owner} takes the number of one port",
        ),
    },
)

PORT_OF_NEXT_BRICK = _code(
    "H703",
    "a sensor port of the next brick",
    """
    Sensor ports are printed 1 to 4 on the brick, and have the numbers 0 to 3. Number 4 is port 1 of the next brick of a
    daisy chain; without one, there is no value. Only `check` of a single frame says so.
    """,
    _sized("2A:00|00|04:00|9D:00:04:00:3F:60"),
    _sized("2A:00|00|04:00|9D:00:03:00:3F:60"),
    alone=True,
    words=Words(
        "{name} is {number}, port 1 of the next brick in a daisy chain: ports are counted from 0",
        "use {before} if port {number} of this brick is meant",
    ),
)

RAW_PERCENT = _code(
    "H708",
    "a power or a speed that looks like a raw number",
    """
    A byte from 20 to 3F is a number from -32 to -1, so a raw 50 (32 in hex) drives backward with 14 %. Numbers from 32
    on need an identification byte: 50 is written 81 32. No byte is a round number both ways: -10 is 36, a raw 54. Only
    `check` of a single frame says so.
    """,
    _sized("2A:00|80|00:00|A5:00:01:32:A6:00:01"),
    _sized("2A:00|80|00:00|A5:00:01:81:32:A6:00:01"),
    alone=True,
    words=Words("{name} is {number} %, backward: that is what {byte} by itself means", "{meant} is written 81 {byte}"),
)

READ_AFTER_MOVE = _code(
    "H704",
    "a count that a move has taken back",
    f"""
    OUTPUT_READ counts within a phase of a move, and each phase takes its angle off the count when it ends. So after a
    move that brakes it is about 0, and after one that coasts it is how far the motor ran on. The angle that a motor has
    turned is what {opcode("OUTPUT_GET_COUNT")} reads; {opcode("OUTPUT_CLR_COUNT")} sets it to 0.
    """,
    _sized("2A:00|00|08:00|AE:00:01:1E:00:82:68:01:00:01|AA:00:01|A8:00:00:64:60"),
    _sized("2A:00|00|04:00|AE:00:01:1E:00:82:68:01:00:01|AA:00:01|B3:00:00:60"),
    words=Words(
        "{move} at offset {at} takes its angle off this count: after the move it is about 0, or how far the motor ran"
        " on",
        f"use {opcode('OUTPUT_GET_COUNT')} for the angle that the motor has turned",
    ),
)
OTHER_DRIVE = _code(
    "H705",
    "a speed for a motor that runs by power",
    f"""
    {opcode("OUTPUT_START")} makes a motor run by the power or by the speed that was set last. From then on only the
    same of the two changes it at once; the other one is remembered, until {opcode("OUTPUT_STOP")} and another
    OUTPUT_START.
    """,
    _sized("2A:00|80|00:00|A4:00:01:1E|A6:00:01|A5:00:01:0A"),
    _sized("2A:00|80|00:00|A5:00:01:1E|A6:00:01|A5:00:01:0A"),
    words=Words(
        "the motor runs by {other} at offset {at}, which {owner} does not change",
        f"use {{opcode}}, or {opcode('OUTPUT_STOP')} before, and {opcode('OUTPUT_START')} after it",
    ),
)
MAY_WAIT_FOREVER = _code(
    "H706",
    "a wait for a sound file that may be missing",
    f"""
    A sound file that is missing or empty makes no sound, and never ends: {opcode("SOUND_READY")} waits until BREAK,
    or until another sound has ended, and the brick answers nothing meanwhile. The sounds in ui are on every brick.
    """,
    _sized("2A:00|80|00:00|94:02:1E:84:2E:2E:2F:70:72:6A:73:2F:78:00|96"),
    _sized("2A:00|80|00:00|94:02:1E:84:2E:2F:75:69:2F:43:6C:69:63:6B:00|96"),
    words=Words(
        "{owner} never ends if {file!r} is missing on the brick",
        "make sure that the file is there, or leave the wait out",
    ),
)
NOT_TWO_MOTORS = _code(
    "H707",
    "one motor, or more than two, in step",
    """
    OUTPUT_STEP_SYNC and OUTPUT_TIME_SYNC turn two motors in step: one runs as the other does. What a brick does with
    one motor, with three or with four is not known. Each motor by itself takes OUTPUT_STEP_SPEED or OUTPUT_TIME_SPEED.
    """,
    _sized("2A:00|80|00:00|B0:00:01:1E:00:82:68:01:01"),
    _sized("2A:00|80|00:00|B0:00:03:1E:00:82:68:01:01"),
    words=Words(
        "{owner} synchronizes two motors, but {name} has {count}: what that does is unknown",
        "name two motors, such as 6 for B and C",
    ),
)

_GUI = "slot 0 is that of the brick's own menu (GUI_SLOT)"
SLOT_OF_MENU = _code(
    "W706",
    "the slot of the brick's menu",
    """
    Programs run in slots: 0 is the brick's own menu, 1 the user's program, 2 the direct commands. To stop slot 0 stops
    the programs of all slots, the menu, too: the brick is dead until it is restarted. As the menu always runs, nothing
    can be loaded into its slot or started in it.
    """,
    _sized("2A:00|80|00:00|02:00"),
    _sized("2A:00|80|00:00|02:01"),
    words={
        "PROGRAM_STOP": Words(
            f"{_GUI}: to stop it stops every slot, and the brick is dead until it is restarted",
            "use 1, the slot of the user's program",
        ),
        "FILE.LOAD_IMAGE": Words(f"{_GUI}, which runs: nothing is loaded", "use 1, the slot of the user's program"),
        "PROGRAM_START": Words(f"{_GUI}, which runs: nothing is started", "use 1, the slot of the user's program"),
    },
)
OTHER_SLOT = _code(
    "W707",
    "a program started in another slot",
    """
    FILE.LOAD_IMAGE loads a program into a slot, with the folder of its files. PROGRAM_START starts it there: in the
    same slot, which is 1 for a user's program. Slot 2 is that of direct commands.
    """,
    _sized("2A:00|80|00:20|C0:08:01:84:61:00:40:44|03:02:40:44:00"),
    _sized("2A:00|80|00:20|C0:08:01:84:61:00:40:44|03:01:40:44:00"),
    words=Words(
        "the program was loaded into slot {loaded}, and is started in slot {slot}", "start it in slot {loaded}"
    ),
)
STARTED_UNLOADED = _code(
    "W708",
    "a program that was not loaded",
    """
    PROGRAM_START takes the address of a program, which FILE.LOAD_IMAGE has returned. With the address 0 nothing
    happens, and the brick reports no error. Local memory is new in each command; global memory keeps what an earlier
    one stored.
    """,
    _sized("2A:00|80|00:00|03:01:00:00:00"),
    _sized("2A:00|80|00:20|C0:08:01:84:61:00:40:44|03:01:40:44:00"),
    words=Words(
        "{name} is 0: no program was loaded, so nothing is started",
        "put FILE.LOAD_IMAGE before it, and use the variables in which it stores SIZE and {name}",
    ),
)
OTHER_RESULT = _code(
    "W709",
    "a result of FILE.LOAD_IMAGE in another place",
    """
    FILE.LOAD_IMAGE stores the size of a program, then its address. PROGRAM_START takes the slot, the size and the
    address, in this order. It does not check the address: what it starts elsewhere is unknown.
    """,
    _sized("2A:00|80|00:20|C0:08:01:84:61:00:40:44|03:01:44:40:00"),
    _sized("2A:00|80|00:20|C0:08:01:84:61:00:40:44|03:01:40:44:00"),
    words=Words("{name} is the variable in which FILE.LOAD_IMAGE stores {result}", "give the slot, then SIZE, then IP"),
)

# 8: system messages, and messages between bricks

UNKNOWN_SYSTEM = _code(
    "E801",
    "an unknown system command",
    """
    The byte after the type is the system command; the firmware knows 0x92 to 0xA2, the firmware updater 0xF0 to
    0xF6. It does not answer any other number.
    """,
    _frame("04:00|2A:00|01|42"),
    _frame("04:00|2A:00|01|9D"),
    words={
        "": Words("unknown system command 0x{number:02X}", "use {known}"),
        "cut off": Words("the frame ends before the number of the system command", "add the number"),
    },
)
WRONG_FIELDS = _code(
    "E802",
    "fields that do not fit",
    """
    A system command has fields of fixed kinds, one after the other up to the end of the frame. Here a field is cut
    short, bytes are left over, or a length does not match the field after it. The firmware does not check that: it
    reads what it finds, even beyond the end.
    """,
    _frame("06:00|2A:00|01|95:00:10"),
    _frame("07:00|2A:00|01|95:00:10:00"),
    words=Words("{owner}: {reason}", "fields of the command: {expected}"),
)
REFUSED_PATH = _code(
    "E803",
    "a path that the firmware refuses",
    """
    The firmware splits a path into folder, name and extension, with a limited buffer for each, including the zero:
    120 bytes for all, 84 for the folder with its slash, 32 for the name up to its first dot, 5 for the extension
    with its dot. It refuses to open a file with a longer one, and answers NO_HANDLES_AVAILABLE.
    """,
    _sized("2A:00|01|92:01:00:00:00:" + "".join(f"{byte:02X}:" for byte in b"../prjs/x/program.script") + "00"),
    _sized("2A:00|01|92:01:00:00:00:" + "".join(f"{byte:02X}:" for byte in b"../prjs/x/program.rbf") + "00"),
    words={
        "": Words("the {part} has {characters}; the firmware accepts at most {most}", "shorten {what} by {over}"),
        "empty": Words("the path of {owner} is empty", "name a file or folder"),
    },
)
FIELD_TOO_LONG = _code(
    "E804",
    "a field that is too long for the firmware",
    """
    The firmware copies the field into a buffer of fixed size. This field does not fit.
    """,
    _sized("2A:00|01|A2:" + "41:" * 11 + "00"),
    _sized("2A:00|01|A2:" + "41:" * 10 + "00"),
    words=Words("{name} has {bytes}, but the firmware has room for only {most}", "shorten it by {over}"),
)
WRONG_CARRIER = _code(
    "E805",
    "a command that this carrier cannot transport",
    """
    Commands of the firmware updater, and BLUETOOTHPIN, reach the brick only by USB. A check knows the carrier from
    `--carrier`, or from the capture it reads.
    """,
    _frame("04:00|2A:00|01|F6"),
    _frame("04:00|2A:00|01|9D"),
    "wifi",
    words=Words("{owner} reaches the brick only by USB, not by {carrier}", "send it by USB"),
)
UNKNOWN_DAISY = _code(
    "E806",
    "an unknown message between bricks",
    """
    A message in a daisy chain has a sub-command, 0xA0 to 0xA5, then the layer it comes from and the layer it goes to.
    """,
    _frame("06:00|2A:00|0A|42:00:01"),
    _frame("06:00|2A:00|0A|A2:00:01"),
    words=Words(
        "{reason}", f"use a sub-command, 0x{min(DaisySubCommand):02X} to 0x{max(DaisySubCommand):02X}, and two layers"
    ),
)
NEVER_ANSWERED = _code(
    "W801",
    "a reply that never comes",
    """
    The type asks for a reply (0x01), but the brick never replies to this command. A program that waits for one
    waits forever.
    """,
    _frame("04:00|2A:00|01|A0"),
    _frame("04:00|2A:00|81|A0"),
    words=Words(
        "the type asks for a reply, but the brick never replies to {owner}",
        f"use type 0x{MessageType.SYSTEM_COMMAND_NO_REPLY:02X}, and do not wait",
    ),
)
ANSWER_NEEDED = _code(
    "W802",
    "a query without a reply",
    """
    The purpose of this command is its reply: it has the handle for the next commands, or the requested contents.
    The type (0x81) does not ask for one.
    """,
    _frame("04:00|2A:00|81|9D"),
    _frame("04:00|2A:00|01|9D"),
    words={
        "": Words(f"{_UNASKED} the requested contents", f"use type 0x{MessageType.SYSTEM_COMMAND_REPLY:02X}"),
        "handle": Words(
            f"{_UNASKED} the handle for the next commands", f"use type 0x{MessageType.SYSTEM_COMMAND_REPLY:02X}"
        ),
    },
)
LONG_DAISY = _code(
    "W803",
    "a message too long for a report between bricks",
    """
    Bricks of a daisy chain exchange USB reports of 64 bytes; a longer frame does not fit.
    """,
    _sized("2A:00|8A|A0:00:01|" + "01:" * 56 + "01"),
    _sized("2A:00|8A|A0:00:01|" + "01:" * 55 + "01"),
    words=Words(
        f"the frame has {{size}} bytes, but a report between bricks carries {REPORT_SIZES[0]}",
        "send less data per frame",
    ),
)
MAILBOX_TOO_SMALL = _code(
    "W804",
    "more than a mailbox holds",
    """
    A mailbox has a name of at most 49 characters and holds 250 bytes. The firmware checks neither: a message to a
    longer name is dropped, since no mailbox has it, and a longer message overwrites the next mailbox.
    """,
    _sized("2A:00|81|9E:02:61:00:FB:00:" + "61:" * 250 + "00"),
    _sized("2A:00|81|9E:02:61:00:FA:00:" + "61:" * 249 + "00"),
    words={
        MAILBOX_NAME: Words(
            f"the name has {{size}} characters; that of a mailbox has at most {mailboxes.MOST_NAME}",
            f"use a name of at most {mailboxes.MOST_NAME} characters",
        ),
        MAILBOX_CONTENT: Words(
            f"the message has {{size}} bytes, but a mailbox has room for only {mailboxes.MOST_CONTENT}",
            f"send at most {mailboxes.MOST_CONTENT} bytes",
        ),
    },
)
TEXT_WITHOUT_ZERO = _code(
    "W805",
    "a message that looks like a text without its zero",
    """
    A text in a mailbox ends with a zero, which is part of the message and counted. The firmware copies a message
    over the last one and does not clear the rest. Without the zero, a program that reads the text also gets the end
    of an earlier, longer message.
    """,
    _sized("2A:00|81|9E:02:61:00:02:00:68:69"),
    _sized("2A:00|81|9E:02:61:00:03:00:68:69:00"),
    words=Words(
        "the message looks like a text without a zero at its end",
        "add a zero, and count it in the length of the message",
    ),
)

NUMBER_OF_ANOTHER_TYPE = _code(
    "W806",
    "a number of another type in a mailbox",
    """
    A number in a mailbox is a float of four bytes, little-endian: a single. Programs for EV3 read integers, doubles and
    numbers in network order as something else, mostly as zero.
    """,
    _sized("2A:00|81|9E:04:61:62:63:00:04:00:0A:00:00:00"),
    _sized("2A:00|81|9E:04:61:62:63:00:04:00:00:00:20:41"),
    words=Words(
        "the message is {value:g} as {kind}; a program reads a number as a float of 4 bytes, little-endian",
        "send {bytes} for {value:g}",
    ),
)
FILE_TOO_LARGE = _code(
    "W807",
    "a file larger than the brick's memory",
    """
    BEGIN_DOWNLOAD announces a size that is more than the flash memory of a brick has. The brick answers SIZE_ERROR,
    or waits for the rest. Often the four bytes are in the wrong order: the low one comes first.
    """,
    _sized("2A:00|01|92:00:00:04:D2:61:2E:72:62:66:00"),
    _sized("2A:00|01|92:D2:04:00:00:61:2E:72:62:66:00"),
    words=Words(
        f"{{name}} is {{value}}, but the flash memory of a brick has {FLASH_SIZE} bytes",
        "send the size of the file, the low byte first",
    ),
)

# 9: encodings

LONGER_FORM = _code(
    "H901",
    "an encoding longer than needed",
    """
    The same value fits a shorter encoding. Both mean the same; the shorter one leaves more room in the frame.

    Constants: LC0 for -32 to 31, LC1 to +-127, LC2 to +-32767, LC4 beyond. Variables: LV0 and GV0 up to 31, LV1
    and GV1 up to 255, LV2 and GV2 up to 65535.
    """,
    _sized("2A:00|80|00:00|94:01:81:05:82:B8:01:82:E8:03"),
    _sized("2A:00|80|00:00|94:01:05:82:B8:01:82:E8:03"),
    words=Words(
        "{name} is {encoding}, but its value fits {bytes}",
        "write it as {shorter}[, and shorten jumps over it by {saved}]",
    ),
)


OF_VALUES = {wrong: entry for entry in CODES.values() for wrong in entry.words if isinstance(wrong, Wrong)}
"""The code of each thing that is wrong with a value. A count has none: the rules on lists word it."""
