"""The brick's own verdict: each rule of the validator by hand, and its position."""

from __future__ import annotations

from itertools import product

import pytest
from support.cpu_time import milliseconds
from support.messages import raw

import ev3proto
from ev3proto.checking.verdict import Reason, Verdict, verdict
from ev3proto.tables import operations
from ev3proto.tables.declaration import Type

START = 7


def answer(code: str) -> tuple[int | None, Reason | None]:
    """Returns where a command is refused, counted from its first operation, and why; None if it is accepted."""
    found = verdict(raw(code))
    assert found.accepted == (found.rejected_at is None) == (found.reason is None) == (found.blamed is None)
    return (None if found.rejected_at is None else found.rejected_at - START), found.reason


ACCEPTED = (None, None)


@pytest.mark.parametrize(
    ("code", "expected"),
    [
        # Rule 1: from one operation to the next, to the end
        ("01", ACCEPTED),
        ("01 01 01", ACCEPTED),
        ("94 01 01 82B801 82E803", ACCEPTED),
        ("94 01 01 82B801", (0, Reason.CUT_OFF)),
        ("94 01 01 82B801 82E8", (0, Reason.CUT_OFF)),
        ("01 94 01 01 82B801", (1, Reason.CUT_OFF)),
        ("94", (0, Reason.CUT_OFF)),
        ("94 02 01 84 78", (0, Reason.CUT_OFF)),
        ("94 02 01 84", (0, Reason.CUT_OFF)),
        ("94 02 01 84 78 00", ACCEPTED),
        ("94 02 01 80 78 00", ACCEPTED),
        ("2F 60 82F401" + "8301000000" * 100, (0, Reason.CUT_OFF)),
        ("2F 60 04" + "8400" * 2, (0, Reason.CUT_OFF)),
        ("9E 00 00 00 00 00 D101", ACCEPTED),  # a handle as the count of parameters: none follow, it may be odd
        # Rule 2
        ("B5", (0, Reason.OPCODE)),
        ("01 00", (1, Reason.OPCODE)),
        ("01 B5 01", (1, Reason.OPCODE)),
        ("A0 00 00 40", (0, Reason.OPCODE)),
        ("01 0A", ACCEPTED),
        ("0A", ACCEPTED),
        ("01 0A 01", (1, Reason.AFTER_END)),
        ("0A 0A", (0, Reason.AFTER_END)),
        # Rules 3 and 5: only the first parameter counts
        ("A6 00 01", ACCEPTED),
        ("A6 817F 01", ACCEPTED),
        ("A6 8180 01", (0, Reason.RANGE)),
        ("A6 8181 01", ACCEPTED),
        ("A6 828000 01", (0, Reason.RANGE)),
        ("A6 82 81FF 01", ACCEPTED),
        ("A6 00 82FF7F", ACCEPTED),
        ("A6 00 8180", ACCEPTED),
        ("02 82FF7F", ACCEPTED),
        ("02 820080", (0, Reason.RANGE)),
        ("02 8300800000", (0, Reason.RANGE)),
        ("85 8300000080 40", (0, Reason.RANGE)),
        ("85 83FFFFFF7F 40", ACCEPTED),
        ("3F 83000080FF 40", ACCEPTED),
        ("3F 830000C07F 40", ACCEPTED),
        ("60 84 6C73 00 40", ACCEPTED),
        ("C4 40 83FFFFFFFF", ACCEPTED),
        # Rule 4: a variable passes, whatever its index
        ("A6 40 5F", ACCEPTED),
        ("A6 C1FF E2FFFF", ACCEPTED),
        ("A6 C3FFFFFFFF 01", ACCEPTED),
        # Rule 6: labels are constants, undefined forms take no byte
        ("A6 A07F 01", ACCEPTED),
        ("A6 A080 01", (0, Reason.RANGE)),
        ("A6 B701 01", ACCEPTED),
        ("A6 85 01", ACCEPTED),
        ("A6 86 87", ACCEPTED),
        ("A6 C0 C4", ACCEPTED),
        ("A6 C5 E7", ACCEPTED),
        # Rule 7: alignment
        ("81 01 60", ACCEPTED),
        ("81 01 64", ACCEPTED),
        ("81 01 61", (0, Reason.ALIGNMENT)),
        ("81 01 62", (0, Reason.ALIGNMENT)),
        ("81 01 E105", (0, Reason.ALIGNMENT)),
        ("81 01 E20400", ACCEPTED),
        ("81 01 41", (0, Reason.ALIGNMENT)),
        ("34 41 42", (0, Reason.ALIGNMENT)),
        ("35 42 43", (0, Reason.ALIGNMENT)),
        ("34 42 43", ACCEPTED),
        ("35 42 44", ACCEPTED),
        ("30 41 43", ACCEPTED),
        ("01 30 00 D103", (1, Reason.ALIGNMENT)),
        ("30 00 D102", ACCEPTED),
        ("81 01 F102", ACCEPTED),
        ("C0 00 84 00 41", (0, Reason.ALIGNMENT)),
        ("C4 40 41", ACCEPTED),
        ("C4 40 D103", (0, Reason.ALIGNMENT)),
        ("0D D103", (0, Reason.ALIGNMENT)),
        # Rule 8: CMD
        ("94 8101 01 82B801 82E803", ACCEPTED),
        ("94 41 01 82B801 82E803", ACCEPTED),
        ("94 C2 0101 01 82B801 82E803", ACCEPTED),
        ("94 07", ACCEPTED),
        ("94 07 01", ACCEPTED),
        ("94 07 00", (2, Reason.OPCODE)),
        ("94 817F", ACCEPTED),
        ("94 820101 01", (0, Reason.RANGE)),
        ("94 8180", (0, Reason.RANGE)),
        ("94 84 78 00", ACCEPTED),
        ("94 D103", (0, Reason.ALIGNMENT)),
        ("84 60 40 40 40 40 8400 00 0D 40", ACCEPTED),
        ("84 60 01", (0, Reason.CUT_OFF)),
        ("7C 0A", ACCEPTED),
        ("7C 0C 00 05 60", ACCEPTED),
        ("FF 04 60", ACCEPTED),
        ("C6 05 40 00", ACCEPTED),
        ("C1 10 40 40", ACCEPTED),
        # Rule 9: a count of parameters
        ("99 1D 00 00 00 3F 01 60", ACCEPTED),
        ("99 1D 00 00 00 3F 01 61", ACCEPTED),
        ("99 1D 00 00 00 3F 02 60", (0, Reason.CUT_OFF)),
        ("99 1D 00 00 00 3F 3F 01", ACCEPTED),
        ("99 1D 00 00 00 3F 3F 61", (7, Reason.CUT_OFF)),
        ("99 1D 00 00 00 3F 41 01", ACCEPTED),
        ("99 1D 00 00 00 3F 828000 01", ACCEPTED),
        ("99 1D 00 00 00 3F 817F" + "01" * 127, ACCEPTED),
        # Rule 10: a count of values
        ("2F 40 03 01 02 03", ACCEPTED),
        ("2F 40 03 01 02", (0, Reason.CUT_OFF)),
        ("2F 40 00", ACCEPTED),
        ("2F 40 00 01", ACCEPTED),
        ("2F 40 02 829010 41", ACCEPTED),
        ("2F 40 44 01 01 01 01", ACCEPTED),
        ("2F 40 84 78 00", ACCEPTED),
        # Rule 11
        ("0D 1F", ACCEPTED),
        ("0D 00", ACCEPTED),
        ("0D 3F", (0, Reason.LABEL)),
        ("0D 8120", (0, Reason.LABEL)),
        ("0D 41", ACCEPTED),
        # Jumps have numbers, not labels, for the validator
        ("40 00", ACCEPTED),
        ("40 83FFFFFF7F", ACCEPTED),
        ("40 41", (0, Reason.ALIGNMENT)),
    ],
)
def test_the_rules(code: str, expected: tuple[int | None, Reason | None]) -> None:
    assert answer(code) == expected


@pytest.mark.parametrize(
    ("code", "number"),
    # -1 of PROGRAM_INFO is 32 of FILE, which does not exist; -2 is 31: MOVE with two texts
    [("0C 3F", 0), ("0C 3E 00 00", 2), ("0C 3E 00", None), ("82 3F", 0), ("83 3F 00 00 00 00 84 00 00 0D 40", 9)],
)
def test_a_negative_cmd_reaches_into_the_table_before(code: str, number: int | None) -> None:
    """The firmware does not expect it: the tables are adjacent in memory."""
    assert verdict(raw(code)).accepted == (number is not None)


def test_what_newer_firmware_has() -> None:
    """The validator of 2013 takes GET_POWER for a command without parameters: 0x60 is SYSTEM, 0x64 JR_LT8."""
    assert answer("81 1D 60 64 68 6C") == (5, Reason.CUT_OFF)
    assert verdict(raw("81 1D 60 64 68 6C"), "xtended").accepted


def test_dialects() -> None:
    assert verdict(raw("E4 00 00 01")) == Verdict(False, 7, Reason.OPCODE, 7)
    assert verdict(raw("E4 00 00 01"), "xtended").accepted
    with pytest.raises(ValueError, match="dialect"):
        verdict(raw("01"), "nxt")


@pytest.mark.parametrize("count", ["3F", "81FF", "83FFFFFFFF", "8300000080", "83FFFFFF7F", "8340420F00"])
def test_counts_that_make_the_brick_spin(count: str) -> None:
    """In constant time, without stepping through thousands of millions of values."""
    frame = raw(f"01 2F 40 {count} 01 02 03")
    assert milliseconds(lambda: verdict(frame), 10) <= 10
    assert verdict(frame) == Verdict(False, 8, Reason.CUT_OFF, 10, True)


def test_a_count_that_is_only_too_large() -> None:
    assert verdict(raw("2F 40 81 64 01 02 03")) == Verdict(False, 7, Reason.CUT_OFF, 9, False)
    assert not verdict(raw("2F 40 83 3F420F00 01 02 03")).spins


def test_blame() -> None:
    """In addition to the operation, at which the firmware stops, the exact argument."""
    assert verdict(raw("01 A6 8180 01")) == Verdict(False, 8, Reason.RANGE, 9)
    assert verdict(raw("81 1E 60 61 68")) == Verdict(False, 7, Reason.ALIGNMENT, 10)


def test_the_header() -> None:
    assert verdict(raw("01", memory=1021)).accepted
    assert verdict(raw("01", memory=1022)) == Verdict(False, 5, Reason.GLOBALS, 5)
    assert verdict(raw("01", memory=1023 | 63 << 10)) == Verdict(False, 5, Reason.GLOBALS, 5)
    assert verdict(raw("01", memory=63 << 10)).accepted
    assert verdict(raw("")) == Verdict(False, 7, Reason.EMPTY, 7)
    assert verdict(raw("", memory=1023)) == Verdict(False, 7, Reason.EMPTY, 7)
    assert verdict(raw("01" * 1017)).accepted
    assert verdict(raw("01" * 1018)) == Verdict(False, 0, Reason.TOO_LONG, 0)


def test_a_length_field_that_is_wrong() -> None:
    whole = raw("82 1B 02 82 1B 01")
    assert verdict(b"\x08\0" + whole[2:]).accepted
    assert verdict(b"\x09\0" + whole[2:]) == Verdict(False, 10, Reason.CUT_OFF, 11)
    assert verdict(b"\x0c\0" + whole[2:]) == Verdict(False, 13, Reason.INCOMPLETE, 13)
    assert verdict(b"\x0c\0" + whole[2:-1]) == Verdict(False, 10, Reason.CUT_OFF, 12)


@pytest.mark.parametrize("frame", [b"", b"\x06", bytes(4), bytes.fromhex("03002A0002"), bytes.fromhex("04002A00019D")])
def test_messages_other_than_direct_commands(frame: bytes) -> None:
    assert verdict(frame).reason is Reason.NO_COMMAND


def test_every_operation_from_its_shortest_values() -> None:
    """Frames of zeros and aligned variables are accepted, except those that the 2013 firmware does not know."""
    for name, declaration in operations().items():
        if declaration.is_newer or name == "ERROR":
            continue
        values: list[object] = []
        for parameter in declaration.parameters:
            if parameter.is_list:
                values.append([])
            elif parameter.is_output or parameter.type is Type.HANDLE:
                values.append(ev3proto.GV(0))
            else:
                values.append("" if parameter.type is Type.STRING else 0)
        frame = ev3proto.direct_command(ev3proto.operation(name, *values)).build()
        assert verdict(frame).accepted, name


def test_every_code_of_two_bytes_has_an_answer() -> None:
    for first, second in product(range(256), range(256)):
        found = verdict(raw(f"{first:02X}{second:02X}"))
        assert found.rejected_at in (None, START, START + 1)
