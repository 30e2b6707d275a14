"""USB reports: a frame at the start of each, recognised by the device's product or by fitting in every respect.

`test_dissector_carriers.py` tests the same for Wireshark.
"""

from __future__ import annotations

import random
import struct
from pathlib import Path

import pytest
from support.files import pcap, timed
from support.packets import USBMON, Device, cut, packets_of
from support.packets import Capture as Packets
from support.reading import opened, records
from support.unlikely_reports import FROM_HOST, UNLIKELY

from ev3proto.capture import Record, Skipped

CAPTURES = Path(__file__).parents[2] / "captures"
LEGO, EV3, BOOTLOADER = 0x0694, 0x0005, 0x0006

VOLTAGE = struct.pack("<HHB", 8, 7, 0x00) + bytes.fromhex("0400 81 01 60")
VOLTS = struct.pack("<HHBf", 7, 7, 0x02, 7.5)
CUT_OFF = bytes.fromhex("0800 0100 80 0000 94 01 01")
"""A command that ends inside an operation."""

DAISY = bytes.fromhex("0600 0100 0A A2 00 01")
DAISY_REPLY = bytes.fromhex("0500 0100 08 01 00")
OVERWRITTEN = bytes.fromhex("0400 0000 01 F6")
"""A bootloader's reply with the request written over its first bytes."""


def test_other_programs_of_a_brick_are_left_alone() -> None:
    """Pybricks, and network gadgets: they have the brick's product number, and bulk endpoints."""
    packets = Packets(USBMON)
    for device in (Device(packets), Device(packets, 8)):
        if device.number == 8:
            device.enumerate(LEGO, EV3)
        device.kind = Device.BULK
        for data in (VOLTAGE, CUT_OFF, VOLTS):
            device.send(data)
            device.receive(data)
    assert records(packets.data()) == []


def test_a_command_and_its_reply() -> None:
    packets = Packets(USBMON)
    device = Device(packets)
    sent, received = device.send(VOLTAGE, b"what an earlier frame left"), device.receive(VOLTS)
    events, capture = opened(packets.data())
    command, reply = (event for event in events if isinstance(event, Record))
    assert (command.frame, command.numbers, command.direction) == (VOLTAGE, (sent,), "sent")
    assert (reply.frame, reply.numbers, reply.direction) == (VOLTS, (received,), "received")
    assert (command.source, command.target, command.peer, command.carrier) == ("host", "1.7", "1.7", "usb")
    assert (reply.request, reply.latency) == (command, 0.001)
    assert [value.value for value in reply.values] == [7.5]
    account = capture.account
    assert (account.frames, account.padding, account.headers) == (19, 1014 + 1015, 128)


@pytest.mark.parametrize("product", [EV3, BOOTLOADER])
def test_a_brick_is_known_by_its_product(product: int) -> None:
    packets = Packets(USBMON)
    brick, other = Device(packets, 7), Device(packets, 8)
    brick.enumerate(LEGO, product)
    other.enumerate(0x1234, product)
    sent = brick.send(CUT_OFF)
    other.send(CUT_OFF)
    (record,) = records(packets.data())
    assert (record.number, record.peer) == (sent, "1.7")
    assert record.message.fault is not None


def test_another_device_gets_the_number() -> None:
    packets = Packets(USBMON)
    device = Device(packets)
    device.enumerate(LEGO, EV3)
    device.send(CUT_OFF)
    device.enumerate(0x1234, 0x0001)
    device.send(CUT_OFF)
    assert len(records(packets.data())) == 1


def test_bytes_of_a_brick_that_are_not_a_frame_are_reported() -> None:
    packets = Packets(USBMON)
    device = Device(packets, size=64)
    device.enumerate(LEGO, EV3)
    sent = device.receive(b"\xff\xff")
    events, capture = opened(packets.data())
    (event,) = events
    assert isinstance(event, Skipped)
    assert (event.number, event.data, event.missing) == (sent, b"\xff\xff" + bytes(62), 0)
    assert event.reason == ("the report has no frame: its length field is 65535, but the range is 3 to 1022")
    assert capture.account.skipped == 64


@pytest.mark.parametrize("report", UNLIKELY)
def test_reports_without_a_whole_frame_are_ignored(report: str) -> None:
    from_host, data = UNLIKELY[report]
    for is_known in (False, True):
        packets = Packets(USBMON)
        device = Device(packets)
        if is_known:
            device.enumerate(LEGO, EV3)
        (device.send if from_host is FROM_HOST else device.receive)(data)
        events, _ = opened(packets.data())
        assert len(events) == is_known


def test_a_computer_sends_daisy_messages_in_its_own_reports() -> None:
    packets = Packets(USBMON)
    device = Device(packets)
    for _ in range(3):
        device.send(DAISY)
        device.receive(DAISY_REPLY)
    device.send(VOLTAGE)
    device.receive(VOLTS)
    found = [(record.number, record.request is not None) for record in records(packets.data())]
    assert found == [(1, False), (2, True), (3, False), (4, True), (5, False), (6, True), (7, False), (8, True)]


def test_daisy_reports_have_their_own_size() -> None:
    for size, frame, count in (
        (64, DAISY, 1),
        (1024, DAISY, 1),
        (64, VOLTAGE, 0),
        (1024, VOLTAGE, 1),
        (512, VOLTAGE, 0),
        (512, DAISY, 0),
    ):
        packets = Packets(USBMON)
        Device(packets, size=size).send(frame)
        assert len(records(packets.data())) == count, (size, frame)
    for far in ("0600 0100 0A A2 00 63", "0500 0100 08 63 00"):
        packets = Packets(USBMON)
        Device(packets, size=64).send(bytes.fromhex(far))
        assert records(packets.data()) == []


def test_bricks_of_a_chain_send_commands_both_ways() -> None:
    packets = Packets(USBMON)
    device = Device(packets, size=64)
    device.send(DAISY)
    device.receive(DAISY)
    assert len(records(packets.data())) == 2


def test_the_bootloaders_fault() -> None:
    for is_known in (False, True):
        packets = Packets(USBMON)
        device = Device(packets)
        if is_known:
            device.enumerate(LEGO, BOOTLOADER)
        device.send(OVERWRITTEN)
        device.receive(OVERWRITTEN)
        command, reply = records(packets.data())
        assert command.note is None
        assert reply.note is not None
        assert reply.note.startswith("a known fault of the EV3's bootloader on USB 3 ports")
        assert reply.request is command


def test_a_reply_may_look_like_one_of_the_bootloader_only_from_the_device() -> None:
    packets = Packets(USBMON)
    Device(packets).receive(bytes.fromhex("0400 0000 01 9D"))  # LIST_OPEN_HANDLES is not a command of the bootloader
    assert records(packets.data()) == []


def test_reports_cut_by_the_capture() -> None:
    """What is cut is read if a reply proves it, or if the device is known to be a brick."""
    packets = Packets(USBMON)
    device = Device(packets)
    device.send(VOLTAGE)
    whole = packets.data()
    for size in range(64 + 12):
        events, _ = opened(cut(whole, size))
        assert len(events) == (size >= 64 + len(VOLTAGE)), size
    device.receive(VOLTS)
    for size in range(64 + 12):
        frames = [(each.frame, each.missing) for each in records(cut(packets.data(), size))]
        sizes = [(min(size - 64, len(frame)), max(len(frame) - size + 64, 0)) for frame in (VOLTAGE, VOLTS)]
        assert [(len(frame), missing) for frame, missing in frames] == (sizes if size >= 64 + 9 else []), size
    packets = Packets(USBMON)
    device = Device(packets)
    device.enumerate(LEGO, EV3)
    device.send(VOLTAGE)
    for size in range(64 + 32, 64 + 40):
        events, _ = opened(cut(packets.data(), size))
        assert [event.frame for event in events if isinstance(event, Record)] == [VOLTAGE]
    enumeration = list(packets_of(packets.data()))[:-1]
    report = list(packets_of(packets.data()))[-1]
    events, _ = opened(pcap(USBMON, [*timed(enumeration), timed([report[:70]])[0]._replace(size=len(report))]))
    (record,) = events
    assert isinstance(record, Record)
    assert (record.frame, record.missing, record.fault) == (VOLTAGE[:6], 4, None)


def test_only_interrupt_transfers_have_frames() -> None:
    packets = Packets(USBMON)
    Device(packets).send(VOLTAGE)
    (packet,) = packets_of(packets.data())
    for kind in (0, 2, 3):
        events, capture = opened(pcap(USBMON, timed([packet[:9] + bytes((kind,)) + packet[10:]])))
        assert events == []
        assert capture.account.other == len(packet)


def test_random_reports_are_hardly_ever_taken_for_frames() -> None:
    rng = random.Random(1)
    packets = Packets(USBMON)
    for size in (4, 8, 64, 1024):
        device = Device(packets, number=size % 100, size=size)
        for _ in range(3000):
            device.send(rng.randbytes(size))
            device.receive(rng.randbytes(size))
    assert len(records(packets.data())) <= 1
