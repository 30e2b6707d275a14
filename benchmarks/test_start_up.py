"""How long the command line takes to start, as a ratio to the minimum.

    pytest benchmarks -k start_up

`ev3proto decode FRAME` is measured against a Python that imports click and construct and ends.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Sequence
from statistics import median

import pytest

ROUNDS = 15
FRAME = "0e002a0080000094010182b80182e803"
BARE = (sys.executable, "-c", "import click, construct")
OURS = (sys.executable, "-m", "ev3proto", "decode", FRAME)
MOST = 1.6
"""The limit of the ratio."""


def _seconds(command: Sequence[str]) -> float:
    """Seconds from start to end. Compiled modules are kept, as on a user's machine."""
    env = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    start = time.perf_counter()
    subprocess.run(command, check=True, env=env, stdout=subprocess.DEVNULL)
    return time.perf_counter() - start


def test_start_up_ratio(capsys: pytest.CaptureFixture[str]) -> None:
    """Prints the ratio that the README names: rounds alternate, the median round counts."""
    for command in (BARE, OURS):
        _seconds(command)  # the first one may write compiled modules
    rounds = [(_seconds(BARE), _seconds(OURS)) for _ in range(ROUNDS)]
    ratio = median(ours / bare for bare, ours in rounds)
    with capsys.disabled():
        print(f"\ndecode FRAME: {ratio:.2f} x as long as importing click and construct", end="")
    assert ratio <= MOST
