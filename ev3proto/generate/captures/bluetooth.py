"""Bluetooth as a computer sees it: a connection, a serial port (RFCOMM) with credits, and frames cut to fit."""

from __future__ import annotations

import struct

from construct import Int8ul, Int16ul, Struct

from ev3proto.capture.carriers.bluetooth.adapters import (
    ACL,
    ACL_PACKET,
    CLOSED,
    COMMAND_PACKET,
    CONNECTED,
    DIRECTION,
    DISCONNECTED,
    DONE,
    EVENT_PACKET,
    HANDLE_BITS,
    L2CAP,
    OPEN,
    frame_check,
)
from ev3proto.tables.carriers import RFCOMM_CHANNEL, RFCOMM_DATA, RFCOMM_POLL

ADDRESS = bytes.fromhex("06165300000a")
"""The brick's address, from a range assigned to no vendor."""

CONNECTION = 0x00B
OURS, THEIRS = 0x0041, 0x0051
"""L2CAP channels in which the host and the brick receive."""

L2CAP_MTU = 1021
FRAME_SIZE = 1008
CREDITS = 7
"""Agreed limits: bytes in a packet, bytes in an RFCOMM frame, frames that either end may send without new credits."""

ENOUGH = 4
"""Number of remaining credits at which an end gets more."""

SIGNAL = Struct("code" / Int8ul, "identifier" / Int8ul, "length" / Int16ul)
CONNECTION_REQUEST = Struct("service" / Int16ul, "source" / Int16ul)
CONNECTION_RESPONSE = Struct("target" / Int16ul, "source" / Int16ul, "result" / Int16ul)
SIGNALS, SERVICE_RFCOMM = 1, 3
"""The L2CAP channel on which channels are set up, and the number of RFCOMM."""

CREATE_CONNECTION, DISCONNECT = 0x0405, 0x0406
COMMAND_STATUS, COMPLETED_PACKETS = 0x0F, 0x13
ASK, ANSWER, CONFIGURE, CONFIGURED, CLOSE, DISCONNECTED_CHANNEL = 2, 3, 4, 5, 6, 7
"""HCI commands and events, and L2CAP signals."""

NEGOTIATION, MODEM_STATUS = 0x20, 0x38
"""Message types of RFCOMM's multiplexer."""

ASKS, AGREES = 0xF0, 0xE0
"""How the ends negotiate that credits control the flow."""

DLCI = RFCOMM_CHANNEL << 1

_REASON = 0x13
"""Reason for disconnecting: ended by the remote user."""

NEGOTIATED = Struct(
    "dlci" / Int8ul,
    "flow" / Int8ul,
    "priority" / Int8ul,
    "timer" / Int8ul,
    "frame_size" / Int16ul,
    "retransmissions" / Int8ul,
    "credits" / Int8ul,
)
"""The requested settings of a port."""


class Writer:
    """A computer and a brick, captured between the computer and its Bluetooth adapter."""

    def __init__(self) -> None:
        self._credits = {True: CREDITS, False: CREDITS}
        self._unconfirmed = 0

    def opening(self) -> list[bytes]:
        """Opens the connection, the channel and the serial port."""
        modem = modem_status(DLCI)
        return [
            *self._connect(),
            self._signal(True, ASK, 1, CONNECTION_REQUEST.build({"service": SERVICE_RFCOMM, "source": OURS})),
            self._signal(
                False, ANSWER, 1, CONNECTION_RESPONSE.build({"target": THEIRS, "source": OURS, "result": 0}) + bytes(2)
            ),
            *self._configure(True, 2, THEIRS, OURS),
            *self._configure(False, 1, OURS, THEIRS),
            *self._turn(0, OPEN),
            self._multiplexer(True, NEGOTIATION, True, negotiated(ASKS)),
            self._multiplexer(False, NEGOTIATION, False, negotiated(AGREES)),
            *self._turn(DLCI, OPEN),
            self._multiplexer(True, MODEM_STATUS, True, modem),
            self._multiplexer(False, MODEM_STATUS, False, modem),
            self._multiplexer(False, MODEM_STATUS, True, modem),
            self._multiplexer(True, MODEM_STATUS, False, modem),
            *self._confirmed(),
        ]

    def between(self, is_from_host: bool) -> list[bytes]:  # noqa: ARG002 - same for both directions
        """Makes the adapter report what it has sent."""
        return self._confirmed()

    def frame(self, frame: bytes, is_from_host: bool) -> list[bytes]:
        """Packs a frame into full RFCOMM frames; when the sender is out of credits, the other end grants some."""
        packets: list[bytes] = []
        while frame:
            if not self._credits[is_from_host]:
                packets.append(self._data(not is_from_host, b""))
            room = FRAME_SIZE - bool(self._lacking(is_from_host))
            packets.append(self._data(is_from_host, frame[:room]))
            frame = frame[room:]
        return packets

    def closing(self) -> list[bytes]:
        """Closes the port, the channel and the connection."""
        ends = CONNECTION_REQUEST.build({"service": THEIRS, "source": OURS})
        handle = struct.pack("<H", CONNECTION)
        return [
            *self._confirmed(),
            *self._turn(DLCI, CLOSED),
            *self._turn(0, CLOSED),
            self._signal(True, CLOSE, 3, ends),
            self._signal(False, DISCONNECTED_CHANNEL, 3, ends),
            *self._confirmed(),
            _command(DISCONNECT, handle + bytes((_REASON,))),
            _event(COMMAND_STATUS, struct.pack("<BBH", 0, 1, DISCONNECT)),
            _event(DISCONNECTED, b"\0" + handle + bytes((0x16,))),
        ]

    def stamped(self, packet: bytes, time_ns: int) -> bytes:  # noqa: ARG002 - these packets hold no time
        """Returns the packet unchanged."""
        return packet

    # The connection

    def _connect(self) -> list[bytes]:
        address = ADDRESS[::-1]
        return [
            _command(CREATE_CONNECTION, address + struct.pack("<HBBHB", 0xCC18, 2, 0, 0, 1)),
            _event(COMMAND_STATUS, struct.pack("<BBH", 0, 1, CREATE_CONNECTION)),
            _event(CONNECTED, struct.pack("<BH", 0, CONNECTION) + address + bytes((1, 0))),
        ]

    def _confirmed(self) -> list[bytes]:
        if not self._unconfirmed:
            return []
        event = _event(COMPLETED_PACKETS, struct.pack("<BHH", 1, CONNECTION, self._unconfirmed))
        self._unconfirmed = 0
        return [event]

    def _packet(self, is_from_host: bool, channel: int, data: bytes) -> bytes:
        """Builds an L2CAP packet."""
        data = L2CAP.pack(len(data), channel) + data
        boundary = 0 if is_from_host else 2
        head = ACL.pack(CONNECTION | boundary << HANDLE_BITS, len(data))
        self._unconfirmed += is_from_host
        return _hci(is_from_host, ACL_PACKET, head + data)

    def _signal(self, is_from_host: bool, code: int, identifier: int, data: bytes) -> bytes:
        head = SIGNAL.build({"code": code, "identifier": identifier, "length": len(data)})
        return self._packet(is_from_host, SIGNALS, head + data)

    def _configure(self, is_from_host: bool, identifier: int, target: int, source: int) -> list[bytes]:
        """Announces the largest packet that an end accepts; the other end agrees."""
        mtu = struct.pack("<BBH", 1, 2, L2CAP_MTU)
        return [
            self._signal(is_from_host, CONFIGURE, identifier, struct.pack("<HH", target, 0) + mtu),
            self._signal(not is_from_host, CONFIGURED, identifier, struct.pack("<HHH", source, 0, 0) + mtu),
        ]

    # The serial port

    def _rfcomm(self, is_from_host: bool, address: int, control: int, data: bytes = b"", credits: bytes = b"") -> bytes:
        channel = THEIRS if is_from_host else OURS
        return self._packet(is_from_host, channel, rfcomm_frame(address, control, data, credits))

    def _turn(self, dlci: int, control: int) -> list[bytes]:
        """Opens or closes a port from the host; the brick agrees."""
        address = dlci << 2 | 3
        return [self._rfcomm(True, address, control | RFCOMM_POLL), self._rfcomm(False, address, DONE | RFCOMM_POLL)]

    def _multiplexer(self, is_from_host: bool, kind: int, is_command: bool, body: bytes) -> bytes:
        return self._rfcomm(is_from_host, is_from_host << 1 | 1, RFCOMM_DATA, multiplexed(kind, is_command, body))

    def _data(self, is_from_host: bool, piece: bytes) -> bytes:
        granted = self._lacking(is_from_host)
        self._credits[is_from_host] -= bool(piece)
        self._credits[not is_from_host] += granted
        address = DLCI << 2 | is_from_host << 1 | 1
        if granted:
            return self._rfcomm(is_from_host, address, RFCOMM_DATA | RFCOMM_POLL, piece, bytes((granted,)))
        return self._rfcomm(is_from_host, address, RFCOMM_DATA, piece)

    def _lacking(self, is_from_host: bool) -> int:
        """Returns the credits that an end grants with its next frame: none while the other end has enough."""
        left = self._credits[not is_from_host]
        return CREDITS - left if left <= ENOUGH else 0


def _hci(is_from_host: bool, kind: int, data: bytes) -> bytes:
    return DIRECTION.pack(not is_from_host) + bytes((kind,)) + data


def _command(code: int, parameters: bytes) -> bytes:
    return _hci(True, COMMAND_PACKET, struct.pack("<HB", code, len(parameters)) + parameters)


def _event(code: int, parameters: bytes) -> bytes:
    return _hci(False, EVENT_PACKET, bytes((code, len(parameters))) + parameters)


# RFCOMM


def rfcomm_frame(address: int, control: int, data: bytes = b"", credits: bytes = b"") -> bytes:
    """Builds an RFCOMM frame, with its length and checksum; a byte of credits does not count as data."""
    size = len(data)
    length = bytes((size << 1 | 1,)) if size < 0x80 else (size << 1).to_bytes(2, "little")
    head = bytes((address, control))
    # Frames with data are checked without their length.
    checked = head if control & ~RFCOMM_POLL == RFCOMM_DATA else head + length
    return head + length + credits + data + bytes((frame_check(checked),))


def multiplexed(kind: int, is_command: bool, body: bytes) -> bytes:
    """Builds a message of the multiplexer: NEGOTIATION or MODEM_STATUS, as a command or as the response to one."""
    return bytes((kind << 2 | is_command << 1 | 1, len(body) << 1 | 1)) + body


def negotiated(flow: int, frame_size: int = FRAME_SIZE, dlci: int = DLCI) -> bytes:
    """Builds the parameters of a port; `flow` is ASKS or AGREES."""
    port = {"dlci": dlci, "flow": flow, "priority": 7, "timer": 0, "retransmissions": 0}
    return bytes(NEGOTIATED.build(port | {"frame_size": frame_size, "credits": CREDITS}))


def modem_status(dlci: int) -> bytes:
    """Builds the status of a serial port's lines: all ready."""
    return bytes((dlci << 2 | 3, 0x8D))
