"""INPUT: sensors, and motors as sensors."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable

from ev3proto.brick.conversions import NAN8, NAN32
from ev3proto.brick.devices.sensors import ANALOG, FIRST_MOTOR, SENSOR_COUNT, SPEED_MODE, Device, Inputs
from ev3proto.brick.exits import Busy, Failure
from ev3proto.brick.handlers import computes, handles, handles_unknown
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine
from ev3proto.tables.declaration import DATAF
from ev3proto.tables.enumerations import CONN, DATA_FORMAT, RESULT

_UART, _IIC = CONN.members["CONN_INPUT_UART"], CONN.members["CONN_NXT_IIC"]
_PERCENT, _RAW, _SI = (DATA_FORMAT.members[name] for name in ("DATA_PCT", "DATA_RAW", "DATA_SI"))
_FAIL = RESULT.members["FAIL"]
_MOST_WHOLE = 2**31 - 1
_MOST_WRITTEN, _MOST_LISTED = 32, 32


def _whole(value: float, not_a_number: int) -> int:
    """Returns a reading as an integer."""
    return not_a_number if math.isnan(value) else int(max(-_MOST_WHOLE, min(value, _MOST_WHOLE)))


_READINGS: dict[int, tuple[Callable[[Inputs, Device, int], float], Callable[[Location, float], None]]] = {
    _PERCENT: (Inputs.percent, lambda place, value: place.write8(_whole(value, NAN8))),
    _RAW: (Inputs.raw, lambda place, value: place.write32(_whole(value, NAN32))),
    _SI: (Inputs.si, Location.write_float),
}
"""The functions that take and write a reading, by its format."""


def _write(vm: Machine, device: Device, format: int, places: Iterable[Location]) -> None:
    """Writes the values of a device, one to each place."""
    read, write = _READINGS[format]
    for dataset, place in enumerate(places):
        write(place, read(vm.brick.inputs, device, dataset))


_NO_PORT = Device()


def _found(vm: Machine, layer: int, number: int) -> Device:
    """Returns the device on a port; an empty one for an unknown port."""
    device = vm.brick.inputs.device(layer, number)
    return _NO_PORT if device is None else device


# Reading without waiting


def _selected(vm: Machine, layer: int, number: int, type: int, mode: int) -> Device:
    device = _found(vm, layer, number)
    vm.brick.inputs.select(device, type, mode)
    return device


@handles("INPUT_READ")
def read(vm: Machine, layer: int, number: int, type: int, mode: int, percent: Location) -> None:
    """Writes one value in percent."""
    _write(vm, _selected(vm, layer, number, type, mode), _PERCENT, [percent])


@handles("INPUT_READSI")
def read_si(vm: Machine, layer: int, number: int, type: int, mode: int, value: Location) -> None:
    """Writes one value in the mode's unit."""
    _write(vm, _selected(vm, layer, number, type, mode), _SI, [value])


@handles("INPUT_READEXT")
def read_ext(vm: Machine, layer: int, number: int, type: int, mode: int, format: int, places: list[Location]) -> None:
    """Writes all values of a mode in one of three formats; in any other one NaN of 8 bits each."""
    device = _selected(vm, layer, number, type, mode)
    if format in _READINGS:
        _write(vm, device, format, places)
    else:
        for place in places:
            place.write8(NAN8)


def _port_name(layer: int, number: int) -> str:
    """Returns a port as people call it."""
    return f"port {number + 1}" if layer == 0 and number < SENSOR_COUNT else f"input {number} of layer {layer}"


@handles("INPUT_READY")
def ready(vm: Machine, layer: int, number: int) -> None:
    """Waits for the device, forever if the port is empty."""
    device = vm.brick.inputs.device(layer, number)
    if device is None or not vm.brick.inputs.is_busy(device):
        return
    if device.is_empty:
        raise Busy(f"INPUT_READY waits for a device on {_port_name(layer, number)}, but none is plugged in there")
    raise Busy


@handles("INPUT_WRITE", raw=True)
def write(vm: Machine) -> None:
    """Writes bytes to a sensor that accepts any, and is busy afterwards."""
    layer, number, count, _ = vm.int8(), vm.int8(), vm.int8(), vm.place()
    device = vm.brick.inputs.device(layer, number)
    if device is None or number + layer * SENSOR_COUNT >= FIRST_MOTOR:
        raise Failure
    if device.connection in (_UART, _IIC):
        if not 0 < count <= _MOST_WRITTEN:
            raise Failure
        vm.brick.inputs.keep_busy(device)


@handles("INPUT_DEVICE_LIST")
def device_list(vm: Machine, length: int, types: Location, changed: Location) -> None:
    """Writes the number of changes; then, as places may overlap, the types on all ports, and a zero if it fits."""
    changed.write8(vm.brick.inputs.changed(vm.program.slot))
    listed = vm.brick.inputs.types()[:_MOST_LISTED][: max(length, 0)]
    if len(listed) < length:
        listed.append(0)
    types.write_bytes(bytes(listed))


@handles("INPUT_SAMPLE")
def sample(vm: Machine, _: int, count: int, __: Location, *arrays: Location) -> None:
    """Writes one value of each of several devices; motors are numbered after the sensors.

    The arrays are devices, types, modes, datasets and values.
    """
    inputs = vm.brick.inputs
    for index in range(max(count, 0)):
        number, kind, mode, dataset = (array.moved(index).read8() for array in arrays[:4])
        device = _selected(vm, 0, number if number < SENSOR_COUNT else number - SENSOR_COUNT + FIRST_MOTOR, kind, mode)
        arrays[4].moved(index * DATAF.size).write_float(inputs.si(device, dataset))


# Reading with waiting


def _waits(format: int) -> Callable[[Machine, int, int, int, int, list[Location]], None]:
    """Writes values of a device in the requested mode; waits for them unless the port is empty."""

    def read(vm: Machine, layer: int, number: int, type: int, mode: int, places: list[Location]) -> None:
        device = _found(vm, layer, number)
        if not device.is_empty:
            vm.brick.inputs.select(device, type, mode, always=True)
            if vm.brick.inputs.is_busy(device):
                raise Busy
        _write(vm, device, format, places)

    return read


handles("INPUT_DEVICE.READY_PCT")(_waits(_PERCENT))
handles("INPUT_DEVICE.READY_RAW")(_waits(_RAW))
handles("INPUT_DEVICE.READY_SI")(_waits(_SI))


# Properties of devices


@handles("INPUT_DEVICE.GET_FORMAT", computes=True)
def get_format(vm: Machine, layer: int, number: int) -> tuple[int, ...]:
    """Returns the format of its mode's values, and the number of its modes."""
    device = vm.brick.inputs.device(layer, number)
    if device is None:
        return 0, 0, 0, 0
    return device.mode_data.datasets, device.mode_data.format, len(device.type.modes), device.type.views


@handles("INPUT_DEVICE.GET_FIGURES", computes=True)
def get_figures(vm: Machine, layer: int, number: int) -> tuple[int, int]:
    """Returns the number of figures and decimals with which its values are shown."""
    device = vm.brick.inputs.device(layer, number)
    return (0, 0) if device is None else (device.mode_data.figures, device.mode_data.decimals)


def _write_padded(vm: Machine, destination: Location, text: str | None, length: int) -> None:
    """Writes a text, padded with spaces to the room for it, and a zero; None is an empty text without padding."""
    if text is None:
        destination.write_text(b"")
        return
    room = len(text) + 1 if length == -1 and destination.handle >= 0 else length
    if vm.resize(destination, room):
        fill = max(room - 1, 0)
        destination.write_text(text.encode()[:fill].ljust(fill))


@handles("INPUT_DEVICE.GET_NAME")
def get_name(vm: Machine, layer: int, number: int, length: int, destination: Location) -> None:
    """Writes the name of its mode, by which the firmware calls the device."""
    device = vm.brick.inputs.device(layer, number)
    _write_padded(vm, destination, None if device is None else device.mode_data.name, length)


@handles("INPUT_DEVICE.GET_SYMBOL")
def get_symbol(vm: Machine, layer: int, number: int, length: int, destination: Location) -> None:
    """Writes the unit of its values."""
    device = vm.brick.inputs.device(layer, number)
    _write_padded(vm, destination, None if device is None else device.mode_data.symbol, length)


@handles("INPUT_DEVICE.GET_MODENAME")
def get_modename(vm: Machine, layer: int, number: int, mode: int, length: int, destination: Location) -> None:
    """Writes the name of one of its modes."""
    device = vm.brick.inputs.device(layer, number)
    has_mode = device is not None and 0 <= mode < len(device.type.modes)
    name = device.type.modes[mode].name if device is not None and has_mode else None
    _write_padded(vm, destination, name, length)


@handles("INPUT_DEVICE.CLR_ALL")
def clear_all(vm: Machine, layer: int) -> None:
    """Clears the counts of sensors and motors, and the buttons' flags; resets sensors that can be written to."""
    if layer <= 0:
        vm.brick.inputs.reset()
        vm.brick.buttons.flush()
        for motor in vm.brick.outputs.freed(0, (1 << SENSOR_COUNT) - 1):
            motor.reset()
            motor.clear_count()


@handles("INPUT_DEVICE.STOP_ALL")
def stop_all(vm: Machine, layer: int) -> None:
    """Stops the motors."""
    if layer <= 0:
        vm.brick.outputs.end_program()


@handles("INPUT_DEVICE.SET_RAW")
def set_raw(vm: Machine, layer: int, number: int, _: int, value: int) -> None:
    """Sets the raw value of a sensor that sends none by itself, or of a motor."""
    device = _found(vm, layer, number)
    if device.motor is not None:
        device.motor.set_reading(value, is_speed=device.mode == SPEED_MODE)
    elif not device.is_empty and device.connection != _UART:
        device.set_readings({0: (float(value),)} if device.connection in ANALOG else {device.mode: (float(value),)})


computes(
    {
        "INPUT_TEST": lambda vm, layer, number: vm.brick.inputs.is_busy(_found(vm, layer, number)),
        "INPUT_DEVICE.GET_TYPEMODE": lambda vm, *port: (_found(vm, *port).type.number, _found(vm, *port).mode),
        "INPUT_DEVICE.GET_CONNECTION": lambda vm, *port: _found(vm, *port).connection,
        # The range of its values in their unit.
        "INPUT_DEVICE.GET_MINMAX": lambda vm, *port: tuple(_found(vm, *port).mode_data.si),
        "INPUT_DEVICE.GET_RAW": lambda vm, *port: _whole(vm.brick.inputs.raw(_found(vm, *port), 0), NAN32),
        # How often the reading of a touch sensor fell, and how often it rose.
        "INPUT_DEVICE.GET_CHANGES": lambda vm, *port: _found(vm, *port).changes,
        "INPUT_DEVICE.GET_BUMPS": lambda vm, *port: _found(vm, *port).bumps,
        "INPUT_DEVICE.CLR_CHANGES": lambda vm, *port: _found(vm, *port).clear_counts(),
        # Both ends of the raw range, one of them, and the range as it was.
        "INPUT_DEVICE.CAL_MINMAX": lambda vm, *range: vm.brick.inputs.calibrate_both(*range),
        "INPUT_DEVICE.CAL_MIN": lambda vm, *end: vm.brick.inputs.calibrate(*end, is_least=True),
        "INPUT_DEVICE.CAL_MAX": lambda vm, *end: vm.brick.inputs.calibrate(*end, is_least=False),
        "INPUT_DEVICE.CAL_DEFAULT": lambda vm, *mode: vm.brick.inputs.uncalibrate(*mode),
    }
)


@handles("INPUT_DEVICE.READY_IIC")
def ready_iic(_: Machine, *parameters: object) -> None:
    """Writes FAIL: no device answers on the I2C bus of a virtual brick."""
    result = parameters[-1]
    assert isinstance(result, Location)
    result.write8(_FAIL)


@handles_unknown("INPUT_DEVICE")
def unknown_command(vm: Machine) -> None:
    """Reads layer and port, which every command has."""
    vm.int8()
    vm.int8()
