"""Long dialogues: the links from replies to commands take little memory, and remain for later readings."""

from __future__ import annotations

import re
import struct
from itertools import cycle, islice

from support.packets import RAW_IP, Capture, Connection
from support.wireshark import Tshark

import ev3proto

UNLOCK = ev3proto.Unlock("06165300000a").build()
READINGS = {"VBATT": ("01", "V"), "IBATT": ("02", "A"), "TBATT": ("05", "°C")}
"""What UI_READ reads: the CMD in hexadecimal, and the unit."""


def frame(counter: int, kind: str, body: str) -> bytes:
    after_length = struct.pack("<H", counter & 0xFFFF) + bytes.fromhex(kind + body)
    return struct.pack("<H", len(after_length)) + after_length


def command(counter: int, what: str) -> bytes:
    """Asks for a reading, then plays a tone: all of these commands are different."""
    tone = "94 01 05 82" + struct.pack("<h", 250 + counter).hex() + "8164"
    return frame(counter, "00", f"0400 81 {READINGS[what][0]} 60" + tone)


def reply(counter: int, value: float) -> bytes:
    return frame(counter, "02", struct.pack("<f", value).hex())


def test_a_long_dialogue(tshark: Tshark) -> None:
    """4,500 commands, each followed by its reply."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(UNLOCK)
    asked = list(islice(cycle(READINGS), 4500))
    for counter, what in enumerate(asked):
        connection.send(command(counter, what))
        connection.receive(reply(counter, counter / 4))
    path = tshark.place(capture.data(), "long.pcap")
    fields = ("-e", "ev3.request_in", "-e", "ev3.response_in", "-e", "_ws.col.Info")
    _, *found = tshark.run(path, "-2", "-T", "fields", *fields).splitlines()
    expected = []
    for counter, what in enumerate(asked):
        number = 2 * counter + 2
        expected += [
            f"\t{number + 1}\tUI_READ.GET_{what} (+SOUND.TONE)",
            f"{number}\t\treply to UI_READ.GET_{what}: {counter / 4:g} {READINGS[what][1]}",
        ]
    assert found == expected


def test_many_commands_in_a_packet(tshark: Tshark) -> None:
    """3,000 commands in one packet and their replies in another; the commands are looked up much later."""
    counters = range(3000)
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(UNLOCK)
    connection.send(b"".join(frame(counter, "00", "0400 81 01 60") for counter in counters))
    connection.receive(b"".join(reply(counter, 7.5) for counter in counters))
    for counter in range(3000, 3300):
        connection.send(command(counter, "VBATT"))
        connection.receive(reply(counter, 8))
    path = tshark.place(capture.data(), "many.pcap")
    fields = ("-e", "frame.number", "-e", "ev3.request_in", "-e", "ev3.response_in")
    _, commands, replies, *others = tshark.run(path, "-2", "-T", "fields", *fields).splitlines()
    assert commands == "2\t\t" + ",".join(["3"] * 3000)
    assert replies == "3\t" + ",".join(["2"] * 3000) + "\t"
    assert others[-2:] == ["602\t\t603", "603\t602\t"]


def test_replies_to_commands_that_come_again(tshark: Tshark) -> None:
    """The values are those of each reply, without a tree and with one."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    expected = []
    for number in range(1, 6):
        volts = struct.pack("<f", number + 0.5)
        for body, memory, line in (
            ("0400 81 01 60", volts, f"UI_READ.GET_VBATT: {number}.5 V"),
            (
                "0500 81 01 60 7C 04 64",
                volts + bytes([number]),
                f"UI_READ.GET_VBATT: vbatt={number}.5 V volume={number} %",
            ),
            ("0400 D3 0D 04 60", b"EV%d\0" % number, f'COM_GET.GET_BRICKNAME: "EV{number}"'),
        ):
            connection.send(frame(1, "00", body))
            connection.receive(frame(1, "02", memory.hex()))
            expected.append("reply to " + line)
    path = tshark.place(capture.data(), "replies.pcap")
    assert tshark.run(path, "-o", 'gui.column.format:"Info","%i"').splitlines()[1::2] == expected
    # Fields need the tree.
    found = tshark.run(path, "-T", "fields", "-e", "_ws.col.Info", "-e", "ev3.ui_read.get_vbatt.value").splitlines()
    values = [volts for number in range(1, 6) for volts in (f"{number}.5", f"{number}.5", "")]
    assert found[1::2] == [f"{line}\t{value}" for line, value in zip(expected, values, strict=True)]


def test_readings_of_devices(tshark: Tshark) -> None:
    """Names and units by type and mode of the command; none where they are kept, and for raw values on a scale."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(UNLOCK)
    expected = []
    for body, memory, info, lines in (
        (
            "0800 991D 00 00 8120 03 02 60 64",
            struct.pack("<ff", 90, -1),
            "INPUT_DEVICE.READY_SI: values[0]=90 degrees values[1]=-1 degrees/s",
            ["VALUES[0]: 90 degrees (angle)", "VALUES[1]: -1 degrees/s (rate)"],
        ),
        ("0400 9D 00 00 1E 00 60", struct.pack("<f", 5.5), "INPUT_READSI: 5.5 cm", ["SI: 5.5 cm (distance)"]),
        ("0400 9D 00 00 1D 02 60", struct.pack("<f", 5), "INPUT_READSI: 5", ["SI: 5 (colour)"]),
        ("0400 9D 00 00 00 00 60", struct.pack("<f", 5), "INPUT_READSI: 5", ["SI: 5"]),
        (
            "0400 991C 00 10 07 00 01 60",
            struct.pack("<i", 90),
            "INPUT_DEVICE.READY_RAW: 90 degrees",
            ["VALUES[0]: 90 degrees (angle)"],
        ),
        ("0400 991C 00 00 1E 00 01 60", struct.pack("<i", 55), "INPUT_DEVICE.READY_RAW: 55", ["VALUES[0]: 55"]),
    ):
        connection.send(frame(1, "00", body))
        connection.receive(frame(1, "02", memory.hex()))
        expected.append([f"reply to {info}", *lines])
    path = tshark.place(capture.data(), "readings.pcap")
    text = tshark.run(path, "-2", "-P", "-V", "-O", "ev3", "-Y", "ev3.memory")
    found = [
        [re.findall(r"reply to .*", packet)[0], *re.findall(r"^ +((?:VALUES\[.\]|SI): .*)", packet, re.MULTILINE)]
        for packet in re.split(r"\n\n(?= *\d+ )", text)
    ]
    assert found == expected
