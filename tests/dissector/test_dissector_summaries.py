"""The dissector keeps direct commands as read, and their items, by their bytes: the output is the same as without."""

from __future__ import annotations

import random
from collections.abc import Iterator
from pathlib import Path

import pytest
from support.frames import Segment, drawn, tcp_capture
from support.wireshark import DISSECTOR, Tshark

import ev3proto
from ev3proto.testing import direct_commands

LIMIT = "MOST_BYTES, SUMMARY_BYTES = 512 * 1024, 512"
LOOKUP = "        if kept and (kept.steps or not wants_steps) then return kept, kept.steps end\n"
LINES = ("-o", 'gui.column.format:"Info","%i"', "-z", "expert", "-d", "tcp.port==5555,ev3_all")
"""Without a tree: the info column, and all expert information."""
TREES = ("-2", "-V", "-O", "ev3", "-Y", "ev3", "-d", "tcp.port==5555,ev3_all")


def with_a_wrong_byte(frame: bytes, rng: random.Random) -> bytes:
    at = rng.randrange(5, len(frame))
    return frame[:at] + rng.randbytes(1) + frame[at + 1 :]


def dialogue() -> Iterator[Segment]:
    """Valid and faulty commands with replies: three times, each with other counters and values."""
    rng = random.Random(1)
    frames = [command.build() for command in drawn(direct_commands(), 60)]
    frames += [with_a_wrong_byte(frame, rng) for frame in frames]
    for turn in range(3):
        for number, frame in enumerate(frames):
            counter = turn * len(frames) + number
            yield Segment(True, frame[:2] + counter.to_bytes(2, "little") + frame[4:])
            size = int.from_bytes(frame[5:7], "little") & 0x3FF
            yield Segment(False, ev3proto.direct_reply(bytes([turn]) * size, counter=counter).build())


@pytest.mark.wireshark
def test_output_is_the_same_without_summaries(tmp_path: Path) -> None:
    text = DISSECTOR.read_text()
    assert text.count(LOOKUP) == 1
    without = tmp_path / "without.lua"
    without.write_text(text.replace(LOOKUP, ""))
    # Forgotten after every few commands, too.
    few = tmp_path / "few.lua"
    assert text.count(LIMIT) == 1
    few.write_text(text.replace(LIMIT, "MOST_BYTES, SUMMARY_BYTES = 2 * 1024, 512"))
    shown = []
    for script in (DISSECTOR, without, few):
        with Tshark.from_setting(script) as tshark:
            capture = tshark.place(tcp_capture(dialogue()), "dialogue.pcap")
            shown.append([tshark.run(capture, *words) for words in (LINES, TREES)])
    assert "but the header requests" in shown[0][0]
    assert "unknown opcode" in shown[0][0]
    assert shown[0] == shown[1] == shown[2]


CHANGE_FIRMWARE = """
do
    local tap = Listener.new("frame", "frame.number == 1")
    function tap.packet()
        set_preference("ev3.firmware", "xtended")
        notify()
    end
end
"""


@pytest.mark.wireshark
def test_a_changed_preference_forgets_them(tmp_path: Path) -> None:
    """Opcode 0xF1 exists in the xtended firmware only."""
    script = tmp_path / "ev3.lua"
    # What Wireshark calls after a change; tshark cannot, because it would save the preferences first.
    text = DISSECTOR.read_text().replace("function ev3.prefs_changed()", "function notify()")
    script.write_text(text + CHANGE_FIRMWARE)
    frames = [bytes.fromhex(f"0600 {number:02X}00 80 0000 F1") for number in range(2)]
    with Tshark.from_setting(script) as tshark:
        capture = tshark.place(tcp_capture(Segment(True, frame) for frame in frames), "frames.pcap")
        words = ("-o", 'gui.column.format:"Info","%i"', "-d", "tcp.port==5555,ev3_all")
        first, second = tshark.run(capture, *words).splitlines()
    assert "0xF1 is DYNLOAD_VMEXIT in the dialects xtended and compat" in first
    assert second == "DYNLOAD_VMEXIT"
