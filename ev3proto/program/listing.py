"""A program as a listing: its header, its objects, each operation with its offset, labels where jumps lead.

Also as one JSON object, with every key that other tools may rely on.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from ev3proto.errors import counted
from ev3proto.messages import Operation
from ev3proto.program.header import IMAGE_HEADER
from ev3proto.program.image import Program
from ev3proto.program.objects import CodeObject
from ev3proto.program.writing import ObjectCode, Writer
from ev3proto.tables.declaration import Direction
from ev3proto.tables.encoding import CONSTANT
from ev3proto.tables.program import VERSIONS, ObjectKind
from ev3proto.text.assembly.disassembly import goal_of
from ev3proto.text.json_format.from_messages import operation_record
from ev3proto.text.phrases import spaced_hex
from ev3proto.text.spans import Line, Role
from ev3proto.text.tree import operation_lines

_CALL = "CALL"
_MOST_REST = 32
_MOST_NAMED = 12


def listing(program: Program) -> Iterator[Line]:
    """Yields one line an operation."""
    writer = Writer(program)
    yield from _head(program)
    for code, name in zip(writer.codes, writer.names, strict=True):
        yield Line()
        yield from _object_head(code.part, name)
        writer.begin(code)
        if code.part.shares is not None:
            continue
        for operation in code.part.operations:
            label = writer.label_at(operation.offset)
            if label is not None:
                yield Line([(f"  {label}:", Role.NAME)])
            yield _step(operation, writer.step(operation) if operation.is_complete else f"{operation.name} ...")
        yield from _rest(code)
    yield from _faults(program)


def program_tree(program: Program) -> Iterator[Line]:
    """Yields the same with a line for every argument, its encoding and meaning."""
    names = Writer(program).names
    yield from _head(program)
    for part, name in zip(program.objects, names, strict=True):
        yield Line()
        yield from _object_head(part, name)
        if part.shares is None:
            for operation in part.operations:
                yield from operation_lines(operation)
            yield from _rest(ObjectCode(part))
    yield from _faults(program)


def called_by(part: CodeObject) -> list[int]:
    """Returns the numbers of the objects that an object calls, each once, in their order."""
    found: dict[int, None] = {}
    for operation in part.operations:
        if operation.name == _CALL and operation.is_complete:
            callee = operation.arguments[0]
            if callee.kind == CONSTANT:
                found.setdefault(int(callee.value))
    return list(found)


def _head(program: Program) -> Iterator[Line]:
    writer = VERSIONS.get(program.version)
    by = f" ({writer})" if writer else ""
    spans = [
        ("program", Role.HEADING),
        (f"  version 0x{program.version:02X}{by}, {counted(len(program.objects), 'object')},", Role.PLAIN),
        (f" {counted(program.global_size, 'byte')} of globals", Role.PLAIN),
    ]
    yield Line(spans, 0, IMAGE_HEADER.sizeof())
    if program.defects.headers is not None:
        yield Line([("headers that say offset 0 mean the code that is next", Role.ASIDE)])


_WAYS = {Direction.IN: "in", Direction.OUT: "out", Direction.INOUT: "in and out"}


def _object_head(part: CodeObject, name: str) -> Iterator[Line]:
    line = Line([(f"object {part.number}", Role.HEADING), (f"  {part.kind} {name}", Role.OPERATION)])
    line.append((f" at {part.offset}, {counted(part.local_size, 'byte')} of locals", Role.PLAIN))
    if part.owner:
        line.append((f", of object {part.owner}", Role.PLAIN))
    if part.triggers and (part.triggers != 1 or part.kind is ObjectKind.THREAD):
        line.append((f", waits for {counted(part.triggers, 'trigger')}", Role.PLAIN))
    yield line
    if part.shares is not None:
        yield Line([(f"  its code is that of object {part.shares}", Role.ASIDE)])
        return
    for number, (parameter, place) in enumerate(zip(part.parameters, part.places, strict=True)):
        way = _WAYS[parameter.direction]
        size = "" if parameter.size is None else f" of {counted(parameter.size, 'byte')}"
        yield Line(
            [
                (f"  p{number}", Role.NAME),
                (f"  {way}, {parameter.type}{size}", Role.PLAIN),
                (f", local {place.offset}", Role.ASIDE),
            ]
        )
    calls = called_by(part)
    if calls:
        shown = ", ".join([*map(str, calls[:_MOST_NAMED]), *["..."][: len(calls) - _MOST_NAMED]])
        yield Line([(f"  calls {shown}", Role.ASIDE)])


def _step(operation: Operation, text: str) -> Line:
    name, _, arguments = text.partition("(")
    spans = [(f"  {operation.offset:5}  ", Role.ASIDE), (name, Role.OPERATION)]
    line = Line(spans, operation.offset, operation.length, target=operation.full_name)
    if arguments:
        line.append((f"({arguments}", Role.PLAIN))
    return line


def _rest(code: ObjectCode) -> Iterator[Line]:
    rest = code.part.rest
    if rest:
        shown = spaced_hex(rest[:_MOST_REST]) + (" ..." if len(rest) > _MOST_REST else "")
        what = "not read" if code.part.fault is not None else "after the end"
        yield Line([(f"         {what}: ", Role.ASIDE), (shown, Role.PLAIN)])


def _faults(program: Program) -> Iterator[Line]:
    for fault in program.faults:
        yield Line([(f"fault at {fault}", Role.FAULT)])


def program_json(program: Program, size: int, origin: str | None = None) -> Iterator[str]:
    """Yields the pieces of the JSON object of a program whose image has `size` bytes.

    An object that uses the code of an earlier one has `shares`, and no operations of its own. With `origin`, the object
    says where the program is from.
    """
    yield _opened(kind="program", size=size, version=program.version, globals=program.global_size) + ', "objects": ['
    for number, part in enumerate(program.objects):
        yield ", " if number else ""
        yield from _object_json(part)
    tail: dict[str, Any] = {
        "faults": [{"offset": fault.offset, "reason": fault.reason} for fault in program.faults],
    }
    if origin is not None:
        tail["origin"] = origin
    yield f"], {_dumped(tail)[1:]}"


def _dumped(entry: dict[str, Any]) -> str:
    return json.dumps(entry, ensure_ascii=False)


def _opened(**entry: Any) -> str:
    """Returns a JSON object without its closing brace."""
    return _dumped(entry)[:-1]


def _object_json(part: CodeObject) -> Iterator[str]:
    entry: dict[str, Any] = {
        "number": part.number,
        "kind": str(part.kind),
        "owner": part.owner,
        "triggers": part.triggers,
        "locals": part.local_size,
        "offset": part.offset,
        "parameters": [
            {
                "type": str(parameter.type),
                "direction": str(parameter.direction),
                "offset": place.offset,
                "size": place.size,
            }
            for parameter, place in zip(part.parameters, part.places, strict=True)
        ]
        if part.shares is None
        else [],
    }
    if part.shares is not None:
        yield _dumped({**entry, "shares": part.shares})
        return
    yield _opened(**entry, length=len(part.code), calls=called_by(part)) + ', "operations": ['
    for number, operation in enumerate(part.operations):
        yield f"{', ' if number else ''}{_dumped(_operation_record(operation))}"
    yield "]"
    if part.rest:
        yield f', "rest": "{part.rest.hex()}"'
    if part.fault is not None:
        yield f', "fault": {_dumped({"offset": part.fault.offset, "reason": part.fault.reason})}'
    yield "}"


def _operation_record(operation: Operation) -> dict[str, Any]:
    entry = operation_record(operation)
    goal = goal_of(operation)
    if goal is not None:
        entry["target"] = goal
    return entry
