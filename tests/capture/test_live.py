"""`ev3proto live` as a process: it captures a program on this computer that talks to an imitated brick.

Capturing needs permission, which the tests may not have. Then it must say so.
"""

from __future__ import annotations

import json
import os
import re
import shlex
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest
from support.cli import run_ev3proto_text
from support.messages import voltage
from support.wireshark import Tshark

ROOT = Path(__file__).parents[2]
LOOPBACK = "lo0" if sys.platform == "darwin" else "lo"
WITHIN = 60
"""Seconds after which everything must have happened."""

UNLOCK = b"GET /target?sn=06165300000a VMTP1.0\r\nProtocol: EV3\r\n\r\n"
ACCEPT = b"Accept:EV340\r\n\r\n\0"
TONE = bytes.fromhex("0e00 0200 80 0000 94 01 05 82b801 82fa00")


def answer(counter: int) -> bytes:
    """7.92 volts."""
    return bytes((7, 0, counter, 0)) + bytes.fromhex("02 a470fd40")


SILENT = 9
"""The counter of commands that the imitation does not answer."""


@contextmanager
def brick() -> Iterator[int]:
    """A brick on a port of this computer, which answers requests for the voltage."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        server.settimeout(WITHIN)

        def serve() -> None:
            connection, _ = server.accept()
            with connection:
                stream = connection.makefile("rb")
                assert stream.read(len(UNLOCK)) == UNLOCK
                connection.sendall(ACCEPT)
                while length := stream.read(2):
                    counter, _, kind, *_ = stream.read(int.from_bytes(length, "little"))
                    if kind == 0 and counter != SILENT:
                        connection.sendall(answer(counter))

        thread = threading.Thread(target=serve, daemon=True)
        thread.start()
        yield server.getsockname()[1]
        thread.join(WITHIN)


@dataclass
class Listening:
    """`ev3proto live` while it runs. It shows every brick on the loopback interface, also those of other tests."""

    process: subprocess.Popen[str]
    lines: list[str]
    port: int = 0

    def own(self) -> list[str]:
        """Returns the lines about the brick at `port`, and those about none."""
        place, found, is_own = f"127.0.0.1:{self.port}", [], False
        for line in list(self.lines):
            if re.fullmatch(r"wifi \S+", line):
                is_own = line == f"wifi {place}"
            about = re.search(r"#\d+ wifi (\S+) (?:sent|received) |\"peer\": \"(\S+)\"", line)
            is_about_none = line.startswith("Capturing")
            if place in about.groups() if about else is_own or is_about_none:
                found.append(line)
        return found

    def wait_for(self, pattern: str) -> str:
        """Returns the first of these lines that matches a pattern; fails if none comes."""
        end = time.monotonic() + WITHIN
        while time.monotonic() < end:
            found = next((line for line in self.own() if re.search(pattern, line)), None)
            if found is not None:
                return found
            time.sleep(0.02)
        raise AssertionError(f"no line like {pattern!r} came, but {self.lines}")


def words(*options: str) -> list[str]:
    return [sys.executable, "-m", "ev3proto", "live", *options]


@contextmanager
def listening(*options: str, port: int = 0) -> Iterator[Listening]:
    """Runs it, and kills it with its child processes if it is still running at the end."""
    with subprocess.Popen(
        words(*options), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=ROOT, start_new_session=True
    ) as process:
        assert process.stdout
        assert process.stderr
        running = Listening(process, [], port)

        def listen(stream: Iterator[str]) -> None:
            running.lines.extend(line.rstrip("\n") for line in stream)

        threads = [threading.Thread(target=listen, args=(stream,)) for stream in (process.stdout, process.stderr)]
        for thread in threads:
            thread.start()
        try:
            yield running
        finally:
            for thread in threads:
                if process.poll() is None:
                    os.killpg(process.pid, signal.SIGKILL)
                thread.join(WITHIN)


def refused(*options: str) -> tuple[int, str]:
    """Returns status and errors of a call that ends before capturing."""
    done = run_ev3proto_text("live", *options)
    assert done.stdout == ""
    return done.returncode, done.stderr


def group(number: int) -> list[str]:
    """The running programs of a process group."""
    listed = subprocess.run(["ps", "-eo", "pgid=,stat=,args="], capture_output=True, text=True, check=True).stdout
    rows = (line.split(None, 2) for line in listed.splitlines())
    return [row[2] for row in rows if row[0] == str(number) and not row[1].startswith("Z")]


@pytest.fixture(scope="module")
def capturing(tshark: Tshark) -> str | None:
    """A tshark that may capture, or None after a check of the error: then nothing is left to test."""
    program = str(tshark.program)
    asked = subprocess.run([program, "-i", LOOPBACK, "-L"], capture_output=True, text=True, timeout=60, check=False)
    if asked.returncode == 0:
        return program
    status, complaint = refused("-i", LOOPBACK, "--tshark", program)
    assert status == 1
    assert complaint.startswith(f"{program} is not allowed to capture: on Debian and Ubuntu run sudo dpkg-reconfigure")
    return None


@contextmanager
def talk(port: int) -> Iterator[Callable[..., None]]:
    """Connects to a brick and unlocks it; the function sends, and waits for the answer."""
    with socket.create_connection(("127.0.0.1", port), timeout=WITHIN) as connection:

        def say(data: bytes, expected: bytes = b"") -> None:
            connection.sendall(data)
            if expected:
                assert connection.recv(len(expected), socket.MSG_WAITALL) == expected

        say(UNLOCK, ACCEPT)
        yield say


@pytest.mark.parametrize("ending", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_dialogues_while_they_happen(capturing: str | None, ending: signal.Signals) -> None:
    if capturing is None:
        return
    with brick() as port, listening("-i", LOOPBACK, "--port", str(port), "--tshark", capturing, port=port) as live:
        assert live.wait_for("Ctrl-C") == f"Capturing on {LOOPBACK}. Ctrl-C ends it."
        with talk(port) as say:
            say(voltage(1), answer(1))
            line = live.wait_for("GET_VBATT")
            assert re.fullmatch(
                r" +\d\.\d{6} +#\d+ UI_READ\.GET_VBATT\(VALUE=GV\(0\)\) -> VALUE=7\.92 V  \d+\.\d{3} ms",
                line,
            )
            say(voltage(SILENT))
            say(TONE)
            assert live.wait_for("SOUND").endswith("SOUND.TONE(VOLUME=5, FREQUENCY=440, DURATION=250)")
            assert sum("GET_VBATT" in line for line in live.own()) == 1
            assert len(group(live.process.pid)) >= 3  # it, tshark, and tshark's capturing program
            live.process.send_signal(ending)
            assert live.process.wait(WITHIN) == 0
            assert live.wait_for("no reply").endswith("UI_READ.GET_VBATT(VALUE=GV(0)) -> no reply  (counter 9)")
            assert group(live.process.pid) == []
        live.wait_for("unlock: serial 06165300000a$")
        live.wait_for("accepted$")
        assert sum("#" in line for line in live.own()) == 5


def test_ctrl_c_in_a_terminal_reaches_all_of_them(capturing: str | None) -> None:
    if capturing is None:
        return
    with listening("-i", LOOPBACK, "--tshark", capturing) as live:
        live.wait_for("Ctrl-C")
        os.killpg(live.process.pid, signal.SIGINT)
        assert live.process.wait(WITHIN) == 0
        assert group(live.process.pid) == []
        assert live.own() == [f"Capturing on {LOOPBACK}. Ctrl-C ends it."]


def test_json_and_a_filter(capturing: str | None) -> None:
    if capturing is None:
        return
    options = ("-i", LOOPBACK, "--tshark", capturing, "--json", "--filter", "op==UI_READ.GET_VBATT")
    with brick() as port, listening(*options, "--port", str(port), port=port) as live, talk(port) as say:
        live.wait_for("Ctrl-C")
        say(TONE)
        say(voltage(1), answer(1))
        shown = json.loads(live.wait_for("^{"))
        live.process.send_signal(signal.SIGINT)
        assert live.process.wait(WITHIN) == 0
        assert shown["command"]["hex"] == voltage(1).hex()
        assert shown["reply"]["hex"] == answer(1).hex()
        assert 0 < shown["latency"] < WITHIN
        assert sum(line.startswith("{") for line in live.own()) == 1


def test_a_reader_that_goes_away(capturing: str | None) -> None:
    if capturing is None:
        return
    with brick() as port:
        command = shlex.join(words("-i", LOOPBACK, "--tshark", capturing, "--port", str(port)))
        with subprocess.Popen(
            ["sh", "-c", f"{command} | head -n 1"],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            cwd=ROOT,
            start_new_session=True,
        ) as process:
            assert process.stderr
            assert process.stderr.readline().startswith("Capturing on")
            with talk(port) as say:
                counter = 0
                end = time.monotonic() + WITHIN
                while process.poll() is None and time.monotonic() < end:  # it notices when it writes
                    counter = (counter + 1) % SILENT
                    say(voltage(counter), answer(counter))
                    time.sleep(0.2)
            output, complaints = process.communicate(timeout=WITHIN)
        assert output.count("\n") == 1
        assert complaints == ""
        assert group(process.pid) == []


ENDLESS = """#!{python}
import signal, sys
signal.signal(signal.SIGTERM, signal.SIG_IGN)
data = open({capture!r}, "rb").read()
blocks = data[:{head}], data[{head}:]
sys.stdout.buffer.write(blocks[0])
while True:
    sys.stdout.buffer.write(blocks[1])
    sys.stdout.flush()
"""
"""A tshark that has captured more than it will ever have handed over, and does that first when it is to stop."""


@pytest.mark.parametrize("is_read", [True, False], ids=["read", "not read"])
def test_it_ends_soon_whatever_was_captured(is_read: bool, tmp_path: Path) -> None:
    program = tmp_path / "tshark"
    program.write_text(ENDLESS.format(python=sys.executable, capture=str(ROOT / "captures" / "wifi.pcapng"), head=48))
    program.chmod(0o755)
    hasty = "from ev3proto.cli import ending, main; ending.PATIENCE = 0.3; main.main()"
    call = [sys.executable, "-c", hasty, "live", "-i", LOOPBACK, "--tshark", str(program), "--json"]
    with subprocess.Popen(
        call, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=ROOT, start_new_session=True
    ) as process:
        assert process.stdout
        assert process.stderr
        try:
            assert process.stderr.readline().startswith(b"Capturing on")
            process.stdout.readline()
            output = process.stdout
            reader = threading.Thread(target=lambda: all(iter(lambda: output.read(1 << 16), b"")), daemon=True)
            if is_read:
                reader.start()
            begin = time.monotonic()
            process.send_signal(signal.SIGTERM)
            assert process.wait(WITHIN) == 128 + signal.SIGTERM
            assert time.monotonic() - begin < WITHIN / 2
            assert group(process.pid) == []
            assert process.stderr.read() == b""
            if is_read:
                reader.join(WITHIN)
        finally:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)


def test_an_interface_that_is_not_there(tshark: Tshark) -> None:
    """Without the right to capture, a user does not learn that: tshark says first that they may not."""
    status, complaint = refused("-i", "nothing0", "--tshark", str(tshark.program))
    assert status == 1
    # The link types of an interface are read from the opened interface.
    may_capture = (
        subprocess.run([tshark.program, "-i", LOOPBACK, "-L"], capture_output=True, check=False).returncode == 0
    )
    if may_capture:
        assert "nothing0" in complaint
        assert complaint.endswith("; tshark -D lists the interfaces, sudo modprobe usbmon adds USB\n")
    else:
        assert complaint.startswith(f"{tshark.program} is not allowed to capture: on Debian and Ubuntu run ")


def test_no_tshark() -> None:
    assert refused("-i", LOOPBACK, "--tshark", "/no/tshark") == (
        1,
        "/no/tshark: no such program: install tshark, which is part of Wireshark, or pass its path by --tshark\n",
    )


@pytest.mark.parametrize("said", ["You don't have permission to capture on that device", "dumpcap: Permission denied"])
def test_without_the_right_to_capture(tmp_path: Path, said: str) -> None:
    program = tmp_path / "tshark"
    program.write_text(f'#!/bin/sh\necho "tshark: {said}" >&2; exit 2\n')
    program.chmod(0o755)
    assert refused("-i", LOOPBACK, "--tshark", str(program)) == (
        1,
        f"{program} is not allowed to capture: on Debian and Ubuntu run sudo dpkg-reconfigure wireshark-common, choose"
        " Yes, join the group with sudo usermod -aG wireshark $USER, and log in again; elsewhere run this as a user"
        " who may\n",
    )


def test_calls_that_are_wrong() -> None:
    assert refused()[0] == 2
    status, complaint = refused("-i", LOOPBACK, "--filter", "op==")
    assert status == 2
    assert "the filter ends early: expected a value" in complaint
