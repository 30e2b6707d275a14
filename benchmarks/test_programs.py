"""How long an image of 100 kB takes to be parsed, built, written as a source, and assembled again."""

from __future__ import annotations

from pytest_benchmark.fixture import BenchmarkFixture

from ev3proto import program

_STEPS = """again{number}:
  UI_WRITE(LED, LED_RED)
  TIMER_WAIT(500, timer)
  ADD8(count, 1, count)
  JR_LT8(count, 2, again{number})
  CALL(Say, 'done', level)
  STRINGS(DUPLICATE, 'x', text)
  MOVEF_F(1.5F, level)
"""
_THREADS, _REPEATS = 11, 220


def _source() -> str:
    body = "".join(_STEPS.format(number=number) for number in range(_REPEATS))
    threads = "".join(
        f"vmthread T{number}\n{{\n  DATA32 timer\n  DATAS text 6\n{body}}}\n" for number in range(_THREADS)
    )
    return f"DATA8 count\nDATAF level\n{threads}subcall Say\n{{\n  IN_S what 8\n  OUT_F answer\n}}\n"


SOURCE = _source()
IMAGE = program.assemble(SOURCE).image
LEAST = 99_000


def test_assemble(benchmark: BenchmarkFixture) -> None:
    benchmark.group = "a program of 100 kB"
    assert len(IMAGE) > LEAST
    assert benchmark(lambda: program.assemble(SOURCE).image) == IMAGE


def test_assemble_in_legos_dialect(benchmark: BenchmarkFixture) -> None:
    benchmark.group = "a program of 100 kB"
    assert benchmark(lambda: program.assemble(SOURCE, dialect="lego").image) == IMAGE


def test_parse_with_every_argument(benchmark: BenchmarkFixture) -> None:
    benchmark.group = "a program of 100 kB"
    found = benchmark(
        lambda: [operation.arguments for part in program.parse(IMAGE).objects for operation in part.operations]
    )
    assert found


def test_build(benchmark: BenchmarkFixture) -> None:
    benchmark.group = "a program of 100 kB"
    parsed = program.parse(IMAGE)
    assert benchmark(parsed.build) == IMAGE


def test_write_a_source(benchmark: BenchmarkFixture) -> None:
    benchmark.group = "a program of 100 kB"
    parsed = program.parse(IMAGE)
    assert benchmark(lambda: program.source_of(parsed))
