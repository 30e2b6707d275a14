"""Texts that are made to keep us busy: twice the text takes at most about twice the time, and little memory."""

from __future__ import annotations

import tracemalloc

import pytest
from support.cpu_time import Work, assert_linear, seconds
from support.effort import effort
from support.notations import EXAMPLES

from ev3proto.text.paste import read_text

HOSTILE = {
    "hex without end": ("0f", 1),
    "hex in one line": ("0f 00 ", 1),
    "frames that lack a byte": ("0f 00 00 00 80 00 00 94 01 81 02 82 e8 03 82 e8 ", 1),
    "length fields": ("ff 03 00 00 80 00 00 01 ", 1),
    "0x": ("0x\n", 10),
    "strings without end": ('"\\x0f', 2),
    "quotes": ('"', 1),
    "brackets": ("{[(", 1),
    "lists without end": ("[1,\n", 10),
    "base64": ("QUJDREVGR0hJSktMTU5PUFFS", 1),
    "rows of a frame without end": ("ff 03 00 00 80 00 00 94\n", 6),
    "rows that are left out": ("00000000  0f 00 00 00\n*\n", 10),
    "repeats": ("0x0 <repeats 999 times>, ", 20),
    "comments": ("/* 1", 1),
    "calls": ("put(0x0f);", 2),
    "colons": ("|0f", 2),
    "minus": ("-1 ", 2),
    "labels": ("ff03 x\n", 10),
    "calls behind quotes": ("'LV0(0)#", 1),
    "announcements": ("sent:\n", 10),
    "frames between words": ("0e002a0080000094 x ", 2),
    "arrays with comments": ("{/*", 1),
    "pairs": ("0: 1, ", 2),
}
SHAPES = ("{whole} ", "{whole} x ", "{cut} x ", "{rows}\n")
SIZE = effort(1 << 12, 1 << 17)
MOST_SIZE = 1 << 17
"""Maximum characters of a text: a line of more than eight times that is not read."""


@pytest.mark.parametrize("name", HOSTILE)
def test_twice_the_text_takes_twice_the_time(name: str) -> None:
    unit, share = HOSTILE[name]

    def reading(size: int) -> Work:
        # Odd, so that what is open at the end of the short text is so at the end of the long one.
        count = size // share // len(unit) | 1
        lines = (unit * count).splitlines(keepends=True)
        return lambda: [None for _ in read_text(lines)]

    assert_linear(reading, SIZE, MOST_SIZE)


def test_rows_of_zeros_after_a_faulty_frame_take_linear_time() -> None:
    frame, zeros = f"08 00 2a 00 00 04 00 ff 01 60{' 00' * 6}\n", f"{'00 ' * 15}00\n"

    def reading(size: int) -> Work:
        lines = [frame, *[zeros] * (size // len(zeros))]
        return lambda: [None for _ in read_text(lines)]

    assert_linear(reading, SIZE, MOST_SIZE)


@pytest.mark.parametrize("rows", EXAMPLES[:: effort(60, 1)])
def test_eight_times_the_notation_takes_at_most_ten_times_the_time(rows: str) -> None:
    whole = " ".join(rows.split("\n"))
    for shape in SHAPES:
        unit = shape.format(whole=whole, cut=whole[: len(whole) * 3 // 5], rows=rows)

        def reading(size: int, unit: str = unit) -> Work:
            lines = (unit * (size // len(unit) + 1)).splitlines(keepends=True)
            return lambda: [None for _ in read_text(lines)]

        assert_linear(reading, SIZE, MOST_SIZE)


def test_a_line_of_a_mebibyte_is_read_in_seconds() -> None:
    text = "0e002a0080000094 x " * (effort(1 << 17, 1 << 20) // 19)
    assert seconds(lambda: list(read_text([text]))) < effort(10, 80)


def test_memory_does_not_grow_with_the_text() -> None:
    lines = (f"12:30:45 sent {number % 256:02x} 00 00 00 80 00 00 94\n" for number in range(effort(1_000, 200_000)))
    tracemalloc.start()
    try:
        for _ in read_text(lines):
            pass
        assert tracemalloc.get_traced_memory()[1] < 8 << 20
    finally:
        tracemalloc.stop()
