"""Where the virtual brick does something else than the firmware on purpose: what `ev3proto brick --help` lists."""

from __future__ import annotations

from ev3proto.brick.clock import MOST_OPERATIONS, MOST_PROCESSOR_SECONDS, MOST_SECONDS

DEVIATIONS: tuple[str, ...] = (
    "A frame with a header error is answered (length 3, 0x04), and the brick reads on; a real one must be restarted.",
    "An operation that would read or write memory that is not there fails with 0x04: variables beyond local and global"
    " memory, addresses, labels that are nowhere set, numbers of mailboxes and objects that do not exist, RETURN.",
    "Every direct command finds 64 bytes of local memory, however few it asks for.",
    "Memory that the firmware leaves as it was, such as new elements of arrays, is zero.",
    "MAILBOX_READ of a box that is not open skips its parameters; the firmware executes them.",
    "The remainder of an integer division by zero is 0; the firmware dies.",
    "STRINGS.STRING_TO_VALUE of a text without a number gives 0; the firmware gives any number.",
    "Formats of printf know %d %i %u %x %X %o %c %f %F %e %E %g %G; any other, such as %a, is shown as it is written.",
    f"A direct command that never ends is ended, with 0x04, after {MOST_OPERATIONS:,} operations,"
    f" {MOST_PROCESSOR_SECONDS:g} s of this computer's processor, or {MOST_SECONDS} s of waiting."
    " The real brick stays deaf.",
    "SYSTEM never runs a command: its status is -1.",
    "Files are those of one folder, which stands for /home/root/lms2012. Paths that lead outside lead nowhere; links"
    " and special files are not opened; files may take 6000 KB.",
    "A piece of an upload or a listing is never larger than fits a frame of 1024 bytes; the firmware loses bytes.",
    "Two uploads of one connection are kept apart; the handles of a connection that ends are freed.",
    "System commands that the firmware answers with a buffer of zeros (unknown ones, WRITEMAILBOX) are not answered.",
    "There are no radios and no daisy chain: nothing is found, sent or connected.",
    "Letters and icons are drawings of this project, in the cells of the firmware's.",
)
"""One sentence or two each."""
