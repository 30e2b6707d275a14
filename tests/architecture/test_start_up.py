"""The imports of a short command: they determine the time of `ev3proto decode FRAME`."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
TONE = "0e002a0080000094010182b80182e803"

PARTS_NOT_NEEDED = (
    "brick",
    "capture.carriers",
    "capture.files",
    "capture.filter",
    "capture.formats",
    "checking.checking",
    "checking.fixing",
    "compose",
    "generate",
    "link",
    "ops",
    "program",
    "sampling",
    "scapy",
    "testing",
    "text.diagnostics",
    "text.assembly",
    "text.dialogues",
)
OTHERS_NOT_NEEDED = ("asyncio", "hypothesis", "pyshark", "rich", "scapy", "secrets", "tempfile")

PROGRAM = """
import sys
from ev3proto.cli.main import main
sys.argv = ["ev3proto", *sys.argv[1:]]
try:
    main()
finally:
    print(*sys.modules, file=sys.stderr)
"""


def _loaded(*words: str) -> set[str]:
    """The names of all modules that are loaded when a command ends."""
    command = [sys.executable, "-c", PROGRAM, *words]
    return set(subprocess.run(command, capture_output=True, text=True, check=True, cwd=ROOT).stderr.split())


def test_decode_loads_nothing_that_it_has_no_use_for() -> None:
    names = _loaded("decode", TONE)
    assert "ev3proto.text.tree" in names
    assert [part for part in PARTS_NOT_NEEDED if f"ev3proto.{part}" in names] == []
    assert [name for name in OTHERS_NOT_NEEDED if name in names] == []
