"""Names of files in memory, as the firmware checks them."""

from __future__ import annotations

from ev3proto.brick.places import Place
from ev3proto.tables.paths import ALLOWED, has_room

REPLACEMENT = ord("_")
"""The firmware's replacement of any other character."""


def check(place: Place) -> bool:
    """Checks a name in memory; forbidden characters are replaced there, so that it passes the next time."""
    text = place.read_text()
    if not ALLOWED.issuperset(text):
        place.write_bytes(bytes(byte if byte in ALLOWED else REPLACEMENT for byte in text))
        return False
    return has_room(text)
