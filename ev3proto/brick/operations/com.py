"""COM: the brick's name, and the settings of its radios, which a virtual brick lacks."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from ev3proto.brick.exits import Failure
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine
from ev3proto.brick.running_programs import OK
from ev3proto.tables.com import NAME_LETTERS
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.enumerations import HWTYPE

USB, BLUETOOTH, WIFI = (HWTYPE.members[name] for name in ("HW_USB", "HW_BT", "HW_WIFI"))
_RADIOS = (BLUETOOTH, WIFI)
_HARDWARE = 4
"""Numbers of hardware, including 0, which means none."""

PIN = b"1234"
NO_NETWORK, UNKNOWN = b"NONE", b"??"

MOST_NAME = int(CONSTANTS["BRICKNAMESIZE"]) - 2
"""Characters of the brick's name."""

_NAME = frozenset(NAME_LETTERS.encode())


def _must_be(hardware: int, *allowed: int) -> None:
    """Fails for hardware without the property, but keeps results that are already written."""
    if hardware not in allowed:
        raise Failure


# COM_GET


def _reports(name: str, value: Callable[[Machine, int], int], *allowed: int) -> None:
    """Registers a command that writes a number for any hardware, and then fails for all but some."""

    @handles(f"COM_GET.{name}")
    def report(vm: Machine, hardware: int, *rest: Any) -> None:
        rest[-1].write8(value(vm, hardware))
        _must_be(hardware, *allowed)


_reports(
    "GET_ON_OFF",
    lambda vm, hardware: {BLUETOOTH: vm.brick.settings.bluetooth, WIFI: vm.brick.settings.wifi}.get(hardware, False),
    *_RADIOS,
)
_reports("GET_MODE2", lambda vm, hardware: hardware == BLUETOOTH and vm.brick.settings.mode2, BLUETOOTH)
# Nothing is in progress, found, paired, connected or encrypted.
_reports("GET_RESULT", lambda *_: OK, *_RADIOS)
_reports("SEARCH_ITEMS", lambda *_: 0, *_RADIOS)
_reports("FAVOUR_ITEMS", lambda *_: 0, BLUETOOTH)
_reports("CONNEC_ITEMS", lambda *_: 0, USB, *_RADIOS)
_reports("GET_ENCRYPT", lambda *_: 0, WIFI)

computes({"COM_GET.GET_PRESENT": lambda _, hardware: hardware in (USB, BLUETOOTH)})


@handles("COM_GET.GET_VISIBLE", computes=True)
def get_visible(vm: Machine, hardware: int) -> bool:
    """Returns the visibility of Bluetooth, for any hardware that exists."""
    if hardware >= _HARDWARE:
        raise Failure
    return vm.brick.settings.visible


@handles("COM_GET.GET_PIN")
def get_pin(vm: Machine, hardware: int, name: bytes, length: int, pin: Location) -> None:  # noqa: ARG001
    """Writes the PIN that every brick is delivered with."""
    vm.write_limited(pin, PIN, length)


@handles("COM_GET.SEARCH_ITEM", "COM_GET.FAVOUR_ITEM", "COM_GET.CONNEC_ITEM")
def describe_item(vm: Machine, hardware: int, item: int, length: int, name: Location, *flags: Location) -> None:  # noqa: ARG001
    """Writes an empty name and zeros: no list has an item."""
    vm.write_limited(name, b"", length)
    for flag in flags:
        flag.write8(0)


@handles("COM_GET.GET_INCOMING")
def get_incoming(vm: Machine, hardware: int, length: int, name: Location, kind: Location) -> None:
    """Writes an empty name and a zero: no device requests a connection."""
    _must_be(hardware, BLUETOOTH)
    _write(vm, name, b"", length)
    kind.write8(0)


@handles("COM_GET.GET_ID")
def get_id(vm: Machine, hardware: int, length: int, destination: Location) -> None:
    """Writes Bluetooth's address, padded with zeros; no zero follows if none fits."""
    _must_be(hardware, BLUETOOTH)
    address = vm.brick.settings.bluetooth_address.encode(STRING_CODING)
    if length < 0:
        length = len(address) + 1
    if vm.resize(destination, length):
        destination.write_bytes(address[:length].ljust(length, b"\0"))


@handles("COM_GET.GET_BRICKNAME")
def get_brick_name(vm: Machine, length: int, name: Location) -> None:
    """Writes the name, cut to fit."""
    _write(vm, name, vm.brick.settings.name.encode(STRING_CODING), length)


def _room(vm: Machine, place: Location, length: int) -> int | None:
    """Resizes an array to a length, -1 for the longest name. Returns its size; None for an unknown array."""
    if place.handle >= 0 and length == -1:
        length = int(CONSTANTS["BRICKNAMESIZE"])
    return length if vm.resize(place, length) else None


def _write(vm: Machine, place: Location, text: bytes, length: int) -> None:
    room = _room(vm, place, length)
    if room is not None:
        place.write_cut(text, room)


@handles("COM_GET.GET_NETWORK")
def get_network(vm: Machine, hardware: int, length: int, *places: Location) -> None:
    """Writes name, MAC and IP address of WiFi; nothing for other hardware."""
    rooms = [_room(vm, place, length) for place in places]
    if hardware != WIFI or rooms[0] is None or None in rooms:
        return
    settings = vm.brick.settings
    network = settings.network if settings.wifi else None
    places[0].write_cut(network.encode(STRING_CODING) if network else NO_NETWORK, rooms[0])
    # The firmware does not cut addresses.
    places[1].write_text(settings.mac.encode(STRING_CODING) if settings.wifi else UNKNOWN)
    places[2].write_text(settings.ip.encode(STRING_CODING) if network and settings.ip else UNKNOWN)


# COM_SET


@handles("COM_SET.SET_BRICKNAME", places=("NAME",))
def set_brick_name(vm: Machine, name: Location) -> None:
    """Sets the name. Other characters than letters, digits, _ and - become _ in the caller's own text, and it fails."""
    text = name.read_text()
    if not _NAME.issuperset(text):
        name.write_bytes(bytes(byte if byte in _NAME else ord("_") for byte in text))
        raise Failure
    if len(text) > MOST_NAME:
        raise Failure
    vm.brick.settings.name = text.decode(STRING_CODING)


def _switches(name: str, settings: Mapping[int, str], *, fails: bool = True) -> None:
    """Registers a command that sets a flag of some hardware; for other hardware it fails or does nothing."""

    @handles(f"COM_SET.{name}")
    def switch(vm: Machine, hardware: int, value: int) -> None:
        if hardware in settings:
            setattr(vm.brick.settings, settings[hardware], value != 0)
        elif fails:
            raise Failure


_switches("SET_ON_OFF", {BLUETOOTH: "bluetooth", WIFI: "wifi"})
_switches("SET_VISIBLE", {BLUETOOTH: "visible"}, fails=False)
_switches("SET_MODE2", {BLUETOOTH: "mode2"})


def _accepts(allowed: tuple[int, ...], *names: str) -> None:
    """Registers commands that are accepted for some hardware and have no effect here."""
    handles(*(f"COM_SET.{name}" for name in names))(lambda _, hardware, *__: _must_be(hardware, *allowed))


_accepts(_RADIOS, "SET_SEARCH", "SET_PIN", "SET_CONNECTION")
_accepts((BLUETOOTH,), "SET_PASSKEY")
_accepts((WIFI,), "SET_MOVEUP", "SET_MOVEDOWN", "SET_ENCRYPT", "SET_SSID")
