"""Paths on the brick: maximum lengths, each including the zero. The firmware refuses longer ones."""

from ev3proto.tables.constants import CONSTANTS

WHOLE = int(CONSTANTS["FILENAMESIZE"])
"""Bytes of a whole path."""

FOLDER = int(CONSTANTS["PATHSIZE"])
"""Bytes before the name, including the slash."""

NAME = int(CONSTANTS["NAMESIZE"])
"""Bytes of the name, up to its first dot."""

EXTENSION = int(CONSTANTS["EXTSIZE"])
"""Bytes of the extension, including the dot."""

USUAL_FOLDERS = (
    *(f"apps/{name}" for name in ("Brick Datalog", "Brick Program", "IR Control", "Motor Control", "Port View")),
    *(f"prjs/{name}" for name in ("BrkDL_SAVE", "BrkProg_SAVE")),
    *(f"sys/{name}" for name in ("lib", "mod", "settings", "ui")),
    *(f"tools/{name}" for name in ("Bluetooth", "Brick Info", "Sleep", "Volume", "WiFi")),
)
"""Folders of a brick as LEGO delivers it, below /home/root/lms2012."""
