"""`check` with other tools and in programs: exit status, SARIF, GitHub's annotations, reports as text, fixes."""

from __future__ import annotations

import json
import re
from pathlib import Path
from urllib.parse import unquote

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.careful import careful_frames
from support.cli import run_ev3proto
from support.effort import effort
from support.messages import frame_of
from support.packets import RAW_IP, Capture, Connection

import ev3proto
from ev3proto.checking.codes import CODES
from ev3proto.checking.program_codes import PROGRAM_CODES
from ev3proto.program import check_program

REFUSED = "09:00|2A:00|80|00:00|81|01|60|"
FINE = "06:00|2A:00|00|00:00|01|"
MISALIGNED = "08:00|2A:00|00|08:00|81|01|61|"
MANY = f"{FINE}\n{MISALIGNED}\n{REFUSED}\n{FINE}\n"


def check(*words: str, stdin: str = "") -> tuple[int, str]:
    done = run_ev3proto("check", *words, stdin=stdin.encode())
    return done.returncode, done.stdout.decode()


def capture_of(*frames: str) -> bytes:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    for frame in frames:
        connection.send(frame_of(frame))
    return capture.data()


BROKEN_PROGRAM = b"LEGO" + bytes(12)
SOURCE = "vmthread MAIN\n{\n  SOUND(TOEN,1,440,1000)\n}\n"
"""A program's source with a misspelt name in its third line."""


@pytest.mark.parametrize(
    "words",
    [[], ["--quiet"], ["--errors-only"], ["--no-hints"], ["--strict"], ["--json"], ["--json", "--quiet"], ["--fix"]]
    + [["--format", style, *more] for style in ("text", "json", "sarif", "github") for more in ([], ["--errors-only"])],
    ids=" ".join,
)
def test_a_refused_frame_is_exit_status_1_whatever_is_shown(words: list[str], tmp_path: Path) -> None:
    log, capture = tmp_path / "robot.log", tmp_path / "robot.pcap"
    log.write_text(f"{FINE}\n{BEYOND_FIXING}\n")
    capture.write_bytes(capture_of(FINE, BEYOND_FIXING))
    assert check(*words, BEYOND_FIXING)[0] == 1
    assert check(*words, FINE)[0] == 0
    assert check(*words, FINE, BEYOND_FIXING)[0] == 1
    assert check(*words, str(log))[0] == 1
    assert check(*words, str(capture))[0] == 1
    assert check(*words, FINE, str(capture), str(log))[0] == 1
    if "--fix" not in words:
        program, source = tmp_path / "robot.rbf", tmp_path / "robot.lms"
        program.write_bytes(BROKEN_PROGRAM)
        source.write_text(SOURCE)
        assert check(*words, str(program))[0] == 1
        assert check(*words, str(source))[0] == 1


BEYOND_FIXING = "08:00|2A:00|80|00:00|94|07|01|"
"""An unknown CMD: the intended one is unknown."""


def test_errors_only_and_quiet_among_many_frames() -> None:
    for words in ([], ["--strict"]):
        assert check(*words, "--quiet", "-", stdin=MANY)[0] == 1
    status, shown = check("--errors-only", "-", stdin=MANY)
    assert status == 1
    assert "line 1" not in shown
    assert "line 4" not in shown
    assert "line 3" in shown
    assert not re.search(r"^(warning|hint)\[", shown, re.MULTILINE)
    assert shown.splitlines()[-1].startswith("4 frames: ")
    status, shown = check("--quiet", "-", stdin=MANY)
    assert status == 1
    assert len(shown.splitlines()) == 1
    assert shown.startswith("4 frames: ")
    assert check("--quiet", FINE) == (0, "1 frame: 0 errors, 0 warnings, 0 hints\n")
    status, shown = check("--json", "--errors-only", "-", stdin=MANY)
    entries = [json.loads(line) for line in shown.splitlines()]
    assert [entry["line"] for entry in entries] == [2, 3]
    assert {finding["severity"] for entry in entries for finding in entry["findings"]} == {"error"}
    status, shown = check("--json", "--quiet", "-", stdin=MANY)
    assert json.loads(shown) == {
        "frames": 4,
        "programs": 0,
        "replies": 0,
        "cut": 0,
        "errors": 3,
        "warnings": 1,
        "hints": 0,
    }


def test_programs_are_counted_as_such(tmp_path: Path) -> None:
    program = tmp_path / "robot.rbf"
    program.write_bytes(BROKEN_PROGRAM)
    assert check("--quiet", str(program))[1].startswith("1 program: ")
    status, shown = check("--quiet", str(program), FINE)
    assert (status, len(shown.splitlines())) == (1, 1)
    assert shown.startswith("1 frame and 1 program: ")


@pytest.mark.parametrize("words", [["--quiet", "--format", "sarif"], ["--json", "--format", "github"]], ids=" ".join)
def test_two_forms_of_output_at_once_are_refused(words: list[str]) -> None:
    assert check(*words, FINE)[0] == 2


ANNOTATION = re.compile(r"::(error|warning|notice) (\w+=[^:,]*(?:,\w+=[^:,]*)*)::(.+)")


def annotations_in(text: str) -> list[tuple[str, dict[str, str], str]]:
    """Returns GitHub's reading of the lines of a workflow."""
    found = []
    for line in text.splitlines():
        read = ANNOTATION.fullmatch(line)
        assert read is not None, line
        places = dict(part.split("=", 1) for part in read[2].split(","))
        found.append((read[1], {name: unquote(value) for name, value in places.items()}, unquote(read[3])))
    return found


def test_annotations_of_github(tmp_path: Path) -> None:
    path = tmp_path / "100% of, the: robot.log"
    path.write_text(f"{FINE}\n  sent: {MISALIGNED}\n{REFUSED}\n{FINE}\n")
    status, shown = check("--format", "github", str(path))
    assert status == 1
    found = annotations_in(shown)
    assert {place["file"] for _, place, _ in found} == {str(path)}
    assert f"file={path}" not in shown
    assert [(kind, place["line"], place["title"]) for kind, place, _ in found if kind == "error"] == [
        ("error", "2", "E205"),
        ("error", "3", "E102"),
        ("error", "3", "E402"),
    ]
    assert found[0][1]["col"] == "9"


def test_annotations_of_captures_and_programs(tmp_path: Path) -> None:
    capture, program, source = tmp_path / "robot.pcap", tmp_path / "robot.rbf", tmp_path / "robot.lms"
    capture.write_bytes(capture_of(FINE, MISALIGNED))
    program.write_bytes(BROKEN_PROGRAM)
    source.write_text(SOURCE)
    kind, place, sentence = annotations_in(check("--format", "github", str(capture))[1])[0]
    assert (kind, place, sentence[:10]) == ("error", {"file": str(capture), "title": "E205"}, "packet 2, ")
    kind, place, sentence = annotations_in(check("--format", "github", str(program))[1])[0]
    assert (kind, place["file"], place["title"][0]) == ("error", str(program), "E")
    kind, place, sentence = annotations_in(check("--format", "github", str(source))[1])[0]
    assert (kind, place["file"], place["line"], place["title"]) == ("error", str(source), "3", "source")


def test_what_cannot_be_read_is_annotated_too() -> None:
    text = f"{FINE}\nsent 0f 00 2a 00 80 00 00 94 01\n{FINE[:-3]}\n"
    status, shown = check("--format", "github", "-", stdin=text)
    assert status == 1
    assert annotations_in(shown)
    run = json.loads(check("--format", "sarif", "nothing.log")[1])["runs"][0]
    assert run["invocations"][0]["executionSuccessful"] is False


def test_sarif(tmp_path: Path) -> None:
    log, program, source = tmp_path / "100% robot.log", tmp_path / "robot.rbf", tmp_path / "robot.lms"
    log.write_text(MANY)
    program.write_bytes(BROKEN_PROGRAM)
    source.write_text(SOURCE)
    capture = tmp_path / "robot.pcap"
    capture.write_bytes(capture_of(FINE, MISALIGNED))
    status, shown = check("--format", "sarif", str(log), str(program), str(source), str(capture), REFUSED)
    assert status == 1
    found = json.loads(shown)
    (run,) = found["runs"]
    assert (found["version"], run["tool"]["driver"]["name"]) == ("2.1.0", "ev3proto")
    rules = {rule["id"] for rule in run["tool"]["driver"]["rules"]}
    assert {result["ruleId"] for result in run["results"]} == rules
    assert {"E205", "E102", "source"} < rules
    places = [result["locations"][0]["physicalLocation"] for result in run["results"] if "locations" in result]
    files = {unquote(place["artifactLocation"]["uri"]) for place in places}
    assert files == {str(path) for path in (log, program, source, capture)}
    in_log = [place for place in places if unquote(place["artifactLocation"]["uri"]) == str(log)]
    assert {place["region"]["startLine"] for place in in_log} == {2, 3}
    clean = json.loads(check("--format", "sarif", FINE)[1])
    assert clean["runs"][0]["results"] == []


def test_every_code_has_a_rule_in_sarif() -> None:
    for entry in CODES.values():
        words = ["--carrier", entry.carrier] if entry.carrier else []
        run = json.loads(check("--format", "sarif", *words, entry.example.hex(" "))[1])["runs"][0]
        for rule in run["tool"]["driver"]["rules"]:
            title = CODES[rule["id"]].title if rule["id"] in CODES else "refused by the brick"
            assert rule["shortDescription"]["text"] == title


def test_a_program_report_as_text_is_what_the_command_prints(tmp_path: Path) -> None:
    for name in ("E001", "W001"):
        code = PROGRAM_CODES.get(name) or next(iter(PROGRAM_CODES.values()))
        program = tmp_path / "robot.rbf"
        program.write_bytes(code.example)
        assert str(check_program(code.example)) + "\n" == check(str(program))[1]
    with pytest.raises(ValueError, match="only frames can be fixed"):
        _ = check_program(BROKEN_PROGRAM).fixed


@st.composite
def with_a_fault(draw: st.DrawFn) -> bytes:
    """A careful frame with a few changed bytes; its length field may be too large, but not too small.

    With another type and another length, the command may take it for operations without a header.
    """
    frame = bytearray(draw(careful_frames()))
    kind = frame[4]
    for _ in range(draw(st.integers(0, 3))):
        frame[draw(st.integers(4, len(frame) - 1))] = draw(st.integers(0, 255))
    if frame[4] == kind and draw(st.booleans()):
        del frame[draw(st.integers(max(7, len(frame) - 3), len(frame))) :]
    return bytes(frame)


few = settings(max_examples=effort(40, 1000), deadline=None)


@few
@given(with_a_fault())
def test_reports_as_text_of_drawn_faults(frame: bytes) -> None:
    report = ev3proto.check(frame)
    assert str(ev3proto.check(frame, alone=True)) + "\n" == check(frame.hex(" "))[1]
    assert check("--quiet", frame.hex(" "))[0] == (1 if not report.accepted or report.errors else 0)
    assert ev3proto.check(ev3proto.parse(frame, strict=False)) == report


@few
@given(with_a_fault())
def test_fixes_of_drawn_faults_are_those_of_the_command(frame: bytes) -> None:
    fixed = ev3proto.fix(frame)
    assert ev3proto.check(frame).fixed == fixed
    assert ev3proto.fix(ev3proto.parse(frame, strict=False)) == fixed
    status, shown = check("--fix", "--json", frame.hex(" "))
    assert json.loads(shown) == fixed.as_dict()
    assert status == (1 if not fixed.report.accepted or fixed.report.errors else 0)
    assert str(fixed) + "\n" == check("--fix", frame.hex(" "))[1]
