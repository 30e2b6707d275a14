"""The registry of handlers, the functions that execute operations. They are registered by name, never by number.

How to add one. Write a function in a file of `ev3proto.brick.operations` (and import a new file in that package's
`__init__`):

    @handles("STRINGS.ADD")
    def add(vm: Machine, first: bytes, second: bytes, destination: Place) -> None:
        vm.write_text(destination, first + second)

The machine reads the parameters as the tables declare them and passes them in their order:

    an input number     DATA8, DATA16, DATA32 and handles as int, DATAF as float
    an input text       bytes, without the zero
    an output, an input that is an array (its declaration has a `length`), a value whose type depends on an array
                        a `Place` to read from or write to
    a count             the list of the places that follow it

`@handles("WRITE8", places=("DESTINATION",))` asks for the place of a parameter that would be a number or a text.
`@handles("JR", raw=True)` asks for nothing: the function reads its parameters itself (`vm.int8()`, `vm.place()`, ...).

Where all outputs are numbers, a function of the inputs is enough: what it returns, one number or a tuple of them, is
written to the outputs. One line registers it:

    computes({"STRINGS.COMPARE": lambda vm, first, second: first == second})

Others wait while a handler works. `tests/brick/test_brick_budgets.py` runs each with the greatest arguments.

A handler raises `Busy` to be called again at the program's next turn, with its parameters read anew, and `Failure`
to end the program (a direct command is answered with DIRECT_REPLY_ERROR). `vm.brick` is the brick with display,
inputs, files; `vm.program` the running program; `vm.milliseconds` the clock.

An opcode with an unknown CMD does nothing, and its intended parameters are executed as operations, as in the firmware.
Where the firmware does something else, a function registered by `@handles_unknown("FILE")` does it. An operation
without a handler fails, as those do that are in the firmware's tables but not in its machine:
`ev3proto.brick.dispatch.coverage` lists them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from ev3proto.tables import operations
from ev3proto.tables.declaration import DIALECTS

Function = Callable[..., Any]


class Handler(NamedTuple):
    """The implementation of one operation."""

    function: Function  # called with the machine and the parameters
    places: frozenset[str]  # names of the inputs that it gets as places
    raw: bool  # it reads its parameters itself
    computes: bool  # it gets the inputs only and returns the outputs


HANDLERS: dict[str, Handler] = {}
"""The handlers by operation name (`SOUND.TONE`, `UI_FLUSH`)."""

UNKNOWN_COMMANDS: dict[str, Function] = {}
"""The handlers of unknown CMDs, by opcode name."""

_NAMES = {name for dialect in DIALECTS for name in operations(dialect)}


def handles(
    *names: str, places: tuple[str, ...] = (), raw: bool = False, computes: bool = False
) -> Callable[[Function], Function]:
    """Registers a function as the handler of one or several operations. ValueError for a name that no table has."""

    def register(function: Function) -> Function:
        for name in names:
            if name not in _NAMES:
                raise ValueError(f"unknown operation {name}")
            if name in HANDLERS:
                raise ValueError(f"{name} has a handler already")
            HANDLERS[name] = Handler(function, frozenset(places), raw, computes)
        return function

    return register


def computes(functions: Mapping[str, Function]) -> None:
    """Registers functions of the inputs by the names of their operations. What they return goes to the outputs."""
    for name, function in functions.items():
        handles(name, computes=True)(function)


def handles_unknown(*opcodes: str) -> Callable[[Function], Function]:
    """Registers what opcodes do with an unknown CMD; the function gets the machine only."""

    def register(function: Function) -> Function:
        for name in opcodes:
            UNKNOWN_COMMANDS[name] = function
        return function

    return register


class DispatchEntry(NamedTuple):
    """How the machine executes one operation."""

    function: Function
    # one for each parameter; None if the handler reads its parameters itself
    readers: tuple[Callable[[Any], Any], ...] | None
    is_quick: bool = False  # whether it takes microseconds, whatever its arguments are


class Family(NamedTuple):
    """How the machine executes an opcode with CMD."""

    entries: dict[int, DispatchEntry]  # by CMD
    unknown: DispatchEntry  # of any other CMD


Dispatch = tuple[DispatchEntry | Family, ...]
"""By opcode. `ev3proto.brick.dispatch` makes it."""
