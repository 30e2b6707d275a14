"""The same slip everywhere: the cheapest reading of a command's code in which each place may have it, for each kind.

A shortest path: from an offset, each argument leads on as it is, or with an edit that undoes the slip at that place.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from ev3proto.checking.edits import Edit, Place, argument_edits
from ev3proto.checking.slips import HABITS, SLIPS
from ev3proto.errors import DecodeError
from ev3proto.messages import Argument
from ev3proto.schema.argument import Reader, read_arguments
from ev3proto.schema.header import COMMAND_HEADER_SIZE
from ev3proto.schema.instructions import OperationSchema
from ev3proto.semantics.facts import operation_facts
from ev3proto.semantics.likelihood import CommandCode, rarity

_REPEATED = -0.1  # the cost of the same slip again: one habit explains all
_LEFT_OUT = {"none left out": "one left out", "one left out": "two left out"}
"""What a path becomes by each of two arguments that are missing."""
_ANOTHER = 1.25  # the further cost of each of them
_LONGEST = 300  # bytes of a frame


class _Path(NamedTuple):
    """A way to an offset.

    read   the cost of what is read
    extra  that of the edits, besides the slip itself
    """

    read: float = 0.0
    extra: float = 0.0
    edits: tuple[Edit, ...] = ()
    arguments: tuple[Argument, ...] = ()

    @property
    def cost(self) -> float:
        return self.read + self.extra + _REPEATED * len(self.edits)


class _Option(NamedTuple):
    """An argument at a place as it is, or after an edit."""

    end: int
    cost: float
    argument: Argument
    edit: Edit | None


_Paths = dict[tuple[int, str], _Path]
"""The cheapest paths, by the offset that they have reached and the kind of slip."""


def habitual(code: CommandCode) -> Iterator[tuple[tuple[Edit, ...], float, float]]:
    """Yields the edits of code that has a slip in several places, their cost, and that of what is read then."""
    size = len(code.data)
    if size > _LONGEST:
        return
    paths: _Paths = {(COMMAND_HEADER_SIZE, kind): _Path() for kind in (*HABITS, "none left out")}
    while (at := min((start for start, _ in paths), default=size)) < size:
        here = {key: paths.pop(key) for key in list(paths) if key[0] == at}
        for key, path in _operation(code, at, here).items():
            _keep(paths, key, path)
    for (end, _), path in paths.items():
        if end == size and len(path.edits) > 1:
            cost = SLIPS[path.edits[0].kind].cost + path.extra + _REPEATED * (len(path.edits) - 1)
            yield path.edits, cost, path.read


def _keep(paths: _Paths, key: tuple[int, str], path: _Path) -> None:
    known = paths.get(key)
    if known is None or path.cost < known.cost:
        paths[key] = path


def _operation(code: CommandCode, at: int, paths: _Paths) -> _Paths:
    """Returns the paths through the operation at an offset."""
    try:
        schema, start = code.set.opcodes[code.data[at]], at + 1
        if schema is None:
            schema, start = code.set.select(code.data, at, len(code.data))
    except DecodeError:
        return {}
    own = rarity(schema)
    here: _Paths = {}
    for (_, kind), path in paths.items():
        _keep(here, (start, kind), path._replace(read=path.read + own, arguments=()))
    for number, reader in enumerate(schema.readers):
        here = _argument(code, schema, number, reader, here)
    return here if schema.tail is None else _elements(code, schema, here)


def _elements(code: CommandCode, schema: OperationSchema, paths: _Paths) -> _Paths:
    """Returns the paths through the elements of a list, as they are."""
    here: _Paths = {}
    for (at, kind), path in paths.items():
        found = list(path.arguments)
        try:
            end = read_arguments(schema.elements(found, len(code.data) - at), code.data, at, len(code.data), found)
        except DecodeError:
            continue
        new = found[len(path.arguments) :]
        cost = sum([code.cost_of(operation_facts(schema).of(len(path.arguments), one.parameter), one) for one in new])
        _keep(here, (end, kind), path._replace(read=path.read + cost))
    return here


def _argument(code: CommandCode, schema: OperationSchema, number: int, reader: Reader, paths: _Paths) -> _Paths:
    """Returns the paths through the next argument."""
    here: _Paths = {}
    options: dict[int, list[_Option]] = {}
    for (at, kind), path in paths.items():
        if at not in options:
            options[at] = list(_options(code, schema, number, reader, at, path.arguments))
        for end, cost, argument, edit in options[at]:
            arguments = (*path.arguments, argument)
            if edit is None:
                _keep(here, (end, kind), path._replace(read=path.read + cost, arguments=arguments))
            elif edit.kind == kind and not edit.guess:
                new = _Path(path.read + cost, path.extra + edit.extra, (*path.edits, edit), arguments)
                _keep(here, (end, kind), new)
            elif edit.kind == "missing" and kind in _LEFT_OUT:
                extra = path.extra + max(edit.extra, 0.0) + _ANOTHER
                _keep(here, (end, _LEFT_OUT[kind]), _Path(path.read + cost, extra, (*path.edits, edit), arguments))
    return here


def _options(
    code: CommandCode, schema: OperationSchema, number: int, reader: Reader, at: int, before: tuple[Argument, ...]
) -> Iterator[_Option]:
    data, facts = code.data, operation_facts(schema)
    known = facts.parameters[number]
    plain = _read(reader, data, at)
    if plain is not None:
        yield _Option(plain[1], code.cost_of(known, plain[0]), plain[0], None)
    argument, end = plain or (None, min(at + 1, len(data)))
    place = Place(code, facts.name, known, at, end, argument, len(facts.parameters) - number - 1)
    for edit in argument_edits(place, list(before)):
        if edit.kind not in HABITS or edit.at < at:
            continue
        local, stop = data[at : edit.at] + edit.new + data[edit.end :], edit.at - at + len(edit.new)
        after = _read(reader, local, 0)
        if after is not None and after[1] >= stop:
            yield _Option(edit.end + after[1] - stop, code.cost_of(known, after[0]), after[0], edit)


def _read(reader: Reader, data: bytes, at: int) -> tuple[Argument, int] | None:
    """Returns one argument and its end, None if it cannot be read."""
    found: list[Argument] = []
    try:
        end = read_arguments((reader,), data, at, len(data), found)
    except DecodeError:
        return None
    return found[0], end
