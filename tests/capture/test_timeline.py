"""Timelines: marks from a dialogue made by hand, the chart in its three forms, and the command line."""

from __future__ import annotations

import json
import re
import struct
import xml.etree.ElementTree as ElementTree
import zlib
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import click
import pytest
from click.testing import CliRunner, Result

from ev3proto import (
    GV,
    Operation,
    SystemStatus,
    direct_command,
    direct_reply,
    operation,
    system_command,
    system_reply,
)
from ev3proto.capture.conversation import MOST_PENDING, Conversation
from ev3proto.capture.record import Announcement, Direction, Event, Record, Route, Skipped, TextKind
from ev3proto.capture.timeline import (
    Form,
    Lane,
    LaneKind,
    Mark,
    MarkState,
    Timeline,
    Window,
    collect,
    render,
)
from ev3proto.capture.timeline.chart import MOST_ROWS, WIDTH, specification, summary
from ev3proto.capture.timeline.collecting import (
    MOST_BRICKS,
    MOST_FILES,
    MOST_LANES,
    MOST_TROUBLES,
    clean,
)
from ev3proto.capture.timeline.marks import MOST_BINS, OTHERS, Bins
from ev3proto.cli.timeline import timeline as command
from ev3proto.extras import install_command
from ev3proto.schema.discovery import Beacon
from ev3proto.schema.frame import frame_reader
from ev3proto.tables.carriers import Carrier

CAPTURES = Path(__file__).parents[2] / "captures"
NOON = 1_767_268_800_000_000_000
"""2026-01-01T12:00:00Z, in nanoseconds."""

MS = 1_000_000
VOLTAGE = operation("UI_READ.GET_VBATT", GV(0))
TONE = operation("SOUND.TONE", VOLUME=5, FREQUENCY=440, DURATION=250)


class Brick:
    """A brick in a dialogue: its records have consecutive numbers and the given times."""

    def __init__(self, peer: str = "1.7", carrier: Carrier = Carrier.USB) -> None:
        self._conversation = Conversation(frame_reader())
        self._out = Route(carrier, "host", peer, Direction.SENT, None, peer)
        self._back = Route(carrier, peer, "host", Direction.RECEIVED, None, peer)
        self._number = 0

    def _record(self, frame: bytes, at_ms: float, route: Route) -> Record:
        self._number += 1
        return self._conversation.record(frame, (self._number,), NOON + round(at_ms * MS), route)

    def tells(self, at_ms: float, frame: bytes) -> Record:
        return self._record(frame, at_ms, self._out)

    def answers(self, at_ms: float, frame: bytes) -> Record:
        return self._record(frame, at_ms, self._back)

    def skipped(self, at_ms: float, reason: str) -> Skipped:
        return Skipped(b"\x01\x02\x03", 5, reason, 99, NOON + round(at_ms * MS), self._back)


def ask(counter: int, *operations: Operation) -> bytes:
    return direct_command(*operations, counter=counter, reply=True, global_size=4).build()


def volts(counter: int, value: float = 7.92) -> bytes:
    return direct_reply(struct.pack("<f", value), counter=counter).build()


def refusal(counter: int) -> bytes:
    return direct_reply(counter=counter, error=True).build()


def tone(counter: int) -> bytes:
    return direct_command(TONE, counter=counter).build()


def collected(events: list[Event], **options: Any) -> Timeline:
    timeline = collect(events, **options)
    assert timeline is not None
    return timeline


def files_of(timeline: Timeline) -> list[Mark]:
    return [mark for mark in timeline.marks if mark.lane.kind is LaneKind.FILES]


def rows_of(chart: dict[str, Any]) -> list[list[str]]:
    """The rows of each panel."""
    return [view["layer"][0]["encoding"]["y"]["scale"]["domain"] for view in chart["vconcat"] if len(view["layer"]) > 3]


def download(brick: Brick, at_ms: float, path: str, size: int = 6, moved: int = 6, counter: int = 50) -> list[Event]:
    """A file to the brick, in 10 ms."""
    begin = system_command("BEGIN_DOWNLOAD", counter=counter, reply=True, size=size, path=path)
    more = system_command("CONTINUE_DOWNLOAD", counter=counter + 1, reply=True, handle=3, data=bytes(moved))
    end = SystemStatus.END_OF_FILE if moved >= size else SystemStatus.SUCCESS
    return [
        brick.tells(at_ms, begin.build()),
        brick.answers(at_ms + 2, system_reply(begin.number, counter=counter, handle=3).build()),
        brick.tells(at_ms + 4, more.build()),
        brick.answers(at_ms + 10, system_reply(more.number, counter=counter + 1, status=end, handle=3).build()),
    ]


# Marks


def test_a_command_and_its_reply_are_one_mark() -> None:
    brick = Brick()
    timeline = collected([brick.tells(0, ask(42, VOLTAGE)), brick.answers(4.5, volts(42))])
    assert timeline.marks == [
        Mark(
            lane=Lane("USB 1.7", LaneKind.DIRECT, "UI_READ.GET_VBATT"),
            outcome=MarkState.ANSWERED,
            begin=0.0,
            end=0.0045,
            label="7.92 V",
            tip={
                "title": "UI_READ.GET_VBATT",
                "outcome": "answered",
                "at": "0.000000 s",
                "clock": "2026-01-01 12:00:00.000000 UTC",
                "brick": "USB 1.7",
                "answer after": "4.500 ms",
                "command": "UI_READ.GET_VBATT(VALUE=GV(0))",
                "reply": "VALUE=7.92 V",
                "command's packet": "1",
                "reply's packet": "2",
                "counter": "42",
            },
            number=1,
            latency=0.0045,
        )
    ]
    assert timeline.messages == 2
    assert (timeline.origin_ns, timeline.begin, timeline.end, timeline.bin_width) == (NOON, 0.0, 0.0045, 0)


def test_how_it_went() -> None:
    brick = Brick()
    events: list[Event] = [
        brick.answers(0, volts(7)),
        brick.tells(1, tone(1)),
        brick.tells(2, ask(2, VOLTAGE)),
        brick.answers(5, refusal(2)),
        brick.tells(6, ask(3, VOLTAGE)),
        brick.tells(7, tone(4)[:-1]),
        brick.skipped(8, "no frame starts here"),
    ]
    marks = collected(events).marks
    assert [(mark.outcome, mark.lane.kind, mark.lane.subject, mark.latency) for mark in marks] == [
        (MarkState.ORPHAN, LaneKind.DIRECT, "command not seen", None),
        (MarkState.SILENT, LaneKind.DIRECT, "SOUND.TONE", None),
        (MarkState.ERROR, LaneKind.DIRECT, "UI_READ.GET_VBATT", 0.003),
        (MarkState.UNANSWERED, LaneKind.DIRECT, "UI_READ.GET_VBATT", None),
        (MarkState.FAULTY, LaneKind.TROUBLE, "faulty frames", None),
        (MarkState.SILENT, LaneKind.DIRECT, "SOUND.TONE", None),
        (MarkState.SKIPPED, LaneKind.TROUBLE, "skipped bytes", None),
    ]
    assert [mark.label for mark in marks][1:3] == ["5 %, 440 Hz, 250 ms", "error"]
    assert marks[4].tip["fault"].startswith("at offset ")
    assert marks[6].tip == {
        "title": "3 bytes skipped",
        "outcome": "bytes skipped",
        "at": "0.008000 s",
        "clock": "2026-01-01 12:00:00.008000 UTC",
        "brick": "USB 1.7",
        "reason": "no frame starts here",
        "from": "1.7",
        "to": "host",
        "packet": "99",
        "not captured": "5 bytes",
    }


def test_an_unknown_message_is_a_faulty_frame() -> None:
    timeline = collected([Brick().tells(0, bytes.fromhex("04 00 01 00 77 00"))])
    assert [(mark.outcome, mark.tip["title"]) for mark in timeline.marks] == [(MarkState.FAULTY, "faulty frame")]


def test_several_operations_share_a_name() -> None:
    stop = operation("OUTPUT_STOP", LAYER=0, NOS=6, BRAKE=1)
    brick = Brick()
    frames = ((TONE, TONE), (TONE, stop), (TONE, stop, VOLTAGE))
    events: list[Event] = [
        brick.tells(number, direct_command(*operations, counter=number, global_size=4).build())
        for number, operations in enumerate(frames)
    ]
    events.append(brick.tells(3, bytes.fromhex("05000300800400")))
    subjects = [mark.lane.subject for mark in collected(events).marks]
    assert subjects == ["SOUND.TONE", "SOUND.TONE, OUTPUT_STOP", "SOUND.TONE + 2 more", "no operation"]


def test_files() -> None:
    brick = Brick()
    illegal = system_command("BEGIN_DOWNLOAD", counter=9, reply=True, size=3, path="/none/here.rtf")
    refused = system_reply(illegal.number, counter=9, status=SystemStatus.ILLEGAL_PATH, error=True, handle=255)
    events: list[Event] = [
        *download(brick, 0, "../prjs/a/a.rbf"),
        *download(brick, 20, "../prjs/b/b.rbf", size=8, counter=60),
        brick.tells(40, illegal.build()),
        brick.answers(41, refused.build()),
    ]
    timeline = collected(events)
    files = files_of(timeline)
    assert [(mark.outcome, mark.label, mark.begin, mark.end) for mark in files] == [
        (MarkState.MOVED, "../prjs/a/a.rbf", 0, 0.01),
        (MarkState.CUT_SHORT, "../prjs/b/b.rbf", 0.02, 0.03),
        (MarkState.ERROR, "/none/here.rtf", 0.04, 0.041),
    ]
    assert files[1].tip == {
        "title": "BEGIN_DOWNLOAD ../prjs/b/b.rbf",
        "outcome": "file not moved whole",
        "at": "0.020000 s",
        "took": "10.000 ms",
        "path": "../prjs/b/b.rbf",
        "moved": "6 of 8 bytes",
        "packets": "5 to 8",
    }
    assert files[2].tip["error"].startswith("ILLEGAL_PATH")
    # The command that was refused is an error; the file that was not transferred because of it is not another one.
    assert timeline.outcomes[MarkState.ERROR] == 1
    assert [mark.lane.subject for mark in timeline.marks][:3] == ["BEGIN_DOWNLOAD", "", "CONTINUE_DOWNLOAD"]


def announcement(peer: str = "192.0.2.10:3015", said: TextKind = TextKind.BEACON) -> Announcement:
    beacon = Beacon("0016530f0f0f", name="myEV3")
    route = Route(Carrier.WIFI, peer, "192.0.2.255:3015", Direction.RECEIVED, None, peer)
    return Announcement(said, beacon.build(), beacon, (1,), NOON, route)


def test_announcements_are_drawn_with_their_brick() -> None:
    brick = Brick("192.0.2.10:5555", Carrier.WIFI)
    timeline = collected([announcement(), brick.tells(1, tone(1))])
    mark = timeline.marks[0]
    assert (mark.outcome, mark.tip["title"]) == (MarkState.ANNOUNCED, "beacon")
    assert mark.tip["says"] == "serial 0016530f0f0f, port 5555, name myEV3, protocol EV3"
    chart = specification(timeline)
    assert chart["vconcat"][0]["title"]["text"] == "WiFi 192.0.2.10:5555"
    assert rows_of(chart) == [["0/beacon", "1/SOUND.TONE"]]


def test_a_filter_draws_whole_exchanges() -> None:
    def events() -> list[Event]:
        brick = Brick()
        return [
            brick.tells(0, ask(1, VOLTAGE)),
            brick.tells(1, tone(2)),
            brick.answers(4, volts(1)),
            brick.tells(5, ask(3, VOLTAGE)),
        ]

    commands = collected(events(), chosen=lambda record: record.direction is Direction.SENT)
    assert [mark.outcome for mark in commands.marks] == [MarkState.ANSWERED, MarkState.SILENT, MarkState.UNANSWERED]
    replies = collected(events(), chosen=lambda record: record.direction is Direction.RECEIVED)
    assert [(mark.outcome, mark.latency) for mark in replies.marks] == [(MarkState.ANSWERED, 0.004)]
    assert replies.messages == 1
    assert collect(events(), chosen=lambda _: False) is None


def test_a_part_of_a_capture() -> None:
    brick = Brick()
    events: list[Event] = [brick.tells(1000 * number, tone(number)) for number in range(10)]
    timeline = collected(events, window=Window(2.5, 5))
    assert [mark.begin for mark in timeline.marks] == [3.0, 4.0, 5.0]
    assert timeline.messages == 3
    assert (timeline.begin, timeline.end) == (2.5, 5.0)
    assert collect([brick.tells(0, tone(0))], window=Window(1, None)) is None


def test_a_file_that_began_before_the_window_is_drawn() -> None:
    brick = Brick()
    events = [*download(brick, 0, "../prjs/a/a.rbf"), *download(brick, 20, "../prjs/b/b.rbf", counter=60)]
    timeline = collected(events, window=Window(0.023, None))
    assert [(mark.label, mark.begin, mark.end) for mark in files_of(timeline)] == [("../prjs/b/b.rbf", 0.02, 0.03)]


def test_nothing_makes_no_timeline() -> None:
    assert collect([]) is None


# Limits


def polls(count: int, brick: Brick | None = None) -> Iterator[Event]:
    """A brick that is asked every 10 ms; each 10th answer is an error, each 25th command is never answered."""
    brick = brick or Brick()
    for number in range(count):
        yield brick.tells(10 * number, ask(number % 65536, VOLTAGE))
        if number % 25:
            reply = volts(number % 65536) if number % 10 else refusal(number % 65536)
            yield brick.answers(10 * number + 1 + number % 7, reply)


def test_beyond_the_limit_marks_are_counted() -> None:
    timeline = collected(list(polls(1000)), most_marks=100)
    lane = Lane("USB 1.7", LaneKind.DIRECT, "UI_READ.GET_VBATT")
    # 10 s in at most 600 bins: 50 ms each, 5 commands.
    assert timeline.bin_width == 0.05
    assert len(timeline.cells) == 200
    first = timeline.cells[lane, 0]
    assert (first.count, first.latencies, first.slowest) == (5, (0.002, 0.005), 8)
    assert dict(first.troubles) == {MarkState.UNANSWERED: 1}
    assert sum(cell.count for cell in timeline.cells.values()) == 1000
    # Only troubles are marks: 40 without a reply, and every 10th of the others.
    assert timeline.outcomes == {MarkState.ANSWERED: 880, MarkState.ERROR: 80, MarkState.UNANSWERED: 40}
    assert len(timeline.marks) == 120
    assert {mark.outcome for mark in timeline.marks} == {MarkState.ERROR, MarkState.UNANSWERED}
    cells = specification(timeline)["datasets"]["cells"]
    assert len(cells) == 200
    assert "darker means more in 50 ms. Problems are marked; the slowest answer" in summary(timeline)[1]
    assert "in packet 8" in cells[0]["tip"]["slowest answer"]


def test_at_the_limit_they_are_not() -> None:
    timeline = collected(list(polls(100)), most_marks=100)
    assert (len(timeline.marks), timeline.cells, timeline.bin_width) == (100, {}, 0)


def test_troubles_are_kept_up_to_a_limit() -> None:
    brick = Brick()
    events: list[Event] = [brick.skipped(number, "garbage") for number in range(MOST_TROUBLES + 30)]
    timeline = collected(events, most_marks=10)
    assert (len(timeline.marks), timeline.unshown) == (MOST_TROUBLES, 30)
    assert summary(timeline)[-1] == "30 marks of errors and files omitted: there are too many."


def test_bins_never_are_more_than_the_limit() -> None:
    bins = Bins()
    lane = Lane("USB 1.7", LaneKind.DIRECT, "SOUND.TONE")
    at = 0
    for step in range(3000):
        at += 1 << (step % 50)  # from a nanosecond to thirteen days
        bins.add(Mark(lane, MarkState.SILENT, at / 1e9, None, "", {}, 1))
        assert len(bins.cells) <= MOST_BINS + 1
    assert sum(cell.count for cell in bins.cells.values()) == 3000
    assert str(bins.width_ns).rstrip("0") in ("1", "5")


def test_lanes_and_bricks_are_limited() -> None:
    events: list[Event] = [
        Brick(f"{number}.1").tells(number, bytes((4, 0, 1, 0, 1, command)))
        for number in range(20)
        for command in range(0x30, 0x60)
    ]
    timeline = collected(events)
    assert len(timeline.bricks) == MOST_BRICKS + 1
    assert list(timeline.bricks)[-1] == OTHERS
    assert len({mark.lane for mark in timeline.marks}) <= MOST_LANES + MOST_BRICKS + 1
    assert max(map(len, rows_of(specification(timeline)))) <= 2 * MOST_ROWS


def test_files_are_limited() -> None:
    brick = Brick()
    events = [event for number in range(MOST_FILES + 7) for event in download(brick, 20 * number, "../prjs/a/a.rbf")]
    timeline = collected(events)
    assert (len(files_of(timeline)), timeline.unshown) == (MOST_FILES, 7)


def test_commands_that_wait_are_limited() -> None:
    brick = Brick()
    events: Iterator[Event] = (brick.tells(number, ask(number % 65536, VOLTAGE)) for number in range(MOST_PENDING + 9))
    timeline = collect(events, most_marks=10)
    assert timeline is not None
    assert timeline.outcomes == {MarkState.UNANSWERED: MOST_PENDING + 9}


# Layout


def test_places_and_labels() -> None:
    brick = Brick()
    events: list[Event] = [
        brick.tells(0, ask(1, VOLTAGE)),
        brick.answers(40, volts(1)),
        brick.tells(500, ask(2, VOLTAGE)),
        brick.answers(504, volts(2, 7.5)),
        brick.tells(505, ask(3, VOLTAGE)),
        brick.answers(506, volts(3, 7.25)),
        brick.tells(1000, tone(4)),
    ]
    timeline = collected(events)
    assert summary(timeline)[0] == "from 2026-01-01 12:00:00.000000 UTC, 1 s: 7 messages"
    chart = specification(timeline)
    panel, latency = chart["vconcat"]
    assert panel["title"]["subtitle"] == ["7 messages, median answer 4 ms, slowest 40 ms"]
    assert rows_of(chart) == [["0/UI_READ.GET_VBATT", "1/SOUND.TONE"]]
    marks = chart["datasets"]["marks"]
    placed = [(mark["t"], mark.get("e"), mark.get("ms"), mark.get("l"), mark.get("back")) for mark in marks]
    assert placed == [
        (0.0, 0.04, 40.0, "7.92 V", False),
        # Here the next symbol leaves no room for words.
        (0.5, 0.504, 4.0, None, None),
        (0.505, 0.506, 1.0, "7.25 V", False),
        # Here they are to the left: the picture ends to the right.
        (1.0, None, None, "5 %, 440 Hz, 250 ms", True),
    ]
    # In a narrower window the words would overlap the next mark, or the edge.
    assert [mark.get("w") for mark in marks] == [121, None, 109, 134]
    symbols = panel["layer"][-1]["encoding"]
    assert symbols["x"]["scale"]["domain"] == [-0.015, 1.015]
    assert symbols["color"]["legend"]["values"] == ["answered", "no reply asked for"]
    assert "answered: 3" in symbols["color"]["legend"]["labelExpr"]
    assert latency["layer"][-1]["encoding"]["y"]["scale"] == {"type": "log", "domain": [1 / 1.5, 60.0]}


def test_trouble_is_drawn_last() -> None:
    brick = Brick()
    events: list[Event] = [brick.tells(0, ask(1, VOLTAGE)), brick.answers(1, refusal(1)), brick.tells(2, tone(2))]
    timeline = collected(events)
    outcomes = [mark["o"] for mark in specification(timeline)["datasets"]["marks"]]
    assert outcomes == ["no reply asked for", "answered with an error"]
    assert summary(timeline)[0].endswith("3 messages, 1 answered with an error")


def test_files_at_the_same_time_have_rows_of_their_own() -> None:
    one, other = Brick("1.7"), Brick("1.7")
    timeline = collected([*download(one, 0, "a.rbf"), *download(other, 5, "b.rbf"), *polls(10, one)])
    files = [mark["row"] for mark in specification(timeline)["datasets"]["marks"] if mark.get("f")]
    assert len(set(files)) == 2
    assert {row.partition("/")[2] for row in files} == {""}


def test_a_capture_of_one_moment_has_a_width() -> None:
    chart = specification(collected([Brick().tells(0, tone(1))]))
    assert chart["vconcat"][0]["layer"][-1]["encoding"]["x"]["scale"]["domain"] == [-0.5, 0.5]


def test_texts_are_made_safe_and_short() -> None:
    assert clean("a\x1b[31m\u202eb\n") == "a\\u001b[31m\\u202eb\\u000a"
    assert clean("x" * 1000, 10) == "xxxxxxxxx…"
    assert len(clean("\0" * 1000, 50)) == 50


# The three forms


@pytest.fixture(scope="module")
def drawn() -> Timeline:
    brick = Brick()
    events: list[Event] = [
        brick.tells(0, ask(1, VOLTAGE)),
        brick.answers(4, volts(1)),
        brick.tells(5, tone(2)),
        brick.tells(6, ask(3, VOLTAGE)),
        *download(brick, 10, "../prjs/</script><script>alert(1)</script>.rbf"),
        brick.skipped(30, 'garbage "<img src=x onerror=alert(2)>"'),
    ]
    return collected(events)


NASTY = "</title></script><script>alert(0)</script>&\x00\u202e.pcap"


def test_svg(drawn: Timeline) -> None:
    svg = render(drawn, Form.SVG, NASTY)
    root = ElementTree.fromstring(svg)
    assert root.tag == "{http://www.w3.org/2000/svg}svg"
    tags = {element.tag.rpartition("}")[2] for element in root.iter()}
    assert not tags & {"script", "image", "foreignObject", "a"}
    texts = {"".join(element.itertext()) for element in root.iter("{http://www.w3.org/2000/svg}text")}
    assert texts >= {
        r"</title></script><script>alert(0)</script>&\u0000\u202e.pcap",
        "USB 1.7",
        "direct commands",
        "UI_READ.GET_VBATT",
        "7.92 V",
        "SOUND.TONE",
        "files",
        "…cript>alert(1)</script>.rbf",
        "answered: 3",
        "never answered: 1",
        "bytes skipped: 1",
        "seconds since the first message",
        "milliseconds from command to reply, linear scale",
    }


def test_png(drawn: Timeline) -> None:
    png = render(drawn, Form.PNG, "robot.pcapng")
    assert png.startswith(b"\x89PNG\r\n\x1a\n")
    width, height, depth, colours = struct.unpack(">IIBB", png[16:26])
    assert 2 * WIDTH < width < 4 * WIDTH
    assert 600 < height < 2000
    packed = b""
    at = 8
    while at < len(png):
        size, name = struct.unpack(">I4s", png[at : at + 8])
        packed += png[at + 8 : at + 8 + size] if name == b"IDAT" else b""
        at += size + 12
    channels = {2: 3, 6: 4}[colours]
    assert len(zlib.decompress(packed)) == height * (1 + width * channels * depth // 8)


class Page(HTMLParser):
    """The elements of a page with their attributes, and the text in each script."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.scripts: list[str] = []
        self.title = ""
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))
        if tag == "script":
            self.scripts.append("")

    def handle_data(self, data: str) -> None:
        if self.lasttag == "script" and self.scripts:
            self.scripts[-1] += data
        elif self.lasttag == "title":
            self.title += data


def test_page(drawn: Timeline) -> None:
    text = render(drawn, Form.HTML, NASTY).decode()
    page = Page(text)
    assert page.title.strip() == r"</title></script><script>alert(0)</script>&\u0000\u202e.pcap"
    # Nothing is fetched, and nothing of the capture became an element.
    tags = [tag for tag, _ in page.elements]
    assert tags.count("script") == 3
    assert not {"img", "link", "iframe", "object"} & set(tags)
    assert not [attributes for _, attributes in page.elements if {"src", "href"} & set(attributes)]
    policy = next(attributes["content"] for _, attributes in page.elements if "http-equiv" in attributes)
    assert policy is not None
    assert policy.startswith("default-src 'none';")
    assert not re.search(r"https?:", policy)
    chart = json.loads(page.scripts[0])
    assert [parameter["name"] for parameter in chart["params"]] == ["time", "picked", "margin", "kinds", "room"]
    marks = chart["datasets"]["marks"]
    assert [mark["tip"]["moved"] for mark in marks if mark.get("f")] == ["6 of 6 bytes"]
    assert [mark["tip"]["path"] for mark in marks if mark.get("f")] == [
        "../prjs/</script><script>alert(1)</script>.rbf"
    ]
    assert "vegaEmbed" in page.scripts[1]
    assert "vegaEmbed(place, chart" in page.scripts[2]


def test_names_of_kinds_are_not_clipped_off(drawn: Timeline) -> None:
    """They are left of the view; a view whose time can be dragged clips its contents."""
    root = ElementTree.fromstring(render(drawn, Form.SVG, "x"))
    clipped = {
        text
        for group in root.iter("{http://www.w3.org/2000/svg}g")
        if "clip-path" in group.attrib
        for text in group.itertext()
    }
    assert "7.92 V" in clipped
    assert not {"direct commands", "system commands", "files", "trouble"} & clipped


def test_views_that_share_the_time_have_it(drawn: Timeline) -> None:
    """Vega-Lite says nothing where a name belongs to a layer without times: it just does not move."""
    chart = json.loads(Page(render(drawn, Form.HTML, "x").decode()).scripts[0])
    layers = {layer["name"]: layer for view in chart["vconcat"] for layer in view["layer"] if "name" in layer}
    assert chart["params"][0]["views"] == ["rows0", "latency"]
    for name in chart["params"][0]["views"]:
        assert layers[name]["encoding"]["x"]["field"] == "t"


@pytest.mark.parametrize("form", list(Form))
def test_the_same_input_gives_the_same_bytes(form: Form) -> None:
    first, second = (render(collected(list(polls(60))), form, "robot.pcapng") for _ in range(2))
    assert first == second


@pytest.mark.parametrize("form", list(Form))
def test_counts_are_drawn_in_all_forms(form: Form) -> None:
    data = render(collected(list(polls(300)), most_marks=50), form, "robot.pcapng")
    assert len(data) > 10_000
    if form is Form.SVG:
        assert b"marks in 5 ms" in data


# The command line


def run(*words: str | Path) -> Result:
    group = click.Group(commands=[command])
    return CliRunner().invoke(group, ["timeline", *map(str, words)], prog_name="ev3proto")


def test_a_real_capture(tmp_path: Path) -> None:
    target = tmp_path / "wifi.svg"
    done = run(CAPTURES / "wifi.pcapng", "-o", target)
    assert (done.exit_code, done.output) == (0, f"{target}: written\n")
    text = target.read_text()
    for words in ("wifi.pcapng", "WiFi 192.0.2.10:5555", "answered with an error: 2", "never answered: 1", "beacon"):
        assert words in text


def test_a_part_of_it(tmp_path: Path) -> None:
    target = tmp_path / "part.svg"
    done = run(CAPTURES / "wifi.pcapng", "-o", target, "--from", "5.15", "--to", "5.2")
    assert done.exit_code == 0
    assert "SOUND.TONE" not in target.read_text()
    assert "OUTPUT_STOP" in target.read_text()


def test_a_filter_keeps_replies_with_their_commands(tmp_path: Path) -> None:
    target = tmp_path / "chosen.svg"
    done = run(CAPTURES / "usb.pcapng", "-o", target, "--filter", "kind==direct-command && op==UI_READ.GET_VBATT")
    assert (done.exit_code, done.output) == (0, f"{target}: written\n")
    text = target.read_text()
    assert "7.92 V" in text
    assert "answered with an error: 1" in text
    assert "never answered" not in text


@pytest.mark.parametrize(
    ("words", "status", "complaint"),
    [
        (("-o", "x.pdf"), 2, "x.pdf: unknown suffix; expected one of .html, .svg, .png, .json"),
        (("-o", "robot"), 2, ".html, .svg, .png"),
        ((), 2, "Missing option '-o'"),
        (("-o", "no-such-folder/x.svg"), 1, "there is no folder no-such-folder"),
        (("-o", "x.svg", "--from", "3", "--to", "3"), 2, "--from 3 must be less than --to 3"),
        (("-o", "x.svg", "--from", "nan"), 2, "nan is not a finite number"),
        (("-o", "x.svg", "--to", "1e300"), 2, "1e+300 is not in the range 0<=x<=1000000000"),
        (("-o", "x.svg", "--from", "100"), 1, "no frame found from 100 s"),
    ],
)
def test_complaints(
    words: tuple[str, ...], status: int, complaint: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    done = run(CAPTURES / "usb.pcapng", *words)
    assert (done.exit_code, complaint in done.output) == (status, True), done.output
    assert list(tmp_path.iterdir()) == []


def test_a_capture_without_frames(tmp_path: Path) -> None:
    capture = tmp_path / "empty.pcap"
    capture.write_bytes(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 1))
    done = run(capture, "-o", tmp_path / "x.html")
    assert (done.exit_code, done.output) == (1, f"{capture}: no frame in 0 packets\n")
    assert list(tmp_path.iterdir()) == [capture]


def test_a_file_that_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "x.svg").mkdir()
    assert run(CAPTURES / "usb.pcapng", "-o", tmp_path / "x.svg").exit_code == 2
    done = run(CAPTURES / "usb.pcapng", "-o", "/proc/x.svg")
    assert done.exit_code == 1
    assert "/proc/x.svg: cannot be written: " in done.output


def test_the_command_without_the_library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ev3proto.capture.timeline.chart_files.LIBRARY", "no_such_library")
    done = run(CAPTURES / "usb.pcapng", "-o", tmp_path / "x.svg")
    assert done.exit_code == 1
    assert f"vl-convert-python, which is not installed: {install_command('plot')}\n" in done.output


def test_a_text_without_times_is_drawn_in_its_order(tmp_path: Path) -> None:
    log, path = tmp_path / "robot.log", tmp_path / "robot.svg"
    log.write_text("sent 09 00 01 00 00 04 00 81 01 60 00\nreceived 07 00 01 00 02 00 00 00 41\n")
    done = CliRunner().invoke(command, [str(log), "-o", str(path)])
    assert (done.exit_code, done.output) == (0, f"{path}: written\n")
    svg = path.read_text()
    assert "order: the lines of the text, which has no times" in svg
    assert "in their order, without times: 2 messages" in svg
    assert "UI_READ" in svg
    for invented in ("seconds", " ms<", " s<", "median answer", "2026-01-01", "How long a brick took"):
        assert invented not in svg, invented


def test_a_part_of_a_text_without_times_is_told_in_lines(tmp_path: Path) -> None:
    log, path = tmp_path / "robot.log", tmp_path / "robot.svg"
    log.write_text("sent 09 00 01 00 00 04 00 81 01 60 00\nreceived 07 00 01 00 02 00 00 00 41\n" * 3)
    said = f"{log}: has no times: --from and --to count its lines\n"
    done = run(log, "-o", path, "--from", "3", "--to", "4")
    assert (done.exit_code, done.output) == (0, f"{said}{path}: written\n")
    assert "in their order, without times: 2 messages" in path.read_text()
    done = run(log, "-o", path, "--from", "7")
    assert (done.exit_code, done.output) == (
        1,
        f"{said}{log}: no frame found from line 7\n",
    )


def test_the_chart_for_other_tools(tmp_path: Path) -> None:
    target = tmp_path / "wifi.json"
    done = run(CAPTURES / "wifi.pcapng", "-o", target)
    assert (done.exit_code, done.output) == (0, f"{target}: written\n")
    chart = json.loads(target.read_text(encoding="utf-8"))
    assert chart["title"]["text"] == "wifi.pcapng"
    assert chart["$schema"] == "https://vega.github.io/schema/vega-lite/v6.1.json"
