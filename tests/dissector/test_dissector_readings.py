"""Wireshark's output does not depend on how it reads a file: in one pass or two, with filters, with other columns.

Wireshark tells a dissector to omit the parts of the tree that are not needed, and asks for them later.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest
from support.wireshark import Tshark

from ev3proto.generate.dissector.profile import COLUMNS

CAPTURES = sorted(path for path in (Path(__file__).parents[2] / "captures").iterdir() if "pcap" in path.suffix)
INFO = '"Info","%i"'
PROFILE = ",".join(f'"{column.title}","{column.format}"' for column in COLUMNS if column.format != "%i")
READINGS = {
    "a read filter": ("-2", "-R", "ev3", "-Y", "ev3"),
    "the profile's columns": ("-2", "-Y", "ev3.msg_num || ev3", "-o", f"gui.column.format:{PROFILE},{INFO}"),
}
"""The options with which tshark reads like Wireshark's window."""

CASES = [(reading, path) for reading in READINGS for path in CAPTURES]
# A packet that a read filter drops leaves its number to the next one, and TCP orders segments by these numbers.
CASES.remove(("a read filter", CAPTURES[0].with_name("wifi-reordered.pcap")))


READ = r"EV3|LEGO|    +[^\s\[]"
GENERATED = rf"{READ}|    +\[(?:Brick|Request in|Response time|File:|Transferred|Size|Began in)"
"""Lines of a tree: those of one reading, and those of every pass. Only the second pass knows about missing replies."""


def shown(tshark: Tshark, capture: Path, lines: str, *words: str) -> list[tuple[str, list[str]]]:
    """Of each packet of ours, the line in the packet list, and those lines of the tree."""
    text = tshark.run(capture, "-P", "-V", "-O", "ev3", *words).replace(" (no reply)", "")
    packets = re.findall(r"^(.*)\nFrame \d+.*\n((?:.+\n)*)", text, re.MULTILINE)
    return [(line, re.findall(rf"^(?:{lines}).*", tree, re.MULTILINE)) for line, tree in packets]


@cache
def shown_in_one_pass(tshark: Tshark, capture: Path, lines: str) -> list[tuple[str, list[str]]]:
    return shown(tshark, capture, lines, "-Y", "ev3", "-o", f"gui.column.format:{INFO}")


@pytest.mark.parametrize(("reading", "capture"), CASES, ids=lambda case: getattr(case, "name", case))
def test_what_is_shown_does_not_depend_on_the_reading(tshark: Tshark, reading: str, capture: Path) -> None:
    # A read filter drops packets to which others are linked.
    lines = READ if reading == "a read filter" else GENERATED
    once = shown_in_one_pass(tshark, capture, lines)
    columns = () if "gui.column" in READINGS[reading][-1] else ("-o", f"gui.column.format:{INFO}")
    again = shown(tshark, capture, lines, *READINGS[reading], *columns)
    if tshark.version >= (4, 6) and capture.name == "wifi-reordered.pcap":
        # In two passes, Wireshark itself reports a reassembly error in the segment that was overtaken.
        once, again = once[:9], again[:9]
    assert once
    assert [tree for _, tree in again] == [tree for _, tree in once]
    assert all(line.endswith(info) for (line, _), (info, _) in zip(again, once, strict=True))
