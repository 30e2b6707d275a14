"""A program in a slot of the machine: its code, objects, memory, resources and status."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from ev3proto.brick.handles import HandleTable
from ev3proto.brick.locations import Location
from ev3proto.checking.verdict import Refusal, validator
from ev3proto.program import ProgramParameter
from ev3proto.tables import operations
from ev3proto.tables.enumerations import OBJSTAT, RESULT, SLOT
from ev3proto.tables.program import ObjectKind

RUNNING, WAITING, STOPPED, HALTED = (OBJSTAT.members[name] for name in ("RUNNING", "WAITING", "STOPPED", "HALTED"))
OK, BUSY, FAIL, STOP = (RESULT.members[name] for name in ("OK", "BUSY", "FAIL", "STOP"))
GUI_SLOT, USER_SLOT, CMD_SLOT, TERM_SLOT, DEBUG_SLOT = (
    SLOT.members[name] for name in ("GUI_SLOT", "USER_SLOT", "CMD_SLOT", "TERM_SLOT", "DEBUG_SLOT")
)
CURRENT_SLOT = SLOT.members["CURRENT_SLOT"]
SLOTS = 5

_LABEL = operations()["LABEL"].opcode.number
_OBJECT_END = operations()["OBJECT_END"].opcode.number

_AFTER_CODE = bytes(256)
"""Zeros after code, more than an operation can read beyond the end."""


class Result(NamedTuple):
    """An output of a subroutine."""

    parameter: ProgramParameter  # as the subroutine declares it
    own: Location  # its place in the subroutine's memory
    place: Location  # its place in the caller's memory


@dataclass(eq=False)
class ProgramObject:
    """An object of a program: a thread, a subroutine, or a block that runs in its owner's memory."""

    number: int  # counted from 1
    begin: int  # offset of its first operation, or of a subroutine's table of parameters
    local_memory: bytearray  # its variables; those of its owner for a block
    local_size: int  # bytes of them that its header asks for
    kind: ObjectKind = ObjectKind.THREAD  # thread, subcall or block
    triggers: int = 0  # number of triggers that start it; 0: it starts with its program
    parameters: tuple[ProgramParameter, ...] = ()  # as a subcall declares them
    status: int = STOPPED  # one of OBJSTAT
    ip: int = 0  # offset of the next operation
    pending: int = 0  # triggers that are still missing
    caller: ProgramObject | None = None  # the object that called it
    results: list[Result] = field(default_factory=list)  # its outputs, and their places in the caller's memory

    def reset(self) -> None:
        """Resets it to its beginning."""
        self.ip = self.begin
        self.pending = self.triggers

    def start(self) -> None:
        """Runs from its beginning."""
        self.reset()
        self.status = RUNNING


@dataclass(eq=False)
class Program:
    """A program in a slot."""

    slot: int
    code: bytearray  # what offsets in it count from: for a direct command its operations, else the whole image
    end: int  # offset after the code
    global_memory: bytearray  # its global variables
    global_size: int  # bytes of them that its header asks for
    objects: dict[int, ProgramObject]  # by number, counted from 1
    started: int = 0  # of the machine's clock, in microseconds
    ended: int | None = None  # the same; None while it runs
    status: int = RUNNING  # one of OBJSTAT
    result: int = BUSY  # one of RESULT
    folder: str = ""  # where names without a folder are looked up, with its closing slash; empty: the current folder
    handles: HandleTable = field(default_factory=HandleTable)  # arrays and files that it holds
    executed: int = 0  # operations so far
    current: ProgramObject | None = None  # the object whose turn was last
    unfinished: int = 0  # operations that are left of its turn, if that took too long
    waits_for: str = ""  # what the operation that waited last waits for in vain, in words
    due: int = 0  # operations of all turns of a tick that are left, if they took too long
    _labels: dict[int, int] | None = None

    def label(self, number: int) -> int | None:
        """Returns the offset of the last opLABEL with a number; None for an unknown number."""
        if self._labels is None:
            self._labels = self._find_labels()
        return self._labels.get(number)

    def _find_labels(self) -> dict[int, int]:
        """Returns all opLABELs, found in the way in which the firmware validates code."""
        found: dict[int, int] = {}
        step = validator("official").step
        starts = sorted({entry.begin for entry in self.objects.values()})
        for begin, stop in zip(starts, [*starts[1:], self.end], strict=True):
            code = bytes(self.code[begin:stop])
            if _LABEL not in code:
                continue
            data = code + _AFTER_CODE
            at: int | Refusal = 0
            while isinstance(at, int) and at < len(code) and code[at] != _OBJECT_END:
                # The number is a short constant, 0 to 31: of other constants, the validator accepts only long ones.
                if code[at] == _LABEL and at + 1 < len(code):
                    found[label_number(code, at + 1)] = begin + at
                at = step(data, at, len(code))
        return found

    def next_object(self) -> ProgramObject | None:
        """Returns the next object that runs, after the current one in the order of their numbers."""
        running = [entry for entry in self.objects.values() if entry.status == RUNNING]
        if not running:
            return None
        last = self.current.number if self.current is not None else 0
        return next((entry for entry in running if entry.number > last), running[0])


def label_number(code: bytes, at: int) -> int:
    """Returns the number of an opLABEL, whose argument starts at an offset: a short constant or one of a byte."""
    first = code[at]
    return first if first < 32 else code[at + 1] if at + 1 < len(code) else 0
