"""Where frames start in a stream: a length that counts itself, bytes left over, gaps, and replies in pieces."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.messages import tone, voltage, volts
from support.packets import HCI_WITH_DIRECTION, RAW_IP, Capture, Connection, SerialPort
from support.wireshark import Tshark

import ev3proto

UNLOCK = b"GET /target?sn=0016530a0b0c VMTP1.0\nProtocol: EV3\n\n"
SELF = "this is a frame whose length counts its own two bytes: it says %d, the size of all that was sent"
LEFT_OVER = "the frame before ends here by its length field, %s before the end of what was sent"
GAP = "bytes that are in no frame, as after a gap in the capture"


def shown(tshark: Tshark, capture: Capture, *words: str) -> dict[int, tuple[str, list[str]]]:
    """Returns the info column and the expert information of each packet with data."""
    path = tshark.place(capture.data(), "boundaries.pcap")
    fields = ("frame.number", "_ws.col.Info", "_ws.expert.message")
    asked = [word for field in fields for word in ("-e", field)]
    lines = tshark.run(path, *words, "-T", "fields", "-E", "aggregator=|", *asked).splitlines()
    split = [line.split("\t") for line in lines]
    return {int(number): (info, said.split("|") if said else []) for number, info, said in split}


def counting_itself(frame: bytes) -> bytes:
    return len(frame).to_bytes(2, "little") + frame[2:]


@pytest.mark.parametrize("link", [RAW_IP, HCI_WITH_DIRECTION])
def test_a_length_that_counts_itself_is_named(tshark: Tshark, link: int) -> None:
    """The first fault of many libraries: the brick waits for two more bytes, and answers to the first command.

    Over TCP, a segment is all that was sent. Over Bluetooth the next packet may continue it, so that one tells.
    """
    capture = Capture(link)
    over_tcp = link == RAW_IP
    wrong, right = (
        Connection(capture, 10_000 + number) if over_tcp else SerialPort(capture, connection=number)
        for number in range(2)
    )
    for way in (wrong, right):
        way.send(UNLOCK if over_tcp else tone(1))
    first = wrong.send(counting_itself(voltage(20)))
    second = wrong.send(counting_itself(voltage(21)))
    reply = wrong.receive(bytes.fromhex("0300 1400 04"))
    third = wrong.send(counting_itself(voltage(22)))
    last = wrong.send(counting_itself(voltage(23)))
    named = [first, second, third, last] if over_tcp else [second, last]
    controls = [right.send(voltage(1)[:7]), right.send(voltage(1)[7:]), right.receive(volts(1))]
    for words in ((), ("-2",)):
        found = shown(tshark, capture, *words)
        said = {number for number, (_, lines) in found.items() if any(SELF % 10 in line for line in lines)}
        assert said == set(named)
        left = [number for number, (_, lines) in found.items() if any(LEFT_OVER % "8 bytes" in line for line in lines)]
        assert left == ([] if over_tcp else [second, last])
        assert found[reply][0] == "error reply to UI_READ.GET_VBATT"
        assert not [line for line in found[reply][1] if "not seen" in line]
        assert not [line for _, lines in found.values() for line in lines if line == GAP]
        assert not [line for number in controls for line in found[number][1] if "offset" in line]
    decoded = list(ev3proto.read(tshark.folder / "boundaries.pcap"))
    notes = {each.number: each.note for each in decoded if isinstance(each, ev3proto.Record) and each.note}
    assert {number: note.partition(";")[0] for number, note in notes.items()} == dict.fromkeys(named, SELF % 10)
    (answer,) = (each for each in decoded if isinstance(each, ev3proto.Record) and each.number == reply)
    assert answer.request is not None
    problems = [each.message.partition(": ")[2] for each in decoded if isinstance(each, ev3proto.Problem)]
    assert [problem for problem in problems if "cut off" not in problem] == [LEFT_OVER % "8 bytes"] * (not over_tcp) * 2


@pytest.mark.parametrize("link", [RAW_IP, HCI_WITH_DIRECTION])
def test_a_lone_frame_with_a_wrong_length_is_named_with_its_reply(tshark: Tshark, link: int) -> None:
    """As the first and only one of a connection; a right frame that is split there is joined."""
    capture = Capture(link)
    alone, refused, split, inside = (
        Connection(capture, 10_000 + number)
        if link == RAW_IP
        else SerialPort(capture, connection=number, address=bytes([number] * 6))
        for number in range(4)
    )
    right = bytes.fromhex("0A00 0700 80 0000 A60001 8400")
    wrong = [alone.send(counting_itself(voltage(1)))]
    for counter in (2, 3):
        wrong.append(refused.send(counting_itself(voltage(counter))))
        refused.receive(bytes((3, 0, counter, 0, 4)))
    # After the reply, the first byte of a right one (RETURN) is not the one that seemed to be missing.
    wrong.append(refused.send((9).to_bytes(2, "little") + voltage(4)[2:]))
    refused.receive(bytes.fromhex("0300 0400 04"))
    good = refused.send(voltage(7))
    refused.receive(volts(7))
    parts = [split.send(right[:-2]), split.send(right[-2:])]
    inside.send(voltage(5))
    inside.receive(volts(5))
    parts += [inside.send(right[:-2]), inside.send(right[-2:] + voltage(6))]
    inside.receive(volts(6))
    found = shown(tshark, capture, "-2")
    assert [number for number, (_, lines) in found.items() if any("offset 0" in line for line in lines)] == wrong
    assert [found[number + 1][0] for number in wrong[1:]] == ["error reply to UI_READ.GET_VBATT"] * 3
    assert found[good] == ("UI_READ.GET_VBATT", [])
    whole = "OUTPUT_START layer=0 nos=A (+UI_DRAW.UPDATE)"
    assert [found[number] for number in parts] == [
        ("part of a frame", []),
        (whole, []),
        ("part of a frame", []),
        (f"{whole}; UI_READ.GET_VBATT", []),
    ]
    records = [each for each in ev3proto.read(tshark.folder / "boundaries.pcap") if isinstance(each, ev3proto.Record)]
    assert {each.number for each in records if each.note} == set(wrong)
    answers = {each.request.number: each.number for each in records if each.request}
    assert answers == {number: number + 1 for number in (*wrong[1:], good, parts[1] + 1, parts[3])}


SWAPPED = "this is a frame whose length has its high byte first: it says %d, but %d bytes follow it"
WRONG = "the length field says that %d bytes follow it, but there are %d"
SLIPS: dict[str, tuple[int, str, str]] = {
    # The length of an 8 byte command, and what is said of it.
    "counts itself": (10, "0A00", SELF % 10),
    "high byte first": (0x0800, "0008", SWAPPED % (0x0800, 8)),
    "1 too large": (9, "0900", WRONG % (9, 8)),
    "1 too small": (7, "0700", WRONG % (7, 8)),
    "2 too small": (6, "0600", WRONG % (6, 8)),
}


@pytest.mark.parametrize("link", [RAW_IP, HCI_WITH_DIRECTION])
def test_a_wrong_length_in_the_very_first_frame_is_named(tshark: Tshark, link: int) -> None:
    """Where nothing else tells that a brick is spoken to: no text, no right frame; in `decode` as in Wireshark."""
    capture = Capture(link)
    expected: dict[int, str] = {}
    controls: list[int] = []
    for number, (length, digits, said) in enumerate(SLIPS.values()):
        way = Connection(capture, 10_000 + number) if link == RAW_IP else SerialPort(capture, connection=number)
        sent = [way.send(bytes.fromhex(digits) + voltage(counter)[2:]) for counter in (20, 21)]
        # Of a length that is too large, over Bluetooth, the rest may come with the next packet.
        waits = 8 < length <= 10 and link != RAW_IP
        expected |= dict.fromkeys(sent[1:] if waits else sent, said)
    for number, pieces in enumerate(([voltage(1)], [voltage(1)[:7], voltage(1)[7:]], [voltage(1) + tone(2)]), 100):
        way = Connection(capture, 10_000 + number) if link == RAW_IP else SerialPort(capture, connection=number)
        controls += [way.send(piece) for piece in pieces]
    for words in ((), ("-2",)):
        found = shown(tshark, capture, *words)
        named = {number: [line for line in lines if "offset 0" in line] for number, (_, lines) in found.items()}
        assert {
            number: lines[0][len("at offset 0: ") :].partition(";")[0] for number, lines in named.items() if lines
        } == expected
        assert not any("ev3" in found[number][0].lower() or "length" in str(found[number]) for number in controls)
    records = [each for each in ev3proto.read(tshark.folder / "boundaries.pcap") if isinstance(each, ev3proto.Record)]
    assert {each.number: each.note.partition(";")[0] for each in records if each.note} == expected


@pytest.mark.parametrize("link", [RAW_IP, HCI_WITH_DIRECTION])
def test_a_single_frame_with_a_wrong_length_is_named_by_decode(tmp_path: Path, link: int) -> None:
    capture = Capture(link)
    way = Connection(capture) if link == RAW_IP else SerialPort(capture)
    way.send(counting_itself(tone(1)))
    (tmp_path / "single.pcap").write_bytes(capture.data())
    (found,) = ev3proto.read(tmp_path / "single.pcap")
    assert isinstance(found, ev3proto.Record)
    assert found.note is not None
    assert found.note.startswith(SELF % 16)


def test_bytes_after_a_frame_are_the_senders(tshark: Tshark) -> None:
    """A length that is too short: what is left over ends with the segment, and the next one starts a frame."""
    capture = Capture(RAW_IP)
    stream = Connection(capture, 10_000)
    stream.send(UNLOCK)
    short = stream.send((14 - 3).to_bytes(2, "little") + tone(1)[2:])
    good = stream.send(tone(2))
    between = stream.send(tone(3) + b"\xff\xff\xff" + tone(4))
    found = shown(tshark, capture)
    assert any((LEFT_OVER % "3 bytes") in line for line in found[short][1])
    assert found[good] == ("SOUND.TONE volume=1 % frequency=440 Hz duration=1000 ms", [])
    assert found[between][0].count("SOUND.TONE") == 2
    assert any((LEFT_OVER % "19 bytes") in line for line in found[between][1])


def test_a_gap_is_said_where_tcp_shows_one(tshark: Tshark) -> None:
    capture = Capture(RAW_IP)
    stream = Connection(capture, 10_000)
    stream.send(UNLOCK)
    begun = stream.send(tone(1)[:9])
    stream.segment(True, bytes(100))
    after = stream.send(b"\1\2\3\4\5" + tone(2))
    found = shown(tshark, capture)
    assert GAP in [*found[begun][1], *found[after][1]]
    assert found[after][0].endswith("SOUND.TONE volume=1 % frequency=440 Hz duration=1000 ms")


def test_a_whole_reply_is_complete_whatever_its_data_look_like(tshark: Tshark) -> None:
    """Over Bluetooth, in two packets: its data are those of a reply of seven bytes and the header of another."""
    capture = Capture(HCI_WITH_DIRECTION)
    port = SerialPort(capture)
    command, reply = counted_read(12), bytes.fromhex("0F00 0700 02 0500 0700 02 0000 0900 0700 02")
    ends = []
    for _ in range(3):
        port.send(command)
        port.receive(reply[:9])
        ends.append(port.receive(reply[9:]))
    path = tshark.place(capture.data(), "complete.pcap")
    asked = ("-T", "fields", "-e", "frame.number", "-Y", "ev3.response_time")
    assert tshark.run(path, *asked).split() == [str(number) for number in ends]
    records = [each for each in ev3proto.read(path) if isinstance(each, ev3proto.Record)]
    assert [each.numbers for each in records] == [each for end in ends for each in ((end - 2,), (end - 1, end))]


def test_the_header_of_a_reply_is_enough_for_a_claim(tshark: Tshark) -> None:
    """A command with an argument outside of its range, and its reply in three packets."""
    capture = Capture(HCI_WITH_DIRECTION)
    port = SerialPort(capture)
    command, reply = counted_read(200, layer=7), bytes.fromhex("CB00 0700 02") + bytes(range(200))
    for _ in range(2):
        sent = port.send(command)
        pieces = [port.receive(reply[at : at + 70]) for at in range(0, len(reply), 70)]
    path = tshark.place(capture.data(), "header.pcap")
    found = tshark.run(path, "-2", "-T", "fields", "-e", "frame.number", "-Y", "ev3.msg_num == 7").split()
    assert found[-2:] == [str(sent), str(pieces[-1])]
    assert len(found) == 4
    records = [each for each in ev3proto.read(path) if isinstance(each, ev3proto.Record)]
    assert [each.numbers for each in records[-2:]] == [(sent,), tuple(pieces)]
    assert len(records) == 4


def counted_read(size: int, layer: int = 0) -> bytes:
    """INPUT_DEVICE.GET_NAME of a length into all of the memory, which is as long."""
    memory = size.to_bytes(2, "little")
    body = b"\7\0\0" + memory + bytes((0x99, 0x15, layer, 0)) + b"\x82" + memory + b"\x60"
    return len(body).to_bytes(2, "little") + body
