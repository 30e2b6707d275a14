"""Operations as in LEGO's own sources: sloppy lines, names for everything, subroutines by name."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.cli import run_ev3proto_text

from ev3proto import program
from ev3proto.text.assembly import AssemblyError, assemble


def code(text: str) -> str:
    """The byte code of the only direct command in a text, in hex."""
    (message,) = assemble(text)
    return message.build()[7:].hex(" ").upper()


def reason(text: str) -> str:
    """Returns the error for a text."""
    with pytest.raises(AssemblyError) as caught:
        assemble(text)
    return caught.value.reason


LINES = {
    # The large icons have no name for "none": they use that of the other icons.
    "DATA8 state\nDATA8 answer\nUI_DRAW(QUESTION,FG_COLOR,30,40,YES_SEL,ICON_NONE,'Go on?',state,answer)": (
        "84 0C 01 1E 81 28 01 3F 84 47 6F 20 6F 6E 3F 00 60 61"
    ),
    # A CMD as a number: SQRT is 8.
    "DATA8 cmd\nJR_NEQ8(cmd,SQRT,End)\nNOP\nEnd:": "70 60 08 01 01",
    # The letters of motor ports: bits if several ports are possible, otherwise a number.
    "OUTPUT_POWER(0,A+B,50)": "A4 00 03 81 32",
    "OUTPUT_POWER(0,B,50)": "A4 00 02 81 32",
    "OUTPUT_START(0,A+B+C+D)": "A6 00 0F",
    "OUTPUT_READ(0,B,GV(0),GV(4))": "A8 00 01 60 64",
    "DATA8 A\nOUTPUT_POWER(0,A,50)": "A4 00 60 81 32",
    # A number that is read as unsigned: 40000 is 0x9C40, and so is -25536.
    "SOUND(TONE,1,440,40000)": "94 01 01 82 B8 01 82 40 9C",
    "SOUND(TONE,1,440,-25536)": "94 01 01 82 B8 01 82 40 9C",
    "UI_WRITE(VALUE16,65535)": "82 0A 3F",
    # One ) too few, one comma too many, blanks, several in a line, a 0 too many.
    "UI_DRAW(FILLWINDOW,0x00,0,0\nUI_DRAW(UPDATE)": "84 13 00 00 00 84 00",
    "JR_TRUE(LV0(0),End\n\nNOP\nEnd:": "42 40 01 01",
    "UI_DRAW(FILLWINDOW,BG_COLOR ,, 0 ,0 )\tUI_DRAW (UPDATE)": "84 13 00 00 00 84 00",
    "MOVE8_8(01,LV0(0))": "30 01 40",
    # The line under the display's title ends a column after the last.
    "UI_DRAW(LINE,FG_COLOR,0,TOPLINE_HEIGHT,LCD_WIDTH,TOPLINE_HEIGHT)": "84 03 01 00 0A 82 B2 00 0A",
    "FILENAME(PACK,'../prjs/My\\ Robot')": "C6 15 84 2E 2E 2F 70 72 6A 73 2F 4D 79 5C 20 52 6F 62 6F 74 00",
    # In the place of a CMD, its name means the CMD, even if something else has that name.
    "define LINE 64\nDATAS text LINE\nUI_DRAW(LINE,1,0,0,9,9)": "84 03 01 00 00 09 09",
    # A letter is its number when an array of any type is filled.
    "ARRAY_APPEND(LV0(0),'T')": "C4 40 81 54",
    # The same definition twice.
    "define PORT 1\ndefine PORT 1\nOUTPUT_START(0,PORT)": "A6 00 01",
}


@pytest.mark.parametrize("text", LINES)
def test_lines_as_lego_writes_them(text: str) -> None:
    assert code(text) == LINES[text]


CALLS = {
    # Seven values, each as what it is: text, variables, a float, whole numbers.
    "define Show 2\nDATA8 a\nDATA32 b\nDATA16 h\nCALL(Show,'text',a,@h,b,3.5F,-1,0xFF)": (
        "09 02 07 84 74 65 78 74 00 60 F1 08 64 83 00 00 60 40 3F 82 FF 00"
    ),
    "define Show 2\nCALL(Show)": "09 02 00",
    "define Show 2\nCALL(Show,'-')": "09 02 01 84 2D 00",
    # The number of values is written if the subroutine is called by its number, never if it is called by name.
    "define Add 2\nCALL(Add,2,2,LV0(0))": "09 02 03 02 02 40",
    "CALL(2,2,5,6)": "09 02 02 05 06",
    "CALL(2,1,'-')": "09 02 01 84 2D 00",
    "CALL(2,'-')": "09 02 01 84 2D 00",
    "opCALL, LC0(2), LC0(1), LCS('-')": "09 02 01 84 2D 00",
}


@pytest.mark.parametrize("text", CALLS)
def test_arguments_of_a_subroutine(text: str) -> None:
    assert code(text) == CALLS[text]


def test_missing_arguments_are_named() -> None:
    assert reason("CALL(Show,'text')") == (
        "unknown object Show: `define Show 2` in front of it gives the number of the object, counted from 1"
    )
    assert reason("INPUT_DEVICE(READY_SI,0,Port,0,0,1,GV0(0))").endswith(
        " Or `DATA8 Port` in front of it declares a variable"
    )
    assert reason("MOVE8_8(SQRTT,LV0(0))") == (
        "unknown variable or constant SQRTT: did you mean SQRT? Or `DATA8 SQRTT` in front of it declares a variable"
    )
    assert reason("CALL(2,3,'text')") == "PARAMETERS says 3, but 1 values follow"
    assert reason("IN_16 width\nMOVE16_16(width, LV0(0))") == (
        "a direct command has no subroutines: it is one piece, as a vmthread is; DATA16 declares a variable"
    )


@pytest.mark.parametrize(
    ("text", "near"),
    [
        ("UI_DRAW(QUESTION,1,2,3,ICON_YES,0,'a',LV0(0),LV0(1))", ": did you mean ICON_NONE?"),
        ("UI_WRITE(LED,LED_RED_FLASCH)", ": did you mean LED_RED_FLASH or LED_GREEN_FLASH"),
        ("UI_DRAW(NOTIFICATION,1,2,3,ICON_RUN,0,0,'a',LV0(0))", ""),
    ],
)
def test_a_suggestion_differs_from_the_wrong_name(text: str, near: str) -> None:
    sentence = reason(text)
    assert near in sentence
    wrong = sentence.partition("unknown ")[2].partition(" ")[0]
    assert wrong not in sentence.partition("did you mean")[2].replace("?", "").split()


# Files


def test_a_source_in_latin_1(tmp_path: Path) -> None:
    source = tmp_path / "hello.lms"
    source.write_bytes("/* Grüße */\nUI_DRAW(TEXT,FG_COLOR,0,10,'Grüße')  // schön\n".encode("latin-1"))
    assert run_ev3proto_text("encode", source).stdout == (
        "0x|11:00|00:00|80|00:00|84:05:01:00:0A:84:47:72:FC:DF:65:00|\n"
    )


@pytest.mark.parametrize("dialect", ["strict", "lego"])
def test_a_program_has_the_letters_of_motor_ports(dialect: str) -> None:
    source = """
    define B_AND_C 6
    vmthread MAIN
    {
      DATA8 D
      OUTPUT_POWER(0,A+B,50)
      OUTPUT_START(0,B)
      OUTPUT_RESET(0,B_AND_C)
      OUTPUT_STOP(0,D,1)
      SOUND(TONE,1,440,40000)
    }
    """
    made = program.assemble(source, dialect=dialect)
    # A + B is 3, B is 2; D is the variable of that name. 40000 is in four bytes, as LEGO's assembler has it.
    code = "A4 00 03 81 32 A6 00 02 A2 00 06 A3 00 40 01 94 01 01 82 B8 01 83 40 9C 00 00 0A"
    assert made.image[28:].hex(" ").upper() == code
    assert made.warnings == ()


@pytest.mark.parametrize("dialect", ["strict", "lego"])
def test_other_names_stay_unknown(dialect: str) -> None:
    for line, name in (("OUTPUT_POWER(0,A+Q,50)", "Q"), ("MOVE8_8(B,B)", "B"), ("OUTPUT_POWER(A,1,50)", "A")):
        with pytest.raises(AssemblyError, match=f"unknown name {name}"):
            program.assemble(f"vmthread MAIN\n{{\n{line}\n}}\n", dialect=dialect)
