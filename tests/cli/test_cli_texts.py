"""Texts on the command line: they work like captures, and everything in them is read or reported."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest
from support.cli import run_ev3proto, run_ev3proto_text

LOG = """09:12:31.000 sent 08 00 01 00 00 04 00 81 01 60
09:12:31.010 recv 07 00 01 00 02 a4 70 fd 40
09:12:32.000 Sent 0x|0E:00|2A:00|80|00:00|94|01|01|82:B8:01|82:E8:03|
09:12:33.000 sent 08 00 02 00 00 04 00 81 01 60
"""
TONE = "0e002a0080000094010182b80182e803"


def run(*words: str, stdin: str | bytes = "") -> subprocess.CompletedProcess[bytes]:
    return run_ev3proto(*words, stdin=stdin.encode() if isinstance(stdin, str) else stdin)


def out(*words: str, stdin: str | bytes = "") -> str:
    done = run(*words, stdin=stdin)
    assert done.returncode == 0, done.stderr
    return done.stdout.decode()


@pytest.fixture
def log(tmp_path: Path) -> Path:
    path = tmp_path / "robot.log"
    path.write_text(LOG)
    return path


def test_a_frame_with_a_wrong_length_is_a_faulty_frame() -> None:
    text = (
        f"one: {TONE}\ntwo: {TONE[:-2]}\nid d41d8cd98f00b204e9800998ecf8427e 00:16:53:42:2B:99\nthree: {TONE}0000ff\n"
    )
    done = run("decode", "-", stdin=text)
    assert done.returncode == 1
    said = done.stderr.decode()
    assert "line 2: fault at offset 0: the frame is cut off" in said
    assert "line 4: fault at offset 16: the frame is longer than its length field says" in said
    assert "line 3" not in said
    checked = run("check", "-", stdin=text)
    assert [code in checked.stdout for code in (b"E102", b"E103")] == [True, True]


UNKNOWN = {
    "1C00xxxx0192xxxxxxxx2E2E2F617070732F7473742F7473742E72626600": ("counter ?", "size = ?", 'path = "../apps'),
    "let b = new Uint8Array([0x0D, 0x00, id & 0xFF, (id >> 8) & 0xFF, 0x00, 0x04, 0x00,\n"
    "  0x99, 0x1D, 0x00, port, 0x00, 0x00, 0x01, 0x60 ]);": ("NO        = ?", "MODE      = 0"),
    "0F00 MMMM 80 0000 94 01 81 XX 82 E803 82 E803": ("VOLUME    = ?", "FREQUENCY = 1000 Hz"),
    "XX XX 2A 00 80 00 00 94 01 81 02 82 e8 03 82 e8 03": ("counter 42, 17 bytes",),
}


@pytest.mark.parametrize("text", UNKNOWN)
def test_unknown_bytes_are_shown_as_such(text: str) -> None:
    done = run("decode", "-", stdin=f"{text}\n")
    assert done.returncode == 0
    for said in UNKNOWN[text]:
        assert said in done.stdout.decode()


def test_operations_joined_in_python() -> None:
    text = "ops = b''.join((ev3.opSound, ev3.TONE, ev3.LCX(1), ev3.LCX(440), ev3.LCX(1000)))\n"
    assert "--operations reads them" in run("decode", "-", stdin=text).stderr.decode()
    assert "FREQUENCY = 440 Hz" in run("decode", "--operations", "-", stdin=text).stdout.decode()
    frame = text.replace("((", "((0x0e, 0, 0x2a, 0, 0x80, 0, 0,  # head\n  ")
    assert "FREQUENCY = 440 Hz" in run("decode", "-", stdin=frame).stdout.decode()


def test_expressions_are_named_with_line_and_column() -> None:
    head = "send([0x0f, 0x00, n, 0x00, 0x80, 0x00, 0x00, 0x94, 0x01, 0x81"
    text = f"first\n{head}, lo(f, 1), 0x82, 0xe8, 0x03, 0x82, 0xe8, 3])"
    said = run("check", "-", stdin=text).stderr.decode()
    assert "line 2, column 19: 'n' is unknown, read as 0" in said
    assert "line 2, column 64: 'lo(f, 1)' is unknown, read as 0" in said


MANGLED = {
    "0d 00 2a 00 c2 80 00 00 c2 a4 00 01 c2 81 64 c2 a6 00 01": "encoded as UTF-8: C2 80 is here for 80",
    "0d 00 2a 00 3f 00 00 3f 00 01 3f 64 3f 00 01": "3F is here for every byte above 7F",
    "0d 00 2a 00 efbfbd 00 00 efbfbd 00 01 efbfbd 64 efbfbd 00 01": "EF BF BD is here for a byte above 7F",
    "0e 00 00 00 80 00 00 94 01 0d 0a 82 e8 03 82 e8 03": "0D 0A is here for 0A",
    r"b'\r\x00*\x00?\x00\x00?\x00\x01?d?\x00\x01'": "3F is here for every byte above 7F",
}


@pytest.mark.parametrize("text", MANGLED)
def test_bytes_that_went_through_a_text(text: str) -> None:
    checked = run("check", "-", stdin=f"{text}\n").stdout.decode()
    assert f"did you mean: {MANGLED[text]}" in checked or f"did you mean: the frame was {MANGLED[text]}" in checked
    assert checked.count("error[") <= 2
    assert MANGLED[text] in run("decode", "-", stdin=f"{text}\n").stderr.decode()


ECHO = bytes.fromhex("04 00 00 00 01 f6 7f b6 00 00 00 06 00 00")


@pytest.mark.parametrize(
    "text", [f"REPLY {ECHO!r}", f"RX {ECHO.hex(' ')}", str(list(ECHO)), f"00000000: {ECHO.hex(' ', -2)}"]
)
def test_the_echo_of_the_bootloader_is_named(text: str) -> None:
    done = run("decode", "-", stdin=f"{text}\n")
    assert "a known fault of its bootloader: the reply to GET_VERSION" in done.stderr.decode()


def test_a_reply_that_went_through_a_text() -> None:
    assert "C3 90 is here for D0" in run("decode", "-", stdin="RX 05 00 2a 00 02 c3 90 41\n").stderr.decode()


STRANGERS = {
    "0x06 0x00 0x00 0x03 0x0B 0x02 0xF4 0x01": "a telegram of the NXT (PLAYTONE)",
    "TX 80 03 0B 02 F4 01": "a telegram of the NXT (PLAYTONE)",
    "0x08,0x00,0x81,0x00,0x11,0x51,0x00,0x25": "LEGO's Wireless Protocol",
    "uuid 00001624-1212-efde-1623-785feabcd123": "LEGO's Wireless Protocol",
    "c5f50002-8280-46da-89f4-6d8051e4aeef": "Pybricks",
    "from pybricks.hubs import EV3Brick": "Pybricks",
    "GET /target?sn=001612345678 VMTP1.0\nProtocol: EV3": "unlocks a brick on WiFi",
    "47 45 54 20 2f 74 61 72 67 65 74 3f 73 6e 3d": "unlocks a brick on WiFi",
    "00000000: 4745 5420 2f74 6172 6765 743f 736e 3d30  GET /target?sn=0": "unlocks a brick on WiFi",
    "Serial-Number: 0016533f0c1e\r\nPort: 5555\r\nName: EV3\r\nProtocol: EV3": "the beacon with which a brick",
    "00000000: 4865 6c6c 6f20 776f 726c 6420 6865 6c6c  Hello world hell": "no frame found",
    r'sendto(3, "\17\0\0\0\200\0\0\224\1\201"..., 17, 0, NULL, 0) = 17': "strace cut the string; -s 1024",
    "{length = 17, bytes = 0x0f000000 80000094 01810282 ... 82e803 }": "NSData",
}


@pytest.mark.parametrize("text", STRANGERS)
def test_what_is_something_else_is_named(text: str) -> None:
    for command in ("decode", "check"):
        done = run(command, "-", stdin=f"{text}\n")
        said = done.stderr.decode()
        assert STRANGERS[text] in said or STRANGERS[text] in done.stdout.decode()
        assert "--operations" not in said
        assert "--no-length" not in said


def test_dialogues_of_a_text(log: Path) -> None:
    lines = out("decode", "--dialogues", str(log)).splitlines()
    assert lines[0].endswith("VALUE=7.92 V  10.000 ms")
    assert len(lines) == 3
    assert lines[2].endswith("no reply  (counter 2)")


def test_a_filter_on_a_text(log: Path) -> None:
    found = out("decode", "--json", "--filter", "op==SOUND.TONE", str(log)).splitlines()
    assert [json.loads(line)["hex"] for line in found] == [TONE]
    assert b"1 frame: " not in run("check", "--filter", "op==UI_READ", str(log)).stderr
    assert run("decode", "--filter", "op==SOUND.PLAY", str(log)).returncode == 1


def test_stats_of_texts_and_captures_together(log: Path, tmp_path: Path) -> None:
    capture = tmp_path / "robot.pcapng"
    out("export", "pcapng", str(log), "-o", str(capture))
    whole = json.loads(out("stats", "--json", str(log), str(capture)))["whole"]
    assert whole["kinds"]["direct-command"]["messages"] == 6
    assert json.loads(out("stats", "--json", str(log)))["whole"]["seconds"] == 2.0


def test_times_survive_the_way_into_a_capture(log: Path, tmp_path: Path) -> None:
    capture = tmp_path / "robot.pcapng"
    out("export", "pcapng", str(log), "-o", str(capture))
    times = [json.loads(line)["time"] for line in out("decode", "--json", str(capture)).splitlines()]
    found = [time for time in times if time]
    assert "2026-01-01T09:12:31.000000" in found[-4]
    assert "2026-01-01T09:12:31.010000" in found[-3]
    assert "2026-01-01T09:12:33.000000" in found[-1]


def test_a_timeline_and_the_files_of_a_text(log: Path, tmp_path: Path) -> None:
    picture = tmp_path / "robot.svg"
    out("timeline", str(log), "-o", str(picture))
    assert "<svg" in picture.read_text()
    moved = "sent 0f 00 01 00 01 92 03 00 00 00 2f 61 2e 74 78 74 00\n"
    assert "/a.txt" in out("files", "-", stdin=moved)


def test_frames_as_raw_bytes() -> None:
    frames = bytes.fromhex(TONE) + bytes.fromhex("0800010000040081 0160")
    shown = [json.loads(line)["hex"] for line in out("decode", "--json", "-", stdin=frames).splitlines()]
    assert shown == [TONE, "08000100000400810160"]
    raw = run("encode", "SOUND(TONE, 1, 440, 1000)", "--to", "raw").stdout
    assert json.loads(out("decode", "--json", "-", stdin=raw))["counter"] == 0
    assert run("decode", "-", stdin=b"\x00\x01\x02garbage").returncode == 1
    assert json.loads(out("stats", "--json", "-", stdin=frames))["whole"]["messages"]["messages"] == 2
    assert len(out("decode", "--dialogues", "-", stdin=frames).splitlines()) == 2


def test_frames_without_their_length_and_operations_alone() -> None:
    content, operations = TONE[4:], TONE[14:]
    assert json.loads(out("decode", "--json", "--no-length", content))["hex"] == TONE
    shown = json.loads(out("decode", "--json", "--operations", operations))
    assert [one["command"] for one in shown["operations"]] == ["TONE"]
    assert json.loads(out("decode", "--json", "--operations", "81 01 60"))["globals"] == 4
    xtended = json.loads(out("decode", "--json", "--operations", "--dialect", "xtended", "E5 01 60"))
    assert (xtended["globals"], xtended["type"]) == (1, "DIRECT_COMMAND_REPLY")
    beyond = run("decode", "--operations", "81 01 C1 FF")
    assert beyond.returncode == 1
    assert b"the operations use 259 bytes of local memory; there are 63" in beyond.stderr
    wrapped = json.loads(out("decode", "--json", "--operations", "94 01 01 82\nB8 01 82 E8 03"))
    assert [one["command"] for one in wrapped["operations"]] == ["TONE"]
    assert b"--no-length" in run("decode", content).stderr
    assert b"--operations" in run("decode", operations).stderr
    assert b"--operations" in run("decode", "-", stdin=f"{operations}\n").stderr


WITHOUT_TIMES = (
    "sent 08 00 01 00 00 04 00 81 01 60\nrecv 07 00 01 00 02 a4 70 fd 40\nsent 08 00 02 00 00 04 00 81 01 60\n"
)


def test_a_text_without_times_has_no_latencies() -> None:
    dialogues = out("decode", "--dialogues", "-", stdin=WITHOUT_TIMES).splitlines()
    assert dialogues[0].endswith("VALUE=7.92 V")
    assert "ms" not in dialogues[0]
    pairs = [json.loads(line) for line in out("decode", "--dialogues", "--json", "-", stdin=WITHOUT_TIMES).splitlines()]
    assert [pair["latency"] for pair in pairs] == [None, None]
    counted = out("stats", "-", stdin=WITHOUT_TIMES)
    assert "Milliseconds" not in counted
    assert "Time" not in counted
    assert json.loads(out("stats", "--json", "-", stdin=WITHOUT_TIMES))["whole"]["latency"] is None
    assert "latency" not in out("values", "-", stdin=WITHOUT_TIMES)


def test_places_in_a_text_are_lines(log: Path, tmp_path: Path) -> None:
    assert "line  what\n   4  UI_READ.GET_VBATT" in out("stats", str(log))
    assert "in 4 frames" in out("stats", str(log))
    assert "line" in out("values", str(log)).splitlines()[0]
    capture = tmp_path / "robot.pcapng"
    out("export", "pcapng", str(log), "-o", str(capture))
    assert "packet  what" in out("stats", str(capture))


def test_what_a_text_says_above_the_bytes_counts_for_them() -> None:
    text = (
        "> 2024/01/31 12:00:00.123456  length=10 from=0 to=9\n 08 00 01 00 00 04 00 81 01 60\n"
        "< 2024/01/31 12:00:00.133456  length=9 from=0 to=8\n 07 00 01 00 02 a4 70 fd 40\n"
    )
    (line,) = out("decode", "--dialogues", "-", stdin=text).splitlines()
    assert line.endswith("VALUE=7.92 V  10.000 ms")


def test_commands_of_a_text_wait_within_the_memory_that_is_given(tmp_path: Path) -> None:
    path = tmp_path / "long.log"
    wide = "fe 03 {:02x} {:02x} 00 04 00 82 08 84" + " 61" * 1013 + " 00"
    commands = "".join(wide.format(number & 255, number >> 8) + "\n" for number in range(1200))
    path.write_text(commands + "03 00 af 04 02\n")
    done = run("stats", "--memory", "1", str(path))
    assert b"unanswered commands were dropped: the memory limit is 1 MiB" in done.stderr
    # Without any reply, no command could be answered, so nothing is lost.
    path.write_text(commands)
    assert run("stats", "--memory", "1", str(path)).stderr == b""


@pytest.mark.parametrize("command", ["stats", "values", "decode", "check"])
def test_what_is_neither_text_nor_capture_is_named_by_its_first_bytes(command: str, tmp_path: Path) -> None:
    path = tmp_path / "junk.bin"
    path.write_bytes(b"abc\x01\x02 that is something else")
    done = run(command, str(path))
    assert done.returncode == 1
    assert b"it starts with 61 62 63 01 02 20 74 68;" in done.stderr


@pytest.mark.parametrize(("count", "sentence"), [(1, "1 byte of padding follows"), (3, "3 bytes of padding follow")])
def test_padding_is_counted(count: int, sentence: str) -> None:
    done = run_ev3proto_text("decode", "06002A0080000001" + "00" * count)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines()[-1] == f"        {sentence} the frame"


def test_a_status_is_explained() -> None:
    """A folder that cannot be created, in the output of decode and of --dialogues."""
    talk = b"Sent 08:00:01:00:01:9b:2f:70:2f:00\nRecv 05:00:01:00:05:9b:05\n"
    meaning = "it cannot be created: it exists, its parent does not, or permission is denied"
    tree = run_ev3proto("decode", stdin=talk).stdout.decode().splitlines()
    at = tree.index("received SYSTEM_REPLY_ERROR, counter 1, 7 bytes: CREATE_DIR NO_PERMISSION")
    assert tree[at + 1] == f"        {meaning}"
    line = run_ev3proto("decode", "--dialogues", stdin=talk).stdout.decode().strip()
    assert line.endswith(f'CREATE_DIR path="/p/" -> NO_PERMISSION ({meaning})')
    reply = json.loads(run_ev3proto("decode", "--json", stdin=talk).stdout.splitlines()[-1])
    assert reply["status_meaning"] == meaning


BOTH = "all of it is a telegram of the NXT (SETOUTPUTSTATE), LEGO's earlier brick, and also this frame of an EV3"
MOTOR_C = "0C 00 80 04 02 64 07 00 00 20 00 00 00 00"


@pytest.mark.parametrize("name", ["decode", "check"])
def test_a_right_frame_alone_that_is_an_nxts_telegram_is_named_as_both(name: str) -> None:
    done = run_ev3proto(name, "-", stdin=MOTOR_C.encode())
    assert done.stderr.decode().splitlines()[0] == f"standard input, line 1: {BOTH}"
    assert name == "check" or done.stdout.startswith(b"DIRECT_REPLY, counter 1152")


def test_a_frame_with_a_direction_or_among_others_is_an_ev3s() -> None:
    battery = "08 00 80 0A 00 01 00 81 12 60\n04 00 80 0A 02 50\n"
    for text in (f"Recv {MOTOR_C}\n", f"{MOTOR_C}\n{MOTOR_C}\n", battery):
        done = run_ev3proto("decode", "-", stdin=text.encode())
        assert (done.returncode, done.stderr) == (0, b""), text


def test_a_faulty_frame_that_is_an_nxts_telegram_is_named_so_first() -> None:
    done = run("decode", "04 00 80 0A 01 00")
    assert done.returncode == 1
    assert done.stderr.decode().strip() == (
        "'04 00 80 0A 01 00': this is a telegram of the NXT (RESETMOTORPOSITION), LEGO's earlier brick; an EV3 does not"
        " know it; fault at offset 5: unknown system command 0x00"
    )


def test_an_opcode_that_no_brick_runs_is_a_fault() -> None:
    """So look telegrams of other bricks."""
    done = run("decode", "0C 00 00 04 00 64 07 00 00 20 00 00 00 00")
    assert done.returncode == 1
    assert b"offset 7: opcode 0x00 is ERROR, which the brick refuses" in done.stderr
