"""FILE: opening, reading, writing, folders, the list of recent files, program images."""

from __future__ import annotations

from ev3proto.brick.conversions import wrap8
from ev3proto.brick.exits import Busy, Failure
from ev3proto.brick.formatting import fixed, padded, read_number
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.handles import NO_HANDLE
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine
from ev3proto.brick.open_files import MOST_RECENT, OpenFile
from ev3proto.brick.running_programs import RUNNING
from ev3proto.brick.text_lines import DELIMITERS
from ev3proto.tables import paths
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import Type
from ev3proto.tables.encoding import STRING_CODING
from ev3proto.tables.paths import ALLOWED, has_room, is_spelled

IMAGE_EXTENSION = str(CONSTANTS["EXT_BYTECODE"]).encode(STRING_CODING)

_MOST_NUMBER = 64
"""Bytes of a number's text."""

_REPLACED = bytes(byte if byte in ALLOWED else ord("_") for byte in range(256))
"""What the firmware makes of each character of a name."""


def allowed_name(vm: Machine, place: Location) -> bytes | None:
    """Reads a file's name as the firmware checks it; None if it is not allowed.

    The error is logged unless the log has it already. Forbidden characters are replaced in memory, so that the name
    passes the next time.
    """
    text = place.read_text()
    is_allowed = is_spelled(text)
    if not is_allowed:
        place.write_bytes(text.translate(_REPLACED))
    if is_allowed and has_room(text):
        return text
    vm.brick.settings.log_once("FILE_NAME_ERROR")
    return None


def checked_name(vm: Machine, place: Location) -> bytes | None:
    """Reads a file's name, in the program's own folder unless it names another one; None if it is not allowed."""
    name = allowed_name(vm, place)
    return None if name is None else in_own_folder(vm, name)


def in_own_folder(vm: Machine, name: bytes) -> bytes:
    """Returns a name in the program's own folder, unless it names another one."""
    return name if b"/" in name else vm.program.folder.encode(STRING_CODING) + name


def write_or_cut(vm: Machine, place: Location, text: bytes, length: int) -> None:
    """Cuts a text to the length; an array gets all of it instead."""
    if place.handle >= 0:
        vm.write_text(place, text)
    else:
        place.write_cut(text, length)


# Opening and closing


def opened_name(vm: Machine, place: Location) -> bytes:
    """Reads the name of a file to open; a forbidden one is tried again once its characters are replaced."""
    name = checked_name(vm, place)
    if name is None:
        raise Busy
    return name


def add(vm: Machine, file: OpenFile, handle: Location) -> None:
    """Writes the handle of an open file; -1 and a failure if none is left."""
    number = vm.program.handles.add(file)
    handle.write16(NO_HANDLE if number is None else number)
    if number is None:
        file.stream.close()
        vm.brick.settings.log_error("FILE_OPEN_ERROR")
        raise Failure


def open_to_write(vm: Machine, name: bytes, handle: Location, *, append: bool, is_log: bool = False) -> OpenFile:
    """Opens a file to write; handle 0 and a failure if that is impossible."""
    files = vm.brick.files
    file, found = files.open_to_write(name, append=append), files.locate(name)
    if file is None or found is None:
        handle.write16(0)
        vm.brick.settings.log_error("FILE_OPEN_ERROR")
        raise Failure
    opened = OpenFile(found, file, True, name, is_log)
    add(vm, opened, handle)
    return opened


@handles("FILE.OPEN_READ", places=("NAME",))
def open_read(vm: Machine, place: Location, handle: Location, size: Location) -> None:
    """Opens a file to read; for an unknown file handle and size are 0, and nothing fails."""
    name = opened_name(vm, place)
    files = vm.brick.files
    file, found = files.open_to_read(name), files.locate(name)
    if file is None or found is None:
        handle.write16(0)
        size.write32(0)
        return
    add(vm, OpenFile(found, file, False, name), handle)
    size.write32(files.totals(name).size)


@handles("FILE.OPEN_WRITE", places=("NAME",))
def open_write(vm: Machine, place: Location, handle: Location) -> None:
    """Opens a file to write; its contents are lost."""
    open_to_write(vm, opened_name(vm, place), handle, append=False)


@handles("FILE.OPEN_APPEND", places=("NAME",))
def open_append(vm: Machine, place: Location, handle: Location) -> None:
    """Opens a file to append."""
    open_to_write(vm, opened_name(vm, place), handle, append=True)


@handles("FILE.CLOSE")
def close(vm: Machine, handle: int) -> None:
    """Closes a file; frees an array, too."""
    if not vm.release(vm.program, handle):
        vm.brick.settings.log_error("FILE_CLOSE_ERROR")
        raise Failure


@handles("FILE.GET_HANDLE", places=("NAME",))
def get_handle(vm: Machine, place: Location, handle: Location, for_writing: Location) -> None:
    """Writes -1 if no file was opened by that name; another path to the same file is another name."""
    number, file = find_open(vm, opened_name(vm, place))
    handle.write16(number)
    for_writing.write8(file is not None and file.for_writing)


def find_open(vm: Machine, name: bytes) -> tuple[int, OpenFile | None]:
    """Returns the handle of an open file and the file, by the name used to open it; -1 and None for others."""
    for number, entry in vm.program.handles.items():
        if isinstance(entry, OpenFile) and entry.name == name:
            return number, entry
    return NO_HANDLE, None


# Reading and writing


def _file(vm: Machine, handle: int, for_writing: bool) -> OpenFile:
    """Returns an open file. Failure for an unknown handle, and for a file opened for the other direction."""
    file = vm.program.handles.get(handle, OpenFile)
    if file is None or file.for_writing is not for_writing:
        vm.brick.settings.log_error("FILE_WRITE_ERROR" if for_writing else "FILE_READ_ERROR")
        raise Failure
    return file


def _write(vm: Machine, handle: int, data: bytes, delimiter: int = 0) -> None:
    """Writes data and a delimiter; fails for an unknown delimiter, after the data is written."""
    end = b"" if delimiter < 0 else DELIMITERS.get(delimiter)
    if not _file(vm, handle, True).stream.put(data + (end or b"")) or end is None:
        vm.brick.settings.log_error("FILE_WRITE_ERROR")
        raise Failure


@handles("FILE.READ_TEXT")
def read_text(vm: Machine, handle: int, delimiter: int, length: int, destination: Location) -> None:
    """Reads a text; a zero follows if it fits. The length counts as 8 bits."""
    length = wrap8(length)
    text = _file(vm, handle, False).read_until(DELIMITERS.get(delimiter, b""), max(0, length))
    _write_read(vm, destination, text, length)


def _write_read(vm: Machine, destination: Location, data: bytes, most: int) -> None:
    """Writes the bytes read, and a zero unless they are as many as requested, which a negative number never is."""
    if most <= 0 or vm.resize(destination, most):
        destination.write_bytes(data + b"\0" * (len(data) != most))


@handles("FILE.READ_VALUE")
def read_value(vm: Machine, handle: int, delimiter: int, value: Location) -> None:
    """Reads a number; 0 if the text is not a number, or if it fails."""
    value.write_float(0.0)
    text = _file(vm, handle, False).read_until(DELIMITERS.get(delimiter, b""), _MOST_NUMBER)
    number = read_number(text)
    value.write_float(0.0 if number is None else number)


@handles("FILE.READ_BYTES")
def read_bytes(vm: Machine, handle: int, count: int, destination: Location) -> None:
    """Reads bytes; a zero follows if the file ended early."""
    _write_read(vm, destination, _file(vm, handle, False).read(count), count)


@handles("FILE.WRITE_TEXT")
def write_text(vm: Machine, handle: int, delimiter: int, text: bytes) -> None:
    """Writes a text and the delimiter."""
    _write(vm, handle, text, delimiter)


@handles("FILE.WRITE_VALUE")
def write_value(vm: Machine, handle: int, delimiter: int, value: float, figures: int, decimals: int) -> None:
    """Writes a number as text, and the delimiter."""
    _write(vm, handle, padded(fixed(value, decimals), figures).encode(STRING_CODING), delimiter)


@handles("FILE.WRITE_BYTES")
def write_bytes(vm: Machine, handle: int, count: int, source: Location) -> None:
    """Writes bytes as they are."""
    _write(vm, handle, source.read_bytes(count))


# Folders


@handles("FILE.REMOVE", places=("NAME",))
def remove(vm: Machine, place: Location) -> None:
    """Deletes a file, or a folder with its files; the list of recent files forgets them."""
    name = checked_name(vm, place)
    if name is not None:
        _remove(vm, name)


def _remove(vm: Machine, path: bytes) -> None:
    files, recent = vm.brick.files, vm.brick.recent
    for known in recent.paths:
        folder, _, name = known.rpartition(b"/")
        if known == path or (folder == path and name in files.entries(path)):
            recent.forget(known)
    files.remove(path)


@handles("FILE.MOVE", places=("SOURCE", "DEST"))
def move(vm: Machine, source: Location, target: Location) -> None:
    """Copies: the source stays. The target is deleted, even if there is nothing to copy."""
    origin = checked_name(vm, source)
    goal = None if origin is None else checked_name(vm, target)
    if origin is None or goal is None:
        return
    files = vm.brick.files
    if files.is_file(goal) or files.is_folder(goal):
        _remove(vm, goal)
    files.copy(origin, goal)


def _entry(vm: Machine, folder: bytes, item: int) -> bytes | None:
    """Returns the name of an entry of a folder, counted from 1; None for an unknown one."""
    names = vm.brick.files.shown(folder)
    return names[item - 1] if 1 <= item <= len(names) else None


@handles("FILE.GET_SUBFOLDER_NAME")
def entry_name(vm: Machine, folder: bytes, item: int, length: int, destination: Location) -> None:
    """Writes the name of an entry without its extension; empty for an unknown entry."""
    name = _entry(vm, folder, item) or b""
    destination.write8(0)
    destination.write_cut(name.partition(b".")[0], length)


@handles("FILE.DEL_SUBFOLDER")
def delete_entry(vm: Machine, folder: bytes, item: int) -> None:
    """Deletes a folder in a folder, with its files.

    The name follows the folder as it is, without a slash and without its extension. So a file that has one is not
    found, and a missing entry means the folder itself.
    """
    name = _entry(vm, folder, item) or b""
    _remove(vm, folder + name.partition(b".")[0])


# Recent files


@handles("FILE.PUT_CACHE_FILE", places=("STRING",))
def put_recent(vm: Machine, place: Location) -> None:
    """Puts a file first in the list."""
    name = allowed_name(vm, place)
    if name is not None:
        vm.brick.recent.put(name)


@handles("FILE.GET_CACHE_FILE")
def recent_name(vm: Machine, item: int, length: int, destination: Location) -> None:
    """Writes a recent file's name, or an empty one; fails for a number outside the list."""
    if not 1 <= item <= MOST_RECENT:
        raise Failure
    recent = vm.brick.recent.paths
    destination.write_cut(recent[item - 1] if item <= len(recent) else b"", length)


# Programs and memory


@handles("FILE.LOAD_IMAGE", places=("NAME",))
def load_image(vm: Machine, slot: int, place: Location, size: Location, address: Location) -> None:
    """Loads a program; for an unknown file size and address are 0. Nothing is written for a bad name, or if the slot
    runs a program.
    """
    running = vm.program_in(slot)
    if running is not None and running.status == RUNNING:
        return
    name = checked_name(vm, place)
    if name is None:
        return
    parts = paths.split(name)
    image = vm.brick.files.read(name if parts.extension else name + IMAGE_EXTENSION)
    if image is None:
        size.write32(0)
        address.write32(0)
        return
    size.write32(len(image))
    address.write32(vm.images.add(image, parts.folder.decode(STRING_CODING)))


@handles("FILE.GET_POOL")
def get_pool(vm: Machine, size: int, handle: Location, address: Location) -> None:
    """Allocates memory with an address, though nothing here reaches it by that address."""
    number = vm.create_array(Type.DATA8, size) if size > 0 else None
    handle.write16(NO_HANDLE if number is None else number)
    address.write32(0 if number is None else vm.images.add(b"", ""))
    if number is None:
        raise Failure


# Operations that need only one line


def _make_folder(vm: Machine, path: bytes) -> bool:
    """Makes a folder; one slash may follow its name. Returns whether anything of that name exists now."""
    files = vm.brick.files
    path = path[: paths.FOLDER - 1].removesuffix(b"/")
    return files.is_folder(path) or files.is_file(path) or files.make_folder(path)


def _number_of(vm: Machine, folder: bytes, name: bytes) -> int:
    """Returns the number of an entry of a folder, counted from 1; 0 for an unknown one."""
    names = [entry.partition(b".")[0] for entry in vm.brick.files.shown(folder)]
    return names.index(name) + 1 if name in names else 0


computes(
    {
        "FILE.MAKE_FOLDER": _make_folder,
        "FILE.GET_FOLDERS": lambda vm, folder: len(vm.brick.files.shown(folder)),
        "FILE.GET_ITEM": _number_of,
        # The recent files, 10 at most.
        "FILE.GET_CACHE_FILES": lambda vm: len(vm.brick.recent.paths),
        "FILE.DEL_CACHE_FILE": lambda vm, path: vm.brick.recent.forget(path),
        # The time and tick to which data logs are aligned.
        "FILE.SET_LOG_SYNC_TIME": lambda vm, *sync: setattr(vm.brick, "log_sync", sync),
        "FILE.GET_LOG_SYNC_TIME": lambda vm: vm.brick.log_sync,
    }
)
