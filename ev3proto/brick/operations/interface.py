"""UI_READ and UI_WRITE: battery, versions, warnings, light, terminal, texts of text boxes."""

from __future__ import annotations

from collections.abc import Callable

from ev3proto.brick.conversions import NAN8, NAN16, NAN32
from ev3proto.brick.devices.panel import Panel
from ev3proto.brick.exits import Busy
from ev3proto.brick.formatting import fixed, padded
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine
from ev3proto.brick.text_lines import DELIMITERS, line_of, with_line

_NOTHING = b"nan"
_MOST_FLOAT, _MOST_FIXED, _MOST_STAMP = 23, 31, 49
"""Maximum number of characters that VALUEF, FLOATVALUE and STAMP write."""


# Versions and state of the brick


def _reads_text(name: str, source: Callable[[Panel], bytes]) -> None:
    """Registers a handler that writes a text."""

    @handles(f"UI_READ.{name}")
    def read(vm: Machine, length: int, destination: Location) -> None:
        vm.write_limited(destination, source(vm.brick.panel), length)


_reads_text("GET_HW_VERS", lambda panel: panel.versions.hardware)
_reads_text("GET_FW_VERS", lambda panel: panel.versions.firmware)
_reads_text("GET_FW_BUILD", lambda panel: panel.versions.firmware_build)
_reads_text("GET_OS_VERS", lambda panel: panel.versions.system)
_reads_text("GET_OS_BUILD", lambda panel: panel.versions.system_build)
_reads_text("GET_VERSION", lambda panel: panel.versions.whole)
_reads_text("GET_IP", lambda panel: panel.address)


def _power(vm: Machine) -> tuple[float, ...]:
    """Returns volt, ampere, ampere seconds, ampere of the motors. Sold bricks measure only the first two."""
    battery = vm.brick.panel.battery
    return battery.voltage, battery.current, 0.0, 0.0


def _write_integer(vm: Machine, number: int, not_a_number: int) -> None:
    vm.brick.console.write(_NOTHING if number == not_a_number else b"%d" % number)


computes(
    {
        "UI_READ.GET_POWER": _power,
        "UI_READ.GET_VBATT": lambda vm: _power(vm)[0],
        "UI_READ.GET_IBATT": lambda vm: _power(vm)[1],
        "UI_READ.GET_IINT": lambda vm: _power(vm)[2],
        "UI_READ.GET_IMOTOR": lambda vm: _power(vm)[3],
        # Degrees above the temperature at the start.
        "UI_READ.GET_TBATT": lambda _: 0.0,
        "UI_READ.GET_LBATT": lambda vm: vm.brick.panel.battery.percent,
        "UI_READ.GET_WARNING": lambda vm: vm.brick.panel.warnings,
        "UI_READ.KEY": lambda vm: vm.brick.console.take_key(),
        "UI_WRITE.LED": lambda vm, pattern: vm.brick.panel.set_light(pattern),
        "UI_WRITE.SET_BUSY": lambda vm, is_busy: vm.brick.panel.set_busy(bool(is_busy)),
        "UI_WRITE.TERMINAL": lambda vm, is_on: setattr(vm.brick.console, "is_on", bool(is_on)),
        "UI_FLUSH": lambda vm: vm.brick.console.flush(),
        "UI_WRITE.WRITE_FLUSH": lambda vm: vm.brick.console.flush(),
        "UI_WRITE.PUT_STRING": lambda vm, text: vm.brick.console.write(text),
        "UI_WRITE.VALUE8": lambda vm, number: _write_integer(vm, number, NAN8),
        # Written without its sign.
        "UI_WRITE.VALUE16": lambda vm, number: _write_integer(vm, number & 0xFFFF, NAN16 & 0xFFFF),
        "UI_WRITE.VALUE32": lambda vm, number: _write_integer(vm, number, NAN32),
        "UI_WRITE.VALUEF": lambda vm, number: vm.brick.console.write(fixed(number, 6).encode()[:_MOST_FLOAT]),
    }
)


@handles("UI_WRITE.FLOATVALUE")
def floatvalue(vm: Machine, number: float, figures: int, decimals: int) -> None:
    """Writes a number with a fixed number of figures."""
    vm.brick.console.write(padded(fixed(number, decimals), figures).encode()[:_MOST_FIXED])


@handles("UI_WRITE.STAMP")
def stamp(vm: Machine, remark: bytes) -> None:
    """Prints time, program, object, position and a remark."""
    place = b"%09d %d %03d %06d" % (vm.milliseconds, vm.program.slot, vm.object.number, vm.ip)
    vm.brick.console.write((b"####[ %b %b]####\r\n" % (place, remark))[:_MOST_STAMP])
    vm.brick.console.flush()


def _line(vm: Machine) -> bytes:
    """Waits for the next line typed, and returns it."""
    line = vm.brick.console.take_line()
    if line is None:
        raise Busy
    return line


@handles("UI_READ.GET_STRING")
def get_string(vm: Machine, length: int, destination: Location) -> None:
    """Writes the next line typed."""
    vm.write_limited(destination, _line(vm), length + 1 if length >= 0 else length)


@handles("UI_READ.GET_ADDRESS", computes=True)
def get_address(vm: Machine) -> int:
    """Returns the next line typed as a decimal number; 0 for any other text."""
    digits = _line(vm).strip()
    return int(digits) if digits.isdigit() else 0


# Text boxes


@handles("UI_READ.TEXTBOX_READ")
def textbox_read(
    _: Machine, text: bytes, size: int, delimiter: int, length: int, number: int, destination: Location
) -> None:
    """Writes a line of a text box."""
    line = line_of(text[: max(size, 0)], DELIMITERS.get(delimiter, b""), number)
    destination.write_text(line[: length - 1] if length > 0 else b"" if length == 0 else line)


@handles("UI_WRITE.TEXTBOX_APPEND")
def textbox_append(vm: Machine, text: Location, size: int, delimiter: int, line: bytes) -> None:
    """Appends a line to those of a text box."""
    before = text.read_text()[: max(size, 0)]
    text.write_bytes(with_line(before, line, DELIMITERS.get(delimiter, b""), vm.brick.display.font, size))
