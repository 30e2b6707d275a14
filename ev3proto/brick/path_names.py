"""Names of files in memory, as the firmware checks them."""

from __future__ import annotations

from ev3proto.brick.locations import Location
from ev3proto.tables.paths import ALLOWED, has_room, is_spelled

REPLACEMENT = ord("_")
"""The firmware's replacement of any other character."""

_REPLACED = bytes(byte if byte in ALLOWED else REPLACEMENT for byte in range(256))


def check(place: Location) -> bool:
    """Checks a name in memory; forbidden characters are replaced there, so that it passes the next time."""
    text = place.read_text()
    if not is_spelled(text):
        place.write_bytes(text.translate(_REPLACED))
        return False
    return has_room(text)
