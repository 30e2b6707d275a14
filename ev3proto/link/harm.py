"""The effects of a message on a brick besides reading: a list of what is harmless, by the facts in the tables.

A proxy for untrusted clients forwards only what is on the list. A replay also sends what `--allow` names, by group.
"""

from __future__ import annotations

from collections.abc import Container
from enum import StrEnum

from ev3proto.link.whitelist import blamed
from ev3proto.messages import Message
from ev3proto.tables.declaration import Effect


class Harm(StrEnum):
    """A group of effects, as it is named on the command line."""

    text: str  # a description that completes "it ..."
    effects: tuple[Effect, ...]  # the most serious first

    def __new__(cls, name: str, text: str, *effects: Effect) -> Harm:
        """Creates a group from its name, text and effects."""
        harm = str.__new__(cls, name)
        harm._value_ = name
        harm.text, harm.effects = text, effects
        return harm

    MOTORS = (
        "motors",
        "makes motors turn or stop",
        Effect.RUNS_MOTORS,
        Effect.STARTS_MOVE,
        Effect.SETS_MOTORS,
        Effect.STOPS_MOTORS,
    )
    FILES = "files", "creates or changes files", Effect.WRITES_FILES
    DELETES = "deletes", "deletes files or folders", Effect.DELETES_FILES
    SETTINGS = "settings", "changes settings", Effect.CHANGES_SETTINGS, Effect.RENAMES
    PROGRAMS = "programs", "starts, stops or changes programs", Effect.CONTROLS_PROGRAMS, Effect.OF_PROGRAMS
    MESSAGES = "messages", "uses the mailboxes of programs", Effect.SENDS_MESSAGES, Effect.USES_MAILBOXES
    BUTTONS = "buttons", "presses buttons", Effect.PRESSES_BUTTONS
    DEVICES = "devices", "writes to sensors or circuits", Effect.WRITES_TO_DEVICES, Effect.RESETS_SENSORS
    SOUNDS = "sounds", "starts or ends a sound", Effect.STARTS_SOUND, Effect.ENDS_SOUND
    DISPLAY = (
        "display",
        "changes what the display or the terminal shows",
        Effect.DIALOG,
        Effect.SHOWS,
        Effect.WIPES,
        Effect.DRAWS,
        Effect.PRINTS,
    )
    LIGHTS = "lights", "changes the lights, or plays a signal", Effect.SIGNALS
    RESTARTS = "restarts", "restarts the brick", Effect.RESTARTS
    FIRMWARE = "firmware", "erases or writes firmware", Effect.WRITES_FIRMWARE
    SHELL = "shell", "runs a command on the brick's operating system", Effect.RUNS_SHELL
    COMPUTING = "computing", "does more than read, such as computing, jumping or waiting", Effect.COMPUTES, Effect.READS
    UNKNOWN = "unknown", "may do anything"


_GROUPED = frozenset(effect for harm in Harm for effect in harm.effects)


def harms_of(message: Message, allowed: Container[str] = ()) -> dict[Harm, str]:
    """Returns what a message may do besides reading: each group with the first operation that does it."""
    does = list(blamed(message))
    found: dict[Harm, str] = {}
    for harm in Harm:
        named = (one for effect in harm.effects for one in does if effect in one.effects and one.name not in allowed)
        first = next(named, None)
        if first is not None and harm not in allowed:
            found[harm] = first.name + first.detail
    others = [one.name for one in does if _GROUPED.isdisjoint(one.effects)]
    if others and Harm.UNKNOWN not in allowed:
        found[Harm.UNKNOWN] = others[0]
    return found
