"""Every room says the same of bytes that are taken for a frame: they all ask `semantics.identify`.

A room that answers for itself again fails here. What a room rightly says otherwise is a row of `OTHERWISE` with its
reason.
"""

from __future__ import annotations

import io
import json
import os
import re
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import pytest
from support.cli import run_ev3proto
from support.packets import RAW_IP, Capture, Connection
from support.relays import relay
from support.server import ACCEPT, UNLOCK, Client, served
from support.stub_brick import stub_brick

import ev3proto
from ev3proto.capture import Record, Skipped, read
from ev3proto.reading.faults import Faults
from ev3proto.text.paste import read_text

ROOT = Path(__file__).parents[2]
TONE = bytes.fromhex("0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03")
NXT = "this is a telegram of the NXT"
DIGITS = rf"a frame written as characters; send {TONE.hex(' ').upper()}"

BYTES = {
    "NXT, tone": (bytes.fromhex("06 00 80 03 B8 01 E8 03"), rf"{NXT} \(PLAYTONE\)"),
    "NXT, motor on B": (bytes.fromhex("0C 00 80 04 01 64 07 00 00 20 00 00 00 00"), rf"{NXT} \(SETOUTPUTSTATE\)"),
    "hub": (
        bytes.fromhex("08 00 81 32 11 51 00 64"),
        r"this is a message of LEGO's Wireless Protocol \(port output command\)",
    ),
    "hex digits": (TONE.hex().encode(), DIGITS),
    "numbers": (" ".join(map(str, TONE)).encode(), DIGITS),
    "text": (b"forward\r\n", "this is the text 'forward', not a frame; a Messaging block needs WRITEMAILBOX"),
    "counts itself": (b"\x10" + TONE[1:], "length (does not count|counts) its own two bytes"),
    "cut": (TONE[:-3], "14 bytes follow(?: it)?, but (there are )?11"),
    "operations": (TONE[7:], "these are operations without"),
}
"""Bytes, and what rooms say of them."""

FRAME, NOTHING_YET = r"\[b'", r"out of reach\?$"
NEVER = "text where a frame should be"
"""What the header alone shows, where all bytes are there."""

OTHERWISE = {
    ("paste", "NXT, motor on B"): (FRAME, "its length fits: decode and check read it, and name it"),
    ("paste", "counts itself"): (FRAME, "decode and check say what is wrong with a frame"),
    ("paste", "cut"): (FRAME, "the same"),
    ("capture", "operations"): ("9 bytes came and 397 are missing", "in a capture, a frame is rather cut"),
    ("capture", "cut"): ("13 bytes came and 3 are missing", "the end of a stream says what is missing"),
    ("brick", "cut"): ("13 of its 16 bytes came", "the same"),
    ("proxy", "cut"): ("inside a frame, after 13 bytes", "the same"),
    ("link", "counts itself"): (NOTHING_YET, "more bytes may come"),
    ("link", "cut"): (NOTHING_YET, "more bytes may come"),
    ("link", "operations"): ("not a frame, 94:01:01", "a brick does not send operations"),
    ("page", "operations"): ("A frame without its header: plays 440 Hz", "its headline says what they do"),
}
"""What rooms rightly say otherwise, and why."""


def decoded(data: bytes) -> str:
    done = run_ev3proto("decode", "-", stdin=data.hex(" ").encode())
    return (done.stdout + done.stderr).decode()


def pasted(data: bytes) -> str:
    return str([piece.problem or piece.data for piece in read_text([f"{data.hex(' ')}\n"])])


def checked(data: bytes) -> str:
    return str(ev3proto.check(data, alone=True))


def captured(data: bytes) -> str:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(UNLOCK)
    connection.receive(ACCEPT)
    connection.send(data)
    faults, said = Faults(), []
    for event in read(io.BytesIO(capture.data())).events():
        if isinstance(event, Skipped):
            said.append(event.reason)
        elif isinstance(event, Record) and (problem := faults.of(event, is_text=False)) is not None:
            said += [problem.message, event.note or ""]
    return str(said)


def _answers(said: list[str], send: Callable[[bytes], None], data: bytes) -> str:
    """What is said anew of bytes, which each client sends before it ends its connection."""
    before = len(said)
    send(data)
    end = time.monotonic() + 2
    while len(said) == before and time.monotonic() < end:
        time.sleep(0.01)
    return str(said[before:])


def sent_to(port: int) -> Callable[[bytes], None]:
    def send(data: bytes) -> None:
        with Client(port) as client:
            client.send(data)

    return send


@pytest.fixture(scope="module")
def rooms(tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, Callable[[bytes], str]]]:
    """The rooms: what each says about bytes."""
    junk = [b""]
    with (
        served(tmp_path_factory.mktemp("brick")) as brick,
        relay("virtual") as proxy,
        stub_brick(lambda _, send: send(junk[0])) as port,
    ):

        def linked(data: bytes) -> str:
            junk[0] = data
            with (
                ev3proto.EV3(protocol=ev3proto.WIFI, address=("127.0.0.1", port), timeout=0.1) as my_ev3,
                pytest.raises(ev3proto.NoAnswerError) as error,
            ):
                my_ev3.send_direct_cmd(b"\x01", sync_mode="SYNC")
            return str(error.value)

        yield {
            "paste": pasted,
            "decode": decoded,
            "check": checked,
            "capture": captured,
            "brick": partial(_answers, brick.said, sent_to(brick.port)),
            "proxy": partial(_answers, proxy.said, sent_to(proxy.proxy.port)),
            "link": linked,
            "page": _page().__getitem__,
        }


def _page() -> dict[bytes, str]:
    """What the page says, whose Python is started once."""
    texts = [data.hex(" ") for data, _ in BYTES.values()]
    script = f"import bridge, json; print(json.dumps([bridge.look(text) for text in {texts}]))"
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "docs" / "playground")}
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=True)
    return dict(zip((data for data, _ in BYTES.values()), json.loads(done.stdout), strict=True))


def test_every_room_says_the_same(rooms: dict[str, Callable[[bytes], str]]) -> None:
    wrong = []
    for name, (data, usual) in BYTES.items():
        for room, says in rooms.items():
            expected, _ = OTHERWISE.get((room, name), (usual, ""))
            if re.search(expected, said := says(data)) is None or NEVER in said:
                wrong.append((room, name, said))
    assert wrong == []
