"""`check` among other tools and in programs: exit status, SARIF, GitHub's annotations, reports as text, fixes."""

from __future__ import annotations

import json

import pytest
from support.cli import run_ev3proto

import ev3proto
from ev3proto.checking.codes import CODES

REFUSED = "09:00|2A:00|80|00:00|81|01|60|"
FINE = "06:00|2A:00|00|00:00|01|"
MISALIGNED = "08:00|2A:00|00|08:00|81|01|61|"
MANY = f"{FINE}\n{MISALIGNED}\n{REFUSED}\n{FINE}\n"


def check(*words: str, stdin: str = "") -> tuple[int, str]:
    done = run_ev3proto("check", *words, stdin=stdin.encode())
    return done.returncode, done.stdout.decode()


@pytest.mark.parametrize("code", CODES)
def test_a_refused_frame_is_exit_status_1(code: str) -> None:
    entry = CODES[code]
    for frame in (entry.example, entry.counterexample):
        if int.from_bytes(frame[:2], "little") + 2 < len(frame):
            # The command line takes what follows a frame for padding, or for the next one.
            continue
        report = ev3proto.check(frame, carrier=entry.carrier)
        words = ["--carrier", entry.carrier] if entry.carrier else []
        status, _ = check(*words, frame.hex(" "))
        assert status == (1 if not report.accepted or report.errors else 0)


def test_errors_only_and_quiet_among_many_frames() -> None:
    status, shown = check("--errors-only", "-", stdin=MANY)
    assert status == 1
    assert "line 1" not in shown
    assert "line 4" not in shown
    assert "line 3" in shown
    assert shown.splitlines()[-1].startswith("4 frames: ")
    status, shown = check("--quiet", "-", stdin=MANY)
    assert status == 1
    assert len(shown.splitlines()) == 1
    assert shown.startswith("4 frames: ")
    assert check("--quiet", FINE) == (0, "1 frame: 0 errors, 0 warnings, 0 hints\n")


def test_annotations_of_github(tmp_path: pytest.TempPathFactory) -> None:
    path = f"{tmp_path}/robot.log"
    with open(path, "w") as file:  # noqa: PTH123 - a path as the workflow gives it
        file.write(MANY)
    status, shown = check("--format", "github", path)
    assert status == 1
    lines = shown.splitlines()
    assert all(line.startswith(("::error ", "::warning ", "::notice ")) for line in lines)
    assert any(f"file={path},line=3,title=E" in line for line in lines)


def test_sarif() -> None:
    status, shown = check("--format", "sarif", "-", stdin=MANY)
    assert status == 1
    log = json.loads(shown)
    assert log["version"] == "2.1.0"
    (run,) = log["runs"]
    rules = {rule["id"] for rule in run["tool"]["driver"]["rules"]}
    assert {result["ruleId"] for result in run["results"]} == rules
    assert {result["locations"][0]["physicalLocation"]["region"]["startLine"] for result in run["results"]} >= {2, 3}
    assert json.loads(check("--format", "sarif", FINE)[1])["runs"][0]["results"] == []


def test_a_report_as_text_is_what_the_command_prints() -> None:
    for frame in (REFUSED, FINE, MISALIGNED):
        data = bytes.fromhex(frame.replace(":", "").replace("|", ""))
        report = ev3proto.check(data)
        assert str(report) + "\n" == check(frame)[1]
        assert ev3proto.check(ev3proto.parse(data, strict=False)) == report


def test_fixes_in_python() -> None:
    data = bytes.fromhex(REFUSED.replace(":", "").replace("|", ""))
    fixed = ev3proto.fix(data)
    assert fixed.frame == bytes.fromhex("08002a00000400810160")
    assert fixed.report.accepted
    assert ev3proto.check(data).fixed == fixed
    assert ev3proto.fix(ev3proto.parse(data, strict=False)) == fixed
