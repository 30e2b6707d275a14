"""Every operation of the community's extended firmware as a function, as `ev3proto.ops` has those of LEGO's own.

What is the same in another firmware is the same function.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

# ruff: noqa: F403, I001 - the private modules say what they export; one import for each module

from ev3proto.ops import (
    com_get as com_get,
    com_read as com_read,
    com_set as com_set,
    com_write as com_write,
    file as file,
    filename as filename,
    info as info,
    input_device as input_device,
    math as math,
    sound as sound,
    strings as strings,
    tst as tst,
    ui_button as ui_button,
    ui_read as ui_read,
    ui_write as ui_write,
)
from ev3proto.ops.xtended import (
    array as array,
    program_info as program_info,
    ui_draw as ui_draw,
)
from ev3proto.ops._plain import *
from ev3proto.ops.xtended._plain import *
