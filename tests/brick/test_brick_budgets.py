"""No handler of the virtual brick keeps other clients waiting for long, nor takes much memory.

A fresh process runs each operation and each system command, from the tables, with the greatest arguments that the
limits let through, on the fullest folder, while another client asks for the battery. Operations that wait for time, a
button or a motor block a brick, as in the firmware.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from support import greatest

MOST_SECONDS = 0.4
"""CPU seconds until the battery is answered; the slowest handler takes half of it."""

MOST_MEMORY = 200 << 10
"""KiB of the whole process."""


@pytest.fixture(scope="module")
def lines(tmp_path_factory: pytest.TempPathFactory) -> list[tuple[str, float, int]]:
    """For each frame the handler's name, the seconds and the KiB."""
    call = [sys.executable, greatest.__file__, str(tmp_path_factory.mktemp("budgets"))]
    places = {**os.environ, "PYTHONPATH": str(Path(greatest.__file__).parents[1])}
    ended = subprocess.run(call, env=places, capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stderr
    rows = (line.split("\t") for line in ended.stdout.splitlines())
    return [(name, float(seconds), int(memory)) for seconds, memory, name in rows]


def test_every_handler_is_run(lines: list[tuple[str, float, int]]) -> None:
    asked = [*greatest.OPERATIONS, *(entry.name for entry in greatest.SYSTEM_COMMANDS), *greatest.GREEDY]
    assert list(dict.fromkeys(name for name, _, _ in lines)) == list(dict.fromkeys(asked))


def test_the_battery_is_answered_meanwhile(lines: list[tuple[str, float, int]]) -> None:
    assert [(name, seconds) for name, seconds, _ in lines if seconds >= MOST_SECONDS] == []


def test_memory(lines: list[tuple[str, float, int]]) -> None:
    assert [(name, memory) for name, _, memory in lines if memory >= MOST_MEMORY] == []
