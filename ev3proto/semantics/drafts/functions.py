"""What the functions of `ev3proto.ops` call: drafts of an operation from one value for each parameter.

Most calls give plain numbers and names and omit all outputs, or have none. For those the bytes of each value are looked
up, once it was checked and encoded. All other calls go the careful way, value by value, which takes ten times as long
(`pytest benchmarks -k composing`).
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

from ev3proto.errors import BuildError
from ev3proto.schema.argument import ArgumentSchema
from ev3proto.schema.instructions import instruction_set
from ev3proto.schema.operation import OperationSchema
from ev3proto.semantics.domain import domain_of
from ev3proto.semantics.drafts.allocation import Need
from ev3proto.semantics.drafts.draft import OMITTED, STAND_IN, Draft, Open
from ev3proto.semantics.drafts.values import check_constant, draft
from ev3proto.semantics.footprint import memory_facts
from ev3proto.tables.declaration import Direction

_MOST_KEPT = 4096
"""Values of one parameter whose bytes are kept."""

_KEPT_TYPES = frozenset({int, str, type(None)})
"""Types of the values that are looked up. A member of an enumeration is none: it equals the members of all others."""


class _Constants(dict[Any, bytes]):
    """The bytes of legal constants for one parameter. KeyError for a value that is none."""

    def __init__(self, schema: ArgumentSchema) -> None:
        super().__init__()
        self._schema = schema
        domain = domain_of(schema.parameter)
        low, high = domain.spans[0] if domain is not None and domain.spans else (0, -1)
        self._legal = range(low, high + 1)

    def __missing__(self, value: Any) -> bytes:
        is_number = type(value) is int
        try:
            if not is_number or value not in self._legal:
                check_constant(self._schema.parameter, value)
            encoded = self._schema.write(value)
        except BuildError:
            raise KeyError(value) from None
        # Texts of any length and number are not kept, names are.
        if len(self) < _MOST_KEPT and (is_number or self._schema.parameter.enum is not None):
            self[value] = encoded
        return encoded


_OMITTED_OUTPUT = {None: STAND_IN}
"""The same for an output."""


class OperationDrafts:
    """Drafts of one operation."""

    __slots__ = ("_head", "_known", "_needs", "_places", "_schema")

    def __init__(self, schema: OperationSchema) -> None:
        self._schema = schema
        self._head = schema.head
        self._places: dict[int, Open] = {}
        self._known: tuple[dict[Any, bytes], ...] | None = None
        needs = _needs(schema)
        self._needs = needs or ()
        if needs is not None:
            inputs = schema.fixed[: len(schema.fixed) - len(needs)]
            self._known = (*map(_Constants, inputs), *(_OMITTED_OUTPUT for _ in needs))
            self._places = {len(inputs) + number: OMITTED for number in range(len(needs))}

    def draft(self, values: Sequence[Any], unchecked: bool) -> Draft:
        """A draft from one value for each parameter, as `ev3proto.semantics.drafts.values.draft` makes it."""
        if self._known is not None and not unchecked:
            encoded = self._head
            try:
                for known, value in zip(self._known, values, strict=True):
                    if type(value) not in _KEPT_TYPES:
                        break
                    encoded += known[value]
                else:
                    return Draft(self._schema, encoded, self._places, self._needs)
            except KeyError:
                pass  # The careful way says what is wrong.
        return draft(self._schema, values, unchecked=unchecked)


def _needs(schema: OperationSchema) -> tuple[Need, ...] | None:
    """What the outputs of an operation need when all are omitted; None where the arguments have a say in it."""
    if schema.list_parameter is not None:
        return None
    found: list[Need] = []
    for argument, facts in zip(schema.fixed, memory_facts(schema), strict=True):
        parameter = argument.parameter
        if parameter.length is not None or parameter.direction is Direction.INOUT:
            return None
        if parameter.direction is Direction.OUT:
            if facts.is_counted or facts.room is None:
                return None
            found.append(Need(f"{parameter.name} of {schema.declaration.name}", facts.room, facts.alignment))
        elif found:
            return None
    return tuple(found)


class Drafts(dict[str, OperationDrafts]):
    """Drafts of the operations of one dialect by name (`SOUND.TONE`); each is prepared when it is first asked for."""

    def __init__(self, dialect: str) -> None:
        super().__init__()
        self._dialect = dialect

    def __missing__(self, name: str) -> OperationDrafts:
        found = self[name] = OperationDrafts(instruction_set(self._dialect)[name])
        return found


@cache
def drafts(dialect: str) -> Drafts:
    """The drafts of one dialect's operations."""
    return Drafts(dialect)
