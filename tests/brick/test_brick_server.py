"""The virtual brick on loopback: carriers, clients that behave badly, and what its user sees."""

from __future__ import annotations

import contextlib
import json
import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time
from dataclasses import replace
from pathlib import Path
from random import Random
from types import SimpleNamespace

import pytest
import serial
from support.cli import run_ev3proto_text
from support.effort import effort
from support.server import ACCEPT, UNLOCK, Client, beacon_port, command, frame, served, system, until, upload

import ev3proto
from ev3proto.brick import limits
from ev3proto.brick.declared import DeclarationError
from ev3proto.brick.servers.host import Faults, ServerError
from ev3proto.brick.servers.page.watcher import Watcher
from ev3proto.brick.servers.script import Script, read_script
from ev3proto.brick.servers.server import Options
from ev3proto.capture import Record, read
from ev3proto.schema.discovery import Beacon
from ev3proto.text.spans import plain_text

PLAIN = Options(port=0, beacon=False)
# INPUT_READ of port 1 in its mode, to GV0.
READ = bytes.fromhex("0b00 0700 00 0100 9a 00 00 00 00 60".replace(" ", ""))
# INFO GET_VOLUME to GV0; a new brick answers 100.
VOLUME = command("DATA8 volume\nINFO(GET_VOLUME, volume)")
HUNDRED = bytes.fromhex("0400 0100 02 64".replace(" ", ""))
# JR to itself.
ENDLESS = bytes.fromhex("0700 0300 00 0000 40 3e".replace(" ", ""))


def test_first_line_says_where_it_listens(tmp_path: Path) -> None:
    process = subprocess.Popen(
        [sys.executable, "-m", "ev3proto", "brick", "--port", "0", "--no-beacon", "--root", tmp_path, "--report"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None
    line = process.stdout.readline()
    assert line.startswith("listening on 127.0.0.1:")
    with Client(int(line.rpartition(":")[2])) as client:
        assert client.ask(VOLUME) == HUNDRED
        # SOUND TONE with a frequency that the loudspeaker cannot play.
        client.send(bytes.fromhex("0e002a0080000094010182c80082e803"))
        assert client.ask(VOLUME) == HUNDRED
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=30)
    # The frequency is a warning, and no error.
    assert process.returncode == 0
    assert "3 frames from clients" in out
    assert "W303" in out
    assert "this brick differs from a real one in " in err
    assert "Traceback" not in err
    assert {entry.name for entry in tmp_path.iterdir()} == {"apps", "prjs", "sys", "tools"}


def test_unlock_text_comes_first(tmp_path: Path) -> None:
    with served(tmp_path) as brick, Client(brick.port, unlocks=False) as client:
        client.send(b"hello\r\n")
        assert client.is_silent()
        client.send(UNLOCK)
        assert client.read(16) == ACCEPT
        assert client.ask(VOLUME) == HUNDRED


def test_frames_in_the_segment_of_the_unlock_text_are_lost(tmp_path: Path) -> None:
    with served(tmp_path) as brick, Client(brick.port, unlocks=False) as client:
        client.send(UNLOCK + VOLUME)
        assert client.read(16) == ACCEPT
        assert client.is_silent()
        assert client.ask(VOLUME) == HUNDRED
        assert "is lost with it" in brick.said[0]


def test_frames_may_be_cut_and_share_segments(tmp_path: Path) -> None:
    with served(tmp_path) as brick, Client(brick.port) as client:
        for byte in VOLUME:
            client.send(bytes((byte,)))
        assert client.reply() == HUNDRED
        client.send(VOLUME * 20)
        assert [client.reply() for _ in range(20)] == [HUNDRED] * 20


def test_one_client_at_a_time(tmp_path: Path) -> None:
    with served(tmp_path) as brick, Client(brick.port) as first, Client(brick.port, unlocks=False) as second:
        second.send(UNLOCK)
        assert second.is_silent()
        assert first.ask(VOLUME) == HUNDRED
        first.socket.close()
        assert second.read(16) == ACCEPT
        assert second.ask(VOLUME) == HUNDRED
        assert "--clients" in brick.said[0]


def test_a_silent_client_keeps_no_other_waiting(tmp_path: Path) -> None:
    with served(tmp_path) as brick, contextlib.ExitStack() as stack:
        silent = [stack.enter_context(Client(brick.port, unlocks=False)) for _ in range(70)]
        silent[-1].send(b"GET /")
        with Client(brick.port) as client:
            assert client.ask(VOLUME) == HUNDRED
        silent[-1].send(UNLOCK[5:])
        assert silent[-1].read(16) == ACCEPT
        assert silent[-1].ask(VOLUME) == HUNDRED


def test_beacon(tmp_path: Path) -> None:
    with beacon_port(), socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as listener:
        listener.bind(("127.0.0.1", 3015))
        listener.settimeout(30)
        with served(tmp_path, Options(port=0)) as brick:
            source = 0
            while source != brick.port:
                # Other bricks on this computer have beacons, too.
                datagram, (_, source) = listener.recvfrom(1024)
            assert Beacon.parse(datagram) == Beacon("0016530f0c1e", str(brick.port), "EV3", "EV3")


def test_the_port_of_beacons_is_reserved_among_all_users(monkeypatch: pytest.MonkeyPatch) -> None:
    """The tests of a second user wait for those of the first one, and then get it."""
    first = os.geteuid()
    with beacon_port(), monkeypatch.context() as impatient:
        impatient.setattr("support.server.MOST_WAITING", 0)
        if first == 0:
            os.seteuid(65_534)
        try:
            with pytest.raises(AssertionError, match="another test run keeps the beacon's port"), beacon_port():
                pass
        finally:
            os.seteuid(first)
    with beacon_port():
        pass


# Bad clients


def test_commands_of_a_disconnected_client_are_executed(tmp_path: Path) -> None:
    """The last command waits 300 ms and turns the light orange, long after the client closed its socket."""
    red = command("UI_WRITE(LED, LED_RED)")
    later = command("DATA32 timer\nTIMER_WAIT(300, timer)\nTIMER_READY(timer)\nUI_WRITE(LED, LED_ORANGE)")
    with served(tmp_path) as brick:
        with Client(brick.port) as client:
            client.send(red + later + command("UI_WRITE(LED, LED_RED_FLASH)"))
        until(lambda: brick.now.brick.leds == 5)
        assert brick.said == []


def test_an_endless_command_of_a_client_that_has_gone_is_ended(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ev3proto.brick.brick.MOST_SECONDS", 1)
    with served(tmp_path) as brick:
        with Client(brick.port) as client:
            # What it left to do after that is not done.
            client.send(command("OBJECT_WAIT(1)") + command("UI_WRITE(LED, LED_RED)"))
        with Client(brick.port) as client:
            assert client.ask(VOLUME) == HUNDRED
        assert brick.now.brick.leds == 1
        assert re.fullmatch(
            r"127\.0\.0\.1:\d+: an endless command was ended; a real brick stops answering", brick.said[0]
        )


def test_a_client_out_of_step_is_named(tmp_path: Path) -> None:
    """A program that sends text instead of frames waits for ever; so does the brick, which says why."""
    with served(tmp_path) as brick, Client(brick.port) as client:
        client.send(VOLUME + b"\0\0" + VOLUME)
        assert [client.reply(), client.reply()] == [HUNDRED, HUNDRED]
        client.send(b"Protocol: EV3\r\n")
        until(lambda: len(brick.said) == 1)
    assert ": this is the text 'Protocol: EV3', not a frame; " in brick.said[0]


def test_an_incomplete_frame_is_reported_and_recorded(tmp_path: Path) -> None:
    """A client whose lengths are too large by one."""
    unfinished = bytes.fromhex("1100000001920a0000002f6e6f6e652f7800")
    path = tmp_path / "talk.pcapng"
    with served(tmp_path / "root", replace(PLAIN, record=path)) as brick:
        with Client(brick.port) as client:
            assert client.ask(VOLUME) == HUNDRED
            client.send(unfinished)
        until(lambda: bool(brick.said))
    assert brick.said[0].endswith(": the connection ended inside a frame: 18 of its 19 bytes came")
    assert unfinished in path.read_bytes()


def test_frames_that_were_not_served_are_counted(tmp_path: Path) -> None:
    """The brick is switched off while a client's command keeps its other frames waiting."""
    wait = command("DATA32 t\nTIMER_WAIT(60000, t)\nTIMER_READY(t)")
    with served(tmp_path) as brick, Client(brick.port) as client:
        client.send(wait + VOLUME * 20 + b"\0\0" + VOLUME[:4])
        until(lambda: brick.now.brick.is_busy and len(brick.now.host.connections[0].left) == 20 * len(VOLUME) + 6)
    assert [said.partition(": ")[2] for said in brick.said] == [
        "the connection ended before 20 frames of it were served"
    ]


def test_silent_clients_keep_no_other_out(tmp_path: Path) -> None:
    with served(tmp_path) as brick, contextlib.ExitStack() as stack:
        for _ in range(80):
            stack.enter_context(socket.create_connection(("127.0.0.1", brick.port), 2))
        with Client(brick.port) as client:
            assert client.ask(VOLUME) == HUNDRED
    assert brick.said == ["127.0.0.1 did not send the unlock text of a WiFi brick; disconnected"]


def test_a_recording_has_what_was_on_the_wire_and_nothing_else(tmp_path: Path) -> None:
    """No beacon and no serial number: the client's address and its unlock text, here with an invented number."""
    path, text = tmp_path / "talk.pcapng", b"GET /target?sn=12:34VMTP1.0\nProtocol: EV3\n"
    with served(tmp_path / "root", replace(PLAIN, record=path)) as brick:
        with Client(brick.port, unlocks=False) as client:
            client.send(text)
            assert client.read(16) == ACCEPT
            assert client.ask(VOLUME) == HUNDRED
            port = client.socket.getsockname()[1]
        until(lambda: not brick.now.host.connections)
    recorded = path.read_bytes()
    assert b"Serial-Number" not in recorded
    assert recorded.count(text) == 1
    (command_, reply) = (event for event in read(path) if isinstance(event, Record))
    assert (command_.frame, reply.frame) == (VOLUME, HUNDRED)
    assert (command_.route.source, command_.route.target) == (f"127.0.0.1:{port}", f"127.0.0.1:{brick.port}")


def test_downloads_longer_than_a_frame_are_taken_recorded_and_put_together(tmp_path: Path) -> None:
    root, path, contents = tmp_path / "root", tmp_path / "talk.pcapng", bytes(range(256)) * 5
    with served(root, replace(PLAIN, record=path, report=True)) as brick:
        with Client(brick.port) as client:
            begin = client.ask(system(0x92, len(contents).to_bytes(4, "little") + b"../prjs/a/a.rbf\0" + contents[:3]))
            assert begin[4:] == bytes((0x03, 0x92, 0x00, 0x00))
            client.send(bytes(4))
            assert client.ask(system(0x93, b"\0" + contents[3:]))[4:] == bytes((0x03, 0x93, 0x08, 0x00))
            whole = client.ask(bytes.fromhex("1d0001000192050000002e2e2f70726a732f712f612e7478740068656c6c6f"))
            assert whole[4:] == bytes((0x03, 0x92, 0x08, 0x00))
        until(lambda: not brick.now.host.connections)
    assert (root / "prjs/a/a.rbf").read_bytes() == contents
    assert (root / "prjs/q/a.txt").read_bytes() == b"hello"
    found = run_ev3proto_text("files", str(path), "-o", str(tmp_path / "out"))
    assert found.returncode == 0
    assert (tmp_path / "out/prjs/a/a.rbf").read_bytes() == contents
    assert (tmp_path / "out/prjs/q/a.txt").read_bytes() == b"hello"
    assert run_ev3proto_text("check", str(path)).returncode == 0


def test_garbage_and_frames_without_meaning(tmp_path: Path) -> None:
    with served(tmp_path) as brick:
        with Client(brick.port) as client:
            # Lengths of 0, 1 and 2, an unknown type, a reply, a command without operations.
            client.send(b"\0\0" + b"\1\0x" + b"\2\0xy" + frame(1, 0x77, b"??") + HUNDRED)
            assert client.ask(frame(5, 0x00, b"\0\0")) == bytes.fromhex("0300050004")
            assert client.ask(VOLUME) == HUNDRED
        with Client(brick.port) as client:
            client.send(Random(1).randbytes(300_000))
        with Client(brick.port) as client:
            assert client.ask(VOLUME) == HUNDRED


def test_garbage_is_recorded_checked_and_watched(tmp_path: Path) -> None:
    chance = Random(3)
    kinds = [*range(6), 0x80, 0x81]
    options = replace(PLAIN, record=tmp_path / "x.pcapng", report=True, page=0)
    with served(tmp_path / "root", options) as brick, Client(brick.port) as client:
        for _ in range(300):
            client.send(frame(chance.randrange(65536), chance.choice(kinds), chance.randbytes(chance.randrange(60))))
        client.send(frame(1, 0x00, b"\x01\0" + bytes(3000)) + VOLUME)
        while client.reply()[2:] != HUNDRED[2:]:
            pass
        assert brick.now.reporter is not None
        assert brick.now.reporter.frames == 302
        assert len(list(brick.now.reporter.lines())) > 10
        # The brick reported no bug.
        assert [said for said in brick.said if "please report" in said] == []


def test_a_frame_that_is_sent_twice_is_watched_twice() -> None:
    """The playground sends it again while the first one is under way."""
    watcher, page = Watcher(time.monotonic), SimpleNamespace(number=1, name="page")
    silent, unknown = frame(1, 0x80, b"\0\0\x01"), frame(1, 0x77, b"")
    for sent in (VOLUME, VOLUME, silent, unknown):
        watcher.frame(page, sent, True)
    for _ in range(2):
        watcher.frame(page, HUNDRED, False)
    talks = watcher.open().take(9)
    assert [(talk.command, talk.reply) for talk in talks] == [
        (VOLUME, HUNDRED),
        (VOLUME, HUNDRED),
        (silent, None),
        (unknown, None),
    ]


def test_a_frame_that_never_ends(tmp_path: Path) -> None:
    with (
        served(tmp_path, replace(PLAIN, clients=2)) as brick,
        Client(brick.port) as endless,
        Client(brick.port) as other,
    ):
        endless.send(b"\xff\xff" + bytes(40_000))
        assert other.ask(VOLUME) == HUNDRED
        assert len(brick.now.host.connections) == 2


def test_a_client_that_does_not_read_waits_and_the_others_do_not(tmp_path: Path) -> None:
    # Each answer has 1,000 bytes; the first client does not read its answers.
    large = frame(1, 0x00, b"\xe8\x03\x01")
    with served(tmp_path, replace(PLAIN, clients=2)) as brick, Client(brick.port) as slow, Client(brick.port) as other:
        slow.socket.settimeout(0.5)
        sent = 0
        with contextlib.suppress(TimeoutError):
            while sent < 100_000_000:
                sent += slow.socket.send(large * 1000)
        assert sent < 100_000_000
        assert other.ask(VOLUME) == HUNDRED
        held = brick.now.host.connections[0]
        assert len(held._incoming) < limits.MOST_BUFFERED * 4
        # When it reads, everything comes.
        slow.socket.settimeout(30)
        assert [slow.reply()[:5] for _ in range(500)] == [bytes.fromhex("eb03010002")] * 500


def test_endless_commands_do_not_keep_others_out(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    waiting = command("local DATA32 timer\nTIMER_WAIT(100000, timer)\nTIMER_READY(timer)")
    ended = "its command was ended after {}, because another client waits"
    with served(tmp_path, replace(PLAIN, clients=2)) as brick, Client(brick.port) as bad, Client(brick.port) as good:
        for endless, time_limit in ((ENDLESS, "0.25 s of CPU time"), (waiting, "0.3 s")):
            bad.send(endless)
            until(lambda: brick.now.brick.is_busy)
            assert good.ask(VOLUME) == HUNDRED
            assert bad.reply()[4] == 0x04
            assert brick.said[-1].endswith(ended.format(time_limit))
            monkeypatch.setattr("ev3proto.brick.servers.host.PATIENCE", 0.3)


def test_a_client_that_connects_for_each_command_is_not_ahead_of_others(tmp_path: Path) -> None:
    """The frame that has waited longest is next, not the newest client."""
    slow = command("DATA32 timer\nTIMER_WAIT(50, timer)\nTIMER_READY(timer)")
    done = 0

    def connect_again(port: int) -> None:
        nonlocal done
        while not is_over.is_set():
            with Client(port) as client:
                client.ask(slow)
                done += 1

    is_over = threading.Event()
    with served(tmp_path, replace(PLAIN, clients=9)) as brick, Client(brick.port) as honest:
        threads = [threading.Thread(target=connect_again, args=(brick.port,)) for _ in range(4)]
        for thread in threads:
            thread.start()
        until(lambda: done > 4)
        waited = []
        for _ in range(8):
            before = done
            assert honest.ask(VOLUME) == HUNDRED
            waited.append(done - before)
        is_over.set()
        for thread in threads:
            thread.join(30)
        # One command of each, and what was counted late.
        assert max(waited) <= 8


def test_an_endless_command_ends_with_its_connection(tmp_path: Path) -> None:
    with served(tmp_path) as brick:
        with Client(brick.port) as client:
            client.send(ENDLESS)
        with Client(brick.port) as client:
            assert client.ask(VOLUME) == HUNDRED


def test_a_command_that_switches_a_brick_off(tmp_path: Path) -> None:
    with served(tmp_path) as brick, Client(brick.port) as client:
        client.send(command("PROGRAM_STOP(0)"))
        until(lambda: bool(brick.said))
        assert client.ask(VOLUME) == HUNDRED
        assert "PROGRAM_STOP 0" in brick.said[0]


# Files


def test_a_file_larger_than_the_limit_and_a_full_folder(tmp_path: Path) -> None:
    with served(tmp_path) as brick, Client(brick.port) as client:
        reply = client.ask(system(0x92, (6_200_000).to_bytes(4, "little") + b"big.bin\0"))
        assert reply[4:] == bytes.fromhex("05 92 09 ff".replace(" ", ""))
        assert not (tmp_path / "sys" / "big.bin").exists()
        (tmp_path / "prjs" / "x.bin").write_bytes(bytes(100))
    with served(tmp_path) as brick, Client(brick.port) as client:
        # A download has to leave 300 KB free, and there is a file of 100 bytes.
        brick.now.brick.equipment.files.quota = 300 * 1024 + 150
        assert upload(client, b"y.bin", bytes(100)) == 9
        assert upload(client, b"z.bin", bytes(40)) == 8


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
def test_a_full_disk_ends_the_recording_only(tmp_path: Path) -> None:
    options = replace(PLAIN, record=Path("/dev/full"))
    with served(tmp_path, options) as brick, Client(brick.port) as client:
        assert client.ask(VOLUME) == HUNDRED
        assert "nothing more is recorded: No space left" in brick.said[0]


def test_nothing_outside_the_folder(tmp_path: Path) -> None:
    root, secret = tmp_path / "root", tmp_path / "secret.txt"
    root.mkdir()
    secret.write_text("do not tell")
    (root / "link").symlink_to(tmp_path)
    (root / "file").symlink_to(secret)
    os.mkfifo(root / "pipe")
    paths = (
        b"/etc/passwd",
        b"../../../../etc/passwd",
        b"../../secret.txt",
        b"../link/secret.txt",
        b"../file",
        b"../pipe",
        str(secret).encode(),
        b"/home/root/lms2012/link/secret.txt",
    )
    with served(root) as brick, Client(brick.port) as client:
        for path in paths:
            reply = client.ask(system(0x94, b"\xe8\x03" + path + b"\0"))
            assert reply[4] == 0x05, path
            assert b"do not tell" not in reply
            client.ask(system(0x92, b"\4\0\0\0" + path + b"\0data"))
            client.ask(system(0x9C, path + b"\0"))
        assert client.ask(system(0x99, b"\xe8\x03../link/\0"))[4] == 0x05
    assert secret.read_text() == "do not tell"


# Reports


def reported(tmp_path: Path, sent: list[bytes], *words: str) -> subprocess.CompletedProcess[str]:
    """Returns the output of `ev3proto brick --report` for some frames, and for one that asks for the volume."""
    call = [sys.executable, "-m", "ev3proto", "brick", "--port", "0", "--no-beacon", "--quiet", "--report", *words]
    process = subprocess.Popen(
        [*call, "--root", tmp_path / "root"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    line = process.stdout.readline()
    with Client(int(line.rpartition(":")[2])) as client:
        client.send(b"".join(sent) + VOLUME)
        while client.reply() != HUNDRED:
            pass
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=30)
    return subprocess.CompletedProcess(call, process.returncode, out, err)


REFUSED = bytes.fromhex("08000100800500810161")
TOO_LOW = bytes.fromhex("0e002a0080000094010182c80082e803")


def test_a_report_with_errors_ends_with_1(tmp_path: Path) -> None:
    """Each kind of finding once, with its count and the first place."""
    done = reported(tmp_path, [REFUSED, TOO_LOW, REFUSED, TOO_LOW, TOO_LOW])
    assert done.returncode == 1
    assert "6 frames from clients, 3 distinct findings" in done.stdout
    assert done.stdout.count("error[E205]") == 1
    assert done.stdout.count("warning[W303]") == 1
    assert re.search(r"127\.0\.0\.1:\d+, frame 1, \d\.\d{3} s: the brick refuses it", done.stdout)
    assert "= E205 in 2 frames" in done.stdout
    assert "= W303 in 3 frames" in done.stdout


def test_a_report_for_other_tools(tmp_path: Path) -> None:
    done = reported(tmp_path, [REFUSED, TOO_LOW], "--json", "--errors-only", "--record", str(tmp_path / "t.pcapng"))
    (entry,) = map(json.loads, done.stdout.splitlines())
    assert (done.returncode, entry["code"], entry["frames"], entry["frame"]) == (1, "E205", 1, 1)
    assert bytes.fromhex(entry["hex"]) == REFUSED
    # The first packets of the recording open the connection.
    assert entry["packet"] > 1


@pytest.mark.parametrize(("shows", "codes"), [(True, set()), (False, {"W702"})])
def test_what_is_drawn_may_be_shown_by_a_later_frame(tmp_path: Path, shows: bool, codes: set[str]) -> None:
    drawn = [command("UI_DRAW(FILLCIRCLE, FG_COLOR, 89, 64, 40)")]
    if shows:
        drawn.append(command("UI_DRAW(UPDATE)"))
    done = reported(tmp_path, drawn, "--json")
    assert {json.loads(line)["code"] for line in done.stdout.splitlines()} & {"W702"} == codes


def test_the_serial_number_is_that_of_the_beacon(tmp_path: Path) -> None:
    with served(tmp_path, replace(PLAIN, serial_number="00165340abcd")) as brick:
        assert brick.now.brick.equipment.settings.bluetooth_address == "00165340abcd"
    done = run_ev3proto_text("brick", "--serial-number", "xyz")
    assert done.returncode == 2
    assert "invalid serial number 'xyz'; expected 12 hexadecimal digits" in done.stderr


def test_the_folders_of_a_new_brick(tmp_path: Path) -> None:
    with served(tmp_path):
        assert (tmp_path / "prjs" / "BrkProg_SAVE").is_dir()
        assert (tmp_path / "apps" / "Port View").is_dir()


# Several clients


def test_fifty_clients_get_their_own_replies(tmp_path: Path) -> None:
    with served(tmp_path, replace(PLAIN, clients=50)) as brick:
        clients = [Client(brick.port) for _ in range(50)]
        for turn in range(10):
            for number, client in enumerate(clients):
                client.send(command(f"DATA8 value\nMOVE8_8({number}, value)", turn * 50 + number))
            for number, client in enumerate(clients):
                counter = (turn * 50 + number).to_bytes(2, "little")
                assert client.reply() == b"\4\0" + counter + b"\2" + bytes((number,))
        for client in clients:
            client.socket.close()


# Faults on purpose


def test_replies_come_late(tmp_path: Path) -> None:
    with served(tmp_path, replace(PLAIN, faults=Faults(delay=0.5))) as brick, Client(brick.port) as client:
        begin = time.monotonic()
        client.send(VOLUME * 50)
        assert [client.reply() for _ in range(50)] == [HUNDRED] * 50
        # All are late by the same time; the delays do not add up, which would be 25 s.
        assert 0.5 <= time.monotonic() - begin < 20


def test_replies_are_lost_or_changed(tmp_path: Path) -> None:
    options = replace(PLAIN, faults=Faults(drop=0.5, corrupt=0.5, random=Random(1)))
    frames = [command("DATA8 volume\nINFO(GET_VOLUME, volume)", counter) for counter in range(200)]
    with served(tmp_path, options) as brick, Client(brick.port) as client:
        client.send(b"".join(frames))
        replies = [client.reply() for _ in range(71)]
        client.socket.settimeout(0.5)
        with contextlib.suppress(TimeoutError):
            while True:
                replies.append(client.reply())
    assert len(replies) < 130
    assert all(len(reply) == 6 for reply in replies)
    assert 20 < sum(reply[4:] != HUNDRED[4:] for reply in replies) < 70


# The serial port


def test_serial_port(tmp_path: Path) -> None:
    link = tmp_path / "ev3"
    with served(tmp_path / "root", replace(PLAIN, port=None, serial=link)) as brick:
        with serial.Serial(str(link), timeout=30) as port:
            port.write(VOLUME * 2)
            assert port.read(12) == HUNDRED * 2
            port.write(VOLUME[:4])
        # A program that opens it later does not continue the frame of the one before.
        until(lambda: not brick.now.host.connections)
        with serial.Serial(str(link), timeout=30) as port:
            port.write(VOLUME)
            assert port.read(6) == HUNDRED
    assert not link.is_symlink()


def test_serial_port_overwrites_nothing(tmp_path: Path) -> None:
    link = tmp_path / "ev3"
    link.write_text("mine")
    with (
        pytest.raises(ServerError, match="already exists; give another name"),
        served(tmp_path, replace(PLAIN, serial=link)),
    ):
        pass
    assert link.read_text() == "mine"


def test_serial_port_removes_only_its_own_link(tmp_path: Path) -> None:
    link = tmp_path / "ev3"
    with served(tmp_path / "root", replace(PLAIN, serial=link)):
        link.unlink()
        link.write_text("mine")
    assert link.read_text() == "mine"


# What is written


def test_recorded_traffic_is_read_back(tmp_path: Path) -> None:
    capture = tmp_path / "talk.pcapng"
    options = replace(PLAIN, clients=2, record=capture)
    with served(tmp_path / "root", options) as brick, Client(brick.port) as first, Client(brick.port) as second:
        assert first.ask(VOLUME) == HUNDRED
        assert second.ask(READ)[:4] == bytes.fromhex("04000700")
    done = run_ev3proto_text("decode", capture)
    assert "INFO.GET_VOLUME" in done.stdout
    assert "VALUE = 100" in done.stdout
    assert "INPUT_READ" in done.stdout
    assert done.stderr == ""


def test_screenshot(tmp_path: Path) -> None:
    picture = tmp_path / "display.png"
    with served(tmp_path / "root", replace(PLAIN, screenshot=picture)) as brick, Client(brick.port) as client:
        client.ask(command("UI_DRAW(FILLRECT, 1, 0, 0, 60, 40)\nUI_DRAW(UPDATE)"))
    assert picture.read_bytes().startswith(b"\x89PNG")


# Scripts


SCRIPT = """
name = "Robby"
voltage = 8.1
[ports.1]
type = "TYPE_TOUCH"
readings.0 = [500]
[ports.B]
type = 7
[[steps]]
at = 0.1
ports.1.0 = 4000
press = "enter"
"""


def test_script(tmp_path: Path) -> None:
    path = tmp_path / "robot.toml"
    path.write_text(SCRIPT)
    with served(tmp_path / "root", replace(PLAIN, script=read_script(path))) as brick, Client(brick.port) as client:
        read = command("DATA8 touch\nDATA8 enter\nINPUT_READ(0, 0, TYPE_TOUCH, 0, touch)\nUI_BUTTON(PRESSED, 2, enter)")
        until(lambda: client.ask(read)[5:] == bytes((100, 1)))
        name = client.ask(command("DATA8 name 10\nCOM_GET(GET_BRICKNAME, 10, name)"))
        assert name[5:].rstrip(b"\0") == b"Robby"


def first_words(tmp_path: Path, *words: str) -> tuple[str, list[str], bytes]:
    """Returns the first line of `ev3proto brick`, its messages, and the types of the devices on all ports."""
    call = [sys.executable, "-m", "ev3proto", "brick", "--port", "0", "--no-beacon", *words]
    with subprocess.Popen(call, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=tmp_path) as brick:
        assert brick.stdout is not None
        listening = brick.stdout.readline()
        with Client(int(listening.rpartition(":")[2])) as client:
            types = client.ask(command("DATA8 types 20\nDATA8 changed\nINPUT_DEVICE_LIST(20, types, changed)"))[5:25]
        brick.send_signal(signal.SIGINT)
        return listening, brick.communicate(timeout=30)[1].splitlines(), types


EQUIPMENT = "plugged in: medium motor on A, large motors on B and C; sensors: touch on 1, gyro on 2, colour on 3,"
NOTHING = b"\x7e" * 4


def test_the_core_set_is_plugged_in(tmp_path: Path) -> None:
    listening, said, types = first_words(tmp_path)
    assert listening.startswith("listening on 127.0.0.1:")
    assert said[0] == f"{EQUIPMENT} ultrasonic on 4 (--bare: nothing)"
    # Touch, gyro, colour, ultrasonic; 12 ports of other bricks; medium motor, two large ones, nothing.
    assert types == bytes((16, 32, 29, 30)) + NOTHING * 3 + bytes((8, 7, 7, 126))


@pytest.mark.parametrize("words", [("--bare",), ("--script", "robot.toml")])
def test_something_else_replaces_the_core_set(tmp_path: Path, words: tuple[str, ...]) -> None:
    (tmp_path / "robot.toml").write_text("[ports.2]\ntype = 16\n")
    _, said, types = first_words(tmp_path, *words)
    assert not [line for line in said if "plugged in: " in line]
    assert types == (NOTHING if "--bare" in words else b"\x7e\x10\x7e\x7e") + NOTHING * 4


def test_a_script_without_ports_leaves_the_core_set(tmp_path: Path) -> None:
    (tmp_path / "robot.toml").write_text("name = 'Robby'\n")
    _, said, types = first_words(tmp_path, "--script", "robot.toml")
    assert said[0].startswith(EQUIPMENT)
    assert types[:4] == bytes((16, 32, 29, 30))


def test_a_device_that_is_plugged_in_replaces_the_core_set(tmp_path: Path) -> None:
    with served(tmp_path, replace(PLAIN, core_set=True)) as brick:
        # New readings, or another device that is unplugged, do not.
        brick.now.brick.plug(1, 16, {0: (4000,)})
        brick.now.brick.plug(2, 126)
        assert len(brick.now.brick.equipment.inputs.plugged()) == 6
        brick.now.brick.plug(2, 16)
        assert list(brick.now.brick.equipment.inputs.plugged()) == [2]


def test_a_command_that_waits_for_a_missing_motor(tmp_path: Path) -> None:
    waiting = command("OUTPUT_STEP_SPEED(0, D, 50, 0, 90, 0, 1)\nOUTPUT_READY(0, D)")
    with served(tmp_path, replace(PLAIN, core_set=True, report=True)) as brick:
        with Client(brick.port) as client:
            client.send(waiting)
            until(lambda: bool(brick.said))
        (said,) = brick.said
        assert said.endswith(": OUTPUT_READY waits for a motor on D, but none is plugged in there")
        assert brick.now.reporter is not None
        text = "\n".join(plain_text(line) for line in brick.now.reporter.lines())
        assert "frame 1" in text
        assert "OUTPUT_READY waits for a motor on D, but none is plugged in there" in text


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("name = 'x'\nvoltage 7", "invalid TOML: Expected '=' after a key in a key/value pair (at line 2, column 9)"),
        ("name = " + "[" * 2000, "invalid TOML: "),
        ("nmae = 'x'", "the script: unknown key 'nmae'; expected one of name, voltage"),
        ("[ports.5]\ntype = 16", "ports.5: unknown port"),
        ("[ports.1]\ntype = 'TYPE_TUOCH'", "unknown type 'TYPE_TUOCH': did you mean TYPE_TOUCH"),
        ("[ports.1]\ntype = 16\nreadings.7 = 1", "ports.1.readings.7: unknown mode; this type has modes 0 to 1"),
        ("[[steps]]\npress = 'enter'", "needs its time"),
        ("[[steps]]\nat = 1\nports.2.0 = 1", "nothing is plugged in there"),
        ("[[steps]]\nat = 1\npress = 'middle'", "unknown button 'middle'"),
        ("[[steps]]\nat = nan", "must be a number"),
        ("period = 1\n[[steps]]\nat = 2", "period must be 2 s at least"),
    ],
)
def test_script_that_says_something_impossible(tmp_path: Path, text: str, expected: str) -> None:
    path = tmp_path / "robot.toml"
    path.write_text(text)
    with pytest.raises(DeclarationError, match=re.escape(expected)):
        read_script(path)
    done = run_ev3proto_text("brick", "--script", path)
    assert done.returncode == 1
    assert expected in done.stderr


def test_a_script_that_is_not_text(tmp_path: Path) -> None:
    path = tmp_path / "robot.toml"
    path.write_bytes(b"name = 'x'\nname = '\xff'\n")
    done = run_ev3proto_text("brick", "--script", path)
    assert (done.returncode, done.stderr) == (
        1,
        f"{path}: invalid TOML: 'utf-8' codec can't decode byte 0xff in position 19: invalid start byte\n",
    )


def test_steps_begin_again(tmp_path: Path) -> None:
    path = tmp_path / "robot.toml"
    path.write_text("period = 3\n[[steps]]\nat = 1\npress = 'up'\n[[steps]]\nat = 2\nrelease = 'up'")
    times = read_script(path).times()
    assert [next(times)[0] for _ in range(5)] == [1, 2, 4, 5, 7]
    assert list(Script().times()) == []


# The call


def test_what_is_wrong_with_a_call(tmp_path: Path) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        done = run_ev3proto_text("brick", "--quiet", "--port", str(port))
    assert done.returncode == 1
    assert done.stderr.startswith(f"port {port} of 127.0.0.1 is in use")
    done = run_ev3proto_text("brick", "--no-wifi")
    assert done.returncode == 2
    done = run_ev3proto_text("brick", "--quiet", "--root", __file__)
    assert done.returncode == 2
    done = run_ev3proto_text("brick", "--quiet", "--port", "0", "--record", tmp_path / "no" / "x.pcapng")
    assert done.returncode == 1
    assert "cannot be written" in done.stderr


def test_coverage() -> None:
    done = run_ev3proto_text("brick", "--coverage")
    assert done.returncode == 0
    assert "operations are implemented" in done.stderr


def test_another_address_is_warned_of(tmp_path: Path) -> None:
    with served(tmp_path, replace(PLAIN, address="0.0.0.0")) as brick:
        assert "anyone who can reach 0.0.0.0" in brick.said[0]
    assert ev3proto.parse(VOLUME).build() == VOLUME


def test_memory_does_not_grow(tmp_path: Path) -> None:
    process = subprocess.Popen(
        [sys.executable, "-m", "ev3proto", "brick", "--quiet", "--port", "0", "--no-beacon", "--root", tmp_path],
        stdout=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None
    resident: list[int] = []
    try:
        with Client(int(process.stdout.readline().rpartition(":")[2])) as client:
            frames = [command("DATA8 volume\nINFO(GET_VOLUME, volume)", counter) for counter in range(50)]
            for _ in range(2):
                for _ in range(effort(2_500, 500_000) // len(frames)):
                    client.send(b"".join(frames))
                    for frame in frames:
                        assert client.reply()[2:4] == frame[2:4]
                resident.append(_resident(process.pid))
    finally:
        process.terminate()
        process.communicate()
    assert resident[1] < resident[0] + 1024


def _resident(number: int) -> int:
    """Returns the KB of memory of a process."""
    status = Path(f"/proc/{number}/status").read_text()
    return int(next(line.split()[1] for line in status.splitlines() if line.startswith("VmRSS")))
