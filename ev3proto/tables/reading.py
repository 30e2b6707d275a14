"""What `proxy --read-only` lets through, and `replay` sends without `--allow`: the reason and the limits of each entry.

An operation or system command is on the list if its entry in the tables has Effect.READS and a row here matches it.
Reasons say what the firmware does; docs/reference/read-only.md is generated from them.
"""

from __future__ import annotations

from collections.abc import Mapping
from fnmatch import fnmatchcase
from functools import cache
from types import MappingProxyType
from typing import NamedTuple

from ev3proto.tables.paths import HOME, parts

_NONE: Mapping[str, int] = MappingProxyType({})

MOST_WAITS = 8
"""Sensors that one command may wait for: the firmware waits 1.2 s for each, and serves no other client meanwhile."""

MOST_FILES = 8
"""Files that one command may open."""

MOST_PATH = 100
"""Characters of a path, with all of its folders: the firmware adds names to it, and checks no lengths."""


class ReadOnly(NamedTuple):
    """Why some operations or system commands only read.

    names   patterns of their names, separated by blanks
    reason  one sentence on what the firmware does
    room    bytes that an output takes, whatever length the command gives
    only    parameters with a single allowed value
    most    how many of them a command may have; None for any number
    """

    names: str
    reason: str
    room: Mapping[str, int] = _NONE
    only: Mapping[str, int] = _NONE
    most: int | None = None


READING = (
    ReadOnly("NOP", "It does nothing."),
    ReadOnly("PORT_CNV_*", "It computes numbers of ports from a number."),
    ReadOnly(
        "ADD* SUB* MUL* DIV* OR* AND* XOR* RL* MATH.* RANDOM CP_* SELECT*",
        "It computes one value; dividing by zero and overflows have results, as for all operations with Effect.READS.",
    ),
    ReadOnly(
        "MOVE* INIT_BYTES READ8 READ16 READ32 READF WRITE8 WRITE16 WRITE32 WRITEF",
        "It copies values within the command's memory: the firmware checks no bounds, so places and counts are"
        " constants.",
    ),
    ReadOnly("INFO.ERRORTEXT", "It copies the name of an error from the firmware, up to LENGTH."),
    ReadOnly("INFO.GET_*", "It copies a setting."),
    ReadOnly("TIMER_READ TIMER_READ_US", "It copies the clock."),
    ReadOnly("MEMORY_USAGE", "It counts the memory for files."),
    ReadOnly(
        "UI_READ.GET_VBATT UI_READ.GET_?BATT UI_READ.GET_IINT UI_READ.GET_IMOTOR UI_READ.GET_WARNING"
        " UI_READ.GET_SDCARD UI_READ.GET_USBSTICK",
        "It copies measured values.",
    ),
    ReadOnly(
        "UI_READ.GET_*_VERS UI_READ.GET_*_BUILD UI_READ.GET_VERSION UI_READ.GET_IP",
        "It copies a text, up to LENGTH, which is 1 to 127: a negative one would not cut it.",
    ),
    ReadOnly(
        "UI_BUTTON.PRESSED UI_BUTTON.TEST* UI_BUTTON.GET_BACK_BLOCK",
        "It copies the state of a button; unlike SHORTPRESS and its like it leaves presses to programs.",
    ),
    ReadOnly("SOUND_TEST", "It copies whether a sound is playing, and does not wait."),
    ReadOnly(
        "INPUT_DEVICE_LIST",
        "It copies the types of devices, LENGTH of them; CHANGED counts from the last call of a direct command.",
    ),
    ReadOnly(
        "INPUT_DEVICE.GET_*",
        "It copies what is known of a device, up to LENGTH; the ports are those that a brick has.",
    ),
    ReadOnly(
        "INPUT_DEVICE.READY_*",
        "It waits up to 1.2 s for a value; it may switch a sensor's mode, but not its type, which would reset the port"
        " and let a motor float.",
        most=MOST_WAITS,
    ),
    ReadOnly(
        "INPUT_READ INPUT_READSI INPUT_READEXT",
        "It copies a value, and does not wait; it may switch a sensor's mode, but not its type, which would reset the"
        " port and let a motor float.",
    ),
    ReadOnly("INPUT_TEST", "It copies whether a device is busy, and does not wait."),
    ReadOnly("OUTPUT_READ OUTPUT_TEST", "It copies the state of motors, and does not wait."),
    ReadOnly(
        "OUTPUT_GET_COUNT",
        "It copies a motor's count; of other bricks in a chain it returns whatever is in memory.",
        only={"LAYER": 0},
    ),
    ReadOnly(
        "FILE.OPEN_READ",
        "It opens a file, which the end of the command closes.",
        most=MOST_FILES,
    ),
    ReadOnly(
        "FILE.READ_*",
        "It reads from a file that OPEN_READ has opened in the same command, and that exists: for a missing one the"
        " handle is 0, which is the command's own memory.",
    ),
    ReadOnly(
        "FILE.GET_FOLDERS FILE.GET_SUBFOLDER_NAME FILENAME.EXIST",
        "It looks into a folder of the brick's own files.",
    ),
    ReadOnly(
        "FILE.GET_CACHE_FILES FILE.GET_CACHE_FILE FILE.GET_LOG_NAME FILE.GET_LOG_SYNC_TIME FILENAME.GET_FOLDERNAME",
        "It copies what the firmware remembers of files, up to LENGTH.",
    ),
    ReadOnly(
        "COM_GET.GET_NETWORK",
        "It copies addresses as a whole, whatever LENGTH says, so the memory must have room for them.",
        room={"MAC": 18, "IP": 16},
    ),
    ReadOnly(
        "COM_GET.*",
        "It copies the state of a radio or a name, up to LENGTH; where the hardware has not got it, it fails.",
    ),
    ReadOnly(
        "BEGIN_UPLOAD BEGIN_GETFILE",
        "It opens a file of the brick's own and reads its first piece; the handle is closed when the client goes.",
    ),
    ReadOnly(
        "CONTINUE_UPLOAD CONTINUE_GETFILE",
        "It reads the next piece of the file that the connection opened last, so a client has one file open.",
    ),
    ReadOnly(
        "LIST_FILES CONTINUE_LIST_FILES",
        "It reads a listing of one of the brick's own folders; the firmware keeps a count where a file has its"
        " descriptor, so a listing is read to its end, and never closed or read as a file.",
    ),
    ReadOnly("CLOSE_FILEHANDLE", "It closes the file that the same client has opened."),
    ReadOnly("LIST_OPEN_HANDLES", "It returns zeros."),
)
"""The first row that matches an entry is its own."""


@cache
def reading_of(name: str) -> ReadOnly | None:
    """Returns the row of an operation or system command that reads; None if there is none."""
    return next((row for row in READING if any(fnmatchcase(name, each) for each in row.names.split())), None)


def is_own(path: bytes) -> bool:
    """Returns whether a path names one of the brick's own files or folders, below /home/root/lms2012, and is short."""
    names = parts(path)
    whole = sum(len(name) + 1 for name in names)
    return tuple(names[: len(HOME)]) == HOME and whole <= MOST_PATH and len(path) <= MOST_PATH
