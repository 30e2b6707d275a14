"""The brick's own verdict: what the firmware does with a frame before it runs it, rule by rule, quirks included.

The firmware looks at the header of a direct command, makes a program with one object of its code, and validates that.
What is decided here is what the release of 2013 decides; where it gives up is the start of the operation that it reads
then, the last one where that ends too late. The rules, whose numbers stand in the comments:

 1  Operations stand one after the other and end exactly where the code ends. After it the firmware finds an
    OBJECT_END and zeros, so an operation that is cut short swallows those, and ends too late.
 2  An opcode that the tables do not have is refused, and so is ERROR. OBJECT_END ends the code: nothing may follow.
 3  An operation is bad until one of its parameters passes, and never bad again: only the first one decides.
 4  A variable passes, whatever its index.
 5  A constant passes within the range of its type, which excludes the value that means "not a number"; a float, and a
    value whose type depends on an array, always pass.
 6  A label counts as a constant. A form whose width is not defined takes no byte after the first one.
 7  The index of a variable is a multiple of 2 for 16 bits and for handles, of 4 for 32 bits and floats, or the
    operation is refused. From a count of parameters on, nobody looks at it.
 8  CMD is the low byte of the value read last, with its sign; of a variable, of its index. One that the opcode's table
    does not have is accepted, and the operation ends there.
 9  A count of parameters is a constant from 0 to 127, and so many parameters follow; or else none do.
10  A count of values is the value read last, of a variable its index, as 32 bits without sign.
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
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, frame_size, read_memory
from ev3proto.schema.instructions import CMD
from ev3proto.tables import operations, with_effect
from ev3proto.tables.declaration import LISTS, Declaration, Effect, Parameter, Role, Type
from ev3proto.tables.encoding import CONSTANT, GLOBAL, RANGES, Encoding
from ev3proto.tables.frame import GRANTED_GLOBALS, MAX_FRAME, MessageType
from ev3proto.tables.validation import CMD_TABLES, LABELS, SPINNING, TABLE_SIZE


class Reason(Enum):
    """Why a frame is refused."""

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
    """What the brick says to a frame.

    accepted     whether it runs it
    rejected_at  offset of what it stops at: the operation, of the header the field; None where it accepts
    reason       why it refuses; None where it accepts
    blamed       offset of the very bytes that are the reason, such as the argument; rejected_at where there is no other
    spins        it reads values for so long that it seems dead, before it refuses
    """

    accepted: bool
    rejected_at: int | None = None
    reason: Reason | None = None
    blamed: int | None = None
    spins: bool = False


ACCEPTED = Verdict(True)


class _Check(NamedTuple):
    """What the validator wants of a parameter.

    numbers      what a constant may be (rules 5 and 11), None for anything
    mask         bits that must not be set in the index of a variable (rule 7)
    handle_mask  the same where the variable holds a handle
    """

    numbers: range | None = None
    mask: int = 0
    handle_mask: int = 1


def _numbers(kind: Type) -> range:
    return range(RANGES[kind].low, RANGES[kind].high + 1)


_8_BITS, _16_BITS = _Check(_numbers(Type.DATA8)), _Check(_numbers(Type.DATA16), mask=1)
_LABEL = _Check(range(LABELS))
_CHECKS = {
    Type.DATA8: _8_BITS,
    Type.STRING: _8_BITS,
    Type.DATA16: _16_BITS,
    Type.HANDLE: _16_BITS,
    Type.DATA32: _Check(_numbers(Type.DATA32), mask=3),
    Type.DATAF: _Check(mask=3),
    Type.ARRAY_TYPED: _Check(),
    Type.COUNT: _Check(handle_mask=0),
    Type.LABEL: _LABEL,
}

_OF_GLOBAL = 0x20
"""The bit of the short form of a global variable that says so, which the validator takes for a part of the index."""

OBJECT_END = with_effect(Effect.ENDS_CODE).opcode.number
"""The opcode that ends a code."""

# Rule 1. More zeros than an operation reads after the parameter that reaches beyond the end.
_BEYOND = bytes((OBJECT_END,)) + bytes(160)

# Rule 6: a form that is not defined takes no more bytes, and is no reason to refuse anything.
_UNDEFINED: Form = (Encoding("", CONSTANT, 0), lambda _data, _at: (0,), 1)
_FORMS = tuple(form or _UNDEFINED for form in INTEGER_FORMS)

_CMD = ((CMD.parameter, _FORMS),)


class _Expected(NamedTuple):
    """What the validator expects after an opcode or a CMD.

    readers  read the parameters before the elements of a list
    checks   what is wanted of each of them
    listed   COUNT or VALUES where a list ends it
    """

    readers: tuple[Reader, ...] = ()
    checks: tuple[_Check, ...] = ()
    listed: Type | None = None


class Validator:
    """The tables of one dialect's validator."""

    def __init__(self, dialect: str, is_latest: bool = False) -> None:
        knows_newer = is_latest or dialect != "official"
        self.opcodes: list[_Expected | None] = [None] * 256
        self.families: list[Sequence[_Expected] | None] = [None] * 256
        known = operations(dialect)
        for declaration in known.values():
            if declaration.command is None and Effect.NEVER_RUNS not in declaration.effects:
                self.opcodes[declaration.opcode.number] = _expected(declaration.parameters)
        tables = _cmd_tables([entry for entry in known.values() if knows_newer or not entry.is_newer])
        for declaration in known.values():
            if declaration.command is not None:
                self.families[declaration.opcode.number] = tables[declaration.opcode.validator_table]

    def scan(self, frame: bytes, at: int, end: int, starts: list[int] | None = None) -> Verdict:
        """The verdict on the code in `frame[at:end]`.

        Args:
            frame: The frame.
            at: The offset of the first opcode.
            end: Where the code ends.
            starts: A list that gets the offset of every operation.
        """
        data = frame[:end] + _BEYOND
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
        """The offset after the operation at an offset, or why it is refused.

        Args:
            data: The frame or the image, and zeros after it.
            at: The offset of the opcode.
            end: Where the code ends; the operation may end further on.
        """
        found: list[Argument] = []
        expected = self.opcodes[data[at]]
        after = at + 1
        if expected is None:
            commands = self.families[data[at]]
            if commands is None:
                # Rule 2.
                return Refusal(Reason.OPCODE, at)
            # Rule 8: CMD is a parameter of 8 bits, whose value chooses those that follow.
            after = read_arguments(_CMD, data, after, len(data), found)
            expected = commands[_number(found[0]) & 0xFF]
        after = read_arguments(expected.readers, data, after, len(data), found)
        checks = (_8_BITS, *expected.checks) if len(found) > len(expected.checks) else expected.checks
        for argument, check in zip(found, checks, strict=True):
            if argument.is_variable:
                # Rules 4 and 7.
                if _number(argument) & (check.handle_mask if argument.form.handle else check.mask):
                    return Refusal(Reason.ALIGNMENT, argument.offset)
            elif (argument is found[0] or check is _LABEL) and check.numbers and _number(argument) not in check.numbers:
                # Rules 3, 5 and 11.
                return Refusal(Reason.LABEL if check is _LABEL else Reason.RANGE, argument.offset)
        return after if expected.listed is None else _after_list(data, after, end, expected.listed, found[-1])


class Refusal(NamedTuple):
    """Why an operation is refused, the offset of what is to blame, and whether the brick spins before it says so."""

    reason: Reason
    blamed: int
    spins: bool = False


def _after_list(data: bytes, at: int, end: int, kind: Type, counter: Argument) -> int | Refusal:
    """The offset after the elements of a list, which nobody looks at; an offset beyond `end` where they reach there."""
    count = _number(counter)
    if kind is Type.VALUES:
        # Rule 10. Each value takes a byte at least: more of them than there are bytes end beyond the code.
        count &= 0xFFFFFFFF
        if count > end - at:
            return Refusal(Reason.CUT_OFF, counter.offset, count >= SPINNING)
    elif counter.is_variable or not 0 <= count <= RANGES[Type.COUNT].high:
        # Rule 9. What does not pass leaves the operation good all the same (rule 3), and empty.
        return at
    try:
        return read_arguments(repeat(_CMD[0], count), data, at, end, [])
    except DecodeError:
        # Rule 1. What follows has no end that would matter.
        return end + 1


def _number(argument: Argument) -> int:
    """The value of an argument as the validator takes it: 0 of a text."""
    value = argument.value
    if not isinstance(value, int):
        return 0
    return value | _OF_GLOBAL if argument.form.kind == GLOBAL and argument.form.width == 0 else value


def _expected(parameters: Sequence[Parameter]) -> _Expected:
    listed = parameters[-1].type if parameters and parameters[-1].type in LISTS else None
    fixed = parameters[:-1] if listed is Type.VALUES else parameters
    return _Expected(tuple((parameter, _FORMS) for parameter in fixed), tuple(map(_check, fixed)), listed)


def _check(parameter: Parameter) -> _Check:
    # How far to jump is a number; only LABEL has a label.
    return _CHECKS[Type.DATA32 if parameter.role is Role.JUMP else parameter.validated or parameter.type]


def _cmd_tables(known: Sequence[Declaration]) -> dict[str, Sequence[_Expected]]:
    """For each table of CMDs by its name, what follows a CMD by the byte that is its number; nothing for unknown ones.

    Args:
        known: The operations that the validator knows.
    """
    commands = [(entry.opcode.validator_table, entry.command, entry.parameters) for entry in known]
    names = dict.fromkeys((*CMD_TABLES, *(name for name, command, _ in commands if command is not None)))
    row: list[_Expected] = []
    for name in names:
        found = [_Expected()] * TABLE_SIZE
        for table, command, parameters in commands:
            if table == name and command is not None:
                found[command.number] = _expected(parameters)
        row += found
    # Rule 8. The firmware does not expect a negative CMD: it looks before its table, which is in the table before it.
    tables: dict[str, Sequence[_Expected]] = {}
    for name, start in zip(names, range(0, len(row), TABLE_SIZE), strict=True):
        own = row[start : start + TABLE_SIZE]
        negative = [row[start + number] if start + number >= 0 else _Expected() for number in range(-128, 0)]
        tables[name] = (*own, *[_Expected()] * (128 - TABLE_SIZE), *negative)
    return tables


@cache
def validator(dialect: str, is_latest: bool = False) -> Validator:
    """The validator of a dialect, made once. That of the latest firmware knows the commands of all."""
    return Validator(dialect, is_latest)


_DIRECT = {member.value for member in MessageType if member.kind == "direct-command"}


def operation_offsets(code: bytes, dialect: str = "official") -> list[int]:
    """Where the validator sees an operation begin in byte code, up to the one that it refuses, if it refuses one.

    Args:
        code: Operations without the header of a frame, to which the offsets refer.
        dialect: "official", "xtended" or "compat": the firmware whose validator it is.
    """
    starts: list[int] = []
    validator(dialect).scan(code, 0, len(code), starts)
    return starts


def verdict(frame: bytes, dialect: str = "official") -> Verdict:
    """What the brick says to the frame of a direct command. Never raises for what is in a frame.

    A frame with more bytes than its length field says is validated as far as that goes, as the firmware does. One with
    fewer bytes than that is refused where what is there is refused, or else where it ends: the brick waits for more.

    Args:
        frame: From its length field to its last byte.
        dialect: The firmware whose instruction set to go by; the rules are those of LEGO's.

    Returns:
        Whether it runs the command, and where it stops if not.

    Raises:
        ValueError: The dialect is unknown.
    """
    size = len(frame)
    if size < HEADER_SIZE or frame[HEADER_SIZE - 1] not in _DIRECT:
        return Verdict(False, min(size, HEADER_SIZE - 1), Reason.NO_COMMAND, min(size, HEADER_SIZE - 1))
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
