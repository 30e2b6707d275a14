"""What the command line prints with --json is what exports/ev3-output.schema.json says."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator  # type: ignore[import-untyped]
from support.cli import run_ev3proto_text as run

ROOT = Path(__file__).parent.parent
SCHEMA = json.loads((ROOT / "exports" / "ev3-output.schema.json").read_text(encoding="utf-8"))
CAPTURES = ("wifi.pcapng", "usb-bootloader.pcapng", "bluetooth.log", "daisy.pcap", "lesson-02.log")


def validator(name: str) -> Any:
    return Draft202012Validator({**SCHEMA, "anyOf": [{"$ref": f"#/$defs/{name}"}]})


def test_the_schema_is_one() -> None:
    Draft202012Validator.check_schema(SCHEMA)


@pytest.mark.parametrize("capture", CAPTURES)
def test_what_decode_prints(capture: str) -> None:
    check = validator("decode")
    lines = [json.loads(line) for line in run("decode", "--json", f"captures/{capture}").stdout.splitlines()]
    frames = [line for line in lines if line["kind"] not in ("beacon", "answer", "unlock", "accept")]
    assert len(frames) > 5
    for line in frames:
        check.validate(line)


def test_what_decode_prints_of_a_faulty_frame() -> None:
    (line,) = run("decode", "--json", "0E002A0080000094010182B80182E8").stdout.splitlines()
    validator("decode").validate(json.loads(line))
    assert json.loads(line)["fault"]["offset"] == 0


def test_what_check_prints() -> None:
    for line in run("check", "--json", "captures/wifi.pcapng").stdout.splitlines():
        validator("check").validate(json.loads(line))


def test_what_stats_prints() -> None:
    validator("stats").validate(json.loads(run("stats", "--json", "captures/wifi.pcapng").stdout))


@pytest.mark.parametrize(("name", "wrong"), [("decode", {"kind": "x", "hex": ""}), ("check", {"accepted": 1})])
def test_something_else_is_refused(name: str, wrong: object) -> None:
    assert not validator(name).is_valid(wrong)
