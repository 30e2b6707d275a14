"""What Lua holds while the dissector reads a capture, and what it does not do twice: both tell in long captures."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable
from pathlib import Path

from support.frames import Segment, tcp_capture
from support.wireshark import Tshark

from ev3proto.generate.dissector.build import build
from ev3proto.tables import OPCODES


def tone(number: int, frequency: int = 440) -> bytes:
    body = bytes.fromhex("0000 94 01 01 82") + struct.pack("<h", frequency) + bytes.fromhex("82E803")
    return struct.pack("<HHB", 14, number, 0x80) + body


def test_how_lua_frees_for_other_plugins_is_left_alone() -> None:
    """All scripts share one Lua: what is set for it is set for all. To ask how much it holds, or to free, sets none."""
    uses = set(re.findall(r"collectgarbage\b(?:\((.*?)\))?", build()))
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
"""A script that holds so much, and says at the end of the run how often Lua went through all that it holds."""


def test_what_packets_leave_behind_is_freed_soon(tmp_path: Path) -> None:
    """But not where other plugins hold much, as it takes long to go through that."""
    script = tmp_path / "ev3.lua"
    freed = []
    for held in (0, 40):
        script.write_text(build() + WATCH % held)
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
"""A script that says at the end of the run how many kilobytes Lua holds."""

WORK = """
do
    local hundreds = 0
    debug.sethook(function() hundreds = hundreds + 1 end, "", 100)
    local tap = Listener.new("frame")
    function tap.draw() print(hundreds) end
end
"""
"""A script that says at the end of the run what Lua did, in hundreds of instructions of its machine."""

WITH_TREE = ("-T", "fields", "-e", "ev3.op")


def number_said(tshark: Tshark, frames: Iterable[bytes], *words: str) -> int:
    """What such a script says after these frames; without words there is no tree."""
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
    """Lua goes through all that it holds whenever it frees something, and most captures have a few operations."""
    script = tmp_path / "ev3.lua"
    script.write_text(build() + HELD)
    tones = [tone(number) for number in range(10)]
    with Tshark.from_setting(script) as tshark:
        few, all_of_them = (number_said(tshark, frames, *WITH_TREE) for frames in (tones, [*tones, *every_operation()]))
    assert all_of_them - few > 200


def long_command(number: int) -> bytes:
    """Thirty tones in one command, the first with a frequency of its own."""
    body = "0000" + "94 01 01 82" + struct.pack("<h", number).hex() + "82E803" + "94 01 01 05 05" * 29
    after_length = struct.pack("<HB", number, 0x80) + bytes.fromhex(body)
    return struct.pack("<H", len(after_length)) + after_length


def test_no_steps_are_kept_where_most_commands_find_no_room_for_theirs(tmp_path: Path) -> None:
    """What is kept of a few is gone through again and again, and saves less than that takes."""
    script = tmp_path / "ev3.lua"
    script.write_text(build() + HELD)
    with Tshark.from_setting(script) as tshark:
        few, many = (
            number_said(
                tshark, [long_command(number) for _ in range(5) for number in range(300, 300 + commands)], *WITH_TREE
            )
            for commands in (50, 600)
        )
    assert many < 0.75 * few


def question(number: int) -> bytes:
    """Reads a sensor thirty times, after a tone with a frequency of its own."""
    body = "0400" + "94 01 01 82" + struct.pack("<h", number).hex() + "82E803" + "9D 00 00 00 00 60" * 30
    after_length = struct.pack("<HB", 0, 0x00) + bytes.fromhex(body)
    return struct.pack("<H", len(after_length)) + after_length


def test_no_layouts_of_replies_are_kept_where_no_steps_are(tmp_path: Path) -> None:
    """A command that is read each time tells each time what its reply will hold."""
    script = tmp_path / "ev3.lua"
    script.write_text(build() + HELD)
    answer = Segment(False, struct.pack("<HHB", 7, 0, 2) + bytes(4))
    held = []
    with Tshark.from_setting(script) as tshark:
        for commands, rounds in ((3000, 1), (600, 5)):
            asked = [question(number) for _ in range(rounds) for number in range(300, 300 + commands)]
            dialogue = (segment for frame in asked for segment in (Segment(True, frame), answer))
            capture = tshark.place(tcp_capture(dialogue), "questions.pcap")
            held.append(int(tshark.run(capture, *WITH_TREE).split()[-1]))
    never_again, crowded = held
    assert crowded - never_again < 150


def test_a_command_that_came_before_is_not_read_again(tmp_path: Path) -> None:
    """However many others came in between, up to some thousands."""
    script = tmp_path / "ev3.lua"
    script.write_text(build() + WORK)
    tones = [tone(0, frequency) for frequency in range(4000)]
    with Tshark.from_setting(script) as tshark:
        none, once, twice = (number_said(tshark, frames) for frames in ([], tones, tones * 2))
    assert twice - once < 0.7 * (once - none)


def test_what_is_of_use_is_kept_where_there_is_no_room_for_more(tmp_path: Path) -> None:
    script = tmp_path / "ev3.lua"
    script.write_text(build() + WORK)
    tones = [tone(0, frequency) for frequency in range(5000)]
    both = tones * 2 + [tone(0, frequency) for frequency in range(6000, 6100)]
    with Tshark.from_setting(script) as tshark:
        none, once, before, after = (number_said(tshark, frames) for frames in ([], tones, both, both + tones))
    assert after - before < 0.7 * (once - none)


def test_of_commands_that_never_come_again_little_is_held(tmp_path: Path) -> None:
    """What is kept of them is forgotten once they prove to be other ones all the time."""
    script = tmp_path / "ev3.lua"
    script.write_text(build() + HELD)
    with Tshark.from_setting(script) as tshark:
        few, more, many = (
            number_said(tshark, [tone(0, frequency) for frequency in range(commands)]) for commands in (10, 4000, 8000)
        )
    assert many - few < 0.3 * (more - few)


def test_what_came_before_is_forgotten_when_the_dialogue_is_another_one(tmp_path: Path) -> None:
    """After so many commands that came but once, those that come again are kept once more, in two rounds at most."""
    script = tmp_path / "ev3.lua"
    script.write_text(build() + WORK)
    others = [tone(0, frequency) for frequency in range(-9000, -1000)]
    tones = [tone(0, frequency) for frequency in range(1000)]
    with Tshark.from_setting(script) as tshark:
        none, one, three, six = (number_said(tshark, others + tones * rounds) for rounds in (0, 1, 3, 6))
    assert six - three < 0.7 * 3 * (one - none)
