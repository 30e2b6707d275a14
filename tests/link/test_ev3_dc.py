"""A program of ev3_dc's lower layer, run by ev3_dc and by this project against the same brick, prints the same.

docs/ev3_dc.md lists the intended differences.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

from support.announcing import Announcing, free_udp_port
from support.cli import run_program
from support.server import beacon_port, free_port, served

from ev3proto.brick.servers.server import Options

PROGRAM = Path(__file__).parent / "lower_layer" / "direct_commands.py"
OTHER_PORT = """
import socket
bind = socket.socket.bind
socket.socket.bind = lambda self, place: bind(self, ("127.0.0.1", {}) if place[1] == 3015 else place)
"""
"""Lets ev3_dc wait for beacons on a port of the test."""

TIME = re.compile(r"^\d\d:\d\d:\d\d\.\d{6} ", re.MULTILINE)


def printed(program: str, **environment: str) -> list[str]:
    """Returns the output of a program, without its times."""
    done = run_program(sys.executable, "-c", program, env=environment)
    assert done.stderr == ""
    return TIME.sub("", done.stdout).splitlines()


def test_both_print_the_same(tmp_path: Path) -> None:
    program = PROGRAM.read_text()
    beacons = free_udp_port()
    with (
        served(tmp_path / "one", Options(port=free_port(), beacon=False)) as brick,
        Announcing("0016530f0c1e", brick.port, beacons),
    ):
        brick.now.brick.plug("A", 7, count=90)
        by_ev3_dc = printed(f"{OTHER_PORT.format(beacons)}\n{program}")
    with served(tmp_path / "two") as brick:
        brick.now.brick.plug("A", 7, count=90)
        ours = program.replace("import ev3_dc as ev3", "import ev3proto as ev3")
        by_ev3proto = printed(ours, EV3PROTO_TARGET=f"wifi:127.0.0.1:{brick.port}")
    assert by_ev3proto == by_ev3_dc


def test_ev3_dc_finds_the_proxy_by_the_serial_number_of_its_brick(tmp_path: Path) -> None:
    port = free_port()
    program = (
        "import ev3_dc as ev3\n"
        "with ev3.EV3(protocol=ev3.WIFI, host='00:16:53:40:AB:CD') as my_ev3:\n"
        "    print(my_ev3.send_direct_cmd(ev3.opInfo + ev3.GET_VOLUME + ev3.GVX(0), global_mem=1))\n"
    )
    with (
        served(tmp_path, Options(port=0, beacon=False, serial_number="00165340abcd")) as brick,
        beacon_port(),
        subprocess.Popen(
            [
                *(sys.executable, "-m", "ev3proto", "proxy", "--to", f"wifi:127.0.0.1:{brick.port}"),
                *("--listen", f"wifi:127.0.0.1:{port}", "--read-only"),
            ],
            stdout=subprocess.PIPE,
        ) as proxy,
    ):
        assert proxy.stdout is not None
        assert proxy.stdout.readline() == f"listening on 127.0.0.1:{port}\n".encode()
        assert printed(f"{OTHER_PORT.format(3015)}\n{program}") == ["b'd'"]
        proxy.terminate()
