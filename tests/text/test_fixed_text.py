"""Fixes in texts: only wrong bytes change, in the notation in which they are written."""

from __future__ import annotations

import pytest
from support.cases import each
from support.notations import EXAMPLES, NOTATIONS

import ev3proto
from ev3proto.text.paste import read_text

REFUSED = bytes.fromhex("0e002a0080000094010282b80181e803")
"""A duration of two bytes, announced as one."""
FIXED = bytes.fromhex("0e002a0080000094010282b80182e803")
LONGER = bytes.fromhex("0f002a0080000094018105 82b801 82e803")
"""A volume of 5 in two bytes."""
SHORTER = bytes.fromhex("0e002a00800000940105 82b801 82e803")
LONG_TONE = bytes.fromhex("0f00000080000094018102 82e803 82e803")
SHORTER_TONE = bytes.fromhex("0e000000800000940102 82e803 82e803")

LOG = """\
# my robot, 2024-01-31: the frame 08 00 2A 00 is the start
12:00:01.500 Sent 0x|0E:00|2A:00|00|00:00|94:01|02|82:B8:01|81:E8:03|   // a tone
12:00:01.600 Recv 0x|03:00|2A:00|04|

12:00:02.500 Sent 0x|08:00|2B:00|00|04:00|81|01|60|   // again
12:00:03.500 Sent 0x|08:00|2C:00|00|08:00|81|01|61|   // at an odd place
"""


def frames(text: str) -> list[bytes]:
    return [piece.data for piece in read_text(text.splitlines(keepends=True)) if piece.data]


def test_a_log_keeps_its_comments_times_and_replies() -> None:
    fixed = ev3proto.fix_text(LOG)
    assert fixed.text == LOG.replace("81:E8:03", "82:E8:03")
    assert fixed.is_fixed
    assert fixed.lines == (2,)
    assert [(each.line, each.fix.is_fixed, each.is_written) for each in fixed.frames] == [
        (2, True, True),
        (5, False, True),
        (6, False, True),
    ]
    assert [len(each.fix.report.findings) for each in fixed.frames] == [0, 0, 1]


def test_a_text_without_anything_to_fix_is_the_same() -> None:
    fixed = ev3proto.fix_text("hello\n\n" + FIXED.hex())
    assert (fixed.text, fixed.lines, fixed.is_fixed) == ("hello\n\n" + FIXED.hex(), (), False)
    assert ev3proto.fix_text("").text == ""


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_line_ends_stay(end: str) -> None:
    text = f"a{end}{REFUSED.hex(' ')}{end}b"
    assert ev3proto.fix_text(text).text == f"a{end}{FIXED.hex(' ')}{end}b"


def test_several_frames_in_one_line() -> None:
    fixed = ev3proto.fix_text(f"first {REFUSED.hex(' ')}, then {LONGER.hex()}; done\n")
    assert fixed.text == f"first {FIXED.hex(' ')}, then {SHORTER.hex()}; done\n"


@each("name", NOTATIONS)
def test_a_byte_is_fixed_in_every_notation(name: str) -> None:
    text = f"# 2024-01-31\n{NOTATIONS[name](REFUSED)}\n/* the end */\n"
    fixed = ev3proto.fix_text(text)
    assert frames(fixed.text) == [FIXED], text
    before, after = text.splitlines(), fixed.text.splitlines()
    changed = [number for number, pair in enumerate(zip(before, after, strict=True), 1) if pair[0] != pair[1]]
    assert tuple(changed) == fixed.lines
    assert not {1, len(before)} & {*changed}


NUMBERED = ("Uint8Array {", '{"0"', "Array (", "buf[0]")
"""Notations with the index of each byte, from which none is removed."""


@each("example", EXAMPLES)
def test_a_byte_is_removed_from_the_examples_or_nothing_is_changed(example: str) -> None:
    """Their volume of 2 is in two bytes. Dumps, calls and numbered bytes stay, and what has unknown bytes."""
    text = f"{example}\n"
    (before,) = frames(text)
    fixed = ev3proto.fix_text(text)
    if frames(fixed.text) != [SHORTER_TONE + before[len(LONG_TONE) :]]:
        assert fixed.text == text
        assert "\n" in example or example.startswith((*NUMBERED, "0x0f0x", "0f 00 xx")), text


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (
            "byte[] b = {15, 0, 42, 0, (byte) -128, 0, 0, (byte) -108, 1, (byte) -127, 5, (byte) -126, (byte) -72, 1,"
            " (byte) -126, (byte) -24, 3}; // five",
            "byte[] b = {14, 0, 42, 0, (byte) -128, 0, 0, (byte) -108, 1, 5, (byte) -126, (byte) -72, 1,"
            " (byte) -126, (byte) -24, 3}; // five",
        ),
        (
            "{\n  0x0F, 0x00, 0x2A, 0x00, // length, counter\n  0x80, 0x00, 0x00, 0x94, 0x01,\n"
            "  0x81, 0x05, // volume\n  0x82, 0xB8, 0x01, 0x82, 0xE8, 0x03 };",
            "{\n  0x0E, 0x00, 0x2A, 0x00, // length, counter\n  0x80, 0x00, 0x00, 0x94, 0x01,\n"
            "  0x05, // volume\n  0x82, 0xB8, 0x01, 0x82, 0xE8, 0x03 };",
        ),
        (
            "b'\\x0f\\x00*\\x00\\x80\\x00\\x00\\x94\\x01\\x81\\x05\\x82\\xb8\\x01\\x82\\xe8\\x03'",
            "b'\\x0e\\x00*\\x00\\x80\\x00\\x00\\x94\\x01\\x05\\x82\\xb8\\x01\\x82\\xe8\\x03'",
        ),
        ("15 0 42 0 128 0 0 148 1 129 5 130 184 1 130 232 3", "14 0 42 0 128 0 0 148 1 5 130 184 1 130 232 3"),
        ("f 0 2a 0 80 0 0 94 1 81 5 82 b8 1 82 e8 3", "e 0 2a 0 80 0 0 94 1 5 82 b8 1 82 e8 3"),
        ("DwAqAIAAAJQBgQWCuAGC6AM=", "DgAqAIAAAJQBBYK4AYLoAw=="),
    ],
)
def test_bytes_are_removed_in_place(before: str, after: str) -> None:
    assert ev3proto.fix_text(before).text == after
    assert frames(after) == [SHORTER]


def test_bytes_that_look_moved_are_edited_in_place() -> None:
    """Both bytes of the length change: 00 0E becomes 0E 00."""
    swapped = FIXED[1::-1] + FIXED[2:]
    assert ev3proto.fix_text(f"# mine\n{swapped.hex(' ')}\n").text == f"# mine\n{FIXED.hex(' ')}\n"


def test_rows_of_a_dump_keep_their_size() -> None:
    """Encodings are not shortened there, and another byte is fixed all the same."""
    dump = (
        "00000000  15 00 2a 00 80 00 00 96  96 96 96 96 96 94 01 81  |..*.............|\n"
        "00000010  05 82 b8 01 81 e8 03                              |.......|\n"
    )
    fixed = ev3proto.fix_text(dump)
    assert fixed.text == dump.replace("01 81 e8", "01 82 e8")
    assert fixed.frames[0].is_written
    broken = frames(dump)[0]
    assert len(ev3proto.fix(broken).frame) < len(broken) == len(frames(fixed.text)[0])


def test_a_frame_that_cannot_be_edited_stays_as_it_is() -> None:
    dump = (
        "00000000  0f 00 2a 00 80 00 00 94  01 81 05 82 b8 01 82 e8  |..*.............|\n"
        "00000010  03                                                |.|\n"
    )
    fixed = ev3proto.fix_text(dump)
    assert (fixed.text, fixed.is_fixed) == (dump, False)
    (frame,) = fixed.frames
    assert (frame.is_written, frame.fix.frame) == (False, SHORTER)
    assert [finding.code for finding in frame.report.findings] == ["H901"]


def test_the_size_is_kept_on_request() -> None:
    assert ev3proto.fix(LONGER).frame == SHORTER
    kept = ev3proto.fix(LONGER, shorten=False)
    assert (kept.frame, kept.is_fixed) == (LONGER, False)
