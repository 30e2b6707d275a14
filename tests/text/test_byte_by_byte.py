"""What each byte of a frame says, and the fields of its header: what the playground shows."""

from __future__ import annotations

import pytest

import ev3proto
from ev3proto.text.byte_by_byte import byte_lines, header_parts, identification


def test_the_header_of_a_direct_command() -> None:
    message = ev3proto.parse(bytes.fromhex("08002a00000400810160"))
    assert [(part.name, part.offset, part.length) for part in header_parts(message)] == [
        ("length", 0, 2),
        ("counter", 2, 2),
        ("type", 4, 1),
        ("memory", 5, 2),
    ]
    assert [part.text for part in header_parts(message)][::3] == [
        "8 bytes after this field",
        "4 bytes global, for the reply; 0 bytes local, for its own use",
    ]


@pytest.mark.parametrize(
    ("frame", "names"),
    [
        ("070001000303f000ff", ["length", "counter", "type", "command", "status"]),  # a reply to a system command
        ("0600010001980041", ["length", "counter", "type", "command"]),
        ("0700010002666 6f640".replace(" ", ""), ["length", "counter", "type"]),
        ("0e0001", ["length"]),
        ("", []),
    ],
)
def test_a_header_has_the_fields_that_its_frame_has(frame: str, names: list[str]) -> None:
    message = ev3proto.parse(bytes.fromhex(frame), strict=False)
    assert [part.name for part in header_parts(message)] == names


def test_a_frame_that_ends_before_its_type_has_a_counter() -> None:
    message = ev3proto.parse(bytes.fromhex("c47d01f4"), strict=False)
    assert list(header_parts(message))[1].text == "62465; a reply has the counter of its command"


def test_a_wrong_length_is_said() -> None:
    message = ev3proto.parse(bytes.fromhex("09002a00000400810160"), strict=False)
    assert next(header_parts(message)).text == "9 bytes after this field according to it; in fact 8"


@pytest.mark.parametrize(
    ("byte", "text"),
    [
        (0x01, "0 0 0 00001, short constant, value in the byte itself (LC0)"),
        (0x41, "0 1 0 00001, short variable, local, index in the byte itself (LV0)"),
        (0x60, "0 1 1 00000, short variable, global, index in the byte itself (GV0)"),
        (0x82, "1 0 0 0 0 010, long constant, 2 bytes after it (LC2)"),
        (0x84, "1 0 0 0 0 100, long constant, text up to a zero (LCS)"),
        (0xA0, "1 0 1 0 0 000, long constant, label, 1 byte after it (LAB1)"),
        (0xF1, "1 1 1 1 0 001, long variable, global, handle, 1 byte after it (GV1)"),
        (0x87, "10000111, undefined as an identification byte"),
    ],
)
def test_the_bits_of_an_identification_byte(byte: int, text: str) -> None:
    assert identification(byte) == text


def test_each_byte_has_a_line_of_its_own() -> None:
    lines = byte_lines(ev3proto.parse(bytes.fromhex("0f002a00800000d4088441620000") + b"\xff" * 3, strict=False))
    assert len(lines) == 17
    assert lines[0] == "Byte 0: 0x0F, byte 1 of 2 (lowest first) of length: 15 bytes after this field"
    assert (
        lines[7] == "Byte 7: 0xD4, opcode COM_SET: Changes the brick's name, its connections and its lists of devices"
    )
    assert lines[8].endswith("CMD SET_BRICKNAME: Renames the brick")
    assert [line.partition(": ")[2] for line in lines[9:13]] == [
        '0x84 = 1 0 0 0 0 100, long constant, text up to a zero (LCS): NAME = "Ab"',
        '0x41, "A" of NAME = "Ab"',
        '0x62, "b" of NAME = "Ab"',
        '0x00, the end of NAME = "Ab"',
    ]
    assert lines[13] == "Byte 13: 0x00, opcode ERROR: Ends the program with a failure; never valid on the wire"
    assert lines[14] == "Byte 14: 0xFF, not part of what could be read"
