"""An independent client, `ev3_dc`, talks to the virtual brick: its results are right."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import ev3_dc
import pytest
from support import tour
from support.server import Served

from ev3proto.brick.servers.script import read_script

OWN_SENSORS = Path(__file__).parents[2] / "docs" / "howto" / "own-sensors.toml"

Talking = tuple[Served, Any]


@pytest.fixture(scope="module")
def talking(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Talking]:
    with tour.connected(tmp_path_factory.mktemp("root")) as talking:
        yield talking


def test_about_the_brick(talking: Talking) -> None:
    brick, client = talking
    name, battery, sensors, system, memory, network, changed = tour.about(client)
    assert name == "Robby"
    assert battery == (pytest.approx(7.9), pytest.approx(0.2), 100)
    assert tuple(sensors) == (16, 29, 33, None, 7, None, 8, 7)
    assert (system.fw_version, system.hw_version) == ("V1.04H", "V0.60")
    assert memory == (6000, 6000)
    # The third is the address of the WiFi dongle, which this client splits in the wrong places.
    assert network[:2] == ("ev3proto", "127.0.0.1")
    assert changed == ("Robot", 20, 10)
    assert client.host == "00:16:53:0F:0C:1E"
    assert str(client) == "WiFi connected EV3 00:16:53:0F:0C:1E (Robot)"
    assert brick.now.brick.equipment.settings.name == "Robot"


def test_sensors(talking: Talking) -> None:
    brick, client = talking
    assert list(tour.sensors(client, brick)) == [
        (False, 0),
        (True, 0),
        (False, 1),
        (42, 7, 5),
        (100, 200, 300),
        0.55,
    ]


def test_sensors_that_a_script_declares(talking: Talking) -> None:
    """The compass of the example, on port 4."""
    brick, client = talking
    (compass,) = (plug for plug in read_script(OWN_SENSORS).plugs if plug.port == 3)
    brick.now.brick.plug(4, compass.type, compass.readings)
    try:
        heading = [ev3_dc.opInput_Device, ev3_dc.READY_SI, b"\0\3", ev3_dc.LCX(62), b"\0\1", ev3_dc.GVX(0)]
        assert struct.unpack("<f", client.send_direct_cmd(b"".join(heading), global_mem=4)) == (90,)
        name = [ev3_dc.opInput_Device, ev3_dc.GET_NAME, b"\0\3\x0c", ev3_dc.GVX(0)]
        assert client.send_direct_cmd(b"".join(name), global_mem=12) == b"HEADING    \0"
    finally:
        brick.now.brick.plug(4, 126)


def test_motor(talking: Talking) -> None:
    _, client = talking
    found = list(tour.motor(client))
    assert [busy for _, busy in found] == [False] * 3
    assert [position for position, _ in found] == pytest.approx([0, 90, 0], abs=10)


def test_vehicle_drives_a_square(talking: Talking) -> None:
    _, client = talking
    # It ends where it began, in the same direction: within 1 cm and some degrees, as its moves overshoot a little.
    x, y, direction = tour.square(client)
    assert (x, y) == pytest.approx((0, 0), abs=0.02)
    assert direction == pytest.approx(0, abs=4)


def test_jukebox(talking: Talking) -> None:
    brick, client = talking
    # LED_ORANGE is pattern 3; a' has 440 Hz; the song begins with d' (294 Hz).
    assert list(tour.jukebox(client, brick)) == [3, 440, 294]


def test_files(talking: Talking) -> None:
    _, client = talking
    # The output of md5sum for it.
    digest = "3C75ACA2359B8B5B31670E96EE3DAF86"
    folders, is_intact, names, is_left = tour.files(client)
    assert folders == ([".", "..", "apps", "prjs", "sys", "tools"], [])
    assert is_intact
    assert names == [("a.txt", 1500, digest), ("b.txt", 1500, digest)]
    assert not is_left
