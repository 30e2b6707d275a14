"""How the virtual brick differs from the firmware on purpose, as `ev3proto brick --help` lists it."""

from __future__ import annotations

from ev3proto.brick.clock import MOST_OPERATIONS, MOST_PROCESSOR_SECONDS, MOST_SECONDS
from ev3proto.brick.servers.limits import PATIENCE, UNLOCK_TIME

DEVIATIONS: tuple[str, ...] = (
    f"A direct command is ended after {PATIENCE:g} s if another client waits.",
    f"A client that has not sent the unlock text after {UNLOCK_TIME:g} s is disconnected.",
    "A frame with a header error is answered (length 3, 0x04), and the brick continues; a real one must be restarted.",
    "An operation that accesses memory out of bounds fails with 0x04: variables beyond local and global memory,"
    " addresses, unset labels, unknown mailboxes and objects, RETURN.",
    "Every direct command has 64 bytes of local memory, however few it requests.",
    "Memory that the firmware does not initialize, such as new elements of arrays, is zero.",
    "MAILBOX_READ of a closed mailbox skips its parameters; the firmware executes them.",
    "The remainder of an integer division by zero is 0; the firmware crashes.",
    "STRINGS.STRING_TO_VALUE of a text without a number gives 0; the firmware gives an arbitrary number.",
    "printf formats support %d %i %u %x %X %o %c %f %F %e %E %g %G; others, such as %a, are shown unchanged.",
    f"An endless direct command is ended with 0x04 after {MOST_OPERATIONS:,} operations,"
    f" {MOST_PROCESSOR_SECONDS:g} s of processor time, or {MOST_SECONDS} s of waiting; a real brick stops"
    " answering.",
    "SYSTEM never runs a command: its status is -1.",
    "All files are in one folder, which is its /home/root/lms2012. Paths out of it do not exist; links and special"
    " files are not opened; files may take 6000 KB.",
    "A piece of an upload or listing always fits a frame of 1024 bytes; the firmware loses bytes.",
    "Two uploads on one connection are kept apart; handles are freed when their connection ends.",
    "System commands that the firmware answers with a buffer of zeros (unknown ones, WRITEMAILBOX) are not answered.",
    "Motors have neither load nor friction: at full power a large one makes 1020 degrees a second, a medium one 1500.",
    "Radios and the daisy chain are missing: nothing is found, sent or connected.",
    "Letters and icons differ from the firmware's, but have the same size.",
)
"""One or two sentences each."""
