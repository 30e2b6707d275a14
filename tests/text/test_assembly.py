"""Assembly: both notations to frames, every frame to assembly and back, and the messages about bad text."""

from __future__ import annotations

import pickle
import random
import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.cases import each
from support.cli import run_ev3proto_text

from ev3proto import DirectCommand, Operation, parse, tables
from ev3proto.capture import Record, read
from ev3proto.dialogue import Dialogue
from ev3proto.tables.declaration import DIALECTS, Direction, Parameter, Type
from ev3proto.testing import frames, mutated_frames, operations
from ev3proto.text.assembly import AssemblyError, assemble, assembly
from ev3proto.text.phrases import MACROS, NOTATIONS, quoted

ROOT = Path(__file__).parents[2]
CAPTURES = sorted((ROOT / "captures").glob("*.pcap*"))

TONE = "0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03"


def assembled(text: str, *, counter: int = 0, reply: bool | None = None) -> list[str]:
    """The frames of a text, in hex."""
    return [message.build().hex(" ").upper() for message in assemble(text, counter=counter, reply=reply)]


def code(text: str) -> str:
    """The byte code of the only direct command in a text, in hex."""
    (message,) = assemble(text)
    return message.build()[7:].hex(" ").upper()


def written(data: list[bytes], dialect: str = "official", notation: str = MACROS) -> str:
    """Frames as assembly."""
    exchanges = map(Dialogue().follow, [parse(frame, strict=False, dialect=dialect) for frame in data])
    return "\n".join(line for exchange in exchanges for line in assembly(exchange, "what it is", notation))


def wrong(text: str) -> AssemblyError:
    """Returns the error for a text."""
    with pytest.raises(AssemblyError) as caught:
        assemble(text)
    return caught.value


# Both notations


@pytest.mark.parametrize(
    "text",
    [
        "SOUND(TONE,1,440,1000)",
        "SOUND.TONE(1, 440, 1000)",
        "opSOUND,LC0(TONE),LC0(1),LC2(440),LC2(1000)",
        "opSound, LC0(TONE), LC0(1),\n    LC2(440), LC2(1000),  // the rest of it\n",
        "opSOUND(TONE, 1, 440, 1000);",
        "SOUND(TONE, VOLUME=1, DURATION=1000, FREQUENCY=440)",
        "SOUND(1, 0x01, 4 * 110, (LCD_WIDTH + 822))",
        "define A 440 /* Hz */\n#define SECOND 1000\nSOUND(TONE,1,A,SECOND)",
        "vmthread  MAIN\n{\n  SOUND(TONE,1,440,1000)  //  as LEGO writes it\n}",
    ],
)
def test_the_same_tone_in_every_way(text: str) -> None:
    assert assembled(text, counter=42) == [TONE]


def test_two_operations_of_legos_document_in_a_line() -> None:
    text = "opOUTPUT_POWER,LC0(0),LC0(0x01),LC0(20), opOUTPUT_START,LC0(0),LC0(0x01)"
    assert assembled(text) == ["0C 00 00 00 80 00 00 A4 00 01 14 A6 00 01"]


def test_encodings_are_those_that_are_named() -> None:
    texts = {
        "opSOUND, LC1(TONE), LC1(1), LC4(440), LCX(1000)": "94 81 01 81 01 83 B8 01 00 00 82 E8 03",
        "opMOVE8_8, LC0(-1), LV1(4)": "30 3F C1 04",
        "opMOVE8_8, LC1(0xFF), GV2(300)": "30 81 FF E2 2C 01",
        "opMOVEF_F, LCF(1.5), LV4(4)": "3F 83 00 00 C0 3F C3 04 00 00 00",
        "opMOVEF_F, LC4(0x7FC00001), GV0(31)": "3F 83 01 00 C0 7F 7F",
        "opMOVEF_F, LCF(-inf), LV(40)": "3F 83 00 00 80 FF C1 28",
        "opFILE, LC0(CLOSE), HND(LV1(4))": "C0 07 D1 04",
        "opFILE, LC0(CLOSE), ADR(HND(GV1(4)))": "C0 07 F9 04",
        "opJR, LAB1(-5)": "40 A0 FB",
        "opJR, bytes(A3 05)": "40 A3 05",
        "opCOM_SET, LC0(SET_BRICKNAME), LCS_OLD('myEV3')": "D4 08 80 6D 79 45 56 33 00",
        "opMOVE8_8, LC1('L'), LV0(1)": "30 81 4C 41",
    }
    for text, expected in texts.items():
        assert code(text) == expected, text


def test_c_spells_texts_letter_by_letter() -> None:
    assert code("opSTRINGS,LC0(DUPLICATE),LCS,'L','E','G','O',0,LV0(4),\nopNOP") == "7D 05 84 4C 45 47 4F 00 44 01"


def test_numbers_take_their_shortest_encoding() -> None:
    assert code("MOVE8_8(31, LV0(0))") == "30 1F 40"
    assert code("MOVE8_8(-33, LV0(0))") == "30 81 DF 40"
    assert code("MOVE8_8(0xFF, LV0(0))") == "30 3F 40"
    assert code("MOVE8_8(DATA8_NAN, LV0(0))") == "30 81 80 40"
    assert code("MOVE32_32(0x80, LV0(0))") == "3A 82 80 00 40"
    assert code("MOVEF_F(3.14F, LV0(0))") == "3F 83 C3 F5 48 40 40"
    assert code("MOVEF_F(DATAF_NAN, LV0(0))") == "3F 83 00 00 C0 7F 40"
    assert code("MOVE8_8(7 / 2 - -7 / 2 | 8, LV0(0))") == "30 0E 40"


def test_texts_and_their_escapes() -> None:
    assert code(r"COM_SET(SET_BRICKNAME, 'a\r\n\t\q\x41\\')") == "D4 08 84 61 0D 0A 09 27 41 5C 00"
    assert code('COM_SET(SET_BRICKNAME, "Ä\'")') == "D4 08 84 C4 27 00"
    assert code("define NAME 'EV3'\nCOM_SET(SET_BRICKNAME, NAME)") == "D4 08 84 45 56 33 00"


# Memory


def test_outputs_in_global_variables_ask_for_a_reply() -> None:
    text = "DATA8 percent\nDATAF volts\nUI_READ(GET_LBATT, percent)\nUI_READ(GET_VBATT, volts)"
    (command,) = assemble(text, counter=42)
    assert command.build().hex(" ").upper() == "0B 00 2A 00 00 08 00 81 12 60 81 01 64"
    dialogue = Dialogue()
    dialogue.feed(command)
    values = dialogue.feed(parse(bytes.fromhex("0B 00 2A 00 02 5F 00 00 00 A4 70 FD 40")))
    assert [(value.name, value.value) for value in values] == [("PCT", 95), ("VALUE", pytest.approx(7.92))]


def test_variables_in_a_thread_are_local() -> None:
    text = """
        define STEPS (INPUTS - 1)
        vmthread MAIN
        {
          DATA8   i
          DATA32  Timer
        Loop:
          TIMER_WAIT(500,Timer)
          TIMER_READY(Timer)
          ADD8(i,1,i)
          JR_LT8(i,STEPS,Loop)
        }
    """
    # Timer is at 4, the first multiple of its size after i; the jump goes back over 4 operations of 15 bytes.
    assert assembled(text) == ["14 00 00 00 80 00 20 85 82 F4 01 44 86 44 10 40 01 40 64 40 03 31"]


def test_scopes_and_elements() -> None:
    text = "local DATA16 a[3]\nglobal ARRAY8 b 4\nHANDLE h\nMOVE16_16(a[2], a)\nMOVE8_8(1, b[3])\nARRAY(DELETE, h)"
    (command,) = assemble(text)
    assert isinstance(command, DirectCommand)
    assert (command.global_size, command.local_size) == (6, 6)
    assert command.build()[7:].hex(" ").upper() == "35 44 40 30 01 63 C1 00 64"


def test_a_handle_means_the_array_that_it_refers_to() -> None:
    assert code("local DATA16 text\nSTRINGS(STRIP, 'a b', @text)") == "7D 08 84 61 20 62 00 D1 00"
    assert code("local DATA32 place\nMOVE8_8(&place, LV0(8))") == "30 C9 00 48"


def test_variables_by_number_are_counted_too() -> None:
    (command,) = assemble("UI_READ(GET_FW_VERS, 8, GV0(13))\nMOVE32_32(1, LV0(4))")
    assert isinstance(command, DirectCommand)
    assert (command.global_size, command.local_size, command.wants_reply) == (21, 8, True)


def test_explicit_values_are_kept() -> None:
    text = "message DIRECT_COMMAND_NO_REPLY counter 7 globals 10 locals 2\nUI_READ(GET_VBATT, GV0(0))"
    assert assembled(text) == ["08 00 07 00 80 0A 08 81 01 60"]
    assert assembled("UI_READ(GET_VBATT, GV0(0))", reply=False) == ["08 00 00 00 80 04 00 81 01 60"]


# Jumps


def test_jumps_both_ways() -> None:
    assert code("Start: JR(End)\nNOP\nEnd:\nJR(Start)") == "40 01 01 40 3B"


def test_a_jump_is_as_long_as_it_needs() -> None:
    for count, expected in ((31, "40 1F"), (32, "40 81 20"), (127, "40 81 7F"), (128, "40 82 80 00")):
        assert code("JR(End)\n" + "NOP\n" * count + "End:").startswith(f"{expected} 01")
    assert code("Start:\n" + "NOP\n" * 30 + "JR(Start)").endswith("01 40 20")
    assert code("Start:\n" + "NOP\n" * 31 + "JR(Start)").endswith("01 40 81 DE")


def test_a_jump_in_a_named_encoding() -> None:
    assert code("Start: opJR, LC2(Start), opJR, LAB1(Start)") == "40 82 FC FF 40 A0 F9"
    error = wrong("JR_FALSE(0, End)\nopJR, LC0(End)\n" + "NOP\n" * 40 + "End:")
    assert (error.line, error.column) == (2, 11)
    assert error.reason == "End is 40 bytes away: LC0 cannot hold 40: it is limited to -32 to 31"


# Lists


def test_lists_of_values() -> None:
    assert code("INIT_BYTES(LV0(0), 3, 1, 'b', 0x43)") == "2F 40 03 01 81 62 81 43"
    assert code("INPUT_READEXT(0, 0, 0, 0, DATA_F, 2, GV0(0), GV0(4))") == "9E 00 00 00 00 03 02 60 64"
    assert code("ARRAY(INITF, LV0(0), 0, 1, 1.5)") == "C1 0B 40 00 01 83 00 00 C0 3F"


# Messages


def test_several_messages_in_a_text() -> None:
    text = """
        message counter 42
        SOUND(BREAK)
        message DIRECT_REPLY counter 9
        bytes A4 70 FD 40
        message DIRECT_REPLY_ERROR
        LIST_FILES(max_bytes=1000, path="/home")
        WRITEMAILBOX("abc", "hello\\0")
        BOOTLOADER.BEGIN_DOWNLOAD(address=0, image_size=2500)
        message SYSTEM_REPLY counter 43
        LIST_FILES(status=END_OF_FILE, list_size=5, handle=1, list="a.rbf")
        message DAISY_COMMAND_REPLY counter 1 command DOWNSTREAM layer_to 1
        OUTPUT_START(0, 15)
    """
    assert assembled(text) == [
        "07 00 2A 00 80 00 00 94 00",
        "07 00 09 00 02 A4 70 FD 40",
        "03 00 0A 00 04",
        "0C 00 0B 00 01 99 E8 03 2F 68 6F 6D 65 00",
        "11 00 0C 00 81 9E 04 61 62 63 00 06 00 68 65 6C 6C 6F 00",
        "0C 00 0D 00 01 F1 00 00 00 00 C4 09 00 00",
        "0F 00 2B 00 03 99 08 05 00 00 00 01 61 2E 72 62 66",
        "09 00 01 00 0A A0 00 01 A6 00 0F",
    ]


def test_faulty_messages_can_be_written() -> None:
    assert assembled(
        "message DIRECT_COMMAND_REPLY length 55 globals 0 locals 0\nopSOUND, LC0(TONE), ...\nbytes 82"
    ) == ["37 00 00 00 00 00 00 94 01 82"]
    assert assembled("frame\nbytes 03:00|01:00\nbytes 02FF") == ["03 00 01 00 02 FF"]


def test_counters_go_on() -> None:
    text = "message\nNOP\nmessage counter 65535\nNOP\nmessage\nNOP"
    assert [message.counter for message in assemble(text, counter=3)] == [3, 65535, 0]


def test_an_empty_text_has_no_messages() -> None:
    assert assemble("") == []
    assert assemble("// nothing\n\n/* at\nall */ define A 1") == []


def test_dialects_have_their_operations() -> None:
    text = "DYNLOAD_ENTRY_0(1, 2, GV0(0), GV0(2))"
    assert wrong(text).reason == "the official firmware has no operation DYNLOAD_ENTRY_0; xtended has"
    (message,) = assemble(text, dialect="xtended")
    assert message.fault is None


# What is wrong

ERRORS = [
    ("SOUND(TOEN,1,440,1000)", 1, 7, "SOUND has no CMD TOEN: did you mean TONE?"),
    ("NOP\n  SUOND(TONE)", 2, 3, "unknown operation SUOND: did you mean SOUND?"),
    ("sound(TONE,1,440,1000)", 1, 1, "unknown operation sound: did you mean SOUND?"),
    ("sound.tone(1,440,1000)", 1, 1, "unknown operation sound.tone: did you mean SOUND.TONE?"),
    ("SOUND(9)", 1, 7, "SOUND has no CMD 9: it has BREAK, TONE, PLAY, REPEAT, SERVICE"),
    ("SOUND()", 1, 7, "the CMD of SOUND is missing: it has BREAK, TONE, PLAY, REPEAT, SERVICE"),
    (
        "SOUND(PLAY, 1)",
        1,
        14,
        "SOUND.PLAY takes 2 values (VOLUME, NAME), not 1: NAME is missing"
        " (sound file without its extension .rsf, absolute or relative to /home/root/lms2012/sys)",
    ),
    ("SOUND(TONE 1)", 1, 12, "expected , or ), found 1"),
    ("opSOUND LC0(TONE)", 1, 9, "expected a comma, found LC0"),
    ("SOUND(TONE,1,440,", 1, 18, "expected a value, found the end of the text"),
    (
        "SOUND(TONE,1,99999,1)",
        1,
        14,
        "FREQUENCY cannot be 99999: use 250 to 10000 Hz; a DATA16 is a whole number from -32767 to 32767",
    ),
    ("SOUND(TONE,'abc',440,1)", 1, 12, "VOLUME takes a number or a variable, not 'abc'"),
    ("SOUND(TONE,VOLUM=1,FREQUENCY=2,DURATION=3)", 1, 12, "SOUND.TONE has no parameter VOLUM: did you mean VOLUME?"),
    ("opSOUND, LC0(TONE), LC0(32), LC0(1), LC0(1)", 1, 21, "LC0 cannot hold 32: it is limited to -32 to 31"),
    ("opNOP, LC3(1)", 1, 8, "unknown macro LC3: there are LC0, LC1, "),
    ("UI_WRITE(LED,LED_GREN)", 1, 14, "unknown value of PATTERN (LEDPATTERN): LED_GREN: did you mean LED_"),
    (
        "MOVE8_8(Speeed, LV0(0))",
        1,
        9,
        "unknown variable or constant Speeed: `DATA8 Speeed` in front of it declares",
    ),
    (
        "message SYSTEM_COMMAND_REPLY\nSOUND(BREAK)",
        2,
        1,
        "SOUND is an operation, which is not allowed in a system-command",
    ),
    ("DATA8 a", 1, 7, "this message has no operation, and the brick refuses an empty one"),
    (
        "UI_READ(GET_VBATT, volts)",
        1,
        20,
        "unknown variable volts: `DATAF volts` in front of it declares a variable",
    ),
    ("UI_READ(GET_VBATT, 4)", 1, 20, "VALUE is an output and cannot be 4: use a variable such as GV(0) or LV(0)"),
    (
        "DATA8 small\nUI_READ(GET_VBATT, small)",
        2,
        20,
        "small has 1 byte here and would be overwritten by VALUE, a DATAF",
    ),
    ("DATA8 a 3\nMOVE8_8(a[3], a)", 2, 11, "an index of a cannot be 3: it is a whole number from 0 to 2"),
    ("DATAS text\nNOP", 1, 11, "expected the number of elements of text, found the end of the line"),
    ("DATAF vol@ts", 1, 10, "expected a number, a text or a name, found @"),
    ("local DATA32 many 16", 1, 14, "many would end 64 bytes into local memory, which has 63"),
    ("DATA8 a\nDATA8 a", 2, 7, "a is declared already, as a variable"),
    ("Loop:\nLoop:", 2, 1, "Loop is declared already, as a label"),
    ("Loop: JR(Lop)", 1, 10, "unknown label Lop: did you mean Loop?"),
    ("Loop: MOVE8_8(Loop, LV0(0))", 1, 15, "Loop is a label, and SOURCE takes none"),
    ("define A", 1, 9, "expected the value of A, found the end of the line"),
    ("MOVE8_8(1 / 0, LV0(0))", 1, 11, "a division by zero has no value"),
    ("MOVE8_8(010, LV0(0))", 1, 9, "010 is octal in C and decimal to most readers: write it as 0x.."),
    ("INIT_BYTES(LV0(0), 3, 1)", 1, 20, "LENGTH says 3, but 1 values follow"),
    ('COM_SET(SET_BRICKNAME, "a', 1, 24, 'the text that starts here has no " at its end'),
    (r"COM_SET(SET_BRICKNAME, 'a\d')", 1, 26, r"unknown escape \d: there are \n \r "),
    ("NOP /* and so on", 1, 5, "the comment that starts here has no */"),
    ("NOP\n§", 2, 1, "unexpected '§'"),
    (
        "message DIRECT_COMAND_REPLY",
        1,
        9,
        "unknown message type DIRECT_COMAND_REPLY: did you mean DIRECT_COMMAND_RE",
    ),
    ("message countr 4", 1, 9, "the header of a direct-command has no countr: did you mean counter?"),
    ("message counter 65536", 1, 17, "counter cannot be 65536: it is a whole number from 0 to 65535"),
    ("message DIRECT_REPLY\nNOP", 2, 1, "an operation is not allowed in a direct-reply, which has no operations"),
    ("LIST_FILES(path='/')", 1, 20, "LIST_FILES needs max_bytes too: maximum number of content bytes in the reply"),
    ("message SYSTEM_REPLY\nDELETE_FILE(status=SUCESS)", 2, 20, "unknown status SUCESS: did you mean SUCCESS?"),
    ("vmthread MAIN { NOP", 1, 1, "the thread that begins here has no } at its end"),
    ("subcall A { }", 1, 1, "a direct command has no subroutines: it is one piece, as a vmthread is"),
    ("NOP\n" * 1018, 1, 1, "the frame would have 1025 bytes; the brick accepts at most 1024 in one frame"),
    (
        "MOVE8_8(1, GV2(2000))",
        1,
        1,
        "the operations use 2001 bytes of global memory; there are 1019 (put `message globals 1019` before",
    ),
    ("SOUND(" + "(" * 60 + "1", 1, 57, "values are nested more than 50 deep"),
    ("NOP(" + "9" * 70 + ")", 1, 5, "a number has at most 64 characters"),
]


@pytest.mark.parametrize(("text", "line", "column", "reason"), ERRORS, ids=[reason[:40] for *_, reason in ERRORS])
def test_errors_name_place_and_reason(text: str, line: int, column: int, reason: str) -> None:
    error = wrong(text)
    assert (error.line, error.column) == (line, column)
    assert error.reason.startswith(reason)
    assert error.text == text.split("\n")[line - 1]
    assert str(error).startswith(f"line {line}, column {column}: {reason}")


def _value(parameter: Parameter) -> str:
    """Something that is legal for a parameter."""
    if parameter.is_output:
        return "GV(0)"
    if parameter.type is Type.STRING or parameter.length is not None:
        return "'x'"
    return "LV(0)" if parameter.type is Type.HANDLE else "1"


@each("name", [name for name in tables.operations() if name != "CALL"])
def test_the_advice_for_an_unknown_name_helps(name: str) -> None:
    declaration = tables.operations()[name]
    parameters = list(declaration.parameters)
    command = [] if declaration.command is None else [declaration.command.name]
    for number, parameter in enumerate(parameters):
        values = [_value(one) for one in parameters]
        values[number] = "mine"
        if parameters[-1].counts:
            elements = "GV(0)" if parameters[-1].elements is not Direction.IN else "1"
            values += [elements] * (2 if parameter is parameters[-1] else 1)
        elif number + 2 == len(parameters) and parameters[-1].is_list:
            values.append("1")
        text = f"{declaration.opcode.name}({', '.join([*command, *values])})"
        with pytest.raises(AssemblyError) as caught:
            assemble(text, unchecked=True)
        advice = re.search("`(.*?)` in front of (?:it|an operation)", caught.value.reason)
        assert advice or parameter.enum is not None, caught.value
        if advice:
            assemble(f"{advice[1]}\n{text}", unchecked=True)


def test_all_errors_are_reported_at_once() -> None:
    error = wrong("SOUND(TOEN)\nNOP\n\tUI_WRITE(LED, LED_GREN)\nJR(\nopNOP LC0(1)")
    assert [(one.line, one.column) for one in (error, *error.others)] == [(1, 7), (3, 16), (5, 7)]
    assert error.others[0].excerpt == "\tUI_WRITE(LED, LED_GREN)\n\t              ^"
    assert pickle.loads(pickle.dumps(error)).others[0].reason == error.others[0].reason


def test_nothing_is_unbounded() -> None:
    assert wrong("NOP(" + "-" * 100_000).reason == "values are nested more than 50 deep"
    assert len(wrong("?\n" * 100_000).others) == 19
    assert len(wrong("MOVE8_8('" + "x" * 100_000 + "', LV0(0))").reason) < 600
    assert wrong(f"bytes {'00' * 60_000}\n" * 20).reason.startswith("the message has more than 524288 bytes")
    assert wrong("x" * ((1 << 24) + 1)).reason.startswith("the text has 16777217 characters")


SAMPLE = """define N 'x'  #define M LV1(4)
DATA8 a 3  ARRAY16 b[4]  local DATAF f
vmthread MAIN { DATA8 i
Loop: ADD8(i, 1, i) JR_LT8(i, (INPUTS*2), Loop) UI_DRAW(TEXT,FG_COLOR,1,2,N)
STRINGS(DUPLICATE,'hi\\n',@b) MOVEF_F(1.5F, f) INPUT_READEXT(0,0,TYPE_TOUCH,0,DATA_8,2,a,a[1]) }
message SYSTEM_REPLY counter 4 length 9
LIST_FILES(status=SUCCESS, list_size=3, handle=0, list="..", ...)
bytes 01 02
message DAISY_COMMAND_REPLY command DOWNSTREAM layer_from 0
opOUTPUT_START,LC0(0),HND(LC1(15)), opJR,LC2(X), X: opSTRINGS,LC0(DUPLICATE),LCS,'a','b',0,M,
frame
bytes 01
WRITEMAILBOX(name="a", payload=bytes(01 02)) /* c */ // d
"""
TOKENS = re.findall(r"\w+|\W", SAMPLE)


@each(
    "value, payload",
    [
        ("'hi'", "68 69 00"),
        ('"hi\\0"', "68 69 00"),
        ("1.5F", "00 00 C0 3F"),
        ("-2", "00 00 00 C0"),
        ("true", "01"),
        ("FALSE", "00"),
        ("bytes(05 00)", "05 00"),
    ],
)
def test_messages_to_mailboxes_are_texts_numbers_and_logic_values(value: str, payload: str) -> None:
    size = f"{len(bytes.fromhex(payload)):02X}"
    head = "81 9E 04 61 62 63 00"
    (frame,) = assembled(f"WRITEMAILBOX(name='abc', payload={value})")
    assert frame.endswith(f"{head} {size} 00 {payload}")
    assert assembled(f"WRITEMAILBOX('abc', {value})") == [frame]


def test_invalid_mailbox_messages() -> None:
    with pytest.raises(AssemblyError, match=r"column 34: unknown name hi"):
        assemble("WRITEMAILBOX(name='abc', payload=hi)")
    with pytest.raises(AssemblyError, match=r"payload cannot be '€'"):
        assemble("WRITEMAILBOX(name='abc', payload='€')")


@given(st.randoms(use_true_random=False), st.text(max_size=20))
def test_bad_text_gives_an_error_and_nothing_else(chance: random.Random, noise: str) -> None:
    words = list(TOKENS)
    for _ in range(chance.randint(1, 8)):
        at = chance.randrange(len(words))
        words[at : at + chance.randint(0, 3)] = [chance.choice([*TOKENS, noise])]
    text = "".join(words)
    try:
        for message in assemble(text):
            message.build()
    except AssemblyError as error:
        for one in (error, *error.others):
            assert one.text == text.split("\n")[one.line - 1].rstrip("\r")
            assert 1 <= one.column <= len(one.text) + 2
            assert one.excerpt.count("\n") == 1


# There and back


@pytest.mark.parametrize("notation", NOTATIONS)
@pytest.mark.parametrize("dialect", DIALECTS)
def test_every_frame_comes_back_faulty_or_not(dialect: str, notation: str) -> None:
    @given(st.lists(frames(dialect) | mutated_frames(dialect) | st.binary(max_size=40), max_size=3))
    def comes_back(data: list[bytes]) -> None:
        messages = assemble(written(data, dialect, notation), dialect=dialect)
        assert [message.build() for message in messages] == data
        assert messages == [parse(frame, strict=False, dialect=dialect) for frame in data]

    comes_back()


@pytest.mark.parametrize("size", [1025, 65537, 70_000])
def test_a_frame_that_is_much_too_long_round_trips(size: int) -> None:
    frame = min(size - 2, 0xFFFF).to_bytes(2, "little") + bytes.fromhex("2A 00 80 00 00") + b"\1" * (size - 7)
    (message,) = assemble(written([frame]))
    assert message.build() == frame


@pytest.mark.parametrize("path", CAPTURES, ids=[path.name for path in CAPTURES])
def test_every_capture_comes_back(path: Path) -> None:
    with read(path) as capture:
        data = [event.frame for event in capture.events() if isinstance(event, Record)]
    assert data
    for notation in NOTATIONS:
        assert [message.build() for message in assemble(written(data, notation=notation))] == data


def lego(operation: Operation) -> str:
    """An operation in LEGO's notation, without encodings except for marked variables."""
    values = [] if operation.command is None else [operation.command]
    for argument in operation.arguments:
        if argument.form.handle or argument.form.address:
            values.append(f"bytes({argument.raw.hex()})")
        elif argument.is_variable:
            values.append(f"{argument.kind[0].upper()}V({argument.value})")
        else:
            values.append(quoted(argument.value) if isinstance(argument.value, str) else repr(argument.value))
    return f"{operation.name}({', '.join(values)})"


@given(operations())
def test_every_operation_in_legos_notation(operation: Operation) -> None:
    text = f"message globals 1023 locals 63\n{lego(operation)}"
    (message,) = assemble(text)
    assert isinstance(message, DirectCommand)
    assert message.fault is None
    assert [one.raw for one in message.operations] == [operation.raw]


# Written


def test_the_output_is_readable() -> None:
    texts = {
        "0E 00 01 00 00 04 00 82 1B 04 82 1B 81 05 01 FE": [
            "message DIRECT_COMMAND_REPLY counter 1 globals 4 locals 0",
            "opUI_WRITE, LC0(LED), LC0(LED_GREEN_FLASH)",
            "opUI_WRITE, LC0(LED), LC1(LED_RED_FLASH)",
            "opNOP",
            "bytes FE",
            "// fault at offset 15: unknown opcode 0xFE for the official firmware",
        ],
        "07 00 09 00 02 A4 70 FD 40": ["message DIRECT_REPLY counter 9", "bytes A4 70 FD 40"],
        "0B 00 02 00 01 98 05 01 02 03 04 05 06": [
            "message SYSTEM_COMMAND_REPLY counter 2",
            "CLOSE_FILEHANDLE(handle=5, hash=bytes(01 02 03 04 05 06))",
        ],
        "03 00 02": [
            "frame",
            "bytes 03 00 02",
            "// fault at offset 3: a frame has at least 5 bytes (length, counter, type), this one has 3",
        ],
    }
    for frame, expected in texts.items():
        assert written([bytes.fromhex(frame)]).split("\n") == ["// what it is", *expected]


def test_text_that_looks_like_assembly_is_recognised() -> None:
    def is_told(line: str) -> bool:
        return "is assembly, not a frame" in run_ev3proto_text("decode", line).stderr

    for line in ("opSOUND(TONE)", "Sound(TONE)", "message counter 42", "DATA8 x"):
        assert is_told(line), line
    for line in ("Sent: hello", "bytes.fromhex('0e0')", '{"kind": "x"}', "printf(1)", "INFO(main): sent"):
        assert not is_told(line), line
