"""A new opcode is one entry in one table: after the one command that generates, all parts know it.

An invented opcode and an invented family are added to the tables in a copy of the project.
"""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path

import pytest
from support.cli import run_program
from support.wireshark import Tshark

from ev3proto.generate.captures import write_pcapng
from ev3proto.tables import OPCODES

ROOT = Path(__file__).parents[2]

FREE, OTHER, *_ = (number for number in range(0x100) if all(number != opcode.number for opcode in OPCODES))
"""Numbers that no opcode has."""

ENTRIES = f"""
    Opcode(
        {FREE},
        "TIMER_LAP",
        "Notes the time of a lap",
        (
            In("NO", DATA8, "which lap", range=(0, 9)),
            Out("TIME", DATA32, "time of the lap", unit="ms"),
        ),
    ),
    Opcode(
        {OTHER},
        "WATCH",
        "Works with stopwatches",
        commands=(
            Command(1, "STOP", "Stops a stopwatch", (In("NO", DATA8, "which stopwatch", range=(0, 3)),)),
            Command(
                2,
                "LAPS",
                "Reads the times of laps",
                (
                    In("LENGTH", DATA8, "how many laps", range=(0, 20)),
                    Out("LAPS", DATA32, "their times", unit="ms", length="LENGTH"),
                ),
            ),
        ),
    ),
)
"""

FRAME = f"0f000700000c00{FREE:02x}0360{OTHER:02x}020264{OTHER:02x}0101"
"""TIMER_LAP 3 into GV(0), WATCH LAPS 2 into GV(4), WATCH STOP 1, with 12 bytes of global memory."""

USER = """
import json
import ev3proto
from ev3proto import GV, check, command, ops
from ev3proto.text.assembly import assemble, operation_line

message = command(ops.timer_lap(3), ops.watch.laps(2), ops.watch.stop(no=1), counter=7)
frame = message.build()
parsed = ev3proto.parse(frame)
assert parsed == message
assert parsed.build() == frame
dialogue = ev3proto.Dialogue()
dialogue.feed(parsed)
values = dialogue.feed(ev3proto.direct_reply(bytes(range(12)), counter=7))
text = "\\n".join(operation_line(operation) for operation in parsed.operations)
(assembled,) = assemble(text, counter=7)
wrong = check(ev3proto.direct_command(ev3proto.operation("WATCH.STOP", 9)).build())
print(json.dumps({
    "hex": frame.hex(),
    "names": [operation.full_name for operation in parsed.operations],
    "accepted": check(frame).accepted,
    "findings": [finding.code for finding in check(frame).findings],
    "wrong": [[finding.code, finding.message] for finding in wrong.findings],
    "values": [[value.op, value.command, value.name, value.value, value.unit] for value in values],
    "text": text,
    "assembled": assembled.build().hex(),
    "help": ops.watch.laps.__doc__,
}))
"""


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the project with the invented entries, generated again."""
    root = tmp_path_factory.mktemp("project")
    for name in ("ev3proto", "dissector", "exports"):
        shutil.copytree(ROOT / name, root / name, ignore=shutil.ignore_patterns("__pycache__"))
    table = root / "ev3proto" / "tables" / "timer.py"
    source = table.read_text()
    assert source.endswith(")\n")
    source = source[: -len(")\n")] + ENTRIES.lstrip("\n")
    table.write_text(source.replace("import ", "import Command, DATA8, ", 1))
    changed = _run(root, "-m", "ev3proto.generate").split()
    assert {"ev3proto/ops/watch.py", "dissector/ev3.lua", "exports/ev3-tables.json"} <= set(changed)
    _run(root, "-m", "ev3proto.generate", "--check")
    return root


def _run(root: Path, *arguments: str, status: int = 0) -> str:
    """The output of Python that imports from the copy first; what it says of a failure."""
    variables = {"PYTHONPATH": str(root), "PYTHONDONTWRITEBYTECODE": "1"}
    done = run_program(sys.executable, *arguments, cwd=root, env=variables)
    assert done.returncode == status, done.stderr
    return done.stderr if status else done.stdout


def test_the_package_knows_them(copy: Path) -> None:
    known = json.loads(_run(copy, "-c", USER))
    assert known["hex"] == FRAME
    assert known["names"] == ["TIMER_LAP", "WATCH.LAPS", "WATCH.STOP"]
    assert (known["accepted"], known["findings"]) == (True, [])
    assert known["wrong"] == [["W303", "NO is 9, outside of 0 to 3"]]
    assert known["values"] == [
        ["TIMER_LAP", None, "TIME", 0x03020100, "ms"],
        ["WATCH", "LAPS", "LAPS", [0x07060504, 0x0B0A0908], "ms"],
    ]
    assert "opWATCH, LC0(LAPS), LC0(2), GV0(4)" in known["text"]
    assert known["assembled"] == known["hex"]
    assert "Reads the times of laps." in known["help"]


@pytest.mark.parametrize(
    ("written", "instead", "sentence"),
    [
        (f"{FREE},", "0x97,", "0x97 is already INPUT_SAMPLE: give TIMER_LAP a number that is free\n"),
        (f"{OTHER},", "0x94,", "0x94 is already SOUND: give WATCH a number that is free\n"),
        (
            '2,\n                "LAPS"',
            '1,\n                "LAPS"',
            "CMD 1 is already WATCH.STOP: give WATCH.LAPS a number that is free\n",
        ),
    ],
)
def test_a_number_that_is_taken_is_named_before_anything_is_written(
    copy: Path, tmp_path: Path, written: str, instead: str, sentence: str
) -> None:
    root = tmp_path / "project"
    shutil.copytree(copy, root)
    table = root / "ev3proto" / "tables" / "timer.py"
    source = table.read_text()
    assert source.count(written) == 1
    table.write_text(source.replace(written, instead))
    shutil.copytree(ROOT / "exports", root / "exports", dirs_exist_ok=True)
    (root / "dissector" / "ev3.lua").unlink()
    assert _run(root, "-m", "ev3proto.generate", status=1) == sentence
    assert not (root / "dissector" / "ev3.lua").exists()


def test_the_command_line_knows_them(copy: Path) -> None:
    assert f"0x{OTHER:02X}" in _run(copy, "-m", "ev3proto", "ops", "WATCH")
    shown = _run(copy, "-m", "ev3proto", "decode", FRAME)
    assert "WATCH" in shown
    assert "LAPS" in shown


GENERATED = (
    *("dissector/ev3.lua", "exports/ev3proto.h", "exports/ev3.ksy", "exports/ev3-tables.json"),
    "ev3proto/ops/watch.py",
)


@pytest.mark.parametrize("path", GENERATED)
def test_what_is_generated_knows_them(copy: Path, path: str) -> None:
    text = (copy / path).read_text().upper()
    assert "WATCH" in text
    assert "LAPS" in text


def test_wireshark_knows_them(copy: Path, tmp_path: Path) -> None:
    capture = tmp_path / "watch.pcapng"
    with capture.open("wb") as stream:
        write_pcapng([bytes.fromhex(FRAME)], stream)
    with Tshark.from_setting(copy / "dissector" / "ev3.lua") as tshark:
        tree = tshark.run(capture, "-V")
    assert "TIMER_LAP" in tree
    assert "LAPS" in tree
    assert "STOP" in tree
