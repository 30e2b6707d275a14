"""The state that UI_READ and UI_WRITE access: versions, battery, light and warnings."""

from __future__ import annotations

from dataclasses import dataclass, field

from ev3proto.brick.devices import Part
from ev3proto.brick.running_programs import USER_SLOT, Program
from ev3proto.tables.enumerations import LEDPATTERN, WARNING

_LED = LEDPATTERN.members
_ORANGE = {
    _LED[f"LED_{color}{rhythm}"]: _LED[f"LED_ORANGE{rhythm}"]
    for color in ("GREEN", "RED", "ORANGE")
    for rhythm in ("", "_FLASH", "_PULSE")
}
_BUSY = WARNING.members["WARNING_BUSY"]
_BATTERY_LOW = WARNING.members["WARNING_BATTLOW"]
_EMPTY, _SPAN = 6200, 1300
"""Millivolts of six empty cells, and how many more full ones have."""
_SHOWN = (WARNING.end[1] if WARNING.end else 0) | _BATTERY_LOW


@dataclass(frozen=True)
class Versions:
    """The brick's versions; a real one's contain the day of its build."""

    hardware: bytes = b"V0.60"
    firmware: bytes = b"V1.04H"
    firmware_build: bytes = b"1307261200"
    system: bytes = b"Linux 2.6.33-rc4"
    system_build: bytes = b"1212131117"
    whole: bytes = b"LMS2012 V1.04H(Jul 26 2013 12:00:00)"


@dataclass
class Battery:
    """Six good cells, which do not run down."""

    voltage: float = 7.5  # volt
    current: float = 0.2  # ampere

    @property
    def percent(self) -> int:
        """Charge in percent."""
        return max(0, min(100, int((self.voltage * 1000 - _EMPTY) * 100 / _SPAN)))


@dataclass
class Panel(Part):
    """The state of a brick that has just been switched on: green light, no warning."""

    versions: Versions = field(default_factory=Versions)
    battery: Battery = field(default_factory=Battery)
    pattern: int = _LED["LED_GREEN"]  # of the light, as it was set
    warnings: int = 0  # bits of WARNING
    address: bytes = b""  # IP address of the cable's network interface

    @property
    def light(self) -> int:
        """The visible pattern of the light, 0 to 9; its colour is orange while a warning is pending."""
        return _ORANGE.get(self.pattern, self.pattern) if self.warnings & _SHOWN else self.pattern

    def set_light(self, pattern: int) -> None:
        """Sets the light; numbers beyond the patterns are clamped."""
        self.pattern = max(min(_LED.values()), min(pattern, max(_LED.values())))

    def set_busy(self, is_busy: bool) -> None:
        """Sets or clears the busy bit among the warnings."""
        self.warnings = self.warnings | _BUSY if is_busy else self.warnings & ~_BUSY

    def program_started(self, program: Program) -> None:
        """Makes the light pulse while a user program runs, until it sets another pattern."""
        if program.slot == USER_SLOT:
            self.pattern = _LED["LED_GREEN_PULSE"]

    def program_ended(self, program: Program) -> None:
        """Makes the light green again after a user program, and clears the busy bit."""
        if program.slot == USER_SLOT:
            self.set_busy(False)
            self.pattern = _LED["LED_GREEN"]
