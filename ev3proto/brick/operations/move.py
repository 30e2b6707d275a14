"""MOVE, INIT_BYTES, READ, WRITE: copying values, and elements of arrays in a program's variables."""

from __future__ import annotations

from collections.abc import Callable

from ev3proto.brick.conversions import NAN8, NAN16, NAN32, float_to_integer, narrowed, widened
from ev3proto.brick.handlers import handles
from ev3proto.brick.locations import WRITERS, Location
from ev3proto.brick.machine import Machine
from ev3proto.tables.declaration import NUMBER_TYPES, Type

_INTEGERS = {"8": (Type.DATA8, NAN8), "16": (Type.DATA16, NAN16), "32": (Type.DATA32, NAN32)}
_TYPES = {suffix: kind for suffix, kind, _ in NUMBER_TYPES}


def _copy(size: int) -> Callable[[Machine], None]:
    """Copies the bits of a value, also those of NaN."""

    def copy(vm: Machine) -> None:
        value = vm.place().read_bytes(size)
        vm.place().write_bytes(value)

    return copy


def _convert_integer(source: str, target: str) -> Callable[[Machine, int, Location], None]:
    kind, nan = _INTEGERS[source]
    if target == "F":

        def convert_to_float(_: Machine, value: int, destination: Location) -> None:
            destination.write_float(float("nan") if value == nan else value)

        return convert_to_float
    goal = _TYPES[target]
    write, change = WRITERS[goal], widened if goal.size > kind.size else narrowed

    def convert(_: Machine, value: int, destination: Location) -> None:
        write(destination, change(value, nan, goal))

    return convert


def _convert_float(target: str) -> Callable[[Machine], None]:
    goal = _TYPES[target]
    write = WRITERS[goal]

    def convert(vm: Machine) -> None:
        bits = vm.float_bits()
        write(vm.place(), float_to_integer(bits, goal))

    return convert


for _source, _type in _TYPES.items():
    for _target in _TYPES:
        # MOVE8_8, MOVE8_16, MOVE8_32, MOVE8_F, MOVE16_8, MOVE16_16, MOVE16_32, MOVE16_F, MOVE32_8,
        # MOVE32_16, MOVE32_32, MOVE32_F, MOVEF_8, MOVEF_16, MOVEF_32, MOVEF_F
        _name = f"MOVE{_source}_{_target}"
        if _source == _target:
            handles(_name, raw=True)(_copy(_type.size))
        elif _source == "F":
            handles(_name, raw=True)(_convert_float(_target))
        else:
            handles(_name)(_convert_integer(_source, _target))


@handles("INIT_BYTES", raw=True)
def init_bytes(vm: Machine) -> None:
    """Values cut to 8 bits, one byte each."""
    destination = vm.place()
    for distance in range(vm.int32()):
        destination.moved(distance).write8(vm.int8())


def _read_element(size: int) -> Callable[[Machine, Location, int, Location], None]:
    def read_element(_: Machine, source: Location, index: int, destination: Location) -> None:
        destination.write_bytes(source.moved(index * size).read_bytes(size))

    return read_element


def _write_element(size: int) -> Callable[[Machine], None]:
    def write_element(vm: Machine) -> None:
        # The value is read before the index: as constants both would share one place.
        value = vm.place().read_bytes(size)
        index = vm.int8()
        vm.place().moved(index * size).write_bytes(value)

    return write_element


for _suffix, _type in _TYPES.items():
    # READ8, READ16, READ32, READF
    handles(f"READ{_suffix}", places=("SOURCE",))(_read_element(_type.size))
    # WRITE8, WRITE16, WRITE32, WRITEF
    handles(f"WRITE{_suffix}", raw=True)(_write_element(_type.size))
