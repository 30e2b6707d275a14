"""The public objects of a program: immutable, typed, printable."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from ev3proto.errors import Fault
from ev3proto.messages import NO_FLAW, Flaw, Operation
from ev3proto.program.code import Code
from ev3proto.program.parameters import ProgramParameter, table_bytes
from ev3proto.tables.program import ObjectKind, aligned, kind_of


class ParameterPlace(NamedTuple):
    """The place of a parameter: its offset in local memory, and its bytes."""

    offset: int
    size: int


@dataclass(frozen=True, slots=True, kw_only=True)
class CodeObject:
    """A thread, subcall or block of a program.

    number      1 or more: the place in the program's table
    owner       number of the object that a block belongs to, else 0
    triggers    how often it has to be triggered before it starts; 1 for subcalls and blocks
    local_size  bytes of local memory, 0 to 4294967295
    parameters  what a subcall declares
    operations  its code, the last OBJECT_END included; offsets are those in the image;
                read again each time, so that a program takes little memory
    offset      of its code in the image
    shares      number of the earlier object whose code it uses, or None
    flaw        its fault, and the bytes that could not be read; NO_FLAW for almost all
    """

    number: int = 0
    owner: int = 0
    triggers: int = 0
    local_size: int = 0
    parameters: tuple[ProgramParameter, ...] = ()
    operations: Sequence[Operation] = ()
    offset: int = 0
    shares: int | None = None
    flaw: Flaw = NO_FLAW

    @property
    def kind(self) -> ObjectKind:
        """Thread, subcall or block."""
        return kind_of(self.owner, self.triggers)

    @property
    def fault(self) -> Fault | None:
        """Its fault, or None."""
        return self.flaw.fault

    @property
    def rest(self) -> bytes:
        """Bytes at the end of its code that could not be read."""
        return self.flaw.rest

    @property
    def code(self) -> bytes:
        """All bytes of its code: the table of parameters, the operations, what could not be read."""
        table = b""
        if self.kind is ObjectKind.SUBCALL and not self.flaw.headless:
            table = table_bytes(self.parameters)
        return table + _bytes_of(self.operations) + self.flaw.rest

    @property
    def places(self) -> tuple[ParameterPlace, ...]:
        """The places of its parameters in local memory: they are its first locals."""
        found = []
        end = 0
        for parameter in self.parameters:
            start = aligned(end, parameter.bytes)
            found.append(ParameterPlace(start, parameter.bytes))
            end = start + parameter.bytes
        return tuple(found)


def _bytes_of(operations: Sequence[Operation]) -> bytes:
    if isinstance(operations, Code):
        return operations.raw
    return b"".join([operation.raw for operation in operations])


class Defects(NamedTuple):
    """The irregularities of an image.

    faults        faults of the image as a whole; those of an object are at the object
    offsets       the offset of every object's code, if they are not in order without gaps
    gaps          offset and bytes of parts that belong to no object
    headers       the offsets in the headers, if the firmware uses others: for 0 it uses the next code
    """

    faults: tuple[Fault, ...] = ()
    offsets: tuple[int, ...] | None = None
    gaps: tuple[tuple[int, bytes], ...] = ()
    headers: tuple[int, ...] | None = None


NO_DEFECTS = Defects()
