"""The line at the top of the display: the brick's name between the states of its radios and of its battery."""

from __future__ import annotations

from collections.abc import Iterator

from ev3proto.brick.devices.display.canvas import WIDTH
from ev3proto.brick.devices.display.fonts import FONTS
from ev3proto.brick.devices.display.icons import ICONS
from ev3proto.brick.devices.panel import Battery
from ev3proto.brick.settings import Settings
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.enumerations import FONTTYPE, ICONTYPE, S_ICON_NO

HEIGHT = 10
"""Rows above the line."""

FONT = FONTTYPE.members["SMALL_FONT"]
ICON_SET = ICONTYPE.members["SMALL_ICON"]
TOP = 1
"""First row of name and icons."""

_NAME_LENGTH = 12
_BATTERY = tuple(S_ICON_NO.members[f"SICON_BATT_{level}"] for level in range(5))
_CELL = FONTS[FONT].width
_ICON = ICONS[ICON_SET].width


def name_place(settings: Settings) -> tuple[int, bytes]:
    """Returns the name's column and its visible part, centred in whole cells."""
    name = settings.name.encode(STRING_CODING)[:_NAME_LENGTH]
    return (WIDTH // _CELL - len(name)) // 2 * _CELL, name


def icon_places(settings: Settings, battery: Battery) -> Iterator[tuple[int, int]]:
    """Yields the icons, each with its column."""
    if settings.bluetooth:
        yield 0, S_ICON_NO.members["SICON_BT_VISIBLE" if settings.visible else "SICON_BT_ON"]
    if settings.wifi:
        yield _ICON, S_ICON_NO.members["SICON_WIFI_3" if settings.network is None else "SICON_WIFI_CONNECTED"]
    level = min(battery.percent * len(_BATTERY) // 100, len(_BATTERY) - 1)
    yield (WIDTH // _ICON - 1) * _ICON, _BATTERY[level]
