"""Assembles statements into program objects: allocates memory, encodes values, sizes jumps.

`ev3proto.program` makes an image of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import accumulate
from typing import NamedTuple

from ev3proto.errors import BuildError, counted, near_misses
from ev3proto.schema.instructions import CMD, OperationSchema, instruction_set
from ev3proto.tables import OPCODES
from ev3proto.tables.constants import CONSTANTS
from ev3proto.tables.declaration import DIALECTS, Direction, Parameter, Type
from ev3proto.tables.encoding import BITS, GLOBAL, LOCAL, RANGES
from ev3proto.tables.program import MAX_MEMORY, MAX_OBJECTS, MAX_PARAMETERS
from ev3proto.tables.source import (
    BASIC_NAMES,
    PARAMETER_WORDS,
    SIZED_PARAMETERS,
    SIZED_WORDS,
    VARIABLE_WORDS,
)
from ev3proto.text.assembly.errors import MOST_ERRORS, SourceError, cited
from ev3proto.text.assembly.names import Callee, LocalNames, Meaning, Memory, Names, Variable, firmware_names, is_object
from ev3proto.text.assembly.notations import OF_BASIC, Notation, Rules
from ev3proto.text.assembly.parsing import Parser
from ev3proto.text.assembly.settings import OPEN, OWN, ImageSettings
from ev3proto.text.assembly.syntax import (
    Call,
    Closing,
    Define,
    Distance,
    Label,
    Marked,
    Name,
    NamedEncoding,
    Number,
    Opening,
    Raw,
    Statement,
    Unchecked,
    Value,
    VariableDeclaration,
    WrittenArgument,
)
from ev3proto.text.assembly.values import Encoder, Piece, encoded_parts, integer, part_sizes

_OPCODES = {opcode.name: bytes((opcode.number,)) for opcode in OPCODES}
_PARAMETERS = {opcode.name: opcode.parameters for opcode in OPCODES if not opcode.commands}
_OF_COMMANDS = {(opcode.name, command.name): command.parameters for opcode in OPCODES for command in opcode.commands}
_CALL, _RETURN, _OBJECT_END, _OBJECT_TRIG = "CALL", "RETURN", "OBJECT_END", "OBJECT_TRIG"
_THREAD, _SUBCALL, _BLOCK = "vmthread", "subcall", "block"

Declared = tuple[Direction, Type, int]
"""A parameter that a subcall declares: its direction, its type, its bytes."""


class AssembledObject(NamedTuple):
    """An object of a program."""

    owner: int
    triggers: int
    local_size: int
    parameters: tuple[Declared, ...] | None  # the parameters that a subcall declares; None for other objects
    declared: int  # parameter count in the code (of the last object with this name)
    code: bytes  # its encoded operations
    shares: int | None  # number of the object whose code it uses; None if the code is its own
    last: int  # index of the last object with this name
    settings: Mapping[str, int]  # its settings in the source


class AssembledProgram(NamedTuple):
    """A program."""

    settings: ImageSettings  # the settings in the source
    global_size: int  # bytes of global memory
    objects: list[AssembledObject]  # the objects, in the order of their numbers


@dataclass
class _Object:
    """An object under construction."""

    head: Opening  # its head
    settings: Mapping[str, int]
    memory: Memory
    alias_of: str | None = None  # the name of the object whose code it uses under another head
    body: list[Statement] = field(default_factory=list)  # its statements
    names: LocalNames = field(default_factory=LocalNames)
    parameters: list[Declared] = field(default_factory=list)
    parts: list[Piece] = field(default_factory=list)  # bytes, and jumps that are not sized yet
    labels: dict[str, int] = field(default_factory=dict)  # index of the part after each label, by name
    last: str = ""  # name of the last operation
    code: bytes = b""  # the joined parts

    @property
    def table_size(self) -> int:
        """Bytes of the table of its parameters."""
        sizes = (2 if kind is Type.STRING else 1 for _, kind, _ in self.parameters)
        return 1 + sum(sizes) if self.head.word == _SUBCALL else 0


class ProgramAssembler:
    """Assembles the objects of one source."""

    def __init__(self, text: str, notation: Notation, coding: str, rules: Rules | None = None) -> None:
        parser = Parser(text, notation, coding)
        self.errors: list[SourceError] = []  # its errors
        self.warnings = parser.warnings  # (offset, message) of valid but probably unintended code
        self._notation = notation
        self._settings = ImageSettings(text, self.errors)
        # The notation alone decides where variables are.
        said = self._settings.rules
        self._rules = rules or said or notation.rules
        if said is not None and notation.folds and said is not OF_BASIC:
            self._keep(SourceError(0, f"the source says {said.name}: it is not in EV3 Basic's dialect"))
        self._names = Names(notation, lambda define, _: self._encoder.meaning(define.value))
        self._encoder = Encoder(self._names, self._rules, self.warnings)
        self._globals = Memory(GLOBAL, notation, MAX_MEMORY)
        self._objects: list[_Object] = []
        self._declarations: list[VariableDeclaration] = []
        self._group(parser.statements())

    def _keep(self, error: SourceError) -> None:
        if len(self.errors) < MOST_ERRORS:
            self.errors.append(error)

    # Grouping by object

    def _group(self, statements: Iterable[Statement | SourceError]) -> None:
        current: _Object | None = None
        defines: list[Define] = []
        for statement in statements:
            try:
                current = self._placed(statement, current, defines)
            except SourceError as error:
                self._keep(error)
            if len(self.errors) >= MOST_ERRORS:
                return
        if current is not None and not self.errors:
            # An earlier error may have consumed the closing brace.
            self._keep(SourceError(current.head.at, f"{current.head.word} {current.head.name} has no }} at its end"))
        if not self.errors:
            self._declare_all(defines)

    def _placed(
        self, statement: Statement | SourceError, current: _Object | None, defines: list[Define]
    ) -> _Object | None:
        """Puts a statement where it belongs, and returns the object in which the next one is."""
        match statement:
            case SourceError():
                raise statement
            case Closing(at):
                if current is None:
                    raise SourceError(at, "unexpected }: no { is open")
                return None
            case Opening():
                return self._opened(statement, current)
            case Define() if current is None or self._notation.last_counts:
                if current is not None:
                    self.warnings.append((statement.at, "a define inside an object is known in the whole file"))
                defines.append(statement)
            case VariableDeclaration(scope=scope) if current is None or scope == GLOBAL:
                self._declarations.append(statement)
            case _ if current is None:
                what = cited(getattr(statement, "name", "this"))
                raise SourceError(statement.at, f"{what} is outside of any object: put it into a vmthread or a subcall")
            case _:
                current.body.append(statement)
        return current

    def _opened(self, head: Opening, current: _Object | None) -> _Object:
        """Begins an object, and returns the one in which the next statement is."""
        if current is None:
            return self._begun(head)
        if not head.is_alias and not (self._notation.folds and head.word == _SUBCALL):
            raise SourceError(head.at, f"a {head.word} cannot begin in another object: a }} is missing before it")
        self._begun(head, current)
        return current

    def _begun(self, head: Opening, current: _Object | None = None) -> _Object:
        if len(self._objects) >= MAX_OBJECTS:
            raise SourceError(head.at, f"a program has at most {MAX_OBJECTS} objects")
        memory = Memory(LOCAL, self._notation, MAX_MEMORY)
        new = _Object(head, self._settings.before(head.at), memory, current.head.name if current else None)
        self._objects.append(new)
        return new

    # Names of the file

    def _declare_all(self, defines: Sequence[Define]) -> None:
        if self._notation.folds:
            self._number_by_mention()
        for define in defines:
            with self._keeping(define.at):
                self._check_new(define.at, define.name)
            self._names.defines[define.name] = define
        for number, one in enumerate(self._objects, 1):
            with self._keeping(one.head.at):
                self._declare_object(number, one)
        for one in self._objects:
            of = self._implementation(one)
            if of is not one and one.head.word == _SUBCALL:
                callee = self._names.objects[one.head.name]
                self._names.objects[one.head.name] = callee._replace(parameters=_declared_by(of.body))
        for declaration in self._declarations:
            with self._keeping(declaration.at):
                self._global(declaration)

    @contextmanager
    def _keeping(self, at: int) -> Iterator[None]:
        """Keeps an error, so that later ones are found, too; a BuildError is at the given place."""
        try:
            yield
        except SourceError as error:
            self._keep(error)
        except BuildError as error:
            self._keep(SourceError(at, str(error)))

    def _number_by_mention(self) -> None:
        """Numbers the objects by the first mention of their names, as EV3 Basic does."""
        order: dict[str, None] = {}
        for one in sorted(self._objects, key=lambda one: one.head.at):
            order.setdefault(one.head.name)
            for statement in one.body:
                if isinstance(statement, Call):
                    parameters = self._parameters(statement)
                    for parameter, argument in zip(parameters, statement.arguments, strict=False):
                        if is_object(parameter) and isinstance(argument.value, Name):
                            order.setdefault(argument.value.text)
        numbers = {name: number for number, name in enumerate(order)}
        self._objects.sort(key=lambda one: numbers[one.head.name])

    def _implementation(self, one: _Object) -> _Object:
        """Returns the object whose code an object uses."""
        if one.alias_of is not None:
            return next(it for it in self._objects if it.head.name == one.alias_of)
        shared = one.settings.get("shares", 0)
        return self._objects[shared - 1] if 0 < shared <= len(self._objects) else one

    def _check_new(self, at: int, name: str) -> None:
        """Refuses a name that is declared twice, or warns; also warns about the firmware's names."""
        if name in firmware_names() and not self._notation.folds:
            self.warnings.append((at, f"{name} is a name of the firmware, which means something else from here on"))
        names = self._names
        if name in names.defines or name in names.objects or name in names.globals:
            self._check_twice(at, f"{cited(name)} is declared already")

    def _check_twice(self, at: int, reason: str) -> None:
        if not self._notation.last_counts:
            raise SourceError(at, reason)
        self.warnings.append((at, f"{reason}: the last one counts"))

    def _declare_object(self, number: int, one: _Object) -> None:
        self._check_new(one.head.at, one.head.name)
        parameters = None
        if one.head.word == _SUBCALL:
            parameters = _declared_by(one.body)
            if len(parameters) > MAX_PARAMETERS:
                count = len(parameters)
                raise SourceError(one.head.at, f"a subcall has at most {MAX_PARAMETERS} parameters, not {count}")
        self._names.objects[one.head.name] = Callee(number, one.head.at, one.head.word, parameters)

    def _global(self, item: VariableDeclaration) -> None:
        self._check_new(item.at, item.name)
        if item.word in PARAMETER_WORDS:
            raise SourceError(item.at, f"{item.word} declares a parameter, which only a subcall has")
        self._names.globals.setdefault(item.name, []).append(self._place(item, self._globals))

    def _place(self, item: VariableDeclaration, memory: Memory) -> Variable:
        """Returns the memory of a declaration."""
        kind = VARIABLE_WORDS.get(item.word, Type.DATA8)
        if item.word in PARAMETER_WORDS:
            kind = PARAMETER_WORDS[item.word][1]
        count = 1
        is_array = item.word in SIZED_WORDS or item.word in SIZED_PARAMETERS
        if item.size is not None:
            count = self._encoder.whole(item.size, f"the size of {cited(item.name)}", 0, (1 << 31) - 1)
        place = memory.place(item.at, item.name, kind, count, is_array)
        if is_array and place.start % place.width:
            self.warnings.append(
                (
                    item.at,
                    f"{item.name} starts at {place.start}, which is not a multiple of {place.width}: its elements are"
                    " not aligned, and the brick refuses to read them",
                )
            )
        return place

    # Objects

    def program(self) -> AssembledProgram | None:
        """Returns the program, or None if there are errors."""
        self._declare_labels()
        for one in self._objects:
            if one.alias_of is None and not self.errors:
                self._body(one)
        if self.errors:
            return None
        self._join()
        owners = self._owners()
        entries: list[AssembledObject] = []
        first: dict[tuple[object, ...], int] = {}
        for number, one in enumerate(self._objects, 1):
            with self._keeping(one.head.at):
                entries.append(self._entry(number, one, owners, first))
        return AssembledProgram(self._settings, self._globals.size, entries)

    def _declare_labels(self) -> None:
        """Declares all labels. Objects of the same name have them in common."""
        known: dict[str, dict[str, int]] = {}
        for one in self._objects:
            own: dict[str, int] = {}
            for statement in one.body:
                if isinstance(statement, Label):
                    if statement.name in own:
                        with self._keeping(statement.at):
                            self._check_twice(statement.at, f"the label {cited(statement.name)} is set already")
                    own[statement.name] = statement.at
            one.names.labels = known.setdefault(one.head.name, {})
            one.names.labels |= own

    def _join(self) -> None:
        """Encodes all code. A label that several objects of one name have is that of the last of them."""
        has_it: dict[tuple[str, str], _Object] = {}
        for one in self._objects:
            has_it |= dict.fromkeys(((one.head.name, label) for label in one.labels), one)
        labels: dict[str, dict[str, int]] = {}
        starts: list[tuple[int, list[int]]] = []
        at = 0
        for one in self._objects:
            name = one.head.name
            own = {label: part for label, part in one.labels.items() if has_it[name, label] is one}
            sizes: list[int] = []
            with self._keeping(one.head.at):
                sizes = part_sizes(one.parts, own, self._rules, one.names.labels)
            start = at + one.table_size
            ends = list(accumulate(sizes, initial=start))
            labels.setdefault(name, {}).update((label, ends[part]) for label, part in own.items())
            starts.append((start, sizes))
            at = ends[-1]
        for one, (start, sizes) in zip(self._objects, starts, strict=True):
            with self._keeping(one.head.at):
                one.code = encoded_parts(one.parts, sizes, labels[one.head.name], start)

    def _body(self, one: _Object) -> None:
        self._names.local = one.names
        for statement in one.body:
            with self._keeping(statement.at):
                self._statement(one, statement)
            if len(self.errors) >= MOST_ERRORS:
                break
        if OPEN not in one.settings:
            # LEGO's assembler adds a RETURN to one that is written, too.
            is_written = one.last == _RETURN and not self._notation.by_line
            if one.head.word == _SUBCALL and not is_written:
                one.parts.append(_OPCODES[_RETURN])
            one.parts.append(_OPCODES[_OBJECT_END])

    def _statement(self, one: _Object, statement: Statement) -> None:
        match statement:
            case Call():
                self._operation(_with_cmd(statement), one)
            case Label(at, name):
                if name in firmware_names() and not self._notation.folds:
                    is_hiding = self._notation.last_counts
                    what = "in this object it means the label" if is_hiding else "jumps to it mean that"
                    self.warnings.append((at, f"{name} is a name of the firmware: {what}"))
                one.labels[name] = len(one.parts)
            case VariableDeclaration():
                self._local(statement, one)
            case Define(at, name):
                if name in one.names.places or name in one.names.defines:
                    raise SourceError(at, f"{cited(name)} is declared already")
                one.names.defines[name] = statement
            case Raw(_, data):
                one.parts.append(data)
                one.last = ""

    def _local(self, item: VariableDeclaration, one: _Object) -> None:
        if item.name in one.names.places or item.name in one.names.defines:
            self._check_twice(item.at, f"{cited(item.name)} is declared already")
        is_parameter = item.word in PARAMETER_WORDS
        if is_parameter and one.head.word != _SUBCALL:
            raise SourceError(item.at, f"a {one.head.word} has no parameters; only a subcall has")
        if is_parameter and one.parts:
            raise SourceError(item.at, "parameters have to be declared in front of the first operation")
        place = self._place(item, one.memory)
        one.names.places[item.name] = place
        if is_parameter:
            direction, kind = PARAMETER_WORDS[item.word]
            one.parameters.append((direction, kind, place.end - place.start))

    # Operations

    def _name(self, call: Call) -> str:
        """Returns the firmware's name of an operation; EV3 Basic renames some."""
        return BASIC_NAMES.get(call.name, call.name) if self._notation.folds else call.name

    def _parameters(self, call: Call) -> tuple[Parameter, ...]:
        return _parameters_of(call._replace(name=self._name(call)))

    def _operation(self, call: Call, one: _Object) -> None:
        name = self._name(call)
        code = _OPCODES.get(name)
        if code is None:
            raise SourceError(call.at, f"unknown operation {cited(call.name)}{near_misses(call.name, _OPCODES)}")
        one.last = name
        if name == _CALL:
            one.parts += [code, *self._call(call)]
            return
        parameters = self._parameters(call)
        pieces: list[Piece] = [code]
        meant: list[Meaning | None] = []
        for number, argument in enumerate(call.arguments):
            parameter = parameters[number] if number < len(parameters) else None
            value = argument.value
            if number == 0 and self._notation.folds and len(parameters) > 1 and isinstance(value, Name):
                # The name of a CMD is part of the operation's, even if a variable has that name, too.
                value = _as_number(value, parameters)
            piece, meaning = self._argument(value, parameter)
            pieces.append(piece)
            meant.append(meaning)
        one.parts += pieces
        if not self._notation.folds:
            self.warnings += _of_operation(call, name, meant)

    def _call(self, call: Call) -> Iterator[Piece]:
        """Yields the arguments of a CALL, with the parameter count of a subcall that is named."""
        if not call.arguments:
            self.warnings.append((call.at, "CALL needs the name of the subcall, and then its arguments"))
            return
        first, *others = [argument.value for argument in call.arguments]
        piece, callee = self._argument(first, self._parameters(call)[0])
        yield piece
        declared = callee.parameters if isinstance(callee, Callee) else None
        if declared is not None:
            yield integer(len(declared), self._rules)
            if len(others) != len(declared):
                wanted = counted(len(declared), "argument")
                shown = cited(first.text) if isinstance(first, Name) else "the subcall"
                reason = f"{shown} takes {wanted}, not {len(others)}"
                if not self._notation.last_counts:
                    raise SourceError(call.at, reason)
                self.warnings.append((call.at, reason))
        elif callee is not None and not isinstance(callee, Callee):
            reason = "CALL takes a subcall by its name; anything else has its count written, too"
            self.warnings.append((first.at, reason))
        meant: list[Meaning | None] = []
        for value in others:
            piece, meaning = self._argument(value, None)
            yield piece
            meant.append(meaning)
        if declared is not None and not self._notation.folds:
            self.warnings += _of_call(call, meant, declared)

    def _argument(self, value: Value, parameter: Parameter | None) -> tuple[Piece, Meaning | None]:
        """Returns the bytes or jump of an argument, and its meaning; None if that is not checked."""
        if isinstance(value, Raw | NamedEncoding | Marked | Distance | Unchecked):
            return self._encoder.argument(value), None
        meaning = self._encoder.meaning(value, parameter)
        return self._encoder.encoded(meaning, value), meaning

    # The program

    def _entry(
        self, number: int, one: _Object, owners: dict[str, int], first: dict[tuple[object, ...], int]
    ) -> AssembledObject:
        head, said, of = one.head, one.settings, self._implementation(one)
        owner = said.get("owner", owners.get(head.name, 1) if head.word == _BLOCK else 0)
        triggers = said.get("triggers", 0 if head.word == _THREAD else 1)
        size = said.get("locals", (of if one.alias_of else one).memory.size)
        shares = said.get("shares") if of is one else self._objects.index(of) + 1
        code = b""
        if shares is not None and (of is one or (one.alias_of is None and shares >= number)):
            raise SourceError(head.at, f"{head.name} cannot share the code of object {shares}")
        parameters = tuple(one.parameters) if head.word == _SUBCALL else None
        if shares is None:
            code = one.code
            key = (owner, triggers, size, parameters, code)
            if self._rules.shares and OWN not in said:
                shares = first.get(key)
            first.setdefault(key, number)
        named = self._names.objects[head.name]
        count, last = len(named.parameters or ()), named.number - 1
        return AssembledObject(owner, triggers, size, parameters, count, code, shares, last, said)

    def _owners(self) -> dict[str, int]:
        """Returns the owner of each block by name: the only object that triggers it, else the first."""
        triggering: dict[str, set[int]] = {}
        for number, one in enumerate(self._objects, 1):
            for statement in one.body:
                if isinstance(statement, Call) and statement.name == _OBJECT_TRIG and statement.arguments:
                    first = statement.arguments[0].value
                    if isinstance(first, Name):
                        triggering.setdefault(first.text, set()).add(number)
        return {name: numbers.pop() if len(numbers) == 1 else 1 for name, numbers in triggering.items()}


def _with_cmd(call: Call) -> Call:
    """Returns a call with the CMD as its first argument: `UI_WRITE.LED(...)` is how ev3proto prints it."""
    family, dot, command = call.name.partition(".")
    if not dot or family not in _OPCODES:
        return call
    cmd = WrittenArgument(None, Name(call.at, command))
    return call._replace(name=family, arguments=(cmd, *call.arguments))


def _parameters_of(call: Call) -> tuple[Parameter, ...]:
    """Returns the parameters of an operation, CMD first; none for an unknown operation."""
    if call.name in _PARAMETERS:
        return _PARAMETERS[call.name]
    first = call.arguments[0].value if call.arguments else None
    return (CMD.parameter, *_OF_COMMANDS.get((call.name, first.text if isinstance(first, Name) else ""), ()))


def _declared_by(body: Iterable[Statement]) -> tuple[tuple[Direction, Type], ...]:
    """Returns direction and type of the parameters that a subcall declares."""
    words = (it.word for it in body if isinstance(it, VariableDeclaration))
    return tuple(PARAMETER_WORDS[word] for word in words if word in PARAMETER_WORDS)


def _as_number(value: Name, parameters: Sequence[Parameter]) -> Value:
    """Returns a CMD as its number, so that no variable hides its name."""
    number = firmware_names().get(value.text)
    return Number(value.at, number) if isinstance(number, int) and parameters[0] is CMD.parameter else value


# Warnings about types, which are errors in lmsasm; `!` before a value omits them

_UNTYPED = (Type.ARRAY_TYPED, Type.LABEL, Type.HANDLE)

Warnings = Iterator[tuple[int, str]]
Meant = Sequence[Meaning | None]
"""The meanings of an operation's arguments; None for one that is not checked."""


def _of_operation(call: Call, name: str, values: Meant) -> Warnings:
    """Yields warnings about an operation, its CMD included."""
    number = _OPCODES[name][0]
    arguments = [argument.value for argument in call.arguments]
    schemas = [one.opcodes[number] for one in map(instruction_set, DIALECTS)]
    families = [one.families[number] for one in map(instruction_set, DIALECTS)]
    if any(families):
        if not values:
            yield call.at, f"the CMD of {name} is missing"
            return
        cmd, first = values[0], arguments[0]
        if not isinstance(cmd, int):
            return
        schemas = [family.commands.get(cmd) for family in families if family is not None]
        if isinstance(first, Name) and (name, first.text) not in _OF_COMMANDS:
            yield first.at, f"{cited(first.text)} is not a CMD of {name}, and counts as the number {cmd}"
        if not any(schemas):
            yield call.at, f"{name} has no CMD {cmd}"
        arguments, values = arguments[1:], values[1:]
    schema = next((schema for schema in schemas if schema is not None), None)
    if schema is not None:
        yield from _of_parameters(call, schema, arguments, values)


def _of_call(call: Call, values: Meant, declared: Sequence[tuple[Direction, Type]]) -> Warnings:
    """Yields warnings about the arguments of a CALL."""
    parameters = [Parameter(f"parameter {number}", kind, "", way) for number, (way, kind) in enumerate(declared, 1)]
    for parameter, argument, value in zip(parameters, call.arguments[1:], values, strict=False):
        yield from _of_one("CALL", parameter, argument.value, value)


def _of_parameters(call: Call, schema: OperationSchema, arguments: Sequence[Value], values: Meant) -> Warnings:
    name, fixed = schema.declaration.name, schema.fixed
    wanted: int | None = len(fixed)
    if schema.tail is not None:
        count = values[len(fixed) - 1] if len(values) >= len(fixed) else None
        wanted = len(fixed) + count if isinstance(count, int) else None
    if wanted is not None and len(values) != wanted:
        yield call.at, f"{name} takes {counted(wanted, 'argument')}, not {len(values)}"
    for one, argument, value in zip(fixed, arguments, values, strict=False):
        yield from _of_one(name, one.parameter, argument, value)


def _of_one(operation: str, parameter: Parameter, argument: Value, value: Meaning | None) -> Warnings:
    reason = _wrong_place(parameter, value) if isinstance(value, Variable) else _wrong_constant(parameter, value)
    if reason is not None:
        shown = f": {cited(argument.text)}" if isinstance(argument, Name) else ""
        yield argument.at, f"{parameter.name} of {operation} {reason}{shown}"


def _wrong_constant(parameter: Parameter, value: Meaning | None) -> str | None:
    """Returns what lmsasm has against a constant: its type, not its meaning, which `semantics.judgement` judges."""
    kind = parameter.type
    if not isinstance(value, int | float | str):
        return None
    if parameter.direction is Direction.OUT:
        return "is an output, and what is written into a constant is lost"
    if isinstance(value, float):
        return None if kind in (Type.DATAF, Type.ARRAY_TYPED) else f"is a {parameter.label}, not a float"
    if isinstance(value, str):
        is_text = kind in (Type.STRING, Type.ARRAY_TYPED, Type.DATA8) and not parameter.counts
        return None if is_text else f"is a {parameter.label}, not a string"
    return _wrong_number(parameter, value)


_NARROW = {kind: RANGES[kind] for kind in (Type.DATA8, Type.DATA16)}


def _wrong_number(parameter: Parameter, value: int) -> str | None:
    kind = parameter.type
    if kind is Type.DATAF:
        if value in (0, CONSTANTS["DATAF_NAN"]):
            return None
        return "is a DATAF, and a whole number means its bits there, while floats end in F"
    if kind is Type.STRING:
        return "is a string, not a number"
    limits = None if parameter.counts else _NARROW.get(kind)
    if parameter.unsigned and value in BITS[kind]:
        return None
    if limits is not None and not limits.low <= value <= limits.high and value != limits.nan & (limits.high * 2 + 1):
        return f"is a {kind}, which reaches from {limits.low} to {limits.high}: it cannot be {value}"
    return None


def _wrong_place(parameter: Parameter, place: Variable) -> str | None:
    kind = parameter.type
    if kind in _UNTYPED or parameter.counts or place.type is kind:
        return None
    if kind is Type.STRING:
        is_text = place.type in (Type.STRING, Type.DATA8, Type.HANDLE)
        return None if is_text else f"is a string, not a {place.type}"
    if place.type is Type.STRING:
        return None if kind is Type.DATA8 else f"is a {kind}, not a string"
    if place.type.size != kind.size or (place.type is Type.DATAF) is not (kind is Type.DATAF):
        return f"is a {kind}, not a {place.type}"
    return None
