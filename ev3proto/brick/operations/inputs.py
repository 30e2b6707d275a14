"""INPUT: sensors, and motors as sensors."""

from __future__ import annotations

import math

from ev3proto.brick.conversions import NAN8, NAN32
from ev3proto.brick.devices.sensors import ANALOG, FIRST_MOTOR, PORTS, SPEED_MODE, Device, Inputs
from ev3proto.brick.handlers import handles, handles_unknown
from ev3proto.brick.machine import Machine
from ev3proto.brick.places import Place
from ev3proto.tables.declaration import DATAF
from ev3proto.tables.enumerations import CONN, DATA_FORMAT, RESULT

_UART, _IIC = CONN.members["CONN_INPUT_UART"], CONN.members["CONN_NXT_IIC"]
_PERCENT, _RAW, _SI = (DATA_FORMAT.members[name] for name in ("DATA_PCT", "DATA_RAW", "DATA_SI"))
_FAIL = RESULT.members["FAIL"]
_MOST_WHOLE = 2**31 - 1
_MOST_WRITTEN, _MOST_LISTED = 32, 32


def _whole(value: float, not_a_number: int) -> int:
    """A reading as an integer."""
    return not_a_number if math.isnan(value) else int(max(-_MOST_WHOLE, min(value, _MOST_WHOLE)))


def _write_percent(inputs: Inputs, device: Device, places: list[Place]) -> None:
    for dataset, place in enumerate(places):
        place.write8(_whole(inputs.percent(device, dataset), NAN8))


def _write_raw(inputs: Inputs, device: Device, places: list[Place]) -> None:
    for dataset, place in enumerate(places):
        place.write32(_whole(inputs.raw(device, dataset), NAN32))


def _write_si(inputs: Inputs, device: Device, places: list[Place]) -> None:
    for dataset, place in enumerate(places):
        place.write_float(inputs.si(device, dataset))


_WRITERS = {_PERCENT: _write_percent, _RAW: _write_raw, _SI: _write_si}
_NO_PORT = Device()


def _found(vm: Machine, layer: int, number: int) -> Device:
    """The device on a port; an empty one where there is no such port."""
    device = vm.brick.inputs.device(layer, number)
    return _NO_PORT if device is None else device


# Reading without waiting


@handles("INPUT_READ")
def read(vm: Machine, layer: int, number: int, type: int, mode: int, percent: Place) -> None:
    """Percent."""
    device = _found(vm, layer, number)
    vm.brick.inputs.select(device, type, mode)
    _write_percent(vm.brick.inputs, device, [percent])


@handles("INPUT_READSI")
def read_si(vm: Machine, layer: int, number: int, type: int, mode: int, value: Place) -> None:
    """A value in the mode's unit."""
    device = _found(vm, layer, number)
    vm.brick.inputs.select(device, type, mode)
    _write_si(vm.brick.inputs, device, [value])


@handles("INPUT_READEXT")
def read_ext(vm: Machine, layer: int, number: int, type: int, mode: int, format: int, places: list[Place]) -> None:
    """All values that a mode has, in one of three formats; in any other one NaN of 8 bits each."""
    device = _found(vm, layer, number)
    vm.brick.inputs.select(device, type, mode)
    writer = _WRITERS.get(format)
    if writer is None:
        for place in places:
            place.write8(NAN8)
    else:
        writer(vm.brick.inputs, device, places)


@handles("INPUT_TEST")
def test(vm: Machine, layer: int, number: int, busy: Place) -> None:
    """Whether the device is not ready."""
    busy.write8(vm.brick.inputs.is_busy(_found(vm, layer, number)))


@handles("INPUT_READY")
def ready(vm: Machine, layer: int, number: int) -> None:
    """Waits for the device, on an empty port for ever."""
    device = vm.brick.inputs.device(layer, number)
    if device is not None and vm.brick.inputs.is_busy(device):
        vm.wait()


@handles("INPUT_WRITE", raw=True)
def write(vm: Machine) -> None:
    """Writes bytes to a sensor that takes any; it is busy then."""
    layer, number, count, _ = vm.int8(), vm.int8(), vm.int8(), vm.place()
    device = vm.brick.inputs.device(layer, number)
    if device is None or number + layer * PORTS >= FIRST_MOTOR:
        vm.fail()
    elif device.connection in (_UART, _IIC):
        if not 0 < count <= _MOST_WRITTEN:
            vm.fail()
        vm.brick.inputs.keep_busy(device)


@handles("INPUT_DEVICE_LIST")
def device_list(vm: Machine, length: int, types: Place, changed: Place) -> None:
    """How many have changed; then, as places may overlap, the types on all ports and a zero where there is room."""
    changed.write8(vm.brick.inputs.changed(vm.program.slot))
    listed = vm.brick.inputs.types()[:_MOST_LISTED][: max(length, 0)]
    if len(listed) < length:
        listed.append(0)
    types.write_bytes(bytes(listed))


@handles("INPUT_SAMPLE")
def sample(
    vm: Machine,
    _: int,
    count: int,
    __: Place,
    devices: Place,
    types: Place,
    modes: Place,
    datasets: Place,
    values: Place,
) -> None:
    """One value of each of several devices; motors are numbered after the sensors."""
    inputs = vm.brick.inputs
    for index in range(max(count, 0)):
        number = devices.moved(index).read8()
        port = number if number < PORTS else number - PORTS + FIRST_MOTOR
        device = _found(vm, 0, port)
        inputs.select(device, types.moved(index).read8(), modes.moved(index).read8())
        values.moved(index * DATAF.size).write_float(inputs.si(device, datasets.moved(index).read8()))


# Reading with waiting


def _ready(vm: Machine, layer: int, number: int, type: int, mode: int) -> Device:
    """The device in the mode asked for, waited for unless the port is empty."""
    inputs = vm.brick.inputs
    device = _found(vm, layer, number)
    if not device.is_empty:
        inputs.select(device, type, mode)
        if inputs.is_busy(device):
            vm.wait()
    return device


@handles("INPUT_DEVICE.READY_PCT")
def ready_percent(vm: Machine, layer: int, number: int, type: int, mode: int, places: list[Place]) -> None:
    """Percent."""
    _write_percent(vm.brick.inputs, _ready(vm, layer, number, type, mode), places)


@handles("INPUT_DEVICE.READY_RAW")
def ready_raw(vm: Machine, layer: int, number: int, type: int, mode: int, places: list[Place]) -> None:
    """Raw values."""
    _write_raw(vm.brick.inputs, _ready(vm, layer, number, type, mode), places)


@handles("INPUT_DEVICE.READY_SI")
def ready_si(vm: Machine, layer: int, number: int, type: int, mode: int, places: list[Place]) -> None:
    """Values in the mode's unit."""
    _write_si(vm.brick.inputs, _ready(vm, layer, number, type, mode), places)


# What a device is


@handles("INPUT_DEVICE.GET_TYPEMODE")
def get_typemode(vm: Machine, layer: int, number: int, type: Place, mode: Place) -> None:
    """Its type and mode."""
    device = _found(vm, layer, number)
    type.write8(device.type.number)
    mode.write8(device.mode)


@handles("INPUT_DEVICE.GET_CONNECTION")
def get_connection(vm: Machine, layer: int, number: int, connection: Place) -> None:
    """How it is connected."""
    connection.write8(_found(vm, layer, number).connection)


@handles("INPUT_DEVICE.GET_FORMAT")
def get_format(
    vm: Machine, layer: int, number: int, datasets: Place, format: Place, modes: Place, views: Place
) -> None:
    """What its mode's values are like, and how many modes it has."""
    device = vm.brick.inputs.device(layer, number)
    if device is None:
        found = (0, 0, 0, 0)
    else:
        mode = device.mode_data
        found = (mode.datasets, mode.format, len(device.type.modes), device.type.views)
    for place, value in zip((datasets, format, modes, views), found, strict=True):
        place.write8(value)


@handles("INPUT_DEVICE.GET_FIGURES")
def get_figures(vm: Machine, layer: int, number: int, figures: Place, decimals: Place) -> None:
    """How its values are shown."""
    device = vm.brick.inputs.device(layer, number)
    figures.write8(0 if device is None else device.mode_data.figures)
    decimals.write8(0 if device is None else device.mode_data.decimals)


@handles("INPUT_DEVICE.GET_MINMAX")
def get_minmax(vm: Machine, layer: int, number: int, least: Place, most: Place) -> None:
    """The range of its values in their unit."""
    si = _found(vm, layer, number).mode_data.si
    least.write_float(si.least)
    most.write_float(si.most)


def _write_padded(vm: Machine, destination: Place, text: str | None, length: int) -> None:
    """A text filled up with blanks to the room it has, and a zero; None is an empty one, which fills nothing."""
    if text is None:
        destination.write_text(b"")
        return
    room = len(text) + 1 if length == -1 and destination.handle >= 0 else length
    if vm.resize(destination, room):
        fill = max(room - 1, 0)
        destination.write_text(text.encode()[:fill].ljust(fill))


@handles("INPUT_DEVICE.GET_NAME")
def get_name(vm: Machine, layer: int, number: int, length: int, destination: Place) -> None:
    """The name of its mode, by which the firmware calls the device."""
    device = vm.brick.inputs.device(layer, number)
    _write_padded(vm, destination, None if device is None else device.mode_data.name, length)


@handles("INPUT_DEVICE.GET_SYMBOL")
def get_symbol(vm: Machine, layer: int, number: int, length: int, destination: Place) -> None:
    """The unit of its values."""
    device = vm.brick.inputs.device(layer, number)
    _write_padded(vm, destination, None if device is None else device.mode_data.symbol, length)


@handles("INPUT_DEVICE.GET_MODENAME")
def get_modename(vm: Machine, layer: int, number: int, mode: int, length: int, destination: Place) -> None:
    """The name of one of its modes."""
    device = vm.brick.inputs.device(layer, number)
    has_mode = device is not None and 0 <= mode < len(device.type.modes)
    name = device.type.modes[mode].name if device is not None and has_mode else None
    _write_padded(vm, destination, name, length)


@handles("INPUT_DEVICE.GET_RAW")
def get_raw(vm: Machine, layer: int, number: int, value: Place) -> None:
    """Its first raw value."""
    _write_raw(vm.brick.inputs, _found(vm, layer, number), [value])


@handles("INPUT_DEVICE.GET_CHANGES")
def get_changes(vm: Machine, layer: int, number: int, value: Place) -> None:
    """How often the reading of a touch sensor fell."""
    value.write_float(_found(vm, layer, number).changes)


@handles("INPUT_DEVICE.GET_BUMPS")
def get_bumps(vm: Machine, layer: int, number: int, value: Place) -> None:
    """How often the reading of a touch sensor rose."""
    value.write_float(_found(vm, layer, number).bumps)


@handles("INPUT_DEVICE.CLR_CHANGES")
def clear_changes(vm: Machine, layer: int, number: int) -> None:
    """Forgets both."""
    _found(vm, layer, number).clear_counts()


@handles("INPUT_DEVICE.CLR_ALL")
def clear_all(vm: Machine, layer: int) -> None:
    """Clears what sensors have counted, and the motors' counts."""
    if layer <= 0:
        vm.brick.inputs.clear()
        for motor in vm.brick.outputs.motors:
            motor.clear_count()
            motor.reset()


@handles("INPUT_DEVICE.STOP_ALL")
def stop_all(vm: Machine, layer: int) -> None:
    """Stops the motors."""
    if layer <= 0:
        vm.brick.outputs.stop_all()


@handles("INPUT_DEVICE.SET_RAW")
def set_raw(vm: Machine, layer: int, number: int, _: int, value: int) -> None:
    """Another raw value of a sensor that sends none by itself, or of a motor."""
    device = _found(vm, layer, number)
    if device.motor is not None:
        device.motor.set_reading(value, is_speed=device.mode == SPEED_MODE)
    elif not device.is_empty and device.connection != _UART:
        device.set_readings({0: (float(value),)} if device.connection in ANALOG else {device.mode: (float(value),)})


# Calibration, types, I2C


@handles("INPUT_DEVICE.CAL_MINMAX")
def calibrate(vm: Machine, type: int, mode: int, least: int, most: int) -> None:
    """Both ends of the raw range."""
    vm.brick.inputs.calibrate_both(type, mode, least, most)


@handles("INPUT_DEVICE.CAL_MIN")
def calibrate_least(vm: Machine, type: int, mode: int, least: int) -> None:
    """The lower end of the raw range."""
    vm.brick.inputs.calibrate(type, mode, least, is_least=True)


@handles("INPUT_DEVICE.CAL_MAX")
def calibrate_most(vm: Machine, type: int, mode: int, most: int) -> None:
    """The upper end of the raw range."""
    vm.brick.inputs.calibrate(type, mode, most, is_least=False)


@handles("INPUT_DEVICE.CAL_DEFAULT")
def uncalibrate(vm: Machine, type: int, mode: int) -> None:
    """The raw range as it was."""
    vm.brick.inputs.uncalibrate(type, mode)


@handles("INPUT_DEVICE.INSERT_TYPE")
def insert_type(_: Machine, __: bytes, ___: int, error: Place) -> None:
    """No types are added to a virtual brick."""
    error.write8(1)


@handles("INPUT_DEVICE.SET_TYPEMODE")
def set_typemode(_: Machine, __: int, ___: int, ____: int, _____: int, error: Place) -> None:
    """There are no third party types to renumber."""
    error.write8(1)


@handles("INPUT_DEVICE.SETUP")
def setup(_: Machine, *__: object) -> None:
    """Nothing answers on the I2C bus of a virtual brick: what was to be read stays as it was."""


@handles("INPUT_DEVICE.READY_IIC")
def ready_iic(_: Machine, *parameters: object) -> None:
    """Nothing answers on the I2C bus of a virtual brick."""
    result = parameters[-1]
    assert isinstance(result, Place)
    result.write8(_FAIL)


@handles_unknown("INPUT_DEVICE")
def unknown_command(vm: Machine) -> None:
    """Layer and port are read whatever the command is."""
    vm.int8()
    vm.int8()
