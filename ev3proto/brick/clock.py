"""How long things take on the virtual brick, and where what never ends is ended."""

TICK = 1_000
"""Microseconds from one turn of the programs to the next while one of them waits."""

OPERATIONS_PER_TURN = 200
"""Operations of one turn of an object, other than that of a direct command."""

OPERATIONS_PER_TICK = 1_000
"""Operations of all turns of a program in a tick: a real brick executes some hundred thousand a second."""

MOST_OPERATIONS = 3_000_000
"""Operations after which a direct command is ended: the firmware would go on for ever."""

MOST_SECONDS = 600
"""Seconds after which a direct command that still waits is ended."""

MOST_FRAMES = 4096
"""Frames that wait for a direct command to end; further ones are dropped. A real brick leaves them to the carrier."""
