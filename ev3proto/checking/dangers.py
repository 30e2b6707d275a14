"""What a frame would do to a brick that is worse than a sound: no suggestion is tacitly worse than the frame."""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.messages import DirectCommand, SystemCommand
from ev3proto.schema.frame import read_last
from ev3proto.schema.header import HEADER_SIZE, with_length
from ev3proto.tables.declaration import Effect
from ev3proto.tables.frame import LENGTH_FIELD
from ev3proto.tables.system import SYSTEM_BY_NUMBER


class Danger(NamedTuple):
    """What a suggestion may do that the given frame does not.

    words    complete "this would ..."
    effects  any of them
    cost     what it makes a candidate dearer
    is_told  whether it is suggested, and told, for a frame that the brick accepts
    """

    words: str
    effects: frozenset[Effect]
    cost: float = 1.0
    is_told: bool = False


DANGERS = (
    Danger("erase or write the brick's firmware", frozenset((Effect.WRITES_FIRMWARE,))),
    Danger("restart the brick", frozenset((Effect.RESTARTS,))),
    Danger("run a command on the brick's operating system", frozenset((Effect.RUNS_SHELL,))),
    Danger("write the brick's flash memory", frozenset((Effect.WRITES_FILES,))),
    Danger("delete files", frozenset((Effect.DELETES_FILES,))),
    Danger("start, stop or change programs", frozenset((Effect.CONTROLS_PROGRAMS,))),
    Danger("press buttons", frozenset((Effect.PRESSES_BUTTONS,))),
    Danger("make motors turn", frozenset((Effect.RUNS_MOTORS, Effect.STARTS_MOVE)), 0.5, is_told=True),
    Danger("give the brick another name", frozenset((Effect.RENAMES,)), 0.5, is_told=True),
)


def dangers_of(frame: bytes, dialect: str) -> frozenset[Danger]:
    """Returns what the operations of a frame would do, as far as they can be read, or its system command."""
    if len(frame) < HEADER_SIZE:
        return frozenset()
    message = read_last(with_length(frame[LENGTH_FIELD:]), dialect)
    effects = set[Effect]()
    if isinstance(message, DirectCommand):
        effects = effects.union(*[one.declaration.effects for one in message.operations])
    elif isinstance(message, SystemCommand) and message.number in SYSTEM_BY_NUMBER:
        effects = {*SYSTEM_BY_NUMBER[message.number].effects}
    return frozenset(one for one in DANGERS if not one.effects.isdisjoint(effects))


def warning(dangers: frozenset[Danger]) -> str:
    """Returns half a sentence about dangers, empty if there are none."""
    words = [one.words for one in DANGERS if one in dangers]
    return f"this would {', and '.join(words)}" if words else ""
