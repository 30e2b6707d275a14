"""The firmware's validator: its tables of CMDs and its limits. (The types of parameters are in the other tables.)

A check reports the verdict of the release of 2013; these facts come from its published source.
"""

CMD_TABLES = (
    *("UI_READ", "UI_WRITE", "UI_DRAW", "UI_BUTTON", "FILE", "PROGRAM_INFO", "INFO", "STRINGS"),
    *("COM_READ", "COM_WRITE", "SOUND", "INPUT_DEVICE", "ARRAY", "MATH", "COM_GET", "COM_SET"),
)
"""The tables of CMDs in the order of the firmware's memory, each named after its first family.

A negative CMD reaches into the table before its own. Each family's entry names its own table; tables
that are not listed here come last.
"""

TABLE_SIZE = 33
"""Number of CMDs in each table: 0 to 32."""

LABELS = 32
"""Number of labels of a program: 0 to 31; jumps can use all but the first."""

SPINNING = 1_000_000
"""Number of values in a list from which on the brick is taken to hang while it reads them.

The validator reads as many as the count says, past the end of the frame; a negative count means more than two thousand
million. The limit is arbitrary: about a tenth of a second.
"""
