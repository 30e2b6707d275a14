"""Claims: one table of dialogues for the state machine, and for both readers of captures on every carrier."""

from __future__ import annotations

import io
import random
from collections.abc import Iterable

import pytest
from support.claims import (
    ALL_STEPS,
    CARRIERS,
    LATER,
    MISTAKES,
    OTHER,
    TO_BRICK,
    Step,
    asking,
    direct,
    error,
    reply,
    way,
)
from support.packets import RAW_IP, USBMON, Capture, Connection, Device, cut
from support.reading import records
from support.strangers import checked_modbus
from support.wireshark import Tshark

from ev3proto.capture import Record, read
from ev3proto.capture.claims import Claim, State
from ev3proto.capture.conversation import Conversation
from ev3proto.capture.finding import Finder
from ev3proto.capture.record import Direction, Route
from ev3proto.schema.frame import frame_reader
from ev3proto.tables.carriers import Carrier

SCHEMA = frame_reader("official")
ROUTE = Route(Carrier.WIFI, "a", "b", Direction.SENT, None, "b")


def states(carrier: str, steps: Iterable[Step]) -> list[State]:
    """The states of a claim that gets these packets, without a reader of captures."""
    claim = Claim(SCHEMA, lambda member: member.is_command, TO_BRICK if carrier == "tcp" else None)
    conversation, finder = Conversation(SCHEMA), Finder(SCHEMA)
    found: list[State] = []
    for number, step in enumerate(steps):
        place = 0
        if not claim.is_claimed:
            _, place, _ = claim.judge(step.to_brick, step.data, lambda _: list)
        frames = finder.frames_of(step.data, place)
        if claim.is_claimed:
            unread = len(step.data) - place - sum(map(len, frames))
            claim.count([conversation.record(frame, (number,), number, ROUTE) for frame in frames], unread)
        found.append(claim.state)
    return found


@pytest.mark.parametrize(("carrier", "name"), [(carrier, name) for carrier, each in ALL_STEPS.items() for name in each])
def test_the_state_after_each_packet(carrier: str, name: str) -> None:
    steps = ALL_STEPS[carrier][name]
    assert states(carrier, steps) == [step.state for step in steps]


def captured(carrier: str) -> tuple[bytes, dict[int, str]]:
    """All dialogues of the table over a carrier, and whether the packet of each number is shown."""
    capture, shown = Capture(CARRIERS[carrier]), {}
    for number, steps in enumerate(ALL_STEPS[carrier].values()):
        conversation = way(carrier, capture, number)
        for step in steps:
            shown[(conversation.send if step.to_brick else conversation.receive)(step.data)] = step.shown
    return capture.data(), shown


def read_by_us(data: bytes) -> list[int]:
    """The packets with messages, by the built-in reader."""
    return sorted({record.numbers[-1] for record in records(data)})


def dissected(tshark: Tshark, data: bytes, *words: str) -> list[int]:
    """The same by the dissector."""
    path = tshark.place(data, "claims.pcap")
    return [
        int(line)
        for line in tshark.run(path, "-Y", "ev3.msg_num", "-T", "fields", "-e", "frame.number", *words).split()
    ]


@pytest.mark.parametrize("carrier", CARRIERS)
def test_the_built_in_reader_shows_what_is_claimed(carrier: str) -> None:
    data, shown = captured(carrier)
    assert read_by_us(data) == [number for number, when in shown.items() if when != OTHER]


@pytest.mark.parametrize("carrier", CARRIERS)
def test_the_dissector_shows_what_is_claimed(carrier: str, tshark: Tshark) -> None:
    data, shown = captured(carrier)
    assert dissected(tshark, data) == [number for number, when in shown.items() if when not in (LATER, OTHER)]
    assert dissected(tshark, data, "-2") == [number for number, when in shown.items() if when != OTHER]


# Mistakes, which are what people capture

ROUNDS = 5


def mistakes(carrier: str, *, are_answered: bool = True) -> Capture:
    """Dialogues of commands that have one mistake each."""
    capture = Capture(CARRIERS[carrier])
    for number, (command, answer) in enumerate(MISTAKES.values()):
        conversation = way(carrier, capture, number)
        for counter in range(100, 100 + ROUNDS):
            conversation.send(command(counter))
            if are_answered:
                conversation.receive(answer(counter))
    return capture


@pytest.mark.parametrize("carrier", CARRIERS)
def test_commands_with_mistakes_are_shown_with_their_replies(carrier: str, tshark: Tshark) -> None:
    data, count = mistakes(carrier).data(), 2 * ROUNDS * len(MISTAKES)
    records = [event for event in read(io.BytesIO(data)).events() if isinstance(event, Record)]
    assert len(records) == count
    assert sum(record.request is not None for record in records) == count // 2
    # In one pass the first command of each dialogue is not shown; its reply has it.
    assert len(dissected(tshark, data)) == count - len(MISTAKES)
    assert len(dissected(tshark, data, "-2")) == count
    path = tshark.place(data, "mistakes.pcap")
    for words in ((), ("-2",)):
        links = tshark.run(path, *words, "-Y", "ev3.request_in", "-T", "fields", "-e", "ev3.request_in").split()
        assert len(set(links)) == count // 2


# The user's word

CHOSEN: dict[str, list[tuple[str, ...]]] = {
    "tcp": [("-d", "tcp.port==5555,ev3_all"), ("-o", "ev3.tcp_ports:5555"), ("-o", "ev3.tcp_ports:5000-6000")],
    "rfcomm": [("-d", "btrfcomm.dlci==2,ev3_all")],
    "usb": [tuple(word for n in range(1, len(MISTAKES) + 1) for word in ("-d", f"usb.device==0x0001{n:04x},ev3_all"))],
}


@pytest.mark.parametrize("carrier", CARRIERS)
def test_the_dissector_shows_all_that_the_user_chose(carrier: str, tshark: Tshark) -> None:
    data, count = mistakes(carrier, are_answered=False).data(), ROUNDS * len(MISTAKES)
    assert dissected(tshark, data) == []
    for words in CHOSEN[carrier]:
        assert len(dissected(tshark, data, *words)) == len(dissected(tshark, data, "-2", *words)) == count


def test_decode_as_for_a_product(tshark: Tshark) -> None:
    capture = Capture(USBMON)
    device = Device(capture)
    device.enumerate(0x1234, 0x0001)
    sent = device.send(asking(1))
    assert dissected(tshark, capture.data()) == []
    assert dissected(tshark, capture.data(), "-d", "usb.product==0x12340001,ev3_all") == [sent]


@pytest.mark.parametrize("carrier", CARRIERS)
def test_the_built_in_reader_reads_everything_on_request(carrier: str) -> None:
    data, count = mistakes(carrier, are_answered=False).data(), ROUNDS * len(MISTAKES)
    assert read_by_us(data) == []
    assert len(list(read(io.BytesIO(data), everything=True))) == count
    assert len(list(read(io.BytesIO(data), ports=[5555]))) == (count if carrier == "tcp" else 0)


def test_everything_is_only_what_has_a_bricks_size() -> None:
    """A mouse and a stick are on the same bus."""
    capture = Capture(USBMON)
    for number, size in enumerate((8, 64), 20):
        Device(capture, number, size=size).receive(bytes.fromhex("0500 0100 02 0102"))
    sent = Device(capture).send(asking(1))
    found = [event.numbers for event in read(io.BytesIO(capture.data()), everything=True)]
    assert found == [(sent,)]


@pytest.mark.parametrize(
    ("carrier", "place"),
    [("tcp", "on TCP port 5555"), ("rfcomm", "on RFCOMM channel 1"), ("usb", "with a USB report of 1024 bytes")],
)
def test_packets_that_are_not_recognised_are_counted(carrier: str, place: str) -> None:
    capture = mistakes(carrier, are_answered=False)
    opened = read(io.BytesIO(capture.data()))
    assert list(opened.events()) == []
    assert opened.account.strange == {place: ROUNDS * len(MISTAKES)}


# Streams


def test_a_command_that_began_before_the_reply_is_not_lost(tshark: Tshark) -> None:
    """While its first half waits, the reply to an earlier one begins the claim."""
    for carrier in ("tcp", "rfcomm"):
        capture = Capture(CARRIERS[carrier])
        conversation = way(carrier, capture, 0)
        conversation.send(asking(1))
        voltage = direct(2, "81 01 60", 4)
        conversation.send(voltage[:6])
        conversation.receive(error(1))
        last = conversation.send(voltage[6:])
        conversation.receive(reply(2, 4))
        counters = [record.message.counter for record in read(io.BytesIO(capture.data()))]
        assert counters == [1, 1, 2, 2], carrier
        assert last in dissected(tshark, capture.data(), "-2"), carrier


def test_commands_cut_by_the_capture_are_proved_by_their_headers() -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    for counter in range(3):
        connection.send(asking(counter))
        connection.receive(error(counter))
    assert len(list(read(io.BytesIO(cut(capture.data(), 40 + 9))))) == 6


@pytest.mark.parametrize("carrier", ["tcp", "rfcomm"])
def test_a_machines_controller_is_not_taken_for_a_brick(carrier: str) -> None:
    """Inside its packets are lengths and opcodes such as NOP, and its replies repeat commands."""
    capture = Capture(CARRIERS[carrier])
    for seed in range(5):
        conversation = way(carrier, capture, seed)
        for from_host, data in checked_modbus(random.Random(seed)):
            (conversation.send if from_host else conversation.receive)(data)
    assert list(read(io.BytesIO(capture.data()))) == []


@pytest.mark.parametrize("carrier", ["tcp", "rfcomm"])
def test_a_reply_proves_the_newest_command_with_its_counter(carrier: str) -> None:
    """What came before is as likely something else: the brick answers each command before the next one is sent."""
    capture = Capture(CARRIERS[carrier])
    conversation = way(carrier, capture, 0)
    for volume in ("82 2C01", "82 9001"):
        conversation.send(direct(7, f"94 01 {volume} 82 B801 82 E803"))
    conversation.receive(reply(7))
    messages = [record.message for record in read(io.BytesIO(capture.data()))]
    assert [message.type.is_command for message in messages if message.type is not None] == [True, False]
    assert messages[0].operations[0].arguments[0].value == 400  # type: ignore[attr-defined]
