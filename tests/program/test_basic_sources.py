"""EV3 Basic's notation: what its compiler writes becomes the image that its assembler makes, byte for byte."""

from __future__ import annotations

import pytest

from ev3proto import program as programs
from ev3proto.program import assemble, source_of
from ev3proto.text.assembly import AssemblyError

# What the compiler makes of a program with a thread and a subroutine, shortened.
COMPILED = """
DATA8  FLAG
DATA32 COUNTER
ARRAY16 LOCKS 2

vmthread MAIN
{
    MOVE32_32 0 COUNTER
    ARRAY CREATE8 0 LOCKS
    CALL PROGRAM_MAIN -1
    PROGRAM_STOP -1
}
vmthread TWORK
{
  launch:
    CALL PROGRAM_WORK 0
    JR_GT32 Counter 1 launch
}
subcall PROGRAM_MAIN
subcall PROGRAM_WORK
{
    IN_32 SUBPROGRAM
    DATA32 INDEX
    ARRAY8 STACKPOINTER 4  // waste 4 bytes
    ARRAY32 RETURNSTACK 4
    MOVE8_8 0 STACKPOINTER / a comment, too
    MOVEF_F 1.5 RETURNSTACK+4
    CALL TEXT.LEN 'a/b' INDEX
    OBJECT_START TWORK
    WRITE32 ENDSUB_A:CALLSUB0 STACKPOINTER RETURNSTACK
    JR SUB_A
CALLSUB0:
    RETURN
SUB_A:
    READ32 RETURNSTACK STACKPOINTER INDEX
    JR_DYNAMIC INDEX
ENDSUB_A:
    MOVE32_16 -32768,STACKPOINTER
    JR_EQ32(INDEX -32 CALLSUB0)
}
subcall TEXT.LEN    // SF
{
    IN_S  text 8
    OUT_32 length
    EXTRACTLOWBYTE -128 length
}
"""

# Written out by hand: MAIN is 1, PROGRAM_MAIN is 2 by its CALL, TWORK 3, PROGRAM_WORK 4, TEXT.LEN 5.
MAIN = "3A 00 64  C1 01 00 68  09 02 01 3F  02 3F  0A"
WORK = (
    "01 82  30 00 48  3F 83 00 00 C0 3F 50  09 05 02 80 61 2F 62 00 44  05 03"
    " CE 83 F9 FF FF FF 48 4C  40 83 01 00 00 00  08  CA 4C 48 44  40 44  39 82 00 80 48  6E 44 20 30  08 0A"
)


def test_a_compiled_program() -> None:
    made = assemble(COMPILED)
    assert made.dialect == "basic"
    program = made.program
    assert program.version == 0x68
    assert program.global_size == 12
    assert [part.shares for part in program.objects] == [None, None, None, 2, None]
    main, work, thread, _, text = (part.code for part in program.objects)
    assert main == bytes.fromhex(MAIN)
    assert work == bytes.fromhex(WORK)
    assert thread == bytes.fromhex("09 04 01 00  6A 64 01 38  0A")
    assert text == bytes.fromhex("02 84 08 42  30 81 80 48  08 0A")
    assert [part.local_size for part in program.objects] == [0, 28, 0, 28, 12]


def test_it_comes_back() -> None:
    image = assemble(COMPILED).image
    source = source_of(programs.parse(image))
    assert "// ev3proto: basic" in source
    assert "LC" not in source.replace("WRITE32(LC4", "")
    assert assemble(source).image == image


def test_templates_of_its_compiler_are_omitted() -> None:
    source = "init\n{\n  OUTPUT_RESET 0 15\n}\ninline A.B // FV\n{\n  MOVE8_8 :0 :1\n x:#:\n}\nsubcall A.C\n{\n}\n"
    made = assemble(source)
    assert len(made.program.objects) == 1
    assert [warning.line for warning in made.warnings] == [1, 5]


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("CALL NOWHERE 1", "unknown name NOWHERE"),
        ("JR nowhere", "unknown name NOWHERE"),
        ("MOVE8_8 4294967296 X", "has more than 32 bits"),
        ("MOVE8_8 1 'x", "has no ' at its end"),
        ("FOO 1", "unknown operation FOO"),
    ],
)
def test_errors_are_reported(line: str, words: str) -> None:
    with pytest.raises(AssemblyError, match=words) as caught:
        assemble(f"DATA8 X\nvmthread M\n{{\n  {line}\n}}\n", dialect="basic")
    assert caught.value.line == 4


@pytest.mark.parametrize(
    ("dialect", "source"),
    [
        ("strict", "vmthread M { CALL(A) CALL(B) } subcall A subcall B { NOP() }"),
        ("lego", "vmthread M\n{\nCALL(A)\nCALL(B)\n}\nsubcall A\nsubcall B\n{\nNOP\n}\n"),
        ("basic", "vmthread M\n{\nCALL A\nCALL B\n}\nsubcall A\nsubcall B\n{\nNOP\n}\n"),
    ],
)
def test_several_heads_in_a_row_share_their_code(dialect: str, source: str) -> None:
    program = assemble(source, dialect=dialect).program
    assert [part.shares for part in program.objects] == [None, None, 2]
    assert program.objects[0].code.hex(" ") == "09 02 00 09 03 00 0a"
    assert program.objects[1].code.hex(" ") == "00 01 08 0a"
