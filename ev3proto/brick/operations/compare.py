"""CP: comparing two numbers into a flag. SELECT: one of two values by a flag."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.brick.operations.branch import RELATIONS
from ev3proto.brick.places import Place
from ev3proto.tables.compare import SIZES


def _compare(relation: Callable[[Any, Any], bool]) -> Callable[[Machine, float, float, Place], None]:
    def compare(_: Machine, left: float, right: float, flag: Place) -> None:
        flag.write8(relation(left, right))

    return compare


def _select(size: int) -> Callable[[Machine], None]:
    def select(vm: Machine) -> None:
        flag = vm.int8()
        first = vm.place().read_bytes(size)
        second = vm.place().read_bytes(size)
        vm.place().write_bytes(first if flag else second)

    return select


for _suffix, _type, _ in SIZES:
    for _name, _relation in RELATIONS.items():
        handles(f"CP_{_name}{_suffix}")(_compare(_relation))
    handles(f"SELECT{_suffix}", raw=True)(_select(_type.size))
