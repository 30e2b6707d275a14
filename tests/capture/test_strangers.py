"""Traffic of other programs on the ports, channels and devices of bricks is ignored by every reader."""

from __future__ import annotations

import io
import random
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from functools import cache

import pytest
from support.effort import effort
from support.messages import tone, voltage, volts
from support.packets import (
    HCI_WITH_DIRECTION,
    HOST,
    RAW_IP,
    SYN,
    USBMON,
    Capture,
    Connection,
    Device,
    SerialPort,
    datagram,
    over,
    segment,
)
from support.packets import cut as snapped
from support.strangers import (
    Said,
    cards,
    database,
    debug_bridge,
    encrypted,
    log_sink,
    modbus,
    moves,
    numbered,
    nxt,
    object_exchange,
    opcodes,
    padded,
    pieces,
    reports,
    similar_beacons,
    torrent,
    tuner,
)
from support.wireshark import Tshark

import ev3proto
from ev3proto.capture import Announcement, Record, read

UNLOCK = ev3proto.Unlock("06165300000a").build()
BEACON = ev3proto.Beacon("06165300000a", name="myEV3").build()
REPORTS = 3000


Stranger = Callable[[random.Random], Iterator[Said]]


def over_tcp(capture: Capture, stranger: Stranger, number: int) -> None:
    """The same on several connections."""
    for each in range(effort(8, 20)):
        ends = HOST, bytes((192, 0, 2, 100 + number))
        over(capture, Connection(capture, 10_000 + 100 * number + each, ends=ends), stranger(random.Random(each)))


def over_bluetooth(capture: Capture, stranger: Stranger, number: int) -> None:
    over(capture, SerialPort(capture, connection=0x00B + number), stranger(random.Random(1)))


def over_udp(capture: Capture, stranger: Stranger, number: int) -> None:
    rng = random.Random(1)
    for from_host, data in stranger(rng):
        port, other = 3015 + number, 6881 + number
        ports = (port, other) if from_host else (other, port)
        capture.add(datagram(data, port=ports[0], target_port=ports[1]))
        capture.add(datagram(rng.randbytes(50)))


def over_usb(capture: Capture, stranger: Stranger, number: int) -> None:
    over(capture, Device(capture, 7 + number), stranger(random.Random(1)))


STRANGERS: dict[str, tuple[int, Callable[[Capture, Stranger, int], None], tuple[Stranger, ...]]] = {
    "tcp": (
        RAW_IP,
        over_tcp,
        (debug_bridge, encrypted, numbered, padded, nxt, database, pieces, opcodes, log_sink),
    ),
    "udp": (RAW_IP, over_udp, (torrent, similar_beacons)),
    "bluetooth": (
        HCI_WITH_DIRECTION,
        over_bluetooth,
        (object_exchange, nxt, modbus, database, cards, moves, opcodes, tuner),
    ),
    "usb": (USBMON, over_usb, (lambda rng: reports(rng, REPORTS),)),
}
"""By carrier: the capture's link, and what is said over it."""

MOST = 0.01
"""This number of other programs' packets may be taken for ours; but of real programs', none."""

REAL = (log_sink, tuner)
"""Traffic that was once taken for ours, made anew."""


@cache
def strangers(carrier: str) -> tuple[bytes, dict[Stranger, range]]:
    """A capture of all strangers on a carrier, each with an end of its own, and the packets of each."""
    link, add, programs = STRANGERS[carrier]
    capture, packets = Capture(link), {}
    for number, stranger in enumerate(programs):
        first = capture.count + 1
        add(capture, stranger, number)
        packets[stranger] = range(first, capture.count + 1)
    return capture.data(), packets


def assert_few(carrier: str, taken: Iterable[int]) -> None:
    """Fails if more packets of a stranger are taken for ours than may be."""
    numbers = Counter(taken)
    for stranger, packets in strangers(carrier)[1].items():
        most = 0 if stranger in REAL else MOST * len(packets)
        found = {number: count for number, count in numbers.items() if number in packets}
        assert sum(found.values()) <= most, (stranger.__name__, found)


def taken_by(tshark: Tshark, data: bytes, filter_: str) -> list[int]:
    path = tshark.place(data, "strangers.pcap")
    return [int(line) for line in tshark.run(path, "-Y", filter_, "-T", "fields", "-e", "frame.number").split()]


@pytest.mark.parametrize("carrier", STRANGERS)
def test_strangers_are_left_to_wireshark(tshark: Tshark, carrier: str) -> None:
    assert_few(carrier, taken_by(tshark, strangers(carrier)[0], "ev3"))


@pytest.mark.parametrize("carrier", STRANGERS)
def test_strangers_are_left_to_others_by_the_built_in_reader(carrier: str) -> None:
    events = read(io.BytesIO(strangers(carrier)[0])).events()
    assert_few(carrier, (event.numbers[-1] if isinstance(event, Announcement) else event.number for event in events))


@pytest.mark.parametrize("carrier", STRANGERS)
def test_strangers_are_left_to_others_where_only_the_beginnings_of_packets_were_captured(carrier: str) -> None:
    for size in (45, 48, 54, 68, 96):
        found = read(io.BytesIO(snapped(strangers(carrier)[0], size))).events()
        assert_few(carrier, (event.number for event in found if isinstance(event, Record)))


@pytest.mark.parametrize("carrier", STRANGERS)
def test_the_dissector_leaves_them_where_only_the_beginnings_of_packets_were_captured(
    tshark: Tshark, carrier: str
) -> None:
    for size in (45, 80):
        # The first label of a beacon may be all that was captured.
        assert_few(carrier, taken_by(tshark, snapped(strangers(carrier)[0], size), "ev3 && !udp"))


@pytest.mark.parametrize(("stranger", "expected"), [("adb", "data"), ("tls", "tls")])
def test_wireshark_shows_strangers_on_port_5555_as_without_us(tshark: Tshark, stranger: str, expected: str) -> None:
    capture = Capture(RAW_IP)
    over_tcp(capture, {"adb": debug_bridge, "tls": encrypted}[stranger], 0)
    path = tshark.place(capture.data(), "strangers.pcap")
    words = ("-T", "fields", "-e", "frame.number", "-e", "frame.protocols", "-e", "_ws.col.Info")
    alone = tshark.run(path, *words, dissector=False)
    assert f"tcp:{expected}\t" in alone
    assert tshark.run(path, *words) == alone


def swapped(stranger: Callable[[random.Random], Iterator[Said]], rng: random.Random) -> Iterator[Said]:
    """The same with both sides exchanged."""
    return ((not from_host, data) for from_host, data in stranger(rng))


def cut(said: Iterator[Said], rng: random.Random, size: int) -> Iterator[Said]:
    """The same in small pieces, from some place on."""
    for from_host, data in list(said)[rng.randrange(8) :]:
        at = 0
        while at < len(data):
            stop = at + rng.randint(1, size)
            yield from_host, data[at:stop]
            at = stop


def ours(rng: random.Random) -> Iterator[Said]:
    for number in range(rng.randrange(30), 40):
        if rng.random() < 0.5:
            yield True, tone(number)
        else:
            yield True, voltage(number)
            yield False, volts(number)


def everybody() -> bytes:
    """Other programs and ours, each on their own connections, complete and in pieces."""
    capture, port = Capture(RAW_IP), 20_000
    for who in (debug_bridge, encrypted, numbered, padded, database, modbus, object_exchange, torrent, ours):
        for seed in range(9):
            rng = random.Random(seed)
            said = who(rng) if seed % 3 else swapped(who, rng)
            port += 1
            connection = Connection(capture, port)
            if seed % 2:
                capture.add(segment(True, 0, flags=SYN, port=port))
                capture.add(segment(False, 0, acknowledged=1, flags=SYN, port=port))
            over(capture, connection, said if seed % 4 else cut(said, rng, 40))
    return capture.data()


def test_the_dissector_and_the_built_in_reader_take_the_same_messages(tshark: Tshark) -> None:
    data = everybody()
    path = tshark.place(data, "everybody.pcap")
    words = ("-Y", "ev3.msg_num", "-T", "fields", "-e", "frame.number", "-e", "ev3.msg_num")
    shown = []
    for line in tshark.run(path, *words).splitlines():
        number, counters = line.split("\t")
        shown += [(int(number), int(counter)) for counter in counters.split(",")]
    records = [event for event in read(io.BytesIO(data)).events() if isinstance(event, Record)]
    assert sorted((record.numbers[-1], record.message.counter) for record in records) == sorted(shown)


# Our own traffic is found nevertheless


@pytest.fixture
def shown(tshark: Tshark) -> Callable[..., list[str]]:
    def ask(capture: Capture, *words: str) -> list[str]:
        path = tshark.place(capture.data(), "ours.pcap")
        return tshark.run(path, "-Y", "ev3", "-T", "fields", "-e", "frame.number", *words).splitlines()

    return ask


def test_a_connection_is_claimed_by_its_first_plausible_command(shown: Callable[..., list[str]]) -> None:
    """A capture may begin inside a frame."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(tone(1)[3:])
    connection.receive(tone(1))
    ours = [connection.send(tone(2)), connection.send(bytes.fromhex("0500 0100 77 01 02"))]
    late = Connection(capture, 10_000)
    for _ in range(8):
        late.send(b"something else")
    ours.append(late.send(tone(3)))
    assert shown(capture) == [str(number) for number in ours]
    assert shown(capture, "-2") == [str(number) for number in ours]


def test_strange_packets_count_once_where_the_connection_begins(shown: Callable[..., list[str]]) -> None:
    """Wireshark then knows which end is the server, and passes data to other dissectors twice."""
    capture = Capture(RAW_IP)
    capture.add(segment(True, 0, flags=SYN))
    capture.add(segment(False, 0, acknowledged=1, flags=SYN))
    connection = Connection(capture)
    for _ in range(7):
        connection.send(b"something else")
    ours = connection.send(tone(1))
    assert shown(capture) == [str(ours)]


def test_what_is_left_of_a_frame_and_looks_like_another_hides_nothing() -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    connection.send(bytes.fromhex("0002 68b3 00 036c"))
    ours = [connection.send(tone(2)), connection.receive(volts(3))]
    taken = [event.numbers[0] for event in read(io.BytesIO(capture.data())).events() if isinstance(event, Record)]
    assert taken == ours


def test_what_follows_a_telling_frame_does_not_hide_it(shown: Callable[..., list[str]]) -> None:
    capture = Capture(RAW_IP)
    ours = Connection(capture).send(tone(1) + b"something else")
    assert shown(capture) == [str(ours)]
    taken = [event.numbers[0] for event in read(io.BytesIO(capture.data())).events() if isinstance(event, Record)]
    assert taken == [ours]


def test_the_unlock_text_on_any_port_may_come_in_two_segments(shown: Callable[..., list[str]]) -> None:
    """Split at each place after which it can be recognised; the same beginning of another text is ignored."""
    capture = Capture(RAW_IP)
    ours = []
    for at in range(17, len(UNLOCK), 5):
        connection = Connection(capture, 10_000 + at, brick_port=7001)
        connection.send(UNLOCK[:at])
        ours += [connection.send(UNLOCK[at:]), connection.send(voltage(1)), connection.receive(volts(1))]
    other = Connection(capture, brick_port=7001)
    for piece in (b"GET /target?sn=1", b" HTTP/1.1\r\nHost: a\r\n\r\n", voltage(1)):
        other.send(piece)
    assert set(map(str, ours)) <= set(shown(capture))
    assert int(shown(capture)[-1]) == ours[-1]


def test_the_unlock_text_on_a_port_of_another_dissector(shown: Callable[..., list[str]]) -> None:
    """Wireshark asks that dissector first, unless a preference of TCP says otherwise."""
    capture = Capture(RAW_IP)
    connection = Connection(capture, brick_port=8080)
    packets = [connection.send(UNLOCK), connection.send(voltage(1)), connection.receive(volts(1))]
    assert shown(capture, "-o", "tcp.try_heuristic_first:TRUE") == [str(number) for number in packets]


def test_a_beacon_names_a_port(shown: Callable[..., list[str]]) -> None:
    """6000 belongs to X11, whose dissector is asked first unless the user prefers heuristics."""
    for port, words in ((16_000, ()), (6000, ("-o", "tcp.try_heuristic_first:TRUE"))):
        capture = Capture(RAW_IP)
        Connection(capture, 10_000, brick_port=port).send(tone(1))
        beacon = capture.add(datagram(BEACON.replace(b"5555", str(port).encode())))
        connection = Connection(capture, brick_port=port)
        packets = [beacon, connection.send(tone(2)), connection.send(tone(3))]
        assert shown(capture, *words) == [str(number) for number in packets]


def test_decode_as_takes_everything_on_a_port_that_a_beacon_names(shown: Callable[..., list[str]]) -> None:
    """The beacon is from one brick; the port on another machine is ours because the user set it."""
    capture = Capture(RAW_IP)
    beacon = capture.add(datagram(BEACON.replace(b"5555", b"6000"), source=bytes((192, 0, 2, 11))))
    sent = Connection(capture, brick_port=6000).send(b"something else")
    assert shown(capture) == [str(beacon)]
    assert shown(capture, "-d", "tcp.port==6000,ev3") == [str(beacon), str(sent)]


def test_a_port_that_a_beacon_names_stays_with_its_dissector(tshark: Tshark) -> None:
    """Names are looked up over TCP on port 53, at other addresses than the brick's, in one packet and in two."""
    question = bytes.fromhex("0018 0007 0100 0001 0000 0000 0000 03 616263 02 6465 00 0001 0001".replace(" ", ""))
    capture = Capture(RAW_IP)
    capture.add(datagram(BEACON.replace(b"5555", b"53")))
    for number in (11, 12):
        connection = Connection(capture, brick_port=53, ends=(HOST, bytes((192, 0, 2, number))))
        for piece in (question, question[:9], question[9:]):
            connection.send(piece)
    path = tshark.place(capture.data(), "names.pcap")
    for words in ([], ["-2"]):
        asked = tshark.run(path, *words, "-Y", "dns", "-T", "fields", "-e", "dns.qry.name").split()
        assert asked == ["abc.de"] * 4


def test_a_reply_on_usb_answers_a_command(shown: Callable[..., list[str]]) -> None:
    capture = Capture(USBMON)
    device = Device(capture)
    device.receive(volts(1))
    ours = [device.send(voltage(1)), device.receive(volts(1))]
    device.receive(bytes.fromhex("FFFF"))
    faulty = device.send(bytes.fromhex("0500 0100 77 01 02"))
    assert shown(capture) == [str(number) for number in ours]
    device.send(bytes.fromhex("0700 0100 80 0000 94 01"))
    assert shown(capture) == [str(number) for number in (*ours, faulty + 1)]


def test_after_the_unlock_text_nothing_ends_a_claim(shown: Callable[..., list[str]]) -> None:
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    unlocked = connection.send(UNLOCK)
    strange = [connection.send(b"\xff" * 20) for _ in range(9)]
    ours = [connection.send(tone(6)), connection.send(bytes.fromhex("0700 0100 80 0000 94 77"))]
    assert shown(capture) == [str(number) for number in (unlocked, *strange, *ours)]
    taken = [event.numbers[0] for event in read(io.BytesIO(capture.data())).events() if isinstance(event, Record)]
    assert taken == ours
