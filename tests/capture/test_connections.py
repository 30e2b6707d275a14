"""The numbers of conversations: in the order of their first messages, whatever else was captured before."""

from __future__ import annotations

from support.messages import tone, voltage, volts
from support.packets import HCI_WITH_DIRECTION, RAW_IP, SYN, USBMON, Connection, Device, SerialPort, segment
from support.packets import Capture as Packets
from support.reading import records

A, B = bytes.fromhex("0a0000531600"), bytes.fromhex("0b0000531600")


def test_tcp_connections_count_from_their_first_message_and_from_a_syn() -> None:
    packets = Packets(RAW_IP)
    first, second, other = (Connection(packets, port) for port in (50001, 50002, 50003))
    other.send(b"GET / HTTP/1.1\r\n\r\n")
    first.send(voltage(1)[:6])
    second.send(voltage(2))
    first.send(voltage(1)[6:])
    second.receive(volts(2))
    packets.add(segment(True, 70_000, flags=SYN, port=50002))
    packets.add(segment(True, 70_001, tone(3), port=50002))
    first.receive(volts(1))
    found = [(each.frame, each.connection) for each in records(packets.data())]
    assert found == [(voltage(2), 1), (voltage(1), 2), (volts(2), 1), (tone(3), 3), (volts(1), 2)]


def test_usb_devices() -> None:
    packets = Packets(USBMON)
    mouse, first, second = Device(packets, 3, size=8), Device(packets, 9), Device(packets, 7)
    mouse.receive(b"\0\1\2\3")
    for device in (first, second, first):
        device.send(voltage(1))
        device.receive(volts(1))
    assert [each.connection for each in records(packets.data())] == [1, 1, 2, 2, 1, 1]


def test_the_serial_port_between_two_addresses_keeps_its_number() -> None:
    packets = Packets(HCI_WITH_DIRECTION)
    for handle, address in ((0x00B, A), (0x00C, B), (0x00C, A)):
        port = SerialPort(packets, connection=handle, address=address)
        port.send(voltage(1))
        port.receive(volts(1))
        packets.add(bytes.fromhex("00000001 04 05 04 00") + handle.to_bytes(2, "little") + b"\x13")
    found = [(each.peer, each.connection) for each in records(packets.data())]
    first, second = ("00:16:53:00:00:0a", 1), ("00:16:53:00:00:0b", 2)
    assert found == [first, first, second, second, first, first]
