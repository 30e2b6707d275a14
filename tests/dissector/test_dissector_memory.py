"""Lua's memory while the dissector reads a capture."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable
from pathlib import Path

from support.frames import Segment, tcp_capture
from support.messages import tone
from support.wireshark import DISSECTOR, Tshark

from ev3proto.tables import OPCODES


def test_how_lua_frees_for_other_plugins_is_left_alone() -> None:
    """All scripts share one Lua: its settings are shared by all. Asking for the memory, or freeing it, changes none."""
    uses = set(re.findall(r"collectgarbage\b(?:\((.*?)\))?", DISSECTOR.read_text()))
    assert uses == {'"count"', ""}


WATCH = """
do
    local held, freed = ("x"):rep(%d * 1024 * 1024), 0
    local function watch()
        setmetatable({}, { __gc = function() freed = freed + 1 watch() end })
    end
    watch()
    local tap = Listener.new("frame")
    function tap.draw() print(freed, #held) end
end
"""
"""A script that keeps this much memory, and prints at the end how often Lua collected garbage."""


def test_what_packets_leave_behind_is_freed_soon(tmp_path: Path) -> None:
    """But not if other plugins keep a lot, as collecting that takes long."""
    script = tmp_path / "ev3.lua"
    freed = []
    for held in (0, 40):
        script.write_text(DISSECTOR.read_text() + WATCH % held)
        with Tshark.from_setting(script) as tshark:
            capture = tshark.place(tcp_capture(Segment(True, tone(number)) for number in range(3000)), "tones.pcap")
            freed.append(int(tshark.run(capture, "-T", "fields", "-e", "ev3.op").split()[-2]))
    assert freed[0] >= 5
    assert freed[1] <= 2


HELD = """
do
    local tap = Listener.new("frame")
    function tap.draw() collectgarbage() print(math.floor(collectgarbage("count"))) end
end
"""
"""A script that prints at the end how many kilobytes Lua holds."""

WITH_TREE = ("-T", "fields", "-e", "ev3.op")


def number_said(tshark: Tshark, frames: Iterable[bytes], *words: str) -> int:
    """The output of such a script for these frames; without words there is no tree."""
    capture = tshark.place(tcp_capture(Segment(True, frame) for frame in frames), "frames.pcap")
    return int(tshark.run(capture, *words).split()[-1])


def every_operation() -> Iterable[bytes]:
    """A frame for each, with zeros as its arguments."""
    for opcode in OPCODES:
        for command in opcode.commands or (None,):
            selected = b"" if command is None else bytes([0x81, command.number])
            zeros = bytes(len((command or opcode).parameters))
            body = bytes([0, 0, opcode.number]) + selected + zeros
            yield struct.pack("<HHB", 3 + len(body), 1, 0x80) + body


def test_what_is_known_of_an_operation_is_read_when_it_comes(tmp_path: Path) -> None:
    """Lua goes through its whole memory whenever it frees something, and most captures have few operations."""
    script = tmp_path / "ev3.lua"
    script.write_text(DISSECTOR.read_text() + HELD)
    tones = [tone(number) for number in range(10)]
    with Tshark.from_setting(script) as tshark:
        few, all_of_them = (number_said(tshark, frames, *WITH_TREE) for frames in (tones, [*tones, *every_operation()]))
    assert all_of_them - few > 200


def test_commands_that_never_repeat_take_little_memory(tmp_path: Path) -> None:
    """What is kept for later passes is small, and what is kept to save time has a limit: 250 bytes a packet."""
    script = tmp_path / "ev3.lua"
    script.write_text(DISSECTOR.read_text() + HELD)
    pairs = 10_000
    # MOVE32_32 of another number to GV0(0) in each command.
    said = [
        segment
        for number in range(pairs)
        for segment in (
            Segment(True, struct.pack("<HHBHBBiB", 12, number, 0, 4, 0x3A, 0x83, number, 0x60)),
            Segment(False, struct.pack("<HHBi", 7, number, 2, number)),
        )
    ]
    with Tshark.from_setting(script) as tshark:
        few, many = (
            int(tshark.run(tshark.place(tcp_capture(part), "moves.pcap")).split()[-1]) for part in (said[:20], said)
        )
    assert (many - few) * 1024 < 250 * len(said)
