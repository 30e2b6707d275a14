"""A program in a slot of the machine: its code, objects, memory, resources and status."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from ev3proto.brick.handles import HandleTable
from ev3proto.brick.places import Place
from ev3proto.checking.verdict import operation_offsets
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


class Result(NamedTuple):
    """An output of a subroutine.

    parameter  as the subroutine declares it
    own        its place in the subroutine's memory
    place      its place in the caller's memory
    """

    parameter: ProgramParameter
    own: Place
    place: Place


@dataclass(eq=False)
class ProgramObject:
    """An object of a program: a thread, a subroutine, or a block that runs in its owner's memory.

    number        counted from 1
    begin         offset of its first operation, or of a subroutine's table of parameters
    local_memory  its variables; those of its owner for a block
    local_size    bytes of them that its header asks for
    kind          thread, subcall or block
    triggers      how many triggers start it; 0: it is started by itself
    parameters    as a subcall declares them
    status        one of OBJSTAT
    ip            offset of the next operation
    pending       triggers that are still missing
    caller        the object that called it
    results       its outputs, and their places in the caller's memory
    """

    number: int
    begin: int
    local_memory: bytearray
    local_size: int
    kind: ObjectKind = ObjectKind.THREAD
    triggers: int = 0
    parameters: tuple[ProgramParameter, ...] = ()
    status: int = STOPPED
    ip: int = 0
    pending: int = 0
    caller: ProgramObject | None = None
    results: list[Result] = field(default_factory=list)

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
    """A program in a slot.

    slot           its number
    code           what offsets in it count from: for a direct command its operations, else the whole image
    end            offset after the code
    global_memory  its global variables
    global_size    bytes of them that its header asks for
    objects        by number, counted from 1
    started        of the machine's clock, in microseconds
    ended          the same; None while it runs
    status         one of OBJSTAT
    result         one of RESULT
    folder         where names without a folder are looked up, with its closing slash; empty: the current folder
    handles        arrays and files that it holds
    executed       operations so far
    current        the object whose turn was last
    unfinished     operations that are left of its turn, if that took too long
    due            operations of all turns of a tick that are left, if they took too long
    """

    slot: int
    code: bytearray
    end: int
    global_memory: bytearray
    global_size: int
    objects: dict[int, ProgramObject]
    started: int = 0
    ended: int | None = None
    status: int = RUNNING
    result: int = BUSY
    folder: str = ""
    handles: HandleTable = field(default_factory=HandleTable)
    executed: int = 0
    current: ProgramObject | None = None
    unfinished: int = 0
    due: int = 0
    _labels: dict[int, int] | None = None

    def label(self, number: int) -> int | None:
        """Returns the offset of the last opLABEL with a number; None for an unknown number."""
        if self._labels is None:
            self._labels = self._find_labels()
        return self._labels.get(number)

    def _find_labels(self) -> dict[int, int]:
        found: dict[int, int] = {}
        starts = sorted({entry.begin for entry in self.objects.values()})
        for begin, stop in zip(starts, [*starts[1:], self.end], strict=True):
            code = bytes(self.code[begin:stop])
            for offset in operation_offsets(code):
                # The number is a short constant, 0 to 31: the validator lets no other constant pass but long ones.
                if code[offset] == _LABEL and offset + 1 < len(code):
                    found[label_number(code, offset + 1)] = begin + offset
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
