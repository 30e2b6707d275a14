"""The firmware's enumerations for use in Python: `LED.RED_FLASH`, `BUTTON.UP`, `TYPE.TYPE_TOUCH`.

Each is a class under the firmware's name with members under the firmware's names (`LEDPATTERN.LED_RED_FLASH`). Where
all members begin or end with the same word, they have a name without it, too, and the class that word as its name
(`LED.RED_FLASH`). All are made from the tables when they are first asked for.
"""

from typing import Any

from ev3proto.enums.making import enumeration, enumeration_names


def __getattr__(name: str) -> Any:
    """An enumeration by name."""
    try:
        value = globals()[name] = enumeration(name)
    except KeyError as error:
        raise AttributeError(error.args[0]) from None
    return value


def __dir__() -> list[str]:
    return enumeration_names()
