"""Frames whose length or type is wrong are frames all the same: `check` names the fault, in every notation."""

from __future__ import annotations

import base64
from collections.abc import Callable
from itertools import product

import pytest
from support.cases import each
from support.cli import run_ev3proto
from support.notations import NOTATIONS

from ev3proto.text.paste import read_argument, read_text

TONE = bytes.fromhex("0f 00 00 00 80 00 00 94 01 81 02 82 e8 03 82 e8 03")
SENSOR = bytes.fromhex("0a 00 2a 00 00 08 00 a8 00 00 60 64")


def headed(frame: bytes, length: int) -> bytes:
    return length.to_bytes(2, "little") + frame[2:]


HEADS: dict[str, tuple[Callable[[bytes], bytes], str]] = {
    "length one too small": (lambda frame: headed(frame, len(frame) - 3), "E103"),
    "length three too small": (lambda frame: headed(frame, len(frame) - 5), "E103"),
    "length counts itself": (lambda frame: headed(frame, len(frame)), "E102"),
    "length bytes swapped": (lambda frame: headed(frame, len(frame) - 2 << 8), "E102"),
    "unknown type": (lambda frame: frame[:4] + b"\x40" + frame[5:], "E105"),
}
WITH_HEADS = (
    *("hex", "blanks", "colons", "lesson", "0x and commas", "pairs of bytes", "decimals", "signed decimals"),
    *("C", "Java", "Kotlin", "Go", "Visual Basic", "Pascal", "Chr()", "repr", "octal escapes", "fromhex"),
    *("hexdump -C", "xxd", "C with remarks", "calls"),
)


WORDS = (("pairs of bytes", "length bytes swapped"), ("xxd", "length bytes swapped"))
"""As words of two bytes, these have the right length."""


@each("name, head", [one for one in product(WITH_HEADS, HEADS) if one not in WORDS])
def test_a_wrong_head_is_named_in_every_notation(name: str, head: str) -> None:
    make, code = HEADS[head]
    frame = make(TONE)
    text = NOTATIONS[name](frame)
    done = run_ev3proto("check", "-", stdin=text.encode())
    said = done.stdout.decode()
    assert code in said, text
    assert "help:" in said
    assert [piece.data for piece in read_text(text.splitlines(keepends=True))] == [frame]


def test_a_wrong_frame_in_a_line_of_strace() -> None:
    wrong = headed(TONE, len(TONE) - 1)
    escaped = NOTATIONS["hex escapes"](wrong)
    (piece,) = read_text([f'write(3, "{escaped}", 17) = 17\n'])
    assert (piece.data, piece.problem) == (wrong, None)


def test_a_wrong_type_in_base64() -> None:
    wrong = HEADS["unknown type"][0](TONE)
    text = base64.b64encode(wrong).decode()
    for line in (text, f"sent {text}", f'{{"data": "{text}"}}'):
        assert [(piece.data, piece.problem) for piece in read_text([f"{line}\n"])] == [(wrong, None)]


def test_a_length_too_small_in_an_object_with_indexes() -> None:
    line = ", ".join(f'"{at}": {byte}' for at, byte in enumerate([*TONE, 7]))
    assert [piece.data for piece in read_text([f"{{{line}}}\n"])] == [TONE + b"\x07"]


def test_the_check_sum_below_a_wrong_frame_in_btmon() -> None:
    wrong = headed(TONE, len(TONE) - 5)
    head = "      RFCOMM: Unnumbered Info with Header Check (UIH) (0xef)\n         Length: 17\n         FCS: 0x9a\n"
    rows = f"        {wrong[:16].hex(' ')}  ................\n        {wrong[16:].hex(' ')} 9a       ..\n"
    assert [piece.data for piece in read_text((head + rows).splitlines(keepends=True))] == [wrong]


UNKNOWN_TYPE = "0900e31a06003f0273f529"


@pytest.mark.parametrize("form", ["{}", "{}  ", "0x{}", "Sent {}", "'{}'"])
def test_a_wrong_type_in_hex_without_blanks(form: str) -> None:
    text = form.format(UNKNOWN_TYPE)
    (piece,) = read_text([f"{text}\n"])
    assert (piece.data.hex(), piece.problem) == (UNKNOWN_TYPE, None)
    assert read_argument(text).data == piece.data


@pytest.mark.parametrize("form", ["12:30:45 sent {}", "{}", "0x|{}|", "Sent 0x|{}|"])
def test_two_lines_with_the_same_wrong_length(form: str) -> None:
    wrong = headed(TONE, len(TONE))
    text = f"{form.format(wrong.hex(':'))}\n" * 2
    assert [(piece.line, piece.data) for piece in read_text(text.splitlines())] == [(1, wrong), (2, wrong)]


@each("name, head", product(("blanks", "C", "repr", "hexdump -C", "lesson"), HEADS))
def test_a_wrong_head_of_a_command_with_a_reply(name: str, head: str) -> None:
    frame = HEADS[head][0](SENSOR)
    assert [piece.data for piece in read_text(NOTATIONS[name](frame).splitlines(keepends=True))] == [frame]


SLIPS = {
    "0e 00 2a 00 80 00 00 G8 01 01 82 b8 01 82 e8 03": (7, "column 22: 'G8' is not hex"),
    r"\x0e\x00\x2a\x00\x80\x00\x00\x94\x01\xof\x82\xb8\x01\x82\xe8\x03": (9, r"column 37: '\\xof' is not an escape"),
    r'x = "\x0e\x00\x2a\x00\x80\x00\x00\x94\x01\xof\x82"': (9, r"column 42: '\\xof' is not an escape"),
    "x = {0x0e, 0x00, 0x2a, 0x00, 0x80, 0xG0}": (5, "column 36: '0xG0' is not a number"),
    "Sent 0E002A008000009": (7, "column 6: '0E002A008000009' has an odd number of hex digits (15)"),
    "Recv 03 00 2a 00 zz": (4, "column 18: 'zz' is not hex"),
    "Sent 0x|0E:0G|2A:00|": (1, "column 12: '0G' is not hex"),
    "Sent {14, 0, 300}": (2, "column 14: '300' is more than 255"),
    r"Sent b'\x0e\x00*": (3, "column 6: the string that starts here never ends"),
    r"Sent b'\x0e\x00\xzz'": (2, r"column 16: '\\xzz' is not an escape"),
    r"Sent \x0e\x00\xzz": (2, r"column 14: '\\xzz' is not an escape"),
    "Sent bytes.fromhex('0e002a00800')": (5, "column 21: '0e002a00800' has an odd number"),
    "0000  0e 00 2a 00 80 0g 00\n0010  01": (5, "column 22: '0g' is not hex"),
    "0000  0e 00 2a 00 80\n*\n0020  00 00": (5, "line 3: the dump leaves lines out here, as the * tells"),
    "0x|ZZ:00|2A:00|80|00:00|94|": (0, "column 4: 'ZZ' is not hex"),
}


@pytest.mark.parametrize("text", SLIPS)
def test_a_slip_is_named_with_its_column(text: str) -> None:
    size, problem = SLIPS[text]
    (piece,) = read_text(f"first\n{text}\nlast\n".splitlines(keepends=True))
    assert (len(piece.data), piece.line) == (size, 2)
    assert problem in (piece.problem or "")


BREAKS_OFF = {
    "x 0f 00 00 00 80 00 00 94 01 81 02 82 e8 03 82 e8": 16,
    "// 0f 00 00 00 80 00 00 94": 8,
    "say 0x0f, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00": 7,
    "say [15, 0, 0, 0, 128, 0, 0, 148] to it": 8,
    "{14, 0, 42, 0, 128}": 5,
    "09:00|2A:00|80|00:00|81|01|60|": 10,
    "Recv 03 00 2A 00": 4,
    "12:30:45.123 RX: 07 00 2A": 3,
}


@pytest.mark.parametrize("text", BREAKS_OFF)
def test_the_start_of_a_frame_is_given_out(text: str) -> None:
    (piece,) = read_text(f"first\n{text}\nlast\n".splitlines(keepends=True))
    assert (len(piece.data), piece.problem) == (BREAKS_OFF[text], None)


BARE = {
    "00 00 80 00 00 94 01 81 02 82 e8 03 82 e8 03": "this is a frame without its length bytes",
    "94 01 81 02 82 e8 03 82 e8 03": "these are operations without the header of a frame",
    "0e 2a 00 80 00 00 94 01 01 82 b8 01 82 e8 03": "this is a frame whose length has one byte; it needs two, the low"
    " one first",
}


@pytest.mark.parametrize("text", BARE)
def test_what_lacks_its_header_is_named(text: str) -> None:
    (piece,) = read_text(["first\n", f"{text}\n", "last\n"])
    assert (piece.data, piece.line) == (b"", 2)
    assert piece.problem == read_argument(text).problem == BARE[text]


@pytest.mark.parametrize("text", ["09 00 00 00 80 00 00 A4 00 01 14 A6 00 01", "03 00 2a 00 7f"])
def test_what_begins_like_a_frame_is_never_told_an_option(text: str) -> None:
    assert all(piece.problem is None for piece in read_text([text]))
    assert read_argument(text).problem is None


NUMBERS = (
    "Sent 12 of 40",
    "Recv 4 bytes",
    "Received 12 01 24 within 3 ms",
    "2024-01-02 12:30:45 Sent command 03 00",
    "send 01 02",
    "Recv 200 300 400",
    "sent 3 0 2",
)


@pytest.mark.parametrize("text", NUMBERS)
def test_other_numbers_do_not_start_a_frame(text: str) -> None:
    assert [piece.data for piece in read_text([text, f"Sent {TONE.hex(' ')}", text])] == [TONE]


AND_A_CUT_ONE = {
    "{tone} 08 00 2B 00 00 04 81 01": "08 00 2B 00 00 04 81 01",
    "{tone};08002B0000048101": "08 00 2B 00 00 04 81 01",
    "Sent {tone} Recv 03 00 2A 00": "03 00 2A 00",
    "Sent {tone}, received 07 00 2A 00 02 66": "07 00 2A 00 02 66",
    "{tone} then 08 00 2B 00 00 04 81": "08 00 2B 00 00 04 81",
    "[15, 0, 0, 0, 128, 0, 0, 148, 1, 129, 2, 130, 232, 3, 130, 232, 3] [8, 0, 43, 0, 128]": "08 00 2B 00 80",
}


@pytest.mark.parametrize("text", AND_A_CUT_ONE)
def test_a_cut_frame_behind_another_one_is_given_out(text: str) -> None:
    line = text.format(tone=TONE.hex(" "))
    first, second = read_text([line])
    assert (first.data, first.problem) == (TONE, None)
    assert (second.data.hex(" ").upper(), second.problem) == (AND_A_CUT_ONE[text], None)
    assert line.rindex(second.text) + 1 == second.column
    assert second.direction == ("received" if "ec" in text else None)


def test_a_long_frame_has_none_behind_it() -> None:
    frame = bytes.fromhex("c0 01 2a 00 02") + TONE[:-4] * 34 + bytes(1)
    frame = (len(frame) - 2).to_bytes(2, "little") + frame[2:]
    assert [piece.data for piece in read_text([f"Recv {frame.hex(' ')} ok 12"])] == [frame]


LEFT_OVER = bytes.fromhex("07 00 01 00 02 00 00 48 42") + bytes.fromhex("99 1d 00 00 00 02 01 60").ljust(1015, b"\0")
REPORTS = {
    "a row": f"RX {LEFT_OVER.hex(' ')}",
    "a report number": f"RX 00 {LEFT_OVER.hex(' ')}",
    "a mark of an empty buffer": f"RX ff ff ff ff {LEFT_OVER.hex(' ')}",
    "Python": f"print({LEFT_OVER!r})",
    "xxd": NOTATIONS["xxd"](LEFT_OVER[:32]),
    "hexdump -C": NOTATIONS["hexdump -C"](bytes.fromhex("07 00 01 00 02 00 00 48 42") + b"hello world" + bytes(12)),
}


@pytest.mark.parametrize("name", REPORTS)
def test_the_frame_at_the_start_of_a_report_wins(name: str) -> None:
    done = run_ev3proto("decode", "-", stdin=REPORTS[name].encode())
    said = done.stdout.decode()
    assert "DIRECT_REPLY, counter 1, 9 bytes" in said
    assert "left-over bytes follow the frame: " in said
    assert said.count("counter") == 1
    assert done.returncode == 0


def test_a_second_frame_behind_the_first_is_another_one() -> None:
    reply = bytes.fromhex("03 00 2a 00 02")
    assert [piece.data for piece in read_text([(TONE + reply).hex(" ")])] == [TONE, reply]


def test_a_wrong_length_does_not_swallow_the_lines_below() -> None:
    lines = ["0e002a0080000094010182b80182e803\n", "2e002a0080000094010182b80182e8\n", "06002a0080000001\n"]
    assert [piece.data.hex() for piece in read_text(lines)] == [line.strip() for line in lines]


ONE_A_LINE = ("{}", "cmd[{at}] = {};", "  {at}: {}", "12:34:56.789 -> {}")


@pytest.mark.parametrize("form", ONE_A_LINE)
def test_bytes_below_a_frame_of_one_byte_a_line_are_reported(form: str) -> None:
    lines = [form.format(byte, at=at) + "\n" for at, byte in enumerate([*TONE, 7, 8])]
    assert [piece.data for piece in read_text(lines[:17])] == [TONE]
    frame, rest = read_text(lines[:18])
    assert (frame.data, frame.problem, rest.data, rest.line) == (TONE, None, b"", 18)
    assert rest.problem == "1 byte follows the frame that ends in line 17: 7"
    assert [*read_text(lines)][1].problem == "2 bytes follow the frame that ends in line 17: 7 8"
    assert [piece.data for piece in read_text([*lines[:17], *lines[:17]])] == [TONE, TONE]


def test_rows_of_a_dump_below_a_complete_frame_are_reported() -> None:
    dump = NOTATIONS["xxd"](TONE)
    assert [piece.data for piece in read_text([*dump.splitlines(), "00000011: 0708 09"])] == [TONE, b""]
