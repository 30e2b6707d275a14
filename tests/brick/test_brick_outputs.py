"""The virtual brick's motors: models that follow commands in time."""

import pytest
from support.brick import answer, ask

from ev3proto.brick import Brick
from ev3proto.brick.devices.motors import Motor

READ = "DATA32 tacho DATA8 speed OUTPUT_READ(0, 0, speed, tacho)"
COUNT = "DATA32 count OUTPUT_GET_COUNT(0, 0, count)"
BUSY = "DATA8 busy OUTPUT_TEST(0, 3, busy)"


@pytest.fixture
def brick() -> Brick:
    """One with large motors on A and B."""
    brick = Brick()
    brick.plug("A", 7)
    brick.plug("B", 7)
    return brick


def number(memory: str) -> int:
    return int.from_bytes(bytes.fromhex(memory), "little", signed=True)


def angles(brick: Brick) -> list[int]:
    return [round(motor.angle) for motor in brick.outputs.motors[:2]]


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

    def test_a_move_begins_where_it_was(self, brick: Brick) -> None:
        ask(brick, "OUTPUT_STEP_SPEED(0, 1, 50, 0, 100, 0, 1)")
        brick.advance(5)
        assert number(ask(brick, COUNT)) == 470
        assert ask(brick, READ) == "64 00 00 00 00"

    def test_a_move_begins_with_the_speed_that_was_shown(self, brick: Brick) -> None:
        assert ask(brick, f"OUTPUT_POWER(0, 1, 50) OUTPUT_START(0, 1) {READ}") == "00 00 00 00 d6"


def test_a_running_motor_reverses_with_its_polarity(brick: Brick) -> None:
    ask(brick, "OUTPUT_POWER(0, 1, 50) OUTPUT_START(0, 1)")
    brick.advance(2)
    assert ask(brick, READ) == "00 00 00 00 32"
    ask(brick, "OUTPUT_POLARITY(0, 1, -1)")
    brick.advance(2)
    assert ask(brick, READ) == "00 00 00 00 ce"


def test_the_count_and_the_tacho_are_cleared_apart() -> None:
    brick = Brick()
    brick.plug("A", 7)
    ask(brick, "OUTPUT_STEP_SPEED(0, 1, 50, 0, 1000, 0, 1)")
    brick.advance(1)
    counted = number(ask(brick, COUNT))
    assert 100 < counted < 900
    assert number(ask(brick, READ)[:11]) == counted
    ask(brick, "OUTPUT_CLR_COUNT(0, 1)")
    assert number(ask(brick, COUNT)) == 0
    assert number(ask(brick, READ)[:11]) == counted
    ask(brick, "OUTPUT_RESET(0, 1)")
    assert number(ask(brick, READ)[:11]) == 0


class TestMoves:
    @pytest.mark.parametrize(
        ("move", "degrees"),
        [
            ("OUTPUT_STEP_SPEED(0, 1, 50, 0, 360, 0, 1)", 360),
            ("OUTPUT_STEP_SPEED(0, 1, 50, 90, 180, 90, 1)", 360),
            ("OUTPUT_STEP_SPEED(0, 1, -50, 90, 180, 90, 1)", -360),
            ("OUTPUT_STEP_POWER(0, 1, 100, 0, -360, 0, 0)", 360),
            ("OUTPUT_STEP_POWER(0, 1, 100, 720, 0, 0, 0)", 720),
            ("OUTPUT_STEP_POWER(0, 1, 100, 0, 0, 720, 0)", 720),
            ("OUTPUT_POLARITY(0, 1, -1) OUTPUT_STEP_SPEED(0, 1, 50, 0, 360, 0, 1)", -360),
            ("OUTPUT_POLARITY(0, 1, 0) OUTPUT_POLARITY(0, 1, 0) OUTPUT_STEP_SPEED(0, 1, 50, 0, 360, 0, 1)", 360),
            ("OUTPUT_STEP_SPEED(0, 1, 50, 0, 0, 0, 1)", 0),
        ],
    )
    def test_they_end_exactly_there(self, brick: Brick, move: str, degrees: int) -> None:
        ask(brick, move)
        brick.advance(20)
        assert ask(brick, BUSY) == "00"
        assert number(ask(brick, COUNT)) == degrees
        assert angles(brick) == [degrees, 0]

    @pytest.mark.parametrize(
        ("move", "before_end", "after"),
        [
            ("OUTPUT_TIME_SPEED(0, 3, 50, 0, 1000, 0, 1)", 0.99, 0.02),
            ("OUTPUT_TIME_POWER(0, 1, 50, 200, 600, 200, 0)", 0.99, 0.02),
            ("OUTPUT_TIME_SYNC(0, 3, 50, 0, 500, 0)", 0.49, 0.02),
        ],
    )
    def test_moves_by_time_end_in_time(self, brick: Brick, move: str, before_end: float, after: float) -> None:
        ask(brick, move)
        brick.advance(before_end)
        assert ask(brick, BUSY) == "01"
        assert ask(brick, READ)[:11] == "00 00 00 00"
        brick.advance(after)
        assert ask(brick, BUSY) == "00"

    def test_waiting_for_a_move(self, brick: Brick) -> None:
        """360 degrees at half of 1000 degrees a second, and 50 ms for speeding up."""
        assert ask(brick, "OUTPUT_STEP_SPEED(0, 1, 50, 0, 360, 0, 1) OUTPUT_READY(0, 1)", seconds=0.7) == "busy"
        assert answer(brick.advance(0.1)) == ""

    def test_a_motor_that_runs_for_ever_is_not_busy(self, brick: Brick) -> None:
        ask(brick, "OUTPUT_SPEED(0, 1, 50) OUTPUT_START(0, 1)")
        brick.advance(10)
        assert ask(brick, BUSY) == "00"
        assert ask(brick, READ) == "00 00 00 00 32"
        assert number(ask(brick, COUNT)) == pytest.approx(5000, abs=50)
        ask(brick, "OUTPUT_SPEED(0, 1, -100)")
        brick.advance(0.2)
        assert ask(brick, READ)[-2:] == "9c"
        ask(brick, "OUTPUT_STOP(0, 1, 0)")
        assert ask(brick, READ) == "00 00 00 00 00"

    def test_speed_without_start(self, brick: Brick) -> None:
        ask(brick, "OUTPUT_SPEED(0, 1, 50)")
        brick.advance(1)
        assert angles(brick) == [0, 0]

    def test_the_speed_lags(self, brick: Brick) -> None:
        ask(brick, "OUTPUT_POWER(0, 1, 100) OUTPUT_START(0, 1)")
        brick.advance(0.05)
        assert ask(brick, READ)[-2:] == "32"

    @pytest.mark.parametrize(
        ("turn", "expected"),
        [(0, [360, 360]), (50, [360, 180]), (100, [360, 0]), (200, [360, -360]), (-100, [0, 360]), (-200, [-360, 360])],
    )
    def test_two_motors_together(self, brick: Brick, turn: int, expected: list[int]) -> None:
        ask(brick, f"OUTPUT_STEP_SYNC(0, 3, 50, {turn}, 360, 1)")
        assert ask(brick, BUSY) == "01"
        brick.advance(5)
        assert ask(brick, BUSY) == "00"
        assert angles(brick) == pytest.approx(expected, abs=8)

    def test_another_command_to_one_of_two_floats_both(self, brick: Brick) -> None:
        ask(brick, "OUTPUT_STEP_SYNC(0, 3, 50, 0, 3600, 1)")
        ask(brick, "OUTPUT_STOP(0, 1, 1)")
        assert ask(brick, BUSY) == "00"

    def test_without_a_motor_nothing_turns(self) -> None:
        brick = Brick()
        ask(brick, "OUTPUT_STEP_SPEED(0, 1, 50, 90, 180, 90, 1)")
        brick.advance(3600)
        assert ask(brick, BUSY) == "01"
        ask(brick, "OUTPUT_PRG_STOP()")
        assert ask(brick, BUSY) == "00"

    def test_a_day_passes_at_once(self) -> None:
        motor = Motor()
        motor.plug(8, 0, 0, 0, is_held=False)
        motor.move(50, (10**8, 10**8, 10**8), False, 1)
        motor.advance(86400.0 * 365)
        assert motor.sensor_count == 3 * 10**8
