"""USB as Linux captures it: a brick is plugged in and describes itself, then reports go back and forth."""

from __future__ import annotations

from construct import Construct, Int8ul, Int16ul, Int32ul, Struct

from ev3proto.capture.carriers.usb.requests import CONTROL, IN, INTERRUPT, USBMON
from ev3proto.capture.record import NANOSECONDS
from ev3proto.tables.carriers import USB_ENDPOINT_IN, USB_ENDPOINT_OUT, USB_PRODUCT, USB_VENDOR
from ev3proto.tables.frame import MAX_FRAME

DEVICE_DESCRIPTOR, CONFIGURATION, STRING, INTERFACE, ENDPOINT, HID, HID_REPORT = 1, 2, 3, 4, 5, 0x21, 0x22
"""Types of descriptors."""

ENGLISH = 0x0409
"""The language of the string descriptors."""

LANGUAGES = bytes((4, STRING)) + ENGLISH.to_bytes(2, "little")
"""The string descriptor with the product's name."""


CONFIGURATION_SIZE = 9
"""Bytes of a configuration descriptor without those inside it; a host asks for these first."""

_COUNT = MAX_FRAME.to_bytes(2, "little")
REPORT = (
    bytes.fromhex("06 00 FF 09 01 A1 01 15 00 26 FF 00 75 08")  # vendor-defined: bytes 0 to 255,
    + b"\x96"
    + _COUNT
    + bytes.fromhex("09 01 81 02")  # this number of them to the host,
    + b"\x96"
    + _COUNT
    + bytes.fromhex("09 01 91 02 C0")  # and the same number from it
)
"""The report descriptor of the brick."""


def _descriptor(kind: int, **fields: tuple[Construct, int]) -> bytes:
    """Builds a descriptor from the type and value of each field."""
    data = b"".join(type_.build(value) for type_, value in fields.values())
    return bytes((2 + len(data), kind)) + data


def device(product: int = USB_PRODUCT) -> bytes:
    """Builds the device descriptor of a brick; `product` differs while its firmware is updated."""
    return _descriptor(
        DEVICE_DESCRIPTOR,
        usb=(Int16ul, 0x0200),
        device_class=(Int8ul, 0),
        subclass=(Int8ul, 0),
        protocol=(Int8ul, 0),
        packet_size=(Int8ul, 64),
        vendor=(Int16ul, USB_VENDOR),
        product=(Int16ul, product),
        version=(Int16ul, 0x0100),
        maker_name=(Int8ul, 1),
        product_name=(Int8ul, 2),
        serial_number=(Int8ul, 3),
        configurations=(Int8ul, 1),
    )


def configuration() -> bytes:
    """Builds the descriptor of the only configuration: a HID interface with an endpoint in each direction."""
    interface = _descriptor(
        INTERFACE,
        number=(Int8ul, 0),
        alternative=(Int8ul, 0),
        endpoints=(Int8ul, 2),
        interface_class=(Int8ul, 3),
        subclass=(Int8ul, 0),
        protocol=(Int8ul, 0),
        name=(Int8ul, 0),
    )
    hid = _descriptor(
        HID,
        version=(Int16ul, 0x0110),
        country=(Int8ul, 0),
        descriptors=(Int8ul, 1),
        kind_of_it=(Int8ul, HID_REPORT),
        size=(Int16ul, len(REPORT)),
    )
    inside = interface + hid + _endpoint(USB_ENDPOINT_IN) + _endpoint(USB_ENDPOINT_OUT)
    head = _descriptor(
        CONFIGURATION,
        total=(Int16ul, CONFIGURATION_SIZE + len(inside)),
        interfaces=(Int8ul, 1),
        number=(Int8ul, 1),
        name=(Int8ul, 0),
        attributes=(Int8ul, 0xC0),
        power=(Int8ul, 1),
    )
    return head + inside


def _endpoint(address: int) -> bytes:
    return _descriptor(
        ENDPOINT, address=(Int8ul, address), attributes=(Int8ul, 3), size=(Int16ul, MAX_FRAME), interval=(Int8ul, 4)
    )


def string(text: str) -> bytes:
    """Builds a string descriptor."""
    data = text.encode("utf-16-le")
    return bytes((2 + len(data), STRING)) + data


BUS, DEVICE = 1, 7

GET_DESCRIPTOR, SET_CONFIGURATION, SET_IDLE = 6, 9, 10
"""Control requests on endpoint 0."""

NAMES = ("LEGO Group", "EV3", "06165300000a")
"""Manufacturer, product, serial number."""

SUBMITTED, DONE = ord("S"), ord("C")
_IN_PROGRESS, SHUT_DOWN = -115, -108
_HAS_SETUP, _HAS_NO_SETUP = 0, ord("-")
_INTERVAL = 8

_SECONDS_AT = 16
"""Offsets of the time in the header that `USBMON` packs: seconds in 8 bytes, microseconds in 4."""

MORE = Struct("interval" / Int32ul, "start_frame" / Int32ul, "flags" / Int32ul, "descriptors" / Int32ul)
"""The part of the header that newer kernels add."""

SETUP = Struct("kind" / Int8ul, "request" / Int8ul, "value" / Int16ul, "index" / Int16ul, "length" / Int16ul)


class Writer:
    """A computer that runs Linux, and a brick at one of its ports."""

    def __init__(self) -> None:
        self._last_from_host: bool | None = None

    def opening(self) -> list[bytes]:
        """Asks for the descriptors and sets the configuration; the host then waits for a report."""
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

    def between(self, is_from_host: bool) -> list[bytes]:  # noqa: ARG002 - same for both directions
        """Completes what was submitted, or submits a read of the next report."""
        if self._last_from_host:
            return [_request(DONE, USB_ENDPOINT_OUT)]
        return [_request(SUBMITTED, USB_ENDPOINT_IN)]

    def frame(self, frame: bytes, is_from_host: bool) -> list[bytes]:
        """Carries one report, whatever the size of the frame: the rest is zero."""
        self._last_from_host = is_from_host
        report = frame.ljust(MAX_FRAME, b"\0")
        if is_from_host:
            return [_request(SUBMITTED, USB_ENDPOINT_OUT, report)]
        return [_request(DONE, USB_ENDPOINT_IN, report)]

    def closing(self) -> list[bytes]:
        """Unplugs the brick while the host waits for a report."""
        last = [] if self._last_from_host is None else self.between(True)
        return [*last, _request(DONE, USB_ENDPOINT_IN, status=SHUT_DOWN)]

    def stamped(self, packet: bytes, time_ns: int) -> bytes:
        """Returns the packet with its time."""
        return stamped(packet, time_ns)


def stamped(packet: bytes, time_ns: int) -> bytes:
    """Returns a usbmon packet with its time, in nanoseconds since 1970, written as Linux does."""
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
    """Builds a usbmon packet, at time 0.

    A status is 0 or a negative error number of Linux; a submitted request is in progress. With `is_padded`, the header
    has 64 bytes, as read from memory, instead of 48.
    """
    is_control = endpoint & ~IN == 0
    is_in = bool(endpoint & IN)
    carries = is_in == (event == DONE)
    head = USBMON["<"].pack(
        0xFFFF888000000000 | device << 16 | endpoint << 8,
        event,
        CONTROL if is_control else INTERRUPT,
        endpoint,
        device,
        bus,
        _HAS_SETUP if setup else _HAS_NO_SETUP,
        0 if carries else ord("<" if is_in else ">"),
        0,
        0,
        (_IN_PROGRESS if event == SUBMITTED else status) % 2**32,
        size,
        len(data),
        setup or bytes(8),
    )
    more = {"interval": 0 if is_control else _INTERVAL, "start_frame": 0, "flags": flags, "descriptors": 0}
    return head + (bytes(MORE.build(more)) if is_padded else b"") + data


def _request(event: int, endpoint: int, data: bytes = b"", *, status: int = 0) -> bytes:
    """Builds the packet of a report: submitted or completed."""
    return record(event, endpoint, data, status=status, size=0 if status else len(data) or MAX_FRAME)


def _asked(kind: int, number: int, answer: bytes, index: int = 0, *, of_interface: bool = False) -> list[bytes]:
    """Asks for a descriptor from the host, with the device's answer."""
    request = {"kind": 0x81 if of_interface else 0x80, "request": GET_DESCRIPTOR, "index": index}
    setup = SETUP.build(request | {"value": kind << 8 | number, "length": len(answer)})
    return [
        record(SUBMITTED, IN, setup=setup, size=len(answer)),
        record(DONE, IN, answer, size=len(answer)),
    ]


def _set(request: int, kind: int, value: int) -> list[bytes]:
    """Sets a value on the device."""
    setup = SETUP.build({"kind": kind, "request": request, "value": value, "index": 0, "length": 0})
    return [record(SUBMITTED, 0, setup=setup), record(DONE, 0)]
