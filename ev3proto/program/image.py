"""Parses images into programs and builds them. A damaged image is parsed as far as possible."""

from __future__ import annotations

from array import array
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

from construct import Int16ul, Int32ul

from ev3proto.errors import BuildError, DecodeError, Fault, as_bytes, counted
from ev3proto.messages import NO_FLAW, Flaw, Operation
from ev3proto.program.code import Code, scanned
from ev3proto.program.header import (
    IMAGE_HEADER_SIZE,
    OBJECT_HEADER_SIZE,
    PACKED_HEADER,
    PACKED_OBJECT,
)
from ev3proto.program.objects import NO_DEFECTS, CodeObject, Defects
from ev3proto.program.parameters import ProgramParameter, read_table
from ev3proto.program.retyped import HandleFinder, Handles, Types
from ev3proto.program.walk import walk
from ev3proto.schema.instructions import InstructionSet, instruction_set
from ev3proto.tables.program import DEFAULT_VERSION, MAX_IMAGE, MAX_MEMORY, MAX_OBJECTS, SIGN, ObjectKind, kind_of

_COUNT_AT = len(SIGN) + Int32ul.sizeof() + Int16ul.sizeof()
"""Offset of the number of objects."""

READ_IN_PART = "the image was read in part only, so it cannot be made again: fault at {fault}"
"""Why a program with faults has no image and no source."""

_OBJECT_END = "OBJECT_END"
_JUMPS = "JR"
"""The prefix of the names of jumps."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Program:
    """A program for the brick's virtual machine.

    version      100 times the version of the byte code, 0 to 65535; the machine does not depend on it
    global_size  bytes of global memory, 0 to 4294967295
    objects      threads, subcalls and blocks, numbered from 1; the first is started with the program
    defects      irregularities of the image; NO_DEFECTS for almost all
    """

    version: int = DEFAULT_VERSION
    global_size: int = 0
    objects: tuple[CodeObject, ...] = ()
    defects: Defects = NO_DEFECTS

    @property
    def faults(self) -> tuple[Fault, ...]:
        """All faults of the image, in the order of offsets."""
        found = [*self.defects.faults, *(part.fault for part in self.objects if part.fault is not None)]
        return tuple(sorted(set(found)))

    @property
    def fault(self) -> Fault | None:
        """The first fault, or None."""
        return next(iter(self.faults), None)

    def build(self) -> bytes:
        """Returns the image. Raises BuildError if no image can carry the program, or if it was read in part only."""
        return build(self)


_Entry = tuple[int, int, int, int]
"""An entry of the table of objects: offset, owner, triggers, bytes of local memory."""


class _Code(NamedTuple):
    """The code at an offset."""

    parameters: tuple[ProgramParameter, ...] = ()  # what a subcall declares
    starts: Sequence[int] = ()  # the offsets of its operations
    limit: int = 0  # the end of the last one; of a partial one, the end of the bytes that it was read from
    # the arrays whose handles local variables hold
    handles: Handles = {}  # noqa: RUF012 - never changed
    flaw: Flaw = NO_FLAW  # its fault, and the bytes that could not be read


class _Reader:
    """Parses one image. Code that several objects share is read once, so the time is linear in the size."""

    def __init__(self, image: bytes, instructions: InstructionSet) -> None:
        self.image = image
        self.faults: list[Fault] = []
        self._instructions = instructions
        self._finder = HandleFinder(instructions.dialect)
        self._shared: Handles = {}
        self._ends: dict[int, int] = {}

    def program(self) -> Program:
        """Returns the program. Raises DecodeError if the header is incomplete."""
        size, version, count, global_size = self._header()
        end = len(self.image)
        if size != end:
            self._fault(len(SIGN), f"the header says {counted(size, 'byte')}; the image has {end}", size > end)
        stated = self._entries(count)
        entries = self._where_validated(stated)
        table_end = IMAGE_HEADER_SIZE + len(entries) * OBJECT_HEADER_SIZE
        starts = sorted({offset for offset, *_ in entries if table_end <= offset < end})
        self._ends = dict(pairwise((*starts, end)))
        objects = tuple(self._objects(entries))
        gap = self.image[table_end : min(starts, default=end)]
        gaps = ((table_end, gap),) if gap else ()
        headers, offsets = (tuple(offset for offset, *_ in some) for some in (stated, entries))
        is_regular = not gaps and offsets == tuple(regular_offsets([_entry(part) for part in objects]))
        is_stated = headers == offsets
        defects = Defects(tuple(self.faults), None if is_regular else offsets, gaps, None if is_stated else headers)
        return Program(version=version, global_size=global_size, objects=objects, defects=defects)

    def _entries(self, count: int) -> list[_Entry]:
        """Returns the entries in the table of objects, as far as it is there."""
        known = min(count, (len(self.image) - IMAGE_HEADER_SIZE) // OBJECT_HEADER_SIZE)
        if known < count:
            self._fault(_COUNT_AT, f"the table of objects is cut off: {count} should be in it, {known} are", True)
        return list(PACKED_OBJECT.iter_unpack(self.image[IMAGE_HEADER_SIZE:][: known * OBJECT_HEADER_SIZE]))

    def _header(self) -> tuple[int, int, int, int]:
        image = self.image
        if not image.startswith(SIGN[: len(image)]) or not image:
            raise DecodeError(0, f"an image starts with {SIGN.decode()}, not {image[: len(SIGN)]!r}")
        if len(image) < IMAGE_HEADER_SIZE:
            raise DecodeError(
                len(image),
                f"an image starts with a header of {IMAGE_HEADER_SIZE} bytes, not {len(image)}",
                truncated=True,
            )
        size, version, count, global_size = PACKED_HEADER.unpack_from(image, len(SIGN))
        return size, version, count, global_size

    def _fault(self, offset: int, reason: str, truncated: bool = False) -> None:
        self.faults.append(Fault(offset, reason, truncated))

    def _where_validated(self, entries: list[_Entry]) -> list[_Entry]:
        """Returns the entries with offsets of 0, as in one published image, replaced by those the firmware uses."""
        if all(offset for offset, *_ in entries):
            return entries
        offsets = [read.offset for read in walk(self.image, self._instructions.dialect).objects]
        offsets += [0] * (len(entries) - len(offsets))
        return [
            (offset or validated, owner, triggers, local_size)
            for (offset, owner, triggers, local_size), validated in zip(entries, offsets, strict=True)
        ]

    def _objects(self, entries: list[_Entry]) -> list[CodeObject]:
        codes: dict[tuple[int, bool], _Code] = {}
        callees: dict[int, tuple[ProgramParameter, ...]] = {}
        for number, (offset, owner, triggers, _) in enumerate(entries, 1):
            if offset not in self._ends:
                continue
            key = (offset, kind_of(owner, triggers) is ObjectKind.SUBCALL)
            if key not in codes:
                codes[key] = self._read_code(*key)
            callees[number] = codes[key].parameters
        types = {
            key: Types(callees, code.handles, self._shared, self._instructions.dialect) for key, code in codes.items()
        }
        first: dict[int, int] = {}
        objects = []
        for number, (offset, owner, triggers, local_size) in enumerate(entries, 1):
            shares = first.get(offset)
            operations: Sequence[Operation] = ()
            if offset not in self._ends:
                code = self._nowhere(number, offset)
            else:
                first.setdefault(offset, number)
                key = (offset, kind_of(owner, triggers) is ObjectKind.SUBCALL)
                code = codes[key]
                operations = Code(self.image, code.starts, code.limit, types[key])
            objects.append(
                CodeObject(
                    number=number,
                    owner=owner,
                    triggers=triggers,
                    local_size=local_size,
                    parameters=code.parameters,
                    operations=operations,
                    offset=offset,
                    shares=shares,
                    flaw=code.flaw,
                )
            )
        return objects

    def _nowhere(self, number: int, offset: int) -> _Code:
        """Returns an object whose offset leads to no code."""
        at = IMAGE_HEADER_SIZE + (number - 1) * OBJECT_HEADER_SIZE
        where = "in the header" if offset < len(self.image) else "after the end of the image"
        fault = Fault(at, f"the code of object {number} should be at offset {offset}, {where}")
        return _Code(flaw=Flaw(fault, headless=True))

    def _read_code(self, start: int, is_subcall: bool) -> _Code:
        at, end = start, self._ends[start]
        parameters: tuple[ProgramParameter, ...] = ()
        if is_subcall:
            try:
                parameters, at = read_table(self.image, at, end)
            except DecodeError as error:
                return _Code(flaw=Flaw(error.fault, self.image[start:end], headless=True))
        starts: array[int] = array("I")
        handles: Handles = {}
        furthest, limit, fault = 0, at, None
        for operation in scanned(self.image, at, end, self._instructions):
            if isinstance(operation, Fault):
                fault = operation
                break
            starts.append(operation.offset)
            self._finder.note(operation, handles, self._shared)
            limit = operation.offset + operation.length
            if operation.name == _OBJECT_END and furthest <= operation.offset:
                # The bytes after it never run.
                break
            furthest = max(furthest, _target(operation))
        flaw = Flaw(fault, self.image[limit:end]) if fault is not None or limit < end else NO_FLAW
        return _Code(parameters, starts, limit if fault is None else end, handles, flaw)


def _target(operation: Operation) -> int:
    """Returns the offset that a jump by a constant leads to; 0 for other operations."""
    if not operation.name.startswith(_JUMPS):
        return 0
    arguments = operation.arguments
    target = arguments[-1].value if arguments else None
    if not isinstance(target, int) or arguments[-1].is_variable:
        return 0
    return operation.offset + operation.length + target


class NewObject(NamedTuple):
    """An object to be written: its header, and its code or the number of the earlier object whose code it uses."""

    owner: int
    triggers: int
    local_size: int
    code: bytes
    shares: int | None = None


def regular_offsets(entries: Sequence[NewObject]) -> Iterator[int]:
    """Yields the offsets of the codes in the usual layout: in order, without gaps, shared code once."""
    at = IMAGE_HEADER_SIZE + len(entries) * OBJECT_HEADER_SIZE
    starts: list[int] = []
    for entry in entries:
        starts.append(at)
        at += len(entry.code)
    for start, entry in zip(starts, entries, strict=True):
        is_shared = entry.shares is not None and 0 < entry.shares <= len(entries)
        yield starts[entry.shares - 1] if is_shared and entry.shares is not None else start


def _entry(part: CodeObject) -> NewObject:
    if not isinstance(part, CodeObject):
        raise BuildError(f"objects cannot have {part!r}: each is a CodeObject")
    code = b"" if part.shares is not None else part.code
    return NewObject(part.owner, part.triggers, part.local_size, code, part.shares)


def parse(image: bytes | bytearray | memoryview, *, strict: bool = True, dialect: str = "official") -> Program:
    """Reads a program image.

    Args:
        image: The image from its sign to its last byte, at most 4 MiB.
        strict: False: nothing after the header raises; `program.faults` says what is wrong and where, and what could be
            read is there.
        dialect: "official", "xtended" or "compat": the firmware whose instruction set to use.

    Returns:
        The program; without faults, its `build()` gives the same bytes again.

    Raises:
        DecodeError: The image is faulty, or not even its header can be read. The error has `offset` and `reason`.
        ValueError: The dialect is unknown.
        TypeError: The image is not made of bytes.
    """
    image = as_bytes(image, "an image")
    instructions = instruction_set(dialect)
    if len(image) > MAX_IMAGE:
        raise DecodeError(MAX_IMAGE, f"the image has {len(image)} bytes; at most {MAX_IMAGE} are read")
    program = _Reader(image, instructions).program()
    if strict and program.fault is not None:
        raise DecodeError(*program.fault)
    return program


def build(program: Program) -> bytes:
    """Returns the image of a program. If it was parsed, codes keep their offsets.

    Args:
        program: The program.

    Returns:
        The image.

    Raises:
        BuildError: No image can carry the program: the message names the field. Or the program has faults: it was read
            in part only.
        TypeError: It is not a Program.
    """
    if not isinstance(program, Program):
        raise TypeError(f"an image is made of a Program, not of {type(program).__name__}")
    if not isinstance(program.defects, Defects):
        raise BuildError(f"defects cannot be {program.defects!r}: they are Defects")
    if program.fault is not None:
        raise BuildError(READ_IN_PART.format(fault=program.fault))
    return image_of(program.version, program.global_size, [_entry(part) for part in program.objects], program.defects)


def image_of(
    version: int,
    global_size: int,
    entries: Sequence[NewObject],
    defects: Defects = NO_DEFECTS,
) -> bytes:
    """Returns the image of objects. Raises BuildError, which names the field."""
    if len(entries) > MAX_OBJECTS:
        raise BuildError(f"a program cannot have {len(entries)} objects: at most {MAX_OBJECTS}")
    offsets = tuple(regular_offsets(entries)) if defects.offsets is None else defects.offsets
    for stated in (offsets, defects.headers):
        if stated is not None and len(stated) != len(entries):
            raise BuildError(f"the program has {len(entries)} objects, and its defects name {len(stated)} offsets")
    body = b"".join(piece for _, piece in _pieces(entries, offsets, defects))
    size = IMAGE_HEADER_SIZE + len(entries) * OBJECT_HEADER_SIZE + len(body)
    head = SIGN + PACKED_HEADER.pack(
        _field("the size", size, MAX_MEMORY),
        _field("version", version, 0xFFFF),
        len(entries),
        _field("global_size", global_size, MAX_MEMORY),
    )
    table = b"".join(
        PACKED_OBJECT.pack(
            _field("the offset", offset, MAX_MEMORY),
            _field("owner", entry.owner, MAX_OBJECTS),
            _field("triggers", entry.triggers, 0xFFFF),
            _field("local_size", entry.local_size, MAX_MEMORY),
        )
        for entry, offset in zip(entries, offsets if defects.headers is None else defects.headers, strict=True)
    )
    return head + table + body


def _pieces(entries: Sequence[NewObject], offsets: Sequence[int], defects: Defects) -> list[tuple[int, bytes]]:
    """Yields the codes and what is between them, in the order of the image."""
    own = [(offset, entry.code) for entry, offset in zip(entries, offsets, strict=True) if entry.shares is None]
    return sorted([*defects.gaps, *own], key=lambda piece: piece[0]) if defects.offsets is not None else own


def _field(name: str, value: int, most: int) -> int:
    if isinstance(value, int) and 0 <= value <= most:
        return value
    raise BuildError(f"{name} cannot be {value!r}: it is a whole number from 0 to {most}")
