"""One human slip away from a right frame: a few cases of each kind of `python -m benchmarks.slips`."""

from __future__ import annotations

from collections import Counter
from functools import cache

import pytest

from benchmarks.slips import SLIPS, frames, table
from ev3proto import check

LESS = {
    "argument_left_out": 0.6,  # which of several numbers it was, the others may not tell
    "two_arguments_left_out": 0.1,  # the same, twice
    "argument_twice": 0.7,
    "neighbours_swapped": 0.3,  # many are right in another sense
    "raw_always": 0.0,  # small numbers look like others
    "byte_lost": 0.3,
    "byte_doubled": 0.7,
    "digit_wrong": 0.5,  # a digit of a value is another value
    "system_field_left_out": 0.0,
    "prefix_of_hex_forgotten": 0.4,  # whether 0A is itself, or 10 in decimal
}
"""The share of slips that lead back, where it is less than nearly all."""


@cache
def rows() -> dict[str, Counter[str]]:
    return dict(table(8))


@pytest.mark.parametrize("kind", SLIPS)
def test_a_slip_leads_back(kind: str) -> None:
    row = rows()[kind]
    assert row["cases"] > 0
    assert row["value"] >= LESS.get(kind, 0.85) * row["cases"]


def test_slips_lead_back_in_all() -> None:
    row = rows()["all"]
    assert row["value"] >= 0.85 * row["cases"]
    assert row["misleading"] <= 0.03 * row["cases"]
    assert row["fixed"] >= 0.5 * row["cases"]
    assert row["wrongly"] <= 0.05 * row["fixed"]


def test_nothing_is_said_of_right_frames() -> None:
    assert not [frame for frame in frames() if check(frame, alone=True).nearest]
