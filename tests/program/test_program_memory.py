"""The memory that images take; variables for compiled programs; settings for what is unusual in an image."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.peak import PEAK
from support.programs import image_of

from ev3proto import program as programs
from ev3proto.program import assemble
from ev3proto.program.writing import declared
from ev3proto.tables.declaration import Type
from ev3proto.text.assembly import AssemblyError

_TYPES = (Type.DATA8, Type.DATA16, Type.DATA32, Type.DATAF, Type.HANDLE, Type.STRING)


@given(
    st.integers(0, 60), st.integers(0, 60), st.dictionaries(st.integers(0, 70), st.sampled_from(_TYPES), max_size=12)
)
def test_variables_keep_their_places(start: int, size: int, uses: dict[int, Type]) -> None:
    lines = (
        [f"ARRAY8 front {start}"] if start not in (0, 2, 4) else ["DATA8 a", "DATA8 b", "DATA8 c", "DATA8 d"][:start]
    )
    found = declared(start, start + size, uses)
    lines += [f"{it.word} v{it.index}{'' if it.count is None else f' {it.count}'}" for it in found]
    program = programs.parse(assemble("\n".join(lines)).image)
    assert program.global_size == start + size
    assert {index for index in uses if start <= index < start + size} <= {it.index for it in found}


@pytest.mark.parametrize(
    ("setting", "header"),
    [
        ("version 0x39", "4C45474F 1D000000 3900 0100 00000000 1C000000 0000 0000 00000000 0A"),
        ("globals 9", "4C45474F 1D000000 6D00 0100 09000000 1C000000 0000 0000 00000000 0A"),
        ("owner 3", "4C45474F 1D000000 6D00 0100 00000000 1C000000 0300 0000 00000000 0A"),
        ("triggers 2", "4C45474F 1D000000 6D00 0100 00000000 1C000000 0000 0200 00000000 0A"),
        ("locals 5", "4C45474F 1D000000 6D00 0100 00000000 1C000000 0000 0000 05000000 0A"),
        ("offset 5", "4C45474F 1D000000 6D00 0100 00000000 05000000 0000 0000 00000000 0A"),
        ("open", "4C45474F 1C000000 6D00 0100 00000000 1C000000 0000 0000 00000000"),
        (
            "gap 28 FF FE\n// ev3proto: offset 30",
            "4C45474F 1F000000 6D00 0100 00000000 1E000000 0000 0000 00000000 FFFE 0A",
        ),
    ],
)
def test_a_setting(setting: str, header: str) -> None:
    assert assemble(f"// ev3proto: {setting}\nvmthread M {{ }}").image == bytes.fromhex(header)


@pytest.mark.parametrize("setting", ["colour 5", "version red", "version 65536", "gap 3 xyz", "locals -1"])
def test_an_unknown_setting(setting: str) -> None:
    with pytest.raises(AssemblyError, match=f"line 1, column 14: unknown setting {setting}"):
        assemble(f"// ev3proto: {setting}\nvmthread M {{ }}")


def _peak(words: list[str], image: Path) -> int:
    """Returns the maximum of memory of a subcommand, in bytes."""
    done = subprocess.run(
        [sys.executable, "-c", PEAK, *words, str(image)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False
    )
    return int(done.stderr.split()[-1]) * 1024


@pytest.mark.parametrize(
    "words", [["decode"], ["decode", "--json"], ["decode", "--format", "lego"], ["check"]], ids=str
)
def test_an_image_takes_at_most_60_bytes_a_byte(words: list[str], tmp_path: Path) -> None:
    small, large, size = tmp_path / "small.rbf", tmp_path / "large.rbf", 60_000
    small.write_bytes(image_of((0, 0, "01 0A")))
    large.write_bytes(image_of((0, 0, "01" * size + "0A")))
    assert _peak(words, large) - _peak(words, small) < 60 * size


def test_findings_of_a_program_are_listed_up_to_a_limit() -> None:
    # MOVE8_8(LV(1), LV(31)) without local memory: two findings each
    report = programs.check_program(image_of((0, 0, "30 41 5F" * 700 + "0A")))
    assert len(report.findings) == 1000
    assert report.as_dict()["omitted"] == 400
    assert "and 400 more findings, which are not listed" in str(report)
