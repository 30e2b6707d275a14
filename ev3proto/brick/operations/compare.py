"""CP: comparing two numbers into a flag. SELECT: one of two values by a flag."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ev3proto.brick.handlers import handles
from ev3proto.brick.locations import Location
from ev3proto.brick.machine import Machine
from ev3proto.brick.operations.branch import RELATIONS
from ev3proto.tables.declaration import NUMBER_TYPES


def _compare(relation: Callable[[Any, Any], bool]) -> Callable[[Machine, float, float, Location], None]:
    return lambda _, left, right, flag: flag.write8(relation(left, right))


def _select(size: int) -> Callable[[Machine], None]:
    def select(vm: Machine) -> None:
        flag = vm.int8()
        first = vm.place().read_bytes(size)
        second = vm.place().read_bytes(size)
        vm.place().write_bytes(first if flag else second)

    return select


for _suffix, _type, _ in NUMBER_TYPES:
    for _name, _relation in RELATIONS.items():
        # CP_LT8, CP_GT8, CP_EQ8, CP_NEQ8, CP_LTEQ8, CP_GTEQ8, CP_LT16, CP_GT16, CP_EQ16, CP_NEQ16,
        # CP_LTEQ16, CP_GTEQ16, CP_LT32, CP_GT32, CP_EQ32, CP_NEQ32, CP_LTEQ32, CP_GTEQ32, CP_LTF, CP_GTF,
        # CP_EQF, CP_NEQF, CP_LTEQF, CP_GTEQF
        handles(f"CP_{_name}{_suffix}")(_compare(_relation))
    # SELECT8, SELECT16, SELECT32, SELECTF
    handles(f"SELECT{_suffix}", raw=True)(_select(_type.size))
