"""Faults of a frame are reported with their place; nothing on the wire makes the dissector fail, hang, or lose its way.

Correct frames that were mutated are sent over all carriers: 1,000, or 100,000 in the thorough tests.
The frames are drawn once, the mutations depend on a seed: every run reads the same bytes.
"""

from __future__ import annotations

import random
import re
import struct
import subprocess
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from support.effort import effort
from support.frames import drawn
from support.packets import (
    HCI_WITH_DIRECTION,
    HOST_PORT,
    RAW_IP,
    USBMON,
    Capture,
    Connection,
    Device,
    SerialPort,
    cut,
    datagram,
    packets_of,
)
from support.wireshark import Tshark

import ev3proto
from ev3proto import GV
from ev3proto.tables.discovery import ACCEPT
from ev3proto.testing import daisy_messages, frames

CAPTURES = Path(__file__).parents[2] / "captures"

SHARES = {"tcp": 40, "udp": 5, "usb": 15, "usb guessed": 10, "rfcomm": 25, "daisy": 5}
MUTATED = {carrier: share * effort(10, 1000) for carrier, share in SHARES.items()}
"""The number of mutated frames, and their carriers."""

SEGMENT_HEAD = 40
"""Bytes before the contents of a segment."""

DRAWN = effort(600, 3000)
SECONDS = 60
"""Maximum seconds of tshark for the mutated frames of one carrier; it takes a few."""

BEACON = ev3proto.Beacon("06165300000a", name="myEV3").build()
UNLOCK = ev3proto.Unlock("06165300000a").build()
TONE = bytes.fromhex("0e00 2a00 80 0000 94 01 01 82b801 82e803")
VOLTAGE = bytes.fromhex("0800 0700 00 0400 81 01 60")
VOLTAGE_REPLY = bytes.fromhex("0700 0700 02 a470fd40")


@cache
def good_frames() -> list[bytes]:
    """Frames of every kind that a computer and a brick exchange."""
    return drawn(frames(), DRAWN)


@cache
def good_daisy_frames() -> list[bytes]:
    return [message.build() for message in drawn(daisy_messages(), 300)]


# Mutations


def with_length(frame: bytes, length: int | None = None) -> bytes:
    """The frame with another length field; by default the correct one."""
    fitting = min(len(frame) - 2, 1022) if length is None else length
    return fitting.to_bytes(2, "little") + frame[2:]


def mutated(frame: bytes, rng: random.Random) -> bytes:
    """A frame with one to three faults; half of those that are long enough have a fitting length field."""
    data = bytearray(frame)
    for _ in range(rng.randint(1, 3)):
        at, size = rng.randrange(len(data) + 1), rng.randint(1, 8)
        match rng.randrange(7):
            case 0 if at < len(data):
                data[at] ^= 1 << rng.randrange(8)
            case 1 if at < len(data):
                data[at] = rng.choice((0x00, 0x7F, 0x80, 0x81, 0x83, 0x84, 0x85, 0xA0, 0xC3, 0xE3, 0xFF))
            case 2:
                data[at:at] = rng.randbytes(size)
            case 3:
                del data[at : at + size]
            case 4:
                data[at:at] = data[at : at + size]
            case 5:
                del data[at:]
            case _:
                data[:2] = rng.choice((rng.randrange(0x10000), rng.randrange(64), 1022, 1023)).to_bytes(2, "little")
    if len(data) >= 5 and rng.random() < 0.5:
        data[:2] = min(len(data) - 2, 1022).to_bytes(2, "little")
    return bytes(data) or b"\0"


def mutations(found: list[bytes], count: int, seed: str) -> Iterator[bytes]:
    rng = random.Random(seed)
    return (mutated(rng.choice(found), rng) for _ in range(count))


def answer(frame: bytes, rng: random.Random) -> bytes:
    """A reply with the counter of a faulty command, with memory of any size, independent of the requested size."""
    memory = rng.randbytes(rng.choice((0, 1, 4, 7, 40, rng.randrange(1019))))
    return ev3proto.direct_reply(memory, counter=int.from_bytes(frame[2:4], "little")).build()


def exchanged(found: Iterable[bytes], rng: random.Random) -> Iterator[tuple[bool, bytes]]:
    """Faulty frames in either direction, and answers to those that may be commands which want one."""
    for frame in found:
        wants_reply = len(frame) >= 5 and frame[4] == 0
        yield wants_reply or rng.random() < 0.5, frame
        if wants_reply:
            yield False, answer(frame, rng)


def over_stream(found: Iterable[bytes], rng: random.Random, streams: Callable[[int], Connection | SerialPort]) -> None:
    """Frames in both directions: alone, several together, split anywhere.

    Most have a length field that fits, as others swallow the next frames; now and then a new stream begins.
    """
    stream = streams(0)
    waiting = {True: b"", False: b""}
    for index, (from_host, frame) in enumerate(exchanged(found, rng)):
        if index % 40 == 0:
            stream = streams(index // 40)
            if isinstance(stream, Connection):
                stream.send(mutated(UNLOCK, rng))
                stream.receive(mutated(ACCEPT, rng))
        fits = len(frame) >= 5 and rng.random() < 0.9
        waiting[from_host] += with_length(frame[:1024]) if fits else frame
        if len(waiting[from_host]) > 900 or rng.random() < 0.6:
            data, waiting[from_host] = waiting[from_host], b""
            middle = rng.randrange(len(data)) if rng.random() < 0.2 else 0
            for piece in (data[:middle], data[middle:]):
                for at in range(0, len(piece), 990):
                    (stream.send if from_host else stream.receive)(piece[at : at + 990])


@cache
def mutated_tcp() -> bytes:
    capture = Capture(RAW_IP)
    found = mutations(good_frames(), MUTATED["tcp"], "tcp")
    over_stream(found, random.Random(1), lambda index: Connection(capture, port=10_000 + index))
    return capture.data()


def mutated_udp() -> bytes:
    capture = Capture(RAW_IP)
    for index, data in enumerate(mutations([BEACON, TONE], MUTATED["udp"], "udp")):
        capture.add(datagram(data, port=1024 + index % 3))
    return capture.data()


def mutated_reports(found: list[bytes], count: int, devices: list[Device]) -> None:
    rng = random.Random(len(devices))
    for from_host, data in exchanged(mutations(found, count, f"reports of {len(devices)}"), rng):
        device = rng.choice(devices)
        (device.send if from_host else device.receive)(data, rng.randbytes(20) if rng.random() < 0.5 else b"")


def mutated_usb() -> bytes:
    capture = Capture(USBMON)
    devices = [Device(capture, 7), Device(capture, 8)]
    for device, product in zip(devices, (0x0005, 0x0006), strict=True):
        device.enumerate(0x0694, product)
    mutated_reports(good_frames(), MUTATED["usb"], devices)
    return capture.data()


def mutated_guessed() -> bytes:
    capture = Capture(USBMON)
    mutated_reports(good_frames(), MUTATED["usb guessed"], [Device(capture)])
    return capture.data()


def mutated_rfcomm() -> bytes:
    capture = Capture(HCI_WITH_DIRECTION)
    found = mutations(good_frames(), MUTATED["rfcomm"], "rfcomm")
    over_stream(found, random.Random(2), lambda index: SerialPort(capture, connection=1 + index % 3000))
    return capture.data()


def mutated_daisy() -> bytes:
    capture = Capture(USBMON)
    mutated_reports(good_daisy_frames(), MUTATED["daisy"], [Device(capture, number, size=64) for number in (2, 3, 4)])
    return capture.data()


MAKE: dict[str, Callable[[], bytes]] = {
    "tcp": mutated_tcp,
    "udp": mutated_udp,
    "usb": mutated_usb,
    "usb guessed": mutated_guessed,
    "rfcomm": mutated_rfcomm,
    "daisy": mutated_daisy,
}


def check_no_errors(tshark: Tshark, capture: bytes, *words: str) -> None:
    """Checks that there is no Lua error with the tree on two passes, nor without it on one."""
    path = tshark.place(capture, "faulty.pcap")
    assert tshark.lua_errors(path, "-2", "-V", *words)[:3] == []
    assert tshark.lua_errors(path, *words)[:3] == []


@pytest.mark.parametrize("carrier", MAKE)
def test_no_mutated_frame_makes_an_error_or_hangs(
    tshark: Tshark, carrier: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tshark, "timeout", SECONDS)
    check_no_errors(tshark, MAKE[carrier]())


# Malicious frames


def command(*operations: bytes | str, counter: int = 1, sizes: int = 0, kind: int = 0x00) -> bytes:
    """A direct command of any bytes, which wants a reply."""
    body = b"".join(bytes.fromhex(piece) if isinstance(piece, str) else piece for piece in operations)
    return struct.pack("<HHBH", 5 + len(body), counter, kind, sizes) + body


def reply(memory: bytes, counter: int = 1, kind: int = 0x02) -> bytes:
    return struct.pack("<HHB", 3 + len(memory), counter, kind) + memory


INIT_BYTES, MAILBOX_WRITE, READ, MOVE_FLOAT = "2F 40", "D9 8400 02 846100 00", "9E 00 00 00 00 13", "3F"
NAN, INFINITE, SMALLEST = "83 0000C07F", "83 000080FF", "83 01000000"
LAST_INDEX = "E3 FFFFFFFF"
"""GV4 with the largest possible index."""

ODD: dict[str, list[bytes]] = {
    "a list of -1, of 2 to the 31 and of 2 to the 31 less one values": [
        command(INIT_BYTES, count, "01 02 03") for count in ("3F", "83 00000080", "83 FFFFFF7F")
    ],
    "a list of 500 values": [command(INIT_BYTES, "82 F401", bytes(500))],
    "a list that a variable counts, or a label, or a text": [
        command(INIT_BYTES, count, "01 02") for count in ("41", "A0 02", "84 32 00")
    ],
    "a list of 127 elements, of 128, of -1": [
        command(MAILBOX_WRITE, count, bytes(200)) for count in ("81 7F", "82 8000", "81 FF")
    ],
    "127 outputs at one place, and their reply": [command(READ, "81 7F", "60" * 127, sizes=4), reply(bytes(4))],
    "1017 operations": [command("01" * 1017)],
    "1017 bytes of zero": [command(bytes(1017))],
    "a text without its end": [command("D4 08 84", b"x" * 900), command("D4 08 84"), command("D4 08 80", b"x")],
    "a text of any bytes": [command("D4 08 84", bytes(range(1, 256)), "00")],
    "CMD in all its forms": [
        command("94", cmd, "01 01 01") for cmd in ("81 01", "82 0100", "83 01000000", "83 FFFFFFFF")
    ],
    "unknown CMD": [command("94", cmd, "01 01 01") for cmd in ("41", "61", "84 31 00", "A0 01", "85", "C1 01", "")],
    "floats that are not numbers": [
        command(*(piece for value in (NAN, INFINITE, SMALLEST, "83 FFFFFFFF") for piece in (MOVE_FLOAT, value, "40"))),
        command("C1 0B 00 00 04", NAN, INFINITE, SMALLEST, "83 FFFFFFFF"),
    ],
    "floats in place of numbers, and the other way round": [command(MOVE_FLOAT, "05 40", MOVE_FLOAT, "84 35 00 40")],
    "replies of floats that are not numbers": [
        *(command("81 01 60 81 01 64 81 01 68", sizes=12), reply(bytes.fromhex("0000C07F 000080FF FFFFFFFF"))),
    ],
    "the largest indexes": [
        *(command("81 01", LAST_INDEX, sizes=4), reply(bytes(4))),
        *(command("99 15 00 00 83 FFFFFF7F", LAST_INDEX, sizes=4), reply(bytes(4))),
        *(command("99 15 00 00 83 00000080 60", sizes=4), reply(bytes(4))),
        *(command("7F 01 00 83 FFFFFF7F", LAST_INDEX, LAST_INDEX, sizes=4), reply(bytes(4))),
    ],
    "handles and addresses": [
        *(command("81 01 F1 00 81 01 E9 00 99 15 00 00 10 F9 00", sizes=4), reply(bytes(4))),
        *(command("98 04 F1 01 E9 02", sizes=8), reply(bytes(8))),
    ],
    "replies of every length": [
        piece
        for size in range(24)
        for piece in (command("99 15 00 00 10 60 81 01 70", sizes=20, counter=size), reply(b"x" * size, counter=size))
    ],
    "error replies with memory": [command("81 01 60", sizes=4), reply(bytes(4), kind=0x04)],
    "one counter for many commands": [
        *[command("81 01 60", sizes=4, counter=0xFFFF)] * 40,
        *[reply(bytes(4), counter=0xFFFF)] * 60,
    ],
    "replies to a faulty command": [command("81 01 60 FF", sizes=4), reply(bytes(4)), command("FF"), reply(b"")],
    "system messages that end anywhere": [
        struct.pack("<HHBB", 4 + size, size, kind, number) + bytes(size)
        for number in (*range(0x92, 0xA3), *range(0xF0, 0xF7), 0x00)
        for kind in (0x01, 0x03, 0x05)
        for size in range(9)
    ],
    "texts of system messages with lengths that lie": [
        struct.pack("<HHBBB", 11, 1, 0x81, 0x9E, length) + b"abc\0\xff\xff" for length in (0, 3, 4, 5, 6, 255)
    ],
    "daisy messages that end anywhere": [
        struct.pack("<HHB", 3 + size, 1, kind) + b"\xa0" * size
        for kind in (0x0A, 0x8A, 0x08, 0x09)
        for size in range(50)
    ],
    "files of 4 GB": [
        struct.pack("<HHBBI", 10, counter, 0x01, 0x92, 0xFFFFFFFF) + b"f\0"
        if counter % 2
        else struct.pack("<HHBBBB", 6, counter - 1, 0x03, 0x92, 0, 0)
        for counter in range(1, 9)
    ],
    "no messages": [struct.pack("<HHB", 3, 1, kind) for kind in range(256)],
}


def carrier_of(name: str, capture: Capture, number: int) -> Connection | Device | SerialPort:
    """A new conversation on a carrier; a device is known to be a brick."""
    if name == "tcp":
        return Connection(capture, 10_000 + number)
    if name == "rfcomm":
        return SerialPort(capture, connection=number)
    brick = Device(capture, number)
    brick.enumerate(0x0694, 0x0005)
    return brick


@pytest.mark.parametrize(("name", "link"), [("tcp", RAW_IP), ("usb", USBMON), ("rfcomm", HCI_WITH_DIRECTION)])
def test_nothing_odd_makes_an_error(tshark: Tshark, name: str, link: int) -> None:
    capture = Capture(link)
    for number, odd in enumerate(ODD.values(), 1):
        converse(carrier_of(name, capture, number), odd)
    check_no_errors(tshark, capture.data())


def converse(carrier: Connection | Device | SerialPort, frames: list[bytes]) -> None:
    for frame in frames:
        (carrier.send if frame[4] & 0x7F in (0x00, 0x01) else carrier.receive)(frame)


# The command, the size of the requested memory, and the line on a reply about some memory.
REPLIES: dict[tuple[str, int], dict[str, str]] = {
    ("81 01 60", 4): {  # a DATAF with a unit
        "A470FD40": "UI_READ.GET_VBATT: 7.92 V",
        "00000080": "UI_READ.GET_VBATT: 0 V",
        "0000C0BF": "UI_READ.GET_VBATT: -1.5 V",
        "20BCBE4C": "UI_READ.GET_VBATT: 100000000 V",
        "CA F2 49 F1": "UI_READ.GET_VBATT: -1e+30 V",
        "0000C07F": "UI_READ.GET_VBATT: NaN V",
        "000080FF": "UI_READ.GET_VBATT: -inf V",
        "A470FD": "UI_READ.GET_VBATT: 3 bytes",
    },
    ("81 12 60", 1): {"64": "UI_READ.GET_LBATT: 100 %", "FF": "UI_READ.GET_LBATT: -1 %"},
    ("B3 00 00 60 B3 00 01 64", 8): {
        "FFFFFFFF 00000080": "OUTPUT_GET_COUNT: nos=A: -1 degrees, nos=B: -2147483648 degrees",
        "68010000 00": "OUTPUT_GET_COUNT: nos=A: 360 degrees",
    },
}


def test_a_line_on_a_reply_says_the_same_however_often_its_command_came(tshark: Tshark) -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    expected = []
    for (operations, size), lines in REPLIES.items():
        # The first replies are read in a different way than later ones.
        for memory, line in (*lines.items(), *lines.items()):
            converse(connection, [command(operations, sizes=size), reply(bytes.fromhex(memory))])
            expected.append(f"reply to {line}")
    path = tshark.place(capture.data(), "replies.pcap")
    found = tshark.run(path, "-T", "fields", "-e", "_ws.col.Info").splitlines()
    assert found[1::2] == expected


def test_all_counters(tshark: Tshark) -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    numbers = range(0, 0x10000, effort(15, 1))
    pieces = [numbers[at : at + 100] for at in range(0, len(numbers), 100)]
    for piece in pieces:
        connection.send(b"".join(struct.pack("<HHBHBBB", 8, number, 0, 4, 0x81, 1, 0x60) for number in piece))
    for piece in pieces:
        connection.receive(b"".join(reply(bytes(4), number) for number in piece))
    path = tshark.place(capture.data(), "counters.pcap")
    fields = tshark.run(path, "-T", "fields", "-e", "ev3.request_in").splitlines()
    answered = [line.split(",") for line in fields[capture.count // 2 :]]
    assert numbers[-1] == 0xFFFF
    assert answered == [[str(packet)] * len(piece) for packet, piece in enumerate(pieces, 1)]


@pytest.mark.parametrize("preference", ["tcp.desegment_tcp_streams:FALSE", "tcp.reassemble_out_of_order:TRUE"])
def test_no_setting_of_tcp_makes_an_error(tshark: Tshark, preference: str) -> None:
    check_no_errors(tshark, mutated_tcp(), "-o", preference)


def test_packets_of_which_less_was_captured_make_no_error(tshark: Tshark) -> None:
    ip, usb, bluetooth = Capture(RAW_IP), Capture(USBMON), Capture(HCI_WITH_DIRECTION)
    frames = [UNLOCK, TONE + VOLTAGE, TONE[:9], TONE[9:] + VOLTAGE, TONE]
    port = SerialPort(bluetooth)
    for device, product in ((7, 0x0005), (8, 0x0006)):
        Device(usb, device).enumerate(0x0694, product)
    for most in range(130):
        ip.add(datagram(BEACON)[:most], len(datagram(BEACON)))
        connection = Connection(ip, 10_000 + most)
        for data in frames:
            segment = connection.segment(True, data)
            ip.add(segment[:most], len(segment))
        whole = Capture(HCI_WITH_DIRECTION)
        port.capture = whole
        for data in frames[1:]:
            port.send(data)
            port.receive(VOLTAGE_REPLY * 3)
        for packet in packets_of(whole.data()):
            bluetooth.add(packet[: max(most, 4)], len(packet))
        whole = Capture(USBMON)
        for number in (7, 8, 9):
            Device(whole, number).send(TONE)
        for packet in packets_of(whole.data()):
            usb.add(packet[: 64 + most], len(packet))
    for capture in (ip, usb, bluetooth):
        check_no_errors(tshark, capture.data())


@pytest.mark.parametrize("most", [60, 68, 96])
@pytest.mark.parametrize("name", ["wifi-reordered.pcap", "usb-windows.pcap"])
def test_captures_of_which_less_was_recorded_make_no_error(tshark: Tshark, name: str, most: int) -> None:
    check_no_errors(tshark, cut((CAPTURES / name).read_bytes(), most))


ERRORS = "ev3.expert.fault || ev3.expert.cut_off || ev3.expert.no_boundary"
"""Wireshark itself has a Malformed Packet for each RFCOMM packet that the capture cut."""


@pytest.mark.parametrize(
    ("name", "most"),
    [("wifi.pcapng", 90), ("wifi-long.pcapng", 130), ("ev3_dc.pcap", 90), ("usb.pcapng", 90), ("bluetooth.log", 60)],
)
def test_what_the_capture_cut_is_a_note(tshark: Tshark, name: str, most: int) -> None:
    path = tshark.place(b"", name)
    subprocess.run(["editcap", "-s", str(most), str(CAPTURES / name), str(path)], check=True)
    assert tshark.run(path, "-Y", f"ev3 && ({ERRORS})") == ""
    assert tshark.run(path, "-Y", "ev3.expert.cut_by_capture") != ""


def test_faults_in_what_the_capture_has_of_a_frame_are_errors(tshark: Tshark) -> None:
    """An unknown opcode and an undefined identification byte, but not a list and a text that are cut."""
    frames = ["0C00 0100 80 0000 FE 01020304", "0E00 0200 80 0000 94 01 85 82B801 82E803"]
    frames += ["1200 0300 80 0000 2F 40 0A 0102030405060708090A", "0E00 0400 01 9C 2E2E2F70726A732F00"]
    capture = Capture(RAW_IP)
    for number, frame in enumerate(frames):
        segment = Connection(capture, 10_000 + number).segment(True, bytes.fromhex(frame))
        capture.add(segment[:-3], len(segment))
    path = tshark.place(capture.data(), "cut.pcap")
    shown = tshark.run(path, "-d", "tcp.port==5555,ev3_all", "-o", 'gui.column.format:"Info","%i"').splitlines()
    assert "fault at offset 7: unknown opcode 0xFE" in shown[0]
    assert "fault at offset 9: undefined identification byte 0x85" in shown[1]
    assert [line.endswith(" [cut by the capture]") for line in shown] == [False, False, True, True]


# Boundaries


def counters(tshark: Tshark, capture: Capture) -> list[list[int]]:
    """The counters of all messages in each packet."""
    path = tshark.place(capture.data(), "boundaries.pcap")
    found = []
    for line in tshark.run(path, "-T", "fields", "-e", "ev3.msg_num").splitlines():
        found.append([int(number) for number in line.split(",") if number])
    return found


def test_a_frame_with_faults_inside_hides_none_of_those_beside_it(tshark: Tshark) -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    expected = []
    for number, frame in enumerate(inner_faults(1500)):
        connection.send(good(3 * number) + frame + good(3 * number + 2))
        expected.append([3 * number, int.from_bytes(frame[2:4], "little"), 3 * number + 2])
    assert counters(tshark, capture) == expected
    assert tshark.run(tshark.folder / "boundaries.pcap", "-Y", "ev3.expert.no_boundary") == ""


def test_a_channel_that_begins_with_another_firmwares_operation(tshark: Tshark) -> None:
    capture = Capture(HCI_WITH_DIRECTION)
    # DYNLOAD_VMEXIT, which LEGO's firmware does not have.
    SerialPort(capture).send(command("F1", counter=7, kind=0x80))
    path = tshark.place(capture.data(), "foreign.pcap")
    assert tshark.run(path, "-Y", "ev3", "-T", "fields", "-e", "ev3.msg_num") == "7\n"


@pytest.mark.parametrize("carrier", ["tcp", "rfcomm"])
def test_few_are_hidden_where_they_are_cut(tshark: Tshark, carrier: str) -> None:
    # On RFCOMM, gaps between packets are not marked: a faulty frame that comes in several packets is doubted,
    # as almost all such frames are two whose middle is missing. About one in twenty mutated frames is lost in this way.
    capture = Capture(RAW_IP if carrier == "tcp" else HCI_WITH_DIRECTION)
    stream = Connection(capture) if carrier == "tcp" else SerialPort(capture)
    rng = random.Random(44)
    expected = [0xFFFF]
    data = good(0xFFFF)
    stream.send(data)
    data = b""
    for number, frame in enumerate(inner_faults(1500)):
        data += frame + good(number)
        expected += [int.from_bytes(frame[2:4], "little"), number]
    while data:
        size = rng.choice((1, 2, 3, 5, rng.randint(1, 60), rng.randint(1, 900)))
        stream.send(data[:size])
        data = data[size:]
    found = [number for numbers in counters(tshark, capture) for number in numbers]
    hidden = Counter(expected) - Counter(found)
    invented = Counter(found) - Counter(expected)
    most_hidden = 0.003 if carrier == "tcp" else 0.025
    assert hidden.total() <= most_hidden * len(expected)
    assert invented.total() <= 0.001 * len(expected)


def test_a_gap_after_a_connection_whose_first_frame_came_in_pieces(tshark: Tshark) -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(good(1)[:7])
    connection.send(good(1)[7:] + good(2)[:9])
    connection.segment(True, good(2)[9:])
    connection.send(good(3))
    assert counters(tshark, capture) == [[], [1], [3]]
    check_no_errors(tshark, capture.data())


def inner_faults(count: int) -> Iterator[bytes]:
    """Mutated frames whose length fields are correct."""
    found = mutations(good_frames(), count, "inside")
    return (with_length(frame[:1024]) if len(frame) >= 5 else reply(frame) for frame in found)


def good(counter: int) -> bytes:
    return command("94 01 01 82 B801 82 E803", counter=counter, kind=0x80)


@pytest.mark.parametrize("carrier", ["tcp", "rfcomm"])
def test_an_impossible_length_hides_none_of_the_frames_beside_it(tshark: Tshark, carrier: str) -> None:
    capture = Capture(RAW_IP if carrier == "tcp" else HCI_WITH_DIRECTION)
    stream = Connection(capture) if carrier == "tcp" else SerialPort(capture)
    expected, lost = [], []
    for length in (1, 2, 1023, 1024, 0x0A0A, 0x0A0D, 0x4547, 0x6341, 0xFFFF):
        stream.send(good(length))
        wrong = with_length(good(3), length)
        for start in (good(2), b""):
            number = stream.send(start + wrong + good(4))
            lost.append(f"{number} {wrong.hex()}")
        stream.send(good(5))
        expected += [[length], [2, 4], [4], [5]]
    assert [numbers for numbers in counters(tshark, capture) if numbers] == expected
    words = ("-Y", "ev3.expert.no_boundary", "-T", "fields", "-e", "frame.number", "-e", "ev3.rest")
    lines = tshark.run(tshark.folder / "boundaries.pcap", *words).splitlines()
    assert [f"{line.split()[0]} {''.join(line.split()[1:])}" for line in lines] == lost


# Reports about faults, and their places


class Told(NamedTuple):
    """The report about a faulty frame: the kind of fault, the words, and the bytes that could not be read."""

    kind: str
    words: str
    rest: str = ""


FAULTS = {
    "0C00 0100 80 0000 02 01 F0 60 84 61 00": Told(
        "unknown_opcode",
        "at offset 9: 0xF0 is DYNLOAD_VMLOAD in the dialects xtended and compat, but not an opcode of "
        "official firmware (E201)",
        "F0 60 84 61 00",
    ),
    "0800 0200 80 0000 94 1F 01": Told("unknown_cmd", "at offset 8: SOUND has no CMD 31 (E208)", "94 1F 01"),
    "0800 0200 80 0000 94 41 01": Told(
        "unknown_cmd", "at offset 8: CMD of SOUND is LV(1), but must be a constant (E209)", "94 41 01"
    ),
    "0900 0300 80 0000 94 01 05 82": Told(
        "cut_off",
        "at offset 10: SOUND.TONE: the argument FREQUENCY runs past the end of the frame: LC2 needs 2 more "
        "bytes (E203)",
        "82",
    ),
    "0800 0300 80 0000 94 01 05": Told(
        "cut_off", "at offset 10: SOUND.TONE: the frame ends before the argument FREQUENCY (E203)"
    ),
    "0A00 0300 80 0000 D4 08 84 6D 79": Told(
        "cut_off",
        "at offset 9: COM_SET.SET_BRICKNAME: the string NAME runs past the end of the frame: its terminating zero is "
        "missing (E203)",
        "84 6D 79",
    ),
    "0900 0300 80 0000 94 01 85 00": Told(
        "fault", "at offset 9: undefined identification byte 0x85 for VOLUME of SOUND.TONE (E210)", "85 00"
    ),
    "0D00 0300 80 0008 2F 40 83 00000080 01": Told(
        "fault",
        "at offset 9: LENGTH is -2147483648: the brick reads millions of values before it does anything else (E207)",
        "01",
    ),
    "0800 0400 00 0800 81 01 61": Told("misaligned", "VALUE is GV(1), and must start at a multiple of 4 (E205)"),
    "0800 0500 00 0200 81 01 60": Told(
        "beyond_memory",
        "VALUE takes bytes 0 to 3 of global memory, but the header requests 2 bytes of global memory (E402)",
    ),
    "0B00 0500 80 0000 A4 00 0F 82 C800": Told(
        "misread", "POWER is 200, which the brick reads as -56: it is a DATA8, -127 to 127 (W301)"
    ),
    "0F00 0500 80 0000 94 01 82 2C01 82 B801 81 64": Told(
        "misread", "VOLUME is 300, which the brick truncates to 44: it is a DATA8, -127 to 127 (E301)"
    ),
    "0D00 0500 80 0000 94 01 05 82 204E 81 64": Told(
        "misread", "FREQUENCY is 20000 Hz, outside of 250 to 10000 Hz (W303)"
    ),
    "0800 0500 80 0000 A6 00 10": Told("misread", "NOS is 16, outside of 0 to 15 (W303)"),
    "0800 0500 80 0000 A6 04 01": Told("misread", "LAYER is 4, outside of 0 to 3 (W303)"),
    "0800 0500 80 0000 A6 00 00": Told(
        "misread", "NOS is 0, a bit mask without a port, so OUTPUT_START does nothing (H702)"
    ),
    "0900 0500 00 0400 B3 00 08 60": Told(
        "misread", "NOS is 8, the bit mask of D, but it takes the number of one port (W303)"
    ),
    "0800 0500 80 0000 82 1B 1F": Told("misread", "PATTERN is 31, which is not in LEDPATTERN (W304)"),
    "0A00 0500 80 0000 A6 82 2C01 01": Told(
        "refused", "LAYER is 300, but the brick accepts only -127 to 127 as DATA8 in a first parameter (E204)"
    ),
    "0300 0600 04": Told("error_reply", "the brick refused the command or failed to execute it; it does not say why"),
    "0600 0700 05 92 06 FF": Told("failed", "the command failed: ILLEGAL_PATH"),
    "0500 0700 03 92 07": Told("failed", "the command failed: FILE_EXITS"),
    "0500 0700 03 92 63": Told("failed", "the command failed: status 99"),
    "0700 0800 02 A470FD40": Told("orphan", "the command that this reply answers was not seen"),
    "0800 0900 00 0400 81 01 60": Told("waiting", "no reply to this command was seen so far"),
    "FFFF 0100 80 0000 02 01": Told(
        "no_boundary",
        "no frame can start here: the length field says 65535, but it can be 3 to 1022",
        "FF FF 01 00 80 00 00 02 01",
    ),
    "0500 0100 77 01 02": Told("fault", "at offset 4: unknown message type 0x77 (E105)", "01 02"),
    "0600 0100 01 9D 01 02": Told(
        "fault", "at offset 6: LIST_OPEN_HANDLES: 2 bytes left over after the last field (E802)", "01 02"
    ),
    "0600 0100 01 77 01 02": Told("fault", "at offset 5: unknown system command 0x77 (E801)", "01 02"),
    "0500 0100 01 94 01": Told(
        "fault", "at offset 6: BEGIN_UPLOAD: the frame ends before the field max_bytes (u16) (E802)", "01"
    ),
    "0700 0100 01 9B 61 62 63": Told(
        "fault",
        "at offset 6: CREATE_DIR: the text path runs past the end of the frame: its terminating zero is missing (E802)",
        "61 62 63",
    ),
    "0300 0100 01": Told("cut_off", "at offset 5: the frame ends before the number of the system command (E801)"),
    "0400 0100 03 92": Told("cut_off", "at offset 6: the frame ends before the command answered and the status", "92"),
    "0400 0100 00 00": Told(
        "cut_off", "at offset 6: the command ends before the two bytes that request memory (E106)", "00"
    ),
    "0500 0100 0A A0 00": Told(
        "cut_off", "at offset 7: the frame ends before the sub-command and the two layers (E806)", "A0 00"
    ),
    "0600 0100 8A 77 00 01": Told("fault", "at offset 5: unknown daisy sub-command 0x77 (E806)"),
    "0400 0100 08 00": Told("cut_off", "at offset 6: the frame ends before the two layers", "00"),
}


@pytest.fixture(scope="module")
def faulty(tshark: Tshark) -> dict[str, Any]:
    """All of these as tshark shows them, each in a segment of another connection."""
    capture = Capture(RAW_IP)
    for number, frame in enumerate(FAULTS):
        connection = Connection(capture, HOST_PORT + number)
        connection.send(UNLOCK)
        connection.send(bytes.fromhex(frame))
    path = tshark.place(capture.data(), "faults.pcap")
    packets = tshark.packets(path, "-2", "-Y", "ev3 && !ev3.unlock")
    return {frame: packet.ev3 for frame, packet in zip(FAULTS, packets, strict=True)}


def values(layer: Any, name: str) -> list[Any]:
    found = layer.get_field(name)
    return [] if found is None else list(found.all_fields)


@pytest.mark.parametrize("frame", FAULTS)
def test_what_is_wrong_is_said(faulty: dict[str, Any], frame: str) -> None:
    layer, told = faulty[frame], FAULTS[frame]
    assert values(layer, f"ev3.expert.{told.kind}")
    assert told.words in [field.show for field in values(layer, "_ws.expert.message")]


UNREADABLE = tuple(f"({code})" for code in ("E105", "E106", "E203", "E208", "E209", "E210", "E211", "E801", "E802"))
"""The codes of what cannot be read."""

AFTERWARDS = r"; the brick (?:reads the next|does not notice).*"


def sentences(lines: Iterable[str]) -> set[str]:
    """The errors that are said with a code of the checker, without the place and what the brick does next."""
    found = (re.fullmatch(rf"(?:at offset \d+: )?(.*?)(?:{AFTERWARDS})? (\(E\d+\))", line) for line in lines)
    return {f"{each[1]} {each[2]}" for each in found if each}


def test_errors_are_named_in_the_words_of_check(tshark: Tshark) -> None:
    """Of commands with drawn mutations, and those above, each in a connection of its own."""
    commands = [frame for frame in good_frames() if frame[4] & 0x7F in (0, 1)]
    drawn_ones = [with_length(each[:1000]) for each in mutations(commands, 400, "words") if len(each) > 7]
    given = [frame for frame in map(bytes.fromhex, FAULTS) if int.from_bytes(frame[:2], "little") == len(frame) - 2]
    frames = [frame for frame in (*drawn_ones, *given) if frame[4] & 0x7F in (0, 1)]
    capture = Capture(RAW_IP)
    for number, frame in enumerate(frames):
        connection = Connection(capture, HOST_PORT + number)
        connection.send(UNLOCK)
        connection.send(frame)
    path = tshark.place(capture.data(), "words.pcap")
    words = ("-T", "fields", "-E", "aggregator=\x1f", "-e", "_ws.expert.message", "-Y", "!ev3.unlock")
    lines = tshark.run(path, *words).split("\n")[: len(frames)]
    count = 0
    for frame, line in zip(frames, lines, strict=True):
        said = sentences(f"{each.message} ({each.code})" for each in ev3proto.check(frame).findings)
        shown = sentences(line.split("\x1f"))
        if any(each.endswith("(E202)") for each in said):
            # What follows an OBJECT_END is read as far as possible, but nothing is said of its arguments.
            said, shown = ({each for each in some if each.endswith("(E202)")} for some in (said, shown))
        assert shown <= said, frame.hex(" ")
        assert {each for each in said if each.endswith(UNREADABLE)} <= shown, frame.hex(" ")
        count += len(shown)
    assert count > 200


@pytest.mark.parametrize("frame", FAULTS)
def test_what_could_not_be_read_is_there(faulty: dict[str, Any], frame: str) -> None:
    data, rest = bytes.fromhex(frame), bytes.fromhex(FAULTS[frame].rest)
    found = values(faulty[frame], "ev3.rest")
    assert [bytes.fromhex(field.raw_value) for field in found] == ([rest] if rest else [])
    # It is the end of the frame.
    assert [int(field.pos) + int(field.size) for field in found] == [SEGMENT_HEAD + len(data)] * len(found)


def one_frame(tshark: Tshark, frame: str | bytes) -> Path:
    """A capture of one segment, after the unlock text by which the connection is known to be ours."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(UNLOCK)
    connection.send(bytes.fromhex(frame) if isinstance(frame, str) else frame)
    return tshark.place(capture.data(), "fault.pcap")


def test_one_pass_cannot_know_that_no_reply_comes(tshark: Tshark) -> None:
    path = one_frame(tshark, VOLTAGE)
    assert tshark.run(path, "-Y", "ev3.expert.waiting") == ""
    assert tshark.run(path, "-2", "-Y", "ev3.expert.waiting") != ""


def tree(tshark: Tshark, capture: Path, *words: str) -> str:
    text = tshark.run(capture, "-V", "-Y", "ev3 && !ev3.unlock", *words)
    return text[text.index("EV3: ") :].strip() + "\n"


def test_a_frame_is_shown_up_to_its_fault(tshark: Tshark) -> None:
    frame = "0F00 0100 80 0000 02 01 94 01 05 82B801 84 61"
    assert (
        tree(tshark, one_frame(tshark, frame))
        == """\
EV3: PROGRAM_STOP prgid=USER_SLOT (+SOUND.TONE) [fault at offset 15: SOUND.TONE: the string DURATION runs past the \
end of the frame: its terminating zero is missing (E203)]
    [Brick: 192.0.2.10:5555]
    [Connection: 1]
    Length: 15
    Message counter: 1
    Type: DIRECT_COMMAND_NO_REPLY (0x80)
    Requested memory: 0x0000
        .... ..00 0000 0000 = Global memory: 0 bytes
        0000 00.. .... .... = Local memory: 0 bytes
    Opcode: PROGRAM_STOP (0x02) prgid=USER_SLOT
        PRGID: USER_SLOT (1)
            Encoding: LC0
    Opcode: SOUND (0x94) TONE volume=5 % frequency=440 Hz
        CMD: SOUND.TONE
        VOLUME: 5 %
            Encoding: LC0
        FREQUENCY: 440 Hz
            Encoding: LC2
    Not read: 84 61
    [Expert Info (Error/Malformed): at offset 15: SOUND.TONE: the string DURATION runs past the end of the frame: its \
terminating zero is missing (E203)]
        [at offset 15: SOUND.TONE: the string DURATION runs past the end of the frame: its terminating zero is \
missing (E203)]
        [Severity level: Error]
        [Group: Malformed]
"""
    )


def test_a_reply_shorter_than_what_was_asked_is_read_as_far_as_it_goes(tshark: Tshark) -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    asked = ev3proto.direct_command(
        ev3proto.operation("UI_READ.GET_VBATT", GV(0)),
        ev3proto.operation("UI_READ.GET_IBATT", GV(4)),
        counter=9,
        reply=True,
        global_size=8,
    )
    connection.send(asked.build())
    connection.receive(reply(bytes.fromhex("A470FD40 0000"), counter=9))
    text = tree(tshark, tshark.place(capture.data(), "short.pcap"))
    text = text[text.index("EV3: reply") :]
    said, _ = text.split("    [Response time")
    assert (
        said
        == """\
EV3: reply to UI_READ.GET_VBATT: 7.92 V
    [Brick: 192.0.2.10:5555]
    [Connection: 1]
    Length: 9
    Message counter: 9
    Type: DIRECT_REPLY (0x02)
    Global memory: a470fd400000
    Answers: UI_READ.GET_VBATT
        VALUE: 7.92 V
    [Request in: 1]
"""
    )


def test_no_text_cuts_the_line(tshark: Tshark) -> None:
    path = one_frame(tshark, command("D4 08 84", b"two\nlines\x7f\xe9\t\0"))
    *_, line = tshark.run(path).splitlines()
    assert line.endswith('COM_SET.SET_BRICKNAME name="two\u240alines\u2421\u00e9\u2409"')


def test_a_brick_that_is_known_as_such_has_its_faulty_reports_shown(tshark: Tshark) -> None:
    capture = Capture(USBMON)
    brick = Device(capture)
    brick.enumerate(0x0694, 0x0005)
    sent = [brick.send(TONE), brick.receive(b"\xff" * 1024), brick.send(bytes.fromhex("0500 0100 77 01 02"))]
    path = tshark.place(capture.data(), "faulty.pcap")
    words = ("-Y", "ev3", "-T", "fields", "-e", "frame.number", "-e", "_ws.col.Info")
    lines = [line.split("\t") for line in tshark.run(path, *words).splitlines()]
    assert [int(number) for number, _ in lines] == sent
    assert [said for _, said in lines] == [
        "SOUND.TONE volume=1 % frequency=440 Hz duration=1000 ms",
        "no frame (1024 bytes)",
        "message of unknown type 0x77 [fault at offset 4: unknown message type 0x77 (E105)]",
    ]
    assert tshark.run(path, "-Y", "ev3.expert.no_boundary", "-T", "fields", "-e", "frame.number").split() == [
        str(sent[1])
    ]


def test_the_fault_of_the_bootloader(tshark: Tshark) -> None:
    path = CAPTURES / "usb-bootloader.pcapng"
    words = ["-Y", "ev3.expert.bootloader_fault", "-T", "fields"]
    for field in ("usb.endpoint_address.direction", "_ws.col.Info", "_ws.expert.message", "ev3.padding"):
        words += ["-e", field]
    direction, said, told, padding = tshark.run(path, *words).rstrip("\n").split("\t")
    assert direction == "1"
    assert said == "bootloader fault: reply to GET_VERSION overwritten by its request"
    assert told == (
        "a known fault of the EV3's bootloader on USB 3 ports: the reply to GET_VERSION with the request written over "
        "its first bytes"
    )
    # After the request's six bytes comes the rest of the reply.
    assert padding.startswith("7f b6 00 00 00 06 00 00")
    assert len(bytes.fromhex(padding)) == 1024 - 6


def test_the_first_mark_of_an_argument_is_in_the_info_column(tshark: Tshark) -> None:
    """Also without a tree, and for operations after the first."""
    path = one_frame(tshark, "1000 0500 80 0000 A6 00 01 A4 00 10 82 C800 A6 04 01")
    expected = (
        "OUTPUT_START layer=0 nos=A (+OUTPUT_POWER, OUTPUT_START) [at offset 12: NOS is 16, outside of 0 to 15 (W303)]"
    )
    for words in ((), ("-2", "-Y", "ev3.expert.misread"), ("-V",)):
        shown = tshark.run(path, *words, "-o", 'gui.column.format:"Info","%i"')
        assert expected in shown


def test_the_reply_to_a_refused_command_has_its_reason(tshark: Tshark) -> None:
    path = CAPTURES / "wifi.pcapng"
    shown = tshark.run(path, "-Y", "ev3.expert.error_reply", "-T", "fields", "-e", "_ws.expert.message")
    assert shown.strip() == (
        "the brick refused the command or failed to execute it; in the command, at offset 9: VALUE is GV(1), and"
        " must start at a multiple of 4 (E205)"
    )


def test_nan_has_one_form(tshark: Tshark) -> None:
    """The machine prints one of these bit patterns as -nan."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(UNLOCK)
    for number, pattern in enumerate(("0000C07F", "0000C0FF", "FFFFFFFF")):
        connection.send(bytes.fromhex(f"0800 {number:02X}00 00 0400 81 01 60"))
        connection.receive(bytes.fromhex(f"0700 {number:02X}00 02 {pattern}"))
    path = tshark.place(capture.data(), "nan.pcap")
    shown = tshark.run(path, "-Y", "ev3.answers", "-T", "fields", "-e", "ev3.ui_read.get_vbatt.value")
    assert shown.split() == ["nan"] * 3


def test_a_listing_has_a_line_for_each_file(tshark: Tshark) -> None:
    listing = b"0123456789ABCDEF0123456789ABCDEF 000004A3 Program.rbf\nui/\n"
    body = bytes((0x99, 0x08)) + struct.pack("<IB", len(listing), 0) + listing
    frame = struct.pack("<HHB", 3 + len(body), 1, 0x03) + body
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(UNLOCK)
    connection.receive(frame)
    shown = tshark.run(tshark.place(capture.data(), "listing.pcap"), "-V", "-O", "ev3")
    assert "Program.rbf, 1187 bytes\n" in shown
    assert re.search(r"^ +ui/$", shown, re.MULTILINE)
