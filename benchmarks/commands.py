"""Random direct commands, the same in every run; all operations of the tables are equally frequent."""

from __future__ import annotations

import random
import struct
from collections.abc import Iterator

import ev3proto
from ev3proto.schema.instructions import OperationSchema, instruction_set
from ev3proto.tables.declaration import Parameter, Type
from ev3proto.tables.encoding import RANGES

TEXTS = ("x", "abc", "./ui/DownloadSucces", "../apps/Motor Control/Motor Control.rbf")
NOT_IN_A_COMMAND = ("ERROR", "OBJECT_END")


def _value(rng: random.Random, parameter: Parameter) -> object:
    size = parameter.type.size or 1
    index = rng.randrange(60 // size) * size
    if parameter.is_output:
        return ev3proto.GV(index) if rng.random() < 0.8 else ev3proto.LV(index)
    if parameter.type is Type.STRING:
        return rng.choice(TEXTS)
    if parameter.type is Type.HANDLE or rng.random() < 0.12:
        return ev3proto.LV(index)
    if parameter.type is Type.DATAF:
        return rng.uniform(-1000, 1000)
    reach = rng.choice((31, RANGES[parameter.type].high))
    return rng.randint(-reach, reach)


def _operation(rng: random.Random, schema: OperationSchema) -> ev3proto.Operation:
    values: list[object] = []
    for parameter in schema.declaration.parameters:
        if parameter.counts:
            values.append([ev3proto.LV(4 * rng.randrange(15)) for _ in range(rng.randint(1, 4))])
        elif parameter.is_list:
            values[-1] = 3
            values.append([rng.randint(-31, 31) for _ in range(3)])
        else:
            values.append(_value(rng, parameter))
    return schema.make(values)


def commands(count: int, seed: int = 1) -> Iterator[bytes]:
    """Frames of one to six operations each."""
    rng = random.Random(seed)
    schemas = [schema for name, schema in instruction_set().by_name.items() if name not in NOT_IN_A_COMMAND]
    for number in range(count):
        body = b"".join(_operation(rng, rng.choice(schemas)).raw for _ in range(rng.randint(1, 6)))
        head = struct.pack("<HBH", number & 0xFFFF, 0x80 * (number % 2), 16 << 10 | 64)
        yield struct.pack("<H", len(head) + len(body)) + head + body
