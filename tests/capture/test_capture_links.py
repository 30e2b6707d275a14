"""The start of packets: every link that frames come over, in both byte orders, and other traffic on them."""

from __future__ import annotations

import struct
from collections.abc import Callable
from itertools import product

import pytest
from support.files import Blocks, btsnoop, pcap, timed
from support.packets import ACK, BRICK, EVERYBODY, HOST, SYN, Device, SerialPort, datagram, packets_of, segment
from support.packets import Capture as Packets
from support.reading import opened, records

import ev3proto
from ev3proto.capture import Announcement, Direction, Record, TextKind

COMMAND = struct.pack("<HHB", 8, 7, 0x00) + bytes.fromhex("0400 81 01 60")
"""UI_READ.GET_VBATT."""

REPLY = struct.pack("<HHBf", 7, 7, 0x02, 7.5)
ACCEPT = b"Accept:EV340\r\n\r\n\0"
IP = segment(True, 1000, COMMAND)
ANSWER = segment(False, 500, REPLY, acknowledged=1010)


# IP on every link


def ethernet(*tags: int) -> Callable[[bytes], bytes]:
    addresses = bytes.fromhex("0016530f0f0f 0a0000000001")
    head = addresses + b"".join(struct.pack(">HH", tag, 0x2064) for tag in tags) + b"\x08\x00"
    return lambda data: head + data


LINKS: dict[str, tuple[int, Callable[[bytes], bytes]]] = {
    "Ethernet": (1, ethernet()),
    "Ethernet with a trailer": (1, lambda data: ethernet()(data) + bytes(10)),
    "VLAN": (1, ethernet(0x8100)),
    "QinQ": (1, ethernet(0x88A8, 0x8100)),
    "QinQ as it was": (1, ethernet(0x9100, 0x8100)),
    "provider bridges": (1, ethernet(0x88A8, 0x88A8)),
    "three tags": (1, ethernet(0x8100, 0x8100, 0x8100)),
    "loopback": (0, lambda data: struct.pack("<I", 2) + data),
    "loopback of the other order": (0, lambda data: struct.pack(">I", 2) + data),
    "loopback of OpenBSD": (108, lambda data: struct.pack(">I", 2) + data),
    "raw": (101, lambda data: data),
    "raw BSD": (12, lambda data: data),
    "raw OpenBSD": (14, lambda data: data),
    "IPv4": (228, lambda data: data),
    "cooked": (113, lambda data: struct.pack(">HHH8sH", 4, 1, 6, b"\0\x16S\x0f\x0f\x0f", 0x0800) + data),
    "cooked with VLAN": (
        113,
        lambda data: struct.pack(">HHH8sHHH", 4, 1, 6, b"\0\x16S\x0f\x0f\x0f", 0x8100, 100, 0x0800) + data,
    ),
    "cooked 2": (276, lambda data: struct.pack(">HHiHBB8s", 0x0800, 0, 3, 1, 4, 6, b"\0\x16S\x0f") + data),
    "cooked 2 with VLAN": (
        276,
        lambda data: struct.pack(">HHiHBB8sHH", 0x8100, 0, 3, 1, 4, 6, b"\0\x16S\x0f", 100, 0x0800) + data,
    ),
}


@pytest.mark.parametrize("name", LINKS)
@pytest.mark.parametrize("order", ["<", ">"])
def test_ip_comes_over_every_link(name: str, order: str) -> None:
    link, wrap = LINKS[name]
    command, reply = records(pcap(link, timed([wrap(IP), wrap(ANSWER)]), order=order))
    assert (command.frame, command.numbers) == (COMMAND, (1,))
    assert (command.source, command.target, command.peer) == ("192.0.2.1:49152", "192.0.2.10:5555", "192.0.2.10:5555")
    assert (command.carrier, command.direction) == ("wifi", "sent")
    assert (reply.frame, reply.numbers) == (REPLY, (2,))
    assert (reply.source, reply.target, reply.peer) == ("192.0.2.10:5555", "192.0.2.1:49152", "192.0.2.10:5555")
    assert (reply.carrier, reply.direction) == ("wifi", "received")
    assert reply.request is command
    assert reply.latency == 0.001
    assert [value.value for value in reply.values] == [7.5]


@pytest.mark.parametrize("name", LINKS)
def test_a_packet_may_be_cut_anywhere(name: str) -> None:
    link, wrap = LINKS[name]
    whole = wrap(IP)
    at = whole.index(COMMAND)
    for size in range(len(whole)):
        packet = timed([whole[:size]])[0]._replace(size=len(whole))
        events, capture = opened(pcap(link, [packet]))
        # A command needs an operation: after its header and memory sizes, an opcode with CMD.
        shown = COMMAND[: size - at] if size >= at + 9 else b""
        assert [event.frame for event in events if isinstance(event, Record)] == ([shown] if shown else [])
        assert capture.account.frames == len(shown)


def ipv6(carried: bytes, *extensions: tuple[int, bytes], protocol: int = 6, from_host: bool = True) -> bytes:
    """An IPv6 packet; each extension is its number and its bytes after the number of the next."""
    ends = [bytes.fromhex("20010db8000000000000000000000001"), bytes.fromhex("20010db8000000000000000000000010")]
    source, target = ends if from_host else ends[::-1]
    numbers = [number for number, _ in extensions] + [protocol]
    body = b"".join(bytes((number,)) + data for number, (_, data) in zip(numbers[1:], extensions, strict=True))
    body += carried
    return struct.pack(">IHBB", 6 << 28, len(body), numbers[0], 64) + source + target + body


TCP = IP[20:]
HOP_BY_HOP = (0, bytes.fromhex("00 0502 0000 0100"))
ROUTING = (43, bytes.fromhex("02 00 00 00000000") + bytes(16))
DESTINATION = (60, bytes.fromhex("01 01 0c") + bytes(12))
ONLY_FRAGMENT = (44, bytes.fromhex("00 0000 00000001"))
FIRST_FRAGMENT = (44, bytes.fromhex("00 0001 00000001"))
LATER_FRAGMENT = (44, bytes.fromhex("00 0011 00000001"))


@pytest.mark.parametrize(
    ("link", "head"),
    [(229, b""), (101, b""), (1, bytes(12) + b"\x86\xdd")]
    + [(0, struct.pack(order + "I", family)) for order, family in product("<>", (10, 23, 24, 28, 30))],
)
@pytest.mark.parametrize(
    "extensions",
    [(), (HOP_BY_HOP,), (HOP_BY_HOP, ROUTING), (DESTINATION,), (HOP_BY_HOP, DESTINATION, ROUTING, ONLY_FRAGMENT)],
)
def test_ipv6_with_extension_headers(link: int, head: bytes, extensions: tuple[tuple[int, bytes], ...]) -> None:
    (record,) = records(pcap(link, timed([head + ipv6(TCP, *extensions)])))
    assert record.frame == COMMAND
    assert record.source == "[2001:db8::1]:49152"
    assert record.target == record.peer == "[2001:db8::10]:5555"


@pytest.mark.parametrize(
    "packet",
    [
        ipv6(TCP, HOP_BY_HOP, LATER_FRAGMENT),
        ipv6(TCP, LATER_FRAGMENT),
        ipv6(TCP, FIRST_FRAGMENT),
        ipv6(TCP, protocol=50),  # encrypted
        ipv6(TCP, protocol=59),  # nothing follows
        ipv6(b"", HOP_BY_HOP),
        ipv6(b"\x06\xff", protocol=0),
        IP[:6] + b"\x20\x10" + IP[8:],  # a later fragment
        IP[:6] + b"\x20\x00" + IP[8:],  # the first one
        IP[:9] + b"\x01" + IP[10:],  # not TCP
        b"\x15" + IP[1:],  # no version of IP
        b"\x41" + IP[1:],  # header too short
        IP[:32] + b"\x10" + IP[33:],  # TCP's header too short
        segment(True, 1, COMMAND, brick_port=5556),
        b"",
        b"\x45",
        b"\x60",
    ],
)
def test_segments_to_other_hosts_are_ignored(packet: bytes) -> None:
    events, capture = opened(pcap(101, timed([packet])))
    assert events == []
    assert capture.account.other == len(packet)


def test_a_packet_whose_size_the_network_card_fills_in() -> None:
    """Large segments are split by the network card, after the capture: their length field is 0."""
    (record,) = records(pcap(101, timed([IP[:2] + b"\0\0" + IP[4:]])))
    assert record.frame == COMMAND
    body = ipv6(TCP)
    (record,) = records(pcap(101, timed([body[:4] + b"\0\0" + body[6:]])))
    assert record.frame == COMMAND


@pytest.mark.parametrize("protocol", [4, 41])
def test_ip_in_ip_is_left_to_wireshark(protocol: int) -> None:
    """However deep it is."""
    packet = IP
    for _ in range(3000):
        if protocol == 4:
            head = struct.pack(">BBHHHBBH", 0x45, 0, 0, 0, 0, 64, 4, 0) + HOST + BRICK
        else:
            head = struct.pack(">IHBB", 6 << 28, 0, 41, 64) + bytes(32)
        packet = head + packet
    events, capture = opened(pcap(101, timed([packet, IP])))
    assert [event.frame for event in events if isinstance(event, Record)] == [COMMAND]
    assert capture.account.other == len(packet)


@pytest.mark.parametrize(
    "head",
    [
        bytes(12) + bytes.fromhex("8847 00064040 00065140"),  # MPLS
        bytes(12) + struct.pack(">HHHHH", 0x8864, 0x1100, 7, 2 + len(IP), 0x21),  # PPPoE
        bytes(12) + bytes.fromhex("88e7 00000001") + bytes(12) + b"\x08\0",  # provider backbone bridges
    ],
)
def test_tunnels_are_left_to_wireshark(head: bytes) -> None:
    events, capture = opened(pcap(1, timed([head + IP])))
    assert events == []
    assert capture.account.other == len(head + IP)


@pytest.mark.parametrize("kind", [0x2000, 0x88CC, 0x8847, 0x8864, 0x8137, 0x00BB, 0x0806, 0x6558, 40])
def test_other_things_on_ethernet_are_passed_over(kind: int) -> None:
    """Packets of zeros and ones, which send readers of these protocols into endless loops."""
    packets = [bytes(12) + struct.pack(">H", kind) + bytes((byte,)) * size for byte in (0, 1, 255) for size in (3, 900)]
    events, capture = opened(pcap(1, timed(packets)))
    assert events == []
    assert capture.account.other == sum(map(len, packets))


@pytest.mark.parametrize(
    "packets",
    [
        [segment(True, 1, COMMAND), segment(False, 1, REPLY)],
        [segment(False, 1, REPLY), segment(True, 1, COMMAND)],
        [segment(False, 1, ACCEPT + REPLY), segment(True, 1, COMMAND)],
        [segment(False, 1, flags=SYN, acknowledged=1), segment(False, 2, REPLY), segment(True, 1, COMMAND)],
        [segment(True, 0, flags=SYN), segment(True, 1, COMMAND), segment(False, 1, REPLY)],
    ],
    ids=["command", "reply", "accepted", "from its second packet", "from its first packet"],
)
def test_the_ports_of_both_ends_can_be_named(packets: list[bytes]) -> None:
    """The data reveals the brick: commands go to it, replies and the answer to the unlock text come from it."""
    found, _ = opened(pcap(101, timed(packets)), ports=range(5000, 60_000))
    said = [event for event in found if isinstance(event, Record)]
    assert {(type(record.message), record.direction, record.peer) for record in said} == {
        (ev3proto.DirectCommand, Direction.SENT, "192.0.2.10:5555"),
        (ev3proto.DirectReply, Direction.RECEIVED, "192.0.2.10:5555"),
    }


@pytest.mark.parametrize("flags", [None, 0, ACK])
def test_the_port_of_the_computer_can_be_named(flags: int | None) -> None:
    """The end that opens a connection, or sends the unlock text, is not the brick."""
    unlock = ev3proto.Unlock("0016530f0f0f").build()
    begin = [] if flags is None else [segment(not flags, 0, flags=SYN | flags, brick_port=61_000)]
    packets = [*begin, segment(True, 1, unlock, brick_port=61_000), segment(False, 1, ACCEPT, brick_port=61_000)]
    found, _ = opened(pcap(101, timed(packets)), ports=range(5000, 60_000))
    said = [event for event in found if isinstance(event, Announcement)]
    assert [event.route.direction for event in said] == [Direction.SENT, Direction.RECEIVED]
    assert {event.route.peer for event in said} == {"192.0.2.10:61000"}


# Beacons

BEACON = ev3proto.Beacon("0016530f0f0f", name="myEV3").build()


def test_beacons_and_what_is_answered_to_them() -> None:
    packets = [
        datagram(b"before any beacon", HOST, 3000, BRICK, 3016),
        datagram(BEACON),
        datagram(b"x", HOST, 3000, BRICK, 3016),
        datagram(BEACON[:40]),
        datagram(b""),
    ]
    events, capture = opened(pcap(101, timed(packets)))
    assert [type(event) for event in events] == [Announcement] * 3
    beacon, answer, cut = (event for event in events if isinstance(event, Announcement))
    assert (beacon.said, beacon.data, beacon.numbers) == (TextKind.BEACON, BEACON, (2,))
    assert beacon.facts == {"serial": "0016530f0f0f", "port": "5555", "name": "myEV3", "protocol": "EV3"}
    assert (beacon.route.source, beacon.route.target) == ("192.0.2.10:3016", "192.0.2.255:3015")
    assert (beacon.route.peer, beacon.route.direction) == ("192.0.2.10:3016", "received")
    assert (answer.said, answer.data, answer.numbers) == (TextKind.ANSWER, b"x", (3,))
    assert (answer.route.peer, answer.route.direction) == ("192.0.2.10:3016", "sent")
    assert (cut.said, cut.data, cut.text) == (TextKind.BEACON, BEACON[:40], None)
    assert (capture.account.texts, capture.account.headers) == (len(BEACON) + 1 + 40, 3 * 28)
    assert capture.account.other == 28 + 17 + 28
    assert EVERYBODY != BRICK


# USB and Bluetooth


def usb_packets() -> list[bytes]:
    packets = Packets(220)
    device = Device(packets)
    device.send(COMMAND)
    device.receive(REPLY)
    return list(packets_of(packets.data()))


def swapped_usbmon(packet: bytes) -> bytes:
    """The same header, written by a big-endian machine."""
    form = "QBBBBHBBqiiII8siiII"
    return struct.pack(">" + form, *struct.unpack_from("<" + form, packet)) + packet[64:]


def short_usbmon(packet: bytes) -> bytes:
    return packet[:48] + packet[64:]


def usbpcap(packet: bytes) -> bytes:
    """The same as Windows records it."""
    endpoint, is_done = packet[10], packet[8:9] == b"C"
    head = struct.pack("<HQIHBHHBBI", 27, 1, 0, 9, is_done, 1, 7, endpoint, 1, len(packet) - 64)
    return head + packet[64:]


def test_usb_on_every_link() -> None:
    packets = usb_packets()
    files = {
        "usbmon": pcap(220, timed(packets)),
        "usbmon, big-endian": pcap(220, timed([swapped_usbmon(packet) for packet in packets]), order=">"),
        "short usbmon": pcap(189, timed([short_usbmon(packet) for packet in packets])),
        "short usbmon, big-endian": pcap(
            189, timed([short_usbmon(swapped_usbmon(packet)) for packet in packets]), order=">"
        ),
        "USBPcap": pcap(249, timed([usbpcap(packet) for packet in packets])),
        "USBPcap, big-endian file": pcap(249, timed([usbpcap(packet) for packet in packets]), order=">"),
    }
    for order in "<>":
        blocks = Blocks(order)
        blocks.interface(220)
        for packet in packets:
            blocks.packet(0, packet if order == "<" else swapped_usbmon(packet))
        files[f"usbmon in pcapng {order}"] = blocks.data()
    for name, data in files.items():
        command, reply = records(data)
        assert (command.frame, reply.frame) == (COMMAND, REPLY), name
        assert (command.source, command.target, command.peer) == ("host", "1.7", "1.7"), name
        assert (reply.source, reply.target, reply.peer) == ("1.7", "host", "1.7"), name
        assert (command.direction, reply.direction) == ("sent", "received"), name
        assert reply.request is command, name


def hci_packets() -> list[tuple[bool, bytes]]:
    """Whether each packet was received, and its bytes, from the packet type on."""
    packets = Packets(201)
    port = SerialPort(packets)
    port.send(COMMAND)
    port.receive(REPLY)
    return [(bool(data[3]), data[4:]) for data in packets_of(packets.data())]


def bluetooth_files() -> dict[str, bytes]:
    packets = hci_packets()
    bare = timed([data for _, data in packets])
    monitor = [(5 if received else 4, data[1:]) for received, data in packets]
    found = {
        "H4": pcap(187, bare),
        "btsnoop": btsnoop(1002, bare, [int(received) for received, _ in packets]),
        "btsnoop of the monitor": btsnoop(
            2001, timed([data for _, data in monitor]), [3 << 16 | kind for kind, _ in monitor]
        ),
    }
    for order in "<>":
        found[f"H4 with direction {order}"] = pcap(
            201, timed([struct.pack(">I", received) + data for received, data in packets]), order=order
        )
        found[f"monitor {order}"] = pcap(
            254, timed([struct.pack(">HH", 3, kind) + data for kind, data in monitor]), order=order
        )
    return found


@pytest.mark.parametrize("name", bluetooth_files())
def test_bluetooth_on_every_link(name: str) -> None:
    data = bluetooth_files()[name]
    command, reply = records(data)
    assert (command.frame, command.numbers, reply.frame, reply.numbers) == (COMMAND, (3,), REPLY, (4,))
    assert (command.source, command.target, command.peer) == ("host", "handle 0x000b", "handle 0x000b")
    assert (reply.source, reply.target, reply.peer) == ("handle 0x000b", "host", "handle 0x000b")
    assert (command.direction, reply.direction) == ("sent", "received")
    assert reply.request is command


def test_adapters_of_the_monitor_are_told_apart() -> None:
    """Two adapters use the same handle for different bricks."""
    monitor = [(5 if received else 4, data[1:]) for received, data in hci_packets()]
    both = [(adapter, kind, data) for kind, data in monitor for adapter in (0, 1)]
    data = btsnoop(2001, timed([data for _, _, data in both]), [adapter << 16 | kind for adapter, kind, _ in both])
    found = records(data)
    assert [record.frame for record in found] == [COMMAND, COMMAND, REPLY, REPLY]
    assert [found[2].request, found[3].request] == found[:2]


@pytest.mark.parametrize("link", [187, 189, 201, 220, 249, 254])
def test_packets_too_short_for_their_link(link: int) -> None:
    packets = [bytes((byte,)) * size for size in range(70) for byte in (0, 2, 4, 255)]
    events, capture = opened(pcap(link, timed(packets)))
    assert events == []
    assert capture.account.other == sum(map(len, packets))
