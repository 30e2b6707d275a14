"""Bluetooth: a connection, the search for the serial port, RFCOMM with credits, and frames split to fit it."""

from __future__ import annotations

from scapy.layers.bluetooth import (
    HCI_ACL_Hdr,
    HCI_Cmd_Create_Connection,
    HCI_Command_Hdr,
    HCI_Event_Command_Status,
    HCI_Event_Connection_Complete,
    HCI_Event_Hdr,
    HCI_Event_Number_Of_Completed_Packets,
    HCI_Hdr,
    HCI_PHDR_Hdr,
    L2CAP_CmdHdr,
    L2CAP_ConfReq,
    L2CAP_ConfResp,
    L2CAP_ConnReq,
    L2CAP_ConnResp,
    L2CAP_DisconnReq,
    L2CAP_DisconnResp,
    L2CAP_Hdr,
)
from scapy.packet import Packet, Raw

from ev3proto.capture.carriers.bluetooth.adapters import CLOSED, DONE, OPEN
from ev3proto.generate.captures.bluetooth import (
    AGREES,
    ASKS,
    CREDITS,
    ENOUGH,
    MODEM_STATUS,
    NEGOTIATION,
    modem_status,
    multiplexed,
    negotiated,
    rfcomm_frame,
)
from ev3proto.tables.carriers import RFCOMM_CHANNEL, RFCOMM_DATA, RFCOMM_POLL
from making import dialogue
from making.dialogue import CONTENTS, Exchange, Host
from making.directory import FOUND, SEARCH, Sdp
from making.files import Record, Wire

ADDRESS = "00:16:53:00:00:0a"
CONNECTION = 0x00B
SDP, RFCOMM = 1, 3
SIGNALS = 1
L2CAP_MTU = 672
FRAME_SIZE = 250
"""Bytes in an RFCOMM frame: fewer than possible, so that frames are split."""

# HCI and L2CAP


class Link:
    """A connection between a host, which captures, and a brick."""

    def __init__(self, wire: Wire) -> None:
        self.wire = wire
        self.signals = 0
        self.sent = 0
        self.channels: dict[int, tuple[int, int]] = {}

    def _add(self, packet: Packet, received: bool) -> None:
        self.wire.add(packet, received)

    def connect(self) -> None:
        """The host's controller connects to the brick."""
        create = HCI_Cmd_Create_Connection(bd_addr=ADDRESS)
        self._add(HCI_Hdr() / HCI_Command_Hdr() / create, False)
        self.wire.wait(1000)
        opcode = HCI_Command_Hdr(bytes(HCI_Command_Hdr() / create)).opcode
        self._add(HCI_Hdr() / HCI_Event_Hdr() / HCI_Event_Command_Status(number=1, opcode=opcode), True)
        self.wire.wait(640_000)
        complete = HCI_Event_Connection_Complete(connection_handle=CONNECTION, bd_addr=ADDRESS, link_type=1)
        self._add(HCI_Hdr() / HCI_Event_Hdr() / complete, True)
        self.wire.wait(2000)

    def completed(self) -> None:
        """The controller reports how many packets it has sent since its last report."""
        event = HCI_Event_Number_Of_Completed_Packets(
            num_handles=1, connection_handle_list=[CONNECTION], num_completed_packets_list=[self.sent]
        )
        self.sent = 0
        self._add(HCI_Hdr() / HCI_Event_Hdr() / event, True)
        self.wire.wait(300)

    def packet(self, received: bool, cid: int, payload: Packet, fragment: int = 0) -> None:
        """An L2CAP packet, in ACL packets of at most `fragment` bytes if that is given."""
        data = bytes(L2CAP_Hdr(cid=cid) / payload)
        for at in range(0, len(data), fragment or len(data)):
            boundary = 1 if at else 2 * received
            head = HCI_Hdr() / HCI_ACL_Hdr(connection_handle=CONNECTION, PB=boundary)
            self._add(head / Raw(data[at : at + (fragment or len(data))]), received)
            self.sent += not received
            self.wire.wait(400)
        self.wire.wait(1500)

    def signal(self, received: bool, payload: Packet, identifier: int) -> None:
        """A packet on the signalling channel."""
        self.packet(received, SIGNALS, L2CAP_CmdHdr(id=identifier) / payload)

    def open(self, psm: int, ours: int, theirs: int) -> None:
        """An L2CAP channel: connected, then configured by both ends."""
        self.channels[psm] = ours, theirs
        mtu = Raw(b"\x01\x02" + L2CAP_MTU.to_bytes(2, "little"))
        self.signals += 2
        ask, tell = self.signals - 1, self.signals
        self.signal(False, L2CAP_ConnReq(psm=psm, scid=ours), ask)
        self.signal(True, L2CAP_ConnResp(dcid=theirs, scid=ours), ask)
        self.signal(False, L2CAP_ConfReq(dcid=theirs) / mtu, tell)
        self.signal(True, L2CAP_ConfResp(scid=ours) / mtu, tell)
        self.signal(True, L2CAP_ConfReq(dcid=ours) / mtu, ask)
        self.signal(False, L2CAP_ConfResp(scid=theirs) / mtu, ask)

    def close(self, psm: int) -> None:
        """Closes an L2CAP channel."""
        ours, theirs = self.channels.pop(psm)
        self.signals += 1
        self.signal(False, L2CAP_DisconnReq(dcid=theirs, scid=ours), self.signals)
        self.signal(True, L2CAP_DisconnResp(dcid=theirs, scid=ours), self.signals)

    def search(self) -> None:
        """The host searches the brick's service directory for the serial port."""
        self.open(SDP, 0x0040, 0x0050)
        ours, theirs = self.channels[SDP]
        self.packet(False, theirs, Sdp(kind=6, transaction=1) / Raw(SEARCH))
        self.packet(True, ours, Sdp(kind=7, transaction=1) / Raw(len(FOUND).to_bytes(2, "big") + FOUND + b"\0"))
        self.close(SDP)


class SerialPort:
    """RFCOMM over an L2CAP channel that the host has opened, with the brick's channel 1."""

    DLCI = RFCOMM_CHANNEL << 1

    def __init__(self, link: Link, ours: int = 0x0041, theirs: int = 0x0051) -> None:
        self.link = link
        self.cids = theirs, ours
        self.credits = [CREDITS, CREDITS]

    def frame(self, received: bool, frame: bytes, fragment: int = 0) -> None:
        """An RFCOMM frame."""
        self.link.packet(received, self.cids[received], Raw(frame), fragment)

    def ask(self, dlci: int, control: int) -> None:
        """A request of the host about a DLCI, and the brick's agreement."""
        self.frame(False, rfcomm_frame(dlci << 2 | 3, control | RFCOMM_POLL))
        self.frame(True, rfcomm_frame(dlci << 2 | 3, DONE | RFCOMM_POLL))

    def multiplexer(self, received: bool, kind: int, is_command: bool, body: bytes) -> None:
        """A command or response about a DLCI."""
        self.frame(received, rfcomm_frame((not received) << 1 | 1, RFCOMM_DATA, multiplexed(kind, is_command, body)))

    def open(self) -> None:
        """Opens the serial port."""
        self.ask(0, OPEN)
        self.multiplexer(False, NEGOTIATION, True, negotiated(ASKS, FRAME_SIZE))
        self.multiplexer(True, NEGOTIATION, False, negotiated(AGREES, FRAME_SIZE))
        self.ask(self.DLCI, OPEN)
        for received in (False, True):
            self.multiplexer(received, MODEM_STATUS, True, modem_status(self.DLCI))
            self.multiplexer(not received, MODEM_STATUS, False, modem_status(self.DLCI))

    def close(self) -> None:
        """Closes the serial port."""
        self.ask(self.DLCI, CLOSED)
        self.ask(0, CLOSED)

    def data(self, received: bool, *pieces: bytes, fragment: int = 0) -> None:
        """Pieces of data, one per frame. A frame brings credits when the other end has few left."""
        for piece in pieces:
            granted = self.lacking(received)
            self.credits[received] -= bool(piece)
            self.credits[not received] += granted
            if self.credits[received] < 0:
                raise ValueError("a frame is sent without credit for it")
            address = self.DLCI << 2 | (not received) << 1 | 1
            control, credit = (RFCOMM_DATA | RFCOMM_POLL, bytes((granted,))) if granted else (RFCOMM_DATA, b"")
            self.frame(received, rfcomm_frame(address, control, piece, credit), fragment)

    def lacking(self, received: bool) -> int:
        """The credits that an end gives with its next frame: none while the other end has enough."""
        left = self.credits[not received]
        return CREDITS - left if left <= ENOUGH else 0

    def write(self, received: bool, data: bytes, fragment: int = 0) -> None:
        """Data in frames as long as possible; a frame with credits holds one byte less."""
        first = FRAME_SIZE - bool(self.lacking(received))
        rest = (data[at : at + FRAME_SIZE] for at in range(first, len(data), FRAME_SIZE))
        self.data(received, data[:first], *rest, fragment=fragment)

    def exchange(self, pair: Exchange) -> None:
        """A command and its reply."""
        self.write(False, pair.command)
        self.write(True, pair.reply)


# The captures


def whole() -> Wire:
    """A connection from beginning to end: search, serial port, dialogue."""
    wire = Wire()
    link = Link(wire)
    host = Host()
    link.connect()
    link.search()
    link.open(RFCOMM, 0x0041, 0x0051)
    port = SerialPort(link)
    port.open()
    link.completed()
    port.exchange(dialogue.versions(host))
    # Two frames in one of RFCOMM's, of which the second is answered.
    silent = host.tell(dialogue.tone())
    pair = dialogue.voltage(host)
    port.write(False, silent + pair.command)
    port.write(True, pair.reply)
    # A command split inside its length field; its reply also split, and its end sent with the next reply's.
    first, second = dialogue.sensors(host), dialogue.touch(host, 100)
    port.data(False, first.command[:1], first.command[1:])
    port.data(False, second.command)
    port.data(True, first.reply[:7], first.reply[7:] + second.reply[:1], second.reply[1:])
    port.data(False, b"")
    # An ACL packet that is split, from the host and from the brick.
    port.write(False, host.tell(dialogue.light("LED_RED_PULSE"), *dialogue.start_motors()), fragment=10)
    pair = dialogue.gyro(host)
    port.write(False, pair.command)
    port.write(True, pair.reply, fragment=12)
    link.completed()
    port.exchange(dialogue.misaligned(host))
    for pair in dialogue.upload(host, "../prjs/log/values.rtf", CONTENTS[:1300], 700):
        port.exchange(pair)
    begin, *pieces = dialogue.download(host, "../prjs/log/values.rtf", CONTENTS[:600])
    port.exchange(begin)
    for pair in pieces:
        port.write(False, pair.command, fragment=192)
        port.write(True, pair.reply)
    port.write(False, host.mail("abc", b"hello\0"))
    port.write(False, host.tell(dialogue.stop_motors()))
    port.close()
    link.close(RFCOMM)
    return wire


def begun_late() -> Wire:
    """Begins with the L2CAP channel: neither the connection nor the search for the serial port was captured."""
    wire = Wire()
    link = Link(wire)
    host = Host(300)
    link.open(RFCOMM, 0x0041, 0x0051)
    port = SerialPort(link)
    port.open()
    port.exchange(dialogue.voltage(host))
    # A reply in three frames, the second of which is split into ACL packets; two commands in one frame.
    pair = dialogue.sensors(host)
    port.write(False, pair.command)
    port.data(True, pair.reply[:1])
    port.data(True, pair.reply[1:20], fragment=16)
    port.data(True, pair.reply[20:])
    link.completed()
    silent = host.tell(dialogue.light("LED_GREEN"))
    first, second = dialogue.touch(host, 0), dialogue.motor_angles(host, 7, 8)
    port.write(False, silent + first.command + second.command[:9])
    port.data(False, second.command[9:])
    port.write(True, first.reply + second.reply)
    port.exchange(dialogue.misaligned(host))
    port.exchange(dialogue.listing(host, "/home/root/lms2012/prjs/log/", 1000)[0])
    return wire


def with_direction(wire: Wire) -> Wire:
    """The same with a word before each packet that gives its direction."""
    found = Wire(wire.now)
    found.records = [
        Record(time, HCI_PHDR_Hdr(direction=int(received)) / packet, received)
        for time, packet, received in wire.records
    ]
    return found
