"""The machine that executes byte code: it reads parameters, finds the handlers and gives every object its turns.

As in the firmware, parameters are read while the operation is executed: a variable only has to be within the existing
memory, an array can be given for its first element, a number is cut to the parameter's type.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable
from contextlib import suppress

from ev3proto.brick.conversions import wrap8, wrap16
from ev3proto.brick.equipment import Equipment
from ev3proto.brick.exits import Busy, Failure, Leave, NoOperation, Pause, Sleep, WildAccess
from ev3proto.brick.handlers import Dispatch, Family
from ev3proto.brick.handles import Array
from ev3proto.brick.images import Image, Images, load
from ev3proto.brick.limits import QUICK_OPERATIONS, thread_time
from ev3proto.brick.locations import Location
from ev3proto.brick.open_files import OpenFile
from ev3proto.brick.running_programs import (
    CMD_SLOT,
    CURRENT_SLOT,
    FAIL,
    OK,
    RUNNING,
    SLOTS,
    STOPPED,
    Program,
    ProgramObject,
)
from ev3proto.schema.argument import INTEGER_FORMS
from ev3proto.tables.declaration import Type
from ev3proto.tables.encoding import CONSTANT, ENCODINGS, GLOBAL, JUMP, LOCAL, SHORT, SIZES, STRINGS, TEXT, Encoding
from ev3proto.tables.memory import ARRAY_ROOM
from ev3proto.tables.validation import LABELS

_SHORT_CONSTANT, _SHORT_LOCAL, _SHORT_GLOBAL, _LONG_CONSTANT, _OTHER = range(5)

_Form = tuple[int, int, Callable[[bytes | bytearray, int], tuple[int]] | None, int]


_MEANINGS: tuple[tuple[Encoding | None, int | None], ...] = (
    *SHORT,
    *((each, None) for each in ENCODINGS[len(SHORT) :]),
)
"""The encoding of each identification byte, and the value of a short form."""


def _form(byte: int) -> _Form:
    """Returns of an identification byte: kind, value of a short form, unpacking of a long constant, size."""
    encoding, value = _MEANINGS[byte]
    if encoding is not None and value is not None:
        return {CONSTANT: _SHORT_CONSTANT, LOCAL: _SHORT_LOCAL, GLOBAL: _SHORT_GLOBAL}[encoding.kind], value, None, 1
    form = INTEGER_FORMS[byte]
    if form is None or form[0].kind != CONSTANT or form[0].handle or form[0].address:
        return _OTHER, 0, None, 0
    _, unpack, size = form
    return _LONG_CONSTANT, 0, unpack, size


_FORMS = tuple(map(_form, range(len(_MEANINGS))))

_SCRATCH = 4096
"""Size in bytes of the buffer that every constant is written to while it is read as memory.

Zeros follow it. What an operation writes to a constant is lost with the next one.
"""


def _integer(
    read: Callable[[Location], int], layout: struct.Struct, wrap: Callable[[int], int]
) -> Callable[[Machine], int]:
    """Reads a parameter of an integer type: short forms and constants directly, all others by their place.

    That makes programs (`ev3proto run`, `brick`) 2.6 times as fast as places alone.
    """
    from_memory = layout.unpack_from

    def integer(vm: Machine) -> int:
        kind, value, unpack, size = _FORMS[vm.code[vm.ip]]
        if kind == _OTHER:
            return read(vm.place())
        if unpack is not None:
            number = unpack(vm.code, vm.ip)[0]
            vm.ip += size
            return wrap(number)
        vm.ip += 1
        if kind == _SHORT_CONSTANT:
            return value
        found: int = from_memory(vm.global_memory if kind == _SHORT_GLOBAL else vm.local_memory, value)[0]
        return found

    return integer


class Machine:
    """The machine with its five slots."""

    program: Program  # the running program
    object: ProgramObject  # its running object

    def __init__(self, brick: Equipment, dispatch: Dispatch) -> None:
        self.brick = brick  # the brick that it belongs to
        self.slots: list[Program | None] = [None] * SLOTS  # the programs, by slot; None for an unused slot
        self.code = bytearray()
        self.ip = 0  # offset of the next byte to read
        self.global_memory = bytearray()
        self.local_memory = bytearray()
        self.images = Images()  # program images in memory
        self._scratch = bytearray(_SCRATCH)
        self._deadline = math.inf  # of the turn
        self._left = 0  # operations of the turn that are not executed
        self._dispatch = dispatch

    # The clock

    @property
    def microseconds(self) -> int:
        """Since the brick was switched on."""
        return self.brick.microseconds

    @property
    def milliseconds(self) -> int:
        """Since the brick was switched on."""
        return self.brick.microseconds // 1000

    # Turns

    def turn(self, program: Program, most: int, deadline: float = math.inf) -> tuple[int, bool]:
        """Gives the next object of a program its turn, or continues one that the deadline interrupted.

        Returns how many operations were executed, and whether the object waits for something.
        """
        entry = program.current
        if entry is None or not program.unfinished or entry.status != RUNNING:
            entry = program.next_object()
            program.unfinished = most
        if entry is None:
            self.end_program(program, OK)
            return 0, False
        program.current = entry
        most, program.unfinished = program.unfinished, 0
        self.program, self.object = program, entry
        self.code, self.ip = program.code, entry.ip
        self.global_memory, self.local_memory = program.global_memory, entry.local_memory
        self._left, self._deadline = most, deadline
        is_waiting = False
        try:
            self._execute(entry)
        except Pause:
            program.unfinished = max(self._left, 1)
        except Busy as busy:
            program.waits_for = "".join(busy.args)
            is_waiting = True
        except (Sleep, Leave):
            pass
        except (Failure, IndexError, ValueError, struct.error, OSError) as failure:
            # Reading code beyond its end raises IndexError, a text in it without an end ValueError, a short
            # variable beyond the memory a struct.error, a full disk an OSError.
            self._fail(program, failure)
        except Exception:
            # A defect, which would occur again at each turn.
            self.end_program(program, FAIL)
            raise
        executed = most - self._left
        program.executed += executed
        return executed, is_waiting

    def _execute(self, entry: ProgramObject) -> None:
        """Executes the operations that are left of a turn; raises Pause at its deadline."""
        left, deadline = self._left, self._deadline
        look = left - QUICK_OPERATIONS  # where the clock is looked at next
        code, dispatch = self.code, self._dispatch
        begin = self.ip
        try:
            while left > 0:
                if left == look:
                    look = left - QUICK_OPERATIONS
                    if thread_time() > deadline:
                        raise Pause
                left -= 1
                begin = self.ip
                found = dispatch[code[begin]]
                self.ip = begin + 1
                if isinstance(found, Family):
                    found = found.entries.get(self.int8(), found.unknown)
                function, readers, is_quick = found
                if not is_quick:
                    look = left
                if readers is None:
                    function(self)
                else:
                    function(self, *[read(self) for read in readers])
            entry.ip = self.ip
        except (Sleep, Pause):
            entry.ip = self.ip
            raise
        except Busy:
            entry.ip = begin
            raise
        finally:
            self._left = left

    def _fail(self, program: Program, failure: Exception) -> None:
        """Ends a program, and logs why; commands are not logged."""
        if program.slot != CMD_SLOT:
            reason = "INSTRUCTION" if isinstance(failure, NoOperation) else "FAIL"
            self.brick.settings.log_error(f"VM_PROGRAM_{reason}_BREAK")
        self.end_program(program, FAIL)

    def start_program(self, slot: int, image: Image) -> bool:
        """Makes a program of an image and starts it in a slot. Returns False and logs an error if it is damaged."""
        program = load(slot, image, self.microseconds, self.brick.dialect)
        if program is None:
            self.brick.settings.log_error("VM_PROGRAM_VALIDATION")
            return False
        self.slots[slot] = program
        self.brick.program_started(program)
        return True

    def end_program(self, program: Program, result: int) -> None:
        """Stops a program and frees what it holds."""
        if program.status == STOPPED:
            return
        program.status = STOPPED
        program.result = result
        program.ended = self.microseconds
        for entry in program.objects.values():
            entry.status = STOPPED
        for handle, _ in program.handles.items():
            self.release(program, handle)
        self.brick.program_ended(program)

    def jump(self, distance: int) -> None:
        """Jumps relative to the byte after the last one read. WildAccess beyond the code."""
        target = self.ip + distance
        if not 0 <= target <= self.program.end:
            raise WildAccess
        self.ip = target

    # Parameters

    int8 = _integer(Location.read8, struct.Struct("<b"), wrap8)
    int16 = _integer(Location.read16, struct.Struct("<h"), wrap16)
    int32 = _integer(Location.read32, struct.Struct("<i"), lambda number: number)

    def float32(self) -> float:
        """Reads a parameter of type DATAF."""
        return self.place().read_float()

    def float_bits(self) -> int:
        """Reads the four bytes of a parameter of type DATAF, as a number without sign."""
        return self.place().read_bits()

    def text(self) -> bytes:
        """Reads a parameter that is a text, without its zero."""
        return self.place().read_text()

    def places(self) -> list[Location]:
        """Reads a count and that number of parameters; none for a negative count."""
        return [self.place() for _ in range(self.int8())]

    def skip(self) -> None:
        """Skips a parameter."""
        first = self.code[self.ip]
        self.ip = self.code.index(0, self.ip + 1) + 1 if first in STRINGS else self.ip + (SIZES[first] or 1)

    def place(self) -> Location:
        """Reads a parameter of any type, and returns the place of its value.

        All constant numbers share one place, so each is lost when the next one is read, as in the firmware.
        """
        code, ip = self.code, self.ip
        first = code[ip]
        encoding, number = _MEANINGS[first]
        self.ip = ip + 1
        if encoding is None:
            # An undefined width takes no byte; the value in the firmware is arbitrary.
            return self._constant(0)
        kind = encoding.kind
        if kind == TEXT:
            place = Location(code, ip + 1)
            self.ip = code.index(0, ip + 1) + 1
        else:
            if number is None:
                self.ip = ip + 1 + (encoding.width or 0)
                if self.ip > len(code):
                    raise WildAccess
                number = int.from_bytes(code[ip + 1 : self.ip], "little", signed=kind not in (LOCAL, GLOBAL))
            if kind == GLOBAL:
                place = Location(self.global_memory, number)
            elif kind == LOCAL:
                place = Location(self.local_memory, number)
            else:
                place = self._constant(self._label(number) if kind == JUMP else number)
        if encoding.handle:
            return self._element(place)
        if encoding.address:
            # Addresses of the real brick's memory do not exist here.
            raise WildAccess
        return place

    def _constant(self, value: int) -> Location:
        self._scratch[:8] = (value & 0xFFFFFFFF).to_bytes(8, "little")
        return Location(self._scratch, 0)

    def _element(self, place: Location) -> Location:
        """Returns the first element of the array with the handle at a place; the place itself for an unknown handle."""
        handle = place.read16()
        array = self.program.handles.get(handle, Array)
        return Location(place.buffer, place.at, handle) if array is None else Location(array.data, 0, handle)

    def _label(self, number: int) -> int:
        """Returns the distance to a label; any other number is itself. Raises WildAccess if the label is not set."""
        if not 0 < number < LABELS:
            return number
        offset = self.program.label(number)
        if offset is None:
            raise WildAccess
        return offset - self.ip

    # Slots and handles

    def program_in(self, slot: int) -> Program | None:
        """Returns the program that runs in a slot or ran there last; None if there was none."""
        if slot == CURRENT_SLOT:
            return self.program
        return self.slots[slot] if 0 <= slot < SLOTS else None

    def release(self, program: Program, handle: int) -> bool:
        """Frees a handle of a program, and closes its file. Returns whether the handle was in use."""
        entry = program.handles.remove(handle)
        if isinstance(entry, OpenFile):
            with suppress(OSError):
                entry.stream.close()
        return entry is not None

    # Results

    def write_text(self, destination: Location, text: bytes, room: int | None = None) -> None:
        """Writes a text and its zero; an array named by its handle is resized, to `room` elements or as needed."""
        if self.resize(destination, len(text) + 1 if room is None else room):
            destination.write_text(text)

    def write_limited(self, destination: Location, text: bytes, length: int) -> None:
        """Writes a text cut to `length` with its zero: 0 writes nothing, a negative length does not cut.

        An array gets `length` elements, or fewer where the text needs fewer, or as many as the text needs for -1.
        """
        needed = len(text) + 1
        if destination.handle >= 0:
            if length > needed or length == -1:
                length = needed
            if not self.resize(destination, length):
                return
        if length > 0:
            destination.write_text(text[: length - 1])
        elif length < 0:
            destination.write_text(text)

    def resize(self, destination: Location, elements: int) -> bool:
        """Resizes the array that a parameter named by its handle; does nothing for other places.

        Returns whether there is a place to write to.
        """
        if destination.handle < 0:
            return True
        array = self.program.handles.get(destination.handle, Array)
        return array is not None and self.resize_array(array, elements)

    def resize_array(self, array: Array, elements: int) -> bool:
        """Resizes an array; new elements are zero. Returns False if there is no memory left."""
        size = elements * array.type.size
        if size < 0 or not self.has_room(size - len(array.data)):
            return False
        if size < len(array.data):
            del array.data[size:]
        else:
            array.data.extend(bytes(size - len(array.data)))
        return True

    def create_array(self, type: Type, elements: int) -> int | None:
        """Returns a new array's handle; None if no memory or no handle is left."""
        if not self.has_room(elements * type.size):
            return None
        return self.program.handles.add(Array(type, elements))

    def has_room(self, more: int) -> bool:
        """Returns whether arrays may take this number of additional bytes."""
        held = (entry for program in self.slots if program is not None for entry in program.handles.entries())
        return more <= 0 or sum(len(entry.data) for entry in held if isinstance(entry, Array)) + more <= ARRAY_ROOM
