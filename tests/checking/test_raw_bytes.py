"""A number as a raw byte, or a label, where an argument belongs: what the byte is, and how the number is written."""

from __future__ import annotations

import pytest

import ev3proto
from ev3proto.checking.report import Finding
from ev3proto.schema.header import with_length


def findings(operations: str, memory: str = "00 00") -> list[Finding]:
    frame = with_length(bytes.fromhex(f"2A 00 80 {memory} {operations}"))
    return list(ev3proto.check(frame).findings)


@pytest.mark.parametrize(
    ("operations", "offset", "message", "help_"),
    [
        (
            "A4 00 0F 4B A6 00 0F",
            10,
            "0x4B is LV(11), a variable at byte 11 of local memory, which the header does not request; the number 75 is"
            " written 81 4B",
            "write the number 75 as 81 4B, or request 12 bytes of local memory",
        ),
        (
            "A5 00 01 64 A6 00 01",
            10,
            "0x64 is GV(4), a variable at byte 4 of global memory, which the header does not request; the number 100 is"
            " written 81 64",
            "write the number 100 as 81 64, or request 5 bytes of global memory",
        ),
        (
            "A5 00 01 9C A6 00 01",
            10,
            "0x9C begins a text (LCS) with the handle and address bits, which takes the next 2 bytes; the number -100"
            " is written 81 9C",
            "write the number -100 as 81 9C",
        ),
        (
            "A5 00 01 9C A6 01 01",
            10,
            "0x9C begins a text (LCS) with the handle and address bits, which the frame does not end; the number -100"
            " is written 81 9C",
            "write the number -100 as 81 9C",
        ),
        (
            "A5 00 01 EC A6 00 01",
            10,
            "0xEC begins no argument; the number -20 is written 2C",
            "write the number -20 as 2C",
        ),
        (
            "A5 00 01 B5 A6 00 01",  # the label takes A6, and 00 is then an opcode
            10,
            "0xB5 is LAB1, a label, but labels are 1 to 31: the brick takes this one as the number -90",
            "write the number -75 as 81 B5, or -90 as 81 A6",
        ),
        (
            "94 01 01 B8 01 82 E8 03",
            10,
            "0xB8 is LAB1, a label: the brick puts the place of label 1 here, not a number",
            "write the number 440 as 82 B8 01",
        ),
        (
            "94 01 01 82 B8 01 E8 03",
            13,
            "0xE8 begins no argument; the number 1000 is written 82 E8 03",
            "write the number 1000 as 82 E8 03, or 232 as 82 E8 00",
        ),
        (
            "AE 00 01 1E 00 68 00 01",
            12,
            "0x68 is GV(8), a variable at byte 8 of global memory, which the header does not request; the number 104 is"
            " written 81 68",
            "write the number 104 as 81 68, or request 12 bytes of global memory",
        ),
        (
            "84 02 01 84 05 00 05 84 00",
            10,
            "0x84 begins a text (LCS), which takes the next 2 bytes; the number 132 is written 82 84 00",
            "write the number 132 as 82 84 00",
        ),
    ],
)
def test_a_raw_byte(operations: str, offset: int, message: str, help_: str) -> None:
    found = findings(operations)
    assert [(each.offset, each.message, each.help) for each in found] == [(offset, message, help_)]
    assert found[0].severity == ("warning" if "takes this one as" in message else "error")


@pytest.mark.parametrize(
    ("operations", "help_"),
    [
        ("A1 A1 14 00 01", "write the number 20 as 14, or -20 as 2C"),  # LAYER is 0 to 3: neither fits
        ("A5 00 01 A1 14 A6 00 01", "write the number 20 as 14, or -20 as 2C"),
        ("A5 00 01 A1 1F A6 00 01", "write the number 31 as 1F, or -31 as 21"),
    ],
)
def test_a_label_for_a_number(operations: str, help_: str) -> None:
    (found,) = findings(operations)
    assert (found.code, found.help) == ("E307", help_)
    assert " is LAB1, a label: the brick puts the place of label " in found.message


@pytest.mark.parametrize(
    ("operations", "number"),
    [
        ("A5 00 01 A1 00 A6 00 01", 0),  # jumps name labels from 1 on
        ("A5 00 01 A1 20 A6 00 01", 32),
        ("A5 00 01 A1 32 A6 00 01", 50),
        ("A5 00 01 A1 CE A6 00 01", -50),  # SPEED has one byte
        ("94 01 01 A1 C8 82 E8 03", 200),  # FREQUENCY has two
    ],
)
def test_labels_from_32_on_are_numbers(operations: str, number: int) -> None:
    (found,) = findings(operations)
    assert found.code == "W305"
    assert f"labels are 1 to 31: the brick takes this one as the number {number}" in found.message


def test_labels_of_jumps_are_labels() -> None:
    assert "E307" not in {each.code for each in findings("0D 01 40 A0 01")}


def test_memory_is_the_first_advice_where_a_variable_is_likelier() -> None:
    """The command itself writes it; the byte is not a documented value; an index of two bytes."""
    (written, read) = findings("30 05 4B A4 00 01 4B A6 00 01")
    assert {each.code for each in (written, read)} == {"E401"}
    assert read.help == "request 12 bytes of local memory, or use a lower index"
    (found,) = findings("82 1B 50")
    assert (found.code, found.help) == (
        "E401",
        "request 17 bytes of local memory, or use a lower index, or write the number 80 as 81 50 if that is meant",
    )
    (found,) = findings("A5 00 01 E1 9C A6 00 01")
    assert found.code == "E402"


def test_a_variable_within_the_memory_is_meant() -> None:
    assert findings("A5 00 01 64 A6 00 01", "08 00") == []


def test_no_memory_is_added_for_a_raw_byte() -> None:
    frame = with_length(bytes.fromhex("2A 00 80 00 00 A4 00 0F 4B A6 00 0F"))
    fixed = ev3proto.fix(frame)
    assert (fixed.frame, fixed.is_fixed) == (frame, False)
    assert fixed.unfixed == (
        "POWER of OUTPUT_POWER at offset 10: write the number 75 as 81 4B, or request 12 bytes of local memory",
    )
