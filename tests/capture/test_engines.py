"""Both engines held against each other: what ev3proto finds in a capture by itself, and what the real tshark finds.

They have nothing in common where carriers are taken apart. A tshark that runs inside a folder sees nothing else of
ours: captures and temporary files lie in the work folder of the fixture `tshark`.
"""

from __future__ import annotations

import asyncio
import gzip
import io
import random
import struct
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest
from support.packets import ACK, RAW_IP, SYN, Capture, Connection, SerialPort, cut, datagram, in_tunnels, segment
from support.wireshark import Tshark

from ev3proto.capture import Account, Announcement, CaptureError, Direction, Event, Record, Skipped, from_pyshark, read
from ev3proto.capture import Capture as Captured
from ev3proto.capture.formats import CaptureFile
from ev3proto.generate.dissector.build import build
from ev3proto.pyshark import read as read_by_tshark
from ev3proto.pyshark.program import Program

CAPTURES = Path(__file__).parents[2] / "captures"

EVENTS = {
    "bluetooth.log": 24,
    "bluetooth.pcapng": 13,
    "daisy.pcap": 8,
    "ev3_dc.pcap": 192,
    "usb-bootloader.pcapng": 16,
    "usb-plugged.pcap": 9,
    "usb-windows.pcap": 15,
    "usb.pcapng": 25,
    "wifi-reordered.pcap": 16,
    "wifi.pcapng": 47,
}
"""How many frames and texts each capture has."""

VOLTAGE = bytes.fromhex("0800010000 0400 810160")
"""A command that asks for the voltage of the battery."""

ANSWER = bytes.fromhex("0700010002 a470fd40")
TONE = bytes.fromhex("0e00020080 0000 94010582b80182fa00")
UNLOCK = b"GET /target?sn=06165300000a VMTP1.0\r\nProtocol: EV3\r\n\r\n"
ACCEPT = b"Accept:EV340\r\n\r\n\0"

Open = Callable[..., Captured]


ASKED: dict[tuple[str, ...], str] = {}
"""What the tshark of the tests has said of itself: always the same, and to ask it would be half of the time."""


@pytest.fixture
def opened(tshark: Tshark, monkeypatch: pytest.MonkeyPatch) -> Open:
    """Opens a capture, or the bytes of one, with the engine wireshark."""
    monkeypatch.setattr(tempfile, "tempdir", str(tshark.folder))
    ask = Program.ask

    def asked_once(program: Program, *words: str) -> str:
        assert program.path == str(tshark.path)
        if words not in ASKED:
            ASKED[words] = ask(program, *words)
        return ASKED[words]

    monkeypatch.setattr(Program, "ask", asked_once)

    def open_capture(source: Path | bytes, *, ports: tuple[int, ...] = (5555,), dialect: str = "official") -> Captured:
        path = tshark.place(source, "" if isinstance(source, Path) else f"{abs(hash(source)):x}.pcap")
        return read_by_tshark(path, tshark=str(tshark.path), ports=ports, dialect=dialect)

    return open_capture


def told(event: Event) -> tuple[object, ...]:
    """All that an event says."""
    place = (event.time_ns, event.route)
    if isinstance(event, Record):
        answers = None if event.request is None else event.request.numbers
        return ("frame", event.frame.hex(), event.numbers, answers, event.note, *place)
    if isinstance(event, Announcement):
        return (event.said, event.data, event.text, event.numbers, *place)
    return ("skipped", event.data, event.missing, event.number, *place)


def ended(captured: Captured) -> tuple[list[Event], str]:
    """All that a capture gives before it complains, and the complaint."""
    found: list[Event] = []
    try:
        found.extend(captured.events())  # what came before an error stays
    except CaptureError as error:
        return found, str(error)
    raise AssertionError("nobody complained")


def builtin(source: Path | bytes) -> Captured:
    return read(io.BytesIO(source) if isinstance(source, bytes) else source)


@pytest.mark.parametrize("name", EVENTS)
def test_both_find_the_same(opened: Open, name: str) -> None:
    ours, theirs = builtin(CAPTURES / name), opened(CAPTURES / name)
    found = [told(event) for event in theirs.events()]
    assert found == [told(event) for event in ours.events()]
    assert len(found) == EVENTS[name]
    assert theirs.account.packets == ours.account.packets
    assert theirs.account.frames == ours.account.frames
    assert theirs.account.texts == ours.account.texts
    assert theirs.account.padding == ours.account.padding
    assert (theirs.account.first_ns, theirs.account.last_ns) == (ours.account.first_ns, ours.account.last_ns)
    assert theirs.account.balance == 0


def test_a_frame_in_two_segments(opened: Open) -> None:
    records = {record.number: record for record in opened(CAPTURES / "wifi.pcapng")}
    asked = records[20]
    assert asked.frame.hex() == "0d000700000800b3000160b3000264"
    assert asked.numbers == (19, 20)
    assert asked.time_ns == 1_767_261_605_158_100_000
    assert (asked.carrier, asked.direction) == ("wifi", "sent")
    assert (asked.source, asked.target, asked.peer) == ("192.0.2.1:49152", "192.0.2.10:5555", "192.0.2.10:5555")
    assert asked.interface is None
    answer = records[23]
    assert answer.numbers == (21, 22, 23)
    assert answer.request is asked
    assert answer.latency == pytest.approx(0.0049)
    assert [(value.name, value.value) for value in answer.values] == [("TACHO", 421), ("TACHO", -17)]


def test_segments_in_the_wrong_order_are_named_in_the_order_of_their_bytes(opened: Open) -> None:
    records = {record.number: record for record in opened(CAPTURES / "wifi-reordered.pcap")}
    assert records[19].numbers == (16, 19, 17)
    assert records[22].numbers == (22, 21)


def test_usb(opened: Open) -> None:
    first, second, *_ = opened(CAPTURES / "usb-windows.pcap")
    assert (first.carrier, first.source, first.target, first.direction) == ("usb", "host", "2.11", "sent")
    assert (second.source, second.target, second.peer, second.direction) == ("2.11", "host", "2.11", "received")


def test_bluetooth(opened: Open) -> None:
    records = list(opened(CAPTURES / "bluetooth.log"))
    whole = next(record for record in records if record.number == 36)
    assert whole.numbers == (35, 36)
    assert (whole.carrier, whole.source, whole.target) == ("bluetooth", "host", "06:16:53:00:00:0a")
    nameless = next(iter(opened(CAPTURES / "bluetooth.pcapng")))
    assert (nameless.source, nameless.target, nameless.peer) == ("host", "handle 0x000b", "handle 0x000b")


def test_the_fault_of_the_bootloader_is_noted(opened: Open) -> None:
    notes = [record.note for record in opened(CAPTURES / "usb-bootloader.pcapng") if record.note]
    assert len(notes) == 1
    assert "fault of the EV3's bootloader" in notes[0]


# Streams as networks spoil them


def connection(capture: Capture, port: int, spoilt: str, chance: random.Random) -> list[bytes]:
    """A connection whose segments are cut anywhere, change places and come twice. Returns its frames, unsorted."""
    numbers = {True: 1000, False: 2**32 - 300}  # one of them starts again from 0 soon
    capture.add(segment(True, numbers[True] - 1, flags=SYN, port=port))
    capture.add(segment(False, numbers[False] - 1, acknowledged=numbers[True], flags=SYN, port=port))
    frames: dict[bool, list[bytes]] = {True: [], False: []}
    for counter in range(chance.randrange(3, 12)):
        frames[True].append(struct.pack("<HHBH", 8, counter, 0, 4) + VOLTAGE[-3:])
        memory = chance.randbytes(chance.choice((4, 4, 60, 900)))
        frames[False].append(struct.pack("<HHB", 3 + len(memory), counter, 2) + memory)
    left = {way: b"".join(frames[way]) for way in frames}
    starts = numbers.copy()
    for way, text in ((True, UNLOCK), (False, ACCEPT)):
        capture.add(segment(way, starts[way], text, acknowledged=starts[not way], port=port))
        starts[way] += len(text)
    while any(left.values()):
        way = chance.choice([way for way in left if left[way]])
        burst = []
        for _ in range(chance.choice((1, 1, 2, 3, 5))):
            size = chance.choice((1, 2, 3, 9, 10, 100, 700, 1448))
            if left[way]:
                burst.append((starts[way], left[way][:size]))
                starts[way] += len(left[way][:size])
                left[way] = left[way][size:]
        if "shuffled" in spoilt and chance.random() < 0.4:
            chance.shuffle(burst)
        if "repeated" in spoilt and chance.random() < 0.3:
            burst.append(chance.choice(burst))
        for start, data in burst:
            capture.add(segment(way, start, data, acknowledged=numbers[not way], port=port))
    return frames[True] + frames[False]


@pytest.mark.parametrize("spoilt", ["cut", "shuffled", "repeated", "shuffled and repeated"])
def test_spoilt_streams(opened: Open, tshark: Tshark, spoilt: str) -> None:
    chance = random.Random(spoilt)
    capture = Capture(RAW_IP)
    frames: list[bytes] = []
    for number in range(40):
        frames += connection(capture, 49152 + number, spoilt, chance)
    data = capture.data()
    captured = opened(data)
    found = list(captured.events())
    if "repeated" in spoilt and tshark.version >= (4, 4):
        # A segment that comes twice inside a frame makes Wireshark lose its place after that one: it is no secret.
        assert captured.account.frames + captured.account.skipped == pytest.approx(sum(map(len, frames)), rel=0.01)
        assert captured.account.balance == 0
        assert any(isinstance(event, Skipped) for event in found)
        return
    assert sorted(event.frame for event in found if isinstance(event, Record)) == sorted(frames)
    assert [told(event) for event in found] == [told(event) for event in builtin(data).events()]


def test_a_segment_that_is_missing_is_no_secret(opened: Open) -> None:
    capture = Capture(RAW_IP)
    talk = Connection(capture)
    talk.send(VOLTAGE)
    talk.segment(True, TONE)  # nobody captured it
    talk.send(VOLTAGE)
    talk.send(VOLTAGE)
    captured = opened(capture.data())
    record, skipped = captured.events()
    assert isinstance(record, Record)
    assert record.numbers == (1,)
    assert isinstance(skipped, Skipped)
    assert skipped.number == 2
    assert skipped.reason == (
        "20 bytes in packets 2, 3 are in no frame: the rest of a frame is missing, or what came before them"
    )
    assert captured.account.skipped == 20
    assert captured.account.balance == 0


def test_an_unfinished_frame_is_told_at_the_end(opened: Open) -> None:
    capture = Capture(RAW_IP)
    talk = Connection(capture)
    talk.send(TONE + VOLTAGE)
    talk.send(VOLTAGE[:6])
    record, second, skipped = opened(capture.data()).events()
    assert isinstance(record, Record)
    assert isinstance(second, Record)
    assert isinstance(skipped, Skipped)
    assert skipped.reason.startswith("6 bytes in packet 2 are in no frame")


def test_an_unfinished_frame_on_bluetooth(opened: Open) -> None:
    capture = Capture(201)
    port = SerialPort(capture)
    port.send(VOLTAGE + TONE[:5])
    number = port.send(TONE[5:9])
    captured = opened(capture.data())
    record, skipped = captured.events()
    assert isinstance(record, Record)
    assert isinstance(skipped, Skipped)
    assert (skipped.data, skipped.number) == (TONE[:9], number)
    assert skipped.reason == "the stream ends inside a frame, of which 9 bytes came"
    assert captured.account.skipped == 9


def test_what_is_no_frame(opened: Open) -> None:
    capture = Capture(RAW_IP)
    talk = Connection(capture)
    talk.send(UNLOCK)
    talk.send(b"HTTP/1.1 404 Not Found\r\n")
    _, skipped = opened(capture.data()).events()
    assert isinstance(skipped, Skipped)
    assert skipped.data == b"HTTP/1.1 404 Not Found\r\n"
    assert skipped.reason.startswith("no frame can start here: its length field would say 21576, a frame has 3 to 1022")


def test_packets_that_were_cut(opened: Open) -> None:
    capture = Capture(RAW_IP)
    talk = Connection(capture)
    for _ in range(20):
        talk.send(TONE)
        talk.send(TONE)
    data = cut(capture.data(), 40 + 12)
    found = list(builtin(data).events())
    assert [told(event) for event in opened(data).events()] == [told(event) for event in found]
    assert [(event.frame, event.numbers) for event in found if isinstance(event, Record)] == [
        (TONE[:12], (number,)) for number in range(1, 41)
    ]
    assert isinstance(found[0], Record)
    assert str(found[0].message.fault) == (
        "offset 0: the frame is cut off: its length field says 14 bytes follow, 10 do"
    )


@pytest.mark.parametrize("most", [47, 48, 49, 50, 51, 52, 60])
def test_what_is_there_of_packets_that_were_cut_is_shown_as_by_the_dissector(most: int, tshark: Tshark) -> None:
    capture = Capture(RAW_IP)
    talk = Connection(capture)
    expected = []
    for data, send in ((TONE, talk.send), (VOLTAGE, talk.send), (ANSWER, talk.receive)) * 40:
        expected.append((send(data), data[: most - 40].hex()))
    data = cut(capture.data(), most)
    records = [event for event in builtin(data).events() if isinstance(event, Record)]
    ours = [(record.number, record.frame.hex()) for record in records]
    path = tshark.place(data, f"cut{most}.pcap")
    words = ("-o", "ev3.bytes:TRUE", "-Y", "ev3.bytes", "-T", "fields", "-e", "frame.number", "-e", "ev3.bytes")
    shown = [line.split("\t") for line in tshark.run(path, *words).splitlines()]
    theirs = [(int(number), data.replace(":", "")) for number, data in shown]
    # Commands of which less than two bytes of an operation are there claim nothing.
    assert ours == theirs == (expected if most >= 49 else [])


def test_what_is_packed_into_other_packets_is_read_by_wireshark(opened: Open) -> None:
    """As the built-in engine says where it reads nothing."""
    data = in_tunnels(TONE)
    assert [record.number for record in opened(data)] == [1, 2, 3, 4, 5, 6]
    ours = builtin(data)
    assert list(ours.events()) == []
    assert ours.account.packed == dict.fromkeys(("GRE", "AH", "802.1ah", "VXLAN", "Geneve", "GTP"), 1)


def test_packets_that_were_cut_are_counted(opened: Open) -> None:
    capture = Capture(RAW_IP)
    Connection(capture).send(TONE)
    capture.add(datagram(b"hello", target_port=53))
    for captured in (opened(cut(capture.data(), 35)), builtin(cut(capture.data(), 35))):
        assert list(captured.events()) == []
        assert captured.account.cut == 1


def test_other_traffic_is_counted(opened: Open) -> None:
    capture = Capture(RAW_IP)
    Connection(capture, brick_port=80).send(b"GET / HTTP/1.1\r\n\r\n")
    capture.add(datagram(b"hello", target_port=53))
    captured = opened(capture.data())
    assert list(captured.events()) == []
    account = captured.account
    assert (account.packets, account.captured, account.other) == (2, 58 + 33, 58 + 33)


def test_other_ports(opened: Open) -> None:
    capture = Capture(RAW_IP)
    for port in (5555, 5556, 5557):
        Connection(capture, brick_port=port).send(VOLTAGE)
    data = capture.data()
    assert [record.target for record in opened(data)] == ["192.0.2.10:5555"]
    assert [record.target for record in opened(data, ports=(5556, 5557))] == ["192.0.2.10:5556", "192.0.2.10:5557"]


def test_the_ports_of_both_ends(opened: Open) -> None:
    capture = Capture(RAW_IP)
    for port in (40_000, 5500):
        talk = Connection(capture, port)
        talk.send(VOLTAGE)
        talk.receive(ANSWER)
    for ports in ((5555, 40_000, 5500), range(5000, 60_000)):
        found = list(opened(capture.data(), ports=ports))
        assert [(record.direction, record.peer) for record in found] == [
            (Direction.SENT, "192.0.2.10:5555"),
            (Direction.RECEIVED, "192.0.2.10:5555"),
        ] * 2


def test_a_connection_on_another_port(opened: Open) -> None:
    capture = Capture(RAW_IP)
    talk = Connection(capture, brick_port=61_000)
    talk.send(UNLOCK)
    talk.receive(ACCEPT)
    talk.send(VOLTAGE)
    talk.receive(ANSWER)
    found = list(opened(capture.data()))
    assert [(record.direction, record.peer) for record in found] == [
        (Direction.SENT, "192.0.2.10:61000"),
        (Direction.RECEIVED, "192.0.2.10:61000"),
    ]


def test_a_segment_that_acknowledges_is_no_frame(opened: Open) -> None:
    capture = Capture(RAW_IP)
    capture.add(segment(True, 1, acknowledged=1, flags=ACK))
    captured = opened(capture.data())
    assert list(captured.events()) == []
    assert captured.account.other == 40


# Files


def test_a_file_that_was_cut(opened: Open) -> None:
    found, complaint = ended(opened((CAPTURES / "usb-windows.pcap").read_bytes()[:-50]))
    assert complaint == "tshark says: the file appears to have been cut short in the middle of a packet"
    assert len(found) == 14


def test_a_file_that_is_no_capture(opened: Open) -> None:
    with pytest.raises(CaptureError, match=r"^tshark says: the file isn't a capture file in a format TShark underst"):
        list(opened(CAPTURES / "README.md").events())


def test_a_file_that_is_not_there(tshark: Tshark) -> None:
    with pytest.raises(FileNotFoundError):
        read_by_tshark("nothing/here.pcap", tshark=str(tshark.path))


# tshark itself


def children() -> set[str]:
    """The programs that this process has started and that run."""
    found: set[str] = set()
    for task in Path("/proc/self/task").iterdir():
        found |= set((task / "children").read_text().split())
    return found


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="only Linux tells which programs somebody started")
def test_nothing_is_left_of_a_capture_that_is_closed_early(opened: Open, tshark: Tshark) -> None:
    before = children()
    capture = Capture(RAW_IP)
    talk = Connection(capture)
    for _ in range(20_000):
        talk.send(VOLTAGE)
    captured = opened(capture.data())
    events = captured.events()
    next(events)
    assert len(children() - before) >= 1
    events.close()  # type: ignore[attr-defined]
    assert children() <= before
    assert list(tshark.folder.glob("ev3proto-*")) == []


def test_where_an_event_loop_runs(opened: Open) -> None:
    async def cell_of_a_notebook() -> int:
        return len(list(opened(CAPTURES / "daisy.pcap")))

    assert asyncio.run(cell_of_a_notebook()) == 8


def test_a_dissector_that_is_installed_is_used(tshark: Tshark) -> None:
    home = Path(tempfile.mkdtemp(prefix="home-", dir=tshark.folder))
    plugins = home / ".local" / "lib" / "wireshark" / "plugins"
    plugins.mkdir(parents=True)
    for folder in (home, *plugins.parents):
        if folder.is_relative_to(home):
            folder.chmod(0o755)
    (plugins / "ev3.lua").write_text(build())
    text = tshark.path.read_text().replace("HOME=/nonexistent", f"HOME={home}")
    text = text.replace('$(dirname "$(readlink -f "$0")")', str(tshark.program.parent))
    program = home / "tshark"
    program.write_text(text)
    program.chmod(0o755)
    path = tshark.place(CAPTURES / "daisy.pcap")
    assert len(list(read_by_tshark(path, tshark=str(program)))) == 8

    (plugins / "ev3.lua").write_text(build().replace("ev3.prefs.bytes", "ev3.prefs.older"))
    with pytest.raises(CaptureError, match="the one that is installed is older than this ev3proto"):
        list(read_by_tshark(path, tshark=str(program)))


@pytest.fixture
def imitation(tmp_path: Path) -> Callable[[str], str]:
    """Makes a program that behaves like some tshark: what it does when it is to read."""

    def make(reading: str, version: str = "TShark (Wireshark) 4.2.5.") -> str:
        path = tmp_path / "tshark"
        path.write_text(
            f"#!/bin/sh\ncase $1 in -v) echo '{version}'; exit;; -G) echo 'EV3\tEV3\tev3'; exit;; esac\n{reading}\n"
        )
        path.chmod(0o755)
        return str(path)

    return make


def complaint(program: str) -> str:
    with pytest.raises(CaptureError) as caught:
        list(read_by_tshark(CAPTURES / "daisy.pcap", tshark=program).events())
    return str(caught.value)


def test_streams_are_copied_for_tshark(
    imitation: Callable[..., str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    program = imitation(f'while [ "$1" != -r ]; do shift; done; cat "$2" > {tmp_path / "seen"}')
    data = (CAPTURES / "daisy.pcap").read_bytes()
    for source in (io.BytesIO(data), CaptureFile(io.BytesIO(gzip.compress(data)))):
        assert list(read_by_tshark(source, tshark=program)) == []
        assert (tmp_path / "seen").read_bytes() == data
        assert list(tmp_path.glob("ev3proto-*")) == []


def test_no_tshark() -> None:
    assert complaint("/no/tshark") == (
        "there is no program /no/tshark: install tshark, which is part of Wireshark, or name it with --tshark"
    )


def test_another_program(imitation: Callable[..., str]) -> None:
    program = imitation("", version="ls (GNU coreutils) 9.1")
    assert complaint(program) == f"{program} is no tshark: it does not say which Wireshark it belongs to"


def test_an_old_tshark(imitation: Callable[..., str]) -> None:
    program = imitation("", version="TShark (Wireshark) 3.6.2 (Git v3.6.2)")
    assert complaint(program) == f"{program} is version 3.6: the dissector runs in Wireshark 4.0 and later"


def test_a_tshark_that_dies(imitation: Callable[..., str]) -> None:
    program = imitation("kill -SEGV $$")
    assert complaint(program) == "tshark ended by signal 11 before it had read everything"


def test_a_tshark_as_root(imitation: Callable[..., str]) -> None:
    said = """echo 'Running as user "root" and group "root". This could be dangerous.' >&2
    echo 'tshark: -o flag "ev3.bytes:TRUE" specifies unknown preference' >&2; exit 1"""
    program = imitation(said, version="TShark (Wireshark) 4.4.1.")
    assert complaint(program) == (
        f"{program} does not load the dissector: as root, Wireshark 4.4 and later load no Lua; run this as an ordinary"
        " user"
    )


def test_what_came_before_tshark_died_is_given(imitation: Callable[..., str]) -> None:
    row = (
        '{"timestamp":"1","layers":{"frame_number":["3"],"frame_time_epoch":["1767261600.000000123"],'
        '"frame_cap_len":["1088"],"frame_protocols":["usb:ev3"],"usb_bus_id":["1"],"usb_device_address":["7"],'
        f'"usb_endpoint_address_direction":["0"],"usb_data_len":["1024"],"ev3_bytes":["{VOLTAGE.hex()}"]}}}}'
    )
    index = '{"index":{"_index":"packets"}}'
    program = imitation(f"printf '%s\\n' '{index}' '{row}'; echo 'tshark: Something went wrong.' >&2; exit 2")
    captured = read_by_tshark(CAPTURES / "daisy.pcap", tshark=program)
    (record,), said = ended(captured)
    assert said == "tshark says: Something went wrong"
    assert isinstance(record, Record)
    assert (record.frame, record.numbers, record.time_ns) == (VOLTAGE, (3,), 1_767_261_600_000_000_123)
    assert captured.account == Account(
        packets=1,
        captured=1088,
        first_ns=1_767_261_600_000_000_123,
        last_ns=1_767_261_600_000_000_123,
        frames=10,
        padding=1014,
        other=64,
    )


@pytest.mark.parametrize("name", ["wifi.pcapng", "usb-bootloader.pcapng", "bluetooth.log"])
def test_packets_of_pyshark(tshark: Tshark, opened: Open, name: str) -> None:
    """Whoever has pyshark read gives its packets, and gets what the engine wireshark gives."""
    packets = tshark.packets(tshark.place(CAPTURES / name), "-o", "ev3.bytes:TRUE")
    found, expected = from_pyshark(packets), opened(CAPTURES / name)
    assert list(map(told, found.events())) == list(map(told, expected.events()))
    assert found.account == expected.account


def test_the_builtin_engine_needs_none_of_it() -> None:
    code = (
        "import sys, ev3proto.capture;"
        f"assert len(list(ev3proto.capture.read({str(CAPTURES / 'daisy.pcap')!r}))) == 8;"
        "print([name for name in sys.modules if name in ('pyshark', 'asyncio', 'lxml')])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60)
    assert done.stdout == "[]\n"
