"""Random direct commands as a careful sender builds them, drawn by hypothesis from the tables."""

from __future__ import annotations

from typing import Any

from hypothesis import strategies as st

import ev3proto
from ev3proto import GV, LV, Operation
from ev3proto.tables import operations
from ev3proto.tables.declaration import Declaration, Parameter, Role, Type
from ev3proto.tables.encoding import RANGES

ROOM = 60
"""Bytes of each memory in the commands of a careful sender."""

NOT_FOR_COMMANDS = {"ERROR", "OBJECT_END", "RETURN"} | {name for name, entry in operations().items() if entry.is_newer}


def careful_value(parameter: Parameter, lengths: set[str]) -> st.SearchStrategy[Any]:
    """Draws values that a careful sender would use.

    lengths  the parameters that give the lengths of others
    """
    size = max(parameter.type.size, 1)
    step = 4 if parameter.type in (Type.ARRAY_TYPED, Type.STRING) else size
    variables = st.integers(0, ROOM // 2 // step - 1).map(lambda index: index * step)
    if parameter.is_output:
        return variables.map(GV) | variables.map(LV)
    if parameter.length is not None or parameter.type is Type.HANDLE:
        return variables.map(LV)
    if parameter.role is Role.JUMP:
        return st.just(0)
    if parameter.name in lengths:
        return st.integers(1, 4)
    if parameter.type is Type.STRING:
        return st.text("abcxyz./", max_size=4)
    if parameter.type is Type.DATAF:
        return st.floats(*(parameter.range or (-1000, 1000)), width=32)
    if parameter.range is not None:
        return st.integers(*parameter.range) | st.sampled_from(list(parameter.special) or [parameter.range[0]])
    if parameter.enum is not None:
        return st.sampled_from(list(parameter.enum.members))
    limits = RANGES[parameter.type]
    return st.integers(limits.low, limits.high) | st.integers(-40, 40)


@st.composite
def careful_operation(draw: st.DrawFn, declaration: Declaration) -> Operation:
    lengths = {str(parameter.length) for parameter in declaration.parameters}
    values: list[Any] = []
    for parameter in declaration.parameters:
        if parameter.counts:
            values.append(draw(st.lists(st.integers(0, 10).map(lambda index: GV(4 * index)), max_size=4)))
        elif parameter.is_list:
            assert isinstance(parameter.element, Type)
            numbers: st.SearchStrategy[Any] = (
                st.floats(-9, 9, width=32) if parameter.element is Type.DATAF else st.integers(-100, 100)
            )
            elements = draw(st.lists(numbers, max_size=4))
            values[-1:] = [len(elements), elements]
        else:
            values.append(draw(careful_value(parameter, lengths)))
    return ev3proto.operation(declaration.name, *values)


KNOWN = [declaration for name, declaration in operations().items() if name not in NOT_FOR_COMMANDS]


@st.composite
def careful_frames(draw: st.DrawFn) -> bytes:
    """Draws direct commands as a careful sender builds them."""
    found = draw(st.lists(st.sampled_from(KNOWN).flatmap(careful_operation), min_size=1, max_size=5))
    return ev3proto.direct_command(
        *found, counter=draw(st.integers(0, 65535)), reply=draw(st.booleans()), global_size=ROOM, local_size=ROOM
    ).build()
