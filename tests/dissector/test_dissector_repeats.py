"""Commands that come again and again: the dissector keeps what it found out of them, and that must not show."""

from __future__ import annotations

import re
import struct

import pytest
from support.packets import RAW_IP, Capture, Connection
from support.wireshark import Tshark

import ev3proto

UNLOCK = ev3proto.Unlock("06165300000a").build()

COMMANDS = {
    "numbers, a text, an enumeration and flags": "0400 94 02 8132 84 6265657000 A4 00 06 8132 9D 00 02 8110 00 60",
    "a variable that the brick refuses, and one beyond the memory": "0800 81 01 61 B3 00 01 68",
    "a CMD of two bytes, and lists": "0200 81 8101 40 2F 40 03 01 02 03 9E 00 00 00 00 00 02 60 61",
    "an opcode that there is not": "0000 94 01 05 82B801 0A F0 01",
    "nothing to read": "0000",
}
"""Bodies of direct commands."""


def frame(body: str, kind: int = 0x80) -> bytes:
    after_length = struct.pack("<HB", 1, kind) + bytes.fromhex(body)
    return struct.pack("<H", len(after_length)) + after_length


def said(tshark: Tshark, frames: list[bytes]) -> list[str]:
    """What the dissector adds to the tree for each, and what the info column says."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(UNLOCK)
    for each in frames:
        connection.send(each)
    path = tshark.place(capture.data(), "again.pcap")
    trees = re.split(r"^(?=EV3: )", tshark.run(path, "-V", "-O", "ev3"), flags=re.MULTILINE)[2:]
    # Without a tree lines are made in another way.
    lines = tshark.run(path, "-o", 'gui.column.format:"Info","%i"').splitlines()[1:]
    assert len(trees) == len(lines) == len(frames)
    return [tree.split("\n\n")[0] + "\n" + line for tree, line in zip(trees, lines, strict=True)]


@pytest.mark.parametrize("body", COMMANDS.values(), ids=COMMANDS.keys())
def test_a_command_looks_the_same_however_often_it_came(tshark: Tshark, body: str) -> None:
    first, *others = said(tshark, [frame(body)] * 5)
    assert others == [first] * 4


def test_a_fault_in_the_first_operation_is_told_of_with_the_type_of_each_command(tshark: Tshark) -> None:
    body = "0000 F0 01"
    frames = [frame(body, kind) for _ in range(4) for kind in (0x00, 0x80)]
    lines = [each.splitlines()[-1].partition(" [")[0] for each in said(tshark, frames)]
    assert lines == ["DIRECT_COMMAND_REPLY", "DIRECT_COMMAND_NO_REPLY"] * 4


def test_more_commands_than_there_is_room_for(tshark: Tshark) -> None:
    """5,500 tones, again and again: they are kept, find no room, are forgotten, and kept again."""
    frequencies, rounds = range(1000, 6500), 3
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    for _ in range(rounds):
        for frequency in frequencies:
            connection.send(frame("0000 94 01 05 82" + struct.pack("<h", frequency).hex() + "8164"))
    path = tshark.place(capture.data(), "tones.pcap")
    lines = [f"SOUND TONE volume=5 frequency={frequency} duration=100" for frequency in frequencies]
    assert tshark.run(path, "-o", 'gui.column.format:"Info","%i"').splitlines() == lines * rounds
    fields = ("-e", "_ws.col.Info", "-e", "ev3.sound.tone.frequency", "-e", "ev3.argument.encoding")
    rows = [f"{line}\t{frequency}\tLC0,LC2,LC1" for line, frequency in zip(lines, frequencies, strict=True)]
    assert tshark.run(path, "-T", "fields", *fields).splitlines() == rows * rounds


def test_replies_to_commands_that_come_again(tshark: Tshark) -> None:
    """The values are those of each reply, without a tree and with one."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    expected = []
    for number in range(1, 6):
        volts = struct.pack("<f", number + 0.5)
        for body, memory, line in (
            ("0400 81 01 60", volts, f"UI_READ GET_VBATT: {number}.5 V"),
            (
                "0500 81 01 60 7C 04 64",
                volts + bytes([number]),
                f"UI_READ GET_VBATT: VBATT={number}.5 V VOLUME={number} %",
            ),
            ("0400 D3 0D 04 60", b"EV%d\0" % number, f'COM_GET GET_BRICKNAME: "EV{number}"'),
        ):
            connection.send(frame(body, 0x00))
            connection.receive(struct.pack("<HHB", 3 + len(memory), 1, 0x02) + memory)
            expected.append("reply to " + line)
    path = tshark.place(capture.data(), "replies.pcap")
    assert tshark.run(path, "-o", 'gui.column.format:"Info","%i"').splitlines()[1::2] == expected
    # Fields need the tree.
    found = tshark.run(path, "-T", "fields", "-e", "_ws.col.Info", "-e", "ev3.ui_read.get_vbatt.value").splitlines()
    values = [volts for number in range(1, 6) for volts in (f"{number}.5", f"{number}.5", "")]
    assert found[1::2] == [f"{line}\t{value}" for line, value in zip(expected, values, strict=True)]
