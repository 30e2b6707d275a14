"""Data logs of FILE: a head of text, rows of samples as they are in memory, and a mark at the end."""

from __future__ import annotations

import struct

from ev3proto.brick import filenames
from ev3proto.brick.areas.files import checked_name
from ev3proto.brick.files import OpenFile
from ev3proto.brick.handlers import handles
from ev3proto.brick.handles import Closable
from ev3proto.brick.machine import Machine
from ev3proto.brick.memory import Place
from ev3proto.brick.outcomes import Busy, Failure
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.encoding import STRING_CODING

LOG_EXTENSION = str(CONSTANTS["EXT_DATALOG"]).encode(STRING_CODING)
END_MARK = b"\xff" * 8

MOST_IN_MEMORY = 1 << 20
"""Bytes of a log that has no file."""


class DataLog(Closable):
    """A data log that is open.

    path  of its file; empty for one in memory
    """

    def __init__(self, path: bytes, file: OpenFile | None) -> None:
        self.path = path
        self._file = file
        self._size = 0

    def write(self, data: bytes) -> bool:
        """Adds bytes. False where there is no room."""
        if self._file is not None:
            return self._file.write(data)
        self._size += len(data)
        return self._size <= MOST_IN_MEMORY

    def close(self) -> None:
        """Closes its file."""
        if self._file is not None:
            self._file.close()


def _log(vm: Machine, handle: int) -> DataLog:
    log = vm.program.handles.get(handle, DataLog)
    if log is None:
        raise Failure
    return log


@handles("FILE.OPEN_LOG", places=("NAME",))
def open_log(
    vm: Machine,
    place: Place,
    time: int,
    tick: int,
    now: int,
    interval: int,
    duration: int,
    description: bytes,
    handle: Place,
) -> None:
    """Without a name it stays in memory."""
    path, file = b"", None
    if place.read_text():
        name = checked_name(vm, place)
        if name is None:
            raise Busy
        path = name if filenames.split(name).extension else name + LOG_EXTENSION
        files = vm.brick.files
        opened, found = files.open_to_write(path), files.locate(path)
        if opened is None or found is None:
            vm.brick.settings.log_error("FILE_OPEN_ERROR")
            raise Failure
        file = OpenFile(files, found, opened, True)
    log = DataLog(path, file)
    numbers = "\t".join(str(number) for number in (time, tick, now, interval, duration))
    head = f"Sync data\t{numbers}\r\n".encode(STRING_CODING)
    number = vm.program.handles.add(log) if log.write(head + description) else None
    if number is None:
        log.close()
        raise Failure
    handle.write16(number)


@handles("FILE.WRITE_LOG")
def write_log(vm: Machine, handle: int, time: int, items: int, values: Place) -> None:
    """A row: the time, and the samples; nothing without samples."""
    log = _log(vm, handle)
    if items > 0 and not log.write(struct.pack("<i", time) + values.read_bytes(items * 4)):
        vm.brick.settings.log_error("FILE_WRITE_ERROR")
        raise Failure


@handles("FILE.CLOSE_LOG")
def close_log(vm: Machine, handle: int, name: bytes) -> None:  # noqa: ARG001 - the handle says which
    """With the mark at its end."""
    _log(vm, handle).write(END_MARK)
    vm.release(vm.program, handle)


@handles("FILE.GET_LOG_NAME")
def log_name(vm: Machine, length: int, destination: Place) -> None:
    """Of the log that is open; empty where none is."""
    logs = (entry for entry in vm.program.handles.entries() if isinstance(entry, DataLog))
    vm.write_limited(destination, next((log.path for log in logs), b""), length)
