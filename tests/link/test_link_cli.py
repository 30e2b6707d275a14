"""`ev3proto send`, `replay` and `proxy`, against virtual bricks."""

from __future__ import annotations

import contextlib
import io
import json
import os
import pty
import re
import signal
import socket
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from random import Random

import dpkt
import pytest
from dpkt.ethernet import Ethernet
from support.cli import ROOT, run_ev3proto_text
from support.relays import Relay, relay
from support.server import ACCEPT, UNLOCK, Client, Served, command, frame, free_port, served, system, until, upload
from support.stub_brick import reply, stub_brick

import ev3proto
from ev3proto import EV3, GV, direct_command, operation
from ev3proto.brick.servers.host import Faults
from ev3proto.brick.servers.server import Options
from ev3proto.capture import Record, read
from ev3proto.generate.captures import write_pcapng
from ev3proto.generate.captures.recording import Recording
from ev3proto.link.carriers import open_wire
from ev3proto.link.errors import ConnectionLostError, PortInUseError
from ev3proto.link.serial_number import announced_number
from ev3proto.link.targets import Target
from ev3proto.tables.carriers import Carrier
from ev3proto.tables.system import SystemStatus

WIFI_CAPTURE = ROOT / "captures" / "wifi.pcapng"
CONFORMANCE = ROOT / "captures" / "conformance.pcapng"
LED = bytes.fromhex("0800 0200 80 0000 82 1B 02")


def without_times(text: str) -> list[str]:
    return [re.sub(r"^ +[\d.]+ +(#\d+) |  [\d.]+ ms$", r"\1 ", line).strip() for line in text.splitlines()]


# send


def test_send_shows_the_dialogue() -> None:
    done = run_ev3proto_text("send", "virtual", "UI_READ(GET_FW_VERS, 16, GV0(0))")
    assert done.returncode == 0
    assert without_times(done.stdout) == [
        '#1 UI_READ.GET_FW_VERS(LENGTH=16, DESTINATION=GV(0)) -> DESTINATION="V1.04H"'
    ]


def test_send_takes_frames_in_any_form_and_passes_replies_over(tmp_path: Path) -> None:
    log = tmp_path / "robot.log"
    log.write_text("09:12:31.011558 Sent 0x|08:00|2A:00|00|01:00|7C:04:60|\n09:12:31.02 Recv 0x|04:00|2A:00|02|64|\n")
    done = run_ev3proto_text("send", "virtual", "--json", log)
    assert done.returncode == 0
    entry = json.loads(done.stdout)
    assert entry["command"]["hex"] == "08002a000001007c0460"
    assert entry["reply"]["values"][0]["value"] == 100
    assert done.stderr == "skipped 1 frame from a brick\n"


def test_send_sends_nothing_that_the_brick_would_refuse() -> None:
    frame = "0x|06:00|2A:00|00|00:00|F0|"
    done = run_ev3proto_text("send", "virtual", frame)
    assert (done.returncode, done.stdout) == (1, "")
    assert "0xF0" in done.stderr
    assert done.stderr.endswith("nothing was sent; --force sends it anyway\n")
    forced = run_ev3proto_text("send", "virtual", "--force", frame)
    assert forced.returncode == 1
    assert "-> error" in forced.stdout


def test_send_shows_errors_in_what_the_brick_takes_and_sends_it() -> None:
    done = run_ev3proto_text("send", "virtual", "0x|09:00|2A:00|00|01:00|3A:81:05:64:|")
    assert "1 error" in done.stderr
    assert "did you mean: 8 bytes of global and 0 bytes of local memory are used" in done.stderr
    assert done.stdout != ""
    assert "nothing was sent" not in done.stderr


SPEED = "OUTPUT_SPEED(0, A, 50)"


def test_send_says_why_a_single_frame_turns_no_motor() -> None:
    done = run_ev3proto_text("send", "virtual", SPEED)
    assert done.returncode == 0
    assert done.stderr.splitlines()[:3] == [
        "frame 1: the brick accepts it; 1 hint",
        "",
        "hint[H701]: OUTPUT_SPEED starts no motor: it sets what OUTPUT_START starts them with",
    ]
    assert "OUTPUT_SPEED(LAYER=0, NOS=1, SPEED=50)" in done.stdout


def test_send_gives_no_such_hint_where_another_frame_starts_the_motor() -> None:
    done = run_ev3proto_text("send", "virtual", SPEED, "OUTPUT_START(0, A)")
    assert (done.returncode, "H701" in done.stderr) == (0, False)


def test_send_to_a_virtual_brick_moves_the_motors_of_the_core_set() -> None:
    commands = ("OUTPUT_STEP_SPEED(0, A, 50, 0, 360, 0, 1)", "OUTPUT_READY(0, A)", "OUTPUT_GET_COUNT(0, 0, GV0(0))")
    done = run_ev3proto_text("send", "virtual", "--json", "--reply", *commands)
    assert done.returncode == 0
    assert done.stderr == (
        "plugged in: medium motor on A, large motors on B and C; sensors: touch on 1, gyro on 2, colour on 3,"
        " ultrasonic on 4 (--bare: nothing)\n"
    )
    count = json.loads(done.stdout.splitlines()[-1])["reply"]["values"][0]["value"]
    assert count == pytest.approx(360, abs=30)


@pytest.mark.parametrize(("words", "port"), [(("--bare",), "A"), ((), "D")])
def test_a_wait_for_a_motor_that_is_not_there_is_named(words: tuple[str, ...], port: str) -> None:
    commands = (f"OUTPUT_STEP_SPEED(0, {port}, 50, 0, 360, 0, 1)", f"OUTPUT_READY(0, {port})")
    done = run_ev3proto_text("send", "virtual", *words, "--reply", "--timeout", "1", *commands)
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1] == (
        "no answer from the virtual brick to the command with the counter 1 within 1 s; OUTPUT_READY waits for a motor"
        f" on {port}, but none is plugged in there"
    )


def test_only_a_virtual_brick_can_be_bare() -> None:
    done = run_ev3proto_text("send", "wifi:127.0.0.1", "--bare", "NOP()")
    assert done.returncode == 2
    assert "--bare is for a virtual brick" in done.stderr


def test_copy_reads_no_more_than_a_brick_has_room_for() -> None:
    done = run_ev3proto_text("copy", "virtual", "/dev/zero", "brick:../prjs/x.rtf")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == "/dev/zero: cannot be read: more than 256 MiB, for which no brick has room\n"


@pytest.mark.parametrize(
    ("words", "status", "sentence"),
    [
        (("nowhere", "01"), 2, "unknown target 'nowhere'"),
        (("bluetooth", "01"), 2, "expected its address, such as bluetooth:00:16:53:42:2B:99"),
        (("virtual", "hello"), 1, "is neither a file nor assembly nor a frame"),
        (("wifi:127.0.0.1:1", "NOP()"), 1, "nothing is listening on 127.0.0.1:1"),
        (("serial:/dev/none", "NOP()"), 1, "no such serial port: /dev/none; pair the brick"),
    ],
)
def test_send_says_what_to_do(words: tuple[str, ...], status: int, sentence: str) -> None:
    done = run_ev3proto_text("send", *words)
    assert (done.returncode, done.stdout) == (status, "")
    assert sentence in done.stderr
    assert "Traceback" not in done.stderr


# replay


def test_replay_omits_commands_that_do_more_than_read() -> None:
    done = run_ev3proto_text("replay", WIFI_CAPTURE, "--to", "virtual", "--dry-run")
    assert done.returncode == 0
    left_out = [line for line in done.stdout.splitlines() if line.startswith("omitted")]
    assert "SOUND.TONE starts or ends a sound (--allow sounds)" in left_out[0]
    assert "UI_WRITE.LED changes the lights, or plays a signal (--allow lights)" in left_out[1]
    assert "OUTPUT_START makes motors turn or stop (--allow motors)" in left_out[2]
    assert "OUTPUT_STOP makes motors turn or stop (--allow motors)" in left_out[3]
    assert "BEGIN_DOWNLOAD creates or changes files (--allow files)" in left_out[4]
    assert done.stderr == "14 commands would be sent, 10 omitted\n"


def test_replay_allows_what_is_named() -> None:
    done = run_ev3proto_text("replay", WIFI_CAPTURE, "--to", "virtual", "--dry-run", "--allow", "motors,BEGIN_DOWNLOAD")
    assert done.stderr == "18 commands would be sent, 6 omitted\n"
    done = run_ev3proto_text("replay", WIFI_CAPTURE, "--to", "virtual", "--dry-run", "--allow", "engines")
    assert done.returncode == 2
    assert "unknown operation or group 'engines'" in done.stderr


def test_replay_tells_how_the_replies_differ() -> None:
    done = run_ev3proto_text("replay", WIFI_CAPTURE, "--to", "virtual", "--fast")
    assert done.returncode == 1
    lines = without_times(done.stdout)
    battery = next(number for number, line in enumerate(lines) if "UI_READ.GET_VBATT(VALUE=GV(0)) -> VALUE=7.5" in line)
    assert lines[battery + 1] == "recorded: VALUE=7.92 V"
    assert done.stderr.endswith(
        "10 commands sent, 14 omitted; answered 6 as recorded, 1 with other values, 3 otherwise\n"
    )


def test_the_conformance_capture_is_answered_by_the_virtual_brick_as_recorded() -> None:
    done = run_ev3proto_text(
        "replay", CONFORMANCE, "--to", "virtual", "--fast", "--differences", "--allow", "computing"
    )
    assert (done.returncode, done.stdout) == (0, "")
    assert done.stderr == (
        "the firmware of the brick is V1.04H\n"
        "300 commands sent, 0 omitted; answered 300 as recorded, 0 with other values, 0 otherwise\n"
    )


def test_a_reply_that_only_another_firmware_gives_is_shown(tmp_path: Path) -> None:
    """A brick with different arithmetic: the value is shown, and the battery's is not."""
    frames = [
        *(ev3proto.parse(bytes.fromhex(frame)) for frame in ("0800010000040081 0160", "0900020000010010070560")),
        ev3proto.direct_reply(bytes.fromhex("00000041"), counter=1),
        ev3proto.direct_reply(b"\x0d", counter=2),
    ]
    capture = tmp_path / "other.pcapng"
    with capture.open("wb") as stream:
        write_pcapng([frames[0], frames[2], frames[1], frames[3]], stream)
    done = run_ev3proto_text("replay", capture, "--to", "virtual", "--fast", "--differences")
    assert done.returncode == 0
    assert without_times(done.stdout) == [
        "#3 ADD8(SOURCE1=7, SOURCE2=5, DESTINATION=GV(0)) -> DESTINATION=12",
        "recorded: DESTINATION=13",
    ]
    assert done.stderr == "2 commands sent, 0 omitted; answered 1 as recorded, 1 with other values, 0 otherwise\n"


def test_the_conformance_capture_only_reads_and_computes() -> None:
    done = run_ev3proto_text("replay", CONFORMANCE, "--to", "usb", "--dry-run")
    assert done.stderr == "216 commands would be sent, 84 omitted\n"
    done = run_ev3proto_text("replay", CONFORMANCE, "--to", "usb", "--dry-run", "--allow", "computing")
    assert done.stderr == "300 commands would be sent, 0 omitted\n"
    assert not re.search("OUTPUT_(?!GET|TEST|READ)|SOUND_?[.](TONE|PLAY)|UI_DRAW|UI_WRITE|_SET", done.stdout)


def test_replay_leaves_the_files_of_others_alone(tmp_path: Path) -> None:
    """The capture begins in the middle of a transfer; another one was not sent, so its handle is another file's now."""
    frames = [
        ev3proto.system.close_filehandle(5, counter=1),
        ev3proto.system.begin_download("../prjs/x", 10, counter=2),
        ev3proto.system_reply("BEGIN_DOWNLOAD", counter=2, handle=6),
        ev3proto.system.close_filehandle(6, counter=3),
        ev3proto.system.continue_upload(7, 10, counter=4),
    ]
    capture = tmp_path / "middle.pcapng"
    with capture.open("wb") as stream:
        write_pcapng(frames, stream)
    done = run_ev3proto_text("replay", capture, "--to", "virtual", "--dry-run")
    assert done.stderr == "0 commands would be sent, 4 omitted\n"
    done = run_ev3proto_text("replay", capture, "--to", "virtual", "--dry-run", "--allow", "files")
    assert done.stderr == "2 commands would be sent, 2 omitted\n"


def test_replay_of_a_transfer_uses_the_handle_that_the_brick_gives(tmp_path: Path) -> None:
    (tmp_path / "brick" / "prjs").mkdir(parents=True)
    (tmp_path / "brick" / "prjs" / "x").write_bytes(bytes(20))
    frames = [
        ev3proto.system.begin_upload("../prjs/x", 10, counter=1),
        ev3proto.system_reply("BEGIN_UPLOAD", counter=1, size=20, handle=9, data=bytes(10)),
        ev3proto.system.continue_upload(9, 10, counter=2),
        ev3proto.system_reply("CONTINUE_UPLOAD", counter=2, status=8, handle=9, data=bytes(10)),
    ]
    capture = tmp_path / "upload.pcapng"
    with capture.open("wb") as stream:
        write_pcapng(frames, stream)
    done = run_ev3proto_text("replay", capture, "--to", f"virtual:{tmp_path / 'brick'}")
    assert done.stderr == "2 commands sent, 0 omitted; answered 2 as recorded, 0 with other values, 0 otherwise\n"
    assert "CONTINUE_UPLOAD handle=64 max_bytes=10 -> END_OF_FILE handle=64" in done.stdout
    assert done.returncode == 0


# proxy


def test_a_proxy_whose_output_is_not_read_goes_on(tmp_path: Path) -> None:
    """Lines fill the pipe of 64 kB after some 700 commands."""
    (tmp_path / "prjs").mkdir()
    data = bytes(range(256)) * 2000
    (tmp_path / "prjs/big.rtf").write_bytes(data)
    words = ["--listen", "wifi:127.0.0.1:0", "--no-beacon", "--read-only"]
    with served(tmp_path) as brick:
        call = [sys.executable, "-m", "ev3proto", "proxy", "--to", f"wifi:127.0.0.1:{brick.port}", *words]
        with subprocess.Popen(call, stdout=subprocess.PIPE, text=True) as process:
            try:
                assert process.stdout is not None
                port = int(process.stdout.readline().rpartition(":")[2])
                with EV3(protocol=ev3proto.WIFI, address=("127.0.0.1", port), timeout=30.0) as my_ev3:
                    for _ in range(2):
                        assert my_ev3.upload("../prjs/big.rtf") == data
            finally:
                process.terminate()
            assert len(process.stdout.read()) > 1 << 17


def through(found: Relay) -> EV3:
    return EV3(protocol=ev3proto.WIFI, address=("127.0.0.1", found.proxy.port), timeout=30.0)


def test_a_program_talks_through_the_proxy(tmp_path: Path) -> None:
    with served(tmp_path) as brick, relay(f"wifi:127.0.0.1:{brick.port}") as found:
        for _ in range(2):  # one client after the other
            with through(found) as my_ev3:
                assert my_ev3.volume == 100
                my_ev3.download(bytes(3000), "../prjs/x.bin")
        assert found.shown[0] == "INFO.GET_VOLUME(VALUE=GV(0)) -> VALUE=100 %"
        assert re.fullmatch(r'BEGIN_DOWNLOAD size=3000 path="../prjs/~\w{8}[.]tmp" -> SUCCESS handle=0', found.shown[1])
        assert found.said == []


def test_writes_of_a_client_are_recorded_as_they_were() -> None:
    """In parts of a frame, and several frames at once."""
    stream = io.BytesIO()
    ask = command("DATA8 volume\nINFO(GET_VOLUME, volume)")
    with relay("virtual", Recording(stream)) as found, Client(found.proxy.port) as client:
        client.send(ask[:3])
        until(lambda: stream.getvalue().count(ask[:3]) == 1)
        client.send(ask[3:])
        client.reply()
        client.send(LED + ask)
        client.reply()
    stream.seek(0)
    packets = [Ethernet(data).data.data for _, data in dpkt.pcapng.Reader(stream)]
    sent = [bytes(packet.data) for packet in packets if packet.dport == found.proxy.port and packet.data]
    assert sent[-3:] == [ask[:3], ask[3:], LED + ask]


def test_a_dialogue_is_recorded(tmp_path: Path) -> None:
    stream = io.BytesIO()
    with relay("virtual", Recording(stream)) as found, through(found) as my_ev3:
        my_ev3.send_direct_cmd(ev3proto.ops.ui_write.led(2))
        assert my_ev3.name == "EV3"
    (tmp_path / "talk.pcapng").write_bytes(stream.getvalue())
    records = [event for event in read(tmp_path / "talk.pcapng").events() if isinstance(event, Record)]
    assert [record.message.kind for record in records] == ["direct-command", "direct-command", "direct-reply"]
    assert records[2].values[0].value == "EV3"
    assert records[2].request is records[1]
    # The numbers next to the dialogue are those of the packets.
    assert found.numbers == [record.number for record in records]


PROGRAM = Random(1).randbytes(1187)
"""A program of 1187 bytes, like one that a foreign client sent in a single CONTINUE_DOWNLOAD."""


def system_7(number: int, body: bytes) -> bytes:
    return frame(7, 0x01, bytes((number,)) + body)


@pytest.mark.parametrize(
    ("sent", "reply", "sentence"),
    [
        (command("UI_WRITE(LED, 1)", 7), "03 00 07 00 04", "UI_WRITE.LED changes the lights, or plays a signal"),
        (command("SOUND(BREAK)", 7), "03 00 07 00 04", "SOUND.BREAK starts or ends a sound"),
        (
            command("UI_DRAW(UPDATE)", 7),
            "03 00 07 00 04",
            "UI_DRAW.UPDATE changes what the display or the terminal shows",
        ),
        (
            command("DATA32 x\nTIMER_WAIT(5, x)", 7),
            "07 00 07 00 04 00 00 00 00",
            "TIMER_WAIT does more than read, such as computing, jumping or waiting",
        ),
        (command("JR(-2)", 7), "03 00 07 00 04", "JR does more than read, such as computing, jumping or waiting"),
        (b"\x06\0\x07\0\0\0\0\xff", "03 00 07 00 04", "the frame may do anything"),
        (system_7(0x9B, b"x\0"), "05 00 07 00 05 9b 05", "CREATE_DIR creates or changes files"),
        (system_7(0x92, b"\5\0\0\0x\0"), "06 00 07 00 05 92 05 ff", "BEGIN_DOWNLOAD creates or changes files"),
        (system_7(0x93, b"\0" + PROGRAM), "06 00 07 00 05 93 05 ff", "CONTINUE_DOWNLOAD creates or changes files"),
        (system_7(0x55, b""), "05 00 07 00 05 55 05", "the frame may do anything"),
        (
            system_7(0x98, b"\0"),
            "06 00 07 00 05 98 01 ff",
            "CLOSE_FILEHANDLE names a handle that this client has not opened",
        ),
        (
            system_7(0x95, b"\0\0\2"),
            "06 00 07 00 05 95 01 ff",
            "CONTINUE_UPLOAD names a handle that this client has not opened",
        ),
        (bytes.fromhex("0600 0700 0a a0 00 01"), "05 00 07 00 09 01 00", "the frame may do anything"),
        (bytes.fromhex("0300 0700 02"), "", "DIRECT_REPLY is not a command"),
        (bytes.fromhex("0500 0700 03 98 00"), "", "SYSTEM_REPLY is not a command"),
        (bytes.fromhex("0600 0700 80 0000 0a"), "", "OBJECT_END does more than read"),
        (bytes.fromhex("0400 0700 77 01"), "", "the frame may do anything"),
    ],
)
def test_what_read_only_blocks(sent: bytes, reply: str, sentence: str) -> None:
    with relay("virtual", is_read_only=True) as found, Client(found.proxy.port) as client:
        forwarded: list[bytes] = []
        send = found.wire.send
        found.wire.send = lambda frame: forwarded.append(frame) or send(frame)  # type: ignore[method-assign, func-returns-value]
        client.send(sent)
        if reply:
            assert client.reply() == bytes.fromhex(reply)
        nop = command("NOP()", 9)
        assert client.ask(nop) == bytes.fromhex("0300090002")
        assert forwarded == [nop]
        (said,) = found.said
        assert said.startswith(f"blocked by --read-only: {sentence}")


def test_read_only_leaves_the_download_of_another_client_alone(tmp_path: Path) -> None:
    with (
        served(tmp_path, Options(port=0, beacon=False, clients=2)) as brick,
        relay(f"wifi:127.0.0.1:{brick.port}", is_read_only=True) as found,
        Client(brick.port) as other,
        Client(found.proxy.port) as client,
    ):
        handle = other.ask(system(0x92, b"\5\0\0\0../prjs/x.rtf\0"))[7:8]
        for number in (0x98, 0x95, 0x97, 0x9A):
            assert client.ask(system(number, handle + (b"" if number == 0x98 else b"\0\2")))[6] == 1
        assert other.ask(system(0x93, handle + b"hello"))[6] == 8
    assert (tmp_path / "prjs/x.rtf").read_bytes() == b"hello"


def handles_in_use(brick: Served) -> int:
    return len(brick.now.brick._system._transfers)


def test_read_only_closes_what_a_client_leaves_open(tmp_path: Path) -> None:
    (tmp_path / "prjs").mkdir()
    (tmp_path / "prjs" / "x.rtf").write_bytes(bytes(3000))
    with served(tmp_path) as brick:
        with relay(f"wifi:127.0.0.1:{brick.port}", is_read_only=True) as found:
            upload_begun = system(0x94, b"\x0a\0../prjs/x.rtf\0")
            with Client(found.proxy.port) as client:
                handle = client.ask(upload_begun)[11:12]
                assert client.ask(system(0x98, handle))[6] == 0
                assert client.ask(system(0x98, handle))[6] == 1  # it is closed
                client.ask(upload_begun)
                # The reply to the first one comes when the client is gone; the others are never sent.
                client.send(system(0x99, b"\x0a\0../prjs/\0") * 3)
            with Client(found.proxy.port) as client:
                assert client.ask(command("NOP()", 7)) == bytes.fromhex("0300070002")
                assert client.is_silent()
                assert handles_in_use(brick) == 0
                client.ask(upload_begun)
                # The proxy ends while this client is connected.
                found.proxy.stop()
                found.thread.join(30)
        until(lambda: handles_in_use(brick) == 0)


def test_read_only_waits_for_the_reply_before_a_handle_is_used_again(tmp_path: Path) -> None:
    """The first command may close it, and another client get it."""
    (tmp_path / "prjs").mkdir()
    (tmp_path / "prjs" / "x.rtf").write_bytes(bytes(30))
    with relay(f"virtual:{tmp_path}", is_read_only=True) as found, Client(found.proxy.port) as client:
        handle = client.ask(system(0x94, b"\x0a\0../prjs/x.rtf\0"))[11:12]
        assert client.ask(system(0x95, handle + b"\x0a\0"))[6] == 0
        client.send(system(0x95, handle + b"\x0a\0") + system(0x98, handle))
        assert sorted(client.reply()[5:7] for _ in range(2)) == [b"\x95\x08", b"\x98\x01"]
        assert found.said == ["blocked by --read-only: CLOSE_FILEHANDLE names a handle that this client has not opened"]


def test_a_client_gets_no_reply_to_another_one() -> None:
    with relay("virtual") as found:
        with Client(found.proxy.port) as client:
            client.send(command("DATA32 t\nTIMER_WAIT(300, t)\nTIMER_READY(t)", 7))
        with Client(found.proxy.port) as client:
            assert client.ask(command("NOP()", 7)) == bytes.fromhex("0300070002")


@pytest.mark.parametrize("size", [1017, 1018, 1187, 65_530])
def test_a_download_of_any_length_goes_through(tmp_path: Path, size: int) -> None:
    data = Random(1).randbytes(size)
    stream = io.BytesIO()
    with (
        served(tmp_path) as brick,
        relay(f"wifi:127.0.0.1:{brick.port}", Recording(stream)) as found,
        Client(found.proxy.port) as client,
    ):
        assert upload(client, b"../prjs/x/x.rbf", data, 65_530) == 8  # END_OF_FILE
        assert client.ask(command("NOP()", 7)) == bytes.fromhex("0300070002")
        assert (tmp_path / "prjs/x/x.rbf").read_bytes() == data
        assert found.said == []
        assert "fault" not in "".join(found.shown)
        assert found.shown[1].endswith(" -> END_OF_FILE handle=0")
    records = [event for event in read(io.BytesIO(stream.getvalue())).events() if isinstance(event, Record)]
    assert [record.frame.endswith(data) for record in records].count(True) == 1


def test_a_long_frame_that_is_not_a_download_ends_the_connection() -> None:
    with relay("virtual") as found, Client(found.proxy.port) as client:
        client.send(system(0x99, bytes(1100)))
        with pytest.raises(ConnectionError):
            client.reply()
        assert "the length field says 1104" in found.said[0]


def test_a_poll_between_frames_is_passed_over(tmp_path: Path) -> None:
    stream = io.BytesIO()
    with relay("virtual", Recording(stream)) as found, Client(found.proxy.port) as client:
        for poll in (b"\0\0", b"\0", b"\0", b"\0\0" * 600):
            client.send(poll)
        assert client.ask(command("NOP()", 7)) == bytes.fromhex("0300070002")
        assert client.ask(b"\0\0" + command("NOP()", 8) + b"\0\0") == bytes.fromhex("0300080002")
        assert found.said == []
    (tmp_path / "talk.pcapng").write_bytes(stream.getvalue())
    records = [event for event in read(tmp_path / "talk.pcapng").events() if isinstance(event, Record)]
    assert [record.message.kind for record in records] == ["direct-command", "direct-reply"] * 2


def test_a_reply_answers_the_oldest_command_with_its_counter() -> None:
    """A brick answers in order. The commands had the same counter, so another reading is possible, and it is noted."""
    ask = direct_command(operation("OUTPUT_TEST", 0, 15, GV(0)), counter=7, reply=True, global_size=1).build()
    again = direct_command(operation("UI_READ.GET_LBATT", GV(0)), counter=7, reply=True, global_size=1).build()

    def only_the_second(frame: bytes, send: Callable[[bytes], None]) -> None:
        if frame == again:
            send(reply(frame, b"\x01"))

    with stub_brick(only_the_second) as port, relay(f"wifi:127.0.0.1:{port}") as found:
        with Client(found.proxy.port) as client:
            client.send(ask)
            assert client.ask(again) == bytes.fromhex("04 00 07 00 02 01")
        until(lambda: len(found.shown) == 2)
    assert found.shown == [
        "OUTPUT_TEST(LAYER=0, NOS=15, BUSY=GV(0)) -> BUSY=1  (the pairing is unsure)",
        "UI_READ.GET_LBATT(PCT=GV(0)) -> no reply  (counter 7)",
    ]


def test_a_frame_that_is_longer_than_a_report_does_not_go_to_usb(tmp_path: Path) -> None:
    with relay(f"virtual:{tmp_path}") as found, Client(found.proxy.port) as client:
        found.wire.carrier = Carrier.USB
        assert upload(client, b"../prjs/x.rbf", PROGRAM, 1187) == SystemStatus.SIZE_ERROR
        assert found.said == [
            "a frame of 1194 bytes was not sent: on USB a frame has at most 1024 bytes; send the file in pieces"
        ]


def test_names_and_pins_can_be_masked() -> None:
    stream = io.BytesIO()
    with relay("virtual", Recording(stream), is_masked=True) as found, through(found) as my_ev3:
        my_ev3.name = "secret"
        assert my_ev3.name == "secret"
    assert found.shown == ['COM_SET.SET_BRICKNAME(NAME="xxxxxx") -> ok', *found.shown[1:]]
    assert found.shown[1].endswith('-> NAME="xxxxxx"')
    assert b"secret" not in stream.getvalue()


@pytest.mark.parametrize("words", [[], ["--json"]])
def test_addresses_can_be_masked(tmp_path: Path, words: list[str]) -> None:
    """Those of brick and client: in lines, JSON, messages and recordings."""
    recording = tmp_path / "talk.pcapng"
    with served(tmp_path) as brick:
        target = f"wifi:127.0.0.1:{brick.port}"
        call = [
            "proxy",
            "--to",
            target,
            "--listen",
            "wifi:127.0.0.1:0",
            "--no-beacon",
            "--hide",
            "--record",
            str(recording),
        ]
        process = subprocess.Popen(
            [sys.executable, "-m", "ev3proto", *call, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )
        assert process.stdout is not None
        port = int(process.stdout.readline().rpartition(":")[2])
        with Client(port, unlocks=False) as client:
            client.send(b"GET /target?sn=0016533f0c1e VMTP1.0\r\nHost: annas-laptop\r\nProtocol: EV3\r\n\r\n")
            assert client.read(len(ACCEPT)) == ACCEPT
            assert client.ask(command("NOP()", 7)) == bytes.fromhex("0300070002")
            peer = client.socket.getsockname()[1]
            client.send(b"\xff" * 9)
            with pytest.raises(ConnectionError):
                client.reply()
    shown, said = process.communicate(timeout=30)
    assert process.returncode == 1
    first, last = said.splitlines()
    assert first.startswith("x sent bytes that are not a frame")
    assert last == "the brick closed the connection; connect again"
    assert "NOP" in shown
    recorded = recording.read_bytes()
    for secret in ("127.0.0.1", str(brick.port), str(peer), "0016533f0c1e", "annas-laptop"):
        assert secret not in shown
        assert secret.encode() not in recorded
    assert socket.inet_aton("127.0.0.1") not in recorded


def test_a_brick_that_is_not_found_is_not_named_with_hide() -> None:
    for words in (("--to", "wifi:127.0.0.1:1"), ("--to", "wifi:annas-brick.invalid")):
        done = run_ev3proto_text("proxy", *words, "--hide", "--listen", "wifi:127.0.0.1:0", "--no-beacon")
        assert done.returncode == 1
        assert "127.0.0.1" not in done.stderr
        assert "annas" not in done.stderr


@pytest.mark.parametrize("faults", [Faults(drop=1.0), Faults(delay=1.0), Faults(corrupt=1.0, random=Random(1))])
def test_faults_on_purpose(faults: Faults) -> None:
    with relay("virtual", faults=faults) as found, through(found) as my_ev3:
        with pytest.raises(ev3proto.NoAnswerError, match="within"):
            my_ev3.send_direct_cmd(b"\x01", sync_mode="SYNC", timeout=0.1)
        if faults.delay:
            assert my_ev3.send_direct_cmd(b"\x01", sync_mode="SYNC") == b""


def test_other_addresses_are_disconnected() -> None:
    with relay("virtual", only_from="127.0.0.2") as found:
        with pytest.raises(ev3proto.NoBrickError):
            through(found)
        assert found.said == ["127.0.0.1 was disconnected: only 127.0.0.2 is served (--from)"]


def test_a_client_that_sends_text_is_named() -> None:
    with relay("virtual") as found:
        with Client(found.proxy.port) as client:
            client.send(b"Protocol: EV3\r\n")
            with pytest.raises(ConnectionError):
                client.reply()
        with Client(found.proxy.port) as client:
            assert client.ask(command("NOP()", 7)) == bytes.fromhex("0300070002")
        (said,) = found.said
        assert re.sub(r"^127.0.0.1:\d+ ", "", said) == (
            "sent bytes that are not a frame: this is the text 'Protocol: EV3', not a frame; a Messaging block needs"
            " WRITEMAILBOX: for its mailbox 'abc', send 19 00 00 00 81 9E 04 61 62 63 00 0E 00 50 72 6F 74 6F 63 6F 6C"
            " 3A 20 45 56 33 00; disconnected"
        )


def test_an_incomplete_frame_is_reported() -> None:
    with relay("virtual") as found:
        with Client(found.proxy.port) as client:
            client.send(bytes.fromhex("1100000001920a0000002f6e6f6e652f7800"))
        with Client(found.proxy.port) as client:
            assert client.ask(command("NOP()", 7)) == bytes.fromhex("0300070002")
        assert "the stream ends inside a frame, after 18 bytes" in found.said[0]


def test_the_oldest_of_many_silent_clients_gives_way() -> None:
    with relay("virtual") as found, contextlib.ExitStack() as stack:
        silent = [stack.enter_context(Client(found.proxy.port, unlocks=False)) for _ in range(70)]
        with Client(found.proxy.port) as client:
            assert client.ask(command("NOP()", 7)) == bytes.fromhex("0300070002")
        with pytest.raises(ConnectionError):
            silent[0].read(1)
        silent[-1].send(UNLOCK)
        assert silent[-1].read(16) == ACCEPT


def test_the_brick_goes_away(tmp_path: Path) -> None:
    with served(tmp_path) as brick:
        found = Relay(f"wifi:127.0.0.1:{brick.port}")
        my_ev3 = through(found)
        assert my_ev3.volume == 100
    found.thread.join(30)
    found.wire.close()
    assert isinstance(found.proxy.lost, ConnectionLostError)
    with pytest.raises(ev3proto.ConnectionLostError):
        my_ev3.send_direct_cmd(b"\x01", sync_mode="SYNC")


def test_the_port_of_the_proxy_is_in_use(tmp_path: Path) -> None:
    with relay("virtual") as found, pytest.raises(PortInUseError, match="is in use: end what uses it"):
        Relay(f"virtual:{tmp_path}", port=found.proxy.port)


def test_a_recording_of_the_proxy_that_cannot_be_written() -> None:
    words = [
        sys.executable,
        "-m",
        "ev3proto",
        "proxy",
        "--listen",
        "wifi:127.0.0.1:0",
        "--to",
        "virtual",
        "--no-beacon",
    ]
    for record, place in (("/dev/full", "/dev/full:"), ("-", "the output")):
        with Path("/dev/full").open("wb") as full:
            done = subprocess.run(
                [*words, "--record", record], cwd=ROOT, stdout=full, stderr=subprocess.PIPE, text=True
            )
        assert (done.returncode, done.stderr) == (1, f"{place} cannot be written: No space left on device\n")


def test_the_proxy_as_a_program_records_into_a_pipe() -> None:
    port = free_port()
    words = ["proxy", "--listen", f"wifi:127.0.0.1:{port}", "--to", "virtual", "--no-beacon", "--record", "-"]
    with subprocess.Popen(
        [sys.executable, "-m", "ev3proto", *words], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stderr is not None
        assert process.stdout is not None
        assert process.stderr.readline() == f"listening on 127.0.0.1:{port}\n".encode()
        with EV3(protocol=ev3proto.WIFI, address=("127.0.0.1", port)) as my_ev3:
            assert my_ev3.volume == 100
        process.send_signal(signal.SIGINT)
        data = process.stdout.read()
        assert process.wait(30) == 0
        assert process.stderr.read() == b""
    records = [event for event in read(io.BytesIO(data)).events() if isinstance(event, Record)]
    assert records[1].values[0].value == 100


def test_the_proxy_announces_itself() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as listener:
        listener.bind(("127.0.0.1", 0))
        listener.settimeout(30)
        with relay("virtual", announced="001653000001", beacon_port=listener.getsockname()[1]) as found:
            datagram, _ = listener.recvfrom(1024)
    port = str(found.proxy.port).encode()
    assert datagram == b"Serial-Number: 001653000001\r\nPort: " + port + b"\r\nName: EV3\r\nProtocol: EV3\r\n"


def test_the_proxy_announces_the_serial_number_of_its_brick(tmp_path: Path) -> None:
    number = "00165340abcd"
    with (
        served(tmp_path, Options(port=0, beacon=False, serial_number=number, clients=4)) as brick,
        contextlib.closing(open_wire(Target.parse(f"wifi:127.0.0.1:{brick.port}"))) as wire,
    ):
        assert announced_number(Target.parse("wifi:127.0.0.1"), wire) == number
        assert announced_number(Target.parse("wifi:00:16:53:00:00:01"), wire) == "001653000001"
        brick.now.brick.equipment.settings.bluetooth_address = "none"
        assert announced_number(Target.parse("wifi:127.0.0.1"), wire) == "000000000000"
    done = run_ev3proto_text("proxy", "--to", "virtual", "--serial-number", "xyz")
    assert done.returncode == 2
    assert "invalid serial number 'xyz'; expected 12 hexadecimal digits" in done.stderr


def test_wrong_calls_of_the_proxy() -> None:
    for words, sentence in (
        (["--listen", "usb", "--to", "virtual"], "cannot listen at 'usb'"),
        (["--to", "virtual", "--from", "home"], "invalid address 'home'; expected one such as 192.0.2.1"),
        (["--to", "nowhere"], "unknown target 'nowhere'"),
    ):
        done = run_ev3proto_text("proxy", *words)
        assert done.returncode == 2
        assert sentence in done.stderr


# copy


def test_copy_brings_a_file_to_the_brick_and_back(tmp_path: Path) -> None:
    (tmp_path / "root").mkdir()
    target = f"virtual:{tmp_path / 'root'}"
    source, copied = tmp_path / "tone.rsf", tmp_path / "copied.rsf"
    source.write_bytes(bytes(range(256)) * 12)
    done = run_ev3proto_text("copy", target, source, "brick:../prjs/tone/tone.rsf")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"{source} -> brick:../prjs/tone/tone.rsf: 3072 bytes, the same MD5\n"
    assert (tmp_path / "root/prjs/tone/tone.rsf").read_bytes() == source.read_bytes()
    assert run_ev3proto_text("copy", target, "brick:../prjs/tone/tone.rsf", copied).returncode == 0
    assert copied.read_bytes() == source.read_bytes()


def test_copy_says_what_to_do(tmp_path: Path) -> None:
    target = f"virtual:{tmp_path}"
    for words, status, sentence in (
        (("one", "two"), 2, "neither SOURCE nor DESTINATION is on the brick; write its path there as brick:PATH"),
        (
            (tmp_path / "none", "brick:../prjs/none"),
            1,
            f"{tmp_path / 'none'}: cannot be read: No such file or directory",
        ),
        (("brick:../prjs/none.rbf", tmp_path / "x"), 1, "none.rbf"),
    ):
        done = run_ev3proto_text("copy", target, *words)
        assert (done.returncode, done.stdout) == (status, "")
        assert sentence in done.stderr
        assert "Traceback" not in done.stderr
    assert not (tmp_path / "x").exists()


def test_copy_shows_a_bar_on_a_terminal(tmp_path: Path) -> None:
    source = tmp_path / "a.bin"
    source.write_bytes(bytes(2000))
    command = [sys.executable, "-m", "ev3proto", "copy", f"virtual:{tmp_path}", str(source), "brick:../prjs/a.bin"]
    ours, theirs = pty.openpty()
    subprocess.run(command, stdout=subprocess.DEVNULL, stderr=theirs, check=True, timeout=60)
    os.close(theirs)
    assert "2,000 of 2,000 bytes" in os.read(ours, 1 << 16).decode()
    os.close(ours)
