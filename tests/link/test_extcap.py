"""`ev3proto extcap`: "EV3 proxy" among Wireshark's interfaces, and a capture with it by the real tshark."""

from __future__ import annotations

import os
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from support.cli import run_ev3proto_text as run
from support.server import Client, command, free_port
from support.stub_brick import HangUp, reply, stub_brick

from ev3proto.capture import Record, read
from ev3proto.cli import extcap

TONE = bytes.fromhex("0e002a0080000094010182b80182e803")
VOLUME = command("DATA8 volume\nINFO(GET_VOLUME, volume)")


def test_what_it_says_of_itself() -> None:
    assert run("extcap", "--extcap-interfaces", "--extcap-version=4.0").stdout.splitlines()[1:] == [
        "interface {value=ev3proxy}{display=EV3 proxy}"
    ]
    assert run("extcap", "--extcap-interface", "ev3proxy", "--extcap-dlts").stdout == (
        "dlt {number=1}{name=EN10MB}{display=Ethernet}\n"
    )
    options = run("extcap", "--extcap-interface", "ev3proxy", "--extcap-config").stdout.splitlines()
    assert [line.partition("{call=")[2].partition("}")[0] for line in options] == ["--target", "--port", "--read-only"]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ([], "give --extcap-interfaces, or --extcap-interface ev3proxy"),
        (["--extcap-interface", "eth0", "--extcap-dlts"], "--extcap-interface ev3proxy"),
        (["--extcap-interface", "ev3proxy", "--capture"], "--capture with --fifo PATH"),
    ],
)
def test_what_it_cannot_do(words: list[str], sentence: str) -> None:
    done = run("extcap", *words)
    assert done.returncode == 2
    assert sentence in done.stderr


def test_a_missing_brick_is_named(tmp_path: Path) -> None:
    words = ["--extcap-interface", "ev3proxy", "--capture", "--fifo", str(tmp_path / "pipe")]
    done = run("extcap", *words, "--target", "wifi:127.0.0.1:1", "--port", "0")
    assert done.returncode == 1
    assert "nothing is listening" in done.stderr


def test_a_refused_option_ends_the_capture_at_once(tmp_path: Path) -> None:
    """Wireshark waits until the FIFO is opened."""
    environment = {**os.environ, "HOME": str(tmp_path)}
    run("dissector", "install", env=environment)
    words = ["-i", "ev3proxy", "-o", "extcap.ev3proxy.port:70000", "-a", "packets:1"]
    done = subprocess.run(["tshark", *words], env=environment, capture_output=True, text=True, timeout=60)
    assert "Error: Invalid value for '--port'" in done.stderr


def test_a_failing_library_is_not_blamed_on_the_capture(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(_target: object) -> None:
        raise PermissionError(13, "Permission denied", "/locked/libusb.so")

    monkeypatch.setattr(extcap, "open_wire", fail)
    words = ["--extcap-interface", "ev3proxy", "--capture", "--fifo", str(tmp_path / "pipe")]
    done = run("extcap", *words, "--target", "usb")
    assert done.returncode == 1
    assert done.stderr == "cannot connect to usb: [Errno 13] Permission denied: '/locked/libusb.so'\n"


def connected(port: int) -> Client:
    """A client of the proxy, as soon as that listens."""
    end = time.monotonic() + 60
    while True:
        try:
            return Client(port)
        except OSError:
            assert time.monotonic() < end
            time.sleep(0.1)


def test_tshark_captures_through_the_proxy(tmp_path: Path) -> None:
    """By the launcher that `ev3proto dissector install` writes."""
    environment = {**os.environ, "HOME": str(tmp_path)}
    installed = run("dissector", "install", env=environment)
    assert "/extcap/ev3proxy: written\n" in installed.stdout
    port = free_port()
    settings = [f"extcap.ev3proxy.{name}:{value}" for name, value in (("target", "virtual"), ("port", port))]
    path = tmp_path / "talk.pcapng"
    words = ["-i", "ev3proxy", *(word for setting in settings for word in ("-o", setting)), "-w", str(path), "-q"]
    tshark = subprocess.Popen(["tshark", *words], env=environment, stderr=subprocess.PIPE, text=True)
    try:
        with connected(port) as client:
            client.send(TONE)
            assert client.ask(VOLUME) == bytes.fromhex("040001000264")
        end = time.monotonic() + 30
        while not path.exists() or TONE not in path.read_bytes():
            assert time.monotonic() < end
            time.sleep(0.1)
    finally:
        tshark.terminate()
        _, said = tshark.communicate(timeout=30)
    first = next(event for event in read(path) if isinstance(event, Record))
    assert first.message.build() == TONE, said


def test_the_capture_goes_on_when_the_brick_vanishes(tmp_path: Path) -> None:
    """It shows the brick's end, and listens again at the same port when the brick is back."""
    environment = {**os.environ, "HOME": str(tmp_path)}
    run("dissector", "install", env=environment)
    path = tmp_path / "talk.pcapng"

    def answer(frame: bytes, send: Callable[[bytes], None]) -> None:
        if frame == TONE:
            raise HangUp
        send(reply(frame, b"\x64"))

    with stub_brick(answer) as brick:
        port = free_port()
        settings = [f"extcap.ev3proxy.target:wifi:127.0.0.1:{brick}", "-o", f"extcap.ev3proxy.port:{port}"]
        words = ["-i", "ev3proxy", "-o", *settings, "-w", str(path), "-q"]
        tshark = subprocess.Popen(["tshark", *words], env=environment, stderr=subprocess.PIPE, text=True)
        try:
            with connected(port) as client:
                client.send(TONE)
                with pytest.raises(ConnectionError):
                    client.reply()
            with connected(port) as client:
                assert client.ask(VOLUME) == bytes.fromhex("040001000264")
            end = time.monotonic() + 30
            while VOLUME not in path.read_bytes():
                assert time.monotonic() < end
                time.sleep(0.1)
        finally:
            tshark.terminate()
            _, said = tshark.communicate(timeout=30)
    words = ["-r", str(path), "-Y", "tcp.flags.fin == 1 || tcp.len > 0", "-T", "fields"]
    words += [word for name in ("tcp.stream", "tcp.flags.fin", "tcp.payload") for word in ("-e", name)]
    listed = subprocess.run(["tshark", *words], capture_output=True, text=True, check=True).stdout
    # Wireshark 4.4 writes truth values as words.
    shown = listed.replace("False", "0").replace("True", "1").splitlines()
    sent = shown.index(f"0\t0\t{TONE.hex()}")
    assert shown[sent + 1].startswith("0\t1"), said
    assert f"1\t0\t{VOLUME.hex()}" in shown[sent + 2 :], said
    assert "waiting for the brick, then listening again" in said
