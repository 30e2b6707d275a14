"""The targets of fuzz/ with all seeds, all inputs that once made one fail, and some similar inputs."""

from __future__ import annotations

from importlib import import_module
from random import Random

import pytest
from support.effort import effort

from fuzz.corpus import HERE, TARGETS, inputs, mutated


def test_every_target_has_seeds() -> None:
    named = {path.stem for path in HERE.glob("[a-z]*.py")} - {"corpus"}
    assert named == set(TARGETS)
    assert all(len(inputs(target)) >= 3 for target in TARGETS)


@pytest.mark.parametrize("target", TARGETS)
def test_seeds_and_regressions(target: str) -> None:
    one_input = import_module(f"fuzz.{target}").one_input
    for data in inputs(target):
        one_input(data)


@pytest.mark.parametrize("target", TARGETS)
def test_inputs_near_the_seeds(target: str) -> None:
    one_input = import_module(f"fuzz.{target}").one_input
    random, seeds = Random(7), inputs(target)
    for _ in range(effort(20, 5000)):
        one_input(mutated(random.choice(seeds), random, seeds))
