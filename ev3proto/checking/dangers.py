"""What a frame would do to a brick that is worse than a sound: no suggestion is tacitly worse than the frame."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
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


Act = tuple[Danger, str]
"""A danger, and the name of the operation; no name where another operation makes nothing worse, as for motors."""


def acts_of(frame: bytes, dialect: str) -> Counter[Act]:
    """Returns what the operations of a frame would do, as far as they can be read, or its system command."""
    if len(frame) < HEADER_SIZE:
        return Counter()
    message = read_last(with_length(frame[LENGTH_FIELD:]), dialect)
    found: list[tuple[str, tuple[Effect, ...]]] = []
    if isinstance(message, DirectCommand):
        found = [(one.full_name, one.declaration.effects) for one in message.operations if one.declaration.effects]
    elif isinstance(message, SystemCommand) and message.number in SYSTEM_BY_NUMBER:
        found = [("", SYSTEM_BY_NUMBER[message.number].effects)]
    return Counter(_acts(found))


def _acts(found: list[tuple[str, tuple[Effect, ...]]]) -> Iterator[Act]:
    for one in DANGERS:
        names = [name for name, effects in found if not one.effects.isdisjoint(effects)]
        yield from {(one, "") for _ in names} if one.is_told else ((one, name) for name in names)


def warning(acts: Iterable[Act]) -> str:
    """Returns half a sentence about acts, empty if there are none."""
    words = list(dict.fromkeys(one.words for one, _ in acts))
    return f"this would {', and '.join(words)}" if words else ""
