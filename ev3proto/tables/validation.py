"""What the firmware's validator knows of byte code beside the types of the parameters: its tables of CMDs, its limits.

The verdict of a check is that of the release of 2013, whose published source these facts come from.
"""

CMD_TABLES = (
    *("UI_READ", "UI_WRITE", "UI_DRAW", "UI_BUTTON", "FILE", "PROGRAM_INFO", "INFO", "STRINGS"),
    *("COM_READ", "COM_WRITE", "SOUND", "INPUT_DEVICE", "ARRAY", "MATH", "COM_GET", "COM_SET"),
)
"""The tables of CMDs in the order in which they stand in the firmware's memory, named after their first family.

A negative CMD reaches into the table before its own. Each family's entry says which table is its own; tables that are
not named here come last.
"""

TABLE_SIZE = 33
"""CMDs that each of these tables has room for: 0 to 32."""

LABELS = 32
"""Labels of a program: 0 to 31, of which jumps can name all but the first."""

SPINNING = 1_000_000
"""Values in a list from which on reading them keeps the brick busy for longer than anybody would wait.

The validator reads as many as the count says, whatever is there; a negative count is one of more than two thousand
million. The number itself is a choice: about a tenth of a second.
"""
