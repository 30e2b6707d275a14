"""The firmware's validator for programs: one index moves from the end of the headers to the stated size.

The brick starts what it accepts. Codes are read one after the other, in the order of the headers, as if there were no
gaps between them; the offsets in the headers are mostly ignored. So a program may pass and then run other bytes than
those that were validated.
"""

from __future__ import annotations

from typing import NamedTuple

from ev3proto.checking.verdict import OBJECT_END, Reason, Refusal, Validator, validator
from ev3proto.program.header import IMAGE_HEADER_SIZE, OBJECT_HEADER_SIZE, PACKED_HEADER, PACKED_OBJECT
from ev3proto.program.parameters import has_size
from ev3proto.tables.program import DEFAULT_VERSION, OLD_VERSIONS, RELEASE_VERSION, SIGN, ObjectKind, kind_of

SIZE_AT = len(SIGN)
"""Offset of the size of the image, the position of every fault of the header."""

VERSION_AT = SIZE_AT + 4
"""Offset of the version."""

_AFTER_IMAGE = bytes(256)
"""Zeros after the image, more than an operation can read beyond the end."""


REASONS = {
    Reason.OPCODE: "unknown opcode",
    Reason.RANGE: "its first constant is out of range",
    Reason.ALIGNMENT: "a variable is not aligned",
    Reason.LABEL: "the number of a label is not 0 to 31",
    Reason.CUT_OFF: "it ends after the end of the image",
    Reason.AFTER_END: "bytes follow the end of the last object",
}
"""Why the code of a program is refused."""


class ObjectRead(NamedTuple):
    """Where the validator reads an object."""

    offset: int  # of the object's code: from its header, or the validator's position if that is 0
    start: int | None  # where it starts to read; None if it reads nothing


class Walk(NamedTuple):
    """The validator's verdict on an image."""

    accepted: bool  # whether the brick starts the program
    # offset of the rejected operation or header field, or None. A version from before the release has a position, too,
    # but is accepted
    position: int | None = None
    reason: str | None = None  # why it refuses
    objects: tuple[ObjectRead, ...] = ()  # those that it reads, up to the refusal


def walk(image: bytes, dialect: str = "official") -> Walk:
    """Returns the validator's verdict on an image with a complete header.

    A version between that of 2013's release and the latest says that the program is for a firmware with newer commands.
    """
    stated, version, count, _ = PACKED_HEADER.unpack_from(image, SIZE_AT)
    table_end = IMAGE_HEADER_SIZE + OBJECT_HEADER_SIZE * count
    faults = (
        (not count, "the program has no objects"),
        (stated < table_end, f"the header states {stated} bytes, fewer than the headers of {count} objects take"),
        (len(image) < stated, f"the header states {stated} bytes; the image has {len(image)}"),
    )
    for fault in [words for is_so, words in faults if is_so]:
        return Walk(False, SIZE_AT, fault)
    way = _Way(image, stated, validator(dialect, is_latest=RELEASE_VERSION < version <= DEFAULT_VERSION))
    for offset, owner, triggers, _ in PACKED_OBJECT.iter_unpack(image[IMAGE_HEADER_SIZE:table_end]):
        reason = way.read(offset or way.at, is_subcall=kind_of(owner, triggers) is ObjectKind.SUBCALL)
        if reason is not None:
            return Walk(False, way.at, REASONS[reason], tuple(way.objects))
    if way.at != stated and way.last is not None:
        reason = Reason.CUT_OFF if way.at > stated else Reason.AFTER_END
        return Walk(False, way.last, REASONS[reason], tuple(way.objects))
    return Walk(True, VERSION_AT if version in OLD_VERSIONS else None, None, tuple(way.objects))


class _Way:
    """The way of the validator through an image.

    at       where it is
    last     the last operation that it has read, None for none
    objects  those that it has read
    """

    def __init__(self, image: bytes, stated: int, validator: Validator) -> None:
        self._data = image + _AFTER_IMAGE
        self._stated = stated
        self._step = validator.step
        self.at = IMAGE_HEADER_SIZE + OBJECT_HEADER_SIZE * PACKED_HEADER.unpack_from(image, SIZE_AT)[2]
        self.last: int | None = None
        self.objects: list[ObjectRead] = []

    def read(self, offset: int, *, is_subcall: bool) -> Reason | None:
        """Reads an object with the offset of its header; returns why it is refused."""
        data, is_nothing, is_ended = self._data, is_subcall and offset < self.at, False
        self.objects.append(ObjectRead(offset, None if is_nothing else self.at))
        if is_subcall and not is_nothing:
            self.at = _table_end(data, self.at)
        while self.at < self._stated and not (is_ended or is_nothing):
            self.last = self.at
            is_ended = data[self.at] == OBJECT_END
            found = self._step(data, self.at, self._stated)
            if isinstance(found, Refusal):
                return found.reason
            self.at = found
        return None


def _table_end(data: bytes, at: int) -> int:
    """Returns the offset after a parameter table, which may be beyond the end of the image."""
    count = data[at] if at < len(data) else 0
    at += 1
    for _ in range(count):
        code = data[at] if at < len(data) else 0
        at += 2 if has_size(code) else 1
    return at
