"""How likely code is what its author meant: a cost for each operation, which grows with unusual values.

`Code` reads from any offset, and each offset only once, so trying an edit of one operation reads that operation alone.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from ev3proto.errors import DecodeError
from ev3proto.messages import Argument, ArgumentValue
from ev3proto.schema.argument import encode_integer, read_arguments
from ev3proto.schema.header import COMMAND_HEADER_SIZE, read_memory
from ev3proto.schema.instructions import OperationSchema, instruction_set
from ev3proto.semantics.facts import ParameterFacts, operation_facts
from ev3proto.semantics.flow import is_label
from ev3proto.semantics.judgement import Judgement, Wrong, judged
from ev3proto.tables import AREAS
from ev3proto.tables.declaration import Effect, Role
from ev3proto.tables.encoding import GLOBAL, JUMP

FAULT = 12.0
"""The cost of an operation that cannot be read."""

_WRONG_KIND = 8.0  # a text for a number, a number for a text, a constant for a result
_LONGER = 0.3  # an encoding longer than needed

_USUAL = frozenset(code.number for area in ("ui", "timer", "sound", "input", "output", "com") for code in AREAS[area])
"""The opcodes of what people send: they move, play, draw and measure; programs also compute and jump."""

_RARE_EFFECTS = {Effect.NEVER_RUNS: FAULT, Effect.OF_PROGRAMS: 4.0, Effect.FAILS: 4.0}
_UNUSUAL, _NEWER, _NO_OPERATION = 1.5, 2.0, 1.5


@cache
def rarity(schema: OperationSchema) -> float:
    """Returns the cost of an operation itself, whatever its arguments."""
    declaration = schema.declaration
    cost = sum(_RARE_EFFECTS.get(effect, 0.0) for effect in declaration.effects)
    cost += _UNUSUAL * (declaration.opcode.number not in _USUAL)
    cost += _NO_OPERATION * (not declaration.parameters and not declaration.effects)
    return cost + _NEWER * declaration.is_newer


class _Memory(NamedTuple):
    """The memory of a command: the bytes that its header requests, the variables that its operations write."""

    globals: int
    locals: int
    written: frozenset[tuple[str, object]] = frozenset()


def _of_variable(known: ParameterFacts, argument: Argument, memory: _Memory) -> float:
    form, index = argument.form, argument.value
    assert isinstance(index, int)
    is_filled = known.is_written or known.is_counted or (form.kind, index) in memory.written
    cost = 2.5 * (not is_filled)
    if form.handle or form.address:
        return cost + 2.0
    cost += 4.0 * (index + known.size > (memory.globals if form.kind == GLOBAL else memory.locals))
    cost += 6.0 * bool(index % known.validator_alignment)
    return cost + _LONGER * (bool(form.width) and index < 32)


_COSTS = {
    **dict.fromkeys((Wrong.WRITTEN, Wrong.TEXT, Wrong.NUMBER, Wrong.LABEL, Wrong.LABEL_BYTE), _WRONG_KIND),
    **dict.fromkeys((Wrong.REFUSED, Wrong.NAN, Wrong.NEGATIVE, Wrong.TRUNCATED), 7.0),
    **dict.fromkeys(
        (Wrong.COUNT, Wrong.NAN_FLOAT, Wrong.OUTSIDE, Wrong.NO_MEMBER, Wrong.MASK, Wrong.LABEL_NUMBER), 5.0
    ),
    Wrong.WHOLE: 6.0,
    Wrong.LONG: 0.0,  # a text's length is rarely a slip
}
_NEAR, _MARKED, _ODD_FLOAT, _JUMP_BY_LABEL, _NO_MOTOR = 3.0, 6.0, 5.0, 0.5, 2.5


def _of_constant(known: ParameterFacts, argument: Argument, _: _Memory) -> float:
    wrong, form, value, parameter = judged(known, argument), argument.form, argument.value, known.parameter
    if wrong is not None:
        return _wrongness(wrong) + _layer(known, value)
    if form.kind == JUMP:
        return _JUMP_BY_LABEL if parameter.role is Role.JUMP and is_label(argument) else _WRONG_KIND
    if isinstance(value, str):
        return _of_text(argument, value)
    if form.handle or form.address:
        return _MARKED
    if isinstance(value, float):
        return 0.0 if value == 0 or 1e-5 < abs(value) < 1e9 else _ODD_FLOAT
    return _layer(known, value) + (_LONGER if form.width and len(encode_integer(value)) <= form.width else 0.0)


def _layer(known: ParameterFacts, value: ArgumentValue) -> float:
    """Returns the cost of another brick's layer, or of no motor."""
    role = known.parameter.role
    return 2.0 if role is Role.LAYER and value else _NO_MOTOR if role is Role.MOTORS and not value else 0.0


def _of_text(argument: Argument, text: str) -> float:
    cost = 3.0 if argument.form.name != "LCS" or argument.form.handle or argument.form.address else 0.0
    odd = sum([0.0 if " " <= one <= "~" else 1.0 if one >= "\xa0" else 4.0 for one in text if one not in "\n\t"])
    return cost + (min(odd, 6.0) if text else 1.0)


def _wrongness(judgement: Judgement) -> float:
    """Returns the cost of what is wrong; less for a number that is little too large."""
    domain, value = judgement.known.domain, judgement.value
    spans = domain.spans if domain is not None and not domain.has_names else ()
    if isinstance(value, int) and value > 15 and any(1.5 * min(low, 0) <= value <= 1.5 * high for low, high in spans):
        return _NEAR
    return _COSTS[judgement.wrong]


class Reading(NamedTuple):
    """One operation, as far as it can be read, and its cost."""

    end: int  # after it, or where it cannot be read on
    cost: float
    schema: OperationSchema | None
    arguments: list[Argument]
    is_fault: bool = False

    @property
    def rarity(self) -> float:
        """The cost of the operation itself."""
        return rarity(self.schema) if self.schema is not None else 0.0


class CommandCode:
    """The code of a direct command, at least one byte after its header.

    data    the whole frame
    memory  what its header requests, what its operations write
    first   its operations in order, up to the first that cannot be read, by their offsets
    """

    def __init__(self, data: bytes, dialect: str) -> None:
        self.data = data
        self.set = instruction_set(dialect)
        parsed = self._chain()
        written = frozenset(
            (argument.form.kind, argument.value)
            for _, one in parsed
            for argument in one.arguments
            if argument.is_variable and argument.parameter.is_output
        )
        self.memory = _Memory(*read_memory(data), written)
        self.first = [(at, self._priced(one, len(data))) for at, one in parsed]
        self._rest: dict[int, float] = {len(data): 0.0}
        total = 0.0
        for at, reading in reversed(self.first):
            total = self._rest[at] = total + reading.cost

    def _chain(self) -> list[tuple[int, Reading]]:
        found: list[tuple[int, Reading]] = []
        at: int = COMMAND_HEADER_SIZE
        while at < len(self.data):
            found.append((at, self._parsed(self.data, at)))
            if found[-1][1].is_fault:
                break
            at = found[-1][1].end
        return found

    @property
    def rarity(self) -> float:
        """The part of its cost that its operations have whatever their arguments are."""
        return sum(reading.rarity for _, reading in self.first)

    def read(self, data: bytes, at: int) -> Reading:
        """Reads the operation at an offset of some bytes."""
        return self._priced(self._parsed(data, at), len(data))

    def _parsed(self, data: bytes, at: int) -> Reading:
        """Returns the operation at an offset of some bytes, without its cost."""
        found: list[Argument] = []
        end, size = at, len(data)
        schema = self.set.opcodes[data[at]]
        try:
            if schema is None:
                schema, end = self.set.select(data, at, size)
            else:
                end = at + 1
            end = read_arguments(schema.readers, data, end, size, found)
            if schema.tail is not None:
                end = read_arguments(schema.elements(found, size - end), data, end, size, found)
        except DecodeError:
            stop = found[-1].offset + found[-1].length if found else end
            return Reading(stop, 0.0, schema, found, True)
        return Reading(end, 0.0, schema, found)

    def _priced(self, one: Reading, size: int) -> Reading:
        """Returns a reading with its cost in code that ends at an offset."""
        if one.is_fault or one.schema is None:
            cost = FAULT + (self._cost(one.schema, one.arguments) if one.schema else 0.0)
        elif Effect.ENDS_CODE in one.schema.declaration.effects:
            cost = 0.5 if one.end == size else FAULT
        else:
            cost = self._cost(one.schema, one.arguments)
        return Reading(one.end, cost, one.schema, one.arguments, one.is_fault)

    def _cost(self, schema: OperationSchema, found: list[Argument]) -> float:
        facts = operation_facts(schema)
        return rarity(schema) + sum(
            [self.cost_of(facts.of(number, one.parameter), one) for number, one in enumerate(found)]
        )

    def cost_of(self, known: ParameterFacts, argument: Argument) -> float:
        """Returns the cost of an argument of a parameter."""
        return (_of_variable if argument.is_variable else _of_constant)(known, argument, self.memory)

    def rest(self, at: int = COMMAND_HEADER_SIZE) -> float:
        """Returns the cost of everything from an offset on."""
        known, path = self._rest, []
        while at not in known:
            reading = self.read(self.data, at)
            if reading.is_fault:
                known[at] = reading.cost
            else:
                path.append((at, reading.cost))
                at = reading.end
        total = known[at]
        for start, cost in reversed(path):
            total = known[start] = total + cost
        return total

    def edited(self, start: int, at: int, end: int, new: bytes, *, is_guess: bool) -> float | None:
        """Returns the cost of the operation at `start`, in which bytes `at` to `end` become `new`, and of what follows.

        None if the edit does not lead to an operation that reaches beyond it.
        """
        local = self.data[start:at] + new + self.data[end:]
        if not local:
            return 0.0
        reading, stop = self.read(local, 0), at - start + len(new)
        if reading.end < stop or (reading.is_fault and (is_guess or reading.end == stop)):
            return None
        if reading.is_fault:
            return reading.cost - len(reading.arguments)  # the same slip again may be what it lacks
        return reading.cost + self.rest(start + reading.end - len(new) + end - at)
