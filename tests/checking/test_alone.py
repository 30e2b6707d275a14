"""Hints about a frame that is tried by itself; none of them where a frame is among others."""

from __future__ import annotations

import json

import pytest
from support.cli import run_ev3proto_text

import ev3proto
from ev3proto.checking.report import Finding
from ev3proto.schema.header import with_length

SPEED_WITHOUT_START = "09 00 2A 00 80 00 00 A5 00 01 1E"


def findings(operations: str, memory: str = "00 00", kind: str = "80", *, alone: bool = True) -> list[Finding]:
    frame = with_length(bytes.fromhex(f"2A 00 {kind} {memory} {operations}"))
    return list(ev3proto.check(frame, alone=alone).findings)


@pytest.mark.parametrize(
    ("operations", "code", "message", "help_"),
    [
        (
            "A5 00 01 1E",
            "H701",
            "OUTPUT_SPEED starts no motor: it sets what OUTPUT_START starts them with",
            "put OUTPUT_START (0xA6) after it, unless the motors run already or a later command starts them",
        ),
        (
            "B2 00 00",
            "H702",
            "NOS is 0, a bit mask without a port, so OUTPUT_CLR_COUNT does nothing",
            "use 1 for A, 2 for B, 4 for C, 8 for D, or the sum of several",
        ),
        (
            "A5 00 01 32 A6 00 01",
            "H708",
            "SPEED is -14 %, backward: that is what 32 by itself means",
            "50 is written 81 32",
        ),
        (
            "A4 00 01 28 A6 00 01",
            "H708",
            "POWER is -24 %, backward: that is what 28 by itself means",
            "40 is written 81 28",
        ),
    ],
)
def test_a_hint(operations: str, code: str, message: str, help_: str) -> None:
    assert [(each.code, each.message, each.help) for each in findings(operations)] == [(code, message, help_)]
    assert findings(operations, alone=False) == []


@pytest.mark.parametrize("speed", ["3B", "36", "81 9C"])
def test_a_round_speed_backward_is_meant(speed: str) -> None:
    """-5, -10 and -100."""
    assert findings(f"A5 00 01 {speed} A6 00 01") == []


def test_sensor_ports_are_counted_from_0() -> None:
    (found,) = findings("9D 00 04 00 3F 60", "04 00", "00")
    assert found.code == "H703"
    assert found.message == "NO is 4, port 1 of the next brick in a daisy chain: ports are counted from 0"
    assert found.help == "use 3 if port 4 of this brick is meant"
    assert findings("9D 00 03 00 3F 60", "04 00", "00") == findings("9D 00 10 00 3F 60", "04 00", "00") == []


def test_the_number_of_a_port_that_is_also_a_mask() -> None:
    (found,) = findings("B3 00 02 60", "04 00", "00")
    assert found.message == "NOS is 2, the number of port C; as a bit mask it would be B"
    assert found.help == "use 1 if port B is meant: OUTPUT_GET_COUNT takes the number of one port"
    assert findings("B3 00 00 60", "04 00", "00") == []
    assert findings("B3 00 03 60", "04 00", "00") == []


def test_a_mask_where_a_number_belongs_is_a_warning_everywhere() -> None:
    (found,) = findings("B3 00 08 60", "04 00", "00", alone=False)
    assert (found.code, found.message, found.help) == (
        "W303",
        "NOS is 8, the bit mask of D, but it takes the number of one port",
        "use 3 for D",
    )
    (found,) = findings("B3 00 0C 60", "04 00", "00", alone=False)
    assert found.help == "use 2 for C, 3 for D"


def test_the_suffix_of_a_sound_is_a_warning_everywhere() -> None:
    (found,) = findings("94 03 01 84 68 2E 52 53 46 00", alone=False)
    assert (found.code, found.message, found.help) == (
        "W705",
        "NAME ends in .rsf, and the firmware adds .rsf to every name",
        "omit it: h",
    )


@pytest.mark.parametrize(
    "operations",
    [
        "A6 00 01",  # the speed was set before
        "A5 00 01 1E A6 00 01",
        "A6 00 01 A5 00 01 1E",
        "A5 00 01 81 CE A6 00 01",  # -50 has an identification byte
    ],
)
def test_no_hint(operations: str) -> None:
    assert findings(operations) == []


def test_the_command_line_gives_hints_for_one_frame_only() -> None:
    def codes(*words: str, stdin: str = "") -> list[list[str]]:
        lines = run_ev3proto_text("check", "--json", *words, stdin=stdin).stdout.splitlines()
        return [[finding["code"] for finding in json.loads(line)["findings"]] for line in lines]

    assert codes(SPEED_WITHOUT_START) == [["H701"]]
    assert codes(stdin=SPEED_WITHOUT_START) == [["H701"]]
    assert codes("OUTPUT_SPEED(0, 1, 30)") == [["H701"]]
    assert codes(SPEED_WITHOUT_START, SPEED_WITHOUT_START) == [[], []]
    assert codes(stdin=f"{SPEED_WITHOUT_START}\n{SPEED_WITHOUT_START}\n") == [[], []]
    assert codes(stdin=f"{SPEED_WITHOUT_START}\n03 00 2B 00 02\n") == [[]]
    assert codes(stdin=f"12:00:01.5 sent {SPEED_WITHOUT_START}\n") == [[]]
