"""The output of the dissector: info column and tree. test_dissector_agreement.py compares values, links and files.

All tests use the real tshark; packet numbers are those of the captures in the repository.
"""

from __future__ import annotations

import struct
from pathlib import Path

import pytest
from scapy.layers.inet import IP, TCP
from scapy.layers.l2 import Ether
from scapy.utils import wrpcap
from support.packets import RAW_IP, Capture, Connection
from support.wireshark import Tshark

import ev3proto

CAPTURES = Path(__file__).parents[2] / "captures"
WIFI = CAPTURES / "wifi.pcapng"


# The info column


@pytest.fixture(scope="module")
def infos(tshark: Tshark) -> list[str]:
    """The text of each packet."""
    return tshark.run(WIFI, "-2", "-T", "fields", "-e", "_ws.col.Info").splitlines()


@pytest.mark.parametrize(
    ("packet", "line"),
    [
        (1, "beacon: 06165300000a 5555 myEV3 EV3"),
        (7, "unlock 06165300000a"),
        (9, "accepted"),
        (11, "SOUND.TONE volume=5 % frequency=440 Hz duration=250 ms"),
        (13, "INPUT_DEVICE_LIST length=4 (+INPUT_DEVICE.GET_NAME, UI_READ.GET_VBATT)"),
        (
            17,
            "UI_WRITE.LED pattern=LED_ORANGE_PULSE; OUTPUT_SPEED layer=0 nos=B+C speed=50 % (+OUTPUT_START);"
            " UI_READ.GET_VBATT",
        ),
        (18, "reply to UI_READ.GET_VBATT: 7.92 V"),
        (29, "error reply to UI_READ.GET_VBATT"),
        (31, 'LIST_FILES max_bytes=80 "/home/root/lms2012/prjs/log/"'),
        (32, 'reply: LIST_FILES "/home/root/lms2012/prjs/log/" 80 of 112 bytes'),
        (43, 'CONTINUE_DOWNLOAD "../prjs/log/first.rbf" 1017 of 2500 bytes'),
        (51, 'reply: BEGIN_DOWNLOAD "/home/root/none/here.rtf" 0 of 3 bytes ILLEGAL_PATH'),
        (52, 'WRITEMAILBOX "abc" text "hello"'),
    ],
)
def test_the_info_column_tells_what_happened(infos: list[str], packet: int, line: str) -> None:
    assert infos[packet - 1] == line


def test_the_protocol_column_and_one_line_output_need_no_tree(tshark: Tshark) -> None:
    lines = tshark.run(WIFI).splitlines()
    assert [line.split(None, 5)[5] for line in lines if " EV3 " in line][3:6] == [
        "EV3 108 unlock 06165300000a",
        "EV3 71 accepted",
        "EV3 70 SOUND.TONE volume=5 % frequency=440 Hz duration=250 ms",
    ]


# Fields


def test_a_command_in_the_tree(tshark: Tshark) -> None:
    text = tshark.run(WIFI, "-V", "-Y", "frame.number == 11")
    assert text[text.index("EV3: ") :].rstrip().splitlines() == [
        "EV3: SOUND.TONE volume=5 % frequency=440 Hz duration=250 ms",
        "    [Brick: 192.0.2.10:5555]",
        "    [Connection: 1]",
        "    Length: 14",
        "    Message counter: 1",
        "    Type: DIRECT_COMMAND_NO_REPLY (0x80)",
        "    Requested memory: 0x0000",
        "        .... ..00 0000 0000 = Global memory: 0 bytes",
        "        0000 00.. .... .... = Local memory: 0 bytes",
        "    Opcode: SOUND (0x94) TONE volume=5 % frequency=440 Hz duration=250 ms",
        "        CMD: SOUND.TONE",
        "        VOLUME: 5 %",
        "            Encoding: LC0",
        "        FREQUENCY: 440 Hz",
        "            Encoding: LC2",
        "        DURATION: 250 ms",
        "            Encoding: LC2",
    ]


def test_values_have_names_flags_and_meanings(tshark: Tshark) -> None:
    text = tshark.run(WIFI, "-V", "-Y", "frame.number == 17")
    assert "PATTERN: LED_ORANGE_PULSE (9)" in text
    assert "NOS: 6 (B+C)" in text
    text = tshark.run(WIFI, "-V", "-Y", "frame.number == 24")
    assert "NO: 0 (port 1)" in text
    assert "TYPE: TYPE_KEEP (0) (keep the type)\n" in text


def test_the_firmware_whose_instruction_set_is_meant_is_a_preference(tshark: Tshark) -> None:
    # DYNLOAD_VMLOAD is not an opcode of LEGO's firmware.
    frame = bytes.fromhex("08 00 01 00 00 01 00 f0 00 60")
    capture = one_segment(tshark.folder / "dynload.pcap", frame)
    official = tshark.run(capture, "-V")
    assert "0xF0 is DYNLOAD_VMLOAD in the dialects xtended and compat" in official
    xtended = tshark.run(capture, "-V", "-o", "ev3.firmware:xtended")
    assert "unknown opcode 0xF0" not in xtended
    assert "0xf0" in xtended.lower()


# Dialogues


def test_replies_whose_command_is_not_in_the_capture_are_said_so(tshark: Tshark) -> None:
    # Two replies in a row show that a connection is a brick's.
    frames = bytes.fromhex("07 00 01 00 02 a4 70 fd 40") + bytes.fromhex("07 00 02 00 02 a4 70 fd 40")
    capture = one_segment(tshark.folder / "orphan.pcap", frames, from_brick=True)
    assert "the command that this reply answers was not seen" in tshark.run(capture, "-V")
    assert "reply: 4 bytes, command not seen" in tshark.run(capture)


def one_segment(path: Path, frame: bytes, *, from_brick: bool = False) -> Path:
    """A capture of one frame in a TCP segment to port 5555, or from it."""
    ports = (5555, 49152) if from_brick else (49152, 5555)
    segment = TCP(sport=ports[0], dport=ports[1], flags="PA")
    wrpcap(str(path), Ether() / IP(src="192.0.2.1", dst="192.0.2.2") / segment / frame)
    return path


def test_no_control_character_is_in_a_line(tshark: Tshark) -> None:
    """ISO-8859-1 without 00 to 1F and 7F to 9F: tshark 4.0 sends those to the terminal unchanged."""
    name = b"a\x1b\x7f\x85\x9b\xe4"
    body = b"\x00\x00\xd4\x08\x84" + name + b"\x00"
    capture = Capture(RAW_IP)
    Connection(capture).send(struct.pack("<HHB", 3 + len(body), 1, 0x80) + body)
    path = tshark.place(capture.data(), "controls.pcap")
    said = tshark.run(path, "-T", "fields", "-e", "_ws.col.Info").strip()
    assert said == 'COM_SET.SET_BRICKNAME name="a\u241b\u2421\ufffd\ufffdä"'


def test_no_control_character_is_in_the_files_of_a_listing(tshark: Tshark) -> None:
    """A line for each file; a size may have any number of digits."""
    digest = b"0" * 32
    listing = digest + b" 0000000A a\x1b[31m\x9bb%n\n" + digest + b" " + b"F" * 12 + b" c\nd\x7f/\n"
    body = struct.pack("<BBIB", 0x99, 0, len(listing), 0) + listing
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(bytes.fromhex("0a00 0100 01 99 e803 2f707200"))
    connection.receive(struct.pack("<HHB", 3 + len(body), 1, 0x03) + body)
    shown = tshark.run(tshark.place(capture.data(), "listing.pcap"), "-V", "-O", "ev3").splitlines()
    at = next(index for index, line in enumerate(shown) if line.startswith("    List: "))
    files = ["a\u241b[31m\ufffdb%n, 10 bytes", "c, 281474976710655 bytes", "d\u2421/"]
    assert shown[at + 1 : at + 4] == [f"        {line}" for line in files]


def test_messages_to_mailboxes_are_read(tshark: Tshark) -> None:
    """Their bytes, and each reading that fits: a frame does not say which one was meant."""
    said = {
        b"hello\0": 'text "hello"',
        b"\x01": "logic true",
        b"\0": 'logic false or text ""',
        b"\0\0\xc0\x3f": "number 1.5",
        b"abc\0": 'number 9.127006e-39 or text "abc"',
        b"\xe9\0": 'text "é"',
        b"x\0y": "3 bytes",
    }
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    for payload in said:
        connection.send(ev3proto.system_command("WRITEMAILBOX", name="abc", payload=payload).build())
    path = tshark.place(capture.data(), "mailboxes.pcap")
    readings = ("ev3.payload.text", "ev3.payload.number", "ev3.payload.logic")
    words = [word for name in ("_ws.col.Info", "ev3.payload", *readings) for word in ("-e", name)]
    rows = [line.split("\t") for line in tshark.run(path, "-T", "fields", *words).splitlines()]
    assert [row[0] for row in rows] == [f'WRITEMAILBOX "abc" {text}' for text in said.values()]
    assert [row[1] for row in rows] == [payload.hex() for payload in said]
    assert [row[2:] for row in rows[:3]] == [["hello", "", ""], ["", "", rows[1][4]], ["", "", rows[2][4]]]
    assert (rows[1][4].lower(), rows[2][4].lower()) in {("1", "0"), ("true", "false")}
    assert (rows[3][2:], rows[5][2]) == (["", "1.5", ""], "é")


def test_a_status_is_explained(tshark: Tshark) -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(ev3proto.system_command("CLOSE_FILEHANDLE", reply=True, handle=3).build())
    connection.receive(bytes.fromhex("0600 0000 05 98 01 03"))
    said = tshark.run(tshark.place(capture.data(), "status.pcap"), "-V", "-O", "ev3")
    meaning = "no file is open under that handle"
    assert f"Status: UNKNOWN_HANDLE (0x01): {meaning}" in said
    assert f"the command failed: UNKNOWN_HANDLE: {meaning}" in said
    assert "EV3: reply: CLOSE_FILEHANDLE UNKNOWN_HANDLE" in said
