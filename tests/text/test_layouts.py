"""The layouts of a message agree on which bytes could be read, and print nothing that the frame does not have."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from support.cases import each

from ev3proto import parse
from ev3proto.dialogue import Exchange
from ev3proto.messages import Message
from ev3proto.testing import mutated_frames
from ev3proto.text.byte_by_byte import byte_lines
from ev3proto.text.forms import as_c
from ev3proto.text.phrases import Seen
from ev3proto.text.spans import plain_text
from ev3proto.text.table import table
from ev3proto.text.tree import tree

pytestmark = pytest.mark.portable

_SHOWN_IN_A_CELL = 12


def read(frame: str | bytes) -> Exchange:
    return Exchange(parse(bytes.fromhex(frame) if isinstance(frame, str) else frame, strict=False))


def _unread_in_tree(exchange: Exchange) -> bytes:
    frame = exchange.message.build()
    lines = [line for line in tree(exchange, Seen()) if plain_text(line).lstrip().startswith("not read: ")]
    return b"".join(frame[line.offset : line.offset + line.length] for line in lines if line.offset is not None)


def _unread_in_table(exchange: Exchange) -> bytes:
    lines = [plain_text(line) for line in table(exchange, Seen())]
    found = ""
    for labels, digits in zip(lines, lines[2:], strict=False):
        if re.match(r"  \\.*\\$", labels) and digits.endswith("|"):
            cells = zip(labels.strip().strip("\\").split("\\"), digits[3:].split("|"), strict=False)
            found += "".join(data for label, data in cells if label.strip() == "rest")
    return bytes.fromhex(re.sub(r"[:. ]", "", found))


def _unread_in_c(message: Message) -> bytes:
    _, _, unread = as_c(message).partition("\n};")[0].rpartition("/* not read */")
    last = as_c(message).rpartition("/* not read */")[0].rpartition("\n")[2]
    return bytes.fromhex("".join(re.findall("0x([0-9A-F]{2}),", last + unread))) if last else b""


def _unread_in_bytes(message: Message) -> bytes:
    unread = "not part of what could be read"
    return bytes.fromhex("".join(line.split("0x")[1][:2] for line in byte_lines(message) if line.endswith(unread)))


def unread(exchange: Exchange) -> dict[str, bytes]:
    """Returns the bytes that each layout calls unread; the table shows the first ones of a cell."""
    return {
        "tree": _unread_in_tree(exchange),
        "table": _unread_in_table(exchange),
        "c": _unread_in_c(exchange.message),
        "bytes": _unread_in_bytes(exchange.message),
    }


@each(
    "frame, rest",
    [
        ("07 00 2A 00 02 AA BB", ""),  # a reply whose length field is too large, and one in which it is too small
        ("05 00 2A 00 02 AA BB CC", "CC"),
        ("0E 00 2A 00 80 00 00 94 01 01 82 B8", "82 B8"),
        ("05 00 2A 00 80 00", "00"),
        ("04 00 2A 00 01", ""),  # system and daisy messages that end in their header
        ("05 00 2A 00 03 99", "99"),
        ("06 00 2A 00 0A A0 00", "A0 00"),
        ("06 00 2A 00 08 01", "01"),
        ("0C 00 01 00 01 99 E8 03 2F 70 72 6A 73 00", ""),  # fields
        ("0A 00 01 00 01 99 E8 03 2F 70 72 6A", "2F 70 72 6A"),
        ("0F 00 01 00 03 99 08 07 00 00 00 00 61 2E 72 62 66", ""),
        ("09 00 01 00 0A A0 00 01 A6 00 0F", ""),  # operations and other contents of daisy messages
        ("08 00 2A 00 0A A2 01 00 01 94", ""),
        ("07 00 2A 00 08 01 00 AA BB", ""),
    ],
)
def test_each_layout_names_the_same_bytes_as_unread(frame: str, rest: str) -> None:
    assert unread(read(frame)) == dict.fromkeys(("tree", "table", "c", "bytes"), bytes.fromhex(rest))


@given(frame=mutated_frames())
def test_layouts_agree_about_any_frame(frame: bytes) -> None:
    exchange = read(frame)
    if exchange.message.type is not None:  # else a header of bytes without a type is all that the layouts differ in
        found = unread(exchange)
        assert {**found, "table": found["tree"][:_SHOWN_IN_A_CELL]} == {
            **dict.fromkeys(found, found["tree"]),
            "table": found["table"],
        }


@each(
    "frame, absent",
    [
        ("04 00 2A 00 0A", ("layer", "bytes: 0x00", "\\cd\\")),
        ("06 00 2A 00 0A A0 00", ("layer", "bytes: 0x00", "\\cd\\")),
        ("04 00 2A 00 01", ("bytes: 0x00", "\\cd\\")),
        ("05 00 2A 00 03 99", ("bytes: 0x00", "\\cd\\", "\\st\\", "command: 0x00")),
        ("06 00 2A 00 08 01", ("layer",)),
        ("05 00 2A 00 80 00", ("\\hd\\", "memory:")),
    ],
)
def test_no_layout_prints_what_the_frame_does_not_have(frame: str, absent: tuple[str, ...]) -> None:
    exchange = read(frame)
    lines = [plain_text(line) for layout in (tree, table) for line in layout(exchange, Seen())]
    text = "\n".join([*lines, as_c(exchange.message), *byte_lines(exchange.message)])
    assert [word for word in absent if word in text] == []


def test_byte_by_byte_knows_the_header_of_daisy_messages_and_the_fields_of_system_messages() -> None:
    assert byte_lines(read("08 00 2A 00 0A A2 01 00 01 94").message)[5:] == [
        "Byte 5: 0xA2, command: 0xA2 INFO",
        "Byte 6: 0x01, layer_from: 1",
        "Byte 7: 0x00, layer_to: 0",
        "Byte 8: 0x01, byte 0 of the payload",
        "Byte 9: 0x94, byte 1 of the payload",
    ]
    assert byte_lines(read("0A 00 01 00 01 99 E8 03 2F 70 72 00").message)[6:9] == [
        "Byte 6: 0xE8, byte 1 of 2 (lowest first) of max_bytes = 1000",
        "Byte 7: 0x03, byte 2 of 2 (lowest first) of max_bytes = 1000",
        'Byte 8: 0x2F, "/" of path = "/pr"',
    ]


def test_a_line_of_the_tree_knows_the_bytes_of_its_field() -> None:
    lines = list(tree(read("0A 00 01 00 01 99 E8 03 2F 70 72 00"), Seen()))
    assert [(plain_text(line).strip(), line.offset, line.length) for line in lines[2:]] == [
        ("max_bytes = 1000", 6, 2),
        ('path      = "/pr"', 8, 4),
    ]


def test_the_table_has_cells_for_the_parts_of_a_daisy_reply() -> None:
    lines = [plain_text(line) for line in table(read("07 00 2A 00 08 01 00 AA BB"), Seen())]
    assert lines[2] == "  \\len  \\cnt  \\rs\\layers\\payload\\"
    assert lines[4] == "0x|07:00|2A:00|08|01:00 |AA:BB  |"
