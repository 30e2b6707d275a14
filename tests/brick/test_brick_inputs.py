"""The virtual brick's sensors: what programs read of them, and how long they take to change their mode."""

import pytest
from support.brick import RefusedError, answer, ask
from support.bricks import OK, op, run

from ev3proto import MotorPort, MotorPorts, SensorPort
from ev3proto.brick import Brick
from ev3proto.messages import GV
from ev3proto.tables.devices import DEVICE_TYPES


@pytest.fixture
def brick() -> Brick:
    """Touch, colour, infrared and ultrasonic sensors on ports 1 to 4, a motor on A."""
    brick = Brick()
    brick.plug(1, 16, {0: (1900,)})
    brick.plug(2, 29, {0: (30,), 2: (5,), 4: (10, 20, 30)})
    brick.plug(3, 33, {0: (55,), 1: (-10, 40, 0, -128, 0, -128, 0, -128)})
    brick.plug(4, 30, {0: (1234,), 1: (486,)})
    brick.plug("A", 8, count=90)
    return brick


PERCENT = "DATA8 p INPUT_READ(0, {}, 0, {}, p)"
SI = "DATAF v INPUT_READSI(0, {}, 0, {}, v)"
NAN = "00 00 c0 7f"


class TestValues:
    @pytest.mark.parametrize(
        ("read", "memory"),
        [
            (PERCENT.format(0, -1), "5a"),
            (SI.format(0, -1), "66 66 66 3f"),
            (PERCENT.format(1, 0), "1e"),
            (SI.format(3, 0), "cd cc f6 42"),
            (PERCENT.format(3, 0), "30"),
            (SI.format(16, 0), "00 00 b4 42"),
            ("DATA32 r INPUT_DEVICE(GET_RAW, 0, 0, r)", "6c 07 00 00"),
            ("DATA32 r INPUT_DEVICE(GET_RAW, 0, 17, r)", "00 00 00 80"),
            ("DATA8 t DATA8 m INPUT_DEVICE(GET_TYPEMODE, 0, 1, t, m)", "1d 00"),
            ("DATA8 t DATA8 m INPUT_DEVICE(GET_TYPEMODE, 0, 17, t, m)", "7e 00"),
            ("DATA8 t DATA8 m INPUT_DEVICE(GET_TYPEMODE, 1, 1, t, m)", "7e 00"),
            ("DATA8 t DATA8 m INPUT_DEVICE(GET_TYPEMODE, 0, 32, t, m)", "7e 00"),
            ("DATA8 c INPUT_DEVICE(GET_CONNECTION, 0, 0, c)", "79"),
            ("DATA8 c INPUT_DEVICE(GET_CONNECTION, 0, 1, c)", "7a"),
            ("DATA8 c INPUT_DEVICE(GET_CONNECTION, 0, 16, c)", "7d"),
            ("DATA8 c INPUT_DEVICE(GET_CONNECTION, 0, 18, c)", "7e"),
            ("DATA8 a DATA8 b DATA8 c DATA8 d INPUT_DEVICE(GET_FORMAT, 0, 1, a, b, c, d)", "01 00 06 03"),
            ("DATA8 a DATA8 b DATA8 c DATA8 d INPUT_DEVICE(GET_FORMAT, 0, 16, a, b, c, d)", "01 02 03 02"),
            ("DATA8 a DATA8 b DATA8 c DATA8 d INPUT_DEVICE(GET_FORMAT, 0, 18, a, b, c, d)", "00 00 01 01"),
            ("DATA8 f DATA8 d INPUT_DEVICE(GET_FIGURES, 0, 3, f, d)", "05 01"),
            ("DATAF a DATAF b INPUT_DEVICE(GET_MINMAX, 0, 3, a, b)", "00 00 00 00 00 00 7f 43"),
            ("DATA8 busy INPUT_TEST(0, 0, busy)", "00"),
            ("DATA8 busy INPUT_TEST(0, 18, busy)", "01"),
            (SI.format(18, 0), NAN),
            (PERCENT.format(18, 0), "80"),
            ("DATAF a DATAF b INPUT_DEVICE(READY_SI, 0, 1, 0, 0, 2, a, b)", f"00 00 f0 41 {NAN}"),
            ("DATA32 a DATA32 b INPUT_DEVICE(READY_RAW, 0, 3, 30, -1, 2, a, b)", "d2 04 00 00 00 00 00 80"),
            ("DATA8 a DATA8 b INPUT_DEVICE(READY_PCT, 0, 18, 0, 0, 2, a, b)", "80 80"),
            ("DATA8 a INPUT_READEXT(0, 1, 0, -1, DATA_PCT, 1, a)", "1e"),
            ("DATA32 a INPUT_READEXT(0, 1, 0, -1, DATA_RAW, 1, a)", "1e 00 00 00"),
            ("DATAF a INPUT_READEXT(0, 1, 0, -1, DATA_SI, 1, a)", "00 00 f0 41"),
            ("DATA8 a DATA8 b INPUT_READEXT(0, 1, 0, -1, DATA_8, 2, a, b)", "80 80"),
            (
                "DATAF c DATAF b INPUT_DEVICE(GET_CHANGES, 0, 0, c) INPUT_DEVICE(GET_BUMPS, 0, 0, b)",
                "00 00 00 00 00 00 80 3f",
            ),
            ("DATAF c INPUT_DEVICE(GET_CHANGES, 0, 1, c)", "00 00 00 00"),
        ],
    )
    def test_what_is_read(self, brick: Brick, read: str, memory: str) -> None:
        assert ask(brick, read) == memory

    @pytest.mark.parametrize(
        ("read", "text"),
        [
            ("INPUT_DEVICE(GET_NAME, 0, 1, 16, text)", b"COL-REFLECT    \0"),
            ("INPUT_DEVICE(GET_NAME, 0, 1, 4, text)", b"COL\0"),
            ("INPUT_DEVICE(GET_NAME, 0, 18, 8, text)", b"NONE   \0"),
            ("INPUT_DEVICE(GET_SYMBOL, 0, 3, 5, text)", b"cm  \0"),
            ("INPUT_DEVICE(GET_MODENAME, 0, 1, 4, 8, text)", b"RGB-RAW\0"),
            ("INPUT_DEVICE(GET_MODENAME, 0, 1, 6, 8, text)", b"\0"),
        ],
    )
    def test_names_are_filled_with_blanks(self, brick: Brick, read: str, text: bytes) -> None:
        assert bytes.fromhex(ask(brick, f"DATAS text 16 {read}")) == text.ljust(16, b"\0")

    def test_the_types_on_all_ports(self, brick: Brick) -> None:
        assert ask(brick, "DATA8 changed ARRAY8 list 6 INPUT_DEVICE_LIST(5, list, changed)") == "05 10 1d 21 1e 7e 00"
        assert ask(brick, "DATA8 changed ARRAY8 list 6 INPUT_DEVICE_LIST(5, list, changed)")[:2] == "00"

    def test_the_list_is_written_after_the_count_where_they_overlap(self, brick: Brick) -> None:
        for length, place, memory in ((4, 2, "10 1d 21 1e 00 00"), (5, 5, "10 1d 21 1e 7e 00")):
            done = run(brick, op("INPUT_DEVICE_LIST", length, GV(0), GV(place)), globals=6)
            assert done == (OK, bytes.fromhex(memory))

    def test_edges_of_a_touch_sensor(self, brick: Brick) -> None:
        read = "DATAF c DATAF b INPUT_DEVICE(GET_CHANGES, 0, 0, c) INPUT_DEVICE(GET_BUMPS, 0, 0, b)"
        for raw in (1100, 1900, 1500, 1100):
            brick.plug(1, 16, {0: (raw,)})
        assert ask(brick, read) == "00 00 80 3f 00 00 00 40"
        ask(brick, "INPUT_DEVICE(CLR_CHANGES, 0, 0)")
        assert ask(brick, read) == "00 00 00 00 00 00 00 00"

    @pytest.mark.parametrize(
        ("type", "raw", "si", "percent"),
        [
            (1, 2000, 0.0, 0),
            (1, 1000, 1.0, 100),
            (1, 0, 1.0, 100),
            (2, 445, 100.0, 100),
            (2, 4000, 0.0, 0),
            (6, -14080, -55.0, 0),
            (32, -200, -200.0, 0),
            (16, 900, 0.0, 0),
        ],
    )
    def test_values_in_units(self, brick: Brick, type: int, raw: int, si: float, percent: int) -> None:
        """Not clamped, except those of analog sensors that have no unit or percent."""
        brick.plug(1, type, {0: (raw,)})
        device = brick.equipment.inputs.device(0, 0)
        assert device is not None
        assert brick.equipment.inputs.si(device, 0) == si
        assert brick.equipment.inputs.percent(device, 0) == percent

    def test_calibration(self, brick: Brick) -> None:
        """CAL_MIN brings a calibration into use; from then on ends are given in the unit of the range that is used."""
        ask(brick, "INPUT_DEVICE(CAL_MINMAX, 29, 0, 20, 40)")
        assert ask(brick, PERCENT.format(1, 0)) == "1e"
        ask(brick, "INPUT_DEVICE(CAL_MIN, 29, 0, 20)")
        assert ask(brick, PERCENT.format(1, 0)) == "0c"
        ask(brick, "INPUT_DEVICE(CAL_MAX, 29, 0, 40)")
        assert ask(brick, PERCENT.format(1, 0)) == "1f"
        ask(brick, "INPUT_DEVICE(CAL_DEFAULT, 29, 0)")
        assert ask(brick, PERCENT.format(1, 0)) == "1e"

    def test_a_reading_that_is_missing_is_nan(self, brick: Brick) -> None:
        read = "DATAF a DATAF b DATAF c DATAF d INPUT_DEVICE(READY_SI, 0, 2, 0, 1, 4, a, b, c, d)"
        assert ask(brick, read, seconds=1.2) == f"00 00 20 c1 00 00 20 42 00 00 00 00 {NAN}"


class TestModes:
    @pytest.mark.parametrize(
        ("port", "mode", "least", "most"),
        [(1, 2, 0.02, 0.025), (2, 1, 1.09, 1.11), (0, 1, 0.004, 0.015), (16, 2, 0.004, 0.015)],
    )
    def test_a_change_takes_its_time(self, brick: Brick, port: int, mode: int, least: float, most: float) -> None:
        read = f"DATAF v INPUT_DEVICE(READY_SI, 0, {port}, 0, {mode}, 1, v)"
        assert ask(brick, read, seconds=least - 0.001) == "busy"
        assert answer(brick.advance(most - least + 0.001)) != "busy"
        assert ask(brick, read) != "busy"

    @pytest.mark.parametrize(
        ("type", "mode", "milliseconds"),
        [(2, 1, 20), (3, 1, 300), (5, 1, 300), (6, 1, 300), (99, 2, 100), (100, 1, 100)],
    )
    def test_older_sensors_take_longer(self, type: int, mode: int, milliseconds: int) -> None:
        brick = Brick()
        brick.plug(1, type)
        ask(brick, PERCENT.format(0, mode))
        brick.advance((milliseconds - 1) / 1000)
        assert ask(brick, "DATA8 busy INPUT_TEST(0, 0, busy)") == "01"
        brick.advance(0.011)
        assert ask(brick, "DATA8 busy INPUT_TEST(0, 0, busy)") == "00"

    def test_only_ready_changes_a_device_that_is_busy(self, brick: Brick) -> None:
        ask(brick, PERCENT.format(1, 2))
        assert ask(brick, "DATAF v INPUT_DEVICE(READY_SI, 0, 1, 0, 1, 1, v)", seconds=0.03) == "00 00 00 00"
        assert ask(brick, "DATA8 t DATA8 m INPUT_DEVICE(GET_TYPEMODE, 0, 1, t, m)") == "1d 01"

    def test_a_motor_is_ready_as_soon_as_it_is_read(self, brick: Brick) -> None:
        brick.plug("B", 7)
        assert ask(brick, "DATAF v INPUT_READSI(0, 17, 0, 2, v)") == "00 00 00 00"

    def test_the_type_of_a_uart_sensor_is_unknown_until_one_was_there(self) -> None:
        brick = Brick()
        brick.plug(1, 30)
        taken_for = "DATA8 t DATA8 m INPUT_DEVICE(GET_TYPEMODE, 0, 0, t, m)"
        ask(brick, "DATA8 p INPUT_READ(0, 0, 29, 2, p)")
        assert ask(brick, taken_for) == "7d 00"
        brick.plug(2, 29)
        brick.advance(0.1)
        ask(brick, "DATA8 p INPUT_READ(0, 0, 29, 2, p)")
        assert ask(brick, taken_for) == "1d 02"

    def test_another_type_reads_the_same_bytes(self, brick: Brick) -> None:
        # 1234 is d2 04: as a signed byte -46.
        ask(brick, "DATA8 p INPUT_READ(0, 3, 29, 0, p)")
        brick.advance(0.1)
        assert ask(brick, "DATA32 raw INPUT_DEVICE(GET_RAW, 0, 3, raw)") == "d2 ff ff ff"

    def test_everything_is_cleared_and_reset(self, brick: Brick) -> None:
        brick.plug("B", 7)
        ask(brick, "OUTPUT_STEP_SYNC(0, A+B, 50, 0, 0, 1)")
        brick.press("enter")
        brick.advance(0.5)
        brick.release("enter")
        ask(brick, "INPUT_DEVICE(CLR_ALL, 0)")
        # The touch sensor is analog, the colour sensor sends by itself; the motors float.
        assert ask(brick, "DATA8 a DATA8 b INPUT_TEST(0, 0, a) INPUT_TEST(0, 1, b)") == "00 01"
        assert ask(brick, "DATA8 busy OUTPUT_TEST(0, A+B, busy)") == "00"
        assert ask(brick, "DATA8 pressed UI_BUTTON(SHORTPRESS, 2, pressed)") == "00"
        assert ask(brick, "DATA32 count OUTPUT_GET_COUNT(0, 0, count)") == "00 00 00 00"

    def test_a_device_that_is_changing_its_mode_keeps_it(self, brick: Brick) -> None:
        ask(brick, SI.format(2, 1))
        ask(brick, SI.format(2, 2))
        assert ask(brick, "DATA8 t DATA8 m INPUT_DEVICE(GET_TYPEMODE, 0, 2, t, m)") == "21 01"

    def test_reading_does_not_wait_for_it(self, brick: Brick) -> None:
        assert ask(brick, SI.format(1, 2)) == NAN
        assert ask(brick, "DATA8 t DATA8 m INPUT_DEVICE(GET_TYPEMODE, 0, 1, t, m)") == "1d 02"
        assert ask(brick, "DATA8 busy INPUT_TEST(0, 1, busy)") == "01"
        brick.advance(0.03)
        assert ask(brick, SI.format(1, 2)) == "00 00 a0 40"

    def test_waiting_for_a_device(self, brick: Brick) -> None:
        assert ask(brick, "INPUT_READY(0, 0)") == ""
        ask(brick, PERCENT.format(1, 4))
        assert ask(brick, "INPUT_READY(0, 1)", seconds=0.03) == ""

    def test_an_empty_port_is_never_ready(self, brick: Brick) -> None:
        assert ask(brick, "INPUT_READY(0, 17)", seconds=60) == "busy"

    def test_several_values(self, brick: Brick) -> None:
        read = "DATAF r DATAF g DATAF b INPUT_DEVICE(READY_SI, 0, 1, 29, 4, 3, r, g, b)"
        assert ask(brick, read, seconds=0.03) == "00 00 20 41 00 00 a0 41 00 00 f0 41"

    @pytest.mark.parametrize(
        ("port", "type", "mode", "found"),
        [
            (1, 0, 7, "1d 05"),  # a mode that there is not is the last one
            (1, 29, 7, "1d 05"),
            (1, 30, 1, "1e 01"),  # what the program says is believed ...
            (1, 77, 0, "7d 00"),
            (0, 29, 1, "10 01"),  # ... but of an EV3 touch sensor, which says itself what it is
            (17, 7, 1, "7e 00"),
        ],
    )
    def test_what_a_device_is_taken_for(self, brick: Brick, port: int, type: int, mode: int, found: str) -> None:
        ask(brick, f"DATA8 p INPUT_READ(0, {port}, {type}, {mode}, p)")
        assert ask(brick, f"DATA8 t DATA8 m INPUT_DEVICE(GET_TYPEMODE, 0, {port}, t, m)") == found
        kind = {0: "79", 1: "7a", 17: "7e"}[port]
        assert ask(brick, f"DATA8 c INPUT_DEVICE(GET_CONNECTION, 0, {port}, c)") == kind

    def test_changes_of_type_and_mode_are_counted(self, brick: Brick) -> None:
        count = "DATA8 changed ARRAY8 list 1 INPUT_DEVICE_LIST(1, list, changed)"
        assert ask(brick, count) == "05 10"
        ask(brick, PERCENT.format(1, 2))
        assert ask(brick, count) == "01 10"

    def test_a_count_can_be_given(self, brick: Brick) -> None:
        brick.plug(1, 16, {0: (1900,), 1: (7,)})
        assert ask(brick, "DATA32 n INPUT_DEVICE(READY_RAW, 0, 0, 16, 1, 1, n)", seconds=0.02) == "07 00 00 00"
        assert ask(brick, "DATAF c INPUT_DEVICE(GET_CHANGES, 0, 0, c)") == "00 00 e0 40"

    def test_a_motor_is_given_a_count(self, brick: Brick) -> None:
        ask(brick, "INPUT_DEVICE(SET_RAW, 0, 16, 0, 45)")
        assert ask(brick, SI.format(16, -1)) == "00 00 34 42"

    def test_presses_are_counted_in_a_mode_of_their_own(self, brick: Brick) -> None:
        for raw in (1100, 1900, 1100):
            brick.plug(1, 16, {0: (raw,)})
        assert ask(brick, "DATA32 n INPUT_DEVICE(READY_RAW, 0, 0, 16, 1, 1, n)", seconds=0.02) == "02 00 00 00"


class TestWriting:
    @pytest.mark.parametrize(
        ("write", "busy"), [("INPUT_WRITE(0, 1, 1, data)", "01"), ("INPUT_WRITE(0, 0, 1, data)", "00")]
    )
    def test_a_sensor_that_takes_bytes_is_busy_then(self, brick: Brick, write: str, busy: str) -> None:
        port = write[15]
        assert ask(brick, f"DATA8 busy local DATA8 data {write} INPUT_TEST(0, {port}, busy)") == busy

    @pytest.mark.parametrize(
        "write", ["INPUT_WRITE(0, 16, 1, data)", "INPUT_WRITE(0, 1, 33, data)", "INPUT_WRITE(0, 1, 0, data)"]
    )
    def test_what_fails(self, brick: Brick, write: str) -> None:
        with pytest.raises(RefusedError):
            ask(brick, f"DATA8 data {write}")

    def test_an_analog_value_is_set(self, brick: Brick) -> None:
        ask(brick, "INPUT_DEVICE(SET_RAW, 0, 0, 16, 1200)")
        assert ask(brick, PERCENT.format(0, 0)) == "14"


class TestPlugging:
    @pytest.mark.parametrize(
        ("port", "type", "readings", "message"),
        [
            (5, 16, None, "unknown port 5; expected one of 1, 2, 3, 4, A, B, C, D"),
            (True, 16, None, "unknown port True; expected one of 1, 2, 3, 4, A, B, C, D"),
            ("E", 7, None, "unknown port 'E'"),
            (MotorPorts.B, 7, None, "MotorPorts.B: 2> is a set of ports; expected one port: MotorPort.B"),
            (MotorPorts.A | MotorPorts.B, 7, None, "MotorPorts.A|B: 3> is a set of ports; expected one port$"),
            (1, 16, {2: (1,)}, "type 16 has no mode 2; it must be 0 to 1"),
        ],
    )
    def test_what_cannot_be(
        self, port: int | str, type: int, readings: dict[int, tuple[int]] | None, message: str
    ) -> None:
        with pytest.raises(ValueError, match=message):
            Brick().plug(port, type, readings)

    def test_what_is_plugged_in(self, brick: Brick) -> None:
        found = {port: device.type.number for port, device in brick.equipment.inputs.plugged().items()}
        assert found == {1: 16, 2: 29, 3: 33, 4: 30, "A": 8}

    def test_names_of_ports(self) -> None:
        brick = Brick()
        for port, kind in ((SensorPort.S1, 16), (SensorPort.S4, 30), (MotorPort.A, 8), (MotorPort.D, 7), ("b", 7)):
            brick.plug(port, kind)
        found = {port: device.type.number for port, device in brick.equipment.inputs.plugged().items()}
        assert found == {1: 16, 4: 30, "A": 8, "B": 7, "D": 7}
        assert [motor.type for motor in brick.equipment.outputs.motors] == [8, 7, 126, 7]

    def test_unplugging(self, brick: Brick) -> None:
        brick.plug(1, 126)
        assert ask(brick, PERCENT.format(0, 0)) == "80"

    def test_the_table_of_types(self) -> None:
        """As many modes and views as the firmware's table has."""
        found = {number: (len(device.modes), device.views) for number, device in DEVICE_TYPES.items()}
        assert found == {
            1: (2, 1), 2: (2, 2), 3: (2, 2), 4: (6, 5), 5: (2, 2), 6: (2, 2), 7: (3, 2), 8: (3, 2), 9: (1, 1),
            10: (1, 1), 11: (1, 1), 12: (1, 1), 13: (1, 1), 14: (1, 1), 15: (1, 1), 16: (2, 1), 17: (1, 1),
            18: (1, 1), 19: (1, 1), 20: (1, 1), 21: (1, 1), 22: (1, 1), 23: (1, 1), 24: (1, 1), 25: (1, 1),
            26: (1, 1), 27: (1, 1), 28: (4, 4), 29: (6, 3), 30: (7, 3), 32: (5, 2), 33: (6, 3), 99: (8, 7),
            100: (2, 2), 101: (1, 1), 125: (1, 1), 126: (1, 1),
        }  # fmt: skip
