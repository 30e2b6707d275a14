"""The session without I/O: counters, pairing, and every consequence of what a brick sends."""

from __future__ import annotations

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import Bundle, RuleBasedStateMachine, consumes, invariant, rule
from support.effort import THOROUGH

from ev3proto.link.errors import LinkError
from ev3proto.link.session import Answered, Oddity, Request, Session, Stray
from ev3proto.schema.frame_buffer import OutOfStep
from ev3proto.tables.frame import MessageType

ASK, TELL = MessageType.DIRECT_COMMAND_REPLY, MessageType.DIRECT_COMMAND_NO_REPLY
NOP = bytes.fromhex("000001")


def reply(counter: int, memory: bytes = b"", type: int = 2) -> bytes:
    """A reply as specified."""
    return (3 + len(memory)).to_bytes(2, "little") + counter.to_bytes(2, "little") + bytes((type,)) + memory


def test_a_command_has_the_lessons_first_counter() -> None:
    assert Session().command(TELL, NOP).frame == bytes.fromhex("06002a0080000001")
    assert Session().outstanding == []


def test_a_reply_answers_its_command() -> None:
    session = Session()
    first, second = session.command(ASK, NOP), session.command(ASK, NOP)
    assert session.feed(bytes.fromhex("03002b0002")) == [Answered(second, bytes.fromhex("03002b0002"))]
    assert session.outstanding == [first]


def test_counters_wrap_around_those_that_are_outstanding() -> None:
    session = Session(65535)
    assert [session.command(ASK, NOP).counter for _ in range(3)] == [65535, 0, 1]
    for counter in range(2, 65535):
        assert session.command(TELL, NOP).counter == counter
    assert session.command(TELL, NOP).counter == 2
    session.feed(reply(0))
    assert session.command(TELL, NOP).counter == 3


@pytest.mark.parametrize(("first", "counter"), [(65535, 65535), (65536, 0), (65536 + 42, 42), (-1, 65535)])
def test_the_first_counter_wraps_around(first: int, counter: int) -> None:
    assert Session(first).command(ASK, NOP).counter == counter


@pytest.mark.parametrize(
    ("kind", "body", "answer"),
    [
        (ASK, NOP, bytes.fromhex("05002a00 03 9d 00")),
        (MessageType.SYSTEM_COMMAND_REPLY, b"\x9d", bytes.fromhex("03002a00 02")),
    ],
)
def test_a_reply_of_another_kind_is_foreign(kind: MessageType, body: bytes, answer: bytes) -> None:
    """A system reply answers no direct command, and the other way round, whatever the counter."""
    session = Session()
    request = session.command(kind, body)
    assert session.feed(answer) == [Stray(Oddity.FOREIGN, answer)]
    assert session.outstanding == [request]


def test_counters_wrap_around_those_that_were_abandoned() -> None:
    """Their replies may come after all."""
    session = Session()
    session.abandon(session.command(ASK, NOP))
    for _ in range(65535):
        session.command(TELL, NOP)
    request = session.command(ASK, NOP)
    assert request.counter == 43
    assert session.feed(reply(42) + reply(43)) == [Stray(Oddity.LATE, reply(42)), Answered(request, reply(43))]


def test_the_counter_of_a_late_answer_is_free_again() -> None:
    session = Session()
    first, second = session.command(ASK, NOP), session.command(ASK, NOP)
    session.abandon(first)
    session.abandon(second)
    session.feed(reply(second.counter))
    for _ in range(65534):
        session.command(ASK, NOP)
    assert session.command(ASK, NOP).counter == second.counter


def test_the_counter_of_an_answered_command_is_free_again_though_it_was_abandoned_before() -> None:
    session = Session()
    first, second = session.command(ASK, NOP), session.command(ASK, NOP)
    session.abandon(second)
    session.abandon(first)
    again = session.adopt(first.frame)
    assert session.feed(reply(first.counter)) == [Answered(again, reply(first.counter))]
    for _ in range(65534):
        session.command(ASK, NOP)
    assert session.command(ASK, NOP).counter == first.counter


def test_when_all_counters_wait_the_next_command_is_refused() -> None:
    session = Session()
    for _ in range(65536):
        session.command(ASK, NOP)
    with pytest.raises(LinkError, match="65536 commands wait for their reply"):
        session.command(ASK, NOP)


def test_a_late_answer_does_not_answer_another_command() -> None:
    session = Session()
    session.abandon(session.command(ASK, NOP))
    assert session.outstanding == []
    assert session.command(ASK, NOP).counter == 43
    assert session.feed(reply(42)) == [Stray(Oddity.LATE, reply(42))]
    assert session.feed(reply(42)) == [Stray(Oddity.FOREIGN, reply(42))]


@pytest.mark.parametrize(
    ("frame", "oddity"),
    [
        (reply(7), Oddity.FOREIGN),
        (bytes.fromhex("0a000100819e026100010031"), Oddity.UNASKED),  # a program's mailbox message
    ],
)
def test_frames_that_answer_no_command(frame: bytes, oddity: Oddity) -> None:
    session = Session()
    request = session.command(ASK, NOP)
    assert session.feed(frame + reply(42)) == [Stray(oddity, frame), Answered(request, reply(42))]


@pytest.mark.parametrize(
    "garbage",
    [bytes(7), bytes(8), b"HTTP/1.1 400 Bad Request\r\n\r\n", b"\xff" * 5, bytes.fromhex("0500070042")],
    ids=["7 zeros", "8 zeros", "another protocol", "ones", "an unknown type"],
)
def test_after_garbage_the_next_answer_is_found(garbage: bytes) -> None:
    session = Session()
    request = session.command(ASK, NOP)
    assert session.feed(garbage + reply(42, b"\x07")) == [
        OutOfStep("no frame can start here", garbage),
        Answered(request, reply(42, b"\x07")),
    ]


class Traffic(RuleBasedStateMachine):
    """Commands and their replies in any order, in any chunks, with any noise between them."""

    waiting = Bundle("waiting")
    over = Bundle("over")

    def __init__(self) -> None:
        super().__init__()
        self.session = Session(65530)
        self.expected: list[Answered | Stray] = []
        self.seen: list[Answered | Stray] = []
        self.wire = b""
        self.open: dict[int, Request] = {}
        self.given_up: set[int] = set()

    @rule(target=waiting)
    def ask(self) -> Request:
        request = self.session.command(ASK, NOP)
        assert request.counter not in self.open
        assert request.counter not in self.given_up
        self.open[request.counter] = request
        return request

    @rule(count=st.integers(1, 20000))
    def tell(self, count: int) -> None:
        for _ in range(count if count < 20 else 20):
            assert self.session.command(TELL, NOP).counter not in self.open
        # Most of a sender's life is far from the end of the counters: jump there.
        self.session._next = (self.session._next + count) % 65536

    @rule(target=over, request=consumes(waiting), memory=st.binary(max_size=1021), type=st.sampled_from((2, 4)))
    def answer(self, request: Request, memory: bytes, type: int) -> Request:
        frame = reply(request.counter, memory, type)
        self.wire += frame
        if self.open.get(request.counter) is request:
            del self.open[request.counter]
            self.expected.append(Answered(request, frame))
        else:
            self.given_up.discard(request.counter)
            self.expected.append(Stray(Oddity.LATE, frame))
        self.settle()
        return request

    @rule(request=over)
    def answer_again(self, request: Request) -> None:
        if request.counter not in self.open and request.counter not in self.given_up:
            self.wire += reply(request.counter)
            self.settle()
            assert isinstance(self.seen[-1], Stray)
            assert self.seen[-1].oddity is Oddity.FOREIGN
            self.expected.append(self.seen[-1])

    @rule(counter=st.integers(20000, 40000))
    def answer_without_a_command(self, counter: int) -> None:
        if counter not in self.open and counter not in self.given_up:
            self.wire += reply(counter)
            self.settle()
            assert isinstance(self.seen[-1], Stray)
            self.expected.append(self.seen[-1])

    @rule(request=waiting)
    def give_up(self, request: Request) -> None:
        self.session.abandon(request)
        if self.open.pop(request.counter, None) is not None:
            self.given_up.add(request.counter)

    @rule(zeros=st.integers(5, 30))
    def send_zeros(self, zeros: int) -> None:
        # Answers of LEGO's firmware to some system commands. Only an awaited answer ends the search.
        self.settle()
        assert all(isinstance(event, OutOfStep) for event in self.session.feed(bytes(zeros)))
        request = self.session.command(ASK, NOP)
        events = self.session.feed(reply(request.counter))
        assert events[-1] == Answered(request, reply(request.counter))

    @rule(size=st.integers(1, 9))
    def settle(self, size: int = 7) -> None:
        for start in range(0, len(self.wire), size):
            for event in self.session.feed(self.wire[start : start + size]):
                assert not isinstance(event, OutOfStep)
                self.seen.append(event)
        self.wire = b""

    @invariant()
    def what_was_seen_is_what_was_sent(self) -> None:
        assert self.seen == self.expected
        assert {each.counter for each in self.session.outstanding} == set(self.open)


Traffic.TestCase.settings = settings(max_examples=200 if THOROUGH else 25, stateful_step_count=30, deadline=None)
TestTraffic = Traffic.TestCase
