"""Paths on the brick: how long one and its parts may be, each with its zero. The firmware refuses longer ones."""

from ev3proto.tables.constants import CONSTANTS

WHOLE = int(CONSTANTS["FILENAMESIZE"])
"""Bytes of a whole path."""

FOLDER = int(CONSTANTS["PATHSIZE"])
"""Bytes of what comes before the name, its slash included."""

NAME = int(CONSTANTS["NAMESIZE"])
"""Bytes of the name, up to its first dot."""

EXTENSION = int(CONSTANTS["EXTSIZE"])
"""Bytes of the extension, its dot included."""
