"""Any program builds to the same bytes, and so does its source."""

from __future__ import annotations

import json

import pytest
from hypothesis import HealthCheck, given, settings

from ev3proto import program as programs
from ev3proto.program import Program, assemble, check_program, source_of
from ev3proto.program.listing import listing, program_json, program_tree
from ev3proto.tables.declaration import DIALECTS
from ev3proto.testing import program_images
from ev3proto.testing import programs as any_programs

_quick = settings(max_examples=60, suppress_health_check=[HealthCheck.too_slow])


@pytest.mark.parametrize("dialect", DIALECTS)
def test_an_image_builds_back_and_its_source_assembles_to_it(dialect: str) -> None:
    @_quick
    @given(program_images(dialect))
    def comes_back(image: bytes) -> None:
        program = programs.parse(image, dialect=dialect)
        assert program.build() == image
        assert assemble(source_of(program), dialect="strict").image == image

    comes_back()


@_quick
@given(any_programs())
def test_every_program_can_be_shown_and_checked(program: Program) -> None:
    image = program.build()
    assert list(listing(program))
    assert list(program_tree(program))
    assert json.loads("".join(program_json(program, len(image))))["size"] == len(image)
    assert check_program(image).frame == image
