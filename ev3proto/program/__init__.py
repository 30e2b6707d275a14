r"""Programs: images (.rbf) and sources (.lms), taken apart and put together.

    program = ev3proto.program.parse(Path("robot.rbf").read_bytes())
    for part in program.objects:
        print(part.number, part.kind, part.local_size, part.operations)
    ev3proto.program.build(program) == image                # byte for byte

    made = ev3proto.program.assemble(Path("robot.lms").read_bytes())
    made.image, made.dialect, made.warnings
    ev3proto.program.source_of(program)                     # a source that assembles to the same image

A program with faults is shown and checked as far as it was read, but not built. `HEADER` is the Construct of the header
and the table of objects, `IMAGE` that of a whole image, with the codes as bytes; both fit into any other `Struct`.
"""

from __future__ import annotations

from ev3proto.program.checking import check_program
from ev3proto.program.header import HEADER, IMAGE
from ev3proto.program.image import Program, build, parse
from ev3proto.program.objects import NO_DEFECTS, CodeObject, Defects
from ev3proto.program.parameters import ProgramParameter
from ev3proto.program.sources import Assembled, SourceDialect, assemble
from ev3proto.program.writing import source_of
from ev3proto.tables.program import DEFAULT_VERSION, ObjectKind

__all__ = [
    "DEFAULT_VERSION",
    "HEADER",
    "IMAGE",
    "NO_DEFECTS",
    "Assembled",
    "CodeObject",
    "Defects",
    "ObjectKind",
    "Program",
    "ProgramParameter",
    "SourceDialect",
    "assemble",
    "build",
    "check_program",
    "parse",
    "source_of",
]
