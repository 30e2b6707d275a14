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
from typing import NamedTuple

from ev3proto.schema.argument import INTEGER_FORMS
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, frame_size, read_memory
from ev3proto.schema.identification import ENCODINGS, SHORT_VALUES
from ev3proto.tables import operations, with_effect
from ev3proto.tables.declaration import Declaration, Effect, Parameter, Role, Type
from ev3proto.tables.encoding import HANDLE_BIT, RANGES
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

# What the validator checks a parameter as.
_DATA8, _DATA16, _DATA32, _FLOAT, _ANY, _COUNT, _LABEL, _VALUES = range(8)

_CHECKED_AS = {
    Type.DATA8: _DATA8,
    Type.STRING: _DATA8,
    Type.DATA16: _DATA16,
    Type.HANDLE: _DATA16,
    Type.DATA32: _DATA32,
    Type.LABEL: _LABEL,
    Type.DATAF: _FLOAT,
    Type.ARRAY_TYPED: _ANY,
    Type.COUNT: _COUNT,
    Type.VALUES: _VALUES,
}

_RANGES = {_DATA8: RANGES[Type.DATA8], _DATA16: RANGES[Type.DATA16], _DATA32: RANGES[Type.DATA32]}

# Rule 7, as a mask of the bits of an index that must not be set.
_MISALIGNED = [0] * 8
_MISALIGNED[_DATA16] = 1
_MISALIGNED[_DATA32] = _MISALIGNED[_FLOAT] = 3
_MISALIGNED_HANDLE = 1

_LONG, _VARIABLE = 0x80, 0x40
"""Bits of an identification byte, as the validator looks at them; `ev3proto.schema.identification` declares them."""

_SHORT_BITS = 0x3F
"""Bits of a short form that the validator takes for the value; of a global variable one of them says that it is one."""

_STRING = 0


def _sizes() -> tuple[int, ...]:
    """Bytes of an argument by its identification byte, as the validator reads it; `_STRING` for a text."""
    sizes = []
    for encoding in ENCODINGS:
        # Rule 6: a form that is not defined takes no more bytes, and is no reason to refuse anything.
        sizes.append(1 if encoding is None else _STRING if encoding.width is None else 1 + encoding.width)
    return tuple(sizes)


_SIZES = _sizes()
OBJECT_END = with_effect(Effect.ENDS_CODE).opcode.number
"""The opcode that ends a code."""

# Rule 1. More zeros than an operation reads after the parameter that reaches beyond the end.
_BEYOND = bytes((OBJECT_END,)) + bytes(160)

_Kinds = tuple[int, ...]


class Validator:
    """The tables of one dialect's validator."""

    def __init__(self, dialect: str, is_latest: bool = False) -> None:
        knows_newer = is_latest or dialect != "official"
        self.opcodes: list[_Kinds | None] = [None] * 256
        self.families: list[Sequence[_Kinds] | None] = [None] * 256
        known = operations(dialect)
        for declaration in known.values():
            if declaration.command is None and Effect.NEVER_RUNS not in declaration.effects:
                self.opcodes[declaration.opcode.number] = _kinds(declaration.parameters)
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
        kinds = self.opcodes[data[at]]
        if kinds is not None:
            return _parameters(data, at + 1, end, kinds, is_good=not kinds)
        return self._command(data, at + 1, end, data[at])

    def _command(self, data: bytes, at: int, end: int, code: int) -> int | Refusal:
        """The offset after an operation with CMD, or why it is refused.

        CMD is a parameter of 8 bits (rules 3 to 7), whose value chooses those that follow (rule 8).
        """
        commands = self.families[code]
        if commands is None:
            # Rule 2.
            return Refusal(Reason.OPCODE, at - 1)
        number, after = _value(data, at)
        first = data[at]
        if first & _LONG:
            reason = _refused(first, number, _DATA8)
            if reason is not None:
                return Refusal(reason, at)
        return _parameters(data, after, end, commands[number & 0xFF], is_good=True)


class Refusal(NamedTuple):
    """Why an operation is refused, the offset of what is to blame, and whether the brick spins before it says so."""

    reason: Reason
    blamed: int
    spins: bool = False


def _parameters(data: bytes, at: int, end: int, kinds: _Kinds, *, is_good: bool) -> int | Refusal:
    """The offset after the parameters of an operation, or why it is refused.

    Args:
        data: The frame, and zeros after it.
        at: The offset of the first parameter.
        end: Where the code ends.
        kinds: What the validator expects, parameter by parameter.
        is_good: Whether a parameter has passed already (rule 3).
    """
    before = at
    for kind in kinds:
        first = data[at]
        if kind >= _COUNT:
            found = _special(data, at, end, kind, before)
            if isinstance(found, Refusal):
                return found
            at = found
        elif first < _LONG:
            # A short constant is within every range (rule 5), a short variable passes (rule 4). The bit of a global
            # variable, which the validator takes for a part of its index, is a multiple of 4.
            if first & _VARIABLE and first & _MISALIGNED[kind]:
                return Refusal(Reason.ALIGNMENT, at)
            before = at
            at += 1
        elif is_good and not first & _VARIABLE:
            # Rule 3: nobody looks at its value.
            before = at
            at = at + _SIZES[first] if _SIZES[first] else data.index(0, at + 1) + 1
        else:
            before = at
            value, at = _long_value(data, at)
            reason = _refused(first, value, kind)
            if reason is not None:
                return Refusal(reason, before)
        is_good = True
    return at


def _special(data: bytes, at: int, end: int, kind: int, before: int) -> int | Refusal:
    """The same for a label, a count of parameters, a list of values.

    Args:
        data: The frame, and zeros after it.
        at: The offset of the parameter.
        end: Where the code ends.
        kind: What the validator expects.
        before: The offset of the parameter before it.
    """
    first = data[at]
    if kind == _VALUES:
        # Rule 10. Each value takes a byte at least: more of them than there are bytes end beyond the code.
        count = _value(data, before)[0] & 0xFFFFFFFF
        return Refusal(Reason.CUT_OFF, before, count >= SPINNING) if count > end - at else _skip(data, at, end, count)
    value, after = _value(data, at)
    if kind == _COUNT:
        # Rule 9. What does not pass leaves the operation good all the same (rule 3), and empty.
        is_count = not first & _VARIABLE and 0 <= value <= RANGES[Type.COUNT].high
        return _skip(data, after, end, value) if is_count else after
    if not first & _VARIABLE:
        # Rule 11.
        return after if 0 <= value < LABELS else Refusal(Reason.LABEL, at)
    # Rules 4 and 7.
    is_handle = first & _LONG and first & HANDLE_BIT
    return Refusal(Reason.ALIGNMENT, at) if is_handle and value & _MISALIGNED_HANDLE else after


def _refused(first: int, value: int, kind: int) -> Reason | None:
    """Why a long argument is refused, where the operation is still bad or it is a variable."""
    if first & _VARIABLE:
        mask = _MISALIGNED_HANDLE if first & HANDLE_BIT else _MISALIGNED[kind]
        return Reason.ALIGNMENT if value & mask else None
    limits = _RANGES.get(kind)
    return None if limits is None or limits.low <= value <= limits.high else Reason.RANGE


def _value(data: bytes, at: int) -> tuple[int, int]:
    """The value of the argument at an offset, as the validator takes it, and the offset after it."""
    first = data[at]
    if first & _LONG:
        return _long_value(data, at)
    short = first & _SHORT_BITS if first & _VARIABLE else SHORT_VALUES[first]
    assert short is not None
    return short, at + 1


def _long_value(data: bytes, at: int) -> tuple[int, int]:
    """The same for a long form. Of a text, and of a form that is not defined, the value is 0."""
    form = INTEGER_FORMS[data[at]]
    if form is None:
        return 0, at + 1
    _, unpack, size = form
    return (0, data.index(0, at + 1) + 1) if unpack is None else (unpack(data, at)[0], at + size)


def _skip(data: bytes, at: int, end: int, count: int) -> int:
    """The offset after so many arguments, none of which is looked at; or after the first that reaches beyond `end`."""
    for _ in range(count):
        if at > end:
            # Rule 1. What follows has no end that would matter.
            break
        size = _SIZES[data[at]]
        at = at + size if size else data.index(0, at + 1) + 1
    return at


def _kinds(parameters: Sequence[Parameter]) -> _Kinds:
    return tuple(_kind(parameter) for parameter in parameters)


def _kind(parameter: Parameter) -> int:
    if parameter.role is Role.JUMP:
        # How far to jump is a number; only LABEL has a label.
        return _DATA32
    return _CHECKED_AS[parameter.validated or parameter.type]


def _cmd_tables(known: Sequence[Declaration]) -> dict[str, Sequence[_Kinds]]:
    """For each table of CMDs by its name, what follows a CMD by the byte that is its number; nothing for unknown ones.

    Args:
        known: The operations that the validator knows.
    """
    commands = [(entry.opcode.validator_table, entry.command, entry.parameters) for entry in known]
    names = dict.fromkeys((*CMD_TABLES, *(name for name, command, _ in commands if command is not None)))
    row: list[_Kinds] = []
    for name in names:
        found: list[_Kinds] = [()] * TABLE_SIZE
        for table, command, parameters in commands:
            if table == name and command is not None:
                found[command.number] = _kinds(parameters)
        row += found
    # Rule 8. The firmware does not expect a negative CMD: it looks before its table, which is in the table before it.
    tables: dict[str, Sequence[_Kinds]] = {}
    for name, start in zip(names, range(0, len(row), TABLE_SIZE), strict=True):
        own = row[start : start + TABLE_SIZE]
        negative = [row[start + number] if start + number >= 0 else () for number in range(-128, 0)]
        tables[name] = (*own, *[()] * (128 - TABLE_SIZE), *negative)
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
