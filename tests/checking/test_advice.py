"""The helps of `check` that name a number: with it, the finding is gone, and there are no more errors than before."""

from __future__ import annotations

import re
from collections import Counter

import pytest

from ev3proto import check
from ev3proto.checking.codes import CODES

LOAD_AND_START = "12002a00800020c00801846100404403"

ADVISED = [
    # Code, frame, a part of the help, the frame with that number
    ("E102", "08002a0001a0", "set the length to 4", "04002a0001a0"),
    ("E103", "08002a00800000821b02821b01", "omit the last 3 bytes", "08002a00800000821b02"),
    ("E103", "00002a0002", "set the length to 3", "03002a0002"),
    ("E105", "06002a0040000001", "use 0x00 for a direct command with a reply", "06002a0000000001"),
    ("E106", "05002a00000000", "NOP (0x01)", "06002a0000000001"),
    ("E107", "08002a0000ff03810160", "request at most 1019", "08002a0000fb03810160"),
    ("E204", "0a002a00800000a6822c0101", "use 0 to 3", "0a002a00800000a682000001"),
    ("E204", "0a002a00800000a6822c0101", "use 0 to 3", "0a002a00800000a682030001"),
    ("E204", "0e000000003cf0d583c8000000840060", "use one of 1 HW_USB", "0e000000003cf0d58301000000840060"),
    ("E205", "08002a00000500810161", "use a multiple of 4", "08002a00000800810164"),
    ("E206", "08002a008000000d8120", "use 1 to 31", "08002a008000000d811f"),
    ("E207", "09002a008000042f403f01", "values that follow, 0 or more", "09002a008000042f400001"),
    ("E301", "0b002a00800000a300822c0101", "use 0 to 15", "0b002a00800000a300820f0001"),
    ("E301", "0c000000003cf0821b83b2f2ffff", "use one of 0 LED_BLACK", "0c000000003cf0821b8300000000"),
    ("E401", "09002a0080000445403f01", "request 2 bytes of local memory", "09002a0080000845403f01"),
    ("E402", "08002a00000000810160", "request 4 bytes of global memory", "08002a00000400810160"),
    ("E501", "0d002a008000009f00000884414200", "set BYTES to 3", "0d002a008000009f00000384414200"),
    ("E502", f"81002a00800000d40884{'78' * 119}00", "shorten it by 1", f"80002a00800000d40884{'78' * 118}00"),
    ("E601", "07000100000410400b", "use -2 to jump to the first operation", "07000100000410403e"),
    ("E601", "07000100000410400b", "or 0 to jump to the end", "070001000004104000"),
    ("E602", "0b002a00800100416001821b01", "use 0 to run UI_WRITE.LED", "0b002a00800100416000821b01"),
    ("E602", "0b002a00800100416001821b01", "or 3 to skip it", "0b002a00800100416003821b01"),
    ("E603", "0800010080041040a001", "put LABEL 1 at the target", "0a00010080041040a0010d01"),
    ("E801", "04002a000142", "use 0x92 to 0xA2", "04002a000192"),
    ("E803", "0e000000019601002e612e622e2e2e00", "shorten it by 3", "0b00000001960100622e2e2e00"),
    ("E804", "10002a0001a2414141414141414141414100", "shorten it by 1", "0f002a0001a24141414141414141414100"),
    ("E806", "06002a000a420001", "use a sub-command, 0xA0 to 0xA5", "06002a000aa00001"),
    ("H401", "06002a008000f001", "request 0", "06002a0080000001"),
    ("H402", "0b002a000004009a0000003f60", "use INPUT_READSI for a float", "0b002a000004009d0000003f60"),
    ("H701", "09002a00800000a500011e", "put OUTPUT_START (0xA6) after it", "0c002a00800000a500011ea60001"),
    ("H702", "09002a00000400b3000160", "use 0 if port A", "09002a00000400b3000060"),
    ("H708", "0c002a00800000a5000132a60001", "50 is written 81 32", "0d002a00800000a500018132a60001"),
    ("H703", "0b002a000004009d0004003f60", "use 3 if port 4", "0b002a000004009d0003003f60"),
    (
        "H704",
        "16002a00000800ae0001320081640001aa0001a800006460",
        "use OUTPUT_GET_COUNT (0xB3)",
        "15002a00000400ae0001320081640001aa0001b3000060",
    ),
    (
        "H705",
        "10002a00800000a400011ea60001a500010a",
        "use OUTPUT_POWER (0xA4)",
        "10002a00800000a400011ea60001a400010a",
    ),
    ("H706", "0c002a0080000094021e84780096", "leave the wait out", "0b002a0080000094021e847800"),
    ("H901", "08000000003cf086811f", "write it as 1F", "07000000003cf0861f"),
    ("W102", "0a002a0000fc038103817f60", "request at most 1019", "0a002a0000fb038103817f60"),
    ("W301", "0b000100003cf0d30d82c80060", "write -56 if these bits", "0b000100003cf0d30d82c8ff60"),
    ("W303", "09000000003cf0990d81b7", "or -1 (all layers)", "09000000003cf0990d81ff"),
    ("W303", "08000000003cf0dc8120", "use 0 to 29", "08000000003cf0dc811d"),
    ("W303", "09002a00000400b3000960", "use 0 for A, 3 for D", "09002a00000400b3000360"),
    ("W304", "08002a00800000821b1f", "use one of 0 LED_BLACK", "08002a00800000821b00"),
    ("W403", "0600010080041001", "request none", "0600010080001001"),
    ("W403", "0600010080041001", "or use type 0x00", "0600010000041001"),
    ("W404", "08002a00800400810160", "use type 0x00", "08002a00000400810160"),
    ("W405", "0d002a00000500991d0000003f0161", "use a multiple of 4", "0d002a00000800991d0000003f0164"),
    ("W406", "09002a00000404d3014060", "use 2 to 3", "09002a00000404d3010360"),
    ("W501", "0d002a008000009f00000184414200", "omit the last 1 byte", "0c002a008000009f000001844100"),
    ("W501", "0d002a008000009f00000184414200", "set BYTES to 2", "0d002a008000009f00000284414200"),
    (
        "W701",
        "1300010000041094010182b80182e803850a409400",
        "put SOUND_READY (0x96)",
        "1400010000041094010182b80182e80396850a409400",
    ),
    ("W702", "07000000003cf08401", "put UI_DRAW.UPDATE (84:00)", "09000000003cf084018400"),
    (
        "W704",
        "11000100000410ae000332000a0001a3000101",
        "put OUTPUT_READY (0xAA)",
        "14000100000410ae000332000a0001aa0003a3000101",
    ),
    ("W801", "04002a0001a0", "use type 0x81", "04002a0081a0"),
    ("W407", "08002a00000410810140", "use GV(0), and request 4 bytes", "08002a00000400810160"),
    ("W706", "07002a008000000200", "use 1", "07002a008000000201"),
    (
        "W707",
        "12002a00800020c0080184610040440302404400",
        "start it in slot 1",
        "12002a00800020c0080184610040440301404400",
    ),
    ("H707", "0e002a00800000b000011e0082680101", "such as 6 for B and C", "0e002a00800000b000061e0082680101"),
    ("W802", "04002a00819d", "use type 0x01", "04002a00019d"),
    ("W806", "0f002a00819e0461626300 04000a000000", "send 00 00 20 41", "0f002a00819e0461626300040000002041"),
]

WITHOUT_A_NUMBER_TO_TRY = {
    "E208": "`ops` lists the numbers",
    "E209": "`ops` lists the numbers",
    "E210": "the names of encodings have numbers in them",
    "E305": "the name of an encoding has a number in it",
    "E802": "the names of types have numbers in them",
    "W804": "the length in front of the message changes, too",
}
"""Codes whose helps may have digits but no number to apply, with the reason."""


@pytest.mark.parametrize(("code", "frame", "advice", "advised"), ADVISED)
def test_a_number_of_a_help(code: str, frame: str, advice: str, advised: str) -> None:
    before, after = (check(bytes.fromhex(text), alone=True) for text in (frame, advised))
    assert advice in next(finding.help for finding in before.findings if finding.code == code)
    counts = [Counter(finding.code for finding in report.findings)[code] for report in (before, after)]
    assert counts[1] == counts[0] - 1
    assert len(after.errors) <= len(before.errors)


@pytest.mark.parametrize("code", CODES)
def test_every_help_with_a_number_is_tried(code: str) -> None:
    entry = CODES[code]
    helps = [
        it.help for it in check(entry.example, carrier=entry.carrier, alone=entry.alone).findings if it.code == code
    ]
    assert code in {row[0] for row in ADVISED} | WITHOUT_A_NUMBER_TO_TRY.keys() or not re.search(r"\d", helps[0])
