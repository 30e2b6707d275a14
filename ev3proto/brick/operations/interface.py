"""UI_READ and UI_WRITE: battery, versions, warnings, light, terminal, texts of text boxes."""

from __future__ import annotations

from collections.abc import Callable

from ev3proto.brick.conversions import NAN8, NAN16, NAN32
from ev3proto.brick.devices.panel import Panel
from ev3proto.brick.formatting import fixed
from ev3proto.brick.handlers import handles, handles_unknown
from ev3proto.brick.machine import Machine
from ev3proto.brick.places import Place
from ev3proto.brick.text_lines import DELIMITERS, line_of, with_line

_NOTHING = b"nan"
_MOST_FLOAT, _MOST_FIXED, _MOST_STAMP = 23, 31, 49
"""Characters that VALUEF, FLOATVALUE and STAMP write at most."""


# What the brick is and how it is doing


def _reads_text(name: str, source: Callable[[Panel], bytes]) -> None:
    """Registers a handler that returns a text."""

    @handles(name)
    def read(vm: Machine, length: int, destination: Place) -> None:
        vm.write_limited(destination, source(vm.brick.panel), length)


_reads_text("UI_READ.GET_HW_VERS", lambda panel: panel.versions.hardware)
_reads_text("UI_READ.GET_FW_VERS", lambda panel: panel.versions.firmware)
_reads_text("UI_READ.GET_FW_BUILD", lambda panel: panel.versions.firmware_build)
_reads_text("UI_READ.GET_OS_VERS", lambda panel: panel.versions.system)
_reads_text("UI_READ.GET_OS_BUILD", lambda panel: panel.versions.system_build)
_reads_text("UI_READ.GET_VERSION", lambda panel: panel.versions.whole)
_reads_text("UI_READ.GET_IP", lambda panel: panel.address)


def _reads_numbers(name: str, *sources: Callable[[Panel], float]) -> None:
    """Registers a handler that returns numbers of type DATAF."""

    @handles(name)
    def read(vm: Machine, *destinations: Place) -> None:
        for destination, source in zip(destinations, sources, strict=True):
            destination.write_float(source(vm.brick.panel))


def _voltage(panel: Panel) -> float:
    return panel.battery.voltage


def _current(panel: Panel) -> float:
    return panel.battery.current


def _integrated(panel: Panel) -> float:
    return panel.battery.integrated


def _motor_current(panel: Panel) -> float:
    return panel.battery.motor_current


_reads_numbers("UI_READ.GET_VBATT", _voltage)
_reads_numbers("UI_READ.GET_IBATT", _current)
_reads_numbers("UI_READ.GET_IINT", _integrated)
_reads_numbers("UI_READ.GET_IMOTOR", _motor_current)
_reads_numbers("UI_READ.GET_TBATT", lambda panel: panel.battery.warming)
_reads_numbers("UI_READ.GET_POWER", _voltage, _current, _integrated, _motor_current)


@handles("UI_READ.GET_LBATT")
def get_lbatt(vm: Machine, percent: Place) -> None:
    """How full the battery is."""
    percent.write8(vm.brick.panel.battery.percent)


@handles("UI_READ.GET_EVENT")
def get_event(vm: Machine, event: Place) -> None:
    """The pending event, once."""
    panel = vm.brick.panel
    event.write8(panel.event)
    panel.event = 0


@handles("UI_READ.GET_SHUTDOWN")
def get_shutdown(vm: Machine, flag: Place) -> None:
    """The wish to shut down, once."""
    panel = vm.brick.panel
    flag.write8(panel.wants_shutdown)
    panel.wants_shutdown = 0


@handles("UI_READ.GET_WARNING")
def get_warning(vm: Machine, warnings: Place) -> None:
    """The warnings, one bit each."""
    warnings.write8(vm.brick.panel.warnings)


@handles("UI_READ.GET_SDCARD", "UI_READ.GET_USBSTICK")
def get_storage(_: Machine, is_present: Place, total: Place, free: Place) -> None:
    """Neither card nor stick is in a virtual brick."""
    is_present.write8(0)
    total.write32(0)
    free.write32(0)


@handles("UI_WRITE.LED")
def led(vm: Machine, pattern: int) -> None:
    """The light behind the buttons."""
    vm.brick.panel.set_light(pattern)


@handles("UI_WRITE.SET_BUSY")
def set_busy(vm: Machine, is_busy: int) -> None:
    """The busy bit among the warnings."""
    vm.brick.panel.set_busy(bool(is_busy))


@handles("UI_WRITE.INIT_RUN", "UI_WRITE.UPDATE_RUN", "UI_WRITE.DOWNLOAD_END")
def pass_over(_: Machine) -> None:
    """The brick's own menus are not there, whose state this is."""


@handles("UI_WRITE.SET_TESTPIN", "UI_WRITE.POWER")
def pass_over_state(_: Machine, __: int) -> None:
    """What it sets cannot be seen from outside."""


# The terminal


@handles("UI_WRITE.TERMINAL")
def terminal(vm: Machine, is_on: int) -> None:
    """Switches the terminal on or off."""
    vm.brick.console.is_on = bool(is_on)


@handles("UI_FLUSH", "UI_WRITE.WRITE_FLUSH")
def flush(vm: Machine) -> None:
    """Prints what was written."""
    vm.brick.console.flush()


@handles("UI_WRITE.PUT_STRING")
def put_string(vm: Machine, text: bytes) -> None:
    """A text."""
    vm.brick.console.write(text)


@handles("UI_WRITE.VALUE8")
def value8(vm: Machine, number: int) -> None:
    """A whole number."""
    vm.brick.console.write(_NOTHING if number == NAN8 else b"%d" % number)


@handles("UI_WRITE.VALUE16")
def value16(vm: Machine, number: int) -> None:
    """A whole number without its sign."""
    vm.brick.console.write(_NOTHING if number == NAN16 else b"%d" % (number & 0xFFFF))


@handles("UI_WRITE.VALUE32")
def value32(vm: Machine, number: int) -> None:
    """A whole number."""
    vm.brick.console.write(_NOTHING if number == NAN32 else b"%d" % number)


@handles("UI_WRITE.VALUEF")
def valuef(vm: Machine, number: float) -> None:
    """A number with six decimals."""
    vm.brick.console.write(fixed(number, 6).encode()[:_MOST_FLOAT])


@handles("UI_WRITE.FLOATVALUE")
def floatvalue(vm: Machine, number: float, figures: int, decimals: int) -> None:
    """A number in a fixed format."""
    digits = fixed(number, decimals)
    digits = digits.rjust(figures) if figures >= 0 else digits.ljust(-figures)
    vm.brick.console.write(digits.encode()[:_MOST_FIXED])


@handles("UI_WRITE.STAMP")
def stamp(vm: Machine, remark: bytes) -> None:
    """Time, program, object, position and a remark; printed at once."""
    place = b"%09d %d %03d %06d" % (vm.milliseconds, vm.program.slot, vm.object.number, vm.ip)
    vm.brick.console.write((b"####[ %b %b]####\r\n" % (place, remark))[:_MOST_STAMP])
    vm.brick.console.flush()


@handles("UI_WRITE.CODE")
def code(vm: Machine, *_: int) -> None:
    """Memory at an address of the real brick, which means nothing here."""
    vm.fail()


@handles("UI_WRITE.ALLOW_PULSE", "UI_WRITE.SET_PULSE", "UI_WRITE.ADDRESS", raw=True)
def no_code(vm: Machine) -> None:
    """The firmware of 2013 has no code for these."""
    vm.fail()


@handles_unknown("UI_WRITE")
def unknown_write(vm: Machine) -> None:
    """UI_WRITE is one of those that fail."""
    vm.fail()


@handles("UI_READ.KEY")
def key(vm: Machine, destination: Place) -> None:
    """The next character typed."""
    destination.write8(vm.brick.console.take_key())


def _line(vm: Machine) -> bytes:
    """The next line typed, waited for."""
    line = vm.brick.console.take_line()
    if line is None:
        vm.wait()
        return b""
    return line


@handles("UI_READ.GET_STRING")
def get_string(vm: Machine, length: int, destination: Place) -> None:
    """The next line typed."""
    vm.write_limited(destination, _line(vm), length + 1 if length >= 0 else length)


@handles("UI_READ.GET_ADDRESS")
def get_address(vm: Machine, destination: Place) -> None:
    """The next line typed, as a decimal number."""
    digits = _line(vm).strip()
    destination.write32(int(digits) if digits.isdigit() else 0)


@handles("UI_READ.GET_CODE")
def get_code(vm: Machine, *_: object) -> None:
    """Byte code typed in is not taken: it waits as for a line that nobody types."""
    vm.wait()


# Text boxes


@handles("UI_READ.TEXTBOX_READ")
def textbox_read(
    _: Machine, text: bytes, size: int, delimiter: int, length: int, number: int, destination: Place
) -> None:
    """A line of a text box."""
    line = line_of(text[: max(size, 0)], DELIMITERS.get(delimiter, b""), number)
    destination.write_text(line[: length - 1] if length > 0 else b"" if length == 0 else line)


@handles("UI_WRITE.TEXTBOX_APPEND")
def textbox_append(vm: Machine, text: Place, size: int, delimiter: int, line: bytes) -> None:
    """A line after those of a text box."""
    before = text.read_text()[: max(size, 0)]
    whole = with_line(before, line, DELIMITERS.get(delimiter, b""), vm.brick.display.font, size)
    text.write_bytes(whole)
