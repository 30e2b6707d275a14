r"""Assembly: messages as text, and text as messages.

There are two notations, which may be mixed:

    SOUND(TONE, 1, 440, 1000)                               LEGO's source: each value in its shortest encoding
    opSOUND, LC0(TONE), LC0(1), LC2(440), LC2(1000)         the C macros: each value in the encoding that is named

Other elements:

    // and /* */             comments
    define SPEED 50          a name for a constant, a text or a macro; #define as well
    DATAF volts              a variable: DATA8, DATA16, DATA32, DATAF, HANDLE, DATAS, ARRAY8, ARRAY16, ARRAY32, ARRAYF
    DATAS name 20            the same with that number of elements; name[3] is one of them
    local DATA8 i            in local memory. Others are global, so the reply carries them; in a vmthread they are local
    vmthread MAIN { ... }    may enclose the operations, as in LEGO's sources
    Loop:  JR(Loop)          a label, and a jump to it
    LED_RED, 0x1F, 1.5F, 'text', "text", (A + 2) * 3        constants; the firmware's names are all known
    @handle  HND(LV1(4))     the memory object that a variable is a handle to; &place and ADR(...) what it points to

Peculiarities of LEGO's own sources are accepted: a missing ) at the end of a line, names of CMDs as numbers, letters of
motor ports (`OUTPUT_POWER(0, A+B, 50)`), CALL with the name of an object, to which `define` gives its number. After a
number, the number of values follows; after a name, it does not: `CALL(Show, 'text', 5)` is `CALL(2, 2, 'text', 5)`.

Values are legal if `ev3proto.ops` accepts them; others are refused, unless their encoding is named, a header
precedes them, or `unchecked=True` is given.

Without a header, operations are one direct command, whose memory and type are computed, and each system command is a
separate message. A header begins a message and sets what is in it:

    message DIRECT_COMMAND_REPLY counter 42 globals 4 locals 0
    opUI_READ, LC0(GET_VBATT), GV0(0)

    message SYSTEM_COMMAND_REPLY counter 43
    LIST_FILES(max_bytes=1000, path="/home/root/lms2012/prjs/")

    message DIRECT_REPLY counter 42
    bytes A4 70 FD 40

    message DAISY_COMMAND_REPLY counter 44 command DOWNSTREAM layer_from 0 layer_to 1
    opOUTPUT_START, LC0(0), LC0(15)

Faulty messages can be written, too. `length 55` in a header sets the length field, `...` ends an operation or a
system command that is cut short, `bytes 01 FF` are verbatim bytes (`bytes(A3 05)` as a value), and `frame` begins a
message that consists of bytes only.
"""

from __future__ import annotations

from ev3proto.messages import Message
from ev3proto.text.assembly.disassembly import assembly, operation_line
from ev3proto.text.assembly.errors import AssemblyError

__all__ = ["AssemblyError", "assemble", "assembly", "operation_line"]


def assemble(
    text: str,
    *,
    dialect: str = "official",
    counter: int = 0,
    reply: bool | None = None,
    unchecked: bool = False,
) -> list[Message]:
    """Returns the messages of a text.

    Args:
        text: Assembly in either notation.
        dialect: The firmware whose operations are known.
        counter: The counter of the first message, 0 to 65535, unless its header has one. Later messages have the next
            numbers.
        reply: Whether messages without a header want a reply. With None, direct commands do if they have global
            memory, and system commands if the brick answers them.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.

    Returns:
        The messages, in order.

    Raises:
        AssemblyError: The text is not assembly, or has an illegal value. The error has line, column, the text of the
            line, and in `others` the other mistakes.
    """
    # It takes 25 ms, and everything that prints messages imports this package.
    from ev3proto.text.assembly.assembling import assembled

    return list(assembled(text, dialect=dialect, counter=counter, reply=reply, unchecked=unchecked))
