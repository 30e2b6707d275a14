"""The settings of a brick: name, volume, radios, the log of errors."""

from __future__ import annotations

from dataclasses import dataclass, field

from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.errors import ERROR_NUMBERS, LOGGED


@dataclass
class Settings:
    """Settings of a brick that was never used before."""

    name: str = "EV3"  # as on its display
    volume: int = int(CONSTANTS["DEFAULT_VOLUME"])  # meant to be 0 to 100; any byte is accepted
    minutes: int = int(CONSTANTS["DEFAULT_SLEEPMINUTES"])  # until an idle brick switches off; any byte is accepted
    bluetooth: bool = True  # whether it is on
    visible: bool = True  # whether the brick is visible by Bluetooth
    bluetooth_address: str = "0016530f0c1e"  # 12 hexadecimal digits in lower case
    mode2: bool = False  # Bluetooth's mode for Apple devices
    wifi: bool = False  # whether it is on
    network: str | None = None  # of WiFi, as COM_GET.GET_NETWORK says it; None: not connected
    mac: str = "44:49:94:0F:0C:1E"
    ip: str | None = None  # None: not connected
    errors: list[int] = field(default_factory=list)  # the log of errors, oldest first

    def log_error(self, name: str) -> None:
        """Adds an error by its name, unless the log is full."""
        self.log_error_number(ERROR_NUMBERS[name])

    def log_once(self, name: str) -> None:
        """Adds an error by its name unless it is in the log."""
        if ERROR_NUMBERS[name] not in self.errors:
            self.log_error(name)

    def log_error_number(self, number: int) -> None:
        """Adds an error by its number; 0 is ignored, and where the log is full the error is dropped."""
        if number and len(self.errors) < LOGGED:
            self.errors.append(number)
