"""What people hunt for in a capture: a missing reply, whose value is whose, a file that is not complete."""

from __future__ import annotations

import struct
from collections.abc import Iterator

from support.messages import tone, voltage, volts
from support.packets import RAW_IP, SYN, Capture, Connection, segment
from support.wireshark import Tshark

import ev3proto
from ev3proto.schema.header import with_length

FIELDS = ("frame.number", "_ws.col.Info", "_ws.expert.message")


def shown(tshark: Tshark, capture: Capture, *words: str) -> dict[int, tuple[str, list[str]]]:
    """Returns the info column and the expert information of each packet, after two passes."""
    path = tshark.place(capture.data(), "hunting.pcap")
    asked = [word for field in FIELDS for word in ("-e", field)]
    lines = tshark.run(path, "-2", *words, "-T", "fields", "-E", "aggregator=|", *asked).splitlines()
    split = [line.split("\t") for line in lines]
    return {int(number): (info, said.split("|") if said else []) for number, info, said in split}


def test_a_command_without_a_reply_is_a_warning(tshark: Tshark) -> None:
    """As soon as a message of the conversation is more than a second newer; until then its reply may come."""
    capture = Capture(RAW_IP)
    stream, other = Connection(capture), Connection(capture, 50_001)
    lost, answered = stream.send(voltage(1)), stream.send(voltage(2))
    stream.receive(volts(2))
    capture.wait(1100)
    last = stream.send(voltage(3))
    late = other.send(voltage(1))
    found = shown(tshark, capture)
    assert found[lost] == ("UI_READ.GET_VBATT (no reply)", ["no reply to this command was seen"])
    assert found[answered] == ("UI_READ.GET_VBATT", [])
    for number in (last, late):
        assert found[number] == ("UI_READ.GET_VBATT", ["no reply to this command was seen so far"])
    path = tshark.folder / "hunting.pcap"
    warned = tshark.run(path, "-2", "-Y", '_ws.expert.severity == "Warning"', "-T", "fields", "-e", "frame.number")
    assert warned.split() == [str(lost)]


def test_a_reply_of_another_size_is_marked(tshark: Tshark) -> None:
    """In the words of `decode`; one of the right size, an error, and a reply without its command are not."""
    capture = Capture(RAW_IP)
    stream = Connection(capture)
    expected = {}
    for counter, size in enumerate((0, 3, 4, 5)):
        stream.send(voltage(counter))
        reply = stream.receive(ev3proto.direct_reply(bytes(size), counter=counter).build())
        if size != 4:
            expected[reply] = [f"the command requests 4 bytes of memory, but this reply has {size}"]
    stream.send(voltage(9))
    stream.receive(bytes.fromhex("0300 0900 04"))
    stream.receive(bytes.fromhex("0300 0A00 02"))
    found = shown(tshark, capture, "-Y", "ev3.expert.other_size")
    assert {number: said for number, (_, said) in found.items()} == expected
    records = (each for each in ev3proto.read(tshark.folder / "hunting.pcap") if isinstance(each, ev3proto.Record))
    assert {each.number: [each.note] for each in records if each.note} == expected


READ = "99 1D {layer} {port} 00 00 01 {variable}"
"""INPUT_DEVICE.READY_SI of a port, into a variable."""


def asks(counter: int, memory: int, code: str) -> bytes:
    return with_length(struct.pack("<HBH", counter, 0, memory) + bytes.fromhex(code))


def test_values_of_one_operation_are_told_apart(tshark: Tshark) -> None:
    capture = Capture(RAW_IP)
    stream = Connection(capture)
    sensors = [READ.format(layer="00", port=f"0{port}", variable=f"{0x60 + 4 * port:02X}") for port in range(3)]
    first = stream.send(asks(1, 12, "".join(sensors)))
    three = stream.receive(ev3proto.direct_reply(struct.pack("<3f", 1, 12, 255), counter=1).build())
    chain = READ.format(layer="00", port="00", variable="60") + READ.format(layer="01", port="00", variable="64")
    stream.send(asks(2, 8, chain))
    layers = stream.receive(ev3proto.direct_reply(struct.pack("<2f", 1, 2), counter=2).build())
    stream.send(asks(3, 16, "B3 00 00 60 B3 00 01 64 81 01 68"))
    mixed = stream.receive(ev3proto.direct_reply(struct.pack("<iif", 90, -90, 7.5), counter=3).build())
    stream.send(asks(4, 5, "A8 00 01 60 61"))
    alone = stream.receive(ev3proto.direct_reply(bytes((5, 0, 0, 0, 9)), counter=4).build())
    found = shown(tshark, capture)
    assert found[first][0].endswith(" (+INPUT_DEVICE.READY_SI x 2)")
    assert found[three][0] == "reply to INPUT_DEVICE.READY_SI: no=0: 1, no=1: 12, no=2: 255"
    assert found[layers][0] == "reply to INPUT_DEVICE.READY_SI: layer=0: 1, layer=1: 2"
    assert found[mixed][0] == "reply to OUTPUT_GET_COUNT: nos=A: 90 degrees, nos=B: -90 degrees, vbatt=7.5 V"
    assert "=" in found[alone][0]
    tree = tshark.run(tshark.folder / "hunting.pcap", "-V", "-Y", f"frame.number == {three}")
    headings = [line.strip() for line in tree.splitlines() if "Answers:" in line]
    assert headings == [f"Answers: INPUT_DEVICE.READY_SI no={port}" for port in range(3)]


def transfer(counter: int, size: int, *pieces: int, closed: bool = False) -> Iterator[tuple[bool, bytes]]:
    """A download in pieces of these sizes, with replies: whether each message is a command, and its bytes."""
    handle = counter
    yield True, ev3proto.system_command("BEGIN_DOWNLOAD", counter=counter, reply=True, size=size, path="a.rtf").build()
    yield False, ev3proto.system_reply("BEGIN_DOWNLOAD", counter=counter, handle=handle).build()
    for number, piece in enumerate(pieces, counter + 1):
        sent = ev3proto.system_command(
            "CONTINUE_DOWNLOAD", counter=number, reply=True, handle=handle, data=bytes(piece)
        )
        yield True, sent.build()
        yield False, ev3proto.system_reply("CONTINUE_DOWNLOAD", counter=number, handle=handle).build()
    if closed:
        yield True, ev3proto.system_command("CLOSE_FILEHANDLE", counter=counter + 9, handle=handle).build()


def refused(counter: int) -> Iterator[tuple[bool, bytes]]:
    """A download to a path that the brick refuses."""
    yield True, ev3proto.system_command("BEGIN_DOWNLOAD", counter=counter, reply=True, size=9, path="a.rtf").build()
    yield False, bytes((6, 0, counter, 0, 0x05, 0x92, 0x06, 0xFF))


def test_a_file_of_another_size_than_announced_is_marked(tshark: Tshark) -> None:
    """Closed before its end, longer, or without a further message: in the words of `ev3proto files`."""
    capture = Capture(RAW_IP)
    places = []
    for number, moves in enumerate(
        (
            transfer(10, 9, 4, closed=True),
            transfer(20, 3, 2, 2),
            transfer(30, 9, 4, 3),
            transfer(40, 9, 4, 5, closed=True),
            transfer(50, 9, 9),
        )
    ):
        stream = Connection(capture, 50_000 + number)
        places.append([(stream.send if is_command else stream.receive)(data) for is_command, data in moves])
    found = shown(tshark, capture, "-Y", "ev3.expert.incomplete_file")
    assert {number: said[1][-1:] for number, said in found.items()} == {
        places[0][-1]: ["4 of 9 bytes were captured"],
        places[1][-2]: ["it has 3 bytes, but 4 were moved"],
        places[2][-1]: ["7 of 9 bytes were captured"],
    }


def test_faults_of_operations_and_mailboxes_are_marked(tshark: Tshark) -> None:
    """A zero at the end, by which the error reply is explained; what is too long for a mailbox."""
    capture = Capture(RAW_IP)
    stream = Connection(capture)
    never = "0x00 is ERROR, which the firmware never runs (E201)"
    zero = stream.send(asks(1, 0, "A6 00 01 00"))
    refused = stream.receive(bytes.fromhex("0300 0100 04"))
    long_name = stream.send(ev3proto.system.writemailbox("n" * 50, "hi").build())
    long_text = stream.send(ev3proto.system.writemailbox("abc", "x" * 250).build())
    right = stream.send(ev3proto.system.writemailbox("n" * 49, "x" * 249).build())
    variable = stream.send(asks(2, 0, "94 63 01"))
    found = shown(tshark, capture)
    assert found[zero][1] == [never]
    assert found[refused][1] == [
        f"the brick refused the command or failed to execute it; in the command, at offset 10: {never}"
    ]
    assert found[long_name][1] == ["the name has 50 characters; that of a mailbox has at most 49 (W804)"]
    assert found[long_text][1] == ["the message has 251 bytes, but a mailbox has room for only 250 (W804)"]
    assert found[right][1] == []
    assert "CMD of SOUND is GV(3), but must be a constant" in found[variable][0]


UNLOCK = b"GET /target?sn=0016530a0b0c VMTP1.0\nProtocol: EV3\n\n"


def test_conversations_have_the_numbers_of_records(tshark: Tshark) -> None:
    """In the order of their first messages; a connection that is made again between the same ends has its own."""
    capture = Capture(RAW_IP)
    one, other = Connection(capture, 50_001), Connection(capture, 50_002)
    one.send(UNLOCK)
    other.send(voltage(1))
    other.receive(volts(1))
    one.send(voltage(1))
    capture.add(segment(True, 0x1234_5678, flags=SYN, port=50_001))
    one.numbers[True] = 0x1234_5679
    one.send(UNLOCK)
    one.send(voltage(2))
    one.receive(volts(2))
    other.send(voltage(2))
    path = tshark.place(capture.data(), "numbers.pcap")
    records = {2: 1, 3: 1, 4: 2, 7: 3, 8: 3, 9: 1}
    for engine in ("builtin", "wireshark"):
        found = ev3proto.read(path, engine=engine, tshark=str(tshark.path))
        assert {each.numbers[-1]: each.connection for each in found if isinstance(each, ev3proto.Record)} == records
    for words in ((), ("-2",)):
        fields = ("-T", "fields", "-e", "frame.number", "-e", "ev3.connection", "-Y", "ev3.connection")
        lines = [line.split() for line in tshark.run(path, *words, *fields).splitlines()]
        assert {int(number): int(connection) for number, connection in lines} == records


def test_commands_on_a_connection_without_the_unlock_text_say_so(tshark: Tshark) -> None:
    """If its beginning is there, and the brick answers nothing; in `decode` by the same sentence."""
    said = "the connection begins without the unlock text (GET /target?sn=...): a brick ignores its commands"
    capture = Capture(RAW_IP)
    locked, unlocked, begun_before, answered = (Connection(capture, port) for port in range(50_001, 50_005))
    for stream in (locked, unlocked, answered):
        capture.add(segment(True, 0, flags=SYN, port=stream.ports[0]))
    unlocked.send(UNLOCK)
    places = [locked.send(tone(1)), locked.send(voltage(2))]
    first = answered.send(voltage(1))
    answered.receive(volts(1))
    for stream in (unlocked, begun_before, answered):
        stream.send(tone(2))
    places.append(locked.send(tone(3)))
    path = tshark.place(capture.data(), "hunting.pcap")
    trees = tshark.run(path, "-2", "-V").split("\nFrame ")
    assert [int(tree.partition(":")[0]) for tree in trees if f"[{said}]" in tree] == places
    # One pass does not know that the reply is still to come.
    notes = {each.number: each.note for each in ev3proto.read(path) if isinstance(each, ev3proto.Record)}
    assert [number for number, note in notes.items() if note] == sorted((*places, first))
    assert {notes[number] for number in places} == {said}


def test_ports_have_a_bit_each_and_no_number_below_zero_is_a_large_one(tshark: Tshark) -> None:
    capture = Capture(RAW_IP)
    stream = Connection(capture)
    stream.send(asks(1, 0, "A6 00 06"))
    stream.send(asks(2, 0, "A6 3F 01"))
    path = tshark.place(capture.data(), "ports.pcap")
    asked = [word for letter in "abcd" for word in ("-e", f"ev3.ports.{letter}")]
    words = ("-T", "fields", *asked, "-e", "ev3.output_start.layer", "-e", "ev3.argument.value")
    # Since 4.4, bits are words.
    lines = tshark.run(path, *words).replace("True", "1").replace("False", "0")
    assert lines.splitlines() == ["0\t1\t1\t0\t0\t", "1\t0\t0\t0\t\t-1"]
