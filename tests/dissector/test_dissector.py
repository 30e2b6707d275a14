"""The output of the dissector: info column, fields for filters, replies read through their commands, transferred files.

All tests use the real tshark; packet numbers are those of the captures in the repository.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
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

Ask = Callable[..., list[str]]


@pytest.fixture
def ask(tshark: Tshark) -> Ask:
    """The values of a field in the packets that match a filter, a line per packet."""

    def asked(display_filter: str, *fields: str, capture: Path = WIFI, passes: int = 2) -> list[str]:
        words = ["-T", "fields", "-Y", display_filter]
        for field in fields:
            words += ["-e", field]
        if passes == 2:
            words.append("-2")
        return tshark.run(capture, *words).splitlines()

    return asked


def info(ask: Ask, packet: int, capture: Path = WIFI) -> str:
    (line,) = ask(f"frame.number == {packet}", "_ws.col.Info", capture=capture)
    return line


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
        (13, "INPUT_DEVICE_LIST length=4 (+2 operations)"),
        (
            17,
            "UI_WRITE.LED pattern=LED_ORANGE_PULSE; OUTPUT_SPEED layer=0 nos=6 speed=50 % (+1 operation);"
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


FILTERS = {
    "ev3.sound.tone.frequency > 400": [11],
    "ev3.ui_write.led.pattern == LED_ORANGE_PULSE": [17],
    "ev3.output_speed.speed": [17],
    'ev3.cmd == "INPUT_DEVICE.READY_SI"': [15],
    "ev3.op == OUTPUT_GET_COUNT": [20],
    "ev3.globals > 20": [13, 25],
    'ev3.argument.variable == "GV(24)"': [13],
    "ev3.msg_num == 5 && ev3.cmd_type == 0": [17],
    "ev3.sys_cmd == WRITEMAILBOX": [52],
    "ev3.reply_status == 6": [51],
    "ev3.file_len == 2500": [41],
    'ev3.path_name contains "log"': [31],
    "ev3.max_bytes == 900 && ev3.file_name": [35],
    "ev3.list_size == 112": [32],
    "ev3.list": [32, 34],
    'ev3.mailbox == "abc"': [52],
    'ev3.beacon.name == "myEV3"': [1, 2],
}
"""Filters, and the packets that match."""


@pytest.fixture(scope="module")
def filtered(tshark: Tshark) -> dict[str, list[int]]:
    return tshark.matches(WIFI, list(FILTERS), "-2")


@pytest.mark.parametrize("display_filter", FILTERS)
def test_everything_is_a_field(filtered: dict[str, list[int]], display_filter: str) -> None:
    assert filtered[display_filter] == FILTERS[display_filter]


def test_the_bootloader_has_fields_too(ask: Ask) -> None:
    capture = CAPTURES / "usb-bootloader.pcapng"
    assert ask("ev3.address == 0 && ev3.image_size == 2500", "ev3.sys_cmd", capture=capture) == ["0xf0", "0xf5"]
    assert ask("ev3.hw_id", "ev3.hw_id", "ev3.fw_id", capture=capture) == ["0x0000b67f\t0x00000600"]
    assert ask("ev3.checksum", "ev3.checksum", capture=capture) == ["0xdace64d3"]


def test_a_command_in_the_tree(tshark: Tshark) -> None:
    text = tshark.run(WIFI, "-V", "-Y", "frame.number == 11")
    assert text[text.index("EV3: ") :].rstrip().splitlines() == [
        "EV3: SOUND.TONE volume=5 % frequency=440 Hz duration=250 ms",
        "    [Brick: 192.0.2.10:5555]",
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


def test_the_firmware_whose_instruction_set_is_meant_is_a_preference(tshark: Tshark, ask: Ask) -> None:
    # DYNLOAD_VMLOAD is not an opcode of LEGO's firmware.
    frame = bytes.fromhex("08 00 01 00 00 01 00 f0 00 60")
    capture = one_segment(tshark.folder / "dynload.pcap", frame)
    official = tshark.run(capture, "-V")
    assert "unknown opcode 0xF0 for the official firmware" in official
    xtended = tshark.run(capture, "-V", "-o", "ev3.firmware:xtended")
    assert "unknown opcode 0xF0" not in xtended
    assert "0xf0" in xtended.lower()


# Dialogues


def test_request_and_reply_point_at_each_other(ask: Ask) -> None:
    assert ask("ev3.response_in == 18", "frame.number") == ["17"]
    assert ask("ev3.request_in == 17", "frame.number", "ev3.response_time") == ["18\t0.004300000"]
    # Two commands went out before two replies came back in one segment.
    assert ask("frame.number == 27", "ev3.request_in", "ev3.response_time") == ["24,25\t0.005100000,0.004800000"]
    assert ask("frame.number in {24, 25}", "ev3.response_in") == ["27", "27"]


def test_a_reply_is_read_through_its_command(ask: Ask) -> None:
    assert ask("ev3.ui_read.get_vbatt.value > 7.9", "frame.number") == ["14", "18"]
    (line,) = ask("frame.number == 18", "ev3.ui_read.get_vbatt.value", "ev3.answers")
    value, operation = line.split("\t")
    assert float(value) == pytest.approx(7.92)
    assert operation == "UI_READ.GET_VBATT"
    assert ask("frame.number == 14", "ev3.input_device_list.array", "ev3.input_device.get_name.destination") == [
        "16,32,29,126\tCOL-REFLECT    "
    ]
    assert ask("frame.number == 16", "ev3.input_device.ready_si.values.item") == ["-12,3"]
    assert ask("frame.number == 23", "ev3.output_get_count.tacho") == ["421,-17"]


def test_one_pass_reads_replies_too(ask: Ask) -> None:
    fields = ("frame.number", "ev3.request_in", "ev3.transfer.done", "ev3.ui_read.get_vbatt.value", "ev3.answers")
    assert ask("ev3", *fields, passes=1) == ask("ev3", *fields, passes=2)


def test_commands_without_a_reply_are_said_so_when_all_is_read(ask: Ask) -> None:
    assert ask("ev3.expert.unanswered", "frame.number") == ["54"]
    assert ask("ev3.expert.unanswered", "frame.number", passes=1) == []


def test_replies_whose_command_is_not_in_the_capture_are_said_so(tshark: Tshark) -> None:
    # Two replies in a row show that a connection is a brick's.
    frames = bytes.fromhex("07 00 01 00 02 a4 70 fd 40") + bytes.fromhex("07 00 02 00 02 a4 70 fd 40")
    capture = one_segment(tshark.folder / "orphan.pcap", frames, from_brick=True)
    assert "the command that this reply answers was not seen" in tshark.run(capture, "-V")
    assert "reply: 4 bytes, command not seen" in tshark.run(capture)


def test_every_piece_of_a_file_tells_which_file_and_how_far_it_is(ask: Ask) -> None:
    fields = ("frame.number", "ev3.transfer.path", "ev3.transfer.done", "ev3.transfer.size")
    assert ask("ev3.sys_cmd in {0x92, 0x93} && frame.number < 50", *fields) == [
        "41\t../prjs/log/first.rbf\t0\t2500",
        "42\t../prjs/log/first.rbf\t0\t2500",
        "43\t../prjs/log/first.rbf\t1017\t2500",
        "44\t../prjs/log/first.rbf\t2034\t2500",
        "46\t../prjs/log/first.rbf\t2034\t2500",
        "47\t../prjs/log/first.rbf\t2034\t2500",
        "48\t../prjs/log/first.rbf\t2500\t2500",
        "49\t../prjs/log/first.rbf\t2500\t2500",
    ]
    path = "../prjs/log/values.rtf"
    assert ask("ev3.sys_cmd == 0x95", *fields) == [
        f"37\t{path},{path},{path}\t900,900,900\t2710,2710,2710",
        f"38\t{path}\t1800\t2710",
        f"39\t{path},{path}\t2700,2710\t2710,2710",
    ]


def test_error_replies_and_failures_are_expert_information(ask: Ask) -> None:
    assert ask("ev3.expert.error_reply", "frame.number") == ["29"]
    assert ask("ev3.expert.failed", "frame.number", "_ws.expert.message") == ["51\tthe command failed: ILLEGAL_PATH"]
    assert ask("ev3.expert.misaligned", "frame.number") == ["28"]


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
