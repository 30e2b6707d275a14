"""What a frame would do to a brick that is worse than a sound: no suggestion is tacitly worse than the frame."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
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


def dangers_of(frame: bytes, dialect: str) -> Counter[Danger]:
    """Returns what the operations of a frame would do, as far as they can be read, or its system command.

    How often counts where one more would be worse, not for motors that turn anyway.
    """
    if len(frame) < HEADER_SIZE:
        return Counter()
    message = read_last(with_length(frame[LENGTH_FIELD:]), dialect)
    acts: list[tuple[Effect, ...]] = []
    if isinstance(message, DirectCommand):
        acts = [one.declaration.effects for one in message.operations if one.declaration.effects]
    elif isinstance(message, SystemCommand) and message.number in SYSTEM_BY_NUMBER:
        acts = [SYSTEM_BY_NUMBER[message.number].effects]
    found = Counter(one for effects in acts for one in DANGERS if not one.effects.isdisjoint(effects))
    return Counter({one: 1 if one.is_told else count for one, count in found.items()})


def warning(dangers: Iterable[Danger]) -> str:
    """Returns half a sentence about dangers, empty if there are none."""
    words = [one.words for one in DANGERS if one in set(dangers)]
    return f"this would {', and '.join(words)}" if words else ""
