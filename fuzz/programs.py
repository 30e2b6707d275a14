"""Programs: images are read as far as possible, and whole ones build back; sources are assembled or refused."""

from __future__ import annotations

import json

from ev3proto.errors import DecodeError
from ev3proto.program import assemble, build, check_program, parse, source_of
from ev3proto.program.listing import listing, program_json, program_tree
from ev3proto.text.assembly.errors import AssemblyError

_SIGN = b"LEGO"


def one_input(data: bytes) -> None:
    """Takes an image (.rbf), or a source (.lms)."""
    if not data.startswith(_SIGN):
        _source(data)
        return
    check_program(data)
    try:
        program = parse(data, strict=False)
    except DecodeError:
        return
    json.loads("".join(program_json(program, len(data))))
    assert list(listing(program))
    assert list(program_tree(program))
    if program.fault is None:
        assert build(program) == data
        assert source_of(program)


def _source(data: bytes) -> None:
    try:
        made = assemble(data)
    except AssemblyError as error:
        assert str(error)
        return
    # LEGO's own assembler turns some faulty sources into an image; so does ours, with a warning.
    assert build(parse(made.image, strict=not made.warnings)) == made.image
