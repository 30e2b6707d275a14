"""The command line as a user types it: a process, its output, its exit status."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest
from support.cli import run_ev3proto_text
from support.terminal import on_a_terminal

from ev3proto.tables import OPCODES, operations
from ev3proto.tables.declaration import declarations
from ev3proto.tables.frame import MessageType
from ev3proto.tables.system import SYSTEM, SystemStatus

ROOT = Path(__file__).parents[2]
LESSON = ROOT / "captures" / "lesson-02.log"
TONE = "0E:00|2A:00|80|00:00|94|01|01|82:B8:01|82:E8:03|"
TONE_BYTES = "0e002a0080000094010182b80182e803"


def run(*words: str, stdin: str = "") -> subprocess.CompletedProcess[str]:
    return run_ev3proto_text(*words, stdin=stdin)


FORMS = [
    f"0x|{TONE}",
    f"09:12:31.011558 Sent 0x|{TONE}",
    TONE_BYTES,
    TONE_BYTES.upper(),
    "0e 00 2a 00 80 00 00 94 01 01 82 b8 01 82 e8 03",
    "0x0E, 0x00, 0x2A, 0x00, 0x80, 0x00, 0x00, 0x94, 0x01, 0x01, 0x82, 0xB8, 0x01, 0x82, 0xE8, 0x03",
    "unsigned char tone[] = {14, 0, 42, 0, 128, 0, 0, 148, 1, 1, 130, 184, 1, 130, 232, 3};",
    r"b'\x0e\x00*\x00\x80\x00\x00\x94\x01\x01\x82\xb8\x01\x82\xe8\x03'",
]


@pytest.mark.parametrize("form", FORMS)
def test_every_form_as_argument_and_on_standard_input(form: str) -> None:
    for done in (run("decode", "--json", form), run("decode", "--json", stdin=form + "\n")):
        assert (done.returncode, done.stderr) == (0, "")
        assert json.loads(done.stdout)["hex"] == TONE_BYTES


def test_bytes_without_quotes() -> None:
    done = run("decode", "--json", "06", "00", "01", "00", "80", "00", "00", "01")
    assert json.loads(done.stdout)["operations"][0]["op"] == "NOP"


@pytest.mark.parametrize(
    "words",
    [
        "14 0 42 0 128 0 0 148 1 1 130 184 1 130 232 3",
        "[14, 0, 42, 0, 128, 0, 0, 148, 1, 1, 130, 184, 1, 130, 232, 3]",
        "{14, 0, 42, 0, 128, 0, 0, 148, 1, 1, 130, 184, 1, 130, 232, 3};",
        "0xe, 0x0, 0x2a, 0x0, 0x80, 0x0, 0x0, 0x94, 0x1, 0x1, 0x82, 0xb8, 0x1, 0x82, 0xe8, 0x3",
        "e 0 2a 0 80 0 0 94 1 1 82 b8 1 82 e8 3",
    ],
)
def test_numbers_without_quotes(words: str) -> None:
    done = run("decode", "--json", *words.split())
    assert (done.returncode, done.stderr) == (0, "")
    assert json.loads(done.stdout)["hex"] == TONE_BYTES
    assert run("encode", *words.split()).stdout == "0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|\n"


def test_numbers_without_quotes_and_without_a_frame() -> None:
    text = "14 0 42 0 128 0 0 148 1 1 130 184 1"
    done, quoted = run("decode", *text.split()), run("decode", text)
    assert (done.returncode, done.stdout, done.stderr) == (1, quoted.stdout, quoted.stderr)
    assert done.stderr.startswith(f"'{text}': ")


def test_files_whose_names_are_numbers(tmp_path: Path) -> None:
    for name in ("1", "2"):
        (tmp_path / name).write_text(f"{TONE}\n")
    done = run_ev3proto_text("decode", "--json", "1", "2", cwd=tmp_path)
    assert (done.returncode, len(done.stdout.splitlines())) == (0, 2)


def test_every_frame_of_the_lesson() -> None:
    done = run("decode", "--json", str(LESSON))
    assert (done.returncode, done.stderr) == (0, "")
    entries = [json.loads(line) for line in done.stdout.splitlines()]
    assert len(entries) == 20
    assert not [entry for entry in entries if "fault" in entry or "rest" in entry]
    told = [[(op["op"], op["command"]) for op in entry.get("operations", [])] for entry in entries]
    assert told[0] == [("COM_SET", "SET_BRICKNAME")]
    assert entries[0]["operations"][0]["args"][0]["value"] == "myEV3"
    assert (entries[1]["kind"], entries[1]["status"], entries[1]["values"]) == ("direct-reply", "ok", [])
    assert told[3] == [("SOUND", "PLAY")]
    assert told[4:6] == [[("SOUND", "REPEAT")], [("SOUND", "BREAK")]]
    assert [arg["value"] for arg in entries[6]["operations"][0]["args"]] == [1, 440, 1000]
    assert told[7] == [("SOUND", "TONE")] * 4
    assert told[8] == [("SOUND", "TONE"), ("SOUND_READY", None)] * 3 + [("SOUND", "TONE")]
    lights = [op["args"][0]["symbol"] for op in entries[9]["operations"] if op["command"] == "LED"]
    assert lights == ["LED_RED", "LED_GREEN", "LED_RED", "LED_RED_FLASH", "LED_GREEN"]
    assert entries[9]["time"] == "11:39:49.039902"
    assert told[10] == [("UI_DRAW", "TOPLINE"), ("UI_DRAW", "BMPFILE"), ("UI_DRAW", "UPDATE")]
    assert told[11] == [("UI_DRAW", "TOPLINE"), ("UI_DRAW", "FILLWINDOW"), ("UI_DRAW", "UPDATE")]
    assert entries[12]["locals"] == 4
    assert [op for op in told[12] if op[0].startswith("TIMER")] == [("TIMER_WAIT", None), ("TIMER_READY", None)] * 3
    assert told[13:17] == [
        told[11],
        *([[("UI_DRAW", "LINE"), ("UI_DRAW", "UPDATE")]] * 3),
    ]
    assert told[17] == [("FILE", "LOAD_IMAGE"), ("PROGRAM_START", None)]
    assert entries[17]["locals"] == 8
    buttons = [op["args"][0]["symbol"] for op in entries[18]["operations"] if op["command"] == "PRESS"]
    assert buttons == ["BACK_BUTTON", "RIGHT_BUTTON", "ENTER_BUTTON"]
    assert told[19] == told[18]
    assert entries[19]["type"] == "DIRECT_COMMAND_REPLY"


def test_a_dialogue_in_a_log() -> None:
    log = "Sent 0x|08:00|01:00|00|04:00|81:01:60|\nRecv 0x|07:00|01:00|02|A4:70:FD:40|\n"
    done = run("decode", stdin=log)
    assert "UI_READ.GET_VBATT VALUE = 7.92 V" in done.stdout
    assert done.returncode == 0


def test_lines_that_are_cut() -> None:
    done = run(
        "decode",
        stdin="12:01:00.253855 Sent 0x|35:00|2A:00|80|00:00|84:12:00:84:1C:01:00:00:84:2E:2E:2F:61:70:70:...\n",
    )
    assert done.returncode == 0
    assert "22 bytes of 55: the text is cut here" in done.stdout
    assert "UI_DRAW.BMPFILE" in done.stdout
    assert '"../app..."' in done.stdout


def test_a_bad_frame_in_the_middle(tmp_path: Path) -> None:
    log = tmp_path / "robot.log"
    log.write_text(f"{TONE}\n06:00|01:00|80|00:00|FE\nSent 06:00|01:00|80|00:00|0g\n{TONE}\n")
    done = run("decode", "--json", str(log))
    assert done.returncode == 1
    entries = [json.loads(line) for line in done.stdout.splitlines()]
    assert [entry["counter"] for entry in entries] == [42, 1, 1, 42]
    assert entries[1]["fault"]["offset"] == 7
    assert f"{log}, line 2: fault at offset 7: unknown opcode 0xFE" in done.stderr
    assert f"{log}, line 3: " in done.stderr


def test_formats() -> None:
    assert run("decode", TONE, "--format", "asm").stdout.splitlines()[-1] == (
        "opSOUND, LC0(TONE), LC0(1), LC2(440), LC2(1000)"
    )
    assert "0x|0E:00|2A:00|80|00:00|94|01|01" in run("decode", TONE, "--format", "table").stdout
    assert run("decode", TONE, "--format", "json").stdout == run("decode", TONE, "--json").stdout


def test_options_that_say_the_same_twice() -> None:
    assert run("decode", "--json", "--format", "json", TONE).returncode == 0
    assert run("decode", "--dialogues", "--format", "json", TONE).returncode == 0
    assert run("check", "--json", "--format", "json", TONE).returncode == 0
    explained = run("check", "--explain", "E101", "--format", "json")
    assert json.loads(explained.stdout)["code"] == "E101"


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1"])
def test_files_in_the_encodings_that_people_have(tmp_path: Path, encoding: str) -> None:
    log = tmp_path / "log.txt"
    log.write_bytes(f"Käthes Log\r\nSent 0x|{TONE}\r\n".encode(encoding))
    done = run("decode", "--json", str(log))
    assert (done.returncode, done.stderr) == (0, "")
    assert json.loads(done.stdout)["hex"] == TONE_BYTES


def test_a_line_without_an_end(tmp_path: Path) -> None:
    log = tmp_path / "log.txt"
    log.write_text("00" * 3_000_000 + f"\n{TONE}\n")
    done = run("decode", "--json", str(log))
    assert done.returncode == 1
    assert len(done.stderr.splitlines()) == 1
    assert "line 1" in done.stderr
    assert json.loads(done.stdout)["hex"] == TONE_BYTES


def test_dialects() -> None:
    frame = "08:00|01:00|80|00:00|E6:60:61"
    assert run("decode", frame).returncode == 1
    assert "FILE_MD5SUM" in run("decode", "--dialect", "xtended", "09:00|01:00|80|00:00|E6:60:61:62").stdout


def test_ops_lists_searches_and_shows() -> None:
    shown = run("ops").stdout.splitlines()
    unreleased = [entry for entry in declarations(OPCODES) if not entry.dialects]
    assert len(shown) == len(operations()) + len(SYSTEM) + len(unreleased) + len(SystemStatus) + len(MessageType)
    assert len(run("ops", "--area", "sound").stdout.splitlines()) == 7
    found = run("ops", "battery").stdout
    assert "UI_READ.GET_VBATT" in found
    page = run("ops", "sound.tone").stdout
    assert "opcode 0x94, CMD 1; starts with 94 01" in page
    assert "250 to 10000 Hz" in page
    assert run("ops", "SOUND", "TONE").stdout == page
    entry = json.loads(run("ops", "--json", "sound.tone").stdout)
    assert [parameter["name"] for parameter in entry["parameters"]] == ["VOLUME", "FREQUENCY", "DURATION"]
    assert "list_size" in run("ops", "LIST_FILES").stdout


def test_colours_on_a_terminal_only(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NO_COLOR", raising=False)
    assert "\x1b[" in on_a_terminal("decode", TONE)[1]
    monkeypatch.setenv("NO_COLOR", "1")
    assert "\x1b[" not in on_a_terminal("decode", TONE)[1]
    assert "\x1b[" not in run("decode", TONE).stdout
