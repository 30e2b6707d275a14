"""The brick's own verdict: the firmware's checks of a frame before it runs it, rule by rule, quirks included.

The firmware checks the header of a direct command, makes its code a program with one object, and validates that.
The verdict is that of the release of 2013. It stops at the start of the operation that it is reading,
the last one if that ends too late. The rules, by the numbers in the comments:

 1  Operations follow each other and end exactly where the code ends. After it the firmware finds an
    OBJECT_END and zeros, so an operation that is cut short reads those, and ends too late.
 2  An opcode that is not in the tables is refused, and so is ERROR. OBJECT_END ends the code: nothing may follow.
 3  An operation is bad until one of its parameters passes, and never bad again: only the first one decides.
 4  A variable passes, whatever its index.
 5  A constant passes within the range of its type, which excludes the value for "not a number"; a float, and a
    value whose type depends on an array, always pass.
 6  A label counts as a constant. A form of undefined width takes no byte after the first one.
 7  The index of a variable is a multiple of 2 for 16 bits and for handles, of 4 for 32 bits and floats, or the
    operation is refused. From a count of parameters on, it is not checked.
 8  CMD is the low byte of the value read last, signed; for a variable, of its index. A CMD that the opcode's table
    lacks is accepted, and the operation ends there.
 9  A count of parameters is a constant from 0 to 127, followed by that number of parameters; otherwise none follow.
10  A count of values is the value read last (for a variable, its index), as 32 bits unsigned.
11  The number of a label is 0 to 31.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum
from functools import cache
from itertools import repeat
from typing import NamedTuple

from ev3proto.errors import DecodeError
from ev3proto.messages import Argument
from ev3proto.schema.argument import INTEGER_FORMS, Form, Reader, read_arguments
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, TYPE_AT, frame_size, read_memory
from ev3proto.schema.instructions import CMD
from ev3proto.semantics.facts import Requirement, requirement
from ev3proto.tables import operations, with_effect
from ev3proto.tables.declaration import Declaration, Effect, Type
from ev3proto.tables.encoding import CONSTANT, COUNTS, GLOBAL, Encoding
from ev3proto.tables.frame import GRANTED_GLOBALS, MAX_FRAME, TYPES_BY_KIND
from ev3proto.tables.validation import CMD_TABLES, SPINNING, TABLE_SIZE


class Reason(Enum):
    """The reason for a refusal."""

    NO_COMMAND = "no command"
    INCOMPLETE = "incomplete"
    TOO_LONG = "too long"
    EMPTY = "empty"
    GLOBALS = "globals"
    OPCODE = "opcode"
    AFTER_END = "after end"
    RANGE = "range"
    ALIGNMENT = "alignment"
    LABEL = "label"
    CUT_OFF = "cut off"


class Verdict(NamedTuple):
    """The brick's verdict on a frame."""

    accepted: bool  # whether the brick runs it
    # offset where it stops: the operation, or the field of the header; None if it accepts
    rejected_at: int | None = None
    reason: Reason | None = None  # why it refuses; None if it accepts
    blamed: int | None = None  # offset of the exact cause, such as the argument; else rejected_at
    spins: bool = False  # whether it hangs reading values before it refuses


ACCEPTED = Verdict(True)


_OF_GLOBAL = 0x20
"""The bit that marks the short form of a global variable, which the validator takes for a part of the index."""

OBJECT_END = with_effect(Effect.ENDS_CODE).opcode.number
"""The opcode that ends the code."""

# Rule 1. At least as many zeros as an operation reads after the parameter that reaches beyond the end.
_AFTER_FRAME = bytes((OBJECT_END,)) + bytes(160)

# Rule 6: an undefined form takes no more bytes, and is accepted.
_UNDEFINED: Form = (Encoding("", CONSTANT, 0), lambda _data, _at: (0,), 1)
_FORMS = tuple(form or _UNDEFINED for form in INTEGER_FORMS)

_CMD = ((CMD.parameter, _FORMS),)
_OF_CMD = (requirement(CMD.parameter),)


class _Expected(NamedTuple):
    """The validator's expectations after an opcode or a CMD."""

    readers: tuple[Reader, ...] = ()  # read the parameters before the elements of a list
    requirements: tuple[Requirement, ...] = ()  # the requirements on each of them
    has_tail: bool = False  # whether the last of them counts the elements of a list


class Validator:
    """The tables of one dialect's validator."""

    def __init__(self, dialect: str, is_latest: bool = False) -> None:
        knows_newer = is_latest or dialect != "official"
        self.opcodes: list[_Expected | None] = [None] * 256
        self.families: list[Sequence[_Expected] | None] = [None] * 256
        known = operations(dialect)
        for declaration in known.values():
            if declaration.command is None and Effect.NEVER_RUNS not in declaration.effects:
                self.opcodes[declaration.opcode.number] = _expected(declaration)
        tables = _cmd_tables([entry for entry in known.values() if knows_newer or not entry.is_newer])
        for declaration in known.values():
            if declaration.command is not None:
                self.families[declaration.opcode.number] = tables[declaration.opcode.validator_table]

    def scan(self, frame: bytes, at: int, end: int, starts: list[int] | None = None) -> Verdict:
        """Returns the verdict on the code in `frame[at:end]`; adds the operations' offsets to `starts`."""
        data = frame[:end] + _AFTER_FRAME
        while at < end:
            start = at
            if starts is not None:
                starts.append(start)
            if data[start] == OBJECT_END:
                # Rule 2.
                return ACCEPTED if start + 1 == end else Verdict(False, start, Reason.AFTER_END, start + 1)
            found = self.step(data, start, end)
            if isinstance(found, Refusal):
                return Verdict(False, start, found.reason, found.blamed, found.spins)
            at = found
            if at > end:
                # Rule 1.
                return Verdict(False, start, Reason.CUT_OFF, end)
        return ACCEPTED

    def step(self, data: bytes, at: int, end: int) -> int | Refusal:
        """Returns the offset after the operation at `at`, maybe beyond `end`, or why it is refused."""
        found: list[Argument] = []
        expected = self.opcodes[data[at]]
        after = at + 1
        required: tuple[Requirement, ...] = ()
        if expected is None:
            commands = self.families[data[at]]
            if commands is None:
                # Rule 2.
                return Refusal(Reason.OPCODE, at)
            # Rule 8: CMD is a parameter of 8 bits, whose value selects the rest.
            after = read_arguments(_CMD, data, after, len(data), found)
            expected, required = commands[_number(found[0]) & 0xFF], _OF_CMD
        after = read_arguments(expected.readers, data, after, len(data), found)
        for argument, check in zip(found, required + expected.requirements, strict=True):
            refused = _refused(argument, check, is_first=argument is found[0])
            if refused is not None:
                return Refusal(refused, argument.offset)
        return _after_list(data, after, end, found[-1]) if expected.has_tail else after


class Refusal(NamedTuple):
    """Why an operation is refused, the offset of the cause, and whether the brick hangs before it refuses."""

    reason: Reason
    blamed: int
    spins: bool = False


def _refused(argument: Argument, check: Requirement, *, is_first: bool) -> Reason | None:
    """Returns why an argument is refused."""
    number = _number(argument)
    if argument.is_variable:
        # Rules 4 and 7.
        is_refused = number % (check.handle_alignment if argument.form.handle else check.alignment)
        return Reason.ALIGNMENT if is_refused else None
    # Rules 3, 5 and 11.
    is_label = check.kind is Type.LABEL
    if (is_label or is_first) and check.numbers and number not in check.numbers:
        return Reason.LABEL if is_label else Reason.RANGE
    return None


def _after_list(data: bytes, at: int, end: int, counter: Argument) -> int | Refusal:
    """Returns the offset after the elements of a list, which are not checked; beyond `end` if they do not fit."""
    count = _number(counter)
    if not counter.parameter.counts:
        # Rule 10. Each value takes at least one byte: more values than bytes cannot fit.
        count &= 0xFFFFFFFF
        if count > end - at:
            return Refusal(Reason.CUT_OFF, counter.offset, count >= SPINNING)
    elif counter.is_variable or not 0 <= count <= COUNTS.high:
        # Rule 9. A bad count leaves the operation valid (rule 3), without elements.
        return at
    try:
        return read_arguments(repeat(_CMD[0], count), data, at, end, [])
    except DecodeError:
        # Rule 1. The rest has no relevant end.
        return end + 1


def _number(argument: Argument) -> int:
    """Returns the value of an argument for the validator: 0 for a text."""
    value = argument.value
    if not isinstance(value, int):
        return 0
    return value | _OF_GLOBAL if argument.form.kind == GLOBAL and argument.form.width == 0 else value


def _expected(declaration: Declaration) -> _Expected:
    fixed = declaration.fixed
    readers = tuple((parameter, _FORMS) for parameter in fixed)
    return _Expected(readers, tuple(map(requirement, fixed)), declaration.tail is not None)


def _cmd_tables(known: Sequence[Declaration]) -> dict[str, Sequence[_Expected]]:
    """Returns, by name of a table of CMDs, what follows each CMD; nothing for unknown CMDs."""
    commands = [entry for entry in known if entry.command is not None]
    names = dict.fromkeys((*CMD_TABLES, *(entry.opcode.validator_table for entry in commands)))
    row: list[_Expected] = []
    for name in names:
        found = [_Expected()] * TABLE_SIZE
        for entry in commands:
            if entry.opcode.validator_table == name and entry.command is not None:
                found[entry.command.number] = _expected(entry)
        row += found
    # Rule 8. The firmware does not expect a negative CMD: it reads before its table, which is in the previous table.
    tables: dict[str, Sequence[_Expected]] = {}
    for name, start in zip(names, range(0, len(row), TABLE_SIZE), strict=True):
        own = row[start : start + TABLE_SIZE]
        negative = [row[start + number] if start + number >= 0 else _Expected() for number in range(-128, 0)]
        tables[name] = (*own, *[_Expected()] * (128 - TABLE_SIZE), *negative)
    return tables


@cache
def validator(dialect: str, is_latest: bool = False) -> Validator:
    """Returns the validator of a dialect, created once. The latest firmware's knows the commands of all releases."""
    return Validator(dialect, is_latest)


_DIRECT = frozenset(map(int, TYPES_BY_KIND["direct-command"]))


def verdict(frame: bytes, dialect: str = "official") -> Verdict:
    """Returns the brick's verdict on the frame of a direct command. No content of a frame makes it raise.

    A frame with more bytes than its length field says is validated up to that length, as in the firmware. One with
    fewer bytes is refused where those bytes are refused, or else where they end: the brick waits for more.

    Args:
        frame: The bytes from the length field to the last one.
        dialect: The firmware whose instruction set is used; the rules are those of LEGO's.

    Returns:
        Whether it runs the command, and if not, where it stops.

    Raises:
        ValueError: The dialect is unknown.
    """
    size = len(frame)
    if size < HEADER_SIZE or frame[TYPE_AT] not in _DIRECT:
        return Verdict(False, min(size, TYPE_AT), Reason.NO_COMMAND, min(size, TYPE_AT))
    stated = frame_size(frame)
    if stated > MAX_FRAME:
        return Verdict(False, 0, Reason.TOO_LONG, 0)
    if stated <= COMMAND_HEADER_SIZE:
        at = min(size, COMMAND_HEADER_SIZE)
        return Verdict(False, at, Reason.EMPTY, at)
    if size >= COMMAND_HEADER_SIZE:
        global_size, _ = read_memory(frame)
        if global_size > GRANTED_GLOBALS:
            return Verdict(False, HEADER_SIZE, Reason.GLOBALS, HEADER_SIZE)
        found = validator(dialect).scan(frame, COMMAND_HEADER_SIZE, min(size, stated))
        if not found.accepted or size >= stated:
            return found
    return Verdict(False, size, Reason.INCOMPLETE, size)
