"""ARRAY, ARRAY_READ and the like: arrays, which programs create and name by handles."""

from __future__ import annotations

from collections.abc import Callable

from ev3proto.brick.exits import Busy, Failure
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.handles import NO_HANDLE, Array
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine
from ev3proto.tables.declaration import NUMBER_TYPES, Type


def _array(vm: Machine, handle: int) -> Array:
    """Returns the array of a handle; raises Failure for an unknown one."""
    array = vm.program.handles.get(handle, Array)
    if array is None:
        raise Failure
    return array


def _array_of(vm: Machine, slot: int, handle: int) -> Array | None:
    """Returns the array of a handle in a slot; None for an unknown one."""
    program = vm.program_in(slot)
    return None if program is None else program.handles.get(handle, Array)


def _resize(vm: Machine, array: Array, elements: int) -> None:
    if elements < 0 or not vm.resize_array(array, elements):
        raise Failure


def _put(array: Array, offset: int, data: bytes) -> None:
    """Writes only within the array; the firmware overwrites the memory behind it."""
    data = data[: max(0, len(array.data) - offset)]
    array.data[offset : offset + len(data)] = data


def _create(kind: Type) -> Callable[[Machine, int, Location], None]:
    def create(vm: Machine, elements: int, handle: Location) -> None:
        if elements < 0 and kind is Type.DATA8:
            elements = 0
        number = vm.create_array(kind, elements) if elements >= 0 else None
        handle.write16(NO_HANDLE if number is None else number)
        if number is None:
            raise Failure

    return create


def _init(kind: Type) -> Callable[[Machine], None]:
    """Returns a handler. The command's type is the width of the values, not the array's type."""
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


for _suffix, _kind, _ in NUMBER_TYPES:
    # ARRAY.CREATE8, ARRAY.CREATE16, ARRAY.CREATE32, ARRAY.CREATEF
    handles(f"ARRAY.CREATE{_suffix}")(_create(_kind))
    # ARRAY.INIT8, ARRAY.INIT16, ARRAY.INIT32, ARRAY.INITF
    handles(f"ARRAY.INIT{_suffix}", raw=True)(_init(_kind))


@handles("ARRAY.RESIZE")
def resize(vm: Machine, handle: int, elements: int) -> None:
    """Resizes an array; the contents are kept as far as they fit."""
    _resize(vm, _array(vm, handle), elements)


@handles("ARRAY.FILL")
def fill(vm: Machine, handle: int, value: Location) -> None:
    """Sets all elements; waits forever for an unknown handle, as the firmware does."""
    array = vm.program.handles.get(handle, Array)
    if array is None:
        raise Busy
    array.data[:] = value.read_bytes(array.type.size) * array.elements


@handles("ARRAY.COPY")
def copy(vm: Machine, source: int, destination: int) -> None:
    """Copies an array into another one of the same type, which gets its size."""
    origin, target = _array(vm, source), _array(vm, destination)
    if origin.type is not target.type:
        raise Failure
    _resize(vm, target, origin.elements)
    target.data[:] = origin.data


def _elements(vm: Machine, handle: int) -> int:
    """Returns the size of an array in elements; 0 for an unknown one."""
    array = vm.program.handles.get(handle, Array)
    return 0 if array is None else array.elements


def _bytes(vm: Machine, slot: int, handle: int) -> int:
    """Returns the size of an array in bytes; 0 for an unknown one."""
    array = _array_of(vm, slot, handle)
    return 0 if array is None else len(array.data)


computes(
    {
        "ARRAY.SIZE": _elements,
        "ARRAY.SET_SIZE": _elements,
        "ARRAY.READ_SIZE": _bytes,
        # An unknown handle is not a failure.
        "ARRAY.DELETE": lambda vm, handle: vm.release(vm.program, handle),
        "ARRAY.DESTROY": lambda vm, handle: vm.release(vm.program, handle),
    }
)


@handles("ARRAY.READ_CONTENT")
def read_content(vm: Machine, slot: int, handle: int, index: int, count: int, destination: Location) -> None:
    """Reads bytes from an index on, zeros after the end."""
    array = _array_of(vm, slot, handle)
    if array is None or index < 0 or (count >= 0 and not vm.resize(destination, count)):
        raise Failure
    if count > 0:
        destination.check(count)
        destination.write_bytes(bytes(array.data[index : index + count]).ljust(count, b"\0"))


@handles("ARRAY.WRITE_CONTENT")
def write_content(vm: Machine, slot: int, handle: int, index: int, count: int, source: Location) -> None:
    """Writes bytes from an index on; the array ends with them, rounded up to whole elements."""
    array = _array_of(vm, slot, handle)
    if array is None or index < 0 or count < 0:
        raise Failure
    data = source.read_bytes(count)
    _resize(vm, array, -(-(index + count) // array.type.size))
    array.data[index : index + count] = data


@handles("ARRAY_WRITE")
def write_element(vm: Machine, handle: int, index: int, value: Location) -> None:
    """Writes an element; the array grows where needed."""
    array = _array(vm, handle)
    if index < 0:
        raise Failure
    data = value.read_bytes(array.type.size)
    if index >= array.elements:
        _resize(vm, array, index + 1)
    _put(array, index * array.type.size, data)


@handles("ARRAY_READ")
def read_element(vm: Machine, handle: int, index: int, value: Location) -> None:
    """Reads an element, in the array's type."""
    array = _array(vm, handle)
    if not 0 <= index < array.elements:
        raise Failure
    begin = index * array.type.size
    value.write_bytes(bytes(array.data[begin : begin + array.type.size]))


@handles("ARRAY_APPEND")
def append(vm: Machine, handle: int, value: Location) -> None:
    """Appends an element."""
    array = _array(vm, handle)
    data = value.read_bytes(array.type.size)
    end = len(array.data)
    _resize(vm, array, array.elements + 1)
    array.data[end:] = data
