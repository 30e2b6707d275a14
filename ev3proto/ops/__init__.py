"""Every operation as a function: `ops.sound.tone(volume=1, frequency=440, duration=1000)`, `ops.ui_flush()`.

Opcodes with a CMD are families, and their commands are functions of those; all other opcodes are functions
here. Names are the firmware's in lower case; a word of Python has a `_` after it (`ops.sound.break_`). A
function gives a `Draft`, and `ev3proto.command` makes a command of drafts. Outputs may be omitted: the
command finds a place for them.

A value that means nothing to the brick is refused with a BuildError. `unchecked=True` lets it through, as
far as it can be encoded.

These are the operations of LEGO's own firmware; `ev3proto.ops.xtended` and `ev3proto.ops.compat` have those
of the community's.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

# ruff: noqa: F403, I001 - the private modules say what they export; one import for each module

from ev3proto.ops import (
    array as array,
    com_get as com_get,
    com_read as com_read,
    com_set as com_set,
    com_write as com_write,
    file as file,
    filename as filename,
    info as info,
    input_device as input_device,
    math as math,
    program_info as program_info,
    sound as sound,
    strings as strings,
    tst as tst,
    ui_button as ui_button,
    ui_draw as ui_draw,
    ui_read as ui_read,
    ui_write as ui_write,
)
from ev3proto.ops._plain import *
