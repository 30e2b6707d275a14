"""What operations do beside what their parameters say: which of them wait, sound, draw, move motors, end a command."""

SOUNDS = frozenset(("SOUND.TONE", "SOUND.PLAY", "SOUND.REPEAT"))
"""They start a sound and return at once; a sound that is playing ends."""

SOUND_ENDS = frozenset(("SOUND.BREAK",))
"""They end the sound that is playing."""

DRAWS = frozenset(
    f"UI_DRAW.{command}"
    for command in (
        *("CLEAN", "PIXEL", "LINE", "CIRCLE", "TEXT", "ICON", "PICTURE", "VALUE", "FILLRECT", "RECT", "RECTANGLE"),
        *("VERTBAR", "INVERSERECT", "FILLWINDOW", "SCROLL", "DOTLINE", "VIEW_VALUE", "VIEW_UNIT", "FILLCIRCLE"),
        *("RESTORE", "BMPFILE", "GRAPH_DRAW"),
    )
)
"""They draw on the canvas, which nobody sees before it is shown."""

WIPES = frozenset(("UI_DRAW.CLEAN", "UI_DRAW.FILLWINDOW", "UI_DRAW.RESTORE"))
"""Those of them that draw over all that was there, or much of it."""

SHOWS = frozenset(("UI_DRAW.UPDATE",))
"""They show the canvas."""

DIALOGUES = frozenset(
    f"UI_DRAW.{command}"
    for command in ("NOTIFICATION", "QUESTION", "KEYBOARD", "BROWSE", "ICON_QUESTION", "TEXTBOX", "POPUP")
)
"""They take the display for themselves, and show what is on it."""

MOVES = frozenset(
    f"OUTPUT_{move}" for move in ("STEP_POWER", "TIME_POWER", "STEP_SPEED", "TIME_SPEED", "STEP_SYNC", "TIME_SYNC")
)
"""They start a move of motors that ends by itself, and return at once; a move of the same motors ends."""

STOPS = frozenset(("OUTPUT_STOP",))
"""They stop motors."""

WAITS = DIALOGUES | frozenset(
    (
        *("SOUND_READY", "SOUND_TEST", "TIMER_READY", "OUTPUT_READY", "OUTPUT_TEST", "INPUT_READY", "COM_READY"),
        *("MAILBOX_READY", "OBJECT_WAIT", "SYSTEM", "UI_READ.GET_STRING", "UI_READ.GET_ADDRESS", "UI_READ.GET_CODE"),
        *("UI_BUTTON.WAIT_FOR_PRESS", "INPUT_DEVICE.READY_IIC", "INPUT_DEVICE.READY_PCT", "INPUT_DEVICE.READY_RAW"),
        *("INPUT_DEVICE.READY_SI", "CALL"),
    )
)
"""They wait, or tell whether to wait: what was begun before them is given some time."""

ENDS = frozenset(("OBJECT_END", "RETURN"))
"""Nothing behind them is run, unless something jumps there."""

MAY_END = frozenset(("PROGRAM_STOP", "OBJECT_STOP"))
"""They end the command itself where its own slot or object is meant."""

OF_PROGRAMS = frozenset(("OBJECT_STOP", "OBJECT_START", "OBJECT_TRIG", "OBJECT_WAIT", "CALL", "RETURN"))
"""They are about the objects of the program that they stand in. A direct command is a program of one object, 1."""
