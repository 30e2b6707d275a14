"""Sensors of one's own, declared by a script or a program: what clients and the page see of them."""

from __future__ import annotations

import re
from collections import deque
from pathlib import Path
from typing import Any

import pytest
from support.brick import ask

from ev3proto.brick import Brick
from ev3proto.brick.declared import DeclarationError
from ev3proto.brick.servers.page.state import Changes, answer
from ev3proto.brick.servers.page.watcher import Unshown
from ev3proto.brick.servers.script import read_script

SCRIPT = Path(__file__).parents[2] / "docs" / "howto" / "own-sensors.toml"
NAN = "00 00 c0 7f"


@pytest.fixture
def brick() -> Brick:
    """A brick with the sensors of the example: ultrasonic on 2, compass on 3."""
    brick = Brick()
    read_script(SCRIPT).set_up(brick)
    return brick


@pytest.mark.parametrize(
    ("read", "memory"),
    [
        ("DATA8 t DATA8 m INPUT_DEVICE(GET_TYPEMODE, 0, 1, t, m)", "3d 00"),
        ("DATA8 c INPUT_DEVICE(GET_CONNECTION, 0, 1, c)", "7a"),
        ("DATA8 c INPUT_DEVICE(GET_CONNECTION, 0, 2, c)", "78"),
        ("DATA8 a DATA8 b DATA8 c DATA8 d INPUT_DEVICE(GET_FORMAT, 0, 1, a, b, c, d)", "01 01 02 02"),
        ("DATA8 f DATA8 d INPUT_DEVICE(GET_FIGURES, 0, 1, f, d)", "05 01"),
        ("DATAF a DATAF b INPUT_DEVICE(GET_MINMAX, 0, 1, a, b)", "00 00 00 00 00 00 e1 43"),
        ("DATA32 r INPUT_DEVICE(GET_RAW, 0, 1, r)", "d2 04 00 00"),
        ("DATAF v INPUT_READSI(0, 1, 0, -1, v)", "cd cc f6 42"),
        ("DATA8 p INPUT_READ(0, 1, 0, -1, p)", "1b"),
        ("DATAF v INPUT_DEVICE(READY_SI, 0, 1, 61, 0, 1, v)", "cd cc f6 42"),
        ("DATA32 a DATA32 b INPUT_DEVICE(READY_RAW, 0, 2, 62, 0, 2, a, b)", "5a 00 00 00 00 00 00 80"),
        ("DATA8 a INPUT_DEVICE(READY_PCT, 0, 2, 62, 0, 1, a)", "19"),
        ("DATA32 a INPUT_READEXT(0, 2, 0, -1, DATA_RAW, 1, a)", "5a 00 00 00"),
        ("DATA8 changed ARRAY8 list 4 INPUT_DEVICE_LIST(4, list, changed)", "02 7e 3d 3e 7e"),
    ],
)  # fmt: skip
def test_what_is_read(brick: Brick, read: str, memory: str) -> None:
    assert ask(brick, read) == memory


@pytest.mark.parametrize(
    ("read", "text"),
    [
        ("INPUT_DEVICE(GET_NAME, 0, 2, 8, text)", b"HEADING\0"),
        ("INPUT_DEVICE(GET_SYMBOL, 0, 1, 5, text)", b"cm  \0"),
        ("INPUT_DEVICE(GET_MODENAME, 0, 2, 1, 8, text)", b"FIELD  \0"),
        ("INPUT_DEVICE(GET_MODENAME, 0, 2, 2, 8, text)", b"\0"),
    ],
)
def test_names(brick: Brick, read: str, text: bytes) -> None:
    assert bytes.fromhex(ask(brick, f"DATAS text 16 {read}")) == text.ljust(16, b"\0")


def test_a_change_of_mode_takes_its_time(brick: Brick) -> None:
    read = "DATAF v INPUT_READSI(0, 2, 0, 1, v)"
    assert ask(brick, read) == NAN
    brick.advance(0.09)
    assert ask(brick, read) == NAN
    brick.advance(0.02)
    assert ask(brick, read) != NAN
    read = "DATA32 x DATA32 y DATA32 z INPUT_DEVICE(READY_RAW, 0, 2, 0, -1, 3, x, y, z)"
    assert ask(brick, read) == "64 00 00 00 38 ff ff ff 2c 01 00 00"


def test_steps_of_the_script_change_its_readings(brick: Brick) -> None:
    script = read_script(SCRIPT)
    (step,) = script.steps
    script.do(step, brick)
    assert ask(brick, "DATAF v INPUT_READSI(0, 1, 0, -1, v)") == "00 00 70 41"
    brick.plug(3, 62, {0: (180,)})
    assert ask(brick, "DATAF v INPUT_READSI(0, 2, 0, -1, v)") == "00 00 34 43"


def test_a_type_of_lego_can_have_other_modes() -> None:
    """As of a sensor of another maker, which reports itself as LEGO's; the type is then known to other ports, too."""
    brick = Brick()
    modes = [{"name": "US-MM", "format": "DATA_32", "raw": (0, 9999), "symbol": "mm"}]
    brick.plug(4, {"type": "TYPE_ULTRASONIC", "modes": modes}, {0: (1500,)})
    assert ask(brick, "DATAF v INPUT_DEVICE(READY_SI, 0, 3, 30, 0, 1, v)") == "00 80 bb 44"
    assert ask(brick, "DATA8 a DATA8 b DATA8 c DATA8 d INPUT_DEVICE(GET_FORMAT, 0, 3, a, b, c, d)") == "01 02 01 01"
    with pytest.raises(ValueError, match="type 30 has no mode 1; it must be 0 to 0"):
        brick.plug(4, 30, {1: (1,)})


def test_the_page_shows_and_sets_them(brick: Brick) -> None:
    changes = Changes(brick, Unshown(deque()), list)
    state = changes.take()
    ultrasonic, compass = state["others"]
    assert (ultrasonic["title"], ultrasonic["modes"][0]["values"]) == (
        "ultrasonic sensor in millimetres",
        (("distance", "cm"),),
    )
    assert compass["modes"][1]["values"] == (("x", "uT"), ("y", "uT"), ("z", "uT"))
    assert [sensor["type"] for sensor in state["sensors"]] == [126, 61, 62, 126]
    assert answer(brick, '{"do": "read", "port": 2, "mode": 0, "values": [300]}') is None
    assert answer(brick, '{"do": "plug", "port": 1, "type": 62}') is None
    assert [sensor["values"] for sensor in changes.take()["sensors"]] == [[0.0], [300.0], [90.0], []]


MODE = {"name": "A", "format": "DATA_8", "raw": (0, 9)}
OWN = {"type": 61, "modes": [MODE]}


@pytest.mark.parametrize(
    ("declared", "message"),
    [
        ({"type": 61}, "device.modes is missing"),
        ({"modes": [MODE]}, "device.type is missing"),
        ({**OWN, "type": 126}, "device.type: unknown type 126; expected 1 to 124, or a name of TYPE"),
        ({**OWN, "type": "TYPE_GIRO"}, "device.type: unknown type 'TYPE_GIRO'"),
        ({**OWN, "type": 7}, "device.type: 7 is the type of a motor: large motor"),
        ({**OWN, "colour": 1}, "device: unknown key 'colour'; expected one of type, title, connection"),
        ({**OWN, "title": ""}, "device.title must be a text of 1 to 40 characters"),
        ({**OWN, "connection": "CONN_UART"}, "unknown name 'CONN_UART': did you mean CONN_INPUT_UART?"),
        ({**OWN, "settling": -1}, "device.settling must be a whole number from 0 to 5000"),
        ({**OWN, "modes": []}, "device.modes must be a list of 1 to 8 tables"),
        ({**OWN, "modes": [3]}, "device.modes.0 must be a table"),
        ({**OWN, "modes": [MODE, {"name": "B", "format": "DATA_8"}]}, "device.modes.1.raw is missing"),
        ({**OWN, "modes": [{**MODE, "raw": (1, 1)}]}, "device.modes.0.raw must be two different numbers"),
        ({**OWN, "modes": [{**MODE, "si": 5}]}, "device.modes.0.si must be two numbers: [least, most]"),
        ({**OWN, "modes": [{**MODE, "si": (0, float("inf"))}]}, "device.modes.0.si must be a number"),
        ({**OWN, "modes": [{**MODE, "format": "DATA_64"}]}, "device.modes.0.format: unknown name 'DATA_64'"),
        ({**OWN, "modes": [{**MODE, "name": "A-VERY-LONG-NAME"}]}, "device.modes.0.name must be a text of 1 to 11"),
        ({**OWN, "modes": [{**MODE, "symbol": "metre"}]}, "device.modes.0.symbol must be a text of 1 to 4"),
        ({**OWN, "modes": [{**MODE, "datasets": 9}]}, "device.modes.0.datasets must be a whole number from 1 to 8"),
        ({**OWN, "modes": [{**MODE, "datasets": 2, "values": ["a"]}]}, "modes.0.datasets is 2, but values has 1 name"),
        ({**OWN, "modes": [{**MODE, "values": "a"}]}, "device.modes.0.values must be a list of 1 to 8 names"),
    ],
)  # fmt: skip
def test_what_cannot_be_declared(declared: dict[str, Any], message: str) -> None:
    with pytest.raises(DeclarationError, match=re.escape(message)):
        Brick().plug(1, declared)


def test_a_type_is_a_number_or_a_declaration() -> None:
    with pytest.raises(ValueError, match="a type is a number, or a table that declares a device, not 'TYPE_TOUCH'"):
        Brick().plug(1, "TYPE_TOUCH")  # type: ignore[arg-type]


def test_only_sensors_can_be_declared() -> None:
    with pytest.raises(DeclarationError, match=r"device\.modes: only sensors can be declared, on the ports 1 to 4"):
        Brick().plug("A", OWN)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[ports.2]\ntype = 61", "ports.2.type: unknown type 61; expected one of TYPE_NXT_TOUCH, "),
        ("[ports.2]\nreadings.0 = 1", "ports.2.type is missing"),
        ("[ports.2]\ntype = 61\nmodes = [{ name = 'A' }]", "ports.2.modes.0.format is missing"),
        (
            "[ports.2]\ntype = 61\nmodes = [{ name = 'A', format = 'DATA_8', raw = [0, 9] }]\nreadings.1 = 4",
            "ports.2.readings.1: unknown mode; this type has modes 0 to 0",
        ),
        (
            "[ports.2]\ntype = 61\nmodes = [{ name = 'A', format = 'DATA_8', raw = [0, 9] }]\nreadings.0 = [4, 5]",
            "ports.2.readings.0 has 2 values; this mode has 1 value",
        ),
    ],
)
def test_what_is_not_declared_in_a_script(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "robot.toml"
    path.write_text(text)
    with pytest.raises(DeclarationError, match=re.escape(message)):
        read_script(path)
