"""Ours and not ours: when traffic is taken for this protocol, and when it is left to others.

The ports, channels and reports that bricks use belong to others as well: debuggers on TCP port 5555, LEGO's NXT on the
serial port of Bluetooth, any other device on USB. The dissector and the built-in reader of captures follow one rule:

Ours is what the unlock text or its answer, a beacon's announced port, the product of a USB device or the user
(`--port`, Decode As) says. Else, on TCP port 5555, on the RFCOMM channel of the serial port and in reports of a brick's
size, a conversation is ours from its first *plausible* command on: read whole, by the instructions of some firmware, at
least one operation that is not `NOT_TELLING`, none that is `NEVER_SENT` or `ONLY_IN_PROGRAMS`, each argument of a kind
and range that its parameter takes, variables within the memory that the header asks for; of one that the capture has
cut, what is there, if its operations are of devices (from `FIRST_OF_DEVICES` on); or a system command that fits its
fields, in one packet if it has data, and is not the NXT's (`NXT_WRITE`). On TCP `REPLIES` complete replies in a row
that bring something begin one, too. It ends after `STRANGE_PACKETS` packets in a row without a frame that can be read
whole; once a reply came with the counter and the length that a command asked for, after as many without any, if they
have more bytes than one. After a gap or garbage the next plausible frame is found.
"""

STRANGE_PACKETS = 3
"""Packets in a row with nothing of ours after which a conversation is left to others."""

REPLIES = 2
"""Complete replies in a row that begin a conversation on TCP."""

NEVER_SENT = "ERROR"
"""The opcode that stands for a fault. Its number is that of zeros in others' data."""

NOT_TELLING = ("PROGRAM_STOP", "PROGRAM_START", "PROGRAM_INFO")
"""Opcodes that commands have, and whose numbers are small: alone they tell nothing."""

ONLY_IN_PROGRAMS = (
    *("OBJECT_STOP", "OBJECT_START", "OBJECT_TRIG", "OBJECT_WAIT", "RETURN", "CALL", "OBJECT_END", "SLEEP"),
    *("LABEL", "PROBE", "DO", "JR"),
)
"""Opcodes that commands seldom have, and whose numbers are small, or the size of many blocks, in others' data."""

FIRST_OF_DEVICES = "UI_FLUSH"
"""The first opcode of those that say something to a device: display, motors, sensors, files, radio."""

NXT_WRITE, NXT_MASK = 0x8301, 0xFF7F
"""What the NXT's command that writes a piece of a file has in the place of the counter, and the bits that tell it.

The NXT is found on the same channel and has the same length field. Its other commands are not plausible.
"""
