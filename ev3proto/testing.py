"""Hypothesis strategies for everything that can be on the wire, generated from the tables.

    from ev3proto.testing import frames, operations

    @given(frames())
    def test_my_decoder(frame): ...

For tests of a decoder, an emulator of the brick or a gateway. New entries in the tables are covered automatically.
Strategies of values (`operations`, `direct_commands`, ...) build with ev3proto. Strategies of bytes
(`encoded_arguments`, `raw_operations`) are assembled here, from the identification bytes alone, because ev3proto
only builds the shortest encodings, and a decoder has to read all of them.

`frames`, `accepted_frames` and `mutated_frames` take a `Choice`: only some operations, areas or message types.

In this project only `ev3proto sample` imports this module, since it needs hypothesis, an optional package.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterable, Mapping
from functools import cache, partial
from typing import Any, NamedTuple, TypeVar

from ev3proto.checking.checking import check
from ev3proto.compose import Draft, Global, Label, Local, command
from ev3proto.errors import BuildError, near_misses
from ev3proto.messages import (
    DaisyCommand,
    DaisyReply,
    DirectCommand,
    DirectReply,
    FieldValue,
    Message,
    Operation,
    SystemCommand,
    SystemReply,
    Variable,
)
from ev3proto.program.image import NewObject, Program, image_of
from ev3proto.program.image import parse as parse_program
from ev3proto.program.parameters import ProgramParameter, code_of, has_size, table_bytes
from ev3proto.schema import constructors
from ev3proto.schema.frame import parse
from ev3proto.schema.header import HEADER_SIZE, MEMORY_SIZE, MOST_IN_REPLY, build_frame, write_memory
from ev3proto.schema.instructions import operation
from ev3proto.semantics.domain import domain_of
from ev3proto.semantics.drafts.functions import drafts
from ev3proto.tables import AREAS, area_of, check_dialect, daisy
from ev3proto.tables import operations as operations_of
from ev3proto.tables.carriers import CARRIERS
from ev3proto.tables.declaration import Declaration, Direction, Parameter, Role, Type
from ev3proto.tables.encoding import (
    BITS,
    CONSTANT,
    GLOBAL,
    IDENTIFICATIONS,
    JUMP,
    LOCAL,
    NAN_FLOAT,
    SHORT,
    STRING_CODING,
    TEXT,
    limits_of,
)
from ev3proto.tables.enumerations import FORMAT_TYPES
from ev3proto.tables.frame import (
    COUNTERS,
    LENGTH_FIELD,
    MAX_FRAME,
    MAX_GLOBALS,
    MAX_LENGTH,
    MAX_LOCALS,
    TYPES_BY_KIND,
    MessageType,
)
from ev3proto.tables.program import PARAMETER_CODES, ObjectKind, kind_of
from ev3proto.tables.system import SYSTEM, SYSTEM_BY_NUMBER, FieldKind, SystemField, SystemStatus

try:
    from hypothesis import strategies as st
    from hypothesis.strategies import DrawFn, SearchStrategy
except ImportError as error:
    from ev3proto.extras import install_command

    raise ImportError(
        f"ev3proto.testing needs hypothesis, which is not installed: {install_command('sample')}"
    ) from error

__all__ = [
    "Choice",
    "accepted_frames",
    "choice",
    "daisy_messages",
    "direct_commands",
    "direct_replies",
    "encoded_arguments",
    "frames",
    "messages",
    "mutated_frames",
    "operations",
    "program_images",
    "programs",
    "raw_operations",
    "system_commands",
    "system_replies",
    "values_for",
]


def __dir__() -> list[str]:
    return __all__


T = TypeVar("T")

PlainValue = int | float | str | Variable
OperationValue = PlainValue | list[PlainValue]
"""A value that `ev3proto.operation` takes for one parameter."""

MOST_ELEMENTS = 6
LONG_LISTS = (31, 32, 127)
MOST_OPERATIONS = 6
MOST_TEXT = 12
"""Enough for every case, few enough to be quick and to shrink to something readable."""

# Values

_texts = st.text(st.characters(min_codepoint=1, max_codepoint=255), max_size=MOST_TEXT)
"""ISO-8859-1 without the zero that ends a string."""

_quarters = st.integers(-4000, 4000).map(lambda number: number / 4)
"""Typical numbers that a single holds exactly."""

_indexes = st.integers(0, 31) | st.integers(32, 1018) | st.integers(0, 0xFFFFFFFF)
"""Indexes of variables: those with a form of one byte, those of the largest memory, and all possible ones."""

_variables = st.builds(Variable, st.sampled_from((LOCAL, GLOBAL)), _indexes) | st.builds(
    Variable, st.sampled_from((LOCAL, GLOBAL)), _indexes, handle=st.booleans(), address=st.booleans()
)

_EDGES = (-0x8000, -0x7FFF, -129, -128, -127, -33, -32, -1, 0, 31, 32, 127, 128, 0x7FFF, 0x8000)
"""The numbers on both sides of each change of the shortest encoding."""


@cache
def _numbers(parameter: Parameter) -> SearchStrategy[int]:
    """Returns the numbers of a parameter's type: also "not a number", and all bits of one that is read unsigned."""
    limits = limits_of(parameter)
    assert limits is not None
    edges = [number for number in (*_EDGES, limits.low, limits.high) if limits.low <= number <= limits.high]
    if not parameter.counts:
        edges.append(limits.nan)
    numbers = st.integers(limits.low, limits.high) | st.sampled_from(edges)
    if parameter.unsigned:
        beyond = range(limits.high + 1, BITS[parameter.type].stop)
        numbers |= st.sampled_from((beyond[0], beyond[-1])) | st.sampled_from(beyond)
    return numbers


@cache
def _constants(parameter: Parameter) -> SearchStrategy[PlainValue]:
    """Returns the constants of a parameter: numbers, floats, names of an enumeration's members, texts."""
    if parameter.type is Type.STRING:
        return _texts
    if parameter.type is Type.DATAF:
        numbers: SearchStrategy[PlainValue] = st.floats(width=32) | _quarters
    else:
        numbers = _numbers(parameter)
    if parameter.enum is not None:
        numbers = st.sampled_from(list(parameter.enum.members)) | numbers
    # An array may be given as a string in the frame.
    return numbers | _texts if parameter.length is not None else numbers


def _element_of(parameter: Parameter, announced: Type | None) -> Parameter:
    """Returns an element of a list as a parameter; `announced` is the type that another argument gives."""
    return parameter.listed if announced is None else parameter.listed._replace(type=announced)


@cache
def values_for(parameter: Parameter) -> SearchStrategy[OperationValue]:
    """Returns values of one parameter, as `ev3proto.operation` takes them.

    Inputs get numbers in the type's range, floats, names of the enumeration's members, texts and variables; outputs
    get variables; lists get a list of these (whole numbers and variables if another argument gives the type).
    """
    if parameter.is_list:
        return _lists(_plain_values(parameter.listed))
    return _plain_values(parameter)


@cache
def _plain_values(parameter: Parameter) -> SearchStrategy[PlainValue]:
    return _variables if parameter.is_output else _constants(parameter) | _variables


def _announced(teller: Parameter, value: OperationValue) -> Type | None:
    """Returns the type of a list's elements by another argument's value; None if that is a variable or no type."""
    number = teller.enum.members[value] if teller.enum is not None and isinstance(value, str) else value
    return FORMAT_TYPES.get(number) if isinstance(number, int) else None


def _teller(declaration: Declaration) -> str | None:
    """Returns the name of the parameter that gives the type of the list at the end, or None."""
    return None if declaration.tail is None else declaration.tail.typed_by


def _lists(elements: SearchStrategy[T], *, is_text: bool = False) -> SearchStrategy[list[T]]:
    """Returns short lists, and now and then a long one, up to the longest; at most one text, as a mailbox has."""
    if is_text:
        return st.lists(elements, max_size=1)
    long = st.builds(lambda element, count: [element] * count, elements, st.sampled_from(LONG_LISTS))
    return st.integers(0, 9).flatmap(lambda draw: long if draw == 9 else st.lists(elements, max_size=MOST_ELEMENTS))


Names = str | tuple[str, ...] | None
"""One operation by name, some, or all of a dialect."""


@cache
def _declarations(dialect: str, names: Names) -> SearchStrategy[Declaration]:
    found = operations_of(dialect)
    if isinstance(names, str):
        return st.just(found[names])
    return st.sampled_from(list(found.values()) if names is None else [found[name] for name in names])


def _values(draw: DrawFn, declaration: Declaration, plain: Callable[[Parameter], SearchStrategy[Any]]) -> list[Any]:
    """Draws one value for each parameter; `plain` returns those of one parameter, or of an element of a list."""
    values: list[Any] = []
    announced: Type | None = None
    for parameter in declaration.parameters:
        if parameter.is_list:
            element = _element_of(parameter, announced)
            elements = draw(_lists(plain(element), is_text=element.type is Type.STRING))
            if not parameter.counts:
                values[-1] = len(elements)
            values.append(elements)
        else:
            values.append(draw(plain(parameter)))
            if parameter.name == _teller(declaration):
                announced = _announced(parameter, values[-1])
    return values


@cache
@st.composite
def operations(draw: DrawFn, dialect: str = "official", name: Names = None) -> Operation:
    """Draws operations built from values, each argument in its shortest encoding.

    Args:
        draw: Passed by hypothesis; callers omit it.
        dialect: "official", "xtended" or "compat": the firmware whose operations are drawn.
        name: One operation (`SOUND.TONE`), or several; without it all of the dialect, each as often as any other.
    """
    declaration = draw(_declarations(dialect, name))
    return operation(declaration.name, *_values(draw, declaration, _plain_values), dialect=dialect)


# Bytes


def _first_bytes() -> dict[tuple[str, int | None], list[int]]:
    """Returns the identification bytes of long forms by kind and width, with and without handle and address bits."""
    found: dict[tuple[str, int | None], list[int]] = {}
    for first, last, encoding, value in IDENTIFICATIONS:
        if value is None:
            found.setdefault((encoding.kind, encoding.width), []).extend(range(first, last + 1))
    return found


_FIRST_BYTES = _first_bytes()
_SHORT_FORMS = {(encoding.kind, value): bytes((byte,)) for byte, (encoding, value) in enumerate(SHORT)}


def _in_width(number: int, width: int, signed: bool) -> bool:
    bits = 8 * width
    return -(1 << bits - 1) <= number < 1 << bits - 1 if signed else 0 <= number < 1 << bits


def _forms(kind: str, number: int, signed: bool, plain: bool = False) -> SearchStrategy[bytes]:
    """Returns every encoding of a number for a kind of argument; `plain` omits handle and address bits."""
    ways = [st.just(_SHORT_FORMS[kind, number])] if (kind, number) in _SHORT_FORMS else []
    for width in (1, 2, 4):
        if (kind, width) in _FIRST_BYTES and _in_width(number, width, signed):
            firsts = _FIRST_BYTES[kind, width]
            tail = number.to_bytes(width, "little", signed=signed)
            ways.append(st.sampled_from([bytes((first,)) + tail for first in (firsts[:1] if plain else firsts)]))
    return st.one_of(ways)


@cache
def _forms_of_text() -> SearchStrategy[bytes]:
    """Returns strings in the current and the old form, which differ only in the identification byte."""
    heads = [bytes((first,)) for first in _FIRST_BYTES[TEXT, None]]
    return st.builds(
        lambda head, text: head + text.encode(STRING_CODING) + b"\0",
        st.sampled_from(heads),
        _texts,
    )


@cache
def _forms_of_variables() -> SearchStrategy[bytes]:
    return st.tuples(st.sampled_from((LOCAL, GLOBAL)), _indexes).flatmap(lambda it: _forms(it[0], it[1], signed=False))


_floats = st.floats(width=32).map(lambda number: struct.pack("<f", number)) | st.just(NAN_FLOAT)


@cache
def _forms_of_constants(parameter: Parameter) -> SearchStrategy[bytes]:
    kind = parameter.type
    if kind is Type.STRING:
        return _forms_of_text()
    if kind is Type.DATAF:
        heads = [bytes((first,)) for first in _FIRST_BYTES[CONSTANT, 4]]
        ways: SearchStrategy[bytes] = st.builds(lambda head, four: head + four, st.sampled_from(heads), _floats)
    else:
        ways = _numbers(parameter).flatmap(lambda number: _forms(CONSTANT, number, signed=True, plain=parameter.counts))
    if kind is Type.LABEL:
        ways |= st.integers(-128, 127).flatmap(lambda number: _forms(JUMP, number, signed=True))
    return ways | _forms_of_text() if parameter.length is not None else ways


@cache
def encoded_arguments(parameter: Parameter) -> SearchStrategy[bytes]:
    """Returns the bytes of one argument in any valid encoding, the shortest or not.

    Includes handle and address bits, labels and the old string form. For a count: the number alone, without what it
    counts; for a list of values: one of its elements.
    """
    if parameter.counts:
        return _forms_of_constants(parameter)
    if parameter.is_list:
        parameter = parameter.listed
    return _forms_of_variables() if parameter.is_output else _forms_of_constants(parameter) | _forms_of_variables()


@cache
@st.composite
def raw_operations(draw: DrawFn, dialect: str = "official", name: Names = None) -> bytes:
    """Draws the bytes of operations, arguments, CMD and counts in any encoding; parameters as for `operations`."""
    declaration = draw(_declarations(dialect, name))
    pieces = [bytes((declaration.opcode.number,))]
    if declaration.command is not None:
        pieces.append(draw(_forms(CONSTANT, declaration.command.number, signed=True, plain=True)))
    announced: Type | None = None
    for parameter in declaration.parameters:
        if parameter.is_list:
            element = _element_of(parameter, announced)
            elements = draw(_lists(encoded_arguments(element), is_text=element.type is Type.STRING))
            count = draw(_forms(CONSTANT, len(elements), signed=True, plain=True))
            if not parameter.counts:
                pieces[-1] = count
            else:
                pieces.append(count)
            pieces += elements
        elif parameter.name == _teller(declaration):
            number, announced = draw(st.sampled_from(list(FORMAT_TYPES.items())))
            pieces.append(draw(_forms(CONSTANT, number, signed=True)))
        else:
            pieces.append(draw(encoded_arguments(parameter)))
    return b"".join(pieces)


# Messages

_counters = st.integers(0, COUNTERS - 1)
_layers = st.integers(0, 0xFF)
_memory_sizes = st.fixed_dictionaries(
    {"global_size": st.integers(0, MAX_GLOBALS), "local_size": st.integers(0, MAX_LOCALS)}
)


def _that_fit(pieces: Iterable[Any], room: int) -> list[Any]:
    """Returns the first operations, as many as fit into a frame."""
    fitting = []
    for piece in pieces:
        room -= len(piece) if isinstance(piece, bytes) else piece.length
        if room < 0:
            break
        fitting.append(piece)
    return fitting


class Choice(NamedTuple):
    """The subject of frames; `choice` creates one from names.

    types            of messages
    operations       their names; None for all of a dialect, with commands that have none
    system_commands  their numbers
    """

    types: tuple[MessageType, ...] = tuple(MessageType)
    operations: tuple[str, ...] | None = None
    system_commands: tuple[int, ...] = tuple(SYSTEM_BY_NUMBER)

    def of(self, *types: MessageType) -> list[MessageType]:
        """Returns those of some types that were chosen."""
        return [member for member in types if member in self.types]


ALL = Choice()
"""Everything."""


SYSTEM_AREA = "system"
"""The name that `choice` uses for all system commands, which have no area in the firmware."""

_DIRECT_COMMANDS = TYPES_BY_KIND["direct-command"]
_DIRECT_REPLIES = TYPES_BY_KIND["direct-reply"]
_SYSTEM_COMMANDS = TYPES_BY_KIND["system-command"]
_SYSTEM_REPLIES = TYPES_BY_KIND["system-reply"]
_DAISY_COMMANDS = TYPES_BY_KIND["daisy-command"]
_DAISY_REPLIES = TYPES_BY_KIND["daisy-reply"]


def choice(
    *, names: Iterable[str] = (), areas: Iterable[str] = (), types: Iterable[str] = (), dialect: str = "official"
) -> Choice:
    """Chooses frames about some operations or system commands, of some types.

    Args:
        names: Of operations (`SOUND.TONE`), of families (`SOUND`), of system commands (`LIST_FILES`), in any case.
        areas: Of the firmware (`sound`), or `system`; with names, only named ones in one of the areas.
        types: Of messages (`DIRECT_REPLY`), or kinds of them (`direct-command`), in any case; by default all that can
            be about the choice: direct commands for operations, commands and replies for system commands.
        dialect: "official", "xtended" or "compat": the firmware whose operations are drawn.

    Returns:
        The argument `chosen` of the strategies of this module.

    Raises:
        ValueError: A name is unknown, or no type of message is left.
    """
    operations, system = _chosen([*names], [*areas], dialect)
    if operations is None:
        possible = tuple(MessageType)
    else:
        possible = (*_DIRECT_COMMANDS * bool(operations), *(_SYSTEM_COMMANDS + _SYSTEM_REPLIES) * bool(system))
    wanted = [member for each in types for member in _types(each)]
    if operations and not system:
        # Commands between bricks carry operations, too; they are drawn only on request.
        possible += tuple(member for member in _DAISY_COMMANDS if member in wanted)
    left = tuple(member for member in possible if not wanted or member in wanted)
    if not left:
        raise ValueError(
            f"no {' or '.join(member.name for member in wanted)} matches the choice: possible are"
            f" {', '.join(member.name for member in possible)}"
        )
    return Choice(left, operations, system)


def _chosen(names: list[str], areas: list[str], dialect: str) -> tuple[tuple[str, ...] | None, tuple[int, ...]]:
    """Returns the chosen operations and system commands, by default all of them."""
    if not names and not areas:
        return None, ALL.system_commands
    named = _named(names, dialect)
    if not areas:
        return named
    operations, system = _of_areas(areas, dialect)
    if not names:
        return operations, system
    left = (
        tuple(full for full in named[0] if full in operations),
        tuple(number for number in named[1] if number in system),
    )
    if left == ((), ()):
        known = operations_of(dialect)
        places = dict.fromkeys([area_of(known[full].opcode) for full in named[0]] + [SYSTEM_AREA] * bool(named[1]))
        raise ValueError(
            f"no given name is in the area {' or '.join(areas)}: {' and '.join(names)}"
            f" {'is' if len(names) == 1 else 'are'} of {', '.join(places)}"
        )
    return left


def _named(names: list[str], dialect: str) -> tuple[tuple[str, ...], tuple[int, ...]]:
    """Returns operations and system commands by their names, or those of families."""
    known = operations_of(dialect)
    operations: dict[str, None] = {}
    system: dict[int, None] = {}
    for name in names:
        upper = name.upper()
        found = [full for full, entry in known.items() if upper in (full, entry.opcode.name)]
        numbers = [entry.number for entry in SYSTEM if entry.name == upper]
        if not found and not numbers:
            families = (entry.opcode.name for entry in known.values())
            hint = near_misses(name, [*families, *known, *(entry.name for entry in SYSTEM)])
            raise ValueError(f"unknown operation or system command {name} for the {dialect} firmware{hint}")
        operations |= dict.fromkeys(found)
        system |= dict.fromkeys(numbers)
    return tuple(operations), tuple(system)


def _of_areas(areas: list[str], dialect: str) -> tuple[tuple[str, ...], tuple[int, ...]]:
    """Returns all operations and system commands of some areas."""
    for area in areas:
        if area not in (*AREAS, SYSTEM_AREA):
            raise ValueError(f"unknown area {area}: the areas are {', '.join(AREAS)} and {SYSTEM_AREA}")
    known = operations_of(dialect)
    operations = [full for area in areas for full, entry in known.items() if area_of(entry.opcode) == area]
    return tuple(dict.fromkeys(operations)), ALL.system_commands if SYSTEM_AREA in areas else ()


def _types(name: str) -> list[MessageType]:
    """Returns the types of messages with a name. Raises ValueError."""
    found = [member for member in MessageType if name.upper() == member.name or name.lower() == member.kind]
    if not found:
        kinds = TYPES_BY_KIND
        hint = near_misses(name, [member.name for member in MessageType]) or f": the kinds are {', '.join(kinds)}"
        raise ValueError(f"unknown type of message {name}{hint}")
    return found


@cache
def direct_commands(dialect: str = "official", chosen: Choice = ALL) -> SearchStrategy[DirectCommand]:
    """Returns direct commands of a few operations, built from values."""
    room = MAX_FRAME - HEADER_SIZE - MEMORY_SIZE

    def placed(found: list[Operation], counter: int, reply: bool, sizes: dict[str, int]) -> DirectCommand:
        fitting = _that_fit(found, room)
        return constructors.placed_in_frame(fitting, [each.raw for each in fitting], counter, reply, **sizes)

    return st.builds(
        placed,
        _several(operations(dialect, chosen.operations), chosen),
        _counters,
        _flags(chosen.of(*_DIRECT_COMMANDS), "wants_reply"),
        _memory_sizes,
    )


def _several(operation: SearchStrategy[Any], chosen: Choice) -> SearchStrategy[list[Any]]:
    """Returns a few operations; at least one if operations were chosen."""
    return st.lists(operation, min_size=chosen.operations is not None, max_size=MOST_OPERATIONS)


def _flags(members: Iterable[MessageType], name: str) -> SearchStrategy[bool]:
    """Returns the possible values of a flag for messages of these types."""
    return st.sampled_from([getattr(member, name) for member in members])


def direct_replies(chosen: Choice = ALL) -> SearchStrategy[DirectReply]:
    """Returns replies to direct commands, with memory of any size that fits into a frame."""
    return st.builds(
        constructors.direct_reply,
        st.binary(max_size=MOST_IN_REPLY),
        counter=_counters,
        error=_flags(chosen.of(*_DIRECT_REPLIES), "is_error"),
    )


_FIELDS: dict[FieldKind, SearchStrategy[FieldValue]] = {
    FieldKind.U8: st.integers(0, 0xFF),
    FieldKind.U16: st.integers(0, 0xFFFF),
    FieldKind.U32: st.integers(0, 0xFFFFFFFF),
    FieldKind.TEXT: _texts,
    FieldKind.COUNTED_TEXT: _texts,
    FieldKind.LISTING: st.text(st.characters(max_codepoint=255), max_size=4 * MOST_TEXT),
}


def _field(field: SystemField) -> SearchStrategy[FieldValue]:
    if field.kind is FieldKind.DATA:
        return st.binary(max_size=64 if field.most is None else min(field.most, 64))
    if field.kind is FieldKind.TEXT and field.most is not None:
        # The firmware's limit includes the zero.
        room = field.most - 1
        return _texts.map(lambda text: text[:room])
    return _FIELDS[field.kind]


@st.composite
def _fields(draw: DrawFn, declared: tuple[SystemField, ...]) -> dict[str, FieldValue]:
    """Draws values of all fields in order, including lengths; optional ones are sometimes omitted."""
    values: dict[str, FieldValue] = {}
    for field in declared:
        if field.counts is not None:
            values[field.name] = 0
        elif not field.optional or draw(st.booleans()):
            values[field.name] = draw(_field(field))
    for field in declared:
        if field.counts is not None:
            counted = values[field.counts]
            is_text = next(it for it in declared if it.name == field.counts).kind is FieldKind.COUNTED_TEXT
            assert isinstance(counted, str | bytes)
            # Senders disagree on whether a text's length includes its zero.
            values[field.name] = len(counted) + (is_text and draw(st.booleans()))
    return values


@st.composite
def system_commands(draw: DrawFn, chosen: Choice = ALL) -> SystemCommand:
    """Draws system commands, including those of the bootloader."""
    entry = SYSTEM_BY_NUMBER[draw(st.sampled_from(chosen.system_commands))]
    fields = draw(_fields(entry.request))
    reply = draw(_flags(chosen.of(*_SYSTEM_COMMANDS), "wants_reply"))
    return constructors.system_command(entry.number, counter=draw(_counters), reply=reply, **fields)


@st.composite
def system_replies(draw: DrawFn, chosen: Choice = ALL) -> SystemReply:
    """Draws replies to system commands with any status; failed ones may end before any of their fields."""
    entry = SYSTEM_BY_NUMBER[draw(st.sampled_from(chosen.system_commands))]
    error = draw(_flags(chosen.of(*_SYSTEM_REPLIES), "is_error"))
    status = draw(st.just(0) | st.sampled_from(list(SystemStatus)).map(int) | st.integers(0, 0xFF))
    fields = draw(_fields(entry.reply))
    if status or error:
        present = draw(st.integers(0, len(fields)))
        fields = dict(list(fields.items())[:present])
    return constructors.system_reply(entry.number, counter=draw(_counters), status=status, error=error, **fields)


def _frame(member: MessageType, counter: int, body: bytes) -> bytes:
    return build_frame(member, counter, body, HEADER_SIZE - LENGTH_FIELD + len(body))


@st.composite
def _daisy_commands(draw: DrawFn, dialect: str, chosen: Choice) -> bytes:
    kinds = [kind for kind in daisy.DaisySubCommand if chosen.operations is None or kind.carries_operations]
    command = draw(st.sampled_from(kinds))
    payload = draw(st.binary(max_size=56))
    if command.carries_operations:
        payload = b"".join(_that_fit(draw(st.lists(raw_operations(dialect, chosen.operations), max_size=3)), 56))
    member = draw(st.sampled_from(chosen.of(*_DAISY_COMMANDS)))
    return _frame(member, draw(_counters), bytes((command, draw(_layers), draw(_layers))) + payload)


@st.composite
def _daisy_replies(draw: DrawFn, chosen: Choice) -> bytes:
    # Layer, port, status, type, mode, 32 bytes of data, checksum, busy flags; or something shorter, not a report.
    report = st.binary(min_size=6 + daisy.SENSOR_DATA_SIZE, max_size=6 + daisy.SENSOR_DATA_SIZE + 4)
    payload = draw(report | st.binary(max_size=20))
    member = draw(st.sampled_from(chosen.of(*_DAISY_REPLIES)))
    return _frame(member, draw(_counters), bytes((draw(_layers), draw(_layers))) + payload)


def daisy_messages(dialect: str = "official", chosen: Choice = ALL) -> SearchStrategy[DaisyCommand | DaisyReply]:
    """Returns messages between bricks, both ways: operations, sensor reports, and other payloads."""

    def parsed(frame: bytes) -> DaisyCommand | DaisyReply:
        message = parse(frame, dialect=dialect)
        assert isinstance(message, DaisyCommand | DaisyReply)
        return message

    ways = [_daisy_commands(dialect, chosen)] * bool(chosen.of(*_DAISY_COMMANDS))
    ways += [_daisy_replies(chosen)] * bool(chosen.of(*_DAISY_REPLIES))
    return st.one_of(ways).map(parsed)


def messages(dialect: str = "official", chosen: Choice = ALL) -> SearchStrategy[Message]:
    """Returns messages of every type, or of the chosen ones."""
    ways: tuple[tuple[Iterable[MessageType], Callable[[], SearchStrategy[Message]]], ...] = (
        (_DIRECT_COMMANDS, lambda: direct_commands(dialect, chosen)),
        (_DIRECT_REPLIES, lambda: direct_replies(chosen)),
        (_SYSTEM_COMMANDS, lambda: system_commands(chosen)),
        (_SYSTEM_REPLIES, lambda: system_replies(chosen)),
        (_DAISY_COMMANDS + _DAISY_REPLIES, lambda: daisy_messages(dialect, chosen)),
    )
    return st.one_of([made() for types, made in ways if chosen.of(*types)])


# Frames


def _raw_direct_commands(dialect: str, chosen: Choice) -> SearchStrategy[bytes]:
    room = MAX_FRAME - HEADER_SIZE - MEMORY_SIZE

    def frame(member: MessageType, counter: int, sizes: Mapping[str, int], found: list[bytes]) -> bytes:
        return _frame(member, counter, write_memory(**sizes) + b"".join(_that_fit(found, room)))

    return st.builds(
        frame,
        st.sampled_from(chosen.of(*_DIRECT_COMMANDS)),
        _counters,
        _memory_sizes,
        _several(raw_operations(dialect, chosen.operations), chosen),
    )


def frames(dialect: str = "official", chosen: Choice = ALL) -> SearchStrategy[bytes]:
    """Returns valid frames, of every type and at most 1024 bytes, with arguments in any encoding.

    Args:
        dialect: "official", "xtended" or "compat": the firmware whose operations are drawn.
        chosen: Which frames: `choice(names=["SOUND.TONE"])`, `choice(types=["direct-command"])`.
    """
    built = messages(dialect, chosen).map(lambda message: message.build())
    return built | _raw_direct_commands(dialect, chosen) if chosen.of(*_DIRECT_COMMANDS) else built


# Frames that the brick accepts

_TEXT_ROOM = 32
"""Size of a variable that holds a text or an array, in bytes."""

_END = Label("end")
"""The target of all jumps in an accepted command: its end."""


@cache
def _accepted_values(parameter: Parameter) -> SearchStrategy[Any]:
    """Returns legal constants of a parameter, and variables that `command` places in memory."""
    if parameter.role is Role.JUMP:
        return st.just(_END)
    has_room = parameter.type is Type.STRING or parameter.length is not None or parameter.indexed_by is not None
    size = st.just(_TEXT_ROOM if has_room else None)
    variables = st.builds(Global, size) | st.builds(Local, size)
    if parameter.is_output:
        return variables
    domain = domain_of(parameter)
    if domain is None:
        return _constants(parameter) | variables
    drawn: Callable[..., SearchStrategy[Any]] = st.integers
    if parameter.type is Type.DATAF:
        drawn = partial(st.floats, width=32)
    constants = [drawn(low, high) for low, high in domain.spans]
    if domain.singles:
        constants.append(st.sampled_from(sorted(domain.singles)))
    if parameter.length is not None:
        constants.append(_texts)
    return st.one_of(*constants, variables)


def _is_accepted(frame: bytes, dialect: str, *carriers: str | None) -> bool:
    return not any(check(frame, dialect=dialect, carrier=carrier).errors for carrier in carriers)


def _command(operations: list[Draft], counter: int = 0, reply: bool | None = None) -> bytes:
    """Returns the frame of a direct command; empty if the operations do not fit."""
    try:
        return command(*operations, _END, counter=counter, reply=reply).build()
    except BuildError:
        return b""


@st.composite
def _accepted_operations(draw: DrawFn, dialect: str, names: Names) -> Draft | None:
    """Draws an operation; None if a command of it alone would be refused."""
    declaration = draw(_declarations(dialect, names))
    try:
        found = drafts(dialect)[declaration.name].draft(_values(draw, declaration, _accepted_values), unchecked=False)
    except BuildError:
        return None
    return found if _is_accepted(_command([found]), dialect, None) else None


def accepted_frames(
    dialect: str = "official", chosen: Choice = ALL, carrier: str | None = None
) -> SearchStrategy[bytes]:
    """Returns commands that the brick accepts: `check` finds no errors in them, at most warnings and hints.

    Jumps lead to the end of the command, arguments have their shortest encoding, variables their place from `command`.

    Args:
        dialect: "official", "xtended" or "compat": the firmware whose operations are drawn.
        chosen: Which frames, as for `frames`; replies are omitted.
        carrier: "usb", "bluetooth" or "wifi": what carries them; None for commands that each of them can carry.

    Raises:
        ValueError: Only replies were chosen, or the carrier is unknown.
    """
    ways: list[SearchStrategy[bytes]] = []
    if chosen.of(*_DIRECT_COMMANDS):
        operation = _accepted_operations(dialect, chosen.operations).filter(lambda found: found is not None)
        several = st.lists(operation, min_size=1, max_size=MOST_OPERATIONS)
        ways.append(st.builds(_command, several, _counters, _flags(chosen.of(*_DIRECT_COMMANDS), "wants_reply")))
    if chosen.of(*_SYSTEM_COMMANDS):
        ways.append(system_commands(chosen).map(lambda message: message.build()))
    if chosen.of(*_DAISY_COMMANDS):
        ways.append(_daisy_commands(dialect, chosen))
    if not ways:
        raise ValueError("the brick accepts only commands, but all chosen messages are replies")
    carriers = CARRIERS if carrier is None else (carrier,)
    return st.one_of(ways).filter(lambda frame: _is_accepted(frame, dialect, *carriers))


# Faulty frames


@st.composite
def mutated_frames(draw: DrawFn, dialect: str = "official", chosen: Choice = ALL) -> bytes:
    """Draws valid frames with a few bytes changed, added or removed, or with another length field.

    Half of them get a matching length field, so that the fault is after it. A few remain valid.

    Args:
        draw: Passed by hypothesis; callers omit it.
        dialect: "official", "xtended" or "compat": the firmware whose operations are drawn.
        chosen: Which frames, as for `frames`.
    """
    frame = bytearray(draw(frames(dialect, chosen)))
    for edit in draw(st.lists(st.sampled_from(("change", "insert", "delete", "length")), min_size=1, max_size=3)):
        at = draw(st.integers(0, len(frame)))
        if edit == "change" and at < len(frame):
            frame[at] ^= draw(st.integers(1, 0xFF))
        elif edit == "insert":
            frame[at:at] = draw(st.binary(min_size=1, max_size=4))
        elif edit == "delete":
            del frame[at : at + draw(st.integers(1, 4))]
        else:
            frame[:LENGTH_FIELD] = draw(st.integers(0, 0xFFFF)).to_bytes(LENGTH_FIELD, "little")
    if len(frame) >= LENGTH_FIELD and draw(st.booleans()):
        length = min(len(frame) - LENGTH_FIELD, MAX_LENGTH)
        frame[:LENGTH_FIELD] = length.to_bytes(LENGTH_FIELD, "little")
    return bytes(frame)


# Programs


@st.composite
def _entries(draw: DrawFn, dialect: str) -> NewObject:
    """Draws an object of any kind, with operations in any encoding."""
    owner, triggers = draw(st.sampled_from(((0, 0), (0, 1), (1, 1), (0, 2))))
    is_subcall = kind_of(owner, triggers) is ObjectKind.SUBCALL
    parameters = draw(st.lists(_program_parameters(), max_size=4)) if is_subcall else []
    code = table_bytes(parameters) if is_subcall else b""
    code += b"".join(draw(st.lists(raw_operations(dialect), max_size=4)))
    ends = ("RETURN", "OBJECT_END") if is_subcall else ("OBJECT_END",)
    code += b"".join(operation(name).raw for name in ends)
    return NewObject(owner, triggers, draw(st.integers(0, 300)), code)


def _program_parameters() -> SearchStrategy[ProgramParameter]:
    kinds = st.sampled_from(tuple(PARAMETER_CODES.values()))
    codes = st.builds(code_of, st.sampled_from(Direction), kinds)
    return st.builds(lambda code, size: ProgramParameter(code, size if has_size(code) else None), codes, _BYTES)


_BYTES = st.integers(0, 255)


def program_images(dialect: str = "official") -> SearchStrategy[bytes]:
    """Returns program images (.rbf) of up to five objects: threads, subcalls, blocks, their arguments in any encoding.

    Args:
        dialect: The firmware whose operations are drawn.
    """
    return st.builds(
        image_of, st.integers(0, 0xFFFF), st.integers(0, 1000), st.lists(_entries(check_dialect(dialect)), max_size=5)
    )


def programs(dialect: str = "official") -> SearchStrategy[Program]:
    """Returns the same as objects. Their contents are arbitrary, but complete."""
    return program_images(dialect).map(lambda image: parse_program(image, strict=False, dialect=dialect))
