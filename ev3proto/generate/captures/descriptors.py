"""What a brick says of itself when it is plugged in: the descriptors that a host asks for."""

from __future__ import annotations

from construct import Const, Construct, Int8ul, Int16ul, Struct

from ev3proto.tables.carriers import USB_ENDPOINT_IN, USB_ENDPOINT_OUT, USB_PRODUCT, USB_VENDOR
from ev3proto.tables.frame import MAX_FRAME

DEVICE_DESCRIPTOR, CONFIGURATION, STRING, INTERFACE, ENDPOINT, HID, HID_REPORT = 1, 2, 3, 4, 5, 0x21, 0x22
"""Kinds of descriptors."""

ENGLISH = 0x0409
"""The language of the texts."""

LANGUAGES = bytes((4, STRING)) + ENGLISH.to_bytes(2, "little")
"""The descriptor that names it."""


def _descriptor(kind: int, **fields: Construct) -> Struct:
    size = 2 + sum(field.sizeof() for field in fields.values())
    heads = ("length" / Const(size, Int8ul), "kind" / Const(kind, Int8ul))
    return Struct(*heads, *(name / field for name, field in fields.items()))


OF_DEVICE = _descriptor(
    DEVICE_DESCRIPTOR,
    usb=Int16ul,
    device_class=Int8ul,
    subclass=Int8ul,
    protocol=Int8ul,
    packet_size=Int8ul,
    vendor=Int16ul,
    product=Int16ul,
    version=Int16ul,
    maker_name=Int8ul,
    product_name=Int8ul,
    serial_number=Int8ul,
    configurations=Int8ul,
)
OF_CONFIGURATION = _descriptor(
    CONFIGURATION,
    total=Int16ul,
    interfaces=Int8ul,
    number=Int8ul,
    name=Int8ul,
    attributes=Int8ul,
    power=Int8ul,
)
OF_INTERFACE = _descriptor(
    INTERFACE,
    number=Int8ul,
    alternative=Int8ul,
    endpoints=Int8ul,
    interface_class=Int8ul,
    subclass=Int8ul,
    protocol=Int8ul,
    name=Int8ul,
)
OF_HID = _descriptor(HID, version=Int16ul, country=Int8ul, descriptors=Int8ul, kind_of_it=Int8ul, size=Int16ul)
OF_ENDPOINT = _descriptor(ENDPOINT, address=Int8ul, attributes=Int8ul, size=Int16ul, interval=Int8ul)

CONFIGURATION_SIZE: int = OF_CONFIGURATION.sizeof()
"""Bytes of a configuration's descriptor without those inside it, for which a host asks first."""

_COUNT = MAX_FRAME.to_bytes(2, "little")
REPORT = (
    bytes.fromhex("06 00 FF 09 01 A1 01 15 00 26 FF 00 75 08")  # of the vendor's own: bytes 0 to 255,
    + b"\x96"
    + _COUNT
    + bytes.fromhex("09 01 81 02")  # so many of them to the host,
    + b"\x96"
    + _COUNT
    + bytes.fromhex("09 01 91 02 C0")  # and as many from it
)
"""What the brick says of its reports."""


def device(product: int = USB_PRODUCT) -> bytes:
    """The descriptor of a brick; `product` is another one while its firmware is updated."""
    fields = {
        "usb": 0x0200,
        "device_class": 0,
        "subclass": 0,
        "protocol": 0,
        "packet_size": 64,
        "vendor": USB_VENDOR,
        "product": product,
        "version": 0x0100,
        "maker_name": 1,
        "product_name": 2,
        "serial_number": 3,
        "configurations": 1,
    }
    return bytes(OF_DEVICE.build(fields))


def configuration() -> bytes:
    """The descriptor of its only configuration, with those inside it: a HID interface with an endpoint each way."""
    interface = {"number": 0, "alternative": 0, "endpoints": 2, "interface_class": 3}
    hid = {"version": 0x0110, "country": 0, "descriptors": 1, "kind_of_it": HID_REPORT, "size": len(REPORT)}
    endpoint = {"attributes": 3, "size": MAX_FRAME, "interval": 4}
    pieces = (
        OF_INTERFACE.build(interface | {"subclass": 0, "protocol": 0, "name": 0}),
        OF_HID.build(hid),
        OF_ENDPOINT.build(endpoint | {"address": USB_ENDPOINT_IN}),
        OF_ENDPOINT.build(endpoint | {"address": USB_ENDPOINT_OUT}),
    )
    inside = b"".join(pieces)
    head = {"total": CONFIGURATION_SIZE + len(inside), "interfaces": 1, "number": 1, "name": 0}
    return bytes(OF_CONFIGURATION.build(head | {"attributes": 0xC0, "power": 1})) + inside


def string(text: str) -> bytes:
    """The descriptor of a text."""
    data = text.encode("utf-16-le")
    return bytes((2 + len(data), STRING)) + data
