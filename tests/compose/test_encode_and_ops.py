"""One domain behind two faces: `encode` takes and refuses the values that `ev3proto.ops` does, with the same bytes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.cases import each

from ev3proto import GV, BuildError, Draft, Variable, command, ops
from ev3proto.enums import LEDPATTERN
from ev3proto.tables import operations
from ev3proto.tables.declaration import Declaration, Parameter, Role, Type
from ev3proto.text.assembly import AssemblyError, assemble

DECLARATIONS = list(operations("official").values())


def function_of(declaration: Declaration) -> Callable[..., Draft]:
    """The function of `ev3proto.ops` that makes an operation."""
    found: Any = ops
    for part in declaration.name.lower().split("."):
        found = getattr(found, f"{part}_" if part in ("break", "return") else part)
    function: Callable[..., Draft] = found
    return function


def safe(parameter: Parameter, number: int) -> Any:
    """A value that is always legal; for a variable, one that is aligned for every type."""
    if parameter.is_list:
        return []
    if parameter.is_output or parameter.type is Type.STRING or parameter.length is not None:
        return GV(64 * number)
    if parameter.range is not None:
        return parameter.range[0]
    return next(iter(parameter.enum.members.values())) if parameter.enum is not None else 1


def named(parameter: Parameter) -> list[str]:
    """Names of the parameter's values, of other values, and nearly of some."""
    own = [] if parameter.enum is None else list(parameter.enum.members)
    return [*own, *parameter.names, "LED_RED", "ICON_NONE", "B", "no such name"]


def values(parameter: Parameter) -> st.SearchStrategy[Any]:
    """Values for a parameter: legal or not, of the right type or not."""
    edges = [0, 1, -1, 127, 128, -127, 255, 32767, 32768, 40000, -25536, 65535, 65536, 2**31 - 1, 2**31, -(2**31) + 1]
    edges += [edge + step for edge in parameter.range or () for step in (-1, 0, 1)]
    return st.one_of(
        st.sampled_from(edges),
        st.integers(-300, 300),
        st.integers(0, 600).map(GV),
        st.sampled_from([0.5, 1.0, -2.0, 1e10, 1e39, float("inf"), float("nan")]),
        st.sampled_from(["", "ab", "it's", "x" * 40, "x" * 300, "€", "a\0b"]),
        st.sampled_from(named(parameter)),
        # A name is one of a label where a jump goes, and CALL by name has no count.
        st.nothing() if parameter.role in (Role.JUMP, Role.OBJECT) else st.sampled_from(list(LEDPATTERN)),
    )


def text_of(value: Any, parameter: Parameter) -> str:
    """A value as assembly. A text stands for a name where the parameter has names, as in Python."""
    if isinstance(value, list):
        return ",".join(text_of(each, parameter) for each in value)
    if isinstance(value, Variable):
        return str(value)
    if isinstance(value, str):
        body = value.replace("\\", "\\\\").replace("'", "\\q").replace("\0", "\\0")
        return f"'{body}'"
    if isinstance(value, LEDPATTERN):
        return value.name
    return repr(value)


def verdict_of_ops(declaration: Declaration, given_values: list[Any]) -> bytes | None:
    """The bytes that Python makes, None where it refuses."""
    try:
        return command(function_of(declaration)(*given_values)).build()[7:]
    except BuildError:
        return None


def verdict_of_encode(declaration: Declaration, given_values: list[Any]) -> bytes | None:
    """The bytes that assembly makes, None where it refuses."""
    written = []
    for parameter, value in zip(declaration.parameters, given_values, strict=True):
        if parameter.counts:
            written.append(str(len(value)))
        if value != []:
            written.append(text_of(value, parameter))
    opcode, _, command = declaration.name.partition(".")
    try:
        (message,) = assemble(f"{opcode}({','.join([command, *written] if command else written)})")
    except AssemblyError:
        return None
    return message.build()[7:]


@each("declaration", DECLARATIONS)
def test_both_take_and_refuse_the_same(declaration: Declaration) -> None:
    parameters = declaration.parameters
    inputs = [number for number, parameter in enumerate(parameters) if not parameter.is_list]
    if not inputs:
        assert verdict_of_encode(declaration, [[] for _ in parameters]) == verdict_of_ops(
            declaration, [[] for _ in parameters]
        )
        return

    @settings(max_examples=5)
    @given(st.data())
    def agree(data: st.DataObject) -> None:
        number = data.draw(st.sampled_from(inputs))
        drawn = data.draw(values(parameters[number]))
        all_values = [safe(parameter, place) for place, parameter in enumerate(parameters)]
        all_values[number] = drawn
        assert verdict_of_encode(declaration, all_values) == verdict_of_ops(declaration, all_values)

    agree()


WITH_LISTS = [one for one in DECLARATIONS if one.parameters and one.parameters[-1].is_list]


@pytest.mark.parametrize("declaration", WITH_LISTS, ids=[declaration.name for declaration in WITH_LISTS])
def test_both_take_and_refuse_the_same_in_lists(declaration: Declaration) -> None:
    parameters = declaration.parameters
    # A name in a list is one of the firmware's numbers in assembly; Python has no names there.
    element = values(parameters[-1]).filter(lambda value: not isinstance(value, LEDPATTERN))

    @settings(max_examples=20)
    @given(
        st.lists(element.filter(lambda value: not isinstance(value, str) or len(value) != 1), min_size=1, max_size=3)
    )
    def agree(elements: list[Any]) -> None:
        all_values = [safe(parameter, place) for place, parameter in enumerate(parameters)]
        all_values[-1] = elements
        if parameters[-1].is_list and not parameters[-1].counts:
            all_values[-2] = len(elements)
        assert verdict_of_encode(declaration, all_values) == verdict_of_ops(declaration, all_values)

    agree()
