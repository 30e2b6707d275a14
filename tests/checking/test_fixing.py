"""Fixes: what is fixed, what is unchanged, and that no fix does any harm."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from support.brick_state import state_of
from support.effort import effort
from support.messages import frame_of

import ev3proto
from ev3proto import GV, LV, DirectCommand, Operation, operation
from ev3proto.brick import Brick
from ev3proto.checking.checking import check
from ev3proto.checking.codes import CODES
from ev3proto.checking.fixing import fix
from ev3proto.checking.report import Fix
from ev3proto.schema.argument import encode_as
from ev3proto.testing import accepted_frames, frames, mutated_frames

many = settings(max_examples=effort(75, 1000))

VOLTAGE = "08:00|2A:00|00|04:00|81|01|60|"


def command(*operations: Operation, **header: int) -> bytes:
    return ev3proto.direct_command(*operations, **header).build()  # type: ignore[arg-type]


def asking(*operations: Operation, **header: int) -> bytes:
    return ev3proto.direct_command(*operations, reply=True, **header).build()


def told(fixed: Fix) -> list[str]:
    return [f"{change.what}: {change.before} -> {change.after}" for change in fixed.changes]


def parsed(frame: bytes) -> DirectCommand:
    return ev3proto.parse(frame, expect=DirectCommand)


# Slips


@pytest.mark.parametrize("length", ["00:00", "07:00", "09:00", "FF:FF"])
def test_a_wrong_length_field(length: str) -> None:
    fixed = fix(frame_of(VOLTAGE.replace("08:00", length)))
    assert fixed.frame == frame_of(VOLTAGE)
    assert [change.what for change in fixed.changes] == ["length field"]
    assert fixed.report.errors == ()


def test_a_wrong_length_field_of_a_system_command() -> None:
    frame = ev3proto.system_command("DELETE_FILE", path="../prjs/x/x.rbf").build()
    fixed = fix(b"\x05" + frame[1:])
    assert (fixed.frame, told(fixed)) == (frame, ["length field: 05 -> 14"])


MANGLED = (
    "0E:00|2A:00|C2:80|00:00|C2:94:01:01:C2:82:C2:B8:01:C2:82:C3:A8:03",
    "0E:00|0D:0A:00|80|00:00|94:01:01:82:B8:01:82:E8:03",
)


@pytest.mark.parametrize("text", MANGLED)
def test_a_text_that_changed_a_frame_is_undone(text: str) -> None:
    counter = "0A" if "0D:0A" in text else "2A"
    fixed = fix(frame_of(text))
    assert fixed.frame == frame_of(f"0E:00|{counter}:00|80|00:00|94:01:01:82:B8:01:82:E8:03")
    assert len(fixed.changes) == 1
    assert fixed.report.accepted


def test_bytes_that_a_text_lost_are_not_guessed() -> None:
    lost = frame_of("0E:00|2A:00|3F|00:00|3F:01:01:3F:3F:01:3F:3F:03")
    assert fix(lost).frame == lost


def test_a_frame_that_is_cut_off_stays() -> None:
    cut = frame_of("0E:00|2A:00|80|00:00|94|01|01|82:B8:01|82:E8")
    fixed = fix(cut)
    assert (fixed.frame, fixed.changes) == (cut, ())
    assert fixed.unfixed == ("a byte of DURATION of SOUND.TONE is missing; its bytes can only be guessed",)


def test_padding_is_not_a_wrong_length() -> None:
    padded = frame_of(VOLTAGE) + bytes(1014)
    assert (fix(padded).frame, fix(padded).changes) == (padded, ())


def test_a_slip_says_what_it_is() -> None:
    (change,) = fix(frame_of("0D:00|2A:00|80|00:00|94:02:02:84:68:65:6C:6C")).changes
    assert str(change) == "offset 15: nothing -> 00 (the text NAME of SOUND.PLAY has no zero at its end)"


def test_two_that_are_as_likely_are_not_fixed() -> None:
    frame = frame_of("0D:00|2A:00|80|00:00|A5:00:01:A1:14:A6:00:01")
    fixed = fix(frame)
    assert fixed.frame == frame
    assert [reason.partition("; ")[2] for reason in fixed.unfixed] == ["or something else, which is as likely"] * 2


# Memory and type


ACCEPTED = "but the brick accepts the frame, and would do something else then"


@pytest.mark.parametrize(
    "frame",
    [
        frame_of("08:00|2A:00|00|00:00|81|01|60|"),  # a longer reply
        asking(operation("INPUT_DEVICE_LIST", 32, GV(0), GV(32)), global_size=4),
        frame_of(VOLTAGE.replace("|00|", "|80|")),  # a reply where none was
        frame_of("0C:00|2A:00|80|00:00|A5:00:01:4B:A6:00:01"),  # another speed than that of a variable
        frame_of("09:00|2A:00|00|04:00|8D:08:02:60"),  # a float for a whole number
    ],
)
def test_what_an_accepted_frame_does_is_left_alone(frame: bytes) -> None:
    fixed = fix(frame)
    assert (fixed.frame, fixed.changes, fixed.report.accepted) == (frame, (), True)
    assert fixed.unfixed[0].endswith(ACCEPTED)


def test_what_is_worse_than_the_frame_is_told_and_left_alone() -> None:
    frame = frame_of("0C:00|2A:00|80|00:00|A5:01:81:32:A6:00:01")
    (one,) = check(frame, alone=True).nearest
    assert (one.harm, one.is_sure) == ("this would make motors turn", True)
    assert one.message == f"LAYER of OUTPUT_SPEED is missing; {one.harm}"
    assert fix(frame).unfixed == (f"{one.message}; so it is up to you",)


def test_local_memory_that_was_not_asked_for() -> None:
    """The brick grants all of it in any case."""
    frame = command(operation("MOVE32_32", 7, LV(4)))
    assert fix(frame).frame == command(operation("MOVE32_32", 7, LV(4)), local_size=8)


def test_more_memory_than_there_is() -> None:
    local = command(operation("MOVE32_32", 7, LV(60)), local_size=4)
    assert fix(local).frame == local
    far = asking(operation("UI_READ.GET_VBATT", GV(0xFFFFFFF0)))
    assert fix(far).frame == far


def test_more_memory_than_the_firmware_gives() -> None:
    fixed = fix(asking(operation("UI_READ.GET_VBATT", GV(0)), global_size=1023))
    assert parsed(fixed.frame).global_size == 4


def test_a_text_of_unknown_length_gets_no_memory() -> None:
    frame = asking(operation("STRINGS.ADD", "a", "b", GV(0)))
    fixed = fix(frame)
    assert fixed.frame == frame
    assert fixed.unfixed[0].endswith("its bytes can only be guessed")


def test_memory_that_nothing_uses_stays() -> None:
    """Programs that read the reply may depend on its size."""
    frame = asking(operation("UI_READ.GET_VBATT", GV(0)), global_size=20)
    assert fix(frame).frame == frame


def test_global_memory_that_the_command_itself_reads_needs_no_reply() -> None:
    frame = command(operation("INPUT_READ", 0, 0, 0, 0, GV(0)), operation("OUTPUT_SPEED", 0, 1, GV(0)), global_size=1)
    assert parsed(fix(frame).frame).type is ev3proto.MessageType.DIRECT_COMMAND_NO_REPLY


# Alignment


def test_misaligned_variables_stay() -> None:
    frame = asking(
        operation("INPUT_READ", 0, 0, 0, 0, GV(0)), operation("INPUT_READSI", 0, 0, 0, 0, GV(1)), global_size=5
    )
    fixed = fix(frame)
    assert (fixed.frame, fixed.changes) == (frame, ())
    assert fixed.unfixed == (
        "SI of INPUT_READSI must start at a multiple of 4: GV(4) is written 64; but that is not certain",
    )
    assert "--fix does not move variables" in CODES["E205"].explanation


# Encodings


def test_shorter_encodings() -> None:
    values = (encode_as("LC2", 5), encode_as("LC4", 440), encode_as("LC4", 1000))
    fixed = fix(frame_of("15:00|00:00|80|00:00|94|81:01|") + b"".join(values))
    assert fixed.frame == frame_of("0E:00|00:00|80|00:00|94|01|05|82:B8:01|82:E8:03|")
    assert told(fixed) == [
        "CMD of SOUND.TONE at offset 8: 81:01 -> 01",
        "VOLUME of SOUND.TONE at offset 10: 82:05:00 -> 05",
        "FREQUENCY of SOUND.TONE at offset 13: 83:B8:01:00:00 -> 82:B8:01",
        "DURATION of SOUND.TONE at offset 18: 83:E8:03:00:00 -> 82:E8:03",
    ]


def test_variables_in_shorter_encodings() -> None:
    frame = asking(operation("UI_READ.GET_VBATT", encode_as("GV4", 4)), global_size=8)
    assert fix(frame).frame == asking(operation("UI_READ.GET_VBATT", GV(4)), global_size=8)


@pytest.mark.parametrize(
    ("name", "argument"),
    [
        ("MOVE8_8", encode_as("LC1", -128)),  # means "not a number": a longer encoding would mean something else
        ("MOVEF_F", encode_as("LC4", 0.0)),
        ("MOVE8_8", bytes((0x91, 0x05))),  # a handle
    ],
)
def test_encodings_that_stay(name: str, argument: bytes) -> None:
    frame = command(operation(name, argument, LV(0)), local_size=4)
    assert fix(frame).frame == frame


def test_what_is_jumped_over_keeps_its_length() -> None:
    long = operation("SOUND.TONE", encode_as("LC2", 5), 440, 1000)
    behind = operation("SOUND.TONE", encode_as("LC2", 6), 440, 1000)
    short = operation("SOUND.TONE", 6, 440, 1000)
    forward = operation("JR", long.length)
    assert fix(command(forward, long, behind)).frame == command(forward, long, short)
    back = operation("JR", -long.length - 2)
    fixed = fix(command(long, back, behind))
    assert fixed.frame == command(long, back, short)
    assert fixed.unfixed == ("1 longer encoding kept: a jump counts its bytes",)
    unknown = operation("JR", LV(0))
    frame = command(unknown, long, local_size=4)
    assert fix(frame).frame == frame


# What holds for every frame


def meaning(frame: bytes) -> list[object]:
    """Operations in order, with the values of their constants and the kinds of all arguments."""
    message = ev3proto.parse(frame, strict=False)
    return [
        (
            found.full_name,
            [(it.form._replace(name="", width=None), repr(it.value) * (not it.is_variable)) for it in found.arguments],
        )
        for found in getattr(message, "operations", ())
    ]


def is_better(fixed: Fix, frame: bytes) -> bool:
    before, after = check(frame), fixed.report
    return (
        after.accepted
        and len(after.findings) < len(before.findings)
        and len(after.errors) <= len(before.errors)
        and (fixed.changes != ())
    )


@pytest.mark.parametrize(
    "frame",
    [
        "0900010000040082118100",  # firmware of 2013 runs the shorter argument as an operation, and refuses that
        "0e002a0080000094010182b80182e8030080",  # the bytes after the stated length are not an operation
    ],
)
def test_an_accepted_frame_stays_accepted(frame: str) -> None:
    fixed = fix(bytes.fromhex(frame))
    assert (fixed.frame.hex(), fixed.changes, fixed.report.accepted) == (frame, (), True)


@many
@given(frames() | mutated_frames())
def test_a_fix_makes_a_frame_better_or_nothing(frame: bytes) -> None:
    fixed = fix(frame)
    assert fixed.frame == frame or is_better(fixed, frame)
    again = fix(fixed.frame)
    assert (again.frame, again.changes) == (fixed.frame, ())
    assert again.report == fixed.report == check(fixed.frame)


@many
@given(frames())
def test_shortening_changes_no_constant_and_no_order(frame: bytes) -> None:
    fixed = fix(frame)
    if check(frame).accepted and not check(frame).errors and not check(frame, alone=True).nearest:
        assert meaning(fixed.frame) == meaning(frame)


# Safety


def outcome(frame: bytes) -> tuple[list[bytes], dict[str, str]]:
    """Returns the replies to a frame and the state of the brick a while after it."""
    brick = Brick()
    replies = brick.receive(frame) + brick.advance(0.5)
    return replies, state_of(brick)


@settings(max_examples=effort(200, 10_000), deadline=None)
@given(frames() | accepted_frames() | mutated_frames())
def test_a_fix_never_changes_what_an_accepted_frame_does(frame: bytes) -> None:
    fixed = fix(frame).frame
    if fixed != frame and check(frame).accepted:
        (replies, state), (others, other) = outcome(frame), outcome(fixed)
        assert replies == others
        assert not {key: (value, other.get(key)) for key, value in state.items() if other.get(key) != value}
