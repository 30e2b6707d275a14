"""The output of --json is as described in exports/ev3-output.schema.json, key by key."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator  # type: ignore[import-untyped]
from support.built import built_export
from support.cli import run_ev3proto_text as run
from support.effort import effort
from support.frames import drawn

from ev3proto.testing import frames, mutated_frames

ROOT = Path(__file__).parents[2]
SCHEMA = json.loads(built_export("ev3-output.schema.json").read_text(encoding="utf-8"))
CAPTURES = sorted(
    path.relative_to(ROOT).as_posix()
    for path in (ROOT / "captures").iterdir()
    if path.suffix in (".pcap", ".pcapng", ".log")
)
TONE = "0e002a0080000094010182b80182e803"


@cache
def validator(name: str) -> Any:
    # Without the part that says that any command may have printed it.
    definitions = {key: value for key, value in SCHEMA.items() if key != "anyOf"}
    return Draft202012Validator({**definitions, "$ref": f"#/$defs/{name}"})


def printed(command: str, *words: str, stdin: str = "") -> list[Any]:
    """The objects that a command prints, each of which is valid by its schema."""
    lines = [json.loads(line) for line in run(command, "--json", *words, stdin=stdin).stdout.splitlines()]
    for line in lines:
        # A message of the wrong kind fits no alternative; that of its own kind gives the reason.
        kind = line.get("kind", command) if command == "decode" else command
        name = kind if kind in SCHEMA["$defs"] else command
        validator(name).validate(line)
        validator(command).validate(line)
    return lines


def test_the_schema_is_one() -> None:
    Draft202012Validator.check_schema(SCHEMA)


@pytest.mark.parametrize("capture", CAPTURES)
def test_output_for_captures(capture: str) -> None:
    assert len(printed("decode", capture)) > 2
    assert len(printed("stats", capture)) == 1
    for words in (["--dialogues"], ["--engine", "builtin", "--filter", "error"]):
        printed("decode", *words, capture)


@pytest.mark.parametrize("capture", ["captures/wifi.pcapng", "captures/daisy.pcap", "captures/lesson-02.log"])
def test_output_of_check_and_values_for_captures(capture: str) -> None:
    assert len(printed("check", capture)) > 2
    assert len(printed("check", "--fix", capture)) > 2
    printed("values", capture)


@pytest.mark.parametrize("strategy", [frames(), mutated_frames()])
def test_output_for_any_frame(strategy: Any) -> None:
    lines = "\n".join(frame.hex() for frame in drawn(strategy, effort(150, 3000)) if frame)
    assert len(printed("decode", stdin=lines)) > 50
    printed("check", stdin=lines)
    printed("check", "--fix", stdin=lines)


def test_output_of_decode_for_a_faulty_frame() -> None:
    (line,) = printed("decode", TONE[:-2])
    assert line["fault"]["offset"] == 0


def test_output_for_programs(tmp_path: Path) -> None:
    image = tmp_path / "robot.rbf"
    source = "vmthread MAIN { CALL(HELPER, 1) } subcall HELPER { IN_8 N SOUND(TONE, 1, 440, 1000) SOUND_READY() }"
    (tmp_path / "robot.lms").write_text(source)
    assert run("encode", str(tmp_path / "robot.lms"), "-o", str(image)).returncode == 0
    (line,) = printed("decode", str(image))
    assert [part["kind"] for part in line["objects"]] == ["vmthread", "subcall"]
    assert len(printed("check", str(image))) == 1
    (tmp_path / "spoilt.lms").write_text(source.replace("TONE", "TOEN"))
    (line,) = printed("check", str(tmp_path / "spoilt.lms"))
    assert [finding["code"] for finding in line["findings"]] == ["source"]


@pytest.mark.parametrize(
    ("name", "wrong"),
    [
        ("decode", {"kind": "x", "hex": ""}),
        ("decode", {"kind": "unknown", "hex": "", "invented": 1}),
        ("check", {"accepted": 1}),
        ("check", {"accepted": True, "rejected_at": None, "findings": [], "hex": "", "invented": 1}),
        ("stats", {"whole": {}}),
        ("values", {"time": "now", "packet": 1, "peer": "", "values": {}}),
    ],
)
def test_something_else_is_refused(name: str, wrong: object) -> None:
    assert not validator(name).is_valid(wrong)


def test_an_unknown_key_is_refused_at_any_level() -> None:
    (message,) = printed("decode", TONE)
    (counted,) = printed("stats", "captures/daisy.pcap")
    for name, whole, place in (
        ("decode", message, message),
        ("decode", message, message["operations"][0]),
        ("decode", message, message["operations"][0]["args"][0]),
        ("stats", counted, counted),
        ("stats", counted, counted["whole"]["operations"][0]),
        ("stats", counted, counted["account"]),
    ):
        assert validator(name).is_valid(whole)
        place["invented"] = 1
        assert not validator(name).is_valid(whole)
        del place["invented"]
