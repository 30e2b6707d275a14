"""`ev3proto check` as a user types it: output, errors, exit status."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest
from support.cli import run_ev3proto, run_ev3proto_text
from support.packets import RAW_IP, Capture, Connection

ROOT = Path(__file__).parents[2]
CAPTURES = ROOT / "captures"
VOLTAGE = "08:00|2A:00|00|04:00|81|01|60|"
VOLTAGE_BYTES = "08002a00000400810160"
MISALIGNED = "08:00|2A:00|00|08:00|81|01|61|"
TOO_LONG = "0B:00|2A:00|00|04:00|81|01|60|"
VOLTS = "0700010002a470fd40"


def run(*words: str, stdin: bytes | str = b"") -> subprocess.CompletedProcess[str]:
    return run_ev3proto_text("check", *words, stdin=stdin)


def entries(*words: str, stdin: bytes | str = b"") -> list[dict[str, Any]]:
    return [json.loads(line) for line in run("--json", *words, stdin=stdin).stdout.splitlines()]


def test_json() -> None:
    done = run("--json", VOLTAGE)
    assert json.loads(done.stdout) == {"accepted": True, "rejected_at": None, "findings": [], "hex": VOLTAGE_BYTES}
    (entry,) = entries(MISALIGNED)
    assert (entry["accepted"], entry["rejected_at"]) == (False, 7)
    (finding,) = (found for found in entry["findings"] if found["severity"] == "error")
    assert (finding["offset"], finding["length"]) == (9, 1)
    assert (finding["operation"], finding["parameter"]) == ("UI_READ.GET_VBATT", "VALUE")
    assert {"code", "message", "help"} < set(finding)


def test_a_log_with_good_and_bad_frames(tmp_path: Path) -> None:
    log = tmp_path / "robot.log"
    log.write_text(f"Sent 0x|{VOLTAGE}\nRecv 0x|07:00|2A:00|02|A4:70:FD:40|\nhello\nSent 0x|{MISALIGNED}\n")
    done = run(str(log))
    assert done.returncode == 1
    lines = done.stdout.splitlines()
    assert lines[0] == f"{log}, line 1: accepted: no findings"
    assert lines[1] == ""
    assert lines[2].startswith(f"{log}, line 4: the brick refuses it at offset 7; ")
    assert lines[-1].startswith("2 frames: 1 error, ")
    assert lines[-1].endswith("; 1 frame from the brick not checked")
    first, second = entries(str(log))
    assert (first["source"], first["line"], second["line"]) == (str(log), 1, 4)


def test_the_lesson_has_no_errors() -> None:
    done = run(str(CAPTURES / "lesson-02.log"))
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines()[-1].startswith("19 frames: 0 errors, ")


def test_a_capture_tells_its_packets_and_its_carrier() -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(bytes.fromhex(VOLTAGE_BYTES))
    connection.receive(bytes.fromhex(VOLTS))
    connection.send(bytes.fromhex(MISALIGNED.replace("|", "").replace(":", "")))
    good, bad = entries(stdin=capture.data())
    assert (good["source"], good["packet"], good["accepted"]) == ("standard input", 1, True)
    assert (bad["packet"], bad["accepted"]) == (3, False)
    done = run("--filter", "packet==1", stdin=capture.data())
    assert (done.returncode, done.stdout) == (0, "standard input, packet 1: accepted: no findings\n")


def test_a_capture_without_commands() -> None:
    capture = Capture(RAW_IP)
    Connection(capture).receive(bytes.fromhex(VOLTS))
    done = run(stdin=capture.data())
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == (
        "standard input: no command in 1 packet; 1 packet on TCP port 5555 was not recognised; --port 5555 shows it as"
        " it is\n"
    )


def test_warnings_count_when_that_is_asked_for() -> None:
    frame = "06:00|01:00|80|04:00|01"  # unused global memory
    entry = entries(frame)[0]
    assert {found["severity"] for found in entry["findings"]} == {"warning"}
    assert run(frame).returncode == 0
    assert run("--strict", frame).returncode == 1


def test_findings_that_are_not_shown() -> None:
    frame = "0A:00|01:00|00|04:00|81|81:01|E1:00|"  # two long encodings
    assert {found["severity"] for found in entries(frame)[0]["findings"]} == {"hint"}
    assert entries("--no-hints", frame)[0]["findings"] == []
    done = run("--no-hints", frame)
    assert (done.returncode, done.stdout) == (0, "the brick accepts it; 2 hints (2 not shown)\n")
    assert "hint[" in run(frame).stdout
    assert "error[" in run("--errors-only", MISALIGNED).stdout


# Fixes


def test_a_fixed_frame() -> None:
    done = run("--fix", TOO_LONG)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == [
        "fixed in 1 place",
        "0x|08:00|2A:00|00|04:00|81|01|60|",
        "  length field: 0B -> 08 (the length field says that 11 bytes follow it, but there are 8: 8 is written 08 00)",
        "fixed: accepted: no findings",
    ]


def test_a_fixed_frame_as_json() -> None:
    (entry,) = entries("--fix", TOO_LONG)
    assert (entry["hex"], entry["accepted"], entry["findings"]) == (VOLTAGE_BYTES, True, [])
    (change,) = entry["changes"]
    assert (change["what"], change["after"]) == ("length field", "08")
    assert entry["unfixed"] == []


def test_a_text_is_printed_with_its_frames_fixed(tmp_path: Path) -> None:
    text = (
        b"# \xe9t\xe9: a log\r\n\t12:00:01 Sent 0x|%s  # volts\r\nRecv 0x|07:00|2A:00|02|A4:70:FD:40|\r\nTX 0x|%s\r\n"
    )
    log = tmp_path / "robot.log"
    log.write_bytes(text % (TOO_LONG.encode(), MISALIGNED.encode()))
    for words, stdin in (([str(log)], b""), (["--quiet", str(log)], b""), ([], log.read_bytes())):
        done = run_ev3proto("check", "--fix", *words, stdin=stdin)
        assert (done.returncode, done.stdout) == (1, text % (VOLTAGE.encode(), MISALIGNED.encode()))
        assert done.stderr.endswith(b"2 frames: 1 error, 0 warnings, 0 hints; 1 frame from the brick not checked\n")
    said = run_ev3proto("check", "--fix", str(log)).stderr
    assert b"robot.log, line 2: fixed in 1 place\n" in said
    assert b"robot.log, line 4: nothing could be fixed\n" in said


def test_a_frame_and_a_text_are_fixed_in_their_order(tmp_path: Path) -> None:
    (tmp_path / "robot.log").write_text("sent 09 00 2a 00 80 00 00 01\n")
    done = run("--fix", "06002a0080000001", str(tmp_path / "robot.log"))
    assert (done.returncode, done.stdout.splitlines()) == (
        0,
        [
            "frame 1: nothing to fix",
            "0x|06:00|2A:00|80|00:00|01|",
            "frame 1: accepted: no findings",
            "sent 06 00 2a 00 80 00 00 01",
        ],
    )
    assert done.stderr.splitlines()[-1] == "2 frames: 0 errors, 0 warnings, 0 hints"


def test_a_fixed_text_can_be_given_on() -> None:
    first = run("--fix", stdin=f"{TOO_LONG}\n{VOLTAGE}\n")
    assert (first.returncode, first.stdout) == (0, f"{VOLTAGE}\n{VOLTAGE}\n")
    again = entries(stdin=first.stdout)
    assert [entry["hex"] for entry in again] == [VOLTAGE_BYTES] * 2
    assert all(entry["accepted"] for entry in again)


def test_a_text_as_json_has_one_object_for_each_frame() -> None:
    first, second = entries("--fix", stdin=f"{TOO_LONG}\n{VOLTAGE}\n")
    assert [(each["hex"], each["line"], each["fixed"]) for each in (first, second)] == [
        (VOLTAGE_BYTES, 1, True),
        (VOLTAGE_BYTES, 2, False),
    ]


def test_a_frame_that_cannot_be_edited_is_shown() -> None:
    dump = (
        "00000000  0f 00 2a 00 80 00 00 94  01 81 05 82 b8 01 82 e8  |..*.............|\n"
        "00000010  03                                                |.|\n"
    )
    done = run("--fix", stdin=dump)
    assert done.stdout == dump
    lines = done.stderr.splitlines()
    assert lines[0] == "standard input, line 1: could be fixed in 1 place"
    assert lines[1] == "0x|0E:00|2A:00|80|00:00|94|01|05|82:B8:01|82:E8:03|"
    assert lines[2] == "  the text is unchanged here: its notation cannot be edited"


# Codes


def test_every_code_can_be_explained() -> None:
    listed = run("--explain", "all")
    codes = [line.split()[0] for line in listed.stdout.splitlines()]
    assert len(codes) == len(set(codes)) > 10
    for code, example in (("E101", "example: 0x|"), ("E001", "example: 4C 45 47 4F ")):
        assert code in codes
        done = run("--explain", code.lower())
        assert done.returncode == 0
        assert f"[{code}]: " in done.stdout
        assert example in done.stdout
        assert json.loads(run("--json", "--explain", code).stdout)["code"] == code
    entry = json.loads(run("--json", "--explain", "E101").stdout)
    assert "E101" in [found["code"] for found in entries(entry["example"])[0]["findings"]]


@pytest.mark.parametrize(
    ("frame", "complaint"),
    [
        ("Recv 0x|07:00|2A:00|02|A4:70:FD:40|", "only 1 frame from the brick"),
        ("Sent 0x|0E:00|2A:00|80|00:00|94|01|...", "a frame that is cut off after 9 bytes"),
    ],
)
def test_what_is_not_a_whole_command(frame: str, complaint: str) -> None:
    done = run(frame)
    assert (done.returncode, done.stdout) == (1, "")
    assert complaint in done.stderr


def test_several_frames_on_the_command_line() -> None:
    done = run(VOLTAGE, "0600010080000001")
    assert done.stdout.splitlines() == [
        "frame 1: accepted: no findings",
        "frame 2: accepted: no findings",
        "2 frames: 0 errors, 0 warnings, 0 hints",
    ]


SPOILT_SOURCE = "vmthread MAIN\n{\n  FOO(1)\n  DATA8 x\n  DATA8 x\n}\n"
"""An unknown operation, and a variable that is declared twice."""

SOURCE_WITH_A_WARNING = "vmthread MAIN\n{\n  DATA8 x\n  MOVE8_8(300, x)\n}\n"
"""300 is more than a DATA8 can be."""


def test_json_has_what_is_wrong_with_a_source(tmp_path: Path) -> None:
    source = tmp_path / "robot.lms"
    source.write_text(SPOILT_SOURCE)
    (entry,) = entries(str(source))
    assert (entry["source"], entry["accepted"], entry["rejected_at"], entry["hex"]) == (str(source), False, None, "")
    assert entry["findings"] == [
        {
            "severity": "error",
            "code": "source",
            "offset": 0,
            "length": 0,
            "message": "unknown operation FOO",
            "help": "change line 3 of the source",
            "line": 3,
            "column": 3,
        },
        {
            "severity": "error",
            "code": "source",
            "offset": 0,
            "length": 0,
            "message": "x is declared already",
            "help": "change line 5 of the source",
            "line": 5,
            "column": 9,
        },
    ]
    assert run("--json", str(source)).returncode == 1


def test_json_has_what_a_source_is_warned_of(tmp_path: Path) -> None:
    source = tmp_path / "robot.lms"
    source.write_text(SOURCE_WITH_A_WARNING)
    (entry,) = entries(str(source))
    assert entry["hex"].startswith("4c45474f")
    warning = entry["findings"][0]
    assert (warning["severity"], warning["code"], warning["line"], warning["column"]) == ("warning", "source", 4, 11)
    assert warning["message"].endswith("which reaches from -127 to 127: it cannot be 300")
    (entry,) = entries("--errors-only", str(source))
    assert "source" not in [finding["code"] for finding in entry["findings"]]


@pytest.mark.parametrize(
    ("stdin", "complaint"), [("", "standard input: no frame found"), (VOLTS, "no command found, only 1 frame from")]
)
def test_no_frame_at_all(stdin: str, complaint: str) -> None:
    done = run("--quiet", stdin=stdin)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith(complaint)


def test_replies_in_plain_hex_are_passed_over() -> None:
    done = run("-", stdin=b"07002a00020000d041\n08000100000400810160\n")
    assert done.returncode == 0
    assert "1 frame from the brick not checked" in done.stdout


# Assembly


def test_assembly_that_is_typed() -> None:
    done = run("UI_READ(GET_VBATT, GV0(0))")
    assert (done.returncode, done.stdout, done.stderr) == (0, "accepted: no findings\n", "")
    done = run("--json", "UI_READ(GET_VBATT, GV0(1))")
    assert done.returncode == 1
    assert [finding["code"] for finding in json.loads(done.stdout)["findings"]] == ["E205"]


def test_assembly_that_cannot_be_read_is_shown_as_send_shows_it() -> None:
    done = run("UI_READ(..)")
    assert (done.returncode, done.stdout) == (1, "")
    sent = run_ev3proto_text("send", "virtual", "UI_READ(..)")
    assert done.stderr == sent.stderr
    assert done.stderr.startswith("line 1, column 9: ")


def test_assembly_in_a_file(tmp_path: Path) -> None:
    """Commands are checked one by one, and replies skipped, as in a log."""
    file = tmp_path / "robot.asm"
    file.write_text(
        run_ev3proto_text("decode", "--format", "asm", "06002a0000000001", "03002a0002", "08000100000500810161").stdout
    )
    done = run("--json", str(file))
    assert [json.loads(line)["accepted"] for line in done.stdout.splitlines()] == [True, False]
    assert f"{file}, frame 3: the brick refuses it at offset 7" in run(str(file)).stdout


def test_a_log_whose_first_line_looks_like_an_operation() -> None:
    done = run(stdin="INFO(main): sent 0x|06:00|2A:00|00|00:00|01|\n")
    assert (done.returncode, done.stderr) == (0, "")
    assert "accepted" in done.stdout
