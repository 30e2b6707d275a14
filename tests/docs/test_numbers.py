"""Numbers in prose are those of the code, or of the one table that has them."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest
from support.cli import run_ev3proto_text

from ev3proto.brick.limits import DEVIATIONS
from ev3proto.tables import OPCODES
from ev3proto.tables.enumerations import ENUMERATIONS
from ev3proto.tables.system import SYSTEM

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "dissector" / "README.md"]
PAGES += [*(ROOT / "docs").glob("*.md"), *(ROOT / "docs" / "howto").glob("*.md")]


def test_how_much_the_tables_have() -> None:
    official = [opcode for opcode in OPCODES if "official" in opcode.dialects]
    others = [opcode for opcode in OPCODES if opcode.dialects and opcode not in official]
    families = [opcode for opcode in official if opcode.commands]
    commands = [command for opcode in OPCODES for command in opcode.commands if command.dialects]
    of_lego = [command for command in commands if "official" in command.dialects]
    bootloader = [command for command in SYSTEM if command.number >= 0xF0]
    sources = " ".join((ROOT / "docs" / "sources.md").read_text(encoding="utf-8").split())
    assert (
        f"The tables have {len(official)} opcodes of LEGO's firmware: {len(official) - len(families)} plain ones and"
        f" {len(families)} families with {len(of_lego)} commands. They also have the {len(others)} opcodes and"
        f" {len(commands) - len(of_lego)} commands that the xtended and compat firmwares add or rename,"
        f" {len(SYSTEM) - len(bootloader)} system commands, {len(bootloader)} commands of the bootloader"
    ) in sources
    log = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    assert f"Tables: {len(official)} official opcodes with {len(of_lego)} commands, {len(others)} opcodes" in log
    assert f" {len(ENUMERATIONS)} enumerations" in log


def test_the_virtual_brick_differs_in_as_many_ways_as_its_help_lists() -> None:
    """The number of the sentence that it prints is that of DEVIATIONS."""
    assert run_ev3proto_text("brick", "--help").stdout.count("\n  - ") == len(DEVIATIONS)


def test_every_page_names_the_same_oldest_python() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    oldest = project["requires-python"].removeprefix(">=")
    said = {
        version
        for file in (*PAGES, ROOT / "CHANGELOG.md", ROOT / "bin" / "setup")
        for version in re.findall(r"Python ([\d.]+\d) or later", file.read_text(encoding="utf-8"))
    }
    assert said == {oldest}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_figures_of_speed_are_in_one_table(page: Path) -> None:
    """That of benchmarks/README.md, beside the benchmark that measures each."""
    text = page.read_text(encoding="utf-8")
    assert (
        re.findall(r"[\d.]+ times (?:as (?:fast|long)|the (?:time|processor))|\d (?:lines|frames) a second", text) == []
    )
