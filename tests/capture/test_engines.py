"""The engine wireshark: the results of the real tshark with the dissector, compared with the built-in engine.

The two engines share no code that takes carriers apart. A tshark that runs inside a folder cannot read our other
files: captures and temporary files are in the work folder of the fixture `tshark`.
"""

from __future__ import annotations

import asyncio
import gzip
import io
import struct
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest
from support.files import Timed, btsnoop, darwin_usb, hcidump, packetlogger, pcap, timed
from support.packets import (
    ACK,
    HCI_WITH_DIRECTION,
    RAW_IP,
    Capture,
    Connection,
    SerialPort,
    cut,
    datagram,
    in_tunnels,
    packets_of,
    segment,
)
from support.wireshark import DISSECTOR, Tshark

from ev3proto.capture import Account, Announcement, CaptureError, Direction, Event, Record, Skipped, read
from ev3proto.capture import Capture as Captured
from ev3proto.capture.formats import CaptureFile
from ev3proto.pyshark import read as read_by_tshark

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
"""The number of frames and texts in each capture."""

VOLTAGE = bytes.fromhex("0800010000 0400 810160")
"""A command that asks for the voltage of the battery."""

ANSWER = bytes.fromhex("0700010002 a470fd40")
TONE = bytes.fromhex("0e00020080 0000 94010582b80182fa00")
UNLOCK = b"GET /target?sn=06165300000a VMTP1.0\r\nProtocol: EV3\r\n\r\n"
ACCEPT = b"Accept:EV340\r\n\r\n\0"

Open = Callable[..., Captured]


@pytest.fixture
def opened(tshark: Tshark, monkeypatch: pytest.MonkeyPatch) -> Open:
    """Opens a capture, or the bytes of one, with the engine wireshark."""
    monkeypatch.setattr(tempfile, "tempdir", str(tshark.folder))

    def open_capture(
        source: Path | bytes, *, ports: tuple[int, ...] = (5555,), dialect: str = "official", suffix: str = "pcap"
    ) -> Captured:
        path = tshark.place(source, "" if isinstance(source, Path) else f"{abs(hash(source)):x}.{suffix}")
        return read_by_tshark(path, tshark=str(tshark.path), ports=ports, dialect=dialect)

    return open_capture


def told(event: Event) -> tuple[object, ...]:
    """All attributes of an event, and only the last of its packets."""
    if isinstance(event, Skipped):
        return ("skipped", event.data, event.number, event.route)
    place = (max(event.numbers), event.route)
    if isinstance(event, Announcement):
        return (event.said, event.data, event.text, *place)
    answers = None if event.request is None else event.request.number
    return ("frame", event.frame.hex(), answers, event.note, *place)


@pytest.mark.parametrize("name", EVENTS)
def test_both_find_the_same(opened: Open, name: str) -> None:
    ours, theirs = read(CAPTURES / name), opened(CAPTURES / name)
    found = [told(event) for event in theirs.events()]
    assert found == [told(event) for event in ours.events()]
    assert len(found) == EVENTS[name]
    for part in ("packets", "frames", "texts", "cut", "first_ns", "last_ns"):
        assert getattr(theirs.account, part) == getattr(ours.account, part)
    assert theirs.account.balance == 0


def hci_packets() -> list[Timed]:
    """A command and its answer over a serial port that is set up before, with direction and type of each packet."""
    capture = Capture(HCI_WITH_DIRECTION)
    port = SerialPort(capture)
    port.send(VOLTAGE)
    port.receive(ANSWER)
    return timed(list(packets_of(capture.data())))


def without_types() -> bytes:
    """The same as btsnoop without packet types: the flags tell the direction."""
    return btsnoop(1001, [Timed(it.time_ns, it.data[5:]) for it in hci_packets()], [it.data[3] for it in hci_packets()])


def cooked() -> bytes:
    """The command and its answer in version 2 of Linux's cooked capture, as `tcpdump -i any` writes it."""
    connection = Connection(Capture(RAW_IP))
    head = struct.pack(">HHIHBB8s", 0x0800, 0, 1, 1, 4, 6, bytes(8))
    packets = (connection.segment(True, VOLTAGE), connection.segment(False, ANSWER))
    return pcap(276, timed([head + packet for packet in packets]))


BOTH_READ: dict[str, tuple[Callable[[], bytes], str]] = {
    "PacketLogger on PowerPC": (lambda: packetlogger(hci_packets(), ">"), "pklg"),
    "PacketLogger": (lambda: packetlogger(hci_packets(), "<"), "pklg"),
    "btsnoop without packet types": (without_types, "log"),
    "Linux cooked": (cooked, "pcap"),
}
"""By program: the file, and the end of its name, by which tshark tells files without a magic number apart."""


@pytest.mark.parametrize("kind", BOTH_READ)
def test_both_read_files_of_other_programs(opened: Open, kind: str) -> None:
    make, suffix = BOTH_READ[kind]
    ours, theirs = read(io.BytesIO(make())), opened(make(), suffix=suffix)
    found = list(theirs)
    assert [record.frame for record in found] == [VOLTAGE, ANSWER]
    assert [told(record) for record in found] == [told(record) for record in ours]
    assert found[1].request is found[0]


TSHARK_READS = {
    "hcidump -w": lambda: hcidump(hci_packets()),
    "macOS's USB": lambda: darwin_usb([(0x01, VOLTAGE.ljust(1024, b"\0")), (0x81, ANSWER.ljust(1024, b"\0"))]),
}


@pytest.mark.parametrize("kind", TSHARK_READS)
def test_what_the_engine_is_named_for_is_read_by_it(opened: Open, kind: str) -> None:
    data = TSHARK_READS[kind]()
    ours = read(io.BytesIO(data))
    assert "--engine wireshark reads" in complaint(ours)[1]
    found = [(record.frame, record.direction) for record in opened(data)]
    assert found == [(VOLTAGE, Direction.SENT), (ANSWER, Direction.RECEIVED)]


def test_a_frame_has_the_number_and_time_of_the_packet_in_which_it_ends(opened: Open) -> None:
    records = {record.number: record for record in opened(CAPTURES / "wifi.pcapng")}
    asked, answer = records[20], records[23]  # in two segments, in three segments
    assert (asked.numbers, asked.time_ns) == ((20,), 1_767_261_605_158_100_000)
    assert (asked.source, asked.target, asked.peer) == ("192.0.2.1:49152", "192.0.2.10:5555", "192.0.2.10:5555")
    assert answer.request is asked
    assert answer.latency == pytest.approx(0.0049)
    assert [(value.name, value.value) for value in answer.values] == [("TACHO", 421), ("TACHO", -17)]


def test_tunnels_are_read_by_wireshark_only(opened: Open) -> None:
    data = in_tunnels(TONE)
    assert [record.number for record in opened(data)] == [1, 2, 3, 4, 5, 6]
    assert list(read(io.BytesIO(data)).events()) == []


def test_packets_that_were_cut(opened: Open) -> None:
    capture = Capture(RAW_IP)
    talk = Connection(capture)
    for _ in range(20):
        talk.send(TONE)
        talk.send(TONE)
    data = cut(capture.data(), 40 + 12)
    captured = opened(data)
    found = list(captured.events())
    assert [told(event) for event in found] == [told(event) for event in read(io.BytesIO(data)).events()]
    assert captured.account.cut == 40
    assert isinstance(found[0], Record)
    assert str(found[0].message.fault) == (
        "offset 0: the frame is cut off: its length field says that 14 bytes follow, but 10 do"
    )


@pytest.mark.parametrize("most", [47, 48, 49, 50, 51, 52, 60])
def test_what_is_there_of_packets_that_were_cut_is_shown_as_by_the_dissector(most: int, tshark: Tshark) -> None:
    capture = Capture(RAW_IP)
    talk = Connection(capture)
    expected = []
    for data, send in ((TONE, talk.send), (VOLTAGE, talk.send), (ANSWER, talk.receive)) * 40:
        expected.append((send(data), data[: most - 40].hex()))
    data = cut(capture.data(), most)
    ours = [(record.number, record.frame.hex()) for record in read(io.BytesIO(data))]
    words = ("-o", "ev3.bytes:TRUE", "-Y", "ev3.bytes", "-T", "fields", "-e", "frame.number", "-e", "ev3.bytes")
    shown = [line.split("\t") for line in tshark.run(tshark.place(data, f"cut{most}.pcap"), *words).splitlines()]
    theirs = [(int(number), data.replace(":", "")) for number, data in shown]
    # Commands with less than two bytes of an operation do not claim a connection.
    assert ours == theirs == (expected if most >= 49 else [])


def test_what_is_not_a_frame(opened: Open) -> None:
    capture = Capture(RAW_IP)
    talk = Connection(capture)
    talk.send(UNLOCK)
    talk.send(b"HTTP/1.1 404 Not Found\r\n")
    capture.add(segment(True, 1, acknowledged=1, flags=ACK))
    capture.add(datagram(b"hello", target_port=53))
    captured = opened(capture.data())
    _, skipped = captured.events()
    assert isinstance(skipped, Skipped)
    assert (skipped.data, skipped.reason) == (
        b"HTTP/1.1 404 Not Found\r\n",
        "the dissector finds no frame in these bytes",
    )
    assert (captured.account.skipped, captured.account.packets) == (24, 4)


def test_a_frame_that_never_ends(opened: Open) -> None:
    capture = Capture(201)
    port = SerialPort(capture)
    port.send(VOLTAGE + TONE[:5])
    assert [record.frame for record in opened(capture.data())] == [VOLTAGE]


def test_other_ports(opened: Open) -> None:
    capture = Capture(RAW_IP)
    for port in (5555, 5556, 5557):
        Connection(capture, brick_port=port).send(VOLTAGE)
    data = capture.data()
    assert [record.target for record in opened(data)] == ["192.0.2.10:5555"]
    assert [record.target for record in opened(data, ports=(5556, 5557))] == ["192.0.2.10:5556", "192.0.2.10:5557"]


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


# Files


def complaint(captured: Captured) -> tuple[list[Event], str]:
    """Returns everything that a capture gives before its error, and the error."""
    found: list[Event] = []
    with pytest.raises(CaptureError) as caught:
        found.extend(captured.events())  # what came before an error remains
    return found, str(caught.value)


def test_a_file_that_was_cut(opened: Open) -> None:
    found, said = complaint(opened((CAPTURES / "usb-windows.pcap").read_bytes()[:-50]))
    assert said == "tshark: the file appears to have been cut short in the middle of a packet"
    assert len(found) == 14


def test_a_file_that_is_not_a_capture(opened: Open) -> None:
    said = complaint(opened(CAPTURES / "README.md"))[1]
    assert said.startswith("tshark: the file isn't a capture file in a format TShark understands")


def test_a_file_that_is_not_there(tshark: Tshark) -> None:
    with pytest.raises(FileNotFoundError):
        read_by_tshark("nothing/here.pcap", tshark=str(tshark.path))


# tshark itself


def children() -> set[str]:
    """The running programs that this process has started."""
    found: set[str] = set()
    for task in Path("/proc/self/task").iterdir():
        found |= set((task / "children").read_text().split())
    return found


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="only Linux lists child processes")
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
    (plugins / "ev3.lua").write_text(DISSECTOR.read_text())
    text = tshark.path.read_text().replace("HOME=/nonexistent", f"HOME={home}")
    text = text.replace('$(dirname "$(readlink -f "$0")")', str(tshark.program.parent))
    program = home / "tshark"
    program.write_text(text)
    program.chmod(0o755)
    path = tshark.place(CAPTURES / "daisy.pcap")
    assert len(list(read_by_tshark(path, tshark=str(program)))) == 8

    (plugins / "ev3.lua").write_text(DISSECTOR.read_text().replace("ev3.prefs.bytes", "ev3.prefs.older"))
    with pytest.raises(CaptureError, match="the one that is installed is older than this ev3proto"):
        list(read_by_tshark(path, tshark=str(program)))


@pytest.fixture
def imitation(tmp_path: Path) -> Callable[..., str]:
    """Makes a program that imitates some tshark: its behaviour when it should read."""

    def make(reading: str, version: str = "TShark (Wireshark) 4.2.5.") -> str:
        path = tmp_path / "tshark"
        path.write_text(
            f"#!/bin/sh\ncase $1 in -v) echo '{version}'; exit;; -G) echo 'EV3\tEV3\tev3'; exit;; esac\n{reading}\n"
        )
        path.chmod(0o755)
        return str(path)

    return make


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
    with pytest.raises(
        CaptureError, match=r"^/no/tshark: no such program: install tshark, .* or pass its path by --ts"
    ):
        read_by_tshark(CAPTURES / "daisy.pcap", tshark="/no/tshark")


@pytest.mark.parametrize(
    ("version", "said"),
    [
        ("ls (GNU coreutils) 9.1", "is not tshark: its version output does not name Wireshark"),
        ("TShark (Wireshark) 3.6.2 (Git v3.6.2)", "is version 3.6: the dissector runs in Wireshark 4.0 and later"),
    ],
)
def test_another_program(imitation: Callable[..., str], version: str, said: str) -> None:
    with pytest.raises(CaptureError, match=said):
        read_by_tshark(CAPTURES / "daisy.pcap", tshark=imitation("", version=version))


@pytest.mark.parametrize(
    ("reading", "said"),
    [
        ("kill -SEGV $$", "tshark ended by signal 11 before the end of the input"),
        (
            """echo 'tshark: -o flag "ev3.bytes:TRUE" specifies unknown preference' >&2; exit 1""",
            "or it is version 4.4 or later and runs as root",
        ),
    ],
)
def test_a_tshark_that_fails(imitation: Callable[..., str], reading: str, said: str) -> None:
    assert complaint(read_by_tshark(CAPTURES / "daisy.pcap", tshark=imitation(reading)))[1].endswith(said)


def test_what_came_before_tshark_died_is_given(imitation: Callable[..., str]) -> None:
    row = (
        '{"timestamp":"1","layers":{"frame_number":["3"],"frame_time_epoch":["1767261600.000000123"],'
        '"frame_cap_len":["1088"],"frame_protocols":["usb:ev3"],"ev3_brick":["1.7"],"ev3_connection":["1"],'
        f'"usb_endpoint_address_direction":["0"],"ev3_bytes":["{VOLTAGE.hex()}"]}}}}'
    )
    index = '{"index":{"_index":"packets"}}'
    program = imitation(f"printf '%s\\n' '{index}' '{row}'; echo 'tshark: Something went wrong.' >&2; exit 2")
    captured = read_by_tshark(CAPTURES / "daisy.pcap", tshark=program)
    (record,), said = complaint(captured)
    assert said == "tshark: Something went wrong"
    assert isinstance(record, Record)
    assert (record.frame, record.numbers, record.time_ns) == (VOLTAGE, (3,), 1_767_261_600_000_000_123)
    assert captured.account == Account(
        packets=1,
        captured=1088,
        first_ns=1_767_261_600_000_000_123,
        last_ns=1_767_261_600_000_000_123,
        frames=10,
        other=1078,
    )


def test_the_builtin_engine_needs_none_of_it() -> None:
    code = (
        "import sys, ev3proto.capture;"
        f"assert len(list(ev3proto.capture.read({str(CAPTURES / 'daisy.pcap')!r}))) == 8;"
        "print([name for name in sys.modules if name in ('pyshark', 'asyncio', 'lxml')])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60)
    assert done.stdout == "[]\n"
