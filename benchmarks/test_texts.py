"""How many frames per second are read from text, without printing: `pytest benchmarks/test_texts.py -s`."""

from __future__ import annotations

import time

import pytest

from ev3proto.text.paste import read_text

TONE = "0f 00 00 00 80 00 00 94 01 81 02 82 e8 03 82 e8 03"
COUNT = 50_000
LINES = {
    "hex": f"{TONE}\n",
    "the lesson's notation": "0x|0F:00|00:00|80|00:00|94:01:81:02:82:E8:03:82:E8:03|\n",
    "log lines": f"2024-01-31 12:30:{{:02}}.123 DEBUG robot: sent {TONE}\n",
    "lines of logcat": f"01-31 12:30:{{:02}}.123  1234  1250 D EV3: send {TONE}\n",
}
LEAST = {"hex": 5000, "the lesson's notation": 5000, "log lines": 5000, "lines of logcat": 4000}
"""Frames per second below which something is wrong."""


@pytest.mark.parametrize("name", LINES)
def test_lines_of_text(name: str) -> None:
    lines = [LINES[name].format(number % 60) for number in range(COUNT)]
    begin = time.process_time()
    found = sum(1 for _ in read_text(lines))
    rate = found / (time.process_time() - begin)
    print(f"\n{name}: {rate:,.0f} frames a second")
    assert found == COUNT
    assert rate > LEAST[name]
