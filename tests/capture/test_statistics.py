"""Statistics: every number worked out by hand, and memory that does not grow with the capture."""

from __future__ import annotations

import json
import random
import subprocess
from collections.abc import Iterable
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from support.cli import run_ev3proto_text

import ev3proto
from ev3proto import GV
from ev3proto.capture import Announcement, Carrier, Direction, Event, Record, Route, Skipped, TextKind, read
from ev3proto.capture import statistics as module
from ev3proto.capture.latencies import ACCURACY, EXACT, Latencies
from ev3proto.capture.record import Outcome
from ev3proto.capture.statistics import MOST_LISTED, MOST_PEERS, MOST_PENDING, Noted, Statistics, Summary
from ev3proto.dialogue import Transfer
from ev3proto.messages import Message
from ev3proto.schema.frame import frame_reader

CAPTURES = Path(__file__).parents[2] / "captures"
MADE = sorted(
    path.name for path in CAPTURES.iterdir() if path.suffix in (".pcap", ".pcapng") or path.name == "bluetooth.log"
)
START = 1_767_261_600_000_000_000
NO_TIME = Route(Carrier.USB, "host", "1.7", Direction.SENT, None, "1.7")


def seen(
    message: Message | bytes,
    number: int = 1,
    milliseconds: float = 0,
    *,
    peer: str = "1.7",
    request: Record | None = None,
    transfer: Transfer | None = None,
) -> Record:
    frame = message if isinstance(message, bytes) else message.build()
    route = Route(Carrier.USB, "host", peer, None, None, peer)
    time_ns = START + round(milliseconds * 1e6)
    if request is not None:
        request.answered = Outcome(time_ns, failed=False)
    return Record(frame, (number,), time_ns, route, frame_reader(), request, transfer)


def summary(events: Iterable[Event]) -> Summary:
    statistics = Statistics()
    for event in events:
        statistics.add(event)
    return statistics.summary()


def ask(counter: int = 1) -> Message:
    return ev3proto.direct_command(
        ev3proto.operation("UI_READ.GET_VBATT", GV(0)), counter=counter, reply=True, global_size=4
    )


def answer(counter: int = 1, *, error: bool = False) -> Message:
    return ev3proto.direct_reply(b"" if error else bytes(4), counter=counter, error=error)


def test_packets_that_are_not_in_the_order_of_their_times() -> None:
    whole = summary([seen(ask(), 1, 500), seen(ask(2), 2, 2000), seen(ask(3), 3, 0)]).whole
    assert (whole.first, whole.last) == ("2026-01-01T10:00:00.000000Z", "2026-01-01T10:00:02.000000Z")
    assert whole.seconds == 2.0


def test_messages_operations_and_latencies() -> None:
    tone = ev3proto.operation("SOUND.TONE", 5, 440, 250)
    play = seen(ev3proto.direct_command(tone, ev3proto.operation("SOUND_READY"), tone), 1, 0)
    first, second, third = seen(ask(1), 2, 10), seen(ask(2), 4, 20), seen(ask(3), 6, 30)
    events = [
        play,
        first,
        seen(answer(1), 3, 14, request=first),
        second,
        seen(answer(2, error=True), 5, 22, request=second),
        third,
        seen(answer(77), 7, 40),
    ]
    found = summary(events)
    whole = found.whole
    assert (whole.messages.messages, whole.messages.bytes) == (7, sum(len(event.frame) for event in events))
    assert {kind: amount.messages for kind, amount in whole.kinds.items()} == {"direct-command": 4, "direct-reply": 3}
    assert whole.kinds["direct-reply"].bytes == 9 + 5 + 9
    assert (whole.errors, whole.orphans, whole.unanswered, whole.faults) == (1, 1, 1, 0)
    assert whole.latency is not None
    assert (whole.latency.count, whole.latency.exact) == (2, True)
    assert (whole.latency.min, whole.latency.median, whole.latency.max) == (0.002, 0.002, 0.004)
    voltage, sound, ready = whole.operations
    assert (voltage.name, voltage.kind) == ("UI_READ.GET_VBATT", "direct")
    assert (voltage.uses, voltage.commands, voltage.replies, voltage.errors, voltage.unanswered) == (3, 3, 2, 1, 1)
    # Three commands of 10 bytes, a reply of 9, an error of 5.
    assert voltage.bytes == 3 * 10 + 9 + 5
    assert (ready.name, ready.uses, ready.commands, ready.latency) == ("SOUND_READY", 1, 1, None)
    assert (sound.name, sound.uses, sound.commands, sound.bytes) == ("SOUND.TONE", 2, 1, len(play.frame))
    assert found.unanswered == [Noted(6, "1.7", "UI_READ.GET_VBATT")]
    assert (whole.first, whole.last, whole.seconds) == (
        "2026-01-01T10:00:00.000000Z",
        "2026-01-01T10:00:00.040000Z",
        0.04,
    )
    (only,) = found.peers
    # The replies came at 14, 22 and 40 ms.
    assert (only.name, only.connection, only.messages, only.gap) == ("1.7", 1, whole.messages, 0.018)
    assert (whole.connection, whole.gap) == (None, 0.018)


def test_several_connections() -> None:
    one, other = seen(ask(), 1, peer="1.7"), seen(ask(), 2, peer="1.8")
    again = seen(ask(), 4, 1000, peer="1.7")
    again.connection = 2
    found = summary([one, other, seen(answer(), 3, 5, peer="1.8", request=other), again])
    assert [(peer.name, peer.connection, peer.messages.messages, peer.unanswered) for peer in found.peers] == [
        ("1.7", 1, 1, 1),
        ("1.8", 1, 2, 0),
        ("1.7", 2, 1, 1),
    ]
    assert (found.whole.name, found.whole.messages.messages, found.whole.unanswered) == ("all", 4, 2)
    # One reply makes no gap, nor do those of two connections.
    assert found.whole.gap is None


def test_system_and_daisy_commands_have_their_names() -> None:
    commands: list[Message | bytes] = [
        ev3proto.system_command("BEGIN_DOWNLOAD", size=1, path="x"),
        ev3proto.system_command(0xF1, address=0, image_size=1),
        bytes.fromhex("0600 0100 81 77 0000"),
        bytes.fromhex("0600 0100 8A A2 0001"),
    ]
    names = [(entry.kind, entry.name) for entry in summary(seen(command) for command in commands).whole.operations]
    assert names == [
        ("daisy", "INFO"),
        ("system", "0x77"),
        ("system", "BEGIN_DOWNLOAD"),
        ("system", "BEGIN_DOWNLOAD (bootloader)"),
    ]


def test_a_reply_whose_command_was_not_seen_says_which_one_it_was() -> None:
    (entry,) = summary([seen(ev3proto.system_reply("CREATE_DIR", status=6))]).whole.operations
    assert (entry.name, entry.commands, entry.replies, entry.errors, entry.latency) == ("CREATE_DIR", 0, 1, 1, None)


def test_faults_texts_and_what_was_skipped() -> None:
    found = summary(
        [
            seen(bytes.fromhex("0600010080000094"), 3),
            seen(b"\1\2", 4),
            Announcement(TextKind.BEACON, b"Serial-Number: x", None, (1,), START, NO_TIME),
            Announcement(TextKind.BEACON, b"Serial-Number: x", None, (2,), START, NO_TIME),
            Skipped(b"\0\0\0", 0, "no frame starts like this", 5, START, NO_TIME),
            Skipped(b"", 100, "a packet is not there", 6, START, NO_TIME),
        ]
    )
    assert found.whole.faults == 2
    assert [(noted.packet, noted.text[:40]) for noted in found.faults] == [
        (3, "offset 8: the frame ends before the argu"),
        (4, "offset 2: a frame has at least 5 bytes ("),
    ]
    assert found.whole.kinds["unknown"].messages == 1
    assert (found.texts["beacon"].messages, found.texts["beacon"].bytes) == (2, 32)
    assert (found.skipped_pieces, found.skipped_bytes, found.missing_bytes) == (2, 3, 100)
    assert found.skipped[1] == Noted(6, "1.7", "a packet is not there")


def test_transfers() -> None:
    upload = Transfer("BEGIN_UPLOAD", "../prjs/a.rbf", 1000, 0, 1000)
    refused = Transfer("BEGIN_DOWNLOAD", "/none/b.rbf", 3)
    begin = ev3proto.system_command("BEGIN_UPLOAD", max_bytes=1000, path=upload.path)
    reply = ev3proto.system_reply("BEGIN_UPLOAD", status=8, size=1000, handle=0, data=b"x" * 1000)
    no = ev3proto.system_reply("BEGIN_DOWNLOAD", status=6, error=True)
    one, two = summary(
        [
            seen(begin, 1, 0, transfer=upload),
            seen(reply, 2, 500, transfer=upload),
            seen(ev3proto.system_command("BEGIN_DOWNLOAD", size=3, path=refused.path), 3, 600, transfer=refused),
            seen(no, 4, 600, transfer=refused),
        ]
    ).transfers
    assert (one.path, one.command, one.direction, one.packet) == ("../prjs/a.rbf", "BEGIN_UPLOAD", "from brick", 1)
    assert (one.bytes, one.size, one.seconds, one.rate, one.complete, one.failed) == (
        1000,
        1000,
        0.5,
        2000,
        True,
        False,
    )
    assert (two.direction, two.bytes, two.rate, two.complete, two.failed) == ("to brick", 0, None, False, True)


def test_a_sender_who_never_gets_an_answer() -> None:
    statistics = Statistics()
    for number in range(MOST_PENDING + 1000):
        statistics.add(seen(ask(number % 65536), number, number))
    found = statistics.summary()
    assert found.whole.unanswered == MOST_PENDING + 1000
    assert [noted.packet for noted in found.unanswered] == list(range(MOST_LISTED))


def test_lists_have_an_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MOST_TRANSFERS", 3)
    statistics = Statistics()
    begin = ev3proto.system_command("BEGIN_DOWNLOAD", size=1, path="x")
    piece = ev3proto.system_command("CONTINUE_DOWNLOAD", handle=0, data=b"x")
    for number in range(MOST_PEERS + 30):
        transfer = Transfer("BEGIN_DOWNLOAD", str(number), 1)
        statistics.add(seen(begin, number, peer=str(number), transfer=transfer))
        statistics.add(seen(piece, number, peer=str(number), transfer=transfer))
        statistics.add(Skipped(b"\0", 0, "nothing", number, START, NO_TIME))
        statistics.add(seen(b"\0", number))
    found = statistics.summary()
    # Peer 1.7, of the faulty frames, is one of them.
    assert (len(found.peers), found.peers_left_out) == (MOST_PEERS, 2 * 31)
    assert (len(found.transfers), found.transfers_left_out) == (3, MOST_PEERS + 27)
    assert (len(found.skipped), found.skipped_pieces) == (MOST_LISTED, MOST_PEERS + 30)
    assert (len(found.faults), found.whole.faults) == (MOST_LISTED, MOST_PEERS + 30)


# Latencies


def test_percentiles_of_a_hundred_are_exact() -> None:
    latencies = Latencies()
    for number in random.Random(1).sample(range(1, 101), 100):
        latencies.add(number / 1000)
    found = latencies.percentiles()
    assert found is not None
    assert (found.count, found.min, found.max, found.exact) == (100, 0.001, 0.1, True)
    assert (found.median, found.p90, found.p99) == (0.05, 0.09, 0.099)


def test_one_latency_and_none() -> None:
    latencies = Latencies()
    assert latencies.percentiles() is None
    latencies.add(0.25)
    found = latencies.percentiles()
    assert found is not None
    assert found.min == found.median == found.p90 == found.p99 == found.max == 0.25


@given(st.lists(st.floats(1e-7, 1000), min_size=1, max_size=50), st.integers(0, 2**32))
def test_percentiles_of_many_are_as_right_as_they_say(kinds: list[float], seed: int) -> None:
    drawn = random.Random(seed).choices(kinds, k=EXACT + 500)
    latencies = Latencies()
    for seconds in drawn:
        latencies.add(seconds)
    drawn.sort()
    found = latencies.percentiles()
    assert found is not None
    assert (found.min, found.max, found.exact) == (drawn[0], drawn[-1], False)
    # The smallest that 750, 1350, 1485 of 1500 are not above.
    for value, exact in ((found.median, drawn[749]), (found.p90, drawn[1349]), (found.p99, drawn[1484])):
        assert value == pytest.approx(exact, rel=ACCURACY * 1.001)


def test_clocks_that_go_backwards_or_stop() -> None:
    latencies = Latencies()
    for seconds in [-5.0, 0.0, 1e9] * EXACT:
        latencies.add(seconds)
    found = latencies.percentiles()
    assert found is not None
    assert (found.min, found.max, found.count) == (-5.0, 1e9, 3 * EXACT)
    assert -5.0 <= found.median <= 1e-9


# Whole captures


@pytest.mark.parametrize("name", MADE)
def test_frames_and_everything_else_are_what_was_captured(name: str) -> None:
    statistics = Statistics()
    with read(CAPTURES / name) as capture:
        for event in capture.events():
            statistics.add(event)
        found = statistics.summary(capture.account)
    account = found.account
    assert account is not None
    assert account.packets > 0
    assert account.captured == sum(account.parts.values())
    assert account.frames == found.whole.messages.bytes == sum(kind.bytes for kind in found.whole.kinds.values())
    assert account.texts == sum(amount.bytes for amount in found.texts.values())
    assert account.skipped == found.skipped_bytes


def run(*words: str) -> subprocess.CompletedProcess[str]:
    return run_ev3proto_text("stats", *words)


def test_the_tables_of_a_capture() -> None:
    done = run(str(CAPTURES / "wifi.pcapng"))
    assert (done.returncode, done.stderr) == (0, "")
    assert "\x1b" not in done.stdout
    lines = done.stdout.splitlines()
    assert lines[0] == "Time: 2026-01-01T10:00:05.087700Z to 2026-01-01T10:00:05.308000Z, 0.220300 s"
    rows = [line.split() for line in lines]
    assert ["direct-command", "12", "162"] in rows
    assert ["all", "42", "5896"] in rows
    assert ["UI_READ.GET_VBATT", "4", "4", "3", "1", "1", "97"] in rows
    assert ["UI_READ.GET_VBATT", "3", "4.300", "4.300", "4.300", "4.300", "4.300"] in rows
    assert ["../prjs/log/values.rtf", "from", "brick", "2710", "2710", "0.013200", "205303", "35"] in rows
    assert ["/home/root/none/here.rtf", "to", "brick", "0", "3", "refused", "0.004300", "0", "50"] in rows
    assert "Commands without a reply: 1" in lines
    assert ["54", "UI_READ.GET_VBATT"] in rows
    assert "Captured bytes, in 58 packets" in lines
    assert ["all", "9226"] in rows
    assert not [line for line in lines if line.startswith(("Frames with a fault", "Skipped", "Replies whose"))]
    assert lines[2:6] == [
        "Messages",
        "kind            messages  bytes",
        "direct-command        12    162",
        "direct-reply           7    105",
    ]


def test_a_capture_as_json() -> None:
    done = run(str(CAPTURES / "wifi.pcapng"), "--json")
    found = json.loads(done.stdout)
    assert found["whole"]["messages"] == {"messages": 42, "bytes": 5896}
    assert found["account"]["captured"] == 9226
    assert [transfer["path"] for transfer in found["transfers"]][1:3] == [
        "../prjs/log/values.rtf",
        "../prjs/log/first.rbf",
    ]


def test_only_what_the_filter_lets_through() -> None:
    found = json.loads(run(str(CAPTURES / "wifi.pcapng"), "--json", "--filter", "op==UI_READ").stdout)
    assert [entry["name"] for entry in found["whole"]["operations"]] == [
        "UI_READ.GET_VBATT",
        "COM_GET.GET_BRICKNAME",
        # These are in one command with a UI_READ.
        "INPUT_DEVICE.GET_NAME",
        "INPUT_DEVICE_LIST",
        "UI_READ.GET_FW_VERS",
    ]
    assert found["account"]["captured"] == 9226


@pytest.mark.parametrize("chosen", ["kind == direct-command", "kind == direct-command && !unanswered"])
def test_a_command_whose_reply_the_filter_keeps_back_has_one(chosen: str) -> None:
    found = json.loads(run(str(CAPTURES / "usb-plugged.pcap"), "--json", "--filter", chosen).stdout)
    assert {kind: amount["messages"] for kind, amount in found["whole"]["kinds"].items()} == {"direct-command": 4}
    assert (found["whole"]["unanswered"], found["unanswered"]) == (0, [])


def test_other_files_than_captures() -> None:
    done = run(str(CAPTURES / "README.md"))
    assert (done.returncode, done.stdout) == (1, "")
    assert "Traceback" not in done.stderr
