"""Texts and arrays on the virtual brick, INFO and the rest of sections that give texts, as measured on the firmware."""

from __future__ import annotations

import math

import pytest
from support.bricks import FAIL, OK, command, op, run

from ev3proto.brick import Brick
from ev3proto.messages import GV, LV


def text(brick: Brick, *code: bytes, size: int = 80) -> bytes:
    """The text that operations leave at GV0."""
    brick.receive(command(op("MOVE8_8", 0, GV(0)), reply=False))
    kind, memory = run(brick, *code, globals=size)
    assert kind == OK
    return memory.partition(b"\0")[0]


@pytest.mark.parametrize(
    ("name", "values", "expected"),
    [
        ("ADD", ("con", "cat"), b"concat"),
        ("DUPLICATE", ("once",), b"once"),
        ("STRIP", (" a b\tc ",), b"ab\tc"),
        ("SUB", ("hello world", "o "), b"world"),
        ("SUB", ("hello", ""), b"hello"),
        ("SUB", ("hello", "x"), b"null)"),
        ("SUB", ("hello", "xyz"), b"ll)"),
        ("NUMBER_TO_STRING", (7, 4), b"0007"),
        ("NUMBER_TO_STRING", (-7, 4), b"-007"),
        ("NUMBER_TO_STRING", (12345, 3), b"123"),
        ("NUMBER_TO_STRING", (-12345, 4), b"-123"),
        ("VALUE_TO_STRING", (2.5, 4, 2), b"2.5"),
        ("VALUE_TO_STRING", (2.5, 6, 2), b"  2.5"),
        ("VALUE_TO_STRING", (123.456, 4, 2), b"123"),
        ("VALUE_TO_STRING", (100.0, 3, 1), b"1"),
        ("VALUE_TO_STRING", (100.0, 3, 0), b"100"),
        ("VALUE_TO_STRING", (0.0, 4, 2), b"0"),
        ("VALUE_TO_STRING", (1.25, -8, 3), b"1.25"),
        ("VALUE_TO_STRING", (-1.5, -3, 1), b"-1"),
        ("VALUE_TO_STRING", (math.nan, 6, 2), b"  ----"),
        ("VALUE_TO_STRING", (math.nan, 3, 2), b"---"),
        ("VALUE_TO_STRING", (math.nan, -6, 2), b"----  "),
        ("VALUE_TO_STRING", (5.0, 0, 2), b""),
        ("VALUE_FORMATTED", (0.1, "%.10f", 20), b"0.1000000015"),
        ("VALUE_FORMATTED", (3.14159, "%5.2f!", 20), b" 3.14!"),
        ("VALUE_FORMATTED", (-2.0, "%07.2f", 20), b"-002.00"),
        ("VALUE_FORMATTED", (1e6, "%e", 20), b"1.000000e+06"),
        ("VALUE_FORMATTED", (1234.5, "%g", 20), b"1234.5"),
        ("VALUE_FORMATTED", (math.nan, "%6.2f", 20), b"   nan"),
        ("VALUE_FORMATTED", (-math.inf, "%f", 20), b"-inf"),
        ("VALUE_FORMATTED", (3.14159, "%f", 5), b"3.14"),
        ("NUMBER_FORMATTED", (255, "%X", 20), b"FF"),
        ("NUMBER_FORMATTED", (-1, "%x", 20), b"ffffffff"),
        ("NUMBER_FORMATTED", (-1, "%u", 20), b"4294967295"),
        ("NUMBER_FORMATTED", (42, "%05d|", 20), b"00042|"),
        ("NUMBER_FORMATTED", (42, "%-5d|", 20), b"42   |"),
        ("NUMBER_FORMATTED", (42, "%+d", 20), b"+42"),
        ("NUMBER_FORMATTED", (8, "%#o", 20), b"010"),
        ("NUMBER_FORMATTED", (65, "%c", 20), b"A"),
        ("NUMBER_FORMATTED", (5, "%.3d", 20), b"005"),
        ("NUMBER_FORMATTED", (5, "100%%", 20), b"100%"),
        ("NUMBER_FORMATTED", (12345, "%d", 4), b"123"),
        ("NUMBER_FORMATTED", (1, "%99999999d", 10), b" " * 9),
    ],
)
def test_strings(brick: Brick, name: str, values: tuple[object, ...], expected: bytes) -> None:
    assert text(brick, op(f"STRINGS.{name}", *values, GV(0))) == expected


def test_sizes_and_comparisons(brick: Brick) -> None:
    code = (
        op("STRINGS.GET_SIZE", "four", GV(0)),
        op("STRINGS.COMPARE", "same", "same", GV(2)),
        op("STRINGS.COMPARE", "same", "Same", GV(3)),
    )
    assert run(brick, *code, globals=4) == (OK, bytes((4, 0, 1, 0)))


def test_nothing_is_cleared_behind_the_zero(brick: Brick) -> None:
    code = op("STRINGS.DUPLICATE", "abcdef", GV(0)), op("STRINGS.DUPLICATE", "x", GV(0))
    assert run(brick, *code, globals=7) == (OK, b"x\0cdef\0")


@pytest.mark.parametrize(
    ("source", "expected"),
    [("1.5", "0000c03f"), ("  -2,5abc", "000020c0"), ("1e2", "0000c842"), ("0x10", "00008041"), ("inf", "0000807f")],
)
def test_a_number_is_read_from_a_text(brick: Brick, source: str, expected: str) -> None:
    assert run(brick, op("STRINGS.STRING_TO_VALUE", source, GV(0)), globals=4) == (OK, bytes.fromhex(expected))


def test_a_comma_becomes_a_point_in_the_source(brick: Brick) -> None:
    code = op("STRINGS.DUPLICATE", "1,5", GV(4)), op("STRINGS.STRING_TO_VALUE", GV(4), GV(0))
    assert run(brick, *code, globals=8) == (OK, bytes.fromhex("0000c03f") + b"1.5\0")


@pytest.mark.parametrize(
    ("name", "values", "elements"),
    [
        ("ADD", ("abc", "de"), 6),
        ("DUPLICATE", ("abc",), 4),
        ("STRIP", ("a b c",), 6),
        ("SUB", ("hello", "l"), 6),
        ("NUMBER_TO_STRING", (7, 4), 6),
        ("VALUE_TO_STRING", (1.0, -8, 2), 10),
        ("VALUE_FORMATTED", (1.0, "%.2f", 3), 5),
        ("NUMBER_FORMATTED", (12345, "%d", 3), 6),
    ],
)
def test_an_array_is_resized_to_what_is_needed(
    brick: Brick, name: str, values: tuple[object, ...], elements: int
) -> None:
    code = (
        op("ARRAY.CREATE8", 1, LV(0)),
        op(f"STRINGS.{name}", *values, LV(0, handle=True)),
        op("ARRAY.SIZE", LV(0), GV(0)),
    )
    assert run(brick, *code, globals=4, locals=2) == (OK, elements.to_bytes(4, "little"))


@pytest.mark.parametrize(("note", "frequency"), [("C4", 262), ("A#6", 1865), ("c4", 440), ("", 440), ("H4", 440)])
def test_notes(brick: Brick, note: str, frequency: int) -> None:
    assert run(brick, op("NOTE_TO_FREQ", note, GV(0)), globals=2) == (OK, frequency.to_bytes(2, "little"))


@pytest.mark.parametrize(
    ("port", "expected"),
    [(21, (0, 3, 1)), (112, (0, 3, 0)), (234, (1, 12, 0)), (1, (0, 1, 0)), (0, (0, 0, 0))],
)
def test_motor_ports(brick: Brick, port: int, expected: tuple[int, ...]) -> None:
    code = op("PORT_CNV_OUTPUT", port, GV(0), GV(1), GV(2))
    assert run(brick, code, globals=3) == (OK, bytes(expected))


@pytest.mark.parametrize(("port", "expected"), [(103, (0, 2)), (201, (1, 0)), (4, (0, 3)), (0, (0, 0xFF))])
def test_sensor_ports(brick: Brick, port: int, expected: tuple[int, ...]) -> None:
    assert run(brick, op("PORT_CNV_INPUT", port, GV(0), GV(1)), globals=2) == (OK, bytes(expected))


# INFO


@pytest.mark.parametrize(
    ("error", "length", "expected"),
    [
        (19, 40, b"VM_PROGRAM_VALIDATION"),
        (33, 40, b"OUT_OF_MEMORY"),
        (0, 40, b""),
        (34, 40, b"Number 34"),
        (100, 40, b"Number 100"),
        (19, 5, b"VM_P"),
        (19, -1, b"VM_PROGRAM_VALIDATION"),
    ],
)
def test_names_of_errors(brick: Brick, error: int, length: int, expected: bytes) -> None:
    assert text(brick, op("INFO.ERRORTEXT", error, length, GV(0))) == expected


def test_the_log_of_errors_holds_seven() -> None:
    brick = Brick()
    run(brick, *(op("INFO.SET_ERROR", number) for number in range(9)))
    found = run(brick, *(op("INFO.GET_ERROR", GV(index)) for index in range(9)), globals=9)
    assert found == (OK, bytes((1, 2, 3, 4, 5, 6, 7, 0, 0)))


def test_volume_and_minutes_are_plain_bytes() -> None:
    brick = Brick()
    before = op("INFO.GET_VOLUME", GV(0)), op("INFO.GET_MINUTES", GV(1))
    set_ = op("INFO.SET_VOLUME", -3), op("INFO.SET_MINUTES", 121)
    after = op("INFO.GET_VOLUME", GV(2)), op("INFO.GET_MINUTES", GV(3)), op("KEEP_ALIVE", GV(4))
    assert run(brick, *before, *set_, *after, globals=5) == (OK, bytes((100, 30, 0xFD, 121, 121)))


def test_timers_count_from_the_start_of_the_command() -> None:
    brick = Brick()
    brick.advance(5)
    code = op("TIMER_READ", GV(0)), op("TIMER_WAIT", 7, GV(4)), op("TIMER_READ_US", GV(8))
    kind, memory = run(brick, *code, globals=12)
    numbers = [int.from_bytes(memory[at : at + 4], "little") for at in (0, 4, 8)]
    assert (kind, numbers) == (OK, [0, 5007, 5_000_000])


# Arrays


def test_the_first_array_is_1_and_a_deleted_number_is_used_again(brick: Brick) -> None:
    code = (
        op("ARRAY.CREATE8", 4, GV(0)),
        op("ARRAY.CREATE16", 4, GV(2)),
        op("ARRAY.DELETE", 1),
        op("ARRAY.CREATEF", 4, GV(4)),
        op("ARRAY.SIZE", 2, GV(8)),
        op("ARRAY.READ_SIZE", -1, 2, GV(12)),
    )
    kind, memory = run(brick, *code, globals=16)
    assert (kind, memory[:6]) == (OK, bytes((1, 0, 2, 0, 1, 0)))
    assert memory[8:] == bytes((4, 0, 0, 0, 8, 0, 0, 0))


@pytest.mark.parametrize(
    "failing",
    [
        op("ARRAY.RESIZE", 9, 4),
        op("ARRAY.COPY", 1, 9),
        op("ARRAY.COPY", 1, 2),
        op("ARRAY.INIT8", 9, 0, 1, [1]),
        op("ARRAY.INIT8", 1, -1, 1, [1]),
        op("ARRAY.INIT8", 1, 3, 2, [1, 2]),
        op("ARRAY.READ_CONTENT", -1, 9, 0, 1, GV(0)),
        op("ARRAY.READ_CONTENT", -1, 1, -1, 1, GV(0)),
        op("ARRAY.WRITE_CONTENT", -1, 9, 0, 1, GV(0)),
        op("ARRAY.WRITE_CONTENT", -1, 1, -1, 1, GV(0)),
        op("ARRAY_READ", 9, 0, GV(0)),
        op("ARRAY_READ", 1, 4, GV(0)),
        op("ARRAY_READ", 1, -1, GV(0)),
        op("ARRAY_WRITE", 9, 0, 5),
        op("ARRAY_WRITE", 1, -1, 5),
        op("ARRAY_APPEND", 9, 5),
        op("ARRAY.CREATE8", 7_000_000, GV(0)),
    ],
)
def test_failures_of_arrays(brick: Brick, failing: bytes) -> None:
    arrays = op("ARRAY.CREATE8", 4, LV(0)), op("ARRAY.CREATE16", 4, LV(2))
    assert run(brick, *arrays, failing, locals=4)[0] == FAIL


@pytest.mark.parametrize(
    "harmless",
    [
        op("ARRAY.DELETE", 9),
        op("ARRAY.SIZE", 9, GV(0)),
        op("ARRAY.READ_SIZE", -1, 9, GV(0)),
        op("ARRAY.CREATE8", -5, GV(4)),
        op("ARRAY.CREATE8", 0, GV(4)),
        op("ARRAY.CREATE8", 5_000_000, GV(4)),
    ],
)
def test_no_failures_of_arrays(brick: Brick, harmless: bytes) -> None:
    kind, memory = run(brick, op("MOVE32_32", 0, GV(0)), harmless, globals=4)
    assert (kind, memory) == (OK, bytes(4))


@pytest.mark.parametrize("endless", [op("ARRAY.FILL", 9, 1), bytes.fromhex("C1 1F"), op("BP0")])
def test_operations_that_are_repeated_for_ever(endless: bytes) -> None:
    brick = Brick()
    assert brick.receive(command(endless)) == []
    assert brick.advance(2) == []


def test_filling_copying_initialising(brick: Brick) -> None:
    code = (
        op("ARRAY.CREATE16", 3, LV(0)),
        op("ARRAY.CREATE16", 1, LV(2)),
        op("ARRAY.FILL", LV(0), -2),
        op("ARRAY.INIT16", LV(0), 1, 2, [10, 20]),
        op("ARRAY.COPY", LV(0), LV(2)),
        op("ARRAY.READ_CONTENT", -1, LV(2), 0, 8, GV(0)),
    )
    assert run(brick, *code, globals=8, locals=4) == (OK, bytes.fromhex("FEFF 0A00 1400 0000".replace(" ", "")))


def test_the_type_of_init_decides_how_wide_the_values_are(brick: Brick) -> None:
    code = (
        op("ARRAY.CREATE8", 8, LV(0)),
        op("ARRAY.INIT16", LV(0), 0, 2, [1, 2]),
        op("ARRAY.READ_CONTENT", 2, LV(0), 0, 8, GV(0)),
    )
    assert run(brick, *code, globals=8, locals=2) == (OK, bytes((1, 0, 2, 0, 0, 0, 0, 0)))


def test_writing_content_resizes_to_its_end_and_reading_gives_zeros_behind(brick: Brick) -> None:
    code = (
        op("ARRAY.CREATE32", 8, LV(0)),
        op("INIT_BYTES", GV(0), 3, [1, 2, 3]),
        op("ARRAY.WRITE_CONTENT", -1, LV(0), 2, 3, GV(0)),
        op("ARRAY.SIZE", LV(0), GV(4)),
        op("ARRAY.READ_CONTENT", -1, LV(0), 2, 8, GV(8)),
    )
    kind, memory = run(brick, *code, globals=16, locals=2)
    assert (kind, memory[4:8], memory[8:]) == (OK, bytes((2, 0, 0, 0)), bytes((1, 2, 3, 0, 0, 0, 0, 0)))


def test_reading_content_into_an_array_resizes_it(brick: Brick) -> None:
    code = (
        op("ARRAY.CREATE8", 4, LV(0)),
        op("ARRAY.CREATE8", 1, LV(2)),
        op("ARRAY.FILL", LV(0), 5),
        op("ARRAY.READ_CONTENT", -1, LV(0), 1, 6, LV(2, handle=True)),
        op("ARRAY.SIZE", LV(2), GV(0)),
        op("ARRAY_READ", LV(2), 2, GV(4)),
        op("ARRAY_READ", LV(2), 3, GV(5)),
    )
    assert run(brick, *code, globals=6, locals=4) == (OK, bytes((6, 0, 0, 0, 5, 0)))


def test_elements_are_written_behind_the_end_and_appended(brick: Brick) -> None:
    code = (
        op("ARRAY.CREATEF", 0, LV(0)),
        op("ARRAY_WRITE", LV(0), 2, bytes.fromhex("83 0000803F".replace(" ", ""))),
        op("ARRAY_APPEND", LV(0), bytes.fromhex("83 00000040".replace(" ", ""))),
        op("ARRAY.SIZE", LV(0), GV(0)),
        op("ARRAY_READ", LV(0), 3, GV(4)),
    )
    assert run(brick, *code, globals=8, locals=2) == (OK, bytes.fromhex("04000000 00000040".replace(" ", "")))


def test_handles_run_out(brick: Brick) -> None:
    create = op("ARRAY.CREATE8", 1, LV(0))
    assert run(brick, *(create for _ in range(249)), locals=2)[0] == OK
    assert run(brick, *(create for _ in range(250)), locals=2)[0] == FAIL


# Memory of programs


def test_memory_of_the_command_itself(brick: Brick) -> None:
    code = (
        op("INIT_BYTES", LV(0), 4, [1, 2, 3, 4]),
        op("INIT_BYTES", GV(0), 4, [5, 6, 7, 8]),
        op("MEMORY_READ", 2, 1, 1, 5, GV(4)),
        op("MEMORY_READ", 2, 0, -1, 3, GV(9)),
        op("MEMORY_WRITE", 2, 0, 11, 2, LV(0)),
    )
    kind, memory = run(brick, *code, globals=12, locals=4)
    assert (kind, memory) == (OK, bytes((5, 6, 7, 8, 2, 3, 4, 0, 0, 0, 5, 1)))


def test_memory_of_a_stopped_slot_stays_as_it_is(brick: Brick) -> None:
    code = op("MOVE8_8", 9, GV(0)), op("MEMORY_READ", 1, 0, 0, 1, GV(0)), op("MEMORY_READ", 2, 5, 0, 1, GV(0))
    assert run(brick, *code, globals=1) == (OK, b"\x09")


def test_an_unused_brick_has_all_its_memory(brick: Brick) -> None:
    assert run(brick, op("MEMORY_USAGE", GV(0), GV(4)), globals=8) == (OK, (6000).to_bytes(4, "little") * 2)


def test_zeros_that_are_removed_leave_zero_bytes(brick: Brick) -> None:
    brick.receive(command(op("INIT_BYTES", GV(0), 8, [9] * 8), reply=False))
    code = op("STRINGS.VALUE_TO_STRING", 2.5, 5, 3, GV(0))
    assert run(brick, code, globals=8) == (OK, b"2.5\0\0\0\x09\x09")


@pytest.mark.parametrize(
    ("number", "pattern", "expected"),
    [
        (70000, "%hd", b"4464"),
        (-1, "%hu", b"65535"),
        (200, "%hhd", b"-56"),
        (1.0, "%a", b"%a"),
    ],
)
def test_sizes_of_printf(brick: Brick, number: float, pattern: str, expected: bytes) -> None:
    name = "VALUE_FORMATTED" if isinstance(number, float) else "NUMBER_FORMATTED"
    assert text(brick, op(f"STRINGS.{name}", number, pattern, 40, GV(0))) == expected


def test_a_negative_nan_in_a_text_keeps_its_sign(brick: Brick) -> None:
    assert run(brick, op("STRINGS.STRING_TO_VALUE", "-nan", GV(0)), globals=4) == (OK, bytes((0, 0, 0xC0, 0xFF)))


def test_memory_is_copied_byte_by_byte(brick: Brick) -> None:
    code = op("INIT_BYTES", GV(0), 4, [1, 2, 3, 4]), op("MEMORY_READ", 2, 0, 0, 3, GV(1))
    assert run(brick, *code, globals=4) == (OK, bytes((1, 1, 1, 1)))
    code = op("INIT_BYTES", GV(0), 4, [1, 2, 3, 4]), op("MEMORY_WRITE", 2, 0, 1, 3, GV(0))
    assert run(brick, *code, globals=4) == (OK, bytes((1, 1, 1, 1)))


def test_the_text_of_an_error_is_empty_without_room(brick: Brick) -> None:
    code = op("MOVE16_16", 0x0909, GV(0)), op("INFO.ERRORTEXT", 5, 0, GV(0))
    assert run(brick, *code, globals=2) == (OK, bytes((0, 9)))


def test_an_array_for_no_error_gets_26_elements(brick: Brick) -> None:
    code = (
        op("ARRAY.CREATE8", 1, LV(0)),
        op("INFO.ERRORTEXT", 0, -1, LV(0, handle=True)),
        op("ARRAY.SIZE", LV(0), GV(0)),
        op("STRINGS.DUPLICATE", LV(0, handle=True), GV(4)),
    )
    assert run(brick, *code, globals=5, locals=2) == (OK, bytes((26, 0, 0, 0, 0)))


def test_the_number_of_an_error_has_ten_elements_of_an_array(brick: Brick) -> None:
    code = (
        op("ARRAY.CREATE8", 1, LV(0)),
        op("INFO.ERRORTEXT", 127, -1, LV(0, handle=True)),
        op("ARRAY.SIZE", LV(0), GV(0)),
        op("STRINGS.DUPLICATE", LV(0, handle=True), GV(4)),
    )
    assert run(brick, *code, globals=14, locals=2) == (OK, bytes((10, 0, 0, 0)) + b"Number 12\0")


def test_the_rest_of_a_long_text_is_cut_at_1023_characters(brick: Brick) -> None:
    """Before the text that was sought is taken off."""
    code = (
        op("ARRAY.CREATE8", 1200, LV(0)),
        op("ARRAY.FILL", LV(0), ord("x")),
        op("ARRAY_WRITE", LV(0), 1199, 0),
        op("ARRAY.CREATE8", 1, LV(4)),
        op("STRINGS.SUB", LV(0, handle=True), "xx", LV(4, handle=True)),
        op("STRINGS.GET_SIZE", LV(4, handle=True), GV(0)),
    )
    kind, memory = run(brick, *code, globals=2, locals=8)
    assert (kind, int.from_bytes(memory, "little")) == (OK, 1021)
