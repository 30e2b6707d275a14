"""CP: comparing two numbers into a flag. SELECT: one of two values by a flag. JR: jumps, always or on a condition.

The offset of a jump that is not taken is not read.
"""

from __future__ import annotations

from collections.abc import Callable
from operator import eq, ge, gt, le, lt, ne
from typing import Any

from ev3proto.brick.conversions import is_nan
from ev3proto.brick.handlers import handles
from ev3proto.brick.machine import Machine
from ev3proto.tables.declaration import NUMBER_TYPES

RELATIONS: dict[str, Callable[[Any, Any], bool]] = {"LT": lt, "GT": gt, "EQ": eq, "NEQ": ne, "LTEQ": le, "GTEQ": ge}
"""The comparisons; with NaN on either side only NEQ is true, as in C."""


def _jump_if(vm: Machine, holds: bool) -> None:
    if holds:
        vm.jump(vm.int32())
    else:
        vm.skip()


@handles("JR", raw=True)
def jump(vm: Machine) -> None:
    """Jumps always."""
    vm.jump(vm.int32())


@handles("JR_TRUE", raw=True)
def jump_if_true(vm: Machine) -> None:
    """Jumps by a flag, which is true unless it is 0."""
    _jump_if(vm, vm.int8() != 0)


@handles("JR_FALSE", raw=True)
def jump_if_false(vm: Machine) -> None:
    """Jumps by a flag, which is true unless it is 0."""
    _jump_if(vm, vm.int8() == 0)


@handles("JR_NAN", raw=True)
def jump_if_nan(vm: Machine) -> None:
    """Jumps if a float is NaN, by its bits."""
    _jump_if(vm, is_nan(vm.float_bits()))


def _jump_by(read: Callable[[Machine], float], relation: Callable[[Any, Any], bool]) -> Callable[[Machine], None]:
    def jump_by_comparison(vm: Machine) -> None:
        left = read(vm)
        _jump_if(vm, relation(left, read(vm)))

    return jump_by_comparison


def _select(size: int) -> Callable[[Machine], None]:
    def select(vm: Machine) -> None:
        flag = vm.int8()
        first = vm.place().read_bytes(size)
        second = vm.place().read_bytes(size)
        vm.place().write_bytes(first if flag else second)

    return select


_READERS: dict[str, Callable[[Machine], float]] = {
    "8": Machine.int8,
    "16": Machine.int16,
    "32": Machine.int32,
    "F": Machine.float32,
}

for _suffix, _type, _ in NUMBER_TYPES:
    for _name, _relation in RELATIONS.items():
        # CP_LT8, CP_GT8, CP_EQ8, CP_NEQ8, CP_LTEQ8, CP_GTEQ8, CP_LT16, CP_GT16, CP_EQ16, CP_NEQ16,
        # CP_LTEQ16, CP_GTEQ16, CP_LT32, CP_GT32, CP_EQ32, CP_NEQ32, CP_LTEQ32, CP_GTEQ32, CP_LTF, CP_GTF,
        # CP_EQF, CP_NEQF, CP_LTEQF, CP_GTEQF
        handles(f"CP_{_name}{_suffix}", computes=True)(lambda _, left, right, holds=_relation: holds(left, right))
        # JR_LT8, JR_LT16, JR_LT32, JR_LTF, JR_GT8, JR_GT16, JR_GT32, JR_GTF, JR_EQ8, JR_EQ16, JR_EQ32,
        # JR_EQF, JR_NEQ8, JR_NEQ16, JR_NEQ32, JR_NEQF, JR_LTEQ8, JR_LTEQ16, JR_LTEQ32, JR_LTEQF, JR_GTEQ8,
        # JR_GTEQ16, JR_GTEQ32, JR_GTEQF
        handles(f"JR_{_name}{_suffix}", raw=True)(_jump_by(_READERS[_suffix], _relation))
    # SELECT8, SELECT16, SELECT32, SELECTF
    handles(f"SELECT{_suffix}", raw=True)(_select(_type.size))
