"""Statements to an image: memory laid out, values encoded, jumps measured, the header written."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction

from ev3proto.errors import BuildError, counted
from ev3proto.program.image import Entry, image_of, regular_offsets
from ev3proto.program.objects import Defects
from ev3proto.program.parameters import ProgramParameter, code_of, table_bytes
from ev3proto.program.source.checks import Checks, named_number
from ev3proto.program.source.encoding import (
    JUMP_SIZES,
    LABEL,
    integer,
    jump,
    long_float,
    marked,
    string,
    variable,
)
from ev3proto.program.source.errors import SourceError
from ev3proto.program.source.jumps import shrink, starts
from ev3proto.program.source.names import Callee, Goal, LocalNames, Meaning, Names, ProgramVariable, builtin_names
from ev3proto.program.source.numbers import single_of, wrapped
from ev3proto.program.source.settings import ObjectSettings, SettingsReader
from ev3proto.program.source.statements import (
    DefineStatement,
    EncodedValue,
    Float,
    Item,
    LabelStatement,
    MarkedName,
    Name,
    Number,
    ObjectSource,
    OperationStatement,
    RawArgument,
    Statement,
    Text,
    Unchecked,
    Value,
    VariableStatement,
)
from ev3proto.schema.argument import encode_as, encode_float, encode_label, with_bits
from ev3proto.tables import OPCODES
from ev3proto.tables.declaration import DATA16, Type
from ev3proto.tables.encoding import GLOBAL, LOCAL, STRING_CODING
from ev3proto.tables.program import DEFAULT_VERSION, MAX_MEMORY, MAX_OBJECTS, MAX_PARAMETERS, aligned
from ev3proto.tables.source import (
    OLD_WORDS,
    PARAMETER_WORDS,
    SIZED_PARAMETERS,
    SIZED_WORDS,
    VARIABLE_WORDS,
)
from ev3proto.text.assembly.errors import MOST_ERRORS
from ev3proto.text.assembly.symbols import suggestion

_OPCODES = {opcode.name: bytes((opcode.number,)) for opcode in OPCODES}
_CALL, _RETURN, _OBJECT_END, _OBJECT_TRIG = "CALL", "RETURN", "OBJECT_END", "OBJECT_TRIG"
_THREAD, _SUBCALL, _BLOCK = "vmthread", "subcall", "block"
_MARKS = {"HND": "@", "ADR": "&"}
_MOST_JUMP = 1 << 15


@dataclass(frozen=True, slots=True)
class PendingJump:
    """An argument that is a label.

    at    where it stands in the source
    name  the label
    form  the encoding that is asked for, None for the usual one
    """

    at: int
    name: str
    form: str | None


class ObjectVariables:
    """Globals, or the locals of one object: variables one after the other."""

    def __init__(self, scope: str) -> None:
        self.scope = scope
        self.size = 0

    def place(self, at: int, size: int, kind: Type, is_array: bool) -> ProgramVariable:
        """The next variable. Raises SourceError where no header can ask for so much."""
        index = aligned(self.size, size)
        self.size = index + size
        if self.size > MAX_MEMORY:
            raise SourceError(at, f"a program has at most {MAX_MEMORY} bytes of {self.scope} memory")
        return ProgramVariable(at, self.scope, index, size, kind, is_array)


@dataclass
class Body:
    """The code of one object while it is made.

    parts   bytes, and jumps that nobody can measure yet
    labels  by name: the number of the part that a label stands in front of
    """

    source: ObjectSource
    settings: ObjectSettings
    names: LocalNames = field(default_factory=LocalNames)
    memory: ObjectVariables = field(default_factory=lambda: ObjectVariables(LOCAL))
    parameters: list[ProgramParameter] = field(default_factory=list)
    parts: list[bytes | PendingJump] = field(default_factory=list)
    labels: dict[str, int] = field(default_factory=dict)
    last: str = ""

    @property
    def has_code(self) -> bool:
        """Whether any statement stood in it so far."""
        return bool(self.parts)


class Assembler:
    """Makes the image of one source.

    errors and warnings are those of the parser, to which its own are added.
    """

    def __init__(
        self,
        items: list[Item],
        settings: SettingsReader,
        errors: list[SourceError],
        warnings: list[tuple[int, str]],
        *,
        is_strict: bool,
        shortest: bool,
        version: int | None,
    ) -> None:
        self.errors = errors
        self.warnings = warnings
        self._items = items
        self._settings = settings
        self._is_strict = is_strict
        self._shortest = shortest or settings.file.shortest
        self._version = version
        self._names = Names(is_strict, warnings)
        self._globals = ObjectVariables(GLOBAL)
        self._checks = Checks(warnings, is_strict=is_strict)
        self._objects: list[ObjectSource] = []
        self._of_objects: list[ObjectSettings] = []
        self._memo: dict[str, Meaning] = {}

    def image(self) -> bytes:
        """The image; what it is worth where there are errors nobody can say."""
        self._declare_all()
        if self.errors:
            return b""
        bodies = [
            self._body(source, settings) for source, settings in zip(self._objects, self._of_objects, strict=True)
        ]
        if self.errors:
            return b""
        entries = self._entries(bodies)
        if self.errors:
            return b""
        return self._laid_out(entries)

    # Names of the file

    def _declare_all(self) -> None:
        for item in self._items:
            try:
                match item:
                    case DefineStatement():
                        self._define(item)
                    case ObjectSource():
                        self._object(item)
                    case VariableStatement():
                        pass
            except SourceError as error:
                self._keep(error)
        self._call_shared()
        for item in self._items:
            if isinstance(item, VariableStatement):
                try:
                    self._global(item)
                except SourceError as error:
                    self._keep(error)

    def _keep(self, error: SourceError) -> None:
        if len(self.errors) < MOST_ERRORS:
            self.errors.append(error)

    def _check_new(self, at: int, name: str) -> None:
        """Strict refuses a name twice; both dialects are warned of names that the firmware has."""
        if name in builtin_names():
            self.warnings.append((at, f"{name} is a name of the firmware, which means something else from here on"))
        names = self._names
        if name in names.defines or name in names.objects or name in names.globals:
            self._check_twice(at, f"{name[:40]} is declared already")

    def _check_twice(self, at: int, reason: str) -> None:
        """Strict refuses what is there already. LEGO's dialect takes the last one, for variables the last one above."""
        if self._is_strict:
            raise SourceError(at, reason)
        self.warnings.append((at, f"{reason}: the last one counts"))

    def _define(self, item: DefineStatement) -> None:
        self._check_new(item.at, item.name)
        self._names.defines[item.name] = item

    def _object(self, item: ObjectSource) -> None:
        self._check_new(item.at, item.name)
        if len(self._objects) >= MAX_OBJECTS:
            raise SourceError(item.at, f"a program has at most {MAX_OBJECTS} objects")
        self._objects.append(item)
        self._of_objects.append(self._settings.before(item.at))
        parameters = None
        if item.kind == _SUBCALL:
            declared = (it.word for it in item.body if isinstance(it, VariableStatement))
            parameters = [PARAMETER_WORDS[word] for word in declared if word in PARAMETER_WORDS]
            if len(parameters) > MAX_PARAMETERS:
                raise SourceError(item.at, f"a subcall has at most {MAX_PARAMETERS} parameters, not {len(parameters)}")
        self._names.objects[item.name] = Callee(len(self._objects), item.at, item.kind, parameters)

    def _call_shared(self) -> None:
        """An object that uses the code of another has the parameters of that."""
        for source, settings in zip(self._objects, self._of_objects, strict=True):
            shared = settings.numbers.get("shares", 0)
            if source.kind == _SUBCALL and 0 < shared <= len(self._objects):
                other = self._names.objects[self._objects[shared - 1].name]
                self._names.objects[source.name].parameters = other.parameters or []

    def _global(self, item: VariableStatement) -> None:
        self._check_new(item.at, item.name)
        place = self._place(item, self._globals, LocalNames())
        self._names.globals.setdefault(item.name, []).append(place)

    def _place(self, item: VariableStatement, memory: ObjectVariables, local: LocalNames) -> ProgramVariable:
        """The memory of a declaration."""
        kind = VARIABLE_WORDS.get(item.word, Type.DATA8)
        if item.word in PARAMETER_WORDS:
            kind = PARAMETER_WORDS[item.word][1]
        count = 1
        is_array = item.word in SIZED_WORDS or item.word in SIZED_PARAMETERS
        if is_array or item.word in OLD_WORDS:
            assert item.size is not None
            count = self._names.number(item.size, local, f"the size of {item.name}")
            if count < 0:
                raise SourceError(item.size.at, f"the size of {item.name} cannot be {count}")
        width = 1 if kind is Type.STRING else kind.size
        place = memory.place(item.at, width * count, kind, is_array)
        if is_array and place.index % width:
            self.warnings.append(
                (
                    item.at,
                    f"{item.name} starts at {place.index}, which is no multiple of {width}: its elements are not"
                    " aligned, and the brick refuses to read them",
                )
            )
        return place

    # Objects

    def _body(self, source: ObjectSource, settings: ObjectSettings) -> Body:
        body = Body(source, settings)
        for statement in source.body:
            if isinstance(statement, LabelStatement):
                if statement.name in body.names.labels:
                    try:
                        self._check_twice(statement.at, f"the label {statement.name[:40]} is set already")
                    except SourceError as error:
                        self._keep(error)
                body.names.labels[statement.name] = statement.at
        for statement in source.body:
            try:
                self._statement(statement, body)
            except SourceError as error:
                self._keep(error)
            except BuildError as error:
                self._keep(SourceError(statement.at, str(error)))
            if len(self.errors) >= MOST_ERRORS:
                break
        if not settings.is_open:
            self._end(body)
        return body

    def _end(self, body: Body) -> None:
        """What every object ends with. LEGO's assembler adds a RETURN to one that is written, too."""
        if body.source.kind == _SUBCALL and not (self._is_strict and body.last == _RETURN):
            body.parts.append(_OPCODES[_RETURN])
        body.parts.append(_OPCODES[_OBJECT_END])

    def _statement(self, statement: Statement, body: Body) -> None:
        match statement:
            case OperationStatement():
                self._step(statement, body)
            case LabelStatement(at, name):
                if name in builtin_names():
                    what = "jumps to it mean that" if self._is_strict else "in this object it means the label"
                    self.warnings.append((at, f"{name} is a name of the firmware: {what}"))
                body.labels[name] = len(body.parts)
            case VariableStatement():
                self._local(statement, body)
            case DefineStatement():
                if statement.name in body.names.places or statement.name in body.names.defines:
                    raise SourceError(statement.at, f"{statement.name[:40]} is declared already")
                body.names.defines[statement.name] = statement
            case RawArgument(_, data):
                body.parts.append(data)
                body.last = ""

    def _local(self, item: VariableStatement, body: Body) -> None:
        if item.name in body.names.places or item.name in body.names.defines:
            self._check_twice(item.at, f"{item.name[:40]} is declared already")
        if item.word in PARAMETER_WORDS:
            if body.source.kind != _SUBCALL:
                raise SourceError(item.at, f"a {body.source.kind} has no parameters; only a subcall has")
            if body.has_code:
                raise SourceError(item.at, "parameters have to be declared in front of the first operation")
        place = self._place(item, body.memory, body.names)
        body.names.places[item.name] = place
        if item.word in PARAMETER_WORDS:
            direction, kind = PARAMETER_WORDS[item.word]
            code = code_of(direction, DATA16 if kind is Type.HANDLE else kind)
            body.parameters.append(ProgramParameter(code, place.size & 0xFF if kind is Type.STRING else None))

    # Operations

    def _step(self, step: OperationStatement, body: Body) -> None:
        code = _OPCODES.get(step.name)
        if code is None:
            raise SourceError(step.at, f"there is no operation {step.name[:40]}{suggestion(step.name, _OPCODES)}")
        parts = body.parts
        parts.append(code)
        if step.name == _CALL:
            self._call(step, body)
        else:
            values: list[Meaning | None] = []
            for place, argument in enumerate(step.arguments):
                try:
                    part, meaning = self._argument(argument, body)
                except SourceError:
                    number = named_number(step, place)
                    if number is None:
                        raise
                    part, meaning = integer(number), number
                parts.append(part)
                values.append(meaning)
            self._checks.operation(step, values)
        body.last = step.name

    def _call(self, step: OperationStatement, body: Body) -> None:
        """A CALL. Of a subcall by name, the number of its parameters is written too."""
        if not step.arguments:
            self.warnings.append((step.at, "CALL needs the name of the subcall, and then its arguments"))
            return
        first, *others = step.arguments
        part, callee = self._argument(first, body)
        body.parts.append(part)
        if isinstance(callee, Callee) and callee.parameters is not None:
            body.parts.append(integer(len(callee.parameters)))
            if len(others) != len(callee.parameters):
                wanted = counted(len(callee.parameters), "argument")
                reason = f"{_shown(first)} takes {wanted}, and here are {len(others)}"
                if self._is_strict:
                    raise SourceError(step.at, reason)
                self.warnings.append((step.at, reason))
        elif callee is not None and not isinstance(callee, Callee):
            self.warnings.append(
                (first.at, "CALL takes a subcall by its name; anything else has its count written, too")
            )
        values: list[Meaning | None] = []
        for argument in others:
            part, meaning = self._argument(argument, body)
            body.parts.append(part)
            values.append(meaning)
        if isinstance(callee, Callee) and callee.parameters is not None:
            self._checks.call(step, values, callee)

    def _argument(self, value: Value, body: Body) -> tuple[bytes | PendingJump, Meaning | None]:
        """The bytes of an argument, or the jump that it is; and what it means, None for what is not to be checked."""
        # Names and numbers are nearly all there is, and matching their classes takes half of all time.
        kind = type(value)
        if kind is Name:
            text: str = value.text  # type: ignore[union-attr]
            meaning: Meaning = body.names.places.get(text) or self._names.meaning(text, value.at, body.names)
            return self._encoded(meaning, value.at), meaning
        if kind is Number:
            number: int = value.value  # type: ignore[union-attr,assignment]
            return integer(number), number
        match value:
            case Unchecked(_, inner):
                return self._argument(inner, body)[0], None
            case MarkedName(at, sign, name):
                place_of = self._names.meaning(name.text, name.at, body.names)
                if not isinstance(place_of, ProgramVariable):
                    raise SourceError(at, f"{name.text[:40]} is no variable, and only one can stand after {sign}")
                if sign == "@" and place_of.type is not Type.HANDLE:
                    self.warnings.append((at, f"{name.text[:40]} is a {place_of.type}, and @ stands before a HANDLE"))
                return marked(place_of, sign), None
            case RawArgument(_, data):
                return data, None
            case EncodedValue():
                return self._form(value, body), None
        meaning = self._names.value(value, body.names)
        return self._encoded(meaning, value.at), meaning

    def _encoded(self, meaning: Meaning, at: int) -> bytes | PendingJump:
        if isinstance(meaning, int):
            return integer(meaning)
        if isinstance(meaning, ProgramVariable):
            return variable(meaning.scope, meaning.index)
        if isinstance(meaning, Goal):
            return PendingJump(at, meaning.name, None)
        if isinstance(meaning, Callee):
            return integer(meaning.number)
        if isinstance(meaning, Text):
            if 0 in meaning.data:
                raise SourceError(at, "a zero ends a string, so none can stand in it")
            return string(meaning.data)
        if isinstance(meaning, Float):
            return long_float(meaning.bits) if self._shortest else integer(meaning.bits)
        assert isinstance(meaning, Fraction)
        return integer(wrapped(int(meaning)))

    def _form(self, form: EncodedValue, body: Body) -> bytes | PendingJump:
        """A value in the encoding that is named."""
        name = form.name
        if name in _MARKS:
            inner = self._argument(form.value, body)[0]
            if not isinstance(inner, bytes):
                raise SourceError(form.at, f"{name} takes no label")
            return with_bits(inner, handle=name == "HND", address=name == "ADR")
        meaning = self._names.value(form.value, body.names)
        if isinstance(meaning, Goal):
            if name not in JUMP_SIZES:
                raise SourceError(form.at, f"{name} cannot hold the distance to a label")
            return PendingJump(form.at, meaning.name, name)
        if isinstance(meaning, ProgramVariable):
            if name[0] != ("G" if meaning.scope == GLOBAL else "L"):
                raise SourceError(form.at, f"{name} is not for {meaning.scope} variables")
            return encode_as(name, meaning.index)
        if isinstance(meaning, Callee):
            return encode_as(name, meaning.number)
        if isinstance(meaning, Text):
            return encode_as(name, meaning.data.decode(STRING_CODING))
        if isinstance(meaning, Float):
            return encode_float(single_of(meaning.bits)) if name == "LCF" else encode_as(name, meaning.bits)
        return encode_as(name, int(meaning) % (1 << 32) if name[1] == "V" else wrapped(int(meaning)))

    # Jumps

    def _code(self, body: Body) -> bytes:
        """The bytes of an object's code after its table of parameters."""
        jumps = [place for place, part in enumerate(body.parts) if isinstance(part, PendingJump)]
        if not jumps:
            return b"".join(body.parts)  # type: ignore[arg-type]
        sizes = [len(part) if isinstance(part, bytes) else JUMP_SIZES[part.form or LABEL] for part in body.parts]
        if self._shortest:
            free = {place: body.parts[place] for place in jumps}
            shrink(sizes, {place: body.labels[it.name] for place, it in free.items() if _is_free(it)})  # type: ignore[union-attr]
        at = starts(sizes)
        pieces: list[bytes] = list(body.parts)  # type: ignore[arg-type]
        for place in jumps:
            part = body.parts[place]
            assert isinstance(part, PendingJump)
            distance = at[body.labels[part.name]] - at[place + 1]
            if not -_MOST_JUMP <= distance < _MOST_JUMP and part.form != "LC4":
                self._keep(SourceError(part.at, f"{part.name[:40]} is {distance} bytes away: a jump reaches 32767"))
                return b""
            try:
                pieces[place] = encode_label(distance) if part.form == "LAB1" else jump(distance, sizes[place])
            except BuildError as error:
                self._keep(SourceError(part.at, f"{part.name[:40]} is {distance} bytes away: {error}"))
                return b""
        return b"".join(pieces)

    # The image

    def _entries(self, bodies: list[Body]) -> list[Entry]:
        entries: list[Entry] = []
        owners = self._owners(bodies)
        first: dict[tuple[int, int, int, bytes], int] = {}
        for number, body in enumerate(bodies, 1):
            source, said = body.source, body.settings
            owner = owners.get(source.name, 1) if source.kind == _BLOCK else 0
            owner = said.numbers.get("owner", owner)
            triggers = said.numbers.get("triggers", 0 if source.kind == _THREAD else 1)
            size = said.numbers.get("locals", body.memory.size)
            shares = said.numbers.get("shares")
            code = b""
            if shares is None:
                code = self._table(body) + self._code(body)
                key = (owner, triggers, size, code)
                if self._shortest and not said.is_own:
                    shares = first.get(key)
                first.setdefault(key, number)
            elif not 0 < shares < number:
                self._keep(SourceError(source.at, f"{source.name} cannot share the code of object {shares}"))
            entries.append(Entry(owner, triggers, size, code, shares))
        return entries

    def _table(self, body: Body) -> bytes:
        """The table of parameters. Of an object that is declared twice, both have the number of the last."""
        if body.source.kind != _SUBCALL:
            return b""
        table = table_bytes(body.parameters)
        last = self._names.objects[body.source.name].parameters or []
        return bytes((len(last),)) + table[1:]

    def _owners(self, bodies: list[Body]) -> dict[str, int]:
        """By the name of a block: the only object that triggers it, or else the first."""
        triggering: dict[str, set[int]] = {}
        for number, body in enumerate(bodies, 1):
            for statement in body.source.body:
                name = _triggered(statement)
                if name is not None:
                    triggering.setdefault(name, set()).add(number)
        return {name: numbers.pop() if len(numbers) == 1 else 1 for name, numbers in triggering.items()}

    def _laid_out(self, entries: list[Entry]) -> bytes:
        said = self._settings.file
        regular = list(regular_offsets(entries))
        offsets = [
            settings.numbers.get("offset", offset) for settings, offset in zip(self._of_objects, regular, strict=True)
        ]
        headers = [
            settings.numbers.get("header", offset) for settings, offset in zip(self._of_objects, offsets, strict=True)
        ]
        if len(self._names.objects) < len(entries):
            headers, entries = self._as_the_last(offsets, entries)
        defects = Defects(
            stated_size=said.numbers.get("size"),
            stated_count=said.numbers.get("count"),
            offsets=None if offsets == regular and not said.gaps else tuple(offsets),
            gaps=tuple(said.gaps),
            headers=None if headers == offsets else tuple(headers),
        )
        version = said.numbers.get("version", DEFAULT_VERSION) if self._version is None else self._version
        return image_of(version, said.numbers.get("globals", self._globals.size), entries, defects)

    def _as_the_last(self, offsets: list[int], entries: list[Entry]) -> tuple[list[int], list[Entry]]:
        """Offsets and entries where objects of the same name have the header of the last of them."""
        lasts = [self._names.objects[source.name].number - 1 for source in self._objects]
        return [offsets[last] for last in lasts], [
            entry._replace(local_size=entries[last].local_size) for entry, last in zip(entries, lasts, strict=True)
        ]


def _is_free(part: bytes | PendingJump) -> bool:
    """Whether nobody said how long a jump is to be."""
    return isinstance(part, PendingJump) and part.form is None


def _triggered(statement: Statement) -> str | None:
    """The name of the object that a statement triggers."""
    if not isinstance(statement, OperationStatement) or statement.name != _OBJECT_TRIG or not statement.arguments:
        return None
    first = statement.arguments[0]
    return first.text if isinstance(first, Name) else None


def _shown(value: Value) -> str:
    return value.text[:40] if isinstance(value, Name) else "the subcall"
