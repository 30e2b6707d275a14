"""The edits that may undo a slip: where each kind of `slips` may have happened, by the parse and the declarations.

A generator for each part of a frame: its header, the arguments of one operation, all operations, system commands.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Iterator
from itertools import product
from typing import NamedTuple

from ev3proto.errors import counted
from ev3proto.messages import Argument, Variable
from ev3proto.schema.argument import LABEL_BYTE, encode_float, encode_integer, encode_string, encode_variable
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE, MEMORY_SIZE, TYPE_AT, frame_size, with_length
from ev3proto.schema.instructions import FamilySchema, OperationSchema
from ev3proto.schema.wire_format import NUMBERS
from ev3proto.semantics.facts import OperationFacts, ParameterFacts, operation_facts
from ev3proto.semantics.judgement import judge
from ev3proto.semantics.likelihood import CommandCode, Reading
from ev3proto.tables.declaration import Direction, Effect, Role, Type
from ev3proto.tables.encoding import CONSTANT, GLOBAL, LOCAL
from ev3proto.tables.frame import LENGTH_FIELD, MESSAGE_TYPES, TYPES_BY_KIND, MessageType
from ev3proto.tables.system import SYSTEM_BY_NUMBER, FieldKind, SystemDeclaration, SystemField
from ev3proto.tables.validation import LABELS

DIRECT, SYSTEM = (frozenset(map(int, TYPES_BY_KIND[f"{kind}-command"])) for kind in ("direct", "system"))
_COMMANDS = {number: MESSAGE_TYPES[number] for number in sorted(DIRECT | SYSTEM)}
_REPLY_BIT = MessageType.DIRECT_COMMAND_REPLY ^ MessageType.DIRECT_COMMAND_NO_REPLY

_LC1, _LC2, _LC4 = (encode_integer(number)[0] for number in (100, 1000, 100_000))
_WIDTHS = {_LC1: 1, _LC2: 2, _LC4: 4}
_WORDS = {1: "one byte", 2: "two bytes", 4: "four bytes"}
_LABELS = {LABEL_BYTE + code: width for code, width in ((0, 1), (1, 1), (2, 2), (3, 4))}
_LCS = encode_string("")[0]
_OLD_LCS = 0x80
_LV0, _GV0 = (encode_variable(Variable(scope, 0))[0] for scope in (LOCAL, GLOBAL))
_LARGE = 5000  # numbers above this one are rare
_SHORT = 32  # numbers and indexes below this one are one byte
_NUMBERS = (Type.DATA8, Type.DATA16, Type.DATA32)
ENDS = b"\r\n\0"
"""Bytes that often follow a frame."""
_PRINTED = bytes(range(0x20, 0x7F))
_COMMON = b"\0."  # bytes that are often twice in a row


class Edit(NamedTuple):
    """An edit at a place: bytes `at` to `end` of a frame become `new`.

    kind   of the slip that it undoes
    words  for the slip's sentence
    extra  what makes it less likely at this place, besides the slip's own cost
    guess  how many of the first bytes of `new` can only be guessed
    """

    kind: str
    at: int
    end: int
    new: bytes
    words: tuple[object, ...] = ()
    extra: float = 0.0
    guess: int = 0


def spaced(data: bytes) -> str:
    """Returns bytes as `0D 00`."""
    return data.hex(" ").upper()


def left_over(frame: bytes, at: int) -> Edit:
    """Returns the edit that drops the bytes from an offset on."""
    rest = frame[at:]
    words = counted(len(rest), "byte"), "is" if len(rest) == 1 else "are"
    return Edit("left-over", at, len(frame), b"", words, 1.0 if rest.strip(ENDS) else 0.0)


# The header


def header_edits(frame: bytes) -> Iterator[Edit]:
    """Yields the edits of a header, but for the length field's value and the sizes of memory."""
    yield from _of_length(frame)
    yield from _of_order(frame)
    yield from _of_decimals(frame)
    size = len(frame)
    if frame[2] in _COMMANDS:
        length = size.to_bytes(LENGTH_FIELD, "little")
        yield Edit("length-missing", 0, 0, length, (spaced(length),), 8.0 if frame_size(frame) == size else 0.0)
        yield Edit("counter-missing", 2, 2, bytes(2), guess=2)
    if frame[3] in _COMMANDS:
        yield Edit("header-short", 2, 3, frame[2:3] + b"\0", guess=2)
    if size > HEADER_SIZE + 1:
        yield from _of_type(frame)
        for at in range(LENGTH_FIELD, min(COMMAND_HEADER_SIZE, size - 1)):
            yield _of_pair(frame, at, 0.5)
    if frame[TYPE_AT] in DIRECT:
        yield from _of_memory(frame)


def _of_length(frame: bytes) -> Iterator[Edit]:
    size = len(frame)
    if frame[0] in (size - 1, size + 1) and frame[1]:
        yield Edit("length-half", 1, 1, b"\0")
    if size > 9 and frame[6] in _COMMANDS:
        yield Edit("header-long", TYPE_AT, 6, b"")
        if not any(frame[2:4]):
            yield Edit("header-long", 2, 4, b"", extra=-1.0)
    if frame_size(frame[1:]) == size - 1:
        yield Edit("report-number", 0, 1, b"")


def _of_order(frame: bytes) -> Iterator[Edit]:
    for given in _ORDERS:
        right = sorted(given, key=list(_FIELDS).index)
        form = "".join([_FIELDS[name] for name in given])
        end = LENGTH_FIELD + struct.calcsize(form)
        if len(frame) < end + ("memory" in given):
            continue
        fields = dict(zip(given, struct.unpack_from(form, frame, LENGTH_FIELD), strict=True))
        if _is_header(fields, frame):
            extra = 0.0 if fields["counter"][0] else _EVEN_COUNTER
            extra += _OPCODE if given[-1] == "counter" and fields["counter"][0] >= 0x80 else 0.0
            new = b"".join([fields[name] for name in right])
            yield Edit("header-order", LENGTH_FIELD, end, new, (", ".join(given), ", ".join(right)), extra)


def _is_header(fields: dict[str, bytes], frame: bytes) -> bool:
    """Returns whether fields in another order are a header: its memory, or else its type, is not there by chance."""
    number, memory, has_counter = fields["type"][0], fields.get("memory"), fields["counter"][0] > 0
    if memory is None:
        return number in SYSTEM and fields["command"][0] in SYSTEM_BY_NUMBER
    is_silent = number == MessageType.DIRECT_COMMAND_NO_REPLY
    is_told = is_silent or (number in DIRECT and has_counter)
    if list(fields)[-1] == "memory":
        return is_told
    is_told = is_silent or (is_told and any(memory))
    return is_told and frame[TYPE_AT] not in _SURE_TYPES and memory != frame[HEADER_SIZE:COMMAND_HEADER_SIZE]


_SURE_TYPES = frozenset(_COMMANDS) - {MessageType.DIRECT_COMMAND_REPLY}
"""Types that are not in their place by chance, as zeros are."""
_FIELDS = {"counter": "2s", "type": "s", "memory": "2s", "command": "s"}
_ORDERS = (
    ("counter", "memory", "type"),
    ("type", "counter", "memory"),
    ("type", "memory", "counter"),
    ("memory", "counter", "type"),
    ("type", "command", "counter"),
    ("type", "counter", "command"),
    ("counter", "command", "type"),
)
"""Orders in which people give the fields of a header; `_FIELDS` has the right one."""
_EVEN_COUNTER = 1.0  # the further cost of a counter whose low byte is zero
_OPCODE = 3.0  # the same of one that is where operations begin, and begins like most of them


def _of_decimals(frame: bytes) -> Iterator[Edit]:
    """Yields the frames whose digits of hex are the decimal digits of these bytes."""
    for one, extra in _from_decimals(with_length(frame[LENGTH_FIELD:])) if _may_be_decimals(frame) else ():
        changed = [at for at in range(TYPE_AT, len(frame)) if one[at] != frame[at]]
        if one[TYPE_AT] in _COMMANDS and (changed[:1] == [TYPE_AT] or len(changed) > 1):
            words = f"{one[changed[0]]:02X}", f"{frame[changed[0]]:02X}"
            yield Edit("decimals", 0, len(frame), one, words, extra + 0.5 * (changed[0] != TYPE_AT))


def _may_be_decimals(frame: bytes) -> bool:
    """Returns whether the length is right, maybe in decimals, and no byte has digits that are never taken for them."""
    length = with_length(frame[LENGTH_FIELD:])[:LENGTH_FIELD]
    is_length = frame[0] in (length[0], _as_decimal(length[0])) and frame[1] == length[1]
    return is_length and not any(byte > _MOST_DECIMAL and f"{byte:02x}".isdigit() for byte in frame[TYPE_AT:])


def _from_decimals(frame: bytes) -> Iterator[tuple[bytes, float]]:
    """Yields frames with the bytes that the digits are in hex, and their cost: those with a letter may have stayed."""
    words, texts = _matched(_WORD, frame), _matched(_TEXT, frame)
    options = [
        (byte,) if at < LENGTH_FIELD or at in words else _in_hex(byte, at in texts, is_open=at >= TYPE_AT)
        for at, byte in enumerate(frame)
    ]
    for at in [at for at, one in enumerate(options) if len(one) > 1][_MOST_OPEN:]:
        options[at] = options[at][:1]
    for choice in product(*options):
        yield bytes(choice), 0.4 * sum(byte != one[0] for byte, one in zip(choice, options, strict=True))


def _in_hex(byte: int, is_text: bool, *, is_open: bool) -> tuple[int, ...]:
    """Returns what a byte was before its digits of hex were taken for decimals: another one, or maybe the same."""
    if byte > _MOST_DECIMAL:
        return (byte,)
    meant = int(str(byte), 16)
    if f"{byte:02x}".isdigit() or (is_text and chr(meant).islower()):
        return (meant,)
    return (byte, meant) if is_open and not is_text else (byte,)


def _matched(kind: re.Pattern[bytes], frame: bytes) -> set[int]:
    return {at for one in kind.finditer(frame) for at in range(*one.span())}


def _as_decimal(byte: int) -> int:
    """Returns what becomes of the digits of a byte in hex if they are taken for those of a decimal number."""
    digits = f"{byte:x}"
    return int(digits) if digits.isdigit() else byte


_MOST_DECIMAL, _MOST_OPEN = 99, 5
_WORD, _TEXT = re.compile(rb"[a-z./]{3,}"), re.compile(rb"[A-Za-z0-9_./ =?<>:;,+*()-]{3,}")


def _of_type(frame: bytes) -> Iterator[Edit]:
    number = frame[TYPE_AT]
    digits = number >> 4 | (number & 15) << 4  # with its two digits swapped
    for other, member in _COMMANDS.items():
        if other in DIRECT or frame[TYPE_AT] in SYSTEM_BY_NUMBER:
            yield Edit("header-short", TYPE_AT, TYPE_AT, bytes((other,)), extra=1.0, guess=1)
        if other == number:
            continue
        changed = number ^ other
        is_near = other == digits or changed == _REPLY_BIT or not (changed & 15 and changed >> 4)
        extra = 1.0 * (number in _COMMANDS) + 0.5 * (not is_near) - 0.5 * (other == digits)
        extra += 1.5 if changed == _REPLY_BIT else 0.0
        yield Edit("type", TYPE_AT, HEADER_SIZE, bytes((other,)), (number, other, member.name), extra)


def _of_memory(frame: bytes) -> Iterator[Edit]:
    at, end = HEADER_SIZE, COMMAND_HEADER_SIZE
    yield Edit("memory-missing", at, at, bytes(2), extra=1.0 if frame[2] in DIRECT and not frame[3] else 0.0)
    yield Edit("memory-half", at, at, b"\0", guess=1)
    yield Edit("memory-half", at + 1, at + 1, b"\0", extra=0.2, guess=1)
    if len(frame) > end + MEMORY_SIZE and not any(frame[end : end + MEMORY_SIZE]):
        yield Edit("header-long", end, end + MEMORY_SIZE, b"")
    if len(frame) > end and frame[at] != frame[at + 1]:
        yield Edit("memory-swapped", at, end, frame[at:end][::-1])
        if 0 < frame[at + 1] < 64:
            new = bytes((frame[at + 1] << 2,))
            yield Edit("memory-shift", at + 1, end, new, (frame[at + 1], spaced(new)))


def _of_pair(data: bytes, at: int, extra: float) -> Edit:
    """Returns the edit of a byte that is there twice, or of two that changed places."""
    if data[at] == data[at + 1]:
        return Edit("doubled", at, at + 1, b"", (data[at],), extra)
    pair = data[at : at + 2]
    return Edit("transposed", at, at + 2, pair[::-1], (spaced(pair), spaced(pair[::-1])))


# The arguments of an operation


class Place(NamedTuple):
    """A place where a parameter is expected."""

    code: CommandCode
    operation: str
    known: ParameterFacts  # the parameter
    at: int
    end: int  # after the argument; one byte further if it cannot be read
    argument: Argument | None  # None if it cannot be read
    following: int  # number of parameters after it

    @property
    def names(self) -> tuple[str, str]:
        """The parameter and its operation."""
        return self.known.parameter.name, self.operation

    @property
    def takes_number(self) -> bool:
        """Whether it is a whole number that the operation reads."""
        parameter = self.known.parameter
        is_single = parameter.length is None and parameter.role not in (Role.JUMP, Role.ADDRESS)
        return parameter.direction is Direction.IN and parameter.type in _NUMBERS and is_single

    def number(self, number: int) -> bytes:
        """Returns a number as an argument, empty if it is not legal here."""
        return encode_integer(number) if judge(self.known, CONSTANT, number) is None else b""


def _numbers(place: Place) -> Iterator[Edit]:
    """Yields the edits of a number that is not written as the brick reads it."""
    data, at = place.code.data, place.at
    for kind, size, number, extra in _readings(place) if place.takes_number else ():
        new = place.number(number)
        if new and new != data[at : at + size] and at + size <= len(data):
            yield Edit(kind, at, at + size, new, (*place.names, number, spaced(new)), extra)


def _readings(place: Place) -> Iterator[tuple[str, int, int, float]]:
    """Yields numbers that may be meant by the bytes at a place: kind, number of bytes, number, further cost."""
    yield from _raw(place)
    data, at, argument = place.code.data, place.at, place.argument
    width = _WIDTHS.get(data[at], 0)
    if argument is not None:
        yield from _of_labels(data[at], data[at + 1 : at + 5])
    if width > 1:
        number = int.from_bytes(data[at + 1 : at + 1 + width], "big", signed=True)
        yield "swapped", 1 + width, number, _of_swapped(number, argument)
    if width and argument is not None and not place.number(int(argument.value)):
        for bits in (8, 16):
            number = int(argument.value) - (1 << bits)
            if -(1 << bits - 1) <= number < 0:
                yield "sign", 1 + width, number, 0.0


def _of_labels(first: int, after: bytes) -> Iterator[tuple[str, int, int, float]]:
    """Yields the numbers that may be meant by a label."""
    width = _LABELS.get(first)
    if width is not None:
        number = int.from_bytes(after[:width], "little") & (1 << 31) - 1
        # Other numbers than those of labels are what they are to the brick, too.
        is_label = number < LABELS
        yield "label", 1 + width, -number, 0.0 if is_label else 0.5
        yield "label", 1 + width, number, 0.5 if is_label else 0.0


def _of_swapped(number: int, argument: Argument | None) -> float:
    """Returns what speaks against swapped bytes: a number that is larger than what is there."""
    value = int(argument.value) if argument is not None else number
    return 1.5 if 0 <= value < number or number < 0 <= value else 0.0


def _raw(place: Place) -> Iterator[tuple[str, int, int, float]]:
    data, at = place.code.data, place.at
    # A negative number of one byte is rarely meant as a positive one.
    is_argument = 3.0 if data[at] < _SHORT or data[at] in (*_WIDTHS, _LCS) else 0.5 if data[at] < 2 * _SHORT else 0.0
    for width in (1,) if place.known.parameter.type is Type.DATA8 else (1, 2):
        for is_signed in (False, True):
            number = int.from_bytes(data[at : at + width], "little", signed=is_signed)
            if len(encode_integer(number)) >= width and (number < 0) == is_signed:
                yield "raw", width, number, 0.5 * (width == 2) + is_argument + _oddness(number)


def _oddness(number: int) -> float:
    """Returns the cost of a number that people rarely write in some bytes: negative, or not round."""
    return 1.0 * (number < 0) + 0.3 * (number % 5 > 0)


def _width(place: Place) -> Iterator[Edit]:
    first = place.code.data[place.at]
    for other, width in _WIDTHS.items() if place.takes_number and first in _WIDTHS else ():
        if other != first:
            words = (*place.names, f"{first:02X}", f"{other:02X}", _WORDS[width])
            number = int.from_bytes(place.code.data[place.at + 1 : place.at + 1 + width], "little", signed=True)
            extra = 1.0 * (_LC4 in (first, other)) + 1.0 * (abs(number) > _LARGE)
            yield Edit("width", place.at, place.at + 1, bytes((other,)), words, extra)


def _text(place: Place) -> Iterator[Edit]:
    data, at = place.code.data, place.at
    if not place.known.is_text or place.known.parameter.direction is not Direction.IN:
        return
    if data[at] in (_OLD_LCS, _LCS):
        stop = len(data) - len(data[at + 1 :].lstrip(_PRINTED))
        for end in {stop, stop + 1, stop - 1, stop - place.following}:
            if at < end <= len(data):
                yield Edit("no-zero", end, end, b"\0", place.names, 0.0 if end == stop else 0.5)
    elif data[at] in _PRINTED:
        yield Edit("no-84", at, at, bytes((_LCS,)), place.names)
    if data[at] and data.find(0, at + 1) == at + 1 + data[at]:
        yield Edit("length-84", at, at + 1, bytes((_LCS,)), place.names)


def _floats(place: Place) -> Iterator[Edit]:
    """Yields the edits of a float that is not written as the brick reads it."""
    at, data = place.at, place.code.data
    if place.known.parameter.type is not Type.DATAF or place.known.parameter.is_output:
        return
    for kind, size, number in _float_readings(place):
        new = encode_float(number) if 0.01 <= abs(number) < 1_000_000 else b""
        if new and new != data[at : at + size] and at + size <= len(data):
            words = (f"{data[at]:02X}", f"{_LC4:02X}", _WORDS[4]) if kind == "width" else (f"{number:g}", spaced(new))
            yield Edit(kind, at, at + size, new, (*place.names, *words))


def _float_readings(place: Place) -> Iterator[tuple[str, int, float]]:
    """Yields floats that may be meant by the bytes at a place: kind, number of bytes, number."""
    argument, at, data = place.argument, place.at, place.code.data
    after = data[at + 1 : at + 5]
    yield "raw", 4, _float(data[at : at + 4])
    if data[at] == _LC4:
        yield "swapped", 5, _float(after[::-1])
    elif data[at] in _WIDTHS:
        yield "width", 5, _float(after)
    if argument is not None and argument.kind == CONSTANT:
        whole = int.from_bytes(after, "little", signed=True) if isinstance(argument.value, float) else argument.value
        yield "float", place.end - at, float(whole)


def _float(data: bytes) -> float:
    return float(struct.unpack("<f", data)[0]) if len(data) == 4 else 0.0


def _aligned(place: Place) -> Iterator[Edit]:
    code, at, argument, known = place.code, place.at, place.argument, place.known
    if argument is None or not argument.is_variable or argument.form.width:
        return
    index, step = int(argument.value), max(known.validator_alignment, known.cpu_alignment)
    below = index - index % step
    for other in (below, below + step) if below != index else ():
        new = bytes((code.data[at] - index + other,))
        words = (*place.names, step, Variable(argument.form.kind, other), spaced(new))
        yield Edit("aligned", at, place.end, new, words, 0.3 if other > index else 0.0)


def _result(place: Place) -> Iterator[Edit]:
    """Yields the edits of a result that is stored in no variable, or in one that no reply carries."""
    code, at, known = place.code, place.at, place.known
    first = code.data[at]
    if not known.parameter.is_output:
        return
    wants_reply = code.memory.globals > 0 or code.data[TYPE_AT] == MessageType.DIRECT_COMMAND_REPLY
    if _LV0 <= first < _GV0 and wants_reply:
        new = bytes((first - _LV0 + _GV0,))
        yield Edit("scope", at, at + 1, new, (*place.names, spaced(new)))
    if code.data[at : at + 2] in _VARIABLES_IN_LC1:
        yield Edit("variable-81", at, at + 1, b"", (*place.names, spaced(code.data[at + 1 : at + 2])))
    scopes = ((GLOBAL, _GV0, wants_reply, 0.0), (LOCAL, _LV0, code.memory.locals > 0, 0.5))
    for scope, base, is_possible, extra in scopes:
        if first < _SHORT and is_possible:
            new = bytes((base + first,))
            yield Edit("variable", at, at + 1, new, (*place.names, Variable(scope, first), spaced(new)), extra)


_VARIABLES_IN_LC1 = frozenset(bytes((_LC1, first)) for first in range(_LV0, _GV0 + _SHORT))


def _lost(place: Place) -> Iterator[Edit]:
    argument, at, data = place.argument, place.at, place.code.data
    if argument is None:
        width = _WIDTHS.get(data[at], 0)
        if width and len(data) - at == width:
            yield Edit("lost", len(data), len(data), b"\0", place.names, guess=1)
        return
    for behind in range(1, min(argument.form.width or 0, 2) + 1):
        yield Edit("lost", at + behind, at + behind, b"\0", place.names, guess=1)


def _digits(place: Place) -> Iterator[Edit]:
    """Yields the edits of the first byte of an argument that is hardly meant, of which one digit may be wrong."""
    argument, at = place.argument, place.at
    first = place.code.data[at]
    if argument is None or place.code.cost_of(place.known, argument) >= _HARDLY_MEANT:
        for other in _near(first):
            yield Edit("digit", at, at + 1, bytes((other,)), (*place.names, f"{first:02X}", f"{other:02X}"))


def _near(number: int) -> Iterator[int]:
    """Yields the bytes that differ in one digit."""
    yield from (number & 0xF0 | digit for digit in range(16) if digit != number & 0xF)
    yield from (number & 0xF | digit << 4 for digit in range(16) if digit != number >> 4)


_HARDLY_MEANT = 2.0  # the cost of an argument

_AT_ARGUMENT = (_numbers, _width, _text, _floats, _aligned, _result, _lost)


def _filler(known: ParameterFacts, code: CommandCode, before: list[Argument]) -> bytes:
    """Returns a value for a missing argument."""
    parameter, domain = known.parameter, known.domain
    if parameter.is_output or parameter.role in (Role.FILE, Role.ARRAY):
        return _free_variable(known, code, before)
    if parameter.type is Type.STRING:
        return encode_string("x")
    if parameter.role is Role.MOTORS or parameter.counts:
        return b"\1"
    low = domain.spans[0][0] if domain is not None and domain.spans else 0
    return encode_integer(next((one for one in (0, 1, low) if judge(known, CONSTANT, one) is None), 0))


def _free_variable(known: ParameterFacts, code: CommandCode, before: list[Argument]) -> bytes:
    """Returns a variable after those of other arguments, or the first one if there is no room."""
    shared, local, _ = code.memory
    scope, most, base = (GLOBAL, shared, _GV0) if shared else (LOCAL, local, _LV0)
    end = max([int(one.value) + 4 for one in before if one.kind == scope], default=0)
    index = end + -end % known.alignment
    return bytes((base + (index if index < _SHORT and index + known.size <= most else 0),))


def operation_edits(code: CommandCode, start: int, reading: Reading) -> Iterator[Edit]:
    """Yields the edits of one operation, as far as it can be read."""
    data, size = code.data, len(code.data)
    yield from _of_opcode(code, start, reading)
    for at in range(start, min(reading.end + (3 if reading.is_fault else 0), size - 1)):
        yield _of_pair(data, at, 1.0 if data[at] in _COMMON else 0.0)
    if reading.schema is None:
        return
    facts, arguments = operation_facts(reading.schema), reading.arguments
    yield from _cut(code, facts, reading)
    yield from _no_results(code, facts, reading)
    yield from _all_local(code, facts, reading)
    ends = [one.offset for one in arguments] + [reading.end]
    for number, at in enumerate(ends):
        argument = arguments[number] if number < len(arguments) else None
        known = _expected(facts, number, argument)
        if known is None:
            continue
        end = ends[number + 1] if argument is not None else min(at + 1, size)
        place = Place(code, facts.name, known, at, end, argument, len(facts.parameters) - number - 1)
        yield from _of_place(place, arguments, number, ends)


def _cut(code: CommandCode, facts: OperationFacts, reading: Reading) -> Iterator[Edit]:
    end, left = reading.end, facts.parameters[len(reading.arguments) :]
    if reading.is_fault and end == len(code.data) and len(left) > 1:
        new = b"".join([_filler(known, code, reading.arguments) for known in left])
        words = (", ".join(known.parameter.name for known in left), facts.name)
        yield Edit("cut", end, end, new, words, 0.5 * len(left), len(new))


def _no_results(code: CommandCode, facts: OperationFacts, reading: Reading) -> Iterator[Edit]:
    """Yields the edit that adds variables for results, where memory is requested and nothing is stored in it."""
    room = code.memory.globals
    if not room or any(one.kind == GLOBAL for _, other in code.first for one in other.arguments):
        return
    at, wanted, count = _results(facts, reading, room)
    if not wanted:
        return
    variables, end = _places(wanted)
    new = count + variables
    is_guess = end != room and not (wanted[-1].is_array and end < room)
    names = ", ".join(dict.fromkeys(known.parameter.name for known in wanted))
    words = (names, facts.name, "is" if len(wanted) == 1 else "are", spaced(new))
    yield Edit("no-results", at, at, new, words, 1.0 * is_guess, len(new) * is_guess)


def _results(facts: OperationFacts, reading: Reading, room: int) -> tuple[int, list[ParameterFacts], bytes]:
    """Returns where results are missing, which, and their number if it is missing, too."""
    if reading.schema is not None and reading.schema.tail is not None:
        return reading.end, *_list_of_results(facts, reading, reading.schema, room)
    wanted = [known for known in facts.parameters if known.parameter.is_output]
    inputs, read = len(facts.parameters) - len(wanted), reading.arguments
    if len(read) <= inputs:
        return reading.end, wanted if len(read) == inputs else [], b""
    return read[inputs].offset, [] if read[inputs].is_variable else wanted, b""


def _places(wanted: list[ParameterFacts]) -> tuple[bytes, int]:
    """Returns aligned variables in global memory, one behind the other, and where the last one ends."""
    variables, end = b"", 0
    for known in wanted:
        index = end + -end % known.alignment
        variables += encode_variable(Variable(GLOBAL, index))
        end = index + known.size
    return variables, end


def _all_local(code: CommandCode, facts: OperationFacts, reading: Reading) -> Iterator[Edit]:
    """Yields the edit that stores all results of an operation in global memory, if they are in local memory."""
    found = [one for one in reading.arguments if one.parameter.is_output and one.kind == LOCAL and not one.form.width]
    if len(found) > 1 and code.data[TYPE_AT] == MessageType.DIRECT_COMMAND_REPLY:
        at, end = found[0].offset, found[-1].offset + 1
        new = bytearray(code.data[at:end])
        for one in found:
            new[one.offset - at] += _GV0 - _LV0
        names = ", ".join(one.name for one in found)
        yield Edit("scope", at, end, bytes(new), (names, facts.name, spaced(bytes(new))), -0.9)


def _list_of_results(
    facts: OperationFacts, reading: Reading, schema: OperationSchema, room: int
) -> tuple[list[ParameterFacts], bytes]:
    """Returns the results of an operation that tells their number, and that number if it is missing, too."""
    read, inputs = reading.arguments, len(facts.parameters)
    element = facts.of(inputs, schema.element(read))
    if not reading.is_fault or not element.parameter.is_output or not inputs - 1 <= len(read) <= inputs:
        return [], b""
    count = min(room // element.size, _MOST_RESULTS)
    if len(read) < inputs:
        return [element] * count, encode_integer(count)
    return [element] * (count if read[-1].value == count else 0), b""


_MOST_RESULTS = 8


def _expected(facts: OperationFacts, number: int, argument: Argument | None) -> ParameterFacts | None:
    if argument is not None:
        return facts.of(number, argument.parameter)
    return facts.parameters[number] if number < len(facts.parameters) else None


def argument_edits(place: Place, arguments: list[Argument]) -> Iterator[Edit]:
    """Yields the edits at the place of an argument; `arguments` are those of its operation that can be read."""
    is_layer = place.known.parameter.role is Role.LAYER
    new = b"\0" if is_layer else _filler(place.known, place.code, arguments)
    extra = (-1.0 if is_layer else 0.1 * min(place.following, 3)) + (0.3 if place.argument is None else 0.0)
    yield Edit("missing", place.at, place.at, new, place.names, extra, 0 if is_layer else len(new))
    for edits in _AT_ARGUMENT if place.at < len(place.code.data) else ():
        yield from edits(place)


def _of_place(place: Place, arguments: list[Argument], number: int, ends: list[int]) -> Iterator[Edit]:
    at, end, data = place.at, place.end, place.code.data
    yield from argument_edits(place, arguments)
    if at < len(data):
        yield from _digits(place)
    if place.argument is None or at >= len(data):
        return
    is_twice = data[at:end] == data[end : end + end - at] and number + 1 < len(arguments)
    yield Edit("extra", at, end, b"", place.names, -1.0 if is_twice else 0.0)
    if number + 1 < len(arguments) and not is_twice:
        after = ends[number + 2]
        words = (place.names[0], arguments[number + 1].name, place.operation)
        yield Edit("order", at, after, data[end:after] + data[at:end], words)


def _of_opcode(code: CommandCode, start: int, reading: Reading) -> Iterator[Edit]:
    schema, family = reading.schema, code.set.families[code.data[start]]
    if schema is not None and Effect.ENDS_CODE in schema.declaration.effects:
        yield Edit("end", start, start + 1, b"")
    if not code.data[start:].strip(ENDS):
        yield left_over(code.data, start)
    if reading.cost >= _SUSPICIOUS:
        yield from _other_opcodes(code, start)
    if family is not None:
        yield from _of_cmd(code, start, family, reading.cost)
    elif schema is not None and schema.declaration.parameters:
        for other in _shorter(code, schema):
            words = (schema.declaration.name, schema.declaration.parameters[-1].name, other.declaration.name)
            distance = abs(other.head[0] - schema.head[0])
            yield Edit("opcode", start, start + 1, other.head, words, 0.5 * (distance > 1))


def _of_cmd(code: CommandCode, start: int, family: FamilySchema, cost: float) -> Iterator[Edit]:
    at, name = start + 1 + len(_PLACE), family.opcode.name
    other = family.short.get(code.data[at]) if at < len(code.data) else None
    if other is not None and _begins_with_place(other):
        yield Edit("cmd-place", start + 1, at + 1, code.data[at : at + 1] + code.data[start + 1 : at], (name,))
    given = code.data[start + 1 : start + 2]
    for cmd in _near(given[0]) if given and cost >= _SUSPICIOUS else ():
        if cmd in family.short:
            words = "CMD", name, spaced(given), f"{cmd:02X}"
            yield Edit("digit", start + 1, start + 2, bytes((cmd,)), words, 1.5 if given[0] in family.short else 0.5)
    for cmd in family.short:
        yield Edit("no-cmd", start + 1, start + 1, bytes((cmd,)), (name,), guess=1)


def _other_opcodes(code: CommandCode, start: int) -> Iterator[Edit]:
    """Yields the opcodes that differ in one digit, or are the next ones."""
    number = code.data[start]
    for other in range(256):
        changed = number ^ other
        is_next = abs(number - other) == 1
        if changed and (is_next or not (changed & 15 and changed >> 4)):
            schema, family = code.set.opcodes[other], code.set.families[other]
            name = schema.declaration.name if schema else family.opcode.name if family else ""
            if name:
                words = f"{number:02X}", f"{other:02X}", name
                extra = 0.5 * (not is_next) + 0.5 * (code.set.opcodes[number] is not None)
                yield Edit("opcode-digit", start, start + 1, bytes((other,)), words, extra)


_SUSPICIOUS = 4.0  # the cost of an operation from which on its opcode is
_PLACE = (Role.LAYER, Role.PORT)


def _begins_with_place(schema: OperationSchema) -> bool:
    return tuple(one.role for one in schema.declaration.parameters[: len(_PLACE)]) == _PLACE


def _shorter(code: CommandCode, schema: OperationSchema) -> Iterator[OperationSchema]:
    """Yields the operations around one in the table that take its first parameters, but not the last."""
    wanted = [one.name for one in schema.declaration.parameters[:-1]]
    for number in range(max(schema.head[0] - 3, 0), min(schema.head[0] + 4, 256)):
        other = code.set.opcodes[number]
        if other is not None and wanted and [one.name for one in other.declaration.parameters] == wanted:
            yield other


# System commands

_USUAL_SIZE = 1000  # bytes to ask for


def system_edits(frame: bytes) -> Iterator[Edit]:
    """Yields the edits of a system command."""
    entry = SYSTEM_BY_NUMBER.get(frame[HEADER_SIZE])
    if entry is None:
        return
    at = HEADER_SIZE + 1
    for field in entry.request:
        if at > len(frame):
            return
        yield from _of_field(frame, at, field, entry)
        if field.kind in NUMBERS:
            at += int(NUMBERS[field.kind].sizeof())
        elif field.kind is FieldKind.TEXT:
            at = frame.find(0, at) + 1 or len(frame)
        elif field.kind is FieldKind.COUNTED_TEXT:
            at += frame[at - 1]
    for place in range(HEADER_SIZE, min(len(frame) - 1, 80)):
        yield _of_pair(frame, place, 2.0 if frame[place] in _COMMON else 1.0)


def _of_field(frame: bytes, at: int, field: SystemField, entry: SystemDeclaration) -> Iterator[Edit]:
    names = field.name, entry.name
    if field.counts is not None:
        yield from _of_count(frame, at, field, entry)
    elif field.kind in NUMBERS:
        yield from _of_number(frame, at, int(NUMBERS[field.kind].sizeof()), names)
    elif field.kind is FieldKind.TEXT:
        yield Edit("no-zero", len(frame), len(frame), b"\0", names)
    elif field.kind is FieldKind.COUNTED_TEXT:
        for count in (frame[at - 1], frame[at - 1] - 1):
            if 0 < count <= len(frame) - at and frame[at + count - 1]:
                yield Edit("no-zero", at + count, at + count, b"\0", names, 0.2 if count == frame[at - 1] else 0.0)


def _of_number(frame: bytes, at: int, width: int, names: tuple[str, str]) -> Iterator[Edit]:
    value = frame[at : at + width]
    yield Edit("no-field", at, at, (_USUAL_SIZE if width == 2 else 0).to_bytes(width, "little"), names, guess=width)
    if value != value[::-1]:
        words = (*names, int.from_bytes(value, "big"), spaced(value[::-1]))
        yield Edit("swapped", at, at + width, value[::-1], words)


def _of_count(frame: bytes, at: int, field: SystemField, entry: SystemDeclaration) -> Iterator[Edit]:
    """Yields the edits of a field that counts the bytes of another."""
    width = int(NUMBERS[field.kind].sizeof())
    is_text = next(one for one in entry.request if one.name == field.counts).kind is FieldKind.COUNTED_TEXT
    value, names = frame[at : at + width], (field.name, entry.name)
    zero = frame[at + width :].find(0)
    looks_like_text = all(0x30 <= byte < 0x7F for byte in value)
    for number, extra in ((zero + 1, 0.0), (zero, 0.3)) if is_text else ((len(frame) - at - width, 0.0),):
        if 0 < number < 1 << 8 * width:
            new = number.to_bytes(width, "little")
            words = (*names, int.from_bytes(value, "little"), number)
            yield Edit("field", at, at + width, new, words, extra + (2.5 if looks_like_text else 0.0))
    missing = frame[at:].find(0) + 1 if is_text else len(frame) - at
    if 0 < missing < 1 << 8 * width:
        yield Edit("no-field", at, at, missing.to_bytes(width, "little"), names)
