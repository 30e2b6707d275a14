"""A tour of what the independent client `ev3_dc` can do with a brick over WiFi.

As a program, it shows a virtual brick to the client and prints the results; `captures/making/record-tour` captures
it.
"""

from __future__ import annotations

import gc
import tempfile
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import ev3_dc
from thread_task import concat

from ev3proto.brick.plugs import Plug
from ev3proto.brick.servers.script import Script
from ev3proto.brick.servers.server import Options
from ev3proto.tables.discovery import BEACON_PORT, TCP_PORT
from support.server import Served, beacon_port, free_port, served

ROBOT = Script(
    plugs=(
        Plug(1, 16, {0: (0.0,)}),
        Plug(2, 29, {0: (42.0,), 1: (7.0,), 2: (5.0,), 4: (100.0, 200.0, 300.0)}),
        Plug(3, 33, {0: (55.0,)}),
        Plug("A", 7, {}),
        Plug("C", 8, {}),
        Plug("D", 7, {}),
    ),
    name="Robby",
    voltage=7.9,
    current=0.2,
)
PROJECTS = "/home/root/lms2012/prjs"


@contextmanager
def connected(root: Path, port: int | None = None) -> Iterator[tuple[Served, Any]]:
    """A virtual robot, and the client that has found it by its beacon."""
    options = Options(port=port or free_port(), script=ROBOT)
    with beacon_port(), ThreadPoolExecutor() as pool:
        # Listen before the brick is switched on: the next beacon would come five seconds later.
        listening = pool.submit(ev3_dc.EV3, protocol=ev3_dc.WIFI)
        while not listening.done() and f":{BEACON_PORT:04X} " not in Path("/proc/net/udp").read_text():
            time.sleep(0.01)
        with served(root, options) as brick:
            client = listening.result()
            yield from _used(brick, client)


def _used(brick: Served, client: Any) -> Iterator[tuple[Served, Any]]:
    """Yields both, and releases the client at the end."""
    # Its objects talk to the brick when they are deleted, which must not happen in the thread of the brick.
    gc.disable()
    client._physical_ev3._socket.settimeout(30)
    try:
        yield brick, client
    finally:
        gc.collect()
        gc.enable()
        client._physical_ev3._socket.close()
        type(client._physical_ev3)._devices.clear()


def about(client: Any) -> Iterator[Any]:
    """Information about the brick, and its settings."""
    yield client.name
    yield client.battery
    yield client.sensors
    yield client.system
    yield client.memory
    yield client.network
    client.name, client.volume, client.sleep = "Robot", 20, 10
    yield client.battery and (client.name, client.volume, client.sleep)


def sensors(client: Any, brick: Served) -> Iterator[Any]:
    """Touch, colour and infrared."""
    plug = brick.now.brick.plug
    touch = ev3_dc.Touch(ev3_dc.PORT_1, ev3_obj=client)
    yield touch.touched, touch.bumps
    plug(1, 16, {0: (4000,)})
    yield touch.touched, touch.bumps
    plug(1, 16, {0: (0,)})
    yield touch.touched, touch.bumps
    color = ev3_dc.Color(ev3_dc.PORT_2, ev3_obj=client)
    yield color.reflected, color.ambient, color.color
    yield tuple(color.rgb_raw)
    yield ev3_dc.Infrared(ev3_dc.PORT_3, ev3_obj=client).distance


def motor(client: Any) -> Iterator[Any]:
    """A quarter of a turn and back, slowly and with a brake: a faster motor runs on."""
    motor = ev3_dc.Motor(ev3_dc.PORT_C, ev3_obj=client)
    yield motor.position, motor.busy
    motor.move_by(90, speed=30, brake=True).start(thread=False)
    yield motor.position, motor.busy
    motor.move_to(0, speed=30, brake=True).start(thread=False)
    yield motor.position, motor.busy


def square(client: Any) -> Any:
    """Drives a square and returns the final position of the vehicle."""
    vehicle = ev3_dc.TwoWheelVehicle(0.0282, 0.1175, ev3_obj=client, speed=30)
    sides = [
        part
        for _ in range(4)
        for part in (vehicle.drive_straight(0.02, brake=True), vehicle.drive_turn(90, 0.0, brake=True))
    ]
    concat(*sides).start(thread=False)
    return vehicle.position


def jukebox(client: Any, brick: Served) -> Iterator[Any]:
    """Light and tones. A command without a reply is run before a later one with a reply, here the battery's."""
    jukebox = ev3_dc.Jukebox(ev3_obj=client)
    jukebox.volume = 12
    jukebox.change_color(ev3_dc.LED_ORANGE)
    yield client.battery and brick.now.brick.leds
    jukebox.play_tone("a'", duration=20)
    yield client.battery and (before := _frequency(brick))
    song = jukebox.song(ev3_dc.HAPPY_BIRTHDAY)
    song.start()
    while (tone := _frequency(brick)) in (None, before):
        time.sleep(0.005)
    yield client.battery and tone
    song.stop()
    song.join()


def _frequency(brick: Served) -> int | None:
    """The tone that is playing."""
    playing = brick.now.brick.equipment.sound.playing
    return None if playing is None else playing.frequency


def files(client: Any) -> Iterator[Any]:
    """A folder, a file in both directions, a copy, and their removal."""
    system = ev3_dc.FileSystem(ev3_obj=client)
    folders, names = system.list_dir("/home/root/lms2012")
    yield sorted(folders), sorted(names)
    system.create_dir(f"{PROJECTS}/tour")
    system.write_file(f"{PROJECTS}/tour/a.txt", b"hello" * 300)
    yield system.read_file(f"{PROJECTS}/tour/a.txt") == b"hello" * 300
    system.copy_file(f"{PROJECTS}/tour/a.txt", f"{PROJECTS}/tour/b.txt")
    _, names = system.list_dir(f"{PROJECTS}/tour")
    yield sorted(names)
    system.del_file(f"{PROJECTS}/tour/b.txt")
    system.del_dir(f"{PROJECTS}/tour", secure=False)
    folders, _ = system.list_dir(PROJECTS)
    yield "tour" in folders


def main(say: Callable[[Any], None] = print) -> None:
    """Makes the whole tour."""
    with tempfile.TemporaryDirectory() as root, connected(Path(root), TCP_PORT) as (brick, client):
        for part in (about(client), sensors(client, brick), motor(client), jukebox(client, brick), files(client)):
            for said in part:
                say(said)
        say(square(client))


if __name__ == "__main__":
    main()
