"""The CPU time of each test and of the processes that it waits for: `pytest --costs FILE`.

Wall time says nothing on a busy machine. What a fixture takes counts for the first test that uses it, and for the last
one when it ends. The file has a line for each test, the most costly first: seconds, a tab, the test.
"""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Generator
from pathlib import Path

import pytest

_KEY = "cpu seconds"
_MOST_SHOWN = 10


def pytest_addoption(parser: pytest.Parser) -> None:
    """Adds the option."""
    parser.addoption("--costs", type=Path, metavar="FILE", help="write the CPU seconds of each test to FILE")


def pytest_configure(config: pytest.Config) -> None:
    """Measures if the option was given, in this process or in its workers."""
    path = config.getoption("--costs")
    if path is None:
        return
    config.pluginmanager.register(_Measuring())
    if not hasattr(config, "workerinput"):
        config.pluginmanager.register(_Listing(path))


class _Measuring:
    """Adds to each report of a test what was spent since the report before."""

    def __init__(self) -> None:
        self._before = 0.0

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtest_logstart(self) -> None:
        self._before = _spent()

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_makereport(self) -> Generator[None, pytest.TestReport, pytest.TestReport]:
        report = yield
        now = _spent()
        report.user_properties.append((_KEY, now - self._before))
        self._before = now
        return report


class _Listing:
    """Adds up the reports, and lists them at the end."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._costs: defaultdict[str, float] = defaultdict(float)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        spent = [value for name, value in report.user_properties if name == _KEY]
        self._costs[report.nodeid] += sum(value for value in spent if isinstance(value, float))

    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        lines = [f"{seconds:.2f}\t{test}" for test, seconds in sorted(self._costs.items(), key=lambda item: -item[1])]
        self._path.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
        terminalreporter.section(f"{sum(self._costs.values()):.0f} seconds of CPU time")
        for line in lines[:_MOST_SHOWN]:
            terminalreporter.write_line(line)


def _spent() -> float:
    """Returns the seconds of this process and of the children that it has waited for."""
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system
