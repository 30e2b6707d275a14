"""Variables for compiled programs, and the settings by which a source describes what is unusual in its image."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ev3proto import program as programs
from ev3proto.program import assemble
from ev3proto.program.writing import declared
from ev3proto.tables.declaration import Type
from ev3proto.text.assembly import AssemblyError

_TYPES = (Type.DATA8, Type.DATA16, Type.DATA32, Type.DATAF, Type.HANDLE, Type.STRING)


@given(
    st.integers(0, 60), st.integers(0, 60), st.dictionaries(st.integers(0, 70), st.sampled_from(_TYPES), max_size=12)
)
def test_the_assembler_puts_every_variable_where_it_was(start: int, size: int, uses: dict[int, Type]) -> None:
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
        ("size 99", "4C45474F 63000000 6D00 0100 00000000 1C000000 0000 0000 00000000 0A"),
        ("count 7", "4C45474F 1D000000 6D00 0700 00000000 1C000000 0000 0000 00000000 0A"),
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
def test_what_is_no_setting(setting: str) -> None:
    with pytest.raises(AssemblyError, match=f"line 1, column 14: unknown setting {setting}"):
        assemble(f"// ev3proto: {setting}\nvmthread M {{ }}")
