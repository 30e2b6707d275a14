"""What is kept of long input has a limit, and evicted things are handed back."""

from __future__ import annotations

import pytest

from ev3proto.bounded import Bounded


def test_the_oldest_entry_goes() -> None:
    kept: Bounded[str, int] = Bounded(2)
    assert kept.add("a", 1) is None
    assert kept.add("b", 2) is None
    assert kept.add("a", 3) is None
    assert kept.add("c", 4) == 2
    assert dict(kept) == {"a": 3, "c": 4}


def test_an_entry_that_is_used_stays() -> None:
    kept: Bounded[str, int] = Bounded(2)
    assert kept.use("a", lambda: 1) == (1, None)
    assert kept.use("b", lambda: 2) == (2, None)
    assert kept.use("a", lambda: 9) == (1, None)
    assert kept.use("c", lambda: 3) == (3, 2)
    assert kept.pop_oldest() == 1


def test_nothing_to_take() -> None:
    with pytest.raises(KeyError):
        Bounded[str, int](2).pop_oldest()
