"""Frames are found in every carrier, however it splits them; other traffic is left to Wireshark."""

from __future__ import annotations

import io
import random
import re
import struct
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

import pytest
from support.effort import effort
from support.messages import tone, voltage, volts
from support.packets import (
    BRICK,
    HCI_WITH_DIRECTION,
    HOST,
    RAW_IP,
    USBMON,
    Capture,
    Connection,
    Device,
    SerialPort,
    datagram,
    packets_of,
    segment,
)
from support.unlikely_reports import FROM_DEVICE, FROM_HOST, UNLIKELY
from support.wireshark import Tshark

import ev3proto
from ev3proto.capture import Announcement, read
from ev3proto.generate.dissector import profile

CAPTURES = Path(__file__).parents[2] / "captures"
SERIAL = "06165300000a"
UNLOCK = ev3proto.Unlock(SERIAL).build()
ACCEPT = b"Accept:EV340\r\n\r\n\0"

Ask = Callable[..., list[str]]


def begin_upload(counter: int) -> bytes:
    return ev3proto.system_command("BEGIN_UPLOAD", counter=counter, max_bytes=1000, path="a/b.rtf").build()


@pytest.fixture
def ask(tshark: Tshark) -> Ask:
    """Fields of the packets that match a filter, a line per packet."""

    def asked(capture: Capture | Path, display_filter: str, *fields: str, words: Sequence[str] = ()) -> list[str]:
        path = capture if isinstance(capture, Path) else tshark.place(capture.data(), "carrier.pcap")
        arguments = ["-T", "fields", "-Y", display_filter, *words]
        for field in fields or ("frame.number",):
            arguments += ["-e", field]
        return tshark.run(path, *arguments).splitlines()

    return asked


def counters(lines: Iterable[str]) -> list[int]:
    """All counters, in any packets."""
    return [int(number) for line in lines for number in line.split(",") if number]


# TCP

FRAMES = [tone(1), voltage(2), tone(3), begin_upload(4), tone(5)]
STREAM = b"".join(FRAMES)


@pytest.mark.parametrize("words", [[], ["-2"]])
@pytest.mark.parametrize("port", [5555, 10_000])
def test_connections_with_the_same_ports_are_told_apart(ask: Ask, port: int, words: list[str]) -> None:
    """Three of them, each with another client; all count their messages alike, and frames are split."""
    capture = Capture(RAW_IP)
    other_host, other_brick = HOST[:3] + bytes([HOST[3] + 100]), BRICK[:3] + bytes([BRICK[3] + 100])
    connections = [
        Connection(capture, brick_port=port, ends=ends)
        for ends in ((HOST, BRICK), (HOST, other_brick), (other_host, BRICK))
    ]
    for connection in connections:
        connection.send(UNLOCK)
        connection.receive(ACCEPT)
    expected = []
    for counter in range(6):
        for connection in connections:
            connection.send(voltage(counter)[:7])
        asked = [connection.send(voltage(counter)[7:]) for connection in connections]
        answers = [connection.receive(volts(counter)) for connection in reversed(connections)]
        bricks = [f"192.0.2.{ends[3]}:{port}" for ends in (BRICK, other_brick, BRICK)]
        expected += ["\t".join(map(str, each)) for each in zip(answers, reversed(asked), bricks, strict=True)]
    assert ask(capture, "ev3.request_in", "frame.number", "ev3.request_in", "ev3.brick", words=words) == expected


@pytest.mark.parametrize(
    ("ports", "packets"),
    [
        ("6000", ["2"]),
        ("5555,6000", ["1", "2"]),
        ("5999-6001", ["2", "3"]),
        ("5550-5560,6001", ["1", "3"]),
        ("", ["1"]),
    ],
)
def test_a_preference_names_other_ports(ask: Ask, ports: str, packets: list[str]) -> None:
    capture = Capture(RAW_IP)
    for port in (5555, 6000, 6001):
        Connection(capture, brick_port=port).send(tone(1))
    assert ask(capture, "ev3", words=("-o", f"ev3.tcp_ports:{ports}")) == packets


@pytest.mark.parametrize("words", [(), ("-2",)], ids=" ".join)
def test_a_preference_names_the_ports_of_both_ends(ask: Ask, words: tuple[str, ...]) -> None:
    """Data tell which end is the brick, whichever port is lower: commands and the unlock text go to it, the answer to
    the text and replies come from it.
    """
    capture = Capture(RAW_IP)
    for number, (host_port, brick_port) in enumerate([(40_000, 5555), (5600, 50_000)]):
        for begin in range(4):
            connection = Connection(capture, host_port + begin, brick_port, (HOST, BRICK[:3] + bytes((10 * number,))))
            if begin == 1:
                connection.send(UNLOCK)
            if begin in (1, 2):
                connection.receive(ACCEPT)
            if begin == 3:
                connection.receive(volts(9))
            connection.send(voltage(1))
            connection.receive(volts(1))
            connection.send(voltage(2)[:6])
            connection.send(voltage(2)[6:] + voltage(3))
            connection.receive(volts(2)[:6])
            connection.receive(volts(2)[6:] + volts(3))
    words = (*words, "-o", "ev3.tcp_ports:5000-60000", "-E", "occurrence=f")
    bricks = ask(capture, "ev3", "ev3.brick", words=words)
    assert bricks == ["192.0.2.0:5555"] * 20 + ["192.0.2.10:50000"] * 20
    assert counters(ask(capture, "ev3.request_in", "ev3.msg_num", words=words)) == [1, 2] * 8
    assert ask(capture, "ev3.request_in == 0 || ev3.expert.no_boundary", words=words) == []


@pytest.mark.parametrize("words", [(), ("-2",)], ids=" ".join)
def test_a_preference_names_the_port_of_the_computer(ask: Ask, words: tuple[str, ...]) -> None:
    """The unlock text, or Decode As, shows nevertheless that the other end is the brick."""
    for is_unlocked in (True, False):
        capture = Capture(RAW_IP)
        connection = Connection(capture, 40_000, 61_000)
        if is_unlocked:
            connection.send(UNLOCK)
            connection.receive(ACCEPT)
        connection.send(voltage(1)[:6])
        connection.send(voltage(1)[6:] + voltage(2))
        connection.receive(volts(1)[:6])
        connection.receive(volts(1)[6:] + volts(2))
        chosen = () if is_unlocked else ("-d", "tcp.port==61000,ev3")
        asked = (*words, *chosen, "-o", "ev3.tcp_ports:5000-60000", "-E", "occurrence=f")
        bricks = ask(capture, "ev3", "ev3.brick", words=asked)
        assert bricks == ["192.0.2.10:61000"] * (4 if is_unlocked else 2)
        assert ask(capture, "ev3.request_in", "ev3.msg_num", words=(*asked, "-E", "occurrence=a")) == ["1,2"]


def test_decode_as_on_another_port(ask: Ask) -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture, brick_port=6000)
    connection.send(voltage(7)[:3])
    connection.send(voltage(7)[3:])
    connection.receive(volts(7))
    assert ask(capture, "ev3") == []
    fields = ("frame.number", "ev3.msg_num", "ev3.request_in")
    assert ask(capture, "ev3", *fields, words=("-d", "tcp.port==6000,ev3")) == ["2\t7\t", "3\t7\t2"]


def test_frames_are_cut_anywhere(ask: Ask) -> None:
    """Two segments for all frames, split at every place; the same from the brick, with replies."""
    replies = b"".join(volts(number) for number in range(1, 6))
    capture = Capture(RAW_IP)
    for at in range(1, len(STREAM)):
        connection = Connection(capture, 10_000 + at)
        for piece in (STREAM[:at], STREAM[at:]):
            connection.send(piece)
        for piece in (replies[: at % len(replies)], replies[at % len(replies) :]):
            connection.receive(piece) if piece else None
    found = counters(ask(capture, "tcp.dstport == 5555", "ev3.msg_num"))
    assert found == [1, 2, 3, 4, 5] * (len(STREAM) - 1)
    assert counters(ask(capture, "tcp.srcport == 5555", "ev3.msg_num")) == found
    assert ask(capture, "ev3.expert.cut_off || ev3.expert.no_boundary || ev3.expert.fault") == []


def test_both_directions_at_once(ask: Ask) -> None:
    """While a reply arrives in pieces, so do commands."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(voltage(1) + voltage(2)[:4])
    connection.receive(volts(1)[:6])
    connection.send(voltage(2)[4:] + voltage(3))
    connection.receive(volts(1)[6:] + volts(2) + volts(3)[:1])
    connection.receive(volts(3)[1:])
    fields = ("frame.number", "ev3.msg_num", "ev3.request_in", "ev3.ui_read.get_vbatt.value")
    assert ask(capture, "ev3", *fields) == ["1\t1\t\t", "3\t2,3\t\t", "4\t1,2\t1,3\t7.5,7.5", "5\t3\t3\t7.5"]


def test_segments_out_of_order(ask: Ask) -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(tone(0))
    pieces = [connection.segment(True, STREAM[at : at + 20]) for at in range(0, len(STREAM), 20)]
    for piece in (pieces[0], pieces[2], pieces[1], *pieces[:2:-1]):
        capture.add(piece)
    words = ("-o", "tcp.reassemble_out_of_order:TRUE")
    assert counters(ask(capture, "ev3", "ev3.msg_num", words=words)) == [0, 1, 2, 3, 4, 5]
    assert ask(capture, "ev3.expert.no_boundary", words=words) == []


@pytest.mark.parametrize("words", [(), ("-2",)], ids=" ".join)
def test_a_connection_with_segments_out_of_order_and_twice(ask: Ask, words: tuple[str, ...]) -> None:
    path = CAPTURES / "wifi-reordered.pcap"
    words = (*words, "-o", "tcp.reassemble_out_of_order:TRUE")
    found = counters(ask(path, "ev3", "ev3.msg_num", words=words))
    assert sorted(found) == [number for number in range(0x8000, 0x8007) for _ in range(2)]
    assert ask(path, "ev3.expert.no_boundary || ev3.expert.fault || ev3.expert.orphan", words=words) == []


UNLOCKS = [
    b"GET /target?sn=06165300000a VMTP1.0\nProtocol: EV3",
    b"GET /target?sn=06165300000a VMTP1.0\nProtocol: EV3\n",
    b"GET /target?sn=06165300000a VMTP1.0\nProtocol: EV3\n\n",
    b"GET /target?sn=06165300000aVMTP1.0\nProtocol: EV3",
    b"GET /target?sn=06165300000a VMTP1.0\r\nProtocol: EV3\r\n\r\n",
    b"GET /target?sn=06165300000a\r\nProtocol: EV3\r\n\r\n",
    b"GET /target?sn=06165300000a VMTP1.0\r\nProtocol:EV3\r\n\r\n",
    b"GET /target?sn=06165300000a\nProtocol:EV3\n",
]


def test_texts_precede_the_frames(ask: Ask) -> None:
    """Every end of the text, in its own segment or together with the frame: a connection each."""
    capture = Capture(RAW_IP)
    ways = [(unlock, apart) for unlock in UNLOCKS for apart in (True, False)]
    for port, (unlock, apart) in enumerate(ways, 10_000):
        connection = Connection(capture, port)
        for send, text, frame in ((connection.send, unlock, voltage(1)), (connection.receive, ACCEPT, volts(1))):
            for piece in (text, frame) if apart else (text + frame,):
                send(piece)
    ports = [str(port) for port in range(10_000, 10_000 + len(ways))]
    assert ask(capture, "ev3.unlock", "tcp.srcport", "ev3.unlock.serial") == [f"{port}\t{SERIAL}" for port in ports]
    assert ask(capture, "ev3.accept", "tcp.dstport") == ports
    commands = ask(capture, "ev3.msg_num && tcp.dstport == 5555", "tcp.srcport", "ev3.msg_num")
    assert commands == [f"{port}\t1" for port in ports]
    fields = ("tcp.dstport", "ev3.msg_num", "ev3.ui_read.get_vbatt.value")
    assert ask(capture, "ev3.msg_num && tcp.srcport == 5555", *fields) == [f"{port}\t1\t7.5" for port in ports]
    assert ask(capture, "ev3.rest") == []


def test_texts_are_cut_anywhere(ask: Ask) -> None:
    text = UNLOCKS[2]
    capture = Capture(RAW_IP)
    for at in range(1, len(text)):
        connection = Connection(capture, 10_000 + at)
        for piece in (text[:at], text[at:], tone(at)):
            connection.send(piece)
    assert counters(ask(capture, "ev3", "ev3.msg_num")) == list(range(1, len(text)))
    assert ask(capture, "ev3.unlock", "ev3.unlock.serial") == [SERIAL] * (len(text) - 1)
    assert ask(capture, "ev3.expert.no_boundary") == []


NAMED = "no frame can start here: this is text; a Messaging block needs WRITEMAILBOX"


@pytest.mark.parametrize("words", [(), ("-2",)])
def test_plain_text_to_a_brick_is_named(ask: Ask, words: tuple[str, ...]) -> None:
    """As Serial.println and App Inventor send it, after the text that unlocks the brick."""
    capture = Capture(RAW_IP)
    connection = Connection(capture, 10_000)
    for piece in (
        UNLOCKS[0],
        b"forward",
        b"forward\r\n",
        b"stop\0",
        voltage(1),
        b"turn left" + voltage(2),
        b"\xc3\xa9\xc3\xa9",
    ):
        connection.send(piece)
    found = ask(capture, "ev3", "_ws.col.Info", words=words)
    assert found[1:4] == ["text, not a frame: forward"] * 2 + ["text, not a frame: stop"]
    assert found[4].startswith("UI_READ.GET_VBATT")
    assert found[5].startswith("text, not a frame: turn left; UI_READ.GET_VBATT")
    assert found[6] == "no frame (4 bytes)"
    assert ask(capture, f'_ws.expert.message == "{NAMED}"', words=words) == ["2", "3", "4", "6"]


def test_plain_text_is_named_only_where_a_brick_is_sure(ask: Ask) -> None:
    """Port 5555 alone is not enough: there a reply has proved the brick."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(voltage(1))
    connection.receive(volts(1))
    connection.send(b"forward")
    assert ask(capture, "ev3", "_ws.col.Info")[2] == "no frame (7 bytes)"
    chosen = ask(capture, "ev3", "_ws.col.Info", words=("-o", "ev3.tcp_ports:5555"))
    assert chosen[2] == "text, not a frame: forward"


def test_plain_text_over_a_channel_that_the_user_chose(ask: Ask) -> None:
    capture, port = rfcomm(5)
    for piece in (b"forward", b"backward\n", voltage(1)):
        port.send(piece)
    found = ask(capture, "ev3", "_ws.col.Info", words=("-d", "btrfcomm.dlci==10,ev3_all"))
    assert found[:2] == ["text, not a frame: forward", "text, not a frame: backward"]
    assert found[2].startswith("UI_READ.GET_VBATT")


def test_a_command_captured_after_its_reply_is_a_message_of_its_own(ask: Ask) -> None:
    """As on two interfaces. TCP needs the order for this: Wireshark takes acknowledged data for repeated."""
    device, port = Device(Capture(USBMON)), SerialPort(Capture(HCI_WITH_DIRECTION))
    streams: tuple[Connection | Device | SerialPort, ...] = (Connection(Capture(RAW_IP)), device, port)
    for stream in streams:
        stream.send(voltage(1))
        stream.receive(volts(1))
        if isinstance(stream, Connection):
            command, reply = (segment(True, 11, voltage(2)), segment(False, 10, volts(2), acknowledged=21))
            late = [stream.capture.add(packet) for packet in (reply, command)][1]
            stream.numbers = {True: 21, False: 19}
        else:
            stream.receive(volts(2))
            late = stream.send(voltage(2))
        stream.send(voltage(3))
        stream.receive(volts(3))
        words = ("-o", "tcp.reassemble_out_of_order:TRUE")
        said = ask(stream.capture, "ev3.msg_num == 2", "frame.number", "ev3.cmd_type", "ev3.request_in", words=words)
        assert said == [f"{late - 1}\t0x02\t", f"{late}\t0x00\t"]
        assert counters(ask(stream.capture, "ev3.request_in", "ev3.msg_num", words=words)) == [1, 3]


# UDP

BEACON = ev3proto.Beacon(SERIAL, name="myEV3").build()


def answer(port: int, target_port: int, target: bytes = BRICK) -> bytes:
    return datagram(b"\0", HOST, port, target, target_port)


def test_a_beacon_and_answers_from_or_to_its_port(ask: Ask) -> None:
    capture = Capture(RAW_IP)
    capture.add(answer(3015, 41_234))  # too early
    capture.add(datagram(BEACON, port=41_234))
    capture.add(answer(40_000, 3015))
    capture.add(answer(3015, 41_234))
    capture.add(answer(40_000, 41_234))  # between other ports
    capture.add(answer(3015, 41_234, HOST))  # to another machine
    assert ask(capture, "ev3.beacon.name", "frame.number", "ev3.beacon.serial") == [f"2\t{SERIAL}"]
    assert ask(capture, "ev3.beacon.answer") == ["3", "4"]
    assert ask(capture, "ev3.beacon.answer", words=("-2",)) == ["3", "4"]


def test_a_beacon_with_another_line(tshark: Tshark) -> None:
    capture = Capture(RAW_IP)
    capture.add(datagram(b"Serial-Number: 06165300000a\r\nPort: 5555\r\nColour: red\r\nProtocol: EV3\r\n"))
    text = tshark.run(tshark.place(capture.data(), "beacon.pcap"), "-V")
    assert "at offset 41: expected a line 'Name: ...'" in text
    assert "    Port: 5555" in text


def test_a_beacon_with_a_port_that_there_cannot_be(tshark: Tshark) -> None:
    capture = Capture(RAW_IP)
    for number, port in enumerate((b"0", b"65536", b"1" + 30 * b"0", b"9" * 400)):
        capture.add(datagram(BEACON.replace(b"5555", port), port=50_000 + number))
        capture.add(answer(3015, 50_000 + number))
    path = tshark.place(capture.data(), "ports.pcap")
    assert tshark.lua_errors(path, "-V") == []
    assert tshark.run(path, "-Y", "ev3.beacon.serial", "-T", "fields", "-e", "frame.number").split() == list("1357")
    bricks = tshark.run(path, "-Y", "ev3.beacon.answer", "-T", "fields", "-e", "ev3.brick").split()
    assert bricks == [f"192.0.2.10:{50_000 + number}" for number in range(4)]


def test_a_beacon_of_which_less_was_captured(ask: Ask) -> None:
    """A beacon at its limits: the first label has 15 bytes, the first line 29, the last label ends at 64."""
    whole = datagram(BEACON)
    head = len(whole) - len(BEACON)
    capture = Capture(RAW_IP)
    for captured in (14, 15, 27, 29, 32, 40, 65):
        capture.add(whole[: head + captured], len(whole))
    assert ask(capture, "ev3") == ["2", "3", "4", "5", "6", "7"]
    events = read(io.BytesIO(capture.data())).events()
    assert [event.numbers for event in events if isinstance(event, Announcement)] == [(n,) for n in range(2, 8)]


def test_decode_as_takes_faulty_beacons(ask: Ask) -> None:
    capture = Capture(RAW_IP)
    capture.add(datagram(b"Serial-Number: 06165300000a\r\nProtocol: EV3\r\n", target_port=3016))
    words = ("-d", "udp.port==3016,ev3")
    assert ask(capture, "ev3.beacon.serial", "ev3.beacon.serial", words=words) == [SERIAL]


# USB


def known(capture: Capture, product: int = 0x0005, number: int = 7) -> Device:
    device = Device(capture, number)
    device.enumerate(0x0694, product)
    return device


@pytest.mark.parametrize("product", [0x0005, 0x0006])
def test_a_brick_is_known_by_its_product(ask: Ask, product: int) -> None:
    capture = Capture(USBMON)
    brick, other = known(capture, product), Device(capture, 8)
    other.enumerate(0x1234, product)
    # Only from a brick: a command that ends inside an operation.
    frame = bytes.fromhex("0800 0100 80 0000 94 01 01")
    sent = brick.send(frame)
    other.send(frame)
    assert ask(capture, "ev3") == [str(sent)]
    assert ask(capture, "ev3.expert.cut_off") == [str(sent)]


@pytest.mark.parametrize("is_known", [True, False])
def test_bulk_transfers_are_left_to_wireshark(ask: Ask, is_known: bool) -> None:
    """Other programs on a brick have the brick's product number and use their own protocol in these."""
    capture = Capture(USBMON)
    brick = known(capture) if is_known else Device(capture)
    brick.kind = Device.BULK
    for data in (voltage(1), bytes.fromhex("FFFF0000 80"), bytes.fromhex("0800 0100 80 0000 94 01 01")):
        brick.send(data)
        brick.receive(data)
    assert ask(capture, "usb.transfer_type == 3") != []
    assert ask(capture, "ev3") == []


@pytest.mark.parametrize("is_known", [True, False])
def test_what_is_behind_the_frame_is_padding(tshark: Tshark, is_known: bool) -> None:
    capture = Capture(USBMON)
    brick = known(capture) if is_known else Device(capture)
    pairs = [(brick.send, voltage(1)), (brick.receive, volts(1)), (brick.send, begin_upload(2))]
    for send, frame in pairs:
        send(frame, b"what an earlier frame left")
    packets = tshark.packets(tshark.place(capture.data(), "padding.pcap"), "-Y", "ev3")
    for packet, (_, frame) in zip(packets, pairs, strict=True):
        start = int(packet.ev3.msg_len.pos)
        padding = packet.ev3.padding
        assert (int(padding.pos) - start, int(padding.size)) == (len(frame), 1024 - len(frame))
        assert bytes.fromhex(padding.raw_value).startswith(b"what an earlier")


def test_reports_without_a_whole_frame_are_left_to_wireshark(ask: Ask) -> None:
    """Each report is from another device; the last device sends a frame."""
    capture = Capture(USBMON)
    sent = {}
    for number, (report, (from_host, data)) in enumerate(UNLIKELY.items(), 1):
        device = Device(capture, number)
        sent[str((device.send if from_host else device.receive)(data))] = report
    last = Device(capture, 100).send(voltage(1))
    found = ask(capture, "ev3")
    assert [sent.get(packet, packet) for packet in found] == [str(last)]


def test_other_devices_are_left_to_wireshark(ask: Ask) -> None:
    mouse, key = 'usb.addr == "1.3.1"', 'usb.addr == "1.5.1"'
    path = CAPTURES / "usb-plugged.pcap"
    assert ask(path, f"({mouse} || {key}) && usb.data_len > 0") != []
    assert ask(path, f"({mouse} || {key}) && ev3") == []


@pytest.mark.parametrize(
    ("size", "first", "most"),
    [
        pytest.param(4, b"", 0, id="mouse"),
        pytest.param(8, b"", 0, id="keyboard"),
        pytest.param(64, b"", 0, id="vendor's own, 64 bytes"),
        pytest.param(64, bytes.fromhex("0A000001"), 1, id="security key"),
        pytest.param(1024, b"", 5, id="vendor's own, 1024 bytes"),
    ],
)
def test_of_many_random_reports_hardly_any_is_taken_for_a_frame(ask: Ask, size: int, first: bytes, most: int) -> None:
    """At most `most` of a hundred thousand. Some of those with 1024 bytes are taken: replies may contain any memory."""
    rng = random.Random(size)
    capture = Capture(USBMON)
    device = Device(capture, size=size)
    for _ in range(effort(8_000, 50_000)):
        device.send(first + rng.randbytes(size - len(first)))
        device.receive(first + rng.randbytes(size - len(first)))
    assert len(ask(capture, "ev3")) <= most


# Daisy chain


def test_reports_between_bricks(ask: Ask) -> None:
    lines = ask(CAPTURES / "daisy.pcap", "ev3", "_ws.col.Info")
    assert lines[0] == "daisy INFO layer 0 to 1"
    assert lines[3] == "daisy DOWNSTREAM layer 0 to 1: OUTPUT_SPEED layer=0 nos=B+C speed=50 % (+OUTPUT_START)"
    assert lines[5] == "daisy reply layer 1 to 0"
    assert len(lines) == 8


def test_a_computer_sends_daisy_messages_in_its_own_reports(ask: Ask) -> None:
    """With 1024 bytes: nothing in them contradicts what else the computer sends."""
    capture = Capture(USBMON)
    device = Device(capture)
    for _ in range(3):
        device.send(bytes.fromhex("0600 0100 0A A2 00 01"))
        device.receive(bytes.fromhex("0500 0100 08 01 00"))
    device.send(bytes.fromhex("0600 0200 8A A3 00 01"))
    device.send(voltage(3))
    device.receive(volts(3))
    found = ask(capture, "ev3", "ev3.cmd_type", "ev3.request_in")
    assert found == [*["0x0a\t", "0x08\t1", "0x0a\t", "0x08\t3", "0x0a\t", "0x08\t5"], "0x8a\t", "0x00\t", "0x02\t8"]


def test_bricks_in_a_chain_are_few(ask: Ask) -> None:
    capture = Capture(USBMON)
    device = Device(capture, size=64)
    device.send(bytes.fromhex("0600 0100 0A A2 00 63"))
    device.receive(bytes.fromhex("0500 0100 08 63 00"))
    assert ask(capture, "ev3") == []


# Bluetooth


def rfcomm(channel: int = 1) -> tuple[Capture, SerialPort]:
    capture = Capture(HCI_WITH_DIRECTION)
    return capture, SerialPort(capture, channel)


def test_decode_as_on_another_channel(ask: Ask) -> None:
    capture, port = rfcomm(5)
    port.send(voltage(1) + voltage(2)[:4])
    port.send(voltage(2)[4:])
    port.receive(volts(1) + volts(2))
    assert ask(capture, "ev3") == []
    # A DLCI is twice the channel, and one more where the other end opened it.
    found = ask(capture, "ev3.msg_num", "ev3.msg_num", "ev3.request_in", words=("-d", "btrfcomm.dlci==10,ev3"))
    assert found == ["1\t", "2\t", "1,2\t3,4"]


def test_frames_cut_over_rfcomm_frames_and_sharing_them(ask: Ask) -> None:
    capture = Capture(HCI_WITH_DIRECTION)
    places = range(HEADER, len(STREAM))
    for at in places:
        port = SerialPort(capture, connection=at)
        for piece in (STREAM[:at], STREAM[at:]):
            port.send(piece)
    assert counters(ask(capture, "ev3", "ev3.msg_num")) == [1, 2, 3, 4, 5] * len(places)


HEADER = 5
"""Bytes that show whether a stream may be of this protocol."""


def test_the_parts_of_a_frame_point_at_each_other(ask: Ask) -> None:
    capture, port = rfcomm()
    first = port.send(begin_upload(1)[:6])
    second = port.send(begin_upload(1)[6:12])
    third = port.send(begin_upload(1)[12:])
    fields = ("frame.number", "ev3.fragment_of", "ev3.fragments", "ev3.msg_num")
    assert ask(capture, "ev3", *fields, words=("-2",)) == [
        f"{first}\t{third}\t\t",
        f"{second}\t{third}\t{first}\t",
        f"{third}\t\t{first},{second}\t1",
    ]


HANDSFREE = (
    (FROM_HOST, b"AT+BRSF=191\r"),
    (FROM_DEVICE, b"\r\n+BRSF: 103\r\n"),
    (FROM_DEVICE, b"\r\nOK\r\n"),
    (FROM_HOST, b"AT+CIND=?\r"),
    (FROM_DEVICE, b'\r\n+CIND: ("service",(0,1)),("call",(0,1))\r\n\r\nOK\r\n'),
    (FROM_HOST, b"ATD5551234;\r"),
    (FROM_DEVICE, b"\r\nERROR\r\n"),
)


@pytest.mark.parametrize("is_typed", [False, True])
def test_other_protocols_on_channel_1_are_left_to_wireshark(ask: Ask, is_typed: bool) -> None:
    capture, port = rfcomm()
    for from_host, text in HANDSFREE:
        for piece in [bytes((byte,)) for byte in text] if is_typed else [text]:
            (port.send if from_host else port.receive)(piece)
    assert ask(capture, "ev3 || ev3.fragment") == []
    assert len(ask(capture, "btrfcomm.len > 0")) == sum(len(text) if is_typed else 1 for _, text in HANDSFREE)


def test_a_stream_whose_first_piece_says_nothing_yet(ask: Ask) -> None:
    """It is not shown before the frame is complete, as it might be another program's."""
    capture, port = rfcomm()
    numbers = [port.send(piece) for piece in (voltage(1)[:1], voltage(1)[1:3], voltage(1)[3:] + tone(2))]
    fields = ("frame.number", "ev3.fragments", "ev3.msg_num")
    whole = f"{numbers[2]}\t{numbers[0]},{numbers[1]}\t1,2"
    assert ask(capture, "ev3", *fields) == [whole]
    parts = [f"{numbers[0]}\t\t", f"{numbers[1]}\t{numbers[0]}\t"]
    assert ask(capture, "ev3", *fields, words=("-2",)) == [*parts, whole]


def test_a_device_whose_name_is_learnt_on_the_way_stays_the_same(ask: Ask) -> None:
    """With a name Wireshark shows another address."""
    address = bytes.fromhex("0A0000531606")
    capture = Capture(HCI_WITH_DIRECTION)
    event(capture, 0x03, struct.pack("<BH6sBB", 0, 0x00B, address, 1, 0))
    port = SerialPort(capture)
    asked = port.send(voltage(1))
    port.receive(volts(1)[:6])
    event(capture, 0x07, struct.pack("<B6s248s", 0, address, b"myEV3"))
    answered = port.receive(volts(1)[6:])
    assert ask(capture, "ev3.request_in", "frame.number", "ev3.request_in") == [f"{answered}\t{asked}"]


def event(capture: Capture, code: int, body: bytes) -> None:
    """Reports of the host's Bluetooth controller."""
    capture.add(struct.pack(">IBBB", 1, 4, code, len(body)) + body)


def test_a_frame_of_which_less_was_captured_hides_none_behind_it(ask: Ask) -> None:
    capture, port = rfcomm()
    port.send(tone(1))
    whole = Capture(HCI_WITH_DIRECTION)
    port.capture = whole
    port.send(tone(2))
    (packet,) = list(packets_of(whole.data()))
    capture.add(packet[:-6], len(packet))
    port.capture = capture
    port.send(tone(3))
    assert counters(ask(capture, "ev3", "ev3.msg_num")) == [1, 2, 3]
    assert ask(capture, "ev3.expert.cut_by_capture", "ev3.msg_num") == ["2"]
    assert ask(capture, "ev3.expert.cut_off") == []


def test_downloads_are_longer_than_all_other_frames(tshark: Tshark) -> None:
    long = struct.pack("<HHBBB", 1105, 7, 0x01, 0x93, 0) + bytes(1100)
    stream = voltage(1) + long + voltage(2)
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(UNLOCK)
    for at in range(0, len(stream), 1000):
        connection.send(stream[at : at + 1000])
    said = tshark.run(tshark.place(capture.data(), "long.pcap"), "-Y", "ev3", "-T", "fields", "-e", "_ws.col.Info")
    lines = [line for text in said.splitlines()[1:] for line in text.split("; ")]
    assert lines == ["UI_READ.GET_VBATT", "CONTINUE_DOWNLOAD 1100 bytes", "UI_READ.GET_VBATT"]
    capture = Capture(HCI_WITH_DIRECTION)
    port = SerialPort(capture)
    for piece in (voltage(1), long[:600], long[600:], voltage(2)):
        port.send(piece)
    said = tshark.run(
        tshark.place(capture.data(), "long-serial.pcap"), "-Y", "ev3.msg_len", "-T", "fields", "-e", "ev3.msg_len"
    )
    assert said.split() == ["8", "1105", "8"]


@pytest.mark.parametrize("size", [1, 2, 3, 100])
def test_polls_between_frames_are_passed_over(tshark: Tshark, size: int) -> None:
    stream = voltage(1) + bytes(2) + voltage(2) + bytes(6) + voltage(3) + bytes(2)
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(UNLOCK)
    for at in range(0, len(stream), size):
        connection.send(stream[at : at + size])
    path = tshark.place(capture.data(), "polls.pcap")
    assert tshark.run(path, "-Y", "ev3.msg_num", "-T", "fields", "-e", "ev3.msg_num").replace(
        ",", "\n"
    ).split() == list("123")
    assert tshark.run(path, "-Y", "ev3.expert.no_boundary") == ""


def test_padding_is_within_its_message(tshark: Tshark) -> None:
    text = tshark.run(CAPTURES / "usb.pcapng", "-T", "pdml", "-Y", "ev3.padding")
    for packet in text.split("<packet>")[1:]:
        inside = packet[packet.index('<proto name="ev3"') :]
        places = [re.search(rf'name="{name}".*? size="(\d+)" pos="(\d+)"', inside) for name in ("ev3", "ev3.padding")]
        (size, start), (padding, at) = (map(int, place.groups()) for place in places if place)
        assert start <= at
        assert at + padding == start + size


def test_the_button_of_the_profile_hides_what_is_not_a_message(tshark: Tshark) -> None:
    """Bare acknowledgements, keep-alives, USB enumeration."""
    shows = {label: text for label, text, _ in profile.BUTTONS}["EV3 only"]
    for name in ("wifi.pcapng", "ev3_dc.pcap", "usb.pcapng", "usb-plugged.pcap"):
        assert tshark.run(CAPTURES / name, "-Y", shows) != ""
        assert tshark.run(CAPTURES / name, "-Y", f"({shows}) && (tcp.len == 0 || usb.setup.bRequest)") == ""


# Names of hosts


def _name_answer(name: str, address: bytes) -> bytes:
    """A datagram with an answer to the question for a name, from which Wireshark learns it."""
    question = b"".join(bytes((len(part),)) + part.encode() for part in name.split(".")) + b"\0"
    data = struct.pack(">HHHHHH", 1, 0x8180, 1, 1, 0, 0) + question + struct.pack(">HH", 1, 1)
    data += b"\xc0\x0c" + struct.pack(">HHIH", 1, 1, 3600, 4) + address
    return datagram(data, bytes((192, 0, 2, 53)), 53, HOST, 40_000)


def test_names_of_hosts_change_nothing_that_is_found(tshark: Tshark) -> None:
    """Names from a file, and names that are learned in the middle; two bricks have connections with the same ports."""
    capture = Capture(RAW_IP)
    capture.add(datagram(ev3proto.Beacon(SERIAL, name="myEV3").build().replace(b"5555", b"16000")))
    both = [Connection(capture, ends=(HOST, BRICK[:3] + bytes((10 + number,)))) for number in range(2)]
    announced = Connection(capture, 50_000, brick_port=16_000)
    for counter in range(12):
        for connection in both:
            connection.send(voltage(counter)[:6])
            connection.send(voltage(counter)[6:] + tone(100 + counter)[:9])
            connection.receive(volts(counter))
            connection.send(tone(100 + counter)[9:])
        if counter > 7:
            both[0].segment(True, bytes(5))  # a gap
            both[0].send(tone(counter)[5:] + tone(200 + counter))
            announced.send(voltage(counter))
        if counter in (3, 5, 9):
            capture.add(_name_answer(f"brick{counter}.example", BRICK if counter != 5 else HOST))
    path = tshark.place(capture.data(), "names.pcap")
    hosts = tshark.place(b"192.0.2.10 robot.example\n192.0.2.1 computer.example\n", "hosts")
    fields = ("-Y", "ev3.msg_num", "-T", "fields", "-e", "frame.number", "-e", "ev3.msg_num", "-e", "ev3.request_in")
    for passes in ((), ("-2",)):
        plain = tshark.run(path, *passes, *fields)
        assert len(plain.splitlines()) == 80
        for words in (("-N", "nd"), ("-N", "n", "-H", str(hosts))):
            assert tshark.run(path, *words, *passes, *fields) == plain
