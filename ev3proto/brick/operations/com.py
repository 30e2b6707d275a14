"""COM: what the brick says of its radios and its name, and what of them can be changed. There are no radios here."""

from __future__ import annotations

from ev3proto.brick.handlers import handles, handles_unknown
from ev3proto.brick.machine import Machine
from ev3proto.brick.operation_exits import Failure
from ev3proto.brick.places import Place
from ev3proto.brick.running_programs import OK
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.enumerations import HWTYPE

USB, BLUETOOTH, WIFI = (HWTYPE.members[name] for name in ("HW_USB", "HW_BT", "HW_WIFI"))
_RADIOS = (BLUETOOTH, WIFI)
_HARDWARE = 4
"""Numbers of hardware, 0 among them, which is none."""

PIN = b"1234"
NO_NETWORK, UNKNOWN = b"NONE", b"??"

MOST_NAME = int(CONSTANTS["BRICKNAMESIZE"]) - 2
"""Characters of the brick's name."""

_NAME = frozenset(b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-")


def _must_be(hardware: int, *allowed: int) -> None:
    """Fails for hardware that has not got the property; what has been written stays."""
    if hardware not in allowed:
        raise Failure


@handles_unknown("COM_GET", "COM_SET")
def unknown(_: Machine) -> None:
    """Fails."""
    raise Failure


@handles("COM_READY")
def ready(_: Machine, hardware: int, name: bytes) -> None:
    """At once."""


@handles("COM_TEST")
def test(_: Machine, hardware: int, name: bytes, busy: Place) -> None:  # noqa: ARG001
    """Never busy."""
    busy.write8(0)


@handles("COM_REMOVE", "COM_WRITEFILE")
def nothing(_: Machine, *__: object) -> None:
    """There is no other device."""


# COM_GET


@handles("COM_GET.GET_ON_OFF")
def get_on_off(vm: Machine, hardware: int, active: Place) -> None:
    """Of Bluetooth and WiFi; others are off, and it fails."""
    settings = vm.brick.settings
    active.write8({BLUETOOTH: settings.bluetooth, WIFI: settings.wifi}.get(hardware, False))
    if hardware not in _RADIOS:
        raise Failure


@handles("COM_GET.GET_VISIBLE")
def get_visible(vm: Machine, hardware: int, visible: Place) -> None:
    """Of Bluetooth, whichever hardware is meant."""
    if hardware >= _HARDWARE:
        raise Failure
    visible.write8(vm.brick.settings.visible)


@handles("COM_GET.GET_RESULT")
def get_result(_: Machine, hardware: int, item: int, result: Place) -> None:  # noqa: ARG001
    """Nothing is under way."""
    result.write8(OK)
    _must_be(hardware, *_RADIOS)


@handles("COM_GET.GET_PIN")
def get_pin(vm: Machine, hardware: int, name: bytes, length: int, pin: Place) -> None:  # noqa: ARG001
    """Always the same."""
    vm.write_limited(pin, PIN, length)


@handles("COM_GET.LIST_STATE")
def list_state(_: Machine, hardware: int, state: Place) -> None:  # noqa: ARG001
    """No list ever changes."""
    state.write16(0)


@handles("COM_GET.SEARCH_ITEMS")
def count_found(_: Machine, hardware: int, items: Place) -> None:
    """None."""
    items.write8(0)
    _must_be(hardware, *_RADIOS)


@handles("COM_GET.FAVOUR_ITEMS")
def count_favourites(_: Machine, hardware: int, items: Place) -> None:
    """None; only Bluetooth has some."""
    items.write8(0)
    _must_be(hardware, BLUETOOTH)


@handles("COM_GET.CONNEC_ITEMS")
def count_connections(_: Machine, hardware: int, items: Place) -> None:
    """None."""
    items.write8(0)
    _must_be(hardware, USB, *_RADIOS)


@handles("COM_GET.SEARCH_ITEM", "COM_GET.FAVOUR_ITEM", "COM_GET.CONNEC_ITEM")
def describe_item(vm: Machine, hardware: int, item: int, length: int, name: Place, *flags: Place) -> None:  # noqa: ARG001
    """There is none: no name, nothing that holds."""
    vm.write_limited(name, b"", length)
    for flag in flags:
        flag.write8(0)


@handles("COM_GET.GET_INCOMING")
def get_incoming(vm: Machine, hardware: int, length: int, name: Place, kind: Place) -> None:
    """Nobody asks for a connection."""
    _must_be(hardware, BLUETOOTH)
    _write(vm, name, b"", length)
    kind.write8(0)


@handles("COM_GET.GET_ENCRYPT")
def get_encryption(_: Machine, hardware: int, item: int, kind: Place) -> None:  # noqa: ARG001 - there is no item
    """None; only of WiFi."""
    kind.write8(0)
    _must_be(hardware, WIFI)


@handles("COM_GET.GET_ID")
def get_id(vm: Machine, hardware: int, length: int, destination: Place) -> None:
    """Bluetooth's address, filled up with zeros; no zero follows where there is no room for one."""
    if hardware != BLUETOOTH:
        raise Failure
    address = vm.brick.settings.bluetooth_address.encode(STRING_CODING)
    if length < 0:
        length = len(address) + 1
    if vm.resize(destination, length):
        destination.write_bytes(address[:length].ljust(length, b"\0"))


@handles("COM_GET.GET_BRICKNAME")
def get_brick_name(vm: Machine, length: int, name: Place) -> None:
    """Cut to what there is room for."""
    _write(vm, name, vm.brick.settings.name.encode(STRING_CODING), length)


def _room(vm: Machine, place: Place, length: int) -> int | None:
    """Makes an array as long as was asked for, or as the longest name for -1.

    Returns the room that there is; None where there is no such array.
    """
    if place.handle >= 0 and length == -1:
        length = int(CONSTANTS["BRICKNAMESIZE"])
    return length if vm.resize(place, length) else None


def _write(vm: Machine, place: Place, text: bytes, length: int) -> None:
    room = _room(vm, place, length)
    if room is not None:
        place.write_cut(text, room)


@handles("COM_GET.GET_NETWORK")
def get_network(vm: Machine, hardware: int, length: int, name: Place, mac: Place, ip: Place) -> None:
    """Of WiFi; nothing is written for others."""
    places = (name, mac, ip)
    rooms = [_room(vm, place, length) for place in places]
    if hardware != WIFI or None in rooms:
        return
    settings = vm.brick.settings
    is_connected = settings.wifi and settings.network is not None
    texts = (
        settings.network.encode(STRING_CODING) if is_connected and settings.network else NO_NETWORK,
        settings.mac.encode(STRING_CODING) if settings.wifi else UNKNOWN,
        settings.ip.encode(STRING_CODING) if is_connected and settings.ip else UNKNOWN,
    )
    name.write_cut(texts[0], length if rooms[0] is None else rooms[0])
    # The firmware does not cut addresses.
    for place, text in zip(places[1:], texts[1:], strict=True):
        place.write_text(text)


@handles("COM_GET.GET_PRESENT")
def get_present(_: Machine, hardware: int, present: Place) -> None:
    """USB and Bluetooth always are."""
    present.write8(hardware in (USB, BLUETOOTH))


@handles("COM_GET.GET_MODE2")
def get_mode2(vm: Machine, hardware: int, active: Place) -> None:
    """Of Bluetooth; of others 0, and it fails."""
    active.write8(hardware == BLUETOOTH and vm.brick.settings.mode2)
    _must_be(hardware, BLUETOOTH)


# COM_SET


@handles("COM_SET.SET_BRICKNAME", places=("NAME",))
def set_brick_name(vm: Machine, name: Place) -> None:
    """Other characters than letters, digits, _ and - become _ in the caller's own text, and it fails."""
    text = name.read_text()
    if not _NAME.issuperset(text):
        name.write_bytes(bytes(byte if byte in _NAME else ord("_") for byte in text))
        raise Failure
    if len(text) > MOST_NAME:
        raise Failure
    vm.brick.settings.name = text.decode(STRING_CODING)


@handles("COM_SET.SET_ON_OFF")
def set_on_off(vm: Machine, hardware: int, active: int) -> None:
    """Of Bluetooth and WiFi."""
    if hardware == BLUETOOTH:
        vm.brick.settings.bluetooth = active != 0
    elif hardware == WIFI:
        vm.brick.settings.wifi = active != 0
    else:
        raise Failure


@handles("COM_SET.SET_VISIBLE")
def set_visible(vm: Machine, hardware: int, visible: int) -> None:
    """Of Bluetooth; for others nothing happens."""
    if hardware == BLUETOOTH:
        vm.brick.settings.visible = visible != 0


@handles("COM_SET.SET_MODE2")
def set_mode2(vm: Machine, hardware: int, active: int) -> None:
    """Of Bluetooth."""
    if hardware != BLUETOOTH:
        raise Failure
    vm.brick.settings.mode2 = active != 0


@handles(
    "COM_SET.SET_SEARCH",
    "COM_SET.SET_PIN",
    "COM_SET.SET_CONNECTION",
)
def set_radio(_: Machine, hardware: int, *__: object) -> None:
    """Accepted for the radios, of which there are none."""
    _must_be(hardware, *_RADIOS)


@handles("COM_SET.SET_PASSKEY")
def set_bluetooth(_: Machine, hardware: int, *__: object) -> None:
    """Accepted for Bluetooth."""
    _must_be(hardware, BLUETOOTH)


@handles(
    "COM_SET.SET_MOVEUP",
    "COM_SET.SET_MOVEDOWN",
    "COM_SET.SET_ENCRYPT",
    "COM_SET.SET_SSID",
)
def set_wifi(_: Machine, hardware: int, *__: object) -> None:
    """Accepted for WiFi."""
    _must_be(hardware, WIFI)
