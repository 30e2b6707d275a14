"""The pairing of replies with commands, for each kind of sender."""

from __future__ import annotations

import heapq
from collections.abc import Iterator
from dataclasses import dataclass

import pytest

from ev3proto.semantics.pairing import Pairing

pytestmark = pytest.mark.portable

MS = 1_000_000

SIZE = 4


@dataclass(frozen=True)
class Sender:
    """A program that sends a command now and then.

    period   milliseconds from one command to the next
    lag      milliseconds until the reply
    at_once  commands that are sent together
    counters  how many counters it uses in turn
    lost     the commands whose replies get lost, by number
    """

    period: int
    lag: int
    at_once: int = 1
    counters: int = 1
    lost: frozenset[int] = frozenset()


def messages(sender: Sender, count: int) -> Iterator[tuple[int, int, bool]]:
    """Yields time in milliseconds, number of the command, and whether it is the reply, in the order of time."""
    events: list[tuple[int, int, int]] = []
    for number in range(count):
        sent = number // sender.at_once * sender.period
        heapq.heappush(events, (sent, 0, number))
        if number not in sender.lost:
            # A brick answers in order, one after the other.
            heapq.heappush(events, (sent + sender.lag + 5 * (number % sender.at_once), 1, number))
    while events:
        time, is_reply, number = heapq.heappop(events)
        yield time, number, bool(is_reply)


def paired(sender: Sender, count: int = 60) -> tuple[int, int]:
    """Returns the number of replies that are paired with the wrong command, and of those with a note."""
    pairing: Pairing[int] = Pairing()
    wrong = noted = 0
    for time, number, is_reply in messages(sender, count):
        key = number % sender.counters
        if not is_reply:
            pairing.remember(key, SIZE, number, time * MS)
            continue
        answer = pairing.answered(key, SIZE, time * MS)
        wrong += answer is None or answer.command != number
        noted += answer is not None and answer.note is not None
    return wrong, noted


@pytest.mark.parametrize(
    ("sender", "wrong", "noted"),
    [
        # One command at a time, with counters of their own or without.
        (Sender(period=100, lag=10, counters=65536), 0, 0),
        (Sender(period=100, lag=10), 0, 0),
        # Polled by a timer, faster than the brick answers: as Scratch does.
        (Sender(period=100, lag=150), 0, 59),
        (Sender(period=50, lag=300), 0, 59),
        # Two at once.
        (Sender(period=100, lag=10, at_once=2), 0, 30),
        # A reply gets lost: of a sender that waits, and of one that sends two at once.
        (Sender(period=100, lag=10, lost=frozenset({20})), 0, 1),
        (Sender(period=100, lag=10, at_once=2, lost=frozenset({20})), 1, 30),
        # Commands that are sent again are answered the second time.
        (Sender(period=1000, lag=10, lost=frozenset({7, 30, 31})), 0, 2),
    ],
)
def test_senders(sender: Sender, wrong: int, noted: int) -> None:
    assert paired(sender) == (wrong, noted)


def test_a_slow_answer_is_one() -> None:
    """A command that waits for a button takes as long as it takes."""
    pairing: Pairing[str] = Pairing()
    for time, command in ((0, "battery"), (100, "name"), (200, "button")):
        pairing.remember(0, SIZE, command, time * MS)
        found = pairing.answered(0, SIZE, (time + (9000 if command == "button" else 5)) * MS)
        assert found is not None
        assert (found.command, found.is_sure) == (command, True)


def test_when_nothing_is_known_of_a_brick_ten_seconds_are_not_too_long() -> None:
    for waited, expected in ((10_000, "first"), (10_001, "second")):
        pairing: Pairing[str] = Pairing()
        pairing.remember(0, SIZE, "first", 0)
        pairing.remember(0, SIZE, "second", 9_999 * MS)
        found = pairing.answered(0, SIZE, waited * MS)
        assert found is not None
        assert found.command == expected


@pytest.mark.parametrize(
    ("lag", "waited", "expected"),
    [
        (0, 50, "first"),
        (0, 51, "second"),
        (16, 50, "first"),
        (17, 51, "first"),
        (100, 300, "first"),
        (100, 301, "second"),
    ],
)
def test_a_brick_takes_three_times_its_longest_time_and_at_least_50_milliseconds(
    lag: int, waited: int, expected: str
) -> None:
    pairing: Pairing[str] = Pairing()
    pairing.remember(0, SIZE, "before", 0)
    pairing.answered(0, SIZE, lag * MS)
    pairing.remember(0, SIZE, "first", 1000 * MS)
    pairing.remember(0, SIZE, "second", (1000 + waited - 1) * MS)
    found = pairing.answered(0, SIZE, (1000 + waited) * MS)
    assert found is not None
    assert found.command == expected


def test_a_stalled_brick_answers_in_order() -> None:
    """If all commands have waited for too long, the brick was slow, and nothing was lost."""
    pairing: Pairing[int] = Pairing()
    pairing.remember(0, SIZE, 0, 0)
    pairing.answered(0, SIZE, 10 * MS)
    for number in range(1, 6):
        pairing.remember(0, SIZE, number, number * 100 * MS)
    found = [pairing.answered(0, SIZE, (600 + number) * MS) for number in range(5)]
    assert [answer and answer.command for answer in found] == [1, 2, 3, 4, 5]


def test_the_size_of_a_reply_tells_which_command_it_answers() -> None:
    pairing: Pairing[str] = Pairing()
    pairing.remember(0, 4, "battery", 0)
    pairing.remember(0, 1, "button", 0)
    found = pairing.answered(0, 1, 10 * MS)
    assert found is not None
    assert (found.command, found.note) == ("button", None)
    assert pairing.unanswered == []


def test_what_is_given_up() -> None:
    lost: list[int] = []
    pairing: Pairing[int] = Pairing(most=300, give_up=lost.append)
    for number in range(260):
        pairing.remember("one counter", SIZE, number)
    assert lost == [0, 1, 2, 3]
    for number in range(260, 306):
        pairing.remember(number, SIZE, number)
    assert lost == [0, 1, 2, 3, 4, 5]
