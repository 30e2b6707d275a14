"""Sources of programs: both dialects to images, byte for byte. The bytes are written out from the specification."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.programs import IMAGE, SHORTEST, SOURCE

from ev3proto import program as programs
from ev3proto.program import assemble
from ev3proto.text.assembly import AssemblyError

pytestmark = pytest.mark.portable

BOTH = ("strict", "lego")
SOURCES = Path(__file__).parents[1].joinpath("support") / "sources"
"""Sources in LEGO's dialect, and the images that they become, in hex."""


def _code(body: str, *, dialect: str | None = None, before: str = "", number: int = 1, shortest: bool = False) -> str:
    """The code of a program's object in hex."""
    source = f"{before}\nvmthread MAIN\n{{\n{body}\n}}\n"
    assembled = assemble(source, dialect=dialect, shortest=shortest)
    part = programs.parse(assembled.image, strict=False).objects[number - 1]
    return part.code.hex(" ").upper()


def _codes(source: str | bytes, dialect: str | None = None) -> list[str]:
    """The codes of a program's objects in hex."""
    program = programs.parse(assemble(source, dialect=dialect).image, strict=False)
    return [part.code.hex(" ") for part in program.objects]


def _header(source: str, dialect: str | None = None) -> tuple[int, list[tuple[int, int, int, int]]]:
    """Bytes of globals, and of each object offset, owner, triggers, bytes of locals."""
    program = programs.parse(assemble(source, dialect=dialect).image, strict=False)
    return program.global_size, [(it.offset, it.owner, it.triggers, it.local_size) for it in program.objects]


@pytest.mark.parametrize("dialect", [None, *BOTH])
def test_the_example(dialect: str | None) -> None:
    assert assemble(SOURCE, dialect=dialect).image == IMAGE


def test_the_example_by_the_rules_of_ev3_g() -> None:
    assert assemble(SOURCE, shortest=True).image == SHORTEST


@pytest.mark.parametrize("ending", ["\r\n", "\r"])
@pytest.mark.parametrize("dialect", BOTH)
def test_lines_end_in_any_way(ending: str, dialect: str) -> None:
    assert assemble(SOURCE.replace("\n", ending), dialect=dialect).image == IMAGE


def test_a_program_without_objects_is_a_bare_header() -> None:
    assert assemble("").image == bytes.fromhex("4C45474F 10000000 6D00 0000 00000000")
    assert assemble("DATA32 x").image == bytes.fromhex("4C45474F 10000000 6D00 0000 04000000")


def test_the_version_is_the_users() -> None:
    assert programs.parse(assemble(SOURCE, version=0x39).image).version == 0x39
    assert programs.parse(assemble("// ev3proto: version 0x68\n" + SOURCE).image).version == 0x68


# Numbers, floats, strings, variables


@pytest.mark.parametrize("dialect", BOTH)
@pytest.mark.parametrize(
    ("written", "encoded"),
    [
        ("0", "00"),
        ("-32", "81 E0"),
        ("32", "81 20"),
        ("-128", "82 80 FF"),
        ("128", "82 80 00"),
        ("-32768", "83 00 80 FF FF"),
        ("32768", "83 00 80 00 00"),
        ("0xFF", "82 FF 00"),
        ("0xFFFFFFFF", "83 FF FF FF FF"),
        ("0x80000000", "83 00 00 00 80"),
        ("010", "08"),
        ("0.0F", "00"),
        ("1F", "83 00 00 80 3F"),
        ("1.5F", "83 00 00 C0 3F"),
        (".5F", "83 00 00 00 3F"),
        ("1e3F", "83 00 00 7A 44"),
        ("-0.0F", "83 00 00 00 80"),
        ("'done'", "80 64 6F 6E 65 00"),
        ("''", "80 00"),
        (r"'\n\r\t\q'", "80 0A 0D 09 27 00"),
        ("'// (a, b) /* */'", "80 2F 2F 20 28 61 2C 20 62 29 20 2F 2A 20 2A 2F 00"),
        ("DATA8_NAN", "82 80 00"),
        ("DATAF_NAN", "83 00 00 C0 7F"),
        ("LED_RED", "02"),
    ],
)
def test_a_constant_in_both_dialects(dialect: str, written: str, encoded: str) -> None:
    assert _code(f"STRINGS(DUPLICATE, {written}, {written})", dialect=dialect) == f"7D 05 {encoded} {encoded} 0A"


@pytest.mark.parametrize(
    ("written", "encoded"),
    [
        ("- 5", "3B"),
        ("-0x10", "30"),
        ("1e-3F", "83 6F 12 83 3A"),
        (r"'\\'", "80 5C 00"),
        (r"'\\n'", "80 5C 0A 00"),
        ("((0 - 7) / 2)", "3D"),
        ("'ä'", "80 C3 A4 00"),
        ("!5", "05"),
        ('"caf\\u00e9"', "80 63 61 66 E9 00"),
        ("LC4(-1)", "83 FF FF FF FF"),
        ("GV2(3)", "E2 03 00"),
        ("HND(LV1(4))", "D1 04"),
        ("bytes(81 05)", "81 05"),
    ],
)
def test_a_constant_of_the_strict_dialect(written: str, encoded: str) -> None:
    assert _code(f"STRINGS(DUPLICATE, {written}, {written})", dialect="strict") == f"7D 05 {encoded} {encoded} 0A"


@pytest.mark.parametrize(
    ("written", "encoded"),
    [
        ("+5", "05"),
        ("1.5", "01"),
        ("08", "08"),
        ("4294967297", "01"),
        (r"'\\'", "80 5C 5C 00"),
        (r"'\\n'", "80 5C 0A 00"),
        (r"'\'s'", "80 27 73 00"),
        ("'it''s'", "80 69 74 27 73 00"),
        (r"'a\sb'", "80 61 20 62 00"),
        (r"'a\db'", "80 61 5C 64 62 00"),
        ("'ä'", "80 E4 00"),
        ("'_x'", "81 78"),
        ("'_xy'", "80 5F 78 79 00"),
    ],
)
def test_a_constant_of_legos_dialect(written: str, encoded: str) -> None:
    assert _code(f"STRINGS(DUPLICATE, {written}, {written})", dialect="lego") == f"7D 05 {encoded} {encoded} 0A"


@pytest.mark.parametrize("dialect", BOTH)
@pytest.mark.parametrize(
    ("before", "local", "encoded"),
    [
        ("", "DATA8 x", "40"),
        ("DATA8 x", "", "60"),
        ("ARRAY8 pad 31\nDATA8 x", "", "7F"),
        ("ARRAY8 pad 32\nDATA8 x", "", "E1 20"),
        ("ARRAY8 pad 128\nDATA8 x", "", "E2 80 00"),
        ("ARRAY8 pad 40000\nDATA8 x", "", "E3 40 9C 00 00"),
        ("", "ARRAY8 pad 128\nDATA8 x", "C2 80 00"),
    ],
)
def test_a_variable(dialect: str, before: str, local: str, encoded: str) -> None:
    assert (
        _code(f"{local}\nUI_FLUSH()\nMOVE8_8(x, x)", dialect=dialect, before=before) == f"80 30 {encoded} {encoded} 0A"
    )


def test_a_handle_and_an_address_are_never_short() -> None:
    assert _code("HANDLE h\nMOVE8_8(@h, @h)") == "30 D1 00 D1 00 0A"
    assert _code("MOVE8_8(@h, @h)", before="HANDLE h") == "30 F1 00 F1 00 0A"
    assert _code("ARRAY8 p 128\nHANDLE h\nMOVE8_8(@h, @h)") == "30 D2 80 00 D2 80 00 0A"
    assert _code("DATA32 a\nMOVE8_8(&a, &a)", dialect="lego") == "30 C9 00 C9 00 0A"
    assert _code("MOVE8_8(&a, &a)", before="ARRAY8 p 128\nDATA32 a", dialect="lego") == "30 EA 80 00 EA 80 00 0A"


# Memory


@pytest.mark.parametrize("dialect", BOTH)
@pytest.mark.parametrize(
    ("declared", "size"),
    [
        ("DATA8 a\nDATA16 b", 4),
        ("DATA8 a\nDATA32 b", 8),
        ("DATA8 a\nDATAF b", 8),
        ("DATA8 a\nDATAS b 2", 4),
        ("DATA8 a\nDATAS b 4", 8),
        ("DATA8 a\nARRAY8 b 4", 8),
        ("DATA8 a\nARRAY16 b 3", 7),
        ("DATA8 a\nARRAY32 b 3", 13),
        ("DATA8 a\nARRAYF b 2", 9),
        ("DATAS a 85", 85),
    ],
)
def test_a_variable_of_two_or_four_bytes_is_aligned_and_no_other(dialect: str, declared: str, size: int) -> None:
    assert _header(declared, dialect)[0] == size


def test_a_misaligned_array_of_words_gives_a_warning() -> None:
    warnings = assemble("DATA8 a\nARRAY16 b 3").warnings
    assert [str(it) for it in warnings] == [
        "line 2, column 9: b starts at 1, which is not a multiple of 2: its elements are not aligned, and the brick"
        " refuses to read them"
    ]


def test_words_that_only_legos_assembler_has() -> None:
    assert _header("global g 3\nDATA8 h\nvmthread M\n{\nlocal l 4\nDATA8 m\n}")[0] == 4
    assert _header("vmthread M\n{\nDATA8 k\nlocal l 4\nDATA8 m\n}")[1][0][3] == 9


# Names


def test_strict_lookup_is_locals_then_declarations_above_then_the_firmware() -> None:
    define = "define LINE 64"
    body = "NOP()\nUI_BUTTON(LINE)"
    assert _code(body, before=define, dialect="strict") == "01 83 82 40 00 0A".replace("82 40 00", "81 40")
    below = f"vmthread MAIN {{ UI_BUTTON(LINE) }}\n{define}"
    assert _codes(below, dialect="strict") == ["83 03 0a"]
    assert _codes(below.replace("{", "\n{\n").replace(" }", "\n}"), dialect="lego") == ["83 81 40 0a"]


def test_a_define_further_down_is_known() -> None:
    source = "vmthread MAIN\n{\nUI_BUTTON(Mine)\n}\ndefine Mine 5\n"
    for dialect in BOTH:
        assert _codes(source, dialect=dialect) == ["83 05 0a"]


def test_the_last_define_counts_in_legos_dialect() -> None:
    assert _code("UI_BUTTON(A)", before="define A 1\ndefine A 2", dialect="lego") == "83 02 0A"
    with pytest.raises(AssemblyError, match="line 2, column 8: A is declared already"):
        assemble("define A 1\ndefine A 2", dialect="strict")


def test_a_variable_declared_twice_takes_its_space_twice_in_legos_dialect() -> None:
    assert _code("DATA8 x\nMOVE8_8(x, x)\nDATA8 x\nMOVE8_8(x, x)", dialect="lego") == "30 40 40 30 41 41 0A"
    with pytest.raises(AssemblyError, match="x is declared already"):
        _code("DATA8 x\nDATA8 x", dialect="strict")


def test_an_object_declared_twice_in_legos_dialect() -> None:
    source = "vmthread M\n{\nCALL(S, 1)\n}\nsubcall S\n{\nIN_8 a\nIN_8 b\nDATA8 l\n}\nsubcall S\n{\nIN_8 a\n}\n"
    image = assemble(source, dialect="lego").image
    size, headers = _header(source, "lego")
    # Both have the header of the last, and the first body says that it has as many parameters as the last.
    assert headers == [(52, 0, 0, 0), (62, 0, 1, 1), (62, 0, 1, 1)]
    assert image[52:].hex(" ") == "09 03 01 01 0a " + "01 80 80 08 0a " + "01 80 08 0a"
    assert size == 0


def test_labels_of_a_subcall_declared_twice_in_legos_dialect_are_those_of_the_last() -> None:
    # LEGO's assembler knows a label by the names of object and label, and by its offset in the image: the last one
    # counts in both copies, and each copy knows the labels of the other.
    first = "subcall S\n{\nIN_8 a\nIN_S b 5\nboth:\nJR(both)\nonly:\nJR(other)\n}\n"
    between = "subcall T\n{\nIN_8 a\nboth:\nJR(both)\n}\n"
    second = "subcall S\n{\nIN_8 a\nIN_S b 5\nNOP\nother:\nJR(only)\nboth:\nJR(both)\n}\n"
    image = assemble("vmthread M\n{\n}\n" + first + between + second, dialect="lego").image
    assert image[16 + 4 * 12 :].hex(" ") == " ".join(
        (
            "0a",
            "02 80 84 05" + " 40 82 17 00" + " 40 82 0f 00" + " 08 0a",
            "01 80" + " 40 82 fc ff" + " 08 0a",
            "02 80 84 05 01" + " 40 82 e9 ff" + " 40 82 fc ff" + " 08 0a",
        )
    )


def test_labels_are_those_of_their_object() -> None:
    source = "vmthread A { x: JR(x) } vmthread B { x: JR(x) NOP() }"
    assert _codes(source) == ["40 82 fc ff 0a", "40 82 fc ff 01 0a"]


def test_a_label_hides_a_constant_in_legos_dialect() -> None:
    assert _code("LINE:\nJR(LINE)", dialect="lego") == "40 82 FC FF 0A"
    assert _code("LINE:\nJR(LINE)", dialect="strict") == "40 03 0A"


@pytest.mark.parametrize("dialect", BOTH)
def test_a_cmd_behind_a_dot(dialect: str) -> None:
    """As ev3proto prints operations."""
    written = _code("UI_WRITE.LED(LED_RED)", dialect=dialect)
    assert written == _code("UI_WRITE(LED, LED_RED)", dialect=dialect)


@pytest.mark.parametrize("dialect", BOTH)
def test_an_unknown_name_is_an_error_with_a_suggestion(dialect: str) -> None:
    with pytest.raises(AssemblyError, match=r"line 4, column \d+: unknown name LED_RAD: did you mean LED_RED"):
        _code("UI_WRITE(LED, LED_RAD)", dialect=dialect)
    with pytest.raises(AssemblyError, match="unknown operation UI_FLASH: did you mean UI_FLUSH"):
        _code("UI_FLASH()", dialect=dialect)


def test_a_global_must_be_declared_above_its_use() -> None:
    for dialect in BOTH:
        with pytest.raises(AssemblyError, match="x is declared further down"):
            assemble("vmthread M\n{\nMOVE8_8(x, x)\n}\nDATA8 x\n", dialect=dialect)


# Expressions


def test_expressions_of_legos_dialect_are_the_usual_ones_without_parentheses() -> None:
    before = "define A 2 + 3 * 4\ndefine B (2 + 3) * 4\ndefine C 7 / 2\ndefine D C * 2"
    code = _code("NOTE_TO_FREQ(A, B)\nNOTE_TO_FREQ(C, D)", before=before, dialect="lego")
    assert code == "63 0E 0E 63 03 07 0A"


def test_expressions_of_the_strict_dialect_go_from_left_to_right() -> None:
    code = _code("NOTE_TO_FREQ((2 + 3 * 4), (A * 2))", before="define A (7 / 2)", dialect="strict")
    assert code == "63 14 06 0A"


# Calls, objects


def test_a_call_tells_how_many_parameters_the_subcall_declares() -> None:
    many = "".join(f"IN_8 p{number}\n" for number in range(34))
    source = "vmthread M\n{\nCALL(S" + ", 1" * 34 + ")\n}\nsubcall S\n{\n" + many + "}\n"
    assert _codes(source)[0] == "09 02 81 22 " + "01 " * 34 + "0a"


def test_object_numbers_from_32_on() -> None:
    threads = "".join(f"vmthread T{number}\n{{\n}}\n" for number in range(2, 40))
    source = "vmthread M\n{\nOBJECT_START(T38)\nCALL(T32)\n}\n" + threads
    for dialect in BOTH:
        assert _codes(source, dialect)[0] == "05 81 26 09 81 20 0a"


def test_the_table_of_parameters() -> None:
    declared = ["IN_8 a", "IN_16 b", "OUT_32 c", "IO_F d", "IN_S e 300", "OUT_S f 8"]
    source = "vmthread M\n{\n}\nsubcall S\n{\n" + "\n".join(declared) + "\n}\n"
    for dialect in BOTH:
        assert _codes(source, dialect)[1] == "06 80 81 42 c3 84 2c 44 08 08 0a"
    handles = "subcall S { IN_H a OUT_H b IO_H c }"
    assert _codes(handles)[0] == "03 81 41 c1 08 0a"


def test_a_parameter_behind_an_operation_is_refused() -> None:
    for dialect in BOTH:
        with pytest.raises(AssemblyError, match="in front of the first operation"):
            assemble("subcall S\n{\nIN_8 a\nNOP()\nIN_8 b\n}\n", dialect=dialect)


def test_a_written_return() -> None:
    source = "subcall S\n{\nRETURN()\n}\n"
    assert _codes(source, dialect="lego")[0] == "00 08 08 0a"
    assert _codes(source, dialect="strict")[0] == "00 08 0a"
    argument = "subcall S\n{\nUI_BUTTON(8)\n}\n"
    assert _codes(argument, dialect="strict") == ["00 83 08 08 0a"]


def test_a_block_belongs_to_the_only_object_that_triggers_it() -> None:
    source = "vmthread A { } vmthread B { OBJECT_TRIG(X) } block X { NOP() } block Y { }"
    assert [(owner, triggers) for _, owner, triggers, _ in _header(source)[1]] == [(0, 0), (0, 0), (2, 1), (1, 1)]
    other = source.replace("block Y", "// ev3proto: owner 2\n// ev3proto: locals 7\nblock Y")
    assert _header(other.replace("} //", "}\n//"))[1][3][1:] == (2, 1, 7)
    with pytest.raises(AssemblyError):
        assemble(source.replace("{", "\n{\n").replace("}", "\n}\n"), dialect="lego")


def test_equal_objects_share_their_code_by_the_rules_of_ev3_g() -> None:
    source = "vmthread M { } subcall A { NOP() } subcall B { NOP() }"
    image = assemble(source, shortest=True).image
    assert [part.shares for part in programs.parse(image).objects] == [None, None, 2]
    assert [part.shares for part in programs.parse(assemble(source).image).objects] == [None, None, None]


# Jumps


@pytest.mark.parametrize(
    ("nops", "jump"),
    [(28, "40 22"), (29, "40 21"), (30, "40 81 DF"), (124, "40 81 81"), (125, "40 82 7F FF")],
)
def test_labels_are_as_short_as_they_can_be(nops: int, jump: str) -> None:
    body = "again:\n" + "NOP()\n" * nops + "JR(again)"
    assert _code(body, shortest=True) == "01 " * nops + jump + " 0A"


def test_a_jump_of_more_than_16_bits_is_refused() -> None:
    text = "'" + "x" * 1000 + "'"
    body = "again:\n" + f"STRINGS(DUPLICATE, {text}, {text})\n" * 17 + "JR(again)"
    with pytest.raises(AssemblyError, match="bytes away"):
        _code(body)


# Mistakes that LEGO's dialect accepts


@pytest.mark.parametrize(
    "line",
    [
        "MOVE8_8 1 x",
        "MOVE8_8(1,,x)",
        "MOVE8_8(1,x",
        "MOVE8_8 (1 x) ;",
        "MOVE8_8(1,=\n x)",
        "MOVE8_8(1, /* one */ x) // done",
    ],
)
def test_legos_dialect_is_loose(line: str) -> None:
    assert _code(line, before="DATA8 x", dialect="lego") == "30 01 60 0A"


def test_text_after_a_brace_or_a_label_is_ignored() -> None:
    source = "vmthread X\n{ it's open\nx: isn't it\nNOP\n} that's it\n"
    assert _codes(source, dialect="lego")[0] == "01 0a"


def test_the_rest_of_a_labels_line_is_ignored() -> None:
    assert _code("x: NOP()\nJR(x)", dialect="lego") == "40 82 FC FF 0A"
    assert _code("x: NOP()\nJR(x)", dialect="strict") == "01 40 82 FB FF 0A"


def test_the_strict_dialect_is_tried_before_legos() -> None:
    assert assemble("vmthread X { NOP() }").dialect == "strict"
    assert assemble("vmthread X\n{\nNOP\n}\n").dialect == "lego"


def test_errors_of_the_strict_dialect_are_warnings() -> None:
    source = "DATA8 x\nvmthread M\n{\nMOVE32_32(x, x)\nMOVE8_8(300, x)\nMOVEF_F(1, 2)\nMOVE8_8(!300, x)\n}\n"
    assert [it.line for it in assemble(source).warnings] == [4, 4, 5, 6, 6]


@pytest.mark.parametrize("number", ["0x" + "F" * 5000, "9" * 5000, "0" + "7" * 5000])
def test_numbers_with_too_many_digits_are_refused(number: str) -> None:
    with pytest.raises(AssemblyError, match="has more than 32 bits"):
        assemble(f"DATA32 v\nvmthread M\n{{\nMOVE32_32({number}, v)\n}}\n", dialect="lego")


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("DATA8 x\nDATA8 x", "x is declared already: the last one counts"),
        ("define N 3\ndefine N 4", "N is declared already: the last one counts"),
        ("again:\nagain:", "the label again is set already: the last one counts"),
        ("again: NOP", "what follows the label again on its line is omitted"),
        ("LINE:", "LINE is a name of the firmware: in this object it means the label"),
        ("MOVE32_32(4294967297, v)", "4294967297 has more than 32 bits, and only the lowest 32 are taken"),
        ("CALL", "CALL needs the name of the subcall"),
        ("CALL(1, 0)", "CALL takes a subcall by its name"),
        ("STRINGS(DUPLICATE, @v, @v)", "v is a DATA32, and @ is for a HANDLE"),
        ("UI_WRITE(TEXT, v)", "TEXT is not a CMD of UI_WRITE, and counts as the number 5"),
    ],
)
def test_mistakes_that_legos_assembler_accepts_are_warnings(line: str, words: str) -> None:
    source = f"DATA32 v\nvmthread M\n{{\n{line}\n}}\n"
    assert words in " ".join(warning.reason for warning in assemble(source, dialect="lego").warnings)


def test_a_nan_by_name_is_not_an_integer() -> None:
    assert not assemble("DATAF x\nvmthread M { MOVEF_F(DATAF_NAN, x) }").warnings


@pytest.mark.parametrize(
    ("source", "line", "words"),
    [
        ("vmthread M { \x00 NOP() }", 1, "unexpected"),
        ("vmthread M\n{\nNOP() /* x\n}\n", 3, "the comment that starts here has no */"),
        ("vmthread M\n{\nNOP\nJR(nowhere)\n}\n", 4, "unknown name nowhere: a variable is declared above its use"),
        ("vmthread M\n{\nblock B { }\n}\n", 3, "a block cannot begin in another object"),
    ],
)
def test_the_first_error_is_the_one_to_fix(source: str, line: int, words: str) -> None:
    with pytest.raises(AssemblyError) as caught:
        assemble(source)
    assert caught.value.line == line
    assert words in caught.value.reason


def test_an_expression_that_the_dialects_read_differently_gives_a_warning() -> None:
    for dialect in BOTH:
        (warning,) = assemble("define A (2 + 3 * 4)\nDATAS x A", dialect=dialect).warnings
        assert "the other dialect gets another number" in warning.reason
        assert not assemble("define A (2 * 3 + 4)\nDATAS x A", dialect=dialect).warnings


@pytest.mark.parametrize(
    "text",
    [
        "vmthread M {" + " " * 5000 + "?",
        "vmthread M { MOVE8_8(" + "1" * 100_000,
        "vmthread M\n{\nMOVE8_8('" + "\\" * 50_000,
        "NOP(" * 100_000,
        "define A " + "(" * 100_000,
        "vmthread M { MOVE8_8(" + "LC0(" * 100_000,
        "".join(f"define A{number} A{number + 1}\n" for number in range(5000)) + "DATAS x A0",
        "".join(f"define A{number} {'(' * 45}A{number + 1}{' + 1)' * 45}\n" for number in range(99)) + "DATAS x A0",
        "x" * 1_000_000,
        "vmthread M\n{\n}\n"
        + "".join(f"define A{n} A{n + 1} * A{n + 1}\n" for n in range(40))
        + "define A40 9 / 10\nDATAS x A0",
    ],
    ids=range(10),
)
def test_no_text_is_slow_or_recurses_deeply(text: str) -> None:
    for dialect in BOTH:
        with pytest.raises(AssemblyError) as caught:
            assemble(text, dialect=dialect)
        assert len(str(caught.value)) < 1000


def test_every_error_has_its_line() -> None:
    source = "vmthread M\n{\nNOP(\n}\nvmthread N\n{\nDATA8 'x'\nFOO()\n}\n"
    with pytest.raises(AssemblyError) as caught:
        assemble(source, dialect="strict")
    assert [(one.line, one.column) for one in (caught.value, *caught.value.others)] == [(4, 1), (7, 7)]


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ("vmthread M { MOVE8_8(1.5, 1) }", "floats end in F"),
        ("vmthread M { MOVE8_8(4294967296, 1) }", "more than 32 bits"),
        (r"vmthread M { MOVE8_8('\d', 1) }", "unknown escape"),
        ("vmthread M { MOVE8_8(1, 2", "missing"),
        ("vmthread M { NOP }", "expected ( after NOP"),
        ("/* never ends", "has no"),
        ("define A B\ndefine B A\nvmthread M { UI_BUTTON(A) }", "defined by itself"),
        ("DATAS x (1 / 0)", "division by zero"),
        ("DATAS x " + "(" * 60 + "1" + ")" * 60, "deep"),
        ("vmthread M { IN_8 a }", "only a subcall has"),
        ("NOP()", "outside of any object"),
        ("DATAS x -1", "cannot be -1"),
    ],
)
def test_invalid_programs_are_refused_with_a_reason(source: str, words: str) -> None:
    with pytest.raises(AssemblyError) as caught:
        assemble(source, dialect="strict")
    assert any(words in one.reason for one in (caught.value, *caught.value.others)), caught.value


def test_files_of_old_editors_end_in_control_z() -> None:
    for dialect in BOTH:
        assert assemble(b"\xef\xbb\xbf" + SOURCE.encode() + b"\x1a", dialect=dialect).image == IMAGE


@pytest.mark.parametrize("name", ["menu", "sensors", "sloppy", "memory"])
def test_whole_programs_as_legos_sources_are_written(name: str) -> None:
    """The images were made with another assembler, which was written from the description of the format alone."""
    made = assemble((SOURCES / f"{name}.lms").read_bytes())
    assert made.dialect == "lego"
    assert made.image == bytes.fromhex((SOURCES / f"{name}.hex").read_text())
    program = programs.parse(made.image)
    assert program.build() == made.image
    assert assemble(programs.source_of(program)).image == made.image


def test_a_source_in_latin_1() -> None:
    source = "vmthread M\n{\nSTRINGS(DUPLICATE, 'ä', 'ä')\n}\n".encode("latin-1")
    for dialect in BOTH:
        assert _codes(source, dialect)[0] == "7d 05 80 e4 00 80 e4 00 0a"
