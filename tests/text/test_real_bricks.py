"""Frames of real bricks: decoded, checked, read as their users read them, and sent to the virtual brick."""

from __future__ import annotations

import json
import re
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest

import ev3proto
from ev3proto.brick import Brick

LOG = Path(__file__).parents[2] / "captures" / "real-bricks.log"


class Exchange(NamedTuple):
    """A command, the reply of a real brick, and the value that its user read in it, or None."""

    printed_in: str
    command: bytes
    reply: bytes | None
    seen: dict[str, Any] | None

    def __str__(self) -> str:
        return f"{self.printed_in}: {self.command[4:].hex()}"


def read_log() -> Iterator[Exchange]:
    place = ""
    found: Exchange | None = None
    for line in LOG.read_text(encoding="ascii").splitlines():
        if line.startswith("# Printed in "):
            place = line.removeprefix("# Printed in ")
        elif line.startswith("# Seen ") and found is not None:
            found = found._replace(seen=json.loads(line.removeprefix("# Seen ")))
        elif line.startswith("Recv ") and found is not None:
            found = found._replace(reply=frame_of(line))
        elif line.startswith("Sent "):
            if found is not None:
                yield found
            found = Exchange(place, frame_of(line), None, None)
    assert found is not None
    yield found


def frame_of(line: str) -> bytes:
    return bytes.fromhex(re.sub(r"^\w+ 0x|[:|]", "", line))


EXCHANGES = list(read_log())
WITH_VALUES = [exchange for exchange in EXCHANGES if exchange.seen is not None]


def test_the_log_is_whole() -> None:
    assert len(EXCHANGES) == 170
    assert sum(exchange.reply is not None for exchange in EXCHANGES) == 126


def test_every_frame_is_read_without_a_fault_and_built_as_it_was() -> None:
    for exchange in EXCHANGES:
        for frame in filter(None, (exchange.command, exchange.reply)):
            assert ev3proto.parse(frame).build() == frame


def test_the_brick_takes_every_command() -> None:
    for exchange in EXCHANGES:
        assert ev3proto.check(exchange.command).accepted, str(exchange)


@pytest.mark.parametrize("exchange", WITH_VALUES, ids=str)
def test_values_are_those_that_the_users_saw(exchange: Exchange) -> None:
    assert exchange.reply is not None
    assert exchange.seen is not None
    dialogue = ev3proto.Dialogue()
    dialogue.feed(ev3proto.parse(exchange.command))
    read: dict[str, list[Any]] = {}
    for value in dialogue.feed(ev3proto.parse(exchange.reply)):
        read.setdefault(value.name, []).append(value.value)
    for name, expected in exchange.seen.items():
        if name.endswith("~"):
            assert all(part in str(read[name[:-1]][0]) for part in expected)
        else:
            wanted = [float(number) for number in (expected if isinstance(expected, list) else [expected])]
            assert read[name] == pytest.approx(wanted, abs=0.005, nan_ok=True)


# Sent to the virtual brick

SAME_CONTENTS = (
    b"\x81\x01",  # UI_READ GET_VBATT and the next operations
    b"\x99\x05",  # INPUT_DEVICE GET_TYPEMODE
    b"\x99\x1d",  # READY_SI
    b"\x99\x1c",  # READY_RAW
)
"""The beginnings of commands whose replies depend on what is plugged in."""


@pytest.fixture
def brick(tmp_path: Path) -> Brick:
    """A brick with the devices and folders of the pages in the log."""
    brick = Brick(tmp_path)
    listing = next(exchange.reply for exchange in EXCHANGES if exchange.seen and "list~" in exchange.seen)
    assert listing is not None
    for folder in ("everstorm", "BrkProg_SAVE"):
        (tmp_path / "prjs" / folder).mkdir()
    for size, name in re.findall(rb"[0-9A-F]{32} ([0-9A-F]{8}) (\S+)\n", listing):
        (tmp_path / "prjs" / "everstorm" / name.decode()).write_bytes(bytes(int(size, 16)))
    (tmp_path / "prjs" / "BrkProg_SAVE" / "Demo.rpf").write_bytes(bytes(0x9A0))
    (tmp_path / "prjs" / "BrkProg_SAVE" / "CVS").mkdir()
    return brick


def plug_in(brick: Brick) -> None:
    """The devices of the page of examples: touch sensor bumped 12 times, colour, infrared; motors."""
    brick.plug(1, 16, {0: (2000,), 1: (12,)})
    brick.plug(2, 29, {2: (3,)})
    brick.plug(3, 33, {0: (26,), 1: (0, -128, -21, 27, 0, -128, 0, -128)})
    brick.plug("A", 7)
    brick.plug("C", 8)
    brick.plug("D", 7)


def play(brick: Brick, exchange: Exchange) -> bytes | None:
    """Sends a command and waits for its reply, if it wants one."""
    replies = brick.receive(exchange.command)
    for _ in range(100):
        if replies or exchange.reply is None:
            break
        replies = brick.advance(0.1)
    assert len(replies) == (exchange.reply is not None), str(exchange)
    return replies[0] if replies else None


def test_commands_are_answered_in_the_same_way(brick: Brick) -> None:
    plug_in(brick)
    brick.plug("B", 7)
    for exchange in EXCHANGES:
        reply = play(brick, exchange)
        if exchange.reply is not None:
            assert reply is not None
            if exchange.command[4] == 0:
                assert (reply[:5], len(reply)) == (exchange.reply[:5], len(exchange.reply)), str(exchange)
            else:
                assert reply[2:6] == exchange.reply[2:6], str(exchange)


def test_a_project_is_listed_with_the_same_sizes(brick: Brick) -> None:
    for exchange in WITH_VALUES:
        if exchange.seen is not None and "list~" in exchange.seen:
            reply = play(brick, exchange)
            assert reply is not None
            assert exchange.reply is not None
            assert reply[:12] == exchange.reply[:12]
            lines = re.compile(rb"^[0-9A-F]{32} (.+)$", re.MULTILINE)
            assert sorted(lines.findall(reply[12:])) == sorted(lines.findall(exchange.reply[12:]))
            assert reply.endswith(b"../\n./\n")


def test_a_folder_is_listed_in_pieces_as_there(brick: Brick) -> None:
    pieces = [exchange for exchange in EXCHANGES if exchange.printed_in == "sys_list_files.yml"]
    found, expected = b"", b""
    for exchange in pieces:
        reply = play(brick, exchange)
        assert reply is not None
        assert exchange.reply is not None
        assert (reply[:7], len(reply)) == (exchange.reply[:7], len(exchange.reply))
        head = 12 if exchange is pieces[0] else 8
        found, expected = found + reply[head:], expected + exchange.reply[head:]
    assert sorted(line[-17:] for line in found.splitlines()) == sorted(line[-17:] for line in expected.splitlines())


@pytest.mark.parametrize(
    "exchange",
    [
        exchange
        for exchange in EXCHANGES
        if exchange.printed_in == "examples_ev3.rst" and exchange.command[7:9] in SAME_CONTENTS
    ],
    ids=str,
)
def test_values_of_sensors_are_the_same(brick: Brick, exchange: Exchange) -> None:
    plug_in(brick)
    brick.advance(2)
    if exchange.command[10] == 17:
        brick.plug("B", 7, count=-33)
        brick.advance(2)
    if exchange.command[7] == 0x81:
        assert exchange.reply is not None
        battery = brick.equipment.panel.battery
        battery.voltage, battery.current = struct.unpack("<ff", exchange.reply[5:13])
    assert play(brick, exchange) == exchange.reply


def test_an_empty_port_gives_no_number_as_there(brick: Brick) -> None:
    exchange = next(exchange for exchange in EXCHANGES if exchange.printed_in == "light-sensor.yml")
    assert play(brick, exchange) == exchange.reply


def test_a_move_is_busy_until_it_has_ended(brick: Brick) -> None:
    plug_in(brick)
    brick.plug("B", 7)
    polls = [exchange for exchange in EXCHANGES if exchange.command[7:8] == b"\xa9"]
    step = next(exchange for exchange in EXCHANGES if exchange.command[7:8] == b"\xae" and exchange.reply is None)
    brick.receive(step.command)
    assert brick.receive(polls[0].command)[0][5] == 1
    brick.advance(10)
    assert brick.receive(polls[0].command)[0][5] == 0
