"""USB as Linux records it: a brick is plugged in and asked what it is, then reports go back and forth."""

from __future__ import annotations

from construct import Int8ul, Int16ul, Int32ul, Struct

from ev3proto.capture.carriers.usb.requests import CONTROL, IN, INTERRUPT, USBMON
from ev3proto.capture.record import NANOSECONDS
from ev3proto.generate.captures.descriptors import (
    CONFIGURATION,
    CONFIGURATION_SIZE,
    DEVICE_DESCRIPTOR,
    ENGLISH,
    HID_REPORT,
    LANGUAGES,
    REPORT,
    STRING,
    configuration,
    device,
    string,
)
from ev3proto.tables.carriers import USB_ENDPOINT_IN, USB_ENDPOINT_OUT
from ev3proto.tables.frame import MAX_FRAME

BUS, DEVICE = 1, 7

GET_DESCRIPTOR, SET_CONFIGURATION, SET_IDLE = 6, 9, 10
"""Requests on endpoint 0."""

NAMES = ("LEGO Group", "EV3", "06165300000a")
"""Maker, product, serial number."""

SUBMITTED, DONE = ord("S"), ord("C")
_IN_PROGRESS, SHUT_DOWN = -115, -108
_HAS_SETUP, _HAS_NO_SETUP = 0, ord("-")
_INTERVAL = 8

_SECONDS_AT = 16
"""Where the time stands in what `USBMON` says: seconds in 8 bytes, microseconds in 4."""

MORE = Struct("interval" / Int32ul, "start_frame" / Int32ul, "flags" / Int32ul, "descriptors" / Int32ul)
"""What newer kernels add to the header."""

SETUP = Struct("kind" / Int8ul, "request" / Int8ul, "value" / Int16ul, "index" / Int16ul, "length" / Int16ul)


class Writer:
    """A computer that runs Linux, and a brick at its port."""

    def __init__(self) -> None:
        self._last_from_host: bool | None = None

    def opening(self) -> list[bytes]:
        """Descriptors are asked for, the configuration is set; the host then waits for a report."""
        whole = configuration()
        return [
            *_asked(DEVICE_DESCRIPTOR, 0, device()),
            *_asked(CONFIGURATION, 0, whole[:CONFIGURATION_SIZE]),
            *_asked(CONFIGURATION, 0, whole),
            *_asked(STRING, 0, LANGUAGES),
            *(
                packet
                for number, name in enumerate(NAMES, 1)
                for packet in _asked(STRING, number, string(name), ENGLISH)
            ),
            *_set(SET_CONFIGURATION, 0x00, 1),
            *_set(SET_IDLE, 0x21, 0),
            *_asked(HID_REPORT, 0, REPORT, of_interface=True),
            _request(SUBMITTED, USB_ENDPOINT_IN),
        ]

    def between(self, is_from_host: bool) -> list[bytes]:  # noqa: ARG002 - the same whoever is next
        """What was submitted is done, or the host waits for the next report."""
        if self._last_from_host:
            return [_request(DONE, USB_ENDPOINT_OUT)]
        return [_request(SUBMITTED, USB_ENDPOINT_IN)]

    def frame(self, frame: bytes, is_from_host: bool) -> list[bytes]:
        """One report, whatever the size of the frame: the rest is zero."""
        self._last_from_host = is_from_host
        report = frame.ljust(MAX_FRAME, b"\0")
        if is_from_host:
            return [_request(SUBMITTED, USB_ENDPOINT_OUT, report)]
        return [_request(DONE, USB_ENDPOINT_IN, report)]

    def closing(self) -> list[bytes]:
        """The brick is unplugged while the host waits for a report."""
        last = [] if self._last_from_host is None else self.between(True)
        return [*last, _request(DONE, USB_ENDPOINT_IN, status=SHUT_DOWN)]

    def stamped(self, packet: bytes, time_ns: int) -> bytes:
        """The packet with its time."""
        return stamped(packet, time_ns)


def stamped(packet: bytes, time_ns: int) -> bytes:
    """A packet of usbmon with the time, in nanoseconds since 1970, that Linux writes into each."""
    seconds, rest = divmod(time_ns, NANOSECONDS)
    stamp = seconds.to_bytes(8, "little") + (rest // 1000).to_bytes(4, "little")
    return packet[:_SECONDS_AT] + stamp + packet[_SECONDS_AT + len(stamp) :]


def record(
    event: int,
    endpoint: int,
    data: bytes = b"",
    *,
    device: int = DEVICE,
    bus: int = BUS,
    status: int = 0,
    setup: bytes = b"",
    size: int = 0,
    flags: int = 0,
    is_padded: bool = True,
) -> bytes:
    """A packet of usbmon, at time 0.

    Args:
        event: SUBMITTED or DONE.
        endpoint: The endpoint, with the bit for the direction; endpoint 0 takes control transfers.
        data: The bytes that went over.
        device: The number of the device on its bus.
        bus: The bus.
        status: How a request ended: 0, or less for an error of Linux. What was submitted is in progress.
        setup: The request of a control transfer.
        size: How many bytes were asked for, or went over.
        flags: Linux's flags of the request.
        is_padded: The header has 64 bytes, as it is read from memory, not 48.

    Returns:
        Header and data.
    """
    is_control = endpoint & ~IN == 0
    is_in = bool(endpoint & IN)
    carries = is_in == (event == DONE)
    head = USBMON.build(
        {
            "id": 0xFFFF888000000000 | device << 16 | endpoint << 8,
            "event": event,
            "transfer": CONTROL if is_control else INTERRUPT,
            "endpoint": endpoint,
            "device": device,
            "bus": bus,
            "has_no_setup": _HAS_SETUP if setup else _HAS_NO_SETUP,
            "has_no_data": 0 if carries else ord("<" if is_in else ">"),
            "seconds": 0,
            "microseconds": 0,
            "status": (_IN_PROGRESS if event == SUBMITTED else status) % 2**32,
            "size": size,
            "captured": len(data),
            "setup": setup or bytes(8),
        }
    )
    more = {"interval": 0 if is_control else _INTERVAL, "start_frame": 0, "flags": flags, "descriptors": 0}
    return bytes(head) + (bytes(MORE.build(more)) if is_padded else b"") + data


def _request(event: int, endpoint: int, data: bytes = b"", *, status: int = 0) -> bytes:
    """A packet of a report: submitted or done."""
    return record(event, endpoint, data, status=status, size=0 if status else len(data) or MAX_FRAME)


def _asked(kind: int, number: int, answer: bytes, index: int = 0, *, of_interface: bool = False) -> list[bytes]:
    """The host asks for a descriptor and gets it."""
    request = {"kind": 0x81 if of_interface else 0x80, "request": GET_DESCRIPTOR, "index": index}
    setup = SETUP.build(request | {"value": kind << 8 | number, "length": len(answer)})
    return [
        record(SUBMITTED, IN, setup=setup, size=len(answer)),
        record(DONE, IN, answer, size=len(answer)),
    ]


def _set(request: int, kind: int, value: int) -> list[bytes]:
    """The host sets something."""
    setup = SETUP.build({"kind": kind, "request": request, "value": value, "index": 0, "length": 0})
    return [record(SUBMITTED, 0, setup=setup), record(DONE, 0)]
