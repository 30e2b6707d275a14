"""Timing of the virtual brick, its limits for commands and clients, and how it differs from the firmware on purpose."""

from __future__ import annotations

import time

thread_time = getattr(time, "thread_time", time.perf_counter)
"""CPU time of this thread, in seconds. Python in a browser has one thread, and no such clock."""

TICK = 1_000
"""Microseconds from one turn of the programs to the next while one of them waits."""

OPERATIONS_PER_TURN = 200
"""Operations of one turn of an object, other than that of a direct command."""

OPERATIONS_PER_TICK = 300
"""Operations of all turns of a program in a tick: a real brick executes some hundred thousand a second."""

QUICK_OPERATIONS = 16
"""Quick operations between two checks of the time; it is also checked after each other one."""

MOST_OPERATIONS = 3_000_000
"""Operations after which a direct command is ended, which the firmware would execute forever."""

OPERATIONS_OF_A_TURN = 20
"""Minimum number of operations that a turn counts, if an object gives up the rest of it."""

MOST_PROCESSOR_SECONDS = 5.0
"""CPU seconds of this computer that a direct command may take."""

MOST_SECONDS = 600
"""Seconds after which a direct command that still waits is ended."""

MOST_WAITING = 4 << 20
"""Bytes of frames that wait for a direct command to end; further frames are dropped. See `Brick.is_busy`."""

STRETCH = 0.02
"""CPU seconds after which a direct command pauses, so that everything else can run."""

PATIENCE = 10.0
"""Seconds after which a direct command is ended when another client waits for it."""

MOST_SPENT = 0.25
"""CPU seconds after which a direct command is ended when another client waits for it."""

MOST_BUFFERED = 1 << 17
"""Bytes of a client that the brick has not read yet; at this limit reading pauses. One frame fits."""

MOST_UNREAD = 1 << 16
"""Bytes of replies that a client leaves unread before its next frame waits."""

MOST_DELAYED = 64
"""Replies to one client that are held back by `--delay` before its next frame waits."""

MOST_QUEUED = 64
"""Connections that may wait until a client disconnects; further ones are closed at once."""

MOST_PAGE_CONNECTIONS = 64
"""Connections to the page; beyond that the oldest without an open page is closed."""

UNLOCK_TIME = 30.0
"""Seconds in which a client has to send the unlock text."""

DEVIATIONS: tuple[str, ...] = (
    f"A direct command is ended after {PATIENCE:g} s, or {MOST_SPENT:g} s of processor time, if another client waits.",
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
