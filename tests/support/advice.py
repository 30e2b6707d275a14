"""Follows the helps of `check`: yields the resulting frames, one for each number that a help names.

The numbers of a help are put where a user would put them. Only the length field changes with them; it remains wrong
by the same number of bytes as before.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

import ev3proto
from ev3proto.checking.report import Finding
from ev3proto.errors import BuildError
from ev3proto.messages import Argument, DirectCommand, Operation, Variable
from ev3proto.schema.argument import ENCODINGS, encode_as, encode_integer, encode_variable
from ev3proto.schema.header import HEADER_SIZE, read_memory, with_length, write_memory
from ev3proto.tables.encoding import CONSTANT

TYPE_OFFSET = 4


class Advised:
    """A frame and a finding in it."""

    def __init__(self, frame: bytes, finding: Finding, dialect: str = "official") -> None:
        self.frame = frame
        self.finding = finding
        self._dialect = dialect
        self.stated = int.from_bytes(frame[:2], "little")
        self._shift = 0

    def frames(self) -> Iterator[tuple[str, bytes, int]]:
        """Yields the applied advice, the resulting frame, and the offset of the finding in it.

        Yields nothing if the help does not name a number.
        """
        for pattern, doing in _DOINGS:
            for found in re.finditer(pattern, self.finding.help):
                for data in doing(self, *found.groups()):
                    yield found[0], data, self.finding.offset + self._shift
                    self._shift = 0

    # Changes

    def spliced(self, start: int, length: int, data: bytes) -> bytes:
        """Returns the frame with other bytes at an offset."""
        self._shift = len(data) - length if start < self.finding.offset else 0
        frame = self.frame[:start] + data + self.frame[start + length :]
        stated = self.stated + len(data) - length
        return min(max(stated, 0), 0xFFFF).to_bytes(2, "little") + frame[2:]

    @property
    def operations(self) -> tuple[Operation, ...]:
        """The operations of the frame, up to the end that its length field gives."""
        end = min(max(self.stated + 2, HEADER_SIZE), len(self.frame))
        message = ev3proto.parse(with_length(self.frame[2:end]), strict=False, dialect=self._dialect)
        return message.operations if isinstance(message, DirectCommand) else ()

    def argument(self, name: str | None = None) -> Argument:
        """Returns the argument that the finding is about, or another one of the same operation."""
        at = self.finding.offset
        for operation in self.operations:
            if operation.offset <= at < operation.offset + operation.length:
                known = [*([operation.cmd] if operation.cmd else []), *operation.arguments]
                return next(it for it in known if (it.name == name if name else it.offset == at))
        raise AssertionError(f"no argument at {at} in {self.frame.hex()}")

    def operation(self) -> Operation:
        """The operation that the finding is about."""
        return next(it for it in self.operations if it.offset == self.finding.offset)

    def with_number(self, value: int, name: str | None = None) -> bytes:
        """Returns the frame with another number for an argument, in as many bytes as before if possible.

        name  another parameter of the operation than that of the finding
        """
        start, length = self.finding.offset, self.finding.length
        if name is not None:
            argument = self.argument(name)
            start, length = argument.offset, argument.length
        return self.spliced(start, length, _again(self.frame[start : start + length], value))


def _again(raw: bytes, value: int) -> bytes:
    encoding = ENCODINGS[raw[0]] if raw else None
    if encoding is None or encoding.kind != CONSTANT:
        return encode_integer(value)
    try:
        data = encode_as(encoding.name, value)
    except BuildError:
        return encode_integer(value)
    return data if len(data) == len(raw) else encode_integer(value)


Doing = Callable[..., Iterator[bytes]]


def _length(at: Advised, number: str) -> Iterator[bytes]:
    yield int(number).to_bytes(2, "little") + at.frame[2:]


def _omit_last(at: Advised, number: str) -> Iterator[bytes]:
    if at.finding.code == "E103":
        yield at.frame[: len(at.frame) - int(number)]
    else:
        argument = at.argument()
        yield at.spliced(argument.offset + argument.length - 1 - int(number), int(number), b"")


def _type(at: Advised, number: str) -> Iterator[bytes]:
    yield at.frame[:TYPE_OFFSET] + bytes((int(number, 16),)) + at.frame[TYPE_OFFSET + 1 :]


def _types(at: Advised, *numbers: str) -> Iterator[bytes]:
    for number in numbers:
        yield from _type(at, number)


def _nop(at: Advised, number: str) -> Iterator[bytes]:
    memory = bytes(2) if at.finding.help.startswith("add two bytes") else b""
    start = HEADER_SIZE if memory else at.finding.offset
    yield at.spliced(start, len(at.frame) - start, memory + bytes((int(number, 16),)))


def _memory(at: Advised, number: str, scope: str | None = None) -> Iterator[bytes]:
    globals_, locals_ = read_memory(at.frame)
    scope = scope or re.findall(r"(global|local) memory", at.finding.message)[0]
    size = 0 if number == "none" else int(number)
    sizes = (size, locals_) if scope == "global" else (globals_, size)
    yield at.frame[:HEADER_SIZE] + write_memory(*sizes) + at.frame[HEADER_SIZE + 2 :]


def _variable(
    at: Advised, letter: str, index: str, asked: str | None = None, scope: str | None = None
) -> Iterator[bytes]:
    argument = at.argument()
    variable = Variable("global" if letter == "G" else "local", int(index), argument.form.handle, argument.form.address)
    data = at.spliced(argument.offset, argument.length, encode_variable(variable))
    if asked is not None:
        (data,) = _memory(Advised(data, at.finding), asked, scope)
    yield data


def _interval(at: Advised, low: str, high: str) -> Iterator[bytes]:
    code = at.finding.code
    if code == "E801":
        for number in range(int(low, 16), int(high, 16) + 1):
            yield at.spliced(HEADER_SIZE, 1, bytes((number,)))
    elif code == "E806":
        for number in range(int(low, 16), int(high, 16) + 1):
            yield at.spliced(at.finding.offset, 1, bytes((number,)))
    else:
        for number in (int(low), int(high), (int(low) + int(high)) // 2):
            yield at.with_number(number)


def _one_of(at: Advised, listed: str) -> Iterator[bytes]:
    for number in re.findall(r"(-?\d+) [A-Za-z_]\w*", listed):
        yield at.with_number(int(number))


def _beside(at: Advised, number: str) -> Iterator[bytes]:
    if at.finding.parameter is not None:
        yield at.with_number(int(number))


def _count(at: Advised, name: str, number: str) -> Iterator[bytes]:
    yield at.with_number(int(number), name)


def _shorten(at: Advised, number: str) -> Iterator[bytes]:
    """Shortens what is too long to fewer characters or bytes."""
    start = at.finding.offset + (1 if at.finding.code == "E502" else 0)
    shorter = at.spliced(start, int(number), b"")
    if at.finding.message.startswith("the message has"):  # a mailbox has its length in the two bytes before it
        count = (at.finding.length - int(number)).to_bytes(2, "little")
        shorter = shorter[: start - 2] + count + shorter[start:]
    yield shorter


def _jump(at: Advised, number: str) -> Iterator[bytes]:
    if at.finding.help.endswith("write it as a constant"):
        yield at.spliced(at.finding.offset, at.finding.length, encode_integer(int(number)))
    else:
        yield at.with_number(int(number))


def _label(at: Advised, number: str) -> Iterator[bytes]:
    jump = next(it for it in at.operations if it.offset < at.finding.offset < it.offset + it.length)
    yield at.spliced(jump.offset + jump.length, 0, ev3proto.operation("LABEL", int(number)).raw)


def _raw(at: Advised, digits: str) -> Iterator[bytes]:
    yield at.spliced(at.finding.offset, at.finding.length, bytes.fromhex(digits))


def _encoded(at: Advised, number: str, digits: str) -> Iterator[bytes]:
    """Encodes a raw byte, or two of them; a label is replaced as a whole."""
    value, first = int(number), at.frame[at.finding.offset]
    length = at.finding.length
    if value & 0xFF == first:
        length = 1 if -128 <= value < 256 else 2
    yield at.spliced(at.finding.offset, length, bytes.fromhex(digits))


def _await_sound(at: Advised, number: str) -> Iterator[bytes]:
    operation = at.operation()
    yield at.spliced(operation.offset + operation.length, 0, bytes((int(number, 16),)))


def _await_motors(at: Advised, number: str) -> Iterator[bytes]:
    operation = at.operation()
    layer, ports = (bytes(argument.raw) for argument in operation.arguments[:2])
    yield at.spliced(operation.offset + operation.length, 0, bytes((int(number, 16),)) + layer + ports)


def _update(at: Advised, opcode: str, cmd: str) -> Iterator[bytes]:
    operation = at.operation()
    yield at.spliced(operation.offset + operation.length, 0, bytes((int(opcode, 16), int(cmd, 16))))


def _as_float(at: Advised, number: str) -> Iterator[bytes]:
    argument = at.argument()
    yield at.spliced(argument.offset, argument.length, encode_as("LC4", float(number)))


_HEX = "0x([0-9A-F]{2})"

_DOINGS: tuple[tuple[str, Doing], ...] = (
    (r"set (?:the length|it) to (\d+)", _length),
    (r"omit the last (\d+) bytes?", _omit_last),
    (rf"use {_HEX} for a direct command with a reply, {_HEX} for one without, {_HEX} or {_HEX} for a system", _types),
    (rf"use type {_HEX}", _type),
    (rf"NOP \({_HEX}\)", _nop),
    (r"(?<!and )request (?:at most )?(\d+) bytes? of (global|local) memory", _memory),
    (r"(?<!and )request (?:at most )?(\d+|none)\b(?! bytes? of)", _memory),
    (r"use ([GL])V\((\d+)\)(?:, and request (\d+) bytes? of (global|local) memory)?", _variable),
    (r"use (?:a sub-command, )?0x([0-9A-F]{2}) to 0x([0-9A-F]{2})", _interval),
    (r"use (-?\d+) to (-?\d+)", _interval),
    (r"use one of (.*)", _one_of),
    (r" or (-?\d+) \(", _beside),
    (r"set ([A-Z]\w*) to (-?\d+)", _count),
    (r"shorten (?:it|its folder) by (\d+)", _shorten),
    (r"(?:use|or) (-?\d+) to (?:run|skip|jump)", _jump),
    (r"write (-?\d+) if these bits", _beside),
    (r"put LABEL (\d+)", _label),
    (r"values that follow, (\d+) or more", _beside),
    (r"write it as ([0-9A-F]{2}(?: [0-9A-F]{2})*)", _raw),
    (r"(-?\d+) as ([0-9A-F]{2}(?: [0-9A-F]{2})*)", _encoded),
    (rf"put SOUND_READY \({_HEX}\)", _await_sound),
    (r"use (\d+) (?:for|if port) [A-D]", _beside),
    (rf"put OUTPUT_START \({_HEX}\)", _await_motors),
    (rf"put OUTPUT_READY \({_HEX}\)", _await_motors),
    (r"put UI_DRAW.UPDATE \(([0-9A-F]{2}):([0-9A-F]{2})\)", _update),
    (r"write (-?\d+) as a float", _as_float),
)
"""The action for each number, by the words around it."""
