"""A program as one JSON object: every key that other tools may rely on."""

from __future__ import annotations

from typing import Any

from ev3proto.messages import Operation
from ev3proto.program.image import Program
from ev3proto.program.listing import called_by
from ev3proto.program.objects import CodeObject
from ev3proto.text.assembly.disassembly import goal_of
from ev3proto.text.json_format.from_messages import operation_record


def program_record(program: Program, size: int) -> dict[str, Any]:
    """Returns the object of a program whose image has `size` bytes.

    An object that uses the code of an earlier one has `shares`, and no operations of its own.
    """
    return {
        "kind": "program",
        "size": size,
        "version": program.version,
        "globals": program.global_size,
        "objects": [_object(part) for part in program.objects],
        "faults": [{"offset": fault.offset, "reason": fault.reason} for fault in program.faults],
    }


def _object(part: CodeObject) -> dict[str, Any]:
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
        entry["shares"] = part.shares
        return entry
    entry["length"] = len(part.code)
    entry["calls"] = called_by(part)
    entry["operations"] = [_operation(operation) for operation in part.operations]
    if part.rest:
        entry["rest"] = part.rest.hex()
    if part.fault is not None:
        entry["fault"] = {"offset": part.fault.offset, "reason": part.fault.reason}
    return entry


def _operation(operation: Operation) -> dict[str, Any]:
    entry = operation_record(operation)
    goal = goal_of(operation)
    if goal is not None:
        entry["target"] = goal
    return entry
