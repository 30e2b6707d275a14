"""The rule that decides whether a conversation is claimed as this protocol or left to others.

Other traffic uses the same ports, channels and reports as bricks: debuggers use TCP port 5555, LEGO's NXT the serial
port of Bluetooth, any device USB reports. The dissector and the built-in reader of captures follow one rule: a claim
begins with a plausible command, or with whole frames that the other side answers.

Claimed for good, whatever it contains: what the unlock text or its answer, the port announced in a beacon, the product
of a USB device, or the user (`--port`, `--all`, the preference, Decode As) identifies.

Elsewhere (TCP port 5555, the RFCOMM channel of the serial port, reports of a brick's size), a claim begins with

- a *plausible* command where a packet begins; inside a packet only if a header follows it at once (zeros are none);
- a packet of whole frames, whatever they contain (USB: one frame), if a packet from the other side begins with the
  reply to one of them: of its kind, with its counter, and for a direct command with the length that it requested, or an
  error, for a system command with its number. Zeros prove nothing: neither a system command 0 nor operations of zeros.
  At most `MOST_HELD` packets of a conversation wait for such a reply;
- on TCP, `REPLIES` complete, non-empty replies in a row.

A direct command is plausible if

- the instructions of some firmware read it to its end, or to the end of what was captured of its packet;
- at least one operation is not in `NOT_TELLING`, and none is `NEVER_SENT` or in `ONLY_IN_PROGRAMS`;
- each argument has a kind and range that its parameter accepts, but for `STILL_SENT`; each set of motors has one;
- variables are within the memory that the header requests.

A system command is plausible if it fits its fields, is in one packet if it has data, and is not that of the NXT
(`NXT_WRITE`).

A claim ends after `STRANGE_PACKETS` packets in a row without a complete frame. Once a reply had the counter and the
length that a command asked for, faulty frames are complete, too, and more than a frame's size of other bytes ends it.
After that a new claim may begin anywhere in a packet.
"""

STRANGE_PACKETS = 3
"""Packets in a row without a frame of this protocol after which a conversation is left to others."""

REPLIES = 2
"""Complete replies in a row that begin a conversation on TCP."""

MOST_HELD = 4
"""Packets of commands in a conversation that wait for a reply which proves them."""

NEVER_SENT = "ERROR"
"""The opcode of a fault. Its number is zero, which is common in other data."""

NOT_TELLING = ("PROGRAM_STOP", "PROGRAM_START", "PROGRAM_INFO")
"""Opcodes of commands with small numbers, which alone do not count as evidence."""

ONLY_IN_PROGRAMS = (
    *("OBJECT_STOP", "OBJECT_START", "OBJECT_TRIG", "OBJECT_WAIT", "RETURN", "CALL", "OBJECT_END", "SLEEP"),
    *("LABEL", "PROBE", "DO", "JR"),
)
"""Opcodes that are rare in commands, and whose numbers are common in other data (small ones, sizes of blocks)."""

STILL_SENT = ("WHOLE", "NAN_FLOAT", "LONG")
"""What may be wrong with an argument (`semantics/judgement.py`), since programs send it: a whole number for a float, a
float that is not a number, a text that is too long."""

NXT_WRITE, NXT_MASK = 0x8301, 0xFF7F
"""The NXT's command that writes a piece of a file, at the position of the counter, and the bits to compare.

The NXT uses the same channel and the same length field. Its other commands are not plausible.
"""
