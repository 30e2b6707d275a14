"""Boundary values of every kind of parameter, through all readers and writers side by side."""

from __future__ import annotations

import math
from typing import Any

import pytest
from support.boundaries import Boundary, boundaries
from support.cases import each

import ev3proto
from ev3proto import BuildError
from ev3proto.checking.verdict import verdict
from ev3proto.messages import DirectCommand
from ev3proto.schema import declared
from ev3proto.schema.instructions import instruction_set
from ev3proto.tables.declaration import Role, Type

pytestmark = pytest.mark.portable

ALL = boundaries()
POSSIBLE = [each for each in ALL if each.raw is not None]
REFUSED = [each for each in ALL if each.raw is None]


def given(case: Boundary) -> list[Any]:
    """The values of the operation, without a count that is computed."""
    values: list[Any] = list(case.values)
    values[case.position] = case.value
    if case.entry.parameters[-1].is_list and not case.entry.parameters[-1].counts:
        values[-2] = None
    return values


def test_there_are_many() -> None:
    assert len(POSSIBLE) > 1500
    assert len(REFUSED) > 500
    assert {case.parameter.type for case in ALL} == set(Type) - {Type.ARRAY_TYPED} | {Type.ARRAY_TYPED}
    assert len([case for case in POSSIBLE if case.legal is False]) > 200


@each("case", POSSIBLE)
def test_the_builder(case: Boundary) -> None:
    assert ev3proto.operation(case.entry.name, *given(case), dialect=case.dialect).raw == case.code


@each("case", REFUSED)
def test_what_the_builder_refuses(case: Boundary) -> None:
    with pytest.raises(BuildError, match=rf"\b{case.parameter.name}\b"):
        ev3proto.operation(case.entry.name, *given(case), dialect=case.dialect)


@each("case", POSSIBLE)
def test_the_reader(case: Boundary) -> None:
    message = ev3proto.parse(case.frame, dialect=case.dialect, expect=DirectCommand)
    (operation,) = message.operations
    assert (operation.full_name, operation.raw) == (case.entry.name, case.code)
    arguments = operation.arguments
    if case.parameter.is_list:
        counter = case.position if case.parameter.counts else case.position - 1
        assert arguments[counter].value == case.read == len(arguments) - counter - 1
    elif case.value == case.value:
        assert arguments[case.position].value == case.read
    assert message.build() == case.frame


@each("case", POSSIBLE)
def test_the_reader_misses_each_last_byte(case: Boundary) -> None:
    """A string that ends only behind the byte code, a number that is cut, an element that is missing."""
    code = case.code
    operations, fault = instruction_set(case.dialect).scan(code, 0, len(code) - 1)
    is_counted = case.parameter.is_list and case.read > 127  # a cut list of that length has an impossible count
    assert (fault is not None and (fault.truncated or is_counted)) or (len(code) == 1 and operations == [])
    assert all(not operation.is_complete for operation in operations)


@each("case", POSSIBLE)
def test_the_declaration(case: Boundary) -> None:
    arguments = declared(case.dialect).OPERATIONS[case.entry.name]
    parsed: Any = arguments.parse(case.arguments)
    found = parsed[case.parameter.name]
    if case.parameter.is_list:
        assert len(found) == case.read
    else:
        assert found.value == case.read
    assert arguments.build(parsed) == case.arguments
    names = [parameter.name for parameter in case.entry.parameters]
    plain = {name: value for name, value in zip(names, given(case), strict=True) if value is not None}
    assert arguments.build(plain) == case.arguments


@each("case", REFUSED)
def test_what_the_declaration_refuses(case: Boundary) -> None:
    names = [parameter.name for parameter in case.entry.parameters]
    plain = {name: value for name, value in zip(names, given(case), strict=True) if value is not None}
    with pytest.raises(BuildError):
        declared(case.dialect).OPERATIONS[case.entry.name].build(plain)


@pytest.mark.parametrize("count", ["82 80 00", "3F", "83 00 00 01 00"])
def test_a_count_beyond_127_is_refused_by_both(count: str) -> None:
    arguments = bytes.fromhex("00 00 00 00 00" + count) + b"\x60" * 300
    with pytest.raises(ev3proto.DecodeError) as one:
        declared().OPERATIONS["INPUT_READEXT"].parse(arguments)
    frame = (6 + len(arguments)).to_bytes(2, "little") + bytes.fromhex("2A 00 00 FB 03 9E") + arguments
    with pytest.raises(ev3proto.DecodeError) as other:
        ev3proto.parse(frame)
    assert one.value.offset + 8 == other.value.offset
    assert "there is room for 0 to 127 values" in one.value.reason
    assert "there is room for 0 to 127 values" in other.value.reason


OF_VALUES = {"E204", "E206", "E301", "W301", "W302", "W303", "W304", "E502"}
"""The checker's codes for numbers that mean nothing, and for texts that are too long."""

LOOKED_AT = [case for case in POSSIBLE if case.legal is not None]


@each("case", LOOKED_AT)
def test_the_checker(case: Boundary) -> None:
    report = ev3proto.check(case.frame, dialect=case.dialect)
    about = [finding.code for finding in report.findings if finding.offset == 7 + case.before]
    assert bool(OF_VALUES & set(about)) is not case.legal


@each("case", POSSIBLE)
def test_the_verdict(case: Boundary) -> None:
    """The validator looks at the constants of a first parameter, at labels, and at the alignment of variables."""
    found = verdict(case.frame, case.dialect)
    parameter, is_first = case.parameter, case.position == 0 and case.entry.command is None
    kind = parameter.validated or parameter.type
    refused = False
    if parameter.direction.value == "in" and isinstance(case.value, int) and not parameter.is_list:
        most = {Type.DATA8: 0x7F, Type.DATA16: 0x7FFF, Type.DATA32: 0x7FFFFFFF, Type.HANDLE: 0x7FFF}.get(kind)
        if parameter.role is Role.JUMP:
            most = 0x7FFFFFFF
        if kind is Type.LABEL and parameter.role is not Role.JUMP:
            refused = not 0 <= case.read <= 31
        elif is_first and most is not None:
            refused = not -most <= case.read <= most
    if refused:
        assert (found.accepted, found.blamed) == (False, 7 + case.before)
    elif not case.entry.is_newer:
        assert found.accepted or found.blamed != 7 + case.before or isinstance(case.value, ev3proto.Variable)


def test_not_a_number_stays_one() -> None:
    """All floats that are not a number are built as the one that the firmware knows."""
    assert ev3proto.operation("MOVEF_F", math.nan, ev3proto.GV(0)).raw.hex() == "3f830000c07f60"
    built = declared().OPERATIONS["MOVEF_F"].build({"SOURCE": math.nan, "DESTINATION": ev3proto.GV(0)})
    assert built.hex() == "830000c07f60"
