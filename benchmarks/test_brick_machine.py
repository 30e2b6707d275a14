"""How fast the virtual brick answers: direct commands that read a value, a loop, a file of a megabyte."""

from __future__ import annotations

from pathlib import Path

import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from ev3proto import system
from ev3proto.brick import Brick
from ev3proto.text.assembly import assemble


def frame(source: str) -> bytes:
    (message,) = assemble(source, reply=True)
    return message.build()


@pytest.mark.parametrize(
    "source",
    ["DATA8 percent\nUI_READ(GET_LBATT, percent)", "DATAF value\nINPUT_DEVICE(READY_SI, 0, 0, 0, 0, 1, value)"],
    ids=["battery", "sensor"],
)
def test_a_command_that_reads_one_value(benchmark: BenchmarkFixture, source: str) -> None:
    brick = Brick()
    brick.plug(1, 16, {0: (1900,)})
    brick.advance(1)
    assert len(benchmark(brick.receive, frame(source))) == 1


def test_a_loop_of_ten_thousand_rounds(benchmark: BenchmarkFixture) -> None:
    brick = Brick()
    loop = "local DATA32 i\nMOVE32_32(0, i)\nagain:\nADD32(i, 1, i)\nJR_LT32(i, 10000, again)"
    assert benchmark(brick.receive, frame(loop))[0][4] == 2


def test_a_file_of_a_megabyte(benchmark: BenchmarkFixture, tmp_path: Path) -> None:
    brick = Brick(tmp_path)
    frames = [message.build() for message in system.download("../prjs/large.rtf", bytes(1 << 20))]

    def send() -> None:
        for message in frames:
            brick.receive(message)

    benchmark(send)
    assert (tmp_path / "prjs" / "large.rtf").stat().st_size == 1 << 20
