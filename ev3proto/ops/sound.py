"""SOUND: plays or stops a sound.

Generated from ev3proto/tables: edit those, then run python -m ev3proto.generate.
"""

from __future__ import annotations

from ev3proto.ops.argument_types import Number, Text
from ev3proto.semantics.drafts.draft import Draft
from ev3proto.semantics.drafts.functions import drafts

__all__ = ["break_", "play", "repeat", "service", "tone"]

_OPERATIONS = drafts("official")


def break_(*, unchecked: bool = False) -> Draft:
    """Stops the tone or file that is playing."""
    return _OPERATIONS["SOUND.BREAK"].draft((), unchecked)


def tone(volume: Number, frequency: Number, duration: Number, *, unchecked: bool = False) -> Draft:
    """Plays one tone and returns at once.

    Args:
        volume: Volume; 0 to 100 %; 0: silent; DATA8.
        frequency: Pitch; the driver clamps it to the range; 250 to 10000 Hz; DATA16.
        duration: Duration, read unsigned (-1 is 65535); ms; 0: until BREAK or the next sound; DATA16.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SOUND.TONE"].draft((volume, frequency, duration), unchecked)


def play(volume: Number, name: Text, *, unchecked: bool = False) -> Draft:
    """Plays a sound file once and returns at once.

    Args:
        volume: Volume; 0 to 100 %; 0: silent; DATA8.
        name: Sound file without its extension .rsf, absolute or relative to /home/root/lms2012/sys; at most 119
            characters; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SOUND.PLAY"].draft((volume, name), unchecked)


def repeat(volume: Number, name: Text, *, unchecked: bool = False) -> Draft:
    """Plays a sound file over and over until BREAK and returns at once.

    Args:
        volume: Volume; 0 to 100 %; 0: silent; DATA8.
        name: Sound file without its extension .rsf, absolute or relative to /home/root/lms2012/sys; at most 119
            characters; string.
        unchecked: Accept values that mean nothing to the brick, as far as they can be encoded.
    """
    return _OPERATIONS["SOUND.REPEAT"].draft((volume, name), unchecked)


def service(*, unchecked: bool = False) -> Draft:
    """Does nothing; the number is used inside the firmware to feed the sound driver."""
    return _OPERATIONS["SOUND.SERVICE"].draft((), unchecked)
