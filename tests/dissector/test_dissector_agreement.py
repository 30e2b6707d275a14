"""The dissector and the codec agree: tshark shows of a frame what `ev3proto.parse` and `Dialogue` read in it.

One side comes through tshark, the dissector and pyshark. The other side gets the frames without the dissector: from
tshark's fields of the lower carrier, or from the strategies that drew them.
"""

from __future__ import annotations

import math
import random
import re
import struct
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cache
from itertools import groupby, pairwise
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from hypothesis import strategies as st
from support.boundaries import boundaries
from support.dissected import Follower, Frame, difference, is_message, packets, shown, unshown
from support.effort import THOROUGH, effort
from support.frames import Segment, drawn, tcp_capture
from support.packets import MILLISECONDS_EACH
from support.wireshark import Tshark

import ev3proto
from ev3proto import GV, LV
from ev3proto.messages import DaisyReply, DirectCommand, Message, Operation, SystemCommand, SystemReply, Variable
from ev3proto.schema.discovery import Unlock
from ev3proto.schema.header import COMMAND_HEADER_SIZE, HEADER_SIZE
from ev3proto.tables import operations
from ev3proto.tables.declaration import DIALECTS, Direction, Parameter
from ev3proto.tables.discovery import ACCEPT, TCP_PORT, UNLOCK_REQUEST
from ev3proto.tables.frame import MAX_FRAME, MessageType
from ev3proto.testing import daisy_messages, frames, raw_operations, system_replies, values_for

CAPTURES = Path(__file__).parents[2] / "captures"
LESSON = CAPTURES / "lesson-02.log"


def check(tshark: Tshark, capture: Path, expected: Sequence[Frame], *words: str, dialect: str = "official") -> None:
    """Compares all messages that tshark shows in a capture with its frames."""
    layers = packets(tshark, capture, *words)
    found = [(number, layer) for number, layer in layers if is_message(layer)]
    follower = Follower(dialect, passes=2 if "-2" in words else 1)
    records = follower.follow(expected)
    for (number, layer), record, frame in zip(found, records, expected, strict=False):
        told = difference(shown(number, layer), record) or unshown(layer, frame.data + frame.padding)
        assert not told, f"packet {frame.packet}, frame {frame.data.hex(' ')}\n{told}"
    assert [number for number, _ in found] == [frame.packet for frame in expected]


# Frames in captures


class Pieces:
    """A stream in one direction, piece by piece; texts before the frames are skipped."""

    def __init__(self) -> None:
        self.decoder = ev3proto.Decoder(strict=False)

    def feed(self, data: bytes) -> Iterator[bytes]:
        """Returns the frames that are complete with this piece."""
        if data.startswith(UNLOCK_REQUEST.encode()):
            data = data[Unlock.read(data)[1] :]
        elif data.startswith(ACCEPT):
            data = data.removeprefix(ACCEPT).removeprefix(b"\0")
        return (message.build() for message in self.decoder.feed(data))


Row = list[str]

Way = tuple[str, bool]
"""A TCP stream, and whether it is the host's side of it."""


def rows(tshark: Tshark, capture: Path, display_filter: str, *fields: str, words: Iterable[str] = ()) -> Iterator[Row]:
    """Fields of the packets that match a filter, read without the dissector."""
    arguments = ["-T", "fields", "-Y", display_filter, *words]
    for name in ("frame.number", "frame.time_relative", *fields):
        arguments += ["-e", name]
    for line in tshark.run(capture, *arguments, dissector=False).splitlines():
        yield line.split("\t")


def over_tcp(tshark: Tshark, capture: Path) -> Iterator[Frame]:
    """Segments in the order of their numbers; repeated ones are skipped, early ones wait."""
    streams: defaultdict[Way, Pieces] = defaultdict(Pieces)
    behind: dict[Way, int] = {}
    early: dict[tuple[Way, int], bytes] = {}
    fields = ("tcp.stream", "tcp.dstport", "tcp.seq", "tcp.payload")
    words = ("-d", f"tcp.port=={TCP_PORT},data")
    for number, time, stream, port, sequence, payload in rows(tshark, capture, "tcp.len > 0", *fields, words=words):
        way = stream, int(port) == TCP_PORT
        early.setdefault((way, int(sequence)), bytes.fromhex(payload))
        at = behind.setdefault(way, int(sequence))
        while (piece := early.pop((way, at), None)) is not None:
            at += len(piece)
            behind[way] = at
            for data in streams[way].feed(piece):
                yield Frame(int(number), 1000 * float(time), way[1], data, talk=stream)
    assert set(early) <= {(way, number) for way, number in early if number < behind[way]}


def over_usb(devices: str) -> Callable[[Tshark, Path], Iterator[Frame]]:
    """Reports of some devices, truncated by the length field."""

    def read(tshark: Tshark, capture: Path) -> Iterator[Frame]:
        fields = ("usb.src", "usb.dst", "usb.capdata", "usbhid.data")
        for number, time, source, target, *data in rows(tshark, capture, devices, *fields):
            report = bytes.fromhex("".join(data))
            size = 2 + int.from_bytes(report[:2], "little")
            device = (target if source == "host" else source).rpartition(".")[0]
            frame, padding = report[:size], report[size:]
            yield Frame(int(number), 1000 * float(time), source == "host", frame, padding, talk=device)

    return read


def over_rfcomm(*words: str) -> Callable[[Tshark, Path], Iterator[Frame]]:
    """The contents of the serial port's channel; the words make tshark recognise RFCOMM."""

    def read(tshark: Tshark, capture: Path) -> Iterator[Frame]:
        streams: dict[bool, Pieces] = {True: Pieces(), False: Pieces()}
        fields = ("hci_h4.direction", "btspp.data", "data.data")
        channel = "btrfcomm.dlci == 2 && btrfcomm.len > 0"
        for number, time, direction, *data in rows(tshark, capture, channel, *fields, words=words):
            from_host = int(direction, 0) == 0
            for frame in streams[from_host].feed(bytes.fromhex("".join(data))):
                yield Frame(int(number), 1000 * float(time), from_host, frame)

    return read


class Carrier(NamedTuple):
    """How to extract the frames of a capture, their number, and the arguments with which tshark sees them."""

    frames: Callable[[Tshark, Path], Iterator[Frame]]
    total: int
    words: tuple[str, ...] = ()


LATE = ("-d", "btl2cap.cid==0x41,btrfcomm", "-d", "btl2cap.cid==0x51,btrfcomm")
"""A capture that begins after the search for the serial port does not say which channels are RFCOMM."""

CARRIERS = {
    "bluetooth.log": Carrier(over_rfcomm(), 24),
    "bluetooth.pcapng": Carrier(over_rfcomm(*LATE), 13),
    "conformance.pcapng": Carrier(over_tcp, 600),
    "daisy.pcap": Carrier(over_usb("usb.data_len == 64"), 8),
    "ev3_dc.pcap": Carrier(over_tcp, 188),
    "senders.pcapng": Carrier(over_tcp, 237),
    "usb-bootloader.pcapng": Carrier(over_usb("usb.data_len == 1024"), 16),
    "usb-plugged.pcap": Carrier(over_usb('usb.data_len == 1024 && usb.addr == "1.7.1"'), 9),
    "usb-windows.pcap": Carrier(over_usb("usb.data_len == 1024"), 15),
    "usb.pcapng": Carrier(over_usb("usb.data_len == 1024"), 25),
    "wifi-long.pcapng": Carrier(over_tcp, 10),
    "wifi-reordered.pcap": Carrier(over_tcp, 14, ("-o", "tcp.reassemble_out_of_order:TRUE")),
    "wifi.pcapng": Carrier(over_tcp, 42),
}


def test_all_captures_are_read() -> None:
    others = {"README.md", "make.py", LESSON.name, "real-bricks.log"}
    assert {path.name for path in CAPTURES.iterdir() if path.is_file()} - others == set(CARRIERS)


@pytest.mark.parametrize("name", CARRIERS)
def test_captures(tshark: Tshark, name: str) -> None:
    """Read once and read twice."""
    capture, carrier = CAPTURES / name, CARRIERS[name]
    found = list(carrier.frames(tshark, capture))
    for passes in ((), ("-2",)):
        check(tshark, capture, found, *carrier.words, *passes)


# Frames in a connection of our own


def in_segments(said: Iterable[tuple[bool, bytes]], chance: random.Random) -> tuple[list[Segment], list[Frame]]:
    """Frames of both sides in segments: whole or split anywhere, alone or with others in the same direction."""
    segments: list[Segment] = []
    found: list[Frame] = []
    for from_host, group in groupby(said, lambda one: one[0]):
        run = [data for _, data in group]
        ends = {sum(map(len, run[: index + 1])) for index in range(len(run))}
        total = b"".join(run)
        cuts = {end for end in ends if chance.random() < 0.5}
        cuts |= {chance.randrange(1, len(total)) for _ in range(chance.choice((0, 0, 1, len(run))))}
        edges = sorted({0, *cuts, len(total)})
        at = 0
        for start, end in pairwise(edges):
            segments.append(Segment(from_host, total[start:end]))
            while run and at + len(run[0]) <= end:
                at += len(run[0])
                milliseconds = MILLISECONDS_EACH * (len(segments) - 1)
                found.append(Frame(len(segments), milliseconds, from_host, run.pop(0)))
    return segments, found


def test_lesson(tshark: Tshark) -> None:
    """The frames of a lesson, in their order."""
    lines = re.findall(r"(Sent|Recv) 0x\|([0-9A-F:|]+)\|$", LESSON.read_text(encoding="utf-8"), re.MULTILINE)
    said = [(way == "Sent", bytes.fromhex(re.sub("[:|]", " ", data))) for way, data in lines]
    segments, found = in_segments(said, random.Random(0))
    assert len(found) == len(said)
    for words in ((), ("-2",)):
        check(tshark, tshark.place(tcp_capture(segments), "lesson.pcap"), found, *words)


# Frames drawn from the tables

DRAWN = {"official": effort(500, 3000), "xtended": effort(60, 300), "compat": effort(60, 300)}
ASKING = {"official": effort(150, 800), "xtended": effort(30, 100), "compat": effort(30, 100)}
AT_ONCE = 16
"""Operations that are drawn together: hypothesis ends a draw that gets too long."""


def names_of(dialect: str) -> list[str]:
    """The operations of LEGO's firmware, and those that others have alone; all for thorough tests."""
    official = operations("official")
    return [
        name
        for name, it in operations(dialect).items()
        if dialect == "official" or THOROUGH or name not in official or it.parameters != official[name].parameters
    ]


@cache
def of_every_operation(dialect: str) -> list[bytes]:
    """A direct command for each operation of a firmware, which requests as much memory as possible."""
    strategies = [raw_operations(dialect, name) for name in names_of(dialect)]
    bodies: list[bytes] = []
    for start in range(0, len(strategies), AT_ONCE):
        (found,) = drawn(st.tuples(*strategies[start : start + AT_ONCE]), 2)[1:]
        bodies += found
    return [_direct(counter, body) for counter, body in enumerate(bodies)]


def _direct(counter: int, operation: bytes) -> bytes:
    size = COMMAND_HEADER_SIZE + len(operation)
    assert size <= MAX_FRAME
    memory = MAX_FRAME - HEADER_SIZE
    return struct.pack("<HHBH", size - 2, counter, MessageType.DIRECT_COMMAND_REPLY, memory) + operation


@cache
def answers() -> dict[int, list[SystemReply]]:
    """Replies to system commands by the command's number."""
    found: dict[int, list[SystemReply]] = {}
    for reply in drawn(system_replies(), 500):
        found.setdefault(reply.number, []).append(reply)
    return found


@cache
def chained() -> list[bytes]:
    """Daisy replies."""
    return [it.build() for it in drawn(daisy_messages(), 200) if isinstance(it, DaisyReply)]


PLACES = st.builds(
    Variable,
    st.sampled_from(("global", "global", "global", "local")),
    st.integers(0, 72),
    handle=st.integers(0, 7).map(lambda it: it == 7),
    address=st.integers(0, 7).map(lambda it: it == 7),
)
LENGTHS = st.sampled_from((-1, -3, 0, 1, 2, 5, 20, 127)) | PLACES


@st.composite
def asking(draw: st.DrawFn, dialect: str) -> bytes:
    """Direct commands whose operations have outputs, most of them inside the requested memory."""
    chosen: list[Operation] = []
    with_outputs = [it for it in operations(dialect).values() if any(map(_gives, it.parameters))]
    for declaration in draw(st.lists(st.sampled_from(with_outputs), min_size=1, max_size=4)):
        values: list[Any] = []
        lengths = {parameter.length for parameter in declaration.parameters}
        for parameter in declaration.parameters:
            if parameter.is_output:
                values.append(draw(PLACES))
            elif parameter.counts and _gives(parameter):
                values.append(draw(st.lists(PLACES, max_size=4)))
            elif parameter.name in lengths:
                values.append(draw(LENGTHS))
            else:
                values.append(draw(values_for(parameter)))
                if parameter.is_list and not parameter.counts:
                    values[-2] = len(values[-1])
        chosen.append(ev3proto.operation(declaration.name, *values, dialect=dialect))
    size, counter = draw(st.integers(0, 80)), draw(st.integers(0, 0xFFFF))
    return ev3proto.direct_command(*chosen, counter=counter, reply=True, global_size=size).build()


def _gives(parameter: Parameter) -> bool:
    return parameter.is_output or (parameter.counts and parameter.elements is not Direction.IN)


TONE = bytes.fromhex("0e002a0080000094010182b80182e803")


class Conversation:
    """A host and a brick with a drawn dialogue; the brick answers almost everything, in order."""

    def __init__(self, dialect: str, seed: int) -> None:
        self.chance = random.Random(seed)
        self.dialect = dialect
        self.said: list[tuple[bool, bytes]] = []
        self.waiting: list[bytes] = []

    def say(self, frames: Iterable[bytes]) -> None:
        """Frames as they were drawn; replies among them are the brick's, and belong to no command."""
        for data in frames:
            message = ev3proto.parse(data, dialect=self.dialect)
            assert message.type is not None
            if isinstance(message, SystemCommand | SystemReply) and "handle" in message.fields:
                # Few handles, so that files are continued.
                handle = int(message.fields["handle"]) % 3
                data = replace(message, fields={**message.fields, "handle": handle}).build()
            self.said.append((message.type.is_command, data))
            if message.wants_reply and self.chance.random() < 0.95:
                self.waiting.append(self.reply(message))
            if self.chance.random() < 0.7:
                self.answer()
        self.answer()

    def answer(self) -> None:
        """The brick sends all outstanding replies."""
        self.said += [(False, data) for data in self.waiting]
        self.waiting.clear()

    def reply(self, message: Message) -> bytes:
        """The reply to a command: usually of the requested size."""
        chance, counter = self.chance, message.counter
        if isinstance(message, DirectCommand):
            size = message.global_size if chance.random() < 0.9 else chance.randrange(64)
            error = chance.random() < 0.1
            memory = b"" if error else chance.randbytes(min(size, MAX_FRAME - HEADER_SIZE))
            return ev3proto.direct_reply(memory, counter=counter, error=error).build()
        if isinstance(message, SystemCommand):
            reply = replace(chance.choice(answers()[message.number]), counter=counter)
            if "handle" in reply.fields:
                reply = replace(reply, fields={**reply.fields, "handle": int(reply.fields["handle"]) % 3})
            return reply.build()
        data = chance.choice(chained())
        return data[:2] + counter.to_bytes(2, "little") + data[4:]


def agree(tshark: Tshark, dialect: str, drawn_frames: Iterable[bytes], *words: str) -> None:
    """Puts frames into their own connection, and compares what is shown of them and of their replies.

    It begins with a tone: not every frame claims a connection. The seed decides where frames are split.
    """
    conversation = Conversation(dialect, seed=1)
    conversation.say([TONE, *drawn_frames])
    segments, found = in_segments(conversation.said, conversation.chance)
    words = ("-o", f"ev3.firmware:{dialect}", *words)
    check(tshark, tshark.place(tcp_capture(segments), "drawn.pcap"), found, *words, dialect=dialect)


def test_every_letter(tshark: Tshark) -> None:
    letters = "".join(map(chr, range(256)))
    frames_of_all = [
        ev3proto.direct_command(ev3proto.operation("COM_SET.SET_BRICKNAME", letters[1:])).build(),
        *(
            ev3proto.direct_command(ev3proto.operation("COM_SET.SET_BRICKNAME", f"a{letter}b")).build()
            for letter in letters[1:]
        ),
        ev3proto.system_reply("LIST_FILES", list_size=len(letters), handle=0, list=letters).build(),
    ]
    agree(tshark, "official", frames_of_all)


def test_floats(tshark: Tshark) -> None:
    """Numbers at the limits of their types, because the dissector assembles them itself."""
    edges = [0.0, -0.0, 1e-45, 1.1754942e-38, 1.17549435e-38, 0.1, 1.0, 16777215.0, 3.4028235e38]
    values = [*edges, *(-edge for edge in edges), math.inf, -math.inf, math.nan]
    moves = (ev3proto.operation("MOVEF_F", value, LV(0)) for value in values)
    agree(tshark, "official", [ev3proto.direct_command(*moves).build()])


@pytest.mark.parametrize("dialect", DIALECTS)
def test_every_operation(tshark: Tshark, dialect: str) -> None:
    frames_of_all = of_every_operation(dialect)
    found = [ev3proto.parse(data, dialect=dialect) for data in frames_of_all]
    assert {
        it.full_name for message in found if isinstance(message, DirectCommand) for it in message.operations
    } == set(names_of(dialect))
    agree(tshark, dialect, frames_of_all)


@pytest.mark.parametrize("dialect", DIALECTS)
def test_boundaries(tshark: Tshark, dialect: str) -> None:
    """Of every kind of parameter; `tests/schema/test_boundaries.py` holds the other readers to what is expected."""
    cases = [case for case in boundaries() if case.raw is not None and case.dialect == dialect]
    if cases:
        agree(tshark, dialect, [case.frame for case in cases])


@pytest.mark.parametrize("dialect", DIALECTS)
def test_drawn_frames(tshark: Tshark, dialect: str) -> None:
    agree(tshark, dialect, drawn(frames(dialect), DRAWN[dialect]))


@pytest.mark.parametrize("dialect", DIALECTS)
def test_reply_values(tshark: Tshark, dialect: str) -> None:
    agree(tshark, dialect, drawn(asking(dialect), ASKING[dialect]), "-2")


def test_a_length_counts_for_its_own_operation(tshark: Tshark) -> None:
    """The first name has two bytes and is not returned; only the brick knows the length of the second."""
    name = "INPUT_DEVICE.GET_NAME"
    asked = (ev3proto.operation(name, 0, 0, 2, LV(0)), ev3proto.operation(name, 0, 0, GV(0), GV(1)))
    command = ev3proto.direct_command(*asked, reply=True, global_size=8, local_size=2)
    reply = ev3proto.direct_reply(b"\x07ABCDEF\0")
    said = [(True, command.build()), (False, reply.build())]
    segments, found = in_segments(said, random.Random(0))
    check(tshark, tshark.place(tcp_capture(segments), "drawn.pcap"), found)


def test_a_frame_that_has_another_and_a_header_in_its_first_packet(tshark: Tshark) -> None:
    """One header does not confirm the inner frame while the outer one may have no fault: two would."""
    # INIT_BYTES of six values: 83 0A00937F is one, and the length, counter and type of the inner frame begin in it.
    inner = bytes.fromhex("0a00937f 00 0000 83020000 80")
    values = b"\x83" + inner + bytes.fromhex("83 02000000")
    data = bytes.fromhex("2f 40 06") + values + TONE[7:]
    frame = struct.pack("<HHBH", 5 + len(data), 7, 0x80, 6 << 10) + data
    assert ev3proto.parse(inner).build() == inner
    parts = (TONE, frame[:-9], frame[-9:])
    capture = tshark.place(tcp_capture(Segment(True, part) for part in parts), "inner.pcap")
    found = [Frame(1, 0.0, True, TONE), Frame(3, 2.0 * MILLISECONDS_EACH, True, frame)]
    for words in ((), ("-2",)):
        check(tshark, capture, found, *words)
