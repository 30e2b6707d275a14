"""Values of the right type that a function cannot use: each raises an error that says what is legal."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest

import ev3proto
from ev3proto import ops
from ev3proto.brick import Brick
from ev3proto.errors import BuildError
from ev3proto.schema.discovery import Unlock


@pytest.mark.parametrize(
    ("call", "error", "sentence"),
    [
        (lambda: Brick(stretch=-1), ValueError, "stretch must be seconds, 0 or more, or None, not -1"),
        (lambda: Unlock("001653", endings=1 << 70).build(), BuildError, "has 0 to 2 line ends after its last line"),
    ],
)
def test_what_cannot_be_taken_is_refused(
    call: Callable[[], Iterator[Any]], error: type[Exception], sentence: str
) -> None:
    with pytest.raises(error) as caught:
        next(call(), None)
    assert sentence in str(caught.value)


@pytest.mark.parametrize("seconds", [float("inf"), float("nan"), -1, 1e40, 10**400])
def test_seconds_that_cannot_pass(seconds: float) -> None:
    brick = Brick()
    for advance in (brick.advance, brick.advance_all):
        with pytest.raises(ValueError, match=r"^seconds are a number from 0 to \d+, not "):
            advance(seconds)
    assert brick.microseconds == 0


@pytest.mark.parametrize("timeout", [-1, float("nan")])
def test_an_invalid_timeout_is_refused_before_anything_is_sent(timeout: float) -> None:
    with pytest.raises(ValueError, match=r"^timeout must be seconds, 0 or more, or None, not "):
        ev3proto.EV3(target="virtual", timeout=timeout)
    with ev3proto.EV3(target="virtual") as ev3:
        for send in (lambda: ev3.send_direct_cmd(ops.nop(), timeout=timeout), lambda: ev3.list_dir("/")):
            ev3.timeout = timeout
            with pytest.raises(ValueError, match=r"^timeout must be seconds, 0 or more, or None, not "):
                send()
        ev3.timeout = 30
        assert ev3.send_direct_cmd(ops.info.get_volume(), sync_mode=ev3proto.ASYNC) == b"\x2a\x00"
