"""Commands with their replies in captures: which are yielded, and when."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest
from support.cli import run_ev3proto_text
from support.messages import voltage, volts
from support.packets import RAW_IP, Capture, Connection
from support.reading import opened

from ev3proto.capture import Event, Record, read
from ev3proto.capture.dialogues import dialogues

SENDERS = Path(__file__).parents[2] / "captures" / "senders.pcapng"

TONE = bytes.fromhex("0e002a0080000094010182b80182e803")
MILLISECOND = 1_000_000


def captured(*frames: tuple[bool, bytes]) -> list[Event]:
    """The events of a capture of these frames, which are a millisecond apart; True: from the host."""
    capture = Capture(RAW_IP)
    connection = Connection(capture)
    for from_host, frame in frames:
        capture.add(connection.segment(from_host, frame))
    return opened(capture.data())[0]


def numbers(events: list[Event], patience_ns: int | None = None) -> list[tuple[int | None, int | None]]:
    """The packets of command and reply of each dialogue."""
    told = dialogues(events, patience_ns)
    return [tuple(None if record is None else record.number for record in spoken) for spoken in told]  # type: ignore[misc]


def test_each_command_with_its_reply_once_that_came() -> None:
    events = captured((True, voltage(1)), (True, voltage(2)), (True, TONE), (False, volts(2)), (False, volts(1)))
    assert numbers(events) == [(3, None), (2, 4), (1, 5)]


def test_commands_that_wait_in_vain_come_last() -> None:
    events = captured((True, voltage(1)), (True, TONE), (True, TONE), (True, TONE))
    assert numbers(events) == [(2, None), (3, None), (4, None), (1, None)]


def test_patience_that_ends() -> None:
    events = captured((True, voltage(1)), (True, TONE), (True, TONE), (False, volts(1)))
    assert numbers(events, patience_ns=2 * MILLISECOND) == [(2, None), (1, None), (3, None), (1, 4)]


def test_a_reply_by_itself() -> None:
    """One is chance, two in a row are not."""
    assert numbers(captured((False, volts(7)))) == []
    assert numbers(captured((False, volts(7)), (False, volts(8)))) == [(None, 2)]


def test_programs_that_do_not_wait_or_never_change_their_counter() -> None:
    """Each of them is a connection of its own; the motor's angle is the number of the command that asked for it."""
    found: dict[str, list[tuple[int | None, bool]]] = {}
    capture = read(SENDERS)
    for record in (event for event in capture.events() if isinstance(event, Record)):
        if record.request is not None:
            latency = None if record.latency is None else round(record.latency * 1000)
            found.setdefault(record.target, []).append((latency, record.note is not None))
    assert [Counter(answers) for answers in found.values()] == [
        # One that waits.
        {(10, False): 20},
        # Two that poll faster than the brick answers.
        {(150, True): 19, (150, False): 1},
        {(300, True): 19, (300, False): 1},
        # Two at once.
        {(10, True): 10, (12, False): 10},
        # Two lost replies of one that waits.
        {(10, False): 16, (10, True): 2},
        # One lost reply of two at once: the other reply is paired with the wrong command, and has a note.
        {(10, True): 9, (12, False): 9, (12, True): 1},
    ]


# Replies whose counters are not those of commands

ASKED = "send 08 00 {} 00 00 04 00 81 01 60\n"
ANSWERED = "recv 07 00 {} 02 A4 70 FD 40\n"


@pytest.mark.parametrize(
    ("counters", "sentence"),
    [
        ([(1, "02 00"), (2, "03 00")], "one higher than the commands'"),
        ([(4, "03 00"), (9, "08 00")], "one lower than the commands'"),
        ([(1, "00 00"), (2, "00 00")], "0, whatever the commands' are"),
        ([(1, "00 01"), (2, "00 02")], "the commands' with their two bytes swapped"),
        ([(1, "07 00"), (2, "03 00")], None),
    ],
)
def test_a_dialogue_that_does_not_pair_says_why(counters: list[tuple[int, str]], sentence: str | None) -> None:
    text = "".join(ASKED.format(f"{asked:02X}") + ANSWERED.format(given) for asked, given in counters)
    *pairs, last = run_ev3proto_text("decode", "--dialogues", "-", stdin=text).stdout.splitlines()
    told = [int.from_bytes(bytes.fromhex(given), "little") for _, given in counters] + [asked for asked, _ in counters]
    found = [line.rpartition("  (counter ")[2] for line in (pairs if sentence else [*pairs, last])]
    assert found == [f"{counter})" for counter in told]
    assert last == f"the replies' counters are {sentence}" or sentence is None


def test_counters_of_replies_that_fit_are_not_blamed() -> None:
    """A reply whose command came before the log began, among others that pair."""
    text = "".join(ASKED.format(f"{each:02X}") + ANSWERED.format(f"{each:02X} 00") for each in range(3))
    shown = run_ev3proto_text("decode", "--dialogues", "-", stdin=ASKED.format("07") + ANSWERED.format("08 00") + text)
    assert "counters" not in shown.stdout
