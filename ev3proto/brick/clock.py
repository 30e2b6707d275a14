"""Timing of the virtual brick, and limits for endless commands."""

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
