"""MAILBOX: boxes that programs open, and messages that arrived in them by WRITEMAILBOX."""

from __future__ import annotations

from ev3proto.brick.boxes import Mailbox
from ev3proto.brick.exits import Busy, Failure, WildAccess
from ev3proto.brick.handlers import computes, handles
from ev3proto.brick.handles import Array
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine
from ev3proto.tables.enumerations import DATA_FORMAT, FORMAT_TYPES
from ev3proto.tables.mailboxes import BOXES, MOST_CONTENT

_SIZES = {number: kind.size for number, kind in FORMAT_TYPES.items()}
_TEXT = DATA_FORMAT.members["DATA_S"]
_ARRAY = DATA_FORMAT.members["DATA_A"]


def _box(vm: Machine, number: int) -> Mailbox:
    """Returns a mailbox by its number; fails beyond the last one, which the firmware does not check."""
    if not 0 <= number < BOXES:
        raise WildAccess
    return vm.brick.mailboxes.boxes[number]


@handles("MAILBOX_OPEN")
def open_box(vm: Machine, number: int, name: bytes, kind: int, depth: int, values: int) -> None:  # noqa: ARG001
    """Opens an empty mailbox; fails if it is already open."""
    _box(vm, number)
    if not vm.brick.mailboxes.open(number, name, kind):
        raise Failure


computes(
    {
        # Name, content and counters stay until it is opened again.
        "MAILBOX_CLOSE": lambda vm, number: setattr(_box(vm, number), "is_open", False),
        # 1: nothing new.
        "MAILBOX_TEST": lambda vm, number: not _box(vm, number).has_news,
    }
)


@handles("MAILBOX_READY")
def wait_for_box(vm: Machine, number: int) -> None:
    """Waits for an unread message."""
    if not _box(vm, number).has_news:
        raise Busy


@handles("MAILBOX_READ")
def read_box(vm: Machine, number: int, length: int, values: list[Location]) -> None:  # noqa: ARG001 - as in the firmware
    """Reads values from the content, of the type that the mailbox was opened with; the content stays.

    Of a box that is not open the firmware executes these parameters as operations; here nothing is read.
    """
    box = _box(vm, number)
    if not box.is_open:
        return
    for number, place in enumerate(values):
        _read_value(vm, box, number, place)
    if box.has_news:
        box.read += 1


def _read_value(vm: Machine, box: Mailbox, number: int, place: Location) -> None:
    """Writes one value of the content to its place; every text is the first one."""
    if box.type in _SIZES and box.type not in (_TEXT, _ARRAY):
        size = _SIZES[box.type]
        place.write_bytes(bytes(box.content[number * size : (number + 1) * size]).ljust(size, b"\0"))
    elif box.type == _TEXT:
        text = bytes(box.content[: MOST_CONTENT - 1]).partition(b"\0")[0]
        if place.handle < 0 or (box.size > 0 and vm.resize(place, box.size)):
            place.write_text(text)
    elif box.type == _ARRAY:
        _read_array(vm, box, number, place.read16())


def _read_array(vm: Machine, box: Mailbox, begin: int, handle: int) -> None:
    """Gives an array, named by a value's handle, as many elements as the message has bytes, and empties the message."""
    array = vm.program.handles.get(handle, Array)
    size, box.size = box.size, 0
    if size > 0 and array is not None and vm.resize_array(array, size):
        data = bytes(box.content[begin : begin + size])
        array.data[: len(data)] = data
