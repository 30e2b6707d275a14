"""The virtual brick's motors, which do what LEGO's motor driver does with motors without load.

The driver's own numbers are in `motor_sequences.txt`, for drawn sequences of commands.
"""

import random
import re
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from support import cpu_time
from support.brick import answer, ask

from ev3proto.brick import Brick

READ = "DATA32 tacho DATA8 speed OUTPUT_READ(0, 0, speed, tacho)"
COUNT = "DATA32 count OUTPUT_GET_COUNT(0, 0, count)"
BUSY = "DATA8 busy OUTPUT_TEST(0, 3, busy)"

SEQUENCES = Path(__file__).parent / "motor_sequences.txt"


class Seen(NamedTuple):
    """What a client sees of a motor: degrees as a sensor, degrees of the move, percent, and whether a move goes on."""

    sensor: int
    read: int
    speed: int
    busy: int


def see(brick: Brick, port: str) -> Seen:
    number = "ABCD".index(port)
    memory = ask(
        brick,
        "DATA32 count DATA32 tacho DATA8 speed DATA8 busy"
        f" OUTPUT_GET_COUNT(0, {number}, count) OUTPUT_READ(0, {number}, speed, tacho)"
        f" OUTPUT_TEST(0, {1 << number}, busy)",
    )
    return Seen(*struct.unpack("<iibb", bytes.fromhex(memory)))


def command(brick: Brick, text: str) -> None:
    assert ask(brick, text) == ""


@pytest.fixture
def brick() -> Brick:
    """One with large motors on A and B and a medium one on C, on for a second."""
    brick = Brick()
    for port, kind in {"A": 7, "B": 7, "C": 8}.items():
        brick.plug(port, kind)
    brick.advance(1)
    return brick


def number(memory: str) -> int:
    return int.from_bytes(bytes.fromhex(memory), "little", signed=True)


class TestHeldValues:
    """A motor that is plugged in with values shows them until a command moves it."""

    @pytest.fixture
    def brick(self) -> Brick:
        brick = Brick()
        brick.plug("A", 7, tacho=1234, count=370, speed=-42)
        return brick

    @pytest.mark.parametrize(
        ("before", "read", "memory"),
        [
            ("", READ, "d2 04 00 00 d6"),
            ("", COUNT, "72 01 00 00"),
            ("OUTPUT_STOP(0, 1, 1)", READ, "d2 04 00 00 d6"),
            ("OUTPUT_CLR_COUNT(0, 1)", COUNT, "00 00 00 00"),
            ("OUTPUT_CLR_COUNT(0, 1)", READ, "d2 04 00 00 d6"),
            ("OUTPUT_CLR_COUNT(0, 2)", COUNT, "72 01 00 00"),
            ("OUTPUT_CLR_COUNT(1, 1)", COUNT, "72 01 00 00"),
            ("", "DATA32 tacho DATA8 speed OUTPUT_READ(1, 0, speed, tacho)", "00 00 00 00 00"),
            ("", "DATA32 tacho DATA8 speed OUTPUT_READ(0, 4, speed, tacho)", "00 00 00 00 00"),
            ("", "DATAF degrees INPUT_READSI(0, 16, 0, 0, degrees)", "00 00 b9 43"),
        ],
    )
    def test_what_is_read(self, brick: Brick, before: str, read: str, memory: str) -> None:
        if before:
            ask(brick, before)
        brick.advance(1)
        assert ask(brick, read) == memory

    def test_the_count_goes_on_from_there(self, brick: Brick) -> None:
        command(brick, "OUTPUT_STEP_SPEED(0, 1, 50, 0, 100, 0, 1)")
        brick.advance(5)
        assert see(brick, "A") == (470, 0, 0, 0)

    def test_they_are_shown_until_the_next_tick(self, brick: Brick) -> None:
        assert ask(brick, f"OUTPUT_POWER(0, 1, 50) OUTPUT_START(0, 1) {READ}") == "d2 04 00 00 d6"
        brick.advance(0.002)
        assert ask(brick, READ) == "00 00 00 00 00"


class Sequence(NamedTuple):
    line: int
    steps: list[str]


def sequences() -> Iterator[Sequence]:
    """Yields the sequences of the file, each with its first line."""
    text = "".join("\n" if line.startswith("#") else line for line in SEQUENCES.read_text().splitlines(keepends=True))
    for found in re.finditer(r"(?:.+\n)+", text):
        yield Sequence(text.count("\n", 0, found.start()) + 1, found[0].splitlines())


def is_near(ours: Seen, lego: Seen, share: float, degrees: int, percent: int) -> bool:
    """Whether two agree as well as motors of the same kind do: counts within a share or some degrees."""

    def are_near(one: int, other: int) -> bool:
        return abs(one - other) <= max(degrees, share * max(abs(one), abs(other)))

    return (
        ours.busy == lego.busy
        and are_near(ours.sensor, lego.sensor)
        and are_near(ours.read, lego.read)
        and abs(ours.speed - lego.speed) <= percent
    )


@pytest.mark.parametrize("sequence", list(sequences()), ids=lambda sequence: f"line {sequence.line}")
def test_motors_do_what_legos_driver_does(brick: Brick, sequence: Sequence) -> None:
    last = len(sequence.steps) - 1
    for place, step in enumerate(sequence.steps):
        waited = re.fullmatch(r"  (\d+) ms: A (.+); B (.+)", step)
        if waited is None:
            command(brick, step)
            continue
        brick.advance(int(waited[1]) / 1000)
        limits = (0.12, 40, 8) if place == last else (0.15, 60, 15)
        for port, values in zip("AB", waited.groups()[1:], strict=True):
            ours, lego = see(brick, port), Seen(*map(int, values.split()))
            assert is_near(ours, lego, *limits), f"{step}: port {port} is {ours}"


WORKED = [
    # Commands and pauses in milliseconds, then a pause, a port, and what is seen there.
    # Each phase subtracts its length: after a move that brakes, OUTPUT_READ is about 0.
    (["OUTPUT_STEP_SPEED(0, A, 50, 90, 180, 90, 1)"], 400, "A", (30, 30, 12, 1)),
    (["OUTPUT_STEP_SPEED(0, A, 50, 90, 180, 90, 1)"], 3400, "A", (360, 0, 0, 0)),
    # Without a brake it shows how far the motor ran on.
    (["OUTPUT_STEP_SPEED(0, A, 50, 0, 360, 0, 0)"], 3000, "A", (436, 76, 0, 0)),
    # Other brakes than 1 stop without an approach.
    (["OUTPUT_STEP_SPEED(0, A, 50, 0, 360, 0, 2)"], 700, "A", (345, 345, 50, 1)),
    (["OUTPUT_STEP_SPEED(0, A, 50, 0, 360, 0, 2)"], 3000, "A", (360, 0, 0, 0)),
    (["OUTPUT_STEP_SPEED(0, C, 50, 0, 360, 0, 1)"], 300, "C", (225, 225, 49, 1)),
    (["OUTPUT_STEP_SPEED(0, C, 50, 0, 360, 0, 1)"], 3000, "C", (360, 0, 0, 0)),
    (["OUTPUT_TIME_SPEED(0, A, 50, 0, 1000, 0, 1)"], 500, "A", (242, 1, 50, 1)),
    (["OUTPUT_TIME_SPEED(0, A, 50, 0, 1000, 0, 1)"], 3000, "A", (490, 0, 0, 0)),
    (["OUTPUT_STEP_POWER(0, A, 50, 90, 180, 90, 1)"], 300, "A", (25, 25, 13, 1)),
    (["OUTPUT_STEP_POWER(0, A, 50, 90, 180, 90, 1)"], 3300, "A", (360, 0, 0, 0)),
    # RESET starts the phase over; the same command again goes on with what is done.
    (["OUTPUT_STEP_SPEED(0, A, 50, 0, 720, 0, 1)", 800, "OUTPUT_RESET(0, A)"], 3000, "A", (1116, 0, 0, 0)),
    (["OUTPUT_STEP_SPEED(0, A, 50, 0, 720, 0, 1)", 800] * 2, 5000, "A", (720, 0, 0, 0)),
    (["OUTPUT_STEP_SPEED(0, A, 50, 0, 720, 0, 1)", 500, "OUTPUT_PRG_STOP()"], 1000, "A", (318, 318, 0, 0)),
    # SPEED takes over while the speed is even.
    (["OUTPUT_STEP_SPEED(0, A, 50, 0, 720, 0, 1)", 500, "OUTPUT_SPEED(0, A, 10)"], 600, "A", (318, 318, 10, 1)),
    (["OUTPUT_SPEED(0, A, 50) OUTPUT_START(0, A)"], 1000, "A", (498, 1, 50, 0)),
    (["OUTPUT_SPEED(0, A, 80) OUTPUT_START(0, A)", 1000, "OUTPUT_STOP(0, A, 0)"], 1000, "A", (893, 121, 0, 0)),
    (["OUTPUT_POWER(0, A, 30) OUTPUT_START(0, A)"], 1500, "A", (491, 1, 33, 0)),
    (["OUTPUT_POWER(0, C, 30) OUTPUT_START(0, C)"], 1500, "C", (949, 2, 41, 0)),
    # Steps of mixed signs: a phase that is behind is over at once.
    (["OUTPUT_STEP_SPEED(0, A, 50, 90, -360, 90, 1)"], 3000, "A", (180, 0, 0, 0)),
    # START after a move by speed creeps.
    (["OUTPUT_STEP_SPEED(0, A, 50, 0, 200, 0, 1)", 2000, "OUTPUT_START(0, A)"], 1000, "A", (252, 0, 5, 0)),
    # POWER within a move by speed: 5000 hundredths of a percent are taken for a speed in a byte.
    (
        ["OUTPUT_STEP_SPEED(0, A, 50, 180, 180, 0, 1)", 100, "OUTPUT_POWER(0, A, 50)"],
        3000,
        "A",
        (-1653, -1833, -100, 1),
    ),
    # POLARITY puts the power out without START, makes a move run away, and multiplies.
    (["OUTPUT_POWER(0, A, 50) OUTPUT_POLARITY(0, A, 1)"], 1000, "A", (503, 503, 53, 0)),
    (
        ["OUTPUT_STEP_SPEED(0, A, 40, 0, 720, 0, 1)", 500, "OUTPUT_POLARITY(0, A, 0)"],
        3000,
        "A",
        (-1012, -1012, -40, 1),
    ),
    (["OUTPUT_POLARITY(0, A, -11) OUTPUT_SPEED(0, A, 5) OUTPUT_START(0, A)"], 1500, "A", (-832, -2, -55, 0)),
    # Two motors in step ignore polarity; the turn may be more than 200.
    (["OUTPUT_POLARITY(0, A, -1) OUTPUT_STEP_SYNC(0, A+B, 50, 0, 360, 1)"], 3000, "A", (360, 0, 0, 0)),
    (["OUTPUT_STEP_SYNC(0, A+B, 50, 50, 360, 1)"], 4000, "B", (180, 0, 0, 0)),
    (["OUTPUT_STEP_SYNC(0, A+B, 50, -50, 360, 1)"], 4000, "A", (180, 0, 0, 0)),
    (["OUTPUT_STEP_SYNC(0, A+B, 50, 100, 360, 1)"], 4000, "B", (0, 0, 0, 0)),
    (["OUTPUT_STEP_SYNC(0, A+B, 50, 200, 360, 1)"], 4000, "B", (-360, 0, 0, 0)),
    (["OUTPUT_STEP_SYNC(0, A+B, 50, 250, 360, 1)"], 4000, "B", (-540, 0, 0, 0)),
    (["OUTPUT_STEP_SYNC(0, A+B, 50, -250, 360, 1)"], 4000, "B", (360, 0, 0, 0)),
    (["OUTPUT_TIME_SYNC(0, A+B, 50, 200, 1000, 1)"], 3000, "B", (-492, 0, 0, 0)),
    # Without end they are busy for ever; a command to one lets the other float.
    (["OUTPUT_STEP_SYNC(0, A+B, 50, 0, 0, 1)"], 1000, "A", (498, 498, 50, 1)),
    (["OUTPUT_STEP_SYNC(0, A+B, 50, 0, 0, 1)", 1000, "OUTPUT_STOP(0, A, 1)"], 500, "A", (498, 0, 0, 0)),
    (["OUTPUT_STEP_SYNC(0, A+B, 50, 0, 0, 1)", 1000, "OUTPUT_STOP(0, A, 1)"], 500, "B", (573, 74, 3, 0)),
    (["OUTPUT_TIME_SYNC(0, A+B, 50, 0, 3000, 1)", 1000, "OUTPUT_SPEED(0, A, 20)"], 1500, "B", (577, 76, 0, 0)),
    (["OUTPUT_STEP_SYNC(0, A+B, 50, 0, 1000, 1)", 500, "OUTPUT_POLARITY(0, B, 1)"], 3000, "B", (438, 195, 5, 0)),
]


@pytest.mark.parametrize(("steps", "pause", "port", "seen"), WORKED)
def test_what_commands_do(brick: Brick, steps: list[str | int], pause: int, port: str, seen: tuple[int, ...]) -> None:
    for step in steps:
        if isinstance(step, int):
            brick.advance(step / 1000)
        else:
            command(brick, step)
    brick.advance(pause / 1000)
    ours, lego = see(brick, port), Seen(*seen)
    assert is_near(ours, lego, 0.015, 4, 2), f"{ours}, expected {lego}"


class TestTwoCounters:
    def test_they_are_cleared_apart(self, brick: Brick) -> None:
        command(brick, "OUTPUT_STEP_SPEED(0, 1, 50, 0, 1000, 0, 1)")
        brick.advance(1)
        before = see(brick, "A")
        assert before.sensor == before.read == pytest.approx(498, abs=5)
        command(brick, "OUTPUT_CLR_COUNT(0, 1)")
        assert see(brick, "A") == before._replace(sensor=0)
        command(brick, "OUTPUT_RESET(0, 1)")
        assert see(brick, "A") == before._replace(sensor=0, read=0)


class TestWaiting:
    def test_until_a_move_has_ended(self, brick: Brick) -> None:
        """The motor needs 0.75 s for 360 degrees at half of 1007 degrees a second."""
        assert ask(brick, "OUTPUT_STEP_SPEED(0, 1, 50, 0, 360, 0, 1) OUTPUT_READY(0, 1)", seconds=0.7) == "busy"
        assert answer(brick.advance(0.3)) == ""

    def test_for_ever_if_two_motors_move_without_end(self, brick: Brick) -> None:
        assert ask(brick, "OUTPUT_TIME_SYNC(0, 3, 50, 0, 0, 0) OUTPUT_READY(0, 1)", seconds=10) == "busy"

    def test_not_at_all_for_a_motor_that_was_started(self, brick: Brick) -> None:
        assert ask(brick, "OUTPUT_SPEED(0, 1, 50) OUTPUT_START(0, 1) OUTPUT_READY(0, 1)") == ""

    def test_speed_without_start(self, brick: Brick) -> None:
        command(brick, "OUTPUT_SPEED(0, 1, 50)")
        brick.advance(1)
        assert see(brick, "A") == (0, 0, 0, 0)

    def test_without_a_motor_nothing_turns(self) -> None:
        brick = Brick()
        command(brick, "OUTPUT_STEP_SPEED(0, 1, 50, 90, 180, 90, 1)")
        brick.advance(120)
        assert ask(brick, BUSY) == "01"
        command(brick, "OUTPUT_PRG_STOP()")
        assert ask(brick, BUSY) == "00"


def test_another_type_makes_a_motor_float_and_clears_its_counts(brick: Brick) -> None:
    command(brick, "OUTPUT_SPEED(0, 1, 50) OUTPUT_START(0, 1)")
    brick.advance(1)
    assert ask(brick, "DATA8 percent INPUT_READ(0, 16, 16, 0, percent)") is not None
    assert see(brick, "A")[:2] == (0, 0)
    brick.advance(3)
    assert see(brick, "A")[2:] == (0, 0)


class TestTime:
    """Results do not depend on how time passes, and time passes quickly."""

    COMMANDS = (
        "OUTPUT_POWER(0, {motors}, {percent}) OUTPUT_START(0, {motors})",
        "OUTPUT_SPEED(0, {motors}, {percent}) OUTPUT_START(0, {motors})",
        "OUTPUT_STOP(0, {motors}, {brake})",
        "OUTPUT_POLARITY(0, {motors}, {brake})",
        "OUTPUT_STEP_SPEED(0, {motors}, {percent}, 0, 3000, 90, {brake})",
        "OUTPUT_TIME_POWER(0, {motors}, {percent}, 500, 3000, 0, {brake})",
        "OUTPUT_STEP_POWER(0, {motors}, {percent}, 90, 30000, 0, {brake})",
        "OUTPUT_STEP_SYNC(0, A+C, {percent}, {turn}, 1000, {brake})",
        "OUTPUT_PRG_STOP()",
    )

    @pytest.mark.parametrize("seed", range(12))
    def test_in_one_step_or_in_many(self, seed: int) -> None:
        draw = random.Random(seed)
        at_once, slowly = Brick(), Brick()
        for brick in (at_once, slowly):
            brick.plug("A", 7)
            brick.plug("C", 8)
        for _ in range(6):
            text = draw.choice(self.COMMANDS).format(
                motors=draw.choice(("A", "C", "A+B", "A+C")),
                percent=draw.choice((-100, -37, 5, 30, 62, 80)),
                turn=draw.choice((0, 50, -130)),
                brake=draw.randint(0, 1),
            )
            milliseconds = draw.choice((300, 5_000, 20_000))
            for brick in (at_once, slowly):
                command(brick, text)
            at_once.advance(milliseconds / 1000)
            for _ in range(milliseconds // 20):
                slowly.advance(0.02)
            assert [see(at_once, port) for port in "ABCD"] == [see(slowly, port) for port in "ABCD"], text

    @pytest.mark.parametrize("how", ["POWER", "SPEED"])
    def test_a_minute_of_motors_that_run(self, brick: Brick, how: str) -> None:
        command(brick, f"OUTPUT_{how}(0, 7, 50) OUTPUT_START(0, 7)")
        brick.advance(60)
        assert see(brick, "A").sensor == pytest.approx(60 * {"POWER": 535, "SPEED": 510}[how], rel=0.02)

    def test_a_minute_of_two_motors_in_step(self, brick: Brick) -> None:
        command(brick, "OUTPUT_STEP_SYNC(0, 3, 50, 0, 0, 1)")
        assert cpu_time.seconds(lambda: brick.advance(60)) < 40 / 60 * 2
        assert see(brick, "A").sensor == pytest.approx(60 * 504, rel=0.02)

    def test_ten_years_after_a_move(self, brick: Brick) -> None:
        command(brick, "OUTPUT_STEP_SPEED(0, 4, 50, 0, 10000, 0, 1)")
        brick.advance(10 * 365 * 86400.0)
        assert see(brick, "C") == (10_000, 0, 0, 0)
