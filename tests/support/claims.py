"""Dialogues that show when a claim begins and ends, on every carrier; and dialogues of commands with a mistake."""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import NamedTuple

from ev3proto.capture.claims import State
from support.messages import tone
from support.packets import HCI_WITH_DIRECTION, RAW_IP, USBMON, Capture, Connection, Device, SerialPort

CARRIERS = {"tcp": RAW_IP, "rfcomm": HCI_WITH_DIRECTION, "usb": USBMON}

Way = Connection | SerialPort | Device


def way(carrier: str, capture: Capture, number: int) -> Way:
    """A new conversation on a carrier."""
    if carrier == "tcp":
        return Connection(capture, 10_000 + number)
    if carrier == "rfcomm":
        return SerialPort(capture, connection=number + 1, address=bytes((number + 1, 0, 0, 0x53, 0x16, 0)))
    return Device(capture, number + 1)


def direct(counter: int, operations: str, memory: int = 0, kind: int = 0x00) -> bytes:
    body = bytes.fromhex(operations)
    return struct.pack("<HHBH", 5 + len(body), counter, kind, memory) + body


def system(counter: int, body: str) -> bytes:
    return struct.pack("<HHB", 3 + len(bytes.fromhex(body)), counter, 0x01) + bytes.fromhex(body)


def reply(counter: int, size: int = 0, kind: int = 0x02) -> bytes:
    return struct.pack("<HHB", 3 + size, counter, kind) + bytes(range(size))


def error(counter: int, size: int = 0) -> bytes:
    return reply(counter, size, 0x04)


def system_reply(counter: int, body: str, kind: int = 0x05) -> bytes:
    return struct.pack("<HHB", 3 + len(bytes.fromhex(body)), counter, kind) + bytes.fromhex(body)


# Mistakes

Mistake = tuple[Callable[[int], bytes], Callable[[int], bytes]]
"""A command and the reply to it, by their counter."""

MISTAKES: dict[str, Mistake] = {
    "a volume of 300": (lambda n: direct(n, "94 01 82 2C01 82 B801 82 E803"), reply),
    "an output without memory": (lambda n: direct(n, "81 01 60"), error),
    "ports as 16": (lambda n: direct(n, "A5 00 10 32"), reply),
    "a missing argument": (lambda n: direct(n, "94 01 01 82 B801"), error),
    "a text for a number": (lambda n: direct(n, "A5 00 01 84 66617374 00"), error),
    "layer 4": (lambda n: direct(n, "A5 04 01 32"), reply),
    "an unknown opcode": (lambda n: direct(n, "77 01 01"), error),
    "an unknown CMD": (lambda n: direct(n, "94 09 01 02"), error),
    "an output beyond the memory": (lambda n: direct(n, "81 01 68", 4), error),
    "a constant for an output": (lambda n: direct(n, "81 01 00", 4), lambda n: error(n, 4)),
    "a text without its end": (lambda n: direct(n, "D4 08 84 6D794556"), error),
    "a number for a text": (lambda n: direct(n, "C0 01 01 60", 2), error),
    "a raw byte": (lambda n: direct(n, "94 01 64 82 B801 82 E803"), reply),
    "swapped bytes of the memory": (lambda n: direct(n, "81 01 60", 0x0400), reply),
    "no operation": (lambda n: direct(n, ""), reply),
    "an unknown system command": (lambda n: system(n, "77"), lambda n: system_reply(n, "77 02")),
    "bytes behind a system command": (lambda n: system(n, "9D 01 02"), lambda n: system_reply(n, "9D 00", 0x03)),
}
"""By what is wrong. The capture begins after the connection, so only the reply shows that the command is a brick's."""


# When claims begin and end

OPEN, CLAIMED, ANSWERED, ENDED = State.OPEN, State.CLAIMED, State.ANSWERED, State.ENDED
TO_BRICK, FROM_BRICK = True, False

OURS, LATER, OTHER = "ours", "later", "other"
"""Whether messages of a packet are shown: at once; when the reply came (in two passes, or by our reader); never."""


class Step(NamedTuple):
    """A packet.

    to_brick  its direction
    data      its bytes
    state     the state of the conversation after it
    shown     OURS, LATER or OTHER
    """

    to_brick: bool
    data: bytes
    state: State
    shown: str


def asking(counter: int) -> bytes:
    """A faulty command that requests four bytes."""
    return direct(counter, "77 01 02", 4)


FAULTY = direct(1, "94 77", kind=0x80)
STRANGE = b"\xff" * 20
MUCH_STRANGE = b"\xff" * 300

STEPS: dict[str, list[Step]] = {
    "a plausible command": [
        Step(TO_BRICK, FAULTY, OPEN, OTHER),
        Step(TO_BRICK, tone(1), CLAIMED, OURS),
        Step(TO_BRICK, FAULTY, CLAIMED, OURS),
        Step(TO_BRICK, STRANGE, CLAIMED, OTHER),
        Step(TO_BRICK, tone(2), CLAIMED, OURS),
        Step(TO_BRICK, FAULTY, CLAIMED, OURS),
        Step(FROM_BRICK, STRANGE, CLAIMED, OTHER),
        Step(TO_BRICK, FAULTY, ENDED, OURS),
        Step(TO_BRICK, FAULTY, ENDED, OTHER),
        Step(TO_BRICK, tone(3), CLAIMED, OURS),
    ],
    "a reply to a plausible command": [
        Step(TO_BRICK, direct(1, "81 01 60", 4), CLAIMED, OURS),
        Step(FROM_BRICK, reply(1, 4), ANSWERED, OURS),
        *[Step(TO_BRICK, FAULTY, ANSWERED, OURS)] * 5,
    ],
    "other data after a reply": [
        Step(TO_BRICK, direct(1, "81 01 60", 4), CLAIMED, OURS),
        Step(FROM_BRICK, reply(1, 4), ANSWERED, OURS),
        *[Step(TO_BRICK, MUCH_STRANGE, ANSWERED, OTHER)] * 3,
        Step(TO_BRICK, tone(5), ANSWERED, OURS),
        *[Step(TO_BRICK, MUCH_STRANGE, ANSWERED, OTHER)] * 3,
        Step(TO_BRICK, MUCH_STRANGE, ENDED, OTHER),
        Step(TO_BRICK, FAULTY, ENDED, OTHER),
        Step(FROM_BRICK, reply(5, 4), ENDED, OTHER),
    ],
    "a reply to a faulty command": [
        Step(TO_BRICK, asking(1), OPEN, LATER),
        Step(FROM_BRICK, reply(1, 4), ANSWERED, OURS),
        *[Step(TO_BRICK, FAULTY, ANSWERED, OURS)] * 5,
    ],
    "an error": [Step(TO_BRICK, asking(1), OPEN, LATER), Step(FROM_BRICK, error(1), ANSWERED, OURS)],
    "an error with the memory": [Step(TO_BRICK, asking(1), OPEN, LATER), Step(FROM_BRICK, error(1, 4), ANSWERED, OURS)],
    "a system reply": [
        Step(TO_BRICK, system(1, "77"), OPEN, LATER),
        Step(FROM_BRICK, system_reply(1, "77 02"), ANSWERED, OURS),
    ],
    "another counter": [Step(TO_BRICK, asking(1), OPEN, OTHER), Step(FROM_BRICK, error(2), OPEN, OTHER)],
    "another length": [Step(TO_BRICK, asking(1), OPEN, OTHER), Step(FROM_BRICK, reply(1, 3), OPEN, OTHER)],
    "another kind": [Step(TO_BRICK, asking(1), OPEN, OTHER), Step(FROM_BRICK, system_reply(1, "77 02"), OPEN, OTHER)],
    "another system command": [
        Step(TO_BRICK, system(1, "77"), OPEN, OTHER),
        Step(FROM_BRICK, system_reply(1, "78 02"), OPEN, OTHER),
    ],
    "no reply requested": [
        Step(TO_BRICK, direct(1, "77 01 02", kind=0x80), OPEN, OTHER),
        Step(FROM_BRICK, error(1), OPEN, OTHER),
    ],
    "four packets wait": [
        Step(TO_BRICK, asking(1), OPEN, OTHER),
        Step(TO_BRICK, asking(2), OPEN, LATER),
        *[Step(TO_BRICK, asking(counter), OPEN, LATER) for counter in (3, 4, 5)],
        Step(FROM_BRICK, error(1), OPEN, OTHER),
        Step(FROM_BRICK, error(2), ANSWERED, OURS),
        Step(FROM_BRICK, error(3), ANSWERED, OURS),
    ],
    "the reply to a later command": [
        Step(TO_BRICK, asking(1), OPEN, OTHER),
        Step(TO_BRICK, asking(2), OPEN, LATER),
        Step(FROM_BRICK, error(2), ANSWERED, OURS),
    ],
}
"""On every carrier."""

STREAM_STEPS: dict[str, list[Step]] = {
    "commands in one packet": [
        Step(TO_BRICK, asking(1) + asking(2), OPEN, LATER),
        Step(FROM_BRICK, error(2), ANSWERED, OURS),
    ],
    "replies in one packet": [
        Step(TO_BRICK, asking(1), OPEN, LATER),
        Step(TO_BRICK, asking(2), OPEN, LATER),
        Step(FROM_BRICK, reply(1, 4) + reply(2, 4), ANSWERED, OURS),
    ],
    "other bytes behind a faulty command": [
        Step(TO_BRICK, asking(1) + b"\xff\xff", OPEN, OTHER),
        Step(FROM_BRICK, error(1), OPEN, OTHER),
    ],
    "a plausible command inside a packet": [
        Step(TO_BRICK, STRANGE + tone(1), OPEN, OTHER),
        Step(TO_BRICK, STRANGE + tone(1) + tone(2)[:2], CLAIMED, OURS),
    ],
    "anywhere after a claim": [
        Step(TO_BRICK, tone(1), CLAIMED, OURS),
        *[Step(TO_BRICK, STRANGE, CLAIMED, OTHER)] * 2,
        Step(TO_BRICK, STRANGE, ENDED, OTHER),
        Step(TO_BRICK, b"\xfe" * 9 + tone(2), CLAIMED, OURS),
    ],
}
"""Where packets are pieces of a stream."""

TCP_STEPS: dict[str, list[Step]] = {
    "two replies in a row": [
        Step(FROM_BRICK, reply(1, 4), OPEN, OTHER),
        Step(FROM_BRICK, STRANGE, OPEN, OTHER),
        Step(FROM_BRICK, reply(2, 4), OPEN, OTHER),
        Step(FROM_BRICK, reply(3, 4), CLAIMED, OURS),
    ],
}
"""On TCP, whose ports tell the direction."""

OTHER_STEPS: dict[str, list[Step]] = {
    "replies without a command": [
        *[Step(FROM_BRICK, reply(counter, 4), OPEN, OTHER) for counter in (6, 7)],
        Step(TO_BRICK, FAULTY, OPEN, OTHER),
        Step(TO_BRICK, tone(6), CLAIMED, OURS),
    ],
}
"""On the others."""

ALL_STEPS = {
    "tcp": STEPS | STREAM_STEPS | TCP_STEPS,
    "rfcomm": STEPS | STREAM_STEPS | OTHER_STEPS,
    "usb": STEPS | OTHER_STEPS,
}
