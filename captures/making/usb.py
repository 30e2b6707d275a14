"""USB: the reports of a brick on the bus, its enumeration, and other devices."""

from __future__ import annotations

import struct
import zlib
from functools import reduce
from operator import xor

from ev3proto import DaisyCommand, DaisyReply, MessageType, Operation, system_command
from ev3proto.generate.captures.usb import (
    CONFIGURATION,
    CONFIGURATION_SIZE,
    DEVICE_DESCRIPTOR,
    ENGLISH,
    GET_DESCRIPTOR,
    HID_REPORT,
    LANGUAGES,
    NAMES,
    REPORT,
    SET_CONFIGURATION,
    SET_IDLE,
    STRING,
    configuration,
    device,
    string,
)
from ev3proto.tables import daisy
from ev3proto.tables.carriers import USB_BOOTLOADER, USB_PRODUCT
from ev3proto.tables.carriers import USB_ENDPOINT_IN as IN
from ev3proto.tables.carriers import USB_ENDPOINT_OUT as OUT
from ev3proto.tables.enumerations import TYPE
from ev3proto.tables.frame import MAX_FRAME, REPORT_SIZES
from making import dialogue
from making.dialogue import IMAGE, Exchange, Host
from making.files import SECOND, Wire
from making.urbs import ESHUTDOWN, Linux, Urbs, Windows


class Brick:
    """The brick's reports. Both ends write each frame over the start of a buffer, which keeps older bytes after it."""

    def __init__(self, urbs: Urbs, size: int = MAX_FRAME) -> None:
        self.urbs = urbs
        self.sent = bytearray(size)
        self.received = bytearray(size)

    def send(self, frame: bytes) -> None:
        """The host sends a frame."""
        self.sent[: len(frame)] = frame
        self.urbs.wire.wait(2500)
        self.urbs.out(OUT, bytes(self.sent))

    def receive(self, frame: bytes) -> None:
        """The brick sends a frame, and the host asks for the next."""
        self.received[: len(frame)] = frame
        self.urbs.wire.wait(3100)
        self.urbs.heard(IN, bytes(self.received))
        self.urbs.wire.wait(30)
        self.listen()

    def listen(self) -> None:
        """The host waits for a report."""
        self.urbs.listen(IN)

    def exchange(self, pair: Exchange) -> None:
        """A command and its reply."""
        self.send(pair.command)
        self.receive(pair.reply)


# Enumeration


def enumerate_device(usb: Linux, product: int, names: tuple[str, str, str]) -> None:
    """Linux' requests to a brick that was plugged in: descriptors, names (maker, product, serial number), reports."""
    whole = configuration()
    usb.control(0x80, GET_DESCRIPTOR, DEVICE_DESCRIPTOR << 8, 0, 18, device(product))
    usb.control(0x80, GET_DESCRIPTOR, CONFIGURATION << 8, 0, CONFIGURATION_SIZE, whole)
    usb.control(0x80, GET_DESCRIPTOR, CONFIGURATION << 8, 0, len(whole), whole)
    usb.control(0x80, GET_DESCRIPTOR, STRING << 8, 0, 255, LANGUAGES)
    for index in (2, 1, 3):
        usb.control(0x80, GET_DESCRIPTOR, STRING << 8 | index, ENGLISH, 255, string(names[index - 1]))
    usb.control(0x00, SET_CONFIGURATION, 1, 0, 0)
    usb.control(0x21, SET_IDLE, 0, 0, 0)
    usb.control(0x81, GET_DESCRIPTOR, HID_REPORT << 8, 0, len(REPORT), REPORT)
    usb.wire.wait(SECOND)


# The captures


def plugged_in() -> Wire:
    """A brick is plugged in, then a program talks to it."""
    usb = Linux(Wire(), device=7)
    enumerate_device(usb, USB_PRODUCT, NAMES)
    brick, host = Brick(usb), Host()
    brick.listen()
    brick.exchange(dialogue.versions(host))
    brick.send(host.tell(dialogue.tone(), dialogue.light("LED_GREEN_FLASH")))
    brick.exchange(dialogue.sensors(host))
    brick.exchange(dialogue.gyro(host))
    brick.send(host.tell(*dialogue.start_motors()))
    brick.exchange(dialogue.motor_angles(host, 96, 95))
    brick.exchange(dialogue.misaligned(host))
    brick.send(host.tell(dialogue.stop_motors()))
    for pair in dialogue.download(host, "../prjs/log/first.rbf", IMAGE):
        brick.exchange(pair)
    brick.exchange(dialogue.illegal_download(host))
    brick.exchange(dialogue.voltage(host))
    return usb.wire


def among_others() -> Wire:
    """A brick, a mouse and a security key that were plugged in before; only the brick uses the protocol."""
    wire = Wire()
    usb = Linux(wire, device=7, mapped=False)
    mouse = Linux(wire, device=3, mapped=False, size=8)
    key = Linux(wire, device=5, mapped=False, size=64)
    brick, host = Brick(usb), Host(1000)
    movements = iter(MOUSE)

    def move(count: int) -> None:
        for _ in range(count):
            wire.wait(8000)
            mouse.heard(IN, next(movements))
            mouse.listen(IN)

    brick.exchange(dialogue.voltage(host))
    move(2)
    brick.send(host.tell(dialogue.light("LED_RED")))
    key.out(OUT, KEY_REQUEST.ljust(key.size, b"\0"))
    wire.wait(4000)
    key.heard(IN, KEY_ANSWER.ljust(key.size, b"\0"))
    key.listen(IN)
    move(2)
    brick.exchange(dialogue.touch(host, 100))
    for pair in dialogue.listing(host, "/home/root/lms2012/prjs/log/", 1000):
        brick.exchange(pair)
    move(1)
    key.out(OUT, KEY_PING.ljust(key.size, b"\0"))
    wire.wait(4000)
    key.heard(IN, KEY_PING.ljust(key.size, b"\0"))
    brick.exchange(dialogue.voltage(host, 7.88))
    return wire


MOUSE = (
    bytes.fromhex("00 00 02 00 FE FF 00 00"),
    bytes.fromhex("00 00 05 00 FB FF 00 00"),
    bytes.fromhex("03 00 01 00 00 00 00 00"),
    bytes.fromhex("03 00 FF FF 02 00 00 00"),
    bytes(8),
)
"""Buttons, movement, wheel. The fourth, with both buttons held, looks like a frame: a DIRECT_REPLY, counter 65535."""

KEY_REQUEST = bytes.fromhex("FF FF FF FF 86 00 08 11 22 33 44 55 66 77 88")
KEY_ANSWER = KEY_REQUEST.replace(b"\0\x08", b"\0\x11") + bytes.fromhex("0A 00 00 01 02 05 02 07 01")
"""A security key is asked for a channel; it gives 0A000001."""

KEY_PING = bytes.fromhex("0A 00 00 01 81 00 05 68 65 6C 6C 6F")
"""A message on that channel. Its start looks like a frame: length 10, type SYSTEM_COMMAND_NO_REPLY."""


def windows() -> Wire:
    """A short dialogue under Windows, with a brick that was plugged in before."""
    usb = Windows(Wire(), device=11, bus=2)
    brick, host = Brick(usb), Host(41)
    brick.listen()
    brick.exchange(dialogue.voltage(host))
    brick.send(host.tell(dialogue.tone(880)))
    brick.exchange(dialogue.sensors(host))
    brick.exchange(dialogue.misaligned(host))
    for pair in dialogue.upload(host, "../prjs/log/values.rtf", dialogue.CONTENTS, 900):
        brick.exchange(pair)
    return usb.wire


def bootloader() -> Wire:
    """A brick in its firmware updater: a new firmware, and one reply whose start is overwritten by the request."""
    usb = Linux(Wire(), device=8, bus=2)
    enumerate_device(usb, USB_BOOTLOADER, ("LEGO Group", "EV3 Firmware Update", "06165300000a"))
    brick, host = Brick(usb), Host(0)
    brick.listen()
    # The known fault, with the bytes seen on a real brick.
    request = system_command("GET_VERSION", counter=host.counter).build()
    brick.send(request)
    brick.receive(request + FAULTY_END)
    host.counter += 1
    # Asked again, it answers correctly.
    version: dict[str, int | str | bytes] = {"hardware_version": 0xB67F, "firmware_version": 0x0600}
    brick.exchange(host.system("GET_VERSION", version))
    brick.exchange(host.system("BEGIN_DOWNLOAD_WITH_ERASE", address=0, image_size=len(IMAGE)))
    for at in range(0, len(IMAGE), 1018):
        brick.exchange(host.system("DOWNLOAD_DATA", data=IMAGE[at : at + 1018]))
    brick.exchange(host.system("GET_CHECKSUM", {"checksum": zlib.crc32(IMAGE)}, address=0, image_size=len(IMAGE)))
    brick.exchange(host.system("START_APP"))
    # It disconnects, and returns as another device.
    usb.wire.wait(SECOND // 2)
    usb.heard(IN, b"", ESHUTDOWN)
    return usb.wire


FAULTY_END = bytes.fromhex("7F B6 00 00 00 06 00 00")
"""The bytes after the request in that reply."""


def chain() -> Wire:
    """Two bricks joined by USB, as the upper one sees it, in reports of 64 bytes."""
    usb = Linux(Wire(), device=2, size=REPORT_SIZES[0])
    lower = Brick(usb, usb.size)
    lower.listen()
    touch, tacho = TYPE.members["TYPE_TOUCH"], TYPE.members["TYPE_TACHO"]
    ask, tell = MessageType.DAISY_COMMAND_REPLY, MessageType.DAISY_COMMAND_NO_REPLY
    lower.send(down(ask, 1, daisy.DaisySubCommand.INFO))
    lower.receive(up(MessageType.DAISY_REPLY, 1, sensor_report(0, touch, b"\0")))
    lower.send(down(tell, 2, daisy.DaisySubCommand.SET_TYPE, bytes((1, 0, touch, 0))))
    lower.send(down(tell, 3, daisy.DaisySubCommand.DOWNSTREAM, *dialogue.start_motors()))
    lower.send(down(ask, 4, daisy.DaisySubCommand.DOWNSTREAM_WITH_BUSY, dialogue.stop_motors()))
    lower.receive(up(MessageType.DAISY_REPLY, 4, sensor_report(16, tacho, struct.pack("<i", 360))))
    lower.receive(up(tell, 5, sensor_report(0, touch, b"\x01")))
    lower.send(down(tell, 6, daisy.DaisySubCommand.UNLOCK_SLAVE))
    return usb.wire


def down(kind: MessageType, counter: int, number: daisy.DaisySubCommand, *parts: Operation | bytes) -> bytes:
    """A command for the lower brick."""
    payload = b"".join(part.raw if isinstance(part, Operation) else part for part in parts)
    message = DaisyCommand(type=kind, counter=counter, number=number, layer_from=0, layer_to=1, payload=payload)
    return message.build()


def up(kind: MessageType, counter: int, payload: bytes) -> bytes:
    """A reply of the lower brick, or its own message with sensor data."""
    if kind is MessageType.DAISY_REPLY:
        return DaisyReply(type=kind, counter=counter, layer_from=1, layer_to=0, payload=payload).build()
    number = daisy.DaisySubCommand.UPSTREAM
    message = DaisyCommand(type=kind, counter=counter, number=number, layer_from=1, layer_to=0, payload=payload)
    return message.build()


def sensor_report(port: int, kind: int, value: bytes) -> bytes:
    """A sensor of the lower brick. The algorithm of the checksum, exclusive or, is a guess."""
    data = bytes((1, port, 0, kind, 0)) + value.ljust(daisy.SENSOR_DATA_SIZE, b"\0")
    return data + bytes((reduce(xor, data),))
