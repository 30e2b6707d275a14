"""Every operation as a function: `ops.sound.tone(volume=1, frequency=440, duration=1000)`, `ops.output_start(0, 1)`.

Opcodes with a CMD are families, and their commands functions in them; all other opcodes are functions here. Names are
the firmware's in lower case; what is a word of Python has a `_` behind it (`ops.sound.break_`). What a function gives
is a `Draft`, and `ev3proto.command` makes commands of those.

These are the operations of LEGO's own firmware; `ev3proto.ops.xtended` and `ev3proto.ops.compat` have those of the
community's. All are made from the tables when they are first asked for. What editors and type checkers see of them
stands in the .pyi files, which are written from the same tables.
"""

from typing import Any

from ev3proto.ops.making import Operations

_OPERATIONS = Operations("official")


def __getattr__(name: str) -> Any:
    """A function, or a family of them."""
    value = globals()[name] = getattr(_OPERATIONS, name)
    return value


def __dir__() -> list[str]:
    return dir(_OPERATIONS)
