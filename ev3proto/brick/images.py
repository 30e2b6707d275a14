"""Program images in the brick's memory, which LOAD_IMAGE loads and PROGRAM_START runs.

Addresses serve only to find the image again.
"""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.bounded import Bounded
from ev3proto.brick.running_programs import RUNNING, Program, ProgramObject
from ev3proto.errors import DecodeError
from ev3proto.program import ProgramParameter
from ev3proto.program.header import IMAGE_HEADER_SIZE, OBJECT_HEADER_SIZE, PACKED_HEADER, PACKED_OBJECT
from ev3proto.program.parameters import read_table
from ev3proto.program.walk import walk
from ev3proto.tables.memory import ARRAY_ROOM
from ev3proto.tables.program import MAX_IMAGE, SIGN, ObjectKind, kind_of

FIRST_ADDRESS = 0x40000000
_ADDRESS_STEP = 0x01000000
MOST_IMAGES = 64
"""Images that are kept; the oldest is forgotten."""

MOST_BYTES = 2 * ARRAY_ROOM
"""Bytes of all images that are kept."""

_ZEROS = bytes(8)
"""The bytes after an image, which an incomplete operation reads."""


class Image(NamedTuple):
    """An image in memory."""

    data: bytes
    folder: str  # where it was loaded from, with its closing slash


class Images:
    """The images in memory, by address."""

    def __init__(self) -> None:
        self._images: Bounded[int, Image] = Bounded(MOST_IMAGES)
        self._next = FIRST_ADDRESS

    def add(self, data: bytes, folder: str) -> int:
        """Puts an image in memory and returns its address."""
        while self._images and sum(len(image.data) for image in self._images.values()) + len(data) > MOST_BYTES:
            self._images.pop_oldest()
        address = self._next
        self._next = FIRST_ADDRESS if address + 2 * _ADDRESS_STEP > 0x7FFFFFFF else address + _ADDRESS_STEP
        self._images.add(address, Image(data, folder))
        return address

    def get(self, address: int) -> Image | None:
        """Returns the image at an address."""
        return self._images.get(address)


def load(slot: int, image: Image, started: int, dialect: str) -> Program | None:
    """Makes a program of an image, with its first object ready to run; None if the image is damaged or too large."""
    data = image.data
    if not data.startswith(SIGN) or not IMAGE_HEADER_SIZE <= len(data) <= MAX_IMAGE:
        return None
    _, _, count, global_size = PACKED_HEADER.unpack_from(data, len(SIGN))
    if IMAGE_HEADER_SIZE + count * OBJECT_HEADER_SIZE > len(data):
        return None
    found = walk(data, dialect)
    if not found.accepted:
        return None
    objects: dict[int, ProgramObject] = {}
    owners: dict[int, int] = {}
    needed = global_size
    for number, read in enumerate(found.objects, 1):
        at = IMAGE_HEADER_SIZE + (number - 1) * OBJECT_HEADER_SIZE
        _, owner, triggers, local_size = PACKED_OBJECT.unpack_from(data, at)
        needed += local_size
        if needed > ARRAY_ROOM:
            return None
        kind = kind_of(owner, triggers)
        parameters, begin = _table(data, read.offset, kind)
        local_memory = bytearray(local_size)
        objects[number] = ProgramObject(
            number, begin, local_memory, local_size, kind=kind, triggers=triggers, parameters=parameters
        )
        if kind is ObjectKind.BLOCK:
            owners[number] = owner
    for number, owner in owners.items():
        # A block runs in the memory of its owner.
        objects[number].local_memory = objects.get(owner, objects[number]).local_memory
    for entry in objects.values():
        entry.reset()
    objects[1].status = RUNNING
    return Program(
        slot,
        bytearray(data + _ZEROS),
        len(data),
        bytearray(global_size),
        global_size,
        objects,
        started=started,
        folder=image.folder,
    )


def _table(data: bytes, at: int, kind: ObjectKind) -> tuple[tuple[ProgramParameter, ...], int]:
    """Returns the parameters of an object, which a subcall has, and where its operations begin."""
    try:
        return read_table(data, at, len(data)) if kind is ObjectKind.SUBCALL else ((), at)
    except DecodeError:
        return (), at
