"""Data logs of FILE: a text header, rows of samples as they are in memory, and an end mark.

Quick logs are gathered in memory and go to their file when they are closed; others are written as they come.
"""

from __future__ import annotations

import struct

from ev3proto.brick.exits import Failure
from ev3proto.brick.handlers import handles
from ev3proto.brick.handles import NO_HANDLE, Array
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine
from ev3proto.brick.open_files import OpenFile
from ev3proto.brick.operations.files import checked_name, find_open, open_to_write, opened_name, write_or_cut
from ev3proto.tables import paths
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import Type
from ev3proto.tables.encoding import STRING_CODING

LOG_EXTENSION = str(CONSTANTS["EXT_DATALOG"]).encode(STRING_CODING)
END_MARK = b"\xff" * 8

SHORTEST_INTERVAL = 10
"""Milliseconds between samples; logs with fewer are gathered in memory."""

BUFFER = 1000
"""Bytes by which the memory for such a log grows."""

MOST_HEAD = 999
"""Bytes of a log's head."""


class LogBuffer(Array):
    """The memory for a quick log, which is an array of bytes."""

    def __init__(self) -> None:
        super().__init__(Type.DATA8, BUFFER)
        self.used = 0  # bytes that were written

    def write(self, vm: Machine, data: bytes) -> bool:
        """Adds bytes. Returns False if there is no room."""
        if self.used + len(data) > len(self.data) and not vm.resize_array(self, len(self.data) + BUFFER):
            return False
        self.data[self.used : self.used + len(data)] = data
        self.used += len(data)
        return True


def _with_extension(name: bytes) -> bytes:
    return name if paths.split(name).extension else name + LOG_EXTENSION


@handles("FILE.OPEN_LOG", places=("NAME",))
def open_log(
    vm: Machine,
    place: Location,
    time: int,
    tick: int,
    now: int,
    interval: int,
    duration: int,
    description: bytes,
    handle: Location,
) -> None:
    """Opens a log, and appends to an existing file. A quick log has two handles; that of its buffer is written."""
    name = _with_extension(opened_name(vm, place))
    numbers = "\t".join(str(number) for number in (time, tick, now, interval, duration))
    head = (f"Sync data\t{numbers}\r\n".encode(STRING_CODING) + description)[:MOST_HEAD]
    file = open_to_write(vm, name, handle, append=True, is_log=True)
    if interval >= SHORTEST_INTERVAL:
        _write_or_log(vm, file, head)
        return
    buffer = LogBuffer()
    number = vm.program.handles.add(buffer) if vm.has_room(BUFFER) else None
    handle.write16(NO_HANDLE if number is None else number)
    if number is None:
        raise Failure
    buffer.write(vm, head)


def _write_or_log(vm: Machine, file: OpenFile | None, data: bytes) -> bool:
    """Writes to a file. Returns False and logs an error if that is impossible."""
    if file is not None and file.for_writing and file.stream.put(data):
        return True
    vm.brick.settings.log_error("FILE_WRITE_ERROR")
    return False


@handles("FILE.WRITE_LOG")
def write_log(vm: Machine, handle: int, time: int, items: int, values: Location) -> None:
    """Writes a row of floats, the time and the samples; nothing without samples. It never fails."""
    if items <= 0:
        return
    row = struct.pack("<f", time) + values.read_bytes(items * 4)
    buffer = vm.program.handles.get(handle, LogBuffer)
    if buffer is None:
        _write_or_log(vm, vm.program.handles.get(handle, OpenFile), row)
    else:
        buffer.write(vm, row)


@handles("FILE.CLOSE_LOG", places=("NAME",))
def close_log(vm: Machine, handle: int, place: Location) -> None:
    """Writes the end mark and closes a log. A quick log finds its file by the name. It never fails."""
    name = checked_name(vm, place)
    if name is None:
        return
    buffer = vm.program.handles.get(handle, LogBuffer)
    if buffer is not None:
        number, file = find_open(vm, _with_extension(name))
        if _write_or_log(vm, file, bytes(buffer.data[: buffer.used]) + END_MARK):
            vm.release(vm.program, number)
        return
    _write_or_log(vm, vm.program.handles.get(handle, OpenFile), END_MARK)
    if not vm.release(vm.program, handle):
        vm.brick.settings.log_error("FILE_CLOSE_ERROR")


@handles("FILE.GET_LOG_NAME")
def log_name(vm: Machine, length: int, destination: Location) -> None:
    """Writes the name of the open log, or an empty one. An array gets all of it."""
    logs = (entry for entry in vm.program.handles.entries() if isinstance(entry, OpenFile) and entry.is_log)
    name = next((log.name for log in logs), b"")
    write_or_cut(vm, destination, name, length)
