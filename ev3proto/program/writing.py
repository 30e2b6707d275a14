"""Writes programs as sources in the strict dialect that assemble to the same bytes.

Values that the default rules reproduce are written plainly; the others name their encoding (`LC2(5)`) or are bytes
(`bytes(...)`). What is unusual about the image or an object is a comment such as `// ev3proto: locals 12`, which other
assemblers ignore.
"""

from __future__ import annotations

import math
import struct
from array import array
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

from ev3proto.errors import BuildError
from ev3proto.messages import Argument, Operation
from ev3proto.program.image import READ_IN_PART, Program
from ev3proto.program.objects import CodeObject
from ev3proto.program.parameters import ProgramParameter, code_of
from ev3proto.schema.argument import encode_as
from ev3proto.semantics.flow import starts_of
from ev3proto.tables.declaration import Type
from ev3proto.tables.encoding import CONSTANT, GLOBAL, JUMP, LOCAL, TEXT
from ev3proto.tables.program import ALIGNED_SIZES, RELEASE_VERSION, VERSIONS, ObjectKind
from ev3proto.tables.source import BYTES, PARAMETER_WORDS, SIZED_WORDS, VARIABLE_WORDS
from ev3proto.text.assembly.disassembly import (
    NO_LABELS,
    TEXT_ESCAPES,
    Labels,
    OperationWriter,
    end_of,
    float_literal,
    goal_of,
    hex_lines,
    in_macro,
    labels_of,
    text_literal,
)
from ev3proto.text.assembly.names import OBJECT_PARAMETER, firmware_names
from ev3proto.text.assembly.notations import BASIC, OF_BASIC, OF_EV3_G, OF_LEGO, Rules
from ev3proto.text.assembly.settings import GAP, MARK, OPEN, OWN
from ev3proto.text.assembly.values import integer, variable
from ev3proto.text.phrases import spaced_hex

_OBJECT_END, _RETURN, _CALL = "OBJECT_END", "RETURN", "CALL"
_NAMES = {ObjectKind.THREAD: "thread", ObjectKind.SUBCALL: "sub", ObjectKind.BLOCK: "block"}
_EV3_G_VERSIONS = (0x00, 0x39)
_LOCAL_NAME, _GLOBAL_NAME, _PARAMETER_NAME, _LABEL_NAME = "l", "g", "p", "to"
_NAN_NAME = "DATAF_NAN"
_BASIC_ESCAPES = {
    letter: escape for letter, escape in TEXT_ESCAPES.items() if (escape, letter) in (BASIC.escapes or ())
}
_PARAMETER_BY_KIND = {
    # Parameters of 16 bits and handles have the same code.
    value: word
    for word, value in reversed(PARAMETER_WORDS.items())
    if value[1] is not Type.HANDLE
}


def source_of(program: Program) -> str:
    """Returns the source of a program, in the strict dialect; `assemble` makes the same image of it.

    Args:
        program: The program.

    Returns:
        The source.

    Raises:
        BuildError: The program has faults: it was read in part only.
        TypeError: It is not a Program.
    """
    return "".join(f"{line}\n" for line in source_lines(program))


def source_lines(program: Program) -> Iterator[str]:
    """Returns an iterator over the lines of `source_of`. Raises the same."""
    if not isinstance(program, Program):
        raise TypeError(f"a source is made of a Program, not of {type(program).__name__}")
    if program.fault is not None:
        raise BuildError(READ_IN_PART.format(fault=program.fault))
    return Writer(program).lines()


class ObjectCode:
    """The written form of the code of one object."""

    def __init__(self, part: CodeObject) -> None:
        self.part = part
        self.word = str(part.kind)  # vmthread, subcall or block
        self.raw = b""  # the bytes of the parameter table, if it cannot be declared
        self.rest = part.rest  # bytes after the operations
        # for each kind of memory: the type by which the steps use each index
        self.uses: dict[str, dict[int, Type]] = {GLOBAL: {}, LOCAL: {}}
        self.steps: Sequence[Operation] = part.operations  # the operations to be written
        if part.shares is not None:
            self.steps, self.rest, self.is_open = (), b"", True
            return
        if part.kind is ObjectKind.SUBCALL and (part.flaw.headless or not all(map(_is_usual, part.parameters))):
            # The word subcall would add a parameter table of its own.
            self.word = str(ObjectKind.THREAD)
            self.raw = part.code[: _table_size(part.parameters)]
        self.is_open = bool(self.rest) or not self._leave_end_out()  # neither RETURN nor OBJECT_END is added
        for step in self.steps:
            _add_uses(step, self.uses)

    def _leave_end_out(self) -> bool:
        """Returns whether the code ends as the assembler ends it, and removes that end from the steps."""
        steps = self.steps
        if not steps or steps[-1].name != _OBJECT_END:
            return False
        if self.word != ObjectKind.SUBCALL:
            self.steps = steps[:-1]
            return True
        if len(steps) < 2 or steps[-2].name != _RETURN:
            return False
        is_written = len(steps) > 2 and steps[-3].name == _RETURN
        is_target = steps[-1].offset in {goal for goal in map(goal_of, steps) if goal is not None}
        self.steps = steps[:-1] if is_written or is_target else steps[:-2]
        return True

    @property
    def places(self) -> Sequence[int]:
        """Offsets that can have a label: those of the steps, and the end if the assembler adds an operation there."""
        found = array("I", starts_of(self.steps))
        if not self.is_open:
            found.append(end_of(self.steps[-1]) if self.steps else self.part.operations[0].offset)
        return found


class Writer(OperationWriter):
    """Writes one program."""

    separator = ", "

    def __init__(self, program: Program) -> None:
        super().__init__(rules_of(program))
        self._program = program
        self.codes = [ObjectCode(part) for part in program.objects]  # how the code of each object is written
        self.names = [f"{_NAMES[part.kind]}{part.number}" for part in program.objects]  # of the objects
        self._locals_end = 0
        self._globals: dict[int, str] = {}
        self._locals: dict[int, str] = {}
        self._labels = NO_LABELS
        self._seen: dict[tuple[int, int, int, bytes], int] = {}
        self._declared = list(self._global_lines())

    def lines(self) -> Iterator[str]:
        """Writes the whole source."""
        program = self._program
        defects = program.defects
        writer = VERSIONS.get(program.version)
        rules = _RULES[self.rules]
        yield f"// by the rules of {rules}{f'; its version is that of {writer}' if writer else ''}"
        yield f"{MARK} version 0x{program.version:02X}"
        yield f"{MARK} {self.rules.name}"
        for offset, data in defects.gaps:
            yield f"{MARK} {GAP} {offset} {spaced_hex(data)}"
        yield from self._declared
        for code, name in zip(self.codes, self.names, strict=True):
            yield ""
            yield from self._object(code, name)

    def _global_lines(self) -> Iterator[str]:
        """Yields the declarations of globals, and remembers their names."""
        uses: dict[int, Type] = {}
        for code in self.codes:
            for index, kind in code.uses[GLOBAL].items():
                uses[index] = _wider(uses.get(index), kind)
        size = self._program.global_size
        if size > MOST_DECLARED:
            yield f"{MARK} globals {size}"
        for one in declared(0, size, uses):
            self._globals[one.index] = f"{_GLOBAL_NAME}{one.index}"
            yield _declaration(one, self._globals[one.index])

    # Objects

    def _object(self, code: ObjectCode, name: str) -> Iterator[str]:
        part = code.part
        declarations = list(self._declarations(code))
        yield from self._settings(code)
        yield f"{code.word} {name}"
        yield "{"
        yield from (f"  {line}" for line in declarations)
        if code.raw:
            yield from _raw(code.raw)
        self._labels = labels_of(code.steps, code.places, self.rules, _LABEL_NAME)
        steps = code.steps
        for step in steps:
            label = self.label_at(step.offset)
            if label is not None:
                yield f"{label}:"
            yield f"  {self.step(step)}"
        if not code.is_open:
            end = end_of(steps[-1]) if steps else part.operations[0].offset
            if end in self._labels.names:
                yield f"{self._labels.names[end]}:"
        if code.rest:
            yield from _raw(code.rest)
        yield "}"

    def _settings(self, code: ObjectCode) -> Iterator[str]:
        part = code.part
        headers, offsets = self._program.defects.headers, self._program.defects.offsets
        settings = (
            (part.owner != 0, f"owner {part.owner}"),
            (part.triggers != (code.word != ObjectKind.THREAD), f"triggers {part.triggers}"),
            (headers is not None, f"header {headers and headers[part.number - 1]}"),
            (offsets is not None, f"offset {part.offset}"),
            (part.shares is not None, f"shares {part.shares}"),
            (part.shares is None and code.is_open, OPEN),
            (self._locals_end != part.local_size, f"locals {part.local_size}"),
            (self._is_own(part), OWN),
        )
        yield from (f"{MARK} {text}" for is_there, text in settings if is_there)

    def _is_own(self, part: CodeObject) -> bool:
        """Returns whether an object would share the code of an earlier one if its source did not say otherwise."""
        if not self.rules.shares or part.shares is not None:
            return False
        key = (part.owner, part.triggers, part.local_size, part.code)
        return self._seen.setdefault(key, part.number) != part.number

    def _declarations(self, code: ObjectCode) -> Iterator[str]:
        """Yields the declarations of parameters and locals, and remembers their names and their end."""
        part = code.part
        self._locals = {}
        self._locals_end = 0
        if part.shares is not None:
            return
        if code.word == ObjectKind.SUBCALL:
            for number, (parameter, place) in enumerate(zip(part.parameters, part.places, strict=True)):
                word = _PARAMETER_BY_KIND[parameter.direction, parameter.type]
                name = f"{_PARAMETER_NAME}{number}"
                self._locals.setdefault(place.offset, name)
                self._locals_end = place.offset + place.size
                yield f"{word} {name}{'' if parameter.size is None else f' {parameter.size}'}"
        for one in declared(self._locals_end, part.local_size, code.uses[LOCAL]):
            self._locals[one.index] = f"{_LOCAL_NAME}{one.index}"
            yield _declaration(one, self._locals[one.index])
        self._locals_end = max(self._locals_end, min(part.local_size, MOST_DECLARED))

    def begin(self, code: ObjectCode) -> None:
        """Prepares the names of an object's variables and labels, to show single operations."""
        for _ in self._declarations(code):
            pass
        self._labels = labels_of(code.steps, code.places, self.rules, _LABEL_NAME)

    def label_at(self, offset: int) -> str | None:
        """Returns the label at an offset of the current object."""
        return self._labels.names.get(offset)

    # Operations

    def step(self, step: Operation) -> str:
        """Writes one operation of the current object as a statement."""
        return self.line(step, self._labels)

    def arguments(self, operation: Operation, labels: Labels) -> Iterable[str]:
        """Writes the arguments of an operation; of a CALL by name, without the number of parameters."""
        arguments = operation.arguments
        if operation.name != _CALL or arguments[0].kind != CONSTANT:
            return super().arguments(operation, labels)
        callee = self._callee(arguments)
        if callee is not None:
            return [callee, *map(self.argument, arguments[2:])]
        # Its name would imply the number of parameters.
        return [self.number(arguments[0], str(arguments[0].value)), *map(self.argument, arguments[1:])]

    def _callee(self, arguments: Sequence[Argument]) -> str | None:
        """Returns the subcall's name, if that implies the first two arguments."""
        number, count = arguments[0], arguments[1]
        if not 0 < int(number.value) <= len(self.codes):
            return None
        callee = self.codes[int(number.value) - 1]
        if callee.word != ObjectKind.SUBCALL or number.raw != integer(int(number.value), self.rules):
            return None
        # An object that shares code has the parameters of the object that owns the code.
        shares = callee.part.shares
        declaring = callee if shares is None else self.codes[shares - 1]
        declares = declaring.part.parameters if declaring.word == ObjectKind.SUBCALL else ()
        if count.raw != integer(len(declares), self.rules) or len(arguments) - 2 != len(declares):
            return None
        return self.names[int(number.value) - 1]

    def argument(self, argument: Argument) -> str:
        """Writes one argument of the current object."""
        if argument.is_variable:
            return self._variable(argument)
        if argument.kind == TEXT:
            return self._text(argument)
        if argument.form.handle or argument.form.address:
            return _bytes(argument.raw)
        if isinstance(argument.value, float):
            return self._float(argument.raw)
        return self._whole(argument, int(argument.value))

    def _whole(self, argument: Argument, value: int) -> str:
        parameter = argument.parameter
        if argument.kind == JUMP or integer(value, self.rules) != argument.raw:
            return self.number(argument, str(value))
        symbol = None if parameter.enum is None else parameter.enum.name_of(value)
        if symbol is not None and firmware_names().get(symbol) == value:
            return symbol
        if parameter.type is Type.DATAF:
            # Other assemblers refuse an integer there, and ours warns about it.
            return f"!{value}" if value else _FLOAT_ZEROS[self.rules.long_floats]
        if parameter.name == OBJECT_PARAMETER and 0 < value <= len(self.names):
            return self.names[value - 1]
        return str(value)

    def _text(self, argument: Argument) -> str:
        text = str(argument.value)
        shown = text_literal(text, _BASIC_ESCAPES if self.rules is OF_BASIC else TEXT_ESCAPES)
        return shown if argument.raw == encode_as("LCS_OLD", text) else in_macro(argument, shown)

    def _float(self, raw: bytes) -> str:
        """Writes a float in LC4, the only encoding that is recognised as a float."""
        bits = int.from_bytes(raw[1:], "little", signed=True)
        (value,) = struct.unpack("<f", raw[1:])
        if not math.isfinite(value):
            return _NAN_NAME if firmware_names()[_NAN_NAME] == bits else f"!0x{bits & 0xFFFFFFFF:08X}"
        text = float_literal(value)
        return text if self.rules.long_floats or integer(bits, self.rules) == raw else f"LCF({text})"

    def _variable(self, argument: Argument) -> str:
        form, index = argument.form, int(argument.value)
        name = (self._globals if argument.kind == GLOBAL else self._locals).get(index)
        is_handle = form.handle and not form.address
        usual = variable(argument.kind, index, self.rules, form.handle, form.address)
        if name is not None and usual == argument.raw and (is_handle or not form.address):
            return f"@{name}" if is_handle else name
        return in_macro(argument, str(index) if index < 1 << 31 else f"0x{index:08X}")


_FLOAT_ZEROS = {True: "0", False: "0.0F"}
"""Zero as a float, by whether all floats are long."""


def _declaration(variable: DeclaredVariable, name: str) -> str:
    return f"{variable.word} {name}" if variable.count is None else f"{variable.word} {name} {variable.count}"


def _bytes(data: bytes) -> str:
    return f"{BYTES}({spaced_hex(data)})"


def _raw(data: bytes) -> Iterator[str]:
    return (f"  {BYTES}({line})" for line in hex_lines(data))


# Facts about objects and operations


def _is_usual(parameter: ProgramParameter) -> bool:
    """Returns whether a keyword declares such a parameter."""
    return parameter.code == code_of(parameter.direction, parameter.type) and (
        (parameter.size is not None) is (parameter.type is Type.STRING)
    )


def _table_size(parameters: Sequence[ProgramParameter]) -> int:
    return 1 + sum(1 if parameter.size is None else 2 for parameter in parameters)


_BUFFERS = (Type.STRING, Type.ARRAY_TYPED, Type.LABEL)


def _add_uses(step: Operation, uses: Mapping[str, dict[int, Type]]) -> None:
    """Adds the types by which an operation uses local and global memory."""
    for argument in step.arguments:
        found = uses.get(argument.kind)
        if found is None:
            continue
        parameter = argument.parameter
        kind = parameter.type
        if argument.form.handle:
            kind = Type.HANDLE
        elif kind is Type.STRING or parameter.length is not None:
            kind = Type.STRING
        elif kind in _BUFFERS:
            kind = Type.DATA8
        index = int(argument.value)
        found[index] = _wider(found.get(index), kind)


def _wider(known: Type | None, kind: Type) -> Type:
    """Returns the type of a place with two uses: a buffer if either is one, else the wider number."""
    if known is None or kind is Type.STRING:
        return kind
    return kind if known is not Type.STRING and kind.size > known.size else known


_RULES = {
    OF_LEGO: "LEGO's assembler, labels of three bytes",
    OF_EV3_G: "EV3-G, labels as short as they can be",
    OF_BASIC: "EV3 Basic, labels of five bytes forwards",
}


def rules_of(program: Program) -> Rules:
    """Returns the rules that fit a program best, by its jumps: those of LEGO's assembler, of EV3-G, or of EV3 Basic."""
    fits = dict.fromkeys(_RULES, 0)
    for jump, is_forwards in _jumps(program):
        for rules in fits:
            fits[rules] += _fits(rules, jump, is_forwards)
    usual = OF_EV3_G if program.version in _EV3_G_VERSIONS else OF_LEGO
    best = max(fits.values())
    shares = any(part.shares is not None for part in program.objects)
    likely = ((usual, not shares), (OF_BASIC, program.version == RELEASE_VERSION), (OF_EV3_G, shares))
    chosen = [rules for rules, is_likely in likely if is_likely and fits[rules] == best]
    return next(iter(chosen), max(fits, key=lambda rules: fits[rules]))


def _jumps(program: Program) -> Iterator[tuple[Argument, bool]]:
    """Yields the jumps of a program, and whether they lead forwards."""
    for part in program.objects:
        for step in part.operations if part.shares is None else ():
            goal = goal_of(step)
            if goal is not None:
                yield step.arguments[-1], goal > step.offset


def _fits(rules: Rules, jump: Argument, is_forwards: bool) -> bool:
    """Returns whether rules encode a jump in that way."""
    encoding = _ENCODINGS.get((rules, is_forwards))
    return jump.raw == integer(int(jump.value), rules) if encoding is None else jump.encoding == encoding


_ENCODINGS = {(OF_LEGO, False): "LC2", (OF_LEGO, True): "LC2", (OF_BASIC, True): "LC4"}
"""The encodings of jumps that do not depend on their distance, by whether they lead forwards."""


# Variables for a compiled program: every index that is used gets a name. The declarations take exactly the memory that
# the image requests, and alignment moves none of them.

_WORDS = {kind: word for word, kind in VARIABLE_WORDS.items() if word not in SIZED_WORDS}
MOST_DECLARED = 1 << 24
"""Maximum memory with named variables, in bytes: more than a brick has."""

_BYTES, _STRING, _ONE = "ARRAY8", "DATAS", "DATA8"


@dataclass(frozen=True, slots=True)
class DeclaredVariable:
    """A declaration: its index, its keyword, the size of an array in bytes."""

    index: int
    word: str
    count: int | None


def declared(start: int, end: int, uses: Mapping[int, Type]) -> list[DeclaredVariable]:
    """Returns variables for the memory from `start` to `end`, one at every place that is used there.

    `uses` has the type of each place by its index; STRING for a buffer of unknown size.
    """
    end = max(start, min(end, MOST_DECLARED))
    places = sorted(index for index in uses if start <= index < end)
    found: list[DeclaredVariable] = []
    at = start
    for index, following in pairwise((*places, end)):
        found += _filled(at, index)
        variable, at = _at(index, following, uses[index])
        found.append(variable)
    return [*found, *_filled(at, end)]


def _at(index: int, following: int, kind: Type) -> tuple[DeclaredVariable, int]:
    """Returns the variable at an index, and the next free index."""
    room = following - index
    width = kind.size
    if kind in _WORDS and 1 < width <= room and index % width == 0:
        return DeclaredVariable(index, _WORDS[kind], None), index + width
    if kind is Type.STRING and room > 1 and not (room in ALIGNED_SIZES and index % room):
        return DeclaredVariable(index, _STRING, room), following
    return DeclaredVariable(index, _ONE, None), index + 1


def _filled(start: int, end: int) -> Iterator[DeclaredVariable]:
    """Yields variables for memory that no operation uses."""
    size = end - start
    if size > 1 and size in ALIGNED_SIZES and start % size:
        yield DeclaredVariable(start, _ONE, None)
        start, size = start + 1, size - 1
    if size == 1:
        yield DeclaredVariable(start, _ONE, None)
    elif size:
        yield DeclaredVariable(start, _BYTES, size)
