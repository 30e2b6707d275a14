"""WiFi: the beacon, the host's answer, and a TCP connection whose ends number and acknowledge their bytes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from scapy.layers.inet import IP, TCP, UDP
from scapy.layers.l2 import Ether
from scapy.packet import Packet

from ev3proto import Beacon, Unlock
from ev3proto.tables.discovery import ACCEPT, BEACON_PORT, TCP_PORT
from making import dialogue
from making.dialogue import CONTENTS, IMAGE, Exchange, Host
from making.files import SECOND, Wire

SERIAL = "06165300000a"
BRICK_SOURCE = 3016
MSS = 1460


@dataclass(slots=True)
class End:
    """One end of the connection.

    number   sequence number of its next byte
    expects  what it acknowledges: the number of the next byte that it has not got
    packets  the next one's number in the IP header
    """

    mac: str
    ip: str
    port: int
    ttl: int
    window: int
    number: int
    packets: int
    expects: int = 0


class Connection:
    """A host and a brick, and the packets between them."""

    def __init__(self, wire: Wire) -> None:
        self.wire = wire
        self.host = End("02:00:00:00:00:01", "192.0.2.1", 49152, 64, 502, 0x10000000, 0x1000)
        self.brick = End("02:00:00:00:00:0a", "192.0.2.10", TCP_PORT, 64, 457, 0x20000000, 1)

    def other(self, end: End) -> End:
        """The other end."""
        return self.brick if end is self.host else self.host

    def _ip(self, sender: End, mac: str, ip: str) -> Packet:
        head = IP(src=sender.ip, dst=ip, ttl=sender.ttl, id=sender.packets, flags="DF")
        sender.packets += 1
        return Ether(src=sender.mac, dst=mac) / head

    # Before the connection

    def beacon(self, name: str) -> None:
        """The brick broadcasts its beacon."""
        datagram = UDP(sport=BRICK_SOURCE, dport=BEACON_PORT) / Beacon(SERIAL, name=name).build()
        self.wire.add(self._ip(self.brick, "ff:ff:ff:ff:ff:ff", "192.0.2.255") / datagram)

    def answer_beacon(self) -> None:
        """The host sends the brick a datagram, whose content does not matter."""
        datagram = UDP(sport=BEACON_PORT, dport=BRICK_SOURCE) / b"\0"
        self.wire.add(self._ip(self.host, self.brick.mac, self.brick.ip) / datagram)

    # The connection

    def segment(
        self, sender: End, data: bytes = b"", flags: str = "A", options: Sequence[tuple[str, object]] = ()
    ) -> Packet:
        """The sender's next segment, without sending it."""
        receiver = self.other(sender)
        head = TCP(
            sport=sender.port,
            dport=receiver.port,
            seq=sender.number,
            ack=sender.expects if "A" in flags else 0,
            flags=flags,
            window=64240 if "S" in flags else sender.window,
            options=list(options),
        )
        sender.number += len(data) + ("S" in flags) + ("F" in flags)
        packet = self._ip(sender, receiver.mac, receiver.ip) / head
        return packet / data if data else packet

    def deliver(self, sender: End, packet: Packet) -> None:
        """A segment passes and arrives in order."""
        self.wire.add(packet)
        self.other(sender).expects = sender.number

    def open(self) -> None:
        """The handshake."""
        options = [("MSS", MSS), ("NOP", None), ("NOP", None), ("SAckOK", b""), ("NOP", None), ("WScale", 7)]
        for sender, flags in ((self.host, "S"), (self.brick, "SA"), (self.host, "A")):
            self.deliver(sender, self.segment(sender, flags=flags, options=options if "S" in flags else ()))
            self.wire.wait(1800)

    def send(self, sender: End, *pieces: bytes, after: int = 4000) -> None:
        """Pieces of data, one per segment."""
        self.wire.wait(after)
        for index, piece in enumerate(pieces):
            last = index == len(pieces) - 1
            self.deliver(sender, self.segment(sender, piece, "PA" if last else "A"))
            self.wire.wait(300)

    def write(self, sender: End, data: bytes, after: int = 4000) -> None:
        """Data in segments as long as possible."""
        self.send(sender, *(data[at : at + MSS] for at in range(0, len(data), MSS)), after=after)

    def acknowledge(self, sender: End, after: int = 40000) -> None:
        """A segment without data."""
        self.wire.wait(after)
        self.deliver(sender, self.segment(sender))

    def exchange(self, pair: Exchange) -> None:
        """A command and its reply, each in its own segments."""
        self.write(self.host, pair.command)
        self.write(self.brick, pair.reply)

    def unlock(self) -> None:
        """The unlock text, and the brick's answer."""
        self.send(self.host, Unlock(SERIAL).build(), after=500)
        self.acknowledge(self.brick, after=2000)
        self.send(self.brick, ACCEPT + b"\0")
        self.acknowledge(self.host)

    def close(self) -> None:
        """Both ends close the connection."""
        self.wire.wait(SECOND)
        for sender, flags in ((self.host, "FA"), (self.brick, "FA"), (self.host, "A")):
            self.deliver(sender, self.segment(sender, flags=flags))
            self.wire.wait(2500)


def whole() -> Wire:
    """From the beacon to the end of the connection."""
    wire = Wire()
    connection = Connection(wire)
    host = Host()
    computer, brick = connection.host, connection.brick
    connection.beacon("myEV3")
    wire.wait(5 * SECOND)
    connection.beacon("myEV3")
    wire.wait(1200)
    connection.answer_beacon()
    wire.wait(30_000)
    connection.open()
    connection.unlock()
    # Without reply: the brick's TCP acknowledges it, a little later.
    connection.send(computer, host.tell(dialogue.tone()))
    connection.acknowledge(brick)
    connection.exchange(dialogue.sensors(host))
    connection.exchange(dialogue.gyro(host))
    # Three frames in one segment, of which the last one is answered.
    silent = host.tell(dialogue.light("LED_ORANGE_PULSE")) + host.tell(*dialogue.start_motors())
    pair = dialogue.voltage(host)
    connection.send(computer, silent + pair.command)
    connection.send(brick, pair.reply)
    # A command split inside its length field, and its reply, too.
    pair = dialogue.motor_angles(host, 421, -17)
    connection.send(computer, pair.command[:1], pair.command[1:])
    connection.send(brick, pair.reply[:1], pair.reply[1:9], pair.reply[9:])
    # Two commands split so that a segment ends inside the second one's length field; two replies at once.
    first, second = dialogue.touch(host, 100), dialogue.versions(host)
    both = first.command + second.command
    cut = len(first.command) + 1
    connection.send(computer, both[:cut], both[cut:])
    connection.acknowledge(brick, after=500)
    connection.send(brick, first.reply + second.reply)
    connection.exchange(dialogue.misaligned(host))
    connection.send(computer, host.tell(dialogue.stop_motors()))
    for pair in dialogue.listing(host, "/home/root/lms2012/prjs/log/", 80):
        connection.exchange(pair)
    # The host asks for the second and third piece without waiting for the second.
    begin, *pieces = dialogue.upload(host, "../prjs/log/values.rtf", CONTENTS, 900)
    connection.exchange(begin)
    connection.send(computer, b"".join(piece.command for piece in pieces))
    connection.write(brick, b"".join(piece.reply for piece in pieces))
    connection.acknowledge(computer, after=200)
    begin, *pieces = dialogue.download(host, "../prjs/log/first.rbf", IMAGE)
    connection.exchange(begin)
    connection.write(computer, b"".join(piece.command for piece in pieces[:2]))
    connection.acknowledge(brick, after=200)
    for piece in pieces[:2]:
        connection.send(brick, piece.reply)
    connection.exchange(pieces[2])
    connection.exchange(dialogue.illegal_download(host))
    connection.send(computer, host.mail("abc", b"hello\0"))
    connection.acknowledge(brick)
    # Never answered.
    connection.send(computer, dialogue.voltage(host).command)
    connection.acknowledge(brick)
    connection.close()
    return wire


def long_downloads() -> Wire:
    """Files in one frame each, as some libraries send them, and polls between frames."""
    wire = Wire()
    connection = Connection(wire)
    host = Host(0x4000)
    computer, brick = connection.host, connection.brick
    connection.open()
    connection.unlock()
    # The rest of the file in one frame of 2500 bytes; then the zeros of a poll.
    begin, rest = dialogue.long_download(host, "../prjs/log/first.rbf", IMAGE, 3)
    connection.exchange(begin)
    connection.write(computer, rest.command + bytes(2))
    connection.write(brick, rest.reply)
    # The whole file with its name.
    (whole,) = dialogue.long_download(host, "../prjs/log/hello.rtf", b"hello", 5)
    connection.send(computer, bytes(4) + whole.command)
    connection.send(brick, whole.reply)
    (whole,) = dialogue.long_download(host, "../prjs/log/values.rtf", CONTENTS, len(CONTENTS))
    connection.exchange(whole)
    connection.exchange(dialogue.voltage(host))
    connection.close()
    return wire


def reordered() -> Wire:
    """A connection with a repeated segment and two segments in the wrong order."""
    wire = Wire()
    connection = Connection(wire)
    host = Host(0x8000)
    computer, brick = connection.host, connection.brick
    connection.open()
    connection.unlock()
    connection.exchange(dialogue.voltage(host))
    # The brick's answer to this one is late, so the host sends it again.
    pair = dialogue.gyro(host)
    wire.wait(4000)
    packet = connection.segment(computer, pair.command, "PA")
    wire.add(packet)
    wire.wait(210_000)
    again = packet.copy()
    again[IP].id = computer.packets
    computer.packets += 1
    connection.deliver(computer, again)
    connection.send(brick, pair.reply)
    # A reply in three segments; the third comes before the second, and the host asks for the second.
    begin, rest = dialogue.upload(host, "../prjs/log/values.rtf", CONTENTS[:1400], 700)
    connection.exchange(begin)
    connection.send(computer, rest.command)
    reply = rest.reply
    one, two, three = (connection.segment(brick, reply[at : at + 250], "PA") for at in range(0, len(reply), 250))
    wire.wait(4000)
    wire.add(one)
    computer.expects += 250
    wire.wait(400)
    wire.add(three)
    wire.wait(100)
    wire.add(connection.segment(computer))
    wire.wait(100)
    connection.deliver(brick, two)
    connection.acknowledge(computer, after=200)
    # A command of two segments, which arrive in the wrong order.
    begin, rest = dialogue.download(host, "../prjs/log/first.rbf", IMAGE[:40])
    one, two = (connection.segment(computer, piece, "PA") for piece in (begin.command[:1], begin.command[1:]))
    wire.wait(4000)
    wire.add(two)
    wire.wait(300)
    connection.deliver(computer, one)
    connection.send(brick, begin.reply)
    connection.exchange(rest)
    connection.exchange(dialogue.touch(host, 0))
    connection.close()
    return wire
