"""ARRAY and its kind: arrays that programs make and name by handles."""

from __future__ import annotations

from collections.abc import Callable

from ev3proto.brick.handlers import handles, handles_unknown
from ev3proto.brick.handles import NO_HANDLE, Array
from ev3proto.brick.machine import Machine
from ev3proto.brick.operation_exits import Busy, Failure
from ev3proto.brick.places import Place
from ev3proto.brick.running_programs import CURRENT_SLOT, Program
from ev3proto.tables.declaration import Type
from ev3proto.tables.move import SIZES


def _array(vm: Machine, handle: int) -> Array:
    """The array of a handle; Failure where there is none."""
    array = vm.program.handles.get(handle, Array)
    if array is None:
        raise Failure
    return array


def _program(vm: Machine, slot: int) -> Program:
    """The program of a slot; Failure where there is none."""
    program = vm.program if slot == CURRENT_SLOT else vm.program_in(slot)
    if program is None:
        raise Failure
    return program


def _resize(vm: Machine, array: Array, elements: int) -> None:
    if elements < 0 or not vm.resize_array(array, elements):
        raise Failure


def _put(array: Array, offset: int, data: bytes) -> None:
    """Writes what is within the array: the firmware writes over what lies after it."""
    data = data[: max(0, len(array.data) - offset)]
    array.data[offset : offset + len(data)] = data


@handles_unknown("ARRAY")
def unknown(vm: Machine) -> None:
    """The firmware executes it again and again, for ever."""
    vm.wait()


def _create(kind: Type) -> Callable[[Machine, int, Place], None]:
    def create(vm: Machine, elements: int, handle: Place) -> None:
        if elements < 0 and kind is Type.DATA8:
            elements = 0
        number = vm.create_array(kind, elements) if elements >= 0 else None
        handle.write16(NO_HANDLE if number is None else number)
        if number is None:
            raise Failure

    return create


def _init(kind: Type) -> Callable[[Machine], None]:
    """The command's type says how wide the values are, whatever the array's type is."""
    read = {
        Type.DATA8: Machine.int8,
        Type.DATA16: Machine.int16,
        Type.DATA32: Machine.int32,
        Type.DATAF: Machine.float_bits,
    }[kind]

    def init(vm: Machine) -> None:
        array = _array(vm, vm.int16())
        index, count = vm.int32(), vm.int32()
        if index < 0 or count < 0 or index + count > array.elements:
            raise Failure
        for number in range(index, index + count):
            _put(array, number * kind.size, (read(vm) & 0xFFFFFFFF).to_bytes(4, "little")[: kind.size])

    return init


for _suffix, _kind, _ in SIZES:
    # ARRAY.CREATE8, ARRAY.CREATE16, ARRAY.CREATE32, ARRAY.CREATEF
    handles(f"ARRAY.CREATE{_suffix}")(_create(_kind))
    # ARRAY.INIT8, ARRAY.INIT16, ARRAY.INIT32, ARRAY.INITF
    handles(f"ARRAY.INIT{_suffix}", raw=True)(_init(_kind))


@handles("ARRAY.DELETE", "ARRAY.DESTROY")
def delete(vm: Machine, handle: int) -> None:
    """No failure where there is none."""
    vm.release(vm.program, handle)


@handles("ARRAY.RESIZE")
def resize(vm: Machine, handle: int, elements: int) -> None:
    """The contents are kept as far as they fit."""
    _resize(vm, _array(vm, handle), elements)


@handles("ARRAY.FILL")
def fill(vm: Machine, handle: int, value: Place) -> None:
    """All elements. Without such an array the firmware tries again and again, for ever."""
    array = vm.program.handles.get(handle, Array)
    if array is None:
        raise Busy
    array.data[:] = value.read_bytes(array.type.size) * array.elements


@handles("ARRAY.COPY")
def copy(vm: Machine, source: int, destination: int) -> None:
    """The destination, of the same type, takes the source's size."""
    origin, target = _array(vm, source), _array(vm, destination)
    if origin.type is not target.type:
        raise Failure
    _resize(vm, target, origin.elements)
    target.data[:] = origin.data


@handles("ARRAY.SIZE", "ARRAY.SET_SIZE")
def size(vm: Machine, handle: int, elements: Place) -> None:
    """In elements; 0 where there is none."""
    array = vm.program.handles.get(handle, Array)
    elements.write32(array.elements if array is not None else 0)


@handles("ARRAY.READ_SIZE")
def read_size(vm: Machine, slot: int, handle: int, size: Place) -> None:
    """In bytes; 0 where there is none."""
    program = vm.program if slot == CURRENT_SLOT else vm.program_in(slot)
    array = program.handles.get(handle, Array) if program is not None else None
    size.write32(len(array.data) if array is not None else 0)


@handles("ARRAY.READ_CONTENT")
def read_content(vm: Machine, slot: int, handle: int, index: int, count: int, destination: Place) -> None:
    """Bytes from a byte on, zeros after the end."""
    array = _program(vm, slot).handles.get(handle, Array)
    if array is None or index < 0 or (count >= 0 and not vm.resize(destination, count)):
        raise Failure
    if count > 0:
        destination.check(count)
        destination.write_bytes(bytes(array.data[index : index + count]).ljust(count, b"\0"))


@handles("ARRAY.WRITE_CONTENT")
def write_content(vm: Machine, slot: int, handle: int, index: int, count: int, source: Place) -> None:
    """Bytes from a byte on; the array ends with them, rounded up to whole elements."""
    array = _program(vm, slot).handles.get(handle, Array)
    if array is None or index < 0 or count < 0:
        raise Failure
    data = source.read_bytes(count)
    _resize(vm, array, -(-(index + count) // array.type.size))
    array.data[index : index + count] = data


@handles("ARRAY_WRITE")
def write_element(vm: Machine, handle: int, index: int, value: Place) -> None:
    """The array grows where needed."""
    array = _array(vm, handle)
    if index < 0:
        raise Failure
    data = value.read_bytes(array.type.size)
    if index >= array.elements:
        _resize(vm, array, index + 1)
    _put(array, index * array.type.size, data)


@handles("ARRAY_READ")
def read_element(vm: Machine, handle: int, index: int, value: Place) -> None:
    """The array's type is the value's."""
    array = _array(vm, handle)
    if not 0 <= index < array.elements:
        raise Failure
    begin = index * array.type.size
    value.write_bytes(bytes(array.data[begin : begin + array.type.size]))


@handles("ARRAY_APPEND")
def append(vm: Machine, handle: int, value: Place) -> None:
    """After the last element."""
    array = _array(vm, handle)
    data = value.read_bytes(array.type.size)
    end = len(array.data)
    _resize(vm, array, array.elements + 1)
    array.data[end:] = data
