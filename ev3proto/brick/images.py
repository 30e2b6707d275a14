"""Program images in the brick's memory, which LOAD_IMAGE loads and PROGRAM_START runs.

Addresses serve only to find the image again.
"""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.bounded import Bounded
from ev3proto.brick.running_programs import RUNNING, Program, ProgramObject
from ev3proto.errors import DecodeError
from ev3proto.program import CodeObject, parse
from ev3proto.program.parameters import table_bytes
from ev3proto.program.walk import walk
from ev3proto.tables.memory import ARRAY_ROOM
from ev3proto.tables.program import ObjectKind

FIRST_ADDRESS = 0x40000000
STEP = 0x01000000
MOST_IMAGES = 64
"""Images that are kept; the oldest is forgotten."""

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
        address = self._next
        self._next = FIRST_ADDRESS if address + 2 * STEP > 0x7FFFFFFF else address + STEP
        self._images.add(address, Image(data, folder))
        return address

    def get(self, address: int) -> Image | None:
        """Returns the image at an address."""
        return self._images.get(address)


def _first_operation(part: CodeObject) -> int:
    """Returns where an object's operations begin: after the parameter table, if it is a subcall."""
    return part.offset + (len(table_bytes(part.parameters)) if part.kind is ObjectKind.SUBCALL else 0)


def load(slot: int, image: Image, started: int, dialect: str) -> Program | None:
    """Makes a program of an image, with its first object ready to run; None if the image is damaged or too large."""
    try:
        parsed = parse(image.data, strict=False, dialect=dialect)
    except DecodeError:
        return None
    if not walk(image.data, dialect).accepted:
        return None
    needed = parsed.global_size + sum(part.local_size for part in parsed.objects)
    if needed > ARRAY_ROOM or not parsed.objects:
        return None
    objects: dict[int, ProgramObject] = {}
    for part in parsed.objects:
        objects[part.number] = ProgramObject(
            part.number,
            _first_operation(part),
            bytearray(part.local_size),
            part.local_size,
            kind=part.kind,
            triggers=part.triggers,
            parameters=part.parameters,
        )
    for part in parsed.objects:
        if part.owner in objects:
            # A block runs in the memory of its owner.
            objects[part.number].local_memory = objects[part.owner].local_memory
    for entry in objects.values():
        entry.reset()
    objects[1].status = RUNNING
    code = bytearray(image.data)
    end = len(code)
    code += _ZEROS
    return Program(
        slot,
        code,
        end,
        bytearray(parsed.global_size),
        parsed.global_size,
        objects,
        started=started,
        folder=image.folder,
    )
