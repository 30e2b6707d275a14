"""Captures made of frames: Wireshark finds no fault in them, and every reader reads the same frames."""

from __future__ import annotations

import io
import struct
from collections.abc import Sequence
from pathlib import Path

import pytest
from dpkt.ethernet import Ethernet
from hypothesis import strategies as st
from support.frames import drawn
from support.reading import records
from support.wireshark import Tshark

from ev3proto import GV, BuildError, capture, direct_command, direct_reply, operation, system_command, system_reply
from ev3proto.capture import Announcement, Carrier, Record, TextKind
from ev3proto.generate.captures import CaptureWriter, TimedFrame, write_pcapng
from ev3proto.generate.captures.wifi import Writer
from ev3proto.messages import Message
from ev3proto.testing import frames

CARRIERS = ("wifi", "usb", "bluetooth")
BEGIN_NS = 1_767_261_600_000_000_000
"""2026-01-01 10:00 UTC, the default start of a conversation."""

NOTE = 0x00400000
"""Wireshark's number for remarks below warnings: a connection is closed, a command has no reply."""

CHUNK = bytes(range(256)) * 3 + bytes(249)

DIALOGUE: list[Message] = [
    direct_command(operation("UI_READ.GET_VBATT", GV(0)), counter=1, reply=True, global_size=4),
    direct_reply(bytes.fromhex("a470fd40"), counter=1),
    direct_command(operation("SOUND.TONE", 1, 440, 1000), counter=2),
    direct_command(operation("UI_WRITE.LED", "LED_RED_FLASH"), counter=3),
    # The largest frame there is, to the brick and back.
    system_command("CONTINUE_DOWNLOAD", counter=4, handle=0, data=CHUNK),
    system_reply("CONTINUE_DOWNLOAD", counter=4, handle=0),
    system_command("BEGIN_UPLOAD", counter=5, max_bytes=1012, path="../prjs/log/values.rtf"),
    system_reply("BEGIN_UPLOAD", counter=5, size=1000, handle=1, data=CHUNK[:1000]),
    direct_command(operation("SOUND_READY"), counter=6, reply=True),
    direct_reply(counter=6),
]


def made(told: Sequence[Message | bytes | TimedFrame], carrier: str, **times: int) -> bytes:
    stream = io.BytesIO()
    assert write_pcapng(told, stream, carrier=carrier, **times) == len(told)
    return stream.getvalue()


@pytest.mark.parametrize("carrier", CARRIERS)
def test_written_captures_can_be_read(carrier: str) -> None:
    found = records(made(DIALOGUE, carrier))
    assert [record.frame for record in found] == [message.build() for message in DIALOGUE]
    assert {record.carrier for record in found} == {Carrier(carrier)}
    assert [record.direction and record.direction.value for record in found] == [
        *("sent", "received", "sent", "sent", "sent", "received", "sent", "received", "sent", "received")
    ]
    assert [record.time_ns - BEGIN_NS for record in found] == [number * 1_000_000 for number in range(10)]
    assert [value.value for value in found[1].values] == [pytest.approx(7.92)]


def test_a_brick_on_wifi_is_found_and_unlocked_first() -> None:
    events = list(capture.read(io.BytesIO(made(DIALOGUE, "wifi"))).events())
    said = [event.said for event in events if isinstance(event, Announcement)]
    assert said == [TextKind.BEACON, TextKind.ANSWER, TextKind.UNLOCK, TextKind.ACCEPT]
    assert isinstance(events[4], Record)


def test_the_header_of_linux_has_the_time_in_seconds_and_microseconds() -> None:
    (tone,) = (message.build() for message in DIALOGUE[2:3])
    data = made([TimedFrame(tone, BEGIN_NS + 1_234_567_000)], "usb")
    header = data[data.index(tone) - 64 :][:64]
    assert struct.unpack_from("<qi", header, 16) == (BEGIN_NS // 10**9 + 1, 234_567)


@pytest.mark.parametrize("carrier", CARRIERS)
def test_given_times(carrier: str) -> None:
    moments = [BEGIN_NS + moment for moment in (0, 1, 1, 5_000_000_123, 5_000_000_124)]
    told = [TimedFrame(message.build(), moment) for message, moment in zip(DIALOGUE, moments, strict=False)]
    assert [record.time_ns for record in records(made(told, carrier))] == moments
    packets = [event.time_ns for event in capture.read(io.BytesIO(made(told, carrier))).events()]
    assert packets == sorted(packets)
    spaced = records(made(DIALOGUE, carrier, begin_ns=1_000_000_000, step_ns=250))
    assert [record.time_ns for record in spaced] == [1_000_000_000 + 250 * number for number in range(10)]


@pytest.mark.parametrize("carrier", CARRIERS)
def test_the_same_frames_make_the_same_file(carrier: str) -> None:
    assert made(DIALOGUE, carrier) == made([message.build() for message in DIALOGUE], carrier)


@pytest.mark.parametrize("carrier", CARRIERS)
def test_wireshark_finds_no_errors(carrier: str, tshark: Tshark) -> None:
    path = tshark.place(made(DIALOGUE, carrier), f"export-{carrier}.pcapng")
    settings = ("ip.check_checksum", "tcp.check_checksum", "udp.check_checksum")
    checks = [word for name in settings for word in ("-o", f"{name}:TRUE")]
    assert tshark.run(path, *checks, "-2", "-Y", f"_ws.malformed || _ws.expert.severity > {NOTE}") == ""
    form = ("-T", "fields", "-e", "_ws.col.Info")
    told = [line for line in tshark.run(path, "-Y", "ev3.msg_len", *form).splitlines() if line]
    assert len(told) == len(DIALOGUE)
    assert told[1] == "reply to UI_READ.GET_VBATT: 7.92 V"
    assert told[2] == "SOUND.TONE volume=1 % frequency=440 Hz duration=1000 ms"
    assert tshark.lua_errors(path) == []


@pytest.mark.parametrize("carrier", CARRIERS)
def test_any_frame_on_any_carrier(carrier: str, tshark: Tshark) -> None:
    # Not every frame claims a serial port, but this one does.
    told = [DIALOGUE[2].build(), *drawn(frames(), 150)]
    data = made(told, carrier)
    assert [record.frame for record in records(data)] == told
    path = tshark.place(data, f"export-any-{carrier}.pcapng")
    assert tshark.run(path, "-Y", "_ws.malformed") == ""
    # The dissector may warn about frames; the packets around them have no warnings.
    others = f"(tcp || usb || btrfcomm || btl2cap) && !ev3 && _ws.expert.severity > {NOTE}"
    assert tshark.run(path, "-2", "-Y", others) == ""


@pytest.mark.parametrize("carrier", CARRIERS)
def test_many_unanswered_commands(carrier: str, tshark: Tshark) -> None:
    # TCP's window, RFCOMM's credits and the numbers of packets reach their limits.
    told = [direct_command(operation("SOUND_READY"), counter=number % 65536) for number in range(400)]
    data = made(told, carrier)
    assert len(records(data)) == 400
    path = tshark.place(data, f"export-many-{carrier}.pcapng")
    assert tshark.run(path, "-2", "-Y", f"_ws.malformed || _ws.expert.severity > {NOTE}") == ""


def test_the_packets_are_those_that_dpkt_builds() -> None:
    writer = Writer()
    opened = len(writer.opening())
    writer._host.number = 2**32 - 700  # its numbers start again among these packets
    writer._brick.packets = 2**16 - 3
    sent = [*DIALOGUE, *DIALOGUE]
    packets = [
        packet
        for message in sent
        for packet in (
            *writer.between(message.type is not None and message.type.is_command),
            *writer.frame(message.build(), message.type is not None and message.type.is_command),
        )
    ]
    assert opened == 9
    assert len(packets) > len(sent)
    for packet in packets:
        ethernet = Ethernet(packet)
        ip = ethernet.data
        ip.sum = ip.data.sum = 0  # dpkt computes missing checksums
        assert bytes(ethernet) == packet


@pytest.mark.parametrize(
    ("frame", "reason"),
    [
        (b"", "its length field says that 0 bytes follow, but 0 do"),
        (bytes.fromhex("0300010080"), None),
        (bytes.fromhex("0400010080"), "its length field says that 4 bytes follow, but 3 do"),
        (
            bytes.fromhex("ff03010080") + bytes(1020),
            "its length field says 1023, but it can be 3 to 1022",
        ),
    ],
)
def test_frames_of_impossible_length(frame: bytes, reason: str | None) -> None:
    stream = io.BytesIO()
    if reason is None:
        assert write_pcapng([frame], stream) == 1
        return
    with pytest.raises(BuildError) as error:
        write_pcapng([DIALOGUE[0], frame], stream)
    assert str(error.value) == f"frame 2: it cannot be carried: {reason}"


def test_decreasing_times_and_unknown_carriers() -> None:
    writer = CaptureWriter(io.BytesIO())
    writer.add(TimedFrame(DIALOGUE[0].build(), 2000))
    with pytest.raises(BuildError, match="the frame has the time 1999 ns, but the one before it has 2000 ns"):
        writer.add(TimedFrame(DIALOGUE[1].build(), 1999))
    with pytest.raises(ValueError, match="carrier 'serial' is not known: it must be one of usb, bluetooth, wifi"):
        write_pcapng([], io.BytesIO(), carrier="serial")


def test_a_refused_frame_changes_nothing() -> None:
    stream = io.BytesIO()
    writer = CaptureWriter(stream, carrier="bluetooth")
    for message in DIALOGUE:
        writer.add(message)
        with pytest.raises(BuildError):
            writer.add(b"\x00\x00")
    writer.close()
    assert stream.getvalue() == made(DIALOGUE, "bluetooth")


def test_frames_are_taken_one_by_one(tmp_path: Path) -> None:
    written: list[int] = []
    with (tmp_path / "tones.pcapng").open("wb") as stream:

        def told() -> object:
            for message in DIALOGUE:
                written.append(stream.tell())
                yield message

        write_pcapng(told(), stream)  # type: ignore[arg-type]
    assert written == sorted(set(written))


def test_strategies_reach_every_size() -> None:
    sizes = [*drawn(st.integers(5, 1024), 40), 1007, 1008, 1009, 1024]
    told = [direct_reply(bytes(size - 5)) for size in sizes]
    for carrier in CARRIERS:
        # Replies alone do not claim a serial port.
        found = records(made([DIALOGUE[0], *told], carrier))
        assert [len(record.frame) for record in found[1:]] == sizes
