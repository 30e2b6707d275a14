"""All who say how much memory operations use are asked about the same ones, and agree.

`compose`, the assembler, bare operations in a text, and `nearest` request what `memory_of` says. Where there is
less, all of them refuse. Two answer other questions: E401 and E402 report what is certainly beyond the memory, and the
proxy needs an upper bound (`link/whitelist.py`).
"""

from __future__ import annotations

from collections.abc import Iterator

from support.cases import each
from support.constants import usual
from support.effort import effort

import ev3proto
from ev3proto import BuildError, Variable
from ev3proto.checking.nearest import _needed_memory
from ev3proto.messages import Operation
from ev3proto.schema.argument import encode_integer, encode_variable
from ev3proto.schema.header import build_frame, write_memory
from ev3proto.schema.instructions import OperationSchema, instruction_set
from ev3proto.semantics.footprint import memory_of
from ev3proto.tables.declaration import DIALECTS, Parameter, Type
from ev3proto.tables.encoding import GLOBAL, LOCAL
from ev3proto.text.assembly import AssemblyError, assemble
from ev3proto.text.paste import read_bare

COUNTS = effort(2, 3)
"""How many of the counts of values are tried: 8, one that is larger than a byte's room, and 1."""

Used = tuple[int, int] | None
"""Bytes of global and of local memory; None: refused."""


def _operations() -> Iterator[tuple[str, OperationSchema, str, int]]:
    known: set[int] = set()
    for dialect in DIALECTS:
        for schema in instruction_set(dialect).by_name.values():
            entry = id(schema.declaration.command or schema.declaration.opcode)
            if entry not in known:
                known.add(entry)
                for scope in (GLOBAL, LOCAL):
                    for count in (8, 1, 2)[:COUNTS]:
                        yield dialect, schema, scope, count


def _code(schema: OperationSchema, scope: str, count: int) -> bytes:
    """Returns an operation whose variables are one after the other, 8 bytes apart, with lists of some values."""
    parameters = [one.parameter for one in schema.fixed]
    tellers = {name for one in parameters for name in (one.length, one.indexed_by) if isinstance(name, str)}
    written: list[bytes] = []
    at = 0
    for parameter in parameters:
        if schema.tail is not None and parameter is schema.tail.counter:
            written.append(encode_integer(count))
        elif _is_variable(parameter):
            written.append(encode_variable(Variable(scope, at)))
            at += 8
        else:
            written.append(encode_integer(count) if parameter.name in tellers else usual(parameter))
    listed = count if schema.tail is not None else 0
    elements = [encode_variable(Variable(scope, at + 4 * number)) for number in range(listed)]
    return schema.head + b"".join((*written, *elements))


def _is_variable(parameter: Parameter) -> bool:
    is_untyped = parameter.type in (Type.STRING, Type.ARRAY_TYPED, Type.HANDLE)
    return parameter.is_output or parameter.length is not None or is_untyped


def _composed(operation: Operation) -> Used:
    try:
        made = ev3proto.command(operation)
    except BuildError:
        return None
    return made.global_size, made.local_size


def _assembled(code: bytes, dialect: str) -> Used:
    try:
        (made,) = assemble(f"bytes({code.hex(' ')})", dialect=dialect)
    except AssemblyError:
        return None
    assert isinstance(made, ev3proto.DirectCommand)
    return made.global_size, made.local_size


def _pasted(code: bytes, dialect: str) -> Used:
    (piece,) = read_bare([code.hex(" ")], "header", dialect)
    if piece.problem is not None:
        return None
    made = ev3proto.parse(piece.data, dialect=dialect, expect=ev3proto.DirectCommand)
    return made.global_size, made.local_size


def _proposed(frame: bytes, dialect: str) -> Used:
    found = _needed_memory(frame, dialect)
    return None if found is None else (found.globals, found.locals)


@each("dialect, schema, scope, count", _operations())
def test_memory(dialect: str, schema: OperationSchema, scope: str, count: int) -> None:
    code = _code(schema, scope, count)
    frame = build_frame(0, 0, write_memory(0, 0) + code)
    message = ev3proto.parse(frame, dialect=dialect, expect=ev3proto.DirectCommand)
    used = memory_of(message.operations)
    expected = None if used.globals > 1019 or used.locals > 63 else (used.globals, used.locals)
    rooms = {
        "compose": _composed(message.operations[0]),
        "assembler": _assembled(code, dialect),
        "paste": _pasted(code, dialect),
        "nearest": _proposed(frame, dialect),
    }
    assert rooms == dict.fromkeys(rooms, expected)
    found = {one.code for one in ev3proto.check(frame, dialect=dialect).findings}
    assert found.isdisjoint({"E401", "E402"}) or any((used.globals, used.locals))
