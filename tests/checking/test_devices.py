"""Hints about motors, sounds and readings that do something else than a sender expects."""

import pytest
from support.brick import ask

from ev3proto import check
from ev3proto.brick import Brick
from ev3proto.text.assembly import assemble

STEP = "OUTPUT_STEP_SPEED(0, A, 50, 0, 360, 0, 1)"
READY = "OUTPUT_READY(0, A)"
READ = "OUTPUT_READ(0, 0, GV0(4), GV0(0))"
POWER, SPEED, START = "OUTPUT_POWER(0, A, 50)", "OUTPUT_SPEED(0, A, 50)", "OUTPUT_START(0, A)"
PLAY, SILENCE = "SOUND(PLAY, 100, '../prjs/x')", "SOUND_READY()"

NEW = {"H402", "H704", "H705", "H706"}


def codes(*operations: str) -> list[str]:
    (message,) = assemble("\n".join(operations), reply=True)
    return [finding.code for finding in check(message.build()).findings if finding.code in NEW]


@pytest.mark.parametrize(
    "operations",
    [
        (STEP, READY, READ),
        (STEP, READ),
        ("OUTPUT_TIME_SYNC(0, A+B, 50, 0, 100, 1)", READY, "OUTPUT_READ(0, 1, GV0(4), GV0(0))"),
    ],
)
def test_a_count_that_a_move_has_taken_back(operations: tuple[str, ...]) -> None:
    assert codes(*operations) == ["H704"]


@pytest.mark.parametrize(
    "operations",
    [
        (READ, STEP),
        (STEP, READY, "OUTPUT_READ(0, 1, GV0(4), GV0(0))"),
        (STEP, READY, "OUTPUT_READ(1, 0, GV0(4), GV0(0))"),
        # Another command to the motor makes the count something else.
        (STEP, READY, "OUTPUT_RESET(0, A)", READ),
        (STEP, READY, SPEED, START, READ),
        (STEP, READY, "OUTPUT_STOP(0, LV0(0), 0)", READ),
        (STEP, READY, "OUTPUT_GET_COUNT(0, 0, GV0(0))"),
    ],
)
def test_counts_that_are_fine(operations: tuple[str, ...]) -> None:
    assert codes(*operations) == []


def test_the_count_is_what_the_hint_says() -> None:
    brick = Brick()
    brick.plug("A", 7)
    assert ask(brick, f"DATA32 tacho DATA8 speed {STEP} {READY}", seconds=3) != "busy"
    brick.advance(1)
    assert ask(brick, "DATA32 tacho DATA8 speed OUTPUT_READ(0, 0, speed, tacho)") == "00 00 00 00 00"


@pytest.mark.parametrize(
    ("operations", "expected"),
    [
        ((POWER, START, SPEED), ["H705"]),
        ((SPEED, START, POWER), ["H705"]),
        ((POWER, START, POWER), []),
        ((POWER, START, "OUTPUT_SPEED(0, B, 50)"), []),
        ((POWER, SPEED, START, SPEED), []),
        ((POWER, START, "OUTPUT_STOP(0, A, 0)", SPEED, START), []),
        ((POWER, START, STEP, READY, SPEED, START), []),
        ((START, SPEED), []),
    ],
)
def test_a_speed_for_a_motor_that_runs_by_power(operations: tuple[str, ...], expected: list[str]) -> None:
    assert codes(*operations) == expected


@pytest.mark.parametrize(
    ("operations", "expected"),
    [
        ((PLAY, SILENCE), ["H706"]),
        ((PLAY, SILENCE, SILENCE), ["H706"]),
        ((SILENCE, PLAY), []),
        ((PLAY,), []),
        ((PLAY, "SOUND(BREAK)", SILENCE), []),
        ((PLAY, "SOUND(TONE, 1, 440, 100)", SILENCE), []),
        # Every brick has the sounds in ui; which file a variable names is unknown.
        (("SOUND(PLAY, 100, './ui/Click')", SILENCE), []),
        (("SOUND(PLAY, 100, LV0(0))", SILENCE), []),
    ],
)
def test_a_wait_for_a_file_that_may_be_missing(operations: tuple[str, ...], expected: list[str]) -> None:
    assert codes(*operations) == expected


def reading(globals: int, *operations: str) -> list[str]:
    (message,) = assemble("\n".join((f"message DIRECT_COMMAND_REPLY globals {globals}", *operations)))
    return [finding.code for finding in check(message.build()).findings if finding.code in NEW]


@pytest.mark.parametrize(
    ("globals", "operations", "expected"),
    [
        (4, ("INPUT_READ(0, 0, 0, -1, GV0(0))",), ["H402"]),
        (8, ("INPUT_READ(0, 0, 0, -1, GV0(0))", "INPUT_READ(0, 1, 0, -1, GV0(4))"), ["H402", "H402"]),
        (4, ("INPUT_DEVICE(READY_PCT, 0, 0, 0, -1, 1, GV0(0))",), ["H402"]),
        (1, ("INPUT_READ(0, 0, 0, -1, GV0(0))",), []),
        (4, ("INPUT_READSI(0, 0, 0, -1, GV0(0))",), []),
        (4, ("INPUT_READ(0, 0, 0, -1, GV0(0))", "INPUT_READ(0, 1, 0, -1, GV0(1))"), []),
        # That much memory is another finding.
        (20, ("INPUT_READ(0, 0, 0, -1, GV0(0))",), []),
        # Not where a float would be, and not an operation with a larger sister.
        (5, ("INPUT_READ(0, 0, 0, -1, GV0(1))",), []),
        (4, ("INFO(GET_VOLUME, GV0(0))",), []),
        (4, ("UI_READ(GET_LBATT, GV0(0))",), []),
    ],
)
def test_bytes_of_the_reply_that_nothing_writes(globals: int, operations: tuple[str, ...], expected: list[str]) -> None:
    assert reading(globals, *operations) == expected


@pytest.mark.parametrize(
    ("size", "found"), [(1, []), (2, ["H401"]), (3, ["H401"]), (4, ["H402"]), (5, ["H401"]), (8, ["H401"])]
)
def test_memory_for_a_float_of_which_a_byte_is_written(size: int, found: list[str]) -> None:
    """INPUT_READ writes a byte to GV(0); other memory is requested for nothing."""
    contents = bytes.fromhex("2A00 00") + bytes((size, 0)) + bytes.fromhex("9A 00 00 00 00 60")
    assert [one.code for one in check(len(contents).to_bytes(2, "little") + contents).findings] == found
