"""MAILBOX: boxes that programs open, and messages that arrived in them by WRITEMAILBOX."""

from __future__ import annotations

from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.mailboxes import BOXES, Mailbox
from ev3proto.brick.memory import Place
from ev3proto.brick.outcomes import Busy, Failure, WildAccess
from ev3proto.tables.enumerations import DATA_FORMAT, FORMAT_TYPES

_SIZES = {number: kind.size for number, kind in FORMAT_TYPES.items()}
_TEXT = DATA_FORMAT.members["DATA_S"]
_ARRAY = DATA_FORMAT.members["DATA_A"]


def _box(vm: Machine, number: int) -> Mailbox:
    """A mailbox by its number; the firmware does not check it, this brick fails beyond the last one."""
    if not 0 <= number < BOXES:
        raise WildAccess
    return vm.brick.mailboxes.boxes[number]


@handles("MAILBOX_OPEN")
def open_box(vm: Machine, number: int, name: bytes, kind: int, depth: int, values: int) -> None:  # noqa: ARG001
    """Empty; fails where it is open."""
    _box(vm, number)
    if not vm.brick.mailboxes.open(number, name, kind):
        raise Failure


@handles("MAILBOX_CLOSE")
def close_box(vm: Machine, number: int) -> None:
    """Name, content and counters stay until it is opened again."""
    _box(vm, number).is_open = False


@handles("MAILBOX_TEST")
def test_box(vm: Machine, number: int, busy: Place) -> None:
    """1: nothing new."""
    busy.write8(not _box(vm, number).has_news)


@handles("MAILBOX_READY")
def wait_for_box(vm: Machine, number: int) -> None:
    """Until there is something new."""
    if not _box(vm, number).has_news:
        raise Busy


@handles("MAILBOX_READ")
def read_box(vm: Machine, number: int, length: int, values: list[Place]) -> None:  # noqa: ARG001 - as in the firmware
    """Values one after the other from the content, of the type given when it was opened; the content stays.

    Of a box that is not open the firmware executes these parameters as operations; here nothing is read.
    """
    box = _box(vm, number)
    if not box.is_open:
        return
    at = 0
    for place in values:
        at += _read_value(vm, box, at, place)
    if box.has_news:
        box.read += 1


def _read_value(vm: Machine, box: Mailbox, at: int, place: Place) -> int:
    """Writes one value of the content to its place; returns how many bytes it took."""
    rest = bytes(box.content[at:])
    if box.type in _SIZES and box.type not in (_TEXT, _ARRAY):
        size = _SIZES[box.type]
        place.write_bytes(rest[:size].ljust(size, b"\0"))
        return size
    left = max(0, box.size - at)
    if box.type == _ARRAY:
        if vm.resize(place, left):
            place.write_bytes(rest[:left])
        return left
    text = rest.partition(b"\0")[0]
    vm.write_text(place, text, max(left, len(text) + 1))
    return len(text) + 1


@handles("MAILBOX_WRITE")
def write_box(_: Machine, brick: bytes, hardware: int, name: bytes, kind: int, values: list[Place]) -> None:
    """No other brick is connected: nothing is sent, and nothing fails."""
