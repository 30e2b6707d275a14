"""Every code that a check can give: its severity, its explanation, a frame that raises it and one that does not.

Codes are stable: a tool may rely on `E301`. The first digit tells what it is about: 1 the frame, 2 operations,
3 values, 4 memory, 5 texts and arrays, 6 the way through the code, 7 sounds, drawings and moves, 8 system messages and
those from brick to brick, 9 encodings.
"""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.checking.report import Finding, Severity
from ev3proto.schema.header import with_length
from ev3proto.tables import operations


class Code(NamedTuple):
    """One code.

    code            `E301`: E for errors, W for warnings, H for hints
    severity        how bad it is
    title           what it is, in a few words
    explanation     what happens on the brick, why, and what to do; paragraphs with an empty line between them
    example         a frame that raises it
    counterexample  nearly the same frame, which does not
    carrier         what has to carry them for that, None where it does not matter
    """

    code: str
    severity: Severity
    title: str
    explanation: str
    example: bytes
    counterexample: bytes
    carrier: str | None = None

    def finding(
        self,
        offset: int,
        length: int,
        message: str,
        help_: str,
        operation: str | None = None,
        parameter: str | None = None,
    ) -> Finding:
        """One that was found; parameters as those of `Finding`."""
        return Finding(self.severity, self.code, offset, length, message, help_, operation, parameter)


CODES: dict[str, Code] = {}
"""The codes by their names, in their order."""

_SEVERITIES = {severity.value[0].upper(): severity for severity in Severity}


def _code(
    code: str, title: str, explanation: str, example: bytes, counterexample: bytes, carrier: str | None = None
) -> Code:
    entry = CODES[code] = Code(code, _SEVERITIES[code[0]], title, explanation.strip(), example, counterexample, carrier)
    return entry


def _frame(text: str) -> bytes:
    """A frame whose length field is what it is, written as the lesson does: `0E:00|2A:00|80|...`."""
    return bytes.fromhex(text.replace("|", "").replace(":", ""))


def _sized(text: str) -> bytes:
    """The same from the counter on; the length field is worked out."""
    return with_length(_frame(text))


def opcode(name: str) -> str:
    """How texts name an operation without a CMD, so that its byte can be found in a frame: `NOP (0x01)`."""
    return f"{name} (0x{operations()[name].opcode.number:02X})"


TONE = _sized("2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03")
VOLTAGE = _sized("2A:00|00|04:00|81:01:60")

# 1: the frame

TOO_SHORT = _code(
    "E101",
    "too short for a frame",
    """
    A frame starts with five bytes: two of length, two of the message counter, one of the type. A direct command
    has two more, which ask for memory. Here the bytes end before that, so nobody knows what they are.
    """,
    _frame("03:00|2A:00"),
    VOLTAGE,
)
INCOMPLETE = _code(
    "E102",
    "the frame ends too early",
    """
    The length field counts the bytes that follow it. It says that there are more than there are.

    On Bluetooth and WiFi the brick goes on waiting, and takes the start of the next frame for the missing
    bytes. On USB it reads on in its buffer, where the last report has left something.
    """,
    _frame("0E:00|2A:00|80|00:00|94:01:01:82:B8:01"),
    TONE,
)
LEFT_OVER = _code(
    "E103",
    "the frame goes on after its end",
    """
    The length field counts the bytes that follow it. There are more, and the brick does not look at those: on
    USB it drops them, on Bluetooth and WiFi it takes them for the start of the next frame, and all that follows
    is lost.
    """,
    _frame("08:00|2A:00|80|00:00|82:1B:02:82:1B:01"),
    _frame("0B:00|2A:00|80|00:00|82:1B:02:82:1B:01"),
)
TOO_LONG = _code(
    "E104",
    "longer than any frame may be",
    """
    A frame has 1024 bytes at most, its length field included. That is the size of the firmware's buffers and of
    one USB report. A long job must be cut into several commands.

    BEGIN_DOWNLOAD and CONTINUE_DOWNLOAD may be longer on Bluetooth and WiFi: the firmware takes their data in
    pieces. `--carrier usb` says that they are to go by USB.
    """,
    _sized("2A:00|80|00:00|" + "01:" * 1017 + "01"),
    _sized("2A:00|80|00:00|" + "01:" * 1016 + "01"),
)
UNKNOWN_TYPE = _code(
    "E105",
    "an unknown message type",
    """
    The byte after the message counter says what kind of message it is. There are twelve; a brick is sent
    direct commands (0x00 with a reply, 0x80 without) and system commands (0x01 and 0x81).
    """,
    _frame("06:00|2A:00|40|00:00|01"),
    _frame("06:00|2A:00|80|00:00|01"),
)
EMPTY = _code(
    "E106",
    "a command without operations",
    f"""
    The firmware refuses a direct command that ends with its header. To see whether the brick answers, send
    {opcode("NOP")}.
    """,
    _frame("05:00|2A:00|00|00:00"),
    _frame("06:00|2A:00|00|00:00|01"),
)
REFUSED_MEMORY = _code(
    "E107",
    "more global memory than the firmware grants",
    """
    The header has ten bits for the size of the global memory, so it can ask for 1023 bytes. The firmware grants
    1021 and refuses a command that asks for more. A reply has room for 1019.
    """,
    _sized("2A:00|00|FF:03|81:01:60"),
    VOLTAGE,
)
NO_COMMAND = _code(
    "W101",
    "a reply, not a command",
    """
    This is what a brick sends. A check is about what a brick is sent, so there is nothing to say about this
    frame; to read it, use `ev3proto decode`.
    """,
    _frame("03:00|2A:00|02"),
    VOLTAGE,
)
LONG_REPLY = _code(
    "W102",
    "a reply that is longer than a frame",
    """
    A reply carries the whole global memory after five bytes of its own, and a frame has 1024 bytes at most.
    The firmware grants two bytes of global memory more than that leaves room for.
    """,
    _sized("2A:00|00|FC:03|81:03:81:7F:60"),
    _sized("2A:00|00|7F:00|81:03:81:7F:60"),
)
PADDING = _code(
    "H101",
    "padding after the frame",
    """
    A USB report always has 1024 bytes; what comes after the frame in it has no meaning. That is right on USB
    and nowhere else: on Bluetooth and WiFi the brick would take the zeros for frames.
    """,
    _frame("06:00|2A:00|80|00:00|01") + bytes(1016),
    _frame("06:00|2A:00|80|00:00|01"),
)

# 2: operations

UNKNOWN_OPCODE = _code(
    "E201",
    "an unknown opcode",
    """
    The firmware's table of opcodes has no entry for this byte, or it is ERROR (0x00), which is never allowed.
    The brick refuses the whole command; nothing of it is run.

    Often the byte was not meant as an opcode: an argument before it is shorter or longer than the sender
    thought, and everything after it is read out of step. Look at the operation before it first.
    """,
    _sized("2A:00|80|00:00|A6:00:01:00"),
    _sized("2A:00|80|00:00|A6:00:01"),
)
AFTER_END = _code(
    "E202",
    "operations after OBJECT_END",
    """
    OBJECT_END ends the code. The firmware stops reading there, finds that this is not where the command ends,
    and refuses it. It puts an OBJECT_END after every direct command by itself, so none is needed.
    """,
    _sized("2A:00|80|00:00|82:1B:02:0A:82:1B:01"),
    _sized("2A:00|80|00:00|82:1B:02:82:1B:01"),
)
CUT_OFF = _code(
    "E203",
    "the last operation is cut off",
    """
    The operations must end exactly where the command ends. This one needs more bytes than there are: an
    argument is missing, a text has no zero, or a list has fewer elements than its count says.

    The firmware reads on after the end, where it finds an OBJECT_END and zeros, and refuses the command
    because the operation ends too late.
    """,
    _sized("2A:00|80|00:00|94:01:01:82:B8:01"),
    TONE,
)
FIRST_OUT_OF_RANGE = _code(
    "E204",
    "a first parameter that its type cannot hold",
    """
    The firmware looks at the value of a constant only in an operation's first parameter, CMD included. One that
    the type cannot hold makes it refuse the command: beyond -127 to 127 for 8 bits, -32767 to 32767 for 16,
    -2147483647 to 2147483647 for 32. The lowest number of each means "not a number" and is refused as well.

    The same mistake in a later parameter goes unnoticed: that is E301.
    """,
    _sized("2A:00|80|00:00|A6:82:2C:01:01"),
    _sized("2A:00|80|00:00|A6:00:01"),
)
MISALIGNED = _code(
    "E205",
    "a misaligned variable",
    """
    A variable of 16 bits must start at an even place of its memory, one of 32 bits or a float at a multiple
    of 4. The firmware checks that before it runs anything, and refuses the whole command. --fix leaves variables where
    they are, because what reads the reply counts on their places; the help names the nearest place that is aligned.
    """,
    _sized("2A:00|00|05:00|81:01:61"),
    VOLTAGE,
)
BAD_LABEL = _code(
    "E206",
    "no label has this number",
    """
    LABEL marks a place for jumps. A program has room for 32 labels, numbered 0 to 31; the firmware refuses
    other numbers.
    """,
    _sized("2A:00|80|00:00|0D:81:20"),
    _sized("2A:00|80|00:00|0D:01"),
)
SPINS = _code(
    "E207",
    "a count that makes the brick spin",
    """
    The operation says how many values follow, and the firmware believes it: it reads that many before it looks
    whether the command has them. It takes the count without its sign, so that -1 is more than four thousand
    million. The brick then does nothing else for minutes, and must be switched off.
    """,
    _sized("2A:00|80|00:04|2F:40:3F:01"),
    _sized("2A:00|80|00:04|2F:40:01:01"),
)
UNKNOWN_CMD = _code(
    "E208",
    "a CMD that the opcode does not have",
    """
    The firmware does not refuse an unknown CMD. It takes it for a command without parameters, so that what was
    meant as arguments is read, and run, as operations. That may be refused further on, or do something that
    nobody meant.
    """,
    _sized("2A:00|80|00:00|94:07:01"),
    _sized("2A:00|80|00:00|94:00:01"),
)
VARIABLE_CMD = _code(
    "E209",
    "a CMD that is no number",
    """
    CMD decides which parameters follow, so it must be a number in the frame itself. Where a variable stands,
    the firmware's validator takes its index for the CMD and the operation itself takes its value; where a text
    stands, CMD is 0.
    """,
    _sized("2A:00|80|00:04|94:41:01:82:B8:01:82:E8:03"),
    TONE,
)
UNDEFINED_FORM = _code(
    "E210",
    "an undefined identification byte",
    """
    The first byte of an argument says how it is encoded. In the long forms, its last three bits say what
    follows; of the eight numbers that they can have the firmware defines five for constants and three for
    variables. For all others it reads no byte at all, and uses whatever number it had read before.
    """,
    _sized("2A:00|80|00:00|A3:00:01:85"),
    _sized("2A:00|80|00:00|A3:00:01:01"),
)
BAD_COUNT = _code(
    "E211",
    "a count that is not a constant number",
    """
    The number of elements in a list must be a constant: 0 to 127 where it counts parameters, anything from 0
    on where it counts values. Where it is not, the firmware takes the list for empty, or the index of a
    variable for the number, and reads the elements as operations.
    """,
    _sized("2A:00|80|00:14|2F:44:40:01"),
    _sized("2A:00|80|00:04|2F:40:01:01"),
)
NEWER = _code(
    "E212",
    "an operation that firmware of 2013 does not know, and refuses",
    """
    LEGO added this CMD later. The firmware of 2013, by whose rules frames are checked here, takes it for a command
    without parameters, reads what follows as operations, and refuses the command there. Newer firmware takes it.
    """,
    _sized("2A:00|00|10:00|81:1D:60:64:68:6C"),
    VOLTAGE,
)
NEWER_ACCEPTED = _code(
    "W201",
    "an operation that firmware of 2013 does not know, but accepts",
    """
    LEGO added this CMD later. The firmware of 2013, by whose rules frames are checked here, takes it for a command
    without parameters, and runs what follows as operations. By chance these are valid.
    """,
    _sized("2A:00|80|00:00|82:12:01"),
    _sized("2A:00|80|00:00|82:1B:01"),
)

# 3: values

TRUNCATED = _code(
    "E301",
    "a constant that is cut down to its type",
    """
    A constant may be encoded in more bytes than the parameter has. The firmware takes the lowest of them and
    drops the rest without a warning: 300 in a parameter of 8 bits is 44. It looks at the value of the first
    parameter only (E204).
    """,
    _sized("2A:00|80|00:00|A3:00:82:2C:01:01"),
    _sized("2A:00|80|00:00|A3:00:01:01"),
)
CONSTANT_OUTPUT = _code(
    "E302",
    "a constant where the brick writes",
    """
    The parameter takes a variable, in which the brick stores a result. It accepts a constant, too, and the
    result is lost; a text is overwritten in the middle of the command.
    """,
    _sized("2A:00|00|00:00|81:01:00"),
    VOLTAGE,
)
NUMBER_FOR_TEXT = _code(
    "E303",
    "a number where the brick reads a text",
    """
    The parameter takes a text (0x84, the characters, a zero) or a variable that holds one. The brick accepts a
    number and reads its bytes, and what happens to stand after them, as characters up to the next zero.
    """,
    _sized("2A:00|80|00:00|94:02:01:05"),
    _sized("2A:00|80|00:00|94:02:01:84:78:00"),
)
TEXT_FOR_NUMBER = _code(
    "E304",
    "a text where the brick reads a number",
    """
    The parameter takes a number. The brick accepts a text and reads its first characters as if they were one:
    "1" is 49.
    """,
    _sized("2A:00|80|00:00|A3:00:84:31:00:01"),
    _sized("2A:00|80|00:00|A3:00:01:01"),
)
INTEGER_FOR_FLOAT = _code(
    "E305",
    "a whole number where the brick reads a float",
    """
    A float is four bytes (0x83 and an IEEE single). The brick takes the bits of whatever constant there is for
    those of a float: the whole number 1 is 0.0000000000000000000000000000000000000000000014 then. Only 0 is the
    same in both.
    """,
    _sized("2A:00|80|00:10|3F:01:40"),
    _sized("2A:00|80|00:10|3F:83:00:00:80:3F:40"),
)
NEGATIVE = _code(
    "W301",
    "a number that the brick reads as a negative one",
    """
    The value fits the bytes of the parameter only without a sign. The firmware drops the upper bytes and reads
    what is left with a sign: 200 in a parameter of 8 bits is -56. Where bits or bytes are meant that is fine;
    write them as the negative number to say so.
    """,
    _sized("2A:00|80|00:04|30:00:40|9F:00:00:01:82:C8:00"),
    _sized("2A:00|80|00:04|30:00:40|9F:00:00:01:81:C8"),
)
NOT_A_NUMBER = _code(
    "W302",
    "a value that means: not a number",
    """
    The lowest number of each type (-128, -32768, -2147483648) and the float 0x7FC00000 say that there is no
    value. Sensors give them; as an argument they are rarely meant. In a first parameter the brick refuses them
    (E204).
    """,
    _sized("2A:00|80|00:00|A4:00:01:81:80"),
    _sized("2A:00|80|00:00|A4:00:01:81:9C"),
)
OUT_OF_RANGE = _code(
    "W303",
    "a value outside the range that is documented",
    """
    The brick takes the command. What it makes of the value depends on the operation: some limit it, some do
    nothing, some do what nobody expects.
    """,
    _sized("2A:00|80|00:00|94:01:01:82:C8:00:82:E8:03"),
    TONE,
)
NO_MEMBER = _code(
    "W304",
    "a number that has no name",
    """
    The parameter takes one of several numbers that have names, such as the patterns of the light. This one is
    none of them.
    """,
    _sized("2A:00|80|00:00|82:1B:1F"),
    _sized("2A:00|80|00:00|82:1B:01"),
)

# 4: memory

BEYOND_LOCALS = _code(
    "E401",
    "a variable beyond the local memory",
    """
    The header asks for a number of bytes of local memory (its upper six bits). This variable lies beyond them,
    in whole or in part. The firmware does not look at that: the operation reads or writes what stands there,
    which belongs to something else.
    """,
    _sized("2A:00|80|00:00|85:82:E8:03:40:86:40"),
    _sized("2A:00|80|00:10|85:82:E8:03:40:86:40"),
)
BEYOND_GLOBALS = _code(
    "E402",
    "a variable beyond the global memory",
    """
    The header asks for a number of bytes of global memory (its lower ten bits), and the reply carries just
    these. This variable lies beyond them, in whole or in part: the reply does not bring its value, and the
    operation overwrites memory that belongs to something else.
    """,
    _sized("2A:00|00|00:00|81:01:60"),
    VOLTAGE,
)
OVERLAP = _code(
    "W401",
    "results that overlap",
    """
    Two results are stored in places that have bytes in common, so that the later one destroys the other. A
    number of 8 bits takes one byte, of 16 two, of 32 and a float four.
    """,
    _sized("2A:00|00|08:00|81:12:60|81:01:64|81:12:65"),
    _sized("2A:00|00|08:00|81:12:60|81:01:64|81:12:61"),
)
OVERWRITTEN = _code(
    "W402",
    "a result that is overwritten before anybody reads it",
    """
    Two operations store their results in the same place of the global memory, and nothing reads the first one
    in between. The reply brings the last one only.
    """,
    _sized("2A:00|00|04:00|81:01:60|81:02:60"),
    _sized("2A:00|00|08:00|81:01:60|81:02:64"),
)
UNWANTED_GLOBALS = _code(
    "W403",
    "global memory in a command that wants no reply",
    """
    Global memory is what the reply carries. This command wants no reply (type 0x80), and none of its operations
    uses the global memory.
    """,
    _sized("2A:00|80|04:00|82:1B:01"),
    _sized("2A:00|80|00:00|82:1B:01"),
)
NO_REPLY = _code(
    "W404",
    "results that no reply carries",
    """
    The command stores results in global memory, which a reply would bring. But its type says that no reply is
    wanted, and no operation of the command itself uses them.

    With type 0x00 the brick answers. Results that nobody needs belong in local memory.
    """,
    _sized("2A:00|80|04:00|81:01:60"),
    VOLTAGE,
)
UNALIGNED = _code(
    "W405",
    "a misaligned variable that the firmware does not notice",
    """
    After a count of parameters the firmware no longer checks where variables lie, and for a few parameters it
    checks the wrong type. The processor still wants numbers of 16 bits at even places and those of 32 bits and
    floats at multiples of 4; elsewhere it may read and write other bytes than were meant.
    """,
    _sized("2A:00|00|05:00|99:1D:00:00:00:3F:01:61"),
    _sized("2A:00|00|04:00|99:1D:00:00:00:3F:01:60"),
)
UNUSED_MEMORY = _code(
    "H401",
    "memory that nothing uses",
    """
    The header asks for more memory than the operations use. Every reply carries the whole global memory, used
    or not.
    """,
    _sized("2A:00|00|20:00|81:01:60"),
    VOLTAGE,
)

# 5: texts and arrays

ARRAY_TOO_SHORT = _code(
    "E501",
    "fewer bytes than the length says",
    """
    One parameter says how many elements the other has, and there are fewer. The brick reads on after them: in
    the operations that follow, or in memory that has nothing to do with it.
    """,
    _sized("2A:00|80|00:00|9F:00:00:08:84:41:42:00"),
    _sized("2A:00|80|00:00|9F:00:00:02:84:41:42:00"),
)
NAME_TOO_LONG = _code(
    "E502",
    "a text that is longer than the firmware allows",
    """
    The firmware has room for a fixed number of bytes of this text, its zero included. It refuses a longer text
    when it comes to the operation: a path has 119 characters at most, the name of a brick 118, that of a mailbox 49.
    """,
    _sized("2A:00|80|00:00|94:02:01:84:" + "61:" * 120 + "00"),
    _sized("2A:00|80|00:00|94:02:01:84:" + "61:" * 119 + "00"),
)
REST_UNUSED = _code(
    "W501",
    "more bytes than the length says",
    """
    One parameter says how many elements the other has, and there are more. The brick does not look at the
    rest.
    """,
    _sized("2A:00|80|00:00|9F:00:00:01:84:41:42:00"),
    _sized("2A:00|80|00:00|9F:00:00:02:84:41:42:00"),
)

# 6: the way through the code

JUMP_OUT = _code(
    "E601",
    "a jump out of the code",
    """
    A jump counts its bytes from the end of the jump itself. This one leads beyond the end of the command or before
    its first operation, where the brick runs whatever bytes it finds. A
    jump to the very end is right: it ends the command.
    """,
    _sized("2A:00|80|00:04|41:40:05:01"),
    _sized("2A:00|80|00:04|41:40:01:01"),
)
JUMP_INTO = _code(
    "E602",
    "a jump into the middle of an operation",
    """
    A jump counts its bytes from the end of the jump itself. No operation starts where this one leads: the
    brick would take an argument for an opcode.
    """,
    _sized("2A:00|80|00:04|41:40:01:82:1B:01"),
    _sized("2A:00|80|00:04|41:40:03:82:1B:01"),
)
NO_SUCH_LABEL = _code(
    "E603",
    "a jump to a label that is not there",
    """
    LAB1 with 1 to 31 names a label, which LABEL sets. Without one the brick jumps by whatever it has stored for
    that label, which may be that of an earlier command. Other numbers are distances in bytes.
    """,
    _sized("2A:00|80|00:04|41:40:A0:01:01"),
    _sized("2A:00|80|00:04|41:40:A0:01:01:0D:01"),
)
UNREACHABLE = _code(
    "W601",
    "operations that are never run",
    """
    No way leads here: a jump that is always taken, or RETURN, stands before it, and nothing jumps to it.
    """,
    _sized("2A:00|80|00:00|40:03:82:1B:01:01"),
    _sized("2A:00|80|00:04|41:40:03:82:1B:01:01"),
)
ENDLESS = _code(
    "W602",
    "a loop without an end",
    """
    Once it gets here, the command never ends: every way leads back. The brick answers only when a command has
    ended, and runs no other direct command until then.
    """,
    _sized("2A:00|80|00:00|82:1B:01:40:3B"),
    _sized("2A:00|80|00:04|82:1B:01:41:40:3A"),
)
FOREIGN_OBJECT = _code(
    "W603",
    "an operation of compiled programs",
    """
    The operation is about the objects of the program that it stands in. A direct command is a program of a
    single object, number 1, which nothing has called: there is no other to start, to call or to return to.
    """,
    _sized("2A:00|80|00:00|05:02"),
    _sized("2A:00|80|00:00|04:01"),
)
JUMP_UNKNOWN = _code(
    "W604",
    "a jump that may lead anywhere",
    """
    How far this jump leads is in a variable, or behind a handle or an address. The brick takes it, and what runs then
    depends on numbers that are not in the code. Read-only proxies and replay do not let such a command through.
    """,
    _sized("2A:00|80|00:04|40:40"),
    _sized("2A:00|80|00:04|41:40:00"),
)
NEEDLESS_END = _code(
    "H601",
    "an OBJECT_END that is not needed",
    """
    The firmware puts an OBJECT_END after every direct command by itself. One more does no harm.
    """,
    _sized("2A:00|80|00:00|82:1B:01:0A"),
    _sized("2A:00|80|00:00|82:1B:01"),
)

# 7: sounds, drawings, moves

SOUND_INTERRUPTED = _code(
    "W701",
    "a sound that the next one cuts off",
    f"""
    SOUND starts a sound and returns at once; the next one ends it. Of several in a row, only the last is heard.
    Put {opcode("SOUND_READY")}, which waits until the sound has ended, or a timer between them.
    """,
    _sized("2A:00|80|00:00|94:01:01:82:06:01:82:F4:01|94:01:01:82:4A:01:82:F4:01"),
    _sized("2A:00|80|00:00|94:01:01:82:06:01:82:F4:01|96|94:01:01:82:4A:01:82:F4:01"),
)
NOT_SHOWN = _code(
    "W702",
    "a drawing that is not shown",
    """
    Operations draw on a canvas. It becomes visible with UI_DRAW.UPDATE (84:00), which does not come after this
    one.
    """,
    _sized("2A:00|80|00:00|84:02:01:05:05"),
    _sized("2A:00|80|00:00|84:02:01:05:05:84:00"),
)
PICTURE_REPLACED = _code(
    "W703",
    "a picture that the next one replaces at once",
    """
    The display shows what was drawn, and what comes next replaces it. Nothing waits in between, so the
    first picture is there for some milliseconds only. TIMER_WAIT and TIMER_READY give people the
    time to see it.
    """,
    _sized("2A:00|80|00:00|84:02:01:05:05:84:00|84:01:84:00"),
    _sized("2A:00|80|00:10|84:02:01:05:05:84:00|85:1F:40:86:40|84:01:84:00"),
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
)

# 8: system messages, and those from brick to brick

UNKNOWN_SYSTEM = _code(
    "E801",
    "an unknown system command",
    """
    The byte after the type is the system command; the firmware has 0x92 to 0xA2, the firmware updater 0xF0 to
    0xF6. It does not answer any other number.
    """,
    _frame("04:00|2A:00|01|42"),
    _frame("04:00|2A:00|01|9D"),
)
WRONG_FIELDS = _code(
    "E802",
    "fields that do not fit",
    """
    A system command has fields of fixed kinds, one after the other up to the end of the frame. Here one of
    them is cut short, bytes are left over, or a length does not say what follows it. The firmware checks none
    of that: it reads what it finds, also beyond the end.
    """,
    _frame("06:00|2A:00|01|95:00:10"),
    _frame("07:00|2A:00|01|95:00:10:00"),
)
REFUSED_PATH = _code(
    "E803",
    "a path that the firmware refuses",
    """
    The firmware takes a path apart into folder, name and extension and has limited room for each, the zero
    included: 120 bytes for all, 84 for the folder with its slash, 32 for the name up to its first dot, 5 for
    the extension with its dot. It gives no handle for a file with a longer one, and says NO_HANDLES_AVAILABLE.
    """,
    _sized("2A:00|01|92:01:00:00:00:" + "".join(f"{byte:02X}:" for byte in b"../prjs/x/program.script") + "00"),
    _sized("2A:00|01|92:01:00:00:00:" + "".join(f"{byte:02X}:" for byte in b"../prjs/x/program.rbf") + "00"),
)
FIELD_TOO_LONG = _code(
    "E804",
    "a field that is longer than the firmware has room for",
    """
    The firmware copies the field into a buffer of fixed size. This field has more bytes than that.
    """,
    _sized("2A:00|01|A2:" + "41:" * 11 + "00"),
    _sized("2A:00|01|A2:" + "41:" * 10 + "00"),
)
WRONG_CARRIER = _code(
    "E805",
    "a command that this carrier cannot transport",
    """
    Commands of the firmware updater, and BLUETOOTHPIN, reach the brick by USB only. A check knows the carrier
    when `--carrier` says so, or it reads a capture.
    """,
    _frame("04:00|2A:00|01|F6"),
    _frame("04:00|2A:00|01|9D"),
    "wifi",
)
UNKNOWN_DAISY = _code(
    "E806",
    "an unknown message from brick to brick",
    """
    Messages in a daisy chain have a sub-command, 0xA0 to 0xA5, then the layer they come from and the one they
    go to.
    """,
    _frame("06:00|2A:00|0A|42:00:01"),
    _frame("06:00|2A:00|0A|A2:00:01"),
)
NEVER_ANSWERED = _code(
    "W801",
    "a reply that never comes",
    """
    The type asks for a reply (0x01), and the brick never replies to this command. A program that waits for one
    waits for ever.
    """,
    _frame("04:00|2A:00|01|A0"),
    _frame("04:00|2A:00|81|A0"),
)
ANSWER_NEEDED = _code(
    "W802",
    "a question that wants no answer",
    """
    The reply is what this command is for: it brings the handle for what follows, or the contents that were
    asked for. The type (0x81) says that none is wanted.
    """,
    _frame("04:00|2A:00|81|9D"),
    _frame("04:00|2A:00|01|9D"),
)
LONG_DAISY = _code(
    "W803",
    "more than a report between bricks carries",
    """
    Bricks of a daisy chain talk in USB reports of 64 bytes; a frame that is longer does not fit.
    """,
    _sized("2A:00|8A|A0:00:01|" + "01:" * 56 + "01"),
    _sized("2A:00|8A|A0:00:01|" + "01:" * 55 + "01"),
)
MAILBOX_TOO_SMALL = _code(
    "W804",
    "more than a mailbox holds",
    """
    A mailbox has a name of at most 49 characters and room for 250 bytes. The firmware does not check what comes:
    no mailbox has a longer name, so the message is dropped, and a longer message overwrites the next mailbox.
    """,
    _sized("2A:00|81|9E:02:61:00:FB:00:" + "61:" * 250 + "00"),
    _sized("2A:00|81|9E:02:61:00:FA:00:" + "61:" * 249 + "00"),
)
TEXT_WITHOUT_ZERO = _code(
    "W805",
    "a message that looks like a text without its zero",
    """
    A text in a mailbox ends with a zero, which is part of the message and counted. The firmware copies a message
    over the last one and does not clear the rest. So a program reads the text up to the next zero: after a longer
    message, the end of that one follows.
    """,
    _sized("2A:00|81|9E:02:61:00:02:00:68:69"),
    _sized("2A:00|81|9E:02:61:00:03:00:68:69:00"),
)

# 9: encodings

LONGER_FORM = _code(
    "H901",
    "an encoding that is longer than it need be",
    """
    The same value fits a shorter form. Both mean the same; the shorter one leaves more room in the frame.

    Constants: LC0 for -32 to 31, LC1 to +-127, LC2 to +-32767, LC4 beyond. Variables: LV0 and GV0 up to 31, LV1
    and GV1 up to 255, LV2 and GV2 up to 65535.
    """,
    _sized("2A:00|80|00:00|94:01:81:05:82:B8:01:82:E8:03"),
    _sized("2A:00|80|00:00|94:01:05:82:B8:01:82:E8:03"),
)
