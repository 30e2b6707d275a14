"""Frames in LEGO's notation: how they look, and that they encode to the same bytes."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.cli import run_ev3proto_text

from ev3proto import parse
from ev3proto.dialogue import Dialogue
from ev3proto.text.assembly import assemble, assembly


def written(frame: bytes) -> str:
    """A frame in LEGO's notation."""
    return "\n".join(assembly(Dialogue().follow(parse(frame, strict=False)), "a frame", "lego"))


def lines(code: str, sizes: str = "00 00") -> list[str]:
    """The operations of a direct command, in LEGO's notation."""
    body = bytes.fromhex(f"00 00 00 {sizes} {code}")
    heading, header, *operations = written(bytes((len(body), 0)) + body).split("\n")
    assert heading == "// a frame"
    assert header.startswith("message DIRECT_COMMAND_REPLY counter 0 ")
    return operations


SHORTEST = {
    "94 01 02 82 E8 03 82 E8 03": ["SOUND(TONE,2,1000,1000)"],
    "94 01 02 82 E8 03 82 40 9C": ["SOUND(TONE,2,1000,40000)"],
    "82 1B 02": ["UI_WRITE(LED,LED_RED)"],
    "84 05 01 00 32 84 61 27 62 0A 00 84 00": ["UI_DRAW(TEXT,FG_COLOR,0,-14,'a\\qb\\n')", "UI_DRAW(UPDATE)"],
    "3F 83 00 00 60 40 60": ["MOVEF_F(3.5F,GV0(0))"],
    "3F 83 00 00 C0 7F 60": ["MOVEF_F(DATAF_NAN,GV0(0))"],
    "01": ["NOP()"],
    "40 01 01 40 3B": ["Label1:", "JR(Label2)", "NOP()", "Label2:", "JR(Label1)"],
    "09 02 01 84 2D 00": ["CALL(2,1,'-')"],
}


@pytest.mark.parametrize("code", SHORTEST)
def test_plain_values_in_their_shortest_encoding(code: str) -> None:
    assert lines(code) == SHORTEST[code]


LONGER = {
    "94 81 01 81 02 83 E8 03 00 00 00": ["SOUND(LC1(TONE),LC1(2),LC4(1000),0)"],
    "82 1B 81 02": ["UI_WRITE(LED,LC1(LED_RED))"],
    "84 05 01 00 00 80 61 00": ["UI_DRAW(TEXT,FG_COLOR,0,0,LCS_OLD('a'))"],
    "3F 05 C1 04": ["MOVEF_F(LC0(5),LV1(4))"],
    "3F 83 01 00 C0 7F 60": ["MOVEF_F(LC4(0x7FC00001),GV0(0))"],
    "40 82 00 00": ["JR(LC2(Label1))", "Label1:"],
    "40 A3 05": ["JR(bytes(A3 05))"],
    "40 82 10 27": ["JR(10000)"],
    "C0 07 D1 04": ["FILE(CLOSE,HND(LV1(4)))"],
}


@pytest.mark.parametrize("code", LONGER)
def test_other_encodings_are_named(code: str) -> None:
    assert lines(code) == LONGER[code]


@given(st.lists(st.integers(-150, 150), min_size=1, max_size=8))
def test_jumps_come_back(distances: list[int]) -> None:
    forms = ["LC0", "LC1", "LC2", "LC4"]
    text = ["message DIRECT_COMMAND_NO_REPLY"]
    for number, distance in enumerate(distances):
        form = forms[2 if not -32 <= distance <= 31 else number % 4]
        text += [f"opJR, {form if form != 'LC1' or -128 <= distance <= 127 else 'LC2'}({distance})", "opNOP"]
    (message,) = assemble("\n".join(text))
    assert [one.build() for one in assemble(written(message.build()))] == [message.build()]


def test_the_command_line_writes_and_reads_it() -> None:
    tone = "0E 00 2A 00 80 00 00 94 01 01 82 B8 01 82 E8 03"
    shown = run_ev3proto_text("decode", "--format", "lego", tone).stdout
    assert shown.split("\n")[1:3] == [
        "message DIRECT_COMMAND_NO_REPLY counter 42 globals 0 locals 0",
        "SOUND(TONE,1,440,1000)",
    ]
    again = run_ev3proto_text("encode", "--to", "lego", stdin=shown).stdout
    assert again == shown
    encoded = run_ev3proto_text("encode", stdin=again).stdout
    assert encoded == "0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|\n"
