"""The form of a report: reports made by hand, and the exact lines that users see."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import pytest

import ev3proto
from ev3proto.checking.report import Change, Finding, Fix, Report, Severity
from ev3proto.text.diagnostics import MOST_ALIKE, diagnostics, fixed, grouped_hex
from ev3proto.text.paste import read_text
from ev3proto.text.spans import Line, Role, plain_text

ERROR, WARNING, HINT = Severity.ERROR, Severity.WARNING, Severity.HINT
TONE = bytes.fromhex("0e002a0080000094010182c80082e803")
LOW = Finding(ERROR, "E1", 10, 3, "the pitch is too low", "give a higher one", "SOUND.TONE", "FREQUENCY")
LONG = Finding(HINT, "H1", 10, 3, "the encoding is long", "give a shorter one", "SOUND.TONE", "FREQUENCY")
QUIET = Finding(WARNING, "W1", 9, 1, "it is inaudible", "make it louder", "SOUND.TONE", "VOLUME")
LENGTH = Finding(ERROR, "E2", 0, 2, "the length is wrong", "count again")


def report(frame: bytes, *findings: Finding, rejected_at: int | None = None) -> Report:
    return Report(frame, rejected_at is None, rejected_at, findings)


def texts(lines: Iterable[Line]) -> list[str]:
    return [plain_text(line) for line in lines]


def test_a_frame_without_findings() -> None:
    assert texts(diagnostics(report(TONE), nearest=())) == ["accepted: no findings"]
    assert texts(diagnostics(report(TONE), place="robot.log, line 3", nearest=())) == [
        "robot.log, line 3: accepted: no findings"
    ]


def test_one_finding() -> None:
    assert texts(diagnostics(report(TONE, LOW, rejected_at=10), nearest=())) == [
        "the brick refuses it at offset 10; 1 error",
        "",
        "error[E1]: the pitch is too low",
        "    --> offset 10, FREQUENCY of SOUND.TONE",
        "     |",
        "  +0 | 0E 00 2A 00 80 00 00 94 01 01 82 C8 00 82 E8 03",
        "     |                               ^^^^^^^^ FREQUENCY = 200 Hz",
        "     = opSOUND, LC0(TONE), LC0(1), LC2(200), LC2(1000)",
        "     = help: give a higher one",
    ]


def test_a_gutter_tells_the_lines_with_bytes() -> None:
    lines = diagnostics(report(TONE, LOW), nearest=())
    assert [plain_text(line)[:6] for line in lines if line and line[0][1] == Role.GUTTER] == [
        "     |",
        "  +0 |",
        "     |",
    ]


def test_findings_on_the_same_bytes_share_them() -> None:
    lines = texts(diagnostics(report(TONE, QUIET, LOW, LONG), place="frame 3", nearest=()))
    assert lines[0] == "frame 3: the brick accepts it; 1 error, 1 warning, 1 hint"
    assert lines[9:] == [
        "",
        "error[E1]: the pitch is too low",
        "hint[H1]: the encoding is long",
        "    --> frame 3, offset 10, FREQUENCY of SOUND.TONE",
        "     |",
        "  +0 | 0E 00 2A 00 80 00 00 94 01 01 82 C8 00 82 E8 03",
        "     |                               ^^^^^^^^ FREQUENCY = 200 Hz",
        "     = opSOUND, LC0(TONE), LC0(1), LC2(200), LC2(1000)",
        "     = help for E1: give a higher one",
        "     = help for H1: give a shorter one",
    ]


def test_only_some_of_the_findings() -> None:
    found = report(TONE, QUIET, LOW, rejected_at=10)
    lines = texts(diagnostics(found, found.errors, nearest=()))
    assert lines[0] == "the brick refuses it at offset 10; 1 error, 1 warning (1 not shown)"
    assert [line for line in lines if "[" in line] == ["error[E1]: the pitch is too low"]


@pytest.mark.parametrize(
    ("offset", "length", "line"),
    [
        (0, 2, "     | ^^^^^ length = 14, 14 bytes follow"),
        (2, 2, "     |       ^^^^^ counter = 42"),
        (4, 1, "     |             ^^ type = DIRECT_COMMAND_NO_REPLY"),
        (5, 2, "     |                ^^^^^ memory: 0 bytes global, 0 bytes local"),
        (7, 1, "     |                      ^^"),
        (8, 1, "     |                         ^^ CMD = 1 TONE"),
        (7, 9, "     |                      ^^^^^^^^^^^^^^^^^^^^^^^^^^ SOUND.TONE"),
        (9, 1, "     |                            ^^ VOLUME = 1 %"),
        (12, 1, "     |                                     ^^"),
    ],
)
def test_the_label_behind_the_underline(offset: int, length: int, line: str) -> None:
    lines = texts(diagnostics(report(TONE, replace(LENGTH, offset=offset, length=length)), nearest=()))
    assert lines[6] == line


def test_what_is_missing_is_marked_behind_the_last_byte() -> None:
    cut = TONE[:13]
    missing = Finding(ERROR, "E3", 13, 0, "an argument is missing", "add it", "SOUND.TONE", "DURATION")
    assert texts(diagnostics(report(cut, missing, rejected_at=13), nearest=()))[3:] == [
        "    --> offset 13, DURATION of SOUND.TONE",
        "     |",
        "  +0 | 0E 00 2A 00 80 00 00 94 01 01 82 C8 00",
        "     |                                        ^^",
        "     = opSOUND, LC0(TONE), LC0(1), LC2(200), ...",
        "     = help: add it",
    ]


def test_what_is_missing_behind_a_full_row_is_marked_in_that_row() -> None:
    missing = replace(LENGTH, offset=16, length=0)
    assert texts(diagnostics(report(TONE, missing), nearest=()))[5:7] == [
        "  +0 | 0E 00 2A 00 80 00 00 94 01 01 82 C8 00 82 E8 03",
        "     |                                                 ^^",
    ]


def test_a_span_over_two_rows() -> None:
    frame = ev3proto.direct_command(*[ev3proto.operation("SOUND.TONE", 1, 200, 1000)] * 2).build()
    second = replace(LENGTH, offset=16, length=9)
    first = replace(LENGTH, offset=15, length=2)
    assert texts(diagnostics(report(frame, first, second), nearest=()))[5:] == [
        "  +0 | 17 00 00 00 80 00 00 94 01 01 82 C8 00 82 E8 03",
        "     |                                              ^^",
        " +16 | 94 01 01 82 C8 00 82 E8 03",
        "     | ^^",
        "     = opSOUND, LC0(TONE), LC0(1), LC2(200), LC2(1000)",
        "     = help: count again",
        "",
        "error[E2]: the length is wrong",
        "    --> offset 16",
        "     |",
        " +16 | 94 01 01 82 C8 00 82 E8 03",
        "     | ^^^^^^^^^^^^^^^^^^^^^^^^^^ SOUND.TONE",
        "     = opSOUND, LC0(TONE), LC0(1), LC2(200), LC2(1000)",
        "     = help: count again",
    ]


def test_a_long_span_is_cut_in_the_middle() -> None:
    frame = ev3proto.direct_command(ev3proto.operation("COM_SET.SET_BRICKNAME", "x" * 200)).build()
    lines = texts(diagnostics(report(frame, replace(LENGTH, offset=9, length=202)), nearest=()))
    rows = [line.split("|")[0].strip() for line in lines if "|" in line]
    assert [row for row in rows if row] == ["+0", "+16", "+32", "...", "+208"]
    assert max(map(len, lines)) <= 120


def test_repetitions_are_told_in_one_line() -> None:
    frame = ev3proto.direct_command(*[ev3proto.operation("UI_FLUSH")] * 20).build()
    many = [replace(LENGTH, offset=7 + number, length=1) for number in range(20)]
    lines = texts(diagnostics(report(frame, *many), nearest=()))
    assert sum(line.startswith("error[E2]: the length") for line in lines) == MOST_ALIKE
    assert lines[-1] == (
        "error[E2]: and 16 more of these, at offsets 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, ..."
    )


def test_system_commands_are_decoded_too() -> None:
    frame = ev3proto.system_command("DELETE_FILE", path="../prjs/x").build()
    lines = texts(diagnostics(report(frame, replace(LENGTH, offset=6, length=11, operation="DELETE_FILE")), nearest=()))
    assert '     = DELETE_FILE path="../prjs/x"' in lines


def test_the_colour_is_that_of_the_worst() -> None:
    lines = list(diagnostics(report(TONE, LONG, LOW), nearest=()))
    (underline,) = [line for line in lines if any("^" in text for text, _ in line)]
    assert [role for text, role in underline if "^" in text] == [Role.FAULT]
    (row,) = [line for line in lines if any(" 0E" in text for text, _ in line)]
    assert [text for text, role in row if role is Role.FAULT] == [" 82 C8 00"]


def test_a_fixed_frame() -> None:
    change = Change("length field", "15", "14", "it was one too many")
    found = Fix(TONE, (change,), ("one thing is left",), report(TONE, LOW, rejected_at=10))
    lines = texts(fixed(found, place="frame 1"))
    assert lines[:5] == [
        "frame 1: fixed in 1 place",
        "0x|0E:00|2A:00|80|00:00|94|01|01|82:C8:00|82:E8:03|",
        "  length field: 15 -> 14 (it was one too many)",
        "  not fixed: one thing is left",
        "frame 1, fixed: the brick refuses it at offset 10; 1 error",
    ]


def test_a_frame_in_which_nothing_was_fixed() -> None:
    assert texts(fixed(Fix(TONE, (), (), report(TONE)))) == [
        "nothing to fix",
        "0x|0E:00|2A:00|80|00:00|94|01|01|82:C8:00|82:E8:03|",
        "accepted: no findings",
    ]
    assert texts(fixed(Fix(TONE, (), (), report(TONE, LOW))))[0] == "nothing could be fixed"


@pytest.mark.parametrize(
    ("frame", "text"),
    [
        ("0600010080000001", "0x|06:00|01:00|80|00:00|01|"),
        ("080001008000000181ff", "0x|08:00|01:00|80|00:00|01|81:FF|"),
        ("0e00010001989210000000782f6100", "0x|0E:00|01:00|01|98|92:10:00:00:00:78:2F:61:00|"),
        ("0300010002", "0x|03:00|01:00|02|"),
        ("030001", "0x|03:00|01|"),
        ("", "0x|"),
    ],
)
def test_frames_as_the_lesson_prints_them(frame: str, text: str) -> None:
    assert grouped_hex(bytes.fromhex(frame)) == text


def test_only_fixed_frames_are_read_again() -> None:
    """The output of --fix can be given to every command that reads frames: nothing else in it looks like a frame."""

    def lines() -> Iterator[str]:
        for number in range(10, 26):
            span = replace(LOW, offset=number, length=40)
            frame = TONE + TONE
            change = Change("FREQUENCY of SOUND.TONE", "83:C8:00:00:00", "82:C8:00", "2 bytes less")
            found = Fix(frame, (change,), (), report(frame, span, rejected_at=10))
            yield from (f"{text}\n" for text in texts(fixed(found)))

    assert [pasted.data for pasted in read_text(lines())] == [TONE] * 32


def test_lines_know_the_finding_that_they_are_about() -> None:
    lines = list(diagnostics(report(TONE, LOW, rejected_at=10), nearest=()))
    assert (lines[0].offset, lines[0].length, lines[0].code) == (0, 16, "")
    assert [(line.offset, line.length, line.code) for line in lines[2:]] == [(10, 3, "E1")] * 7
