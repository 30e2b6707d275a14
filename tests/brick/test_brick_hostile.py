"""Whatever is sent to the virtual brick: it answers in the right form or not at all, and goes on."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from support.bricks import FAIL, OK, command, op, run, taken_apart
from support.effort import effort

from ev3proto import testing
from ev3proto.brick import Brick
from ev3proto.messages import LV

NOP = command(op("NOP"))
NOP_REPLY = bytes.fromhex("03 00 01 00 02")


@pytest.fixture(scope="module")
def root(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("brick")


@pytest.fixture(autouse=True)
def _short_patience(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ev3proto.brick.brick.MOST_OPERATIONS", 2_000)
    monkeypatch.setattr("ev3proto.brick.brick.MOST_SECONDS", 0.05)


def is_alive(brick: Brick, frame: bytes) -> None:
    """Sends a frame, lets its time pass, and looks whether the brick still answers."""
    replies = [*brick.receive(frame), *brick.advance(0.1)]
    assert len(replies) <= 1
    for reply in replies:
        assert int.from_bytes(reply[:2], "little") == len(reply) - 2
        assert reply[2:4] == frame[2:4]
    assert brick.equipment.is_dead or brick.receive(NOP) == [NOP_REPLY]


@settings(max_examples=effort(80, 3000), suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(message=testing.direct_commands())
def test_direct_commands_of_any_operations(root: Path, message: object) -> None:
    is_alive(Brick(root), message.build())  # type: ignore[attr-defined]


@settings(max_examples=effort(80, 3000), suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(
    head=st.tuples(st.integers(0, 0xFFFF), st.sampled_from((0, 1, 0x80, 0x81))),
    body=st.binary(max_size=80),
)
def test_any_bytes_in_a_frame(root: Path, head: tuple[int, int], body: bytes) -> None:
    contents = head[0].to_bytes(2, "little") + bytes((head[1],)) + body
    is_alive(Brick(root), len(contents).to_bytes(2, "little") + contents)


@settings(max_examples=effort(80, 3000), deadline=None)
@given(frame=st.binary(max_size=40))
def test_any_bytes_in_place_of_a_frame(frame: bytes) -> None:
    brick = Brick()
    brick.receive(frame)
    brick.advance(0.1)
    assert brick.equipment.is_dead or brick.receive(NOP) == [NOP_REPLY]


def test_a_call_lasts_no_longer_than_it_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ev3proto.brick.brick.MOST_OPERATIONS", 20_000)
    monkeypatch.setattr("ev3proto.brick.brick.MOST_SECONDS", 600)
    brick = Brick(stretch=0.0)
    assert brick.receive(command(op("JR", -2))) == []
    assert brick.is_busy
    replies: list[bytes] = []
    for _ in range(1000):
        replies += brick.advance(0.001)
    assert [taken_apart(reply)[0] for reply in replies] == [FAIL]


def test_arrays_of_all_programs_have_one_room() -> None:
    brick = Brick()
    create = op("ARRAY.CREATE32", 700_000, LV(0))
    assert run(brick, create, create, locals=2)[0] == OK
    assert run(brick, create, create, create, locals=2)[0] == FAIL
    assert run(brick, create, op("ARRAY.RESIZE", LV(0), 0x7FFFFFFF), locals=2)[0] == FAIL


def test_frames_that_wait_have_one_room(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ev3proto.brick.brick.MOST_WAITING", 100)
    brick = Brick()
    assert brick.receive(command(op("OBJECT_WAIT", 1))) == []
    for _ in range(50):
        assert brick.receive(NOP) == []
    [ended, *served] = brick.advance(0.1)
    assert taken_apart(ended)[0] == FAIL
    assert len(served) == 100 // len(NOP)
